//! Tests of `vibration::network`.

use dalembert_mechanics::vibration::network::*;
use itertools::Itertools as _;
use nalgebra::Complex;

fn link(a: Option<usize>, b: Option<usize>, stiffness: f64, damping: f64) -> SpringDamper {
    SpringDamper { ends: [a, b], stiffness, damping }
}

fn close(ours: f64, expected: f64) {
    assert!((ours - expected).abs() <= 1e-12 * expected.abs().max(1e-3), "{ours} is not {expected}");
}

/// A bridge of five springs that is neither series nor parallel.
fn bridge() -> Network {
    let links = vec![
        link(Some(0), Some(1), 3.0, 0.1),
        link(Some(0), Some(2), 5.0, 0.2),
        link(Some(1), Some(2), 7.0, 0.0),
        link(Some(1), None, 11.0, 0.3),
        link(Some(2), None, 13.0, 0.0),
    ];
    Network { masses: vec![2.0, 0.0, 0.0], links }
}

#[test]
fn the_driving_point_stiffness_of_a_bridge_is_force_over_displacement() {
    let network = bridge();
    let x = network.at_rest(&[1.0, 0.0, 0.0]).unwrap();
    let driving_point = network.driving_point_stiffness(0, |link| Complex::from(link.stiffness));
    close(driving_point.re * x[0], 1.0);
}

#[test]
fn the_excited_bridge_meets_its_dynamic_stiffness() {
    let (network, frequency) = (bridge(), 1.7);
    let x = network.harmonic_response(&[1.0, 0.0, 0.0], frequency).unwrap()[0];
    let driving_point =
        network.driving_point_stiffness(0, |link| Complex::new(link.stiffness, link.damping * frequency));
    let whole = (driving_point - 2.0 * frequency * frequency) * x;
    close(whole.re, 1.0);
    assert!(whole.im.abs() < 1e-12);
}

#[test]
fn roots_are_those_of_the_polynomial() {
    // m s² + Z(s) = 0 with two Kelvin–Voigt elements in series: of the third degree.
    let links = vec![link(Some(0), Some(1), 3000.0, 100.0), link(Some(1), None, 12000.0, 330.0)];
    let network = Network { masses: vec![10.0, 0.0], links };
    let roots = network.roots().unwrap();
    let (m, k, c, l, d) = (10.0, 3000.0, 100.0, 12000.0, 330.0);
    let cubic = [m * (c + d), m * (k + l) + c * d, k * d + l * c, k * l];
    let expected = dalembert_numerics::polynomial::roots(&cubic).unwrap();
    assert_eq!(roots.len(), 3);
    for (ours, expected) in roots.iter().zip_eq(&expected) {
        assert!((ours - expected).norm() < 1e-10 * expected.norm(), "{ours} is not {expected}");
    }
    close((roots[1].im.abs() * 1e5).round(), 1_501_392.0);
}

#[test]
fn light_nodes_without_dampers_add_no_roots() {
    let links = vec![link(Some(0), Some(1), 6.0, 0.0), link(Some(1), None, 3.0, 0.0)];
    let roots = Network { masses: vec![0.5, 0.0], links }.roots().unwrap();
    assert_eq!(roots.len(), 2);
    close(roots[1].im, 2.0);
    assert!(roots[1].re.abs() < 1e-12);
    assert_eq!(bridge().roots().unwrap().len(), 4);
}

#[test]
fn two_masses_in_a_row() {
    // Equal masses and springs, one end fixed: ω = 2 √(k/m) sin(π/10), sin(3π/10).
    let links = vec![link(Some(0), None, 9.0, 0.0), link(Some(0), Some(1), 9.0, 0.0)];
    let roots = Network { masses: vec![1.0, 1.0], links }.roots().unwrap();
    let mut frequencies: Vec<f64> = roots.iter().map(|root| root.im).filter(|im| *im > 0.0).collect();
    frequencies.sort_by(f64::total_cmp);
    for (n, frequency) in frequencies.iter().enumerate() {
        let angle = (2 * n + 1) as f64 * std::f64::consts::PI / 10.0;
        assert!((frequency / (6.0 * angle.sin()) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn what_nothing_holds_is_named() {
    let links = vec![link(Some(0), None, 1.0, 0.0), link(Some(0), Some(1), 0.0, 1.0)];
    let network = Network { masses: vec![0.0, 1.0], links };
    assert_eq!(network.at_rest(&[0.0, 1.0]), Err(NetworkError::Loose { node: 1 }));
    assert!(network.roots().is_ok());
}
