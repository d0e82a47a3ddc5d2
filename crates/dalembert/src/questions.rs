//! The usual questions of an analysis, on the command line.

use dalembert_core::{
    Draft, Entry, Text, UnitSetting, nearest,
    suggestions::{Suggestion, suggestions},
};

use crate::{console::Console, failure::Failure, solving::solve};

/// Asks the usual questions that `--ask` names, by their words or their keys, in the units of a setting; says what is wrong with those that the
/// problem does not offer. A problem that cannot be read or has no answer is reported where it is solved.
pub(crate) fn ask_usual(
    draft: &mut Draft,
    entry: &'static Entry,
    units: UnitSetting,
    asked: &[String],
    console: &Console,
) -> Result<Vec<Text>, Failure> {
    let names: Vec<&str> = asked.iter().map(String::as_str).filter(|text| !text.contains('=')).collect();
    let shape = entry.shape();
    let (false, Ok(record)) = (names.is_empty(), draft.read(&shape)) else { return Ok(Vec::new()) };
    let Ok(solution) = solve(entry, &record)? else { return Ok(Vec::new()) };
    let offered = suggestions(entry, &solution.in_units_of(units, draft, &shape));
    let locale = console.locale.at(entry.about.id);
    let mut errors = Vec::new();
    for name in names {
        match offered.iter().find(|suggestion| suggestion.is(name, &locale)) {
            Some(suggestion) => {
                if let Err(error) = suggestion.ask(draft, &shape, &locale) {
                    errors.push(error.why);
                }
            }
            None => errors.push(unknown(name, &offered)),
        }
    }
    Ok(errors)
}

fn unknown(name: &str, offered: &[Suggestion]) -> Text {
    let keys: Vec<String> = offered.iter().map(Suggestion::name).collect();
    let text = match nearest(name.trim(), keys.iter().map(String::as_str)) {
        Some(near) => Text::new("--ask {name}: there is no such usual question here; did you mean `{near}`?")
            .with("near", near),
        None if offered.is_empty() => {
            Text::new("--ask {name}: write a name and a formula, as in --ask 'peak to peak=2*X'")
        }
        None => Text::new(
            "--ask {name}: write a name and a formula, as in --ask 'peak to peak=2*X', or one of {known}",
        )
        .with("known", keys.join(", ")),
    };
    text.with("name", name)
}
