//! Friction in the joints of a moving mechanism.

use super::{Machine, substitute};
use crate::planar::{
    Contact, PlanarError,
    friction::{Effect, Frictionless, Response},
    vectors::dot,
};
use dalembert_numerics::ode::{OdeError, Problem};

/// A sliding slower than this part of the fastest velocity, or than so many times the tolerance, is at rest; the same
/// part of its size is nothing to any other margin of friction.
pub(in super::super) const NOISE: f64 = 1e-9;
const NOISES: f64 = 100.0;

impl Machine<'_> {
    /// Adds the Coulomb friction to accelerations and multipliers found without it; its power, W. Without a balance the
    /// accelerations are not numbers.
    pub(super) fn apply_friction(&mut self) -> f64 {
        let response = self.response();
        let Some(efforts) = response.efforts(&self.contacts) else {
            let jammed = response.jammed();
            self.jammed = Some(jammed);
            self.driving.fill(f64::NAN);
            return f64::NAN;
        };
        let power = response.power(&efforts);
        let Effect { free, accelerations, multipliers } = response.effect(&efforts);
        self.jammed = None;
        (self.driving, self.held, self.multipliers) = (free, accelerations, multipliers);
        // The joints that stick are independent: where there are as many as free motions and no driver moves, nothing
        // does. Rounding would let it creep.
        let drivers = &self.system.mechanism.drivers;
        let sticking = self.contacts.iter().filter(|contact| **contact == Contact::Sticking).count();
        if sticking == self.motions.len()
            && drivers.iter().all(|driver| driver.velocity == 0.0 && driver.acceleration == 0.0)
        {
            self.driving.fill(0.0);
        }
        power
    }

    /// Response of the joints to friction in the state whose rates were computed without it.
    fn response(&self) -> Response<'_> {
        let effect = Effect {
            free: self.driving.clone(),
            accelerations: self.held.clone(),
            multipliers: self.multipliers.clone(),
        };
        let frictionless = Frictionless {
            system: self.system,
            poses: &self.work.poses,
            velocities: &self.velocities,
            motions: &self.motions,
            effect,
        };
        Response::new(&self.frictions, frictionless, |force| {
            let mut free: Vec<f64> = self.motions.iter().map(|motion| dot(motion, force)).collect();
            substitute(&self.reduced, &mut free);
            let mut accelerations = vec![0.0; force.len()];
            for (motion, s) in self.motions.iter().zip(&free) {
                for (a, n) in accelerations.iter_mut().zip(motion) {
                    *a += n * s;
                }
            }
            let masses = accelerations.iter().zip(&self.masses).zip(force);
            let mut left: Vec<f64> = masses.map(|((a, mass), force)| mass * a - force).collect();
            let mut multipliers = vec![0.0; self.multipliers.len()];
            self.orders[self.now].multipliers(&mut left, &mut multipliers);
            Ok(Effect { free, accelerations, multipliers })
        })
        .expect("what a force does is always found")
    }

    /// Error of the mechanism for an error of the integrator.
    pub(in super::super) fn explained(&self, error: OdeError) -> PlanarError {
        self.jammed.clone().unwrap_or(PlanarError::Motion(error))
    }

    /// Returns true if joints have friction.
    pub(in super::super) fn has_friction(&self) -> bool {
        !self.frictions.is_empty()
    }

    /// Contact state of each joint with friction.
    pub(in super::super) fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Error bound of a friction margin.
    pub(in super::super) fn noise(&self) -> f64 {
        NOISE.max(NOISES * self.tolerance)
    }

    /// The margins of friction in a state ([`Response::margins`]).
    pub(in super::super) fn margins(&mut self, time: f64, state: &[f64], margins: &mut Vec<f64>) {
        let contacts = std::mem::take(&mut self.contacts);
        self.rates_of(time, state);
        let response = self.response();
        let fastest = self.fastest.max(f64::MIN_POSITIVE);
        match response.efforts(&contacts) {
            Some(efforts) => response.margins(&contacts, &efforts, fastest, margins),
            None => {
                margins.clear();
                margins.resize(2 * contacts.len() + 1, f64::NAN);
            }
        }
        self.contacts = contacts;
    }

    /// Finds anew in a state which joints stick and which slide; `used` is the margin that was used up, if one was, and
    /// whether it was so at once. The state from which the motion goes on: what rests, rests wholly.
    ///
    /// # Errors
    /// `Jammed`, `Sticks`.
    pub(in super::super) fn settled(
        &mut self,
        time: f64,
        state: &[f64],
        used: Option<(usize, bool)>,
    ) -> Result<Vec<f64>, PlanarError> {
        let (kept, count) = (self.layout.kept.len(), self.frictions.len());
        let mut state = state.to_vec();
        self.settle(time, &mut state);
        let mut contacts = std::mem::take(&mut self.contacts);
        self.rates_of(time, &state);
        let free = kept..kept + self.motions.len();
        let fastest = state[free.clone()].iter().fold(self.fastest, |most, v| most.max(v.abs()));
        let (noise, still) = (self.noise(), self.noise() * fastest);
        let response = self.response();
        let slides = response.contacts(still);
        if contacts.is_empty() {
            contacts.clone_from(&slides);
        }
        for (contact, now) in contacts.iter_mut().zip(slides) {
            if now == Contact::Indeterminate && matches!(contact, Contact::Sliding { .. }) {
                *contact = now;
            }
        }
        let mut opens = noise;
        match used {
            Some((stopped, at_once)) if stopped < count => {
                contacts[stopped] = Contact::Indeterminate;
                if at_once {
                    // It slid, if at all, for less than can be distinguished from rest.
                    opens = f64::INFINITY;
                }
            }
            Some((turned, _)) if turned < 2 * count => {
                if let Contact::Sliding { side, .. } = &mut contacts[turned - count] {
                    *side = -*side;
                }
            }
            Some(_) => {
                if let Some((_, begun)) = response.opening(&contacts)? {
                    contacts = begun;
                }
            }
            None => {}
        }
        response.settle(&mut contacts, fastest, [noise, opens])?;
        for (v, change) in state[free].iter_mut().zip(response.stopped(&contacts, still)?) {
            *v += change;
        }
        self.contacts = contacts;
        Ok(state)
    }

    /// Finds the rates of a state, for what they leave in the machine.
    fn rates_of(&mut self, time: f64, state: &[f64]) {
        let mut rates = vec![0.0; state.len()];
        self.rates(time, state, &mut rates);
    }
}
