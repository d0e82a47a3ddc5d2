//! The inputs of an analysis as rows of a table, each with its path as a problem file writes it.

use serde_json::Value as Json;

use super::{
    html::{code, escaped},
    words::Words,
};
use crate::docs::{array, text};

/// A symbol with its index: `θ_m`.
fn symbol(symbol: &str) -> String {
    match symbol.split_once('_') {
        Some((base, index)) => format!("{}<sub>{}</sub>", escaped(base), escaped(index)),
        None => escaped(symbol),
    }
}

/// Rows for fields: path, symbol, meaning, values.
pub(super) fn rows(fields: &Json, words: &Words) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    of_fields(&mut rows, fields, "", words);
    rows
}

fn of_fields(rows: &mut Vec<Vec<String>>, fields: &Json, above: &str, words: &Words) {
    for field in array(fields) {
        let path = format!("{above}{}", text(field, "name"));
        let (label, help) = (text(field, "label"), text(field, "help"));
        let meaning = if help.is_empty() {
            escaped(label)
        } else {
            format!("{}<br><small>{}</small>", escaped(label), escaped(help))
        };
        rows.push(vec![code(&path), symbol(text(field, "symbol")), meaning, escaped(text(field, "takes"))]);
        inside(rows, field, &path, words);
    }
}

fn inside(rows: &mut Vec<Vec<String>>, shape: &Json, path: &str, words: &Words) {
    if let Some(first) = shape["like"].as_str() {
        let like = format!("{} {}", words.as_in, code(first));
        rows.push(vec![code(&format!("{path}.…")), String::new(), like, String::new()]);
        return;
    }
    match text(shape, "kind") {
        "rows" => inside(rows, &shape["item"], &format!("{path}[n]"), words),
        "group" => of_fields(rows, &shape["fields"], &format!("{path}."), words),
        "table" => of_fields(rows, &shape["columns"], &format!("{path}."), words),
        "one-of" => {
            for alternative in array(&shape["alternatives"]) {
                let path = format!("{path}.{}", text(alternative, "name"));
                let label = escaped(text(alternative, "label"));
                rows.push(vec![code(&path), String::new(), label, String::new()]);
                of_fields(rows, &alternative["fields"], &format!("{path}."), words);
            }
        }
        _ => {}
    }
}
