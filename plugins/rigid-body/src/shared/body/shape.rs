//! The shapes that a part may have, as a form asks for them.

use dalembert_core::{Inputs, Worksheet};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{
        MassProperties,
        primitive::{Anchor, Extent, OwnInertia, Primitive, ShapeError},
    },
};
use nalgebra::{Matrix3, Vector3};

/// The shape of a part, in axes of its own.
#[derive(Clone, Debug, Inputs)]
pub enum Shape {
    /// Particle
    Particle,
    /// Slender rod
    /// Along its own z axis, from its middle.
    Rod {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Slender rod between two points
    /// The points relative to the reference point.
    RodBetween {
        /// First end.
        #[input("a", "m")]
        from: Vector3<f64>,
        /// Second end.
        #[input("b", "m")]
        to: Vector3<f64>,
    },
    /// Rod bent into a circular arc
    /// In its own xy plane about the origin, from the x axis towards y.
    Arc {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
        /// Angle of the arc.
        #[input("β", "deg", min = 1, max = 360)]
        angle: f64,
    },
    /// Slender ring
    /// About its own z axis.
    Ring {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Thin disc
    /// About its own z axis.
    Disc {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Thin disc with a hole
    /// About its own z axis.
    Annulus {
        /// Outer radius.
        #[input("R", "m", positive)]
        outer: f64,
        /// Inner radius.
        #[input("R_i", "m", positive)]
        inner: f64,
    },
    /// Thin half disc
    /// In its own xy plane, y ≥ 0, from the centre of the circle.
    HalfDisc {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Thin quarter disc
    /// In its own xy plane, x, y ≥ 0, from the centre of the circle.
    QuarterDisc {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Thin elliptical plate
    /// In its own xy plane, from its centre.
    EllipticalPlate {
        /// Semi-axis along x.
        #[input("a", "m", positive)]
        a: f64,
        /// Semi-axis along y.
        #[input("b", "m", positive)]
        b: f64,
    },
    /// Thin rectangular plate
    /// In its own xy plane, from its centre.
    RectangularPlate {
        /// Side along x.
        #[input("a", "m", positive)]
        a: f64,
        /// Side along y.
        #[input("b", "m", positive)]
        b: f64,
    },
    /// Thin right-angled triangular plate
    /// In its own xy plane, legs along x and y from the right angle.
    RightTriangularPlate {
        /// Leg along x.
        #[input("a", "m", positive)]
        a: f64,
        /// Leg along y.
        #[input("b", "m", positive)]
        b: f64,
    },
    /// Box
    /// From its centre.
    Box {
        /// Side along x.
        #[input("a", "m", positive)]
        a: f64,
        /// Side along y.
        #[input("b", "m", positive)]
        b: f64,
        /// Side along z.
        #[input("c", "m", positive)]
        c: f64,
    },
    /// Cylinder
    /// About its own z axis, from its centre.
    Cylinder {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
        /// Height.
        #[input("h", "m", positive)]
        height: f64,
    },
    /// Hollow cylinder
    /// About its own z axis, from its centre.
    HollowCylinder {
        /// Outer radius.
        #[input("R", "m", positive)]
        outer: f64,
        /// Inner radius.
        #[input("R_i", "m", positive)]
        inner: f64,
        /// Height.
        #[input("h", "m", positive)]
        height: f64,
    },
    /// Thin tube
    /// About its own z axis, from its centre, open at both ends.
    Tube {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
        /// Height.
        #[input("h", "m", positive)]
        height: f64,
    },
    /// Half cylinder
    /// About its own z axis, y ≥ 0, from the middle of the axis of the circle.
    HalfCylinder {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
        /// Height.
        #[input("h", "m", positive)]
        height: f64,
    },
    /// Cone
    /// About its own z axis, from its apex.
    Cone {
        /// Radius of the base.
        #[input("R", "m", positive)]
        radius: f64,
        /// Height.
        #[input("h", "m", positive)]
        height: f64,
    },
    /// Thin conical shell
    /// About its own z axis, from its apex, open at the base.
    ConicalShell {
        /// Radius of the base.
        #[input("R", "m", positive)]
        radius: f64,
        /// Height.
        #[input("h", "m", positive)]
        height: f64,
    },
    /// Sphere
    /// From its centre.
    Sphere {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Hollow sphere
    /// From its centre.
    HollowSphere {
        /// Outer radius.
        #[input("R", "m", positive)]
        outer: f64,
        /// Inner radius.
        #[input("R_i", "m", positive)]
        inner: f64,
    },
    /// Thin spherical shell
    /// From its centre.
    SphericalShell {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Hemisphere
    /// About its own z axis, z ≥ 0, from the centre of the circle.
    Hemisphere {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Thin hemispherical shell
    /// About its own z axis, z ≥ 0, from the centre of the circle, open there.
    HemisphericalShell {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Ellipsoid
    /// From its centre.
    Ellipsoid {
        /// Semi-axis along x.
        #[input("a", "m", positive)]
        a: f64,
        /// Semi-axis along y.
        #[input("b", "m", positive)]
        b: f64,
        /// Semi-axis along z.
        #[input("c", "m", positive)]
        c: f64,
    },
    /// Torus
    /// About its own z axis, from its centre.
    Torus {
        /// Radius of the circle through the middle of the section.
        #[input("R", "m", positive)]
        radius: f64,
        /// Radius of the section.
        #[input("R_s", "m", positive)]
        section: f64,
    },
    /// Paraboloid
    /// About its own z axis, from its vertex.
    Paraboloid {
        /// Radius of the base.
        #[input("R", "m", positive)]
        radius: f64,
        /// Height.
        #[input("h", "m", positive)]
        height: f64,
    },
    /// Tetrahedron with three edges at right angles
    /// Along its own x, y and z axes, from their common corner.
    Tetrahedron {
        /// Edge along x.
        #[input("a", "m", positive)]
        a: f64,
        /// Edge along y.
        #[input("b", "m", positive)]
        b: f64,
        /// Edge along z.
        #[input("c", "m", positive)]
        c: f64,
    },
    /// Any shape, by its radii of gyration
    /// About principal axes through its centre of mass, the origin.
    Radii {
        /// Radii of gyration.
        #[input("k", "m")]
        radii: Vector3<f64>,
    },
    /// Any shape, by its inertia matrix
    /// About its centre of mass, the origin.
    Matrix {
        /// Moments of inertia Iₓ, I_y, I_z.
        #[input("I", "kg*m^2")]
        moments: Vector3<f64>,
        /// Products of inertia I_yz, I_zx, I_xy.
        /// I_xy = ∫ xy dm; in the inertia matrix they appear with a minus sign.
        #[input("P", "kg*m^2", default = "(0; 0; 0) kg*m^2")]
        products: Vector3<f64>,
    },
}

/// A shape over the numbers of a form or of a worksheet.
#[derive(Clone, Copy)]
pub(super) enum Described<V: Vector> {
    /// A simple shape.
    Primitive(Primitive<V::Scalar>),
    /// A slender rod from one point to another.
    Between(V, V),
    /// Radii of gyration.
    Radii(V),
    /// Moments and products of inertia.
    Matrix(V, V),
}

/// The same for the shape of the form and that on a worksheet: they have the same alternatives.
macro_rules! described {
    ($shape:expr, $kind:ident) => {
        match *$shape {
            $kind::Particle {} => Described::Primitive(Primitive::Particle),
            $kind::Rod { length } => Described::Primitive(Primitive::Rod { length }),
            $kind::RodBetween { from, to } => Described::Between(from, to),
            $kind::Arc { radius, angle } => Described::Primitive(Primitive::Arc { radius, angle }),
            $kind::Ring { radius } => Described::Primitive(Primitive::Ring { radius }),
            $kind::Disc { radius } => Described::Primitive(Primitive::Disc { radius }),
            $kind::Annulus { outer, inner } => Described::Primitive(Primitive::Annulus { outer, inner }),
            $kind::HalfDisc { radius } => Described::Primitive(Primitive::HalfDisc { radius }),
            $kind::QuarterDisc { radius } => Described::Primitive(Primitive::QuarterDisc { radius }),
            $kind::EllipticalPlate { a, b } => Described::Primitive(Primitive::EllipticalPlate { a, b }),
            $kind::RectangularPlate { a, b } => Described::Primitive(Primitive::RectangularPlate { a, b }),
            $kind::RightTriangularPlate { a, b } => {
                Described::Primitive(Primitive::RightTriangularPlate { a, b })
            }
            $kind::Box { a, b, c } => Described::Primitive(Primitive::Box { a, b, c }),
            $kind::Cylinder { radius, height } => {
                Described::Primitive(Primitive::Cylinder { radius, height })
            }
            $kind::HollowCylinder { outer, inner, height } => {
                Described::Primitive(Primitive::HollowCylinder { outer, inner, height })
            }
            $kind::Tube { radius, height } => Described::Primitive(Primitive::Tube { radius, height }),
            $kind::HalfCylinder { radius, height } => {
                Described::Primitive(Primitive::HalfCylinder { radius, height })
            }
            $kind::Cone { radius, height } => Described::Primitive(Primitive::Cone { radius, height }),
            $kind::ConicalShell { radius, height } => {
                Described::Primitive(Primitive::ConicalShell { radius, height })
            }
            $kind::Sphere { radius } => Described::Primitive(Primitive::Sphere { radius }),
            $kind::HollowSphere { outer, inner } => {
                Described::Primitive(Primitive::HollowSphere { outer, inner })
            }
            $kind::SphericalShell { radius } => Described::Primitive(Primitive::SphericalShell { radius }),
            $kind::Hemisphere { radius } => Described::Primitive(Primitive::Hemisphere { radius }),
            $kind::HemisphericalShell { radius } => {
                Described::Primitive(Primitive::HemisphericalShell { radius })
            }
            $kind::Ellipsoid { a, b, c } => Described::Primitive(Primitive::Ellipsoid { a, b, c }),
            $kind::Torus { radius, section } => Described::Primitive(Primitive::Torus { radius, section }),
            $kind::Paraboloid { radius, height } => {
                Described::Primitive(Primitive::Paraboloid { radius, height })
            }
            $kind::Tetrahedron { a, b, c } => Described::Primitive(Primitive::Tetrahedron { a, b, c }),
            $kind::Radii { radii } => Described::Radii(radii),
            $kind::Matrix { moments, products } => Described::Matrix(moments, products),
        }
    };
}

impl Shape {
    pub(super) fn described(&self) -> Described<Vector3<f64>> {
        described!(self, Shape)
    }

    pub(super) fn check(&self) -> Result<(), ShapeError> {
        match self.described() {
            Described::Primitive(shape) => shape.check(),
            _ => Ok(()),
        }
    }

    pub(super) fn extent(&self) -> Extent<f64> {
        self.described().extent(|from, to| (to - from).norm())
    }

    /// Inertia tensor about the centre of mass in the own axes.
    pub(super) fn tensor(&self, mass: f64) -> Matrix3<f64> {
        let OwnInertia { moments, products } = self.described().inertia(mass, self.length());
        MassProperties::tensor(moments.into(), products.map_or_else(Vector3::zeros, Vector3::from))
    }

    /// From a named point to the centre of mass, in the own axes.
    pub(super) fn to_centre(&self, anchor: Anchor) -> Option<Vector3<f64>> {
        self.described().to_centre(anchor, self.length())
    }

    /// The length of a rod between two points; else nothing.
    fn length(&self) -> f64 {
        self.ends().map_or(0.0, |(from, to)| (to - from).norm())
    }

    /// The letters of its lengths.
    pub(crate) fn letters(&self) -> &'static [&'static str] {
        match self {
            Shape::Rod { .. } => &["L"],
            Shape::Arc { .. } => &["R", "β"],
            Shape::Annulus { .. } | Shape::HollowSphere { .. } => &["R", "R_i"],
            Shape::RodBetween { .. }
            | Shape::EllipticalPlate { .. }
            | Shape::RectangularPlate { .. }
            | Shape::RightTriangularPlate { .. } => &["a", "b"],
            Shape::Box { .. } | Shape::Ellipsoid { .. } | Shape::Tetrahedron { .. } => &["a", "b", "c"],
            Shape::Cylinder { .. }
            | Shape::Tube { .. }
            | Shape::HalfCylinder { .. }
            | Shape::Cone { .. }
            | Shape::ConicalShell { .. }
            | Shape::Paraboloid { .. } => &["R", "h"],
            Shape::HollowCylinder { .. } => &["R", "R_i", "h"],
            Shape::Torus { .. } => &["R", "R_s"],
            Shape::Radii { .. } => &["k"],
            Shape::Ring { .. }
            | Shape::Disc { .. }
            | Shape::HalfDisc { .. }
            | Shape::QuarterDisc { .. }
            | Shape::Sphere { .. }
            | Shape::SphericalShell { .. }
            | Shape::Hemisphere { .. }
            | Shape::HemisphericalShell { .. } => &["R"],
            _ => &[],
        }
    }

    /// The ends of a rod between two points.
    pub(super) fn ends(&self) -> Option<(Vector3<f64>, Vector3<f64>)> {
        match *self {
            Shape::RodBetween { from, to } => Some((from, to)),
            _ => None,
        }
    }
}

impl<W: Worksheet> ShapeGiven<W> {
    pub(super) fn described(&self) -> Described<W::Vec> {
        described!(self, ShapeGiven)
    }
}

impl<V: Vector> Described<V> {
    /// Length, area or volume; the length of a rod between two points is found by `distance`.
    pub(super) fn extent(self, distance: impl Fn(V, V) -> V::Scalar) -> Extent<V::Scalar> {
        match self {
            Described::Primitive(shape) => shape.extent(),
            Described::Between(from, to) => Extent::Length(distance(from, to)),
            Described::Radii(_) | Described::Matrix(..) => Extent::Point,
        }
    }

    /// Moments and products of inertia about the centre of mass in the own axes; `length` is that of a rod between
    /// two points.
    pub(super) fn inertia(self, mass: V::Scalar, length: V::Scalar) -> OwnInertia<V::Scalar> {
        match self {
            Described::Primitive(shape) => shape.inertia(mass),
            Described::Between(..) => Primitive::Rod { length }.inertia(mass),
            Described::Radii(radii) => {
                OwnInertia { moments: radii.components().map(|radius| mass * radius.powi(2)), products: None }
            }
            Described::Matrix(moments, products) => {
                let none = products.value() == Vector3::zeros();
                OwnInertia { moments: moments.components(), products: (!none).then(|| products.components()) }
            }
        }
    }

    /// From a named point to the centre of mass, in the own axes; `length` is that of a rod between two points.
    pub(super) fn to_centre(self, anchor: Anchor, length: V::Scalar) -> Option<V> {
        match self {
            Described::Primitive(shape) => shape.to_centre(anchor),
            // Where its two points are counted from is no place in its own axes: see `Part::middle`.
            Described::Between(..) => Primitive::Rod { length }.to_centre(anchor),
            Described::Radii(_) | Described::Matrix(..) => Primitive::Particle.to_centre(anchor),
        }
    }

    /// Returns true if a rotation about its own z axis leaves the inertia unchanged.
    pub(super) fn is_round(self) -> bool {
        match self {
            Described::Primitive(shape) => shape.is_round(),
            Described::Between(..) => true,
            Described::Radii(_) | Described::Matrix(..) => false,
        }
    }

    /// Returns true if any rotation leaves the inertia unchanged.
    pub(super) fn is_ball(self) -> bool {
        matches!(self, Described::Primitive(shape) if shape.is_ball())
    }
}
