//! The motion of a system of many degrees of freedom under given forces, exactly.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Complex, DMatrix, DVector};

use super::poles::{Poles, advance, advance_harmonic};
use dalembert_numerics::{
    extremes::{Extreme, Extremes, Sampling},
    linalg::{self, LinalgError},
};

/// From a time on, a force changes evenly, until the next piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceSegment {
    /// Start time.
    pub start: f64,
    /// The force at its beginning, over the amplitude.
    pub value: f64,
    /// Rate of change with time.
    pub slope: f64,
}

/// A force on the masses that is straight from time to time; nothing before its first piece.
#[derive(Debug, Clone, PartialEq)]
pub struct Push {
    /// The force on each mass, for a value of 1.
    pub force: DVector<f64>,
    /// The pieces, in the order of time.
    pub pieces: Vec<ForceSegment>,
}

/// A force `F cos(Ω(t − t₀) − φ)` from the time `t₀` on; nothing before.
#[derive(Debug, Clone, PartialEq)]
pub struct HarmonicLoad {
    /// The amplitude on each mass.
    pub force: DVector<f64>,
    /// Ω.
    pub frequency: f64,
    /// φ.
    pub lag: f64,
    /// t₀, zero or later.
    pub start: f64,
}

/// A start and the forces after it.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeExcitation {
    /// The displacements at time zero.
    pub position: DVector<f64>,
    /// The velocities at time zero.
    pub velocity: DVector<f64>,
    /// Forces in straight pieces.
    pub pushes: Vec<Push>,
    /// Harmonic forces.
    pub harmonics: Vec<HarmonicLoad>,
}

/// The motion of a system from a start under forces; exact, since between two breaks of the forces every pole has
/// a closed form.
#[derive(Debug, Clone)]
pub struct TimeResponse<'a> {
    poles: &'a Poles,
    /// Times at which a force changes its law, and the state then, harmonic forces aside.
    breaks: Vec<(f64, Vec<Complex<f64>>)>,
    /// b of the forces and of their slopes after each break.
    laws: Vec<Vec<[Complex<f64>; 2]>>,
    /// b of each harmonic force, turned by its lag and turned back, its frequency and its start.
    harmonics: Vec<(Vec<[Complex<f64>; 2]>, [f64; 2])>,
}

impl<'a> TimeResponse<'a> {
    /// Follows the forces from break to break. `momentum` is `ΦᵀM`, which gives modal coordinates.
    pub fn new(poles: &'a Poles, momentum: &DMatrix<f64>, excitation: &TimeExcitation) -> Self {
        let inputs: Vec<_> = excitation.pushes.iter().map(|push| poles.input(&push.force)).collect();
        let law = |from: f64| -> Vec<[Complex<f64>; 2]> {
            let laws: Vec<(f64, f64)> = excitation.pushes.iter().map(|push| push.during(from)).collect();
            let sum = |at: usize, of: fn(&(f64, f64)) -> f64| {
                inputs.iter().zip(&laws).map(|(input, law)| input[at] * of(law)).sum::<Complex<f64>>()
            };
            (0..poles.roots.len()).map(|at| [sum(at, |law| law.0), sum(at, |law| law.1)]).collect()
        };
        let mut state = poles.state(&(momentum * &excitation.position), &(momentum * &excitation.velocity));
        let times = breaks(excitation, f64::INFINITY);
        let (mut reached, mut laws) = (Vec::new(), Vec::new());
        for (at, time) in times.iter().enumerate() {
            let here = law(*time);
            reached.push((*time, state.clone()));
            if let Some(next) = times.get(at + 1) {
                state = later(poles, &state, &here, next - time);
            }
            laws.push(here);
        }
        let harmonics = excitation.harmonics.iter().map(|harmonic| {
            let turn = Complex::from_polar(1.0, -harmonic.lag);
            let inputs = poles.input(&harmonic.force).into_iter().map(|b| [b * turn, b * turn.conj()]);
            (inputs.collect(), [harmonic.frequency, harmonic.start])
        });
        Self { poles, breaks: reached, laws, harmonics: harmonics.collect() }
    }

    /// The state of the poles at a time, `x = Σ s z`.
    pub fn state(&self, time: f64) -> Vec<Complex<f64>> {
        let last = self.breaks.iter().rposition(|(start, _)| *start <= time).unwrap_or(0);
        let (start, state) = &self.breaks[last];
        let mut state = later(self.poles, state, &self.laws[last], time - start);
        for (inputs, [frequency, begun]) in &self.harmonics {
            if time <= *begun {
                continue;
            }
            for ((z, root), [forward, backward]) in state.iter_mut().zip(&self.poles.roots).zip(inputs) {
                *z += advance_harmonic(*root, *forward, *backward, *frequency, time - begun);
            }
        }
        state
    }
}

impl TimeResponse<'_> {
    /// The displacement of a mass that is farthest from zero from time zero to another one, to 1e-9; none where it takes
    /// more than so many examines the motion, or is cancelled.
    ///
    /// A stretch is cut in halves until the cubic through its ends, with its error `h⁴/384 max |x⁗|`, cannot come so far
    /// out, or is as exact as that.
    pub fn farthest(
        &self,
        row: usize,
        until: f64,
        most_looks: usize,
        cancelled: &dyn Fn() -> bool,
    ) -> Option<Extreme> {
        const PARTS: u32 = 64;
        const EXACT: f64 = 1e-9;
        /// Resolution at resonance, where no bound holds: this part of a radian of the fastest pole.
        const RESOLVED: f64 = 0.05;
        let mut looks = 0;
        let mut number = |time: f64| {
            looks += 1;
            let state = self.state(time);
            let look = Sampling::of(self.poles.displacement(row, &state), self.poles.velocity(row, &state));
            (look, looks)
        };
        let fastest = self.harmonics.iter().map(|(_, [frequency, _])| *frequency);
        let fastest = fastest.chain(self.poles.roots.iter().map(|root| root.norm())).fold(0.0, f64::max);
        let mut places: Vec<f64> = (0..=PARTS).map(|n| until * f64::from(n) / f64::from(PARTS)).collect();
        places.extend(self.breaks.iter().map(|(time, _)| *time).filter(|time| *time < until));
        places.sort_by(f64::total_cmp);
        places.dedup();
        let seen: Vec<(f64, Sampling)> = places.iter().map(|time| (*time, number(*time).0)).collect();
        let (_, first) = seen.first()?;
        let mut found = Extremes::at(0.0, first.value);
        let mut floor = seen.iter().fold(0.0f64, |most, (_, look)| most.max(look.value.abs()));
        let mut open: Vec<[(f64, Sampling); 2]> =
            seen.windows(2).rev().map(|pair| [pair[0], pair[1]]).collect();
        let mut bends = (usize::MAX, Bends::default());
        while let Some([(from, a), (to, b)]) = open.pop() {
            let step = to - from;
            let broken = self.breaks.iter().rposition(|(start, _)| *start <= from).unwrap_or(0);
            if bends.0 != broken {
                bends = (broken, self.bends(row, broken));
            }
            let error =
                bends.1.most([from, to].map(|time| time - self.breaks[broken].0)) * step.powi(4) / 384.0;
            let (rise, fall) = (a.value + a.rate * step / 3.0, b.value - b.rate * step / 3.0);
            let reach = [a.value, rise, fall, b.value].map(f64::abs).into_iter().fold(0.0, f64::max) + error;
            if reach < floor {
                continue;
            }
            if error <= EXACT * floor || step * fastest <= RESOLVED {
                let mut look = |time: f64| number(time).0;
                found.follow(&mut look, [from, to]);
                floor = floor.max(found.farthest().value.abs());
                continue;
            }
            let middle = f64::midpoint(from, to);
            let (look, looks) = number(middle);
            if looks > most_looks || cancelled() {
                return None;
            }
            floor = floor.max(look.value.abs());
            open.push([(middle, look), (to, b)]);
            open.push([(from, a), (middle, look)]);
        }
        Some(found.farthest())
    }

    /// Bounds of the fourth derivative of a displacement after a break.
    fn bends(&self, row: usize, broken: usize) -> Bends {
        let (start, state) = &self.breaks[broken];
        let mut bends = Bends { steady: 0.0, dying: Vec::with_capacity(state.len()) };
        let shapes = self.poles.shapes.row(row);
        let mut free: Vec<Complex<f64>> = Vec::with_capacity(state.len());
        for ((z, root), [constant, slope]) in state.iter().zip(&self.poles.roots).zip(&self.laws[broken]) {
            free.push(z + constant / root + slope / (root * root));
        }
        for (inputs, [frequency, begun]) in &self.harmonics {
            if begun > start {
                continue;
            }
            let turning = Complex::new(0.0, *frequency);
            let (mut ahead, mut back) = (Complex::<f64>::ZERO, Complex::<f64>::ZERO);
            for (n, (root, [forward, backward])) in self.poles.roots.iter().zip(inputs).enumerate() {
                let [forward, backward] =
                    [forward / (turning - root), backward / (-turning - root)].map(|z| z / 2.0);
                (ahead, back) = (ahead + shapes[n] * forward, back + shapes[n] * backward);
                free[n] -= (forward + backward) * (root * (start - begun)).exp();
            }
            bends.steady += (ahead.norm() + back.norm()) * frequency.powi(4);
        }
        for (n, root) in self.poles.roots.iter().enumerate() {
            bends.dying.push(((shapes[n] * free[n]).norm() * root.norm().powi(4), root.re));
        }
        bends
    }
}

/// Bounds of the parts of a fourth derivative after a break: what stays, and what decays, with its rate.
#[derive(Debug, Clone, Default)]
struct Bends {
    steady: f64,
    dying: Vec<(f64, f64)>,
}

impl Bends {
    /// The most between two times after the break.
    fn most(&self, [from, to]: [f64; 2]) -> f64 {
        let dying =
            self.dying.iter().map(|(size, rate)| size * (rate * if *rate > 0.0 { to } else { from }).exp());
        self.steady + dying.sum::<f64>()
    }
}

/// The state a time later under an unchanged law of the forces.
fn later(poles: &Poles, state: &[Complex<f64>], law: &[[Complex<f64>; 2]], time: f64) -> Vec<Complex<f64>> {
    let all = poles.roots.iter().zip(state).zip(law);
    all.map(|((root, z), [constant, slope])| advance(*root, *z, *constant, *slope, time)).collect()
}

/// The displacements at a time by the Taylor series of the equations of motion, step after step: a second method,
/// without modes.
///
/// # Errors
/// `Singular` mass; `TooLarge` when more than `limit` steps would be needed.
pub fn by_series(
    matrices: [&DMatrix<f64>; 3],
    excitation: &TimeExcitation,
    time: f64,
    limit: usize,
) -> Result<DVector<f64>, LinalgError> {
    state_by_series(matrices, excitation, time, limit).map(|[displacements, _]| displacements)
}

/// The displacements and the velocities at a time, as [`by_series`].
///
/// # Errors
/// As for [`by_series`].
pub fn state_by_series(
    [m, c, k]: [&DMatrix<f64>; 3],
    excitation: &TimeExcitation,
    time: f64,
    limit: usize,
) -> Result<[DVector<f64>; 2], LinalgError> {
    const TERMS: usize = 24;
    let n = m.nrows();
    let over_mass = |a: &DMatrix<f64>| -> Result<DMatrix<f64>, LinalgError> {
        let columns = a.column_iter().map(|column| Ok(linalg::solve(m, &column.into_owned())?.x));
        Ok(DMatrix::from_columns(&columns.collect::<Result<Vec<_>, LinalgError>>()?))
    };
    let force_over_mass = |force: &DVector<f64>| Ok(linalg::solve(m, force)?.x);
    let (stiffness, damping) = (over_mass(k)?, over_mass(c)?);
    let pushes: Vec<_> = excitation
        .pushes
        .iter()
        .map(|push| force_over_mass(&push.force))
        .collect::<Result<Vec<_>, LinalgError>>()?;
    let harmonics: Vec<_> = excitation
        .harmonics
        .iter()
        .map(|harmonic| force_over_mass(&harmonic.force))
        .collect::<Result<Vec<_>, LinalgError>>()?;
    let fastest = excitation.harmonics.iter().map(|harmonic| harmonic.frequency).fold(0.0, f64::max);
    let rate = stiffness.norm().sqrt().max(damping.norm()).max(fastest);
    let wanted = (rate * time).ceil();
    if wanted.is_nan() || wanted > limit as f64 {
        return Err(LinalgError::TooLarge { what: "steps", size: wanted as usize, limit });
    }
    let (mut x, mut v) = (excitation.position.clone(), excitation.velocity.clone());
    for ends in breaks(excitation, time).windows(2) {
        let steps = (rate * (ends[1] - ends[0])).ceil().max(1.0);
        let h = (ends[1] - ends[0]) / steps;
        for step in 0..steps as usize {
            let now = ends[0] + h * step as f64;
            // Derivatives of x, each over its factorial and times h to its power.
            let mut terms: Vec<DVector<f64>> = vec![x.clone(), &v * h];
            let mut force_size = h * h;
            for order in 0..TERMS {
                let mut acceleration = -(&stiffness * &terms[order]) * (h * h)
                    - &damping * &terms[order + 1] * (h * (order as f64 + 1.0));
                for (push, over) in excitation.pushes.iter().zip(&pushes) {
                    let (value, change) = push.during(ends[0]);
                    let force = match order {
                        0 => value + change * (now - ends[0]),
                        1 => change,
                        _ => 0.0,
                    };
                    acceleration += over * (force * force_size);
                }
                for (harmonic, over) in excitation.harmonics.iter().zip(&harmonics) {
                    if harmonic.start > ends[0] {
                        continue;
                    }
                    let w = harmonic.frequency;
                    let turn = w * (now - harmonic.start) - harmonic.lag + FRAC_PI_2 * order as f64;
                    acceleration += over * (w.powi(order as i32) * turn.cos() * force_size);
                }
                let next = (order + 1) as f64 * (order + 2) as f64;
                terms.push(acceleration / next);
                force_size *= h / (order + 1) as f64;
            }
            x = terms.iter().rev().fold(DVector::zeros(n), |sum, term| sum + term);
            v = terms
                .iter()
                .enumerate()
                .skip(1)
                .rev()
                .fold(DVector::zeros(n), |sum, (order, term)| sum + term * (order as f64 / h));
        }
    }
    Ok([x, v])
}

impl Push {
    /// Value and slope between the break at `from` and the next one.
    fn during(&self, from: f64) -> (f64, f64) {
        self.pieces
            .iter()
            .rev()
            .find(|piece| piece.start <= from)
            .map_or((0.0, 0.0), |piece| (piece.value + piece.slope * (from - piece.start), piece.slope))
    }
}

/// The times up to `time` at which a force changes its law, with both ends.
fn breaks(excitation: &TimeExcitation, time: f64) -> Vec<f64> {
    let starts = excitation.pushes.iter().flat_map(|push| &push.pieces).map(|piece| piece.start);
    let starts = starts.chain(excitation.harmonics.iter().map(|harmonic| harmonic.start));
    let mut breaks: Vec<f64> =
        starts.filter(|start| *start > 0.0 && *start < time).chain([0.0, time]).collect();
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    breaks
}
