//! Both masses with their springs and dampers in full, and where a response is level.

use nalgebra::Complex;

use super::DampedMass;
use dalembert_mechanics::Real;

/// Masses, springs and dampers.
pub(super) struct InFull {
    mass: f64,
    stiffness: f64,
    damping: f64,
    absorber: f64,
    spring: f64,
    damper: f64,
}

impl InFull {
    /// The main system with an absorber of that spring and damper.
    pub(super) fn of<N: Real>(body: &DampedMass<N>, zeta: f64, spring: f64, damper: f64) -> Self {
        let (stiffness, natural) = (body.stiffness.value(), body.natural.value());
        let mass = stiffness / (natural * natural);
        let damping = 2.0 * zeta * mass * natural;
        Self { mass, stiffness, damping, absorber: body.absorber.value(), spring, damper }
    }

    /// Amplitudes of the main mass and of the absorber relative to it, under a force on the main mass: the equations of
    /// motion of both, the first added to the second.
    pub(super) fn motion(&self, force: f64, frequency: f64) -> [f64; 2] {
        let square = frequency * frequency;
        let own = Complex::new(self.stiffness - self.mass * square, self.damping * frequency);
        let link = Complex::new(self.spring, self.damper * frequency);
        let inertia = self.absorber * square;
        // link·z = inertia·(x + z), own·x − inertia·(x + z) = force
        let above = link - inertia;
        let determinant = own * above - link * inertia;
        [(above * force / determinant).norm(), (force * inertia / determinant).norm()]
    }
}

/// Distance of a response from its stationary point at a peak, relative to the frequency ratio, and the bound of its
/// error by differences of sixth order and rounding. `None` where the peak is too broad to be placed so.
pub(super) fn off_level(response: impl Fn(f64) -> f64, ratio: f64) -> Option<[f64; 2]> {
    let at = |part: f64| response(ratio * (1.0 + part));
    let here = at(0.0);
    let small = 1e-4;
    let bend = (at(small) + at(-small) - 2.0 * here) / (small * small);
    let width = (here / -bend).sqrt();
    if width.is_nan() || width > 1.0 {
        return None;
    }
    let step = 0.005 * width;
    let (mut slope, mut bend) = (0.0, -490.0 * here);
    for (n, odd, even) in [(1.0, 45.0, 270.0), (2.0, -9.0, -27.0), (3.0, 1.0, 2.0)] {
        let [right, left] = [at(n * step), at(-n * step)];
        slope += odd * (right - left);
        bend += even * (right + left);
    }
    let off = slope / (60.0 * step) / (bend / (180.0 * step * step));
    Some([off, 1e-9 * width])
}
