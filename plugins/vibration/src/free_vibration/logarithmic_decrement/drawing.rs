//! Drawings of the systems that decay.

use dalembert_core::{Drawing, Ink, Sketch, Text};

use super::SystemData;
use crate::shared::{letters::joined, oscillator::plots, turning};

impl SystemData {
    /// The mass on its spring, or the disc on its shaft; none where neither is known.
    pub(super) fn drawing(&self) -> Option<Drawing> {
        let oscillator = |letters: [Text; 2]| {
            plots::supported("The mass on its spring", letters).ground((-1.0, -1.5), (1.0, -1.5)).finish()
        };
        match self {
            SystemData::Unknown | SystemData::Period { .. } => None,
            SystemData::MassStiffness { mass, stiffness, .. } => {
                Some(oscillator([mass.letter().into(), stiffness.letters().into()]))
            }
            SystemData::MassPeriod { mass, .. } => Some(oscillator([mass.letters(), "k".into()])),
            SystemData::StiffnessPeriod { .. } => Some(oscillator(["m".into(), "k".into()])),
            SystemData::Torsion { inertia, .. } => {
                Some(disc(["k_t".into(), joined(inertia.letters())], false))
            }
            SystemData::Shaft { .. } => Some(disc(["d".into(), "J".into()], true)),
        }
    }
}

fn disc(letters: [Text; 2], shaft: bool) -> Drawing {
    let mut sketch = Sketch::new("The disc on its shaft");
    turning::hung(&mut sketch, letters, 1.6);
    turning::turn(&mut sketch, "θ", (0.0, -0.35), 0.9, Ink::Motion);
    if shaft {
        sketch.dimension("L", (0.0, 0.14), (0.0, 1.6), 5.0);
    }
    sketch.finish()
}
