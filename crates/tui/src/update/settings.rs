//! What a person sets, and what is wrong with it.

use std::path::Path;

use dalembert_core::Text;

use crate::{
    dialog::{Answer, Dialog},
    files::shown,
    glyphs::{Colors, filter_untrusted},
    look::Theme,
    model::{Effect, Model},
    settings::Fault,
};

/// So many faults are listed.
const MOST_FAULTS: usize = 8;

/// Tells what of the settings is not taken, over the screen or, where something else lies there, below it.
pub(super) fn faulty(model: &mut Model, path: &Path, faults: &[Fault]) {
    let say = |fault: &Fault| {
        Text::new("line {line}: {why}").with("line", fault.line).with_text("why", fault.why.clone())
    };
    let title = Text::new("{file}: this is not taken, the rest is").with("file", shown(path));
    let Some(first) = faults.first() else { return };
    if model.dialog.is_some() {
        model.complain(Text::new("{file}: {why}").with("file", shown(path)).with_text("why", say(first)));
        return;
    }
    let line = |text: Text| filter_untrusted(&text.render(&model.locale)).into_owned();
    let mut lines: Vec<String> = faults.iter().take(MOST_FAULTS).map(|fault| line(say(fault))).collect();
    if faults.len() > MOST_FAULTS {
        lines.push(line(Text::new("and {more} more").with("more", faults.len() - MOST_FAULTS)));
    }
    model.dialog = Some(Dialog::Message { title, lines });
}

/// Asks how things are to be coloured.
pub(super) fn ask_theme(model: &mut Model) {
    if model.look.colors == Colors::None {
        model.say("this terminal shows no colours, or was asked to show none");
        return;
    }
    let chosen = Theme::ALL.iter().position(|theme| *theme == model.look.theme).unwrap_or(0);
    model.dialog = Some(Dialog::Ask {
        question: "How are things to be coloured? The settings can say it for good.".into(),
        answers: Theme::ALL.iter().map(|theme| (theme.name(), Answer::Theme(*theme))).collect(),
        chosen,
    });
}

/// Takes the mouse, or leaves it to the terminal.
pub(super) fn turn_mouse(model: &mut Model) -> Vec<Effect> {
    model.mouse = !model.mouse;
    model.say(if model.mouse {
        "the mouse is taken: the terminal's own selection needs Shift now"
    } else {
        "the mouse is the terminal's own again"
    });
    vec![Effect::Mouse(model.mouse)]
}
