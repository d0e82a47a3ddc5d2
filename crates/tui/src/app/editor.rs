//! The user's editor.

use std::{
    env,
    io::Write,
    path::{Path, PathBuf},
    process::Command,
};

use crate::files::FileError;

/// Default editor, present on every Unix system.
const USUAL: &str = "vi";

/// The command of the settings, of `$VISUAL` or of `$EDITOR`, the first that there is.
pub(super) fn command(set: Option<&str>) -> String {
    let named = |name: &str| env::var(name).ok().filter(|command| !command.trim().is_empty());
    set.map(str::to_owned)
        .or_else(|| named("VISUAL"))
        .or_else(|| named("EDITOR"))
        .unwrap_or_else(|| USUAL.to_owned())
}

/// End of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ended {
    Well,
    Badly,
    /// There is no such program.
    NotFound,
}

/// Runs the command on a file and waits. The command may have words of its own (`code --wait`), so the shell reads it;
/// the path stays one word whatever is in it.
pub(super) fn run(command: &str, path: &Path) -> Ended {
    /// Exit status of a shell that finds no such program.
    const NOT_FOUND: i32 = 127;
    let script = format!("{command} \"$1\"");
    let status = Command::new("sh").args(["-c", &script, "sh"]).arg(path).status();
    match status.map(|status| (status.success(), status.code())) {
        Ok((true, _)) => Ended::Well,
        Ok((_, Some(NOT_FOUND))) => Ended::NotFound,
        _ => Ended::Badly,
    }
}

/// A text as a file that only the user can read; it stays until it is removed.
pub(super) fn copy(text: &str) -> Result<PathBuf, FileError> {
    let failed = |source| FileError::Failed { action: "write", path: env::temp_dir(), source };
    let mut file =
        tempfile::Builder::new().prefix("dalembert-").suffix(".toml").tempfile().map_err(failed)?;
    file.write_all(text.as_bytes()).map_err(failed)?;
    let (_, path) = file.keep().map_err(|error| failed(error.error))?;
    Ok(path)
}
