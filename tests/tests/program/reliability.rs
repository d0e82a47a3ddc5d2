//! Hostile and unlucky input of the whole program: it ends by itself, soon, with an error that names the repair, and
//! nothing is lost.

use std::{
    fmt::Write as _,
    fs,
    os::unix::fs::{MetadataExt as _, PermissionsExt as _},
    path::Path,
    process::{Command, Output, Stdio},
    time::Duration,
};

use dalembert_tests::{process, pty};
use tempfile::TempDir;

/// Time in which the program answers on a machine that does other work too. Each of these files once took more than
/// forty seconds, or did not end.
const SOON: Duration = Duration::from_secs(10);

const TWO_PLANES: &str = "analysis = \"balancing/two-plane\"\n[inputs]\nplane_b = \"1 m\"\n\
    correction_a.radius.radius = \"60 mm\"\ncorrection_b.radius.radius = \"60 mm\"\nway = \"drill\"\n";

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder can be made")
}

/// Output of the program, which ends by itself within [`SOON`].
fn solved_soon(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = crate::program();
    let (status, [stdout, stderr]) = process::ended(command.args(arguments).current_dir(folder), SOON);
    let status = status.unwrap_or_else(|| panic!("{arguments:?} runs for more than {SOON:?}"));
    Output { status, stdout, stderr }
}

fn refused(folder: &Path, text: &str) -> String {
    fs::write(folder.join("x.toml"), text).expect("the file is written");
    let output = solved_soon(folder, &["solve", "x.toml"]);
    let error = String::from_utf8(output.stderr).expect("errors are UTF-8");
    assert_eq!(output.status.code(), Some(2), "{error}");
    error
}

#[test]
fn thousands_of_wrong_rows_are_refused_at_once() {
    let folder = folder();
    let row =
        "[[inputs.masses]]\nmass = \"1 kgg\"\nradius = \"1 m\"\nangle = \"0 deg\"\nposition = \"0 m\"\n";
    for rows in [20, 2_000, 10_000] {
        let error = refused(folder.path(), &(TWO_PLANES.to_owned() + &row.repeat(rows)));
        assert!(error.contains("kgg") || error.contains("at most"), "{rows} rows: {error}");
        assert!(error.len() < 100_000, "{rows} rows: {} bytes of errors", error.len());
    }
}

#[test]
fn thousands_of_equal_names_are_refused_at_once() {
    let folder = folder();
    for (list, shape) in [("nodes", "virtual-work/equilibrium"), ("joints", "rigid-body/rate-of-change")] {
        let mut text = format!("analysis = \"{shape}\"\n");
        for _ in 0..3_000 {
            let _ = writeln!(text, "[[inputs.{list}]]\nname = \"A\"");
        }
        refused(folder.path(), &text);
    }
}

#[test]
fn lists_longer_than_their_limit_are_refused_before_they_are_solved() {
    let folder = folder();
    let (link, load) = (
        "{ driving = \"1 m\", driven = \"2 m\" }, ",
        "{ lever = \"1\", kind = { force = { force = \"1 N\", arm = \"1 m\" } } }, ",
    );
    let sought = "sought = { force = { lever = \"2\", arm = \"1 m\" } }";
    for (links, loads) in [(10_000, 1), (1, 10_000)] {
        let (links, loads) = (link.repeat(links), load.repeat(loads));
        let text = format!(
            "analysis = \"virtual-work/compound-lever\"\n[inputs]\nlinks = [{links}]\nloads = [{loads}]\n{sought}\n"
        );
        let error = refused(folder.path(), &text);
        assert!(error.contains("10000 rows: at most"), "{error}");
    }
}

#[test]
fn arguments_that_are_repeated_cannot_drive_the_terminal() {
    for hostile in ["--\u{9b}31m", "--\u{202e}gnp.exe", "--set\u{200b}x", "--format=\u{1b}]52;c;AAAA\u{7}"] {
        for arguments in [vec![hostile], vec!["solve", hostile], vec!["solve", "x", "--json", hostile]] {
            let output = crate::program().args(&arguments).output().expect("the program runs");
            assert_eq!(output.status.code(), Some(2), "{arguments:?}");
            for stream in [&output.stdout, &output.stderr] {
                let text = String::from_utf8_lossy(stream);
                let raw = |c: char| c != '\n' && (c.is_control() || "\u{200b}\u{202e}".contains(c));
                assert!(!text.contains(raw), "{arguments:?}: {text:?}");
            }
        }
    }
}

#[test]
fn titles_and_names_are_escaped_in_json() {
    let folder = folder();
    let text = "format = 2\ntitle = \"\\u009b31m\\u202e\\u2028t\"\nanalysis = \"balancing/single-plane\"\n[inputs]\n";
    fs::write(folder.path().join("x.toml"), text).expect("the file is written");
    let output = solved_soon(folder.path(), &["solve", "x.toml", "--format", "json"]);
    let text = String::from_utf8(output.stdout).expect("JSON is UTF-8");
    assert!(
        !text.contains(|c: char| c != '\n' && (c.is_control() || "\u{202e}\u{2028}".contains(c))),
        "{text:?}"
    );
}

#[test]
fn an_output_takes_the_place_of_no_input_and_of_no_other_file() {
    let folder = folder();
    let (problem, notes) = (folder.path().join("p.toml"), folder.path().join("notes.txt"));
    let begun =
        crate::program().args(["new", "vibration/gun-recoil", "--case", "1"]).output().expect("it runs");
    fs::write(&problem, &begun.stdout).expect("the file is written");
    fs::write(&notes, "mine").expect("the file is written");
    for output in ["p.toml", "notes.txt"] {
        let run = solved_soon(folder.path(), &["solve", "p.toml", "-o", output]);
        assert_eq!(run.status.code(), Some(2), "{output}");
    }
    // Not even with --force a problem.
    let run = solved_soon(folder.path(), &["solve", "p.toml", "-o", "p.toml", "--force"]);
    assert_eq!(run.status.code(), Some(2));
    assert_eq!(fs::read(&problem).expect("it is there"), begun.stdout);
    assert_eq!(fs::read_to_string(&notes).expect("it is there"), "mine");
}

#[test]
fn a_limit_of_the_size_of_files_is_an_error_and_leaves_nothing() {
    let folder = folder();
    // One block: less than a note.
    let script = "ulimit -f 1; exec \"$0\" solve vibration/gun-recoil --case 1 -o note.html";
    let run = Command::new("sh")
        .arg("-c")
        .arg(script)
        .arg(pty::program())
        .current_dir(folder.path())
        .env("LANG", "C.UTF-8")
        .env("XDG_CONFIG_HOME", folder.path())
        .stdin(Stdio::null())
        .output()
        .expect("there is a shell");
    let error = String::from_utf8_lossy(&run.stderr);
    assert_eq!(run.status.code(), Some(2), "{:?}: {error}", run.status);
    assert!(error.contains("note.html"), "{error}");
    assert_eq!(fs::read_dir(folder.path()).expect("the folder is read").count(), 0);
}

#[test]
fn owner_group_and_permissions_survive_a_save() {
    let folder = folder();
    let path = folder.path().join("note.html");
    for (mode, owner, group) in [(0o664, 1234, 4321), (0o640, 0, 4321)] {
        fs::write(&path, "old").expect("the file is written");
        // Another owner is for root alone to give; without it, the file keeps those it has.
        let _ = std::os::unix::fs::chown(&path, Some(owner), Some(group));
        fs::set_permissions(&path, fs::Permissions::from_mode(mode)).expect("the mode is set");
        let before = fs::metadata(&path).expect("it is there");
        let run = solved_soon(
            folder.path(),
            &["solve", "vibration/gun-recoil", "--case", "1", "-o", "note.html", "--force"],
        );
        assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
        let after = fs::metadata(&path).expect("it is there");
        assert!(after.len() > before.len(), "nothing was written");
        let kept = |file: &fs::Metadata| (file.mode() & 0o7777, file.uid(), file.gid());
        assert_eq!(kept(&after), kept(&before));
        fs::remove_file(&path).expect("it is removed");
    }
}

#[test]
fn a_knee_near_its_dead_centre_is_answered_without_cancellation() {
    // 2 L sin²(α/2), L of the case, in 60 digits.
    let run = crate::program()
        .args(["solve", "virtual-work/toggle-press", "--case", "1", "--set", "angle=1e-3 deg"])
        .args(["--format", "json"])
        .output()
        .expect("the program runs");
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).expect("it is JSON");
    let stroke = json["answers"]["remaining_stroke"]["si"].as_f64().expect("it is answered");
    let want = 7.615_435_494_471_1e-11;
    assert!((stroke / want - 1.0).abs() < 1e-11, "{stroke:e}");
}

#[test]
fn what_is_not_a_format_or_a_display_is_refused() {
    let folder = folder();
    for line in [
        "show = \"x\"",
        "show = []",
        "show = 3",
        "format = \"zzz\"",
        "format = -1",
        "format = 1.5",
        "show.amplitude = \"mm; 0 digits\"",
        "show.amplitude = \"mm; 99 digits\"",
    ] {
        let error = refused(folder.path(), &format!("{line}\nanalysis = \"vibration/base-excitation\"\n"));
        assert!(error.contains("write") || error.contains("is a table"), "{line}: {error}");
    }
    let dated = "format = 2\nanalysis = \"vibration/gun-recoil\"\n[inputs]\nstiffness = \"1970-01-01\"\n";
    assert!(refused(folder.path(), dated).contains("1970-01-01"));
}
