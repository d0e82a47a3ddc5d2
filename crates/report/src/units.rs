//! The units that answers are shown in.

use dalembert_core::{Answer, Display, Solution, Text, nearest, unit_hint};
use dalembert_units::{self as units, Kind, Unit};

/// Answers that a name means: one of them, a family, or those that a word is about.
struct Meant {
    /// Their places in the solution.
    places: Vec<usize>,
    /// Rank of the name, from 0: all that a word is about, all of a name, all of a name and a place, one answer.
    closeness: usize,
}

/// Shows answers in other units, and with other digits where they are asked for: pairs of a name and, for example,
/// `mm; 6 digits`. The more closely a name means an answer, the later it is taken: `amplitude[2]` after `amplitude`, and
/// that after `length`.
///
/// # Errors
/// As for [`show_answer_in`]; the others are shown nevertheless, and the first error is returned.
pub fn show_answers_in(solution: &mut Solution, show: &[(String, String)]) -> Result<(), Text> {
    let mut show: Vec<&(String, String)> = show.iter().collect();
    show.sort_by_key(|(name, _)| meant(solution, name).closeness);
    let mut result = Ok(());
    for (name, unit) in show {
        result = result.and(show_answer_in(solution, name, unit));
    }
    result
}

/// Shows an answer, and the step that found it, in another unit, and with other digits where they are asked for, as in
/// `mm; 6 digits`. The numbers stay what they are. In a system of units the step keeps its unit, so that numbers can be
/// put into later formulas as they are.
///
/// A name without its place means every answer of that name: `amplitude` all of `amplitude[1]`, `amplitude[2]`. Where
/// there is none, it means every answer with that word in its name or label, or of that kind of quantity, which the unit
/// measures: `force`, `length`, `angular velocity`.
///
/// # Errors
/// There is no such answer, the unit or the number of digits cannot be read, or the unit measures something else.
pub fn show_answer_in(solution: &mut Solution, name: &str, unit: &str) -> Result<(), Text> {
    let meant = meant(solution, name);
    if meant.places.is_empty() {
        let known: Vec<String> = solution.answers.iter().map(|answer| answer.name.to_string()).collect();
        let why = match nearest(name, known.iter().map(String::as_str)) {
            Some(near) => Text::new("no answer `{name}`; did you mean `{near}`?").with("near", near),
            None => Text::new("no answer `{name}`; use one of {known}").with("known", known.join(", ")),
        };
        return Err(why.with("name", name));
    }
    let display = Display::read(unit)?;
    let wanted = match display.unit.as_str() {
        "" => None,
        unit => Some(units::unit(unit).map_err(|err| Text::new(err.to_string()))?),
    };
    let answers = &solution.answers;
    let fits = |at: &usize| wanted.as_ref().is_none_or(|wanted| wanted.dim.agrees(answers[*at].unit.dim));
    let places: Vec<usize> = match meant.closeness {
        0 => meant.places.iter().copied().filter(|at| fits(at)).collect(),
        _ => meant.places.clone(),
    };
    if let ([], Some(wanted)) = (&places[..], &wanted) {
        return Err(unfit_all(answers, &meant.places, name, wanted));
    }
    if let (Some(unfit), Some(wanted)) = (places.iter().find(|at| !fits(at)), &wanted) {
        return Err(unfit_one(&answers[*unfit], wanted));
    }
    for at in places {
        solution.answers[at].digits = display.digits;
        if let Some(wanted) = &wanted {
            solution.show_answer_in(at, wanted);
        }
    }
    Ok(())
}

/// The answers that a name means.
fn meant(solution: &Solution, name: &str) -> Meant {
    let places = |is: &dyn Fn(&Answer) -> bool| -> Vec<usize> {
        (0..solution.answers.len()).filter(|at| is(&solution.answers[*at])).collect()
    };
    let one = places(&|answer| answer.name.is(name));
    if !one.is_empty() {
        return Meant { places: one, closeness: usize::MAX };
    }
    let first = format!("{name}[");
    let family = places(&|answer| answer.name.to_string().starts_with(&first));
    if !family.is_empty() {
        return Meant { places: family, closeness: 1 + name.matches('[').count() };
    }
    let wanted = words(name);
    let has = |text: &str| !wanted.is_empty() && words(text).windows(wanted.len()).any(|some| some == wanted);
    let is_kind = |unit: &Unit| words(Kind::of(unit).name()).get(1..).is_some_and(|kind| kind == wanted);
    let about = |answer: &Answer| has(answer.name.base) || has(answer.label) || is_kind(&answer.unit);
    Meant { places: places(&about), closeness: 0 }
}

/// The words of a name or a label, in lower case.
fn words(text: &str) -> Vec<String> {
    let words = text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect()
}

fn unfit_one(answer: &Answer, wanted: &Unit) -> Text {
    let unit = wanted.ascii();
    let why = match unit_hint(&unit, answer.unit.dim) {
        Some(hint) => Text::new("{name} cannot be shown in {unit}; {hint}").with_text("hint", hint),
        None => {
            Text::new("{name} cannot be shown in {unit}; write a unit like {own}").with("own", own(answer))
        }
    };
    why.with("name", answer.name).with("unit", unit)
}

fn unfit_all(answers: &[Answer], places: &[usize], name: &str, wanted: &Unit) -> Text {
    let found = places.iter().map(|at| format!("{} ({})", answers[*at].name, own(&answers[*at])));
    Text::new("none of the answers of `{name}` can be shown in {unit}: {found}")
        .with("name", name)
        .with("unit", wanted.ascii())
        .with("found", found.collect::<Vec<_>>().join(", "))
}

/// The unit of an answer as it is typed; `1` for a pure number.
fn own(answer: &Answer) -> String {
    match answer.unit.ascii() {
        unit if unit.is_empty() => "1".to_owned(),
        unit => unit,
    }
}
