//! The end of a problem or of the program, and what becomes of unsaved work.

use dalembert_core::Text;

use crate::{
    dialog::{After, Answer, Dialog},
    effect::Effect,
    intent::Intent,
    model::{Model, Screen},
};

/// Does what ends problems, or asks first what becomes of unsaved work.
pub(super) fn leave(model: &Model, after: After) -> Vec<Intent> {
    let unsaved = match after {
        _ if model.readonly && !model.is_replay => Vec::new(),
        After::Quit => unsaved(model),
        After::Stay | After::Close => {
            let shown = model.bench.iter().filter(|bench| bench.problem.is_unsaved());
            shown.map(|bench| bench.problem.number).collect()
        }
    };
    match unsaved[..] {
        [] => vec![Intent::Discard(after)],
        [only] => {
            let question = "The problem has unsaved changes.".into();
            vec![Intent::Bring(only), Intent::Show(ask(question, after, false))]
        }
        _ => {
            let problems = model.problems().into_iter().filter(|bench| bench.problem.is_unsaved());
            let names: Vec<String> = problems.map(|bench| bench.name_among(&model.locale)).collect();
            let question = Text::new("{count} problems have unsaved changes: {names}.")
                .with("count", names.len())
                .with("names", names.join("; "));
            vec![Intent::Show(ask(question, after, true))]
        }
    }
}

fn ask(question: Text, after: After, several: bool) -> Dialog {
    let (save, discard) = match after {
        After::Quit if several => ("save all and quit", "quit without saving"),
        After::Quit => ("save and quit", "quit without saving"),
        After::Stay | After::Close => ("save and close", "close without saving"),
    };
    Dialog::Ask {
        question,
        answers: vec![
            (save, Answer::SaveThen(after)),
            (discard, Answer::DiscardThen(after)),
            ("stay", Answer::Cancel),
        ],
        chosen: 0,
    }
}

/// Saves what is not saved, one after the other, and then goes on.
pub(super) fn save_then(model: &mut Model, after: After) -> Vec<Intent> {
    let next = match after {
        After::Stay => return Vec::new(),
        After::Quit => unsaved(model).first().copied(),
        After::Close => model
            .bench
            .iter()
            .map(|bench| bench.problem.number)
            .find(|number| unsaved(model).contains(number)),
    };
    let Some(number) = next else { return vec![Intent::Discard(after)] };
    model.after_save = after;
    vec![Intent::Bring(number), Intent::Save]
}

/// Ends problems, whatever is not saved of them.
pub(super) fn discard(model: &mut Model, after: After) -> Vec<Intent> {
    match after {
        After::Stay => Vec::new(),
        After::Quit => {
            let numbers = model.problems().into_iter().map(|bench| bench.problem.number);
            numbers.map(Effect::Forget).chain([Effect::Quit]).map(Intent::Do).collect()
        }
        After::Close => {
            let Some(closed) = model.bench.take().map(|bench| bench.problem.number) else {
                return Vec::new();
            };
            let all: Vec<u64> = model.problems().iter().map(|bench| bench.problem.number).collect();
            let next = all.iter().find(|number| **number > closed).or(all.last());
            let shown = next.map_or(Intent::Preview, |number| Intent::Bring(*number));
            if next.is_none() {
                model.screen = Screen::Picker;
            }
            vec![Intent::Do(Effect::Forget(closed)), shown]
        }
    }
}

/// The problems that are not saved, in the order of opening.
fn unsaved(model: &Model) -> Vec<u64> {
    let unsaved = model.problems().into_iter().filter(|bench| bench.problem.is_unsaved());
    unsaved.map(|bench| bench.problem.number).collect()
}
