//! Changes of contact during a motion: joints with friction that come to rest, stick and begin to slide.

use super::EquationsOfMotion;
use crate::planar::{
    Contact, PlanarError,
    tolerances::{REST_SPEED, REST_SPEED_IN_TOLERANCES},
};
use dalembert_numerics::ode::OdeSystem;

impl EquationsOfMotion<'_> {
    /// Reports whether a joint has friction.
    pub(in super::super) fn has_friction(&self) -> bool {
        !self.frictions.is_empty()
    }

    /// The state of contact of each joint with friction, in the order of these loads.
    pub(in super::super) fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Rounding of a margin of friction, relative to its size.
    pub(in super::super) fn margin_rounding(&self) -> f64 {
        REST_SPEED.max(REST_SPEED_IN_TOLERANCES * self.tolerance)
    }

    /// The margins of friction in a state ([`Response::margins`](super::super::friction::FrictionResponse::margins)).
    pub(in super::super) fn margins(&mut self, time: f64, state: &[f64], margins: &mut Vec<f64>) {
        let (tree, independent) = (self.tree(), self.independent());
        let Self { data, frictions, contacts, max_velocity, .. } = self;
        let moving = data.position(time, &state[..tree]).factored().velocities(&state[independent]);
        let response = moving.accelerations().friction_response(frictions);
        match response.efforts(contacts) {
            Some(efforts) => {
                response.margins(contacts, &efforts, max_velocity.max(f64::MIN_POSITIVE), margins);
            }
            None => {
                margins.clear();
                margins.resize(2 * contacts.len() + 1, f64::NAN);
            }
        }
    }

    /// Finds anew in a state which joints stick and which slide; `used` is the margin that was used up, if one was, and
    /// whether it was so at once. The state from which the motion goes on: joints at rest have no velocity there.
    ///
    /// # Errors
    /// `Jammed`, `Sticks`.
    pub(in super::super) fn recontacted(
        &mut self,
        time: f64,
        state: &[f64],
        used: Option<(usize, bool)>,
    ) -> Result<Vec<f64>, PlanarError> {
        let mut state = state.to_vec();
        self.settle(time, &mut state);
        let independent = self.independent();
        let max_velocity =
            state[independent.clone()].iter().fold(self.max_velocity, |most, v| most.max(v.abs()));
        let rounding = self.margin_rounding();
        let rest = rounding * max_velocity;
        let tree = self.tree();
        let Self { data, frictions, contacts: present, .. } = self;
        let factored = data.position(time, &state[..tree]).factored();
        let moving = factored.velocities(&state[independent.clone()]);
        let response = moving.accelerations().friction_response(frictions);
        let mut contacts = present.clone();
        let by_velocity = response.contacts(rest);
        if contacts.is_empty() {
            contacts.clone_from(&by_velocity);
        }
        for (contact, now) in contacts.iter_mut().zip(by_velocity) {
            if now == Contact::Indeterminate && matches!(contact, Contact::Sliding { .. }) {
                *contact = now;
            }
        }
        let count = frictions.len();
        let mut opening = rounding;
        match used {
            Some((stopped, at_once)) if stopped < count => {
                contacts[stopped] = Contact::Indeterminate;
                if at_once {
                    // It slid, if at all, for less than can be distinguished from rest.
                    opening = f64::INFINITY;
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
        response.settle(&mut contacts, max_velocity, [rounding, opening])?;
        for (v, change) in state[independent].iter_mut().zip(response.stopped(&contacts, rest)?) {
            *v += change;
        }
        *present = contacts;
        Ok(state)
    }
}
