//! Sources of formulas, problems and published values.

use std::fmt;

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
}

impl fmt::Display for Cite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.source.short)?;
        if self.place.is_empty() { Ok(()) } else { write!(f, ", {}", self.place) }
    }
}
