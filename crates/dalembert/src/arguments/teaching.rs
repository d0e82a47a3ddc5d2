//! Arguments of the commands for a class.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::completion;

#[derive(Debug, Args)]
pub(crate) struct Variants {
    /// The id of an analysis, or a problem file; - reads the standard input
    #[arg(value_name = "ID|FILE|-", add = completion::problems())]
    pub(crate) problem: String,
    /// Vary this published case, counted from 1; default: case 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) case: Option<u32>,
    /// Seed of the data: the same seed gives the same variants
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Number of variants
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(crate) count: u32,
    /// One variant for the student of this id, which is the seed
    #[arg(long, value_name = "ID", conflicts_with_all = ["seed", "count"])]
    pub(crate) student: Vec<String>,
    /// Tolerance of the answers: a share of their values
    #[arg(long, value_name = "SHARE", default_value = "0.5 %")]
    pub(crate) tolerance: String,
    /// Output format
    #[arg(long, value_enum, default_value = "md")]
    pub(crate) format: VariantsFormat,
    /// Write to this folder: a sheet and a worked key for each variant, the key and its CSV, or the files of a learning platform
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Overwrite existing files
    #[arg(long, requires = "out")]
    pub(crate) force: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum VariantsFormat {
    /// Markdown
    Md,
    /// HTML
    Html,
    /// LaTeX
    Tex,
    /// Typst
    Typ,
    /// Answers for a spreadsheet
    Csv,
    /// Questions for Moodle
    Moodle,
    /// A QTI 2.1 package
    Qti,
    /// A question folder for PrairieLearn
    Prairielearn,
}

#[derive(Debug, Args)]
pub(crate) struct Grade {
    /// Answers in CSV: columns of students, answer and value; - reads the standard input
    #[arg(value_name = "FILE|-")]
    pub(crate) answers: String,
    /// The id of an analysis, or a problem file
    #[arg(long, value_name = "ID|FILE", add = completion::problems())]
    pub(crate) problem: String,
    /// Grade answers to this published case, counted from 1; default: case 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) case: Option<u32>,
    /// Column of ids whose students have variants of their own, as written by `dalembert variants --student`
    #[arg(long, value_name = "COLUMN")]
    pub(crate) seed_column: Option<String>,
    /// Tolerance of the answers: a share of their values
    #[arg(long, value_name = "SHARE", default_value = "0.5 %")]
    pub(crate) tolerance: String,
    /// Credit of outcomes in place of right=1, rounded-early=0.9, few-digits=0.5, carried-forward=0.8, sign-or-unit=0.5
    #[arg(long, value_name = "OUTCOME=WEIGHT", default_value = "")]
    pub(crate) weights: String,
    /// The longest search for the causes of the wrong answers of one student, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=3600))]
    pub(crate) time_limit: u64,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: GradeFormat,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum GradeFormat {
    /// Tables for a reader
    Text,
    /// A row for each answer
    Csv,
    /// Answers, points and statistics for another program
    Json,
}
