//! Homogeneous bodies of simple shape: length, area or volume, centre of mass, moments and products of inertia.
//!
//! Each shape has axes of its own, reported with it; its moments of inertia are taken about its centre of mass G in these
//! axes. The formulas stand in the tables of every book of dynamics (Beer & Johnston, *Dynamics*, inside back
//! cover; Meriam & Kraige, *Dynamics*, table D/4); `m` is the mass of the shape, filled evenly along its length,
//! over its area or through its volume.

use std::f64::consts::PI;

use nalgebra::Vector3;

use super::MassProperties;
use crate::{Real, Vector};

/// A homogeneous shape and its dimensions, in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive<S> {
    /// A mass at a point, the origin.
    Particle,
    /// A slender rod along z, its middle at the origin.
    Rod {
        /// Length.
        length: S,
    },
    /// A slender rod bent to an arc of a circle about the origin, in the xy plane, from the x axis towards y.
    Arc {
        /// Radius of the circle.
        radius: S,
        /// Angle of the arc, rad, at most 2π.
        angle: S,
    },
    /// A slender ring about the z axis in the xy plane.
    Ring {
        /// Radius.
        radius: S,
    },
    /// A thin disc about the z axis in the xy plane.
    Disc {
        /// Radius.
        radius: S,
    },
    /// A thin disc with a round hole in its middle.
    Annulus {
        /// Outer radius.
        outer: S,
        /// Inner radius.
        inner: S,
    },
    /// The half `y ≥ 0` of a thin disc; the origin is the centre of the circle.
    HalfDisc {
        /// Radius.
        radius: S,
    },
    /// The quarter `x, y ≥ 0` of a thin disc; the origin is the centre of the circle.
    QuarterDisc {
        /// Radius.
        radius: S,
    },
    /// A thin elliptical plate in the xy plane.
    EllipticalPlate {
        /// Semi-axis along x.
        a: S,
        /// Semi-axis along y.
        b: S,
    },
    /// A thin rectangular plate in the xy plane, its centre at the origin.
    RectangularPlate {
        /// Side along x.
        a: S,
        /// Side along y.
        b: S,
    },
    /// A thin right-angled triangular plate in the xy plane, its right angle at the origin.
    RightTriangularPlate {
        /// Leg along x.
        a: S,
        /// Leg along y.
        b: S,
    },
    /// A box, its centre at the origin.
    Box {
        /// Side along x.
        a: S,
        /// Side along y.
        b: S,
        /// Side along z.
        c: S,
    },
    /// A cylinder about the z axis, its centre at the origin.
    Cylinder {
        /// Radius.
        radius: S,
        /// Height.
        height: S,
    },
    /// A cylinder with a bore about the same axis.
    HollowCylinder {
        /// Outer radius.
        outer: S,
        /// Inner radius.
        inner: S,
        /// Height.
        height: S,
    },
    /// A thin tube without ends about the z axis, its centre at the origin.
    Tube {
        /// Radius.
        radius: S,
        /// Height.
        height: S,
    },
    /// The half `y ≥ 0` of a cylinder about the z axis; the origin is the middle of that axis.
    HalfCylinder {
        /// Radius.
        radius: S,
        /// Height.
        height: S,
    },
    /// A cone about the z axis: apex at the origin, base at `z = h`.
    Cone {
        /// Radius of the base.
        radius: S,
        /// Height.
        height: S,
    },
    /// A thin conical shell without a base: apex at the origin, rim at `z = h`.
    ConicalShell {
        /// Radius of the rim.
        radius: S,
        /// Height.
        height: S,
    },
    /// A sphere about the origin.
    Sphere {
        /// Radius.
        radius: S,
    },
    /// A sphere with a hollow about the same centre.
    HollowSphere {
        /// Outer radius.
        outer: S,
        /// Inner radius.
        inner: S,
    },
    /// A thin spherical shell.
    SphericalShell {
        /// Radius.
        radius: S,
    },
    /// The half `z ≥ 0` of a sphere about the origin.
    Hemisphere {
        /// Radius.
        radius: S,
    },
    /// The half `z ≥ 0` of a thin spherical shell about the origin, open below.
    HemisphericalShell {
        /// Radius.
        radius: S,
    },
    /// An ellipsoid about the origin.
    Ellipsoid {
        /// Semi-axis along x.
        a: S,
        /// Semi-axis along y.
        b: S,
        /// Semi-axis along z.
        c: S,
    },
    /// A solid ring of round section about the z axis.
    Torus {
        /// Radius of the circle through the middle of the section.
        radius: S,
        /// Radius of the section, not more than that of the circle.
        section: S,
    },
    /// A solid paraboloid of revolution about the z axis: vertex at the origin, base at `z = h`.
    Paraboloid {
        /// Radius of the base.
        radius: S,
        /// Height.
        height: S,
    },
    /// A tetrahedron with three edges along x, y and z from the origin.
    Tetrahedron {
        /// Edge along x.
        a: S,
        /// Edge along y.
        b: S,
        /// Edge along z.
        c: S,
    },
}

/// Region over which the mass of a shape is distributed: point, line, surface or volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent<S> {
    /// A point.
    Point,
    /// A line of that length, m.
    Length(S),
    /// A surface of that area, m².
    Area(S),
    /// A space of that volume, m³.
    Volume(S),
}

/// Moments and products of inertia about the centre of mass, in the axes of the shape, kg·m².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OwnInertia<S> {
    /// `(I_x, I_y, I_z)`.
    pub moments: [S; 3],
    /// `(I_yz, I_zx, I_xy)`, `I_xy = ∫ xy dm`; `None` where the axes are principal.
    pub products: Option<[S; 3]>,
}

/// A named point of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The origin of its own axes.
    Origin,
    /// Centre of mass.
    MassCentre,
    /// Point at which its own axis enters it; the first end of an arc.
    NearEnd,
    /// Point at which its own axis leaves it; the last end of an arc.
    FarEnd,
    /// The corner with the least coordinates.
    Corner,
}

/// Dimensions that make no shape.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    /// The hole is not smaller than the whole.
    #[error("the inner radius {inner} m is not smaller than the outer radius {outer} m")]
    Hollow {
        /// Inner radius, m.
        inner: f64,
        /// Outer radius, m.
        outer: f64,
    },
    /// A torus that would meet itself.
    #[error("the section radius {section} m of the torus is larger than the radius {radius} m of its circle")]
    Torus {
        /// Radius of the section, m.
        section: f64,
        /// Radius of the circle, m.
        radius: f64,
    },
}

impl<S: Real> Primitive<S> {
    /// Holds the dimensions against each other; that each is positive is taken for granted.
    ///
    /// # Errors
    /// [`ShapeError`].
    pub fn check(self) -> Result<(), ShapeError> {
        match self {
            Self::Annulus { outer, inner }
            | Self::HollowCylinder { outer, inner, .. }
            | Self::HollowSphere { outer, inner }
                if inner.value() >= outer.value() =>
            {
                Err(ShapeError::Hollow { inner: inner.value(), outer: outer.value() })
            }
            Self::Torus { radius, section } if section.value() > radius.value() => {
                Err(ShapeError::Torus { section: section.value(), radius: radius.value() })
            }
            _ => Ok(()),
        }
    }

    /// Length, area or volume.
    pub fn extent(self) -> Extent<S> {
        match self {
            Self::Particle => Extent::Point,
            Self::Rod { length } => Extent::Length(length),
            Self::Arc { radius, angle } => Extent::Length(radius * angle),
            Self::Ring { radius } => Extent::Length(radius * (2.0 * PI)),
            Self::Disc { radius } => Extent::Area(radius.powi(2) * PI),
            Self::Annulus { outer, inner } => Extent::Area((outer.powi(2) - inner.powi(2)) * PI),
            Self::HalfDisc { radius } => Extent::Area(radius.powi(2) * PI / 2.0),
            Self::QuarterDisc { radius } => Extent::Area(radius.powi(2) * PI / 4.0),
            Self::EllipticalPlate { a, b } => Extent::Area(a * b * PI),
            Self::RectangularPlate { a, b } => Extent::Area(a * b),
            Self::RightTriangularPlate { a, b } => Extent::Area(a * b / 2.0),
            Self::Box { a, b, c } => Extent::Volume(a * b * c),
            Self::Cylinder { radius, height } => Extent::Volume(radius.powi(2) * height * PI),
            Self::HollowCylinder { outer, inner, height } => {
                Extent::Volume((outer.powi(2) - inner.powi(2)) * height * PI)
            }
            Self::Tube { radius, height } => Extent::Area(radius * height * (2.0 * PI)),
            Self::HalfCylinder { radius, height } | Self::Paraboloid { radius, height } => {
                Extent::Volume(radius.powi(2) * height * PI / 2.0)
            }
            Self::Cone { radius, height } => Extent::Volume(radius.powi(2) * height * PI / 3.0),
            Self::ConicalShell { radius, height } => {
                Extent::Area(radius * (radius.powi(2) + height.powi(2)).sqrt() * PI)
            }
            Self::Sphere { radius } => Extent::Volume(radius.powi(3) * (4.0 * PI) / 3.0),
            Self::HollowSphere { outer, inner } => {
                Extent::Volume((outer.powi(3) - inner.powi(3)) * (4.0 * PI) / 3.0)
            }
            Self::SphericalShell { radius } => Extent::Area(radius.powi(2) * (4.0 * PI)),
            Self::Hemisphere { radius } => Extent::Volume(radius.powi(3) * (2.0 * PI) / 3.0),
            Self::HemisphericalShell { radius } => Extent::Area(radius.powi(2) * (2.0 * PI)),
            Self::Ellipsoid { a, b, c } => Extent::Volume(a * b * c * (4.0 * PI) / 3.0),
            Self::Torus { radius, section } => Extent::Volume(radius * section.powi(2) * (2.0 * PI * PI)),
            Self::Tetrahedron { a, b, c } => Extent::Volume(a * b * c / 6.0),
        }
    }

    /// Coordinates of the centre of mass in the axes of the shape, m; `None` where it is their origin.
    pub fn centre<V: Vector<Scalar = S>>(self) -> Option<V> {
        let zero = S::from(0.0);
        let along_z = |z: S| V::from_components(zero, zero, z);
        Some(match self {
            Self::Arc { radius, angle } => V::from_components(
                radius * angle.sin() / angle,
                radius * (S::from(1.0) - angle.cos()) / angle,
                zero,
            ),
            Self::HalfDisc { radius } | Self::HalfCylinder { radius, .. } => {
                V::from_components(zero, radius * 4.0 / (3.0 * PI), zero)
            }
            Self::QuarterDisc { radius } => {
                V::from_components(radius * 4.0 / (3.0 * PI), radius * 4.0 / (3.0 * PI), zero)
            }
            Self::RightTriangularPlate { a, b } => V::from_components(a / 3.0, b / 3.0, zero),
            Self::Cone { height, .. } => along_z(height * 3.0 / 4.0),
            Self::ConicalShell { height, .. } | Self::Paraboloid { height, .. } => {
                along_z(height * 2.0 / 3.0)
            }
            Self::Hemisphere { radius } => along_z(radius * 3.0 / 8.0),
            Self::HemisphericalShell { radius } => along_z(radius / 2.0),
            Self::Tetrahedron { a, b, c } => V::from_components(a / 4.0, b / 4.0, c / 4.0),
            _ => return None,
        })
    }

    /// Moments and products of inertia about the centre of mass, in the axes of the shape, for its mass `m`.
    pub fn inertia(self, mass: S) -> OwnInertia<S> {
        let m = mass;
        let zero = S::from(0.0);
        let principal = |x: S, y: S, z: S| OwnInertia { moments: [x, y, z], products: None };
        // Of revolution about z.
        let round = |across: S, along: S| principal(across, across, along);
        match self {
            Self::Particle => round(zero, zero),
            Self::Rod { length } => round(super::rod_inertia(m, length), zero),
            Self::Arc { radius, angle } => {
                let (sin, cos) = (angle.sin(), angle.cos());
                let (x, y) = (radius * sin / angle, radius * (S::from(1.0) - cos) / angle);
                OwnInertia {
                    moments: [
                        m * radius.powi(2) * (S::from(1.0) - sin * cos / angle) / 2.0 - m * y.powi(2),
                        m * radius.powi(2) * (S::from(1.0) + sin * cos / angle) / 2.0 - m * x.powi(2),
                        m * radius.powi(2) - m * (x.powi(2) + y.powi(2)),
                    ],
                    products: Some([
                        zero,
                        zero,
                        m * radius.powi(2) * sin.powi(2) / (angle * 2.0) - m * x * y,
                    ]),
                }
            }
            Self::Ring { radius } => round(m * radius.powi(2) / 2.0, m * radius.powi(2)),
            Self::Disc { radius } => {
                round(super::disc_diametral_inertia(m, radius), super::disc_axial_inertia(m, radius))
            }
            Self::Annulus { outer, inner } => {
                round(m * (outer.powi(2) + inner.powi(2)) / 4.0, m * (outer.powi(2) + inner.powi(2)) / 2.0)
            }
            Self::HalfDisc { radius } => {
                let centre = radius * 4.0 / (3.0 * PI);
                principal(
                    m * radius.powi(2) / 4.0 - m * centre.powi(2),
                    m * radius.powi(2) / 4.0,
                    m * radius.powi(2) / 2.0 - m * centre.powi(2),
                )
            }
            Self::QuarterDisc { radius } => {
                let centre = radius * 4.0 / (3.0 * PI);
                let across = m * radius.powi(2) / 4.0 - m * centre.powi(2);
                OwnInertia {
                    moments: [across, across, m * radius.powi(2) / 2.0 - m * centre.powi(2) * 2.0],
                    products: Some([zero, zero, m * radius.powi(2) / (2.0 * PI) - m * centre.powi(2)]),
                }
            }
            Self::EllipticalPlate { a, b } => {
                principal(m * b.powi(2) / 4.0, m * a.powi(2) / 4.0, m * (a.powi(2) + b.powi(2)) / 4.0)
            }
            Self::RectangularPlate { a, b } => {
                principal(m * b.powi(2) / 12.0, m * a.powi(2) / 12.0, m * (a.powi(2) + b.powi(2)) / 12.0)
            }
            Self::RightTriangularPlate { a, b } => OwnInertia {
                moments: [m * b.powi(2) / 18.0, m * a.powi(2) / 18.0, m * (a.powi(2) + b.powi(2)) / 18.0],
                products: Some([zero, zero, -(m * a * b / 36.0)]),
            },
            Self::Box { a, b, c } => principal(
                m * (b.powi(2) + c.powi(2)) / 12.0,
                m * (c.powi(2) + a.powi(2)) / 12.0,
                m * (a.powi(2) + b.powi(2)) / 12.0,
            ),
            Self::Cylinder { radius, height } => {
                round(super::cylinder_diametral_inertia(m, radius, height), m * radius.powi(2) / 2.0)
            }
            Self::HollowCylinder { outer, inner, height } => round(
                m * ((outer.powi(2) + inner.powi(2)) * 3.0 + height.powi(2)) / 12.0,
                m * (outer.powi(2) + inner.powi(2)) / 2.0,
            ),
            Self::Tube { radius, height } => {
                round(m * (radius.powi(2) * 6.0 + height.powi(2)) / 12.0, m * radius.powi(2))
            }
            Self::HalfCylinder { radius, height } => {
                let centre = radius * 4.0 / (3.0 * PI);
                let across = super::cylinder_diametral_inertia(m, radius, height);
                principal(across - m * centre.powi(2), across, m * radius.powi(2) / 2.0 - m * centre.powi(2))
            }
            Self::Cone { radius, height } => round(
                m * (radius.powi(2) * 4.0 + height.powi(2)) * 3.0 / 80.0,
                m * radius.powi(2) * 3.0 / 10.0,
            ),
            Self::ConicalShell { radius, height } => {
                round(m * (radius.powi(2) * 9.0 + height.powi(2) * 2.0) / 36.0, m * radius.powi(2) / 2.0)
            }
            Self::Sphere { radius } => {
                let about = m * radius.powi(2) * 2.0 / 5.0;
                round(about, about)
            }
            Self::HollowSphere { outer, inner } => {
                let about =
                    m * (outer.powi(5) - inner.powi(5)) * 2.0 / ((outer.powi(3) - inner.powi(3)) * 5.0);
                round(about, about)
            }
            Self::SphericalShell { radius } => {
                let about = m * radius.powi(2) * 2.0 / 3.0;
                round(about, about)
            }
            Self::Hemisphere { radius } => {
                round(m * radius.powi(2) * 83.0 / 320.0, m * radius.powi(2) * 2.0 / 5.0)
            }
            Self::HemisphericalShell { radius } => {
                round(m * radius.powi(2) * 5.0 / 12.0, m * radius.powi(2) * 2.0 / 3.0)
            }
            Self::Ellipsoid { a, b, c } => principal(
                m * (b.powi(2) + c.powi(2)) / 5.0,
                m * (c.powi(2) + a.powi(2)) / 5.0,
                m * (a.powi(2) + b.powi(2)) / 5.0,
            ),
            Self::Torus { radius, section } => round(
                m * (radius.powi(2) * 4.0 + section.powi(2) * 5.0) / 8.0,
                m * (radius.powi(2) * 4.0 + section.powi(2) * 3.0) / 4.0,
            ),
            Self::Paraboloid { radius, height } => {
                round(m * (radius.powi(2) * 3.0 + height.powi(2)) / 18.0, m * radius.powi(2) / 3.0)
            }
            Self::Tetrahedron { a, b, c } => OwnInertia {
                moments: [
                    m * (b.powi(2) + c.powi(2)) * 3.0 / 80.0,
                    m * (c.powi(2) + a.powi(2)) * 3.0 / 80.0,
                    m * (a.powi(2) + b.powi(2)) * 3.0 / 80.0,
                ],
                products: Some([-(m * b * c / 80.0), -(m * c * a / 80.0), -(m * a * b / 80.0)]),
            },
        }
    }

    /// From a named point of the shape to its centre of mass, in the axes of the shape, m; `None` where the shape has no
    /// such point.
    pub fn to_centre<V: Vector<Scalar = S>>(self, anchor: Anchor) -> Option<V> {
        let zero = S::from(0.0);
        let origin = V::from_components(zero, zero, zero);
        let along_z = |z: S| Some(V::from_components(zero, zero, z));
        match (anchor, self) {
            (Anchor::MassCentre, _) => Some(origin),
            (Anchor::Origin, _)
            | (
                Anchor::NearEnd,
                Self::Cone { .. }
                | Self::ConicalShell { .. }
                | Self::Paraboloid { .. }
                | Self::Hemisphere { .. }
                | Self::HemisphericalShell { .. },
            )
            | (Anchor::Corner, Self::RightTriangularPlate { .. } | Self::Tetrahedron { .. }) => {
                Some(self.centre().unwrap_or(origin))
            }
            (Anchor::FarEnd, Self::Cone { height, .. }) => along_z(-(height / 4.0)),
            (Anchor::FarEnd, Self::ConicalShell { height, .. } | Self::Paraboloid { height, .. }) => {
                along_z(-(height / 3.0))
            }
            (Anchor::FarEnd, Self::Hemisphere { radius }) => along_z(-(radius * 5.0 / 8.0)),
            (Anchor::FarEnd, Self::HemisphericalShell { radius }) => along_z(-(radius / 2.0)),
            (Anchor::NearEnd, Self::Arc { radius, .. }) => {
                Some(self.centre::<V>()? - V::from_components(radius, zero, zero))
            }
            (Anchor::FarEnd, Self::Arc { radius, angle }) => Some(
                self.centre::<V>()? - V::from_components(radius * angle.cos(), radius * angle.sin(), zero),
            ),
            (Anchor::Corner, Self::RectangularPlate { a, b }) => {
                Some(V::from_components(a / 2.0, b / 2.0, zero))
            }
            (Anchor::Corner, Self::Box { a, b, c }) => Some(V::from_components(a / 2.0, b / 2.0, c / 2.0)),
            (Anchor::NearEnd, Self::HalfCylinder { radius, height }) => {
                Some(V::from_components(zero, radius * 4.0 / (3.0 * PI), height / 2.0))
            }
            (Anchor::FarEnd, Self::HalfCylinder { radius, height }) => {
                Some(V::from_components(zero, radius * 4.0 / (3.0 * PI), -(height / 2.0)))
            }
            (Anchor::NearEnd, _) => along_z(self.half_height()?),
            (Anchor::FarEnd, _) => along_z(-self.half_height()?),
            (Anchor::Corner, _) => None,
        }
    }

    /// Returns true if the moment of inertia is the same about all axes through G across z: a rotation about z leaves
    /// the inertia unchanged.
    pub fn is_round(self) -> bool {
        matches!(
            self,
            Self::Particle
                | Self::Rod { .. }
                | Self::Ring { .. }
                | Self::Disc { .. }
                | Self::Annulus { .. }
                | Self::Cylinder { .. }
                | Self::HollowCylinder { .. }
                | Self::Tube { .. }
                | Self::Cone { .. }
                | Self::ConicalShell { .. }
                | Self::Sphere { .. }
                | Self::HollowSphere { .. }
                | Self::SphericalShell { .. }
                | Self::Hemisphere { .. }
                | Self::HemisphericalShell { .. }
                | Self::Torus { .. }
                | Self::Paraboloid { .. }
        )
    }

    /// Returns true if the moment of inertia is the same about all axes through G.
    pub fn is_ball(self) -> bool {
        matches!(
            self,
            Self::Particle | Self::Sphere { .. } | Self::HollowSphere { .. } | Self::SphericalShell { .. }
        )
    }

    /// Half the way through a shape whose middle is at the origin, along its own axis.
    fn half_height(self) -> Option<S> {
        match self {
            Self::Rod { length } => Some(length / 2.0),
            Self::Box { c, .. } => Some(c / 2.0),
            Self::Cylinder { height, .. }
            | Self::HollowCylinder { height, .. }
            | Self::Tube { height, .. } => Some(height / 2.0),
            Self::Sphere { radius } | Self::SphericalShell { radius } => Some(radius),
            Self::HollowSphere { outer, .. } => Some(outer),
            Self::Ellipsoid { c, .. } => Some(c),
            _ => None,
        }
    }
}

impl Primitive<f64> {
    /// Mass properties in the axes of the shape.
    pub fn mass_properties(self, mass: f64) -> MassProperties {
        let OwnInertia { moments, products } = self.inertia(mass);
        let centre = self.centre().unwrap_or_else(Vector3::zeros);
        let products = products.map_or_else(Vector3::zeros, Vector3::from);
        MassProperties { mass, centre, inertia: MassProperties::tensor(moments.into(), products) }
    }
}
