//! A rigid body as a person describes it: put together from parts, or known by its inertia.

mod description;
mod shape;

pub use description::{
    Amount, AmountGiven, Body, BodyGiven, Direction, DirectionGiven, Part, PartGiven, Presence,
    ReferencePoint, TakenAbout, TakenAboutGiven, refused,
};
pub use shape::{Shape, ShapeGiven};
