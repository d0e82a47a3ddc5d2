//! The files that a path may mean, as far as it is typed.

use std::path::{Path, PathBuf};

use crate::keys::turned;

/// The names in the folder that is typed.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// The folder that was asked for last, as it is typed: up to the last `/`.
    folder: Option<String>,
    /// Names in the folder, in order; folders end in `/`.
    all: Vec<String>,
    /// Text typed before a completion was inserted, and the index of that completion.
    tried: Option<(String, usize)>,
}

impl Names {
    /// The folder that is to be looked into for this text, where that was not asked for yet.
    pub fn wanted(&mut self, typed: &str) -> Option<PathBuf> {
        let (folder, _) = split(typed);
        if self.folder.as_deref() == Some(folder) {
            return None;
        }
        *self = Self { folder: Some(folder.to_owned()), ..Self::default() };
        Some(folder_of(folder))
    }

    /// Takes what is in a folder, unless another was asked for since.
    pub fn take(&mut self, folder: &Path, names: Vec<String>) {
        if self.folder.as_deref().is_some_and(|asked| folder_of(asked) == folder) {
            self.all = names;
        }
    }

    /// A character was typed: completion ends.
    pub fn typed(&mut self) {
        self.tried = None;
    }

    /// The names that begin as the text does, and which of them is tried.
    pub fn matching(&self, typed: &str) -> (Vec<&str>, Option<usize>) {
        let typed = self.tried.as_ref().map_or(typed, |(typed, _)| typed);
        let (_, begun) = split(typed);
        let begun = begun.to_lowercase();
        let fits = |name: &&str| {
            name.to_lowercase().starts_with(&begun) && (begun.starts_with('.') || !name.starts_with('.'))
        };
        let found = self.all.iter().map(String::as_str).filter(fits).collect();
        (found, self.tried.as_ref().map(|(_, at)| *at))
    }

    /// The text with the next name that fits, or the one before; `None` where none does.
    pub fn next(&mut self, typed: &str, forward: bool) -> Option<String> {
        let (found, at) = self.matching(typed);
        let last = found.len().checked_sub(1)?;
        let to = match at {
            Some(at) => turned(at, if forward { 1 } else { -1 }, found.len()),
            None if forward => 0,
            None => last,
        };
        let (folder, _) = split(typed);
        let text = format!("{folder}{}", found[to]);
        let before = self.tried.take().map_or_else(|| typed.to_owned(), |(typed, _)| typed);
        // The only one is meant: what is in it comes next.
        self.tried = (last > 0).then_some((before, to));
        Some(text)
    }

    /// Returns true if a completion is inserted that is not accepted yet.
    pub fn is_trying(&self) -> bool {
        self.tried.is_some()
    }
}

/// The folder of a path with its `/`, and what follows it.
fn split(typed: &str) -> (&str, &str) {
    typed.split_at(typed.rfind('/').map_or(0, |at| at + 1))
}

fn folder_of(typed: &str) -> PathBuf {
    PathBuf::from(if typed.is_empty() { "." } else { typed })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_tried_one_after_the_other() {
        let mut names = Names::default();
        assert_eq!(names.wanted("lab/fa"), Some(PathBuf::from("lab/")));
        assert_eq!(names.wanted("lab/fan"), None);
        let there = ["fan.toml", "Fan2.toml", "old/", ".hidden"].map(str::to_owned).to_vec();
        names.take(Path::new("other/"), vec!["wrong".to_owned()]);
        names.take(Path::new("lab/"), there);
        assert_eq!(names.matching("lab/fa").0, ["fan.toml", "Fan2.toml"]);
        assert_eq!(names.matching("lab/").0, ["fan.toml", "Fan2.toml", "old/"]);
        assert_eq!(names.next("lab/fa", true).as_deref(), Some("lab/fan.toml"));
        assert_eq!(names.next("lab/fan.toml", true).as_deref(), Some("lab/Fan2.toml"));
        assert_eq!(names.next("lab/Fan2.toml", true).as_deref(), Some("lab/fan.toml"));
        assert_eq!(names.next("lab/fan.toml", false).as_deref(), Some("lab/Fan2.toml"));
        names.typed();
        assert_eq!(names.next("lab/o", true).as_deref(), Some("lab/old/"));
        assert!(!names.is_trying() && names.wanted("lab/old/").is_some());
        assert_eq!(names.next("lab/old/", true), None);
    }
}
