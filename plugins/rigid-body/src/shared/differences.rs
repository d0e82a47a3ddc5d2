//! Second methods by differences and by quadrature.

use dalembert_core::Worksheet;
use dalembert_mechanics::{Real, rigid};
use dalembert_numerics::quadrature;
use nalgebra::Vector3;

/// The second derivative at `t = 0` of a vector that is known at every time; `period` as in [`rigid::numerical_rate`].
pub(crate) fn second_rate(vector: impl Fn(f64) -> Vector3<f64>, period: f64) -> Option<Vector3<f64>> {
    let lost = Vector3::repeat(f64::NAN);
    let first = |t: f64| rigid::numerical_rate(|s| vector(t + s), period).unwrap_or(lost);
    rigid::numerical_rate(first, period).ok()
}

/// The same of a number.
pub(crate) fn second_slope(number: impl Fn(f64) -> f64, period: f64) -> Option<f64> {
    second_rate(|t| Vector3::new(number(t), 0.0, 0.0), period).map(|rate| rate.x)
}

/// Holds the moment of inertia of a disc about its axis to the sum over its rings.
pub(crate) fn check_disc<W: Worksheet>(axial: W::Num, mass: W::Num, radius: W::Num, sheet: W) {
    sheet.verify(|| {
        let radius = radius.value();
        let ring = |r: f64| 2.0 * r.powi(3) / radius.powi(2);
        let sum = mass.value() * quadrature::integral(ring, [0.0, radius], 1);
        sheet.check("moment of inertia of the disc, ring by ring", axial, sum.into());
    });
}
