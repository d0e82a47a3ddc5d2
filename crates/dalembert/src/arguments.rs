//! Arguments and options of the command line.

mod answers;
mod teaching;

use std::path::PathBuf;

use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use dalembert_core::{Language, Locale, Text};
use dalembert_report::Parts;

pub(crate) use self::{
    answers::{Find, Optimise, Sensitivity, TableFormat},
    teaching::{Grade, GradeFormat, Variants, VariantsFormat},
};
use crate::completion;

/// A machine-dynamics workbench: pick a problem, edit its inputs in any units, see the worked solution.
#[derive(Debug, Parser)]
#[command(
    name = "dalembert",
    version,
    after_help = "Without arguments: the workbench in a terminal, a worked problem elsewhere. Exit status: 0 solved; 1 refused, or a check failed; 2 bad input or usage."
)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of the command line")]
pub(crate) struct Arguments {
    /// A problem file or the id of an analysis, to open in the workbench
    #[arg(value_name = "FILE", add = completion::problems())]
    pub(crate) problem: Option<String>,
    /// Open the file read-only
    #[arg(long)]
    pub(crate) readonly: bool,
    /// Record the session to a new file, for `dalembert replay`
    #[arg(long, value_name = "FILE")]
    pub(crate) record: Option<PathBuf>,
    /// Language of the output
    #[arg(long, global = true, value_name = "LANGUAGE", value_parser = Language::ALL.map(Language::tag))]
    pub(crate) lang: Option<String>,
    /// Print ASCII characters only
    #[arg(long, global = true)]
    pub(crate) ascii: bool,
    /// For serial lines and screen readers: ASCII, no colours, no frames, no mouse, animations paused
    #[arg(long)]
    pub(crate) basic: bool,
    /// Leave the mouse to the terminal
    #[arg(long)]
    pub(crate) no_mouse: bool,
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// List the analyses
    List(List),
    /// Show the inputs and answers of an analysis
    Show(Show),
    /// Begin a problem file, with comments on every input
    New(New),
    /// Solve a problem and print its worked solution
    Solve(Solve),
    /// Solve the problem in a calculation note again, and compare every printed line of data, answers and working
    Confirm(Confirm),
    /// Check your own answers, and find the likeliest cause of a wrong one
    Check(Check),
    /// Find the values of an input with which an answer is a wanted one, or within a limit
    Find(Find),
    /// Rank the inputs by their effect on an answer, and combine their tolerances
    Sensitivity(Sensitivity),
    /// Choose inputs so that an answer is as small or as large as possible under limits
    Optimise(Optimise),
    /// Solve a problem at many values of its inputs: grids, samples, statistics
    Study(Study),
    /// Check all published answers
    Verify(Verify),
    /// Write variants of an exercise with other data, their keys, and files for learning platforms
    Variants(Variants),
    /// Grade the answers of a class
    Grade(Grade),
    /// Print the JSON Schema of a problem file, for an editor, or of results
    Schema(Schema),
    /// Answer requests of another program
    Serve(Serve),
    /// Balance a rotor in the field, step by step
    Field(Field),
    /// Replay a recorded or written session of the workbench
    Replay(Replay),
    /// Watch a tour of 90 seconds in the workbench; any key takes over
    Tour(Tour),
    /// Print a completion script for a shell
    Completions(Completions),
    /// Print the manual page
    Man(ManPage),
    /// Show version, files and folders, and the capabilities of the terminal
    Info,
    /// Print a settings template
    Settings,
}

#[derive(Debug, Args)]
pub(crate) struct Field {
    /// Job file: an existing job is continued, a new one is begun under this name
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,
    /// Record the session to a new file, for `dalembert replay`
    #[arg(long, value_name = "FILE")]
    pub(crate) record: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct List {
    /// Words in any order and either language, of titles, topics, books, cases, inputs and answers
    pub(crate) filter: Vec<String>,
    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Show {
    /// The id of an analysis, such as vibration/rotating-unbalance
    #[arg(add = completion::ids())]
    pub(crate) id: String,
    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct New {
    /// The id of an analysis, such as vibration/rotating-unbalance
    #[arg(add = completion::ids())]
    pub(crate) id: String,
    /// Fill in the inputs of this published case, counted from 1; without it the values are left empty
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) case: Option<u32>,
    /// Write to a new file
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Overwrite an existing file
    #[arg(long, requires = "output")]
    pub(crate) force: bool,
}

/// Form of a worked solution.
#[derive(Debug, Args)]
pub(crate) struct OutputForm {
    /// Output format; default: by the file extension, otherwise text
    #[arg(long, value_enum)]
    pub(crate) format: Option<Format>,
    /// Parts of the worked solution; default: full
    #[arg(long, value_enum, value_name = "PARTS")]
    pub(crate) parts: Option<PartsChoice>,
    /// The table to print as CSV: answers, inputs, steps, checks, table-1, plot-1
    #[arg(long, value_name = "NAME", default_value = "answers")]
    pub(crate) table: String,
}

#[derive(Debug, Args)]
pub(crate) struct Solve {
    /// The id of an analysis, or a problem file; - reads the standard input
    #[arg(value_name = "ID|FILE|-", add = completion::problems())]
    pub(crate) problem: String,
    /// Start from the inputs of this published case, counted from 1; without it, --set starts from empty
    /// inputs, and an id alone solves case 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) case: Option<u32>,
    /// Change an input: mass="40 kg", masses[2].radius="0.1 m"; a table can be read from a file: samples=@data.csv
    #[arg(long, value_name = "PATH=VALUE", add = completion::settings())]
    pub(crate) set: Vec<String>,
    /// Define a quantity for formulas in inputs and questions: nu=0.3, 'G=E/(2*(1+nu))'
    #[arg(long = "let", value_name = "NAME=FORMULA")]
    pub(crate) define: Vec<String>,
    /// Ask a question over inputs, answers and steps: 'peak to peak=2*X'; or one of the usual ones, which `show` lists:
    /// rms_velocity
    #[arg(long, value_name = "NAME[=FORMULA]")]
    pub(crate) ask: Vec<String>,
    /// Give an answer whose value is known, for an input that is to be found: --set 'mass=?' --given
    /// 'natural_frequency=8.2 Hz'
    #[arg(long, value_name = "ANSWER=VALUE", add = completion::answers("="))]
    pub(crate) given: Vec<String>,
    /// Solve the same problem with an input changed beside it: 'weighted.mass=m + 2 kg'
    #[arg(long, value_name = "NAME.INPUT=FORMULA")]
    pub(crate) configuration: Vec<String>,
    /// Print the working of this answer alone: the steps that lead to it; of one of several by its row: 'frequency[2]'
    #[arg(long, value_name = "ANSWER", add = completion::answers(""))]
    pub(crate) answer: Vec<String>,
    #[command(flatten)]
    pub(crate) form: OutputForm,
    /// Write to a new file, by its extension: .html, .tex, .typ, .md, .docx, .txt, .json or .csv; Markdown and Typst write their figures beside it
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Overwrite existing files; never a problem file
    #[arg(long, requires = "output")]
    pub(crate) force: bool,
    /// Refuse a number without a unit where one is needed, instead of assuming one with a warning
    #[arg(long)]
    pub(crate) strict: bool,
    /// Number of significant digits
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(crate) digits: Option<u8>,
    /// Unit of an answer, or of all answers of a name or a quantity: amplitude=um, force=lbf
    #[arg(long, value_name = "ANSWER=UNIT", add = completion::answers("="))]
    pub(crate) unit: Vec<String>,
    /// Units of everything that is shown: auto (the system that the inputs show), as-typed, SI, in-lbf-s, ft-slug-s,
    /// mm-t-s
    #[arg(long, value_name = "SYSTEM")]
    pub(crate) units: Option<String>,
    /// Line of the title block: project, author, checker, date or revision, as in author='A. Silva'
    #[arg(long, value_name = "KEY=TEXT")]
    pub(crate) title_block: Vec<String>,
}

#[derive(Debug, Args)]
pub(crate) struct Confirm {
    /// Note that `dalembert solve --output` wrote: HTML, LaTeX, Typst or Markdown
    #[arg(value_name = "NOTE")]
    pub(crate) note: PathBuf,
}

#[derive(Debug, Args)]
pub(crate) struct Check {
    /// The id of an analysis, or a problem file; - reads the standard input
    #[arg(value_name = "ID|FILE|-", add = completion::problems())]
    pub(crate) problem: String,
    /// Your answers, with their units; a number alone is in the unit of the answer: 'amplitude=19.5 mm'
    #[arg(value_name = "ANSWER=VALUE", required = true, add = completion::answers("="))]
    pub(crate) answers: Vec<String>,
    /// Take the inputs of this published case, counted from 1; default: case 1, unless --set sets them
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) case: Option<u32>,
    /// Change an input: mass="40 kg"
    #[arg(long, value_name = "PATH=VALUE", add = completion::settings())]
    pub(crate) set: Vec<String>,
    /// Print what is correct too
    #[arg(long)]
    pub(crate) reveal: bool,
    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of the command line")]
pub(crate) struct Study {
    /// A study plan, a problem file or the id of an analysis
    #[arg(value_name = "PLAN|FILE|ID", add = completion::problems())]
    pub(crate) subject: String,
    /// Vary an input of a problem: speed='600..1800 rpm:13', speed=10..1000:31:log, mass='40 kg; 45 kg',
    /// mass='normal(2 %)', mass='uniform(38 kg; 42 kg)'
    #[arg(long, value_name = "INPUT=VALUES", add = completion::numbers("="))]
    pub(crate) vary: Vec<String>,
    /// The answers, separated by commas; default: every answer that is a number
    #[arg(long, value_name = "NAMES", value_delimiter = ',', add = completion::answers(""))]
    pub(crate) answers: Vec<String>,
    /// A limit whose probability of being exceeded is wanted: 'amplitude > 0.2 mm'
    #[arg(long, value_name = "ANSWER>VALUE")]
    pub(crate) limit: Vec<String>,
    /// Number of samples of the inputs that have a distribution
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) samples: Option<u64>,
    /// Method by which samples are drawn
    #[arg(long, value_name = "METHOD", value_parser = ["monte-carlo", "latin-hypercube", "sobol"])]
    pub(crate) sampling: Option<String>,
    /// Seed of the samples: the same seed gives the same ones
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Sobol' indices: shares of the inputs in the variance of each answer
    #[arg(long)]
    pub(crate) sobol_indices: bool,
    /// Two inputs over which the answers are mapped, separated by a comma; default: the first two that vary
    #[arg(long, value_name = "INPUT,INPUT")]
    pub(crate) map: Vec<String>,
    /// Write all points to a CSV or Parquet file; a run that was broken off goes on where it ended
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Overwrite an existing file
    #[arg(long, requires = "output")]
    pub(crate) force: bool,
    /// Solve one of several parts of the points, into a file beside that of the whole: 3/16
    #[arg(long, value_name = "NUMBER/OF", requires = "output")]
    pub(crate) shard: Option<String>,
    /// Merge the shards into the file
    #[arg(long, requires = "output", conflicts_with = "shard")]
    pub(crate) merge: bool,
    /// Have so many parts solved by Slurm, as a job array, and merge them
    #[arg(long, value_name = "PARTS", requires = "output", conflicts_with_all = ["shard", "merge"], value_parser = clap::value_parser!(u64).range(1..=10_000))]
    pub(crate) slurm: Option<u64>,
    /// An option of sbatch: --slurm-option=--partition=long
    #[arg(long, value_name = "OPTION", requires = "slurm", allow_hyphen_values = true)]
    pub(crate) slurm_option: Vec<String>,
    /// Number of threads; default: one for each processor
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub(crate) threads: Option<u32>,
    /// Write the summary to a file: text, Markdown, HTML, LaTeX or Typst, by its extension
    #[arg(long, value_name = "FILE")]
    pub(crate) report: Option<PathBuf>,
    /// Print the summary as JSON
    #[arg(long)]
    pub(crate) json: bool,
    /// Print the plan as a file and solve nothing
    #[arg(long)]
    pub(crate) print_plan: bool,
    /// Number of significant digits
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(crate) digits: Option<u8>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// The worked solution for a terminal or a printer
    Text,
    /// The worked solution in Markdown
    Markdown,
    /// The worked solution as one HTML page, with figures
    Html,
    /// The worked solution in LaTeX, with figures
    Latex,
    /// The worked solution in Typst
    Typst,
    /// The worked solution as a document of Word, with equations and figures
    #[cfg(feature = "word")]
    Docx,
    /// Inputs, answers and checks for another program
    Json,
    /// One table for a spreadsheet
    Csv,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PartsChoice {
    /// Statement, data and drawing, without what is to be found
    Statement,
    /// Statement, data, drawing, answers and checks, without the working
    Answers,
    /// Everything
    Full,
}

impl From<PartsChoice> for Parts {
    fn from(choice: PartsChoice) -> Self {
        match choice {
            PartsChoice::Statement => Self::Statement,
            PartsChoice::Answers => Self::Answers,
            PartsChoice::Full => Self::Full,
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct Verify {
    /// Words in any order and either language, of titles, topics, books, cases, inputs and answers
    pub(crate) filter: Vec<String>,
    /// List the answers that no check covers, each with the reason
    #[arg(long)]
    pub(crate) uncovered: bool,
    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Schema {
    /// The id of an analysis, such as vibration/rotating-unbalance; results for what `solve --format json` prints
    #[arg(add = completion::ids())]
    pub(crate) id: String,
}

#[derive(Debug, Args)]
pub(crate) struct Serve {
    /// Read JSON lines from standard input and write one to standard output for each
    #[arg(long, required = true)]
    pub(crate) stdio: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Replay {
    /// Session file, as written by --record; - reads the standard input
    pub(crate) file: String,
    /// Speed factor relative to the typing speed
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = speed)]
    pub(crate) speed: f64,
    /// Replay at once without a terminal and print the marked screens, or the last one
    #[arg(long)]
    pub(crate) headless: bool,
    /// Write the marked screens as SVG to this folder instead of printing them
    #[arg(long, value_name = "FOLDER", requires = "headless")]
    pub(crate) pictures: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Tour {
    /// Speed factor
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = speed)]
    pub(crate) speed: f64,
}

/// Between a hundredth and a hundredfold.
fn speed(text: &str) -> Result<f64, String> {
    let number = text.replace(',', ".").parse().ok();
    number
        .filter(|speed| (0.01..=100.0).contains(speed))
        .ok_or_else(|| "write a number from 0.01 to 100".to_owned())
}

#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// The shell
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
pub(crate) struct ManPage {
    /// Subcommand; default: the whole program
    pub(crate) command: Option<String>,
}

/// The grammar of the command line, its help in a language. The headings that clap writes itself stay English.
pub(crate) fn command(language: Language) -> clap::Command {
    translated(Arguments::command(), language)
}

fn translated(command: clap::Command, language: Language) -> clap::Command {
    let locale = match language {
        Language::English => return command,
        Language::Portuguese => Locale::portuguese(),
    };
    let say = |words: &clap::builder::StyledStr| Text::new(words.to_string()).render(&locale);
    let command = match command.get_about() {
        Some(about) => {
            let about = say(about);
            command.about(about)
        }
        None => command,
    };
    let command = match command.get_after_help() {
        Some(after) => {
            let after = say(after);
            command.after_help(after)
        }
        None => command,
    };
    command
        .mut_args(|argument| match argument.get_help() {
            Some(help) => {
                let help = say(help);
                argument.help(help)
            }
            None => argument,
        })
        .mut_subcommands(|inner| translated(inner, language))
}

#[cfg(test)]
mod tests {
    use dalembert_core::text::is_translated;

    use super::*;

    #[test]
    fn the_grammar_is_sound() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn the_help_is_translated() {
        fn untranslated(command: &clap::Command, missing: &mut Vec<String>) {
            let helps = command.get_arguments().filter_map(clap::Arg::get_help);
            for words in command.get_about().into_iter().chain(command.get_after_help()).chain(helps) {
                if !is_translated(&words.to_string()) {
                    missing.push(format!("{} = {words}", dalembert_core::text::key(&words.to_string())));
                }
            }
            command.get_subcommands().for_each(|inner| untranslated(inner, missing));
        }
        let mut missing = Vec::new();
        untranslated(&Arguments::command(), &mut missing);
        assert!(missing.is_empty(), "{}", missing.join("\n"));
    }
}
