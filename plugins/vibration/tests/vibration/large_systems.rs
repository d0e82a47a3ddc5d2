//! Modal analysis of many degrees of freedom: the bands of the matrices give what the full matrices give.

use std::f64::consts::PI;

use dalembert_core::{Answer, Draft, Solution, SolveError, Stop, find_analysis};
use dalembert_vibration as _;

const ID: &str = "vibration/modal-analysis";

fn solve(inputs: &[(&str, &str)]) -> Result<Solution, String> {
    let entry = find_analysis(ID).unwrap();
    let shape = entry.shape();
    let mut draft = Draft::blank(&shape);
    for (path, text) in inputs {
        draft.set(&shape, path, text).unwrap();
    }
    let record = draft.read(&shape).map_err(|errors| SolveError::Fields(errors).to_string())?;
    entry.solve(&record, &Stop::new()).map_err(|error| error.to_string())
}

fn number(solution: &Solution, name: &str) -> f64 {
    solution.answer(name).and_then(Answer::si).unwrap_or_else(|| panic!("{name} is not answered"))
}

/// The matrices of a chain that is not uniform, with dampers in proportion to its springs and one to the ground.
fn chain(n: usize, corner: bool, damper: f64) -> String {
    let mut rows = String::from("[1]; [1]; [kg]; [N*s/m]; [N/m]\n");
    let spring = |place: usize| 1e4 * (1.0 + 0.3 * (place as f64).sin());
    for row in 1..=n {
        let stiffness = spring(row) + spring(row + 1);
        let mass = 1.0 + 0.2 * (row as f64).cos();
        let damping = 1e-3 * stiffness + if row == 7 { damper } else { 0.0 };
        rows += &format!("{row}; {row}; {mass}; {damping}; {stiffness}\n");
        if row > 1 {
            rows += &format!("{row}; {}; 0; {}; {}\n", row - 1, -1e-3 * spring(row), -spring(row));
        }
    }
    if corner {
        // An entry of nothing, far from the diagonal: full matrices are needed.
        rows += &format!("1; {n}; 0; 0; 0\n");
    }
    rows
}

#[test]
fn bands_and_full_matrices_agree() {
    let inputs = |corner: bool| {
        let rows = chain(180, corner, 0.0);
        solve(&[("system.matrices.entries", &rows), ("damping", "dampers"), ("normalisation", "largest")])
            .unwrap()
    };
    let (banded, full) = (inputs(false), inputs(true));
    for mode in 1..=8 {
        for answer in ["frequency", "modal_mass", "modal_stiffness", "damping_ratio", "damped_frequency"] {
            let name = format!("{answer}[{mode}]");
            let (a, b) = (number(&banded, &name), number(&full, &name));
            assert!((a - b).abs() <= 1e-9 * b.abs(), "{name}: {a} and {b}");
        }
    }
    assert!(banded.checks.iter().all(|check| check.passed), "{:?}", banded.checks);
    assert!(banded.checks.len() > 8);
}

/// ω_j = 2√(k/m) sin(jπ/(2(n + 1))), and of a free chain 2√(k/m) sin((j − 1)π/(2n)).
#[test]
fn a_hundred_thousand_masses() {
    for (ends, exact) in [
        ("both-fixed", (|j, n| 200.0 * (j * PI / (2.0 * (n + 1.0))).sin()) as fn(f64, f64) -> f64),
        ("free", |j, n| 200.0 * ((j - 1.0) * PI / (2.0 * n)).sin()),
    ] {
        let solution = solve(&[
            ("system.uniform.count", "100000"),
            ("system.uniform.mass", "10 kg"),
            ("system.uniform.spring", "1e5 N/m"),
            ("system.uniform.ends", ends),
            ("damping.ratio.ratio", "0.02"),
            ("normalisation", "largest"),
        ])
        .unwrap();
        for mode in 1..=8 {
            let (found, exact) =
                (number(&solution, &format!("frequency[{mode}]")), exact(f64::from(mode), 1e5));
            assert!((found - exact).abs() <= 1e-9 * exact, "{ends} {mode}: {found} and not {exact}");
            if exact > 0.0 {
                assert!((number(&solution, &format!("damping_ratio[{mode}]")) - 0.02).abs() < 1e-12);
            }
        }
        assert!(solution.checks.iter().all(|check| check.passed), "{:?}", solution.checks);
    }
}

#[test]
fn what_cannot_be_solved_says_why() {
    let uniform = |count: &str| {
        solve(&[
            ("system.uniform.count", count),
            ("system.uniform.mass", "10 kg"),
            ("system.uniform.spring", "1e5 N/m"),
            ("system.uniform.ends", "both-fixed"),
            ("damping", "dampers"),
            ("normalisation", "largest"),
        ])
        .unwrap_err()
    };
    assert!(uniform("100001").contains("100000"), "{}", uniform("100001"));
    let refused = |rows: &str| {
        solve(&[("system.matrices.entries", rows), ("damping", "dampers"), ("normalisation", "largest")])
            .unwrap_err()
    };
    let why = refused(&chain(600, false, 3.0));
    assert!(why.contains("the dampers couple the modes"), "{why}");
    for (row, words) in
        [("3; 3; 1; 0; 1\n", "the entry (3, 3) is listed twice"), ("3; 4; 1; 0; 1\n", "differ")]
    {
        let why = refused(&(chain(150, false, 0.0) + row));
        assert!(why.contains(words), "{why}");
    }
}
