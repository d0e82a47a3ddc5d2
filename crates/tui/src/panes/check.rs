//! The user's own answers, each beside what is said of it.

use std::collections::{BTreeMap, BTreeSet};

use dalembert_core::{
    Answer, Locale, Solution, Text,
    check::{self, Cause, Causes, Verdict},
    hints::{self, HintLevel},
};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{
    about_number,
    columns::{padded, typed_in},
    reasons, wrap,
};
use crate::{
    ask::{Question, Reply},
    glyphs::filter_untrusted,
    intent::Intent,
    keys::{Action, KeyContext},
    look::{Appearance, Glyph},
    pane::{Page, Pane, Ui, register_pane},
    problem::Problem,
    remembered::Progress,
    text_entry::TextEntry,
    typed::Typed,
};

/// Cells of the narrowest and of the widest cell to type in.
const CELL: (usize, usize) = (10, 24);

/// The pane of the user's own answers.
#[derive(Debug, Default)]
pub struct Check {
    /// The answer under the cursor.
    cursor: usize,
    /// Texts that were typed, by the name of the answer.
    typed: Typed<String>,
    /// The answers that the user asked to see.
    seen: BTreeSet<String>,
    /// The causes of what was typed, as far as they were found.
    causes: Causes,
    /// True if the search for them has come to its end.
    is_searched: bool,
    /// Number of hints that were asked for, by the name of the answer.
    hints: BTreeMap<String, usize>,
    /// True if it was said that everything is right.
    congratulated: bool,
}

register_pane!(Check, 60);

impl Pane for Check {
    fn name(&self) -> &'static str {
        "Check"
    }

    fn place(&self) -> KeyContext {
        KeyContext::Cells
    }

    fn covers_results(&self, problem: &Problem) -> bool {
        !self.congratulated || problem.found.revealed.is_some()
    }

    fn is_useful(&self, problem: &Problem) -> bool {
        problem.found.solution.as_ref().is_some_and(|found| !found.answers.is_empty())
    }

    fn page(&self, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        match &problem.found.solution {
            Some(solution) if !problem.is_stale() => {
                self.lines(solution, &order(problem, solution), ui, width)
            }
            _ => Page::of(reasons::why_not(problem, ui, width)),
        }
    }

    fn about(&self, _: &Problem, _: &Ui<'_>) -> Vec<Text> {
        vec!["value with unit, e.g. 19.5 mm; checked as you type".into()]
    }

    fn serves(&self, _: &Problem, action: Action) -> bool {
        action != Action::Left
    }

    /// Shows our answer under the cursor, or covers it again; gives the next hint.
    fn act(&mut self, problem: &mut Problem, _: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        let name = self.answer(problem)?.name.to_string();
        match action {
            Action::Toggle => {
                if !self.seen.remove(&name) {
                    self.seen.insert(name);
                }
                Some(Vec::new())
            }
            // Behind the last hint there is none again.
            Action::NextHint => {
                let shown = self.hints.entry(name).or_default();
                *shown = (*shown + 1) % (HintLevel::ALL.len() + 1);
                Some(vec![Intent::BringIn(self.cursor)])
            }
            _ => None,
        }
    }

    fn cursor<'a>(&'a mut self, _: &'a mut Problem) -> Option<&'a mut usize> {
        Some(&mut self.cursor)
    }

    fn cells(&self, problem: &Problem) -> usize {
        problem.found.solution.as_ref().map_or(0, |solution| solution.answers.len())
    }

    fn cell(&self, problem: &Problem) -> Option<String> {
        Some(self.text(&self.answer(problem)?.name.to_string()).to_owned())
    }

    fn about_cell(&self, problem: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        let Some(answer) = self.answer(problem) else { return Vec::new() };
        let form = match answer.si() {
            Some(_) => about_number(&answer.unit, ui),
            None => Some(Text::new("write it as in `{example}`").with("example", check::example(answer))),
        };
        [answer.title()].into_iter().chain(form).collect()
    }

    fn typed(&mut self, problem: &mut Problem, text: String) {
        if let Some(name) = self.answer(problem).map(|answer| answer.name.to_string()) {
            (self.causes, self.is_searched) = (Vec::new(), false);
            self.typed.set(&name, text);
        }
    }

    /// Says once that what is asked for is right, which is remembered of a published case.
    fn kept(&mut self, problem: &mut Problem) -> Vec<Intent> {
        let Some(solution) = problem.found.solution.as_ref().filter(|_| !problem.is_stale()) else {
            return Vec::new();
        };
        let names: Vec<String> = solution.answers.iter().map(|answer| answer.name.to_string()).collect();
        // Of a published case, what it asks for; of other problems, everything.
        let asked = problem.published().map(|case| case.asked.iter().map(String::as_str));
        let wanted: Vec<&str> = match asked {
            Some(asked) => asked.filter(|name| names.iter().any(|known| known == name)).collect(),
            None => names.iter().map(String::as_str).collect(),
        };
        let is_done = match problem.asked() {
            [] => self.is_right(solution, &wanted),
            _ => wanted.iter().all(|name| self.verdict(solution, name) == Some(Verdict::Right)),
        };
        if wanted.is_empty() || !is_done || std::mem::replace(&mut self.congratulated, true) {
            return Vec::new();
        }
        problem.found.revealed = None;
        vec![Intent::Say("all required answers are correct".into()), Intent::Reach(Progress::Solved)]
    }

    fn question(&self, problem: &Problem) -> Option<Question> {
        let solution = problem.found.solution.as_ref()?;
        let is_wrong = |(name, _): &(String, String)| {
            matches!(self.verdict(solution, name), Some(Verdict::Wrong | Verdict::RoundedEarly(_)))
        };
        if self.is_searched || !self.typed.0.iter().any(is_wrong) {
            return None;
        }
        Some(Question::Causes {
            entry: problem.entry(),
            record: problem.record()?,
            solution: Box::new(solution.clone()),
            typed: self.typed.0.clone(),
        })
    }

    fn is_answered(&self, _: &Problem) -> bool {
        self.is_searched
    }

    fn answered(&mut self, _: &mut Problem, reply: Option<Reply>) -> Vec<Intent> {
        (self.causes, self.is_searched) = match reply {
            Some(Reply::Causes { found, is_whole }) => (found, is_whole),
            _ => (Vec::new(), true),
        };
        // What is said of a wrong answer is read to its end.
        vec![Intent::BringIn(self.cursor)]
    }

    fn forget(&mut self, _: &mut Problem, inputs: bool) {
        (self.causes, self.is_searched) = (Vec::new(), false);
        self.congratulated &= !inputs;
    }
}

impl Check {
    /// The text that was typed for an answer.
    fn text(&self, name: &str) -> &str {
        self.typed.text(name)
    }

    /// The answer under the cursor.
    fn answer<'p>(&self, problem: &'p Problem) -> Option<&'p Answer> {
        let solution = problem.found.solution.as_ref()?;
        let order = order(problem, solution);
        solution.answers.get(*order.places.get(self.cursor.min(order.places.len().checked_sub(1)?))?)
    }

    /// The verdict on the user's answer of that name; `None` where there is none.
    fn verdict(&self, solution: &Solution, name: &str) -> Option<Verdict> {
        let text = self.text(name);
        let answer = solution.answer(name).filter(|_| !text.trim().is_empty())?;
        Some(check::compare(answer, text))
    }

    /// True if these answers are found: those that no other of them was made from are there, and all that are there
    /// are right.
    fn is_right(&self, solution: &Solution, wanted: &[&str]) -> bool {
        let verdict = |name: &str| self.verdict(solution, name);
        solution.last_of(wanted).into_iter().all(|name| verdict(name) == Some(Verdict::Right))
            && self.typed.0.iter().all(|(name, _)| verdict(name).is_none_or(|found| found == Verdict::Right))
    }

    /// The answers with what was typed for each; the page starts at each answer.
    fn lines(&self, solution: &Solution, order: &Order, ui: &Ui<'_>, width: u16) -> Page {
        let look = ui.look;
        let width = usize::from(width).max(1);
        let locale = &ui.locale.ascii(look.ascii);
        let mut page = Page::default();
        let words = "Enter your result. The reference value stays hidden until yours is correct.";
        let words = wrap::words(&Text::new(words).render(locale), width).into_iter();
        page.lines.extend(words.map(|line| Line::styled(line, look.dim())));
        if order.asked > 0 {
            page.lines.push(self.score(solution, order, look, locale));
        }
        page.lines.push(Line::default());
        let answers: Vec<&Answer> = order.places.iter().map(|place| &solution.answers[*place]).collect();
        let labels: Vec<String> = answers.iter().map(|answer| answer.label(locale)).collect();
        let longest = labels.iter().map(|label| label.width()).max().unwrap_or(0);
        let cell = (width / 3).clamp(CELL.0, CELL.1);
        let beside = width.saturating_sub(cell + 6);
        let columns = Columns { label: longest.min(beside), cell };
        for (n, (&answer, label)) in answers.iter().zip(&labels).enumerate() {
            if n == order.asked && n > 0 {
                let heading = Text::new("Further answers, not asked for").render(locale);
                page.lines.push(Line::default());
                page.lines.push(Line::styled(look.shortened(&heading, width), look.dim()));
            }
            page.starts.push(page.lines.len());
            let under_cursor = n == self.cursor;
            let one = One {
                answer,
                label,
                text: locale.style.decimal.written(self.text(&answer.name.to_string())),
                edit: ui.edit.filter(|_| under_cursor),
                focused: ui.focused && under_cursor,
                verdict: self.verdict(solution, &answer.name.to_string()),
            };
            one.line(&columns, look, &mut page.lines);
            self.said(&one, solution, ui.waits, (look, locale, width), &mut page.lines);
            self.hinted(&one, solution, (look, locale, width), &mut page.lines);
        }
        page
    }

    /// Line of how many of the answers that are asked for are right.
    fn score(&self, solution: &Solution, order: &Order, look: &Appearance, locale: &Locale) -> Line<'static> {
        let asked =
            order.places.iter().take(order.asked).map(|place| solution.answers[*place].name.to_string());
        let right = asked.filter(|name| self.verdict(solution, name) == Some(Verdict::Right)).count();
        let words =
            Text::new("Asked for: {right} of {count} right").with("right", right).with("count", order.asked);
        let style = if right == order.asked { look.good() } else { look.title() };
        Line::styled(words.render(locale), style)
    }

    /// Writes the hint that was asked for below the line.
    fn hinted(
        &self,
        one: &One<'_>,
        solution: &Solution,
        (look, locale, width): (&Appearance, &Locale, usize),
        lines: &mut Vec<Line<'static>>,
    ) {
        let shown = self.hints.get(&one.answer.name.to_string()).copied().unwrap_or(0);
        let Some(level) = shown.checked_sub(1).and_then(|at| HintLevel::ALL.get(at)) else { return };
        let heading = Text::new("Hint {n} of {count}: {level}")
            .with("n", shown)
            .with("count", HintLevel::ALL.len())
            .with_text("level", level.name());
        lines.extend(wrap::hanging(vec![Span::raw("    ")], &heading.render(locale), look.title(), width));
        let hint = hints::hint(solution, one.answer, *level, locale);
        if hint.earlier > 0 {
            let before = Text::new("{count} earlier steps are in Working").with("count", hint.earlier);
            lines.extend(wrap::hanging(vec![Span::raw("    ")], &before.render(locale), look.dim(), width));
        }
        for line in hint.lines {
            let text = match (line.symbol.is_empty(), line.source.is_empty()) {
                (false, _) => format!("{} = {}", line.symbol, line.text),
                (true, false) => format!("{} ({})", line.text, line.source),
                (true, true) => line.text,
            };
            let dot = format!("    {} ", look.glyph(Glyph::Dot));
            lines.extend(wrap::hanging(vec![Span::raw(dot)], &look.words(&text), Style::new(), width));
        }
    }

    /// Writes the comment below the line.
    fn said(
        &self,
        one: &One<'_>,
        solution: &Solution,
        waits: bool,
        (look, locale, width): (&Appearance, &Locale, usize),
        lines: &mut Vec<Line<'static>>,
    ) {
        let name = one.answer.name.to_string();
        let mut say = |text: &str, style: Style| {
            lines.extend(wrap::hanging(vec![Span::raw("    ")], text, style, width));
        };
        match &one.verdict {
            None | Some(Verdict::Right) => {}
            Some(verdict @ Verdict::TooFewDigits) => say(&verdict.text().render(locale), look.warning()),
            Some(Verdict::Unread(why)) => say(&filter_untrusted(&why.render(locale)), look.dim()),
            Some(verdict @ (Verdict::Wrong | Verdict::RoundedEarly(_))) => {
                let style = if *verdict == Verdict::Wrong { look.error() } else { look.warning() };
                let found = causes_of(&self.causes, &name);
                let head = match found {
                    [] if waits => "incorrect; searching for a common error that gives this value",
                    [] if !self.is_searched => "incorrect",
                    [] if *verdict == Verdict::Wrong => "Incorrect. No common error reproduces this value.",
                    [] => "",
                    [first, ..] if first.is_named => "Incorrect. Likely cause:",
                    _ => "Incorrect. Possible causes:",
                };
                match head {
                    "" => say(&verdict.text().render(&locale.digits(2)), style),
                    _ => say(&Text::new(head).render(locale), style),
                }
                let hints = self.hints.get(&name).copied().unwrap_or(0);
                let reveals = self.seen.contains(&name) || hints >= HintLevel::ALL.len();
                cause_lines(found, solution, reveals, (look, locale, width), lines);
                if waits && !found.is_empty() {
                    let further = Text::new("searching further").render(locale);
                    lines.extend(wrap::hanging(vec![Span::raw("    ")], &further, look.dim(), width));
                }
            }
        }
        if one.verdict == Some(Verdict::Right) || self.seen.contains(&name) {
            let shown = format!("= {}", one.answer.shown(locale));
            lines.extend(wrap::hanging(vec![Span::raw("    ")], &shown, look.answer(), width));
        }
    }
}

/// The causes of a wrong answer.
fn causes_of<'c>(all: &'c [(String, Vec<Cause>)], name: &str) -> &'c [Cause] {
    all.iter().find(|(known, _)| known == name).map_or(&[], |(_, causes)| causes)
}

/// The likeliest cause, with the step where it happens, and below it the other possibilities. What is right in place of
/// it is written where the answer is shown too.
fn cause_lines(
    causes: &[Cause],
    solution: &Solution,
    reveals: bool,
    (look, locale, width): (&Appearance, &Locale, usize),
    lines: &mut Vec<Line<'static>>,
) {
    let named = causes.first().is_some_and(|first| first.is_named);
    let dot = || vec![Span::raw(format!("    {} ", look.glyph(Glyph::Dot)))];
    for (n, cause) in causes.iter().enumerate() {
        if n == 1 && named {
            let other = Text::new("Other possibilities:").render(locale);
            lines.extend(wrap::hanging(vec![Span::raw("    ")], &other, look.dim(), width));
        }
        let style = if n == 0 && named { Style::new() } else { look.dim() };
        let text = filter_untrusted(&cause.text(solution).render(locale)).into_owned();
        lines.extend(wrap::hanging(dot(), &text, style, width));
        if n > 0 || !named {
            continue;
        }
        for [wrong, right] in cause.mistakes.iter().filter_map(|mistake| mistake.lines(solution, locale)) {
            let line = if reveals {
                Text::new("{wrong}   (correct: {right})").with("wrong", wrong).with("right", right)
            } else {
                Text::verbatim(wrong)
            };
            lines.extend(wrap::hanging(vec![Span::raw("      ")], &line.render(locale), look.dim(), width));
        }
    }
}

/// Answers in the order of the page: those that the statement asks for, in its order, then all others.
struct Order {
    /// Places in the solution.
    places: Vec<usize>,
    /// Number of answers asked for; 0 without a statement.
    asked: usize,
}

fn order(problem: &Problem, solution: &Solution) -> Order {
    let place = |name: &String| solution.answers.iter().position(|answer| answer.name.is(name));
    let mut places: Vec<usize> = problem.asked().iter().filter_map(place).collect();
    let asked = places.len();
    places.extend(
        (0..solution.answers.len()).filter(|place| !places[..asked].contains(place)).collect::<Vec<_>>(),
    );
    Order { places, asked }
}

struct Columns {
    label: usize,
    cell: usize,
}

struct One<'a> {
    answer: &'a Answer,
    label: &'a str,
    /// The text with the decimal mark of the language.
    text: String,
    edit: Option<&'a TextEntry>,
    focused: bool,
    verdict: Option<Verdict>,
}

impl One<'_> {
    fn line(&self, columns: &Columns, look: &Appearance, lines: &mut Vec<Line<'static>>) {
        let pointer = if self.focused { look.glyph(Glyph::Pointer) } else { " " };
        let name = if self.focused { look.title() } else { Style::new() };
        let mut label = wrap::words(self.label, columns.label);
        let last = label.pop().unwrap_or_default();
        let mut head = Span::styled(format!("{pointer} "), look.border(self.focused));
        for line in label {
            lines.push(Line::from(vec![
                std::mem::replace(&mut head, Span::raw("  ")),
                Span::styled(line, name),
            ]));
        }
        let mut line =
            Line::from(vec![head, Span::styled(padded(&last, columns.label), name), Span::raw("  ")]);
        match self.edit {
            Some(input) => line.extend(typed_in(input, columns.cell)),
            None if self.text.is_empty() => {
                let unit = self.answer.unit.shown(look.ascii);
                let hint = if unit.is_empty() { look.glyph(Glyph::Rule).to_owned() } else { unit };
                let hint = padded(&look.shortened(&hint, columns.cell), columns.cell);
                let style = if self.focused { look.focus() } else { look.dim() };
                line.push_span(Span::styled(hint, style));
            }
            None => {
                let text = filter_untrusted(&self.text).into_owned();
                let text = padded(&look.shortened(&text, columns.cell), columns.cell);
                line.push_span(Span::styled(text, if self.focused { look.focus() } else { Style::new() }));
            }
        }
        let (glyph, style) = match &self.verdict {
            None => ("", Style::new()),
            Some(Verdict::Right) => (look.glyph(Glyph::Good), look.good()),
            Some(Verdict::RoundedEarly(_) | Verdict::TooFewDigits) => {
                (look.glyph(Glyph::Warning), look.warning())
            }
            Some(Verdict::Wrong | Verdict::Unread(_)) => (look.glyph(Glyph::Bad), look.error()),
        };
        line.push_span(Span::styled(format!(" {glyph}"), style));
        lines.push(line);
    }
}
