//! Ranges of the corrections by the uncertainty of the readings.

use dalembert_core::{Text, Worksheet};
use dalembert_mechanics::balance::spread::{self, Choice, ReadingSpread};
use dalembert_numerics::intervals::IntervalSet;
use nalgebra::Complex;
use std::{f64::consts::TAU, ops::Bound};

use super::Numbers;

/// Number of Monte Carlo samples from which the ranges are computed.
const SAMPLES: usize = 400;

/// As many unknowns times readings a min-max problem may have for its samples to be found while a key is typed.
const QUICK: usize = 200;

/// Beside its weight a range wider than this is no longer what linear propagation makes it, and covers less.
const WIDE: f64 = 0.3;

/// Ranges of weights and predictions by the uncertainty of the readings. These are no numbers of the plain reading,
/// which somebody may repeat a million times.
pub(super) fn ranges<W: Worksheet>(
    (numbers, limits): (&Numbers, &[f64]),
    choice: Choice<'_>,
    spread: ReadingSpread,
    weights: &[Complex<f64>],
    unit: &'static str,
    sheet: W,
) {
    if spread.amplitude == 0.0 && spread.phase == 0.0 {
        return;
    }
    if matches!(choice, Choice::MinMax(_)) && weights.len() * numbers.first.len() > QUICK {
        sheet.warn(|| {
            Text::new(
                "the ranges of the weights are left out: to solve the min-max problem of {readings} readings and {planes}                  planes again for each of {samples} samples takes too long; least squares gives its ranges at once",
            )
            .with("readings", numbers.first.len())
            .with("planes", weights.len())
            .with("samples", SAMPLES)
        });
        return;
    }
    let over = numbers.over(limits);
    let measured = over.measured(choice, spread);
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let Some(ranges) = spread::ranges(&measured, weights, SAMPLES, threads) else { return };
    let between = |[low, high]: [f64; 2]| IntervalSet::interval(Bound::Included(low), Bound::Included(high));
    let mut uncertain = Vec::new();
    for (n, (size, angle)) in (1..).zip(ranges.sizes.iter().zip(&ranges.angles)) {
        let label = "95 % interval of the correction mass in plane";
        sheet.answer_set(("correction_range", n), label, "g", &between(*size), Vec::new());
        // Both ends positive, as angles are marked: 350° to 370° about the mark.
        let turn = if angle[0] < 0.0 { TAU } else { 0.0 };
        let any = angle[1] - angle[0] > TAU * (1.0 - 1e-9);
        let angles = if any { IntervalSet::all() } else { between(angle.map(|a| a + turn)) };
        let label = "95 % interval of the angle of the correction in plane";
        sheet.answer_set(("angle_range", n), label, "deg", &angles, Vec::new());
        let weight = weights[n - 1].norm();
        let width = size[1] - size[0];
        if width > WIDE * weight && width <= weight {
            uncertain.push(n);
        }
        if width > weight {
            sheet.warn(|| {
                Text::new(
                    "the uncertainty of the readings allows a correction in plane {n} from {low} to {high}: use a larger trial weight or more stable readings before the next start",
                )
                .with("n", n)
                .with_quantity("low", size[0], "g")
                .with_quantity("high", size[1], "g")
            });
        }
    }
    if !uncertain.is_empty() {
        sheet.warn(|| {
            let said = if uncertain.len() == 1 {
                "plane {planes}: the correction is uncertain, and its 95 % interval covers only about 87 %; repeat the runs, or use a larger trial weight"
            } else {
                "planes {planes}: the corrections are uncertain, and their 95 % intervals cover only about 87 %; repeat the runs, or use a larger trial weight"
            };
            let planes = uncertain.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
            Text::new(said).with("planes", planes)
        });
    }
    sheet.answer_list(
        "residual_limit",
        "95 % upper limit of the residual vibration",
        unit,
        &ranges.residuals.iter().zip(limits).map(|(ratio, limit)| ratio * limit).collect::<Vec<_>>(),
    );
}
