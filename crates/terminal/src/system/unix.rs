//! Terminals of Unix: termios, signals, and a guard process.

mod guard;
mod input;
mod signals;

use std::{io, sync::Arc};

use rustix::termios::{tcgetattr, tcgetwinsize};
use signal_hook::{consts::SIGXFSZ, flag};

use crate::TerminalError;

pub(crate) use crossterm::terminal::enable_raw_mode;
pub use guard::run_guarded;
pub(crate) use input::Input;
pub use input::Waker;
pub(crate) use signals::{suspend, terminal_is_lost, watch};

/// Reason for which the terminal cannot place text, if it cannot: `TERM` is unset, empty or `dumb`.
pub(crate) fn unusable() -> Option<TerminalError> {
    let term = std::env::var_os("TERM").unwrap_or_default().to_string_lossy().into_owned();
    (term.is_empty() || term == "dumb").then_some(TerminalError::Dumb(term))
}

/// Value of a variable of the environment that is not set: Unix sets what there is to know of a terminal.
pub(crate) fn usual(_: &str) -> Option<&'static str> {
    None
}

/// Makes a write beyond the largest size of a file (`ulimit -f`) an error of that write, where it would end the process.
pub fn report_file_size_limit() -> io::Result<()> {
    // What is raised need not be known: the write fails with EFBIG.
    flag::register(SIGXFSZ, Arc::default()).map(drop)
}

/// The bytes that the line to the terminal carries in a second, where it reports it. What says 38400 baud or more is a
/// pseudo-terminal that nobody reported, or a line so fast that nothing needs to be spared.
pub fn line_rate() -> Option<f64> {
    const UNKNOWN_RATE: u32 = 38_400;
    /// Eight bits, a start and a stop.
    const BITS: f64 = 10.0;
    let baud = tcgetattr(rustix::stdio::stdout()).ok()?.output_speed();
    (1..UNKNOWN_RATE).contains(&baud).then(|| f64::from(baud) / BITS)
}

/// Columns of the terminal that standard output is.
pub fn columns() -> Option<u16> {
    tcgetwinsize(rustix::stdio::stdout()).ok().map(|size| size.ws_col).filter(|columns| *columns > 0)
}

/// Pixels across a cell and down a cell, where the system knows them.
#[cfg(feature = "pixels")]
pub(crate) fn cell() -> Option<(u16, u16)> {
    let window = tcgetwinsize(rustix::stdio::stdout()).ok()?;
    Some((window.ws_xpixel.checked_div(window.ws_col)?, window.ws_ypixel.checked_div(window.ws_row)?))
}
