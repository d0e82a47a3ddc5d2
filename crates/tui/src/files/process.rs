//! Whether the process that left a file has ended.

use std::fs;

/// Whether a process with this number runs, and is one of this program as far as can be seen.
pub(super) fn runs(process: i32) -> bool {
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

/// When a process, or `self`, began, in ticks since the start of the machine; `None` where the system does not tell.
pub(super) fn began(process: &str) -> Option<String> {
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
