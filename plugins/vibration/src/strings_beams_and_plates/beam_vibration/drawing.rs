//! Drawing of a beam on its supports with what it carries.

use dalembert_core::Drawing;

use super::{AttachedPart, BeamVibration};
use crate::shared::{
    continuous::{HALF_BEAM, beam},
    letters::of_row,
};

impl BeamVibration {
    /// The beam on its supports with what it carries, and its cross-section.
    pub(super) fn drawing(&self) -> Drawing {
        const WIDTH: f64 = 6.0;
        let mut sketch = beam("The beam and its section", WIDTH);
        self.left.draw(&mut sketch, 0.0, true);
        self.right.draw(&mut sketch, WIDTH, false);
        for (attached, row) in self.attachments.iter().zip(1..) {
            let x = (attached.distance / self.length).min(1.0) * WIDTH;
            let top = HALF_BEAM;
            match attached.part {
                AttachedPart::Mass { inertia, .. } => {
                    let letters: &[&str] = if inertia.is_some() { &["m", "J"] } else { &["m"] };
                    sketch
                        .mass("", (x - 0.2, top), (x + 0.2, top + 0.4))
                        .label(of_row(letters, row), (x, top + 0.4))
                }
                AttachedPart::Spring { .. } => sketch
                    .spring(of_row(&["k"], row), (x, -1.0), (x, -top))
                    .ground((x - 0.3, -1.0), (x + 0.3, -1.0)),
                AttachedPart::RotationSpring { .. } => {
                    sketch.torsion_spring(of_row(&["k_t"], row), (x, 0.0), 0.0)
                }
                AttachedPart::Pin => sketch.pin("", (x, -top)),
                AttachedPart::SprungMass { .. } => sketch
                    .spring(of_row(&["k"], row), (x, top), (x, 0.8))
                    .mass(of_row(&["m"], row), (x - 0.35, 0.8), (x + 0.35, 1.2)),
            };
            sketch.dimension(of_row(&["x"], row), (0.0, -1.2), (x, -1.2), 3.0);
        }
        if self.axial.is_some() {
            sketch.force("N", (WIDTH, 0.0), (WIDTH + 0.8, 0.0)).force("", (0.0, 0.0), (-0.8, 0.0));
        }
        if self.foundation.is_some() {
            for n in 0..6u8 {
                let x = WIDTH * (f64::from(n) + 0.5) / 6.0;
                let name = if n == 2 { "k_f" } else { "" };
                sketch.spring(name, (x, -0.9), (x, -HALF_BEAM));
            }
            sketch.ground((0.0, -0.9), (WIDTH, -0.9));
        }
        self.section.draw(&mut sketch, (WIDTH + 1.9, 0.0), 0.9);
        sketch.finish()
    }
}
