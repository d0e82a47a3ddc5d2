//! Keys of the list of analyses.

use super::{open_case, problems};
use crate::{
    bench::Bench,
    keys::Action,
    model::{Effect, Model},
    picker::Preview,
    solver::{Job, Work},
};

pub(super) fn act(model: &mut Model, action: Action) -> Vec<Effect> {
    let page = isize::try_from(model.size.1.saturating_sub(6).max(1)).unwrap_or(1);
    match action {
        Action::Up => step(model, -1),
        Action::Down => step(model, 1),
        Action::PageUp => step(model, -page),
        Action::PageDown => step(model, page),
        Action::First => step(model, isize::MIN),
        Action::Last => step(model, isize::MAX),
        Action::Filter => {
            model.picker.typing = true;
            model.picker.case = None;
            Vec::new()
        }
        Action::NextPane if model.picker.typing => {
            model.picker.typing = false;
            Vec::new()
        }
        Action::NextPane => {
            let cases = model.picker.chosen(&model.listings).map_or(0, |listing| listing.cases.len());
            model.picker.case = if model.picker.case.is_none() && cases > 0 { Some(0) } else { None };
            preview(model)
        }
        Action::PreviousPane => {
            model.picker.case = None;
            preview(model)
        }
        Action::Back => back(model),
        Action::Enter => enter(model),
        _ => Vec::new(),
    }
}

/// Solves the case that is to be seen beside the list.
pub(super) fn preview(model: &mut Model) -> Vec<Effect> {
    let case = model.picker.case.unwrap_or(0);
    let Some(listing) = model.picker.chosen(&model.listings) else {
        model.picker.preview = None;
        return Vec::new();
    };
    let (entry, id) = (listing.entry, listing.entry.about.id);
    if model.picker.preview.as_ref().is_some_and(|preview| preview.id == id && preview.case == case) {
        return Vec::new();
    }
    let record = listing.cases.get(case).and_then(|case| case.record(entry).ok());
    let generation = model.next_generation();
    model.picker.preview = Some(Preview { id, case, generation, solution: None });
    record
        .map(|record| Effect::Solve(Job { generation, work: Work::Solve(entry, record) }))
        .into_iter()
        .collect()
}

fn step(model: &mut Model, by: isize) -> Vec<Effect> {
    let visible = model.picker.visible(&model.listings);
    match &mut model.picker.case {
        Some(case) => {
            let cases = visible.get(model.picker.chosen).map_or(0, |at| model.listings[*at].cases.len());
            *case = case.saturating_add_signed(by).min(cases.saturating_sub(1));
        }
        None => {
            let last = visible.len().saturating_sub(1);
            model.picker.chosen = model.picker.chosen.min(last).saturating_add_signed(by).min(last);
        }
    }
    preview(model)
}

fn back(model: &mut Model) -> Vec<Effect> {
    let picker = &mut model.picker;
    if picker.case.take().is_none() {
        let kept = picker.chosen(&model.listings).map(|listing| listing.entry.about.id);
        picker.typing = false;
        picker.filter.reset();
        // The line that was chosen stays chosen in the whole list.
        picker.chosen =
            model.listings.iter().position(|listing| Some(listing.entry.about.id) == kept).unwrap_or(0);
    }
    preview(model)
}

fn enter(model: &mut Model) -> Vec<Effect> {
    let Some(listing) = model.picker.chosen(&model.listings) else { return Vec::new() };
    let (entry, case) = (listing.entry, model.picker.case);
    model.picker.typing = false;
    let wanted = case.and_then(|case| listing.cases.get(case));
    let is_wanted = |bench: &&Bench| {
        bench.entry.about.id == entry.about.id
            && wanted.is_none_or(|case| bench.title.is_empty() && bench.form.draft == case.draft)
    };
    // Back to where it was left: the one that is worked on before the others, the newest before older ones.
    let open = model.bench.iter().chain(model.problems().into_iter().rev()).find(is_wanted);
    match open.map(|bench| bench.number) {
        Some(number) => problems::bring(model, number),
        None => open_case(model, entry, case.unwrap_or(0)),
    }
}
