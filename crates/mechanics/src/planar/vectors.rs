//! Vectors of all coordinates: three of each body.

/// The scalar product.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The largest absolute value.
pub(super) fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// The body that moves most in a scaled motion.
pub(super) fn body_that_moves_most(motion: &[f64]) -> usize {
    let bodies: Vec<f64> = motion.chunks_exact(3).map(largest).collect();
    (0..bodies.len()).max_by(|&a, &b| bodies[a].total_cmp(&bodies[b])).unwrap_or(0)
}
