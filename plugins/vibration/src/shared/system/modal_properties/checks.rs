//! Second methods to what modes have: their stiffness from K, their roots from the equations of the damped system.

use dalembert_core::{Text, Worksheet};
use dalembert_mechanics::vibration::modes::ComplexMode;
use nalgebra::{Complex, DMatrix, DVector};

use crate::shared::system::{Assembled, SystemMatrices, damping::ModalDamping};

/// A modal stiffness, from the stiffness matrix.
pub(super) fn stiffness<W: Worksheet>(
    system: &impl SystemMatrices,
    shape: &DVector<f64>,
    mode: usize,
    stiffness: W::Num,
    sheet: W,
) {
    // Of stiff springs that hardly stretch, little is left.
    let (other, size) = system.stiffness_product(shape);
    sheet.check_sum(
        Text::new("mode {mode}: modal stiffness from the stiffness matrix, φᵀKφ").with("mode", mode),
        stiffness,
        other.into(),
        size,
    );
}

/// Damping ratio and damped frequency of a mode that damping leaves alone: one of the roots of the whole damped system.
/// Near critical damping two roots meet, and are known to half of their digits only.
pub(super) fn root<W: Worksheet>(
    [natural, ratio, damped]: [f64; 3],
    mode: usize,
    all: &[ComplexMode],
    sheet: W,
) {
    let Some(fastest) = all.iter().map(ComplexMode::natural).reduce(f64::max) else { return };
    if ratio * ratio > 0.99 {
        return;
    }
    let root = Complex::new(-ratio * natural, damped);
    let nearest = all.iter().map(|mode| (mode.root - root).norm()).fold(f64::INFINITY, f64::min);
    sheet.check_zero(
        Text::new("mode {mode}: −ζω + iω_d is a root of det(λ²M + λC + K) = 0").with("mode", mode),
        nearest.into(),
        fastest,
    );
}

/// A damped mode, from its natural frequency and damping ratio: its shape obeys the equation of motion.
pub(super) fn complex<W: Worksheet>(
    matrices: (&Assembled<W::Num>, &ModalDamping),
    [natural, ratio, damped]: [f64; 3],
    (place, mode): (usize, &ComplexMode),
    fastest: f64,
    sheet: W,
) {
    let (system, damping) = matrices;
    let turning = ((1.0 - ratio) * (1.0 + ratio)).max(0.0).sqrt();
    let along = |matrix: &DMatrix<f64>| {
        let image = matrix.map(|x| Complex::new(x, 0.0)) * &mode.shape;
        let size = matrix.norm() * mode.shape.norm_squared();
        (mode.shape.dot(&image), size)
    };
    let [(m, m_size), (c, c_size), (k, k_size)] =
        [&system.mass, &damping.physical, &system.stiffness].map(along);
    let left = [damped, natural * turning].map(|turning| {
        let root = Complex::new(-ratio * natural, turning);
        (root * root * m + root * c + k).norm()
    });
    let size = natural * natural * m_size + natural * c_size + k_size;
    // The roots are known to the last places of the fastest one.
    let rounding = 1e-15 * fastest / natural * size;
    sheet.check_residual(
        Text::new("damped mode {place}: powers of inertia, damping and stiffness in its mode shape, vᵀ(λ²M + λC + K)v = 0")
            .with("place", place),
        left[0].max(left[1]).into(),
        size,
        rounding,
    );
}
