//! The tests that hold for every analysis, over those of the laboratory. One without Portuguese writes `english_only`
//! behind the laboratory, and needs no `locales`.

use laboratory as _;

dalembert_testkit::registry_tests!(
    dalembert_testkit::Laboratory::of("laboratory").crate_at(env!("CARGO_MANIFEST_DIR"))
);
