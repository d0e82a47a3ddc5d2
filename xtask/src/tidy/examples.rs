//! Examples in the documentation of the libraries.

use super::{Tree, lines};

/// The libraries that others use too: each of their public modules shows its use.
const LIBRARIES: [&str; 3] = ["crates/mechanics", "crates/numerics", "crates/units"];

/// Words after the opening of a fence with which rustdoc still compiles and runs it.
const RUN: [&str; 3] = ["rust", "should_panic", "standalone_crate"];

pub(super) fn a_public_module_has_an_example_that_runs(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for (library, n, module) in public_modules(tree) {
        let path = format!("{library}/src/{module}.rs");
        if !tree.text(&path).is_some_and(has_example) {
            faults.push(format!(
                "{library}/src/lib.rs:{n}: the module `{module}` has no example that runs and asserts a result; \
                 write one in the `//!` comment of {path}, in a fence without `ignore`, `no_run` or `text`"
            ));
        }
    }
    faults
}

pub(super) fn a_public_module_has_a_topic(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for (library, n, module) in public_modules(tree) {
        let path = format!("{library}/src/lib.rs");
        let link = format!("[`{module}`]");
        let mut table =
            documentation(tree.text(&path).unwrap_or_default()).filter(|line| line.starts_with('|'));
        if !table.any(|row| row.contains(&link)) {
            faults.push(format!(
                "{path}:{n}: the module `{module}` stands under no topic; write {link} in the table of the front page"
            ));
        }
    }
    faults
}

/// The public modules at the root of each library: folder of the library, line and name.
fn public_modules(tree: &Tree) -> impl Iterator<Item = (&'static str, usize, &str)> {
    LIBRARIES.into_iter().flat_map(|library| {
        let text = tree.text(&format!("{library}/src/lib.rs")).unwrap_or_default();
        lines(text).filter_map(move |(n, line)| {
            let rest = line.strip_prefix("pub mod ")?;
            Some((library, n, rest.split([';', ' ', '{']).next().unwrap_or_default()))
        })
    })
}

/// The lines of the documentation of a module.
fn documentation(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| line.strip_prefix("//!")).map(str::trim)
}

/// Returns true if the documentation of a module has a fence that is compiled and run and asserts something.
fn has_example(text: &str) -> bool {
    // True within a fence that runs, false within another one.
    let mut within: Option<bool> = None;
    for line in documentation(text) {
        match (within, line.strip_prefix("```")) {
            (None, Some(words)) => within = Some(runs(words)),
            (Some(_), Some(_)) => within = None,
            (Some(true), None) if line.starts_with("assert") || line.contains(" assert") => return true,
            _ => {}
        }
    }
    false
}

fn runs(words: &str) -> bool {
    words
        .split([',', ' '])
        .filter(|word| !word.is_empty())
        .all(|word| RUN.contains(&word) || word.starts_with("edition"))
}
