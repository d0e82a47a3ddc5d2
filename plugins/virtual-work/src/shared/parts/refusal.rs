//! Messages for refusals of the kernel, in the names of the form.

use dalembert_core::{Refusal, Text};
use dalembert_mechanics::planar::PlanarError;
use dalembert_numerics::ode::OdeError;

use super::Parts;

impl Parts {
    /// Message for an error, in the names of the form.
    pub(crate) fn refusal(&self, error: &PlanarError, rows: &[usize]) -> Refusal {
        let drive = |driver: usize| self.drivers[driver].name.as_str();
        let joint = |joint: usize| rows.get(joint).map_or("", |row| self.joints[*row].name.as_str());
        let unit = |driver: usize| self.drivers[driver].what.unit();
        Refusal::because(match error {
            PlanarError::DoesNotClose { joint: at, residual } if *at < rows.len() => Text::new(
                "the mechanism cannot be assembled: {joint} remains open by {gap}; check the lengths, the driver values and the angles of the bodies",
            )
            .with("joint", joint(*at))
            .with_quantity("gap", *residual, "mm"),
            PlanarError::DoesNotClose { joint: at, .. } => {
                Text::new("the mechanism does not reach the value of {driver}; choose another")
                    .with("driver", drive(at - rows.len()))
            }
            PlanarError::UnderDriven { singular: true, .. } => Text::new(
                "in this position the joints allow more motions than there are drivers, although the numbers match: a singular position; draw it in another one",
            ),
            PlanarError::UnderDriven { free, .. } => Text::new(
                "{free} degrees of freedom have no driver: add a driver, or a joint, for each",
            )
            .with("free", free.to_string()),
            PlanarError::OverDriven { driver } => Text::new(
                "{driver} is redundant: the joints and the other drivers already determine it; remove it",
            )
            .with("driver", drive(*driver)),
            PlanarError::Limit { driver, at } => {
                Text::new("{driver} reaches a limit position at {at}: the mechanism does not move further")
                    .with("driver", drive(*driver))
                    .with_quantity("at", *at, unit(*driver))
            }
            PlanarError::TooFar { driver } => {
                Text::new("{driver} would move too far at once: more than about thirty revolutions; choose a nearer value")
                    .with("driver", drive(*driver))
            }
            PlanarError::DeadCentre { driver } => Text::new(
                "{driver} is at a dead centre: in this position it cannot move the mechanism; choose another value",
            )
            .with("driver", drive(*driver)),
            PlanarError::Jammed { joint: at } => Text::new(
                "no equilibrium was found with the friction in {joint}: the mechanism is self-locking; lower the coefficient of friction",
            )
            .with("joint", joint(*at)),
            PlanarError::Number { what: "load", index } => Text::new(
                "{load} has an invalid value, or is friction in a joint without sliding",
            )
            .with("load", self.loads[*index].name.as_str()),
            PlanarError::Massless { body } => Text::new(
                "{body} can move freely, but it and all that moves with it are massless; give it a mass, or drive it",
            )
            .with("body", &self.bodies[*body].name),
            PlanarError::Rate { index } => Text::new(
                "row {row} of the start is redundant: it follows from the joints, the drivers and the rows before it; remove it",
            )
            .with("row", (index + 1).to_string()),
            PlanarError::Sticks { load } => Text::new(
                "{load} is friction in one of the joints at rest, too many to determine which one begins to move; remove some of it",
            )
            .with("load", self.loads[*load].name.as_str()),
            PlanarError::Motion(error) => late(error),
            PlanarError::NoEquilibrium => {
                Text::new("no equilibrium was found near the drawn position; draw the bodies at other angles")
            }
            PlanarError::Number { .. } | PlanarError::NoSuchBody { .. } | PlanarError::NotFinite => {
                Text::new("a length or a result is too large or too small for the mechanism to be computed")
            }
        })
    }
}

/// Message for a motion that cannot be integrated to its end.
fn late(error: &OdeError) -> Text {
    match *error {
        OdeError::TooManySteps { at, .. } => Text::new(
            "the motion requires too many steps beyond {time}: the duration is too long; shorten it",
        )
        .with_quantity("time", at, "s"),
        OdeError::Stiff { at } => Text::new(
            "the motion cannot be integrated beyond {time}: one part of it is much faster than the rest; remove what is very stiff or very light, or shorten the duration",
        )
        .with_quantity("time", at, "s"),
        OdeError::NotFinite { at } | OdeError::TooShort { at } => Text::new(
            "the motion cannot be integrated beyond {time}: there the mechanism locks, or its joints no longer determine the motion; shorten the duration",
        )
        .with_quantity("time", at, "s"),
        OdeError::Input | OdeError::Stopped => {
            Text::new("the duration must be a positive number")
        }
    }
}
