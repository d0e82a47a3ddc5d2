//! The lines of the pane: the cells of the plan, and what was found.

use dalembert_core::{FieldError, Locale, SolveError, Text};
use dalembert_units::{Style as NumberStyle, write_number};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{
    LEAST_CURVES, Study,
    kind::Kind,
    plan::{Cell, Subject},
};
use crate::{
    ask::StudyProgress,
    glyphs::filter_untrusted,
    look::Glyph,
    pane::{Page, Ui},
    panes::{
        columns::{padded, typed_in},
        reasons, wrap,
    },
    problem::Problem,
};

/// Cells of a label beside a long text.
const SHORTEST: usize = 16;

impl Study {
    /// The cells and what was found; the page starts at each cell.
    pub(super) fn lines(&self, of: &Subject<'_>, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        let look = ui.look;
        let cells = usize::from(width).max(1);
        let locale = &ui.locale.ascii(look.ascii);
        let mut page = Page::default();
        let all = self.plan.cells(of);
        let under_cursor = self.under_cursor(of);
        let names: Vec<String> = all.iter().map(|cell| self.plan.label(*cell, of).render(locale)).collect();
        let label = names.iter().map(|name| name.width()).max().unwrap_or(0).min(cells * 2 / 5);
        let room = cells.saturating_sub(label + 6).max(1);
        let errors = self.errors(of, problem);
        let mut placed = vec![false; errors.len()];
        for (cell, name) in all.iter().zip(&names) {
            page.starts.push(page.lines.len());
            let is_under = ui.focused && *cell == under_cursor;
            let edit = ui.edit.filter(|_| is_under);
            let shown = filter_untrusted(&self.plan.shown(*cell, of).render(locale)).into_owned();
            // A label gives way to a long text, which stays under the others where it can.
            let wanted = edit.map_or(shown.width(), |input| input.value().width() + 1);
            let own = label.min((room + label).saturating_sub(wanted)).max(label.min(SHORTEST));
            let room = room + label - own;
            let pointer = if is_under { look.glyph(Glyph::Pointer) } else { " " };
            let style = if is_under { look.title() } else { Style::new() };
            let mut name: Vec<Line<'static>> = wrap::words(&filter_untrusted(name), own)
                .into_iter()
                .enumerate()
                .map(|(n, name)| {
                    let pointer = if n == 0 { pointer } else { " " };
                    Line::from(vec![
                        Span::styled(format!("{pointer} "), look.border(is_under)),
                        Span::styled(padded(&name, own), style),
                    ])
                })
                .collect();
            let mut line = name.pop().unwrap_or_default();
            page.lines.extend(name);
            line.push_span("  ");
            match edit {
                Some(input) => line.extend(typed_in(input, room)),
                None => {
                    let mut shown = wrap::words(&shown, room).into_iter();
                    let style = match (is_under, self.plan.is_usual(*cell, of)) {
                        (true, _) => look.focus(),
                        (false, false) => Style::new(),
                        (false, true) => look.dim(),
                    };
                    line.push_span(Span::styled(shown.next().unwrap_or_default(), style));
                    for rest in shown {
                        page.lines.push(line);
                        let before = " ".repeat(own + 4);
                        line = Line::from(vec![Span::raw(before), Span::styled(rest, style)]);
                    }
                    if cell.is_choice() {
                        line.push_span(Span::styled(format!(" {}", look.glyph(Glyph::Open)), look.dim()));
                    }
                }
            }
            page.lines.push(line);
            // A line that is hidden has its errors below that which hides it.
            let hides = *cell == Cell::Inputs && !self.plan.unfolded;
            for (error, placed) in errors.iter().zip(&mut placed).filter(|(_, placed)| !**placed) {
                let path = cell.path();
                let rest = match error.path.strip_prefix(&path) {
                    Some(rest) if rest.is_empty() || rest.starts_with(['.', '[']) => rest,
                    _ => continue,
                };
                if *cell == Cell::Inputs && !rest.is_empty() && !hides {
                    continue;
                }
                *placed = true;
                page.lines.extend(error_lines(
                    if hides { &error.path } else { rest },
                    error,
                    ui,
                    locale,
                    cells,
                ));
            }
        }
        for (error, _) in errors.iter().zip(placed).filter(|(_, placed)| !placed) {
            page.lines.extend(error_lines(&error.path, error, ui, locale, cells));
        }
        page.lines.push(Line::default());
        if errors.is_empty() {
            self.found(problem, ui, locale, width, &mut page.lines);
        }
        page
    }

    /// Results, or that they are sought.
    fn found(
        &self,
        problem: &Problem,
        ui: &Ui<'_>,
        locale: &Locale,
        width: u16,
        lines: &mut Vec<Line<'static>>,
    ) {
        let look = ui.look;
        let words = |text: &Text, style: Style| {
            let words = filter_untrusted(&text.render(locale)).into_owned();
            wrap::words(&words, width.into()).into_iter().map(move |line| Line::styled(line, style))
        };
        let details = problem.found.studied.iter().flatten().flat_map(|found| &found.details);
        let details: Vec<Line<'static>> = details.flat_map(|text| words(text, look.answer())).collect();
        let mut say = |text: &Text, style: Style| lines.extend(words(text, style));
        match &problem.found.studied {
            None if ui.waits => say(&"solving".into(), look.dim()),
            None => say(&"cancelled".into(), look.dim()),
            Some(Err(error)) => lines.extend(reasons::refusal(None, error, look, locale, width)),
            Some(Ok(found)) => {
                if let Some(progress) = &found.progress {
                    say(&progress_text(progress, ui.waits, locale.style), look.warning());
                }
                found.found.iter().for_each(|text| say(text, look.answer()));
                found.remarks.iter().for_each(|text| say(text, look.dim()));
                // A plot is seen first, where there is room for one.
                let room = usize::from(ui.area.height).saturating_sub(lines.len());
                let least = usize::from(LEAST_CURVES);
                if room < least || room >= least + details.len() {
                    lines.extend(details);
                }
            }
        }
    }

    /// Errors of the plan: of its texts, or what of them does not fit the problem.
    fn errors(&self, of: &Subject<'_>, problem: &Problem) -> Vec<FieldError> {
        let read = match self.plan.kind {
            Kind::Find => self.plan.target(of).map(drop),
            _ => self.plan.read(of).map(drop),
        };
        match (read, &problem.found.studied) {
            (Err(errors), _) => errors,
            (Ok(()), Some(Err(SolveError::Fields(errors)))) => errors.clone(),
            _ => Vec::new(),
        }
    }
}

/// An error below its line; `place` is the part of the line that it is about.
fn error_lines(
    place: &str,
    error: &FieldError,
    ui: &Ui<'_>,
    locale: &Locale,
    cells: usize,
) -> impl Iterator<Item = Line<'static>> {
    let place = place.trim_start_matches('.');
    let why = error.why.render(locale);
    let text = if place.is_empty() { why } else { format!("{place}: {why}") };
    let text = filter_untrusted(&text).into_owned();
    wrap::hanging(vec![Span::raw("    ")], &text, ui.look.error(), cells).collect::<Vec<_>>().into_iter()
}

/// Progress of a study: share, rate and time left.
fn progress_text(progress: &StudyProgress, is_running: bool, style: NumberStyle) -> Text {
    let number = |value: f64, digits| write_number(value, NumberStyle { digits, ..style });
    let share = (100.0 * progress.done as f64 / progress.points as f64).floor();
    let text = if is_running {
        "{share} % of {points} points, {rate} a second, {left} s left; Esc cancels"
    } else {
        "cancelled at {share} % of {points} points: results of these"
    };
    Text::new(text)
        .with("share", share)
        .with("points", progress.points)
        .with("rate", number(progress.rate(), 2))
        .with("left", progress.left().ceil())
}
