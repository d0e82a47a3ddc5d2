//! Extremes over a time: over a longer time the largest is never less large.

use std::collections::BTreeSet;

use dalembert_core::{AnswerValue, Entry, Number, Record, Solution, Stop, vary};

use crate::{problems::cases_of, some};

/// Inputs that say over what time a motion is examined, or when: those of the problem itself. A duration within a
/// part of it, such as that of a blow or a pulse, is another problem.
const TIMES: [&str; 3] = ["duration", "instant", "time"];
const FACTORS: [f64; 4] = [1.0, 1.3, 2.7, 10.0];

#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    Most,
    Least,
    First,
}

/// Kind of extreme that an answer names itself.
fn side(name: &str, label: &str) -> Option<Side> {
    let said = format!("{name} {label}").to_lowercase();
    let says = |words: &[&str]| words.iter().any(|word| said.contains(word));
    if says(&["first"]) {
        Some(Side::First)
    } else if says(&["largest", "highest", "maximum", "friction needed"]) {
        Some(Side::Most)
    } else if says(&["least", "lowest", "minimum"]) {
        Some(Side::Least)
    } else {
        None
    }
}

fn extremes(solution: &Solution) -> Vec<(String, Side, f64)> {
    let answers = solution.answers.iter().filter_map(|answer| {
        let AnswerValue::Number(Number::Scalar(si), _) = answer.value else { return None };
        let name = answer.name.to_string();
        let side = side(&name, answer.label)?;
        Some((name, side, si))
    });
    answers.collect()
}

fn solved(entry: &Entry, record: &Record) -> Option<Solution> {
    entry.solve(record, &Stop::new()).ok()
}

/// Solves every case over longer times: a maximum grows no smaller, a minimum no larger, and the first moment stays.
/// Returns the ids of the analyses with such an answer.
pub fn a_longer_time_has_no_smaller_maximum(entries: &[&'static Entry]) -> BTreeSet<&'static str> {
    some(entries);
    let mut covered = BTreeSet::new();
    let mut wrong = Vec::new();
    for entry in entries {
        for case in cases_of(entry) {
            let Ok(record) = case.record(entry) else { continue };
            for input in vary::inputs(&record) {
                if !TIMES.contains(&input.path.as_str()) || input.si <= 0.0 {
                    continue;
                }
                let longer = FACTORS.iter().filter_map(|factor| {
                    let record = vary::changed(&record, &input.path, factor * input.si)?;
                    Some((*factor, extremes(&solved(entry, &record)?)))
                });
                let longer: Vec<_> = longer.collect();
                for pair in longer.windows(2) {
                    let [(_, short), (factor, long)] = pair else { unreachable!("windows of two") };
                    for (name, side, before) in short {
                        // A largest displacement may be on either side.
                        let Some((_, _, after)) = long.iter().find(|(other, ..)| other == name) else {
                            continue;
                        };
                        let rounding = 1e-9 * before.abs().max(after.abs());
                        let holds = match side {
                            Side::Most => after.abs() >= before.abs() - rounding,
                            Side::Least => *after <= before + rounding,
                            Side::First => (after - before).abs() <= rounding,
                        };
                        covered.insert(entry.about.id);
                        if !holds {
                            wrong.push(format!(
                                "{}, {}: {name} is {before:e}, and {after:e} at {factor} times its {}",
                                entry.about.id, case.name, input.path
                            ));
                        }
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    covered
}
