//! Worst case over tolerances: the answers at every combination of their ends.

use itertools::Itertools as _;

use crate::{
    Answer, Cell, Column, Entry, FieldError, Record, Solution, SolveError, Stop, TableExhibit, Text,
    definitions::Tolerance,
    intern::fixed,
    vary::{self, Perturbed, VariedInput},
};

/// The most tolerances of a problem: each doubles the number of combinations.
const MOST: usize = 10;

/// Combinations of the ends of tolerances.
pub(crate) struct Corners<'t> {
    /// Tolerance and place of each input that has one.
    places: Vec<(&'t Tolerance, usize)>,
    /// The inputs with a tolerance behind those that are unknown.
    others: Vec<VariedInput>,
}

impl<'t> Corners<'t> {
    /// The combinations for a problem, some of whose inputs are unknown.
    ///
    /// # Errors
    /// Too many tolerances; one of an input that cannot be varied.
    pub(crate) fn new(
        tolerances: &'t [Tolerance],
        record: &Record,
        unknown: &[VariedInput],
    ) -> Result<Self, SolveError> {
        if let Some(one) = tolerances.get(MOST) {
            let why = Text::new("{count} tolerances: the worst case is found of at most {most}");
            let why = why.with("count", tolerances.len()).with("most", MOST);
            return Err(SolveError::Fields(vec![FieldError::new(&one.name, why)]));
        }
        let all = vary::inputs(record);
        let (mut places, mut others) = (Vec::new(), Vec::new());
        for tolerance in tolerances {
            let is_it = |input: &VariedInput| input.path == tolerance.name;
            let at = match unknown.iter().position(is_it) {
                Some(at) => at,
                None => {
                    let found = all.iter().find(|input| is_it(input)).cloned();
                    others.push(found.ok_or_else(|| fixed_input(&tolerance.name))?);
                    unknown.len() + others.len() - 1
                }
            };
            places.push((tolerance, at));
        }
        Ok(Self { places, others })
    }

    /// The problem to be solved again at the combinations: the unknown inputs come first.
    ///
    /// # Errors
    /// As [`Perturbed::new`]; a tolerance of an input that the analysis cannot change.
    pub(crate) fn perturbed(
        &self,
        entry: &Entry,
        record: &Record,
        unknown: &[VariedInput],
        answers: Vec<String>,
    ) -> Result<Perturbed, SolveError> {
        let inputs = unknown.iter().chain(&self.others).cloned().collect();
        let perturbed = Perturbed::new(entry, record, inputs, answers)?;
        match self.others.iter().find(|input| !perturbed.has_input(&input.path)) {
            Some(lost) => Err(fixed_input(&lost.path)),
            None => Ok(perturbed),
        }
    }

    /// Number of the combinations, with that of the values themselves.
    pub(crate) fn count(&self) -> usize {
        if self.places.is_empty() { 1 } else { 1 + (1 << self.places.len()) }
    }

    /// The changes of the inputs, by their places: none, then those of every combination.
    pub(crate) fn changes(&self, unknown: &[f64]) -> impl Iterator<Item = Vec<(usize, f64)>> {
        let nominal: Vec<(usize, f64)> = unknown.iter().copied().enumerate().collect();
        let combinations = (1..self.count()).map({
            let nominal = nominal.clone();
            move |corner| {
                let mut changes = nominal.clone();
                for (n, (tolerance, at)) in self.places.iter().enumerate() {
                    let si = unknown.get(*at).copied().unwrap_or_else(|| self.others[at - unknown.len()].si);
                    let sign = if corner >> n & 1 == 0 { 1.0 } else { -1.0 };
                    let shifted = (*at, si + sign * tolerance.width.at(si));
                    match changes.get_mut(*at) {
                        Some(change) => *change = shifted,
                        None => changes.push(shifted),
                    }
                }
                changes
            }
        });
        std::iter::once(nominal).chain(combinations)
    }
}

/// Refusal of a tolerance of an input that the analysis cannot change.
fn fixed_input(path: &str) -> SolveError {
    let why = "this input cannot be varied, so it has no tolerance";
    SolveError::Fields(vec![FieldError::new(path, why)])
}

/// Table of the answers with their least and largest values within the tolerances; `None` where there is no tolerance.
///
/// # Errors
/// As [`Corners::new`]; a stop.
pub(crate) fn table(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    stop: &Stop,
) -> Result<Option<TableExhibit>, SolveError> {
    let tolerances = record.plan.as_ref().map_or(&[][..], |plan| plan.tolerances());
    if tolerances.is_empty() {
        return Ok(None);
    }
    let corners = Corners::new(tolerances, record, &[])?;
    let plan = record.plan.as_ref().map(|plan| plan.without_unknowns().into());
    let record = &Record { plan, ..record.clone() };
    // What was found is an answer of the search alone.
    let found = solution.determined.iter().flat_map(|determined| &determined.unknowns);
    let found: Vec<&str> = found.map(|unknown| unknown.name.as_str()).collect();
    let is_number =
        |answer: &&Answer| answer.si().is_some() && !found.iter().any(|name| answer.name.is(name));
    let numbers = solution.answers.iter().filter(is_number);
    let names = numbers.map(|answer| answer.name.to_string()).unique().collect();
    let mut perturbed = corners.perturbed(entry, record, &[], names)?;
    let mut rows = Vec::new();
    let mut refused = 0;
    let mut ends = vec![[f64::INFINITY, f64::NEG_INFINITY]; perturbed.answers.len()];
    for changes in corners.changes(&[]) {
        let answers = perturbed.with(&changes, stop)?;
        refused += usize::from(answers.iter().any(|si| si.is_nan()));
        for (end, si) in ends.iter_mut().zip(&answers).filter(|(_, si)| si.is_finite()) {
            *end = [end[0].min(*si), end[1].max(*si)];
        }
    }
    for (name, end) in perturbed.answers.iter().zip(ends) {
        let Some(answer) = solution.answer(name) else { continue };
        let Some(si) = answer.si() else { continue };
        let value = |si: f64| {
            if si.is_finite() { Text::quantity(si, fixed(&answer.unit)).into() } else { Cell::Empty }
        };
        rows.push(vec![answer.title().into(), value(si), value(end[0].min(si)), value(end[1].max(si))]);
    }
    let words = |heading: &'static str| Column { heading: heading.into(), unit: "" };
    let title = if refused > 0 {
        Text::new("Worst case: the answers at all ends of the tolerances; {refused} of {count} have none")
            .with("refused", refused)
            .with("count", corners.count())
    } else {
        Text::new("Worst case: the answers at all ends of the tolerances")
    };
    Ok(Some(TableExhibit {
        title,
        columns: vec![words("Answer"), words("nominal"), words("least"), words("largest")],
        rows,
        foot: Vec::new(),
    }))
}
