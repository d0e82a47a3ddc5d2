//! English and Brazilian Portuguese are both complete.
//!
//! Sentences are found in two ways: in the descriptions of every analysis and the solutions of every case, and
//! as literals in the sources that become a `Text`.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use dalembert as _;
use dalembert_core::{
    DrawnShape, Exhibit, Field, Locale, Shape, Stop, Text,
    cases::{self, Case, Hold},
    exhibit::Cell,
    registry, text,
};
use dalembert_plugins as _;
use dalembert_report as _;
use dalembert_tui as _;

#[test]
fn every_sentence_has_its_portuguese() {
    let mut sentences = Sentences::default();
    for entry in registry() {
        let of = entry.family();
        sentences.add(of, entry.about.title);
        sentences.add(of, entry.about.summary);
        sentences.add(of, entry.about.topic);
        sentences.fields(of, entry.fields(), &mut BTreeSet::new());
        for case in cases::cases(entry).unwrap() {
            sentences.case(of, &case);
            let Ok(record) = case.record(entry) else { continue };
            if let Ok(solution) = entry.solve(&record, &Stop::new()) {
                sentences.solution(of, &solution);
            }
        }
    }
    let sources: Vec<(String, String)> =
        source_files().into_iter().map(|path| (crate_of(&path), read(&path))).collect();
    for (of, source) in &sources {
        for literal in literals(source) {
            sentences.add(of, &literal);
        }
    }
    for path in
        source_files().into_iter().filter(|path| path.components().any(|part| part.as_os_str() == "plugins"))
    {
        for literal in sentences_of_an_analysis(&read(&path)) {
            sentences.add(&crate_of(&path), &literal);
        }
    }
    for kind in dalembert_units::Kind::all() {
        sentences.add("units", kind.name());
    }
    let missing: Vec<String> = sentences
        .0
        .iter()
        .filter(|(sentence, _)| !text::is_translated(sentence))
        .map(|(sentence, of)| format!("[{of}] {} = {sentence}", text::key(sentence)))
        .collect();
    assert!(missing.is_empty(), "{} sentences have no Portuguese:\n{}", missing.len(), missing.join("\n"));
}

/// A label is a line of its own: it begins as a sentence does, in both languages.
#[test]
fn labels_begin_with_capitals_in_both_languages() {
    let mut labels = Sentences::default();
    for entry in registry() {
        labels.fields(entry.about.id, entry.fields(), &mut BTreeSet::new());
        for case in cases::cases(entry).unwrap() {
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

/// What people read of a case.
fn words_of(case: &Case) -> Vec<Text> {
    let reasons = case.expect.iter().filter_map(|expected| match &expected.how {
        Hold::Within(_, why) | Hold::Disputed { why, .. } => Some(why.clone()),
        Hold::ToTheLastPlace | Hold::Computed => None,
    });
    [case.title(), case.source.clone(), case.note.clone()].into_iter().chain(reasons).collect()
}

/// Long sentences that begin alike would be translated alike.
#[test]
fn every_sentence_of_a_case_has_a_key_of_its_own() {
    let mut known: BTreeMap<String, String> = BTreeMap::new();
    for entry in registry() {
        for text in cases::cases(entry).unwrap().iter().flat_map(words_of) {
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

#[test]
fn the_translations_are_well_formed_and_use_the_same_arguments() {
    let faults = text::translation_faults();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let mut used: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for path in source_files() {
        for literal in literals(&read(&path)) {
            used.insert(text::key(&literal), arguments(&literal, "{", "}"));
        }
    }
    for path in translation_files() {
        for line in read(&path).lines() {
            let Some((key, sentence)) = line.split_once(" = ") else { continue };
            if let Some(wanted) = used.get(key) {
                let have = arguments(sentence, "{ $", " }");
                assert_eq!(&have, wanted, "{}: {key} has other arguments than the English", path.display());
            }
        }
    }
}

/// Every sentence, and where it is used.
#[derive(Default)]
struct Sentences(BTreeMap<String, String>);

impl Sentences {
    fn add(&mut self, of: &str, sentence: &str) {
        // Symbols, units and numbers are the same in every language, and so is what stands in a place.
        let mut words = sentence.to_owned();
        while let (Some(open), Some(close)) = (words.find('{'), words.find('}')) {
            words.replace_range(open.min(close)..=open.max(close), " ");
        }
        let notation = |word: &str| {
            ["sin", "cos", "tan"].contains(&word)
                || word.chars().filter(char::is_ascii_alphabetic).count() < 3
        };
        if !words.split(|c: char| !c.is_alphabetic()).all(notation) {
            self.0.entry(sentence.to_owned()).or_insert_with(|| of.to_owned());
        }
    }

    fn text(&mut self, of: &str, text: &Text) {
        self.add(of, &text.template);
        for (_, arg) in &text.args {
            if let dalembert_core::Arg::Text(text) = arg {
                self.text(of, text);
            }
        }
    }

    fn fields(&mut self, of: &str, fields: &[Field], seen: &mut BTreeSet<usize>) {
        for field in fields {
            self.add(of, field.label);
            self.add(of, field.help);
            self.shape(of, &field.shape, seen);
        }
    }

    fn shape(&mut self, of: &str, shape: &Shape, seen: &mut BTreeSet<usize>) {
        match shape {
            Shape::Group(fields) | Shape::Table(fields) => self.once(of, fields(), seen),
            Shape::Optional(inner) => self.shape(of, inner(), seen),
            Shape::Rows { item, .. } => self.shape(of, item(), seen),
            Shape::OneOf(variants) => {
                for variant in variants() {
                    self.add(of, variant.label);
                    self.add(of, variant.help);
                    self.once(of, (variant.fields)(), seen);
                }
            }
            _ => {}
        }
    }

    /// A type may contain itself: its fields are visited once.
    fn once(&mut self, of: &str, fields: &'static [Field], seen: &mut BTreeSet<usize>) {
        if !fields.is_empty() && seen.insert(fields.as_ptr() as usize) {
            self.fields(of, fields, seen);
        }
    }

    fn case(&mut self, of: &str, case: &Case) {
        for text in words_of(case) {
            self.text(of, &text);
        }
    }

    fn solution(&mut self, of: &str, solution: &dalembert_core::Solution) {
        solution.steps.iter().for_each(|step| self.text(of, &step.why));
        solution.answers.iter().for_each(|answer| self.add(of, answer.label));
        solution.checks.iter().for_each(|check| self.text(of, &check.what));
        solution.warnings.iter().for_each(|warning| self.text(of, warning));
        for answer in &solution.answers {
            if let dalembert_core::AnswerValue::Set(_, limits) = &answer.value {
                for limit in limits {
                    self.text(of, limit);
                }
            }
        }
        for exhibit in &solution.exhibits {
            match exhibit {
                Exhibit::Plot(plot) => {
                    let texts = [&plot.title, &plot.x.label, &plot.y.label].into_iter();
                    let series = plot.series.iter().map(|series| &series.label);
                    let marks = plot.marks.iter().map(|mark| &mark.label);
                    let bands = plot.bands.iter().map(|band| &band.label);
                    let levels = plot.levels.iter().map(|level| &level.label);
                    texts
                        .chain(series)
                        .chain(marks)
                        .chain(bands)
                        .chain(levels)
                        .for_each(|text| self.text(of, text));
                }
                Exhibit::Table(table) => {
                    self.text(of, &table.title);
                    table.columns.iter().for_each(|column| self.text(of, &column.heading));
                    for cell in table.rows.iter().flatten().chain(&table.foot) {
                        if let Cell::Text(text) = cell {
                            self.text(of, text);
                        }
                    }
                }
                Exhibit::Drawing(drawing) => self.drawing(of, &drawing.title, &drawing.shapes),
                Exhibit::Animation(animation) => {
                    animation.frames.iter().for_each(|frame| self.drawing(of, &animation.title, frame));
                }
                Exhibit::Scene(scene) => (0..scene.frames.len()).for_each(|frame| {
                    let drawing = scene.seen(frame, scene.view);
                    self.drawing(of, &drawing.title, &drawing.shapes);
                }),
            }
        }
    }

    fn drawing(&mut self, of: &str, title: &Text, shapes: &[DrawnShape]) {
        self.text(of, title);
        for shape in shapes {
            if let DrawnShape::Label(.., text) = shape {
                self.text(of, text);
            }
        }
    }
}

/// Every sentence in the code of an analysis: reasons, labels, warnings, in branches that no case takes as well.
fn sentences_of_an_analysis(source: &str) -> BTreeSet<String> {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let mut found = BTreeSet::new();
    for line in joined(code) {
        let exempt = [
            "keywords:",
            "full:",
            "short:",
            "expect(",
            "unreachable!(",
            "panic!(",
            "reason =",
            "//",
            "cases:",
        ];
        let named = |mark: &&str| {
            line.trim_start().starts_with(*mark) || (!mark.starts_with("//") && line.contains(*mark))
        };
        if exempt.iter().any(named) {
            continue;
        }
        // Literals stand at the odd places between quotes.
        for literal in line.replace("\\\"", "'").split('"').skip(1).step_by(2) {
            let words =
                literal.split(' ').filter(|word| word.chars().filter(char::is_ascii_lowercase).count() > 2);
            if words.count() > 1 {
                found.insert(literal.to_owned());
            }
        }
    }
    found
}

/// The lines of a source, those that a trailing backslash continues joined.
fn joined(code: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut open = false;
    for line in code.lines() {
        let (text, continues) = line.strip_suffix('\\').map_or((line, false), |text| (text, true));
        match lines.last_mut() {
            Some(last) if open => *last += text.trim_start(),
            _ => lines.push(text.to_owned()),
        }
        open = continues;
    }
    lines
}

/// The literals of a source that become a [`Text`].
fn literals(source: &str) -> BTreeSet<String> {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let code: Vec<&str> = code.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let code = code.join("\n");
    let mut found = BTreeSet::new();
    let marks = [
        "Text::new(",
        "Text::from(",
        "Refusal::because(",
        "FieldError::new(path, ",
        "mismatch(trail, ",
        "fail(",
        "faults.push(",
        "limit(",
        ".unexpected(",
        "expected: ",
        "after: ",
    ];
    for mark in marks {
        for rest in code.split(mark).skip(1) {
            if let Some(literal) = rest.trim_start().strip_prefix('"') {
                found.insert(unescaped(literal));
            }
        }
    }
    found.remove("");
    found
}

/// A string literal up to its closing quote, its escapes and line joins undone.
fn unescaped(literal: &str) -> String {
    let mut text = String::new();
    let mut chars = literal.chars();
    while let Some(c) = chars.next() {
        match c {
            '"' => break,
            '\\' => match chars.next() {
                Some('n') => text.push('\n'),
                Some('\n') => {
                    let rest = chars.as_str().trim_start();
                    chars = rest.chars();
                }
                Some(other) => text.push(other),
                None => break,
            },
            c => text.push(c),
        }
    }
    text
}

fn arguments(sentence: &str, open: &str, close: &str) -> BTreeSet<String> {
    let parts = sentence.split(open).skip(1).filter_map(|rest| rest.split_once(close));
    parts.map(|(name, _)| name.trim().to_owned()).collect()
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn source_files() -> Vec<PathBuf> {
    files("rs").into_iter().filter(|path| path.components().any(|part| part.as_os_str() == "src")).collect()
}

fn translation_files() -> Vec<PathBuf> {
    files("ftl")
}

/// The files with an ending below crates/ and plugins/.
fn files(ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    // The derive speaks to programmers alone.
    let mut folders =
        ["core", "units", "report", "tui", "dalembert"].map(|name| root().join("crates").join(name)).to_vec();
    folders.push(root().join("plugins"));
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|have| have == ending) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn crate_of(path: &Path) -> String {
    let parts: Vec<_> =
        path.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
    parts.iter().position(|part| part == "src").map_or_else(String::new, |at| parts[at - 1].clone())
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}
