//! Truth of a printed worked solution: every substitution, read again from its text and computed, gives the
//! result beside it.

use dalembert_core::registry;
use dalembert_plugins as _;
use dalembert_testkit::printed;

#[test]
fn printed_steps_give_their_results() {
    let read = printed::printed_steps_give_their_results(registry());
    assert!(read > 100, "only {read} substitutions were read");
}
