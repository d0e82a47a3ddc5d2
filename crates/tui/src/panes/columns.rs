//! Numbers under one another: decimal mark under decimal mark.

use ratatui::{
    style::{Modifier, Style},
    text::Span,
};
use unicode_width::UnicodeWidthStr;

use crate::{glyphs::filter_untrusted, text_entry::TextEntry};

/// A quantity as it is written, in the three parts that stand under one another.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Aligned {
    /// `−12`
    pub(super) whole: String,
    /// `.5×10⁻⁶`
    pub(super) decimals: String,
    /// ` kN/m`, with the space before it; `°`
    pub(super) unit: String,
}

impl Aligned {
    /// The parts of `−12.5 kN/m`.
    pub(super) fn of(text: &str) -> Self {
        let end = text.find([' ', '°', '′', '″', '\'', '"']).unwrap_or(text.len());
        let (number, unit) = text.split_at(end);
        let (whole, decimals) = number.split_at(number.find(['.', ',', '×', 'e']).unwrap_or(number.len()));
        Self { whole: whole.into(), decimals: decimals.into(), unit: unit.into() }
    }
}

/// The widths that a column of quantities needs: before the decimal mark, and from it on.
pub(super) fn widths<'a>(all: impl IntoIterator<Item = &'a Aligned>) -> (usize, usize) {
    all.into_iter().fold((0, 0), |(whole, decimals), one| {
        (whole.max(one.whole.width()), decimals.max(one.decimals.width()))
    })
}

/// The number of a quantity in a column of those widths.
pub(super) fn number(one: &Aligned, (whole, decimals): (usize, usize)) -> String {
    let before = " ".repeat(whole.saturating_sub(one.whole.width()));
    let after = " ".repeat(decimals.saturating_sub(one.decimals.width()));
    format!("{before}{}{}{after}", one.whole, one.decimals)
}

/// The text, filled up with spaces to `width` cells.
pub(super) fn padded(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width.saturating_sub(text.width())))
}

/// The text of a cell while it is typed in, with the cursor in it.
pub(super) fn typed_in(entry: &TextEntry, cells: usize) -> [Span<'static>; 3] {
    let input = entry.input();
    if entry.is_selected() {
        let selected = Style::new().add_modifier(Modifier::REVERSED);
        let text: String = filter_untrusted(entry.value()).chars().take(cells).collect();
        let rest = " ".repeat(cells.saturating_sub(text.width()));
        return [Span::styled(text, selected), Span::raw(rest), Span::raw("")];
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantity_has_three_parts() {
        let parts = |text| {
            let Aligned { whole, decimals, unit } = Aligned::of(text);
            [whole, decimals, unit]
        };
        assert_eq!(parts("−12.5 kN/m"), ["−12", ".5", " kN/m"]);
        assert_eq!(parts("12,5°"), ["12", ",5", "°"]);
        assert_eq!(parts("1.3×10⁻⁶ m⁴"), ["1", ".3×10⁻⁶", " m⁴"]);
        assert_eq!(parts("1e-6 m^4"), ["1", "e-6", " m^4"]);
        assert_eq!(parts("7"), ["7", "", ""]);
    }

    #[test]
    fn decimal_marks_stand_under_one_another() {
        let all = ["451.39", "0.06169", "1020"].map(Aligned::of);
        let widths = widths(&all);
        let lines: Vec<String> = all.iter().map(|one| number(one, widths)).collect();
        assert_eq!(lines, [" 451.39   ", "   0.06169", "1020      "]);
    }
}
