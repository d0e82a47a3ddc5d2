//! What must not change an answer: other base units, other units of an input, the reading of the solve.

use itertools::Itertools as _;
use std::{
    collections::{BTreeMap, BTreeSet},
    num::NonZero,
    sync::{
        atomic::{AtomicUsize, Ordering},
        mpsc,
    },
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    AnswerValue, Entry, Field, Number, Record, Shape, Solution, SolveError, Stop, Value, cases, registry,
    vary,
};
use dalembert_plugins as _;
use dalembert_tests::times;
use dalembert_units::{self as units, Dim};

const LENGTH: f64 = 1.7;
const MASS: f64 = 0.6;
const TIME: f64 = 2.3;

/// Nature has no preferred units: a problem written in other base units has the same answers.
#[test]
fn every_answer_scales_with_its_dimension() {
    for_each(&problems(), |_, Problem { name, entry, record, solution: here }| {
        let there =
            entry.solve(&scaled(record), &Stop::new()).unwrap_or_else(|err| panic!("{name} scaled: {err}"));
        assert_eq!(names(here), names(&there), "{name}");
        verified(&format!("{name} scaled"), &there);
        for (a, b) in here.answers.iter().zip_eq(&there.answers) {
            let (want, got) = (numbers(&a.value), numbers(&b.value));
            assert_eq!(want.len(), got.len(), "{name}: {}", a.name);
            let size = want.iter().fold(0.0f64, |size, x| size.max(x.abs()));
            for (want, got) in want.iter().zip_eq(got) {
                let want = want * scale(a.dim());
                assert!(
                    (got - want).abs() <= 1e-8 * size * scale(a.dim()) + a.noise * scale(a.dim()),
                    "{name}: {} is {got} and not {want} in other base units",
                    a.name
                );
            }
        }
    });
}

/// The unit that an input is typed in changes how it is shown, never what is found.
#[test]
fn the_unit_of_an_input_does_not_change_the_answers() {
    for_each(&forms(), |_, Problem { name, entry, record, solution: here }| {
        for Varied { path, field, si, unit, .. } in varied(record) {
            let Some(measure) = measure(&field.shape).map(|measure| measure.of(&unit)) else { continue };
            for unit in measure.units() {
                let mut draft = dalembert_core::Draft::of_record(record);
                let unit = units::unit(unit).unwrap_or_else(|err| panic!("{name}: {err}"));
                let style = units::Style { digits: 17, ascii: true, ..units::Style::default() };
                let text = units::write_quantity(si, &unit, style);
                draft.set(&entry.shape(), &path, &text).unwrap_or_else(|err| panic!("{name}: {err}"));
                let record =
                    draft.read(&entry.shape()).unwrap_or_else(|err| panic!("{name}: {text}: {err:?}"));
                let there =
                    entry.solve(&record, &Stop::new()).unwrap_or_else(|err| panic!("{name}: {text}: {err}"));
                assert_eq!(names(here), names(&there), "{name}: other answers with {path} = {text}");
                verified(&format!("{name}, {path} = {text}"), &there);
                for (a, b) in here.answers.iter().zip_eq(&there.answers) {
                    let (want, got) = (numbers(&a.value), numbers(&b.value));
                    let size = want.iter().fold(0.0f64, |size, x| size.max(x.abs()));
                    assert_eq!(want.len(), got.len(), "{name}: {} with {path} = {text}", a.name);
                    for (want, got) in want.iter().zip_eq(got) {
                        let off = (got - want).abs();
                        assert!(
                            off <= 1e-7 * size + a.noise,
                            "{name}: {} is {got}, not {want}, with {path} = {text}",
                            a.name
                        );
                    }
                }
            }
        }
    });
}

/// The plain reading gives the numbers of the worked solution, bit for bit.
#[test]
fn the_plain_reading_is_the_worked_reading() {
    for_each(&problems(), |_, Problem { name, entry, record, solution: worked }| {
        let numbers = worked.answers.iter().filter(|answer| answer.si().is_some());
        let wanted: Vec<String> = numbers.map(|answer| answer.name.to_string()).collect();
        let wanted: Vec<&str> = wanted.iter().map(String::as_str).collect();
        let mut plain = entry.prepare(record, &[], &wanted).unwrap_or_else(|err| panic!("{name}: {err}"));
        let mut found = vec![0.0; wanted.len()];
        plain.sweep(&[0.0], &mut found, &Stop::new()).unwrap();
        for (name_of, got) in wanted.iter().zip_eq(found) {
            let want = worked.answer(name_of).and_then(dalembert_core::Answer::si).unwrap();
            assert_eq!(want.to_bits(), got.to_bits(), "{name}: {name_of} is {want} worked and {got} plain");
        }
    });
}

/// Whatever finite numbers are typed, a solve answers or refuses; it neither panics nor answers NaN or infinity, and one
/// that takes long ends when it is reported to stop.
#[test]
fn extreme_values_are_answered_or_refused() {
    // Two of the values for each input, others for its neighbour and for the next form; all where more is asked for.
    let apart = (4 / times()).max(1);
    for_each(&forms(), |form, Problem { name, entry, record, .. }| {
        let (varied, inputs) = (varied(record), vary::inputs(record));
        // What is outside the limits of an input is refused where it is read, and never gets to be solved.
        let permitted = |path: &str, si: f64| {
            inputs.iter().find(|input| input.path == path).is_none_or(|input| input.permits(si))
        };
        for (at, extreme) in [0.0, 1e-300, 1e-12, 1e12, 1e150, 1e300, -1.0, -1e12].into_iter().enumerate() {
            for Varied { place, path, .. } in varied.iter().filter(|varied| {
                (varied.place + form + at).is_multiple_of(apart) && permitted(&varied.path, extreme)
            }) {
                let mut wild = record.clone();
                let mut seen = 0;
                replace(&mut wild, &mut |quantity| {
                    if seen == *place {
                        quantity.si = extreme;
                    }
                    seen += 1;
                });
                check_finite(&format!("{name}: {path} is {extreme:e}"), &stopped_after_a_while(entry, &wild));
            }
        }
    });
}

fn verified(name: &str, solution: &Solution) {
    if let Some(check) = solution.checks.iter().find(|check| !check.passed) {
        panic!("{name}: {}: {:e}, at most {:e}", check.what.english(), check.residual, check.limit);
    }
}

/// What a solve finds that is reported to stop when it has taken so long.
fn stopped_after_a_while(entry: &Entry, record: &Record) -> Result<Solution, SolveError> {
    const LONG: Duration = Duration::from_millis(100);
    const SOON: Duration = Duration::from_secs(20);
    let (stop, begun) = (&Stop::new(), Instant::now());
    let solved = thread::scope(|scope| {
        let (done, waits) = mpsc::channel::<()>();
        scope.spawn(move || {
            if waits.recv_timeout(LONG) == Err(mpsc::RecvTimeoutError::Timeout) {
                stop.stop();
            }
        });
        let solved = entry.solve(record, stop);
        drop(done);
        solved
    });
    assert!(begun.elapsed() < SOON, "{}: goes on after it was asked to stop", entry.about.id);
    solved
}

fn check_finite(name: &str, solved: &Result<Solution, SolveError>) {
    if let Ok(solution) = solved {
        for answer in &solution.answers {
            assert!(
                numbers(&answer.value).iter().all(|x| x.is_finite()),
                "{name}: {} is not finite",
                answer.name
            );
        }
    }
}

fn numbers(value: &AnswerValue) -> Vec<f64> {
    match value {
        AnswerValue::Number(Number::Scalar(x), _) => vec![*x],
        AnswerValue::Number(Number::Vector(v), _) => v.to_vec(),
        AnswerValue::List(numbers) => numbers.clone(),
        AnswerValue::Set(set, _) => set
            .intervals()
            .flat_map(|interval| [interval.lower, interval.upper])
            .filter_map(|bound| match bound {
                std::ops::Bound::Included(x) | std::ops::Bound::Excluded(x) => Some(x),
                std::ops::Bound::Unbounded => None,
            })
            .collect(),
    }
}

/// Which answers there are: rounding has no part in that.
fn names(solution: &Solution) -> Vec<String> {
    solution.answers.iter().map(|answer| answer.name.to_string()).collect()
}

fn scale(dim: Dim) -> f64 {
    LENGTH.powi(dim.length.into()) * MASS.powi(dim.mass.into()) * TIME.powi(dim.time.into())
}

fn scaled(record: &Record) -> Record {
    let mut record = record.clone();
    scale_record(&mut record);
    record
}

fn scale_record(record: &mut Record) {
    record.values.iter_mut().for_each(scale_value);
}

fn scale_value(value: &mut Value) {
    match value {
        Value::Quantity(quantity) => quantity.si *= scale(quantity.unit.dim),
        Value::Vector(vector) => vector.si.iter_mut().for_each(|x| *x *= scale(vector.unit.dim)),
        Value::Group(record) | Value::OneOf { fields: record, .. } => scale_record(record),
        Value::Rows(rows) => rows.iter_mut().for_each(scale_value),
        Value::Table(table) => {
            for row in &mut table.rows {
                row.iter_mut().zip_eq(&table.units).for_each(|(x, unit)| *x *= scale(unit.dim));
            }
        }
        _ => {}
    }
}

fn replace(record: &mut Record, change: &mut impl FnMut(&mut units::Quantity)) {
    fn value(value_here: &mut Value, change: &mut impl FnMut(&mut units::Quantity)) {
        match value_here {
            Value::Quantity(quantity) => change(quantity),
            Value::Group(record) | Value::OneOf { fields: record, .. } => replace(record, change),
            Value::Rows(rows) => rows.iter_mut().for_each(|row| value(row, change)),
            _ => {}
        }
    }
    record.values.iter_mut().for_each(|here| value(here, change));
}

fn measure(shape: &Shape) -> Option<dalembert_core::Measure> {
    match shape {
        Shape::Quantity(measure) => Some(*measure),
        Shape::Optional(inner) => measure(inner()),
        Shape::Rows { item, .. } => measure(item()),
        _ => None,
    }
}

/// An input that is varied by itself.
struct Varied {
    /// Its place among the quantities of the problem.
    place: usize,
    path: String,
    field: &'static Field,
    si: f64,
    /// As it was written.
    unit: units::Unit,
}

/// The quantities of a problem. Of rows that ask for the same, the first two stand for all: a shaft of eighteen
/// segments is no other code than one of two.
fn varied(record: &Record) -> Vec<Varied> {
    let mut all = Vec::new();
    let mut place = 0;
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    record.leaves(&mut |path, field, value| {
        let Value::Quantity(quantity) = value else { return };
        let times = seen.entry(without_rows(path)).or_default();
        *times += 1;
        if *times <= 2 {
            let (si, unit) = (quantity.si, quantity.unit.clone());
            all.push(Varied { place, path: path.to_owned(), field, si, unit });
        }
        place += 1;
    });
    all
}

/// A path without the numbers of rows: `masses[].radius`.
fn without_rows(path: &str) -> String {
    path.chars().filter(|c| !c.is_ascii_digit()).collect()
}

/// What is asked and how it is answered, without the numbers: the alternatives that are chosen, and what is left out.
fn form(record: &Record) -> BTreeSet<String> {
    let mut form = BTreeSet::new();
    record.leaves(&mut |path, _, value| {
        let kind = match value {
            Value::OneOf { variant, .. } => format!("{variant}"),
            Value::Flag(yes) => format!("{yes}"),
            Value::Absent => "absent".to_owned(),
            _ => String::new(),
        };
        form.insert(format!("{} {kind}", without_rows(path)));
    });
    form
}

/// A problem of the catalogue, and what comes of it.
struct Problem {
    name: String,
    entry: &'static Entry,
    record: Record,
    solution: Solution,
}

/// Every form of every problem, once: cases of the same analysis that fill in the same inputs with other numbers
/// would vary the same things once more.
fn forms() -> Vec<Problem> {
    let mut seen = BTreeSet::new();
    let mut all = problems();
    all.retain(|problem| seen.insert((problem.entry.about.id, form(&problem.record))));
    all
}

/// Every case of every analysis, or of the one that `DALEMBERT_ONLY` names.
fn problems() -> Vec<Problem> {
    let only = std::env::var("DALEMBERT_ONLY").ok();
    assert!(only.as_deref().is_none_or(|id| dalembert_core::find(id).is_some()), "no analysis is {only:?}");
    let mut all = Vec::new();
    for entry in registry().iter().filter(|entry| only.as_deref().is_none_or(|id| id == entry.about.id)) {
        for case in cases::cases(entry).unwrap_or_else(|err| panic!("{}: {err}", entry.about.id)) {
            if case.refused.is_some() {
                continue;
            }
            let name = format!("{}, {}", entry.about.id, case.name);
            let record = case.record(entry).unwrap_or_else(|err| panic!("{name}: {err}"));
            let solution = entry.solve(&record, &Stop::new()).unwrap_or_else(|err| panic!("{name}: {err}"));
            all.push(Problem { name, entry, record, solution });
        }
    }
    all
}

/// Examines each of them, on all cores.
fn for_each(problems: &[Problem], look: impl Fn(usize, &Problem) + Sync) {
    assert!(!problems.is_empty(), "there is no problem to examine");
    let next = AtomicUsize::new(0);
    let workers = thread::available_parallelism().map_or(1, NonZero::get);
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| {
                loop {
                    let at = next.fetch_add(1, Ordering::Relaxed);
                    let Some(problem) = problems.get(at) else { break };
                    look(at, problem);
                }
            });
        }
    });
}
