//! Running an analysis without trusting it: one that panics is named, and the program goes on.

use std::{
    any::Any,
    cell::Cell,
    panic::{self, AssertUnwindSafe},
    sync::{
        Mutex, Once, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
};

use dalembert_core::{Entry, FieldError, Record, Refusal, Solution, SolveError, Stop, Text};

use crate::failure::Failure;

/// Outcome of a solve: a solution, or the reason for which there is none.
pub(crate) type SolveOutcome = Result<Solution, Text>;

/// Solves a problem.
pub(crate) fn solve(entry: &'static Entry, record: &Record) -> Result<SolveOutcome, Failure> {
    match guarded(entry, || entry.solve(record, &Stop::new()))? {
        Ok(solution) => Ok(Ok(solution)),
        Err(SolveError::Refused(Refusal::NoAnswer(why))) => Ok(Err(why)),
        Err(SolveError::Refused(Refusal::Stopped)) => {
            Err(Failure::Fault(format!("{} was stopped", entry.about.id)))
        }
        Err(error) => Err(failure(error)),
    }
}

/// Failure of a command whose problem has no solution.
pub(crate) fn failure(error: SolveError) -> Failure {
    match error {
        SolveError::Refused(Refusal::NoAnswer(why)) => Failure::Refused(why),
        SolveError::Refused(Refusal::Stopped) => Failure::Fault(error.to_string()),
        SolveError::Fields(errors) => {
            let why = |error: FieldError| {
                Text::new("{path}: {why}").with("path", error.path).with_text("why", error.why)
            };
            Failure::Input(errors.into_iter().map(why).collect())
        }
    }
}

/// Runs a part of an analysis; a panic becomes a [`Failure::Fault`] that names the analysis and the place.
pub(crate) fn guarded<T>(entry: &Entry, run: impl FnOnce() -> T) -> Result<T, Failure> {
    contained(entry.about.id, run)
}

/// The place of the latest panic.
static PLACE: Mutex<String> = Mutex::new(String::new());

/// Number of calls of [`contained`] that run, on whatever thread.
static CONTAINED: AtomicUsize = AtomicUsize::new(0);

thread_local! {
    /// True on a thread whose panic is caught, and so is not reported twice.
    static IS_CAUGHT: Cell<bool> = const { Cell::new(false) };
}

/// Runs what may panic; a panic becomes a [`Failure::Fault`] that names what panicked and the place.
pub(crate) fn contained<T>(what: &str, run: impl FnOnce() -> T) -> Result<T, Failure> {
    // One hook for all threads: to set one for each call would race with those of others.
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if CONTAINED.load(Ordering::SeqCst) > 0 {
                let at = info.location().map_or_else(String::new, ToString::to_string);
                *PLACE.lock().unwrap_or_else(PoisonError::into_inner) = at;
            }
            if !IS_CAUGHT.get() {
                before(info);
            }
        }));
    });
    CONTAINED.fetch_add(1, Ordering::SeqCst);
    let was_caught = IS_CAUGHT.replace(true);
    let result = panic::catch_unwind(AssertUnwindSafe(run));
    IS_CAUGHT.set(was_caught);
    CONTAINED.fetch_sub(1, Ordering::SeqCst);
    result.map_err(|payload| {
        let place = PLACE.lock().unwrap_or_else(PoisonError::into_inner);
        Failure::Fault(format!("{what} panicked at {place}: {}", words(&*payload)))
    })
}

fn words(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<&str>().copied();
    text.or_else(|| payload.downcast_ref::<String>().map(String::as_str)).unwrap_or("no message")
}

#[cfg(test)]
mod tests {
    use dalembert_core::{About, Analysis, Draft, Inputs, Worksheet};

    use super::*;

    /// An analysis with a fault.
    #[derive(Debug, Inputs)]
    struct Faulty {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    }

    impl Analysis for Faulty {
        const ABOUT: About = About {
            id: "test/faulty",
            title: "",
            topic: "",
            summary: "",
            main: &[],
            keywords: "",
            sources: &[],
            cases: "",
        };

        fn solve<W: Worksheet>(&self, _: &FaultyGiven<W>, _: W) -> Result<(), Refusal> {
            panic!("index {} of a list of 1", self.mass)
        }
    }

    #[test]
    fn a_panicking_analysis_is_named() {
        static ENTRY: Entry = Entry::of::<Faulty>();
        let shape = ENTRY.shape();
        let mut draft = Draft::blank(&shape);
        draft.set(&shape, "mass", "3 kg").unwrap();
        let record = draft.read(&shape).unwrap();
        let fault = solve(&ENTRY, &record).unwrap_err().to_string();
        assert!(fault.starts_with("test/faulty panicked at crates/dalembert/src/solving.rs"), "{fault}");
        assert!(fault.ends_with("index 3 of a list of 1"), "{fault}");
    }
}
