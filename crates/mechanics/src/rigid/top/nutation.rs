//! Any motion of the heavy top, by elliptic functions.
//!
//! With `z = 1 − cos θ` energy and the two momenta give `ż² = (A + β z) z (2 − z) − (d + a z)²`: a cubic whose zeros
//! are the limits of the nutation. `z` keeps its digits near the upright axis, `y = 1 + cos θ` near the hanging one, so
//! that both are carried along.

use std::{f64::consts::PI, ops::ControlFlow};

use dalembert_numerics::{elliptic, roots};

/// A top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Top {
    /// Moment of inertia about its axis `I_a`, kg·m².
    pub axial: f64,
    /// Moment of inertia about a transverse axis through the fixed point `I_t`, kg·m².
    pub transverse: f64,
    /// Moment of the weight with the axis level `K = m g l`, N·m.
    pub couple: f64,
}

/// Reason for which the motion of a top cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum TopError {
    /// Moments of inertia or weight are not positive.
    #[error("moments of inertia and the moment of the weight must be positive and finite")]
    Body,
    /// The axis starts on the vertical.
    #[error("the axis starts on the vertical, where precession is not defined; start a little beside it")]
    Vertical,
    /// The axis approaches the vertical asymptotically.
    #[error("the axis approaches the vertical asymptotically; change the spin or the start a little")]
    Asymptotic,
    /// Something is beyond the range of numbers.
    #[error("the motion is beyond the range of numbers; check the sizes of what is given")]
    NotFinite,
}

/// Type of the path of the axis between its limits: steady, wavy, cusped or looped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trace {
    /// The axis keeps its angle to the vertical.
    Steady,
    /// The precession never turns back.
    Wave,
    /// The axis is at rest at one limit.
    Cusp,
    /// The precession turns back near one limit.
    Loop,
}

/// Attitude of the axis and its rates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attitude {
    /// Nutation `θ`, rad.
    pub nutation: f64,
    /// Precession since the start `φ`, rad.
    pub precession: f64,
    /// Spin since the start `ψ`, rad.
    pub spin: f64,
    /// `θ̇`, rad/s.
    pub nutation_rate: f64,
    /// `φ̇`, rad/s.
    pub precession_rate: f64,
}

/// A height of the axis: `1 − cos θ` and `1 + cos θ`, each to all its digits.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Height {
    z: f64,
    y: f64,
}

/// A motion of a top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nutation {
    low: Height,
    high: Height,
    /// The third zero of the cubic in `z`, which is not positive.
    third: f64,
    /// `I_a ω₃/I_t`, 1/s.
    a: f64,
    /// `(L_z − I_a ω₃)/I_t`, 1/s.
    d: f64,
    /// `(L_z + I_a ω₃)/I_t`, 1/s.
    e: f64,
    /// `2K/I_t`, 1/s².
    beta: f64,
    axial_velocity: f64,
    /// Argument of the elliptic functions at the start.
    start: f64,
    /// The cubic is flat between its limits.
    steady: bool,
    /// `2 K(k)`, and what [`Nutation::angles`] gives over it and at the start: found once for every instant.
    span: f64,
    in_span: (f64, f64),
    at_start: (f64, f64),
}

impl Top {
    /// The motion from a start: `θ`, `θ̇`, `φ̇` and `ω₃`.
    ///
    /// # Errors
    /// [`TopError`].
    pub fn released(
        &self,
        nutation: f64,
        nutation_rate: f64,
        precession_rate: f64,
        axial_velocity: f64,
    ) -> Result<Nutation, TopError> {
        let body = [self.axial, self.transverse, self.couple];
        if !body.iter().all(|x| x.is_finite() && *x > 0.0) {
            return Err(TopError::Body);
        }
        let sine = nutation.sin();
        if nutation <= 0.0 || nutation >= PI || sine * sine == 0.0 {
            return Err(TopError::Vertical);
        }
        let half = nutation / 2.0;
        let at = Height { z: 2.0 * half.sin().powi(2), y: 2.0 * half.cos().powi(2) };
        let a = self.axial * axial_velocity / self.transverse;
        let beta = 2.0 * self.couple / self.transverse;
        let across = precession_rate * sine * sine;
        let (d, e) = (across - a * at.z, across + a * at.y);
        // Energies above those of the upright and of the hanging axis: A = 2 (E′ ∓ K)/I_t.
        let moving = nutation_rate.powi(2) + precession_rate * across;
        let (above, below) = (moving - beta * at.z, moving + beta * at.y);
        let second = 2.0 * beta - above - a * a;
        if ![at.z, a, beta, d * d, e * e, above, below, second].iter().all(|x| x.is_finite()) {
            return Err(TopError::NotFinite);
        }
        let zero = |cubic: &dyn Fn(f64) -> f64, ends| {
            roots::find(cubic, ends, |_| ControlFlow::Continue(())).map_err(|_| TopError::NotFinite)
        };
        let (low, high, third) = if nutation_rate == 0.0 {
            // The start is a limit; the others are the zeros of β z² − q z − d²/z₀.
            let (other, third) = two_zeros(beta, second - beta * at.z, d * d / at.z);
            let other = Height { z: other, y: e * e / (beta * at.y * (2.0 - third)) }.mended();
            if other.above(at) > 0.0 { (at, other, third) } else { (other, at, third) }
        } else if d == 0.0 {
            // The axis passes the vertical, or could: z itself is a factor.
            let (low, other) = two_zeros(beta, second, 2.0 * above);
            let high = Height::upper(other.max(0.0));
            let third = other.min(0.0);
            (Height { z: low, y: e * e / (beta * high.y * (2.0 - third)) }.mended(), high, third)
        } else if at.z < at.y {
            let cubic = |z: f64| (above + beta * z) * z * (2.0 - z) - (d + a * z).powi(2);
            let high = Height::upper(zero(&cubic, [0.0, at.z])?);
            let low = zero(&cubic, [at.z, 2.0])?;
            let third = -d * d / (beta * low * high.z);
            (Height { z: low, y: e * e / (beta * high.y * (2.0 - third)) }.mended(), high, third)
        } else {
            let cubic = |y: f64| (below - beta * y) * y * (2.0 - y) - (e - a * y).powi(2);
            let (low, high) = (zero(&cubic, [0.0, at.y])?, zero(&cubic, [at.y, 2.0])?);
            let low = Height { z: 2.0 - low, y: low };
            let product = d * d / (beta * low.z);
            // What is left of the cubic: z₂ z₃ = −d²/(β z₁), z₂ + z₃ = c₂/β − z₁.
            let (upper, third) = two_zeros(1.0, second / beta - low.z, product);
            (low, Height { z: upper, y: high }.mended(), third)
        };
        let depth = high.above(low);
        let steady = depth <= 4.0 * f64::EPSILON * low.z.min(low.y).max(f64::MIN_POSITIVE);
        let amplitude = f64::atan2(at.above(low).max(0.0).sqrt(), high.above(at).max(0.0).sqrt());
        let complement = (high.z - third) / (low.z - third);
        let finite = [low.z, low.y, high.z, high.y, third, complement];
        if !(finite.iter().all(|x| x.is_finite()) && low.z > third) {
            return Err(TopError::NotFinite);
        }
        if complement <= 0.0 {
            return Err(TopError::Asymptotic);
        }
        let start = if steady { 0.0 } else { elliptic::ellip_f(amplitude, complement) };
        let start = if nutation_rate > 0.0 { -start } else { start };
        let nothing = (0.0, 0.0);
        let (span, in_span, at_start) = (0.0, nothing, nothing);
        let mut motion = Nutation {
            low,
            high,
            third,
            a,
            d,
            e,
            beta,
            axial_velocity,
            start,
            steady,
            span,
            in_span,
            at_start,
        };
        motion.span = 2.0 * elliptic::ellip_k(motion.complement());
        motion.in_span = motion.angles(PI);
        motion.at_start = motion.angles(elliptic::amplitude_of(start, motion.complement()));
        let finite = start.is_finite() && motion.period().is_finite() && motion.period() > 0.0;
        if finite && motion.advance().is_finite() { Ok(motion) } else { Err(TopError::NotFinite) }
    }
}

impl Height {
    /// From `z`, where `z` is the one with the digits.
    fn upper(z: f64) -> Self {
        Self { z, y: 2.0 - z }
    }

    /// The larger of the two numbers follows from the smaller.
    fn mended(self) -> Self {
        if self.y < 1.0 { Self { z: 2.0 - self.y, ..self } } else { Self::upper(self.z.max(0.0)) }
    }

    /// The difference of the cosines.
    fn above(self, other: Self) -> f64 {
        if other.z < other.y { other.z - self.z } else { self.y - other.y }
    }

    fn angle(self) -> f64 {
        2.0 * f64::atan2(self.z.max(0.0).sqrt(), self.y.max(0.0).sqrt())
    }
}

impl Nutation {
    /// The highest and the lowest position of the axis, `θ` in rad.
    pub fn limits(&self) -> [f64; 2] {
        [self.high.angle(), self.low.angle()]
    }

    /// The third zero of the cubic in `cos θ`, at least 1, where the axis never is.
    pub fn third_zero(&self) -> f64 {
        1.0 - self.third
    }

    /// Modulus `k` of the elliptic functions, `√((u₂ − u₁)/(u₃ − u₁))`.
    pub fn modulus(&self) -> f64 {
        (self.high.above(self.low) / (self.low.z - self.third)).max(0.0).sqrt()
    }

    /// Time from one lowest position to the next, s: `T = 2 K(k)/p`, `p = ½ √(β (u₃ − u₁))`.
    pub fn period(&self) -> f64 {
        self.span / self.argument_rate()
    }

    /// Precession angle over one period of nutation, rad.
    pub fn advance(&self) -> f64 {
        self.in_span.0
    }

    /// The precession `φ̇` at the highest and at the lowest position, rad/s.
    pub fn precession_at_limits(&self) -> [f64; 2] {
        [self.high, self.low].map(|at| self.precession_rate(at))
    }

    /// Type of the path of the axis between its limits.
    pub fn trace(&self) -> Trace {
        // φ̇ sin²θ: its sign at the two limits tells.
        let [at_high, at_low] = [self.high, self.low].map(|at| self.across(at));
        let nothing = |x: f64, at: Height| x.abs() <= 1e-12 * (self.d.abs() + self.a.abs() * at.z);
        if self.steady {
            Trace::Steady
        } else if (self.a != 0.0 || self.d != 0.0)
            && (nothing(at_high, self.high) || nothing(at_low, self.low))
            && self.high.z > 0.0
            && self.low.y > 0.0
        {
            Trace::Cusp
        } else if at_high * at_low < 0.0 {
            Trace::Loop
        } else {
            Trace::Wave
        }
    }

    /// The axis at a time from the start.
    pub fn at(&self, time: f64) -> Attitude {
        let complement = self.complement();
        let argument = self.start + self.argument_rate() * time;
        let turns = (argument / self.span).round();
        let amplitude = elliptic::amplitude_of(argument - turns * self.span, complement);
        let (sn, cn) = amplitude.sin_cos();
        let dn = (complement + (1.0 - complement) * cn * cn).sqrt();
        let between = |low: f64, high: f64| low * cn * cn + high * sn * sn;
        let height = Height { z: between(self.low.z, self.high.z), y: between(self.low.y, self.high.y) };
        // Both angles grow by the same in every span of the argument.
        let (rest, lower_rest) = self.angles(amplitude);
        let precession = turns * self.in_span.0 + rest - self.at_start.0;
        let lower = turns * self.in_span.1 + lower_rest - self.at_start.1;
        // ψ̇ = ω₃ − φ̇ cos θ, and φ̇ cos θ = φ̇ + a − e/y.
        let spin = (self.axial_velocity - self.a) * time - precession + 2.0 * lower;
        let rate = -2.0 * self.high.above(self.low) * self.argument_rate() * sn * cn * dn;
        let sine = (height.z * height.y).sqrt();
        // Through the vertical θ̇ = ż/sin θ is a quotient of zeros: there energy gives its size.
        let nutation_rate = if sine > 1e-9 { rate / sine } else { 0.0 };
        Attitude {
            nutation: height.angle(),
            precession,
            spin,
            nutation_rate,
            precession_rate: self.precession_rate(height),
        }
    }

    /// `½ √(β (z₁ − z₃))`, 1/s.
    fn argument_rate(&self) -> f64 {
        (self.beta * (self.low.z - self.third)).sqrt() / 2.0
    }

    fn complement(&self) -> f64 {
        if self.steady { 1.0 } else { (self.high.z - self.third) / (self.low.z - self.third) }
    }

    /// `φ̇ sin²θ`.
    fn across(&self, at: Height) -> f64 {
        if at.z < at.y { self.d + self.a * at.z } else { self.e - self.a * at.y }
    }

    fn precession_rate(&self, at: Height) -> f64 {
        let square = at.z * at.y;
        if square > 0.0 { self.across(at) / square } else { 0.0 }
    }

    /// The integrals over time, from a lowest position to an amplitude, of `φ̇ = (d/2)/z + (e/2)/y` and of its second
    /// part.
    fn angles(&self, amplitude: f64) -> (f64, f64) {
        let complement = self.complement();
        let part = |weight: f64, at_low: f64, at_high: f64| {
            if weight == 0.0 || at_low <= 0.0 || at_high <= 0.0 {
                return 0.0;
            }
            weight / at_low * elliptic::ellip_pi(amplitude, at_high / at_low, complement)
                / self.argument_rate()
        };
        let upper = part(self.d / 2.0, self.low.z, self.high.z);
        let lower = part(self.e / 2.0, self.low.y, self.high.y);
        (upper + lower, lower)
    }
}

/// The zeros of `β z² − q z − c`, the larger one first, without loss of digits.
fn two_zeros(beta: f64, q: f64, c: f64) -> (f64, f64) {
    let root = (q * q + 4.0 * beta * c).max(0.0).sqrt();
    if q >= 0.0 {
        let larger = (q + root) / (2.0 * beta);
        (larger, if larger > 0.0 { -c / (beta * larger) } else { 0.0 })
    } else {
        let smaller = (q - root) / (2.0 * beta);
        (-c / (beta * smaller), smaller)
    }
}
