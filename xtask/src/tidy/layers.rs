//! Dependencies permitted to each crate.

use super::{Tree, ends_in, lines, without_tests};

/// A crate and those of this workspace that it may depend on, by folder, without tests.
const BELOW: [(&str, &[&str]); 18] = [
    ("crates/units", &[]),
    ("crates/numerics", &[]),
    ("crates/mechanics", &["numerics"]),
    ("crates/derive", &[]),
    ("crates/core", &["derive", "numerics", "units"]),
    ("crates/import", &["core"]),
    ("crates/report", &["core", "numerics", "units"]),
    ("crates/teaching", &["core", "numerics", "report", "units"]),
    ("crates/terminal", &[]),
    ("crates/study", &["core", "import", "numerics"]),
    ("crates/plot", &["core", "report", "terminal", "units"]),
    ("crates/tui", &["core", "import", "plot", "report", "study", "terminal", "units"]),
    (
        "crates/dalembert",
        &["core", "import", "mechanics", "plugins", "report", "study", "teaching", "tui", "units"],
    ),
    ("crates/web", &["core", "plugins", "report"]),
    ("plugins/*", &["core", "mechanics", "numerics", "units"]),
    ("crates/testkit", &["core", "mechanics", "numerics", "plot", "report", "terminal", "units"]),
    (
        "tests",
        &[
            "",
            "core",
            "import",
            "mechanics",
            "numerics",
            "plugins",
            "report",
            "study",
            "teaching",
            "testkit",
            "tui",
            "units",
            "web",
        ],
    ),
    ("xtask", &["units"]),
];

/// All that an analysis may use from outside the workspace: what its vectors are made of.
const OF_A_PLUGIN: [&str; 1] = ["nalgebra"];

/// Modules of `std` that a pure crate does without.
const EFFECTS: [&str; 4] = ["fs", "net", "process", "env"];

/// The crates that do no input or output.
const PURE: [&str; 10] = [
    "crates/units/src/",
    "crates/numerics/src/",
    "crates/mechanics/src/",
    "crates/core/src/",
    "crates/import/src/",
    "crates/report/src/",
    "crates/teaching/src/",
    "crates/plot/src/",
    "crates/web/src/",
    "plugins/",
];

pub(super) fn a_plugin_is_named_only_by_the_bundle(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for family in tree.families() {
        let names = [format!("dalembert-{family}"), format!("dalembert_{}", family.replace('-', "_"))];
        let own = format!("plugins/{family}/");
        let others = tree.iter().filter(|(path, _)| {
            (ends_in(path, "rs") || path.ends_with("Cargo.toml"))
                && !path.starts_with(&own)
                && !path.starts_with("plugins/bundle/")
                && !is_of_tests(path)
        });
        for (path, text) in others {
            for (n, line) in lines(without_tests(text)) {
                // A profile says how a crate is compiled, whatever it holds.
                let is_profile = path.ends_with("Cargo.toml") && line.starts_with("[profile.");
                if !is_profile && names.iter().any(|name| has_word(line, name)) {
                    faults.push(format!(
                        "{path}:{n}: names a plugin; only plugins/bundle may, the registry is for all others"
                    ));
                }
            }
        }
    }
    faults
}

pub(super) fn a_crate_depends_only_on_what_lies_below(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for (folder, text) in tree.manifests().filter(|(folder, _)| *folder != "plugins/bundle") {
        let known = BELOW.iter().find(|(pattern, _)| match pattern.strip_suffix('*') {
            Some(start) => folder.starts_with(start),
            None => folder == *pattern,
        });
        let path = format!("{folder}/Cargo.toml");
        let Some((_, below)) = known else {
            faults.push(format!("{path}: say in xtask/src/tidy/layers.rs what this crate may depend on"));
            continue;
        };
        for (n, dependency) in dependencies(text) {
            let inside = dependency.strip_prefix("dalembert").map(|rest| rest.trim_start_matches('-'));
            let allowed = match inside {
                Some(inside) => below.contains(&inside),
                None => !folder.starts_with("plugins/") || OF_A_PLUGIN.contains(&dependency),
            };
            if !allowed {
                faults.push(format!("{path}:{n}: may not depend on {dependency}"));
            }
        }
    }
    faults
}

pub(super) fn pure_crates_do_no_input_or_output(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for (path, text) in tree.sources().filter(|(path, _)| !is_of_tests(path)) {
        let pure = PURE.iter().any(|start| path.starts_with(start));
        let code = without_tests(text);
        for (n, part) in of_std(code) {
            if part == "net" || (pure && EFFECTS.contains(&part)) {
                faults.push(format!("{path}:{n}: std::{part} has no place here"));
            }
        }
        for (n, line) in lines(code).filter(|(_, line)| pure && !line.trim_start().starts_with("//")) {
            for call in ["print!", "println!", "eprint!", "eprintln!"] {
                if has_word(line, call) {
                    faults.push(format!("{path}:{n}: {call} has no place here; return what is to be shown"));
                }
            }
        }
    }
    faults
}

/// Returns true if a source is a module of unit tests.
fn is_of_tests(path: &str) -> bool {
    path.ends_with("/tests.rs")
}

/// The dependencies of a manifest, without those of tests, and the lines they stand in.
fn dependencies(manifest: &str) -> Vec<(usize, &str)> {
    let mut inside = false;
    let mut found = Vec::new();
    for (n, line) in lines(manifest) {
        if let Some(section) = line.strip_prefix('[') {
            let section = section.trim_end_matches(']');
            inside = section == "dependencies" || section.ends_with(".dependencies");
        } else if inside && line.starts_with(|c: char| c.is_ascii_alphabetic()) {
            let end = line.find(['.', ' ', '=']).unwrap_or(line.len());
            found.push((n, &line[..end]));
        }
    }
    found
}

/// The parts of `std` that code uses: `fs` in `std::fs::read` and in `use std::{env, fs}`.
fn of_std(code: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    for (at, name) in code.match_indices("std::") {
        let inside_of_a_word = code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let line = code[..at].lines().count().max(1);
        let in_a_comment =
            code[..at].lines().next_back().is_some_and(|line| line.trim_start().starts_with("//"));
        if inside_of_a_word || in_a_comment {
            continue;
        }
        let rest = &code[at + name.len()..];
        let Some(list) = rest.strip_prefix('{') else {
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
            found.push((line, &rest[..end]));
            continue;
        };
        // The first word of each item of the list, of no list inside it.
        let (mut depth, mut start) = (0, Some(0));
        for (at, c) in list.char_indices() {
            let ends = !c.is_alphanumeric() && c != '_' && !c.is_whitespace();
            if let (true, Some(from)) = (ends, start) {
                found.push((line, list[from..at].trim()));
                start = None;
            }
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => start = Some(at + 1),
                _ => {}
            }
        }
    }
    found
}

/// Returns true if `word` is in the line and is no part of a longer word.
fn has_word(line: &str, word: &str) -> bool {
    let letter = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    line.match_indices(word)
        .any(|(at, _)| !line[..at].ends_with(letter) && !line[at + word.len()..].starts_with(letter))
}
