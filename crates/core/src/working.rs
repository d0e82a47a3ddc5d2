//! The working of some answers alone: the steps that they were made from.

use std::collections::BTreeSet;

use crate::{
    Answer, AnswerValue, Check, ProblemSteps, Sides, Solution,
    trace::{Id, Op},
};

impl Solution {
    /// The same solution with these answers alone, the steps that lead to them, and the checks of those. A step that a
    /// numerical method found leads to nothing before it. Answers that are no numbers of the trace have no steps of their own.
    #[must_use]
    pub fn working_of(&self, chosen: impl Fn(&Answer) -> bool) -> Solution {
        let answers: Vec<Answer> = self.answers.iter().filter(|answer| chosen(answer)).cloned().collect();
        let numbers = answers.iter().filter_map(|answer| match answer.value {
            AnswerValue::Number(_, id) => Some(id),
            _ => None,
        });
        let nodes: BTreeSet<Id> = numbers.flat_map(|id| self.ancestors(id)).collect();
        let needed = |id: &Id| match self.trace.node(*id).op {
            Op::Step(step) => Some(step),
            _ => None,
        };
        let kept: Vec<usize> = nodes.iter().filter_map(needed).collect::<BTreeSet<_>>().into_iter().collect();
        let before = |step: usize| kept.partition_point(|known| *known < step);
        let mut trace = self.trace.clone();
        for node in &mut trace.nodes {
            if let Op::Step(step) = &mut node.op {
                match kept.binary_search(step) {
                    Ok(place) => *step = place,
                    // Nothing that is kept refers to it.
                    Err(_) => node.op = Op::Literal,
                }
            }
        }
        let of_problem = |of: &ProblemSteps| ProblemSteps {
            steps: before(of.steps.start)..before(of.steps.end),
            exhibits: 0..0,
            ..of.clone()
        };
        let is_of_these = |check: &&Check| match check.sides {
            Sides::Both(one, other) => nodes.contains(&one) || nodes.contains(&other),
            Sides::One(one) | Sides::Residual(one) => nodes.contains(&one),
            Sides::Plain => false,
        };
        Solution {
            answers,
            steps: kept.iter().map(|step| self.steps[*step].clone()).collect(),
            problems: self.problems.iter().map(of_problem).filter(|of| !of.steps.is_empty()).collect(),
            common_errors: Vec::new(),
            exhibits: Vec::new(),
            checks: self.checks.iter().filter(is_of_these).cloned().collect(),
            warnings: self.warnings.clone(),
            defects: self.defects.clone(),
            determined: self.determined.clone(),
            computed: self.computed.clone(),
            units: self.units,
            trace,
        }
    }
}
