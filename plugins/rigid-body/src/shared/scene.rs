//! Scenes in space as line drawings: points, axes, arrows and wireframes.
//!
//! A scene takes points in metres (or in any one length of its own) with z up, and gives an exhibit that can be seen
//! from every side.

use std::f64::consts::TAU;

use dalembert_core::{Exhibit, Ink, Point3, Shape3, Text, Viewpoint3, exhibit};
use nalgebra::{Matrix3, Vector3};

/// Frames of an animation.
pub const FRAMES: usize = 24;
/// Straight parts of a drawn circle.
const PARTS: usize = 72;

/// Shapes drawn so far, later ones over earlier ones.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    view: Viewpoint3,
    y_up: bool,
    shapes: Vec<Shape3>,
}

impl Scene {
    /// An empty scene: x towards the viewer and to the left, y to the right, z up.
    pub fn new() -> Self {
        Self::default()
    }

    /// Seen at first from the direction of an azimuth, from x about z, and of an elevation above the plane xy, rad.
    pub fn seen_from(azimuth: f64, elevation: f64) -> Self {
        Self { view: Viewpoint3 { azimuth, elevation }, ..Self::default() }
    }

    /// A scene whose y axis points up: z towards the viewer and to the left, x to the right.
    pub fn y_up() -> Self {
        Self { y_up: true, ..Self::default() }
    }

    /// A scene whose y axis points up, seen at first from the direction of an azimuth, from z about y, and of an
    /// elevation above the plane zx, rad.
    pub fn y_up_from(azimuth: f64, elevation: f64) -> Self {
        Self { y_up: true, ..Self::seen_from(azimuth, elevation) }
    }

    /// All that was drawn.
    pub fn exhibit(self, title: impl Into<Text>) -> Exhibit {
        Exhibit::Scene(exhibit::Scene {
            title: title.into(),
            frames: vec![self.shapes],
            period: 0.0,
            view: self.view,
        })
    }

    /// Straight lines from point to point.
    pub fn line(&mut self, points: impl IntoIterator<Item = Vector3<f64>>, ink: Ink) {
        let points = points.into_iter().map(|point| self.place(point)).collect();
        self.shapes.push(Shape3::Polyline(points, ink));
    }

    /// Words beside a point, after those that stand there already.
    pub fn label(&mut self, at: Vector3<f64>, words: impl Into<Text>) {
        let (at, words) = (self.place(at), words.into());
        let is_there = |other: &Point3| at.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-9);
        let there = self.shapes.iter_mut().find_map(|shape| match shape {
            Shape3::Label(other, text) if is_there(other) && !text.is_empty() => Some(text),
            _ => None,
        });
        match there {
            Some(_) if words.is_empty() => {}
            Some(text) => {
                let one = std::mem::take(text);
                *text = Text::new("{one}, {other}").with_text("one", one).with_text("other", words);
            }
            None => self.shapes.push(Shape3::Label(at, words)),
        }
    }

    /// A named arrow along a vector; none for a vector without length.
    pub fn arrow(&mut self, tail: Vector3<f64>, along: Vector3<f64>, ink: Ink, name: impl Into<Text>) {
        if along.norm() > 0.0 {
            let head = tail + along;
            self.shapes.push(Shape3::Arrow(self.place(tail), self.place(head), ink));
            let name = name.into();
            if !name.is_empty() {
                self.label(head, name);
            }
        }
    }

    /// A distance between two points: a line with two heads, set off by a vector that its extension lines follow.
    pub fn dimension(&mut self, name: impl Into<Text>, ends: [Vector3<f64>; 2], shift: Vector3<f64>) {
        if shift.norm() > 0.0 {
            for end in ends {
                self.line([end, end + shift * 1.15], Ink::Faint);
            }
        }
        let [from, to] = ends.map(|end| end + shift);
        let middle = (from + to) / 2.0;
        for end in [from, to] {
            self.arrow(middle, end - middle, Ink::Faint, "");
        }
        self.label(middle, name);
    }

    /// An angle about a point, from one direction to another.
    pub fn angle(
        &mut self,
        name: impl Into<Text>,
        at: Vector3<f64>,
        [from, to]: [Vector3<f64>; 2],
        radius: f64,
    ) {
        let [from, to] = [from, to].map(|direction| direction.try_normalize(0.0).unwrap_or_else(Vector3::x));
        let side = (to - from * from.dot(&to)).try_normalize(0.0).unwrap_or_default();
        let whole = from.angle(&to);
        let point = |part: f64| {
            let (sin, cos) = (whole * part).sin_cos();
            at + (from * cos + side * sin) * radius
        };
        self.line((0..=12).map(|n| point(f64::from(n) / 12.0)), Ink::Faint);
        self.label(point(0.5), name);
    }

    /// A couple or a rotation about an axis: an arrow nearly all round it.
    pub fn turn(
        &mut self,
        name: impl Into<Text>,
        at: Vector3<f64>,
        axis: Vector3<f64>,
        radius: f64,
        ink: Ink,
    ) {
        if axis.norm() > 0.0 {
            let [x, y] = across(axis).map(|v| v * radius);
            let point = |part: f64| {
                let (sin, cos) = (0.8 * TAU * part).sin_cos();
                at + x * cos + y * sin
            };
            self.line((0..=24).map(|n| point(f64::from(n) / 24.0)), ink);
            self.arrow(point(0.93), point(1.0) - point(0.93), ink, name);
        }
    }

    /// Three named axes of a length along the columns of a rotation.
    pub fn axes(
        &mut self,
        origin: Vector3<f64>,
        rotation: &Matrix3<f64>,
        length: f64,
        names: [&'static str; 3],
    ) {
        for (axis, name) in names.into_iter().enumerate() {
            self.arrow(origin, rotation.column(axis) * length, Ink::Faint, name);
        }
    }

    /// A circle about an axis (any length).
    pub fn circle(&mut self, centre: Vector3<f64>, axis: Vector3<f64>, radius: f64, ink: Ink) {
        let [across, along] = across(axis);
        self.line(ring(centre, across * radius, along * radius), ink);
    }

    /// A thin disc or hoop about the third axis of a rotation: its rim, and a diameter that shows how it turned.
    pub fn disc(&mut self, centre: Vector3<f64>, rotation: &Matrix3<f64>, radius: f64, ink: Ink) {
        let [x, y] = [0, 1].map(|n| rotation.column(n) * radius);
        self.line(ring(centre, x, y), ink);
        self.line([centre - x, centre + x], ink);
    }

    /// A box about the axes of a rotation, with the lengths of its edges.
    pub fn cuboid(&mut self, centre: Vector3<f64>, rotation: &Matrix3<f64>, edges: Vector3<f64>, ink: Ink) {
        let corner =
            |x: f64, y: f64, z: f64| centre + rotation * Vector3::new(x, y, z).component_mul(&edges) / 2.0;
        const ROUND: [(f64, f64); 5] = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
        for z in [-1.0, 1.0] {
            self.line(ROUND.map(|(x, y)| corner(x, y, z)), ink);
        }
        for (x, y) in &ROUND[..4] {
            self.line([corner(*x, *y, -1.0), corner(*x, *y, 1.0)], ink);
        }
    }

    /// A cylinder from the middle of one end to that of the other.
    pub fn cylinder(&mut self, ends: [Vector3<f64>; 2], radius: f64, ink: Ink) {
        let [x, y] = across(ends[1] - ends[0]).map(|v| v * radius);
        for end in ends {
            self.line(ring(end, x, y), ink);
        }
        for side in [x, -x, y, -y] {
            self.line(ends.map(|end| end + side), ink);
        }
    }

    /// A cone from its apex to the middle of its base.
    pub fn cone(&mut self, apex: Vector3<f64>, base: Vector3<f64>, radius: f64, ink: Ink) {
        let [x, y] = across(base - apex).map(|v| v * radius);
        self.line(ring(base, x, y), ink);
        for side in [x, -x, y, -y] {
            self.line([apex, base + side], ink);
        }
    }

    /// A sphere: its outline, and its circles normal to the axes.
    pub fn sphere(&mut self, centre: Vector3<f64>, radius: f64, ink: Ink) {
        self.shapes.push(Shape3::Sphere(self.place(centre), radius, ink));
        for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
            self.circle(centre, axis, radius, ink);
        }
    }

    /// An ellipsoid by its semi-axes along the columns of a rotation: its sections in the planes of these.
    pub fn ellipsoid(&mut self, centre: Vector3<f64>, rotation: &Matrix3<f64>, half: Vector3<f64>, ink: Ink) {
        let axis = |n: usize| rotation.column(n % 3) * half[n % 3];
        for n in 0..3 {
            self.line(ring(centre, axis(n), axis(n + 1)), ink);
        }
    }

    /// A level square of floor.
    pub fn floor(&mut self, centre: Vector3<f64>, half_edge: f64) {
        let corner = |x: f64, y: f64| centre + Vector3::new(x, y, 0.0) * half_edge;
        let round = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
        self.line(round.map(|(x, y)| corner(x, y)), Ink::Faint);
    }

    /// A point with the coordinates of the scene: the axis that points up comes last.
    fn place(&self, point: Vector3<f64>) -> Point3 {
        let [x, y, z] = point.into();
        if self.y_up { [z, x, y] } else { [x, y, z] }
    }
}

/// An animation of scenes that are each drawn for a part of the whole, from 0 to 1.
pub fn animation(title: impl Into<Text>, period: f64, mut frame: impl FnMut(f64) -> Scene) -> Exhibit {
    let scenes: Vec<Scene> = (0..FRAMES).map(|k| frame(k as f64 / (FRAMES - 1) as f64)).collect();
    let view = scenes.first().map_or_else(Viewpoint3::default, |scene| scene.view);
    let frames = scenes.into_iter().map(|scene| scene.shapes).collect();
    Exhibit::Scene(exhibit::Scene { title: title.into(), frames, period, view })
}

/// Two unit vectors across a direction; with it, right-handed.
pub(crate) fn across(direction: Vector3<f64>) -> [Vector3<f64>; 2] {
    let along = direction.try_normalize(0.0).unwrap_or_else(Vector3::z);
    // The axis that is furthest from the direction.
    let away = if along.x.abs() < 0.9 { Vector3::x() } else { Vector3::y() };
    let first = (away - along * along.dot(&away)).normalize();
    [first, along.cross(&first)]
}

fn ring(centre: Vector3<f64>, x: Vector3<f64>, y: Vector3<f64>) -> impl Iterator<Item = Vector3<f64>> {
    (0..=PARTS).map(move |n| {
        let (sin, cos) = (TAU * n as f64 / PARTS as f64).sin_cos();
        centre + x * cos + y * sin
    })
}
