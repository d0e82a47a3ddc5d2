//! Rows of the lists that every problem has: definitions, questions, given answers and configurations.

use crate::{Record, Value};

/// Rows of one of the lists that every problem has.
pub(super) fn rows<'r>(record: &'r Record, list: &str) -> &'r [Value] {
    match record.get(list) {
        Some(Value::Rows(rows)) => rows,
        _ => &[],
    }
}

/// The key of the question in a row: as it is typed, or its words in small letters with `_` between them.
pub(super) fn question_key(row: &Value) -> String {
    let key = text_of(row, "key");
    if !key.is_empty() {
        return key.to_owned();
    }
    let words = text_of(row, "name").split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join("_")
}

/// Text of a field of a row; empty where it has none.
pub(super) fn text_of<'v>(row: &'v Value, field: &str) -> &'v str {
    match row {
        Value::Group(record) => match record.get(field) {
            Some(Value::Text(text)) => text.trim(),
            _ => "",
        },
        _ => "",
    }
}
