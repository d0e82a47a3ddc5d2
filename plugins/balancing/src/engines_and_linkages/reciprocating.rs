//! Reciprocating engines: shaking forces and couples by orders, counterweights, balance shafts.

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    balance::reciprocating::{self as engine, Piston, PistonMotion},
};

use crate::{
    shared::crank::Throw,
    sources::{BEVAN, DEN_HARTOG, KHURMI, NORTON},
};

mod checks;
mod counterweight;
mod layout;
mod orders;
mod pictures;

/// An engine and its speed.
#[derive(Clone, Debug, Inputs)]
pub struct Reciprocating {
    /// Arrangement.
    pub arrangement: Arrangement,
    /// Speed of the crankshaft.
    #[input("ω", "rpm", positive)]
    pub speed: f64,
    /// Motion of the pistons.
    pub motion: Terms,
    /// Crank angle.
    /// For the forces at that instant; the first throw of a line engine is at the top at 0.
    #[input("θ", "deg")]
    pub angle: Option<f64>,
    /// Counterweights.
    /// Opposite every crank: they balance its rotating mass and a fraction of its reciprocating mass.
    pub counterweight: Option<Counterweight>,
    /// Balance shafts.
    /// A pair that turns in opposite senses.
    pub shafts: Option<Shafts>,
    /// Reference point for moments.
    /// Along the shaft; left out, the middle between the first and the last cylinder.
    #[input("z₀", "mm")]
    pub reference: Option<f64>,
}

/// Harmonic orders of the piston motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Terms {
    /// Primary and secondary, two terms
    /// cos α + λ cos 2α.
    Two,
    /// Exact: orders 1, 2, 4 and 6
    Exact,
}

/// Arrangement of the cylinders.
#[derive(Clone, Debug, Inputs)]
pub enum Arrangement {
    /// In-line
    Inline {
        /// Every cylinder.
        every: Every,
        /// Cylinders along the shaft.
        #[input(min = 1, max = 12)]
        count: usize,
        /// Spacing.
        spacing: Spacing,
        /// Cranks.
        cranks: CrankAngles,
    },
    /// V or W: banks on the same cranks
    /// The banks lie evenly about the vertical, cylinders are numbered bank by bank.
    Banks {
        /// Every cylinder.
        every: Every,
        /// Banks.
        #[input(min = 2, max = 4)]
        banks: usize,
        /// Angle between neighbouring banks.
        #[input("γ", "deg")]
        between: f64,
        /// Cranks along the shaft.
        #[input(min = 1, max = 8)]
        count: usize,
        /// Spacing.
        spacing: Spacing,
        /// Cranks.
        cranks: CrankAngles,
        /// Splay angle of a crank pin.
        /// From one bank to the next.
        #[input("δ", "deg", default = "0 deg")]
        split: f64,
        /// Offset of a bank along the shaft from the one before.
        #[input("s", "mm", default = "0 mm")]
        offset: f64,
    },
    /// Boxer: opposed cylinders on opposed cranks
    Boxer {
        /// Every cylinder.
        every: Every,
        /// Pairs of cylinders.
        #[input(min = 1, max = 6)]
        count: usize,
        /// Distance between neighbouring cylinders along the shaft.
        #[input("p", "mm", positive)]
        pitch: f64,
        /// Cranks.
        /// Of the first cylinder of each pair.
        cranks: CrankAngles,
    },
    /// Radial: cylinders all round one crank
    Radial {
        /// Every cylinder.
        every: Every,
        /// Cylinders.
        #[input(min = 2, max = 18)]
        count: usize,
    },
    /// Opposed pistons in one cylinder, on two shafts
    Opposed {
        /// Every piston.
        every: Every,
        /// Cylinders along the shaft.
        #[input(min = 1, max = 12)]
        count: usize,
        /// Spacing.
        spacing: Spacing,
        /// Cranks.
        cranks: CrankAngles,
        /// Lead of the second crank.
        #[input("δ", "deg", default = "0 deg")]
        lead: f64,
    },
    /// Cylinders one by one
    Cylinders {
        /// Cylinders.
        #[input(min = 1)]
        cylinders: Vec<PlacedCylinder>,
    },
}

/// Parameters common to all cylinders.
#[derive(Clone, Debug, Inputs)]
pub struct Every {
    /// Reciprocating mass.
    #[input("m", "kg", positive)]
    pub reciprocating: f64,
    /// Rotating mass at the crank pin.
    #[input("m_r", "kg", nonnegative, default = "0 kg")]
    pub rotating: f64,
    /// Crank.
    pub throw: Throw,
    /// Length of the rod.
    /// If omitted, only primary forces are reported.
    #[input("l", "mm", positive)]
    pub rod: Option<f64>,
}

/// Positions along the shaft.
#[derive(Clone, Debug, Inputs)]
pub enum Spacing {
    /// Equal distances
    Pitch {
        /// Distance between adjacent cranks.
        #[input("p", "mm", positive)]
        pitch: f64,
    },
    /// Positions given
    Positions {
        /// Positions along the shaft.
        #[input("z", "mm")]
        positions: Vec<f64>,
    },
}

/// Crank angles.
#[derive(Clone, Debug, Inputs)]
pub enum CrankAngles {
    /// Crank angles given
    Angles {
        /// Crank angles.
        #[input("φ", "deg")]
        angles: Vec<f64>,
    },
    /// From the firing order
    Firing {
        /// Firing order.
        /// Such as 1-3-4-2, one number for each cylinder.
        order: String,
        /// Strokes of a cycle.
        strokes: Strokes,
    },
    /// Even firing, in the order with the smallest couples
    Best {
        /// Strokes of a cycle.
        strokes: Strokes,
    },
}

/// Strokes of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Strokes {
    /// Four strokes
    Four,
    /// Two strokes
    Two,
}

/// A cylinder by itself.
#[derive(Clone, Debug, Inputs)]
pub struct PlacedCylinder {
    /// Reciprocating mass.
    #[input("m", "kg", positive)]
    pub reciprocating: f64,
    /// Rotating mass at the crank pin.
    #[input("m_r", "kg", nonnegative, default = "0 kg")]
    pub rotating: f64,
    /// Crank radius.
    #[input("r", "mm", positive)]
    pub radius: f64,
    /// Length of the rod.
    /// If omitted, only primary forces are reported.
    #[input("l", "mm", positive)]
    pub rod: Option<f64>,
    /// Crank angle.
    #[input("φ", "deg")]
    pub throw: f64,
    /// Direction of the stroke.
    /// From the vertical, in the sense of the crank angles.
    #[input("ψ", "deg", default = "0 deg")]
    pub line: f64,
    /// Position along the shaft.
    #[input("z", "mm", default = "0 mm")]
    pub position: f64,
}

/// Counterweights opposite the cranks.
#[derive(Clone, Debug, Inputs)]
pub struct Counterweight {
    /// Balanced fraction of the reciprocating mass.
    #[input("c", "1", min = 0.0, max = 1.0, default = "0.5")]
    pub fraction: f64,
    /// Radius of the counterweight.
    #[input("b", "mm", positive)]
    pub radius: f64,
}

/// A pair of balance shafts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Shafts {
    /// At the speed of the crankshaft
    First,
    /// At twice that speed
    Second,
}

impl Arrangement {
    /// The symbol of the distance from one cylinder to the next.
    fn along(&self) -> &'static str {
        match self {
            Arrangement::Inline { spacing: Spacing::Pitch { .. }, .. }
            | Arrangement::Banks { spacing: Spacing::Pitch { .. }, .. }
            | Arrangement::Opposed { spacing: Spacing::Pitch { .. }, .. }
            | Arrangement::Boxer { .. } => "p",
            _ => "z",
        }
    }
}

register!(Reciprocating);

impl Analysis for Reciprocating {
    const ABOUT: About = About {
        id: "balancing/reciprocating",
        title: "Shaking forces of reciprocating engines",
        topic: "Engines and linkages",
        summary: "Primary, secondary and higher forces and couples of engines in line, in V, boxer, radial or cylinder by cylinder, with counterweights and balance shafts.",
        main: &["force", "couple", "residual", "counterweight"],
        keywords: "balanceamento massas alternativas motor em linha V radial boxer twin V-twin força primária secundária contrapeso eixo balanceador \
                   ordem de ignição reciprocating engine inline primary secondary couple firing order Lanchester balance shaft counterweight",
        sources: &[&DEN_HARTOG, &NORTON, &KHURMI, &BEVAN],
        cases: include_str!("../../cases/reciprocating.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ReciprocatingGiven<W>, sheet: W) -> Result<(), Refusal> {
        let cylinders = layout::cylinders(&self.arrangement, &given.arrangement, sheet)?;
        sheet.keep_going()?;
        for c in &cylinders {
            if let Some(rod) = c.rod
                && rod.value() < 1.01 * c.crank.value()
            {
                return Err(Refusal::because(
                    Text::new(
                        "the rod of {rod} must be longer than the crank of {crank}, or the crank cannot rotate fully; give a rod of at least 1.01 crank radii",
                    )
                    .with_quantity("rod", rod.value(), "mm")
                    .with_quantity("crank", c.crank.value(), "mm"),
                ));
            }
        }
        let finite = cylinders.iter().all(|c| c.rod.is_some());
        let orders: &[u8] = match (finite, self.motion) {
            (false, _) => &[1],
            (true, Terms::Two) => &[1, 2],
            (true, Terms::Exact) => &[1, 2, 4, 6],
        };
        let motion = match (finite, self.motion) {
            (false, _) => PistonMotion::OneTerm,
            (true, Terms::Two) => PistonMotion::TwoTerms,
            (true, Terms::Exact) => PistonMotion::Exact,
        };
        let about = layout::reference(&cylinders, given.reference, sheet);
        let primary = layout::amplitudes(&cylinders, given.speed, sheet);
        let pistons: Vec<Piston> = cylinders
            .iter()
            .zip(&primary)
            .map(|(c, amplitude)| Piston {
                amplitude: amplitude.value(),
                ratio: c.rod.map_or(0.0, |rod| c.crank.value() / rod.value()),
                line: c.line.value(),
                throw: c.throw.value(),
                position: c.position.value(),
            })
            .collect();
        let mut found = Vec::new();
        for &order in orders {
            let strengths = orders::strengths(order, self.motion, &cylinders, &primary, sheet);
            found.push(orders::of_order(order, &cylinders, &strengths, about, given.angle, sheet));
            sheet.keep_going()?;
        }
        sheet.verify(|| orders::check(&found, &pistons, motion, about.map_or(0.0, Real::value), sheet));
        let scale: f64 = pistons.iter().map(|p| p.amplitude).sum();
        let at = about.map_or(0.0, Real::value);
        let (_, largest) = engine::largest(|angle| engine::shaking(&pistons, motion, at, angle).0);
        let largest = if largest < 1e-11 * scale { 0.0 } else { largest };
        let whole =
            sheet.numerical("F_max", "N", largest, "Maximum shaking force of all orders over a revolution");
        sheet.answer("greatest_force", "Maximum shaking force over a revolution", whole);
        sheet.verify(|| {
            let again = orders::largest_again(&found, &pistons, motion);
            sheet.check_zero(
                "the maximum force from the vectors of the orders, or from the slider-crank as a mechanism",
                (whole.value() - again).into(),
                scale,
            );
        });
        let residual = counterweight::rotating(given, &cylinders, &primary, &found, about, sheet);
        if let Some(shafts) = self.shafts {
            let engine = counterweight::CylinderEngine { cylinders: &cylinders, pistons: &pistons, motion };
            counterweight::shafts(shafts, given.speed, &engine, &found, &residual, about, sheet)?;
        }
        sheet.show(|| Exhibit::Plot(pictures::forces(&pistons, motion, at)));
        if cylinders.iter().any(|c| c.position.value() != cylinders[0].position.value()) {
            sheet.show(|| Exhibit::Plot(pictures::couples(&pistons, motion, at)));
        }
        sheet.show(|| {
            let drawn: Vec<layout::View> = cylinders.iter().map(layout::Placed::drawn).collect();
            Exhibit::Drawing(pictures::engine(&drawn, self.arrangement.along()))
        });
        sheet.show(|| Exhibit::Drawing(pictures::ellipse(&pistons, motion, at)));
        sheet.show(|| Exhibit::Table(pictures::table(&found)));
        sheet.show(|| Exhibit::Animation(pictures::stars(&pistons, orders)));
        Ok(())
    }
}
