//! Answers near singular points, compared with arithmetic of many digits.

use dalembert_core::{Answer, Stop, file};
use toml_edit::{DocumentMut, Table};

/// The permitted relative error of an answer of condition 1.
const FLOOR: f64 = 1e-12;
/// The multiple of the condition that rounding explains: a formula rounds some ten times on its way.
const STEPS: f64 = 16.0;

/// Compares answers near singular points with reference values of many digits: they are as near as the condition of
/// the point lets the last places of the inputs tell, and no check fails. `data` is TOML, one `[[point]]` each with
/// `analysis`, `inputs`, `answer`, `value` (a text of many digits), `condition` and `family`. Returns the numbers of
/// points and of families.
pub fn near_singular_points_are_answered_as_their_condition_allows(data: &str) -> (usize, usize) {
    let data: DocumentMut = data.parse().unwrap_or_else(|err| panic!("{err}"));
    let points = data["point"].as_array_of_tables().expect("the data has points");
    let (mut faults, mut families) = (Vec::new(), Vec::new());
    for (number, point) in (1..).zip(points) {
        let name = format!("point {number}, {}", text(point, "family"));
        families.push(text(point, "family"));
        faults.extend(fault(point).map(|fault| format!("{name}: {fault}\n{}", text(point, "inputs"))));
    }
    families.dedup();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    (points.len(), families.len())
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
    let Some(got) = solution.answer(text(point, "answer")).and_then(Answer::si) else {
        return Some("there is no such answer".to_owned());
    };
    let (off, limit) = ((got - want).abs() / want.abs(), FLOOR.max(STEPS * f64::EPSILON * condition));
    (off.is_nan() || off > limit)
        .then(|| format!("{got:e} is {off:.1e} off {want:e}, {limit:.1e} is explained"))
}

fn text<'t>(point: &'t Table, key: &str) -> &'t str {
    point[key].as_str().unwrap_or_else(|| panic!("{key} is a text"))
}
