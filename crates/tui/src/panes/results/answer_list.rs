//! The answers one below another: main answers first, numbers with their decimal marks in one column.

use dalembert_core::{Answer, AnswerValue, Locale, Number, Solution, Text, printer, trace::Op};
use ratatui::{
    style::{Modifier, Style},
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{Reading, difference};
use crate::{
    look::{Appearance, Glyph},
    pane::Page,
    panes::{
        columns::{Aligned, number, padded, widths},
        steps, wrap,
    },
};

/// The widest column of labels in a pane of less than twice that; in wider ones half of it. Longer labels go on below.
const WIDEST_LABELS: usize = 40;
/// The narrowest column of labels beside symbols, and without: where there is less room, symbols give way, then columns.
const NARROWEST_LABELS: (usize, usize) = (16, 24);
/// So many of the values have room in their column.
const USUAL: (usize, usize) = (17, 20);
/// The widest symbol that stands beside its answer.
const WIDEST_SYMBOL: usize = 9;
/// So many lists of the same name are shown; of more their number.
const MOST_LISTS: usize = 2;
/// So many main answers are seen whatever else is.
const MOST_MAIN: usize = 4;

/// Labels at the left, symbols beside them, numbers with their decimal marks in one column, units in another. In a narrow
/// pane each answer stands beside its label, at the right edge, where both fit, and below it where they do not. The page
/// starts at each answer.
pub(super) fn page(
    solution: &Solution,
    reading: &Reading<'_>,
    look: &Appearance,
    locale: &Locale,
    width: usize,
) -> Page {
    let answers: Vec<ShownAnswer<'_>> = solution
        .answers
        .iter()
        .enumerate()
        .map(|(n, answer)| {
            let is_alike = |before: &&Answer| before.is_main && before.problem == answer.problem;
            let is_among_first = || solution.answers[..n].iter().filter(is_alike).count() < MOST_MAIN;
            let is_bold = answer.is_main && (answer.asked || is_among_first());
            ShownAnswer { is_bold, ..ShownAnswer::of(answer, solution, reading, look, locale) }
        })
        .collect();
    let columns = Columns::of(&answers, width);
    let mut page = Page::default();
    for (n, one) in answers.iter().enumerate() {
        let before = n.checked_sub(1).map(|before| &answers[before]);
        let is_other_problem = before.is_none_or(|before| before.answer.problem != one.answer.problem);
        if is_other_problem {
            page.lines.extend(steps::heading(n == 0, one.answer.problem, look, locale));
        } else if before.is_some_and(|before| before.answer.is_main && !one.answer.is_main) {
            page.lines.push(Line::default());
        }
        let first = page.lines.len();
        page.starts.push(first);
        if let Some(lists) = folded_lists(solution, n, reading) {
            if lists.first() == Some(&n) {
                page.lines.extend(folded(one.answer, lists.len(), reading, look, locale, width));
            }
            continue;
        }
        page.lines.extend(match &columns {
            Some(columns) => columns.lines(one, look, width),
            None => one.lines(look, width),
        });
        if reading.chosen == Some(n) {
            page.lines.iter_mut().skip(first).for_each(|line| line.style = look.focus());
        }
        if !one.is_covered {
            one.behind(reading, look, locale, width, &mut page.lines);
        }
        if one.answer.is_main && n < MOST_MAIN {
            page.head = page.lines.len();
        }
    }
    page
}

/// An answer as it is shown.
struct ShownAnswer<'a> {
    answer: &'a Answer,
    label: String,
    symbol: String,
    value: String,
    /// The parts of a single number.
    aligned: Option<Aligned>,
    is_covered: bool,
    /// True for the main answers that stand out.
    is_bold: bool,
}

impl<'a> ShownAnswer<'a> {
    fn of(
        answer: &'a Answer,
        solution: &Solution,
        reading: &Reading<'_>,
        look: &Appearance,
        locale: &Locale,
    ) -> Self {
        let is_covered = steps::covers(reading.revealed, solution, answer);
        let value = if is_covered { "?".into() } else { answer.shown(locale) };
        let is_number = matches!(answer.value, AnswerValue::Number(Number::Scalar(_), _));
        let symbol = look.words(&symbol_of(answer, solution)).into_owned();
        Self {
            answer,
            label: answer.title_within().render(locale),
            symbol: if symbol.width() > WIDEST_SYMBOL { String::new() } else { symbol },
            aligned: is_number.then(|| Aligned::of(&value)),
            value,
            is_covered,
            is_bold: answer.is_main,
        }
    }

    fn label_style(&self) -> Style {
        if self.is_bold { Style::new().add_modifier(Modifier::BOLD) } else { Style::new() }
    }

    fn value_style(&self, look: &Appearance) -> Style {
        if self.is_bold { look.answer() } else { Style::new() }
    }

    /// The answer in a narrow pane.
    fn lines(&self, look: &Appearance, width: usize) -> Vec<Line<'static>> {
        let (label, style) = (&self.label, self.label_style());
        if label.width() + 2 + self.value.width() > width {
            return self.below(look, width);
        }
        let gap = width - label.width() - self.value.width();
        vec![Line::from(vec![
            Span::styled(label.clone(), style),
            Span::raw(" ".repeat(gap)),
            Span::styled(self.value.clone(), self.value_style(look)),
        ])]
    }

    /// The value below its label.
    fn below(&self, look: &Appearance, width: usize) -> Vec<Line<'static>> {
        let style = self.label_style();
        let label = wrap::words(&self.label, width).into_iter().map(|line| Line::styled(line, style));
        let value = wrap::hanging(vec![Span::raw("  ")], &self.value, self.value_style(look), width);
        label.chain(value).collect()
    }

    /// Notes on the value: its difference from the pinned one, the limits of a set.
    fn behind(
        &self,
        reading: &Reading<'_>,
        look: &Appearance,
        locale: &Locale,
        width: usize,
        lines: &mut Vec<Line<'static>>,
    ) {
        let difference = reading.pinned.and_then(|pinned| difference::of(self.answer, pinned, locale));
        if let Some(difference) = difference {
            difference::add(&difference, look, width, lines);
        }
        let AnswerValue::Set(_, limits) = &self.answer.value else { return };
        for limit in limits {
            let head =
                vec![Span::raw("    "), Span::styled(look.glyph(Glyph::Dot), look.dim()), Span::raw(" ")];
            lines.extend(wrap::hanging(head, &limit.render(locale), look.dim(), width));
        }
    }
}

/// The symbol of an answer in the worked solution, where it has one.
fn symbol_of(answer: &Answer, solution: &Solution) -> String {
    let AnswerValue::Number(_, id) = answer.value else { return String::new() };
    match &solution.trace.node(id).op {
        Op::Step(step) => solution.steps.get(*step).map(|step| printer::symbol(&step.symbol)),
        Op::Given { symbol, .. } => Some(printer::symbol(symbol)),
        _ => None,
    }
    .unwrap_or_default()
}

/// Widths of the columns of a pane that is wide enough for them.
struct Columns {
    label: usize,
    symbol: usize,
    numbers: (usize, usize),
}

impl Columns {
    fn of(answers: &[ShownAnswer<'_>], width: usize) -> Option<Self> {
        // A few wide values make no column: they stand below their labels.
        let aligned = || answers.iter().filter_map(|one| one.aligned.as_ref());
        let mut widest: Vec<usize> = aligned().map(width_of).collect();
        widest.sort_unstable();
        let most = widest.get(widest.len() * USUAL.0 / USUAL.1).or(widest.last()).copied().unwrap_or(0);
        let usual = || aligned().filter(|one| width_of(one) <= most);
        let numbers = widths(usual());
        let values = usual().map(|one| numbers.0 + numbers.1 + unit_column(one).width()).max().unwrap_or(0);
        let longest = answers.iter().map(|one| one.label.width()).max().unwrap_or(0);
        let symbol = answers.iter().map(|one| one.symbol.width()).max().unwrap_or(0);
        let room = width.saturating_sub(2 + values.max(16));
        // Labels go on in a second line beside symbols, which give way where that would be many.
        let with_symbols = room.saturating_sub(symbol + 1);
        let has_symbols = with_symbols >= longest.min(NARROWEST_LABELS.0);
        let (symbol, room, least) = if has_symbols {
            (symbol, with_symbols, NARROWEST_LABELS.0)
        } else {
            (0, room, NARROWEST_LABELS.1)
        };
        (room >= longest.min(least)).then(|| Self {
            label: longest.min(room).min(WIDEST_LABELS.max(width / 2)),
            symbol,
            numbers,
        })
    }

    /// Cells before the values.
    fn before(&self) -> usize {
        self.label + self.symbol + usize::from(self.symbol > 0) + 2
    }

    fn lines(&self, one: &ShownAnswer<'_>, look: &Appearance, width: usize) -> Vec<Line<'static>> {
        let fits = one.label.width() <= self.label && self.before() + one.value.width() <= width;
        let values = match &one.aligned {
            Some(aligned) => {
                let number = number(aligned, self.numbers);
                let unit = unit_column(aligned);
                if self.before() + number.width() + unit.width() > width {
                    return one.below(look, width);
                }
                // A pure number leaves nothing behind it.
                let number = if unit.is_empty() { number.trim_end().to_owned() } else { number };
                vec![Span::styled(number, one.value_style(look)), Span::raw(unit)]
            }
            // What is no single number stands in the column of the numbers where it fits whole, else below its label.
            None if fits => vec![Span::styled(one.value.clone(), one.value_style(look))],
            None => return one.below(look, width),
        };
        let style = one.label_style();
        let mut labels = wrap::words(&one.label, self.label);
        let last = labels.pop().unwrap_or_default();
        let mut lines: Vec<Line<'static>> =
            labels.into_iter().map(|line| Line::styled(line, style)).collect();
        let mut spans = vec![Span::styled(padded(&last, self.label), style)];
        if self.symbol > 0 {
            spans.push(Span::styled(format!(" {}", padded(&one.symbol, self.symbol)), look.symbol()));
        }
        spans.push(Span::raw("  "));
        spans.extend(values);
        lines.push(Line::from(spans));
        lines
    }
}

/// Cells that a number takes with its unit.
fn width_of(one: &Aligned) -> usize {
    let (before, after) = widths(std::iter::once(one));
    before + after + unit_column(one).width()
}

/// The unit with the space before it that every unit of a column has, `°` too.
fn unit_column(one: &Aligned) -> String {
    match one.unit.as_str() {
        "" => String::new(),
        unit if unit.starts_with(' ') => unit.to_owned(),
        unit => format!(" {unit}"),
    }
}

/// The places of the lists of one name, such as mode shapes, that this answer is one of, where they are not shown one by one.
fn folded_lists(solution: &Solution, at: usize, reading: &Reading<'_>) -> Option<Vec<usize>> {
    let one = &solution.answers[at];
    let is_list = |answer: &Answer| !answer.is_main && matches!(answer.value, AnswerValue::List(_));
    if reading.opened_by.is_none() || reading.pinned.is_some() || !is_list(one) {
        return None;
    }
    let is_alike = |answer: &&Answer| is_list(answer) && answer.name.base == one.name.base;
    let all = solution.answers.iter().enumerate().filter(|(_, answer)| is_alike(answer)).map(|(n, _)| n);
    let all: Vec<usize> = all.collect();
    let is_chosen = reading.chosen.is_some_and(|chosen| all.contains(&chosen));
    (all.len() > MOST_LISTS && !is_chosen).then_some(all)
}

/// Lists of one name in one line.
fn folded(
    answer: &Answer,
    count: usize,
    reading: &Reading<'_>,
    look: &Appearance,
    locale: &Locale,
    width: usize,
) -> Vec<Line<'static>> {
    let text = Text::new("{label}: {count} lists; {key} shows them")
        .with_text("label", answer.label)
        .with("count", count)
        .with("key", reading.opened_by.unwrap_or_default());
    let lines = wrap::words(&text.render(locale), width);
    lines.into_iter().map(|line| Line::styled(line, look.dim())).collect()
}
