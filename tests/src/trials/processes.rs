//! The program as a process: hostile arguments, kills, and system calls that fail.

use std::{
    fs,
    path::Path,
    process::{Command, ExitStatus, Stdio},
    thread,
    time::{Duration, Instant},
};

use tempfile::TempDir;

use super::{Outcome, Random};
use crate::{process, pty};

/// Time in which a command ends: `verify` solves every case.
const LIMIT: Duration = Duration::from_mins(1);
/// A problem whose note is written.
const SAVED: [&str; 7] = ["solve", "vibration/gun-recoil", "--case", "1", "-o", "note.html", "--force"];

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder can be made")
}

fn in_folder(command: &mut Command, folder: &Path) {
    command
        .current_dir(folder)
        .env("LANG", "C.UTF-8")
        .env("HOME", folder)
        .env("XDG_CONFIG_HOME", folder)
        .stdin(Stdio::null());
}

/// Status of a command, none if it does not end by itself, and all that it prints.
fn ended(command: &mut Command) -> (Option<ExitStatus>, Vec<u8>) {
    let (status, [mut printed, errors]) = process::ended(command, LIMIT);
    printed.extend(errors);
    (status, printed)
}

/// Gives the program so many command lines of words that do and do not belong there: it ends with 0, 1 or 2, soon, and
/// prints nothing that drives a terminal.
pub(super) fn hostile_arguments(times: u64, seed: u64) -> Outcome {
    let words = [
        "list",
        "show",
        "new",
        "solve",
        "check",
        "find",
        "verify",
        "schema",
        "sensitivity",
        "study",
        "optimise",
        "grade",
        "variants",
        "confirm",
        "help",
        "--json",
        "--format",
        "json",
        "html",
        "-o",
        "--set",
        "mass=1 kg",
        "mass=",
        "=",
        "mass=\u{1b}[31m",
        "--case",
        "1",
        "-1",
        "99999999999999999999",
        "--digits",
        "17",
        "0",
        "--lang",
        "pt-BR",
        "xx",
        "vibration/gun-recoil",
        "vibration/",
        "nothing.toml",
        "/dev/null",
        "/dev/full",
        ".",
        "",
        "--",
        "-",
        "\u{202e}",
        "\u{9b}2J",
        "--strict",
        "--ascii",
        "@/etc/passwd",
        "masses[9999999]=1",
        "a.b.c.d=1",
        "nul\u{1}",
    ];
    let folder = folder();
    let mut outcome = Outcome { tried: times, ..Outcome::default() };
    for n in 0..times {
        let mut random = Random::new(seed, n);
        let line: Vec<&str> = (0..=random.below(6)).map(|_| random.one(&words)).collect();
        let mut command = Command::new(pty::program());
        in_folder(command.args(&line), folder.path());
        let (status, printed) = ended(&mut command);
        let code = status.and_then(|status| status.code());
        let printed = String::from_utf8_lossy(&printed);
        let raw = printed
            .contains(|c: char| (c.is_control() && !"\n\t".contains(c)) || "\u{202e}\u{200b}".contains(c));
        if !matches!(code, Some(0..=2)) || raw || printed.contains("panicked") || printed.contains("root:x:")
        {
            outcome.failures.push(format!(
                "seed {seed}, {n}: {line:?}: {status:?}{}",
                if raw { ", raw controls" } else { "" }
            ));
        }
    }
    outcome
}

/// Notes before and after, of different lengths.
fn notes(folder: &Path) -> [Vec<u8>; 2] {
    let path = folder.join("note.html");
    let old = vec![b'o'; 400_000];
    fs::write(&path, &old).expect("the file is written");
    let mut command = Command::new(pty::program());
    in_folder(command.args(SAVED), folder);
    let (status, printed) = ended(&mut command);
    let new = fs::read(&path).expect("the note is there");
    assert!(
        status.is_some_and(|status| status.success()) && new != old,
        "{}",
        String::from_utf8_lossy(&printed)
    );
    [old, new]
}

/// Kills the program with -9 while it saves a note over another, so many times: the file is the old one or the new one.
pub(super) fn kills(times: u64, seed: u64) -> Outcome {
    let folder = folder();
    let path = folder.path().join("note.html");
    let [old, new] = notes(folder.path());
    let mut outcome = Outcome { tried: times, ..Outcome::default() };
    // The time of a whole run, so that kills are spread over it.
    let start = Instant::now();
    let mut command = Command::new(pty::program());
    in_folder(command.args(SAVED), folder.path());
    ended(&mut command);
    let whole = start.elapsed().as_micros() as usize;
    let (mut olds, mut news) = (0, 0);
    for n in 0..times {
        fs::write(&path, &old).expect("the file is written");
        let mut command = Command::new(pty::program());
        in_folder(command.args(SAVED), folder.path());
        let mut child =
            command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the program runs");
        thread::sleep(Duration::from_micros((whole / 2 + Random::new(seed, n).below(whole)) as u64));
        let _ = child.kill();
        let _ = child.wait();
        match fs::read(&path) {
            Ok(text) if text == old => olds += 1,
            Ok(text) if text == new => news += 1,
            Ok(text) => outcome.failures.push(format!("kill {n}: {} bytes are left", text.len())),
            Err(err) => outcome.failures.push(format!("kill {n}: {err}")),
        }
    }
    let left = fs::read_dir(folder.path()).map_or(0, |entries| entries.count().saturating_sub(1));
    outcome.note =
        format!("the old file {olds} times, the new one {news} times; {left} temporary files left");
    outcome
}

/// Lets one system call after the other of a save fail with each of seven errors: the file is the old one or the new one,
/// the exit status tells which, and no temporary file is left.
pub(super) fn system_calls(times: u64, _seed: u64) -> Outcome {
    const ERRORS: [&str; 7] = ["EIO", "ENOSPC", "EDQUOT", "EACCES", "EROFS", "EINTR", "EMFILE"];
    const CALLS: [&str; 9] =
        ["openat", "write", "fsync", "rename", "fchmod", "fchown", "flock", "statx", "getrandom"];
    let mut outcome = Outcome::default();
    let strace = Command::new("strace").arg("-V").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !strace.is_ok_and(|status| status.success()) {
        return Outcome { note: "not run: strace is not installed".to_owned(), ..outcome };
    }
    let folder = folder();
    let path = folder.path().join("note.html");
    let [old, new] = notes(folder.path());
    let (mut failed, mut succeeded) = (0, 0);
    for n in 0..times {
        let (error, rest) = (ERRORS[n as usize % ERRORS.len()], n as usize / ERRORS.len());
        let (call, when) = (CALLS[rest % CALLS.len()], 1 + rest / CALLS.len());
        fs::write(&path, &old).expect("the file is written");
        let mut command = Command::new("strace");
        command.args(["-f", "-qq", "-o", "/dev/null", "-e", &format!("trace={call}"), "-e"]);
        command.arg(format!("inject={call}:error={error}:when={when}")).arg(pty::program()).args(SAVED);
        in_folder(&mut command, folder.path());
        let (status, printed) = ended(&mut command);
        outcome.tried += 1;
        let ok = status.is_some_and(|status| status.success());
        if ok {
            succeeded += 1;
        } else {
            failed += 1;
        }
        let text = fs::read(&path).unwrap_or_default();
        let strays = fs::read_dir(folder.path()).map_or(0, |entries| entries.count().saturating_sub(1));
        let is_sound = (text == old && !ok) || text == new;
        if !is_sound || strays > 0 || status.is_none_or(|status| status.code().is_none()) {
            let said = String::from_utf8_lossy(&printed).lines().next().unwrap_or_default().to_owned();
            let kind = if text == old {
                "old"
            } else if text == new {
                "new"
            } else {
                "torn"
            };
            outcome.failures.push(format!(
                "{call} number {when} fails with {error}: {status:?}, {kind}, {strays} left: {said}"
            ));
            for entry in fs::read_dir(folder.path()).into_iter().flatten().flatten() {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
    outcome.note = format!("{failed} saves failed with an error, {succeeded} succeeded all the same");
    outcome
}
