//! Tests that hold for every analysis, over those of balancing with their crate alone: built in seconds after a change,
//! they are the judge of mutants. The tests of the workspace run the same over all analyses.

use dalembert_balancing as _;

dalembert_testkit::registry_tests!(
    dalembert_testkit::Laboratory::of("balancing").crate_at(env!("CARGO_MANIFEST_DIR"))
);
