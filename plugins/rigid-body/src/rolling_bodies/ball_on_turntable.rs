//! A ball that rolls on a turntable: circles, and on a tilted one a drift.

use std::f64::consts::{PI, TAU};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{Real, Vector};
use dalembert_numerics::{
    ode::{self, OdeFunction},
    quadrature,
};
use nalgebra::Vector3;

use crate::sources::{FOWLER, ROUTH};

/// A ball that rolls without slip on a plane that turns steadily about an axis normal to it.
///
/// The axes are at rest: the origin on the axis of the turntable, x down the slope where the turntable is tilted, z along
/// the axis, about which the turntable turns by the right-hand rule.
#[derive(Clone, Debug, Inputs)]
pub struct BallOnTurntable {
    /// Ball.
    pub ball: Ball,
    /// Angular velocity of the turntable.
    /// Negative where it turns the other way.
    #[input("Ω", "rad/s")]
    pub turntable: f64,
    /// Initial position of the ball.
    #[input("r₀", "m", planar)]
    pub start: Vector3<f64>,
    /// Initial velocity of its centre.
    pub release: Release,
    /// Tilt of the turntable.
    #[input("β", "deg", min = 0, below = 90, default = "0 deg")]
    pub tilt: f64,
    /// Time at which the motion is required.
    #[input("t", "s", nonnegative)]
    pub time: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// A ball, by what its inertia is in parts of `m ρ²`.
#[derive(Clone, Debug, Inputs)]
pub enum Ball {
    /// Solid
    Solid,
    /// Thin shell
    Shell,
    /// Given
    Given {
        /// Moment of inertia divided by m ρ².
        /// With the mass m and the radius ρ of the ball: 2/5 for a solid one.
        #[input("κ", "1", positive, max = 1)]
        ratio: f64,
    },
}

/// Motion of the ball at the start.
#[derive(Clone, Debug, Inputs)]
pub enum Release {
    /// Velocity given
    Velocity {
        /// Velocity.
        #[input("v₀", "m/s", planar)]
        velocity: Vector3<f64>,
    },
    /// At rest on the turntable
    /// It was held on the turntable and turned with it.
    Carried,
}

register!(BallOnTurntable);

impl Analysis for BallOnTurntable {
    const ABOUT: About = About {
        id: "rigid-body/ball-on-turntable",
        title: "Ball on a turntable",
        topic: "Rolling bodies",
        summary: "Path of a ball that rolls on a level or tilted turntable: angular velocity, centre and radius of its circle, drift across the slope, position at a time, friction.",
        main: &["rate", "period", "position"],
        keywords: "ball sphere rolling turntable rotating table circle 2/7 drift inclined rolling without slip bola esfera mesa giratória \
                   prato rolamento círculo deriva inclinada",
        sources: &[&FOWLER, &ROUTH],
        cases: include_str!("../../cases/ball_on_turntable.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &BallOnTurntableGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.turntable == 0.0 {
            return Err(Refusal::because(
                "the turntable is at rest, and the ball rolls in a straight line or a parabola: write an angular velocity other than zero",
            ));
        }
        let zero = W::Num::from(0.0);
        let up = W::Vec::from_components(zero, zero, 1.0.into());
        let ratio = match given.ball {
            BallGiven::Solid {} => {
                let ratio =
                    sheet.numerical("κ", "1", 2.0 / 5.0, "Moment of inertia of a solid ball: 2/5 m ρ²");
                sheet.verify(|| {
                    let shells = quadrature::integral(|r: f64| 2.0 * r.powi(4), [0.0, 1.0], 1);
                    sheet.check("moment of inertia of the ball, shell by shell", ratio, shells.into());
                });
                ratio
            }
            BallGiven::Shell {} => {
                let ratio =
                    sheet.numerical("κ", "1", 2.0 / 3.0, "Moment of inertia of a thin shell: 2/3 m ρ²");
                sheet.verify(|| {
                    let rings = quadrature::integral(|z: f64| (1.0 - z.powi(2)) / 2.0, [-1.0, 1.0], 1);
                    sheet.check("moment of inertia of the shell, ring by ring", ratio, rings.into());
                });
                ratio
            }
            BallGiven::Given { ratio } => ratio,
        };
        sheet.common_error("ω_c", "the angular velocity of the turntable taken as that of the path", || {
            given.turntable
        });
        sheet.common_error("ω_c", "the factor of rolling down an incline, 1/(1 + κ), used", || {
            given.turntable / (ratio + 1.0)
        });
        let rate = sheet.step(
            "ω_c",
            "rad/s",
            ratio / (ratio + 1.0) * given.turntable,
            (
                "Angular velocity of the path: by friction and rolling, v̇ = κ/(1 + κ) Ω × v",
                FOWLER.at("§30.5"),
            ),
        );
        let period = sheet.step("T", "s", W::Num::from(TAU) / rate.abs(), "Time of one circle");
        let velocity = match given.release {
            ReleaseGiven::Velocity { velocity } => velocity,
            ReleaseGiven::Carried {} => sheet.step_vector(
                "v₀",
                "m/s",
                up.cross(given.start) * given.turntable,
                "Velocity of the turntable under the ball",
            ),
        };
        let drift = (self.tilt > 0.0).then(|| {
            let downhill = sheet.step(
                "a_s",
                "m/s^2",
                given.gravity * given.tilt.sin() / (ratio + 1.0),
                "Acceleration of a ball that rolls down the same slope at rest",
            );
            let speed = sheet.step(
                "v_d",
                "m/s",
                downhill / rate,
                (
                    "Drift along y, across the slope, at which κ/(1 + κ) Ω × v takes the acceleration away",
                    FOWLER.at("§30.6"),
                ),
            );
            (downhill, speed)
        });
        let relative = match drift {
            None => velocity,
            Some((_, speed)) => sheet.step_vector(
                "w",
                "m/s",
                velocity - W::Vec::from_components(zero, speed, zero),
                "Velocity relative to the drift",
            ),
        };
        let arm = sheet.step_vector(
            "q",
            "m",
            up.cross(relative) / rate,
            "From the ball to the centre of its circle",
        );
        let centre = sheet.step_vector("r_c", "m", given.start + arm, "Centre of the circle at the start");
        let radius = sheet.step("R", "m", relative.magnitude() / rate.abs(), "Radius of the circle");
        let angle = sheet.step("φ", "rad", rate * given.time, "Angle along the circle in that time");
        let (sin, cos) = (angle.sin(), angle.cos());
        let mut place = centre - (arm * cos + up.cross(arm) * sin);
        let mut now = relative * cos + up.cross(relative) * sin;
        if let Some((_, speed)) = drift {
            let along = W::Vec::from_components(zero, speed, zero);
            place = place + along * given.time;
            now = now + along;
        }
        let place = sheet.step_vector(
            "r",
            "m",
            place,
            "Position at that time: the arm has turned, and the centre drifted",
        );
        let now = sheet.step_vector("v", "m/s", now, "Velocity at that time");
        let distance = sheet.step("d", "m", place.magnitude(), "Distance from the axis at that time");
        sheet.answer("rate", "Angular velocity of the path", rate);
        sheet.answer("period", "Time of one circle", period);
        sheet.answer_vector("centre", "Centre of the circle at the start", centre);
        sheet.answer("radius", "Radius of the circle", radius);
        if let Some((_, speed)) = drift {
            sheet.answer("drift", "Drift velocity, along y", speed);
        }
        sheet.answer_vector("position", "Position at that time", place);
        sheet.answer_vector("velocity", "Velocity at that time", now);
        sheet.answer("distance", "Distance from the axis at that time", distance);
        self.friction(given, [rate, radius, ratio], sheet);
        let path =
            Path { ratio: ratio.value(), turntable: self.turntable, slope: self.gravity * self.tilt.sin() };
        let start = [self.start, velocity.value()];
        sheet.verify(|| {
            self.checks(
                &path,
                start,
                [period, radius, distance],
                [centre, place, now],
                drift.map(|(_, v)| v),
                sheet,
            );
        });
        let (centre, radius) = (centre.value(), radius.value());
        let shown = distance.value();
        sheet.show(|| Exhibit::Plot(self.distance(&path, start, shown)));
        sheet.show(|| Exhibit::Plot(self.path(&path, start, period.value())));
        sheet.show(|| Exhibit::Drawing(self.sketch(start, centre, radius)));
        Ok(())
    }
}

/// Numbers that the motion follows from.
struct Path {
    /// I/(m ρ²).
    ratio: f64,
    /// rad/s.
    turntable: f64,
    /// Gravity down the slope, along x, m/s².
    slope: f64,
}

impl Path {
    /// Position and velocity after a time by the closed solution.
    fn at(&self, [place, velocity]: [Vector3<f64>; 2], time: f64) -> [Vector3<f64>; 2] {
        let rate = self.ratio / (1.0 + self.ratio) * self.turntable;
        let drift = Vector3::y() * (self.slope / (1.0 + self.ratio) / rate);
        let relative = velocity - drift;
        let (sin, cos) = (rate * time).sin_cos();
        let across = Vector3::z().cross(relative);
        let gone = (relative * sin + across * (1.0 - cos)) / rate;
        [place + gone + drift * time, relative * cos + across * sin + drift]
    }

    /// Position and velocity after a time, and what slip is left, by integration of the equations of motion of the ball:
    /// with the force of friction per unit of mass `f`, v̇ = f + g and κ ρ ω̇ = −z × f, such that the ball does not slip.
    fn integrated(&self, [place, velocity]: [Vector3<f64>; 2], time: f64) -> Option<[Vector3<f64>; 3]> {
        let (ratio, slope) = (self.ratio, Vector3::x() * self.slope);
        let table = Vector3::z() * self.turntable;
        // ρ ω at the start: v + ω × (−ρ z) = Ω × r.
        let spin = Vector3::z().cross(velocity - table.cross(place));
        let size =
            place.norm() + velocity.norm() / self.turntable.abs() + self.slope / self.turntable.powi(2);
        let mut problem = OdeFunction {
            rates: move |_: f64, state: &[f64], rates: &mut [f64]| {
                let velocity = Vector3::new(state[2], state[3], 0.0);
                // The contact accelerates with the turntable: f + g + f/κ = Ω × v.
                let friction = (table.cross(velocity) - slope) / (1.0 + 1.0 / ratio);
                let acceleration = friction + slope;
                let turning = -Vector3::z().cross(friction) / ratio;
                rates.copy_from_slice(&[
                    velocity.x,
                    velocity.y,
                    acceleration.x,
                    acceleration.y,
                    turning.x,
                    turning.y,
                ]);
            },
            relative: 1e-12,
            absolute: 1e-14 * size,
        };
        let start = [place.x, place.y, velocity.x, velocity.y, spin.x, spin.y];
        let states = ode::states(&mut problem, &start, &[0.0, time], 20_000).ok()?;
        let end = states.last()?;
        let [place, velocity, spin] = [0, 2, 4].map(|n| Vector3::new(end[n], end[n + 1], 0.0));
        Some([place, velocity, velocity - spin.cross(Vector3::z()) - table.cross(place)])
    }
}

impl BallOnTurntable {
    /// Answers the friction that the path needs.
    fn friction<W: Worksheet>(
        &self,
        given: &BallOnTurntableGiven<W>,
        [rate, radius, ratio]: [W::Num; 3],
        sheet: W,
    ) {
        let central = rate.powi(2) * radius;
        let (needed, why) = if self.tilt > 0.0 {
            let slope = given.gravity * given.tilt.sin();
            let cos = given.gravity * given.tilt.cos();
            (
                (central + slope) / cos,
                "Coefficient of friction that it takes where friction holds the circle and the weight along the slope at once",
            )
        } else {
            (central / given.gravity, "Coefficient of friction that it takes to keep the ball on its circle")
        };
        sheet.common_error("µ", "the ball taken to rest on the turntable, at its initial radius", || {
            given.turntable.powi(2) * given.start.magnitude() / given.gravity
        });
        let needed = sheet.step("µ", "1", needed, why);
        sheet.answer("friction", "Coefficient of friction needed", needed);
        sheet.verify(|| {
            // The force of friction per unit of mass from the rolling: (Ω × v − g) κ/(1 + κ), at its largest.
            let share = ratio / (ratio + 1.0);
            let fastest = rate.abs() * radius;
            let slope = given.gravity * given.tilt.sin();
            // Beside the drift, Ω × v_d = −g/κ along the slope.
            let force = share * (given.turntable.abs() * fastest + slope / ratio + slope);
            sheet.check_sum(
                "the force of friction from rolling without slip",
                force / (given.gravity * given.tilt.cos()),
                needed,
                needed.value(),
            );
        });
    }

    fn checks<W: Worksheet>(
        &self,
        path: &Path,
        start: [Vector3<f64>; 2],
        [period, radius, distance]: [W::Num; 3],
        [centre, place, now]: [W::Vec; 3],
        drift: Option<W::Num>,
        sheet: W,
    ) {
        let size = start[0].norm() + centre.value().norm() + radius.value();
        let fast = start[1].norm() + size / period.value();
        if self.time <= 50.0 * period.value()
            && let Some([there, velocity, slip]) = path.integrated(start, self.time)
        {
            let far = size + drift.map_or(0.0, |speed| (speed.value() * self.time).abs());
            sheet.check_zero(
                "position by integration of the equations of motion",
                (there - place.value()).norm().into(),
                far,
            );
            sheet.check_zero("velocity by integration", (velocity - now.value()).norm().into(), fast);
            sheet.check_sum("distance from the axis by integration", there.norm().into(), distance, far);
            sheet.check_zero(
                "the ball has not slipped",
                slip.norm().into(),
                fast + self.turntable.abs() * far,
            );
        }
        if let Some([half, ..]) = path.integrated(start, period.value() / 2.0) {
            // Half a circle later the ball lies on the other side of the centre, which has drifted.
            let along = Vector3::y() * drift.map_or(0.0, |speed| speed.value() * period.value() / 2.0);
            let middle = (start[0] + half - along) / 2.0;
            let across = W::Num::from((half - along - start[0]).norm() / 2.0);
            sheet.check_zero(
                "centre of the circle from half a circle",
                (middle - centre.value()).norm().into(),
                size,
            );
            sheet.check_sum("radius of the circle from half a circle", across, radius, size);
        }
        if let Some([whole, ..]) = path.integrated(start, period.value()) {
            let along = W::Num::from((whole - start[0]).y / period.value());
            let speed = drift.unwrap_or_else(|| 0.0.into());
            sheet.check_sum("drift: displacement in the time of a circle", along, speed, fast);
        }
    }

    fn distance(&self, path: &Path, start: [Vector3<f64>; 2], here: f64) -> Plot {
        let period = TAU * (1.0 + path.ratio) / (path.ratio * path.turntable.abs());
        let most = (1.2 * self.time).max(1.5 * period);
        let at = |n: u16| {
            let time = most * f64::from(n) / 300.0;
            (time, path.at(start, time)[0].norm())
        };
        Plot::new(
            "Distance from the axis against time",
            Axis::linear("time", "s"),
            Axis::linear("distance from the axis", "m"),
            vec![Series::line("d", (0..=300).map(at).collect()).of("distance")],
        )
        .over("time")
        .mark("at that time", (self.time, here))
    }

    fn path(&self, path: &Path, start: [Vector3<f64>; 2], period: f64) -> Plot {
        let circles = if self.tilt > 0.0 { 3.0 } else { 1.0 };
        let at = |n: u16| {
            let place = path.at(start, circles * period * f64::from(n) / 360.0)[0];
            (place.x, place.y)
        };
        let there = path.at(start, self.time)[0];
        Plot::new(
            "Path of the ball, seen from above",
            Axis::linear("x", "m"),
            Axis::linear("y", "m"),
            vec![Series::line("path", (0..=360).map(at).collect())],
        )
        .equal()
        .mark("start", (start[0].x, start[0].y))
        .mark("at that time", (there.x, there.y))
    }
}

impl BallOnTurntable {
    /// The turntable from above, and beside it its slope from the side.
    fn sketch(&self, [start, velocity]: [Vector3<f64>; 2], centre: Vector3<f64>, radius: f64) -> Drawing {
        let size = (centre.norm() + radius).max(1.2 * start.norm()).max(f64::MIN_POSITIVE);
        let at = |place: Vector3<f64>| (place.x / size, place.y / size);
        let sweep = if self.turntable > 0.0 { (1.9, 2.9) } else { (2.9, 1.9) };
        let mut sketch = Sketch::new("The turntable from above and its tilt from the side");
        sketch
            .circle((0.0, 0.0), 1.1, Ink::Body)
            .vector("x", (-1.1, 0.0), (1.35, 0.0), Ink::Faint)
            .vector("y", (0.0, -1.1), (0.0, 1.3), Ink::Faint)
            .couple("Ω", (0.0, 0.0), sweep, Ink::Motion)
            .circle(at(centre), radius / size, Ink::Motion)
            .vector("r₀", (0.0, 0.0), at(start), Ink::Result)
            .disc("", at(start), 0.05);
        if centre.norm() > 0.05 * size {
            sketch.mass_centre("r_c", at(centre));
        }
        if let (Release::Velocity { .. }, Some(along)) = (&self.release, velocity.try_normalize(0.0)) {
            let (x, y) = at(start);
            sketch.motion("v₀", (x, y), (x + 0.4 * along.x, y + 0.4 * along.y));
        }
        let (sin, cos) = self.tilt.sin_cos();
        let top = (1.8, 0.0);
        let foot = (top.0 + 1.2 * cos, top.1 - 1.2 * sin);
        sketch.ground(foot, top).axis((foot.0 - 1.2, foot.1), foot).angle("β", foot, PI, PI - self.tilt);
        if let Ball::Given { .. } = self.ball {
            sketch.label("κ", at(start));
        }
        sketch.disc("", (top.0 + 0.6 * cos + 0.08 * sin, top.1 - 0.6 * sin + 0.08 * cos), 0.08);
        sketch.finish()
    }
}
