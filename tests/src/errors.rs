//! The corpus of student errors, `data/errors`: wrong answers computed by formulas written by hand, each with the error that
//! leads to it, and what the search for causes makes of them.

use std::{collections::BTreeMap, fmt::Write as _, fs, path::Path};

use dalembert_core::{
    Entry, Record, Solution, Stop, cases,
    check::{self, Cause, Causes, Mistake, Place, Verdict},
    find, printer,
    trace::{Id, Op},
    value_of_numbers, vary,
};
use dalembert_units::{Style, unit, write_quantity};
use toml_edit::{Document, Item, Table, Value};

/// A problem with the errors that students make in it.
#[derive(Clone, Debug)]
pub struct CorpusProblem {
    /// The analysis and the number of its case, counted from 1.
    pub of: (String, usize),
    /// The name of the answer, and the unit that it is written in.
    pub answer: (String, String),
    /// Symbols of the formulas, by the paths of inputs.
    pub inputs: Vec<(String, String)>,
    /// The right formulas, each with the symbol that it gives; the last one is the answer.
    pub lines: Vec<(String, String)>,
    /// The errors.
    pub errors: Vec<CorpusError>,
}

/// An error of a student: one edit or two.
#[derive(Clone, Debug)]
pub struct CorpusError {
    /// Changes of the formulas or the data.
    pub edits: Vec<CorpusEdit>,
    /// Other causes that give the very same number: place and operation.
    pub also: Vec<(String, String)>,
}

/// An edit of the formulas or the data, and its cause.
#[derive(Clone, Debug)]
pub struct CorpusEdit {
    /// Change of a formula or of data.
    pub what: EditKind,
    /// Place, `input:PATH`, `step:SYMBOL` or `answer`.
    pub at: String,
    /// Operation.
    pub does: String,
    /// The other input that is interchanged.
    pub with: Option<String>,
}

/// Kind of an edit.
#[derive(Clone, Debug)]
pub enum EditKind {
    /// Another formula for a symbol.
    Line(String, String),
    /// Another value of a symbol of the inputs, as a formula.
    Input(String, String),
    /// Another value of the answer, as a formula.
    Result(String),
}

/// Counts of the causes that were found.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Errors that could be made.
    pub made: usize,
    /// Causes that came first and were right.
    pub right: usize,
    /// Those of them that came with other mistakes that give the very same number.
    pub shared: usize,
    /// Those of them that were named.
    pub named: usize,
    /// Right causes among those listed, but not the first.
    pub listed: usize,
    /// Wrong causes that came first.
    pub wrong: usize,
    /// Wrong causes that came first and were named.
    pub named_wrong: usize,
}

impl Tally {
    /// Share of the errors whose cause came first, in percent.
    pub fn right_share(&self) -> f64 {
        100.0 * self.right as f64 / self.made.max(1) as f64
    }

    /// Share of the errors with a wrong cause first, in percent.
    pub fn wrong_share(&self) -> f64 {
        100.0 * self.wrong as f64 / self.made.max(1) as f64
    }
}

/// The problems of every file of a folder.
///
/// # Panics
/// With what is wrong with a file.
#[must_use]
pub fn corpus(folder: &Path) -> Vec<CorpusProblem> {
    let files = fs::read_dir(folder).unwrap_or_else(|err| panic!("{}: {err}", folder.display()));
    let mut paths: Vec<_> = files.filter_map(|file| Some(file.ok()?.path())).collect();
    paths.retain(|path| path.extension().is_some_and(|ext| ext == "toml"));
    paths.sort();
    paths.iter().flat_map(|path| problems(path)).collect()
}

fn problems(path: &Path) -> Vec<CorpusProblem> {
    let text = fs::read_to_string(path).unwrap_or_else(|err| panic!("{}: {err}", path.display()));
    let document = Document::parse(text).unwrap_or_else(|err| panic!("{}: {err}", path.display()));
    let list = document.get("problem").and_then(Item::as_array_of_tables);
    let list = list.unwrap_or_else(|| panic!("{}: no [[problem]]", path.display()));
    list.iter().map(|table| problem(table).unwrap_or_else(|| panic!("{}: {table}", path.display()))).collect()
}

fn problem(table: &Table) -> Option<CorpusProblem> {
    let text = |key: &str| table.get(key).and_then(Item::as_str).map(str::to_owned);
    let case = table.get("case").and_then(Item::as_integer).unwrap_or(1);
    let inputs = table.get("inputs").and_then(Item::as_table_like)?;
    let inputs =
        inputs.iter().filter_map(|(symbol, path)| Some((symbol.to_owned(), path.as_str()?.to_owned())));
    let lines = table.get("lines").and_then(Item::as_array)?.iter().filter_map(|line| split(line.as_str()?));
    let errors = table.get("error").and_then(Item::as_array_of_tables)?.iter().map(error);
    Some(CorpusProblem {
        of: (text("analysis")?, usize::try_from(case).ok()?),
        answer: (text("answer")?, text("unit").unwrap_or_default()),
        inputs: inputs.collect(),
        lines: lines.collect(),
        errors: errors.collect::<Option<_>>()?,
    })
}

fn split(line: &str) -> Option<(String, String)> {
    let (symbol, formula) = line.split_once('=')?;
    Some((symbol.trim().to_owned(), formula.trim().to_owned()))
}

fn error(table: &Table) -> Option<CorpusError> {
    let edits = table.get("edits").and_then(Item::as_array)?.iter();
    let edits = edits.map(|edit| {
        let edit = edit.as_inline_table()?;
        let text = |key: &str| edit.get(key).and_then(Value::as_str).map(str::to_owned);
        let what = match (text("write"), text("input"), text("result")) {
            (Some(line), None, None) => {
                split(&line).map(|(symbol, formula)| EditKind::Line(symbol, formula))?
            }
            (None, Some(symbol), None) => EditKind::Input(symbol, text("value")?),
            (None, None, Some(formula)) => EditKind::Result(formula),
            _ => return None,
        };
        Some(CorpusEdit { what, at: text("at")?, does: text("does")?, with: text("with") })
    });
    let pair = |pair: &Value| {
        let pair = pair.as_array()?;
        Some((pair.get(0)?.as_str()?.to_owned(), pair.get(1)?.as_str()?.to_owned()))
    };
    let also = table.get("also").and_then(Item::as_array).into_iter().flatten();
    Some(CorpusError { edits: edits.collect::<Option<_>>()?, also: also.filter_map(pair).collect() })
}

/// A problem of the corpus with its solution.
pub struct Solved<'p> {
    /// The problem.
    pub problem: &'p CorpusProblem,
    /// Analysis.
    pub entry: &'static Entry,
    record: Record,
    /// The solution.
    pub solution: Solution,
    inputs: BTreeMap<String, f64>,
}

impl<'p> Solved<'p> {
    /// The problem solved, every number of its data so many times as large by what `factor` gives for its place; `None`
    /// where these data have no solution.
    ///
    /// # Panics
    /// If the formulas do not give the answer of the program.
    pub fn new(problem: &'p CorpusProblem, factor: &dyn Fn(usize) -> f64) -> Option<Self> {
        let (id, case) = &problem.of;
        let entry = find(id).unwrap_or_else(|| panic!("there is no {id}"));
        let cases = cases::cases(entry).expect("the cases of an analysis can be read");
        let mut record = cases[case - 1].record(entry).expect("a case can be read");
        // A count stays as it is given.
        let counts = counts(&record);
        let given = vary::inputs(&record);
        for (place, (_, path)) in problem.inputs.iter().enumerate() {
            let Some(input) = given.iter().find(|input| input.path == *path) else {
                assert!(counts.contains_key(path), "{id}: there is no input {path}");
                continue;
            };
            record = vary::changed(&record, path, factor(place) * input.si)?;
        }
        let solution = entry.solve(&record, &Stop::new()).ok()?;
        let numbers = vary::inputs(&record);
        let si = |path: &str| {
            let number = numbers.iter().find(|input| input.path == path).map(|input| input.si);
            number.or_else(|| counts.get(path).copied()).unwrap_or(f64::NAN)
        };
        let inputs = problem.inputs.iter().map(|(symbol, path)| (symbol.clone(), si(path))).collect();
        let solved = Self { problem, entry, record, solution, inputs };
        let right = solved.value(&[]).unwrap_or_else(|why| panic!("{id}: {why}"));
        let ours = solved.solution.answer(&problem.answer.0).and_then(dalembert_core::Answer::si);
        let ours = ours.unwrap_or_else(|| panic!("{id}: {} is not a number", problem.answer.0));
        if (right - ours).abs() > 1e-6 * ours.abs() {
            // The lines are those of the case: other data may be decided by another condition, such as the other one of two
            // resonances.
            let is_case = (0..problem.inputs.len()).all(|place| factor(place) == 1.0);
            assert!(!is_case, "{id}: {right} by hand, {ours} by the program");
            return None;
        }
        Some(solved)
    }

    /// The answer with these edits.
    fn value(&self, edits: &[CorpusEdit]) -> Result<f64, String> {
        let mut known = self.inputs.clone();
        let value = |formula: &str, known: &BTreeMap<String, f64>| {
            value_of_numbers(formula, &|name| known.get(name).copied())
                .map_err(|why| format!("{formula}: {}", why.english()))
        };
        for edit in edits {
            if let EditKind::Input(symbol, formula) = &edit.what {
                let taken = value(formula, &known)?;
                known.insert(symbol.clone(), taken);
            }
        }
        let mut answer = f64::NAN;
        for (symbol, formula) in &self.problem.lines {
            let edited = edits.iter().find_map(|edit| match &edit.what {
                EditKind::Line(of, formula) if of == symbol => Some(formula),
                _ => None,
            });
            answer = value(edited.unwrap_or(formula), &known)?;
            known.insert(symbol.clone(), answer);
        }
        for edit in edits {
            if let EditKind::Result(formula) = &edit.what {
                answer = value(formula, &known)?;
            }
        }
        Ok(answer)
    }

    /// The wrong answer as a student writes it with so many digits; `None` where it has no value, or looks right.
    #[must_use]
    pub fn written(&self, error: &CorpusError, digits: u8) -> Option<String> {
        let si = self.value(&error.edits).ok().filter(|si| si.is_finite())?;
        self.typed(si, digits)
    }

    /// A number as it is typed, unless it looks right.
    #[must_use]
    pub fn typed(&self, si: f64, digits: u8) -> Option<String> {
        let answer = self.solution.answer(&self.problem.answer.0)?;
        let unit = unit(&self.problem.answer.1).expect("a unit of the corpus can be read");
        let text = write_quantity(si, &unit, Style { digits, ..Style::default() });
        matches!(check::compare(answer, &text), Verdict::Wrong | Verdict::RoundedEarly(_)).then_some(text)
    }

    /// Causes that the search finds for an answer.
    #[must_use]
    pub fn causes(&self, typed: &str) -> Vec<Cause> {
        self.searched(typed, None)
    }

    /// The same; `report` receives what is found on the way.
    pub fn searched(&self, typed: &str, report: Option<&mut dyn FnMut(Causes)>) -> Vec<Cause> {
        let typed = [(self.problem.answer.0.clone(), typed.to_owned())];
        let found = check::causes(self.entry, &self.record, &self.solution, &typed, &Stop::new(), report);
        found.into_iter().next().map_or_else(Vec::new, |(_, causes)| causes)
    }

    /// True if a cause is that of the error: the same operations at the same places.
    #[must_use]
    pub fn is_cause(&self, cause: &Cause, error: &CorpusError) -> bool {
        cause.all_mistakes().any(|mistakes| self.is_explanation(mistakes, error))
    }

    fn is_explanation(&self, mistakes: &[Mistake], error: &CorpusError) -> bool {
        let [first, rest @ ..] = &error.edits[..] else { return false };
        match (mistakes, rest) {
            ([only], []) => {
                let also = error.also.iter().any(|(at, does)| self.fits(only, at, does, None));
                also || self.fits(only, &first.at, &first.does, first.with.as_deref())
            }
            ([one, other], [second]) => {
                let fits = |mistake: &Mistake, edit: &CorpusEdit| {
                    self.fits(mistake, &edit.at, &edit.does, edit.with.as_deref())
                };
                (fits(one, first) && fits(other, second)) || (fits(one, second) && fits(other, first))
            }
            _ => false,
        }
    }

    /// True if a mistake is at a place, and of that operation. An error in a step is also found in a number that goes into its
    /// formula, or in the term that it is of the next step.
    fn fits(&self, mistake: &Mistake, at: &str, does: &str, with: Option<&str>) -> bool {
        let operation = mistake.operation();
        // What an analysis says of an error of its own is the error, whatever it is called here.
        if operation == "common" {
            return self.is_place(mistake, at, with);
        }
        // A factor of two has several names, and so has an angle in degrees.
        let alike: &[&[&str]] = &[
            &["half", "factor"],
            &["degrees", "unit"],
            &["model", "alternative", "factor"],
            &["half", "factor", "left-out", "twice"],
            &["weight", "factor", "left-out"],
            &["sign", "direction"],
        ];
        // A factor of a thousand in the answer is one of its unit.
        let is_unit = |word: &str| ["unit", "power-of-ten"].contains(&word);
        if mistake.place == Place::Answer && is_unit(operation) && is_unit(does) {
            return self.is_place(mistake, at, with);
        }
        // Another unit of a given value is a factor of it.
        let is_given = matches!(mistake.place, Place::Input(..));
        if is_given && [(operation, does), (does, operation)].contains(&("unit", "factor")) {
            return self.is_place(mistake, at, with);
        }
        let is_two = |operation: &str| operation != "left-out" || self.is_about_a_number(mistake);
        let is_alike = |group: &&[&str]| {
            group.contains(&operation) && group.contains(&does) && is_two(operation) && is_two(does)
        };
        (operation == does || alike.iter().any(is_alike)) && self.is_place(mistake, at, with)
    }

    /// True if a mistake is about a number of a formula, not a quantity.
    fn is_about_a_number(&self, mistake: &Mistake) -> bool {
        mistake.of.is_none_or(|id| self.solution.trace.node(id).op == Op::Literal)
    }

    fn is_place(&self, mistake: &Mistake, at: &str, with: Option<&str>) -> bool {
        let symbol_of = |step: usize| printer::symbol(&self.solution.steps[step].symbol);
        let about = mistake.of.map(|id| match &self.solution.trace.node(id).op {
            Op::Step(step) => format!("step:{}", symbol_of(*step)),
            Op::Given { path, .. } => format!("input:{path}"),
            _ => String::new(),
        });
        let is_about = about.as_deref() == Some(at);
        match &mistake.place {
            Place::Answer => {
                let last = self.problem.lines.last().map(|(symbol, _)| symbol.as_str());
                at == "answer" || self.is_last_step(at) || at.strip_prefix("step:") == last
            }
            Place::Problem => true,
            Place::Input(path, _) => {
                let other = match &mistake.change {
                    check::Change::Interchanged(path, _) => Some(format!("input:{path}")),
                    _ => None,
                };
                let here = format!("input:{path}");
                at == here
                    || (with == Some(&here) && other.as_deref() == Some(at))
                    || here.starts_with(&format!("{at}."))
                    || self.goes_into(path, at)
            }
            Place::Step(step, symbol) => {
                let here = format!("step:{}", printer::symbol(symbol));
                at == here
                    || is_about
                    || (at == "answer" && self.is_last_step(&here))
                    || self.is_term_of(*step, at)
            }
        }
    }

    /// True if a step holds the answer.
    fn is_last_step(&self, at: &str) -> bool {
        let answer = self.solution.answer(&self.problem.answer.0);
        let Some(dalembert_core::AnswerValue::Number(_, id)) = answer.map(|answer| &answer.value) else {
            return false;
        };
        let last = self.solution.steps.iter().find(|step| step.result == *id);
        last.is_some_and(|step| at == format!("step:{}", printer::symbol(&step.symbol)))
    }

    /// The numbers that the formula of a step takes directly.
    fn operands(&self, step: usize) -> Vec<Id> {
        let mut open: Vec<Id> = self.solution.steps[step].formula.into_iter().collect();
        let mut found = Vec::new();
        while let Some(id) = open.pop() {
            found.push(id);
            open.extend(self.solution.trace.operands(id));
        }
        found
    }

    fn steps_at(&self, at: &str) -> Vec<usize> {
        let is_it =
            |step: &usize| at == format!("step:{}", printer::symbol(&self.solution.steps[*step].symbol));
        (0..self.solution.steps.len()).filter(is_it).collect()
    }

    /// True if an input, or one of those below a choice, stands in the formula of a step.
    fn goes_into(&self, path: &str, at: &str) -> bool {
        let below = format!("{path}.");
        let is_it = |id: &Id| match &self.solution.trace.node(*id).op {
            Op::Given { path: own, .. } => own == path || own.starts_with(&below),
            _ => false,
        };
        self.steps_at(at).into_iter().any(|step| self.operands(step).iter().any(is_it))
    }

    /// True if a step stands in the formula of the step at a place, or the other way round.
    fn is_term_of(&self, step: usize, at: &str) -> bool {
        let has = |outer: usize, inner: usize| {
            self.operands(outer).iter().any(|id| self.solution.trace.node(*id).op == Op::Step(inner))
        };
        self.steps_at(at).into_iter().any(|other| has(other, step))
    }
}

/// The whole numbers among the inputs, by their paths.
fn counts(record: &Record) -> BTreeMap<String, f64> {
    let mut found = BTreeMap::new();
    record.leaves(&mut |path, _, value| {
        if let dalembert_core::Value::Count(count) = value {
            found.insert(path.to_owned(), *count as f64);
        }
    });
    found
}

/// The errors of problems as the search sees them, single ones and pairs, with so many digits.
#[must_use]
pub fn tally(
    problems: &[CorpusProblem],
    digits: u8,
    factor: &dyn Fn(usize) -> f64,
    log: &mut String,
) -> [Tally; 2] {
    let mut all = [Tally::default(); 2];
    for problem in problems {
        let Some(solved) = Solved::new(problem, factor) else {
            let _ = writeln!(log, "{} {}: no solution", problem.of.0, problem.of.1);
            continue;
        };
        for error in &problem.errors {
            // A digit copied wrongly is one of the given number.
            let is_digit = |edit: &CorpusEdit| ["digit", "swapped"].contains(&edit.does.as_str());
            if factor(0) != 1.0 && error.edits.iter().any(is_digit) {
                continue;
            }
            let Some(typed) = solved.written(error, digits) else { continue };
            let causes = solved.causes(&typed);
            let tally = &mut all[usize::from(error.edits.len() > 1)];
            tally.made += 1;
            let is_right = |cause: &Cause| solved.is_cause(cause, error);
            match causes.first() {
                Some(first) if is_right(first) => {
                    tally.right += 1;
                    tally.shared += usize::from(!first.equivalents.is_empty());
                    tally.named += usize::from(first.is_named);
                    continue;
                }
                Some(first) => {
                    tally.wrong += 1;
                    tally.named_wrong += usize::from(first.is_named);
                }
                None => {}
            }
            tally.listed += usize::from(causes.iter().any(is_right));
            let edits: Vec<String> = error
                .edits
                .iter()
                .map(|edit| {
                    let what = match &edit.what {
                        EditKind::Line(symbol, formula) => format!("{symbol} = {formula}"),
                        EditKind::Input(symbol, formula) => format!("{symbol} := {formula}"),
                        EditKind::Result(formula) => formula.clone(),
                    };
                    format!("{what} [{} {}]", edit.at, edit.does)
                })
                .collect();
            let (id, case) = &problem.of;
            let _ = writeln!(log, "{id} {case} {} = {typed}: {}", problem.answer.0, edits.join(" & "));
            for cause in &causes {
                let named = if cause.is_named { "named" } else { "possible" };
                let ops: Vec<_> = cause.mistakes.iter().map(Mistake::operation).collect();
                let right = if is_right(cause) { "RIGHT " } else { "" };
                let text = cause.text(&solved.solution).english();
                let _ = writeln!(log, "    {right}{named}: {text} [{}]", ops.join(", "));
            }
        }
    }
    all
}
