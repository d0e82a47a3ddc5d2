//! Variants of published problems: each is solved, and graded as what it is.

use dalembert_core::{Entry, Locale, Stop, Text, UnitSetting, cases, find};
use dalembert_plugins as _;
use dalembert_teaching::{
    Exercise, Generator, causes,
    grading::{AnswerRow, GradedProblem, Outcome, Rules, grade},
};
use dalembert_testkit::on_all_cores;
use dalembert_tests::times;

/// Problems that are varied: analyses, and the places of their cases.
const PROBLEMS: [(&str, usize); 20] = [
    ("balancing/splitting", 1),
    ("balancing/static-couple", 1),
    ("balancing/tolerance", 1),
    ("rigid-body/dynamic-equilibrium", 1),
    ("rigid-body/gyrocompass", 1),
    ("rigid-body/rod-on-shaft", 1),
    ("rigid-body/steady-rolling", 1),
    ("vibration/gun-recoil", 1),
    ("vibration/harmonic-force", 1),
    ("vibration/harmonic-sum", 1),
    ("vibration/large-pendulum", 1),
    ("vibration/logarithmic-decrement", 1),
    ("vibration/loss-of-contact", 1),
    ("vibration/mass-on-shaft", 1),
    ("vibration/vibration-instrument", 1),
    ("virtual-work/a-frame", 1),
    ("virtual-work/bar-and-cord", 1),
    ("virtual-work/geared-drive", 1),
    ("virtual-work/rack-press", 1),
    ("virtual-work/screw-jack", 1),
];

fn exercise(entry: &'static Entry, at: usize) -> Exercise {
    let case = cases::cases(entry).expect("the cases can be read").swap_remove(at - 1);
    Exercise {
        entry,
        title: case.title(),
        statement: case.exercise(),
        record: case.record(entry).expect("the case can be read"),
        draft: case.draft,
        units: UnitSetting::default(),
        show: Vec::new(),
    }
}

/// Ten seeds of each problem; `cargo xtask teaching` takes a thousand.
#[test]
fn variants_are_solved_and_graded() {
    let (stop, rules, locale) = (Stop::new(), Rules::default(), Locale::english().digits(7));
    on_all_cores(&PROBLEMS, |_, (id, at)| {
        let exercise = exercise(find(id).expect("there is such an analysis"), *at);
        let mut generator = Generator::new(&exercise, rules.tolerance, &stop)
            .unwrap_or_else(|why| panic!("{id}: {:?}", why.iter().map(Text::english).collect::<Vec<_>>()));
        for seed in 0..10 * times() as u64 {
            let found = generator.variants(seed, 1, &stop);
            let variant =
                found.unwrap_or_else(|why| panic!("{id}, seed {seed}: {}", why.english())).remove(0);
            let solution = &variant.solution;
            assert!(solution.checks.iter().all(|check| check.passed), "{id}, seed {seed}");
            assert_eq!(solution.warnings, [], "{id}, seed {seed}");
            let problem = GradedProblem {
                entry: exercise.entry,
                record: &variant.record,
                solution,
                asked: &variant.asked,
            };
            let row = |answer: &str, value: String| AnswerRow {
                student: seed.to_string(),
                answer: answer.to_owned(),
                value,
            };
            let rows: Vec<AnswerRow> = variant
                .asked
                .iter()
                .map(|name| row(name, solution.answer(name).expect("it is asked for").shown(&locale)))
                .collect();
            let rows: Vec<&AnswerRow> = rows.iter().collect();
            for one in grade(&problem, (&seed.to_string(), &rows), &rules, &locale, &stop) {
                assert_eq!(one.outcome, Outcome::Right, "{id}, seed {seed}: {one:?}");
            }
            // The first usual mistake is not taken for the right answer.
            for name in variant.numbers() {
                let answer = solution.answer(&name).expect("it is asked for");
                let right = answer.si().expect("it is a number");
                let apart = |error: &&causes::CommonError| (error.si - right).abs() > 0.01 * right.abs();
                let Some(error) = variant.errors[&name].iter().find(apart) else { continue };
                let value = dalembert_units::write_quantity(error.si, &answer.unit, locale.style);
                let given = row(&name, value);
                let graded = grade(&problem, ("", &[&given]), &rules, &locale, &stop);
                assert!(
                    ![Outcome::Right, Outcome::RoundedEarly].contains(&graded[0].outcome),
                    "{id}, seed {seed}: {:?}",
                    graded[0]
                );
            }
        }
    });
}
