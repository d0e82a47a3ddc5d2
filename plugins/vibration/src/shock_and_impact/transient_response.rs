//! One degree of freedom under a load that begins at a moment: a step, a ramp, a pulse, a table, an impulse.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::transient::{Extreme, OscillatorState, TransientError, TransientOutput},
};

mod model;
mod stress;
mod superposition;

use self::{
    model::LoadModel,
    superposition::{Instant, Superposition},
};
use crate::{
    shared::{
        free_motion::{DampedOscillator, system_of_body},
        load::{AccelerationPoint, LoadHistory},
        oscillator::{
            Elasticity, SpringData,
            motion::OscillatorMotion,
            parts::{BodyDamping, BodySprings, OscillatingBody, motion_of},
            plots,
        },
        spring::sketch::carrying,
    },
    sources::{CHOPRA, RAO, THOMSON},
};

/// The oscillator, what moves it, and when it is examined.
#[derive(Clone, Debug, Inputs)]
pub struct TransientResponse {
    /// Mass or moment of inertia.
    /// Required only for a force or torque on it, or if the stiffness is given instead of a frequency.
    pub mass: Option<OscillatingBody>,
    /// Springs.
    pub elasticity: BodySprings,
    /// Damping.
    pub damping: BodyDamping,
    /// Excitation.
    /// From rest, unless an initial motion is specified.
    pub excitation: Excitation,
    /// Times.
    /// The displacement is computed at each of them.
    #[input("t", "s", nonnegative)]
    pub times: Vec<f64>,
    /// Distance of the extreme fibre.
    /// From the neutral axis. If the spring is a beam, its maximum bending stress is also computed.
    #[input("c_f", "m", positive)]
    pub fibre: Option<f64>,
}

/// Excitation of the mass.
#[derive(Clone, Debug, Inputs)]
pub enum Excitation {
    /// Force on the mass
    Force {
        /// Magnitude.
        size: ForceSize,
        /// Time history.
        course: LoadHistory,
    },
    /// Force on the mass from a table
    /// Linear between the points, zero before the first and after the last.
    ForceTable {
        /// Points.
        /// Increasing times; two points at the same time define a step.
        #[input(table)]
        points: Vec<ForcePoint>,
    },
    /// Impulse on the mass
    Impulse {
        /// Impulse.
        #[input("I", "N*s", positive)]
        impulse: f64,
    },
    /// Acceleration of the base
    /// The displacement is that relative to the base.
    BaseAcceleration {
        /// Maximum acceleration.
        #[input("a₀", "m/s^2", positive)]
        acceleration: f64,
        /// Time history.
        course: LoadHistory,
    },
    /// Acceleration of the base by a table
    /// Straight between the points, zero before the first and after the last. The displacement is relative to the
    /// base.
    BaseTable {
        /// Points.
        /// Increasing times; two points at the same time define a step.
        #[input(table)]
        points: Vec<AccelerationPoint>,
    },
    /// Initial motion
    Initial {
        /// Initial displacement.
        #[input("x₀", "m", default = "0 m")]
        displacement: f64,
        /// Initial velocity.
        #[input("v₀", "m/s", default = "0 m/s")]
        velocity: f64,
    },
    /// Torque on the body
    /// For a rotation.
    Torque {
        /// Magnitude.
        size: TorqueSize,
        /// Time history.
        course: LoadHistory,
    },
    /// Torque on the body from a table
    /// Linear between the points, zero before the first and after the last.
    TorqueTable {
        /// Points.
        /// Increasing times; two points at the same time define a step.
        #[input(table)]
        points: Vec<TorquePoint>,
    },
    /// Angular impulse on the body
    /// For a rotation.
    AngularImpulse {
        /// Angular impulse.
        #[input("I", "N*m*s", positive)]
        impulse: f64,
    },
    /// Angular acceleration of the base
    /// For a rotation. The angle is that relative to the base.
    BaseRotation {
        /// Maximum angular acceleration.
        #[input("α₀", "rad/s^2", positive)]
        acceleration: f64,
        /// Time history.
        course: LoadHistory,
    },
    /// Initial rotation
    InitialRotation {
        /// Initial angle.
        #[input("θ₀", "rad", default = "0 rad")]
        angle: f64,
        /// Initial angular velocity.
        #[input("Ω₀", "rad/s", default = "0 rad/s")]
        rate: f64,
    },
}

/// Magnitude of a force.
#[derive(Clone, Debug, Inputs)]
pub enum ForceSize {
    /// Maximum force given
    Largest {
        /// Maximum force.
        #[input("F₀", "N", positive)]
        force: f64,
    },
    /// Impulse of the whole pulse given
    Impulse {
        /// Impulse.
        /// The area under the force.
        #[input("I", "N*s", positive)]
        impulse: f64,
    },
}

/// Magnitude of a torque.
#[derive(Clone, Debug, Inputs)]
pub enum TorqueSize {
    /// Maximum torque given
    Largest {
        /// Maximum torque.
        #[input("T₀", "N*m", positive)]
        torque: f64,
    },
    /// Angular impulse of the whole pulse given
    Impulse {
        /// Angular impulse.
        /// The area under the torque.
        #[input("I", "N*m*s", positive)]
        impulse: f64,
    },
}

/// A point of a torque in time.
#[derive(Clone, Debug, Inputs)]
pub struct TorquePoint {
    /// Time.
    #[input("t", "s", nonnegative)]
    pub time: f64,
    /// Torque.
    #[input("T", "N*m")]
    pub torque: f64,
}

/// A point of a force in time.
#[derive(Clone, Debug, Inputs)]
pub struct ForcePoint {
    /// Time.
    #[input("t", "s", nonnegative)]
    pub time: f64,
    /// Force.
    #[input("F", "N")]
    pub force: f64,
}

register!(TransientResponse);

impl Analysis for TransientResponse {
    const ABOUT: About = About {
        id: "vibration/transient-response",
        title: "Transient response",
        topic: "Shock and impact",
        summary: "Displacement time history, its maximum and the residual response, of one degree of freedom under a step, ramp, pulse, table, impulse or base acceleration.",
        main: &["maximum", "time_of_maximum", "displacement"],
        keywords: "step ramp pulse impulse half-sine triangular rectangular shock Duhamel convolution dynamic \
                   load factor overshoot degrau rampa pulso impulso choque transitório resposta transiente \
                   convolução fator de amplificação dinâmica sobressinal semi-senoidal meia-onda senoidal",
        sources: &[&RAO, &THOMSON, &CHOPRA],
        cases: include_str!("../../cases/transient_response.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TransientResponseGiven<W>, sheet: W) -> Result<(), Refusal> {
        let TransientResponseGiven { mass, elasticity, damping, .. } = given;
        let motion = motion_of(mass.as_ref(), elasticity, damping, Some(self.excitation.motion()))?;
        let system = system_of_body(motion, mass.as_ref(), elasticity, damping, sheet)?;
        let why = ("Natural period, without damping", RAO.at("§2.2"));
        let period = sheet.step("T", "s", W::Num::from(2.0) * PI / system.natural, why);
        let model = model::model(&self.excitation, &given.excitation, &system, sheet)?;
        let superposition = Superposition::new(&system, &model, sheet);

        sheet.answer("natural_frequency", "Natural frequency", system.natural);
        sheet.answer("period", "Natural period", period);
        sheet.answer("damping_ratio", "Damping ratio", system.ratio);
        if let Some(size) = model.size {
            sheet.answer("static_displacement", motion.of("Static displacement", "Static angle"), size);
        }
        if let Some(duration) = model.duration {
            let ratio = sheet.step("t_d/T", "1", duration / period, "Duration over the natural period");
            sheet.answer("duration_ratio", "Duration over the natural period", ratio);
        }
        for (n, time) in given.times.iter().enumerate() {
            let instant = Instant::output_at(*time, n + 1);
            let x = superposition.displacement(&instant, sheet)?;
            sheet.answer(("displacement", n + 1), motion.of("Displacement at time", "Angle at time"), x);
        }
        let found = match model.motion.extremes(TransientOutput::DISPLACEMENT, [0.0, f64::INFINITY]) {
            Ok(found) => Some(found.farthest()),
            Err(TransientError::Unbounded) => {
                sheet.warn(|| {
                    Text::new(
                        "the load rises without end and the motion with it: there is no largest displacement",
                    )
                });
                None
            }
            Err(err) => return Err(cannot(err)),
        };
        if let Some(largest) = found {
            self.maximum(given, largest, &system, &model, &superposition, sheet)?;
        }
        let last = self.shown(period.value(), &model, found);
        sheet.show(|| Exhibit::Plot(model.plot(motion, last, found, self.is_relative())));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

impl TransientResponse {
    /// The largest displacement and what follows from it.
    fn maximum<W: Worksheet>(
        &self,
        given: &TransientResponseGiven<W>,
        largest: Extreme,
        system: &DampedOscillator<W::Num>,
        model: &LoadModel<W::Num>,
        superposition: &Superposition<W::Num>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let why = "Time of maximum displacement: the first zero of the velocity at which it is reached";
        let angle = match (&self.excitation, self.course()) {
            (_, Some(LoadHistory::Step)) => Some((PI, "half of the undamped natural period taken")),
            (Excitation::Impulse { .. } | Excitation::AngularImpulse { .. }, _) => {
                Some((PI / 2.0, "a quarter of the undamped natural period taken"))
            }
            _ => None,
        };
        if let Some((angle, what)) = angle {
            sheet.common_error("tₘ", what, || W::Num::from(angle) / system.natural);
        }
        let time = sheet.numerical("tₘ", "s", largest.time, why);
        let x = superposition.displacement(&Instant::largest(time), sheet)?;
        let at = model.motion.at(time.value());
        sheet.check_zero(
            "the velocity is zero at the maximum displacement",
            (at.velocity / system.natural.value()).into(),
            superposition.scale(largest.time).max(largest.value.abs()),
        );
        sheet.answer("maximum", system.motion.of("Maximum displacement", "Maximum angle"), x);
        sheet.answer("time_of_maximum", "Time of maximum displacement", time);
        if let Some(size) = model.size {
            let why = ("Maximum displacement over the static one: the dynamic load factor", RAO.at("§4.6"));
            let factor = sheet.step("D", "1", x / size, why);
            sheet.answer("amplification", "Dynamic load factor", factor);
            let mut beyond = None;
            if model.is_held {
                let why = "Excess of the maximum displacement over the final value";
                let overshoot = sheet.step("M_p", "%", (x - size) / size, why);
                sheet.answer("overshoot", "Overshoot", overshoot);
                beyond = Some(overshoot);
            }
            self.closed_form(system, factor, beyond, sheet);
        }
        if let Some(end) = model.end {
            let residual =
                model.motion.extremes(TransientOutput::DISPLACEMENT, [end, f64::INFINITY]).map_err(cannot)?;
            let why = "Maximum displacement after the load, from the free motion starting at its end";
            let left = residual.farthest().value.abs();
            // A pulse of whole periods leaves nothing, and its rounding is no displacement.
            let left = if left > 1e-13 * superposition.scale(end) { left } else { 0.0 };
            let residual =
                sheet.numerical(system.motion.of("x_r", "θ_r"), system.motion.displacement_unit(), left, why);
            sheet.verify(|| {
                if system.ratio.value() == 0.0 {
                    let OscillatorState { displacement, velocity } = model.motion.at(end);
                    sheet.check_sum(
                        "without damping, the residual amplitude is that of the state at the end of the load",
                        residual,
                        (displacement.hypot(velocity / system.natural.value())).into(),
                        superposition.scale(end),
                    );
                }
            });
            let label =
                system.motion.of("Maximum displacement after the load", "Maximum angle after the load");
            sheet.answer("residual", label, residual);
        }
        self.support(system, model, sheet)?;
        if let (Some(fibre), Some(body)) = (given.fibre, system.body) {
            stress::stress(&given.elasticity, fibre, body.stiffness, x, sheet)?;
        }
        Ok(())
    }

    /// Closed forms of the largest displacement, where there is one.
    fn closed_form<W: Worksheet>(
        &self,
        system: &DampedOscillator<W::Num>,
        factor: W::Num,
        overshoot: Option<W::Num>,
        sheet: W,
    ) {
        let ratio = system.ratio.value();
        sheet.verify(|| match self.course() {
            Some(LoadHistory::Step) if ratio < 1.0 => {
                let damped = ((1.0 - ratio) * (1.0 + ratio)).sqrt();
                sheet.check(
                    "dynamic load factor of a step from its closed form, 1 + e^(−πζ/√(1 − ζ²))",
                    factor,
                    (1.0 + (-PI * ratio / damped).exp()).into(),
                );
                if let Some(overshoot) = overshoot {
                    sheet.check_sum(
                        "overshoot of a step response: amplitude ratio after half a cycle of free vibration, e^(−πζ/√(1 − ζ²))",
                        overshoot,
                        (-PI * ratio / damped).exp().into(),
                        1.0,
                    );
                }
            }
            Some(LoadHistory::RampStep { rise }) if ratio == 0.0 => {
                let half = system.natural.value() * rise / 2.0;
                sheet.check(
                    "dynamic load factor of the ramp from its closed form, 1 + |sin(πt_r/T)|/(πt_r/T)",
                    factor,
                    (1.0 + half.sin().abs() / half).into(),
                );
            }
            _ => {}
        });
    }

    /// The largest force on the support, or the largest acceleration of a mass on an excited base.
    fn support<W: Worksheet>(
        &self,
        system: &DampedOscillator<W::Num>,
        model: &LoadModel<W::Num>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let output = TransientOutput::support(system.ratio.value());
        let found = model.motion.extremes(output, [0.0, f64::INFINITY]).map_err(cannot)?.farthest();
        let natural = system.natural.value();
        let state = model.motion.at(found.time);
        let rate = 2.0 * system.ratio.value() * state.velocity / natural;
        let scale = found.value.abs().max(state.displacement.abs()).max(rate.abs());
        let level = |sheet: W| {
            let OscillatorState { displacement, velocity } = model.motion.at(found.time);
            let load = model.motion.load(found.time);
            let slope = 2.0 * system.ratio.value() * velocity / natural;
            let rate = velocity / natural + 2.0 * system.ratio.value() * (load - displacement - slope);
            // A jump of the load may be where the largest value is: there the rate jumps too.
            if found.time > 0.0 && !model.jumps_at(found.time) {
                let scale = found.value.abs() * (1.0 + system.ratio.value());
                sheet.check_zero("its rate is zero at that time", rate.into(), scale.max(load.abs()));
            }
        };
        if self.is_relative() {
            let why = "Maximum acceleration of the mass itself, −2ζωₙż − ωₙ²z, where its rate is zero";
            let (symbol, unit) = system.motion.of(("aₘ", "m/s^2"), ("αₘ", "rad/s^2"));
            let largest = sheet.numerical(symbol, unit, found.value.abs() * natural * natural, why);
            sheet.verify(|| {
                level(sheet);
                if let Some(by_impulses) = model.by_impulses(natural, system.ratio.value(), found.time) {
                    let what = "maximum acceleration, by Duhamel's integral up to its instant";
                    let other = by_impulses.abs() * natural * natural;
                    sheet.check_sum(what, largest, other.into(), scale * natural * natural);
                }
            });
            let label =
                system.motion.of("Maximum absolute acceleration", "Maximum absolute angular acceleration");
            sheet.answer("acceleration", label, largest);
        } else if let Some(body) = system.body {
            let why = system.motion.of(
                "Maximum force of spring and damper on the support, kx + cẋ, where its rate is zero",
                "Maximum torque of spring and damper on the support, k_t θ + c_t θ̇, where its rate is zero",
            );
            let (symbol, unit) = system.motion.of(("F_T", "kN"), ("T_T", "N*m"));
            let largest = sheet.numerical(symbol, unit, found.value.abs() * body.stiffness.value(), why);
            sheet.verify(|| {
                level(sheet);
                if let Some(by_impulses) = model.by_impulses(natural, system.ratio.value(), found.time) {
                    let what = "maximum force on the support, by Duhamel's integral up to its instant";
                    let stiffness = body.stiffness.value();
                    let other = by_impulses.abs() * stiffness;
                    sheet.check_sum(what, largest, other.into(), scale * stiffness);
                }
            });
            let (name, label) = system.motion.of(
                ("support_force", "Maximum force on the support"),
                ("support_torque", "Maximum torque on the support"),
            );
            sheet.answer(name, label, largest);
        }
        Ok(())
    }

    fn course(&self) -> Option<&LoadHistory> {
        match &self.excitation {
            Excitation::Force { course, .. }
            | Excitation::BaseAcceleration { course, .. }
            | Excitation::Torque { course, .. }
            | Excitation::BaseRotation { course, .. } => Some(course),
            _ => None,
        }
    }

    /// Returns true if the displacement is relative to an excited base.
    fn is_relative(&self) -> bool {
        matches!(
            self.excitation,
            Excitation::BaseAcceleration { .. }
                | Excitation::BaseTable { .. }
                | Excitation::BaseRotation { .. }
        )
    }

    /// Until when the motion is shown.
    fn shown<N: Real>(&self, period: f64, model: &LoadModel<N>, found: Option<Extreme>) -> f64 {
        let settled = model.last_change();
        let asked = self.times.iter().copied().fold(0.0, f64::max);
        let reached = found.map_or(0.0, |found| found.time);
        (settled + 2.5 * period).max(1.1 * asked).max(1.2 * reached)
    }

    fn drawing(&self) -> Drawing {
        let body = self.mass.as_ref().map_or_else(|| "m".into(), OscillatingBody::letters);
        let letters = [body.clone(), self.elasticity.letters().into()];
        if self.excitation.motion() == OscillatorMotion::Rotation {
            let torque = match self.excitation {
                Excitation::AngularImpulse { .. } => "I",
                Excitation::BaseRotation { .. } => "α(t)",
                Excitation::InitialRotation { .. } => "θ₀, Ω₀",
                Excitation::Torque { size: TorqueSize::Largest { .. }, .. } => "T(t) ≤ T₀",
                Excitation::Torque { .. } => "T(t), I",
                _ => "T(t)",
            };
            return plots::inertia_spring_damper(torque, letters);
        }
        let mut sketch = match &self.elasticity {
            BodySprings::Any(Elasticity::Springs(SpringData::Springs { springs })) => {
                let mut sketch = Sketch::new("The mass on its springs");
                carrying(springs, &mut sketch);
                sketch.mass(body, (-0.6, -0.4), (0.6, 0.4)).motion("x", (1.0, -0.2), (1.0, 0.5));
                sketch
            }
            _ => {
                let mut sketch = plots::supported("One degree of freedom", letters);
                sketch.ground((-1.0, -1.5), (1.0, -1.5));
                sketch
            }
        };
        if self.fibre.is_some() {
            sketch.label("c_f", (-1.8, -0.5));
        }
        let (tail, head) = ((0.0, 0.4), (0.0, 1.2));
        match self.excitation {
            Excitation::Impulse { .. } => sketch.force("I", tail, head),
            Excitation::BaseAcceleration { .. } => sketch.force("ÿ(t) ≤ a₀", (-1.2, -1.8), (-1.2, -1.0)),
            Excitation::BaseTable { .. } => sketch.force("ÿ(t)", (-1.2, -1.8), (-1.2, -1.0)),
            Excitation::Initial { .. } => sketch.motion("x₀, v₀", tail, head),
            Excitation::Force { size: ForceSize::Largest { .. }, .. } => {
                sketch.force("F(t) ≤ F₀", tail, head)
            }
            Excitation::Force { .. } => sketch.force("F(t), I", tail, head),
            _ => sketch.force("F(t)", tail, head),
        };
        sketch.finish()
    }
}

impl Excitation {
    /// The motion that it is of.
    fn motion(&self) -> OscillatorMotion {
        match self {
            Excitation::Torque { .. }
            | Excitation::TorqueTable { .. }
            | Excitation::AngularImpulse { .. }
            | Excitation::BaseRotation { .. }
            | Excitation::InitialRotation { .. } => OscillatorMotion::Rotation,
            _ => OscillatorMotion::Translation,
        }
    }
}

/// The words for a motion that cannot be computed.
fn cannot(err: TransientError) -> Refusal {
    match err {
        TransientError::Order { .. } => {
            Refusal::because("the times of the table must begin at zero or later and ascend: sort its rows")
        }
        _ => Refusal::because(
            "these numbers are too large or too small for the motion to be computed: check their units",
        ),
    }
}

impl<N: Real> LoadModel<N> {
    /// Displacement and load in time.
    fn plot(&self, of: OscillatorMotion, last: f64, found: Option<Extreme>, relative: bool) -> Plot {
        let time = |n: u16| last * f64::from(n) / 480.0;
        let motion = (0..=480).map(|n| (time(n), self.motion.at(time(n)).displacement)).collect();
        let label = if relative {
            of.of("relative displacement", "relative angle")
        } else {
            of.of("displacement", "angle")
        };
        let mut series = vec![Series::line(label, motion).of("displacement[1]")];
        if self.size.is_some() || self.end.is_some() {
            let load = (0..=480).map(|n| (time(n), self.motion.load(time(n)))).collect();
            series.push(Series::line(
                of.of("static displacement under the load", "static angle under the torque"),
                load,
            ));
        }
        let plot = Plot::new(
            of.of("Displacement time history", "Angle time history"),
            Axis::linear("time", "s"),
            Axis::linear(of.of("displacement", "angle"), of.displacement_unit()),
            series,
        )
        .over("times[1]");
        match found {
            Some(found) => plot.mark("largest", (found.time, found.value)),
            None => plot,
        }
    }
}
