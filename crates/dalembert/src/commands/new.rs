//! `dalembert new`

use std::process::ExitCode;

use dalembert_core::{Text, file};

use crate::{
    arguments::New,
    console::{Console, print},
    failure::Failure,
    output, problem,
};

/// Writes the file that a problem begins with, empty or with the inputs of a published case.
pub(crate) fn run(new: &New, console: &Console) -> Result<ExitCode, Failure> {
    let entry = problem::analysis(&new.id)?;
    let case = new.case.map(|number| problem::case(entry, number)).transpose()?;
    let text = file::template(entry, case.as_ref(), &console.locale);
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
