//! Statement of an exercise as it is written in a case or a problem file.
//!
//! ```toml
//! statement = "A fan of 40 kg runs at 1000 rpm …"
//! asked = ["amplitude"]
//!
//! [vary]
//! mass = "30 kg .. 60 kg : 5 kg"
//! ```

use toml_edit::{Item, TableLike};

use crate::Text;

/// Statement of an exercise: its sentences, the answers it asks for and the ranges of its data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statement {
    /// Sentences; empty where there are none.
    pub text: Text,
    /// Names of the answers that are asked for, in their order; empty where none is named.
    pub asked: Vec<String>,
    /// Ranges of the data of variants, by the paths of their inputs; empty where none is declared.
    pub vary: Vec<(String, String)>,
}

impl Statement {
    /// Statement of a table.
    ///
    /// # Errors
    /// The key that is wrong, and why.
    pub(crate) fn of(table: &dyn TableLike) -> Result<Self, (&'static str, Text)> {
        let text = match table.get("statement").map(Item::as_str) {
            None => String::new(),
            Some(Some(text)) => words(text),
            Some(None) => return Err(("statement", Text::new("write the statement as a text in quotes"))),
        };
        let asked = match table.get("asked") {
            None => Vec::new(),
            Some(_) if text.is_empty() => return Err(("asked", "`asked` needs a `statement`".into())),
            Some(item) => names(item).ok_or(("asked", Text::new(ASKED)))?,
        };
        Ok(Self { text: Text::new(text), asked, vary: vary(table).map_err(|why| ("vary", why))? })
    }
}

/// Repair of a list of asked answers.
const ASKED: &str = "write the answers that the statement asks for as in `asked = [\"amplitude\"]`";

/// A text on several lines as one.
pub(crate) fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn names(item: &Item) -> Option<Vec<String>> {
    let names = item.as_array()?.iter().map(|name| name.as_str().map(str::to_owned));
    names.collect::<Option<Vec<_>>>().filter(|names| !names.is_empty())
}

/// Ranges of `[vary]`; inputs within a group may be written as nested tables.
pub(crate) fn vary(table: &dyn TableLike) -> Result<Vec<(String, String)>, Text> {
    fn flatten(prefix: &str, item: &Item, found: &mut Vec<(String, String)>) -> Result<(), Text> {
        match (item.as_str(), item.as_table_like()) {
            (Some(range), _) => found.push((prefix.to_owned(), range.to_owned())),
            (None, Some(table)) => {
                for (key, item) in table.iter() {
                    let path = if prefix.is_empty() { key.to_owned() } else { format!("{prefix}.{key}") };
                    flatten(&path, item, found)?;
                }
            }
            (None, None) => {
                let why = Text::new("write the range of {path} as in `mass = \"30 kg .. 60 kg : 5 kg\"`");
                return Err(why.with("path", if prefix.is_empty() { "vary" } else { prefix }));
            }
        }
        Ok(())
    }
    let mut found = Vec::new();
    if let Some(item) = table.get("vary") {
        flatten("", item, &mut found)?;
    }
    Ok(found)
}
