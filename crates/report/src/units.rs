//! The units that answers are shown in.

use dalembert_core::{AnswerValue, Display, Solution, Text, nearest, trace::Op, unit_hint};
use dalembert_units as units;

/// Shows an answer, and the step that found it, in another unit, and with other digits where they are asked for, as in
/// `mm; 6 digits`. The numbers stay what they are.
///
/// # Errors
/// There is no such answer, the unit or the number of digits cannot be read, or the unit measures something else.
pub fn show_answer_in(solution: &mut Solution, name: &str, unit: &str) -> Result<(), Text> {
    let Some(at) = solution.answers.iter().position(|answer| answer.name.is(name)) else {
        let known: Vec<String> = solution.answers.iter().map(|answer| answer.name.to_string()).collect();
        let why = match nearest(name, known.iter().map(String::as_str)) {
            Some(near) => Text::new("no answer `{name}`; did you mean `{near}`?").with("near", near),
            None => Text::new("no answer `{name}`; use one of {known}").with("known", known.join(", ")),
        };
        return Err(why.with("name", name));
    };
    let display = Display::read(unit)?;
    solution.answers[at].digits = display.digits;
    if display.unit.is_empty() {
        return Ok(());
    }
    let unit = display.unit.as_str();
    let wanted = units::unit(unit).map_err(|err| Text::new(err.to_string()))?;
    let answer = &mut solution.answers[at];
    if !wanted.dim.agrees(answer.unit.dim) {
        let own = match answer.unit.ascii() {
            unit if unit.is_empty() => "1".to_owned(),
            unit => unit,
        };
        let why = match unit_hint(unit, answer.unit.dim) {
            Some(hint) => Text::new("{name} cannot be shown in {unit}; {hint}").with_text("hint", hint),
            None => Text::new("{name} cannot be shown in {unit}; write a unit like {own}").with("own", own),
        };
        return Err(why.with("name", name).with("unit", unit));
    }
    answer.unit = wanted.clone();
    if let AnswerValue::Number(_, id) = answer.value
        && let Op::Step(step) = solution.trace.node(id).op
    {
        solution.steps[step].unit = wanted;
    }
    Ok(())
}
