//! Free vibration with dry friction, alone or beside viscous damping.

use dalembert_core::{About, Analysis, Drawing, Exhibit, Inputs, Refusal, Sketch, Worksheet, register};
use dalembert_mechanics::Real;

use crate::{
    shared::{
        decay::DecayCount,
        dry_friction::{FrictionFromDecay, FrictionOscillator, natural_frequency},
        oscillator::{Mass, SpringData, given_weight, mass, motion::OscillatorMotion},
    },
    sources::{GROVER, RAO},
};

/// A mass on a spring that rubs, how it starts, and what is asked of it.
#[derive(Clone, Debug, Inputs)]
pub struct CoulombDamping {
    /// Mass or weight.
    pub mass: Mass,
    /// Springs.
    pub stiffness: SpringData,
    /// Friction.
    pub friction: FrictionForce,
    /// Static friction over kinetic friction.
    #[input("µₛ/µ", "1", min = 1, default = "1")]
    pub static_ratio: f64,
    /// Viscous damping in addition to friction.
    #[input("c", "N*s/m", nonnegative, default = "0 N*s/m")]
    pub damping: f64,
    /// Initial displacement.
    /// From the position in which the spring is unloaded.
    #[input("x₀", "m")]
    pub displacement: f64,
    /// Initial velocity.
    #[input("v₀", "m/s", default = "0 m/s")]
    pub velocity: f64,
    /// Time at which the motion is required.
    #[input("t", "s", nonnegative)]
    pub time: Option<f64>,
    /// Target amplitude of the decay.
    #[input("Xₐ", "m", positive)]
    pub fall: Option<f64>,
}

/// Friction force, or the coefficient that gives it.
#[derive(Clone, Debug, Inputs)]
pub enum FrictionForce {
    /// Friction force given
    Force {
        /// Friction force.
        #[input("F", "N", positive)]
        force: f64,
    },
    /// Coefficient of friction on a horizontal surface
    Coefficient {
        /// Coefficient of friction.
        #[input("µ", "1", positive)]
        coefficient: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Coefficient of friction and normal force
    Normal {
        /// Coefficient of friction.
        #[input("µ", "1", positive)]
        coefficient: f64,
        /// Normal force.
        #[input("N", "N", positive)]
        normal: f64,
    },
    /// From the decrease of the amplitude
    Decay {
        /// First amplitude.
        #[input("X₁", "m", positive)]
        first_amplitude: f64,
        /// Last amplitude.
        #[input("X₂", "m", positive)]
        last_amplitude: f64,
        /// Counted quantity.
        counted: DecayCount,
        /// Gravity.
        /// For the coefficient of friction on a horizontal surface.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

register!(CoulombDamping);

impl Analysis for CoulombDamping {
    const ABOUT: About = About {
        id: "vibration/coulomb-damping",
        title: "Free vibration with dry friction",
        topic: "Free vibration",
        summary: "Amplitude decrease, number of cycles, stopping time and position, and exact motion of a mass with dry friction; friction from a decay.",
        main: &["strokes", "cycles", "stop_time", "rest_position", "friction_coefficient"],
        keywords: "coulomb friction dry damping linear decay rest position stop sliding block atrito seco \
                   amortecimento de coulomb decaimento linear parada",
        sources: &[&RAO, &GROVER],
        cases: include_str!("../../cases/coulomb_damping.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &CoulombDampingGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = mass(&given.mass, sheet);
        let stiffness = given.stiffness.stiffness_under(mass, sheet)?;
        let natural = natural_frequency(stiffness, mass, sheet);
        let force = friction(given, [mass, stiffness], sheet)?;
        let oscillator = FrictionOscillator {
            motion: OscillatorMotion::Translation,
            mass,
            stiffness,
            natural,
            force,
            static_ratio: given.static_ratio,
            damping: given.damping,
            displacement: given.displacement,
            velocity: given.velocity,
            time: given.time,
            fall: given.fall,
        };
        oscillator.solve(sheet)?;
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// The friction force.
fn friction<W: Worksheet>(
    given: &CoulombDampingGiven<W>,
    [mass, stiffness]: [W::Num; 2],
    sheet: W,
) -> Result<W::Num, Refusal> {
    let why = ("Friction force", RAO.at("§2.9"));
    Ok(match &given.friction {
        FrictionForceGiven::Force { force } => *force,
        FrictionForceGiven::Coefficient { coefficient, gravity } => {
            let force = match given_weight(&given.mass, *gravity) {
                Some(weight) => *coefficient * weight,
                None => *coefficient * mass * *gravity,
            };
            sheet.step("F", "N", force, why)
        }
        FrictionForceGiven::Normal { coefficient, normal } => {
            sheet.step("F", "N", *coefficient * *normal, why)
        }
        FrictionForceGiven::Decay { first_amplitude: first, last_amplitude: last, counted, gravity } => {
            let decay =
                FrictionFromDecay { first: *first, last: *last, counted, stiffness, damping: given.damping };
            let (force, cycles) = decay.force(OscillatorMotion::Translation, "F", sheet)?;
            let weight = given_weight(&given.mass, *gravity).unwrap_or_else(|| mass * *gravity);
            let coefficient =
                sheet.step("µ", "1", force / weight, "Coefficient of friction on a horizontal surface");
            sheet.check(
                "the energy difference between the two amplitudes is the friction work over the path",
                stiffness * (first.powi(2) - last.powi(2)) / 2.0,
                coefficient * weight * cycles * (*first + *last) * 2.0,
            );
            sheet.answer("friction_coefficient", "Coefficient of friction", coefficient);
            force
        }
    })
}

impl CoulombDamping {
    /// The mass where it is released, beside the line of its spring at rest.
    fn drawing(&self) -> Drawing {
        let away = 0.7 * if self.displacement < 0.0 { -1.0 } else { 1.0 };
        let mut sketch = Sketch::new("The mass on its spring, with friction");
        sketch
            .ground((-2.8, 1.2), (-2.8, -0.7))
            .ground((-2.8, -0.7), (2.4, -0.7))
            .axis((0.0, -0.7), (0.0, 1.4))
            .spring(self.stiffness.letters(), (-2.8, 0.3), (away - 0.7, 0.3))
            .mass(self.mass.letter(), (away - 0.7, -0.7), (away + 0.7, 0.7))
            .dimension("x₀", (0.0, 1.1), (away, 1.1), 0.0)
            .axis((away, 0.7), (away, 1.3));
        if self.damping > 0.0 {
            sketch.damper("c", (-2.8, -0.3), (away - 0.7, -0.3));
        }
        if self.velocity != 0.0 {
            let (side, along) = (away + 0.7, 0.7 * self.velocity.signum());
            sketch.motion("v₀", (side - along.min(0.0), 0.3), (side - along.min(0.0) + along, 0.3));
        }
        match self.friction {
            FrictionForce::Normal { .. } => {
                sketch.force("N", (away, 1.8), (away, 0.75));
            }
            FrictionForce::Decay { .. } => {
                sketch.label("X₁, X₂", (away, -0.7));
            }
            _ => {}
        }
        let friction = if let FrictionForce::Force { .. } = self.friction { "F" } else { "µN" };
        sketch.force(friction, (away + 1.6, -0.55), (away + 0.75, -0.55)).finish()
    }
}
