//! Names as files, ids and types write them.

use anyhow::{Result, bail};

/// Refuses what is no name in kebab case: `two-plane`.
pub(crate) fn check_kebab(name: &str) -> Result<()> {
    let word = |word: &str| {
        word.starts_with(|c: char| c.is_ascii_lowercase())
            && word.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit())
    };
    if name.split('-').all(word) {
        return Ok(());
    }
    let meant: Vec<String> = name
        .split(|c: char| !c.is_ascii_alphanumeric())
        .map(|word| word.trim_start_matches(|c: char| c.is_ascii_digit()).to_ascii_lowercase())
        .filter(|word| !word.is_empty())
        .collect();
    match meant.join("-") {
        meant if meant.is_empty() => {
            bail!("`{name}` is no name: write words in lower case, like `two-plane`")
        }
        meant => bail!("`{name}` is no name in kebab case: write `{meant}`"),
    }
}

/// `two-plane` as `two_plane`.
pub(crate) fn snake(kebab: &str) -> String {
    kebab.replace('-', "_")
}

/// `Engines, gears and wheels` as `engines_gears_and_wheels`.
pub(crate) fn snake_of(words: &str) -> String {
    let words = words.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_").to_lowercase()
}

/// `two-plane` or `two_plane` as `TwoPlane`.
pub(crate) fn pascal(name: &str) -> String {
    name.split(['-', '_'])
        .flat_map(|word| {
            let mut letters = word.chars();
            letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters)
        })
        .collect()
}

/// `two-plane` as `Two plane`.
pub(crate) fn title(kebab: &str) -> String {
    let words = kebab.replace('-', " ");
    let mut letters = words.chars();
    letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect()
}

/// The one of `known` that `name` was most likely meant as.
pub(crate) fn nearest<'k>(name: &str, known: &'k [String]) -> Option<&'k str> {
    known.iter().map(|known| (distance(name, known), known.as_str())).min().map(|(_, known)| known)
}

/// Returns true if two names differ by a typing mistake.
pub(crate) fn is_slip(a: &str, b: &str) -> bool {
    distance(a, b) <= 2
}

/// Number of letters that are inserted, deleted or replaced to turn one name into the other.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (n, here) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = n + 1;
        for (m, there) in b.iter().enumerate() {
            let changed = diagonal + usize::from(here != *there);
            diagonal = row[m + 1];
            row[m + 1] = changed.min(row[m] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_in_three_spellings() {
        assert_eq!(snake("base-excitation"), "base_excitation");
        assert_eq!(pascal("base-excitation"), "BaseExcitation");
        assert_eq!(pascal("rod_on_shaft"), "RodOnShaft");
        assert_eq!(title("base-excitation"), "Base excitation");
        assert_eq!(snake_of("Strings, beams and plates"), "strings_beams_and_plates");
    }

    #[test]
    fn a_bad_name_is_refused_with_what_was_meant() {
        for name in ["demo", "two-plane", "frame2-d"] {
            check_kebab(name).unwrap();
        }
        for (name, meant) in [
            ("Two Plane", "write `two-plane`"),
            ("two_plane", "write `two-plane`"),
            ("../x", "write `x`"),
            ("a--b", "write `a-b`"),
            ("2-plane", "write `plane`"),
            ("", "words in lower case"),
        ] {
            let err = check_kebab(name).unwrap_err().to_string();
            assert!(err.contains(meant), "{err}");
        }
    }

    #[test]
    fn the_nearest_name_is_found() {
        let known = ["balancing", "rigid-body", "vibration", "virtual-work"].map(str::to_owned);
        assert_eq!(nearest("vibrations", &known), Some("vibration"));
        assert_eq!(nearest("rigidbody", &known), Some("rigid-body"));
        assert_eq!(nearest("x", &[]), None);
    }
}
