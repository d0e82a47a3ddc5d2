//! Drawing of a string, rod, shaft or shear beam between its ends.

use dalembert_core::{Drawing, Sketch, Text};
use dalembert_mechanics::vibration::wave::WaveEnd;

use super::{BodyEnd, StringRodShaft, TorsionSection, TurningEnd, WaveCarrier, draw_ends};

const WIDTH: f64 = 6.0;

/// The body with its length, its tension or its section, and the letters of its ends.
pub(super) fn drawing(problem: &StringRodShaft, ends: [WaveEnd; 2]) -> Drawing {
    let mut sketch = Sketch::new("The body between its ends");
    let half = 0.12;
    match &problem.body {
        WaveCarrier::String { left, right, .. } => {
            sketch
                .bars([(0.0, 0.0), (WIDTH, 0.0)])
                .force("T", (WIDTH, 0.35), (WIDTH + 0.9, 0.35))
                .force("T", (0.0, 0.35), (-0.9, 0.35))
                .label(straight(left, "_0"), (0.0, -0.5))
                .label(straight(right, "_L"), (WIDTH, -0.5));
        }
        WaveCarrier::Rod { left, right, .. } | WaveCarrier::ShearBeam { left, right, .. } => {
            sketch
                .mass("", (0.0, -2.0 * half), (WIDTH, 2.0 * half))
                .label(straight(left, "_0"), (0.0, -0.5))
                .label(straight(right, "_L"), (WIDTH, -0.5));
        }
        WaveCarrier::Shaft { section, left, right, .. } => {
            sketch
                .mass("", (0.0, -half), (WIDTH, half))
                .label(turning(left, "_0"), (0.0, -0.5))
                .label(turning(right, "_L"), (WIDTH, -0.5));
            match section {
                TorsionSection::Round(section) => section.draw(&mut sketch, (WIDTH + 1.6, 0.0), 0.8),
                TorsionSection::Rectangle { .. } => {
                    sketch.label("a, b", (0.4 * WIDTH, half));
                }
                TorsionSection::Given { .. } => {}
            }
        }
    }
    draw_ends(ends, &mut sketch, WIDTH, 0.0);
    sketch.dimension("L", (0.0, -1.1), (WIDTH, -1.1), 0.0).finish()
}

/// Letters of an end that moves along a line.
fn straight(end: &BodyEnd, place: &str) -> Text {
    match end {
        BodyEnd::Fixed | BodyEnd::Free => "".into(),
        BodyEnd::Spring { .. } => named(&["k"], place),
        BodyEnd::Mass { .. } => named(&["m"], place),
        BodyEnd::SpringAndMass { .. } => named(&["k", "m"], place),
    }
}

/// Letters of an end that turns.
fn turning(end: &TurningEnd, place: &str) -> Text {
    match end {
        TurningEnd::Fixed | TurningEnd::Free => "".into(),
        TurningEnd::Spring { .. } => named(&["k"], place),
        TurningEnd::Disc { .. } => named(&["J"], place),
        TurningEnd::SpringAndDisc { .. } => named(&["k", "J"], place),
    }
}

fn named(letters: &[&str], place: &str) -> Text {
    let all: Vec<String> = letters.iter().map(|letter| format!("{letter}{place}")).collect();
    Text::verbatim(all.join(", "))
}
