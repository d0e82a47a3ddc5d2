//! Line breaks in formulas that are too long for a line: before sums, else before products, else within brackets, roots and
//! fractions, which are then written on one line.
//!
//! Widths are estimates in ems, the size of the letters around: those who set the pieces know their own letters.

use std::mem::take;

use super::{Math, closing};

/// Signs before which a line breaks first.
const SUMS: [char; 8] = ['+', '−', '-', '±', '=', '≤', '≥', '<'];
/// Signs before which a line breaks where it must.
const PRODUCTS: [char; 5] = ['×', '·', '⋅', '*', '/'];

/// Terms of a formula, each in pieces that are not broken and that are no wider than `room`, if anything can be done
/// about it. A formula that has room is one term of one piece.
pub(crate) fn broken(formula: &Math, room: f64) -> Vec<Vec<Math>> {
    if width(formula) <= room {
        return vec![vec![formula.clone()]];
    }
    let terms = terms(parts(formula));
    terms.into_iter().map(|term| pieces(term, room).into_iter().map(whole).collect()).collect()
}

/// The terms of a broken formula, each as the texts of its pieces. `set` gets a piece, and true if it begins with a sign that
/// stands between it and the piece before.
pub(crate) fn set_in_pieces(
    formula: &Math,
    room: f64,
    set: impl Fn(&Math, bool) -> String,
) -> Vec<Vec<String>> {
    let mut is_first = true;
    let mut piece = |piece: &Math| set(piece, !take(&mut is_first) && begins_with_sign(piece));
    broken(formula, room).iter().map(|term| term.iter().map(&mut piece).collect()).collect()
}

/// Width that is left of `room` for a side of an equation beside the symbol and the equals sign.
pub(crate) fn room_beside(symbol: &Math, room: f64) -> f64 {
    room - width(symbol) - 1.5
}

/// True of a sign that stands between two parts, and would be taken for one before a part at the begin of a piece.
fn begins_with_sign(formula: &Math) -> bool {
    let first = match formula {
        Math::Row(parts) => parts.first(),
        other => Some(other),
    };
    matches!(first, Some(Math::Operator(sign)) if SUMS.contains(sign) || PRODUCTS.contains(sign))
}

/// Estimated width of a formula, in ems.
pub(crate) fn width(formula: &Math) -> f64 {
    let letters = |text: &str, of_each: f64| of_each * text.chars().count() as f64;
    match formula {
        Math::Row(parts) => parts.iter().map(width).sum(),
        Math::Number(digits) => letters(digits, 0.5),
        Math::Upright(words) => letters(words, 0.55),
        Math::Symbol(base, index) => letters(base, 0.6) + letters(index, 0.4),
        Math::Operator('(' | ')' | '[' | ']' | '|' | ',' | ';') => 0.45,
        Math::Operator(_) => 1.2,
        Math::Gap => 0.2,
        Math::Fraction(top, bottom) => width(top).max(width(bottom)) + 0.3,
        Math::Root(_, of) => width(of) + 1.0,
        Math::Power(base, small) | Math::Index(base, small) => width(base) + letters(small, 0.4),
        Math::Brackets(_, inner) => width(inner) + 1.0,
    }
}

fn parts(formula: &Math) -> Vec<Math> {
    match formula {
        Math::Row(parts) => parts.clone(),
        other => vec![other.clone()],
    }
}

fn whole(mut parts: Vec<Math>) -> Math {
    if parts.len() == 1 { parts.remove(0) } else { Math::Row(parts) }
}

fn width_of(parts: &[Math]) -> f64 {
    parts.iter().map(width).sum()
}

fn is_sign(part: &Math, of: &[char]) -> bool {
    matches!(part, Math::Operator(sign) if of.contains(sign))
}

/// Parts in terms: a new one begins before a sign between two parts, and behind a comma.
fn terms(parts: Vec<Math>) -> Vec<Vec<Math>> {
    let mut terms: Vec<Vec<Math>> = vec![Vec::new()];
    for part in parts {
        let last = terms.last().and_then(|term| term.last());
        let is_between = last.is_some_and(|last| !matches!(last, Math::Operator(_) | Math::Gap));
        let is_behind_comma = last.is_some_and(|last| is_sign(last, &[',', ';']));
        if is_sign(&part, &SUMS) && is_between || is_behind_comma {
            terms.push(Vec::new());
        }
        if let Some(term) = terms.last_mut()
            && !(term.is_empty() && part == Math::Gap)
        {
            term.push(part);
        }
    }
    terms
}

/// A term in pieces, none of which is wider than `room` if that can be had.
fn pieces(term: Vec<Math>, room: f64) -> Vec<Vec<Math>> {
    if width_of(&term) <= room {
        return vec![term];
    }
    let mut found: Vec<Vec<Math>> = Vec::new();
    for factor in factors(term) {
        if width_of(&factor) <= room {
            found.push(factor);
            continue;
        }
        let is_alone =
            factor.iter().filter(|part| !matches!(part, Math::Operator(_) | Math::Gap)).count() == 1;
        let mut piece: Vec<Math> = Vec::new();
        for part in factor {
            let opened = opened(part, room, is_alone && found.is_empty());
            for (n, more) in opened.into_iter().enumerate() {
                if n > 0 {
                    found.push(take(&mut piece));
                }
                piece.extend(more);
            }
        }
        found.push(piece);
    }
    found
}

/// Factors of a term, each with the sign before it; a number keeps its unit, and a function what it is of.
fn factors(term: Vec<Math>) -> Vec<Vec<Math>> {
    let mut factors: Vec<Vec<Math>> = vec![Vec::new()];
    let mut rest = term.into_iter().peekable();
    while let Some(part) = rest.next() {
        let Some(factor) = factors.last_mut() else { break };
        let is_between = factor.last().is_some_and(|last| !matches!(last, Math::Operator(_)));
        let is_upright = |part: Option<&Math>| matches!(part, Some(Math::Upright(_)) | None);
        if is_sign(&part, &PRODUCTS) && is_between {
            factors.push(vec![part]);
        } else if part == Math::Gap && is_between && !is_upright(factor.last()) && !is_upright(rest.peek()) {
            factors.push(Vec::new());
        } else {
            factor.push(part);
        }
    }
    factors
}

/// A part that is too wide, in pieces. A fraction that stands beside other factors is put into brackets.
fn opened(part: Math, room: f64, is_alone: bool) -> Vec<Vec<Math>> {
    if width(&part) <= room {
        return vec![vec![part]];
    }
    // For the brackets, root and stroke beside what is within.
    let room = room - 2.0;
    match part {
        Math::Row(parts) => pieces_of_sum(parts, room),
        Math::Brackets(open, inner) => in_brackets(open, &inner, room),
        Math::Root(degree, of) if degree.is_empty() => {
            let root = vec![Math::Operator('√'), Math::Operator('(')];
            enclosed(root, pieces_of_sum(parts(&of), room), ')')
        }
        Math::Power(base, power) => raised(&base, room, |last| Math::Power(last, power)),
        Math::Index(base, index) => raised(&base, room, |last| Math::Index(last, index)),
        Math::Fraction(top, bottom) => {
            let top = side(&top, room, |parts| terms(parts.to_vec()).len() > 1);
            let bottom = side(&bottom, room, |parts| parts.len() > 1);
            let mut pieces = top;
            for (n, piece) in bottom.into_iter().enumerate() {
                let stroke = if n == 0 { vec![Math::Operator('/'), Math::Gap] } else { Vec::new() };
                pieces.push([stroke, piece].concat());
            }
            if is_alone { pieces } else { enclosed(vec![Math::Operator('(')], pieces, ')') }
        }
        other => vec![vec![other]],
    }
}

/// Pieces of a sum, all alike.
fn pieces_of_sum(parts: Vec<Math>, room: f64) -> Vec<Vec<Math>> {
    terms(parts).into_iter().flat_map(|term| pieces(term, room)).collect()
}

/// Numerator or denominator of a fraction on one line, in brackets where it needs them.
fn side(formula: &Math, room: f64, needs_brackets: impl Fn(&[Math]) -> bool) -> Vec<Vec<Math>> {
    let parts = parts(formula);
    if needs_brackets(&parts) {
        enclosed(vec![Math::Operator('(')], pieces_of_sum(parts, room), ')')
    } else {
        pieces_of_sum(parts, room)
    }
}

/// Pieces between brackets.
fn enclosed(open: Vec<Math>, mut pieces: Vec<Vec<Math>>, close: char) -> Vec<Vec<Math>> {
    if let Some(first) = pieces.first_mut() {
        first.splice(0..0, open);
    }
    if let Some(last) = pieces.last_mut() {
        last.push(Math::Operator(close));
    }
    pieces
}

/// Pieces of something in brackets, whose brackets no longer grow with it.
fn in_brackets(open: char, inner: &Math, room: f64) -> Vec<Vec<Math>> {
    enclosed(vec![Math::Operator(open)], pieces_of_sum(parts(inner), room), closing(open))
}

/// Pieces of a base, with what is raised or lowered behind its closing bracket.
fn raised(base: &Math, room: f64, set: impl FnOnce(Box<Math>) -> Math) -> Vec<Vec<Math>> {
    let mut pieces = match base {
        Math::Brackets(open, inner) => in_brackets(*open, inner, room),
        other => in_brackets('(', other, room),
    };
    if let Some(last) = pieces.last_mut()
        && let Some(bracket) = last.pop()
    {
        last.push(set(Box::new(bracket)));
    }
    pieces
}

/// A formula in lines that are no wider than `room`, if anything can be done about it, for what does not break lines
/// itself: whole terms are put on a line while there is room, then whole pieces.
#[cfg(feature = "word")]
pub(crate) fn lines(formula: &Math, room: f64) -> Vec<Math> {
    let mut lines: Vec<Vec<Math>> = vec![Vec::new()];
    for term in broken(formula, room) {
        let units: Vec<Math> = if width_of(&term) <= room { vec![Math::Row(term)] } else { term };
        for unit in units {
            let is_full =
                lines.last().is_some_and(|line| !line.is_empty() && width_of(line) + width(&unit) > room);
            if is_full {
                lines.push(Vec::new());
            }
            if let Some(line) = lines.last_mut() {
                line.push(unit);
            }
        }
    }
    lines.into_iter().map(whole).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{symbols, values};

    /// Letters of a formula without what sets them.
    fn letters(formula: &Math) -> String {
        match formula {
            Math::Row(parts) => parts.iter().map(letters).collect(),
            Math::Number(text) | Math::Upright(text) => text.clone(),
            Math::Symbol(base, index) => format!("{base}{index}"),
            Math::Operator(sign) => sign.to_string(),
            Math::Gap => String::new(),
            Math::Fraction(top, bottom) => format!("{}/{}", letters(top), letters(bottom)),
            Math::Root(degree, of) => format!("{degree}√{}", letters(of)),
            Math::Power(base, power) => format!("{}{power}", letters(base)),
            Math::Index(base, index) => format!("{}{index}", letters(base)),
            Math::Brackets(open, inner) => format!("{open}{}", letters(inner)),
        }
    }

    fn pieces_of(text: &str, room: f64) -> Vec<Vec<String>> {
        let terms = broken(&values(text), room);
        terms.iter().map(|term| term.iter().map(letters).collect()).collect()
    }

    #[test]
    fn a_formula_that_has_room_is_left_alone() {
        assert_eq!(broken(&symbols("a + b"), 20.0), [[symbols("a + b")]]);
    }

    #[test]
    fn a_long_formula_is_broken_between_terms_before_factors() {
        let text = "2 kg × 3 m/s × 5 + 4 kg × 5 m/s";
        assert_eq!(pieces_of(text, 12.0), [["2kg×3m/s×5"], ["+4kg×5m/s"]]);
        assert_eq!(pieces_of(text, 6.0), [vec!["2kg", "×3m/s", "×5"], vec!["+4kg", "×5m/s"]]);
    }

    #[test]
    fn long_brackets_roots_and_fractions_are_opened() {
        assert_eq!(pieces_of("2 × (3 m + 4 m + 5 m)", 6.0), [["2", "×(3m", "+4m", "+5m)"]]);
        assert_eq!(pieces_of("√(3 m + 4 m + 5 m)", 6.0), [["√(3m", "+4m", "+5m)"]]);
        assert_eq!(pieces_of("(3 m + 4 m + 5 m) / (2 × 3 s)", 6.0), [["(3m", "+4m", "+5m)", "/(2×3s)"]]);
        assert_eq!(pieces_of("(3 m + 4 m + 5 m)²", 6.0), [["(3m", "+4m", "+5m)2"]]);
    }

    #[test]
    fn no_letter_is_lost_and_no_piece_is_wider_than_its_room() {
        let text = "−0 rad/s² × 150 mm × cos(30°) / (200 mm × cos(−22.024°)) + (150 mm × (20 rad/s)² × sin(30°) + 200 mm × \
                    (−14.013 rad/s)² × sin(−22.024°)) / (200 mm × cos(−22.024°)) − √((1 − 0.98²)² + (2 × 0.06 × 0.98)²) i";
        let plain = |text: &str| text.chars().filter(|c| !"()| ".contains(*c)).collect::<String>();
        let whole = plain(&letters(&values(text)));
        for room in [10.0, 12.0, 19.0, 33.0] {
            let broken = broken(&values(text), room);
            let all: String = broken.iter().flatten().map(letters).collect();
            assert_eq!(plain(&all), whole, "{room}");
            for piece in broken.iter().flatten() {
                assert!(width(piece) <= room + 1.0, "{room}: {} in {}", width(piece), letters(piece));
            }
        }
    }
}
