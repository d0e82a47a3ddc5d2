//! Every answer is held by a second method, or its case file says why not.

use dalembert_plugins as _;
use dalembert_testkit::coverage;
use dalembert_tests::chosen;

#[test]
fn every_answer_is_covered_or_has_a_reason() {
    let covered = coverage::every_answer_is_covered_or_has_a_reason(&chosen());
    assert!(covered > 0, "nothing is covered");
}
