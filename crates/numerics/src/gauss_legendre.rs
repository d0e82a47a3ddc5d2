//! Gauss quadrature over the unit interval, for energies of vibration shapes.
//!
//! ```
//! use std::f64::consts::PI;
//!
//! use dalembert_numerics::gauss_legendre::{integral, legendre};
//!
//! // The generalised mass of a simply supported beam in its first mode is half of its mass: ∫₀¹ sin² πξ dξ = 1/2.
//! assert!((integral(2, |xi| (PI * xi).sin().powi(2)) - 0.5).abs() < 1e-14);
//! // Two points, at (1 ± 1/√3)/2, of weight 1/2.
//! let rule = legendre(2);
//! assert!((rule[0].0 + rule[1].0 - 1.0).abs() < 1e-15);
//! assert!(((rule[1].0 - rule[0].0).abs() - 1.0 / 3_f64.sqrt()).abs() < 1e-15);
//! assert!((rule[0].1 - 0.5).abs() < 1e-15);
//! ```

/// Abscissas and weights of the ten-point rule on `[−1, 1]`, the positive half.
const RULE: [(f64, f64); 5] = [
    (0.148_874_338_981_631_21, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_36),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

/// `∫₀¹ f dξ` by the ten-point Gauss rule on each of `panels` equal parts: exact to degree 19 within each.
pub fn integral(panels: usize, f: impl Fn(f64) -> f64) -> f64 {
    points(panels).map(|(xi, weight)| weight * f(xi)).sum()
}

/// The points of [`integral`] and their weights, which add up to one: pairs `(ξ, weight)`.
pub fn points(panels: usize) -> impl Iterator<Item = (f64, f64)> {
    let half = 0.5 / panels.max(1) as f64;
    (0..panels.max(1)).flat_map(move |panel| {
        let middle = (2 * panel + 1) as f64 * half;
        RULE.into_iter()
            .flat_map(move |(x, w)| [(middle - half * x, w * half), (middle + half * x, w * half)])
    })
}

/// Pairs of points and weights, which add up to one, of the Gauss–Legendre rule with that many points on the unit
/// interval: exact to the degree `2 points − 1`.
pub fn legendre(points: usize) -> Vec<(f64, f64)> {
    let n = points as f64;
    let place = |k: usize| {
        let mut x = (std::f64::consts::PI * (k as f64 + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..8 {
            let (mut before, mut here) = (0.0, 1.0);
            for j in 0..points {
                let j = j as f64;
                (before, here) = (here, ((2.0 * j + 1.0) * x * here - j * before) / (j + 1.0));
            }
            slope = n * (x * here - before) / (x * x - 1.0);
            x -= here / slope;
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..points).map(place).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn polynomials_are_exact() {
        for power in 0..20 {
            let integral = super::integral(3, |xi| xi.powi(power));
            assert!((integral * f64::from(power + 1) - 1.0).abs() < 1e-14, "{power}: {integral}");
        }
        for power in 0..64 {
            let integral: f64 =
                super::legendre(32).into_iter().map(|(xi, weight)| weight * xi.powi(power)).sum();
            assert!((integral * f64::from(power + 1) - 1.0).abs() < 1e-13, "{power}: {integral}");
        }
    }
}
