//! The lean of a two-wheeler in a turn, with the gyroscopic couples of its wheels and its engine.

use std::{
    f64::consts::{FRAC_PI_2, TAU},
    ops::ControlFlow,
};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet,
    register,
};
use dalembert_mechanics::{Real, rigid};
use dalembert_numerics::roots;
use nalgebra::{Rotation3, Vector3};

use crate::{
    shared::{differences::second_rate, flat::into_page},
    sources::{BEER, KHURMI},
};

/// A motorcycle or a bicycle with its rider, leaning into a turn as one rigid body.
///
/// The tyres are thin: the line of contact stays in the middle plane.
#[derive(Clone, Debug, Inputs)]
pub struct TwoWheelerLean {
    /// Mass with rider.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Height of the centre of mass.
    /// With the vehicle upright.
    #[input("h", "m", positive)]
    pub centre_height: f64,
    /// Radius of the wheels.
    #[input("r", "m", positive)]
    pub wheel_radius: f64,
    /// Moment of inertia of each wheel.
    #[input("I_w", "kg*m^2", nonnegative)]
    pub wheel_inertia: f64,
    /// Engine.
    pub engine: Option<TransverseEngine>,
    /// Yaw less pitch moment of inertia of the whole vehicle.
    /// With wheels and rider, about axes through G: the one about the vehicle's own vertical axis less the one about
    /// its transverse axis. Textbooks neglect it; it is small compared with m h².
    #[input("J", "kg*m^2")]
    pub inertia_difference: Option<f64>,
    /// Radius of the turn.
    #[input("R", "m", positive)]
    pub radius: f64,
    /// Radius measured.
    pub measured: Measured,
    /// Find.
    pub motion: KnownMotion,
    /// Friction coefficient of the tyres.
    #[input("µ", "1", positive)]
    pub friction: Option<f64>,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// The turning parts of an engine whose shaft lies across the vehicle.
#[derive(Clone, Debug, Inputs)]
pub struct TransverseEngine {
    /// Moment of inertia of its rotating parts.
    #[input("I_e", "kg*m^2", nonnegative)]
    pub inertia: f64,
    /// Gear ratio.
    /// Engine speed divided by wheel speed.
    #[input("G", "1", nonnegative)]
    pub ratio: f64,
    /// Sense.
    pub sense: Sense,
}

/// Sense of rotation of the engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Sense {
    /// Same sense as the wheels
    Like,
    /// Opposite to the wheels
    Against,
}

/// To where the radius of the turn reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Measured {
    /// To the centre of mass
    CentreOfMass,
    /// To the wheel path
    /// The centre of mass then runs on the smaller circle of radius R − h sin θ.
    Track,
}

/// Known quantity of the motion.
#[derive(Clone, Debug, Inputs)]
pub enum KnownMotion {
    /// The lean at a given speed
    Speed {
        /// Speed of the wheels.
        #[input("v", "m/s", nonnegative)]
        speed: f64,
    },
    /// The speed for a given lean
    Lean {
        /// Lean angle from the vertical.
        #[input("θ", "rad", nonnegative, max = 1.5)]
        lean: f64,
    },
}

const ON_TRACK: &str = "radius of the wheel path used for the centre of mass";
const UPRIGHT_COUPLE: &str = "gyroscopic couple of the upright vehicle used, not reduced by cos θ";

register!(TwoWheelerLean);

impl Analysis for TwoWheelerLean {
    const ABOUT: About = About {
        id: "rigid-body/two-wheeler-lean",
        title: "Lean of a two-wheeler in a turn",
        topic: "Gyroscopes and vehicles",
        summary: "Lean angle of a motorcycle in a turn, with the gyroscopic couples of wheels and engine, the required friction, and the speed for a given lean.",
        main: &["lean", "speed"],
        keywords: "motorcycle bicycle lean heel gyroscopic motocicleta bicicleta inclinação curva giroscópico duas rodas",
        sources: &[&KHURMI, &BEER],
        cases: include_str!("../../cases/two_wheeler_lean.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TwoWheelerLeanGiven<W>, sheet: W) -> Result<(), Refusal> {
        let wheels = given.wheel_inertia * 2.0;
        let rotors = match (&self.engine, &given.engine) {
            (Some(engine), Some(given_engine)) => {
                let share = given_engine.inertia * given_engine.ratio;
                if engine.sense == Sense::Like { wheels + share } else { wheels - share }
            }
            _ => wheels,
        };
        if let (Some(engine), Some(given_engine)) = (&self.engine, &given.engine) {
            let squared = || {
                let share = given_engine.inertia * given_engine.ratio.powi(2);
                if engine.sense == Sense::Like { wheels + share } else { wheels - share }
            };
            let what = "gear ratio squared, as for the moment of inertia referred by kinetic energy";
            sheet.common_error("I", what, squared);
        }
        let inertia = sheet.step(
            "I",
            "kg*m^2",
            rotors,
            (
                "Rotating parts, referred to the wheel speed: their angular momentum is I v/r",
                KHURMI.at("§14.10"),
            ),
        );
        let (speed, lean) = match given.motion {
            KnownMotionGiven::Speed { speed } => (speed, self.lean(given, inertia, speed, sheet)?),
            KnownMotionGiven::Lean { lean } => (self.speed(given, inertia, lean, sheet)?, lean),
        };
        let rate = sheet.step("Ω", "rad/s", speed / given.radius, "Angular velocity of the turn");
        let path = match self.measured {
            Measured::CentreOfMass => given.radius,
            Measured::Track => sheet.step(
                "R_G",
                "m",
                given.radius - given.centre_height * lean.sin(),
                "Radius of the circle of the centre of mass",
            ),
        };
        let gyroscopic = sheet.step(
            "C_g",
            "N*m",
            inertia * (speed / given.wheel_radius) * rate * lean.cos(),
            ("Gyroscopic couple, which tends to right the vehicle", KHURMI.at("§14.10")),
        );
        let own = given.inertia_difference.map(|difference| {
            sheet.step(
                "C_J",
                "N*m",
                difference * rate.powi(2) * lean.sin() * lean.cos(),
                (
                    "Couple due to the turning of the leaning vehicle itself, as for a rotor without spin",
                    BEER.at("§18.2"),
                ),
            )
        });
        let centrifugal = sheet.step(
            "C_c",
            "N*m",
            given.mass * rate.powi(2) * path * given.centre_height * lean.cos(),
            ("Moment of the centrifugal force about the line of contact", KHURMI.at("§14.10")),
        );
        let weight = sheet.step(
            "C_w",
            "N*m",
            given.mass * given.gravity * given.centre_height * lean.sin(),
            ("Moment of the weight, which balances both", KHURMI.at("§14.10")),
        );
        let plain = sheet.step(
            "θ₀",
            "deg",
            (rate.powi(2) * path / given.gravity).atan2(W::Num::from(1.0)),
            "Lean angle of a vehicle without rotating parts on the same circle",
        );
        let what = "tangent of the lean angle taken as the friction required";
        sheet.common_error("µ₀", what, || lean.tan());
        let needed = sheet.step(
            "µ₀",
            "1",
            rate.powi(2) * path / given.gravity,
            "Required friction of the tyres: ratio of centripetal force to weight, independent of the lean",
        );
        sheet.answer("gyroscopic_couple", "Gyroscopic couple", gyroscopic);
        if let Some(own) = own {
            sheet.answer("own_couple", "Couple due to the turning of the leaning vehicle itself", own);
        }
        sheet.answer("centrifugal_couple", "Moment of the centrifugal force", centrifugal);
        sheet.answer("weight_couple", "Moment of the weight", weight);
        sheet.answer("lean_without_rotors", "Lean angle without the gyroscopic couples", plain);
        sheet.answer("friction_needed", "Required friction coefficient of the tyres", needed);
        if let Some(friction) = given.friction {
            if needed.value() > friction.value() {
                sheet.warn(|| {
                    Text::new("the tyres slide: required friction coefficient {needed}, available {friction}")
                        .with_quantity("needed", needed.value(), "1")
                        .with_quantity("friction", friction.value(), "1")
                });
            }
            if self.measured == Measured::Track {
                let on_track = || (friction * given.gravity * given.radius).sqrt();
                sheet.common_error("v_s", ON_TRACK, on_track);
            }
            let sliding = sheet.step(
                "v_s",
                "m/s",
                (friction * given.gravity * path).sqrt() * given.radius / path,
                "Speed at which the tyres slide on that circle",
            );
            sheet.answer("sliding_speed", "Speed at which the tyres slide", sliding);
            sheet.verify(|| {
                let place = |t: f64| {
                    let (sin, cos) = (sliding.value() / self.radius * t).sin_cos();
                    Vector3::new(cos, sin, 0.0) * path.value()
                };
                let Some(acceleration) = second_rate(place, TAU * self.radius / sliding.value()) else {
                    return;
                };
                let what =
                    "acceleration of the centre of mass at that speed, by finite differences of its position";
                sheet.check(what, friction * given.gravity, acceleration.norm().into());
            });
        }
        sheet.verify(|| {
            let own = own.unwrap_or_else(|| 0.0.into());
            let outwards = centrifugal + gyroscopic + own;
            let size =
                weight.value().abs() + centrifugal.value() + gyroscopic.value().abs() + own.value().abs();
            sheet.check_zero("the couples about the line of contact balance", weight - outwards, size);
            let per_mass = rate.powi(2) * path;
            sheet.check_sum(
                "weight and centrifugal force balance at the lean without rotating parts",
                given.gravity * plain.sin(),
                per_mass * plain.cos(),
                self.gravity + per_mass.value().abs(),
            );
            let spin = inertia.value() * speed.value() / self.wheel_radius;
            self.check_by_rotation(spin, rate.value(), lean.value(), (gyroscopic + own).value(), sheet);
        });
        let (inertia, lean, speed) = (inertia.value(), lean.value(), speed.value());
        sheet.show(|| Exhibit::Plot(self.lean_over_speed(inertia, (speed, lean))));
        sheet.show(|| Exhibit::Drawing(self.rear_view(lean)));
        Ok(())
    }
}

impl TwoWheelerLean {
    /// The lean at a speed: closed where the radius reaches to the centre of mass, searched for where it reaches to the
    /// track, for the lean then changes the circle.
    fn lean<W: Worksheet>(
        &self,
        given: &TwoWheelerLeanGiven<W>,
        inertia: W::Num,
        speed: W::Num,
        sheet: W,
    ) -> Result<W::Num, Refusal> {
        let lean = match (self.measured, self.inertia_difference) {
            (Measured::CentreOfMass, None) => {
                let tangent = sheet.step(
                    "t",
                    "1",
                    speed.powi(2) / (given.gravity * given.radius)
                        * (inertia / (given.mass * given.wheel_radius * given.centre_height) + 1.0),
                    ("Tangent of the lean: m g h sin θ = (m v² h/R + I v²/(r R)) cos θ", KHURMI.at("§14.10")),
                );
                let upright = || {
                    let ratio = speed.powi(2) / (given.gravity * given.radius);
                    let slant = (ratio.powi(2) + 1.0).sqrt();
                    ratio.atan2(W::Num::from(1.0)) + ((tangent - ratio) / slant).asin()
                };
                sheet.common_error("θ", UPRIGHT_COUPLE, upright);
                sheet.common_error("θ", "small lean assumed: tan θ replaced by θ", || tangent);
                sheet.step("θ", "deg", tangent.atan2(W::Num::from(1.0)), "Lean angle from the vertical")
            }
            (measured, _) => {
                if measured == Measured::Track && self.radius <= self.centre_height {
                    return Err(Refusal::because(
                        "the radius of the wheel path must be above the height of the centre of mass, which would otherwise lean over the centre of the turn",
                    ));
                }
                let square = speed.value().powi(2);
                let excess =
                    |lean: f64| lean.sin() - lean.cos() * self.tangent(inertia.value(), square, lean);
                // Backward only where the engine turns hard against the wheels.
                let found = roots::find(excess, [-FRAC_PI_2, FRAC_PI_2], |_| ControlFlow::Continue(()))
                    .map_err(|_| {
                        Refusal::because(
                            "no lean balances the couples: the speed is too high for this radius",
                        )
                    })?;
                if self.inertia_difference.is_none() {
                    let plain = || {
                        let gyroscopic = inertia / (given.mass * given.wheel_radius * given.centre_height);
                        let tangent = speed.powi(2) / (given.gravity * given.radius) * (gyroscopic + 1.0);
                        tangent.atan2(W::Num::from(1.0))
                    };
                    sheet.common_error("θ", ON_TRACK, plain);
                }
                sheet.numerical(
                    "θ",
                    "deg",
                    found,
                    "Lean angle from the vertical, found numerically: the couples to be balanced depend on the lean itself",
                )
            }
        };
        sheet.answer("lean", "Lean angle from the vertical", lean);
        Ok(lean)
    }

    /// Required value of tan θ at a square of the speed, on the circle at this lean.
    fn tangent(&self, inertia: f64, square: f64, lean: f64) -> f64 {
        let path = match self.measured {
            Measured::CentreOfMass => self.radius,
            Measured::Track => self.radius - self.centre_height * lean.sin(),
        };
        let centrifugal = path / self.radius.powi(2);
        let per_moment = 1.0 / (self.mass * self.centre_height);
        let gyroscopic = inertia * per_moment / (self.wheel_radius * self.radius);
        let own = self.inertia_difference.unwrap_or(0.0) * per_moment * lean.sin() / self.radius.powi(2);
        square / self.gravity * (centrifugal + gyroscopic + own)
    }

    /// The speed at a lean, in closed form.
    fn speed<W: Worksheet>(
        &self,
        given: &TwoWheelerLeanGiven<W>,
        inertia: W::Num,
        lean: W::Num,
        sheet: W,
    ) -> Result<W::Num, Refusal> {
        let path = match self.measured {
            Measured::CentreOfMass => given.radius,
            Measured::Track => given.radius - given.centre_height * lean.sin(),
        };
        if path.value() <= 0.0 {
            return Err(Refusal::because(
                "at that lean the centre of mass is over the centre of the turn: write a larger radius",
            ));
        }
        let couples = given.mass * given.centre_height * path / given.radius.powi(2)
            + inertia / (given.wheel_radius * given.radius);
        let couples = match given.inertia_difference {
            Some(difference) => couples + difference * lean.sin() / given.radius.powi(2),
            None => couples,
        };
        let moment = || given.mass * given.gravity * given.centre_height;
        if self.measured == Measured::Track {
            let more = || given.mass * given.centre_height * (given.radius - path) / given.radius.powi(2);
            let on_track = || moment() * lean.tan() / (couples + more());
            sheet.common_error("q", ON_TRACK, on_track);
        }
        let spin = || inertia / (given.wheel_radius * given.radius);
        let upright = || moment() * lean.sin() / ((couples - spin()) * lean.cos() + spin());
        sheet.common_error("q", UPRIGHT_COUPLE, upright);
        let square = sheet.step(
            "q",
            "m^2/s^2",
            given.mass * given.gravity * given.centre_height * lean.tan() / couples,
            (
                "Square of the speed: m g h sin θ = (m Ω² R_G h + I v Ω/r) cos θ with Ω = v/R",
                KHURMI.at("§14.10"),
            ),
        );
        if square.value() < 0.0 {
            return Err(Refusal::because(
                "the angular momentum of the engine opposes that of the wheels so strongly that the vehicle would lean outwards: no speed gives that lean",
            ));
        }
        let speed = sheet.step("v", "m/s", square.sqrt(), "Speed for that lean");
        sheet.answer("speed", "Speed for that lean", speed);
        Ok(speed)
    }

    /// A second method to the couples of wheels, engine and vehicle: the difference quotient of the angular momentum about
    /// G. In a turn to the left the axles point left and down, x points forward.
    fn check_by_rotation<W: Worksheet>(&self, spin: f64, rate: f64, lean: f64, couple: f64, sheet: W) {
        let (sin, cos) = lean.sin_cos();
        let (across, upright) = (Vector3::new(0.0, cos, -sin), Vector3::new(0.0, sin, cos));
        let difference = self.inertia_difference.unwrap_or(0.0);
        let tensor = upright * upright.transpose() * difference;
        let about = Vector3::z() * rate;
        let momentum_at = |t: f64| {
            let vehicle = Rotation3::from_scaled_axis(about * t);
            rigid::turned(&tensor, &vehicle) * about + vehicle * across * spin
        };
        let period = if rate > 0.0 { TAU / rate } else { 1.0 };
        let Ok(derivative) = rigid::numerical_rate(momentum_at, period) else { return };
        sheet.check_zero(
            "the gyroscopic couples from the difference quotient of the angular momentum",
            W::Num::from(-derivative.x - couple),
            (spin.abs() + difference.abs() * rate) * TAU / period,
        );
    }

    /// Lean against speed, with and without turning parts: the speed is closed in the lean.
    fn lean_over_speed(&self, inertia: f64, here: (f64, f64)) -> Plot {
        // Without turning parts the vehicle itself is taken as one that does not turn.
        let without = Self { inertia_difference: None, ..self.clone() };
        let curve = |this: &Self, inertia: f64| -> Vec<(f64, f64)> {
            (0..=140)
                .map(|n| f64::from(n) * 0.01)
                .map(|lean: f64| ((lean.tan() / this.tangent(inertia, 1.0, lean)).sqrt(), lean))
                .filter(|(speed, _)| speed.is_finite())
                .collect()
        };
        Plot::new(
            "Lean angle against speed",
            Axis::linear("speed", "km/h"),
            Axis::linear("lean", "deg"),
            vec![
                Series::line("with wheels and engine", curve(self, inertia)).of("lean"),
                Series::line("without wheels and engine", curve(&without, 0.0)).of("lean_without_rotors"),
            ],
        )
        .over("motion.speed.speed")
        .mark("here", here)
    }

    /// The vehicle from behind: a wheel, the handlebar above it, the centre of mass, the lean, and the centre of the turn at the
    /// right.
    fn rear_view(&self, lean: f64) -> Drawing {
        let (sin, cos) = lean.sin_cos();
        let size = self.centre_height.max(2.0 * self.wheel_radius);
        let (height, wheel) = (self.centre_height / size, 2.0 * self.wheel_radius / size);
        let at = |up: f64, across: f64| (up * sin + across * cos, up * cos - across * sin);
        let centre = at(height, 0.0);
        let pull = 0.5 * lean.tan().min(2.0);
        let bar = 1.15 * height.max(wheel);
        let tyre: Vec<_> = (0..16)
            .map(|n| {
                let (across, up) = (TAU * f64::from(n) / 16.0).sin_cos();
                at(wheel / 2.0 * (1.0 - up), 0.06 * across)
            })
            .collect();
        // The centre of the turn is drawn as near as it finds room.
        let (axis, from) = (1.3, if matches!(self.measured, Measured::Track) { (0.0, 0.0) } else { centre });
        let mut sketch = Sketch::new("From behind, in a turn to the right (R is not to scale)");
        sketch
            .ground((-0.8, 0.0), (1.5, 0.0))
            .axis((0.0, 0.0), (0.0, 1.3))
            .axis((axis, 0.0), (axis, 1.3))
            .axis(at(0.0, 0.0), at(1.2, 0.0))
            .body("", tyre)
            .bars([at(wheel, 0.0), at(bar, 0.0)])
            .bars([at(bar, -0.2), at(bar, 0.2)])
            .dimension("r", at(0.0, 0.0), at(wheel / 2.0, 0.0), -2.0)
            .label("I_w", at(0.75 * wheel, 0.05))
            .dimension("h", at(0.0, 0.0), centre, 3.0)
            .dimension("R", (from.0, from.1), (axis, from.1), if from.1 == 0.0 { 2.0 } else { 0.0 })
            .force("m g", centre, (centre.0, centre.1 - 0.45))
            .force("m Ω² R_G", centre, (centre.0 - pull, centre.1))
            .mass_centre("G", centre)
            .arc((0.0, 0.0), 0.75, (FRAC_PI_2 - lean.max(0.0), FRAC_PI_2 - lean.min(0.0)), Ink::Faint)
            .label("θ", (0.75 * (lean / 2.0).sin(), 0.75 * (lean / 2.0).cos()));
        if self.engine.is_some() {
            let engine = at(f64::midpoint(wheel, height), 0.0);
            sketch.round("I_e", engine, 0.06, Ink::Body);
        }
        if self.inertia_difference.is_some() {
            sketch.label("J", at(1.1 * height, 0.0));
        }
        into_page(&mut sketch, "v", at(1.2, 0.0), 0.05);
        sketch.finish()
    }
}
