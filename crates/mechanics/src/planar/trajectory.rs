//! The result of a simulation: moments of a motion.

use super::{Contact, Event, PlanarState};
use dalembert_numerics::ode;

/// Duration and tolerance of a simulation: the tolerance is relative to the size of the mechanism and to its largest
/// velocity.
pub type PlanarRun<'a> = ode::Integration<'a, Event>;

/// A motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// From the start to the end.
    pub samples: Vec<Snapshot>,
    /// The index of the event that ended it, if one did.
    pub ended: Option<usize>,
    /// The state of contact of the joints with friction at the end, in the order of these loads.
    pub contacts: Vec<Contact>,
    /// The number of steps that the integrator tried.
    pub steps: usize,
}

/// A moment of a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// Time, s.
    pub time: f64,
    /// Positions, velocities and accelerations.
    pub state: PlanarState,
    /// Kinetic energy, J.
    pub kinetic: f64,
    /// Energy of weights, springs and all other loads that have a potential, J, from an arbitrary level.
    pub stored: f64,
    /// Work since the start of the drivers, of friction and of the other loads without potential, J.
    pub work: f64,
}

impl Trajectory {
    /// The largest difference of the energy balance `T + V − W` from the start, J: zero for an exact motion.
    pub fn imbalance(&self) -> f64 {
        let balance = |sample: &Snapshot| sample.kinetic + sample.stored - sample.work;
        let first = self.samples.first().map_or(0.0, balance);
        self.samples.iter().map(|sample| (balance(sample) - first).abs()).fold(0.0, f64::max)
    }
}

impl Snapshot {
    /// Adds so many times another one, the time left out.
    pub(super) fn add(&mut self, times: f64, other: &Snapshot) {
        let PlanarState { positions, velocities, accelerations } = &mut self.state;
        let parts = [
            (positions, &other.state.positions),
            (velocities, &other.state.velocities),
            (accelerations, &other.state.accelerations),
        ];
        for (sums, added) in parts {
            for (x, y) in sums.iter_mut().flatten().zip(added.iter().flatten()) {
                *x += times * y;
            }
        }
        self.kinetic += times * other.kinetic;
        self.stored += times * other.stored;
        self.work += times * other.work;
    }
}
