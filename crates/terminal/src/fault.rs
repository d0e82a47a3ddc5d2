//! Fault injection: a program is broken on demand, to test everything else in this crate.

use std::{
    fmt, hint,
    process::abort,
    str::FromStr,
    thread,
    time::{Duration, Instant},
};

/// A fault that a program can be asked to commit, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// `panic`: this thread panics.
    Panic,
    /// `double`: a destructor panics while this thread panics, which aborts.
    Double,
    /// `abort`: the process aborts.
    Abort,
    /// `overflow`: the stack of this thread overflows, which aborts.
    Overflow,
    /// `worker`: another thread panics, and nobody catches it.
    Worker,
    /// `analysis`: panics; for a solver thread, which contains it.
    Analysis,
    /// `slow`: takes 1 s, and looks for a stop every 5 ms; for a solver thread.
    Slow,
    /// `long`: takes 10 s, and looks for a stop every 5 ms; for a solver thread.
    Long,
    /// `stubborn`: takes 3 s and never looks; for a solver thread.
    Stubborn,
}

impl Fault {
    /// Every fault, in the order of the enum.
    pub const ALL: [Self; 9] = [
        Self::Panic,
        Self::Double,
        Self::Abort,
        Self::Overflow,
        Self::Worker,
        Self::Analysis,
        Self::Slow,
        Self::Long,
        Self::Stubborn,
    ];

    /// True where a solver thread, apart from the one that draws, is to commit it.
    pub fn belongs_to_solver(self) -> bool {
        matches!(self, Self::Analysis | Self::Slow | Self::Long | Self::Stubborn)
    }

    /// True where faults may be requested: `DALEMBERT_FAULTS=1` in the environment.
    pub fn allowed() -> bool {
        std::env::var_os("DALEMBERT_FAULTS").is_some_and(|value| value == "1")
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Panic => "panic",
            Self::Double => "double",
            Self::Abort => "abort",
            Self::Overflow => "overflow",
            Self::Worker => "worker",
            Self::Analysis => "analysis",
            Self::Slow => "slow",
            Self::Long => "long",
            Self::Stubborn => "stubborn",
        })
    }
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|fault| fault.to_string() == name).ok_or_else(|| {
            let names = Self::ALL.map(|fault| fault.to_string()).join(", ");
            format!("`{name}` is no fault: write one of {names}")
        })
    }
}

/// Commits `fault` on this thread. `stopped` is asked by [`Fault::Slow`] and [`Fault::Long`] whether their
/// result is still wanted.
pub fn fault(fault: Fault, stopped: impl Fn() -> bool) {
    const LONG: Duration = Duration::from_secs(1);
    match fault {
        Fault::Panic => panic!("requested panic"),
        Fault::Double => {
            let _trap = PanicsInDrop;
            panic!("requested panic, first of two");
        }
        Fault::Abort => abort(),
        Fault::Overflow => _ = overflow(0),
        Fault::Worker => {
            // Its end is seen by the panic hook, and by nobody else.
            let worker = thread::Builder::new().name("requested fault".into());
            drop(worker.spawn(|| panic!("requested panic of a worker")));
        }
        Fault::Analysis => panic!("requested panic of an analysis"),
        Fault::Slow | Fault::Long => {
            let start = Instant::now();
            let takes = if fault == Fault::Slow { LONG } else { 10 * LONG };
            while start.elapsed() < takes && !stopped() {
                thread::sleep(Duration::from_millis(5));
            }
        }
        Fault::Stubborn => thread::sleep(3 * LONG),
    }
}

struct PanicsInDrop;

impl Drop for PanicsInDrop {
    fn drop(&mut self) {
        panic!("requested panic, second of two");
    }
}

#[expect(unconditional_recursion, reason = "overflowing the stack is its purpose")]
fn overflow(depth: u64) -> u64 {
    let page = hint::black_box([depth; 512]);
    overflow(depth + 1) + hint::black_box(page)[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        for fault in Fault::ALL {
            assert_eq!(fault.to_string().parse(), Ok(fault));
        }
        assert!("rain".parse::<Fault>().unwrap_err().contains("stubborn"));
    }
}
