//! The points of a study on several threads, handed on in their order.

use std::{
    ops::Range,
    sync::mpsc::{Receiver, SyncSender, sync_channel},
    thread,
};

use dalembert_core::{
    Locale, Refusal, SolveError, Stop,
    study::{BLOCK, Evaluation, Rows, Study},
};

use crate::{StudyError, table};

/// Blocks that a thread may be ahead of the one that takes them.
const AHEAD: usize = 2;

/// Rows of a block, and their text.
#[derive(Debug, Default)]
pub struct SolvedBlock {
    /// The rows.
    pub rows: Rows,
    /// The same as CSV, where a table is written.
    pub text: String,
}

/// Solves a range of points on so many threads; `take` receives the blocks in their order, as text too where `locale` is
/// the language of their reasons.
///
/// # Errors
/// Those of `take`, after which nothing more is solved; [`Refusal::Stopped`].
///
/// # Panics
/// With the panic of an analysis.
pub fn solve(
    study: &Study<'_>,
    range: Range<u64>,
    threads: usize,
    locale: Option<&Locale>,
    stop: &Stop,
    take: &mut dyn FnMut(&SolvedBlock) -> Result<(), StudyError>,
) -> Result<(), StudyError> {
    let blocks = blocks(range);
    let threads = threads.clamp(1, blocks.len().max(1));
    thread::scope(|scope| {
        let mut workers = Vec::new();
        let mut receivers: Vec<Receiver<SolvedBlock>> = Vec::new();
        for first in 0..threads {
            let (sender, receiver) = sync_channel(AHEAD);
            receivers.push(receiver);
            let evaluation = study.evaluation()?;
            let own: Vec<Range<u64>> = blocks.iter().skip(first).step_by(threads).cloned().collect();
            workers.push(scope.spawn(move || work(evaluation, own, locale, stop, &sender)));
        }
        let mut taken = Ok(());
        for (n, _) in blocks.iter().enumerate() {
            // A thread that sends no more has been stopped or has panicked.
            let Ok(block) = receivers[n % threads].recv() else { break };
            taken = take(&block);
            if taken.is_err() {
                break;
            }
        }
        drop(receivers);
        let mut worked = Ok(());
        for worker in workers {
            match worker.join() {
                Ok(result) => worked = worked.and(result),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        taken.and(worked.map_err(|refusal| SolveError::Refused(refusal).into()))
    })
}

/// Solves the blocks of a thread until nobody takes them any more.
fn work(
    mut evaluation: Evaluation<'_>,
    blocks: Vec<Range<u64>>,
    locale: Option<&Locale>,
    stop: &Stop,
    sender: &SyncSender<SolvedBlock>,
) -> Result<(), Refusal> {
    for range in blocks {
        let mut block = SolvedBlock::default();
        evaluation.rows(range, &mut block.rows, stop)?;
        if let Some(locale) = locale {
            table::write_rows(&mut block.text, &block.rows, locale);
        }
        if sender.send(block).is_err() {
            break;
        }
    }
    Ok(())
}

/// The blocks of a range: their limits are the same in every range.
fn blocks(range: Range<u64>) -> Vec<Range<u64>> {
    let mut blocks = Vec::new();
    let mut from = range.start;
    while from < range.end {
        let to = (from / BLOCK as u64 + 1) * BLOCK as u64;
        blocks.push(from..to.min(range.end));
        from = to;
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_end_at_the_same_points_in_every_range() {
        assert_eq!(blocks(0..10_000), [0..4096, 4096..8192, 8192..10_000]);
        assert_eq!(blocks(5_000..9_000), [5_000..8192, 8192..9_000]);
        assert!(blocks(7..7).is_empty());
    }
}
