//! Sessions that are recorded and played again, in the terminal and without one.

use std::{
    fs,
    path::Path,
    process::{Command, Output},
    time::Duration,
};

use dalembert_tests::pty::{self, Launch, PATIENCE, Signal};

/// Plays a session without a terminal.
fn played(session: &Path, more: &[&str]) -> Output {
    let mut command = Command::new(pty::program());
    command.args(["--lang", "en", "replay"]).arg(session).arg("--headless").args(more);
    command.output().expect("the program runs")
}

fn written(folder: &Path, text: &str) -> std::path::PathBuf {
    let path = folder.join("session.replay");
    fs::write(&path, text).expect("written");
    path
}

#[test]
fn a_session_without_a_terminal_prints_the_screens_it_marks() {
    let folder = tempfile::tempdir().expect("a folder");
    let session = written(
        folder.path(),
        "screen 100x24\nopen vibration/rotating-unbalance\npicture before\ntype <end><del>1500 rpm<enter>\n\
         expect 4.5535\npicture after\n",
    );
    let output = played(&session, &[]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    let (before, after) = text.split_once("== after\n").expect("two screens");
    assert!(before.starts_with("== before\n") && before.contains("19.456"), "{before}");
    assert!(after.contains("4.5535") && after.lines().count() == 24, "{after}");

    let pictures = folder.path().join("pictures");
    let output = played(&session, &["--pictures", pictures.to_str().expect("a readable path")]);
    assert!(output.status.success() && output.stdout.is_empty());
    let svg = fs::read_to_string(pictures.join("after.svg")).expect("a picture");
    assert!(svg.starts_with("<svg") && svg.contains("4.5535") && !svg.contains("19.456"), "{svg}");
}

#[test]
fn what_is_not_on_the_screen_fails_the_session() {
    let folder = tempfile::tempdir().expect("a folder");
    let session = written(folder.path(), "open vibration/rotating-unbalance\n\nexpect 42 mm\n");
    let output = played(&session, &[]);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{error}");
    assert!(error.contains("line 3: `42 mm` is not on the screen"), "{error}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("19.456"), "the screen is shown");
}

#[test]
fn what_cannot_be_played_is_bad_input() {
    let folder = tempfile::tempdir().expect("a folder");
    for (text, words) in [
        ("screen wide\n", "line 1: `wide` is not a size"),
        ("open vibration/no-such-thing\n", "neither the id of an analysis nor a file"),
        ("type <esc>q\ntype x\n", "line 2: the program has already ended"),
    ] {
        let output = played(&written(folder.path(), text), &[]);
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && error.contains(words), "{text}{error}");
    }
}

#[test]
fn a_session_opens_the_file_beside_it() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(
        folder.path().join("fan.toml"),
        "analysis = \"vibration/rotating-unbalance\"\ntitle = \"Paint shop\"\n\n[inputs]\nmass = \"40 kg\"\n",
    )
    .expect("written");
    let output = played(&written(folder.path(), "open fan.toml\nexpect Paint shop\n"), &[]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// A recorded session gives the same last screen when it is replayed.
#[test]
fn what_is_recorded_can_be_played() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("lesson.replay");
    let launch = Launch::new(pty::program()).size(30, 100);
    let mut pty = launch
        .argument("vibration/rotating-unbalance")
        .argument("--record")
        .argument(path.as_os_str())
        .start();
    pty.expect("19.456");
    pty.types("<end><del>1500 rpm<enter>");
    pty.expect("4.5535");
    std::thread::sleep(Duration::from_millis(800));
    pty.types("]]<home><right>");
    pty.idle(Duration::from_millis(200));
    let last = pty.screen();
    pty.types("q");
    pty.expect("without saving");
    pty.types("<down><enter>");
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]));

    let text = fs::read_to_string(&path).expect("the session is there");
    let begin = "screen 100x30\nlanguage en\nlook colour\nopen vibration/rotating-unbalance\n";
    assert!(text.starts_with(begin), "{text}");
    assert!(text.contains("type <end><del>1500 rpm<enter>\nwait "), "{text}");
    // How the program was ended is nobody's who looks on.
    assert!(text.ends_with("type ]]<home><right>\n"), "{text}");
    let again = written(folder.path(), &text);
    let screen = String::from_utf8_lossy(&played(&again, &[]).stdout).into_owned();
    let bare = |screen: &str| screen.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
    // A replay writes nothing, and its title line reports it.
    let without_title =
        |screen: &str| screen.split_once('\n').map(|(_, rest)| bare(rest)).unwrap_or_default();
    assert!(screen.contains("read-only"), "{screen}");
    assert_eq!(without_title(screen.trim_end()), without_title(last.trim_end()));

    // A file that is there is not written over, and that is said before the terminal is taken.
    for (name, words) in
        [(path.clone(), "already exists"), (folder.path().join("none/x.replay"), "folder not found")]
    {
        let launch = Launch::new(pty::program()).argument("--record").argument(name.as_os_str());
        let mut pty = launch.start();
        assert_eq!(pty.exit_code(), Some(2), "{}", pty.screen());
        let screen = pty.screen().split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(screen.contains(words) && screen.contains(".replay"), "{screen}");
    }
    assert_eq!(fs::read_to_string(&path).expect("the session is there"), text);
}

/// The window is closed in the middle of a word.
#[test]
fn a_closed_window_loses_no_key_of_a_recording() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("lesson.replay");
    let launch = Launch::new(pty::program()).argument("vibration/rotating-unbalance");
    let mut pty = launch.argument("--record").argument(path.as_os_str()).start();
    pty.expect("19.456");
    pty.types("<end><del>15");
    pty.expect("15");
    pty.idle(Duration::from_millis(100));
    pty.signal(-1, Signal::HUP);
    assert!(pty.exit_code().is_some());
    let text = fs::read_to_string(&path).expect("the session is there");
    assert!(text.ends_with("type <end><del>15\n"), "{text}");
}

/// A lecture: the session stands at its pauses under its captions, and keys steer it.
#[test]
fn a_replay_pauses_under_a_caption_and_is_steered_by_keys() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "open vibration/rotating-unbalance\ncaption At 1000 rpm the fan is close to resonance.\npause\n\
                caption Half as fast again.\ntype <end><del>1500 rpm<enter>\nwait 900000 ms\n";
    let session = written(folder.path(), text);
    let launch = Launch::new(pty::program()).argument("replay").argument(&session);
    let mut pty = launch.argument("--speed").argument("10").start();
    pty.expect("close to resonance");
    pty.expect("paused");
    // A paused session does nothing by itself.
    pty.idle(Duration::from_millis(300));
    assert!(pty.screen().contains("19.456"), "{}", pty.screen());
    pty.types("<pgdn>");
    pty.expect("4.5535");
    pty.expect("Half as fast again.");
    assert!(!pty.screen().contains("close to resonance"), "{}", pty.screen());
    pty.expect("replay 10×");
    pty.types("+");
    pty.expect("replay 15×");
    pty.types("-");
    pty.expect("replay 10×");
    pty.types(" ");
    pty.expect("paused");
    pty.types(" ");
    pty.expect("replay 10×");
    pty.types("x");
    pty.expect("replay stopped");
    assert!(!pty.screen().contains("Half as fast again."), "{}", pty.screen());
    // Without a terminal a caption is part of the pictures.
    let session =
        written(folder.path(), "open vibration/rotating-unbalance\ncaption The peak.\npause\npicture one\n");
    let output = String::from_utf8_lossy(&played(&session, &[]).stdout).into_owned();
    assert!(output.contains("The peak.") && !output.contains("Space"), "{output}");
}

/// The tour plays itself; a key is the user's and acts, nothing of the tour is asked about, and the session is writable.
#[test]
fn the_tour_hands_over_the_keys() {
    let launch = Launch::new(pty::program()).size(36, 120).argument("--lang").argument("pt-BR");
    let mut pty = launch.argument("tour").start();
    pty.expect("visita");
    pty.expect("Um ventilador vibra");
    pty.types("?");
    pty.expect("Atalhos");
    pty.idle(Duration::from_millis(200));
    assert!(!pty.screen().contains("visita ·"), "{}", pty.screen());

    let launch = Launch::new(pty::program()).size(36, 120).argument("tour").argument("--speed");
    let mut pty = launch.argument("40").start();
    pty.expect("end of the tour");
    assert!(!pty.screen().contains("read-only"), "{}", pty.screen());
    // It ends in the search of the list.
    pty.types("<esc>");
    pty.expect("/ search");
    pty.types("q");
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]), "nothing is asked");
}

/// A recorded session that saves and quits does neither when replayed, and asks about no unsaved work.
#[test]
fn a_session_that_is_played_writes_nothing_and_does_not_end_the_program() {
    let folder = tempfile::tempdir().expect("a folder");
    let problem =
        "analysis = \"vibration/rotating-unbalance\"\ntitle = \"Paint shop\"\n\n[inputs]\nmass = \"40 kg\"\n";
    let file = folder.path().join("fan.toml");
    fs::write(&file, problem).expect("written");
    // Work that an earlier session left.
    let kept = folder.path().join("state/dalembert/autosave");
    fs::create_dir_all(&kept).expect("made");
    let autosave = dalembert_tui::files::Autosave::in_folder(kept.clone()).expect("a folder of its own");
    autosave.note(1, None, problem.to_owned());
    autosave.flush().expect("written");
    let work = fs::read_dir(&kept).expect("there").flatten().next().expect("it is kept").path();
    let text = fs::read_to_string(&work).expect("readable");
    let (before, after) = text.split_once(" began=").expect("the header has it");
    fs::write(&work, format!("{before} began=1{after}")).expect("written");

    for keys in ["<home>41<enter>sq<enter>", "<home>41<enter>q<enter>", "<home>41<enter>q<down><enter>"] {
        let session = written(folder.path(), &format!("open fan.toml\ntype {keys}\n"));
        let launch = Launch::new(pty::program()).argument("replay").argument(&session);
        let mut pty = launch
            .argument("--speed")
            .argument("20")
            .env("XDG_STATE_HOME", folder.path().join("state").to_str().expect("a readable path"))
            .start();
        pty.expect("keyboard is active again");
        assert!(pty.screen().contains("read-only") && pty.screen().contains("41 kg"), "{}", pty.screen());
        pty.types("q");
        assert_eq!(pty.exit_code(), Some(0), "{keys}");
        assert_eq!(fs::read_to_string(&file).expect("there"), problem, "{keys}");
        assert!(work.exists(), "the next session is asked about it");
    }
}

#[test]
fn a_session_is_played_in_the_terminal_until_a_key_takes_over() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "language pt-BR\nopen vibration/rotating-unbalance\ntype <end><del>1500 rpm<enter>\n";
    let session = written(folder.path(), text);
    let play = |session: &Path| {
        let launch = Launch::new(pty::program()).argument("replay").argument(session);
        launch.argument("--speed").argument("10").start()
    };
    let mut pty = play(&session);
    pty.expect("4,5535");
    pty.expect("teclado está ativo");
    pty.types("L");
    pty.expect("4.5535");

    let session = written(folder.path(), &format!("{text}wait 900000 ms\ntype <del>7\n"));
    let mut pty = play(&session);
    pty.expect("4,5535");
    // The Enter that ends the field comes a moment later.
    pty.idle(Duration::from_millis(400));
    pty.types("L");
    pty.expect("reprodução interrompida");
    assert!(!pty.sees("Inputs", Duration::from_millis(300)), "the key that stops it does no more");
    pty.types("L");
    assert!(pty.sees("Inputs", PATIENCE), "{}", pty.screen());
}
