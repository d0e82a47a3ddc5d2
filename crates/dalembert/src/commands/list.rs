//! `dalembert list`

use std::process::ExitCode;

use dalembert_core::{Entry, Locale, Text, cases, registry};
use dalembert_report::{Block, Document, NamedValue};
use serde_json::{Value as Json, json};

use crate::{
    arguments::List,
    console::{Console, print_json},
    failure::Failure,
};

/// Lists the analyses by family.
pub(crate) fn run(list: &List, console: &Console) -> Result<ExitCode, Failure> {
    let found = matching(&list.filter);
    if list.json {
        print_json(&found.iter().map(|entry| described(entry, &console.locale)).collect())?;
        return Ok(ExitCode::SUCCESS);
    }
    if found.is_empty() {
        let why = Text::new("no analysis matches {filter}; `dalembert list` shows them all");
        return Err(Failure::input(why.with("filter", list.filter.join(" "))));
    }
    let mut blocks = Vec::new();
    for family in found.chunk_by(|a, b| a.family() == b.family()) {
        blocks.push(Block::Heading(family[0].family().to_owned()));
        let line = |entry: &&'static Entry| NamedValue {
            label: entry.about.id.to_owned(),
            value: Text::from(entry.about.title).render(&console.locale),
            ..NamedValue::default()
        };
        blocks.push(Block::Lines(family.iter().map(line).collect()));
    }
    console.print(Document { title: String::new(), blocks })?;
    Ok(ExitCode::SUCCESS)
}

/// The analyses in which every word is found: in the id, the keywords, or title and summary in either language.
pub(crate) fn matching(filter: &[String]) -> Vec<&'static Entry> {
    let words: Vec<String> =
        filter.iter().flat_map(|words| words.split_whitespace()).map(str::to_lowercase).collect();
    let holds = |entry: &&&'static Entry| {
        let about = entry.about;
        let reported = |locale: Locale| {
            let say = |words: &'static str| Text::from(words).render(&locale.at(about.id));
            format!("{} {}", say(about.title), say(about.summary))
        };
        let text = [about.id, about.keywords, &reported(Locale::english()), &reported(Locale::portuguese())]
            .join(" ")
            .to_lowercase();
        words.iter().all(|word| text.contains(word.as_str()))
    };
    registry().iter().filter(holds).copied().collect()
}

fn described(entry: &Entry, locale: &Locale) -> Json {
    let about = entry.about;
    let locale = &locale.at(about.id);
    json!({
        "id": about.id,
        "family": entry.family(),
        "title": Text::from(about.title).render(locale),
        "summary": Text::from(about.summary).render(locale),
        "sources": about.sources.iter().map(|source| source.short).collect::<Vec<_>>(),
        "cases": cases::cases(entry).map_or(0, |cases| cases.len()),
    })
}
