//! Inverse dynamics of a mechanism: driving forces by virtual power, checked by the Newton–Euler equations.

use super::{
    BodyFrame, Gradient, Model, PlanarBody, PlanarError, PlanarLoad, PlanarMechanism, PlanarState, Pose,
    RelativeCoordinate,
    friction::{FrictionLaw, FrictionResponse, Frictionless, ResponseToForce},
    load::wrench,
    measure::{gradient, poses, rate},
};
use dalembert_numerics::{linalg::Elimination, simd::SimdReal};

/// A load with its forces and moments `[F_x, F_y, M]` on bodies, N and N m.
type AppliedLoad = (LoadId, Vec<(usize, [f64; 3])>);

/// The solution of the inverse dynamics of a driven mechanism.
#[derive(Debug, Clone, PartialEq)]
pub struct InverseDynamics {
    /// The effort of each driver by virtual power, N or N m: positive when it pushes its measure to grow.
    pub efforts: Vec<f64>,
    /// The same by Newton and Euler.
    pub newton_euler: Vec<f64>,
    /// The multiplier of each equation, in the order of [`Model::equations`]: the effort that a joint or driver
    /// exerts along its measure.
    pub multipliers: Vec<f64>,
    /// The velocity coefficients `∂q/∂m` for each driver: the velocities `(x, y, θ)` of the bodies at unit velocity of
    /// the driver, the others held.
    pub coefficients: Vec<Vec<[f64; 3]>>,
    /// The power of every load, weight and inertia load.
    pub powers: Vec<LoadPower>,
    /// Kinetic energy, J.
    pub kinetic_energy: f64,
    /// The rate of the kinetic energy, `Σ (m a · v + I α ω)`, W.
    pub energy_rate: f64,
}

/// The part of a load in the balance of virtual power.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadPower {
    /// The load.
    pub of: LoadId,
    /// The virtual power for a unit velocity of each driver.
    pub generalised: Vec<f64>,
    /// The power, W.
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

impl Model {
    /// The efforts of the drivers, the reactions of the joints and the power of every load.
    ///
    /// # Errors
    /// `UnderDriven`, `OverDriven`, `DeadCentre`, `Jammed`, `NotFinite`.
    pub fn inverse_dynamics(&self, state: &PlanarState) -> Result<InverseDynamics, PlanarError> {
        self.balanced(&self.factored(&state.positions)?, state)
    }

    /// Velocities, accelerations and efforts in one, from one elimination: [`kinematics`](Model::kinematics) and
    /// [`inverse_dynamics`](Model::inverse_dynamics).
    ///
    /// # Errors
    /// As for [`inverse_dynamics`](Model::inverse_dynamics).
    pub fn kinetostatics(
        &self,
        positions: &[[f64; 3]],
    ) -> Result<(PlanarState, InverseDynamics), PlanarError> {
        let elimination = self.factored(positions)?;
        let state = self.driven_motion(&elimination, positions)?;
        let dynamics = self.balanced(&elimination, &state)?;
        Ok((state, dynamics))
    }

    /// The inverse dynamics with the Jacobian eliminated in the positions of the state.
    fn balanced(
        &self,
        elimination: &Elimination,
        state: &PlanarState,
    ) -> Result<InverseDynamics, PlanarError> {
        let coefficients = self.velocity_coefficients(elimination)?;
        let mut acting = self.acting(state);
        let loads = forces(state.positions.len(), &acting);
        let scaled =
            loads.iter().flat_map(|[x, y, moment]| [*x, *y, moment / self.length]).collect::<Vec<_>>();
        let (multipliers, frictions) = self.multipliers(elimination, state, &scaled)?;
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
        Ok(InverseDynamics {
            efforts,
            newton_euler: multipliers[self.first_driver()..].to_vec(),
            multipliers,
            coefficients,
            powers,
            kinetic_energy,
            energy_rate,
        })
    }

    /// Kinetic energy, J, and its rate, W.
    pub fn energy(&self, state: &PlanarState) -> (f64, f64) {
        let of_body = |((body, v), a): ((&PlanarBody, &[f64; 3]), &[f64; 3])| {
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
        loads.iter().try_fold(self.gravitational(&poses), |sum, load| Some(sum + stored(load, &poses)?))
    }

    /// The potential energy of the weights and of those loads that have one, J, from an arbitrary level.
    pub(super) fn stored(&self, poses: &[Pose<f64>]) -> f64 {
        let loads = self.mechanism.loads.iter().filter_map(|load| stored(load, poses));
        self.gravitational(poses) + loads.sum::<f64>()
    }

    /// The potential energy of the weights, J.
    fn gravitational(&self, poses: &[Pose<f64>]) -> f64 {
        let [gx, gy] = self.mechanism.gravity;
        let bodies = self.mechanism.bodies.iter().zip(poses);
        bodies.map(|(body, at)| -body.mass * (gx * at.x + gy * at.y)).sum()
    }

    /// Every load but friction, every weight and every inertia load.
    fn acting(&self, state: &PlanarState) -> Vec<AppliedLoad> {
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
    pub(super) fn applied(&self, positions: &[[f64; 3]], velocities: &[[f64; 3]]) -> Vec<AppliedLoad> {
        let poses = poses(positions);
        let PlanarMechanism { bodies, loads, gravity: [gx, gy], .. } = &self.mechanism;
        let mut acting = Vec::new();
        for (index, load) in loads.iter().enumerate() {
            let parts = match load {
                PlanarLoad::Force { at, force, turns_with } => {
                    let force = turns_with.map_or(*force, |body| poses[body].turned(*force));
                    at.on.map(|body| (body, wrench(&poses[body], at.at, force))).into_iter().collect()
                }
                PlanarLoad::Effort { measure, effort } => {
                    let gradient = gradient(measure, &poses);
                    let rate = rate(measure, &gradient, velocities);
                    along(measure, &gradient, effort.at(gradient.value, rate))
                }
                PlanarLoad::Friction { .. } => continue,
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

    /// The forces and moments `[F_x, F_y, M]` of loads but friction and of weights on every body, and the power of
    /// those loads that have no potential, W. The velocities are those of the bodies and, last, of the ground.
    #[inline(always)]
    pub(super) fn forces<S: SimdReal>(
        &self,
        poses: &[Pose<S>],
        velocities: &[[S; 3]],
        forces: &mut [[S; 3]],
    ) -> S {
        let PlanarMechanism { bodies, loads, gravity: [gx, gy], .. } = &self.mechanism;
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
                PlanarLoad::Force { at, force, turns_with } => {
                    let turned = match *turns_with {
                        Some(body) => poses[body].turned(*force),
                        None => [S::from(force[0]), S::from(force[1])],
                    };
                    if let Some(body) = at.on {
                        apply(body, wrench(&poses[body], at.at, turned), turns_with.is_none());
                    }
                }
                PlanarLoad::Effort { measure, effort } => {
                    let gradient = gradient(measure, poses);
                    let rate = rate(measure, &gradient, velocities);
                    let strength = effort.at(gradient.value, rate);
                    for (frame, part) in measure.bodies().into_iter().zip([gradient.from, gradient.to]) {
                        if let Some(body) = frame {
                            let [x, y, moment] = part;
                            apply(body, [x * strength, y * strength, moment * strength], effort.is_stored());
                        }
                    }
                }
                PlanarLoad::Friction { .. } => {}
            }
        }
        power
    }

    /// The multipliers, by equation, under loads on the scaled coordinates, by column, and the frictions in the joints
    /// that slide.
    fn multipliers(
        &self,
        elimination: &Elimination,
        state: &PlanarState,
        loads: &[f64],
    ) -> Result<(Vec<f64>, Vec<AppliedLoad>), PlanarError> {
        let under = |loads: &[f64]| -> Result<ResponseToForce, PlanarError> {
            let balance: Vec<f64> = loads.iter().map(|load| -load).collect();
            let multipliers = elimination.solve_transposed(&balance)?;
            let accelerations = vec![0.0; loads.len()];
            Ok(ResponseToForce { independent: Vec::new(), accelerations, multipliers })
        };
        let response = under(loads)?;
        let frictions = self.frictions();
        if frictions.is_empty() {
            return Ok((response.multipliers, Vec::new()));
        }
        let poses = poses(&state.positions);
        let frictionless =
            Frictionless { model: self, poses: &poses, velocities: &state.velocities, basis: &[], response };
        let response = FrictionResponse::new(&frictions, frictionless, under)?;
        let efforts = response.bearing(&mut response.contacts(0.0)).ok_or_else(|| response.jammed())?;
        let on_bodies = |(friction, effort): (&FrictionLaw, &f64)| {
            let gradient = gradient(&friction.measure, &poses);
            (
                LoadId::Load(friction.load),
                along(&friction.measure, &gradient, effort * self.length_of(&friction.measure)),
            )
        };
        let acting = frictions.iter().zip(&efforts).map(on_bodies).collect();
        Ok((response.total(&efforts).multipliers, acting))
    }
}

/// The energy stored in a load, if it stores any.
fn stored(load: &PlanarLoad, poses: &[Pose<f64>]) -> Option<f64> {
    match load {
        PlanarLoad::Force { at, force, turns_with: None } => {
            let [x, y] = at.on.map_or(at.at, |body| poses[body].point(at.at));
            Some(-(force[0] * x + force[1] * y))
        }
        PlanarLoad::Effort { measure, effort } => effort.energy(gradient(measure, poses).value),
        PlanarLoad::Force { .. } | PlanarLoad::Friction { .. } => None,
    }
}

/// An effort along a measure as forces and moments on its bodies.
fn along(measure: &RelativeCoordinate, gradient: &Gradient<f64>, effort: f64) -> Vec<(usize, [f64; 3])> {
    let part = |frame: BodyFrame, gradient: [f64; 3]| frame.map(|body| (body, gradient.map(|x| x * effort)));
    let [from, to] = measure.bodies();
    [part(from, gradient.from), part(to, gradient.to)].into_iter().flatten().collect()
}

/// The sums of the forces and moments on each body.
fn forces(bodies: usize, acting: &[AppliedLoad]) -> Vec<[f64; 3]> {
    let mut sums = vec![[0.0; 3]; bodies];
    for (body, force) in acting.iter().flat_map(|(_, parts)| parts) {
        for (sum, part) in sums[*body].iter_mut().zip(force) {
            *sum += part;
        }
    }
    sums
}

/// The power of forces and moments on bodies in a virtual motion, `(x, y, θ)` of each body.
pub(super) fn virtual_power(parts: &[(usize, [f64; 3])], motion: &[[f64; 3]]) -> f64 {
    parts.iter().map(|(body, force)| force.iter().zip(motion[*body]).map(|(f, v)| f * v).sum::<f64>()).sum()
}
