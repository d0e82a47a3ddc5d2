//! A study for the workbench: the same points and statistics as on the command line, shown while they come.

use std::{
    path::Path,
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    Answer, Entry, Plot, Record, Refusal, Solution, SolveError, Stop, Text,
    study::{Bands, Curves, Design, Study, StudyPlan, Summary, find_target},
};
use dalembert_study::{StudyError, data, workers};

/// Interval at which the points so far are reported, which takes at most one part of so many of the time.
const REPORT_EVERY: Duration = Duration::from_millis(200);
const REPORT_SHARE: u32 = 20;

/// Result of a study, or of the points that are solved so far.
#[derive(Clone, Debug, Default)]
pub struct StudyResult {
    /// The points that are solved, where more are to come.
    pub progress: Option<StudyProgress>,
    /// Numbers found, in words.
    pub found: Vec<Text>,
    /// More of them, where there is room.
    pub details: Vec<Text>,
    /// Remarks on them.
    pub remarks: Vec<Text>,
    /// Curves or distributions, one for each answer.
    pub plots: Vec<Plot>,
}

/// Points of a study that are solved, and the time that they took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StudyProgress {
    /// Points that are solved.
    pub done: u64,
    /// All points.
    pub points: u64,
    /// Time since the study was begun.
    pub elapsed: Duration,
}

impl StudyProgress {
    /// Points solved in a second.
    pub fn rate(&self) -> f64 {
        self.done as f64 / self.elapsed.as_secs_f64().max(f64::MIN_POSITIVE)
    }

    /// Time that the points to come will take, s.
    pub fn left(&self) -> f64 {
        (self.points - self.done) as f64 / self.rate().max(f64::MIN_POSITIVE)
    }
}

/// Carries out a plan on all cores. Files that it names are in `folder`; `answers` are those of the problem as it is.
///
/// # Errors
/// Everything in the plan that does not fit the problem; why this has no answer; [`Refusal::Stopped`].
pub(super) fn carry_out(
    (entry, record): (&Entry, &Record),
    answers: &[Answer],
    (plan, folder): (&StudyPlan, &Path),
    stop: &Stop,
    report: &dyn Fn(StudyResult),
) -> Result<StudyResult, SolveError> {
    let read = |name: &str| data::read(&folder.join(name));
    let design = Design::new(plan, record, &read).map_err(SolveError::Fields)?;
    let solution = Solution { answers: answers.to_vec(), ..Solution::default() };
    let study = Study::new(entry, record, plan, design, &solution)?;
    let points = study.design.points();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let mut sums = study.accumulator(0);
    let (mut curves, mut bands) = (Curves::of(&study), Bands::of(&study));
    let begun = Instant::now();
    let (mut reported, mut pause, mut done) = (begun, REPORT_EVERY, 0);
    let solved = workers::solve(&study, 0..points, threads, None, stop, &mut |block| {
        sums.take(&block.rows);
        done += block.rows.len() as u64;
        if let Some(curves) = &mut curves {
            block.rows.iter().for_each(|row| curves.push(&row));
        }
        if let Some(bands) = &mut bands {
            block.rows.iter().for_each(|row| bands.push(&row));
        }
        if done < points && reported.elapsed() >= pause {
            let from = Instant::now();
            let progress = StudyProgress { done, points, elapsed: begun.elapsed() };
            report(StudyResult {
                progress: Some(progress),
                ..result(&study, &sums.clone().summary(), (curves.as_ref(), bands.as_ref()))
            });
            reported = Instant::now();
            pause = REPORT_EVERY.max(REPORT_SHARE * from.elapsed());
        }
        Ok(())
    });
    match solved {
        Ok(()) => Ok(result(&study, &sums.summary(), (curves.as_ref(), bands.as_ref()))),
        Err(StudyError::Solve(error)) => Err(error),
        Err(error) => Err(Refusal::NoAnswer(error.text()).into()),
    }
}

/// Finds where an answer takes a wanted value.
///
/// # Errors
/// Why the problem as given has no answer; [`Refusal::Stopped`].
pub(super) fn find(
    (entry, record): (&Entry, &Record),
    input: (&str, [f64; 2]),
    answer: (&Answer, f64),
    stop: &Stop,
) -> Result<StudyResult, SolveError> {
    let mut target = find_target(entry, record, input, answer, stop)?;
    let remarks = target.remarks.split_off(target.values.len());
    Ok(StudyResult {
        found: target.remarks,
        remarks,
        plots: target.plot.into_iter().collect(),
        ..StudyResult::default()
    })
}

fn result(
    study: &Study<'_>,
    summary: &Summary,
    (curves, bands): (Option<&Curves<'_>>, Option<&Bands<'_>>),
) -> StudyResult {
    let is_drawn = study.design.drawn().next().is_some();
    let all = || study.answers.iter().zip(&summary.answers).filter(|(_, of)| of.count > 0);
    let (mut found, mut details) = (Vec::new(), Vec::new());
    for (answer, of) in all() {
        if study.answers.len() > 1 {
            found.push(answer.title());
            details.extend(is_drawn.then(|| answer.title()));
        }
        found.extend(if is_drawn { of.words(answer) } else { vec![of.extent(answer)] });
        found.extend(of.words_of_limits(answer));
        details.extend(is_drawn.then(|| of.details(answer)).into_iter().flatten());
    }
    let mut remarks = curves.map_or_else(Vec::new, Curves::remarks);
    if summary.refused > 0 {
        let refused = Text::new("{refused} of {all} have no answer");
        remarks.push(refused.with("refused", summary.refused).with("all", summary.points));
    }
    // The reasons of a curve are given with its ranges.
    if let (Some((point, why)), None) = (&summary.first_refusal, curves) {
        remarks.push(Text::new("point {point}: {why}").with("point", point).with_text("why", why.clone()));
    }
    let plots = match (curves, bands) {
        (Some(curves), _) => curves.plots(),
        (None, Some(bands)) => bands.plots(),
        (None, None) => all().filter_map(|(answer, of)| of.distribution(answer)).collect(),
    };
    StudyResult { progress: None, found, details, remarks, plots }
}
