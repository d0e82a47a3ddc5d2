//! Summary of a study: statistics of its answers, probabilities of limits, influence of the inputs.

use dalembert_core::{
    Answer, Exhibit, Locale, Text,
    study::{AnswerStatistics, Estimate, Exceedance, Histogram, LevelMean, Study, Summary},
};
use dalembert_units::{self as units, Unit};
use serde_json::{Value as Json, json};

use crate::{
    document::{Block, Document, DocumentTable, NamedValue},
    figure::{figure, picture::Picture},
    study_figures,
};

/// Letters of the longest bar of a histogram.
const LONGEST_BAR: f64 = 40.0;
/// Inputs of the table of their influence: those that have most.
const MOST_INPUTS: usize = 12;
/// Inputs over which the points of an answer are shown.
const MOST_SCATTERS: usize = 2;
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
    for (place, (answer, of)) in all().enumerate() {
        let ranked = ranked(of);
        blocks.extend(influence(study, answer, of, &ranked, locale));
        blocks.extend(study_figures::tornado(study, answer, of, &ranked, locale).map(Block::Figure));
        blocks.extend(sobol_indices(study, answer, of, locale));
        blocks.extend(distribution(&say(&answer.title()), &answer.unit, of, locale));
        let plot = of.histogram.plot(answer, |value| answer.unit.si(value));
        blocks.extend(plot.and_then(|plot| figure(&Exhibit::Plot(plot), locale)).map(Block::Figure));
        for (n, (input, _)) in ranked.iter().take(MOST_SCATTERS).enumerate() {
            let picture = study_figures::scatter(study, summary, place, *input, locale);
            // One is enough on a screen.
            let letters =
                |picture: Picture| if n > 0 { Picture { letters: Vec::new(), ..picture } } else { picture };
            blocks.extend(picture.map(letters).map(Block::Figure));
        }
        blocks.extend(study_figures::maps(study, summary, place, locale).into_iter().map(Block::Figure));
    }
    Document { title: title.to_owned(), blocks }
}

/// The inputs over whose levels the mean of an answer changes, by their places, with its least and its largest value in
/// the unit of the answer; the largest change first.
fn ranked(of: &AnswerStatistics) -> Vec<(usize, [f64; 2])> {
    let range = |(input, levels): (usize, &Vec<LevelMean>)| {
        let means = || levels.iter().filter(|level| level.count > 0).map(|level| level.mean);
        let ends = [means().reduce(f64::min)?, means().reduce(f64::max)?];
        (ends[0] < ends[1]).then_some((input, ends))
    };
    let mut inputs: Vec<(usize, [f64; 2])> = of.effects.iter().enumerate().filter_map(range).collect();
    inputs.sort_by(|(_, a), (_, b)| (b[1] - b[0]).total_cmp(&(a[1] - a[0])));
    inputs.truncate(MOST_INPUTS);
    inputs
}

/// Table of the influence of the inputs on an answer.
fn influence(
    study: &Study<'_>,
    answer: &Answer,
    of: &AnswerStatistics,
    ranked: &[(usize, [f64; 2])],
    locale: &Locale,
) -> Option<Block> {
    let quantity = |value: f64| units::write_quantity(answer.unit.si(value), &answer.unit, locale.style);
    let row = |(input, [least, largest]): &(usize, [f64; 2])| {
        let correlation = of.correlations[*input];
        let number = units::write_number((correlation * 1e3).round() / 1e3, locale.style);
        let share = percent(of.shares[*input], locale);
        let label = study.design.inputs[*input].label.render(locale);
        vec![label, quantity(*least), quantity(*largest), number, share]
    };
    let rows: Vec<Vec<String>> = ranked.iter().map(row).collect();
    let title = Text::new("Influence on {answer}").with_text("answer", answer.title()).render(locale);
    let columns = ["input", "least mean", "largest mean", "correlation", "share of variance"];
    let columns = columns.map(|text| Text::from(text).render(locale));
    (!rows.is_empty()).then(|| table(&title, &columns, rows))
}

/// Table of the Sobol' indices of an answer, with the sum of the first-order ones.
fn sobol_indices(study: &Study<'_>, answer: &Answer, of: &AnswerStatistics, locale: &Locale) -> Vec<Block> {
    let Some(indices) = of.sobol_indices.as_ref().filter(|indices| !indices.inputs.is_empty()) else {
        return Vec::new();
    };
    let words = |text: &'static str| Text::from(text).render(locale);
    let number = |value: f64| units::write_number((value * 1e4).round() / 1e4, locale.style);
    let cells = |Estimate { value, interval: [low, high] }: Estimate| {
        let interval = Text::new("{low} to {high}").with("low", number(low)).with("high", number(high));
        [number(value), interval.render(locale)]
    };
    let rows = study.design.inputs.iter().zip(&indices.inputs).map(|(input, index)| {
        let label = [input.label.render(locale)];
        label.into_iter().chain(cells(index.first_order)).chain(cells(index.total)).collect()
    });
    let title = Text::new("Sobol' indices of {answer}").with_text("answer", answer.title()).render(locale);
    let columns = ["input", "first order", "95 % interval", "total order", "95 % interval"];
    let Block::Table(mut table) = table(&title, &columns.map(words), rows.collect()) else {
        return Vec::new();
    };
    let sum: f64 = indices.inputs.iter().map(|index| index.first_order.value).sum();
    table.foot = vec![words("sum"), number(sum)];
    table.foot.resize(columns.len(), String::new());
    let mut blocks = vec![Block::Table(table)];
    if indices.left_out > 0 {
        let why = Text::new(
            "{left} of {all} base samples are left out of the indices, since a point of them has no answer.",
        )
        .with("left", indices.left_out)
        .with("all", indices.left_out + indices.samples);
        blocks.push(Block::Paragraph(why.render(locale)));
    }
    blocks
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
