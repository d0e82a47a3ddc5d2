//! What part of the shown tab is seen.

use ratatui::layout::Rect;

use crate::{bench::Focus, layout, model::Model, view};

/// The area of the shown tab.
pub(super) fn area(model: &Model) -> Option<Rect> {
    let bench = model.bench.as_ref()?;
    let (columns, rows) = model.size;
    let areas =
        layout::bench(Rect::new(0, 0, columns, rows), Focus::Pane, bench.expanded || model.look.basic);
    view::area_of_tab(model, bench, &areas)
}

pub(super) fn shown_lines(model: &Model) -> usize {
    area(model).map_or(1, |area| usize::from(area.height))
}

pub(super) fn scroll(model: &mut Model, by: isize) {
    let (Some(area), Some(bench)) = (area(model), &model.bench) else { return };
    let tab = bench.tab;
    let lines = view::page(model, bench, tab, area.width).lines.len();
    let last = lines.saturating_sub(usize::from(area.height));
    let to = bench.scroll[tab as usize].min(last).saturating_add_signed(by).min(last);
    if let Some(bench) = &mut model.bench {
        bench.scroll[tab as usize] = to;
    }
}

/// Scrolls the shown tab so that one of its parts is seen from its first line.
pub(super) fn bring_in(model: &mut Model, part: usize) {
    let (Some(area), Some(bench)) = (area(model), &model.bench) else { return };
    let tab = bench.tab;
    let page = view::page(model, bench, tab, area.width);
    let height = usize::from(area.height);
    let begin = page.starts.get(part).copied().unwrap_or(0);
    let end = page.starts.get(part + 1).copied().unwrap_or(page.lines.len());
    let now = bench.scroll[tab as usize];
    let to = if begin < now || end - begin >= height { begin } else { now.max(end.saturating_sub(height)) };
    if let Some(bench) = &mut model.bench {
        bench.scroll[tab as usize] = if part == 0 { 0 } else { to };
    }
}
