//! Drawings and animations of a train: discs along their shafts, amplitudes as ordinates.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Animation, Drawing, Ink, Sketch, Text};

use super::{TorsionalTrain, TrainInertia, verbatim};
use crate::shared::{letters::of_row, spring::torsional::TorsionalSpring};

/// Half the height of a disc, the height of an amplitude of one, and the distance of shaft lines.
const DISC: f64 = 0.55;
const AMPLITUDE: f64 = 0.9;
const LINE: f64 = 2.4;
/// Frames of an animation.
const FRAMES: u16 = 24;

/// Positions of the discs in the drawing.
pub(super) struct Layout {
    at: Vec<(f64, f64)>,
}

impl Layout {
    /// Discs joined by shafts stand side by side; geared ones and side branches on a line of their own below.
    pub(super) fn of(problem: &TorsionalTrain) -> Self {
        let count = problem.discs.len();
        let mut joined: Vec<Vec<(usize, bool)>> = vec![Vec::new(); count];
        for shaft in &problem.shafts {
            let [a, b] = shaft.ends();
            joined[a].push((b, true));
            joined[b].push((a, true));
        }
        for pair in &problem.gears {
            joined[pair.driving.0].push((pair.driven.0, false));
            joined[pair.driven.0].push((pair.driving.0, false));
        }
        let mut at: Vec<Option<(f64, f64)>> = vec![None; count];
        let mut lines = 0.0;
        // A chain may start in the middle of the list: begin where only one thing is joined.
        let start = (0..count).find(|disc| joined[*disc].len() <= 1).unwrap_or(0);
        at[start] = Some((0.0, 0.0));
        let mut waiting = vec![start];
        while let Some(disc) = waiting.pop() {
            let Some((x, y)) = at[disc] else { continue };
            let mut same_line = true;
            for &(other, shaft) in &joined[disc] {
                if at[other].is_some() {
                    continue;
                }
                at[other] = Some(if shaft && same_line {
                    same_line = false;
                    (x + 2.0, y)
                } else {
                    lines -= LINE;
                    (if shaft { x + 2.0 } else { x }, lines)
                });
                waiting.push(other);
            }
        }
        Self { at: at.into_iter().map(|at| at.unwrap_or((0.0, 0.0))).collect() }
    }

    /// The train at rest, with the letters of its discs, shafts, gears and torques.
    pub(super) fn drawing(&self, problem: &TorsionalTrain) -> Drawing {
        let mut sketch = self.still(problem, Ink::Body).titled("The train");
        for ((disc, &(x, y)), row) in problem.discs.iter().zip(&self.at).zip(1..) {
            sketch.label(verbatim(&disc.name), (x, y + DISC));
            if let TrainInertia::Rotor(rotor) = &disc.inertia {
                sketch.label(of_row(rotor.letters(), row), (x, y - DISC));
            }
        }
        for (shaft, row) in problem.shafts.iter().zip(1..) {
            let [a, b] = shaft.ends().map(|disc| self.at[disc]);
            let line = a.1.min(b.1);
            let middle = (f64::midpoint(a.0, b.0), line);
            match &shaft.stiffness {
                TorsionalSpring::Shaft { section, .. } => {
                    let (left, right) = (a.0.min(b.0) + 0.15, a.0.max(b.0) - 0.15);
                    sketch.label(of_row(section.each(), row), middle).dimension(
                        of_row(&["L"], row),
                        (left, line),
                        (right, line),
                        -2.0,
                    );
                }
                _ => {
                    sketch.label(of_row(&["k_t"], row), middle);
                }
            }
        }
        for (pair, row) in problem.gears.iter().zip(1..) {
            let [a, b] = [self.at[pair.driving.0], self.at[pair.driven.0]];
            sketch.label(of_row(&["i"], row), (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1)));
        }
        for (torque, row) in problem.torques.iter().flat_map(|all| &all.torques).zip(1..) {
            let (x, y) = self.at[torque.disc.0];
            let turn = |n: i32| {
                let (sin, cos) = (PI * (0.6 + 0.8 * f64::from(n) / 12.0)).sin_cos();
                (x + 0.35 + 0.1 * cos, y + 0.4 * sin)
            };
            sketch.curve((0..12).map(turn).collect::<Vec<_>>(), Ink::Force).force(
                of_row(&["T"], row),
                turn(11),
                turn(12),
            );
        }
        sketch.finish()
    }

    /// A mode, with the amplitudes of the discs as they are; the largest fills the height.
    pub(super) fn animation(&self, problem: &TorsionalTrain, mode: usize, shape: &[f64]) -> Animation {
        let largest = shape.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let frame = |n: u16| {
            let now = AMPLITUDE / largest * (TAU * f64::from(n) / f64::from(FRAMES)).cos();
            let mut sketch = self.still(problem, Ink::Faint);
            for shaft in &problem.shafts {
                let [a, b] = shaft.ends();
                let line = self.at[a].1.min(self.at[b].1);
                let point = |disc: usize| (self.at[disc].0, line + now * shape[disc]);
                sketch.curve([point(a), point(b)], Ink::Motion);
            }
            for (&(x, y), amplitude) in self.at.iter().zip(shape) {
                sketch.curve([(x, y), (x, y + now * amplitude)], Ink::Motion);
            }
            sketch
        };
        let title = Text::new("Mode {mode}: angle of twist along the shafts").with("mode", mode);
        Sketch::animation(title, (0..FRAMES).map(frame), 2.0)
    }

    fn still(&self, problem: &TorsionalTrain, ink: Ink) -> Sketch {
        let mut sketch = Sketch::default();
        for shaft in &problem.shafts {
            let [a, b] = shaft.ends().map(|disc| self.at[disc]);
            sketch.curve([a, (a.0, a.1.min(b.1)), (b.0, a.1.min(b.1)), b], ink);
        }
        for pair in &problem.gears {
            let [a, b] = [self.at[pair.driving.0], self.at[pair.driven.0]];
            sketch.axis(a, b);
        }
        for (disc, &(x, y)) in problem.discs.iter().zip(&self.at) {
            if disc.is_held() {
                sketch.ground((x, y - DISC), (x, y + DISC));
            } else if !matches!(disc.inertia, TrainInertia::Light) && ink == Ink::Body {
                sketch.mass("", (x - 0.15, y - DISC), (x + 0.15, y + DISC));
            } else {
                sketch.curve([(x, y - DISC), (x, y + DISC)], ink);
            }
        }
        sketch
    }
}
