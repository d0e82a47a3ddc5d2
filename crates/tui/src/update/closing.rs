//! The end of a problem or of the program, and what becomes of unsaved work.

use dalembert_core::Text;

use super::{
    files, list,
    problems::{bring, name},
};
use crate::{
    dialog::{After, Answer, Dialog},
    model::{Effect, Model, Screen},
};

/// Does what ends problems, or asks first what becomes of unsaved work.
pub(super) fn leave(model: &mut Model, after: After) -> Vec<Effect> {
    let unsaved = match after {
        _ if model.readonly && !model.played => Vec::new(),
        After::Quit => unsaved(model),
        After::Stay | After::Close => {
            model.bench.iter().filter(|bench| bench.is_unsaved()).map(|bench| bench.number).collect()
        }
    };
    let question = match unsaved[..] {
        [] => return discard(model, after),
        [only] => {
            let effects = bring(model, only);
            ask(model, "The problem has unsaved changes.".into(), after);
            return effects;
        }
        _ => {
            let names: Vec<String> = model
                .problems()
                .into_iter()
                .filter(|bench| bench.is_unsaved())
                .map(|bench| name(model, bench))
                .collect();
            Text::new("{count} problems have unsaved changes: {names}.")
                .with("count", names.len())
                .with("names", names.join("; "))
        }
    };
    ask(model, question, after);
    Vec::new()
}

/// Does what was put off until the problem that is shown was saved.
pub(super) fn go_on(model: &mut Model, after: After) -> Vec<Effect> {
    match (after, unsaved(model).first()) {
        // The next one that is not saved yet has its turn.
        (After::Quit, Some(number)) => save_then(model, *number, After::Quit),
        _ => discard(model, after),
    }
}

/// Saves what is not saved, and then goes on.
pub(super) fn save_all_then(model: &mut Model, after: After) -> Vec<Effect> {
    let here = model.bench.as_ref().map(|bench| bench.number);
    let first = match after {
        After::Quit => unsaved(model).first().copied(),
        After::Stay | After::Close => here,
    };
    first.map_or_else(Vec::new, |number| save_then(model, number, after))
}

/// Ends problems, whatever is not saved of them.
pub(super) fn discard(model: &mut Model, after: After) -> Vec<Effect> {
    match after {
        After::Stay => Vec::new(),
        After::Quit => {
            let mut effects: Vec<Effect> =
                model.problems().iter().map(|bench| Effect::Forget(bench.number)).collect();
            effects.push(Effect::Quit);
            effects
        }
        After::Close => {
            let Some(closed) = model.bench.take() else { return Vec::new() };
            let mut effects = vec![Effect::Forget(closed.number)];
            let all: Vec<u64> = model.problems().iter().map(|bench| bench.number).collect();
            let next = all.iter().find(|number| **number > closed.number).or(all.last());
            effects.extend(match next {
                Some(number) => bring(model, *number),
                None => {
                    model.screen = Screen::Picker;
                    list::preview(model)
                }
            });
            effects
        }
    }
}

fn ask(model: &mut Model, question: Text, after: After) {
    let several = after == After::Quit && unsaved(model).len() > 1;
    let (save, discard) = match after {
        After::Quit if several => ("save all and quit", "quit without saving"),
        After::Quit => ("save and quit", "quit without saving"),
        After::Stay | After::Close => ("save and close", "close without saving"),
    };
    model.dialog = Some(Dialog::Ask {
        question,
        answers: vec![
            (save, Answer::SaveThen(after)),
            (discard, Answer::DiscardThen(after)),
            ("stay", Answer::Cancel),
        ],
        chosen: 0,
    });
}

fn save_then(model: &mut Model, number: u64, after: After) -> Vec<Effect> {
    let mut effects = bring(model, number);
    model.after_save = after;
    effects.extend(files::save(model));
    effects
}

/// The problems that are not saved, in the order of opening.
fn unsaved(model: &Model) -> Vec<u64> {
    model.problems().into_iter().filter(|bench| bench.is_unsaved()).map(|bench| bench.number).collect()
}
