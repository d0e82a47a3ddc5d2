//! Absorbers, undamped and damped: closed forms against eigenvalues and against the response itself.

use std::f64::consts::TAU;

use dalembert_mechanics::vibration::absorber::{self, AbsorberError, DampedAbsorber};
use dalembert_numerics::linalg;
use nalgebra::DMatrix;
use proptest::prelude::*;

use crate::{close::close, sdof};

fn optimum(mass_ratio: f64) -> DampedAbsorber {
    let root = absorber::least_peak_root(mass_ratio);
    let tuning = absorber::least_peak_tuning(root);
    let damping = tuning * absorber::least_peak_damping(mass_ratio, root);
    DampedAbsorber { mass_ratio, main_damping: 0.0, tuning, damping }
}

fn largest(absorber: DampedAbsorber) -> f64 {
    absorber.largest_peak().expect("a damped system has a peak").height
}

/// The formulas as they are printed, before their common factors are taken out.
#[test]
fn least_peak_as_printed() {
    for mu in [0.01f64, 0.05, 0.3, 1.0, 4.0] {
        let s = (4.0 + 3.0 * mu).sqrt();
        let tuning = 2.0 / (1.0 + mu)
            * (2.0 * (16.0 + 23.0 * mu + 9.0 * mu * mu + 2.0 * (2.0 + mu) * s)
                / (3.0 * (64.0 + 80.0 * mu + 27.0 * mu * mu)))
                .sqrt();
        let damping = ((8.0 + 9.0 * mu - 4.0 * s) / (1.0 + mu)).sqrt() / 4.0;
        let height = (((8.0 + 9.0 * mu).powi(2) * (16.0 + 9.0 * mu) - 128.0 * s.powi(3))
            / (3.0 * (32.0 + 27.0 * mu)))
            .sqrt()
            / (3.0 * mu);
        let root = absorber::least_peak_root(mu);
        close(absorber::least_peak_tuning(root), tuning, 1e-12);
        close(absorber::least_peak_damping(mu, root), damping, 1e-11);
        close(absorber::least_peak_height(mu, root), height, 1e-10);
    }
}

/// With a light absorber, the fixed-point formulas are the least peak; the gap shrinks with μ itself.
#[test]
fn fixed_points_are_the_limit_of_the_least_peak() {
    for mu in [1e-5, 1e-4, 1e-3] {
        let root = absorber::least_peak_root(mu);
        close(absorber::den_hartog_tuning(mu), absorber::least_peak_tuning(root), mu);
        close(absorber::den_hartog_damping(mu), absorber::least_peak_damping(mu, root), mu);
        close(absorber::fixed_point_height(mu), absorber::least_peak_height(mu, root), mu);
    }
}

#[test]
fn no_least_peak_outside_its_range() {
    assert!(matches!(absorber::least_peak(0.0, 0.1), Err(AbsorberError::Range { .. })));
    assert!(matches!(absorber::least_peak(0.1, 1.0), Err(AbsorberError::Range { .. })));
    assert!(matches!(absorber::least_peak(0.1, f64::NAN), Err(AbsorberError::Range { .. })));
    assert!(matches!(absorber::least_peak(0.01, 0.9), Err(AbsorberError::NoPeaks { .. })));
}

proptest! {
    /// The closed formula of the two resonances, against the eigenvalues of the two masses.
    #[test]
    fn resonances_are_eigenvalues(mu in 1e-4f64..10.0, f in 0.1f64..5.0) {
        let (s, d) = (absorber::resonance_sum(f, mu), absorber::resonance_difference(f, mu));
        let k_a = mu * f * f;
        let stiffness = DMatrix::from_row_slice(2, 2, &[1.0 + k_a, -k_a, -k_a, k_a]);
        let mass = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, mu]);
        let squares = linalg::generalised_eigenvalues(&stiffness, &mass).unwrap();
        let upper = f64::midpoint(s, d);
        close(upper, squares[1].sqrt(), 1e-12);
        close(f / upper, squares[0].sqrt(), 1e-11);
        for g in [upper, f / upper] {
            close(absorber::mass_ratio_of_resonance(g / f, f), mu, 1e-8);
        }
        close(absorber::mass_ratio_of_split(1.0 / upper, upper / f), mu, 1e-8);
    }

    /// At the frequency of an undamped absorber the main mass is at rest.
    #[test]
    fn the_main_mass_is_at_rest(mu in 1e-4f64..10.0, f in 0.1f64..5.0) {
        let undamped = DampedAbsorber { mass_ratio: mu, main_damping: 0.0, tuning: f, damping: 0.0 };
        prop_assert_eq!(undamped.magnification(f), 0.0);
        close(undamped.relative_motion(f), 1.0 / (mu * f * f), 1e-10);
    }

    /// At a fixed point every damping gives the same magnification, and the two dampings that make it level there
    /// have the mean square of the formula.
    #[test]
    fn fixed_points(mu in 1e-3f64..5.0, gamma in 0.0f64..10.0) {
        let tuning = absorber::den_hartog_tuning(mu);
        let mean = absorber::fixed_points_mean(mu, tuning);
        let half = absorber::fixed_points_half_difference(mu, tuning, mean);
        let mut level = 0.0;
        for u in [mean - half, mean + half] {
            let any = DampedAbsorber { mass_ratio: mu, main_damping: 0.0, tuning, damping: gamma };
            close(any.magnification(u.sqrt()), absorber::fixed_point_height(mu), 1e-8);
            close(absorber::magnification_as_one(mu, u.sqrt()), absorber::fixed_point_height(mu), 1e-9);
            let square = absorber::level_damping_squared(mu, tuning, u);
            let here = DampedAbsorber { damping: square.sqrt(), ..any };
            let nearest = here.peaks().into_iter().map(|peak| (peak.ratio - u.sqrt()).abs()).fold(1.0, f64::min);
            prop_assert!(nearest < 1e-5, "no peak at the fixed point");
            level += square / 2.0;
        }
        let damping = tuning * absorber::den_hartog_damping(mu);
        close(level.sqrt(), damping, 1e-8);
    }

    /// The closed optimum is what its response says, has two equal peaks, and no neighbour has a lower one.
    #[test]
    fn the_closed_optimum_is_the_least_peak(mu in 1e-3f64..5.0, turn in 0.0f64..TAU) {
        let best = optimum(mu);
        let height = absorber::least_peak_height(mu, absorber::least_peak_root(mu));
        let peaks = best.peaks();
        prop_assert_eq!(peaks.len(), 2);
        close(peaks[0].height, height, 1e-9);
        close(peaks[1].height, height, 1e-9);
        for size in [0.001, 0.02] {
            let away = size * mu.sqrt().min(1.0);
            let near = DampedAbsorber {
                tuning: best.tuning * (1.0 + away * turn.cos()),
                damping: best.damping * (1.0 + 10.0 * away * turn.sin()),
                ..best
            };
            prop_assert!(largest(near) >= height * (1.0 - 1e-11), "{} is below {height}", largest(near));
        }
        close(absorber::least_peak(mu, 0.0).unwrap().absorber.tuning, best.tuning, 1e-11);
        close(absorber::least_peak(mu, 0.0).unwrap().absorber.damping, best.damping, 1e-10);
    }

    /// With a damped main system too, no neighbour of the optimum has a lower peak.
    #[test]
    fn the_numeric_optimum_is_the_least_peak(mu in 0.005f64..1.0, zeta in 0.0f64..0.15, turn in 0.0f64..TAU) {
        let best = absorber::least_peak(mu, zeta).unwrap();
        let peaks = best.absorber.peaks();
        close(peaks[0].height, best.height, 1e-9);
        close(peaks[1].height, best.height, 1e-9);
        for size in [0.001, 0.02] {
            let away = size * mu.sqrt();
            let near = DampedAbsorber {
                tuning: best.absorber.tuning * (1.0 + away * turn.cos()),
                damping: best.absorber.damping * (1.0 + 10.0 * away * turn.sin()),
                ..best.absorber
            };
            prop_assert!(largest(near) >= best.height * (1.0 - 1e-11), "{} is below {}", largest(near), best.height);
        }
    }

    /// The viscous absorber without spring: closed form for an undamped main system, least for a damped one.
    #[test]
    fn the_viscous_optimum_is_the_least_peak(mu in 0.01f64..5.0, zeta in 0.0f64..0.15, away in -0.5f64..0.5) {
        let undamped = absorber::least_peak_viscous(mu, 0.0).unwrap();
        close(undamped.height, absorber::viscous_height(mu), 1e-10);
        close(undamped.absorber.damping, absorber::viscous_damping(mu), 1e-10);
        close(undamped.absorber.largest_peak().unwrap().ratio, absorber::viscous_fixed_point(mu), 1e-6);
        let best = absorber::least_peak_viscous(mu, zeta).unwrap();
        let near = DampedAbsorber { damping: best.absorber.damping * (1.0 + away), ..best.absorber };
        prop_assert!(largest(near) >= best.height * (1.0 - 1e-11));
    }

    /// Peaks and the largest relative motion, against a scan.
    #[test]
    fn largest_of_a_scan(mu in 0.01f64..2.0, zeta in 0.0f64..0.3, f in 0.3f64..2.0, gamma in 0.05f64..1.0) {
        let any = DampedAbsorber { mass_ratio: mu, main_damping: zeta, tuning: f, damping: gamma };
        // A peak may be narrower than the steps of the scan: each is examined closely.
        let scan = |of: &dyn Fn(f64) -> f64| {
            let at: Vec<f64> = (0..=8000).map(|n| f64::from(n) * 5e-4).collect();
            let peaks = at.windows(3).filter(|near| of(near[1]) >= of(near[0]).max(of(near[2])));
            peaks.map(|near| of(sdof::largest(of, near[0], near[2]))).fold(0.0, f64::max)
        };
        let motion = any.largest_relative_motion().unwrap().height;
        let scanned = scan(&|g| any.relative_motion(g));
        prop_assert!((scanned / motion - 1.0).abs() < 1e-9);
        let scanned = scan(&|g| any.magnification(g));
        if let Some(peak) = any.largest_peak() {
            prop_assert!((scanned / peak.height - 1.0).abs() < 1e-9);
        } else {
            prop_assert!(scanned <= 1.0);
        }
    }
}
