//! Events of a motion: a measure that reaches a value or comes to rest ends it, a margin of friction that is used up
//! changes the contacts.

use super::{RelativeCoordinate, equations_of_motion::EquationsOfMotion};
use dalembert_numerics::ode::{Integrator, SAME_TIME};

/// An event that ends a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event {
    /// A measure reaches a value, m or rad.
    Reaches(RelativeCoordinate, f64),
    /// A measure comes to rest.
    Rests(RelativeCoordinate),
}

/// The first event within the last step of the integrator; its end if there is none.
pub(super) struct FirstEvent {
    /// Time, s.
    pub(super) time: f64,
    /// The event that ends the motion, by its index.
    pub(super) ended: Option<usize>,
    /// The margin of friction that is used up, and whether it was so at the beginning of the step.
    pub(super) used: Option<(usize, bool)>,
}

impl FirstEvent {
    /// Locates the first of these events, and of the margins of friction, within the last step.
    pub(super) fn locate(
        motion: &mut EquationsOfMotion,
        integrator: &mut Integrator,
        events: &[Event],
    ) -> Self {
        let mut first = Self { time: integrator.time(), ended: None, used: None };
        if motion.has_friction() {
            let rounding = motion.margin_rounding();
            if let Some((time, margin)) = integrator.first_fall(motion, rounding, EquationsOfMotion::margins)
            {
                (first.time, first.used) = (time, Some((margin, time <= integrator.before())));
            }
        }
        let same = SAME_TIME * (integrator.time() - integrator.before());
        for (index, event) in events.iter().enumerate() {
            let function = |motion: &mut EquationsOfMotion, time: f64, state: &[f64]| match event {
                Event::Reaches(measure, value) => motion.measure(measure, time, state)[0] - value,
                Event::Rests(measure) => motion.measure(measure, time, state)[1],
            };
            let zero = integrator.first_zero(motion, function);
            if let Some(time) = zero.filter(|time| *time <= first.time + same) {
                if time < first.time - same {
                    first.used = None;
                }
                (first.time, first.ended) = (time.min(first.time), Some(index));
            }
        }
        first
    }
}
