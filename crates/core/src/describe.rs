//! The value of an input in words, and the form in which a problem file writes it.

use dalembert_units as units;

use crate::{Field, FieldLimit, Locale, Measure, Shape, Text, Variant, gravity, table};

/// The most fields of a group that a form shows.
const MOST_FIELDS: usize = 6;
/// The longest list of alternatives with what is in them, in bytes.
const MOST_FORMS: usize = 300;
/// Levels of groups and alternatives that a form shows.
const DEPTH: usize = 2;

/// Description of the values that a shape takes: `kg, above 0`.
pub fn in_words(shape: &Shape, locale: &Locale) -> String {
    let text = match shape {
        Shape::Quantity(measure) => return quantity(measure, locale),
        Shape::Vector(measure, len) => Text::new("{len} components, {what}, written {form}")
            .with("len", len)
            .with("what", quantity(measure, locale))
            .with("form", form(shape)),
        Shape::Text => "words".into(),
        Shape::Flag => "yes or no".into(),
        Shape::Count { min, max: u64::MAX } => Text::new("a whole number from {min}").with("min", min),
        Shape::Count { min, max } => {
            Text::new("a whole number from {min} to {max}").with("min", min).with("max", max)
        }
        Shape::OneOf(_) => "one of".into(),
        Shape::Group(_) => "these".into(),
        Shape::Rows { min: 0, most, .. } => Text::new("rows, at most {most}").with("most", most),
        Shape::Rows { min, most, .. } => {
            Text::new("rows, {min} to {most}").with("min", min).with("most", most)
        }
        Shape::Table(columns) => Text::new(
            "a table, as lines of text under the heading \"{heading}\" or as rows {form}, with the columns",
        )
        .with("heading", table::heading(columns()))
        .with("form", form(shape)),
        Shape::Reference(list) => Text::new("the name of one of {list}").with("list", list),
        Shape::Optional(inner) => {
            return format!("{}, {}", in_words(inner(), locale), Text::from("or nothing").render(locale));
        }
    };
    text.render(locale)
}

/// Description of the values that a field takes, with its default.
pub fn takes(field: &Field, locale: &Locale) -> String {
    let values = in_words(&field.shape, locale);
    match default_of(field) {
        Some(default) => format!("{values}, {}", locale.style.decimal.written(&default.render(locale))),
        None => values,
    }
}

/// The default of a field in words.
pub fn default_of(field: &Field) -> Option<Text> {
    let default = field.default?;
    let text = if gravity::is_gravity(field) {
        Text::new("default that of the problem, else {default}, or {customary} among US customary units")
            .with("customary", gravity::in_feet(default))
    } else {
        Text::new("default {default}")
    };
    Some(text.with("default", default))
}

/// `kg, above 0`
fn quantity(measure: &Measure, locale: &Locale) -> String {
    let own = measure.own_unit();
    let unit = match own.shown(locale.style.ascii) {
        _ if !measure.others.is_empty() => measure.units_of_kinds(locale.style.ascii),
        unit if unit.is_empty() => Text::from("a number").render(locale),
        unit => unit,
    };
    let limit = |words: &'static str, limit: f64| {
        let limit = units::write_number(limit, locale.style);
        format!(", {}", Text::new(words).with("limit", limit).render(locale))
    };
    let least = match measure.min {
        FieldLimit::None => String::new(),
        FieldLimit::Including(least) => limit("at least {limit}", least),
        FieldLimit::Excluding(least) => limit("above {limit}", least),
    };
    let most = match measure.max {
        FieldLimit::None => String::new(),
        FieldLimit::Including(most) => limit("at most {limit}", most),
        FieldLimit::Excluding(most) => limit("below {limit}", most),
    };
    format!("{unit}{least}{most}")
}

/// The form of a value in a problem file, with `…` for what the user writes: `{ length = "… m", young = "… Pa" }`.
pub fn form(shape: &Shape) -> String {
    form_within(shape, DEPTH)
}

/// The form of an alternative: its name, or a table with its name.
pub fn form_of(variant: &Variant) -> String {
    variant_within(variant, 1)
}

/// The forms of all alternatives; what is in them only where there is room for it.
pub(crate) fn forms_of(variants: &'static [Variant]) -> String {
    let within = |depth| {
        let forms: Vec<String> = variants.iter().map(|variant| variant_within(variant, depth)).collect();
        forms.join("; ")
    };
    Some(within(1)).filter(|forms| forms.len() <= MOST_FORMS).unwrap_or_else(|| within(0))
}

/// Forms of a table in a file.
pub(crate) fn table(columns: &'static [Field]) -> Text {
    let row = fields_within(columns, 1);
    Text::new("write a table as lines of text with the heading \"{heading}\", or as a list of rows {row}")
        .with("heading", table::heading(columns))
        .with("row", row)
}

fn form_within(shape: &Shape, depth: usize) -> String {
    match shape {
        Shape::Quantity(measure) => match measure.own_unit().ascii() {
            unit if unit.is_empty() => "\"…\"".to_owned(),
            unit => format!("\"… {unit}\""),
        },
        Shape::Vector(measure, len) => {
            let text = format!("({}) {}", vec!["…"; *len].join("; "), measure.own_unit().ascii());
            format!("\"{}\"", text.trim_end())
        }
        Shape::Flag => "\"yes\"".to_owned(),
        Shape::Text | Shape::Count { .. } | Shape::Reference(_) => "\"…\"".to_owned(),
        Shape::OneOf(variants) => match variants().first() {
            Some(first) => variant_within(first, depth),
            None => "\"…\"".to_owned(),
        },
        Shape::Group(fields) => fields_within(fields(), depth),
        Shape::Rows { item, .. } => format!("[{}, …]", form_within(item(), depth)),
        Shape::Table(columns) => format!("[{}, …]", fields_within(columns(), depth)),
        Shape::Optional(inner) => form_within(inner(), depth),
    }
}

fn variant_within(variant: &Variant, depth: usize) -> String {
    match (variant.fields)() {
        [] => format!("\"{}\"", variant.name),
        fields => format!("{{ {} = {} }}", variant.name, fields_within(fields, depth)),
    }
}

/// A table of fields: those that must be given, or all where none must.
fn fields_within(fields: &'static [Field], depth: usize) -> String {
    let Some(depth) = depth.checked_sub(1) else { return "{ … }".to_owned() };
    let needed = |field: &&Field| {
        field.default.is_none() && !matches!(field.shape, Shape::Optional(_) | Shape::Rows { min: 0, .. })
    };
    let one = |field: &Field| format!("{} = {}", field.name, form_within(&field.shape, depth));
    let mut shown: Vec<&Field> = fields.iter().filter(needed).collect();
    if shown.is_empty() {
        shown = fields.iter().collect();
    }
    let more = if shown.len() > MOST_FIELDS { ", …" } else { "" };
    let shown: Vec<String> = shown.into_iter().take(MOST_FIELDS).map(one).collect();
    format!("{{ {}{more} }}", shown.join(", "))
}
