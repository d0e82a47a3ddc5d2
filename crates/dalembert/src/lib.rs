//! The program without its analyses: a binary links those it wants and calls [`main`].
//!
//! Every subcommand is a function from its arguments and a `Console` to the text it prints or
//! a `Failure`; what is printed where, and with which exit status, is decided here alone.

mod arguments;
mod commands;
mod completion;
mod console;
mod failure;
mod output;
mod problem;
mod questions;
pub mod request;
mod snippet;
mod solving;
mod values;

use std::{
    borrow::Cow,
    ffi::OsString,
    io::{self, Write as _},
    path::PathBuf,
    process::ExitCode,
};

use clap::FromArgMatches as _;
use clap_complete::CompleteEnv;
use dalembert_core::{Locale, Text, duplicates};
use dalembert_tui::{
    glyphs::filter_untrusted,
    settings::{self, Settings},
    terminal,
};

use crate::{
    arguments::{Arguments, Command, Format, GradeFormat, TableFormat},
    console::{Console, print_json},
    failure::Failure,
};

dalembert_core::messages!("../locales/pt-BR.ftl");

/// The whole program. Exit status: 0 solved; 1 refused, or a check failed; 2 bad input or usage.
pub fn main() -> ExitCode {
    // Without it a save that meets the limit ends the program.
    let _ = terminal::report_file_size_limit();
    let words: Vec<OsString> = std::env::args_os().collect();
    // The help is in the language that is asked for, so that is searched for before everything else.
    let path = settings::path();
    let (settings, faults) = path.as_deref().map_or_else(Default::default, settings::read);
    let language = console::requested_language(&words, settings.language);
    CompleteEnv::with_factory(|| arguments::command(language)).var(completion::VARIABLE).complete();
    let parsed = arguments::command(language)
        .try_get_matches_from(&words)
        .and_then(|matches| Arguments::from_arg_matches(&matches));
    match parsed {
        Ok(arguments) => {
            let console = Console::of_process(language, arguments.ascii);
            for entry in duplicates() {
                let words = Text::new(
                    "{title} is left out: another analysis has its id {id}; give it one of its own",
                );
                console.notify(
                    "warning: {words}",
                    &words.with("title", entry.about.title).with("id", entry.about.id),
                );
            }
            let set = Set { path, settings, faults };
            run(&arguments, set, &console).unwrap_or_else(|failure| {
                // A refusal stands in the result already.
                if arguments.command.as_ref().is_some_and(prints_json)
                    && !matches!(failure, Failure::Refused(_) | Failure::Output(_))
                {
                    let _ = print_json(&failure.json(&console.locale));
                }
                console.report(&failure)
            })
        }
        Err(err) => {
            // Help and version are no errors to clap either: it knows the stream and the status. An argument that it
            // repeats cannot drive the terminal.
            match filter_untrusted(&err.to_string()) {
                Cow::Borrowed(_) => _ = err.print(),
                Cow::Owned(harmless) => _ = write!(io::stderr(), "{harmless}"),
            }
            if err.use_stderr() && asks_for_json(&words) {
                let message = err.to_string();
                let why = message.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned();
                let _ = print_json(&Failure::input(Text::verbatim(why)).json(&Locale::english()));
            }
            ExitCode::from(u8::try_from(err.exit_code()).unwrap_or(2))
        }
    }
}

/// Returns true if another program reads what a command prints, errors included.
fn prints_json(command: &Command) -> bool {
    match command {
        Command::Solve(solve) => {
            commands::solve::format(&solve.form, solve.output.as_deref()) == Format::Json
        }
        Command::Check(check) => check.json,
        Command::Find(find) => find.json,
        Command::Optimise(optimise) => {
            commands::solve::format(&optimise.form, optimise.output.as_deref()) == Format::Json
        }
        Command::Sensitivity(sensitivity) => sensitivity.format == TableFormat::Json,
        Command::List(list) => list.json,
        Command::Show(show) => show.json,
        Command::Study(study) => study.json,
        Command::Verify(verify) => verify.json,
        Command::Grade(grade) => grade.format == GradeFormat::Json,
        _ => false,
    }
}

/// Returns true if words that are no command line ask for JSON.
fn asks_for_json(words: &[OsString]) -> bool {
    let is_json = |pair: &[OsString]| pair[0] == "--format" && pair[1] == "json";
    words.windows(2).any(is_json) || words.iter().any(|word| word == "--format=json" || word == "--json")
}

/// Settings of the user and the path of their file.
struct Set {
    path: Option<PathBuf>,
    settings: Settings,
    faults: Vec<settings::Fault>,
}

fn run(arguments: &Arguments, set: Set, console: &Console) -> Result<ExitCode, Failure> {
    let for_workbench = arguments.problem.is_some()
        || arguments.readonly
        || arguments.basic
        || arguments.no_mouse
        || arguments.record.is_some();
    if arguments.command.is_some() && for_workbench {
        return Err(Failure::input(
            "options of the workbench and a subcommand cannot be combined; use one of them",
        ));
    }
    match &arguments.command {
        None => commands::workbench::run(arguments, set, console),
        Some(Command::List(list)) => commands::list::run(list, console),
        Some(Command::Show(show)) => commands::show::run(show, console),
        Some(Command::New(new)) => commands::new::run(new, console),
        Some(Command::Solve(solve)) => commands::solve::run(solve, console),
        Some(Command::Confirm(confirm)) => commands::confirm::run(confirm, console),
        Some(Command::Check(check)) => commands::check::run(check, console),
        Some(Command::Find(find)) => commands::find::run(find, console),
        Some(Command::Optimise(optimise)) => commands::optimise::run(optimise, console),
        Some(Command::Sensitivity(sensitivity)) => commands::sensitivity::run(sensitivity, console),
        Some(Command::Study(study)) => commands::study::run(study, console),
        Some(Command::Verify(verify)) => commands::verify::run(verify, console),
        Some(Command::Variants(variants)) => commands::variants::run(variants, console),
        Some(Command::Grade(grade)) => commands::grade::run(grade, console),
        Some(Command::Schema(schema)) => commands::schema::run(schema, console),
        Some(Command::Serve(_)) => commands::serve::run(console),
        Some(Command::Field(field)) => commands::field::run(field, arguments, set, console),
        Some(Command::Replay(replay)) => commands::replay::run(replay, set, console),
        Some(Command::Tour(tour)) => commands::tour::run(tour, set, console),
        Some(Command::Completions(completions)) => commands::completions::run(completions),
        Some(Command::Man(man)) => commands::man::run(man, console),
        Some(Command::Info) => commands::info::run(&set, console),
        Some(Command::Settings) => commands::settings::run(console),
    }
}
