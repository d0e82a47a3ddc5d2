//! The tables of a solved problem for a spreadsheet, one table a text (RFC 4180).

use std::ops::Bound;

use dalembert_core::{
    Answer, AnswerValue, Cell, Exhibit, Locale, Number, Plot, Solution, TableExhibit, Text, Value, printer,
};
use dalembert_units::{self as units, Style, Unit};

use crate::{
    WorkedProblem,
    figure::{
        Seen,
        axes::{Axes, CurveReading},
    },
    inputs::inputs,
};

/// The names of the tables that [`csv()`] writes: `inputs`, `answers`, `steps`, `checks`, then `table-1` …, `plot-1` ….
pub fn csv_tables(worked: &WorkedProblem<'_>) -> Vec<String> {
    let mut names: Vec<String> = ["answers", "inputs", "steps", "checks"].map(str::to_owned).into();
    if let Ok(solution) = worked.outcome {
        names.extend((1..=exhibited_tables(solution).count()).map(|n| format!("table-{n}")));
        names.extend((1..=plots(solution).count()).map(|n| format!("plot-{n}")));
    }
    names
}

/// One table, by its name. `None` where there is no such table.
///
/// Numbers have a decimal point in every language. Words that a spreadsheet would take for a formula are preceded
/// by `'`.
pub fn csv(worked: &WorkedProblem<'_>, table: &str, locale: &Locale) -> Option<String> {
    let solution = worked.outcome.ok();
    let locale = &locale.at(worked.entry.about.id);
    let mut sheet = CsvSheet::default();
    match (table, table.rsplit_once('-')) {
        ("inputs", _) => write_inputs(worked, &mut sheet, locale),
        ("answers", _) => write_answers(solution, &mut sheet, locale),
        ("steps", _) => write_steps(solution, &mut sheet, locale),
        ("checks", _) => write_checks(solution, &mut sheet, locale),
        (_, Some(("table", n))) => {
            write_table(exhibited_tables(solution?).nth(place(n)?)?, &mut sheet, locale);
        }
        (_, Some(("plot", n))) => write_plot(plots(solution?).nth(place(n)?)?, &mut sheet, locale),
        _ => return None,
    }
    Some(sheet.text())
}

/// CSV of the visible part of a plot: the points of its curves and its marks in the window, on the scale of the axis,
/// and the cursor readings. `None` where there is nothing to draw.
pub fn plot_csv(plot: &Plot, seen: &Seen<'_>, locale: &Locale) -> Option<String> {
    let axes = Axes::seen(plot, seen.pinned, &seen.view)?;
    let mut sheet = CsvSheet::default();
    let plain = Locale { style: Style { ascii: true, ..locale.style }, ..*locale };
    sheet.headings(&["series", &axes.x.title(0, &plain).whole(), &axes.y.title(0, &plain).whole()]);
    let mut row = |label: &str, (x, y): (f64, f64)| {
        if axes.x.of(x).is_some_and(|place| (-1e-9..=1.0 + 1e-9).contains(&place)) {
            sheet.0.push(vec![words(label), number(axes.x.value(x)), number(axes.y.value(y))]);
        }
    };
    for series in &plot.series {
        let label = series.label.render(locale);
        series.points.iter().for_each(|at| row(&label, *at));
    }
    plot.marks.iter().for_each(|mark| row(&mark.label.render(locale), mark.at));
    if let Some(x) = seen.cursor.and_then(|cursor| axes.within(cursor)) {
        for series in &plot.series {
            let label = Text::new("{curve} at the cursor").with_text("curve", series.label.clone());
            if let Some(CurveReading { y, .. }) = axes.read(series, x) {
                row(&label.render(locale), (x, y));
            }
        }
    }
    Some(sheet.text())
}

/// Rows of cells, the first of them the headings.
#[derive(Default)]
struct CsvSheet(Vec<Vec<String>>);

impl CsvSheet {
    fn headings(&mut self, headings: &[&str]) {
        self.0.push(headings.iter().map(|heading| words(heading)).collect());
    }

    fn text(self) -> String {
        let mut writer =
            ::csv::WriterBuilder::new().terminator(::csv::Terminator::CRLF).from_writer(Vec::new());
        for row in self.0 {
            writer.write_record(row).expect("every row is as long as the headings, and memory takes all");
        }
        let bytes = writer.into_inner().expect("memory takes everything");
        String::from_utf8(bytes).expect("texts are UTF-8, and the writer adds ASCII alone")
    }
}

fn place(n: &str) -> Option<usize> {
    n.parse::<usize>().ok()?.checked_sub(1)
}

fn exhibited_tables(solution: &Solution) -> impl Iterator<Item = &TableExhibit> {
    solution.exhibits.iter().filter_map(|exhibit| match exhibit {
        Exhibit::Table(table) => Some(table),
        _ => None,
    })
}

fn plots(solution: &Solution) -> impl Iterator<Item = &Plot> {
    solution.exhibits.iter().filter_map(|exhibit| match exhibit {
        Exhibit::Plot(plot) => Some(plot),
        _ => None,
    })
}

/// A number: a decimal point, and the digits that read back bit for bit.
fn number(value: f64) -> String {
    if value.is_finite() {
        let shortest = format!("{value:?}");
        shortest.strip_suffix(".0").map(str::to_owned).unwrap_or(shortest)
    } else {
        String::new()
    }
}

/// Words. A cell that a spreadsheet would evaluate is preceded by `'`.
fn words(text: &str) -> String {
    // Spreadsheets take full-width signs for the narrow ones.
    if text.starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠', '\t', '\r']) {
        format!("'{text}")
    } else {
        text.to_owned()
    }
}

fn write_inputs(worked: &WorkedProblem<'_>, sheet: &mut CsvSheet, locale: &Locale) {
    sheet.headings(&["path", "label", "symbol", "text", "value", "unit", "si"]);
    for input in inputs(worked.draft, worked.solved_record(), worked.outcome.ok(), locale) {
        let (value, unit, si) = match input.value {
            Some(_) if let Some((si, unit)) = &input.computed => {
                (number(unit.value(*si)), unit.ascii(), number(*si))
            }
            Some(Value::Quantity(quantity)) => {
                (number(quantity.unit.value(quantity.si)), quantity.unit.ascii(), number(quantity.si))
            }
            Some(Value::Count(count)) => (count.to_string(), String::new(), count.to_string()),
            Some(Value::Vector(vector)) => (String::new(), vector.unit.ascii(), String::new()),
            Some(_) => Default::default(),
            None => continue,
        };
        let texts = [&input.path, &input.label, &input.symbol, &input.typed].map(|text| words(text));
        sheet.0.push(texts.into_iter().chain([value, words(&unit), si]).collect());
    }
}

fn write_answers(solution: Option<&Solution>, sheet: &mut CsvSheet, locale: &Locale) {
    sheet.headings(&["name", "label", "component", "value", "unit", "si"]);
    for answer in solution.iter().flat_map(|solution| &solution.answers) {
        for (component, si) in components(answer) {
            let label = answer.label(locale);
            let value = si.map_or_else(String::new, |si| number(answer.unit.value(si)));
            let si = si.map_or_else(String::new, number);
            sheet.0.push(vec![
                words(&answer.name.to_string()),
                words(&label),
                component,
                value,
                answer.unit.ascii(),
                si,
            ]);
        }
    }
}

/// The numbers of an answer: `x`, `y`, `z` of a vector; `1`, `2`, … of a list; `from 1`, `to 1`, … of a set, empty at an open end.
fn components(answer: &Answer) -> Vec<(String, Option<f64>)> {
    match &answer.value {
        AnswerValue::Number(Number::Scalar(si), _) => vec![(String::new(), Some(*si))],
        AnswerValue::Number(Number::Vector(si), _) => {
            ["x", "y", "z"].iter().zip(si).map(|(axis, si)| ((*axis).to_owned(), Some(*si))).collect()
        }
        AnswerValue::List(numbers) => {
            numbers.iter().enumerate().map(|(n, si)| ((n + 1).to_string(), Some(*si))).collect()
        }
        AnswerValue::Set(set, _) => {
            let end = |bound: Bound<f64>| match bound {
                Bound::Included(x) | Bound::Excluded(x) => Some(x),
                Bound::Unbounded => None,
            };
            let ends = |(n, interval): (usize, dalembert_numerics::intervals::Interval)| {
                [
                    (format!("from {}", n + 1), end(interval.lower)),
                    (format!("to {}", n + 1), end(interval.upper)),
                ]
            };
            set.intervals().enumerate().flat_map(ends).collect()
        }
    }
}

fn write_steps(solution: Option<&Solution>, sheet: &mut CsvSheet, locale: &Locale) {
    sheet.headings(&["step", "symbol", "formula", "substitution", "result", "si", "why", "source"]);
    let Some(solution) = solution else { return };
    for (n, step) in solution.steps.iter().enumerate() {
        let written = printer::step(solution, step, locale);
        let si = match solution.trace.node(step.result).number {
            Number::Scalar(si) => number(si),
            Number::Vector(_) => String::new(),
        };
        let texts = [&written.symbol, &written.formula, &written.substitution, &written.result];
        let row = std::iter::once((n + 1).to_string()).chain(texts.map(|text| words(text)));
        sheet.0.push(row.chain([si, words(&written.why), words(&written.source)]).collect());
    }
}

fn write_checks(solution: Option<&Solution>, sheet: &mut CsvSheet, locale: &Locale) {
    sheet.headings(&["what", "residual", "passed"]);
    for check in solution.iter().flat_map(|solution| &solution.checks) {
        let what = words(&check.what.render(locale));
        sheet.0.push(vec![what, number(check.residual), check.passed.to_string()]);
    }
}

fn write_table(table: &TableExhibit, sheet: &mut CsvSheet, locale: &Locale) {
    let heading = |heading: &Text, unit: &str| match unit_of(unit).ascii() {
        unit if unit.is_empty() => words(&heading.render(locale)),
        unit => words(&format!("{} [{unit}]", heading.render(locale))),
    };
    sheet.0.push(table.columns.iter().map(|column| heading(&column.heading, column.unit)).collect());
    for row in table.rows.iter().chain(Some(&table.foot).filter(|foot| !foot.is_empty())) {
        let cells = table.columns.iter().enumerate().map(|(at, column)| match row.get(at) {
            None | Some(Cell::Empty) => String::new(),
            Some(Cell::Number(si)) => number(unit_of(column.unit).value(*si)),
            Some(Cell::Text(text)) => words(&text.render(locale)),
        });
        sheet.0.push(cells.collect());
    }
}

fn write_plot(plot: &Plot, sheet: &mut CsvSheet, locale: &Locale) {
    let (x, y) = (unit_of(plot.x.unit), unit_of(plot.y.unit));
    let heading = |label: &Text, unit: &Unit| match unit.ascii() {
        unit if unit.is_empty() => label.render(locale),
        unit => format!("{} [{unit}]", label.render(locale)),
    };
    sheet.headings(&["series", &heading(&plot.x.label, &x), &heading(&plot.y.label, &y)]);
    for series in &plot.series {
        let label = words(&series.label.render(locale));
        for point in &series.points {
            sheet.0.push(vec![label.clone(), number(x.value(point.0)), number(y.value(point.1))]);
        }
    }
}

fn unit_of(text: &str) -> Unit {
    units::unit(text).unwrap_or(Unit::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_that_a_spreadsheet_would_evaluate_are_quoted() {
        for dangerous in ["=cmd()", "+1", "-1", "@sum", "\t=1", "\r=1"] {
            assert_eq!(words(dangerous), format!("'{dangerous}"));
        }
        assert_eq!(words("fan = 1"), "fan = 1");
    }

    #[test]
    fn numbers_keep_their_point_and_their_sign() {
        assert_eq!(number(-0.0203), "-0.0203");
        assert_eq!(number(1.3e-6), "1.3e-6");
        assert_eq!(number(f64::NAN), "");
    }

    #[test]
    fn a_sheet_is_rfc_4180() {
        let mut sheet = CsvSheet::default();
        sheet.headings(&["a", "b"]);
        sheet.0.push(vec!["x, \"y\"".into(), "two\nlines".into()]);
        assert_eq!(sheet.text(), "a,b\r\n\"x, \"\"y\"\"\",\"two\nlines\"\r\n");
    }
}
