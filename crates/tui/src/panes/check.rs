//! The user's own answers, each beside what is said of it.

use dalembert_core::{Answer, Locale, Solution, Text, check::Verdict};
use ratatui::{
    style::{Modifier, Style},
    text::{Line, Span},
};
use tui_input::Input;
use unicode_width::UnicodeWidthStr;

use super::{Page, columns::padded, wrap};
use crate::{
    ask::Ask,
    glyphs::filter_untrusted,
    look::{Glyph, Look},
    tab::Tab,
};

/// Cells of the narrowest and of the widest cell to type in.
const CELL: (usize, usize) = (10, 24);

/// The answers with what was typed for each; the page starts at each answer. `focused`: whether the keys act here.
pub fn page(solution: &Solution, ask: &Ask, focused: bool, look: &Look, locale: &Locale, width: u16) -> Page {
    let width = usize::from(width).max(1);
    let check = &ask.check;
    let locale = &locale.ascii(look.ascii);
    let mut page = Page::default();
    let words = "Enter your result. The reference value stays hidden until yours is correct.";
    let words = wrap::words(&Text::new(words).render(locale), width).into_iter();
    page.lines.extend(words.map(|line| Line::styled(line, look.dim())));
    page.lines.push(Line::default());
    let labels: Vec<String> = solution.answers.iter().map(|answer| answer.label(locale)).collect();
    let longest = labels.iter().map(|label| label.width()).max().unwrap_or(0);
    let cell = (width / 3).clamp(CELL.0, CELL.1);
    let beside = width.saturating_sub(cell + 6);
    let columns = Columns { label: longest.min(beside), cell };
    for (n, (answer, label)) in solution.answers.iter().zip(&labels).enumerate() {
        page.starts.push(page.lines.len());
        let under_cursor = n == check.cursor;
        let one = One {
            answer,
            label,
            text: check.text(&answer.name.to_string()),
            edit: ask.edit.as_ref().filter(|_| under_cursor),
            focused: focused && under_cursor,
            verdict: check.verdict(solution, &answer.name.to_string()),
        };
        one.line(&columns, look, &mut page.lines);
        one.said(solution, ask, look, locale, width, &mut page.lines);
    }
    page
}

struct Columns {
    label: usize,
    cell: usize,
}

struct One<'a> {
    answer: &'a Answer,
    label: &'a str,
    text: &'a str,
    edit: Option<&'a Input>,
    focused: bool,
    verdict: Option<Verdict>,
}

impl One<'_> {
    fn line(&self, columns: &Columns, look: &Look, lines: &mut Vec<Line<'static>>) {
        let pointer = if self.focused { look.glyph(Glyph::Pointer) } else { " " };
        let name = if self.focused { look.title() } else { Style::new() };
        let mut label = wrap::words(self.label, columns.label);
        let last = label.pop().unwrap_or_default();
        let mut head = Span::styled(format!("{pointer} "), look.border(self.focused));
        for line in label {
            lines.push(Line::from(vec![
                std::mem::replace(&mut head, Span::raw("  ")),
                Span::styled(line, name),
            ]));
        }
        let mut line =
            Line::from(vec![head, Span::styled(padded(&last, columns.label), name), Span::raw("  ")]);
        match self.edit {
            Some(input) => line.extend(typed_in(input, columns.cell)),
            None if self.text.is_empty() => {
                let unit = self.answer.unit.shown(look.ascii);
                let hint = if unit.is_empty() { look.glyph(Glyph::Ellipsis).to_owned() } else { unit };
                let hint = padded(&look.shortened(&hint, columns.cell), columns.cell);
                let style = if self.focused { look.focus() } else { look.dim() };
                line.push_span(Span::styled(hint, style));
            }
            None => {
                let text = filter_untrusted(self.text).into_owned();
                let text = padded(&look.shortened(&text, columns.cell), columns.cell);
                line.push_span(Span::styled(text, if self.focused { look.focus() } else { Style::new() }));
            }
        }
        let (glyph, style) = match &self.verdict {
            None => ("", Style::new()),
            Some(Verdict::Right) => (look.glyph(Glyph::Good), look.good()),
            Some(Verdict::RoundedEarly(_) | Verdict::TooFewDigits) => {
                (look.glyph(Glyph::Warning), look.warning())
            }
            Some(Verdict::Wrong | Verdict::Unread(_)) => (look.glyph(Glyph::Bad), look.error()),
        };
        line.push_span(Span::styled(format!(" {glyph}"), style));
        lines.push(line);
    }

    /// What is said below the line.
    fn said(
        &self,
        solution: &Solution,
        ask: &Ask,
        look: &Look,
        locale: &Locale,
        width: usize,
        lines: &mut Vec<Line<'static>>,
    ) {
        let name = self.answer.name.to_string();
        let mut say = |text: &str, style: Style| {
            lines.extend(wrap::hanging(vec![Span::raw("    ")], text, style, width));
        };
        match &self.verdict {
            None | Some(Verdict::Right) => {}
            Some(verdict @ (Verdict::RoundedEarly(_) | Verdict::TooFewDigits)) => {
                say(&verdict.text().render(&locale.digits(2)), look.warning());
            }
            Some(Verdict::Unread(why)) => say(&filter_untrusted(&why.render(locale)), look.dim()),
            Some(Verdict::Wrong) => match &ask.check.slips {
                None if ask.waits(Tab::Check) => {
                    say(
                        &Text::new("incorrect; searching for a common error that gives this value")
                            .render(locale),
                        look.error(),
                    );
                }
                None => say(&Text::new("incorrect").render(locale), look.error()),
                Some(all) => {
                    let slips =
                        all.iter().find(|(known, _)| *known == name).map_or(&[][..], |(_, slips)| slips);
                    if slips.is_empty() {
                        say(
                            &Text::new("Incorrect. No common error reproduces this value.").render(locale),
                            look.error(),
                        );
                    } else {
                        say(&Text::new("Incorrect. Possible cause:").render(locale), look.error());
                    }
                    for slip in slips {
                        let text = slip.text(solution).render(locale);
                        let dot = format!("    {} ", look.glyph(Glyph::Dot));
                        lines.extend(wrap::hanging(vec![Span::raw(dot)], &text, Style::new(), width));
                    }
                }
            },
        }
        if self.verdict == Some(Verdict::Right) || ask.check.seen.contains(&name) {
            let shown = format!("= {}", self.answer.shown(locale));
            lines.extend(wrap::hanging(vec![Span::raw("    ")], &shown, look.answer(), width));
        }
    }
}

/// The text of a cell while it is typed in, with the cursor in it.
pub(super) fn typed_in(input: &Input, cells: usize) -> [Span<'static>; 3] {
    let scroll = input.visual_scroll(cells.saturating_sub(1));
    let text = filter_untrusted(input.value()).into_owned();
    let seen: Vec<char> = text.chars().chain([' ']).skip(scroll).take(cells).collect();
    let at = input.visual_cursor().saturating_sub(scroll).min(seen.len().saturating_sub(1));
    let under = Style::new().add_modifier(Modifier::UNDERLINED);
    let after: String = seen[at + 1..].iter().collect();
    [
        Span::styled(seen[..at].iter().collect::<String>(), under),
        Span::styled(seen[at].to_string(), Style::new().add_modifier(Modifier::REVERSED)),
        Span::styled(padded(&after, cells.saturating_sub(at + 1)), under),
    ]
}
