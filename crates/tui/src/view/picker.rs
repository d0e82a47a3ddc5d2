//! The list of analyses and what is to be known of the chosen one.

use dalembert_core::Text;
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    text::{Line, Span},
};

use super::{
    Spot, boxed, draw_lines, scroll_mark,
    text::{fit, padded, width, wrapped},
    word,
};
use crate::{
    drawing,
    glyphs::filter_untrusted,
    layout,
    look::Glyph,
    model::Model,
    picker::{Listing, family},
};

/// The fewest lines in which a drawing can be recognised.
const LEAST_DRAWING: u16 = 7;
/// Lines of what goes in and comes out.
const MOST_LISTED: usize = 3;
/// The most that a drawing is given.
const MOST_DRAWING: u16 = 14;

/// Draws the screen; answers where the cursor of the filter stands.
pub(super) fn draw(model: &Model, body: Rect, buffer: &mut Buffer) -> Option<Position> {
    let (list, preview) = layout::picker(body);
    let cursor = draw_list(model, list, buffer);
    if let (Some(area), Some(listing)) = (preview, model.picker.chosen(&model.listings)) {
        draw_preview(model, listing, area, buffer);
    }
    cursor
}

/// What lies at a place of the screen.
pub(super) fn spot(_model: &Model, body: Rect, at: Position) -> Option<Spot> {
    let (list, preview) = layout::picker(body);
    if list.contains(at) {
        return Some(Spot::Listing(None));
    }
    preview.filter(|preview| preview.contains(at)).map(|_| Spot::Case(None))
}

fn draw_list(model: &Model, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let (look, picker) = (&model.look, &model.picker);
    let visible = picker.visible(&model.listings);
    let filtered = picker.typing || !picker.filter.value().is_empty();
    let focused = picker.case.is_none();
    let mut title = format!(" {} ", word("List of analyses", model));
    if filtered {
        title += &format!("{}/{} ", visible.len(), model.listings.len());
    }
    boxed(&Line::styled(title, look.border(focused).patch(look.title())), focused, look, area, buffer);
    let mut inner = layout::inside(area);
    let mut cursor = None;
    if filtered && inner.height > 1 {
        let room = usize::from(inner.width).saturating_sub(3);
        let scroll = picker.filter.visual_scroll(room);
        let text: String = picker.filter.value().chars().skip(scroll).collect();
        buffer.set_stringn(inner.x, inner.y, "/ ", inner.width.into(), look.key());
        let text = filter_untrusted(&text).chars().take(room).collect::<String>();
        buffer.set_stringn(inner.x + 2, inner.y, text, room, look.title());
        if picker.typing {
            cursor = Some(Position::new(
                inner.x + 2 + (picker.filter.visual_cursor() - scroll).min(room) as u16,
                inner.y,
            ));
        }
        inner.y += 1;
        inner.height -= 1;
    }
    if visible.is_empty() {
        let text = if model.listings.is_empty() {
            "no analysis is linked"
        } else {
            "nothing matches; Esc drops the filter"
        };
        for (y, text) in (inner.y..inner.bottom()).zip(wrapped(&word(text, model), inner.width.into())) {
            buffer.set_string(inner.x, y, text, look.dim());
        }
        return cursor;
    }
    let room = usize::from(inner.width);
    let mut rows: Vec<Line<'static>> = Vec::new();
    let mut chosen_row = 0;
    let mut last_family = "";
    let problems = model.problems();
    for (n, at) in visible.iter().enumerate() {
        let listing = &model.listings[*at];
        let of_family = listing.entry.family();
        if !filtered && of_family != last_family {
            if !rows.is_empty() {
                rows.push(Line::default());
            }
            last_family = of_family;
            let name = family(of_family).render(&model.locale);
            rows.push(Line::styled(fit(&name, room, look), look.dim().patch(look.title())));
        }
        let chosen = n == picker.chosen.min(visible.len() - 1);
        if chosen {
            chosen_row = rows.len();
        }
        let pointer = if chosen { look.glyph(Glyph::Pointer) } else { " " };
        let mut open = problems.iter().filter(|bench| bench.entry.about.id == listing.entry.about.id);
        let mark = match open.next() {
            Some(bench) if bench.is_unsaved() || open.any(|bench| bench.is_unsaved()) => {
                look.glyph(Glyph::Full)
            }
            Some(_) => look.glyph(Glyph::Hollow),
            None => " ",
        };
        let style = if chosen && focused { look.focus() } else { ratatui::style::Style::new() };
        let cells = room.saturating_sub(4);
        rows.push(Line::from(vec![
            Span::styled(format!("{pointer} "), look.border(focused)),
            Span::styled(padded(&listing.title(&model.locale), cells, look), style),
            Span::raw(" "),
            Span::styled(mark, look.warning()),
        ]));
    }
    let height = usize::from(inner.height);
    let last = rows.len().saturating_sub(height);
    let first = chosen_row.saturating_sub(height / 2).min(last);
    draw_lines(&rows, first, inner, buffer);
    scroll_mark(first, height, rows.len(), look, area, buffer);
    cursor
}

fn draw_preview(model: &Model, listing: &Listing, area: Rect, buffer: &mut Buffer) {
    let look = &model.look;
    let about = listing.entry.about;
    let focused = model.picker.case.is_some();
    let name = fit(about.id, usize::from(area.width).saturating_sub(6), look);
    boxed(&Line::styled(format!(" {name} "), look.border(focused)), focused, look, area, buffer);
    let inner = layout::inside(area);
    let room = usize::from(inner.width);
    let mut lines: Vec<Line<'static>> = Vec::new();
    let paragraph = |lines: &mut Vec<Line<'static>>, text: &str, style| {
        lines.extend(wrapped(text, room).into_iter().map(|text| Line::styled(text, style)));
    };
    paragraph(&mut lines, &Text::from(about.summary).render(&model.locale), ratatui::style::Style::new());
    let listed = |lines: &mut Vec<Line<'static>>, heading: &'static str, all: Vec<String>| {
        if !all.is_empty() {
            let heading = word(heading, model);
            let text = format!("{heading}: {}", all.join(", "));
            let mut wrapped = wrapped(&text, room);
            if wrapped.len() > MOST_LISTED {
                wrapped.truncate(MOST_LISTED);
                if let Some(last) = wrapped.last_mut() {
                    *last = fit(&format!("{last} {}", look.glyph(Glyph::Ellipsis)), room, look);
                }
            }
            for (n, text) in wrapped.into_iter().enumerate() {
                lines.push(match text.strip_prefix(&heading).filter(|_| n == 0) {
                    Some(rest) => Line::from(vec![
                        Span::styled(heading.clone(), look.title()),
                        Span::styled(rest.to_owned(), look.dim()),
                    ]),
                    None => Line::styled(text, look.dim()),
                });
            }
        }
    };
    let fields =
        listing.entry.fields().iter().map(|field| lower(&Text::from(field.label).render(&model.locale)));
    listed(&mut lines, "In", fields.collect());
    let solution = model
        .picker
        .preview
        .as_ref()
        .filter(|preview| preview.id == about.id)
        .and_then(|preview| preview.solution.as_ref());
    let answers = solution.iter().flat_map(|solution| &solution.answers);
    listed(
        &mut lines,
        "Out",
        answers.map(|answer| lower(&Text::from(answer.label).render(&model.locale))).collect(),
    );
    lines.push(Line::default());
    let first_case = lines.len();
    let mut shown_case = first_case;
    for (n, case) in listing.cases.iter().enumerate() {
        let chosen = model.picker.case == Some(n);
        if chosen {
            shown_case = lines.len();
        }
        let pointer = if chosen { look.glyph(Glyph::Pointer) } else { look.glyph(Glyph::Bullet) };
        let style = if chosen { look.focus() } else { ratatui::style::Style::new() };
        let name = fit(&filter_untrusted(&case.name), room.saturating_sub(2), look);
        let left = room.saturating_sub(width(&name) + 4);
        let source = filter_untrusted(&case.source).into_owned();
        let mut line =
            Line::from(vec![Span::styled(format!("{pointer} "), look.dim()), Span::styled(name, style)]);
        if left >= width(&source).min(12) {
            line.push_span(Span::styled(format!("  {}", fit(&source, left, look)), look.dim()));
        }
        lines.push(line);
    }
    if listing.cases.is_empty() {
        lines.push(Line::styled(word("no published case", model), look.dim()));
    }
    let drawing =
        solution.and_then(|solution| solution.exhibits.iter().find_map(|exhibit| exhibit.sketch(0)));
    let text_height = u16::try_from(lines.len()).unwrap_or(u16::MAX).min(inner.height);
    let left = inner.height.saturating_sub(text_height + 1);
    let picture = drawing.filter(|_| left >= LEAST_DRAWING).map(|drawing| (drawing, left.min(MOST_DRAWING)));
    let height = usize::from(inner.height);
    let first = if focused { (shown_case + 1).saturating_sub(height) } else { 0 };
    draw_lines(&lines, first, inner, buffer);
    if let Some((drawing, height)) = picture {
        let area = Rect { y: inner.bottom() - height, height, ..inner };
        drawing::render(&drawing, look, &model.locale, area, buffer);
    } else {
        scroll_mark(first, height, lines.len(), look, area, buffer);
    }
}

/// A label inside a sentence: `Young's modulus` keeps its capital, `Mass` does not, nor does an abbreviation change.
fn lower(label: &str) -> String {
    let mut characters = label.chars();
    match (characters.next(), characters.clone().next()) {
        (Some(first), Some(second)) if second.is_lowercase() && !label.contains("'s ") => {
            first.to_lowercase().chain(characters).collect()
        }
        _ => label.to_owned(),
    }
}
