//! Unknowns: an input is found back from an answer that it gave.

use std::sync::Mutex;

use dalembert_core::{
    Answer, Draft, Entry, Record, SolveError, Stop,
    cases::Case,
    vary::{self, Perturbed, VariedInput},
};

use crate::{
    problems::{cases_of, on_all_cores},
    some,
};

/// The share of an input within which it is found back.
const CLOSE: f64 = 1e-6;

/// Makes an input of the first case of each analysis unknown and gives an answer that depends on it: the value of the
/// case is among the solutions from 0.7 to 1.5 times itself. Returns the number of inputs found; analyses without a pair
/// of numbers of which one follows the other are none.
pub fn an_input_is_found_back_from_an_answer(entries: &[&'static Entry]) -> usize {
    examine_pairs(entries, |pair| {
        let why = |why| format!("{} from {}: {why}", pair.input.path, pair.answer.name);
        vec![find_back(pair).map_err(why)]
    })
}

/// An input of the first case of an analysis, and an answer that follows it smoothly.
pub(crate) struct Pair {
    pub(crate) entry: &'static Entry,
    pub(crate) case: Case,
    pub(crate) record: Record,
    pub(crate) input: VariedInput,
    pub(crate) answer: Answer,
}

impl Pair {
    /// The range of the input that is searched, in SI: from 0.7 to 1.5 times its value.
    pub(crate) fn ends(&self) -> [f64; 2] {
        let mut ends = [0.7, 1.5].map(|share| share * self.input.si);
        ends.sort_by(f64::total_cmp);
        ends
    }

    /// The same problem with the input unknown in that range.
    pub(crate) fn with_unknown(&self) -> Result<Draft, String> {
        let unit = self.input.measure.own_unit();
        let [from, to] = self.ends().map(|si| unit.value(si));
        let name = unit.ascii();
        let range = format!("? {from:e} {name} .. {to:e} {name}");
        let mut draft = self.case.draft.clone();
        draft.set(&self.entry.shape(), &self.input.path, &range).map_err(|err| err.to_string())?;
        Ok(draft)
    }
}

/// Examines the pair of every analysis that has one. Returns the number of results that are right; fails with the others.
pub(crate) fn examine_pairs(
    entries: &[&'static Entry],
    examine: impl Fn(&Pair) -> Vec<Result<(), String>> + Sync,
) -> usize {
    some(entries);
    let results = Mutex::new(Vec::new());
    on_all_cores(entries, |_, entry| {
        let Some(case) = cases_of(entry).into_iter().find(|case| case.refused.is_none()) else { return };
        let record = case.record(entry).unwrap_or_else(|err| panic!("{}: {err}", entry.about.id));
        let Some((input, answer)) = pair(entry, &record) else { return };
        let pair = Pair { entry, case, record, input, answer };
        let found =
            examine(&pair).into_iter().map(|one| one.map_err(|why| format!("{}: {why}", entry.about.id)));
        results.lock().expect("no worker panics").extend(found);
    });
    let results = results.into_inner().expect("no worker panics");
    let faults: Vec<&str> = results.iter().filter_map(|one| Some(one.as_ref().err()?.as_str())).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    results.len()
}

fn pair(entry: &Entry, record: &Record) -> Option<(VariedInput, Answer)> {
    let solution = entry.solve(record, &Stop::new()).ok()?;
    let numbers: Vec<&Answer> =
        solution.answers.iter().filter(|answer| answer.si().is_some_and(|si| si != 0.0)).collect();
    let names = numbers.iter().map(|answer| answer.name.to_string()).collect();
    let mut again = Perturbed::new(entry, record, vary::inputs(record), names).ok()?;
    let inputs = again.inputs.clone();
    for (at, input) in inputs.iter().enumerate() {
        // Components of vectors cannot be unknown.
        let is_component = matches!(input.path.rsplit('.').next(), Some("x" | "y" | "z"));
        if input.si == 0.0 || is_component {
            continue;
        }
        let [near, far] = [1.001, 1.01].map(|share| again.with(&[(at, share * input.si)], &Stop::new()).ok());
        let (near, far) = (near?, far?);
        for (n, name) in again.answers.iter().enumerate() {
            let answer = solution.answer(name)?;
            let rate = |value: f64, share: f64| (value / answer.si().unwrap_or(f64::NAN) - 1.0) / share;
            let (near, far) = (rate(near[n], 0.001), rate(far[n], 0.01));
            if near.abs() > 0.1 && near.abs() < 20.0 && (far / near - 1.0).abs() < 0.2 {
                return Some((input.clone(), answer.clone()));
            }
        }
    }
    None
}

fn find_back(pair: &Pair) -> Result<(), String> {
    let Pair { entry, input, answer, .. } = pair;
    let shape = entry.shape();
    let mut draft = pair.with_unknown()?;
    let si = answer.si().ok_or("no number")?;
    let given = match answer.unit.coherent() {
        unit if unit == "1" => format!("{si:e}"),
        unit => format!("{si:e} {unit}"),
    };
    draft.give(&shape, &answer.name.to_string(), &given).map_err(|err| err.to_string())?;
    let record = draft.read(&shape).map_err(|errors| SolveError::Fields(errors).to_string())?;
    let solution = entry.solve(&record, &Stop::new()).map_err(|err| err.to_string())?;
    let determined = solution.determined.as_deref().ok_or("nothing was found")?;
    if determined.solutions.iter().any(|found| (found[0] - input.si).abs() <= CLOSE * input.si.abs()) {
        return Ok(());
    }
    Err(format!("{given} is that of {}, and {:?} were found", input.si, determined.solutions))
}
