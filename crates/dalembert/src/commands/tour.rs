//! `dalembert tour`

use std::process::ExitCode;

use dalembert_core::find;
use dalembert_tui::{Options, keys::KeyMap, replay, settings::Settings};

use crate::{Set, arguments::Tour, console::Console, failure::Failure};

/// Plays the tour, which ends in the user's own session.
pub(crate) fn run(asked: &Tour, set: Set, console: &Console) -> Result<ExitCode, Failure> {
    if !console.interactive {
        return Err(Failure::input("the tour needs a terminal; `dalembert list` lists the analyses"));
    }
    let session = replay::tour(console.locale.language);
    Ok(dalembert_tui::run(Options {
        analysis: session.open.as_deref().and_then(find),
        language: console.locale.language,
        settings: Settings {
            ascii: set.settings.ascii || console.locale.style.ascii,
            // It is written in the usual keys.
            keys: KeyMap::default(),
            ..set.settings
        },
        faults: set.path.map(|path| (path, set.faults)),
        replay: Some((session, asked.speed)),
        tour: true,
        ..Options::default()
    }))
}
