//! Words for mistakes.

use std::f64::consts::FRAC_1_SQRT_2;

use dalembert_units::Dim;

use super::{Change, Mistake, Place};
use crate::{
    Answer, AnswerValue, Locale, Solution, Text, printer,
    reevaluate::Edit,
    trace::{Number, Op, TraceNode},
};

/// Longer parts of formulas are not written out.
const LONGEST_PART: usize = 24;
/// Longer reasons of steps are not repeated.
const LONGEST_REASON: usize = 60;

/// Description of a mistake, without a number of the right solution.
pub(super) fn mistake(mistake: &Mistake, solution: &Solution) -> Text {
    let label = |name: &str| match solution.answer(name) {
        Some(answer) => answer.title(),
        None => Text::verbatim(name),
    };
    match (&mistake.place, &mistake.change) {
        (_, Change::Follows(names)) => {
            let all = names
                .iter()
                .map(|name| label(name))
                .reduce(|all, next| Text::new("{all}, {next}").with_text("all", all).with_text("next", next));
            Text::new("consistent with your earlier answer to {answers} (error carried forward)")
                .with_text("answers", all.unwrap_or_default())
        }
        (_, Change::Printed(why)) => {
            Text::new("the published value, which is disputed: {why}").with_text("why", why.clone())
        }
        (_, Change::OtherAnswer(name)) => {
            Text::new("this is the value of another answer: {answer}").with_text("answer", label(name))
        }
        (_, Change::OtherStep(symbol)) => Text::new("this is the value of {symbol}, an intermediate result")
            .with("symbol", printer::symbol(symbol)),
        (_, Change::Given(_, input)) => {
            Text::new("this is a given value: {input}").with_text("input", input.clone())
        }
        (_, Change::Branch) => {
            Text::new("one limit or one part of the set only; other values are permitted too")
        }
        (Place::Answer, change) => of_answer(change),
        (Place::Input(_, input), Change::Interchanged(_, other)) => {
            Text::new("{first} and {second} interchanged")
                .with_text("first", input.clone())
                .with_text("second", other.clone())
        }
        (Place::Input(_, input), change) => Text::new("{input}: {change}")
            .with_text("input", input.clone())
            .with_text("change", of_input(change)),
        (Place::Step(at, symbol), change) => {
            let why = solution.steps.get(*at).map(|step| step.why.clone());
            let short = why.filter(|why| !why.is_empty() && why.english().chars().count() <= LONGEST_REASON);
            let text = match short {
                Some(why) => Text::new("computing {symbol} ({why}): {change}").with_text("why", why),
                None => Text::new("computing {symbol}: {change}"),
            };
            let change = as_amplitude(mistake, *at, solution)
                .unwrap_or_else(|| of_step(change, part(mistake, solution).as_deref()));
            text.with("symbol", printer::symbol(symbol)).with_text("change", change)
        }
        (Place::Problem, change) => of_step(change, None),
    }
}

/// The value that is read in place of an amplitude, where a step is one that is asked for.
fn as_amplitude(mistake: &Mistake, at: usize, solution: &Solution) -> Option<Text> {
    let Change::Times(factor, _) = &mistake.change else { return None };
    let taken = if *factor == 2.0 {
        Text::new("peak-to-peak value in place of the amplitude")
    } else if *factor == FRAC_1_SQRT_2 {
        Text::new("rms value in place of the amplitude")
    } else {
        return None;
    };
    let result = solution.steps.get(at)?.result;
    if mistake.edit.as_ref().is_none_or(|edit| edit.at != result) {
        return None;
    }
    let is_amplitude = |answer: &Answer| {
        let base = answer.name.base;
        let is_it = matches!(answer.value, AnswerValue::Number(_, id) if id == result);
        is_it && answer.dim() != Dim::NONE && (base == "amplitude" || base.ends_with("_amplitude"))
    };
    solution.answers.iter().any(is_amplitude).then_some(taken)
}

fn of_answer(change: &Change) -> Text {
    match change {
        Change::Unit { taken, is } => {
            Text::new("the number is in {taken}, not {is}").with("taken", taken).with("is", is)
        }
        Change::Squared => Text::new("squared value: a square root was omitted"),
        Change::Rooted => Text::new("square root of the value: a square was omitted"),
        Change::Inverted => Text::new("reciprocal of the answer"),
        other => common(other),
    }
}

fn of_input(change: &Change) -> Text {
    match change {
        Change::Unit { taken, is } => Text::new("{is} used as {taken}").with("is", is).with("taken", taken),
        Change::Half => {
            Text::new("whole and half confused (diameter and radius, peak-to-peak and amplitude)")
        }
        Change::Gravity(si) => Text::new("{gravity} used").with_quantity("gravity", *si, "m/s^2"),
        Change::Weight => Text::new("mass and weight confused"),
        Change::LeftOut => Text::new("omitted"),
        Change::Count => Text::new("counted one too many or one too few"),
        Change::OtherEnd(whole) => {
            Text::new("measured from the other end of: {length}").with_text("length", whole.clone())
        }
        other => common(other),
    }
}

/// The term, factor or argument that a mistake is about as it is written, where that is short.
fn part(mistake: &Mistake, solution: &Solution) -> Option<String> {
    let written = printer::formula(solution, mistake.of?, &Locale::english());
    (written.chars().count() <= LONGEST_PART).then_some(written)
}

fn of_step(change: &Change, part: Option<&str>) -> Text {
    let about = |with: &'static str, without: &'static str| match part {
        Some(part) => Text::new(with).with("part", part),
        None => Text::new(without),
    };
    match change {
        Change::Common(what) => what.clone(),
        Change::Weight => Text::new("mass and weight confused"),
        Change::TermSign => about("sign error in the term {part}", "sign error in a term"),
        Change::TermLeftOut => about("the term {part} omitted", "a term omitted"),
        Change::TermTwice => about("the term {part} taken twice", "a term taken twice"),
        Change::FactorLeftOut => about("the factor {part} omitted", "a factor omitted"),
        Change::FactorSquared => about("the factor {part} taken twice", "a factor taken twice"),
        Change::FactorInverted => about(
            "the factor {part} on the wrong side of the fraction",
            "a factor on the wrong side of the fraction",
        ),
        Change::Coefficient(right, taken) => Text::new("coefficient {taken} in place of {right}")
            .with_number("taken", fraction(*taken))
            .with_number("right", fraction(*right)),
        Change::AddedDirectly => Text::new("components added as numbers, not as vectors"),
        Change::AddedAsVectors => Text::new("root of the sum of the squares in place of the sum"),
        Change::SeriesForParallel => Text::new("series and parallel connection confused"),
        Change::Exponent(right, 1) if *right > 1 => Text::new("an exponent omitted"),
        Change::Exponent(right, taken) => {
            Text::new("exponent {taken} in place of {right}").with("taken", taken).with("right", right)
        }
        Change::RootLeftOut => Text::new("a square root omitted"),
        Change::Trigonometric(right, taken) => {
            Text::new("{taken} in place of {right}").with("taken", taken).with("right", right)
        }
        Change::DividedForMultiplied => Text::new("division and multiplication interchanged"),
        Change::Degrees => Text::new("an angle in degrees used as radians, or the other way round"),
        Change::Quadrant => Text::new("arctangent taken without regard to the quadrant (off by 180°)"),
        Change::AcuteAngle => Text::new("acute angle taken, without regard to the quadrant"),
        Change::Calculator(true) => Text::new("calculator in degrees with angles in radians"),
        Change::Calculator(false) => Text::new("calculator in radians with angles in degrees"),
        Change::Rounded(digits) => Text::new("rounded to {digits} significant digits").with("digits", digits),
        other => common(other),
    }
}

/// A coefficient as a formula has it: `1/12`.
fn fraction(number: f64) -> String {
    let (sign, size) = (if number < 0.0 { "−" } else { "" }, number.abs());
    let whole = |x: f64| (x - x.round()).abs() < 1e-9 * x;
    let fits = |under: &f64| whole(size * under);
    match [1.0, 2.0, 3.0, 5.0, 10.0].into_iter().chain((4..=200).map(f64::from)).find(fits) {
        Some(1.0) => format!("{sign}{}", size.round()),
        Some(under) => format!("{sign}{}/{under}", (size * under).round()),
        None => format!("{number:.4}"),
    }
}

fn common(change: &Change) -> Text {
    match change {
        Change::Sign => Text::new("sign error"),
        Change::Times(factor, written) if factor.abs() > 1.0 => {
            Text::new("{factor} times too large").with("factor", written)
        }
        Change::Times(_, written) => Text::new("{factor} times too small").with("factor", written),
        Change::PowerOfTen(places) => {
            let factor = format!("10{}", dalembert_units::superscript(i32::from(places.abs())));
            let factor = if places.abs() == 1 { "10".to_owned() } else { factor };
            let large = Text::new("decimal point misplaced ({factor} times too large)");
            let small = Text::new("decimal point misplaced ({factor} times too small)");
            if *places > 0 { large } else { small }.with("factor", factor)
        }
        Change::Squared => Text::new("squared"),
        Change::Rooted => Text::new("square root taken"),
        Change::Inverted => Text::new("inverted"),
        Change::Direction => Text::new("measured from another axis or in the opposite sense"),
        Change::Complement => Text::new("measured from the other end: the complement to 1"),
        Change::OtherAngle => Text::new("the other angle with the same sine or cosine"),
        Change::Digit(right, taken) | Change::Swapped(right, taken) => {
            Text::new("{right} copied as {taken}").with_number("right", right).with_number("taken", taken)
        }
        Change::Alternative(right, taken) => Text::new("{taken} in place of {right}")
            .with_text("taken", taken.clone())
            .with_text("right", right.clone()),
        _ => Text::new("different interpretation"),
    }
}

/// Lines of what was computed and of what is right.
pub(super) fn lines(mistake: &Mistake, solution: &Solution, locale: &Locale) -> Option<[String; 2]> {
    let (Place::Step(at, _), Some(edit)) = (&mistake.place, &mistake.edit) else { return None };
    let step = solution.steps.get(*at)?;
    let right = printer::step(solution, step, locale);
    let (wrong, right) = if edit.at == step.result {
        let taken = mistake.taken?;
        (printer::in_place_of_result(solution, step, Number::Scalar(taken), locale.style), right.result)
    } else {
        let edited = edited(solution, edit);
        (printer::step(&edited, step, locale).formula, right.formula)
    };
    let line = |value: &str| format!("{} = {value}", printer::symbol_in(&step.symbol, locale.style));
    (wrong != right && !wrong.is_empty()).then(|| [line(&wrong), line(&right)])
}

/// The solution with an edit in its trace, for its formulas alone.
fn edited(solution: &Solution, edit: &Edit) -> Solution {
    let mut trace = solution.trace.clone();
    let Some(((last, _), before)) = edit.ops.split_last() else { return solution.clone() };
    for (op, number) in before {
        let node = trace.node(edit.at);
        let is_literal = *op == Op::Literal;
        let number = if is_literal { *number } else { node.number };
        trace.nodes.push(TraceNode { number, op: op.clone(), ..node.clone() });
    }
    trace.nodes[edit.at as usize].op = last.clone();
    Solution { trace, steps: solution.steps.clone(), ..Solution::default() }
}
