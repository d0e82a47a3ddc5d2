//! `dalembert schema`: JSON Schema (draft 2020-12) of the problem file of an analysis.
//!
//! With it an editor completes keys and alternatives and marks what is wrong, for TOML as for JSON.

use std::process::ExitCode;

use dalembert_core::{
    ChildList, Entry, Field, FieldLimit, Locale, Measure, Shape, Text, UnitSetting, Variant,
};
use serde_json::{Map, Value as Json, json};

use crate::{
    arguments::Schema,
    console::{Console, print_json},
    failure::Failure,
    problem,
};

/// Prints the schema.
pub(crate) fn run(schema: &Schema, console: &Console) -> Result<ExitCode, Failure> {
    let entry = problem::analysis(&schema.id)?;
    print_json(&of(entry, &console.locale))?;
    Ok(ExitCode::SUCCESS)
}

fn of(entry: &Entry, locale: &Locale) -> Json {
    let about = entry.about;
    let locale = &locale.at(about.id);
    let mut writer = Writer { locale, known: Vec::new(), definitions: Map::new() };
    let inputs = writer.group(entry.fields());
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": Text::from(about.title).render(locale),
        "description": Text::from(about.summary).render(locale),
        "type": "object",
        "additionalProperties": false,
        "required": ["analysis", "inputs"],
        "properties": {
            "format": { "type": "integer", "minimum": 1, "maximum": 2 },
            "analysis": { "const": about.id },
            "title": { "type": "string" },
            "units": { "enum": UnitSetting::ALL.map(|setting| setting.to_string()) },
            "let": { "type": "object", "additionalProperties": { "type": ["string", "number"] } },
            "inputs": inputs,
            "given": { "type": "object", "additionalProperties": { "type": ["string", "number"] } },
            "ask": { "type": "object", "additionalProperties": { "oneOf": [
                { "type": ["string", "number"] },
                {
                    "type": "object",
                    "additionalProperties": false,
                    "required": ["value"],
                    "properties": {
                        "value": { "type": ["string", "number"] },
                        "unit": { "type": "string" },
                        "symbol": { "type": "string" },
                        "key": { "type": "string" },
                    },
                },
            ] } },
            "show": { "type": "object", "additionalProperties": { "type": "string" } },
        },
        "$defs": writer.definitions,
    })
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
                let items = self.shape(item(), name);
                json!({ "type": "array", "minItems": min, "maxItems": most, "items": items })
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
