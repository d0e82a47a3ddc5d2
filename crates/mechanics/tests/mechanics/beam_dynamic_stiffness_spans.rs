//! Tests of `beam::dynamic_stiffness::spans`.

use dalembert_mechanics::beam::dynamic_stiffness::spans::*;
use itertools::Itertools as _;

const PLAIN: Span = Span { length: 1.0, bending: 1.0, mass: 1.0, axial: 0.0, foundation: 0.0 };
const PIN: SpanJoint = SpanJoint {
    held: true,
    clamped: false,
    spring: 0.0,
    turning_spring: 0.0,
    coupling: 0.0,
    mass: 0.0,
    inertia: 0.0,
};

/// At the inner joints `near + far cos(jπ/N) = 0`, with the stiffnesses of a span that turns at one end.
#[test]
fn equal_spans_have_a_closed_form() {
    let clamp = SpanJoint { clamped: true, ..PIN };
    for count in 2..6 {
        for end in [PIN, clamp] {
            let mut joints = vec![PIN; count + 1];
            (joints[0], joints[count]) = (end, end);
            let beam = Spans { spans: vec![PLAIN; count], joints };
            for beta in beam.roots(count).unwrap() {
                let near = beta.cosh() * beta.sin() - beta.sinh() * beta.cos();
                let far = beta.sinh() - beta.sin();
                let cosine = |j: usize| (j as f64 * std::f64::consts::PI / count as f64).cos();
                let alone = if end.clamped { beta.cos() - beta.cosh().recip() } else { beta.sin() };
                let least = (1..count)
                    .map(|j| ((near + far * cosine(j)) / beta.cosh()).abs())
                    .chain([alone.abs()])
                    .fold(f64::INFINITY, f64::min);
                assert!(least < 1e-11, "{count} spans: {beta} leaves {least:e}");
            }
        }
    }
}

#[test]
fn finite_elements_come_down_to_the_exact_roots() {
    let beam = Spans {
        spans: vec![
            Span { axial: -2.0, ..PLAIN },
            Span { length: 0.7, bending: 2.5, mass: 1.8, axial: 3.0, foundation: 40.0 },
            Span { length: 0.3, mass: 0.5, ..PLAIN },
        ],
        joints: vec![
            SpanJoint { spring: 30.0, turning_spring: 2.0, ..SpanJoint::default() },
            PIN,
            SpanJoint { mass: 0.4, inertia: 0.01, ..SpanJoint::default() },
            SpanJoint { spring: 5.0, mass: 0.1, ..SpanJoint::default() },
        ],
    };
    let roots = beam.roots(4).unwrap();
    let mut before = [f64::INFINITY; 4];
    for parts in [2, 4, 8, 16] {
        for ((root, lambda), before) in
            roots.iter().zip_eq(beam.finite_elements(parts, 4).unwrap()).zip_eq(&mut before)
        {
            let gap = lambda / root.powi(4) - 1.0;
            assert!(gap > -1e-11 && gap < *before, "{parts}: {gap:e}");
            *before = gap;
        }
    }
    assert!(before.iter().all(|gap| *gap < 2e-4), "{before:?}");
    let shapes: Vec<SpanShape> = roots.iter().map(|root| beam.shape(*root).unwrap()).collect();
    for (n, (root, shape)) in roots.iter().zip_eq(&shapes).enumerate() {
        assert!((shape.rayleigh_quotient() / root.powi(4) - 1.0).abs() < 1e-11);
        for other in &shapes[n + 1..] {
            assert!(shape.inertia_product(other).abs() < 1e-10 * shape.inertia_product(shape));
        }
    }
}
