//! Terminal events of a motion.

use dalembert_core::{Inputs, Reference, Refusal, Text};
use dalembert_mechanics::planar::{Event, RelativeCoordinate, Snapshot, Trajectory};

use crate::shared::parts::{Part, Parts};

/// Terminal event of a motion.
#[derive(Clone, Debug, Inputs)]
pub enum MechanismEvent {
    /// Nothing
    Nothing,
    /// A body reaches an angle
    Angle {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
        /// Angle.
        #[input("θ", "deg")]
        value: f64,
    },
    /// A body comes to rest
    /// It stops rotating; for a body that only translates, use two points.
    Rest {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
    },
    /// Two points reach a distance
    Distance {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Distance.
        #[input("s", "mm", positive)]
        value: f64,
    },
    /// Two points come to relative rest
    Still {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
    },
}

impl MechanismEvent {
    pub(super) fn end(&self, parts: &Parts) -> Option<Event> {
        let angle = |body: Reference| RelativeCoordinate::Angle { of: Some(body.0), against: None };
        match *self {
            MechanismEvent::Nothing => None,
            MechanismEvent::Angle { body, value } => Some(Event::Reaches(angle(body), value)),
            MechanismEvent::Rest { body } => Some(Event::Rests(angle(body))),
            MechanismEvent::Distance { from, to, value } => {
                Some(Event::Reaches(parts.distance(from, to), value))
            }
            MechanismEvent::Still { from, to } => Some(Event::Rests(parts.distance(from, to))),
        }
    }

    /// Refuses the rest of a body that keeps its angle: the zeros of its angular velocity are those of rounding.
    pub(super) fn check_relevance(&self, moved: &Trajectory, bodies: &[Part]) -> Result<(), Refusal> {
        let (MechanismEvent::Rest { body }, Some(_)) = (self, moved.ended) else { return Ok(()) };
        let angle = |moment: &Snapshot| moment.state.positions[body.0][2];
        let start = moved.samples.first().map_or(0.0, angle);
        if moved.samples.iter().any(|moment| (angle(moment) - start).abs() > 1e-9) {
            return Ok(());
        }
        let why = Text::new(
            "{body} does not turn, so this end condition does not apply to it: use two points that come to relative rest",
        );
        Err(Refusal::NoAnswer(why.with("body", &bodies[body.0].name)))
    }
}
