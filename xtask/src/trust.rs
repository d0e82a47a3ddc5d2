//! `cargo xtask trust`: trials of reliability, and `docs/trust.md`, which is written from the runs that tried them.
//!
//! A run is recorded in `docs/trust.toml` with what was tried, how often, what failed, the seed, the commit and the
//! command; a record is replaced by the next run of that row alone.

mod mutants;
mod processors;
mod rows;

use std::{fmt::Write as _, fs, path::Path};

use anyhow::{Context, Result, bail, ensure};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use self::rows::{ROWS, Row};
use crate::{cargo::git, fuzz};

const RECORDS: &str = "docs/trust.toml";
const DOCUMENT: &str = "docs/trust.md";
/// Share of a run that `--check` repeats.
const SHARE: u64 = 100;
/// Failures that are recorded in words; their number is recorded whole.
const SHOWN: usize = 12;

/// Result of running a row.
#[derive(Debug, Deserialize)]
struct Outcome {
    tried: u64,
    failed: u64,
    failures: Vec<String>,
    note: String,
}

/// Recorded run.
#[derive(Clone, Debug, Deserialize, Serialize, PartialEq)]
struct Record {
    row: String,
    tried: u64,
    failed: u64,
    seed: u64,
    commit: String,
    date: String,
    command: String,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    note: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    failures: Vec<String>,
}

#[derive(Default, Deserialize, Serialize)]
struct Records {
    #[serde(default)]
    run: Vec<Record>,
}

/// Runs the rows of these names, or all, records what was met, and writes the document. `--seed S` takes other random
/// numbers, `--times N` another size; `--check` repeats a hundredth of each and records nothing; `--list` prints the rows.
///
/// # Errors
/// A row that does not exist, or cannot be run; with `--check`, a failure in a row that is recorded without.
pub fn run(root: &Path, words: &[&str]) -> Result<()> {
    let (mut names, mut seed, mut times, mut checks) = (Vec::new(), 1, None, false);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        let mut number = || {
            let number = words.next().with_context(|| format!("a number is missing behind {word}"))?;
            number.parse::<u64>().with_context(|| format!("{word} {number}: no number"))
        };
        match *word {
            "--list" => {
                for row in &ROWS {
                    println!("{:<20}{}", row.name, row.tried);
                }
                return Ok(());
            }
            "--check" => checks = true,
            "--seed" => seed = number()?,
            "--times" => times = Some(number()?),
            name => names.push(name),
        }
    }
    for row in chosen(&names)? {
        if checks {
            check(root, row)?;
        } else {
            record(root, row, times.unwrap_or(row.times), seed)?;
        }
    }
    Ok(())
}

fn chosen(names: &[&str]) -> Result<Vec<&'static Row>> {
    for name in names {
        ensure!(ROWS.iter().any(|row| row.name == *name), "no row {name:?}; `--list` prints them");
    }
    Ok(ROWS.iter().filter(|row| names.is_empty() || names.contains(&row.name)).collect())
}

fn record(root: &Path, row: &Row, times: u64, seed: u64) -> Result<()> {
    // Before the run, which takes hours: what is committed while it lasts is not what it tries. The records of other rows
    // change no program.
    let tree =
        ["status", "--porcelain", "--untracked-files=no", "--", ".", ":!docs/trust.toml", ":!docs/trust.md"];
    let changed = !git(root, &tree)?.trim().is_empty();
    let commit = git(root, &["rev-parse", "--short=12", "HEAD"])?.trim().to_owned();
    let outcome = (row.run)(root, row, times, seed).with_context(|| row.name)?;
    println!("{}: {} tried, {} failed; {}", row.name, outcome.tried, outcome.failed, outcome.note);
    if outcome.tried == 0 {
        println!("{}: nothing was tried, and nothing is recorded", row.name);
        return Ok(());
    }
    let record = Record {
        row: row.name.to_owned(),
        tried: outcome.tried,
        failed: outcome.failed,
        seed,
        commit: if changed { format!("{commit}, changed") } else { commit },
        date: date(root)?,
        command: format!("cargo xtask trust --seed {seed} --times {times} {}", row.name),
        note: outcome.note,
        failures: outcome.failures.into_iter().take(SHOWN).collect(),
    };
    let mut records = read(root)?;
    records.run.retain(|other| other.row != record.row);
    records.run.push(record);
    let place = |record: &Record| ROWS.iter().position(|row| row.name == record.row);
    records.run.sort_by_key(place);
    fs::write(root.join(RECORDS), toml::to_string_pretty(&records)?)?;
    fs::write(root.join(DOCUMENT), document(&records))?;
    Ok(())
}

/// Date of today, as the system has it.
fn date(root: &Path) -> Result<String> {
    let date =
        crate::cargo::output(std::process::Command::new("date").current_dir(root).args(["-u", "+%Y-%m-%d"]))?;
    Ok(date.trim().to_owned())
}

fn check(root: &Path, row: &Row) -> Result<()> {
    let records = read(root)?;
    let Some(recorded) = records.run.iter().find(|record| record.row == row.name) else {
        println!("{}: never run", row.name);
        return Ok(());
    };
    // Other things than those that were recorded: the share of them that may fail is the same.
    let outcome =
        (row.run)(root, row, row.times.div_ceil(SHARE), recorded.seed + 1).with_context(|| row.name)?;
    println!("{}: {} tried, {} failed; {}", row.name, outcome.tried, outcome.failed, outcome.note);
    if outcome.failed > 0 && recorded.failed == 0 {
        let first = &outcome.failures[..outcome.failures.len().min(SHOWN)];
        bail!("{} failed: {}", row.name, first.join("; "));
    }
    Ok(())
}

fn read(root: &Path) -> Result<Records> {
    match fs::read_to_string(root.join(RECORDS)) {
        Ok(text) => toml::from_str(&text).with_context(|| format!("{RECORDS} cannot be read")),
        Err(_) => Ok(Records::default()),
    }
}

/// Path and text of the document of the records.
pub(crate) fn generated(root: &Path) -> Result<(String, String)> {
    Ok((DOCUMENT.to_owned(), document(&read(root)?)))
}

fn document(records: &Records) -> String {
    let mut text = "\
# What was tried

Written by `cargo xtask trust` from recorded runs (`docs/trust.toml`): each row is what was tried, how often, and how
often it failed; a failure is not dropped, and stands until a run without it takes its place. `cargo xtask trust NAME`
runs a row again, `cargo xtask trust --check` a hundredth of each, with other random numbers.

| row | what was tried | tried | failed | seed | commit | date |
|---|---|---:|---:|---:|---|---|
"
    .to_owned();
    let rows = || {
        ROWS.iter().filter_map(|row| Some((row, records.run.iter().find(|record| record.row == row.name)?)))
    };
    for (row, record) in rows() {
        let Record { tried, failed, seed, commit, date, .. } = record;
        let _ = writeln!(
            text,
            "| [{name}](#{name}) | {} | {} | {} | {seed} | {commit} | {date} |",
            row.tried,
            grouped(*tried),
            grouped(*failed),
            name = row.name
        );
    }
    for (row, record) in rows() {
        let _ = write!(text, "\n## {}\n\n{}.\n\n    {}\n", row.name, row.tried, record.command);
        if !record.note.is_empty() {
            let _ = write!(text, "\n{}.\n", record.note);
        }
        if !record.failures.is_empty() {
            let _ = write!(text, "\nFailed {} times, first:\n\n", grouped(record.failed));
            for failure in &record.failures {
                let _ = writeln!(text, "- `{}`", failure.replace('`', "'").replace('\n', " "));
            }
        }
    }
    let missing: Vec<&str> = ROWS
        .iter()
        .map(|row| row.name)
        .filter(|name| records.run.iter().all(|record| record.row != *name))
        .collect();
    if !missing.is_empty() {
        let _ = write!(text, "\n## Never run\n\n{}.\n", missing.join(", "));
    }
    text
}

/// A number with its thousands apart: `12 345`.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let first = digits.len() % 3;
    let mut text = digits[..first].to_owned();
    for group in digits.as_bytes()[first..].chunks(3) {
        if !text.is_empty() {
            text.push(' ');
        }
        text += &String::from_utf8_lossy(group);
    }
    text
}

/// Things in an order that their names and a seed alone decide: that of the SHA-256 of both.
fn shuffled(mut names: Vec<String>, seed: u64) -> Vec<String> {
    names.sort_by_cached_key(|name| <[u8; 32]>::from(Sha256::digest(format!("{seed} {name}"))));
    names
}

/// A search of libFuzzer as the outcome of a row.
fn searched(root: &Path, target: &str, executions: u64, seed: u64) -> Result<Outcome> {
    let program = fuzz::built(root)?;
    let search = fuzz::search(root, &program, target, executions, seed)?;
    let late = search.last_new > search.executions / 4 * 3;
    let note = fuzz::described(&search) + if late { ": in the last quarter" } else { "" };
    let failures: Vec<String> = search.fault.into_iter().collect();
    Ok(Outcome { tried: search.executions, failed: failures.len() as u64, failures, note })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_of_its_records() {
        assert_eq!([0, 12, 999, 1000, 1_234_567].map(grouped), ["0", "12", "999", "1 000", "1 234 567"]);
        let record = Record {
            row: ROWS[0].name.to_owned(),
            tried: 12_345,
            failed: 1,
            seed: 7,
            commit: "abc".to_owned(),
            date: "2026-01-02".to_owned(),
            command: "cargo".to_owned(),
            note: "a note".to_owned(),
            failures: vec!["`x` fails".to_owned()],
        };
        let records = Records { run: vec![record] };
        let again: Records = toml::from_str(&toml::to_string_pretty(&records).unwrap()).unwrap();
        assert_eq!(again.run, records.run);
        let text = document(&records);
        assert!(text.contains("| 12 345 | 1 | 7 | abc |") && text.contains("- `'x' fails`"), "{text}");
        assert!(text.contains("## Never run") && text.contains(ROWS[1].name), "{text}");
    }

    #[test]
    fn rows_have_names_of_their_own() {
        assert!(ROWS.len() >= 20, "{} rows", ROWS.len());
        for (place, row) in ROWS.iter().enumerate() {
            assert!(ROWS[..place].iter().all(|other| other.name != row.name), "{} is there twice", row.name);
            assert!(row.times > 0 && !row.tried.ends_with('.'), "{}", row.name);
        }
    }
}
