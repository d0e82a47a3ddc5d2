//! The worked solution: why, formula, substitution, result of every step.

use std::borrow::Cow;

use dalembert_core::{
    Answer, Locale, Solution, Text,
    printer::{self, WrittenStep},
    trace::Op,
};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{
    columns::{Aligned, number, padded, widths},
    reasons, steps,
    steps::{step_of, symbols},
    wrap,
};
use crate::{
    intent::Intent,
    keys::{
        Action, KeyContext, PaneKeys,
        tables::{ENDS, ENTER, LEFT, LINES, PAGES, RIGHT, bind, typed},
    },
    look::Appearance,
    pane::{Page, Pane, Ui, register_pane},
    problem::Problem,
};

/// Keys of the pane.
static KEYS: PaneKeys = PaneKeys {
    id: "working",
    name: "Working",
    table: &[
        &[
            bind(
                Action::Reveal,
                &[typed(' ')],
                "reveal the next step; page down if none is hidden",
                "reveal",
            ),
            bind(Action::Right, RIGHT, "next symbol", "symbols"),
            bind(Action::Left, LEFT, "previous symbol", ""),
            bind(Action::Enter, ENTER, "go to the step or input that defines the symbol", "follow"),
        ],
        LINES,
        PAGES,
        ENDS,
    ],
};

/// The pane of the worked solution.
#[derive(Debug, Default)]
pub struct Working {
    /// The symbol that the cursor is at.
    symbol: Option<Symbol>,
    /// The symbols that were followed to where it is.
    visited: Vec<Symbol>,
}

/// A symbol of a step: the places of both.
type Symbol = (usize, usize);

register_pane!(Working, 20);

impl Pane for Working {
    fn name(&self) -> &'static str {
        "Working"
    }

    fn place(&self) -> KeyContext {
        KeyContext::Own(&KEYS)
    }

    fn page(&self, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        let Some(solution) = working(problem) else { return reasons::nothing(problem, ui, width) };
        if problem.hides_numbers() {
            return Page::of(reasons::why_not(problem, ui, width));
        }
        let reveal = ui.key(self.place(), Action::Reveal);
        let reading = (problem.found.revealed, self.symbol);
        let page = read(&solution, reading, &reveal, ui.look, ui.locale, width);
        let page = match answer_of(problem) {
            Some(answer) => {
                let head = Text::new("Steps that lead to: {answer}; {back} shows all")
                    .with_text("answer", answer.title())
                    .with("back", ui.key(KeyContext::Pane, Action::Back))
                    .render(ui.locale);
                let head = wrap::words(&head, usize::from(width).max(1)).into_iter();
                let head = head.map(|line| Line::styled(line, ui.look.dim())).chain([Line::default()]);
                let lines = head.chain(page.lines.iter().cloned()).collect();
                page.behind(lines)
            }
            None => page,
        };
        if !problem.is_stale() {
            return page;
        }
        let lines = reasons::stale(page.lines.clone(), ui.look, ui.locale, width);
        page.behind(lines)
    }

    fn first_part_of(&self, problem: &Problem, name: &str) -> Option<usize> {
        let solution = working(problem).filter(|_| !problem.hides_numbers())?;
        let of = solution.problems.iter().find(|of| of.name == name)?;
        Some(of.steps.start.min(steps::shown(problem.found.revealed, &solution)))
    }

    fn serves(&self, problem: &Problem, action: Action) -> bool {
        match action {
            Action::Reveal => problem.found.revealed.is_some(),
            Action::Enter => self.symbol.is_some(),
            _ => true,
        }
    }

    fn act(&mut self, problem: &mut Problem, ui: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        if action == Action::Back {
            // Back to the symbol that was followed here; from the first one, to no symbol at all; then to all steps.
            if self.symbol.is_none() {
                return problem.found.working_of.take().map(|_| vec![Intent::BringIn(0)]);
            }
            let before = self.visited.pop();
            return Some(self.put(before));
        }
        Some(match (action, self.symbol) {
            (Action::Reveal, _) if problem.found.revealed.is_some() => {
                let found = &mut problem.found;
                let solution = found.solution.as_ref()?;
                let step = steps::shown(found.revealed, solution);
                found.revealed = Some(step + 1).filter(|next| *next < solution.steps.len());
                let last = found.revealed.is_none().then(|| Intent::Say("every step is revealed".into()));
                last.into_iter().chain([Intent::BringIn(step)]).collect()
            }
            (Action::Left | Action::Right, _) | (Action::Enter, None) => {
                let (solution, revealed) = (working(problem)?, problem.found.revealed);
                let first = self.first_seen(problem, ui);
                match self.beside(&solution, revealed, first, action != Action::Left) {
                    Some(symbol) => self.put(Some(symbol)),
                    None => Intent::say("no further symbol"),
                }
            }
            (Action::Enter, Some(symbol)) => {
                let solution = working(problem)?;
                let Some(id) = symbols(&solution, symbol.0).get(symbol.1).copied() else {
                    return Some(Intent::say("this step depends on no other symbol"));
                };
                if let Some(step) = step_of(&solution, id) {
                    self.visited.push(symbol);
                    self.put(Some((step, 0)))
                } else if let Op::Given { path, .. } = &solution.trace.node(id).op {
                    vec![Intent::GoToInput(path.clone())]
                } else {
                    Vec::new()
                }
            }
            _ => return None,
        })
    }

    fn restart(&mut self) {
        *self = Self::default();
    }

    fn led_to_input(&self) -> bool {
        self.symbol.is_some()
    }
}

/// The answer whose steps alone are shown; none while steps are hidden.
fn answer_of(problem: &Problem) -> Option<&Answer> {
    let name = problem.found.working_of.as_ref().filter(|_| problem.found.revealed.is_none())?;
    problem.found.solution.as_ref()?.answer(name)
}

/// The solution whose steps are shown: of one answer alone, or of all.
fn working(problem: &Problem) -> Option<Cow<'_, Solution>> {
    let solution = problem.found.solution.as_ref()?;
    Some(match answer_of(problem) {
        Some(chosen) => Cow::Owned(solution.working_of(|answer| answer.name == chosen.name)),
        None => Cow::Borrowed(solution),
    })
}

impl Working {
    /// The symbol that the cursor is at: the places of its step and of itself.
    pub fn symbol(&self) -> Option<(usize, usize)> {
        self.symbol
    }

    fn put(&mut self, symbol: Option<Symbol>) -> Vec<Intent> {
        self.symbol = symbol;
        symbol.map(|(step, _)| Intent::BringIn(step)).into_iter().collect()
    }

    /// The symbol after the cursor, or before it; the first one from a step on where there is no cursor yet.
    fn beside(
        &self,
        solution: &Solution,
        revealed: Option<usize>,
        from: usize,
        forward: bool,
    ) -> Option<Symbol> {
        let all = (0..steps::shown(revealed, solution))
            .flat_map(|step| (0..symbols(solution, step).len()).map(move |symbol| (step, symbol)));
        match (self.symbol, forward) {
            (None, _) => all.clone().find(|symbol| symbol.0 >= from).or_else(|| all.clone().next_back()),
            (Some(here), true) => all.clone().find(|symbol| *symbol > here),
            (Some(here), false) => all.clone().rfind(|symbol| *symbol < here),
        }
    }

    /// The first step that is seen.
    fn first_seen(&self, problem: &Problem, ui: &Ui<'_>) -> usize {
        let page = self.page(problem, ui, ui.area.width);
        let first = ui.scroll.min(page.lines.len().saturating_sub(ui.area.height.into()));
        page.starts.iter().position(|start| *start >= first).unwrap_or(0)
    }
}

/// The worked solution; the page starts at each step.
///
/// Each step is a number, its reason and source, and below them `symbol = formula`, `= substitution`, `= result`
/// with the signs of equality under one another. A long formula goes on below its beginning.
pub fn lines(solution: &Solution, look: &Appearance, locale: &Locale, width: u16) -> Page {
    read(solution, (None, None), "", look, locale, width)
}

/// The same as far as it is revealed. Of the step to be found next there are its reason and its symbol; below the step
/// with the cursor stand the symbols it is made of. `reveal` is the name of the key that reveals the next one.
fn read(
    solution: &Solution,
    (revealed, symbol): (Option<usize>, Option<Symbol>),
    reveal: &str,
    look: &Appearance,
    locale: &Locale,
    width: u16,
) -> Page {
    let width = usize::from(width).max(1);
    let locale = &locale.ascii(look.ascii);
    let mut page = Page::default();
    let digits = solution.steps.len().to_string().len();
    let revealed = steps::shown(revealed, solution);
    for (n, step) in solution.steps.iter().enumerate().take(revealed + 1) {
        if n > 0 {
            page.lines.push(Line::default());
        }
        if let Some(of) = solution.problems.iter().find(|of| of.steps.start == n) {
            page.lines.extend(steps::heading(n == 0, of.name, look, locale));
        }
        page.starts.push(page.lines.len());
        let mut written = plain(&printer::step(solution, step, locale), look);
        if n == revealed {
            written = WrittenStep {
                symbol: written.symbol,
                why: written.why,
                result: "?".into(),
                formula: String::new(),
                substitution: String::new(),
                source: String::new(),
                terms: Vec::new(),
            };
        }
        let head = format!("{:>digits$}  ", n + 1);
        // In a narrow pane the formulas begin nearer to the edge.
        let indent = if width < 30 { 1 } else { head.width() };
        reason(&written, head, look, width, &mut page.lines);
        equalities(&written, indent, look, width, &mut page.lines);
        terms(&written.terms, indent + 2, look, width, &mut page.lines);
        if let Some((_, chosen)) = symbol.filter(|(step, _)| *step == n && n < revealed) {
            made_of(
                solution,
                n,
                chosen,
                &Reader { look, locale, width, indent: indent + 2 },
                &mut page.lines,
            );
        }
    }
    let more = solution.steps.len().saturating_sub(revealed);
    if more > 0 {
        let words = Text::new("{count} of {all} steps hidden; {key} in this tab reveals the next")
            .with("key", reveal)
            .with("count", more)
            .with("all", solution.steps.len())
            .render(locale);
        page.lines.push(Line::default());
        page.lines.extend(wrap::words(&words, width).into_iter().map(|line| Line::styled(line, look.dim())));
    }
    page
}

/// The symbols that a step is made of, with the numbers of the steps that made them; the chosen one is marked.
fn made_of(
    solution: &Solution,
    step: usize,
    chosen: usize,
    reader: &Reader<'_>,
    lines: &mut Vec<Line<'static>>,
) {
    let &Reader { look, locale, width, indent } = reader;
    let mut parts = vec![Span::styled(Text::new("depends on").render(locale), look.dim())];
    for (n, id) in symbols(solution, step).into_iter().enumerate() {
        let symbol = look.words(&printer::formula(solution, id, locale)).into_owned();
        let from = step_of(solution, id).map_or_else(String::new, |step| format!(" ({})", step + 1));
        let style = if n == chosen { look.focus() } else { look.symbol() };
        parts.push(Span::styled(
            look.shortened(&format!("{symbol}{from}"), width.saturating_sub(indent)),
            style,
        ));
    }
    if parts.len() == 1 {
        parts = vec![Span::styled(Text::new("no other symbol").render(locale), look.dim())];
    }
    let mut line = Line::from(" ".repeat(indent));
    for part in parts {
        if line.width() > indent && line.width() + part.width() > width {
            lines.push(std::mem::replace(&mut line, Line::from(" ".repeat(indent))));
        }
        line.push_span(part);
        line.push_span(Span::raw("  "));
    }
    line.spans.pop();
    lines.push(line);
}

/// A step in what the terminal can show.
fn plain(step: &WrittenStep, look: &Appearance) -> WrittenStep {
    step.map(&|text| look.words(text).into_owned())
}

/// For whom it is written, and where.
struct Reader<'a> {
    look: &'a Appearance,
    locale: &'a Locale,
    width: usize,
    indent: usize,
}

/// The number of the step and why it is taken; the source at the right, or below where it does not fit.
fn reason(step: &WrittenStep, head: String, look: &Appearance, width: usize, lines: &mut Vec<Line<'static>>) {
    let indent = head.width();
    lines.extend(wrap::hanging(vec![Span::styled(head, look.dim())], &step.why, look.title(), width));
    if step.source.is_empty() {
        return;
    }
    match lines.last_mut() {
        Some(line) if line.width() + 2 + step.source.width() <= width => {
            let gap = " ".repeat(width - line.width() - step.source.width());
            line.push_span(Span::styled(format!("{gap}{}", step.source), look.dim()));
        }
        _ => {
            lines.extend(wrap::hanging(vec![Span::raw(" ".repeat(indent))], &step.source, look.dim(), width));
        }
    }
}

fn equalities(
    step: &WrittenStep,
    indent: usize,
    look: &Appearance,
    width: usize,
    lines: &mut Vec<Line<'static>>,
) {
    let sides =
        [(&step.formula, Style::new()), (&step.substitution, look.dim()), (&step.result, look.answer())];
    let symbol = &step.symbol;
    // A symbol that takes half of the line stands alone.
    let alone = indent + symbol.width() + 3 > width / 2 && symbol.width() > 2;
    let column = if alone { indent } else { indent + symbol.width() + 1 };
    if alone {
        for piece in wrap::formula(symbol, width.saturating_sub(indent), width.saturating_sub(indent)) {
            lines.push(Line::from(vec![Span::raw(" ".repeat(indent)), Span::styled(piece, look.symbol())]));
        }
    }
    let mut before = if alone {
        vec![Span::raw(" ".repeat(column))]
    } else {
        vec![Span::raw(" ".repeat(indent)), Span::styled(symbol.clone(), look.symbol()), Span::raw(" ")]
    };
    for (side, style) in sides.into_iter().filter(|(side, _)| !side.is_empty()) {
        let room = width.saturating_sub(column + 2);
        // What goes on below is set in once more; with hardly any room it begins at the edge.
        let hang = if room > 12 { column + 4 } else { 0 };
        for (n, piece) in wrap::formula(side, room, width.saturating_sub(hang)).into_iter().enumerate() {
            let mut line = match n {
                0 => {
                    let mut line = std::mem::replace(&mut before, vec![Span::raw(" ".repeat(column))]);
                    line.push(Span::styled("= ", look.dim()));
                    line
                }
                _ => vec![Span::raw(" ".repeat(hang))],
            };
            line.push(Span::styled(piece, style));
            lines.push(Line::from(line));
        }
    }
}

/// The terms of a long sum and their values, in two columns.
fn terms(
    terms: &[(String, String)],
    indent: usize,
    look: &Appearance,
    width: usize,
    lines: &mut Vec<Line<'static>>,
) {
    let values: Vec<Aligned> = terms.iter().map(|(_, value)| Aligned::of(value)).collect();
    let number_widths = widths(&values);
    let symbols = terms.iter().map(|(symbol, _)| symbol.width()).max().unwrap_or(0);
    let whole =
        values.iter().map(|value| number_widths.0 + number_widths.1 + value.unit.width()).max().unwrap_or(0);
    let beside = indent + symbols + 2 + whole <= width;
    for ((symbol, value), aligned) in terms.iter().zip(&values) {
        let space = Span::raw(" ".repeat(indent));
        if beside {
            lines.push(Line::from(vec![
                space,
                Span::styled(padded(symbol, symbols + 2), look.symbol()),
                Span::raw(number(aligned, number_widths)),
                Span::styled(aligned.unit.clone(), look.dim()),
            ]));
        } else {
            let room = width.saturating_sub(indent);
            for piece in wrap::formula(&format!("{symbol} = {value}"), room, room) {
                lines.push(Line::from(vec![space.clone(), Span::raw(piece)]));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step() -> WrittenStep {
        let text = str::to_owned;
        WrittenStep {
            symbol: text("U"),
            formula: text("Σ mᵢ rᵢ cos θᵢ"),
            substitution: String::new(),
            result: text("9.5 kg·mm"),
            why: text("Unbalance"),
            source: text("Norton, §12.3"),
            terms: vec![
                (text("m₁ r₁ cos θ₁"), text("12.25 kg·mm")),
                (text("m₂ r₂ cos θ₂"), text("−2.75 kg·mm")),
            ],
        }
    }

    fn written(step: &WrittenStep, width: usize) -> Vec<String> {
        let mut lines = Vec::new();
        reason(step, "1  ".into(), &Appearance::default(), width, &mut lines);
        equalities(step, 3, &Appearance::default(), width, &mut lines);
        terms(&step.terms, 5, &Appearance::default(), width, &mut lines);
        assert!(lines.iter().all(|line| line.width() <= width), "{lines:?}");
        lines.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn the_terms_of_a_long_sum_stand_in_columns() {
        assert_eq!(
            written(&step(), 40),
            [
                "1  Unbalance               Norton, §12.3",
                "   U = Σ mᵢ rᵢ cos θᵢ",
                "     = 9.5 kg·mm",
                "     m₁ r₁ cos θ₁  12.25 kg·mm",
                "     m₂ r₂ cos θ₂  −2.75 kg·mm",
            ]
        );
    }

    #[test]
    fn a_narrow_pane_holds_the_same_in_more_lines() {
        let whole = |lines: &[String]| lines.concat().replace(' ', "");
        for width in 24..40 {
            let narrow = written(&step(), width);
            for words in ["Norton,§12.3", "U=Σmᵢrᵢcosθᵢ", "=9.5kg·mm", "12.25kg·mm", "−2.75kg·mm"]
            {
                assert!(whole(&narrow).contains(words), "{width}: {narrow:?}");
            }
        }
    }

    #[test]
    fn a_number_that_was_found_has_no_formula() {
        let found = WrittenStep { formula: String::new(), terms: Vec::new(), ..step() };
        assert_eq!(written(&found, 40)[1..], ["   U = 9.5 kg·mm"]);
    }
}
