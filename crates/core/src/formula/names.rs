//! Names compared as people write them: `ω_n`, `ωₙ` and `omega_n` are one name.

use crate::ascii::{greek, index};

/// Letters that look like a Greek one, beside those of [`greek`].
const LIKE_GREEK: [(char, &str); 3] = [('µ', "mu"), ('ο', "omicron"), ('∆', "Delta")];

/// Returns true if two names are one, written in two ways: `ω_n`, `ωₙ` and `omega_n`.
pub fn same_name(one: &str, other: &str) -> bool {
    normalised(one) == normalised(other)
}

/// A name without what may be written in several ways: Greek letters spelled out, indices on the line, without `_`
/// and brackets, so that `m[2]`, `m_2` and `m₂` are one name. A comma between indices stays.
pub(crate) fn normalised(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        let like = LIKE_GREEK.iter().find(|(letter, _)| *letter == c).map(|(_, spelled)| *spelled);
        if let Some(spelled) = greek(c).or(like) {
            text += spelled;
        } else if let Some(plain) = index(c) {
            text.push(plain);
        } else if c == '′' {
            text.push('\'');
        } else if !matches!(c, '_' | '[' | ']' | ' ') {
            text.push(c);
        }
    }
    text
}
