//! Preview of the chosen row: of an analysis its purpose, inputs and answers, its cases with their verdicts, and its
//! drawing; of a heading its entries.

use std::{borrow::Cow, collections::BTreeSet};

use dalembert_core::{Drawing, Text, cases::Comparison};
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    style::Style,
    text::{Line, Span},
};

use crate::{
    drawing,
    glyphs::filter_untrusted,
    keys::{Action, KeyContext},
    layout,
    look::{Appearance, Glyph},
    model::Model,
    pane::Page,
    picker::{Heading, Leaf, Listing, Row},
    solver::CheckedCase,
    text::{fit, width, wrapped},
    view::{boxed, draw_lines, scroll_mark, word},
};

/// The fewest lines in which a drawing can be recognised.
const LEAST_DRAWING: u16 = 7;
/// From so many lines on there is always room for the drawing; the cases scroll above it.
const ROOMY: u16 = 24;
/// Lines of what goes in and comes out.
const MOST_LISTED: usize = 3;
/// The most that a drawing is given.
const MOST_DRAWING: u16 = 14;

/// Draws it.
pub(super) fn draw(model: &Model, row: Row, area: Rect, buffer: &mut Buffer) {
    match row {
        Row::Heading(heading) => of_heading(model, heading, area, buffer),
        Row::Leaf(leaf) => {
            if let Some(listing) = model.listings.get(leaf.listing) {
                of_leaf(model, leaf, listing, area, buffer);
            }
        }
    }
}

fn of_heading(model: &Model, heading: Heading, area: Rect, buffer: &mut Buffer) {
    let (look, contents) = (&model.look, model.contents());
    let name = filter_untrusted(&contents.name(heading)).into_owned();
    let name = fit(&name, usize::from(area.width).saturating_sub(6), look);
    boxed(&Line::styled(format!(" {name} "), look.border(false)), false, look, area, buffer);
    let inner = layout::inside(area);
    let room = usize::from(inner.width);
    let mut lines: Vec<Line<'static>> = Vec::new();
    let (count, done) = contents.count(heading);
    let said = match heading {
        Heading::Exercises | Heading::Set(_) => {
            Text::new("{done} of {count} exercises done; {key} ticks one")
                .with("done", done)
                .with("key", model.key(KeyContext::Picker, Action::Toggle))
        }
        Heading::Field => Text::from(
            "Balancing in the field: run 0, trial runs, correction and check run on pages that ask for one thing at a time. Enter begins.",
        ),
        _ if count == 1 => Text::from("1 analysis"),
        _ => Text::new("{count} analyses"),
    };
    let said = said.with("count", count).render(&model.locale);
    lines.extend(wrapped(&said, room).into_iter().map(|text| Line::styled(text, look.dim())));
    lines.push(Line::default());
    for inner in contents.below(heading) {
        let (count, done) = contents.count(inner);
        let count = match inner {
            Heading::Set(_) => format!("{done}/{count}"),
            _ => count.to_string(),
        };
        let name =
            fit(&filter_untrusted(&contents.name(inner)), room.saturating_sub(width(&count) + 4), look);
        lines.push(Line::from(vec![
            Span::styled(format!("{} ", look.glyph(Glyph::Bullet)), look.dim()),
            Span::raw(name),
            Span::styled(format!("  {count}"), look.dim()),
        ]));
    }
    for leaf in contents.leaves(heading) {
        let Some(listing) = model.listings.get(leaf.listing) else { continue };
        let case = leaf.case.and_then(|case| listing.cases().get(case));
        let (name, more) = match (heading, case) {
            (Heading::Set(_), Some(case)) => {
                let progress = word(contents.progress(leaf).name(), model);
                (case.title().render(&model.locale), progress)
            }
            _ => (listing.title(&model.locale), String::new()),
        };
        // The state is what one looks for: a long title gives way to it.
        let state = if more.is_empty() { 0 } else { width(&more) + 2 };
        let name = fit(&name, room.saturating_sub(2 + state), look);
        let mut line = Line::from(vec![
            Span::styled(format!("{} ", look.glyph(Glyph::Bullet)), look.dim()),
            Span::raw(name),
        ]);
        if !more.is_empty() {
            line.push_span(Span::styled(format!("  {more}"), look.dim()));
        }
        lines.push(line);
    }
    draw_lines(&lines, 0, inner, buffer);
    scroll_mark(0, inner.height.into(), lines.len(), look, area, buffer);
}

fn of_leaf(model: &Model, leaf: Leaf, listing: &Listing, area: Rect, buffer: &mut Buffer) {
    let look = &model.look;
    let focused = model.picker.case.is_some();
    let room = usize::from(area.width).saturating_sub(6);
    let name = fit(&listing.title(&model.locale), room, look);
    boxed(&Line::styled(format!(" {name} "), look.border(focused)), focused, look, area, buffer);
    let sheet = sheet(model, leaf, listing, layout::inside(area));
    draw_lines(&sheet.page.lines, sheet.first, sheet.text, buffer);
    if let Some(drawing) = sheet.drawing {
        // In cells: what is turned over by every key is not worth sending.
        let look = &Appearance { pixels: None, ..*look };
        drawing::render(&drawing, look, &model.locale.at(listing.entry.about.id), sheet.picture, buffer);
    }
    scroll_mark(sheet.first, sheet.text.height.into(), sheet.page.lines.len(), look, area, buffer);
}

/// The published case that stands at a place, by its number.
pub(super) fn case_at(model: &Model, row: Row, area: Rect, at: Position) -> Option<usize> {
    let Row::Leaf(leaf) = row else { return None };
    let sheet = sheet(model, leaf, model.listings.get(leaf.listing)?, layout::inside(area));
    let line = sheet.first + usize::from(at.y.checked_sub(sheet.text.y)?);
    sheet.page.part_at(line).filter(|_| sheet.text.contains(at))
}

/// Description of an analysis, and its area.
struct Preview<'m> {
    /// Begins at each case.
    page: Page,
    /// The first line that is shown.
    first: usize,
    text: Rect,
    drawing: Option<Cow<'m, Drawing>>,
    picture: Rect,
}

fn sheet<'m>(model: &'m Model, leaf: Leaf, listing: &Listing, inner: Rect) -> Preview<'m> {
    let about = listing.entry.about;
    let room = usize::from(inner.width);
    let solution = model
        .picker
        .preview
        .as_ref()
        .filter(|preview| preview.id == about.id)
        .and_then(|preview| preview.solution.as_ref());
    let mut page = Page::default();
    let lines = &mut page.lines;
    let locale = &model.locale.at(about.id);
    let summary = Text::from(about.summary).render(locale);
    lines.extend(wrapped(&summary, room).into_iter().map(Line::from));
    lines.push(Line::styled(fit(about.id, room, &model.look), model.look.dim()));
    let fields = listing.entry.fields().iter().map(|field| field.label);
    let fields: Vec<String> = fields.map(|label| lower(&Text::from(label).render(locale))).collect();
    listed(model, "Inputs", &fields, room, lines);
    let answers = solution.iter().flat_map(|solution| &solution.answers);
    // One of several is named once.
    let mut answers: Vec<String> =
        answers.map(|answer| lower(&Text::from(answer.label).render(locale))).collect();
    let mut named = BTreeSet::new();
    answers.retain(|answer| named.insert(answer.clone()));
    listed(model, "Results", &answers, room, lines);
    lines.push(Line::default());
    let chosen = model.picker.case.or(leaf.case);
    cases(model, listing, chosen, room, &mut page);
    let drawing =
        solution.and_then(|solution| solution.exhibits.iter().find_map(|exhibit| exhibit.sketch(0)));
    let wanted = u16::try_from(page.lines.len()).unwrap_or(u16::MAX).min(inner.height);
    let left = inner.height.saturating_sub(wanted + 1);
    let height = match drawing {
        Some(_) if left >= LEAST_DRAWING => left.min(MOST_DRAWING),
        Some(_) if inner.height >= ROOMY => LEAST_DRAWING + 1,
        _ => 0,
    };
    let text = Rect { height: inner.height - height, ..inner };
    let picture = Rect { y: text.bottom(), height, ..inner };
    let shown = chosen.and_then(|case| page.starts.get(case));
    let first = shown.map_or(0, |line| (line + 1).saturating_sub(text.height.into()));
    Preview { page, first, text, drawing: drawing.filter(|_| height > 0), picture }
}

/// The published cases with their verdicts.
fn cases(model: &Model, listing: &Listing, chosen: Option<usize>, room: usize, page: &mut Page) {
    let look = &model.look;
    if listing.cases().is_empty() {
        page.lines.push(Line::styled(word("no published cases", model), look.dim()));
        return;
    }
    let mut head = vec![
        Span::styled(word("Cases", model), look.title()),
        Span::styled(format!(": {}", listing.cases().len()), look.dim()),
    ];
    let sums = sums(model, listing);
    if !sums.is_empty() {
        head.push(Span::styled(format!("  {}", word("Answers", model)), look.dim()));
    }
    for (mark, style, count) in sums {
        head.push(Span::styled(format!(" {mark} {count}"), style));
    }
    page.lines.push(Line::from(head));
    for (n, case) in listing.cases().iter().enumerate() {
        let is_chosen = chosen == Some(n);
        page.starts.push(page.lines.len());
        let pointer = if is_chosen { look.glyph(Glyph::Pointer) } else { " " };
        let checked = listing.checked.as_ref().and_then(|checked| checked.get(n));
        let (mark, style) =
            checked.map_or((look.glyph(Glyph::Bullet), look.dim()), |checked| verdict(model, checked));
        let name_style = match (is_chosen, model.picker.case) {
            (true, Some(_)) => look.focus(),
            (true, None) => look.title(),
            (false, _) => Style::new(),
        };
        let locale = &model.locale.at(listing.entry.about.id);
        let name = fit(&case.title().render(locale), room.saturating_sub(4), look);
        let left = room.saturating_sub(width(&name) + 6);
        let source = case.source.render(locale);
        let mut line = Line::from(vec![
            Span::styled(format!("{pointer} "), look.key()),
            Span::styled(format!("{mark} "), style),
            Span::styled(name, name_style),
        ]);
        if left >= width(&source).min(12) {
            line.push_span(Span::styled(format!("  {}", fit(&source, left, look)), look.dim()));
        }
        page.lines.push(line);
    }
}

/// Numbers of published answers that agree, are disputed, disagree.
fn sums(model: &Model, listing: &Listing) -> Vec<(&'static str, Style, usize)> {
    let all: Vec<Comparison> = listing
        .checked
        .iter()
        .flatten()
        .filter_map(|checked| checked.verdicts.as_ref()?.as_ref().ok())
        .flatten()
        .map(|verdict| verdict.outcome)
        .collect();
    [Comparison::Agreed, Comparison::Disputed, Comparison::Differing]
        .into_iter()
        .map(|outcome| {
            let (mark, style) = marked(model, outcome);
            (mark, style, all.iter().filter(|other| **other == outcome).count())
        })
        .filter(|(_, _, count)| *count > 0)
        .collect()
}

/// The mark of a case: that of its worst answer.
fn verdict(model: &Model, checked: &CheckedCase) -> (&'static str, Style) {
    let look = &model.look;
    match &checked.verdicts {
        None => (look.glyph(Glyph::Bullet), look.dim()),
        Some(Err(_)) => marked(model, Comparison::Differing),
        Some(Ok(verdicts)) => {
            let any = |outcome| verdicts.iter().any(|verdict| verdict.outcome == outcome);
            match (any(Comparison::Differing), any(Comparison::Disputed)) {
                (true, _) => marked(model, Comparison::Differing),
                (false, true) => marked(model, Comparison::Disputed),
                _ if verdicts.is_empty() => (look.glyph(Glyph::Bullet), look.dim()),
                (false, false) => marked(model, Comparison::Agreed),
            }
        }
    }
}

fn marked(model: &Model, outcome: Comparison) -> (&'static str, Style) {
    let look = &model.look;
    match outcome {
        Comparison::Agreed => (look.glyph(Glyph::Good), look.good()),
        Comparison::Disputed => (look.glyph(Glyph::Unequal), look.warning()),
        Comparison::Differing => (look.glyph(Glyph::Bad), look.error()),
    }
}

/// `In: mass, stiffness, …` in few lines.
fn listed(model: &Model, heading: &'static str, all: &[String], room: usize, lines: &mut Vec<Line<'static>>) {
    if all.is_empty() {
        return;
    }
    let look = &model.look;
    let heading = word(heading, model);
    let mut wrapped = wrapped(&format!("{heading}: {}", all.join(", ")), room);
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
