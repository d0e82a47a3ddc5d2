//! Closed forms beside quadrature.

use std::f64::consts::PI;

use nalgebra::Complex;
use proptest::prelude::*;

use dalembert_mechanics::vibration::random::*;

fn close(ours: f64, expected: f64, scale: f64, tolerance: f64) {
    assert!((ours - expected).abs() <= tolerance * scale.abs(), "{ours} is not {expected}");
}

#[test]
fn white_noise_has_its_closed_form() {
    for ratio in [1e-5, 1e-3, 0.05, 0.4, 1.0, 3.0] {
        let mode = Resonance { natural: 2.0, ratio };
        let points: Vec<f64> = mode.breaks().chain([0.0, 100.0, f64::INFINITY]).collect();
        let squared = |omega: f64| mode.receptance(omega).norm_sqr();
        let displacement = integrate(squared, &points).unwrap();
        close(displacement, white_displacement(1.0, 2.0, ratio), displacement, 1e-10);
        let velocity = integrate(|omega| omega * omega * squared(omega), &points).unwrap();
        close(velocity, white_velocity(1.0, 2.0, ratio), velocity, 1e-10);
        if ratio != 1.0 {
            let closed = modal_moment(mode, mode, 0, [0.0, f64::INFINITY]).unwrap();
            close(closed.value, displacement, closed.scale, 1e-10);
        }
    }
}

/// The correlation of two modes under white noise is that of the complete quadratic combination.
#[test]
fn two_modes_correlate_as_der_kiureghian_says() {
    let (r, s) = (Resonance { natural: 1.0, ratio: 0.02 }, Resonance { natural: 1.3, ratio: 0.05 });
    let moment = |r, s| modal_moment(r, s, 0, [0.0, f64::INFINITY]).unwrap().value;
    let ours = moment(r, s) / (moment(r, r) * moment(s, s)).sqrt();
    let (a, b, q) = (0.02f64, 0.05f64, 1.3f64);
    let cqc = 8.0 * (a * b).sqrt() * (a + q * b) * q.powf(1.5)
        / ((1.0 - q * q).powi(2) + 4.0 * a * b * q * (1.0 + q * q) + 4.0 * (a * a + b * b) * q * q);
    close(ours, cqc, 1.0, 1e-12);
}

/// On a base with the acceleration 1 a mode moves by `−γ/(ωₙ² − ω² + 2iζωₙω)`; the base adds its own acceleration.
#[test]
fn the_absolute_acceleration_is_that_of_the_base_and_the_relative_one() {
    let mode = |natural, ratio| Resonance { natural, ratio };
    let modes = [(mode(2.0, 0.05), 0.83), (mode(5.3, 0.12), 0.29), (mode(9.1, 0.02), -0.12)];
    for omega in [0.3_f64, 1.9, 4.1, 8.8, 23.0] {
        let motion = |(mode, share): &(Resonance, f64)| {
            let stiffness = mode.natural * mode.natural - omega * omega;
            -Complex::new(stiffness, 2.0 * mode.ratio * mode.natural * omega).inv() * *share
        };
        let relative: Complex<f64> = modes.iter().map(motion).sum();
        let square = relative.norm_sqr();
        close(relative_squared(&modes, omega), square, square, 1e-12);
        let square = (Complex::<f64>::ONE - relative * (omega * omega)).norm_sqr();
        close(absolute_squared(&modes, omega), square, square, 1e-11);
    }
}

#[test]
fn a_density_runs_straight_between_its_points() {
    let line = Density::new(vec![(1.0, 2.0), (3.0, 4.0)], false).unwrap();
    assert_eq!([line.at(0.5), line.at(2.0), line.at(3.0), line.at(3.1)], [0.0, 3.0, 4.0, 0.0]);
    let power = Density::new(vec![(1.0, 2.0), (10.0, 200.0)], true).unwrap();
    close(power.at(3.0), 18.0, 18.0, 1e-14);
    assert_eq!(Density::new(vec![(1.0, 2.0)], false), Err(DensityError::Few));
    assert_eq!(Density::new(vec![(1.0, 2.0), (1.0, 2.0)], false), Err(DensityError::Order));
    assert_eq!(Density::new(vec![(0.0, 2.0), (1.0, 2.0)], true), Err(DensityError::Value));
}

#[test]
fn a_flat_function_has_its_area() {
    close(integrate(|_| 3.0, &[1.0, 4.0]).unwrap(), 9.0, 9.0, 1e-14);
    close(integrate(|x| 1.0 / (1.0 + x * x), &[0.0, 1.0, f64::INFINITY]).unwrap(), PI / 2.0, 1.0, 1e-13);
    assert_eq!(integrate(|x| 1.0 / (x - 2.0).max(0.0), &[0.0, 4.0]), Err(QuadratureError::NotFinite));
}

proptest! {
    #[test]
    fn bands_by_partial_fractions_and_by_quadrature(
        ratio in 0.005..0.9f64, other in 0.005..0.9f64, natural in 0.2..5.0f64,
        from in 0.0..3.0f64, width in 0.1..6.0f64, power in 0u8..3,
    ) {
        let (r, s) = (Resonance { natural: 1.0, ratio }, Resonance { natural, ratio: other });
        let power = 2 * power;
        let to = from + width;
        let function =
            |omega: f64| (r.receptance(omega) * s.receptance(omega).conj()).re * omega.powi(power.into()) + 1.0;
        let points: Vec<f64> =
            [from, to].into_iter().chain(r.breaks().chain(s.breaks()).filter(|x| *x > from && *x < to)).collect();
        let ours = modal_moment(r, s, power, [from, to]).unwrap();
        let quadrature = integrate(function, &points).unwrap() - width;
        prop_assert!((ours.value - quadrature).abs() <= 1e-9 * (ours.scale + width), "{ours:?} {quadrature}");
        let mut points = points;
        points.sort_by(f64::total_cmp);
        let about = integrate_about(function, &points, [1.0, ratio]) - width;
        prop_assert!((about - quadrature).abs() <= 1e-9 * (ours.scale + width), "{about} {quadrature}");
    }
}
