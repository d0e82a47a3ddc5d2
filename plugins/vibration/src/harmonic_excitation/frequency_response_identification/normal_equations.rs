//! The normal equations of the complex least squares, in the numbers that are answered.

use dalembert_mechanics::identification::modal::{Complex, DampingModel, MeasuredResponse, ResponsePoint};

/// The normal equations of natural frequency, damping, modal constant and residuals, each over the sizes of its derivative
/// and of its own part of the response: zero where the sum of squares is least.
pub(super) fn normal_equations(
    points: &[ResponsePoint],
    response: MeasuredResponse,
    model: DampingModel,
    answered: &[f64],
) -> Vec<f64> {
    // The sum of squares does not tell apart what changes it by less than its own rounding.
    const BLIND: f64 = 6e-8;
    let [natural, damping, constant] = [answered[0], answered[1], answered[2]];
    let [stiffness, mass] = [3, 4].map(|n| answered.get(n).copied().unwrap_or(0.0));
    let mut rows: Vec<([Complex<f64>; 5], Complex<f64>)> = Vec::with_capacity(points.len());
    let mut measured = 0.0;
    for &(frequency, value) in points {
        // Receptance, mobility or accelerance, as it was measured.
        let factor = match response {
            MeasuredResponse::Receptance => Complex::new(1.0, 0.0),
            MeasuredResponse::Mobility => Complex::new(0.0, frequency),
            MeasuredResponse::Accelerance => Complex::new(-frequency * frequency, 0.0),
        };
        // ∂d/∂ωₙ and ∂d/∂ζ or ∂d/∂η of the term i d of the damping.
        let (loss, by_natural, by_damping) = match model {
            DampingModel::Viscous => {
                (2.0 * damping * natural * frequency, 2.0 * damping * frequency, 2.0 * natural * frequency)
            }
            DampingModel::Hysteretic => {
                (damping * natural * natural, 2.0 * damping * natural, natural * natural)
            }
        };
        let one = 1.0 / Complex::new(natural * natural - frequency * frequency, loss);
        let square = frequency * frequency;
        let fitted = one * constant + stiffness - mass / square;
        let derivatives = [
            -one * one * constant * Complex::new(2.0 * natural, by_natural),
            -one * one * constant * Complex::new(0.0, by_damping),
            one,
            Complex::new(1.0, 0.0),
            Complex::new(-1.0 / square, 0.0),
        ];
        rows.push((derivatives.map(|part| part * factor), fitted * factor - value));
        measured += value.norm_sqr();
    }
    let measured: f64 = measured.sqrt();
    let left = rows.iter().map(|(_, off)| off.norm_sqr()).sum::<f64>().sqrt();
    let equation = |(n, number): (usize, &f64)| {
        let product: f64 = rows.iter().map(|(parts, off)| (off.conj() * parts[n]).re).sum();
        let size = rows.iter().map(|(parts, _)| parts[n].norm_sqr()).sum::<f64>().sqrt();
        let beyond = (product.abs() - BLIND * left * size).max(0.0);
        beyond / (size * (size * number.abs()).clamp(0.01 * measured, measured))
    };
    answered.iter().enumerate().map(equation).collect()
}
