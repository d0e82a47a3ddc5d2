//! `cargo xtask find TERM`: the file in which a thing of that name stands.
//!
//! The words of the term are compared with those of file names and of public names; the glossary gives synonyms.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Result, bail};

use crate::tidy::Tree;

/// The document that gives the synonyms of a term: the cells of a row, each with synonyms between commas.
const GLOSSARY: &str = "docs/glossary.md";
/// Keywords of public items.
const ITEMS: [&str; 7] = ["fn", "struct", "enum", "trait", "type", "const", "static"];

/// Prints the files that are called by the term, or hold a public item of that name.
///
/// # Errors
/// There is none.
pub fn run(tree: &Tree, term: &str) -> Result<()> {
    let found = Index::of(tree).find(term);
    if found.is_empty() {
        bail!("no file and no public name has the words of `{term}` or of its synonyms in {GLOSSARY}");
    }
    for path in &found {
        println!("{path}");
    }
    Ok(())
}

/// Names of a tree, among which terms are found.
pub struct Index<'t> {
    /// The names in each source, by its path.
    names: BTreeMap<String, Names>,
    glossary: &'t str,
}

impl<'t> Index<'t> {
    /// Names in the sources of a tree, and the synonyms of its glossary.
    pub fn of(tree: &'t Tree) -> Self {
        Self { names: names(tree), glossary: tree.text(GLOSSARY).unwrap_or_default() }
    }

    /// The files that match best: by a name of the very words of the term, else by one that has all of them: file, path,
    /// public items, first line. Synonyms are tried where the term itself is nobody's name.
    pub fn find(&self, term: &str) -> Vec<String> {
        let terms = std::iter::once(term.to_owned()).chain(synonyms(self.glossary, term));
        terms.map(|term| self.best(&words(&term))).find(|found| !found.is_empty()).unwrap_or_default()
    }

    fn best(&self, wanted: &BTreeSet<String>) -> Vec<String> {
        let is_it = |name: &BTreeSet<String>| name == wanted;
        let has_it = |name: &BTreeSet<String>| wanted.is_subset(name);
        let by =
            |is: &dyn Fn(&BTreeSet<String>) -> bool, of: fn(&Names) -> &[BTreeSet<String>]| -> Vec<String> {
                let found = self.names.iter().filter(|(_, names)| of(names).iter().any(is));
                found.map(|(path, _)| path.clone()).collect()
            };
        let found = [
            by(&is_it, Names::file),
            by(&is_it, Names::items),
            by(&has_it, Names::file),
            by(&has_it, Names::path),
            by(&has_it, Names::items),
            by(&has_it, Names::heading),
        ];
        found.into_iter().find(|found| !found.is_empty()).unwrap_or_default()
    }
}

/// The words of the name of a file, of its whole path, of the line that says what it is, and of its public items.
struct Names {
    file: [BTreeSet<String>; 1],
    path: [BTreeSet<String>; 1],
    heading: [BTreeSet<String>; 1],
    items: Vec<BTreeSet<String>>,
}

impl Names {
    fn file(&self) -> &[BTreeSet<String>] {
        &self.file
    }

    fn path(&self) -> &[BTreeSet<String>] {
        &self.path
    }

    fn heading(&self) -> &[BTreeSet<String>] {
        &self.heading
    }

    fn items(&self) -> &[BTreeSet<String>] {
        &self.items
    }
}

/// Returns true if a file is a source of a crate or plugin, without its tests.
fn is_source(path: &str) -> bool {
    (path.starts_with("crates/") || path.starts_with("plugins/"))
        && path.contains("/src/")
        && !path.ends_with("/tests.rs")
        && !path.contains("/src/tests/")
}

/// The names in the sources of crates and plugins, by path.
fn names(tree: &Tree) -> BTreeMap<String, Names> {
    let sources = tree.sources().filter(|(path, _)| is_source(path));
    sources
        .map(|(path, text)| {
            let stem = path.rsplit('/').next().unwrap_or_default().trim_end_matches(".rs");
            let heading = text.lines().next().and_then(|line| line.strip_prefix("//!")).unwrap_or_default();
            let names = Names {
                file: [words(stem)],
                path: [words(path.trim_end_matches(".rs"))],
                heading: [words(heading)],
                items: text.lines().filter_map(public).collect(),
            };
            (path.to_owned(), names)
        })
        .collect()
}

/// The names of the public items and fields of the sources below a folder, but for bibliographies (`sources.rs`), whose
/// items are named after authors.
pub fn public_names(tree: &Tree, folder: &str) -> BTreeSet<String> {
    let sources = tree.sources().filter(|(path, _)| path.starts_with(folder) && is_source(path));
    let sources = sources.filter(|(path, _)| !path.ends_with("/sources.rs"));
    sources.flat_map(|(_, text)| text.lines().filter_map(public_name)).collect()
}

/// The words of the public item or field that a line begins.
fn public(line: &str) -> Option<BTreeSet<String>> {
    public_name(line).map(|name| words(&name))
}

fn public_name(line: &str) -> Option<String> {
    let rest = line.trim_start().strip_prefix("pub")?;
    let rest = rest.strip_prefix("(crate)").or_else(|| rest.strip_prefix("(super)")).unwrap_or(rest);
    let (kind, rest) = rest.strip_prefix(' ')?.split_once(' ')?;
    if let Some(field) = kind.strip_suffix(':') {
        return Some(field.to_owned());
    }
    let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    ITEMS.contains(&kind).then_some(name)
}

/// The other terms of the rows of the glossary that have this one.
fn synonyms(glossary: &str, term: &str) -> Vec<String> {
    let rows = glossary.lines().filter_map(|line| line.strip_prefix("| "));
    let mut synonyms = Vec::new();
    for row in rows {
        let mut cells = row.split(" | ").map(|cell| cell.split(", ").map(str::trim).collect::<Vec<_>>());
        let (Some(english), Some(portuguese)) = (cells.next(), cells.next()) else { continue };
        if english.iter().chain(&portuguese).any(|one| one.eq_ignore_ascii_case(term)) {
            synonyms.extend(english.iter().map(|one| (*one).to_owned()));
        }
    }
    synonyms
}

/// The words of a name in lower case and in the singular: `CamelCase`, `snake_case` or with spaces.
pub fn words(name: &str) -> BTreeSet<String> {
    let mut spaced = String::new();
    let mut was_lower = false;
    for c in name.chars() {
        if c.is_uppercase() && was_lower {
            spaced.push(' ');
        }
        was_lower = c.is_lowercase();
        spaced.extend(if c.is_alphanumeric() { c } else { ' ' }.to_lowercase());
    }
    let small = ["of", "the", "a", "and", "to", "in", "is"];
    let parts = spaced.split_whitespace().filter(|word| !small.contains(word));
    parts.map(singular).collect()
}

fn singular(word: &str) -> String {
    let without = |ending: &str| word.strip_suffix(ending).filter(|stem| stem.len() > 2);
    if let Some(stem) = without("ies") {
        return format!("{stem}y");
    }
    if let Some(stem) =
        without("es").filter(|stem| ["ch", "sh", "ss", "ias", "x"].iter().any(|end| stem.ends_with(end)))
    {
        return stem.to_owned();
    }
    let stem = without("s").filter(|stem| stem.len() > 3 && !stem.ends_with(['s', 'u', 'i']));
    stem.unwrap_or(word).to_owned()
}
