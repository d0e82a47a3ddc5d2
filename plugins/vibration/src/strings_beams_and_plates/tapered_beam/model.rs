//! A linear taper, or the course of a table: one interface to both kernels.

use dalembert_mechanics::beam::{
    tapered::{Ritz, RitzShape, Tapered},
    varying::{Varying, VaryingRitz, VaryingShape},
};
use dalembert_numerics::linalg::LinalgError;

/// Terms of the trial functions along a linear taper.
const TERMS: usize = 24;

/// A beam whose section varies.
pub(super) enum VaryingBeam {
    Linear(Tapered),
    Table(Varying),
}

/// The shape of a vibration.
pub(super) enum VaryingMode {
    Linear(RitzShape),
    Table(VaryingShape),
}

impl VaryingBeam {
    /// Terms that the answers are found with: in all, or between two points of a table.
    pub(super) fn terms(&self) -> usize {
        match self {
            VaryingBeam::Linear(_) => TERMS,
            VaryingBeam::Table(beam) => (2 * TERMS / (beam.points.len() - 1)).clamp(8, 20),
        }
    }

    /// Smaller numbers of terms, for the convergence.
    pub(super) fn convergence_terms(&self, wanted: usize) -> impl Iterator<Item = usize> + use<> {
        let first = match self {
            VaryingBeam::Linear(_) => wanted.max(2),
            VaryingBeam::Table(beam) => (wanted + 2).saturating_sub(beam.points.len()).max(1),
        };
        (first..self.terms()).step_by(if matches!(self, VaryingBeam::Linear(_)) { 3 } else { 1 })
    }

    /// Motions of the beam as a whole that nothing holds.
    pub(super) fn rigid_motions(&self) -> usize {
        match self {
            VaryingBeam::Linear(beam) => beam.rigid_motions(),
            VaryingBeam::Table(beam) => beam.rigid_motions(),
        }
    }

    /// The lowest `λ` and their shapes.
    pub(super) fn ritz(
        &self,
        terms: usize,
        count: usize,
    ) -> Result<(Vec<f64>, Vec<VaryingMode>), LinalgError> {
        Ok(match self {
            VaryingBeam::Linear(beam) => {
                let Ritz { lambdas, shapes } = beam.ritz(terms, count)?;
                (lambdas, shapes.into_iter().map(VaryingMode::Linear).collect())
            }
            VaryingBeam::Table(beam) => {
                let VaryingRitz { lambdas, shapes } = beam.ritz(terms, count)?;
                (lambdas, shapes.into_iter().map(VaryingMode::Table).collect())
            }
        })
    }

    /// `λ` of a shape from the moments of its inertia forces.
    pub(super) fn moment_quotient(&self, shape: &VaryingMode) -> Result<f64, LinalgError> {
        match (self, shape) {
            (VaryingBeam::Linear(beam), VaryingMode::Linear(shape)) => beam.moment_quotient(shape),
            (VaryingBeam::Table(beam), VaryingMode::Table(shape)) => beam.moment_quotient(shape),
            _ => Err(LinalgError::NotConverged),
        }
    }
}

impl VaryingMode {
    /// Deflection at a share of the length.
    pub(super) fn deflection(&self, xi: f64) -> f64 {
        match self {
            VaryingMode::Linear(shape) => shape.deflection(xi),
            VaryingMode::Table(shape) => shape.deflection(xi),
        }
    }

    /// Points between the ends that stay at rest, ascending.
    pub(super) fn nodes(&self) -> Vec<f64> {
        match self {
            VaryingMode::Linear(shape) => shape.nodes(),
            VaryingMode::Table(shape) => shape.nodes(),
        }
    }
}
