//! Part of the operating system in a terminal: bytes of the keys, signals, and a process in front that restores it.

#[cfg(unix)]
mod unix;
#[cfg(windows)]
#[expect(clippy::unnecessary_wraps, reason = "on Unix these functions can fail")]
mod windows;

#[cfg(unix)]
pub use unix::*;
#[cfg(windows)]
pub use windows::*;

/// Environment variable of the child: the process number of its guard.
pub const GUARDED: &str = "DALEMBERT_GUARDED";

/// The words of the guard's message when the program was ended by a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guarded {
    /// Name of the program.
    pub name: &'static str,
    /// Clause after "the terminal was restored", such as "work kept is offered at the next start".
    pub advice: Option<&'static str>,
}

/// The number of the signal of a terminal that is gone; a process that it ends returns 128 more.
pub(crate) const HANG_UP: i32 = 1;

/// Cause that ended a wait for input.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Ready {
    /// There are bytes to read.
    pub(crate) readable: bool,
    /// Another thread ended it.
    pub(crate) woken: bool,
    /// The terminal is gone.
    pub(crate) gone: bool,
}
