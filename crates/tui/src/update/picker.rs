//! Keys of the list of analyses: the chosen row, and what is shown beside it.

use dalembert_core::{Text, UnitSetting};

use crate::{
    bench::Bench,
    effect::Effect,
    intent::Intent,
    keys::{Action, KeyContext},
    model::{Model, Screen},
    picker::{Heading, Leaf, Preview, Row},
    remembered::{HistoryChange, Progress},
    solver::{Job, JobOutcome, Work},
};

pub(super) fn act(model: &mut Model, action: Action) -> Vec<Intent> {
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
        Action::NextPane if model.picker.case.is_some() => to_list(model),
        Action::NextPane => to_cases(model),
        Action::PreviousPane => to_list(model),
        Action::Right => right(model),
        Action::Left => left(model),
        Action::PinAnalysis => pin(model),
        Action::Toggle => mark(model),
        Action::Blank => blank(model),
        Action::Back => back(model),
        Action::Enter => enter(model),
        _ => Vec::new(),
    }
}

fn step(model: &mut Model, by: isize) -> Vec<Intent> {
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
fn to_cases(model: &mut Model) -> Vec<Intent> {
    model.go_to_cases();
    // Letters are keys there.
    model.picker.typing &= model.picker.case.is_none();
    preview(model)
}

fn to_list(model: &mut Model) -> Vec<Intent> {
    model.picker.case = None;
    preview(model)
}

/// Opens a heading, or goes on to the cases.
fn right(model: &mut Model) -> Vec<Intent> {
    match model.picker.chosen(model.contents()) {
        Some(Row::Heading(heading))
            if heading != Heading::Field && !model.picker.is_open(heading, &model.listings) =>
        {
            turn(model, heading)
        }
        Some(Row::Heading(_)) => step(model, 1),
        _ => to_cases(model),
    }
}

/// Back from the cases; from the list to the heading, which is folded next.
fn left(model: &mut Model) -> Vec<Intent> {
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

fn turn(model: &mut Model, heading: Heading) -> Vec<Intent> {
    holding(model, |model| model.picker.turn(heading));
    preview(model)
}

/// Pins the chosen analysis, or no more.
fn pin(model: &mut Model) -> Vec<Intent> {
    let Some(leaf) = chosen_leaf(model) else {
        model.say("select an analysis to pin");
        return Vec::new();
    };
    let id = model.listings[leaf.listing].entry.about.id;
    let pinned = !model.remembered.pinned.iter().any(|other| other == id);
    let effects = remember(model, HistoryChange::Pin(id.to_owned(), pinned));
    model.say(if pinned { "pinned at the top of the list" } else { "unpinned" });
    let mut all = preview(model);
    all.extend(effects);
    all
}

/// A blank problem of the chosen analysis.
fn blank(model: &mut Model) -> Vec<Intent> {
    let Some(leaf) = chosen_leaf(model) else {
        return Intent::say("select an analysis to begin a blank problem");
    };
    model.picker.typing = false;
    vec![Intent::OpenBlank(model.listings[leaf.listing].entry)]
}

/// Marks the chosen exercise as done, or as not done.
fn mark(model: &mut Model) -> Vec<Intent> {
    let Some((leaf, case)) = model.chosen_exercise() else {
        let said = Text::new("{key} ticks an exercise of a list");
        model.say(said.with("key", model.key(KeyContext::Picker, Action::Toggle)));
        return Vec::new();
    };
    let listing = &model.listings[leaf.listing];
    let progress = if model.contents().progress(leaf).is_done() { Progress::Opened } else { Progress::Done };
    let (analysis, case) = (listing.entry.about.id.to_owned(), listing.cases()[case].name.clone());
    remember(model, HistoryChange::Reach { analysis, case, progress })
}

fn back(model: &mut Model) -> Vec<Intent> {
    let is_search = model.picker.case.take().is_none();
    model.picker.typing &= !is_search;
    if is_search && !model.picker.filter.value().is_empty() {
        let kept = chosen_leaf(model).map(|leaf| leaf.listing);
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

fn enter(model: &mut Model) -> Vec<Intent> {
    let leaf = match model.picker.chosen(model.contents()) {
        Some(Row::Heading(Heading::Field)) => return super::field::begin(model),
        Some(Row::Heading(heading)) => return turn(model, heading),
        Some(Row::Leaf(leaf)) => leaf,
        None => return Vec::new(),
    };
    let listing = &model.listings[leaf.listing];
    let (entry, case) = (listing.entry, model.picker.case.or(leaf.case));
    model.picker.typing = false;
    let wanted = case.and_then(|case| listing.cases().get(case));
    let is_exercise = leaf.is_exercise() && case == leaf.case;
    let is_wanted = |bench: &&Bench| {
        bench.problem.entry().about.id == entry.about.id
            && (!is_exercise || bench.problem.document.is_exercise)
            && wanted.is_none_or(|case| {
                bench.problem.document.title.is_empty() && bench.problem.inputs.form.draft == case.draft
            })
    };
    // Back to where it was left: the one that is worked on before the others, the newest before older ones.
    let open = model.bench.iter().chain(model.problems().into_iter().rev()).find(is_wanted);
    match open.map(|bench| bench.problem.number) {
        Some(number) => vec![Intent::Bring(number)],
        None if is_exercise => vec![Intent::OpenExercise(entry, case.unwrap_or(0))],
        None => vec![Intent::OpenCase(entry, case.unwrap_or(0))],
    }
}

/// Solves the case that is to be seen beside the list.
pub(super) fn preview(model: &mut Model) -> Vec<Intent> {
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
        .map(|record| Intent::Do(Effect::Solve(Job { generation, work: Work::Solve(entry, record) })))
        .into_iter()
        .collect()
}

/// Compares the cases of the chosen analysis with what was printed: it is solved, so the user rests on it.
fn check_cases(model: &Model) -> Vec<Intent> {
    let listing = chosen_leaf(model).and_then(|leaf| model.listings.get(leaf.listing));
    let unjudged = listing.filter(|listing| listing.checked.is_none() && !listing.cases().is_empty());
    unjudged.map(|listing| Intent::Do(Effect::Judge(listing.entry))).into_iter().collect()
}

/// Does something that may move rows, with the same one chosen after it.
fn holding<T>(model: &mut Model, change: impl FnOnce(&mut Model) -> T) -> T {
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
pub(super) fn return_to_list(model: &mut Model) -> Vec<Intent> {
    model.screen = Screen::Picker;
    model.picker.typing = true;
    let left = model.bench.as_ref().map(|bench| bench.problem.entry().about.id);
    let is_left = |leaf: Leaf| Some(model.listings[leaf.listing].entry.about.id) == left;
    if !chosen_leaf(model).is_some_and(is_left) {
        let rows = model.picker.rows(model.contents());
        let row = rows.iter().position(|row| matches!(row, Row::Leaf(leaf) if is_left(*leaf)));
        model.picker.chosen = row.unwrap_or(model.picker.chosen);
    }
    preview(model)
}

fn chosen_leaf(model: &Model) -> Option<Leaf> {
    match model.picker.chosen(model.contents())? {
        Row::Leaf(leaf) => Some(leaf),
        Row::Heading(_) => None,
    }
}

/// Takes what was solved to be seen beside the list.
pub(super) fn solved(model: &mut Model, outcome: JobOutcome) -> Vec<Intent> {
    match &mut model.picker.preview {
        Some(preview) if preview.generation == outcome.generation => {
            let solution = outcome.result.ok().flatten();
            let listing = model.listings.iter().find(|listing| listing.entry.about.id == preview.id);
            let case = listing.and_then(|listing| Some((listing.entry, listing.cases().get(preview.case)?)));
            preview.solution = match (solution, case) {
                (Some(solution), Some((entry, case))) => {
                    Some(solution.in_units_of(UnitSetting::Auto, &case.draft, &entry.shape()))
                }
                (solution, _) => solution,
            };
            check_cases(model)
        }
        _ => Vec::new(),
    }
}

/// Remembers something, and has it written where anything is written.
pub(super) fn remember(model: &mut Model, change: HistoryChange) -> Vec<Intent> {
    let taken = holding(model, |model| model.remembered.take(&change));
    if taken && !model.readonly { vec![Intent::Do(Effect::Remember(change))] } else { Vec::new() }
}
