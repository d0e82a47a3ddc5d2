//! Tests that hold for every analysis, over those of balancing with their crate alone: built in seconds after a change,
//! they are the judge of mutants. The tests of the workspace run the same over all analyses.

use dalembert_balancing as _;
use dalembert_core::{Entry, registry};
use dalembert_testkit::{catalogue, exhibits, invariance, printed, unknowns};

/// The analyses of the crate.
fn entries() -> &'static [&'static Entry] {
    let all = registry();
    assert!(all.len() > 5 && all.iter().all(|entry| entry.family() == "balancing"), "{} analyses", all.len());
    all
}

#[test]
fn every_printed_answer_agrees_or_is_disputed() {
    catalogue::every_printed_answer_agrees_or_is_disputed(entries());
}

#[test]
fn every_solution_is_sound() {
    catalogue::every_solution_is_sound(entries());
}

#[test]
fn every_answer_scales_with_its_dimension() {
    invariance::every_answer_scales_with_its_dimension(entries());
}

#[test]
fn the_plain_reading_is_the_worked_reading() {
    invariance::the_plain_reading_is_the_worked_reading(entries());
}

#[test]
fn every_mark_equals_an_answer_or_a_point_of_a_curve() {
    exhibits::every_mark_equals_an_answer_or_a_point_of_a_curve(entries());
}

#[test]
fn printed_steps_give_their_results() {
    printed::printed_steps_give_their_results(entries());
}

#[test]
fn an_input_is_found_back_from_an_answer() {
    unknowns::an_input_is_found_back_from_an_answer(entries());
}
