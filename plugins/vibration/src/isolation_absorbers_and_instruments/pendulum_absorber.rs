//! Pendulums that hold a rotor or an oscillating mass still.

use dalembert_core::{About, Analysis, Exhibit, Inputs, Plot, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{Real, vibration::pendulum_absorber::tuned_order};

mod coupled;
mod exhibits;
mod gravity;

use self::coupled::BodyWithPendulum;
use crate::{
    shared::inertia::{self, Inertia},
    sources::{DEN_HARTOG, KER_WILSON},
};

/// Inputs of a pendulum absorber.
#[derive(Clone, Debug, Inputs)]
pub struct PendulumAbsorber {
    /// Support of the pendulum.
    pub problem: PendulumCarrier,
}

/// Body on which the pendulum hangs.
#[derive(Clone, Debug, Inputs)]
pub enum PendulumCarrier {
    /// On a rotor
    /// The centrifugal field restores the pendulum, so its frequency is proportional to the speed.
    Rotor {
        /// Pendulum.
        pendulum: Pendulum,
        /// Distance of the pivot from the shaft.
        /// For rollers, measured to the centre of the hole.
        #[input("R", "m", positive)]
        pivot: f64,
        /// Arm.
        arm: Arm,
        /// Mass of a pendulum.
        mass: PendulumMass,
        /// Pendulums.
        #[input(min = 1, max = 100, default = "1")]
        count: u32,
        /// Inertia of the rotor.
        /// Without the pendulums.
        inertia: Inertia,
        /// Stiffness of the shaft supporting the rotor.
        /// Omit for a rotor that turns freely.
        #[input("k", "N*m/rad", positive)]
        stiffness: Option<f64>,
        /// Speed.
        #[input("Ω", "rpm", positive)]
        speed: f64,
        /// Order of the torque.
        /// If omitted, it is the tuned order.
        #[input("n", "1", positive)]
        order: Option<f64>,
        /// Amplitude of the torque.
        #[input("T", "N*m", positive)]
        torque: Option<f64>,
    },
    /// Suspended from an oscillating mass
    /// Gravity is the restoring force of the pendulum; the mass moves sideways.
    Gravity {
        /// Oscillating mass.
        #[input("M", "kg", positive)]
        body: f64,
        /// Stiffness of its springs.
        #[input("k", "N/m", positive)]
        stiffness: f64,
        /// Frequency of the force.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
        /// Amplitude of the force.
        #[input("F₀", "N", positive)]
        force: Option<f64>,
        /// Length of the pendulum.
        length: Length,
        /// Mass of the pendulum.
        mass: PendulumMass,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// The kind of pendulum.
#[derive(Clone, Debug, Inputs)]
pub enum Pendulum {
    /// Small mass on an arm
    Point,
    /// Body on a pivot
    /// It rotates with its arm.
    Body {
        /// Radius of gyration about its centre of mass.
        #[input("κ", "m", positive)]
        gyration: f64,
    },
    /// Bifilar: on two pins in larger holes
    /// It does not rotate relative to the rotor; the arm is the hole diameter minus the pin diameter.
    Bifilar,
    /// Roller in a hole
    /// It rolls without slipping; the arm is the hole radius minus the roller radius.
    Roller {
        /// Radius of the roller.
        #[input("a", "m", positive)]
        radius: f64,
        /// Shape.
        shape: Roller,
    },
}

/// The shape of a roller.
#[derive(Clone, Debug, Inputs)]
pub enum Roller {
    /// Solid cylinder
    Solid,
    /// Ring
    Ring,
}

/// Arm of the pivot, or the tuning that determines it.
#[derive(Clone, Debug, Inputs)]
pub enum Arm {
    /// Arm given
    Given {
        /// Arm.
        /// From the pivot to the centre of mass.
        #[input("r", "m", positive)]
        arm: f64,
    },
    /// Order to tune to
    Tuned {
        /// Order.
        /// Vibrations per revolution to be absorbed by the pendulum.
        #[input("n_t", "1", positive)]
        order: f64,
    },
}

/// Length of a pendulum under gravity, or its tuning.
#[derive(Clone, Debug, Inputs)]
pub enum Length {
    /// Length given
    Given {
        /// Length.
        #[input("l", "m", positive)]
        length: f64,
        /// Radius of gyration about its centre of mass.
        /// Omit for a small mass on a string.
        #[input("κ", "m", positive)]
        gyration: Option<f64>,
    },
    /// Tuned to the force
    /// A small mass on a string.
    Tuned,
}

/// Mass of a pendulum, or the requirement that determines it.
#[derive(Clone, Debug, Inputs)]
pub enum PendulumMass {
    /// Mass given
    Given {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
    /// Limited swing angle
    /// The lightest pendulum that does not exceed this amplitude under the load it absorbs.
    Swing {
        /// Maximum swing angle.
        #[input("φ_a", "deg", positive, below = 60)]
        swing: f64,
    },
}

/// Common error of the tuning.
const FROM_CENTRE: &str =
    "the distance of the pendulum mass from the shaft used in place of that of the pivot";

register!(PendulumAbsorber);

impl Analysis for PendulumAbsorber {
    const ABOUT: About = About {
        id: "vibration/pendulum-absorber",
        title: "Pendulum absorber",
        topic: "Isolation, absorbers and instruments",
        summary: "Order, arm and mass of centrifugal pendulums and rollers on a rotor, their swing and effective inertia, and pendulums under an oscillating mass.",
        main: &["length", "mass", "tuned_order", "antiresonance", "rotor_amplitude"],
        keywords: "centrifugal pendulum CPVA bifilar Salomon roller order tuning torsional absorber antiresonance \
                   absorvedor pendular pêndulo centrífugo bifilar rolete ordem sintonia antirressonância",
        sources: &[&DEN_HARTOG, &KER_WILSON],
        cases: include_str!("../../cases/pendulum_absorber.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &PendulumAbsorberGiven<W>, sheet: W) -> Result<(), Refusal> {
        match &given.problem {
            PendulumCarrierGiven::Rotor { .. } => self.on_rotor(given, sheet),
            PendulumCarrierGiven::Gravity { body, stiffness, frequency, force, length, mass, gravity } => {
                gravity::MassWithPendulum {
                    body: *body,
                    stiffness: *stiffness,
                    frequency: *frequency,
                    force: *force,
                    gravity: *gravity,
                }
                .solve(length, mass, sheet)
            }
        }
    }
}

impl PendulumAbsorber {
    fn on_rotor<W: Worksheet>(&self, given: &PendulumAbsorberGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (
            PendulumCarrierGiven::Rotor {
                pendulum,
                pivot,
                arm,
                mass,
                inertia,
                stiffness,
                speed,
                order,
                torque,
                ..
            },
            PendulumCarrier::Rotor { pendulum: kind, count, .. },
        ) = (&given.problem, &self.problem)
        else {
            return Ok(());
        };
        let (pivot, speed, count) = (*pivot, *speed, f64::from(*count));
        let limit = if let PendulumMassGiven::Swing { swing } = mass { Some(*swing) } else { None };
        let rotor = inertia::moment_of_inertia(inertia, sheet, "J".into());
        // Radius of gyration of a roller, and what of it swings: κ²/a² for each r².
        let (gyration, rolling) = match (pendulum, kind) {
            (PendulumGiven::Body { gyration }, _) => (Some(*gyration), None),
            (PendulumGiven::Roller { radius, .. }, Pendulum::Roller { shape, .. }) => {
                let (share, why) = match shape {
                    Roller::Solid => {
                        (0.5, "Square of the radius of gyration of a solid roller over that of its radius")
                    }
                    Roller::Ring => {
                        (1.0, "Square of the radius of gyration of a ring over that of its radius")
                    }
                };
                let share = sheet.numerical("q", "1", share, why);
                let gyration =
                    sheet.step("κ", "m", *radius * share.sqrt(), "Radius of gyration of the roller");
                (Some(gyration), Some((share, *radius)))
            }
            _ => (None, None),
        };
        let (arm, wanted) = match arm {
            ArmGiven::Given { arm } => (*arm, None),
            ArmGiven::Tuned { order } => {
                if gyration.is_some() {
                    let point = || pivot / order.powi(2);
                    sheet.common_error("r", "the pendulum taken as a point mass", point);
                } else {
                    let centre = || pivot / (order.powi(2) - 1.0);
                    sheet.common_error("r", FROM_CENTRE, centre);
                }
                let found = match (rolling, gyration) {
                    (Some((share, _)), _) => sheet.step(
                        "r",
                        "mm",
                        pivot / (order.powi(2) * (share + 1.0)),
                        (
                            "Arm that tunes a roller to the order, from n² = R/(r (1 + q))",
                            KER_WILSON.at("vol. 1"),
                        ),
                    ),
                    (None, Some(gyration)) => {
                        let half = sheet.step(
                            "h",
                            "mm",
                            pivot / (order.powi(2) * 2.0),
                            "The arm is a root of r² − 2 h r + κ² = 0, from n² = R r/(r² + κ²), with this h",
                        );
                        if gyration.value() > half.value() {
                            return Err(Refusal::because(
                                "no arm tunes this body to the order: write a smaller radius of gyration or a pivot further out",
                            ));
                        }
                        let why = "The larger root: the shorter arm needs a much larger oscillation";
                        sheet.step("r", "mm", half + (half.powi(2) - gyration.powi(2)).sqrt(), why)
                    }
                    (None, None) => sheet.step(
                        "r",
                        "mm",
                        pivot / order.powi(2),
                        ("Arm that tunes the pendulum to the order, from n² = R/r", DEN_HARTOG.at("ch. 5")),
                    ),
                };
                sheet.answer("arm", "Arm", found);
                (found, Some(*order))
            }
        };
        let swing = match (rolling, gyration) {
            (Some((share, _)), _) => sheet.step(
                "s²",
                "cm^2",
                arm.powi(2) * (share + 1.0),
                "Inertia of the pendulum motion per kilogram: the smaller a roller, the faster it spins",
            ),
            (None, Some(gyration)) => sheet.step(
                "s²",
                "cm^2",
                arm.powi(2) + gyration.powi(2),
                "Inertia of the pendulum motion per kilogram, about the pivot",
            ),
            (None, None) => sheet.step(
                "s²",
                "cm^2",
                arm.powi(2),
                "Inertia of the pendulum motion per kilogram, about the pivot",
            ),
        };
        let coupling = match (rolling, gyration) {
            (Some((share, radius)), _) => sheet.step(
                "c²",
                "cm^2",
                arm * (pivot + arm) - share * radius * arm,
                "Coupling per kilogram: a roller rotates opposite to the pendulum motion of its centre",
            ),
            (None, Some(gyration)) => sheet.step(
                "c²",
                "cm^2",
                arm * (pivot + arm) + gyration.powi(2),
                "Coupling of pendulum motion and rotor per kilogram",
            ),
            (None, None) => sheet.step(
                "c²",
                "cm^2",
                arm * (pivot + arm),
                "Coupling of pendulum motion and rotor per kilogram",
            ),
        };
        if coupling.value() <= 0.0 {
            return Err(Refusal::because(
                "the roller is so large that it rotates against its own swing and absorbs nothing: write a smaller one",
            ));
        }
        sheet.common_error("n₀", FROM_CENTRE, || tuned_order(pivot + arm, arm, swing));
        let tuned = sheet.step(
            "n₀",
            "1",
            tuned_order(pivot, arm, swing),
            ("Tuned order: frequency of the pendulum over the speed, at any speed", DEN_HARTOG.at("ch. 5")),
        );
        sheet.answer("tuned_order", "Tuned order", tuned);
        if let Some(order) = wanted {
            sheet.check(
                "the pendulum frequency in the centrifugal field equals the frequency of the order, n² s² = R r",
                order.powi(2) * swing,
                pivot * arm,
            );
            sheet.check("tuned order of that arm", tuned, order);
        }
        let antiresonance = sheet.step(
            "ω₀",
            "rad/s",
            tuned * speed,
            "Frequency of the pendulum motion at this speed: at this frequency the rotor is at rest",
        );
        sheet.answer("antiresonance", "Frequency at which the rotor is at rest", antiresonance);
        let mass = match mass {
            PendulumMassGiven::Given { mass } => *mass,
            PendulumMassGiven::Swing { swing: limit } => {
                let Some(torque) = torque else {
                    return Err(Refusal::because(
                        "the mass for a limited swing follows from the torque: write its amplitude",
                    ));
                };
                let by_speed = || *torque / (coupling * speed.powi(2) * *limit * count);
                let what = "the speed of the rotor used as the frequency of the pendulum";
                sheet.common_error("m", what, by_speed);
                let uncoupled = || *torque / (swing * antiresonance.powi(2) * *limit * count);
                let what = "the moment of the pendulum about its pivot taken as its torque on the rotor";
                sheet.common_error("m", what, uncoupled);
                let mass = sheet.step(
                    "m",
                    "kg",
                    *torque / (coupling * antiresonance.powi(2) * *limit * count),
                    (
                        "Mass of each pendulum: at its limit angle it absorbs the whole torque of the tuned order",
                        DEN_HARTOG.at("ch. 5"),
                    ),
                );
                sheet.answer("mass", "Mass of a pendulum", mass);
                mass
            }
        };
        let carried = (pivot + arm).powi(2);
        let carried = match gyration {
            Some(gyration) => carried + gyration.powi(2),
            None => carried,
        };
        let together = sheet.step(
            "J₁",
            "kg*m^2",
            rotor + mass * carried * count,
            "Rotor with the pendulums locked to it",
        );
        let coupled = sheet.step(
            "J₁₂",
            "kg*m^2",
            mass * coupling * count,
            "Inertia coupling of rotor and pendulum motion",
        );
        let swinging = sheet.step("J₂", "kg*m^2", mass * swing * count, "Inertia of the pendulum motion");
        if let (Some(limit), Some(torque)) = (limit, torque) {
            sheet.check(
                "with the rotor at rest, the pendulums at their limit balance the torque, J₁₂ ω₀² φ",
                coupled * antiresonance.powi(2) * limit,
                *torque,
            );
        }
        let motion = BodyWithPendulum {
            on_rotor: true,
            body: together,
            coupling: coupled,
            swing: swinging,
            antiresonance,
            held: *stiffness,
        };
        let pair = motion.pair();
        let own = motion.frequencies(sheet);
        for (row, frequency) in own.iter().enumerate() {
            let counted = sheet.step(("f", row + 1), "Hz", *frequency, "The same frequency in Hz");
            sheet.answer(("frequency", row + 1), "Natural frequency of rotor and pendulum", counted);
            let at = sheet.step(
                ("n_r", row + 1),
                "1",
                *frequency / speed,
                "Order that coincides with it at this speed",
            );
            sheet.verify(|| {
                let effective = match stiffness {
                    Some(held) => together - *held / (at * speed).powi(2),
                    None => together,
                };
                let terms = [effective * swinging * (tuned.powi(2) - at.powi(2)), (coupled * at).powi(2)];
                let held = stiffness.map_or(0.0, |held| held.value() / (at * speed).value().powi(2));
                let squares = tuned.value().powi(2) + at.value().powi(2);
                sheet.check_zero(
                    "at that order the inertia of the rotor, the effective inertia of the pendulums and the shaft are in balance",
                    terms[0] + terms[1],
                    (together.value() + held) * swinging.value() * squares + terms[1].value(),
                );
            });
            sheet.answer(("resonant_order", row + 1), "Order that resonates at this speed", at);
        }
        let order = order.unwrap_or(tuned);
        let off = (order.value() / tuned.value() - 1.0).abs() < 1e-12;
        if off {
            sheet.warn(|| {
                Text::new("at the tuned order the pendulum acts like an infinite flywheel; friction alone leaves some motion")
            });
        } else {
            let shift = tuned.powi(2) - order.powi(2);
            let effective = sheet.step(
                "J_e",
                "kg*m^2",
                together - rotor + coupled.powi(2) * order.powi(2) / (swinging * shift),
                (
                    "Effective inertia of the pendulums at the order of the torque; negative beyond the tuned order",
                    DEN_HARTOG.at("ch. 5"),
                ),
            );
            sheet.answer("effective_inertia", "Effective inertia of the pendulums", effective);
            sheet.verify(|| {
                let square = (order.value() * speed.value()).powi(2);
                let follow = pair.coupling * square / (pair.back - pair.swing * square);
                sheet.check(
                    "effective inertia from the pendulum oscillation caused by a moving rotor",
                    W::Num::from(pair.body + pair.coupling * follow - rotor.value()),
                    effective,
                );
            });
        }
        let frequency = sheet.step("ω", "rad/s", order * speed, "Frequency of the torque");
        if let Some(torque) = torque {
            motion.steady(frequency, *torque, sheet)?;
        }
        let view = exhibits::PendulumRotor {
            pair,
            alone: rotor.value(),
            speed: speed.value(),
            tuned: tuned.value(),
            order: order.value(),
            pivot: pivot.value(),
            arm: arm.value(),
        };
        // A mass that a swing tells is another at another order or speed.
        let is_given =
            matches!(self.problem, PendulumCarrier::Rotor { mass: PendulumMass::Given { .. }, .. });
        let over = |plot: Plot, input| Exhibit::Plot(if is_given { plot.over(input) } else { plot });
        sheet.show(|| over(view.effective(), "problem.rotor.order"));
        sheet.show(|| over(view.against_speed(), "problem.rotor.speed"));
        sheet.show(|| Exhibit::Drawing(view.drawing(&self.problem)));
        sheet.show(|| Exhibit::Animation(view.animation()));
        Ok(())
    }
}
