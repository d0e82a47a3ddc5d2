//! Drawings of discs on upright shafts, seen from obliquely above.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Ink, Point, Sketch, Text};

/// Half the width of a disc, half the height of its ellipse, half its thickness.
const WIDE: f64 = 0.9;
const DEEP: f64 = 0.22;
const THICK: f64 = 0.14;

/// A disc about a middle, its axis upright.
pub(crate) fn disc(sketch: &mut Sketch, name: impl Into<Text>, (x, y): Point) {
    let rim = |angle: f64, up: f64| (x + WIDE * angle.cos(), y + up + DEEP * angle.sin());
    let part = |from: f64, to: f64, up: f64| {
        (0..=24).map(move |n| rim(from + (to - from) * f64::from(n) / 24.0, up))
    };
    let outline: Vec<Point> = part(0.0, PI, THICK).chain(part(PI, TAU, -THICK)).collect();
    sketch
        .body("", outline)
        .curve(part(PI, TAU, THICK).collect::<Vec<_>>(), Ink::Body)
        .label(name, (x + 0.8 * WIDE, y - 2.2 * THICK));
}

/// An arrow round an upright axis before a point, from left to right.
pub(crate) fn turn(sketch: &mut Sketch, name: impl Into<Text>, (x, y): Point, wide: f64, ink: Ink) {
    let at = |angle: f64| (x + wide * angle.cos(), y + 0.3 * wide * angle.sin());
    let (from, to) = (1.1 * PI, 1.8 * PI);
    let point = |n: i32| at(from + (to - from) * f64::from(n) / 12.0);
    sketch.curve((0..=12).map(point).collect::<Vec<_>>(), ink).vector(name, point(11), point(12), ink);
}

/// A disc that hangs from the ground at a height on its shaft.
pub(crate) fn suspended(sketch: &mut Sketch, [shaft, inertia]: [Text; 2], height: f64) {
    sketch.ground((0.8, height), (-0.8, height)).curve([(-0.06, height), (-0.06, THICK)], Ink::Body).line(
        shaft,
        (0.06, height),
        (0.06, THICK),
        Ink::Body,
    );
    disc(sketch, inertia, (0.0, 0.0));
}
