//! What a person sets, and what is wrong with it.

use std::path::Path;

use dalembert_core::Text;

use crate::{dialog::Dialog, files::shown, glyphs::filter_untrusted, model::Model, settings::Fault};

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
