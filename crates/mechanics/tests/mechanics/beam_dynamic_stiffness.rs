//! Tests of `beam::dynamic_stiffness`.

use itertools::Itertools as _;
use std::f64::consts::PI;

use proptest::prelude::*;

use dalembert_mechanics::beam::dynamic_stiffness::*;

const FREE: BeamStation = BeamStation {
    at: 0.0,
    held: false,
    clamped: false,
    spring: 0.0,
    turning_spring: 0.0,
    mass: 0.0,
    inertia: 0.0,
};
const PINNED: BeamStation = BeamStation { held: true, ..FREE };
const GUIDED: BeamStation = BeamStation { clamped: true, ..FREE };
const CLAMPED: BeamStation = BeamStation { held: true, clamped: true, ..FREE };

fn beam(left: BeamStation, right: BeamStation) -> Beam {
    Beam {
        shear: 0.0,
        rotary: 0.0,
        axial: 0.0,
        foundation: 0.0,
        stations: vec![left, BeamStation { at: 1.0, ..right }],
    }
}

fn close(ours: f64, expected: f64, tolerance: f64) {
    assert!((ours - expected).abs() <= tolerance * expected.abs(), "{ours} is not {expected}");
}

/// A frequency equation, of β and 1/cosh β.
type Residual = fn(f64, f64) -> f64;

/// The frequency equations of Euler–Bernoulli beams over cosh β (Rao §8.5; Blevins, table 8-1).
#[test]
fn every_pair_of_supports_satisfies_its_equation() {
    let sech = |b: f64| 1.0 / b.cosh();
    let residuals: [(BeamStation, BeamStation, Residual); 10] = [
        (FREE, FREE, |b, s| b.cos() - s),
        (CLAMPED, CLAMPED, |b, s| b.cos() - s),
        (CLAMPED, FREE, |b, s| b.cos() + s),
        (PINNED, PINNED, |b, _| b.sin()),
        (GUIDED, GUIDED, |b, _| b.sin()),
        (PINNED, GUIDED, |b, _| b.cos()),
        (CLAMPED, PINNED, |b, _| b.sin() - b.cos() * b.tanh()),
        (FREE, PINNED, |b, _| b.sin() - b.cos() * b.tanh()),
        (CLAMPED, GUIDED, |b, _| b.sin() + b.cos() * b.tanh()),
        (FREE, GUIDED, |b, _| b.sin() + b.cos() * b.tanh()),
    ];
    for (left, right, residual) in residuals {
        for (left, right) in [(left, right), (right, left)] {
            let roots = beam(left, right).roots(12).unwrap();
            let shapes: Vec<BeamShape> =
                roots.iter().map(|root| beam(left, right).shape(*root).unwrap()).collect();
            for (n, shape) in shapes.iter().enumerate() {
                close(shape.rayleigh_quotient(), roots[n].powi(4), 1e-12);
                for other in &shapes[..n] {
                    let size = (shape.inertia_product(shape) * other.inertia_product(other)).sqrt();
                    assert!(shape.inertia_product(other).abs() < 1e-10 * size);
                }
            }
            for (n, root) in roots.iter().enumerate() {
                let off = residual(*root, sech(*root));
                assert!(off.abs() < 1e-12 * root, "{left:?} {right:?} {n}: {root} leaves {off}");
                // One root for each half wave: none is missed.
                assert!((root / PI - n as f64 - 1.0).abs() < 0.6, "{left:?} {right:?} {n}: {root}");
            }
        }
    }
}

#[test]
fn rigid_motions_are_counted() {
    let elastic = |k: f64| BeamStation { spring: k, ..FREE };
    for (left, right, motions) in [
        (FREE, FREE, 2),
        (PINNED, FREE, 1),
        (GUIDED, FREE, 1),
        (GUIDED, GUIDED, 1),
        (PINNED, GUIDED, 0),
        (PINNED, PINNED, 0),
        (elastic(3.0), FREE, 1),
        (elastic(3.0), elastic(2.0), 0),
    ] {
        assert_eq!(beam(left, right).rigid_motions(), motions, "{left:?} {right:?}");
    }
}

#[test]
fn euler_buckling() {
    for (left, right, effective) in
        [(PINNED, PINNED, 1.0), (CLAMPED, CLAMPED, 0.5), (CLAMPED, FREE, 2.0), (CLAMPED, GUIDED, 1.0)]
    {
        let load = beam(left, right).buckling_load().unwrap().unwrap();
        close(load, (PI / effective).powi(2), 1e-12);
    }
    // tan p = p.
    close(beam(CLAMPED, PINNED).buckling_load().unwrap().unwrap(), 4.493409457909064f64.powi(2), 1e-12);
    // Engesser: P = P_E/(1 + P_E s).
    let shear = Beam { shear: 0.02, ..beam(PINNED, PINNED) };
    close(shear.buckling_load().unwrap().unwrap(), PI.powi(2) / (1.0 + 0.02 * PI.powi(2)), 1e-12);
    assert_eq!(beam(FREE, PINNED).buckling_load().unwrap(), None);
    let pressed = Beam { axial: -10.0, ..beam(PINNED, PINNED) };
    assert_eq!(pressed.roots(1), Err(BeamError::Buckled));
}

/// Pinned at both ends the shapes are sines: λ in closed form.
#[test]
fn pinned_beams_in_closed_form() {
    let (shear, rotary, axial, foundation) = (0.02, 0.006, -3.0, 40.0);
    let timoshenko = Beam { shear, rotary, axial, foundation, ..beam(PINNED, PINNED) };
    let mut expected: Vec<f64> = (1..20)
        .flat_map(|j| {
            let q = (f64::from(j) * PI).powi(2);
            // det [q/s + n q + k − λ, −√q/s; −√q/s, q + 1/s − r λ] = 0
            let (a, c, b) = (q / shear + axial * q + foundation, q + 1.0 / shear, q / shear.powi(2));
            let (half, product) = ((a * rotary + c) / (2.0 * rotary), (a * c - b) / rotary);
            let root = (half.powi(2) - product).sqrt();
            [product / (half + root), half + root]
        })
        .chain([1.0 / (shear * rotary)])
        .collect();
    expected.sort_by(f64::total_cmp);
    let roots = timoshenko.roots(14).unwrap();
    for (root, expected) in roots.iter().zip_eq(&expected[..14]) {
        close(root.powi(4), *expected, 1e-11);
    }
    let supported = Beam { axial: 50.0, foundation: 1000.0, ..beam(PINNED, PINNED) };
    for (n, root) in supported.roots(6).unwrap().into_iter().enumerate() {
        let q = ((n + 1) as f64 * PI).powi(2);
        close(root.powi(4), q * q + 50.0 * q + 1000.0, 1e-12);
    }
}

/// Compression and foundation can make two frequencies the same.
#[test]
fn double_roots_are_counted_twice() {
    let q = PI.powi(2);
    // q² − n q = 16 q² − 4 n q
    let double = Beam { axial: -5.0 * q, foundation: 20.0 * q * q, ..beam(PINNED, PINNED) };
    let roots = double.roots(3).unwrap();
    close(roots[0], roots[1], 1e-12);
    close(roots[0].powi(4), 16.0 * q * q, 1e-12);
}

#[test]
fn a_cantilever_with_a_heavy_tip_is_a_spring_and_a_mass() {
    for tip in [1e3, 1e6] {
        let heavy = beam(CLAMPED, BeamStation { mass: tip, ..FREE });
        let roots = heavy.roots(2).unwrap();
        // λ = 3/(μ + 33/140).
        close(roots[0].powi(4), 3.0 / (tip + 33.0 / 140.0), 1e-4 / tip);
        close(roots[1], 3.926602312047919, 1e-2);
    }
}

#[test]
fn very_high_roots_neither_overflow_nor_cancel() {
    let roots = beam(CLAMPED, FREE).roots(120).unwrap();
    close(roots[119], 119.5 * PI, 1e-13);
    let shape = beam(CLAMPED, FREE).shape(roots[119]).unwrap();
    close(shape.rayleigh_quotient(), roots[119].powi(4), 1e-9);
    close(shape.state(1.0).deflection.abs(), 1.0, 1e-9);
}

#[test]
fn mirrored_and_cut_beams_are_the_same_beam() {
    let left = BeamStation { spring: 20.0, turning_spring: 3.0, mass: 0.2, inertia: 0.01, ..FREE };
    let one = Beam { shear: 0.01, rotary: 0.004, axial: -1.0, ..beam(left, PINNED) };
    let mut other = Beam { stations: vec![PINNED, BeamStation { at: 1.0, ..left }], ..one.clone() };
    let expected = one.roots(8).unwrap();
    for stations in [vec![], vec![BeamStation { at: 0.3, ..FREE }, BeamStation { at: 0.77, ..FREE }]] {
        other.stations.splice(1..1, stations);
        for (a, b) in other.roots(8).unwrap().into_iter().zip_eq(&expected) {
            close(a, *b, 1e-12);
        }
    }
}

#[test]
fn nodes_are_counted() {
    for (n, root) in beam(CLAMPED, FREE).roots(8).unwrap().into_iter().enumerate() {
        assert_eq!(beam(CLAMPED, FREE).shape(root).unwrap().nodes().len(), n);
    }
    let free = beam(FREE, FREE);
    let root = free.roots(1).unwrap()[0];
    let nodes = free.shape(root).unwrap().nodes();
    close(nodes[0], 0.2241575, 1e-6);
    close(nodes[1], 1.0 - 0.2241575, 1e-6);
}

fn any_beam() -> impl Strategy<Value = Beam> {
    let station =
        (0..5usize, -2.0..4.0f64, -2.0..4.0f64, -2.0..2.0f64, -4.0..0.0f64).prop_map(|(kind, k, t, m, j)| {
            match kind {
                0 => CLAMPED,
                1 => PINNED,
                2 => GUIDED,
                3 => BeamStation { mass: 10f64.powf(m), inertia: 10f64.powf(j), ..FREE },
                _ => BeamStation { spring: 10f64.powf(k), turning_spring: 10f64.powf(t), ..FREE },
            }
        });
    (station.clone(), station, 0..3usize, 0.001..0.03f64, -2.0..30.0f64, 0.0..300.0f64).prop_map(
        |(left, right, theory, rotary, axial, foundation)| {
            let rotary = if theory == 0 { 0.0 } else { rotary };
            let shear = if theory == 2 { 3.1 * rotary } else { 0.0 };
            Beam { shear, rotary, axial, foundation, ..beam(left, right) }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn shapes_have_the_energy_of_their_root_and_are_orthogonal(beam in any_beam()) {
        let Ok(roots) = beam.roots(6) else {
            prop_assert!(beam.axial < 0.0);
            return Ok(());
        };
        let shapes: Vec<BeamShape> = roots.iter().map(|root| beam.shape(*root).unwrap()).collect();
        for (n, (root, shape)) in roots.iter().zip_eq(&shapes).enumerate() {
            prop_assert!(n == 0 || *root > roots[n - 1]);
            // Half a step to each side of the root there is one frequency more.
            let below = beam.count((root * (1.0 - 1e-9)).powi(4)).unwrap();
            let above = beam.count((root * (1.0 + 1e-9)).powi(4)).unwrap();
            prop_assert_eq!((below, above), (beam.rigid_motions() + n, beam.rigid_motions() + n + 1));
            let quotient = shape.rayleigh_quotient();
            prop_assert!((quotient / root.powi(4) - 1.0).abs() < 1e-12, "{} {}", quotient, root.powi(4));
            for (other_root, other) in roots[..n].iter().zip_eq(&shapes[..n]) {
                let size = (shape.inertia_product(shape) * other.inertia_product(other)).sqrt();
                let product = shape.inertia_product(other);
                // Shapes of close roots are known less well.
                let apart = 1.0 - (other_root / root).powi(4);
                prop_assert!(product.abs() * apart < 1e-10 * size, "{} {} {}", product, size, apart);
            }
        }
    }

    #[test]
    fn a_stiffer_spring_never_lowers_a_frequency(beam in any_beam(), k in 0.0..1000.0f64, at in 0..2usize) {
        let mut stiffer = beam.clone();
        stiffer.stations[at].spring += k;
        stiffer.stations[at].turning_spring += 0.1 * k;
        for lambda in [1.0, 30.0, 300.0, 3e3, 3e4, 3e5] {
            prop_assert!(stiffer.count(lambda).unwrap() <= beam.count(lambda).unwrap());
        }
    }

    #[test]
    fn a_slender_timoshenko_beam_is_an_euler_bernoulli_beam(beam in any_beam()) {
        let slender = |r: f64| Beam { rotary: r, shear: 3.0 * r, axial: beam.axial.max(0.0), ..beam.clone() };
        let (thin, thick, plain) = (slender(1e-9).roots(4).unwrap(), slender(1e-3).roots(4).unwrap(), slender(0.0).roots(4).unwrap());
        for ((thin, thick), plain) in thin.into_iter().zip_eq(thick).zip_eq(plain) {
            prop_assert!((thin / plain - 1.0).abs() < 1e-5);
            // Shear and rotary inertia lower every frequency.
            prop_assert!(thick <= plain * (1.0 + 1e-12) && thin <= plain * (1.0 + 1e-12));
        }
    }
}
