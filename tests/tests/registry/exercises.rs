//! Exercises: every statement is complete, every list has statements, and hints come from the worked solution.

use std::collections::BTreeSet;

use dalembert_core::{
    Locale, Stop,
    cases::{self, Case},
    exercises, find,
    hints::{HintLevel, hint},
    printer, registry,
};
use itertools::zip_eq;

#[test]
fn statements_are_complete_and_give_nothing_away() {
    let count = dalembert_testkit::exercises::statements_are_complete(registry());
    assert!(count >= 130, "{count} statements");
}

/// Cases with a statement, with their analyses.
fn stated() -> impl Iterator<Item = (&'static dalembert_core::Entry, Case)> {
    let of_entry = |entry: &&'static dalembert_core::Entry| {
        let entry = *entry;
        cases::cases(entry).expect("the case files are read").into_iter().map(move |case| (entry, case))
    };
    registry().iter().flat_map(of_entry).filter(|(_, case)| !case.statement.is_empty())
}

#[test]
fn every_exercise_of_the_lists_has_a_statement() {
    let mut listed = BTreeSet::new();
    for list in exercises::bundled() {
        for exercise in list.expect("the list can be read").list {
            let entry = find(&exercise.analysis).expect("there is the analysis");
            let cases = cases::cases(entry).expect("the case files are read");
            let case = cases.iter().find(|case| case.name == exercise.case).expect("there is the case");
            assert!(!case.statement.is_empty(), "{}: {} has no statement", exercise.analysis, exercise.case);
            let is_new = listed.insert((exercise.analysis.clone(), exercise.case.clone()));
            assert!(is_new, "{}: {} stands in two lists", exercise.analysis, exercise.case);
        }
    }
    // What has a statement can be found in a list.
    for (entry, case) in stated() {
        let is_listed = listed.contains(&(entry.about.id.to_owned(), case.name.clone()));
        assert!(is_listed, "{}: {} is in no list", entry.about.id, case.name);
    }
    let analyses: BTreeSet<&str> = listed.iter().map(|(analysis, _)| analysis.as_str()).collect();
    let families: BTreeSet<&str> = analyses.iter().filter_map(|id| Some(id.split_once('/')?.0)).collect();
    assert!((analyses.len(), families.len()) >= (80, 4), "{analyses:?}");
}

#[test]
fn hints_lead_from_words_to_the_answer() {
    let locale = Locale::english();
    let mut numbers = 0;
    for (entry, case) in stated() {
        let record = case.record(entry).expect("the case is read");
        let solution = entry.solve(&record, &Stop::new()).expect("the case has a solution");
        for name in &case.asked {
            let answer = solution.answer(name).expect("what is asked for is an answer");
            let place = format!("{}, {}: {name}", entry.about.id, case.name);
            let [words, formulas, values] =
                HintLevel::ALL.map(|level| hint(&solution, answer, level, &locale));
            for (hint, level) in zip_eq([&words, &formulas, &values], HintLevel::ALL) {
                assert!(!hint.lines.is_empty(), "{place}: no {}", level.name());
                assert!(hint.lines.iter().all(|line| !line.text.is_empty()), "{place}: {hint:?}");
            }
            assert!(words.lines.iter().all(|line| line.symbol.is_empty()), "{place}");
            // The numbers end in the result, and nothing before them gives it away.
            if answer.si().is_some() {
                let last = solution.working_of(|known| known.name == answer.name);
                let step = last.steps.last().expect("an answer has a step");
                let result = printer::step(&last, step, &locale).result;
                let said = values.lines.last().expect("it has lines");
                assert!(said.text.ends_with(&result), "{place}: {said:?} {result}");
                let given_away =
                    words.lines.iter().chain(&formulas.lines).find(|line| line.text.contains(&result));
                assert!(
                    given_away.is_none_or(|_| result.chars().count() < 5),
                    "{place}: {given_away:?} {result}"
                );
                numbers += 1;
            }
        }
    }
    assert!(numbers > 200, "{numbers}");
}
