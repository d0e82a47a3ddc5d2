//! Every alternative of every one-of is reached by a case that holds a number.

use dalembert_core::registry;
use dalembert_plugins as _;
use dalembert_testkit::alternatives;

#[test]
fn every_alternative_is_reached_by_a_case() {
    let known = alternatives::every_alternative_is_reached_by_a_case(registry());
    assert!(known > 100, "{known} one-ofs");
}
