//! `cargo xtask dialects`: files as other programs write them, read by the built program.
//!
//! `tests/data/dialects/expected.toml` has for each file, and for parts of some, the numbers that stand in it or the words
//! of its refusal. A file counts as right if the program read just these numbers, with these assumed units.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use serde_json::Value as Json;

use crate::cargo::{Program, run as run_command};

/// Folder of the files.
const FOLDER: &str = "tests/data/dialects";
/// Permitted difference of a number, by the largest of its column, where the file has no other.
const WITHIN: f64 = 1e-12;
/// A number of so many characters in an error is taken for one of the file's.
const LONG: usize = 4;

/// Expected readings of the files.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Expected {
    truth: BTreeMap<String, Truth>,
    file: Vec<Entry>,
}

/// Numbers of a table, in SI.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Truth {
    analysis: String,
    table: String,
    rows: Vec<[f64; 2]>,
}

/// Expected reading of a file or a part of it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: String,
    /// Program that writes such files.
    program: String,
    /// Part behind `#`.
    part: Option<String>,
    #[serde(default = "decay")]
    truth: String,
    within: Option<f64>,
    /// Units that no heading names.
    #[serde(default)]
    assumed: Vec<String>,
    /// Words of the refusal.
    refused: Option<Vec<String>>,
    /// Feature without which the program refuses the file.
    needs: Option<String>,
}

fn decay() -> String {
    "decay".to_owned()
}

/// Outcome of a reading.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The numbers of the file.
    Right,
    /// Refused with the repair, as it is to be.
    Refused,
    /// Another refusal, or one that prints more of the file than a cell.
    Amiss(String),
    /// Other numbers or units than those of the file.
    Wrong(String),
}

/// A reading of a file.
#[derive(Clone, Debug)]
pub struct Reading {
    /// File and part: `run.csv#1,3`.
    pub file: String,
    /// Program that writes such files.
    pub program: String,
    /// Outcome.
    pub outcome: Outcome,
    /// Errors that the program printed in place of an answer.
    pub said: String,
}

/// Reads every file by the program that `program` makes a command of, which has these features.
///
/// # Errors
/// Files that are not there, or a program that cannot be run.
pub fn readings(root: &Path, program: &dyn Fn() -> Command, features: &[&str]) -> Result<Vec<Reading>> {
    let folder = root.join(FOLDER);
    let text = fs::read_to_string(folder.join("expected.toml")).context("expected.toml cannot be read")?;
    let expected: Expected = toml::from_str(&text)?;
    expected
        .file
        .iter()
        .map(|entry| {
            let truth = expected.truth.get(&entry.truth).context("a truth that there is not")?;
            reading(&folder, entry, truth, program(), features)
        })
        .collect()
}

fn reading(
    folder: &Path,
    entry: &Entry,
    truth: &Truth,
    program: Command,
    features: &[&str],
) -> Result<Reading> {
    let mut program = program;
    let part = entry.part.as_ref().map(|part| format!("#{part}")).unwrap_or_default();
    let path = folder.join(&entry.name);
    ensure!(path.is_file(), "{} is not there", path.display());
    let set = format!("{}=@{}{part}", truth.table, path.display());
    let output = program.args(["solve", &truth.analysis, "--format", "json", "--set", &set]).output()?;
    let printed = String::from_utf8_lossy(&output.stdout);
    let read = serde_json::from_str::<Json>(&printed).ok();
    let errors = read.as_ref().and_then(|read| read["errors"].as_array());
    let messages = errors.into_iter().flatten().filter_map(|error| error["message"].as_str());
    let said = messages.collect::<Vec<_>>().join("\n").replace(&*path.to_string_lossy(), &entry.name);
    let table = read.as_ref().and_then(|read| read["inputs"][&truth.table]["si"].as_array());
    let is_without = entry.needs.as_deref().is_some_and(|feature| !features.contains(&feature));
    let outcome = match (table, &entry.refused) {
        (None, _) if is_without && said.contains("is built without") => Outcome::Refused,
        (None, Some(words)) => match words.iter().find(|word| !said.contains(*word)) {
            Some(word) => Outcome::Amiss(format!("refused without `{word}`")),
            None => shows_one_cell(&path, &said)?,
        },
        (None, None) => Outcome::Amiss("refused".to_owned()),
        (Some(_), Some(_)) => Outcome::Wrong("read, and is to be refused".to_owned()),
        (Some(rows), None) => {
            compared(rows, read.as_ref().map_or(&Json::Null, |read| &read["warnings"]), entry, truth)
        }
    };
    Ok(Reading { file: entry.name.clone() + &part, program: entry.program.clone(), outcome, said })
}

/// Compares rows and warnings with what stands in the file.
fn compared(rows: &[Json], warnings: &Json, entry: &Entry, truth: &Truth) -> Outcome {
    let wrong = |why: String| Outcome::Wrong(why);
    if rows.len() != truth.rows.len() {
        return wrong(format!("{} rows in place of {}", rows.len(), truth.rows.len()));
    }
    for column in 0..2 {
        let largest = truth.rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        for (n, (row, wanted)) in rows.iter().zip(&truth.rows).enumerate() {
            let found = row[column].as_f64().unwrap_or(f64::NAN);
            let difference = (found - wanted[column]).abs();
            if difference.is_nan() || difference > entry.within.unwrap_or(WITHIN) * largest {
                return wrong(format!("row {}: {found} in place of {}", n + 1, wanted[column]));
            }
        }
    }
    let mark = "no unit in the heading; ";
    let all = warnings.as_array().map_or(&[][..], Vec::as_slice);
    let assumed = all.iter().filter_map(Json::as_str).find_map(|warning| warning.split_once(mark));
    let assumed = assumed.map_or("", |(_, units)| units.trim_end_matches(" assumed"));
    if assumed == entry.assumed.join(", ") {
        Outcome::Right
    } else {
        wrong(format!("assumed `{assumed}` in place of `{}`", entry.assumed.join(", ")))
    }
}

/// A refusal prints no line of the file, and of its numbers one.
fn shows_one_cell(path: &Path, said: &str) -> Result<Outcome> {
    let text = String::from_utf8_lossy(&fs::read(path)?).into_owned();
    let parts = |text: &str| -> Vec<String> {
        let is_between = |c: char| c.is_whitespace() || ";\"'`#(){}:/".contains(c);
        text.split(is_between).map(|cell| cell.trim_matches([',', '.']).to_owned()).collect()
    };
    let of_file: Vec<String> =
        text.lines().flat_map(|line| [parts(line), parts(&line.replace(',', " "))].concat()).collect();
    let is_number = |cell: &&String| cell.len() >= LONG && cell.contains(|c: char| c.is_ascii_digit());
    let mut shown: Vec<String> =
        parts(said).iter().filter(is_number).filter(|cell| of_file.contains(cell)).cloned().collect();
    shown.sort();
    shown.dedup();
    let line = text.lines().map(str::trim).find(|line| line.len() > 2 * LONG && said.contains(*line));
    Ok(match line {
        Some(line) if parts(line).len() > 1 => {
            Outcome::Amiss(format!("the refusal prints the line {line:?}"))
        }
        _ if shown.len() > 1 => Outcome::Amiss(format!("the refusal prints {shown:?}")),
        _ => Outcome::Refused,
    })
}

/// Reads every file, and prints what is not as it is to be, and the counts. With `--make` the files are made before.
///
/// # Errors
/// A file that is read wrong, or refused in other words.
pub fn run(root: &Path, words: &[&str]) -> Result<()> {
    if words.contains(&"--make") {
        let script: PathBuf = root.join(FOLDER).join("make.py");
        run_command(Command::new("python3").arg(script))
            .context("it needs Python and the packages that make.py names")?;
    }
    let program = Program::built(root, root)?;
    let all = readings(root, &|| program.with(&[]), &[])?;
    for reading in &all {
        let (mark, why) = match &reading.outcome {
            Outcome::Right => ("read   ", ""),
            Outcome::Refused => ("refused", ""),
            Outcome::Amiss(why) => ("AMISS  ", why.as_str()),
            Outcome::Wrong(why) => ("WRONG  ", why.as_str()),
        };
        let is_shown = !why.is_empty() || words.contains(&"--all");
        println!("{mark}  {:32}  {}", reading.file, reading.program);
        if is_shown {
            println!("         {why}\n         {}", reading.said);
        }
    }
    let count = |is: fn(&Outcome) -> bool| all.iter().filter(|reading| is(&reading.outcome)).count();
    let files: std::collections::BTreeSet<&str> =
        all.iter().map(|reading| reading.file.split('#').next().unwrap_or_default()).collect();
    let amiss = count(|outcome| matches!(outcome, Outcome::Amiss(_)));
    let wrong = count(|outcome| matches!(outcome, Outcome::Wrong(_)));
    println!("\n{} files, {} readings", files.len(), all.len());
    println!("read right      {:4}", count(|outcome| *outcome == Outcome::Right));
    println!("refused         {:4}", count(|outcome| *outcome == Outcome::Refused));
    println!("refused amiss   {amiss:4}");
    println!("silently wrong  {wrong:4}");
    ensure!(amiss + wrong == 0, "{} readings are not as they are to be", amiss + wrong);
    Ok(())
}
