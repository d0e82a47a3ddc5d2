//! The index of decisions: a line for each file of docs/decisions, by date.

use std::{fs, path::Path};

use anyhow::{Context, Result, ensure};

/// The folder of decisions.
const FOLDER: &str = "docs/decisions";

const HEAD: &str = "# Decisions\n\nWhy a part is as it is, by the date on which it was decided. A new decision is a file \
                    `YYYY-MM-DD-its-title.md` whose first line is its title; `cargo xtask docs` enters it here.\n\n";

/// Path and text of the index.
///
/// # Errors
/// A file whose name does not begin with a date or is not the title's, or that has no title.
pub(super) fn index(root: &Path) -> Result<(String, String)> {
    let mut entries = Vec::new();
    for entry in fs::read_dir(root.join(FOLDER)).with_context(|| format!("{FOLDER} cannot be read"))? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if name == "README.md" {
            continue;
        }
        let text = fs::read_to_string(root.join(FOLDER).join(&name))?;
        let title = text.lines().next().and_then(|line| line.strip_prefix("# "));
        let title = title.with_context(|| format!("{FOLDER}/{name}: the first line is no title, `# …`"))?;
        let date = name.get(..10).filter(|date| is_date(date));
        let date = date.with_context(|| format!("{FOLDER}/{name}: the name begins with no date"))?;
        let expected = format!("{date}-{}.md", slug(title));
        ensure!(name == expected, "{FOLDER}/{name}: its title asks for the name {expected}");
        entries.push(format!("- {date} [{title}]({name})\n"));
    }
    entries.sort();
    Ok((format!("{FOLDER}/README.md"), format!("{}{HEAD}{}", super::BEGIN, entries.concat())))
}

/// Returns true for digits in the form of 2026-11-29.
fn is_date(text: &str) -> bool {
    let form = |(at, c): (usize, char)| if matches!(at, 4 | 7) { c == '-' } else { c.is_ascii_digit() };
    text.chars().enumerate().all(form)
}

/// Words of a title in lower case, joined by hyphens.
fn slug(title: &str) -> String {
    let plain = title.to_lowercase().replace(['`', '\''], "");
    let words = plain.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_of_a_file_is_that_of_its_title() {
        assert_eq!(
            slug("Check `sheet.verify(|| …)` by Gauss's method"),
            "check-sheet-verify-by-gausss-method"
        );
        assert!(is_date("2026-11-29"));
        assert!(!is_date("2026-1-129"));
    }
}
