//! Transmission angles of the links of a mechanism.

use std::collections::BTreeSet;

use dalembert_core::{
    TableExhibit, Text,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::{BodyPoint, Model, PlanarState, SweepResult};

use super::{Sample, Solved};
use crate::shared::parts::Joint;

/// An end that moves slower than this part of the fastest body is at rest.
const STILL: f64 = 1e-9;

/// A link that can only push and pull along the line of its two pins, if nothing else loads it.
pub(super) struct TwoForceLink<'a> {
    name: &'a str,
    /// The pin at each end, by its name and its point.
    ends: [(&'a str, BodyPoint); 2],
}

impl Solved<'_> {
    /// The transmission angle at both ends of each link: the acute angle between its line and the normal of the path of
    /// its pin, which is the line of the crank or rocker that the pin moves, `sin μ = |v·u|/|v|`.
    pub(super) fn table_of_transmission(
        &self,
        links: &[TwoForceLink<'_>],
        samples: &[Sample],
    ) -> TableExhibit {
        let velocities = self.dynamics.coefficients[0].clone();
        let here = PlanarState { velocities, ..self.state.clone() };
        let with_speed = |state: PlanarState| {
            let size = |[x, y, turn]: &[f64; 3]| x.hypot(*y).max(turn.abs() * self.system.size());
            let fastest = state.velocities.iter().map(size).fold(0.0, f64::max);
            (state, fastest)
        };
        let here = with_speed(here);
        let there: Vec<(PlanarState, f64)> = self.moving(samples).into_iter().map(with_speed).collect();
        let mut rows = Vec::new();
        for link in links {
            let [(_, a), (_, b)] = link.ends;
            for ((pin, end), other) in link.ends.into_iter().zip([b, a]) {
                let angle = self.transmission([end, other], &here);
                let angles = there.iter().filter_map(|state| self.transmission([end, other], state));
                let least = angles.chain(angle).reduce(f64::min);
                let number = |angle: Option<f64>| angle.map_or(Cell::Empty, Cell::Number);
                rows.push(vec![
                    Cell::Text(Text::new("{link} at {pin}").with("link", link.name).with("pin", pin)),
                    number(angle),
                    number(least.filter(|_| !samples.is_empty())),
                ]);
            }
        }
        TableExhibit {
            title: "Transmission angles of the links between two pins".into(),
            columns: vec![
                Column { heading: "Link and pin".into(), unit: "" },
                Column { heading: "Transmission angle".into(), unit: "deg" },
                Column { heading: "Minimum over the range".into(), unit: "deg" },
            ],
            rows,
            foot: Vec::new(),
        }
    }

    /// Rods, and bodies that nothing but two pins holds, none of whose pins is on the ground; none where there are several
    /// drivers, since the pins have no paths of their own then.
    pub(super) fn links(&self) -> Vec<TwoForceLink<'_>> {
        if self.dynamics.coefficients.len() != 1 {
            return Vec::new();
        }
        let pin = |reference| self.parts.point(reference);
        let mut links = Vec::new();
        for connection in &self.parts.joints {
            let Joint::Rod { from, to, .. } = connection.joint else { continue };
            let names = [from, to].map(|end| self.parts.points[end.0].name.as_str());
            let ends = [(names[0], pin(from)), (names[1], pin(to))];
            if ends.iter().all(|(_, end)| end.on.is_some()) {
                links.push(TwoForceLink { name: &connection.name, ends });
            }
        }
        let mut rows_of = vec![Vec::new(); self.parts.bodies.len()];
        for row in 0..self.parts.joints.len() {
            for body in self.held(row) {
                rows_of[body].push(row);
            }
        }
        for ((body, part), rows) in self.parts.bodies.iter().enumerate().zip(rows_of) {
            let mut ends = Vec::new();
            let mut is_link = true;
            for row in rows {
                let connection = &self.parts.joints[row];
                match connection.joint {
                    Joint::Pin { a, b } if pin(a).on.is_some() && pin(b).on.is_some() => {
                        let own = if pin(a).on == Some(body) { a } else { b };
                        ends.push((connection.name.as_str(), pin(own)));
                    }
                    _ => is_link = false,
                }
            }
            if let (true, Ok(ends)) = (is_link, ends.try_into()) {
                links.push(TwoForceLink { name: &part.name, ends });
            }
        }
        links
    }

    /// The bodies that a joint belongs to.
    fn held(&self, row: usize) -> BTreeSet<usize> {
        let equations =
            self.owners(row).flat_map(|owner| &self.system.equations()[self.system.equations_of(owner)]);
        let terms = equations.flat_map(|equation| &equation.terms);
        terms.flat_map(|term| term.measure.bodies()).flatten().collect()
    }

    /// The positions of the range with velocities: those of the virtual motion where the only driver is at rest.
    fn moving(&self, samples: &[Sample]) -> Vec<PlanarState> {
        let [first, ..] = samples else { return Vec::new() };
        let mut mechanism = self.system.mechanism().clone();
        if mechanism.drivers.iter().any(|driver| driver.velocity != 0.0) {
            return samples.iter().map(|sample| sample.state.clone()).collect();
        }
        mechanism.drivers[0].velocity = 1.0;
        let values: Vec<f64> = samples.iter().map(|sample| sample.value).collect();
        let positions = &first.state.positions;
        let mut swept = SweepResult::default();
        // The same positions were followed for the samples, so they are again.
        let _end = Model::new(&mechanism, positions)
            .and_then(|system| system.sweep(positions, 0)?.over(&values, &mut swept));
        (0..swept.reached()).map(|n| swept.state(n)).collect()
    }

    /// The transmission angle at the first of two points of a link, in a position with the largest velocity of a body;
    /// none where it is at rest.
    fn transmission(&self, ends: [BodyPoint; 2], (state, fastest): &(PlanarState, f64)) -> Option<f64> {
        let [[at, velocity, _], [other, ..]] = ends.map(|end| self.system.point(end, state));
        let line = [at[0] - other[0], at[1] - other[1]];
        let speed = velocity[0].hypot(velocity[1]);
        if speed <= STILL * fastest {
            return None;
        }
        let along = (velocity[0] * line[0] + velocity[1] * line[1]).abs();
        let across = (velocity[0] * line[1] - velocity[1] * line[0]).abs();
        Some(along.atan2(across))
    }
}
