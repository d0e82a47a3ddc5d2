//! The steps of a worked solution: how many are revealed, what they cover, and the symbols they are made of.

use std::collections::HashSet;

use dalembert_core::{
    Answer, AnswerValue, Locale, Solution, problem_heading,
    trace::{Id, Op},
};
use dalembert_plot::look::Appearance;
use ratatui::text::Line;

/// Line of the heading of a problem or a configuration among several.
pub(super) fn heading(
    is_first: bool,
    name: &str,
    look: &Appearance,
    locale: &Locale,
) -> Option<Line<'static>> {
    problem_heading(is_first, name).map(|text| Line::styled(text.render(locale), look.title()))
}

/// The number of steps of a solution that are revealed.
pub(super) fn shown(revealed: Option<usize>, solution: &Solution) -> usize {
    revealed.map_or(solution.steps.len(), |revealed| revealed.min(solution.steps.len()))
}

/// True if an answer is covered: some step that leads to it is not revealed.
pub(super) fn covers(revealed: Option<usize>, solution: &Solution, answer: &Answer) -> bool {
    let Some(revealed) = revealed else { return false };
    let last = match answer.value {
        AnswerValue::Number(_, id) => {
            leaves(solution, id).into_iter().filter_map(|id| step_of(solution, id)).max()
        }
        AnswerValue::Set(..) | AnswerValue::List(_) => None,
    };
    last.unwrap_or(solution.steps.len().saturating_sub(1)) >= revealed
}

/// The inputs and results of earlier steps that a step is made of, in the order of its formula.
pub(super) fn symbols(solution: &Solution, step: usize) -> Vec<Id> {
    let formula = solution.steps.get(step).and_then(|step| step.formula);
    formula.map_or_else(Vec::new, |formula| leaves(solution, formula))
}

/// The step whose result a node is.
pub(super) fn step_of(solution: &Solution, id: Id) -> Option<usize> {
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
