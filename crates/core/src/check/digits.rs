//! Numbers as they are copied: one digit wrong, or two interchanged.

use super::Change;

/// Digits that look alike.
const ALIKE: [(char, char); 9] = [
    ('1', '7'),
    ('3', '8'),
    ('5', '6'),
    ('6', '9'),
    ('0', '6'),
    ('2', '7'),
    ('3', '5'),
    ('4', '9'),
    ('6', '8'),
];

/// True if a number is so many times another by the decimal point alone.
pub(super) fn is_shifted(times: f64) -> bool {
    let places = times.abs().log10();
    !places.is_finite() || (places - places.round()).abs() < 1e-9
}

/// True if the first digits in which two numbers differ look alike.
pub(super) fn looks_alike(right: &str, taken: &str) -> bool {
    let differ = right.chars().zip(taken.chars()).find(|(a, b)| a != b);
    differ.is_some_and(|(a, b)| ALIKE.contains(&(a, b)) || ALIKE.contains(&(b, a)))
}

/// A number with one digit of it copied wrongly, or two neighbours interchanged.
pub(super) fn other_digit(value: f64) -> Vec<(Change, f64)> {
    let mut found = Vec::new();
    if value == 0.0 || !value.is_finite() {
        return found;
    }
    let text = written(value);
    let mut may = |change: fn(String, String) -> Change, taken: String| {
        // Nobody copies a number as nothing.
        if let Ok(value) = taken.parse::<f64>()
            && value != 0.0
        {
            found.push((change(text.clone(), taken), value));
        }
    };
    let characters: Vec<char> = text.chars().collect();
    let end = characters.iter().position(|one| *one == 'e').unwrap_or(characters.len());
    for (at, digit) in characters[..end].iter().enumerate().filter(|(_, digit)| digit.is_ascii_digit()) {
        for other in ('0'..='9').filter(|other| other != digit) {
            let mut taken = characters.clone();
            taken[at] = other;
            may(Change::Digit, taken.into_iter().collect());
        }
        let next = (at + 1..end).find(|next| characters[*next].is_ascii_digit());
        if let Some(next) = next.filter(|next| characters[*next] != *digit) {
            let mut taken = characters.clone();
            taken.swap(at, next);
            may(Change::Swapped, taken.into_iter().collect());
        }
    }
    found
}

/// A number as a person writes it, with at most six significant digits and no exponent where there need be none.
fn written(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || !(1e-4..1e7).contains(&size) {
        return format!("{value:e}");
    }
    let places = (5 - size.log10().floor() as i32).clamp(0, 12) as usize;
    let text = format!("{value:.places$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
