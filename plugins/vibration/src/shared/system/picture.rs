//! Pictures of systems at rest and in their modes.

use std::f64::consts::TAU;

use dalembert_core::{Animation, Drawing, Ink, Point, Sketch, Text};

use super::{ChainEnds, System, banded::size};
use crate::shared::letters::of_row;

/// Distance from mass to mass, and half the width of a mass.
const STEP: f64 = 2.0;
const HALF: f64 = 0.4;
/// Equal masses above this number are drawn as the first and the last ones.
const EQUAL: usize = 4;
/// So far the largest displacement of a mode goes.
const SWING: f64 = 0.5;
/// Frames of one turn.
const FRAMES: usize = 24;
/// Systems above this size are drawn as a line.
const DRAWN: usize = 12;

/// The system at rest; loads are the letters of the forces on masses, counted from 1.
pub(crate) fn at_rest(system: &System, loads: &[(usize, Text)]) -> Drawing {
    if let System::Uniform { count, damper, ends, .. } = system
        && *count > EQUAL
    {
        return equal(*count, damper.is_some(), *ends).finish();
    }
    let mut sketch = sketch(system, &vec![0.0; size(system)], true).titled("The system");
    if let System::Chain { masses, wall } = system
        && masses.len() <= DRAWN
    {
        let half = half(masses.len());
        for (place, letters) in loads {
            let x = STEP * *place as f64;
            if *place == masses.len() && wall.is_none() {
                sketch.force(letters.clone(), (x + half, 0.0), (x + half + 0.9, 0.0));
            } else {
                // A stem on the mass, from which the arrow goes along the row.
                let (foot, top) = ((x, half), (x, half + 0.4));
                sketch.curve([foot, top], Ink::Force).force(letters.clone(), top, (x + 0.8, half + 0.4));
            }
        }
    }
    sketch.finish()
}

/// The first and the last masses of a row of equal ones.
fn equal(count: usize, damped: bool, ends: ChainEnds) -> Sketch {
    let mut sketch = Sketch::new("The system: equal masses and springs");
    let half = 0.6;
    let link = |place: usize, from: f64, to: f64, sketch: &mut Sketch| {
        if ends.hold(place, count) {
            if damped {
                sketch.spring_and_damper(("k", "c"), (from, 0.0), (to, 0.0), 0.6);
            } else {
                sketch.spring("k", (from, 0.0), (to, 0.0));
            }
        }
    };
    // Two masses, a gap, the last one.
    let places = [(1, 2.8), (2, 5.8), (count, 10.4)];
    if ends.hold(0, count) {
        sketch.ground((0.5, 0.9), (0.5, -0.9));
    }
    link(0, 0.5, 2.8 - half, &mut sketch);
    link(1, 2.8 + half, 5.8 - half, &mut sketch);
    link(2, 5.8 + half, 8.1, &mut sketch);
    link(count, 10.4 + half, 12.8, &mut sketch);
    if ends.hold(count, count) {
        sketch.ground((12.8, -0.9), (12.8, 0.9));
    }
    for dot in 0..3 {
        sketch.round("", (8.5 + 0.45 * f64::from(dot), 0.0), 0.05, Ink::Body);
    }
    for (place, x) in places {
        sketch.mass("m", (x - half, -half), (x + half, half)).label(Text::new(place.to_string()), (x, half));
    }
    sketch
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
            chain(moved, spring, ground, labels.then_some(Lettering::Rows))
        }
        System::Uniform { count, damper, ends, .. } if *count <= DRAWN => {
            let link = |place: usize| {
                let held = ends.hold(place, *count);
                (held, held && damper.is_some())
            };
            chain(moved, link, |_| (false, false), labels.then_some(Lettering::Alike))
        }
        System::String { masses, .. } => {
            let mut sketch = string(moved, labels);
            if labels && masses.len() <= DRAWN {
                string_letters(masses.len(), &mut sketch);
            }
            sketch
        }
        _ => string(moved, false),
    }
}

/// Letters of a chain: with their rows, or of links that are all alike.
#[derive(Clone, Copy)]
enum Lettering {
    Rows,
    Alike,
}

/// Half the width of a mass of so many: many are narrower, so that the coils between them are seen.
fn half(count: usize) -> f64 {
    if count > EQUAL { 0.7 * HALF } else { HALF }
}

/// Masses in a row that move along it.
fn chain(
    moved: &[f64],
    link: impl Fn(usize) -> (bool, bool),
    ground: impl Fn(usize) -> (bool, bool),
    labels: Option<Lettering>,
) -> Sketch {
    let n = moved.len();
    let half = half(n);
    let rest = |row: usize| STEP * (row as f64 + 1.0);
    let at = |row: usize| rest(row) + moved[row];
    let mut sketch = Sketch::default();
    let end = STEP * (n as f64 + 1.0);
    for place in 0..=n {
        let (spring, damper) = link(place);
        if !spring && !damper {
            continue;
        }
        let from = if place == 0 { half } else { at(place - 1) + half };
        let to = if place == n { end - half } else { at(place) - half };
        if place == 0 {
            sketch.ground((half, 0.8), (half, -0.8));
        }
        if place == n {
            sketch.ground((end - half, -0.8), (end - half, 0.8));
        }
        let names = match labels {
            None => [Text::default(), Text::default()],
            Some(Lettering::Alike) => ["k".into(), "c".into()],
            Some(Lettering::Rows) if place == n => ["k_w".into(), "c_w".into()],
            Some(Lettering::Rows) => ["k", "c"].map(|letter| of_row(&[letter], place + 1)),
        };
        beside((spring, damper), names, (from, 0.0), (to, 0.0), &mut sketch);
    }
    for (row, _) in moved.iter().enumerate() {
        let held = ground(row);
        let x = rest(row);
        if held != (false, false) {
            sketch.ground((x - 0.6, -1.6), (x + 0.6, -1.6));
            let names = match labels {
                None => [Text::default(), Text::default()],
                Some(_) => ["k_g", "c_g"].map(|letter| of_row(&[letter], row + 1)),
            };
            beside(held, names, (x, -1.6), (at(row), -half), &mut sketch);
        }
        let name = match labels {
            None => Text::default(),
            Some(Lettering::Alike) => "m".into(),
            Some(Lettering::Rows) => of_row(&["m"], row + 1),
        };
        sketch.mass(name, (at(row) - half, -half), (at(row) + half, half));
        if labels.is_none() {
            // Where the mass rests.
            sketch.axis((x, half + 0.15), (x, half + 0.35));
        }
    }
    sketch
}

/// A spring, a damper, or both side by side.
fn beside(what: (bool, bool), [spring, damper]: [Text; 2], from: Point, to: Point, sketch: &mut Sketch) {
    match what {
        (true, true) => sketch.spring_and_damper((spring, damper), from, to, 0.6),
        (true, false) => sketch.spring(spring, from, to),
        (false, true) => sketch.damper(damper, from, to),
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
        let name = if labels { of_row(&["m"], row + 1) } else { Text::default() };
        if n <= DRAWN {
            sketch.disc(name, (at(row), *y), 0.15);
        } else if labels {
            sketch.label(name, (at(row), *y));
        }
    }
    sketch
}

/// Distances under the string, its tension at the end.
fn string_letters(count: usize, sketch: &mut Sketch) {
    let at = |row: usize| (STEP * row as f64, 0.0);
    for row in 1..=count {
        sketch.dimension(of_row(&["l"], row), at(row - 1), at(row), -2.0);
    }
    sketch.dimension("l_e", at(count), at(count + 1), -2.0).force(
        "T",
        at(count + 1),
        (STEP * (count + 1) as f64 + 0.8, 0.0),
    );
}
