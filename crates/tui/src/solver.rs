//! Solving beside the thread that draws: the newest job wins, older ones are reported to stop, panics are contained.

use std::{
    io,
    sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, mpsc},
    thread,
};

use dalembert_core::{
    Entry, Record, Refusal, Solution, SolveError, Stop,
    cases::{self, Case, Verdict},
};

use crate::{
    ask::{Question, Reply},
    terminal::{Fault, catch_panic, fault},
};

/// Threads beyond the first are started only when all are held by jobs that do not look for their stop.
const MOST_THREADS: usize = 4;
/// So many analyses wait for their cases to be compared.
const MOST_WISHES: usize = 3;

/// Something to be solved. Of two jobs, the one with the larger generation is newer.
#[derive(Clone, Debug)]
pub struct Job {
    /// Generation number.
    pub generation: u64,
    /// Work to do.
    pub work: Work,
}

/// Work of a job.
#[derive(Clone, Debug)]
pub enum Work {
    /// Solves a problem.
    Solve(&'static Entry, Record),
    /// Commits a fault.
    Fault(Fault),
    /// Answers what is asked beside the results.
    Ask(Question),
}

/// Outcome of a job.
#[derive(Clone, Debug)]
pub struct JobOutcome {
    /// The number of the job.
    pub generation: u64,
    /// Solution; `None` for a job that computes none.
    pub result: Result<Option<Solution>, JobFailure>,
    /// Reply to a question beside the results, which may be [partial](Reply::is_partial).
    pub reply: Option<Reply>,
}

/// Reason for which nothing was found.
#[derive(Clone, Debug, PartialEq)]
pub enum JobFailure {
    /// The problem has no answer, or its inputs may not stand together.
    Unsolved(SolveError),
    /// The analysis panicked: a fault of the program.
    Fault(String),
}

/// A published case, and how its printed answers compare with ours.
#[derive(Clone, Debug)]
pub struct CheckedCase {
    /// The case.
    pub case: Case,
    /// `None` while it has not been solved.
    pub verdicts: Option<Result<Vec<Verdict>, SolveError>>,
}

/// The threads that solve.
#[derive(Debug)]
pub struct Solver {
    desk: Arc<Queue>,
    report: Arc<dyn Report>,
}

/// Receiver of outcomes, called on the thread that computed them.
trait Report: Fn(JobOutcome) + Send + Sync {}

impl<F: Fn(JobOutcome) + Send + Sync> Report for F {}

impl std::fmt::Debug for dyn Report {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Report")
    }
}

#[derive(Debug, Default)]
struct Queue {
    state: Mutex<SolverState>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct SolverState {
    next: Option<(Job, Arc<Stop>)>,
    running: Vec<Arc<Stop>>,
    threads: usize,
    closed: bool,
}

impl Solver {
    /// Ready for jobs; `report` is called from other threads.
    pub fn new(report: impl Fn(JobOutcome) + Send + Sync + 'static) -> Self {
        Self { desk: Arc::default(), report: Arc::new(report) }
    }

    /// Solves this, and nothing older any more.
    pub fn submit(&self, job: Job) {
        let mut state = self.desk.lock();
        for stop in &state.running {
            stop.stop();
        }
        state.next = Some((job, Arc::new(Stop::new())));
        if state.running.len() == state.threads && state.threads < MOST_THREADS {
            let (desk, report) = (self.desk.clone(), self.report.clone());
            let thread = thread::Builder::new().name("solver".into());
            if thread.spawn(move || work(&desk, &*report)).is_ok() {
                state.threads += 1;
            }
        }
        drop(state);
        self.desk.changed.notify_one();
    }

    /// Percentage of the newest job that is done, where it is known.
    pub fn percentage(&self) -> Option<u32> {
        self.desk.lock().running.last().and_then(|stop| stop.percentage())
    }

    /// Nothing that was submitted is wanted any more.
    pub fn cancel(&self) {
        let mut state = self.desk.lock();
        state.next = None;
        for stop in &state.running {
            stop.stop();
        }
    }
}

impl Drop for Solver {
    fn drop(&mut self) {
        let mut state = self.desk.lock();
        state.closed = true;
        for stop in &state.running {
            stop.stop();
        }
        drop(state);
        self.desk.changed.notify_all();
    }
}

impl Queue {
    fn lock(&self) -> MutexGuard<'_, SolverState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Does a job on this thread. `None` when it was stopped. `report` receives what is found before the end.
pub fn solve(job: &Job, stop: &Stop, report: &dyn Fn(JobOutcome)) -> Option<JobOutcome> {
    let mut reply = None;
    let so_far =
        |reply| report(JobOutcome { generation: job.generation, result: Ok(None), reply: Some(reply) });
    let result = match &job.work {
        Work::Solve(entry, record) => match catch_panic(|| entry.solve(record, stop)) {
            Ok(Ok(solution)) => Ok(Some(solution)),
            Ok(Err(SolveError::Refused(Refusal::Stopped))) => return None,
            Ok(Err(error)) => Err(JobFailure::Unsolved(error)),
            Err(panic) => Err(JobFailure::Fault(panic)),
        },
        Work::Fault(kind) => {
            catch_panic(|| fault(*kind, || stop.check().is_err())).map(|()| None).map_err(JobFailure::Fault)
        }
        Work::Ask(question) => match catch_panic(|| question.answer(stop, &so_far)) {
            Ok(None) => return None,
            Ok(some) => {
                reply = some;
                Ok(None)
            }
            Err(panic) => Err(JobFailure::Fault(panic)),
        },
    };
    Some(JobOutcome { generation: job.generation, result, reply })
}

/// The cases of an analysis, each compared with what was printed.
pub fn check_cases(entry: &'static Entry) -> Vec<CheckedCase> {
    let checked = |case: Case| {
        // A panic shows in the tab of results as well; here the case stays without a verdict.
        let verdicts = catch_panic(|| case.verify(entry)).ok();
        CheckedCase { case, verdicts }
    };
    cases::cases(entry).unwrap_or_default().into_iter().map(checked).collect()
}

/// A thread that compares cases with what was printed; `report` is called from it. The newest wish comes first, and of
/// old ones only a few are kept: the others are wished again when somebody looks.
pub fn case_checker(
    report: impl Fn((&'static str, Vec<CheckedCase>)) + Send + 'static,
) -> io::Result<mpsc::Sender<&'static Entry>> {
    let (wishes, incoming) = mpsc::channel::<&'static Entry>();
    thread::Builder::new().name("cases".into()).spawn(move || {
        while let Ok(wish) = incoming.recv() {
            let mut waiting = vec![wish];
            while !waiting.is_empty() {
                waiting.extend(incoming.try_iter());
                let Some(newest) = waiting.pop() else { break };
                waiting.retain(|other| other.about.id != newest.about.id);
                waiting.drain(..waiting.len().saturating_sub(MOST_WISHES));
                report((newest.about.id, check_cases(newest)));
            }
        }
    })?;
    Ok(wishes)
}

fn work(desk: &Queue, report: &dyn Report) {
    let mut state = desk.lock();
    loop {
        if state.closed {
            return;
        }
        let Some((job, stop)) = state.next.take() else {
            state = desk.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
            continue;
        };
        state.running.push(stop.clone());
        drop(state);
        if let Some(outcome) = solve(&job, &stop, &|so_far| report(so_far)) {
            report(outcome);
        }
        state = desk.lock();
        state.running.retain(|running| !Arc::ptr_eq(running, &stop));
    }
}

#[cfg(test)]
mod tests {
    use std::{
        sync::mpsc,
        time::{Duration, Instant},
    };

    use super::*;

    fn job(generation: u64, kind: Fault) -> Job {
        Job { generation, work: Work::Fault(kind) }
    }

    fn solver() -> (Solver, mpsc::Receiver<JobOutcome>) {
        let (sender, outcomes) = mpsc::channel();
        let solver = Solver::new(move |outcome| {
            let _ = sender.send(outcome);
        });
        (solver, outcomes)
    }

    #[test]
    fn the_newest_job_does_not_wait_for_one_that_looks_for_its_stop() {
        let (solver, outcomes) = solver();
        let start = Instant::now();
        for generation in 1..=20 {
            solver.submit(job(generation, Fault::Slow));
            thread::sleep(Duration::from_millis(10));
        }
        solver.submit(job(21, Fault::Analysis));
        let newest = outcomes.iter().find(|outcome| outcome.generation == 21);
        assert!(start.elapsed() < Duration::from_millis(800), "{:?}", start.elapsed());
        assert!(
            matches!(newest.map(|outcome| outcome.result), Some(Err(JobFailure::Fault(panic))) if panic.contains("requested"))
        );
    }

    #[test]
    fn a_job_that_never_looks_holds_nobody_else() {
        let (solver, outcomes) = solver();
        solver.submit(job(1, Fault::Stubborn));
        thread::sleep(Duration::from_millis(50));
        let start = Instant::now();
        solver.submit(job(2, Fault::Analysis));
        assert_eq!(outcomes.recv().map(|outcome| outcome.generation), Ok(2));
        assert!(start.elapsed() < Duration::from_millis(500), "{:?}", start.elapsed());
    }

    #[test]
    fn what_is_cancelled_ends_and_the_next_job_is_done() {
        let (solver, outcomes) = solver();
        solver.submit(job(1, Fault::Long));
        thread::sleep(Duration::from_millis(50));
        let start = Instant::now();
        solver.cancel();
        assert_eq!(outcomes.recv().map(|outcome| outcome.generation), Ok(1));
        assert!(start.elapsed() < Duration::from_millis(500), "{:?}", start.elapsed());
        solver.submit(job(2, Fault::Analysis));
        assert_eq!(outcomes.recv().map(|outcome| outcome.generation), Ok(2));
    }

    #[test]
    fn a_panic_leaves_the_thread_at_work() {
        let (solver, outcomes) = solver();
        for generation in 1..=3 {
            solver.submit(job(generation, Fault::Analysis));
            assert_eq!(outcomes.recv().map(|outcome| outcome.generation), Ok(generation));
        }
    }
}
