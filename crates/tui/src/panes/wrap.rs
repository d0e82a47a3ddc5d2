//! Words and formulas in lines of a given width. Nothing is cut away: what does not fit goes on below.

use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use dalembert_plot::wrap::broken;
pub(super) use dalembert_plot::wrap::words;

/// A formula in lines of at most `first` and then `rest` cells, broken before its operators (after commas): outside
/// brackets, and before plus and minus rather than times, where that leaves no line half empty.
pub(super) fn formula(text: &str, first: usize, rest: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut left = text.to_owned();
    let mut width = first.max(1);
    while left.width() > width {
        let at = break_of(&left, width);
        let tail = left.split_off(at);
        lines.push(left.trim_end().to_owned());
        tail.trim_start().clone_into(&mut left);
        width = rest.max(1);
    }
    lines.push(left);
    lines
}

/// A head, and beside it words in as many lines as they need.
pub(crate) fn hanging(
    head: Vec<Span<'static>>,
    text: &str,
    style: Style,
    width: usize,
) -> impl Iterator<Item = Line<'static>> {
    let indent: usize = head.iter().map(Span::width).sum();
    // Where the head leaves no room for words, they go below it.
    let (beside, indent) = if indent + 8 <= width.max(16) { (true, indent) } else { (false, 0) };
    let mut texts = words(text, width.saturating_sub(indent)).into_iter();
    let first = if beside { texts.next() } else { None };
    let mut line = head;
    line.extend(first.map(|text| Span::styled(text, style)));
    std::iter::once(Line::from(line)).chain(
        texts.map(move |text| Line::from(vec![Span::raw(" ".repeat(indent)), Span::styled(text, style)])),
    )
}

/// End of the first line of a formula, in bytes.
fn break_of(text: &str, width: usize) -> usize {
    let (mut cells, mut depth) = (0, 0u32);
    // The best operator so far: how tightly it binds, the cells before it, and its place; and the last space.
    let mut best: Option<(u32, usize, usize)> = None;
    let mut space = None;
    let mut last = ' ';
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            ' ' if at > 0 => {
                space = Some(at);
                let binding = match text[at + 1..].split(' ').next().unwrap_or_default() {
                    _ if last == ',' || last == ';' => Some(0),
                    "+" | "-" | "−" | "=" => Some(0),
                    "×" | "*" | "/" | "·" => Some(1),
                    _ => None,
                };
                // A tighter place counts only where the looser one would leave the line half empty.
                if let Some(binding) = binding.map(|binding| 2 * depth + binding)
                    && best.is_none_or(|(looser, before, _)| binding <= looser || 2 * before <= width)
                {
                    best = Some((binding, cells, at));
                }
            }
            _ => {}
        }
        cells += c.width().unwrap_or(0);
        last = c;
        // A space may stand beyond the edge.
        if cells > width {
            break;
        }
    }
    let place = best.map(|(.., at)| at).or(space);
    place.unwrap_or_else(|| broken(text, width).first().map_or(text.len(), String::len))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_break_before_operators_and_outside_brackets() {
        assert_eq!(formula("a + b", 10, 10), ["a + b"]);
        assert_eq!(
            formula("200 kN/mm² × 1.3×10⁻⁶ m⁴ / (1.2 m)³", 28, 28),
            ["200 kN/mm² × 1.3×10⁻⁶ m⁴", "/ (1.2 m)³"]
        );
        assert_eq!(formula("alpha beta + (c − delta + e)", 18, 18), ["alpha beta", "+ (c − delta + e)"]);
        // Inside brackets rather than a line half empty.
        assert_eq!(
            formula("a + (beta gamma − delta epsilon)", 20, 20),
            ["a + (beta gamma", "− delta epsilon)"]
        );
    }

    #[test]
    fn no_part_of_a_formula_is_lost() {
        let text = "√((k − m ω²)² + (c ω)²) / (m₁ r₁ cos θ₁ + m₂ r₂ cos θ₂) × 1.2345×10⁻⁶ m⁴";
        for (first, rest) in (1..90).flat_map(|first| [(first, first), (first, first / 2)]) {
            let lines = formula(text, first, rest);
            assert!(
                lines.iter().skip(1).all(|line| line.width() <= rest.max(1)),
                "{first} {rest}: {lines:?}"
            );
            assert!(lines[0].width() <= first);
            assert_eq!(lines.concat().replace(' ', ""), text.replace(' ', ""));
        }
    }
}
