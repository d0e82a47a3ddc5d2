//! Graded answers as a document, as CSV and as JSON.

use std::collections::BTreeMap;

use dalembert_core::{Locale, Text};
use dalembert_report::{Block, Document, DocumentTable};
use dalembert_units as units;
use serde_json::{Value as Json, json};

use super::{AnswerStatistics, GradedAnswer, Outcome, Rules};
use crate::sheets::{cell, csv_text};

/// Version of the JSON.
const FORMAT: u32 = 1;

/// Graded answers, points of the students and statistics of the class for a reader.
pub fn document_of(
    title: &str,
    graded: &[GradedAnswer],
    statistics: &[AnswerStatistics],
    rules: &Rules,
    locale: &Locale,
) -> Document {
    let say = |words: &'static str| Text::from(words).render(locale);
    let number = |x: f64| units::write_number(x, units::Style { digits: 3, ..locale.style });
    let percent = |x: f64| Text::quantity(x, "%").render(&locale.digits(3));
    let table = |columns: Vec<String>, numeric: &[bool], rows| {
        Block::Table(DocumentTable { columns, numeric: numeric.to_vec(), rows, ..DocumentTable::default() })
    };
    let weights = Outcome::WITH_CREDIT.iter().zip(rules.weights);
    let weights = weights.map(|(outcome, weight)| format!("{} {}", say(outcome.label()), number(weight)));
    let rule = Text::new("Tolerance {tolerance}; credit: {weights}.")
        .with("tolerance", percent(rules.tolerance))
        .with("weights", weights.collect::<Vec<_>>().join(", "));
    let answers = graded.iter().map(|one| {
        vec![
            one.student.clone(),
            one.answer.clone(),
            one.value.clone(),
            say(one.outcome.label()),
            number(one.credit),
            one.cause.render(locale),
        ]
    });
    let headings = ["Student", "Answer", "Value", "Outcome", "Credit", "Cause"].map(say).to_vec();
    let mut blocks = vec![
        Block::Paragraph(rule.render(locale)),
        Block::Heading(say("Answers")),
        table(headings, &[false, false, false, false, true, false], answers.collect()),
        Block::Heading(say("Students")),
    ];
    let students = points(graded)
        .into_iter()
        .map(|(student, points, most)| vec![student.to_owned(), number(points), most.to_string()]);
    let headings = ["Student", "Points", "of"].map(say).to_vec();
    blocks.push(table(headings, &[false, true, true], students.collect()));
    blocks.push(Block::Heading(say("Class")));
    let class = statistics
        .iter()
        .map(|of| vec![of.answer.clone(), of.students.to_string(), percent(of.right), number(of.credit)]);
    let headings = ["Answer", "Students", "Share right", "Mean credit"].map(say).to_vec();
    blocks.push(table(headings, &[false, true, true, true], class.collect()));
    for of in statistics.iter().filter(|of| !of.causes.is_empty()) {
        let heading = Text::new("Most common errors: {answer}").with("answer", &of.answer);
        blocks.push(Block::Subheading(heading.render(locale)));
        let item = |(cause, times): &(Text, usize)| format!("{times} × {}", cause.render(locale));
        blocks.push(Block::Items(of.causes.iter().map(item).collect()));
    }
    Document { title: title.to_owned(), blocks }
}

/// Graded answers as CSV. Outcomes are keys; cells that a spreadsheet would evaluate are preceded by `'`.
pub fn csv_of(graded: &[GradedAnswer], locale: &Locale) -> String {
    let headings = ["student", "answer", "value", "expected", "outcome", "credit", "cause"];
    let mut rows = vec![headings.map(str::to_owned).to_vec()];
    rows.extend(graded.iter().map(|one| {
        vec![
            cell(&one.student),
            cell(&one.answer),
            cell(&one.value),
            cell(&one.expected),
            one.outcome.key().to_owned(),
            one.credit.to_string(),
            cell(&one.cause.render(locale)),
        ]
    }));
    csv_text(&rows)
}

/// Graded answers, points and statistics for another program.
pub fn json_of(
    graded: &[GradedAnswer],
    statistics: &[AnswerStatistics],
    rules: &Rules,
    locale: &Locale,
) -> Json {
    let answers: Vec<Json> = graded
        .iter()
        .map(|one| {
            json!({
                "student": one.student,
                "answer": one.answer,
                "value": one.value,
                "expected": one.expected,
                "outcome": one.outcome.key(),
                "credit": one.credit,
                "cause": one.cause.render(locale),
            })
        })
        .collect();
    let students: Vec<Json> = points(graded)
        .into_iter()
        .map(|(student, points, most)| json!({ "student": student, "points": points, "of": most }))
        .collect();
    let class: Vec<Json> = statistics
        .iter()
        .map(|of| {
            let outcomes: serde_json::Map<String, Json> = of
                .outcomes
                .iter()
                .map(|(outcome, times)| (outcome.key().to_owned(), (*times).into()))
                .collect();
            let causes: Vec<Json> = of
                .causes
                .iter()
                .map(|(cause, times)| json!({ "cause": cause.render(locale), "times": times }))
                .collect();
            json!({
                "answer": of.answer,
                "students": of.students,
                "right": of.right,
                "credit": of.credit,
                "outcomes": outcomes,
                "causes": causes,
            })
        })
        .collect();
    let weights: serde_json::Map<String, Json> = Outcome::WITH_CREDIT
        .iter()
        .zip(rules.weights)
        .map(|(outcome, weight)| (outcome.key().to_owned(), weight.into()))
        .collect();
    json!({
        "format": FORMAT,
        "tolerance": rules.tolerance,
        "weights": weights,
        "answers": answers,
        "students": students,
        "class": class,
    })
}

/// Points of each student and the most that there are, in the order in which students were met first.
fn points(graded: &[GradedAnswer]) -> Vec<(&str, f64, usize)> {
    let mut places: BTreeMap<&str, usize> = BTreeMap::new();
    let mut found: Vec<(&str, f64, usize)> = Vec::new();
    // A name that is no answer is worth nothing, and a second value counts once.
    for one in graded {
        let place = *places.entry(&one.student).or_insert_with(|| {
            found.push((&one.student, 0.0, 0));
            found.len() - 1
        });
        found[place].1 += one.credit;
        found[place].2 += usize::from(!one.expected.is_empty());
    }
    found
}
