//! Scenes in space: lines and words at points of three coordinates, drawn as they are seen from a side.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{Drawing, DrawnShape, Ink, LabelSide, Point};
use crate::Text;

/// A point of a scene: x, y and, upwards, z, in metres or in any one length of the scene.
pub type Point3 = [f64; 3];

/// A sketch in space: its frames, all in the same coordinates, shown one after another and again; one frame stands
/// still.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Title.
    pub title: Text,
    /// Frames; the first one stands for the scene where nothing can move.
    pub frames: Vec<Vec<Shape3>>,
    /// The time of all frames on the screen, in seconds.
    pub period: f64,
    /// From where it is seen, unless somebody turns it.
    pub view: Viewpoint3,
}

/// A part of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape3 {
    /// Straight lines from point to point.
    Polyline(Vec<Point3>, Ink),
    /// The outline of a sphere about a centre.
    Sphere(Point3, f64, Ink),
    /// An arrow from tail to head.
    Arrow(Point3, Point3, Ink),
    /// Words beside a point.
    Label(Point3, Text),
}

/// From where a scene is seen, by parallel rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewpoint3 {
    /// The direction towards the viewer, from x about z, rad.
    pub azimuth: f64,
    /// The same above the plane xy, rad.
    pub elevation: f64,
}

impl Scene {
    /// Projection of one of its frames, which repeat without end, from a viewpoint. Words at the head of an arrow go on
    /// in its direction, others stand away from the middle.
    pub fn seen(&self, frame: usize, view: Viewpoint3) -> Drawing {
        let shapes = self.frames.get(frame % self.frames.len().max(1)).map_or(&[][..], Vec::as_slice);
        let middle = view.point(middle(shapes));
        let side = |at: &Point3| {
            let arrow = shapes.iter().rev().find_map(|shape| match shape {
                Shape3::Arrow(tail, head, _) if head == at => Some(view.point(*tail)),
                _ => None,
            });
            let (from, to) = (arrow.unwrap_or(middle), view.point(*at));
            LabelSide::towards((to.0 - from.0, to.1 - from.1))
        };
        let seen = |shape: &Shape3| match shape {
            Shape3::Polyline(points, ink) => {
                DrawnShape::Polyline(points.iter().map(|at| view.point(*at)).collect(), *ink)
            }
            Shape3::Sphere(at, radius, ink) => DrawnShape::Circle(view.point(*at), *radius, *ink),
            Shape3::Arrow(tail, head, ink) => DrawnShape::Arrow(view.point(*tail), view.point(*head), *ink),
            Shape3::Label(at, words) => DrawnShape::Label(view.point(*at), side(at), words.clone()),
        };
        Drawing { title: self.title.clone(), shapes: shapes.iter().map(seen).collect::<Vec<_>>().into() }
    }
}

/// The middle of the box round the lines of a frame.
fn middle(shapes: &[Shape3]) -> Point3 {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let points = shapes.iter().flat_map(|shape| match shape {
        Shape3::Polyline(points, _) => points.clone(),
        Shape3::Sphere(at, ..) | Shape3::Label(at, _) => vec![*at],
        Shape3::Arrow(tail, head, _) => vec![*tail, *head],
    });
    for point in points {
        for axis in 0..3 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    std::array::from_fn(|axis| f64::midpoint(low[axis], high[axis]))
}

impl Default for Viewpoint3 {
    /// x towards the viewer and to the left, y to the right, z up.
    fn default() -> Self {
        Self { azimuth: 35.0_f64.to_radians(), elevation: 25.0_f64.to_radians() }
    }
}

impl Viewpoint3 {
    /// Projection of a point of a scene onto the drawing plane.
    pub fn point(&self, [x, y, z]: Point3) -> Point {
        let (sin, cos) = self.azimuth.sin_cos();
        let (sin_up, cos_up) = self.elevation.sin_cos();
        (y * cos - x * sin, z * cos_up - (x * cos + y * sin) * sin_up)
    }

    /// The view of somebody who goes round the scene by an angle, counter-clockwise from above, and up by another, at
    /// most until straight above it or below it; rad.
    #[must_use]
    pub fn turned(self, round: f64, up: f64) -> Self {
        Self {
            azimuth: (self.azimuth + round).rem_euclid(TAU),
            elevation: (self.elevation + up).clamp(-FRAC_PI_2, FRAC_PI_2),
        }
    }
}
