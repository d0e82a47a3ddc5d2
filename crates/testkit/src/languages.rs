//! English and Brazilian Portuguese, both complete.
//!
//! Sentences are found in two ways: in the descriptions of every analysis and the solutions of every case, and as
//! literals in sources.

mod scan;
mod sentences;

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use dalembert_core::{Entry, Locale, Stop, Text, text};

use self::{
    scan::{arguments, literals, sentences_of_an_analysis, strings},
    sentences::{Sentences, is_the_same_in_every_language, words_of},
};
use crate::{
    problems::{cases_of, for_each_problem},
    some,
};

/// A source of the program.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// Folder of the crate.
    pub of: String,
    /// Content.
    pub text: String,
    /// True for the source of analyses, in which every literal of two words is a sentence.
    pub of_analyses: bool,
}

impl SourceFile {
    /// The sources in the folders `src` below a folder.
    pub fn below(folder: impl AsRef<Path>, of_analyses: bool) -> Vec<Self> {
        let folder = folder.as_ref();
        let sources = files(folder, "rs").into_iter().filter_map(|path| {
            let of = crate_of(folder, &path)?;
            Some(Self { of, text: read(&path), of_analyses })
        });
        sources.collect()
    }
}

/// Searches the Portuguese of every sentence that a user can read: those of the analyses and their cases, and those
/// of the sources. Prints the missing ones ready to be translated.
pub fn every_sentence_has_its_portuguese(entries: &[&'static Entry], sources: &[SourceFile]) {
    some(entries);
    let mut sentences = Sentences::default();
    for entry in entries {
        let of = entry.family();
        sentences.add(of, entry.about.title);
        sentences.add(of, entry.about.summary);
        sentences.add(of, entry.about.topic);
        sentences.fields(of, entry.fields(), &mut BTreeSet::new());
        for case in cases_of(entry) {
            sentences.case(of, &case);
            let Ok(record) = case.record(entry) else { continue };
            if let Ok(solution) = entry.solve(&record, &Stop::new()) {
                sentences.solution(of, &solution);
            }
        }
    }
    for source in sources {
        let mut found = literals(&source.text);
        if source.of_analyses {
            found.extend(sentences_of_an_analysis(&source.text));
        }
        for sentence in &found {
            sentences.add(&source.of, sentence);
        }
    }
    all_are_translated(&sentences);
}

/// Searches the Portuguese of sentences that stand elsewhere, such as the names of a table. `of` is their crate.
pub fn sentences_have_their_portuguese<'a>(of: &str, all: impl IntoIterator<Item = &'a str>) {
    let mut sentences = Sentences::default();
    for sentence in all {
        sentences.add(of, sentence);
    }
    all_are_translated(&sentences);
}

fn all_are_translated(sentences: &Sentences) {
    assert!(!sentences.0.is_empty(), "there is no sentence to be translated");
    let missing: Vec<String> = sentences
        .0
        .iter()
        .filter(|(sentence, _)| !is_the_same_in_every_language(sentence) && !text::is_translated(sentence))
        .map(|(sentence, of)| format!("[{of}] {} = {sentence}", text::key(sentence)))
        .collect();
    assert!(missing.is_empty(), "{} sentences have no Portuguese:\n{}", missing.len(), missing.join("\n"));
}

/// Compares labels in both languages: where the English begins with a capital, so does the Portuguese.
pub fn labels_begin_with_capitals_in_both_languages(entries: &[&'static Entry]) {
    some(entries);
    let mut labels = Sentences::default();
    for entry in entries {
        labels.fields(entry.about.id, entry.fields(), &mut BTreeSet::new());
        for case in cases_of(entry) {
            let Ok(record) = case.record(entry) else { continue };
            let Ok(solution) = entry.solve(&record, &Stop::new()) else { continue };
            solution.answers.iter().for_each(|answer| labels.add(entry.about.id, answer.label));
        }
    }
    let capital = |text: &str| text.starts_with(char::is_uppercase);
    let portuguese = Locale::portuguese();
    let wrong: Vec<String> = labels
        .0
        .iter()
        .filter(|(label, _)| capital(label))
        .map(|(label, of)| (label, of, Text::new(label.clone()).render(&portuguese)))
        .filter(|(.., translated)| translated.starts_with(char::is_lowercase))
        .map(|(label, of, translated)| format!("[{of}] {} = {translated}", text::key(label)))
        .collect();
    assert!(wrong.is_empty(), "{} labels:\n{}", wrong.len(), wrong.join("\n"));
}

/// Compares the keys of the sentences of all cases: long sentences that begin alike would be translated alike.
pub fn every_sentence_of_a_case_has_a_key_of_its_own(entries: &[&'static Entry]) {
    some(entries);
    let mut known: BTreeMap<String, String> = BTreeMap::new();
    for entry in entries {
        for text in cases_of(entry).iter().flat_map(words_of) {
            let english = text.english();
            let first = known.entry(text::key(&english)).or_insert_with(|| english.clone());
            assert!(
                *first == english || text::key(&english).is_empty(),
                "{}: {first}\n{english}",
                entry.about.id
            );
        }
    }
}

/// Reads every translation file below some folders: it is well formed, and each message has the arguments and the relations
/// (≤, ≥, ≠) that its English sentence has in the sources.
pub fn the_translations_are_well_formed_and_use_the_same_arguments(
    sources: &[SourceFile],
    folders: &[impl AsRef<Path>],
) {
    let faults = text::translation_faults();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let relations = |sentence: &str| sentence.chars().filter(|c| "≤≥≠".contains(*c)).collect::<String>();
    let mut used: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut related: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for literal in sources.iter().flat_map(|source| literals(&source.text)) {
        used.insert(text::key(&literal), arguments(&literal, "{", "}"));
        if !text::is_notation(&literal) {
            related.entry(text::key(&literal)).or_default().insert(relations(&literal));
        }
    }
    for (path, key, sentence) in messages(folders).iter().filter(|(_, _, sentence)| !sentence.is_empty()) {
        if let Some(wanted) = used.get(key) {
            let have = arguments(sentence, "{ $", " }");
            assert_eq!(&have, wanted, "{}: {key} has other arguments than the English", path.display());
            let signs =
                related.get(key).is_none_or(|all| all.iter().all(|signs| *signs == relations(sentence)));
            assert!(signs, "{}: {key} has other relations than the English", path.display());
        }
    }
}

/// Searches the sentence of every translation below some folders: among those of the analyses and their cases, and
/// among all literals of the sources. Prints the translations of sentences that were renamed or left out since.
pub fn every_translation_is_in_use(
    entries: &[&'static Entry],
    sources: &[SourceFile],
    folders: &[impl AsRef<Path>],
) {
    some(entries);
    let mut sentences = Sentences::default();
    for entry in entries {
        sentences.fields(entry.family(), entry.shape().fields(None), &mut BTreeSet::new());
        for case in cases_of(entry) {
            sentences.case(entry.family(), &case);
        }
    }
    for_each_problem(entries, |problem| sentences.solution(problem.entry.family(), &problem.solution));
    let literals: Vec<String> = sources.iter().flat_map(|source| strings(&source.text)).collect();
    let sentences = sentences.0.keys().chain(&literals).filter(|sentence| !text::is_notation(sentence));
    let used: BTreeSet<String> = sentences.map(|sentence| text::key(sentence)).collect();
    let unused: Vec<String> = messages(folders)
        .iter()
        .filter(|(_, key, _)| !used.contains(key))
        .map(|(path, key, _)| format!("{}: {key}", path.display()))
        .collect();
    assert!(unused.is_empty(), "{} translations of no sentence:\n{}", unused.len(), unused.join("\n"));
}

/// The messages of all translation files below some folders: file, key, and the sentence beside it, if it is one line.
fn messages(folders: &[impl AsRef<Path>]) -> Vec<(PathBuf, String, String)> {
    let mut found = Vec::new();
    for path in folders.iter().flat_map(|folder| files(folder.as_ref(), "ftl")) {
        for (key, sentence) in read(&path).lines().filter_map(|line| line.split_once(" =")) {
            if key.starts_with(|c: char| c.is_ascii_lowercase()) {
                found.push((path.clone(), key.to_owned(), sentence.trim().to_owned()));
            }
        }
    }
    assert!(!found.is_empty(), "there is no translation");
    found
}

/// The files with an ending below a folder, without what is built.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        let listed = fs::read_dir(&folder).unwrap_or_else(|err| panic!("{}: {err}", folder.display()));
        for entry in listed {
            let path = entry.unwrap_or_else(|err| panic!("{}: {err}", folder.display())).path();
            if path.is_dir() && !path.ends_with("target") {
                folders.push(path);
            } else if path.extension().is_some_and(|have| have == ending) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// The folder of the crate that a source belongs to; `None` outside of every folder `src` below `folder`.
fn crate_of(folder: &Path, source: &Path) -> Option<String> {
    let below = source.strip_prefix(folder).ok()?;
    let of_the_crate: PathBuf = below.iter().take_while(|part| *part != "src").collect();
    let name = if of_the_crate.as_os_str().is_empty() { folder } else { &of_the_crate };
    (of_the_crate != below).then(|| name.file_name().unwrap_or_default().to_string_lossy().into_owned())
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|err| panic!("{}: {err}", path.display()))
}
