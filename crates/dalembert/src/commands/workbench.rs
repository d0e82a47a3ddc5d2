//! `dalembert` and `dalembert FILE`: the workbench, or a worked solution where there is no terminal.

use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};

use dalembert_core::{Text, file, find};
use dalembert_tui::{Options, settings::Settings};

use crate::{
    Set,
    arguments::Arguments,
    commands::solve::print_worked,
    console::Console,
    failure::Failure,
    problem::{self, ProblemSource},
};

/// The problem that the workbench opens on, and that is printed where there is no terminal, when none is named.
const FIRST: &str = "vibration/rotating-unbalance";

/// Opens the workbench.
pub(crate) fn run(arguments: &Arguments, set: Set, console: &Console) -> Result<ExitCode, Failure> {
    let named = arguments.problem.as_deref();
    if !console.interactive {
        let asked = ProblemSource::named(named.unwrap_or(FIRST));
        return print_worked(&problem::read(&asked, console)?, console);
    }
    if named.is_some_and(problem::is_standard_input) {
        return Err(Failure::input(
            "the workbench reads its keys from standard input: name a file, or use `dalembert solve -`",
        ));
    }
    if let Some(path) = &arguments.record {
        can_be_recorded(path)?;
    }
    let analysis = find(named.unwrap_or(FIRST));
    let path = named.filter(|_| analysis.is_none()).map(PathBuf::from);
    if let Some(named) = named.filter(|named| problem::looks_like_an_id(named))
        && path.as_ref().is_some_and(|path| !path.exists())
    {
        return Err(Failure::input(file::no_such_analysis(named)));
    }
    Ok(dalembert_tui::run(Options {
        file: path,
        analysis,
        record: arguments.record.clone(),
        ..options(arguments, set, console)
    }))
}

/// Options that the user's settings and the options of every command give.
pub(super) fn options(arguments: &Arguments, set: Set, console: &Console) -> Options {
    Options {
        language: console.locale.language,
        settings: Settings {
            ascii: set.settings.ascii || console.locale.style.ascii,
            mouse: if arguments.no_mouse || arguments.basic { Some(false) } else { set.settings.mouse },
            ..set.settings
        },
        faults: set.path.map(|path| (path, set.faults)),
        readonly: arguments.readonly,
        basic: arguments.basic,
        ..Options::default()
    }
}

/// A session is recorded in a new file, and that is known before the workbench opens. The file is made later: the
/// program is started twice, see [`run_guarded`](dalembert_tui::terminal::run_guarded).
pub(super) fn can_be_recorded(path: &Path) -> Result<(), Failure> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let why = if path.symlink_metadata().is_ok() {
        Text::new(
            "{file} already exists and is never overwritten by a recording: choose another name, or delete it",
        )
    } else if folder.is_some_and(|folder| !folder.is_dir()) {
        Text::new("{file} cannot be recorded: folder not found")
    } else {
        return Ok(());
    };
    Err(Failure::input(why.with("file", path.display())))
}
