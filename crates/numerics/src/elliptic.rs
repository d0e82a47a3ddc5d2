//! Elliptic integrals and functions: the arithmetic–geometric mean, Jacobi's functions, Carlson's symmetric forms.
//!
//! Near the modulus 1 all of them hang on `1 − k²`; what ends in `_of` takes that complement `m₁ = 1 − k²` itself, so
//! that whoever knows it to all its digits loses none.
//!
//! ```
//! use std::f64::consts::PI;
//!
//! use dalembert_numerics::elliptic::{complete, jacobi};
//!
//! // A pendulum swings to an amplitude of 90°: its period is that of small swings times 2 K(sin 45°)/π.
//! let modulus = (PI / 4.0).sin();
//! let quarter = complete(modulus);
//! assert!((2.0 * quarter / PI - 1.180_340_599_016_096).abs() < 1e-14);
//! // sin(θ/2) = k sn u: a quarter of a period after the lowest position it stands at its amplitude, sn = 1 and cn = 0.
//! let (sn, cn, _) = jacobi(quarter, modulus);
//! assert!((sn - 1.0).abs() < 1e-14 && cn.abs() < 1e-14);
//! ```

use std::f64::consts::{FRAC_PI_2, PI};

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
    ellip_k(complement(modulus))
}

/// The same from `m₁ = 1 − k²`; infinite for `m₁ = 0`.
pub fn ellip_k(complement: f64) -> f64 {
    FRAC_PI_2 / agm(1.0, complement.sqrt())
}

/// Jacobi's elliptic functions `(sn, cn, dn)` of argument `u` and modulus `0 ≤ k < 1`, by descending Landen steps.
///
/// Abramowitz and Stegun, §16.4.
pub fn jacobi(u: f64, modulus: f64) -> (f64, f64, f64) {
    jacobi_of(u, complement(modulus))
}

/// The same from `0 ≤ m₁ ≤ 1`, `m₁ = 1 − k²`; hyperbolic functions for `m₁ = 0`.
pub fn jacobi_of(u: f64, complement: f64) -> (f64, f64, f64) {
    if complement <= 0.0 {
        return (u.tanh(), u.cosh().recip(), u.cosh().recip());
    }
    let (sn, cn) = amplitude_of(u, complement).sin_cos();
    (sn, cn, (complement + (1.0 - complement) * cn * cn).sqrt())
}

/// Jacobi's amplitude `φ = am u`, the inverse of [`ellip_f`]; it grows by `π` with every `2 K`.
///
/// Abramowitz and Stegun, §16.4; for `m₁ = 0` Gudermann's function.
pub fn amplitude_of(u: f64, complement: f64) -> f64 {
    const MOST: usize = 32;
    if complement <= 0.0 {
        return 2.0 * (u / 2.0).tanh().atan();
    }
    // c/a of each step, and 1 − (c/a)², which near the modulus 1 is lost in the first.
    let mut ratios = [(0.0, 1.0); MOST];
    let (mut a, mut b) = (1.0, complement.sqrt());
    let mut last = 0;
    while last + 1 < MOST && (a - b).abs() > 2.0 * f64::EPSILON * a {
        let mean = f64::midpoint(a, b);
        ratios[last] = ((a - b) / 2.0 / mean, a * b / (mean * mean));
        b = (a * b).sqrt();
        a = mean;
        last += 1;
    }
    let mut phi = (1u64 << last) as f64 * a * u;
    for (ratio, rest) in ratios[..last].iter().rev() {
        let (sin, cos) = phi.sin_cos();
        let (sin, cos) = (ratio * sin, (rest + (ratio * cos).powi(2)).sqrt());
        phi = f64::midpoint(phi, sin.atan2(cos));
    }
    phi
}

/// Incomplete elliptic integral of the first kind `F = ∫₀^φ dφ/√(1 − k² sin²φ)`, from `m₁ = 1 − k²`.
///
/// Carlson's form; for `m₁ = 0` only `|φ| < π/2` has a finite value.
pub fn ellip_f(amplitude: f64, complement: f64) -> f64 {
    let (turns, rest) = half_turns(amplitude);
    let (sin, cos) = rest.sin_cos();
    let part = sin * carlson_first(cos * cos, cos * cos + complement * sin * sin, 1.0);
    if turns == 0.0 { part } else { 2.0 * turns * ellip_k(complement) + part }
}

/// Incomplete elliptic integral of the third kind `Π = ∫₀^φ dφ/((1 − n sin²φ) √(1 − k² sin²φ))`, from `1 − n > 0` and
/// `m₁ = 1 − k²`.
///
/// Carlson's form, for large negative `n` after the transformation of Abramowitz and Stegun, §17.7.15, which has no
/// differences of near numbers; for `m₁ = 0` only `|φ| < π/2` has a finite value.
pub fn ellip_pi(amplitude: f64, characteristic_complement: f64, complement: f64) -> f64 {
    let (turns, rest) = half_turns(amplitude);
    let of = |angle| ellip_pi_within(angle, characteristic_complement, complement);
    if turns == 0.0 { of(rest) } else { 2.0 * turns * of(FRAC_PI_2) + of(rest) }
}

/// [`ellip_pi`] for an amplitude within a quarter turn.
fn ellip_pi_within(angle: f64, rest: f64, complement: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let (cos_squared, sin_squared) = (cos * cos, sin * sin);
    let y = cos_squared + complement * sin_squared;
    let first = sin * carlson_first(cos_squared, y, 1.0);
    if rest > 2.0 {
        let below = rest - complement;
        let within = ellip_pi_within(angle, complement / rest, complement);
        let steepness = ((rest - 1.0) * below / rest).sqrt();
        return complement * (rest - 1.0) / (rest * below) * within
            + (1.0 - complement) / below * first
            + ((rest - 1.0) / (rest * below)).sqrt() * f64::atan2(steepness * sin * cos, y.sqrt());
    }
    let p = cos_squared + rest * sin_squared;
    first + (1.0 - rest) / 3.0 * sin_squared * sin * carlson_third(cos_squared, y, 1.0, p)
}

/// Carlson's `R_F(x, y, z) = ½ ∫₀^∞ dt/√((t + x)(t + y)(t + z))` of numbers that are not negative and of which one at
/// most is zero.
///
/// B. C. Carlson, *Numerical computation of real or complex elliptic integrals*, Numerical Algorithms 10 (1995), §2.
pub fn carlson_first(x: f64, y: f64, z: f64) -> f64 {
    let start = (x + y + z) / 3.0;
    let far = (3.0 * f64::EPSILON).powf(-1.0 / 6.0)
        * (start - x).abs().max((start - y).abs()).max((start - z).abs());
    let (mut at, mut mean, mut quarter) = ([x, y, z], start, 1.0);
    for _ in 0..MOST_DOUBLINGS {
        if quarter * far < mean.abs() {
            break;
        }
        let [a, b, c] = at.map(f64::sqrt);
        let step = a * b + a * c + b * c;
        at = at.map(|x| (x + step) / 4.0);
        mean = (mean + step) / 4.0;
        quarter /= 4.0;
    }
    let (x, y) = ((start - x) * quarter / mean, (start - y) * quarter / mean);
    let z = -x - y;
    let (second, third) = (x * y - z * z, x * y * z);
    (1.0 - second / 10.0 + third / 14.0 + second * second / 24.0 - 3.0 * second * third / 44.0) / mean.sqrt()
}

/// Carlson's `R_J(x, y, z, p) = 3/2 ∫₀^∞ dt/((t + p) √((t + x)(t + y)(t + z)))` of `p > 0` and numbers that are not
/// negative and of which one at most is zero.
///
/// Carlson, as for [`carlson_first`].
pub fn carlson_third(x: f64, y: f64, z: f64, p: f64) -> f64 {
    let start = (x + y + z + 2.0 * p) / 5.0;
    let far = (f64::EPSILON / 4.0).powf(-1.0 / 6.0)
        * [x, y, z, p].into_iter().map(|x| (start - x).abs()).fold(0.0, f64::max);
    let mut product = (p - x) * (p - y) * (p - z);
    let (mut at, mut mean, mut quarter, mut sum) = ([x, y, z, p], start, 1.0, 0.0);
    for _ in 0..MOST_DOUBLINGS {
        if quarter * far < mean.abs() {
            break;
        }
        let [a, b, c, d] = at.map(f64::sqrt);
        let step = a * b + a * c + b * c;
        let sides = (d + a) * (d + b) * (d + c);
        sum += quarter / sides * carlson_of_one(product / (sides * sides));
        at = at.map(|x| (x + step) / 4.0);
        mean = (mean + step) / 4.0;
        quarter /= 4.0;
        product /= 64.0;
    }
    let [x, y, z] = [x, y, z].map(|x| (start - x) * quarter / mean);
    let p = -(x + y + z) / 2.0;
    let xyz = x * y * z;
    let second = x * y + x * z + y * z - 3.0 * p * p;
    let third = xyz + 2.0 * second * p + 4.0 * p.powi(3);
    let fourth = (2.0 * xyz + second * p + 3.0 * p.powi(3)) * p;
    let fifth = xyz * p * p;
    let series = 1.0 - 3.0 * second / 14.0 + third / 6.0 + 9.0 * second * second / 88.0
        - 3.0 * fourth / 22.0
        - 9.0 * second * third / 52.0
        + 3.0 * fifth / 26.0;
    quarter * series / (mean * mean.sqrt()) + 6.0 * sum
}

/// Each step brings the arguments four times nearer together: enough for the whole range of floating point.
const MOST_DOUBLINGS: u32 = 600;

/// `R_C(1, 1 + e)` for `e > −1`: the inverse tangent, circular or hyperbolic.
fn carlson_of_one(e: f64) -> f64 {
    let root = e.abs().sqrt();
    if root == 0.0 {
        1.0
    } else if e > 0.0 {
        root.atan() / root
    } else {
        root.atanh() / root
    }
}

/// An angle as half turns and what is left of them, at most a quarter turn.
fn half_turns(angle: f64) -> (f64, f64) {
    let turns = (angle / PI).round();
    (turns, angle - turns * PI)
}

fn complement(modulus: f64) -> f64 {
    (1.0 - modulus) * (1.0 + modulus)
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

    /// B. C. Carlson (1995), §3: values printed to fourteen digits.
    #[test]
    fn carlson_forms_are_those_he_printed() {
        let close =
            |ours: f64, printed: f64| assert!((ours / printed - 1.0).abs() < 1e-13, "{ours} {printed}");
        close(carlson_first(1.0, 2.0, 0.0), 1.3110287771461);
        close(carlson_first(2.0, 3.0, 4.0), 0.58408284167715);
        close(carlson_third(0.0, 1.0, 2.0, 3.0), 0.77688623778582);
        close(carlson_third(2.0, 3.0, 4.0, 5.0), 0.14297579667157);
    }

    /// The amplitude undoes the integral of the first kind, over many turns and up to the modulus 1.
    #[test]
    fn the_amplitude_is_the_inverse_of_the_first_integral() {
        for complement in [1.0, 0.5, 1e-3, 1e-8, 1e-14] {
            for n in -40..=40 {
                let u = f64::from(n) * 0.37 + 0.01;
                let back = ellip_f(amplitude_of(u, complement), complement);
                // Near a quarter turn the integral is as steep as 1/√m₁.
                let steep = 1e-15 / jacobi_of(u, complement).2;
                assert!((back - u).abs() < 1e-13 * u.abs() + 10.0 * steep, "{complement} {u} {back}");
            }
        }
        assert!((amplitude_of(0.7, 0.0) - (0.7f64.sinh()).atan()).abs() < 1e-15);
    }

    /// With `k = 0` the third integral is `atan(√(1 − n) tan φ)/√(1 − n)`; else its slope is compared with its integrand.
    #[test]
    fn the_third_integral_is_that_of_its_integrand() {
        for rest in [0.01, 0.5, 1.0, 7.0] {
            let closed = (f64::sqrt(rest) * 1.1f64.tan()).atan() / f64::sqrt(rest);
            assert!((ellip_pi(1.1, rest, 1.0) / closed - 1.0).abs() < 1e-14);
            assert!(
                (ellip_pi(1.1 + 3.0 * PI, rest, 1.0) - closed - 3.0 * PI / f64::sqrt(rest)).abs() < 1e-12
            );
            for (angle, complement) in [(0.3, 0.2), (1.4, 1e-6), (4.0, 0.6), (-9.0, 0.9)] {
                let h = 1e-4;
                let of = |angle| ellip_pi(angle, rest, complement);
                let slope = (8.0 * (of(angle + h) - of(angle - h)) - of(angle + 2.0 * h)
                    + of(angle - 2.0 * h))
                    / (12.0 * h);
                let sine = f64::sin(angle).powi(2);
                let integrand =
                    1.0 / ((1.0 - (1.0 - rest) * sine) * (1.0 - (1.0 - complement) * sine).sqrt());
                assert!((slope / integrand - 1.0).abs() < 1e-8, "{rest} {angle} {complement}");
            }
        }
        // Far below zero, where two large numbers would nearly cancel: π/(2 √(1 − n)) for k = 0.
        for rest in [3.0, 1e6, 4e12] {
            let off = ellip_pi(FRAC_PI_2, rest, 1.0) * f64::sqrt(rest) / FRAC_PI_2 - 1.0;
            assert!(off.abs() < 1e-14, "{rest} {off:e}");
        }
    }
}
