//! Ground on which the values of an input are known: the enclosures of formulas, or a scan.

use dalembert_core::{Locale, Record, Stop, Text, study::answer as named_answer};
use dalembert_study::ranges::{self, Basis, FoundRanges, RangeQuestion};
use dalembert_units as units;
use serde_json::{Value as Json, json};

use super::{Asked, reading};
use crate::{
    console::Console,
    failure::Failure,
    problem::{self, ProblemSource},
    solving,
};

/// Digits of the ends of what is not decided: fewer would show both ends as one number.
const DIGITS: u8 = 12;

/// The solutions of an equality by enclosures, in the range that was searched, or else as it is asked for. `None` where the
/// input is no number of the problem as it is.
///
/// # Errors
/// A panic of the analysis.
pub(super) fn of(asked: &Asked<'_>, searched: Option<[f64; 2]>) -> Result<Option<FoundRanges>, Failure> {
    // What was said of the inputs was said when they were read with the unknown.
    let console = Console::of_program(Locale::english());
    let changes = asked.changes();
    let source = ProblemSource {
        case: asked.case,
        changes: &changes,
        ..ProblemSource::named(&asked.arguments.problem)
    };
    let Ok(problem) = problem::read(&source, &console) else { return Ok(None) };
    let Ok(solution) = solving::solve(problem.entry, &problem.record)? else { return Ok(None) };
    let (Ok(answer), Some(range)) =
        (named_answer(&solution, "", asked.answer), searched.or_else(|| range_of(asked, &problem.record)))
    else {
        return Ok(None);
    };
    let Ok(wanted) = reading::value_of(&answer, asked.value) else { return Ok(None) };
    let question =
        RangeQuestion { input: asked.input, range, answer: &answer, relation: asked.relation, wanted };
    let stop = Stop::new();
    let found =
        solving::guarded(problem.entry, || ranges::find((problem.entry, &problem.record), question, &stop))?;
    Ok(found.ok())
}

/// The range that is asked for, or that about the value of the problem, in SI; `None` where it cannot be read.
fn range_of(asked: &Asked<'_>, record: &Record) -> Option<[f64; 2]> {
    reading::input_of(asked, record).and_then(|input| reading::range_of(asked, &input)).ok()
}

/// Sentences about what is proven.
pub(super) fn lines(found: &FoundRanges, locale: &Locale) -> Vec<String> {
    let mut lines = Vec::new();
    match &found.basis {
        Basis::Formulas { points } => {
            let text = Text::new(
                "certified by interval arithmetic for the formulas of this solution; the same formulas were seen at {points} points of the range",
            );
            lines.push(text.with("points", points));
        }
        Basis::Scan { points, why } => {
            let text = Text::new("not certified: {why}; {points} points of the range were examined");
            lines.push(text.with_text("why", why.clone()).with("points", points));
        }
    }
    let undecided = found.undecided();
    let style = units::Style { digits: locale.style.digits.max(DIGITS), ..locale.style };
    let written = |si: f64| units::write_quantity(si, &found.input.unit, style);
    lines.extend(undecided.iter().map(|[from, to]| {
        Text::new("undecided: from {from} to {to}").with("from", written(*from)).with("to", written(*to))
    }));
    if !undecided.is_empty() {
        let style = units::Style { digits: 2, ..locale.style };
        let percent = units::write_number(100.0 * share(found), style);
        lines.push(Text::new("undecided in all: {percent} % of the range").with("percent", percent));
    }
    lines.iter().map(|line| line.render(locale)).collect()
}

/// The undecided share of the range.
fn share(found: &FoundRanges) -> f64 {
    let width = |[from, to]: [f64; 2]| to - from;
    let whole = found.parts.first().zip(found.parts.last()).map_or(1.0, |(first, last)| last.to - first.from);
    found.undecided().into_iter().map(width).fold(0.0, |sum, width| sum + width) / whole
}

/// The same for another program.
pub(super) fn json(found: &FoundRanges, locale: &Locale) -> Json {
    let unit = &found.input.unit;
    let both =
        |all: Vec<[f64; 2]>| all.into_iter().map(|ends| ends.map(|si| unit.value(si))).collect::<Vec<_>>();
    let (points, why) = match &found.basis {
        Basis::Formulas { points } => (points, None),
        Basis::Scan { points, why } => (points, Some(why.render(locale))),
    };
    json!({
        "certified": why.is_none(),
        "points": points,
        "why": why,
        "unit": unit.ascii(),
        "solutions": both(found.solutions()),
        "undecided": both(found.undecided()),
        "undecided_share": share(found),
    })
}
