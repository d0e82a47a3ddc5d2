//! Sources of formulas, problems and published values.

use std::fmt;

use crate::{Language, Locale, Text};

/// A book, a standard, a paper or a set of notes.
#[derive(Debug, PartialEq, Eq)]
pub struct Source {
    /// Short citation in a worked solution: `Rao`.
    pub short: &'static str,
    /// Authors, title, edition, publisher, year.
    pub full: &'static str,
}

/// A place in a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cite {
    /// The book.
    pub source: &'static Source,
    /// The section, equation or page; may be empty.
    pub place: &'static str,
}

impl Source {
    /// A place in this source: `RAO.at("§3.7")`.
    pub const fn at(&'static self, place: &'static str) -> Cite {
        Cite { source: self, place }
    }

    /// Short citation in the language.
    pub fn short_in(&self, locale: &Locale) -> String {
        Text::from(self.short).render(locale)
    }

    /// Authors, title, edition, publisher and year in the language.
    pub fn full_in(&self, locale: &Locale) -> String {
        Text::from(self.full).render(locale)
    }
}

/// Words of a place in English and in Portuguese.
const PLACES: [(&str, &str); 6] = [
    ("ch.", "cap."),
    ("app.", "ap."),
    ("App.", "ap."),
    ("table", "tabela"),
    ("problem", "problema"),
    ("example", "exemplo"),
];

impl Cite {
    /// The citation in the language: `Khurmi & Gupta, cap. 22`.
    pub fn render(&self, locale: &Locale) -> String {
        let short = self.source.short_in(locale);
        if self.place.is_empty() {
            return short;
        }
        let word = |word: &'static str| match locale.language {
            Language::English => word,
            Language::Portuguese => PLACES
                .iter()
                .find(|(english, _)| *english == word)
                .map_or(word, |(_, portuguese)| *portuguese),
        };
        let place: Vec<&str> = self.place.split(' ').map(word).collect();
        format!("{short}, {}", place.join(" "))
    }
}

impl fmt::Display for Cite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.source.short)?;
        if self.place.is_empty() { Ok(()) } else { write!(f, ", {}", self.place) }
    }
}
