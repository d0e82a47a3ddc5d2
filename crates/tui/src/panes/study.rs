//! A study: its plan, which is edited line by line, and what it found.

mod add;
mod draft;
mod kind;
mod lines;
mod plan;

use std::path::PathBuf;

use dalembert_core::{FieldError, Plot, Refusal, Text, study::StudyPlan};
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
};

use self::{
    draft::{Way, names_a_file},
    kind::Kind,
    plan::{Cell, Plan, Slot, Subject},
};
use super::{about_number, answers, begun, reasons};
use crate::{
    ask::{Question, Reply},
    dialog::{Choice, Chosen, Dialog},
    intent::Intent,
    keys::{Action, KeyContext},
    pane::{Gesture, Page, Pane, Ui, register_pane},
    pixels::Picture,
    plot,
    problem::{OpenFile, Problem},
};

/// A plot in fewer rows than these tells nothing.
const LEAST_CURVES: u16 = 7;

/// The pane of a study. What it finds is part of the problem, since its curves are shown among the plots.
#[derive(Debug, Default)]
pub struct Study {
    /// The cell under the cursor.
    cursor: usize,
    /// The input that it begins with, by its path: that of the cursor of the form when the tab was turned to.
    begins: String,
    plan: Plan,
    /// Place of the curves under the pointer of the mouse.
    pointer: Option<f64>,
}

register_pane!(Study, 80);

impl Pane for Study {
    fn name(&self) -> &'static str {
        "Study"
    }

    fn place(&self) -> KeyContext {
        KeyContext::Plan
    }

    fn is_useful(&self, problem: &Problem) -> bool {
        problem.found.solution.as_ref().is_some_and(|found| !answers::numbers(found).is_empty())
    }

    fn page(&self, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        if problem.found.revealed.is_some() {
            return reasons::covered(ui, width);
        }
        if problem.found.solution.is_none() || problem.is_stale() {
            return Page::of(reasons::why_not(problem, ui, width));
        }
        self.subject(problem).map_or_else(Page::default, |of| self.lines(&of, problem, ui, width))
    }

    /// Shows the curves of the answer under the cursor, or of the first, where there is room below the lines.
    fn draw(&self, problem: &Problem, ui: &Ui<'_>, room: Rect, buffer: &mut Buffer) -> Vec<Picture> {
        if room.height < LEAST_CURVES || problem.is_stale() || problem.found.revealed.is_some() {
            return Vec::new();
        }
        let Some(plot) = self.curves(problem) else { return Vec::new() };
        let state = plot::PlotState { marker: ui.marker, pointer: self.pointer, ..Default::default() };
        plot::render(plot, None, &state, ui.look, ui.locale, room, buffer)
    }

    /// The curves are read under the pointer.
    fn mouse(&mut self, problem: &Problem, ui: &Ui<'_>, gesture: Gesture, at: Position) -> bool {
        let Some(plot) = self.curves(problem) else { return false };
        let state = plot::PlotState { marker: ui.marker, ..Default::default() };
        match gesture {
            Gesture::Leave => self.pointer = None,
            Gesture::Hover => {
                let lines = self.page(problem, ui, ui.area.width).lines.len();
                let is_below = usize::from(at.y.saturating_sub(ui.area.y)) > lines;
                let place = plot::place_at(plot, &state, ui.look, ui.locale, ui.area, at.x);
                let place = place.filter(|_| is_below).map(|(place, _)| place);
                self.pointer = state.with_pointer(plot, place).pointer;
            }
            _ => return false,
        }
        gesture == Gesture::Leave || self.pointer.is_some()
    }

    fn about(&self, problem: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        let keys = ui.pair(KeyContext::Plan, Action::Left, Action::Right);
        let key = |action| ui.key(KeyContext::Plan, action);
        let text = match self.subject(problem).map(|of| self.under_cursor(&of)) {
            Some(Cell::Vary(_)) => {
                Text::new("{keys} another input, {how} how it varies, {remove} removes it")
                    .with("how", key(Action::Toggle))
                    .with("remove", key(Action::DeleteRow))
            }
            Some(Cell::Inputs) => Text::new("{keys} shows or hides the inputs that vary"),
            Some(Cell::Answer(_)) => {
                Text::new("{keys} another answer, {add} one more").with("add", key(Action::AddRow))
            }
            Some(Cell::Kind) => {
                Text::new("{keys} another kind: {about}").with_text("about", self.plan.kind.about())
            }
            _ => "curves are also shown in Plot, with cursor and zoom".into(),
        };
        vec![text.with("keys", keys)]
    }

    fn serves(&self, problem: &Problem, action: Action) -> bool {
        let Some(cell) = self.subject(problem).map(|of| self.under_cursor(&of)) else { return false };
        match action {
            Action::Toggle => matches!(cell, Cell::Vary(_)),
            Action::Enter => !cell.is_choice(),
            Action::Left => cell.is_choice() || matches!(cell, Cell::Vary(_)),
            _ => true,
        }
    }

    fn act(&mut self, problem: &mut Problem, ui: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        let of = self.subject(problem)?;
        let cell = self.under_cursor(&of);
        let mut to = cell;
        match (action, cell) {
            (Action::AddRow, _) => return Some(vec![self.offer(&of, ui)]),
            (Action::Toggle, Cell::Vary(at)) => return Some(self.offer_ways(&of, at, ui)),
            (Action::Left | Action::Right | Action::Toggle, Cell::Inputs) => {
                self.plan.unfolded = !self.plan.unfolded;
                return Some(Vec::new());
            }
            (Action::Left | Action::Right, _) => {
                self.plan.choose(cell, if action == Action::Left { -1 } else { 1 }, &of);
            }
            (Action::DeleteRow, _) => self.plan.remove(cell, &of),
            (Action::MoveRowUp | Action::MoveRowDown, Cell::Vary(at)) => {
                to = Cell::Vary(self.plan.swap(at, if action == Action::MoveRowUp { -1 } else { 1 }, &of));
            }
            _ => return None,
        }
        problem.found.studied = None;
        self.go_to(to, problem);
        Some(vec![Intent::Ask])
    }

    fn chosen(&mut self, problem: &mut Problem, what: &str) -> Vec<Intent> {
        let Some(of) = self.subject(problem) else { return Vec::new() };
        let (to, begins) = match what.split_once('=') {
            Some((HOW, line)) => {
                let Cell::Vary(at) = self.under_cursor(&of) else { return Vec::new() };
                line.clone_into(&mut self.plan.edit(&of).vary[at].text);
                (Cell::Vary(at), names_a_file(line))
            }
            Some((ADD, what)) => self.plan.add(what, &of),
            _ => return Vec::new(),
        };
        problem.found.studied = None;
        self.go_to(to, problem);
        let mut intents = vec![Intent::Ask, Intent::BringIn(self.cursor)];
        if begins {
            intents.push(Intent::Press(KeyContext::Plan, Action::Enter));
        }
        intents
    }

    fn cursor<'a>(&'a mut self, _: &'a mut Problem) -> Option<&'a mut usize> {
        Some(&mut self.cursor)
    }

    fn turned_to(&mut self, problem: &mut Problem) -> Vec<Intent> {
        if begun(&mut self.begins, problem) && self.plan.follows_form() {
            problem.found.studied = None;
        }
        Vec::new()
    }

    fn cells(&self, problem: &Problem) -> usize {
        self.subject(problem).map_or(0, |of| self.plan.cells(&of).len())
    }

    fn cell(&self, problem: &Problem) -> Option<String> {
        let of = self.subject(problem)?;
        let cell = self.under_cursor(&of);
        (!cell.is_choice()).then(|| self.plan.text(cell, &of))
    }

    fn about_cell(&self, problem: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        let Some(of) = self.subject(problem) else { return Vec::new() };
        let cell = self.under_cursor(&of);
        let form = match cell {
            Cell::Wanted => of.answer().and_then(|answer| about_number(&answer.unit, ui)),
            Cell::Vary(at) => {
                let unit = of.varied(at).and_then(|input| about_number(&input.unit, ui));
                let form = Text::new("as in 1..9:5, 1; 3 or normal(2 %)");
                return unit.into_iter().chain([form, self.plan.label(cell, &of)]).collect();
            }
            Cell::Limit(_) | Cell::Condition(_) => Some(Text::new("as in amplitude > 0.2 mm")),
            Cell::Correlation(_) => Some(Text::new("as in mass; speed: 0.5")),
            _ => Some(Text::new("a whole number")),
        };
        form.into_iter().chain([self.plan.label(cell, &of)]).collect()
    }

    fn typed(&mut self, problem: &mut Problem, text: String) {
        let Some(of) = self.subject(problem) else { return };
        self.plan.set(self.under_cursor(&of), text, &of);
        problem.found.studied = None;
    }

    fn question(&self, problem: &Problem) -> Option<Question> {
        let of = self.subject(problem)?;
        let (entry, record) = (problem.entry(), problem.record()?);
        if self.plan.kind == Kind::Find {
            let (input, answer) = self.plan.target(&of).ok()?;
            return Some(Question::Find { entry, record, input, answer });
        }
        let mut plan = self.plan.read(&of).ok()?;
        let solution = problem.found.solution.as_ref()?;
        if self.plan.kind == Kind::Sweep {
            plan.answers = answers::with_other_limits(solution, plan.answers);
        }
        let answers = solution.answers.clone();
        Some(Question::Study { entry, record, answers, plan: Box::new(plan), folder: self.folder(problem) })
    }

    fn plan_file(&self) -> Option<&OpenFile> {
        self.plan.file.as_ref().filter(|_| self.plan.kind == Kind::File)
    }

    fn plan(&self, problem: &Problem) -> Result<StudyPlan, Vec<FieldError>> {
        let Some(of) = self.subject(problem) else {
            return Err(vec![FieldError::new("problem", "the problem has no solution to vary")]);
        };
        if self.plan.kind == Kind::Find {
            let why = "a search for a target value has no plan; choose a sweep or Monte Carlo";
            return Err(vec![FieldError::new("study", why)]);
        }
        self.plan.read(&of)
    }

    fn take_plan(&mut self, problem: &mut Problem, plan: &StudyPlan, file: OpenFile) {
        let inputs = problem.record().map(|record| Problem::numbers(&record)).unwrap_or_default();
        self.plan.slots[Kind::File as usize] = Slot {
            answers: Some(plan.answers.clone()),
            draft: Some(draft::Draft::of(plan, &inputs)),
            wanted: String::new(),
        };
        if self.plan.kind != Kind::File {
            // What became the plan of a file is there no more as it was.
            self.cursor = 0;
        }
        (self.plan.kind, self.plan.file) = (Kind::File, Some(file));
        problem.found.studied = None;
    }

    fn is_answered(&self, problem: &Problem) -> bool {
        problem.found.studied.as_ref().is_some_and(|found| !is_partial(found))
    }

    fn answered(&mut self, problem: &mut Problem, reply: Option<Reply>) -> Vec<Intent> {
        problem.found.studied = Some(match reply {
            Some(Reply::Study(found)) => *found,
            _ => Err(Refusal::because("failed (internal error)").into()),
        });
        Vec::new()
    }

    /// Keeps the results of a study that is cancelled.
    fn forget(&mut self, problem: &mut Problem, inputs: bool) {
        problem.found.studied.take_if(|found| inputs || !is_partial(found));
    }
}

/// First word of a choice from a list: a line of the input under the cursor, or something to add.
const HOW: &str = "how";
const ADD: &str = "add";

impl Study {
    /// The subject of the study; `None` while there are no inputs or answers to choose from.
    fn subject<'p>(&self, problem: &'p Problem) -> Option<Subject<'p>> {
        Some(self.plan.subject(problem, &problem.record()?, problem.found.solution.as_ref()?, &self.begins))
    }

    /// The curves of the answer under the cursor, or of the first.
    fn curves<'p>(&self, problem: &'p Problem) -> Option<&'p Plot> {
        let at = match self.subject(problem).map(|of| self.under_cursor(&of)) {
            Some(Cell::Answer(at)) => at,
            _ => 0,
        };
        problem.studied().nth(at).or_else(|| problem.studied().next())
    }

    fn under_cursor(&self, of: &Subject<'_>) -> Cell {
        let cells = self.plan.cells(of);
        cells[self.cursor.min(cells.len() - 1)]
    }

    /// The cursor goes to a cell, or to the one before where it is the last of its list that was removed.
    fn go_to(&mut self, cell: Cell, problem: &Problem) {
        let Some(of) = self.subject(problem) else { return };
        let cells = self.plan.cells(&of);
        let at = cells.iter().position(|known| *known == cell);
        let before = cell.before().and_then(|before| cells.iter().position(|known| *known == before));
        self.cursor = at.or(before).unwrap_or(self.cursor).min(cells.len() - 1);
    }

    /// The ways in which an input may vary, to choose from.
    fn offer_ways(&self, of: &Subject<'_>, at: usize, ui: &Ui<'_>) -> Vec<Intent> {
        let Some(input) = of.varied(at) else { return Vec::new() };
        let tolerance = of.tolerance(&input.path);
        let tolerance = if tolerance.is_empty() { input.step_text() } else { tolerance };
        let option = |(way, name): (Way, &'static str)| {
            let line = way.line(input, tolerance);
            (!line.is_empty()).then(|| Choice {
                label: line.clone(),
                help: Text::new(name).render(ui.locale),
                value: Chosen::OfPane(format!("{HOW}={line}")),
            })
        };
        let options: Vec<Choice> = Way::ALL.into_iter().filter_map(option).collect();
        let now = self.plan.text(Cell::Vary(at), of);
        let chosen = options.iter().position(|choice| choice.label == now).unwrap_or(0);
        vec![Intent::Show(Dialog::Choice { path: String::new(), options, chosen })]
    }

    /// List of what a plan may have more of.
    fn offer(&self, of: &Subject<'_>, ui: &Ui<'_>) -> Intent {
        let options = self.plan.additions(of).into_iter().map(|(label, help, what)| Choice {
            label: label.render(ui.locale),
            help: help.render(ui.locale),
            value: Chosen::OfPane(format!("{ADD}={what}")),
        });
        Intent::Show(Dialog::Choice { path: String::new(), options: options.collect(), chosen: 0 })
    }

    /// The folder of the files that the plan names: its own, or that of the problem.
    fn folder(&self, problem: &Problem) -> PathBuf {
        let own = self.plan_file().map(|file| &file.path);
        let path = own.or(problem.document.file.as_ref().map(|file| &file.path));
        path.and_then(|path| path.parent()).map_or_else(PathBuf::new, Into::into)
    }
}

fn is_partial(found: &Result<crate::ask::StudyResult, dalembert_core::SolveError>) -> bool {
    found.as_ref().is_ok_and(|found| found.progress.is_some())
}
