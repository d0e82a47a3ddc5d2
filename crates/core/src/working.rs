//! The working of some answers alone: the steps that they were made from.

use std::collections::BTreeSet;

use crate::{
    Answer, AnswerValue, ProblemSteps, Sides, Solution,
    reevaluate::ancestors,
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
        let nodes: BTreeSet<Id> = numbers.flat_map(|id| ancestors(self, id)).collect();
        let needed = |id: &Id| match self.trace.node(*id).op {
            Op::Step(step) => Some(step),
            _ => None,
        };
        let kept: BTreeSet<usize> = nodes.iter().filter_map(needed).collect();
        let mut narrowed = self.clone();
        narrowed.steps = kept.iter().map(|step| self.steps[*step].clone()).collect();
        for node in &mut narrowed.trace.nodes {
            if let Op::Step(step) = &mut node.op {
                match kept.iter().position(|known| known == step) {
                    Some(place) => *step = place,
                    // Nothing that is kept refers to it.
                    None => node.op = Op::Literal,
                }
            }
        }
        let before = |step: usize| kept.range(..step).count();
        let of_problem = |of: &ProblemSteps| ProblemSteps {
            steps: before(of.steps.start)..before(of.steps.end),
            exhibits: 0..0,
            ..of.clone()
        };
        narrowed.problems = self.problems.iter().map(of_problem).filter(|of| !of.steps.is_empty()).collect();
        narrowed.checks.retain(|check| match check.sides {
            Sides::Both(one, other) => nodes.contains(&one) || nodes.contains(&other),
            Sides::One(one) | Sides::Residual(one) => nodes.contains(&one),
            Sides::Plain => false,
        });
        narrowed.answers = answers;
        narrowed.exhibits.clear();
        narrowed
    }
}
