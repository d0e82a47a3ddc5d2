//! The response of a damped system: directly, as sums over modes or poles, or point by point with loss factors.

use dalembert_core::{Refusal, Text};
use dalembert_mechanics::vibration::{poles::Poles, receptance};
use dalembert_numerics::linalg::{ComplexLu, LinalgError};
use nalgebra::{Complex, DMatrix, DVector};

use super::losses::Losses;
use crate::shared::system::{Assembled, damping::ModalDamping, modes::WorkedModes};

/// The most degrees of freedom whose curves are solved point by point, as loss factors of springs ask for.
const MOST_DIRECT: usize = 30;

/// The damped system under its forces.
pub(super) struct SteadyResponse<'a, N> {
    pub(super) system: &'a Assembled<N>,
    pub(super) damped: &'a ModalDamping,
    pub(super) losses: Option<Losses>,
    pub(super) force: DVector<Complex<f64>>,
    pub(super) found: &'a WorkedModes<N>,
}

impl<N> SteadyResponse<'_, N> {
    /// Mass, damping and stiffness.
    pub(super) fn matrices(&self) -> [&DMatrix<f64>; 3] {
        [&self.system.mass, &self.damped.physical, &self.system.stiffness]
    }

    /// Returns true if anything loses energy.
    pub(super) fn is_damped(&self) -> bool {
        self.damped.any() || self.losses.is_some()
    }

    /// The displacements by the dynamic stiffness.
    pub(super) fn at(&self, frequency: f64) -> Result<DVector<Complex<f64>>, Refusal> {
        let square = frequency * frequency;
        let squares = &self.found.modes.squares;
        let largest = squares.last().copied().unwrap_or(0.0);
        let resonant = (0..squares.len()).find(|&mode| {
            (squares[mode] - square).abs() <= 1e-12 * largest.max(square)
                && self.damped.matrix.column(mode).amax() * frequency <= 1e-14 * square
                && (self.losses.is_none() || square == 0.0)
        });
        if let Some(mode) = resonant {
            let why = if frequency == 0.0 {
                Text::new(
                    "rigid-body mode {mode} is unrestrained: under a constant force the motion is unbounded, it grows with t²",
                )
            } else {
                Text::new(
                    "at the natural frequency {mode}, without damping, the motion is unbounded: it grows with t and \
                     there is no steady state",
                )
            };
            return Err(Refusal::because(why.with("mode", mode + 1)));
        }
        let [mass, damping, stiffness] = self.matrices();
        let solved = match &self.losses {
            Some(losses) => losses.response(self.matrices(), &self.force, frequency),
            None => receptance::direct(mass, damping, stiffness, &self.force, frequency),
        };
        solved.map_err(|error| match error {
            LinalgError::Singular { .. } => Refusal::because(
                "so close to an undamped resonance the response is unbounded and has no significant digits",
            ),
            _ => Refusal::because(
                "masses, springs and dampers differ so much in magnitude that numbers overflow",
            ),
        })
    }

    /// The displacement of a mass at each frequency: from modes or poles, or point by point.
    pub(super) fn curve(&self, row: usize, grid: &[f64]) -> Option<Vec<Complex<f64>>> {
        let Some(losses) = &self.losses else {
            return curve(self.damped, &self.force, self.found, row, grid);
        };
        if self.force.len() > MOST_DIRECT {
            return None;
        }
        let at = |frequency: &f64| Some(losses.response(self.matrices(), &self.force, *frequency).ok()?[row]);
        grid.iter().map(at).collect()
    }
}

/// The whole frequency response matrix.
pub(super) fn matrix<N>(response: &SteadyResponse<'_, N>, frequency: f64) -> Option<DMatrix<Complex<f64>>> {
    let n = response.system.size();
    let dynamic = match &response.losses {
        Some(losses) => losses.dynamic(response.matrices(), frequency),
        None => receptance::dynamic_stiffness(response.matrices(), frequency),
    };
    ComplexLu::new(&dynamic).and_then(|lu| lu.solve(&DMatrix::identity(n, n))).ok()
}

/// The displacements as sums over modes, or over poles where the damping couples the modes.
pub(super) fn by_modes<N>(
    damped: &ModalDamping,
    force: &DVector<Complex<f64>>,
    found: &WorkedModes<N>,
    frequency: f64,
) -> Option<DVector<Complex<f64>>> {
    let rows = (0..force.len()).map(|row| Some(curve(damped, force, found, row, &[frequency])?[0]));
    Some(DVector::from_vec(rows.collect::<Option<Vec<_>>>()?))
}

/// The displacement of a mass at each frequency.
fn curve<N>(
    damped: &ModalDamping,
    force: &DVector<Complex<f64>>,
    found: &WorkedModes<N>,
    row: usize,
    grid: &[f64],
) -> Option<Vec<Complex<f64>>> {
    let modes = &found.modes;
    let mut total = vec![Complex::ZERO; grid.len()];
    let parts: [(DVector<f64>, Complex<f64>); 2] =
        [(force.map(|f| f.re), Complex::ONE), (force.map(|f| f.im), Complex::I)];
    let (mut real, mut imaginary) = (vec![0.0; grid.len()], vec![0.0; grid.len()]);
    let poles = if damped.proportional { None } else { Some(Poles::new(modes, &damped.matrix, 0.0).ok()?) };
    for (force, turn) in parts {
        if force.amax() == 0.0 {
            continue;
        }
        match &poles {
            None => {
                let modal = modes.shapes.transpose() * &force;
                let residues: Vec<f64> =
                    modes.shapes.row(row).iter().zip(modal.iter()).map(|(phi, pull)| phi * pull).collect();
                receptance::sum_of_modes(
                    &residues,
                    &modes.squares,
                    &damped.decays(),
                    grid,
                    &mut real,
                    &mut imaginary,
                );
            }
            Some(poles) => {
                let input = poles.input(&force);
                let residues: Vec<Complex<f64>> =
                    poles.shapes.row(row).iter().zip(&input).map(|(s, b)| s * b).collect();
                receptance::sum_of_poles(&residues, &poles.roots, grid, &mut real, &mut imaginary);
            }
        }
        for ((sum, re), im) in total.iter_mut().zip(&real).zip(&imaginary) {
            *sum += turn * Complex::new(*re, *im);
        }
    }
    Some(total)
}
