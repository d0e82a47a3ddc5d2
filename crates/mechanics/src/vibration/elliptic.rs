//! Elliptic integrals and functions by the arithmetic–geometric mean.

use std::f64::consts::FRAC_PI_2;

/// Arithmetic–geometric mean of two positive numbers: the common limit of `(a + b)/2` and `√(a b)`.
///
/// Converges quadratically; zero if one of them is zero. Abramowitz and Stegun, *Handbook of Mathematical Functions*,
/// §17.6.
pub fn agm(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 4.0 * f64::EPSILON * a.abs().max(b.abs()) {
        let next = (f64::midpoint(a, b), a.sqrt() * b.sqrt());
        if next == (a, b) || b == 0.0 {
            break;
        }
        (a, b) = next;
    }
    if b == 0.0 { 0.0 } else { f64::midpoint(a, b) }
}

/// Complete elliptic integral of the first kind `K(k) = ∫₀^{π/2} dφ/√(1 − k² sin²φ)` of the modulus `|k| < 1`.
///
/// Abramowitz and Stegun, §17.6.3: `K = π/(2 agm(1, √(1 − k²)))`.
pub fn complete(modulus: f64) -> f64 {
    FRAC_PI_2 / agm(1.0, ((1.0 - modulus) * (1.0 + modulus)).sqrt())
}

/// Jacobi's elliptic functions `(sn, cn, dn)` of argument `u` and modulus `0 ≤ k < 1`, by descending Landen steps.
///
/// Abramowitz and Stegun, §16.4.
pub fn jacobi(u: f64, modulus: f64) -> (f64, f64, f64) {
    const MOST: usize = 32;
    let (mut a, mut c) = ([1.0; MOST], [modulus; MOST]);
    let mut b = ((1.0 - modulus) * (1.0 + modulus)).sqrt();
    let mut last = 0;
    while c[last].abs() > f64::EPSILON * a[last] && last + 1 < MOST {
        a[last + 1] = f64::midpoint(a[last], b);
        c[last + 1] = (a[last] - b) / 2.0;
        b = (a[last] * b).sqrt();
        last += 1;
    }
    let mut phi = (1u64 << last) as f64 * a[last] * u;
    for n in (1..=last).rev() {
        phi = f64::midpoint(phi, (c[n] / a[n] * phi.sin()).clamp(-1.0, 1.0).asin());
    }
    let (sn, cn) = phi.sin_cos();
    (sn, cn, (1.0 - (modulus * sn).powi(2)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz and Stegun, tables 17.1 and 17.2.
    #[test]
    fn complete_integrals_are_those_of_the_tables() {
        for (modulus_squared, printed) in
            [(0.0, FRAC_PI_2), (0.5, 1.854074677301372), (0.9, 2.578092113348173), (0.99, 3.695637362989875)]
        {
            let off = complete(f64::sqrt(modulus_squared)) / printed - 1.0;
            assert!(off.abs() < 1e-14, "K for m = {modulus_squared} is off by {off:e}");
        }
    }

    /// `sn′ = cn dn`, by a symmetric difference, and `sn(K) = 1`.
    #[test]
    fn jacobi_functions_solve_their_equation() {
        for modulus in [1e-9, 0.1, 0.7, 0.99, 0.999999] {
            assert!((jacobi(complete(modulus), modulus).0 - 1.0).abs() < 1e-14);
            for n in -20..=20 {
                let (u, h) = (f64::from(n) / 7.0, 1e-5);
                let (_, cn, dn) = jacobi(u, modulus);
                let slope = (jacobi(u + h, modulus).0 - jacobi(u - h, modulus).0) / (2.0 * h);
                assert!((slope - cn * dn).abs() < 1e-9, "k = {modulus}, u = {u}");
            }
        }
    }
}
