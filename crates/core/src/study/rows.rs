//! Rows of a study: points and their answers.

use crate::Text;

/// Points of a study with their answers.
#[derive(Clone, Debug, Default)]
pub struct Rows {
    /// Numbers of inputs and answers of a row.
    pub(super) widths: [usize; 2],
    pub(super) inputs: Vec<f64>,
    pub(super) answers: Vec<f64>,
    /// The rows without an answer, counted from 0, ascending, and why.
    pub(super) refused: Vec<(usize, Text)>,
}

/// A point of a study with its answers.
#[derive(Clone, Copy, Debug)]
pub struct Row<'r> {
    /// The inputs, in the units of the design.
    pub inputs: &'r [f64],
    /// The answers, in their units; NaN where there is none.
    pub answers: &'r [f64],
    /// Reason for which the point has no answer.
    pub refusal: Option<&'r Text>,
}

impl Rows {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.answers.len() / self.widths[1].max(1)
    }

    /// Returns true if there are none.
    pub fn is_empty(&self) -> bool {
        self.answers.is_empty()
    }

    /// The rows in their order.
    pub fn iter(&self) -> impl Iterator<Item = Row<'_>> {
        let [inputs, answers] = self.widths.map(|width| width.max(1));
        let mut refused = self.refused.iter().peekable();
        let rows = self.inputs.chunks_exact(inputs).zip(self.answers.chunks_exact(answers)).enumerate();
        rows.map(move |(row, (inputs, answers))| {
            let refusal = refused.next_if(|(at, _)| *at == row).map(|(_, why)| why);
            Row { inputs, answers, refusal }
        })
    }
}
