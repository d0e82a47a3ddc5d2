//! Invariance of answers: under other base units, other units of an input, the other reading of the solve.

use dalembert_plugins as _;
use dalembert_testkit::invariance;
use dalembert_tests::{chosen, times};

#[test]
fn every_answer_scales_with_its_dimension() {
    invariance::every_answer_scales_with_its_dimension(&chosen());
}

#[test]
fn the_unit_of_an_input_does_not_change_the_answers() {
    invariance::the_unit_of_an_input_does_not_change_the_answers(&chosen(), times());
}

#[test]
fn the_plain_reading_is_the_worked_reading() {
    invariance::the_plain_reading_is_the_worked_reading(&chosen());
}

#[test]
fn points_read_by_simd_are_those_read_one_by_one() {
    invariance::points_read_by_simd_are_those_read_one_by_one(&chosen(), times());
}

#[test]
fn extreme_values_are_answered_or_refused() {
    invariance::extreme_values_are_answered_or_refused(&chosen(), times());
}
