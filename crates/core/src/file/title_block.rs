//! Title block of a calculation note: `[title_block]` of a problem file.

use toml_edit::{Item, Table};

use super::{FileError, write::set_text};
use crate::{Text, path::nearest};

/// Table of a problem file.
pub(super) const TABLE: &str = "title_block";

/// Keys with their labels, in the order in which they are printed.
const LINES: [(&str, &str); 5] = [
    ("project", "Project"),
    ("author", "Prepared by"),
    ("checker", "Checked by"),
    ("date", "Date"),
    ("revision", "Revision"),
];

/// Project, author, checker, date and revision of a note; each may be absent.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TitleBlock([String; LINES.len()]);

impl TitleBlock {
    /// Keys of the lines.
    pub fn keys() -> [&'static str; LINES.len()] {
        LINES.map(|(key, _)| key)
    }

    /// Sets the text of a key.
    ///
    /// # Errors
    /// A key that is none, with the nearest one.
    pub fn set(&mut self, key: &str, text: &str) -> Result<(), Text> {
        match LINES.iter().position(|(known, _)| *known == key) {
            Some(at) => text.trim().clone_into(&mut self.0[at]),
            None => {
                return Err(match nearest(key, Self::keys().into_iter()) {
                    Some(near) => {
                        Text::new("a title block has no `{key}`; did you mean `{near}`?").with("near", near)
                    }
                    None => Text::new("a title block has no `{key}`; it has {keys}")
                        .with("keys", Self::keys().join(", ")),
                }
                .with("key", key));
            }
        }
        Ok(())
    }

    /// Labels and texts of the lines that are there.
    pub fn lines(&self) -> impl Iterator<Item = (Text, &str)> {
        let lines = LINES.iter().zip(&self.0).filter(|(_, text)| !text.is_empty());
        lines.map(|((_, label), text)| (Text::from(*label), text.as_str()))
    }

    pub(super) fn read(root: &Table, errors: &mut Vec<FileError>) -> Self {
        let mut block = Self::default();
        let Some(item) = root.get(TABLE) else { return block };
        let Some(table) = item.as_table_like() else {
            let why = Text::from("`title_block` is a table, as in [title_block] author = \"A. Silva\"");
            errors.push(FileError { why, span: item.span() });
            return block;
        };
        for (key, item) in table.iter() {
            let text = text_of(item).ok_or_else(|| Text::from("a line of a title block is a text"));
            if let Err(why) = text.and_then(|text| block.set(key, &text)) {
                errors.push(FileError { why, span: item.span() });
            }
        }
        block
    }

    pub(super) fn write(&self, root: &mut Table) {
        for ((key, _), text) in LINES.iter().zip(&self.0).filter(|(_, text)| !text.is_empty()) {
            let block = root.entry(TABLE).or_insert_with(|| Item::Table(Table::new()));
            if let Some(block) = block
                .as_table_like_mut()
                .filter(|block| block.get(key).and_then(text_of).is_none_or(|before| before.trim() != text))
            {
                set_text(block, key, text);
            }
        }
    }
}

/// A text; dates and numbers may stand without quotation marks.
fn text_of(item: &Item) -> Option<String> {
    let date = || item.as_datetime().map(ToString::to_string);
    let number = || item.as_integer().map(|number| number.to_string());
    item.as_str().map(str::to_owned).or_else(date).or_else(number)
}
