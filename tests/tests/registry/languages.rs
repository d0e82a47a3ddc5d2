//! English and Brazilian Portuguese are both complete.

use std::path::{Path, PathBuf};

use dalembert as _;
use dalembert_core::{Shape, cases, exams::exams, own_fields, registry, suggestions};
use dalembert_plugins as _;
use dalembert_report as _;
use dalembert_study as _;
use dalembert_teaching::grading::Outcome;
use dalembert_testkit::languages::{self, SourceFile};
use dalembert_tui as _;

#[test]
fn every_sentence_has_its_portuguese() {
    languages::every_sentence_has_its_portuguese(registry(), &sources());
}

#[test]
fn every_kind_of_quantity_has_its_portuguese() {
    languages::sentences_have_their_portuguese(
        "units",
        dalembert_units::Kind::all().map(dalembert_units::Kind::name),
    );
}

#[test]
fn every_usual_question_has_its_portuguese() {
    languages::sentences_have_their_portuguese("core", suggestions::labels());
}

#[test]
fn every_exam_question_has_its_portuguese() {
    let mut sentences = Vec::new();
    for entry in exams() {
        let case = cases::first(entry).unwrap_or_else(|| panic!("{} has no case", entry.about.id));
        sentences.extend([case.title(), case.source, case.statement].map(|text| text.english()));
        sentences.extend([entry.about.topic, entry.about.summary].map(str::to_owned));
    }
    languages::sentences_have_their_portuguese("bundle", sentences.iter().map(String::as_str));
}

#[test]
fn every_outcome_of_grading_has_its_portuguese() {
    languages::sentences_have_their_portuguese("teaching", Outcome::ALL.map(Outcome::label));
}

#[test]
fn every_list_of_a_problem_has_its_portuguese() {
    let fields = registry()[0].shape().fields(None);
    let mut sentences = Vec::new();
    for list in &fields[own_fields(fields)..] {
        let Shape::Rows { item, .. } = list.shape else { panic!("{} is no list", list.name) };
        let columns = item().fields(None);
        assert!(columns.len() >= 2, "{} has columns", list.name);
        sentences.extend(std::iter::once(list).chain(columns).flat_map(|field| [field.label, field.help]));
    }
    languages::sentences_have_their_portuguese("core", sentences);
}

#[test]
fn labels_begin_with_capitals_in_both_languages() {
    languages::labels_begin_with_capitals_in_both_languages(registry());
}

#[test]
fn every_sentence_of_a_case_has_a_key_of_its_own() {
    languages::every_sentence_of_a_case_has_a_key_of_its_own(registry());
}

#[test]
fn the_translations_are_well_formed_and_use_the_same_arguments() {
    languages::the_translations_are_well_formed_and_use_the_same_arguments(&sources(), &folders());
}

#[test]
fn every_translation_is_in_use() {
    let entries = [registry(), exams()].concat();
    languages::every_translation_is_in_use(&entries, &sources(), &folders());
}

fn sources() -> Vec<SourceFile> {
    let mut all = SourceFile::below(root().join("plugins"), true);
    all.extend(crates().iter().flat_map(|folder| SourceFile::below(folder, false)));
    all
}

/// The folders with translation files.
fn folders() -> Vec<PathBuf> {
    [crates(), vec![root().join("plugins")]].concat()
}

/// The crates whose sentences users read. Derive and testkit speak to programmers alone, and errors of kernels are put
/// into words by the analyses.
fn crates() -> Vec<PathBuf> {
    ["core", "units", "import", "report", "study", "teaching", "terminal", "plot", "tui", "dalembert", "web"]
        .map(|name| root().join("crates").join(name))
        .to_vec()
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}
