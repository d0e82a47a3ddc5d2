//! The constraint equations of a mechanism at its position, and the linear system of its velocities.

use dalembert_core::{
    TableExhibit, Text,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::{BodyFrame, Equation, Pose, RelativeCoordinate};

use super::Solved;
use crate::shared::parts::verbatim;

/// Coefficients below this part of the largest of their equation are zero.
const ROUNDING: f64 = 1e-12;

fn quantity(value: f64, unit: &'static str) -> Cell {
    Cell::Text(Text::new("{side_value}").with_quantity("side_value", value, unit))
}

fn column(heading: &'static str) -> Column {
    Column { heading: heading.into(), unit: "" }
}

impl Solved<'_> {
    /// The constraint equations: both sides at the position, and what is left between them.
    pub(super) fn table_of_constraints(&self) -> TableExhibit {
        let row = |(n, equation): (usize, &Equation)| {
            let positions = &self.state.positions;
            let of_term = |term: &dalembert_mechanics::planar::ConstraintTerm| {
                let value = self.system.value(&term.measure, positions);
                term.weight * term.function.as_ref().map_or(value, |function| function.at(value)[0])
            };
            let left: f64 = equation.terms.iter().map(of_term).sum();
            let right = equation.constant.unwrap_or(0.0);
            let measure = &equation.terms[0].measure;
            let unit = if measure.is_angle() { "deg" } else { "mm" };
            let kind = match (measure, equation.terms.len()) {
                (_, 2..) => "sum of relative coordinates",
                (RelativeCoordinate::Angle { .. }, _) => "relative angle",
                (RelativeCoordinate::Component { direction: [_, y], .. }, _) if *y == 0.0 => {
                    "distance along x"
                }
                (RelativeCoordinate::Component { direction: [x, _], .. }, _) if *x == 0.0 => {
                    "distance along y"
                }
                (RelativeCoordinate::Component { .. } | RelativeCoordinate::Along { .. }, _) => {
                    "distance from the line"
                }
                (RelativeCoordinate::Distance { .. }, _) => "distance of two points",
                (RelativeCoordinate::Bearing { .. }, _) => "polar angle",
            };
            vec![
                Cell::Text(self.name_of_equation(n)),
                kind.into(),
                quantity(left, unit),
                quantity(right, unit),
                quantity(left - right, unit),
            ]
        };
        TableExhibit {
            title: "Constraint equations at the position".into(),
            columns: ["Joint", "Relative coordinate", "Left side", "Right side", "Residual"]
                .map(column)
                .into(),
            rows: self.system.equations().iter().enumerate().map(row).collect(),
            foot: Vec::new(),
        }
    }

    /// The equations of the velocities, `Φ_q q̇ = −Φ_t`: the coefficients of the velocities of each body.
    pub(super) fn table_of_velocity_equations(&self) -> TableExhibit {
        let mut rows = Vec::new();
        for (n, equation) in self.system.equations().iter().enumerate() {
            let is_angle = equation.terms[0].measure.is_angle();
            let first_driver = self.system.equations().len() - self.parts.drivers.len();
            let driver = n.checked_sub(first_driver);
            let rate = driver.map_or(0.0, |driver| self.system.mechanism().drivers[driver].velocity);
            let mut right = Some(quantity(rate, if is_angle { "rad/s" } else { "m/s" }));
            for (body, coefficients) in self.coefficients(equation) {
                let size = self.system.size();
                let largest =
                    coefficients[0].abs().max(coefficients[1].abs()).max(coefficients[2].abs() / size);
                let [x, y] = [0, 1].map(|axis: usize| {
                    let number = coefficients[axis];
                    if number.abs() > ROUNDING * largest { Cell::Number(number) } else { Cell::Empty }
                });
                let turn = match coefficients[2] {
                    turn if turn.abs() <= ROUNDING * largest * size => Cell::Empty,
                    turn if is_angle => Cell::Number(turn),
                    turn => quantity(turn, "mm"),
                };
                let first = right.take();
                let name = if first.is_some() { Cell::Text(self.name_of_equation(n)) } else { Cell::Empty };
                let body = verbatim(&self.parts.bodies[body].name);
                rows.push(vec![name, Cell::Text(body), x, y, turn, first.unwrap_or(Cell::Empty)]);
            }
        }
        TableExhibit {
            title: "Velocity equations: coefficients of the velocities of each body".into(),
            columns: ["Joint", "Body", "of v_Gx", "of v_Gy", "of ω", "Right side"].map(column).into(),
            rows,
            foot: Vec::new(),
        }
    }

    /// The derivative of the left side of an equation with respect to the positions of each body.
    fn coefficients(&self, equation: &Equation) -> Vec<(usize, [f64; 3])> {
        let pose =
            |frame: BodyFrame| frame.map_or_else(Pose::ground, |body| Pose::new(self.state.positions[body]));
        let mut all: Vec<(usize, [f64; 3])> = Vec::new();
        for term in &equation.terms {
            let frames = term.measure.bodies();
            let gradient = term.measure.gradient([&pose(frames[0]), &pose(frames[1])]);
            let rate = term.function.as_ref().map_or(1.0, |function| function.at(gradient.value)[1]);
            for (frame, part) in frames.into_iter().zip([gradient.from, gradient.to]) {
                let Some(body) = frame else { continue };
                let part = part.map(|x: f64| x * term.weight * rate);
                match all.iter_mut().find(|(other, _)| *other == body) {
                    Some((_, sum)) => *sum = [sum[0] + part[0], sum[1] + part[1], sum[2] + part[2]],
                    None => all.push((body, part)),
                }
            }
        }
        all
    }

    /// The joint or driver that an equation belongs to.
    fn name_of_equation(&self, equation: usize) -> Text {
        let owner = self.system.owner(equation);
        match self.rows.get(owner) {
            Some(row) => verbatim(&self.parts.joints[*row].name),
            None => verbatim(&self.parts.drivers[owner - self.rows.len()].name),
        }
    }
}
