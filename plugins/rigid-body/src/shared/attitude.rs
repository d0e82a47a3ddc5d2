//! Attitude of a frame B in a frame N: as it is given, in all of its representations, and as a picture.
//!
//! `[BN]` has the unit vectors of B, in components in N, for its rows: it changes components in N into components in B.
//! Angles are of the frame, positive by the right-hand rule.

mod description;
mod euler;
mod observations;
mod pictures;
mod representations;
mod rotations;

pub(crate) use self::{
    description::rows_of,
    euler::plain_angles,
    pictures::{both, frames},
    representations::{Representations, answer_representations},
    rotations::{along, cross_matrix, matrix, parameter_rows, plain_parameters, row_times},
};
pub use self::{
    description::{
        AttitudeInput, AttitudeInputGiven, FrameAxes, RotationSense, SingleAttitude, SingleAttitudeGiven,
        SuccessiveRotation,
    },
    euler::EulerSequence,
    observations::{VectorObservation, VectorObservationGiven},
};
