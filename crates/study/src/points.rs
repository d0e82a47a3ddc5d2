//! Answers at given points: those of another program, which has its inputs as arrays.

use std::{
    panic,
    sync::{Mutex, PoisonError},
    thread,
};

use dalembert_core::{
    Entry, Record, SolveError, Stop, Text,
    study::BLOCK,
    vary::{self, InputLimits, VariedInput},
};

/// Answers at the points of arrays.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointAnswers {
    /// Answers in SI, a point a row; NaN where there is none.
    pub answers: Vec<f64>,
    /// The points without an answer, counted from 0, ascending, and why.
    pub refused: Vec<(usize, Text)>,
}

/// The inputs of a problem at these paths.
///
/// # Errors
/// A path that is no number among the inputs, by its place.
pub fn varied<'p>(
    record: &Record,
    paths: impl IntoIterator<Item = &'p str>,
) -> Result<Vec<VariedInput>, usize> {
    let known = vary::inputs(record);
    let find = |(n, path): (usize, &str)| known.iter().find(|input| input.path == path).cloned().ok_or(n);
    paths.into_iter().enumerate().map(find).collect()
}

/// Solves a problem by its plain reading with the values of `points` for these inputs, in SI, a point a row.
///
/// # Errors
/// An input that the analysis cannot vary; why the problem as given has no answer;
/// [`Refusal::Stopped`](dalembert_core::Refusal::Stopped).
///
/// # Panics
/// With the panic of an analysis.
pub fn solve(
    (entry, record): (&Entry, &Record),
    inputs: &[VariedInput],
    wanted: &[&str],
    points: &[f64],
    threads: usize,
    stop: &Stop,
) -> Result<PointAnswers, SolveError> {
    let vary: Vec<&str> = inputs.iter().map(|input| input.path.as_str()).collect();
    let (width, rows) = (inputs.len().max(1), points.len() / inputs.len().max(1));
    let limits = InputLimits::of(inputs.iter().map(|input| &input.measure));
    let mut answers = vec![f64::NAN; rows * wanted.len()];
    let mut refused = Vec::new();
    let blocks = points.chunks(BLOCK * width).zip(answers.chunks_mut(BLOCK * wanted.len().max(1)));
    let blocks = Mutex::new(blocks.enumerate());
    let work = || -> Result<Vec<(usize, Text)>, SolveError> {
        let mut evaluate = entry.prepare(record, &vary, wanted)?;
        let mut refused = Vec::new();
        loop {
            let next = blocks.lock().unwrap_or_else(PoisonError::into_inner).next();
            let Some((n, (points, answers))) = next else { return Ok(refused) };
            let first = refused.len();
            let mut refuse = |row: usize, why| refused.push((n * BLOCK + row, why));
            evaluate.sweep_with_reasons(points, answers, &mut refuse, stop)?;
            for (row, at) in limits.outside(points) {
                let why = outside(&inputs[at], points[row * width + at]);
                answers[row * wanted.len()..][..wanted.len()].fill(f64::NAN);
                let row = n * BLOCK + row;
                match refused[first..].iter_mut().find(|(known, _)| *known == row) {
                    Some(known) => known.1 = why,
                    None => refused.push((row, why)),
                }
            }
        }
    };
    thread::scope(|scope| {
        let threads = threads.clamp(1, rows.div_ceil(BLOCK).max(1));
        let workers: Vec<_> = (1..threads).map(|_| scope.spawn(work)).collect();
        refused.extend(work()?);
        for worker in workers {
            refused.extend(worker.join().unwrap_or_else(|fault| panic::resume_unwind(fault))?);
        }
        Ok::<_, SolveError>(())
    })?;
    refused.sort_by_key(|(row, _)| *row);
    // What was stopped in the last block is no result.
    stop.check().map_err(SolveError::Refused)?;
    Ok(PointAnswers { answers, refused })
}

/// Reason for which an input has no such value, in SI.
fn outside(input: &VariedInput, si: f64) -> Text {
    let text = format!("{} {}", input.unit.value(si), input.unit.ascii());
    let why = Text::new("{input} = {value}: {why}").with("input", &input.path);
    why.with("value", text.trim_end()).with_text("why", "outside the limits of this input")
}
