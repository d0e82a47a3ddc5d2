//! Derivations: the section of the theory that derives, or defines, what a step of a worked solution computes.
//!
//! `docs/theory/derivations.toml` has a table for each analysis: sections as `page#anchor`, each with beginnings of the
//! English titles of steps. Of all beginnings that fit a title the longest decides, and `""` fits every title.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

use anyhow::{Context, Result, ensure};
use serde_json::{Value as Json, json};

use super::markdown::anchor;
use crate::{
    cargo::Program,
    docs::{array, text},
    new_analysis::DERIVATIONS,
    server,
};

/// Sections of each analysis, and beginnings of the titles of the steps that they derive.
#[derive(Debug)]
pub struct Derivations {
    sections: BTreeMap<String, BTreeMap<String, Vec<String>>>,
}

impl Derivations {
    /// Reads the file of the derivations of a repository.
    ///
    /// # Errors
    /// The file cannot be read, a section is no heading of the theory, or a beginning stands in two sections of an analysis.
    pub fn read(root: &Path) -> Result<Self> {
        let file = fs::read_to_string(root.join(DERIVATIONS))
            .with_context(|| format!("{DERIVATIONS} cannot be read"))?;
        let headings = headings(&root.join("docs/theory"))?;
        Self::of(&file, &headings).with_context(|| DERIVATIONS)
    }

    fn of(file: &str, headings: &BTreeSet<String>) -> Result<Self> {
        let sections: BTreeMap<String, BTreeMap<String, Vec<String>>> = toml::from_str(file)?;
        for (analysis, sections) in &sections {
            let mut known = BTreeSet::new();
            for (section, beginnings) in sections {
                ensure!(headings.contains(section), "{analysis}: {section} is no heading of the theory");
                for beginning in beginnings {
                    ensure!(known.insert(beginning), "{analysis}: {beginning:?} stands in two sections");
                }
            }
        }
        Ok(Self { sections })
    }

    /// The section, `page#anchor`, that derives the formula of the step with this English title, and the beginning of the
    /// title that decides.
    #[must_use]
    pub fn of_step(&self, analysis: &str, title: &str) -> Option<(&str, &str)> {
        let fitting = self.beginnings(analysis).filter(|(_, beginning)| title.starts_with(beginning));
        fitting.max_by_key(|(_, beginning)| beginning.len())
    }

    /// Every beginning of a title of an analysis, behind its section.
    pub fn beginnings(&self, analysis: &str) -> impl Iterator<Item = (&str, &str)> {
        let sections = self.sections.get(analysis).into_iter().flatten();
        sections.flat_map(|(section, beginnings)| {
            beginnings.iter().map(move |beginning| (section.as_str(), beginning.as_str()))
        })
    }

    /// The analyses that have a table.
    pub fn analyses(&self) -> impl Iterator<Item = &str> {
        self.sections.keys().map(String::as_str)
    }

    /// Sections of the steps of every case, by the id of an analysis and the place of the case; steps of a question itself,
    /// as those that find an unknown, have none.
    pub(super) fn of_cases(&self, program: &Program, listed: &Json) -> Result<BTreeMap<String, OfCases>> {
        let made = server::of_each(program, "en", array(listed), |server, entry| {
            let id = text(entry, "id");
            let shown = server.ask("show", &json!(id))?;
            let of_case = |n: usize| -> Result<Vec<Option<String>>> {
                let solved = server.ask("solve", &json!({ "problem": id, "case": n + 1 }))?;
                Ok(array(&solved["steps"]).iter().map(|step| self.of_solved(&solved, step)).collect())
            };
            let cases = (0..array(&shown["cases"]).len()).map(of_case).collect::<Result<_>>()?;
            Ok((id.to_owned(), cases))
        })?;
        Ok(made.into_iter().collect())
    }

    /// The section of a step of a result.
    fn of_solved(&self, solved: &Json, step: &Json) -> Option<String> {
        let (title, problem) = (text(step, "why"), text(step, "problem"));
        // A step of one of several problems has its name before the title.
        let (analysis, title) = match array(&solved["problems"]).iter().find(|of| text(of, "name") == problem)
        {
            Some(of) => (text(of, "analysis"), title.strip_prefix(problem)?.strip_prefix(": ")?),
            None => (text(solved, "analysis"), title),
        };
        self.of_step(analysis, title).map(|(section, _)| section.to_owned())
    }
}

/// For each case, the section of each step.
pub(super) type OfCases = Vec<Vec<Option<String>>>;

/// Sections of the pages in a folder, as `page#anchor`.
fn headings(folder: &Path) -> Result<BTreeSet<String>> {
    let mut found = BTreeSet::new();
    for entry in fs::read_dir(folder).with_context(|| format!("{} cannot be read", folder.display()))? {
        let path = entry?.path();
        if path.extension().is_none_or(|extension| extension != "md") {
            continue;
        }
        let page = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let lines = fs::read_to_string(&path)?;
        let sections =
            lines.lines().filter_map(|line| line.strip_prefix("## ").or(line.strip_prefix("### ")));
        found.extend(sections.map(|heading| format!("{page}#{}", anchor(heading))));
    }
    Ok(found)
}

/// A worked solution in HTML with a link behind the title of each step that has a section; `way` leads to the folder of the
/// documents.
pub(super) fn linked(report: &str, sections: &[Option<String>], way: &str, word: &str) -> String {
    let mut text = String::with_capacity(report.len());
    let mut steps = sections.iter().enumerate().peekable();
    for line in report.split_inclusive('\n') {
        let is_next = |(n, _): &(usize, _)| line.starts_with(&format!("<p><b>{}.</b>", n + 1));
        let section = steps.next_if(is_next).and_then(|(_, section)| section.as_ref());
        match (section, line.strip_suffix("</p>\n")) {
            (Some(section), Some(title)) => {
                let address = format!("{way}theory/{}", section.replacen('#', ".html#", 1));
                text += &format!("{title} <a class=\"derivation\" href=\"{address}\">{word}</a></p>\n");
            }
            _ => text += line,
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const DERIVED: &str = r#"
        ["vibration/x"]
        "harmonic#base" = ["", "Force on"]
        "harmonic#force" = ["Force"]
    "#;

    #[test]
    fn the_longest_beginning_decides() {
        let headings = ["harmonic#base", "harmonic#force"].map(str::to_owned).into();
        let derived = Derivations::of(DERIVED, &headings).unwrap();
        for (title, section) in [
            ("Force at resonance", "harmonic#force"),
            ("Force on the base", "harmonic#base"),
            ("Amplitude", "harmonic#base"),
        ] {
            assert_eq!(derived.of_step("vibration/x", title).unwrap().0, section, "{title}");
        }
        assert_eq!(derived.of_step("vibration/y", "Force"), None);
        let exam = json!({
            "analysis": "exam/x", "problems": [{ "name": "fan", "analysis": "vibration/x" }],
        });
        let step =
            |why: &str, problem: &str| derived.of_solved(&exam, &json!({ "why": why, "problem": problem }));
        assert_eq!(step("fan: Force at rest", "fan").as_deref(), Some("harmonic#force"));
        assert_eq!(step("Question: force", ""), None);
    }

    #[test]
    fn faults_of_the_file_are_named() {
        let only = |heading: &str| BTreeSet::from([heading.to_owned()]);
        let error = Derivations::of(DERIVED, &only("harmonic#base")).unwrap_err();
        assert!(error.to_string().contains("harmonic#force is no heading"), "{error}");
        let twice = "[\"a/b\"]\n\"p#q\" = [\"x\", \"x\"]";
        let error = Derivations::of(twice, &only("p#q")).unwrap_err();
        assert!(error.to_string().contains("\"x\" stands in two sections"), "{error}");
    }

    #[test]
    fn a_link_behind_each_title() {
        let report = "<h2>Working</h2>\n<p><b>1.</b> Mass</p>\n<div>m</div>\n<p><b>2.</b> Speed</p>\n";
        let sections = [None, Some("rotors#whirl".to_owned())];
        let expected = "<h2>Working</h2>\n<p><b>1.</b> Mass</p>\n<div>m</div>\n<p><b>2.</b> Speed \
             <a class=\"derivation\" href=\"../theory/rotors.html#whirl\">derivation</a></p>\n";
        assert_eq!(linked(report, &sections, "../", "derivation"), expected);
    }
}
