//! Scissors of crossed bars, as a mechanism.

use std::f64::consts::PI;

use dalembert_mechanics::planar::{BodyPoint, PlanarBody, PlanarJoint, PlanarMechanism};

/// Crossed bars with a table on top: for each stage the bar that rises to the right and the one that rises to the
/// left, both from their lower ends, then the table from its left joint.
pub(crate) struct Scissor {
    pub(crate) stages: usize,
    pub(crate) bar: f64,
}

impl Scissor {
    pub(crate) fn rising(&self, stage: usize, distance: f64) -> BodyPoint {
        BodyPoint::body(2 * stage, [distance, 0.0])
    }

    pub(crate) fn falling(&self, stage: usize, distance: f64) -> BodyPoint {
        BodyPoint::body(2 * stage + 1, [distance, 0.0])
    }

    pub(crate) fn table(&self, x: f64, y: f64) -> BodyPoint {
        BodyPoint::body(2 * self.stages, [x, y])
    }

    /// The lift without drivers and loads, and where its bodies are.
    pub(crate) fn built(&self, angle: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let (n, l) = (self.stages, self.bar);
        let foot = BodyPoint::ground([0.0; 2]);
        let mut joints = vec![
            PlanarJoint::Pin { a: foot, b: self.rising(0, 0.0) },
            PlanarJoint::Slot { guide: foot, direction: 0.0, pin: self.falling(0, 0.0), offset: 0.0 },
        ];
        for stage in 0..n {
            joints.push(PlanarJoint::Pin { a: self.rising(stage, l / 2.0), b: self.falling(stage, l / 2.0) });
            if stage + 1 < n {
                joints.push(PlanarJoint::Pin { a: self.falling(stage, l), b: self.rising(stage + 1, 0.0) });
                joints.push(PlanarJoint::Pin { a: self.rising(stage, l), b: self.falling(stage + 1, 0.0) });
            }
        }
        joints.push(PlanarJoint::Pin { a: self.falling(n - 1, l), b: self.table(0.0, 0.0) });
        joints.push(PlanarJoint::Slot {
            guide: self.table(0.0, 0.0),
            direction: 0.0,
            pin: self.rising(n - 1, l),
            offset: 0.0,
        });
        let (wide, high) = (l * angle.cos(), l * angle.sin());
        let mut drawn = Vec::new();
        for stage in 0..n {
            let y = stage as f64 * high;
            drawn.push([0.0, y, angle]);
            drawn.push([wide, y, PI - angle]);
        }
        drawn.push([0.0, n as f64 * high, 0.0]);
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 2 * n + 1],
            joints,
            ..PlanarMechanism::default()
        };
        (mechanism, drawn)
    }
}
