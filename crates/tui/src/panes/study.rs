//! A study: its cells, and what it found.

use dalembert_core::{Locale, Text};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{Page, check::typed_in, columns::padded, results, wrap};
use crate::{
    ask::{Ask, Subject},
    glyphs::filter_untrusted,
    look::{Glyph, Look},
    tab::Tab,
};

/// The cells and what was found; the page starts at each cell.
pub fn page(of: &Subject<'_>, ask: &Ask, focused: bool, look: &Look, locale: &Locale, width: u16) -> Page {
    let cells = usize::from(width).max(1);
    let locale = &locale.ascii(look.ascii);
    let study = &ask.study;
    let mut page = Page::default();
    let all = study.cells();
    let label = all.iter().map(|cell| cell.name().render(locale).width()).max().unwrap_or(0).min(cells / 2);
    let room = cells.saturating_sub(label + 6).max(1);
    let plan = study.plan(of, &ask.sensitivity.widths(&of.inputs));
    for cell in all {
        page.starts.push(page.lines.len());
        let under_cursor = focused && cell == study.cell();
        let pointer = if under_cursor { look.glyph(Glyph::Pointer) } else { " " };
        let name = look.shortened(&cell.name().render(locale), label);
        let mut line = Line::from(vec![
            Span::styled(format!("{pointer} "), look.border(under_cursor)),
            Span::styled(padded(&name, label), if under_cursor { look.title() } else { Style::new() }),
            Span::raw("  "),
        ]);
        match ask.edit.as_ref().filter(|_| under_cursor) {
            Some(input) => line.extend(typed_in(input, room.min(24))),
            None => {
                let shown = study.shown(cell, of, locale.style.decimal).render(locale);
                let shown = look.shortened(&filter_untrusted(&shown), room);
                let typed = cell.is_choice() || !study.text(cell).trim().is_empty();
                let style = match (under_cursor, typed) {
                    (true, _) => look.focus(),
                    (false, true) => Style::new(),
                    (false, false) => look.dim(),
                };
                line.push_span(Span::styled(shown, style));
                if cell.is_choice() {
                    line.push_span(Span::styled(format!(" {}", look.glyph(Glyph::Open)), look.dim()));
                }
            }
        }
        page.lines.push(line);
        if let Err((wrong, why)) = &plan
            && *wrong == cell
        {
            let why = filter_untrusted(&why.render(locale)).into_owned();
            page.lines.extend(wrap::hanging(vec![Span::raw("    ")], &why, look.error(), cells));
        }
    }
    page.lines.push(Line::default());
    let dim = |word: &'static str| Line::styled(Text::new(word).render(locale), look.dim());
    match &study.found {
        _ if plan.is_err() => {}
        _ if ask.waits(Tab::Study) => page.lines.push(dim("solving")),
        None => page.lines.push(dim("cancelled")),
        Some(Err(error)) => page.lines.extend(results::refusal(None, error, look, locale, width)),
        Some(Ok(found)) => {
            for text in &found.says {
                page.lines.extend(wrap::words(&text.render(locale), cells).into_iter().map(|line| {
                    Line::styled(line, if found.numbers.is_empty() { look.dim() } else { look.answer() })
                }));
            }
        }
    }
    page
}
