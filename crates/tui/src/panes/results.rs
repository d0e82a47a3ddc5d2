//! The answers, how they were checked, and what is doubtful about them.

mod answer_list;
mod difference;
mod questions;

use dalembert_core::{Check, Display, Locale, Solution, Text};
use dalembert_report::show_answer_in;
use dalembert_units::{self as unit, Kind, Style as Digits, write_number};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{
    reasons::{self, marked, stale},
    wrap,
};
use crate::{
    glyphs::filter_untrusted,
    intent::Intent,
    keys::{Action, KeyContext},
    look::{Appearance, Glyph},
    pane::{Page, Pane, Ui, register_pane},
    problem::Problem,
};

/// The fewest and the most digits of an answer.
const DIGITS: (u8, u8) = (3, 12);

/// The pane of answers.
#[derive(Debug, Default)]
pub struct Results {
    /// The answer whose unit and digits are chosen, by its place.
    chosen: Option<usize>,
    /// True if long lists and every check are shown.
    opened: bool,
}

register_pane!(Results, 10);

impl Pane for Results {
    fn name(&self) -> &'static str {
        "Results"
    }

    fn page(&self, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        let mut lines = reasons::why_not(problem, ui, width);
        for file in problem.document.linked.iter().filter(|file| file.unsaved) {
            let said = Text::new("linked file {file} is used as it is open, with unsaved changes");
            let said = filter_untrusted(&said.with("file", &file.path).render(ui.locale)).into_owned();
            let style = ui.look.warning();
            lines.extend(marked(ui.look, Glyph::Warning, style, &said, style, width.into()));
        }
        let Some(solution) = problem.found.solution.as_ref().filter(|_| !problem.hides_numbers()) else {
            return Page::of(lines);
        };
        if !lines.is_empty() {
            lines.push(Line::default());
        }
        let (found, pinned) = (&problem.found, problem.found.pinned.as_ref());
        let key = ui.key(KeyContext::Pane, Action::Enter);
        let opened_by = (!self.opened).then_some(key.as_str());
        let reading = Reading { revealed: found.revealed, chosen: self.chosen, opened_by, pinned };
        let page = page(solution, &reading, ui.look, ui.locale, width);
        let own = page.lines.clone();
        lines.extend(if problem.is_stale() { stale(own, ui.look, ui.locale, width) } else { own });
        page.behind(lines)
    }

    fn first_part_of(&self, problem: &Problem, name: &str) -> Option<usize> {
        let solution = problem.found.solution.as_ref().filter(|_| !problem.hides_numbers())?;
        solution.answers.iter().position(|answer| answer.problem == name)
    }

    fn about(&self, _: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        let text = match self.chosen {
            Some(_) => {
                Text::new("{keys} select the answer; {working} its working, {unit} unit, {digits} digits, {give} give its value")
                    .with("keys", ui.pair(KeyContext::Pane, Action::Up, Action::Down))
                    .with("working", ui.key(KeyContext::Pane, Action::Enter))
                    .with("give", ui.key(KeyContext::Pane, Action::Give))
            }
            None => Text::new("{unit} unit of an answer, {digits} digits, {ask} ask a question")
                .with("ask", ui.key(KeyContext::Pane, Action::UsualQuestions)),
        };
        let key = |action| ui.key(KeyContext::Pane, action);
        vec![text.with("unit", key(Action::NextDisplayUnit)).with("digits", key(Action::NextDigits))]
    }

    fn act(&mut self, problem: &mut Problem, ui: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        match (action, self.chosen) {
            (Action::Give, Some(at)) => Some(give(problem, at)),
            (Action::Enter, Some(at)) => {
                let found = &mut problem.found;
                let answer = found.solution.as_ref()?.answers.get(at)?;
                found.working_of = Some(answer.name.to_string());
                Some(vec![Intent::TurnTo("Working")])
            }
            (Action::Enter, None) => {
                self.opened = !self.opened;
                Some(Vec::new())
            }
            (Action::UsualQuestions, _) => Some(vec![Intent::Show(questions::dialog(problem, ui))]),
            (Action::NextDisplayUnit | Action::NextDigits | Action::Give, _) => {
                Some(self.display(problem, ui, action))
            }
            (Action::Up | Action::Down, Some(at)) => {
                let answers = problem.found.solution.as_ref().map_or(0, |solution| solution.answers.len());
                let by = if action == Action::Up { -1 } else { 1 };
                let at = at.saturating_add_signed(by).min(answers.saturating_sub(1));
                self.chosen = Some(at);
                Some(vec![Intent::BringIn(at)])
            }
            (Action::Back, Some(_)) => {
                self.chosen = None;
                Some(Vec::new())
            }
            _ => None,
        }
    }
}

impl Results {
    /// Shows the chosen answer in its next unit, or with another number of digits; without a chosen one, chooses the
    /// first.
    fn display(&mut self, problem: &mut Problem, ui: &Ui<'_>, action: Action) -> Vec<Intent> {
        let usual = ui.locale.style.digits;
        let Some(solution) = problem.found.solution.as_ref().filter(|found| !found.answers.is_empty()) else {
            return Vec::new();
        };
        let Some(at) = self.chosen else {
            self.chosen = Some(0);
            let key = |action| ui.key(KeyContext::Pane, action);
            let said = Text::new(
                "{keys} select the answer; {working} its working, {unit} unit, {digits} digits, {give} give its value; {back} back",
            )
            .with("working", key(Action::Enter))
            .with("keys", ui.pair(KeyContext::Pane, Action::Up, Action::Down))
            .with("unit", key(Action::NextDisplayUnit))
            .with("digits", key(Action::NextDigits))
            .with("give", key(Action::Give))
            .with("back", key(Action::Back));
            return Intent::say(said);
        };
        let answer = &solution.answers[at.min(solution.answers.len() - 1)];
        let name = answer.name.to_string();
        let known = problem.document.show.iter().find(|(known, _)| *known == name);
        let mut display = known.map_or_else(Display::default, |(_, text)| Display::of(text));
        if action == Action::NextDigits {
            let next = match display.digits.unwrap_or(usual) {
                digits if digits >= DIGITS.1 => DIGITS.0,
                digits => digits + 1,
            };
            display.digits = Some(next).filter(|next| *next != usual);
        } else {
            let now = answer.unit.ascii();
            let all: Vec<&str> = Kind::of(&answer.unit)
                .units()
                .iter()
                .copied()
                .filter(|unit| !["1", "dB"].contains(unit))
                .collect();
            let same = |unit: &str| unit::unit(unit).is_ok_and(|unit| unit.ascii() == now);
            let at = all.iter().position(|unit| same(unit));
            match all.get(at.map_or(0, |at| (at + 1) % all.len().max(1))) {
                Some(unit) if !same(unit) => (*unit).clone_into(&mut display.unit),
                _ => return Intent::say("no other unit available"),
            }
        }
        put(problem, &name, &display);
        vec![Intent::Keep]
    }
}

/// Gives the value of an answer, so that an input can be found from it.
fn give(problem: &mut Problem, at: usize) -> Vec<Intent> {
    let answer = problem.found.solution.as_ref().and_then(|solution| solution.answers.get(at));
    let Some((answer, si)) = answer.and_then(|answer| Some((answer, answer.si()?))) else {
        return Intent::say("only the value of a single number can be given");
    };
    let value = unit::write_quantity(si, &answer.unit, Digits::default());
    let Some(path) = problem.inputs.form.give(&answer.name.to_string(), &value) else { return Vec::new() };
    let said = "enter the known value here, and ? in the input that is to be found";
    vec![Intent::Changed, Intent::GoToInput(path), Intent::Say(said.into())]
}

/// Takes how an answer is shown from now on.
fn put(problem: &mut Problem, name: &str, display: &Display) {
    let text = display.to_string();
    let (found, document) = (&mut problem.found, &mut problem.document);
    for solution in found.solution.iter_mut().chain(&mut found.pinned) {
        // It is a unit of its kind.
        let _ = show_answer_in(solution, name, &text);
    }
    match document.show.iter_mut().find(|(known, _)| known == name) {
        Some((_, old)) => *old = text,
        None => document.show.push((name.to_owned(), text)),
    }
    document.show_changed = true;
}

/// Answers, warnings and checks of a solution; faults of the program before them.
pub fn lines(solution: &Solution, look: &Appearance, locale: &Locale, width: u16) -> Vec<Line<'static>> {
    read(solution, None, None, look, locale, width)
}

/// The same as far as so many steps of the worked solution are revealed; each answer with its difference to the same one of a pinned
/// solution, where there is one.
pub fn read(
    solution: &Solution,
    revealed: Option<usize>,
    pinned: Option<&Solution>,
    look: &Appearance,
    locale: &Locale,
    width: u16,
) -> Vec<Line<'static>> {
    let reading = Reading { revealed, pinned, chosen: None, opened_by: None };
    page(solution, &reading, look, locale, width).lines
}

/// Choices of the user for reading a solution.
struct Reading<'a> {
    /// So many steps of the worked solution are revealed; `None`: all.
    revealed: Option<usize>,
    /// The answer that is chosen.
    chosen: Option<usize>,
    /// The key that shows long lists and every check; `None` where they are shown.
    opened_by: Option<&'a str>,
    /// The solution that it is compared with.
    pinned: Option<&'a Solution>,
}

/// The same; the page starts at each answer, of which one may be chosen.
fn page(solution: &Solution, reading: &Reading<'_>, look: &Appearance, locale: &Locale, width: u16) -> Page {
    let width = usize::from(width).max(1);
    let locale = &locale.ascii(look.ascii);
    let mut lines = Vec::new();
    if !solution.defects.is_empty() {
        let words = Text::new("Internal error, not caused by your inputs; do not trust these results:");
        lines.extend(marked(look, Glyph::Bad, look.error(), &words.render(locale), look.error(), width));
        for defect in &solution.defects {
            lines.extend(wrap::hanging(vec![Span::raw("    ")], defect, look.error(), width));
        }
        lines.push(Line::default());
    }
    if reading.pinned.is_some() {
        let note = Text::new("with the difference from the pinned result").render(locale);
        lines.extend(wrap::words(&note, width).into_iter().map(|line| Line::styled(line, look.dim())));
    }
    if let Some(units) = solution.units {
        let line = units.line().render(locale);
        lines.extend(wrap::words(&line, width).into_iter().map(|line| Line::styled(line, look.dim())));
    }
    let before = lines.len();
    let answers = answer_list::page(solution, reading, look, locale, width);
    let starts = answers.starts.into_iter().map(|start| start + before).collect();
    let head = before + answers.head;
    lines.extend(answers.lines);
    if !solution.warnings.is_empty() {
        lines.push(Line::default());
        for warning in &solution.warnings {
            let words = warning.render(locale);
            lines.extend(marked(look, Glyph::Warning, look.warning(), &words, Style::new(), width));
        }
    }
    if !solution.checks.is_empty() {
        lines.push(Line::default());
        // What failed comes first.
        let (passed, failed): (Vec<_>, Vec<_>) = solution.checks.iter().partition(|check| check.passed);
        lines.extend(failed.into_iter().flat_map(|one| check(one, look, locale, width)));
        match reading.opened_by {
            None => lines.extend(passed.into_iter().flat_map(|one| check(one, look, locale, width))),
            Some(_) if passed.is_empty() => {}
            Some(key) => {
                let words = passed_checks(&passed, key, locale).render(locale);
                lines.extend(marked(look, Glyph::Good, look.good(), &words, look.dim(), width));
            }
        }
    }
    Page { lines, starts, head }
}

/// All checks that passed in one line.
fn passed_checks(passed: &[&Check], key: &str, locale: &Locale) -> Text {
    let most = passed.iter().map(|check| check.residual).fold(ROUNDING, f64::max);
    let text = match passed.len() {
        1 => Text::new("1 check passed (difference ≤ {difference}); {key} shows it"),
        count => Text::new("{count} checks passed (differences ≤ {difference}); {key} shows them")
            .with("count", count),
    };
    text.with("difference", write_number(most, Digits { digits: 1, ..locale.style })).with("key", key)
}

/// A relative difference below this is not shown: its digits are rounding and differ from processor to processor.
const ROUNDING: f64 = 1e-9;

fn check(check: &Check, look: &Appearance, locale: &Locale, width: usize) -> Vec<Line<'static>> {
    let difference = write_number(check.residual, Digits { digits: 1, ..locale.style });
    let outcome = match (check.passed, check.residual <= ROUNDING) {
        (true, true) => Text::new("verified by a second method"),
        (true, false) => Text::new("verified by a second method (relative difference {difference})"),
        (false, _) => Text::new("FAILED: a second method differs by {difference}"),
    };
    let outcome = outcome.with("difference", difference);
    let (glyph, style, words_style) = if check.passed {
        (Glyph::Good, look.good(), look.dim())
    } else {
        (Glyph::Bad, look.error(), look.error())
    };
    let (what, outcome) = (check.what.render(locale), outcome.render(locale));
    let mut lines: Vec<_> = marked(look, glyph, style, &what, Style::new(), width).collect();
    // Beside what is compared where it fits, below it where it does not.
    match lines.last_mut() {
        Some(line) if line.width() + 2 + outcome.width() <= width => {
            line.push_span(Span::styled(format!("  {outcome}"), words_style));
        }
        _ => lines.extend(wrap::hanging(vec![Span::raw("  ")], &outcome, words_style, width)),
    }
    lines
}
