//! The lines that a body is drawn with.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_core::Ink;
use dalembert_mechanics::rigid::{MassProperties, Principal, primitive::Primitive};
use nalgebra::Vector3;

use super::{Amount, Body, BodyPart, Presence, Shape, shape::Described};
use crate::shared::{flat, scene::Scene};

type Lines = Vec<Vec<Vector3<f64>>>;

/// Parts of a body up to which each has its letters.
const LETTERED: usize = 6;

impl Body {
    /// Draws the body in its own axes; its size, m, for what is drawn beside it.
    pub(crate) fn draw(&self, scene: &mut Scene, body: &MassProperties, principal: &Principal) -> f64 {
        let Body::Parts { .. } = self else {
            let half = equal_ellipsoid(body.mass, principal.moments);
            scene.ellipsoid(body.centre, principal.axes.matrix(), half, Ink::Body);
            let letters = match self {
                Body::Radii { .. } => ["m_0", "r_0", "k"],
                _ => ["m_0", "r_0", "I_0"],
            };
            scene.label(body.centre + principal.axis(2) * half.z, flat::letters(&letters));
            return half.max().max(body.centre.norm());
        };
        let size = self.draw_parts(scene, |point| point);
        if size > 0.0 { size } else { 1.0 }
    }

    /// Draws the parts of the body with their letters, where its points are placed; its size, m, zero without parts.
    pub(crate) fn draw_parts(&self, scene: &mut Scene, place: impl Fn(Vector3<f64>) -> Vector3<f64>) -> f64 {
        let Body::Parts { parts } = self else { return 0.0 };
        let mut size = 0.0f64;
        rods(parts, scene, &place);
        for (part, row) in parts.iter().zip(1..) {
            let ink = if part.presence == Presence::Hole { Ink::Faint } else { Ink::Body };
            let lines = part.lines();
            if parts.len() <= LETTERED {
                part.label(scene, &lines, row, &place);
            }
            if let Shape::Particle = part.shape
                && let Ok(there) = part.properties()
            {
                scene.sphere(place(there.centre), 0.06 * there.centre.norm().max(1e-3), ink);
            }
            for line in lines {
                size = line.iter().fold(size, |size, point| size.max(point.norm()));
                scene.line(line.into_iter().map(&place), ink);
            }
        }
        size
    }
}

/// Draws rods without mass between the centres of successive parts that do not touch, so that they are one body.
fn rods(parts: &[BodyPart], scene: &mut Scene, place: impl Fn(Vector3<f64>) -> Vector3<f64>) {
    let centre = |part: &BodyPart| {
        part.properties().ok().filter(|_| part.presence != Presence::Hole).map(|there| there.centre)
    };
    for pair in parts.windows(2) {
        let [Some(from), Some(to)] = [centre(&pair[0]), centre(&pair[1])] else { continue };
        let Some(along) = (to - from).try_normalize(0.0) else { continue };
        // So far a part reaches from its centre along the line of the centres.
        let reach = |part: &BodyPart, centre: Vector3<f64>| {
            let far = |point: &Vector3<f64>| (point - centre).dot(&along).abs();
            part.lines().iter().flatten().map(far).fold(0.0, f64::max)
        };
        if (to - from).norm() > reach(&pair[0], from) + reach(&pair[1], to) {
            scene.line([place(from), place(to)], Ink::Body);
        }
    }
}

/// Semi-axes of the homogeneous ellipsoid with that mass and these principal moments.
fn equal_ellipsoid(mass: f64, moments: Vector3<f64>) -> Vector3<f64> {
    let sum = moments.sum();
    moments.map(|moment| (2.5 * (sum - 2.0 * moment) / mass).max(0.0).sqrt())
}

impl BodyPart {
    /// Letters of the mass and the position at the centre of mass, those of the shape on its outline. A point at the origin,
    /// where the axes begin, has none.
    fn label(
        &self,
        scene: &mut Scene,
        lines: &[Vec<Vector3<f64>>],
        row: usize,
        place: impl Fn(Vector3<f64>) -> Vector3<f64>,
    ) {
        let Ok(there) = self.properties() else { return };
        let mass = match self.amount {
            Amount::Mass { .. } => "m",
            Amount::PerLength { .. } => "μ",
            Amount::PerArea { .. } => "σ",
            Amount::PerVolume { .. } => "ρ",
        };
        let is_placed = there.centre != Vector3::zeros();
        let letters: &[&str] = if is_placed { &[mass, "r"] } else { &[mass] };
        scene.label(place(there.centre), flat::of_row(letters, row));
        if let Some((from, to)) = self.shape.ends() {
            for (letter, end) in [("a", from), ("b", to)] {
                if end != Vector3::zeros() {
                    scene.label(place(end), flat::of_row(&[letter], row));
                }
            }
        } else if let Some(line) = lines.first().filter(|_| !self.shape.letters().is_empty()) {
            scene.label(place(line[line.len() / 8]), flat::of_row(self.shape.letters(), row));
        }
    }

    /// Outline in the axes of the body.
    fn lines(&self) -> Lines {
        let (Ok(there), Ok(rotation)) = (self.properties(), self.rotation()) else { return Vec::new() };
        if let Some((from, to)) = self.shape.ends() {
            let half = (to - from) / 2.0;
            return vec![vec![there.centre - half, there.centre + half]];
        }
        let (lines, centre) = match self.shape.described() {
            Described::Primitive(shape) => (outline(shape), shape.centre().unwrap_or_else(Vector3::zeros)),
            _ => {
                let body = if there.mass < 0.0 { there.taken_away() } else { there };
                let Ok(principal) = body.principal() else { return Vec::new() };
                let half = equal_ellipsoid(body.mass, principal.moments);
                let lines = outline(Primitive::Ellipsoid { a: half.x, b: half.y, c: half.z });
                let placed = |point: Vector3<f64>| body.centre + principal.axes * point;
                return lines.into_iter().map(|line| line.into_iter().map(placed).collect()).collect();
            }
        };
        let placed = |point: Vector3<f64>| there.centre + rotation * (point - centre);
        lines.into_iter().map(|line| line.into_iter().map(placed).collect()).collect()
    }
}

/// Part of an ellipse about the z axis, at a height.
fn arc(a: f64, b: f64, z: f64, from: f64, to: f64) -> Vec<Vector3<f64>> {
    let steps = ((to - from).abs() / TAU * 48.0).ceil().clamp(2.0, 48.0);
    (0..=steps as usize)
        .map(|n| from + (to - from) * n as f64 / steps)
        .map(|angle| Vector3::new(a * angle.cos(), b * angle.sin(), z))
        .collect()
}

fn circle(radius: f64, z: f64) -> Vec<Vector3<f64>> {
    arc(radius, radius, z, 0.0, TAU)
}

/// The same line with its axes in the order y, z, x: from the plane xy into yz, or into zx when done twice.
fn turned(line: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    line.iter().map(|p| Vector3::new(p.z, p.x, p.y)).collect()
}

/// Four lines from a circle at one height to one at another.
fn sides(lower: f64, from: f64, upper: f64, to: f64) -> Lines {
    (0..4)
        .map(|n| f64::from(n) * FRAC_PI_2)
        .map(|angle| {
            let along = Vector3::new(angle.cos(), angle.sin(), 0.0);
            vec![along * lower + Vector3::z() * from, along * upper + Vector3::z() * to]
        })
        .collect()
}

fn polygon(points: &[(f64, f64)], z: f64) -> Vec<Vector3<f64>> {
    points.iter().chain(points.first()).map(|&(x, y)| Vector3::new(x, y, z)).collect()
}

/// Two outlines at `±h/2`, and lines from corner to corner.
fn prism(outline: impl Fn(f64) -> Vec<Vector3<f64>>, corners: &[(f64, f64)], height: f64) -> Lines {
    let half = height / 2.0;
    let edges = corners.iter().map(|&(x, y)| vec![Vector3::new(x, y, -half), Vector3::new(x, y, half)]);
    [outline(-half), outline(half)].into_iter().chain(edges).collect()
}

fn rectangle(a: f64, b: f64) -> [(f64, f64); 4] {
    let (x, y) = (a / 2.0, b / 2.0);
    [(-x, -y), (x, -y), (x, y), (-x, y)]
}

fn half_circle(radius: f64, z: f64) -> Vec<Vector3<f64>> {
    let mut line = arc(radius, radius, z, 0.0, PI);
    line.push(Vector3::new(radius, 0.0, z));
    line
}

/// The outline of a shape in its own axes.
fn outline(shape: Primitive<f64>) -> Lines {
    match shape {
        Primitive::Particle => vec![vec![Vector3::zeros()]],
        Primitive::Rod { length } => {
            vec![vec![Vector3::z() * (-length / 2.0), Vector3::z() * (length / 2.0)]]
        }
        Primitive::Arc { radius, angle } => vec![arc(radius, radius, 0.0, 0.0, angle)],
        Primitive::Ring { radius } => vec![circle(radius, 0.0)],
        Primitive::Disc { radius } => {
            vec![circle(radius, 0.0), vec![Vector3::x() * -radius, Vector3::x() * radius]]
        }
        Primitive::Annulus { outer, inner } => vec![circle(outer, 0.0), circle(inner, 0.0)],
        Primitive::HalfDisc { radius } => vec![half_circle(radius, 0.0)],
        Primitive::QuarterDisc { radius } => {
            let mut line = arc(radius, radius, 0.0, 0.0, FRAC_PI_2);
            line.extend([Vector3::zeros(), Vector3::x() * radius]);
            vec![line]
        }
        Primitive::EllipticalPlate { a, b } => vec![arc(a, b, 0.0, 0.0, TAU)],
        Primitive::RectangularPlate { a, b } => vec![polygon(&rectangle(a, b), 0.0)],
        Primitive::RightTriangularPlate { a, b } => vec![polygon(&[(0.0, 0.0), (a, 0.0), (0.0, b)], 0.0)],
        Primitive::Box { a, b, c } => prism(|z| polygon(&rectangle(a, b), z), &rectangle(a, b), c),
        Primitive::Cylinder { radius, height } | Primitive::Tube { radius, height } => {
            let half = height / 2.0;
            let mut lines = sides(radius, -half, radius, half);
            lines.extend([circle(radius, -half), circle(radius, half)]);
            lines
        }
        Primitive::HollowCylinder { outer, inner, height } => {
            let half = height / 2.0;
            let mut lines = sides(outer, -half, outer, half);
            lines.extend([
                circle(outer, -half),
                circle(outer, half),
                circle(inner, -half),
                circle(inner, half),
            ]);
            lines
        }
        Primitive::HalfCylinder { radius, height } => {
            prism(|z| half_circle(radius, z), &[(radius, 0.0), (0.0, radius), (-radius, 0.0)], height)
        }
        Primitive::Cone { radius, height } | Primitive::ConicalShell { radius, height } => {
            let mut lines = sides(0.0, 0.0, radius, height);
            lines.push(circle(radius, height));
            lines
        }
        Primitive::Sphere { radius }
        | Primitive::SphericalShell { radius }
        | Primitive::HollowSphere { outer: radius, .. } => {
            outline(Primitive::Ellipsoid { a: radius, b: radius, c: radius })
        }
        Primitive::Ellipsoid { a, b, c } => vec![
            arc(a, b, 0.0, 0.0, TAU),
            turned(&arc(b, c, 0.0, 0.0, TAU)),
            turned(&turned(&arc(c, a, 0.0, 0.0, TAU))),
        ],
        Primitive::Hemisphere { radius } | Primitive::HemisphericalShell { radius } => vec![
            circle(radius, 0.0),
            turned(&arc(radius, radius, 0.0, 0.0, PI)),
            turned(&turned(&arc(radius, radius, 0.0, -FRAC_PI_2, FRAC_PI_2))),
        ],
        Primitive::Torus { radius, section } => {
            let mut lines = vec![
                circle(radius + section, 0.0),
                circle(radius - section, 0.0),
                circle(radius, section),
                circle(radius, -section),
            ];
            lines.push(
                turned(&turned(&circle(section, 0.0))).iter().map(|p| p + Vector3::x() * radius).collect(),
            );
            lines.push(
                turned(&turned(&circle(section, 0.0))).iter().map(|p| p - Vector3::x() * radius).collect(),
            );
            lines
        }
        Primitive::Paraboloid { radius, height } => {
            let profile: Vec<(f64, f64)> =
                (-12..=12).map(|n| f64::from(n) / 12.0).map(|t| (radius * t, height * t * t)).collect();
            vec![
                circle(radius, height),
                profile.iter().map(|&(r, z)| Vector3::new(r, 0.0, z)).collect(),
                profile.iter().map(|&(r, z)| Vector3::new(0.0, r, z)).collect(),
            ]
        }
        Primitive::Tetrahedron { a, b, c } => {
            let (x, y, z, o) = (Vector3::x() * a, Vector3::y() * b, Vector3::z() * c, Vector3::zeros());
            vec![vec![o, x, y, o, z, x], vec![y, z]]
        }
    }
}
