//! `cargo xtask words`: carries translations over to sentences that were reworded.
//!
//! A translation is found by the words of its English sentence, so a new wording has none. What the working tree
//! changed against a commit says which wording it replaced: in each hunk the sentences without a translation are
//! paired with those that are gone, in their order. The Portuguese stays as it was, for a person to read beside the
//! new English.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    process::Stdio,
};

use anyhow::{Context, Result, bail};

use crate::{
    cargo::{cargo, git},
    new_analysis::{read, translation_files, write},
};

/// Carries over what was reworded since `base`, prints each sentence with its Portuguese, and names what is left.
///
/// # Errors
/// Sentences that have no translation still; what could be carried over is, even so.
pub fn run(root: &Path, base: &str) -> Result<()> {
    let missing = missing(root)?;
    let diff =
        git(root, &["diff", "--unified=0", "--no-color", "--no-ext-diff", base, "--", "*.rs", "*.toml"])?;
    let hunks = hunks(&diff);
    let mut files = BTreeMap::new();
    for folder in ["crates", "plugins"] {
        for path in translation_files(&root.join(folder))? {
            files.insert(path.clone(), read(&path)?);
        }
    }
    let used = sources(root)?;
    let left = carried(&missing, &hunks, &mut files, &|key| used.contains(&bounded(key)));
    for (path, text) in &files {
        write(path, text)?;
    }
    if left.is_empty() {
        return Ok(());
    }
    bail!("{} sentences have to be translated:\n{}", left.len(), left.join("\n"))
}

/// A sentence without a translation: its key and the sentence.
struct Missing {
    key: String,
    sentence: String,
}

/// A change: the words that were taken out and those that were put in, each as [`slug`] writes them.
#[derive(Debug, PartialEq)]
struct Hunk {
    removed: String,
    added: String,
}

/// Missing translations reported by the test of languages, as `[crate] key = sentence`.
fn missing(root: &Path) -> Result<Vec<Missing>> {
    let test = cargo(root)
        .args(["test", "--quiet", "--package", "dalembert-tests", "--test", "registry"])
        .args(["--", "languages::every_sentence_has_its_portuguese"])
        .env("RUST_BACKTRACE", "0")
        .stderr(Stdio::inherit())
        .output()
        .context("the test of languages cannot be run")?;
    let text = String::from_utf8(test.stdout).context("the test of languages does not print UTF-8")?;
    let found: Vec<Missing> = text.lines().filter_map(Missing::read).collect();
    if found.is_empty() && !test.status.success() {
        bail!("the test of languages could not be run to its end:\n{text}");
    }
    Ok(found)
}

impl Missing {
    fn read(line: &str) -> Option<Self> {
        let (_, message) = line.strip_prefix('[')?.split_once("] ")?;
        let (key, sentence) = message.split_once(" = ")?;
        Some(Self { key: key.to_owned(), sentence: sentence.to_owned() })
    }
}

/// Puts the translations of reworded sentences under their new keys; the sentences that are left without one.
fn carried(
    missing: &[Missing],
    hunks: &[Hunk],
    files: &mut BTreeMap<PathBuf, String>,
    is_used: &dyn Fn(&str) -> bool,
) -> Vec<String> {
    let keys: Vec<String> =
        files.values().flat_map(|text| text.lines()).filter_map(key_of).map(str::to_owned).collect();
    let mut done: BTreeMap<&str, String> = BTreeMap::new();
    for hunk in hunks {
        let mut new: Vec<(usize, &Missing)> =
            missing.iter().filter_map(|one| Some((hunk.added.find(&bounded(&one.key))?, one))).collect();
        let mut old: Vec<(usize, &String)> = keys
            .iter()
            .filter(|key| !hunk.added.contains(&bounded(key)))
            .filter_map(|key| Some((hunk.removed.find(&bounded(key))?, key)))
            .collect();
        new.sort_by_key(|(at, _)| *at);
        // Where one key begins another, the longer one is the sentence.
        old.sort_by_key(|(at, key)| (*at, std::cmp::Reverse(key.len())));
        old.dedup_by_key(|(at, _)| *at);
        let mut end = 0;
        old.retain(|(at, key)| {
            let is_apart = *at >= end;
            if is_apart {
                // The hyphen behind a key is the one before the next.
                end = at + bounded(key).len() - 1;
            }
            is_apart
        });
        if new.len() == old.len() {
            for ((_, new), (_, old)) in new.iter().zip(&old) {
                done.entry(new.key.as_str()).or_insert_with(|| (*old).clone());
            }
        }
    }
    let mut left = Vec::new();
    for Missing { key, sentence } in missing {
        let Some(old) = done.get(key.as_str()) else {
            left.push(format!("{key} = {sentence}"));
            continue;
        };
        for text in files.values_mut() {
            let Some(at) = text.lines().position(|line| key_of(line) == Some(old)) else { continue };
            let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
            let words = lines[at].split_once(" = ").map_or("", |(_, words)| words).to_owned();
            println!("{old}\n  {sentence}\n  {words}\n");
            let line = format!("{key} = {words}");
            if is_used(old) {
                lines.insert(at, line);
            } else {
                lines[at] = line;
            }
            *text = lines.join("\n") + "\n";
        }
    }
    left
}

/// The key of a line that begins a message.
fn key_of(line: &str) -> Option<&str> {
    line.split_once(" = ").map(|(key, _)| key).filter(|key| !key.starts_with([' ', '#']))
}

/// The hunks of a diff without context.
fn hunks(diff: &str) -> Vec<Hunk> {
    let mut found: Vec<[String; 2]> = Vec::new();
    for line in diff.lines() {
        if line.starts_with("@@") {
            found.push([String::new(), String::new()]);
        } else if let (Some(last), false) =
            (found.last_mut(), line.starts_with("---") || line.starts_with("+++"))
        {
            let side = if line.starts_with('-') { &mut last[0] } else { &mut last[1] };
            *side += line.get(1..).unwrap_or_default();
            side.push('\n');
        }
    }
    found.into_iter().map(|[removed, added]| Hunk { removed: slug(&removed), added: slug(&added) }).collect()
}

/// The words of a text in lower case, each between hyphens: a key is found in it with [`bounded`].
fn slug(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.fold("-".to_owned(), |slug, word| slug + &word.to_ascii_lowercase() + "-")
}

/// A key between hyphens, without the letter that stands before a number.
fn bounded(key: &str) -> String {
    let words = key.strip_prefix("n-").filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    format!("-{}-", words.unwrap_or(key))
}

/// The words of all sources and cases.
fn sources(root: &Path) -> Result<String> {
    let listed = git(root, &["ls-files", "crates", "plugins"])?;
    let wanted = |path: &&str| {
        Path::new(path).extension().is_some_and(|have| have == "rs") || path.contains("/cases/")
    };
    let texts = listed.lines().filter(wanted).map(|path| read(&root.join(path)));
    Ok(slug(&texts.collect::<Result<Vec<_>>>()?.join("\n")))
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIFF: &str = "\
--- a/plugins/vibration/src/a.rs
+++ b/plugins/vibration/src/a.rs
@@ -3 +3 @@ fn solve
-        sheet.answer(\"x\", \"Greatest speed\", fast);
+        sheet.answer(\"x\", \"Maximum speed of the {body}\", fast);
@@ -9,2 +9,2 @@
-    /// 2 planes are given.
-    /// Left side.
+    /// 2 correction planes are given.
+    /// Left-hand side.
@@ -20,0 +20 @@
+    /// A new sentence.
";

    fn missing(key: &str, sentence: &str) -> Missing {
        Missing { key: key.to_owned(), sentence: sentence.to_owned() }
    }

    #[test]
    fn a_translation_follows_its_sentence() {
        let path = PathBuf::from("pt-BR.ftl");
        let text = "greatest-speed = Maior velocidade\n    .flywheel = Maior rotação\nmass = Massa\n\
                    n-2-planes-are-given = Dois planos\nleft-side = Lado esquerdo\n";
        let wanted = [
            missing("maximum-speed-of-the-body", "Maximum speed of the {body}"),
            missing("n-2-correction-planes-are-given", "2 correction planes are given"),
            missing("left-hand-side", "Left-hand side"),
            missing("a-new-sentence", "A new sentence"),
        ];
        let mut files = BTreeMap::from([(path.clone(), text.to_owned())]);
        let left = carried(&wanted, &hunks(DIFF), &mut files, &|key| key == "left-side");
        assert_eq!(left, ["a-new-sentence = A new sentence"]);
        assert_eq!(
            files[&path],
            "maximum-speed-of-the-body = Maior velocidade\n    .flywheel = Maior rotação\nmass = Massa\n\
             n-2-correction-planes-are-given = Dois planos\nleft-hand-side = Lado esquerdo\n\
             left-side = Lado esquerdo\n"
        );
    }

    #[test]
    fn what_the_test_prints_is_read() {
        let read = Missing::read("[vibration] mass-of-body = Mass of {body}").unwrap();
        assert_eq!((read.key.as_str(), read.sentence.as_str()), ("mass-of-body", "Mass of {body}"));
        assert!(Missing::read("test result: ok").is_none());
    }
}
