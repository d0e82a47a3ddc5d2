//! Critical speeds of a rotor on its supports, and the speeds between which it is unstable.
//!
//! A zero is searched for only between two speeds at which the function differs in sign, on the reduced model first and
//! then, in a narrow range around that zero, on all equations. What cannot be refined is named and costs nothing else.

use nalgebra::{Complex, DMatrix, DVector};

use super::{
    Assembled, RotorError,
    campbell::Campbell,
    modes::{ReducedRotor, Spectrum, WhirlMode, polished},
    stiffness::{Node, Powers, Stiffness},
};
use dalembert_numerics::linalg;

/// A critical speed: a mode whose frequency is the wanted multiple of the speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Critical {
    /// Speed, rad/s.
    pub speed: f64,
    /// The mode there.
    pub mode: WhirlMode,
}

/// Critical speeds and instabilities in a range of speeds, and the part of the range that could not be resolved.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Criticals {
    /// By ascending speed.
    pub found: Vec<Critical>,
    /// Speeds (rad/s) near which there is another one that could not be refined on all equations.
    pub lost: Vec<f64>,
}

/// Speeds between which a mode grows.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Start of the band; `None` where a mode is unstable at the lowest speed already.
    pub from: Option<Critical>,
    /// End of the band; `None` where a mode is still unstable at the highest speed.
    pub to: Option<Critical>,
}

/// Speed ranges in which a rotor is unstable.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Instability {
    /// By ascending speed.
    pub bands: Vec<Band>,
    /// Speeds near which an end of a band could not be refined on all equations.
    pub lost: Vec<f64>,
    /// The number of speeds that were examined.
    pub examined: usize,
}

/// A mode that grows by less than this share of its eigenvalue in a reduced model neither grows nor decays: several
/// times what the eigenvalues of a full matrix lose.
pub const NEUTRAL: f64 = 1e-9;

impl Criticals {
    fn sorted(mut self) -> Self {
        self.found.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        self.lost.sort_by(f64::total_cmp);
        self
    }
}

/// The critical speeds of a conservative rotor up to a speed, the lowest of them, as many as the reduced model has
/// modes; without going over the speeds.
///
/// With `ω = s Ω` the equations of free whirl are `(K − ω²(M − iG/s)) v = 0`, a Hermitian eigenproblem for any
/// slope `s` of the line. `M − iG/s` is not positive where polar inertia prevails; such whirl has no critical speed.
///
/// # Errors
/// `Buckled` where `K` is not positive; `Linalg`.
pub fn direct(reduced: &ReducedRotor<'_>, slope: f64, highest: f64) -> Result<Criticals, RotorError> {
    let (stiffness, _) = reduced.matrices(0.0);
    let n = stiffness.nrows();
    let m = n / 2;
    // In units in which the shapes on their mean bearings have a stiffness of one, what is left of a soft one shows.
    let unit = |i: usize| 1.0 / reduced.frequencies()[i % m];
    let scaled = DMatrix::from_fn(n, n, |i, j| stiffness[(i, j)] * (unit(i) * unit(j)));
    let eigen = linalg::symmetric_eigen(&scaled)?;
    let rounding = f64::EPSILON * n as f64 * scaled.amax();
    if eigen.values.iter().any(|&value| value <= rounding) {
        return Err(RotorError::Buckled);
    }
    // Coordinates in which the stiffness is one.
    let whole = DMatrix::from_fn(n, n, |i, j| unit(i) * eigen.vectors[(i, j)] / eigen.values[j].sqrt());
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
    let mut all = Criticals::default();
    // Largest first: they belong to the lowest speeds. Equal frequencies of both planes stand four times.
    let mut basis: Vec<DVector<Complex<f64>>> = Vec::new();
    for at in (0..2 * n).rev() {
        let value = pairs.values[at];
        if value <= 0.0 || all.found.len() + all.lost.len() == reduced.count {
            break;
        }
        let frequency = value.sqrt().recip();
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
        match whirl(reduced.rotor, &mode, slope) {
            Some(mode) => all.found.push(Critical { speed: mode.lambda.im / slope, mode }),
            None => all.lost.push(frequency / slope),
        }
    }
    all.found.retain(|critical| critical.speed <= highest);
    Ok(all.sorted())
}

/// The free whirl `(K − ω²N) v = 0`, `N = M − iG/s`, nearest to a mode of a reduced model: inverse iteration on all
/// equations, its frequency by the Rayleigh quotient, which errs by the square of the error of the shape.
fn whirl(rotor: &Assembled, mode: &WhirlMode, slope: f64) -> Option<WhirlMode> {
    // The larger shifts are for short elements on soft bearings, see `modes::OFFSETS`.
    [1e-4, 1e-3, 5e-3].into_iter().find_map(|offset| shifted_whirl(rotor, mode, slope, offset))
}

fn shifted_whirl(rotor: &Assembled, mode: &WhirlMode, slope: f64, offset: f64) -> Option<WhirlMode> {
    let first = mode.lambda.im;
    let image = |shape: &[Node], omega: f64, still: f64| {
        let lambda = Complex::new(0.0, omega);
        let powers = Powers { mass: lambda * lambda, damping: lambda, stiffness: Complex::new(still, 0.0) };
        Stiffness::of(rotor, powers, omega / slope).times(shape)
    };
    let form = |shape: &[Node], image: &[Node]| -> f64 {
        shape.iter().flatten().zip(image.iter().flatten()).map(|(a, b)| (a.conj() * b).re).sum()
    };
    let mut omega = first;
    let mut shape = mode.shape.clone();
    for offset in [offset, -offset, offset] {
        // −ω²N v, and with the same sign what the inverse iteration is given.
        let near = omega * (1.0 + offset);
        let dynamic = Stiffness::new(rotor, Complex::new(0.0, near), near / slope);
        let mut next = dynamic.solve(&image(&shape, near, 0.0))?;
        let size = next.iter().flatten().map(|x| x.norm()).fold(0.0, f64::max);
        next.iter_mut().flatten().for_each(|x| *x /= size);
        shape = next;
        let inertia = -form(&shape, &image(&shape, near, 0.0)) / (near * near);
        let powers = Powers {
            mass: Complex::new(0.0, 0.0),
            damping: Complex::new(0.0, 0.0),
            stiffness: Complex::new(1.0, 0.0),
        };
        let elastic = form(&shape, &Stiffness::of(rotor, powers, 0.0).times(&shape));
        let before = omega;
        omega = (elastic / inertia).sqrt();
        // Also where it is not a number.
        let is_near = (omega - first).abs() < 1e-2 * first;
        if !is_near {
            return None;
        }
        if (omega - before).abs() < 1e-13 * omega {
            break;
        }
    }
    Some(WhirlMode { lambda: Complex::new(0.0, omega), shape, coordinates: mode.coordinates.clone() })
}

/// The critical speeds at which a natural frequency of a Campbell diagram meets the line `ω = s Ω`: where the `k`-th of
/// them by size passes it.
///
/// # Errors
/// `Linalg`, `Stopped`.
pub fn crossings(
    reduced: &ReducedRotor<'_>,
    campbell: &Campbell,
    slope: f64,
) -> Result<Criticals, RotorError> {
    let above = |mode: &WhirlMode, speed: f64| mode.frequency() - slope * speed;
    let mut all = Criticals::default();
    let mut steps: Vec<(Spectrum, Spectrum)> =
        campbell.spectra.windows(2).map(|pair| (pair[0].clone(), pair[1].clone())).collect();
    let narrow = 1e-3 * campbell.speeds.last().copied().unwrap_or(0.0);
    while let Some((left, right)) = steps.pop() {
        // A motion that begins or ends to swing changes the places of all others.
        let even = left.modes.len() == right.modes.len() && left.overdamped.len() == right.overdamped.len();
        if !even && right.speed - left.speed > narrow {
            let middle = reduced.modes(0.5 * (left.speed + right.speed))?;
            steps.push((left, middle.clone()));
            steps.push((middle, right));
            continue;
        }
        for (k, (one, other)) in left.modes.iter().zip(&right.modes).enumerate() {
            let ends = [(left.speed, above(one, left.speed)), (right.speed, above(other, right.speed))];
            if (ends[0].1 > 0.0) == (ends[1].1 > 0.0) {
                continue;
            }
            let at = |speed: f64| Ok(reduced.modes(speed)?.modes.into_iter().nth(k));
            let found = zero(reduced, ends, at, above, |lambda, speed| lambda.im - slope * speed)?;
            match found {
                Found::Refined(critical) => all.found.push(critical),
                Found::Lost(speed) => all.lost.push(speed),
                Found::Jump => {}
            }
        }
    }
    Ok(all.sorted())
}

/// The speeds between which a mode grows. Between the speeds of a diagram others are examined wherever the growth bends
/// so much that it could pass zero there and come back.
///
/// # Errors
/// `Linalg`, `Stopped`.
pub fn instability(reduced: &ReducedRotor<'_>, campbell: &Campbell) -> Result<Instability, RotorError> {
    // Where the last of the lowest modes is one of a pair, either may be the one that is examined, and what grows would
    // come and go: then more of them are.
    for more in 0..MOST_MORE {
        let (found, settled) = bands(reduced, campbell, reduced.count + more)?;
        if settled {
            return Ok(found);
        }
    }
    Ok(bands(reduced, campbell, reduced.count + MOST_MORE)?.0)
}

/// So many modes more are examined for stability at most.
const MOST_MORE: usize = 4;

/// The bands of the lowest modes, and whether every change of sign was a zero.
fn bands(
    reduced: &ReducedRotor<'_>,
    campbell: &Campbell,
    count: usize,
) -> Result<(Instability, bool), RotorError> {
    let mut settled = true;
    let of = |spectrum: &Spectrum| (spectrum.speed, growth(most_unstable(spectrum)));
    let look = |speed: f64| Ok::<_, RotorError>(of(&reduced.lowest(speed, count)?));
    let mut seen: Vec<(f64, f64)> = if count == reduced.count {
        campbell.spectra.iter().map(of).collect()
    } else {
        campbell.speeds.iter().map(|&speed| look(speed)).collect::<Result<_, _>>()?
    };
    let mut steps: Vec<([(f64, f64); 2], u8)> =
        seen.windows(2).map(|pair| ([pair[0], pair[1]], BISECTIONS)).collect();
    while let Some(([left, right], depth)) = steps.pop() {
        let middle = look(0.5 * (left.0 + right.0))?;
        seen.push(middle);
        let bend = (middle.1 - 0.5 * (left.1 + right.1)).abs();
        let nearest = left.1.abs().min(middle.1.abs()).min(right.1.abs());
        if depth > 0 && bend > 0.5 * nearest && bend > NEUTRAL && seen.len() < MOST_EXAMINED {
            steps.extend([([left, middle], depth - 1), ([middle, right], depth - 1)]);
        }
    }
    seen.sort_by(|a, b| a.0.total_cmp(&b.0));

    let mut all = Instability { examined: seen.len(), ..Instability::default() };
    let mut open: Option<Option<Critical>> = seen.first().filter(|(_, g)| *g > 0.0).map(|_| None);
    for pair in seen.windows(2) {
        let ends = [pair[0], pair[1]];
        if (ends[0].1 > 0.0) == (ends[1].1 > 0.0) {
            continue;
        }
        let at = |speed: f64| Ok(most_unstable(&reduced.lowest(speed, count)?).cloned());
        let function = |mode: &WhirlMode, _| growth(Some(mode));
        let end = match zero(reduced, ends, at, function, |lambda, _| lambda.re)? {
            Found::Refined(critical) => Some(critical),
            Found::Lost(speed) => {
                settled = false;
                all.lost.push(speed);
                None
            }
            Found::Jump => {
                settled = false;
                all.lost.push(0.5 * (ends[0].0 + ends[1].0));
                None
            }
        };
        match open.take() {
            None => open = Some(end),
            Some(from) => all.bands.push(Band { from, to: end }),
        }
    }
    if let Some(from) = open {
        all.bands.push(Band { from, to: None });
    }
    Ok((all, settled))
}

/// A step between two speeds of a diagram is divided so many times at most.
const BISECTIONS: u8 = 6;

/// So many speeds are examined for stability at most.
const MOST_EXAMINED: usize = 250;

/// The mode that grows most, or decays least, over the size of its eigenvalue.
fn most_unstable(spectrum: &Spectrum) -> Option<&WhirlMode> {
    spectrum.modes.iter().max_by(|a, b| growth(Some(a)).total_cmp(&growth(Some(b))))
}

/// Relative growth rate of a mode, Re s over |s|; below zero where rounding could be the reason.
fn growth(mode: Option<&WhirlMode>) -> f64 {
    mode.map_or(-1.0, |mode| mode.lambda.re / mode.lambda.norm() - NEUTRAL)
}

/// Result of refining a change of sign.
enum Found {
    Refined(Critical),
    /// A zero of the reduced model near this speed has none on all equations beside it.
    Lost(f64),
    /// The function jumps.
    Jump,
}

/// The zero of a function of a mode and the speed between two speeds where its signs differ.
fn zero(
    reduced: &ReducedRotor<'_>,
    ends: [(f64, f64); 2],
    mode_at: impl Fn(f64) -> Result<Option<WhirlMode>, RotorError>,
    rough: impl Fn(&WhirlMode, f64) -> f64,
    exact: impl Fn(Complex<f64>, f64) -> f64,
) -> Result<Found, RotorError> {
    let highest = ends[1].0;
    let mut latest = None;
    let [left, right] = working_of(ends, 1e-10 * highest, |speed| {
        let Some(mode) = mode_at(speed)? else { return Ok(f64::NAN) };
        let value = rough(&mode, speed);
        latest = Some((speed, mode));
        Ok(value)
    })?;
    let size = ends[0].1.abs().max(ends[1].1.abs());
    if left.1.abs().min(right.1.abs()) > 1e-3 * size {
        return Ok(Found::Jump);
    }
    let guess = if left.1.abs() < right.1.abs() { left.0 } else { right.0 };
    let mode = match latest {
        Some((speed, mode)) if speed == guess => Some(mode),
        _ => mode_at(guess)?,
    };
    let Some(mut mode) = mode else { return Ok(Found::Lost(guess)) };
    // On all equations the zero lies a little beside: the range around it is widened until the signs differ.
    let mut at = |speed: f64| -> Result<f64, RotorError> {
        mode = polished(reduced.rotor, &mode, speed)?.mode;
        Ok(exact(mode.lambda, speed))
    };
    // A zero at standstill has no size of its own.
    let size = guess.max(1e-8 * highest);
    let mut width = 1e-8 * size;
    let around = loop {
        let (from, to) = ((guess - width).max(ends[0].0), (guess + width).min(ends[1].0));
        let (Ok(f), Ok(g)) = (at(from), at(to)) else { return Ok(Found::Lost(guess)) };
        if (f > 0.0) != (g > 0.0) {
            break [(from, f), (to, g)];
        }
        width *= 30.0;
        if width > 0.02 * size {
            return Ok(Found::Lost(guess));
        }
    };
    let Ok([left, right]) = working_of(around, 1e-14 * guess, &mut at) else { return Ok(Found::Lost(guess)) };
    let speed = if left.1.abs() < right.1.abs() { left.0 } else { right.0 };
    Ok(match polished(reduced.rotor, &mode, speed) {
        Ok(polished) => Found::Refined(Critical { speed, mode: polished.mode }),
        Err(_) => Found::Lost(guess),
    })
}

/// Narrows a range whose ends differ in sign: by the straight line between them, one end's value halved where it stays
/// (Illinois), and by bisection where that does not halve the range twice in a row.
fn working_of(
    mut ends: [(f64, f64); 2],
    width: f64,
    mut function: impl FnMut(f64) -> Result<f64, RotorError>,
) -> Result<[(f64, f64); 2], RotorError> {
    let mut weights = [1.0, 1.0];
    let mut kept = usize::MAX;
    for step in 0..100 {
        let [(a, fa), (b, fb)] = ends;
        if b - a <= width || fa == 0.0 || fb == 0.0 {
            break;
        }
        let (wa, wb) = (fa * weights[0], fb * weights[1]);
        let line = a + (b - a) * (wa / (wa - wb));
        let middle = 0.5 * (a + b);
        let next = if step % 4 == 3 || !(line > a && line < b) { middle } else { line };
        if next <= a || next >= b {
            break;
        }
        // So near to the zero the step goes beyond it on purpose, so that the other end follows.
        let next = next.clamp(a + 0.25 * width, b - 0.25 * width);
        let value = function(next)?;
        let end = usize::from((value > 0.0) == (fb > 0.0));
        ends[end] = (next, value);
        weights[end] = 1.0;
        weights[1 - end] = if kept == 1 - end { 0.5 * weights[1 - end] } else { 1.0 };
        kept = 1 - end;
    }
    Ok(ends)
}
