//! Minimum of a function of several variables over the unit cube, under constraints.
//!
//! Global by many starts: the points of a scrambled Sobol' sequence are ranked, and the best of them that do not lie side by
//! side begin a local search each (S. Kucherenko and Yu. Sytsko, *Comput. Optim. Appl.* 30, 2005), until further ones are
//! not expected to find another minimum (C. G. E. Boender and A. H. G. Rinnooy Kan, *Math. Program.* 37, 1987). Local by sequential
//! quadratic programming (D. Kraft, *ACM Trans. Math. Softw.* 20, 1994; crate `slsqp`), which knows the derivatives from
//! differences. From the best optimum the search goes on without derivatives, by linear approximation (M. J. D. Powell's COBYLA,
//! 1994; crate `cobyla`), until that finds nothing better: a second method, which does not stop where a function has a kink.
//!
//! ```
//! use dalembert_numerics::optimisation::minimise;
//!
//! // The strongest beam sawn from a round log of diameter 1: b h² is largest under b² + h² ≤ 1 for b = 1/√3 and
//! // h = √(2/3). The objective comes first, the constraint after it.
//! let mut values = |x: &[f64]| Some(vec![-x[0] * x[1] * x[1], x[0] * x[0] + x[1] * x[1] - 1.0]);
//! let minimum = minimise(&mut values, 2, 1, &[]);
//! let best = &minimum.optima[0];
//! assert!((best.values[0] + 2.0 / 27_f64.sqrt()).abs() < 1e-9);
//! assert!((best.x[0] - 1.0 / 3_f64.sqrt()).abs() < 1e-6 && (best.x[1] - (2.0_f64 / 3.0).sqrt()).abs() < 1e-6);
//! ```

use std::cell::RefCell;

use nalgebra::DMatrix;

use crate::{nonlinear::jacobian, sampling::sobol};

/// A constraint that is violated by less counts as met.
pub const FEASIBLE: f64 = 1e-9;
/// Points that are ranked before the local searches, for each dimension.
const SCREENED: usize = 200;
/// The most points that are ranked.
const MOST_SCREENED: usize = 2000;
/// Local searches: so many, and so many more for each dimension.
const STARTS: [usize; 2] = [4, 4];
/// The most evaluations of a local search with derivatives.
const MOST_STEPS: usize = 300;
/// The most evaluations of the search without derivatives, for each dimension.
const MOST_TRIALS: usize = 500;
/// The most searches without derivatives.
const RENEWALS: usize = 5;
/// Share of the scale of the objective that is no improvement.
const SMALLEST_GAIN: f64 = 1e-12;
/// Scaled value that stands for a point without one.
const NO_VALUE: f64 = 1e6;
/// Step, of the unit cube, at which a search ends.
const SMALLEST_STEP: f64 = 1e-12;
/// Distance, of the unit cube, within which two optima are one.
const SAME: f64 = 1e-3;

/// Values of a point: first those whose largest is to be least, then the constraints, each of which is to be ≤ 0; `None`
/// where there are none.
pub type Values<'v> = dyn FnMut(&[f64]) -> Option<Vec<f64>> + 'v;

/// A local minimum.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The variables, each from 0 to 1.
    pub x: Vec<f64>,
    /// The values there.
    pub values: Vec<f64>,
    /// Number of the local searches that ended here.
    pub starts: usize,
}

/// Result of a search.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Minimum {
    /// The local minima, the best first. Where no constraint can be met, the point that violates them least.
    pub optima: Vec<Optimum>,
    /// Number of local searches.
    pub starts: usize,
    /// Number of points that were evaluated.
    pub evaluations: usize,
    /// Improvement of the objective by the last search without derivatives, which began at the best optimum: none, or
    /// rounding, where that is a minimum.
    pub gain: f64,
    /// Difference of the objective between the quarters of all points that are ranked: what counts as a large one.
    pub scale: f64,
}

/// Minimises the largest of the first `objectives` values over the unit cube, from given starts, a number from 0 to 1
/// for each dimension, and others. Without optima where no point that was tried has values.
pub fn minimise(
    values: &mut Values<'_>,
    dimensions: usize,
    objectives: usize,
    given: &[Vec<f64>],
) -> Minimum {
    let screened = (SCREENED * dimensions).min(MOST_SCREENED);
    let sequence = (0..screened as u64).map(|n| (0..dimensions).map(|axis| sobol(1, n, axis)).collect());
    let mut ranked: Vec<Point> = Vec::new();
    let mut evaluations = 0;
    for x in given.iter().cloned().chain(sequence) {
        evaluations += 1;
        ranked.extend(values(&x).map(|values| Point { x, values }));
    }
    let objective_of = |point: &Point| point.objective(objectives);
    let scale = spread(ranked.iter().map(objective_of).collect());
    ranked.sort_by(|a, b| a.merit(objectives).total_cmp(&b.merit(objectives)));
    let starts = apart(&ranked, dimensions, STARTS[0] + STARTS[1] * dimensions);
    let Some(first) = starts.first().cloned() else {
        return Minimum { evaluations, ..Minimum::default() };
    };
    let offset = objective_of(&first);
    let search = RefCell::new(Search {
        values,
        objectives,
        count: first.values.len(),
        offset,
        scale,
        at: Vec::new(),
        found: None,
        jacobian: None,
        best: None,
        evaluations,
    });
    let mut optima: Vec<Optimum> = Vec::new();
    let mut searches = 0;
    for start in &starts {
        let ended = local(&search, start, Method::SequentialQuadratic);
        keep(&mut optima, ended, objectives, scale);
        searches += 1;
        if expected_minima(optima.len(), searches) < optima.len() as f64 + 0.5 {
            break;
        }
    }
    sort(&mut optima, objectives);
    let mut gain = 0.0;
    for _ in 0..RENEWALS {
        let best = Point { x: optima[0].x.clone(), values: optima[0].values.clone() };
        let found = local(&search, &best, Method::LinearApproximation);
        // What the search without derivatives improves, the one with them ends.
        let polished = local(&search, &found, Method::SequentialQuadratic);
        gain = 0.0;
        if polished.merit(objectives) < best.merit(objectives) {
            gain = (objective_of(&best) - objective_of(&polished)).abs();
            (optima[0].x, optima[0].values) = (polished.x, polished.values);
        }
        if gain <= SMALLEST_GAIN * scale {
            break;
        }
    }
    sort(&mut optima, objectives);
    let evaluations = search.into_inner().evaluations;
    Minimum { optima, starts: searches, evaluations, gain, scale }
}

/// Expected number of local minima where so many searches ended in so many different ones: `w (n − 1)/(n − w − 2)`.
fn expected_minima(found: usize, searches: usize) -> f64 {
    if searches > found + 2 {
        (found * (searches - 1)) as f64 / (searches - found - 2) as f64
    } else {
        f64::INFINITY
    }
}

/// A point that has values.
#[derive(Clone, Debug)]
struct Point {
    x: Vec<f64>,
    values: Vec<f64>,
}

/// Violation of the constraints, then the objective: points are compared by the first where it is no rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Merit {
    violation: f64,
    objective: f64,
}

impl PartialOrd for Merit {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.total_cmp(other))
    }
}

impl Merit {
    fn of(values: &[f64], objectives: usize) -> Self {
        let largest = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let (wanted, constraints) = values.split_at(objectives);
        let violation = largest(constraints);
        Self { violation: if violation > FEASIBLE { violation } else { 0.0 }, objective: largest(wanted) }
    }

    fn total_cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.violation.total_cmp(&other.violation).then(self.objective.total_cmp(&other.objective))
    }
}

impl Point {
    fn merit(&self, objectives: usize) -> Merit {
        Merit::of(&self.values, objectives)
    }

    fn objective(&self, objectives: usize) -> f64 {
        self.merit(objectives).objective
    }
}

fn sort(optima: &mut [Optimum], objectives: usize) {
    let merit = |optimum: &Optimum| Merit::of(&optimum.values, objectives);
    optima.sort_by(|a, b| merit(a).total_cmp(&merit(b)));
}

/// Half of the values lie within this width; that of the size of a value where all are alike.
fn spread(mut values: Vec<f64>) -> f64 {
    values.retain(|value| value.is_finite());
    values.sort_by(f64::total_cmp);
    let at = |share: usize| values.get(values.len() * share / 4).copied().unwrap_or(0.0);
    let width = at(3) - at(1);
    let size = at(2).abs();
    if width > 1e-12 * size {
        width
    } else if size > 0.0 {
        size
    } else {
        1.0
    }
}

/// The best points of which no two are nearer than points that fill the cube evenly.
fn apart(ranked: &[Point], dimensions: usize, count: usize) -> Vec<Point> {
    let near = 0.5 * (count as f64).powf(-1.0 / dimensions as f64);
    let mut chosen: Vec<Point> = Vec::new();
    for point in ranked {
        if chosen.len() == count {
            break;
        }
        if chosen.iter().all(|other| distance(&other.x, &point.x) > near) {
            chosen.push(point.clone());
        }
    }
    chosen
}

/// Largest difference of a variable.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Keeps the end of a local search, once for all that end there.
fn keep(optima: &mut Vec<Optimum>, ended: Point, objectives: usize, scale: f64) {
    let merit = ended.merit(objectives);
    let is_same = |known: &&mut Optimum| {
        let other = Merit::of(&known.values, objectives);
        distance(&known.x, &ended.x) < SAME && (other.objective - merit.objective).abs() < SAME * scale
    };
    match optima.iter_mut().find(is_same) {
        None => optima.push(Optimum { x: ended.x, values: ended.values, starts: 1 }),
        Some(known) => {
            known.starts += 1;
            if merit < Merit::of(&known.values, objectives) {
                (known.x, known.values) = (ended.x, ended.values);
            }
        }
    }
}

/// State of the searches: the scaled problem, and the point that was evaluated last.
struct Search<'v, 'f> {
    values: &'v mut Values<'f>,
    objectives: usize,
    /// Number of values, with the constraints.
    count: usize,
    /// An objective is scaled to `(value − offset)/scale`.
    offset: f64,
    scale: f64,
    at: Vec<f64>,
    /// Scaled values at the last point.
    found: Option<Vec<f64>>,
    /// Jacobian of the scaled values there, once it is asked for; zero where there is none.
    jacobian: Option<DMatrix<f64>>,
    /// The best point of the present search.
    best: Option<Point>,
    evaluations: usize,
}

impl Search<'_, '_> {
    /// Goes to a point.
    fn go_to(&mut self, x: &[f64]) {
        if self.at == x {
            return;
        }
        self.at = x.to_vec();
        self.jacobian = None;
        self.found = None;
        // Where no constraint can be met the quadratic program has no solution, and the next point is not a number.
        if !x.iter().all(|x| (0.0..=1.0).contains(x)) {
            return;
        }
        self.evaluations += 1;
        let values = (self.values)(x);
        if let Some(values) = &values {
            let point = Point { x: x.to_vec(), values: values.clone() };
            if self
                .best
                .as_ref()
                .is_none_or(|best| point.merit(self.objectives) < best.merit(self.objectives))
            {
                self.best = Some(point);
            }
        }
        self.found = values.map(|values| scaled(values, self.objectives, self.offset, self.scale));
    }

    /// Scaled value `row` at a point.
    fn value(&mut self, row: usize, x: &[f64]) -> f64 {
        self.go_to(x);
        self.found.as_ref().map_or(NO_VALUE, |found| found[row])
    }

    /// Gradient of value `row` at a point; zero where there is none.
    fn gradient(&mut self, row: usize, x: &[f64], gradient: &mut [f64]) {
        self.go_to(x);
        if self.jacobian.is_none() {
            let (objectives, offset, scale) = (self.objectives, self.offset, self.scale);
            let (values, evaluations) = (&mut self.values, &mut self.evaluations);
            let mut scaled_values = |x: &[f64]| {
                *evaluations += 1;
                values(x).map(|values| scaled(values, objectives, offset, scale))
            };
            let found = self.found.as_ref();
            let of_values = found.and_then(|found| jacobian(&mut scaled_values, x, found));
            self.jacobian = Some(of_values.unwrap_or_else(|| DMatrix::zeros(self.count, x.len())));
        }
        if let Some(jacobian) = &self.jacobian {
            gradient.iter_mut().zip(&jacobian.row(row)).for_each(|(to, from)| *to = *from);
        }
    }
}

fn scaled(mut values: Vec<f64>, objectives: usize, offset: f64, scale: f64) -> Vec<f64> {
    values[..objectives].iter_mut().for_each(|value| *value = (*value - offset) / scale);
    values
}

#[derive(Clone, Copy)]
enum Method {
    SequentialQuadratic,
    LinearApproximation,
}

/// The best point of a local search. Of several objectives the largest is made least through one more variable, t, with a
/// constraint `fᵢ − t ≤ 0` for each: so both methods see smooth functions.
fn local(search: &RefCell<Search<'_, '_>>, start: &Point, method: Method) -> Point {
    let dimensions = start.x.len();
    let (objectives, count) = (search.borrow().objectives, start.values.len());
    search.borrow_mut().best = Some(start.clone());
    let is_minimax = objectives > 1;
    let mut x = start.x.clone();
    let mut bounds = vec![(0.0, 1.0); dimensions];
    if is_minimax {
        let state = search.borrow();
        x.push((start.objective(objectives) - state.offset) / state.scale);
        bounds.push((-NO_VALUE, NO_VALUE));
    }
    // The value of row `row`, less t where it is one of several objectives.
    let value = |row: Option<usize>, x: &[f64], gradient: Option<&mut [f64]>| {
        let mut search = search.borrow_mut();
        let (inner, level) = x.split_at(dimensions);
        let of_level = is_minimax && row.is_none_or(|row| row < objectives);
        if let Some(gradient) = gradient {
            gradient.fill(0.0);
            if let Some(row) = row {
                search.gradient(row, inner, &mut gradient[..dimensions]);
            }
            if of_level {
                gradient[dimensions] = if row.is_some() { -1.0 } else { 1.0 };
            }
        }
        match row {
            None => level[0],
            Some(row) => search.value(row, inner) - if of_level { level[0] } else { 0.0 },
        }
    };
    let constraints = if is_minimax { 0..count } else { objectives..count };
    let row = if is_minimax { None } else { Some(0) };
    match method {
        Method::SequentialQuadratic => {
            let objective = |x: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| value(row, x, gradient);
            let constraints: Vec<_> = constraints
                .map(|row| {
                    let value = &value;
                    move |x: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| value(Some(row), x, gradient)
                })
                .collect();
            let stop = slsqp::StopTols { xtol_abs: vec![SMALLEST_STEP; x.len()], ..Default::default() };
            // How it ended says less than the best point on its way.
            let _ = slsqp::minimize(objective, &x, &bounds, &constraints, (), MOST_STEPS, Some(stop));
        }
        Method::LinearApproximation => {
            let objective = |x: &[f64], (): &mut ()| value(row, x, None);
            let constraints: Vec<_> = constraints
                .map(|row| {
                    let value = &value;
                    // Its constraints are to be ≥ 0.
                    move |x: &[f64], (): &mut ()| -value(Some(row), x, None)
                })
                .collect();
            let stop = cobyla::StopTols { xtol_abs: vec![1e-10; x.len()], ..Default::default() };
            let begin = cobyla::RhoBeg::All(0.03);
            let trials = MOST_TRIALS * (dimensions + 1);
            let _ = cobyla::minimize(objective, &x, &bounds, &constraints, (), trials, begin, Some(stop));
        }
    }
    search.borrow_mut().best.take().unwrap_or_else(|| start.clone())
}

#[cfg(test)]
mod tests {
    use itertools::zip_eq;

    use super::*;

    /// The function of variables that go from `from` to `to`.
    fn over(
        [from, to]: [f64; 2],
        function: impl Fn(&[f64]) -> Vec<f64>,
    ) -> impl FnMut(&[f64]) -> Option<Vec<f64>> {
        move |x| Some(function(&x.iter().map(|x| from + (to - from) * x).collect::<Vec<_>>()))
    }

    fn near(found: f64, known: f64, tolerance: f64) {
        assert!((found - known).abs() <= tolerance, "{found} and not {known}");
    }

    /// L. C. W. Dixon and G. P. Szegö, *Towards Global Optimisation 2*, 1978: the six-hump camel, two global of six minima.
    #[test]
    fn the_global_minimum_among_several() {
        let camel = |x: &[f64]| {
            let (x, y) = (x[0], x[1]);
            vec![(4.0 - 2.1 * x * x + x.powi(4) / 3.0) * x * x + x * y + (4.0 * y * y - 4.0) * y * y]
        };
        let found = minimise(&mut over([-3.0, 3.0], camel), 2, 1, &[]);
        near(found.optima[0].values[0], -1.031_628_453_489_877, 1e-12);
        near(found.optima[1].values[0], -1.031_628_453_489_877, 1e-12);
        assert!(found.gain < 1e-9, "{found:?}");
        assert!(found.optima.len() > 2 && found.optima[2].values[0] > -0.3, "{found:?}");
    }

    /// W. Hock and K. Schittkowski, *Test Examples for Nonlinear Programming Codes*, 1981, no. 43: −44 at (0, 1, 2, −1).
    #[test]
    fn rosen_and_suzuki() {
        let problem = |x: &[f64]| {
            let square = |n: usize| x[n] * x[n];
            let sum = square(0) + square(1) + square(3);
            vec![
                sum + 2.0 * square(2) - 5.0 * x[0] - 5.0 * x[1] - 21.0 * x[2] + 7.0 * x[3],
                sum + square(2) + x[0] - x[1] + x[2] - x[3] - 8.0,
                square(0) + 2.0 * square(1) + square(2) + 2.0 * square(3) - x[0] - x[3] - 10.0,
                2.0 * square(0) + square(1) + square(2) + 2.0 * x[0] - x[1] - x[3] - 5.0,
            ]
        };
        let found = minimise(&mut over([-5.0, 5.0], problem), 4, 1, &[]);
        let best = &found.optima[0];
        near(best.values[0], -44.0, 1e-7);
        assert!(found.gain < 1e-9, "{found:?}");
        for (x, known) in zip_eq(&best.x, [0.0, 1.0, 2.0, -1.0]) {
            near(10.0 * x - 5.0, known, 1e-4);
        }
    }

    /// C. Charalambous and A. R. Conn, *SIAM J. Numer. Anal.* 15 (1978): the largest of three functions, 1.95222449.
    #[test]
    fn the_largest_of_three_functions() {
        let three = |x: &[f64]| {
            let (x, y) = (x[0], x[1]);
            vec![x * x + y.powi(4), (2.0 - x).powi(2) + (2.0 - y).powi(2), 2.0 * (y - x).exp()]
        };
        let found = minimise(&mut over([-2.0, 3.0], three), 2, 3, &[]);
        let largest = found.optima[0].values.iter().copied().fold(0.0, f64::max);
        near(largest, 1.952_224_493_870_22, 1e-9);
        assert!(found.gain < 1e-9, "{found:?}");
        near(5.0 * found.optima[0].x[0] - 2.0, 1.139_037_651_992, 1e-6);
    }

    /// Equality constraints as two inequalities: the point of the unit circle nearest to (2, 1).
    #[test]
    fn an_equality() {
        let circle = |x: &[f64]| {
            let radius = x[0].hypot(x[1]) - 1.0;
            vec![(x[0] - 2.0).powi(2) + (x[1] - 1.0).powi(2), radius, -radius]
        };
        let found = minimise(&mut over([-3.0, 3.0], circle), 2, 1, &[]);
        near(found.optima[0].values[0], (5_f64.sqrt() - 1.0).powi(2), 1e-8);
    }

    #[test]
    fn points_without_values_and_without_permission() {
        let mut half = |x: &[f64]| (x[0] <= 0.5).then(|| vec![-x[0]]);
        near(minimise(&mut half, 1, 1, &[]).optima[0].x[0], 0.5, 1e-6);
        let mut never = |x: &[f64]| Some(vec![x[0], 1.0 + x[0]]);
        let found = minimise(&mut never, 1, 1, &[]);
        near(found.optima[0].values[1], 1.0, 1e-9);
        let mut none = |_: &[f64]| None;
        assert!(minimise(&mut none, 2, 1, &[]).optima.is_empty());
    }

    #[test]
    fn a_kink() {
        let kink = |x: &[f64]| vec![(x[0] - 0.3).abs() + 3.0 * (x[1] + 0.2 * x[0]).abs()];
        let found = minimise(&mut over([-1.0, 1.0], kink), 2, 1, &[]);
        near(found.optima[0].values[0], 0.0, 1e-7);
    }
}
