//! Joint reactions of a mechanism: in the axes of the ground, in those of the bodies, and over the range.

use std::ops::Range;

use dalembert_core::{
    Axis, Exhibit, Plot, Series, TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::BodyFrame;

use super::{Sample, Solved};
use crate::{
    shared::{
        built::{check_pin, turned},
        parts::{Connection, Joint, PartLoad, carried, owners, verbatim},
    },
    sources::HAUG,
};

/// Multipliers below this part of the largest are rounding alone.
const ROUNDING: f64 = 1e-13;
/// So many pins are released to check the forces in them.
const MOST_CHECKED: usize = 8;
/// So many pins have a diagram at most.
const MOST_PINS: usize = 4;

impl Solved<'_> {
    /// Answers the reaction of each joint; `determined` if no joint is redundant.
    pub(super) fn reactions<W: Worksheet>(&self, determined: bool, sheet: W) {
        let mut pins = Vec::new();
        for (row, connection) in self.parts.joints.iter().enumerate() {
            let size = match (self.exerted(row), self.carried(row)) {
                (Some([x, y]), _) => x.hypot(y),
                (None, [Some(line), ..]) => line.abs(),
                _ => continue,
            };
            let reason = Text::new(
                "Force transmitted by {name}, by the equations of Newton and Euler, M q̈ = Q + Φ_qᵀ λ",
            );
            let why = (reason.with("name", &connection.name), HAUG.at("ch. 6"));
            let force = sheet.numerical(("R", row + 1), "N", size, why);
            sheet.answer(("reaction", row + 1), "Force in the joint", force);
            sheet.row_label(("reaction", row + 1), &connection.name);
            if let Joint::Pin { .. } = connection.joint {
                pins.extend(self.owners(row).map(|joint| (joint, connection.name.as_str(), force)));
            }
        }
        // Friction goes with the force in its joint, and has none in a joint that is released.
        let is_smooth = !self.parts.loads.iter().any(|load| matches!(load.load, PartLoad::Friction { .. }));
        if determined && is_smooth {
            sheet.verify(|| {
                for (joint, name, force) in pins.into_iter().take(MOST_CHECKED) {
                    check_pin((self.system, self.state, self.dynamics), (joint, name), force, sheet);
                }
            });
        }
    }

    /// Reaction of a joint on its second point: the force along x and y, or across a line or along a rod; the couple.
    fn carried(&self, row: usize) -> [Option<f64>; 3] {
        carried(self.system, self.rows, row, &self.dynamics.multipliers, ROUNDING)
    }

    /// The parts between which a joint exerts forces, in the order of its points.
    fn joined(&self, row: usize) -> Vec<BodyFrame> {
        let mut parts = Vec::new();
        for part in self.owners(row).flat_map(|owner| self.system.connected_parts(owner)) {
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        parts
    }

    /// The joints of the mechanism that a joint of the form stands for.
    pub(super) fn owners(&self, row: usize) -> Range<usize> {
        owners(self.rows, row)
    }

    /// The force of a joint on a part, in the axes of the ground.
    fn force_on(&self, part: BodyFrame, row: usize, positions: &[[f64; 3]], multipliers: &[f64]) -> [f64; 2] {
        let largest = multipliers.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        self.owners(row)
            .map(|owner| self.system.force_on(part, owner, positions, multipliers))
            .fold([0.0; 2], |sum, force| [sum[0] + force[0], sum[1] + force[1]])
            .map(|force| if force.abs() > ROUNDING * largest { force } else { 0.0 })
    }

    /// The force of a joint of two parts on its second one; none of a cord, whose tension is what it carries.
    fn exerted(&self, row: usize) -> Option<[f64; 2]> {
        match (&self.parts.joints[row].joint, &self.joined(row)[..]) {
            (Joint::Cord { .. }, _) => None,
            (_, &[_, second]) => {
                Some(self.force_on(second, row, &self.state.positions, &self.dynamics.multipliers))
            }
            _ => None,
        }
    }

    pub(super) fn table_of_reactions(&self) -> TableExhibit {
        let number = |part: Option<f64>| part.map_or(Cell::Empty, Cell::Number);
        let row = |(row, connection): (usize, &Connection)| {
            let [first, second, couple] = self.carried(row);
            // A pin or weld has no line of its own.
            let line = if second.is_some() { None } else { first };
            let force = self.exerted(row);
            let [x, y] = [0, 1].map(|axis| number(force.map(|force| force[axis])));
            let size = number(force.map(|[x, y]| x.hypot(y)));
            vec![Cell::Text(verbatim(&connection.name)), x, y, size, number(line), number(couple)]
        };
        TableExhibit {
            title: "Reaction of each joint on its second point".into(),
            columns: vec![
                Column { heading: "Joint".into(), unit: "" },
                Column { heading: "Force along x".into(), unit: "N" },
                Column { heading: "Force along y".into(), unit: "N" },
                Column { heading: "Force".into(), unit: "N" },
                Column { heading: "Force along its own line".into(), unit: "N" },
                Column { heading: "Couple".into(), unit: "N*m" },
            ],
            rows: self.parts.joints.iter().enumerate().map(row).collect(),
            foot: Vec::new(),
        }
    }

    /// The forces of the joints on the bodies, in the axes of each body.
    pub(super) fn table_of_axes(&self) -> TableExhibit {
        let of_joint = |(row, connection): (usize, &Connection)| {
            let on_body = |body: usize| {
                let at = &self.state.positions;
                let force = self.force_on(Some(body), row, at, &self.dynamics.multipliers);
                let size = force[0].hypot(force[1]);
                let axes = turned(force, -at[body][2]);
                let [along, across] = axes.map(|x| if x.abs() > 1e-12 * size { x } else { 0.0 });
                vec![
                    Cell::Text(verbatim(&connection.name)),
                    Cell::Text(verbatim(&self.parts.bodies[body].name)),
                    Cell::Number(along),
                    Cell::Number(across),
                    Cell::Number(size),
                ]
            };
            self.joined(row).into_iter().flatten().map(on_body).collect::<Vec<_>>()
        };
        TableExhibit {
            title: "Reaction of each joint on each body, in body axes".into(),
            columns: vec![
                Column { heading: "Joint".into(), unit: "" },
                Column { heading: "Body".into(), unit: "" },
                Column { heading: "Along its x axis".into(), unit: "N" },
                Column { heading: "Transverse, along its y axis".into(), unit: "N" },
                Column { heading: "Force".into(), unit: "N" },
            ],
            rows: self.parts.joints.iter().enumerate().flat_map(of_joint).collect(),
            foot: Vec::new(),
        }
    }

    /// The forces of the pins and the shaking force over the range, each as the curve of its head from a fixed tail.
    pub(super) fn show_polar_diagrams<W: Worksheet>(&self, samples: &[Sample], sheet: W) {
        let pins = self.pins(samples);
        let curve = |&(row, part): &(usize, BodyFrame)| {
            let label = Text::new("{name} on {body}").with_text("body", self.name_of(part));
            let label = label.with("name", &self.parts.joints[row].name);
            polar(label, samples, |sample| self.force_at(sample, (row, part)))
        };
        if !pins.is_empty() {
            let title = "Forces of the pins, in the axes of the ground";
            sheet.show(|| in_ground_axes(title, pins.iter().map(curve).collect()));
        }
        let shaking = |sample: &Sample| self.system.shaking_force(&sample.state);
        if changes(samples, shaking) {
            let title = "Shaking force: resultant force on the ground";
            sheet.show(|| in_ground_axes(title, vec![polar("".into(), samples, shaking)]));
        }
    }

    /// The pins that have a diagram, each with the part whose force is shown: those on the ground first, with the ground.
    fn pins(&self, samples: &[Sample]) -> Vec<(usize, BodyFrame)> {
        let of_pin =
            |(row, connection): (usize, &Connection)| match (&connection.joint, &self.joined(row)[..]) {
                (Joint::Pin { .. }, &[first, second]) => Some((row, first.and(second))),
                _ => None,
            };
        let mut pins: Vec<(usize, BodyFrame)> =
            self.parts.joints.iter().enumerate().filter_map(of_pin).collect();
        pins.retain(|&pin| changes(samples, |sample| self.force_at(sample, pin)));
        pins.sort_by_key(|(_, part)| part.is_some());
        pins.truncate(MOST_PINS);
        pins
    }

    fn force_at(&self, sample: &Sample, (row, part): (usize, BodyFrame)) -> [f64; 2] {
        self.force_on(part, row, &sample.state.positions, &sample.multipliers)
    }
}

/// Returns true if a force varies over the samples. It is examined in some places only: every solve asks, shown or not.
fn changes(samples: &[Sample], force: impl Fn(&Sample) -> [f64; 2]) -> bool {
    const PLACES: usize = 7;
    let places: Vec<&Sample> = samples.iter().step_by(samples.len() / PLACES + 1).collect();
    let multipliers = places.iter().flat_map(|sample| &sample.multipliers);
    let largest = multipliers.fold(0.0f64, |most, x| most.max(x.abs()));
    let forces: Vec<[f64; 2]> = places.iter().map(|sample| force(sample)).collect();
    forces.windows(2).any(|pair| {
        let [[ax, ay], [bx, by]] = [pair[0], pair[1]];
        (bx - ax).hypot(by - ay) > 1e-9 * largest
    })
}

fn polar(label: Text, samples: &[Sample], force: impl Fn(&Sample) -> [f64; 2]) -> Series {
    Series::line(label, samples.iter().map(|sample| force(sample).into()).collect())
}

fn in_ground_axes(title: &'static str, curves: Vec<Series>) -> Exhibit {
    let (x, y) = (Axis::linear("Force along x", "N"), Axis::linear("Force along y", "N"));
    Exhibit::Plot(Plot::new(title, x, y, curves).equal())
}
