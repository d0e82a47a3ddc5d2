//! What is remembered from one session to the next.

use super::list;
use crate::{
    model::{Effect, Model},
    remembered::{Change, Progress},
};

/// Takes a change, and has it written where anything is written.
pub(super) fn remember(model: &mut Model, change: Change) -> Vec<Effect> {
    let taken = list::holding(model, |model| model.remembered.take(&change));
    if taken && !model.readonly { vec![Effect::Remember(change)] } else { Vec::new() }
}

/// The case that is shown was opened.
pub(super) fn opened(model: &mut Model) -> Vec<Effect> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let id = bench.entry.about.id.to_owned();
    let mut effects = reach(model, Progress::Opened);
    effects.extend(remember(model, Change::Open(id)));
    effects
}

/// The case that is shown was solved by hand: it is done in every list of exercises.
pub fn remember_done(model: &mut Model) -> Vec<Effect> {
    reach(model, Progress::Solved)
}

/// The case that is shown, as it was published, is worked through so far at least.
fn reach(model: &mut Model, progress: Progress) -> Vec<Effect> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let Some(case) = bench.origin.as_ref().filter(|case| case.draft == bench.form.draft) else {
        return Vec::new();
    };
    let (analysis, case) = (bench.entry.about.id.to_owned(), case.name.clone());
    let progress = progress.max(model.remembered.progress(&analysis, &case));
    remember(model, Change::Reach { analysis, case, progress })
}
