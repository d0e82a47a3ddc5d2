//! The terminal's lifecycle: how the workbench takes the screen, returns it, and survives what happens between.
//!
//! Two processes share the work. The **guard** ([`run_guarded`]) is the process the shell started; it runs the program
//! again as its child and waits. It owns no screen, so it can put the terminal right when the child dies without a
//! word (`SIGKILL`, `abort`, stack overflow). The **child** holds a [`Session`]: raw mode, the alternate screen,
//! bracketed paste and, if asked, the mouse, all of them given back when it is dropped, when its thread panics, when
//! a signal ends the process and before it is suspended.
//!
//! ```no_run
//! use dalembert_tui::terminal::{self, Input, Options, Session};
//! use std::{process::ExitCode, time::Duration};
//!
//! fn workbench() -> Result<(), terminal::TerminalError> {
//!     let mut session = Session::enter(Options::default())?;
//!     loop {
//!         session.draw(|frame| frame.render_widget("q ends", frame.area()))?;
//!         for input in session.next_events(Duration::from_mins(1))? {
//!             if matches!(input, Input::Key(key) if key.code == ratatui::crossterm::event::KeyCode::Char('q')) {
//!                 return Ok(());
//!             }
//!         }
//!     }
//! }
//!
//! fn main() -> ExitCode {
//!     terminal::run_guarded(|| match workbench() {
//!         Ok(()) => ExitCode::SUCCESS,
//!         Err(error) => {
//!             eprintln!("{error}");
//!             ExitCode::from(2)
//!         }
//!     })
//! }
//! ```
//!
//! Exit codes: what the program returns; 101 after a panic of its main thread; 128 + n after signal n.
//!
//! Invariants: nothing here knows the model or the screens. Input bytes are decoded here, by [`decode`], and not by
//! crossterm, whose reader loses the rest of a burst, never leaves an open paste, and panics on some mouse reports.

mod backend;
pub mod decode;
mod fault;
mod guard;
mod input;
mod panics;
mod session;
mod shared;
mod signals;

use std::io::{self, IsTerminal};

use rustix::termios::tcgetattr;

pub use decode::Input;
pub use fault::{Fault, fault};
pub use guard::{GUARDED, run_guarded};
pub use input::Waker;
pub use panics::contained;
pub use session::{Options, Session};

/// Why the workbench cannot have the terminal. The message says what to use instead.
#[derive(Debug, thiserror::Error)]
pub enum TerminalError {
    /// Keys could not be read.
    #[error(
        "standard input is not a terminal, so there are no keys to read: write `dalembert solve FILE` for plain output"
    )]
    InputNotATerminal,
    /// The screen could not be drawn.
    #[error(
        "standard output is not a terminal, so there is no screen to draw: write `dalembert solve FILE` for plain output"
    )]
    OutputNotATerminal,
    /// `TERM` is unset, empty or `dumb`.
    #[error(
        "TERM is {}, a terminal that cannot place text on a screen: write `dalembert solve FILE`, \
         or set TERM to what your terminal is, such as `TERM=xterm-256color`",
        if .0.is_empty() { "not set".to_owned() } else { format!("`{}`", .0.escape_debug()) }
    )]
    Dumb(String),
    /// A call to the terminal failed.
    #[error("the terminal did not {action}: {source}")]
    Failed {
        /// What was asked of it, as a verb: "draw a frame".
        action: &'static str,
        /// What the system said.
        source: io::Error,
    },
}

/// Whether the workbench can run here: both ends are a terminal, and it is one that can place text.
///
/// [`Session::enter`] asks the same; the command line asks first, so that it can answer in plain text.
pub fn usable() -> Result<(), TerminalError> {
    if !io::stdin().is_terminal() {
        return Err(TerminalError::InputNotATerminal);
    }
    if !io::stdout().is_terminal() {
        return Err(TerminalError::OutputNotATerminal);
    }
    let term = std::env::var_os("TERM").unwrap_or_default().to_string_lossy().into_owned();
    if term.is_empty() || term == "dumb" {
        return Err(TerminalError::Dumb(term));
    }
    Ok(())
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

/// `failed("draw a frame")` for `map_err`.
fn failed(action: &'static str) -> impl FnOnce(io::Error) -> TerminalError {
    move |source| TerminalError::Failed { action, source }
}
