//! Unknown inputs: found from answers that are given in their place.
//!
//! With one unknown and one given answer the range is examined at 400 points: every change of sign of
//! `answer − given` is bracketed and refined, and so is every point where the difference comes nearest to zero. With
//! several, the normalised differences are brought to zero by Levenberg and Marquardt's method from 33 starts; with more
//! given answers than unknowns their squares are made least. A solution counts only if a solve with it returns every
//! given answer to 1e-9. Where an answer is to be least or largest, the unknowns are its optimum.
//!
//! Where the trace of one unknown has an inverse, its formula is a step, and the solutions are all that there are.

mod inverse;
mod optimum;
pub(crate) mod search;

use std::sync::Arc;

use dalembert_units::Unit;

pub use self::optimum::{Candidate, Optimum};
use self::{
    inverse::{Inverse, Question, inverse},
    optimum::{Setting, objectives, wanted},
    search::{ACCEPTED, Target, Variable, search},
};
use crate::{
    Answer, AnswerValue, Cell, Column, Entry, Exhibit, FieldError, Name, Record, Refusal, Sheet, SolveError,
    Stop, Symbol, TableExhibit, Term, Text, Worksheet, cases,
    definitions::{AXES, GivenAnswer, Goal, Plan, Unknown},
    intern::fixed,
    intern::intern,
    linked, reading,
    tolerances::Corners,
    vary::{self, VariedInput, WIDE},
};

/// Unknown inputs of a problem as they were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Determined {
    /// The unknowns.
    pub unknowns: Vec<DeterminedInput>,
    /// The given answers that they were found from.
    pub givens: Vec<ReachedAnswer>,
    /// Every solution in the range, in SI, ascending; a value for each unknown. The working is that of the first one.
    pub solutions: Vec<Vec<f64>>,
    /// Number of points of the range of one unknown, or of starts for several.
    pub points: usize,
    /// The inputs with the first solution.
    pub record: Record,
    /// Formula of the one unknown, where the trace has an inverse.
    pub(crate) inverse: Option<Inverse>,
    /// Search for the optimum, where an answer is to be least or largest.
    pub optimum: Option<Optimum>,
}

/// An input or a definition that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct DeterminedInput {
    /// The path of the input, or the name of the definition.
    pub name: String,
    /// Name in words.
    pub label: Text,
    /// Symbol in formulas.
    pub symbol: &'static str,
    /// The unit it is shown in.
    pub unit: Unit,
    /// The range that was searched, in SI.
    pub range: [f64; 2],
    /// Standard uncertainty, in SI, where every given answer has one.
    pub uncertainty: Option<f64>,
}

/// An answer that something is required of, and what the problem answers with the unknowns found.
#[derive(Clone, Debug, PartialEq)]
pub struct ReachedAnswer {
    /// Name of the answer.
    pub name: String,
    /// Name in words.
    pub label: Text,
    /// Requirement.
    pub goal: Goal,
    /// The unit it was given in.
    pub unit: Unit,
    /// Given value or limit, in SI; the value found where it is the least or the largest.
    pub given: f64,
    /// Value with the unknowns found, in SI.
    pub reached: f64,
}

/// The most solutions that are listed in a sentence.
const LISTED: usize = 6;

/// The problem with its unknowns found; `None` where nothing is unknown.
pub(crate) fn determine(entry: &Entry, record: &Record, stop: &Stop) -> Result<Option<Record>, SolveError> {
    let Some(plan) = &record.plan else { return Ok(None) };
    let Some((unknowns, givens)) = plan.search() else { return Ok(None) };
    let known = Record { plan: Some(Arc::new(plan.without_unknowns())), ..record.clone() };
    let inputs = unknown_inputs(&known, plan, unknowns)?;
    let mut variables = Vec::new();
    for (unknown, input) in unknowns.iter().zip(&inputs) {
        variables.push(variable(entry, &known, unknown, input)?);
    }
    let (begin, answers) = begin(entry, &known, &variables, &inputs, (plan, givens), stop)?;
    let objectives = objectives(givens)?;
    // A solution is found at the values as they are, an optimum at every end of the tolerances.
    let tolerances = if objectives.is_some() { plan.tolerances() } else { &[] };
    let corners = Corners::new(tolerances, &begin, &inputs)?;
    let names: Vec<String> = answers.iter().map(|answer| answer.name.to_string()).collect();
    let mut again = corners.perturbed(entry, &begin, &inputs, names)?;
    if let Some(lost) = inputs.iter().find(|input| !again.has_input(&input.path)) {
        return Err(fixed_input(plan, &lost.path));
    }
    if let Some(lost) = (0..answers.len()).find(|n| !again.answers.contains(&answers[*n].name.to_string())) {
        return Err(fault(
            format!("{}.name", givens[lost].path),
            not_a_number(answers[lost].name, &again.answers),
        ));
    }
    if let Some(objectives) = objectives {
        let setting = Setting { begin, plan, inputs, variables, givens, answers };
        return setting.determine(objectives, &corners, &mut again, stop).map(Some);
    }
    let targets: Vec<Target> =
        givens.iter().map(|given| Target { si: given.si, tolerance: given.tolerance }).collect();
    let mut evaluate = |x: &[f64]| {
        let changes: Vec<(usize, f64)> = x.iter().copied().enumerate().collect();
        again.with(&changes, stop)
    };
    let mut found = search(&mut evaluate, &variables, &targets, stop)?;
    if let ([_], [unknown], [input]) = (&variables[..], unknowns, &inputs[..])
        && found.solutions.is_empty()
        && found.without_influence.is_none()
        && let Some(wider) = wider(&variables[0], unknown, input)
    {
        let again = search(&mut evaluate, std::slice::from_ref(&wider), &targets, stop)?;
        if !again.solutions.is_empty() {
            (found, variables) = (again, vec![wider]);
        }
    }
    let label = |answer: &Answer| answer.title();
    if let Some(blind) = found.without_influence {
        let why = Text::new("{answer} does not depend on what is unknown: give another answer")
            .with_text("answer", label(&answers[blind]));
        return Err(fault(format!("{}.name", givens[blind].path), why));
    }
    let Some(first) = found.solutions.first() else {
        return Err(none(&found, &variables, &inputs, givens, &answers).into());
    };
    if !found.is_determined {
        let names: Vec<&str> = inputs.iter().map(|input| input.path.as_str()).collect();
        let why = Text::new(
            "the given answers do not determine {unknowns} separately: many values give the same answers; give another answer",
        );
        return Err(Refusal::because(why.with("unknowns", names.join(", "))).into());
    }
    let solved = solved(&begin, plan, &inputs, first)?;
    let size = found.size(&targets[0]);
    let reached = evaluate(first)?;
    let mut determined = Determined {
        unknowns: inputs
            .iter()
            .zip(&variables)
            .enumerate()
            .map(|(n, (input, variable))| DeterminedInput {
                label: input.label.clone(),
                symbol: input.symbol,
                unit: input.unit.clone(),
                range: variable.range,
                uncertainty: found.uncertainties.as_ref().map(|all| all[n]),
                name: input.path.clone(),
            })
            .collect(),
        givens: givens
            .iter()
            .zip(&answers)
            .zip(reached)
            .map(|((given, answer), reached)| ReachedAnswer {
                name: answer.name.to_string(),
                label: label(answer),
                goal: given.goal,
                unit: given.unit.clone(),
                given: given.si,
                reached,
            })
            .collect(),
        solutions: found.solutions,
        points: found.points,
        record: Record { plan: None, ..solved.clone() },
        inverse: None,
        optimum: None,
    };
    let by_search = with_determined(solved, determined.clone());
    let ([unknown], [given], [planned]) = (&determined.unknowns[..], &determined.givens[..], givens) else {
        return Ok(Some(by_search));
    };
    let Ok(base) = entry.solve_nominal(&by_search, stop) else { return Ok(Some(by_search)) };
    let defects = base.defects.len();
    let question = Question {
        unknown,
        given,
        row: &planned.path,
        found: &determined.solutions,
        scan: &found.scan,
        size,
        evaluate: &mut evaluate,
    };
    let Some((solutions, formula)) = inverse(base, question)? else { return Ok(Some(by_search)) };
    let solved = self::solved(&begin, plan, &inputs, &solutions[0])?;
    determined.record = Record { plan: None, ..solved.clone() };
    (determined.solutions, determined.inverse) = (solutions, Some(formula));
    let first = determined.solutions[0][0];
    let name = determined.unknowns[0].name.clone();
    let by_formula = with_determined(solved, determined);
    // A formula that the sheet does not take is none.
    let is_right = entry.solve_nominal(&by_formula, stop).is_ok_and(|solution| {
        let is_near = |(si, _): (f64, &Unit)| (si - first).abs() <= ACCEPTED * first.abs();
        solution.defects.len() == defects && solution.computed_input(&name).is_some_and(is_near)
    });
    stop.check()?;
    Ok(Some(if is_right { by_formula } else { by_search }))
}

/// The problem with values of the unknowns.
fn solved(begin: &Record, plan: &Plan, inputs: &[VariedInput], x: &[f64]) -> Result<Record, SolveError> {
    inputs.iter().zip(x).try_fold(begin.clone(), |record, (input, si)| {
        vary::changed(&record, &input.path, *si).ok_or_else(|| fixed_input(plan, &input.path))
    })
}

fn with_determined(mut solved: Record, determined: Determined) -> Record {
    if let Some(plan) = &mut solved.plan {
        Arc::make_mut(plan).determine(determined);
    }
    solved
}

fn fault(path: impl Into<String>, why: impl Into<Text>) -> SolveError {
    SolveError::Fields(vec![FieldError::new(path, why)])
}

/// Refusal of an unknown that the analysis cannot change.
fn fixed_input(plan: &Plan, name: &str) -> SolveError {
    fault(plan.error_path(name), "this input cannot be varied, so it cannot be unknown")
}

/// Refusal of a given answer that is none of the numbers that are known.
fn not_a_number(name: impl std::fmt::Display, known: &[String]) -> Text {
    Text::new("no answer `{name}` with a single number; the answers are {known}")
        .with("name", name)
        .with("known", known.join(", "))
}

/// The unknowns as inputs that vary.
fn unknown_inputs(known: &Record, plan: &Plan, unknowns: &[Unknown]) -> Result<Vec<VariedInput>, SolveError> {
    let all = vary::inputs(known);
    let input = |unknown: &Unknown| {
        let found = all.iter().find(|input| input.path == unknown.name).cloned();
        found.ok_or_else(|| fixed_input(plan, &unknown.name))
    };
    unknowns.iter().map(input).collect()
}

/// The range of an unknown: as typed, or from 1/1000 to 1000 times the value typed or that of the first case that has
/// one, within the limits of the field; of an angle a whole turn; of a component of a vector to both sides of zero.
fn variable(
    entry: &Entry,
    known: &Record,
    unknown: &Unknown,
    input: &VariedInput,
) -> Result<Variable, SolveError> {
    if !unknown.choices.is_empty() {
        return Ok(Variable::one_of(unknown.choices.clone()));
    }
    if let Some(range) = unknown.range {
        return Ok(Variable::new(range, unknown.start));
    }
    let start = unknown.start.or_else(|| {
        let (entry, name) = linked::problem_of(entry, &unknown.name);
        let records = cases::cases(entry).ok()?.into_iter().filter_map(|case| case.record(entry).ok());
        let mut values = records.filter_map(|mut record| vary::number(&mut record, name).copied());
        values.find(|si| si.is_finite() && *si != 0.0)
    });
    if unknown.is_component {
        let size = size_of_vector(known, &unknown.name);
        return Ok(Variable::new(input.permitted([-SIZES * size, SIZES * size]), unknown.start));
    }
    let own = input.measure.own_unit();
    let around = start.unwrap_or_else(|| own.si(1.0));
    let range = input.range_around(around);
    if range[0] < range[1] {
        return Ok(Variable::new(range, start));
    }
    Err(fault(&unknown.name, "write a range to search, as in ? 1 kg .. 100 kg"))
}

/// A range that was assumed, a thousand times wider, where nothing was found in it.
fn wider(variable: &Variable, unknown: &Unknown, input: &VariedInput) -> Option<Variable> {
    if unknown.range.is_some() || !unknown.choices.is_empty() || input.is_angle() {
        return None;
    }
    let [from, to] = variable.range;
    let low = if from < 0.0 { from * WIDE } else { from / WIDE };
    let range = input.permitted([low, to * WIDE]);
    (range != variable.range).then(|| Variable::new(range, unknown.start))
}

/// The range of a component of a vector without one, in sizes of its largest component, to both sides.
const SIZES: f64 = 100.0;

/// The largest component, in SI, of the vector that a component is of; what is unknown counts as one unit.
fn size_of_vector(known: &Record, component: &str) -> f64 {
    let mut known = known.clone();
    let vector = component.rsplit_once('.').map_or("", |(vector, _)| vector);
    let mut size = |axis| vary::number(&mut known, &format!("{vector}.{axis}")).map_or(0.0, |si| si.abs());
    AXES.into_iter().map(&mut size).fold(0.0, f64::max)
}

/// A point of the range at which the problem has answers, and the answers that are given there.
fn begin(
    entry: &Entry,
    known: &Record,
    variables: &[Variable],
    inputs: &[VariedInput],
    (plan, givens): (&Plan, &[GivenAnswer]),
    stop: &Stop,
) -> Result<(Record, Vec<Answer>), SolveError> {
    let mut refused = None;
    for start in search::starts(variables) {
        let changes = inputs.iter().zip(&start).map(|(input, si)| (input.path.as_str(), *si));
        let Some(changed) = vary::changed_together(known, changes) else { continue };
        let solution = match entry.solve_nominal(&changed, stop) {
            Ok(solution) => solution,
            Err(SolveError::Refused(Refusal::Stopped)) => return Err(Refusal::Stopped.into()),
            Err(error) => {
                refused.get_or_insert(error);
                continue;
            }
        };
        let mut answers = Vec::new();
        let mut errors = Vec::new();
        for given in givens {
            let name = plan.question(&given.name).unwrap_or_else(|| given.name.clone());
            match solution.answer(&name).filter(|answer| answer.si().is_some()) {
                None => {
                    let scalars = solution.answers.iter().filter(|answer| answer.si().is_some());
                    let known: Vec<String> = scalars.map(|answer| answer.name.to_string()).collect();
                    let why = not_a_number(name, &known);
                    errors.push(FieldError::new(format!("{}.name", given.path), why));
                }
                Some(answer) if !given.goal.is_extreme() && !answer.dim().agrees(given.unit.dim) => {
                    let text = dalembert_units::write_quantity(given.si, &given.unit, <_>::default());
                    let why = reading::of_another_dimension(&text, given.unit.dim, &answer.unit);
                    errors.push(FieldError::new(format!("{}.value", given.path), why));
                }
                Some(answer) => answers.push(answer.clone()),
            }
        }
        return if errors.is_empty() { Ok((changed, answers)) } else { Err(SolveError::Fields(errors)) };
    }
    Err(refused.unwrap_or_else(|| {
        Refusal::because("no value in the range of the unknowns is permitted with these inputs").into()
    }))
}

/// Reason for which there is no solution: what the answer covers, or how near the best values come.
fn none(
    found: &search::Found,
    variables: &[Variable],
    inputs: &[VariedInput],
    givens: &[GivenAnswer],
    answers: &[Answer],
) -> Refusal {
    let quantity = |text: Text, name, si, unit: &Unit| text.with_quantity(name, si, fixed(unit));
    if let ([input], [given], [answer]) = (inputs, givens, answers) {
        let range = variables[0].range;
        let text = match found.covered {
            Some([least, most]) => {
                let text = Text::new(
                    "no {input} from {from} to {to} gives {answer} = {given}: the answer lies between {least} (at {at_least}) and {most} (at {at_most})",
                );
                let text = quantity(text, "least", least.1, &given.unit);
                let text = quantity(text, "most", most.1, &given.unit);
                let text = quantity(text, "at_least", least.0, &input.unit);
                quantity(text, "at_most", most.0, &input.unit)
            }
            None => Text::new(
                "no {input} from {from} to {to} gives {answer} = {given}: the problem has no answer there",
            ),
        };
        let text = quantity(text, "from", range[0], &input.unit);
        let text = quantity(text, "to", range[1], &input.unit);
        let text = quantity(text, "given", given.si, &given.unit);
        return Refusal::because(
            text.with_text("input", input.label.clone()).with_text("answer", answer.title()),
        );
    }
    let Some((x, reached)) = &found.nearest else {
        return Refusal::because(
            "the problem has no answer at any of the starts of the search: write narrower ranges, as in ? 1 kg .. 100 kg",
        );
    };
    let at = inputs.iter().zip(x).map(|(input, si)| equals(input.label.clone(), *si, &input.unit));
    let found = givens.iter().zip(answers).zip(reached);
    let found = found.map(|((given, answer), si)| equals(answer.title(), *si, &given.unit));
    let text = Text::new(
        "no solution in the ranges searched; the nearest: {reached}, with {at}; write other ranges, as in ? 1 kg .. 100 kg",
    );
    Refusal::because(text.with_text("reached", listed(found)).with_text("at", listed(at)))
}

fn equals(label: Text, si: f64, unit: &Unit) -> Text {
    Text::new("{label} = {value}").with_text("label", label).with_quantity("value", si, fixed(unit))
}

/// Texts one after another: `a; b; c`.
fn listed(texts: impl Iterator<Item = Text>) -> Text {
    let joined = |all: Text, one: Text| Text::new("{all}; {one}").with_text("all", all).with_text("one", one);
    texts.reduce(joined).unwrap_or_default()
}

impl ReachedAnswer {
    /// Requirement in words: `amplitude = 2 mm`, `stress ≤ 100 MPa`.
    pub fn requirement(&self) -> Text {
        wanted(self.label.clone(), self.goal, self.given, &self.unit)
    }
}

impl Determined {
    /// Description of the search for an unknown; `None` where there is none of that name.
    fn why(&self, name: &str) -> Option<Text> {
        let unknown = self.unknowns.iter().find(|unknown| unknown.name == name)?;
        let givens = self.givens.iter().map(ReachedAnswer::requirement);
        let how = match self.unknowns.len() {
            _ if let Some(optimum) = &self.optimum => match optimum.starts {
                _ if self.givens.iter().filter(|given| given.goal.is_extreme()).count() > 1 => Text::new(
                    "{unknown} is unknown: the compromise nearest to the best of both on the Pareto front from {from} to {to} for {givens}",
                ),
                0 => Text::new("{unknown} is unknown: the best choice for {givens}"),
                _ => Text::new(
                    "{unknown} is unknown: the optimum from {from} to {to} for {givens}; {ended} of {points} local searches end here",
                )
                .with("ended", optimum.ended),
            },
            _ if self.givens.len() > self.unknowns.len() => {
                Text::new("{unknown} is unknown: least squares of {givens}")
            }
            1 if let Some(inverse) = &self.inverse => match inverse.branches() {
                [] => Text::new(
                    "{unknown} is unknown: its formula follows from {givens}; all solutions from {from} to {to}: {count}",
                ),
                several => Text::new(
                    "{unknown} is unknown: its formula follows from {givens}; all solutions from {from} to {to}, with {branches}: {count}",
                )
                .with_text("branches", listed(several.iter().cloned())),
            },
            1 => Text::new(
                "{unknown} is unknown: found from {givens}; solutions from {from} to {to}, at {points} points: {count}",
            ),
            _ => Text::new(
                "{unknown} is unknown: found from {givens}; solutions from {from} to {to}, from {points} starts: {count}",
            ),
        };
        let [from, to] = unknown.range;
        let unit = fixed(&unknown.unit);
        Some(
            how.with_text("unknown", unknown.label.clone())
                .with_text("givens", listed(givens))
                .with_quantity("from", from, unit)
                .with_quantity("to", to, unit)
                .with("points", self.points)
                .with("count", self.solutions.len()),
        )
    }

    /// Returns true if the solutions are all that there are in the range: the trace was inverted.
    pub fn has_all(&self) -> bool {
        self.inverse.is_some()
    }

    /// Writes an unknown as a step, by its formula where it has one; `None` where there is none of that name.
    pub(crate) fn write<'s>(
        &self,
        sheet: &'s Sheet<'s>,
        name: &str,
        (symbol, unit): (Symbol, &'static str),
        si: f64,
    ) -> Option<Term<'s>> {
        let why = self.why(name)?;
        Some(match (&self.inverse, &self.givens[..]) {
            (Some(inverse), [given]) => inverse.write(sheet, (symbol, unit), given, why),
            _ => sheet.numerical(symbol, unit, si, why),
        })
    }

    /// Compares the given answers with those of the solved sheet, and shows every solution.
    pub(crate) fn conclude(&self, plan: &Plan, sheet: &Sheet<'_>) {
        let exact = self.optimum.is_some() || self.givens.len() == self.unknowns.len();
        for given in self.givens.iter().filter(|_| exact) {
            let value = sheet.solution().answer(&given.name).map(|answer| answer.value.clone());
            let Some(AnswerValue::Number(_, node)) = value else { continue };
            if given.goal != Goal::Value {
                continue;
            }
            let residual = sheet.term(node) - sheet.constant(given.given, &given.unit);
            let what = Text::new("{answer} is the given one").with_text("answer", given.label.clone());
            // Of a zero, the size of what cancels in it.
            let scale = match given.given.abs().max(given.reached.abs()) {
                scale if given.given != 0.0 => scale,
                scale => scale.max(sheet.error(node) / f64::EPSILON),
            };
            sheet.check_residual(what, residual, scale, ACCEPTED * scale);
        }
        for unknown in &self.unknowns {
            let name = Name::from(intern(&unknown.name));
            if let Some(id) = sheet.lifted(&unknown.name)
                && sheet.solution().answer(&unknown.name).is_none()
            {
                sheet.answer(name, plan.label(&unknown.name), sheet.term(id));
                sheet.mark_asked(name, plan.problem_name(&unknown.name), false);
            }
            let searched = self.inverse.as_ref().and_then(Inverse::searched);
            if let (Some(searched), Some(id)) = (searched, sheet.lifted(&unknown.name)) {
                let what = Text::new("{unknown} by its formula is the solution of the search");
                let what = what.with_text("unknown", unknown.label.clone());
                sheet.check(what, sheet.term(id), Term::from(searched));
            }
        }
        if self.solutions.len() > 1 {
            let shown = self.solutions.iter().take(LISTED).map(|solution| {
                let values = self.unknowns.iter().zip(solution);
                listed(values.map(|(unknown, si)| equals(unknown.label.clone(), *si, &unknown.unit)))
            });
            let text = Text::new(
                "{count} solutions in the range searched: {solutions}; the first is worked out; a narrower range, as in ? 1 kg .. 100 kg, chooses another",
            );
            let shown = shown
                .enumerate()
                .map(|(n, one)| Text::new("({n}) {one}").with("n", n + 1).with_text("one", one));
            let text = text.with("count", self.solutions.len()).with_text("solutions", listed(shown));
            sheet.warn(|| text);
        }
        if self.solutions.len() > 1 {
            sheet.show(|| Exhibit::Table(self.table()));
        }
        if !exact {
            sheet.show(|| Exhibit::Table(self.residuals()));
        }
        if let Some(optimum) = &self.optimum {
            optimum.conclude(self, sheet);
        }
    }

    fn table(&self) -> TableExhibit {
        let columns = self.unknowns.iter().map(|unknown| column(unknown.label.clone(), &unknown.unit));
        TableExhibit {
            title: Text::new("Solutions in the range searched"),
            columns: columns.collect(),
            rows: self.solutions.iter().map(|row| row.iter().copied().map(Cell::Number).collect()).collect(),
            foot: Vec::new(),
        }
    }

    fn residuals(&self) -> TableExhibit {
        let mut rows = Vec::new();
        for given in &self.givens {
            let value = |si| Cell::Text(Text::quantity(si, fixed(&given.unit)));
            let share = (given.reached - given.given) / given.given;
            let share = if share.is_finite() { Cell::Number(share) } else { Cell::Empty };
            rows.push(vec![given.label.clone().into(), value(given.given), value(given.reached), share]);
        }
        let words = |heading: &'static str| Column { heading: heading.into(), unit: "" };
        TableExhibit {
            title: Text::new("Given answers and those of the fit"),
            columns: vec![
                words("Answer"),
                words("given value"),
                words("value of the fit"),
                Column { heading: "residual".into(), unit: "%" },
            ],
            rows,
            foot: Vec::new(),
        }
    }
}

fn column(heading: Text, unit: &Unit) -> Column {
    Column { heading, unit: fixed(unit) }
}
