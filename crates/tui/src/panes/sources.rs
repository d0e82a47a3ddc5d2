//! The books an analysis follows, and how its published cases come out.

use dalembert_core::{
    Entry, Locale, Refusal, SolveError, Text,
    cases::{Case, Outcome, Truth, Verdict},
};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{Page, columns::padded, wrap};
use crate::look::{Glyph, Look};

/// A published case, and how its printed answers compare with ours.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The case.
    pub case: Case,
    /// `None` while it has not been solved.
    pub verdicts: Option<Result<Vec<Verdict>, SolveError>>,
}

/// Books and cases; the page starts at each case, and `chosen` is the case that the keys act on.
pub fn lines(
    entry: &Entry,
    cases: &[Judged],
    chosen: Option<usize>,
    look: &Look,
    locale: &Locale,
    width: u16,
) -> Page {
    let width = usize::from(width).max(1);
    let mut page = Page::default();
    heading("Published cases", look, locale, width, &mut page.lines);
    for (n, judged) in cases.iter().enumerate() {
        page.starts.push(page.lines.len());
        case(judged, n, chosen == Some(n), look, locale, width, &mut page.lines);
        page.lines.push(Line::default());
    }
    if cases.is_empty() {
        page.lines.push(Line::default());
    }
    heading("Books and notes", look, locale, width, &mut page.lines);
    for source in entry.about.sources {
        let head = vec![Span::styled(look.glyph(Glyph::Bullet), look.dim()), Span::raw(" ")];
        page.lines.extend(wrap::hanging(head, source.full, Style::new(), width));
    }
    page
}

fn heading(words: &'static str, look: &Look, locale: &Locale, width: usize, lines: &mut Vec<Line<'static>>) {
    let words = wrap::words(&Text::new(words).render(locale), width);
    lines.extend(words.into_iter().map(|line| Line::styled(line, look.title())));
}

fn case(
    judged: &Judged,
    n: usize,
    chosen: bool,
    look: &Look,
    locale: &Locale,
    width: usize,
    lines: &mut Vec<Line<'static>>,
) {
    let Case { name, source, note, truth, .. } = &judged.case;
    let pointer = if chosen { look.glyph(Glyph::Pointer) } else { " " };
    let head = vec![
        Span::styled(format!("{pointer} "), look.key()),
        Span::styled(format!("{}  ", n + 1), look.dim()),
    ];
    let indent = head.iter().map(Span::width).sum::<usize>();
    let space = |more: usize| vec![Span::raw(" ".repeat((indent + more).min(width / 4)))];
    let name_style = if chosen { look.focus() } else { look.title() };
    lines.extend(wrap::hanging(head, name, name_style, width));
    let kind = Text::new(kind(*truth)).render(locale);
    lines.extend(wrap::hanging(space(0), &format!("{source} ({kind})"), look.dim(), width));
    if !note.is_empty() {
        lines.extend(wrap::hanging(space(0), note, look.dim(), width));
    }
    match &judged.verdicts {
        None => {
            let words = Text::new("not solved yet").render(locale);
            lines.extend(wrap::hanging(space(0), &words, look.dim(), width));
        }
        Some(Err(error)) => {
            let words = match error {
                SolveError::Refused(Refusal::NoAnswer(why)) => why.render(locale),
                SolveError::Refused(Refusal::Stopped) => Text::new("not solved yet").render(locale),
                SolveError::Fields(_) => error.to_string(),
            };
            let mut head = space(0);
            head.push(Span::styled(format!("{} ", look.glyph(Glyph::Bad)), look.error()));
            lines.extend(wrap::hanging(head, &words, look.error(), width));
        }
        Some(Ok(verdicts)) => compared(verdicts, &space(0), look, locale, width, lines),
    }
}

/// Printed beside ours in columns; below each other where the width does not hold them.
fn compared(
    verdicts: &[Verdict],
    space: &[Span<'static>],
    look: &Look,
    locale: &Locale,
    width: usize,
    lines: &mut Vec<Line<'static>>,
) {
    let widest =
        |text: &dyn Fn(&Verdict) -> String| verdicts.iter().map(|one| text(one).width()).max().unwrap_or(0);
    let (printed, ours) = (Text::new("printed").render(locale), Text::new("ours").render(locale));
    let name = |one: &Verdict| one.answer.replace('_', " ");
    let names = widest(&name);
    let printed_width = widest(&|one| one.printed.clone()).max(printed.width());
    let ours_width = widest(&|one| one.ours.clone()).max(ours.width());
    let outcome = |one: &Verdict| Text::new(one.outcome.name()).render(locale);
    let indent = space.iter().map(Span::width).sum::<usize>();
    let whole = indent + 2 + names + 2 + printed_width + 2 + ours_width + 2 + widest(&outcome);
    let columns = whole <= width;
    if columns && !verdicts.is_empty() {
        let head = format!("  {}  {}  {ours}", padded("", names), padded(&printed, printed_width));
        lines.push(Line::from([space, &[Span::styled(head, look.dim())]].concat()));
    }
    for one in verdicts {
        let (glyph, style) = match one.outcome {
            Outcome::Agreed => (Glyph::Good, look.good()),
            Outcome::Disputed => (Glyph::Warning, look.warning()),
            Outcome::Differing => (Glyph::Bad, look.error()),
        };
        let mark = Span::styled(format!("{} ", look.glyph(glyph)), style);
        if columns {
            let answers = [
                Span::raw(format!("{}  ", padded(&name(one), names))),
                Span::raw(format!("{}  ", padded(&one.printed, printed_width))),
                Span::raw(format!("{}  ", padded(&one.ours, ours_width))),
                Span::styled(outcome(one), style),
            ];
            lines.push(Line::from([space, &[mark], &answers].concat()));
        } else {
            // A number and its unit stay together.
            let held = |text: &str| text.replace(' ', "\u{A0}");
            let (theirs, mine) = (held(&one.printed), held(&one.ours));
            let words = format!("{}: {printed} {theirs}, {ours} {mine}, {}", name(one), outcome(one));
            lines.extend(wrap::hanging([space, &[mark]].concat(), &words, Style::new(), width));
        }
        if !one.why.is_empty() {
            let head = [space, &[Span::raw("    ")]].concat();
            lines.extend(wrap::hanging(head, &one.why, look.dim(), width));
        }
    }
}

fn kind(truth: Truth) -> &'static str {
    match truth {
        Truth::Published => "published",
        Truth::ClosedForm => "closed form",
        Truth::OtherProgram => "by another program",
        Truth::OwnEarlierValue => "our own earlier value",
    }
}
