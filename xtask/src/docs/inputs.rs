//! The inputs of an analysis as rows of a table, each with its path as a problem file writes it.

use serde_json::Value as Json;

use super::{array, cell, text};

/// The table of the inputs. What has been described once is not described again.
pub(super) fn table(fields: &Json) -> String {
    let mut text = "| input | symbol | what it is | what may stand there |\n|---|---|---|---|\n".to_owned();
    rows(&mut text, fields, "");
    text
}

/// A row for every field and, below it, for what lies in it.
fn rows(table: &mut String, fields: &Json, above: &str) {
    for field in array(fields) {
        let path = format!("{above}{}", text(field, "name"));
        let (symbol, label, help) = (text(field, "symbol"), text(field, "label"), text(field, "help"));
        let about = if help.is_empty() { label.to_owned() } else { format!("{label}: {help}") };
        let mut may = asked(field);
        if let Some(default) = field["default"].as_str() {
            may += &format!("; otherwise {default}");
        }
        if field["optional"] == true {
            may += "; may be left out";
        }
        *table += &format!("| `{path}` | {} | {} | {} |\n", cell(symbol), cell(&about), cell(&may));
        inside(table, field, &path);
    }
}

fn inside(table: &mut String, shape: &Json, path: &str) {
    if let Some(first) = shape["like"].as_str() {
        *table += &format!("| `{path}.…` | | as in `{first}` | |\n");
        return;
    }
    match text(shape, "kind") {
        "rows" => inside(table, &shape["item"], &format!("{path}[n]")),
        "group" => rows(table, &shape["fields"], &format!("{path}.")),
        "table" => rows(table, &shape["columns"], &format!("{path}.")),
        "one-of" => {
            for alternative in array(&shape["alternatives"]) {
                let path = format!("{path}.{}", text(alternative, "name"));
                *table += &format!("| `{path}` | | {} | |\n", cell(text(alternative, "label")));
                rows(table, &alternative["fields"], &format!("{path}."));
            }
        }
        _ => {}
    }
}

/// Description of the value of a field.
fn asked(shape: &Json) -> String {
    match text(shape, "kind") {
        "quantity" => format!("{}{}", in_one_of(shape, array(&shape["others"])), limits(shape)),
        "vector" => format!("{} components, {}", shape["components"], in_unit(shape)),
        "text" => "words".to_owned(),
        "flag" => "yes or no".to_owned(),
        "count" => format!("a whole number{}", limits(shape)),
        "one-of" => "one of these".to_owned(),
        "group" => "these together".to_owned(),
        "rows" => match shape["min"].as_u64() {
            Some(least) if least > 0 => format!("a list, at least {least}: {}", asked(&shape["item"])),
            _ => format!("a list: {}", asked(&shape["item"])),
        },
        "table" => "a table with these columns".to_owned(),
        "reference" => format!("the name of one of `{}`", text(shape, "rows")),
        other => other.to_owned(),
    }
}

/// `a length in m`
fn in_unit(shape: &Json) -> String {
    match text(shape, "unit") {
        "" | "1" => text(shape, "quantity").to_owned(),
        unit => format!("{} in {unit}", text(shape, "quantity")),
    }
}

/// `a velocity in mm/s, an acceleration in m/s^2 or a ratio`; what has no name of its own by its units alone.
fn in_one_of(shape: &Json, others: &[Json]) -> String {
    let unnamed = |other: &Json| text(other, "quantity") == text(shape, "quantity");
    let other = |other| if unnamed(other) { text(other, "unit").to_owned() } else { in_unit(other) };
    match others {
        [] => in_unit(shape),
        [between @ .., last] => {
            let first: Vec<String> =
                std::iter::once(in_unit(shape)).chain(between.iter().map(other)).collect();
            format!("{} or {}", first.join(", "), other(last))
        }
    }
}

/// `, above 0 and at most 1`
fn limits(shape: &Json) -> String {
    let limit = |limit: &Json, words: [&str; 2]| match limit {
        Json::Number(number) => (number.as_u64() != Some(u64::MAX)).then(|| format!("{} {number}", words[0])),
        Json::Object(limit) => {
            let value = limit["value"].as_f64().map_or_else(String::new, |value| value.to_string());
            Some(format!("{} {value}", words[usize::from(limit["included"] != true)]))
        }
        _ => None,
    };
    let both = [limit(&shape["min"], ["at least", "above"]), limit(&shape["max"], ["at most", "below"])];
    let both: Vec<String> = both.into_iter().flatten().collect();
    if both.is_empty() { String::new() } else { format!(", {}", both.join(" and ")) }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn what_was_described_is_not_described_again() {
        let limit = json!({ "value": 0.0, "included": false });
        let mass = json!({ "name": "mass", "label": "Mass.", "help": "", "symbol": "m", "default": null,
            "kind": "quantity", "quantity": "a mass", "unit": "kg", "min": limit, "max": null });
        let flag = json!({ "name": "on", "label": "On", "help": "Or off.", "symbol": "", "default": "yes", "kind": "flag" });
        let first = json!({ "name": "a", "label": "Body", "help": "", "symbol": "", "default": null, "optional": true,
            "kind": "group", "fields": [mass, flag] });
        let second = json!({ "name": "b", "label": "Body", "help": "", "symbol": "", "default": null, "optional": true,
            "kind": "group", "like": "a" });
        assert_eq!(
            table(&json!([first, second])).lines().skip(2).collect::<Vec<_>>(),
            [
                "| `a` |  | Body | these together; may be left out |",
                "| `a.mass` | m | Mass. | a mass in kg, above 0 |",
                "| `a.on` |  | On: Or off. | yes or no; otherwise yes |",
                "| `b` |  | Body | these together; may be left out |",
                "| `b.…` | | as in `a` | |",
            ]
        );
    }
}
