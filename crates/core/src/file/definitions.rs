//! The tables `[let]`, `[ask]`, `[given]` and `[configuration.NAME]` of a problem file.

use toml_edit::{Item, Table, TableLike, Value as Toml};

use super::{FileError, FileNotes, plain, rows::in_brackets, write::set_text};
use crate::{Draft, Shape, Text, path};

/// The keys of a question that is a table.
const QUESTION: [&str; 4] = ["value", "unit", "symbol", "key"];

/// Definitions, questions, given answers and configurations of a table, in the order of the fields of a problem.
pub(crate) fn lists(root: &dyn TableLike, reading: &mut FileNotes) -> [Draft; 4] {
    let definitions = pairs(root, "let", "a quantity or a formula in quotes is needed here", reading);
    let asked = questions(root, reading);
    let given = pairs(root, "given", "a quantity in quotes is needed here, as in \"8.2 Hz\"", reading);
    [definitions, asked, given, configurations(root, reading)].map(Draft::Rows)
}

/// Adds what the tables of a problem say to the draft of its inputs.
pub(crate) fn read(root: &dyn TableLike, shape: &Shape, draft: &mut Draft, reading: &mut FileNotes) {
    let lists = lists(root, reading);
    put(draft, shape, lists);
}

/// Puts the lists of a problem behind its inputs.
pub(crate) fn put(draft: &mut Draft, shape: &Shape, lists: [Draft; 4]) {
    let Draft::Group(all) = draft else { return };
    let own = shape.fields(None).len() - lists.len();
    all.resize(own, Draft::Absent);
    all.extend(lists);
}

fn table<'d>(root: &'d dyn TableLike, key: &str, reading: &mut FileNotes) -> Option<&'d dyn TableLike> {
    let item = root.get(key)?;
    let table = item.as_table_like();
    if table.is_none() {
        let example = match key {
            "given" => "natural_frequency = \"8.2 Hz\"",
            "configuration" => "weighted = { mass = \"12 kg\" }",
            _ => "nu = \"0.3\"",
        };
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

/// Rows of the changed inputs of each configuration.
fn configurations(root: &dyn TableLike, reading: &mut FileNotes) -> Vec<Draft> {
    let Some(table) = table(root, "configuration", reading) else { return Vec::new() };
    let mut rows = Vec::new();
    for (name, item) in table.iter() {
        match item.as_table_like() {
            // No input is changed yet.
            Some(inputs) if inputs.is_empty() => {
                rows.push(Draft::Group([name, "", ""].map(|text| Draft::Leaf(text.to_owned())).to_vec()));
            }
            Some(inputs) => changes(name, "", inputs, &mut rows, reading),
            None => reading.errors.push(FileError {
                why: Text::new("a configuration is a table of changed inputs, as in [configuration.{name}]")
                    .with("name", name),
                span: item.span(),
            }),
        }
    }
    rows
}

/// The changed inputs of a configuration, at paths in quotes or in tables.
fn changes(name: &str, within: &str, inputs: &dyn TableLike, rows: &mut Vec<Draft>, reading: &mut FileNotes) {
    for (input, item) in inputs.iter() {
        let path = if within.is_empty() { input.to_owned() } else { format!("{within}.{input}") };
        if let (Some(inner), Some((parent, chosen))) = (item.as_table_like(), path.rsplit_once('.'))
            && inner.is_empty()
        {
            // An alternative without inputs.
            rows.push(Draft::Group([name, parent, chosen].map(|text| Draft::Leaf(text.to_owned())).to_vec()));
        } else if let Some(inner) = item.as_table_like() {
            changes(name, &path, inner, rows, reading);
        } else if let Some(text) = change(item) {
            rows.push(Draft::Group([name.to_owned(), path, text].map(Draft::Leaf).to_vec()));
        } else {
            let why = Text::new("{path}: {why}")
                .with("path", format!("configuration.{name}.{path}"))
                .with_text("why", "a quantity or a formula in quotes is needed here");
            reading.errors.push(FileError { why, span: item.span() });
        }
    }
}

/// The text of a changed input: a value, or the components of a vector in a list.
fn change(item: &Item) -> Option<String> {
    match item.as_value()? {
        value @ Toml::Boolean(_) => Some(plain(value)),
        Toml::Array(all) if all.iter().all(|one| !matches!(one, Toml::Array(_) | Toml::InlineTable(_))) => {
            Some(in_brackets(all))
        }
        _ => formula(item),
    }
}

/// Writes the configurations of a draft; an input that is written in tables stays there.
fn write_configurations(root: &mut Table, rows: &[Draft]) {
    if rows.is_empty() {
        root.remove("configuration");
        return;
    }
    let all = root.entry("configuration").or_insert_with(|| {
        let mut table = Table::new();
        table.set_implicit(true);
        Item::Table(table)
    });
    let Some(all) = all.as_table_like_mut() else { return };
    let names: Vec<&str> = rows.iter().map(|row| leaf(row, 0)).collect();
    keep_only(all, &|name| names.contains(&name));
    for name in names {
        if !all.contains_key(name) {
            all.insert(name, Item::Table(Table::new()));
        }
        let Some(table) = all.get_mut(name).and_then(Item::as_table_like_mut) else { continue };
        let own = rows.iter().filter(|row| leaf(row, 0) == name).map(|row| (leaf(row, 1), leaf(row, 2)));
        let own: Vec<(&str, &str)> = own.filter(|change| *change != ("", "")).collect();
        keep_only(table, &|key| {
            own.iter().any(|(path, _)| {
                path.strip_prefix(key).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
            })
        });
        for (path, text) in own {
            write_change(table, path, text);
        }
    }
}

/// Writes a changed input: within the tables that are there, else at its path in quotes.
fn write_change(table: &mut dyn TableLike, path: &str, text: &str) {
    let inner = path
        .split_once('.')
        .filter(|(first, _)| table.get(first).is_some_and(|item| item.as_table_like().is_some()));
    match inner {
        Some((first, rest)) => {
            if let Some(inner) = table.get_mut(first).and_then(Item::as_table_like_mut) {
                write_change(inner, rest, text);
            }
        }
        // Components in a list, or an alternative without inputs, stay as they are written.
        None if table.get(path).is_some_and(|item| is_written(item, text)) => {}
        None => set_text(table, path, text),
    }
}

fn is_written(item: &Item, text: &str) -> bool {
    let alone = |table: &dyn TableLike| table.len() == 1 && table.contains_key(text);
    item.as_array().is_some_and(|all| in_brackets(all) == text) || item.as_table_like().is_some_and(alone)
}

pub(super) fn keep_only(table: &mut dyn TableLike, is_kept: &dyn Fn(&str) -> bool) {
    let gone: Vec<String> =
        table.iter().map(|(name, _)| name.to_owned()).filter(|name| !is_kept(name)).collect();
    for name in gone {
        table.remove(&name);
    }
}

fn formula(item: &Item) -> Option<String> {
    match item.as_value()? {
        value @ (Toml::String(_) | Toml::Integer(_) | Toml::Float(_)) => Some(plain(value)),
        _ => None,
    }
}

/// Writes the definitions, questions and given answers of a draft into the tables of a file, in their order; what is gone is taken out.
pub(crate) fn write(root: &mut Table, draft: &Draft, shape: &Shape) {
    if let Ok((Draft::Rows(rows), _)) = draft.at(shape, "configuration")
        && (!rows.is_empty() || root.contains_key("configuration"))
    {
        write_configurations(root, rows);
    }
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
        keep_only(table, &|name| names.contains(&name));
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
