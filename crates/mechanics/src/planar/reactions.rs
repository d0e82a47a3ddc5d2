//! Joint reactions from the Lagrange multipliers, and their resultant on the ground.

use super::{BodyFrame, Model, PlanarLoad, PlanarState, Pose, measure::poses};

impl Model {
    /// The parts between which a joint or driver exerts forces, in the order of its points; the drivers count on after
    /// the joints, as in [`owner`](Model::owner).
    pub fn connected_parts(&self, owner: usize) -> Vec<BodyFrame> {
        let mut parts = Vec::new();
        for equation in &self.equations[self.equations_of(owner)] {
            let lengths = equation.terms.iter().filter(|term| term.measure.has_line());
            for part in lengths.flat_map(|term| term.measure.bodies()) {
                if !parts.contains(&part) {
                    parts.push(part);
                }
            }
        }
        parts
    }

    /// The force that a joint or driver exerts on a part, the ground included, N in the axes of the ground:
    /// `Σ λ ∂Φ/∂(x, y)` over its equations. E. J. Haug, *Computer-Aided Kinematics and Dynamics of Mechanical
    /// Systems* (1989), ch. 6.
    pub fn force_on(
        &self,
        part: BodyFrame,
        owner: usize,
        positions: &[[f64; 3]],
        multipliers: &[f64],
    ) -> [f64; 2] {
        let pose = |frame: BodyFrame| frame.map_or(Pose::ground(), |body| Pose::new(positions[body]));
        let mut force = [0.0; 2];
        for equation in self.equations_of(owner) {
            let multiplier = multipliers[equation];
            let terms = &self.equations[equation].terms;
            for term in terms.iter().filter(|term| term.measure.has_line()) {
                let [from, to] = term.measure.bodies().map(pose);
                let gradient = term.measure.gradient([&from, &to]);
                let rate = term.function.as_ref().map_or(1.0, |function| function.at(gradient.value)[1]);
                for (on, [x, y, _]) in term.measure.bodies().into_iter().zip([gradient.from, gradient.to]) {
                    if on == part {
                        let effort = multiplier * term.weight * rate;
                        force = [force[0] + effort * x, force[1] + effort * y];
                    }
                }
            }
        }
        force
    }

    /// The shaking force: the sum of all forces that the mechanism exerts on the ground, by joints, drivers, springs,
    /// dampers and gas, N. By the balance of the whole it is that of the forces from outside, the weights and the
    /// inertia forces, `Σ F + Σ m (g − a)`. R. L. Norton, *Design of Machinery*, 5th ed. (2012), ch. 11.
    pub fn shaking_force(&self, state: &PlanarState) -> [f64; 2] {
        let poses = poses(&state.positions);
        let [gx, gy] = self.mechanism.gravity;
        let inertia = self.mechanism.bodies.iter().zip(&state.accelerations);
        let of_masses = inertia.map(|(body, [x, y, _])| [body.mass * (gx - x), body.mass * (gy - y)]);
        let outside = self.mechanism.loads.iter().filter_map(|load| match load {
            PlanarLoad::Force { at, force, turns_with } if at.on.is_some() => {
                Some(turns_with.map_or(*force, |body| poses[body].turned(*force)))
            }
            _ => None,
        });
        of_masses.chain(outside).fold([0.0; 2], |sum, force| [sum[0] + force[0], sum[1] + force[1]])
    }
}
