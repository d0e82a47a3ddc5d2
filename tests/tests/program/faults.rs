//! Faults of every kind, and what they leave behind: nothing.
//!
//! Each test runs twice, against the smallest program on the terminal's lifecycle and against the workbench. It asks
//! of a program only what both have: `dalembert` on its first screen, a palette behind `:` that shows what is typed,
//! the commands `:quit` and `:fault KIND` (with `DALEMBERT_FAULTS=1`), Ctrl-Z, and notices shown somewhere.

use std::{
    path::Path,
    thread,
    time::{Duration, Instant},
};

use dalembert_tests::pty::{self, Launch, Pty, Signal};

macro_rules! against_both {
    ($($test:ident)*) => {
        mod lifecycle {
            $(#[test] fn $test() { super::$test(&super::pty::lifecycle()); })*
        }
        mod workbench {
            $(#[test] fn $test() { super::$test(&super::pty::program()); })*
        }
    };
}

against_both! {
    quitting
    faults_that_end_the_program
    faults_that_do_not
    a_stubborn_solver_does_not_hold_the_keys
    signals_to_the_program
    signals_to_the_guard
    a_guard_that_is_killed
    suspending_and_resuming
    jobs_in_the_background
    no_shell_to_return_to
    the_window_closes
    the_window_closes_while_hangups_are_ignored
    a_terminal_that_takes_no_bytes
    bursts_of_keys
    hostile_input
    answers_nobody_asked_for
    pastes
    resizing
    tiny_sizes
    bytes_on_the_line
    plain_terminals
    hopeless_terminals
}

const SECOND: Duration = Duration::from_secs(1);

fn launch(program: &Path) -> Launch {
    Launch::new(program).env("DALEMBERT_FAULTS", "1")
}

/// Started, with its first screen drawn.
fn started(launch: Launch) -> Pty {
    let pty = launch.start();
    pty.expect("dalembert");
    pty.idle(Duration::from_millis(100));
    pty
}

/// The program takes keys and draws.
#[track_caller]
fn assert_alive(pty: &mut Pty, after: &str) {
    leave(pty);
    pty.types(":alive");
    assert!(pty.sees(":alive", pty::PATIENCE), "no answer to keys after {after}:\n{}", pty.screen());
    escape(pty);
}

/// Closes the palette. What follows an escape at once would be a key with Alt.
fn escape(pty: &mut Pty) {
    pty.types("<esc>");
    thread::sleep(Duration::from_millis(100));
}

/// Leaves whatever has the keys, up to the list of analyses, where letters are keys.
fn leave(pty: &mut Pty) {
    for _ in 0..3 {
        escape(pty);
    }
}

/// The program ended with this code and left the terminal as it was.
#[track_caller]
fn assert_ended(pty: &mut Pty, code: u32, after: &str) {
    let exit = pty.exit_code();
    assert_eq!((exit, pty.leftovers()), (Some(code), vec![]), "after {after}:\n{}", pty.screen());
}

fn quitting(program: &Path) {
    let mut pty = started(launch(program));
    pty.types(":quit<enter>");
    assert_ended(&mut pty, 0, "quit");
}

fn faults_that_end_the_program(program: &Path) {
    for (kind, code, says) in [
        ("panic", 101, "requested panic"),
        ("double", 134, "signal 6"),
        ("abort", 134, "signal 6"),
        ("overflow", 134, "signal 6"),
    ] {
        let mut pty = started(launch(program));
        pty.types(&format!(":fault {kind}<enter>"));
        assert_ended(&mut pty, code, kind);
        assert!(pty.screen().contains(says), "{kind}:\n{}", pty.screen());
    }
}

fn faults_that_do_not(program: &Path) {
    for kind in ["worker", "analysis"] {
        let mut pty = started(launch(program));
        pty.types(&format!(":fault {kind}<enter>"));
        pty.expect("requested panic");
        assert!(pty.screen().contains("dalembert"), "the screen is lost after {kind}:\n{}", pty.screen());
        assert_alive(&mut pty, kind);
        pty.types(":quit<enter>");
        assert_ended(&mut pty, 0, kind);
    }
}

fn a_stubborn_solver_does_not_hold_the_keys(program: &Path) {
    let mut pty = started(launch(program));
    pty.types(":fault stubborn<enter>");
    let start = Instant::now();
    thread::sleep(Duration::from_millis(100));
    for letters in ["abc", "def"] {
        pty.types(&format!(":{letters}"));
        pty.expect(&format!(":{letters}"));
        escape(&mut pty);
    }
    // The solver takes a second more.
    assert!(start.elapsed() < 2 * SECOND, "{:?} for keys beside a solver", start.elapsed());
}

fn signals_to_the_program(program: &Path) {
    for (signal, code) in [
        (Signal::TERM, 143),
        (Signal::HUP, 129),
        (Signal::INT, 130),
        (Signal::QUIT, 131),
        (Signal::KILL, 137),
        (Signal::SEGV, 139),
        (Signal::ABORT, 134),
    ] {
        let mut pty = started(launch(program));
        pty.signal(-1, signal);
        if signal == Signal::SEGV {
            // The first one looks like an overflow of the stack to the handler of the standard library.
            thread::sleep(Duration::from_millis(100));
            pty.signal(-1, signal);
        }
        assert_ended(&mut pty, code, &format!("{signal:?}"));
    }
}

fn signals_to_the_guard(program: &Path) {
    for (signal, code) in [(Signal::TERM, 143), (Signal::HUP, 129), (Signal::INT, 130), (Signal::QUIT, 131)] {
        let mut pty = started(launch(program));
        pty.signal(0, signal);
        assert_ended(&mut pty, code, &format!("{signal:?}"));
        let mut pty = started(launch(program));
        pty.signal_group(signal);
        assert_ended(&mut pty, code, &format!("{signal:?} to the group"));
    }
}

/// Nobody can keep the shell from writing its prompt first; but the program notices, ends, and cleans up.
fn a_guard_that_is_killed(program: &Path) {
    let mut pty = started(launch(program).under_shell());
    let proper = proper(&pty);
    pty.signal(0, Signal::KILL);
    pty.expect("Killed");
    let end = Instant::now() + 3 * SECOND;
    while pty::alive(proper).is_some() && Instant::now() < end {
        thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(pty::alive(proper), None, "the program goes on without its guard");
    pty.idle(Duration::from_millis(100));
    pty.types("<enter>");
    pty.idle(Duration::from_millis(100));
    assert_eq!(pty.leftovers(), [""; 0]);
}

fn suspending_and_resuming(program: &Path) {
    type Stop = fn(&mut Pty);
    let ways: [(&str, Stop); 4] = [
        ("Ctrl-Z", |pty| pty.types("<c-z>")),
        ("TSTP to the program", |pty| pty.signal(-1, Signal::TSTP)),
        ("TSTP to the guard", |pty| pty.signal(0, Signal::TSTP)),
        ("TSTP to the group", |pty| pty.signal_group(Signal::TSTP)),
    ];
    for (name, stop) in ways {
        let mut pty = started(launch(program).under_shell());
        for round in 0..3 {
            stop(&mut pty);
            pty.expect("Stopped");
            pty.idle(Duration::from_millis(150));
            assert_eq!(pty.leftovers(), [""; 0], "stopped by {name}");
            pty.types(&format!("echo back$((6*7+{round}))<enter>"));
            pty.expect(&format!("back{}", 42 + round));
            pty.resize(30 - round, 100 - round);
            let start = Instant::now();
            pty.types("fg<enter>");
            pty.idle(Duration::from_millis(20));
            pty.expect("dalembert");
            assert!(start.elapsed() < SECOND, "{:?} to come back after {name}", start.elapsed());
            pty.idle(Duration::from_millis(150));
            assert_alive(&mut pty, name);
        }
        pty.types(":quit<enter>");
        pty.idle(Duration::from_millis(200));
        pty.types("echo code$?<enter>");
        pty.expect("code0");
        assert_eq!(pty.leftovers(), [""; 0], "ended after {name}");
    }
}

/// A stopped job that is ended, and one that is continued where it must not draw.
fn jobs_in_the_background(program: &Path) {
    let mut pty = started(launch(program).under_shell());
    pty.types("<c-z>");
    pty.expect("Stopped");
    pty.types("kill %1<enter>");
    // The shell tells of it at a prompt, once it has happened.
    for _ in 0..40 {
        if pty.screen().contains("Exit 143") {
            break;
        }
        pty.idle(Duration::from_millis(100));
        pty.types("jobs<enter>");
    }
    pty.expect("Exit 143");
    assert_eq!(pty.leftovers(), [""; 0], "ended while stopped");

    pty.types("clear; \"$PROGRAM\"<enter>");
    pty.expect("dalembert");
    pty.idle(Duration::from_millis(100));
    pty.types("<c-z>");
    pty.expect("Stopped");
    pty.types("clear; bg<enter>");
    pty.idle(Duration::from_millis(300));
    assert_eq!(pty.leftovers(), [""; 0], "continued in the background");
    pty.types("echo still$((6*7))<enter>");
    pty.expect("still42");
    pty.types("fg<enter>");
    pty.expect("dalembert");
    pty.idle(Duration::from_millis(150));
    assert_alive(&mut pty, "bg, then fg");
    pty.types(":quit<enter>");
    pty.expect("still42");
    pty.idle(Duration::from_millis(200));
    assert_eq!(pty.leftovers(), [""; 0], "ended after bg and fg");
}

/// Started by the terminal itself: a stop would be for ever.
fn no_shell_to_return_to(program: &Path) {
    let mut pty = started(launch(program));
    pty.types("<c-z>");
    pty.expect("no shell");
    pty.signal(-1, Signal::TSTP);
    assert_alive(&mut pty, "Ctrl-Z without a shell");
}

/// Gone soon, on a machine that is busy too, and without having spun in between.
#[track_caller]
fn assert_gone(processes: &[i32], spent: f64) {
    let end = Instant::now() + SECOND * 5;
    let mut now = spent;
    for &process in processes {
        while let Some(seconds) = pty::alive(process) {
            now = now.max(seconds);
            assert!(
                Instant::now() < end,
                "process {process} goes on without a terminal ({seconds} s of processor)"
            );
            thread::sleep(Duration::from_millis(20));
        }
    }
    assert!(now - spent < 0.2, "{} s of processor after the end of the terminal", now - spent);
}

fn the_window_closes(program: &Path) {
    let mut pty = started(launch(program));
    let processes = pty.processes();
    let spent = spent(proper(&pty));
    pty.hang_up();
    assert_gone(&processes, spent);
}

fn the_window_closes_while_hangups_are_ignored(program: &Path) {
    let mut pty = started(launch(program).in_script("trap '' HUP; \"$PROGRAM\"; exit $?"));
    let processes = pty.processes();
    let spent = spent(proper(&pty));
    pty.hang_up();
    assert_gone(&processes[1..], spent);
}

/// A stopped line, a wedged multiplexer: the program hangs in its output, and must end all the same.
fn a_terminal_that_takes_no_bytes(program: &Path) {
    let mut pty = started(launch(program));
    let proper = proper(&pty);
    pty.pause(true);
    for size in 0..60 {
        pty.resize(40 + size % 2, 150);
        thread::sleep(Duration::from_millis(10));
    }
    pty.signal(-1, Signal::TERM);
    let end = Instant::now() + 6 * SECOND;
    while pty::alive(proper).is_some() && Instant::now() < end {
        thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(pty::alive(proper), None, "it waits for a terminal that takes nothing");
    pty.pause(false);
    assert_eq!(pty.exit_code(), Some(143));
}

fn bursts_of_keys(program: &Path) {
    for count in [1_500, 5_000, 20_000] {
        let mut pty = started(launch(program));
        let start = Instant::now();
        pty.types(":");
        pty.send(&b"j".repeat(count));
        pty.types("-last");
        pty.expect("j-last");
        assert!(start.elapsed() < 4 * SECOND, "{:?} for {count} keys", start.elapsed());
        // One backspace a key, and one more closes nothing: each was counted.
        pty.send(&b"\x7f".repeat(count + 4));
        pty.types("end");
        pty.expect(":jend");
    }
}

fn hostile_input(program: &Path) {
    for (name, bytes) in [
        ("a mouse at 0, 0", b"\x1b[<0;0;0M".to_vec()),
        ("a mouse beyond all screens", b"\x1b[<99999999999999;1;1M".to_vec()),
        ("a cursor at 0, 0", b"\x1b[0;0R".to_vec()),
        ("high bytes", (128..=255).collect::<Vec<u8>>().repeat(40)),
        ("five hundred introducers", b"\x1b[".repeat(500)),
        ("zero bytes", b"\xff\xfe\0\0".to_vec()),
        ("an open string", b"\x1b]0;title".to_vec()),
        ("half a character", b"\xf0\x9f".to_vec()),
        ("five thousand turns of the wheel", b"\x1b[<64;5;5M".repeat(5000)),
    ] {
        let mut pty = started(launch(program));
        pty.send(&bytes);
        pty.idle(Duration::from_millis(200));
        assert_alive(&mut pty, name);
        pty.types(":quit<enter>");
        assert_ended(&mut pty, 0, name);
    }
}

fn answers_nobody_asked_for(program: &Path) {
    let mut pty = started(launch(program));
    pty.types(":clean");
    pty.expect(":clean");
    pty.send(b"\x1b]11;rgb:1e1e/1e1e/1e1e\x1b\\\x1b[?62;22c\x1b[12;40R\x1b[?2026;2$y\x1bP>|XTerm(388)\x1b\\");
    pty.idle(Duration::from_millis(200));
    pty.types("-field");
    pty.expect(":clean-field");
}

fn pastes(program: &Path) {
    let mut pty = started(launch(program));
    pty.types(":");
    pty.paste("two\x1b words");
    pty.idle(Duration::from_millis(100));
    assert!(!pty.screen().contains('\x1b'));
    assert_alive(&mut pty, "a paste with an escape");

    pty.types(":");
    pty.paste(&"x".repeat(1_000_000));
    pty.idle(Duration::from_millis(200));
    assert_alive(&mut pty, "a paste of a megabyte");

    // The end of this one never comes; two seconds of silence are its end.
    pty.types(":");
    pty.send(b"\x1b[200~left open");
    thread::sleep(Duration::from_millis(2500));
    assert_alive(&mut pty, "an open paste");
    pty.types(":quit<enter>");
    assert_ended(&mut pty, 0, "pastes");
}

fn resizing(program: &Path) {
    let mut pty = started(launch(program));
    let mut state = 3_u64;
    let mut random = |below: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (1 + (state >> 33) % below) as u16
    };
    for _ in 0..1000 {
        pty.resize(random(120), random(200));
    }
    pty.resize(24, 80);
    pty.idle(Duration::from_millis(300));
    pty.expect("dalembert");
    assert_alive(&mut pty, "a thousand sizes");
}

fn tiny_sizes(program: &Path) {
    for (rows, columns) in [(1, 1), (1, 200), (60, 1), (2, 3), (0, 0), (500, 1000)] {
        let mut pty = started(launch(program));
        pty.resize(rows, columns);
        pty.idle(Duration::from_millis(150));
        pty.types("<down>");
        pty.idle(Duration::from_millis(100));
        assert!(pty.runs(), "{rows} x {columns} ended it");
        pty.resize(24, 80);
        pty.expect("dalembert");
        assert_alive(&mut pty, "a tiny window");
    }
}

fn bytes_on_the_line(program: &Path) {
    let mut pty = started(launch(program));
    pty.idle(Duration::from_millis(500));
    let first = pty.raw();
    assert!(first.len() <= 6_000, "{} bytes for the first frame", first.len());

    let proper = proper(&pty);
    let before = spent(proper);
    thread::sleep(2 * SECOND);
    assert_eq!(pty.count(), first.len(), "bytes while nothing happens");
    assert!(spent(proper) - before < 0.02, "it works while nothing happens");

    // The workbench goes from its first problem to the list; the other program has one screen alone.
    leave(&mut pty);
    pty.types(":");
    pty.expect(":");
    pty.idle(Duration::from_millis(100));
    // What is offered for a letter differs; the letter in the middle of them stands for a key.
    let mut costs = ["a", "e", "o", "w", "z"].map(|letter| {
        let before = pty.count();
        pty.types(letter);
        pty.expect(&format!(":{letter}"));
        pty.idle(Duration::from_millis(100));
        let cost = pty.count() - before;
        pty.send(b"\x7f");
        pty.idle(Duration::from_millis(100));
        cost
    });
    costs.sort_unstable();
    assert!(costs[2] <= 300, "{costs:?} bytes for a key");

    // Between entering and leaving there is nothing but whole synchronized updates.
    let raw = String::from_utf8(pty.raw()).expect("UTF-8");
    let frames: Vec<&str> = raw.split("\x1b[?2026h").collect();
    assert!(frames.len() >= 4, "{} frames", frames.len() - 1);
    for frame in &frames[1..] {
        assert!(frame.ends_with("\x1b[?2026l"), "bytes outside of a frame: {frame:?}");
    }
}

/// Sequences that the environment does not promise are not sent.
fn plain_terminals(program: &Path) {
    for (term, lang, colorterm) in [
        ("xterm-256color", "C", ""),
        ("xterm", "pt_BR.ISO-8859-1", "truecolor"),
        ("linux", "en_US.UTF-8", "truecolor"),
        ("vt100", "en_US.UTF-8", ""),
    ] {
        let mut pty =
            started(launch(program).env("TERM", term).env("LANG", lang).env("COLORTERM", colorterm));
        assert_alive(&mut pty, term);
        let raw = pty.raw();
        assert!(raw.is_ascii(), "TERM={term} LANG={lang}: {:?}", String::from_utf8_lossy(&raw));
        assert!(!contains(&raw, "8;2;"), "TERM={term} LANG={lang}: true colours");
    }
    for (name, value, unwanted) in [("COLORTERM", "", &["8;2;"][..]), ("NO_COLOR", "1", &["8;2;", "8;5;"])] {
        let mut pty = started(launch(program).env(name, value));
        assert_alive(&mut pty, name);
        for unwanted in unwanted {
            assert!(!contains(&pty.raw(), unwanted), "{name}={value}: colours");
        }
    }
}

fn hopeless_terminals(program: &Path) {
    for launch in [launch(program).env("TERM", "dumb"), launch(program).without("TERM")] {
        let mut pty = launch.start();
        assert_eq!(pty.exit_code(), Some(2), "{}", pty.screen());
        pty.expect("cannot place text on a screen");
        assert_eq!(pty.leftovers(), [""; 0]);
        assert!(!contains(&pty.raw(), "\x1b"), "{:?}", String::from_utf8_lossy(&pty.raw()));
    }
}

#[test]
fn where_the_workbench_cannot_be_drawn_it_names_the_plain_command() {
    let mut pty = launch(&pty::program()).env("TERM", "dumb").start();
    assert_eq!(pty.exit_code(), Some(2), "{}", pty.screen());
    pty.expect("dalembert solve");
}

/// The program proper, behind its guard.
fn proper(pty: &Pty) -> i32 {
    *pty.processes().last().expect("it runs")
}

/// The processor seconds of a process that runs.
fn spent(process: i32) -> f64 {
    pty::alive(process).expect("it runs")
}

fn contains(raw: &[u8], text: &str) -> bool {
    raw.windows(text.len()).any(|window| window == text.as_bytes())
}

/// The work is kept by every end that leaves the program a moment.
#[test]
fn the_autosave_runs_before_the_end() {
    type End = fn(&mut Pty);
    let ends: [(&str, u32, End); 4] = [
        ("TERM", 143, |pty| pty.signal(-1, Signal::TERM)),
        ("HUP to the guard", 129, |pty| pty.signal(0, Signal::HUP)),
        ("a panic", 101, |pty| pty.types(":fault panic<enter>")),
        ("Ctrl-Z, then TERM", 143, |pty| {
            pty.types("<c-z>");
            pty.idle(Duration::from_millis(100));
            pty.signal(-1, Signal::TERM);
        }),
    ];
    for (name, code, end) in ends {
        let folder = tempfile::tempdir().unwrap();
        let kept = folder.path().join("kept");
        let mut pty = started(launch(&pty::lifecycle()).env("LIFECYCLE_AUTOSAVE", kept.to_str().unwrap()));
        pty.types("abc");
        pty.expect("keys=3");
        end(&mut pty);
        assert_ended(&mut pty, code, name);
        let kept = std::fs::read_to_string(kept).unwrap_or_default();
        assert!(kept.starts_with("keys = "), "{name}: {kept:?}");
    }
}
