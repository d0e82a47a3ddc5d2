//! Test of whether the process that left a file still runs.

use std::fs;

/// Returns true if a process with this number runs and is, as far as can be determined, one of this program.
pub(in crate::files) fn runs(process: i32) -> bool {
    let Some(pid) = rustix::process::Pid::from_raw(process) else { return false };
    if matches!(rustix::process::test_kill_process(pid), Err(rustix::io::Errno::SRCH)) {
        return false;
    }
    let process = process.to_string();
    // A process that has ended keeps its number until its parent asks how.
    if stat(&process, STATE).is_some_and(|state| matches!(state.as_str(), "Z" | "X")) {
        return false;
    }
    // Numbers are used again; where the system tells names, another program is not ours.
    let name = |process: &str| fs::read(format!("/proc/{process}/comm"));
    match (name(&process), name("self")) {
        (Ok(theirs), Ok(ours)) => theirs == ours,
        _ => true,
    }
}

/// Start time of a process, or of `self`, in clock ticks since boot; `None` where the system does not report it.
pub(in crate::files) fn began(process: &str) -> Option<String> {
    stat(process, BEGAN)
}

/// Places of fields in `/proc/PID/stat`, counted from that after the name.
const STATE: usize = 0;
const BEGAN: usize = 19;

fn stat(process: &str, field: usize) -> Option<String> {
    let text = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    // The name stands in parentheses, and may hold any character.
    text.rsplit_once(')')?.1.split_whitespace().nth(field).map(str::to_owned)
}
