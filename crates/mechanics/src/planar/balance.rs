//! Inverse dynamics of a mechanism: driving forces by virtual power, checked by the Newton–Euler equations.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use super::{
    Frame, Load, Measure, Mechanism, PlanarError, Pose, State, System,
    friction::{Effect, Friction, Frictionless, Response},
    load::wrench,
    system::{gradient, poses, project},
};
use dalembert_numerics::{linalg::Elimination, simd::SimdReal};

/// Load or joint with its forces and moments `[F_x, F_y, M]` on the bodies.
type Act = (LoadId, Vec<(usize, [f64; 3])>);

/// The efforts on a moving mechanism.
#[derive(Debug, Clone, PartialEq)]
pub struct Dynamics {
    /// The effort of each driver by virtual power, N or N m: positive when it pushes its measure to grow.
    pub efforts: Vec<f64>,
    /// The same by Newton and Euler.
    pub newton_euler: Vec<f64>,
    /// The multiplier of each equation, in the order of [`System::equations`]: the effort that a joint or driver
    /// exerts along its measure.
    pub multipliers: Vec<f64>,
    /// `∂q/∂m` for each driver: how every body moves with a unit velocity of the driver and the others held.
    pub coefficients: Vec<Vec<[f64; 3]>>,
    /// The power of every load, weight and inertia load.
    pub powers: Vec<LoadPower>,
    /// Kinetic energy, J.
    pub kinetic_energy: f64,
    /// Rate of the kinetic energy, `Σ (m a · v + I α ω)`, W.
    pub energy_rate: f64,
}

/// The part that a load has in the balance of virtual power.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadPower {
    /// Identifier of the load.
    pub of: LoadId,
    /// Generalised forces: virtual power for a unit velocity of each driver.
    pub generalised: Vec<f64>,
    /// Power, W.
    pub power: f64,
}

/// Something that has power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadId {
    /// A load, counted from 0.
    Load(usize),
    /// The weight of a body.
    Weight(usize),
    /// The inertia force of a body, `−m a`.
    InertiaForce(usize),
    /// The inertia couple of a body, `−I α`.
    InertiaCouple(usize),
}

impl System {
    /// The efforts of the drivers, the reactions of the joints and the power of every load.
    ///
    /// # Errors
    /// `UnderDriven`, `OverDriven`, `DeadCentre`, `Jammed`, `NotFinite`.
    pub fn dynamics(&self, state: &State) -> Result<Dynamics, PlanarError> {
        self.balanced(&self.factored(&state.positions)?, state)
    }

    pub(super) fn balanced(&self, elimination: &Elimination, state: &State) -> Result<Dynamics, PlanarError> {
        let coefficients = self.coefficients(elimination)?;
        let mut acting = self.acting(state);
        let loads = forces(state.positions.len(), &acting);
        let scaled =
            loads.iter().flat_map(|[x, y, moment]| [*x, *y, moment / self.length]).collect::<Vec<_>>();
        let (multipliers, frictions) = self.in_friction(elimination, state, &scaled)?;
        acting.extend(frictions);
        acting.sort_by_key(|(of, _)| match *of {
            LoadId::Load(load) => (0, load),
            LoadId::Weight(body) => (1, body),
            LoadId::InertiaForce(body) => (2, body),
            LoadId::InertiaCouple(body) => (3, body),
        });
        let powers: Vec<LoadPower> = acting
            .iter()
            .map(|(of, parts)| LoadPower {
                of: *of,
                generalised: coefficients.iter().map(|motion| virtual_power(parts, motion)).collect(),
                power: virtual_power(parts, &state.velocities),
            })
            .collect();
        let efforts = (0..coefficients.len())
            .map(|driver| -powers.iter().map(|load| load.generalised[driver]).sum::<f64>())
            .collect();
        let (kinetic_energy, energy_rate) = self.energy(state);
        Ok(Dynamics {
            efforts,
            newton_euler: multipliers[self.first_driver()..].to_vec(),
            multipliers,
            coefficients,
            powers,
            kinetic_energy,
            energy_rate,
        })
    }

    /// Kinetic energy and its rate.
    pub fn energy(&self, state: &State) -> (f64, f64) {
        let of_body = |((body, v), a): ((&super::Body, &[f64; 3]), &[f64; 3])| {
            let energy = body.mass * (v[0] * v[0] + v[1] * v[1]) + body.inertia * v[2] * v[2];
            let rate = body.mass * (v[0] * a[0] + v[1] * a[1]) + body.inertia * v[2] * a[2];
            (energy / 2.0, rate)
        };
        let bodies = self.mechanism.bodies.iter().zip(&state.velocities).zip(&state.accelerations);
        bodies.map(of_body).fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1))
    }

    /// The potential energy of weights, springs and constant efforts and forces, J, from an arbitrary level; none if
    /// a load has none.
    pub fn potential(&self, positions: &[[f64; 3]]) -> Option<f64> {
        let poses = poses(positions);
        let loads = &self.mechanism.loads;
        loads.iter().try_fold(self.height(&poses), |sum, load| Some(sum + stored(load, &poses)?))
    }

    /// The potential energy of the weights and of those loads that have one, J, from an arbitrary level.
    pub(super) fn stored(&self, poses: &[Pose<f64>]) -> f64 {
        let loads = self.mechanism.loads.iter().filter_map(|load| stored(load, poses));
        self.height(poses) + loads.sum::<f64>()
    }

    /// The potential energy of the weights.
    fn height(&self, poses: &[Pose<f64>]) -> f64 {
        let [gx, gy] = self.mechanism.gravity;
        let bodies = self.mechanism.bodies.iter().zip(poses);
        bodies.map(|(body, at)| -body.mass * (gx * at.x + gy * at.y)).sum()
    }

    /// Every load but friction, weight and inertia load, with the forces and moments on the bodies.
    pub(super) fn acting(&self, state: &State) -> Vec<Act> {
        let mut acting = self.applied(&state.positions, &state.velocities);
        for (index, (body, [x, y, angular])) in
            self.mechanism.bodies.iter().zip(&state.accelerations).enumerate()
        {
            if body.mass > 0.0 {
                let force = [-body.mass * x, -body.mass * y, 0.0];
                acting.push((LoadId::InertiaForce(index), vec![(index, force)]));
            }
            if body.inertia > 0.0 {
                let couple = [0.0, 0.0, -body.inertia * angular];
                acting.push((LoadId::InertiaCouple(index), vec![(index, couple)]));
            }
        }
        acting
    }

    /// The loads but friction, and the weights.
    pub(super) fn applied(&self, positions: &[[f64; 3]], velocities: &[[f64; 3]]) -> Vec<Act> {
        let poses = poses(positions);
        let Mechanism { bodies, loads, gravity: [gx, gy], .. } = &self.mechanism;
        let mut acting = Vec::new();
        for (index, load) in loads.iter().enumerate() {
            let parts = match load {
                Load::Force { at, force, turns_with } => {
                    let force = turns_with.map_or(*force, |body| poses[body].turned(*force));
                    at.on.map(|body| (body, wrench(&poses[body], at.at, force))).into_iter().collect()
                }
                Load::Effort { measure, effort } => {
                    let gradient = gradient(measure, &poses);
                    let rate = project(measure, &gradient, velocities);
                    along(measure, &gradient, effort.at(gradient.value, rate))
                }
                Load::Friction { .. } => continue,
            };
            acting.push((LoadId::Load(index), parts));
        }
        if [*gx, *gy] != [0.0, 0.0] {
            for (index, body) in bodies.iter().enumerate().filter(|(_, body)| body.mass > 0.0) {
                let weight = [body.mass * gx, body.mass * gy, 0.0];
                acting.push((LoadId::Weight(index), vec![(index, weight)]));
            }
        }
        acting
    }

    /// The forces and moments of loads and weights on every body, and the power of those loads that have no potential.
    #[inline(always)]
    pub(super) fn forces<S: SimdReal>(
        &self,
        poses: &[Pose<S>],
        velocities: &[[S; 3]],
        forces: &mut [[S; 3]],
    ) -> S {
        let Mechanism { bodies, loads, gravity: [gx, gy], .. } = &self.mechanism;
        for (force, body) in forces.iter_mut().zip(bodies) {
            *force = [S::from(body.mass * gx), S::from(body.mass * gy), S::from(0.0)];
        }
        let mut power = S::from(0.0);
        let mut apply = |body: usize, part: [S; 3], stored: bool| {
            for (sum, part) in forces[body].iter_mut().zip(part) {
                *sum = *sum + part;
            }
            if !stored {
                let [vx, vy, w] = velocities[body];
                power = power + part[0] * vx + part[1] * vy + part[2] * w;
            }
        };
        for load in loads {
            match load {
                Load::Force { at, force, turns_with } => {
                    let turned = match *turns_with {
                        Some(body) => poses[body].turned(*force),
                        None => [S::from(force[0]), S::from(force[1])],
                    };
                    if let Some(body) = at.on {
                        apply(body, wrench(&poses[body], at.at, turned), turns_with.is_none());
                    }
                }
                Load::Effort { measure, effort } => {
                    let gradient = gradient(measure, poses);
                    let rate = project(measure, &gradient, velocities);
                    let strength = effort.at(gradient.value, rate);
                    for (frame, part) in measure.bodies().into_iter().zip([gradient.from, gradient.to]) {
                        if let Some(body) = frame {
                            let [x, y, moment] = part;
                            apply(body, [x * strength, y * strength, moment * strength], effort.is_stored());
                        }
                    }
                }
                Load::Friction { .. } => {}
            }
        }
        power
    }

    /// The multipliers under loads on the scaled positions, with the frictions that they give rise to in the joints that
    /// slide.
    fn in_friction(
        &self,
        elimination: &Elimination,
        state: &State,
        loads: &[f64],
    ) -> Result<(Vec<f64>, Vec<Act>), PlanarError> {
        let under = |loads: &[f64]| -> Result<Effect, PlanarError> {
            let balance: Vec<f64> = loads.iter().map(|load| -load).collect();
            let multipliers = elimination.solve_transposed(&balance)?;
            Ok(Effect { free: Vec::new(), accelerations: vec![0.0; loads.len()], multipliers })
        };
        let effect = under(loads)?;
        let frictions = self.frictions();
        if frictions.is_empty() {
            return Ok((effect.multipliers, Vec::new()));
        }
        let poses = poses(&state.positions);
        let frictionless =
            Frictionless { system: self, poses: &poses, velocities: &state.velocities, motions: &[], effect };
        let response = Response::new(&frictions, frictionless, under)?;
        let efforts = response.bearing(&mut response.contacts(0.0)).ok_or_else(|| response.jammed())?;
        let on_bodies = |(friction, effort): (&Friction, &f64)| {
            let gradient = gradient(&friction.measure, &poses);
            (LoadId::Load(friction.load), along(&friction.measure, &gradient, effort * self.arm(friction)))
        };
        let acting = frictions.iter().zip(&efforts).map(on_bodies).collect();
        Ok((response.effect(&efforts).multipliers, acting))
    }
}

/// The energy stored in a load, if it stores any.
fn stored(load: &Load, poses: &[Pose<f64>]) -> Option<f64> {
    match load {
        Load::Force { at, force, turns_with: None } => {
            let [x, y] = at.on.map_or(at.at, |body| poses[body].point(at.at));
            Some(-(force[0] * x + force[1] * y))
        }
        Load::Effort { measure, effort } => effort.energy(gradient(measure, poses).value),
        Load::Force { .. } | Load::Friction { .. } => None,
    }
}

/// An effort along a measure as forces and moments on its bodies.
fn along(measure: &Measure, gradient: &super::Gradient<f64>, effort: f64) -> Vec<(usize, [f64; 3])> {
    let part = |frame: Frame, gradient: [f64; 3]| frame.map(|body| (body, gradient.map(|x| x * effort)));
    let [from, to] = measure.bodies();
    [part(from, gradient.from), part(to, gradient.to)].into_iter().flatten().collect()
}

fn forces(bodies: usize, acting: &[Act]) -> Vec<[f64; 3]> {
    let mut sums = vec![[0.0; 3]; bodies];
    for (body, force) in acting.iter().flat_map(|(_, parts)| parts) {
        add(&mut sums[*body], *force);
    }
    sums
}

fn add(sum: &mut [f64; 3], part: [f64; 3]) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += part;
    }
}

pub(super) fn virtual_power(parts: &[(usize, [f64; 3])], motion: &[[f64; 3]]) -> f64 {
    parts.iter().map(|(body, force)| force.iter().zip(motion[*body]).map(|(f, v)| f * v).sum::<f64>()).sum()
}
