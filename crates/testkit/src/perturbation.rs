//! Perturbation: every case with all its numbers changed at random by up to 30 %, as a user may well type them.

use std::{
    collections::BTreeMap,
    fmt::Write as _,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::Mutex,
    time::{Duration, Instant},
};

use dalembert_core::{
    Answer, AnswerValue, Entry, Record, Refusal, Solution, SolveError, Stop, Text, Value, text::Arg, vary,
};
use dalembert_numerics::random::uniform_bits;
use itertools::Itertools as _;

use crate::{
    problems::{cases_of, has_formulas, on_all_cores},
    some,
};

/// The largest change of a number, over the number.
pub const CHANGE: f64 = 0.3;
/// Answers in the range of another name than their own with `_range`.
const RANGES: [(&str, &str); 1] = [("angle_range", "correction_angle")];

/// Random draws, and the verdicts on refusals.
#[derive(Clone, Copy, Debug)]
pub struct Draws<'a> {
    /// Draws of each case.
    pub count: u64,
    /// Seed; the same seed draws the same numbers.
    pub seed: u64,
    /// Table of Markdown with the refusals that are permitted, as `docs/refusals.md`; `None` permits every one.
    pub refusals: Option<&'a str>,
}

impl Default for Draws<'_> {
    fn default() -> Self {
        Self { count: 3, seed: 0, refusals: None }
    }
}

/// Outcomes of all draws.
#[derive(Default)]
struct Met {
    /// Of each analysis: drawn, answered, refused.
    counts: BTreeMap<&'static str, [usize; 3]>,
    faults: Vec<String>,
    /// Templates of refusals, how often they came, and where first.
    refusals: BTreeMap<String, (usize, String)>,
    slow: Vec<String>,
}

/// Changes all numbers of every case at random: each problem is answered with finite numbers, no failed check and
/// every answer in its own range, or refused for a reason that is the input's. `report_to` gets all that was met
/// before a fault ends the test.
pub fn numbers_near_those_of_a_case_are_answered_or_refused_with_reason(
    entries: &[&'static Entry],
    draws: &Draws<'_>,
    report_to: impl FnOnce(&str),
) {
    some(entries);
    let jobs: Vec<(&'static Entry, String, Record)> = entries
        .iter()
        .flat_map(|entry| cases_of(entry).into_iter().map(move |case| (*entry, case)))
        .filter(|(_, case)| case.refused.is_none())
        .map(|(entry, case)| {
            let record = case.record(entry).unwrap_or_else(|err| panic!("{}: {err}", case.name));
            (entry, format!("{}, {}", entry.about.id, case.name), record)
        })
        .collect();
    let met = Mutex::new(Met::default());
    on_all_cores(&jobs, |_, (entry, name, record)| {
        for draw in 0..draws.count {
            let key = name
                .bytes()
                .fold(draw, |key, byte| key.wrapping_mul(0x0100_0000_01b3).wrapping_add(u64::from(byte)));
            let record = perturbed(record, draws.seed, key);
            try_one(entry, &format!("{name}, draw {draw}"), &record, &met);
        }
    });
    let met = met.into_inner().expect("no draw panics with the list");
    let mut faults = met.faults.clone();
    if let Some(table) = draws.refusals {
        let verdicts = verdicts(table);
        for (template, (count, first)) in &met.refusals {
            match verdicts.get(template).map(String::as_str) {
                Some("input at fault") => {}
                Some(verdict) => {
                    faults.push(format!("refused {count} times, {verdict}: {template} ({first})"));
                }
                None => {
                    faults.push(format!(
                        "refused {count} times, not among the refusals that are known: {template} ({first})"
                    ));
                }
            }
        }
    }
    report_to(&report(&met, draws));
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

/// Verdicts on refusals by their templates, as a table of Markdown has them: `message`, *verdict*.
pub fn verdicts(table: &str) -> BTreeMap<String, String> {
    let mut verdicts = BTreeMap::new();
    for line in table.lines().filter(|line| line.starts_with("| `")) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [template, verdict, ..] = cells[..] else { panic!("a row of two cells at least: {line}") };
        let template = template.trim_matches('`').to_owned();
        let before = verdicts.insert(template.clone(), verdict.trim_matches('*').to_owned());
        assert!(before.is_none(), "{template} stands twice");
    }
    verdicts
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

/// Faults of a solution, whatever the problem.
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
        let of = RANGES.iter().find(|(range, _)| *range == answer.name.base);
        let Some(of) = of.map(|(_, of)| *of).or(answer.name.base.strip_suffix("_range")) else { continue };
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

/// The sentence without its arguments; one that is made of sentences, with theirs.
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
pub fn perturbed(record: &Record, seed: u64, key: u64) -> Record {
    let mut record = record.clone();
    let mut place = 0;
    let mut factor = || {
        place += 1;
        let share = (uniform_bits(seed, key, place) >> 11) as f64 / (1u64 << 53) as f64;
        1.0 + CHANGE * (2.0 * share - 1.0)
    };
    record.values.iter_mut().for_each(|value| perturb(value, &mut factor));
    if !has_formulas(&record) {
        return record;
    }
    // Inputs with a formula follow the others.
    let first = vary::inputs(&record).into_iter().next();
    first.and_then(|input| vary::changed(&record, &input.path, input.si)).unwrap_or(record)
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
            for row in table.rows_mut() {
                row.iter_mut().zip_eq(&factors).for_each(|(x, factor)| *x *= factor);
            }
        }
        Value::Text(_) | Value::Flag(_) | Value::Count(_) | Value::Reference { .. } | Value::Absent => {}
    }
}

/// All that was met, for the one who judges it.
fn report(met: &Met, draws: &Draws<'_>) -> String {
    let sum = |at: usize| met.counts.values().map(|counts| counts[at]).sum::<usize>();
    let mut text = format!(
        "{} draws of each case: {} drawn, {} answered, {} refused, {} faults\n",
        draws.count,
        sum(0),
        sum(1),
        sum(2),
        met.faults.len()
    );
    for (id, [drawn, answered, refused]) in &met.counts {
        writeln!(text, "{id}: {drawn} drawn, {answered} answered, {refused} refused")
            .expect("a String takes all that is written");
    }
    let verdicts = verdicts(draws.refusals.unwrap_or_default());
    for (template, (count, first)) in &met.refusals {
        let verdict = verdicts.get(template).map_or("not judged", String::as_str);
        writeln!(text, "| `{template}` | *{verdict}* | {count} | {first}")
            .expect("a String takes all that is written");
    }
    for line in met.faults.iter().chain(&met.slow) {
        writeln!(text, "{line}").expect("a String takes all that is written");
    }
    text
}
