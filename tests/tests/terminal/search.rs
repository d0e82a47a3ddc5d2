//! Search in the list of analyses, by the words that textbooks use: one for the workbench and the command line.

use std::collections::BTreeMap;

use dalembert_core::{
    Entry, cases, catalogue, registry,
    search::{self, Index},
};
use dalembert_plugins as _;
use dalembert_tests::person::Person;
use dalembert_tui::picker::Row;
use serde::Deserialize;

/// Words, names and headings, and the analysis that stands among the first three.
const QUERIES: &str = include_str!("../../data/queries.toml");

#[derive(Deserialize)]
struct Queries {
    words: BTreeMap<String, String>,
    /// By the work that has the heading.
    english: BTreeMap<String, BTreeMap<String, String>>,
    portuguese: BTreeMap<String, BTreeMap<String, String>>,
}

fn queries() -> Queries {
    toml::from_str(QUERIES).expect("the queries can be read")
}

/// The analyses of a search, the best match first.
fn found(words: &str) -> Vec<&'static Entry> {
    let indices: Vec<Index> = registry()
        .iter()
        .map(|entry| Index::of(entry, &cases::cases(entry).expect("the cases can be read")))
        .collect();
    let indices: Vec<&Index> = indices.iter().collect();
    search::find(&indices, words).into_iter().map(|found| registry()[found.place]).collect()
}

/// The queries for which the analysis is not among the first three of these entries.
fn missed<'q>(
    entries: &[&'static Entry],
    queries: impl Iterator<Item = (&'q String, &'q String)>,
) -> Vec<String> {
    let indices: Vec<Index> = entries
        .iter()
        .map(|entry| Index::of(entry, &cases::cases(entry).expect("the cases can be read")))
        .collect();
    let indices: Vec<&Index> = indices.iter().collect();
    let mut missed = Vec::new();
    for (words, id) in queries {
        // Capitals and accents do not matter.
        for words in [words.clone(), words.to_uppercase(), dalembert_core::ascii(words)] {
            let found = search::find(&indices, &words).into_iter().take(3);
            let first: Vec<&str> = found.map(|found| entries[found.place].about.id).collect();
            if !first.contains(&id.as_str()) {
                missed.push(format!("{words}: {id} is not among {first:?}"));
            }
        }
    }
    missed
}

#[test]
fn words_of_textbooks_find_their_analysis_among_the_first_three() {
    let missed = missed(registry(), queries().words.iter());
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
fn of_sixty_headings_of_textbooks_nearly_all_find_their_analysis_among_the_first_three() {
    let queries = queries();
    for books in [&queries.english, &queries.portuguese] {
        assert_eq!(books.values().map(BTreeMap::len).sum::<usize>(), 30);
    }
    let headings = queries.english.values().chain(queries.portuguese.values()).flatten();
    let missed = missed(catalogue(), headings);
    assert!(missed.len() <= 3 * 3, "each is asked in three ways:\n{}", missed.join("\n"));
}

#[test]
fn symbols_and_labels_of_inputs_and_answers_are_searched() {
    for (words, id) in [
        ("m₀e", "vibration/rotating-unbalance"),
        ("speed of the machine", "vibration/rotating-unbalance"),
        ("rotação da máquina", "vibration/rotating-unbalance"),
        ("wire diameter", "vibration/rotating-unbalance"),
        ("peak frequency", "vibration/rotating-unbalance"),
    ] {
        assert!(found(words).iter().any(|entry| entry.about.id == id), "{words}");
    }
}

#[test]
fn the_workbench_and_the_command_line_find_the_same() {
    for words in ["critical speed", "khurmi", "pião", "rotunb", "V-twin"] {
        let mut person = Person::at(80, 24);
        person.types("/").types(words);
        let rows = person.model.picker.rows(person.model.contents());
        let shown: Vec<&str> = rows
            .iter()
            .filter_map(|row| match row {
                Row::Leaf(leaf) => Some(person.model.listings[leaf.listing].entry.about.id),
                Row::Heading(_) => None,
            })
            .collect();
        assert_eq!(shown, found(words).iter().map(|entry| entry.about.id).collect::<Vec<_>>(), "{words}");
    }
}
