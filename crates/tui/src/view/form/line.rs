//! A line of the inputs: its label, its symbol and its value in columns.

use std::ops::Range;

use dalembert_core::{Draft, Number, Shape, Text, Value, describe, draft, within_problem};
use dalembert_units::{write_components, write_quantity};
use ratatui::{
    style::{Modifier, Style},
    text::{Line as Shown, Span},
};

use super::{super::word, Faults, POINTER};
use crate::{
    bench::Bench,
    form::{self, BETWEEN, FormLine, Role},
    glyphs::filter_untrusted,
    layout::Focus,
    look::Glyph,
    model::Model,
    text::{padded, shortened, width, wrapped},
};

/// Cells that a value has at least.
const LEAST_VALUE: usize = 12;
/// So many of the values have room in their column; longer ones begin before it.
const USUAL: (usize, usize) = (3, 4);
/// Cells that a label keeps at least where its value needs the room.
const LEAST_LABEL: usize = 16;
/// Cells between a text and the value that it stands for: `  = `.
const BESIDE: usize = 4;
/// Cells that a value below its label is set in by.
const BELOW: usize = 4;
/// Rows of a value below its label at most.
const MOST_ROWS: usize = 4;
/// Characters of a value that are examined.
const LONGEST_VALUE: usize = 1000;

/// Validity of a field.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Filled {
    Well,
    /// Invalid text.
    Wrong,
    /// It is still empty.
    Needed,
}

/// The cells of the columns.
pub(super) struct Columns {
    label: usize,
    symbol: usize,
    value: usize,
}

impl Columns {
    /// The same for a line whose value is so wide, with its label set in by so many cells.
    fn with_room_for(&self, value: usize, margin: usize) -> Self {
        let from_label =
            value.saturating_sub(self.value).min(self.label.saturating_sub(margin + LEAST_LABEL));
        Self { label: self.label - from_label, symbol: self.symbol, value: self.value + from_label }
    }

    /// Cells that show labels, symbols and usual values whole.
    pub(super) fn wanted(&self, model: &Model, lines: &[FormLine]) -> usize {
        let values = usual_value(lines);
        let choice = |line: &FormLine| match &line.role {
            Role::Choice { variants, chosen } => {
                let value = chosen.and_then(|at| variants.get(at));
                let value =
                    value.map_or(0, |variant| width(&Text::from(variant.label).render(&model.locale)));
                margin(line) + width(&label(model, line)) + value + 4
            }
            _ => 0,
        };
        let choices = lines.iter().map(choice).max().unwrap_or(0);
        (self.before_value() + values).max(choices)
    }

    /// Cells before the value.
    fn before_value(&self) -> usize {
        self.label + self.symbol + usize::from(self.symbol > 0) + 1
    }
}

pub(super) fn columns(model: &Model, lines: &[FormLine], room: usize) -> Columns {
    let room = room.saturating_sub(POINTER);
    let leaves = || lines.iter().filter(|line| matches!(line.role, Role::Leaf { .. } | Role::Table { .. }));
    let cells = |line: &FormLine| margin(line) + width(&label(model, line));
    // Where nothing is typed yet, choices have the whole of it.
    let all = || lines.iter().map(cells).max().unwrap_or(0);
    let label = leaves().map(cells).max().unwrap_or_else(all);
    // The names of Greek letters are longer than they are.
    let look = &model.look;
    let most = if look.ascii { 12 } else { 9 };
    let symbol = leaves().map(|line| width(&look.words(line.field.symbol))).max().unwrap_or(0).min(most);
    let symbol = if room < 30 { 0 } else { symbol };
    let gaps = 1 + usize::from(symbol > 0);
    // Values come first, within reason; what is left goes to the labels, and what they leave to echoes. A few long values
    // make no column: they take what they need from their own labels.
    let value = usual_value(lines).clamp(LEAST_VALUE, (room / 2).max(LEAST_VALUE));
    let label = label.min(room.saturating_sub(symbol + gaps + value));
    Columns { label, symbol, value: room.saturating_sub(label + symbol + gaps) }
}

/// Cells of most of the values.
fn usual_value(lines: &[FormLine]) -> usize {
    let text =
        |line: &FormLine| if let Role::Leaf { text, .. } = &line.role { Some(width(text)) } else { None };
    let mut values: Vec<usize> = lines.iter().filter_map(text).collect();
    values.sort_unstable();
    values.get(values.len() * USUAL.0 / USUAL.1).or(values.last()).copied().unwrap_or(0).max(LEAST_VALUE)
}

pub(super) fn margin(line: &FormLine) -> usize {
    usize::from(line.depth.min(8)) * 2
}

fn label(model: &Model, line: &FormLine) -> String {
    let label = line.field.title().render(&model.locale);
    match line.number {
        Some(number) if matches!(line.role, Role::Leaf { .. }) => format!("{label} {number}"),
        Some(number) => number.to_string(),
        None => label,
    }
}

/// A line of the form as rows of the screen, and the row and column of the cursor where it is edited.
#[derive(Default)]
pub(super) struct LineRows {
    pub(super) rows: Vec<Shown<'static>>,
    pub(super) cursor: Option<(usize, usize)>,
}

/// The value of a line as it is shown.
struct ShownValue {
    text: String,
    style: Style,
    /// Text behind it that says what a key does with it.
    mark: String,
    /// Value that the text stands for, shown where there is room.
    echo: Option<String>,
}

/// A line of the form that is drawn.
struct LineView<'a> {
    model: &'a Model,
    bench: &'a Bench,
    line: &'a FormLine,
    columns: &'a Columns,
    focused: bool,
    folded: bool,
    state: Filled,
}

/// Draws a line. Labels and values that have no room beside each other go on in rows below: nothing is cut.
pub(super) fn draw_line(
    model: &Model,
    bench: &Bench,
    faults: &Faults<'_>,
    line: &FormLine,
    under_cursor: bool,
    columns: &Columns,
) -> LineRows {
    let look = &model.look;
    let focused = under_cursor && bench.focus == Focus::Form;
    let folded = bench.problem.inputs.form.is_folded(&line.path);
    let (wrong, needed) = faults.at(line.changed.as_deref().unwrap_or(&line.path), folded);
    let state = match (wrong, needed) {
        (true, _) => Filled::Wrong,
        (_, true) => Filled::Needed,
        _ => Filled::Well,
    };
    let view = LineView { model, bench, line, columns, focused, folded, state };
    let LineRows { mut rows, cursor } = view.rows();
    let behind = if line.changed.is_some() { "" } else { " " };
    let mut pointer = vec![match (under_cursor, wrong) {
        (true, _) => Span::styled(format!("{}{behind}", look.glyph(Glyph::Pointer)), look.border(focused)),
        (false, true) => Span::styled(format!("{}{behind}", look.glyph(Glyph::Bad)), look.error()),
        (false, false) => Span::raw(format!(" {behind}")),
    }];
    pointer.extend(line.changed.as_ref().map(|_| Span::styled(look.glyph(Glyph::Full), look.key())));
    for (n, row) in rows.iter_mut().enumerate() {
        let before = if n == 0 { std::mem::take(&mut pointer) } else { vec![Span::raw(" ".repeat(POINTER))] };
        row.spans.splice(0..0, before);
    }
    LineRows { rows, cursor: cursor.map(|(row, column)| (row, column + POINTER)) }
}

impl LineView<'_> {
    fn rows(&self) -> LineRows {
        let (model, look) = (self.model, &self.model.look);
        let picked = if self.focused { look.focus() } else { Style::new() };
        let text = |text: String, style: Style, mark: String| ShownValue { text, style, mark, echo: None };
        let open = format!(" {}", look.glyph(Glyph::Open));
        match &self.line.role {
            Role::Leaf { shape, text } => self.leaf(shape, text, picked),
            Role::Choice { variants, chosen } => {
                let value = match chosen.and_then(|at| variants.get(at)) {
                    Some(variant) => Text::from(variant.label),
                    None => Text::new("choose one of {count}").with("count", variants.len()),
                };
                let style = if chosen.is_none() { look.warning() } else { Style::new() };
                let value = text(value.render(&model.locale), style.patch(picked), open);
                let mut rows = self.heading(look.title(), &value);
                if let Some(row) = rows.last_mut().filter(|_| self.folded) {
                    let summary = self.bench.problem.inputs.form.summary(&self.line.path);
                    let before = format!(" {} ", look.glyph(Glyph::Closed));
                    self.summarize(&before, &summary, row);
                }
                LineRows { rows, cursor: None }
            }
            Role::Table { content } => {
                let value = text(content.render(&model.locale), picked, open);
                LineRows { rows: self.beside(self.columns, Style::new(), &value, None), cursor: None }
            }
            Role::Group { summary } => {
                let closed =
                    if self.folded { format!(" {}", look.glyph(Glyph::Closed)) } else { String::new() };
                let style = look.title().patch(picked);
                let mut rows = self.heading(style, &text(String::new(), Style::new(), closed));
                if let Some(row) = rows.last_mut() {
                    self.summarize("  ", summary, row);
                }
                LineRows { rows, cursor: None }
            }
            Role::Rows { count } => {
                let style = look.title().patch(picked);
                let rows = self.heading(style, &text(format!(" {count}"), look.dim(), String::new()));
                LineRows { rows, cursor: None }
            }
            Role::Absent => {
                let none = text(format!(" {}", word("none", model)), look.dim(), String::new());
                LineRows { rows: self.heading(picked, &none), cursor: None }
            }
        }
    }

    /// A number, a word or a formula beside its label and symbol.
    fn leaf(&self, shape: &Shape, text: &str, picked: Style) -> LineRows {
        let (look, form) = (&self.model.look, &self.bench.problem.inputs.form);
        let style = if self.focused { look.title() } else { Style::new() };
        if let Some(edit) = form.edit.as_ref().filter(|edit| edit.path == self.line.path) {
            let columns = self.columns.with_room_for(width(edit.input.value()) + 1, margin(self.line));
            let cells = columns.value.saturating_sub(1);
            let input = edit.input.input();
            let scroll = input.visual_scroll(cells);
            let typed = filter_untrusted(edit.input.value()).into_owned();
            let seen = typed.chars().skip(chars_in(&typed, scroll)).collect::<String>();
            let (text, style_of_text) = if edit.input.is_selected() {
                (seen, look.focus())
            } else {
                (padded_plain(&seen, columns.value), Style::new().add_modifier(Modifier::UNDERLINED))
            };
            let value = ShownValue { text, style: style_of_text, mark: String::new(), echo: None };
            let rows = self.beside(&columns, style, &value, None);
            let column = columns.before_value() + input.visual_cursor().saturating_sub(scroll);
            return LineRows { cursor: Some((rows.len() - 1, column)), rows };
        }
        let value = self.value(shape, text, picked);
        // What a formula gives, or what was found, is worth the room of a label; the same value in SI is not.
        let own = width(&value.text) + width(&value.mark);
        let computed =
            computed(self.model, self.line).filter(|computed| value.echo.as_ref() == Some(computed));
        let both = own + computed.map_or(0, |value| width(&value) + BESIDE);
        let set_in = margin(self.line);
        let roomy = self.columns.with_room_for(both, set_in);
        let columns = if roomy.value >= both { roomy } else { self.columns.with_room_for(own, set_in) };
        // Another decimal mark leaves the digits where they are.
        let is_seen = self.focused && value.text.len() == text.len();
        let digit = form.digit(&self.line.path, text).filter(|_| is_seen);
        LineRows { rows: self.beside(&columns, style, &value, digit), cursor: None }
    }

    /// The label and the symbol in their columns, the value in its own, or below where it is too long for that. The digit
    /// that keys change is underlined.
    fn beside(
        &self,
        columns: &Columns,
        style: Style,
        value: &ShownValue,
        digit: Option<Range<usize>>,
    ) -> Vec<Shown<'static>> {
        let look = &self.model.look;
        let mut rows: Vec<Shown<'static>> = self
            .label_rows(columns.label)
            .into_iter()
            .map(|label| Shown::from(Span::styled(padded(&label, columns.label, look), style)))
            .collect();
        let Some(row) = rows.last_mut() else { return rows };
        if columns.symbol > 0 {
            row.push_span(" ");
            let symbol = padded(&look.words(self.line.field.symbol), columns.symbol, look);
            row.push_span(Span::styled(symbol, look.symbol()));
        }
        row.push_span(" ");
        if width(&value.text) + width(&value.mark) > columns.value {
            rows.extend(self.below(value));
            return rows;
        }
        let at = row.spans.len();
        row.push_span(Span::styled(value.text.clone(), value.style));
        row.push_span(Span::styled(value.mark.clone(), look.dim()));
        let left = columns.value.saturating_sub(width(&value.text) + BESIDE);
        if let Some(echo) = value.echo.as_ref().filter(|echo| width(echo) <= left) {
            row.push_span(Span::styled(format!("  = {echo}"), look.dim()));
        }
        if let Some(digit) = digit {
            point_out(row, at, digit);
        }
        rows
    }

    /// A name, and beside it a value: in the column of values, right behind the name, or below.
    fn heading(&self, style: Style, value: &ShownValue) -> Vec<Shown<'static>> {
        let look = &self.model.look;
        let left = self.columns.before_value() - 1;
        let room = left + 1 + self.columns.value;
        let needed = width(&value.text) + width(&value.mark);
        let labels = self.label_rows(room);
        let [label] = &labels[..] else {
            let mut rows: Vec<_> = labels.into_iter().map(|label| Shown::styled(label, style)).collect();
            rows.extend(self.below(value));
            return rows;
        };
        let is_choice = matches!(self.line.role, Role::Choice { .. });
        let in_column = is_choice && width(label) <= left && needed <= self.columns.value;
        let name = if in_column { padded(label, left, look) } else { label.clone() };
        let gap = usize::from(!value.text.is_empty());
        let mut row = Shown::from(Span::styled(name.clone(), style));
        if width(&name) + gap + needed > room {
            return [row].into_iter().chain(self.below(value)).collect();
        }
        row.push_span(" ".repeat(gap));
        row.push_span(Span::styled(value.text.clone(), value.style));
        row.push_span(Span::styled(value.mark.clone(), look.dim()));
        vec![row]
    }

    /// A value that has no room beside its label, in the rows below it.
    fn below(&self, value: &ShownValue) -> Vec<Shown<'static>> {
        let look = &self.model.look;
        let before = margin(self.line) + BELOW;
        let room = self.columns.before_value() + self.columns.value;
        let room = room.saturating_sub(before + width(&value.mark));
        let texts = shortened(wrapped(value.text.trim(), room), MOST_ROWS, room, look);
        let mut rows: Vec<Shown<'static>> = texts
            .into_iter()
            .map(|text| Shown::from(vec![Span::raw(" ".repeat(before)), Span::styled(text, value.style)]))
            .collect();
        if let Some(row) = rows.last_mut() {
            row.push_span(Span::styled(value.mark.clone(), look.dim()));
        }
        rows
    }

    /// The label in lines of so many cells.
    fn label_rows(&self, cells: usize) -> Vec<String> {
        let before = margin(self.line).min(cells / 2);
        let label = filter_untrusted(&label(self.model, self.line)).into_owned();
        let lines = wrapped(&label, cells.saturating_sub(before));
        lines.into_iter().map(|line| format!("{}{line}", " ".repeat(before))).collect()
    }

    /// The texts of what is folded, as many as fit whole.
    fn summarize(&self, before: &str, summary: &str, row: &mut Shown<'static>) {
        let look = &self.model.look;
        let between = if look.ascii { " | " } else { BETWEEN };
        let room = (self.columns.before_value() + self.columns.value).saturating_sub(row.width());
        let mut shown = String::new();
        for text in filter_untrusted(summary).split(BETWEEN).filter(|text| !text.is_empty()) {
            let next = format!("{}{text}", if shown.is_empty() { before } else { between });
            if width(&shown) + width(&next) > room {
                break;
            }
            shown += &next;
        }
        row.push_span(Span::styled(shown, look.dim()));
    }

    fn value(&self, shape: &Shape, text: &str, picked: Style) -> ShownValue {
        let (model, look) = (self.model, &self.model.look);
        // A text of any length is typed; no more of it is examined than can be seen.
        let seen: String = text.chars().take(LONGEST_VALUE).collect();
        let seen = filter_untrusted(&seen).replace('\n', " ");
        let seen = form::in_language(&seen, shape, model.locale.style.decimal);
        let shown = |text: String, style: Style| ShownValue {
            text,
            style: style.patch(picked),
            mark: String::new(),
            echo: None,
        };
        if seen.trim().is_empty() {
            return shown(self.hint(shape), look.dim());
        }
        let is_wrong = self.state == Filled::Wrong;
        let style = if is_wrong { look.error() } else { Style::new() };
        match shape {
            Shape::Flag if !is_wrong => {
                let on = matches!(draft::read_leaf(text, shape, ""), Ok(Value::Flag(true)));
                let (glyph, name) = if on { (Glyph::Full, "yes") } else { (Glyph::Hollow, "no") };
                shown(format!("{} {}", look.glyph(glyph), word(name, model)), style)
            }
            Shape::Reference(_) => {
                ShownValue { mark: format!(" {}", look.glyph(Glyph::Open)), ..shown(seen, style) }
            }
            _ => {
                let echo = form::echo(text, shape, model.locale.style);
                ShownValue { echo: echo.or_else(|| computed(model, self.line)), ..shown(seen, style) }
            }
        }
    }

    /// Text of an empty field.
    fn hint(&self, shape: &Shape) -> String {
        let (model, look) = (self.model, &self.model.look);
        let hint = match (shape, self.bench.problem.inputs.form.gravity(self.line)) {
            (_, Some(taken)) => taken,
            _ if self.line.optional => word("none", model),
            (Shape::Quantity(measure), None) if !measure.others.is_empty() => {
                measure.units_of_kinds(look.ascii)
            }
            (Shape::Quantity(measure) | Shape::Vector(measure, _), None) => measure.own_unit().pretty(),
            (Shape::Count { .. }, None) => describe::in_words(shape, &model.locale),
            _ => String::new(),
        };
        match (self.state, hint.is_empty()) {
            (Filled::Needed, true) => word("needed", model),
            (Filled::Needed, false) => {
                format!("{} {} {hint}", word("needed", model), look.glyph(Glyph::Dot))
            }
            (_, true) => word("empty", model),
            (_, false) => hint,
        }
    }
}

/// Value of an input or a definition that a formula gives, or that was found.
pub(in crate::view) fn computed(model: &Model, line: &FormLine) -> Option<String> {
    let problem = &model.bench.as_ref()?.problem;
    // A problem that is solved by hand keeps its numbers covered.
    let shows = !problem.is_stale() && problem.found.revealed.is_none();
    let solution = problem.found.solution.as_ref().filter(|_| shows)?;
    let shape = problem.entry().shape();
    let (of, inner) = within_problem(shape.fields(None), &line.path);
    let definition = inner.strip_suffix(".formula").filter(|row| row.starts_with("let["));
    let name = definition.and_then(|row| {
        let row = if of.is_empty() { row.to_owned() } else { format!("{of}.{row}") };
        match problem.inputs.form.draft.at(&shape, &format!("{row}.name")) {
            Ok((Draft::Leaf(name), _)) if of.is_empty() => Some(name.trim().to_owned()),
            Ok((Draft::Leaf(name), _)) => Some(format!("{of}.{}", name.trim())),
            _ => None,
        }
    });
    let name = name.unwrap_or_else(|| problem.inputs.form.name_of(line));
    let (value, unit) = solution.computed_value(&name)?;
    let style = model.locale.style;
    match (value, &line.role) {
        (Number::Scalar(si), _) => Some(write_quantity(si, unit, style)),
        (Number::Vector(si), Role::Leaf { shape, .. }) => match shape.present() {
            Shape::Vector(_, len) => Some(write_components(&si[..len], unit, style)),
            _ => None,
        },
        (Number::Vector(_), _) => None,
    }
}

/// Underlines the digit of a value that keys change, where it is seen.
fn point_out(shown: &mut Shown<'static>, value: usize, digit: Range<usize>) {
    let Some(span) = shown.spans.get(value).filter(|span| span.content.get(digit.clone()).is_some()) else {
        return;
    };
    let (style, content) = (span.style, span.content.clone().into_owned());
    let chosen = style.add_modifier(Modifier::UNDERLINED | Modifier::BOLD);
    let pieces = [
        Span::styled(content[..digit.start].to_owned(), style),
        Span::styled(content[digit.clone()].to_owned(), chosen),
        Span::styled(content[digit.end..].to_owned(), style),
    ];
    shown.spans.splice(value..=value, pieces);
}

/// The characters that take the first `cells` cells.
fn chars_in(text: &str, cells: usize) -> usize {
    let mut seen = 0;
    text.chars()
        .take_while(|character| {
            let inside = seen < cells;
            seen += unicode_width::UnicodeWidthChar::width(*character).unwrap_or(0);
            inside
        })
        .count()
}

/// Cut without a mark: the cursor is in it, and shows that there is more.
fn padded_plain(text: &str, room: usize) -> String {
    let mut shown: String = text.chars().take(chars_in(text, room)).collect();
    let missing = room.saturating_sub(width(&shown));
    shown.extend(std::iter::repeat_n(' ', missing));
    shown
}
