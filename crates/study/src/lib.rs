//! Studies of any size, in files: the points of a [`Study`](dalembert_core::study::Study) are solved by all cores and
//! written as they come.
//!
//! | module | what it does |
//! |---|---|
//! | [`workers`] | solves the points on several threads and hands them on in their order |
//! | [`table`] | writes rows as CSV and reads them back, to the last bit |
//! | [`output`] | writes a table or a shard of it, goes on with one that was broken off, merges shards |
//! | [`ranges`] | finds the values of an input with which an answer is within a limit, and proves them |
//! | [`slurm`] | has the shards solved by a cluster |
//! | [`points`] | solves points that are given as arrays |
//! | [`data`] | reads files that a plan names |
//! | [`parquet`] | reads and writes Parquet, where the program is built with it |
//! | [`plans`] | reads and writes plans |
//! | [`spread`] | draws inputs within their tolerances, for the spread of an answer |
//!
//! A table is the same to the last byte on any number of threads, broken off and resumed or not, and merged from any
//! number of shards: a row is a function of its number alone, and the statistics are taken from the rows in their order.

pub mod data;
pub mod output;
pub mod parquet;
pub mod plans;
pub mod points;
pub mod ranges;
pub mod slurm;
pub mod spread;
pub mod table;
pub mod workers;

use std::{io, path::PathBuf};

use dalembert_core::Text;

dalembert_core::messages!("../locales/pt-BR.ftl");

/// Reason for which a study was not carried out, or not to its end.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// A file cannot be read or written.
    #[error("{}: {error}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        error: io::Error,
    },
    /// A file or a request that does not fit the study.
    #[error("{}", .0.english())]
    Unfit(Text),
    /// The inputs have no answer, or the analysis cannot vary them.
    #[error("{0}")]
    Solve(#[from] dalembert_core::SolveError),
}

impl StudyError {
    /// A function that names the file of an error of the system.
    pub(crate) fn of_file(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |error| Self::File { path, error }
    }

    /// Sentence for the user.
    pub fn text(&self) -> Text {
        match self {
            Self::File { path, error } => {
                Text::new("{file}: {why}").with("file", path.display()).with("why", error)
            }
            Self::Unfit(why) => why.clone(),
            Self::Solve(error) => Text::verbatim(error),
        }
    }
}
