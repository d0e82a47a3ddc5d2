//! A compiled mechanism: constraint residuals `Φ(q, t)`, constraint Jacobian `Φ_q`, and the assembly.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

mod check;

use nalgebra::DMatrix;

use self::check::check;

use super::{Dynamics, Equation, Frame, Gradient, Load, Measure, Mechanism, PlanarError, Point, Pose};
use crate::Real;
use dalembert_numerics::{linalg::Elimination, simd::SimdReal};

/// Closure tolerance of a joint, relative to the size of the mechanism.
const CLOSED: f64 = 1e-14;
/// A component of a motion above this part of its largest is no rounding.
const FREE: f64 = 1e-6;
/// Steps of the assembly before it is given up.
const STEPS: usize = 200;

/// Positions, velocities and accelerations of all bodies, each `(x, y, θ)`: m and rad, and per s and s².
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Positions.
    pub positions: Vec<[f64; 3]>,
    /// Velocities.
    pub velocities: Vec<[f64; 3]>,
    /// Accelerations.
    pub accelerations: Vec<[f64; 3]>,
}

/// Poses of the bodies before the mechanism is assembled.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// `(x, y, θ)` of each body.
    pub drawn: Vec<[f64; 3]>,
    /// The bodies whose origin was not given and does not follow from the joints and drivers.
    pub unplaced: Vec<usize>,
    /// The same, but a joint takes what is left from the drawn position: a weight on a cord, whose length nobody gives.
    pub assumed: Vec<usize>,
    /// The bodies whose origin was not given, and which the joints let lie at another place as well with the same angles:
    /// a slider at the end of a rod.
    pub elsewhere: Vec<usize>,
}

/// In how many ways a mechanism can move.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mobility {
    /// `3 n − m`: three for each body less one for each equation of the joints (Grübler, Kutzbach).
    pub counted: i64,
    /// `3 n − rank Φ_q`: how it moves in this position.
    pub free: usize,
    /// The joints with equations that follow from others: their reactions are not determined by statics.
    pub redundant: Vec<usize>,
}

/// A mechanism whose every reference is known to be good.
#[derive(Debug, Clone)]
pub struct System {
    pub(super) mechanism: Mechanism,
    /// Those of the joints, then those of the drivers.
    pub(super) equations: Vec<Equation>,
    /// The joint of each equation; the drivers count on after the joints.
    pub(super) owners: Vec<usize>,
    /// The size of the mechanism, m: what makes angles and lengths comparable.
    pub(super) length: f64,
}

/// The residuals of the constraints in a position, and their Jacobian by the scaled positions
/// `(x, y, θ · length)`.
pub(super) struct Constraints {
    pub(super) residuals: Vec<f64>,
    pub(super) jacobian: DMatrix<f64>,
}

impl System {
    /// Checks a mechanism and writes down its equations. `drawn` is about where its bodies are, `(x, y, θ)` each:
    /// it settles what the joints leave open, on which side a linkage is assembled and how gears mesh.
    ///
    /// # Errors
    /// `Number`, `NoSuchBody`.
    pub fn new(mechanism: &Mechanism, drawn: &[[f64; 3]]) -> Result<Self, PlanarError> {
        check(mechanism, drawn)?;
        let mut equations = Vec::new();
        let mut owners = Vec::new();
        for (owner, joint) in mechanism.joints.iter().enumerate() {
            for equation in joint.equations() {
                equations.push(equation);
                owners.push(owner);
            }
        }
        for (driver, owner) in mechanism.drivers.iter().zip(mechanism.joints.len()..) {
            equations.push(Equation::of(driver.measure, Some(driver.value)));
            owners.push(owner);
        }
        let length = size(mechanism, &equations, drawn);
        let mut system = Self { mechanism: mechanism.clone(), equations, owners, length };
        let poses = poses(drawn);
        for equation in &mut system.equations {
            if equation.sum.is_none() {
                equation.sum = Some(left_side(equation, &poses));
            }
        }
        Ok(system)
    }

    /// About where the bodies are when their angles are known, and the origins of some of them: the origins as the joints
    /// want them while no body turns, by least squares. What a joint takes from the drawn position is left out.
    ///
    /// # Errors
    /// As for [`new`](System::new); `NotFinite`.
    pub fn place(
        mechanism: &Mechanism,
        angles: &[f64],
        origins: &[Option<[f64; 2]>],
    ) -> Result<Placed, PlanarError> {
        // Not all in one place: distances between coinciding points have no direction.
        let apart = |(body, &angle): (usize, &f64)| {
            let turn = 2.4 * (body + 1) as f64;
            [turn.cos(), turn.sin(), angle]
        };
        let spread: Vec<[f64; 3]> = angles.iter().enumerate().map(apart).collect();
        let system = Self::new(mechanism, &spread)?;
        let from = |share: f64| -> Vec<[f64; 3]> {
            let size = share * system.length;
            let given = |body: usize| origins.get(body).copied().flatten();
            let place = |(body, [x, y, angle]): (usize, &[f64; 3])| {
                let [x, y] = given(body).unwrap_or([x * size, y * size]);
                [x, y, *angle]
            };
            spread.iter().enumerate().map(place).collect()
        };
        let wanted: Vec<usize> = {
            let joints = mechanism.joints.iter().flat_map(super::Joint::equations);
            let asked = joints.enumerate().filter(|(_, equation)| equation.sum.is_some());
            asked.map(|(row, _)| row).chain(system.first_driver()..system.equations.len()).collect()
        };
        let columns: Vec<usize> = (0..3 * angles.len()).filter(|column| column % 3 != 2).collect();
        // The places by Gauss and Newton, and what they leave of the residuals.
        let settled = |mut drawn: Vec<[f64; 3]>| -> Result<(Vec<[f64; 3]>, f64), PlanarError> {
            let mut left = f64::INFINITY;
            for _ in 0..20 {
                let (residuals, jacobian) = system.row_scaled(&drawn)?;
                let jacobian = jacobian.select_rows(&wanted).select_columns(&columns);
                let residual =
                    nalgebra::DVector::from_iterator(wanted.len(), wanted.iter().map(|&row| residuals[row]));
                left = residual.norm();
                let mut normal = jacobian.tr_mul(&jacobian);
                for at in 0..normal.nrows() {
                    normal[(at, at)] += 1e-9;
                }
                let step = Elimination::new(&normal)?.solve(jacobian.tr_mul(&residual).as_slice())?;
                for (at, step) in drawn.iter_mut().zip(step.chunks_exact(2)) {
                    (at[0], at[1]) = (at[0] - step[0], at[1] - step[1]);
                }
                if step.iter().all(|step| step.abs() <= 1e-9 * system.length) {
                    break;
                }
            }
            Ok((drawn, left))
        };
        let (drawn, left_here) = settled(from(0.01))?;
        let (_, jacobian) = system.row_scaled(&drawn)?;
        let left = Elimination::new(&jacobian.select_rows(&wanted).select_columns(&columns))?.null_space()?;
        let is_free =
            |body: usize| left.iter().any(|motion| motion[2 * body..][..2].iter().any(|x| x.abs() > FREE));
        let unplaced =
            (0..angles.len()).filter(|&body| is_free(body) && origins.get(body).is_none_or(Option::is_none));
        let is_held = |body: &usize| {
            let mut open =
                mechanism.joints.iter().flat_map(super::Joint::equations).filter(|of| of.sum.is_none());
            open.any(|of| of.terms.iter().any(|term| term.measure.bodies().contains(&Some(*body))))
        };
        let (assumed, unplaced): (Vec<usize>, Vec<usize>) = unplaced.partition(is_held);
        // The same from far away, on either side.
        let mut elsewhere = Vec::new();
        for far in [1.0, -1.0] {
            let (other, left_there) = settled(from(far))?;
            let is_another = left_there <= 2.0 * left_here + 1e-6 * system.length;
            let lies_apart = |body: &usize| {
                let ([x, y, _], [u, v, _]) = (drawn[*body], other[*body]);
                (x - u).hypot(y - v) > 1e-3 * system.length
                    && !unplaced.contains(body)
                    && !assumed.contains(body)
                    && origins.get(*body).is_none_or(Option::is_none)
            };
            elsewhere.extend((0..angles.len()).filter(|body| is_another && lies_apart(body)));
        }
        elsewhere.sort_unstable();
        elsewhere.dedup();
        Ok(Placed { drawn, unplaced, assumed, elsewhere })
    }

    /// The size of the mechanism, m: its longest arm, rod or reach.
    pub fn size(&self) -> f64 {
        self.length
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// The equations: those of the joints in their order, then one for each driver.
    pub fn equations(&self) -> &[Equation] {
        &self.equations
    }

    /// The joint that an equation belongs to; the drivers count on after the joints.
    pub fn owner(&self, equation: usize) -> usize {
        self.owners[equation]
    }

    pub(super) fn first_driver(&self) -> usize {
        self.equations.len() - self.mechanism.drivers.len()
    }

    /// The same mechanism with its drivers at other values.
    pub(super) fn driven_to(&mut self, values: &[f64]) {
        let first = self.first_driver();
        for ((equation, driver), &value) in
            self.equations[first..].iter_mut().zip(&mut self.mechanism.drivers).zip(values)
        {
            equation.sum = Some(value);
            driver.value = value;
        }
    }

    /// The value of a measure.
    pub fn value(&self, measure: &Measure, positions: &[[f64; 3]]) -> f64 {
        gradient(measure, &poses(positions)).value
    }

    /// The velocity of a measure.
    pub fn rate(&self, measure: &Measure, state: &State) -> f64 {
        let gradient = gradient(measure, &poses(&state.positions));
        project(measure, &gradient, &state.velocities)
    }

    /// Position, velocity and acceleration of a point.
    pub fn point(&self, point: Point, state: &State) -> [[f64; 2]; 3] {
        let Some(body) = point.on else { return [point.at, [0.0; 2], [0.0; 2]] };
        let pose = Pose::new(state.positions[body]);
        let [rx, ry] = pose.turned(point.at);
        let ([vx, vy, w], [ax, ay, angular]) = (state.velocities[body], state.accelerations[body]);
        [
            [pose.x + rx, pose.y + ry],
            [vx - w * ry, vy + w * rx],
            [ax - angular * ry - w * w * rx, ay + angular * rx - w * w * ry],
        ]
    }

    /// Closes the mechanism near the drawn position: Newton's method with the smallest change of the positions,
    /// damped while it is far from closed (Levenberg and Marquardt).
    ///
    /// # Errors
    /// `DoesNotClose`, `NotFinite`.
    pub fn assemble(&self, drawn: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, PlanarError> {
        let mut positions = drawn.to_vec();
        let (mut residuals, mut jacobian) = self.row_scaled(&positions)?;
        let (mut open, mut damping) = (square(&residuals), 1e-3);
        let (mut best, mut stalled) = (f64::INFINITY, 0);
        for _ in 0..STEPS {
            let largest = residuals.iter().fold(0.0f64, |most, residual| most.max(residual.abs()));
            if largest <= CLOSED * self.reach(&positions) || stalled > 20 {
                break;
            }
            let mut normal = &jacobian * jacobian.transpose();
            for at in 0..normal.nrows() {
                normal[(at, at)] += damping * f64::min(1.0, largest / self.length);
            }
            let multipliers = Elimination::new(&normal)?.solve(&residuals)?;
            let change = jacobian.tr_mul(&nalgebra::DVector::from_vec(multipliers));
            let tried = self.moved(&positions, change.as_slice(), -1.0);
            let (new_gaps, new_slopes) = self.row_scaled(&tried)?;
            let new_open = square(&new_gaps);
            if new_open < open {
                (positions, residuals, jacobian, open) = (tried, new_gaps, new_slopes, new_open);
                damping = f64::max(damping * 0.1, 1e-15);
            } else {
                damping = f64::max(damping * 10.0, 1e-12);
            }
            stalled = if open < 0.99 * best { 0 } else { stalled + 1 };
            best = best.min(open);
        }
        self.closed(&positions)?;
        Ok(positions)
    }

    /// Refuses positions in which an equation does not hold.
    pub(super) fn closed(&self, positions: &[[f64; 3]]) -> Result<(), PlanarError> {
        let (residuals, _) = self.row_scaled(positions)?;
        let (equation, residual) = residuals.iter().enumerate().fold((0, 0.0f64), |worst, (at, residual)| {
            if residual.abs() > worst.1 { (at, residual.abs()) } else { worst }
        });
        if residual <= 1e-10 * self.reach(positions) {
            Ok(())
        } else {
            Err(PlanarError::DoesNotClose { joint: self.owners[equation], residual })
        }
    }

    /// Mobility of the mechanism in a position.
    ///
    /// # Errors
    /// `NotFinite`.
    pub fn mobility(&self, positions: &[[f64; 3]]) -> Result<Mobility, PlanarError> {
        let joints = self.first_driver();
        let jacobian = self.constraints(positions).jacobian.rows(0, joints).into_owned();
        let elimination = Elimination::new(&jacobian)?;
        let mut redundant: Vec<usize> =
            elimination.dependent_rows().iter().map(|&row| self.owners[row]).collect();
        redundant.sort_unstable();
        redundant.dedup();
        let unknowns = 3 * self.mechanism.bodies.len();
        Ok(Mobility {
            counted: unknowns as i64 - joints as i64,
            free: unknowns - elimination.rank(),
            redundant,
        })
    }

    /// The equations of joints and drivers, ready to be solved for velocities, accelerations and multipliers.
    ///
    /// # Errors
    /// `UnderDriven`, `OverDriven`, `DeadCentre`; `NotFinite`.
    pub(super) fn factored(&self, positions: &[[f64; 3]]) -> Result<Elimination, PlanarError> {
        let jacobian = self.constraints(positions).jacobian;
        let elimination = Elimination::new(&jacobian)?;
        let unknowns = 3 * self.mechanism.bodies.len();
        let drivers = self.mechanism.drivers.len();
        if elimination.rank() == unknowns && elimination.dependent_rows().is_empty() {
            return Ok(elimination);
        }
        let Mobility { counted, free, .. } = self.mobility(positions)?;
        if elimination.rank() == unknowns && drivers == free {
            return Ok(elimination);
        }
        if drivers < free {
            let singular = counted <= drivers as i64;
            return Err(PlanarError::UnderDriven { free: free - drivers, singular });
        }
        // Of the motions that the joints leave, which driver moves none that the others do not?
        let joints = Elimination::new(&jacobian.rows(0, self.first_driver()).into_owned())?;
        let motions = joints.null_space()?;
        let driven = DMatrix::from_fn(drivers, motions.len().max(1), |driver, motion| {
            motions.get(motion).map_or(0.0, |motion| {
                jacobian.row(self.first_driver() + driver).iter().zip(motion).map(|(a, b)| a * b).sum()
            })
        });
        let idle = Elimination::new(&driven)?.dependent_rows().first().copied();
        let driver = idle.unwrap_or(drivers.saturating_sub(1));
        Err(if drivers > free {
            PlanarError::OverDriven { driver }
        } else {
            PlanarError::DeadCentre { driver }
        })
    }

    /// Velocities and accelerations with the drivers' own: `Φ_q q̇ = −Φ_t` and `Φ_q q̈ = γ`.
    ///
    /// # Errors
    /// As for [`dynamics`](System::dynamics).
    pub fn motion(&self, positions: &[[f64; 3]]) -> Result<State, PlanarError> {
        self.driven(&self.factored(positions)?, positions)
    }

    /// Velocities, accelerations and efforts in one: [`motion`](System::motion) and [`dynamics`](System::dynamics),
    /// from one elimination.
    ///
    /// # Errors
    /// As for [`dynamics`](System::dynamics).
    pub fn solved(&self, positions: &[[f64; 3]]) -> Result<(State, Dynamics), PlanarError> {
        let elimination = self.factored(positions)?;
        let state = self.driven(&elimination, positions)?;
        let dynamics = self.balanced(&elimination, &state)?;
        Ok((state, dynamics))
    }

    /// The motion that the drivers give.
    fn driven(&self, elimination: &Elimination, positions: &[[f64; 3]]) -> Result<State, PlanarError> {
        let drivers = &self.mechanism.drivers;
        let rates: Vec<f64> = drivers.iter().map(|driver| driver.velocity).collect();
        let accelerations: Vec<f64> = drivers.iter().map(|driver| driver.acceleration).collect();
        self.motion_with(elimination, positions, &rates, &accelerations)
    }

    /// `∂q/∂m` for each driver.
    pub(super) fn coefficients(&self, elimination: &Elimination) -> Result<Vec<Vec<[f64; 3]>>, PlanarError> {
        (self.first_driver()..self.equations.len())
            .map(|driver| {
                let mut unit = vec![0.0; self.equations.len()];
                unit[driver] = 1.0;
                Ok(self.unscaled(&elimination.solve(&unit)?))
            })
            .collect()
    }

    pub(super) fn motion_with(
        &self,
        elimination: &Elimination,
        positions: &[[f64; 3]],
        rates: &[f64],
        accelerations: &[f64],
    ) -> Result<State, PlanarError> {
        let mut right = vec![0.0; self.first_driver()];
        right.extend(rates);
        let velocities = self.unscaled(&elimination.solve(&right)?);
        let mut right: Vec<f64> = self.biases(positions, &velocities).into_iter().map(|bias| -bias).collect();
        for (right, acceleration) in right[self.first_driver()..].iter_mut().zip(accelerations) {
            *right += acceleration;
        }
        let accelerations = self.unscaled(&elimination.solve(&right)?);
        Ok(State { positions: positions.to_vec(), velocities, accelerations })
    }

    /// The constraint residuals Φ and their Jacobian Φ_q.
    pub(super) fn constraints(&self, positions: &[[f64; 3]]) -> Constraints {
        let poses = poses(positions);
        let mut jacobian = DMatrix::zeros(self.equations.len(), 3 * positions.len());
        let mut residuals = Vec::with_capacity(self.equations.len());
        for (row, equation) in self.equations.iter().enumerate() {
            let mut left = 0.0;
            for term in &equation.terms {
                let gradient = gradient(&term.measure, &poses);
                let [value, rate] = match &term.profile {
                    Some(profile) => {
                        let [value, rate, _] = profile.at(gradient.value);
                        [value, rate]
                    }
                    None => [gradient.value, 1.0],
                };
                left += term.weight * value;
                for (frame, part) in term.measure.bodies().into_iter().zip([gradient.from, gradient.to]) {
                    if let Some(body) = frame {
                        let factor = term.weight * rate;
                        jacobian[(row, 3 * body)] += factor * part[0];
                        jacobian[(row, 3 * body + 1)] += factor * part[1];
                        jacobian[(row, 3 * body + 2)] += factor * part[2] / self.length;
                    }
                }
            }
            residuals.push(left - equation.sum.unwrap_or(0.0));
        }
        Constraints { residuals, jacobian }
    }

    /// The accelerations of the equations' left sides when no body accelerates.
    pub(super) fn biases(&self, positions: &[[f64; 3]], velocities: &[[f64; 3]]) -> Vec<f64> {
        let poses = poses(positions);
        let of_term = |term: &super::Term| {
            let bias = bias(&term.measure, &poses, velocities);
            let through = match &term.profile {
                Some(profile) => {
                    let gradient = gradient(&term.measure, &poses);
                    let rate = project(&term.measure, &gradient, velocities);
                    let [_, first, second] = profile.at(gradient.value);
                    first * bias + second * rate * rate
                }
                None => bias,
            };
            term.weight * through
        };
        self.equations.iter().map(|equation| equation.terms.iter().map(of_term).sum()).collect()
    }

    /// Residuals and Jacobian, each row scaled by its largest entry: residuals in m whatever is measured.
    fn row_scaled(&self, positions: &[[f64; 3]]) -> Result<(Vec<f64>, DMatrix<f64>), PlanarError> {
        let Constraints { mut residuals, mut jacobian } = self.constraints(positions);
        if residuals.iter().chain(jacobian.iter()).any(|x| !x.is_finite()) {
            return Err(PlanarError::NotFinite);
        }
        for (residual, mut row) in residuals.iter_mut().zip(jacobian.row_iter_mut()) {
            let largest = row.amax();
            if largest > 0.0 {
                *residual /= largest;
                row /= largest;
            }
        }
        Ok((residuals, jacobian))
    }

    /// Positions moved by so many scaled steps.
    pub(super) fn moved(&self, positions: &[[f64; 3]], change: &[f64], times: f64) -> Vec<[f64; 3]> {
        let moved = |(at, step): (&[f64; 3], &[f64])| {
            [at[0] + times * step[0], at[1] + times * step[1], at[2] + times * step[2] / self.length]
        };
        positions.iter().zip(change.chunks_exact(3)).map(moved).collect()
    }

    /// A coordinate, rate or acceleration of the bodies by its column, an angle times the length.
    pub(super) fn scaled(&self, column: usize, of_bodies: &[[f64; 3]]) -> f64 {
        let value = of_bodies[column / 3][column % 3];
        if column % 3 == 2 { value * self.length } else { value }
    }

    /// Scaled rates as those of the bodies.
    #[inline(always)]
    pub(super) fn unscale<S: SimdReal>(&self, scaled: &[S], of_bodies: &mut [[S; 3]]) {
        let per_length = 1.0 / self.length;
        for (rate, scaled) in of_bodies.iter_mut().zip(scaled.chunks_exact(3)) {
            *rate = [scaled[0], scaled[1], scaled[2] * per_length];
        }
    }

    /// The same, in a list of their own.
    pub(super) fn unscaled(&self, scaled: &[f64]) -> Vec<[f64; 3]> {
        let mut of_bodies = vec![[0.0; 3]; scaled.len() / 3];
        self.unscale(scaled, &mut of_bodies);
        of_bodies
    }

    /// Size of the mechanism, m, to which the rounding of its positions is relative.
    pub(super) fn reach(&self, positions: &[[f64; 3]]) -> f64 {
        let largest = positions
            .iter()
            .map(|[x, y, angle]| x.abs().max(y.abs()).max(angle.abs() * self.length))
            .fold(self.length, f64::max);
        largest.max(f64::MIN_POSITIVE)
    }
}

/// The poses of the bodies and, last, of the ground.
pub(super) fn poses(positions: &[[f64; 3]]) -> Vec<Pose<f64>> {
    positions.iter().map(|&position| Pose::new(position)).chain([Pose::ground()]).collect()
}

/// The poses of the bodies that a measure is taken from and to.
#[inline(always)]
pub(super) fn pair<'a, S>(measure: &Measure, poses: &'a [Pose<S>]) -> [&'a Pose<S>; 2] {
    let ground = poses.len() - 1;
    let [from, to] = measure.bodies();
    [&poses[from.unwrap_or(ground)], &poses[to.unwrap_or(ground)]]
}

#[inline(always)]
pub(super) fn gradient<S: Real>(measure: &Measure, poses: &[Pose<S>]) -> Gradient<S> {
    measure.gradient(pair(measure, poses))
}

pub(super) fn bias(measure: &Measure, poses: &[Pose<f64>], velocities: &[[f64; 3]]) -> f64 {
    let [from_velocity, to_velocity] =
        measure.bodies().map(|frame| frame.map_or([0.0; 3], |body| velocities[body]));
    measure.bias(pair(measure, poses), [from_velocity, to_velocity])
}

/// The velocity of a measure.
#[inline(always)]
pub(super) fn project<S: Real>(measure: &Measure, gradient: &Gradient<S>, velocities: &[[S; 3]]) -> S {
    let dot = |[ax, ay, aw]: [S; 3], [bx, by, bw]: [S; 3]| ax * bx + ay * by + aw * bw;
    let of = |frame: Frame, part: [S; 3]| frame.map_or(S::from(0.0), |body| dot(part, velocities[body]));
    let [from, to] = measure.bodies();
    of(from, gradient.from) + of(to, gradient.to)
}

fn left_side(equation: &Equation, poses: &[Pose<f64>]) -> f64 {
    let of_term = |term: &super::Term| {
        let value = gradient(&term.measure, poses).value;
        term.weight * term.profile.as_ref().map_or(value, |profile| profile.at(value)[0])
    };
    equation.terms.iter().map(of_term).sum()
}

fn square(residuals: &[f64]) -> f64 {
    residuals.iter().map(|residual| residual * residual).sum()
}

/// The largest length of the mechanism: of the arms to its points, of its rods, of the drawing.
fn size(mechanism: &Mechanism, equations: &[Equation], drawn: &[[f64; 3]]) -> f64 {
    let arm = |point: Point| point.at[0].hypot(point.at[1]);
    let of_measure = |measure: &Measure| match *measure {
        Measure::Angle { .. } => 0.0,
        Measure::Component { from, to, .. }
        | Measure::Along { from, to, .. }
        | Measure::Distance { from, to } => arm(from).max(arm(to)),
    };
    let in_equations = equations.iter().flat_map(|equation| {
        let only_lengths = equation.terms.iter().all(|term| !term.measure.is_angle());
        let sum = if only_lengths { equation.sum.map_or(0.0, f64::abs) } else { 0.0 };
        equation.terms.iter().map(|term| of_measure(&term.measure)).chain([sum])
    });
    let in_loads = mechanism.loads.iter().map(|load| match load {
        Load::Force { at, .. } => arm(*at),
        Load::Effort { measure, .. } => of_measure(measure),
        Load::Friction { radius, .. } => *radius,
    });
    let largest = in_equations.chain(in_loads).fold(0.0, f64::max);
    let in_drawing = drawn.iter().map(|[x, y, _]| x.hypot(*y)).fold(0.0, f64::max);
    // Arms below a picometre are what rounding leaves of a pin at the centre of mass.
    [largest, in_drawing].into_iter().find(|&length| length > 1e-12).unwrap_or(1.0)
}
