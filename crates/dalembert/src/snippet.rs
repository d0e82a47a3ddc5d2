//! Errors of a problem file, with the lines they stand in.

use std::{ops::Range, path::Path};

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet, renderer::DecorStyle};
use dalembert_core::{FieldError, Text, file};
use dalembert_tui::glyphs::{Glyphs, filter_untrusted};

use crate::{console::Console, failure::FileErrors};

/// The most errors that are shown.
const MOST: usize = 100;
/// The longest line that is shown, in bytes; of a longer one the place is reported alone.
const LONGEST_LINE: usize = 200;

/// Errors, each with its file, line and column, and the line itself.
pub(crate) fn show(
    path: &Path,
    text: &str,
    errors: &[(Text, Option<Range<usize>>)],
    console: &Console,
) -> FileErrors {
    let renderer = if console.styled_errors { Renderer::styled() } else { Renderer::plain() };
    let unicode = !console.locale.style.ascii && console.capabilities.glyphs == Glyphs::Unicode;
    let decor = if console.styled_errors && unicode { DecorStyle::Unicode } else { DecorStyle::Ascii };
    let renderer = renderer.decor_style(decor).term_width(console.width);
    let origin = console.plain(&path.to_string_lossy()).replace('\n', " ");
    let error = Text::from("error").render(&console.locale);
    let group = |why: &Text, span: Option<&Range<usize>>| {
        let level = Level::ERROR.with_name(error.clone());
        let title = console.plain(&why.render(&console.locale)).replace('\n', " ");
        let title = level.primary_title(title);
        let Some(span) = span.filter(|span| text.get(span.start..span.end).is_some()) else {
            return title.element(Origin::path(origin.clone()));
        };
        let line = Line::of(text, span);
        if !line.is_plain() {
            return title.element(Origin::path(origin.clone()).line(line.number).char_column(line.column()));
        }
        title.element(
            Snippet::source(line.text.to_owned())
                .line_start(line.number)
                .path(origin.clone())
                .annotation(AnnotationKind::Primary.span(line.span)),
        )
    };
    let shown = errors.iter().take(MOST).map(|(why, span)| {
        let group: Group<'_> = group(why, span.as_ref());
        renderer.render(&[group])
    });
    let mut shown = shown.collect::<Vec<_>>();
    if let Some(more) = errors.len().checked_sub(MOST).filter(|more| *more > 0) {
        shown.push(Text::new("and {more} more errors").with("more", more).render(&console.locale));
    }
    let line = |span: &Range<usize>| text.get(span.start..span.end).map(|_| Line::of(text, span).number);
    let place = |(why, span): &(Text, Option<Range<usize>>)| (why.clone(), span.as_ref().and_then(line));
    FileErrors { shown: shown.join("\n\n"), places: errors.iter().take(MOST).map(place).collect() }
}

/// The same for errors of fields; `typed` is what stands in the field of one.
pub(crate) fn show_fields(
    path: &Path,
    text: &str,
    errors: &[&FieldError],
    typed: &dyn Fn(&FieldError) -> String,
    console: &Console,
) -> FileErrors {
    let spans = file::locate(text, errors.iter().copied().take(MOST));
    let spans = spans.into_iter().chain(std::iter::repeat(None));
    let places: Vec<_> = errors
        .iter()
        .zip(spans)
        .map(|(err, value)| {
            let why = Text::new("{path}: {why}").with("path", &err.path).with_text("why", err.why.clone());
            (why, value.map(|value| part_of(text, value, err, typed)))
        })
        .collect();
    show(path, text, &places, console)
}

/// Within a value in quotes, the part that is wrong.
fn part_of(
    text: &str,
    value: Range<usize>,
    err: &FieldError,
    typed: &dyn Fn(&FieldError) -> String,
) -> Range<usize> {
    let inner = value.start + 1..value.end.saturating_sub(1);
    match &err.span {
        Some(part) if part.start < part.end => {
            let typed = typed(err);
            if text.get(inner.clone()) == Some(typed.as_str()) && part.end <= typed.len() {
                inner.start + part.start..inner.start + part.end
            } else {
                value
            }
        }
        _ => value,
    }
}

/// The first line of a span.
struct Line<'t> {
    text: &'t str,
    number: usize,
    /// The part of the span within this line.
    span: Range<usize>,
}

impl<'t> Line<'t> {
    fn of(text: &'t str, span: &Range<usize>) -> Self {
        let start = text[..span.start].rfind('\n').map_or(0, |at| at + 1);
        let end = text[span.start..].find('\n').map_or(text.len(), |at| span.start + at);
        let number = file::line_of(text, start);
        let end = if text[start..end].ends_with('\r') { end - 1 } else { end };
        let within = |at: usize| at.clamp(start, end.max(start)) - start;
        Line { text: &text[start..end.max(start)], number, span: within(span.start)..within(span.end) }
    }

    /// Counted from 1, in characters.
    fn column(&self) -> usize {
        1 + self.text[..self.span.start].chars().count()
    }

    /// Returns true if the line can be shown unchanged.
    fn is_plain(&self) -> bool {
        self.text.len() <= LONGEST_LINE && filter_untrusted(self.text) == self.text
    }
}
