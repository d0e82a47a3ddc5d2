//! Common parts of the files for learning platforms.

use dalembert_core::{Answer, Locale};

use crate::{Exercise, Variant, decimal::rounded, sheets};

/// A file for a learning platform: its path within the folder that is written, and its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExportFile {
    /// Path, its parts apart by `/`.
    pub path: String,
    /// Content.
    pub text: String,
}

/// A number to be filled in, in the unit that stands beside it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Blank {
    /// Name of the answer.
    pub(crate) name: String,
    /// Label of the answer.
    pub(crate) label: String,
    /// Unit that stands beside the blank; empty for a pure number.
    pub(crate) unit: String,
    /// Right value.
    pub(crate) value: f64,
    /// Tolerance, absolute.
    pub(crate) within: f64,
    /// Values of common errors, with the sentence that names each.
    pub(crate) errors: Vec<(f64, String)>,
}

impl Blank {
    /// Tolerance of the value of a common error: the same share as that of the right value.
    pub(crate) fn within_of(&self, error: f64) -> f64 {
        if self.value == 0.0 { self.within } else { (self.within * error / self.value).abs() }
    }
}

/// Blanks of a variant, one for each asked answer that is a number, to be filled in within a share of its value.
pub(crate) fn blanks(exercise: &Exercise, variant: &Variant, tolerance: f64, locale: &Locale) -> Vec<Blank> {
    let locale = &locale.at(exercise.entry.about.id);
    let blank = |name: String| {
        let answer: &Answer = variant.solution.answer(&name)?;
        let si = answer.si()?;
        let value = rounded(answer.unit.value(if si.abs() <= answer.noise { 0.0 } else { si }));
        let within = rounded((tolerance * value).abs());
        let mut errors: Vec<(f64, String)> = Vec::new();
        for error in variant.errors.get(&name).into_iter().flatten() {
            let wrong = rounded(answer.unit.value(error.si));
            // The first mistake with a value gives the sentence.
            let is_apart =
                |other: f64| (wrong - other).abs() > 2.0 * tolerance * wrong.abs().max(other.abs());
            if wrong.is_finite() && is_apart(value) && errors.iter().all(|(known, _)| is_apart(*known)) {
                errors.push((wrong, error.text.render(locale)));
            }
        }
        let (label, unit) = (answer.label(locale), answer.unit.shown(locale.style.ascii));
        Some(Blank { name, label, unit, value, within, errors })
    };
    variant.numbers().into_iter().filter_map(blank).collect()
}

/// The drawing of a variant as SVG.
pub(crate) fn svg(variant: &Variant, locale: &Locale) -> Option<String> {
    Some(sheets::drawing(variant, locale)?.svg())
}

/// Words as text of XML or HTML.
pub(crate) fn escaped(words: &str) -> String {
    let mut text = String::with_capacity(words.len());
    for character in words.chars() {
        match character {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '"' => text.push_str("&quot;"),
            '\n' | '\r' | '\t' => text.push(' '),
            _ if character.is_control() || matches!(character, '\u{FFFE}' | '\u{FFFF}') => {
                text.push('\u{FFFD}');
            }
            _ => text.push(character),
        }
    }
    text
}

/// An identifier of letters, digits and hyphens that begins with a letter: that of a name in any script.
pub(crate) fn identifier(name: &str) -> String {
    let plain: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' }).collect();
    let words: Vec<&str> = plain.split('-').filter(|word| !word.is_empty()).collect();
    let joined = words.join("-");
    // Names that share their letters have different hashes.
    let tail = if joined == name { String::new() } else { format!("-{:08x}", crate::seed_of(name) as u32) };
    if joined.starts_with(|c: char| c.is_ascii_alphabetic()) {
        joined + &tail
    } else {
        format!("v-{joined}{tail}")
    }
}

/// Part of the name of a file for a variant: its label where that is plain.
pub fn file_label(label: &str) -> String {
    let is_plain = !label.is_empty() && label.chars().all(|c| c.is_ascii_alphanumeric());
    if is_plain { label.to_owned() } else { identifier(label) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_plain_and_apart() {
        assert_eq!(identifier("fan-on-cantilever"), "fan-on-cantilever");
        assert!(identifier("Ação 1").starts_with("a-o-1-"));
        assert_ne!(identifier("a b"), identifier("a_b"));
        assert!(identifier("2023001").starts_with("v-2023001"));
        assert!(identifier("../../x").chars().all(|c| c.is_ascii_alphanumeric() || c == '-'));
    }
}
