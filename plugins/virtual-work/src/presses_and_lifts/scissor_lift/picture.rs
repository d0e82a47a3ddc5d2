//! The lift in motion, and the force of its cylinder over the way.

use dalembert_core::{Axis, DrawnShape, Ink, Plot, Series};

use super::{ScissorLift, Sought};
use crate::shared::equilibria::{arrow, spread};

impl ScissorLift {
    pub(super) fn force_over_angle(&self, share: f64, force: f64) -> Plot {
        let most = 8.0 * force.abs().max(share.abs());
        let stages = f64::from(self.stages);
        let at = |angle: f64| {
            let length = |angle: f64| {
                let (from, to) = (self.place_at(&self.lower, angle), self.place_at(&self.upper, angle));
                (to.0 - from.0).hypot(to.1 - from.1)
            };
            let step = 1e-5;
            let growth = (length(angle + step) - length(angle - step)) / (2.0 * step);
            let rise = stages * self.bar * angle.cos();
            let force = (share + stages * self.bar_weight) * rise / growth;
            (angle, if force.abs() <= most { force } else { f64::INFINITY })
        };
        Plot::new(
            "Force of the cylinder against the angle of the bars",
            Axis::linear("angle of the bars", "deg"),
            Axis::linear("force of each cylinder", "kN"),
            vec![Series::line("F", spread([0.05, 1.5], 300).map(at).collect()).of("cylinder_force")],
        )
        .over(match self.sought {
            Sought::Cylinder { .. } => "angle",
            // The load of the table is another at another angle.
            Sought::Load { .. } => "",
        })
        .mark("at this angle", (self.angle, force))
    }

    pub(super) fn frame(&self, angle: f64) -> Vec<DrawnShape> {
        let (l, stages) = (self.bar, self.stages);
        let (wide, high) = (l * angle.cos(), l * angle.sin());
        let top = f64::from(stages) * high;
        let mut shapes = vec![
            DrawnShape::Ground((-0.2 * l, -0.03 * l), (1.4 * l, -0.03 * l)),
            DrawnShape::Pin((0.0, 0.0)),
        ];
        for stage in 0..stages {
            let y = f64::from(stage) * high;
            shapes.push(DrawnShape::Polyline(vec![(0.0, y), (wide, y + high)], Ink::Body));
            shapes.push(DrawnShape::Polyline(vec![(wide, y), (0.0, y + high)], Ink::Body));
        }
        shapes.push(DrawnShape::Block((-0.1 * l, top), (1.1 * l, top + 0.06 * l), Ink::Body));
        let (from, to) = (self.place_at(&self.lower, angle), self.place_at(&self.upper, angle));
        shapes.push(DrawnShape::Polyline(vec![from, to], Ink::Result));
        for end in [from, to] {
            shapes.push(DrawnShape::Circle(end, 0.02 * l, Ink::Result));
        }
        shapes.push(DrawnShape::Label(
            (f64::midpoint(from.0, to.0), f64::midpoint(from.1, to.1) + 0.05 * l),
            "F".into(),
        ));
        shapes.extend(arrow((wide / 2.0, top + 0.4 * l), [0.0, -0.3 * l], "W"));
        shapes
    }
}
