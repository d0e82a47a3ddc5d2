//! `cargo xtask tidy`: what the tree promises of itself that no compiler checks.
//!
//! The tree is read once; every rule is a function from it to what is wrong.

use std::{collections::BTreeMap, fs, path::Path};

use anyhow::{Context, Result, bail};

mod analyses;
mod comments;
mod examples;
mod layers;
mod loops;
mod pairs;
mod phrases;
mod text;

/// The text files of a repository, by their path from its root with `/` between folders.
pub struct Tree(BTreeMap<String, String>);

/// Folders that hold nothing written by hand, or are no part of the repository.
const LEFT_OUT: [&str; 2] = ["target", ".git"];

/// The endings of what is read.
const READ: [&str; 5] = ["rs", "toml", "md", "ftl", "yaml"];

/// Prints what is wrong with the tree; an error if anything is.
pub fn run(root: &Path) -> Result<()> {
    let tree = Tree::read(root)?;
    let mut faults = faults(&tree);
    faults.extend(phrases::commits(root, tree.text(phrases::GLOSSARY).unwrap_or_default())?);
    for fault in &faults {
        println!("{fault}");
    }
    match faults.len() {
        0 => Ok(()),
        1 => bail!("1 fault of the tree"),
        many => bail!("{many} faults of the tree"),
    }
}

/// Everything that is wrong with a tree, as `path:line: what is wrong`.
pub fn faults(tree: &Tree) -> Vec<String> {
    let rules = [
        analyses::an_analysis_is_one_file,
        analyses::a_topic_holds_analyses_alone,
        analyses::an_analysis_is_imported_by_nothing,
        analyses::every_plugin_is_in_the_bundle,
        analyses::a_plugin_is_tested_from_outside,
        comments::doc_comments_begin_with_a_noun_or_a_verb,
        examples::a_public_module_has_a_topic,
        examples::a_public_module_has_an_example_that_runs,
        layers::a_plugin_is_named_only_by_the_bundle,
        layers::a_crate_depends_only_on_what_lies_below,
        layers::pure_crates_do_no_input_or_output,
        loops::files_do_not_import_each_other_in_a_loop,
        pairs::tests_pair_lists_of_one_length,
        phrases::retired_phrases_do_not_come_back,
        text::modules_are_not_named_mod,
        text::nothing_is_left_to_do,
        text::lints_are_those_of_the_workspace,
        text::a_long_file_says_why,
        text::documents_name_what_exists,
    ];
    rules.iter().flat_map(|rule| rule(tree)).collect()
}

impl Tree {
    /// The files below a folder.
    pub fn read(root: &Path) -> Result<Self> {
        let mut files = BTreeMap::new();
        let mut folders = vec![root.to_owned()];
        while let Some(folder) = folders.pop() {
            for entry in
                fs::read_dir(&folder).with_context(|| format!("{} cannot be read", folder.display()))?
            {
                let path = entry?.path();
                let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                if path.is_dir() {
                    if !LEFT_OUT.contains(&name.as_str()) {
                        folders.push(path);
                    }
                } else if READ.iter().any(|ending| ends_in(&name, ending)) {
                    let text = fs::read_to_string(&path)
                        .with_context(|| format!("{} is no UTF-8 text", path.display()))?;
                    let below =
                        path.strip_prefix(root).expect("a file lies below the folder it was found in");
                    let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
                    files.insert(parts.join("/"), text);
                }
            }
        }
        Ok(Self(files))
    }

    /// A tree from paths and texts.
    pub fn of(files: &[(&str, &str)]) -> Self {
        Self(files.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect())
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(path, text)| (path.as_str(), text.as_str()))
    }

    pub(crate) fn text(&self, path: &str) -> Option<&str> {
        self.0.get(path).map(String::as_str)
    }

    /// Returns true if there is a file or a folder of that path.
    fn has(&self, path: &str) -> bool {
        let folder = format!("{}/", path.trim_end_matches('/'));
        self.0.contains_key(path) || self.0.keys().any(|file| file.starts_with(&folder))
    }

    /// The sources: path and text of every `.rs` file.
    pub(crate) fn sources(&self) -> impl Iterator<Item = (&str, &str)> {
        self.iter().filter(|(path, _)| ends_in(path, "rs"))
    }

    /// The manifests of the members of the workspace: folder and text.
    fn manifests(&self) -> impl Iterator<Item = (&str, &str)> {
        self.iter().filter_map(|(path, text)| {
            let folder = path.strip_suffix("/Cargo.toml")?;
            // One with a workspace of its own is no member.
            (!text.lines().any(|line| line == "[workspace]")).then_some((folder, text))
        })
    }

    /// The families: the folders of plugins that hold analyses.
    fn families(&self) -> impl Iterator<Item = &str> {
        self.manifests()
            .filter_map(|(folder, _)| folder.strip_prefix("plugins/"))
            .filter(|family| *family != "bundle" && !family.contains('/'))
    }
}

/// The lines of a text with their numbers, from 1.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().map(|(n, line)| (n + 1, line))
}

/// Returns true if a file has this extension.
fn ends_in(path: &str, ending: &str) -> bool {
    Path::new(path).extension().is_some_and(|have| have == ending)
}

/// The part of a source above its tests.
fn without_tests(text: &str) -> &str {
    text.find("#[cfg(test)]").map_or(text, |at| &text[..at])
}

#[cfg(test)]
mod tests;
