//! Free rotation over a long time: steps that keep the energy and the angular momentum as such.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::SimulateError;

/// `√15`.
const ROOT: f64 = 3.872983346207417;
/// The times, the stage weights and the weights of the Gauss method of order 6.
const TIMES: [f64; 3] = [0.5 - ROOT / 10.0, 0.5, 0.5 + ROOT / 10.0];
const STAGES: [[f64; 3]; 3] = [
    [5.0 / 36.0, 2.0 / 9.0 - ROOT / 15.0, 5.0 / 36.0 - ROOT / 30.0],
    [5.0 / 36.0 + ROOT / 24.0, 2.0 / 9.0, 5.0 / 36.0 - ROOT / 24.0],
    [5.0 / 36.0 + ROOT / 30.0, 2.0 / 9.0 + ROOT / 15.0, 5.0 / 36.0],
];
const WEIGHTS: [f64; 3] = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];
/// The most rounds of a step, and the part of a radian up to which they converge well within them.
const ROUNDS: usize = 60;
const LONGEST: f64 = 0.5;
/// Steps after which what rounding did to the invariants is taken back.
const BETWEEN: u32 = 32;
/// The part of a radian up to which the attitude of so many steps is exact to rounding.
const SHORT: f64 = 0.01;
/// Relative rounding error of the invariants.
const ROUNDING: f64 = 8e-15;

/// A body that turns freely, stepped in equal times.
///
/// The angular momentum in principal axes of the body follows `Ḣ = H × J⁻¹H` by the Gauss method of order 6, which
/// keeps every quadratic invariant: energy and `|H|` (E. Hairer, C. Lubich, G. Wanner, *Geometric Numerical
/// Integration*, 2nd ed., §IV.2.1). The attitude is turned by the exponential of the mean angular velocity, to the
/// same order (S. Blanes, F. Casas, J. A. Oteo, J. Ros, *The Magnus expansion and some of its applications*, Physics
/// Reports 470 (2009), §5), and by what keeps the angular momentum where it was in space.
#[derive(Debug, Clone)]
pub struct FreeRotation {
    /// `1/J` of the principal axes.
    inverse: Vector3<f64>,
    step: f64,
    stages: [[f64; 3]; 3],
    weights: [f64; 3],
    /// Extrapolation of the rates of one step into the next.
    onward: [[f64; 3]; 3],
    slopes: [Vector3<f64>; 3],
    momentum: Vector3<f64>,
    /// Compensation of the rounding error of the momentum.
    carried: Vector3<f64>,
    attitude: Quaternion<f64>,
    in_space: Vector3<f64>,
    /// `2T` and `H²` of the start.
    energy: f64,
    square: f64,
    since: u32,
    /// True if the attitude is corrected after every step, rather than after [`BETWEEN`] of them.
    long: bool,
}

impl FreeRotation {
    /// A body with principal moments `inertia`, kg·m², at an attitude (from its principal axes to those in space) and
    /// with an angular velocity in its principal axes, rad/s, to be followed in steps of some s.
    ///
    /// # Errors
    /// `Inertia`, `NotFinite`; `Step` for a step of more than half a radian.
    pub fn new(
        inertia: Vector3<f64>,
        attitude: UnitQuaternion<f64>,
        omega_body: Vector3<f64>,
        step: f64,
    ) -> Result<Self, SimulateError> {
        if inertia.iter().any(|moment| moment.is_nan() || *moment <= 0.0) {
            return Err(SimulateError::Inertia);
        }
        let momentum = inertia.component_mul(&omega_body);
        let (energy, square) = (momentum.dot(&omega_body), momentum.norm_squared());
        let good = step.is_finite() && step > 0.0 && square.is_finite() && energy.is_finite();
        if !good || !inertia.iter().all(|moment| moment.is_finite()) {
            return Err(SimulateError::NotFinite);
        }
        let turned = step * square.sqrt() / inertia.min();
        if turned.is_nan() || turned > LONGEST {
            return Err(SimulateError::Step { turned });
        }
        let inverse = inertia.map(f64::recip);
        let slope = momentum.cross(&inverse.component_mul(&momentum));
        Ok(Self {
            inverse,
            step,
            stages: STAGES.map(|row| row.map(|weight| weight * step)),
            weights: WEIGHTS.map(|weight| weight * step),
            onward: onward(),
            slopes: [slope; 3],
            momentum,
            carried: Vector3::zeros(),
            attitude: attitude.into_inner(),
            in_space: attitude * momentum,
            energy,
            square,
            since: 0,
            long: turned > SHORT,
        })
    }

    /// The body a time later that is shorter than a step.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn after(&self, time: f64) -> Result<Self, SimulateError> {
        let inertia = self.inverse.map(f64::recip);
        let mut later = Self::new(inertia, self.attitude(), self.omega_body(), time)?;
        later.advance();
        Ok(later)
    }

    /// Makes one step.
    pub fn advance(&mut self) {
        let [a, b, c] = self.slopes;
        let mut slopes = self.onward.map(|[x, y, z]| a * x + b * y + c * z);
        let mut omegas = [Vector3::zeros(); 3];
        // A slope that changes by less than this no longer changes the momentum.
        let enough = 1e-16 * self.square.sqrt() / self.step;
        let mut before = f64::INFINITY;
        for _ in 0..ROUNDS {
            let [a, b, c] = slopes;
            let mut change = 0.0_f64;
            for stage in 0..3 {
                let [x, y, z] = self.stages[stage];
                let momentum = self.momentum + (self.carried + (a * x + b * y + c * z));
                omegas[stage] = self.inverse.component_mul(&momentum);
                let slope = momentum.cross(&omegas[stage]);
                let off = slope - slopes[stage];
                change = change.max(off.x.abs()).max(off.y.abs()).max(off.z.abs());
                slopes[stage] = slope;
            }
            if change <= enough || change >= before {
                break;
            }
            before = change;
        }
        self.slopes = slopes;
        let [x, y, z] = self.weights;
        let change = self.carried + (slopes[0] * x + slopes[1] * y + slopes[2] * z);
        let next = self.momentum + change;
        self.carried = change - (next - self.momentum);
        self.momentum = next;
        self.since += 1;
        if self.since == BETWEEN {
            self.since = 0;
            self.take_back_rounding();
        }
        self.turn(omegas);
    }

    /// The attitude, from the principal axes of the body to those in space.
    pub fn attitude(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::new_normalize(self.attitude)
    }

    /// The angular velocity in the principal axes, rad/s.
    pub fn omega_body(&self) -> Vector3<f64> {
        self.inverse.component_mul(&self.momentum)
    }

    /// The angular momentum in space as attitude and angular velocity give it, kg·m²/s.
    pub fn momentum_in_space(&self) -> Vector3<f64> {
        rotated(&self.attitude, self.momentum)
    }

    /// Kinetic energy, J.
    pub fn energy(&self) -> f64 {
        self.momentum.dot(&self.omega_body()) / 2.0
    }

    /// Turns the attitude by the mean angular velocity of a step, of which three stages are known, and brings the angular
    /// momentum back to where it is in space: after a long step at once, else when its rounding is taken back.
    fn turn(&mut self, [first, middle, last]: [Vector3<f64>; 3]) {
        // The transpose of the attitude follows Ẏ = −ω̂ Y; α are the moments of −ω over the step.
        let mean = middle * -self.step;
        let slope = (first - last) * (self.step * ROOT / 3.0);
        let bend = (first + last - middle * 2.0) * (self.step * -10.0 / 3.0);
        let one = mean.cross(&slope);
        let two = mean.cross(&(bend * 2.0 + one)) / -60.0;
        let angle = mean + bend / 12.0 + (one - mean * 20.0 - bend).cross(&(slope + two)) / 240.0;
        let turned = self.attitude * exponential(angle * -0.5);
        if self.since > 0 && !self.long {
            self.attitude = turned;
            return;
        }
        let off = rotated(&turned, self.momentum).cross(&self.in_space);
        // Without any angular momentum nothing turns.
        let back = if self.square > 0.0 { off * (0.5 / self.square) } else { off };
        let whole = Quaternion::from_parts(1.0, back) * turned;
        // Within rounding of one: no root is needed.
        self.attitude = whole * (1.5 - 0.5 * whole.norm_squared());
    }

    /// A step of Newton's method along the gradients of `H²` and `2T` back to their values at the start.
    fn take_back_rounding(&mut self) {
        let (momentum, omega) = (self.momentum, self.omega_body());
        let (mixed, omega_square) = (momentum.dot(&omega), omega.norm_squared());
        let (square, energy) = ((self.square - momentum.norm_squared()) / 2.0, (self.energy - mixed) / 2.0);
        let off = 2.0 * square.abs() / self.square + 2.0 * energy.abs() / self.energy;
        // NaN for a body at rest; less is rounding of the invariants themselves.
        if off.is_nan() || off <= ROUNDING {
            return;
        }
        let whole = self.square * omega_square;
        let free = whole - mixed * mixed;
        // With H along ω the length of one gives the other.
        self.carried += if free > 1e-12 * whole {
            let along = (square * omega_square - energy * mixed) / free;
            let across = (energy * self.square - square * mixed) / free;
            momentum * along + omega * across
        } else {
            momentum * (square / self.square)
        };
    }
}

/// The weights that evaluate the polynomial through the slopes of a step at the times of the next.
fn onward() -> [[f64; 3]; 3] {
    let weight = |at: usize, of: usize| {
        let others = (0..3).filter(|other| *other != of);
        others.map(|other| (1.0 + TIMES[at] - TIMES[other]) / (TIMES[of] - TIMES[other])).product()
    };
    [0, 1, 2].map(|at| [0, 1, 2].map(|of| weight(at, of)))
}

/// The unit quaternion `(cos |v|, sin |v| v/|v|)`, for `|v|` up to a quarter: the series to below rounding.
fn exponential(half: Vector3<f64>) -> Quaternion<f64> {
    const COS: [f64; 6] = [1.0 / 132.0, 1.0 / 90.0, 1.0 / 56.0, 1.0 / 30.0, 1.0 / 12.0, 1.0 / 2.0];
    const SIN: [f64; 5] = [1.0 / 110.0, 1.0 / 72.0, 1.0 / 42.0, 1.0 / 20.0, 1.0 / 6.0];
    let x = half.norm_squared();
    let cos = COS.iter().fold(1.0, |sum, factor| 1.0 - sum * x * factor);
    let sin = SIN.iter().fold(1.0, |sum, factor| 1.0 - sum * x * factor);
    Quaternion::from_parts(cos, half * sin)
}

fn rotated(by: &Quaternion<f64>, vector: Vector3<f64>) -> Vector3<f64> {
    let (real, imaginary) = (by.w, by.imag());
    let twice = imaginary.cross(&vector) * 2.0;
    vector + twice * real + imaginary.cross(&twice)
}
