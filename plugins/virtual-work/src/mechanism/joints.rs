//! What the joints of a mechanism carry: in the axes of the ground and in those of the bodies.

use dalembert_core::{
    TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::Frame;

use super::Solved;
use crate::{
    built::turned,
    parts::{Connection, Joint, carried, verbatim},
    sources::HAUG,
};

/// Multipliers below this part of the largest are rounding alone.
const ROUNDING: f64 = 1e-13;

impl Solved<'_> {
    /// What each joint carries.
    pub(super) fn reactions<W: Worksheet>(&self, sheet: W) {
        for (row, connection) in self.parts.joints.iter().enumerate() {
            let size = match (self.exerted(row), self.carried(row)) {
                (Some([x, y]), _) => x.hypot(y),
                (None, [Some(line), ..]) => line.abs(),
                _ => continue,
            };
            let reason = Text::new(
                "Force that {name} carries, by the equations of Newton and Euler, M q̈ = Q + Φ_qᵀ λ",
            );
            let why = (reason.with("name", &connection.name), HAUG.at("ch. 6"));
            let force = sheet.found(("R", row + 1), "N", size, why);
            sheet.answer(("reaction", row + 1), "Force in the joint", force);
            sheet.whose(("reaction", row + 1), &connection.name);
        }
    }

    /// What a joint exerts on its second point: the force along x and y, or across a line or along a rod; the couple.
    fn carried(&self, row: usize) -> [Option<f64>; 3] {
        carried(self.system, self.rows, row, &self.dynamics.multipliers, ROUNDING)
    }

    /// The parts between which a joint exerts forces, in the order of its points.
    fn joined(&self, row: usize) -> Vec<Frame> {
        let mut parts = Vec::new();
        for part in self.owners(row).flat_map(|owner| self.system.joined(owner)) {
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        parts
    }

    /// The joints of the mechanism that a joint of the form stands for.
    fn owners(&self, row: usize) -> impl Iterator<Item = usize> {
        self.rows.iter().enumerate().filter(move |(_, of)| **of == row).map(|(owner, _)| owner)
    }

    /// The force of a joint on a part, in the axes of the ground.
    fn force_on(&self, part: Frame, row: usize, positions: &[[f64; 3]], multipliers: &[f64]) -> [f64; 2] {
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
            title: "What each joint exerts on its second point".into(),
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
            title: "What each joint exerts on each body, in the axes of the body".into(),
            columns: vec![
                Column { heading: "Joint".into(), unit: "" },
                Column { heading: "Body".into(), unit: "" },
                Column { heading: "Along its x axis".into(), unit: "N" },
                Column { heading: "Across, along its y axis".into(), unit: "N" },
                Column { heading: "Force".into(), unit: "N" },
            ],
            rows: self.parts.joints.iter().enumerate().flat_map(of_joint).collect(),
            foot: Vec::new(),
        }
    }
}
