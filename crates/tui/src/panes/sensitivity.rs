//! Sensitivity of an answer to each input: bars, the most influential first.

use dalembert_core::{
    Answer, Locale, Refusal, Solution, SolveError, Text,
    sensitivity::{InputInfluence, Sensitivity as Found},
    vary,
};
use dalembert_units::{Unit, write_number, write_quantity};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{
    answers, begun,
    columns::{padded, typed_in},
    reasons, wrap,
};
use crate::{
    ask::{Question, Reply},
    glyphs::filter_untrusted,
    intent::Intent,
    keys::{Action, KeyContext, turned},
    look::{Appearance, Glyph},
    pane::{Page, Pane, Ui, register_pane},
    problem::Problem,
    text_entry::TextEntry,
};

/// Cells of a tolerance.
const TOLERANCE: usize = 6;
/// Cells that bars have at least, where labels can be shortened for them.
const BAR: usize = 6;
/// Cells of the change for 1 %.
const CHANGE: usize = 8;

/// The pane of the influence of each input on an answer.
#[derive(Debug, Default)]
pub struct Sensitivity {
    /// The line under the cursor.
    cursor: usize,
    /// The input that it begins with, by its path: that of the cursor of the form when the tab was turned to.
    begins: String,
    /// The answer that the user chose, by its name.
    answer: Option<String>,
    /// The result; `None` while it is sought.
    found: Option<Result<Found, SolveError>>,
}

register_pane!(Sensitivity, 70);

impl Pane for Sensitivity {
    fn name(&self) -> &'static str {
        "Sensitivity"
    }

    fn place(&self) -> KeyContext {
        KeyContext::Cells
    }

    fn is_useful(&self, problem: &Problem) -> bool {
        problem.found.solution.as_ref().is_some_and(|found| !answers::numbers(found).is_empty())
    }

    fn page(&self, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        match &problem.found.solution {
            Some(solution) if !problem.is_stale() && problem.found.revealed.is_none() => {
                self.lines(solution, problem, ui, width)
            }
            _ if problem.found.revealed.is_some() => reasons::covered(ui, width),
            _ => Page::of(reasons::why_not(problem, ui, width)),
        }
    }

    fn about(&self, _: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        vec![
            Text::new("{keys} another answer; type a tolerance of the input, such as 2 %")
                .with("keys", ui.pair(KeyContext::Cells, Action::Left, Action::Right)),
        ]
    }

    fn serves(&self, _: &Problem, action: Action) -> bool {
        action != Action::Toggle
    }

    /// Chooses another answer.
    fn act(&mut self, problem: &mut Problem, _: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        let by = if action == Action::Left { -1 } else { 1 };
        let solution = problem.found.solution.as_ref()?;
        if !matches!(action, Action::Left | Action::Right) {
            return None;
        }
        let (answers, at) = self.answers(solution);
        self.answer = answers.get(turned(at, by, answers.len())).map(|answer| answer.name.to_string());
        self.found = None;
        Some(vec![Intent::Ask])
    }

    fn cursor<'a>(&'a mut self, _: &'a mut Problem) -> Option<&'a mut usize> {
        Some(&mut self.cursor)
    }

    fn turned_to(&mut self, problem: &mut Problem) -> Vec<Intent> {
        if begun(&mut self.begins, problem) {
            self.found = None;
        }
        Vec::new()
    }

    fn has_arrows(&self, line: usize) -> bool {
        line == 0
    }

    fn cells(&self, _: &Problem) -> usize {
        self.sorted().len()
    }

    fn cell(&self, problem: &Problem) -> Option<String> {
        Some(problem.inputs.tolerances.text(self.input()?.input.path.as_str()).to_owned())
    }

    fn about_cell(&self, _: &Problem, _: &Ui<'_>) -> Vec<Text> {
        let Some(one) = self.input() else { return Vec::new() };
        vec![one.input.label.clone(), Text::new("tolerance of an input, such as 2 %")]
    }

    fn typed(&mut self, problem: &mut Problem, text: String) {
        if let Some(path) = self.input().map(|one| one.input.path.clone()) {
            problem.inputs.tolerances.set(path.as_str(), text);
            problem.found.studied = None;
        }
    }

    fn question(&self, problem: &Problem) -> Option<Question> {
        let (answers, at) = self.answers(problem.found.solution.as_ref()?);
        let record = problem.record()?;
        let tolerances = problem.widths(&vary::inputs(&record));
        let answer = answers.get(at)?.name.to_string();
        Some(Question::Sensitivity { entry: problem.entry(), record, answer, tolerances })
    }

    fn is_answered(&self, _: &Problem) -> bool {
        self.found.is_some()
    }

    fn answered(&mut self, _: &mut Problem, reply: Option<Reply>) -> Vec<Intent> {
        self.found = Some(match reply {
            Some(Reply::Sensitivity(found)) => found,
            _ => Err(Refusal::because("failed (internal error)").into()),
        });
        Vec::new()
    }

    fn forget(&mut self, _: &mut Problem, _: bool) {
        self.found = None;
    }
}

impl Sensitivity {
    /// The answers that are numbers, and the place of the one that is asked about.
    fn answers<'s>(&self, solution: &'s Solution) -> (Vec<&'s Answer>, usize) {
        answers::chosen(solution, self.answer.as_deref(), &self.begins)
    }

    /// The inputs that change the answer, the most influential first; those that do not, last.
    fn sorted(&self) -> Vec<&InputInfluence> {
        let Some(Ok(found)) = &self.found else { return Vec::new() };
        let mut sorted: Vec<&InputInfluence> = found.influences.iter().collect();
        let size = |one: &InputInfluence| match one.change(found.value).abs() {
            change if change.is_nan() => 0.0,
            change => change,
        };
        sorted.sort_by(|a, b| size(b).total_cmp(&size(a)));
        sorted
    }

    /// The input under the cursor.
    fn input(&self) -> Option<&InputInfluence> {
        // The order must not change while a tolerance is typed.
        let sorted = self.sorted();
        sorted.get(self.cursor.min(sorted.len().checked_sub(1)?)).copied()
    }

    /// The influences on the chosen answer; the page starts at each input.
    fn lines(&self, solution: &Solution, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        let look = ui.look;
        let cells = usize::from(width).max(1);
        let locale = &ui.locale.ascii(look.ascii);
        let mut page = Page::default();
        let (answers, at) = self.answers(solution);
        let Some(answer) = answers.get(at) else { return page };
        let title =
            format!("{} {} {}", look.glyph(Glyph::Left), answer.label(locale), look.glyph(Glyph::Right));
        let title = format!("{title}  {}", answer.shown(locale));
        page.lines
            .extend(wrap::words(&title, cells).into_iter().map(|line| Line::styled(line, look.title())));
        let found = match &self.found {
            None => {
                let state = if ui.waits { "solving" } else { "cancelled" };
                page.lines.push(Line::styled(Text::new(state).render(locale), look.dim()));
                return page;
            }
            Some(Err(error)) => {
                page.lines.extend(reasons::refusal(None, error, look, locale, width));
                return page;
            }
            Some(Ok(found)) => found,
        };
        let sorted = self.sorted();
        let label = sorted.iter().map(|one| one.input.label.render(locale).width()).max().unwrap_or(0);
        let room = cells.saturating_sub(CHANGE + TOLERANCE + 6);
        let label = label.min((cells / 2).min(room.saturating_sub(BAR)).max(8));
        let bar = room.saturating_sub(label);
        let columns = Columns { label, bar, cells };
        // What is changed by degrees is distinguished from what is changed by shares.
        let step = if sorted.iter().any(|one| one.input.step_text() != "1 %") {
            "for +1 % or +1°"
        } else {
            "for +1 %"
        };
        let left = columns.label + columns.bar + CHANGE + 4;
        let heading =
            format!("{:>left$}  {}", Text::new(step).render(locale), Text::new("± tol.").render(locale));
        page.lines.push(Line::styled(look.shortened(&plus_minus(&heading, look), cells), look.dim()));
        let most = sorted
            .iter()
            .map(|one| one.change(found.value).abs())
            .filter(|x| x.is_finite())
            .fold(0.0, f64::max);
        for (n, one) in sorted.iter().enumerate() {
            page.starts.push(page.lines.len());
            let under_cursor = n == self.cursor.min(sorted.len() - 1);
            let row = Row {
                one,
                found,
                most,
                under_cursor: ui.focused && under_cursor,
                edit: ui.edit,
                typed: problem.inputs.tolerances.text(one.input.path.as_str()),
            };
            page.lines.extend(row.lines(&columns, look, locale));
            if ui.focused && under_cursor {
                row.details(&answer.unit, &columns, look, locale, &mut page.lines);
            }
        }
        page.lines.push(Line::default());
        if ui.waits {
            page.lines.push(Line::styled(Text::new("solving").render(locale), look.dim()));
            return page;
        }
        let written = |si: f64, digits| {
            write_quantity(si, &answer.unit, locale.digits(digits).style).replace(' ', "\u{A0}")
        };
        let together = Text::new(
            "all tolerances: {least} to {most} in the worst case, ± {likely} as root-sum-square (independent)",
        )
        .with("least", written(found.spread.worst[0], 4))
        .with("most", written(found.spread.worst[1], 4))
        .with("likely", written(found.spread.likely, 3));
        let together = plus_minus(&together.render(locale), look);
        page.lines.extend(wrap::words(&together, cells).into_iter().map(Line::from));
        page
    }
}

/// `±`, also where there is no such sign.
fn plus_minus(text: &str, look: &Appearance) -> String {
    if look.ascii { text.replace('±', "+/-") } else { text.to_owned() }
}

struct Columns {
    label: usize,
    bar: usize,
    cells: usize,
}

struct Row<'a> {
    one: &'a InputInfluence,
    found: &'a Found,
    /// The largest change of all.
    most: f64,
    under_cursor: bool,
    /// The text that is typed under the cursor.
    edit: Option<&'a TextEntry>,
    /// The tolerance that was typed.
    typed: &'a str,
}

impl Row<'_> {
    fn lines(&self, columns: &Columns, look: &Appearance, locale: &Locale) -> Vec<Line<'static>> {
        let style = if self.under_cursor { look.title() } else { Style::new() };
        let label = wrap::words(&self.one.input.label.render(locale), columns.label);
        let mut lines: Vec<Line<'static>> = label
            .iter()
            .enumerate()
            .map(|(n, label)| {
                let pointer = if self.under_cursor && n == 0 { look.glyph(Glyph::Pointer) } else { " " };
                Line::from(vec![
                    Span::styled(format!("{pointer} "), look.border(self.under_cursor)),
                    Span::styled(padded(label, columns.label), style),
                ])
            })
            .collect();
        if let Some(last) = lines.last_mut() {
            last.spans.extend(self.effect(columns, look, locale));
        }
        lines
    }

    /// Bar, change and tolerance.
    fn effect(&self, columns: &Columns, look: &Appearance, locale: &Locale) -> Vec<Span<'static>> {
        let change = self.one.change(self.found.value);
        let relative = change / self.found.value.abs();
        let shown = if self.found.value == 0.0 || !relative.is_finite() {
            look.glyph(Glyph::Rule).to_owned()
        } else {
            let sign = if relative > 0.0 { "+" } else { "" };
            format!("{sign}{} %", write_number(100.0 * relative, locale.digits(2).style))
        };
        let share = if self.most > 0.0 && change.is_finite() { change.abs() / self.most } else { 0.0 };
        let full = (share * columns.bar as f64).round() as usize;
        let glyph = match (look.ascii, change < 0.0) {
            (true, true) => "-",
            (true, false) => "+",
            (false, true) => "▒",
            (false, false) => "█",
        };
        let style = if change < 0.0 { look.series(1) } else { look.series(0) };
        let mut spans = vec![
            Span::raw("  "),
            Span::styled(padded(&glyph.repeat(full), columns.bar), style),
            Span::raw(format!("{}{shown}  ", " ".repeat(CHANGE.saturating_sub(shown.width())))),
        ];
        match self.edit.filter(|_| self.under_cursor) {
            Some(input) => spans.extend(typed_in(input, TOLERANCE)),
            None => {
                let (text, style) = match self.typed.trim() {
                    "" => (self.one.input.step_text().to_owned(), look.dim()),
                    typed => (filter_untrusted(typed).into_owned(), Style::new()),
                };
                let style = if self.under_cursor { look.focus() } else { style };
                spans.push(Span::styled(padded(&look.shortened(&text, TOLERANCE), TOLERANCE), style));
            }
        }
        spans
    }

    /// Details of the input under the cursor.
    fn details(
        &self,
        answer: &Unit,
        columns: &Columns,
        look: &Appearance,
        locale: &Locale,
        lines: &mut Vec<Line<'static>>,
    ) {
        let mut say = |text: Text, style: Style| {
            lines.extend(wrap::hanging(vec![Span::raw("    ")], &text.render(locale), style, columns.cells));
        };
        let (one, value) = (self.one, self.found.value);
        let elasticity = one.elasticity(value);
        if elasticity.is_finite() {
            let elasticity = write_number(elasticity, locale.digits(4).style);
            say(Text::new("elasticity {elasticity}").with("elasticity", elasticity), look.dim());
        }
        if one.derivative.is_finite() {
            let number =
                write_number(one.derivative * one.input.unit.factor / answer.factor, locale.digits(4).style);
            say(
                Text::new("derivative {number} {unit}").with("number", number).with("unit", one.unit(answer)),
                look.dim(),
            );
        }
        let written = |x: f64| {
            if x.is_finite() {
                write_quantity(x, answer, locale.style)
            } else {
                look.glyph(Glyph::Rule).to_owned()
            }
        };
        let sides = Text::new("with −{step}: {less}; with +{step}: {more}")
            .with("step", one.input.step_text())
            .with("less", written(one.sides[0]))
            .with("more", written(one.sides[1]));
        say(sides, look.dim());
        if one.has_kink(value) {
            say(Text::new("asymmetric effect"), look.warning());
        }
        if let Some(why) = &one.refused {
            say(Text::new("no answer on one side: {why}").with_text("why", why.clone()), look.warning());
        }
        if let Err(why) = one.input.tolerance(self.typed)
            && !self.typed.trim().is_empty()
        {
            say(why, look.error());
        }
    }
}
