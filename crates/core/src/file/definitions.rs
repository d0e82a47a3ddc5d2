//! The tables `[let]`, `[ask]` and `[given]` of a problem file: definitions, questions and given answers.

use toml_edit::{Item, Table, TableLike, Value as Toml};

use super::{FileError, FileNotes, plain, set_text};
use crate::{Draft, Shape, Text, path};

/// The keys of a question that is a table.
const QUESTION: [&str; 4] = ["value", "unit", "symbol", "key"];

/// Adds what the tables of a file say to the draft of its inputs.
pub(crate) fn read(root: &dyn TableLike, shape: &Shape, draft: &mut Draft, reading: &mut FileNotes) {
    let rows = pairs(root, "let", "a quantity or a formula in quotes is needed here", reading);
    put(draft, shape, "let", rows);
    let rows = questions(root, reading);
    put(draft, shape, "ask", rows);
    let rows = pairs(root, "given", "a quantity in quotes is needed here, as in \"8.2 Hz\"", reading);
    put(draft, shape, "given", rows);
}

fn put(draft: &mut Draft, shape: &Shape, field: &str, rows: Vec<Draft>) {
    let Draft::Group(all) = draft else { return };
    let Some(at) = shape.fields(None).iter().position(|known| known.name == field) else { return };
    while all.len() <= at {
        all.push(Draft::Rows(Vec::new()));
    }
    all[at] = Draft::Rows(rows);
}

fn table<'d>(root: &'d dyn TableLike, key: &str, reading: &mut FileNotes) -> Option<&'d dyn TableLike> {
    let item = root.get(key)?;
    let table = item.as_table_like();
    if table.is_none() {
        let example = if key == "given" { "natural_frequency = \"8.2 Hz\"" } else { "nu = \"0.3\"" };
        let why = Text::new("`{key}` is a table of names and formulas, as in [{key}] {example}")
            .with("key", key)
            .with("example", example);
        reading.errors.push(FileError { why, span: item.span() });
    }
    table
}

/// Rows of a table of names and texts.
fn pairs(
    root: &dyn TableLike,
    key: &'static str,
    needed: &'static str,
    reading: &mut FileNotes,
) -> Vec<Draft> {
    let Some(table) = table(root, key, reading) else { return Vec::new() };
    let mut rows = Vec::new();
    for (name, item) in table.iter() {
        match formula(item) {
            Some(text) => rows.push(Draft::Group(vec![Draft::Leaf(name.to_owned()), Draft::Leaf(text)])),
            None => reading.errors.push(FileError {
                why: Text::new("{path}: {why}")
                    .with("path", format!("{key}.{name}"))
                    .with_text("why", needed),
                span: item.span(),
            }),
        }
    }
    rows
}

fn questions(root: &dyn TableLike, reading: &mut FileNotes) -> Vec<Draft> {
    let Some(table) = table(root, "ask", reading) else { return Vec::new() };
    let mut rows = Vec::new();
    for (name, item) in table.iter() {
        let details = item.as_table_like();
        let value = details.map_or_else(|| formula(item), |details| details.get("value").and_then(formula));
        let Some(value) = value else {
            let why = "a formula is needed here, as in \"2*X\"";
            reading.errors.push(FileError {
                why: Text::new("{path}: {why}").with("path", format!("ask.{name}")).with_text("why", why),
                span: item.span(),
            });
            continue;
        };
        for (key, item) in details.into_iter().flat_map(TableLike::iter) {
            if !QUESTION.contains(&key) {
                reading.errors.push(FileError {
                    why: path::unknown("", key, QUESTION.into_iter()).why,
                    span: item.span(),
                });
            }
        }
        let part = |key: &str| {
            let text = details.and_then(|details| details.get(key)).and_then(Item::as_str);
            text.map_or(Draft::Absent, |text| Draft::Leaf(text.to_owned()))
        };
        rows.push(Draft::Group(vec![
            Draft::Leaf(name.to_owned()),
            Draft::Leaf(value),
            part("unit"),
            part("symbol"),
            part("key"),
        ]));
    }
    rows
}

fn formula(item: &Item) -> Option<String> {
    match item.as_value()? {
        value @ (Toml::String(_) | Toml::Integer(_) | Toml::Float(_)) => Some(plain(value)),
        _ => None,
    }
}

/// Writes the definitions, questions and given answers of a draft into the tables of a file, in their order; what is gone is taken out.
pub(crate) fn write(root: &mut Table, draft: &Draft, shape: &Shape) {
    for field in ["let", "ask", "given"] {
        let rows = match draft.at(shape, field) {
            Ok((Draft::Rows(rows), _)) => rows.as_slice(),
            _ => &[],
        };
        if rows.is_empty() && !root.contains_key(field) {
            continue;
        }
        let item = root.entry(field).or_insert_with(|| Item::Table(Table::new()));
        let Some(table) = item.as_table_like_mut() else { continue };
        let names: Vec<&str> = rows.iter().map(|row| leaf(row, 0)).collect();
        let gone: Vec<String> = table
            .iter()
            .map(|(name, _)| name.to_owned())
            .filter(|name| !names.contains(&name.as_str()))
            .collect();
        for name in gone {
            table.remove(&name);
        }
        for row in rows {
            let (name, value) = (leaf(row, 0), leaf(row, 1));
            let details: Vec<(&str, &str)> = [("unit", 2), ("symbol", 3), ("key", 4)]
                .into_iter()
                .map(|(key, at)| (key, leaf(row, at)))
                .filter(|(_, text)| !text.is_empty())
                .collect();
            if details.is_empty() {
                set_text(table, name, value);
                continue;
            }
            let mut inline = toml_edit::InlineTable::new();
            inline.insert("value", value.into());
            for (key, text) in details {
                inline.insert(key, text.into());
            }
            let same = table.get(name).and_then(Item::as_inline_table).is_some_and(|before| {
                before.len() == inline.len()
                    && inline
                        .iter()
                        .all(|(key, text)| before.get(key).and_then(Toml::as_str) == text.as_str())
            });
            if !same {
                table.insert(name, Item::Value(Toml::InlineTable(inline)));
            }
        }
    }
}

fn leaf(row: &Draft, at: usize) -> &str {
    match row {
        Draft::Group(parts) => match parts.get(at) {
            Some(Draft::Leaf(text)) => text,
            _ => "",
        },
        _ => "",
    }
}
