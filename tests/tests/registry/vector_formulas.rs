//! A vector takes a formula: components that are formulas, products and other vectors.

use dalembert_core::{Stop, file};
use itertools::Itertools as _;

use crate::{number, solved};

/// A cylinder whose moments about the origin depend on its place.
fn cylinder(position: &str) -> String {
    format!(
        r#"
format = 2
analysis = "rigid-body/mass-properties"

[let]
R = "1.3 m"
n = "0.5"

[inputs]
[[inputs.body.parts.parts]]
name = "cylinder"
shape.cylinder = {{ radius = "0.2 m", height = "0.6 m" }}
amount.mass.mass = "3 kg"
position = "{position}"
reference = "near-end"
direction.axis.axis = "(1; -1; 0)"
"#
    )
}

const MOMENTS: [&str; 3] = ["point_inertia_x", "point_inertia_y", "point_inertia_z"];

fn moments(position: &str) -> [f64; 3] {
    let solution = solved(&cylinder(position));
    assert!(solution.checks.iter().all(|check| check.passed), "{position}");
    MOMENTS.map(|name| number(&solution, name))
}

#[test]
fn a_vector_by_formulas_is_the_vector_of_their_values() {
    let typed = moments("(1.3; 2.6; 0.65) m");
    for position in [
        "(R; 2*R; R*n)",
        "(R; 2*R; 650 mm)",
        "(R; 2*R; 0.65) m",
        "R*(1; 2; n)",
        "(R; 2*R; 0) + (0; 0; R*n)",
        "cross((0; 1; 0), (-R*n; 0; R)) + (0; 2*R; 0)",
        "-(-R; -2*R; -R*n)",
    ] {
        for (got, want) in moments(position).into_iter().zip_eq(typed) {
            assert!((got - want).abs() <= 1e-14 * want.abs(), "{position}: {got} is not {want}");
        }
    }
}

#[test]
fn a_definition_in_a_vector_is_varied_as_any_other() {
    let problem = file::parse(&cylinder("(R; 2*R; R*n)")).expect("the file is read");
    let record = problem.draft.read(&problem.entry.shape()).expect("the inputs are read");
    let mut plain = problem.entry.prepare(&record, &["R", "n"], &MOMENTS).expect("the moments are numbers");
    let points = [1.3, 0.5, 2.0, 0.25];
    let mut found = [0.0; 6];
    plain.sweep(&points, &mut found, &Stop::new()).expect("each point has its moments");
    let want = [moments("(1.3; 2.6; 0.65) m"), moments("(2; 4; 0.5) m")].concat();
    for (got, want) in found.into_iter().zip_eq(want) {
        assert!((got - want).abs() <= 1e-14 * want.abs(), "{got} is not {want}");
    }
}

#[test]
fn what_is_wrong_with_a_formula_of_a_vector_is_named() {
    for (position, why) in [
        ("(R; 2 kg; 0)", "compares or adds"),
        ("R", "is no vector"),
        ("(R; n; 0)", "compares or adds"),
        ("(R; 2*Q; 0)", "Q"),
        ("(R; R; R; R)", "a closing bracket behind 2 or 3 components"),
    ] {
        let text = cylinder(position);
        let refused = match file::parse(&text) {
            Err(errors) => format!("{errors:?}"),
            Ok(problem) => match problem.draft.read(&problem.entry.shape()) {
                Err(errors) => {
                    errors.iter().map(|error| format!("{} {}", error.path, error.why.english())).join("\n")
                }
                Ok(_) => panic!("{position} is taken"),
            },
        };
        assert!(refused.contains(why) && refused.contains("position"), "{position}: {refused}");
    }
}

#[test]
fn a_question_may_be_a_vector_of_answers() {
    let text = cylinder("(R; 2*R; 0)")
        + "[ask]\nmoments = { value = \"(point_inertia_x; point_inertia_y; point_inertia_z)\", unit = \"kg m^2\" }\n";
    let solution = solved(&text);
    let answer = solution.answer("moments").expect("the question is answered");
    let dalembert_core::AnswerValue::Number(dalembert_core::Number::Vector(found), _) = answer.value else {
        panic!("{:?} is no vector", answer.value);
    };
    assert_eq!(found, MOMENTS.map(|name| number(&solution, name)));
}
