//! ODE integrator: `ẏ = f(t, y)` with dense output and an error controlled at every step.
//!
//! The explicit method of Dormand and Prince of order 8 with estimates of order 5 and 3 and a polynomial of order 7
//! between the ends of a step: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*,
//! 2nd ed., §II.4 to §II.6.
//!
//! ```
//! use dalembert_numerics::ode::{OdeError, OdeFunction, states};
//!
//! // A mass on a spring, ẍ = −4 x, released from rest at x = 1: x = cos 2t and ẋ = −2 sin 2t.
//! let mut oscillator = OdeFunction {
//!     rates: |_: f64, state: &[f64], rates: &mut [f64]| {
//!         rates[0] = state[1];
//!         rates[1] = -4.0 * state[0];
//!     },
//!     relative: 1e-12,
//!     absolute: 1e-12,
//! };
//! let times = [0.0, 1.0, 10.0];
//! for (time, state) in times.iter().zip(states(&mut oscillator, &[1.0, 0.0], &times, 10_000)?) {
//!     assert!((state[0] - (2.0 * time).cos()).abs() < 1e-10);
//!     assert!((state[1] + 2.0 * (2.0 * time).sin()).abs() < 1e-10);
//! }
//! # Ok::<(), OdeError>(())
//! ```

mod coefficients;
mod events;

use self::coefficients::{BETWEEN, FIFTH, NODES, STAGES, Sum, THIRD};
pub use self::events::SAME_TIME;

/// The stages of a step, its end, and those of the polynomial between.
const SLOPES: usize = 16;
/// The slope at the end of a step.
const END: usize = 12;
/// A step is shortened or lengthened by at most these factors, and aims below the allowed error by the last.
const SHORTEN: f64 = 1.0 / 3.0;
const LENGTHEN: f64 = 6.0;
const CAUTION: f64 = 0.9;
/// `h |λ|` beyond which the method is held by its stability, and the steps in a row that tell.
const STABLE: f64 = 6.1;
const HELD: u32 = 15;
/// The error of the polynomial between the ends of a step, over what is allowed at its end, that is usual at most: a
/// step with more is longer than the estimates of its error are good for.
const USUAL: f64 = 500.0;
/// Gaps between the stages of a step, the widest first: their middle, and how far from it is still far from the stages.
const GAPS: [[f64; 2]; 3] = [[7.0 / 15.0, 0.06], [0.159, 0.015], [0.026, 0.01]];
/// A step is shortened at most to this part for the sake of a gap.
const LEAST: f64 = 0.3;
/// The end of a step keeps this part of it away from a singular position, after so many tries.
const CLEAR: f64 = 0.25;
const RELAID: u32 = 4;
/// The largest value of x⁴ (1 − x)³ from 0 to 1, the last term of the polynomial.
const LAST_TERM: f64 = 256.0 * 27.0 / 823_543.0;

/// Options of an integration: interval, output, tolerance, events.
#[derive(Clone, Copy)]
pub struct Integration<'a, E> {
    /// s.
    pub duration: f64,
    /// The error that each step may add.
    pub tolerance: f64,
    /// Number of samples at equal time steps, start and end included.
    pub samples: usize,
    /// Terminal events: each ends the integration early.
    pub ends: &'a [E],
    /// The most steps.
    pub most_steps: usize,
    /// Asked now and then whether to stop.
    pub cancelled: &'a dyn Fn() -> bool,
}

/// System of first-order differential equations `dy/dt = f(t, y)` to integrate.
pub trait OdeSystem {
    /// The rates `f(t, y)`. Rates that are not finite say that the motion cannot go on from there: the step is
    /// shortened.
    fn rates(&mut self, time: f64, state: &[f64], rates: &mut [f64]);

    /// The error that each part of the state may have in a step between two states; infinite for a part that is
    /// not examined. Called once after the rates of each step.
    fn allowed(&mut self, before: &[f64], after: &[f64], allowed: &mut [f64]);

    /// Brings a state back to what it must satisfy after each step; false if it is too far from it.
    fn settle(&mut self, _time: f64, _state: &mut [f64]) -> bool {
        true
    }

    /// Times from the last singular position and to the next one, seen from a state whose rates were just evaluated: at
    /// such a position the rates are lost to rounding. Steps are laid so that none of their stages falls near it.
    fn singular(&mut self, _time: f64, _state: &[f64], _rates: &[f64]) -> [f64; 2] {
        [f64::INFINITY; 2]
    }

    /// Returns true if the integration has to be abandoned.
    fn stopped(&self) -> bool {
        false
    }
}

/// A [`OdeSystem`] of a function and two tolerances.
#[derive(Debug, Clone)]
pub struct OdeFunction<F> {
    /// `f(t, y)`, written to its last argument.
    pub rates: F,
    /// The allowed error in parts of each number.
    pub relative: f64,
    /// The allowed error of every number besides.
    pub absolute: f64,
}

/// Reason for which an integration fails.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum OdeError {
    /// The start, the end or the tolerances are not numbers that make sense.
    #[error("start, end and tolerances must be finite, the end after the start and the tolerances positive")]
    Input,
    /// The rates are not finite, however short the step.
    #[error("the motion cannot go on from {at}: its rates are not finite")]
    NotFinite {
        /// Time of failure.
        at: f64,
    },
    /// The allowed error asks for steps below rounding.
    #[error("the allowed error cannot be held at {at}: steps become too short")]
    TooShort {
        /// Time of failure.
        at: f64,
    },
    /// The motion asks for too many steps.
    #[error("{steps} steps do not suffice beyond {at}")]
    TooManySteps {
        /// Time of failure.
        at: f64,
        /// Number of steps taken.
        steps: usize,
    },
    /// The motion asks for too many steps, since something decays so much faster than it lasts that stability alone
    /// holds the steps of an explicit method short.
    #[error("the motion is stiff at {at}: something in it decays much faster than the rest moves")]
    Stiff {
        /// Time of failure.
        at: f64,
    },
    /// Asked to stop.
    #[error("the motion was stopped")]
    Stopped,
}

/// The states at the given times, ascending, the first of which is that of `start`: one state for each time, its numbers
/// in the order of `start`.
///
/// # Errors
/// All of [`OdeError`].
pub fn states<P: OdeSystem>(
    problem: &mut P,
    start: &[f64],
    times: &[f64],
    most_steps: usize,
) -> Result<Vec<Vec<f64>>, OdeError> {
    let (&[first, ..], &[.., last]) = (times, times) else { return Ok(Vec::new()) };
    let mut integrator = Integrator::new(problem, first, start, last, most_steps)?.examined_between();
    let mut states = Vec::with_capacity(times.len());
    for &time in times {
        while integrator.time() < time {
            integrator.advance(problem, last)?;
        }
        states.push(integrator.at(problem, time));
    }
    Ok(states)
}

/// A motion on its way.
#[derive(Debug, Clone)]
pub struct Integrator {
    time: f64,
    state: Vec<f64>,
    /// Begin of the last step.
    before: f64,
    state_before: Vec<f64>,
    /// The length of the next step.
    next: f64,
    /// The slopes of the stages of the last step.
    slopes: Vec<Vec<f64>>,
    /// True if the stored rates at the current state are those of the last stage of a step (first same as last), false
    /// if they were evaluated again.
    stepped: bool,
    /// True if the interpolating polynomial of each step is computed and examined for events.
    examined_between: bool,
    /// The polynomial over the last step, once asked for.
    between: Option<[Vec<f64>; 7]>,
    /// Time to the next singular position, seen from the current state and from the previous one.
    ahead: f64,
    ahead_before: f64,
    tried: Vec<f64>,
    last_stage: Vec<f64>,
    allowed: Vec<f64>,
    steps: usize,
    most_steps: usize,
    held: u32,
    free: u32,
}

impl Integrator {
    /// Starts a motion that is to last to about `end`.
    ///
    /// # Errors
    /// `Input`, `NotFinite`.
    pub fn new<P: OdeSystem>(
        problem: &mut P,
        start: f64,
        state: &[f64],
        end: f64,
        most_steps: usize,
    ) -> Result<Self, OdeError> {
        let good = start.is_finite() && end.is_finite() && end >= start && finite(state);
        if !good {
            return Err(OdeError::Input);
        }
        let zeros = vec![0.0; state.len()];
        let mut integrator = Self {
            time: start,
            state: state.to_vec(),
            before: start,
            state_before: state.to_vec(),
            next: end - start,
            slopes: vec![zeros.clone(); SLOPES],
            stepped: false,
            examined_between: false,
            between: None,
            ahead: f64::INFINITY,
            ahead_before: f64::INFINITY,
            tried: zeros.clone(),
            last_stage: zeros.clone(),
            allowed: zeros,
            steps: 0,
            most_steps,
            held: 0,
            free: 0,
        };
        integrator.restart(problem, start, state)?;
        integrator.next = integrator.first_step(problem, end - start)?;
        Ok(integrator)
    }

    /// For a motion that is asked for between the ends of steps: each is so short that its polynomial holds there.
    #[must_use]
    pub fn examined_between(mut self) -> Self {
        self.examined_between = true;
        self
    }

    /// Current time.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// State at the current time.
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// Time at the start of the last step.
    pub fn before(&self) -> f64 {
        self.before
    }

    /// Number of steps taken.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Goes on from another state, perhaps with another number of parts, at the present time or one in the last step.
    ///
    /// # Errors
    /// `NotFinite`; `Input` for a time outside the last step.
    pub fn restart<P: OdeSystem>(
        &mut self,
        problem: &mut P,
        time: f64,
        state: &[f64],
    ) -> Result<(), OdeError> {
        if !(self.before..=self.time).contains(&time) {
            return Err(OdeError::Input);
        }
        let n = state.len();
        self.time = time;
        self.state.clear();
        self.state.extend_from_slice(state);
        self.before = self.time;
        self.state_before.clone_from(&self.state);
        for part in self.slopes.iter_mut().chain([&mut self.tried, &mut self.last_stage, &mut self.allowed]) {
            part.resize(n, 0.0);
        }
        problem.rates(self.time, &self.state, &mut self.slopes[0]);
        let [_, ahead] = problem.singular(self.time, &self.state, &self.slopes[0]);
        (self.ahead, self.ahead_before) = (ahead, ahead);
        (self.stepped, self.between) = (false, None);
        if finite(&self.slopes[0]) { Ok(()) } else { Err(OdeError::NotFinite { at: self.time }) }
    }

    /// Makes one step, not beyond a time.
    ///
    /// # Errors
    /// `NotFinite`, `TooShort`, `TooManySteps` or `Stiff`, `Stopped`; `Input` for an allowed error that is not positive.
    pub fn advance<P: OdeSystem>(&mut self, problem: &mut P, until: f64) -> Result<(), OdeError> {
        let left = until - self.time;
        if !left.is_finite() || left <= 0.0 {
            return Err(OdeError::Input);
        }
        if self.stepped {
            self.slopes.swap(0, END);
            self.stepped = false;
        }
        self.between = None;
        self.before = self.time;
        self.state_before.clone_from(&self.state);
        let mut step = self.next;
        self.ahead_before = self.ahead;
        let mut singular = self.ahead;
        let (mut shortened, mut at_all, mut relaid) = (false, true, 0);
        loop {
            if problem.stopped() {
                return Err(OdeError::Stopped);
            }
            if self.steps >= self.most_steps {
                let (at, steps) = (self.time, self.steps);
                let stiff = self.held >= HELD;
                return Err(if stiff {
                    OdeError::Stiff { at }
                } else {
                    OdeError::TooManySteps { at, steps }
                });
            }
            self.steps += 1;
            let wanted = if step * 1.01 >= left { left } else { step };
            let taken = laid(wanted, left, singular);
            let whole = taken >= left;
            if taken <= 4.0 * f64::EPSILON * self.before.abs().max(f64::MIN_POSITIVE) {
                let at = self.before;
                return Err(if at_all { OdeError::TooShort { at } } else { OdeError::NotFinite { at } });
            }
            let end = if whole { until } else { self.before + taken };
            let mut error =
                if self.try_step(problem, taken) { self.error(problem, taken)? } else { f64::NAN };
            at_all = !error.is_nan();
            if at_all && error <= 1.0 && problem.settle(end, &mut self.tried) {
                problem.rates(end, &self.tried, &mut self.slopes[END]);
                at_all = finite(&self.slopes[END]);
                let [behind, ahead] = problem.singular(end, &self.tried, &self.slopes[END]);
                if at_all && !whole && relaid < RELAID && behind.min(ahead) < CLEAR * taken {
                    singular = if behind < ahead { taken - behind } else { taken + ahead };
                    relaid += 1;
                    continue;
                }
                if at_all {
                    self.watch_stiffness(taken);
                    std::mem::swap(&mut self.state, &mut self.tried);
                    let between = if self.examined_between { self.look_between(problem, taken) } else { 0.0 };
                    if between <= 1.0 {
                        (self.time, self.stepped, self.ahead) = (end, true, ahead);
                        let factor = (CAUTION * error.powf(-0.125)).clamp(SHORTEN, LENGTHEN);
                        let next = taken * if shortened { factor.min(1.0) } else { factor };
                        self.next = if whole || taken < step { next.max(step) } else { next };
                        return Ok(());
                    }
                    self.state.clone_from(&self.state_before);
                    self.between = None;
                    // The polynomial is of one order less.
                    error = between.powf(8.0 / 7.0);
                }
            }
            shortened = true;
            step = taken * if error > 1.0 { (CAUTION * error.powf(-0.125)).max(SHORTEN) } else { 0.25 };
        }
    }

    /// Goes back to the begin of the last step, to make others: one that ends at a time within it is more exact there
    /// than [`at`](Self::at) is.
    pub fn back(&mut self) {
        self.time = self.before;
        self.state.clone_from(&self.state_before);
        self.ahead = self.ahead_before;
        (self.stepped, self.between) = (false, None);
    }

    /// The state at a time within the last step.
    pub fn at<P: OdeSystem>(&mut self, problem: &mut P, time: f64) -> Vec<f64> {
        let step = self.time - self.before;
        if time >= self.time || step <= 0.0 {
            return self.state.clone();
        }
        if time <= self.before {
            return self.state_before.clone();
        }
        let x = (time - self.before) / step;
        if self.between.is_none() {
            self.between = Some(self.polynomial(problem, step));
        }
        let parts = self.between.as_ref().expect("the polynomial was just made");
        let of = |n: usize| {
            let inner =
                parts.iter().enumerate().rev().fold(0.0, |sum, (power, part)| {
                    (sum + part[n]) * if power % 2 == 0 { x } else { 1.0 - x }
                });
            self.state_before[n] + inner
        };
        (0..self.state.len()).map(of).collect()
    }

    /// The stages and the result of a step; false if some slope is not finite.
    fn try_step<P: OdeSystem>(&mut self, problem: &mut P, step: f64) -> bool {
        for stage in 1..=END {
            self.point(stage, step);
            if stage == END {
                return finite(&self.tried);
            }
            if stage == END - 1 {
                self.last_stage.clone_from(&self.tried);
            }
            let time = self.before + NODES[stage] * step;
            problem.rates(time, &self.tried, &mut self.slopes[stage]);
            if !finite(&self.slopes[stage]) {
                return false;
            }
        }
        true
    }

    /// The state of a stage, to `tried`.
    fn point(&mut self, stage: usize, step: f64) {
        self.tried.clone_from(&self.state_before);
        for &(slope, weight) in STAGES[stage] {
            let weight = weight * step;
            for (x, slope) in self.tried.iter_mut().zip(&self.slopes[slope]) {
                *x += weight * slope;
            }
        }
    }

    /// The error of a step over what is allowed, of the part where it is largest.
    fn error<P: OdeSystem>(&mut self, problem: &mut P, step: f64) -> Result<f64, OdeError> {
        problem.allowed(&self.state_before, &self.tried, &mut self.allowed);
        if self.allowed.iter().any(|allowed| allowed.is_nan() || *allowed <= 0.0) {
            return Err(OdeError::Input);
        }
        let (mut fifth, mut third) = (0.0f64, 0.0f64);
        for (n, allowed) in self.allowed.iter().enumerate() {
            fifth = f64::max(fifth, (self.sum(FIFTH, n) / allowed).abs());
            third = f64::max(third, (self.sum(THIRD, n) / allowed).abs());
        }
        let whole = fifth.hypot(0.1 * third);
        Ok(if whole == 0.0 { 0.0 } else { step * fifth * (fifth / whole) })
    }

    fn sum(&self, sum: Sum, n: usize) -> f64 {
        sum.iter().map(|&(slope, weight)| weight * self.slopes[slope][n]).sum()
    }

    /// Makes the polynomial over a step: its last term over what is usual.
    fn look_between<P: OdeSystem>(&mut self, problem: &mut P, step: f64) -> f64 {
        let between = self.polynomial(problem, step);
        let [.., last] = &between;
        let parts = last.iter().zip(&self.allowed).map(|(last, allowed)| (last / allowed).abs());
        let most = parts.fold(0.0, |most: f64, part| if part > most || part.is_nan() { part } else { most });
        self.between = Some(between);
        most * LAST_TERM / USUAL
    }

    /// The coefficients of the polynomial over the last step.
    fn polynomial<P: OdeSystem>(&mut self, problem: &mut P, step: f64) -> [Vec<f64>; 7] {
        for stage in END + 1..SLOPES {
            self.point(stage, step);
            let time = self.before + NODES[stage] * step;
            problem.rates(time, &self.tried, &mut self.slopes[stage]);
        }
        let n = self.state.len();
        let each = |of: &dyn Fn(usize) -> f64| -> Vec<f64> { (0..n).map(of).collect() };
        let change = |n: usize| self.state[n] - self.state_before[n];
        let slope = |at: usize, n: usize| step * self.slopes[at][n];
        let upper = BETWEEN.map(|sum| each(&|n| step * self.sum(sum, n)));
        let [a, b, c, d] = upper;
        [
            each(&change),
            each(&|n| slope(0, n) - change(n)),
            each(&|n| 2.0 * change(n) - slope(0, n) - slope(END, n)),
            a,
            b,
            c,
            d,
        ]
    }

    /// Notes whether stability alone holds the steps short: `|Δf|/|Δy|` between the last stage and the end of the step
    /// estimates the largest eigenvalue.
    fn watch_stiffness(&mut self, step: f64) {
        let (mut slopes, mut states) = (0.0, 0.0);
        for (n, allowed) in self.allowed.iter().enumerate() {
            slopes += ((self.slopes[END][n] - self.slopes[END - 1][n]) / allowed).powi(2);
            states += ((self.tried[n] - self.last_stage[n]) / allowed).powi(2);
        }
        if states > 0.0 && step * step * slopes > STABLE * STABLE * states {
            (self.held, self.free) = (self.held + 1, 0);
        } else {
            self.free += 1;
            if self.free == 6 {
                self.held = 0;
            }
        }
    }

    /// A first step whose error is about what is allowed (§II.4, "starting step size").
    fn first_step<P: OdeSystem>(&mut self, problem: &mut P, whole: f64) -> Result<f64, OdeError> {
        problem.allowed(&self.state, &self.state, &mut self.allowed);
        if self.allowed.iter().any(|allowed| allowed.is_nan() || *allowed <= 0.0) {
            return Err(OdeError::Input);
        }
        let size = |x: &[f64], allowed: &[f64]| {
            x.iter().zip(allowed).map(|(x, allowed)| (x / allowed).powi(2)).sum::<f64>().sqrt()
        };
        let (state, slope) = (size(&self.state, &self.allowed), size(&self.slopes[0], &self.allowed));
        let first = if state > 0.0 && slope > 0.0 { 0.01 * state / slope } else { 1e-6 * whole };
        let first = first.min(whole);
        for ((x, at), slope) in self.tried.iter_mut().zip(&self.state).zip(&self.slopes[0]) {
            *x = at + first * slope;
        }
        problem.rates(self.time + first, &self.tried, &mut self.slopes[1]);
        let change: Vec<f64> = self.slopes[1].iter().zip(&self.slopes[0]).map(|(a, b)| a - b).collect();
        let bend = size(&change, &self.allowed) / first;
        let steepest = slope.max(bend);
        let second = if steepest.is_finite() && steepest > 0.0 {
            (0.01 / steepest).powf(0.125)
        } else {
            100.0 * first
        };
        // The estimate may be too good for a step too long; from a short one it leads up.
        Ok((second / LENGTHEN).min(100.0 * first).min(whole).max(1e-12 * whole))
    }
}

impl<F: FnMut(f64, &[f64], &mut [f64])> OdeSystem for OdeFunction<F> {
    fn rates(&mut self, time: f64, state: &[f64], rates: &mut [f64]) {
        (self.rates)(time, state, rates);
    }

    fn allowed(&mut self, before: &[f64], after: &[f64], allowed: &mut [f64]) {
        for ((allowed, a), b) in allowed.iter_mut().zip(before).zip(after) {
            *allowed = self.absolute + self.relative * a.abs().max(b.abs());
        }
    }
}

/// A step laid so that a singular position lies in a gap between its stages, or beyond it by as much as the next step
/// needs for the same.
fn laid(step: f64, left: f64, singular: f64) -> f64 {
    let [widest, _] = GAPS[0];
    let part = singular / step;
    if part > 1.0 + widest {
        return step;
    }
    if GAPS.iter().any(|[middle, half]| (part - middle).abs() <= *half) {
        return step;
    }
    if part < widest {
        let gap =
            GAPS.iter().map(|[middle, _]| *middle).find(|middle| part < *middle && part > LEAST * middle);
        return gap.map_or(step, |middle| singular / middle);
    }
    if step >= left {
        // What remains up to the end takes it up.
        let beyond = (left - singular).max(0.0) / (1.0 - widest);
        return left - beyond.max(0.05 * left);
    }
    singular - widest * step
}

fn finite(x: &[f64]) -> bool {
    x.iter().all(|x| x.is_finite())
}
