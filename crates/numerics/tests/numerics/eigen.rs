//! Eigenproblems of vibration: full, banded, without symmetry; and complex systems.

use itertools::Itertools as _;
use std::f64::consts::PI;

use dalembert_numerics::linalg::{
    ComplexBand, LinalgError, SymmetricBand, complex_eigen, complex_eigenvalues, generalised_eigen,
    generalised_eigenvalues, lowest_modes, solve_complex,
};
use nalgebra::{Complex, DMatrix, DVector};

use crate::close::{close, found};

/// Numbers between −1 and 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn matrix(&mut self, rows: usize, columns: usize) -> DMatrix<f64> {
        DMatrix::from_fn(rows, columns, |_, _| self.next())
    }
}

/// Stiffness and mass of n masses m on springs k, the first one to the wall.
fn chain(n: usize, m: f64, k: f64) -> (SymmetricBand, SymmetricBand) {
    let mut stiffness = found(SymmetricBand::zeros(n, 1.min(n - 1)));
    for i in 0..n {
        stiffness.add(i, i, if i + 1 < n { 2.0 * k } else { k });
        if i > 0 {
            stiffness.add(i, i - 1, -k);
        }
    }
    (stiffness, found(SymmetricBand::diagonal(&vec![m; n])))
}

fn chain_value(n: usize, m: f64, k: f64, mode: usize) -> f64 {
    let sine = ((2 * mode + 1) as f64 * PI / (2.0 * (2 * n + 1) as f64)).sin();
    4.0 * k / m * sine * sine
}

fn full(band: &SymmetricBand) -> DMatrix<f64> {
    DMatrix::from_fn(band.size(), band.size(), |i, j| band.get(i, j))
}

/// Matrices whose reduced problems are divided, with values that are alike or almost so.
#[test]
fn alike_values_have_orthogonal_modes() {
    let n = 150;
    let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
    // A ring of masses, on ground springs that are alike, almost alike and far apart, and without any coupling.
    let ring = |i: usize, j: usize| match i.abs_diff(j) {
        0 => 2.0,
        1 => -1.0,
        off if off == n - 1 => -1.0,
        _ => 0.0,
    };
    let coupled = DMatrix::from_fn(n, n, |i, j| ring(i, j) + unit(i, j));
    let all = DMatrix::from_fn(n, n, |i, j| 1.0 + unit(i, j));
    let almost = DMatrix::from_fn(n, n, |i, j| 1e-9 * ring(i, j) + unit(i, j) * (1.0 + (i % 3) as f64));
    let glued = DMatrix::from_fn(n, n, |i, j| {
        let across = (i + 1).min(j + 1) % 21 == 0;
        let steep = (i % 21).abs_diff(10) as f64;
        match i.abs_diff(j) {
            0 => steep,
            1 => {
                if across {
                    1e-8
                } else {
                    1.0
                }
            }
            _ => 0.0,
        }
    });
    let alone = DMatrix::from_fn(n, n, |i, j| unit(i, j) * (i / 10) as f64);
    let mass = DMatrix::identity(n, n);
    for k in [coupled, all, almost, glued, alone] {
        let modes = found(generalised_eigen(&k, &mass));
        let products = modes.vectors.tr_mul(&modes.vectors) - &mass;
        assert!(products.amax() < 1e-13, "{:e}", products.amax());
        let off = &k * &modes.vectors - &modes.vectors * DMatrix::from_diagonal(&modes.values);
        assert!(off.amax() < 1e-13 * k.amax() * n as f64, "{:e}", off.amax());
        let sum = modes.values.sum();
        close(sum, k.trace(), 1e-12);
    }
    // The ring: 1 + 4 sin²(π m/n), each twice but the first and the last.
    let modes = found(generalised_eigen(&DMatrix::from_fn(n, n, |i, j| ring(i, j) + unit(i, j)), &mass));
    for (at, value) in modes.values.iter().enumerate() {
        let wave = at.div_ceil(2) as f64;
        close(*value, 1.0 + 4.0 * (PI * wave / n as f64).sin().powi(2), 1e-12);
    }
}

#[test]
fn modes_are_orthogonal_and_satisfy_their_equation() {
    let mut random = Random(7);
    for n in [1, 2, 3, 5, 12, 33] {
        let (a, b) = (random.matrix(n, n), random.matrix(n, n));
        // Units of translations and rotations beside each other.
        let units =
            DMatrix::from_fn(n, n, |i, j| if i == j { 10f64.powi((i % 7) as i32 * 2 - 6) } else { 0.0 });
        let k = &units * (&a * a.transpose() + DMatrix::identity(n, n)) * &units;
        let m = &units * (&b * b.transpose() + DMatrix::identity(n, n)) * &units;
        let (k, m) = ((&k + k.transpose()) / 2.0, (&m + m.transpose()) / 2.0);
        let modes = found(generalised_eigen(&k, &m));
        let alone = found(generalised_eigenvalues(&k, &m));
        let (mass, stiffness) = (
            modes.vectors.transpose() * &m * &modes.vectors,
            modes.vectors.transpose() * &k * &modes.vectors,
        );
        for i in 0..n {
            close(alone[i], modes.values[i], 1e-12);
            assert!(i == 0 || modes.values[i] >= modes.values[i - 1]);
            for j in 0..n {
                let unit = f64::from(u8::from(i == j));
                assert!((mass[(i, j)] - unit).abs() < 1e-12, "n = {n}: {}", mass[(i, j)]);
                let off = (stiffness[(i, j)] - unit * modes.values[i]).abs();
                assert!(off < 1e-11 * modes.values[n - 1], "n = {n}: {off:e}");
            }
        }
    }
}

#[test]
fn a_full_chain_keeps_the_digits_of_its_low_modes() {
    for n in [2, 10, 120] {
        let (k, m) = chain(n, 3.0, 1e6);
        let modes = found(generalised_eigen(&full(&k), &full(&m)));
        close(modes.values[0], chain_value(n, 3.0, 1e6, 0), 1e-13);
        for mode in 0..n {
            close(modes.values[mode], chain_value(n, 3.0, 1e6, mode), 1e-8);
        }
    }
}

#[test]
fn the_lowest_modes_of_a_long_chain_to_thirteen_digits() {
    for (n, count) in [(1, 1), (2, 2), (7, 7), (50, 50), (1000, 10), (6_000, 3)] {
        let (k, m) = chain(n, 0.5, 2e5);
        let modes = found(lowest_modes(&k, &m, count));
        for mode in 0..count {
            close(modes.values[mode], chain_value(n, 0.5, 2e5, mode), 2e-13);
            let x: Vec<f64> = modes.vectors.column(mode).iter().copied().collect();
            let theta = (2 * mode + 1) as f64 * PI / (2 * n + 1) as f64;
            let amplitude = 2.0 / (0.5 * (2 * n + 1) as f64).sqrt();
            let sign = x[0].signum();
            for (i, x) in x.iter().enumerate() {
                let exact = amplitude * ((i + 1) as f64 * theta).sin();
                assert!(
                    (sign * x - exact).abs() < 1e-8 * amplitude,
                    "n = {n}, mode {mode}: {x} is not {exact}"
                );
            }
        }
    }
}

#[test]
fn rigid_and_repeated_modes_are_all_found() {
    // Six equal and separate two-mass systems: every value six times, the first one zero.
    let n = 12;
    let (mut k, m) = (found(SymmetricBand::zeros(n, 1)), found(SymmetricBand::diagonal(&vec![2.0; n])));
    for i in (0..n).step_by(2) {
        k.add(i, i, 8.0);
        k.add(i + 1, i + 1, 8.0);
        k.add(i, i + 1, -8.0);
    }
    let modes = found(lowest_modes(&k, &m, 9));
    for mode in 0..9 {
        if mode < 6 {
            assert_eq!(modes.values[mode], 0.0);
        } else {
            close(modes.values[mode], 8.0, 1e-13);
        }
    }
    let mass = modes.vectors.transpose() * &modes.vectors * 2.0;
    assert!((mass - DMatrix::identity(9, 9)).amax() < 1e-12);
    let full_modes = found(generalised_eigen(&full(&k), &full(&m)));
    assert_eq!(full_modes.values.iter().filter(|value| **value == 0.0).count(), 6);
    // A free chain: 0, then 4k/m sin²(jπ/2n).
    let n = 400;
    let mut free = found(SymmetricBand::zeros(n, 1));
    for i in 1..n {
        free.add(i, i, 0.7);
        free.add(i - 1, i - 1, 0.7);
        free.add(i, i - 1, -0.7);
    }
    let modes = found(lowest_modes(&free, &found(SymmetricBand::diagonal(&vec![1.3; n])), 6));
    assert_eq!(modes.values[0], 0.0);
    for mode in 1..6 {
        close(modes.values[mode], 2.8 / 1.3 * (mode as f64 * PI / (2 * n) as f64).sin().powi(2), 1e-12);
    }
}

#[test]
fn the_lowest_modes_are_resolved_where_ground_springs_bring_them_together() {
    // Masses in rows of `wide` on springs to their neighbours, the first row to the wall, all on ground springs; or as
    // many chains that are not joined across. λ = g + 4 sin²(θ/2) (+ 4 sin²(cπ/2w) across a joined row).
    for (rows, wide, ground, joined) in [
        (3000, 5, 0.3, true),
        (3000, 5, 30.0, true),
        (2000, 1, 3e-4, true),
        (1500, 2, 0.8, false),
        (700, 3, 2.0, false),
    ] {
        let n = rows * wide;
        let mut k = found(SymmetricBand::zeros(n, wide));
        for i in 0..n {
            k.add(i, i, ground + if i < wide { 1.0 } else { 0.0 });
            let across = (joined && i % wide > 0).then_some(1);
            for before in [across, (i >= wide).then_some(wide)].into_iter().flatten() {
                k.add(i, i, 1.0);
                k.add(i - before, i - before, 1.0);
                k.add(i, i - before, -1.0);
            }
        }
        let m = found(SymmetricBand::diagonal(&vec![1.0; n]));
        let modes = found(lowest_modes(&k, &m, 9));
        let repeated = if joined { 1 } else { wide };
        for mode in 0..9 {
            let along = |mode: usize| {
                let theta = (2 * mode + 1) as f64 * PI / (2 * rows + 1) as f64;
                4.0 * (theta / 2.0).sin().powi(2)
            };
            let exact = ground + along(mode / repeated);
            // The entries of K are rounded themselves.
            close(modes.values[mode], exact, 1e-15 * (ground + 4.0) / exact);
            let theta = (2 * (mode / repeated) + 1) as f64 * PI / (2 * rows + 1) as f64;
            // The part of the vector that the modes of this value make up.
            let shares = (0..wide).map(|column| {
                let sine = |row: usize| ((row + 1) as f64 * theta).sin();
                let share: f64 =
                    (0..rows).map(|row| sine(row) * modes.vectors[(row * wide + column, mode)]).sum();
                share / ((2 * rows + 1) as f64 / 4.0).sqrt()
            });
            let shares: Vec<f64> = shares.collect();
            let whole = if joined {
                shares.iter().sum::<f64>().powi(2) / wide as f64
            } else {
                shares.iter().map(|share| share * share).sum()
            };
            let rounding = 1e-14 * (ground + 4.0) / (along(1) - along(0));
            assert!((whole - 1.0).abs() < 1e-12 + rounding.powi(2), "{rows} rows, mode {mode}: {whole}");
        }
        let products = modes.vectors.tr_mul(&modes.vectors) - DMatrix::identity(9, 9);
        assert!(products.amax() < 1e-12, "{rows} rows: orthogonal to {}", products.amax());
    }
}

#[test]
fn a_band_gives_what_the_full_matrices_give() {
    let mut random = Random(3);
    for (n, width) in [(20, 3), (60, 2), (40, 7)] {
        let fill = |random: &mut Random, diagonal: f64| {
            let mut band = found(SymmetricBand::zeros(n, width));
            for i in 0..n {
                band.add(i, i, diagonal + random.next());
                for j in i.saturating_sub(width)..i {
                    band.add(i, j, random.next());
                }
            }
            band
        };
        let (k, m) = (fill(&mut random, 4.0 * width as f64), fill(&mut random, 3.0 * width as f64));
        let (banded, dense) =
            (found(lowest_modes(&k, &m, 6)), found(generalised_eigen(&full(&k), &full(&m))));
        for mode in 0..6 {
            close(banded.values[mode], dense.values[mode], 1e-12);
            let overlap = banded.vectors.column(mode).dot(&(full(&m) * dense.vectors.column(mode)));
            close(overlap.abs(), 1.0, 1e-10);
        }
        assert_eq!(SymmetricBand::of(&full(&k)), Ok(k));
    }
}

#[test]
fn what_has_no_modes_is_named() {
    let one = DMatrix::identity(2, 2);
    let bad = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.5, 1.0]);
    assert!(matches!(
        generalised_eigen(&bad, &one),
        Err(LinalgError::NotSymmetric { row: 1, column: 2, difference }) if (difference - 0.2).abs() < 1e-15
    ));
    for mass in [[1.0, 0.0], [0.0, 0.0], [-1.0, 2.0]] {
        let mass = DMatrix::from_diagonal(&DVector::from_column_slice(&mass));
        assert!(matches!(
            generalised_eigen(&one, &mass),
            Err(LinalgError::NotPositiveDefinite { matrix: "mass", .. })
        ));
    }
    let singular = DMatrix::from_element(2, 2, 3.0);
    assert_eq!(
        generalised_eigen(&one, &singular),
        Err(LinalgError::NotPositiveDefinite { matrix: "mass", row: 2 })
    );
    let band = |diagonal: &[f64]| found(SymmetricBand::diagonal(diagonal));
    assert!(matches!(
        lowest_modes(&band(&[1.0, -2.0]), &band(&[1.0, 1.0]), 1),
        Err(LinalgError::NotPositiveDefinite { matrix: "stiffness", row: 2 })
    ));
    assert!(matches!(lowest_modes(&band(&[1.0]), &band(&[1.0, 1.0]), 1), Err(LinalgError::Shape { .. })));
    assert!(matches!(lowest_modes(&band(&[f64::NAN]), &band(&[1.0]), 1), Err(LinalgError::NotFinite)));
    assert!(matches!(
        SymmetricBand::zeros(1_000_001, 0),
        Err(LinalgError::TooLarge { limit: 1_000_000, .. })
    ));
    let large = DMatrix::zeros(5001, 5001);
    assert!(matches!(generalised_eigen(&large, &large), Err(LinalgError::TooLarge { limit: 5000, .. })));
}

#[test]
fn a_damped_oscillator_has_its_two_roots() {
    // λ = −ζω ± iω√(1−ζ²), the vector (1, λ).
    let (natural, zeta): (f64, f64) = (300.0, 0.1);
    let a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -natural * natural, -2.0 * zeta * natural]);
    let eigen = found(complex_eigen(&a));
    for (at, sign) in [(0, -1.0), (1, 1.0)] {
        close(eigen.values[at].re, -zeta * natural, 1e-13);
        close(eigen.values[at].im, sign * natural * (1.0 - zeta * zeta).sqrt(), 1e-13);
        let ratio = eigen.vectors[(1, at)] / eigen.vectors[(0, at)];
        assert!((ratio - eigen.values[at]).norm() < 1e-12 * natural, "{ratio}");
    }
    let left = found(eigen.left());
    let product = left * &eigen.vectors - DMatrix::identity(2, 2);
    assert!(product.iter().all(|entry| entry.norm() < 1e-13));
    // Critical damping has one vector only.
    let critical = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, -2.0]);
    assert!(matches!(found(complex_eigen(&critical)).left(), Err(LinalgError::Singular { .. })));
}

#[test]
fn eigenvalues_come_back_from_matrices_that_stall_others() {
    let mut random = Random(11);
    for n in [4, 8, 24, 48] {
        let cycle = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from((i + 1) % n == j)));
        for value in found(complex_eigenvalues(&cycle)) {
            close(value.norm(), 1.0, 1e-13);
        }
        let a = random.matrix(n, n);
        let eigen = found(complex_eigen(&a));
        for (value, alone) in eigen.values.iter().zip_eq(found(complex_eigenvalues(&a))) {
            assert!((value - alone).norm() < 1e-12, "{value} is not {alone}");
        }
    }
}

#[test]
fn complex_systems_full_and_banded() {
    let mut random = Random(5);
    for (n, lower, upper) in [(1, 0, 0), (6, 2, 1), (40, 3, 5), (31, 4, 4)] {
        let mut band = found(ComplexBand::zeros(n, lower, upper));
        let mut a = DMatrix::from_element(n, n, Complex::ZERO);
        for i in 0..n {
            for j in i.saturating_sub(lower)..=(i + upper).min(n - 1) {
                let scale = 10f64.powi((i % 5) as i32 * 3);
                let entry = Complex::new(random.next(), random.next()) * scale;
                band.add(i, j, entry);
                a[(i, j)] = entry;
            }
        }
        let x = DMatrix::from_fn(n, 2, |_, _| Complex::new(random.next(), random.next()));
        let b = &a * &x;
        let mut one: Vec<_> = b.column(0).iter().copied().collect();
        found(band.solve(&mut one));
        let both = found(solve_complex(&a, &b));
        for i in 0..n {
            assert!((one[i] - x[(i, 0)]).norm() < 1e-9, "banded {n}: {} is not {}", one[i], x[(i, 0)]);
            for column in 0..2 {
                assert!((both[(i, column)] - x[(i, column)]).norm() < 1e-9, "full {n}");
            }
        }
    }
    let singular = DMatrix::from_element(2, 2, Complex::ONE);
    assert!(matches!(solve_complex(&singular, &singular), Err(LinalgError::Singular { .. })));
    let mut band = found(ComplexBand::zeros(2, 1, 1));
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        band.add(i, j, Complex::ONE);
    }
    assert!(matches!(band.solve(&mut [Complex::ONE; 2]), Err(LinalgError::Singular { .. })));
}
