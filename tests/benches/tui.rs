//! Benchmark of the workbench at a pseudo-terminal: response times and bytes sent.
//!
//! Measures the binary that the variable `DALEMBERT` names. Prints `name<TAB>figure<TAB>goal`, a row a line;
//! `cargo xtask bench` makes a table of them. Times end when the last byte of the frame has come.

use std::{
    env,
    path::PathBuf,
    process::{Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use dalembert_core::find;
use dalembert_plugins as _;
use dalembert_tests::pty::{self, Launch, PATIENCE, Pty};

const ROUNDS: usize = 40;
/// Frames end so.
const END: &[u8] = b"\x1b[?2026l";
/// Nothing more comes after so long.
const SILENCE: Duration = Duration::from_millis(40);
/// Columns of the widest form beside its results.
const WIDEST_FORM: usize = 66;
const FAN: &str = "vibration/rotating-unbalance";

fn main() {
    start();
    frames();
    results();
    while_solving();
    cancel();
    idle();
    slow_line();
    pixels();
}

/// From the start of the process to the end of its first frame.
fn start() {
    for (rows, columns) in [(24, 80), (50, 200)] {
        let times = (0..ROUNDS / 2).map(|_| {
            let pty = open(None, |launch| launch.size(rows, columns));
            frame_after(&pty, 0, pty.started).0
        });
        row(&format!("start to first frame, {columns}×{rows}"), &figures(times.collect()), "≤ 20 ms");
    }
    let version = (0..ROUNDS / 2).map(|_| {
        let start = Instant::now();
        let status = Command::new(program()).arg("--version").stdout(Stdio::null()).status();
        assert!(status.is_ok_and(|status| status.success()), "the program cannot be run");
        start.elapsed()
    });
    row("start to the end of --version", &figures(version.collect()), "");
}

/// Keys that solve nothing: a frame is drawn, and its differences go over the line.
fn frames() {
    for (rows, columns) in [(24, 80), (50, 200)] {
        let mut pty = opened(FAN, |launch| launch.size(rows, columns));
        let whole = pty.count();
        let (times, bytes): (Vec<_>, Vec<_>) = (0..ROUNDS)
            .map(|n| {
                let (count, start) = (pty.count(), Instant::now());
                pty.types(down_and_up(n));
                frame_after(&pty, count, start)
            })
            .unzip();
        let goal = if rows == 50 { "≤ 2 ms to draw" } else { "" };
        row(&format!("key that moves to frame, {columns}×{rows}"), &figures(times), goal);
        row(&format!("  bytes of it, {columns}×{rows}"), &most(&bytes), "≤ 300 B");
        if rows == 24 {
            row("first frame, 80×24, one synchronised update", &format!("{whole} B"), "≤ 6000 B");
        }
    }
}

/// A key that changes an input, to the frame with its answers.
fn results() {
    for (id, keys, rows, columns, goal) in [
        (FAN, "<down>", 50, 160, "≤ 16 ms"),
        ("vibration/modal-analysis", "<down><down><down>", 50, 160, "≤ 16 ms"),
        ("vibration/rotor-dynamics", "<down><down>", 50, 160, "≤ 16 ms"),
        ("virtual-work/mechanism", "<down><down><down><down><down>", 50, 160, "≤ 16 ms"),
        ("virtual-work/engine", "<down>", 50, 160, "≤ 16 ms"),
    ] {
        if find(id).is_none() {
            row(&format!("key to results, {id}"), "is not linked", "");
            continue;
        }
        let mut pty = opened(id, |launch| launch.size(rows, columns));
        pty.types(keys);
        quiet(&pty, SILENCE);
        let (times, bytes): (Vec<_>, Vec<_>) = (0..ROUNDS)
            .map(|n| {
                let (before, count, start) = (beside_form(&pty), pty.count(), Instant::now());
                pty.types(if n % 2 == 0 { "+" } else { "-" });
                let first = frame_after(&pty, count, start);
                quiet(&pty, SILENCE);
                let (last, all) = last_frame(&pty, count, start);
                assert!(beside_form(&pty) != before, "no result changes:\n{}", pty.screen());
                (last.max(first.0), all)
            })
            .unzip();
        row(&format!("key to results, {id}"), &figures(times), goal);
        row(&format!("  bytes of it, {columns}×{rows}"), &most(&bytes), "");
    }
    let mut pty = opened(FAN, |launch| launch);
    let bytes: Vec<usize> = (0..ROUNDS)
        .map(|n| {
            let (count, start) = (pty.count(), Instant::now());
            pty.types(if n % 2 == 0 { "+" } else { "-" });
            quiet(&pty, SILENCE);
            last_frame(&pty, count, start).1
        })
        .collect();
    row("bytes of a key that changes every answer of the fan, 80×24", &most(&bytes), "≤ 300 B");
}

/// Keys while a solve of ten seconds runs: those that move, and those that make it worthless.
fn while_solving() {
    let mut pty = opened(FAN, faulty);
    let mut moving = Vec::new();
    let mut changing = Vec::new();
    for round in 0..4 {
        long_solve(&mut pty);
        for n in 0..25 {
            let (count, start) = (pty.count(), Instant::now());
            pty.types(down_and_up(n));
            moving.push(frame_after(&pty, count, start).0);
        }
        pty.types("<home>");
        quiet(&pty, SILENCE);
        for n in 0..10 {
            if n > 0 {
                long_solve(&mut pty);
            }
            let (count, start) = (pty.count(), Instant::now());
            pty.types(if (round + n) % 2 == 0 { "+" } else { "-" });
            frame_after(&pty, count, start);
            quiet(&pty, SILENCE);
            assert!(!pty.screen().contains("solving"), "no results:\n{}", pty.screen());
            changing.push(last_frame(&pty, count, start).0);
        }
    }
    row("key that moves, while a 10 s solve runs", &figures(moving), "p99 ≤ 30 ms");
    row("key to results, while a 10 s solve runs", &figures(changing), "p99 ≤ 30 ms");
}

/// Esc while a solve of ten seconds runs, to the word that it is stopped. Half of it is the wait for what may follow
/// an escape.
fn cancel() {
    let mut pty = opened(FAN, faulty);
    let times = (0..ROUNDS / 2).map(|_| {
        long_solve(&mut pty);
        let (count, start) = (pty.count(), Instant::now());
        pty.types("<esc>");
        let time = frame_after(&pty, count, start).0;
        assert!(pty.sees("solve cancelled", PATIENCE), "it goes on:\n{}", pty.screen());
        time
    });
    row("Esc to the end of a solve", &figures(times.collect()), "≤ 50 ms");
}

fn idle() {
    let pty = opened(FAN, |launch| launch);
    quiet(&pty, Duration::from_secs(2));
    let processes = pty.processes();
    let spent = || processes.iter().filter_map(|process| pty::alive(*process)).sum::<f64>();
    let (count, before) = (pty.count(), spent());
    thread::sleep(Duration::from_secs(3));
    let percent = (spent() - before) / 3.0 * 100.0;
    row("idle for 3 s", &format!("{} B, {percent:.1} % CPU", pty.count() - count), "0 B, 0 % CPU");
}

/// Keys on a line of 9600 baud, alone and while an animation plays.
fn slow_line() {
    for animation in [false, true] {
        // From 100 columns on the animation is seen beside the form.
        let columns = if animation { 120 } else { 80 };
        let mut pty = open(Some("vibration/modal-analysis"), |launch| launch.baud(9600).size(24, columns));
        let silence = Duration::from_millis(700);
        quiet(&pty, silence);
        if animation {
            pty.types("]]]np<tab>");
            // The animation plays from now on: nothing is ever silent again.
            thread::sleep(Duration::from_secs(12));
        }
        let before = pty.count();
        let begin = Instant::now();
        let mut times = Vec::new();
        for n in 0..ROUNDS / 2 {
            let pointed = pointed_line(&pty);
            let start = Instant::now();
            pty.types(down_and_up(n));
            while pointed_line(&pty) == pointed && start.elapsed() < PATIENCE {
                thread::sleep(Duration::from_millis(2));
            }
            assert!(start.elapsed() < PATIENCE, "the key does nothing:\n{}", pty.screen());
            times.push(start.elapsed());
            // Not always at the same frame of the animation.
            thread::sleep(Duration::from_millis(370));
            if !animation {
                quiet(&pty, Duration::from_millis(200));
            }
        }
        let what = if animation { "while an animation plays" } else { "alone" };
        let rate = (pty.count() - before) as f64 / begin.elapsed().as_secs_f64();
        row(&format!("key to screen at 9600 baud, {what}"), &p95(times), "p95 ≤ 1.5 s");
        row("  bytes a second meanwhile", &format!("{rate:.0} B/s"), "");
    }
}

/// Pictures in pixels at a terminal that answers as Kitty does: keys that change what they show, a cursor, an animation.
fn pixels() {
    let like_kitty =
        |id, columns| opened(id, |launch| launch.size(50, columns).answering(Duration::ZERO, pty::KITTY));
    let has_picture = |pty: &Pty| pty.raw().windows(5).any(|bytes| bytes == b"a=T,q");
    for (id, keys, what) in [
        (FAN, "<down>", "key to results with a picture"),
        ("virtual-work/four-bar", "<down>", "key to results with a picture"),
        (FAN, "<a-3><right><right><right>", "cursor of a plot in pixels"),
    ] {
        let mut pty = like_kitty(id, 200);
        if !has_picture(&pty) {
            row(what, "is not built: feature `pixels`", "");
            return;
        }
        pty.types(keys);
        quiet(&pty, Duration::from_millis(300));
        let moves = keys.contains("right");
        let (times, bytes): (Vec<_>, Vec<_>) = (0..ROUNDS)
            .map(|n| {
                let (count, start) = (pty.count(), Instant::now());
                pty.types(match (moves, n % 2 == 0) {
                    (true, _) => "<right>",
                    (false, true) => "+",
                    (false, false) => "-",
                });
                let first = frame_after(&pty, count, start);
                quiet(&pty, SILENCE);
                let (last, all) = last_frame(&pty, count, start);
                (last.max(first.0), all)
            })
            .unzip();
        row(&format!("{what}, {id}, 200×50"), &figures(times), "≤ 30 ms");
        row("  bytes of it", &most(&bytes), "≤ 60 kB");
    }
    let mut pty = like_kitty("vibration/modal-analysis", 160);
    pty.types("]]]np");
    thread::sleep(Duration::from_secs(1));
    let before = pty.count();
    thread::sleep(Duration::from_secs(3));
    let sent = pty.since(before);
    let frames = sent.windows(END.len()).filter(|bytes| *bytes == END).count();
    let rate = format!("{:.0} frames/s, {} B a frame", frames as f64 / 3.0, sent.len() / frames.max(1));
    row("animation in pixels, 160×50", &rate, "≤ 60 kB a frame");
}

/// Text of the screen beside the form, where it is wide.
fn beside_form(pty: &Pty) -> String {
    pty.screen().lines().flat_map(|line| line.chars().skip(WIDEST_FORM)).collect()
}

/// Keys that never leave the first lines of a form, or one would wait for what does not happen.
fn down_and_up(n: usize) -> &'static str {
    if n % 8 < 4 { "<down>" } else { "<up>" }
}

/// The line that the form points at.
fn pointed_line(pty: &Pty) -> Option<String> {
    let screen = pty.screen();
    screen.lines().find(|line| line.starts_with("│▸")).map(str::to_owned)
}

fn program() -> PathBuf {
    let program = env::var_os("DALEMBERT");
    program.expect("DALEMBERT names the built program: run `cargo xtask bench tui`").into()
}

fn faulty(launch: Launch) -> Launch {
    launch.env("DALEMBERT_FAULTS", "1")
}

/// The program, started on the list or on an analysis.
fn open(id: Option<&str>, with: impl FnOnce(Launch) -> Launch) -> Pty {
    let launch = with(Launch::new(program()));
    match id {
        Some(id) => launch.argument(id).start(),
        None => launch.start(),
    }
}

/// The same, its first frame drawn and solved.
fn opened(id: &str, with: impl FnOnce(Launch) -> Launch) -> Pty {
    let pty = open(Some(id), with);
    pty.expect("dalembert");
    quiet(&pty, Duration::from_millis(150));
    pty
}

/// Begins a solve of ten seconds.
fn long_solve(pty: &mut Pty) {
    pty.types(":fault long<enter>");
    pty.expect("solving");
    quiet(pty, SILENCE);
}

/// Waits until nothing comes for so long.
fn quiet(pty: &Pty, silence: Duration) {
    loop {
        let count = pty.count();
        thread::sleep(silence);
        if pty.count() == count {
            return;
        }
    }
}

/// The time and the length of the first frame that ends after so many bytes.
fn frame_after(pty: &Pty, count: usize, start: Instant) -> (Duration, usize) {
    loop {
        assert!(start.elapsed() < PATIENCE, "no frame:\n{}", pty.screen());
        if let Some(at) = pty.since(count).windows(END.len()).position(|bytes| bytes == END) {
            let length = at + END.len();
            return (came(pty, count + length, start), length);
        }
        // What is read has its time: to look often would only take the processor from the program.
        thread::sleep(Duration::from_millis(2));
    }
}

/// The time of the last frame that has come since, and the length of all of them.
fn last_frame(pty: &Pty, count: usize, start: Instant) -> (Duration, usize) {
    let length = pty.since(count).len();
    (came(pty, count + length, start), length)
}

fn came(pty: &Pty, count: usize, start: Instant) -> Duration {
    pty.arrival(count).map_or(PATIENCE, |time| time.saturating_duration_since(start))
}

fn row(name: &str, figure: &str, goal: &str) {
    println!("{name}\t{figure}\t{goal}");
}

fn figures(mut times: Vec<Duration>) -> String {
    times.sort();
    let of = |share: usize| times[(times.len() * share / 100).min(times.len() - 1)].as_secs_f64() * 1e3;
    format!("{:.1} ms, p99 {:.1} ms", of(50), of(99))
}

fn p95(mut times: Vec<Duration>) -> String {
    times.sort();
    let of = |share: usize| times[times.len() * share / 100].as_secs_f64();
    format!("{:.2} s, p95 {:.2} s", of(50), of(95))
}

fn most(bytes: &[usize]) -> String {
    let mut bytes = bytes.to_vec();
    bytes.sort_unstable();
    format!("{} B, at most {} B", bytes[bytes.len() / 2], bytes[bytes.len() - 1])
}
