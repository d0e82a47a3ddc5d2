//! Comparison of what the pages compute with what the program computes, and what they say to wrong inputs.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use anyhow::Result;
use serde_json::{Value as Json, json};

use super::{WIDTHS, script};
use crate::{
    cargo::Program,
    docs::{array, text},
    handbook::{solver::SCRIPT, words::Words},
};

/// Largest size of the script as it is downloaded, compressed by gzip: 4 MB.
const LARGEST: u64 = 4_000_000;

/// Answers that are rounding alone, and so have other digits where the last bits of sines are others: problem and answer. The
/// masses of this exam question are those with which the forces cancel; what is left of the force, and the direction of a
/// counterweight that has no mass, are rounding.
const ROUNDING: [[&str; 2]; 2] = [
    ["exam/counterweights-of-a-four-bar", "balanced.shaking_force"],
    ["exam/counterweights-of-a-four-bar", "balanced.crank_angle"],
];

/// Solves the problem file of every case in a browser and by the program, and prints how they compare; the faults.
///
/// An answer is the same if it is printed with the same characters. Of the last bits of its number, which elementary
/// functions of the machine decide, those that differ are counted.
pub(super) fn compared(
    program: &Program,
    browser: &str,
    folder: &Path,
    pages: &BTreeMap<String, String>,
) -> Result<Vec<String>> {
    let files = |language: &str| {
        let of_language = pages.iter().filter(|(page, text)| {
            page.starts_with(&format!("{language}/")) && text.contains("id=\"problem-file\"")
        });
        let files = of_language.map(|(page, _)| folder.join(page).with_extension("toml"));
        files.collect::<Vec<PathBuf>>()
    };
    let languages = Words::ALL.map(|words| (words.language, files(words.language)));
    let cases: usize = languages.iter().map(|(_, files)| files.len()).sum();
    let request = json!({
        "browser": browser,
        "program": program.path(),
        "script": folder.join(SCRIPT),
        "languages": languages.map(|(language, files)| json!({ "language": language, "files": files })),
        "rounding": ROUNDING,
        "widths": WIDTHS,
    });
    let reply = script("solver", &[], &request)?;
    let mut faults = Vec::new();
    let size = |key: &str| reply["sizes"][key].as_u64().unwrap_or(u64::MAX);
    let megabytes = |key: &str| size(key) as f64 / 1e6;
    println!(
        "solver: {SCRIPT} has {:.2} MB, downloaded as {:.2} MB by gzip, {:.2} MB by brotli",
        megabytes("file"),
        megabytes("gzip"),
        megabytes("brotli")
    );
    if size("gzip") > LARGEST {
        faults.push(format!("{SCRIPT} is downloaded as more than {} MB", LARGEST / 1_000_000));
    }
    let mut solved = 0;
    for found in array(&reply["found"]) {
        let count = |key: &str| found[key].as_u64().unwrap_or_default();
        solved += count("count") as usize;
        println!(
            "solver, {}: {} problem files in {:.0} s: the printed answers of {} are the program's, all bytes of the \
             result of {} (worked solutions of {}); {} numbers of answers differ in their last bits, by {:.1e} at most ({})",
            text(found, "language"),
            count("count"),
            found["seconds"].as_f64().unwrap_or_default(),
            count("shown"),
            count("same"),
            count("papers"),
            count("off"),
            found["most"].as_f64().unwrap_or_default(),
            text(found, "where"),
        );
        faults.extend(array(&found["faults"]).iter().filter_map(Json::as_str).map(str::to_owned));
    }
    println!("solver: {} answers that are rounding alone are left out", ROUNDING.len());
    if solved < cases {
        faults.push(format!("the pages have solved {solved} of {cases} problem files"));
    }
    for shown in array(&reply["shown"]) {
        faults.extend(of_typing(shown));
    }
    Ok(faults)
}

/// Faults of a page in which wrong inputs were typed.
fn of_typing(shown: &Json) -> Vec<String> {
    let page = text(shown, "page");
    let mut faults: Vec<String> = array(&shown["wide"])
        .iter()
        .map(|wide| format!("{page}: {} px wide at {} px while it solves", wide["is"], wide["at"]))
        .collect();
    let errors: Vec<&str> = array(&shown["errors"]).iter().filter_map(Json::as_str).collect();
    let [unit, missing] = errors[..] else { return vec![format!("{page}: says nothing to wrong inputs")] };
    if !unit.contains("furlongz") {
        faults.push(format!("{page}: does not name a wrong unit: {unit:?}"));
    }
    if missing.is_empty() {
        faults.push(format!("{page}: does not name a missing value"));
    }
    if !text(shown, "repaired").is_empty() || shown["answers"].as_u64().is_none_or(|count| count == 0) {
        faults.push(format!("{page}: has no answers when its inputs are right again"));
    }
    println!("solver: {page} says to a wrong unit {unit:?}, to a missing value {missing:?}");
    faults
}
