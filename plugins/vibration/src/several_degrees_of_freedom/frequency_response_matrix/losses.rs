//! Loss factors of single springs of a chain: complex stiffness, and the loss factors of the modes.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::vibration::receptance;
use dalembert_numerics::linalg::{self, LinalgError};
use nalgebra::{Complex, DMatrix, DVector};

use crate::{
    shared::system::{ChainEnds, System, modes::WorkedModes},
    sources::EWINS,
};

/// A spring with a loss factor: the masses at its ends, counted from 0, where it does not end at a wall.
struct LossySpring {
    ends: [Option<usize>; 2],
    stiffness: f64,
    loss_factor: f64,
}

/// The imaginary part of the stiffness of a chain.
pub(super) struct Losses {
    springs: Vec<LossySpring>,
    /// `H`: the stiffness matrix of the springs, each multiplied by its loss factor.
    matrix: DMatrix<f64>,
}

impl Losses {
    /// Of springs by their numbers, counted from 1 at the left, and loss factors; `None` where there are none.
    ///
    /// # Errors
    /// A system that is no chain; a spring that does not exist.
    pub(super) fn of(system: &System, losses: &[(usize, f64)]) -> Result<Option<Self>, Refusal> {
        if losses.is_empty() {
            return Ok(None);
        }
        let stiffnesses: Vec<f64> = match system {
            System::Chain { masses, wall } => {
                let walls = wall.as_ref().and_then(|wall| wall.spring);
                let springs = masses.iter().map(|mass| mass.spring).chain([walls]);
                springs.map(|spring| spring.unwrap_or(0.0)).collect()
            }
            System::Uniform { count, spring, ends, .. } => {
                let at = |place: usize| if ChainEnds::hold(*ends, place, *count) { *spring } else { 0.0 };
                (0..=*count).map(at).collect()
            }
            System::String { .. } | System::Matrices { .. } => {
                return Err(Refusal::because(
                    "loss factors are those of the springs of a chain: choose a chain, or leave the loss factors out",
                ));
            }
        };
        let n = stiffnesses.len() - 1;
        let mut springs = Vec::new();
        for (spring, loss_factor) in losses {
            let stiffness = stiffnesses.get(spring - 1).copied().unwrap_or(0.0);
            if stiffness == 0.0 {
                let why = Text::new(
                    "the chain has no spring {n}: springs count from the left, that before mass 1 is the first",
                );
                return Err(Refusal::because(why.with("n", *spring)));
            }
            let at = spring - 1;
            let ends = [at.checked_sub(1), (at < n).then_some(at)];
            springs.push(LossySpring { ends, stiffness, loss_factor: *loss_factor });
        }
        let mut matrix = DMatrix::zeros(n, n);
        for LossySpring { ends, stiffness, loss_factor } in &springs {
            let value = stiffness * loss_factor;
            for (i, from) in ends.iter().enumerate() {
                for (j, to) in ends.iter().enumerate() {
                    if let (Some(row), Some(column)) = (*from, *to) {
                        matrix[(row, column)] += if i == j { value } else { -value };
                    }
                }
            }
        }
        Ok(Some(Self { springs, matrix }))
    }

    /// `K − ω²M + iωC + iH`; at rest nothing is lost.
    pub(super) fn dynamic(&self, matrices: [&DMatrix<f64>; 3], frequency: f64) -> DMatrix<Complex<f64>> {
        let lost = f64::from(u8::from(frequency != 0.0));
        receptance::dynamic_stiffness(matrices, frequency) + self.matrix.map(|h| Complex::new(0.0, lost * h))
    }

    /// The displacements under harmonic forces.
    ///
    /// # Errors
    /// Those of the system of equations.
    pub(super) fn response(
        &self,
        matrices: [&DMatrix<f64>; 3],
        force: &DVector<Complex<f64>>,
        frequency: f64,
    ) -> Result<DVector<Complex<f64>>, LinalgError> {
        let right = DMatrix::from_column_slice(force.len(), 1, force.as_slice());
        Ok(linalg::solve_complex(&self.dynamic(matrices, frequency), &right)?.column(0).into_owned())
    }

    /// The same from twice as many real equations, and the size of their rounding.
    ///
    /// # Errors
    /// Those of the system of equations.
    pub(super) fn real_response(
        &self,
        matrices: [&DMatrix<f64>; 3],
        force: &DVector<Complex<f64>>,
        frequency: f64,
    ) -> Result<(DVector<Complex<f64>>, f64), LinalgError> {
        let dynamic = self.dynamic(matrices, frequency);
        let n = force.len();
        let real = DMatrix::from_fn(2 * n, 2 * n, |i, j| {
            let entry = dynamic[(i % n, j % n)];
            match (i < n, j < n) {
                (true, false) => -entry.im,
                (false, true) => entry.im,
                _ => entry.re,
            }
        });
        let right = DVector::from_fn(2 * n, |i, _| if i < n { force[i].re } else { force[i - n].im });
        let solved = linalg::solve(&real, &right)?;
        let size = solved.x.amax();
        let motion = DVector::from_fn(n, |i, _| Complex::new(solved.x[i], solved.x[n + i]));
        Ok((motion, solved.condition * f64::EPSILON * size))
    }

    /// Answers the loss factors of the modes, from the strain energies of the springs in them.
    pub(super) fn modal<W: Worksheet>(
        &self,
        stiffness: &DMatrix<f64>,
        found: &WorkedModes<W::Num>,
        sheet: W,
    ) {
        for (mode, square) in found.modes.squares.iter().enumerate() {
            if *square <= 0.0 {
                continue;
            }
            let shape = found.modes.shapes.column(mode).into_owned();
            let strain = shape.dot(&(stiffness * &shape));
            let loss = shape.dot(&(&self.matrix * &shape)) / strain;
            let why = (
                "Modal loss factor: loss factor of each spring times its share of the strain energy of the mode",
                EWINS.at("§2.7"),
            );
            let loss = sheet.numerical(("η_m", mode + 1), "1", loss, why);
            sheet.answer(("loss_factor", mode + 1), "Modal loss factor", loss);
            sheet.verify(|| {
                let lost: f64 = self
                    .springs
                    .iter()
                    .map(|spring| {
                        let [from, to] = spring.ends.map(|end| end.map_or(0.0, |at| shape[at]));
                        spring.loss_factor * spring.stiffness * (to - from).powi(2)
                    })
                    .sum();
                sheet.check(
                    Text::new("mode {mode}: energy lost in the springs, over 2π times the strain energy")
                        .with("mode", mode + 1),
                    W::Num::from(lost / *square),
                    loss,
                );
            });
        }
    }
}
