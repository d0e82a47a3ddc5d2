//! Mass properties held against integrals, closed forms and their own equations.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_mechanics::rigid::{
    BodyError, MassProperties, Principal,
    primitive::{Anchor, Extent, Primitive, ShapeError},
};
use nalgebra::{Matrix3, Rotation3, Vector3};
use proptest::prelude::*;

use crate::close::{close, found};

/// Nodes and weights of ten points on (0, 1), by Gauss.
const GAUSS: [(f64, f64); 5] = [
    (0.1488743389816312, 0.2955242247147529),
    (0.4333953941292472, 0.2692667193099963),
    (0.6794095682990244, 0.219086362515982),
    (0.8650633666889845, 0.1494513491505806),
    (0.9739065285171717, 0.0666713443086881),
];

/// Integrals of a map from the unit cube: `∫ dV`, `∫ r dV`, `∫ r rᵀ dV`.
#[derive(Clone, Copy)]
struct Integrals {
    extent: f64,
    first: Vector3<f64>,
    second: Matrix3<f64>,
}

/// Integrals over the image of the unit cube, line or square, with the density of the map; `panels` in each direction.
fn integrate(dimensions: usize, panels: usize, at: impl Fn([f64; 3]) -> (Vector3<f64>, f64)) -> Integrals {
    let mut nodes = Vec::new();
    for panel in 0..panels {
        for (x, w) in GAUSS {
            for x in [-x, x] {
                let width = 1.0 / panels as f64;
                nodes.push(((panel as f64 + f64::midpoint(1.0, x)) * width, w / 2.0 * width));
            }
        }
    }
    let one = vec![(0.5, 1.0)];
    let along = |n: usize| if n < dimensions { &nodes } else { &one };
    let mut all = Integrals { extent: 0.0, first: Vector3::zeros(), second: Matrix3::zeros() };
    for &(u, a) in along(0) {
        for &(v, b) in along(1) {
            for &(w, c) in along(2) {
                let (r, density) = at([u, v, w]);
                let weight = a * b * c * density;
                all.extent += weight;
                all.first += r * weight;
                all.second += r * r.transpose() * weight;
            }
        }
    }
    all
}

/// A point of a shape from three numbers in (0, 1), and how much of the shape there is about it.
fn mapped(shape: Primitive<f64>) -> (usize, Box<dyn Fn([f64; 3]) -> (Vector3<f64>, f64)>) {
    let polar = |r: f64, angle: f64, z: f64| Vector3::new(r * angle.cos(), r * angle.sin(), z);
    // A ball by radius, polar angle and longitude.
    let ball = |r: f64, polar: f64, angle: f64| {
        Vector3::new(polar.sin() * angle.cos(), polar.sin() * angle.sin(), polar.cos()) * r
    };
    let sector =
        move |inner: f64, outer: f64, from: f64, to: f64, height: f64| -> Box<dyn Fn([f64; 3]) -> _> {
            Box::new(move |[u, v, w]: [f64; 3]| {
                let r = inner + (outer - inner) * u;
                let density = r * (outer - inner) * (to - from) * if height > 0.0 { height } else { 1.0 };
                (polar(r, from + (to - from) * v, height * (w - 0.5)), density)
            })
        };
    let spherical = move |inner: f64, outer: f64, most: f64| -> Box<dyn Fn([f64; 3]) -> _> {
        Box::new(move |[u, v, w]: [f64; 3]| {
            let r = inner + (outer - inner) * u;
            let density = r * r * (most * v).sin() * (outer - inner) * most * TAU;
            (ball(r, most * v, TAU * w), density)
        })
    };
    let shell = move |r: f64, most: f64| -> Box<dyn Fn([f64; 3]) -> _> {
        Box::new(move |[u, v, _]: [f64; 3]| {
            (ball(r, most * u, TAU * v), r * r * (most * u).sin() * most * TAU)
        })
    };
    match shape {
        Primitive::Particle => (0, Box::new(|_| (Vector3::zeros(), 1.0))),
        Primitive::Rod { length } => {
            (1, Box::new(move |[u, ..]| (Vector3::z() * (length * (u - 0.5)), length)))
        }
        Primitive::Arc { radius, angle } => {
            (1, Box::new(move |[u, ..]| (polar(radius, angle * u, 0.0), radius * angle)))
        }
        Primitive::Ring { radius } => {
            (1, Box::new(move |[u, ..]| (polar(radius, TAU * u, 0.0), radius * TAU)))
        }
        Primitive::Disc { radius } => (2, sector(0.0, radius, 0.0, TAU, 0.0)),
        Primitive::Annulus { outer, inner } => (2, sector(inner, outer, 0.0, TAU, 0.0)),
        Primitive::HalfDisc { radius } => (2, sector(0.0, radius, 0.0, PI, 0.0)),
        Primitive::QuarterDisc { radius } => (2, sector(0.0, radius, 0.0, FRAC_PI_2, 0.0)),
        Primitive::EllipticalPlate { a, b } => (
            2,
            Box::new(move |[u, v, _]| {
                let p = polar(u, TAU * v, 0.0);
                (Vector3::new(a * p.x, b * p.y, 0.0), a * b * u * TAU)
            }),
        ),
        Primitive::RectangularPlate { a, b } => {
            (2, Box::new(move |[u, v, _]| (Vector3::new(a * (u - 0.5), b * (v - 0.5), 0.0), a * b)))
        }
        Primitive::RightTriangularPlate { a, b } => {
            (2, Box::new(move |[u, v, _]| (Vector3::new(a * u, b * v * (1.0 - u), 0.0), a * b * (1.0 - u))))
        }
        Primitive::Box { a, b, c } => (
            3,
            Box::new(move |[u, v, w]| (Vector3::new(a * (u - 0.5), b * (v - 0.5), c * (w - 0.5)), a * b * c)),
        ),
        Primitive::Cylinder { radius, height } => (3, sector(0.0, radius, 0.0, TAU, height)),
        Primitive::HollowCylinder { outer, inner, height } => (3, sector(inner, outer, 0.0, TAU, height)),
        Primitive::HalfCylinder { radius, height } => (3, sector(0.0, radius, 0.0, PI, height)),
        Primitive::Tube { radius, height } => (
            2,
            Box::new(move |[u, v, _]| (polar(radius, TAU * u, height * (v - 0.5)), radius * TAU * height)),
        ),
        Primitive::Cone { radius, height } => (
            3,
            Box::new(move |[u, v, w]| {
                let r = radius * w * u;
                (polar(r, TAU * v, height * w), r * radius * w * TAU * height)
            }),
        ),
        Primitive::ConicalShell { radius, height } => (
            2,
            Box::new(move |[u, v, _]| {
                (polar(radius * u, TAU * v, height * u), radius * u * TAU * radius.hypot(height))
            }),
        ),
        Primitive::Sphere { radius } => (3, spherical(0.0, radius, PI)),
        Primitive::HollowSphere { outer, inner } => (3, spherical(inner, outer, PI)),
        Primitive::Hemisphere { radius } => (3, spherical(0.0, radius, FRAC_PI_2)),
        Primitive::SphericalShell { radius } => (2, shell(radius, PI)),
        Primitive::HemisphericalShell { radius } => (2, shell(radius, FRAC_PI_2)),
        Primitive::Ellipsoid { a, b, c } => {
            let unit = spherical(0.0, 1.0, PI);
            (
                3,
                Box::new(move |at| {
                    let (r, density) = unit(at);
                    (Vector3::new(a * r.x, b * r.y, c * r.z), density * a * b * c)
                }),
            )
        }
        Primitive::Torus { radius, section } => (
            3,
            Box::new(move |[u, v, w]| {
                let (s, angle) = (section * u, TAU * v);
                let r = radius + s * angle.cos();
                (polar(r, TAU * w, s * angle.sin()), s * section * TAU * r * TAU)
            }),
        ),
        Primitive::Paraboloid { radius, height } => (
            3,
            Box::new(move |[u, v, w]| {
                // z = h t², so that the rim of each section is polynomial in t.
                let rim = radius * w;
                (polar(rim * u, TAU * v, height * w * w), rim * rim * u * TAU * height * 2.0 * w)
            }),
        ),
        Primitive::Tetrahedron { a, b, c } => (
            3,
            Box::new(move |[u, v, w]| {
                let (x, y) = (u, v * (1.0 - u));
                let z = w * (1.0 - x - y);
                (Vector3::new(a * x, b * y, c * z), a * b * c * (1.0 - u) * (1.0 - x - y))
            }),
        ),
    }
}

fn all_shapes(a: f64, b: f64, c: f64, angle: f64) -> [Primitive<f64>; 27] {
    let (radius, height) = (a, b);
    let (outer, inner) = (a, a * 0.6);
    [
        Primitive::Particle,
        Primitive::Rod { length: a },
        Primitive::Arc { radius, angle },
        Primitive::Ring { radius },
        Primitive::Disc { radius },
        Primitive::Annulus { outer, inner },
        Primitive::HalfDisc { radius },
        Primitive::QuarterDisc { radius },
        Primitive::EllipticalPlate { a, b },
        Primitive::RectangularPlate { a, b },
        Primitive::RightTriangularPlate { a, b },
        Primitive::Box { a, b, c },
        Primitive::Cylinder { radius, height },
        Primitive::HollowCylinder { outer, inner, height },
        Primitive::Tube { radius, height },
        Primitive::HalfCylinder { radius, height },
        Primitive::Cone { radius, height },
        Primitive::ConicalShell { radius, height },
        Primitive::Sphere { radius },
        Primitive::HollowSphere { outer, inner },
        Primitive::SphericalShell { radius },
        Primitive::Hemisphere { radius },
        Primitive::HemisphericalShell { radius },
        Primitive::Ellipsoid { a, b, c },
        Primitive::Torus { radius, section: inner },
        Primitive::Paraboloid { radius, height },
        Primitive::Tetrahedron { a, b, c },
    ]
}

fn near(got: f64, want: f64, size: f64, what: impl Fn() -> String) {
    assert!((got - want).abs() <= 1e-10 * size, "{}: {got} and not {want}", what());
}

#[test]
fn every_shape_is_its_integral() {
    for [a, b, c, angle] in [[0.7, 1.3, 0.9, FRAC_PI_2], [2.0, 0.4, 3.0, 4.5], [1.0, 1.0, 1.0, TAU]] {
        for shape in all_shapes(a, b, c, angle) {
            let (dimensions, map) = mapped(shape);
            let integrals = integrate(dimensions, 2, map);
            let what = |part: &'static str| move || format!("{shape:?}, {part}");
            match shape.extent() {
                Extent::Point => {}
                Extent::Length(x) | Extent::Area(x) | Extent::Volume(x) => {
                    near(x, integrals.extent, integrals.extent, what("extent"));
                }
            }
            let mass = 2.5;
            let own = shape.mass_properties(mass);
            let centre = integrals.first / integrals.extent;
            let second = integrals.second * (mass / integrals.extent) - centre * centre.transpose() * mass;
            let tensor = Matrix3::identity() * second.trace() - second;
            let size = (a * a + b * b + c * c) * mass;
            for n in 0..3 {
                near(own.centre[n], centre[n], a + b + c, what("centre"));
                for k in 0..3 {
                    near(own.inertia[(n, k)], tensor[(n, k)], size, what("inertia"));
                }
            }
            let round = (own.inertia[(0, 0)] - own.inertia[(1, 1)]).abs() < 1e-12 * size
                && own.inertia[(0, 1)].abs() + own.inertia[(1, 2)].abs() + own.inertia[(2, 0)].abs()
                    < 1e-12 * size
                && own.centre.xy().norm() < 1e-12;
            assert!(round || !shape.is_round(), "{shape:?} is not of revolution");
            assert!(own.check().is_ok(), "{shape:?}");
            assert!(shape.check().is_ok(), "{shape:?}");
        }
    }
}

#[test]
fn anchors_are_points_of_the_shape() {
    for shape in all_shapes(0.7, 1.3, 0.9, 2.0) {
        let centre = shape.centre().unwrap_or_else(Vector3::zeros);
        let from = |anchor| shape.to_centre::<Vector3<f64>>(anchor).map(|arm| centre - arm);
        close(found_point(from(Anchor::Origin)).norm(), 0.0, 1e-15);
        close((found_point(from(Anchor::MassCentre)) - centre).norm(), 0.0, 1e-15);
        if let (Some(near), Some(far)) = (from(Anchor::NearEnd), from(Anchor::FarEnd)) {
            let arc = matches!(shape, Primitive::Arc { .. });
            assert!(
                arc || (near.xy().norm() < 1e-12 && far.xy().norm() < 1e-12),
                "{shape:?}: {near} and {far}"
            );
            assert!(arc || far.z > near.z, "{shape:?}");
        }
    }
    let cone = Primitive::Cone { radius: 0.5, height: 2.0 };
    close(found_point(cone.to_centre(Anchor::FarEnd)).z, -0.5, 1e-15);
    let box_ = Primitive::Box { a: 2.0, b: 4.0, c: 6.0 };
    assert_eq!(box_.to_centre(Anchor::Corner), Some(Vector3::new(1.0, 2.0, 3.0)));
    assert_eq!(Primitive::Sphere { radius: 1.0 }.to_centre::<Vector3<f64>>(Anchor::Corner), None);
}

fn found_point(point: Option<Vector3<f64>>) -> Vector3<f64> {
    point.expect("the shape has the point")
}

#[test]
fn what_is_no_shape_is_refused() {
    assert_eq!(
        Primitive::Annulus { outer: 1.0, inner: 1.0 }.check(),
        Err(ShapeError::Hollow { inner: 1.0, outer: 1.0 })
    );
    assert!(Primitive::Torus { radius: 1.0, section: 1.5 }.check().is_err());
}

#[test]
fn what_is_no_body_is_refused_by_its_axis() {
    let body = |moments: [f64; 3], products: [f64; 3]| MassProperties {
        mass: 1.0,
        centre: Vector3::zeros(),
        inertia: MassProperties::tensor(moments.into(), products.into()),
    };
    match body([1.0, 2.0, 3.5], [0.0; 3]).check() {
        Err(BodyError::Triangle { axis, moment, others }) => {
            assert_eq!((axis, moment, others), ([0.0, 0.0, 1.0], 3.5, 3.0));
        }
        other => panic!("{other:?}"),
    }
    match body([1.0, 1.0, 1.0], [0.0, 0.0, 2.0]).check() {
        Err(BodyError::Negative { axis, moment }) => {
            close(moment, -1.0, 1e-14);
            close(axis[0], 0.5f64.sqrt(), 1e-14);
            close(axis[1], 0.5f64.sqrt(), 1e-14);
        }
        other => panic!("{other:?}"),
    }
    // A thin plate and a rod are bodies; only turning the rod about itself is refused.
    assert!(body([1.0, 2.0, 3.0], [0.0; 3]).check().is_ok());
    let rod = body([1.0, 0.0, 1.0], [0.0; 3]);
    assert!(rod.check().is_ok());
    assert_eq!(rod.check_turnable(), Err(BodyError::NoInertia { axis: [0.0, 1.0, 0.0] }));
    assert_eq!(MassProperties { mass: 0.0, ..rod }.check(), Err(BodyError::Mass(0.0)));
    let ball = found(Primitive::Sphere { radius: 1.0 }.mass_properties(1.0).check());
    assert_eq!(*ball.axes.matrix(), Matrix3::identity());
    let whole = Primitive::Sphere { radius: 1.0 }.mass_properties(1.0);
    assert!(matches!(MassProperties::composite(&[whole, whole.taken_away()]), Err(BodyError::Mass(_))));
}

fn vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-3.0..3.0f64).prop_map(Vector3::from)
}

fn rotation() -> impl Strategy<Value = Rotation3<f64>> {
    vector().prop_map(Rotation3::new)
}

fn bodies() -> impl Strategy<Value = Vec<MassProperties>> {
    let one = (0..27usize, 0.1..5.0f64, vector(), rotation(), prop::array::uniform4(0.2..2.0f64));
    prop::collection::vec(one, 1..8).prop_map(|all| {
        all.into_iter()
            .map(|(shape, mass, at, turn, [a, b, c, angle])| {
                all_shapes(a, b, c, angle)[shape].mass_properties(mass).turned(&turn).moved(at)
            })
            .collect()
    })
}

fn alike(a: &MassProperties, b: &MassProperties, within: f64) {
    let size = a.inertia.amax().max(a.mass * a.centre.norm_squared());
    assert!((a.mass - b.mass).abs() <= within * a.mass, "{a:?} and {b:?}");
    assert!((a.centre - b.centre).norm() <= within * (1.0 + a.centre.norm()), "{a:?} and {b:?}");
    assert!((a.inertia - b.inertia).amax() <= within * size.max(a.mass), "{a:?} and {b:?}");
}

proptest! {
    #[test]
    fn a_composite_is_the_same_in_any_order(parts in bodies()) {
        let forth = found(MassProperties::composite(&parts));
        let back: Vec<_> = parts.iter().rev().copied().collect();
        alike(&forth, &found(MassProperties::composite(&back)), 1e-14);
        // And by steps: the first with the rest.
        if parts.len() > 1 {
            let rest = found(MassProperties::composite(&parts[1..]));
            alike(&forth, &found(MassProperties::composite(&[parts[0], rest])), 1e-13);
            // What is added and taken away again leaves the rest.
            let without = found(MassProperties::composite(&[forth, parts[0].taken_away()]));
            alike(&rest, &without, 1e-11 * forth.mass / rest.mass);
        }
    }

    #[test]
    fn parallel_axes_lead_there_and_back(parts in bodies(), point in vector()) {
        let body = found(MassProperties::composite(&parts));
        let back = MassProperties::from_inertia_about(point, body.inertia_about(point), body.mass, body.centre);
        alike(&body, &back, 1e-14);
    }

    #[test]
    fn a_line_sees_the_same_moment_from_any_of_its_points(
        parts in bodies(), point in vector(), direction in vector(), along in -3.0..3.0f64,
    ) {
        prop_assume!(direction.norm() > 0.1);
        let body = found(MassProperties::composite(&parts));
        let here = found(body.inertia_about_line(point, direction));
        let there = found(body.inertia_about_line(point + direction * along, direction * 7.0));
        let size = body.inertia_about(point).amax() + body.mass * 100.0;
        prop_assert!((here - there).abs() <= 1e-13 * size);
        let distance = (point - body.centre).cross(&direction.normalize()).norm();
        let through_g = found(body.inertia_about_line(body.centre, direction));
        prop_assert!((here - through_g - body.mass * distance * distance).abs() <= 1e-13 * size);
    }

    #[test]
    fn principal_axes_satisfy_their_equation(parts in bodies(), turn in rotation()) {
        let body = found(MassProperties::composite(&parts));
        let principal = found(body.check());
        let axes = principal.axes.matrix();
        let size = body.inertia.amax();
        prop_assert!((axes.transpose() * axes - Matrix3::identity()).amax() <= 1e-14);
        prop_assert!((axes.determinant() - 1.0).abs() <= 1e-14);
        let left = body.inertia * axes - axes * Matrix3::from_diagonal(&principal.moments);
        // Moments that count as equal differ by up to 1e-9.
        let gaps = [principal.moments.y - principal.moments.x, principal.moments.z - principal.moments.y];
        let close_pair = gaps.iter().any(|gap| *gap > 0.0 && *gap <= 1e-9 * size);
        prop_assert!(left.amax() <= if close_pair { 1e-9 } else { 1e-13 } * size, "{left}");
        // A turn of the body turns its axes and leaves its moments.
        let turned = found(body.turned(&turn).principal());
        prop_assert!((turned.moments - principal.moments).amax() <= 1e-13 * size);
    }

    #[test]
    fn a_body_of_revolution_keeps_its_axis(mass in 0.1..9.0f64, axis in vector(), angle in -3.0..3.0f64) {
        prop_assume!(axis.norm() > 0.1);
        let turn = Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(axis), angle);
        let disc = Primitive::Disc { radius: 0.8 }.mass_properties(mass).turned(&turn);
        let principal = found(disc.check());
        prop_assert_eq!(principal.symmetry_axis(), Some(2));
        prop_assert!(principal.axis(2).cross(&(turn * Vector3::z())).norm() < 1e-14);
        let Principal { moments, .. } = principal;
        prop_assert!((moments - Vector3::new(0.16, 0.16, 0.32) * mass).amax() < 1e-14 * mass);
    }
    #[test]
    fn a_slender_body_of_revolution_has_its_axis_first(
        mass in 0.1..9.0f64, axis in vector(), angle in -3.0..3.0f64,
    ) {
        prop_assume!(axis.norm() > 0.1);
        let turn = Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(axis), angle);
        let principal = |shape: Primitive<f64>| found(shape.mass_properties(mass).turned(&turn).check());
        let pin = principal(Primitive::Cylinder { radius: 0.2, height: 1.5 });
        prop_assert_eq!(pin.symmetry_axis(), Some(0));
        prop_assert!(pin.axis(0).cross(&(turn * Vector3::z())).norm() < 1e-13);
        prop_assert!((pin.moments - Vector3::new(0.02, 0.1975, 0.1975) * mass).amax() < 1e-14 * mass);
        prop_assert_eq!(principal(Primitive::Box { a: 0.3, b: 0.7, c: 1.1 }).symmetry_axis(), None);
        prop_assert_eq!(principal(Primitive::Sphere { radius: 0.6 }).symmetry_axis(), None);
    }

    #[test]
    fn principal_axes_do_not_depend_on_the_unit_of_mass(turn in rotation()) {
        for moments in [[1.3, 2.1, 2.9], [1.3, 1.3, 2.1], [1.1, 1.9, 1.9]] {
            let principal = |unit: f64| {
                let inertia = Matrix3::from_diagonal(&(Vector3::from(moments) * unit));
                let body = MassProperties { mass: unit, centre: Vector3::zeros(), inertia };
                found(body.turned(&turn).principal())
            };
            let here = principal(1.0);
            for unit in [1e-12, 1e12] {
                let there = principal(unit);
                prop_assert!((there.moments / unit - Vector3::from(moments)).amax() <= 1e-13);
                prop_assert!((there.axes.matrix() - here.axes.matrix()).amax() <= 1e-12);
            }
        }
    }
}
