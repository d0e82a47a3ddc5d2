//! Readings over the limits of their sensors.

use dalembert_core::{Text, Worksheet};
use dalembert_mechanics::{Real, balance::influence};
use nalgebra::Complex;

use super::Numbers;
use crate::shared::rotor;

/// The largest ratio of a predicted reading to its limit.
pub(super) fn nearest<W: Worksheet>(numbers: &Numbers, weights: &[Complex<f64>], limits: &[f64], sheet: W) {
    let left = influence::residuals(&numbers.alpha, &numbers.first, weights);
    let ratios = left.iter().zip(limits).map(|(reading, limit)| reading.norm() / limit);
    let how = "Largest ratio of a predicted residual reading to its limit";
    let ratio = sheet.numerical("ρ_max", "1", ratios.fold(0.0, f64::max), how);
    sheet.answer("largest_ratio", "Maximum residual reading over limit", ratio);
    sheet.verify(|| {
        let mut most = (0.0f64, 0.0f64);
        for (row, limit) in limits.iter().enumerate() {
            let first = numbers.first[row];
            let mut vectors = vec![(first.norm(), first.arg())];
            for (plane, weight) in weights.iter().enumerate() {
                let influence = numbers.alpha[(row, plane)];
                vectors.push((influence.norm() * weight.norm(), influence.arg() + weight.arg()));
            }
            let (squared, scale) = rotor::by_pairs(&vectors);
            most = (most.0.max(squared / limit.powi(2)), most.1.max(scale / limit.powi(2)));
        }
        let what = "square of the largest ratio by the law of cosines over readings and effects";
        sheet.check_sum(what, ratio.powi(2), most.0.into(), most.1);
    });
    if ratio.value() > 1.0 {
        sheet.warn(|| {
            Text::new(
                "no permitted masses bring every reading below its limit: the largest ratio is {ratio}; correct in more planes, or permit larger masses",
            )
            .with("ratio", format!("{:.2}", ratio.value()))
        });
    }
}
