//! Names and texts of files.

use super::{Tree, ends_in, lines};
use crate::names::snake;

/// More lines than this need a reason.
const LONG: usize = 600;

/// Prefix of the comment that gives the reason for a long file.
const REASON: &str = "// Long because ";

pub(super) fn modules_are_not_named_mod(tree: &Tree) -> Vec<String> {
    let named = tree.sources().filter(|(path, _)| path.ends_with("/mod.rs"));
    named
        .map(|(path, _)| format!("{path}: write {}.rs beside the folder", path.trim_end_matches("/mod.rs")))
        .collect()
}

pub(super) fn nothing_is_left_to_do(tree: &Tree) -> Vec<String> {
    // In halves, so that this file is not among what it finds.
    let marks =
        [("TO", "DO"), ("FIX", "ME"), ("XX", "X"), ("dbg", "!("), ("todo", "!("), ("unimplemented", "!(")];
    let marks = marks.map(|(a, b)| format!("{a}{b}"));
    let attributes = [("#[", "allow"), ("#![", "allow")].map(|(a, b)| format!("{a}{b}("));
    let mut faults = Vec::new();
    for (path, text) in tree.iter() {
        for (n, line) in lines(text) {
            for mark in marks.iter().filter(|mark| line.contains(mark.as_str())) {
                faults.push(format!("{path}:{n}: `{mark}` is left"));
            }
            if ends_in(path, "rs") && attributes.iter().any(|start| line.trim_start().starts_with(start)) {
                faults.push(format!("{path}:{n}: write `#[expect(lint, reason = \"…\")]`"));
            }
        }
    }
    faults
}

/// Every crate takes the lints of the workspace, among them the one that forbids unsafe code.
pub(super) fn lints_are_those_of_the_workspace(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for (folder, text) in tree.manifests() {
        if !text.contains("[lints]\nworkspace = true\n") {
            faults.push(format!("{folder}/Cargo.toml: write `[lints]` and under it `workspace = true`"));
        }
    }
    if !tree.text("Cargo.toml").is_some_and(|text| text.contains("\nunsafe_code = \"forbid\"\n")) {
        faults.push("Cargo.toml: the lints of the workspace must forbid unsafe code".to_owned());
    }
    faults
}

pub(super) fn a_long_file_says_why(tree: &Tree) -> Vec<String> {
    let long = tree.sources().filter(|(_, text)| text.lines().count() > LONG && !text.contains(REASON));
    long.map(|(path, text)| {
        let count = text.lines().count();
        format!("{path}: {count} lines; split it, or give the reason in a line `{REASON}…`")
    })
    .collect()
}

/// A document that speaks of a file of the tree must speak of one that is there.
pub(super) fn documents_name_what_exists(tree: &Tree) -> Vec<String> {
    const FOLDERS: [&str; 6] = ["crates/", "plugins/", "tests/", "xtask/", "examples/", "docs/"];
    let mut faults = Vec::new();
    for (path, text) in tree.iter().filter(|(path, _)| ends_in(path, "md")) {
        let begun = begun(text);
        for (n, line) in lines(text) {
            for quoted in line.split('`').skip(1).step_by(2) {
                let plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
                let example =
                    quoted.split('/').any(|part| is_placeholder(part) || begun.contains(&stem(part)));
                if FOLDERS.iter().any(|folder| quoted.starts_with(folder))
                    && quoted.chars().all(plain)
                    && is_readable(quoted)
                    && !example
                    && !tree.has(quoted)
                {
                    faults.push(format!("{path}:{n}: there is no {quoted}"));
                }
            }
        }
    }
    faults
}

/// The files that a document begins as an example: `base_excitation` after `new-analysis vibration base-excitation`.
fn begun(text: &str) -> Vec<String> {
    let after = text.split("new-analysis ").skip(1);
    after
        .filter_map(|rest| rest.split_whitespace().nth(1))
        .map(|name| snake(name.trim_end_matches('`')))
        .collect()
}

/// `NAME` in `plugins/NAME/src/lib.rs`.
fn is_placeholder(part: &str) -> bool {
    let stem = stem(part);
    !stem.is_empty() && stem.chars().all(|c| c.is_ascii_uppercase() || c == '_') && stem != "README"
}

fn stem(part: &str) -> String {
    part.split('.').next().unwrap_or_default().to_owned()
}

/// Folders, and files of the kinds that the tree holds.
fn is_readable(path: &str) -> bool {
    let name = path.trim_end_matches('/').rsplit('/').next().unwrap_or_default();
    name.rsplit_once('.').is_none_or(|(_, ending)| super::READ.contains(&ending))
}
