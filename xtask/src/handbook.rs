//! `cargo xtask handbook`: the analyses, their worked solutions, the guide and the theory as pages for a browser, made from
//! what the built program says of itself. They are files that need no server, with scripts for the search and for solving alone.

use std::{collections::BTreeMap, fs, path::Path};

use anyhow::{Context, Result, bail};
use serde_json::{Value as Json, json};

pub use self::derivations::Derivations;
use self::{derivations::OfCases, html::Frame, markdown::Body, pages::Case, words::Words};
use crate::{
    cargo::{Program, target},
    docs::{array, text},
    new_analysis::write as write_file,
    server::{self, Server},
};

mod check;
mod contents;
mod derivations;
mod html;
mod inputs;
mod markdown;
mod pages;
mod solver;
mod words;

/// Folder of the handbook in the target folder.
const FOLDER: &str = "handbook";

const STYLE: &str = include_str!("handbook/style.css");
const SEARCH: &str = include_str!("handbook/search.js");
const SOLVE: &str = include_str!("handbook/solve.js");

/// Documents that are pages: file in docs/, and page.
const DOCUMENTS: [(&str, &str); 4] = [
    ("guide.md", "guide.html"),
    ("problem-files.md", "problem-files.html"),
    ("units.md", "units.html"),
    ("glossary.md", "glossary.html"),
];

/// The page that names the others of the theory.
const THEORY: &str = "theory/README.html";

/// Pages by their paths.
type Files = Vec<(String, String)>;

/// Writes the handbook, in every language or in one; with `--check` it is examined too.
///
/// # Errors
/// An option that is none, a problem that the program does not solve, a fault that the check finds.
pub fn run(root: &Path, words: &[&str]) -> Result<()> {
    let (languages, checked) = match words {
        [] => (Words::ALL.to_vec(), false),
        ["--check"] => (Words::ALL.to_vec(), true),
        ["--lang", language] => match Words::ALL.iter().find(|words| words.language == *language) {
            Some(words) => (vec![*words], false),
            None => bail!("--lang {language}: write en or pt-BR"),
        },
        _ => bail!("write `cargo xtask handbook`, with `--lang en`, `--lang pt-BR` or `--check` behind it"),
    };
    let program = Program::built(root, root)?;
    let folder = target(root).join(FOLDER);
    let listed = Server::start(&program, "en")?.ask("list", &Json::Null)?;
    let documents = documents(root, &listed)?;
    let derivations = Derivations::read(root)?.of_cases(&program, &listed)?;
    println!("the solver of the pages is built as WebAssembly: minutes, the first time");
    let solver = solver::build(root, &folder)?;
    if let Err(why) = &solver {
        println!("NOT BUILT: the pages do not solve: {why}");
    }
    for words in languages {
        let within = folder.join(words.language);
        if within.exists() {
            fs::remove_dir_all(&within).with_context(|| format!("{} cannot be removed", within.display()))?;
        }
        let pages = write(&program, words, &documents, &derivations, solver.is_ok(), &within)?;
        println!("written: {pages} pages in {}", within.display());
    }
    write_file(&folder.join("index.html"), &html::languages())?;
    copy(&root.join("docs/pictures"), &folder.join("en/pictures"))?;
    if checked { check::run(root, &program, &folder, &documents, solver.is_ok()) } else { Ok(()) }
}

/// Writes all pages in a language, and says how many.
fn write(
    program: &Program,
    words: &'static Words,
    documents: &Documents,
    derivations: &BTreeMap<String, OfCases>,
    solves: bool,
    folder: &Path,
) -> Result<usize> {
    let verified = program.in_language(words.language, &["verify", "--json"]).output()?;
    let verified: Json =
        serde_json::from_slice(&verified.stdout).context("`dalembert verify` printed no JSON")?;
    let mut server = Server::start(program, words.language)?;
    let listed = server.ask("list", &Json::Null)?;
    let index = server.ask("index", &Json::Null)?;
    let made = server::of_each(program, words.language, array(&listed), |server, entry| {
        let id = text(entry, "id");
        let shown = server.ask("show", &json!(id))?;
        let rows: Vec<&Json> =
            array(&verified["rows"]).iter().filter(|row| text(row, "analysis") == id).collect();
        let derived = derivations.get(id).map_or(&[][..], Vec::as_slice);
        let cases = cases(server, &shown, &rows, derived, words)?;
        let figures = server.ask("report", &json!({ "problem": id, "case": 1, "format": "figures" }))?;
        let theory: Vec<(&str, &str)> = documents.theory_of(id);
        let files = pages::of_analysis(&shown, array(&figures), &cases, &theory, solves, words);
        write_files(folder, &files)?;
        let titles: Vec<String> = cases.iter().map(|case| text(case.shown, "title").to_owned()).collect();
        Ok((files.iter().filter(|(path, _)| is_page(path)).count(), titles))
    })?;
    let titles: Vec<&[String]> = made.iter().map(|(_, titles)| titles.as_slice()).collect();
    let mut files = vec![
        ("style.css".to_owned(), STYLE.to_owned()),
        ("search.js".to_owned(), SEARCH.to_owned()),
        ("solve.js".to_owned(), format!("const WORDS = {};\n{SOLVE}", words.of_solver())),
        ("search-index.js".to_owned(), contents::search_index(&index, array(&listed), &titles)),
        ("index.html".to_owned(), contents::page(array(&listed), &documents.theory(), words)),
    ];
    if words.has_documents {
        files.extend(documents.pages(words));
    }
    write_files(folder, &files)?;
    let pages = files.iter().filter(|(path, _)| is_page(path)).count();
    Ok(pages + made.iter().map(|(pages, _)| pages).sum::<usize>())
}

/// The cases of an analysis, each solved, with its problem file and its comparisons.
fn cases<'s>(
    server: &mut Server,
    shown: &'s Json,
    rows: &[&'s Json],
    derived: &[Vec<Option<String>>],
    words: &Words,
) -> Result<Vec<Case<'s>>> {
    let id = text(shown, "id");
    let way = html::documents(&html::up(&pages::of_case(id, 1)), words);
    let of_number = |(n, case): (usize, &'s Json)| {
        let problem = json!({ "problem": id, "case": n + 1 });
        let mut report = problem.clone();
        report["format"] = "html_fragment".into();
        let name = match text(case, "name") {
            "" => text(shown, "title"),
            name => name,
        };
        let of_case = |row: &&&Json| text(row, "case") == name;
        let report = server.ask("report", &report)?;
        let sections = derived.get(n).map_or(&[][..], Vec::as_slice);
        Ok(Case {
            shown: case,
            comparisons: rows.iter().filter(of_case).copied().collect(),
            report: derivations::linked(
                report.as_str().unwrap_or_default(),
                sections,
                &way,
                words.derivation,
            ),
            solved: server.ask("solve", &problem)?,
            file: server.ask("new", &problem)?.as_str().unwrap_or_default().to_owned(),
        })
    };
    array(&shown["cases"]).iter().enumerate().map(of_number).collect()
}

/// Documents of docs/ as bodies of pages.
struct Documents {
    /// Page and body.
    bodies: Vec<(String, Body)>,
}

impl Documents {
    /// The pages of the theory: path and title.
    fn theory(&self) -> Vec<(&str, &str)> {
        let theory = self.bodies.iter().filter(|(page, _)| page.starts_with("theory/") && page != THEORY);
        theory.map(|(page, body)| (page.as_str(), body.title.as_str())).collect()
    }

    /// The same, of those that name an analysis.
    fn theory_of(&self, id: &str) -> Vec<(&str, &str)> {
        let named = |page: &str| self.bodies.iter().any(|(of, body)| of == page && body.named.contains(id));
        self.theory().into_iter().filter(|(page, _)| named(page)).collect()
    }

    fn pages(&self, words: &'static Words) -> Files {
        let page = |(path, body): &(String, Body)| {
            let frame = Frame { path, title: &body.title, words, translated: false };
            (path.clone(), frame.page(&body.html))
        };
        self.bodies.iter().map(page).collect()
    }
}

/// Reads the documents and the theory.
fn documents(root: &Path, listed: &Json) -> Result<Documents> {
    let ids: Vec<&str> = array(listed).iter().map(|entry| text(entry, "id")).collect();
    let mut sources: BTreeMap<String, String> =
        DOCUMENTS.iter().map(|(file, page)| ((*file).to_owned(), (*page).to_owned())).collect();
    for entry in fs::read_dir(root.join("docs/theory")).context("docs/theory cannot be read")? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if let Some(stem) = name.strip_suffix(".md") {
            sources.insert(format!("theory/{name}"), format!("theory/{stem}.html"));
        }
    }
    let body = |(file, page): (&String, &String)| {
        let up = "../".repeat(page.matches('/').count());
        let linked = |address: &str| linked(file, address, &sources).map(|found| format!("{up}{found}"));
        let analysis = |id: &str| ids.contains(&id).then(|| format!("{up}{id}.html"));
        let path = root.join("docs").join(file);
        let text = fs::read_to_string(&path).with_context(|| format!("{} cannot be read", path.display()))?;
        let body = markdown::body(&text, &linked, &analysis).with_context(|| file.clone())?;
        Ok((page.clone(), body))
    };
    Ok(Documents { bodies: sources.iter().map(body).collect::<Result<_>>()? })
}

/// Path in the handbook of what a document links to; nothing for what is not there.
fn linked(file: &str, address: &str, sources: &BTreeMap<String, String>) -> Option<String> {
    let (path, anchor) = address.split_once('#').map_or((address, ""), |(path, anchor)| (path, anchor));
    let mut parts: Vec<&str> = file.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            ".." => {
                parts.pop()?;
            }
            "." | "" => {}
            part => parts.push(part),
        }
    }
    let path = if path.is_empty() { file.to_owned() } else { parts.join("/") };
    let page = match path.as_str() {
        "reference/README.md" => "index.html".to_owned(),
        picture if picture.starts_with("pictures/") => picture.to_owned(),
        source => sources.get(source)?.clone(),
    };
    Some(if anchor.is_empty() { page } else { format!("{page}#{anchor}") })
}

fn is_page(path: &str) -> bool {
    Path::new(path).extension().is_some_and(|extension| extension == "html")
}

fn write_files(folder: &Path, files: &Files) -> Result<()> {
    files.iter().try_for_each(|(path, text)| write_file(&folder.join(path), text))
}

/// Copies the pictures of a folder.
fn copy(from: &Path, to: &Path) -> Result<()> {
    for entry in fs::read_dir(from).with_context(|| format!("{} cannot be read", from.display()))? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "svg") {
            let name = path.file_name().unwrap_or_default();
            write_file(&to.join(name), &fs::read_to_string(&path)?)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_of_documents_lead_to_pages() {
        let sources = [("guide.md", "guide.html"), ("theory/euler.md", "theory/euler.html")];
        let sources = sources.map(|(file, page)| (file.to_owned(), page.to_owned())).into_iter().collect();
        for (file, address, page) in [
            ("guide.md", "#keys", Some("guide.html#keys")),
            ("guide.md", "theory/euler.md", Some("theory/euler.html")),
            ("theory/euler.md", "../guide.md#units", Some("guide.html#units")),
            ("guide.md", "reference/README.md", Some("index.html")),
            ("guide.md", "../README.md", None),
            ("guide.md", "../crates/core/src/search.rs", None),
        ] {
            assert_eq!(linked(file, address, &sources).as_deref(), page, "{address} in {file}");
        }
    }
}
