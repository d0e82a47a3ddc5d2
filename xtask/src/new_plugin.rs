//! `cargo xtask new-plugin NAME`: a crate for a family of analyses, and its two lines in the bundle.

use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::{
    names::{check_kebab, snake, title},
    new_analysis::{below, families, is_keyword, read, write},
};

const LIBRARY: &str = include_str!("new_plugin/lib.rs");

/// Versions of the crates of the workspace that a crate of it accepts.
const VERSION: &str = concat!(env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));

const MANIFEST: &str = "\
[package]
name = \"dalembert-FAMILY\"
description = \"Analyses: FAMILY.\"
version.workspace = true
edition.workspace = true
rust-version.workspace = true
license.workspace = true
publish.workspace = true

# Tested from outside, so that it is compiled once.
[lib]
test = false
doctest = false

[lints]
workspace = true

[dependencies]
dalembert-core.workspace = true
dalembert-mechanics.workspace = true
";

/// Line of the bundle's manifest by which it depends on a family.
pub fn dependency(family: &str) -> String {
    format!("dalembert-{family} = {{ version = \"{VERSION}\", path = \"../{family}\" }}")
}

/// Writes the crate of a new family.
///
/// # Errors
/// A name that is none or is taken; nothing is written then.
pub fn run(root: &Path, name: &str) -> Result<()> {
    check_kebab(name)?;
    let folder = root.join("plugins").join(name);
    if folder.exists() || families(root)?.iter().any(|family| family == name) {
        bail!("`{name}` is taken: there is {}", below(root, &folder));
    }
    // The crates of the program are named in the same way.
    let crates = ["plugins", "core", "derive", "mechanics", "report", "tests", "tui", "units"];
    if is_keyword(&snake(name)) || crates.contains(&name) {
        bail!("`{name}` cannot name a family; take another word");
    }
    let bundle = root.join("plugins/bundle");
    let manifest = with_line(&read(&bundle.join("Cargo.toml"))?, "dalembert-", &dependency(name))
        .context("plugins/bundle/Cargo.toml has no plugin")?;
    let library = with_line(
        &read(&bundle.join("src/lib.rs"))?,
        "use dalembert_",
        &format!("use dalembert_{} as _;", snake(name)),
    )
    .context("plugins/bundle/src/lib.rs has no plugin")?;
    write(&folder.join("Cargo.toml"), &MANIFEST.replace("FAMILY", name))?;
    write(&folder.join("src/lib.rs"), &LIBRARY.replace("family-title", &title(name).to_lowercase()))?;
    write(&folder.join("locales/pt-BR.ftl"), &format!("# {}\n", title(name)))?;
    write(&bundle.join("Cargo.toml"), &manifest)?;
    write(&bundle.join("src/lib.rs"), &library)?;
    println!("written: {}", below(root, &folder));
    println!("changed: plugins/bundle/Cargo.toml, plugins/bundle/src/lib.rs");
    println!("begin an analysis: cargo xtask new-analysis {name} NAME --topic TOPIC");
    Ok(())
}

/// A text with one more line in its sorted block of lines that begin with `start`.
fn with_line(text: &str, start: &str, line: &str) -> Option<String> {
    let mut lines: Vec<&str> = text.lines().collect();
    let block: Vec<usize> = (0..lines.len()).filter(|n| lines[*n].starts_with(start)).collect();
    let at = block.iter().find(|n| lines[**n] > line).copied().or(block.last().map(|last| last + 1))?;
    lines.insert(at, line);
    Some(lines.join("\n") + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_of_a_plugin_stands_in_its_order() {
        let text = "//! All.\n\nuse dalembert_balancing as _;\nuse dalembert_vibration as _;\n";
        let with = with_line(text, "use dalembert_", "use dalembert_rotors as _;").unwrap();
        assert_eq!(
            with,
            "//! All.\n\nuse dalembert_balancing as _;\nuse dalembert_rotors as _;\nuse dalembert_vibration as _;\n"
        );
        assert!(
            with_line(text, "use dalembert_", "use dalembert_wear as _;").unwrap().ends_with("wear as _;\n")
        );
        assert_eq!(with_line("//! None.\n", "use dalembert_", "x"), None);
    }
}
