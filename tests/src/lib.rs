//! Helpers of the tests of the whole program: a user before the screens, and a terminal for the program itself.

pub mod errors;
pub mod fuzz;
pub mod person;
pub mod pictures;
pub mod process;
pub mod pty;
pub mod trials;

use dalembert_core::{Entry, registry};

/// Multiplier of the random tests over the registry: `DALEMBERT_TIMES`, as `cargo xtask soak nets` sets
/// it.
#[must_use]
pub fn times() -> usize {
    let times = std::env::var("DALEMBERT_TIMES").ok();
    times.map_or(1, |text| text.parse().unwrap_or_else(|_| panic!("DALEMBERT_TIMES is a number: {text}")))
}

/// The one analysis that is examined, if not all: `DALEMBERT_ONLY`.
#[must_use]
pub fn only() -> Option<String> {
    std::env::var("DALEMBERT_ONLY").ok()
}

/// Every analysis, or those whose id, or whose family, `DALEMBERT_ONLY` names.
#[must_use]
pub fn chosen() -> Vec<&'static Entry> {
    let only = only();
    let is_chosen =
        |entry: &&Entry| only.as_deref().is_none_or(|only| only == entry.about.id || only == entry.family());
    let entries: Vec<_> = registry().iter().copied().filter(is_chosen).collect();
    assert!(!entries.is_empty(), "no analysis is {only:?}");
    entries
}
