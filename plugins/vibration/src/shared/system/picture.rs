//! Pictures of systems at rest and in their modes.

use std::f64::consts::TAU;

use dalembert_core::{Animation, Drawing, DrawnShape, Ink, Point, Text};

use super::{Ends, System};

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
    Drawing { title: "The system".into(), shapes: shapes(system, &vec![0.0; size(system)], true) }
}

/// A mode as it moves; the largest entry of the shape must be 1.
pub(crate) fn mode(system: &System, place: usize, shape: &[f64]) -> Animation {
    let frames = (0..FRAMES)
        .map(|frame| {
            let turn = (TAU * frame as f64 / FRAMES as f64).cos();
            let moved: Vec<f64> = shape.iter().map(|x| SWING * turn * x).collect();
            shapes(system, &moved, false)
        })
        .collect();
    Animation::new(Text::new("Mode {mode}").with("mode", place), frames, 2.0)
}

fn size(system: &System) -> usize {
    match system {
        System::Chain { masses, .. } => masses.len(),
        System::String { masses, .. } => masses.len(),
        System::Uniform { count, .. } => *count,
        System::Matrices { entries } => {
            entries.iter().map(|entry| entry.row.max(entry.column)).fold(0.0, f64::max) as usize
        }
    }
}

fn shapes(system: &System, moved: &[f64], labels: bool) -> Vec<DrawnShape> {
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
                let held = match ends {
                    Ends::BothFixed => true,
                    Ends::FirstFixed => place < *count,
                    Ends::Free => place > 0 && place < *count,
                };
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
) -> Vec<DrawnShape> {
    let n = moved.len();
    let at = |row: usize| STEP * (row as f64 + 1.0) + moved[row];
    let mut shapes = Vec::new();
    let end = STEP * (n as f64 + 1.0);
    for place in 0..=n {
        let (spring, damper) = link(place);
        if !spring && !damper {
            continue;
        }
        let from = if place == 0 { HALF } else { at(place - 1) + HALF };
        let to = if place == n { end - HALF } else { at(place) - HALF };
        if place == 0 {
            shapes.push(DrawnShape::Ground((HALF, -0.8), (HALF, 0.8)));
        }
        if place == n {
            shapes.push(DrawnShape::Ground((end - HALF, 0.8), (end - HALF, -0.8)));
        }
        let both = if spring && damper { 0.25 } else { 0.0 };
        if spring {
            shapes.push(DrawnShape::Spring((from, both), (to, both)));
        }
        if damper {
            shapes.push(DrawnShape::Damper((from, -both), (to, -both)));
        }
    }
    for (row, _) in moved.iter().enumerate() {
        let (spring, damper) = ground(row);
        let x = STEP * (row as f64 + 1.0);
        if spring || damper {
            shapes.push(DrawnShape::Ground((x - 0.6, -1.6), (x + 0.6, -1.6)));
        }
        let both = if spring && damper { 0.25 } else { 0.0 };
        if spring {
            shapes.push(DrawnShape::Spring((at(row) - both, -HALF), (x - both, -1.6)));
        }
        if damper {
            shapes.push(DrawnShape::Damper((at(row) + both, -HALF), (x + both, -1.6)));
        }
        shapes.push(DrawnShape::Block((at(row) - HALF, -HALF), (at(row) + HALF, HALF), Ink::Body));
        if labels {
            shapes.push(DrawnShape::Label((at(row) - 0.2, HALF + 0.3), Text::new((row + 1).to_string())));
        } else {
            // Where the mass rests.
            shapes.push(DrawnShape::Polyline(vec![(x, HALF + 0.15), (x, HALF + 0.35)], Ink::Faint));
        }
    }
    shapes
}

/// Points that move across a line.
fn string(moved: &[f64], labels: bool) -> Vec<DrawnShape> {
    let n = moved.len();
    let step = if n > DRAWN { STEP * DRAWN as f64 / n as f64 } else { STEP };
    let at = |row: usize| step * (row as f64 + 1.0);
    let ends: [Point; 2] = [(0.0, 0.0), (step * (n as f64 + 1.0), 0.0)];
    let mut line = vec![ends[0]];
    line.extend(moved.iter().enumerate().map(|(row, y)| (at(row), *y)));
    line.push(ends[1]);
    let mut shapes = vec![
        DrawnShape::Polyline(vec![(0.0, -SWING), (0.0, SWING)], Ink::Faint),
        DrawnShape::Polyline(ends.to_vec(), Ink::Faint),
        DrawnShape::Polyline(line, Ink::Motion),
    ];
    if n <= DRAWN {
        shapes.extend(
            moved.iter().enumerate().map(|(row, y)| DrawnShape::Circle((at(row), *y), 0.15, Ink::Body)),
        );
    }
    if labels {
        shapes.extend((0..n).map(|row| DrawnShape::Label((at(row), 0.4), Text::new((row + 1).to_string()))));
    }
    shapes
}
