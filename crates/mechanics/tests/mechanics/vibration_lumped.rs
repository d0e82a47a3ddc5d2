//! Tests of `vibration::lumped`.

use proptest::prelude::*;

use dalembert_mechanics::beam::influence;
use dalembert_mechanics::vibration::lumped::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Discs on a simply supported shaft: Dunkerley ≤ exact ≤ Rayleigh.
    #[test]
    fn bounds_hold(discs in prop::collection::vec((0.05..0.95f64, 0.1..10.0f64), 1..6)) {
        let masses: Vec<f64> = discs.iter().map(|disc| disc.1).collect();
        let coefficient = |x: f64, a: f64| influence::simply_supported(1.0, 1.0, x.min(a), x.max(a));
        let rows: Vec<Vec<f64>> =
            discs.iter().map(|(x, _)| discs.iter().map(|(a, _)| coefficient(*x, *a)).collect()).collect();
        let exact = frequencies(&rows, &masses).unwrap()[0];
        let dunkerley = (0..masses.len()).map(|n| rows[n][n] * masses[n]).sum::<f64>().sqrt().recip();
        let rounds = matrix_iteration(&rows, &masses, 2000);
        prop_assert!(dunkerley <= exact * (1.0 + 1e-12));
        // Every round is a quotient of Rayleigh's, and comes nearer.
        let mut before = f64::INFINITY;
        for round in &rounds {
            prop_assert!(round.frequency >= exact * (1.0 - 1e-12) && round.frequency <= before * (1.0 + 1e-12));
            before = round.frequency;
        }
        prop_assert!((before / exact - 1.0).abs() < 1e-10);
    }
}
