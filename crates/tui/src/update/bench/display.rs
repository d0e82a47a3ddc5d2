//! The unit and the digits that an answer is shown with.

use dalembert_core::{Display, Text};
use dalembert_report::show_answer_in;
use dalembert_units::{self as units, Kind};

use super::kept;
use crate::{
    bench::Bench,
    keys::{Action, Place},
    model::{Effect, Model},
    tab::Tab,
};

/// The fewest and the most digits of an answer.
const DIGITS: (u8, u8) = (3, 12);

/// Shows the chosen answer in its next unit, or with another number of digits; without a chosen one, chooses the first.
pub(super) fn change(model: &mut Model, action: Action) -> Vec<Effect> {
    let usual = model.locale.style.digits;
    let readonly = model.readonly;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if bench.tab != Tab::Results {
        model.say("the answers are in Results");
        return Vec::new();
    }
    let Some(solution) = bench.found.solution.as_ref().filter(|solution| !solution.answers.is_empty()) else {
        return Vec::new();
    };
    let Some(at) = bench.reading.answer else {
        bench.reading.answer = Some(0);
        let key = |action| model.key(Place::Pane, action);
        let said = Text::new("{keys} select the answer; {unit} unit, {digits} digits; {back} back")
            .with("keys", format!("{} {}", key(Action::Up), key(Action::Down)))
            .with("unit", key(Action::NextDisplayUnit))
            .with("digits", key(Action::NextDigits))
            .with("back", key(Action::Back));
        model.say(said);
        return Vec::new();
    };
    let answer = &solution.answers[at.min(solution.answers.len() - 1)];
    let name = answer.name.to_string();
    let mut display = bench
        .show
        .iter()
        .find(|(known, _)| *known == name)
        .map_or_else(Display::default, |(_, text)| Display::of(text));
    if action == Action::NextDigits {
        let next = match display.digits.unwrap_or(usual) {
            digits if digits >= DIGITS.1 => DIGITS.0,
            digits => digits + 1,
        };
        display.digits = Some(next).filter(|next| *next != usual);
    } else {
        let now = answer.unit.ascii();
        let all: Vec<&str> = Kind::of(&answer.unit)
            .units()
            .iter()
            .copied()
            .filter(|unit| !["1", "dB"].contains(unit))
            .collect();
        let same = |unit: &str| units::unit(unit).is_ok_and(|unit| unit.ascii() == now);
        let at = all.iter().position(|unit| same(unit));
        match all.get(at.map_or(0, |at| (at + 1) % all.len().max(1))) {
            Some(unit) if !same(unit) => (*unit).clone_into(&mut display.unit),
            _ => {
                model.say("no other unit available");
                return Vec::new();
            }
        }
    }
    put(bench, &name, &display);
    if readonly { Vec::new() } else { vec![kept(bench)] }
}

/// Another answer is chosen.
pub(super) fn step(model: &mut Model, by: isize) {
    let Some(bench) = &mut model.bench else { return };
    let last = bench.found.solution.as_ref().map_or(0, |solution| solution.answers.len()).saturating_sub(1);
    if let Some(at) = &mut bench.reading.answer {
        *at = at.saturating_add_signed(by).min(last);
        let at = *at;
        super::bring_in(model, at);
    }
}

fn put(bench: &mut Bench, name: &str, display: &Display) {
    let text = display.to_string();
    for solution in bench.found.solution.iter_mut().chain(&mut bench.pinned) {
        // It is a unit of its kind.
        let _ = show_answer_in(solution, name, &text);
    }
    match bench.show.iter_mut().find(|(known, _)| known == name) {
        Some((_, old)) => *old = text,
        None => bench.show.push((name.to_owned(), text)),
    }
    bench.show_changed = true;
}
