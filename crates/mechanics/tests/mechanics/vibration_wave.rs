//! Tests of `vibration::wave`.

use std::f64::consts::PI;

use itertools::Itertools as _;
use proptest::prelude::*;

use dalembert_mechanics::vibration::wave::*;

fn close(ours: f64, expected: f64) {
    assert!((ours - expected).abs() <= 1e-12 * expected.abs().max(1e-3), "{ours} is not {expected}");
}

#[test]
fn plain_ends_have_multiples_of_a_quarter_wave() {
    for (ends, quarters) in [
        ([WaveEnd::FIXED, WaveEnd::FIXED], [2.0, 4.0, 6.0]),
        ([WaveEnd::FREE, WaveEnd::FREE], [2.0, 4.0, 6.0]),
        ([WaveEnd::FIXED, WaveEnd::FREE], [1.0, 3.0, 5.0]),
        ([WaveEnd::FREE, WaveEnd::FIXED], [1.0, 3.0, 5.0]),
    ] {
        for (root, quarter) in roots(ends, 3).unwrap().into_iter().zip_eq(quarters) {
            close(root, quarter * PI / 2.0);
        }
    }
}

#[test]
fn a_mass_at_the_end_by_the_classical_equation() {
    // β tan β = 1/μ (Rao §8.3): β₁ = 0.8603336 for μ = 1.
    let ends = [WaveEnd::FIXED, WaveEnd { stiffness: 0.0, mass: 1.0 }];
    let found = roots(ends, 8).unwrap();
    close(found[0], 0.860333589019380);
    for root in found {
        assert!((root * root.sin() - root.cos()).abs() < 1e-13 * root, "{root}");
    }
    // A very heavy end on a light rod: β² → 1/μ.
    let heavy = roots([WaveEnd::FIXED, WaveEnd { stiffness: 0.0, mass: 1e8 }], 2).unwrap();
    assert!((heavy[0] - 1e-4).abs() < 1e-12, "{}", heavy[0]);
    assert!((heavy[1] - PI).abs() < 1e-8, "{}", heavy[1]);
}

proptest! {
    #[test]
    fn roots_ascend_and_satisfy_equation_and_energy(
        k in prop::array::uniform2(-3.0..4.0f64), m in prop::array::uniform2(-3.0..3.0f64),
    ) {
        let end = |n: usize| WaveEnd { stiffness: 10f64.powf(k[n]), mass: 10f64.powf(m[n]) };
        let ends = [end(0), end(1)];
        let found = roots(ends, 8).unwrap();
        for pair in found.windows(2) {
            prop_assert!(pair[1] > pair[0]);
        }
        let shapes: Vec<WaveShape> = found.iter().map(|root| shape(ends, *root)).collect();
        for (n, (root, shape)) in found.iter().zip_eq(&shapes).enumerate() {
            let quotient = shape.rayleigh_quotient(ends);
            prop_assert!((quotient / root.powi(2) - 1.0).abs() < 1e-9, "{} {}", quotient, root.powi(2));
            for other in &shapes[..n] {
                let size = (shape.inertia_product(shape, ends) * other.inertia_product(other, ends)).sqrt();
                prop_assert!(shape.inertia_product(other, ends).abs() < 1e-10 * size);
            }
        }
    }

    #[test]
    fn a_stiffer_end_never_lowers_a_frequency(k in -3.0..4.0f64, more in 0.0..2.0f64, m in 0.0..3.0f64) {
        let ends = |k: f64| [WaveEnd { stiffness: 10f64.powf(k), mass: m }, WaveEnd { stiffness: 0.0, mass: 0.3 }];
        let (soft, stiff) = (roots(ends(k), 6).unwrap(), roots(ends(k + more), 6).unwrap());
        for (soft, stiff) in soft.iter().zip_eq(stiff) {
            prop_assert!(stiff >= soft * (1.0 - 1e-12));
        }
    }
}
