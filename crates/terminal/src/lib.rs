//! A terminal for full-screen programs: taken, given back whatever happens, and decoded.
//!
//! Two processes share the work. The **guard** ([`run_guarded`]) is the process the shell started; it runs the program
//! again as its child and waits. It owns no screen, so it can put the terminal right when the child dies without a
//! word (`SIGKILL`, `abort`, stack overflow). The **child** holds a [`Session`]: raw mode, the alternate screen,
//! bracketed paste and, if asked, the mouse, all of them given back when it is dropped, when its thread panics, when
//! a signal ends the process and before it is suspended.
//!
//! ```no_run
//! use std::{process::ExitCode, time::Duration};
//!
//! use dalembert_terminal::{
//!     Guarded, Options, Session, TerminalError, TerminalInput,
//!     glyphs::{Capabilities, Environment},
//!     run_guarded,
//! };
//! use ratatui::crossterm::event::KeyCode;
//!
//! fn clock() -> Result<(), TerminalError> {
//!     let capabilities = Capabilities::detect(&Environment::of_process());
//!     let mut session = Session::enter(Options { capabilities, ..Options::default() })?;
//!     loop {
//!         session.draw(|frame| frame.render_widget("q ends", frame.area()))?;
//!         for input in session.next_events(Duration::from_secs(1))? {
//!             if matches!(input, TerminalInput::Key(key) if key.code == KeyCode::Char('q')) {
//!                 return Ok(());
//!             }
//!         }
//!     }
//! }
//!
//! fn main() -> ExitCode {
//!     run_guarded(&Guarded { name: "clock", advice: None }, || match clock() {
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
//! The parts can be used alone. [`decode`] turns bytes into keys, mouse reports and pastes, without a terminal:
//!
//! ```
//! use dalembert_terminal::{TerminalInput, decode::Decoder};
//! use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
//!
//! let (mut decoder, mut inputs) = (Decoder::default(), Vec::new());
//! decoder.feed(b"\x1b[1;5C\x1b[200~two\nlines\x1b[201~", &mut inputs);
//! assert_eq!(
//!     inputs,
//!     [
//!         TerminalInput::Key(KeyEvent::new(KeyCode::Right, KeyModifiers::CONTROL)),
//!         TerminalInput::Paste("two\nlines".to_owned()),
//!     ]
//! );
//! ```
//!
//! [`glyphs`] finds in the environment what a terminal can show, and reduces finished frames to it; [`catch_panic`]
//! keeps a panic from the screen; [`Fault`] breaks a program on demand, to test all of this.
//!
//! Input bytes are decoded here and not by crossterm, whose reader loses the rest of a burst, never leaves an open
//! paste, and panics on some mouse reports. What differs between Unix and Windows stands in `system`; on Windows there is no
//! guard, and nothing is suspended. Nothing here knows the program: what it is called and what it advises come
//! in as parameters, and errors report the cause alone.

mod backend;
pub mod decode;
mod fault;
pub mod glyphs;
mod input;
mod panics;
pub mod pixels;
mod session;
mod shared;
mod system;

use std::io::{self, IsTerminal};

pub use decode::TerminalInput;
pub use fault::{Fault, fault};
pub use panics::catch_panic;
pub use session::{Options, Session};
pub use system::{GUARDED, Guarded, Waker, columns, line_rate, report_file_size_limit, run_guarded};

/// A terminal that cannot be had, with the cause.
#[derive(Debug, thiserror::Error)]
pub enum TerminalError {
    /// Keys could not be read.
    #[error("standard input is not a terminal, so there are no keys to read")]
    InputNotATerminal,
    /// The screen could not be drawn.
    #[error("standard output is not a terminal, so there is no screen to draw")]
    OutputNotATerminal,
    /// `TERM` is unset, empty or `dumb`.
    #[error(
        "TERM is {}, a terminal that cannot place text on a screen",
        if .0.is_empty() { "not set".to_owned() } else { format!("`{}`", .0.escape_debug()) }
    )]
    Dumb(String),
    /// A console of Windows that takes no escape sequences.
    #[error("the console takes no escape sequences; that of Windows 10 and later does")]
    NoSequences,
    /// A call to the terminal failed.
    #[error("the terminal did not {action}: {source}")]
    Failed {
        /// The request, as a verb: "draw a frame".
        action: &'static str,
        /// The error of the system.
        source: io::Error,
    },
}

/// Examines the terminal: both ends must be one, and one that can place text.
///
/// [`Session::enter`] asks the same; a program that can answer in plain text asks first.
pub fn usable() -> Result<(), TerminalError> {
    if !io::stdin().is_terminal() {
        return Err(TerminalError::InputNotATerminal);
    }
    if !io::stdout().is_terminal() {
        return Err(TerminalError::OutputNotATerminal);
    }
    system::unusable().map_or(Ok(()), Err)
}

/// Converter of an error for `map_err(failed("draw a frame"))`.
fn failed(action: &'static str) -> impl FnOnce(io::Error) -> TerminalError {
    move |source| TerminalError::Failed { action, source }
}
