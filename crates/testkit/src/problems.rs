//! Problems of the catalogue: every case of every analysis with its solution.

use std::{
    collections::BTreeMap,
    num::NonZero,
    ops::Bound,
    ptr,
    sync::{
        LazyLock, Mutex, OnceLock,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use dalembert_core::{
    AnswerValue, COMMON_LISTS, Entry, Number, Record, Solution, Stop, Value,
    cases::{self, Case},
};

/// A problem of the catalogue, and its solution.
#[derive(Debug)]
pub struct SolvedCase {
    /// Analysis and case.
    pub name: String,
    /// Analysis.
    pub entry: &'static Entry,
    /// Inputs.
    pub record: Record,
    /// Solution of the analysis for the inputs.
    pub solution: Solution,
}

/// The cases of an analysis.
pub(crate) fn cases_of(entry: &Entry) -> Vec<Case> {
    cases::cases(entry).unwrap_or_else(|err| panic!("{}: {err}", entry.about.id))
}

/// Every case with a solution.
pub(crate) fn problems(entries: &[&'static Entry]) -> Vec<&'static SolvedCase> {
    let mut all = Vec::new();
    for_each_problem(entries, |problem| all.push(problem));
    all
}

/// Visits every case with a solution, one after the other. A case is solved once for all tests of a process.
///
/// # Panics
/// If there is no analysis, or a case that is not to be refused cannot be read or solved.
pub fn for_each_problem(entries: &[&'static Entry], visit: impl FnMut(&'static SolvedCase)) {
    assert!(!entries.is_empty(), "there is no analysis to examine");
    entries.iter().flat_map(|entry| solved_cases(entry)).for_each(visit);
}

/// The cases of an analysis that are not refused, solved when they are first asked for.
pub(crate) fn solved_cases(entry: &'static Entry) -> &'static [SolvedCase] {
    type Solved = OnceLock<Vec<SolvedCase>>;
    static SOLVED: LazyLock<Mutex<BTreeMap<usize, &'static Solved>>> = LazyLock::new(Mutex::default);
    let place = ptr::from_ref(entry).addr();
    let solved: &'static Solved = SOLVED
        .lock()
        .expect("no panic while it is held")
        .entry(place)
        .or_insert_with(|| Box::leak(Box::default()));
    solved.get_or_init(|| {
        let cases = cases_of(entry).into_iter().filter(|case| case.refused.is_none());
        cases.map(|case| solved_case(entry, &case)).collect()
    })
}

fn solved_case(entry: &'static Entry, case: &Case) -> SolvedCase {
    let name = format!("{}, {}", entry.about.id, case.name);
    let record = case.record(entry).unwrap_or_else(|err| panic!("{name}: {err}"));
    let solution = entry.solve(&record, &Stop::new()).unwrap_or_else(|err| panic!("{name}: {err}"));
    SolvedCase { name, entry, record, solution }
}

/// Returns true if a problem has definitions, questions or given answers: their texts hold quantities that no input has.
pub(crate) fn has_formulas(record: &Record) -> bool {
    let is_there = |list: &&str| matches!(record.get(list), Some(Value::Rows(rows)) if !rows.is_empty());
    COMMON_LISTS.iter().any(is_there)
}

/// The solution of the first case of each analysis.
pub(crate) fn first_solutions(
    entries: &[&'static Entry],
) -> impl Iterator<Item = (&'static Entry, Solution)> {
    assert!(!entries.is_empty(), "there is no analysis to examine");
    entries.iter().filter_map(|entry| {
        let record = cases::first(entry)?.record(entry).ok()?;
        Some((*entry, entry.solve(&record, &Stop::new()).ok()?))
    })
}

/// Calls `work` with each item and its place, on all cores; panics of it are those of the caller.
///
/// # Panics
/// If there is no item, or where `work` panics.
pub fn on_all_cores<T: Sync>(items: &[T], work: impl Fn(usize, &T) + Sync) {
    assert!(!items.is_empty(), "there is nothing to examine");
    let next = AtomicUsize::new(0);
    let workers = thread::available_parallelism().map_or(1, NonZero::get);
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| {
                loop {
                    let at = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(at) else { break };
                    work(at, item);
                }
            });
        }
    });
}

/// The numbers of an answer: of a vector its components, of a set the ends of its intervals.
pub(crate) fn numbers(value: &AnswerValue) -> Vec<f64> {
    match value {
        AnswerValue::Number(Number::Scalar(x), _) => vec![*x],
        AnswerValue::Number(Number::Vector(v), _) => v.to_vec(),
        AnswerValue::List(numbers) => numbers.clone(),
        AnswerValue::Set(set, _) => {
            set.intervals().flat_map(|interval| [interval.lower, interval.upper]).filter_map(end).collect()
        }
    }
}

fn end(bound: Bound<f64>) -> Option<f64> {
    match bound {
        Bound::Included(x) | Bound::Excluded(x) => Some(x),
        Bound::Unbounded => None,
    }
}
