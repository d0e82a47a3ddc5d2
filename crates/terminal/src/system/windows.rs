//! Consoles of Windows, in the mode in which they send and take the sequences of a terminal (Windows 10 and later).
//!
//! There are no signals and there is no guard: a program that is ended from outside leaves the console to the system.

use std::{
    io::{self, Read},
    process::ExitCode,
    sync::{
        Arc,
        atomic::Ordering::SeqCst,
        mpsc::{self, Receiver, RecvTimeoutError, Sender},
    },
    thread,
    time::Duration,
};

use crossterm::{ansi_support::supports_ansi, terminal};
use crossterm_winapi::{ConsoleMode, Handle};

use super::{Guarded, Ready};
use crate::{TerminalError, shared::Shared};

/// `ENABLE_VIRTUAL_TERMINAL_INPUT`: keys come as the sequences that a terminal sends.
const SEQUENCES_AS_INPUT: u32 = 0x0200;

/// Period at which the size of the window is read, which nothing reports.
const SIZE_PERIOD: Duration = Duration::from_millis(200);

/// Message of the thread that reads, or of one that wakes.
enum Message {
    Bytes(Vec<u8>),
    Wake,
    Gone,
}

/// Ends a wait of [`Session::next_events`](crate::Session::next_events) from another thread: a solver calls it after
/// it has left its result where the drawing thread looks.
#[derive(Clone, Debug)]
pub struct Waker(Sender<Message>);

impl Waker {
    /// Ends the present wait, or the next one if nobody waits. Never blocks.
    pub fn wake(&self) {
        // Without a session nobody waits.
        let _ = self.0.send(Message::Wake);
    }
}

/// Standard input, read by a thread of its own: a wait for a console cannot be ended by another thread.
#[derive(Debug)]
pub(crate) struct Input {
    messages: Receiver<Message>,
    /// Bytes that were taken from the thread and not read yet.
    bytes: Vec<u8>,
}

impl Input {
    pub(crate) fn new() -> io::Result<(Self, Waker)> {
        let (sender, messages) = mpsc::channel();
        let waker = Waker(sender.clone());
        thread::Builder::new().name("keys".into()).spawn(move || {
            let mut buffer = [0; 4096];
            loop {
                let message = match io::stdin().lock().read(&mut buffer) {
                    // Ctrl-Z at the start of a line, which the library takes for an end.
                    Ok(0) => Message::Bytes(vec![0x1a]),
                    Ok(count) => Message::Bytes(buffer[..count].to_vec()),
                    Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                    Err(_) => Message::Gone,
                };
                let is_last = matches!(message, Message::Gone);
                if sender.send(message).is_err() || is_last {
                    return;
                }
            }
        })?;
        Ok((Self { messages, bytes: Vec::new() }, waker))
    }

    /// Waits for bytes, a wake or the end of the terminal, for at most `timeout`.
    pub(crate) fn wait(&mut self, timeout: Duration) -> io::Result<Ready> {
        let mut ready = Ready { readable: !self.bytes.is_empty(), ..Ready::default() };
        let timeout = if ready.readable { Duration::ZERO } else { timeout };
        let mut next = self.messages.recv_timeout(timeout);
        loop {
            match next {
                Ok(Message::Bytes(bytes)) => {
                    self.bytes.extend(bytes);
                    ready.readable = true;
                }
                Ok(Message::Wake) => ready.woken = true,
                Ok(Message::Gone) | Err(RecvTimeoutError::Disconnected) => {
                    ready.gone = true;
                    return Ok(ready);
                }
                Err(RecvTimeoutError::Timeout) => return Ok(ready),
            }
            next = self.messages.recv_timeout(Duration::ZERO);
        }
    }

    /// Takes the bytes that are there; `None` where the terminal is gone.
    pub(crate) fn read(&mut self, buffer: &mut [u8]) -> io::Result<Option<usize>> {
        let count = buffer.len().min(self.bytes.len());
        buffer[..count].copy_from_slice(&self.bytes[..count]);
        self.bytes.drain(..count);
        Ok(Some(count))
    }
}

/// Runs `program`: on Windows no process stands in front of it.
pub fn run_guarded(_: &Guarded, program: impl FnOnce() -> ExitCode) -> ExitCode {
    program()
}

/// Reason for which the console cannot place text, if it cannot.
pub(crate) fn unusable() -> Option<TerminalError> {
    (!supports_ansi()).then_some(TerminalError::NoSequences)
}

/// Value of a variable of the environment that is not set: consoles that take sequences show Unicode and all colours.
pub(crate) fn usual(variable: &str) -> Option<&'static str> {
    match variable {
        "TERM" => Some("xterm-256color"),
        "COLORTERM" => Some("truecolor"),
        "LANG" => Some("C.UTF-8"),
        _ => None,
    }
}

/// Raw mode, in which keys come as sequences.
pub(crate) fn enable_raw_mode() -> io::Result<()> {
    terminal::enable_raw_mode()?;
    let mode = ConsoleMode::from(Handle::current_in_handle()?);
    mode.set_mode(mode.mode()? | SEQUENCES_AS_INPUT)
}

/// Starts the thread that reads the size of the window.
pub(crate) fn watch(shared: &Arc<Shared>) -> io::Result<()> {
    let shared = shared.clone();
    thread::Builder::new().name("size of the window".into()).spawn(move || {
        let mut known = terminal::size().ok();
        loop {
            thread::sleep(SIZE_PERIOD);
            let now = terminal::size().ok();
            if now != known {
                known = now;
                shared.resized.store(true, SeqCst);
                shared.waker.wake();
            }
        }
    })?;
    Ok(())
}

/// Nothing is suspended: there is no shell that would continue it.
pub(crate) fn suspend(_: &Shared) -> bool {
    false
}

/// A console that is closed ends its processes itself.
pub(crate) fn terminal_is_lost() -> bool {
    false
}

/// Files have no limit of size that would end a process.
pub fn report_file_size_limit() -> io::Result<()> {
    Ok(())
}

/// No console reports the rate of a line.
pub fn line_rate() -> Option<f64> {
    None
}

/// Columns of the console that standard output is.
pub fn columns() -> Option<u16> {
    terminal::size().ok().map(|(columns, _)| columns).filter(|columns| *columns > 0)
}

/// No console reports its pixels.
#[cfg(feature = "pixels")]
pub(crate) fn cell() -> Option<(u16, u16)> {
    None
}
