//! Worked solutions as files: every analysis in every format is well-formed.

use std::path::Path;

use dalembert_core::{Locale, find, registry};
use dalembert_plugins as _;
use dalembert_testkit::papers::{self, PAPERS, worked_out};

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

#[test]
fn every_picture_keeps_inside_its_frame() {
    papers::every_picture_keeps_inside_its_frame(registry());
}
