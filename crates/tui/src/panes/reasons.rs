//! The lines of a pane that has nothing to show, or may not show it.

use dalembert_core::{FieldError, Locale, Refusal, Shape, SolveError, Text};
use ratatui::{
    buffer::Buffer,
    layout::Rect,
    style::Style,
    text::{Line, Span},
};

use super::{label_of, wrap};
use crate::{
    glyphs::filter_untrusted,
    keys::{Action, KeyContext},
    look::{Appearance, Glyph},
    pane::{Page, Ui},
    pixels::Picture,
    problem::{Freshness, Problem},
    solver::JobFailure,
    text::{fit, wrapped},
};

/// The most errors that are listed.
const MOST_ERRORS: usize = 100;

/// The most empty inputs that are listed.
const MOST_MISSING: usize = 12;

/// Reason for which the present inputs have no solution: invalid inputs, a refusal, an internal error.
pub(super) fn why_not(problem: &Problem, ui: &Ui<'_>, width: u16) -> Vec<Line<'static>> {
    let (look, locale) = (ui.look, ui.locale);
    if problem.found.state == Freshness::Unread {
        let (wrong, needed) = (problem.wrong().count(), problem.needed().count());
        let is_without_numbers = problem.hides_numbers() || problem.found.solution.is_none();
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
        lines.extend(missing(problem, ui, width));
        lines.extend(problem.wrong().take(MOST_ERRORS).flat_map(|error| unread(problem, ui, error, width)));
        if wrong > MOST_ERRORS {
            let more = Text::new("and {more} more").with("more", wrong - MOST_ERRORS).render(locale);
            lines.push(Line::styled(more, look.error()));
        }
        return lines;
    }
    match &problem.found.failure {
        None => Vec::new(),
        Some(JobFailure::Unsolved(error)) => {
            refusal(Some(&problem.entry().shape()), error, look, locale, width)
        }
        Some(JobFailure::Fault(panic)) => {
            let said = Text::new("this analysis failed (internal error); your inputs are kept");
            let mut lines = wrapped(&said.render(locale), width.into());
            lines.extend(wrapped(&filter_untrusted(panic), width.into()));
            lines.into_iter().map(|text| Line::styled(text, look.error())).collect()
        }
    }
}

/// The inputs that are still empty, in the order of the form.
fn missing(problem: &Problem, ui: &Ui<'_>, width: u16) -> Vec<Line<'static>> {
    let (look, count) = (ui.look, problem.needed().count());
    let shape = problem.entry().shape();
    let label = |error: &FieldError| {
        let label = label_of(&shape, &error.path, ui.locale).unwrap_or_else(|| error.path.clone());
        let label = filter_untrusted(&label).into_owned();
        let head = vec![Span::raw(format!("  {} ", look.glyph(Glyph::Dot)))];
        wrap::hanging(head, &label, Style::new(), width.into()).collect::<Vec<_>>()
    };
    let mut lines: Vec<_> = problem.needed().take(MOST_MISSING).flat_map(label).collect();
    if count > MOST_MISSING {
        let more = Text::new("and {more} more").with("more", count - MOST_MISSING).render(ui.locale);
        lines.push(Line::styled(format!("  {more}"), look.dim()));
    }
    lines
}

fn unread(problem: &Problem, ui: &Ui<'_>, error: &FieldError, width: u16) -> Vec<Line<'static>> {
    let look = ui.look;
    let field = label_of(&problem.entry().shape(), &error.path, ui.locale);
    let field = field.unwrap_or_else(|| error.path.clone());
    let text = Text::new("{where}: {why}").with("where", field).with_text("why", error.why.clone());
    let text = filter_untrusted(&text.render(ui.locale)).into_owned();
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

/// The page of a pane that has nothing to show.
pub(super) fn nothing(problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
    let why = match (&problem.found.solution, problem.found.state) {
        (Some(_), _) => "nothing to show here".into(),
        (None, Freshness::Solving(_)) => "solving".into(),
        (None, Freshness::Unread) => problem.to_do().unwrap_or_else(|| "solving".into()),
        (None, Freshness::Stopped) => "cancelled".into(),
        (None, Freshness::Current) => "no solution".into(),
    };
    let lines = wrapped(&why.render(ui.locale), width.into());
    Page::of(lines.into_iter().map(|text| Line::styled(text, ui.look.dim())).collect())
}

/// The page of a pane whose content would give away what is to be found.
pub(super) fn covered(ui: &Ui<'_>, width: u16) -> Page {
    let words = Text::new("hidden until every step is revealed; {key} shows the results")
        .with("key", ui.key(KeyContext::Form, Action::TryByHand))
        .render(ui.locale);
    let lines = wrapped(&words, width.into()).into_iter();
    Page::of(lines.map(|text| Line::styled(text, ui.look.dim())).collect())
}

/// The page of a picture that is hidden: by the user, or while Check asks for what it would show.
pub(super) fn hidden(problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
    if problem.found.revealed.is_some() {
        return covered(ui, width);
    }
    let words = Text::new("hidden until yours is correct").render(ui.locale);
    let lines = wrapped(&words, width.into()).into_iter();
    Page::of(lines.map(|text| Line::styled(text, ui.look.dim())).collect())
}

/// Draws the page of a pane that has nothing to show.
pub(super) fn draw_nothing(problem: &Problem, ui: &Ui<'_>, room: Rect, buffer: &mut Buffer) {
    nothing(problem, ui, room.width).draw(0, room, buffer);
}

/// Draws, above a picture of earlier inputs, that it is one; the room that is left.
pub(super) fn draw_stale(problem: &Problem, ui: &Ui<'_>, room: Rect, buffer: &mut Buffer) -> Rect {
    if !problem.is_stale() || problem.found.solution.is_none() || room.height <= 3 {
        return room;
    }
    let note = Text::new("results for the previous, complete inputs").render(ui.locale);
    buffer.set_string(room.x, room.y, fit(&note, room.width.into(), ui.look), ui.look.warning());
    Rect { y: room.y + 1, height: room.height - 1, ..room }
}

/// Dims a picture of earlier inputs, in cells and in pixels.
pub(super) fn dim_stale(
    problem: &Problem,
    ui: &Ui<'_>,
    room: Rect,
    mut pictures: Vec<Picture>,
    buffer: &mut Buffer,
) -> Vec<Picture> {
    if problem.is_stale() {
        buffer.set_style(room, ui.look.dim());
        let dim = ui.look.stroke(ui.look.dim().into());
        for picture in &mut pictures {
            picture.raster.change_inks(|_| dim);
        }
    }
    pictures
}

/// Message of an analysis without a solution. Fields are named by their labels in `shape`, the inputs of the analysis,
/// where it holds them.
pub fn refusal(
    shape: Option<&Shape>,
    error: &SolveError,
    look: &Appearance,
    locale: &Locale,
    width: u16,
) -> Vec<Line<'static>> {
    let width = usize::from(width).max(1);
    let heading = |words: &'static str, style: Style| {
        wrap::words(&Text::new(words).render(locale), width)
            .into_iter()
            .map(move |line| Line::styled(line, style))
            .collect::<Vec<_>>()
    };
    match error {
        SolveError::Refused(Refusal::Stopped) => heading("Solution cancelled.", look.dim()),
        SolveError::Refused(Refusal::NoAnswer(why)) => {
            let mut lines = heading("No solution", look.warning());
            lines.push(Line::default());
            let why = why.render(locale);
            lines.extend(wrap::words(&why, width).into_iter().map(Line::from));
            lines
        }
        SolveError::Fields(errors) => {
            let mut lines = heading("Some inputs cannot be read", look.error());
            lines.push(Line::default());
            for error in errors {
                let label = shape.and_then(|shape| label_of(shape, &error.path, locale));
                let words =
                    format!("{}: {}", label.as_ref().unwrap_or(&error.path), error.why.render(locale));
                lines.extend(marked(look, Glyph::Bad, look.error(), &words, Style::new(), width));
            }
            lines
        }
    }
}

/// Lines of a pane that belong to the inputs before the last change: dimmed, under a note that reports it.
pub fn stale(
    lines: Vec<Line<'static>>,
    look: &Appearance,
    locale: &Locale,
    width: u16,
) -> Vec<Line<'static>> {
    let note = Text::new("results for the previous, complete inputs").render(locale);
    let note = marked(look, Glyph::Warning, look.warning(), &note, look.warning(), usize::from(width).max(1));
    let dimmed = lines.into_iter().map(|line| {
        let spans = line.spans.into_iter().map(|span| Span::styled(span.content, look.dim()));
        Line::from(spans.collect::<Vec<_>>())
    });
    note.chain([Line::default()]).chain(dimmed).collect()
}

/// A pictogram, and words beside it.
pub(super) fn marked(
    look: &Appearance,
    glyph: Glyph,
    glyph_style: Style,
    words: &str,
    style: Style,
    width: usize,
) -> impl Iterator<Item = Line<'static>> {
    let head = vec![Span::styled(look.glyph(glyph), glyph_style), Span::raw(" ")];
    wrap::hanging(head, words, style, width)
}
