//! Drawing of a crankshaft with its cranks and what is attached to it.

use dalembert_core::{Drawing, Ink, Point, Sketch, Text};

use super::{Attached, CrankshaftCranks, EngineOrders};
use crate::shared::{
    inertia::{Inertia, RotorInertia},
    letters::of_row,
};

/// The crankshaft with what is attached to it, from the free end, as discs along a shaft.
pub(super) fn crankshaft(problem: &EngineOrders, count: usize) -> Drawing {
    let mut sketch = Sketch::new("The crankshaft from the free end");
    let mut x = 0.0;
    for (part, row) in problem.front.iter().zip(1..) {
        disc(&mut sketch, (x, 1.1), inertia(part, ["J_f", "m_f"], row));
        sketch.label(verbatim(&part.name), (x, -1.1)).link(of_row(&["k_t_f"], row), (x, 0.0), (x + 1.6, 0.0));
        x += 1.6;
    }
    let first = x;
    let letters = |row: usize| match problem.cranks {
        CrankshaftCranks::Alike { .. } => ["J_c".into(), "k_c".into()],
        CrankshaftCranks::Each { .. } => [of_row(&["J"], row), of_row(&["k"], row)],
    };
    for row in 1..=count {
        let [moment, stiffness] = letters(row);
        let up = if row % 2 == 1 { 1.0 } else { -1.0 };
        // A throw with its webs, the pins up and down in turn.
        sketch
            .bars([(x - 0.25, 0.0), (x - 0.25, 0.8 * up), (x + 0.25, 0.8 * up), (x + 0.25, 0.0)])
            .label(Text::new(row.to_string()), (x, 0.8 * up));
        if row == 1 || matches!(problem.cranks, CrankshaftCranks::Each { .. }) {
            sketch.label(moment, (x, -0.2 * up));
        }
        if row < count {
            sketch.bars([(x + 0.25, 0.0), (x + 0.95, 0.0)]);
            if row == 1 || matches!(problem.cranks, CrankshaftCranks::Each { .. }) {
                sketch.label(stiffness, (x + 0.6, 0.0));
            }
            x += 1.2;
        }
    }
    if problem.diameter.is_some() {
        sketch.label("d", (first + 0.4, 0.0));
    }
    for (part, row) in problem.rear.iter().zip(1..) {
        sketch.link(of_row(&["k_t_r"], row), (x + 0.25, 0.0), (x + 1.6, 0.0));
        x += 1.6;
        disc(&mut sketch, (x, 1.4), inertia(part, ["J_r", "m_r"], row));
        sketch.label(verbatim(&part.name), (x, -1.4));
    }
    sketch.motion("n_a ≤ n ≤ n_b", (x + 0.2, 0.0), (x + 1.2, 0.0)).finish()
}

/// A disc edge-on, with its letters above.
fn disc(sketch: &mut Sketch, (x, half): Point, letters: Text) {
    sketch.block("", (x - 0.15, -half), (x + 0.15, half), Ink::Body).label(letters, (x, half));
}

/// The letters of the inertia of an attached part.
fn inertia(part: &Attached, [moment, mass]: [&'static str; 2], row: usize) -> Text {
    match part.inertia {
        Inertia::Rotor(RotorInertia::Given { .. }) => of_row(&[moment], row),
        _ => of_row(&[mass], row),
    }
}

/// A name that a user gave.
fn verbatim(name: &str) -> Text {
    Text::new("{x}").with("x", name)
}
