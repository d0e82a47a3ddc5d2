//! The initial run alone, before any trial run.

use dalembert_core::{Drawing, Exhibit, Refusal, Text, Worksheet};
use nalgebra::Complex;

use super::{Field, Job, numbers, rotor::Demand, show};
use crate::shared::views::dial;

/// Evaluates the initial run.
///
/// # Errors
/// Readings of which every one is 0.
pub(super) fn evaluate<W: Worksheet>(
    field: &Field,
    (job, opposed): (&Job<W::Num>, bool),
    demand: Option<&Demand<W::Num>>,
    sheet: W,
) -> Result<(), Refusal> {
    let first = numbers::initial(job, opposed, sheet)?;
    let largest = first.iter().map(|v| v.norm()).fold(0.0, f64::max);
    let largest = sheet.numerical("A_max", job.units.reading, largest, "Largest reading of the initial run");
    sheet.answer("initial", "Largest vibration of the initial run", largest);
    if let Some(Demand::Vibration { limit }) = demand {
        let ratio = sheet.step("q_r", "1", largest / *limit, "Largest reading over its limit: 1 at most");
        sheet.answer("initial_ratio", "Largest vibration over its limit", ratio);
    }
    sheet.show(|| Exhibit::Table(show::initial(&first, job.units.reading)));
    sheet.show(|| Exhibit::Drawing(drawing(field, &first)));
    Ok(())
}

/// The readings as vectors, as they are counted on the rotor.
fn drawing(field: &Field, first: &[Complex<f64>]) -> Drawing {
    let reach = first.iter().map(|v| v.norm()).fold(0.0, f64::max);
    let mut sketch = dial("Readings of the initial run");
    for (n, reading) in (1..).zip(first) {
        let tip = field.seen(*reading / reach);
        sketch.motion(Text::new(format!("V{n}")), (0.0, 0.0), (tip.re, tip.im));
    }
    sketch.finish()
}
