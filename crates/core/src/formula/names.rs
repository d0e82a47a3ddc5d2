//! Names compared as people write them: `ω_n`, `ωₙ` and `omega_n` are one name.

use crate::{
    Text,
    ascii::{greek, index},
    path::distance,
};

/// Letters that look like a Greek one, beside those of [`greek`].
const LIKE_GREEK: [(char, &str); 3] = [('µ', "mu"), ('ο', "omicron"), ('∆', "Delta")];

/// A name without what may be written in several ways, by which formulas compare symbols: Greek letters spelled out, indices
/// on the line, without `_` and brackets, so that `m[2]`, `m_2` and `m₂` are one name. A comma between indices stays.
pub fn normalised(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        if c.is_ascii() {
            if !matches!(c, '_' | '[' | ']' | ' ') {
                text.push(c);
            }
            continue;
        }
        let like = LIKE_GREEK.iter().find(|(letter, _)| *letter == c).map(|(_, spelled)| *spelled);
        if let Some(spelled) = greek(c).or(like) {
            text += spelled;
        } else if let Some(plain) = index(c) {
            text.push(plain);
        } else if c == '′' {
            text.push('\'');
        } else {
            text.push(c);
        }
    }
    text
}

/// Letters that are typed in place of a Greek one, with its name.
const TYPED_FOR_GREEK: [(&str, &str); 6] =
    [("w", "omega"), ("z", "zeta"), ("d", "delta"), ("u", "mu"), ("th", "theta"), ("ph", "phi")];
/// The most names that a refusal offers.
const MOST_OFFERED: usize = 3;

/// Refusal of a name that nothing has, with the nearest of the known ones.
pub(crate) fn missing(name: &str, known: &[String]) -> Text {
    let near = nearest_names(name, known);
    let why = if near.is_empty() {
        Text::new(
            "there is no `{name}` here: no input, definition, answer or step has that name or symbol; `dalembert show` lists those of inputs and answers, the Working those of steps",
        )
    } else {
        let near: Vec<String> = near.iter().map(|near| format!("`{near}`")).collect();
        Text::new(
            "there is no `{name}` here; did you mean {near}? `dalembert show` lists the names of inputs and answers, the Working those of steps",
        )
        .with("near", near.join(", "))
    };
    why.with("name", name)
}

/// The known names that a name was probably meant as, the nearest first: written in another way, the last part of a path, or
/// a slip away.
pub(crate) fn nearest_names<'k>(name: &str, known: &'k [String]) -> Vec<&'k str> {
    let plain = |name: &str| normalised(name).to_lowercase().replace(['-', '.'], "");
    let wanted = plain(name);
    let (length, last) = (wanted.chars().count(), |path: &str| path.rsplit('.').next().map(plain));
    let greek = TYPED_FOR_GREEK.iter().filter_map(|(typed, greek)| {
        let rest = wanted.strip_prefix(typed)?;
        Some(format!("{greek}{rest}"))
    });
    let greek: Vec<String> = greek.collect();
    let rank = |candidate: &str| {
        let candidate_name = plain(candidate);
        if candidate_name == wanted {
            return Some(0);
        }
        if last(candidate).is_some_and(|last| last == wanted) || greek.contains(&candidate_name) {
            return Some(1);
        }
        // A symbol of one or two letters is a slip away from most others.
        let slips = distance(&wanted, &candidate_name);
        (length > 2 && slips <= 1 + length / 5).then_some(1 + slips)
    };
    let mut found: Vec<(usize, &str)> =
        known.iter().filter_map(|candidate| Some((rank(candidate)?, candidate.as_str()))).collect();
    found.sort_by_key(|(rank, candidate)| (*rank, candidate.len()));
    let mut offered: Vec<&str> = Vec::new();
    for (_, candidate) in found {
        if !offered.contains(&candidate) && offered.len() < MOST_OFFERED {
            offered.push(candidate);
        }
    }
    offered
}
