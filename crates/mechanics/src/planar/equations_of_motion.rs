//! The equations of motion of a mechanism as a problem of the integrator: its state is the tree coordinates, the
//! independent velocities and, where drivers or loads have no potential, their work.

mod contacts;

use std::ops::Range;

use super::{
    Contact, Model, PlanarError, RelativeCoordinate, Snapshot,
    data::{Accelerated, Data, Moving, Quality},
    elimination::Conditioning,
    friction::FrictionLaw,
    tolerances::{
        DEGENERATE_TOLERANCE, MAX_SINGULAR_TOLERANCE, MIN_PIVOT_OF_VELOCITIES, MOTION_MAX_CORRECTION,
        MOTION_MAX_CORRECTION_IN_TOLERANCES, MOTION_MAX_ITERATIONS, MOTION_RESIDUAL,
        MOTION_SINGULAR_RESIDUAL, MOTION_STALLED_RESIDUAL, SINGULAR_ROUNDING, SINGULARITY_LOOKAHEAD,
        STALLED_RESIDUAL,
    },
    vectors::{body_that_moves_most, largest},
};
use dalembert_numerics::ode::{OdeError, OdeSystem};

/// A model in motion.
pub(super) struct EquationsOfMotion<'a> {
    model: &'a Model,
    data: Data<'a>,
    frictions: Vec<FrictionLaw>,
    /// The state of each joint with friction, until a margin of it is used up.
    contacts: Vec<Contact>,
    /// The reason why the last rates are not numbers, if it is friction.
    jammed: Option<PlanarError>,
    /// True if the work of loads without potential and of drivers is part of the state.
    has_work: bool,
    /// Of a step: relative to the size and to the largest velocity.
    tolerance: f64,
    /// The largest independent velocity at the start, m/s, or what the accelerations can make of the size.
    max_velocity: f64,
    cancelled: &'a dyn Fn() -> bool,
}

impl<'a> EquationsOfMotion<'a> {
    /// The motion of a model from closed positions.
    pub(super) fn new(
        model: &'a Model,
        positions: &[[f64; 3]],
        tolerance: f64,
        cancelled: &'a dyn Fn() -> bool,
    ) -> Self {
        Self {
            data: Data::new(model, positions),
            frictions: model.frictional_joints(),
            contacts: Vec::new(),
            jammed: None,
            has_work: model.has_work(),
            tolerance,
            max_velocity: 0.0,
            cancelled,
            model,
        }
    }

    /// The state of positions and velocities.
    pub(super) fn state(&self, positions: &[[f64; 3]], velocities: &[[f64; 3]], work: f64) -> Vec<f64> {
        let mut state = self.model.tree_coordinates(positions);
        state.extend(self.data.independent().iter().map(|&column| self.model.scaled(column, velocities)));
        state.extend(self.has_work.then_some(work));
        state
    }

    /// The number of tree coordinates, which come first in a state.
    fn tree(&self) -> usize {
        self.model.layout.tree.len()
    }

    /// The independent velocities in a state.
    fn independent(&self) -> Range<usize> {
        self.tree()..self.tree() + self.data.independent().len()
    }

    /// Positions and velocities of a state.
    fn moving(&mut self, time: f64, state: &[f64]) -> Moving<'_, 'a> {
        let (tree, independent) = (self.tree(), self.independent());
        self.data.position(time, &state[..tree]).factored().velocities(&state[independent])
    }

    /// Everything in a state, and its rates.
    fn evaluated(&mut self, time: f64, state: &[f64], rates: &mut [f64]) -> Accelerated<'_, 'a> {
        let (tree, independent) = (self.tree(), self.independent());
        let Self { model, data, frictions, contacts, jammed, has_work, .. } = self;
        let moving = data.position(time, &state[..tree]).factored().velocities(&state[independent.clone()]);
        for (rate, &column) in rates.iter_mut().zip(&model.layout.tree) {
            *rate = moving.scaled()[column];
        }
        let mut accelerated = moving.accelerations();
        if !contacts.is_empty() {
            *jammed = accelerated.add_friction(frictions, contacts).err();
        }
        rates[independent].copy_from_slice(accelerated.independent());
        if *has_work {
            accelerated.power += accelerated.driver_power();
            rates[state.len() - 1] = accelerated.power;
        }
        accelerated
    }

    /// A moment of the motion in a state, brought onto the constraints.
    pub(super) fn snapshot(&mut self, time: f64, state: &[f64]) -> Option<Snapshot> {
        let mut state = state.to_vec();
        if self.settle(time, &mut state) { self.snapshot_of_settled(time, &state) } else { None }
    }

    fn snapshot_of_settled(&mut self, time: f64, state: &[f64]) -> Option<Snapshot> {
        let mut rates = vec![0.0; state.len()];
        let work = if self.has_work { state[state.len() - 1] } else { 0.0 };
        let accelerated = self.evaluated(time, state, &mut rates);
        let [kinetic, stored] = accelerated.energies();
        let full = accelerated.state();
        rates.iter().all(|x| x.is_finite()).then_some(Snapshot { time, state: full, kinetic, stored, work })
    }

    /// Reports whether a state is so close to a singular position that the velocities which follow from it are
    /// rounding.
    pub(super) fn is_singular(&mut self, time: f64, state: &[f64]) -> bool {
        let tree = self.tree();
        let factored = self.data.position(time, &state[..tree]).factored();
        factored.smallest_pivot() < MIN_PIVOT_OF_VELOCITIES
            && factored.conditioning() == Conditioning::NearSingular
    }

    /// The value of a measure and its velocity, in a state that need not satisfy the constraints.
    pub(super) fn measure(&mut self, measure: &RelativeCoordinate, time: f64, state: &[f64]) -> [f64; 2] {
        self.moving(time, state).measure(measure)
    }

    /// The state in another order of pivots, if the present one has become weak.
    pub(super) fn reordered(&mut self, time: f64, state: &[f64]) -> Option<Vec<f64>> {
        let tree = self.tree();
        if !self.data.position(time, &state[..tree]).factored().is_weak() {
            return None;
        }
        let mut state = state.to_vec();
        if !self.settle(time, &mut state) {
            return None;
        }
        let snapshot = self.snapshot_of_settled(time, &state)?;
        self.data.position(time, &state[..tree]).select_order();
        Some(self.state(&snapshot.state.positions, &snapshot.state.velocities, snapshot.work))
    }

    /// The error for a start that cannot move.
    pub(super) fn refusal(&self) -> PlanarError {
        let massless = self.data.basis().iter().find(|motion| {
            let inertia: f64 = motion.iter().zip(&self.model.masses).map(|(n, mass)| n * n * mass).sum();
            inertia == 0.0
        });
        massless.map_or(PlanarError::NotFinite, |motion| PlanarError::Massless {
            body: body_that_moves_most(motion),
        })
    }

    /// The error that an error of the integrator stands for.
    pub(super) fn error(&self, error: OdeError) -> PlanarError {
        self.jammed.clone().unwrap_or(PlanarError::Motion(error))
    }

    /// Sets the size of velocities from those of the start and from what the accelerations can make of the size of the
    /// mechanism.
    pub(super) fn begin(&mut self, state: &[f64]) {
        let mut rates = vec![0.0; state.len()];
        self.evaluated(0.0, state, &mut rates);
        let independent = self.independent();
        let velocity = largest(&state[independent.clone()])
            .max((largest(&rates[independent]) * self.model.length).sqrt());
        self.max_velocity = if velocity > 0.0 { velocity } else { self.model.length };
    }
}

impl OdeSystem for EquationsOfMotion<'_> {
    fn rates(&mut self, time: f64, state: &[f64], rates: &mut [f64]) {
        self.evaluated(time, state, rates);
    }

    fn allowed(&mut self, before: &[f64], after: &[f64], allowed: &mut [f64]) {
        let (tree, independent) = (self.tree(), self.independent());
        let Quality { conditioning, smallest_pivot } = self.data.take_quality();
        let tolerance = match conditioning {
            Conditioning::Regular => self.tolerance,
            Conditioning::NearSingular => {
                let loops = self.model.layout.loops.len() as f64;
                let rounding = SINGULAR_ROUNDING * loops * f64::EPSILON / smallest_pivot.powi(2);
                self.tolerance.max(rounding.min(MAX_SINGULAR_TOLERANCE))
            }
            // A shorter step comes to where another order is selected.
            Conditioning::Degenerate => DEGENERATE_TOLERANCE,
        };
        allowed[..tree].fill(tolerance * self.model.length);
        let ends = before[independent.clone()].iter().chain(&after[independent.clone()]);
        let max_velocity = ends.fold(self.max_velocity, |most, v| most.max(v.abs()));
        allowed[independent].fill(tolerance * max_velocity);
        if self.has_work {
            allowed[before.len() - 1] = f64::INFINITY;
        }
    }

    fn settle(&mut self, time: f64, state: &mut [f64]) -> bool {
        let (tree, length) = (self.tree(), self.model.length);
        let max_correction =
            MOTION_MAX_CORRECTION.max(MOTION_MAX_CORRECTION_IN_TOLERANCES * self.tolerance) * length;
        let mut last = f64::INFINITY;
        for iteration in 0..=MOTION_MAX_ITERATIONS {
            let position = self.data.position(time, &state[..tree]);
            let residual = position.residual();
            if residual.is_nan() {
                return false;
            }
            let is_accepted = residual <= MOTION_STALLED_RESIDUAL * length;
            let is_stalled = is_accepted && residual > STALLED_RESIDUAL * last;
            if residual <= MOTION_RESIDUAL * length || is_stalled || iteration == MOTION_MAX_ITERATIONS {
                return is_accepted;
            }
            last = residual;
            let factored = position.factored();
            if residual <= MOTION_SINGULAR_RESIDUAL * length
                && factored.conditioning() == Conditioning::NearSingular
            {
                return true;
            }
            let mut size = 0.0f64;
            for (x, correction) in state.iter_mut().zip(factored.correction()) {
                *x -= correction;
                size = size.max(correction.abs());
            }
            if size.is_nan() || size > max_correction {
                return false;
            }
        }
        false
    }

    fn singular(&mut self, time: f64, state: &[f64], rates: &[f64]) -> [f64; 2] {
        let tree = self.tree();
        let velocity = largest(&rates[..tree]);
        let here = self.data.position(time, &state[..tree]).factored();
        if !here.is_falling() || velocity == 0.0 {
            return [f64::INFINITY; 2];
        }
        let before = here.reduced_rows();
        let ahead = SINGULARITY_LOOKAHEAD * self.model.length / velocity;
        let moved: Vec<f64> = state.iter().zip(&rates[..tree]).map(|(x, rate)| x + ahead * rate).collect();
        let there = self.data.position(time + ahead, &moved).factored();
        there.steps_to_singularity(&before).map(|steps| steps * ahead)
    }

    fn stopped(&self) -> bool {
        (self.cancelled)()
    }
}
