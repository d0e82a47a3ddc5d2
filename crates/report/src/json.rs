//! A solved problem for another program.

use std::ops::Bound;

use dalembert_core::{Answer, AnswerValue, Locale, Number, Value};
use serde_json::{Map, Value as Json, json};

use crate::{Worked, inputs::inputs};

/// `{"analysis", "case", "inputs": {path: {"text", "si", "unit"}}, "answers": {name: {"label", "si", "unit",
/// "shown"}}, "checks": [{"what", "residual", "passed"}], "warnings": [], "refusal": null | "…"}`.
///
/// `si` is a number, `[x, y, z]` for a vector or a list, `[[from, to], …]` for a set (`null` where an end is open to
/// infinity), and for inputs also `true`, a list of rows, or `null` for words. `unit` can be typed.
pub fn json(worked: &Worked<'_>, locale: &Locale) -> Json {
    let mut given = Map::new();
    for input in inputs(worked.draft, worked.record, locale) {
        if let Some(value) = input.value {
            let (si, unit) = understood(value);
            given.insert(input.path, json!({ "text": input.typed, "si": si, "unit": unit }));
        }
    }
    let mut answers = Map::new();
    let (mut checks, mut warnings) = (Vec::new(), Vec::new());
    if let Ok(solution) = worked.outcome {
        for found in &solution.answers {
            answers.insert(found.name.to_string(), answer(found, locale));
        }
        checks.extend(solution.checks.iter().map(|check| {
            json!({ "what": check.what.render(locale), "residual": check.residual, "passed": check.passed })
        }));
        warnings.extend(solution.warnings.iter().map(|warning| warning.render(locale)));
    }
    json!({
        "analysis": worked.entry.about.id,
        "case": worked.case.english(),
        "inputs": given,
        "answers": answers,
        "checks": checks,
        "warnings": warnings,
        "refusal": worked.outcome.err().map(|why| why.render(locale)),
    })
}

fn answer(answer: &Answer, locale: &Locale) -> Json {
    let si = match &answer.value {
        AnswerValue::Number(Number::Scalar(si), _) => json!(si),
        AnswerValue::Number(Number::Vector(si), _) => json!(si),
        AnswerValue::List(numbers) => json!(numbers),
        AnswerValue::Set(set, _) => {
            let end = |bound: Bound<f64>| match bound {
                Bound::Included(x) | Bound::Excluded(x) => Some(x),
                Bound::Unbounded => None,
            };
            set.intervals().map(|interval| json!([end(interval.lower), end(interval.upper)])).collect()
        }
    };
    json!({
        "label": answer.label(locale),
        "si": si,
        "unit": answer.unit.ascii(),
        "shown": answer.shown(locale),
    })
}

/// What was understood: its value, and the unit it was written in.
fn understood(value: &Value) -> (Json, Json) {
    match value {
        Value::Quantity(quantity) => (json!(quantity.si), json!(quantity.unit.ascii())),
        Value::Vector(vector) => (json!(vector.si[..vector.len]), json!(vector.unit.ascii())),
        Value::Flag(flag) => (json!(flag), Json::Null),
        Value::Count(count) => (json!(count), Json::Null),
        Value::Table(table) => {
            (json!(table.rows), table.units.iter().map(dalembert_units::Unit::ascii).collect())
        }
        Value::Text(_)
        | Value::Reference { .. }
        | Value::OneOf { .. }
        | Value::Group(_)
        | Value::Rows(_)
        | Value::Absent => (Json::Null, Json::Null),
    }
}
