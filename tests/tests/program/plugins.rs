//! Plugins that misbehave: the program lives, the culprit is named, the others work.

use std::{
    fs,
    path::PathBuf,
    process::{Command, Output, Stdio},
    time::{Duration, Instant},
};

use dalembert_tests::pty::Launch;

const CULPRIT: &str = "misbehaving/plugin";

/// The program with the analysis that misbehaves.
fn misbehaving() -> PathBuf {
    PathBuf::from(env!("CARGO_BIN_EXE_misbehaving"))
}

fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(misbehaving());
    command.args(arguments).stdin(Stdio::null()).env("LANG", "C.UTF-8");
    command.env("XDG_CONFIG_HOME", env!("CARGO_TARGET_TMPDIR")).output().expect("the program runs")
}

/// Exit status and everything that is printed, for a misdeed by its number.
fn solved(deed: u8) -> (Option<i32>, String) {
    let output = run(&["solve", CULPRIT, "--set", &format!("deed={deed}")]);
    let text =
        [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("it is UTF-8")).concat();
    (output.status.code(), text)
}

#[test]
fn what_an_analysis_does_is_named_and_sets_the_status() {
    for (deed, status, words) in [
        (1, 2, "misbehaving/plugin panicked at"),
        (3, 1, "cannot be represented: y"),
        (4, 1, "L = n is in 1, not in kg"),
        (8, 1, "cannot be represented: y"),
        (9, 0, "Misbehaving plugin"),
    ] {
        let (found, text) = solved(deed);
        assert_eq!(found, Some(status), "misdeed {deed}: {text}");
        assert!(text.contains(words), "misdeed {deed}: {text}");
    }
}

#[test]
fn ten_million_points_are_drawn() {
    let start = Instant::now();
    let (status, text) = solved(7);
    assert_eq!(status, Some(0), "{text}");
    assert!(start.elapsed() < Duration::from_mins(1), "{:?}", start.elapsed());
}

#[test]
fn an_id_that_is_taken_is_left_out_by_name() {
    let output = run(&["list"]);
    let (listed, said) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(listed.matches("vibration/gun-recoil").count(), 1, "{listed}");
    assert!(said.contains("is left out: another analysis has its id vibration/gun-recoil"), "{said}");
}

#[test]
fn the_workbench_outlives_an_analysis_that_panics_or_never_ends() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    for (deed, words) in [(1, "row 3 is empty"), (2, "Misbehaving plugin")] {
        let file = folder.path().join(format!("deed-{deed}.toml"));
        let text = format!("format = 2\nanalysis = \"{CULPRIT}\"\n[inputs]\ndeed = \"{deed}\"\n");
        fs::write(&file, text).expect("the file is written");
        let mut pty = Launch::new(misbehaving()).argument(&file).start();
        pty.expect(words);
        // Another problem is opened and solved.
        pty.types("<esc>Base excitation<enter>");
        pty.expect("▸ Base excitation");
        pty.types(":quit<enter>");
        assert_eq!(pty.exit_code(), Some(0), "misdeed {deed}: {}", pty.screen());
    }
}
