//! The tests that hold for every registered analysis, as functions over a list of them.
//!
//! Whatever an analysis computes: its published answers are right, its answers scale with their dimensions, the unit
//! of an input changes nothing, every answer is checked by a second method, every plot agrees with the answers, every
//! sentence is translated. Nobody writes these tests for an analysis; a crate of analyses calls them. A crate outside
//! of this workspace gets all of them, over its own analyses alone, by one line in `tests/registry.rs`:
//!
//! ```
//! # use dalembert_testkit as _;
//! // The crate with the analyses, so that it is linked.
//! // use laboratory as _;
//!
//! dalembert_testkit::registry_tests!(
//!     dalembert_testkit::Laboratory::of("laboratory").crate_at(env!("CARGO_MANIFEST_DIR"))
//! );
//! ```
//!
//! `registry_tests!(…, english_only)` leaves out the tests of the Portuguese. Each function can be called alone, with
//! any list of entries; it panics with all that it found wrong. Those that return a number return how much they
//! examined, so that a caller can refuse to pass where nothing was found to examine.

pub mod alternatives;
pub mod cancellation;
pub mod catalogue;
pub mod coverage;
mod evaluator;
pub mod exercises;
pub mod exhibits;
pub mod extremes;
pub mod inputs;
pub mod invariance;
mod laboratory;
pub mod languages;
pub mod letters;
pub mod mutants;
pub mod near_singular;
pub mod optima;
pub mod papers;
pub mod path_independence;
pub mod perturbation;
pub mod plots;
pub mod printed;
mod problems;
pub mod unit_systems;
pub mod unknowns;

use dalembert_core::Entry;

pub use crate::{
    laboratory::Laboratory,
    problems::{SolvedCase, for_each_problem, on_all_cores},
};

/// Refuses an empty list, over which every test would pass.
fn some(entries: &[&'static Entry]) {
    assert!(!entries.is_empty(), "there is no analysis to examine");
}
