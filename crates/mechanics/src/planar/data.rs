//! Working data of the motion of a [`Model`]: positions, factors, velocities, accelerations and multipliers of one
//! moment.
//!
//! The order of the computation is in the types: [`Data::position`] gives a [`Positioned`], this a [`Factored`], this a
//! [`Moving`], this an [`Accelerated`], and each has the results that are valid there. A position that was evaluated or
//! factored last is not computed again.
//!
//! The state of the motion are the tree coordinates of the [`Layout`](super::layout::EquationLayout), m, and the independent
//! velocities, m/s, in the columns that the selected [`PivotOrder`] leaves without a pivot. With a basis N of the null
//! space of `Φ_q` (one vector of 3n scaled velocities for each independent one), `q̇ = q̇₀ + N ṡ` and `q̈ = q̈₀ + N
//! s̈`, the equations of motion are `(Nᵀ M N) s̈ = Nᵀ (Q − M q̈₀)`; the multipliers follow from `Φ_qᵀ λ = M q̈ − Q` (E.
//! J. Haug, *Computer-Aided Kinematics and Dynamics of Mechanical Systems* (1989), §6.3 and §7.2).

use super::{
    Contact, Driver, Model, PlanarError, PlanarState, Pose, RelativeCoordinate,
    elimination::{Conditioning, LuFactors, PivotOrder},
    friction::{FrictionLaw, FrictionResponse, Frictionless, ResponseToForce},
    layout::Position,
    measure::{gradient, rate},
    tolerances::{MASSLESS_PIVOT, MAX_ORDERS},
    vectors::dot,
};

/// The numbers of one moment of a motion. Vectors are scaled, by the columns or rows of the model.
pub(super) struct Data<'m> {
    model: &'m Model,
    /// Time, s.
    time: f64,
    position: Position,
    /// The tree coordinates for which the position was evaluated.
    tree: Vec<f64>,
    /// True if it was, with the present values of the drivers.
    is_evaluated: bool,
    /// The orders of pivots that have served so far.
    orders: Vec<(PivotOrder, LuFactors)>,
    /// The one that serves now.
    selected: usize,
    /// True if its factors are those of the position.
    is_factored: bool,
    /// The worst of the factors since [`take_quality`](Data::take_quality).
    quality: Quality,
    /// Velocities `(x, y, θ)` of the bodies and, last, of the ground.
    velocities: Vec<[f64; 3]>,
    /// Forces and moments of weights and loads on the bodies, N and N m.
    forces: Vec<[f64; 3]>,
    /// A right-hand side, by rows.
    rhs: Vec<f64>,
    /// Velocities, m/s, then forces, N, by columns.
    scaled: Vec<f64>,
    /// The null-space basis N.
    basis: Vec<Vec<f64>>,
    /// The Cholesky factor of `Nᵀ M N`, by rows, lower triangle.
    reduced_mass: Vec<f64>,
    /// The response to weights, loads and friction.
    response: ResponseToForce,
    /// True if multipliers are needed, for the work of drivers or for friction.
    needs_multipliers: bool,
}

/// The quality of factors.
#[derive(Clone, Copy)]
pub(super) struct Quality {
    pub(super) conditioning: Conditioning,
    /// The smallest ratio of a pivot to its value when it was selected.
    pub(super) smallest_pivot: f64,
}

impl Quality {
    const BEST: Self = Self { conditioning: Conditioning::Regular, smallest_pivot: 1.0 };
}

/// Working data with a position: poses, residuals and Jacobian.
pub(super) struct Positioned<'d, 'm>(&'d mut Data<'m>);

/// The same with the Jacobian eliminated.
pub(super) struct Factored<'d, 'm>(&'d mut Data<'m>);

/// The same with velocities.
pub(super) struct Moving<'d, 'm>(&'d mut Data<'m>);

/// The same with accelerations and multipliers.
pub(super) struct Accelerated<'d, 'm> {
    data: &'d mut Data<'m>,
    /// The power of the drivers, of friction and of the loads without potential, W.
    pub(super) power: f64,
}

impl<'m> Data<'m> {
    /// Data for a model in closed positions, with an order of pivots selected there.
    pub(super) fn new(model: &'m Model, positions: &[[f64; 3]]) -> Self {
        let (bodies, rows) = (positions.len(), model.equations.len());
        let mut data = Self {
            model,
            time: 0.0,
            position: model.layout.position(&model.equations),
            tree: Vec::new(),
            is_evaluated: false,
            orders: Vec::new(),
            selected: 0,
            is_factored: false,
            quality: Quality::BEST,
            velocities: vec![[0.0; 3]; bodies + 1],
            forces: vec![[0.0; 3]; bodies],
            rhs: vec![0.0; rows],
            scaled: vec![0.0; 3 * bodies],
            basis: Vec::new(),
            reduced_mass: Vec::new(),
            response: ResponseToForce {
                independent: Vec::new(),
                accelerations: vec![0.0; 3 * bodies],
                multipliers: vec![0.0; rows],
            },
            needs_multipliers: !model.mechanism.drivers.is_empty() || model.has_friction(),
        };
        data.position(0.0, &model.tree_coordinates(positions)).select_order();
        data
    }

    /// Positions, residuals and Jacobian at a time, s, for tree coordinates, m.
    pub(super) fn position(&mut self, time: f64, tree: &[f64]) -> Positioned<'_, 'm> {
        let model = self.model;
        self.time = time;
        let driven = &mut self.position.constants[model.first_driver()..];
        for (constant, driver) in driven.iter_mut().zip(&model.mechanism.drivers) {
            let value = driver.value + time * (driver.velocity + time * driver.acceleration / 2.0);
            if *constant != value {
                *constant = value;
                self.is_evaluated = false;
            }
        }
        if !self.is_evaluated || self.tree != tree {
            model.layout.evaluate(tree, &mut self.position);
            self.tree.clear();
            self.tree.extend_from_slice(tree);
            (self.is_evaluated, self.is_factored) = (true, false);
        }
        Positioned(self)
    }

    /// The columns of the independent velocities.
    pub(super) fn independent(&self) -> &[usize] {
        &self.orders[self.selected].0.independent
    }

    /// The null-space basis of the velocities that were computed last.
    pub(super) fn basis(&self) -> &[Vec<f64>] {
        &self.basis
    }

    /// The quality of the factors since it was last taken.
    pub(super) fn take_quality(&mut self) -> Quality {
        std::mem::replace(&mut self.quality, Quality::BEST)
    }

    fn select(&mut self, index: usize) {
        self.selected = index;
        self.is_factored = false;
        let n = self.independent().len();
        self.basis.resize_with(n, Vec::new);
        for motion in &mut self.basis {
            motion.resize(self.model.masses.len(), 0.0);
        }
        self.reduced_mass.resize(n * n, 0.0);
        self.response.independent.resize(n, 0.0);
    }
}

impl<'d, 'm> Positioned<'d, 'm> {
    /// The largest residual of the loop equations, m.
    pub(super) fn residual(&self) -> f64 {
        self.0.model.layout.largest_residual(&self.0.position)
    }

    /// Selects a remembered order of pivots that suits the position, or a new one.
    pub(super) fn select_order(self) {
        let data = self.0;
        let model = data.model;
        let layout = &model.layout;
        let jacobian = &data.position.jacobian;
        for index in 0..data.orders.len() {
            let (order, factors) = &mut data.orders[index];
            order.eliminate(jacobian, factors);
            if !order.is_weak(layout, jacobian, factors) {
                data.select(index);
                return;
            }
        }
        let order = PivotOrder::new(layout, jacobian, model.masses.len());
        let factors = order.factors();
        if data.orders.len() == MAX_ORDERS {
            data.orders.remove(0);
        }
        data.orders.push((order, factors));
        data.select(data.orders.len() - 1);
    }

    /// Eliminates the Jacobian.
    pub(super) fn factored(self) -> Factored<'d, 'm> {
        let data = self.0;
        if !data.is_factored {
            let (order, factors) = &mut data.orders[data.selected];
            order.eliminate(&data.position.jacobian, factors);
            data.is_factored = true;
            let Quality { conditioning, smallest_pivot } = &mut data.quality;
            *conditioning = (*conditioning).max(order.conditioning(factors));
            *smallest_pivot = smallest_pivot.min(order.smallest_pivot(factors));
        }
        Factored(data)
    }
}

impl<'d, 'm> Factored<'d, 'm> {
    fn order(&self) -> (&PivotOrder, &LuFactors) {
        let (order, factors) = &self.0.orders[self.0.selected];
        (order, factors)
    }

    /// The conditioning of the position in the selected order.
    pub(super) fn conditioning(&self) -> Conditioning {
        let (order, factors) = self.order();
        order.conditioning(factors)
    }

    /// The smallest ratio of a pivot to its value when it was selected.
    pub(super) fn smallest_pivot(&self) -> f64 {
        let (order, factors) = self.order();
        order.smallest_pivot(factors)
    }

    /// Reports whether another order of pivots should be selected.
    pub(super) fn is_weak(&self) -> bool {
        let (order, factors) = self.order();
        order.is_weak(&self.0.model.layout, &self.0.position.jacobian, factors)
    }

    /// Reports whether a pivot is so small that a singular position may be near.
    pub(super) fn is_falling(&self) -> bool {
        let (order, factors) = self.order();
        order.is_falling(factors)
    }

    /// The reduced rows of the loop equations ([`PivotOrder::reduced_rows`]).
    pub(super) fn reduced_rows(&self) -> Vec<f64> {
        let (order, factors) = self.order();
        order.reduced_rows(factors)
    }

    /// The number of steps, behind and ahead, to a singular position, from the reduced rows one step before.
    pub(super) fn steps_to_singularity(&self, before: &[f64]) -> [f64; 2] {
        self.order().0.steps_to_singularity(before, &self.reduced_rows())
    }

    /// The correction of the tree coordinates by Newton's method, m: to be subtracted.
    pub(super) fn correction(self) -> impl Iterator<Item = f64> + use<'d, 'm> {
        let data = self.0;
        let model = data.model;
        data.rhs.fill(0.0);
        for &row in &model.layout.loops {
            data.rhs[row] = data.position.residuals[row];
        }
        let (order, factors) = &data.orders[data.selected];
        order.solve(factors, &mut data.rhs, &mut data.scaled);
        let scaled = &data.scaled;
        model.layout.tree.iter().map(|&column| scaled[column])
    }

    /// The velocities of all bodies from the independent ones, m/s, and the null-space basis.
    pub(super) fn velocities(self, independent: &[f64]) -> Moving<'d, 'm> {
        let data = self.0;
        let model = data.model;
        let (order, factors) = &data.orders[data.selected];
        let drivers = &model.mechanism.drivers;
        if drivers.is_empty() {
            data.scaled.fill(0.0);
        } else {
            data.rhs.fill(0.0);
            for (rhs, driver) in data.rhs[model.first_driver()..].iter_mut().zip(drivers) {
                *rhs = velocity(driver, data.time);
            }
            order.solve(factors, &mut data.rhs, &mut data.scaled);
        }
        for (number, (motion, rate)) in data.basis.iter_mut().zip(independent).enumerate() {
            order.null_vector(factors, number, motion);
            for (v, n) in data.scaled.iter_mut().zip(&*motion) {
                *v += n * rate;
            }
        }
        model.unscale(&data.scaled, &mut data.velocities);
        Moving(data)
    }
}

impl<'d, 'm> Moving<'d, 'm> {
    /// The velocities of the scaled coordinates, m/s, by column.
    pub(super) fn scaled(&self) -> &[f64] {
        &self.0.scaled
    }

    /// The null-space basis.
    pub(super) fn basis(&self) -> &[Vec<f64>] {
        &self.0.basis
    }

    /// The value of a measure and its velocity.
    pub(super) fn measure(&self, measure: &RelativeCoordinate) -> [f64; 2] {
        let gradient = gradient(measure, &self.0.position.poses);
        [gradient.value, rate(measure, &gradient, &self.0.velocities)]
    }

    /// Accelerations and multipliers under the loads without friction; not numbers if an independent motion has no
    /// inertia.
    pub(super) fn accelerations(self) -> Accelerated<'d, 'm> {
        let data = self.0;
        let model = data.model;
        let (order, factors) = &data.orders[data.selected];
        let drivers = &model.mechanism.drivers;
        let ResponseToForce { independent, accelerations, multipliers } = &mut data.response;
        model.layout.quadratic_velocity_terms(&data.position, &data.velocities, &mut data.rhs);
        for (rhs, driver) in data.rhs[model.first_driver()..].iter_mut().zip(drivers) {
            *rhs += driver.acceleration;
        }
        order.solve(factors, &mut data.rhs, accelerations);
        let power = model.forces(&data.position.poses, &data.velocities, &mut data.forces);
        let per_length = 1.0 / model.length;
        for (scaled, force) in data.scaled.chunks_exact_mut(3).zip(&data.forces) {
            scaled.copy_from_slice(&[force[0], force[1], force[2] * per_length]);
        }
        let n = data.basis.len();
        for row in 0..n {
            let motion = &data.basis[row];
            let mut force = 0.0;
            for (((n, load), mass), a) in
                motion.iter().zip(&data.scaled).zip(&model.masses).zip(&*accelerations)
            {
                force += n * (load - mass * a);
            }
            independent[row] = force;
            for column in 0..=row {
                let mut sum = 0.0;
                for ((a, b), mass) in motion.iter().zip(&data.basis[column]).zip(&model.masses) {
                    sum += a * b * mass;
                }
                data.reduced_mass[row * n + column] = sum;
            }
        }
        if factor_positive(&mut data.reduced_mass, n) {
            substitute(&data.reduced_mass, independent);
        } else {
            independent.fill(f64::NAN);
        }
        for (motion, s) in data.basis.iter().zip(&*independent) {
            for (a, n) in accelerations.iter_mut().zip(motion) {
                *a += n * s;
            }
        }
        if data.needs_multipliers {
            for ((g, a), mass) in data.scaled.iter_mut().zip(&*accelerations).zip(&model.masses) {
                *g = mass * a - *g;
            }
            order.solve_transposed(factors, &mut data.scaled, multipliers);
        }
        Accelerated { data, power }
    }
}

impl Accelerated<'_, '_> {
    /// The accelerations in the columns of the independent velocities, m/s².
    pub(super) fn independent(&self) -> &[f64] {
        &self.data.response.independent
    }

    /// The power of the drivers, W, by the multipliers.
    pub(super) fn driver_power(&self) -> f64 {
        let drivers = &self.data.model.mechanism.drivers;
        let efforts = &self.data.response.multipliers[self.data.model.first_driver()..];
        let power = |(effort, driver): (&f64, &Driver)| effort * velocity(driver, self.data.time);
        efforts.iter().zip(drivers).map(power).sum()
    }

    /// Positions, velocities and accelerations of the bodies.
    pub(super) fn state(&self) -> PlanarState {
        let bodies = self.data.forces.len();
        let of_pose = |pose: &Pose<f64>| [pose.x, pose.y, pose.angle];
        PlanarState {
            positions: self.data.position.poses[..bodies].iter().map(of_pose).collect(),
            velocities: self.data.velocities[..bodies].to_vec(),
            accelerations: self.data.model.unscaled(&self.data.response.accelerations),
        }
    }

    /// The kinetic energy and the energy stored in weights and loads, J.
    pub(super) fn energies(&self) -> [f64; 2] {
        let length = self.data.model.length;
        let of_body = |(masses, v): (&[f64], &[f64; 3])| {
            let turn = v[2] * length;
            0.5 * (masses[0] * (v[0] * v[0] + v[1] * v[1]) + masses[2] * turn * turn)
        };
        let kinetic = self.data.model.masses.chunks_exact(3).zip(&self.data.velocities).map(of_body).sum();
        [kinetic, self.data.model.stored(&self.data.position.poses)]
    }

    /// The response of the joints to friction, from these accelerations without it.
    pub(super) fn friction_response<'f>(&self, frictions: &'f [FrictionLaw]) -> FrictionResponse<'f> {
        let (model, data) = (self.data.model, &*self.data);
        let (order, factors) = &data.orders[data.selected];
        let frictionless = Frictionless {
            model,
            poses: &data.position.poses,
            velocities: &data.velocities,
            basis: &data.basis,
            response: data.response.clone(),
        };
        FrictionResponse::new(frictions, frictionless, |force| {
            let mut independent: Vec<f64> = data.basis.iter().map(|motion| dot(motion, force)).collect();
            substitute(&data.reduced_mass, &mut independent);
            let mut accelerations = vec![0.0; force.len()];
            for (motion, s) in data.basis.iter().zip(&independent) {
                for (a, n) in accelerations.iter_mut().zip(motion) {
                    *a += n * s;
                }
            }
            let unbalanced = accelerations.iter().zip(&model.masses).zip(force);
            let mut unbalanced: Vec<f64> = unbalanced.map(|((a, mass), force)| mass * a - force).collect();
            let mut multipliers = vec![0.0; data.response.multipliers.len()];
            order.solve_transposed(factors, &mut unbalanced, &mut multipliers);
            Ok(ResponseToForce { independent, accelerations, multipliers })
        })
        .expect("the response to a force is always found")
    }

    /// Adds the Coulomb friction of joints in these contacts to accelerations, multipliers and power. Without a balance
    /// they are not numbers.
    ///
    /// # Errors
    /// `Jammed`.
    pub(super) fn add_friction(
        &mut self,
        frictions: &[FrictionLaw],
        contacts: &[Contact],
    ) -> Result<(), PlanarError> {
        let response = self.friction_response(frictions);
        let Some(efforts) = response.efforts(contacts) else {
            self.data.response.independent.fill(f64::NAN);
            self.power = f64::NAN;
            return Err(response.jammed());
        };
        self.power += response.power(&efforts);
        self.data.response = response.total(&efforts);
        // The joints that stick are independent: where there are as many as independent motions and no driver moves,
        // nothing does. Rounding would let it creep.
        let mut drivers = self.data.model.mechanism.drivers.iter();
        let sticking = contacts.iter().filter(|contact| **contact == Contact::Sticking).count();
        if sticking == self.data.basis.len()
            && drivers.all(|driver| driver.velocity == 0.0 && driver.acceleration == 0.0)
        {
            self.data.response.independent.fill(0.0);
        }
        Ok(())
    }
}

/// The velocity of a driver at a time.
fn velocity(driver: &Driver, time: f64) -> f64 {
    driver.velocity + time * driver.acceleration
}

/// Factors a symmetric positive definite n × n matrix H, given by rows in its lower triangle, in place (Cholesky);
/// false if it is not.
fn factor_positive(h: &mut [f64], n: usize) -> bool {
    for j in 0..n {
        let diagonal = h[j * n + j];
        let mut pivot = diagonal;
        for k in 0..j {
            pivot -= h[j * n + k] * h[j * n + k];
        }
        if pivot.is_nan() || pivot <= MASSLESS_PIVOT * diagonal {
            return false;
        }
        let root = pivot.sqrt();
        h[j * n + j] = root;
        for i in j + 1..n {
            let mut sum = h[i * n + j];
            for k in 0..j {
                sum -= h[i * n + k] * h[j * n + k];
            }
            h[i * n + j] = sum / root;
        }
    }
    true
}

/// Solves `H x = b` with the factors of H, in place.
fn substitute(h: &[f64], x: &mut [f64]) {
    let n = x.len();
    for j in 0..n {
        for k in 0..j {
            x[j] -= h[j * n + k] * x[k];
        }
        x[j] /= h[j * n + j];
    }
    for j in (0..n).rev() {
        for k in j + 1..n {
            x[j] -= h[k * n + j] * x[k];
        }
        x[j] /= h[j * n + j];
    }
}
