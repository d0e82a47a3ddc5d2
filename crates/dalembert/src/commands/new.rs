//! `dalembert new`

use std::process::ExitCode;

use dalembert_core::{Locale, Text, file};

use crate::{
    arguments::New,
    console::{Console, print},
    failure::Failure,
    output, problem,
};

/// Writes the file that a problem begins with, empty or with the inputs of a published case.
pub(crate) fn run(new: &New, console: &Console) -> Result<ExitCode, Failure> {
    let text = text(&new.id, new.case, &console.locale)?;
    match &new.output {
        None => print(&text)?,
        Some(path) if path.symlink_metadata().is_ok() && !new.force => {
            let why = Text::new("{file} already exists: choose another name, or use --force to overwrite");
            return Err(Failure::input(why.with("file", path.display())));
        }
        Some(path) => output::write(path, &text, new.force)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// The text of the file.
pub(crate) fn text(id: &str, case: Option<u32>, locale: &Locale) -> Result<String, Failure> {
    let entry = problem::analysis(id)?;
    let case = case.map(|number| problem::case(entry, number)).transpose()?;
    Ok(file::template(entry, case.as_ref(), locale))
}
