//! Many degrees of freedom: what must hold for every system of masses, springs and dampers.

use dalembert_mechanics::vibration::{
    modes::{ModesError, complex_modes, is_proportional, natural_modes},
    poles::Poles,
    receptance::{column_of_modes, column_of_poles, direct, sum_of_modes, sum_of_poles},
    response::{ForceSegment, HarmonicLoad, Push, TimeExcitation, TimeResponse, by_series},
};
use dalembert_numerics::linalg::solve_complex;
use itertools::Itertools as _;
use nalgebra::{Complex, DMatrix, DVector};
use proptest::prelude::*;

use crate::close::{close, found};

/// A chain from a wall: masses, springs and dampers.
#[derive(Debug, Clone)]
struct Chain {
    mass: DMatrix<f64>,
    damping: DMatrix<f64>,
    stiffness: DMatrix<f64>,
}

fn assembled(masses: &[f64], links: &[f64]) -> (DMatrix<f64>, DMatrix<f64>) {
    let n = masses.len();
    let mut matrix = DMatrix::zeros(n, n);
    for (at, link) in links.iter().enumerate() {
        matrix[(at, at)] += link;
        if at > 0 {
            matrix[(at - 1, at - 1)] += link;
            matrix[(at - 1, at)] -= link;
            matrix[(at, at - 1)] -= link;
        }
    }
    (DMatrix::from_diagonal(&DVector::from_column_slice(masses)), matrix)
}

fn chains() -> impl Strategy<Value = Chain> {
    (1_usize..9).prop_flat_map(|n| {
        let masses = prop::collection::vec(0.5..5.0, n);
        let springs = prop::collection::vec(100.0..4000.0, n);
        let dampers = prop::collection::vec(0.0..20.0, n);
        (masses, springs, dampers).prop_map(|(masses, springs, dampers)| {
            let (mass, stiffness) = assembled(&masses, &springs);
            let (_, damping) = assembled(&masses, &dampers);
            Chain { mass, damping, stiffness }
        })
    })
}

fn norm(a: &DMatrix<f64>) -> f64 {
    a.column_iter().map(|column| column.lp_norm(1)).fold(0.0, f64::max)
}

proptest! {
    // Each case is many solves.
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn modes_are_orthogonal_and_their_residual_is_rounding(chain in chains()) {
        let Chain { mass, stiffness, .. } = &chain;
        let modes = found(natural_modes(mass, stiffness));
        let n = modes.squares.len();
        let largest = modes.squares[n - 1];
        let unit = modes.shapes.transpose() * mass * &modes.shapes - DMatrix::identity(n, n);
        prop_assert!(unit.amax() < 1e-12);
        let squares = DMatrix::from_diagonal(&DVector::from_column_slice(&modes.squares));
        let off = modes.shapes.transpose() * stiffness * &modes.shapes - squares;
        prop_assert!(off.amax() < 1e-12 * largest);
        // The residual ratio of LAPACK's tests.
        for (mode, square) in modes.squares.iter().enumerate() {
            let shape = modes.shapes.column(mode);
            let left = (stiffness * shape - mass * shape * *square).lp_norm(1);
            let size = (norm(stiffness) + square * norm(mass)) * shape.lp_norm(1);
            prop_assert!(left <= 30.0 * f64::EPSILON * size * n as f64, "mode {mode}: {}", left / size);
        }
    }

    #[test]
    fn stiffness_never_lowers_and_mass_never_raises_a_frequency(
        chain in chains(), at in 0_usize..8, more in 0.0..1000.0,
    ) {
        let Chain { mass, stiffness, .. } = &chain;
        let n = mass.nrows();
        let before = found(natural_modes(mass, stiffness)).squares;
        let mut stiffer = stiffness.clone();
        stiffer[(at % n, at % n)] += more;
        let mut heavier = mass.clone();
        heavier[(at % n, at % n)] += more / 100.0;
        let (up, down) = (found(natural_modes(mass, &stiffer)).squares, found(natural_modes(&heavier, stiffness)).squares);
        for mode in 0..n {
            prop_assert!(up[mode] >= before[mode] * (1.0 - 1e-12));
            prop_assert!(down[mode] <= before[mode] * (1.0 + 1e-12));
            // One more spring or mass moves no frequency beyond its old neighbour.
            if mode + 1 < n {
                prop_assert!(up[mode] <= before[mode + 1] * (1.0 + 1e-12));
                prop_assert!(down[mode + 1] >= before[mode] * (1.0 - 1e-12));
            }
        }
    }

    #[test]
    fn other_units_scale_every_frequency(chain in chains(), mass in -6_i32..7, time in -6_i32..7) {
        let (m, t) = (10f64.powi(mass), 10f64.powi(time));
        let here = found(natural_modes(&chain.mass, &chain.stiffness)).squares;
        let there = found(natural_modes(&(&chain.mass * m), &(&chain.stiffness * (m / (t * t))))).squares;
        for (here, there) in here.iter().zip_eq(&there) {
            close(*there * t * t, *here, 1e-12);
        }
    }

    #[test]
    fn complex_modes_satisfy_their_equation(chain in chains()) {
        let Chain { mass, damping, stiffness } = &chain;
        let modes = found(natural_modes(mass, stiffness));
        let all = found(complex_modes(&modes, damping));
        let count: usize = all.iter().map(|mode| if mode.root.im > 0.0 { 2 } else { 1 }).sum();
        prop_assert_eq!(count, 2 * mass.nrows());
        for mode in &all {
            let dynamic = stiffness.map(Complex::from)
                + damping.map(Complex::from) * mode.root
                + mass.map(Complex::from) * (mode.root * mode.root);
            let left = (dynamic * &mode.shape).iter().map(|x| x.norm()).fold(0.0, f64::max);
            let size = norm(stiffness) + norm(damping) * mode.natural() + norm(mass) * mode.natural().powi(2);
            prop_assert!(left < 1e-12 * size, "{}", left / size);
        }
    }

    #[test]
    fn response_is_reciprocal_and_the_sum_of_its_modes(chain in chains(), share in 0.05..1.6, zeta in 0.005..0.2) {
        let Chain { mass, damping, stiffness } = &chain;
        let n = mass.nrows();
        let modes = found(natural_modes(mass, stiffness));
        let frequency = share * modes.squares[n - 1].sqrt();
        let momentum = mass * &modes.shapes;
        let decays: Vec<f64> = modes.squares.iter().map(|square| 2.0 * zeta * square.sqrt()).collect();
        let alike = &momentum * DMatrix::from_diagonal(&DVector::from_column_slice(&decays)) * momentum.transpose();
        prop_assert!(is_proportional(&modes.damping(&alike)));
        for (kind, c) in [alike.clone(), damping + &alike * 0.1].iter().enumerate() {
            let dynamic = DMatrix::from_fn(n, n, |i, j| {
                Complex::new(stiffness[(i, j)] - frequency * frequency * mass[(i, j)], frequency * c[(i, j)])
            });
            let matrix = found(solve_complex(&dynamic, &DMatrix::identity(n, n)));
            let size = matrix.iter().map(|x| x.norm()).fold(0.0, f64::max);
            let poles = found(Poles::new(&modes, &modes.damping(c), 0.0));
            for driven in 0..n {
                let force = DVector::from_fn(n, |row, _| if row == driven { 1.0 } else { 0.0 });
                let column = found(direct(mass, c, stiffness, &force.map(Complex::from), frequency));
                let input = poles.input(&force);
                for row in 0..n {
                    prop_assert!((matrix[(row, driven)] - matrix[(driven, row)]).norm() < 1e-12 * size);
                    prop_assert!((matrix[(row, driven)] - column[row]).norm() < 1e-12 * size);
                    let residues: Vec<_> = poles.shapes.row(row).iter().zip_eq(&input).map(|(s, b)| s * b).collect();
                    let (mut re, mut im) = ([0.0], [0.0]);
                    sum_of_poles(&residues, &poles.roots, &[frequency], &mut re, &mut im);
                    let sum = Complex::new(re[0], im[0]);
                    prop_assert!((sum - column[row]).norm() < 1e-10 * size, "{sum} is not {}", column[row]);
                    if kind == 0 {
                        let residues: Vec<f64> =
                            (0..n).map(|mode| modes.shapes[(row, mode)] * modes.shapes[(driven, mode)]).collect();
                        sum_of_modes(&residues, &modes.squares, &decays, &[frequency], &mut re, &mut im);
                        prop_assert!((Complex::new(re[0], im[0]) - column[row]).norm() < 1e-10 * size);
                    }
                }
            }
        }
    }

    #[test]
    fn motion_is_that_of_the_taylor_series(
        chain in chains(), at in 0_usize..8, start in -1.0..1.0, rise in 0.01..0.4, frequency in 1.0..40.0, time in 0.0..0.8,
    ) {
        let Chain { mass, damping, stiffness } = &chain;
        let n = mass.nrows();
        let on = |row: usize, size: f64| DVector::from_fn(n, |i, _| if i == row % n { size } else { 0.0 });
        let excitation = TimeExcitation {
            position: on(at, start),
            velocity: on(at + 1, 10.0 * start),
            pushes: vec![Push {
                force: on(at + 2, 50.0),
                pieces: vec![
                    ForceSegment { start: 0.0, value: 0.0, slope: 1.0 / rise },
                    ForceSegment { start: rise, value: 1.0, slope: 0.0 },
                    ForceSegment { start: 0.6, value: 0.0, slope: 0.0 },
                ],
            }],
            harmonics: vec![HarmonicLoad { force: on(at, 30.0), frequency, lag: 0.3, start: 0.0 }],
        };
        let modes = found(natural_modes(mass, stiffness));
        let poles = found(Poles::new(&modes, &modes.damping(damping), time));
        let state = TimeResponse::new(&poles, &(modes.shapes.transpose() * mass), &excitation).state(time);
        let series = found(by_series([mass, damping, stiffness], &excitation, time, 100_000));
        let size = series.amax().max(excitation.position.amax());
        for row in 0..n {
            prop_assert!((poles.displacement(row, &state) - series[row]).abs() < 1e-10 * size);
        }
    }
}

#[test]
fn columns_are_their_rows_at_once() {
    let (mass, stiffness) = assembled(&[1.0, 2.0, 3.0, 1.5], &[400.0, 300.0, 500.0, 200.0]);
    let (_, damping) = assembled(&[1.0; 4], &[0.0, 6.0, 0.0, 1.0]);
    let modes = found(natural_modes(&mass, &stiffness));
    let lines: Vec<f64> = (0..700).map(|line| 0.05 * f64::from(line)).collect();
    let decays: Vec<f64> = modes.squares.iter().map(|square| 0.1 * square.sqrt()).collect();
    let (mut real, mut imaginary) = (DMatrix::zeros(4, 700), DMatrix::zeros(4, 700));
    let (mut re, mut im) = (vec![0.0; 700], vec![0.0; 700]);
    column_of_modes(&modes.shapes, 2, &modes.squares, &decays, &lines, &mut real, &mut imaginary);
    let held = |row: usize, real: &DMatrix<f64>, imaginary: &DMatrix<f64>, re: &[f64], im: &[f64]| {
        for line in 0..700 {
            let off = (real[(row, line)] - re[line]).hypot(imaginary[(row, line)] - im[line]);
            assert!(
                off < 1e-12 * re.iter().fold(0.0f64, |size, x| size.max(x.abs())),
                "row {row}, line {line}"
            );
        }
    };
    for row in 0..4 {
        let residues: Vec<f64> =
            (0..4).map(|mode| modes.shapes[(row, mode)] * modes.shapes[(2, mode)]).collect();
        sum_of_modes(&residues, &modes.squares, &decays, &lines, &mut re, &mut im);
        held(row, &real, &imaginary, &re, &im);
    }
    let poles = found(Poles::new(&modes, &modes.damping(&damping), 0.0));
    let input = poles.input(&DVector::from_column_slice(&[0.0, 0.0, 1.0, 0.0]));
    column_of_poles(&poles.shapes, &input, &poles.roots, &lines, &mut real, &mut imaginary);
    for row in 0..4 {
        let residues: Vec<_> = poles.shapes.row(row).iter().zip_eq(&input).map(|(s, b)| s * b).collect();
        sum_of_poles(&residues, &poles.roots, &lines, &mut re, &mut im);
        held(row, &real, &imaginary, &re, &im);
    }
}

#[test]
fn damping_that_meets_a_double_root_is_continuous() {
    // ẍ + 2ζω ẋ + ω² x = 0 from x = 1 across ζ = 1, and a free mass under a constant force.
    let one = DMatrix::from_element(1, 1, 1.0);
    let modes = found(natural_modes(&one, &(&one * 4.0)));
    let start = TimeExcitation {
        position: DVector::from_element(1, 1.0),
        velocity: DVector::zeros(1),
        pushes: Vec::new(),
        harmonics: Vec::new(),
    };
    let exact = 3.0 * (-2.0f64).exp();
    for away in [0.0, 1e-15, -1e-13, 1e-11, -1e-10, 1e-9] {
        let poles = found(Poles::new(&modes, &(&one * (4.0 * (1.0 + away))), 1.0));
        let x = poles.displacement(0, &TimeResponse::new(&poles, &one, &start).state(1.0));
        assert!((x - exact).abs() < 1e-8, "{away:e}: {x} is not {exact}");
    }
    let free = found(natural_modes(&one, &(&one * 0.0)));
    let poles = found(Poles::new(&free, &(&one * 0.0), 3.0));
    let push = Push {
        force: DVector::from_element(1, 2.0),
        pieces: vec![ForceSegment { start: 0.0, value: 1.0, slope: 0.0 }],
    };
    let pushed = TimeExcitation { position: DVector::zeros(1), pushes: vec![push], ..start };
    close(poles.displacement(0, &TimeResponse::new(&poles, &one, &pushed).state(3.0)), 9.0, 1e-9);
}

/// From rest with a velocity under a harmonic force, over as many beats as there are.
#[test]
fn nothing_of_a_motion_is_farther_out_than_the_farthest() {
    let (mass, stiffness) = assembled(&[1.3, 2.1], &[420.0, 310.0]);
    let (_, damping) = assembled(&[1.0; 2], &[0.5, 0.35]);
    let modes = found(natural_modes(&mass, &stiffness));
    let excitation = TimeExcitation {
        position: DVector::zeros(2),
        velocity: DVector::from_column_slice(&[2.7, -1.9]),
        pushes: Vec::new(),
        harmonics: vec![HarmonicLoad {
            force: DVector::from_column_slice(&[6.0, -3.0]),
            frequency: 7.3,
            lag: 0.4,
            start: 0.0,
        }],
    };
    for until in [3.0, 11.0, 40.0] {
        let poles = found(Poles::new(&modes, &modes.damping(&damping), until));
        let motion = TimeResponse::new(&poles, &(modes.shapes.transpose() * &mass), &excitation);
        for row in 0..2 {
            let at = |time: f64| poles.displacement(row, &motion.state(time));
            let farthest = motion.farthest(row, until, 100_000, &|| false).expect("so many looks are enough");
            close(at(farthest.time), farthest.value, 1e-12);
            for n in 0..=20_000 {
                let x = at(until * f64::from(n) / 20_000.0);
                assert!(x.abs() <= farthest.value.abs() * (1.0 + 2e-9), "{x} is beyond {farthest:?}");
            }
        }
    }
}

#[test]
fn an_unstable_rest_is_named() {
    let mass = DMatrix::identity(2, 2);
    let stiffness = DMatrix::from_row_slice(2, 2, &[1.0, -3.0, -3.0, 1.0]);
    assert!(matches!(
        natural_modes(&mass, &stiffness),
        Err(ModesError::Unstable { square }) if (square + 2.0).abs() < 1e-14
    ));
}
