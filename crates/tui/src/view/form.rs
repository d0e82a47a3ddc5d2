//! The inputs.

use std::{
    collections::{HashMap, HashSet},
    ops::Range,
};

use dalembert_core::{Draft, FieldError, Number, Shape, Text, Value, describe, draft, within_problem};
use dalembert_units::{write_components, write_quantity};
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    style::{Modifier, Style},
    text::{Line as Shown, Span},
};

use super::{boxed, scroll_mark, word};
use crate::{
    bench::Bench,
    form::{self, BETWEEN, FormLine, Role},
    glyphs::filter_untrusted,
    layout,
    layout::Focus,
    look::{Appearance, Glyph},
    model::Model,
    text::{fit, fit_label, padded, shortened, width, wrapped},
};

/// Lines of an error on a field that has not the cursor.
const SHORT_ERROR: usize = 2;
/// Lines of an error on the field under the cursor.
const LONG_ERROR: usize = 6;
/// Cells that a value has at least.
const LEAST_VALUE: usize = 12;
/// So many of the values have room in their column; longer ones begin before it.
const USUAL: (usize, usize) = (3, 4);
/// Cells that a label keeps at least where its value needs the room.
const LEAST_LABEL: usize = 10;
/// Cells between a text and the value that it stands for: `  = `.
const BESIDE: usize = 4;
/// Cells before every line, for the pointer.
const POINTER: usize = 2;

/// Validity of a field.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Filled {
    Well,
    /// Invalid text.
    Wrong,
    /// It is still empty.
    Needed,
}

/// Errors of the inputs, by their paths.
struct Faults<'b> {
    wrong: HashMap<&'b str, Vec<&'b FieldError>>,
    needed: HashSet<&'b str>,
    /// The paths of everything that something wrong or needed lies within.
    around_wrong: HashSet<&'b str>,
    around_needed: HashSet<&'b str>,
}

impl<'b> Faults<'b> {
    fn of(bench: &'b Bench) -> Self {
        let around = |path: &'b str| {
            path.match_indices(['.', '[']).map(|(at, _)| &path[..at]).chain([path]).collect::<Vec<_>>()
        };
        let mut wrong: HashMap<&str, Vec<&FieldError>> = HashMap::new();
        for error in bench.problem.wrong() {
            wrong.entry(&error.path).or_default().push(error);
        }
        Self {
            wrong,
            needed: bench.problem.needed().map(|error| error.path.as_str()).collect(),
            around_wrong: bench.problem.wrong().flat_map(|error| around(&error.path)).collect(),
            around_needed: bench.problem.needed().flat_map(|error| around(&error.path)).collect(),
        }
    }

    /// Invalid and missing state of a line, including collapsed lines below it.
    fn at(&self, path: &str, folded: bool) -> (bool, bool) {
        if folded {
            (self.around_wrong.contains(path), self.around_needed.contains(path))
        } else {
            (self.wrong.contains_key(path), self.needed.contains(path))
        }
    }
}

/// The cells of the columns.
struct Columns {
    label: usize,
    symbol: usize,
    value: usize,
}

impl Columns {
    /// The same for a line whose value is so wide.
    fn with_room_for(&self, value: usize) -> Self {
        let from_label = value.saturating_sub(self.value).min(self.label.saturating_sub(LEAST_LABEL));
        Self { label: self.label - from_label, symbol: self.symbol, value: self.value + from_label }
    }
}

/// Draws the form; answers where the cursor of an edit stands.
pub(super) fn draw(model: &Model, bench: &Bench, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let look = &model.look;
    let focused = bench.focus == Focus::Form;
    let mut title =
        vec![Span::styled(format!(" {} ", word("Inputs", model)), look.border(focused).patch(look.title()))];
    let to_do = bench.problem.to_do().map(|to_do| to_do.render(&model.locale));
    if let Some(analysis) = bench.problem.inputs.form.analysis() {
        let analysis = Text::from(analysis.about.title).render(&model.locale);
        let taken = width(&title[0].content) + to_do.as_deref().map_or(0, |to_do| width(to_do) + 3) + 5;
        let room = usize::from(area.width).saturating_sub(taken);
        if room >= LEAST_LABEL {
            title.push(Span::styled(format!("{} ", fit(&analysis, room, look)), look.dim()));
        }
    }
    if let Some(to_do) = to_do {
        title.push(if bench.problem.wrong().next().is_some() {
            Span::styled(format!("{} {to_do} ", look.glyph(Glyph::Bad)), look.error())
        } else {
            Span::styled(format!("{to_do} "), look.warning())
        });
    }
    boxed(&Shown::from(title), focused, look, area, buffer);
    let laid = Laid::of(model, bench, area);
    let height = usize::from(laid.inner.height);
    super::draw_lines(&laid.rows, laid.first, laid.inner, buffer);
    let (before, after) = laid.outside;
    scroll_mark(before + laid.first, height, before + laid.rows.len() + after, look, area, buffer);
    let (row, column) = laid.cursor?;
    let y = row.checked_sub(laid.first).filter(|y| *y < height)?;
    Some(Position::new(
        laid.inner.x + column.min(usize::from(laid.inner.width).saturating_sub(1)) as u16,
        laid.inner.y + y as u16,
    ))
}

/// The line of the form that is drawn at a place of the screen.
pub(super) fn line_at(model: &Model, bench: &Bench, area: Rect, at: Position) -> Option<usize> {
    let laid = Laid::of(model, bench, area);
    let row = usize::from(at.y.checked_sub(laid.inner.y)?);
    laid.owners.get(laid.first + row).copied().filter(|_| laid.inner.contains(at))
}

/// The form as it is drawn.
struct Laid {
    /// Those of the lines near the cursor: a form may have thousands of others.
    rows: Vec<Shown<'static>>,
    /// The line that each row belongs to.
    owners: Vec<usize>,
    /// Row and column of the cursor of an edit.
    cursor: Option<(usize, usize)>,
    /// The first row that is seen.
    first: usize,
    /// So many lines come before the rows, and so many after.
    outside: (usize, usize),
    inner: Rect,
}

impl Laid {
    fn of(model: &Model, bench: &Bench, area: Rect) -> Self {
        let mut inner = layout::inside(area);
        if layout::framed(area) {
            // The pointer is margin enough.
            inner.x -= 1;
            inner.width += 2;
        }
        let lines = bench.problem.inputs.form.lines();
        let columns = columns(model, &lines, inner.width.into());
        let mut rows: Vec<Shown<'static>> = Vec::new();
        let mut owners = Vec::new();
        let mut cursor = None;
        let (mut begin, mut end) = (0, 0);
        let faults = Faults::of(bench);
        let height = usize::from(inner.height);
        // Every line has a row at least, so that no line further from the cursor is seen.
        let (from, to) = (
            bench.problem.inputs.form.cursor.saturating_sub(height),
            bench.problem.inputs.form.cursor + height + 1,
        );
        let outside = (from, lines.len().saturating_sub(to));
        for (n, line) in lines.iter().enumerate().take(to).skip(from) {
            let under_cursor = n == bench.problem.inputs.form.cursor;
            if under_cursor {
                begin = rows.len();
            }
            let (row, column) = draw_line(model, bench, &faults, line, under_cursor, &columns);
            if let Some(column) = column {
                cursor = Some((rows.len(), column));
            }
            rows.push(row);
            rows.extend(draw_errors(model, &faults, line, under_cursor, inner.width.into()));
            owners.resize(rows.len(), n);
            if under_cursor {
                end = rows.len();
            }
        }
        let last = rows.len().saturating_sub(height);
        // The line of the cursor stays near the middle, with all of its error.
        let first = begin.saturating_sub(height / 2).max(end.saturating_sub(height)).min(begin).min(last);
        Self { rows, owners, cursor, first, outside, inner }
    }
}

fn columns(model: &Model, lines: &[FormLine], room: usize) -> Columns {
    let room = room.saturating_sub(POINTER);
    let leaves = || lines.iter().filter(|line| matches!(line.role, Role::Leaf { .. } | Role::Table { .. }));
    let cells = |line: &FormLine| indent(line) + width(&label(model, line));
    // Where nothing is typed yet, choices have the whole of it.
    let all = || lines.iter().map(cells).max().unwrap_or(0);
    let label = leaves().map(cells).max().unwrap_or_else(all);
    // The names of Greek letters are longer than they are.
    let look = &model.look;
    let most = if look.ascii { 10 } else { 6 };
    let symbol = leaves().map(|line| width(&look.words(line.field.symbol))).max().unwrap_or(0).min(most);
    let symbol = if room < 30 { 0 } else { symbol };
    let gaps = 1 + usize::from(symbol > 0);
    let mut values: Vec<usize> = lines
        .iter()
        .filter_map(|line| if let Role::Leaf { text, .. } = &line.role { Some(width(text)) } else { None })
        .collect();
    values.sort_unstable();
    // Values come first, within reason; what is left goes to the labels, and what they leave to echoes. A few long values
    // make no column: they take what they need from their own labels.
    let value = values.get(values.len() * USUAL.0 / USUAL.1).or(values.last()).copied().unwrap_or(0);
    let value = value.clamp(LEAST_VALUE, (room / 2).max(LEAST_VALUE));
    let label = label.min(room.saturating_sub(symbol + gaps + value));
    Columns { label, symbol, value: room.saturating_sub(label + symbol + gaps) }
}

/// The texts of a row, set apart by what the terminal can show: a dot would be a product in ASCII.
fn side_by_side(summary: &str, look: &Appearance) -> String {
    let between = if look.ascii { " | " } else { BETWEEN };
    filter_untrusted(summary).replace(BETWEEN, between)
}

fn indent(line: &FormLine) -> usize {
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

/// A line, and the column of the cursor where it is edited.
fn draw_line(
    model: &Model,
    bench: &Bench,
    faults: &Faults<'_>,
    line: &FormLine,
    under_cursor: bool,
    columns: &Columns,
) -> (Shown<'static>, Option<usize>) {
    let look = &model.look;
    let focused = under_cursor && bench.focus == Focus::Form;
    let folded = bench.problem.inputs.form.is_folded(&line.path);
    let (wrong, needed) = faults.at(line.changed.as_deref().unwrap_or(&line.path), folded);
    let behind = if line.changed.is_some() { "" } else { " " };
    let pointer = match (under_cursor, wrong) {
        (true, _) => Span::styled(format!("{}{behind}", look.glyph(Glyph::Pointer)), look.border(focused)),
        (false, true) => Span::styled(format!("{}{behind}", look.glyph(Glyph::Bad)), look.error()),
        (false, false) => Span::raw(format!(" {behind}")),
    };
    let mut shown = Shown::from(vec![pointer]);
    if line.changed.is_some() {
        shown.push_span(Span::styled(look.glyph(Glyph::Full), look.key()));
    }
    let spaces = " ".repeat(indent(line));
    let name = format!("{spaces}{}", label(model, line));
    let room = columns.label + columns.symbol + usize::from(columns.symbol > 0) + 1 + columns.value;
    let picked = if focused { look.focus() } else { Style::new() };
    let open = look.glyph(Glyph::Open);
    match &line.role {
        Role::Leaf { shape, text } => {
            let beside = computed(model, line);
            let wide = beside.as_deref().map_or(0, |value| width(value) + BESIDE);
            let columns = &columns.with_room_for(width(text) + wide);
            shown.push_span(Span::styled(
                padded(&fit_label(&name, columns.label, look), columns.label, look),
                if focused { look.title() } else { Style::new() },
            ));
            if columns.symbol > 0 {
                shown.push_span(" ");
                shown.push_span(Span::styled(
                    padded(&look.words(line.field.symbol), columns.symbol, look),
                    look.symbol(),
                ));
            }
            shown.push_span(" ");
            let before = shown.width();
            if let Some(edit) = bench.problem.inputs.form.edit.as_ref().filter(|edit| edit.path == line.path)
            {
                let cells = columns.value.saturating_sub(1);
                let scroll = edit.input.visual_scroll(cells);
                let text = filter_untrusted(edit.input.value()).into_owned();
                let seen = text.chars().skip(chars_in(&text, scroll)).collect::<String>();
                let style = Style::new().add_modifier(Modifier::UNDERLINED);
                shown.push_span(Span::styled(padded_plain(&seen, columns.value), style));
                let column = before + edit.input.visual_cursor().saturating_sub(scroll);
                return (shown, Some(column));
            }
            let state = match (wrong, needed) {
                (true, _) => Filled::Wrong,
                (_, true) => Filled::Needed,
                _ => Filled::Well,
            };
            let value = shown.spans.len();
            push_value(model, line, shape, text, (state, beside), picked, columns.value, &mut shown);
            if let Some(digit) = bench.problem.inputs.form.digit(&line.path, text).filter(|_| focused) {
                point_out(&mut shown, value, text, digit);
            }
        }
        Role::Choice { variants, chosen } => {
            let value = match chosen.and_then(|at| variants.get(at)) {
                Some(variant) => Text::from(variant.label).render(&model.locale),
                None => {
                    Text::new("choose one of {count}").with("count", variants.len()).render(&model.locale)
                }
            };
            let left = columns.label + columns.symbol + usize::from(columns.symbol > 0);
            let narrow = width(&value) + 2 > columns.value;
            let name = if narrow { fit(&name, left, look) } else { padded(&name, left, look) };
            let left = width(&name);
            shown.push_span(Span::styled(name, look.title()));
            shown.push_span(" ");
            let value = fit(&value, room.saturating_sub(left + 3), look);
            let style = if chosen.is_none() { look.warning() } else { Style::new() };
            shown.push_span(Span::styled(value, style.patch(picked)));
            shown.push_span(Span::styled(format!(" {open}"), look.dim()));
            if folded {
                let summary = side_by_side(&bench.problem.inputs.form.summary(&line.path), look);
                let left = (room + POINTER).saturating_sub(shown.width() + 2);
                let summary = format!(" {} {}", look.glyph(Glyph::Closed), summary);
                shown.push_span(Span::styled(fit(&summary, left, look), look.dim()));
            }
        }
        Role::Table { lines } => {
            shown.push_span(padded(
                &name,
                columns.label + columns.symbol + usize::from(columns.symbol > 0),
                look,
            ));
            shown.push_span(" ");
            let count = match lines {
                1 => Text::from("one line"),
                lines => Text::new("{count} lines").with("count", lines),
            };
            let count = count.render(&model.locale);
            shown.push_span(Span::styled(fit(&count, columns.value.saturating_sub(2), look), picked));
            shown.push_span(Span::styled(format!(" {open}"), look.dim()));
        }
        Role::Group { summary } => {
            let name = if folded { format!("{name} {}", look.glyph(Glyph::Closed)) } else { name };
            let name = fit(&name, room, look);
            let left = room.saturating_sub(width(&name) + 2);
            shown.push_span(Span::styled(name, look.title().patch(picked)));
            let summary = side_by_side(summary, look);
            shown.push_span(Span::styled(format!("  {}", fit(&summary, left, look)), look.dim()));
        }
        Role::Rows { count } => {
            let name = fit(&name, room.saturating_sub(5), look);
            shown.push_span(Span::styled(name, look.title().patch(picked)));
            shown.push_span(Span::styled(format!("  {count}"), look.dim()));
        }
        Role::Absent => {
            let left_out = word("none", model);
            let name = fit(&name, room.saturating_sub(width(&left_out) + 2), look);
            shown.push_span(Span::styled(name, picked));
            shown.push_span(Span::styled(format!("  {left_out}"), look.dim()));
        }
    }
    (shown, None)
}

#[expect(clippy::too_many_arguments, reason = "a line of a form has this many sides")]
fn push_value(
    model: &Model,
    line: &FormLine,
    shape: &Shape,
    text: &str,
    (state, beside): (Filled, Option<String>),
    picked: Style,
    room: usize,
    shown: &mut Shown<'static>,
) {
    let look = &model.look;
    let wrong = state == Filled::Wrong;
    // A text of any length is typed; no more of it is examined than can be seen.
    let seen: String = text.chars().take(4 * room + 4).collect();
    let seen = filter_untrusted(&seen).replace('\n', " ");
    if seen.trim().is_empty() {
        let taken = model.bench.as_ref().and_then(|bench| bench.problem.inputs.form.gravity(line));
        let hint = match (shape, taken) {
            (_, Some(taken)) => taken,
            _ if line.optional => word("none", model),
            (Shape::Quantity(measure), None) if !measure.others.is_empty() => {
                measure.units_of_kinds(look.ascii)
            }
            (Shape::Quantity(measure) | Shape::Vector(measure, _), None) => measure.own_unit().pretty(),
            (Shape::Count { .. }, None) => describe::in_words(shape, &model.locale),
            _ => String::new(),
        };
        let hint = match (state, hint.is_empty()) {
            (Filled::Needed, true) => word("needed", model),
            (Filled::Needed, false) => {
                let (needed, dot) = (word("needed", model), look.glyph(Glyph::Dot));
                let with_unit = [format!("{needed} {dot} {hint}"), format!("{needed} {hint}")];
                with_unit.into_iter().find(|text| width(text) <= room).unwrap_or(needed)
            }
            (_, true) => word("empty", model),
            (_, false) => hint,
        };
        shown.push_span(Span::styled(fit(&hint, room, look), look.dim().patch(picked)));
        return;
    }
    let style = if wrong { look.error() } else { Style::new() };
    match shape {
        Shape::Flag => {
            let on = matches!(draft::read_leaf(text, shape, ""), Ok(Value::Flag(true)));
            let (glyph, name) = if on { (Glyph::Full, "yes") } else { (Glyph::Hollow, "no") };
            let value = if wrong { seen } else { format!("{} {}", look.glyph(glyph), word(name, model)) };
            shown.push_span(Span::styled(fit(&value, room, look), style.patch(picked)));
        }
        Shape::Reference(_) => {
            shown.push_span(Span::styled(fit(&seen, room.saturating_sub(2), look), style.patch(picked)));
            shown.push_span(Span::styled(format!(" {}", look.glyph(Glyph::Open)), look.dim()));
        }
        _ => {
            let value = fit_quantity(&seen, room, look);
            let left = room.saturating_sub(width(&value) + BESIDE);
            shown.push_span(Span::styled(value, style.patch(picked)));
            let echo = form::echo(text, shape, model.locale.style).or(beside);
            if let Some(echo) = echo.filter(|echo| width(echo) <= left) {
                shown.push_span(Span::styled(format!("  = {echo}"), look.dim()));
            }
        }
    }
}

/// Value of an input or a definition that a formula gives, or that was found.
fn computed(model: &Model, line: &FormLine) -> Option<String> {
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
fn point_out(shown: &mut Shown<'static>, value: usize, text: &str, digit: Range<usize>) {
    let Some(span) = shown.spans.get(value).filter(|span| span.content.starts_with(&text[..digit.end]))
    else {
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

/// Draws the errors of the field below its line.
fn draw_errors(
    model: &Model,
    faults: &Faults<'_>,
    line: &FormLine,
    under_cursor: bool,
    room: usize,
) -> Vec<Shown<'static>> {
    let look = &model.look;
    let most = if under_cursor { LONG_ERROR } else { SHORT_ERROR };
    let before = (indent(line) + POINTER).min(room / 4);
    let mut shown = Vec::new();
    let path = line.changed.as_deref().unwrap_or(&line.path);
    for error in faults.wrong.get(path).into_iter().flatten() {
        let text = filter_untrusted(&error.why.render(&model.locale)).into_owned();
        let room = room.saturating_sub(before);
        let lines = shortened(wrapped(&text, room), most, room, look);
        shown.extend(lines.into_iter().map(|text| {
            Shown::from(vec![
                Span::raw(" ".repeat(before)),
                Span::styled(text, look.error().remove_modifier(Modifier::BOLD)),
            ])
        }));
    }
    shown
}

/// A value made to fit: of a number with a unit the last digits go first, since without its unit it says nothing.
fn fit_quantity(text: &str, room: usize, look: &Appearance) -> String {
    match text.split_once(' ') {
        Some((number, unit)) if width(text) > room && width(unit) + 5 <= room => {
            format!("{} {unit}", fit(number, room - width(unit) - 1, look))
        }
        _ => fit(text, room, look),
    }
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
