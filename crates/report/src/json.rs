//! JSON writer: a solved problem for another program.

mod exhibits;
mod steps;

use std::ops::Bound;

use dalembert_core::{
    Answer, AnswerValue, Check, Determined, Draft, Entry, Exhibit, LinkedProblem, Locale, Solution, Value,
    printer, vary,
};
use dalembert_units::{Unit, is_invisible};
use serde_json::{Map, Value as Json, json};

use crate::{WorkedProblem, inputs::inputs};

/// Version of the schema of results. It changes when a key goes or means something else, not when one is added.
pub const RESULTS_FORMAT: u32 = 1;

/// JSON Schema (draft 2020-12) of what [`json()`] writes, with the meaning of every key.
pub const RESULTS_SCHEMA: &str = include_str!("json/results.schema.json");

/// The keys of a result, in their order.
pub const RESULT_KEYS: [&str; 18] = [
    "format",
    "program",
    "analysis",
    "case",
    "statement",
    "units",
    "notes",
    "inputs",
    "answers",
    "unknowns",
    "definitions",
    "problems",
    "steps",
    "plots",
    "tables",
    "checks",
    "warnings",
    "refusal",
];

/// A solved problem as [`RESULTS_SCHEMA`] describes it.
///
/// `value` is in `unit`, the one that is shown, and `si` in `si_unit`, which is coherent; both units can be typed, and that
/// of a pure number is `1`. Each is a number that reads back bit for bit, `[x, y, z]` for a vector or a list, `[[from, to],
/// …]` for a set (`null` where an end is open to infinity), and for inputs also `true`, a list of rows (with a list of
/// units), or `null` for words.
pub fn json(worked: &WorkedProblem<'_>, locale: &Locale) -> Json {
    json_of(worked, &|_| true, locale)
}

/// The same with those of its keys alone that are wanted.
pub fn json_of(worked: &WorkedProblem<'_>, wanted: &dyn Fn(&str) -> bool, locale: &Locale) -> Json {
    let locale = &locale.at(worked.entry.about.id);
    let keys = RESULT_KEYS.into_iter().filter(|key| wanted(key));
    Json::Object(keys.map(|key| (key.to_owned(), part(key, worked, locale))).collect())
}

/// Value of a key of the result.
fn part(key: &str, worked: &WorkedProblem<'_>, locale: &Locale) -> Json {
    let solution = worked.outcome.ok();
    let exhibits = || solution.into_iter().flat_map(|solution| &solution.exhibits);
    match key {
        "format" => RESULTS_FORMAT.into(),
        "program" => concat!("dalembert ", env!("CARGO_PKG_VERSION")).into(),
        "analysis" => worked.entry.about.id.into(),
        "case" => worked.case.english().into(),
        "statement" => worked.statement.render(locale).into(),
        "units" => worked.shown_units().map(|units| units.system.key()).into(),
        "notes" => steps::words(worked.notes, locale),
        "inputs" => given(worked, locale).into(),
        "answers" => solution.map(|solution| answers(solution, locale)).unwrap_or_default().into(),
        "unknowns" => {
            let found = solution.and_then(|solution| Some((solution.determined.as_deref()?, solution)));
            found.map(|(found, solution)| determined(found, solution, locale)).unwrap_or_default().into()
        }
        "definitions" => definitions(worked).into(),
        "problems" => problems(worked.entry).into(),
        "steps" => solution.map_or_else(Vec::new, |solution| all_steps(solution, locale)).into(),
        "plots" => exhibits()
            .filter_map(|exhibit| match exhibit {
                Exhibit::Plot(plot) => Some(exhibits::plot(plot, locale)),
                _ => None,
            })
            .collect(),
        "tables" => exhibits()
            .filter_map(|exhibit| match exhibit {
                Exhibit::Table(table) => Some(exhibits::table(table, locale)),
                _ => None,
            })
            .collect(),
        "checks" => {
            let all = solution.into_iter().flat_map(|solution| &solution.checks);
            let check = |check: &Check| json!({ "what": check.what.render(locale), "residual": check.residual, "limit": check.limit, "passed": check.passed });
            all.map(check).collect()
        }
        "warnings" => steps::words(solution.map_or(&[], |solution| &solution.warnings), locale),
        _ => worked.outcome.err().map(|why| why.render(locale)).into(),
    }
}

fn all_steps(solution: &Solution, locale: &Locale) -> Vec<Json> {
    (0..solution.steps.len()).map(|n| steps::step(solution, n, locale)).collect()
}

fn given(worked: &WorkedProblem<'_>, locale: &Locale) -> Map<String, Json> {
    let mut given = Map::new();
    for input in inputs(worked.draft, worked.solved_record(), worked.outcome.ok(), locale) {
        if let Some(value) = input.value {
            let mut entry = match &input.computed {
                Some((si, unit)) => with_units(&|of| json!(of(*si)), unit),
                None => understood(value),
            };
            entry.insert("text".into(), input.typed.into());
            given.insert(input.path, Json::Object(entry));
        }
    }
    given
}

fn answers(solution: &Solution, locale: &Locale) -> Map<String, Json> {
    let entry = |found: &Answer| (found.name.to_string(), answer(solution, found, locale));
    solution.answers.iter().map(entry).collect()
}

/// JSON as it is printed. Characters that could drive a terminal or turn the direction of a text are escaped.
pub fn json_text(json: &Json) -> String {
    let mut text = String::new();
    for c in format!("{json:#}\n").chars() {
        // All of them stand within strings: the rest is ASCII.
        if c == '\n' || !(c.is_control() || is_invisible(c)) {
            text.push(c);
        } else {
            text.extend(c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")));
        }
    }
    text
}

fn answer(solution: &Solution, answer: &Answer, locale: &Locale) -> Json {
    let numbers = |of: &dyn Fn(f64) -> f64| match &answer.value {
        AnswerValue::Number(number, _) => steps::number(*number, of),
        AnswerValue::List(numbers) => numbers.iter().map(|si| of(*si)).collect(),
        AnswerValue::Set(set, _) => {
            let end = |bound: Bound<f64>| match bound {
                Bound::Included(x) | Bound::Excluded(x) => Some(of(x)),
                Bound::Unbounded => None,
            };
            set.intervals().map(|interval| json!([end(interval.lower), end(interval.upper)])).collect()
        }
    };
    let mut entry = with_units(&numbers, &answer.unit);
    entry.insert("label".into(), answer.label(locale).into());
    entry.insert("shown".into(), answer.shown(locale).into());
    if let Some(step) = steps::step_of(solution, &answer.value) {
        entry.insert("step".into(), step.into());
    }
    if answer.asked {
        entry.insert("asked".into(), true.into());
    }
    Json::Object(entry)
}

/// Definitions by their names, of linked problems behind the name of the problem.
fn definitions(worked: &WorkedProblem<'_>) -> Map<String, Json> {
    let quantities = vary::inputs(worked.record);
    let mut found = Map::new();
    let problems = std::iter::once("")
        .chain(worked.entry.linked().iter().map(|problem| problem.name).filter(|name| !name.is_empty()));
    for problem in problems {
        let within =
            |name: &str| if problem.is_empty() { name.to_owned() } else { format!("{problem}.{name}") };
        let rows = worked.draft.at(&worked.entry.shape(), &within("let"));
        let Ok((Draft::Rows(rows), _)) = rows else { continue };
        for row in rows {
            let Draft::Group(parts) = row else { continue };
            let [Draft::Leaf(name), Draft::Leaf(formula)] = &parts[..] else { continue };
            let name = within(name);
            let computed = worked.outcome.ok().and_then(|solution| solution.computed_input(&name));
            let quantity = quantities.iter().find(|input| input.path == name);
            let typed = quantity.map(|input| (input.si, &input.unit));
            let mut entry = Map::new();
            if let Some((si, unit)) = computed.or(typed) {
                entry = with_units(&|of| json!(of(si)), unit);
            }
            entry.insert("formula".into(), formula.as_str().into());
            found.insert(name, Json::Object(entry));
        }
    }
    found
}

/// Linked problems with their analyses and files; none where there is one problem alone.
fn problems(entry: &Entry) -> Vec<Json> {
    let of = |problem: &LinkedProblem| json!({ "name": problem.name, "analysis": problem.entry.about.id, "file": problem.file });
    entry.linked().iter().map(of).collect()
}

fn determined(found: &Determined, solution: &Solution, locale: &Locale) -> Map<String, Json> {
    let unknown = |(n, unknown): (usize, &dalembert_core::DeterminedInput)| {
        let values = |of: &dyn Fn(f64) -> f64| {
            found.solutions.iter().map(|solution| of(solution[n])).collect::<Json>()
        };
        let mut entry = with_units(&values, &unknown.unit);
        entry.insert("label".into(), unknown.label.render(locale).into());
        entry.insert("from".into(), unknown.range[0].into());
        entry.insert("to".into(), unknown.range[1].into());
        entry.insert("uncertainty".into(), unknown.uncertainty.into());
        entry.insert("all".into(), found.has_all().into());
        entry.insert("formula".into(), unknown_formula(solution, locale).into());
        (unknown.name.clone(), Json::Object(entry))
    };
    found.unknowns.iter().enumerate().map(unknown).collect()
}

/// Formula of the one unknown, `m = k / (2π fₙ)²`, where the trace was inverted: its solutions are all that there are.
pub fn unknown_formula(solution: &Solution, locale: &Locale) -> Option<String> {
    let unknown = solution.determined.as_ref().filter(|found| found.has_all())?.unknowns.first()?;
    let (_, id) = solution.computed.iter().find(|(path, _)| *path == unknown.name)?;
    let step = solution.steps.iter().find(|step| step.result == *id)?;
    let written = printer::step(solution, step, locale);
    Some(format!("{} = {}", written.symbol, written.formula))
}

/// Value as read, in JSON.
fn understood(value: &Value) -> Map<String, Json> {
    let plain = |value: Json| {
        let none = Json::Null;
        [("value", value.clone()), ("unit", none.clone()), ("si", value), ("si_unit", none)]
            .map(|(key, json)| (key.to_owned(), json))
            .into_iter()
            .collect()
    };
    match value {
        Value::Quantity(quantity) => with_units(&|of| json!(of(quantity.si)), &quantity.unit),
        Value::Vector(vector) => {
            with_units(&|of| vector.si[..vector.len].iter().map(|si| of(*si)).collect(), &vector.unit)
        }
        Value::Table(table) => {
            let own = |row: &[f64]| {
                row.iter().zip(&table.units).map(|(si, unit)| json!(unit.value(*si))).collect::<Json>()
            };
            let mut entry = Map::new();
            entry.insert("value".into(), table.rows().map(own).collect());
            entry.insert("unit".into(), table.units.iter().map(written).collect());
            entry.insert("si".into(), table.rows().map(|row| json!(row)).collect());
            entry.insert("si_unit".into(), table.units.iter().map(Unit::coherent).collect());
            entry
        }
        Value::Flag(flag) => plain(json!(flag)),
        Value::Count(count) => plain(json!(count)),
        Value::Text(_)
        | Value::Reference { .. }
        | Value::OneOf { .. }
        | Value::Group(_)
        | Value::Rows(_)
        | Value::Absent => plain(Json::Null),
    }
}

/// The same numbers in a unit and in SI, each beside its unit. `numbers` writes them through what it is given.
fn with_units(numbers: &dyn Fn(&dyn Fn(f64) -> f64) -> Json, unit: &Unit) -> Map<String, Json> {
    let mut entry = Map::new();
    entry.insert("value".into(), numbers(&|si| unit.value(si)));
    entry.insert("unit".into(), written(unit).into());
    entry.insert("si".into(), numbers(&|si| si));
    entry.insert("si_unit".into(), unit.coherent().into());
    entry
}

fn written(unit: &Unit) -> String {
    let text = unit.ascii();
    if text.is_empty() { "1".to_owned() } else { text }
}
