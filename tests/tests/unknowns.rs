//! Unknown inputs and given answers over the registry.

use dalembert_core::registry;
use dalembert_plugins as _;
use dalembert_testkit::unknowns;

#[test]
fn an_input_is_found_back_from_an_answer() {
    let found = unknowns::an_input_is_found_back_from_an_answer(registry());
    assert!(found >= 110, "only {found} analyses were examined");
}
