//! PrairieLearn: a question folder whose `server.py` draws one of the variants.
//!
//! The server computes nothing but the choice: every number stands in the file.

use dalembert_core::{Locale, Text};
use dalembert_report::{Block, Document, html_fragment};
use serde_json::{Value as Json, json};

use crate::{
    Exercise, ExportFile, Variant, base64,
    export::{blanks, escaped, identifier, svg},
    seed_of,
    sheets::question,
};

/// The question folder of the variants.
pub fn question_folder(
    exercise: &Exercise,
    variants: &[Variant],
    tolerance: f64,
    locale: &Locale,
) -> Vec<ExportFile> {
    let locale = &locale.at(exercise.entry.about.id);
    let heading = exercise.heading().render(locale);
    let folder = identifier(&heading);
    let file = |name: &str, text: String| ExportFile { path: format!("{folder}/{name}"), text };
    let info = json!({
        "uuid": uuid(&format!("{} {heading} {:?}", exercise.entry.about.id, exercise.draft)),
        "title": heading,
        "topic": Text::from(exercise.entry.about.topic).render(locale),
        "tags": ["numeric"],
        "type": "v3",
    });
    let data: Vec<Json> =
        variants.iter().map(|variant| self::variant(exercise, variant, tolerance, locale)).collect();
    vec![
        file("info.json", format!("{info:#}\n")),
        file("question.html", page(exercise, variants.first(), tolerance, locale)),
        file("server.py", server(&Json::Array(data))),
    ]
}

/// Page with a blank for each asked number; names and units are those of every variant.
fn page(exercise: &Exercise, first: Option<&Variant>, tolerance: f64, locale: &Locale) -> String {
    let mut text = "<pl-question-panel>\n{{{params.statement}}}\n</pl-question-panel>\n".to_owned();
    for blank in first.map(|first| blanks(exercise, first, tolerance, locale)).into_iter().flatten() {
        let name = key(&blank.name);
        text += &format!(
            "<p><pl-number-input answers-name=\"{name}\" label=\"{} = \" suffix=\"{}\" comparison=\"relabs\" \
             rtol=\"{tolerance}\" atol=\"{{{{params.atol_{name}}}}}\"></pl-number-input></p>\n",
            escaped(&blank.label),
            escaped(&blank.unit)
        );
    }
    text
}

/// Data of a variant for the server.
fn variant(exercise: &Exercise, variant: &Variant, tolerance: f64, locale: &Locale) -> Json {
    let blocks: Vec<Block> = question(exercise, variant, locale)
        .into_iter()
        .filter(|block| !matches!(block, Block::Figure(_)))
        .collect();
    let html = html_fragment(&Document { title: String::new(), blocks });
    let mut statement = html.replace("<h1></h1>\n", "");
    if let Some(svg) = svg(variant, locale) {
        let data = base64::encoded(svg.as_bytes());
        statement += &format!("<p><img alt=\"\" src=\"data:image/svg+xml;base64,{data}\"/></p>\n");
    }
    let answers = blanks(exercise, variant, tolerance, locale).into_iter().map(|blank| {
        let errors: Vec<Json> = blank
            .errors
            .iter()
            .map(|(value, why)| json!({ "value": value, "within": blank.within_of(*value), "why": why }))
            .collect();
        let answer = json!({
            "value": blank.value,
            // Only zero needs an absolute tolerance: nothing is near to it by a share of it.
            "atol": if blank.value == 0.0 { 1e-9 } else { 0.0 },
            "errors": errors,
        });
        (key(&blank.name), answer)
    });
    json!({ "label": variant.label, "statement": statement, "answers": answers.collect::<serde_json::Map<_, _>>() })
}

/// Name of an answer as PrairieLearn takes it.
fn key(name: &str) -> String {
    let is_plain = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if is_plain { name.to_owned() } else { identifier(name).replace('-', "_") }
}

/// Program of the question. JSON of numbers, texts, lists and objects is Python as well.
fn server(variants: &Json) -> String {
    format!(
        "\"\"\"Variants of one problem: each attempt draws one, and a wrong answer that a usual mistake gives is named.\"\"\"\n\n\
         import random\n\nVARIANTS = {variants:#}\n\n\n\
         def generate(data):\n    variant = random.choice(VARIANTS)\n    data[\"params\"][\"label\"] = variant[\"label\"]\n    \
         data[\"params\"][\"statement\"] = variant[\"statement\"]\n    \
         for name, answer in variant[\"answers\"].items():\n        \
         data[\"correct_answers\"][name] = answer[\"value\"]\n        \
         data[\"params\"][\"atol_\" + name] = answer[\"atol\"]\n\n\n\
         def grade(data):\n    labels = [variant[\"label\"] for variant in VARIANTS]\n    \
         variant = VARIANTS[labels.index(data[\"params\"][\"label\"])]\n    \
         for name, answer in variant[\"answers\"].items():\n        score = data[\"partial_scores\"].get(name)\n        \
         typed = data[\"submitted_answers\"].get(name)\n        \
         if score is None or score.get(\"score\") or not isinstance(typed, (int, float)):\n            continue\n        \
         for error in answer[\"errors\"]:\n            if abs(typed - error[\"value\"]) <= error[\"within\"]:\n                \
         score[\"feedback\"] = error[\"why\"]\n                break\n"
    )
}

/// A name-based identifier in the form of a UUID (RFC 9562, version 8): the same problem has the same one.
fn uuid(name: &str) -> String {
    let [high, low] = [seed_of(name), seed_of(&format!("{name} again"))];
    let high = (high & 0xffff_ffff_ffff_0fff) | 0x8000;
    let low = (low & 0x3fff_ffff_ffff_ffff) | 0x8000_0000_0000_0000;
    format!(
        "{:08x}-{:04x}-{:04x}-{:04x}-{:012x}",
        high >> 32,
        high >> 16 & 0xffff,
        high & 0xffff,
        low >> 48,
        low & 0xffff_ffff_ffff
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_problem_keeps_its_identifier() {
        let one = uuid("vibration/rotating-unbalance");
        assert_eq!(one, uuid("vibration/rotating-unbalance"));
        assert_ne!(one, uuid("vibration/rotating-unbalance 2"));
        let parts: Vec<usize> = one.split('-').map(str::len).collect();
        assert_eq!(parts, [8, 4, 4, 4, 12]);
        assert!(one.as_bytes()[14] == b'8' && b"89ab".contains(&one.as_bytes()[19]), "{one}");
    }
}
