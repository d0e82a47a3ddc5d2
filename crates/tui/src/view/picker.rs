//! The list of analyses; what is to be known of the chosen one stands beside it.

mod preview;

use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    style::Style,
    text::{Line, Span},
};

use super::{HitTarget, boxed, draw_lines, scroll_mark, word};
use crate::{
    glyphs::filter_untrusted,
    layout,
    look::Glyph,
    model::Model,
    picker::{Heading, Leaf, Row},
    remembered::Progress,
    text::{padded, width, wrapped},
};

/// Draws the screen; answers where the cursor of the filter stands.
pub(super) fn draw(model: &Model, body: Rect, buffer: &mut Buffer) -> Option<Position> {
    let (list, beside) = layout::picker(body);
    let cursor = draw_list(model, list, buffer);
    if let (Some(area), Some(row)) = (beside, model.picker.chosen(model.contents())) {
        preview::draw(model, row, area, buffer);
    }
    cursor
}

/// Hit target at a place of the screen.
pub(super) fn spot(model: &Model, body: Rect, at: Position) -> Option<HitTarget> {
    let (list, preview) = layout::picker(body);
    if list.contains(at) {
        let rows = model.picker.rows(model.contents()).len();
        let area = area_of_rows(model, list);
        let row = first_row(model, rows, area) + usize::from(at.y.saturating_sub(area.y));
        return Some(HitTarget::Listing(area.contains(at).then_some(row).filter(|row| *row < rows)));
    }
    let preview = preview.filter(|preview| preview.contains(at))?;
    let case =
        model.picker.chosen(model.contents()).and_then(|row| preview::case_at(model, row, preview, at));
    Some(HitTarget::Case(case))
}

fn draw_list(model: &Model, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let (look, picker) = (&model.look, &model.picker);
    let visible = picker.rows(model.contents());
    let filtered = is_filtered(model);
    let focused = picker.case.is_none();
    let mut title = format!(" {} ", word("List of analyses", model));
    if !picker.filter.value().is_empty() {
        let found = visible.iter().filter(|row| matches!(row, Row::Leaf(_))).count();
        title += &format!("{found}/{} ", model.listings.len());
    }
    boxed(&Line::styled(title, look.border(focused).patch(look.title())), focused, look, area, buffer);
    let inner = layout::inside(area);
    let mut cursor = None;
    if filtered && inner.height > 1 {
        let room = usize::from(inner.width).saturating_sub(3);
        let scroll = picker.filter.visual_scroll(room);
        let text: String = picker.filter.value().chars().skip(scroll).collect();
        buffer.set_stringn(inner.x, inner.y, "/ ", inner.width.into(), look.key());
        let text = filter_untrusted(&text).chars().take(room).collect::<String>();
        if text.is_empty() {
            let hint = word("type to search", model);
            buffer.set_stringn(inner.x + 2, inner.y, hint, room, look.dim());
        }
        buffer.set_stringn(inner.x + 2, inner.y, text, room, look.title());
        if picker.typing {
            cursor = Some(Position::new(
                inner.x + 2 + (picker.filter.visual_cursor() - scroll).min(room) as u16,
                inner.y,
            ));
        }
    }
    let inner = area_of_rows(model, area);
    if visible.is_empty() {
        let text = if model.listings.is_empty() {
            "no analyses in this build"
        } else {
            "no match; Esc clears the search"
        };
        for (y, text) in (inner.y..inner.bottom()).zip(wrapped(&word(text, model), inner.width.into())) {
            buffer.set_string(inner.x, y, text, look.dim());
        }
        return cursor;
    }
    let room = usize::from(inner.width);
    let chosen = picker.chosen.min(visible.len() - 1);
    let rows: Vec<Line<'static>> = visible
        .iter()
        .enumerate()
        .map(|(n, row)| match row {
            Row::Heading(heading) => of_heading(model, *row, *heading, n == chosen, room),
            Row::Leaf(leaf) => of_leaf(model, *row, *leaf, n == chosen, room),
        })
        .collect();
    let height = usize::from(inner.height);
    let first = first_row(model, rows.len(), inner);
    draw_lines(&rows, first, inner, buffer);
    scroll_mark(first, height, rows.len(), look, area, buffer);
    cursor
}

/// Area of the rows: below the line of the filter, where there is one.
fn area_of_rows(model: &Model, list: Rect) -> Rect {
    let inner = layout::inside(list);
    let above = u16::from(is_filtered(model) && inner.height > 1);
    Rect { y: inner.y + above, height: inner.height - above, ..inner }
}

/// The first row that is shown: the chosen one stands in the middle, where that can be.
fn first_row(model: &Model, rows: usize, area: Rect) -> usize {
    let height = usize::from(area.height);
    model
        .picker
        .chosen
        .min(rows.saturating_sub(1))
        .saturating_sub(height / 2)
        .min(rows.saturating_sub(height))
}

fn is_filtered(model: &Model) -> bool {
    model.picker.typing || !model.picker.filter.value().is_empty()
}

/// A heading: whether it is open, what it is called, how much stands under it.
fn of_heading(model: &Model, row: Row, heading: Heading, chosen: bool, room: usize) -> Line<'static> {
    let look = &model.look;
    let contents = model.contents();
    let open = model.picker.is_open(heading, contents.listings);
    let fold = look.glyph(if open { Glyph::Open } else { Glyph::Closed });
    let (count, done) = contents.count(heading);
    let count = match heading {
        Heading::Exercises | Heading::Set(_) => format!("{done}/{count}"),
        Heading::Pinned | Heading::Recent | Heading::Field => String::new(),
        Heading::Family(_) | Heading::Topic(..) => count.to_string(),
    };
    let indent = " ".repeat(row.depth());
    let cells = room.saturating_sub(indent.len() + 2 + 1 + width(&count));
    let focused = chosen && model.picker.case.is_none();
    let style = match heading {
        _ if focused => look.focus(),
        Heading::Topic(..) | Heading::Set(_) => Style::new(),
        _ => look.title(),
    };
    let name = filter_untrusted(&contents.name(heading)).into_owned();
    Line::from(vec![
        Span::styled(format!("{indent}{fold} "), look.border(chosen)),
        Span::styled(padded(&name, cells, look), style),
        Span::styled(format!(" {count}"), look.dim()),
    ])
}

/// An analysis, or an exercise: what it is called, and whether it is open, saved, done.
fn of_leaf(model: &Model, row: Row, leaf: Leaf, chosen: bool, room: usize) -> Line<'static> {
    let look = &model.look;
    let contents = model.contents();
    let Some(listing) = contents.listings.get(leaf.listing) else { return Line::default() };
    let case = leaf.case.and_then(|case| listing.cases().get(case));
    let name = match (leaf.under, case) {
        (Some(Heading::Set(_)), Some(case)) => case.title().render(&model.locale),
        _ => listing.title(&model.locale),
    };
    let problems = model.problems();
    let mut open = problems.iter().filter(|bench| bench.problem.entry().about.id == listing.entry.about.id);
    let mark = match (leaf.under, open.next()) {
        (Some(Heading::Set(_)), _) => match contents.progress(leaf) {
            Progress::NotBegun => " ",
            Progress::Opened => look.glyph(Glyph::Hollow),
            Progress::Solved | Progress::Done => look.glyph(Glyph::Good),
        },
        (_, Some(bench)) if bench.problem.is_unsaved() || open.any(|bench| bench.problem.is_unsaved()) => {
            look.glyph(Glyph::Full)
        }
        (_, Some(_)) => look.glyph(Glyph::Hollow),
        (_, None) => " ",
    };
    let pointer = if chosen { look.glyph(Glyph::Pointer) } else { " " };
    let focused = model.picker.case.is_none();
    let style = if chosen && focused { look.focus() } else { Style::new() };
    let indent = " ".repeat(row.depth());
    let cells = room.saturating_sub(indent.len() + 2 + 2);
    Line::from(vec![
        Span::styled(format!("{indent}{pointer} "), look.border(focused)),
        Span::styled(padded(&name, cells, look), style),
        Span::styled(format!(" {mark}"), look.warning()),
    ])
}
