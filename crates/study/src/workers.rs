//! The points of a study on several threads, handed on in their order.

use std::{
    ops::Range,
    sync::mpsc::{Receiver, SyncSender, sync_channel},
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    Locale, Refusal, SolveError, Stop,
    study::{Evaluation, Rows, Study},
};

use crate::{StudyError, table};

/// Parts that a thread may be ahead of the one that takes them.
const AHEAD: usize = 2;
/// Points of a part: as many as give every thread several, and take about so long, within these.
const PARTS: u64 = 8;
const LONG: Duration = Duration::from_millis(20);
const POINTS: [u64; 2] = [16, 4096];

/// Rows of a part, and their text.
#[derive(Debug, Default)]
pub struct SolvedBlock {
    /// The rows.
    pub rows: Rows,
    /// The same as CSV, where a table is written.
    pub text: String,
}

/// Solves a range of points on so many threads; `take` receives the parts in their order, as text too where `locale` is
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
    let mut evaluation = study.evaluation()?;
    let each = time_of_point(&mut evaluation, &range, stop).map_err(SolveError::Refused)?;
    let parts = Parts::of(range, threads, each);
    let threads = (threads as u64).clamp(1, parts.count.max(1)) as usize;
    if threads == 1 {
        let mut block = SolvedBlock::default();
        for range in (0..parts.count).map(|n| parts.nth(n)) {
            block.solve(&mut evaluation, range, locale, stop).map_err(SolveError::Refused)?;
            take(&block)?;
        }
        return Ok(());
    }
    thread::scope(|scope| {
        let mut workers = Vec::new();
        let mut receivers: Vec<Receiver<SolvedBlock>> = Vec::new();
        for first in 0..threads {
            let (sender, receiver) = sync_channel(AHEAD);
            receivers.push(receiver);
            let evaluation = study.evaluation()?;
            let own = (first as u64..parts.count).step_by(threads).map(move |n| parts.nth(n));
            workers.push(scope.spawn(move || work(evaluation, own, locale, stop, &sender)));
        }
        let mut taken = Ok(());
        for n in 0..parts.count {
            // A thread that sends no more has been stopped or has panicked.
            let Ok(block) = receivers[n as usize % threads].recv() else { break };
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

impl SolvedBlock {
    fn solve(
        &mut self,
        evaluation: &mut Evaluation<'_>,
        points: Range<u64>,
        locale: Option<&Locale>,
        stop: &Stop,
    ) -> Result<(), Refusal> {
        evaluation.rows(points, &mut self.rows, stop)?;
        self.text.clear();
        if let Some(locale) = locale {
            table::write_rows(&mut self.text, &self.rows, locale);
        }
        Ok(())
    }
}

/// Time that the first point of a range takes, the second time.
fn time_of_point(
    evaluation: &mut Evaluation<'_>,
    range: &Range<u64>,
    stop: &Stop,
) -> Result<Duration, Refusal> {
    let first = range.start..(range.start + 1).min(range.end);
    let mut rows = Rows::default();
    evaluation.rows(first.clone(), &mut rows, stop)?;
    let begun = Instant::now();
    evaluation.rows(first, &mut rows, stop)?;
    Ok(begun.elapsed())
}

/// Solves the parts of a thread until nobody takes them any more.
fn work(
    mut evaluation: Evaluation<'_>,
    parts: impl Iterator<Item = Range<u64>>,
    locale: Option<&Locale>,
    stop: &Stop,
    sender: &SyncSender<SolvedBlock>,
) -> Result<(), Refusal> {
    for range in parts {
        let mut block = SolvedBlock::default();
        block.solve(&mut evaluation, range, locale, stop)?;
        if sender.send(block).is_err() {
            break;
        }
    }
    Ok(())
}

/// A range of points in parts, which end at multiples of a power of two.
#[derive(Clone, Copy, Debug)]
struct Parts {
    from: u64,
    to: u64,
    size: u64,
    count: u64,
}

impl Parts {
    /// Parts for so many threads of points that take so long each: few points of a slow analysis are solved by all of
    /// them, too.
    fn of(range: Range<u64>, threads: usize, each: Duration) -> Self {
        let Range { start: from, end: to } = range;
        let even = to.saturating_sub(from) / (PARTS * threads.max(1) as u64);
        let timely = (LONG.as_nanos() / each.as_nanos().max(1)).min(POINTS[1].into()) as u64;
        let size = even.min(timely).next_power_of_two().clamp(POINTS[0], POINTS[1]);
        let count = if from < to { to.div_ceil(size) - from / size } else { 0 };
        Self { from, to, size, count }
    }

    fn nth(&self, n: u64) -> Range<u64> {
        let begin = (self.from / self.size + n) * self.size;
        begin.max(self.from)..(begin + self.size).min(self.to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_cover_a_range_in_its_order() {
        let [quick, slow] = [Duration::from_nanos(60), Duration::from_millis(50)];
        for (range, threads) in
            [(0..10_000, 2), (5_000..9_001, 3), (0..201, 2), (7..8, 4), (0..3_000_000, 64)]
        {
            for each in [Duration::ZERO, quick, Duration::from_micros(100), slow] {
                let parts = Parts::of(range.clone(), threads, each);
                let all: Vec<Range<u64>> = (0..parts.count).map(|n| parts.nth(n)).collect();
                assert_eq!((all[0].start, all[all.len() - 1].end), (range.start, range.end));
                let follows =
                    |pair: &[Range<u64>]| pair[0].end == pair[1].start && pair[1].start < pair[1].end;
                assert!(all.windows(2).all(follows));
                let most = if each == slow { POINTS[0] } else { POINTS[1] };
                assert!(all.iter().all(|part| part.end - part.start <= most), "{all:?}");
            }
        }
        assert!(Parts::of(0..201, 2, quick).count >= 4, "a short sweep has work for both threads");
        assert!(Parts::of(0..1_000_000, 2, quick).count < 300, "a quick study has few parts");
        assert_eq!(Parts::of(7..7, 2, quick).count, 0);
    }
}
