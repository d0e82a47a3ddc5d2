//! Vectors of all coordinates: three of each body.

/// The scalar product.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The body that moves most in a scaled motion.
pub(super) fn body_that_moves_most(motion: &[f64]) -> usize {
    let size = |body: &[f64]| body.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    let bodies: Vec<f64> = motion.chunks_exact(3).map(size).collect();
    (0..bodies.len()).max_by(|&a, &b| bodies[a].total_cmp(&bodies[b])).unwrap_or(0)
}
