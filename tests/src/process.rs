//! Commands that have to end by themselves.

use std::{
    fs::{self, File},
    process::{Command, ExitStatus},
    thread,
    time::{Duration, Instant},
};

/// Runs a command. Returns its status, none if it did not end within `limit` and was killed, and what it printed on
/// standard output and standard error.
///
/// # Panics
/// If it cannot be run.
pub fn ended(command: &mut Command, limit: Duration) -> (Option<ExitStatus>, [Vec<u8>; 2]) {
    // Files, and no pipes: what is printed need not be read while the command runs.
    let folder = tempfile::tempdir().expect("a folder can be made");
    let paths = ["stdout", "stderr"].map(|name| folder.path().join(name));
    let [stdout, stderr] = paths.each_ref().map(|path| File::create(path).expect("a file can be made"));
    let mut child = command.stdout(stdout).stderr(stderr).spawn().expect("the program runs");
    let start = Instant::now();
    let status = loop {
        match child.try_wait().expect("the program can be waited for") {
            Some(status) => break Some(status),
            None if start.elapsed() > limit => {
                let _ = child.kill();
                let _ = child.wait();
                break None;
            }
            None => thread::sleep(Duration::from_millis(1)),
        }
    };
    (status, paths.map(|path| fs::read(path).unwrap_or_default()))
}
