//! Identification of the damping of a free decay: its turning points fitted with an exponential (viscous), a straight
//! line (Coulomb), and both together.
//!
//! Viscous damping takes a share `δ` of the amplitude in each cycle, friction a fixed piece `4F/k`. Together
//! `dX/dn = −(δ X + d)`, whose solution `X = X₀ e^(−δn) − d (1 − e^(−δn))/δ` passes exactly through the turning
//! points of every such decay, `n` being counted in cycles; then `F/k = (d/δ) tanh(δ/4)`.

use nalgebra::{DMatrix, DVector};

use dalembert_numerics::linalg;

/// A fitted decay, `X = X₀ e^(−δn) − d (1 − e^(−δn))/δ`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DecayFit {
    /// `X₀`, the amplitude at `n = 0`.
    pub initial: f64,
    /// `δ`, logarithmic decrement of the viscous part.
    pub decrement: f64,
    /// `d`, what friction takes in a cycle where nothing else does.
    pub loss: f64,
    /// Root mean square of the differences, in the unit of the amplitudes.
    pub scatter: f64,
    /// The normal equations, each over the size of its terms: zero but for rounding. Zero, too, where a bound holds
    /// the parameter.
    pub normal_equations: [f64; 3],
}

/// Reason for which a decay has no fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum DecayFitError {
    /// Fewer than three points, or a number that is not finite, or an amplitude that is not positive.
    #[error("at least three points with positive amplitudes are needed")]
    Points,
    /// The amplitudes do not fall.
    #[error("the amplitudes do not fall with the cycles")]
    NotDecaying,
}

/// The three fits of one decay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DecayFits {
    /// Viscous damping alone: an exponential.
    pub viscous: DecayFit,
    /// Friction alone: a straight line.
    pub friction: DecayFit,
    /// Both.
    pub both: DecayFit,
}

/// Least squares of amplitudes `(n, X)`, `n` in cycles: every fit minimises the sum of the squares of the differences
/// of the amplitudes themselves, so that their scatters can be compared.
///
/// # Errors
/// [`DecayFitError`] says what is wrong with the points.
pub fn fit(points: &[(f64, f64)]) -> Result<DecayFits, DecayFitError> {
    let good = |&(n, x): &(f64, f64)| n.is_finite() && x.is_finite() && x > 0.0;
    if points.len() < 3 || !points.iter().all(good) {
        return Err(DecayFitError::Points);
    }
    // Amplitudes in units of the largest, cycles in units of their span.
    let start = points.iter().fold(f64::INFINITY, |least, point| least.min(point.0));
    let span = points.iter().fold(0.0f64, |most, point| most.max(point.0 - start));
    let size = points.iter().fold(0.0f64, |most, point| most.max(point.1));
    if !(span > 0.0 && span.is_finite()) {
        return Err(DecayFitError::Points);
    }
    let scaled: Vec<(f64, f64)> = points.iter().map(|&(n, x)| ((n - start) / span, x / size)).collect();
    let full = |model: [f64; 3]| finished(model, &scaled, points, [start, span, size]);

    let line = polished([1.0, 0.0, 0.0], [true, false, true], &scaled);
    let curve = polished([1.0, log_slope(&scaled), 0.0], [true, true, false], &scaled);
    if !(line[2] > 0.0 && curve[1] > 0.0) {
        return Err(DecayFitError::NotDecaying);
    }
    // Both: the best of several starts between the two pure fits; a bound that holds leaves a pure one.
    let mixed = [0.15, 0.5, 0.85].map(|share| {
        let from = [1.0, share * curve[1], (1.0 - share) * line[2]];
        polished(from, [true, true, true], &scaled)
    });
    let better = |a: [f64; 3], b: [f64; 3]| {
        // A second parameter that only fits rounding is none.
        if squares(&b, &scaled) + 1e-26 < squares(&a, &scaled) { b } else { a }
    };
    let permitted = mixed.into_iter().filter(|model| model[1] >= 0.0 && model[2] >= 0.0);
    let both = permitted.fold(better(line, curve), better);
    Ok(DecayFits { viscous: full(curve), friction: full(line), both: full(both) })
}

/// `X(n)` of a fit.
pub fn amplitude(fit: &DecayFit, cycles: f64) -> f64 {
    at(&[fit.initial, fit.decrement, fit.loss], cycles)
}

/// The decrement by least squares of `ln X = ln X₀ − δ n`, `n` in cycles. `None` where the points fix no line.
pub fn logarithmic_slope(points: &[(f64, f64)]) -> Option<f64> {
    let a = DMatrix::from_fn(points.len(), 2, |i, j| if j == 0 { 1.0 } else { -points[i].0 });
    let b = DVector::from_iterator(points.len(), points.iter().map(|point| point.1.ln()));
    linalg::least_squares(&a, &b).ok().map(|solved| solved.x[1])
}

/// A turning point of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningPoint {
    /// Time, s.
    pub time: f64,
    /// Displacement, in the unit of the record.
    pub displacement: f64,
}

/// Turning points of a record `(t, x)` with ascending times: extremes that the motion leaves by more than a share
/// of the whole range, each at the vertex of the parabola through the highest sample and its neighbours. The ends
/// of the record are not turning points.
pub fn turning_points(record: &[(f64, f64)], share: f64) -> Vec<TurningPoint> {
    let (least, most) = record.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), point| {
        (least.min(point.1), most.max(point.1))
    });
    let threshold = share * (most - least);
    if !(threshold > 0.0 && threshold.is_finite()) {
        return Vec::new();
    }
    let mut found: Vec<usize> = Vec::new();
    let (mut high, mut low) = (0, 0);
    let mut rising: Option<bool> = None;
    for (i, &(_, x)) in record.iter().enumerate() {
        if x > record[high].1 {
            high = i;
        }
        if x < record[low].1 {
            low = i;
        }
        if rising != Some(false) && record[high].1 - x > threshold {
            found.push(high);
            (rising, low, high) = (Some(false), i, i);
        } else if rising != Some(true) && x - record[low].1 > threshold {
            found.push(low);
            (rising, low, high) = (Some(true), i, i);
        }
    }
    found
        .into_iter()
        .filter(|&i| i > 0 && i + 1 < record.len())
        .map(|i| vertex(&record[i - 1..=i + 1]))
        .collect()
}

/// The vertex of the parabola through three points; the middle one where there is none.
fn vertex(three: &[(f64, f64)]) -> TurningPoint {
    let (t, x) = three[1];
    let [left, right] = [three[0], three[2]].map(|(at, value)| [at - t, value - x]);
    let [slope_left, slope_right] = [left, right].map(|[dt, dx]| dx / dt);
    let curvature = (slope_right - slope_left) / (right[0] - left[0]);
    let slope = slope_left - curvature * left[0];
    let shift = -slope / (2.0 * curvature);
    if shift.is_finite() && shift > left[0] && shift < right[0] {
        TurningPoint { time: t + shift, displacement: x + slope * shift / 2.0 }
    } else {
        TurningPoint { time: t, displacement: x }
    }
}

/// `X₀ e^(−δn) − d (1 − e^(−δn))/δ`.
fn at([initial, decrement, loss]: &[f64; 3], n: f64) -> f64 {
    initial * (-decrement * n).exp() - loss * lag(*decrement, n)
}

/// `(1 − e^(−δn))/δ`, `n` at `δ = 0`.
fn lag(decrement: f64, n: f64) -> f64 {
    if decrement == 0.0 { n } else { -(-decrement * n).exp_m1() / decrement }
}

/// `∂X/∂X₀`, `∂X/∂δ`, `∂X/∂d`.
fn slopes([initial, decrement, loss]: &[f64; 3], n: f64) -> [f64; 3] {
    let decay = (-decrement * n).exp();
    let y = decrement * n;
    // d/dδ of the lag: (n e^(−y) − lag)/δ, −n²/2 at δ = 0.
    let lag_slope = if y.abs() < 1e-4 {
        n * n * (-0.5 + y / 3.0 - y * y / 8.0)
    } else {
        (n * decay - lag(*decrement, n)) / decrement
    };
    [decay, -n * initial * decay - loss * lag_slope, -lag(*decrement, n)]
}

fn squares(model: &[f64; 3], points: &[(f64, f64)]) -> f64 {
    points.iter().map(|&(n, x)| (x - at(model, n)).powi(2)).sum()
}

/// Slope of `−ln X` over `n` by least squares.
fn log_slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = points.iter().fold([0.0; 2], |sum, &(n, x)| [sum[0] + n / count, sum[1] + x.ln() / count]);
    let [over, under] = points.iter().fold([0.0; 2], |[over, under], &(n, x)| {
        [over + (n - mean[0]) * (x.ln() - mean[1]), under + (n - mean[0]).powi(2)]
    });
    -over / under
}

/// Gauss–Newton with halved steps, over the parameters that are free.
fn polished(mut model: [f64; 3], free: [bool; 3], points: &[(f64, f64)]) -> [f64; 3] {
    let columns: Vec<usize> = (0..3).filter(|&j| free[j]).collect();
    let mut best = squares(&model, points);
    for _ in 0..60 {
        let rows: Vec<[f64; 3]> = points.iter().map(|&(n, _)| slopes(&model, n)).collect();
        let jacobian = DMatrix::from_fn(rows.len(), columns.len(), |i, j| rows[i][columns[j]]);
        let residual = DVector::from_iterator(points.len(), points.iter().map(|&(n, x)| x - at(&model, n)));
        let Ok(solved) = linalg::least_squares(&jacobian, &residual) else { break };
        let mut share = 1.0;
        let mut moved = false;
        for _ in 0..30 {
            let mut trial = model;
            for (j, &column) in columns.iter().enumerate() {
                trial[column] += share * solved.x[j];
            }
            let value = squares(&trial, points);
            if value <= best {
                moved = (0..3).any(|j| (trial[j] - model[j]).abs() > 1e-15 * trial[j].abs());
                (model, best) = (trial, value);
                break;
            }
            share /= 2.0;
        }
        if !moved {
            break;
        }
    }
    model
}

/// A model of scaled points as a fit of the points themselves.
fn finished(
    model: [f64; 3],
    scaled: &[(f64, f64)],
    points: &[(f64, f64)],
    [start, span, size]: [f64; 3],
) -> DecayFit {
    let normal_equations = [0, 1, 2].map(|j| {
        if j > 0 && model[j] == 0.0 {
            return 0.0;
        }
        let terms = scaled
            .iter()
            .map(|&(n, x)| [slopes(&model, n)[j] * (x - at(&model, n)), slopes(&model, n)[j].abs()]);
        let [sum, scale] = terms.fold([0.0; 2], |sum, term| [sum[0] + term[0], sum[1] + term[1]]);
        if scale == 0.0 { 0.0 } else { sum / scale }
    });
    // A perfect fit leaves rounding only.
    let scatter = (squares(&model, scaled) / points.len() as f64).sqrt();
    let scatter = if scatter < 1e-13 { 0.0 } else { scatter };
    let (decrement, loss) = (model[1] / span, model[2] * size / span);
    // Back from n = start to n = 0.
    let initial = at(&[model[0] * size, decrement, loss], -start);
    DecayFit { initial, decrement, loss, scatter: size * scatter, normal_equations }
}
