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

    /// Each mode satisfies `x = ω² a m x`, and its frequency the frequency equation; between two of them the determinant
    /// changes its sign.
    #[test]
    fn modes_satisfy_the_equation_of_motion(discs in prop::collection::vec(0.5..2.0f64, 2..6)) {
        let count = discs.len();
        let place = |n: usize| (n + 1) as f64 / (count + 1) as f64;
        let row = |i: usize| (0..count).map(move |j| influence::cantilever(1.0, place(i.min(j)), place(i.max(j))));
        let rows: Vec<Vec<f64>> = (0..count).map(|i| row(i).collect()).collect();
        let found = modes(&rows, &discs).unwrap();
        for (n, mode) in found.iter().enumerate() {
            let square = mode.frequency.powi(2);
            for (i, w) in mode.shape.iter().enumerate() {
                let sum: f64 = (0..count).map(|j| rows[i][j] * discs[j] * mode.shape[j]).sum();
                prop_assert!((square * sum - w).abs() < 1e-8 * square / found[0].frequency.powi(2));
            }
            let scale: f64 =
                found.iter().map(|other| (mode.frequency / other.frequency).powi(2).max(1.0)).product();
            prop_assert!(frequency_determinant(&rows, &discs, mode.frequency).abs() < 1e-9 * scale);
            if let Some(next) = found.get(n + 1) {
                let [before, after] = [mode.frequency, next.frequency]
                    .map(|at| frequency_determinant(&rows, &discs, at * (1.0 + 1e-6)));
                prop_assert!(before * after < 0.0);
            }
        }
    }
}
