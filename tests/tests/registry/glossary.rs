//! Things are found by their names in the field, and every word of a name has its place in the glossary.

use std::collections::BTreeSet;

use dalembert_core::registry;
use dalembert_plugins as _;
use dalembert_testkit::{SolvedCase, for_each_problem};
use xtask::{
    find::{Index, public_names, words},
    root,
    tidy::Tree,
};

#[test]
fn a_term_of_the_field_leads_to_its_one_file() {
    let tree = Tree::read(&root()).expect("the tree can be read");
    let text = std::fs::read_to_string(root().join("docs/finding.toml")).expect("the list is there");
    let expected: toml_edit::DocumentMut = text.parse().expect("the list is TOML");
    assert!(expected.len() >= 40, "{} terms", expected.len());
    let index = Index::of(&tree);
    let wrong: Vec<String> = expected
        .iter()
        .filter_map(|(term, file)| {
            let file = file.as_str().expect("a path in quotes");
            let found = index.find(term);
            (found != [file]).then(|| format!("{term}: {found:?} and not {file}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A word that is neither in the glossary nor in its list of general words is private, or has still to be entered.
#[test]
fn every_word_of_a_public_name_and_of_a_label_is_in_the_glossary() {
    let glossary = std::fs::read_to_string(root().join("docs/glossary.md")).expect("the glossary is there");
    let (terms, _) = glossary.split_once("## Traps of translation").expect("the tables end there");
    let known: BTreeSet<String> = words(terms).into_iter().chain(general(&glossary)).collect();
    let tree = Tree::read(&root()).expect("the tree can be read");
    let mut missing: BTreeSet<String> = BTreeSet::new();
    for name in ["crates/", "plugins/"].map(|folder| public_names(&tree, folder)).into_iter().flatten() {
        let words = words(&name);
        let unknown = plain(&words).filter(|word| !known.contains(*word));
        missing.extend(unknown.map(|word| format!("{word} (in the name `{name}`)")));
    }
    let mut labels = 0;
    for_each_problem(registry(), |SolvedCase { solution, .. }| {
        for answer in &solution.answers {
            labels += 1;
            let words = words(answer.label);
            let unknown = plain(&words).filter(|word| !known.contains(*word));
            missing.extend(unknown.map(|word| format!("{word} (in {:?})", answer.label)));
        }
    });
    assert!(labels > 2000, "{labels} labels");
    let mut seen = BTreeSet::new();
    missing.retain(|line| seen.insert(line.split(' ').next().unwrap_or_default().to_owned()));
    assert!(
        missing.is_empty(),
        "{} words:\n{}",
        missing.len(),
        missing.into_iter().collect::<Vec<_>>().join("\n")
    );
}

/// Words alone: formulas and symbols have a place of their own.
fn plain(words: &BTreeSet<String>) -> impl Iterator<Item = &String> {
    words.iter().filter(|word| word.chars().all(|c| c.is_ascii_lowercase()))
}

/// The general English words that the glossary lists at its end.
fn general(glossary: &str) -> BTreeSet<String> {
    let (_, below) = glossary.split_once("## General words").expect("the glossary lists them");
    words(below.split("\n## ").next().unwrap_or_default())
}
