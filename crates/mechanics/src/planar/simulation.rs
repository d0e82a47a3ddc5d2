//! The motion of a mechanism under its loads, from a start to an end.
//!
//! Of the positions those are integrated that no equation gives explicitly, of the velocities as many as there are
//! degrees of freedom; after each step the positions are brought back onto the constraints, so that these never drift
//! (E. J. Haug, *Computer-Aided Kinematics and Dynamics of Mechanical Systems* (1989), §7.3; E. Hairer, G. Wanner,
//! *Solving Ordinary Differential Equations II*, §VII.2).

use super::{
    Model, PlanarError, PlanarRun, Snapshot, Trajectory,
    equations_of_motion::EquationsOfMotion,
    events::FirstEvent,
    tolerances::{INTERPOLATION_GAP, INTERPOLATION_PARTS, START_DISTANCE},
};
use dalembert_numerics::ode::{Integrator, OdeError};

impl Model {
    /// Follows the motion from positions and velocities that satisfy joints and drivers. The drivers go on from
    /// their values with constant acceleration; what no driver drives moves freely. A joint with friction that comes to
    /// rest sticks until its loads overcome it; every such change ends a step.
    ///
    /// # Errors
    /// `Massless`, `Jammed`, `Sticks`; `DoesNotClose` if the positions do not satisfy the joints; `Motion` when it ends
    /// early or is stopped; `NotFinite`.
    pub fn simulate(
        &self,
        positions: &[[f64; 3]],
        velocities: &[[f64; 3]],
        run: &PlanarRun,
    ) -> Result<Trajectory, PlanarError> {
        let mut motion = EquationsOfMotion::new(self, positions, run.tolerance, run.cancelled);
        let mut state = motion.state(positions, velocities, 0.0);
        motion.begin(&state);
        let mut samples = Vec::with_capacity(run.samples);
        let first = motion.snapshot(0.0, &state);
        let is_near = |first: &Snapshot| {
            let allowed = START_DISTANCE * self.reach(positions);
            let mut coordinates = first.state.positions.iter().flatten().zip(positions.iter().flatten());
            coordinates.all(|(a, b)| (a - b).abs() <= allowed)
        };
        if !first.as_ref().is_some_and(is_near) {
            self.check_closed(positions, &self.driver_values())?;
        }
        let Some(first) = first else { return Err(motion.refusal()) };
        state = motion.state(&first.state.positions, &first.state.velocities, 0.0);
        let lost = |time: f64| PlanarError::Motion(OdeError::NotFinite { at: time });
        if motion.has_friction() {
            state = motion.recontacted(0.0, &state, None)?;
            samples.push(motion.snapshot(0.0, &state).ok_or_else(|| lost(0.0))?);
        } else {
            samples.push(first);
        }
        let mut integrator = Integrator::new(&mut motion, 0.0, &state, run.duration, run.most_steps)?;
        if run.samples > 2 || !run.ends.is_empty() || motion.has_friction() {
            integrator = integrator.examined_between();
        }
        let intervals = run.samples.saturating_sub(1);
        let time_of = |index: usize| {
            if index == intervals { run.duration } else { run.duration * index as f64 / intervals as f64 }
        };
        let mut ended = None;
        while integrator.time() < run.duration && ended.is_none() {
            integrator.advance(&mut motion, run.duration).map_err(|error| motion.error(error))?;
            let event = FirstEvent::locate(&mut motion, &mut integrator, run.ends);
            let until = event.time;
            ended = event.ended;
            while samples.len() <= intervals && time_of(samples.len()) <= until {
                let time = time_of(samples.len());
                let sample = within_step(&mut motion, &mut integrator, time);
                samples.push(sample.ok_or_else(|| lost(time))?);
            }
            let mut next = None;
            if event.used.is_some() || ended.is_some() {
                integrator.back();
                while integrator.time() < until {
                    integrator.advance(&mut motion, until).map_err(|error| motion.error(error))?;
                    let time = integrator.time();
                    if let Some(state) = motion.reordered(time, integrator.state()) {
                        integrator.restart(&mut motion, time, &state)?;
                    }
                }
                next = Some(integrator.state().to_vec());
            }
            if let (Some(state), true) = (&mut next, motion.has_friction()) {
                *state = motion.recontacted(until, state, event.used)?;
            }
            let now = next.as_deref().unwrap_or(integrator.state());
            if ended.is_some() {
                samples.pop_if(|last| last.time >= until);
                samples.push(motion.snapshot(until, now).ok_or_else(|| lost(until))?);
            } else if let Some(state) = motion.reordered(until, now).or(next) {
                integrator.restart(&mut motion, until, &state)?;
            }
        }
        let contacts = motion.contacts().to_vec();
        Ok(Trajectory { samples, ended, contacts, steps: integrator.steps() })
    }
}

/// A moment within the last step. Close to a singular position, where velocities and accelerations do not follow from
/// the position, it is interpolated (Lagrange) from moments of the step that are further away.
fn within_step(motion: &mut EquationsOfMotion, integrator: &mut Integrator, time: f64) -> Option<Snapshot> {
    let state = integrator.at(motion, time);
    if !motion.is_singular(time, &state) {
        return motion.snapshot(time, &state);
    }
    let (begin, end) = (integrator.before(), integrator.time());
    let parts = f64::from(INTERPOLATION_PARTS);
    let at = |part: u32| {
        if part == INTERPOLATION_PARTS { end } else { begin + (end - begin) * f64::from(part) / parts }
    };
    let gap = INTERPOLATION_GAP * (end - begin) / parts;
    let times: Vec<f64> =
        (0..=INTERPOLATION_PARTS).map(at).filter(|other| (time - other).abs() >= gap).collect();
    let mut sum: Option<Snapshot> = None;
    for &here in &times {
        let others = times.iter().filter(|other| **other != here);
        let weight: f64 = others.map(|other| (time - other) / (here - other)).product();
        let state = integrator.at(motion, here);
        let found = motion.snapshot(here, &state)?;
        match &mut sum {
            Some(sum) => sum.add(weight, &found),
            None => {
                let mut first = found.clone();
                first.add(weight - 1.0, &found);
                sum = Some(first);
            }
        }
    }
    sum.map(|sum| Snapshot { time, ..sum })
}
