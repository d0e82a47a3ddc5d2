//! Formulas beside exact arithmetic, and with one operation made wrongly.

use dalembert_core::registry;
use dalembert_testkit::{
    cancellation::{SMALL, compared},
    mutants,
};

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

/// Judges `times` formulas with one operation made wrongly, by the published answers and the checks of all cases.
pub(super) fn mutants(times: u64, seed: u64) -> Outcome {
    let verdicts = mutants::verdicts(registry(), times, seed);
    Outcome {
        tried: (verdicts.drawn - verdicts.without_effect.len()) as u64,
        note: format!(
            "{} caught by a published answer, {} by a check alone, {} because the solve did not end or panicked; \
             {} more have no effect on any answer; drawn from {}",
            verdicts.by_answers,
            verdicts.by_checks,
            verdicts.by_failure,
            verdicts.without_effect.len(),
            verdicts.all
        ),
        failures: verdicts.survivors,
    }
}
