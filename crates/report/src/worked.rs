//! Worked solution as a document: its parts and their order.

use dalembert_core::{
    Answer, AnswerValue, Cell, Draft, Entry, Exhibit, Locale, Plot, Record, ShownUnits, Solution,
    TableExhibit, Text, Value, ascii, printer, problem_heading, title_of,
};
use dalembert_units as units;

use crate::{
    Parts,
    document::{Block, Document, DocumentTable, NamedValue},
    figure::{drawing, figure},
    inputs::{self, ReportedInput, inputs},
    tables::{document_table, file_of},
};

/// A problem and what came of it.
#[derive(Clone, Copy, Debug)]
pub struct WorkedProblem<'a> {
    /// Analysis of the problem.
    pub entry: &'static Entry,
    /// The name of the published case or the title of the problem file; may be empty.
    pub case: &'a Text,
    /// Publication of the case; may be empty.
    pub source: &'a Text,
    /// Statement of the exercise that the problem is; may be empty.
    pub statement: &'a Text,
    /// Remarks; may be empty.
    pub note: &'a Text,
    /// Notes on the reading of the inputs where the inputs do not show it.
    pub notes: &'a [Text],
    /// Texts of the inputs.
    pub draft: &'a Draft,
    /// Inputs as read.
    pub record: &'a Record,
    /// Outcome: a solution, or the reason for which there is none.
    pub outcome: Result<&'a Solution, &'a Text>,
}

impl WorkedProblem<'_> {
    /// The inputs with the values that the solution has: those of unknowns are found by it.
    pub fn solved_record(&self) -> &Record {
        let determined = self.outcome.ok().and_then(|solution| solution.determined.as_deref());
        determined.map_or(self.record, |determined| &determined.record)
    }

    /// The system of units that the solution is shown in; `None` for units as typed.
    pub fn shown_units(&self) -> Option<ShownUnits> {
        self.outcome.ok().and_then(|solution| solution.units)
    }
}

/// The worked solution as a user reads it: problem, inputs, drawings, answers, steps, plots and tables, checks, sources.
pub fn document(worked: &WorkedProblem<'_>, locale: &Locale) -> Document {
    document_of(worked, Parts::Full, locale)
}

/// The parts of it that are chosen.
pub fn document_of(worked: &WorkedProblem<'_>, parts: Parts, locale: &Locale) -> Document {
    written(worked, parts, locale, true)
}

/// The same without figures, for a text that cannot show them: to lay them out takes longer than all the rest.
pub fn document_without_figures(worked: &WorkedProblem<'_>, parts: Parts, locale: &Locale) -> Document {
    written(worked, parts, locale, false)
}

fn written(worked: &WorkedProblem<'_>, parts: Parts, locale: &Locale, with_figures: bool) -> Document {
    let about = worked.entry.about;
    let locale = &locale.at(about.id);
    let say = |words: &'static str| Text::from(words).render(locale);
    let mut blocks = vec![Block::Paragraph(say(about.summary))];
    let texts = [worked.case, worked.source, worked.statement, worked.note];
    let [case, source, statement, note] = texts.map(|text| text.render(locale));
    let case = [case, source].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" — ");
    blocks.extend([case, statement, note].into_iter().filter(|text| !text.is_empty()).map(Block::Paragraph));
    // What is to be found is not among the data of a sheet to be worked on.
    let solution = worked.outcome.ok();
    let shown = match parts {
        Parts::Statement => &WorkedProblem { outcome: Err(worked.case), ..*worked },
        Parts::Answers | Parts::Full => worked,
    };
    if let Some(units) = shown.shown_units() {
        blocks.push(Block::Paragraph(units.line().render(locale)));
    }
    blocks.push(Block::Heading(say("Given data")));
    blocks.extend(given(shown, locale));
    if !worked.notes.is_empty() {
        blocks.push(Block::Heading(say("How the data were read")));
        blocks.push(Block::Items(worked.notes.iter().map(|note| note.render(locale)).collect()));
    }
    if let Some(solution) = solution.filter(|_| with_figures) {
        blocks.extend(drawings(solution, parts, locale));
    }
    match worked.outcome {
        _ if parts == Parts::Statement => {}
        Err(why) => {
            blocks.push(Block::Heading(say("No answer")));
            blocks.push(Block::Paragraph(why.render(locale)));
        }
        Ok(solution) => solved(solution, parts, &mut blocks, with_figures, locale),
    }
    if !about.sources.is_empty() && parts == Parts::Full {
        blocks.push(Block::Heading(say("Sources")));
        let named =
            about.sources.iter().map(|one| format!("{}: {}", one.short_in(locale), one.full_in(locale)));
        blocks.push(Block::Items(named.collect()));
    }
    let document = Document { title: say(about.title), blocks };
    if locale.style.ascii { document.map(&|text| ascii(text)) } else { document }
}

/// Drawings of the machine: a sheet to be worked on has nothing in them of what is to be found.
fn drawings(solution: &Solution, parts: Parts, locale: &Locale) -> Vec<Block> {
    let picture = |exhibit: &Exhibit| match parts {
        Parts::Statement => drawing(&exhibit.sketch(0)?.unsolved(), locale),
        Parts::Answers | Parts::Full => figure(exhibit, locale),
    };
    let drawn = solution.exhibits.iter().filter(|exhibit| is_drawing(exhibit));
    drawn.filter_map(picture).map(Block::Figure).collect()
}

fn is_drawing(exhibit: &Exhibit) -> bool {
    matches!(exhibit, Exhibit::Drawing(_) | Exhibit::Animation(_) | Exhibit::Scene(_))
}

fn solved(solution: &Solution, parts: Parts, blocks: &mut Vec<Block>, with_figures: bool, locale: &Locale) {
    let say = |words: &'static str| Text::from(words).render(locale);
    blocks.push(Block::Heading(say("Answers")));
    for (n, answers) in solution.answers.chunk_by(|a, b| a.problem == b.problem).enumerate() {
        blocks.extend(subheading(n == 0, answers[0].problem, locale));
        blocks.push(Block::Lines(answers.iter().flat_map(|answer| answer_lines(answer, locale)).collect()));
    }
    if !solution.warnings.is_empty() {
        blocks.push(Block::Heading(say("Warnings")));
        blocks.push(Block::Items(solution.warnings.iter().map(|warning| warning.render(locale)).collect()));
    }
    if !solution.defects.is_empty() {
        blocks.push(Block::Heading(say("Internal errors")));
        blocks.push(Block::Items(solution.defects.clone()));
    }
    if parts == Parts::Full {
        worked_out(solution, blocks, with_figures, locale);
    }
    if !solution.checks.is_empty() {
        blocks.push(Block::Heading(say("Checks")));
        let checks = solution.checks.iter().map(|check| {
            let text = match (check.passed, check.limit > 1e-9) {
                (true, false) => Text::new("{what}: relative difference {gap}"),
                (true, true) => {
                    Text::new("{what}: relative difference {gap}, within rounding (up to {limit})")
                }
                (false, _) => Text::new("{what}: FAILED, relative difference {gap}, limit {limit}"),
            };
            let number = |x: f64| units::write_number(x, units::Style { digits: 2, ..locale.style });
            let (gap, limit) = (number(check.residual), number(check.limit));
            text.with_text("what", check.what.clone()).with("gap", gap).with("limit", limit).render(locale)
        });
        blocks.push(Block::Items(checks.collect()));
    }
}

/// Steps, plots and tables.
fn worked_out(solution: &Solution, blocks: &mut Vec<Block>, with_figures: bool, locale: &Locale) {
    let say = |words: &'static str| Text::from(words).render(locale);
    if !solution.steps.is_empty() {
        blocks.push(Block::Heading(say("Working")));
        for (n, step) in solution.steps.iter().enumerate() {
            if let Some(of) = solution.problems.iter().find(|of| of.steps.start == n) {
                blocks.extend(subheading(n == 0, of.name, locale));
            }
            blocks.push(Block::Step(n + 1, printer::step(solution, step, locale)));
        }
    }
    for exhibit in solution.exhibits.iter().filter(|exhibit| !is_drawing(exhibit)) {
        if with_figures {
            blocks.extend(figure(exhibit, locale).map(Block::Figure));
        }
        match exhibit {
            Exhibit::Table(table) => blocks.push(Block::Table(written_table(table, locale))),
            Exhibit::Plot(plot) => blocks.extend(plotted(plot, locale)),
            Exhibit::Drawing(_) | Exhibit::Animation(_) | Exhibit::Scene(_) => {}
        }
    }
}

fn given(worked: &WorkedProblem<'_>, locale: &Locale) -> Vec<Block> {
    let inputs = inputs(worked.draft, worked.solved_record(), worked.outcome.ok(), locale);
    let mut tables = Vec::new();
    for input in &inputs {
        if let Some(Value::Table(table)) = input.value {
            tables.push(Block::Table(document_table(input, table, worked, locale)));
        }
    }
    let system = worked.shown_units().map(|units| units.system);
    let in_system = |input: &ReportedInput<'_>| {
        let value = input.value.filter(|_| input.computed.is_none())?;
        inputs::shown_in(value, system?, locale)
    };
    let lines = inputs.iter().filter(|input| !input.is_common).map(|input| NamedValue {
        depth: input.depth,
        symbol: input.symbol.clone(),
        label: input.label.clone(),
        value: match (in_system(input), input.value.and(file_of(&input.typed))) {
            (Some(other), _) => format!("{} = {other}", input.shown),
            (None, Some(file)) => {
                let text = Text::new("{rows} from {file}").with("rows", &input.shown).with("file", file);
                text.render(locale)
            }
            (None, None) => input.shown.clone(),
        },
    });
    let [definitions, others] = common(&inputs, worked, locale);
    let lines = definitions.into_iter().chain(lines).chain(others);
    std::iter::once(Block::Lines(lines.collect())).chain(tables).collect()
}

/// Definitions, and given answers and configurations, each on a line. Questions stand among the answers.
fn common(inputs: &[ReportedInput<'_>], worked: &WorkedProblem<'_>, locale: &Locale) -> [Vec<NamedValue>; 2] {
    let computed = |name: &str| {
        let (si, unit) = worked.outcome.ok()?.computed_input(name)?;
        Some(units::write_quantity(si, unit, locale.style))
    };
    let say = |text: Text| text.render(locale);
    let (mut definitions, mut lines) = (Vec::new(), Vec::new());
    for row in inputs.iter().filter(|input| input.is_common && input.value.is_none()) {
        let part = |name: &str| {
            let path = format!("{}.{name}", row.path);
            inputs.iter().find(|input| input.path == path).map_or("", |input| input.typed.trim())
        };
        let (problem, list) = row.path.rsplit_once('.').unwrap_or(("", &row.path));
        let outside =
            |name: &str| if problem.is_empty() { name.to_owned() } else { format!("{problem}.{name}") };
        let with_value = |text: &str, value: Option<String>| match value {
            Some(value) if value != text => format!("{text} = {value}"),
            _ => text.to_owned(),
        };
        // A comma between the arguments of a function leaves no room for one in a number.
        let typed = |text: &str| {
            if text.contains(',') { text.to_owned() } else { locale.style.decimal.written(text) }
        };
        // An input is named by its path, or by its symbol.
        let changed = |input: &str| {
            let path = outside(input);
            let is_it = |known: &&ReportedInput<'_>| !known.is_common && ascii(&known.symbol) == ascii(input);
            let mut named = inputs.iter().filter(is_it);
            match (inputs.iter().any(|known| known.path == path), named.next(), named.next()) {
                (false, Some(only), None) => only.path.clone(),
                _ => path,
            }
        };
        let of = |text: Text| match problem {
            "" => say(text),
            problem => format!("{problem}: {}", say(text)),
        };
        match list.split('[').next() {
            Some("let") => definitions.push(NamedValue {
                label: of(Text::new("Definition")),
                symbol: part("name").to_owned(),
                value: with_value(&typed(part("formula")), computed(&outside(part("name")))),
                ..NamedValue::default()
            }),
            Some("given") => {
                let name = outside(part("name"));
                let answer = worked.outcome.ok().and_then(|solution| solution.answer(&name));
                lines.push(NamedValue {
                    label: say(Text::new("Given: {answer}")
                        .with_text("answer", answer.map_or_else(|| Text::verbatim(&name), Answer::title))),
                    value: part("value").to_owned(),
                    ..NamedValue::default()
                });
            }
            Some("configuration") => {
                let path = changed(part("input"));
                let inner = path.strip_prefix(problem).unwrap_or(&path).trim_start_matches('.');
                let title = title_of(&worked.entry.shape(), &path).unwrap_or_else(|| Text::verbatim(&path));
                let known = inputs.iter().find(|input| input.path == path);
                lines.push(NamedValue {
                    label: of(Text::new("Configuration {name}: {input}")
                        .with("name", part("name"))
                        .with_text("input", title)),
                    symbol: known.map_or_else(String::new, |input| input.symbol.clone()),
                    value: with_value(
                        part("formula"),
                        computed(&outside(&format!("{}.{inner}", part("name")))),
                    ),
                    ..NamedValue::default()
                });
            }
            _ => {}
        }
    }
    [definitions, lines]
}

fn subheading(is_first: bool, name: &str, locale: &Locale) -> Option<Block> {
    problem_heading(is_first, name).map(|text| Block::Subheading(text.render(locale)))
}

fn answer_lines(answer: &Answer, locale: &Locale) -> Vec<NamedValue> {
    let label = answer.title_within().render(locale);
    let mut lines = vec![NamedValue { depth: 0, symbol: String::new(), label, value: answer.shown(locale) }];
    if let AnswerValue::Set(_, limits) = &answer.value {
        let limit =
            |text: &Text| NamedValue { depth: 1, label: text.render(locale), ..NamedValue::default() };
        lines.extend(limits.iter().map(limit));
    }
    lines
}

fn written_table(table: &TableExhibit, locale: &Locale) -> DocumentTable {
    let numeric: Vec<bool> = (0..table.columns.len())
        .map(|at| table.rows.iter().any(|row| matches!(row.get(at), Some(Cell::Number(_)))))
        .collect();
    let columns = table.columns.iter().map(|column| {
        let heading = column.heading.render(locale);
        match pretty(column.unit, locale) {
            unit if unit.is_empty() => heading,
            unit => format!("{heading} [{unit}]"),
        }
    });
    let row = |cells: &Vec<Cell>| -> Vec<String> {
        let cells = cells.iter().zip(&table.columns).map(|(cell, column)| match cell {
            Cell::Empty => String::new(),
            Cell::Text(text) => text.render(locale),
            Cell::Number(si) => {
                let unit = units::unit(column.unit).unwrap_or(units::Unit::ONE);
                units::write_number(unit.value(*si), locale.style)
            }
        });
        cells.collect()
    };
    DocumentTable {
        title: table.title.render(locale),
        columns: columns.collect(),
        numeric,
        rows: table.rows.iter().map(row).collect(),
        foot: row(&table.foot),
    }
}

/// Description of a plot in words: its title, and its named points and lines.
fn plotted(plot: &Plot, locale: &Locale) -> Vec<Block> {
    let unit = |text: &str| units::unit(text).unwrap_or(units::Unit::ONE);
    let (x, y) = (unit(plot.x.unit), unit(plot.y.unit));
    let write = |si: f64, unit: &units::Unit| units::write_quantity(si, unit, locale.style);
    let marks = plot.marks.iter().map(|mark| {
        format!("{}: ({}; {})", mark.label.render(locale), write(mark.at.0, &x), write(mark.at.1, &y))
    });
    let levels =
        plot.levels.iter().map(|level| format!("{}: {}", level.label.render(locale), write(level.y, &y)));
    let named: Vec<String> = marks.chain(levels).collect();
    if named.is_empty() {
        return Vec::new();
    }
    vec![Block::Heading(plot.title.render(locale)), Block::Items(named)]
}

fn pretty(unit: &str, locale: &Locale) -> String {
    units::unit(unit).map_or_else(|_| unit.to_owned(), |unit| unit.shown(locale.style.ascii))
}
