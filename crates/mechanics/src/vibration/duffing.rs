//! Duffing's oscillator `m ẍ + c ẋ + k x + h x³ = F cos ωt`.
//!
//! `h > 0` hardens, `h < 0` softens. Free vibration exactly, by elliptic functions; forced vibration by harmonic balance
//! with the first harmonic (closed) and with the first and third (Newton). Amplitudes are zero to peak.
//! A. H. Nayfeh and D. T. Mook, *Nonlinear Oscillations* (1979), ch. 2 and 4.

use std::{
    f64::consts::{FRAC_PI_2, TAU},
    ops::ControlFlow,
};

use nalgebra::{DMatrix, DVector};

use dalembert_numerics::elliptic::agm;
use dalembert_numerics::{extremes, linalg, roots};

/// Mass, damping, stiffness and the coefficient of the cube.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Duffing {
    /// Mass `m`, kg.
    pub mass: f64,
    /// Damping `c`, N·s/m.
    pub damping: f64,
    /// Stiffness `k`, N/m.
    pub stiffness: f64,
    /// Coefficient of the cube `h`, N/m³.
    pub cubic: f64,
}

/// A steady vibration by the first harmonic: `x = A cos(ωt − φ)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DuffingResponse {
    /// Amplitude, m.
    pub amplitude: f64,
    /// Lag behind the force, rad.
    pub lag: f64,
    /// True if a small disturbance decays: where the required force grows with the amplitude.
    pub stable: bool,
}

/// A steady vibration by the first and third harmonics:
/// `x = a₁ cos ωt + b₁ sin ωt + a₃ cos 3ωt + b₃ sin 3ωt`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoHarmonics {
    /// `a₁, b₁, a₃, b₃`, m.
    pub coefficients: [f64; 4],
}

impl Duffing {
    /// Period of the free undamped vibration of amplitude `A`, s:
    /// `T = 2π/(Ω agm(1, √(1 − κ²)))` with `Ω² = (k + h A²)/m`, `κ² = h A²/(2(k + h A²))`.
    ///
    /// `None` where the motion is no vibration about zero: a softening spring at or beyond `A² = k/|h|`, or no
    /// restoring force.
    pub fn free_period(&self, amplitude: f64) -> Option<f64> {
        let turn = self.stiffness + self.cubic * amplitude * amplitude;
        if turn <= 0.0 || self.stiffness < 0.0 {
            return None;
        }
        let middle = self.stiffness + self.cubic * amplitude * amplitude / 2.0;
        let period = TAU / ((turn / self.mass).sqrt() * agm(1.0, (middle / turn).sqrt()));
        period.is_finite().then_some(period)
    }

    /// The same period by quadrature of `dt = dx/v`, from conservation of energy, with `x = A sin φ`.
    pub fn free_period_by_quadrature(&self, amplitude: f64) -> f64 {
        // The integrand is smooth and periodic, so that equal weights converge faster than any power of the step.
        const POINTS: u32 = 512;
        let rate = |n: u32| {
            let sine = (TAU * f64::from(n) / f64::from(POINTS)).sin();
            let held = self.stiffness + self.cubic * amplitude * amplitude * (1.0 + sine * sine) / 2.0;
            (self.mass / held).sqrt()
        };
        TAU * (0..POINTS).map(rate).sum::<f64>() / f64::from(POINTS)
    }

    /// Frequency of the free vibration by the first harmonic, the backbone: `ω² = (k + ¾ h A²)/m`; `None` where that
    /// is not positive.
    pub fn backbone(&self, amplitude: f64) -> Option<f64> {
        let squared = self.equivalent(amplitude) / self.mass;
        (squared > 0.0).then(|| squared.sqrt())
    }

    /// All steady vibrations by the first harmonic at `ω` under `F`, in ascending amplitude: one or three of
    /// `[(k − m ω² + ¾ h A²)² + (c ω)²] A² = F²`.
    pub fn steady(&self, force: f64, frequency: f64) -> Vec<DuffingResponse> {
        let p = self.stiffness - self.mass * frequency * frequency;
        let (q, r) = (self.damping * frequency, 0.75 * self.cubic);
        // A cubic in s = A²; between its turning points it has one root or none.
        let balance = |s: f64| ((p + r * s).powi(2) + q * q) * s - force * force;
        let slope = |s: f64| (p + r * s) * (p + 3.0 * r * s) + q * q;
        let mut ends = vec![0.0];
        if let Some(turning) = turning_points(3.0 * r * r, 4.0 * p * r, p * p + q * q) {
            ends.extend(turning.into_iter().filter(|s| *s > 0.0));
        }
        let turned = ends[ends.len() - 1];
        let last = (-1000..1000).map(|n| 2f64.powi(n)).find(|s| *s > turned && balance(*s) > 0.0);
        ends.extend(last);
        let root =
            |ends: &[f64]| roots::find(balance, [ends[0], ends[1]], |_| ControlFlow::Continue(())).ok();
        let steady =
            |s: f64| DuffingResponse { amplitude: s.sqrt(), lag: q.atan2(p + r * s), stable: slope(s) > 0.0 };
        ends.windows(2).filter_map(root).filter(|s| *s > 0.0).map(steady).collect()
    }

    /// Largest amplitude of the first harmonic at any frequency, m, and its frequency, rad/s:
    /// `A² [¾ h A² + k − c²/(4m)] = F² m/c²`, `m ω² = k + ¾ h A² − c²/(2m)`.
    ///
    /// `None` without damping, where there is none, or where the damping leaves no peak.
    pub fn peak(&self, force: f64) -> Option<(f64, f64)> {
        let Duffing { mass, damping, stiffness, cubic } = *self;
        let reach = force * force * mass / (damping * damping);
        let (a, b) = (0.75 * cubic, stiffness - damping * damping / (4.0 * mass));
        // a s² + b s = reach: the smaller positive root, without cancellation.
        let squared = 2.0 * reach / (b + (b * b + 4.0 * a * reach).sqrt());
        let frequency = ((self.equivalent(squared.sqrt()) - damping * damping / (2.0 * mass)) / mass).sqrt();
        let found = squared > 0.0 && squared.is_finite() && frequency > 0.0 && frequency.is_finite();
        found.then(|| (squared.sqrt(), frequency))
    }

    /// Jump points as the frequency changes slowly, `(ω, A)` in ascending frequency: the vertical tangents of the
    /// response of the first harmonic. None or two.
    pub fn jumps(&self, force: f64) -> Vec<(f64, f64)> {
        const SAMPLES: u32 = 2000;
        let Some((largest, _)) = self.peak(force) else { return Vec::new() };
        let side = usize::from(self.cubic > 0.0);
        let frequency = |amplitude: f64| self.frequencies_of(force, amplitude)[side];
        // Denser towards the peak, where the last vertical tangent lies.
        let amplitude = |n: f64| largest * (FRAC_PI_2 * n / f64::from(SAMPLES)).sin();
        let turns = |n: f64, sign: f64| {
            let [before, at, after] = [n - 1.0, n, n + 1.0].map(|n| sign * frequency(amplitude(n)));
            before <= at && at > after
        };
        let mut jumps = Vec::new();
        for n in (2..SAMPLES).map(f64::from) {
            for sign in [-1.0, 1.0] {
                if turns(n, sign) {
                    let best = maximum(|n| sign * frequency(amplitude(n)), [n - 1.0, n + 1.0]);
                    jumps.push(self.refined_jump(force, frequency(amplitude(best)), amplitude(best)));
                }
            }
        }
        jumps.sort_by(|a, b| a.0.total_cmp(&b.0));
        jumps
    }

    /// A vertical tangent to the last digit: balance and slope are both zero, by Newton's method in `ω²` and `A²`.
    fn refined_jump(&self, force: f64, frequency: f64, amplitude: f64) -> (f64, f64) {
        let Duffing { mass, damping, stiffness, cubic } = *self;
        let (r, d) = (0.75 * cubic, damping * damping);
        let (mut u, mut s) = (frequency * frequency, amplitude * amplitude);
        for _ in 0..20 {
            let p = stiffness - mass * u;
            let (one, three) = (p + r * s, p + 3.0 * r * s);
            let balance = (one * one + d * u) * s - force * force;
            let slope = one * three + d * u;
            let by_u = (s * (d - 2.0 * mass * one), d - mass * (one + three));
            let slope_by_s = r * three + 3.0 * r * one;
            let determinant = slope * by_u.1 - by_u.0 * slope_by_s;
            let (ds, du) = (
                (balance * by_u.1 - slope * by_u.0) / determinant,
                (slope * slope - balance * slope_by_s) / determinant,
            );
            if !(ds.abs() < 0.1 * s && du.abs() < 0.1 * u) {
                break;
            }
            (s, u) = (s - ds, u - du);
        }
        (u.sqrt(), s.sqrt())
    }

    /// The two frequencies at which the first harmonic has the amplitude `A`, below and above the backbone, rad/s;
    /// NaN where there is none.
    pub fn frequencies_of(&self, force: f64, amplitude: f64) -> [f64; 2] {
        let (equivalent, loss) = (self.equivalent(amplitude), self.damping * self.damping / self.mass);
        let held = equivalent - loss / 2.0;
        // (F/A)² − k² + (k − c²/2m)², in which the squares of k would cancel.
        let needed = (force / amplitude).powi(2) - loss * (equivalent - loss / 4.0);
        [-1.0, 1.0].map(|side: f64| ((held + side * needed.sqrt()) / self.mass).sqrt())
    }

    /// The first and third harmonics at `ω` under `F`, from a steady vibration of the first.
    ///
    /// `None` where Newton's method does not reach a balance of both harmonics.
    pub fn two_harmonics(&self, force: f64, frequency: f64, from: &DuffingResponse) -> Option<TwoHarmonics> {
        let mut x = DVector::from_vec(vec![
            from.amplitude * from.lag.cos(),
            from.amplitude * from.lag.sin(),
            0.0,
            0.0,
        ]);
        let scale = from.amplitude;
        for _ in 0..50 {
            let residual = self.residual(force, frequency, &x);
            let mut jacobian = DMatrix::zeros(4, 4);
            for column in 0..4 {
                let step = 1e-6 * scale;
                let mut moved = [x.clone(), x.clone()];
                moved[0][column] += step;
                moved[1][column] -= step;
                let [up, down] = moved.map(|x| self.residual(force, frequency, &x));
                jacobian.set_column(column, &((up - down) / (2.0 * step)));
            }
            let change = linalg::solve(&jacobian, &residual).ok()?.x;
            x -= &change;
            if change.amax() <= 1e-14 * x.amax() {
                break;
            }
        }
        let found = TwoHarmonics { coefficients: [x[0], x[1], x[2], x[3]] };
        let size = force.abs().max(self.stiffness * scale).max(self.cubic.abs() * scale.powi(3));
        let held = self.residual(force, frequency, &x).amax() <= 1e-10 * size;
        (held && x.iter().all(|x| x.is_finite())).then_some(found)
    }

    /// Residual of the harmonic balance of the first and third harmonics: `cos ωt`, `sin ωt`, `cos 3ωt`, `sin 3ωt`, in
    /// N.
    ///
    /// The cube has harmonics up to the ninth; sixteen equal samples of a period hold its first and third exactly.
    fn residual(&self, force: f64, frequency: f64, x: &DVector<f64>) -> DVector<f64> {
        const SAMPLES: u32 = 16;
        let mut cube = [0.0; 4];
        for n in 0..SAMPLES {
            let basis = harmonics(TAU * f64::from(n) / f64::from(SAMPLES));
            let at: f64 = basis.iter().zip(x.iter()).map(|(basis, x)| basis * x).sum();
            for (sum, basis) in cube.iter_mut().zip(basis) {
                *sum += 2.0 / f64::from(SAMPLES) * at.powi(3) * basis;
            }
        }
        let line = |harmonic: f64, a: f64, b: f64| {
            let (held, damped) = (
                self.stiffness - self.mass * (harmonic * frequency).powi(2),
                self.damping * harmonic * frequency,
            );
            (held * a + damped * b, held * b - damped * a)
        };
        let (first, third) = (line(1.0, x[0], x[1]), line(3.0, x[2], x[3]));
        DVector::from_vec(vec![
            first.0 + self.cubic * cube[0] - force,
            first.1 + self.cubic * cube[1],
            third.0 + self.cubic * cube[2],
            third.1 + self.cubic * cube[3],
        ])
    }

    /// Equivalent stiffness of the first harmonic, `k + ¾ h A²`, N/m.
    pub fn equivalent(&self, amplitude: f64) -> f64 {
        self.stiffness + 0.75 * self.cubic * amplitude * amplitude
    }
}

impl TwoHarmonics {
    /// Displacement at the phase `ωt`, m.
    pub fn displacement(&self, phase: f64) -> f64 {
        harmonics(phase).iter().zip(self.coefficients).map(|(basis, x)| basis * x).sum()
    }

    /// Largest displacement, m.
    pub fn amplitude(&self) -> f64 {
        const PLACES: u32 = 72;
        let places: Vec<f64> = (0..=PLACES + 1).map(|n| TAU * f64::from(n) / f64::from(PLACES)).collect();
        extremes::largest(|phase| self.displacement(phase), &places).map_or(0.0, |top| top.value)
    }

    /// Amplitudes of the first and of the third harmonic, m.
    pub fn amplitudes(&self) -> [f64; 2] {
        let [a, b, c, d] = self.coefficients;
        [a.hypot(b), c.hypot(d)]
    }
}

/// Argument of the maximum of a unimodal function, by golden-section search.
fn maximum(function: impl Fn(f64) -> f64, [mut from, mut to]: [f64; 2]) -> f64 {
    let share = f64::midpoint(-1.0, 5f64.sqrt());
    while to - from > 1e-9 {
        let (a, b) = (to - share * (to - from), from + share * (to - from));
        if function(a) > function(b) { to = b } else { from = a }
    }
    f64::midpoint(from, to)
}

/// The two real roots of `a s² + b s + c`, ascending; `None` where there are none.
fn turning_points(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let inside = b * b - 4.0 * a * c;
    if a == 0.0 || inside.is_nan() || inside <= 0.0 {
        return None;
    }
    let larger = -(b + b.signum() * inside.sqrt()) / 2.0;
    let [one, other] = [larger / a, c / larger];
    Some([one.min(other), one.max(other)])
}

fn harmonics(phase: f64) -> [f64; 4] {
    [phase.cos(), phase.sin(), (3.0 * phase).cos(), (3.0 * phase).sin()]
}

/// `(t, x)` of the free undamped vibration from rest at `amplitude` over one `period`, by the fourth-order method of
/// Runge and Kutta, for a curve.
pub fn free_motion(oscillator: &Duffing, amplitude: f64, period: f64, points: u32) -> Vec<(f64, f64)> {
    const SUBSTEPS: u32 = 8;
    let acceleration = |x: f64| -(oscillator.stiffness * x + oscillator.cubic * x * x * x) / oscillator.mass;
    let h = period / f64::from(points * SUBSTEPS);
    let (mut x, mut v) = (amplitude, 0.0);
    let mut motion = vec![(0.0, x)];
    for n in 1..=points {
        for _ in 0..SUBSTEPS {
            let (k1, l1) = (v, acceleration(x));
            let (k2, l2) = (v + h / 2.0 * l1, acceleration(x + h / 2.0 * k1));
            let (k3, l3) = (v + h / 2.0 * l2, acceleration(x + h / 2.0 * k2));
            let (k4, l4) = (v + h * l3, acceleration(x + h * k3));
            x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            v += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
        }
        motion.push((period * f64::from(n) / f64::from(points), x));
    }
    motion
}
