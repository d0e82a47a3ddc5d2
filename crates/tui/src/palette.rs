//! The command palette: what it offers for what is typed.

use dalembert_core::Text;
use nucleo_matcher::{
    Config, Matcher, Utf32Str,
    pattern::{CaseMatching, Normalization, Pattern},
};

use crate::{
    keys::{Action, Bound, KeyContext},
    model::{Model, Screen},
};

/// A command with words of its own: what it does, and the words.
pub(crate) fn command(typed: &str) -> Option<(Action, &str)> {
    let (first, words) = typed.trim().split_once(char::is_whitespace)?;
    let action = match first.to_lowercase().as_str() {
        "problem" | "problema" => Action::BeginProblem,
        "configuration" | "configuração" | "configuracao" => Action::BeginConfiguration,
        _ => return None,
    };
    Some((action, words.trim()))
}

/// The bindings that the palette offers for what is typed, the best first, and the place each belongs to.
pub(crate) fn matching_actions<'m>(model: &'m Model, typed: &str) -> Vec<(KeyContext, &'m Bound)> {
    // What is done where the keys are now comes before the same thing elsewhere.
    let places: Vec<KeyContext> = match (model.screen, &model.bench) {
        (Screen::Bench, Some(bench)) if bench.field.is_some() => vec![bench.place()],
        (Screen::Bench, Some(bench)) => {
            let of_problem = |place: &KeyContext| *place == KeyContext::Form || place.is_pane();
            [bench.place()].into_iter().chain(model.keys.places().filter(of_problem)).collect()
        }
        _ => vec![KeyContext::Picker],
    };
    let mut all: Vec<(KeyContext, &'m Bound)> = Vec::new();
    for place in places.into_iter().filter(|place| !place.is_text()) {
        for bound in model.keys.bindings(place) {
            let same = |other: &Bound| {
                other.binding.action == bound.binding.action || other.binding.name == bound.binding.name
            };
            if !all.iter().any(|(_, other)| same(other)) {
                all.push((place, bound));
            }
        }
    }
    if let Some((action, _)) = command(typed) {
        all.retain(|(_, bound)| bound.binding.action == action);
        return all;
    }
    let typed = typed.trim();
    if typed.is_empty() {
        return all;
    }
    let mut matcher = Matcher::new(Config::DEFAULT);
    let pattern = Pattern::parse(typed, CaseMatching::Ignore, Normalization::Smart);
    let mut scored: Vec<(u32, (KeyContext, &'m Bound))> = all
        .into_iter()
        .filter_map(|(place, bound)| {
            let binding = bound.binding;
            let name = Text::from(binding.name).render(&model.locale);
            // English names do in every language, so that instructions can be followed.
            let score = [name.as_str(), binding.name]
                .into_iter()
                .filter_map(|name| pattern.score(Utf32Str::new(name, &mut Vec::new()), &mut matcher))
                .max()?;
            let exact = if binding.name == typed || name == typed { 1_000 } else { 0 };
            Some((score + exact, (place, bound)))
        })
        .collect();
    scored.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
    scored.into_iter().map(|(_, matching_actions)| matching_actions).collect()
}
