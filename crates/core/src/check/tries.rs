//! Candidates as they are collected.

use super::{Mistake, wrong::Wrong};
use crate::reevaluate::Edit;

/// A mistake, and what each of the wrong answers would be with it.
pub(super) struct Candidate {
    pub(super) mistake: Mistake,
    /// Weight beside other mistakes, at most 1.
    pub(super) prior: f64,
    /// NaN where the mistake does not concern an answer.
    pub(super) values: Vec<f64>,
    /// True if it shows in every answer that depends on it.
    pub(super) is_shared: bool,
    /// True if it is made of what the user or a book said, so that it hits by no accident.
    pub(super) is_free: bool,
    /// Edits of the trace that give these values; empty where the trace does not tell.
    pub(super) edits: Vec<Edit>,
}

/// The candidates that were found so far.
pub(super) struct Tries<'w, 's> {
    pub(super) wrong: &'w [Wrong<'s>],
    pub(super) found: Vec<Candidate>,
}

impl Tries<'_, '_> {
    pub(super) fn push(
        &mut self,
        prior: f64,
        mistake: Mistake,
        values: Vec<f64>,
        is_shared: bool,
        edits: Vec<Edit>,
    ) {
        if values.iter().any(|value| value.is_finite()) {
            self.found.push(Candidate { mistake, prior, values, is_shared, is_free: false, edits });
        }
    }

    /// An edit of the trace.
    pub(super) fn edit(&mut self, prior: f64, mistake: Mistake, values: Vec<f64>) {
        let edits = mistake.edit.iter().cloned().collect();
        self.push(prior, mistake, values, true, edits);
    }

    /// Other data.
    pub(super) fn data(&mut self, prior: f64, mistake: Mistake, values: Vec<f64>, edits: Vec<Edit>) {
        self.push(prior, mistake, values, true, edits);
    }

    /// Candidates found so far, the likeliest first.
    pub(super) fn ranked(&mut self) -> &[Candidate] {
        self.found.sort_by(|a, b| b.prior.total_cmp(&a.prior));
        &self.found
    }

    pub(super) fn free(&mut self, prior: f64, mistake: Mistake, values: Vec<f64>) {
        let candidate =
            Candidate { mistake, prior, values, is_shared: false, is_free: true, edits: Vec::new() };
        self.found.push(candidate);
    }
}
