//! The motion of a system of many degrees of freedom under given forces, exactly.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Complex, DMatrix, DVector};

use super::poles::{Poles, advance, advance_harmonic};
use crate::linalg::{self, LinalgError};

/// From a time on, a force changes evenly, until the next piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// When it begins.
    pub start: f64,
    /// The force at its beginning, over the amplitude.
    pub value: f64,
    /// Its change with time.
    pub slope: f64,
}

/// A force on the masses that is straight from time to time; nothing before its first piece.
#[derive(Debug, Clone, PartialEq)]
pub struct Push {
    /// The force on each mass, for a value of 1.
    pub force: DVector<f64>,
    /// The pieces, in the order of time.
    pub pieces: Vec<Piece>,
}

/// A force `F cos(Ωt − φ)` from time zero on.
#[derive(Debug, Clone, PartialEq)]
pub struct Harmonic {
    /// The amplitude on each mass.
    pub force: DVector<f64>,
    /// Ω.
    pub frequency: f64,
    /// φ.
    pub lag: f64,
}

/// A start and the forces after it.
#[derive(Debug, Clone, PartialEq)]
pub struct Excitation {
    /// The displacements at time zero.
    pub position: DVector<f64>,
    /// The velocities at time zero.
    pub velocity: DVector<f64>,
    /// Forces in straight pieces.
    pub pushes: Vec<Push>,
    /// Harmonic forces.
    pub harmonics: Vec<Harmonic>,
}

/// The state of the poles at a time, `x = Σ s z`; exact, since between two breaks of the forces every pole has a
/// closed form. `momentum` is `ΦᵀM`, which gives modal coordinates.
pub fn state(
    poles: &Poles,
    momentum: &DMatrix<f64>,
    excitation: &Excitation,
    time: f64,
) -> Vec<Complex<f64>> {
    let mut state = poles.state(&(momentum * &excitation.position), &(momentum * &excitation.velocity));
    let inputs: Vec<_> = excitation.pushes.iter().map(|push| poles.input(&push.force)).collect();
    let breaks = breaks(excitation, time);
    for ends in breaks.windows(2) {
        let (from, to) = (ends[0], ends[1]);
        for (at, z) in state.iter_mut().enumerate() {
            let (mut constant, mut slope) = (Complex::ZERO, Complex::ZERO);
            for (push, input) in excitation.pushes.iter().zip(&inputs) {
                let (value, change) = push.during(from);
                constant += input[at] * value;
                slope += input[at] * change;
            }
            *z = advance(poles.roots[at], *z, constant, slope, to - from);
        }
    }
    for harmonic in &excitation.harmonics {
        let turn = Complex::from_polar(1.0, -harmonic.lag);
        for ((z, root), input) in state.iter_mut().zip(&poles.roots).zip(poles.input(&harmonic.force)) {
            *z += advance_harmonic(*root, input * turn, input * turn.conj(), harmonic.frequency, time);
        }
    }
    state
}

/// The displacements at a time by the Taylor series of the equations of motion, step after step: a second way,
/// without modes.
///
/// # Errors
/// `Singular` mass; `TooLarge` when more than `limit` steps would be needed.
pub fn by_series(
    [m, c, k]: [&DMatrix<f64>; 3],
    excitation: &Excitation,
    time: f64,
    limit: usize,
) -> Result<DVector<f64>, LinalgError> {
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
                    let w = harmonic.frequency;
                    let turn = w * now - harmonic.lag + FRAC_PI_2 * order as f64;
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
    Ok(x)
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
fn breaks(excitation: &Excitation, time: f64) -> Vec<f64> {
    let starts = excitation.pushes.iter().flat_map(|push| &push.pieces).map(|piece| piece.start);
    let mut breaks: Vec<f64> =
        starts.filter(|start| *start > 0.0 && *start < time).chain([0.0, time]).collect();
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    breaks
}
