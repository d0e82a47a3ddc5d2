//! Initial conditions of a system, the forces on it, and the motion of its base.

use dalembert_core::{Inputs, Refusal, Text};
use dalembert_mechanics::vibration::response::TimeExcitation;
use nalgebra::{DMatrix, DVector};

use super::histories::{AccelerationHistory, ForceHistory};
use crate::shared::letters::of_row;

/// Initial condition of a coordinate.
#[derive(Clone, Debug, Inputs)]
pub struct InitialCondition {
    /// Coordinate.
    #[input(min = 1, max = 500)]
    pub coordinate: usize,
    /// Displacement.
    #[input("x₀", "m", default = "0 m")]
    pub displacement: f64,
    /// Velocity.
    #[input("v₀", "m/s", default = "0 m/s")]
    pub velocity: f64,
}

/// A force on a coordinate.
#[derive(Clone, Debug, Inputs)]
pub struct Force {
    /// Coordinate.
    #[input(min = 1, max = 500)]
    pub coordinate: usize,
    /// Time history.
    pub course: ForceHistory,
}

/// Motion of the base.
#[derive(Clone, Debug, Inputs)]
pub struct BaseAcceleration {
    /// Time history.
    pub course: AccelerationHistory,
}

/// A coordinate that is examined.
#[derive(Clone, Debug, Inputs)]
pub struct Observed {
    /// Coordinate.
    #[input(min = 1, max = 500)]
    pub coordinate: usize,
}

/// Initial conditions and loads of a system, and the coordinates that are observed.
pub(crate) struct Excitation<'a> {
    pub(crate) start: &'a [InitialCondition],
    pub(crate) forces: &'a [Force],
    pub(crate) base: &'a [BaseAcceleration],
    pub(crate) observed: &'a [Observed],
}

impl Excitation<'_> {
    /// The start and the forces, as vectors over all coordinates.
    ///
    /// # Errors
    /// A coordinate that the system has not; too many observed ones; a table of a force whose times decrease.
    pub(crate) fn over(&self, mass: &DMatrix<f64>) -> Result<TimeExcitation, Refusal> {
        let n = mass.nrows();
        let all =
            self.start.iter().map(|row| row.coordinate).chain(self.forces.iter().map(|row| row.coordinate));
        if let Some(wrong) = all.chain(self.observed.iter().map(|row| row.coordinate)).find(|&at| at > n) {
            let why = Text::new("there is no coordinate {at}: the system has {n}");
            return Err(Refusal::because(why.with("at", wrong).with("n", n)));
        }
        if self.observed.len() > 50 {
            return Err(Refusal::because("at most 50 times and 50 coordinates are computed at a time"));
        }
        let mut excitation = TimeExcitation {
            position: DVector::zeros(n),
            velocity: DVector::zeros(n),
            pushes: Vec::new(),
            harmonics: Vec::new(),
        };
        for row in self.start {
            excitation.position[row.coordinate - 1] = row.displacement;
            excitation.velocity[row.coordinate - 1] = row.velocity;
        }
        for row in self.forces {
            let on =
                |size: f64| DVector::from_fn(n, |at, _| if at + 1 == row.coordinate { size } else { 0.0 });
            row.course.history()?.add_to(&mut excitation, on);
        }
        // In coordinates relative to the base the inertia forces of its motion act: −M 1 a.
        let inertia = -(mass * DVector::from_element(n, 1.0));
        for row in self.base {
            row.course.history()?.add_to(&mut excitation, |size| &inertia * size);
        }
        Ok(excitation)
    }
}

/// The letters of forces, with the coordinates that they act on.
pub(crate) fn loads(forces: &[Force]) -> Vec<(usize, Text)> {
    forces.iter().zip(1..).map(|(force, row)| (force.coordinate, of_row(&["F"], row))).collect()
}
