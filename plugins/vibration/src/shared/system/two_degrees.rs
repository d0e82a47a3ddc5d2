//! Two degrees of freedom, in closed form.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::Real;

use crate::sources::RAO;

/// Natural frequencies, ascending, and the ratio of the second coordinate to the first in each mode.
pub(crate) struct TwoModes<N> {
    pub(crate) frequencies: [N; 2],
    pub(crate) ratios: Option<[N; 2]>,
}

/// The roots of `(K₁₁ − ω² M₁)(K₂₂ − ω² M₂) − K₁₂² = 0`, with the steps; `ratio_unit` is that of the second
/// coordinate over the first.
pub(crate) fn solve<W: Worksheet>(
    masses: [W::Num; 2],
    [k11, k12, k22]: [W::Num; 3],
    ratio_unit: &'static str,
    sheet: W,
) -> Result<TwoModes<W::Num>, Refusal> {
    let unstable = || {
        Refusal::because(
            "the stiffness matrix is indefinite: the rest position is unstable and does not vibrate",
        )
    };
    if k11.value() < 0.0 || k22.value() < 0.0 {
        return Err(unstable());
    }
    let why = "Square of the frequency of one coordinate alone, the other fixed";
    let first = sheet.step(("Λ", 1), "rad^2/s^2", k11 / masses[0], why);
    let second = sheet.step(("Λ", 2), "rad^2/s^2", k22 / masses[1], why);
    let coupling = sheet.step(
        "Γ",
        "rad^4/s^4",
        k12.powi(2) / (masses[0] * masses[1]),
        "Coupling of the two coordinates",
    );
    let upper = sheet.step(
        ("λ", 2),
        "rad^2/s^2",
        (first + second) / 2.0 + (((first - second) / 2.0).powi(2) + coupling).sqrt(),
        ("det(K − λM) = 0 is (Λ₁ − λ)(Λ₂ − λ) = Γ, with λ = ω²; its larger root", RAO.at("§5.3")),
    );
    // What is left of a b − d when all of it cancels: a motion that stretches no spring.
    let product = first.value() * second.value();
    let rigid = product - coupling.value() <= 8.0 * f64::EPSILON * product;
    if rigid && product - coupling.value() < -8.0 * f64::EPSILON * product {
        return Err(unstable());
    }
    let frequency = |place: usize, square: W::Num| {
        let uncoupled = || (if place == 1 { first.min(second) } else { first.max(second) }).sqrt();
        sheet.common_error(("ω", place), "the coupling of the two coordinates neglected", uncoupled);
        sheet.step(("ω", place), "rad/s", square.sqrt(), ("Natural frequency", RAO.at("§5.3")))
    };
    let (lower, lowest) = if rigid {
        let zero = sheet.numerical(
            ("λ", 1),
            "rad^2/s^2",
            0.0,
            ("Λ₁Λ₂ = Γ: the smaller root is zero, a rigid body mode", RAO.at("§5.7")),
        );
        let still = sheet.numerical(
            ("ω", 1),
            "rad/s",
            0.0,
            "Rigid body mode: the system moves as a whole, no spring is stretched",
        );
        (zero, still)
    } else {
        let lower = sheet.step(
            ("λ", 1),
            "rad^2/s^2",
            (first * second - coupling) / upper,
            "The smaller root: the product of the two is Λ₁Λ₂ − Γ",
        );
        (lower, frequency(1, lower))
    };
    let highest = frequency(2, upper);
    let ratios = (k12.value() != 0.0).then(|| {
        [(1, lower), (2, upper)].map(|(place, square)| {
            let [own, other] = [k11 - square * masses[0], k22 - square * masses[1]];
            // The first row, unless it loses two digits more than the second by cancellation.
            if (own / k11).value().abs() >= 1e-2 * (other / k22).value().abs() {
                let why = "First row of (K − λM) φ = 0: the second amplitude over the first";
                sheet.step(("r", place), ratio_unit, own / -k12, (why, RAO.at("§5.3")))
            } else {
                let why = "Second row of (K − λM) φ = 0: the second amplitude over the first";
                sheet.step(("r", place), ratio_unit, -k12 / other, (why, RAO.at("§5.3")))
            }
        })
    });
    Ok(TwoModes { frequencies: [lowest, highest], ratios })
}
