//! Common errors in the moments of inertia of a shape.

use dalembert_core::{Symbol, Worksheet};
use dalembert_mechanics::{
    Real,
    rigid::{self, primitive::Primitive},
};

use super::shape::Described;

const ACROSS: &str = "the moment of inertia about the axis of symmetry used for a transverse axis";
const ALONG: &str = "the moment of inertia about a transverse axis used for the axis of symmetry";
const EDGE: &str = "the moment of inertia taken about an edge of the body";
const CORNER: &str = "the moment of inertia taken about a corner of the plate";
const END: &str = "the moment of inertia taken about a diameter of the end of the cylinder";

/// Records the common errors of the next step of a symbol, the moment of inertia of a shape about one of its own axes
/// through its centre of mass; `length` is that of a rod between two points.
pub(super) fn of_moment<W: Worksheet>(
    shape: Described<W::Vec>,
    axis: usize,
    symbol: impl Into<Symbol>,
    [m, length]: [W::Num; 2],
    sheet: W,
) {
    let symbol = symbol.into();
    let shape = match shape {
        Described::Primitive(shape) => shape,
        Described::Between(..) => Primitive::Rod { length },
        Described::Radii(_) | Described::Matrix(..) => return,
    };
    let note = |what: &'static str, wrong: &dyn Fn() -> W::Num| sheet.common_error(symbol, what, wrong);
    let along = axis == 2;
    if shape.is_round() && !shape.is_ball() && !matches!(shape, Primitive::Rod { .. }) {
        if along {
            note(ALONG, &|| shape.inertia(m).moments[0]);
        } else {
            note(ACROSS, &|| shape.inertia(m).moments[2]);
        }
    }
    match shape {
        Primitive::Rod { length } if !along => {
            note("the moment of inertia of the rod taken about its end", &|| m * length.powi(2) / 3.0);
        }
        Primitive::Ring { radius } => {
            note("the moment of inertia of a solid disc used for the ring", &|| {
                Primitive::Disc { radius }.inertia(m).moments[axis]
            });
        }
        Primitive::Disc { radius } if along => {
            note("the whole mass of the disc taken at its rim", &|| m * radius.powi(2));
        }
        Primitive::Annulus { outer, inner } | Primitive::HollowCylinder { outer, inner, .. } if along => {
            note("the whole mass taken at the mean radius", &|| m * (outer + inner).powi(2) / 4.0);
        }
        Primitive::RectangularPlate { a, b } => {
            note(if along { CORNER } else { EDGE }, &|| m * squares([a, b, 0.0.into()], axis) / 3.0);
        }
        Primitive::Box { a, b, c } => note(EDGE, &|| m * squares([a, b, c], axis) / 3.0),
        Primitive::RightTriangularPlate { a, b } => {
            let squares = || squares([a, b, 0.0.into()], axis);
            note("the factor of the second moment of area of a triangle, 1/36, used with the mass", &|| {
                m * squares() / 36.0
            });
            note("the moment of inertia of the triangle taken about its right-angled corner", &|| {
                m * squares() / 6.0
            });
        }
        Primitive::Cylinder { radius, .. } if along => {
            note("the whole mass of the cylinder taken at its outer surface", &|| m * radius.powi(2));
        }
        Primitive::Cylinder { radius, height } => {
            note(END, &|| m * (radius.powi(2) * 3.0 + height.powi(2) * 4.0) / 12.0);
        }
        Primitive::HollowCylinder { outer, inner, height } => {
            note(END, &|| m * ((outer.powi(2) + inner.powi(2)) * 3.0 + height.powi(2) * 4.0) / 12.0);
        }
        Primitive::Cone { radius, .. } if along => {
            note("the moment of inertia of a cylinder about its axis used for the cone", &|| {
                rigid::disc_axial_inertia(m, radius)
            });
        }
        Primitive::Cone { radius, height } => {
            note("the transverse moment of inertia of the cone taken about its apex", &|| {
                m * (radius.powi(2) + height.powi(2) * 4.0) * 3.0 / 20.0
            });
        }
        Primitive::ConicalShell { radius, .. } if along => {
            note("the moment of inertia of a solid cone used for the shell", &|| {
                m * radius.powi(2) * 3.0 / 10.0
            });
        }
        Primitive::ConicalShell { radius, height } => {
            note("the transverse moment of inertia of the conical shell taken about its apex", &|| {
                m * (radius.powi(2) + height.powi(2) * 2.0) / 4.0
            });
        }
        Primitive::Sphere { radius } => {
            note("the moment of inertia of a thin spherical shell used for the solid sphere", &|| {
                m * radius.powi(2) * 2.0 / 3.0
            });
            note("the moment of inertia of a disc used for the sphere", &|| {
                rigid::disc_axial_inertia(m, radius)
            });
        }
        Primitive::SphericalShell { radius } => {
            note("the moment of inertia of a solid sphere used for the thin shell", &|| {
                m * radius.powi(2) * 2.0 / 5.0
            });
        }
        Primitive::Hemisphere { radius } if along => {
            note("half the moment of inertia of a sphere of the same mass used", &|| {
                m * radius.powi(2) / 5.0
            });
        }
        Primitive::Paraboloid { radius, .. } if along => {
            note("the moment of inertia of a cylinder about its axis used for the paraboloid", &|| {
                rigid::disc_axial_inertia(m, radius)
            });
        }
        Primitive::Paraboloid { radius, height } => {
            note("the transverse moment of inertia of the paraboloid taken about its vertex", &|| {
                m * (radius.powi(2) + height.powi(2) * 3.0) / 6.0
            });
        }
        _ => {}
    }
}

/// The sum of the squares of the two lengths across an axis.
fn squares<S: Real>(lengths: [S; 3], axis: usize) -> S {
    lengths[(axis + 1) % 3].powi(2) + lengths[(axis + 2) % 3].powi(2)
}
