//! Speeds at which a multiple of the speed meets a natural frequency, and the speed at which a rotor turns unstable.

use nalgebra::{Complex, DMatrix, DVector};

use super::{
    Assembled, RotorError,
    campbell::Campbell,
    modes::{Mode, Reduced, polished},
    stiffness::Stiffness,
};
use crate::linalg::{self, LinalgError};

/// A critical speed: a mode whose frequency is the wanted multiple of the speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Critical {
    /// Speed, rad/s.
    pub speed: f64,
    /// The mode there.
    pub mode: Mode,
}

/// The critical speeds of a conservative rotor up to a speed, the lowest of them, as many as the reduced model has
/// modes; without going over the speeds.
///
/// With `ω = s Ω` the equations of free whirl are `(K − ω²(M − iG/s)) v = 0`, a Hermitian eigenproblem for any
/// slope `s` of the line. `M − iG/s` is not positive where polar inertia prevails; such whirl has no critical speed.
///
/// # Errors
/// `Buckled` where `K` is not positive; `Linalg`.
pub fn direct(reduced: &Reduced<'_>, slope: f64, highest: f64) -> Result<Vec<Critical>, RotorError> {
    let (stiffness, _) = reduced.matrices(0.0);
    let n = stiffness.nrows();
    let m = n / 2;
    let scale = stiffness.amax();
    let eigen = linalg::symmetric_eigen(&(stiffness / scale))?;
    if eigen.values.iter().any(|&value| value <= 0.0) {
        return Err(RotorError::Buckled);
    }
    // Coordinates in which the stiffness is one.
    let whole = DMatrix::from_fn(n, n, |i, j| eigen.vectors[(i, j)] / eigen.values[j].sqrt());
    let mut gyroscopic = DMatrix::zeros(n, n);
    for i in 0..m {
        for j in 0..m {
            gyroscopic[(i, m + j)] = reduced.gyroscopic()[(i, j)] / slope;
            gyroscopic[(m + i, j)] = -reduced.gyroscopic()[(i, j)] / slope;
        }
    }
    let mass = whole.tr_mul(&whole);
    let cross = whole.tr_mul(&(gyroscopic * &whole));
    // A Hermitian matrix A − iB as the real symmetric [[A, B], [−B, A]]: every eigenvalue comes twice.
    let double = DMatrix::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
        (true, true) => mass[(i, j)],
        (false, false) => mass[(i - n, j - n)],
        (true, false) => 0.5 * (cross[(i, j - n)] - cross[(j - n, i)]),
        (false, true) => -0.5 * (cross[(i - n, j)] - cross[(j, i - n)]),
    });
    let pairs = linalg::symmetric_eigen(&double)?;
    let mut found: Vec<Critical> = Vec::new();
    // Largest first: they belong to the lowest speeds. Equal frequencies of both planes stand four times.
    let mut basis: Vec<DVector<Complex<f64>>> = Vec::new();
    for at in (0..2 * n).rev() {
        let value = pairs.values[at];
        if value <= 0.0 || found.len() == reduced.count {
            break;
        }
        let frequency = (scale / value).sqrt();
        if frequency / slope > highest * (1.0 + 1e-6) {
            break;
        }
        let column = pairs.vectors.column(at);
        let mut vector = DVector::from_fn(n, |i, _| Complex::new(column[i], column[n + i]));
        for other in &basis {
            let share = other.dotc(&vector);
            vector.axpy(-share, other, Complex::new(1.0, 0.0));
        }
        let left = vector.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
        if left < 0.5 {
            continue;
        }
        vector /= Complex::new(left, 0.0);
        let coordinates = whole.map(|x| Complex::new(x, 0.0)) * &vector;
        basis.push(vector);
        let mode = reduced.mode(Complex::new(0.0, frequency), &coordinates);
        found.push(refined(reduced.rotor, frequency / slope, mode, slope)?);
    }
    found.retain(|critical| critical.speed <= highest);
    found.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    Ok(found)
}

/// The frequency of a critical speed of a conservative rotor from its shape alone, by the quotient of Rayleigh on all
/// equations: `ω² = vᴴ K v/vᴴ (M − iG/s) v`, rad/s.
pub fn rayleigh_frequency(rotor: &Assembled, critical: &Critical, slope: f64) -> f64 {
    let shape = &critical.mode.shape;
    let form = |lambda: Complex<f64>, speed: f64| {
        let image = Stiffness::new(rotor, lambda, speed).times(shape);
        shape.iter().flatten().zip(image.iter().flatten()).map(|(a, b)| (a.conj() * b).re).sum::<f64>()
    };
    // At λ = iω the dynamic stiffness is K − ω²M + iωΩG.
    let omega = critical.mode.lambda.im;
    let elastic = form(Complex::new(0.0, 0.0), 0.0);
    let still = form(Complex::new(0.0, omega), 0.0);
    let spinning = form(Complex::new(0.0, omega), omega / slope);
    omega * (elastic / (elastic - still - (spinning - still))).sqrt()
}

/// The critical speeds that a Campbell diagram shows: where a branch crosses the line `ω = s Ω`.
///
/// # Errors
/// `Linalg`.
pub fn crossings(
    reduced: &Reduced<'_>,
    campbell: &Campbell,
    slope: f64,
) -> Result<Vec<Critical>, RotorError> {
    let above = |mode: &Mode, speed: f64| mode.frequency() - slope * speed;
    let mut found = on_branches(reduced, campbell, above)?
        .into_iter()
        .map(|(speed, mode)| refined(reduced.rotor, speed, mode, slope))
        .collect::<Result<Vec<_>, _>>()?;
    found.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    Ok(found)
}

/// The lowest speed at which a mode begins to grow, and that mode; `None` where none does. A rotor that is unstable
/// at the first speed has its threshold there.
///
/// # Errors
/// `Linalg`.
pub fn threshold(reduced: &Reduced<'_>, campbell: &Campbell) -> Result<Option<Critical>, RotorError> {
    let growth = |mode: &Mode, _| mode.lambda.re / mode.lambda.norm() - 1e-10;
    let at_first = campbell
        .branches
        .iter()
        .filter_map(|branch| branch.first()?.as_ref())
        .find(|mode| growth(mode, 0.0) > 0.0);
    if let (Some(mode), Some(&speed)) = (at_first, campbell.speeds.first()) {
        return Ok(Some(Critical { speed, mode: mode.clone() }));
    }
    let mut found = Vec::new();
    for (speed, mode) in on_branches(reduced, campbell, growth)? {
        let of = |lambda: Complex<f64>, _: f64| lambda.re;
        found.push(secant(reduced.rotor, speed, mode, of)?);
    }
    found.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    Ok(found.into_iter().next())
}

/// Rough places where a function of a branch and the speed changes its sign, with the mode there.
fn on_branches(
    reduced: &Reduced<'_>,
    campbell: &Campbell,
    function: impl Fn(&Mode, f64) -> f64,
) -> Result<Vec<(f64, Mode)>, RotorError> {
    let mut found = Vec::new();
    for branch in &campbell.branches {
        for (at, pair) in branch.windows(2).enumerate() {
            let [Some(left), Some(right)] = pair else { continue };
            let (from, to) = (campbell.speeds[at], campbell.speeds[at + 1]);
            let (f, g) = (function(left, from), function(right, to));
            if f == 0.0 && from > 0.0 && at == 0 {
                found.push((from, left.clone()));
            }
            if (f > 0.0) == (g > 0.0) || f == 0.0 {
                continue;
            }
            let speed = from + (to - from) * f / (f - g);
            let nearer = if speed - from < to - speed && from > 0.0 { left } else { right };
            let here = reduced.modes(speed)?.modes;
            let same = here.into_iter().max_by(|a, b| nearer.assurance(a).total_cmp(&nearer.assurance(b)));
            found.extend(same.map(|mode| (speed, mode)));
        }
    }
    Ok(found)
}

/// A critical speed to the last digits, on all equations of the rotor.
fn refined(rotor: &Assembled, speed: f64, mode: Mode, slope: f64) -> Result<Critical, RotorError> {
    secant(rotor, speed, mode, |lambda, speed| lambda.im - slope * speed)
}

/// The speed at which a function of an eigenvalue and the speed vanishes, near a first guess.
fn secant(
    rotor: &Assembled,
    speed: f64,
    mut mode: Mode,
    function: impl Fn(Complex<f64>, f64) -> f64,
) -> Result<Critical, RotorError> {
    let first = mode.lambda;
    let at = |mode: &mut Mode, speed: f64| -> Result<f64, RotorError> {
        *mode = polished(rotor, mode, speed)?;
        Ok(function(mode.lambda, speed))
    };
    let mut before = speed;
    let mut old = at(&mut mode, before)?;
    let mut here = speed * (1.0 + 1e-4);
    let mut slope = f64::NAN;
    let mut last = f64::INFINITY;
    for _ in 0..20 {
        let new = at(&mut mode, here)?;
        // So near to the zero a difference would be rounding: the slope is known well enough by then.
        if (here - before).abs() > 1e-6 * here {
            slope = (new - old) / (here - before);
        }
        let step = -new / slope;
        let strayed =
            (here + step - speed).abs() > 0.5 * speed || (mode.lambda - first).norm() > first.norm();
        if !step.is_finite() || strayed {
            break;
        }
        (before, old, here) = (here, new, here + step);
        // What does not shrink any more is rounding.
        let settled = step.abs() <= 1e-12 * here || (step.abs() <= 1e-8 * here && step.abs() > 0.5 * last);
        if settled {
            at(&mut mode, here)?;
            return Ok(Critical { speed: here, mode });
        }
        last = step.abs();
    }
    Err(LinalgError::NotConverged.into())
}
