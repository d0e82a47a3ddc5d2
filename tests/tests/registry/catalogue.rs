//! Every published case of every analysis.

use dalembert_core::{cases, registry};
use dalembert_plugins as _;
use dalembert_testkit::catalogue;
use dalembert_tests::{chosen, only};

#[test]
fn every_printed_answer_agrees_or_is_disputed() {
    catalogue::every_printed_answer_agrees_or_is_disputed(&chosen());
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

#[test]
fn a_companion_is_named_where_its_output_was_seen() {
    let seen = catalogue::a_companion_is_named_where_its_output_was_seen(&chosen());
    assert!(seen > 0 || only().is_some(), "no case was seen in a companion");
}

#[test]
fn the_right_value_of_a_dispute_has_five_digits() {
    let disputed = catalogue::the_right_value_of_a_dispute_has_five_digits(&chosen());
    assert!(disputed > 0 || only().is_some(), "no answer is disputed");
}

#[test]
fn every_solution_is_sound() {
    catalogue::every_solution_is_sound(&chosen());
}

#[test]
fn every_solution_has_a_main_answer() {
    catalogue::every_solution_has_a_main_answer(&chosen());
}

/// The first case of each analysis, so that a change can be read in review.
#[test]
fn every_worked_solution_is_written_down() {
    for (id, sheet) in catalogue::every_worked_solution_is_written_down(&chosen()) {
        insta::assert_snapshot!(format!("sheet_{}", id.replace('/', "_")), sheet);
    }
}

#[test]
fn a_solve_is_a_pure_function() {
    catalogue::a_solve_is_a_pure_function(&chosen());
}

#[test]
fn every_analysis_is_well_described() {
    catalogue::every_analysis_is_well_described(registry());
}

/// The guide lists the analyses; one that is begun is listed when it is done.
#[test]
fn every_analysis_is_in_the_list_of_the_guide() {
    if only().is_some() {
        return;
    }
    let guide = include_str!("../../../docs/guide.md");
    let (_, list) = guide.split_once("## What it solves").expect("the guide has a list");
    let list = list.split("\n## ").next().unwrap_or_default();
    let is_listed =
        |id: &str| id.split('/').next_back().is_some_and(|name| list.contains(&format!("`{name}`")));
    let missing: Vec<&str> =
        registry().iter().map(|entry| entry.about.id).filter(|id| !is_listed(id)).collect();
    assert!(missing.is_empty() && list.lines().count() > 10, "{missing:?}");
}
