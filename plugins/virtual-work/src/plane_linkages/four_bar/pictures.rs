//! Figures of a four-bar linkage over its range: curves, class, animation.

use std::f64::consts::TAU;

use dalembert_core::{
    Axis, Cell, Column, Exhibit, Ink, Plot, Series, TableExhibit, Text, Worksheet, exhibit::Point as At,
};

use super::{Closing, FourBar, FourBarPosition, FourBarUnknown};
use crate::shared::{
    built::{self, Range, Template, TemplateRange},
    figure,
};

impl FourBar {
    pub(super) fn show<W: Worksheet>(&self, sheet: W) {
        let at = |angle: f64| FourBar { angle, ..self.clone() };
        let range = Range::about(self.angle, |angle| self.closes(angle));
        let cycle = TemplateRange::new(range, "angle", at);
        match self.unknown {
            FourBarUnknown::Torque { .. } => sheet.show(|| cycle.torque(|found| found.torque)),
            FourBarUnknown::Load { .. } => sheet.show(|| {
                cycle.plot(
                    "Torque over one revolution",
                    ("Torque on the rocker", "N*m"),
                    &[("torque", "load", &|found| built::bounded(found.load, found.ratios[1], 1.0))],
                )
            }),
        }
        sheet.show(|| {
            cycle.plot(
                "Velocity ratios",
                ("Ratio of angular velocity to that of the crank", "1"),
                &[
                    ("coupler", "coupler_ratio", &|found| found.ratios[0]),
                    ("rocker", "rocker_ratio", &|found| found.ratios[1]),
                ],
            )
        });
        if self.moves() {
            sheet.show(|| {
                cycle.plot(
                    "Angular accelerations",
                    ("Angular acceleration", "rad/s^2"),
                    &[
                        ("coupler", "coupler_acceleration", &|found| found.accelerations[0]),
                        ("rocker", "rocker_acceleration", &|found| found.accelerations[1]),
                    ],
                )
            });
        }
        let path = || -> Vec<(f64, f64)> {
            let [x, y] = [0, 1]
                .map(|axis| cycle.curve(|found| found.place.map_or(f64::INFINITY, |place| place[axis])));
            x.into_iter().zip(y).map(|((_, x), (_, y))| (x, y)).collect()
        };
        if self.point.is_some() {
            sheet.show(|| {
                Exhibit::Plot(
                    Plot::new(
                        "Coupler curve",
                        Axis::linear("x", "mm"),
                        Axis::linear("y", "mm"),
                        vec![Series::line("point of the coupler", path())],
                    )
                    .equal(),
                )
            });
        }
        let least = || {
            let angles = cycle.curve(|found| (found.angles[1] - found.angles[0]).cos().abs().acos());
            angles.into_iter().fold(f64::INFINITY, |least, (_, angle)| least.min(angle))
        };
        sheet.show(|| Exhibit::Table(self.abilities(range, least())));
        sheet.show(|| {
            let path: Vec<At> = path().into_iter().filter(|(x, _)| x.is_finite()).collect();
            let size = self.frame + self.crank.max(self.rocker);
            built::animation("The four-bar linkage", ("angle", self.angle), range, size, |angle, sketch| {
                let there = at(angle);
                let found = there.plain()?;
                let [o, a, b, c] = there.pins(&found).map(At::from);
                if path.len() > 1 {
                    sketch.curve(path.as_slice(), Ink::Motion);
                }
                sketch.line("d", o, c, Ink::Faint).link("a", o, a).link("b", a, b).link("c", c, b).angle(
                    "θ₂",
                    o,
                    0.0,
                    angle.rem_euclid(TAU),
                );
                if let (Some(point), Some(at)) = (&there.point, found.place) {
                    let at = At::from(at);
                    let foot = figure::away(a, point.along, found.angles[0]);
                    sketch.bars([a, at, b]).dimension("p", a, foot, -1.5);
                    if point.across != 0.0 {
                        sketch.line("q", foot, at, Ink::Faint);
                    }
                    sketch.joint("P", at);
                    built::forces(sketch, &[("F_P", at, [point.force.x, point.force.y])], 0.5 * self.frame);
                }
                figure::link_mass(sketch, 2, there.crank_mass.as_ref(), (o, a), 2.0);
                figure::link_mass(sketch, 3, there.coupler_mass.as_ref(), (a, b), -3.0);
                figure::link_mass(sketch, 4, there.rocker_mass.as_ref(), (c, b), -2.0);
                sketch.pin("O₂", o).pin("O₄", c).joint("A", a).joint("B", b);
                let (crank, rocker) = match there.unknown {
                    FourBarUnknown::Torque { load } => (0.0, load),
                    FourBarUnknown::Load { torque } => (torque, 0.0),
                };
                figure::turning(sketch, o, ("ω₂", there.speed), ("T₂", crank));
                figure::turning(sketch, c, ("", 0.0), ("T₄", rocker));
                Some(())
            })
        });
    }

    /// Returns true if the loop closes at a crank angle.
    fn closes(&self, angle: f64) -> bool {
        let [x, y] = built::away([0.0; 2], self.crank, angle);
        let distance = (self.frame - x).hypot(y);
        distance < self.coupler + self.rocker && distance > (self.coupler - self.rocker).abs()
    }

    fn pins(&self, found: &FourBarPosition<f64>) -> [[f64; 2]; 4] {
        let a = built::away([0.0; 2], self.crank, self.angle);
        [[0.0; 2], a, built::away(a, self.coupler, found.angles[0]), [self.frame, 0.0]]
    }

    /// Class after Grashof, range of the crank and extremes of the transmission angle.
    fn abilities(&self, range: Range, least: f64) -> TableExhibit {
        let lengths = [self.frame, self.crank, self.coupler, self.rocker];
        let (shortest, longest) =
            lengths.iter().fold((f64::INFINITY, 0.0f64), |(s, l), x| (s.min(*x), l.max(*x)));
        let excess = 2.0 * (shortest + longest) - lengths.iter().sum::<f64>();
        let class = if excess.abs() <= 1e-12 * longest {
            "change point: all links can become collinear"
        } else if excess > 0.0 {
            "non-Grashof double rocker: no link rotates fully"
        } else if shortest == self.frame {
            "double crank: crank and rocker rotate fully"
        } else if shortest == self.crank {
            "crank-rocker: the crank rotates fully"
        } else if shortest == self.rocker {
            "rocker-crank: the driven link rotates fully, the crank oscillates"
        } else {
            "Grashof double rocker: the coupler rotates fully"
        };
        let mut rows: Vec<Vec<Cell>> = vec![vec!["Grashof class".into(), class.into()]];
        let side = if self.closing == Closing::Open { "Open loop" } else { "Crossed loop" };
        rows.push(vec!["Closing of the loop".into(), side.into()]);
        if let Range::Between(from, to) = range {
            rows.push(vec!["Crank angle from".into(), from.into()]);
            rows.push(vec!["Crank angle to".into(), to.into()]);
        }
        if least.is_finite() {
            rows.push(vec!["Minimum transmission angle, sampled over the revolution".into(), least.into()]);
        }
        TableExhibit {
            title: Text::from("Kinematic properties of the linkage"),
            columns: vec![
                Column { heading: "Property".into(), unit: "" },
                Column { heading: "Value".into(), unit: "deg" },
            ],
            rows,
            foot: vec![],
        }
    }
}
