//! Invariance of answers: under other base units, other units of an input, the other reading of the solve.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{Mutex, mpsc},
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    Answer, Draft, Entry, Field, Record, Solution, SolveError, Stop, Value,
    vary::{self, Perturbed},
};
use dalembert_numerics::random::uniform;
use dalembert_units::{self as units, Dim};
use itertools::Itertools as _;

use crate::problems::{SolvedCase, has_formulas, numbers, on_all_cores, problems};

const LENGTH: f64 = 1.7;
const MASS: f64 = 0.6;
const TIME: f64 = 2.3;

/// Solves every case in other base units, of which nature has none it prefers: each answer scales with its dimension. Cases
/// with formulas hold quantities beside their inputs, which are left out.
pub fn every_answer_scales_with_its_dimension(entries: &[&'static Entry]) {
    on_all_cores(&problems(entries), |_, SolvedCase { name, entry, record, solution: here }| {
        if has_formulas(record) {
            return;
        }
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

/// Types every input in each of its units: a unit changes how a number is shown, never what is found. Every text is read;
/// for each input `times` of the units are solved with, in turn, so that each unit of a quantity is met in some problem.
pub fn the_unit_of_an_input_does_not_change_the_answers(entries: &[&'static Entry], times: usize) {
    on_all_cores(&forms(entries), |form, SolvedCase { name, entry, record, solution: here }| {
        if has_formulas(record) {
            return;
        }
        for Varied { place, path, field, si, unit } in varied(record) {
            let Some(measure) = field.shape.measure().map(|measure| measure.of(&unit)) else { continue };
            let all = measure.units();
            for (n, unit) in all.iter().enumerate() {
                let mut draft = Draft::of_record(record);
                let unit = units::unit(unit).unwrap_or_else(|err| panic!("{name}: {err}"));
                let style = units::Style { digits: 17, ascii: true, ..units::Style::default() };
                let text = units::write_quantity(si, &unit, style);
                draft.set(&entry.shape(), &path, &text).unwrap_or_else(|err| panic!("{name}: {err}"));
                let record =
                    draft.read(&entry.shape()).unwrap_or_else(|err| panic!("{name}: {text}: {err:?}"));
                let mut read = f64::NAN;
                record.leaves(&mut |at, _, value| {
                    if let Value::Quantity(quantity) = value
                        && at == path
                    {
                        read = quantity.si;
                    }
                });
                assert!(
                    (read - si).abs() <= 1e-14 * si.abs(),
                    "{name}: {path} = {text} is read as {read}, not {si}"
                );
                if (n + form + place) % all.len() >= times {
                    continue;
                }
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

/// Compares the plain reading of every case with the worked one: the numbers are the same, bit for bit.
pub fn the_plain_reading_is_the_worked_reading(entries: &[&'static Entry]) {
    on_all_cores(&problems(entries), |_, SolvedCase { name, entry, record, solution: worked }| {
        let numbers = worked.answers.iter().filter(|answer| answer.si().is_some());
        let wanted: Vec<String> = numbers.map(|answer| answer.name.to_string()).collect();
        let wanted: Vec<&str> = wanted.iter().map(String::as_str).collect();
        let mut plain = entry.prepare(record, &[], &wanted).unwrap_or_else(|err| panic!("{name}: {err}"));
        let mut found = vec![0.0; wanted.len()];
        plain.sweep(&[0.0], &mut found, &Stop::new()).unwrap_or_else(|err| panic!("{name}: {err}"));
        for (name_of, got) in wanted.iter().zip_eq(found) {
            let want = worked.answer(name_of).and_then(Answer::si).expect("it was among the numbers");
            assert_eq!(want.to_bits(), got.to_bits(), "{name}: {name_of} is {want} worked and {got} plain");
        }
    });
}

/// Compares a sweep over many points with a sweep of each point alone, for every case of the analyses that are read by
/// SIMD: the answers and the reasons of refused points are the same, bit for bit. Each of these analyses has points that
/// are read several at once. Of each case all answers together are read, and `times` in four of the answers alone, other
/// ones with the next case.
pub fn points_read_by_simd_are_those_read_one_by_one(entries: &[&'static Entry], times: usize) {
    /// Points that differ by little, and that differ by so much that conditions have other outcomes.
    const SPREADS: [(u64, f64); 2] = [(64, 1e-6), (83, 0.9)];
    const NO_PANIC: &str = "nobody panics while counting";
    let by_simd = Mutex::new(BTreeMap::new());
    let entries: Vec<&'static Entry> = entries.iter().copied().filter(|entry| entry.simd).collect();
    if entries.is_empty() {
        return;
    }
    on_all_cores(&problems(&entries), |problem, SolvedCase { name, entry, record, solution }| {
        let numbers = solution.answers.iter().filter(|answer| answer.si().is_some());
        let wanted = numbers.map(|answer| answer.name.to_string()).collect();
        let Perturbed { inputs, answers, .. } = Perturbed::new(entry, record, vary::inputs(record), wanted)
            .unwrap_or_else(|err| panic!("{name}: {err}"));
        let paths: Vec<&str> = inputs.iter().map(|input| input.path.as_str()).collect();
        let every: Vec<&str> = answers.iter().map(String::as_str).collect();
        let value = |sample: u64, place: usize, spread: f64| {
            let (input, off) = (&inputs[place], spread * (2.0 * uniform(1, sample, place as u64) - 1.0));
            if input.unit.dim == Dim::ANGLE { input.si + 4.0 * off } else { input.si * (1.0 + off) }
        };
        let points: Vec<f64> = SPREADS
            .into_iter()
            .flat_map(|(count, spread)| (0..count).map(move |sample| (sample, spread)))
            .flat_map(|(sample, spread)| (0..paths.len()).map(move |place| (sample, place, spread)))
            .map(|(sample, place, spread)| value(sample, place, spread))
            .collect();
        // All answers together need what no SIMD vector holds; each alone ends before it.
        let alone = every.iter().enumerate().filter(|(n, _)| (n + problem) % 4 < times);
        for wanted in alone.map(|(_, name)| std::slice::from_ref(name)).chain([&every[..]]) {
            let prepare =
                || entry.prepare(record, &paths, wanted).unwrap_or_else(|err| panic!("{name}: {err}"));
            let (mut block, mut single) = (prepare(), prepare());
            let mut together = vec![0.0; points.len() / paths.len() * wanted.len()];
            let mut refused = Vec::new();
            let mut refuse = |row, why| refused.push((row, why));
            let stop = Stop::new();
            block.sweep_with_reasons(&points, &mut together, &mut refuse, &stop).expect("nobody stops it");
            let mut refusals = refused.into_iter().peekable();
            let rows = points.chunks_exact(paths.len()).zip_eq(together.chunks_exact(wanted.len()));
            for (n, (point, together)) in rows.enumerate() {
                let (mut alone, mut why) = (vec![0.0; wanted.len()], None);
                let mut refuse = |_, text| why = Some(text);
                single.sweep_with_reasons(point, &mut alone, &mut refuse, &stop).expect("nobody stops it");
                assert_eq!(
                    refusals.next_if(|(row, _)| *row == n).map(|(_, why)| why),
                    why,
                    "{name}: point {n}"
                );
                for (answer, (a, b)) in wanted.iter().zip_eq(together.iter().zip_eq(&alone)) {
                    let is_same = a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
                    assert!(is_same, "{name}: {answer} at point {n} is {a} by SIMD, and {b} alone");
                }
            }
            assert_eq!(single.points_by_simd(), 0);
            *by_simd.lock().expect(NO_PANIC).entry(entry.about.id).or_insert(0) += block.points_by_simd();
        }
    });
    for (id, points) in by_simd.into_inner().expect(NO_PANIC) {
        assert!(points > 0, "{id}: no points were read several at once");
    }
}

/// Types extreme numbers: a solve answers or refuses; it neither panics nor answers NaN or infinity, and one that takes
/// long ends when it is given the stop signal. `times` many times as many values are tried.
pub fn extreme_values_are_answered_or_refused(entries: &[&'static Entry], times: usize) {
    // Two of the values for each input, others for its neighbour and for the next form; all where more is asked for.
    let apart = (4 / times).max(1);
    on_all_cores(&forms(entries), |form, SolvedCase { name, entry, record, .. }| {
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

/// Solves, with the stop signal after a while.
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

/// Names of the answers: rounding has no part in them.
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
            let units = table.units.clone();
            for row in table.rows_mut() {
                row.iter_mut().zip_eq(&units).for_each(|(x, unit)| *x *= scale(unit.dim));
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

/// An input that is varied by itself.
struct Varied {
    /// Place among the quantities of the problem.
    place: usize,
    path: String,
    field: &'static Field,
    si: f64,
    /// Unit as it was written.
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

/// The form of a problem without its numbers: the alternatives that are chosen, and what is left out.
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

/// Every form of every problem, once: cases of the same analysis that fill in the same inputs with other numbers
/// would vary the same things once more.
fn forms(entries: &[&'static Entry]) -> Vec<&'static SolvedCase> {
    let mut seen = BTreeSet::new();
    let mut all = problems(entries);
    all.retain(|problem| seen.insert((problem.entry.about.id, form(&problem.record))));
    all
}
