//! Symbols of a sheet: no two of them are one name in formulas.

use std::{collections::BTreeMap, ops::Range, sync::Mutex};

use dalembert_core::{Entry, Number, ProblemSteps, Solution, normalised, printer, registry, trace::Op};
use dalembert_plugins as _;
use dalembert_testkit::{SolvedCase, for_each_problem, on_all_cores};
use itertools::zip_eq;

/// A quantity of a sheet: its symbol, its number, and where it is.
type Quantity = (String, Number, String);

/// The symbols of a sheet, or of one of its problems or configurations, that are one name in formulas, and stand for
/// different numbers or are written differently.
fn coincident(solution: &Solution) -> Vec<String> {
    if solution.problems.is_empty() {
        return coincident_in(solution, 0..solution.steps.len(), |_| true);
    }
    let names: Vec<&str> = solution.problems.iter().map(|problem| problem.name).collect();
    let of_problem = |path: &str| {
        let first = path.split('.').next().unwrap_or_default();
        names.iter().find(|name| **name == first).copied().unwrap_or_default()
    };
    let of = |problem: &ProblemSteps| {
        coincident_in(solution, problem.steps.clone(), |path| of_problem(path) == problem.name)
    };
    solution.problems.iter().flat_map(of).collect()
}

fn coincident_in(solution: &Solution, steps: Range<usize>, is_given: impl Fn(&str) -> bool) -> Vec<String> {
    let mut all: BTreeMap<String, Vec<Quantity>> = BTreeMap::new();
    let mut put = |symbol: String, number: Number, what: String| {
        let of = all.entry(normalised(&symbol)).or_default();
        if !symbol.is_empty() && of.iter().all(|(known, si, _)| *known != symbol || !is_same(*si, number)) {
            of.push((symbol, number, what));
        }
    };
    for node in &solution.trace.nodes {
        if let Op::Given { symbol, path, .. } = &node.op
            && is_given(path)
        {
            put(printer::symbol(symbol), node.number, path.clone());
        }
    }
    for (n, step) in zip_eq(steps.clone(), &solution.steps[steps]) {
        let number = solution.trace.node(step.result).number;
        put(printer::symbol(&step.symbol), number, format!("step {} {}", n + 1, step.why.english()));
    }
    all.into_values().filter(|of| of.len() > 1).map(|of| format!("{of:?}")).collect()
}

/// Returns true for numbers that differ by rounding alone.
fn is_same(a: Number, b: Number) -> bool {
    match (a, b) {
        (Number::Scalar(a), Number::Scalar(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()),
        (Number::Vector(a), Number::Vector(b)) => {
            let size = a.iter().chain(&b).fold(0.0_f64, |size, x| size.max(x.abs()));
            zip_eq(a, b).all(|(a, b)| (a - b).abs() <= 1e-9 * size)
        }
        _ => false,
    }
}

#[test]
fn no_two_symbols_of_a_sheet_are_one_name() {
    let found: Mutex<BTreeMap<&str, Vec<String>>> = Mutex::default();
    on_all_cores(registry(), |_, entry: &&Entry| {
        for_each_problem(&[*entry], |SolvedCase { solution, .. }| {
            let two = coincident(solution);
            if !two.is_empty() {
                let mut found = found.lock().expect("no worker panics");
                found.entry(entry.about.id).or_default().extend(two);
            }
        });
    });
    let found = found.into_inner().expect("no worker panics");
    for (id, all) in &found {
        println!("{id}: {}", all.len());
        for one in all {
            println!("    {one}");
        }
    }
    assert!(found.is_empty(), "{} analyses", found.len());
}
