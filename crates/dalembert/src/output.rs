//! Files that results are written to: no problem, and nothing else unasked, is written over.

use std::{fs, path::Path};

use dalembert_core::{Text, file};
use dalembert_tui::files::{self, Before, FileError};

use crate::failure::Failure;

/// Checks that a result may be written to a path; `problem` is the file being solved, if it is one.
pub(crate) fn allowed(path: &Path, problem: &Path, force: bool) -> Result<(), Failure> {
    let Ok(there) = fs::canonicalize(path) else { return Ok(()) };
    let refuse = |why: &'static str| Err(Failure::input(Text::new(why).with("file", path.display())));
    if fs::canonicalize(problem).is_ok_and(|problem| problem == there) {
        return refuse("{file} is the problem itself: write its solution to another file");
    }
    if files::read(path).is_ok_and(|opened| file::is_problem(&opened.text)) {
        return refuse("{file} is a problem file: write the solution to another file");
    }
    if force {
        Ok(())
    } else {
        refuse("{file} already exists: choose another name, or use --force to overwrite")
    }
}

/// Writes the content of a file that is allowed.
pub(crate) fn write(path: &Path, content: impl AsRef<[u8]>, force: bool) -> Result<(), Failure> {
    // What was made since it was examined is kept too.
    let before = if force { Before::Whatever } else { Before::Absent };
    files::save(path, content, before).map(drop).map_err(|error: FileError| Failure::File(error))
}
