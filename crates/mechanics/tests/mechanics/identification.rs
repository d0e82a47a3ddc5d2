use std::f64::consts::TAU;

use dalembert_mechanics::identification::modal::{
    Complex, DampingModel, MeasuredResponse, ModalError, ModalFit, Residuals, ResponsePoint, circle_fit,
    modal_fit,
};
use dalembert_mechanics::identification::{self, FitError, fit_receptance, measured_peak};
use dalembert_mechanics::sdof;
use proptest::prelude::*;

use crate::close::{ROUNDING, close, found, printed};

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

/// Points of `A/(ω_n² − ω² + i d) + R − S/ω²`, as what was measured.
fn mode(
    [natural, damping, a, r, s]: [f64; 5],
    model: DampingModel,
    response: MeasuredResponse,
    ratios: impl IntoIterator<Item = f64>,
) -> Vec<ResponsePoint> {
    let fit = ModalFit {
        natural_frequency: natural,
        damping,
        modal_constant: a,
        stiffness_residual: r,
        mass_residual: s,
        misfit: 0.0,
        slopes: [0.0; 5],
    };
    let at = |ratio: f64| {
        let frequency = natural * ratio;
        let receptance = fit.receptance(model, frequency);
        let i = Complex::new(0.0, frequency);
        let value = match response {
            MeasuredResponse::Receptance => receptance,
            MeasuredResponse::Mobility => receptance * i,
            MeasuredResponse::Accelerance => receptance * i * i,
        };
        (frequency, value)
    };
    ratios.into_iter().map(at).collect()
}

#[test]
fn three_receptances_of_a_chain() {
    // Code_Aster SDLD21 at 5.0, 5.5 and 6.0 Hz; the model has 5.5274 Hz and ζ = 0.00868.
    let points: Vec<ResponsePoint> =
        [(5.0, 1.0237e-4, -8.5187e-6), (5.5, 4.5066e-4, -7.7914e-4), (6.0, -9.4101e-5, -1.0585e-5)]
            .into_iter()
            .map(|(f, re, im)| (TAU * f, Complex::new(re, im)))
            .collect();
    let fit =
        found(modal_fit(&points, MeasuredResponse::Receptance, DampingModel::Viscous, Residuals::Stiffness));
    printed(fit.natural_frequency / TAU, 5.5274, 4);
    close(fit.damping, 0.00868242, 1e-3);
    let circle = found(circle_fit(&points, MeasuredResponse::Receptance, DampingModel::Hysteretic));
    close(2.0 * circle.circle.radius, 0.001028953972043863, 1e-10);
}

#[test]
fn what_is_no_mode_is_refused() {
    let line: Vec<ResponsePoint> = (1..6).map(|n| (f64::from(n), Complex::new(f64::from(n), 1.0))).collect();
    let fit =
        |points: &[ResponsePoint]| circle_fit(points, MeasuredResponse::Receptance, DampingModel::Hysteretic);
    assert_eq!(fit(&line).unwrap_err(), ModalError::NoCircle);
    assert!(matches!(fit(&line[..2]), Err(ModalError::TooFew { .. })));
    assert!(matches!(fit(&[(0.0, Complex::new(1.0, 0.0)); 3]), Err(ModalError::Point { .. })));
    assert_eq!(fit(&[(1.0, Complex::new(0.0, 0.0)); 4]).unwrap_err(), ModalError::NoCircle);
}

proptest! {
    #[test]
    fn an_exact_mode_is_found_again(
        natural in 1.0..1e4f64, damping in 0.002..0.2f64, a in 1e-3..1e3f64, share in -0.05..0.05f64,
        viscous in any::<bool>(), which in 0..3usize, antiphase in any::<bool>(),
    ) {
        let model = if viscous { DampingModel::Viscous } else { DampingModel::Hysteretic };
        let response = [MeasuredResponse::Receptance, MeasuredResponse::Mobility, MeasuredResponse::Accelerance][which];
        let a = if antiphase { -a } else { a };
        // The residual as a share of the peak.
        let r = share * a / (damping * natural.powi(2));
        // Round about the resonance, out to some bandwidths.
        let ratios = (-12..=12).map(|n| 1.0 + f64::from(n) / 12.0 * (4.0 * damping).min(0.8));
        let points = mode([natural, damping, a, r, 0.0], model, response, ratios);
        let fit = found(modal_fit(&points, response, model, Residuals::Stiffness));
        close(fit.natural_frequency, natural, 1e-9);
        close(fit.damping, damping, 1e-8);
        close(fit.modal_constant, a, 1e-8);
        prop_assert!((fit.stiffness_residual - r).abs() < 1e-8 * (a / (damping * natural.powi(2))).abs());
        prop_assert!(fit.misfit < 1e-9 && fit.slopes.iter().all(|slope| slope.abs() < 1e-9));
        // A real residual leaves the circle of a receptance a circle; that of a mobility only without one.
        if !viscous || share.abs() < 1e-3 {
            let circle = found(circle_fit(&points, response, model));
            let tolerance = if viscous { 0.1 } else { 1e-7 };
            close(circle.natural_frequency, natural, tolerance);
            close(circle.damping, damping, tolerance);
            close(circle.modal_constant, a.abs(), tolerance);
        }
    }

    #[test]
    fn a_mode_alone_is_a_circle_in_its_plane(
        natural in 1.0..1e4f64, damping in 0.002..0.3f64, viscous in any::<bool>(),
    ) {
        let model = if viscous { DampingModel::Viscous } else { DampingModel::Hysteretic };
        let ratios = (-10..=10).map(|n| 1.0 + f64::from(n) / 10.0 * (3.0 * damping).min(0.8));
        let points = mode([natural, damping, 2.0, 0.0, 0.0], model, MeasuredResponse::Receptance, ratios);
        let fit = found(circle_fit(&points, MeasuredResponse::Receptance, model));
        close(fit.natural_frequency, natural, 1e-9);
        close(fit.damping, damping, 1e-8);
        close(fit.modal_constant, 2.0, 1e-8);
        let [least, most] = fit.damping_of_pairs.expect("there are points on both sides");
        close(least, most, 1e-6);
        // The half-power points lie on the ends of the diameter across.
        let across = fit.marks[1] - fit.marks[2];
        close(across.norm(), 2.0 * fit.circle.radius, 1e-9);
    }

    #[test]
    fn any_points_are_fitted_or_refused(
        numbers in prop::collection::vec((1e-3..1e6f64, -1e9..1e9f64, -1e9..1e9f64), 0..12),
    ) {
        let points: Vec<ResponsePoint> = numbers.into_iter().map(|(w, x, y)| (w, Complex::new(x, y))).collect();
        for model in [DampingModel::Viscous, DampingModel::Hysteretic] {
            if let Ok(fit) = modal_fit(&points, MeasuredResponse::Mobility, model, Residuals::StiffnessAndMass) {
                prop_assert!(fit.natural_frequency.is_finite() && fit.damping.is_finite());
            }
        }
    }

    #[test]
    fn a_few_points_give_the_damping_back(zeta in 0.001..0.6f64, natural in 1.0..1e4f64, r in 0.2..3.0f64) {
        prop_assume!((r - 1.0).abs() > 0.02);
        let free = natural * (1.0 - zeta * zeta).sqrt();
        let forced = natural * sdof::magnification_peak_ratio(zeta);
        close(identification::damping_ratio_from_free_and_forced(free, forced), zeta, 1e-8 / zeta.powi(2));
        let one = sdof::unbalance_magnification(1.0, zeta);
        close(identification::damping_ratio_from_resonance_and_far(one, 1.0), zeta, ROUNDING);
        let at = sdof::unbalance_magnification(r, zeta);
        if one * r / at > 1.0 + 1e-6 {
            close(identification::damping_ratio_from_unbalance_ratio(one / at, r), zeta, 1e-6);
        }
        let (force_one, force_at) = (sdof::magnification(1.0, zeta), sdof::magnification(r, zeta));
        if force_one / force_at > r * (1.0 + 1e-6) {
            close(identification::damping_ratio_from_force_ratio(force_one / force_at, r), zeta, 1e-6);
        }
        let speeds = [r * natural, 0.9 * r * natural];
        let magnifications = speeds.map(|speed| sdof::unbalance_magnification(speed / natural, zeta));
        let ours = identification::natural_frequency_from_two_speeds(speeds, magnifications);
        close(ours, natural, 1e-8);
        let squared = identification::damping_ratio_from_speed(natural, speeds[0], magnifications[0]).powi(2);
        prop_assert!((squared - zeta * zeta).abs() < 1e-9 * (1.0 + r * r));
    }
}
