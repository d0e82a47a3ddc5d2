//! A weight split between two adjacent positions of a rotor: holes, bolts, blades.

use dalembert_mechanics::balance;
use std::f64::consts::TAU;

/// Two adjacent positions around a rotor, the first at the angle of a weight or before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Adjacent {
    /// Their numbers, counted from 1.
    pub numbers: [f64; 2],
    /// Angle between neighbours, rad.
    pub pitch: f64,
}

/// The positions on both sides of an angle, of so many around the rotor, number 1 at `start`.
pub(crate) fn adjacent(count: usize, start: f64, angle: f64) -> Adjacent {
    let pitch = TAU / count as f64;
    let before = ((angle - start) / pitch + 1e-12).floor();
    let number = before.rem_euclid(count as f64) + 1.0;
    Adjacent { numbers: [number, number % count as f64 + 1.0], pitch }
}

/// The parts of a weight at two angles: the parallelogram.
pub(crate) fn parts(mass: f64, angle: f64, [first, second]: [f64; 2]) -> [f64; 2] {
    [balance::split_first(mass, angle, first, second), balance::split_second(mass, angle, first, second)]
}
