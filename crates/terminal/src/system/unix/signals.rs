//! Signals, and the terminal that disappears without one. Each has its own thread, so neither depends on the one that
//! draws being alive.

use std::{
    io,
    sync::{Arc, atomic::Ordering::SeqCst},
    thread,
    time::Duration,
};

use rustix::{
    event::{PollFd, PollFlags, Timespec, poll},
    process::{Signal, getpgrp, getppid, getsid, kill_current_process_group},
};
use signal_hook::{
    consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGWINCH},
    iterator::Signals,
};

use super::guard;
use crate::shared::Shared;

/// Two signals sent one right after the other come no later than this.
const SOON_AFTER: Duration = Duration::from_millis(20);

/// Starts both threads. They live as long as the process: once a handler is installed, the default action of its
/// signal is gone, so a signal after the session still has to end the process here.
pub(crate) fn watch(shared: &Arc<Shared>) -> io::Result<()> {
    let guard = guard::parent();
    let mut signals = Signals::new([SIGTERM, SIGHUP, SIGINT, SIGQUIT, SIGTSTP, SIGCONT, SIGWINCH])?;
    let (for_signals, for_terminal) = (shared.clone(), shared.clone());
    thread::Builder::new().name("signals".into()).spawn(move || {
        loop {
            let mut batch: Vec<i32> = signals.wait().collect();
            if batch.contains(&SIGCONT) {
                // The signal that a stopped process is continued for (`kill %1`) may be handled after it.
                thread::sleep(SOON_AFTER);
                batch.extend(signals.pending());
            }
            if for_signals.released.load(SeqCst) {
                // They are for the program that has the terminal; that it stops stops us all.
                if batch.contains(&SIGTSTP) && !batch.contains(&SIGCONT) {
                    let _ = kill_current_process_group(Signal::STOP);
                }
                batch.retain(|signal| [SIGTERM, SIGHUP, SIGWINCH].contains(signal));
            }
            // First, because a process in the background that is continued to be ended must not ask for the terminal.
            if let Some(&signal) =
                batch.iter().find(|signal| [SIGTERM, SIGHUP, SIGINT, SIGQUIT].contains(signal))
            {
                for_signals.end(signal);
            }
            let continued = batch.contains(&SIGCONT);
            for signal in batch {
                match signal {
                    // Asked for before the stop that has just ended.
                    SIGTSTP if continued => {}
                    SIGTSTP => _ = suspend(&for_signals),
                    SIGCONT => {
                        // Failing here means that the terminal is gone, and the other thread will report it.
                        let _ = for_signals.take();
                        for_signals.repaint.store(true, SeqCst);
                        for_signals.waker.wake();
                    }
                    _ => {
                        for_signals.resized.store(true, SeqCst);
                        for_signals.waker.wake();
                    }
                }
            }
        }
    })?;
    thread::Builder::new().name("terminal watch".into()).spawn(move || {
        loop {
            thread::sleep(Duration::from_millis(500));
            if terminal_is_lost() || guard.is_some_and(|pid| getppid() != Some(pid)) {
                for_terminal.end(SIGHUP);
            }
        }
    })?;
    Ok(())
}

/// Gives the terminal back and stops the whole process group, so that the shell takes over even when the program has
/// a parent in that group. Returns false, and does nothing, where no shell would ever continue it.
///
/// Nothing is taken again here: this thread may run on for a moment after the call. `SIGCONT` does it.
pub(crate) fn suspend(shared: &Shared) -> bool {
    if !under_job_control() {
        return false;
    }
    {
        let _frame = shared.frame();
        if !shared.is_active() {
            return false;
        }
        shared.give_back();
    }
    kill_current_process_group(Signal::STOP).is_ok()
}

/// A shell with job control gives each job a process group of its own. In the group of the session's leader
/// (`xterm -e dalembert`, a container) nobody is left to continue what was stopped.
fn under_job_control() -> bool {
    getsid(None).is_ok_and(|session| session != getpgrp())
}

/// The window is closed, or the line is cut. `SIGHUP` reports it too, but it can be ignored by inheritance (`nohup`,
/// `sudo`, a multiplexer that was killed).
pub(crate) fn terminal_is_lost() -> bool {
    let stdin = rustix::stdio::stdin();
    let mut fds = [PollFd::new(&stdin, PollFlags::empty())];
    let now = Timespec { tv_sec: 0, tv_nsec: 0 };
    let gone = PollFlags::HUP | PollFlags::ERR | PollFlags::NVAL;
    poll(&mut fds, Some(&now)).is_ok_and(|ready| ready > 0 && fds[0].revents().intersects(gone))
}
