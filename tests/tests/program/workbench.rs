//! The program itself, at a terminal: what no test without one can see.

use std::{fs, path::Path, time::Duration};

use dalembert_tests::pty::{self, Launch, Pty, Signal};

fn started(launch: Launch) -> Pty {
    let pty = launch.start();
    pty.expect("dalembert");
    pty
}

/// A program in a home folder that outlives it.
fn at_home(home: &Path) -> Launch {
    Launch::new(pty::program()).env("XDG_STATE_HOME", home.to_str().expect("a readable path"))
}

/// The newest speed of the fan is 1500 rpm: in the form, the results, the working and the plot.
#[test]
fn a_user_changes_the_speed_of_the_fan_and_sees_everything_follow() {
    let mut pty = started(Launch::new(pty::program()));
    pty.expect("19.456");
    pty.types("<end><del>1500 rpm<enter>");
    pty.expect("4.5535");
    pty.types("]<end>");
    pty.expect("4.5535 mm");
    pty.types("]<right>");
    pty.expect("1500 rpm");
    pty.types("q");
    pty.expect("quit without saving");
    pty.types("<down><enter>");
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]));
}

/// A terminal writes Alt as an escape before the key, so that over a slow line Esc and `:` arrive as Alt with `:`.
#[test]
fn escape_and_a_key_that_arrive_together_are_two_keys() {
    let mut pty = started(Launch::new(pty::program()));
    pty.expect("19.456");
    pty.types("<tab>");
    pty.idle(Duration::from_millis(150));
    pty.send(b"\x1b:quit");
    pty.expect(":quit");
    pty.send(b"\x1b\x1b");
    pty.idle(Duration::from_millis(150));
    assert!(!pty.screen().contains(":quit"), "{}", pty.screen());
    // Likewise in a line of text: the list opens with the cursor in its search.
    pty.send(b"\x1b");
    pty.expect("List of analyses");
    pty.send(b"\x1b:quit");
    pty.expect(":quit");
}

/// The old amplitude is never on the screen beside the new speed: a key and what it leads to are one frame.
#[test]
fn a_key_and_its_results_are_one_frame() {
    let mut pty = started(Launch::new(pty::program()).size(40, 120));
    pty.expect("19.456");
    pty.types("<end>");
    pty.idle(Duration::from_millis(200));
    let before = pty.raw().len();
    pty.types("<s-up>");
    pty.expect("1010 rpm");
    pty.idle(Duration::from_millis(200));
    let raw = pty.raw();
    let frames = String::from_utf8_lossy(&raw[before..]).matches("\x1b[?2026h").count();
    assert_eq!(frames, 1, "{:?}", String::from_utf8_lossy(&raw[before..]));
}

#[test]
fn two_hundred_keys_at_once_build_no_backlog() {
    let mut pty = started(Launch::new(pty::program()));
    pty.expect("19.456");
    pty.types("<end>");
    pty.idle(Duration::from_millis(150));
    let before = pty.count();
    pty.send(&[b'+'; 200]);
    pty.expect("1200 rpm");
    pty.idle(Duration::from_millis(150));
    let raw = pty.raw();
    let frames = raw[before..].windows(8).filter(|bytes| bytes == b"\x1b[?2026h").count();
    assert!(frames <= 12, "{frames} frames for 200 keys that were there at once");
    // A key after them is answered at once.
    pty.send(&[b'-'; 150]);
    pty.types("?");
    pty.expect("Keyboard shortcuts");
    pty.types("<esc>");
    pty.expect("1050 rpm");
    pty.types("q");
}

#[test]
fn what_is_typed_outlives_the_window_and_is_offered_again() {
    let home = tempfile::tempdir().expect("a folder");
    let mut pty = started(at_home(home.path()));
    pty.expect("19.456");
    pty.types("<end><del>1234 rpm<enter>");
    pty.idle(Duration::from_millis(200));
    pty.signal(-1, Signal::TERM);
    assert_eq!(pty.exit_code(), Some(143));

    let mut pty = started(at_home(home.path()));
    pty.expect("without saving");
    pty.types("<enter>");
    pty.expect("1234 rpm");
    // Discarded when the user asks for it, and not offered again.
    pty.types("q");
    pty.expect("quit without saving");
    pty.types("<down><enter>");
    assert_eq!(pty.exit_code(), Some(0));
    let mut pty = started(at_home(home.path()));
    pty.idle(Duration::from_millis(200));
    assert!(!pty.screen().contains("without saving"), "{}", pty.screen());
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
}

#[test]
fn a_problem_file_is_opened_changed_and_saved() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fan.toml");
    let text = "# the fan of the paint shop\nanalysis = \"vibration/rotating-unbalance\"\n\n[inputs]\nmass = \"40 kg\"\nunbalance = \"0.1 kg*m\"\nspeed = \"1000 rpm\" # its plate\nsupport.stiffness.stiffness = \"450 kN/m\"\ndamping.ratio.ratio = \"0.1\"\n";
    fs::write(&path, text).expect("written");
    let mut pty = started(
        Launch::new(pty::program()).in_script(&format!("\"$PROGRAM\" '{}'; exit $?", path.display())),
    );
    pty.expect("fan.toml");
    pty.types("<end><del>1200 rpm<enter>s");
    pty.expect("saved as");
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
    let saved = fs::read_to_string(&path).expect("the file is there");
    let latest = text.replace("-unbalance\"\n", "-unbalance\"\nformat = 2\n");
    assert_eq!(saved, latest.replace("1000 rpm", "1200 rpm"));
}

#[test]
fn the_worked_solution_is_exported_and_exported_anew() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = format!("cd '{}' && \"$PROGRAM\"; exit $?", folder.path().display());
    let mut pty = started(Launch::new(pty::program()).in_script(&script));
    pty.expect("19.456");
    pty.types("X");
    pty.expect("rotating-unbalance.html");
    pty.types("<enter>");
    pty.expect("worked solution written to");
    let path = folder.path().join("rotating-unbalance.html");
    let first = fs::read_to_string(&path).expect("the file is there");
    assert!(first.contains("<svg") && first.contains("19.456") && first.contains("</html>\n"));
    let confirmed = crate::program().arg("confirm").arg(&path).status().expect("the program runs");
    assert!(confirmed.success());
    // At another speed: the file is not lost without a word.
    pty.types("<end><del>1500 rpm<enter>");
    pty.expect("4.5535");
    pty.types("X<enter>");
    pty.expect("already exists");
    pty.types("<down><enter>");
    pty.expect("worked solution written to");
    let second = fs::read_to_string(&path).expect("the file is there");
    assert!(second.contains("4.5535") && !second.contains("19.456"));
    // As a document of Word, by the ending of its name.
    pty.types("X<c-u>fan.docx<enter>");
    pty.expect("written to fan.docx");
    let confirmed = crate::program().arg("confirm").arg(folder.path().join("fan.docx")).output();
    let confirmed = confirmed.expect("the program runs");
    assert!(confirmed.status.success(), "{}", String::from_utf8_lossy(&confirmed.stderr));
}

/// A solve of ten seconds ends at a key; what was found before stays, marked as old, and the next change solves.
#[test]
fn escape_stops_a_solve() {
    let mut pty = started(Launch::new(pty::program()).env("DALEMBERT_FAULTS", "1"));
    pty.expect("19.456");
    pty.types(":fault long<enter>");
    pty.expect("solving; Esc cancels");
    pty.types("<esc>");
    pty.expect("solve cancelled");
    pty.expect("cancelled");
    assert!(!pty.screen().contains("solving;"), "{}", pty.screen());
    pty.types("<end><del>1500 rpm<enter>");
    pty.expect("4.5535");
    assert!(!pty.screen().contains("cancelled"), "{}", pty.screen());
}

/// So does what a tab asks beside the results, which stay.
#[test]
fn escape_stops_what_a_tab_asks() {
    let mut pty = started(Launch::new(pty::program()).env("DALEMBERT_FAULTS", "1"));
    pty.expect("19.456");
    pty.types("[[");
    pty.expect("current value");
    pty.types(":fault long<enter>");
    pty.expect("solving; Esc cancels");
    pty.types("<esc>");
    pty.expect("Study cancelled");
    assert!(!pty.screen().contains("solving"), "{}", pty.screen());
    assert!(pty.screen().contains("20..60 kg"), "{}", pty.screen());
    // The thread is free again.
    pty.types("<right>");
    pty.expect("Target value");
    pty.expect("Mass of the machine = 40 kg");
}

#[test]
fn copies_go_to_the_clipboard_of_the_terminal() {
    let mut pty = started(Launch::new(pty::program()));
    pty.expect("19.456");
    pty.types("y");
    pty.expect("copied");
    assert!(String::from_utf8_lossy(&pty.raw()).contains("\x1b]52;c;"));
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
}

/// A fan is balanced where it stands: the first run, a trial weight, the correction, and the page for the file.
///
/// 10 µm at 90° become 10 µm at 0° by 5 g at 0°: the weight turns the vibration by (10 − 10i) µm, so that the
/// correction is −10i·5/(10 − 10i) g = 5/√2 g at −45°.
#[test]
fn a_fan_is_balanced_in_the_field_and_the_page_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let (job, page) = (folder.path().join("job.toml"), folder.path().join("page.md"));
    let mut pty = started(Launch::new(pty::program()).in_script(&format!(
        "\"$PROGRAM\" balancing/field && \"$PROGRAM\" solve '{}' --format markdown -o '{}'; exit $?",
        job.display(),
        page.display()
    )));
    pty.expect("Field balancing");
    pty.types("<down><down><down>10 um<enter><down>90 deg<enter>");
    // The trial weight, and what was read with it.
    pty.types("<down><down><down><down><down><down><down>5 g<enter><down>0 deg<enter>");
    pty.types("<down><down><down>10 um<enter><down>0 deg<enter>");
    pty.expect("3.5355 g");
    pty.expect("315      °");
    pty.types(&format!("s{}<enter>", job.display()));
    pty.expect("saved as");
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
    let page = fs::read_to_string(&page).expect("the page is there");
    for words in ["3.5355", "315", "heavy spot", "135"] {
        assert!(page.contains(words), "{words}:\n{page}");
    }
}
