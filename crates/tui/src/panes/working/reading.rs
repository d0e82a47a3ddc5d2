//! How far a user has read the worked solution: what is covered still, and the symbol that is followed.

use std::collections::HashSet;

use dalembert_core::{
    Answer, AnswerValue, Solution,
    trace::{Id, Op},
};

/// A symbol of a step: the places of both.
pub type Place = (usize, usize);

/// How far a user has read the worked solution.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// How many steps are revealed, with the answers they lead to; `None` where nothing is covered.
    pub revealed: Option<usize>,
    /// The symbol that the cursor is at.
    pub symbol: Option<Place>,
    /// The answer whose unit and digits are chosen, by its place.
    pub answer: Option<usize>,
    /// The symbols that were followed to where it is.
    pub trail: Vec<Place>,
}

impl Reading {
    /// How many steps of a solution are revealed.
    pub fn steps(&self, solution: &Solution) -> usize {
        self.revealed.map_or(solution.steps.len(), |revealed| revealed.min(solution.steps.len()))
    }

    /// Whether an answer is covered: some step that leads to it is not revealed.
    pub fn covers(&self, solution: &Solution, answer: &Answer) -> bool {
        let Some(revealed) = self.revealed else { return false };
        let last = match answer.value {
            AnswerValue::Number(_, id) => {
                leaves(solution, id).into_iter().filter_map(|id| step_of(solution, id)).max()
            }
            AnswerValue::Set(..) | AnswerValue::List(_) => None,
        };
        last.unwrap_or(solution.steps.len().saturating_sub(1)) >= revealed
    }

    /// One step more is revealed; whether it was the last.
    pub fn reveal(&mut self, solution: &Solution) -> bool {
        let steps = self.steps(solution) + 1;
        self.revealed = (steps < solution.steps.len()).then_some(steps);
        self.revealed.is_none()
    }

    /// The symbol after the cursor, or before it; the first one from a step on where there is no cursor yet.
    pub fn beside(&self, solution: &Solution, from: usize, forward: bool) -> Option<Place> {
        let all = (0..self.steps(solution))
            .flat_map(|step| (0..symbols(solution, step).len()).map(move |symbol| (step, symbol)));
        match (self.symbol, forward) {
            (None, _) => all.clone().find(|place| place.0 >= from).or_else(|| all.clone().next_back()),
            (Some(here), true) => all.clone().find(|place| *place > here),
            (Some(here), false) => all.clone().rfind(|place| *place < here),
        }
    }
}

/// The inputs and results of earlier steps that a step is made of, in the order of its formula.
pub fn symbols(solution: &Solution, step: usize) -> Vec<Id> {
    let formula = solution.steps.get(step).and_then(|step| step.formula);
    formula.map_or_else(Vec::new, |formula| leaves(solution, formula))
}

/// The step whose result a node is.
pub fn step_of(solution: &Solution, id: Id) -> Option<usize> {
    if let Op::Step(step) = solution.trace.node(id).op { Some(step) } else { None }
}

/// The inputs and results of steps that a node is made of, each once.
fn leaves(solution: &Solution, id: Id) -> Vec<Id> {
    let (mut found, mut names, mut seen) = (Vec::new(), Vec::new(), HashSet::new());
    let mut open = vec![id];
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        match &solution.trace.node(id).op {
            // The same input may stand in several nodes.
            Op::Given { path, .. } if names.contains(&path) => {}
            Op::Given { path, .. } => {
                names.push(path);
                found.push(id);
            }
            Op::Step(_) => found.push(id),
            _ => open.extend(solution.trace.operands(id).into_iter().rev()),
        }
    }
    found
}
