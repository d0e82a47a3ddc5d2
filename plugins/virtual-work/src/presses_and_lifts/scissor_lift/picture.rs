//! The lift in motion, and the force of its cylinder over the way.

use dalembert_core::{Axis, Plot, Series, Sketch};

use super::{CylinderEnd, ScissorLift, ScissorLiftUnknown};
use crate::shared::equilibria::spread;

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
            ScissorLiftUnknown::Cylinder { .. } => "angle",
            // The load of the table is another at another angle.
            ScissorLiftUnknown::Load { .. } => "",
        })
        .mark("at this angle", (self.angle, force))
    }

    /// The length of the barrel of the cylinder: nearly half of its longest stroke.
    fn barrel(&self) -> f64 {
        let lengths = spread([0.1, 1.45], 60).map(|angle| {
            let (from, to) = (self.place_at(&self.lower, angle), self.place_at(&self.upper, angle));
            (to.0 - from.0).hypot(to.1 - from.1)
        });
        0.45 * lengths.fold(0.0, f64::max)
    }

    pub(super) fn frame(&self, angle: f64) -> Sketch {
        let (l, stages) = (self.bar, self.stages);
        let (wide, high) = (l * angle.cos(), l * angle.sin());
        let top = f64::from(stages) * high;
        let mut sketch = Sketch::default();
        sketch.size(1.6 * l);
        let unit = sketch.symbol();
        sketch
            .guide((0.5 * l, 0.0), (1.2 * l, 0.0))
            .slider("", (wide, 0.0), 0.0)
            .axis((0.0, 0.0), (8.0 * unit, 0.0))
            .angle("θ", (0.0, 0.0), 0.0, angle)
            .dimension("L", (wide, 0.0), (0.0, high), 0.0);
        for stage in 0..stages {
            let y = f64::from(stage) * high;
            sketch
                .bars([(0.0, y), (wide, y + high)])
                .bars([(wide, y), (0.0, y + high)])
                .joint("", (wide / 2.0, y + high / 2.0))
                .joint("", (wide, y));
            if stage > 0 {
                sketch.joint("", (0.0, y));
            }
        }
        let (from, to) = (self.place_at(&self.lower, angle), self.place_at(&self.upper, angle));
        sketch
            .mass("", (-0.1 * l, top), (1.1 * l, top + 0.06 * l))
            .pin("", (0.0, 0.0))
            .cylinder("F", from, to, self.barrel().min(0.8 * (to.0 - from.0).hypot(to.1 - from.1)))
            .force("", (wide / 2.0, top + 0.4 * l), (wide / 2.0, top + 0.1 * l))
            .label("W", (wide / 2.0, top + 0.4 * l));
        for (end, at) in [(&self.lower, from), (&self.upper, to)] {
            match *end {
                CylinderEnd::Ground { x, y } => {
                    sketch.pin("", at).dimension("x", (0.0, at.1), at, (-0.35 * l - y.min(0.0)) / unit);
                    if y != 0.0 {
                        sketch.dimension("y", (x, 0.0), at, -2.0);
                    }
                }
                CylinderEnd::Table { x, y } => {
                    sketch.dimension("x", (0.0, top), (x, top), 0.25 * l / unit);
                    if y != 0.0 {
                        sketch.dimension("y", (x, top), at, -2.0);
                    }
                }
                CylinderEnd::Rising { stage, .. } => {
                    let foot = (0.0, f64::from(stage - 1) * high);
                    sketch.dimension("d", foot, at, 2.0);
                }
                CylinderEnd::Falling { stage, .. } => {
                    let foot = (wide, f64::from(stage - 1) * high);
                    sketch.dimension("d", foot, at, -2.0);
                }
            }
        }
        sketch
    }
}
