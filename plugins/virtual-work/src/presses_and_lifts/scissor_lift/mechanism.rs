//! The lift as a mechanism, and the forces in its pins.

use dalembert_core::{
    TableExhibit, Text,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::{BodyPoint, Driver, InverseDynamics, PlanarLoad, RelativeCoordinate};

use super::{CylinderEnd, ScissorLift};
use crate::shared::{
    equilibria::{down, solved},
    scissor::Scissor,
};

impl ScissorLift {
    pub(super) fn scissor(&self) -> Scissor {
        Scissor { stages: self.stages as usize, bar: self.bar }
    }

    fn point(&self, end: &CylinderEnd) -> BodyPoint {
        let scissor = self.scissor();
        match *end {
            CylinderEnd::Ground { x, y } => BodyPoint::ground([x, y]),
            CylinderEnd::Table { x, y } => scissor.table(x, y),
            CylinderEnd::Rising { stage, distance } => scissor.rising(stage as usize - 1, distance),
            CylinderEnd::Falling { stage, distance } => scissor.falling(stage as usize - 1, distance),
        }
    }

    /// An end of the cylinder at an angle of the bars.
    pub(super) fn place_at(&self, end: &CylinderEnd, angle: f64) -> (f64, f64) {
        let (l, (sin, cos)) = (self.bar, angle.sin_cos());
        match *end {
            CylinderEnd::Ground { x, y } => (x, y),
            CylinderEnd::Table { x, y } => (x, f64::from(self.stages) * l * sin + y),
            CylinderEnd::Rising { stage, distance } => {
                (distance * cos, (f64::from(stage - 1) * l + distance) * sin)
            }
            CylinderEnd::Falling { stage, distance } => {
                ((l - distance) * cos, (f64::from(stage - 1) * l + distance) * sin)
            }
        }
    }

    /// Efforts and reactions of one frame that carries its share of the load over its left joint.
    pub(super) fn solved(&self, angle: f64, share: f64) -> Option<InverseDynamics> {
        let scissor = self.scissor();
        let (mut mechanism, drawn) = scissor.built(angle);
        let (lower, upper) = (self.place_at(&self.lower, angle), self.place_at(&self.upper, angle));
        mechanism.drivers = vec![Driver {
            measure: RelativeCoordinate::Distance {
                from: self.point(&self.lower),
                to: self.point(&self.upper),
            },
            value: (upper.0 - lower.0).hypot(upper.1 - lower.1),
            velocity: 0.0,
            acceleration: 0.0,
        }];
        mechanism.loads = vec![down(scissor.table(self.bar * angle.cos() / 2.0, 0.0), share)];
        let weights = (0..2 * scissor.stages)
            .map(|bar| down(BodyPoint::body(bar, [self.bar / 2.0, 0.0]), self.bar_weight));
        mechanism.loads.extend(weights.collect::<Vec<PlanarLoad>>());
        solved(&mechanism, &drawn)
    }

    /// The forces in the pins of a frame.
    pub(super) fn pins(&self, share: f64) -> Option<TableExhibit> {
        let effort = self.solved(self.angle, share)?;
        let mut rows = Vec::new();
        let mut row = |name: Text, force: [Option<f64>; 2]| {
            let cell = |x: Option<f64>| x.map_or(Cell::Empty, Cell::Number);
            let size = force[0].unwrap_or(0.0).hypot(force[1].unwrap_or(0.0));
            rows.push(vec![Cell::Text(name), cell(force[0]), cell(force[1]), Cell::Number(size)]);
        };
        // In the order of the equations: two for a pin, one for a sliding joint.
        let mut left = effort.multipliers.iter().copied();
        row("Fixed foot".into(), [left.next(), left.next()]);
        row("Sliding foot".into(), [None, left.next()]);
        for stage in 1..=self.stages {
            row(Text::new("Crossing of stage {stage}").with("stage", stage), [left.next(), left.next()]);
            if stage < self.stages {
                row(
                    Text::new("Left joint over stage {stage}").with("stage", stage),
                    [left.next(), left.next()],
                );
                row(
                    Text::new("Right joint over stage {stage}").with("stage", stage),
                    [left.next(), left.next()],
                );
            }
        }
        row("Left joint of the table".into(), [left.next(), left.next()]);
        row("Right joint of the table".into(), [None, left.next()]);
        let column = |heading: &'static str, unit: &'static str| Column { heading: heading.into(), unit };
        Some(TableExhibit {
            title: "Forces in the pins of a frame, the load in the middle".into(),
            columns: vec![
                column("Pin", ""),
                column("Horizontal", "N"),
                column("Vertical", "N"),
                column("Size", "N"),
            ],
            rows,
            foot: Vec::new(),
        })
    }
}
