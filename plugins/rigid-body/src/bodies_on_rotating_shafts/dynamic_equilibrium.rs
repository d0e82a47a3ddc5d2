//! A rod or a plate that hangs from a hinge on a turning shaft: where it stands out by itself.

use std::{
    f64::consts::{FRAC_PI_2, PI},
    ops::ControlFlow,
};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, rigid};
use dalembert_numerics::roots;
use nalgebra::Vector3;

use crate::{
    shared::differences::{second_rate, second_slope},
    sources::{BEER, RIUL},
};

/// A body that swings about a level pin on a vertical shaft.
///
/// The pin stands square to the plane of the shaft and of the line from the pin to G. The angle is that of this line
/// to the vertical, from hanging straight down, positive away from the shaft.
#[derive(Clone, Debug, Inputs)]
pub struct DynamicEquilibrium {
    /// Body.
    pub body: Hanging,
    /// Mass.
    /// Forces grow with it; angle and speed do not depend on it.
    #[input("m", "kg", positive, default = "1 kg")]
    pub mass: f64,
    /// Distance of the pin from the axis of the shaft.
    #[input("a", "m", nonnegative, default = "0 m")]
    pub offset: f64,
    /// Given.
    pub known: SteadyMotionInput,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// Body that hangs from the pin.
#[derive(Clone, Debug, Inputs)]
pub enum Hanging {
    /// Slender rod, or plate hung by an edge
    Rod {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Particle on a light rod
    Particle {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Body symmetrical about the line from the pin to G
    Symmetric {
        /// Distance of G from the pin.
        #[input("r_G", "m", positive)]
        centre: f64,
        /// Radius of gyration along the line: m k² = ∫ ξ² dm from the pin.
        #[input("k_ξ", "m", positive)]
        along: f64,
        /// Radius of gyration normal to the line: m k² = ∫ η² dm.
        #[input("k_η", "m", nonnegative, default = "0 m")]
        across: f64,
    },
}

/// Given quantity of the steady motion.
#[derive(Clone, Debug, Inputs)]
pub enum SteadyMotionInput {
    /// Speed of the shaft
    Speed {
        /// Angular velocity of the shaft.
        #[input("ω", "rad/s")]
        speed: f64,
    },
    /// Angle of the body
    Angle {
        /// Angle to the vertical.
        #[input("θ", "rad")]
        angle: f64,
    },
}

register!(DynamicEquilibrium);

impl Analysis for DynamicEquilibrium {
    const ABOUT: About = About {
        id: "rigid-body/dynamic-equilibrium",
        title: "Hinged body on a rotating shaft",
        topic: "Bodies on rotating shafts",
        summary: "Equilibrium angle of a rod, plate or particle hinged to a rotating shaft, or the speed for a given angle; its stability and the hinge forces.",
        main: &["angle", "critical_speed", "speed"],
        keywords: "dynamic equilibrium conical pendulum hinged rod governor rotating frame equilíbrio dinâmico \
                   relativo pêndulo cônico haste articulada eixo vertical regulador velocidade crítica ângulo \
                   centrifugal governor regulador centrífugo",
        sources: &[&RIUL, &BEER],
        cases: include_str!("../../cases/dynamic_equilibrium.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &DynamicEquilibriumGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (centre, along, across) = shape(given, sheet);
        let out = match across {
            Some(across) => {
                sheet.step("D", "kg*m^2", along - across, "The inertia forces grow with ∫ ξ² dm − ∫ η² dm")
            }
            None => along,
        };
        let weight = sheet.step(
            "G_m",
            "N*m",
            given.mass * given.gravity * centre,
            "Maximum moment of the weight about the pin",
        );
        let (speed, angle) = match given.known {
            SteadyMotionInputGiven::Angle { angle } => {
                (self.speed_for(angle, given, [centre, out, weight], sheet)?, angle)
            }
            SteadyMotionInputGiven::Speed { speed } => (speed, self.angle_at(speed, out, weight, sheet)?),
        };
        if self.offset == 0.0 && out.value() > 0.0 {
            if let HangingGiven::Rod { length } = given.body {
                let pendulum = || (given.gravity / length).sqrt();
                let what = "the rod treated as a simple pendulum with its mass at the free end";
                sheet.common_error("ω_c", what, pendulum);
            }
            let critical = sheet.step(
                "ω_c",
                "rad/s",
                (weight / out).sqrt(),
                "Speed above which the body leaves the vertical: cos θ = 1",
            );
            sheet.answer("critical_speed", "Speed above which the body leaves the vertical", critical);
            sheet.verify(|| {
                let potential = |angle: f64| self.potential(critical.value(), angle);
                let Some(bend) = second_slope(potential, PI) else { return };
                let what = "the second derivative of the potential of a hanging body is zero at that speed";
                sheet.check_zero(what, bend.into(), weight.value());
            });
        }
        let moments = |sin: W::Num, cos: W::Num| {
            speed.powi(2) * (given.mass * given.offset * centre * cos + out * sin * cos) - weight * sin
        };
        self.small_swings(given, [speed, angle, centre, along, out, weight], across, sheet);
        let radius = sheet.step(
            "x_G",
            "m",
            given.offset + centre * angle.sin(),
            "Distance of G from the axis of the shaft",
        );
        let level = sheet.step(
            "R_x",
            "N",
            given.mass * speed.powi(2) * radius,
            ("Force of the pin towards the shaft: it keeps G on its circle", RIUL.at("eqs. 22–23")),
        );
        if let HangingGiven::Particle { .. } = given.body {
            let tension = || given.mass * given.gravity / angle.cos();
            let what = "whole tension of the rod taken as the force upwards";
            sheet.common_error("R_y", what, tension);
        }
        let upright = sheet.step("R_y", "N", given.mass * given.gravity, "Force of the pin upwards");
        sheet.answer("force_towards_the_shaft", "Force of the pin towards the shaft", level);
        sheet.answer("force_upwards", "Force of the pin upwards", upright);
        sheet.verify(|| {
            let ((sin, cos), centre) = (angle.value().sin_cos(), centre.value());
            let about_centre = out.value() - self.mass * centre.powi(2);
            let couple = speed.value().powi(2) * about_centre * sin * cos;
            let of_pin = centre * (level.value() * cos - upright.value() * sin);
            let size = centre * (level.value().abs() + upright.value())
                + speed.value().powi(2) * (out.value().abs() + self.mass * centre.powi(2));
            let what = "moments of the force of the pin and of the inertia couple about G";
            sheet.check_zero(what, (of_pin + couple).into(), size);
            let at = |t: f64| {
                let (sin, cos) = (speed.value() * t).sin_cos();
                Vector3::new(cos, sin, 0.0) * radius.value()
            };
            if let Some(acceleration) = second_rate(at, 2.0 * PI / speed.value().abs()) {
                let what = "mass times the acceleration of G, by finite differences of its position";
                let size = level.value().abs() + self.mass * speed.value().powi(2) * self.offset;
                sheet.check_sum(what, level, (-self.mass * acceleration.x).into(), size);
            }
        });
        sheet.verify(|| {
            sheet.check_zero(
                "the moments of the inertia forces and of the weight about the pin",
                moments(angle.sin(), angle.cos()),
                weight.value().max((speed.powi(2) * out).value().abs()),
            );
            let potential = |t: f64| Vector3::x() * self.potential(speed.value(), angle.value() + t);
            if let Ok(slope) = rigid::numerical_rate(potential, PI) {
                sheet.check_zero(
                    "the potential of weight and centrifugal forces is stationary there",
                    W::Num::from(slope.x),
                    weight.value() + (speed.powi(2) * along).value().abs(),
                );
            }
        });
        let (speed, angle) = (speed.value(), angle.value());
        sheet.show(|| Exhibit::Drawing(self.drawing(angle, speed)));
        sheet.show(|| Exhibit::Plot(self.couple_over_angle(speed, angle)));
        sheet.show(|| Exhibit::Plot(self.angle_over_speed(speed, angle)));
        Ok(())
    }
}

/// Distance of G from the pin, ∫ ξ² dm and, unless it is nothing, ∫ η² dm.
fn shape<W: Worksheet>(given: &DynamicEquilibriumGiven<W>, sheet: W) -> (W::Num, W::Num, Option<W::Num>) {
    let along_the_line =
        |value: W::Num| sheet.step("J_ξ", "kg*m^2", value, "∫ ξ² dm along the line, from the pin");
    match given.body {
        HangingGiven::Rod { length } => {
            let centre = sheet.step("r_G", "m", length / 2.0, "Distance of G from the pin");
            let about_centre = || rigid::rod_inertia(given.mass, length);
            sheet.common_error("J_ξ", "moment of inertia of the rod taken about its midpoint", about_centre);
            let at_centre = || given.mass * centre.powi(2);
            sheet.common_error("J_ξ", "centrifugal force of the whole body applied at G", at_centre);
            (centre, along_the_line(given.mass * length.powi(2) / 3.0), None)
        }
        HangingGiven::Particle { length } => (length, along_the_line(given.mass * length.powi(2)), None),
        HangingGiven::Symmetric { centre, along, across } => {
            let shifted = || rigid::parallel_axis(given.mass * along.powi(2), given.mass, centre);
            let what = "radius of gyration treated as one about G, the parallel-axis term added";
            sheet.common_error("J_ξ", what, shifted);
            let at_centre = || given.mass * centre.powi(2);
            sheet.common_error("J_ξ", "centrifugal force of the whole body applied at G", at_centre);
            let along = along_the_line(given.mass * along.powi(2));
            let across = (across.value() != 0.0).then(|| {
                sheet.step("J_η", "kg*m^2", given.mass * across.powi(2), "∫ η² dm normal to the line")
            });
            (centre, along, across)
        }
    }
}

impl DynamicEquilibrium {
    /// Distance of G from the pin, ∫ ξ² dm and ∫ η² dm over the mass, as plain numbers.
    fn plain(&self) -> [f64; 3] {
        match self.body {
            Hanging::Rod { length } => [length / 2.0, length.powi(2) / 3.0, 0.0],
            Hanging::Particle { length } => [length, length.powi(2), 0.0],
            Hanging::Symmetric { centre, along, across } => [centre, along.powi(2), across.powi(2)],
        }
    }

    /// Moment about the pin of inertia forces and weight, N·m, outwards.
    fn moment(&self, speed: f64, angle: f64) -> f64 {
        let [centre, along, across] = self.plain();
        let (sin, cos) = angle.sin_cos();
        self.mass
            * (speed.powi(2) * (self.offset * centre * cos + (along - across) * sin * cos)
                - self.gravity * centre * sin)
    }

    /// Potential of the centrifugal forces and of the weight, J.
    fn potential(&self, speed: f64, angle: f64) -> f64 {
        let [centre, along, across] = self.plain();
        let (sin, cos) = angle.sin_cos();
        let about_shaft = 2.0 * self.offset * centre * sin + along * sin.powi(2) + across * cos.powi(2);
        -self.mass * (speed.powi(2) * about_shaft / 2.0 + self.gravity * centre * cos)
    }

    /// The angle at which the body stands out at a speed, rad.
    fn standing(&self, speed: f64) -> Result<f64, Refusal> {
        let [centre, along, across] = self.plain();
        if self.offset == 0.0 {
            let cosine = self.gravity * centre / ((along - across) * speed.powi(2));
            return Ok(if cosine > 0.0 && cosine < 1.0 { cosine.acos() } else { 0.0 });
        }
        if speed == 0.0 {
            return Ok(0.0);
        }
        // Outwards when it hangs, inwards when it is level; both over the largest of the two.
        let size = self.mass * (self.gravity * centre).max(speed.powi(2) * (along + self.offset * centre));
        let moment = |angle: f64| self.moment(speed, angle) / size;
        roots::find(moment, [0.0, FRAC_PI_2], |_| ControlFlow::Continue(())).map_err(|_| {
            Refusal::because("the lengths and the speed are too disparate for an angle to be found")
        })
    }

    fn speed_for<W: Worksheet>(
        &self,
        angle: W::Num,
        given: &DynamicEquilibriumGiven<W>,
        [centre, out, weight]: [W::Num; 3],
        sheet: W,
    ) -> Result<W::Num, Refusal> {
        let (sin, cos) = (angle.sin(), angle.cos());
        if self.offset == 0.0 && sin.value().abs() < 1e-12 {
            return Err(Refusal::because(
                "a body hinged on the axis itself hangs straight down at every speed: give another angle, or the speed",
            ));
        }
        let outwards = sheet.step(
            "E",
            "kg*m^2",
            if self.offset == 0.0 {
                out * sin * cos
            } else {
                given.mass * given.offset * centre * cos + out * sin * cos
            },
            ("Moment of the inertia forces about the pin, per unit ω²", RIUL.at("eqs. 22–23")),
        );
        let square = weight.value() * sin.value() / outwards.value();
        if !(square.is_finite() && square >= 0.0) || outwards.value().abs() <= 1e-14 * out.value().abs() {
            return Err(Refusal::because(
                "no speed holds the body at this angle: the inertia forces lift it away from the shaft, but never to the level of the pin",
            ));
        }
        if let HangingGiven::Rod { length } = given.body {
            let conical = || (given.gravity * angle.tan() / (given.offset + length * sin)).sqrt();
            let what = "the rod treated as a conical pendulum with its mass at the free end";
            sheet.common_error("ω", what, conical);
        }
        if self.offset != 0.0 {
            let on_axis = || (weight / (out * cos)).sqrt();
            sheet.common_error("ω", "pin assumed on the axis of the shaft", on_axis);
        }
        let speed = sheet.step(
            "ω",
            "rad/s",
            (weight * sin / outwards).sqrt(),
            ("Speed at which the moments about the pin cancel", RIUL.at("eqs. 22–23")),
        );
        sheet.answer("speed", "Speed of the shaft", speed);
        Ok(speed)
    }

    fn angle_at<W: Worksheet>(
        &self,
        speed: W::Num,
        out: W::Num,
        weight: W::Num,
        sheet: W,
    ) -> Result<W::Num, Refusal> {
        let found = self.standing(speed.value())?;
        let angle = if self.offset == 0.0 && found > 0.0 {
            if matches!(self.body, Hanging::Rod { .. }) {
                let conical = || weight / (out * speed.powi(2)) * 2.0 / 3.0;
                let what = "the rod treated as a conical pendulum with its mass at the free end";
                sheet.common_error("c", what, conical);
            }
            let cosine = sheet.step(
                "c",
                "1",
                weight / (out * speed.powi(2)),
                (
                    "Moments about the pin: D ω² sin θ cos θ = m g r sin θ, which gives cos θ",
                    RIUL.at("eqs. 22–23"),
                ),
            );
            sheet.step("θ", "deg", cosine.acos(), "Equilibrium angle of the body")
        } else if self.offset == 0.0 {
            let how = "Too slow to leave the vertical: cos θ would exceed 1";
            sheet.numerical("θ", "deg", 0.0, how)
        } else {
            let on_axis = || (weight / (out * speed.powi(2))).acos();
            sheet.common_error("θ", "pin assumed on the axis of the shaft", on_axis);
            let how = "Root of ω² (m a r cos θ + D sin θ cos θ) = m g r sin θ between the downward vertical and the horizontal";
            sheet.numerical("θ", "deg", found, (how, RIUL.at("eqs. 22–23")))
        };
        sheet.answer("angle", "Angle to the vertical", angle);
        Ok(angle)
    }

    /// Stability, and the circular frequency of small swings about the angle at steady speed.
    fn small_swings<W: Worksheet>(
        &self,
        given: &DynamicEquilibriumGiven<W>,
        [speed, angle, centre, along, out, weight]: [W::Num; 6],
        across: Option<W::Num>,
        sheet: W,
    ) {
        let (sin, cos) = (angle.sin(), angle.cos());
        let turning = if self.offset == 0.0 {
            out * (sin.powi(2) - cos.powi(2))
        } else {
            given.mass * given.offset * centre * sin + out * (sin.powi(2) - cos.powi(2))
        };
        let stiffness = sheet.step(
            "k_θ",
            "N*m",
            weight * cos + speed.powi(2) * turning,
            "Stiffness of the restoring moment",
        );
        let size = weight.value().abs() + (speed.powi(2) * out).value().abs();
        if stiffness.value() > 1e-12 * size {
            let inertia = across.map_or(along, |across| along + across);
            let at_rest = || (weight / inertia).sqrt();
            sheet.common_error("p", "frequency of the pendulum on a shaft at rest used", at_rest);
            if !matches!(self.body, Hanging::Particle { .. }) {
                let about_centre = || (stiffness / (inertia - given.mass * centre.powi(2))).sqrt();
                sheet.common_error("p", "moment of inertia of the swinging body taken about G", about_centre);
            }
            let frequency = sheet.step(
                "p",
                "rad/s",
                (stiffness / inertia).sqrt(),
                "Angular frequency of small oscillations about this angle, at constant speed",
            );
            sheet.answer("swing_frequency", "Angular frequency of small oscillations", frequency);
            sheet.verify(|| {
                let potential = |off: f64| self.potential(speed.value(), angle.value() + off);
                let Some(bend) = second_slope(potential, PI) else { return };
                let what = "second derivative of the potential of weight and centrifugal forces";
                let size = weight.value()
                    + speed.value().powi(2)
                        * (along.value() + self.offset.abs() * self.mass * centre.value());
                sheet.check_sum(what, inertia * frequency.powi(2), bend.into(), size);
            });
        } else {
            sheet.warn(|| {
                Text::from("the body does not stay at this angle: a small push drives it further away")
            });
        }
    }

    fn drawing(&self, angle: f64, speed: f64) -> Drawing {
        let [centre, ..] = self.plain();
        let length = match self.body {
            Hanging::Rod { length } | Hanging::Particle { length } => length,
            Hanging::Symmetric { centre, .. } => 2.0 * centre,
        };
        let pin = (self.offset, 0.0);
        let at = |distance: f64| (pin.0 + distance * angle.sin(), pin.1 - distance * angle.cos());
        let mut sketch = Sketch::new("The body and the shaft");
        sketch
            .link("", (0.0, -1.1 * length), (0.0, 0.4 * length))
            .bearing("", (0.0, -length), FRAC_PI_2)
            .bearing("", (0.0, 0.25 * length), FRAC_PI_2)
            .link("", (0.0, 0.0), pin)
            .axis(pin, (pin.0, -0.6 * length))
            .angle("θ", pin, -FRAC_PI_2, angle - FRAC_PI_2);
        let side = if angle < 0.0 { -2.5 } else { 2.5 };
        match self.body {
            Hanging::Rod { .. } => sketch.link("m", pin, at(length)).dimension("L", pin, at(length), side),
            Hanging::Particle { .. } => sketch
                .bars([pin, at(length)])
                .dimension("L", pin, at(length), side)
                .disc("m", at(length), 0.07 * length),
            Hanging::Symmetric { .. } => {
                let half = 0.12 * length;
                let beside = |distance: f64, across: f64| {
                    let (x, y) = at(distance);
                    (x + across * angle.cos(), y + across * angle.sin())
                };
                let corners = [(0.0, -half), (length, -half), (length, half), (0.0, half)];
                sketch
                    .body("", corners.map(|(along, across)| beside(along, across)))
                    .dimension("r_G", pin, at(centre), side + side.signum())
                    .label("m, k_ξ, k_η", at(length))
            }
        };
        sketch.joint("", pin).mass_centre("G", at(centre));
        if self.offset > 0.0 {
            sketch.dimension("a", (0.0, 0.0), pin, 2.0);
        }
        if speed != 0.0 {
            sketch.motion("ω", (0.0, 0.4 * length), (0.0, 0.7 * length));
        }
        sketch.finish()
    }

    fn couple_over_angle(&self, speed: f64, angle: f64) -> Plot {
        let at = |n: i32| {
            let angle = PI * f64::from(n) / 120.0;
            (angle, -self.moment(speed, angle))
        };
        Plot::new(
            "Couple required to hold the body at an angle",
            Axis::linear("angle to the vertical", "deg"),
            Axis::linear("couple", "N*m"),
            vec![Series::line("M", (-120..=120).map(at).collect())],
        )
        .mark("equilibrium", (angle, 0.0))
    }

    fn angle_over_speed(&self, speed: f64, angle: f64) -> Plot {
        let [centre, along, _] = self.plain();
        let natural = (self.gravity * centre / along).sqrt();
        let most = (speed.abs() * 1.5).max(2.5 * natural);
        let at = |n: i32| {
            let speed = most * f64::from(n) / 160.0;
            self.standing(speed).map_or((speed, f64::NAN), |angle| (speed, angle))
        };
        Plot::new(
            "Angle against the speed of the shaft",
            Axis::linear("speed", "rpm"),
            Axis::linear("angle to the vertical", "deg"),
            vec![Series::line("θ", (0..=160).map(at).collect()).of("angle")],
        )
        .over("known.speed.speed")
        .mark("at this speed", (speed.abs(), angle))
    }
}
