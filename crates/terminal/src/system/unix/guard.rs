//! The process in front of the program, which can still put the terminal right when the program cannot.

use std::{
    io::{self, IsTerminal, Write},
    os::unix::process::CommandExt,
    process::{Command, ExitCode},
    thread,
    time::Duration,
};

use rustix::{
    process::{Pid, Signal, WaitOptions, getpid, getppid, kill_process, waitpid},
    termios::{OptionalActions, Termios, tcgetattr, tcsetattr},
};
use signal_hook::{
    consts::{SIGCHLD, SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP},
    iterator::Signals,
};

use crate::{
    glyphs::{Capabilities, Environment, Glyphs},
    pixels::FORGET,
    shared::LEAVE,
    system::{GUARDED, Guarded},
};

/// Runs `program` in a child process, and repairs the terminal if the child dies by a signal.
///
/// In the process the shell started this runs the same executable with the same arguments, waits, and returns its
/// exit code, or 128 + n after signal n. In the child it calls `program`. Where no guard is possible or needed (no
/// terminal, no second process) it calls `program` at once.
pub fn run_guarded(words: &Guarded, program: impl FnOnce() -> ExitCode) -> ExitCode {
    if parent().is_some() || !io::stdin().is_terminal() {
        return program();
    }
    match start() {
        Ok((child, signals, saved)) => wait(words, child, signals, &saved),
        Err(_) => program(),
    }
}

/// The guard of this process, if it has one. The number is compared, so that a program started from within the
/// program, which inherits the variable, gets a guard of its own.
pub(super) fn parent() -> Option<Pid> {
    let named = std::env::var(GUARDED).ok()?.parse().ok().and_then(Pid::from_raw)?;
    (getppid() == Some(named)).then_some(named)
}

fn start() -> io::Result<(Pid, Signals, Termios)> {
    let saved = tcgetattr(rustix::stdio::stdin())?;
    // Before the child exists, so that none of its signals is missed.
    let signals = Signals::new([SIGCHLD, SIGTERM, SIGHUP, SIGINT, SIGQUIT, SIGTSTP, SIGCONT])?;
    let mut arguments = std::env::args_os();
    let mut command = Command::new(std::env::current_exe()?);
    if let Some(name) = arguments.next() {
        command.arg0(name);
    }
    let child = command.args(arguments).env(GUARDED, getpid().as_raw_nonzero().to_string()).spawn()?;
    Ok((Pid::from_child(&child), signals, saved))
}

fn wait(words: &Guarded, child: Pid, mut signals: Signals, saved: &Termios) -> ExitCode {
    loop {
        let mut batch: Vec<i32> = signals.wait().collect();
        if batch.contains(&SIGTSTP) {
            // If the whole group has it, the child stops the group, and this process with it, in a moment. Forwarded
            // after that, it would stop the child once more as soon as it is continued.
            thread::sleep(Duration::from_millis(100));
            batch.extend(signals.pending());
        }
        let continued = batch.contains(&SIGCONT);
        for signal in batch {
            let forward = match signal {
                SIGCHLD => {
                    if let Some(code) = reap(words, child, saved) {
                        return code;
                    }
                    continue;
                }
                SIGCONT => continue,
                // Asked for before the stop that has just ended.
                SIGTSTP if continued => continue,
                SIGTSTP => Signal::TSTP,
                SIGTERM => Signal::TERM,
                SIGHUP => Signal::HUP,
                SIGINT => Signal::INT,
                _ => Signal::QUIT,
            };
            // The child is not reaped yet, so its number is still its own; one that has died needs no signal.
            let _ = kill_process(child, forward);
        }
    }
}

/// The exit code of the child, if it has ended.
fn reap(words: &Guarded, child: Pid, saved: &Termios) -> Option<ExitCode> {
    let (_, status) = waitpid(Some(child), WaitOptions::NOHANG).ok()??;
    if let Some(code) = status.exit_status() {
        return Some(ExitCode::from(code as u8));
    }
    let signal = status.terminating_signal()?;
    repair(saved);
    // Not `eprintln`, which panics when standard error is gone as well.
    let _ = writeln!(
        io::stderr(),
        "{} was ended by signal {signal}{}; the terminal was restored{}",
        words.name,
        match signal {
            4 | 6 | 7 | 11 => ", a fault of the program",
            9 => ", sent from outside or for want of memory",
            _ => "",
        },
        words.advice.map_or_else(String::new, |advice| format!(", and {advice}"))
    );
    Some(ExitCode::from(128 + signal as u8))
}

fn repair(saved: &Termios) {
    let mut stdout = io::stdout().lock();
    // Whatever fails here, there is nothing better left to do than to go on with the rest.
    // A picture was cut off, or may be there, where the terminal could be asked whether it shows any.
    let asked = Capabilities::detect(&Environment::of_process()).glyphs == Glyphs::Unicode;
    let pictures =
        if cfg!(feature = "pixels") && asked { ["\x1b\\", FORGET].concat() } else { String::new() };
    let _ = stdout.write_all((pictures + LEAVE).as_bytes()).and_then(|()| stdout.flush());
    let _ = tcsetattr(rustix::stdio::stdin(), OptionalActions::Now, saved);
}
