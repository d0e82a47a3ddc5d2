//! Settings of the user, and their errors.

use std::path::{Path, PathBuf};

use dalembert_core::Text;

use crate::{
    dialog::{Answer, Dialog},
    effect::Effect,
    files::shown,
    glyphs::{Colors, filter_untrusted},
    intent::Intent,
    look::Theme,
    model::Model,
    settings::Fault,
};

/// So many faults are listed.
const MOST_FAULTS: usize = 8;

/// Tells what of the user's own files is not taken, over the screen or, where something else lies there, below it.
pub(super) fn faulty(model: &mut Model, files: &[(PathBuf, Vec<Fault>)]) {
    let all: Vec<(&PathBuf, &Fault)> =
        files.iter().flat_map(|(path, faults)| faults.iter().map(move |fault| (path, fault))).collect();
    let Some((path, first)) = all.first() else { return };
    let seen = if model.dialog.is_some() { 1 } else { MOST_FAULTS };
    let more = (all.len() > seen)
        .then(|| Text::new("and {more} more: `dalembert info` lists all").with("more", all.len() - seen));
    if model.dialog.is_some() {
        let first = first.text_in(shown(path));
        model.report_error(match more {
            Some(more) => Text::new("{why}; {more}").with_text("why", first).with_text("more", more),
            None => first,
        });
        return;
    }
    let one_file = files.len() == 1;
    let title = if one_file {
        Text::new("{file}: ignored; the other settings apply").with("file", shown(path))
    } else {
        Text::new("ignored; all other settings apply")
    };
    let lines = all.iter().take(MOST_FAULTS).map(|(path, fault)| {
        let name = Path::new(path.file_name().unwrap_or(path.as_os_str()));
        if one_file { fault.text() } else { fault.text_in(shown(name)) }
    });
    let line = |text: Text| filter_untrusted(&text.render(&model.locale)).into_owned();
    let lines = lines.chain(more).map(line).collect();
    model.dialog = Some(Dialog::Message { title, lines });
}

/// Asks how things are to be coloured.
pub(super) fn ask_theme(model: &Model) -> Vec<Intent> {
    if model.look.colors == Colors::None {
        return Intent::say("this terminal shows no colours, or they are switched off");
    }
    let chosen = Theme::ALL.iter().position(|theme| *theme == model.look.theme).unwrap_or(0);
    vec![Intent::Show(Dialog::Ask {
        question: "Choose a theme (set `theme` in the settings to keep it).".into(),
        answers: Theme::ALL.iter().map(|theme| (theme.name(), Answer::Theme(*theme))).collect(),
        chosen,
    })]
}

/// Takes the mouse, or leaves it to the terminal.
pub(super) fn turn_mouse(model: &mut Model) -> Vec<Intent> {
    model.mouse = !model.mouse;
    model.say(if model.mouse {
        "mouse in use: select text with Shift"
    } else {
        "mouse left to the terminal"
    });
    vec![Intent::Do(Effect::Mouse(model.mouse))]
}
