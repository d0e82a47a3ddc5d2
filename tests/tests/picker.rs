//! The list of analyses and the problems that are open, as a person sees them.

use std::fs;

use dalembert_tests::person::Person;
use dalembert_tui::{Msg, files::Autosave};

const FAN: &str = "vibration/rotating-unbalance";
const PENDULUM: &str = "vibration/large-pendulum";
const ROD: &str = "rigid-body/rod-on-shaft";

#[test]
fn several_problems_are_open_at_once() {
    let mut person = Person::at(100, 30).opens(FAN);
    assert!(!person.sees().contains("1/1"), "one is not counted:\n{}", person.sees());
    assert!(person.types("b").sees().contains("no other problem is open"));
    person.types("<end><del>1500 rpm<enter>");
    // Nothing is asked, nothing is lost.
    let mut person = person.opens(PENDULUM).opens(ROD);
    assert!(person.model.dialog.is_none() && person.sees().contains("3/3"), "{}", person.sees());
    person.types("b");
    let screen = person.sees();
    assert!(screen.contains("1/3") && screen.contains("1500 rpm") && screen.contains("4.5535"), "{screen}");
    assert!(person.types("b").sees().contains("Pendulum"), "{}", person.sees());
    // Enter in the list comes back to what is open.
    person.types("<esc>/rotunb<enter>");
    assert!(person.sees().contains("1/3") && person.sees().contains("1500 rpm"), "{}", person.sees());
    // From the list `b` comes back as well.
    person.types("<esc><esc>b");
    assert!(person.sees().contains("1/3"), "{}", person.sees());
}

#[test]
fn closing_asks_for_unsaved_work_alone() {
    let mut person = Person::at(100, 30).opens(FAN);
    person.types("<end>+");
    let mut person = person.opens(PENDULUM);
    person.types("B");
    assert!(person.model.dialog.is_none() && person.sees().contains("1001 rpm"), "{}", person.sees());
    person.types("B");
    assert!(person.sees().contains("close without saving"), "{}", person.sees());
    person.types("<esc>");
    assert!(person.sees().contains("1001 rpm"));
    person.types("B<down><enter>");
    assert!(person.sees().contains("List of analyses") && person.kept.is_empty(), "{}", person.sees());
    assert!(person.types("b").sees().contains("no problem is open"));
}

#[test]
fn the_end_names_everything_that_is_not_saved_and_saves_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut person = Person::at(100, 30).opens(FAN);
    person.types("<end>+");
    let mut person = person.opens(PENDULUM).opens(ROD);
    person.types("b").types("b").types("<del>2.5 m<enter>q");
    let screen = person.sees();
    assert!(screen.contains("2 problems have changes") && !person.has_left, "{screen}");
    assert_eq!(person.kept.len(), 2);
    // One after the other, each under its name.
    person.types("<enter>");
    for name in ["fan", "pendulum"] {
        assert!(!person.has_left && person.sees().contains("Save as"), "{}", person.sees());
        person.types(&format!("{}<enter>", folder.path().join(name).display()));
    }
    assert!(person.has_left && person.kept.is_empty());
    let saved = |name: &str| fs::read_to_string(folder.path().join(name)).expect("it was saved");
    assert!(saved("fan.toml").contains("1001 rpm"), "{}", saved("fan.toml"));
    assert!(saved("pendulum.toml").contains("2.5 m"), "{}", saved("pendulum.toml"));
}

#[test]
fn nine_problems_are_open_at_most_and_none_with_work_in_it_gives_way() {
    let mut person = Person::at(100, 30).opens(FAN);
    for n in 1..9 {
        person = person.opens(if n % 2 == 0 { ROD } else { PENDULUM });
        person.types("T").types(&format!("number {n}<enter>"));
    }
    assert!(person.sees().contains("9/9"));
    // The fan alone is as it was published.
    person = person.opens(ROD);
    assert!(person.sees().contains("9/9"), "{}", person.sees());
    person.types("T").types("number 9<enter>");
    let mut person = person.opens(PENDULUM);
    assert!(person.sees().contains("9 problems are open already"), "{}", person.sees());
    assert_eq!(person.model.problems().iter().map(|bench| bench.title.len()).min(), Some(8));
}

#[test]
fn a_file_is_open_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fan.toml");
    let mut person = Person::at(100, 30).opens(FAN);
    person.types(&format!("s{}<enter>", path.display()));
    person.types("<end>+");
    let mut person = person.opens(ROD).opens_file(&path);
    assert!(
        person.sees().contains("open already") && person.sees().contains("1001 rpm"),
        "{}",
        person.sees()
    );
    assert_eq!(person.model.problems().len(), 2);
    // Once the changes are saved it is read again.
    person.types("s");
    fs::write(&path, fs::read_to_string(&path).expect("saved").replace("1001", "1003")).expect("written");
    let mut person = person.opens_file(&path);
    assert!(person.sees().contains("1003 rpm") && person.sees().contains("1/2"), "{}", person.sees());
}

/// What the sessions left is taken up together, each in its place, and kept again at once.
#[test]
fn everything_a_crashed_session_left_is_taken_up() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("autosave");
    let mut person = Person::at(100, 30).opens(FAN);
    person.types("<end>+");
    let mut person = person.opens(ROD);
    person.types("T").types("the rod<enter>");
    let autosave = Autosave::in_folder(state.clone()).expect("a folder of its own");
    for (problem, text) in &person.kept {
        autosave.note(*problem, None, text.clone());
    }
    autosave.flush().expect("written");
    let files: Vec<_> = fs::read_dir(&state).expect("there").flatten().map(|entry| entry.path()).collect();
    assert_eq!(files.len(), 2);
    for file in &files {
        // As if it had begun at another time: the process of this number is another one now.
        let text = fs::read_to_string(file).expect("readable");
        let (before, after) = text.split_once(" began=").expect("the header says so");
        fs::write(file, format!("{before} began=1{after}")).expect("written");
    }
    let sessions = Autosave::in_folder(state.clone()).expect("there").crashed();
    let mut next = Person::at(100, 30);
    next.happens(Msg::Crashed(sessions));
    let screen = next.sees();
    assert!(screen.contains("2 problems") && screen.contains("Rotating unbalance"), "{screen}");
    next.types("<enter>");
    let texts: Vec<String> = next.kept.values().cloned().collect();
    assert!(texts.iter().any(|text| text.contains("1001 rpm")), "{texts:?}");
    assert!(texts.iter().any(|text| text.contains("the rod")), "{texts:?}");
    assert_eq!((next.model.problems().len(), fs::read_dir(&state).expect("there").count()), (2, 0));
}
