//! The statement of an exercise, above its inputs.

use ratatui::{
    layout::Rect,
    text::{Line, Span},
};

use crate::{
    bench::{Bench, StatementState},
    glyphs::filter_untrusted,
    keys::{Action, KeyContext},
    look::Glyph,
    model::Model,
    text::{fit, wrapped},
    view::word,
};

/// Rows of inputs that stay below a statement, of as many as there are.
const LEAST_INPUTS: usize = 5;
/// Rows of the text of a statement at least, where it is expanded.
const LEAST_TEXT: usize = 2;
/// Rows around the text: the heading, and a blank one below.
const AROUND: usize = 2;

/// A statement as it is drawn.
pub(super) struct Statement {
    /// Rows, heading and blank row included.
    pub(super) rows: Vec<Line<'static>>,
    /// Rows of its text that are seen.
    pub(super) seen: usize,
    /// Rows of its text.
    pub(super) of: usize,
}

impl Statement {
    /// Statement of a problem above a form of so many lines; `None` where it has none or there is no room.
    pub(super) fn of(model: &Model, bench: &Bench, inner: Rect, lines: usize) -> Option<Self> {
        let look = &model.look;
        let (room, height) = (usize::from(inner.width), usize::from(inner.height));
        let text = text(model, bench, room)?;
        let StatementState { is_folded, first } = bench.statement;
        let left = height.saturating_sub(AROUND + lines.min(LEAST_INPUTS));
        let is_folded = is_folded || left < LEAST_TEXT;
        if height < AROUND + LEAST_INPUTS {
            return None;
        }
        let of = text.len();
        let seen = if is_folded { 0 } else { left.min(of) };
        let first = first.min(of - seen);
        let key = model.key(KeyContext::Form, Action::Statement);
        let fold = look.glyph(if is_folded { Glyph::Closed } else { Glyph::Open });
        let place = if is_folded || seen == of {
            format!("  {key}")
        } else {
            format!("  {key} {}–{}/{of}", first + 1, first + seen)
        };
        let heading = fit(&word("Statement", model), room.saturating_sub(place.len() + 2), look);
        let mut rows = vec![Line::from(vec![
            Span::styled(format!("{fold} "), look.dim()),
            Span::styled(heading, look.title()),
            Span::styled(place, look.dim()),
        ])];
        rows.extend(text.into_iter().skip(first).take(seen).map(Line::from));
        if !is_folded {
            rows.push(Line::default());
        }
        Some(Self { rows, seen, of })
    }
}

/// Rows of the whole statement at some width, heading and blank row included; none without one.
pub(super) fn rows_wanted(model: &Model, bench: &Bench, room: usize) -> usize {
    match text(model, bench, room) {
        Some(_) if bench.statement.is_folded => 1,
        Some(text) => text.len() + AROUND,
        None => 0,
    }
}

fn text(model: &Model, bench: &Bench, room: usize) -> Option<Vec<String>> {
    let text = bench.problem.statement()?.render(&model.locale);
    Some(wrapped(&filter_untrusted(&text), room))
}
