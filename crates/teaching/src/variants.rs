//! Variants of an exercise: other data, drawn from a seed, of which those are taken that make as sound a problem.

use std::collections::BTreeMap;

use dalembert_core::{
    Answer, Draft, FieldError, Record, Refusal, Solution, SolveError, Stop, Text,
    vary::{self, Perturbed},
};

use crate::{
    Datum, Exercise, Range,
    causes::{self, CommonError},
    exercise::numbers,
    ranges::{ranges, with_data},
    seed::drawn,
};

/// Draws for one variant before the search is given up.
pub const TRIES: u64 = 400;
/// The largest elasticity of an answer to a datum: a change of 1 % changes the answer by at most so many percent.
pub const LARGEST_ELASTICITY: f64 = 20.0;
/// The least relative distance of the answers of two variants, and of those of the problem itself.
pub const CLOSEST: f64 = 0.02;
/// So many of the most frequent mistakes are kept apart from the right answer, and named where one of them is made.
const MOST_ERRORS: usize = 24;
/// Step of derivatives, as a share of the datum.
const STEP: f64 = 1e-4;
/// Values closer to each other than this share are one.
const SAME: f64 = 1e-9;

/// An exercise with other data.
#[derive(Clone, Debug)]
pub struct Variant {
    /// Number of the variant, or id of its student.
    pub label: String,
    /// Data that differ from variant to variant.
    pub data: Vec<Datum>,
    /// Texts of the inputs.
    pub draft: Draft,
    /// Inputs as read.
    pub record: Record,
    /// Solution, in the units of the exercise.
    pub solution: Solution,
    /// Names of the answers that are asked for.
    pub asked: Vec<String>,
    /// For each asked answer that is a number the values that usual mistakes give in its place.
    pub errors: BTreeMap<String, Vec<CommonError>>,
}

impl Variant {
    /// Names of the asked answers that are numbers.
    pub fn numbers(&self) -> Vec<String> {
        numbers(&self.asked, &self.solution)
    }
}

/// Source of the variants of an exercise.
#[derive(Debug)]
pub struct Generator<'e> {
    exercise: &'e Exercise,
    ranges: Vec<Range>,
    perturbed: Perturbed,
    /// Places of the inputs of each range among those of `perturbed`.
    places: Vec<Vec<usize>>,
    original: Variant,
    /// Mistakes that the problem itself does not tell from the right answer.
    hidden: BTreeMap<String, Vec<String>>,
    tolerance: f64,
}

/// Reason for which data are not taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Rejection {
    Unsolved,
    Warned,
    Unchecked,
    Elastic,
    Close,
    Mistakable,
}

impl<'e> Generator<'e> {
    /// Ready to draw variants whose answers are graded within `tolerance`, a share.
    ///
    /// # Errors
    /// Everything that is wrong with the declared ranges, or why the problem itself makes no exercise.
    pub fn new(exercise: &'e Exercise, tolerance: f64, stop: &Stop) -> Result<Self, Vec<Text>> {
        let named = |errors: Vec<FieldError>| -> Vec<Text> {
            let line = |error: FieldError| {
                Text::new("vary.{path}: {why}").with("path", error.path).with_text("why", error.why)
            };
            errors.into_iter().map(line).collect()
        };
        let ranges = ranges(exercise).map_err(named)?;
        if ranges.is_empty() {
            let why = "no number among the inputs varies; declare ranges, as in [vary] mass = \"30 kg .. 60 kg : 5 kg\"";
            return Err(vec![why.into()]);
        }
        let original = Self::original(exercise, stop)?;
        let wanted = original.numbers();
        if wanted.is_empty() {
            return Err(vec!["no asked answer is a single number; name one under `asked` or [ask]".into()]);
        }
        if let Some(warning) = original.solution.warnings.first() {
            let why = Text::new("the problem itself is solved with a warning: {warning}");
            return Err(vec![why.with_text("warning", warning.clone())]);
        }
        let perturbed =
            Perturbed::new(exercise.entry, &exercise.record, vary::inputs(&exercise.record), wanted)
                .map_err(|error| refused(&error))?;
        let place = |path: &String| perturbed.inputs.iter().position(|input| input.path == *path);
        let places: Vec<Vec<usize>> =
            ranges.iter().map(|range| range.paths.iter().filter_map(place).collect()).collect();
        let hidden = hidden(&original, tolerance);
        Ok(Self { exercise, ranges, perturbed, places, original, hidden, tolerance })
    }

    fn original(exercise: &Exercise, stop: &Stop) -> Result<Variant, Vec<Text>> {
        let (draft, record) = (exercise.draft.clone(), exercise.record.clone());
        let solution = exercise.solve(&draft, &record, stop).map_err(|error| refused(&error))?;
        let asked = exercise.asked(&solution);
        let errors =
            errors(exercise, &record, &solution, &asked, stop).map_err(|why| refused(&why.into()))?;
        Ok(Variant { label: String::new(), data: Vec::new(), draft, record, solution, asked, errors })
    }

    /// The problem itself, as a variant without other data.
    pub fn problem(&self) -> &Variant {
        &self.original
    }

    /// Ranges of the data.
    pub fn ranges(&self) -> &[Range] {
        &self.ranges
    }

    /// Variants of a seed, each apart from those before it.
    ///
    /// # Errors
    /// Why there are not so many.
    pub fn variants(&mut self, seed: u64, count: usize, stop: &Stop) -> Result<Vec<Variant>, Text> {
        let mut found: Vec<Variant> = Vec::new();
        let mut trial = 0;
        for number in 1..=count {
            let mut rejected: BTreeMap<Rejection, u64> = BTreeMap::new();
            let accepted = loop {
                if rejected.values().sum::<u64>() == TRIES {
                    return Err(exhausted(found.len(), count, &rejected));
                }
                let data: Vec<Datum> = self
                    .ranges
                    .iter()
                    .enumerate()
                    .map(|(at, range)| range.datum(drawn(seed, trial, at, range.values.len())))
                    .collect();
                trial += 1;
                match self.accepted(data, &found, stop) {
                    Ok(Ok(variant)) => break variant,
                    Ok(Err(why)) => *rejected.entry(why).or_default() += 1,
                    Err(_) => return Err("the search for variants was stopped".into()),
                }
            };
            found.push(Variant { label: number.to_string(), ..accepted });
        }
        Ok(found)
    }

    /// The variant with these data, or why it is not taken; the outer error is a stop.
    fn accepted(
        &mut self,
        data: Vec<Datum>,
        others: &[Variant],
        stop: &Stop,
    ) -> Result<Result<Variant, Rejection>, Refusal> {
        let dependent = match self.dependent(&data, stop)? {
            Ok(dependent) => dependent,
            Err(why) => return Ok(Err(why)),
        };
        let shape = self.exercise.entry.shape();
        let Ok(draft) = with_data(&self.exercise.draft, &shape, &data) else {
            return Ok(Err(Rejection::Unsolved));
        };
        let Ok(record) = draft.read(&shape) else { return Ok(Err(Rejection::Unsolved)) };
        let solution = match self.exercise.solve(&draft, &record, stop) {
            Ok(solution) => solution,
            Err(SolveError::Refused(Refusal::Stopped)) => return Err(Refusal::Stopped),
            Err(_) => return Ok(Err(Rejection::Unsolved)),
        };
        if self.original.asked.iter().any(|name| solution.answer(name).is_none()) {
            return Ok(Err(Rejection::Unsolved));
        }
        if !solution.warnings.is_empty() {
            return Ok(Err(Rejection::Warned));
        }
        if solution.checks.iter().any(|check| !check.passed) || !solution.defects.is_empty() {
            return Ok(Err(Rejection::Unchecked));
        }
        let values = |solution: &Solution| -> Vec<f64> {
            let of = |name: &String| solution.answer(name).and_then(Answer::si);
            dependent.iter().map(|name| of(name).unwrap_or(f64::NAN)).collect()
        };
        let own = values(&solution);
        let differ = |(a, b): (&f64, &f64)| (a - b).abs() >= CLOSEST * a.abs().max(b.abs());
        // The printed answers fit none of it, and nobody's answers are all those of a neighbour.
        let is_new = !own.is_empty() && own.iter().zip(&values(&self.original.solution)).all(differ);
        if !is_new || others.iter().any(|other| !own.iter().zip(&values(&other.solution)).any(differ)) {
            return Ok(Err(Rejection::Close));
        }
        let asked = self.original.asked.clone();
        let errors = errors(self.exercise, &record, &solution, &asked, stop)?;
        let variant = Variant { label: String::new(), data, draft, record, solution, asked, errors };
        let is_hidden = |name: &String, text: &str| {
            self.hidden.get(name).is_some_and(|known| known.iter().any(|known| known == text))
        };
        let near = near_errors(&variant, 2.0 * self.tolerance);
        if near.iter().any(|(name, error)| !is_hidden(name, &error.text.english())) {
            return Ok(Err(Rejection::Mistakable));
        }
        Ok(Ok(variant))
    }

    /// Names of the asked numbers that depend on the data, unless one of them does so too steeply.
    fn dependent(&mut self, data: &[Datum], stop: &Stop) -> Result<Result<Vec<String>, Rejection>, Refusal> {
        let changes: Vec<(usize, f64)> = data
            .iter()
            .zip(&self.places)
            .flat_map(|(datum, places)| places.iter().map(|place| (*place, datum.si)))
            .collect();
        let values = self.perturbed.with(&changes, stop)?;
        if values.iter().any(|value| !value.is_finite()) {
            return Ok(Err(Rejection::Unsolved));
        }
        let mut depends = vec![false; values.len()];
        for (datum, places) in data.iter().zip(&self.places) {
            let mut moved = |sign: f64| {
                let si = datum.si * (1.0 + sign * STEP);
                let here = |(place, known): &(usize, f64)| {
                    (*place, if places.contains(place) { si } else { *known })
                };
                self.perturbed.with(&changes.iter().map(here).collect::<Vec<_>>(), stop)
            };
            let (less, more) = (moved(-1.0)?, moved(1.0)?);
            for (at, value) in values.iter().enumerate() {
                let is_angle = self
                    .original
                    .solution
                    .answer(&self.perturbed.answers[at])
                    .is_some_and(|answer| answer.dim() == dalembert_units::Dim::ANGLE);
                // The size of a direction says nothing: it is compared with a radian.
                let size = if is_angle { 1.0 } else { value.abs() };
                let elasticity = (more[at] - less[at]).abs() / (2.0 * STEP * size);
                depends[at] |= (more[at] - less[at]).abs() > SAME * size;
                if elasticity > LARGEST_ELASTICITY && value.abs() > 0.0 {
                    return Ok(Err(Rejection::Elastic));
                }
            }
        }
        let names = self.perturbed.answers.iter().zip(depends).filter(|(_, depends)| *depends);
        Ok(Ok(names.map(|(name, _)| name.clone()).collect()))
    }
}

fn refused(error: &SolveError) -> Vec<Text> {
    match error {
        SolveError::Refused(Refusal::NoAnswer(why)) => {
            vec![Text::new("the problem itself has no answer: {why}").with_text("why", why.clone())]
        }
        SolveError::Refused(Refusal::Stopped) => vec!["the search for variants was stopped".into()],
        SolveError::Fields(errors) => {
            let line = |error: &FieldError| {
                Text::new("{path}: {why}").with("path", &error.path).with_text("why", error.why.clone())
            };
            errors.iter().map(line).collect()
        }
    }
}

fn errors(
    exercise: &Exercise,
    record: &Record,
    solution: &Solution,
    asked: &[String],
    stop: &Stop,
) -> Result<BTreeMap<String, Vec<CommonError>>, Refusal> {
    let of = |name: String| {
        let found = causes::common_errors(exercise.entry, record, solution, (&name, MOST_ERRORS), stop)?;
        Ok((name, found))
    };
    numbers(asked, solution).into_iter().map(of).collect()
}

/// Common errors that lie so near to the right answer, by the names of the answers.
fn near_errors(variant: &Variant, share: f64) -> Vec<(&String, &CommonError)> {
    let mut found = Vec::new();
    for (name, errors) in &variant.errors {
        let right = variant.solution.answer(name).and_then(Answer::si).unwrap_or(f64::NAN);
        let near = errors.iter().filter(|error| (error.si - right).abs() <= share * right.abs());
        found.extend(near.map(|error| (name, error)));
    }
    found
}

/// Mistakes, by their sentences, that the problem itself does not tell from the right answer.
fn hidden(original: &Variant, tolerance: f64) -> BTreeMap<String, Vec<String>> {
    let mut found: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (name, error) in near_errors(original, 2.0 * tolerance) {
        found.entry(name.clone()).or_default().push(error.text.english());
    }
    found
}

/// The error after so many draws, with the most frequent reason.
fn exhausted(found: usize, wanted: usize, rejected: &BTreeMap<Rejection, u64>) -> Text {
    let why = match rejected.iter().max_by_key(|(_, count)| **count).map(|(why, _)| why) {
        Some(Rejection::Warned) => "most are solved with a warning",
        Some(Rejection::Unchecked) => "most fail a check",
        Some(Rejection::Elastic) => "most have an answer that changes by more than 20 % for 1 % of a datum",
        Some(Rejection::Close) => {
            "most have answers less than 2 % from those of the problem or of another variant"
        }
        Some(Rejection::Mistakable) => "most have an answer that a usual mistake gives too",
        Some(Rejection::Unsolved) | None => "most have no answer",
    };
    Text::new("{found} of {wanted} variants found, then none in {tries} draws: {why}; widen the ranges under [vary]")
        .with("found", found)
        .with("wanted", wanted)
        .with("tries", TRIES)
        .with_text("why", why)
}
