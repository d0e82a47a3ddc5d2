//! Published cases and worked solutions: what is printed is answered, and what is worked is sound.

use std::collections::{BTreeMap, BTreeSet};

use dalembert_core::{
    Answer, Entry, Locale, Stop,
    cases::{Comparison, ComparisonRule, Seen},
    coverage::same_trees,
    duplicates, printer,
};

use crate::{
    problems::{SolvedCase, cases_of, for_each_problem},
    some,
};

/// Compares every answer that was printed somewhere with computed: it agrees as far as it was printed, or is disputed
/// with a reason.
pub fn every_printed_answer_agrees_or_is_disputed(entries: &[&'static Entry]) {
    some(entries);
    let mut differing = Vec::new();
    for entry in entries {
        let id = entry.about.id;
        for case in cases_of(entry) {
            let verdicts = case.verify(entry).unwrap_or_else(|err| panic!("{id}, {}: {err}", case.name));
            for verdict in verdicts.iter().filter(|verdict| verdict.outcome == Comparison::Differing) {
                let (answer, printed, computed, why) =
                    (&verdict.answer, &verdict.printed, &verdict.computed, verdict.why.english());
                differing.push(format!(
                    "{id}, {}: {answer} is printed {printed}, computed {computed}; {why}",
                    case.name
                ));
            }
        }
    }
    assert!(differing.is_empty(), "{}", differing.join("\n"));
}

/// Compares the source of each case with the place where it was seen: of a companion's output the companion is named
/// first, and the book behind it after that. Returns the number of cases that were seen in a companion.
pub fn a_companion_is_named_where_its_output_was_seen(entries: &[&'static Entry]) -> usize {
    some(entries);
    let mut seen = 0;
    for entry in entries {
        for case in cases_of(entry) {
            let source = case.source.english();
            let (first, _) = source.split_once(',').unwrap_or((&source, ""));
            let of_a_companion = case.seen == Some(Seen::Companion);
            assert_eq!(
                first.contains("companion"),
                of_a_companion,
                "{}, {}: write `… companion to` before the book, of a companion's output alone: {source}",
                entry.about.id,
                case.name
            );
            seen += usize::from(of_a_companion);
        }
    }
    seen
}

/// Counts the digits of the right value beside each disputed one: five, or a whole number. Returns the number of
/// disputed answers.
pub fn the_right_value_of_a_dispute_has_five_digits(entries: &[&'static Entry]) -> usize {
    some(entries);
    let mut disputed = 0;
    for entry in entries {
        for case in cases_of(entry) {
            for expected in &case.expect {
                let ComparisonRule::Disputed { computed, .. } = &expected.how else { continue };
                disputed += 1;
                let whole = computed.chars().all(|c| c.is_ascii_digit());
                assert!(
                    whole || digits_of(computed).iter().all(|digits| *digits >= 5),
                    "{}, {}: {} is {computed}, with fewer than five digits",
                    entry.about.id,
                    case.name,
                    expected.answer
                );
            }
        }
    }
    disputed
}

/// The significant digits of each number of a text.
fn digits_of(text: &str) -> Vec<usize> {
    let parts = text.split(|c: char| c.is_whitespace() || "(;)≤≥".contains(c));
    let numbers = parts.filter(|part| part.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)));
    numbers
        .map(|number| {
            let digits = number.split(['e', 'E']).next().unwrap_or_default();
            let digits: String = digits.chars().filter(char::is_ascii_digit).collect();
            digits.trim_start_matches('0').len()
        })
        .collect()
}

/// Examines the solution of every case: no defect of dimensions, checks that pass and whose sides are not the same
/// tree, at least one check, one step and one answer.
pub fn every_solution_is_sound(entries: &[&'static Entry]) {
    for_each_problem(entries, |SolvedCase { name, solution, .. }| {
        assert!(solution.defects.is_empty(), "{name}: {:?}", solution.defects);
        for check in &solution.checks {
            assert!(check.passed, "{name}: {} ({:e})", check.what.english(), check.residual);
        }
        let same: Vec<String> = same_trees(solution).iter().map(|check| check.what.english()).collect();
        assert!(same.is_empty(), "{name}: both sides are the same tree: {same:?}");
        assert!(!solution.checks.is_empty(), "{name}: no answer is found by a second method");
        assert!(!solution.steps.is_empty(), "{name}: nothing is worked");
        assert!(!solution.answers.is_empty(), "{name}: nothing is answered");
    });
}

/// Looks for the main answers: the solution of every case has one at least, and each that an analysis names is an answer
/// of one of its cases.
pub fn every_solution_has_a_main_answer(entries: &[&'static Entry]) {
    let (mut seen, mut faults) = (BTreeSet::new(), Vec::new());
    for_each_problem(entries, |SolvedCase { name, entry, solution, .. }| {
        let main: Vec<&Answer> = solution.answers.iter().filter(|answer| answer.is_main).collect();
        if main.is_empty() {
            let names: Vec<&str> = solution.answers.iter().map(|answer| answer.name.base).collect();
            faults.push(format!("{name}: none of its answers is a main one: {}", names.join(" ")));
        }
        let within_problem = |answer: &Answer| answer.name.base.rsplit('.').next();
        seen.extend(main.iter().filter_map(|answer| Some((entry.about.id, within_problem(answer)?))));
    });
    for entry in entries {
        let id = entry.about.id;
        if entry.about.main.is_empty() {
            faults.push(format!("{id} names no main answer"));
        }
        let missing = entry.about.main.iter().filter(|name| !seen.contains(&(id, **name)));
        faults.extend(missing.map(|name| format!("{id}: no case has the answer {name}")));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Writes every worked solution down: each step has a reason in both languages. Returns the English text of the first
/// case of each analysis by its id, for review.
pub fn every_worked_solution_is_written_down(entries: &[&'static Entry]) -> BTreeMap<&'static str, String> {
    let mut sheets = BTreeMap::new();
    for_each_problem(entries, |SolvedCase { name, entry, solution, .. }| {
        let (english, portuguese) = (Locale::english(), Locale::portuguese());
        let mut sheet = format!("== {name}\n");
        for step in &solution.steps {
            for locale in [&english, &portuguese] {
                let written = printer::step(solution, step, locale);
                assert!(!written.why.is_empty(), "{name}: {} has no reason", written.symbol);
            }
            let written = printer::step(solution, step, &english);
            sheet += &format!(
                "{} [{}]\n    {} = {}\n        = {}\n        = {}\n",
                written.why,
                written.source,
                written.symbol,
                written.formula,
                written.substitution,
                written.result
            );
        }
        for answer in &solution.answers {
            sheet += &format!("{}: {}\n", answer.name, answer.shown(&english));
        }
        sheets.entry(entry.about.id).or_insert(sheet);
    });
    sheets
}

/// Solves every case twice: the solutions are equal to the last bit.
pub fn a_solve_is_a_pure_function(entries: &[&'static Entry]) {
    some(entries);
    for entry in entries {
        for case in cases_of(entry) {
            let Ok(record) = case.record(entry) else { continue };
            let stop = Stop::new();
            assert_eq!(
                entry.solve(&record, &stop),
                entry.solve(&record, &stop),
                "{}, {}",
                entry.about.id,
                case.name
            );
        }
    }
}

/// Examines what is said of each analysis: an id in kebab case that no other has, a title, a summary that is a
/// sentence, and a source.
pub fn every_analysis_is_well_described(entries: &[&'static Entry]) {
    some(entries);
    for entry in entries {
        let id = entry.about.id;
        let (family, name) = id.split_once('/').unwrap_or_else(|| panic!("{id}: an id is family/name"));
        let kebab =
            |text: &str| text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
        assert!(kebab(family) && kebab(name), "{id}: an id is in kebab case");
        assert!(!entry.about.title.is_empty() && entry.about.summary.ends_with('.'), "{id}");
        assert!(!entry.about.sources.is_empty(), "{id} names no source");
    }
    let duplicates: Vec<&str> = duplicates().iter().map(|entry| entry.about.id).collect();
    assert!(duplicates.is_empty(), "two analyses have the same id: {}", duplicates.join(", "));
}
