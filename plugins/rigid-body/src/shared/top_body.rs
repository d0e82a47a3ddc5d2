//! The body of a heavy top: what a user may know of it, and what its motion needs.

use dalembert_core::{Ink, Inputs, Refusal, Worksheet};
use dalembert_mechanics::rigid;
use nalgebra::{Rotation3, Vector3};

use crate::{
    shared::{body::Shape, common_errors::AS_DISC, scene::Scene},
    sources::BEER,
};

/// A body of revolution that turns about a fixed point of its axis.
#[derive(Clone, Debug, Inputs)]
pub struct TopBody {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Distance of the centre of mass from the fixed point.
    /// Along the axis.
    #[input("l", "mm", positive)]
    pub distance: f64,
    /// Moments of inertia.
    pub inertia: TopInertia,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// Moments of inertia of a top.
#[derive(Clone, Debug, Inputs)]
pub enum TopInertia {
    /// About the axis and about the fixed point
    AboutPoint {
        /// Moment of inertia about the axis.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
        /// Transverse moment of inertia about the fixed point.
        #[input("I_t", "kg*m^2", positive)]
        transverse: f64,
    },
    /// About the axis and about the centre of mass
    AboutCentre {
        /// Moment of inertia about the axis.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
        /// Transverse moment of inertia about the centre of mass.
        #[input("I_G", "kg*m^2", positive)]
        transverse: f64,
    },
    /// Radii of gyration
    Gyration {
        /// Radius of gyration about the axis.
        #[input("k_a", "mm", positive)]
        axial: f64,
        /// Transverse radius of gyration about the fixed point.
        #[input("k_t", "mm", positive)]
        transverse: f64,
    },
    /// A shape
    /// Its own z axis along the axis of the top, its centre of mass at the distance given.
    Shape {
        /// Shape.
        shape: Shape,
    },
    /// About the axis only: a top that spins fast
    AxialOnly {
        /// Moment of inertia about the axis.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
    },
}

/// Moments of the body in the motion of a top.
#[derive(Clone, Copy, Debug)]
pub struct TopMoments<N> {
    /// Moment of inertia about the axis `I_a`.
    pub axial: N,
    /// Transverse moment of inertia about the fixed point `I_t`, where it is known.
    pub transverse: Option<N>,
    /// Moment of the weight with the axis level `K`.
    pub couple: N,
}

impl TopBody {
    /// Draws the top with its axis along a rotation's third, `length` from its tip to the middle of its rim, and the letters of
    /// what is given of it.
    pub(crate) fn draw(&self, turn: &Rotation3<f64>, length: f64, scene: &mut Scene) {
        let axis = turn * Vector3::z();
        let radius = 0.42 * length;
        scene.cone(Vector3::zeros(), axis * length, radius, Ink::Body);
        scene.disc(axis * length, turn.matrix(), radius, Ink::Body);
        // The distance of G is measured on the side away from the vertical.
        let level = Vector3::z().cross(&axis).try_normalize(0.0).unwrap_or_else(Vector3::x);
        let out = level.cross(&axis);
        let centre = axis * (0.7 * length);
        scene.dimension("l", [Vector3::zeros(), centre], out * (1.1 * radius));
        let inertia = match self.inertia {
            TopInertia::AboutPoint { .. } => "m, I_a, I_t",
            TopInertia::AboutCentre { .. } => "m, I_a, I_G",
            TopInertia::Gyration { .. } => "m, k_a, k_t",
            TopInertia::Shape { .. } => "m",
            TopInertia::AxialOnly { .. } => "m, I_a",
        };
        scene.label(axis * length + out * radius, inertia);
        scene.label(Vector3::zeros(), "O");
    }
}

impl<W: Worksheet> TopBodyGiven<W> {
    /// Writes the moments of the body and of its weight.
    ///
    /// # Errors
    /// A shape that is none of revolution about its z axis.
    pub fn moments(&self, sheet: W) -> Result<TopMoments<W::Num>, Refusal> {
        let couple = sheet.step(
            "K",
            "N*m",
            self.mass * self.gravity * self.distance,
            "Moment of the weight about the fixed point with the axis level; at the angle θ it is K sin θ",
        );
        let about_point = |transverse| {
            sheet.step(
                "I_t",
                "kg*m^2",
                rigid::parallel_axis(transverse, self.mass, self.distance),
                (
                    "Transverse moment of inertia about the fixed point: parallel-axis theorem",
                    BEER.at("app. B"),
                ),
            )
        };
        let (axial, transverse) = match &self.inertia {
            TopInertiaGiven::AboutPoint { axial, transverse } => (*axial, Some(*transverse)),
            TopInertiaGiven::AboutCentre { axial, transverse } => (*axial, Some(about_point(*transverse))),
            TopInertiaGiven::Shape { shape } => {
                let [axial, transverse] = shape.axial_and_transverse(self.mass, "I_G", sheet)?;
                (axial, Some(about_point(transverse)))
            }
            TopInertiaGiven::Gyration { axial, transverse } => {
                sheet.common_error("I_a", AS_DISC, || rigid::disc_axial_inertia(self.mass, *axial));
                sheet.common_error(
                    "I_t",
                    "m l² added, as if the radius of gyration were about the centre of mass",
                    || {
                        let own = rigid::moment_by_gyration(self.mass, *transverse);
                        rigid::parallel_axis(own, self.mass, self.distance)
                    },
                );
                let about = |symbol, radius: W::Num, why| {
                    sheet.step(symbol, "kg*m^2", rigid::moment_by_gyration(self.mass, radius), why)
                };
                let axial =
                    about("I_a", *axial, "Moment of inertia about the axis from its radius of gyration");
                let transverse =
                    about("I_t", *transverse, "Transverse moment of inertia from its radius of gyration");
                (axial, Some(transverse))
            }
            TopInertiaGiven::AxialOnly { axial } => (*axial, None),
        };
        Ok(TopMoments { axial, transverse, couple })
    }
}
