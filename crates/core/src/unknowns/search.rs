//! Search for every value of the unknowns with which the answers are the given ones.

use std::{cmp::Ordering, ops::ControlFlow};

use dalembert_numerics::{
    extremes,
    linalg::{least_squares, symmetric_eigen},
    nonlinear::{LocalMinimum, halton, jacobian, levenberg_marquardt},
    roots,
};
use nalgebra::{DMatrix, DVector};

use crate::{Refusal, Stop};

/// The share of a given answer by which a solution may miss it.
pub(crate) const ACCEPTED: f64 = 1e-9;
/// Points at which the range of one unknown is examined.
const SCAN: usize = 400;
/// Starts of the search for several unknowns, beside the typed one.
const STARTS: u32 = 32;
/// Solutions nearer to each other than this share of themselves are one.
const SAME: f64 = 1e-7;
/// Ratio of the singular values of the Jacobian below which a combination of unknowns is not determined: its differences
/// are good to about 1e-9.
const SINGULAR: f64 = 1e-7;

/// An unknown with its range, in SI.
#[derive(Clone, Debug)]
pub(crate) struct Variable {
    pub(crate) range: [f64; 2],
    pub(super) start: Option<f64>,
    /// The values to choose from; none where every value of the range counts.
    pub(super) choices: Vec<f64>,
    /// True where equal ratios count, not equal differences.
    pub(crate) is_logarithmic: bool,
}

/// A given answer, in SI.
pub(crate) struct Target {
    pub(crate) si: f64,
    pub(crate) tolerance: Option<f64>,
}

/// Result of a search.
#[derive(Default)]
pub(crate) struct Found {
    /// The solutions, ascending.
    pub(crate) solutions: Vec<Vec<f64>>,
    /// Points examined, or starts.
    pub(crate) points: usize,
    /// The points examined of one unknown, each with the answer there; NaN where there is none.
    pub(crate) scan: Vec<(f64, f64)>,
    /// Places of the least and of the largest answer, with the answer there, for one unknown.
    pub(crate) covered: Option<[(f64, f64); 2]>,
    /// The unknowns that come nearest, and the answers there.
    pub(crate) nearest: Option<(Vec<f64>, Vec<f64>)>,
    /// A given answer that no unknown changes.
    pub(crate) without_influence: Option<usize>,
    /// Returns true if the given answers determine every unknown.
    pub(crate) is_determined: bool,
    /// Standard uncertainties of the unknowns, where every given answer has one.
    pub(crate) uncertainties: Option<Vec<f64>>,
}

/// The answers with values of the unknowns; NaN where there is none.
pub(crate) type Evaluate<'e> = dyn FnMut(&[f64]) -> Result<Vec<f64>, Refusal> + 'e;

impl Found {
    /// The size of an answer that a solution is compared with.
    pub(crate) fn size(&self, target: &Target) -> f64 {
        if target.si == 0.0 {
            self.covered.map_or(1.0, |[a, b]| a.1.abs().max(b.1.abs()))
        } else {
            target.si.abs()
        }
    }
}

impl Variable {
    /// An unknown in a range, with the value to begin with.
    pub(crate) fn new(range: [f64; 2], start: Option<f64>) -> Self {
        let is_logarithmic = range[0] > 0.0 && range[1] / range[0] > 30.0;
        let start = start.filter(|si| (range[0]..=range[1]).contains(si));
        Self { range, start, choices: Vec::new(), is_logarithmic }
    }

    /// An unknown that is one of several values.
    pub(crate) fn one_of(choices: Vec<f64>) -> Self {
        let end = |better: fn(f64, f64) -> f64| choices.iter().copied().reduce(better).unwrap_or_default();
        let range = [end(f64::min), end(f64::max)];
        Self { range, start: None, choices, is_logarithmic: false }
    }

    /// The value at a share of the range.
    pub(super) fn value(&self, share: f64) -> f64 {
        if !self.choices.is_empty() {
            let at = (share * self.choices.len() as f64) as usize;
            return self.choices[at.min(self.choices.len() - 1)];
        }
        let [from, to] = self.range;
        let value =
            if self.is_logarithmic { from * (to / from).powf(share) } else { from + (to - from) * share };
        value.clamp(from, to)
    }

    /// The share of the range at a value.
    pub(super) fn share(&self, value: f64) -> f64 {
        let [from, to] = self.range;
        if self.is_logarithmic {
            (value / from).ln() / (to / from).ln()
        } else {
            (value - from) / (to - from)
        }
    }

    /// Derivative of the value with respect to the share.
    fn slope(&self, value: f64) -> f64 {
        let [from, to] = self.range;
        if self.is_logarithmic { value * (to / from).ln() } else { to - from }
    }
}

/// Values to begin with: those typed or of a case, then points that fill the ranges.
pub(crate) fn starts(variables: &[Variable]) -> impl Iterator<Item = Vec<f64>> {
    shares(variables).into_iter().map(|shares| at(variables, &shares))
}

fn shares(variables: &[Variable]) -> Vec<Vec<f64>> {
    let first =
        variables.iter().map(|variable| variable.start.map_or(0.5, |start| variable.share(start))).collect();
    std::iter::once(first).chain((1..=STARTS).map(|n| halton(n, variables.len()))).collect()
}

fn at(variables: &[Variable], shares: &[f64]) -> Vec<f64> {
    variables.iter().zip(shares).map(|(variable, share)| variable.value(*share)).collect()
}

/// Searches the ranges.
///
/// # Errors
/// [`Refusal::Stopped`] alone.
pub(crate) fn search(
    evaluate: &mut Evaluate<'_>,
    variables: &[Variable],
    targets: &[Target],
    stop: &Stop,
) -> Result<Found, Refusal> {
    match (variables, targets) {
        ([variable], [target]) => one(evaluate, variable, target, stop),
        _ => several(evaluate, variables, targets, stop),
    }
}

fn one(
    evaluate: &mut Evaluate<'_>,
    variable: &Variable,
    target: &Target,
    stop: &Stop,
) -> Result<Found, Refusal> {
    let places: Vec<f64> = (0..=SCAN).map(|n| variable.value(n as f64 / SCAN as f64)).collect();
    let mut values = Vec::with_capacity(places.len());
    for (n, place) in places.iter().enumerate() {
        values.push(evaluate(&[*place])?[0]);
        stop.report(n + 1, places.len());
    }
    let finite = || places.iter().copied().zip(values.iter().copied()).filter(|(_, value)| value.is_finite());
    let least = finite().min_by(|a, b| a.1.total_cmp(&b.1));
    let most = finite().max_by(|a, b| a.1.total_cmp(&b.1));
    let covered = least.zip(most).map(|(least, most)| [least, most]);
    let scan = places.iter().copied().zip(values.iter().copied()).collect();
    let mut found = Found { points: places.len(), scan, covered, is_determined: true, ..Found::default() };
    if let Some([least, most]) = covered
        && most.1 - least.1 <= 1e-12 * most.1.abs().max(least.1.abs())
    {
        found.without_influence = Some(0);
        return Ok(found);
    }
    let mut stopped = None;
    let mut residual = |x: f64| match evaluate(&[x]) {
        Ok(values) => values[0] - target.si,
        Err(refusal) => {
            stopped = Some(refusal);
            f64::NAN
        }
    };
    let residuals: Vec<f64> = values.iter().map(|value| value - target.si).collect();
    let mut roots: Vec<f64> = Vec::new();
    let bracketed = |residual: &mut dyn FnMut(f64) -> f64, from: f64, to: f64, roots: &mut Vec<f64>| {
        roots.extend(roots::find(residual, [from, to], |_| ControlFlow::Continue(())).ok());
    };
    for n in 0..places.len() {
        let here = residuals[n];
        if here == 0.0 {
            roots.push(places[n]);
            continue;
        }
        if n + 1 < places.len() && here * residuals[n + 1] < 0.0 {
            bracketed(&mut residual, places[n], places[n + 1], &mut roots);
        }
        // Two roots between neighbours, or one where the answer only touches the given one.
        if n == 0 || n + 1 == places.len() {
            continue;
        }
        let sign = here.signum();
        let around = [residuals[n - 1], here, residuals[n + 1]].map(|r| r * sign);
        if around.iter().all(|r| *r > 0.0) && around[1] <= around[0] && around[1] <= around[2] {
            let near = [places[n - 1], places[n], places[n + 1]];
            let heights = around.map(|r| -r);
            let Some(nearest) = extremes::largest_about(|x| -sign * residual(x), &near, &heights) else {
                continue;
            };
            if nearest.value > 0.0 {
                bracketed(&mut residual, near[0], nearest.time, &mut roots);
                bracketed(&mut residual, nearest.time, near[2], &mut roots);
            } else {
                roots.push(nearest.time);
            }
        }
    }
    let size = found.size(target);
    roots.retain(|root| residual(*root).abs() <= ACCEPTED * size);
    if let Some(refusal) = stopped {
        return Err(refusal);
    }
    found.solutions = distinct(roots.into_iter().map(|root| vec![root]).collect());
    if let (Some(first), Some(tolerance)) = (found.solutions.first(), target.tolerance) {
        let share = variable.share(first[0]);
        let mut difference = |shares: &[f64]| {
            let value = evaluate(&[variable.value(shares[0])]).ok()?[0];
            value.is_finite().then(|| vec![value])
        };
        let rate = jacobian(&mut difference, &[share], &[target.si]).map(|rate| rate[(0, 0)]);
        found.uncertainties = rate.map(|rate| vec![(tolerance * variable.slope(first[0]) / rate).abs()]);
    }
    Ok(found)
}

fn several(
    evaluate: &mut Evaluate<'_>,
    variables: &[Variable],
    targets: &[Target],
    stop: &Stop,
) -> Result<Found, Refusal> {
    let shares = shares(variables);
    let weighted = targets.len() > variables.len() && targets.iter().all(|target| target.tolerance.is_some());
    let scales: Vec<f64> = targets
        .iter()
        .map(|target| match target.tolerance {
            Some(tolerance) if weighted => tolerance,
            _ if target.si != 0.0 => target.si.abs(),
            _ => 1.0,
        })
        .collect();
    let mut stopped = None;
    let mut residuals = |shares: &[f64]| match evaluate(&at(variables, shares)) {
        Ok(values) if values.iter().all(|value| value.is_finite()) => {
            let scaled = values.iter().zip(targets).zip(&scales);
            Some(scaled.map(|((value, target), scale)| (value - target.si) / scale).collect::<Vec<f64>>())
        }
        Ok(_) => None,
        Err(refusal) => {
            stopped = Some(refusal);
            None
        }
    };
    let mut minima: Vec<LocalMinimum> = Vec::new();
    for (n, start) in shares.iter().enumerate() {
        minima.extend(levenberg_marquardt(&mut residuals, start));
        stop.report(n + 1, shares.len());
    }
    let sum = |minimum: &LocalMinimum| minimum.residuals.iter().map(|r| r * r).sum::<f64>();
    minima.sort_by(|a, b| sum(a).total_cmp(&sum(b)));
    let mut found = Found { points: shares.len(), is_determined: true, ..Found::default() };
    let best = minima.first().cloned();
    if let Some(best) = &best {
        let reached = best.residuals.iter().zip(targets).zip(&scales);
        let reached = reached.map(|((r, target), scale)| target.si + r * scale).collect();
        found.nearest = Some((at(variables, &best.x), reached));
        if let Some(jacobian) = jacobian(&mut residuals, &best.x, &best.residuals) {
            found.without_influence = (0..targets.len()).find(|row| jacobian.row(*row).amax() == 0.0);
            found.is_determined = is_determined(&jacobian);
            found.uncertainties = uncertainties(&jacobian, targets, &scales).map(|all| {
                let slopes = variables.iter().zip(&best.x).map(|(one, share)| one.slope(one.value(*share)));
                all.iter().zip(slopes).map(|(error, slope)| error * slope.abs()).collect()
            });
        }
    }
    if let Some(refusal) = stopped {
        return Err(refusal);
    }
    let least = best.as_ref().map_or(0.0, sum);
    let accepted = minima.iter().filter(|minimum| {
        if targets.len() > variables.len() {
            // A minimum on a face of the ranges is none of the squares.
            sum(minimum) <= least * (1.0 + ACCEPTED) + ACCEPTED * ACCEPTED
                && minimum.x.iter().all(|share| *share > 0.0 && *share < 1.0)
        } else {
            minimum.residuals.iter().all(|r| r.abs() <= ACCEPTED)
        }
    });
    found.solutions = distinct(accepted.map(|minimum| at(variables, &minimum.x)).collect());
    Ok(found)
}

/// Returns true if no combination of the unknowns leaves all given answers as they are.
fn is_determined(jacobian: &DMatrix<f64>) -> bool {
    let lengths =
        DVector::from_iterator(jacobian.ncols(), jacobian.column_iter().map(|column| column.norm()));
    if lengths.min() == 0.0 {
        return false;
    }
    let even = jacobian * DMatrix::from_diagonal(&lengths.map(f64::recip));
    let product = even.transpose() * &even;
    symmetric_eigen(&product).is_ok_and(|eigen| eigen.values.min() > SINGULAR.powi(2) * eigen.values.max())
}

/// Standard uncertainties of the shares: the roots of the diagonal of `(JᵀJ)⁻¹` with residuals in their uncertainties.
fn uncertainties(jacobian: &DMatrix<f64>, targets: &[Target], scales: &[f64]) -> Option<Vec<f64>> {
    let tolerances: Option<Vec<f64>> = targets.iter().map(|target| target.tolerance).collect();
    let weights = DVector::from_iterator(
        targets.len(),
        tolerances?.iter().zip(scales).map(|(tolerance, scale)| scale / tolerance),
    );
    let weighted = DMatrix::from_diagonal(&weights) * jacobian;
    let columns = weighted.ncols();
    // Row j of the pseudo-inverse has the length of the uncertainty of unknown j.
    let mut squares = vec![0.0; columns];
    for row in 0..weighted.nrows() {
        let mut unit = DVector::zeros(weighted.nrows());
        unit[row] = 1.0;
        let solved = least_squares(&weighted, &unit).ok()?;
        squares.iter_mut().zip(solved.x.iter()).for_each(|(sum, x)| *sum += x * x);
    }
    Some(squares.into_iter().map(f64::sqrt).collect())
}

/// Solutions in ascending order, each once.
fn distinct(mut all: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let order = |a: &Vec<f64>, b: &Vec<f64>| a.partial_cmp(b).unwrap_or(Ordering::Equal);
    all.sort_by(order);
    let mut kept: Vec<Vec<f64>> = Vec::new();
    for one in all {
        if !kept.iter().any(|known| is_same(known, &one)) {
            kept.push(one);
        }
    }
    kept
}

/// Returns true if two solutions are one.
pub(super) fn is_same(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME * a.abs().max(b.abs()))
}
