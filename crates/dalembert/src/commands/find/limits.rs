//! Intervals of an input with which an answer is within a limit.

use std::process::ExitCode;

use dalembert_core::{Locale, Stop, Text, study::answer as named_answer};
use dalembert_study::ranges::{self, FoundRanges, LimitedBy, PermittedInterval, RangeQuestion, Relation};
use dalembert_units as units;
use serde_json::{Value as Json, json};

use super::{
    Asked, proof,
    reading::{input_of, range_of, value_of},
};
use crate::{
    commands::solve,
    console::{Console, print, print_json},
    failure::Failure,
    problem::{self, ProblemSource},
    solving,
};

/// Version of the schema of the JSON.
const FORMAT: u32 = 1;

/// Prints the permitted intervals of an input.
pub(super) fn run(asked: &Asked<'_>, console: &Console) -> Result<ExitCode, Failure> {
    let find = asked.arguments;
    let changes = asked.changes();
    let source = ProblemSource { case: asked.case, changes: &changes, ..ProblemSource::named(&find.problem) };
    let problem = problem::read(&source, console)?;
    let input = input_of(asked, &problem.record)?;
    let range = range_of(asked, &input)?;
    let solution = solve::outcome(&problem)?.map_err(Failure::Refused)?;
    let named = |why: Text| {
        let sign = if asked.relation == Relation::AtMost { "≤" } else { "≥" };
        let text = format!("{} {sign} {}", asked.answer, asked.value);
        Failure::input(Text::new("{text}: {why}").with("text", text.trim()).with_text("why", why))
    };
    let answer = named_answer(&solution, "", asked.answer).map_err(|error| named(error.why))?;
    let wanted = value_of(&answer, asked.value).map_err(named)?;
    let question =
        RangeQuestion { input: asked.input, range, answer: &answer, relation: asked.relation, wanted };
    let stop = Stop::new();
    let found =
        solving::guarded(problem.entry, || ranges::find((problem.entry, &problem.record), question, &stop))?
            .map_err(solving::failure)?;
    let mut locale = console.locale.at(problem.entry.about.id);
    locale.style.digits = find.digits.unwrap_or(locale.style.digits);
    if find.json {
        let mut shown = to_json(&found, &question, &locale);
        shown["analysis"] = problem.entry.about.id.into();
        print_json(&shown)?;
    } else {
        for line in lines(&found, &question, &locale) {
            print(&format!("{}\n", console.plain(&line)))?;
        }
    }
    Ok(if found.permitted().is_empty() { ExitCode::from(1) } else { ExitCode::SUCCESS })
}

/// Lines of the output: the question, each interval with its limits, and the ground.
fn lines(found: &FoundRanges, question: &RangeQuestion<'_>, locale: &Locale) -> Vec<String> {
    let input = &found.input;
    let style = locale.style;
    let of_input = |si: f64| units::write_quantity(si, &input.unit, style);
    let of_answer = |si: f64| units::write_quantity(si, &question.answer.unit, style);
    let mut texts = vec![
        Text::new("{unknown} for {answer} {relation} {value}, from {from} to {to}:")
            .with_text("unknown", input.label.clone())
            .with_text("answer", question.answer.title())
            .with("relation", if found.relation == Relation::AtLeast { "≥" } else { "≤" })
            .with("value", of_answer(question.wanted))
            .with("from", of_input(question.range[0]))
            .with("to", of_input(question.range[1])),
    ];
    let covered = |text: Text| match found.covered {
        Some([least, most]) => text
            .with("least", of_answer(least.1))
            .with("at_least", of_input(least.0))
            .with("most", of_answer(most.1))
            .with("at_most", of_input(most.0)),
        None => text,
    };
    if found.is_constant {
        texts.push(Text::from("the answer does not depend on this input"));
    }
    if found.is_no_constraint() {
        texts.push(covered(Text::new(
            "not a constraint: every value of the range meets it; the answer lies between {least} (at {at_least}) and {most} (at {at_most})",
        )));
    } else if found.is_impossible() && found.covered.is_some() {
        texts.push(covered(Text::new(
            "impossible: no value of the range meets it; the answer lies between {least} (at {at_least}) and {most} (at {at_most})",
        )));
    } else if found.is_impossible() {
        texts.push(Text::from("impossible: there is no answer in the whole range"));
    } else if found.permitted().is_empty() {
        texts.push(Text::from(
            "no value of the range is known to meet it; values that may are in what is undecided",
        ));
    }
    let mut lines: Vec<String> = texts.iter().map(|text| text.render(locale)).collect();
    if !found.is_no_constraint() {
        lines.extend(found.permitted().iter().map(|one| {
            let text = Text::new("{from} to {to} ({lower}; {upper})")
                .with("from", of_input(one.ends[0]))
                .with("to", of_input(one.ends[1]))
                .with_text("lower", limit(&one.limited_by[0]))
                .with_text("upper", limit(&one.limited_by[1]));
            format!("  {}", text.render(locale))
        }));
    }
    lines.extend(proof::lines(found, locale));
    lines
}

/// Limit of an interval in words.
fn limit(limit: &LimitedBy) -> Text {
    match limit {
        LimitedBy::Equality => "limit reached".into(),
        LimitedBy::Range => "end of the range".into(),
        LimitedBy::NoAnswer(Some(why)) => {
            Text::new("beyond it no answer: {why}").with_text("why", why.clone())
        }
        LimitedBy::NoAnswer(None) => "beyond it no answer".into(),
        LimitedBy::Undecided => "beyond it undecided".into(),
    }
}

fn to_json(found: &FoundRanges, question: &RangeQuestion<'_>, locale: &Locale) -> Json {
    let (unit, own) = (&found.input.unit, &question.answer.unit);
    let name = |limit: &LimitedBy| match limit {
        LimitedBy::Equality => "equality",
        LimitedBy::Range => "range",
        LimitedBy::NoAnswer(_) => "no-answer",
        LimitedBy::Undecided => "undecided",
    };
    let interval = |one: &PermittedInterval| {
        let [from, to] = one.ends.map(|si| unit.value(si));
        json!({ "from": from, "to": to, "limited_by": one.limited_by.each_ref().map(name) })
    };
    let verdict = match () {
        () if found.is_no_constraint() => "not-a-constraint",
        () if found.is_impossible() => "impossible",
        () if found.permitted().is_empty() => "undecided",
        () => "limits",
    };
    json!({
        "format": FORMAT,
        "input": found.input.path,
        "unit": unit.ascii(),
        "range": question.range.map(|si| unit.value(si)),
        "answer": question.answer.name.to_string(),
        "relation": if found.relation == Relation::AtLeast { ">=" } else { "<=" },
        "value": own.value(question.wanted),
        "answer_unit": own.ascii(),
        "verdict": verdict,
        "intervals": found.permitted().iter().map(interval).collect::<Vec<_>>(),
        "covered": found.covered.map(|ends| ends.map(|(_, si)| own.value(si))),
        "proof": proof::json(found, locale),
    })
}
