//! `dalembert sensitivity`

use std::{process::ExitCode, thread};

use dalembert_core::{
    Answer, Locale, Record, Solution, Stop, Text,
    sensitivity::{self, InputInfluence, Sensitivity},
    study::{USUAL_SAMPLES, answer as named_answer},
    vary,
};
use dalembert_report::{Block, Document, DocumentTable};
use dalembert_study::{
    StudyError,
    spread::{self, NONLINEAR, SampledSpread},
};
use dalembert_units as units;
use serde_json::{Value as Json, json};

use crate::{
    arguments::{Sensitivity as Arguments, TableFormat},
    commands::solve,
    console::{Console, print, print_json},
    failure::Failure,
    problem::{self, LoadedProblem, ProblemSource},
    solving,
};

/// Version of the schema of the JSON.
const FORMAT: u32 = 1;

/// Sensitivity of an answer as it is printed.
struct Report<'r> {
    problem: &'r LoadedProblem,
    answer: &'r Answer,
    found: &'r Sensitivity,
    sampled: Option<&'r SampledSpread>,
    /// True where no tolerance was given, and every input has the usual one.
    is_usual: bool,
    locale: Locale,
}

/// Prints the influence of each input on an answer, and the effect of the tolerances.
pub(crate) fn run(asked: &Arguments, console: &Console) -> Result<ExitCode, Failure> {
    let source =
        ProblemSource { case: asked.case, changes: &asked.set, ..ProblemSource::named(&asked.problem) };
    let problem = problem::read(&source, console)?;
    let solution = solve::outcome(&problem)?.map_err(Failure::Refused)?;
    let answer = chosen(&solution, asked.answer.as_deref())?;
    let tolerances = tolerances(&problem.record, &asked.tolerance)?;
    let is_usual = tolerances.is_empty();
    let usual = if is_usual { sensitivity::USUAL } else { 0.0 };
    let (entry, record) = (problem.entry, &problem.record);
    let stop = Stop::new();
    let name = answer.name.to_string();
    let found = solving::guarded(entry, || {
        sensitivity::sensitivity(entry, record, &name, (&tolerances, usual), &stop)
    })?
    .map_err(solving::failure)?;
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let samples = (asked.samples.unwrap_or(USUAL_SAMPLES), asked.seed);
    let sampled = solving::guarded(entry, || {
        spread::sampled((entry, record), &solution, &found, samples, (threads, &stop))
    })?
    .map_err(|error| match error {
        StudyError::Solve(error) => solving::failure(error),
        other => Failure::input(other.text()),
    })?;
    let mut locale = console.locale.at(entry.about.id);
    locale.style.digits = asked.digits.unwrap_or(locale.style.digits);
    let report = Report {
        problem: &problem,
        answer: &answer,
        found: &found,
        sampled: sampled.as_ref(),
        is_usual,
        locale,
    };
    match asked.format {
        TableFormat::Table => console.print(report.document())?,
        TableFormat::Json => print_json(&report.json())?,
        TableFormat::Csv => print(&report.csv())?,
    }
    Ok(ExitCode::SUCCESS)
}

/// The named answer, or the main one: the first that is a number, or a limit of the first where that is a set.
fn chosen(solution: &Solution, name: Option<&str>) -> Result<Answer, Failure> {
    if let Some(name) = name {
        return named_answer(solution, "", name).map_err(|error| Failure::input(error.why));
    }
    let limits = solution.answers.first().map_or_else(Vec::new, |first| solution.limits_of(first));
    let number = || solution.answers.iter().find(|answer| answer.si().is_some());
    limits
        .first()
        .copied()
        .or_else(number)
        .cloned()
        .ok_or_else(|| Failure::input("this problem has no answer that is a number"))
}

/// The tolerances in SI, by the paths of their inputs: those of the problem, and in their place those of the command line.
fn tolerances(record: &Record, typed: &[String]) -> Result<Vec<(String, f64)>, Failure> {
    let inputs = vary::inputs(record);
    let mut all = sensitivity::tolerances(record);
    let mut errors = Vec::new();
    for text in typed {
        let wrong = |why: Text| {
            let error = Text::new("--tolerance {text}: {why}").with("text", text);
            error.with_text("why", why)
        };
        let Some((path, width)) = text.split_once('=') else {
            errors.push(wrong("write an input and its tolerance, as in --tolerance mass='2 %'".into()));
            continue;
        };
        let path = path.trim();
        let Some(input) = inputs.iter().find(|input| input.path == path) else {
            errors.push(wrong(vary::unknown_number(&inputs, path)));
            continue;
        };
        match input.tolerance(width) {
            Ok(width) => {
                all.retain(|(known, _)| known != path);
                all.push((path.to_owned(), width));
            }
            Err(why) => errors.push(wrong(why)),
        }
    }
    if errors.is_empty() { Ok(all) } else { Err(Failure::Input(errors)) }
}

impl Report<'_> {
    /// The inputs, the most influential first.
    fn sorted(&self) -> Vec<&InputInfluence> {
        let value = self.found.value;
        let size =
            |one: &InputInfluence| Some(one.change(value).abs()).filter(|x| x.is_finite()).unwrap_or(0.0);
        let mut sorted: Vec<&InputInfluence> = self.found.influences.iter().collect();
        sorted.sort_by(|a, b| size(b).total_cmp(&size(a)));
        sorted
    }

    fn say(&self, text: &Text) -> String {
        text.render(&self.locale)
    }

    fn written(&self, si: f64) -> String {
        if si.is_finite() {
            units::write_quantity(si, &self.answer.unit, self.locale.style)
        } else {
            "–".into()
        }
    }

    /// The derivative in the units that are shown.
    fn derivative(&self, one: &InputInfluence) -> f64 {
        one.derivative * one.input.unit.factor / self.answer.unit.factor
    }

    fn document(&self) -> Document {
        let number = |x: f64| {
            let style = units::Style { digits: self.locale.style.digits.min(4), ..self.locale.style };
            if x.is_finite() { units::write_number(x, style) } else { "–".into() }
        };
        let words = |text: &'static str| self.say(&Text::from(text));
        let row = |one: &&InputInfluence| {
            let value = self.found.value;
            let [less, more] = one.at_tolerance;
            let has = one.tolerance > 0.0;
            vec![
                self.say(&one.input.label),
                number(one.elasticity(value)),
                format!("{} {}", number(self.derivative(one)), one.unit(&self.answer.unit)).trim().to_owned(),
                if has {
                    units::write_quantity(one.tolerance, &one.input.unit, self.locale.style)
                } else {
                    String::new()
                },
                if has { self.written(less) } else { String::new() },
                if has { self.written(more) } else { String::new() },
            ]
        };
        let headings =
            ["Input", "Elasticity", "Derivative", "± tolerance", "at its lower end", "at its upper end"];
        let table = DocumentTable {
            title: String::new(),
            columns: headings.map(words).to_vec(),
            numeric: vec![false, true, true, true, true, true],
            rows: self.sorted().iter().map(row).collect(),
            foot: Vec::new(),
        };
        let title = format!("{} = {}", self.answer.label(&self.locale), self.written(self.found.value));
        let mut blocks = vec![Block::Heading(title), Block::Table(table)];
        let [least, most] = self.found.spread.worst;
        let mut lines = vec![
            Text::new("worst case at the ends of the tolerances: {least} to {most}")
                .with("least", self.written(least))
                .with("most", self.written(most)),
            Text::new("root of the sum of squares: {value} ± {likely}")
                .with("value", self.written(self.found.value))
                .with("likely", self.written(self.found.spread.likely)),
        ];
        if let Some(sampled) = self.sampled {
            lines.push(
                Text::new(
                    "Monte Carlo: 95 % of the answers from {from} to {to}, mean {mean} ({samples} samples, seed {seed}; normal inputs, 95 % within their tolerances)",
                )
                .with("from", self.written(sampled.interval[0]))
                .with("to", self.written(sampled.interval[1]))
                .with("mean", self.written(sampled.mean))
                .with("samples", sampled.samples)
                .with("seed", sampled.seed),
            );
        }
        let remarks = self.remarks();
        blocks.push(Block::Items(lines.iter().chain(&remarks).map(|line| self.say(line)).collect()));
        Document { title: String::new(), blocks }
    }

    /// Remarks: the usual tolerances, inputs with a kink or a side without an answer, and a spread that is not linear.
    fn remarks(&self) -> Vec<Text> {
        let mut remarks = Vec::new();
        if self.is_usual {
            remarks.push(Text::from(
                "no tolerance is given: 1 % is taken for every input, 1° for an angle; write --tolerance PATH=VALUE for your own",
            ));
        }
        for one in self.sorted() {
            let label = one.input.label.clone();
            if one.has_kink(self.found.value) {
                remarks.push(Text::new("{input}: asymmetric effect").with_text("input", label.clone()));
            }
            if let Some(why) = &one.refused {
                let text = Text::new("{input}: no answer on one side: {why}").with_text("input", label);
                remarks.push(text.with_text("why", why.clone()));
            }
        }
        if let Some(sampled) = self.sampled {
            if sampled.refused > 0 {
                let text = Text::new("{count} of {samples} samples have no answer");
                remarks.push(text.with("count", sampled.refused).with("samples", sampled.samples));
            }
            let difference = sampled.difference(self.found);
            if difference > NONLINEAR {
                let percent = |share: f64| {
                    units::write_number(100.0 * share, units::Style { digits: 2, ..self.locale.style })
                };
                let text = Text::new(
                    "warning: Monte Carlo and root of the sum of squares differ by {percent} % of the latter, more than {limit} %: within these tolerances the answer is not linear",
                );
                remarks.push(text.with("percent", percent(difference)).with("limit", percent(NONLINEAR)));
            }
        }
        remarks
    }

    fn json(&self) -> Json {
        let unit = &self.answer.unit;
        let of = |si: f64| finite(unit.value(si));
        let inputs: Vec<Json> = self
            .sorted()
            .iter()
            .map(|one| {
                let own = &one.input.unit;
                json!({
                    "path": one.input.path,
                    "label": self.say(&one.input.label),
                    "value": finite(own.value(one.input.si)),
                    "unit": own.ascii(),
                    "elasticity": finite(one.elasticity(self.found.value)),
                    "derivative": { "value": finite(self.derivative(one)), "unit": one.unit(unit) },
                    "tolerance": finite(one.tolerance / own.factor),
                    "at_tolerance": one.at_tolerance.map(of),
                    "asymmetric": one.has_kink(self.found.value),
                    "refused": one.refused.as_ref().map(|why| self.say(why)),
                })
            })
            .collect();
        let sampled = self.sampled.map(|sampled| {
            json!({
                "samples": sampled.samples,
                "refused": sampled.refused,
                "seed": sampled.seed,
                "mean": of(sampled.mean),
                "deviation": finite(sampled.deviation / unit.factor),
                "interval_95": sampled.interval.map(of),
                "difference": finite(sampled.difference(self.found)),
                "limit": NONLINEAR,
            })
        });
        json!({
            "format": FORMAT,
            "analysis": self.problem.entry.about.id,
            "answer": self.answer.name.to_string(),
            "value": of(self.found.value),
            "unit": unit.ascii(),
            "inputs": inputs,
            "worst_case": self.found.spread.worst.map(of),
            "root_sum_square": finite(self.found.spread.likely / unit.factor),
            "monte_carlo": sampled,
            "remarks": self.remarks().iter().map(|text| self.say(text)).collect::<Vec<_>>(),
        })
    }

    /// A row for each input, then one for each way to put the tolerances together.
    fn csv(&self) -> String {
        let unit = &self.answer.unit;
        let number = |x: f64| if x.is_finite() { x.to_string() } else { String::new() };
        let headings = [
            "input",
            "value",
            "unit",
            "elasticity",
            "derivative",
            "derivative_unit",
            "tolerance",
            "low",
            "high",
            "answer_unit",
        ];
        let mut rows = vec![headings.map(str::to_owned).to_vec()];
        for one in self.sorted() {
            let own = &one.input.unit;
            let [low, high] = one.at_tolerance.map(|si| number(unit.value(si)));
            rows.push(vec![
                one.input.path.clone(),
                number(own.value(one.input.si)),
                own.ascii(),
                number(one.elasticity(self.found.value)),
                number(self.derivative(one)),
                one.unit(unit),
                number(one.tolerance / own.factor),
                low,
                high,
                unit.ascii(),
            ]);
        }
        let (value, likely) = (self.found.value, self.found.spread.likely);
        let mut together = vec![
            ("(worst case)", self.found.spread.worst),
            ("(root sum square)", [value - likely, value + likely]),
        ];
        together.extend(self.sampled.map(|sampled| ("(Monte Carlo)", sampled.interval)));
        for (name, ends) in together {
            let [low, high] = ends.map(|si| number(unit.value(si)));
            let mut row = vec![String::new(); headings.len()];
            name.clone_into(&mut row[0]);
            (row[7], row[8], row[9]) = (low, high, unit.ascii());
            rows.push(row);
        }
        let lines: Vec<String> = rows.iter().map(|row| row.join(",")).collect();
        lines.join("\n") + "\n"
    }
}

/// A number of JSON; none where it is not finite.
fn finite(x: f64) -> Json {
    if x.is_finite() { json!(x) } else { Json::Null }
}
