//! Sheets for a class and keys for its teacher, as documents and as CSV.

use dalembert_core::{Answer, Exhibit, Locale, Text, Value};
use dalembert_report::{
    Block, Document, DocumentTable, NamedValue, WorkedProblem, document,
    figure::{figure, picture::Picture},
    inputs,
};
use dalembert_units as units;

use crate::{Exercise, Variant, decimal::number, rewritten};

/// Statement sheet of a variant: the statement with its data, the drawing, and what is asked for.
pub fn sheet(exercise: &Exercise, variant: &Variant, locale: &Locale) -> Document {
    let locale = &locale.at(exercise.entry.about.id);
    let mut blocks = question(exercise, variant, locale);
    blocks.push(Block::Heading(Text::from("Find").render(locale)));
    let asked = answers(variant).map(|answer| asked_for(answer, locale));
    blocks.push(Block::Items(asked.collect()));
    Document { title: title(exercise, variant, locale), blocks }
}

/// Key of several variants: a row for each, with its asked answers.
pub fn key(exercise: &Exercise, variants: &[Variant], locale: &Locale) -> Document {
    let locale = &locale.at(exercise.entry.about.id);
    let say = |words: &'static str| Text::from(words).render(locale);
    let heading = exercise.heading().render(locale);
    let mut columns = vec![say("Variant")];
    if let Some(first) = variants.first() {
        columns.extend(answers(first).map(|answer| answer.label(locale)));
    }
    let row = |variant: &Variant| {
        let values = answers(variant).map(|answer| answer.shown(locale));
        std::iter::once(variant.label.clone()).chain(values).collect()
    };
    let numeric = (0..columns.len()).map(|at| at > 0).collect();
    let rows = variants.iter().map(row).collect();
    let table = DocumentTable { title: String::new(), columns, numeric, rows, foot: Vec::new() };
    let title = Text::new("{exercise}: key").with("exercise", heading).render(locale);
    Document { title, blocks: vec![Block::Table(table)] }
}

/// Worked key of a variant: its statement and the whole worked solution.
pub fn worked_key(exercise: &Exercise, variant: &Variant, locale: &Locale) -> Document {
    let locale = &locale.at(exercise.entry.about.id);
    let none = Text::from("");
    let worked = WorkedProblem {
        entry: exercise.entry,
        case: &none,
        source: &none,
        statement: &none,
        note: &none,
        notes: &[],
        draft: &variant.draft,
        record: &variant.record,
        outcome: Ok(&variant.solution),
    };
    let mut solved = document(&worked, locale);
    let mut blocks: Vec<Block> = question(exercise, variant, locale)
        .into_iter()
        // Data and drawing stand in the solution.
        .filter(|block| matches!(block, Block::Paragraph(_)))
        .collect();
    blocks.append(&mut solved.blocks);
    Document { title: title(exercise, variant, locale), blocks }
}

/// Several documents as one, a heading for each.
pub fn together(title: String, documents: Vec<Document>) -> Document {
    let inner = |block: Block| match block {
        Block::Heading(words) => Block::Subheading(words),
        other => other,
    };
    let blocks = documents.into_iter().flat_map(|document| {
        std::iter::once(Block::Heading(document.title)).chain(document.blocks.into_iter().map(inner))
    });
    Document { title, blocks: blocks.collect() }
}

/// Answers of variants as CSV: variant, answer, label, value, unit. Numbers have a decimal point in every language.
pub fn answers_csv(exercise: &Exercise, variants: &[Variant], locale: &Locale) -> String {
    let locale = &locale.at(exercise.entry.about.id);
    let mut rows = vec![["variant", "answer", "label", "value", "unit"].map(str::to_owned).to_vec()];
    for variant in variants {
        for answer in answers(variant) {
            let (value, unit) = match answer.si() {
                Some(si) => (number(answer.unit.value(si)), answer.unit.ascii()),
                None => (cell(&answer.shown(&locale.ascii(true))), String::new()),
            };
            let label = cell(&answer.label(locale));
            rows.push(vec![cell(&variant.label), cell(&answer.name.to_string()), label, value, cell(&unit)]);
        }
    }
    csv_text(&rows)
}

/// Rows as CSV (RFC 4180).
pub(crate) fn csv_text(rows: &[Vec<String>]) -> String {
    let mut writer = csv::WriterBuilder::new().terminator(csv::Terminator::CRLF).from_writer(Vec::new());
    for row in rows {
        writer.write_record(row).expect("every row is as long as the headings, and memory takes all");
    }
    let bytes = writer.into_inner().expect("memory takes everything");
    String::from_utf8(bytes).expect("texts are UTF-8, and the writer adds ASCII alone")
}

/// A cell of words. One that a spreadsheet would evaluate is preceded by `'`; a number is none.
pub(crate) fn cell(text: &str) -> String {
    // Spreadsheets take full-width signs for the narrow ones, and leave out white space before them.
    let first = text.trim_start().chars().next();
    let is_formula = first.is_some_and(|c| ['=', '+', '-', '@', '＝', '＋', '－', '＠'].contains(&c))
        || text.starts_with(['\t', '\r', '\n']);
    if is_formula && text.parse::<f64>().is_err() { format!("'{text}") } else { text.to_owned() }
}

/// The asked answers of a variant.
pub(crate) fn answers(variant: &Variant) -> impl Iterator<Item = &Answer> {
    variant.asked.iter().filter_map(|name| variant.solution.answer(name))
}

/// Line of an answer that is asked for: its label, and the unit that it is graded in.
pub(crate) fn asked_for(answer: &Answer, locale: &Locale) -> String {
    match answer.unit.shown(locale.style.ascii) {
        unit if unit.is_empty() => answer.label(locale),
        unit => format!("{} [{unit}]", answer.label(locale)),
    }
}

/// Title of the sheet of a variant.
pub(crate) fn title(exercise: &Exercise, variant: &Variant, locale: &Locale) -> String {
    let heading = exercise.heading().render(locale);
    if variant.label.is_empty() {
        return heading;
    }
    let title = Text::new("{exercise}, variant {variant}").with("exercise", heading);
    title.with("variant", &variant.label).render(locale)
}

/// Statement, data where the statement does not have them, and drawing.
pub(crate) fn question(exercise: &Exercise, variant: &Variant, locale: &Locale) -> Vec<Block> {
    let mut blocks = Vec::new();
    let say = |words: &'static str| Text::from(words).render(locale);
    let statement = exercise.statement.text.render(locale);
    if statement.is_empty() {
        blocks.push(Block::Paragraph(say(exercise.entry.about.summary)));
        blocks.push(Block::Heading(say("Given data")));
        let all = inputs(&variant.draft, &variant.record, None, locale);
        let lines =
            all.iter().filter(|input| !input.is_common && input.value != Some(&Value::Absent)).map(|input| {
                NamedValue {
                    depth: input.depth,
                    symbol: input.symbol.clone(),
                    label: input.label.clone(),
                    value: input.shown.clone(),
                }
            });
        blocks.push(Block::Lines(lines.collect()));
    } else if let Some(own) = rewritten(&statement, &variant.data, locale) {
        blocks.push(Block::Paragraph(own));
    } else {
        blocks.push(Block::Paragraph(statement));
        blocks.push(Block::Paragraph(say("In place of the values above take these:")));
        blocks.push(Block::Lines(variant.data.iter().flat_map(|datum| data_lines(datum, locale)).collect()));
    }
    blocks.extend(drawing(variant, locale).map(Block::Figure));
    blocks
}

fn data_lines(datum: &crate::Datum, locale: &Locale) -> Vec<NamedValue> {
    let value = units::write_quantity(datum.si, &datum.unit, units::Style { digits: 12, ..locale.style });
    let symbol = if datum.paths.len() == 1 { datum.symbol.to_owned() } else { String::new() };
    vec![NamedValue { depth: 0, symbol, label: datum.label.render(locale), value }]
}

/// The first drawing of a variant; plots and tables show answers.
pub(crate) fn drawing(variant: &Variant, locale: &Locale) -> Option<Picture> {
    let drawing = variant.solution.exhibits.iter().find(|exhibit| matches!(exhibit, Exhibit::Drawing(_)))?;
    figure(drawing, locale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_a_formula() {
        for formula in
            ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", " =1", "\t=1", "\r=1", "＝1", "-3.2 mm"]
        {
            assert!(cell(formula).starts_with('\''), "{formula:?}");
        }
        for plain in ["-3.2", "19.4 mm", "a=b", "", "1e-3"] {
            assert_eq!(cell(plain), plain);
        }
    }
}
