//! Least squares of a decay, compared with what makes them least: the differences are orthogonal to every change of the curve.

use dalembert_core::Worksheet;

/// Residuals of the amplitudes about the curve of a decrement and a friction loss.
struct Differences {
    /// Sum of the products with the change of the curve, over the size of that change, for decrement and loss; zero for
    /// a parameter that is not free.
    slopes: [f64; 2],
    /// Root mean square.
    scatter: f64,
    /// The largest amplitude.
    size: f64,
}

impl Differences {
    /// The first amplitude, in which the curve is linear, is the best one for that decrement and loss.
    fn of(points: &[(f64, f64)], [decrement, loss]: [f64; 2]) -> Self {
        let start = points.iter().map(|point| point.0).fold(f64::INFINITY, f64::min);
        let size = points.iter().map(|point| point.1).fold(0.0, f64::max);
        let falls = |cycles: f64| (-decrement * cycles).exp();
        let lag = |cycles: f64| {
            if decrement == 0.0 { cycles } else { -(-decrement * cycles).exp_m1() / decrement }
        };
        let rows: Vec<[f64; 2]> = points.iter().map(|point| [point.0 - start, point.1]).collect();
        let [over, under] = rows.iter().fold([0.0; 2], |[over, under], &[cycles, amplitude]| {
            let fall = falls(cycles);
            [over + fall * (amplitude + loss * lag(cycles)), under + fall * fall]
        });
        let initial = over / under;
        let difference =
            |[cycles, amplitude]: [f64; 2]| amplitude + loss * lag(cycles) - initial * falls(cycles);
        // Of the lag over the decrement: ∫τe^(−δτ)dτ, the part of a friction that began later.
        let later = |cycles: f64| {
            let y = decrement * cycles;
            if y < 1e-3 {
                cycles * cycles * (0.5 - y / 3.0 + y * y / 8.0 - y * y * y / 30.0)
            } else {
                (lag(cycles) - cycles * falls(cycles)) / decrement
            }
        };
        let by_decrement = |cycles: f64| loss * later(cycles) - initial * cycles * falls(cycles);
        let orthogonal = |change: &dyn Fn(f64) -> f64| {
            let [sum, scale] = rows.iter().fold([0.0; 2], |[sum, scale], &row| {
                [sum + change(row[0]) * difference(row), scale + change(row[0]).abs()]
            });
            sum / (scale * size)
        };
        let slopes = [
            if decrement == 0.0 { 0.0 } else { orthogonal(&by_decrement) },
            if loss == 0.0 { 0.0 } else { orthogonal(&lag) },
        ];
        let squares: f64 = rows.iter().map(|&row| difference(row).powi(2)).sum();
        Self { slopes, scatter: (squares / points.len() as f64).sqrt(), size }
    }
}

/// Holds decrement and loss, and the root mean square that they leave.
pub(super) fn check<W: Worksheet>(
    [slopes, left]: [&'static str; 2],
    points: &[(f64, f64)],
    parameters: [f64; 2],
    scatter: f64,
    sheet: W,
) {
    check_slopes(slopes, points, parameters, sheet);
    check_scatter(left, points, parameters, scatter, sheet);
}

/// Holds decrement and loss to the normal equations of the amplitudes.
pub(super) fn check_slopes<W: Worksheet>(
    what: &'static str,
    points: &[(f64, f64)],
    parameters: [f64; 2],
    sheet: W,
) {
    sheet.check_zeros(what, Differences::of(points, parameters).slopes, 1.0);
}

/// Holds a root mean square to the differences themselves.
pub(super) fn check_scatter<W: Worksheet>(
    what: &'static str,
    points: &[(f64, f64)],
    parameters: [f64; 2],
    scatter: f64,
    sheet: W,
) {
    let other = Differences::of(points, parameters);
    // What fits to the last places leaves rounding alone.
    let rounding = 1e-14 * other.size;
    let residual = W::Num::from(scatter - other.scatter);
    let left = scatter.max(other.scatter);
    sheet.check_residual(what, residual, if left > rounding { left } else { other.size }, rounding);
}
