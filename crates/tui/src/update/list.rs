//! The list of analyses: the chosen row, and what is shown beside it.

use crate::{
    model::{Effect, Model, Screen},
    picker::{Heading, Leaf, Preview, Row},
    solver::{Job, Work},
};

/// Solves the case that is to be seen beside the list.
pub(super) fn preview(model: &mut Model) -> Vec<Effect> {
    let Some(leaf) = chosen_leaf(model) else {
        model.picker.preview = None;
        return Vec::new();
    };
    let listing = &model.listings[leaf.listing];
    let case = model.picker.case.or(leaf.case).unwrap_or(0);
    let (entry, id) = (listing.entry, listing.entry.about.id);
    if model.picker.preview.as_ref().is_some_and(|preview| preview.id == id && preview.case == case) {
        return Vec::new();
    }
    let record = listing.cases().get(case).and_then(|case| case.record(entry).ok());
    let generation = model.next_generation();
    model.picker.preview = Some(Preview { id, case, generation, solution: None });
    record
        .map(|record| Effect::Solve(Job { generation, work: Work::Solve(entry, record) }))
        .into_iter()
        .collect()
}

/// What is chosen is solved, so the user rests on it: its cases are compared with what was printed.
pub(super) fn judge(model: &Model) -> Vec<Effect> {
    let listing = chosen_leaf(model).and_then(|leaf| model.listings.get(leaf.listing));
    let unjudged = listing.filter(|listing| listing.judged.is_none() && !listing.cases().is_empty());
    unjudged.map(|listing| Effect::Judge(listing.entry)).into_iter().collect()
}

/// Does something that may move rows, with the same one chosen after it.
pub(super) fn holding<T>(model: &mut Model, change: impl FnOnce(&mut Model) -> T) -> T {
    let chosen = model.picker.chosen(model.contents());
    let done = change(model);
    let rows = model.picker.rows(model.contents());
    let same = |row: &Row| match (row, chosen) {
        (Row::Leaf(leaf), Some(Row::Leaf(chosen))) => leaf.listing == chosen.listing,
        _ => false,
    };
    let at = rows.iter().position(|row| Some(*row) == chosen).or_else(|| rows.iter().position(same));
    model.picker.chosen = at.unwrap_or_else(|| model.picker.chosen.min(rows.len().saturating_sub(1)));
    done
}

/// Puts the cursor where the list begins: on what can be opened, where some of it is shown.
pub(super) fn begin(model: &mut Model) {
    let rows = model.picker.rows(model.contents());
    let family = |row: &Row| matches!(row, Row::Heading(Heading::Family(_)));
    let leaf = rows.iter().position(|row| matches!(row, Row::Leaf(_)));
    model.picker.chosen = leaf.or_else(|| rows.iter().position(family)).unwrap_or(0);
}

/// Back to the list, to the analysis of the problem that is left, where it is shown.
pub(super) fn come_back(model: &mut Model) -> Vec<Effect> {
    model.screen = Screen::Picker;
    let left = model.bench.as_ref().map(|bench| bench.entry.about.id);
    let is_left = |leaf: Leaf| Some(model.listings[leaf.listing].entry.about.id) == left;
    if !chosen_leaf(model).is_some_and(is_left) {
        let rows = model.picker.rows(model.contents());
        let row = rows.iter().position(|row| matches!(row, Row::Leaf(leaf) if is_left(*leaf)));
        model.picker.chosen = row.unwrap_or(model.picker.chosen);
    }
    preview(model)
}

pub(super) fn chosen_leaf(model: &Model) -> Option<Leaf> {
    match model.picker.chosen(model.contents())? {
        Row::Leaf(leaf) => Some(leaf),
        Row::Heading(_) => None,
    }
}
