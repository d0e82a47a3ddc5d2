//! Tests of `vibration::torsional`.

use dalembert_mechanics::vibration::torsional::*;
use itertools::Itertools as _;

fn chain(inertias: &[f64], stiffnesses: &[f64]) -> Train {
    let shaft = |(at, &stiffness): (usize, &f64)| TrainShaft { ends: [at, at + 1], stiffness };
    let shafts: Vec<TrainShaft> = stiffnesses.iter().enumerate().map(shaft).collect();
    Train::new(inertias, &vec![0.0; inertias.len()], &shafts).expect("the train is complete")
}

fn close(ours: f64, expected: f64, tolerance: f64) {
    assert!((ours - expected).abs() <= tolerance * expected.abs(), "{ours} is not {expected}");
}

#[test]
fn two_discs_by_the_formula() {
    let modes = chain(&[3.0, 1.0], &[12.0]).modes().unwrap();
    assert_eq!(modes.len(), 2);
    close(modes[1].frequency, 4.0, 1e-15);
    close(modes[1].shape[0] / modes[1].shape[1], -1.0 / 3.0, 1e-14);
}

#[test]
fn equal_discs_by_the_formula() {
    // n equal discs on equal shafts, both ends free: ω = 2 √(k/J) sin(iπ/2n).
    let n = 40;
    let modes = chain(&vec![2.0; n], &vec![18.0; n - 1]).modes().unwrap();
    for (i, mode) in modes.iter().enumerate().skip(1) {
        let angle = i as f64 * std::f64::consts::PI / (2 * n) as f64;
        close(mode.frequency, 6.0 * angle.sin(), 1e-13);
        for (at, amplitude) in mode.shape.iter().enumerate() {
            let exact = ((2 * at + 1) as f64 * angle).cos();
            let scale = mode.shape[0] / angle.cos();
            assert!((amplitude - scale * exact).abs() < 1e-9, "{i}: {amplitude}");
        }
    }
}

#[test]
fn a_low_frequency_keeps_its_digits_in_a_stiff_train() {
    // Three stiff shafts in a row with small discs between: nearly two discs on one soft shaft.
    let train = chain(&[1.0, 1e-9, 1e-9, 1.0], &[1e12, 1.0, 1e12]);
    let exact = (2.0f64 / (1.0 + 2e-12) / (1.0 + 1e-9)).sqrt();
    close(train.modes().unwrap()[1].frequency, exact, 1e-11);
}

#[test]
fn a_symmetric_branched_train_has_two_equal_frequencies() {
    let spoke = |end| TrainShaft { ends: [0, end], stiffness: 8.0 };
    let train = Train::new(&[5.0, 2.0, 2.0, 2.0], &[0.0; 4], &[spoke(1), spoke(2), spoke(3)]).unwrap();
    let modes = train.modes().unwrap();
    close(modes[1].frequency, 2.0, 1e-14);
    close(modes[2].frequency, 2.0, 1e-14);
    close(modes[3].frequency, (8.0f64 * (3.0 / 5.0 + 1.0 / 2.0)).sqrt(), 1e-14);
    for (a, first) in modes.iter().enumerate() {
        for second in &modes[..a] {
            let product: f64 =
                (0..4).map(|i| [5.0, 2.0, 2.0, 2.0][i] * first.shape[i] * second.shape[i]).sum();
            assert!(product.abs() < 1e-12, "{product}");
        }
    }
}

#[test]
fn the_holzer_residual_vanishes_at_every_frequency() {
    let train = Train::new(
        &[4.0, 0.0, 7.0, 1.0, 2.0],
        &[0.0; 5],
        &[
            TrainShaft { ends: [0, 1], stiffness: 300.0 },
            TrainShaft { ends: [1, 2], stiffness: 500.0 },
            TrainShaft { ends: [2, 3], stiffness: 100.0 },
            TrainShaft { ends: [2, 4], stiffness: 250.0 },
        ],
    )
    .unwrap();
    let modes = train.modes().unwrap();
    assert_eq!(modes.len(), 4);
    for mode in &modes[1..] {
        assert!(train.residual(mode.frequency).abs() < 1e-11);
        assert!(train.residual(mode.frequency * 1.01).abs() > 1e-4);
        assert_eq!(
            train.count_below(mode.frequency * 1.0001) - train.count_below(mode.frequency * 0.9999),
            1
        );
    }
}

#[test]
fn against_a_wall() {
    let train = Train::new(&[2.0], &[50.0], &[]).unwrap();
    close(train.modes().unwrap()[0].frequency, 5.0, 1e-15);
    close(train.steady(&[10.0], 3.0).unwrap()[0], 10.0 / (50.0 - 18.0), 1e-15);
    assert_eq!(train.steady(&[10.0], 5.0), Err(TrainError::Resonance));
}

/// Numbers spread over `low..high`, different for every seed.
fn spread(seed: u64, count: usize, low: f64, high: f64) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        low + (high - low) * (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count).map(|_| next()).collect()
}

/// A tree of `n` discs: each hangs on an earlier one.
fn tree(seed: u64, n: usize) -> (Vec<f64>, Vec<TrainShaft>) {
    let (inertias, stiffnesses) = (spread(seed, n, 0.5, 20.0), spread(seed + 99, n, 10.0, 1e4));
    let parents = spread(seed + 7, n, 0.0, 1.0);
    let shaft = |disc: usize| TrainShaft {
        ends: [(parents[disc] * disc as f64) as usize, disc],
        stiffness: stiffnesses[disc],
    };
    (inertias, (1..n).map(shaft).collect())
}

#[test]
fn frequencies_are_those_of_the_assembled_matrices() {
    for seed in 1..20 {
        let n = 9;
        let (inertias, shafts) = tree(seed, n);
        let modes = Train::new(&inertias, &vec![0.0; n], &shafts).unwrap().modes().unwrap();
        let mut stiffness = nalgebra::DMatrix::zeros(n, n);
        for &TrainShaft { ends: [a, b], stiffness: k } in &shafts {
            stiffness[(a, a)] += k;
            stiffness[(b, b)] += k;
            stiffness[(a, b)] -= k;
            stiffness[(b, a)] -= k;
        }
        let masses = nalgebra::DMatrix::from_diagonal(&nalgebra::DVector::from_column_slice(&inertias));
        let squares = dalembert_numerics::linalg::generalised_eigenvalues(&stiffness, &masses).unwrap();
        for (mode, square) in modes.iter().zip_eq(squares.iter()) {
            assert!((mode.frequency.powi(2) - square).abs() <= 1e-12 * squares[n - 1]);
        }
        for (a, first) in modes.iter().enumerate() {
            for second in &modes[..a] {
                let dot = |x: &TorsionalMode, y: &TorsionalMode| -> f64 {
                    (0..n).map(|i| inertias[i] * x.shape[i] * y.shape[i]).sum()
                };
                let size = (dot(first, first) * dot(second, second)).sqrt();
                assert!(dot(first, second).abs() <= 1e-12 * size, "{seed}: {}", dot(first, second) / size);
            }
        }
    }
}

#[test]
fn a_stiffer_shaft_never_lowers_a_frequency() {
    for seed in 1..20 {
        let n = 7;
        let (inertias, mut shafts) = tree(seed, n);
        let walls = vec![0.0; n];
        let before = Train::new(&inertias, &walls, &shafts).unwrap().modes().unwrap();
        shafts[seed as usize % (n - 1)].stiffness *= 1.7;
        let after = Train::new(&inertias, &walls, &shafts).unwrap().modes().unwrap();
        for (before, after) in before.iter().zip_eq(&after) {
            assert!(after.frequency >= before.frequency * (1.0 - 1e-14));
        }
    }
}

#[test]
fn forced_amplitudes_meet_equilibrium() {
    // Four discs; the sum of all torques and inertia torques is zero.
    let (inertias, frequency) = ([100.0, 50.0, 10.0, 50.0], 5.0f64);
    let train = chain(&inertias, &[1e4, 1e4, 2e4]);
    let amplitudes = train.steady(&[0.0, 1e4, 0.0, 0.0], frequency).unwrap();
    let all: f64 = amplitudes.iter().zip_eq(&inertias).map(|(x, j)| j * frequency.powi(2) * x).sum();
    close(all, -1e4, 1e-13);
    close(amplitudes[0], -2.06254, 1e-5);
}

#[test]
fn what_is_no_tree_is_refused() {
    let shaft = |a, b| TrainShaft { ends: [a, b], stiffness: 1.0 };
    let free = [0.0; 3];
    let triangle = [shaft(0, 1), shaft(1, 2), shaft(2, 0)];
    assert!(matches!(Train::new(&[1.0; 3], &free, &triangle), Err(TrainError::Loop { .. })));
    assert_eq!(Train::new(&[1.0; 3], &free, &[shaft(0, 1)]), Err(TrainError::Apart { disc: 3 }));
    assert_eq!(Train::new(&[1.0; 3], &free, &[shaft(1, 1)]), Err(TrainError::Ends { shaft: 1 }));
    assert_eq!(Train::new(&[0.0; 3], &free, &[shaft(0, 1), shaft(1, 2)]), Err(TrainError::Massless));
}
