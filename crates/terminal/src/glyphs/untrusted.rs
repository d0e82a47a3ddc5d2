//! Text of a file or a user, before any terminal, log or report sees it.

use std::borrow::Cow;

use unicode_width::UnicodeWidthChar;

/// Accents in a row that are kept on one character; `θ̈` needs one.
const MOST_ACCENTS: usize = 2;

/// The text without anything that could drive a terminal or show other than it is.
///
/// Controls (C0, DEL, C1) become `�`, so that it shows where something was; line feeds stay, a tab and the Unicode
/// line separators become a space. Bidirectional controls, zero-width characters, variation selectors and tags are
/// dropped, and so is every accent after the second on one character. Filtering twice changes nothing more.
pub fn filter_untrusted(text: &str) -> Cow<'_, str> {
    if !text.chars().any(doubtful) {
        return Cow::Borrowed(text);
    }
    let mut accents = 0;
    let filtered: String = text
        .chars()
        .filter_map(|character| {
            let kept = match character {
                '\n' => '\n',
                '\t' | '\u{2028}' | '\u{2029}' => ' ',
                _ if character.is_control() => '\u{FFFD}',
                _ if invisible(character) => return None,
                _ => character,
            };
            if kept.width() == Some(0) {
                accents += 1;
                (accents <= MOST_ACCENTS).then_some(kept)
            } else {
                accents = 0;
                Some(kept)
            }
        })
        .collect();
    if filtered == text { Cow::Borrowed(text) } else { Cow::Owned(filtered) }
}

/// Returns true for a character that the filter has to examine: any but line feeds and characters with a width of their
/// own.
fn doubtful(character: char) -> bool {
    match character {
        ' '..='~' | '\n' => false,
        '\u{2028}' | '\u{2029}' => true,
        _ => character.is_control() || invisible(character) || character.width() == Some(0),
    }
}

/// Characters that change how others look, or hide, without a shape of their own.
fn invisible(character: char) -> bool {
    matches!(character,
        '\u{AD}' | '\u{34F}' | '\u{61C}' // soft hyphen, grapheme joiner, Arabic letter mark
        | '\u{115F}' | '\u{1160}' | '\u{3164}' | '\u{FFA0}' // Hangul fillers
        | '\u{17B4}' | '\u{17B5}' | '\u{180B}'..='\u{180F}'
        | '\u{200B}'..='\u{200F}' // zero-width space and joiners, directional marks
        | '\u{202A}'..='\u{202E}' // embeddings and overrides
        | '\u{2060}'..='\u{206F}' // word joiner, invisible operators, isolates
        | '\u{FE00}'..='\u{FE0F}' | '\u{FEFF}' | '\u{FFF0}'..='\u{FFFB}'
        | '\u{1BCA0}'..='\u{1BCA3}' | '\u{1D173}'..='\u{1D17A}'
        | '\u{E0000}'..='\u{E0FFF}') // tags, more variation selectors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinary_text_is_borrowed() {
        for text in ["plain", "two\nlines", "ω = √(k/m)", "ação", "θ̈ + ẋ²", "梁", ""] {
            assert!(matches!(filter_untrusted(text), Cow::Borrowed(same) if same == text), "{text}");
        }
    }

    #[test]
    fn nothing_that_drives_a_terminal_survives() {
        for (hostile, harmless) in [
            ("a\x1b[31mb", "a\u{FFFD}[31mb"),
            ("\x1b]52;c;aGk=\x07", "\u{FFFD}]52;c;aGk=\u{FFFD}"),
            ("\u{9b}2J", "\u{FFFD}2J"),
            ("a\rb\x08\x7f\0", "a\u{FFFD}b\u{FFFD}\u{FFFD}\u{FFFD}"),
            ("tab\there", "tab here"),
            ("abc\u{202E}dcb\u{2066}", "abcdcb"),
            ("ze\u{200B}ro\u{FEFF}", "zero"),
            ("sep\u{2028}arated", "sep arated"),
        ] {
            assert_eq!(filter_untrusted(hostile), harmless);
        }
    }

    #[test]
    fn accents_do_not_pile_up() {
        let piled = format!("x{}y\u{308}", "\u{301}".repeat(500));
        assert_eq!(filter_untrusted(&piled), "x\u{301}\u{301}y\u{308}");
    }

    #[test]
    fn every_character_comes_out_visible_and_filtering_is_idempotent() {
        for character in ('\0'..'\u{20000}').chain('\u{E0000}'..'\u{E1000}') {
            let text = format!("a{character}b");
            let once = filter_untrusted(&text).into_owned();
            assert_eq!(filter_untrusted(&once), once, "{character:?}");
            assert!(!once.chars().any(|c| c.is_control() && c != '\n'), "{character:?}");
        }
    }
}
