//! `dalembert schema`: JSON Schema (draft 2020-12) of the problem file of an analysis, or of results.
//!
//! With that of a problem file an editor completes keys and alternatives and marks what is wrong, for TOML as for JSON.

use std::process::ExitCode;

use dalembert_core::{
    ChildList, Entry, Field, FieldLimit, LinkedProblem, Locale, Measure, Shape, Text, UnitSetting, Variant,
    file::{ShortForm, TitleBlock},
    linked, registry,
};
use dalembert_report::RESULTS_SCHEMA;
use serde_json::{Map, Value as Json, json};

use crate::{
    arguments::Schema,
    console::{Console, print_json},
    failure::Failure,
    problem,
};

/// The name of the schema of results, `dalembert solve --format json`.
const RESULTS: &str = "results";

/// Prints the schema.
pub(crate) fn run(schema: &Schema, console: &Console) -> Result<ExitCode, Failure> {
    print_json(&json(&schema.id, &console.locale)?)?;
    Ok(ExitCode::SUCCESS)
}

/// Schema of the problem file of an analysis, of linked problems, or of results.
pub(crate) fn json(id: &str, locale: &Locale) -> Result<Json, Failure> {
    Ok(match id {
        RESULTS => serde_json::from_str(RESULTS_SCHEMA).map_err(|error| Failure::Fault(error.to_string()))?,
        linked::ID => of_linked(&[], locale),
        id => match problem::analysis(id)? {
            entry if entry.linked().is_empty() => of(entry, locale),
            entry => of_linked(entry.linked(), locale),
        },
    })
}

/// Schema of the file of a problem of an analysis, to which others may be linked.
fn of(entry: &Entry, locale: &Locale) -> Json {
    let about = entry.about;
    let locale = &locale.at(about.id);
    let mut writer = Writer { locale, known: Vec::new(), definitions: Map::new() };
    let mut properties = problem_of(entry, &mut writer);
    properties.extend(of_file(any_problem()));
    let (title, description) = (Text::from(about.title), Text::from(about.summary));
    let texts = [title, description].map(|text| text.render(locale));
    schema(texts, &["analysis", "inputs"], properties, writer)
}

/// Schema of a file of linked problems: of these, or of any.
fn of_linked(problems: &[LinkedProblem], locale: &Locale) -> Json {
    let mut writer = Writer { locale, known: Vec::new(), definitions: Map::new() };
    let named: Map<String, Json> = problems
        .iter()
        .map(|problem| {
            let properties = problem_of(problem.entry, &mut writer);
            (problem.name.to_owned(), object(&["analysis", "inputs"], properties))
        })
        .collect();
    let problem = if named.is_empty() {
        any_problem()
    } else {
        json!({ "type": "object", "additionalProperties": false, "properties": named })
    };
    let mut properties = lists();
    properties.extend(of_file(problem));
    let texts = ["Linked problems", "Several problems that feed each other."];
    let texts = texts.map(|text| Text::from(text).render(locale));
    schema(texts, &["problem"], properties, writer)
}

fn schema(
    [title, description]: [String; 2],
    required: &[&str],
    properties: Map<String, Json>,
    writer: Writer<'_>,
) -> Json {
    let mut schema = object(required, properties);
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema".into();
    schema["title"] = title.into();
    schema["description"] = description.into();
    schema["$defs"] = writer.definitions.into();
    schema
}

fn object(required: &[&str], properties: Map<String, Json>) -> Json {
    let properties = Json::Object(properties);
    json!({ "type": "object", "additionalProperties": false, "required": required, "properties": properties })
}

/// Keys of a file beside those of its problem.
fn of_file(problem: Json) -> Map<String, Json> {
    let format = json!({ "type": "integer", "minimum": 1, "maximum": 2 });
    let units = json!({ "enum": UnitSetting::ALL.map(|setting| setting.to_string()) });
    let asked = json!({ "type": "array", "minItems": 1, "items": { "type": "string" } });
    let keys = [
        ("format", format),
        ("statement", json!({ "type": "string" })),
        ("title_block", title_block()),
        ("asked", asked),
        ("vary", json!({ "type": "object", "additionalProperties": { "type": ["string", "object"] } })),
        ("units", units),
        ("problem", problem),
    ];
    keys.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

/// Title block of notes: texts, dates or numbers.
fn title_block() -> Json {
    let line = json!({ "type": ["string", "integer"] });
    let lines = TitleBlock::keys().into_iter().map(|key| (key.to_owned(), line.clone()));
    object(&[], lines.collect())
}

/// Keys of a problem of an analysis.
fn problem_of(entry: &Entry, writer: &mut Writer<'_>) -> Map<String, Json> {
    let mut properties = lists();
    properties.insert("analysis".into(), json!({ "const": entry.about.id }));
    properties.insert("inputs".into(), writer.group(entry.fields()));
    properties
}

/// Named problems of any analysis, whose inputs are left to the schema of that.
fn any_problem() -> Json {
    let mut properties = lists();
    let ids: Vec<&str> = registry().iter().map(|entry| entry.about.id).collect();
    properties.insert("analysis".into(), json!({ "enum": ids }));
    properties.insert("inputs".into(), json!({ "type": "object" }));
    json!({ "type": "object", "additionalProperties": object(&["analysis"], properties) })
}

/// Keys that every problem has beside its inputs.
fn lists() -> Map<String, Json> {
    let value = json!({ "type": ["string", "number"] });
    let values = json!({ "type": "object", "additionalProperties": value });
    let changes = json!({ "type": "object", "additionalProperties": { "type": ["string", "number", "boolean", "array", "object"] } });
    let question = json!({ "oneOf": [
        value,
        {
            "type": "object",
            "additionalProperties": false,
            "required": ["value"],
            "properties": {
                "value": value,
                "unit": { "type": "string" },
                "symbol": { "type": "string" },
                "key": { "type": "string" },
            },
        },
    ] });
    let all = json!({
        "title": { "type": "string" },
        "let": values,
        "given": values,
        "ask": { "type": "object", "additionalProperties": question },
        "configuration": { "type": "object", "additionalProperties": changes },
        "show": { "type": "object", "additionalProperties": { "type": "string" } },
    });
    match all {
        Json::Object(all) => all,
        _ => Map::new(),
    }
}

struct Writer<'l> {
    locale: &'l Locale,
    /// Alternatives and rows are defined once: a type may contain itself.
    known: Vec<(ChildList, String)>,
    definitions: Map<String, Json>,
}

impl Writer<'_> {
    fn group(&mut self, fields: &'static [Field]) -> Json {
        let mut properties = Map::new();
        let mut required = Vec::new();
        for field in fields {
            if field.default.is_none()
                && !matches!(field.shape, Shape::Optional(_) | Shape::Rows { min: 0, .. })
            {
                required.push(field.name);
            }
            properties.insert(field.name.to_owned(), self.field(field));
        }
        json!({ "type": "object", "additionalProperties": false, "required": required, "properties": properties })
    }

    fn field(&mut self, field: &'static Field) -> Json {
        let label = Text::from(field.label).render(self.locale);
        let help = Text::from(field.help).render(self.locale);
        let mut schema = self.shape(&field.shape, field.name);
        if let Json::Object(schema) = &mut schema {
            let symbol = if field.symbol.is_empty() { String::new() } else { format!(" ({})", field.symbol) };
            schema.insert("title".into(), format!("{label}{symbol}").into());
            if !help.is_empty() {
                schema.insert("description".into(), help.into());
            }
            if let Some(default) = field.default {
                schema.insert("default".into(), default.into());
            }
        }
        schema
    }

    fn shape(&mut self, shape: &Shape, name: &str) -> Json {
        match shape {
            Shape::Quantity(measure) => quantity(measure),
            Shape::Vector(measure, len) => json!({
                "type": ["string", "array"],
                "minItems": len,
                "maxItems": len,
                "items": { "type": ["string", "number"] },
                "examples": [format!("({}) {}", vec!["0"; *len].join("; "), measure.unit)],
            }),
            Shape::Text => json!({ "type": ["string", "number"] }),
            Shape::Flag => json!({ "enum": [true, false, "yes", "no"] }),
            Shape::Count { min, max } => {
                json!({ "type": ["integer", "string"], "minimum": min, "maximum": max, "pattern": "^ *[0-9]+ *$" })
            }
            Shape::Reference(_) => json!({ "type": ["string", "integer"] }),
            Shape::Table(columns) => json!({
                "type": ["string", "array"],
                "items": { "anyOf": [
                    { "type": "array", "items": { "type": ["string", "number"] } },
                    { "type": ["string", "number"] },
                    self.group(columns()),
                ] },
            }),
            Shape::Group(fields) => self.defined(shape, name, |writer| writer.group(fields())),
            Shape::OneOf(variants) => self.defined(shape, name, |writer| writer.one_of(variants())),
            Shape::Rows { item, min, most } => {
                let mut rows = vec![self.shape(item(), name)];
                let mut lists = Vec::new();
                for form in ShortForm::of_rows(item()) {
                    match form {
                        ShortForm::RowInOrder => rows.push(json!({ "type": "array" })),
                        ShortForm::RowOfValue => rows.push(json!({ "type": ["string", "number"] })),
                        ShortForm::ByName => lists.push(json!({ "type": "object", "maxProperties": most })),
                        ShortForm::InOneText => lists.push(json!({ "type": "string" })),
                    }
                }
                let items = any_of(rows);
                lists
                    .insert(0, json!({ "type": "array", "minItems": min, "maxItems": most, "items": items }));
                any_of(lists)
            }
            Shape::Optional(inner) => self.shape(inner(), name),
        }
    }

    /// An alternative is a table with its name, or its name alone where it asks for nothing; the value of the only
    /// quantity of one may stand in place of its table, and of the choice.
    fn one_of(&mut self, variants: &'static [Variant]) -> Json {
        let names: Vec<&str> = variants
            .iter()
            .filter(|variant| (variant.fields)().is_empty())
            .map(|variant| variant.name)
            .collect();
        let mut alternatives = Vec::new();
        if !names.is_empty() {
            alternatives.push(json!({ "enum": names }));
        }
        let is_one_value = |variant: &Variant| matches!((variant.fields)(), [only] if only.shape.is_leaf());
        if variants.iter().any(is_one_value) {
            alternatives.push(json!({ "type": ["string", "number"], "pattern": "^[^A-Za-z]" }));
        }
        for variant in variants {
            let mut fields = self.group((variant.fields)());
            if let Json::Object(fields) = &mut fields {
                fields.insert("title".into(), Text::from(variant.label).render(self.locale).into());
            }
            let fields = if is_one_value(variant) {
                json!({ "anyOf": [fields, { "type": ["string", "number"] }] })
            } else {
                fields
            };
            alternatives.push(json!({
                "type": "object",
                "additionalProperties": false,
                "required": [variant.name],
                "properties": { variant.name: fields },
            }));
        }
        json!({ "oneOf": alternatives })
    }

    /// The definition of the child list of a shape, written where they are first met.
    fn defined(&mut self, shape: &Shape, name: &str, write: impl FnOnce(&mut Self) -> Json) -> Json {
        let Some(child_list) = shape.child_list() else { return write(self) };
        let known = self.known.iter().find(|(known, _)| *known == child_list).map(|(_, name)| name.clone());
        let name = known.unwrap_or_else(|| {
            let taken = |name: &String| self.known.iter().any(|(_, known)| known == name);
            let numbered = std::iter::once(name.to_owned()).chain((2..).map(|n| format!("{name}-{n}")));
            let free = numbered.into_iter().find(|name| !taken(name)).unwrap_or_default();
            // Known before it is written, so that it can name itself.
            self.known.push((child_list, free.clone()));
            let definition = write(self);
            self.definitions.insert(free.clone(), definition);
            free
        });
        json!({ "$ref": format!("#/$defs/{name}") })
    }
}

/// One of these forms; the only one where it is alone.
fn any_of(mut forms: Vec<Json>) -> Json {
    if forms.len() == 1 { forms.remove(0) } else { json!({ "anyOf": forms }) }
}

/// A text with a unit, or a bare number in the unit of the field, within its limits.
fn quantity(measure: &Measure) -> Json {
    let mut schema = json!({ "type": ["string", "number"] });
    if let Json::Object(schema) = &mut schema {
        match measure.min {
            FieldLimit::None => {}
            FieldLimit::Including(least) => drop(schema.insert("minimum".into(), least.into())),
            FieldLimit::Excluding(least) => drop(schema.insert("exclusiveMinimum".into(), least.into())),
        }
        match measure.max {
            FieldLimit::None => {}
            FieldLimit::Including(most) => drop(schema.insert("maximum".into(), most.into())),
            FieldLimit::Excluding(most) => drop(schema.insert("exclusiveMaximum".into(), most.into())),
        }
        let units = measure.all().map(|measure| measure.own_unit().ascii());
        let examples: Vec<String> =
            units.filter(|unit| !unit.is_empty()).map(|unit| format!("1 {unit}")).collect();
        if !examples.is_empty() {
            schema.insert("examples".into(), json!(examples));
        }
    }
    schema
}
