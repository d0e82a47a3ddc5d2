//! The points of a study, solved: any thread has an evaluation of its own.

use std::ops::Range;

use dalembert_units::Kind;

use super::{
    amounts::shown,
    design::Design,
    plan::{Amount, Limit, StudyPlan},
    rows::Rows,
    statistics::{Accumulator, AnswerLimit},
};
use crate::{
    Answer, Entry, Evaluate, FieldError, Record, Refusal, Solution, SolveError, Stop, Text, intern::fixed,
    nearest, vary::InputLimits,
};

/// Points that are drawn and solved together: few enough that their numbers stay in the cache of a core.
const IN_CACHE: usize = 2048;

/// A study that is ready to run: its points, and the answers that are wanted at each.
#[derive(Debug)]
pub struct Study<'a> {
    pub(super) entry: &'a Entry,
    pub(super) record: &'a Record,
    /// The inputs of every point.
    pub design: Design,
    /// The wanted answers as they are at the inputs of the problem: names, labels, units.
    pub answers: Vec<Answer>,
    /// Sets whose limits are among the wanted answers, two at least, by their places: these share a plot.
    pub(super) sets: Vec<(Answer, Vec<usize>)>,
    /// The limits whose probability is asked for.
    pub limits: Vec<AnswerLimit>,
    conditions: Vec<AnswerLimit>,
}

/// The plain reading of a study, for one thread.
pub struct Evaluation<'a> {
    study: &'a Study<'a>,
    evaluate: Box<dyn Evaluate>,
    limits: InputLimits,
    /// Inputs of the rows in SI.
    points: Vec<f64>,
}

impl<'a> Study<'a> {
    /// Reads the answers, limits and conditions of a plan, whose inputs have been [designed](Design::new). The units of
    /// answers are those of the solution of the problem as it is.
    ///
    /// # Errors
    /// Everything in the plan that does not fit the answers; an input that the analysis cannot vary.
    pub fn new(
        entry: &'a Entry,
        record: &'a Record,
        plan: &StudyPlan,
        design: Design,
        solution: &Solution,
    ) -> Result<Self, SolveError> {
        let mut errors = Vec::new();
        let answers = match &plan.answers[..] {
            [] => solution.answers.iter().filter(|answer| answer.si().is_some()).cloned().collect(),
            names => {
                let find = |(n, name): (usize, &String)| {
                    answer(solution, &format!("answers[{}]", n + 1), name).map_err(|error| errors.push(error))
                };
                names.iter().enumerate().flat_map(find).collect()
            }
        };
        let (limits, conditions) = (Vec::new(), Vec::new());
        let mut study = Self { entry, record, design, answers, sets: Vec::new(), limits, conditions };
        study.limits = study.read_limits("limit", &plan.limit, solution, &mut errors);
        study.conditions = study.read_limits("condition", &plan.condition, solution, &mut errors);
        if study.answers.is_empty() && errors.is_empty() {
            errors.push(FieldError::new("answers", "this problem has no answer that is a number"));
        }
        study.sets = sets(solution, &study.answers);
        if errors.is_empty() {
            // What cannot be varied is said before anything is computed.
            study.evaluation()?;
            Ok(study)
        } else {
            Err(SolveError::Fields(errors))
        }
    }

    /// Reads limits; an answer that is named in one alone is wanted too.
    fn read_limits(
        &mut self,
        list: &str,
        limits: &[Limit],
        solution: &Solution,
        errors: &mut Vec<FieldError>,
    ) -> Vec<AnswerLimit> {
        let mut found = Vec::new();
        for (n, limit) in (1..).zip(limits) {
            let path = format!("{list}[{n}]");
            match self.limit(&path, limit, solution) {
                Ok(all) => found.extend(all),
                Err(error) => errors.push(error),
            }
        }
        found
    }

    fn limit(
        &mut self,
        path: &str,
        limit: &Limit,
        solution: &Solution,
    ) -> Result<Vec<AnswerLimit>, FieldError> {
        let named = answer(solution, &format!("{path}.answer"), &limit.answer)?;
        let known = self.answers.iter().position(|answer| answer.name == named.name);
        let at = known.unwrap_or_else(|| {
            self.answers.push(named.clone());
            self.answers.len() - 1
        });
        if limit.above.is_none() && limit.below.is_none() {
            return Err(FieldError::new(path, "write above or below, as in above = \"0.5 mm\""));
        }
        let mut limits = Vec::new();
        for (name, value, above) in [("above", &limit.above, true), ("below", &limit.below, false)] {
            if let Some(value) = value {
                let path = format!("{path}.{name}");
                limits.push(AnswerLimit { answer: at, limit: in_unit_of(&named, &path, value)?, above });
            }
        }
        Ok(limits)
    }

    /// The statistics of its rows from that point on, counted from 0.
    pub fn accumulator(&self, first: u64) -> Accumulator {
        let Self { design, answers, limits, .. } = self;
        let base_sample = design.base_sample();
        let rows = base_sample.map_or(design.points(), |points| design.points() / points as u64 * 2);
        let sums = Accumulator::new(design.inputs.len(), answers.len(), limits.clone())
            .with_levels(design.levels(), design.maps.clone(), rows)
            .starting_at(first);
        match base_sample {
            Some(points) => sums.with_sobol_indices(points),
            None => sums,
        }
    }

    /// A reading of its own for a thread.
    ///
    /// # Errors
    /// An input that the analysis cannot vary; why the problem as given has no answer.
    pub fn evaluation(&self) -> Result<Evaluation<'_>, SolveError> {
        let vary: Vec<&str> = self.design.inputs.iter().map(|input| input.path.as_str()).collect();
        let names: Vec<String> = self.answers.iter().map(|answer| answer.name.to_string()).collect();
        let wanted: Vec<&str> = names.iter().map(String::as_str).collect();
        Ok(Evaluation {
            study: self,
            evaluate: self.entry.prepare(self.record, &vary, &wanted)?,
            limits: InputLimits::of(self.design.inputs.iter().map(|input| &input.measure)),
            points: Vec::new(),
        })
    }
}

impl Evaluation<'_> {
    /// Solves a range of points, counted from 0, into rows, whose memory is used again.
    ///
    /// # Errors
    /// [`Refusal::Stopped`] alone.
    pub fn rows(&mut self, range: Range<u64>, rows: &mut Rows, stop: &Stop) -> Result<(), Refusal> {
        let Study { design, answers, .. } = self.study;
        let (inputs, wanted) = (design.inputs.len(), answers.len());
        let count = (range.end - range.start) as usize;
        rows.widths = [inputs, wanted];
        rows.inputs.clear();
        rows.inputs.resize(count * inputs, 0.0);
        rows.answers.clear();
        rows.answers.resize(count * wanted, f64::NAN);
        rows.refused.clear();
        for begin in (0..count).step_by(IN_CACHE) {
            self.block(range.start, begin..count.min(begin + IN_CACHE), rows, stop)?;
        }
        rows.refused.sort_by_key(|(row, _)| *row);
        Ok(())
    }

    /// Solves a block of the rows, which begin at the point `first`.
    fn block(
        &mut self,
        first: u64,
        block: Range<usize>,
        rows: &mut Rows,
        stop: &Stop,
    ) -> Result<(), Refusal> {
        let Study { design, answers, conditions, .. } = self.study;
        let (inputs, wanted) = (design.inputs.len(), answers.len());
        self.points.resize(block.len() * inputs, 0.0);
        let shown = &mut rows.inputs[block.start * inputs..block.end * inputs];
        design.rows(first + block.start as u64, shown, &mut self.points);
        let values = &mut rows.answers[block.start * wanted..block.end * wanted];
        let refused = &mut rows.refused;
        self.evaluate.sweep_with_reasons(
            &self.points,
            values,
            &mut |row, why| refused.push((block.start + row, why)),
            stop,
        )?;
        // That an input is outside of its limits goes before any other reason.
        let mut outside = Vec::new();
        for (n, at) in self.limits.outside(&self.points) {
            let row = block.start + n;
            rows.answers[row * wanted..][..wanted].fill(f64::NAN);
            let input = &design.inputs[at];
            let text = format!("{} {}", rows.inputs[row * inputs + at], input.unit.ascii());
            let why = input.measure.outside(self.points[n * inputs + at], text.trim_end());
            let why = Text::new("{input}: {why}")
                .with("input", &input.path)
                .with_text("why", why.unwrap_or_else(|| "is not a finite number".into()));
            outside.push((row, why));
        }
        let is_inside = |row: &usize| outside.binary_search_by_key(row, |(row, _)| *row).is_err();
        rows.refused.retain(|(row, _)| is_inside(row));
        rows.refused.append(&mut outside);
        let values = &mut rows.answers[block.start * wanted..block.end * wanted];
        for (row, values) in block.zip(values.chunks_exact_mut(wanted)) {
            for (value, answer) in values.iter_mut().zip(answers) {
                *value = answer.unit.value(*value);
            }
            if values.iter().all(|value| value.is_finite())
                && let Some(unmet) =
                    conditions.iter().find(|condition| !condition.is_exceeded(values[condition.answer]))
            {
                values.fill(f64::NAN);
                rows.refused.push((row, unmet.reason(&answers[unmet.answer])));
            }
        }
        Ok(())
    }
}

impl AnswerLimit {
    /// Reason of a point that does not meet it as a condition.
    fn reason(&self, answer: &Answer) -> Text {
        let text = if self.above {
            Text::new("the condition is not met: {answer} above {limit}")
        } else {
            Text::new("the condition is not met: {answer} below {limit}")
        };
        let limit = answer.unit.si(self.limit);
        text.with_text("answer", answer.title()).with_quantity("limit", limit, fixed(&answer.unit))
    }
}

/// Sets of a solution with the places of those of their limits that are wanted, where these are several.
fn sets(solution: &Solution, wanted: &[Answer]) -> Vec<(Answer, Vec<usize>)> {
    let of = |set: &Answer| {
        let limits = solution.limits_of(set);
        let is_limit = |at: &usize| limits.iter().any(|limit| limit.name == wanted[*at].name);
        (set.clone(), (0..wanted.len()).filter(is_limit).collect::<Vec<usize>>())
    };
    solution.answers.iter().map(of).filter(|(_, limits)| limits.len() > 1).collect()
}

/// The answer of that name, which is a number; `path` is where it is named.
///
/// # Errors
/// The answers that are numbers, or the one that is meant.
pub fn answer(solution: &Solution, path: &str, name: &str) -> Result<Answer, FieldError> {
    let numbers = || solution.answers.iter().filter(|answer| answer.si().is_some());
    if let Some(answer) = numbers().find(|answer| answer.name.is(name)) {
        return Ok(answer.clone());
    }
    let names: Vec<String> = numbers().map(|answer| answer.name.to_string()).collect();
    let why =
        match nearest(name, names.iter().map(String::as_str)) {
            Some(near) => Text::new("`{name}` is not a number among the answers; did you mean `{near}`?")
                .with("near", near),
            None => Text::new("`{name}` is not a number among the answers: {known}")
                .with("known", names.join(", ")),
        };
    Err(FieldError::new(path, why.with("name", name)))
}

/// A value of an answer in its unit.
fn in_unit_of(answer: &Answer, path: &str, value: &Amount) -> Result<f64, FieldError> {
    let si = value.si(&answer.unit, Kind::of(&answer.unit)).map_err(|why| FieldError::new(path, why))?;
    Ok(shown(&answer.unit, si))
}
