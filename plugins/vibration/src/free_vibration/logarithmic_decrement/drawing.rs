//! Drawings of the systems that decay.

use dalembert_core::{Drawing, Ink, Sketch, Text};

use super::SystemData;
use crate::shared::{letters::joined, oscillator::plots, turning};

impl SystemData {
    /// The mass on its spring, or the disc on its shaft.
    pub(super) fn drawing(&self) -> Drawing {
        let oscillator = |letters: [Text; 2]| {
            plots::supported("The mass on its spring", letters).ground((-1.0, -1.5), (1.0, -1.5)).finish()
        };
        match self {
            SystemData::MassStiffness { mass, stiffness, .. } => {
                oscillator([mass.letter().into(), stiffness.letters().into()])
            }
            SystemData::MassPeriod { mass, .. } => oscillator([mass.letters(), "k".into()]),
            SystemData::Unknown | SystemData::Period { .. } | SystemData::StiffnessPeriod { .. } => {
                oscillator(["m".into(), "k".into()])
            }
            SystemData::Torsion { inertia, .. } => disc(["k_t".into(), joined(inertia.letters())], false),
            SystemData::Shaft { .. } => disc(["d".into(), "J".into()], true),
        }
    }
}

fn disc(letters: [Text; 2], shaft: bool) -> Drawing {
    let mut sketch = Sketch::new("The disc on its shaft");
    turning::suspended(&mut sketch, letters, 1.6);
    turning::turn(&mut sketch, "θ", (0.0, -0.35), 0.9, Ink::Motion);
    if shaft {
        sketch.dimension("L", (0.0, 0.14), (0.0, 1.6), 5.0);
    }
    sketch.finish()
}
