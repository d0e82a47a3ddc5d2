//! Transient from rest under a harmonic drive: `ẍ + 2ζω_n ẋ + ω_n² x = ω_n² (s sin ωt + c cos ωt)`.
//!
//! Written as `ṡ = A s` with the harmonic as part of the state, the motion is `e^(At) s₀`: exact for every damping,
//! critical damping and undamped resonance included.

use nalgebra::{Matrix4, Vector4};

/// The most radians, of the free motion and of the harmonic together, that a history spans.
const LONGEST: f64 = 1e5;

/// Harmonic drive of the oscillator, as its static deflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarmonicDrive {
    /// Frequency `ω`, rad/s.
    pub frequency: f64,
    /// Amplitude of the sine, m.
    pub sine: f64,
    /// Amplitude of the cosine, m.
    pub cosine: f64,
}

/// The motion from rest at `count + 1` equally spaced times from zero to `last`: time in s, displacement in m.
///
/// `None` where the numbers are not finite or the time spans more than a hundred thousand radians, over which the
/// rounding of the exponential would show.
pub fn history(
    natural_frequency: f64,
    damping_ratio: f64,
    drive: HarmonicDrive,
    last: f64,
    count: u16,
) -> Option<Vec<(f64, f64)>> {
    let step = last / f64::from(count.max(1));
    let r = drive.frequency / natural_frequency;
    // In radians of the free motion: the state is x, ẋ/ω_n, sin ωt, cos ωt.
    let angle = natural_frequency * step;
    let span = (1.0 + r + 2.0 * damping_ratio) * natural_frequency * last;
    let finite = [span, r, drive.sine, drive.cosine, last].iter().all(|x| x.is_finite());
    if !finite || span > LONGEST || step <= 0.0 {
        return None;
    }
    #[rustfmt::skip]
    let system = Matrix4::new(
         0.0,  1.0,                  0.0,         0.0,
        -1.0, -2.0 * damping_ratio,  drive.sine,  drive.cosine,
         0.0,  0.0,                  0.0,         r,
         0.0,  0.0,                 -r,           0.0,
    );
    // The size of the drive must not decide how finely the exponential is cut.
    let size = drive.sine.abs().max(drive.cosine.abs());
    let mut unit = system;
    if size > 0.0 {
        unit[(1, 2)] /= size;
        unit[(1, 3)] /= size;
    }
    let advance = exponential(unit * angle);
    let mut state = Vector4::new(0.0, 0.0, 0.0, 1.0);
    let mut motion = Vec::with_capacity(usize::from(count) + 1);
    for n in 0..=count {
        motion.push((step * f64::from(n), size * state[0]));
        state = advance * state;
    }
    motion.iter().all(|(t, x)| t.is_finite() && x.is_finite()).then_some(motion)
}

/// `e^A` by its series after halving, and squaring back. For finite entries.
fn exponential(matrix: Matrix4<f64>) -> Matrix4<f64> {
    let halvings = (4.0 * matrix.abs().row_sum().max()).max(1.0).log2().ceil() as i32;
    let small = matrix * 0.5f64.powi(halvings);
    // With entries that add up to a quarter in a row, sixteen terms leave 1e-24.
    let series =
        (1..=16u8).rev().fold(Matrix4::identity(), |sum, n| Matrix4::identity() + small * sum / f64::from(n));
    (0..halvings).fold(series, |power, _| power * power)
}
