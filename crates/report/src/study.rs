//! Summary of a study: statistics of its answers, probabilities of limits, influence of the inputs.

use dalembert_core::{
    Answer, Exhibit, Locale, Text,
    study::{AnswerStatistics, Exceedance, Histogram, Study, Summary},
};
use dalembert_units::{self as units, Unit};
use serde_json::{Value as Json, json};

use crate::{
    document::{Block, Document, DocumentTable, NamedValue},
    figure::figure,
};

/// Letters of the longest bar of a histogram.
const LONGEST_BAR: f64 = 40.0;
/// Correlations below this one are those of independent numbers.
const SMALL_CORRELATION: f64 = 0.01;
/// Smaller shares are not written with their digits.
const SMALL_SHARE: f64 = 1e-4;

/// The summary as JSON: statistics of each answer in its unit.
pub fn study_json(study: &Study<'_>, summary: &Summary, locale: &Locale) -> Json {
    let mut all = serde_json::to_value(summary).unwrap_or_default();
    let first = summary.first_refusal.as_ref();
    all["first_refusal"] = json!(first.map(|(point, why)| (point, why.render(locale))));
    let answers = all["answers"].as_array_mut().into_iter().flatten().zip(&study.answers);
    for (value, answer) in answers {
        value["answer"] = answer.name.to_string().into();
        value["unit"] = answer.unit.ascii().into();
    }
    all["inputs"] = study
        .design
        .inputs
        .iter()
        .map(|input| json!({ "input": input.path, "unit": input.unit.ascii() }))
        .collect();
    all
}

/// The summary of a study as a document.
pub fn study_document(study: &Study<'_>, title: &str, summary: &Summary, locale: &Locale) -> Document {
    let say = |text: &Text| text.render(locale);
    let words = |text: &'static str| Text::from(text).render(locale);
    let mut blocks = vec![Block::Heading(words("Study"))];
    let mut lines = vec![named(&words("Points"), summary.points.to_string())];
    if summary.refused > 0 {
        lines.push(named(&words("Points without an answer"), summary.refused.to_string()));
    }
    if let Some((point, why)) = &summary.first_refusal {
        let first = Text::new("point {point}: {why}").with("point", point).with_text("why", why.clone());
        lines.push(named(&words("The first of them"), say(&first)));
    }
    blocks.push(Block::Lines(lines));
    let all = || study.answers.iter().zip(&summary.answers);
    let quantity = |value: f64, unit: &Unit| units::write_quantity(unit.si(value), unit, locale.style);
    let statistics: [(&str, fn(&AnswerStatistics) -> f64); 8] = [
        ("mean", |of| of.mean),
        ("standard deviation", |of| of.deviation),
        ("minimum", |of| of.least),
        ("2.5 %", |of| of.percentiles[0]),
        ("median", |of| of.percentiles[3]),
        ("97.5 %", |of| of.percentiles[6]),
        ("maximum", |of| of.largest),
        ("number of points", |of| of.count as f64),
    ];
    let rows = statistics.iter().map(|(name, of_answer)| {
        let cell = |(answer, of): (&Answer, &AnswerStatistics)| match *name {
            "number of points" => of.count.to_string(),
            _ if of.count == 0 => "–".to_owned(),
            _ => quantity(of_answer(of), &answer.unit),
        };
        [words(name)].into_iter().chain(all().map(cell)).collect()
    });
    let columns: Vec<String> =
        [words("statistic")].into_iter().chain(all().map(|(answer, _)| say(&answer.title()))).collect();
    blocks.push(table(&words("Statistics of the answers"), &columns, rows.collect()));
    if let Some(width) = all().find(|(_, of)| of.bin_width > 0.0) {
        let why = Text::new("Percentiles are counted in bins; those of {answer} are {width} wide.")
            .with_text("answer", width.0.title())
            .with("width", quantity(width.1.bin_width, &width.0.unit));
        blocks.push(Block::Paragraph(say(&why)));
    }
    let limits: Vec<Vec<String>> = all()
        .flat_map(|(answer, of)| of.exceedances.iter().map(move |limit| (answer, limit)))
        .map(|(answer, limit)| {
            let text = if limit.above { "{answer} above {limit}" } else { "{answer} below {limit}" };
            let text = Text::new(text)
                .with_text("answer", answer.title())
                .with("limit", quantity(limit.limit, &answer.unit));
            let Exceedance { probability, interval: [low, high], .. } = limit;
            [say(&text)]
                .into_iter()
                .chain([probability, low, high].map(|share| percent(*share, locale)))
                .collect()
        })
        .collect();
    if !limits.is_empty() {
        let columns = ["limit", "probability", "95 % interval from", "to"].map(words);
        blocks.push(table(&words("Limits"), &columns, limits));
    }
    for (answer, of) in all() {
        blocks.extend(influence(study, answer, of, locale));
        blocks.extend(distribution(&say(&answer.title()), &answer.unit, of, locale));
        let plot = of.histogram.plot(answer, |value| answer.unit.si(value));
        blocks.extend(plot.and_then(|plot| figure(&Exhibit::Plot(plot), locale)).map(Block::Figure));
    }
    Document { title: title.to_owned(), blocks }
}

/// Table of the correlation of an answer with every input, the largest first.
fn influence(study: &Study<'_>, answer: &Answer, of: &AnswerStatistics, locale: &Locale) -> Option<Block> {
    let inputs = study.design.inputs.iter().zip(&of.correlations);
    let mut inputs: Vec<(f64, String)> = inputs
        .map(|(input, correlation)| (*correlation, input.label.render(locale)))
        .filter(|(correlation, _)| correlation.abs() >= SMALL_CORRELATION)
        .collect();
    inputs.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    let row = |(correlation, input): (f64, String)| {
        let number = units::write_number((correlation * 1e3).round() / 1e3, locale.style);
        vec![input, number, percent(correlation * correlation, locale)]
    };
    let rows: Vec<Vec<String>> = inputs.into_iter().map(row).collect();
    let title = Text::new("Influence on {answer}").with_text("answer", answer.title()).render(locale);
    let columns = ["input", "correlation coefficient", "share of the variance"];
    let columns = columns.map(|text| Text::from(text).render(locale));
    (!rows.is_empty()).then(|| table(&title, &columns, rows))
}

/// Table of the frequencies of an answer, with bars.
fn distribution(answer: &str, unit: &Unit, of: &AnswerStatistics, locale: &Locale) -> Option<Block> {
    let Histogram { from, width, counts } = &of.histogram;
    let most = *counts.iter().max()? as f64;
    let bar = if locale.style.ascii { "#" } else { "█" };
    let mut rows = Vec::new();
    // Two intervals a row are enough for letters.
    for (n, pair) in counts.chunks(2).enumerate() {
        let count: u64 = pair.iter().sum();
        let begin = from + 2.0 * n as f64 * width;
        let length = count as f64 / (2.0 * most) * LONGEST_BAR;
        rows.push(vec![
            units::write_quantity(unit.si(begin), unit, locale.style),
            percent(count as f64 / of.count as f64, locale),
            bar.repeat(length.round() as usize),
        ]);
    }
    let title = Text::new("Distribution of {answer}").with("answer", answer).render(locale);
    let columns = ["from", "share", ""].map(|text| Text::from(text).render(locale));
    Some(Block::Table(DocumentTable {
        title,
        columns: columns.to_vec(),
        numeric: vec![true, true, false],
        rows,
        foot: Vec::new(),
    }))
}

fn table(title: &str, columns: &[String], rows: Vec<Vec<String>>) -> Block {
    let numeric = (0..columns.len()).map(|n| n > 0).collect();
    Block::Table(DocumentTable {
        title: title.to_owned(),
        columns: columns.to_vec(),
        numeric,
        rows,
        foot: Vec::new(),
    })
}

fn named(label: &str, value: String) -> NamedValue {
    NamedValue { label: label.to_owned(), value, ..NamedValue::default() }
}

/// A share in percent, to three digits.
fn percent(share: f64, locale: &Locale) -> String {
    let style = units::Style { digits: 3, ..locale.style };
    if share > 0.0 && share < SMALL_SHARE {
        return format!("< {} %", units::write_number(100.0 * SMALL_SHARE, style));
    }
    format!("{} %", units::write_number(100.0 * share, style))
}
