//! Worked solutions as files: every analysis in every format is well-formed.

use std::{
    collections::BTreeMap,
    io::{Cursor, Read as _},
    path::Path,
};

use dalembert_core::{Locale, find, registry};
use dalembert_plugins as _;
use dalembert_report::{Block, NoteSource, Parts, docx};
use dalembert_testkit::papers::{self, PAPERS, worked_out};
use quick_xml::{Reader, events::Event};

#[test]
fn every_analysis_is_written_well_in_every_format() {
    papers::every_analysis_is_written_well_in_every_format(registry());
}

/// Reports word for word: a problem with plots and one with vectors and a scene in space. Of the figures their number
/// of lines.
#[test]
fn two_problems_in_every_format_and_both_languages() {
    for id in ["vibration/rotating-unbalance", "rigid-body/momentum"] {
        let entry = find(id).expect("the analysis is linked");
        for (locale, language) in [(Locale::english(), "en"), (Locale::portuguese(), "pt")] {
            let document = worked_out(entry, &locale);
            for (paper, name) in PAPERS {
                let files = paper.files(&document, Path::new(name), &locale).expect("the path has a name");
                let of = format!("paper_{}_{language}_{name}", id.replace('/', "_"));
                insta::assert_snapshot!(of, without_figures(&files[0].1));
            }
        }
    }
}

/// The text with the size of each figure in its place.
fn without_figures(text: &str) -> String {
    let mut kept = String::new();
    let mut figure: Option<usize> = None;
    for line in text.lines() {
        if ["<svg", "\\begin{tikzpicture}"].iter().any(|begin| line.trim_start().starts_with(begin)) {
            figure = Some(0);
        }
        match &mut figure {
            Some(lines) => *lines += 1,
            None => kept += &format!("{line}\n"),
        }
        if line.contains("</svg>") || line.contains("\\end{tikzpicture}") {
            kept += &format!("[a figure of {} lines]\n", figure.take().unwrap_or(0));
        }
    }
    kept
}

/// Writes the first case of every analysis for Word: each step is an equation, headings are headings, data are tables,
/// figures are metafiles, and the XML of all parts is well formed.
#[test]
fn every_analysis_is_a_document_of_word() {
    let locale = Locale::english();
    let mut equations = 0;
    for entry in registry() {
        let id = entry.about.id;
        let document = worked_out(entry, &locale);
        let source = NoteSource::new("format = 2\n".to_owned(), &[], Parts::Full, &locale);
        let bytes = docx(&document, &source, &locale).expect("a document");
        let mut archive = zip::ZipArchive::new(Cursor::new(&bytes)).expect("an archive");
        let mut counts: BTreeMap<String, usize> = BTreeMap::new();
        let mut figures = 0;
        for n in 0..archive.len() {
            let mut file = archive.by_index(n).expect("a part");
            let name = file.name().expect("a name").into_owned();
            if name.rsplit_once('.').is_some_and(|(_, kind)| kind == "emf") {
                figures += 1;
                continue;
            }
            let mut text = String::new();
            file.read_to_string(&mut text).expect("a text");
            let mut reader = Reader::from_str(&text);
            let (mut open, mut style) = (0_usize, String::new());
            loop {
                match reader.read_event().unwrap_or_else(|why| panic!("{id}, {name}: {why}")) {
                    Event::Eof => break,
                    Event::Start(start) => {
                        open += 1;
                        *counts.entry(start.name().as_ref().to_owned()).or_default() += 1;
                    }
                    Event::Empty(empty)
                        if empty.name().as_ref() == "w:pStyle" && name == "word/document.xml" =>
                    {
                        let value = empty.try_get_attribute("w:val").expect("well formed").expect("a style");
                        style = value.value.into_owned();
                        *counts.entry(style.clone()).or_default() += 1;
                    }
                    Event::End(_) => open -= 1,
                    _ => {}
                }
            }
            assert_eq!(open, 0, "{id}, {name} {style}");
        }
        let of =
            |wanted: &dyn Fn(&Block) -> bool| document.blocks.iter().filter(|block| wanted(block)).count();
        let count = |name: &str| counts.get(name).copied().unwrap_or(0);
        let steps = of(&|block| matches!(block, Block::Step(..)));
        assert_eq!(count("m:oMathPara"), steps, "{id}");
        assert!(count("m:oMath") >= steps, "{id}");
        assert_eq!(count("Heading1"), of(&|block| matches!(block, Block::Heading(_))), "{id}");
        let tables = of(&|block| matches!(block, Block::Lines(_) | Block::Table(_)));
        assert!(count("w:tbl") >= tables && tables > 0, "{id}");
        assert_eq!(figures, of(&|block| matches!(block, Block::Figure(_))), "{id}");
        assert_eq!(count("w:drawing"), figures, "{id}");
        equations += steps;
    }
    assert!(equations > 2000, "only {equations} equations");
}

#[test]
fn every_picture_keeps_inside_its_frame() {
    papers::every_picture_keeps_inside_its_frame(registry());
}
