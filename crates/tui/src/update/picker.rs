//! Keys of the list of analyses.

use dalembert_core::Text;

use super::{
    list::{begin, chosen_leaf, holding, preview},
    open_case, problems, remember,
};
use crate::{
    bench::Bench,
    keys::{Action, Place},
    model::{Effect, Model},
    picker::{Heading, Row},
    remembered::{Change, Progress},
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
        Action::NextPane if model.picker.case.is_some() => to_list(model),
        Action::NextPane => to_cases(model),
        Action::PreviousPane => to_list(model),
        Action::Right => right(model),
        Action::Left => left(model),
        Action::PinAnalysis => pin(model),
        Action::Toggle => mark(model),
        Action::Back => back(model),
        Action::Enter => enter(model),
        _ => Vec::new(),
    }
}

fn step(model: &mut Model, by: isize) -> Vec<Effect> {
    match (model.picker.case, chosen_leaf(model)) {
        (Some(case), Some(leaf)) => {
            let last = model.listings[leaf.listing].cases().len().saturating_sub(1);
            model.picker.case = Some(case.saturating_add_signed(by).min(last));
        }
        _ => {
            let last = model.picker.rows(model.contents()).len().saturating_sub(1);
            model.picker.chosen = model.picker.chosen.min(last).saturating_add_signed(by).min(last);
        }
    }
    preview(model)
}

/// To the cases of the chosen analysis, where it has some.
pub(super) fn to_cases(model: &mut Model) -> Vec<Effect> {
    if model.picker.case.is_none()
        && let Some(leaf) = chosen_leaf(model)
        && !model.listings[leaf.listing].cases().is_empty()
    {
        model.picker.case = Some(leaf.case.unwrap_or(0));
    }
    preview(model)
}

fn to_list(model: &mut Model) -> Vec<Effect> {
    model.picker.case = None;
    preview(model)
}

/// Opens a heading, or goes on to the cases.
fn right(model: &mut Model) -> Vec<Effect> {
    match model.picker.chosen(model.contents()) {
        Some(Row::Heading(heading)) if !model.picker.is_open(heading, &model.listings) => {
            turn(model, heading)
        }
        Some(Row::Heading(_)) => step(model, 1),
        _ => to_cases(model),
    }
}

/// Back from the cases; from the list to the heading, which is folded next.
fn left(model: &mut Model) -> Vec<Effect> {
    if model.picker.case.is_some() {
        return to_list(model);
    }
    let Some(row) = model.picker.chosen(model.contents()) else { return Vec::new() };
    match row {
        Row::Heading(heading) if model.picker.is_open(heading, &model.listings) => turn(model, heading),
        _ => {
            let above = row.under().map(Row::Heading);
            let rows = model.picker.rows(model.contents());
            if let Some(at) = rows.iter().position(|row| Some(*row) == above) {
                model.picker.chosen = at;
            }
            preview(model)
        }
    }
}

fn turn(model: &mut Model, heading: Heading) -> Vec<Effect> {
    holding(model, |model| model.picker.turn(heading));
    preview(model)
}

/// Pins the chosen analysis, or no more.
fn pin(model: &mut Model) -> Vec<Effect> {
    let Some(leaf) = chosen_leaf(model) else {
        model.say("select an analysis to pin");
        return Vec::new();
    };
    let id = model.listings[leaf.listing].entry.about.id;
    let pinned = !model.remembered.pinned.iter().any(|other| other == id);
    let effects = remember(model, Change::Pin(id.to_owned(), pinned));
    model.say(if pinned { "pinned at the top of the list" } else { "unpinned" });
    let mut all = preview(model);
    all.extend(effects);
    all
}

/// Marks the chosen exercise as done, or as not done.
fn mark(model: &mut Model) -> Vec<Effect> {
    let Some((leaf, case)) = model.chosen_exercise() else {
        let said = Text::new("{key} ticks an exercise of a list");
        model.say(said.with("key", model.key(Place::Picker, Action::Toggle)));
        return Vec::new();
    };
    let listing = &model.listings[leaf.listing];
    let progress = if model.contents().progress(leaf).is_done() { Progress::Opened } else { Progress::Done };
    let (analysis, case) = (listing.entry.about.id.to_owned(), listing.cases()[case].name.clone());
    remember(model, Change::Reach { analysis, case, progress })
}

fn back(model: &mut Model) -> Vec<Effect> {
    if model.picker.case.take().is_none() && (model.picker.typing || !model.picker.filter.value().is_empty())
    {
        let kept = chosen_leaf(model).map(|leaf| leaf.listing);
        model.picker.typing = false;
        model.picker.filter.reset();
        // What was chosen stays chosen in the whole list.
        match kept {
            Some(listing) => show(model, listing),
            None => begin(model),
        }
    }
    preview(model)
}

/// Chooses an analysis in its topic.
fn show(model: &mut Model, listing: usize) {
    let mut picker = std::mem::take(&mut model.picker);
    picker.show(listing, model.contents());
    model.picker = picker;
}

fn enter(model: &mut Model) -> Vec<Effect> {
    let leaf = match model.picker.chosen(model.contents()) {
        Some(Row::Heading(heading)) => return turn(model, heading),
        Some(Row::Leaf(leaf)) => leaf,
        None => return Vec::new(),
    };
    let listing = &model.listings[leaf.listing];
    let (entry, case) = (listing.entry, model.picker.case.or(leaf.case));
    model.picker.typing = false;
    let wanted = case.and_then(|case| listing.cases().get(case));
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
