//! Texts and options of a page in the inputs of the problem.

use std::f64::consts::TAU;

use dalembert_core::{Answer, Draft, FieldError, Shape, Text, Value, draft};
use dalembert_units::Style;

use super::line::{Choice, FieldLine, LineKind, READING_UNITS, WEIGHT_UNITS};
use crate::problem::Problem;

/// The list of trial runs.
pub(super) const RUNS: &str = "measured.influence.runs.runs";
/// The names under which units of answers are chosen: every answer with that word follows.
const SHOWN_READINGS: &str = "vibration";
const SHOWN_WEIGHTS: &str = "mass";

/// The text of a line as it would be taken: the texts of inputs, by their paths, or a title.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum TypedLine {
    /// The title of the problem.
    Title(String),
    /// Texts of inputs.
    Inputs(Draft),
}

/// The text of an input; empty where it is not there.
pub(super) fn text_at<'p>(problem: &'p Problem, path: &str) -> &'p str {
    match problem.inputs.form.draft.at(&problem.entry().shape(), path) {
        Ok((Draft::Leaf(text), _)) => text.trim(),
        _ => "",
    }
}

/// Number of rows of a list.
pub(super) fn rows(problem: &Problem, path: &str) -> usize {
    rows_in(&problem.inputs.form.draft, &problem.entry().shape(), path)
}

fn rows_in(draft: &Draft, shape: &Shape, path: &str) -> usize {
    match draft.at(shape, path) {
        Ok((Draft::Rows(rows), _)) => rows.len(),
        _ => 0,
    }
}

/// The chosen alternative of a one-of.
pub(super) fn chosen(problem: &Problem, path: &str) -> Option<usize> {
    match problem.inputs.form.draft.at(&problem.entry().shape(), path) {
        Ok((Draft::OneOf(at, _), _)) => Some(*at),
        _ => None,
    }
}

/// An input as a number in SI.
pub(super) fn si_at(problem: &Problem, path: &str) -> Option<f64> {
    si_in(&problem.inputs.form.draft, &problem.entry().shape(), path)
}

fn si_in(draft: &Draft, shape: &Shape, path: &str) -> Option<f64> {
    let (place, shape) = draft.at(shape, path).ok()?;
    let Draft::Leaf(text) = place else { return None };
    match draft::read_leaf(text, &shape.present(), path).ok()? {
        Value::Quantity(quantity) => Some(quantity.si),
        _ => None,
    }
}

/// An answer for the inputs as they are.
pub(super) fn answer<'p>(problem: &'p Problem, name: &str) -> Option<&'p Answer> {
    let solution = problem.found.solution.as_ref().filter(|_| !problem.is_stale())?;
    solution.answers.iter().find(|answer| answer.name.is(name))
}

/// Number of correction planes.
pub(super) fn planes(problem: &Problem) -> Option<usize> {
    text_at(problem, "rotor.planes").parse().ok()
}

/// Number of sensors: that of the initial run, once it is said.
pub(super) fn sensors(problem: &Problem) -> Option<usize> {
    let is_said =
        rows(problem, "view.sensors") > 0 || !text_at(problem, "measured.first[1].amplitude").is_empty();
    is_said.then(|| rows(problem, "measured.first"))
}

/// Number of trial runs: one for each plane, and all that are there; none where the influence is known.
pub(super) fn trials(problem: &Problem) -> usize {
    match chosen(problem, "measured.influence") {
        Some(1) => 0,
        _ => planes(problem).unwrap_or(1).max(rows(problem, RUNS)),
    }
}

/// The unit of the readings: the one that was chosen, or that of the first reading.
pub(super) fn reading_unit(problem: &Problem) -> Option<String> {
    let chosen = shown(problem, SHOWN_READINGS);
    chosen.or_else(|| {
        let text = text_at(problem, "measured.first[1].amplitude");
        let unit = text.trim_start_matches(|c: char| !c.is_alphabetic() && c != 'µ').trim();
        (!text.is_empty()).then(|| if unit.is_empty() { "1".to_owned() } else { unit.to_owned() })
    })
}

/// The unit of the weights.
pub(super) fn weight_unit(problem: &Problem) -> String {
    shown(problem, SHOWN_WEIGHTS).unwrap_or_else(|| "g".to_owned())
}

fn shown(problem: &Problem, name: &str) -> Option<String> {
    let found = problem.document.show.iter().find(|(known, _)| known == name);
    found.map(|(_, unit)| unit.clone())
}

fn show(problem: &mut Problem, name: &str, unit: &str) {
    problem.document.show.retain(|(known, _)| known != name);
    problem.document.show.push((name.to_owned(), unit.to_owned()));
    problem.document.show_changed = true;
}

/// The place of the option of a line that is chosen.
pub(crate) fn option(problem: &Problem, choice: Choice) -> Option<usize> {
    match choice {
        Choice::Planes => planes(problem)?.checked_sub(1),
        Choice::Sensors => sensors(problem)?.checked_sub(1),
        Choice::ReadingUnit => {
            let unit = reading_unit(problem)?;
            READING_UNITS.iter().position(|known| *known == unit)
        }
        Choice::WeightUnit => WEIGHT_UNITS.iter().position(|known| *known == weight_unit(problem)),
        Choice::OneOf(path) => chosen(problem, path),
    }
}

/// True if a line is answered.
pub(crate) fn is_answered(problem: &Problem, line: &FieldLine) -> bool {
    match &line.kind {
        LineKind::Title => !problem.document.title.is_empty(),
        LineKind::Choice(choice, _) => option(problem, *choice).is_some(),
        LineKind::Value(path, _) => !text_at(problem, path).is_empty(),
        LineKind::Pair(size, angle, _) => {
            !text_at(problem, size).is_empty() && !text_at(problem, angle).is_empty()
        }
        LineKind::Go(_) => true,
    }
}

/// The text of a line as a user reads and types it.
pub(crate) fn written(problem: &Problem, line: &FieldLine, style: Style) -> String {
    let text = |path: &str| in_style(text_at(problem, path), style);
    match &line.kind {
        LineKind::Title => problem.document.title.clone(),
        LineKind::Value(path, _) => text(path),
        LineKind::Pair(size, angle, _) if is_answered(problem, line) => {
            format!("{} @ {}", text(size), text(angle))
        }
        _ => String::new(),
    }
}

/// A text of an input in the decimal mark and the signs of a user.
pub(crate) fn in_style(text: &str, style: Style) -> String {
    let text = if style.ascii { text.to_owned() } else { text.replace(" deg", "°").replace("um", "µm") };
    style.decimal.written(&text)
}

/// Chooses an option; false where there is none such.
pub(crate) fn choose(problem: &mut Problem, choice: Choice, at: usize) -> bool {
    let shape = problem.entry().shape();
    let mut draft = problem.inputs.form.draft.clone();
    match choice {
        Choice::Planes => {
            set(&mut draft, &shape, "rotor.planes", &(at + 1).to_string());
            resize(&mut draft, &shape, RUNS, |rows| rows.min(at + 1));
            let known = sensors(problem).unwrap_or(0);
            if at > 0 {
                with_sensors(&mut draft, &shape, known.max(at + 1));
            }
        }
        Choice::Sensors => with_sensors(&mut draft, &shape, at + 1),
        Choice::ReadingUnit => {
            let Some(unit) = READING_UNITS.get(at) else { return false };
            show(problem, SHOWN_READINGS, unit);
            return true;
        }
        Choice::WeightUnit => {
            let Some(unit) = WEIGHT_UNITS.get(at) else { return false };
            show(problem, SHOWN_WEIGHTS, unit);
            return true;
        }
        Choice::OneOf(path) => return choose_alternative(problem, path, at),
    }
    let entry = problem.entry();
    problem.inputs.form.replace(entry, draft);
    true
}

/// An alternative of a one-of, with what it had before where it is chosen again.
fn choose_alternative(problem: &mut Problem, path: &str, at: usize) -> bool {
    let entry = problem.entry();
    let shape = entry.shape();
    let mut draft = problem.inputs.form.draft.clone();
    let group = path.rsplit_once('.').map_or("", |(group, _)| group);
    if draft.at(&shape, path).is_err() && !group.is_empty() {
        // A group that is left out is put in with its defaults.
        let Ok((place, inner)) = draft.at_mut(&shape, group) else { return false };
        *place = Draft::blank(&inner.present());
        problem.inputs.form.replace(entry, draft);
    }
    if chosen(problem, path) != Some(at) {
        problem.inputs.form.choose(path, at);
    }
    chosen(problem, path) == Some(at)
}

/// The inputs with so many sensors, in every run that there is.
fn with_sensors(draft: &mut Draft, shape: &Shape, sensors: usize) {
    let (runs, checks) = (rows_in(draft, shape, RUNS), rows_in(draft, shape, "measured.checks"));
    resize(draft, shape, "measured.first", |_| sensors);
    resize(draft, shape, "view.sensors", |_| sensors);
    for n in 1..=sensors {
        let path = format!("view.sensors[{n}].angle");
        if matches!(draft.at(shape, &path), Ok((Draft::Leaf(text), _)) if text.is_empty()) {
            set(draft, shape, &path, "0 deg");
        }
    }
    for run in 1..=runs {
        resize(draft, shape, &format!("{RUNS}[{run}].readings"), |_| sensors);
    }
    for run in 1..=checks {
        resize(draft, shape, &format!("measured.checks[{run}].readings"), |_| sensors);
    }
}

fn resize(draft: &mut Draft, shape: &Shape, path: &str, to: impl Fn(usize) -> usize) {
    if let Ok((Draft::Rows(rows), list)) = draft.at_mut(shape, path)
        && let Shape::Rows { item, .. } = list.present()
    {
        rows.resize(to(rows.len()), Draft::blank(item()));
    }
}

/// Writes a text where there may be one.
fn set(draft: &mut Draft, shape: &Shape, path: &str, text: &str) {
    // A path that is no input of the problem cannot come from a line.
    let _ = draft.set(shape, path, text);
}

/// Takes what was typed on a line.
pub(crate) fn take(problem: &mut Problem, typed: TypedLine) {
    match typed {
        TypedLine::Title(title) => problem.document.title = title,
        TypedLine::Inputs(draft) => {
            let entry = problem.entry();
            problem.inputs.form.replace(entry, draft);
        }
    }
}

impl TypedLine {
    /// The meaning of a text on a line.
    ///
    /// # Errors
    /// What is wrong with the text, as its input says it.
    pub(crate) fn read(problem: &Problem, line: &FieldLine, text: &str, style: Style) -> Result<Self, Text> {
        let point = |text: &str| style.decimal.to_point(text);
        match &line.kind {
            LineKind::Title => Ok(Self::Title(text.trim().to_owned())),
            LineKind::Value(_, _) if text.trim().is_empty() && line.required => {
                Err("a value is needed here".into())
            }
            LineKind::Value(path, unit) => inputs(problem, &[(path, in_unit(&point(text), unit))]),
            LineKind::Pair(size, angle, unit) => {
                let Some((first, second)) = split(text) else {
                    return Err("two values are needed, such as 4.2 @ 120".into());
                };
                let pair = [(size, in_unit(&point(first), unit)), (angle, in_unit(&point(second), "deg"))];
                let read = inputs(problem, &pair)?;
                let is_beyond = |si: f64| (si / TAU).abs() - 1e-9 > 1.0;
                let shape = problem.entry().shape();
                match &read {
                    Self::Inputs(draft) if si_in(draft, &shape, angle).is_some_and(is_beyond) => {
                        Err("an angle from 0 to 360° is needed behind the @".into())
                    }
                    _ => Ok(read),
                }
            }
            LineKind::Choice(..) | LineKind::Go(_) => Err("".into()),
        }
    }
}

/// The inputs with these texts. A text is refused where an input is wrong with it that was not before.
fn inputs(problem: &Problem, texts: &[(&String, String)]) -> Result<TypedLine, Text> {
    let shape = problem.entry().shape();
    let mut draft = problem.inputs.form.draft.clone();
    for (path, text) in texts {
        begin_run(problem, &mut draft, &shape, path);
        draft.set(&shape, path, text).map_err(|error| error.why)?;
        if text.is_empty() && *path == "positions.count" {
            set(&mut draft, &shape, "positions", "");
            leave_out(&mut draft, &shape, "positions");
        }
    }
    let wrong = |draft: &Draft| -> Vec<FieldError> {
        let errors = draft.read(&shape).err().unwrap_or_default();
        let is_empty = |error: &FieldError| match draft.at(&shape, &error.path) {
            Ok((Draft::Leaf(text), _)) => text.trim().is_empty(),
            Ok((Draft::Absent, _)) => true,
            _ => false,
        };
        errors.into_iter().filter(|error| !is_empty(error)).collect()
    };
    let before = wrong(&problem.inputs.form.draft);
    match wrong(&draft).into_iter().find(|error| !before.contains(error)) {
        Some(error) => Err(error.why),
        None => Ok(TypedLine::Inputs(draft)),
    }
}

fn leave_out(draft: &mut Draft, shape: &Shape, path: &str) {
    if let Ok((place, _)) = draft.at_mut(shape, path) {
        *place = Draft::Absent;
    }
}

/// Makes the row of a run on the way to an input in it, with as many readings as there are sensors.
fn begin_run(problem: &Problem, draft: &mut Draft, shape: &Shape, path: &str) {
    let row_of = |list: &str| -> Option<usize> {
        let rest = path.strip_prefix(list)?.strip_prefix('[')?;
        rest.split(']').next()?.parse().ok()
    };
    let sensors = sensors(problem).unwrap_or(1);
    if let Some(run) = row_of(RUNS) {
        let is_first = !matches!(draft.at(shape, RUNS), Ok((Draft::Rows(_), _)));
        let row = format!("{RUNS}[{run}]");
        if draft.at(shape, &row).is_err() {
            set(draft, shape, &format!("{row}.plane"), &run.to_string());
            resize(draft, shape, &format!("{row}.readings"), |_| sensors);
        }
        if is_first {
            set(draft, shape, "measured.influence.runs.after", "taken-off");
        }
    }
    if let Some(run) = row_of("measured.checks") {
        let row = format!("measured.checks[{run}]");
        if draft.at(shape, &row).is_err() {
            set(draft, shape, &format!("{row}.readings[1].amplitude"), "");
            resize(draft, shape, &format!("{row}.readings"), |_| sensors);
        }
    }
}

/// A number alone with its unit; any other text as it is.
fn in_unit(text: &str, unit: &str) -> String {
    let text = text.trim();
    let is_alone =
        !text.is_empty() && !text.contains(|c: char| c.is_alphabetic() || matches!(c, '°' | '%' | 'µ'));
    if is_alone && !matches!(unit, "" | "1") { format!("{text} {unit}") } else { text.to_owned() }
}

/// The two values of a text: on both sides of `@`, `∠` or `;`, or of the space before the second number.
fn split(text: &str) -> Option<(&str, &str)> {
    let text = text.trim();
    let (first, second) = match text.split_once(['@', '∠', ';']) {
        Some(parts) => parts,
        None => {
            let begins =
                |word: &str| word.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '−'));
            let second = text.split_whitespace().skip(1).filter(|word| begins(word)).last()?;
            text.split_at(text.rfind(second)?)
        }
    };
    let (first, second) = (first.trim(), second.trim());
    (!first.is_empty() && !second.is_empty()).then_some((first, second))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reading_is_two_values_however_it_is_written() {
        for (text, parts) in [
            ("4.2 @ 120", Some(("4.2", "120"))),
            ("4,2@120", Some(("4,2", "120"))),
            ("4.2 120", Some(("4.2", "120"))),
            ("4.2 mm/s 120 deg", Some(("4.2 mm/s", "120 deg"))),
            ("4.2 ∠ -30°", Some(("4.2", "-30°"))),
            ("4.2 -30", Some(("4.2", "-30"))),
            ("4.2", None),
            ("4.2 @", None),
            ("", None),
        ] {
            assert_eq!(split(text), parts, "{text}");
        }
    }

    #[test]
    fn a_number_alone_takes_the_unit_of_its_line() {
        for (text, unit, taken) in [
            ("4.2", "mm/s", "4.2 mm/s"),
            ("4.2 mil", "mm/s", "4.2 mil"),
            ("30", "deg", "30 deg"),
            ("30°", "deg", "30°"),
            ("7", "1", "7"),
            ("", "g", ""),
        ] {
            assert_eq!(in_unit(text, unit), taken, "{text}");
        }
    }
}
