//! Difference between an answer and the same one of a pinned result.

use dalembert_core::{Answer, Locale, Solution, Text};
use dalembert_units::{Style as Digits, write_number, write_quantity};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use crate::{look::Appearance, panes::wrap};

/// Numbers that differ by less than this share of them are the same.
const ROUNDING: f64 = 1e-12;

/// `+0.12 mm (+2.3 %)`; what has no difference in numbers says what it was. `None` where it is the same.
pub(super) fn of(answer: &Answer, pinned: &Solution, locale: &Locale) -> Option<String> {
    let Some(before) = pinned.answers.iter().find(|before| before.name == answer.name) else {
        return Some(Text::new("not present").render(locale));
    };
    let (Some(now), Some(then)) = (answer.si(), before.si()) else {
        if answer.value == before.value {
            return None;
        }
        let mut before = before.clone();
        before.unit = answer.unit.clone();
        return Some(Text::new("was {value}").with("value", before.shown(locale)).render(locale));
    };
    let difference = now - then;
    if difference.abs() <= answer.noise.max(before.noise).max(ROUNDING * now.abs().max(then.abs())) {
        return None;
    }
    let style = Digits { digits: 3, ..locale.style };
    let signed = |text: String, of: f64| if of > 0.0 { format!("+{text}") } else { text };
    let absolute = signed(write_quantity(difference, &answer.unit, style), difference);
    let share = 100.0 * difference / then.abs();
    if then.abs() <= before.noise || !share.is_finite() {
        return Some(absolute);
    }
    Some(format!("{absolute} ({} %)", signed(write_number(share, style), share)))
}

/// Puts it at the right of the last line where it fits, else on a line of its own.
pub(super) fn add(text: &str, look: &Appearance, width: usize, lines: &mut Vec<Line<'static>>) {
    match lines.last_mut() {
        Some(line) if line.width() + 2 + text.width() <= width => {
            let gap = " ".repeat(width - line.width() - text.width());
            line.push_span(Span::styled(format!("{gap}{text}"), look.dim()));
        }
        _ if text.width() + 2 <= width => {
            let gap = " ".repeat(width - text.width());
            lines.push(Line::from(vec![Span::raw(gap), Span::styled(text.to_owned(), look.dim())]));
        }
        _ => lines.extend(wrap::hanging(vec![Span::styled("  ", Style::new())], text, look.dim(), width)),
    }
}
