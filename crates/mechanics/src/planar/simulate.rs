//! The motion of a mechanism under its loads, from a start to an end.
//!
//! Of the positions those are integrated that no equation gives explicitly, of the velocities as many as there are
//! degrees of freedom; after each step the positions are brought back onto the joints, so that these never drift apart
//! (E. J. Haug, *Computer-Aided Kinematics and Dynamics of Mechanical Systems* (1989), §7.3; E. Hairer, G. Wanner,
//! *Solving Ordinary Differential Equations II*, §VII.2).

use super::{Contact, Measure, PlanarError, State, System, machine::Machine};
use dalembert_numerics::ode::{self, Integrator, OdeError, SAME_TIME};

/// Options of an integration: the tolerance is in parts of the size of the mechanism and of its largest velocity.
pub type Run<'a> = ode::Run<'a, End>;

/// Terminal event of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// A measure reaches a value, m or rad.
    Reaches(Measure, f64),
    /// A measure comes to rest.
    Rests(Measure),
}

/// A motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// From the start to the end.
    pub samples: Vec<Snapshot>,
    /// Index of the event that ended the motion, if any.
    pub ended: Option<usize>,
    /// Contact states of the joints with friction at the end, in the order of these loads.
    pub contacts: Vec<Contact>,
    /// Number of integration steps.
    pub steps: usize,
}

/// A moment of a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// Time, s.
    pub time: f64,
    /// Positions, velocities and accelerations.
    pub state: State,
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
        let left = |sample: &Snapshot| sample.kinetic + sample.stored - sample.work;
        let first = self.samples.first().map_or(0.0, left);
        self.samples.iter().map(|sample| (left(sample) - first).abs()).fold(0.0, f64::max)
    }
}

impl System {
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
        run: &Run,
    ) -> Result<Trajectory, PlanarError> {
        let mut machine = Machine::new(self, positions, run.tolerance, run.cancelled);
        let mut state = machine.state(positions, velocities, 0.0);
        machine.begin(&state);
        let mut samples = Vec::with_capacity(run.samples);
        let first = sample(&mut machine, 0.0, &state);
        let near = |first: &Snapshot| {
            let allowed = 1e-9 * self.reach(positions);
            let parts = first.state.positions.iter().flatten().zip(positions.iter().flatten());
            parts.into_iter().all(|(a, b)| (a - b).abs() <= allowed)
        };
        if !first.as_ref().is_some_and(near) {
            self.closed(positions)?;
        }
        let Some(first) = first else { return Err(machine.refusal()) };
        state = machine.state(&first.state.positions, &first.state.velocities, 0.0);
        let lost = |time: f64| PlanarError::Motion(OdeError::NotFinite { at: time });
        if machine.has_friction() {
            state = machine.settled(0.0, &state, None)?;
            samples.push(sample(&mut machine, 0.0, &state).ok_or_else(|| lost(0.0))?);
        } else {
            samples.push(first);
        }
        let mut integrator = Integrator::new(&mut machine, 0.0, &state, run.duration, run.most_steps)?;
        if run.samples > 2 || !run.ends.is_empty() || machine.has_friction() {
            integrator = integrator.looked_between();
        }
        let residuals = run.samples.saturating_sub(1);
        let time_of = |index: usize| {
            if index == residuals { run.duration } else { run.duration * index as f64 / residuals as f64 }
        };
        let mut ended = None;
        while integrator.time() < run.duration && ended.is_none() {
            integrator.advance(&mut machine, run.duration).map_err(|error| machine.explained(error))?;
            let mut until = integrator.time();
            let mut used = None;
            if machine.has_friction() {
                let noise = machine.noise();
                if let Some((time, margin)) = integrator.first_fall(&mut machine, noise, Machine::margins) {
                    (until, used) = (time, Some((margin, time <= integrator.before())));
                }
            }
            let late = SAME_TIME * (integrator.time() - integrator.before());
            for (index, end) in run.ends.iter().enumerate() {
                let number = |machine: &mut Machine, time: f64, state: &[f64]| match end {
                    End::Reaches(measure, value) => machine.measured(measure, time, state)[0] - value,
                    End::Rests(measure) => machine.measured(measure, time, state)[1],
                };
                let zero = integrator.first_zero(&mut machine, number);
                if let Some(time) = zero.filter(|time| *time <= until + late) {
                    if time < until - late {
                        used = None;
                    }
                    (until, ended) = (time.min(until), Some(index));
                }
            }
            while samples.len() <= residuals && time_of(samples.len()) <= until {
                let time = time_of(samples.len());
                samples.push(between(&mut machine, &mut integrator, time).ok_or_else(|| lost(time))?);
            }
            let mut next = None;
            if used.is_some() || ended.is_some() {
                integrator.back();
                while integrator.time() < until {
                    integrator.advance(&mut machine, until).map_err(|error| machine.explained(error))?;
                    let time = integrator.time();
                    if let Some(state) = machine.renewed(time, integrator.state()) {
                        integrator.restart(&mut machine, time, &state)?;
                    }
                }
                next = Some(integrator.state().to_vec());
            }
            if let (Some(state), true) = (&mut next, machine.has_friction()) {
                *state = machine.settled(until, state, used)?;
            }
            let now = next.as_deref().unwrap_or(integrator.state());
            if ended.is_some() {
                samples.pop_if(|last| last.time >= until);
                samples.push(sample(&mut machine, until, now).ok_or_else(|| lost(until))?);
            } else if let Some(state) = machine.renewed(until, now).or(next) {
                integrator.restart(&mut machine, until, &state)?;
            }
        }
        let contacts = machine.contacts().to_vec();
        Ok(Trajectory { samples, ended, contacts, steps: integrator.steps() })
    }
}

/// A moment within the last step. Close to a singular position, where velocities and accelerations do not follow from the
/// position, it is interpolated from moments of the step that are further away.
fn between(machine: &mut Machine, integrator: &mut Integrator, time: f64) -> Option<Snapshot> {
    /// Parts of the step between the moments, and how many of them are kept away from.
    const PARTS: u32 = 11;
    const AWAY: f64 = 2.0;
    let state = integrator.at(machine, time);
    if !machine.is_singular(time, &state) {
        return sample(machine, time, &state);
    }
    let (begin, end) = (integrator.before(), integrator.time());
    let at = |part: u32| {
        if part == PARTS { end } else { begin + (end - begin) * f64::from(part) / f64::from(PARTS) }
    };
    let away = AWAY * (end - begin) / f64::from(PARTS);
    let times: Vec<f64> = (0..=PARTS).map(at).filter(|other| (time - other).abs() >= away).collect();
    let mut sum: Option<Snapshot> = None;
    for &here in &times {
        let others = times.iter().filter(|other| **other != here);
        let weight: f64 = others.map(|other| (time - other) / (here - other)).product();
        let state = integrator.at(machine, here);
        let found = sample(machine, here, &state)?;
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

impl Snapshot {
    /// Adds so many times another one.
    fn add(&mut self, times: f64, other: &Snapshot) {
        let State { positions, velocities, accelerations } = &mut self.state;
        let parts = [
            (positions, &other.state.positions),
            (velocities, &other.state.velocities),
            (accelerations, &other.state.accelerations),
        ];
        for (ours, theirs) in parts {
            for (x, y) in ours.iter_mut().flatten().zip(theirs.iter().flatten()) {
                *x += times * y;
            }
        }
        self.kinetic += times * other.kinetic;
        self.stored += times * other.stored;
        self.work += times * other.work;
    }
}

fn sample(machine: &mut Machine, time: f64, state: &[f64]) -> Option<Snapshot> {
    let (state, work) = machine.full(time, state)?;
    let [kinetic, stored] = machine.energies();
    Some(Snapshot { time, state, kinetic, stored, work })
}
