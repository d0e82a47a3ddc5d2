//! Transmission angles of the links of a mechanism.

use dalembert_core::{
    TableExhibit, Text,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::{BodyPoint, PlanarState};

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
        let there: Vec<PlanarState> = samples.iter().filter_map(|sample| self.moving(sample)).collect();
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
        for connection in self.parts.joints {
            let Joint::Rod { from, to, .. } = connection.joint else { continue };
            let names = [from, to].map(|end| self.parts.points[end.0].name.as_str());
            let ends = [(names[0], pin(from)), (names[1], pin(to))];
            if ends.iter().all(|(_, end)| end.on.is_some()) {
                links.push(TwoForceLink { name: &connection.name, ends });
            }
        }
        for (body, part) in self.parts.bodies.iter().enumerate() {
            let mut ends = Vec::new();
            let mut is_link = true;
            for (row, connection) in self.parts.joints.iter().enumerate() {
                if !self.holds(row, body) {
                    continue;
                }
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

    /// Returns true if a joint belongs to a body.
    fn holds(&self, row: usize, body: usize) -> bool {
        self.system.equations().iter().enumerate().any(|(equation, of)| {
            self.rows.get(self.system.owner(equation)) == Some(&row)
                && of.terms.iter().any(|term| term.measure.bodies().contains(&Some(body)))
        })
    }

    /// A position with velocities: those of the virtual motion where the driver is at rest.
    fn moving(&self, sample: &Sample) -> Option<PlanarState> {
        if self.system.mechanism().drivers.iter().any(|driver| driver.velocity != 0.0) {
            return Some(sample.state.clone());
        }
        let (_, dynamics) = self.system.kinetostatics(&sample.state.positions).ok()?;
        let velocities = dynamics.coefficients.into_iter().next()?;
        Some(PlanarState { velocities, ..sample.state.clone() })
    }

    /// The transmission angle at the first of two points of a link; none where it is at rest.
    fn transmission(&self, ends: [BodyPoint; 2], state: &PlanarState) -> Option<f64> {
        let [[at, velocity, _], [other, ..]] = ends.map(|end| self.system.point(end, state));
        let size = |[x, y, turn]: &[f64; 3]| x.hypot(*y).max(turn.abs() * self.system.size());
        let fastest = state.velocities.iter().map(size).fold(0.0, f64::max);
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
