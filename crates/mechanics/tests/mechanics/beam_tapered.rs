//! Tests of `beam::tapered`.

use dalembert_mechanics::beam::dynamic_stiffness::{Beam, BeamStation};
use dalembert_mechanics::beam::tapered::*;
use itertools::Itertools as _;

const ALL: [EndSupport; 3] = [EndSupport::Free, EndSupport::Pinned, EndSupport::Clamped];

#[test]
fn without_a_taper_it_is_the_uniform_beam() {
    for left in ALL {
        for right in ALL {
            let tapered = Tapered { width: 1.0, depth: 1.0, supports: [left, right] };
            let station = |at: f64, support: EndSupport| BeamStation {
                at,
                held: support != EndSupport::Free,
                clamped: support == EndSupport::Clamped,
                ..BeamStation::default()
            };
            let stations = vec![station(0.0, left), station(1.0, right)];
            let exact = Beam { shear: 0.0, rotary: 0.0, axial: 0.0, foundation: 0.0, stations };
            let ritz = tapered.ritz(18, 4).unwrap();
            for ((root, lambda), shape) in
                exact.roots(4).unwrap().into_iter().zip_eq(&ritz.lambdas).zip_eq(&ritz.shapes)
            {
                assert!((lambda / root.powi(4) - 1.0).abs() < 1e-9, "{lambda} {}", root.powi(4));
                let quotient = tapered.moment_quotient(shape).unwrap();
                assert!((lambda / quotient - 1.0).abs() < 1e-9, "{left:?} {right:?} {lambda} {quotient}");
            }
        }
    }
}

#[test]
fn pointed_cantilevers_by_their_bessel_functions() {
    // Kirchhoff's wedge and cone (Timoshenko, Vibration Problems, art. on beams of variable section):
    // √λ = 5.315 and 8.719.
    let cantilever = [EndSupport::Clamped, EndSupport::Free];
    for (width, expected) in [(1.0, 5.3151), (0.0, 8.7193)] {
        let pointed = Tapered { width, depth: 0.0, supports: cantilever };
        let ritz = pointed.ritz(16, 3).unwrap();
        assert!((ritz.lambdas[0].sqrt() / expected - 1.0).abs() < 2e-5, "{}", ritz.lambdas[0].sqrt());
        for (lambda, shape) in ritz.lambdas.iter().zip_eq(&ritz.shapes) {
            let quotient = pointed.moment_quotient(shape).unwrap();
            assert!((lambda / quotient - 1.0).abs() < 1e-9, "{lambda} {quotient}");
        }
    }
}

/// From above by the curvature of the shapes, from below by the moments of their inertia forces.
#[test]
fn a_strong_taper_is_enclosed() {
    let beam = Tapered { width: 5.0, depth: 4.0, supports: [EndSupport::Free, EndSupport::Clamped] };
    let mut before = [0.0; 5];
    for terms in [12, 16, 20, 24] {
        let ritz = beam.ritz(terms, 5).unwrap();
        for ((lambda, shape), before) in ritz.lambdas.iter().zip_eq(&ritz.shapes).zip_eq(&mut before) {
            *before = beam.moment_quotient(shape).unwrap() / lambda - 1.0;
            assert!(*before < 1e-12, "{before}");
        }
    }
    assert!(before.iter().all(|gap| gap.abs() < 1e-12), "{before:?}");
}

#[test]
fn more_terms_never_raise_a_frequency() {
    for supports in [[EndSupport::Clamped, EndSupport::Free], [EndSupport::Pinned, EndSupport::Clamped]] {
        let beam = Tapered { width: 0.2, depth: 0.25, supports };
        let mut before = [f64::INFINITY; 5];
        for terms in 6..22 {
            let ritz = beam.ritz(terms, 5).unwrap();
            for (before, now) in before.iter_mut().zip_eq(ritz.lambdas) {
                assert!(now <= *before * (1.0 + 1e-10));
                *before = now;
            }
        }
    }
}
