//! The plain reading of a problem with definitions, formulas, questions, configurations and links.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use dalembert_units::Dim;

use super::{
    Plan, PlannedInput,
    names::{self, Named, Place},
    unknowns::AXES,
    working::entry_of,
};
use crate::{
    Answer, Entry, Evaluate, FieldError, Number, Plain, Record, Refusal, Solution, SolveError, Stop, Text,
    formula::{Formula, Operand, evaluate, normalised},
    gravity, printer, vary,
};

/// A problem with a plan, solved again and again with other values of its levers.
struct Planned {
    entry: Entry,
    /// The inputs and the formulas beside them, with the values of the point.
    record: Record,
    plan: Plan,
    levers: Vec<Lever>,
    wanted: Vec<String>,
    /// The plain readings, where all that is wanted is made of numbers among their answers.
    readings: Option<Readings>,
}

/// Place of a number that is varied.
enum Lever {
    /// A definition, by its place.
    Definition(usize),
    /// The input at these paths.
    Input(Vec<String>),
}

/// The plain readings of the problems and configurations that the wanted answers rest on.
struct Readings {
    /// Of each scope.
    solutions: Vec<PlainSolution>,
    /// Values of the questions.
    questions: Vec<Option<(f64, Dim)>>,
    /// The questions, and the inputs and definitions over answers, that are needed.
    needed: BTreeSet<Place>,
    wanted: Vec<Source>,
}

/// The plain reading of a problem or a configuration.
#[derive(Default)]
struct PlainSolution {
    evaluate: Option<Box<dyn Evaluate>>,
    /// Paths, within the problem, of the inputs that change.
    inputs: Vec<String>,
    /// The answers that are needed.
    answers: Vec<NeededAnswer>,
    values: Vec<f64>,
}

/// An answer of a problem that is wanted or named in a formula.
#[derive(Clone, PartialEq)]
struct NeededAnswer {
    /// Name in the formula, or of the answer.
    called: String,
    /// Name of the answer within its problem.
    name: String,
    dim: Dim,
}

/// Place of a wanted number.
#[derive(Clone, Copy)]
enum Source {
    Answer(usize, usize),
    Question(usize),
}

fn unknown(path: &str, why: &'static str) -> SolveError {
    SolveError::Fields(vec![FieldError::new(path, Text::from(why))])
}

/// Prepares the plain reading: `vary` are paths of quantities and names of definitions, `wanted` names of answers.
pub(crate) fn prepare(
    entry: &Entry,
    record: &Record,
    plan: &Plan,
    vary: &[&str],
    wanted: &[&str],
) -> Result<Box<dyn Evaluate>, SolveError> {
    for path in vary {
        if plan.has_formula(path) {
            return Err(unknown(
                path,
                "takes its value from a formula, so it cannot be varied; vary its definitions",
            ));
        }
    }
    let mut inputs = Record { plan: None, ..record.clone() };
    let levers = vary.iter().map(|path| match plan.lever(path) {
        Some(definition) => Lever::Definition(definition),
        None => Lever::Input(vary::places(&mut inputs, path)),
    });
    let mut planned = Planned {
        entry: *entry,
        levers: levers.collect(),
        record: inputs,
        plan: plan.clone(),
        wanted: wanted.iter().map(|name| (*name).to_owned()).collect(),
        readings: None,
    };
    let is_asked = |name: &&str| plan.question(name).is_some();
    let is_plain = !plan.after_solution.iter().any(|place| matches!(place, Place::Input(_)));
    let is_prepared = plan.search().is_none() && !plan.changes_cells(vary);
    if is_prepared && is_plain && !wanted.iter().any(is_asked) {
        let has_no_formula = plan.inputs.iter().all(|input| input.formula.is_none());
        if plan.names.scopes.len() == 1
            && has_no_formula
            && vary.iter().all(|path| plan.lever(path).is_none())
        {
            // What is varied and wanted is of the analysis itself.
            return entry.prepare(&Record { plan: None, ..record.clone() }, vary, wanted);
        }
        // Answers of the analyses alone: no unit is needed, so nothing is worked out.
        planned.readings = Some(Readings::of_answers(plan, vary, wanted, record));
        planned.first()?;
        return Ok(Box::new(planned));
    }
    let solution = entry.solve_nominal(record, &Stop::new())?;
    if let Some(determined) = &solution.determined {
        planned.plan.keep_ranges(determined);
    }
    for name in wanted {
        if solution.answer(name).and_then(Answer::si).is_none() {
            return Err(unknown(name, "is not a number among the answers"));
        }
    }
    if is_prepared {
        planned.readings = Readings::of_solution(plan, vary, wanted, record, &solution);
        // What is read plainly is what is worked out, to the last bit; else the working is read.
        let found = planned.first();
        let worked = |name: &&str| solution.answer(name).and_then(Answer::si);
        if !found.is_ok_and(|found| wanted.iter().filter_map(worked).eq(found)) {
            planned.readings = None;
        }
    }
    Ok(Box::new(planned))
}

impl Readings {
    fn new(plan: &Plan, vary: &[&str], record: &Record) -> Self {
        let scopes = &plan.names.scopes;
        let mut solutions: Vec<PlainSolution> = scopes.iter().map(|_| PlainSolution::default()).collect();
        let levers: Vec<String> = plan.levers().map(|(name, ..)| name).collect();
        let varied = vary.iter().filter(|path| !levers.iter().any(|lever| lever == *path));
        let varied: Vec<String> = varied.flat_map(|path| gravity::shared(record, path)).collect();
        let with_formula = plan.inputs.iter().filter(|input| input.formula.is_some() && !input.is_cell);
        for (at, solution) in solutions.iter_mut().enumerate() {
            let problem = scopes[at].problem;
            let own = varied.iter().filter(|path| plan.names.scope_of_input(path) == problem);
            // What a configuration replaces does not change with the inputs that it replaces.
            let is_there = |inner: &&str| at == problem || !plan.names.is_replaced(at, inner);
            let own = own.filter_map(|path| scopes[problem].inside(path)).filter(is_there);
            let mut inputs: Vec<String> = own.map(str::to_owned).collect();
            let is_own = |input: &&PlannedInput| {
                input.scope == at || input.scope == problem && is_there(&input.inner.as_str())
            };
            for input in with_formula.clone().filter(is_own) {
                for inner in input.numbers() {
                    if !inputs.contains(&inner) {
                        inputs.push(inner);
                    }
                }
            }
            solution.inputs = inputs;
        }
        Self {
            solutions,
            questions: vec![None; plan.questions.len()],
            needed: BTreeSet::new(),
            wanted: Vec::new(),
        }
    }

    fn of_answers(plan: &Plan, vary: &[&str], wanted: &[&str], record: &Record) -> Self {
        let mut readings = Self::new(plan, vary, record);
        for name in wanted {
            let scope = plan.scope_of_answer(name);
            let inner = plan.names.scopes[scope].inside(name).unwrap_or(name);
            let answer = NeededAnswer { called: inner.to_owned(), name: inner.to_owned(), dim: Dim::NONE };
            let column = readings.solutions[scope].need(answer);
            readings.wanted.push(Source::Answer(scope, column));
        }
        readings
    }

    /// `None` where a formula takes what is no number among the answers: a vector, a list, a step.
    fn of_solution(
        plan: &Plan,
        vary: &[&str],
        wanted: &[&str],
        record: &Record,
        solution: &Solution,
    ) -> Option<Self> {
        let mut readings = Self::new(plan, vary, record);
        for name in wanted {
            let question = plan
                .questions
                .iter()
                .position(|question| plan.names.scopes[question.scope].outside(&question.key) == *name);
            let source = match question {
                Some(at) => {
                    readings.need(plan, Place::Question(at), solution)?;
                    Source::Question(at)
                }
                None => {
                    let scope = plan.scope_of_answer(name);
                    let inner = plan.names.scopes[scope].inside(name)?;
                    Source::Answer(scope, readings.need_answer(plan, scope, inner, solution)?)
                }
            };
            readings.wanted.push(source);
        }
        // Inputs of problems that are linked rest on answers; questions and definitions are needed where they are named.
        for place in plan.after_solution.iter().filter(|place| matches!(place, Place::Input(_))) {
            readings.need(plan, *place, solution)?;
        }
        Some(readings)
    }

    /// Takes a question, an input or a definition over answers as needed, with all that it names.
    fn need(&mut self, plan: &Plan, place: Place, solution: &Solution) -> Option<()> {
        if !self.needed.insert(place) {
            return Some(());
        }
        let scope = plan.scope_of(place);
        for (name, _) in plan.formula_of(place).map(Formula::names).unwrap_or_default() {
            match plan.find(place, name) {
                Some(Named::Answer(scope, name)) => {
                    self.need_answer(plan, scope, &name, solution)?;
                }
                Some(Named::Question(at)) => self.need(plan, Place::Question(at), solution)?,
                Some(Named::Definition(at)) if plan.after_solution.contains(&Place::Definition(at)) => {
                    self.need(plan, Place::Definition(at), solution)?;
                }
                Some(Named::Input(_) | Named::Definition(_)) => {}
                None => {
                    let Place::Question(at) = place else { continue };
                    match plan.names.question(scope, name).filter(|before| *before < at) {
                        Some(before) => self.need(plan, Place::Question(before), solution)?,
                        // A unit has no answer.
                        None if dalembert_units::unit(name).is_ok() => {
                            let _ = self.need_answer(plan, scope, name, solution);
                        }
                        None => {
                            self.need_answer(plan, scope, name, solution)?;
                        }
                    }
                }
            }
        }
        Some(())
    }

    /// The column of an answer of a scope by its name or its symbol.
    fn need_answer(&mut self, plan: &Plan, scope: usize, name: &str, solution: &Solution) -> Option<usize> {
        let of = &plan.names.scopes[scope];
        let answer = solution.answer(&of.outside(name)).or_else(|| by_symbol(solution, of.name, name))?;
        answer.si()?;
        let own = answer.name.to_string();
        let answer =
            NeededAnswer { called: name.to_owned(), name: of.inside(&own)?.to_owned(), dim: answer.unit.dim };
        Some(self.solutions[scope].need(answer))
    }
}

/// The answer whose number is that of the one step of a problem with this symbol.
fn by_symbol<'s>(solution: &'s Solution, problem: &str, name: &str) -> Option<&'s Answer> {
    let wanted = normalised(name);
    let is_own = |at: &usize| {
        let mut of = solution.problems.iter().filter(|steps| steps.steps.contains(at));
        solution.problems.is_empty() || of.any(|steps| steps.name == problem)
    };
    let has_symbol = |at: &usize| normalised(&printer::symbol(&solution.steps[*at].symbol)) == wanted;
    let mut steps = (0..solution.steps.len()).filter(is_own).filter(has_symbol);
    let (only, None) = (steps.next()?, steps.next()) else { return None };
    let node = solution.steps[only].result;
    let is_it = |answer: &&Answer| matches!(answer.value, crate::AnswerValue::Number(_, id) if id == node);
    solution.answers.iter().filter(|answer| answer.problem == problem && !answer.asked).find(is_it)
}

impl PlainSolution {
    fn need(&mut self, answer: NeededAnswer) -> usize {
        self.answers.iter().position(|known| *known == answer).unwrap_or_else(|| {
            self.answers.push(answer);
            self.answers.len() - 1
        })
    }
}

impl PlannedInput {
    /// The path of the number that it is, or those of the components of the vector, within its problem.
    fn numbers(&self) -> Vec<String> {
        match self.value {
            Number::Scalar(_) => vec![self.inner.clone()],
            Number::Vector(_) => {
                AXES.iter().take(self.components).map(|axis| format!("{}.{axis}", self.inner)).collect()
            }
        }
    }
}

impl Plan {
    /// Returns true if cells of tables may change with these levers: an analysis is prepared with its tables as they are.
    fn changes_cells(&self, vary: &[&str]) -> bool {
        let mut cells = (0..self.inputs.len()).filter(|at| self.inputs[*at].is_cell).peekable();
        let is_named = |path: &&str| self.lever(path).is_some() || self.planned_input(path).is_some();
        cells.peek().is_some()
            && (vary.iter().any(is_named) || cells.any(|at| self.after_solution.contains(&Place::Input(at))))
    }

    /// The number at a path within the problem or the configuration of a scope.
    fn number_within(&self, scope: usize, inner: &str, record: &mut Record) -> Option<f64> {
        let problem = self.names.scopes[scope].problem;
        let mut changed = self.inputs.iter().filter(|input| scope != problem && input.scope == scope);
        let number = |input: &PlannedInput| match input.value {
            Number::Scalar(si) => (input.inner == inner).then_some(si),
            Number::Vector(si) => {
                let axis = inner.strip_prefix(&input.inner)?.strip_prefix('.')?;
                let at = AXES.iter().position(|known| *known == axis)?;
                input.formula.as_ref().map(|_| si[at])
            }
        };
        changed
            .find_map(number)
            .or_else(|| vary::number(record, &self.names.scopes[problem].outside(inner)).copied())
    }

    /// The scope that an answer is of.
    fn scope_of_answer(&self, name: &str) -> usize {
        let of = self.names.scopes.iter().enumerate().filter(|(_, scope)| scope.inside(name).is_some());
        of.max_by_key(|(_, scope)| scope.name.len()).map_or(0, |(at, _)| at)
    }
}

impl Planned {
    /// The wanted answers with the inputs as they are.
    fn first(&mut self) -> Result<Vec<f64>, SolveError> {
        let mut row = vec![f64::NAN; self.wanted.len()];
        let Some(readings) = &mut self.readings else { return Ok(row) };
        readings.read(&self.entry, &mut self.plan, &mut self.record, &mut row, &Stop::new())?;
        Ok(row)
    }

    /// Solves one point; why, where it has no answer.
    fn point(&mut self, point: &[f64], row: &mut [f64], stop: &Stop) -> Result<Option<Text>, Refusal> {
        if let Err(why) = self.set(point) {
            row.fill(f64::NAN);
            return Ok(Some(why));
        }
        let found = match &mut self.readings {
            Some(readings) => readings.read(&self.entry, &mut self.plan, &mut self.record, row, stop),
            None => {
                let changed = Record { plan: Some(Arc::new(self.plan.clone())), ..self.record.clone() };
                self.entry.solve_nominal(&changed, stop).map(|solution| {
                    for (place, name) in row.iter_mut().zip(&self.wanted) {
                        *place = solution.answer(name).and_then(Answer::si).unwrap_or(f64::NAN);
                    }
                })
            }
        };
        let why = match found {
            Ok(()) => return Ok(None),
            Err(SolveError::Refused(Refusal::Stopped)) => return Err(Refusal::Stopped),
            Err(SolveError::Refused(Refusal::NoAnswer(why))) => why,
            Err(SolveError::Fields(errors)) => {
                errors.into_iter().next().map_or_else(|| NO_VALUE.into(), |error| error.why)
            }
        };
        row.fill(f64::NAN);
        Ok(Some(why))
    }

    /// Gives the levers the numbers of a point, and the formulas their values; why, where a formula has none.
    fn set(&mut self, point: &[f64]) -> Result<(), Text> {
        for (lever, si) in self.levers.iter().zip(point) {
            match lever {
                Lever::Definition(definition) => self.plan.set(*definition, *si),
                Lever::Input(paths) => {
                    for path in paths {
                        *vary::number(&mut self.record, path).ok_or(NO_VALUE)? = *si;
                    }
                }
            }
        }
        self.plan.renew(&mut self.record).map_err(|error| error.why)
    }
}

/// Reason of a point at which an input has no value.
const NO_VALUE: &str = "an input has no value";

impl Readings {
    /// Reads the wanted answers of a record in whose plan the formulas have their values.
    fn read(
        &mut self,
        entry: &Entry,
        plan: &mut Plan,
        record: &mut Record,
        row: &mut [f64],
        stop: &Stop,
    ) -> Result<(), SolveError> {
        let plain = Plain::new(stop);
        for n in 0..plan.order.len() {
            match plan.order[n] {
                Place::Solution(scope) => self.solve(entry, plan, scope, record, stop)?,
                place @ Place::Question(at) if self.needed.contains(&place) => {
                    self.questions[at] = Some(self.question(plan, at, record, &plain)?);
                }
                place @ (Place::Definition(_) | Place::Input(_)) if self.needed.contains(&place) => {
                    let answer = |named: &Named| self.number(named);
                    plan.evaluate(place, &plain, &answer).map_err(|error| SolveError::Fields(vec![error]))?;
                    if let Place::Input(at) = place {
                        plan.write_input(at, record);
                    }
                }
                _ => {}
            }
        }
        for (place, source) in row.iter_mut().zip(&self.wanted) {
            let found = match *source {
                Source::Answer(scope, column) => self.solutions[scope].values.get(column).copied(),
                Source::Question(at) => self.questions[at].map(|(si, _)| si),
            };
            *place = found.unwrap_or(f64::NAN);
        }
        Ok(())
    }

    /// Solves the problem or the configuration of a scope, where an answer of it is needed.
    fn solve(
        &mut self,
        entry: &Entry,
        plan: &Plan,
        scope: usize,
        record: &mut Record,
        stop: &Stop,
    ) -> Result<(), SolveError> {
        let solution = &mut self.solutions[scope];
        let problem = plan.names.scopes[scope].problem;
        let name = plan.names.scopes[problem].name;
        let Some(entry) = entry_of(entry, name).filter(|_| !solution.answers.is_empty()) else {
            return Ok(());
        };
        if solution.evaluate.is_none() {
            let inputs = Record { plan: None, ..plan.record_of(scope, record) };
            let names: Vec<&str> = solution.answers.iter().map(|answer| answer.name.as_str()).collect();
            let paths: Vec<&str> = solution.inputs.iter().map(String::as_str).collect();
            let evaluate = entry.prepare(&inputs, &paths, &names).map_err(|error| outside(error, name))?;
            solution.evaluate = Some(evaluate);
            solution.values = vec![f64::NAN; names.len()];
        }
        let Some(evaluate) = &mut solution.evaluate else { return Ok(()) };
        let point: Option<Vec<f64>> =
            solution.inputs.iter().map(|path| plan.number_within(scope, path, record)).collect();
        // Without an input there is still one point.
        let point = point.filter(|point| !point.is_empty()).unwrap_or_else(|| vec![0.0]);
        let mut reason = None;
        evaluate.sweep_with_reasons(&point, &mut solution.values, &mut |_, why| reason = Some(why), stop)?;
        reason.map_or(Ok(()), |why| Err(Refusal::NoAnswer(why).into()))
    }

    fn question(
        &self,
        plan: &Plan,
        at: usize,
        record: &mut Record,
        plain: &Plain<'_>,
    ) -> Result<(f64, Dim), SolveError> {
        let question = &plan.questions[at];
        let mut inputs = BTreeMap::new();
        for (name, _) in question.formula.names() {
            if let Some(Named::Input(path)) = plan.find(Place::Question(at), name) {
                let unit = plan.names.input(&path).map(|input| input.unit.dim);
                inputs.insert(name.to_owned(), names::value_at(record, &path).zip(unit));
            }
        }
        let values = |name: &str| -> Result<Option<Operand<&Plain<'_>>>, Text> {
            let named = match plan.find(Place::Question(at), name) {
                Some(Named::Input(_)) => {
                    let value = inputs.get(name).copied().flatten();
                    return Ok(value.map(|(value, dim)| match value {
                        Number::Scalar(si) => Operand::Number(si, dim),
                        Number::Vector(si) => Operand::Vector(si.into(), dim),
                    }));
                }
                Some(Named::Definition(at)) => return Ok(Some(plan.operand(Place::Definition(at)))),
                Some(named) => named,
                None => match plan.names.question(question.scope, name).filter(|before| *before < at) {
                    Some(before) => Named::Question(before),
                    None => Named::Answer(question.scope, name.to_owned()),
                },
            };
            Ok(self.number(&named).map(|(si, dim)| Operand::Number(si, dim)))
        };
        match evaluate::<&Plain<'_>>(
            &question.formula,
            &values,
            &|name| plan.names.known(question.scope, name),
            plain,
        ) {
            Ok(Operand::Number(si, dim)) => Ok((si, dim)),
            Ok(_) => Err(unknown(&question.key, "is not a number among the answers")),
            Err(error) => Err(Refusal::because(error.why).into()),
        }
    }

    fn number(&self, named: &Named) -> Option<(f64, Dim)> {
        match named {
            Named::Answer(scope, called) => {
                let solution = &self.solutions[*scope];
                let at = solution.answers.iter().position(|answer| answer.called == *called)?;
                Some((*solution.values.get(at)?, solution.answers[at].dim))
            }
            Named::Question(at) => self.questions[*at],
            Named::Input(_) | Named::Definition(_) => None,
        }
    }
}

/// An error of a problem with its paths from outside.
fn outside(error: SolveError, problem: &str) -> SolveError {
    match error {
        SolveError::Fields(errors) if !problem.is_empty() => SolveError::Fields(
            errors
                .into_iter()
                .map(|error| FieldError { path: format!("{problem}.{}", error.path), ..error })
                .collect(),
        ),
        error => error,
    }
}

impl Evaluate for Planned {
    fn sweep_with_reasons(
        &mut self,
        points: &[f64],
        answers: &mut [f64],
        refused: &mut dyn FnMut(usize, Text),
        stop: &Stop,
    ) -> Result<(), Refusal> {
        let (columns, wanted) = (self.levers.len().max(1), self.wanted.len().max(1));
        for (n, (point, row)) in points.chunks(columns).zip(answers.chunks_mut(wanted)).enumerate() {
            stop.check()?;
            if let Some(why) = self.point(&point[..self.levers.len().min(point.len())], row, stop)? {
                refused(n, why);
            }
        }
        Ok(())
    }
}
