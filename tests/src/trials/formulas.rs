//! Formulas beside exact arithmetic.

use dalembert_core::registry;
use dalembert_testkit::cancellation::{SMALL, compared};

use super::Outcome;

/// Compares every answer and step of all cases, of `times` random problems near each, and with one input after the other
/// nearly zero.
pub(super) fn beside_exact_arithmetic(times: u64, seed: u64) -> Outcome {
    let compared = compared(registry(), times, &SMALL, seed);
    let failures = compared.faults.iter();
    Outcome {
        tried: compared.numbers as u64,
        failures: failures
            .map(|(formula, (count, first))| format!("{formula}: {count} times; {first}"))
            .collect(),
        note: format!(
            "{} solutions; {} numbers with fewer than 12 digits that their condition explains",
            compared.solutions, compared.explained
        ),
    }
}
