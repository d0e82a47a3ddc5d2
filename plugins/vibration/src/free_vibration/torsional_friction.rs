//! Free torsional vibration with dry friction, alone or beside viscous damping.

use dalembert_core::{About, Analysis, Drawing, Exhibit, Ink, Inputs, Refusal, Sketch, Worksheet, register};
use dalembert_mechanics::Real;

use crate::{
    shared::{
        decay::DecayCount,
        dry_friction::{FrictionFromDecay, FrictionOscillator, natural_frequency},
        inertia::{Inertia, moment_of_inertia},
        letters::joined,
        oscillator::motion::OscillatorMotion,
        spring::torsional::{TorsionalSpring, stiffness},
        turning,
    },
    sources::{GROVER, RAO},
};

/// A body on a torsional spring that rubs, how it starts, and what is asked of it.
#[derive(Clone, Debug, Inputs)]
pub struct TorsionalFriction {
    /// Inertia of the body.
    pub inertia: Inertia,
    /// Torsional spring or shaft.
    pub spring: TorsionalSpring,
    /// Friction.
    pub friction: FrictionTorque,
    /// Static friction over kinetic friction.
    #[input("µₛ/µ", "1", min = 1, default = "1")]
    pub static_ratio: f64,
    /// Viscous damping in addition to friction.
    #[input("c_t", "N*m*s/rad", nonnegative, default = "0 N*m*s/rad")]
    pub damping: f64,
    /// Initial angle.
    /// From the position in which the spring is unloaded.
    #[input("θ₀", "rad")]
    pub angle: f64,
    /// Initial angular velocity.
    #[input("Ω₀", "rad/s", default = "0 rad/s")]
    pub rate: f64,
    /// Time at which the motion is required.
    #[input("t", "s", nonnegative)]
    pub time: Option<f64>,
    /// Target amplitude of the decay.
    #[input("Θₐ", "rad", positive)]
    pub fall: Option<f64>,
}

/// Friction torque, or what gives it.
#[derive(Clone, Debug, Inputs)]
pub enum FrictionTorque {
    /// Friction torque given
    Torque {
        /// Friction torque.
        #[input("T_f", "N*m", positive)]
        torque: f64,
    },
    /// Coefficient of friction, normal force and radius
    Brake {
        /// Coefficient of friction.
        #[input("µ", "1", positive)]
        coefficient: f64,
        /// Normal force.
        #[input("N", "N", positive)]
        normal: f64,
        /// Radius at which it rubs.
        #[input("ρ", "m", positive)]
        radius: f64,
    },
    /// From the decrease of the amplitude
    Decay {
        /// First amplitude.
        #[input("A₁", "rad", positive)]
        first_amplitude: f64,
        /// Last amplitude.
        #[input("A₂", "rad", positive)]
        last_amplitude: f64,
        /// Counted quantity.
        counted: DecayCount,
    },
}

register!(TorsionalFriction);

impl Analysis for TorsionalFriction {
    const ABOUT: About = About {
        id: "vibration/torsional-friction",
        title: "Free torsional vibration with dry friction",
        topic: "Free vibration",
        summary: "Amplitude decrease, number of cycles, stopping time and angle, and exact motion of a body on a torsional spring or shaft with a friction torque; friction torque from a decay.",
        main: &["strokes", "cycles", "stop_time", "rest_position"],
        keywords: "coulomb friction dry damping torsional oscillation pulley disc shaft brake friction torque stop \
                   rest position atrito seco amortecimento de coulomb oscilação torcional polia eixo freio torque de \
                   atrito parada",
        sources: &[&RAO, &GROVER],
        cases: include_str!("../../cases/torsional_friction.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TorsionalFrictionGiven<W>, sheet: W) -> Result<(), Refusal> {
        let inertia = moment_of_inertia(&given.inertia, sheet, "J".into());
        let stiffness = stiffness(&given.spring, sheet)?;
        sheet.answer("stiffness", "Torsional stiffness", stiffness);
        let natural = natural_frequency(stiffness, inertia, sheet);
        let oscillator = FrictionOscillator {
            motion: OscillatorMotion::Rotation,
            mass: inertia,
            stiffness,
            natural,
            force: friction(given, stiffness, sheet)?,
            static_ratio: given.static_ratio,
            damping: given.damping,
            displacement: given.angle,
            velocity: given.rate,
            time: given.time,
            fall: given.fall,
        };
        oscillator.solve(sheet)?;
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// The friction torque.
fn friction<W: Worksheet>(
    given: &TorsionalFrictionGiven<W>,
    stiffness: W::Num,
    sheet: W,
) -> Result<W::Num, Refusal> {
    match &given.friction {
        FrictionTorqueGiven::Torque { torque } => Ok(*torque),
        FrictionTorqueGiven::Brake { coefficient, normal, radius } => {
            let torque = *coefficient * *normal * *radius;
            Ok(sheet.step("T_f", "N*m", torque, "Friction torque: friction force times its radius"))
        }
        FrictionTorqueGiven::Decay { first_amplitude: first, last_amplitude: last, counted } => {
            let decay =
                FrictionFromDecay { first: *first, last: *last, counted, stiffness, damping: given.damping };
            let (torque, cycles) = decay.force(OscillatorMotion::Rotation, "T_f", sheet)?;
            sheet.check(
                "the energy difference between the two amplitudes is the friction work over the angle travelled",
                stiffness * (first.powi(2) - last.powi(2)) / 2.0,
                torque * cycles * (*first + *last) * 2.0,
            );
            Ok(torque)
        }
    }
}

impl TorsionalFriction {
    /// The disc on its shaft with a brake at its rim.
    fn drawing(&self) -> Drawing {
        let shaft = match &self.spring {
            TorsionalSpring::Shaft { section, .. } => joined(&["k_t", section.letters()]),
            _ => "k_t".into(),
        };
        let mut sketch = Sketch::new("The disc on its torsional spring, with friction");
        turning::suspended(&mut sketch, [shaft, joined(self.inertia.letters())], 1.8);
        if let TorsionalSpring::Shaft { .. } = self.spring {
            sketch.dimension("L", (0.0, 0.14), (0.0, 1.8), 5.0);
        }
        let start = if self.rate == 0.0 { "θ₀" } else { "θ₀, Ω₀" };
        turning::turn(&mut sketch, start, (0.0, -0.35), 0.9, Ink::Motion);
        let torque = match self.friction {
            FrictionTorque::Torque { .. } => "T_f",
            FrictionTorque::Brake { .. } => "µN",
            FrictionTorque::Decay { .. } => "A₁, A₂",
        };
        sketch
            .mass("", (0.9, -0.16), (1.15, 0.16))
            .ground((1.15, -0.3), (1.15, 0.3))
            .label(torque, (1.0, 0.16));
        if let FrictionTorque::Brake { .. } = self.friction {
            sketch.force("N", (1.9, 0.0), (1.2, 0.0)).dimension("ρ", (0.0, 0.3), (0.9, 0.3), 0.0);
        }
        if self.damping > 0.0 {
            sketch.damper("c_t", (0.0, -1.5), (0.0, -0.36)).ground((-0.8, -1.5), (0.8, -1.5));
        }
        sketch.finish()
    }
}
