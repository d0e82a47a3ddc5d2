//! Trials of reliability: hostile files, arguments and events, faults of the system, formulas beside exact arithmetic.
//! `cargo xtask trust` runs them at full size and records what they met.

mod events;
mod files;
mod formulas;
mod processes;

use dalembert_numerics::random::uniform_bits;

/// Result of a trial.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Number of things that were tried.
    pub tried: u64,
    /// Those that failed, each with what is needed to try it again.
    pub failures: Vec<String>,
    /// Measurements beside it; may be empty.
    pub note: String,
}

/// Runs so many of a trial with a seed.
pub type Run = fn(times: u64, seed: u64) -> Outcome;

/// Every trial, by name.
pub const TRIALS: [(&str, Run); 9] = [
    ("formulas", formulas::beside_exact_arithmetic),
    ("mutants-formulas", formulas::mutants),
    ("hostile-files", files::hostile),
    ("hostile-arguments", processes::hostile_arguments),
    ("kills", processes::kills),
    ("system-calls", processes::system_calls),
    ("events", events::random),
    ("sizes", events::sizes),
    ("terminals", events::terminals),
];

/// Random choices from a seed; the same seed chooses the same.
pub(crate) struct Random {
    seed: u64,
    key: u64,
    place: u64,
}

impl Random {
    /// Choices of the `key`th thing that is tried.
    pub(crate) fn new(seed: u64, key: u64) -> Self {
        Self { seed, key, place: 0 }
    }

    /// A number below `limit`, which is not 0.
    pub(crate) fn below(&mut self, limit: usize) -> usize {
        self.place += 1;
        (uniform_bits(self.seed, self.key, self.place) >> 16) as usize % limit
    }

    /// One of several.
    pub(crate) fn one<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}
