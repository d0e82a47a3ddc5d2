//! Problems solved from their texts.

use dalembert_core::{Solution, SolveError, Stop, file};

pub(crate) fn solve(text: &str) -> Result<Solution, SolveError> {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
    let record = problem.draft.read(&problem.entry.shape()).map_err(SolveError::Fields)?;
    problem.entry.solve(&record, &Stop::new())
}
