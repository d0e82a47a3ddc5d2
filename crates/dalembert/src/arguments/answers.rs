//! Arguments of the commands that ask how an answer depends on inputs.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::OutputForm;
use crate::completion;

#[derive(Debug, Args)]
pub(crate) struct Find {
    /// The id of an analysis, or a problem file; - reads the standard input
    #[arg(value_name = "ID|FILE|-", add = completion::problems())]
    pub(crate) problem: String,
    /// The input to find: mass, masses[2].radius
    #[arg(value_name = "INPUT", required_unless_present = "input_option", add = completion::numbers(""))]
    pub(crate) input: Option<String>,
    /// The answer or question, and the value or the limit that it is to have: 'natural_frequency=8.2 Hz', 'amplitude<=2 mm'
    #[arg(value_name = "ANSWER=VALUE", required_unless_present = "answer_option", add = completion::answers("="))]
    pub(crate) answer: Option<String>,
    /// The same as INPUT
    #[arg(long = "input", id = "input_option", value_name = "PATH", hide = true, conflicts_with = "input", add = completion::numbers(""))]
    pub(crate) input_option: Option<String>,
    /// The same as ANSWER=VALUE
    #[arg(long = "answer", id = "answer_option", value_name = "ANSWER=VALUE", hide = true, conflicts_with = "answer", add = completion::answers("="))]
    pub(crate) answer_option: Option<String>,
    /// Take the other inputs of this published case, counted from 1; default: case 1, unless --set sets them
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) case: Option<u32>,
    /// Change another input: mass="40 kg"
    #[arg(long, value_name = "PATH=VALUE", add = completion::settings())]
    pub(crate) set: Vec<String>,
    /// Least value of the range to search; default: 1/1000 to 1000 times the value of case 1
    #[arg(long, value_name = "VALUE", requires = "to", allow_hyphen_values = true)]
    pub(crate) from: Option<String>,
    /// Largest value of the range to search
    #[arg(long, value_name = "VALUE", requires = "from", allow_hyphen_values = true)]
    pub(crate) to: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
    /// Number of significant digits
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(crate) digits: Option<u8>,
}

#[derive(Debug, Args)]
pub(crate) struct Optimise {
    /// The id of an analysis, or a problem file; - reads the standard input
    #[arg(value_name = "ID|FILE|-", add = completion::problems())]
    pub(crate) problem: String,
    /// Take the other inputs of this published case, counted from 1; default: case 1, unless --set sets them
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) case: Option<u32>,
    /// Change an input; with a tolerance, the worst case counts: mass='40 kg ± 5 %'
    #[arg(long, value_name = "PATH=VALUE", add = completion::settings())]
    pub(crate) set: Vec<String>,
    /// An input to choose, in a range or from a list: stiffness='20 kN/m .. 80 kN/m', mass='2 kg; 3 kg; 5 kg'
    #[arg(long, value_name = "PATH=VALUES", add = completion::numbers("="))]
    pub(crate) vary: Vec<String>,
    /// Ask a question over inputs, answers and steps, which may be minimised or limited: 'price=2*m'
    #[arg(long, value_name = "NAME[=FORMULA]")]
    pub(crate) ask: Vec<String>,
    /// The answer or question to be made as small as possible; of two of these the Pareto front is found
    #[arg(long, value_name = "ANSWER", add = completion::answers(""))]
    pub(crate) minimise: Vec<String>,
    /// The answer or question to be made as large as possible
    #[arg(long, value_name = "ANSWER", add = completion::answers(""))]
    pub(crate) maximise: Vec<String>,
    /// A limit that is to be kept: 'amplitude < 0.2 mm'
    #[arg(long, value_name = "ANSWER<VALUE")]
    pub(crate) limit: Vec<String>,
    #[command(flatten)]
    pub(crate) form: OutputForm,
    /// Write to a new file: the problem with the optimum (.toml), or the worked solution by the extension
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Overwrite an existing file
    #[arg(long, requires = "output")]
    pub(crate) force: bool,
    /// Number of significant digits
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(crate) digits: Option<u8>,
}

#[derive(Debug, Args)]
pub(crate) struct Sensitivity {
    /// The id of an analysis, or a problem file; - reads the standard input
    #[arg(value_name = "ID|FILE|-", add = completion::problems())]
    pub(crate) problem: String,
    /// The answer; default: the main one
    #[arg(value_name = "ANSWER", add = completion::answers(""))]
    pub(crate) answer: Option<String>,
    /// Take the inputs of this published case, counted from 1; default: case 1, unless --set sets them
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) case: Option<u32>,
    /// Change an input; its tolerance may stand behind it: mass='40 kg ± 5 %'
    #[arg(long, value_name = "PATH=VALUE", add = completion::settings())]
    pub(crate) set: Vec<String>,
    /// Tolerance of an input, to either side, in place of that of the problem: mass='2 %', length='0.5 mm'
    #[arg(long, value_name = "PATH=VALUE", add = completion::numbers("="))]
    pub(crate) tolerance: Vec<String>,
    /// Number of samples of the Monte Carlo simulation
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(100..))]
    pub(crate) samples: Option<u64>,
    /// Seed of the samples: the same seed gives the same ones
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Output format
    #[arg(long, value_enum, default_value = "table")]
    pub(crate) format: TableFormat,
    /// Number of significant digits
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(crate) digits: Option<u8>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TableFormat {
    /// A table for a reader
    Table,
    /// Numbers for another program
    Json,
    /// A row for each input
    Csv,
}
