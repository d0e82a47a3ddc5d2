//! Preview of the chosen row: of an analysis its purpose, inputs and answers, its cases with their verdicts, and its
//! drawing; of a heading its entries.

use std::{borrow::Cow, collections::BTreeSet};

use dalembert_core::{
    Drawing, Solution, Text,
    cases::{Case, Comparison},
    exams::FAMILY,
};
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
    panes::wrap::hanging,
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
    let name = fit(&name, room_of_title(area), look);
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
        lines.extend(entry(&filter_untrusted(&contents.name(inner)), &count, look, room));
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
        lines.extend(entry(&name, &more, look, room));
    }
    draw_lines(&lines, 0, inner, buffer);
    scroll_mark(0, inner.height.into(), lines.len(), look, area, buffer);
}

/// An entry of a heading, in as many lines as it needs, with a number or a state behind it.
fn entry(name: &str, more: &str, look: &Appearance, room: usize) -> Vec<Line<'static>> {
    let head = vec![Span::styled(format!("{} ", look.glyph(Glyph::Bullet)), look.dim())];
    let mut lines: Vec<Line<'static>> = hanging(head, name, Style::new(), room).collect();
    behind(&mut lines, more, look, room);
    lines
}

/// Adds faint words behind lines that are indented by two, or below where there is no room behind.
fn behind(lines: &mut Vec<Line<'static>>, words: &str, look: &Appearance, room: usize) {
    if words.is_empty() {
        return;
    }
    let has_room = fits_behind(lines, words, room);
    match lines.last_mut().filter(|_| has_room) {
        Some(line) => line.push_span(Span::styled(format!("  {words}"), look.dim())),
        None => lines.extend(hanging(vec![Span::raw("    ")], words, look.dim(), room)),
    }
}

/// Returns true if the last of these lines has room for more words behind.
fn fits_behind(lines: &[Line<'static>], words: &str, room: usize) -> bool {
    lines.last().is_some_and(|line| line.width() + 2 + width(words) <= room)
}

fn of_leaf(model: &Model, leaf: Leaf, listing: &Listing, area: Rect, buffer: &mut Buffer) {
    let look = &model.look;
    let focused = model.picker.case.is_some();
    let name = fit(&title(model, leaf, listing), room_of_title(area), look);
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

/// Cells of the title in a frame.
fn room_of_title(area: Rect) -> usize {
    usize::from(area.width).saturating_sub(6)
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

/// The case of an exercise or an exam question, with its statement, unless one of the cases of its analysis is chosen.
fn exercise<'l>(model: &Model, leaf: Leaf, listing: &'l Listing) -> Option<&'l Case> {
    let is_exam = listing.entry.family() == FAMILY;
    let case = if is_exam { Some(0) } else { leaf.case.filter(|_| leaf.is_exercise()) };
    let case = case.filter(|_| model.picker.case.is_none())?;
    listing.cases().get(case).filter(|case| !case.statement.is_empty())
}

/// Title of the preview: of an exercise that of its case, else that of the analysis.
fn title(model: &Model, leaf: Leaf, listing: &Listing) -> String {
    exercise(model, leaf, listing)
        .map_or_else(|| listing.title(&model.locale), |case| case.title().render(&model.locale))
}

/// The statement of an exercise, what it asks for, its source and its progress.
fn statement(model: &Model, leaf: Leaf, listing: &Listing, case: &Case, room: usize, page: &mut Page) {
    let lines = &mut page.lines;
    let look = &model.look;
    let locale = &model.locale.at(listing.entry.about.id);
    let text = filter_untrusted(&case.statement.render(locale)).into_owned();
    lines.extend(wrapped(&text, room).into_iter().map(Line::from));
    lines.push(Line::default());
    lines.extend(
        wrapped(&case.source.render(locale), room).into_iter().map(|text| Line::styled(text, look.dim())),
    );
    let analysis = format!("{} ({})", listing.title(&model.locale), listing.entry.about.id);
    lines.extend(wrapped(&analysis, room).into_iter().map(|text| Line::styled(text, look.dim())));
    if leaf.is_exercise() {
        let progress = word(model.contents().progress(leaf).name(), model);
        lines.push(Line::styled(fit(&progress, room, look), look.title()));
    }
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
    let of_exercise = exercise(model, leaf, listing);
    // A title that its frame has no room for stands in the text.
    let title = Some(title(model, leaf, listing)).filter(|title| width(title) + 2 > room);
    let title = title.iter().flat_map(|title| wrapped(title, room));
    let mut page = Page::of(title.map(|line| Line::styled(line, model.look.title())).collect());
    match of_exercise {
        Some(case) => statement(model, leaf, listing, case, room, &mut page),
        None => described(model, leaf, listing, solution, room, &mut page),
    }
    let chosen = model.picker.case.or(leaf.case);
    let drawing =
        solution.and_then(|solution| solution.exhibits.iter().find_map(|exhibit| exhibit.sketch(0)));
    // What an exercise asks for is not shown before it is solved.
    let drawing = match of_exercise {
        Some(_) => drawing.map(|drawing| Cow::Owned(drawing.unsolved())),
        None => drawing,
    };
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

/// Description of an analysis: its purpose, inputs and answers, and its cases.
fn described(
    model: &Model,
    leaf: Leaf,
    listing: &Listing,
    solution: Option<&Solution>,
    room: usize,
    page: &mut Page,
) {
    let about = listing.entry.about;
    let lines = &mut page.lines;
    let locale = &model.locale.at(about.id);
    let summary = Text::from(about.summary).render(locale);
    lines.extend(wrapped(&summary, room).into_iter().map(Line::from));
    lines.extend(wrapped(about.id, room).into_iter().map(|line| Line::styled(line, model.look.dim())));
    // The choice of what is asked, or given, names no quantity.
    let is_quantity = |label: &&str| !["Find", "Given"].contains(label);
    let fields = listing.entry.fields().iter().map(|field| field.label).filter(is_quantity);
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
    cases(model, listing, chosen, room, page);
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
        let head =
            vec![Span::styled(format!("{pointer} "), look.key()), Span::styled(format!("{mark} "), style)];
        let mut lines: Vec<Line<'static>> =
            hanging(head, &case.title().render(locale), name_style, room).collect();
        // The source of a case that is not chosen stands behind its title or nowhere.
        let source = case.source.render(locale);
        if is_chosen || fits_behind(&lines, &source, room) {
            behind(&mut lines, &source, look, room);
        }
        page.lines.append(&mut lines);
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

/// `Inputs: mass, stiffness and 3 more` in few lines.
fn listed(model: &Model, heading: &'static str, all: &[String], room: usize, lines: &mut Vec<Line<'static>>) {
    if all.is_empty() {
        return;
    }
    let look = &model.look;
    let heading = word(heading, model);
    let some = |shown: usize| {
        let names = all[..shown].join(", ");
        let names = match all.len() - shown {
            0 => names,
            more => Text::new("{names} and {count} more")
                .with("names", names)
                .with("count", more)
                .render(&model.locale),
        };
        wrapped(&format!("{heading}: {names}"), room)
    };
    // More than these have no room, even if every line were filled to its end.
    let room_of_all = MOST_LISTED * (room + 1);
    let mut used = 0;
    let most = all.iter().take_while(|name| {
        used += width(name);
        let has_room = used <= room_of_all;
        used += 2;
        has_room
    });
    let few = (1..=most.count()).rev().map(some).find(|lines| lines.len() <= MOST_LISTED);
    for (n, text) in few.unwrap_or_else(|| some(1)).into_iter().enumerate() {
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
