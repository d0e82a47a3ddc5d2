//! A periodic force, or a base that shakes periodically: its Fourier coefficients, and the exact steady motion.
//!
//! One period is cut into [`WaveSegment`]s over the share `s = t/T` of the period, on each of which the drive is
//! `u = a + b s + g sin(ρ s)`. The oscillator is `ẍ + 2ζω_n ẋ + ω_n² x = ω_n² u` under a force (`u = F/k`) and
//! `… = ω_n² u + 2ζω_n u̇` on a base (`u = y`). On every piece the motion is known in closed form; that it comes back
//! after a period is a linear equation for where it begins. No series is cut off.

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix2, Vector2};

use dalembert_numerics::quadrature::integral;

mod pieces;

pub use pieces::{full_rectified, half_rectified, polygon, pulse, sawtooth, square, triangle};

/// A piece of a period: `u = value + slope σ + sine sin(rate σ)` with `σ` the share of the period since `from`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveSegment {
    /// Start of the piece, as a share of the period.
    pub from: f64,
    /// End of the piece, as a share of the period.
    pub to: f64,
    /// Value at its beginning.
    pub value: f64,
    /// Slope, for a whole period.
    pub slope: f64,
    /// Amplitude of its sine.
    pub sine: f64,
    /// Radians of its sine in a whole period.
    pub rate: f64,
}

/// Path of the excitation to the mass: force or base motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExcitationPath {
    /// A force on the mass.
    Force,
    /// A base that shakes spring and damper.
    Base,
}

/// Mean of a period.
pub fn mean(pieces: &[WaveSegment]) -> f64 {
    let of = |piece: &WaveSegment| {
        let length = piece.to - piece.from;
        let sine = if piece.rate == 0.0 {
            0.0
        } else {
            piece.sine * 2.0 * (piece.rate * length / 2.0).sin().powi(2) / piece.rate
        };
        piece.value * length + piece.slope * length * length / 2.0 + sine
    };
    pieces.iter().map(of).sum()
}

/// Cosine and sine coefficient of the `n`th harmonic, `n ≥ 1`: `aₙ = 2∫u cos 2πns ds`, `bₙ = 2∫u sin 2πns ds`.
/// S. S. Rao, *Mechanical Vibrations*, 5th ed., §1.11.
pub fn harmonic(pieces: &[WaveSegment], n: u32) -> (f64, f64) {
    let theta = TAU * f64::from(n);
    let turned = |angle: f64| Complex::from_polar(1.0, -angle);
    let of = |piece: &WaveSegment| {
        let length = piece.to - piece.from;
        // By parts, with the whole turns of the angle left out for the sake of its digits.
        let start = turned(TAU * (f64::from(n) * piece.from).fract());
        let end = turned(TAU * (f64::from(n) * piece.to).fract());
        let last = piece.value + piece.slope * length;
        let straight = Complex::i() / theta * (end * last - start * piece.value)
            + (end - start) * (piece.slope / (theta * theta));
        let wave = |rate: f64| {
            // ∫ e^(i rate σ) dσ = length e^(i x) sin x/x with x = rate·length/2.
            let x = rate * length / 2.0;
            let sinc = if x.abs() < 1e-8 { 1.0 } else { x.sin() / x };
            Complex::from_polar(length * sinc, x)
        };
        let bent = if piece.sine == 0.0 {
            Complex::ZERO
        } else {
            start * (wave(piece.rate - theta) - wave(-piece.rate - theta)) * piece.sine
                / Complex::new(0.0, 2.0)
        };
        straight + bent
    };
    let sum: Complex<f64> = pieces.iter().map(of).sum();
    (2.0 * sum.re, -2.0 * sum.im)
}

/// The exact steady motion.
#[derive(Clone, Debug)]
pub struct PeriodicResponse {
    damping_ratio: f64,
    /// Radians of the free motion, without damping, in a period.
    angle: f64,
    drive: ExcitationPath,
    pieces: Vec<WaveSegment>,
    /// Displacement and momentum at the beginning of each piece.
    starts: Vec<Vector2<f64>>,
}

impl PeriodicResponse {
    /// The steady motion of an oscillator of a damping ratio, with `angle = ω_n T`.
    ///
    /// `None` where there is none, or none that numbers can hold: undamped with a harmonic at the natural frequency.
    pub fn new(
        pieces: &[WaveSegment],
        drive: ExcitationPath,
        damping_ratio: f64,
        angle: f64,
    ) -> Option<Self> {
        let mut steady = Self {
            damping_ratio,
            angle,
            drive,
            pieces: pieces.to_vec(),
            starts: vec![Vector2::zeros(); pieces.len()],
        };
        if !(angle.is_finite() && angle > 0.0 && damping_ratio.is_finite() && !pieces.is_empty()) {
            return None;
        }
        let end_of = |steady: &Self, begin: Vector2<f64>| {
            (0..steady.pieces.len()).fold(begin, |state, n| steady.advance(n, state, steady.length(n)))
        };
        let driven = end_of(&steady, Vector2::zeros());
        let column = |unit| end_of(&steady, unit) - driven;
        let period = Matrix2::from_columns(&[column(Vector2::x()), column(Vector2::y())]);
        let closing = Matrix2::identity() - period;
        if closing.determinant().abs() < 1e-9 {
            return None;
        }
        // Two equations, by Cramer: the determinant was examined.
        let [a, c, b, d] = [closing.m11, closing.m21, closing.m12, closing.m22];
        let mut state = Vector2::new(d * driven[0] - b * driven[1], a * driven[1] - c * driven[0])
            / closing.determinant();
        for n in 0..steady.pieces.len() {
            steady.starts[n] = state;
            state = steady.advance(n, state, steady.length(n));
        }
        steady.starts.iter().all(|state| state.iter().all(|x| x.is_finite())).then_some(steady)
    }

    /// Displacement at a share of the period, in units of the drive.
    pub fn displacement(&self, share: f64) -> f64 {
        self.at(share)[0]
    }

    /// Velocity at a share of the period, in units of the drive times the natural frequency.
    pub fn velocity(&self, share: f64) -> f64 {
        let (n, since) = self.place(share);
        let [x, p] = self.at(share).into();
        p - 2.0 * self.damping_ratio * (x - self.through(self.drive_at(n, since)))
    }

    /// Mean of the square of the displacement, by quadrature. `None` where the
    /// motion rings through so many radians that they are too many.
    pub fn mean_square(&self) -> Option<f64> {
        let mut sum = 0.0;
        for (n, start) in self.starts.iter().enumerate() {
            let square = |since: f64| self.advance(n, *start, since)[0].powi(2);
            sum += self.edges(n)?.windows(2).map(|edge| integral(square, [edge[0], edge[1]], 1)).sum::<f64>();
        }
        Some(sum)
    }

    /// The largest and the least displacement. `None` as for [`PeriodicResponse::mean_square`].
    pub fn extremes(&self) -> Option<[f64; 2]> {
        /// Samples an eighth of a radian apart miss less than this part of a swing.
        const CLOSE: f64 = 0.01;
        let mut shares = Vec::new();
        for (n, piece) in self.pieces.iter().enumerate() {
            let between =
                |edge: &[f64]| [0.0, 0.25, 0.5, 0.75].map(|part| edge[0] + part * (edge[1] - edge[0]));
            shares.extend(self.edges(n)?.windows(2).flat_map(between).map(|since| piece.from + since));
        }
        let values: Vec<f64> = shares.iter().map(|&share| self.displacement(share)).collect();
        let last = shares.len().checked_sub(1)?;
        let refined = |sign: f64| {
            let of = |n: usize| sign * values[n];
            let best = (0..=last).map(of).fold(f64::NEG_INFINITY, f64::max);
            // Another top may be a little higher than its sample tells.
            let close = best - CLOSE * (best - (0..=last).map(of).fold(f64::INFINITY, f64::min));
            let mut highest = best;
            for n in 0..=last {
                let (before, after) = (if n == 0 { last } else { n - 1 }, if n == last { 0 } else { n + 1 });
                if of(n) < close || of(n) < of(before) || of(n) < of(after) {
                    continue;
                }
                // The velocity changes its sign between the neighbours.
                let mut low = shares[before] - if n == 0 { 1.0 } else { 0.0 };
                let mut high = shares[after] + if n == last { 1.0 } else { 0.0 };
                for _ in 0..60 {
                    let middle = f64::midpoint(low, high);
                    if sign * self.velocity(middle) > 0.0 {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                highest = highest.max(sign * self.displacement(low));
            }
            sign * highest
        };
        Some([refined(1.0), refined(-1.0)])
    }

    /// Shares since the beginning of a piece between which the motion is smooth: half a radian apart while the free
    /// motion that the piece began with lasts, further apart where it does not oscillate, and after it has died as the
    /// drive itself asks.
    fn edges(&self, n: usize) -> Option<Vec<f64>> {
        const MOST: usize = 8000;
        let (length, zeta) = (self.length(n), self.damping_ratio);
        let width = (zeta * zeta - 1.0).max(0.0).sqrt();
        let (fast, slow) = (1.0 + zeta + width, if zeta < 1.0 { zeta } else { 1.0 / (zeta + width) });
        let longest = if zeta < 1.0 { 0.5 } else { 0.5 / slow };
        let (end, mut angle) = (self.angle * length, 0.0);
        let mut edges = vec![0.0];
        while angle < end && slow * angle < 40.0 {
            angle += (0.25 * angle).min(longest).max(0.5 / fast);
            edges.push((angle / self.angle).min(length));
            if edges.len() > MOST {
                return None;
            }
        }
        if angle < end {
            let (from, parts) = (angle / self.angle, (self.pieces[n].rate * 2.0 + 4.0) as u32);
            edges.extend((1..=parts).map(|k| from + (length - from) * f64::from(k) / f64::from(parts)));
        }
        Some(edges)
    }

    fn at(&self, share: f64) -> Vector2<f64> {
        let (n, since) = self.place(share);
        self.advance(n, self.starts[n], since)
    }

    /// The piece at a share of the period, and the share since its beginning.
    fn place(&self, share: f64) -> (usize, f64) {
        let share = share - share.floor();
        let n = self.pieces.partition_point(|piece| piece.from <= share).saturating_sub(1);
        (n, (share - self.pieces[n].from).max(0.0))
    }

    fn length(&self, n: usize) -> f64 {
        self.pieces[n].to - self.pieces[n].from
    }

    fn drive_at(&self, n: usize, since: f64) -> f64 {
        let piece = &self.pieces[n];
        piece.value + piece.slope * since + piece.sine * (piece.rate * since).sin()
    }

    /// The part of the drive that the damper feels.
    fn through(&self, drive: f64) -> f64 {
        match self.drive {
            ExcitationPath::Force => 0.0,
            ExcitationPath::Base => drive,
        }
    }

    /// Displacement and momentum `p = ẋ/ω_n + 2ζ(x − y)`, which a jump of the base leaves as it is, a share of the
    /// period later.
    fn advance(&self, n: usize, state: Vector2<f64>, since: f64) -> Vector2<f64> {
        let zeta = self.damping_ratio;
        let (x0, v0) = (state[0], state[1] - 2.0 * zeta * (state[0] - self.through(self.drive_at(n, 0.0))));
        let (xp0, vp0) = self.particular(n, 0.0);
        let (xp, vp) = self.particular(n, since);
        let (c, s) = free(zeta, self.angle * since);
        let (dx, dv) = (x0 - xp0, v0 - vp0);
        let x = xp + c * dx + s * dv;
        let v = vp - s * dx + (c - 2.0 * zeta * s) * dv;
        Vector2::new(x, v + 2.0 * zeta * (x - self.through(self.drive_at(n, since))))
    }

    /// A motion that satisfies the equation on a piece: displacement, and velocity over the natural frequency.
    fn particular(&self, n: usize, since: f64) -> (f64, f64) {
        let piece = &self.pieces[n];
        let zeta = self.damping_ratio;
        let slope = piece.slope / self.angle;
        let lag = 2.0 * zeta * (slope - self.through(slope));
        let straight = (piece.value + piece.slope * since - lag, slope);
        if piece.sine == 0.0 {
            return straight;
        }
        let r = piece.rate / self.angle;
        let dashpot = self.through(2.0 * zeta * r);
        let ratio = Complex::new(1.0, dashpot) / Complex::new((1.0 - r) * (1.0 + r), 2.0 * zeta * r);
        let turning = ratio * Complex::from_polar(piece.sine, piece.rate * since);
        (straight.0 + turning.im, straight.1 + r * turning.re)
    }
}

/// Free motion after `angle` radians: that of a displacement of one, and that of a velocity of one, for any damping.
fn free(zeta: f64, angle: f64) -> (f64, f64) {
    let square = (1.0 - zeta) * (1.0 + zeta);
    let z = square * angle * angle;
    if z.abs() < 1e-4 {
        let decay = (-zeta * angle).exp();
        let cosine = 1.0 - z / 2.0 * (1.0 - z / 12.0 * (1.0 - z / 30.0));
        let sine = angle * (1.0 - z / 6.0 * (1.0 - z / 20.0 * (1.0 - z / 42.0)));
        (decay * (cosine + zeta * sine), decay * sine)
    } else if square > 0.0 {
        let w = square.sqrt();
        let (sin, cos) = (w * angle).sin_cos();
        let decay = (-zeta * angle).exp();
        (decay * (cos + zeta / w * sin), decay * sin / w)
    } else {
        let width = (-square).sqrt();
        let (slow, fast) = (-1.0 / (zeta + width), -(zeta + width));
        let (e_slow, e_fast) = ((slow * angle).exp(), (fast * angle).exp());
        ((slow * e_fast - fast * e_slow) / (slow - fast), (e_slow - e_fast) / (slow - fast))
    }
}
