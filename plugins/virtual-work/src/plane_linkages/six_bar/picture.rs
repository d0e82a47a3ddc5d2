//! The figure of a six-bar linkage.

use std::f64::consts::TAU;

use dalembert_core::{Ink, Sketch, exhibit::Point as At};

use super::{Attached, LinkOutput, SixBar};
use crate::shared::{
    built::{self, Template},
    figure,
};

impl SixBar {
    /// Draws the linkage at its crank angle; the guide of a slider lies at `still`, from the one end of its way to the other.
    pub(super) fn draw(&self, still: At, (low, high): (f64, f64), sketch: &mut Sketch) -> Option<()> {
        let found = self.plain()?;
        let a = built::away([0.0; 2], self.crank, self.angle);
        let b = At::from(built::away(a, self.coupler, found.angles[0]));
        let (o, a, c) = ((0.0, 0.0), At::from(a), (self.frame, 0.0));
        let [d, end] = found.pins.map(At::from);
        let root = if let Attached::Rocker { .. } = self.attached { c } else { a };
        if let LinkOutput::Slider { direction, .. } = &self.output {
            let on = |along: f64| figure::away(still, along, *direction);
            let spare = 3.0 * sketch.symbol();
            sketch.guide(on(low - spare), on(high + spare)).slider("", end, *direction);
        }
        sketch
            .line("d", o, c, Ink::Faint)
            .link("a", o, a)
            .link("b", a, b)
            .link("c", c, b)
            .bars([root, d, b])
            .link("l₅", d, end);
        let (along, across, first) = match self.attached {
            Attached::Rocker { along, across } => (along, across, (c, b)),
            Attached::Coupler { along, across } => (along, across, (a, b)),
        };
        let foot = figure::away(first.0, along, (first.1.1 - first.0.1).atan2(first.1.0 - first.0.0));
        if along != 0.0 {
            sketch.dimension("p", first.0, foot, 2.0);
        }
        if across != 0.0 {
            sketch.line("q", foot, d, Ink::Faint);
        }
        figure::link_mass(sketch, 2, self.crank_mass.as_ref(), (o, a), 2.0);
        figure::link_mass(sketch, 3, self.coupler_mass.as_ref(), (a, b), -2.0);
        figure::link_mass(sketch, 4, self.rocker_mass.as_ref(), (c, b), -2.0);
        figure::link_mass(sketch, 5, self.link_mass.as_ref(), (d, end), -2.0);
        sketch.pin("O₂", o).pin("O₄", c).joint("A", a).joint("B", b).joint("D", d).angle(
            "θ₂",
            o,
            0.0,
            self.angle.rem_euclid(TAU),
        );
        figure::turning(sketch, o, ("ω₂", self.speed), ("", 0.0));
        match &self.output {
            LinkOutput::Slider { direction, mass, .. } => {
                if *mass != 0.0 {
                    sketch.label("m₆", end);
                }
                sketch.joint("", end);
                figure::on_slider(sketch, "F", end, (found.load, *direction), self.crank);
            }
            LinkOutput::Rocker { pivot, mass, .. } => {
                let pivot = (pivot.x, pivot.y);
                sketch.link("l₆", pivot, end).pin("E", pivot).joint("", end);
                figure::link_mass(sketch, 6, mass.as_ref(), (pivot, end), -2.0);
            }
        }
        Some(())
    }
}
