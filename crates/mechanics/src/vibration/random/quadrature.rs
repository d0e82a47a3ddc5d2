//! Integrals of resonant functions over frequency.

/// Reason for which an integral was not found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum QuadratureError {
    /// The function is NaN or infinite somewhere.
    #[error("the function under the integral is not finite")]
    NotFinite,
    /// The parts reached their limit.
    #[error("the integral did not converge")]
    NotConverged,
}

/// Half of the nodes of the Kronrod rule of 15 points, its weights, and those of the Gauss rule of 7 inside it.
const KRONROD: [(f64, f64, f64); 8] = [
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_224, 0.0),
    (0.949_107_912_342_758_5, 0.063_092_092_629_978_56, 0.129_484_966_168_869_7),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_19, 0.0),
    (0.741_531_185_599_394_4, 0.140_653_259_715_525_92, 0.279_705_391_489_276_64),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9, 0.0),
    (0.405_845_151_377_397_2, 0.190_350_578_064_785_4, 0.381_830_050_505_118_9),
    (0.207_784_955_007_898_47, 0.204_432_940_075_298_9, 0.0),
    (0.0, 0.209_482_141_084_727_82, 0.417_959_183_673_469_4),
];
/// The difference of the two rules, relative to the integral, at which it counts as found. The finer rule is then far
/// nearer.
const TOLERANCE: f64 = 1e-10;
/// The most parts.
const MOST_PARTS: usize = 2000;

/// The integral between the least and the largest of some points, which are its first parts, by halving the part
/// of the largest error (Gauss–Kronrod 7–15; Piessens et al., *QUADPACK*, 1983). The last point may be infinite for a
/// function that falls at least as `1/x²`; the point before it must then be above zero.
///
/// # Errors
/// `NotFinite`; `NotConverged` after 2000 parts.
pub fn integrate(function: impl Fn(f64) -> f64, points: &[f64]) -> Result<f64, QuadratureError> {
    let mut points = points.to_vec();
    points.sort_by(f64::total_cmp);
    points.dedup();
    // The tail runs over 1/x.
    let tail = match points.last() {
        Some(&last) if last.is_infinite() => {
            points.pop();
            points.last().map(|&from| 1.0 / from)
        }
        _ => None,
    };
    let over_tail = |t: f64| if t == 0.0 { 0.0 } else { function(1.0 / t) / (t * t) };
    let mut parts: Vec<QuadratureInterval> =
        points.windows(2).map(|pair| QuadratureInterval::new(&function, pair[0], pair[1], false)).collect();
    parts.extend(tail.map(|tail| QuadratureInterval::new(&over_tail, 0.0, tail, true)));
    while parts.len() < MOST_PARTS {
        let total: f64 = parts.iter().map(|part| part.value).sum();
        let error: f64 = parts.iter().map(|part| part.error).sum();
        if !total.is_finite() {
            return Err(QuadratureError::NotFinite);
        }
        if error <= TOLERANCE * total.abs() {
            return Ok(total);
        }
        let worst = parts.iter().enumerate().max_by(|a, b| a.1.error.total_cmp(&b.1.error));
        let Some((n, part)) = worst.map(|(n, part)| (n, *part)) else { return Ok(0.0) };
        let middle = 0.5 * (part.from + part.to);
        let halves = [(part.from, middle), (middle, part.to)].map(|(from, to)| {
            if part.tail {
                QuadratureInterval::new(&over_tail, from, to, true)
            } else {
                QuadratureInterval::new(&function, from, to, false)
            }
        });
        parts.swap_remove(n);
        parts.extend(halves);
    }
    Err(QuadratureError::NotConverged)
}

/// The same integral over finite points by a rule of fixed panels in `t`, `x = centre + width sinh t`, which spreads a
/// resonance out: a second method.
pub fn integrate_about(function: impl Fn(f64) -> f64, points: &[f64], [centre, width]: [f64; 2]) -> f64 {
    let to_t = |x: f64| ((x - centre) / width).asinh();
    let mut sum = 0.0;
    for pair in points.windows(2) {
        let (from, to) = (to_t(pair[0]), to_t(pair[1]));
        let panels = ((to - from) * 8.0).ceil().max(4.0);
        let size = (to - from) / panels;
        for n in 0..panels as usize {
            let middle = from + size * (n as f64 + 0.5);
            let at = |t: f64| function(centre + width * t.sinh()) * width * t.cosh();
            sum += 0.5 * size * kronrod(&at, middle, 0.5 * size).0;
        }
    }
    sum
}

#[derive(Clone, Copy)]
struct QuadratureInterval {
    from: f64,
    to: f64,
    value: f64,
    error: f64,
    tail: bool,
}

impl QuadratureInterval {
    fn new(function: &impl Fn(f64) -> f64, from: f64, to: f64, tail: bool) -> Self {
        let half = 0.5 * (to - from);
        let (kronrod, gauss) = kronrod(function, 0.5 * (from + to), half);
        Self { from, to, value: kronrod * half, error: ((kronrod - gauss) * half).abs(), tail }
    }
}

/// The two rules over `middle ± half`, for a half width of one.
fn kronrod(function: &impl Fn(f64) -> f64, middle: f64, half: f64) -> (f64, f64) {
    let mut sums = (0.0, 0.0);
    for (node, fine, coarse) in KRONROD {
        let value = if node == 0.0 {
            function(middle)
        } else {
            function(middle - half * node) + function(middle + half * node)
        };
        sums.0 += fine * value;
        sums.1 += coarse * value;
    }
    sums
}
