//! Every published case of every analysis.

use std::collections::BTreeMap;

use dalembert_core::{
    Entry, Locale, Solution, Stop,
    cases::{self, Hold, Outcome, Seen},
    coverage::same_trees,
    printer, registry,
};
use dalembert_plugins as _;

#[test]
fn every_printed_answer_is_ours_or_is_disputed() {
    let mut differing = Vec::new();
    for entry in chosen() {
        let id = entry.about.id;
        let cases = cases::cases(entry).unwrap_or_else(|err| panic!("{id}: {err}"));
        for case in &cases {
            let verdicts = case.verify(entry).unwrap_or_else(|err| panic!("{id}, {}: {err}", case.name));
            for verdict in verdicts.iter().filter(|verdict| verdict.outcome == Outcome::Differing) {
                let (answer, printed, ours, why) =
                    (&verdict.answer, &verdict.printed, &verdict.ours, verdict.why.english());
                differing.push(format!(
                    "{id}, {}: {answer} is printed {printed}, ours is {ours}; {why}",
                    case.name
                ));
            }
        }
    }
    assert!(differing.is_empty(), "{}", differing.join("\n"));
}

/// The printed answers of the course documents, which the catalogue must hold: analysis and how many at least.
#[test]
fn the_course_documents_are_in_the_catalogue() {
    let sources = [
        ("virtual-work/virtual-power", "Riul", 6),
        ("balancing/two-plane", "Riul", 8),
        ("rigid-body/spinning-disc-on-arm", "Riul", 1),
        ("rigid-body/rod-on-shaft", "Riul", 1),
        ("vibration/frequency-response-identification", "list 06", 3),
        ("vibration/rotating-unbalance", "list 07", 4),
        ("vibration/shaft-clearance", "list 08", 1),
        ("vibration/beam-and-springs", "list 08", 3),
    ];
    for (id, source, least) in sources {
        let entry = dalembert_core::find(id).unwrap_or_else(|| panic!("{id} is not registered"));
        let cases = cases::cases(entry).unwrap();
        let printed: usize = cases
            .iter()
            .filter(|case| case.source.english().contains(source))
            .map(|case| case.expect.len())
            .sum();
        assert!(
            printed >= least,
            "{id} holds {printed} printed answers of {source}; the document has {least}"
        );
    }
}

/// A source that was seen is named first: for a companion's output the companion, and then the book behind it.
#[test]
fn a_companion_is_named_where_its_output_was_seen() {
    let mut seen = 0;
    for entry in chosen() {
        for case in cases::cases(entry).unwrap() {
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
    assert!(seen > 0 || only().is_some(), "no case was seen in a companion");
}

/// A dispute holds the right value as well as it is known; a count is whole.
#[test]
fn the_right_value_of_a_dispute_has_five_digits() {
    let mut disputed = 0;
    for entry in chosen() {
        for case in cases::cases(entry).unwrap() {
            for expected in &case.expect {
                let Hold::Disputed { ours, .. } = &expected.how else { continue };
                disputed += 1;
                let whole = ours.chars().all(|c| c.is_ascii_digit());
                assert!(
                    whole || numbers(ours).iter().all(|digits| *digits >= 5),
                    "{}, {}: {} is {ours}, with fewer than five digits",
                    entry.about.id,
                    case.name,
                    expected.answer
                );
            }
        }
    }
    assert!(disputed > 0 || only().is_some(), "no answer is disputed");
}

/// The significant digits of each number of a text.
fn numbers(text: &str) -> Vec<usize> {
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

#[test]
fn every_solution_is_sound() {
    for_every_solution(|name, solution| {
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

#[test]
fn every_worked_solution_is_written_down() {
    // The first case of each analysis, so that a change can be read in review; the answers of all are checked elsewhere.
    let mut sheets: BTreeMap<String, String> = BTreeMap::new();
    for_every_solution(|name, solution| {
        let id = name.split(',').next().unwrap_or_default();
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
        sheets.entry(format!("sheet_{}", id.replace('/', "_"))).or_insert(sheet);
    });
    for (name, all) in sheets {
        insta::assert_snapshot!(name, all);
    }
}

#[test]
fn a_solve_is_a_pure_function() {
    for entry in chosen() {
        for case in cases::cases(entry).unwrap() {
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

#[test]
fn every_analysis_is_well_described() {
    let mut ids: Vec<&str> = registry().iter().map(|entry| entry.about.id).collect();
    for entry in registry() {
        let id = entry.about.id;
        let (family, name) = id.split_once('/').unwrap_or_else(|| panic!("{id}: an id is family/name"));
        let kebab =
            |text: &str| text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
        assert!(kebab(family) && kebab(name), "{id}: an id is in kebab case");
        assert!(!entry.about.title.is_empty() && entry.about.summary.ends_with('.'), "{id}");
        assert!(!entry.about.sources.is_empty(), "{id} names no source");
    }
    ids.dedup();
    assert_eq!(ids.len(), registry().len(), "two analyses have the same id");
}

fn for_every_solution(mut look: impl FnMut(&str, &Solution)) {
    for entry in chosen() {
        for case in cases::cases(entry).unwrap_or_else(|err| panic!("{}: {err}", entry.about.id)) {
            if case.refused.is_some() {
                continue;
            }
            let name = format!("{}, {}", entry.about.id, case.name);
            let record = case.record(entry).unwrap_or_else(|err| panic!("{name}: {err}"));
            let solution = entry.solve(&record, &Stop::new()).unwrap_or_else(|err| panic!("{name}: {err}"));
            look(&name, &solution);
        }
    }
}

/// The one analysis that is examined, if not all.
fn only() -> Option<String> {
    std::env::var("DALEMBERT_ONLY").ok()
}

/// Every analysis, or the one that `DALEMBERT_ONLY` names.
fn chosen() -> impl Iterator<Item = &'static Entry> {
    let only = only();
    assert!(only.as_deref().is_none_or(|id| dalembert_core::find(id).is_some()), "no analysis is {only:?}");
    registry().iter().copied().filter(move |entry| only.as_deref().is_none_or(|id| id == entry.about.id))
}
