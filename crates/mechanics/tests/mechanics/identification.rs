use dalembert_mechanics::identification::{self, FitError, fit_receptance, measured_peak};
use dalembert_mechanics::sdof;
use proptest::prelude::*;

use crate::close::{close, found, printed};

/// The suspension of list 06: static 2e-4 m/N, peak 1.6e-3 m/N at 12 rad/s.
const STATIC: f64 = 2e-4;
const PEAK: f64 = 1.6e-3;
const PEAK_FREQUENCY: f64 = 12.0;

/// `n` points of a response between two shares of its natural frequency.
fn response(k: f64, m: f64, c: f64, [from, to]: [f64; 2], n: u32) -> Vec<(f64, f64)> {
    let natural = sdof::natural_frequency(k, m);
    let at = |i: u32| {
        let frequency = natural * (from + (to - from) * f64::from(i) / f64::from(n - 1));
        (frequency, sdof::receptance(k, m, c, frequency))
    };
    (0..n).map(at).collect()
}

#[test]
fn suspension_of_list_06() {
    let mass = identification::mass_from_peak_and_point(PEAK, PEAK_FREQUENCY, STATIC, 0.0);
    let stiffness = identification::stiffness_from_mass_and_peak(mass, PEAK, PEAK_FREQUENCY);
    let damping = identification::damping_from_mass_and_peak(mass, stiffness, PEAK, PEAK_FREQUENCY);
    printed(mass, 34.45, 2);
    printed(stiffness, 5000.0, 6);
    printed(damping, 51.98, 2);
}

#[test]
fn a_response_without_damping_has_no_fit_below_zero() {
    let points = response(5000.0, 34.0, 0.0, [0.2, 0.9], 12);
    let fit = found(fit_receptance(&points));
    close(fit.stiffness, 5000.0, 1e-9);
    assert!(fit.damping < 1e-3 * sdof::critical_damping(5000.0, 34.0));
}

#[test]
fn what_is_no_response_is_refused() {
    let point = |receptance| fit_receptance(&[(1.0, 1e-3), (2.0, receptance), (3.0, 1e-3)]);
    for wrong in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        assert!(matches!(point(wrong), Err(FitError::Point { .. })), "{wrong}");
    }
    assert!(matches!(
        fit_receptance(&[(1.0, 1e-3), (1.0, 1e-3), (2.0, 1e-3)]),
        Err(FitError::Undetermined(_))
    ));
    // 1/H² over ω² is a parabola that opens upwards and stays above zero.
    let parabola = |y: fn(f64) -> f64| -> Vec<_> {
        (1..9).map(|i| f64::from(i) * 0.08).map(|s| (s.sqrt(), 1.0 / y(s).sqrt())).collect()
    };
    assert_eq!(fit_receptance(&parabola(|s| 1.0 - s * s)), Err(FitError::NotAnOscillator));
    assert_eq!(fit_receptance(&parabola(|s| (1.0 - s).powi(2) - 0.05 * s)), Err(FitError::NegativeDamping));
}

#[test]
fn a_peak_has_lower_points_on_both_sides() {
    assert_eq!(measured_peak(&[]), None);
    assert_eq!(measured_peak(&[(1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]), None);
    assert_eq!(measured_peak(&[(1.0, 3.0), (2.0, 2.0), (3.0, 1.0)]), None);
    assert_eq!(
        measured_peak(&[(1.0, 1.0), (2.0, 1.2), (3.0, 1.0)]).map(|peak| peak.half_power),
        Some([None, None])
    );
}

proptest! {
    #[test]
    fn the_fit_of_an_exact_response_is_its_system(
        k in 1e2..1e8f64, m in 1e-2..1e4f64, zeta in 0.005..0.6f64,
    ) {
        let c = sdof::damping_from_ratio(zeta, k, m);
        let fit = found(fit_receptance(&response(k, m, c, [0.3, 1.8], 40)));
        close(fit.stiffness, k, 1e-7);
        close(fit.mass, m, 1e-7);
        close(fit.damping, c, 1e-5);
        prop_assert!(fit.misfit < 1e-8);
    }

    #[test]
    fn the_vertex_of_an_exact_response_is_its_peak(k in 1e2..1e8f64, m in 1e-2..1e4f64, zeta in 0.02..0.5f64) {
        let c = sdof::damping_from_ratio(zeta, k, m);
        let peak = measured_peak(&response(k, m, c, [0.1, 1.9], 60)).expect("the peak is inside");
        close(peak.frequency, sdof::natural_frequency(k, m) * sdof::magnification_peak_ratio(zeta), 1e-7);
        close(peak.receptance, sdof::peak_magnification(zeta) / k, 1e-7);
    }

    #[test]
    fn half_power_points_give_the_system(k in 1e2..1e8f64, m in 1e-2..1e4f64, zeta in 0.001..0.38f64) {
        let natural = sdof::natural_frequency(k, m);
        let [lower, upper] =
            [sdof::lower_half_power_ratio(zeta), sdof::upper_half_power_ratio(zeta)].map(|r| r * natural);
        let height = sdof::peak_magnification(zeta) / k;
        let mass = identification::mass_from_half_power(height, lower, upper);
        let frequency = identification::peak_between_half_power(lower, upper);
        close(mass, m, 1e-9);
        close(frequency, natural * sdof::magnification_peak_ratio(zeta), 1e-9);
        let stiffness = identification::stiffness_from_mass_and_peak(mass, height, frequency);
        close(stiffness, k, 1e-9);
        let damping = identification::damping_from_mass_and_peak(mass, stiffness, height, frequency);
        close(damping, sdof::damping_from_ratio(zeta, k, m), 1e-9);
    }
}
