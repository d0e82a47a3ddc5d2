//! `dalembert replay`

use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};

use dalembert_core::Text;
use dalembert_tui::{
    Options,
    files::{self, Before},
    glyphs::Glyphs,
    keys::KeyMap,
    replay::{self, Replay as Session, ReplayResult},
    settings::Settings,
};

use crate::{
    Set,
    arguments::Replay,
    console::{Console, print},
    failure::Failure,
    problem,
};

/// Plays a session, in the terminal or without one.
pub(crate) fn run(asked: &Replay, set: Set, console: &Console) -> Result<ExitCode, Failure> {
    let text = problem::text_of(&asked.file)?;
    let session = Session::read(&text).map_err(|err| Failure::input(err.text()))?;
    let folder = Path::new(&asked.file).parent().unwrap_or(Path::new(""));
    if asked.headless {
        let played = match replay::play(&session, folder) {
            Err(replay::ReplayFailure::NotSeen { line, text, screen }) => {
                print(&screen)?;
                return Err(unmet(&replay::ReplayFailure::NotSeen { line, text, screen }));
            }
            played => played.map_err(|failure| unmet(&failure))?,
        };
        match &asked.pictures {
            Some(folder) => keep(&played, folder)?,
            None => print(&shown(&played))?,
        }
        return Ok(ExitCode::SUCCESS);
    }
    let (file, analysis) = match &session.open {
        Some(named) => replay::to_open(named, folder).map_err(|failure| unmet(&failure))?,
        None => (None, None),
    };
    if !console.interactive {
        return Err(Failure::input("no terminal to replay in; use --headless"));
    }
    Ok(dalembert_tui::run(Options {
        file,
        analysis,
        field: session.field.clone(),
        language: session.language,
        settings: Settings {
            ascii: set.settings.ascii || console.locale.style.ascii || session.look.glyphs == Glyphs::Ascii,
            // A session says its language, and is written in the usual keys.
            language: None,
            keys: KeyMap::default(),
            ..set.settings
        },
        // What was recorded may save and write over files: only the user's own keys do that.
        readonly: true,
        replay: Some((session, asked.speed)),
        ..Options::default()
    }))
}

/// Exit status of a failed replay: bad input if something could not be opened, a failed check if an expected text is
/// not on the screen.
fn unmet(failure: &replay::ReplayFailure) -> Failure {
    match failure {
        replay::ReplayFailure::NothingToOpen(_) => Failure::input(failure.text()),
        _ => Failure::Unmet(failure.text()),
    }
}

/// The marked screens one after the other, each under its name; without any, the last one.
fn shown(played: &ReplayResult) -> String {
    match played.pictures.as_slice() {
        [] => played.last.clone(),
        pictures => {
            let named = pictures.iter().map(|picture| format!("== {}\n{}", picture.name, picture.text));
            named.collect::<Vec<_>>().concat()
        }
    }
}

fn keep(played: &ReplayResult, folder: &Path) -> Result<(), Failure> {
    if played.pictures.is_empty() {
        return Err(Failure::input(Text::new("the session marks no screenshot; add `picture NAME` to it")));
    }
    std::fs::create_dir_all(folder).map_err(Failure::Output)?;
    for picture in &played.pictures {
        let path: PathBuf = folder.join(format!("{}.svg", picture.name));
        files::save(&path, &picture.svg, Before::Whatever)?;
    }
    Ok(())
}
