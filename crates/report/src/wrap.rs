//! Lines of a width: sentences break at blanks, formulas before an operator.

use unicode_width::UnicodeWidthStr;

/// The columns a text takes.
pub(crate) fn columns(text: &str) -> usize {
    text.width()
}

/// A text with blanks behind it, up to a width.
pub(crate) fn padded(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width.saturating_sub(columns(text))))
}

/// Sentences in lines of `width` columns; a word that is longer has a line of its own.
pub(crate) fn sentences(text: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            if !line.is_empty() && columns(&line) + 1 + columns(word) > width {
                lines.push(std::mem::take(&mut line));
            }
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
        lines.push(line);
    }
    lines
}

/// A formula in lines: the first of `width` columns, the others `hang` less.
///
/// A line breaks before `+`, `−` or `=` outside of as many brackets as possible, then before another operator,
/// and where there is none, at a blank. A number is never parted from its digits.
pub(crate) fn formula(text: &str, width: usize, hang: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest = text;
    let mut room = width.max(1);
    while columns(rest) > room {
        let Some(at) = best_break(rest, room) else { break };
        lines.push(rest[..at].trim_end().to_owned());
        rest = rest[at..].trim_start();
        room = width.saturating_sub(hang).max(1);
    }
    lines.push(rest.to_owned());
    lines
}

/// Best break of a formula within `room` columns: the byte at which the next line begins.
fn best_break(text: &str, room: usize) -> Option<usize> {
    let mut depth = 0;
    let mut best: Option<(usize, usize)> = None;
    for (at, character) in text.char_indices() {
        match character {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ' ' => {
                let column = columns(&text[..at]);
                if column > room {
                    // Nothing fits: the first place beyond is the least harm.
                    return Some(best.map_or(at + 1, |(_, at)| at));
                }
                if let Some(cost) = cost(&text[..at], &text[at + 1..]) {
                    // A break in the first third leaves a ragged line.
                    let cost = cost
                        + 4 * usize::try_from(depth).unwrap_or(0)
                        + if 3 * column < room { 20 } else { 0 };
                    if best.is_none_or(|(least, _)| cost <= least) {
                        best = Some((cost, at + 1));
                    }
                }
            }
            _ => {}
        }
    }
    best.map(|(_, at)| at)
}

/// Penalty of a break between two parts of a formula; `None` where a break is not allowed.
fn cost(before: &str, after: &str) -> Option<usize> {
    const SUMS: [char; 4] = ['+', '−', '-', '='];
    const PRODUCTS: [char; 4] = ['×', '*', '/', '·'];
    let operator = |text: &str, signs: [char; 4]| {
        signs.iter().any(|sign| text.starts_with([*sign]) && text[sign.len_utf8()..].starts_with(' '))
    };
    if operator(after, SUMS) {
        Some(0)
    } else if operator(after, PRODUCTS) {
        Some(3)
    } else if before.ends_with(SUMS) || before.ends_with(PRODUCTS) {
        None
    } else if before.ends_with([',', ';']) {
        Some(4)
    } else {
        // Between a number and its unit, or between factors that are written side by side.
        Some(40)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_break_at_blanks() {
        assert_eq!(sentences("one two three", 7), ["one two", "three"]);
        assert_eq!(sentences("incompressible a", 4), ["incompressible", "a"]);
        assert_eq!(sentences("ação é só", 6), ["ação é", "só"]);
    }

    #[test]
    fn formulas_break_before_plus_and_minus_first() {
        assert_eq!(formula("2 kg × 3 m/s + 4 kg × 5 m/s", 20, 2), ["2 kg × 3 m/s", "+ 4 kg × 5 m/s"]);
        assert_eq!(formula("2 kg × 3 m/s × (4 m + 5 m) × 7", 25, 0), ["2 kg × 3 m/s", "× (4 m + 5 m) × 7"]);
        assert_eq!(formula("short", 20, 2), ["short"]);
    }

    #[test]
    fn nothing_of_a_formula_is_lost() {
        let text = "√((1 − (0.98578)²)² + (2 × 0.06169 × 0.98578)²) / (40 kg × 1.2×10⁻⁶ m⁴) − |−5 N| + atan2(1 N, 2 N)";
        for width in 1..120 {
            assert_eq!(formula(text, width, 2).join(" "), text, "{width}");
        }
    }
}
