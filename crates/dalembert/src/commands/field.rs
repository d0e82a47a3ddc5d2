//! `dalembert field`: a job of balancing in the field, step by step in a terminal.

use std::process::ExitCode;

use dalembert_tui::{Options, settings::Settings};

use crate::{
    Set,
    arguments::{Arguments, Field},
    console::Console,
    failure::Failure,
};

/// Opens field mode on a job that is gone on with, or on a blank one.
pub(crate) fn run(
    arguments: &Field,
    all: &Arguments,
    set: Set,
    console: &Console,
) -> Result<ExitCode, Failure> {
    if !console.interactive {
        return Err(Failure::input("field mode needs a terminal; `dalembert solve FILE` prints a job"));
    }
    let exists = arguments.file.as_ref().is_some_and(|path| path.exists());
    let blank = arguments.file.clone().filter(|_| !exists);
    Ok(dalembert_tui::run(Options {
        file: arguments.file.clone().filter(|_| exists),
        language: console.locale.language,
        settings: Settings {
            ascii: set.settings.ascii || console.locale.style.ascii,
            mouse: if all.no_mouse || all.basic { Some(false) } else { set.settings.mouse },
            ..set.settings
        },
        faults: set.path.map(|path| (path, set.faults)),
        readonly: all.readonly,
        basic: all.basic,
        field: Some(blank),
        ..Options::default()
    }))
}
