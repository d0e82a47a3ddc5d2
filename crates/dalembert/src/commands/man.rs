//! `dalembert man`

use std::process::ExitCode;

use dalembert_core::{Text, nearest};

use crate::{
    arguments::{self, ManPage},
    console::{Console, print},
    failure::Failure,
};

/// Prints the manual page of the program or of a subcommand, in roff.
pub(crate) fn run(man: &ManPage, console: &Console) -> Result<ExitCode, Failure> {
    let mut program = arguments::command(console.locale.language);
    program.build();
    let command = match &man.command {
        None => program,
        Some(name) => {
            let found = program.find_subcommand(name).cloned();
            found.ok_or_else(|| {
                let known = program.get_subcommands().map(clap::Command::get_name);
                let why = match nearest(name, known) {
                    Some(near) => Text::new("there is no subcommand `{name}`; did you mean `{near}`?")
                        .with("near", near),
                    None => Text::new("there is no subcommand `{name}`; see `dalembert --help`"),
                };
                Failure::input(why.with("name", name))
            })?
        }
    };
    let mut page = Vec::new();
    clap_mangen::Man::new(command).render(&mut page).map_err(Failure::Output)?;
    print(&String::from_utf8_lossy(&page))?;
    Ok(ExitCode::SUCCESS)
}
