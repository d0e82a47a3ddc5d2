//! A pair of wheels on a track whose one rail dips: the couple that turns the axle, and the forces on the rails.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, gyroscope},
};
use nalgebra::{Rotation3, Vector3};

use crate::{
    shared::{differences::second_slope, flat::into_page},
    sources::KHURMI,
};

/// A pair of wheels on an axle that runs over a dip of one rail, which sinks and rises in simple harmonic motion.
#[derive(Clone, Debug, Inputs)]
pub struct DippingRail {
    /// Moment of inertia of the pair of wheels about its axle.
    #[input("I_a", "kg*m^2", positive)]
    pub axial_inertia: f64,
    /// Transverse moment of inertia of the pair of wheels.
    /// For the couple that lifts and lowers it.
    #[input("I_t", "kg*m^2", positive)]
    pub transverse_inertia: Option<f64>,
    /// Diameter of the wheels.
    #[input("D", "m", positive)]
    pub diameter: f64,
    /// Distance between the wheels.
    #[input("w", "m", positive)]
    pub gauge: f64,
    /// Speed.
    #[input("v", "m/s", nonnegative)]
    pub speed: f64,
    /// Depth of the dip.
    #[input("δ", "m", nonnegative)]
    pub depth: f64,
    /// Extent of the dip.
    pub length: Length,
    /// Dipping rail.
    pub rail: Rail,
}

/// Length or duration of the whole dip.
#[derive(Clone, Debug, Inputs)]
pub enum Length {
    /// By duration
    Time {
        /// Time from beginning to end.
        #[input("t", "s", positive)]
        time: f64,
    },
    /// By length
    Along {
        /// Length along the rail.
        #[input("λ", "m", positive)]
        length: f64,
    },
}

/// One of the rails.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Rail {
    /// Left
    Left,
    /// Right
    Right,
}

register!(DippingRail);

impl Analysis for DippingRail {
    const ABOUT: About = About {
        id: "rigid-body/dipping-rail",
        title: "Pair of wheels on a dipping rail",
        topic: "Gyroscopes and vehicles",
        summary: "Gyroscopic couple of a locomotive's pair of wheels when one rail dips, and the resulting forces between wheels and rails.",
        main: &["couple", "load_change"],
        keywords: "locomotive wheel axle rail dip gyroscopic locomotiva rodeiro trilho rebaixo desnível giroscópico",
        sources: &[&KHURMI],
        cases: include_str!("../../cases/dipping_rail.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &DippingRailGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.speed == 0.0 && matches!(self.length, Length::Along { .. }) {
            return Err(Refusal::because(
                "wheels at rest never pass a dip of a given length: write a speed above zero, or the time of the dip",
            ));
        }
        let spin = sheet.step(
            "ω",
            "rad/s",
            given.speed * 2.0 / given.diameter,
            "Angular velocity of the wheels, rolling without slipping",
        );
        let time = match given.length {
            LengthGiven::Time { time } => time,
            LengthGiven::Along { length } => {
                sheet.step("t", "s", length / given.speed, "Time to pass the dip")
            }
        };
        sheet.common_error("a", "whole depth of the dip taken as the amplitude", || given.depth);
        let amplitude =
            sheet.step("a", "m", given.depth / 2.0, "Amplitude of the harmonic motion: half of the depth");
        let frequency = sheet.step(
            "p",
            "rad/s",
            W::Num::from(TAU) / time,
            "Angular frequency: the whole dip is one period",
        );
        let average = || given.depth * 2.0 / time;
        sheet.common_error("V", "average speed of the descent used in place of the maximum", average);
        let fall = sheet.step(
            "V",
            "m/s",
            amplitude * frequency,
            "Maximum speed of the descending wheel, half way down",
        );
        let about_middle = || fall * 2.0 / given.gauge;
        let what = "axle assumed to tilt about its midpoint, half of the gauge used";
        sheet.common_error("ω_p", what, about_middle);
        let rate = sheet.step(
            "ω_p",
            "rad/s",
            fall / given.gauge,
            "Maximum angular velocity with which the axle tilts",
        );
        let couple = sheet.step(
            "C",
            "N*m",
            gyroscope::right_angled_couple(given.axial_inertia, spin, rate),
            ("Maximum gyroscopic couple, about the vertical", KHURMI.at("example 14.14")),
        );
        let shared = || couple / (given.gauge * 2.0);
        sheet.common_error("P", "couple divided between the wheels: half of the force at each", shared);
        let by_radius = || couple * 2.0 / given.diameter;
        sheet.common_error("P", "radius of the wheels taken as the lever arm of the couple", by_radius);
        let force = sheet.step(
            "P",
            "N",
            couple / given.gauge,
            (
                "Force between each wheel and its rail, along the track, opposite on both sides",
                KHURMI.at("example 14.14"),
            ),
        );
        let average = || rate * 4.0 / time;
        let what = "average angular acceleration over a quarter of the dip used in place of the maximum";
        sheet.common_error("α", what, average);
        let acceleration = sheet.step(
            "α",
            "rad/s^2",
            amplitude * frequency.powi(2) / given.gauge,
            "Maximum angular acceleration of the axle, at the top and at the bottom of the dip",
        );
        sheet.answer("couple", "Maximum gyroscopic couple", couple);
        sheet.answer("rail_force", "Force between each wheel and its rail", force);
        sheet.answer("tilting_rate", "Maximum angular velocity of the tilting axle", rate);
        sheet.answer(
            "tilting_acceleration",
            "Maximum angular acceleration of the tilting axle",
            acceleration,
        );
        sheet.answer("wheel_speed", "Angular velocity of the wheels", spin);
        if let Some(transverse) = given.transverse_inertia {
            let tilting =
                sheet.step("C_α", "N*m", transverse * acceleration, "Couple that tilts the pair of wheels");
            let with_gyroscopic = || (tilting + couple) / given.gauge;
            let what = "gyroscopic couple, which acts about the vertical, added to the tilting couple";
            sheet.common_error("ΔN", what, with_gyroscopic);
            let load = sheet.step("ΔN", "N", tilting / given.gauge, "Corresponding change of the wheel load");
            sheet.answer("tilting_couple", "Maximum couple that tilts the pair of wheels", tilting);
            sheet.answer("load_change", "Maximum change of each wheel load", load);
            sheet.verify(|| {
                let Some(tilting_rate) = second_slope(|t| self.tilt(t, time.value()), time.value()) else {
                    return;
                };
                let what =
                    "change of the angular momentum about the track at the top of the dip, by differences";
                let change = self.transverse_inertia.unwrap_or(0.0) * tilting_rate;
                sheet.check(what, tilting, change.into());
                sheet.check("moment of the changes of both wheel loads", load * given.gauge, change.into());
            });
        }
        // Rolling forward, H points left. A sinking left wheel turns the axle about the backward direction:
        // Ω × H points down, its reaction up.
        let words = match self.rail {
            Rail::Left => {
                "Effect: while the left wheel descends, the pair of wheels tends to turn to the left; while it rises, to the right"
            }
            Rail::Right => {
                "Effect: while the right wheel descends, the pair of wheels tends to turn to the right; while it rises, to the left"
            }
        };
        let effect = sheet.step("C_z", "N*m", couple.abs(), words);
        sheet.answer("effect", words, effect);
        sheet.verify(|| {
            self.check_by_rotation(rate.value(), spin.value(), couple, force, sheet);
            self.check_tilting(time.value(), spin, [rate, acceleration], sheet);
        });
        let (couple, time) = (couple.value(), time.value());
        sheet.show(|| Exhibit::Plot(couple_over_dip(couple, time)));
        sheet.show(|| Exhibit::Drawing(self.sketch()));
        Ok(())
    }
}

impl DippingRail {
    /// Tilt angle of the axle at a time.
    fn tilt(&self, t: f64, time: f64) -> f64 {
        self.depth / 2.0 * (1.0 - (TAU * t / time).cos()) / self.gauge
    }

    /// Rate and acceleration of the tilting by differences of the angle, and the contact that rests.
    fn check_tilting<W: Worksheet>(
        &self,
        time: f64,
        spin: W::Num,
        [rate, acceleration]: [W::Num; 2],
        sheet: W,
    ) {
        let half_way = |t: f64| Vector3::x() * self.tilt(time / 4.0 + t, time);
        if let Ok(found) = rigid::numerical_rate(half_way, time) {
            let what = "difference quotient of the angle of the axle half way down";
            sheet.check(what, rate, found.x.into());
        }
        if let Some(found) = second_slope(|t| self.tilt(t, time), time) {
            let what = "second difference quotient of the angle of the axle at the top";
            sheet.check(what, acceleration, found.into());
        }
        let (radius, speed) = (self.diameter / 2.0, self.speed);
        let rim = |t: f64| {
            let (sin, cos) = (spin.value() * t).sin_cos();
            Vector3::new(speed * t - radius * sin, radius - radius * cos, 0.0)
        };
        let period = TAU * radius / speed;
        let Ok(velocity) = rigid::numerical_rate(rim, period) else { return };
        sheet.check_zero("velocity of the point of the wheel on the rail", velocity.norm().into(), speed);
    }

    /// A second method: the difference quotient of the angular momentum of the tilting pair, turned as a whole.
    fn check_by_rotation<W: Worksheet>(&self, rate: f64, spin: f64, couple: W::Num, force: W::Num, sheet: W) {
        let transverse = self.transverse_inertia.unwrap_or(self.axial_inertia);
        let tensor = gyroscope::symmetric_tensor(self.axial_inertia, transverse, Vector3::y());
        let about = -Vector3::x() * rate;
        let momentum_at = |t: f64| {
            let tilt = Rotation3::from_scaled_axis(about * t);
            rigid::turned(&tensor, &tilt) * (about + tilt * Vector3::y() * spin)
        };
        let period = if rate > 0.0 { TAU / rate } else { 1.0 };
        let Ok(derivative) = rigid::numerical_rate(momentum_at, period) else { return };
        sheet.check_zero(
            "the couple from the difference quotient of R I Rᵀ ω",
            W::Num::from(derivative.norm() - couple.value()),
            Vector::value(momentum_at(0.0)).norm() * TAU / period,
        );
        sheet.check_zero(
            "moment of the forces of both rails from the same difference quotient",
            W::Num::from(derivative.norm() - force.value() * self.gauge),
            Vector::value(momentum_at(0.0)).norm() * TAU / period,
        );
    }

    /// The wheel pair from behind on its dip, which is drawn steeper, and the dip of the rail from its side.
    fn sketch(&self) -> Drawing {
        let tilt: f64 = if self.rail == Rail::Left { 0.12 } else { -0.12 };
        let (sin, cos) = tilt.sin_cos();
        let at = |along: f64, up: f64| (along * cos - up * sin, along * sin + up * cos);
        let mut sketch = Sketch::new("The wheel pair from behind, and the dip from the side (not to scale)");
        sketch.axis((-1.4, 0.0), (1.4, 0.0)).link("", at(-1.15, 0.0), at(1.15, 0.0));
        for side in [-1.0, 1.0] {
            let foot = at(side, -0.7);
            sketch.ground((foot.0 - 0.3, foot.1), (foot.0 + 0.3, foot.1)).body(
                "",
                [(-0.08, -0.7), (0.08, -0.7), (0.08, 0.7), (-0.08, 0.7)].map(|(x, y)| at(side + x, y)),
            );
        }
        let inertia = if self.transverse_inertia.is_some() { "I_a, I_t" } else { "I_a" };
        sketch
            .motion("ω", at(0.3, 0.0), at(-0.4, 0.0))
            .label(inertia, at(0.6, 0.0))
            .dimension("D", at(-1.0, -0.7), at(-1.0, 0.7), 2.5)
            .dimension("w", (at(-1.0, -0.7).0, -0.95), (at(1.0, -0.7).0, -0.95), -1.5);
        into_page(&mut sketch, "v", at(0.0, 0.45), 0.12);
        // The rail goes down by its depth and up again over the length.
        let (left, length, depth) = (2.0, 2.2, 0.45);
        let rail = |n: i32| {
            let part = f64::from(n) / 24.0;
            (left + length * part, -0.3 - depth * (1.0 - (TAU * part).cos()) / 2.0)
        };
        let middle = left + length / 2.0;
        sketch
            .curve((0..=24).map(rail).collect::<Vec<_>>(), Ink::Body)
            .axis((left - 0.2, -0.3), (left + length + 0.2, -0.3))
            .dimension("δ", (middle, -0.3), (middle, -0.3 - depth), 0.0)
            .circle((left - 0.1, -0.05), 0.25, Ink::Body)
            .motion("v", (left - 0.1, -0.05), (left + 0.6, -0.05));
        let name = match self.length {
            Length::Time { .. } => "v t",
            Length::Along { .. } => "λ",
        };
        sketch.dimension(name, (left, -0.3 - depth), (left + length, -0.3 - depth), -2.0).finish()
    }
}

fn couple_over_dip(couple: f64, time: f64) -> Plot {
    let at = |n: u16| {
        let t = time * f64::from(n) / 160.0;
        (t, couple * (TAU * t / time).sin())
    };
    Plot::new(
        "Gyroscopic couple over the dip",
        Axis::linear("time", "s"),
        Axis::linear("couple", "N*m"),
        vec![Series::line("C", (0..=160).map(at).collect())],
    )
    .mark("half way down", (time / 4.0, couple))
}
