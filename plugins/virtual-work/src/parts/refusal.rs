//! Why a mechanism has no answer, in the names of the form.

use dalembert_core::{Refusal, Text};
use dalembert_mechanics::{ode::OdeError, planar::PlanarError};

use super::{Driven, Parts};

impl Parts<'_> {
    /// The unit of what a driver drives.
    pub(crate) fn unit(&self, driver: usize) -> &'static str {
        match self.drivers[driver].what {
            Driven::Angle { .. } => "deg",
            Driven::Position { .. } | Driven::Distance { .. } => "mm",
        }
    }

    /// What is wrong, in the names of the form.
    pub(crate) fn refusal(&self, error: &PlanarError, rows: &[usize]) -> Refusal {
        let drive = |driver: usize| self.drivers[driver].name.as_str();
        let joint = |joint: usize| rows.get(joint).map_or("", |row| self.joints[*row].name.as_str());
        let unit = |driver: usize| self.unit(driver);
        Refusal::because(match error {
            PlanarError::DoesNotClose { joint: at, residual } if *at < rows.len() => Text::new(
                "the mechanism cannot be assembled: {joint} stays open by {gap}; look at the lengths, the driven values and the angles at which the bodies lie",
            )
            .with("joint", joint(*at))
            .with_quantity("gap", *residual, "mm"),
            PlanarError::DoesNotClose { joint: at, .. } => {
                Text::new("the mechanism does not reach the value of {driver}; choose another")
                    .with("driver", drive(at - rows.len()))
            }
            PlanarError::UnderDriven { singular: true, .. } => Text::new(
                "in this position the joints let the mechanism move in more ways than it has drivers, although their number fits: a singular position; draw it in another one",
            ),
            PlanarError::UnderDriven { free, .. } => Text::new(
                "{free} degrees of freedom have no driver: add a driver, or a joint, for each",
            )
            .with("free", free.to_string()),
            PlanarError::OverDriven { driver } => Text::new(
                "{driver} is one driver too many: the joints and the other drivers hold it already; take it out",
            )
            .with("driver", drive(*driver)),
            PlanarError::Limit { driver, at } => {
                Text::new("{driver} comes to a limit at {at}: the mechanism goes no further")
                    .with("driver", drive(*driver))
                    .with_quantity("at", *at, unit(*driver))
            }
            PlanarError::TooFar { driver } => {
                Text::new("{driver} is to move too far at once: more than some thirty turns; choose a nearer value")
                    .with("driver", drive(*driver))
            }
            PlanarError::DeadCentre { driver } => Text::new(
                "{driver} stands at a dead centre: in this position it cannot move the mechanism; choose another value",
            )
            .with("driver", drive(*driver)),
            PlanarError::Jammed { joint: at } => Text::new(
                "the friction in {joint} finds no balance: the mechanism locks itself; lower the coefficient of friction",
            )
            .with("joint", joint(*at)),
            PlanarError::Number { what: "load", index } => Text::new(
                "{load} has a number it cannot have, or is friction in a joint without sliding",
            )
            .with("load", self.loads[*index].name.as_str()),
            PlanarError::Massless { body } => Text::new(
                "{body} can move freely, but nothing that moves with it has a mass; give it a mass, or drive it",
            )
            .with("body", &self.bodies[*body].name),
            PlanarError::Rate { index } => Text::new(
                "row {row} of the start follows from the joints, the drivers and the rows before it; take it out",
            )
            .with("row", (index + 1).to_string()),
            PlanarError::Sticks { load } => Text::new(
                "{load} is friction in one of so many joints at rest that what begins to move cannot be found; take some of it out",
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

/// Why a motion cannot be followed to its end.
fn late(error: &OdeError) -> Text {
    match *error {
        OdeError::TooManySteps { at, .. } => Text::new(
            "the motion asks for too many steps beyond {time}: too much happens in this duration; shorten it",
        )
        .with_quantity("time", at, "s"),
        OdeError::Stiff { at } => Text::new(
            "the motion cannot be followed beyond {time}: something in it is much faster than the rest; take out what is very stiff or very light, or shorten the duration",
        )
        .with_quantity("time", at, "s"),
        OdeError::NotFinite { at } | OdeError::TooShort { at } => Text::new(
            "the motion cannot be followed beyond {time}: there the mechanism locks, or its joints no longer say how it goes on; shorten the duration",
        )
        .with_quantity("time", at, "s"),
        OdeError::Input | OdeError::Stopped => {
            Text::new("the duration must be a positive number")
        }
    }
}
