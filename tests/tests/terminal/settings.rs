//! Settings: keys, themes, mouse capture, the editor; and files that other programs change.

use std::{fs, os::unix::fs::PermissionsExt, path::Path, process::Command, time::Duration};

use dalembert_core::Locale;
use dalembert_tests::{
    person::Person,
    pty::{self, Launch, Pty},
};
use dalembert_tui::{
    keys::{Action, Key, KeyContext},
    look::Theme,
    panes::places,
    settings,
};
use ratatui::style::Color;

const FAN: &str = "vibration/rotating-unbalance";
/// An analysis with a table.
const MODES: &str = "vibration/modal-analysis";

fn fan(columns: u16, rows: u16) -> Person {
    Person::at(columns, rows).opens(FAN)
}

/// The fan before a user with these settings.
fn fan_with(text: &str) -> Person {
    let (settings, faults) = settings::parse(text);
    assert_eq!(faults, [], "{text}");
    let mut person = fan(90, 30);
    person.model.adopt(&settings);
    person
}

#[test]
fn the_footer_the_help_and_the_palette_show_the_keys_that_hold() {
    let mut person =
        fan_with("[keys]\nnext-tab = \"f6\"\nprevious-tab = \"f5\"\nundo = \"ctrl-x\"\nsave = []\n");
    // As wide as a footer that would name the key to save.
    let footer = person.resizes(160, 40).sees().lines().last().unwrap_or_default().to_owned();
    assert!(footer.contains("F5 F6 tabs") && footer.contains("Ctrl-X undo"), "{footer}");
    assert!(!footer.contains(" s save"), "{footer}");
    let before = person.sees();
    assert_eq!(person.types("]").sees(), before, "a key that was moved does nothing at its old place");
    person.types("<f6>");
    assert!(person.sees().contains("reason") || person.sees() != before);
    person.types("?<end><pgup>");
    let help = person.sees();
    assert!(help.contains("Ctrl-X") || person.types("<pgup>").sees().contains("Ctrl-X"), "{help}");
    person.types("<esc>:undo");
    assert!(person.sees().lines().any(|line| line.contains("undo") && line.contains("Ctrl-X")));
}

#[test]
fn sentences_name_the_keys_that_hold() {
    let keys =
        "[keys]\ntoggle = \"f5\"\nenter = \"f6\"\nunit-of-answer = \"w\"\nright = \"f7\"\nreveal = \"f8\"\n";
    let mut person = fan_with(keys);
    for (typed, said) in [
        ("<down><down>3", "F6 opens the options"),
        ("<tab>", "w unit of an answer, D digits"),
        ("<end>", "F6 shows them"),
        ("[", "↑ ↓ choose a case; F6 loads it"),
        ("[[", "← F7 another answer"),
        ("t", "F8 in Working reveals"),
        ("[[[[", "hidden; F8 in this tab"),
        ("<esc><esc><esc><f5>", "F5 ticks an exercise"),
    ] {
        let screen = person.types(typed).sees();
        assert!(screen.contains(said), "{typed}: {said}\n{screen}");
    }
    let mut person = fan_with(keys).opens(MODES);
    let screen = person.turns_to("Table").types("<f6>").sees();
    assert!(screen.contains("F6 loads a case in Sources"), "{screen}");
    let mut person = Person::in_portuguese(100, 30).opens(FAN);
    person.types("t]");
    assert!(person.sees().contains("Espaço nesta aba revela"), "{}", person.sees());
    assert!(person.sees().lines().last().unwrap_or_default().contains("Espaço "), "{}", person.sees());
}

#[test]
fn what_is_set_holds_from_the_first_frame() {
    let mut person = fan_with("decimal = \"comma\"\ndigits = 3\nfilm-speed = 0\n");
    assert!(person.sees().contains("19,5 "), "{}", person.sees());
    assert!(!person.model.playing);
    // The mark outlives a change of the language.
    person.types("LL");
    assert!(person.sees().contains("19,5 "), "{}", person.sees());
}

#[test]
fn every_action_has_a_key_or_a_name_and_stands_in_the_file_of_settings() {
    let file = settings::default_file(&Locale::english());
    for place in places() {
        for binding in place.bindings() {
            assert!(!binding.name.is_empty(), "{binding:?}");
            assert!(file.contains(&format!("# {} = ", binding.action.id())), "{binding:?}");
            // What has no key can be reached in the palette alone.
            assert!(!binding.keys.is_empty() || !place.is_text(), "{binding:?}");
        }
    }
    // Every action that has a name in the settings stands in a table.
    let names =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/tui/src/keys/names.rs"))
            .expect("the source is there");
    let ids: Vec<&str> = names
        .lines()
        .filter(|line| line.trim_start().starts_with("Action::"))
        .filter_map(|line| line.split('"').nth(1))
        .collect();
    assert!(ids.len() > 50, "{ids:?}");
    for id in ids {
        let stands =
            places().into_iter().flat_map(KeyContext::bindings).any(|binding| binding.action.id() == id);
        assert!(stands, "{id} stands in no table");
    }
}

#[test]
fn a_theme_is_chosen_by_name_and_colours_every_cell() {
    let mut person = fan(80, 24);
    person.types(":theme<enter>");
    assert!(person.sees().contains("high contrast"), "{}", person.sees());
    person.types("<down><enter>");
    assert_eq!(person.model.look.theme, Theme::Dark);
    let buffer = person.draws();
    assert!(buffer.content.iter().all(|cell| cell.fg != Color::Reset && cell.bg == Color::Black));
    person.types(":theme<enter><end><enter>");
    let buffer = person.draws();
    assert!(buffer.content.iter().all(|cell| cell.fg == Color::Reset && cell.bg == Color::Reset));
    let mut person = Person::in_ascii(80, 24).opens(FAN);
    assert!(person.types(":theme<enter>").sees().contains("shows no colours"));
}

#[test]
fn what_is_edited_outside_is_here_and_can_be_taken_back() {
    let mut person = fan(90, 30);
    person.editor = |text| text.replace("1000 rpm", "1500 rpm");
    assert!(person.types("E").sees().contains("4.5535"), "{}", person.sees());
    assert!(person.sees().contains("not saved yet"));
    assert!(person.types("z").sees().contains("19.456"));
    person.editor = |text| text.replace("[inputs]", "[inputs");
    let broken = person.types("E").sees();
    assert!(broken.contains("cannot be read") && broken.contains("line 5"), "{broken}");
    assert!(person.types("<down><enter>").sees().contains("19.456"), "nothing is lost");
    person.editor = str::to_owned;
    assert!(person.types("E").sees().contains("no changes"));
}

fn started(launch: Launch) -> Pty {
    let pty = launch.start();
    pty.expect("dalembert");
    pty
}

/// A home whose settings say this.
fn home_with(settings: &str) -> tempfile::TempDir {
    let home = tempfile::tempdir().expect("a folder");
    fs::create_dir(home.path().join("dalembert")).expect("a folder");
    fs::write(home.path().join("dalembert/settings.toml"), settings).expect("written");
    home
}

fn configured(home: &tempfile::TempDir) -> Launch {
    Launch::new(pty::program()).env("XDG_CONFIG_HOME", home.path().to_str().expect("a readable path"))
}

fn fan_file(folder: &Path) -> std::path::PathBuf {
    let path = folder.join("fan.toml");
    let text = "# the fan of the paint shop\nanalysis = \"vibration/rotating-unbalance\"\n\n[inputs]\nmass = \"40 kg\"\nunbalance = \"0.1 kg*m\"\nspeed = \"1000 rpm\" # its plate\nsupport.stiffness.stiffness = \"450 kN/m\"\ndamping.ratio.ratio = \"0.1\"\n";
    fs::write(&path, text).expect("written");
    path
}

fn opening(path: &Path, arguments: &str, launch: Launch) -> Pty {
    let script = format!("\"$PROGRAM\" {arguments} '{}'; exit $?", path.display());
    let pty = launch.in_script(&script).start();
    pty.expect("fan.toml");
    pty
}

#[test]
fn broken_settings_are_named_by_line_and_the_rest_holds() {
    let home = home_with("theme = \"drak\"\n[keys]\nnext-tab = \"f6\"\nquit = \"Q\"\nsave = \"esc\"\n");
    let mut pty = started(configured(&home));
    pty.expect("line 1: `theme` cannot be `drak`; did you mean `dark`?");
    pty.expect("line 5: `esc` is reserved for `back`");
    pty.types("<esc>");
    pty.expect("[ F6 tabs");
    pty.types("Q");
    assert_eq!(pty.exit_code(), Some(0));
}

#[test]
fn the_mouse_is_taken_and_left_by_the_terminal_s_own_sequences() {
    let mut pty = started(Launch::new(pty::program()));
    pty.expect("19.456");
    assert!(String::from_utf8_lossy(&pty.raw()).contains("\x1b[?1000h\x1b[?1002h\x1b[?1003h\x1b[?1006h"));
    let screen = pty.screen();
    let (row, line) = screen.lines().enumerate().find(|(_, line)| line.contains("Working")).expect("the tab");
    let column = line[..line.find("Working").unwrap_or(0)].chars().count() + 1;
    pty.send(format!("\x1b[<0;{column};{}M\x1b[<0;{column};{}m", row + 1, row + 1).as_bytes());
    pty.expect("symbols");
    pty.types(":mouse<enter>");
    pty.expect("mouse left to the terminal");
    assert!(String::from_utf8_lossy(&pty.raw()).contains("\x1b[?1000l"));
    pty.types("q");
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]));
}

#[test]
fn over_ssh_and_where_it_is_not_wanted_the_mouse_is_the_terminal_s() {
    let over_ssh = Launch::new(pty::program()).env("SSH_CONNECTION", "192.0.2.1 50000 192.0.2.2 22");
    let home = home_with("mouse = false\n");
    let unwanted = Launch::new(pty::program()).in_script("\"$PROGRAM\" --no-mouse; exit $?");
    for launch in [over_ssh, configured(&home), unwanted] {
        let mut pty = started(launch);
        pty.expect("19.456");
        assert!(!String::from_utf8_lossy(&pty.raw()).contains("\x1b[?1000h"));
        pty.types("q");
        assert_eq!(pty.exit_code(), Some(0));
    }
}

#[test]
fn basic_has_no_colours_no_frames_and_the_cursor_at_the_focus() {
    let mut pty = started(Launch::new(pty::program()).in_script("\"$PROGRAM\" --basic; exit $?"));
    pty.expect("1000 rpm");
    pty.idle(Duration::from_millis(200));
    let raw = pty.raw();
    assert!(raw.is_ascii());
    let text = String::from_utf8_lossy(&raw);
    assert!(!text.contains("?2026h") && !text.contains("?1000h"), "{text:?}");
    assert!((30..38).all(|color| !text.contains(&format!("\x1b[{color}m"))), "{text:?}");
    // The cursor is shown where the value of the first field begins.
    assert!(text.ends_with("\x1b[?25h\x1b[3;60H") || text.contains("\x1b[?25h\x1b[3;"), "{text:?}");
    let screen = pty.screen();
    assert!(!screen.contains("+--") && !screen.contains('|'), "{screen}");
    pty.types("q");
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]));
}

/// An editor that changes the speed, or spoils the file once.
fn editor(folder: &Path, script: &str) -> String {
    let path = folder.join("editor.sh");
    fs::write(&path, format!("#!/bin/sh\n{script}\n")).expect("written");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("executable");
    path.to_str().expect("a readable path").to_owned()
}

#[test]
fn the_problem_is_edited_in_the_user_s_editor() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = fan_file(folder.path());
    let command = editor(folder.path(), "echo the editor is here; sed -i 's/1000 rpm/1500 rpm/' \"$1\"");
    let mut pty = opening(&path, "", Launch::new(pty::program()).env("EDITOR", &command));
    pty.types("E");
    pty.expect("1500 rpm");
    pty.expect("reloaded");
    assert!(String::from_utf8_lossy(&pty.raw()).contains("the editor is here"));
    assert!(
        fs::read_to_string(&path).is_ok_and(|text| text.contains("1500 rpm") && text.contains("# its plate"))
    );
    pty.types("q");
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]));
}

#[test]
fn what_the_editor_spoils_is_named_and_edited_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let spoil = "if grep -q inputz \"$1\"; then sed -i s/inputz/inputs/ \"$1\"; else sed -i s/inputs/inputz/ \"$1\"; fi";
    let command = editor(folder.path(), spoil);
    let home = home_with(&format!("editor = \"{command}\"\n"));
    let mut pty = started(configured(&home).env("EDITOR", "false"));
    pty.expect("19.456");
    pty.types("E");
    pty.expect("cannot be read");
    pty.expect("inputz");
    pty.types("<enter>");
    pty.expect("no changes");
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
}

#[test]
fn an_editor_that_fails_is_named() {
    let mut pty = started(Launch::new(pty::program()).env("VISUAL", "false"));
    pty.expect("19.456");
    pty.types("E");
    pty.expect("`false` failed");
    pty.types("<c-c>");
    assert_eq!(pty.exit_code(), Some(0));
}

#[test]
fn an_editor_that_is_not_there_is_named() {
    let mut pty = started(Launch::new(pty::program()).env("VISUAL", "no-such-editor"));
    pty.expect("19.456");
    pty.types("E");
    pty.expect("`no-such-editor` was not found");
    pty.types("<c-c>");
    assert_eq!(pty.exit_code(), Some(0));
}

#[test]
fn what_the_editor_did_was_no_other_program() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = fan_file(folder.path());
    let command = editor(folder.path(), "sed -i s/inputs/inputz/ \"$1\"");
    let mut pty = opening(&path, "", Launch::new(pty::program()).env("EDITOR", &command));
    pty.types("E");
    pty.expect("cannot be read");
    let examined = Duration::from_secs(3);
    assert!(!pty.sees("by another program", examined), "{}", pty.screen());
    pty.types("<down><enter>");
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
}

#[test]
fn an_interrupt_in_the_editor_is_the_editor_s() {
    let folder = tempfile::tempdir().expect("a folder");
    // `exec`: an interrupt that meets a shell as it forks is lost to the child, and the shell waits for that.
    let command = editor(folder.path(), "echo waiting; exec sleep 20");
    let mut pty = started(Launch::new(pty::program()).env("EDITOR", &command));
    pty.expect("19.456");
    pty.types("E");
    pty.expect("waiting");
    pty.types("<c-c>");
    pty.expect("` failed: set");
    pty.types("q");
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]));
}

#[test]
fn a_file_that_another_program_changes_is_read_again_or_asked_about() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = fan_file(folder.path());
    let mut pty = opening(&path, "", Launch::new(pty::program()));
    let change = |from: &str, to: &str| {
        let text = fs::read_to_string(&path).expect("the file is there");
        fs::write(&path, text.replace(from, to)).expect("written");
    };
    change("1000 rpm", "1200 rpm");
    pty.expect("reloaded");
    pty.expect("1200 rpm");
    pty.types("<end><del>900 rpm<enter>");
    change("40 kg", "50 kg");
    pty.expect("keep this version");
    pty.types("<down><enter>");
    pty.expect("50 kg");
    pty.expect("1200 rpm");
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
}

#[test]
fn a_watched_file_costs_no_bytes_and_no_time() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = fan_file(folder.path());
    let mut pty = opening(&path, "", Launch::new(pty::program()));
    pty.idle(Duration::from_millis(1500));
    let busy = |pty: &Pty| pty.processes().into_iter().filter_map(pty::alive).sum::<f64>();
    let (bytes, seconds) = (pty.count(), busy(&pty));
    std::thread::sleep(Duration::from_millis(3200));
    assert_eq!(pty.count(), bytes);
    // Processor time is counted in ticks of 0.01 s, whose sums are not exact: 0.02 s are two of them.
    let ticks = (100.0 * (busy(&pty) - seconds)).round();
    assert!(ticks <= 2.0, "{ticks} ticks");
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
}

#[test]
fn read_only_writes_nothing_at_all() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = fan_file(folder.path());
    let before = fs::read(&path).expect("the file is there");
    let state = folder.path().join("state");
    let launch = Launch::new(pty::program()).env("XDG_STATE_HOME", state.to_str().expect("a readable path"));
    let mut pty = opening(&path, "--readonly", launch);
    pty.types("<end><del>900 rpm<enter>");
    pty.expect("900 rpm");
    for keys in ["s", "S", "X", "E"] {
        pty.types(keys);
        pty.expect("not saved: the program is read-only");
        pty.types("<tab><tab>");
        pty.expect("? help");
    }
    // Long enough for what is kept against a crash.
    std::thread::sleep(Duration::from_millis(1500));
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
    assert_eq!(fs::read(&path).ok(), Some(before));
    let left: Vec<_> =
        fs::read_dir(folder.path()).expect("the folder").flatten().map(|entry| entry.file_name()).collect();
    assert_eq!(left, ["fan.toml"]);
    assert!(
        fs::read_dir(pty.home()).is_ok_and(|mut home| home.next().is_none()),
        "something in the home folder"
    );
}

#[test]
fn an_action_without_a_key_is_reached_by_its_name() {
    let mut person = fan(90, 30);
    person.types(":mouse<enter>");
    assert!(person.model.mouse && person.sees().contains("with Shift"), "{}", person.sees());
    let unkeyed = |action| {
        KeyContext::Form.bindings().any(|binding| binding.action == action && binding.keys.is_empty())
    };
    assert!(unkeyed(Action::Mouse) && unkeyed(Action::Theme));
}

#[test]
fn the_settings_in_the_guide_are_taken() {
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide.md");
    let guide = fs::read_to_string(guide).expect("the file is there");
    let part = guide.split("## Settings").nth(1).expect("the part on settings");
    let block = part.split("```toml").nth(1).and_then(|rest| rest.split("```").next()).expect("an example");
    let (settings, faults) = settings::parse(block);
    assert_eq!(faults, [], "{block}");
    assert_eq!(settings.keys.key(KeyContext::Form, Action::Save), Key::parse("f5").ok());
}

#[test]
fn info_names_every_path_and_what_is_not_taken() {
    let home = home_with("thme = \"dark\"\n");
    let run = |command: &str| {
        let output = Command::new(pty::program())
            .arg(command)
            .env("XDG_CONFIG_HOME", home.path())
            .env("XDG_STATE_HOME", home.path().join("state"))
            .env("LANG", "C.UTF-8")
            .env_remove("LC_ALL")
            .env_remove("LC_MESSAGES")
            .output()
            .expect("the program runs");
        String::from_utf8(output.stdout).expect("what is printed is UTF-8")
    };
    let info = run("info").split_whitespace().collect::<Vec<_>>().join(" ");
    let home = home.path().display();
    assert!(info.contains(&format!("{home}/dalembert/settings.toml (found)")), "{info}");
    assert!(info.contains(&format!("{home}/state/dalembert/autosave (not found)")), "{info}");
    assert!(info.contains("line 1: unknown setting `thme`; did you mean `theme`?"), "{info}");
    let file = run("settings");
    assert_eq!(settings::parse(&file), (settings::Settings::default(), Vec::new()), "{file}");
}

#[test]
fn a_key_that_does_nothing_here_says_why() {
    let mut person = fan(90, 30);
    for (keys, said) in [
        ("<home><space>", "Space has no effect on this field"),
        ("a", "not in a list"),
        ("p", "no animation on the screen"),
    ] {
        assert!(person.types(keys).sees().contains(said), "{keys}: {}", person.sees());
    }
    let mut person = Person::at(90, 30).opens(MODES);
    let screen = person.turns_to("Table").types("<enter>").sees();
    assert!(screen.contains("nothing to open here"), "{screen}");
}

#[test]
fn the_keys_in_the_guide_are_keys_of_the_tables() {
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide.md");
    let guide = fs::read_to_string(guide).expect("the file is there");
    let names: Vec<String> = places()
        .into_iter()
        .flat_map(KeyContext::bindings)
        .flat_map(|binding| binding.keys)
        .map(|key| key.name(&Locale::english()))
        .collect();
    let table = guide.split("| key | what it does |").nth(1).expect("the table of keys");
    let rows = table.lines().skip(2).take_while(|line| line.starts_with('|'));
    let keys: Vec<&str> = rows
        .filter_map(|row| row.split('|').nth(1))
        .flat_map(|keys| keys.split('`').skip(1).step_by(2))
        .collect();
    assert!(keys.len() > 25, "{keys:?}");
    for key in keys {
        assert!(names.iter().any(|name| name == key), "`{key}` is no key");
    }
}
