//! Lists of exercises: named sequences of published cases, to be worked through.
//!
//! ```toml
//! title = "Vibration: lists 06 to 08"
//! title-pt-BR = "Vibrações: listas 06 a 08"
//!
//! [[exercise]]
//! analysis = "vibration/shaft-clearance"
//! case = "Francis turbine"
//! ```

use std::collections::BTreeMap;

use toml_edit::{Document, Item, Key, Table};

use crate::{
    Language, Text, cases,
    file::{self, FileError},
    find,
    path::nearest,
};

/// The text of a list that comes with the program.
#[doc(hidden)]
pub struct Bundled(pub &'static str);

inventory::collect!(Bundled);

/// Adds a list of exercises, a TOML file beside the code, to those that everybody is offered.
#[macro_export]
macro_rules! exercises {
    ($path:literal) => {
        $crate::inventory::submit! { $crate::exercises::Bundled(include_str!($path)) }
    };
}

/// A list of exercises.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exercises {
    title: String,
    portuguese: Option<String>,
    /// Exercises, in order.
    pub list: Vec<Exercise>,
}

/// An exercise: a published case of an analysis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exercise {
    /// The id of the analysis.
    pub analysis: String,
    /// The name of the case; empty for the first one.
    pub case: String,
}

impl Exercises {
    /// Title in a language.
    pub fn title(&self, language: Language) -> &str {
        match (&self.portuguese, language) {
            (Some(title), Language::Portuguese) => title,
            _ => &self.title,
        }
    }
}

/// Reads a list; whether there are such analyses and cases is another question, see [`unknown`].
///
/// # Errors
/// Everything that is wrong with it.
pub fn read(text: &str) -> Result<Exercises, Vec<FileError>> {
    let document = file::document(text)?;
    let table = document.as_table();
    let word = |item: Option<&Item>| item.and_then(Item::as_str).map(str::to_owned);
    let mut errors = Vec::new();
    let title = word(table.get("title"));
    if title.is_none() {
        errors.push(FileError { why: Text::new("`title = \"…\"` is required"), span: None });
    }
    let exercises = tables(&document);
    if exercises.is_empty() {
        let why = Text::new("at least one `[[exercise]]` with `analysis = \"family/name\"` is required");
        errors.push(FileError { why, span: None });
    }
    let mut list = Vec::new();
    for exercise in exercises {
        for (key, _) in exercise.iter().filter(|(key, _)| !["analysis", "case"].contains(key)) {
            let why = Text::new("`{key}` is neither `analysis` nor `case`").with("key", key);
            errors.push(FileError { why, span: exercise.key(key).and_then(Key::span) });
        }
        match word(exercise.get("analysis")) {
            Some(analysis) => {
                list.push(Exercise { analysis, case: word(exercise.get("case")).unwrap_or_default() });
            }
            None => {
                let why = Text::new("an exercise requires `analysis = \"family/name\"`");
                errors.push(FileError { why, span: exercise.span() });
            }
        }
    }
    match title {
        Some(title) if errors.is_empty() => {
            Ok(Exercises { title, portuguese: word(table.get("title-pt-BR")), list })
        }
        _ => Err(errors),
    }
}

/// The analyses and cases of a list that there are not.
pub fn unknown(text: &str) -> Vec<FileError> {
    let Ok(document) = file::document(text) else { return Vec::new() };
    // Exercises of one analysis follow one another, and its cases are many.
    let mut names: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    let mut errors = Vec::new();
    for exercise in tables(&document) {
        let word = |key: &str| Some((exercise.get(key)?.as_str()?, exercise.get(key)?.span()));
        let Some((id, span)) = word("analysis") else { continue };
        let Some(entry) = find(id) else {
            errors.push(FileError { why: file::no_such_analysis(id), span });
            continue;
        };
        let Some((name, span)) = word("case").filter(|(name, _)| !name.is_empty()) else { continue };
        let names = names.entry(id).or_insert_with(|| {
            cases::cases(entry).unwrap_or_default().into_iter().map(|case| case.name).collect()
        });
        if names.iter().all(|known| known != name) {
            let why = match nearest(name, names.iter().map(String::as_str)) {
                Some(near) => {
                    Text::new("{analysis} has no case `{name}`; did you mean `{near}`?").with("near", near)
                }
                None => Text::new("{analysis} has no case `{name}`; `dalembert show {analysis}` lists them"),
            };
            errors.push(FileError { why: why.with("analysis", id).with("name", name), span });
        }
    }
    errors
}

fn tables<'d>(document: &'d Document<&str>) -> Vec<&'d Table> {
    let all = document.as_table().get("exercise").and_then(Item::as_array_of_tables);
    all.map_or_else(Vec::new, |all| all.iter().collect())
}

/// The lists that come with the program, in the order of their English titles.
pub fn bundled() -> Vec<Result<Exercises, Vec<FileError>>> {
    let mut all: Vec<_> = inventory::iter::<Bundled>().map(|shipped| read(shipped.0)).collect();
    all.sort_by(|a, b| {
        let title = |one: &Result<Exercises, _>| one.as_ref().map(|one| one.title.clone()).ok();
        title(a).cmp(&title(b))
    });
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_read_or_said_to_be_wrong() {
        let text = "title = \"A\"\ntitle-pt-BR = \"B\"\n[[exercise]]\nanalysis = \"x/y\"\n[[exercise]]\nanalysis = \"x/z\"\ncase = \"c\"\n";
        let list = read(text).unwrap();
        assert_eq!((list.title(Language::English), list.title(Language::Portuguese)), ("A", "B"));
        assert_eq!(list.list[1], Exercise { analysis: "x/z".into(), case: "c".into() });
        for (wrong, said) in [
            ("", "title"),
            ("title = \"A\"", "[[exercise]]"),
            ("title = \"A\"\n[[exercise]]\n", "analysis"),
            ("title = \"A\"\n[[exercise]]\nanalysis = \"x/y\"\nanswer = 1\n", "answer"),
            ("title = ", "string"),
        ] {
            let errors = read(wrong).unwrap_err();
            let all: Vec<String> = errors.iter().map(|error| error.why.english()).collect();
            assert!(all.iter().any(|error| error.contains(said)), "{wrong:?}: {all:?}");
        }
    }
}
