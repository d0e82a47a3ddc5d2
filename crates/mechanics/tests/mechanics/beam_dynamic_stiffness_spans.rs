//! Tests of `beam::dynamic_stiffness::spans`.

use dalembert_mechanics::beam::dynamic_stiffness::{BeamError, spans::*};
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

/// Between two joints `m ω² = EI k⁴ + N k² + f` with `k = nπ/L`; the beam buckles where the first is zero.
#[test]
fn an_axial_force_changes_the_frequencies_up_to_buckling() {
    let (bending, mass, foundation) = (2.5, 1.8, 3.7);
    let squared = (std::f64::consts::PI / 1.3).powi(2);
    let buckling = bending * squared + foundation / squared;
    let beam = |axial: f64| {
        let span = |length: f64| Span { length, bending, mass, axial, foundation };
        Spans { spans: vec![span(0.5), span(0.8)], joints: vec![PIN, SpanJoint::default(), PIN] }
    };
    for share in [-0.999, -0.4, 0.6, 5.0] {
        let axial = share * buckling;
        for (n, beta) in (1..).zip(beam(axial).roots(3).unwrap()) {
            let k = f64::from(n * n) * squared;
            let expected = (bending * k * k + axial * k + foundation) / mass;
            assert!((beta.powi(4) / expected - 1.0).abs() < 1e-9, "{share}, {n}: {beta}");
        }
    }
    for share in [1.001, 1.7] {
        assert_eq!(beam(-share * buckling).roots(3), Err(BeamError::Buckled));
    }
}

/// Between two joints the shapes are `sin nπx/L`, wherever the spans are divided.
#[test]
fn a_shape_is_a_sine_with_a_largest_deflection_of_one() {
    let span = |length: f64| Span { length, bending: 2.5, mass: 1.8, axial: 3.1, foundation: 0.7 };
    let beam = Spans { spans: vec![span(0.4), span(0.8)], joints: vec![PIN, SpanJoint::default(), PIN] };
    for (n, root) in (1_u32..).zip(beam.roots(4).unwrap()) {
        let shape = beam.shape(root).unwrap();
        let side = shape.deflection(0.05).signum();
        for x in [0.05, 0.23, 0.41, 0.77, 1.03, 1.16] {
            let sine = (f64::from(n) * std::f64::consts::PI * x / 1.2).sin();
            assert!((side * shape.deflection(x) - sine).abs() < 1e-9, "shape {n} at {x}");
        }
        let nodes = shape.nodes();
        assert_eq!(nodes.len() + 1, n as usize, "{nodes:?}");
        for (part, node) in (1_u32..).zip(nodes) {
            assert!((node - 1.2 * f64::from(part) / f64::from(n)).abs() < 1e-9, "shape {n}: {node}");
        }
    }
}
