//! Every case of every analysis with all its numbers changed at random by up to 30 %: what a user may well type. It is
//! answered with finite numbers, no failed check and every answer in its own range, or refused for a reason that is the
//! input's. `cargo xtask soak perturb --draws N` draws more.

use itertools::Itertools as _;
use std::{
    collections::BTreeMap,
    fmt::Write as _,
    fs,
    panic::{AssertUnwindSafe, catch_unwind},
    path::PathBuf,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    Answer, AnswerValue, Entry, Record, Refusal, Solution, SolveError, Stop, Text, Value, cases, registry,
    text::Arg, vary,
};
use dalembert_mechanics::balance::spread::uniform_bits;
use dalembert_plugins as _;

/// Draws for each case where nobody asks for more.
const DRAWS: u64 = 3;
/// The largest change of a number, over the number.
const CHANGE: f64 = 0.3;
/// Answers that are ranges, and the answers that lie in them.
const RANGES: [(&str, &str); 2] = [("correction_range", "correction"), ("angle_range", "correction_angle")];

/// Counts over all draws.
#[derive(Default)]
struct Met {
    /// Of each analysis: drawn, answered, refused.
    counts: BTreeMap<&'static str, [usize; 3]>,
    faults: Vec<String>,
    /// Templates of refusals, how often they came, and where first.
    refusals: BTreeMap<String, (usize, String)>,
    slow: Vec<String>,
}

#[test]
fn numbers_near_those_of_a_case_are_answered_or_refused_with_reason() {
    let asked = number("DALEMBERT_DRAWS");
    let draws = asked.unwrap_or(DRAWS);
    // The same draws every day: a sentence that comes once in ten thousand is met by who asks for more, not by who happens
    // to commit something else.
    let seed = asked.and_then(|_| number("PROPTEST_RNG_SEED")).unwrap_or(0);
    let only = std::env::var("DALEMBERT_ONLY").ok();
    let jobs: Vec<(&'static Entry, String, Record)> = registry()
        .iter()
        .filter(|entry| only.as_deref().is_none_or(|id| id == entry.about.id))
        .flat_map(|entry| cases::cases(entry).unwrap().into_iter().map(move |case| (*entry, case)))
        .filter(|(_, case)| case.refused.is_none())
        .map(|(entry, case)| {
            let record = case.record(entry).unwrap_or_else(|err| panic!("{}: {err}", case.name));
            (entry, format!("{}, {}", entry.about.id, case.name), record)
        })
        .collect();
    assert!(!jobs.is_empty(), "no analysis is {only:?}");
    let (met, next) = (Mutex::new(Met::default()), AtomicUsize::new(0));
    let workers = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| {
                while let Some((entry, name, record)) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) {
                    for draw in 0..draws {
                        let key = name.bytes().fold(draw, |key, byte| {
                            key.wrapping_mul(0x0100_0000_01b3).wrapping_add(u64::from(byte))
                        });
                        let record = perturbed(record, seed, key);
                        try_one(entry, &format!("{name}, draw {draw}"), &record, &met);
                    }
                }
            });
        }
    });
    let met = met.into_inner().unwrap();
    let judged = judged();
    let mut faults = met.faults.clone();
    for (template, (count, first)) in &met.refusals {
        match judged.get(template).map(String::as_str) {
            Some("input at fault") => {}
            Some(verdict) => faults.push(format!("refused {count} times, {verdict}: {template} ({first})")),
            None => {
                faults.push(format!("refused {count} times, not in docs/refusals.md: {template} ({first})"));
            }
        }
    }
    report(&met, draws);
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

/// A refusal that is judged twice, or that no sentence of the program is like, would say nothing.
#[test]
fn the_table_of_refusals_is_sound() {
    let judged = judged();
    assert!(judged.len() >= 20, "docs/refusals.md has {} rows", judged.len());
    for (template, verdict) in judged {
        assert!(["input at fault", "ours"].contains(&verdict.as_str()), "{template}: {verdict}");
    }
}

fn try_one(entry: &'static Entry, name: &str, record: &Record, met: &Mutex<Met>) {
    // The form and a file do not let such a number pass.
    let within = vary::inputs(record).iter().all(|input| input.permits(input.si));
    let start = Instant::now();
    let solved = if within {
        catch_unwind(AssertUnwindSafe(|| entry.solve(record, &Stop::new())))
    } else {
        Ok(Err(SolveError::Refused(Refusal::because("outside the limits of this input"))))
    };
    let took = start.elapsed();
    let mut met = met.lock().expect("no draw panics with the list");
    if took > Duration::from_secs(10) {
        met.slow.push(format!("{name}: {:.0} s", took.as_secs_f64()));
    }
    let mut refused = Vec::new();
    match solved {
        Err(_) => met.faults.push(format!("{name}: panics")),
        Ok(Ok(solution)) => {
            let faults = faults(&solution);
            if !faults.is_empty() {
                let inputs = vary::inputs(record);
                let numbers: Vec<String> =
                    inputs.iter().map(|input| format!("{}={}", input.path, input.si)).collect();
                let with = numbers.join(" ");
                met.faults.extend(faults.into_iter().map(|fault| format!("{name}: {fault}; SI: {with}")));
            }
        }
        Ok(Err(SolveError::Refused(Refusal::NoAnswer(why)))) => refused.push(template(&why)),
        Ok(Err(SolveError::Refused(Refusal::Stopped))) => met.faults.push(format!("{name}: stopped")),
        Ok(Err(SolveError::Fields(errors))) => {
            refused.extend(errors.iter().map(|error| template(&error.why)));
        }
    }
    let counts = met.counts.entry(entry.about.id).or_default();
    counts[0] += 1;
    counts[if refused.is_empty() { 1 } else { 2 }] += 1;
    refused.sort();
    refused.dedup();
    for template in refused {
        met.refusals.entry(template).or_insert_with(|| (0, name.to_owned())).0 += 1;
    }
}

/// Defects of a solution, whatever the problem.
fn faults(solution: &Solution) -> Vec<String> {
    let mut faults: Vec<String> = solution.defects.clone();
    for check in solution.checks.iter().filter(|check| !check.passed) {
        faults.push(format!("FAILED {:.1e} > {:.1e} {}", check.residual, check.limit, check.what.english()));
    }
    for answer in &solution.answers {
        let finite = match &answer.value {
            AnswerValue::Number(number, _) => number.is_finite(),
            AnswerValue::List(all) => all.iter().all(|x| x.is_finite()),
            AnswerValue::Set(..) => true,
        };
        if !finite {
            faults.push(format!("{} is not finite", answer.name));
        }
        let AnswerValue::Set(range, _) = &answer.value else { continue };
        if !answer.name.base.ends_with("_range") {
            continue;
        }
        let Some((_, of)) = RANGES.iter().find(|(range, _)| *range == answer.name.base) else {
            faults.push(format!("{}: the answer in this range is not known to the test", answer.name));
            continue;
        };
        let mut name = answer.name;
        name.base = of;
        let value = solution.answers.iter().find(|answer| answer.name == name).and_then(Answer::si);
        let Some(value) = value else {
            faults.push(format!("{}: there is no answer {name}", answer.name));
            continue;
        };
        // An angle may be marked a turn before or after its range.
        let turns = if of.ends_with("angle") { [-1.0, 0.0, 1.0] } else { [0.0; 3] };
        let about = |value: f64| [value * (1.0 - 1e-9), value, value * (1.0 + 1e-9)];
        let mut places = turns.iter().flat_map(|turn| about(value + turn * std::f64::consts::TAU));
        if !places.any(|place| range.contains(place)) {
            faults.push(format!("{name} = {value} lies outside its own range"));
        }
    }
    faults
}

/// The sentence without what stands in it; where it is made of sentences, with theirs.
fn template(why: &Text) -> String {
    let mut all = why.template.to_string();
    for (_, arg) in &why.args {
        if let Arg::Text(inner) = arg
            && !inner.template.is_empty()
            && why.template.matches(char::is_alphabetic).count() < 20
        {
            write!(all, " / {}", template(inner)).expect("a String takes all that is written");
        }
    }
    all.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "/")
}

/// The record with every number changed by a factor of its own, a column of a table by one.
fn perturbed(record: &Record, seed: u64, key: u64) -> Record {
    let mut record = record.clone();
    let mut place = 0;
    let mut factor = || {
        place += 1;
        let share = (uniform_bits(seed, key, place) >> 11) as f64 / (1u64 << 53) as f64;
        1.0 + CHANGE * (2.0 * share - 1.0)
    };
    record.values.iter_mut().for_each(|value| perturb(value, &mut factor));
    record
}

fn perturb(value: &mut Value, factor: &mut impl FnMut() -> f64) {
    match value {
        Value::Quantity(quantity) => quantity.si *= factor(),
        Value::Vector(vector) => vector.si.iter_mut().for_each(|x| *x *= factor()),
        Value::Group(record) | Value::OneOf { fields: record, .. } => {
            record.values.iter_mut().for_each(|value| perturb(value, factor));
        }
        Value::Rows(rows) => rows.iter_mut().for_each(|row| perturb(row, factor)),
        Value::Table(table) => {
            let factors: Vec<f64> = table.units.iter().map(|_| factor()).collect();
            for row in &mut table.rows {
                row.iter_mut().zip_eq(&factors).for_each(|(x, factor)| *x *= factor);
            }
        }
        Value::Text(_) | Value::Flag(_) | Value::Count(_) | Value::Reference { .. } | Value::Absent => {}
    }
}

/// The verdicts of `docs/refusals.md` by template.
fn judged() -> BTreeMap<String, String> {
    let text = fs::read_to_string(table()).expect("docs/refusals.md is there");
    let mut judged = BTreeMap::new();
    for line in text.lines().filter(|line| line.starts_with("| `")) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [template, verdict, ..] = cells[..] else { panic!("a row of two cells at least: {line}") };
        let template = template.trim_matches('`').to_owned();
        let before = judged.insert(template.clone(), verdict.trim_matches('*').to_owned());
        assert!(before.is_none(), "{template} stands twice");
    }
    judged
}

fn table() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/refusals.md")
}

/// Writes a report to the file that `DALEMBERT_REPORT` names.
fn report(met: &Met, draws: u64) {
    let Ok(path) = std::env::var("DALEMBERT_REPORT") else { return };
    let sum = |at: usize| met.counts.values().map(|counts| counts[at]).sum::<usize>();
    let mut text = format!(
        "{draws} draws of each case: {} drawn, {} answered, {} refused, {} faults\n",
        sum(0),
        sum(1),
        sum(2),
        met.faults.len()
    );
    for (id, [drawn, answered, refused]) in &met.counts {
        writeln!(text, "{id}: {drawn} drawn, {answered} answered, {refused} refused")
            .expect("a String takes all that is written");
    }
    let judged = judged();
    for (template, (count, first)) in &met.refusals {
        let verdict = judged.get(template).map_or("not judged", String::as_str);
        writeln!(text, "| `{template}` | *{verdict}* | {count} | {first}")
            .expect("a String takes all that is written");
    }
    for line in met.faults.iter().chain(&met.slow) {
        writeln!(text, "{line}").expect("a String takes all that is written");
    }
    fs::write(path, text).expect("the report can be written");
}

fn number(name: &str) -> Option<u64> {
    std::env::var(name).ok().map(|text| text.parse().unwrap_or_else(|_| panic!("{name} is a number: {text}")))
}

#[test]
fn a_perturbed_number_stays_within_its_share_and_is_drawn_again() {
    let entry = dalembert_core::find("vibration/free-vibration").unwrap();
    let record = cases::cases(entry).unwrap()[0].record(entry).unwrap();
    let one = perturbed(&record, 7, 1);
    assert_eq!(one, perturbed(&record, 7, 1));
    assert_ne!(one, perturbed(&record, 7, 2));
    let mut seen = 0;
    let mut numbers = Vec::new();
    record.leaves(&mut |_, _, value| {
        if let Value::Quantity(quantity) = value {
            numbers.push(quantity.si);
        }
    });
    one.leaves(&mut |path, _, value| {
        if let Value::Quantity(quantity) = value {
            let change = (quantity.si - numbers[seen]).abs();
            assert!(change <= CHANGE * numbers[seen].abs(), "{path}");
            seen += 1;
        }
    });
    assert!(seen > 0);
}
