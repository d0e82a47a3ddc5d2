use std::{
    fs::{self, File, Permissions},
    io::{BufRead, BufReader, Read},
    os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink},
    path::{Path, PathBuf},
    process::{Command, Stdio},
    thread,
    time::Duration,
};

use super::{
    save::{
        Step::{Create, Permit, Rename, Sync, SyncFolder, Write},
        remove_leftovers_older, save_with,
    },
    system::began,
    *,
};

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn what_is_saved_is_read_back() {
    let folder = folder();
    let path = folder.path().join("fan.toml");
    let saved = save(&path, "mass = \"20.3 mm\"\n", Before::Absent).unwrap();
    assert_eq!(
        read(&path).unwrap(),
        Opened { text: "mass = \"20.3 mm\"\n".into(), fingerprint: saved, linked: LinkedTexts::default() }
    );
    assert_eq!(names(folder.path()), ["fan.toml"]);
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_text() {
    let folder = folder();
    let path = folder.path().join("bom.toml");
    fs::write(&path, "\u{FEFF}a = 1\r\n").unwrap();
    assert_eq!(read(&path).unwrap().text, "a = 1\r\n");
    assert_eq!(read(&path).unwrap().fingerprint, Fingerprint::of("\u{FEFF}a = 1\r\n".as_bytes()));
}

#[test]
fn what_is_no_problem_file_is_refused_by_name() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    rustix::fs::mknodat(
        rustix::fs::CWD,
        at("pipe"),
        rustix::fs::FileType::Fifo,
        rustix::fs::Mode::from_raw_mode(0o600),
        0,
    )
    .unwrap();
    assert!(fs::metadata(at("pipe")).unwrap().file_type().is_fifo());
    let sparse = File::create(at("large")).unwrap();
    sparse.set_len(10 * 1024 * LARGEST).unwrap();
    fs::write(at("latin1"), b"a = 1\nmassa = \"a\xE7\xE3o\"\n").unwrap();
    fs::write(at("utf16"), b"\xFF\xFEa\0").unwrap();
    fs::write(at("half"), b"caf\xC3").unwrap();
    for (path, message) in [
        (at("none"), "not found: check its name"),
        (at(""), "is a folder"),
        (at("pipe"), "is a pipe"),
        ("/dev/zero".into(), "is a device"),
        (at("large"), "larger than 256 MiB"),
        (at("latin1"), "byte 16 in line 2; save it as UTF-8"),
        (at("utf16"), "looks like UTF-16"),
        (at("half"), "byte 3 in line 1"),
        (at("es\x1b[31mc\u{202E}"), "es\u{FFFD}[31mc`"),
    ] {
        let error = read(&path).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
}

#[test]
fn a_file_at_the_limit_is_read() {
    let folder = folder();
    let path = folder.path().join("edge");
    // A file without blocks, which takes no room on the disk and reads as zeros.
    let file = File::create(&path).unwrap();
    file.set_len(LARGEST).unwrap();
    assert_eq!(read(&path).unwrap().text.len() as u64, LARGEST);
    file.set_len(LARGEST + 1).unwrap();
    assert!(matches!(read(&path), Err(FileError::TooLarge(_))));
}

#[test]
fn two_instances_lose_nothing_in_silence() {
    let folder = folder();
    let path = folder.path().join("shared.toml");
    save(&path, "first", Before::Absent).unwrap();
    let (one, two) = (read(&path).unwrap(), read(&path).unwrap());
    save(&path, "one's", Before::Was(one.fingerprint)).unwrap();
    assert!(matches!(save(&path, "two's", Before::Was(two.fingerprint)), Err(FileError::Changed(_))));
    assert_eq!(read(&path).unwrap().text, "one's");
    fs::remove_file(&path).unwrap();
    assert!(matches!(save(&path, "two's", Before::Was(two.fingerprint)), Err(FileError::Removed(_))));
    fs::write(&path, "somebody's").unwrap();
    assert!(matches!(save(&path, "two's", Before::Absent), Err(FileError::Exists(_))));
    // Written again with the same text, as a synchronised folder does: no change.
    fs::write(&path, "first").unwrap();
    save(&path, "two's", Before::Was(two.fingerprint)).unwrap();
    save(&path, "over", Before::Whatever).unwrap();
    assert_eq!(read(&path).unwrap().text, "over");
}

#[test]
fn of_many_that_save_at_once_exactly_one_wins() {
    let folder = folder();
    let path = folder.path().join("raced.toml");
    for round in 0..20 {
        let opened = save(&path, "start", Before::Whatever).unwrap();
        let threads: Vec<_> = (0..4)
            .map(|writer| {
                let path = path.clone();
                thread::spawn(move || save(&path, format!("writer {writer}"), Before::Was(opened)).is_ok())
            })
            .collect();
        let won: Vec<bool> = threads.into_iter().map(|thread| thread.join().unwrap()).collect();
        assert_eq!(won.iter().filter(|won| **won).count(), 1, "round {round}");
        let winner = won.iter().position(|won| *won).unwrap();
        assert_eq!(read(&path).unwrap().text, format!("writer {winner}"));
    }
}

#[test]
fn links_and_permissions_are_kept() {
    let folder = folder();
    let (target, link) = (folder.path().join("target.toml"), folder.path().join("link.toml"));
    fs::write(&target, "old").unwrap();
    fs::set_permissions(&target, Permissions::from_mode(0o640)).unwrap();
    symlink("target.toml", &link).unwrap();
    save(&link, "new", Before::Was(read(&link).unwrap().fingerprint)).unwrap();
    assert_eq!(fs::read_link(&link).unwrap(), Path::new("target.toml"));
    assert_eq!(fs::read_to_string(&target).unwrap(), "new");
    assert_eq!(fs::metadata(&target).unwrap().permissions().mode() & 0o7777, 0o640);

    let dangling = folder.path().join("dangling.toml");
    symlink("made.toml", &dangling).unwrap();
    save(&dangling, "made", Before::Absent).unwrap();
    assert_eq!(fs::read_to_string(folder.path().join("made.toml")).unwrap(), "made");
    assert_eq!(names(folder.path()), ["dangling.toml", "link.toml", "made.toml", "target.toml"]);
}

#[test]
fn a_new_file_has_the_permissions_of_any_new_file() {
    let folder = folder();
    let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
    save(&ours, "", Before::Absent).unwrap();
    fs::write(&plain, "").unwrap();
    let mode = |path: &Path| fs::metadata(path).unwrap().mode();
    assert_eq!(mode(&ours), mode(&plain));
}

/// Every error at every step, over a file of three parts: the old file stays, whole, until the rename; the new one is
/// whole after it; no temporary file is left; the message has the system's word and says what to do.
#[test]
fn a_step_that_fails_leaves_the_file_whole() {
    let errors = [
        (rustix::io::Errno::NOSPC, "free some space"),
        (rustix::io::Errno::DQUOT, "free some space"),
        (rustix::io::Errno::FBIG, "free some space"),
        (rustix::io::Errno::ACCESS, "save to another folder"),
        (rustix::io::Errno::ROFS, "save to another folder"),
        (rustix::io::Errno::IO, "os error 5"),
        (rustix::io::Errno::INTR, "os error 4"),
    ];
    let new = "n".repeat(150_000);
    let folder = folder();
    let path = folder.path().join("precious.toml");
    let mut steps = Vec::new();
    save(&path, "old", Before::Absent).unwrap();
    save_with(&path, &new, Before::Whatever, &mut |step| {
        steps.push(step);
        Ok(())
    })
    .unwrap();
    assert_eq!(steps, [Create, Write, Write, Write, Permit, Sync, Rename, SyncFolder]);
    for (errno, advice) in errors {
        for (failing, step) in steps.iter().enumerate() {
            save(&path, "old", Before::Whatever).unwrap();
            let mut count = 0;
            let error = save_with(&path, &new, Before::Whatever, &mut |_| {
                count += 1;
                if count - 1 == failing { Err(errno.into()) } else { Ok(()) }
            })
            .unwrap_err()
            .to_string();
            assert!(error.contains(advice) && error.contains("precious.toml"), "{error}");
            let expected = if *step == SyncFolder { &new } else { "old" };
            assert!(fs::read_to_string(&path).unwrap() == expected, "{errno:?} at {step:?}");
            assert_eq!(names(folder.path()), ["precious.toml"]);
        }
    }
}

#[test]
fn strays_of_the_dead_are_removed_and_nothing_else() {
    let folder = folder();
    let dead = dead_process();
    let living = std::process::id();
    for name in [
        format!(".dalembert-{dead}-abc.tmp"),
        format!(".dalembert-{living}-abc.tmp"),
        ".dalembert-abc.tmp".to_owned(),
        "mine.tmp".to_owned(),
    ] {
        fs::write(folder.path().join(name), "").unwrap();
    }
    symlink("mine.tmp", folder.path().join(format!(".dalembert-{dead}-link.tmp"))).unwrap();
    assert_eq!(remove_leftovers(folder.path()), 0, "too young");
    assert_eq!(remove_leftovers_older(folder.path(), Duration::ZERO), 1);
    assert!(!folder.path().join(format!(".dalembert-{dead}-abc.tmp")).exists());
    assert_eq!(names(folder.path()).len(), 4);
}

#[test]
fn strays_beside_a_file_go_when_it_is_opened_or_saved() {
    let folder = folder();
    let path = folder.path().join("fan.toml");
    save(&path, "mass", Before::Absent).unwrap();
    let dead = dead_process();
    let stray = folder.path().join(format!(".dalembert-{dead}-abc.tmp"));
    let old = std::time::SystemTime::now() - Duration::from_mins(2);
    let uses: [&dyn Fn(&Path); 2] =
        [&|path| drop(read(path)), &|path| drop(save(path, "m", Before::Whatever))];
    for use_it in uses {
        fs::write(&stray, "mass").unwrap();
        use_it(&path);
        assert!(stray.exists(), "a save may be under way");
        File::options().write(true).open(&stray).unwrap().set_modified(old).unwrap();
        use_it(&path);
        assert_eq!(names(folder.path()), ["fan.toml"]);
    }
}

#[test]
fn a_private_file_is_private_while_it_is_written() {
    let folder = folder();
    let path = folder.path().join("fan.toml");
    fs::write(&path, "old").unwrap();
    for mode in [0o600, 0o664] {
        fs::set_permissions(&path, Permissions::from_mode(mode)).unwrap();
        let mut seen = Vec::new();
        let mut step = |step| {
            if step != Create {
                let modes = fs::read_dir(folder.path()).unwrap().map(|entry| {
                    let entry = entry.unwrap();
                    let is_temporary = entry.path() != path;
                    is_temporary.then(|| entry.metadata().unwrap().permissions().mode() & 0o777)
                });
                seen.extend(modes.flatten().map(|mode| (step, mode)));
            }
            Ok(())
        };
        save_with(&path, "new", Before::Whatever, &mut step).unwrap();
        assert_eq!(seen, [(Write, 0o600), (Permit, 0o600), (Sync, mode), (Rename, mode)]);
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, mode);
    }
}

/// The number of a process that has ended.
fn dead_process() -> u32 {
    let mut child = Command::new("true").spawn().unwrap();
    child.wait().unwrap();
    child.id()
}

/// The two texts of the kill test: of equal length, so that a mixture would not show by its size.
fn version(round: usize) -> String {
    let letter = if round.is_multiple_of(2) { "a" } else { "b" };
    letter.repeat(400_000)
}

/// Not a test by itself: the process that [`a_kill_at_any_moment_leaves_a_whole_file`] kills.
#[test]
fn saver() {
    let Some(path) = std::env::var_os("DALEMBERT_TEST_SAVER").map(PathBuf::from) else { return };
    for round in 0.. {
        save(&path, version(round), Before::Whatever).unwrap();
        if round == 0 {
            println!("\nsaving");
        }
    }
}

#[test]
fn a_kill_at_any_moment_leaves_a_whole_file() {
    const KILLS: u64 = 200;
    let folder = folder();
    let path = folder.path().join("precious.toml");
    save(&path, version(0), Before::Absent).unwrap();
    let (mut first, mut second, mut strays) = (0, 0, 0);
    for kill in 0..KILLS {
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "files::tests::saver", "--nocapture"])
            .env("DALEMBERT_TEST_SAVER", &path)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let output = BufReader::new(child.stdout.take().unwrap());
        assert!(output.lines().map_while(Result::ok).any(|line| line == "saving"), "it never began");
        // Spread over a few saves, in steps that share no factor with their length.
        thread::sleep(Duration::from_micros(kill * 7919 % 20_000));
        child.kill().unwrap();
        child.wait().unwrap();
        let text = fs::read_to_string(&path).unwrap();
        match text {
            text if text == version(0) => first += 1,
            text if text == version(1) => second += 1,
            text => panic!("torn at kill {kill}: {} bytes, beginning {:?}", text.len(), text.get(..8)),
        }
        strays += remove_leftovers_older(folder.path(), Duration::ZERO);
        assert_eq!(names(folder.path()), ["precious.toml"], "kill {kill}");
    }
    // Otherwise the kills did not fall into saves, and nothing was tested.
    assert!(first > 0 && second > 0 && strays > 0, "{first} first, {second} second, {strays} strays");
}

#[test]
fn unsaved_work_of_a_crashed_session_is_found() {
    let folder = folder();
    let state = folder.path().join("state").join("autosave");
    let autosave = Autosave::in_folder(state.clone()).unwrap();
    assert_eq!(fs::metadata(&state).unwrap().mode() & 0o777, 0o700);
    let original = folder.path().join("ventilação 100% \n.toml");
    autosave.note(1, Some(&original), "mass = 1\nlength = 2\n".into());
    autosave.flush().unwrap();
    assert_eq!(autosave.crashed(), [], "this session runs");

    // As if another process had written it, and died.
    let file = state.join(&names(&state)[0]);
    let (ours, dead) = (format!("pid={} ", std::process::id()), format!("pid={} ", dead_process()));
    fs::write(&file, fs::read_to_string(&file).unwrap().replace(&ours, &dead)).unwrap();
    let next = Autosave::in_folder(state.clone()).unwrap();
    let [found] = &next.crashed()[..] else { panic!("{:?}", next.crashed()) };
    assert_eq!(found.original.as_deref(), Some(&*original));
    assert_eq!(found.text, "mass = 1\nlength = 2\n");
    found.clone().discard().unwrap();
    assert_eq!(names(&state), [""; 0]);
}

#[test]
fn a_session_has_ended_even_if_its_number_is_taken() {
    let folder = folder();
    let state = folder.path().join("autosave");
    let autosave = Autosave::in_folder(state.clone()).unwrap();
    autosave.note(1, None, "work".into());
    autosave.flush().unwrap();
    let file = state.join(&names(&state)[0]);
    let text = fs::read_to_string(&file).unwrap();
    assert_eq!(autosave.crashed(), [], "this session runs");

    // Ended, and nobody asked how.
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "no test has this name"])
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let (ours, theirs) = (format!("pid={} ", std::process::id()), format!("pid={} ", child.id()));
    let began = |process: u32| format!(" began={}", began(&process.to_string()).unwrap());
    let of_child = text.replace(&ours, &theirs).replace(&began(std::process::id()), &began(child.id()));
    assert_ne!(of_child, text);
    fs::write(&file, of_child).unwrap();
    let mut output = child.stdout.take().unwrap();
    Read::read_to_end(&mut output, &mut Vec::new()).unwrap();
    let found = (0..500).any(|_| {
        thread::sleep(Duration::from_millis(10));
        autosave.crashed().len() == 1
    });
    assert!(found, "the session of a process that has ended is offered");
    child.wait().unwrap();

    // The number is this process's now, which began at another time.
    fs::write(&file, text.replace(&began(std::process::id()), " began=1")).unwrap();
    assert_eq!(autosave.crashed().len(), 1);
}

#[test]
fn an_autosave_follows_the_work_and_ends_with_it() {
    let folder = folder();
    let state = folder.path().join("autosave");
    let autosave = Autosave::in_folder(state.clone()).unwrap();
    autosave.flush().unwrap();
    assert_eq!(names(&state), [""; 0], "nothing noted, nothing written");
    for text in ["one", "two"] {
        autosave.note(1, None, text.into());
        autosave.flush().unwrap();
        let files = names(&state);
        assert_eq!(files.len(), 1);
        assert!(fs::read_to_string(state.join(&files[0])).unwrap().ends_with(&format!("\n{text}")));
    }
    autosave.forget(1);
    assert_eq!(names(&state), [""; 0]);
}

#[test]
fn planted_links_are_not_followed() {
    let folder = folder();
    let state = folder.path().join("autosave");
    let victim = folder.path().join("victim");
    fs::write(&victim, format!("# dalembert autosave pid={} host=\nstolen", dead_process())).unwrap();
    let autosave = Autosave::in_folder(state.clone()).unwrap();
    for name in ["1-a.toml", "autosave.toml"] {
        symlink(&victim, state.join(name)).unwrap();
    }
    assert_eq!(autosave.crashed(), []);
    autosave.note(1, None, "work".into());
    autosave.flush().unwrap();
    assert!(fs::read_to_string(&victim).unwrap().ends_with("stolen"));
}

#[test]
fn a_state_folder_that_cannot_be_made_is_an_error_that_names_it() {
    let folder = folder();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let error = Autosave::in_folder(file.join("autosave")).unwrap_err().to_string();
    assert!(error.contains("could not make the folder") && error.contains("file/autosave"), "{error}");
    // The inert one, as after such an error: it takes everything, and keeps nothing.
    let inert = Autosave::default();
    inert.note(1, None, "work".into());
    inert.flush().unwrap();
    assert_eq!(inert.crashed(), []);
    inert.forget(1);
}
