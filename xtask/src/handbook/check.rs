//! Examination of a handbook that has been written: its links, its problem files, its search, and the widths of its pages in
//! a browser.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use anyhow::{Context, Result, bail, ensure};
use serde_json::{Value as Json, json};

use super::{Documents, html::escaped, words::Words};
use crate::{
    cargo::{Program, browser, installed},
    docs::{array, text},
    server::{self, Server},
};

mod solver;

/// Script for Node.js: the search, pages in a browser, and what they compute.
const SCRIPT: &str = include_str!("check.mjs");
/// Queries of the search, in the tree.
const QUERIES: &str = "tests/data/queries.toml";
/// Widths of a page, in pixels: a phone and a desk.
const WIDTHS: [u32; 2] = [390, 1200];

/// Examines a handbook and prints what was examined.
///
/// # Errors
/// What is wrong with it.
pub(super) fn run(
    root: &Path,
    program: &Program,
    folder: &Path,
    documents: &Documents,
    solves: bool,
) -> Result<()> {
    let pages = pages(folder)?;
    let mut faults = Vec::new();
    let listed = Server::start(program, "en")?.ask("list", &Json::Null)?;
    let ids = array(&listed).iter().map(|entry| text(entry, "id")).filter(|id| !id.starts_with("exam/"));
    let (derived, missing): (Vec<&str>, Vec<&str>) = ids.partition(|id| !documents.theory_of(id).is_empty());
    println!("theory: {} analyses have their derivation, {} have none", derived.len(), missing.len());
    faults.extend(missing.iter().map(|id| format!("{id}: no page of docs/theory names it")));
    let (count, broken) = links(folder, &pages);
    println!("links: {count} in {} pages, {} broken", pages.len(), broken.len());
    faults.extend(broken);
    for words in Words::ALL {
        let (count, wrong) = problem_files(program, words.language, &folder.join(words.language))?;
        println!("problem files, {}: {count}, {} with other answers", words.language, wrong.len());
        faults.extend(wrong);
    }
    let has_node = installed(Command::new("node").arg("--version"));
    if has_node {
        for words in Words::ALL {
            let searched = searched(root, program, words.language, &folder.join(words.language))?;
            let (count, found, wrong) = searched;
            println!(
                "search, {}: {count} queries, {found} find their analysis, {} unlike the program",
                words.language,
                wrong.len()
            );
            faults.extend(wrong);
        }
    } else {
        println!("search: not run, Node.js is not installed");
    }
    match browser() {
        Some(browser) if has_node => {
            let wide = wide(browser, folder, &pages)?;
            println!("widths: {} pages at {WIDTHS:?} px, {} too wide", pages.len(), wide.len());
            faults.extend(wide);
        }
        _ => println!("widths: not run, Chromium or Node.js is not installed"),
    }
    match browser() {
        _ if !solves => println!("solver: not run, it is not built"),
        Some(browser) if has_node => faults.extend(solver::compared(program, browser, folder, &pages)?),
        _ => println!("solver: not run, Chromium or Node.js is not installed"),
    }
    for fault in &faults {
        println!("{fault}");
    }
    match faults.len() {
        0 => Ok(()),
        count => bail!("{count} faults of the handbook"),
    }
}

/// The pages of a folder: path below it, and text.
fn pages(folder: &Path) -> Result<BTreeMap<String, String>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(below) = folders.pop() {
        let here = folder.join(&below);
        for entry in fs::read_dir(&here).with_context(|| format!("{} cannot be read", here.display()))? {
            let path = below.join(entry?.file_name());
            if folder.join(&path).is_dir() {
                folders.push(path);
            } else if super::is_page(&path.to_string_lossy()) {
                let text = fs::read_to_string(folder.join(&path))?;
                found.insert(path.to_string_lossy().replace('\\', "/"), text);
            }
        }
    }
    Ok(found)
}

/// Number of the links of the pages to files of the handbook, and those that lead nowhere.
fn links(folder: &Path, pages: &BTreeMap<String, String>) -> (usize, Vec<String>) {
    let anchors: BTreeMap<&str, BTreeSet<&str>> =
        pages.iter().map(|(path, text)| (path.as_str(), attributes(text, "id").collect())).collect();
    let (mut count, mut broken) = (0, Vec::new());
    for (page, text) in pages {
        let addresses = attributes(text, "href").chain(attributes(text, "src"));
        for address in addresses.filter(|address| !address.contains("://")) {
            count += 1;
            let (path, anchor) = address.split_once('#').unwrap_or((address, ""));
            let target = if path.is_empty() { Some(page.clone()) } else { resolved(page, path) };
            let is_there = target.is_some_and(|target| match anchors.get(target.as_str()) {
                Some(ids) => anchor.is_empty() || ids.contains(anchor),
                None => anchor.is_empty() && folder.join(&target).is_file(),
            });
            if !is_there {
                broken.push(format!("{page}: the link {address} leads nowhere"));
            }
        }
    }
    (count, broken)
}

/// The values of an attribute in a text.
fn attributes<'t>(text: &'t str, name: &str) -> impl Iterator<Item = &'t str> {
    let begin = format!(" {name}=\"");
    let starts: Vec<usize> = text.match_indices(&begin).map(|(at, _)| at + begin.len()).collect();
    starts.into_iter().filter_map(|at| text[at..].split('"').next())
}

/// The path that an address on a page means.
fn resolved(page: &str, address: &str) -> Option<String> {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in address.split('/') {
        if part == ".." {
            parts.pop()?;
        } else {
            parts.push(part);
        }
    }
    Some(parts.join("/"))
}

/// Number of the problem files of a language, and those whose answers are not those of their page.
fn problem_files(program: &Program, language: &str, folder: &Path) -> Result<(usize, Vec<String>)> {
    let listed = Server::start(program, language)?.ask("list", &Json::Null)?;
    let of_analysis = |server: &mut Server, entry: &Json| {
        let (id, count) = (text(entry, "id"), entry["cases"].as_u64().unwrap_or_default());
        let mut wrong = Vec::new();
        for number in 1..=count {
            let read = |ending: &str| {
                let path = folder.join(format!("{id}/{number}.{ending}"));
                fs::read_to_string(&path).with_context(|| format!("{} cannot be read", path.display()))
            };
            let (file, page) = (read("toml")?, read("html")?);
            if let Some(why) = fault_of(server, id, number, &file, &page) {
                wrong.push(format!("{language}/{id}/{number}.toml: {why}"));
            }
        }
        Ok((count as usize, wrong))
    };
    let found = server::of_each(program, language, array(&listed), of_analysis)?;
    let count = found.iter().map(|(count, _)| count).sum();
    Ok((count, found.into_iter().flat_map(|(_, wrong)| wrong).collect()))
}

/// Fault of a problem file: what it gives is not what the case gives, or not what stands on the page.
fn fault_of(server: &mut Server, id: &str, number: u64, file: &str, page: &str) -> Option<String> {
    let mut solved = |problem: Json| server.ask("solve", &problem);
    let of_case = solved(json!({ "problem": id, "case": number, "only": ["answers", "refusal"] }));
    let of_file = solved(json!({ "problem_file": file, "only": ["answers", "refusal"] }));
    let (of_case, of_file) = match (of_case, of_file) {
        (Ok(of_case), Ok(of_file)) => (of_case, of_file),
        (Err(why), _) | (_, Err(why)) => return Some(format!("{why:#}")),
    };
    if of_case != of_file {
        return Some("its answers are not those of the case".to_owned());
    }
    let missing = of_file["answers"].as_object()?.iter().find(|(_, answer)| {
        let shown = text(answer, "shown");
        !shown.is_empty() && !page.contains(&escaped(shown))
    });
    missing.map(|(name, answer)| format!("{name} = {} does not stand on the page", text(answer, "shown")))
}

/// Number of queries, of those that find their analysis among the first three, and those that find others than the
/// program does.
fn searched(
    root: &Path,
    program: &Program,
    language: &str,
    folder: &Path,
) -> Result<(usize, usize, Vec<String>)> {
    let queries = queries(root)?;
    let words: Vec<&String> = queries.iter().map(|(words, _)| words).collect();
    let arguments = [folder.join("search.js"), folder.join("search-index.js")];
    let found = script("search", &arguments, &json!(words))?;
    ensure!(array(&found).len() == queries.len(), "the search has not answered every query");
    let mut server = Server::start(program, language)?;
    let (mut right, mut wrong) = (0, Vec::new());
    for ((words, id), found) in queries.iter().zip(array(&found)) {
        let listed = server.ask("list", &json!(words))?;
        let first: Vec<&str> = array(&listed).iter().take(3).map(|entry| text(entry, "id")).collect();
        let found: Vec<&str> = array(found).iter().filter_map(Json::as_str).collect();
        right += usize::from(found.contains(&id.as_str()));
        if found != first {
            wrong.push(format!("{language}: {words} finds {found:?}, the program {first:?}"));
        }
    }
    Ok((queries.len(), right, wrong))
}

/// The queries of the tests: words, and the analysis that is meant.
fn queries(root: &Path) -> Result<Vec<(String, String)>> {
    let text = fs::read_to_string(root.join(QUERIES)).with_context(|| format!("{QUERIES} cannot be read"))?;
    let table: toml::Table = text.parse().with_context(|| format!("{QUERIES} is no TOML"))?;
    let mut queries = Vec::new();
    collect(&table, &mut queries);
    Ok(queries)
}

fn collect(table: &toml::Table, queries: &mut Vec<(String, String)>) {
    for (words, value) in table {
        match value {
            toml::Value::String(id) => queries.push((words.clone(), id.clone())),
            toml::Value::Table(table) => collect(table, queries),
            _ => {}
        }
    }
}

/// The pages that are wider than a window.
fn wide(browser: &str, folder: &Path, pages: &BTreeMap<String, String>) -> Result<Vec<String>> {
    let addresses: Vec<PathBuf> = pages.keys().map(|page| folder.join(page)).collect();
    let request = json!({ "browser": browser, "pages": addresses, "widths": WIDTHS });
    let found = script("widths", &[], &request)?;
    ensure!(found["measured"] == addresses.len(), "the browser has not opened every page");
    let page =
        |fault: &Json| format!("{}: {} px wide at {} px", text(fault, "page"), fault["is"], fault["at"]);
    Ok(array(&found["wide"]).iter().map(page).collect())
}

/// Reply of the script to a request.
fn script(task: &str, arguments: &[PathBuf], request: &Json) -> Result<Json> {
    let mut command = Command::new("node");
    command.args(["--input-type=module", "--eval", SCRIPT, "--", task]).args(arguments);
    let mut running =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().context("node cannot be run")?;
    let input = running.stdin.take().context("node reads nothing")?;
    serde_json::to_writer(input, request)?;
    let output = running.wait_with_output()?;
    ensure!(output.status.success(), "node ended with {}", output.status);
    serde_json::from_slice(&output.stdout).context("node printed no JSON")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_that_lead_nowhere_are_found() {
        let pages = [
            (
                "en/a.html",
                "<h2 id=\"x\"> <a href=\"#x\"> <a href=\"b/1.html#y\"> <a href=\"https://e.org/z\">",
            ),
            (
                "en/b/1.html",
                "<p id=\"y\"> <a href=\"../a.html#no\"> <img src=\"gone.svg\"> <a href=\"../../../a\">",
            ),
        ];
        let pages = pages.map(|(path, text)| (path.to_owned(), text.to_owned())).into_iter().collect();
        let (count, broken) = links(Path::new("no folder"), &pages);
        assert_eq!(count, 5);
        let of = |address: &str| format!("en/b/1.html: the link {address} leads nowhere");
        assert_eq!(broken, [of("../a.html#no"), of("../../../a"), of("gone.svg")]);
    }
}
