//! Phrases that the glossary has retired do not come back.

use std::path::Path;

use anyhow::{Context, Result};
use memchr::memmem;

use super::{Tree, ends_in, lines};
use crate::cargo::git;

/// Path of the document with the retired phrases, in a table under [`HEADING`].
pub(super) const GLOSSARY: &str = "docs/glossary.md";
/// The heading of that table: phrase, what to write instead, places, exceptions.
const HEADING: &str = "## Words that do not come back";
/// Documents that quote messages, or the phrases themselves.
const QUOTING: [&str; 3] = [GLOSSARY, "docs/refusals.md", "CHANGELOG.md"];

/// Folders of such documents: the reference, and first entries, which stand as they were written.
const QUOTING_FOLDERS: [&str; 2] = ["docs/reference/", "tests/first-entry/"];

fn is_quoting(path: &str) -> bool {
    QUOTING.contains(&path) || QUOTING_FOLDERS.iter().any(|folder| path.starts_with(folder))
}

/// A row of the table.
struct Retired<'t> {
    phrase: &'t str,
    /// The phrase as [`spaced`] writes it.
    spaced: String,
    instead: &'t str,
    places: &'t str,
    exceptions: &'t str,
}

pub(super) fn retired_phrases_do_not_come_back(tree: &Tree) -> Vec<String> {
    let Some(glossary) = tree.text(GLOSSARY) else { return Vec::new() };
    let retired = retired(glossary);
    let mut faults = Vec::new();
    for (path, text) in tree.iter().filter(|(path, _)| !is_quoting(path)) {
        // Few files have any: only their lines are read.
        let words = spaced(&text.replace('_', " "));
        let is_met = |one: &&Retired| memmem::find(words.as_bytes(), one.spaced.as_bytes()).is_some();
        let here: Vec<&Retired> =
            retired.iter().filter(is_met).filter(|one| !one.is_excepted(path)).collect();
        if here.is_empty() {
            continue;
        }
        for (n, line) in lines(text) {
            let words = spaced(&line.replace('_', " "));
            for one in here.iter().filter(|one| words.contains(&one.spaced) && one.stands_in(path, line)) {
                faults.push(format!("{path}:{n}: `{}` is retired: write {}", one.phrase, one.instead));
            }
        }
    }
    faults
}

/// Subjects of the commits since the table says `Commits since HASH` that use a retired phrase, are longer than 72
/// characters or have no body; nothing where the history is not there.
pub(super) fn commits(root: &Path, glossary: &str) -> Result<Vec<String>> {
    let Some(since) = section(glossary).lines().find_map(|line| line.strip_prefix("Commits since ")) else {
        return Ok(Vec::new());
    };
    let range = format!("{}..HEAD", since.trim().trim_end_matches('.'));
    let Ok(log) = git(root, &["log", "--no-merges", "--format=%h%x1f%s%x1f%b%x1e", &range]) else {
        return Ok(Vec::new());
    };
    let retired = retired(glossary);
    let mut faults = Vec::new();
    for entry in log.split('\x1e').map(str::trim).filter(|entry| !entry.is_empty()) {
        let mut parts = entry.split('\x1f');
        let hash = parts.next().unwrap_or_default();
        let subject = parts.next().with_context(|| format!("{hash} has no subject"))?;
        if subject.chars().count() > 72 {
            faults.push(format!("{hash}: the subject has more than 72 characters"));
        }
        if parts.next().is_none_or(|body| body.trim().is_empty()) {
            faults.push(format!("{hash}: the body must say why"));
        }
        let words = spaced(subject);
        for one in retired.iter().filter(|one| one.places.contains("commits") && words.contains(&one.spaced))
        {
            faults.push(format!("{hash}: `{}` is retired: write {}", one.phrase, one.instead));
        }
    }
    Ok(faults)
}

impl Retired<'_> {
    fn is_excepted(&self, path: &str) -> bool {
        self.exceptions.split('`').skip(1).step_by(2).any(|start| path.starts_with(start))
    }

    /// Returns true if the phrase, found in a line of a file, is used there in one of its places.
    fn stands_in(&self, path: &str, line: &str) -> bool {
        let is = |place: &str| self.places.contains(place);
        let is_quoted =
            || line.split('"').skip(1).step_by(2).any(|quoted| spaced(quoted).contains(&self.spaced));
        if ends_in(path, "rs") {
            is("code") || is("messages") && is_quoted()
        } else if ends_in(path, "md") {
            is("documents") && spaced(line).contains(&self.spaced)
        } else if ends_in(path, "ftl") {
            let text = line.split_once(" = ").map(|(_, text)| spaced(text));
            is("translations") && text.is_some_and(|text| text.contains(&self.spaced))
        } else {
            // Files and lists of exercises that say the former name of a case are still read.
            let is_current = !line.starts_with("former = ");
            let in_place = is("messages") || is("titles") && line.starts_with("name = ");
            ends_in(path, "toml") && is_current && in_place && is_quoted()
        }
    }
}

/// The rows of the table.
fn retired(glossary: &str) -> Vec<Retired<'_>> {
    let rows = section(glossary).lines().filter_map(|line| line.strip_prefix("| `"));
    rows.filter_map(|row| {
        let mut cells = row.trim_end().trim_end_matches('|').split('|').map(str::trim);
        let phrase = cells.next()?.trim_end_matches('`');
        Some(Retired {
            phrase,
            spaced: format!(" {phrase} "),
            instead: cells.next()?,
            places: cells.next()?,
            exceptions: cells.next()?,
        })
    })
    .collect()
}

/// The part of the glossary under the heading.
fn section(glossary: &str) -> &str {
    let Some((_, below)) = glossary.split_once(HEADING) else { return "" };
    below.split_once("\n## ").map_or(below, |(section, _)| section)
}

/// The words of a line in lower case between single spaces, and a stop for each punctuation mark; names and ids are one
/// word each: ` is . given `.
fn spaced(line: &str) -> String {
    let mut words = String::from(" ");
    for part in line.split_inclusive(|c: char| !c.is_alphanumeric() && !"_-".contains(c)) {
        let word = part.trim_end_matches(|c: char| !c.is_alphanumeric() && !"_-".contains(c));
        if !word.is_empty() {
            words.extend(word.chars().flat_map(char::to_lowercase));
            words.push(' ');
        }
        if part.len() > word.len() && !part.ends_with(char::is_whitespace) {
            words.push_str(". ");
        }
    }
    words
}
