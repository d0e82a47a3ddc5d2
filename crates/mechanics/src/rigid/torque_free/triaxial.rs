//! Torque-free motion of any body by Jacobi's elliptic functions.
//!
//! The axes are put in an order a, b, c: b has the middle moment of inertia, c is the axis that the polhode goes
//! around. Then `ω_a = A_a cn τ`, `ω_b = A_b sn τ`, `ω_c = A_c dn τ`, up to signs, with `τ` linear in time. L. D.
//! Landau and E. M. Lifshitz, *Mechanics*, 3rd ed., §37. All differences are written so that they lose no digits near
//! the middle axis.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

use dalembert_numerics::elliptic;

/// Principal moments of inertia that no body has, or a motion out of range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum FreeBodyError {
    /// A moment of inertia is not positive.
    #[error("the moment of inertia about axis {axis} must be positive and finite")]
    Moment {
        /// Axis, counted from 0.
        axis: usize,
    },
    /// A moment is larger than the sum of the other two.
    #[error(
        "the moment of inertia about axis {axis} is larger than the sum of the other two, which no body has"
    )]
    Triangle {
        /// Axis, counted from 0.
        axis: usize,
    },
    /// Something is beyond the range of numbers.
    #[error("the motion is beyond the range of numbers; check the sizes of what is given")]
    NotFinite,
}

/// Class of the polhode: path of the tip of the angular velocity on the inertia ellipsoid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Polhode {
    /// It stays: the body turns about a principal axis.
    Permanent,
    /// It goes around the axis of that number, which has the largest or the smallest moment.
    Around(usize),
    /// Separatrix: the tip goes once, asymptotically, from one end of the intermediate axis to the other.
    Separatrix,
}

/// A body in free motion, from an angular velocity at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeBody {
    inertia: Vector3<f64>,
    start: Vector3<f64>,
    polhode: Polhode,
    /// Permutation of the principal axes that gives a, b, c.
    order: [usize; 3],
    /// `A_a`, `A_b`, `A_c` with their signs, rad/s.
    amplitudes: [f64; 3],
    /// `dτ/dt`, 1/s.
    argument_rate: f64,
    /// `1 − k²`.
    complement: f64,
    /// `τ` at the start.
    argument: f64,
    /// Axes fixed in the body beside the start: nodes, across them, along `H_G`.
    frame: Matrix3<f64>,
}

impl FreeBody {
    /// A body from its principal moments of inertia, kg·m², and its angular velocity about them, rad/s.
    ///
    /// # Errors
    /// [`FreeBodyError`].
    pub fn new(inertia: Vector3<f64>, start: Vector3<f64>) -> Result<Self, FreeBodyError> {
        if let Some(axis) = (0..3).find(|n| !(inertia[*n].is_finite() && inertia[*n] > 0.0)) {
            return Err(FreeBodyError::Moment { axis });
        }
        if let Some(axis) = (0..3).find(|n| inertia.sum() - 2.0 * inertia[*n] < -1e-12 * inertia.sum()) {
            return Err(FreeBodyError::Triangle { axis });
        }
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| inertia[*a].total_cmp(&inertia[*b]));
        let momentum = inertia.component_mul(&start);
        let excess = excess(inertia, start);
        if !(momentum.norm_squared().is_finite() && excess.is_finite()) {
            return Err(FreeBodyError::NotFinite);
        }
        if excess < 0.0 {
            order.reverse();
        }
        let [a, b, c] = order;
        let polhode = if start.cross(&momentum) == Vector3::zeros() {
            Polhode::Permanent
        } else if excess == 0.0 {
            Polhode::Separatrix
        } else {
            Polhode::Around(c)
        };
        let mut body = Self {
            inertia,
            start,
            polhode,
            order,
            amplitudes: [0.0; 3],
            argument_rate: 0.0,
            complement: 1.0,
            argument: 0.0,
            frame: Matrix3::identity(),
        };
        if polhode == Polhode::Permanent {
            return Ok(body);
        }
        let ([i_a, i_b, i_c], [w_a, w_b, w_c]) = (order.map(|n| inertia[n]), order.map(|n| start[n]));
        let size_a = w_a.hypot((i_b * (i_c - i_b) / (i_a * (i_c - i_a))).sqrt() * w_b);
        let size_b = w_b.hypot((i_a * (i_c - i_a) / (i_b * (i_c - i_b))).sqrt() * w_a);
        let size_c = w_c.hypot((i_b * (i_b - i_a) / (i_c * (i_c - i_a))).sqrt() * w_b);
        // From I_a ω̇_a = ±(I_b − I_c) ω_b ω_c: + where a, b, c are in the order of x, y, z or turned from it.
        let turned = if (b + 3 - a) % 3 == 1 { 1.0 } else { -1.0 };
        let side_c = if w_c < 0.0 { -1.0 } else { 1.0 };
        let side_b = side_c * turned * (i_c - i_b).signum();
        body.amplitudes = [size_a, side_b * size_b, side_c * size_c];
        body.argument_rate = ((i_c - i_b) * (i_c - i_a) / (i_a * i_b)).sqrt() * size_c;
        body.complement = (excess / ((i_c - i_b) * i_c * size_c * size_c)).min(1.0);
        let amplitude = f64::atan2(side_b * w_b / size_b, w_a / size_a);
        body.argument = elliptic::ellip_f(amplitude, body.complement);
        body.frame = body.beside(start);
        let finite = [size_a, size_b, size_c, body.argument_rate, body.complement, body.argument];
        if finite.iter().all(|x| x.is_finite())
            && body.argument_rate > 0.0
            && (polhode == Polhode::Separatrix || body.complement > 0.0)
        {
            Ok(body)
        } else {
            Err(FreeBodyError::NotFinite)
        }
    }

    /// Class of the polhode: path of the tip of the angular velocity on the inertia ellipsoid.
    pub fn polhode(&self) -> Polhode {
        self.polhode
    }

    /// The axes a, b, c as numbers from 0.
    pub fn order(&self) -> [usize; 3] {
        self.order
    }

    /// The largest values of `ω_a`, `ω_b`, `ω_c`, with the signs that go with `cn`, `sn`, `dn`, rad/s; zero for a
    /// permanent rotation.
    pub fn amplitudes(&self) -> [f64; 3] {
        self.amplitudes
    }

    /// Modulus `k` of the elliptic functions and `1 − k²`.
    pub fn modulus(&self) -> (f64, f64) {
        ((1.0 - self.complement).max(0.0).sqrt(), self.complement)
    }

    /// `p = dτ/dt`, 1/s.
    pub fn argument_rate(&self) -> f64 {
        self.argument_rate
    }

    /// Time after which the angular velocity is the same in the body, `4 K(k)/p`, s; infinite for a permanent rotation
    /// and for the separatrix.
    pub fn period(&self) -> f64 {
        match self.polhode {
            Polhode::Around(_) => 4.0 * elliptic::ellip_k(self.complement) / self.argument_rate,
            Polhode::Permanent | Polhode::Separatrix => f64::INFINITY,
        }
    }

    /// First time, from now on, at which the component along the intermediate axis is zero, s.
    pub fn first_flip(&self) -> Option<f64> {
        match self.polhode {
            Polhode::Around(_) => {
                let half = 2.0 * elliptic::ellip_k(self.complement);
                Some((-self.argument).rem_euclid(half) / self.argument_rate)
            }
            Polhode::Separatrix if self.argument <= 0.0 => Some(-self.argument / self.argument_rate),
            Polhode::Permanent | Polhode::Separatrix => None,
        }
    }

    /// Angle of the axis c about `H_G` in one period, rad.
    pub fn advance(&self) -> f64 {
        let period = self.period();
        if period.is_finite() { self.precession_between(0.0, TAU, period) } else { 0.0 }
    }

    /// Angular velocity in axes fixed in the body, rad/s.
    pub fn velocity(&self, time: f64) -> Vector3<f64> {
        if self.polhode == Polhode::Permanent {
            return self.start;
        }
        let (_, rest) = self.turns(self.argument + self.argument_rate * time);
        let (sn, cn, dn) = elliptic::jacobi_of(rest, self.complement);
        let mut velocity = Vector3::zeros();
        for ((axis, amplitude), function) in self.order.into_iter().zip(self.amplitudes).zip([cn, sn, dn]) {
            velocity[axis] = amplitude * function;
        }
        velocity
    }

    /// Rotation of the body since the start, from body axes to fixed axes that agreed with them.
    pub fn attitude(&self, time: f64) -> Rotation3<f64> {
        if self.polhode == Polhode::Permanent {
            return Unit::try_new(self.start, 0.0).map_or_else(Rotation3::identity, |along| {
                Rotation3::from_axis_angle(&along, self.start.norm() * time)
            });
        }
        let precession = self.precession_between(self.amplitude(0.0), self.amplitude(time), time);
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), precession);
        let now = self.beside(self.velocity(time));
        Rotation3::from_matrix_unchecked(self.frame * turn.matrix() * now.transpose())
    }

    /// The precession of the axis c about `H_G` while Jacobi's amplitude goes from one value to another,
    /// `(H/I_c)(t + (I_c − I_a)/(I_a p) ΔΠ(n, k))`.
    fn precession_between(&self, from: f64, to: f64, time: f64) -> f64 {
        let [i_a, i_b, i_c] = self.order.map(|n| self.inertia[n]);
        let rest = i_b * (i_c - i_a) / (i_a * (i_c - i_b));
        let third = |amplitude| elliptic::ellip_pi(amplitude, rest, self.complement);
        let momentum = self.inertia.component_mul(&self.start).norm();
        momentum / i_c * (time + (i_c - i_a) / (i_a * self.argument_rate) * (third(to) - third(from)))
    }

    fn amplitude(&self, time: f64) -> f64 {
        let (turns, rest) = self.turns(self.argument + self.argument_rate * time);
        turns * TAU + elliptic::amplitude_of(rest, self.complement)
    }

    /// An argument as whole periods of the functions and the rest.
    fn turns(&self, argument: f64) -> (f64, f64) {
        if self.polhode == Polhode::Separatrix {
            return (0.0, argument);
        }
        let period = 4.0 * elliptic::ellip_k(self.complement);
        let turns = (argument / period).round();
        (turns, argument - turns * period)
    }

    /// Unit vectors along the line of nodes of the axis c, across it, and along `H_G`, in axes of the body.
    fn beside(&self, velocity: Vector3<f64>) -> Matrix3<f64> {
        let momentum = self.inertia.component_mul(&velocity).normalize();
        let mut axis = Vector3::zeros();
        axis[self.order[2]] = 1.0;
        let nodes = axis.cross(&momentum).normalize();
        Matrix3::from_columns(&[nodes, momentum.cross(&nodes), momentum])
    }
}

/// `H² − 2 T I_b`, b the axis of the middle moment: positive where the polhode goes around the axis of the largest.
/// What is rounding beside its two terms is zero.
fn excess(inertia: Vector3<f64>, velocity: Vector3<f64>) -> f64 {
    let mut moments: [f64; 3] = inertia.into();
    moments.sort_by(f64::total_cmp);
    let terms = [0, 1, 2].map(|n| inertia[n] * (inertia[n] - moments[1]) * velocity[n] * velocity[n]);
    let (sum, size) = (terms.iter().sum::<f64>(), terms.iter().map(|term| term.abs()).sum::<f64>());
    if sum.abs() <= 8.0 * f64::EPSILON * size { 0.0 } else { sum }
}
