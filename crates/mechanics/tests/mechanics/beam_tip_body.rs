//! Tests of `beam::tip_body`.

use std::f64::consts::PI;

use dalembert_mechanics::beam::tip_body::*;
use itertools::Itertools as _;
use nalgebra::Vector3;

fn round(length: f64, diameter: f64, timoshenko: bool) -> Cantilever {
    let (young, poisson, density) = (200e9, 0.3, 8000.0);
    let shear = young / (2.0 * (1.0 + poisson));
    let area = PI * diameter.powi(2) / 4.0;
    let moment = PI * diameter.powi(4) / 64.0;
    let kappa = dalembert_mechanics::section::shear::round(poisson);
    let bending = Bending {
        stiffness: young * moment,
        shear: if timoshenko { young * moment / (kappa * shear * area * length.powi(2)) } else { 0.0 },
        rotary: if timoshenko { moment / (area * length.powi(2)) } else { 0.0 },
    };
    Cantilever {
        length,
        line_mass: density * area,
        axial: young * area,
        torsion: 2.0 * shear * moment,
        polar: 2.0 * density * moment,
        bending: [bending; 2],
    }
}

#[test]
fn with_next_to_no_body_it_is_the_cantilever() {
    let beam = round(1.0, 0.2, false);
    let modes = beam.modes(&[(1e-9, Vector3::zeros())], 8).unwrap();
    let bending = |beta: f64| beta.powi(2) * (beam.bending[0].stiffness / beam.line_mass).sqrt();
    let axial = 0.5 * PI * (beam.axial / beam.line_mass).sqrt();
    let torsion = 0.5 * PI * (beam.torsion / beam.polar).sqrt();
    let mut expected =
        [bending(1.875104068711961), bending(4.694091132974175), bending(7.854757438237613)].repeat(2);
    expected.extend([axial, torsion, 3.0 * torsion, 3.0 * axial]);
    expected.sort_by(f64::total_cmp);
    for (mode, expected) in modes.iter().zip_eq(&expected[..8]) {
        assert!((mode.frequency / expected - 1.0).abs() < 1e-8, "{} {expected}", mode.frequency);
    }
}

#[test]
fn a_heavy_point_at_the_tip_is_a_mass_on_springs() {
    let beam = round(2.0, 0.05, false);
    let modes = beam.modes(&[(1e6, Vector3::zeros())], 3).unwrap();
    let expected = (3.0 * beam.bending[0].stiffness / (8.0 * 1e6)).sqrt();
    for mode in &modes[..2] {
        assert!((mode.frequency / expected - 1.0).abs() < 1e-4);
        assert!(mode.residual < 1e-12, "{}", mode.residual);
    }
    // The two shapes stand across each other.
    assert!(modes[0].tip.dot(&modes[1].tip).abs() < 1e-6);
}

#[test]
fn nafems_four() {
    let body = [(1e4, Vector3::new(0.0, 2.0, 0.0)), (1e3, Vector3::new(0.0, -2.0, 0.0))];
    let frequencies = |timoshenko: bool| {
        let modes = round(10.0, 0.5, timoshenko).modes(&body, 6).unwrap();
        modes.into_iter().map(|mode| mode.frequency / (2.0 * PI)).collect::<Vec<_>>()
    };
    // Converged frames of Euler–Bernoulli elements.
    let frames = [1.723278, 1.726843, 7.413388, 9.974768, 18.1816, 26.98553];
    for ((plain, frame), shearing) in frequencies(false).iter().zip_eq(frames).zip_eq(frequencies(true)) {
        assert!((plain / frame - 1.0).abs() < 3e-6, "{plain} {frame}");
        assert!(shearing < *plain && shearing > 0.98 * plain, "{shearing} {plain}");
    }
}
