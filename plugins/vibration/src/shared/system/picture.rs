//! Pictures of systems at rest and in their modes.

use std::f64::consts::TAU;

use dalembert_core::{Animation, Drawing, Ink, Point, Sketch, Text};

use super::{System, banded::size};

/// Distance from mass to mass, and half the width of a mass.
const STEP: f64 = 2.0;
const HALF: f64 = 0.4;
/// So far the largest displacement of a mode goes.
const SWING: f64 = 0.5;
/// Frames of one turn.
const FRAMES: usize = 24;
/// Systems above this size are drawn as a line.
const DRAWN: usize = 12;

/// The system at rest.
pub(crate) fn at_rest(system: &System) -> Drawing {
    sketch(system, &vec![0.0; size(system)], true).titled("The system").finish()
}

/// A mode as it moves; the largest entry of the shape must be 1.
pub(crate) fn mode(system: &System, place: usize, shape: &[f64]) -> Animation {
    let frames = (0..FRAMES).map(|frame| {
        let turn = (TAU * frame as f64 / FRAMES as f64).cos();
        let moved: Vec<f64> = shape.iter().map(|x| SWING * turn * x).collect();
        sketch(system, &moved, false)
    });
    Sketch::animation(Text::new("Mode {mode}").with("mode", place), frames, 2.0)
}

fn sketch(system: &System, moved: &[f64], labels: bool) -> Sketch {
    match system {
        System::Chain { masses, wall } if masses.len() <= DRAWN => {
            let spring = |n: usize| match masses.get(n) {
                Some(mass) => (mass.spring.is_some(), mass.damper.is_some()),
                None => wall
                    .as_ref()
                    .map_or((false, false), |wall| (wall.spring.is_some(), wall.damper.is_some())),
            };
            let ground = |n: usize| (masses[n].ground_spring.is_some(), masses[n].ground_damper.is_some());
            chain(moved, spring, ground, labels)
        }
        System::Uniform { count, damper, ends, .. } if *count <= DRAWN => {
            let link = |place: usize| {
                let held = ends.hold(place, *count);
                (held, held && damper.is_some())
            };
            chain(moved, link, |_| (false, false), labels)
        }
        System::String { .. } => string(moved, labels),
        _ => string(moved, false),
    }
}

/// Masses in a row that move along it.
fn chain(
    moved: &[f64],
    link: impl Fn(usize) -> (bool, bool),
    ground: impl Fn(usize) -> (bool, bool),
    labels: bool,
) -> Sketch {
    let n = moved.len();
    let rest = |row: usize| STEP * (row as f64 + 1.0);
    let at = |row: usize| rest(row) + moved[row];
    let mut sketch = Sketch::default();
    let end = STEP * (n as f64 + 1.0);
    for place in 0..=n {
        let (spring, damper) = link(place);
        if !spring && !damper {
            continue;
        }
        let from = if place == 0 { HALF } else { at(place - 1) + HALF };
        let to = if place == n { end - HALF } else { at(place) - HALF };
        if place == 0 {
            sketch.ground((HALF, 0.8), (HALF, -0.8));
        }
        if place == n {
            sketch.ground((end - HALF, -0.8), (end - HALF, 0.8));
        }
        beside((spring, damper), (from, 0.0), (to, 0.0), &mut sketch);
    }
    for (row, _) in moved.iter().enumerate() {
        let held = ground(row);
        let x = rest(row);
        if held != (false, false) {
            sketch.ground((x - 0.6, -1.6), (x + 0.6, -1.6));
            beside(held, (x, -1.6), (at(row), -HALF), &mut sketch);
        }
        sketch.mass("", (at(row) - HALF, -HALF), (at(row) + HALF, HALF));
        if labels {
            sketch.label(Text::new((row + 1).to_string()), (at(row), HALF));
        } else {
            // Where the mass rests.
            sketch.axis((x, HALF + 0.15), (x, HALF + 0.35));
        }
    }
    sketch
}

/// A spring, a damper, or both side by side.
fn beside(what: (bool, bool), from: Point, to: Point, sketch: &mut Sketch) {
    match what {
        (true, true) => sketch.spring_and_damper(("", ""), from, to, 0.6),
        (true, false) => sketch.spring("", from, to),
        (false, true) => sketch.damper("", from, to),
        (false, false) => sketch,
    };
}

/// Points that move across a line.
fn string(moved: &[f64], labels: bool) -> Sketch {
    let n = moved.len();
    let step = if n > DRAWN { STEP * DRAWN as f64 / n as f64 } else { STEP };
    let at = |row: usize| step * (row as f64 + 1.0);
    let end = (step * (n as f64 + 1.0), 0.0);
    let mut line: Vec<Point> = vec![(0.0, 0.0)];
    line.extend(moved.iter().enumerate().map(|(row, y)| (at(row), *y)));
    line.push(end);
    let mut sketch = Sketch::default();
    sketch.axis((0.0, -SWING), (0.0, SWING)).axis((0.0, 0.0), end).curve(line, Ink::Motion);
    for (row, y) in moved.iter().enumerate() {
        let name = if labels { Text::new((row + 1).to_string()) } else { Text::default() };
        if n <= DRAWN {
            sketch.disc(name, (at(row), *y), 0.15);
        } else if labels {
            sketch.label(name, (at(row), *y));
        }
    }
    sketch
}
