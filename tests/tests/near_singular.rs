//! Answers near singular points beside those of arithmetic with 50 digits: as near as their condition lets the last
//! places of the inputs tell, and without a check that fails.

use dalembert_core::{Stop, file};
use dalembert_plugins as _;
use toml_edit::{DocumentMut, Table};

/// Relative error allowed for an answer of condition 1.
const FLOOR: f64 = 1e-12;
/// Multiple of the condition number that is allowed: a formula rounds some ten times on its way.
const STEPS: f64 = 16.0;

#[test]
fn near_singular_points_are_answered_as_their_condition_allows() {
    let data: DocumentMut = include_str!("../data/near_singular.toml").parse().unwrap();
    let points = data["point"].as_array_of_tables().unwrap();
    let (mut faults, mut families) = (Vec::new(), Vec::new());
    for (number, point) in (1..).zip(points) {
        let name = format!("point {number}, {}", text(point, "family"));
        families.push(text(point, "family"));
        faults.extend(fault(point).map(|fault| format!("{name}: {fault}\n{}", text(point, "inputs"))));
    }
    families.dedup();
    assert!(points.len() >= 77 && families.len() >= 9, "{} points of {families:?}", points.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn fault(point: &Table) -> Option<String> {
    let problem = format!(
        "format = 2\nanalysis = \"{}\"\n[inputs]\n{}",
        text(point, "analysis"),
        text(point, "inputs")
    );
    let problem = file::parse(&problem).unwrap_or_else(|errors| panic!("{errors:?}"));
    let record = problem.draft.read(&problem.entry.shape()).unwrap_or_else(|errors| panic!("{errors:?}"));
    let solution = match problem.entry.solve(&record, &Stop::new()) {
        Ok(solution) => solution,
        Err(why) => return Some(format!("refused: {why}")),
    };
    if let Some(check) = solution.checks.iter().find(|check| !check.passed) {
        return Some(format!("{} ({:e} > {:e})", check.what.english(), check.residual, check.limit));
    }
    let want: f64 = text(point, "value").parse().expect("the value of a point is a number");
    let condition = point["condition"].as_float().expect("a point has a condition number");
    let Some(got) = solution.answer(text(point, "answer")).and_then(dalembert_core::Answer::si) else {
        return Some("there is no such answer".to_owned());
    };
    let (off, limit) = ((got - want).abs() / want.abs(), FLOOR.max(STEPS * f64::EPSILON * condition));
    (off.is_nan() || off > limit)
        .then(|| format!("{got:e} is {off:.1e} off {want:e}, {limit:.1e} is explained"))
}

fn text<'t>(point: &'t Table, key: &str) -> &'t str {
    point[key].as_str().unwrap_or_else(|| panic!("{key} is a text"))
}
