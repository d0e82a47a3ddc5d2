use dalembert_numerics::linalg::complex_eigenvalues;
use dalembert_numerics::polynomial::{PolynomialError, roots};
use itertools::Itertools as _;
use nalgebra::{Complex, DMatrix};
use proptest::prelude::*;

use crate::close::found;

/// Coefficients of `Π (x − zᵢ)`, highest power first.
fn product(roots: &[Complex<f64>]) -> Vec<f64> {
    let mut coefficients = vec![Complex::from(1.0)];
    for root in roots {
        coefficients.push(Complex::from(0.0));
        for i in (1..coefficients.len()).rev() {
            let previous = coefficients[i - 1];
            coefficients[i] -= root * previous;
        }
    }
    coefficients.into_iter().map(|c| c.re).collect()
}

/// The largest distance from any of one set to the nearest of the other, relative to the largest of all.
fn distance(p: &[Complex<f64>], q: &[Complex<f64>]) -> f64 {
    let size = p.iter().chain(q).map(|z| z.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let one_way = |p: &[Complex<f64>], q: &[Complex<f64>]| {
        p.iter().map(|z| q.iter().map(|w| (z - w).norm()).fold(f64::INFINITY, f64::min)).fold(0.0, f64::max)
    };
    assert_eq!(p.len(), q.len());
    one_way(p, q).max(one_way(q, p)) / size
}

#[test]
fn low_degrees_in_closed_form() {
    assert_eq!(found(roots(&[2.0, -6.0])), [Complex::from(3.0)]);
    let pair = found(roots(&[1.0, -2.0, 5.0]));
    assert!(distance(&pair, &[Complex::new(1.0, -2.0), Complex::new(1.0, 2.0)]) < 1e-15);
    assert_eq!(pair[0].conj(), pair[1]);
    let four = found(roots(&[1.0, 0.0, 0.0, 0.0, -1.0]));
    let expected = [(-1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (1.0, 0.0)].map(|(re, im)| Complex::new(re, im));
    assert!(distance(&four, &expected) < 1e-15);
    assert!(found(roots(&[7.0])).is_empty());
    assert_eq!(found(roots(&[0.0, 0.0, 3.0, 0.0, 0.0])), [Complex::from(0.0); 2]);
}

#[test]
fn roots_of_unity_where_the_companion_matrix_stalls() {
    for n in 2..60 {
        let mut coefficients = vec![0.0; n + 1];
        (coefficients[0], coefficients[n]) = (1.0, -1.0);
        let expected: Vec<_> =
            (0..n).map(|k| Complex::from_polar(1.0, std::f64::consts::TAU * k as f64 / n as f64)).collect();
        assert!(distance(&found(roots(&coefficients)), &expected) < 1e-13, "n = {n}");
    }
}

#[test]
fn repeated_roots_are_real_and_as_good_as_their_coefficients() {
    let double = found(roots(&product(&[Complex::from(-3.0); 2])));
    assert!(double.iter().all(|z| z.im == 0.0 && (z.re + 3.0).abs() < 1e-6), "{double:?}");
    let triple = found(roots(&product(&[Complex::from(2.0); 3])));
    assert!(triple.iter().all(|z| (z - 2.0).norm() < 1e-4), "{triple:?}");
}

#[test]
fn moduli_far_apart() {
    let expected = [-1e12, -1e3, -1e-4, 5e-9].map(Complex::from);
    let found = found(roots(&product(&expected)));
    for (ours, root) in found.iter().zip_eq(expected) {
        assert!((ours - root).norm() < 1e-11 * root.norm(), "{ours} for {root}");
    }
    let tiny = crate::close::found(roots(&[1e-300, 0.0, -4e-300]));
    assert!(distance(&tiny, &[Complex::from(-2.0), Complex::from(2.0)]) < 1e-14);
}

#[test]
fn refusals() {
    assert_eq!(roots(&[]), Err(PolynomialError::Zero));
    assert_eq!(roots(&[0.0, 0.0]), Err(PolynomialError::Zero));
    assert_eq!(roots(&[1.0, f64::NAN]), Err(PolynomialError::NotFinite));
    assert_eq!(roots(&[f64::INFINITY, 1.0]), Err(PolynomialError::NotFinite));
}

fn closed_under_conjugation() -> impl Strategy<Value = Vec<Complex<f64>>> {
    let real = prop::collection::vec(-5.0..5.0f64, 0..4);
    let pairs = prop::collection::vec((-5.0..5.0f64, 0.3..5.0f64), 0..4);
    (real, pairs).prop_map(|(real, pairs)| {
        let pairs = pairs.into_iter().flat_map(|(re, im)| [Complex::new(re, im), Complex::new(re, -im)]);
        real.into_iter().map(Complex::from).chain(pairs).collect()
    })
}

fn parted(roots: &[Complex<f64>], by: f64) -> bool {
    (0..roots.len()).all(|i| (0..i).all(|j| (roots[i] - roots[j]).norm() > by))
}

proptest! {
    #[test]
    fn there_and_back(expected in closed_under_conjugation().prop_filter("apart", |z| !z.is_empty() && parted(z, 0.5))) {
        let coefficients = product(&expected);
        let ours = found(roots(&coefficients));
        prop_assert!(distance(&ours, &expected) < 1e-7, "{ours:?} for {expected:?}");
        // Real coefficients again, and the same ones.
        let again = product(&ours);
        let size: f64 = expected.iter().map(|z| 1.0 + z.norm()).product();
        for (p, q) in again.iter().zip_eq(&coefficients) {
            prop_assert!((p - q).abs() <= 1e-11 * size, "{again:?} for {coefficients:?}");
        }
        let reals = |roots: &[Complex<f64>]| roots.iter().filter(|z| z.im == 0.0).count();
        prop_assert_eq!(reals(&ours), reals(&expected));

        let n = expected.len();
        let companion = DMatrix::from_fn(n, n, |i, j| {
            if i == 0 { -coefficients[j + 1] } else { f64::from(u8::from(i == j + 1)) }
        });
        let eigenvalues = found(complex_eigenvalues(&companion));
        prop_assert!(distance(&eigenvalues, &ours) < 1e-6);
    }

    #[test]
    fn any_coefficients_are_answered_or_refused(coefficients in prop::collection::vec(any::<f64>(), 0..9)) {
        if let Ok(roots) = roots(&coefficients) {
            prop_assert!(roots.iter().all(|z| z.re.is_finite() && z.im.is_finite()));
        }
    }
}
