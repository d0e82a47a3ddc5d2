//! Drawings of the lever, the rolling body and the pulley.

use std::f64::consts::PI;

use dalembert_core::{Drawing, Ink, Point, Sketch, Text};

use super::{
    AttachedDamper, AttachedSpring, EquivalentSystem, LeverBar, LeverPosition, LoadAmplitude, RollingSurface,
    TurningBody,
};
use crate::shared::letters::{letter_of_row, of_row};

/// The body with what is attached to it.
pub(super) fn drawing(system: &EquivalentSystem) -> Drawing {
    match &system.body {
        TurningBody::Lever { position, .. } => lever(system, position),
        TurningBody::Rolling { radius, surface, .. } => rolling(system, *radius, surface),
        TurningBody::Pulley { masses, .. } => {
            let arms = masses.iter().map(|mass| mass.arm).chain(arms(system));
            let radius = arms.fold(0.0, f64::max);
            pulley(system, if radius > 0.0 { radius } else { 1.0 })
        }
    }
}

/// Arms of springs and dampers, as lengths.
fn arms(system: &EquivalentSystem) -> impl Iterator<Item = f64> {
    let springs = system.springs.iter().filter_map(|spring| match spring {
        AttachedSpring::Linear { arm, .. } => Some(arm.abs()),
        AttachedSpring::Torsional { .. } => None,
    });
    let dampers = system.dampers.iter().filter_map(|damper| match damper {
        AttachedDamper::Linear { arm, .. } => Some(arm.abs()),
        AttachedDamper::Torsional { .. } => None,
    });
    springs.chain(dampers)
}

fn numbered(symbol: &'static str, n: usize) -> Text {
    of_row(&[symbol], n)
}

/// The springs by number and arm.
fn springs(system: &EquivalentSystem) -> impl Iterator<Item = (usize, Option<f64>)> {
    (1..).zip(&system.springs).map(|(n, spring)| match spring {
        AttachedSpring::Linear { arm, .. } => (n, Some(*arm)),
        AttachedSpring::Torsional { .. } => (n, None),
    })
}

/// The dampers by number and arm; torsional ones are not drawn.
fn dampers(system: &EquivalentSystem) -> impl Iterator<Item = (usize, f64)> {
    (1..).zip(&system.dampers).filter_map(|(n, damper)| match damper {
        AttachedDamper::Linear { arm, .. } => Some((n, *arm)),
        AttachedDamper::Torsional { .. } => None,
    })
}

fn lever(system: &EquivalentSystem, position: &LeverPosition) -> Drawing {
    let TurningBody::Lever { bar, masses, .. } = &system.body else { unreachable!("the body is a lever") };
    let ends: Vec<f64> = match *bar {
        LeverBar::Uniform { length, pivot, .. } => vec![-pivot, length - pivot],
        LeverBar::Given { centre, .. } => vec![0.0, centre],
        LeverBar::Light => vec![0.0],
    };
    let signed = system.springs.iter().filter_map(|spring| match spring {
        AttachedSpring::Linear { arm, .. } => Some(*arm),
        AttachedSpring::Torsional { .. } => None,
    });
    let places = || ends.iter().copied().chain(masses.iter().map(|mass| mass.distance));
    let all: Vec<f64> = places().chain(signed).chain(dampers(system).map(|damper| damper.1)).collect();
    let (first, last) = all.iter().fold((0.0f64, 0.0f64), |(low, high), x| (low.min(*x), high.max(*x)));
    let size = if last > first { last - first } else { 1.0 };
    // Along the lever and across it.
    let at = |along: f64, across: f64| -> Point {
        let (along, across) = (along / size * 4.0, across * 4.0);
        match position {
            LeverPosition::Horizontal => (along, across),
            LeverPosition::Hanging { .. } => (across, -along),
            LeverPosition::Standing { .. } => (across, along),
        }
    };
    let mut sketch = Sketch::new("The lever");
    sketch.bars([at(first, 0.0), at(last, 0.0)]).pin("O", at(0.0, 0.0));
    for (n, arm) in springs(system) {
        match arm {
            Some(arm) => {
                let foot = 0.04 * size;
                sketch.ground(at(arm + foot, -0.3), at(arm - foot, -0.3)).spring(
                    numbered("k", n),
                    at(arm, -0.3),
                    at(arm, 0.0),
                );
            }
            None => {
                sketch.torsion_spring(numbered("k", n), at(0.0, 0.0), 0.0);
            }
        }
    }
    for (n, arm) in dampers(system) {
        let foot = 0.04 * size;
        sketch.ground(at(arm - foot, 0.3), at(arm + foot, 0.3)).damper(
            numbered("c", n),
            at(arm, 0.3),
            at(arm, 0.0),
        );
    }
    for (n, mass) in (1..).zip(masses) {
        sketch.particle(numbered("m", n), at(mass.distance, 0.0));
    }
    lengths(system, at, &mut sketch);
    let centre = match *bar {
        LeverBar::Light => None,
        LeverBar::Uniform { length, pivot, .. } => Some(length / 2.0 - pivot),
        LeverBar::Given { centre, .. } => Some(centre),
    };
    if let Some(centre) = centre {
        sketch.mass_centre("G", at(centre, 0.0));
    }
    sketch.finish()
}

/// Arms from the pivot, letters of equal ones together; the length of the bar and the load.
fn lengths(system: &EquivalentSystem, at: impl Fn(f64, f64) -> Point, sketch: &mut Sketch) {
    let TurningBody::Lever { bar, masses, .. } = &system.body else { return };
    let origin = at(0.0, 0.0);
    let mut arms: Vec<(f64, String)> = Vec::new();
    arms.extend(masses.iter().zip(1..).map(|(mass, row)| (mass.distance, letter_of_row("l", row))));
    for (spring, row) in system.springs.iter().zip(1..) {
        if let AttachedSpring::Linear { arm, .. } = spring {
            arms.push((*arm, letter_of_row("a", row)));
        }
    }
    for (damper, row) in system.dampers.iter().zip(1..) {
        if let AttachedDamper::Linear { arm, .. } = damper {
            arms.push((*arm, letter_of_row("b", row)));
        }
    }
    arms.extend(system.reference.map(|reference| (reference, "p".to_owned())));
    match *bar {
        LeverBar::Uniform { length, pivot, .. } => {
            sketch.dimension("L", at(-pivot, 0.0), at(length - pivot, 0.0), 5.0);
            sketch.label("m", at(0.3 * length - pivot, 0.0));
            if pivot > 0.0 {
                sketch.dimension("e", at(-pivot, 0.0), origin, 2.5);
            }
        }
        LeverBar::Given { centre, .. } => {
            arms.push((centre, "d".to_owned()));
            sketch.label("m, J_O", at(centre, 0.0));
        }
        LeverBar::Light => {}
    }
    match system.load.as_ref().map(|load| &load.amplitude) {
        Some(LoadAmplitude::Force { arm, .. }) => {
            arms.push((*arm, "a_F".to_owned()));
            sketch.force("F₀ cos(ω t)", at(*arm, 0.35), at(*arm, 0.05));
        }
        Some(LoadAmplitude::Moment { .. }) => {
            sketch.couple("M₀ cos(ω t)", origin, (0.6, 2.6), Ink::Force);
        }
        None => {}
    }
    let mut drawn: Vec<(f64, Vec<String>)> = Vec::new();
    for (arm, letter) in arms.into_iter().filter(|(arm, _)| *arm != 0.0) {
        match drawn.iter_mut().find(|(other, _)| (other - arm).abs() < 1e-9 * arm.abs()) {
            Some((_, letters)) => letters.push(letter),
            None => drawn.push((arm, vec![letter])),
        }
    }
    // Below the lever, whichever way the arm goes.
    for ((arm, letters), level) in drawn.into_iter().zip(0u8..) {
        let below = (4.0 + 2.0 * f64::from(level)) * if arm < 0.0 { 1.0 } else { -1.0 };
        sketch.dimension(Text::verbatim(letters.join(", ")), origin, at(arm, 0.0), below);
    }
}

fn rolling(system: &EquivalentSystem, radius: f64, surface: &RollingSurface) -> Drawing {
    let mut sketch = Sketch::new("The rolling body");
    sketch.disc("m", (0.0, 1.0), 1.0).dimension("r", (0.0, 1.0), (0.707, 0.293), 0.0);
    match surface {
        RollingSurface::Flat => {
            sketch.ground((-2.5, 0.0), (2.5, 0.0));
        }
        RollingSurface::Trough { radius: large, .. } => {
            let large = (large / radius).min(8.0);
            let half = (2.5 / large).min(1.2);
            let angles = (-PI / 2.0 - half, -PI / 2.0 + half);
            sketch.arc((0.0, large), large, angles, Ink::Body);
        }
    }
    for (n, arm) in springs(system) {
        match arm {
            Some(arm) => {
                let y = arm / radius;
                sketch.ground((-2.4, y - 0.25), (-2.4, y + 0.25)).spring(
                    numbered("k", n),
                    (-2.4, y),
                    (0.0, y),
                );
            }
            None => {
                sketch.torsion_spring(numbered("k", n), (0.0, 1.0), 0.0);
            }
        }
    }
    for (n, arm) in dampers(system) {
        let y = arm / radius;
        sketch.ground((2.4, y + 0.25), (2.4, y - 0.25)).damper(numbered("c", n), (2.4, y), (0.0, y));
    }
    sketch.finish()
}

fn pulley(system: &EquivalentSystem, radius: f64) -> Drawing {
    let TurningBody::Pulley { masses, .. } = &system.body else { unreachable!("the body is a pulley") };
    let mut sketch = Sketch::new("The pulley");
    sketch.pulley("J", (0.0, 0.0), 1.0).pin("O", (0.0, 0.0));
    for (n, mass) in (1..).zip(masses) {
        let x = mass.arm / radius;
        sketch.cord([(x, 0.0), (x, -1.4)]).mass(numbered("m", n), (x - 0.3, -1.9), (x + 0.3, -1.4));
    }
    for (n, arm) in springs(system) {
        match arm {
            Some(arm) => {
                let x = -arm.abs() / radius;
                sketch
                    .ground((x - 0.25, -2.4), (x + 0.25, -2.4))
                    .spring(numbered("k", n), (x, -2.4), (x, -1.0))
                    .cord([(x, -1.0), (x, 0.0)]);
            }
            None => {
                sketch.torsion_spring(numbered("k", n), (0.0, 0.0), 0.0);
            }
        }
    }
    for (n, arm) in dampers(system) {
        let x = -arm.abs() / radius;
        sketch
            .ground((x + 0.25, 2.0), (x - 0.25, 2.0))
            .damper(numbered("c", n), (x, 2.0), (x, 0.8))
            .cord([(x, 0.8), (x, 0.0)]);
    }
    sketch.finish()
}
