//! Tests of `beam::varying`.

use dalembert_mechanics::beam::{
    tapered::{EndSupport, Tapered},
    varying::*,
};
use itertools::Itertools as _;

const ALL: [EndSupport; 3] = [EndSupport::Free, EndSupport::Pinned, EndSupport::Clamped];

fn linear(places: &[f64], supports: [EndSupport; 2]) -> Varying {
    let point =
        |place: &f64| SectionPoint { place: *place, width: 1.0 - 0.4 * place, depth: 1.0 - 0.5 * place };
    Varying { points: places.iter().map(point).collect(), between: Interpolation::Linear, supports }
}

#[test]
fn a_linear_table_is_the_linear_taper_however_it_is_divided() {
    for left in ALL {
        for right in ALL {
            let supports = [left, right];
            let whole = Tapered { width: 0.6, depth: 0.5, supports }.ritz(24, 4).unwrap();
            for places in [vec![0.0, 1.0], vec![0.0, 0.3, 1.0], vec![0.0, 0.2, 0.55, 1.0]] {
                let beam = linear(&places, supports);
                let ritz = beam.ritz(16, 4).unwrap();
                for ((lambda, shape), expected) in
                    ritz.lambdas.iter().zip_eq(&ritz.shapes).zip_eq(&whole.lambdas)
                {
                    assert!((lambda / expected - 1.0).abs() < 1e-8, "{supports:?} {lambda} {expected}");
                    let quotient = beam.moment_quotient(shape).unwrap();
                    assert!((lambda / quotient - 1.0).abs() < 1e-8, "{supports:?} {lambda} {quotient}");
                }
            }
        }
    }
}

/// `w = e^(αx) y` makes a beam of constant section in tension of an exponential width: `y'''' − 2α²y'' + (α⁴ − λ)y = 0`.
#[test]
fn an_exponential_width_between_clamps_has_a_closed_form() {
    let alpha = 0.6_f64;
    let point = |place: f64| SectionPoint { place, width: (-2.0 * alpha * place).exp(), depth: 1.0 };
    let beam = Varying {
        points: vec![point(0.0), point(1.0)],
        between: Interpolation::Exponential,
        supports: [EndSupport::Clamped; 2],
    };
    for lambda in beam.ritz(18, 3).unwrap().lambdas {
        let beta = lambda.sqrt();
        let (s, t) = ((alpha * alpha + beta).sqrt(), (beta - alpha * alpha).sqrt());
        let left = 2.0 * (s.cosh().recip() - t.cos()) + (s / t - t / s) * s.tanh() * t.sin();
        assert!(left.abs() < 1e-8, "{lambda} {left}");
    }
}
