//! The couple over time or radius, and an animation of the rotor with the vectors.

use std::f64::consts::{FRAC_PI_3, PI, TAU};

use dalembert_core::{Axis, Exhibit, Ink, Plot, Series};
use nalgebra::{Rotation3, Vector3};

use super::{Bow, CarrierMotion, GyroscopicCouple, LeftOrRight, RotorCarrier};
use crate::shared::{
    flat::letters,
    scene::{self, Scene},
};

impl GyroscopicCouple {
    /// The couple over two periods of a harmonic motion, or against the radius of a turn.
    pub(super) fn plot(&self, couple: f64) -> Option<Exhibit> {
        if let Some((_, period)) = self.harmonic() {
            let at = |n: u16| {
                let t = 2.0 * period * f64::from(n) / 240.0;
                (t, couple * (TAU * t / period).cos())
            };
            return Some(Exhibit::Plot(
                Plot::new(
                    "Gyroscopic couple over two oscillations, from the middle of the first",
                    Axis::linear("time", "s"),
                    Axis::linear("couple", "N*m"),
                    vec![Series::line("C", (0..=240).map(at).collect())],
                )
                .mark("largest", (0.0, couple)),
            ));
        }
        let (radius, label, input) = match self.motion {
            CarrierMotion::SteadyTurn { radius, .. } => {
                (radius, "radius of the turn", "motion.steady-turn.radius")
            }
            CarrierMotion::VerticalCurve { radius, .. } => {
                (radius, "radius of the curve", "motion.vertical-curve.radius")
            }
            _ => return None,
        };
        let at = |n: u16| {
            let share = 0.3 + 2.7 * f64::from(n) / 200.0;
            (radius * share, couple / share)
        };
        let curve = (0..=200).map(at).collect();
        Some(Exhibit::Plot(
            Plot::new(
                "Gyroscopic couple against the radius of the path",
                Axis::linear(label, "m"),
                Axis::linear("couple", "N*m"),
                vec![Series::line("C", curve).of("couple")],
            )
            .over(input)
            .mark("this curve", (radius, couple)),
        ))
    }

    /// The rotor that spins in its carrier, the angular velocities, and the couple.
    pub(super) fn animation(
        &self,
        momentum: Vector3<f64>,
        couple: Vector3<f64>,
        precession: Vector3<f64>,
    ) -> Exhibit {
        let axle = momentum.try_normalize(0.0).unwrap_or_else(|| self.spin_direction());
        let rest = Rotation3::rotation_between(&Vector3::z(), &axle).unwrap_or_else(|| {
            // Straight down: half a turn about any level axis.
            Rotation3::from_axis_angle(&Vector3::x_axis(), PI)
        });
        let turn = if momentum.norm() == 0.0 { 0.0 } else { TAU };
        scene::animation("The rotor, its rotations and the couple", 3.0, |t| {
            let mut scene = Scene::seen_from(-FRAC_PI_3, FRAC_PI_3 / 2.0);
            self.outline(&mut scene);
            let spun = rest * Rotation3::from_axis_angle(&Vector3::z_axis(), turn * t);
            scene.disc(Vector3::zeros(), spun.matrix(), 0.7, Ink::Body);
            scene.line([-axle, axle], Ink::Body);
            let rim = spun * Vector3::x() * 0.7;
            scene.label(
                rest * Vector3::new(0.5, 0.5, 0.0),
                letters(&[self.rotor.letters(), if self.transverse_inertia.is_some() { "I_t" } else { "" }]),
            );
            if !self.rotor.radius_letter().is_empty() {
                scene.line([Vector3::zeros(), rim], Ink::Faint);
                scene.label(rest * Vector3::new(0.35, 0.0, 0.0), self.rotor.radius_letter());
            }
            if self.bearings.is_some() {
                let side = rest * Vector3::y() * 0.45;
                scene.dimension("a", [-axle, Vector3::zeros()], side);
                scene.dimension("b", [Vector3::zeros(), axle], side);
                for end in [-axle, axle] {
                    scene.circle(end, axle, 0.12, Ink::Body);
                }
            }
            let mut arrow = |vector: Vector3<f64>, length: f64, ink: Ink, name: &'static str| {
                if let Some(unit) = vector.try_normalize(0.0) {
                    scene.arrow(Vector3::zeros(), unit * length, ink, name);
                }
            };
            arrow(momentum, 1.5, Ink::Motion, "ω");
            arrow(precession, 1.3, Ink::Motion, self.precession_letter());
            if let CarrierMotion::HeldAtOneEnd { .. } = self.motion {
                arrow(couple, 1.7, Ink::Force, "M");
                scene.dimension("L", [-axle, Vector3::zeros()], Vector3::z() * -0.3);
            } else {
                arrow(-couple, 1.7, Ink::Result, "M_R");
            }
            scene
        })
    }

    /// The plan of the carrier under the rotor, with the keel of a ship and the wheels of a vehicle, and an arrow forward.
    fn outline(&self, scene: &mut Scene) {
        let plan: &[(f64, f64)] = match self.carrier {
            RotorCarrier::Ship => &[
                (2.8, 0.0),
                (2.1, 0.45),
                (1.2, 0.75),
                (0.0, 0.8),
                (-2.0, 0.65),
                (-2.0, -0.65),
                (0.0, -0.8),
                (1.2, -0.75),
                (2.1, -0.45),
                (2.8, 0.0),
            ],
            RotorCarrier::Aircraft => &AIRCRAFT,
            RotorCarrier::Vehicle => &[(2.0, 0.8), (-2.0, 0.8), (-2.0, -0.8), (2.0, -0.8), (2.0, 0.8)],
            RotorCarrier::Frame => &[(1.4, 1.0), (-1.4, 1.0), (-1.4, -1.0), (1.4, -1.0), (1.4, 1.0)],
        };
        scene.line(plan.iter().map(|&(x, y)| Vector3::new(x, y, -0.8)), Ink::Faint);
        match self.carrier {
            RotorCarrier::Ship => {
                let keel = [(2.8, -0.8), (2.3, -1.3), (1.8, -1.5), (-1.9, -1.5), (-2.0, -0.8)];
                scene.line(keel.map(|(x, z)| Vector3::new(x, 0.0, z)), Ink::Faint);
                let transom = [(0.65, -0.8), (0.45, -1.3), (0.0, -1.5), (-0.45, -1.3), (-0.65, -0.8)];
                scene.line(transom.map(|(y, z)| Vector3::new(-2.0, y, z)), Ink::Faint);
            }
            RotorCarrier::Vehicle => {
                for (x, y) in [(1.3, 0.8), (1.3, -0.8), (-1.3, 0.8), (-1.3, -0.8)] {
                    scene.circle(Vector3::new(x, y, -1.0), Vector3::y(), 0.35, Ink::Faint);
                }
            }
            RotorCarrier::Aircraft | RotorCarrier::Frame => {}
        }
        let front = plan.iter().map(|(x, _)| *x).fold(0.0, f64::max);
        let forward = Vector3::new(front, 0.0, -0.8);
        match &self.motion {
            CarrierMotion::SteadyTurn { towards, .. } => {
                let side = if *towards == LeftOrRight::Left { Vector3::y() } else { -Vector3::y() };
                scene.arrow(forward, Vector3::x() * 0.7, Ink::Motion, "v");
                scene.arrow(Vector3::z() * -0.8, side * 1.6, Ink::Faint, "R");
            }
            CarrierMotion::VerticalCurve { bow, .. } => {
                let side = if *bow == Bow::Rising { Vector3::z() } else { -Vector3::z() };
                scene.arrow(forward, Vector3::x() * 0.7, Ink::Motion, "v");
                scene.arrow(Vector3::z() * -0.8, side * 1.4, Ink::Faint, "R");
            }
            _ => scene.arrow(forward, Vector3::x() * 0.5, Ink::Faint, "x"),
        }
    }

    /// The letter of the motion of the carrier, or of the precession that follows from it.
    fn precession_letter(&self) -> &'static str {
        match self.motion {
            CarrierMotion::Pitching { .. } | CarrierMotion::Rolling { .. } => "ω_p",
            CarrierMotion::HarmonicPitching { .. } | CarrierMotion::HarmonicRolling { .. } => "A",
            CarrierMotion::Gimbal { .. } => "ω_g, γ",
            _ => "Ω",
        }
    }
}

const AIRCRAFT: [(f64, f64); 12] = [
    (2.2, 0.0),
    (0.6, 0.25),
    (0.0, 2.0),
    (-0.6, 2.0),
    (-0.5, 0.25),
    (-2.2, 0.2),
    (-2.2, -0.2),
    (-0.5, -0.25),
    (-0.6, -2.0),
    (0.0, -2.0),
    (0.6, -0.25),
    (2.2, 0.0),
];
