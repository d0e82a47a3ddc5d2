//! Symbols among words: `about x_B` has one that is set as in formulas.

use super::{Math, lowered, raised, symbols};

/// Most letters of each part of an index. What is longer is a name, as in `d_wire`.
const INDEX: usize = 3;
/// Letters that stand before a symbol without being a part of it.
const BEFORE: [char; 5] = ['δ', 'Δ', 'Σ', '∑', '∫'];

/// Text with its words by `words` and its symbols by `symbol`.
pub(crate) fn set_in_words(
    text: &str,
    words: impl Fn(&str) -> String,
    symbol: impl Fn(&Math) -> String,
) -> String {
    let mut out = String::new();
    let mut begin = 0;
    let mut before = None;
    for (at, letter) in text.char_indices() {
        let is_begin = before.is_none_or(|before| !continues(before) || BEFORE.contains(&before));
        if at >= begin
            && is_begin
            && let Some(end) = symbol_end(text, at)
        {
            out += &words(&text[begin..at]);
            out += &symbol(&symbols(&text[at..end]));
            begin = end;
        }
        before = Some(letter);
    }
    out + &words(&text[begin..])
}

/// True of what goes on with a word or the name of a file.
fn continues(letter: char) -> bool {
    letter.is_alphanumeric() || matches!(letter, '_' | '.')
}

/// End of the symbol with an index that begins here, if there is one: a letter, then parts of an index behind lines.
fn symbol_end(text: &str, begin: usize) -> Option<usize> {
    let mut rest = text[begin..].char_indices().peekable();
    rest.next().filter(|(_, letter)| letter.is_alphabetic())?;
    let mut parts = 0;
    while rest.next_if(|(_, letter)| *letter == '_').is_some() {
        let mut letters = 0;
        // Raised and lowered digits are numeric too.
        let is_letter =
            |letter: char| letter.is_alphanumeric() && raised(letter).is_none() && lowered(letter).is_none();
        while rest.next_if(|(_, letter)| is_letter(*letter)).is_some() {
            letters += 1;
        }
        if !(1..=INDEX).contains(&letters) {
            return None;
        }
        while rest.next_if(|(_, letter)| raised(*letter).is_some()).is_some() {}
        parts += 1;
    }
    let end = rest.peek().map_or(text.len(), |(at, _)| begin + at);
    let mut behind = text[end..].chars();
    let is_end = match behind.next() {
        Some('.') => !behind.next().is_some_and(char::is_alphanumeric),
        Some(letter) => letter != '_' && (!letter.is_alphanumeric() || lowered(letter).is_some()),
        None => true,
    };
    (parts > 0 && is_end).then_some(end)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn marked(text: &str) -> String {
        set_in_words(text, str::to_owned, |symbol| match symbol {
            Math::Symbol(base, index) => format!("<{base}|{index}>"),
            other => panic!("{other:?} is no symbol"),
        })
    }

    #[test]
    fn symbols_with_an_index_are_found_among_words() {
        assert_eq!(marked("Moments about x_B."), "Moments about <x|B>.");
        assert_eq!(marked("(I_a − I_t)/l, then H_G²"), "(<I|a> − <I|t>)/l, then <H|G>²");
        assert_eq!(marked("ΣF_y = 0 and δW_W_4"), "Σ<F|y> = 0 and δ<W|W4>");
        assert_eq!(marked("ω_Gx, J_r₁"), "<ω|Gx>, <J|r1>");
    }

    #[test]
    fn names_are_words() {
        for name in ["d_wire = 3 mm", "spring.k_a", "run_a", "x_1.csv", "x_", "_a", "a_b_", "ação_a", "k_a.b"]
        {
            assert_eq!(marked(name), name);
        }
    }
}
