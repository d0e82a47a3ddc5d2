//! The immutable model of a mechanism: its constraint equations, scaled masses and layout, compiled once.
//!
//! Every function takes the model by `&self` and the position, velocity and driver values as arguments; what is
//! computed stands in results or in working data of its own ([`Data`](super::data::Data), the stations of a
//! [`Sweep`](super::Sweep)).
//!
//! Index conventions: bodies, joints, drivers and loads count from 0. Positions, velocities and accelerations have one
//! `[x, y, θ]` for each body. Equations stand in the order of the joints, then one for each driver; residuals,
//! multipliers and rows of the Jacobian `Φ_q` (m × 3n for m equations and n bodies) follow them. Its columns are
//! *scaled* coordinates: `3 body + (0, 1, 2)` for `(x, y, θ · size)`, m, so that lengths and angles are comparable.

mod check;

use std::ops::Range;

use self::check::check;
use super::{
    BodyPoint, ConstraintTerm, Equation, PlanarError, PlanarLoad, PlanarMechanism, Pose, RelativeCoordinate,
    layout::EquationLayout,
    measure::{gradient, poses, rate},
    tolerances::MIN_LENGTH,
};
use dalembert_numerics::simd::SimdReal;

/// Positions, velocities and accelerations of all bodies, each `(x, y, θ)`: m and rad, and per s and s².
#[derive(Debug, Clone, PartialEq)]
pub struct PlanarState {
    /// Positions.
    pub positions: Vec<[f64; 3]>,
    /// Velocities.
    pub velocities: Vec<[f64; 3]>,
    /// Accelerations.
    pub accelerations: Vec<[f64; 3]>,
}

/// A mechanism compiled for evaluation; every reference in it is valid.
#[derive(Debug, Clone)]
pub struct Model {
    pub(super) mechanism: PlanarMechanism,
    /// Those of the joints, then those of the drivers.
    pub(super) equations: Vec<Equation>,
    /// The joint of each equation; the drivers count on after the joints.
    pub(super) owners: Vec<usize>,
    /// The size of the mechanism, m: it makes angles and lengths comparable.
    pub(super) length: f64,
    /// The masses `(m, m, I / size²)` of the scaled coordinates, kg.
    pub(super) masses: Vec<f64>,
    /// Explicit and loop equations, and the places of the Jacobian's entries.
    pub(super) layout: EquationLayout,
}

impl Model {
    /// Checks a mechanism and compiles its equations. `guess` is about where its bodies are, `(x, y, θ)` each: it
    /// settles what the joints leave open, on which side a linkage is assembled and how gears mesh.
    ///
    /// # Errors
    /// `Number`, `NoSuchBody`.
    pub fn new(mechanism: &PlanarMechanism, guess: &[[f64; 3]]) -> Result<Self, PlanarError> {
        check(mechanism, guess)?;
        let mut equations = Vec::new();
        let mut owners = Vec::new();
        for (owner, joint) in mechanism.joints.iter().enumerate() {
            for equation in joint.equations() {
                equations.push(equation);
                owners.push(owner);
            }
        }
        let of_joints = equations.len();
        for (driver, owner) in mechanism.drivers.iter().zip(mechanism.joints.len()..) {
            equations.push(Equation::of(driver.measure, Some(driver.value)));
            owners.push(owner);
        }
        let length = size(mechanism, &equations, guess);
        let poses = poses(guess);
        for equation in &mut equations {
            if equation.constant.is_none() {
                equation.constant = Some(left_side(equation, &poses));
            }
        }
        let masses =
            mechanism.bodies.iter().flat_map(|body| [body.mass, body.mass, body.inertia / (length * length)]);
        Ok(Self {
            masses: masses.collect(),
            layout: EquationLayout::new(&equations, of_joints, mechanism.bodies.len(), length),
            mechanism: mechanism.clone(),
            equations,
            owners,
            length,
        })
    }

    /// The size of the mechanism, m: its longest arm, rod or reach.
    pub fn size(&self) -> f64 {
        self.length
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &PlanarMechanism {
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

    /// The indices of the equations of a joint; the drivers count on after the joints.
    pub fn equations_of(&self, owner: usize) -> Range<usize> {
        let from = self.owners.partition_point(|of| *of < owner);
        from..self.owners.partition_point(|of| *of <= owner)
    }

    /// The number of equations of the joints, which is the index of the first driver's equation.
    pub(super) fn first_driver(&self) -> usize {
        self.equations.len() - self.mechanism.drivers.len()
    }

    /// The value of each driver in the model, m or rad.
    pub(super) fn driver_values(&self) -> Vec<f64> {
        self.mechanism.drivers.iter().map(|driver| driver.value).collect()
    }

    /// The value that each driver's measure has in a position, m or rad.
    pub(super) fn driven_values(&self, positions: &[[f64; 3]]) -> Vec<f64> {
        self.mechanism.drivers.iter().map(|driver| self.value(&driver.measure, positions)).collect()
    }

    /// The value of a measure.
    pub fn value(&self, measure: &RelativeCoordinate, positions: &[[f64; 3]]) -> f64 {
        gradient(measure, &poses(positions)).value
    }

    /// The velocity of a measure.
    pub fn rate(&self, measure: &RelativeCoordinate, state: &PlanarState) -> f64 {
        let gradient = gradient(measure, &poses(&state.positions));
        rate(measure, &gradient, &state.velocities)
    }

    /// Position, velocity and acceleration of a point, in the axes of the ground: m, m/s, m/s².
    pub fn point(&self, point: BodyPoint, state: &PlanarState) -> [[f64; 2]; 3] {
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

    /// Reports whether drivers or loads have no potential, so that their work is a quantity of its own.
    pub(super) fn has_work(&self) -> bool {
        let dissipates = |load: &PlanarLoad| match load {
            PlanarLoad::Force { turns_with, .. } => turns_with.is_some(),
            PlanarLoad::Effort { effort, .. } => !effort.is_stored(),
            PlanarLoad::Friction { .. } => true,
        };
        !self.mechanism.drivers.is_empty() || self.mechanism.loads.iter().any(dissipates)
    }

    /// The factor that makes a measure a length: the size for an angle, m, 1 for a length.
    pub(super) fn length_of(&self, measure: &RelativeCoordinate) -> f64 {
        if measure.is_angle() { self.length } else { 1.0 }
    }

    /// Positions changed by so many times a displacement of the scaled coordinates.
    pub(super) fn displaced(
        &self,
        positions: &[[f64; 3]],
        displacement: &[f64],
        times: f64,
    ) -> Vec<[f64; 3]> {
        let displaced = |(at, step): (&[f64; 3], &[f64])| {
            [at[0] + times * step[0], at[1] + times * step[1], at[2] + times * step[2] / self.length]
        };
        positions.iter().zip(displacement.chunks_exact(3)).map(displaced).collect()
    }

    /// The scaled position, velocity or acceleration in a column.
    pub(super) fn scaled(&self, column: usize, of_bodies: &[[f64; 3]]) -> f64 {
        let value = of_bodies[column / 3][column % 3];
        if column % 3 == 2 { value * self.length } else { value }
    }

    /// The tree coordinates of a position, m.
    pub(super) fn tree_coordinates(&self, positions: &[[f64; 3]]) -> Vec<f64> {
        self.layout.tree.iter().map(|&column| self.scaled(column, positions)).collect()
    }

    /// The velocities or accelerations `(x, y, θ)` of the bodies from scaled ones.
    #[inline(always)]
    pub(super) fn unscale<S: SimdReal>(&self, scaled: &[S], of_bodies: &mut [[S; 3]]) {
        let per_length = 1.0 / self.length;
        for (of_body, scaled) in of_bodies.iter_mut().zip(scaled.chunks_exact(3)) {
            *of_body = [scaled[0], scaled[1], scaled[2] * per_length];
        }
    }

    /// The same, in a list of their own.
    pub(super) fn unscaled(&self, scaled: &[f64]) -> Vec<[f64; 3]> {
        let mut of_bodies = vec![[0.0; 3]; scaled.len() / 3];
        self.unscale(scaled, &mut of_bodies);
        of_bodies
    }

    /// The largest scaled coordinate, m, at least the size: rounding of the positions is relative to it.
    pub(super) fn reach(&self, positions: &[[f64; 3]]) -> f64 {
        let largest = positions
            .iter()
            .map(|[x, y, angle]| x.abs().max(y.abs()).max(angle.abs() * self.length))
            .fold(self.length, f64::max);
        largest.max(f64::MIN_POSITIVE)
    }
}

/// The left side `Σ weight · f(measure)` of an equation.
fn left_side(equation: &Equation, poses: &[Pose<f64>]) -> f64 {
    let of_term = |term: &ConstraintTerm| {
        let value = gradient(&term.measure, poses).value;
        term.weight * term.function.as_ref().map_or(value, |function| function.at(value)[0])
    };
    equation.terms.iter().map(of_term).sum()
}

/// The largest length of the mechanism: of the arms to its points, of its rods, of the initial guess.
fn size(mechanism: &PlanarMechanism, equations: &[Equation], guess: &[[f64; 3]]) -> f64 {
    let arm = |point: BodyPoint| point.at[0].hypot(point.at[1]);
    let of_measure = |measure: &RelativeCoordinate| match *measure {
        RelativeCoordinate::Angle { .. } => 0.0,
        RelativeCoordinate::Component { from, to, .. }
        | RelativeCoordinate::Along { from, to, .. }
        | RelativeCoordinate::Distance { from, to }
        | RelativeCoordinate::Bearing { from, to } => arm(from).max(arm(to)),
    };
    let in_equations = equations.iter().flat_map(|equation| {
        let only_lengths = equation.terms.iter().all(|term| !term.measure.is_angle());
        let constant = if only_lengths { equation.constant.map_or(0.0, f64::abs) } else { 0.0 };
        equation.terms.iter().map(|term| of_measure(&term.measure)).chain([constant])
    });
    let in_loads = mechanism.loads.iter().map(|load| match load {
        PlanarLoad::Force { at, .. } => arm(*at),
        PlanarLoad::Effort { measure, .. } => of_measure(measure),
        PlanarLoad::Friction { radius, .. } => *radius,
    });
    let largest = in_equations.chain(in_loads).fold(0.0, f64::max);
    let in_guess = guess.iter().map(|[x, y, _]| x.hypot(*y)).fold(0.0, f64::max);
    [largest, in_guess].into_iter().find(|&length| length > MIN_LENGTH).unwrap_or(1.0)
}
