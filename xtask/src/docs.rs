//! `cargo xtask docs`: the reference in docs/, written from what the built program says of itself.

use std::{collections::BTreeMap, fs, path::Path};

use anyhow::{Context, Result, bail};
use serde_json::Value as Json;

use crate::{
    cargo::{self, Program},
    names::title,
    new_analysis::write as write_file,
};

mod inputs;

/// Form of a problem file, for those who read the reference alone.
const PROBLEM_FILES: &str = include_str!("docs/problem_files.md");

const BEGIN: &str = "<!-- Written by `cargo xtask docs`. -->\n";

/// Writes docs/reference.md and docs/units.md.
pub fn write(root: &Path) -> Result<()> {
    for (path, text) in generated(root)? {
        write_file(&root.join(&path), &text)?;
        println!("written: {path}");
    }
    Ok(())
}

/// Sees that what [`write()`] would write is there already.
pub fn check(root: &Path) -> Result<()> {
    let stale: Vec<String> = generated(root)?
        .into_iter()
        .filter(|(path, text)| fs::read_to_string(root.join(path)).ok().as_ref() != Some(text))
        .map(|(path, _)| path)
        .collect();
    if stale.is_empty() {
        return Ok(());
    }
    bail!("out of date: {}; run `cargo xtask docs`", stale.join(", "))
}

/// The generated files: path and text.
fn generated(root: &Path) -> Result<Vec<(String, String)>> {
    let program = Program::built(root, root)?;
    let listed = json(&program, &["list", "--json"])?;
    let verdicts = verdicts(&json(&program, &["verify", "--json"])?);
    let mut families: BTreeMap<String, Vec<Json>> = BTreeMap::new();
    let (exams, analyses): (Vec<&Json>, Vec<&Json>) =
        array(&listed).iter().partition(|entry| text(entry, "family") == "exam");
    for analysis in analyses {
        let id = text(analysis, "id");
        families
            .entry(text(analysis, "family").to_owned())
            .or_default()
            .push(json(&program, &["show", id, "--json"])?);
    }
    let mut reference = format!("{BEGIN}{PROBLEM_FILES}\n# Every analysis\n");
    for (family, analyses) in &families {
        reference += &format!("\n- {}\n", title(family));
        for analysis in analyses {
            let (heading, id) = (text(analysis, "title"), text(analysis, "id"));
            reference += &format!("  - [{heading}](#{}): `{id}`\n", anchor(heading));
        }
    }
    reference += "\n- Exam questions\n";
    for exam in &exams {
        let (heading, id) = (text(exam, "title"), text(exam, "id"));
        reference += &format!("  - [{heading}](#{}): `{id}`\n", anchor(heading));
    }
    for (family, analyses) in &families {
        reference += &format!("\n# {}\n", title(family));
        for analysis in analyses {
            // A case may be a refusal; the first one is what the form opens with, so it has an answer.
            let solved = json(&program, &["solve", text(analysis, "id"), "--case", "1", "--format", "json"])?;
            reference += &described(analysis, &solved, &verdicts);
        }
    }
    reference += "\n# Exam questions\n";
    for exam in exams {
        let shown = json(&program, &["show", text(exam, "id"), "--json"])?;
        reference += &exam_section(&shown, &verdicts);
    }
    let mut symbols = cargo::cargo(root);
    symbols.args(["run", "--quiet", "--package", "dalembert-units", "--example", "symbols"]);
    let units = cargo::output(&mut symbols)?;
    Ok(vec![
        ("docs/reference.md".to_owned(), reference),
        ("docs/units.md".to_owned(), format!("{BEGIN}{}{units}", include_str!("docs/units.md"))),
    ])
}

/// The section of an analysis.
fn described(analysis: &Json, solved: &Json, verdicts: &BTreeMap<(String, String), Counts>) -> String {
    let id = text(analysis, "id");
    let mut section = format!("\n## {}\n\n`{id}` — {}\n", text(analysis, "title"), text(analysis, "summary"));
    section += &format!("\n{}", inputs::table(&analysis["inputs"]));
    section += "\n| answer | what it is | in the first case |\n|---|---|---|\n";
    for answer in array(&analysis["answers"]) {
        let name = text(answer, "name");
        let shown = solved["answers"][name]["shown"].as_str().unwrap_or("—");
        section += &format!("| `{name}` | {} | {} |\n", cell(text(answer, "label")), cell(shown));
    }
    section += "\nCases:\n\n";
    for (n, case) in array(&analysis["cases"]).iter().enumerate() {
        let (name, source) = (text(case, "name"), text(case, "source"));
        let counts = verdicts.get(&(id.to_owned(), name.to_owned())).copied().unwrap_or_default();
        let seen = match text(case, "seen") {
            "" => String::new(),
            seen => format!(", {seen}"),
        };
        section += &format!("{}. {name} — {source} ({}{seen}): {counts}\n", n + 1, text(case, "truth"));
    }
    section += "\nSources:\n\n";
    for source in array(&analysis["sources"]) {
        section += &format!("- {}: {}\n", text(source, "short"), text(source, "full"));
    }
    section
}

/// The section of an exam question: its statement and where it follows.
fn exam_section(exam: &Json, verdicts: &BTreeMap<(String, String), Counts>) -> String {
    let (id, title) = (text(exam, "id"), text(exam, "title"));
    let mut section = format!("\n## {title}\n\n`{id}`\n");
    for case in array(&exam["cases"]) {
        let counts = verdicts.get(&(id.to_owned(), title.to_owned())).copied().unwrap_or_default();
        section += &format!("\n{}\n\n{}: {counts}\n", text(case, "statement"), text(case, "source"));
    }
    section
}

/// Counts of the comparisons of a case's published answers.
#[derive(Clone, Copy, Default)]
struct Counts {
    agreed: usize,
    disputed: usize,
    differing: usize,
}

impl std::fmt::Display for Counts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let all = [(self.agreed, "agreed"), (self.disputed, "disputed"), (self.differing, "differing")];
        let words: Vec<String> = all
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, word)| format!("{count} {word}"))
            .collect();
        f.write_str(&words.join(", "))
    }
}

/// Counts by analysis and case.
fn verdicts(verified: &Json) -> BTreeMap<(String, String), Counts> {
    let mut counts: BTreeMap<(String, String), Counts> = BTreeMap::new();
    for row in array(&verified["rows"]) {
        let of = counts.entry((text(row, "analysis").to_owned(), text(row, "case").to_owned())).or_default();
        match text(row, "verdict") {
            "agreed" => of.agreed += 1,
            "disputed" => of.disputed += 1,
            _ => of.differing += 1,
        }
    }
    counts
}

/// JSON output of the program with these arguments.
pub(crate) fn json(program: &Program, arguments: &[&str]) -> Result<Json> {
    let mut command = program.with(arguments);
    // The status says what was found; the text is complete in any case.
    let output =
        command.stderr(std::process::Stdio::inherit()).output().context("the program cannot be run")?;
    serde_json::from_slice(&output.stdout)
        .with_context(|| format!("`dalembert {}` printed no JSON", arguments.join(" ")))
}

/// The heading as GitHub and others link to it.
fn anchor(heading: &str) -> String {
    let words = heading.to_lowercase().replace(' ', "-");
    words.chars().filter(|c| c.is_alphanumeric() || *c == '-' || *c == '_').collect()
}

/// Text for a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

fn text<'j>(json: &'j Json, key: &str) -> &'j str {
    json[key].as_str().unwrap_or_default()
}

fn array(json: &Json) -> &[Json] {
    json.as_array().map_or(&[], Vec::as_slice)
}
