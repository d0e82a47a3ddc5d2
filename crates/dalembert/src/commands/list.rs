//! `dalembert list`

use std::process::ExitCode;

use dalembert_core::{
    Entry, Locale, Text,
    cases::{self, Case},
    catalogue, find,
    search::{self, Found, Index},
};
use dalembert_report::{Block, Document, NamedValue};
use serde_json::{Value as Json, json};

use crate::{
    arguments::List,
    console::{Console, print_json},
    failure::Failure,
};

/// Lists the analyses by family, or those that a search leaves, the best match first.
pub(crate) fn run(list: &List, console: &Console) -> Result<ExitCode, Failure> {
    if list.json {
        print_json(&json(&list.filter, &console.locale))?;
        return Ok(ExitCode::SUCCESS);
    }
    let found = matching(&list.filter);
    if found.is_empty() {
        let why = Text::new("no analysis matches {filter}; `dalembert list` shows them all");
        return Err(Failure::input(why.with("filter", list.filter.join(" "))));
    }
    let mut blocks = Vec::new();
    if list.filter.is_empty() {
        for family in found.chunk_by(|a, b| a.entry.family() == b.entry.family()) {
            blocks.push(Block::Heading(family[0].entry.family().to_owned()));
            blocks.push(Block::Lines(family.iter().map(|found| found.line(&console.locale)).collect()));
        }
    } else {
        blocks.push(Block::Lines(found.iter().map(|found| found.line(&console.locale)).collect()));
    }
    console.print(Document { title: String::new(), blocks })?;
    Ok(ExitCode::SUCCESS)
}

/// The analyses of a search for another program, the best match first.
pub(crate) fn json(filter: &[String], locale: &Locale) -> Json {
    matching(filter).iter().map(|found| described(found.entry, locale)).collect()
}

/// Texts that a search compares, for another program that searches as this one does: those of every analysis, folded, with
/// the words and endings that do not count.
pub(crate) fn index() -> Json {
    let of = |entry: &&'static Entry| {
        let index = Index::of(entry, &cases::cases(entry).unwrap_or_default());
        json!({
            "id": entry.about.id,
            "names": index.names,
            "keywords": index.keywords,
            "words": index.words,
            "inputs": index.inputs,
            "cases": index.cases,
        })
    };
    json!({
        "analyses": catalogue().iter().map(of).collect::<Vec<_>>(),
        "small_words": search::SMALL_WORDS,
        "optional_words": search::OPTIONAL_WORDS,
        "standards": search::STANDARDS,
        "endings": search::ENDINGS,
        "stem": search::STEM,
        "within": search::WITHIN,
        "joined": search::JOINED,
    })
}

/// An analysis that a search leaves, and the case that the words speak of.
struct Match {
    entry: &'static Entry,
    case: Option<Case>,
}

impl Match {
    fn line(&self, locale: &Locale) -> NamedValue {
        let about = self.entry.about;
        let locale = &locale.at(about.id);
        let title = Text::from(about.title).render(locale);
        let value = match &self.case {
            Some(case) => format!("{title} ▸ {}", case.title().render(locale)),
            None => title,
        };
        NamedValue { label: about.id.to_owned(), value, ..NamedValue::default() }
    }
}

/// The analyses of a search, the best match first; all without words.
fn matching(filter: &[String]) -> Vec<Match> {
    searched(filter, search::find)
}

/// The analysis of an id, or those in which every word is found, in the order of their ids.
pub(crate) fn with_words(filter: &[String]) -> Vec<&'static Entry> {
    if let [id] = filter
        && let Some(entry) = find(id)
    {
        return vec![entry];
    }
    let mut found: Vec<&'static Entry> =
        searched(filter, search::find_words).into_iter().map(|found| found.entry).collect();
    found.sort_by_key(|entry| entry.about.id);
    found
}

fn searched(filter: &[String], search: fn(&[&Index], &str) -> Vec<Found>) -> Vec<Match> {
    let filter = filter.join(" ");
    if filter.trim().is_empty() {
        return catalogue().iter().map(|&entry| Match { entry, case: None }).collect();
    }
    let mut cases: Vec<Vec<Case>> =
        catalogue().iter().map(|entry| cases::cases(entry).unwrap_or_default()).collect();
    let indices: Vec<Index> =
        catalogue().iter().zip(&cases).map(|(entry, cases)| Index::of(entry, cases)).collect();
    let found = search(&indices.iter().collect::<Vec<_>>(), &filter);
    let matched = |found: Found| Match {
        entry: catalogue()[found.place],
        case: found.case.map(|case| cases[found.place].swap_remove(case)),
    };
    found.into_iter().map(matched).collect()
}

fn described(entry: &Entry, locale: &Locale) -> Json {
    let about = entry.about;
    let locale = &locale.at(about.id);
    let cases = cases::cases(entry).unwrap_or_default();
    json!({
        "id": about.id,
        "family": entry.family(),
        "family_name": search::family(entry.family()).render(locale),
        "topic": Text::from(about.topic).render(locale),
        "title": Text::from(about.title).render(locale),
        "summary": Text::from(about.summary).render(locale),
        "sources": about.sources.iter().map(|source| source.short).collect::<Vec<_>>(),
        "cases": cases.len(),
        "exercises": cases.iter().filter(|case| !case.statement.is_empty()).count(),
    })
}
