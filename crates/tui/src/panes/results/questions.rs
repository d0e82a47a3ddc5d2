//! The list of the usual questions of a problem.

use dalembert_core::{Text, suggestions::suggestions};

use crate::{
    dialog::{Choice, Chosen, Dialog},
    pane::Ui,
    problem::Problem,
};

/// The usual questions of the present solution with what they come to, and behind them a question of the user's own.
/// Where the numbers are hidden, so are theirs.
pub(super) fn dialog(problem: &Problem, ui: &Ui<'_>) -> Dialog {
    let shows = problem.found.revealed.is_none() && !problem.is_stale();
    let solution = problem.found.solution.as_ref().filter(|_| !problem.is_stale());
    let offered = solution.map(|solution| suggestions(problem.entry(), solution)).unwrap_or_default();
    let style = ui.locale.ascii(ui.look.ascii).style;
    let question = |question| {
        let question: Box<dalembert_core::suggestions::Suggestion> = Box::new(question);
        let title = ui.look.words(&question.title(ui.locale)).into_owned();
        let label = if shows { format!("{title} = {}", question.shown(style)) } else { title };
        Choice { label, help: question.formula.clone(), value: Chosen::Question(question) }
    };
    let own = Choice {
        label: Text::from("A question of your own").render(ui.locale),
        help: Text::from("a name and a formula over inputs, answers and steps: 2*X").render(ui.locale),
        value: Chosen::OwnQuestion,
    };
    let options = offered.into_iter().map(question).chain([own]).collect();
    Dialog::Choice { path: "ask".to_owned(), options, chosen: 0 }
}
