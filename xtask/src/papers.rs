//! `cargo xtask papers`: every analysis as a note, and sheets and keys of variants for a class, in both languages and each
//! format, printed as PDF and measured.
//!
//! | format | printed by |
//! |---|---|
//! | HTML | Chromium, and laid out for a phone and a desk |
//! | Typst | the package `typst` of Python |
//! | LaTeX | pdfLaTeX |
//! | Word | LibreOffice, where `--format docx` asks for it |
//!
//! Faults are letters outside of the text of a page or cut, boxes that LaTeX reports as overfull, and titles that stand
//! last on a page.

use std::{
    collections::BTreeMap,
    fs,
    io::Write as _,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    thread,
};

use anyhow::{Context, Result, bail, ensure};
use serde::Deserialize;
use serde_json::{Value as Json, json};

use crate::{
    cargo::{Program, browser, installed, output, target},
    docs::{self, ids},
};

/// Script for Python: makes the PDFs and measures them.
const SCRIPT: &str = include_str!("papers/papers.py");
/// Formats by the ending of their files, and how many of them are printed without `--format`.
const FORMATS: [&str; 4] = ["html", "typ", "tex", "docx"];
const USUAL: usize = 3;
/// Languages of the notes.
const LANGUAGES: [&str; 2] = ["en", "pt-BR"];
/// Widths in which pages are laid out, in pixels: a phone and a desk.
const WIDTHS: [u32; 2] = [390, 1200];
/// Kinds of faults, with what is counted.
const KINDS: [(&str, &str); 4] = [
    ("failed", "not printed"),
    ("outside", "places outside of the text or cut"),
    ("overfull", "overfull boxes"),
    ("lone", "lone titles"),
];
/// Problems whose variants are printed: a problem file, and analyses with drawings, tables, vectors and long formulas.
const VARIED: [&str; 7] = [
    "tests/data/teaching/fan.toml",
    "balancing/splitting",
    "rigid-body/steady-rolling",
    "vibration/base-excitation",
    "vibration/harmonic-sum",
    "virtual-work/a-frame",
    "virtual-work/geared-drive",
];
/// Files of the variants of a problem, without ending: sheet and worked key of each, the key of all, and all sheets as one.
const SHEETS: [&str; 6] = ["sheet-1", "sheet-2", "worked-1", "worked-2", "key", "class"];
/// Number of programs that print at the same time.
const PROCESSES: usize = 2;

/// Documents that are written for one name in one language.
#[derive(Clone, Copy)]
enum Written<'a> {
    /// Note of an analysis.
    Note(&'a str),
    /// Sheets and keys of two variants of a problem.
    Sheets(&'a str),
}

/// Document in one language: a file without ending in a folder.
struct Note {
    name: String,
    folder: PathBuf,
    stem: &'static str,
    formats: Vec<String>,
    titles: Vec<String>,
}

/// Findings about a note in a format.
#[derive(Deserialize)]
struct Printed {
    name: String,
    format: String,
    pages: usize,
    faults: Vec<(String, String)>,
}

/// Prints the notes of all analyses and the sheets, or those whose names contain one of the words; `--format F` prints one
/// format.
///
/// # Errors
/// A program that is missing, with how it is installed; faults, which are listed.
pub fn run(root: &Path, words: &[&str]) -> Result<()> {
    let (formats, names) = options(words)?;
    let browser = programs(&formats)?;
    let program = Program::built(root, root)?;
    let ids: Vec<String> = ids(&docs::json(&program, &["list", "--json"])?);
    let place = Place { root, program, folder: target(root).join("papers") };
    let is_wanted = |name: &str| names.is_empty() || names.iter().any(|word| name.contains(word));
    let notes = ids.iter().filter(|id| is_wanted(id)).map(|id| Written::Note(id));
    let sheets = VARIED.iter().filter(|problem| is_wanted(problem)).map(|problem| Written::Sheets(problem));
    let wanted: Vec<Written> = notes.chain(sheets).collect();
    ensure!(!wanted.is_empty(), "no name contains {}", names.join(" or "));
    let wanted: Vec<(&str, Written)> =
        LANGUAGES.iter().flat_map(|language| wanted.iter().map(move |one| (*language, *one))).collect();
    let work = |part: &[(&str, Written)]| -> Result<Vec<Printed>> {
        let notes = part.iter().map(|(language, one)| match one {
            Written::Note(id) => Ok(vec![place.note(language, id, &formats)?]),
            Written::Sheets(problem) => place.sheets(language, problem, &formats),
        });
        let notes: Vec<Note> = notes.collect::<Result<Vec<_>>>()?.into_iter().flatten().collect();
        printed(&notes, &formats, browser)
    };
    let printed = thread::scope(|scope| {
        let parts = wanted.chunks(wanted.len().div_ceil(PROCESSES));
        let workers: Vec<_> = parts.map(|part| scope.spawn(move || work(part))).collect();
        let found = workers.into_iter().map(|worker| worker.join().expect("a worker does not panic"));
        found.collect::<Result<Vec<_>>>()
    })?;
    let printed: Vec<Printed> = printed.into_iter().flatten().collect();
    report(&printed, &formats)
}

/// Formats and names among the words of the command line.
fn options<'w>(words: &[&'w str]) -> Result<(Vec<&'w str>, Vec<&'w str>)> {
    let (mut formats, mut names) = (Vec::new(), Vec::new());
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match *word {
            "--format" => {
                let format = words.next().context("write a format behind --format")?;
                ensure!(
                    FORMATS.contains(format),
                    "there is no format {format}; write {}",
                    FORMATS.join(", ")
                );
                formats.push(*format);
            }
            option if option.starts_with('-') => bail!("{option} is no option of papers"),
            name => names.push(name),
        }
    }
    Ok((if formats.is_empty() { FORMATS[..USUAL].to_vec() } else { formats }, names))
}

/// The name of the browser, if all programs that these formats need are there.
///
/// # Errors
/// Those that are missing, with how they are installed.
fn programs(formats: &[&str]) -> Result<Option<&'static str>> {
    let runs = |program: &str, arguments: &[&str]| installed(Command::new(program).args(arguments));
    let browser = browser();
    let needed = [
        ("", "pymupdf, by `pip install pymupdf`", runs("python3", &["-c", "import pymupdf"])),
        ("typ", "typst, by `pip install typst`", runs("python3", &["-c", "import typst"])),
        ("html", "Chromium, by `apt-get install chromium`", browser.is_some()),
        (
            "tex",
            "pdflatex, by `apt-get install texlive-latex-recommended texlive-pictures texlive-fonts-recommended lmodern`",
            runs("pdflatex", &["--version"]),
        ),
        (
            "docx",
            "LibreOffice, by `apt-get install libreoffice-writer libreoffice-math`",
            runs("soffice", &["--version"]),
        ),
    ];
    let missing: Vec<&str> = needed
        .iter()
        .filter(|(format, _, is_there)| !is_there && (format.is_empty() || formats.contains(format)))
        .map(|(_, what, _)| *what)
        .collect();
    ensure!(missing.is_empty(), "papers needs {}", missing.join("; "));
    Ok(browser)
}

/// Folder of the documents, with the program that writes them.
struct Place<'a> {
    root: &'a Path,
    program: Program,
    folder: PathBuf,
}

impl Place<'_> {
    /// Folder for a name in a language.
    fn folder(&self, language: &str, name: &str) -> Result<PathBuf> {
        let folder = self.folder.join(language).join(name.replace('/', "+"));
        fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        Ok(folder)
    }

    /// Writes a note in these formats, and in Markdown, which has its titles.
    fn note(&self, language: &str, id: &str, formats: &[&str]) -> Result<Note> {
        let folder = self.folder(language, id)?;
        for format in formats.iter().chain(&["md"]) {
            let path = folder.join(format!("note.{format}"));
            let path = path.to_string_lossy();
            let mut command =
                self.program.in_language(language, &["solve", id, "--force", "--output", &path]);
            let done = command.output().context("the program cannot be run")?;
            // A problem may have no answer: its note has the reason.
            ensure!(done.status.code() != Some(2), "{id}: {}", String::from_utf8_lossy(&done.stderr));
        }
        let text = fs::read_to_string(folder.join("note.md"))?;
        let formats = formats.iter().map(|&format| format.to_owned()).collect();
        Ok(Note { name: format!("{id} {language}"), folder, stem: "note", formats, titles: titles(&text) })
    }

    /// Writes sheets and keys of two variants in the same way. There are none for Word.
    fn sheets(&self, language: &str, problem: &str, formats: &[&str]) -> Result<Vec<Note>> {
        let folder = self.folder(language, &format!("variants of {problem}"))?;
        let path = folder.to_string_lossy();
        let formats: Vec<&str> = formats.iter().filter(|format| **format != "docx").copied().collect();
        for format in formats.iter().chain(&["md"]) {
            let options = ["variants", problem, "--seed", "11", "--count", "2", "--format", format];
            let mut files = self.program.in_language(language, &options);
            output(files.current_dir(self.root).args(["--force", "--out", &path]))?;
            let mut class = self.program.in_language(language, &options);
            let text = output(class.current_dir(self.root))?;
            fs::write(folder.join(format!("class.{format}")), text)?;
        }
        let note = |stem: &'static str| -> Result<Note> {
            let text = fs::read_to_string(folder.join(format!("{stem}.md")))?;
            let name = format!("{problem} {language}, {stem}");
            let formats = formats.iter().map(|&format| format.to_owned()).collect();
            Ok(Note { name, folder: folder.clone(), stem, formats, titles: titles(&text) })
        };
        SHEETS.into_iter().map(note).collect()
    }
}

/// The titles of a note in Markdown: headings, reasons of steps, titles of tables.
fn titles(text: &str) -> Vec<String> {
    let of_line = |line: &str| {
        let heading = line.strip_prefix("## ").or(line.strip_prefix("### "));
        let bold = line.strip_prefix("**").map(|rest| rest.replacen("**", "", 1));
        heading.map(str::to_owned).or(bold).map(|title| title.replace("&amp;", "&"))
    };
    text.lines().filter_map(of_line).collect()
}

/// Prints and measures notes.
fn printed(notes: &[Note], formats: &[&str], browser: Option<&str>) -> Result<Vec<Printed>> {
    let note = |note: &Note| {
        json!({
            "name": note.name, "folder": note.folder, "stem": note.stem, "titles": note.titles, "formats": note.formats
        })
    };
    let notes: Vec<Json> = notes.iter().map(note).collect();
    let request = json!({ "notes": notes, "formats": formats, "browser": browser, "widths": WIDTHS });
    let mut python = Command::new("python3")
        .args(["-c", SCRIPT])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .context("python3 cannot be run")?;
    let mut requests = python.stdin.take().context("python3 reads nothing")?;
    writeln!(requests, "{request}")?;
    drop(requests);
    let done = python.wait_with_output()?;
    ensure!(done.status.success(), "the measurement ended with {}", done.status);
    serde_json::from_slice(&done.stdout).context("the measurement cannot be read")
}

/// Prints faults and their numbers.
fn report(printed: &[Printed], formats: &[&str]) -> Result<()> {
    let mut counts: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for one in printed {
        for (kind, what) in &one.faults {
            *counts.entry((&one.format, kind)).or_default() += 1;
            println!("{}, {}: {what}", one.name, one.format);
        }
    }
    for format in formats {
        let of_format = || printed.iter().filter(|one| one.format == *format);
        let pages: usize = of_format().map(|one| one.pages).sum();
        let kinds: Vec<String> = KINDS
            .iter()
            .map(|(kind, words)| format!("{} {words}", counts.get(&(*format, *kind)).unwrap_or(&0)))
            .collect();
        println!("{format}: {} documents, {pages} pages: {}", of_format().count(), kinds.join(", "));
    }
    match counts.values().sum() {
        0 => Ok(()),
        count => bail!("{count} faults of printed notes"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_are_headings_reasons_and_titles_of_tables() {
        let text = "# Fan\n\nA fan.\n\n## Given data\n\n**1.** The speed (Rao §1)\n\n    ω = 2\n\n**Modes**\n\n| a |\n";
        assert_eq!(titles(text), ["Given data", "1. The speed (Rao §1)", "Modes"]);
    }

    #[test]
    fn formats_and_names_are_chosen() {
        let chosen = options(&["crank", "--format", "tex", "fan"]).expect("an option");
        assert_eq!(chosen, (vec!["tex"], vec!["crank", "fan"]));
        assert!(options(&["--format", "doc"]).is_err() && options(&["--fast"]).is_err());
    }
}
