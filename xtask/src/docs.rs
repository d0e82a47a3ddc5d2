//! `cargo xtask docs`: the reference in docs/, written from what the built program says of itself.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
    process::{ExitStatus, Stdio},
};

use anyhow::{Context, Result, bail};
use serde_json::{Value as Json, json};

use crate::{
    cargo::{self, Program},
    new_analysis::write as write_file,
    server, trust,
};

mod architecture;
mod decisions;
mod inputs;

/// The folder of the reference: a page for each analysis in the folder of its family.
const REFERENCE: &str = "docs/reference";

/// Form of a problem file, on one page.
const PROBLEM_FILES: &str = include_str!("docs/problem_files.md");

const BEGIN: &str = "<!-- Written by `cargo xtask docs`. -->\n";

/// Writes the pages of the reference, docs/problem-files.md, docs/units.md, the index of decisions and
/// docs/architecture.svg, and removes pages of analyses that are no more.
pub fn write(root: &Path) -> Result<()> {
    let generated = generated(root)?;
    for path in superfluous(root, &generated)? {
        fs::remove_file(root.join(&path)).with_context(|| format!("{path} cannot be removed"))?;
        println!("removed: {path}");
    }
    for (path, text) in &generated {
        if fs::read_to_string(root.join(path)).ok().as_ref() != Some(text) {
            write_file(&root.join(path), text)?;
            println!("written: {path}");
        }
    }
    Ok(())
}

/// Sees that what [`write()`] would write is there already, and nothing else.
pub fn check(root: &Path) -> Result<()> {
    let generated = generated(root)?;
    let superfluous = superfluous(root, &generated)?;
    let stale: Vec<String> = generated
        .into_iter()
        .filter(|(path, text)| fs::read_to_string(root.join(path)).ok().as_ref() != Some(text))
        .map(|(path, _)| path)
        .collect();
    let faults = [("out of date", stale), ("superfluous", superfluous)];
    let faults = faults.into_iter().filter(|(_, paths)| !paths.is_empty());
    let faults: Vec<String> = faults.map(|(fault, paths)| format!("{fault}: {}", paths.join(", "))).collect();
    if faults.is_empty() { Ok(()) } else { bail!("{}; run `cargo xtask docs`", faults.join("; ")) }
}

/// The pages in the folder of the reference that are not generated.
fn superfluous(root: &Path, generated: &[(String, String)]) -> Result<Vec<String>> {
    let known: BTreeSet<&str> = generated.iter().map(|(path, _)| path.as_str()).collect();
    let mut found = Vec::new();
    let mut folders = vec![REFERENCE.to_owned()];
    while let Some(folder) = folders.pop() {
        let Ok(entries) = fs::read_dir(root.join(&folder)) else { continue };
        for entry in entries {
            let entry = entry?;
            let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                folders.push(path);
            } else if !known.contains(path.as_str()) {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

/// The generated files: path and text.
fn generated(root: &Path) -> Result<Vec<(String, String)>> {
    let program = Program::built(root, root)?;
    let verified = program.with(&["verify", "--json"]).stdout(Stdio::piped()).spawn();
    let verified = verified.context("the program cannot be run")?;
    let listed = json(&program, &["list", "--json"])?;
    let listed = array(&listed);
    let described = server::of_each(&program, "en", listed, |server, entry| {
        let id = text(entry, "id");
        let shown = server.ask("show", &json!(id))?;
        if text(entry, "family") == EXAMS {
            return Ok((shown, Json::Null));
        }
        // A case may be a refusal; the first one is what the form opens with, so it has an answer.
        let problem = json!({ "problem": id, "case": 1, "only": ["answers"] });
        Ok((shown, server.ask("solve", &problem)?))
    })?;
    // The status says what was found; the text is complete in any case.
    let verified = verified.wait_with_output().context("the program cannot be run")?;
    let verified = serde_json::from_slice(&verified.stdout).context("`dalembert verify` printed no JSON")?;
    let verdicts = verdicts(&verified);
    let mut files = vec![(format!("{REFERENCE}/README.md"), index(listed))];
    for (analysis, solved) in &described {
        let page = match text(analysis, "family") {
            EXAMS => exam_page(analysis, &verdicts),
            _ => page(analysis, solved, &verdicts),
        };
        files.push((format!("{REFERENCE}/{}.md", text(analysis, "id")), format!("{BEGIN}{page}")));
    }
    let mut symbols = cargo::cargo(root);
    symbols.args(["run", "--quiet", "--package", "dalembert-units", "--example", "symbols"]);
    let units = cargo::output(&mut symbols)?;
    files.push(("docs/problem-files.md".to_owned(), format!("{BEGIN}{PROBLEM_FILES}")));
    files.push(("docs/units.md".to_owned(), format!("{BEGIN}{}{units}", include_str!("docs/units.md"))));
    files.push(decisions::index(root)?);
    files.push(architecture::picture(root)?);
    files.push(trust::generated(root)?);
    Ok(files)
}

/// The family of exam questions.
pub(crate) const EXAMS: &str = "exam";

/// The pages by family and topic, each with its id and what it is about.
fn index(listed: &[Json]) -> String {
    let mut index = format!(
        "{BEGIN}# Reference\n\nOne page for each analysis: inputs, answers, cases, sources. How a problem is written is on \
         [the page of problem files](../problem-files.md), every unit on [the page of units](../units.md).\n"
    );
    for (family, topics) in by_topic(listed) {
        index += &format!("\n## {family}\n");
        for (topic, entries) in topics {
            if !topic.is_empty() && topic != family {
                index += &format!("\n### {topic}\n");
            }
            index.push('\n');
            for entry in entries {
                let [id, heading, summary] = ["id", "title", "summary"].map(|key| text(entry, key));
                let about =
                    if text(entry, "family") == EXAMS { String::new() } else { format!(": {summary}") };
                index += &format!("- [{heading}]({id}.md) `{id}`{about}");
                index.push('\n');
            }
        }
    }
    index
}

/// Entries of a list by family and topic, in the order of the list; exam questions stand last.
pub(crate) fn by_topic(listed: &[Json]) -> Vec<(&str, Vec<(&str, Vec<&Json>)>)> {
    let mut families: Vec<(&str, Vec<(&str, Vec<&Json>)>)> = Vec::new();
    let (exams, analyses): (Vec<&Json>, Vec<&Json>) =
        listed.iter().partition(|entry| text(entry, "family") == EXAMS);
    for entry in analyses.into_iter().chain(exams) {
        let topics = of_key(&mut families, text(entry, "family_name"));
        of_key(topics, text(entry, "topic")).push(entry);
    }
    families
}

/// Value of a key in a list of pairs, begun where there is none.
fn of_key<'p, 'k, V: Default>(pairs: &'p mut Vec<(&'k str, V)>, key: &'k str) -> &'p mut V {
    let at = pairs.iter().position(|(known, _)| *known == key).unwrap_or_else(|| {
        pairs.push((key, V::default()));
        pairs.len() - 1
    });
    &mut pairs[at].1
}

/// The page of an analysis.
fn page(analysis: &Json, solved: &Json, verdicts: &BTreeMap<(String, String), Counts>) -> String {
    let id = text(analysis, "id");
    let mut section = format!("# {}\n\n`{id}` — {}\n", text(analysis, "title"), text(analysis, "summary"));
    section += &format!("\n## Inputs\n\n{}", inputs::table(&analysis["inputs"]));
    section += "\n## Answers\n\n| answer | what it is | in the first case |\n|---|---|---|\n";
    for answer in array(&analysis["answers"]) {
        let name = text(answer, "name");
        let shown = solved["answers"][name]["shown"].as_str().unwrap_or("—");
        section += &format!("| `{name}` | {} | {} |\n", cell(text(answer, "label")), cell(shown));
    }
    section += "\n## Cases\n\n";
    for (n, case) in array(&analysis["cases"]).iter().enumerate() {
        let (name, source) = (text(case, "name"), text(case, "source"));
        let counts = verdicts.get(&(id.to_owned(), name.to_owned())).copied().unwrap_or_default();
        let seen = match text(case, "seen") {
            "" => String::new(),
            seen => format!(", {seen}"),
        };
        section += &format!("{}. {name} — {source} ({}{seen}): {counts}\n", n + 1, text(case, "truth"));
    }
    section += "\n## Sources\n\n";
    for source in array(&analysis["sources"]) {
        section += &format!("- {}: {}\n", text(source, "short"), text(source, "full"));
    }
    section
}

/// The page of an exam question: its statement and where it follows.
fn exam_page(exam: &Json, verdicts: &BTreeMap<(String, String), Counts>) -> String {
    let (id, title) = (text(exam, "id"), text(exam, "title"));
    let mut section = format!("# {title}\n\n`{id}`\n");
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
    // The status says what was found; the text is complete in any case.
    Ok(json_and_status(program, arguments)?.0)
}

/// JSON output of the program with these arguments, and its status.
pub(crate) fn json_and_status(program: &Program, arguments: &[&str]) -> Result<(Json, ExitStatus)> {
    let mut command = program.with(arguments);
    let output = command.stderr(Stdio::inherit()).output().context("the program cannot be run")?;
    let json = serde_json::from_slice(&output.stdout)
        .with_context(|| format!("`dalembert {}` printed no JSON", arguments.join(" ")))?;
    Ok((json, output.status))
}

/// Text for a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

pub(crate) fn text<'j>(json: &'j Json, key: &str) -> &'j str {
    json[key].as_str().unwrap_or_default()
}

/// The ids of what `list --json` prints.
pub(crate) fn ids(listed: &Json) -> Vec<String> {
    array(listed).iter().filter_map(|analysis| analysis["id"].as_str().map(str::to_owned)).collect()
}

/// Text in HTML or SVG.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

pub(crate) fn array(json: &Json) -> &[Json] {
    json.as_array().map_or(&[], Vec::as_slice)
}
