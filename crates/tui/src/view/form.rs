//! The inputs.

mod line;
mod statement;

use std::collections::{HashMap, HashSet};

use dalembert_core::{FieldError, Text};
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    style::Modifier,
    text::{Line as Shown, Span},
};

pub(super) use self::line::computed;
use self::{
    line::{LineRows, columns, draw_line, margin},
    statement::Statement,
};
use super::{boxed, scroll_mark, word};
use crate::{
    bench::Bench,
    form::FormLine,
    glyphs::filter_untrusted,
    layout,
    layout::Focus,
    look::Glyph,
    model::Model,
    text::{shortened, width, wrapped},
};

/// Lines of an error on a field that has not the cursor.
const SHORT_ERROR: usize = 2;
/// Lines of an error on the field under the cursor.
const LONG_ERROR: usize = 6;
/// Cells before every line, for the pointer.
const POINTER: usize = 2;
/// Columns of the frame.
const FRAME: usize = 2;

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
        if width(&analysis) <= room {
            title.push(Span::styled(format!("{analysis} "), look.dim()));
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
    super::draw_lines(&laid.statement, 0, Rect { height: laid.statement.len() as u16, ..laid.above }, buffer);
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

/// Columns of a form that shows every label and usual value in one row, frame included.
pub(super) fn columns_wanted(model: &Model, bench: &Bench) -> u16 {
    let lines = bench.problem.inputs.form.lines();
    let cells = columns(model, &lines, usize::from(u16::MAX)).wanted(model, &lines);
    u16::try_from(cells + POINTER + FRAME).unwrap_or(u16::MAX)
}

/// Rows of the whole form in so many columns, frame included.
pub(super) fn rows_wanted(model: &Model, bench: &Bench, columns_of_area: u16) -> u16 {
    let lines = bench.problem.inputs.form.lines();
    // Of a long list a part is seen in any case.
    if lines.len() > usize::from(model.size.1) {
        return u16::MAX - 1;
    }
    let room = usize::from(columns_of_area).saturating_sub(FRAME);
    let (columns, faults) = (columns(model, &lines, room), Faults::of(bench));
    let rows = |line: &FormLine| {
        let own = draw_line(model, bench, &faults, line, false, &columns).rows.len();
        own + draw_errors(model, &faults, line, false, room).len()
    };
    let statement = statement::rows_wanted(model, bench, room);
    u16::try_from(statement + lines.iter().map(rows).sum::<usize>() + 2).unwrap_or(u16::MAX - 1)
}

/// Rows of the text of the statement that are seen above the form, and all; `None` without one.
pub(super) fn seen_of_statement(model: &Model, bench: &Bench, area: Rect) -> Option<(usize, usize)> {
    let (inner, lines) = (inside(area), bench.problem.inputs.form.lines().len());
    Statement::of(model, bench, inner, lines).map(|statement| (statement.seen, statement.of))
}

/// The inside of the form: the pointer is margin enough.
fn inside(area: Rect) -> Rect {
    let mut inner = layout::inside(area);
    if layout::framed(area) {
        inner.x -= 1;
        inner.width += 2;
    }
    inner
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
    /// Rows of the statement, and the area that they begin.
    statement: Vec<Shown<'static>>,
    above: Rect,
}

impl Laid {
    fn of(model: &Model, bench: &Bench, area: Rect) -> Self {
        let above = inside(area);
        let lines = bench.problem.inputs.form.lines();
        let statement = Statement::of(model, bench, above, lines.len()).map_or_else(Vec::new, |all| all.rows);
        let rows_above = statement.len() as u16;
        let inner =
            Rect { y: above.y + rows_above, height: above.height.saturating_sub(rows_above), ..above };
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
            let LineRows { rows: own, cursor: at } =
                draw_line(model, bench, &faults, line, under_cursor, &columns);
            cursor = cursor.or(at.map(|(row, column)| (rows.len() + row, column)));
            rows.extend(own);
            rows.extend(draw_errors(model, &faults, line, under_cursor, inner.width.into()));
            owners.resize(rows.len(), n);
            if under_cursor {
                end = rows.len();
            }
        }
        let last = rows.len().saturating_sub(height);
        // The line of the cursor stays near the middle, with all of its error.
        let first = begin.saturating_sub(height / 2).max(end.saturating_sub(height)).min(begin).min(last);
        Self { rows, owners, cursor, first, outside, inner, statement, above }
    }
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
    let before = (margin(line) + POINTER).min(room / 4);
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
