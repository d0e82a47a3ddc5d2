//! A reciprocating engine with one cylinder: the piston's motion, the forces in its parts, and its turning moment.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{Real, slider_crank::engine as kernel};

mod animation;
mod cycle;
mod exhibits;
mod flywheel;
mod forces;
mod gas;
mod ideal;
mod motion;
mod rod;
mod witness;

pub use self::{
    flywheel::{EngineLoad, EngineLoadGiven, Resisting, ResistingGiven},
    gas::{
        Acting, ActingGiven, AngleRow, Behind, BehindGiven, Datum, DatumGiven, ExpansionLaw,
        ExpansionLawGiven, Gas, GasGiven, StrokeRow,
    },
    ideal::{Combustion, CombustionGiven, FuelCutOff, FuelCutOffGiven, PeakPressure, PeakPressureGiven},
    rod::{Centre, CentreGiven, RodInertia, RodInertiaGiven, RodMass, RodMassGiven, SwingPin},
};
use crate::sources::{BEVAN, KHURMI, RIUL};

/// An engine with one cylinder at one crank angle, and over its cycle.
#[derive(Clone, Debug, Inputs)]
pub struct Engine {
    /// Crank.
    pub throw: Throw,
    /// Rod.
    pub rod: RodLength,
    /// Offset of the line of stroke.
    /// Height above the crankshaft, on the side to which the crank turns first.
    #[input("e", "mm", default = "0 mm")]
    pub offset: f64,
    /// Crank angle.
    /// From the dead centre with the piston farthest from the crankshaft (inner or top dead centre), in the sense of
    /// rotation; with an offset, from the line of stroke.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Motion.
    pub motion: EngineMotion,
    /// Formulas of the motion.
    pub terms: Terms,
    /// Reciprocating mass.
    /// Piston, piston rod, crosshead.
    #[input("m_R", "kg", nonnegative, default = "0 kg")]
    pub reciprocating: f64,
    /// Mass of the connecting rod.
    pub rod_mass: RodMass,
    /// Position of the cylinder.
    pub orientation: Orientation,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
    pub gravity: f64,
    /// Force on the piston.
    pub gas: Gas,
    /// Friction of the piston.
    /// Against its motion as the crank turns forward.
    #[input("F_f", "N", nonnegative)]
    pub friction: Option<f64>,
    /// Flywheel and driven load.
    pub output: Option<EngineLoad>,
}

/// Crank radius or stroke.
#[derive(Clone, Debug, Inputs)]
pub enum Throw {
    /// Crank radius
    Radius {
        /// Crank radius.
        #[input("r", "mm", positive)]
        radius: f64,
    },
    /// Stroke
    /// Of an engine without offset: twice the crank radius.
    Stroke {
        /// Stroke.
        #[input("S", "mm", positive)]
        stroke: f64,
    },
}

/// Length of the rod.
#[derive(Clone, Debug, Inputs)]
pub enum RodLength {
    /// Length
    Length {
        /// Length of the rod.
        #[input("l", "mm", positive)]
        length: f64,
    },
    /// Ratio to the crank radius
    Ratio {
        /// Length of the rod over the crank radius.
        #[input("n", "1", above = 1)]
        ratio: f64,
    },
}

/// Motion of the engine.
#[derive(Clone, Debug, Inputs)]
pub enum EngineMotion {
    /// Running
    Running {
        /// Speed of the crank.
        #[input("ω", "rpm", positive)]
        speed: f64,
        /// Angular acceleration of the crank.
        #[input("α", "rad/s^2", default = "0 rad/s^2")]
        acceleration: f64,
    },
    /// At rest
    /// Equilibrium without inertia.
    Standing,
    /// Acceleration of the piston given
    PistonAcceleration {
        /// Acceleration of the piston.
        /// Towards the crank.
        #[input("a", "m/s^2")]
        acceleration: f64,
    },
}

/// Formulas of the piston motion, exact or approximate; a table shows all of them.
#[derive(Clone, Debug, Inputs)]
pub enum Terms {
    /// Exact
    Exact,
    /// Two terms
    /// cos θ + cos 2θ/n, as in most books.
    Two,
    /// Harmonics up to an order
    Harmonics {
        /// Highest order.
        /// Beyond the first, only even orders occur.
        #[input(min = 2, max = 16, default = "6")]
        highest: u32,
    },
}

/// Orientation of the cylinder.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum Orientation {
    /// Weights neglected
    Weightless,
    /// Vertical, above the crankshaft
    Vertical,
    /// Horizontal
    Horizontal,
    /// Inclined
    Inclined {
        /// Angle of the stroke above the horizontal.
        #[input("β", "deg")]
        angle: f64,
    },
}

register!(Engine);

impl Analysis for Engine {
    const ABOUT: About = About {
        id: "virtual-work/engine",
        title: "Reciprocating engine",
        topic: "Engines, gears and wheels",
        summary: "Motion of the piston, forces in piston, rod, guide, crank pin and bearings, and turning moment of a single-cylinder engine, at one angle and over its cycle.",
        main: &["turning_moment", "piston_force", "mean_moment", "velocity", "acceleration"],
        keywords: "motor alternativo pistão biela manivela slider-crank piston effort crank effort turning moment diagram gudgeon pin \
                   connecting rod thrust guide crosshead steam engine Otto Diesel ideal cycle compression ratio indicator diagram cut-off expansion inertia force torque motor \
                   esforço no êmbolo ponto morto diagrama de torque máquina a vapor força de inércia pino da manivela",
        sources: &[&RIUL, &BEVAN, &KHURMI],
        cases: include_str!("../../cases/engine.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EngineGiven<W>, sheet: W) -> Result<(), Refusal> {
        let lengths = motion::lengths(self, given, sheet)?;
        self.refuse_contradictions(lengths.offset.is_some())?;
        let moving = motion::motion(self, given, &lengths, sheet);
        let rod = rod::masses(&self.rod_mass, &given.rod_mass, lengths.rod, given.gravity, sheet)?;
        let field = forces::gravity(self, given, rod.as_ref(), sheet);
        let kernel = self.kernel(&lengths, rod.as_ref(), &field);
        if let (Some(rod), Some(_)) = (&rod, moving.speed) {
            rod::inertia_force(rod, &lengths, &moving, &kernel, sheet);
        }
        let problem = forces::EngineProblem {
            given,
            lengths: &lengths,
            moving: &moving,
            rod: rod.as_ref(),
            field: &field,
        };
        let forces = forces::forces(self, &problem, &kernel, sheet)?;
        sheet.verify(|| witness::motion(self, &lengths, &moving, &kernel, sheet));
        if let Some(forces) = &forces {
            if let Some(output) = &given.output {
                let works = witness::moment(&moving, &kernel, forces.pressure);
                flywheel::acceleration(output, &moving, forces.moment, works, sheet)?;
            }
            sheet.verify(|| witness::forces(&problem, &kernel, forces, sheet));
        }
        sheet.keep_going()?;
        let cycle = match (&forces, moving.speed) {
            (Some(forces), Some(speed)) => {
                cycle::cycle(self, &problem, &kernel, forces.gas.as_ref(), speed, sheet)?
            }
            _ => None,
        };
        let view = exhibits::View {
            engine: self,
            kernel: &kernel,
            crank: moving.crank(),
            given_acceleration: match self.motion {
                EngineMotion::PistonAcceleration { acceleration } => Some(acceleration),
                _ => None,
            },
            running: moving.speed.is_some(),
            gas: forces.as_ref().and_then(|forces| forces.gas.as_ref()),
            force: forces.as_ref().map(|forces| forces.pressure),
            cycle: cycle.as_ref(),
        };
        if view.running {
            sheet.show(|| Exhibit::Table(view.models()));
        }
        if view.running && view.force.is_some() {
            sheet.show(|| Exhibit::Plot(view.moments()));
            sheet.show(|| Exhibit::Plot(view.efforts()));
            sheet.show(|| Exhibit::Plot(view.crank_pin()));
            sheet.show(|| Exhibit::Plot(view.bearing()));
        }
        if view.running {
            sheet.show(|| Exhibit::Plot(view.accelerations()));
        }
        sheet.show(|| animation::show(&view));
        Ok(())
    }
}

impl Engine {
    /// Angle of the line of stroke over the horizontal.
    fn upright(&self) -> f64 {
        match self.orientation {
            Orientation::Vertical => FRAC_PI_2,
            Orientation::Horizontal | Orientation::Weightless => 0.0,
            Orientation::Inclined { angle } => angle,
        }
    }

    /// Inputs that do not go together.
    fn refuse_contradictions(&self, offset: bool) -> Result<(), Refusal> {
        if offset && !matches!(self.terms, Terms::Exact) {
            return Err(Refusal::because(
                "the two-term and harmonic formulas hold for a line of stroke through the crankshaft: choose the exact motion, or no offset",
            ));
        }
        let weightless_rod = matches!(self.rod_mass, RodMass::Massless);
        if matches!(self.motion, EngineMotion::PistonAcceleration { .. }) && !weightless_rod {
            return Err(Refusal::because(
                "the acceleration of the piston does not determine that of the rod: give the speed, or leave the rod without mass and add its share to the reciprocating mass",
            ));
        }
        Ok(())
    }

    /// The same engine as plain numbers.
    fn kernel<N: Real>(
        &self,
        lengths: &motion::Lengths<N>,
        rod: Option<&rod::Masses<N>>,
        field: &forces::GravityField<N>,
    ) -> kernel::EngineCylinder {
        let (crank, length) = (lengths.crank.value(), lengths.rod.value());
        kernel::EngineCylinder {
            crank,
            rod: length,
            offset: lengths.offset.map_or(0.0, Real::value),
            model: self.model(length / crank),
            reciprocating: self.reciprocating,
            rod_mass: rod.map_or(0.0, |rod| rod.mass.value()),
            rod_centre: rod.map_or(0.0, |rod| rod.centre.value()),
            rod_inertia: rod.map_or(0.0, |rod| rod.inertia.value()),
            gravity: [field.along, field.across].map(|part| part.map_or(0.0, Real::value)),
            friction: self.friction.unwrap_or(0.0),
        }
    }

    fn model(&self, ratio: f64) -> kernel::PistonFormula {
        match self.terms {
            Terms::Exact => kernel::PistonFormula::Exact,
            Terms::Two => kernel::PistonFormula::TwoTerm,
            Terms::Harmonics { highest } => {
                kernel::PistonFormula::up_to(u8::try_from(highest).unwrap_or(u8::MAX), ratio)
            }
        }
    }
}

/// The rod has to be longer than crank and offset together, by a hundredth of them.
fn too_short(rod: f64, least: f64) -> Refusal {
    Refusal::because(
        Text::new(
            "the crank cannot make a full revolution with a rod of {rod}: crank and offset together require more than {least}",
        )
        .with_quantity("rod", rod, "mm")
        .with_quantity("least", least, "mm"),
    )
}
