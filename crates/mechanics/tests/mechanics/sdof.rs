use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};
use std::ops::ControlFlow;

use dalembert_mechanics::{beam, sdof, spring};
use dalembert_numerics::{polynomial, roots};
use proptest::prelude::*;

use crate::close::{ROUNDING, close, found, printed};

/// The place of the largest value of a function with one peak, by golden sections, to about `1e-8`.
pub(crate) fn largest(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let golden = (5f64.sqrt() - 1.0) / 2.0;
    for _ in 0..200 {
        let (p, q) = (high - golden * (high - low), low + golden * (high - low));
        if f(p) > f(q) { high = q } else { low = p }
    }
    f64::midpoint(low, high)
}

#[test]
fn suspension_of_list_06_with_the_exact_place_of_the_peak() {
    let (at_rest, peak, at) = (2.0e-4, 1.6e-3, 12.0);
    let stiffness = sdof::stiffness_from_static_receptance(at_rest);
    let ratio = sdof::damping_ratio_from_peak(peak / at_rest).unwrap();
    let natural = sdof::natural_frequency_from_force_peak(at, ratio);
    let mass = sdof::mass_from_natural_frequency(stiffness, natural);
    let damping = sdof::damping_from_ratio(ratio, stiffness, mass);
    close(stiffness, 5000.0, ROUNDING);
    printed(ratio, 0.06262, 5);
    printed(natural, 12.05, 2);
    printed(mass, 34.45, 2);
    printed(damping, 51.98, 2);
    // The model found must show the very curve it was found from.
    close(sdof::receptance(stiffness, mass, damping, 0.0), at_rest, ROUNDING);
    close(sdof::receptance(stiffness, mass, damping, at), peak, ROUNDING);
    let curve = |frequency| sdof::receptance(stiffness, mass, damping, frequency);
    close(largest(curve, 1.0, 30.0), at, 1e-7);
    close(sdof::forced_amplitude(1.0, stiffness, mass, damping, at), 1.6e-3, ROUNDING);
}

#[test]
fn suspension_of_list_06_with_the_peak_taken_for_the_natural_frequency() {
    let mass = sdof::mass_from_natural_frequency(5000.0, 12.0);
    printed(mass, 34.72, 2);
    printed(sdof::damping_from_resonant_receptance(1.6e-3, 12.0), 52.08, 2);
}

#[test]
fn fan_of_list_07() {
    let stiffness = beam::cantilever(200e9, 1.3e-6, 1.2);
    let natural = sdof::natural_frequency(stiffness, 40.0);
    let ratio = sdof::damping_ratio_from_peak(40.0 * 20.3e-3 / 0.1).unwrap();
    let damping = sdof::damping_from_ratio(ratio, stiffness, 40.0);
    let speed = 1000.0 * TAU / 60.0;
    let r = sdof::frequency_ratio(speed, natural);
    printed(stiffness, 451_389.0, 0);
    printed(natural, 106.23, 2);
    printed(ratio, 0.06169, 5);
    printed(r, 0.98579, 5);
    let amplitude = sdof::unbalance_amplitude(0.1, stiffness, 40.0, damping, speed);
    printed(amplitude * 1e3, 19.456, 3);
    close(0.1 / 40.0 * sdof::unbalance_magnification(r, ratio), amplitude, ROUNDING);
    printed(natural * sdof::unbalance_peak_ratio(ratio) * 60.0 / TAU, 1018.3, 1);
    let at_peak = natural * sdof::unbalance_peak_ratio(ratio);
    close(sdof::unbalance_amplitude(0.1, stiffness, 40.0, damping, at_peak), 20.3e-3, ROUNDING);
}

#[test]
fn mass_on_beam_and_springs_of_list_08() {
    let cantilever = beam::cantilever(210e9, 1.5e-5, 2.5);
    let stiffness = spring::series([spring::parallel([cantilever, 5e5]), 2e5]);
    let decrement = sdof::logarithmic_decrement(15.0, 6.0);
    let ratio = sdof::damping_ratio_from_decrement(decrement);
    let damped = 180.0 * TAU / 60.0;
    let natural = sdof::natural_frequency_from_damped(damped, ratio);
    let mass = sdof::mass_from_natural_frequency(stiffness, natural);
    let damping = sdof::damping_from_ratio(ratio, stiffness, mass);
    let r = sdof::frequency_ratio(22.7, natural);
    printed(stiffness, 169_344.0, 0);
    printed(decrement, 0.4513, 4);
    printed(ratio, 0.0716, 4);
    printed(mass, 474.2, 1);
    printed(damping, 1284.0, 0);
    printed(sdof::transmissibility(r, ratio), 2.136, 3);
    let amplitude = sdof::forced_amplitude(200.0, stiffness, mass, damping, 22.7);
    printed(amplitude * 1e3, 2.49, 2);
    let force = sdof::transmitted_force(amplitude, stiffness, damping, 22.7);
    printed(force, 427.0, 0);
    close(force / 200.0, sdof::transmissibility(r, ratio), ROUNDING);
    close(sdof::damped_frequency(natural, ratio), damped, ROUNDING);
}

#[test]
fn damping_ratios_of_a_peak_are_roots_of_its_quartic() {
    // 4Λ²ζ²(1 − ζ²) = 1.
    let peak: f64 = 8.12;
    let four = 4.0 * peak * peak;
    let positive: Vec<f64> = found(polynomial::roots(&[-four, 0.0, four, 0.0, -1.0]))
        .into_iter()
        .filter(|z| z.im == 0.0 && z.re > 0.0)
        .map(|z| z.re)
        .collect();
    close(positive[0], sdof::damping_ratio_from_peak(peak).unwrap(), 1e-12);
    close(positive[1], sdof::extraneous_damping_ratio_from_peak(peak).unwrap(), 1e-12);
}

#[test]
fn damping_ratio_from_peak_keeps_its_digits_when_damping_is_light() {
    for (peak, expected) in [(1e8, 5e-9), (1e12, 5e-13), (1e150, 5e-151)] {
        close(sdof::damping_ratio_from_peak(peak).unwrap(), expected, 1e-15);
    }
    // The next term of the series, ζ = 1/(2Λ) (1 + 1/(8Λ²) + …).
    close(sdof::damping_ratio_from_peak(1e3).unwrap(), 5e-4 * (1.0 + 1.25e-7 + 5.46875e-14), 1e-15);
}

#[test]
fn damping_ratio_from_peak_near_the_last_peak() {
    // With Λ = 1 + ε, ζ² = (1 − √(1 − Λ⁻²))/2 = 1/2 − √(ε/2) (1 − 3ε/4 + …).
    for exponent in [10, 20, 30, 40] {
        let small = 2f64.powi(-exponent);
        let squared = sdof::damping_ratio_from_peak(1.0 + small).unwrap().powi(2);
        let expected = 0.5 - (small / 2.0).sqrt() * (1.0 - 0.75 * small);
        close(squared, expected, 4.0 * small.powi(2) + 1e-15);
    }
    for none in [1.0, 0.5, 0.0, -3.0, f64::NAN] {
        assert_eq!(sdof::damping_ratio_from_peak(none), None);
        assert_eq!(sdof::extraneous_damping_ratio_from_peak(none), None);
    }
}

#[test]
fn phase_passes_a_quarter_turn_at_the_natural_frequency() {
    let (k, m, c) = (2000.0, 5.0, 11.0);
    let natural = sdof::natural_frequency(k, m);
    close(sdof::phase_lag(k, m, c, natural), PI / 2.0, ROUNDING);
    assert_eq!(sdof::phase_lag(k, m, c, 0.0), 0.0);
    close(sdof::phase_lag(k, m, 0.0, 2.0 * natural), PI, ROUNDING);
    close(sdof::receptance(k, m, c, natural), 1.0 / (c * natural), ROUNDING);
    close(sdof::magnification(1.0, 0.1), sdof::quality_factor(0.1), ROUNDING);
}

#[test]
fn transmissibility_is_one_at_root_two_whatever_the_damping() {
    for ratio in [0.0, 0.05, 0.3, 1.0, 4.0] {
        close(sdof::transmissibility(2f64.sqrt(), ratio), 1.0, ROUNDING);
        assert_eq!(sdof::transmissibility(0.0, ratio), 1.0);
    }
}

#[test]
fn decay_agrees_with_the_motion_itself() {
    let (natural, ratio) = (9.0, 0.13);
    let damped = sdof::damped_frequency(natural, ratio);
    let motion = |t: f64| (-ratio * natural * t).exp() * (damped * t - 0.4).cos();
    let decrement = sdof::logarithmic_decrement(motion(0.2) / motion(0.2 + 3.0 * TAU / damped), 3.0);
    close(decrement, sdof::decrement_from_damping_ratio(ratio), ROUNDING);
    close(sdof::damping_ratio_from_decrement(decrement), ratio, ROUNDING);
}

#[test]
fn period_and_critical_damping() {
    close(sdof::angular_frequency(0.5), 4.0 * PI, ROUNDING);
    // Roots of m s² + c_c s + k coincide: c_c² = 4 k m.
    close(sdof::critical_damping(300.0, 7.0).powi(2), 4.0 * 300.0 * 7.0, ROUNDING);
    close(sdof::damping_ratio(33.0, 300.0, 7.0), 33.0 / sdof::critical_damping(300.0, 7.0), ROUNDING);
}

#[test]
fn lower_half_power_point_reaches_zero_at_sin_of_an_eighth_turn() {
    let last = (PI / 8.0).sin();
    assert!(sdof::lower_half_power_ratio(last - 1e-12) < 1e-5);
    assert!(sdof::lower_half_power_ratio(last + 1e-12).is_nan());
}

proptest! {
    #[test]
    fn motion_solves_its_equation(
        k in 1.0..1e6f64, m in 0.1..1e3f64, zeta in 0.0..2.0f64, r in 0.01..5.0f64, force in 0.1..1e4f64,
    ) {
        let c = sdof::damping_from_ratio(zeta, k, m);
        let w = r * sdof::natural_frequency(k, m);
        prop_assume!(sdof::dynamic_stiffness(k, m, c, w) > 1e-3 * k);
        let x = sdof::forced_amplitude(force, k, m, c, w);
        let phase = sdof::phase_lag(k, m, c, w);
        // The parts of m ẍ + c ẋ + k x in phase with the motion and a quarter turn ahead of it.
        let scale = force + k * x;
        prop_assert!(((k - m * w * w) * x - force * phase.cos()).abs() <= 1e-11 * scale);
        prop_assert!((c * w * x - force * phase.sin()).abs() <= 1e-11 * scale);
        close(sdof::magnification(r, zeta), x * k / force, 1e-9);
        close(sdof::phase_lag_from_ratios(r, zeta), phase, 1e-9);
        close(sdof::unbalance_magnification(r, zeta), r * r * sdof::magnification(r, zeta), ROUNDING);
    }

    #[test]
    fn transmitted_force_follows_spring_and_damper(r in 0.01..5.0, zeta in 0.001..2.0f64) {
        // (1 + 2ζr i)/((1 − r²) + 2ζr i)
        let (real, imaginary) = (1.0 - r * r, 2.0 * zeta * r);
        let size = real * real + imaginary * imaginary;
        let (p, q) = ((real + imaginary * imaginary) / size, (imaginary * real - imaginary) / size);
        close(sdof::transmissibility(r, zeta), p.hypot(q), 1e-11);
        let lag = sdof::transmissibility_phase(r, zeta);
        prop_assert!((lag - (-q).atan2(p)).abs() <= 1e-11);
    }

    #[test]
    fn damping_ratio_and_peak_there_and_back(zeta in 1e-9..0.7f64) {
        let peak = sdof::peak_magnification(zeta);
        close(sdof::damping_ratio_from_peak(peak).unwrap(), zeta, 1e-11);
        let other = sdof::extraneous_damping_ratio_from_peak(peak).unwrap();
        close(zeta.powi(2) + other.powi(2), 1.0, ROUNDING);
        prop_assert!(other > FRAC_1_SQRT_2);
        // Of light damping, 1 − ζ²/2 keeps no more than the rounding of one leaves of it.
        if zeta > 1e-4 {
            close(sdof::peak_magnification(other), peak, f64::EPSILON / zeta.powi(2) + ROUNDING);
        }
    }

    #[test]
    fn peak_is_the_largest_value(zeta in 0.02..0.65f64) {
        let peak = sdof::peak_magnification(zeta);
        let force = sdof::magnification_peak_ratio(zeta);
        let unbalance = sdof::unbalance_peak_ratio(zeta);
        close(sdof::magnification(force, zeta), peak, 1e-11);
        close(sdof::unbalance_magnification(unbalance, zeta), peak, 1e-11);
        close(largest(|r| sdof::magnification(r, zeta), 0.0, 2.0), force, 1e-5);
        close(largest(|r| sdof::unbalance_magnification(r, zeta), 0.2, 10.0), unbalance, 1e-5);
        close(sdof::natural_frequency_from_force_peak(7.0 * force, zeta), 7.0, ROUNDING);
    }

    #[test]
    fn half_power_points(zeta in 1e-4..0.38f64, natural in 1.0..1e3f64) {
        let level = sdof::peak_magnification(zeta) * FRAC_1_SQRT_2;
        let (lower, upper) = (sdof::lower_half_power_ratio(zeta), sdof::upper_half_power_ratio(zeta));
        let peak = sdof::magnification_peak_ratio(zeta);
        let crossing = |range| {
            let gap = |r| sdof::magnification(r, zeta) / level - 1.0;
            found(roots::find(gap, range, |_| ControlFlow::Continue(())))
        };
        close(crossing([0.0, peak]), lower, 1e-9);
        close(crossing([peak, 4.0]), upper, 1e-9);
        let exact = sdof::damping_ratio_from_half_power(lower * natural, upper * natural);
        close(exact, zeta, 1e-10);
        // The bandwidth estimate is right to the order ζ².
        let estimate = sdof::damping_ratio_from_bandwidth(lower * natural, upper * natural, natural);
        prop_assert!(zeta > 0.2 || (estimate / zeta - 1.0).abs() <= 3.0 * zeta.powi(2) + 1e-11);
    }

    #[test]
    fn damping_there_and_back(zeta in 1e-6..0.999f64, k in 1.0..1e6, m in 0.1..1e3) {
        close(sdof::damping_ratio(sdof::damping_from_ratio(zeta, k, m), k, m), zeta, ROUNDING);
        let decrement = sdof::decrement_from_damping_ratio(zeta);
        close(sdof::damping_ratio_from_decrement(decrement), zeta, 1e-11);
        let natural = sdof::natural_frequency(k, m);
        close(sdof::mass_from_natural_frequency(k, natural), m, ROUNDING);
        close(sdof::stiffness_from_natural_frequency(m, natural), k, ROUNDING);
    }
}
