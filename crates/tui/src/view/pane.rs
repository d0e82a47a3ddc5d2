//! What was found: the tabs, side by side where there is room.

use dalembert_core::{FieldError, Text};
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    style::{Modifier, Style},
    text::{Line, Span},
};

use super::{
    boxed, draw_lines, scroll_mark,
    text::{fit, width, wrapped},
    word,
};
use crate::{
    bench::{Bench, Focus, State},
    drawing,
    glyphs::filter_untrusted,
    keys::{Action, Place},
    layout::{self, Areas},
    look::{Glyph, Look},
    model::Model,
    panes::{self, Page, results, sources, working},
    plot,
    solver::Failure,
    tab::Tab,
};

/// The most errors that are listed.
const MOST_ERRORS: usize = 100;
/// A plot in fewer rows than these tells nothing.
const LEAST_CURVES: u16 = 7;
/// A drawing that has no more rows than this has none to spare for the bar of an animation.
const LEAST_UNDER_BAR: u16 = 5;

/// Draws every pane of what was found.
pub(super) fn draw(model: &Model, bench: &Bench, areas: &Areas, buffer: &mut Buffer) {
    for (tab, area, tabs) in panes(model, bench, areas) {
        let title = match tabs {
            Some(tabs) => tab_bar(model, bench, &tabs, area.width),
            None => tab_title(model, bench, tab),
        };
        draw_tab(model, bench, tab, &title, area, buffer);
    }
    if let (Some(_), Some(picture)) = (areas.pane, areas.picture) {
        let [_, second, _] = pictures(bench, picture);
        if !second.is_empty() {
            draw_next_plot(model, bench, second, buffer);
        }
    }
}

/// The panes that are seen: what each shows, where, and the tabs that are named above it.
pub(super) fn panes(model: &Model, bench: &Bench, areas: &Areas) -> Vec<(Tab, Rect, Option<Vec<Tab>>)> {
    let Some(pane) = areas.pane else { return Vec::new() };
    let Some(picture) = areas.picture else {
        return vec![(bench.tab, pane, Some(bench.tabs()))];
    };
    // Pictures have a column of their own.
    let tabs: Vec<Tab> = bench.tabs().into_iter().filter(|tab| !tab.is_picture()).collect();
    let mut panes = if bench.tab.is_alone() {
        vec![(bench.tab, pane, Some(tabs))]
    } else {
        let [upper, lower] = stacked(model, bench, pane);
        vec![(Tab::Results, upper, Some(tabs)), (Tab::Working, lower, None)]
    };
    let [upper, _, lower] = pictures(bench, picture);
    panes.push((Tab::Plot, upper, None));
    if !lower.is_empty() {
        panes.push((Tab::Drawing, lower, None));
    }
    panes
}

/// The pane at a place of the screen, its inside, and the tab whose name stands just there.
pub(super) fn pane_at(
    model: &Model,
    bench: &Bench,
    areas: &Areas,
    at: Position,
) -> Option<(Tab, Rect, Option<Tab>)> {
    let (tab, area, tabs) = panes(model, bench, areas).into_iter().find(|(_, area, _)| area.contains(at))?;
    let title = super::title_of(area);
    let named = tabs.filter(|_| title.contains(at)).and_then(|tabs| {
        let mut offset = usize::from(at.x - title.x);
        for (named, cells) in bar(model, bench, &tabs, area.width).cells {
            match offset.checked_sub(cells) {
                Some(rest) => offset = rest,
                None => return named,
            }
        }
        None
    });
    Some((tab, layout::inside(area), named))
}

/// The line of the page of a tab that stands at a place of its inside.
pub(super) fn line_at(model: &Model, bench: &Bench, tab: Tab, inside: Rect, at: Position) -> Option<usize> {
    let lines = page(model, bench, tab, inside.width).lines.len();
    let line = first_line(bench, tab, lines, inside) + usize::from(at.y.checked_sub(inside.y)?);
    (inside.contains(at) && line < lines).then_some(line)
}

/// The first line that a tab shows of its page.
fn first_line(bench: &Bench, tab: Tab, lines: usize, inside: Rect) -> usize {
    bench.scroll[tab as usize].min(lines.saturating_sub(inside.height.into()))
}

/// Whether a drawing or animation is on the screen.
pub(super) fn shows_drawing(bench: &Bench, areas: &Areas) -> bool {
    areas.picture.is_some() || (areas.pane.is_some() && bench.tab == Tab::Drawing)
}

/// The inside of the pane that shows the chosen tab.
pub(crate) fn area_of_tab(model: &Model, bench: &Bench, areas: &Areas) -> Option<Rect> {
    let pane = areas.pane?;
    let area = match (areas.picture, bench.tab) {
        (None, _) => pane,
        (_, tab) if tab.is_alone() => pane,
        (Some(_), Tab::Results) => stacked(model, bench, pane)[0],
        (Some(_), Tab::Working) => stacked(model, bench, pane)[1],
        (Some(picture), Tab::Plot) => pictures(bench, picture)[0],
        (Some(picture), _) => pictures(bench, picture)[2],
    };
    Some(layout::inside(area))
}

/// The lines of a tab; a picture has none.
pub(crate) fn page(model: &Model, bench: &Bench, tab: Tab, width: u16) -> Page {
    let (look, locale) = (&model.look, &model.locale);
    let solution = bench.found.solution.as_ref();
    let stale = |lines: Vec<Line<'static>>| {
        if bench.is_stale() { results::stale(lines, look, locale, width) } else { lines }
    };
    match tab {
        Tab::Results => {
            let mut lines = why_not(model, bench, width);
            let mut starts = Vec::new();
            if let Some(solution) = solution.filter(|_| !bench.hides_numbers()) {
                if !lines.is_empty() {
                    lines.push(Line::default());
                }
                let found =
                    results::page(solution, &bench.reading, bench.pinned.as_ref(), look, locale, width);
                let answers = found.lines.len();
                let shown = stale(found.lines);
                let before = lines.len() + shown.len() - answers;
                starts = found.starts.into_iter().map(|start| start + before).collect();
                lines.extend(shown);
            }
            Page { lines, starts }
        }
        Tab::Working => match solution {
            Some(_) if bench.hides_numbers() => hidden(model, bench, width),
            Some(solution) => {
                let page = working::read(
                    solution,
                    &bench.reading,
                    &model.key(Place::Working, Action::Reveal),
                    look,
                    locale,
                    width,
                );
                let before = page.lines.len();
                let lines = stale(page.lines);
                let more = lines.len() - before;
                Page { lines, starts: page.starts.into_iter().map(|start| start + more).collect() }
            }
            None => nothing(model, bench, width),
        },
        Tab::Table | Tab::Sensitivity | Tab::Study if bench.reading.revealed.is_some() => {
            covered(model, width)
        }
        Tab::Table if bench.hides_numbers() => hidden(model, bench, width),
        Tab::Table => {
            let mut lines = Vec::new();
            for table in bench.tables() {
                if !lines.is_empty() {
                    lines.push(Line::default());
                }
                lines.extend(panes::table::lines(table, look, locale, width));
            }
            if lines.is_empty() {
                nothing(model, bench, width)
            } else {
                Page { lines: stale(lines), starts: Vec::new() }
            }
        }
        Tab::Check => match solution {
            Some(solution) if !bench.is_stale() => {
                let focused = bench.focus == Focus::Pane;
                panes::check::page(solution, &bench.ask, focused, look, locale, width)
            }
            _ => Page { lines: why_not(model, bench, width), starts: Vec::new() },
        },
        Tab::Sensitivity | Tab::Study => match solution {
            Some(solution) if !bench.is_stale() => {
                let focused = bench.focus == Focus::Pane;
                if tab == Tab::Sensitivity {
                    panes::sensitivity::page(solution, &bench.ask, focused, look, locale, width)
                } else {
                    bench.subject().map_or_else(Page::default, |subject| {
                        panes::study::page(&subject, &bench.ask, focused, look, locale, width)
                    })
                }
            }
            _ => Page { lines: why_not(model, bench, width), starts: Vec::new() },
        },
        Tab::Sources => {
            let chosen = (bench.focus == Focus::Pane).then_some(bench.case);
            let answers = solution.map_or(&[][..], |solution| &solution.answers);
            let answers = bench.reading.revealed.is_none().then_some(answers);
            sources::lines(bench.entry, &bench.cases, chosen, answers, look, locale, width)
        }
        Tab::Plot | Tab::Drawing => Page::default(),
    }
}

fn stacked(model: &Model, bench: &Bench, pane: Rect) -> [Rect; 2] {
    let lines = page(model, bench, Tab::Results, layout::inside(pane).width).lines.len();
    layout::stack(pane, lines)
}

fn pictures(bench: &Bench, picture: Rect) -> [Rect; 3] {
    layout::pictures(picture, bench.plots().count(), bench.drawings().next().is_some())
}

fn draw_tab(model: &Model, bench: &Bench, tab: Tab, title: &Line<'static>, area: Rect, buffer: &mut Buffer) {
    let (look, locale) = (&model.look, &model.locale);
    let focused = bench.focus == Focus::Pane && bench.tab == tab;
    boxed(title, focused, look, area, buffer);
    let inner = layout::inside(area);
    if inner.is_empty() {
        return;
    }
    if !tab.is_picture() {
        let lines = page(model, bench, tab, inner.width).lines;
        let height = usize::from(inner.height);
        let first = first_line(bench, tab, lines.len(), inner);
        draw_lines(&lines, first, inner, buffer);
        scroll_mark(first, height, lines.len(), look, area, buffer);
        // Where there is room below its cells, a study shows its curves.
        let used = (lines.len() + 1).min(height) as u16;
        let left = Rect { y: inner.y + used, height: inner.height - used, ..inner };
        if tab == Tab::Study
            && left.height >= LEAST_CURVES
            && !bench.is_stale()
            && bench.reading.revealed.is_none()
            && let Some(plot) = bench.studied()
        {
            let state = plot::State { marker: bench.plot_state.marker, ..plot::State::default() };
            plot::render(plot, None, &state, look, locale, left, buffer);
        }
        return;
    }
    if tab == Tab::Plot && bench.reading.revealed.is_some() {
        draw_lines(&covered(model, inner.width).lines, 0, inner, buffer);
        return;
    }
    let stale = bench.is_stale();
    let mut room = inner;
    if stale && bench.found.solution.is_some() && room.height > 3 {
        let note = word("results for the previous, complete inputs", model);
        buffer.set_string(room.x, room.y, fit(&note, room.width.into(), look), look.warning());
        room.y += 1;
        room.height -= 1;
    }
    let drawn = match tab {
        Tab::Plot => bench.shown_plot().map(|(plot, pinned)| {
            plot::render(plot, pinned, &bench.plot_state, look, locale, room, buffer);
        }),
        _ => bench.sketch().and_then(|exhibit| {
            let (frames, _) = exhibit.frames();
            if frames > 1 && !stale && room.height > LEAST_UNDER_BAR {
                room.height -= 1;
                let bar = Rect { y: room.bottom(), height: 1, ..room };
                animation_bar(model, bench.frame, frames, bar, buffer);
            }
            let drawing = bench.drawing_seen()?;
            drawing::render(&drawing, look, locale, room, buffer);
            Some(())
        }),
    };
    if drawn.is_none() {
        draw_lines(&nothing(model, bench, inner.width).lines, 0, inner, buffer);
    } else if stale {
        buffer.set_style(room, look.dim());
    }
}

/// The plot after the one that is shown, as it is: keys act on the other one.
fn draw_next_plot(model: &Model, bench: &Bench, area: Rect, buffer: &mut Buffer) {
    let plots = bench.plots().count();
    let at = (bench.plot.min(plots.saturating_sub(1)) + 1) % plots.max(1);
    let place = format!(" {}/{plots} ", at + 1);
    boxed(&Line::styled(place, model.look.dim()), false, &model.look, area, buffer);
    let inner = layout::inside(area);
    if bench.reading.revealed.is_some() {
        draw_lines(&covered(model, inner.width).lines, 0, inner, buffer);
        return;
    }
    if let Some((plot, pinned)) = bench.plot_at(at) {
        let state = plot::State { marker: bench.plot_state.marker, ..plot::State::default() };
        plot::render(plot, pinned, &state, &model.look, &model.locale, inner, buffer);
        if bench.is_stale() {
            buffer.set_style(inner, model.look.dim());
        }
    }
}

/// Whether an animation moves, and which of its frames is shown: `▶ ━━━━────── 10/24`.
fn animation_bar(model: &Model, frame: usize, frames: usize, area: Rect, buffer: &mut Buffer) {
    if frames < 2 {
        return;
    }
    let look = &model.look;
    let frame = frame % frames;
    let sign = look.glyph(if model.playing { Glyph::Right } else { Glyph::Held });
    let digits = frames.to_string().len();
    let place = format!("{:>digits$}/{frames}", frame + 1);
    let room = usize::from(area.width).saturating_sub(width(&place) + 4);
    let done = (frame * room).div_ceil(frames - 1).min(room);
    let (full, rest) = if look.ascii { ("=", "-") } else { ("━", "─") };
    let line = Line::from(vec![
        Span::styled(format!("{sign} "), look.key()),
        Span::styled(full.repeat(done), look.border(true)),
        Span::styled(rest.repeat(room - done), look.dim()),
        Span::styled(format!("  {place}"), look.dim()),
    ]);
    buffer.set_line(area.x, area.y, &line, area.width);
}

/// Why the present inputs have no solution: what cannot be read, a refusal, a fault of the program.
fn why_not(model: &Model, bench: &Bench, width: u16) -> Vec<Line<'static>> {
    let (look, locale) = (&model.look, &model.locale);
    if bench.found.state == State::Unread {
        let (wrong, needed) = (bench.wrong().count(), bench.needed().count());
        let is_without_numbers = bench.hides_numbers() || bench.found.solution.is_none();
        let headline = match (wrong, needed) {
            (0, 1) if !is_without_numbers => Text::new("1 value missing"),
            (0, _) if !is_without_numbers => Text::new("{count} values missing").with("count", needed),
            _ if !is_without_numbers => Text::from(""),
            (0, 1) => Text::new("No result yet: one value missing"),
            (0, _) => Text::new("No result yet: {needed} values missing"),
            (1, 0) => Text::new("No result yet: one error"),
            (_, 0) => Text::new("No result yet: {wrong} errors"),
            _ => Text::new("No result yet: {needed} missing, {wrong} wrong"),
        };
        let headline = headline.with("wrong", wrong).with("needed", needed).render(locale);
        let mut lines = Vec::new();
        if !headline.is_empty() {
            let headline = wrapped(&headline, width.into()).into_iter();
            lines.extend(headline.map(|text| Line::styled(text, look.warning())));
        }
        lines.extend(bench.wrong().take(MOST_ERRORS).flat_map(|error| unread(model, bench, error, width)));
        if wrong > MOST_ERRORS {
            let more = Text::new("and {more} more").with("more", wrong - MOST_ERRORS).render(locale);
            lines.push(Line::styled(more, look.error()));
        }
        return lines;
    }
    match &bench.found.failure {
        None => Vec::new(),
        Some(Failure::Unsolved(error)) => {
            results::refusal(Some(&bench.entry.shape()), error, look, locale, width)
        }
        Some(Failure::Fault(panic)) => {
            let said = word("this analysis failed (internal error); your inputs are kept", model);
            let mut lines = wrapped(&said, width.into());
            lines.extend(wrapped(&filter_untrusted(panic), width.into()));
            lines.into_iter().map(|text| Line::styled(text, look.error())).collect()
        }
    }
}

/// What a tab says whose numbers belong to inputs far from the present ones.
fn hidden(model: &Model, bench: &Bench, width: u16) -> Page {
    Page { lines: why_not(model, bench, width), starts: Vec::new() }
}

fn unread(model: &Model, bench: &Bench, error: &FieldError, width: u16) -> Vec<Line<'static>> {
    let look = &model.look;
    let field = panes::label_of(&bench.entry.shape(), &error.path, &model.locale);
    let field = field.unwrap_or_else(|| error.path.clone());
    let text = Text::new("{where}: {why}").with("where", field).with_text("why", error.why.clone());
    let text = filter_untrusted(&text.render(&model.locale)).into_owned();
    let glyph = look.glyph(Glyph::Bad);
    wrapped(&text, usize::from(width).saturating_sub(2))
        .into_iter()
        .enumerate()
        .map(|(n, text)| {
            let mark = if n == 0 { format!("{glyph} ") } else { "  ".to_owned() };
            Line::from(vec![Span::styled(mark, look.error()), Span::raw(text)])
        })
        .collect()
}

/// What a tab says that has nothing to show.
fn nothing(model: &Model, bench: &Bench, width: u16) -> Page {
    let why = match (&bench.found.solution, bench.found.state) {
        (Some(_), _) => "nothing to show here".into(),
        (None, State::Solving(_)) => "solving".into(),
        (None, State::Unread) => bench.to_do().unwrap_or_else(|| "solving".into()),
        (None, State::Stopped) => "cancelled".into(),
        (None, State::Current) => "no solution".into(),
    };
    let lines = wrapped(&why.render(&model.locale), width.into());
    Page {
        lines: lines.into_iter().map(|text| Line::styled(text, model.look.dim())).collect(),
        starts: Vec::new(),
    }
}

/// What a tab says whose content would give away what is to be found.
fn covered(model: &Model, width: u16) -> Page {
    let words = Text::new("hidden until every step is revealed; {key} shows the results")
        .with("key", model.key(Place::Form, Action::TryByHand))
        .render(&model.locale);
    let lines = wrapped(&words, width.into()).into_iter();
    Page { lines: lines.map(|text| Line::styled(text, model.look.dim())).collect(), starts: Vec::new() }
}

/// The names of these tabs, the chosen one marked; where there is no room for all, those around it.
fn tab_bar(model: &Model, bench: &Bench, tabs: &[Tab], columns: u16) -> Line<'static> {
    bar(model, bench, tabs, columns).line
}

/// A line of tabs, and what its cells belong to, from left to right.
struct Bar {
    line: Line<'static>,
    cells: Vec<(Option<Tab>, usize)>,
}

fn bar(model: &Model, bench: &Bench, tabs: &[Tab], columns: u16) -> Bar {
    let names: Vec<String> = tabs
        .iter()
        .map(|tab| match place_of_shown(bench, *tab).filter(|_| *tab == bench.tab) {
            Some(place) => format!("{} {place}", word(tab.name(), model)),
            None => word(tab.name(), model),
        })
        .collect();
    let chosen = tabs.iter().position(|tab| *tab == bench.tab).unwrap_or(0);
    let room = usize::from(columns).saturating_sub(4);
    let cells =
        |range: std::ops::Range<usize>| names[range].iter().map(|name| width(name) + 1).sum::<usize>() + 1;
    let (mut first, mut end) = (0, names.len());
    // Where not all fit, the far ones go first, and arrows report it.
    while cells(first..end) + 2 * usize::from(first > 0 || end < names.len()) > room && end - first > 1 {
        if end - 1 > chosen && (end - 1 - chosen >= chosen - first) {
            end -= 1;
        } else {
            first += 1;
        }
    }
    let look = &model.look;
    let focused = bench.focus == Focus::Pane;
    let mut bar = Bar { line: Line::default(), cells: Vec::new() };
    let mut push = |tab: Option<Tab>, text: String, style: Style| {
        bar.cells.push((tab, width(&text)));
        bar.line.push_span(Span::styled(text, style));
    };
    push(None, " ".into(), Style::new());
    if first > 0 {
        push(Some(tabs[first - 1]), format!("{} ", look.glyph(Glyph::Left)), look.dim());
    }
    for (n, name) in names.iter().enumerate().take(end).skip(first) {
        let style = match (tabs[n] == bench.tab, focused) {
            (true, true) => look.border(true).patch(look.title()).add_modifier(Modifier::REVERSED),
            (true, false) => look.title().add_modifier(Modifier::UNDERLINED),
            (false, _) => look.dim(),
        };
        push(Some(tabs[n]), name.clone(), style);
        push(None, " ".into(), Style::new());
    }
    if end < names.len() {
        push(Some(tabs[end]), format!("{} ", look.glyph(Glyph::Right)), look.dim());
    }
    bar
}

/// The name of a tab that has a frame of its own, and which of several it shows.
fn tab_title(model: &Model, bench: &Bench, tab: Tab) -> Line<'static> {
    let look: &Look = &model.look;
    let focused = bench.focus == Focus::Pane && bench.tab == tab;
    let place = place_of_shown(bench, tab).map_or_else(String::new, |place| format!("{place} "));
    let style = match (focused, bench.tab == tab) {
        (true, _) => look.border(true).patch(look.title()).add_modifier(Modifier::REVERSED),
        (false, true) => look.title().add_modifier(Modifier::UNDERLINED),
        _ => look.dim(),
    };
    Line::from(vec![
        Span::raw(" "),
        Span::styled(word(tab.name(), model), style),
        Span::raw(" "),
        Span::styled(place, look.dim()),
    ])
}

/// Which of several plots or drawings a tab shows: `1/2`.
fn place_of_shown(bench: &Bench, tab: Tab) -> Option<String> {
    bench.place_of_shown(tab).map(|(place, of)| format!("{place}/{of}"))
}
