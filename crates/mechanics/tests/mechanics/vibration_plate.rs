//! Tests of `vibration::plate`.

use dalembert_mechanics::vibration::plate::*;
use itertools::zip_eq;

/// Roots of the frequency equations of each edge by mpmath, in 30 digits. Leissa's tables 2.1 (clamped) and those of
/// simply supported plates agree to their last place; his table 2.5 of free plates, ν = 0.33, prints 5.253, 9.084 and
/// 12.23, which are off by up to 0.2 %.
#[test]
fn round_plates_by_their_frequency_equations() {
    let numbers: [(Edge, f64, &[f64]); 3] = [
        (Edge::Clamped, 0.3, &[10.2158262299, 21.2603976946, 34.8770354203, 39.7711482365]),
        (Edge::Simple, 0.3, &[4.93514904257, 13.898165073, 25.6132967208, 29.7200047321]),
        (Edge::Free, 0.33, &[5.2620369603, 9.06889866179, 12.243894258]),
    ];
    for (edge, poisson, numbers) in numbers {
        let modes = Round::Plate { edge, poisson }.modes(numbers.len());
        for (mode, number) in zip_eq(&modes, numbers) {
            let ours = mode.root.powi(2);
            assert!((ours / number - 1.0).abs() < 1e-11, "{edge:?}: {ours} {number}");
            let gap = mode.rayleigh_quotient() / mode.root.powi(4) - 1.0;
            assert!(gap.abs() < 1e-11, "{mode:?}: {gap:e}");
        }
    }
}

#[test]
fn drums_by_their_zeros() {
    for mode in Round::Membrane.modes(12) {
        let gap = mode.rayleigh_quotient() / mode.root.powi(2) - 1.0;
        assert!(gap.abs() < 1e-11, "{mode:?}: {gap:e}");
        assert_eq!(mode.circles().len(), mode.place - 1);
    }
}

/// Square plates with ν = 0.3: Leissa, J. Sound Vib. 31 (1973), table 1.
#[test]
fn square_plates_of_leissa() {
    use Edge::{Clamped, Free, Simple};
    for (sides, printed) in [
        ([Simple, Simple], 19.7392),
        ([Simple, Clamped], 23.6463),
        ([Clamped, Clamped], 28.9509),
        ([Clamped, Free], 12.6874),
        ([Simple, Free], 11.6845),
        ([Free, Free], 9.6314),
    ] {
        let plate = Levy { aspect: 1.0, sides, poisson: 0.3 };
        let modes = plate.modes(6).unwrap();
        assert!((modes[0].number - printed).abs() < 0.51e-4, "{sides:?}: {}", modes[0].number);
        for mode in &modes {
            let gap = mode.rayleigh_quotient(1.0) / mode.number.powi(2) - 1.0;
            assert!(gap.abs() < 1e-11, "{sides:?}: {gap:e}");
        }
    }
}

#[test]
fn simply_supported_all_round_has_a_closed_form() {
    let plate = Levy { aspect: 1.7, sides: [Edge::Simple; 2], poisson: 0.3 };
    for mode in plate.modes(8).unwrap() {
        let (m, n) = (mode.half_waves as f64, mode.place as f64);
        let exact = std::f64::consts::PI.powi(2) * (m * m + (1.7 * n).powi(2));
        assert!((mode.number / exact - 1.0).abs() < 1e-12);
    }
}
