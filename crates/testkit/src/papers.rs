//! Worked solutions as files: every analysis in every format is well formed.

use std::path::Path;

use dalembert_core::{Entry, Exhibit, Locale, Refusal, SolveError, Stop};
use dalembert_report::{
    Document, DocumentFormat, WorkedProblem, document,
    figure::{figure, picture::PictureElement},
};

use crate::{
    problems::{cases_of, first_solutions},
    some,
};

/// The formats, each with the name of its file.
pub const PAPERS: [(DocumentFormat, &str); 4] = [
    (DocumentFormat::Markdown, "solution.md"),
    (DocumentFormat::Html, "solution.html"),
    (DocumentFormat::Latex, "solution.tex"),
    (DocumentFormat::Typst, "solution.typ"),
];

/// The first case of an analysis as a document.
pub fn worked_out(entry: &'static Entry, locale: &Locale) -> Document {
    let case = cases_of(entry).into_iter().next().expect("an analysis has a case");
    let record = case.draft.read(&entry.shape()).expect("the case files are well formed");
    let solved = match entry.solve(&record, &Stop::new()) {
        Ok(solution) => Ok(solution),
        Err(SolveError::Refused(Refusal::NoAnswer(why))) => Err(why),
        Err(other) => panic!("{}: {other:?}", entry.about.id),
    };
    let worked = WorkedProblem {
        entry,
        case: &case.title(),
        source: &case.source,
        statement: &case.statement,
        note: &case.note,
        notes: &[],
        draft: &case.draft,
        record: &record,
        outcome: solved.as_ref(),
    };
    document(&worked, locale)
}

/// Writes the first case of every analysis as Markdown, HTML, LaTeX and Typst in both languages: no tag, brace,
/// bracket or environment is left open.
pub fn every_analysis_is_written_well_in_every_format(entries: &[&'static Entry]) {
    some(entries);
    let mut faults = Vec::new();
    for entry in entries {
        for locale in [Locale::english(), Locale::portuguese()] {
            let document = worked_out(entry, &locale);
            for (paper, name) in PAPERS {
                let files = paper.files(&document, Path::new(name), &locale).expect("the path has a name");
                for (name, text) in files {
                    let fault = match name.rsplit('.').next() {
                        Some("html" | "svg") => markup_fault(&text),
                        Some("tex") => latex_fault(&text),
                        Some("typ") => typst_fault(&text),
                        _ => None,
                    };
                    faults.extend(fault.map(|why| format!("{} {name}: {why}", entry.about.id)));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Draws the figures of the first case of every analysis for paper: nothing lies outside of their frames.
pub fn every_picture_keeps_inside_its_frame(entries: &[&'static Entry]) {
    let mut faults = Vec::new();
    for (entry, solution) in first_solutions(entries) {
        for exhibit in &solution.exhibits {
            let Some(picture) = figure(exhibit, &Locale::english()) else {
                assert!(!matches!(exhibit, Exhibit::Plot(_)), "{}: a plot is not drawn", entry.about.id);
                continue;
            };
            let inside = |at: &(f64, f64)| {
                (-0.5..=picture.width + 0.5).contains(&at.0) && (-0.5..=picture.height + 0.5).contains(&at.1)
            };
            for part in &picture.parts {
                let within = match part {
                    PictureElement::Line { points, .. } => points.iter().all(inside),
                    PictureElement::Disc { at, .. } | PictureElement::Words { at, .. } => inside(at),
                    PictureElement::Area { from, to, .. } => inside(from) && inside(to),
                };
                if !within {
                    faults.push(format!("{} {}: {part:?}", entry.about.id, picture.title));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The first tag that does not close, closes what is not open, or is not written well.
fn markup_fault(text: &str) -> Option<String> {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = text.strip_prefix("<!DOCTYPE html>").unwrap_or(text);
    while let Some(at) = rest.find('<') {
        let before = &rest[..at];
        if open.last() != Some(&"style") && before.contains('>') {
            return Some(format!("a bare > in {before:?}"));
        }
        let Some(end) = rest[at..].find('>') else { return Some("a tag without an end".to_owned()) };
        let tag = &rest[at + 1..at + end];
        if !tag.matches('"').count().is_multiple_of(2) {
            return Some(format!("<{tag}>"));
        }
        if let Some(name) = tag.strip_prefix('/') {
            if open.pop() != Some(name) {
                return Some(format!("</{name}>"));
            }
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap_or(tag));
        }
        rest = &rest[at + end + 1..];
    }
    open.pop().map(|name| format!("<{name}> is left open"))
}

/// The first brace or environment that does not close, or character that pdfLaTeX does not know.
fn latex_fault(text: &str) -> Option<String> {
    let strange = text.chars().find(|c| !matches!(c, '\n' | ' '..='~' | 'À'..='Ö' | 'Ø'..='ö' | 'ø'..='ÿ'));
    if let Some(strange) = strange {
        return Some(format!("pdfLaTeX does not know {strange:?}"));
    }
    let (mut depth, mut escaped, mut dollars) = (0, false, 0);
    for (n, line) in text.lines().enumerate() {
        for character in line.chars() {
            match character {
                _ if escaped => escaped = false,
                '\\' => escaped = true,
                '{' => depth += 1,
                '}' => depth -= 1,
                '$' => dollars += 1,
                '%' => break,
                _ => {}
            }
            if depth < 0 {
                return Some(format!("line {}: a brace closes nothing: {line}", n + 1));
            }
        }
        escaped = false;
    }
    let count = |what: &str| text.matches(what).count();
    if depth != 0 || dollars % 2 != 0 {
        return Some("a brace or a $ is left open".to_owned());
    }
    (count("\\begin{") != count("\\end{")
        || count("\\left") - count("\\leftarrow") - count("\\leftrightarrow")
            != count("\\right") - count("\\rightarrow"))
    .then(|| "an environment or a bracket is left open".to_owned())
}

/// The first bracket, string or formula that does not close where it should.
fn typst_fault(text: &str) -> Option<String> {
    let mut open: Vec<char> = Vec::new();
    let mut rest = text.chars();
    while let Some(character) = rest.next() {
        let top = open.last().copied();
        // Quotation marks within words are words.
        let code = matches!(top, Some('(' | '$'));
        match (top, character) {
            (_, '\\') => drop(rest.next()),
            (Some('"'), '"') | (Some('$'), '$') | (Some('('), ')') | (Some('['), ']') => drop(open.pop()),
            (Some('"'), _) => {}
            (_, '"') if code => open.push('"'),
            (_, '$') => open.push('$'),
            (_, '(') if code || text_is_call(text, rest.as_str()) => open.push('('),
            (_, '[') => open.push('['),
            (Some('$'), ')') | (_, ']') => return Some(format!("{character} closes nothing")),
            _ => {}
        }
    }
    open.pop().map(|left| format!("{left} is left open"))
}

/// True where the bracket before `rest` belongs to a call such as `#table(`.
fn text_is_call(text: &str, rest: &str) -> bool {
    let before = &text[..text.len() - rest.len() - 1];
    let name = before.rsplit(|c: char| !c.is_ascii_lowercase()).next().unwrap_or_default();
    !name.is_empty()
        && before[..before.len() - name.len()].ends_with('#')
        && !before[..before.len() - name.len()].ends_with("\\#")
}
