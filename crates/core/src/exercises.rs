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

use toml_edit::Item;

use crate::{Language, file};

/// The text of a list that comes with the program.
#[doc(hidden)]
pub struct Shipped(pub &'static str);

inventory::collect!(Shipped);

/// Adds a list of exercises, a TOML file beside the code, to those that everybody is offered.
#[macro_export]
macro_rules! exercises {
    ($path:literal) => {
        $crate::inventory::submit! { $crate::exercises::Shipped(include_str!($path)) }
    };
}

/// A list of exercises.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exercises {
    title: String,
    portuguese: Option<String>,
    /// Its exercises, in their order.
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
    /// Its title.
    pub fn title(&self, language: Language) -> &str {
        match (&self.portuguese, language) {
            (Some(title), Language::Portuguese) => title,
            _ => &self.title,
        }
    }
}

/// Reads a list. `Err` says what is wrong with it, in English.
pub fn read(text: &str) -> Result<Exercises, String> {
    let document = file::document(text)
        .map_err(|errors| errors.iter().map(|error| error.why.english()).collect::<Vec<_>>().join("; "))?;
    let table = document.as_table();
    let word = |item: Option<&Item>| item.and_then(Item::as_str).map(str::to_owned);
    let title = word(table.get("title")).ok_or("it needs `title = \"…\"`")?;
    let exercises = table
        .get("exercise")
        .and_then(Item::as_array_of_tables)
        .ok_or("it needs one `[[exercise]]` at least, with `analysis = \"family/name\"`")?;
    let list = exercises
        .iter()
        .enumerate()
        .map(|(n, exercise)| {
            let unknown = exercise.iter().map(|(key, _)| key).find(|key| !["analysis", "case"].contains(key));
            if let Some(key) = unknown {
                return Err(format!("exercise {}: `{key}` is neither `analysis` nor `case`", n + 1));
            }
            let analysis = word(exercise.get("analysis"))
                .ok_or_else(|| format!("exercise {}: it needs `analysis = \"family/name\"`", n + 1))?;
            Ok(Exercise { analysis, case: word(exercise.get("case")).unwrap_or_default() })
        })
        .collect::<Result<_, String>>()?;
    Ok(Exercises { title, portuguese: word(table.get("title-pt-BR")), list })
}

/// The lists that come with the program, in the order of their English titles.
pub fn shipped() -> Vec<Result<Exercises, String>> {
    let mut all: Vec<_> = inventory::iter::<Shipped>().map(|shipped| read(shipped.0)).collect();
    all.sort_by(|a, b| {
        let title = |one: &Result<Exercises, String>| one.as_ref().map(|one| one.title.clone()).ok();
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
            let error = read(wrong).unwrap_err();
            assert!(error.contains(said), "{wrong:?}: {error}");
        }
    }
}
