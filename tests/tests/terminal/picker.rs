//! The list of analyses and the problems that are open, as a user sees them.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs::{self, File},
    time::{Duration, SystemTime},
};

use dalembert_core::{Language, exercises, registry};
use dalembert_tests::{
    person::Person,
    pty::{self, Launch, Pty, Signal},
};
use dalembert_tui::{
    Msg,
    files::Autosave,
    picker::{Heading, Row},
    remembered::{HistoryChange, Progress},
};
use insta::assert_snapshot;

const FAN: &str = "vibration/rotating-unbalance";
const PENDULUM: &str = "vibration/large-pendulum";
const ROD: &str = "rigid-body/rod-on-shaft";

#[test]
fn several_problems_are_open_at_once() {
    let mut person = Person::at(100, 30).opens(FAN);
    assert!(!person.sees().contains("1/1"), "one is not counted:\n{}", person.sees());
    assert!(person.types("b").sees().contains("no other open problem"));
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
    assert!(person.types("<esc>b").sees().contains("no open problem"));
}

#[test]
fn the_end_names_everything_that_is_not_saved_and_saves_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut person = Person::at(100, 30).opens(FAN);
    person.types("<end>+");
    let mut person = person.opens(PENDULUM).opens(ROD);
    person.types("b").types("b").types("<del>2.5 m<enter>q");
    let screen = person.sees();
    assert!(screen.contains("2 problems have unsaved") && !person.has_quit, "{screen}");
    assert_eq!(person.kept.len(), 2);
    // One after the other, each under its name.
    person.types("<enter>");
    for name in ["fan", "pendulum"] {
        assert!(!person.has_quit && person.sees().contains("Save as"), "{}", person.sees());
        person.types(&format!("{}<enter>", folder.path().join(name).display()));
    }
    assert!(person.has_quit && person.kept.is_empty());
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
    assert!(person.sees().contains("9 problems are open"), "{}", person.sees());
    assert_eq!(person.model.problems().iter().map(|bench| bench.problem.document.title.len()).min(), Some(8));
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
        person.sees().contains("already open") && person.sees().contains("1001 rpm"),
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

/// Autosaved work of all crashed sessions is recovered together, each in its place, and autosaved again at once.
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
        let (before, after) = text.split_once(" began=").expect("the header has it");
        fs::write(file, format!("{before} began=1{after}")).expect("written");
        // The newest comes first; two writes within one tick of the clock have no order.
        if text.contains("the rod") {
            let later = SystemTime::now() + Duration::from_secs(10);
            File::options().write(true).open(file).and_then(|file| file.set_modified(later)).expect("a time");
        }
    }
    let sessions = Autosave::in_folder(state.clone()).expect("there").crashed();
    let mut next = Person::at(100, 30);
    next.happens(Msg::Crashed(sessions));
    let screen = next.sees();
    assert!(screen.contains("2 problems") && screen.contains("the rod; Rotating unbalance"), "{screen}");
    next.types("<enter>");
    let texts: Vec<String> = next.kept.values().cloned().collect();
    assert!(texts.iter().any(|text| text.contains("1001 rpm")), "{texts:?}");
    assert!(texts.iter().any(|text| text.contains("the rod")), "{texts:?}");
    assert_eq!((next.model.problems().len(), fs::read_dir(&state).expect("there").count()), (2, 0));
}

#[test]
fn a_problem_that_a_crashed_session_left_is_called_by_its_analysis() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("autosave");
    let mut person = Person::at(100, 30).opens(FAN);
    person.types("<end>+");
    let autosave = Autosave::in_folder(state.clone()).expect("a folder of its own");
    for (problem, text) in &person.kept {
        autosave.note(*problem, None, text.clone());
    }
    autosave.flush().expect("written");
    let file = fs::read_dir(&state).expect("there").flatten().next().expect("it is kept").path();
    let text = fs::read_to_string(&file).expect("readable");
    let (before, after) = text.split_once(" began=").expect("the header has it");
    fs::write(&file, format!("{before} began=1{after}")).expect("written");
    let sessions = Autosave::in_folder(state).expect("there").crashed();
    for (mut person, name) in
        [(Person::at(100, 30), "Rotating unbalance"), (Person::in_portuguese(100, 30), "Desbalanceamento")]
    {
        let screen = person.happens(Msg::Crashed(sessions.clone())).sees();
        let asked = screen.lines().filter(|line| line.contains(name)).count();
        assert!(asked >= 1 && !screen.contains("without a file"), "{screen}");
    }
}

#[test]
fn the_state_of_an_exercise_stands_behind_the_longest_title() {
    let mut person = Person::at(80, 30);
    let lists = Row::Heading(Heading::Exercises);
    let at = person.model.picker.rows(person.model.contents()).iter().position(|row| *row == lists);
    person.types("<esc><home>").types(&"<down>".repeat(at.expect("lists of exercises")));
    person.types("<right><down>");
    let shown = person.sees();
    let exercises = shown.lines().filter(|line| line.contains("• ")).count();
    assert!(exercises > 3 && shown.matches("not started").count() == exercises, "{shown}");
}

/// These screens are of these analyses, so that another analysis changes no snapshot. They are more than a few: the
/// topics begin folded.
const SOME: [&str; 15] = [
    "rigid-body/heavy-top",
    "rigid-body/momentum",
    "rigid-body/rod-on-shaft",
    "rigid-body/spinning-disc-on-arm",
    "rigid-body/top-nutation",
    "vibration/base-excitation",
    "vibration/beam-and-springs",
    "vibration/damped-absorber",
    "vibration/equivalent-stiffness",
    "vibration/free-vibration",
    "vibration/frequency-response-identification",
    "vibration/large-pendulum",
    "vibration/logarithmic-decrement",
    "vibration/rotating-unbalance",
    "vibration/shaft-clearance",
];

#[test]
fn the_list_is_a_tree_of_families_and_topics() {
    for (columns, rows) in [(80, 24), (120, 36), (200, 60)] {
        let mut english = Person::at(columns, rows).knows(&SOME);
        assert_snapshot!(format!("tree_{columns}x{rows}"), english.sees());
        let mut portuguese = Person::in_portuguese(columns, rows).knows(&SOME);
        let keys = "<down>".repeat(8);
        assert_snapshot!(
            format!("tree_{columns}x{rows}_pt"),
            portuguese.types(&keys).types("<right><down>").sees()
        );
    }
    let mut plain = Person::in_ascii(80, 24).knows(&SOME);
    let screen = plain.types("<right><down><down>").sees();
    assert!(screen.is_ascii(), "{screen}");
    assert_snapshot!("tree_ascii", screen);
}

#[test]
fn headings_are_opened_and_folded() {
    let mut person = Person::at(80, 24).knows(&SOME);
    let closed = person.sees();
    assert!(!closed.contains("Heavy top"), "{closed}");
    // On the family; its first topic is below.
    person.types("<down><right>");
    let open = person.sees();
    assert!(open.contains("Slender rod") && open.contains("Disc spinning"), "{open}");
    assert!(person.types("<right>").sees().contains("rigid-body/rod-on-shaft"), "{}", person.sees());
    // Back to the heading, and shut.
    person.types("<left>");
    assert_eq!(person.sees(), open);
    person.types("<enter><up>");
    assert_eq!(person.sees(), closed);
    person.types("<left>");
    assert!(!person.sees().contains("▸ Free bodies and tops"), "{}", person.sees());
    // Of a heading it is said what stands under it.
    assert!(person.sees().contains("5 analyses"), "{}", person.sees());
}

#[test]
fn every_analysis_is_reached_in_its_topic() {
    let mut person = Person::at(100, 30);
    let total = person.model.listings.len();
    // Everything is opened: a heading is followed by what stands under it.
    let rows = |person: &Person| person.model.picker.rows(person.model.contents());
    person.types("<esc><home>");
    let mut at = 0;
    while at < rows(&person).len() {
        if let Row::Heading(heading) = rows(&person)[at]
            && heading != Heading::Field
            && !person.model.picker.is_open(heading, &person.model.listings)
        {
            person.types("<enter>");
        }
        person.types("<down>");
        at += 1;
    }
    let under_topics =
        rows(&person).into_iter().filter(|row| matches!(row.under(), Some(Heading::Topic(..))));
    assert_eq!(under_topics.count(), total);
}

/// A topic of one analysis is no topic, and one of very many is none either. A family of the tree alone is compared with it.
#[test]
fn topics_hold_a_handful_each() {
    let mut topics: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for entry in registry() {
        *topics.entry((entry.family(), entry.about.topic)).or_default() += 1;
    }
    for (topic, count) in topics {
        assert!(
            (2..=10).contains(&count),
            "{topic:?} holds {count}: take a topic that is there, or divide it"
        );
    }
}

#[test]
fn the_filter_finds_words_in_any_order_in_both_languages() {
    for (filter, id) in [
        ("cursor manivela", "virtual-work/slider-crank"),
        ("francis", "vibration/shaft-clearance"),
        ("turbine francis", "vibration/shaft-clearance"),
        ("pêndulo grande", "vibration/large-pendulum"),
        ("pendulo amplitude", "vibration/large-pendulum"),
        ("desbalanceamento rotativo", "vibration/rotating-unbalance"),
        ("list 07 question 2", "vibration/rotating-unbalance"),
        ("fan cantilever", "vibration/rotating-unbalance"),
        ("PIÃO nutação", "rigid-body/top-nutation"),
        ("nutacao piao", "rigid-body/top-nutation"),
        ("heavy top nutation", "rigid-body/top-nutation"),
        ("log decrem", "vibration/logarithmic-decrement"),
    ] {
        if dalembert_core::find(id).is_none() {
            continue;
        }
        let mut person = Person::at(80, 24);
        person.types("/").types(filter);
        assert_eq!(chosen(&person), Some(id), "{filter}:\n{}", person.sees());
    }
    let mut person = Person::at(80, 24);
    person.types("/vibracoes");
    let found = person.model.picker.rows(person.model.contents()).len();
    assert!(found > 50, "{found}: the family by its Portuguese name, without accents");
    assert!(person.types("<esc>/beer 18").sees().contains("/ beer 18"), "{}", person.sees());
    assert!(chosen(&person).is_some_and(|id| id.starts_with("rigid-body/")), "{}", person.sees());
}

#[test]
fn a_case_that_the_filter_means_is_shown_and_opened() {
    let mut person = Person::at(100, 30);
    person.types("/assumed damping fan");
    let screen = person.sees();
    let line = screen.lines().find(|line| line.contains("The fan with the assumed")).unwrap_or_default();
    assert!(line.contains('▸'), "{screen}");
    person.types("<enter>");
    assert!(person.sees().contains("The fan with the assumed damping"), "{}", person.sees());
    let Some(bench) = &person.model.bench else { panic!("a problem is open") };
    assert_eq!(
        bench.problem.document.origin.as_ref().map(|case| case.name.as_str()),
        Some("The fan with the assumed damping")
    );
    // The filter is still there; without it the list is open where the analysis stands.
    person.types("<esc><esc>");
    assert_eq!(chosen(&person), Some(FAN), "{}", person.sees());
}

#[test]
fn cases_have_their_verdicts_beside_the_list() {
    let mut person = Person::at(120, 40);
    person.types("/rotunb");
    let screen = person.sees();
    let line = |text: &str| screen.lines().find(|line| line.contains(text)).unwrap_or_default().to_owned();
    assert!(line("Cases: ").contains('✓') && line("Cases: ").contains('≠'), "{screen}");
    // The amplitude that was printed for the fan is disputed.
    assert!(line("Fan on a cantilever").contains('≠'), "{screen}");
    assert!(line("Fan on a cantilever, corrected").contains('✓'), "{screen}");
    assert!(screen.contains('⢀') || screen.contains('⠤') || screen.contains('─'), "{screen}");
}

#[test]
fn pinned_and_recent_analyses_head_the_list() {
    let mut person = Person::at(80, 24).knows(&SOME);
    person.types("/heavy top<enter><esc><esc>*");
    let screen = person.sees();
    let place = |text: &str| screen.find(text).unwrap_or_else(|| panic!("{text} not found:\n{screen}"));
    assert!(place("Pinned") < place("Exercise lists"), "{screen}");
    assert_eq!(chosen(&person), Some("rigid-body/heavy-top"), "the cursor stays:\n{screen}");
    person.types("/rotunb<enter><esc><esc>");
    let screen = person.sees();
    assert!(screen.contains("Recent"), "{screen}");
    assert_snapshot!("pinned_and_recent", person.types("<home><down>").sees());
    assert!(person.remembered.contains(&HistoryChange::Pin("rigid-body/heavy-top".into(), true)));
    assert!(person.remembered.contains(&HistoryChange::Open(FAN.into())));
    // Pinned no more; it is the recent one now.
    person.types("*");
    assert!(!person.sees().contains("Pinned") && person.sees().contains("Heavy top"), "{}", person.sees());
}

#[test]
fn exercises_are_opened_and_marked() {
    let mut person = Person::at(120, 36);
    let lists = Row::Heading(Heading::Exercises);
    let at = person.model.picker.rows(person.model.contents()).iter().position(|row| *row == lists);
    person.types("<esc><home>").types(&"<down>".repeat(at.expect("lists of exercises")));
    person.types("<right><down><right>");
    let screen = person.sees();
    assert!(screen.contains("Exercise lists") && screen.contains("0/"), "{screen}");
    // The first exercise is opened, with its own inputs.
    person.types("<down><enter>");
    let case = person
        .model
        .bench
        .as_ref()
        .and_then(|bench| bench.problem.document.origin.as_ref())
        .map(|case| case.name.clone());
    let case = case.expect("an exercise is a published case");
    person.types("<esc>");
    let line = |person: &mut Person, text: &str| {
        let screen = person.sees();
        // The title of the preview has the name of the exercise too.
        let row = screen.lines().find(|line| line.starts_with('│') && line.contains(text));
        row.map(str::to_owned).unwrap_or(screen)
    };
    let shown: String = case.chars().take(20).collect();
    assert!(line(&mut person, &shown).contains('○'), "{}", person.sees());
    person.types("<esc><space>");
    assert!(line(&mut person, &shown).contains('✓'), "{}", person.sees());
    assert!(line(&mut person, "Exercise lists").contains("1/"), "{}", person.sees());
    assert!(matches!(person.remembered.last(), Some(HistoryChange::Reach { progress: Progress::Done, .. })));
    person.types("<space>");
    assert!(line(&mut person, "Exercise lists").contains("0/"), "{}", person.sees());
    // Found right by hand, it is done as well.
    let Some(HistoryChange::Reach { analysis, case, .. }) = person.remembered.last().cloned() else {
        panic!("{:?}", person.remembered);
    };
    person.model.remembered.take(&HistoryChange::Reach { analysis, case, progress: Progress::Solved });
    assert!(line(&mut person, "Exercise lists").contains("1/"), "{}", person.sees());
}

#[test]
fn lists_of_exercises_are_found_by_their_name() {
    let exercise = "Slider-crank with given vectors";
    for search in ["exercise lists", "dynamics machinery"] {
        let screen = Person::at(120, 30).types(search).sees();
        assert!(screen.contains(exercise), "{search}: {screen}");
    }
    // One word of a title asks for analyses.
    let screen = Person::at(120, 30).types("machinery").sees();
    assert!(!screen.contains(exercise), "{screen}");
}

#[test]
fn every_exercise_of_the_lists_is_there() {
    for list in exercises::bundled() {
        let list = list.expect("the list can be read");
        assert_ne!(list.title(Language::English), list.title(Language::Portuguese));
        for exercise in &list.list {
            let Some(entry) = dalembert_core::find(&exercise.analysis) else {
                assert!(!all_families_are_linked(), "{} is no analysis", exercise.analysis);
                continue;
            };
            let cases = dalembert_core::cases::cases(entry).expect("the cases can be read");
            let there = exercise.case.is_empty() || cases.iter().any(|case| case.is_named(&exercise.case));
            assert!(there, "{}: there is no case `{}`", exercise.analysis, exercise.case);
        }
    }
    assert!(exercises::bundled().len() >= 2);
}

#[test]
fn what_is_pinned_and_recent_outlives_the_session() {
    let home = tempfile::tempdir().expect("a folder");
    let started = |arguments: &str| {
        let script = format!("\"$PROGRAM\" {arguments}; exit $?");
        let launch = Launch::new(pty::program()).in_script(&script);
        launch.env("XDG_STATE_HOME", home.path().to_str().expect("a readable path")).start()
    };
    let mut pty = started("vibration/large-pendulum");
    pty.expect("Pendulum of large");
    to_list(&mut pty);
    pty.types("/rotunb<enter>");
    pty.expect("19.456");
    to_list(&mut pty);
    pty.types("<esc>");
    pty.expect("▸ Isolation, absorbers");
    pty.types("*");
    pty.expect("pinned at the top of the list");
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
    let file = home.path().join("dalembert/remembered.toml");
    let text = fs::read_to_string(&file).expect("it was written");
    assert!(text.contains("pinned = [\"vibration/rotating-unbalance\"]"), "{text}");

    let mut pty = started("vibration/large-pendulum --readonly");
    pty.expect("Pendulum of large");
    to_list(&mut pty);
    pty.expect("Pinned");
    pty.expect("Recent");
    pty.types("<esc>");
    pty.expect("q quit");
    pty.types("*");
    pty.idle(Duration::from_millis(200));
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
    assert_eq!(fs::read_to_string(&file).ok(), Some(text), "read-only, nothing is written");

    // A broken file is reported about, and left.
    fs::write(&file, "pinned = [").expect("written");
    let mut pty = started("vibration/large-pendulum");
    pty.expect("cannot be read and is left");
    to_list(&mut pty);
    pty.types("<esc>");
    pty.expect("q quit");
    pty.types("*q");
    assert_eq!(pty.exit_code(), Some(0));
    assert_eq!(fs::read_to_string(&file).ok().as_deref(), Some("pinned = ["));
}

#[test]
fn two_edited_problems_are_offered_after_a_crash() {
    let home = tempfile::tempdir().expect("a folder");
    let started = || {
        let launch = Launch::new(pty::program());
        launch.env("XDG_STATE_HOME", home.path().to_str().expect("a readable path")).start()
    };
    let mut pty = started();
    pty.expect("19.456");
    pty.types("<end><del>1234 rpm<enter>");
    to_list(&mut pty);
    pty.types("/large pendulum<enter>");
    pty.expect("2/2");
    pty.types("<del>2.345 m<enter>");
    pty.expect("2.345 m");
    pty.idle(Duration::from_millis(200));
    pty.signal(-1, Signal::TERM);
    assert_eq!(pty.exit_code(), Some(143));

    let mut pty = started();
    pty.expect("2 problems");
    pty.types("<enter>");
    // Beside the problem that the program began with.
    pty.expect("3/3");
    for _ in 0..2 {
        pty.types("b");
        pty.idle(Duration::from_millis(100));
    }
    pty.expect("2/3");
    let seen = pty.screen();
    pty.types("b");
    pty.expect("3/3");
    let both = seen + &pty.screen();
    assert!(both.contains("1234 rpm") && both.contains("2.345 m"), "{both}");
    pty.types("q");
    pty.expect("2 problems have unsaved");
    pty.types("<down><enter>");
    assert_eq!(pty.exit_code(), Some(0));
    assert_eq!(fs::read_dir(home.path().join("dalembert/autosave")).expect("there").count(), 0);
}

/// `Esc` by itself: with a character right behind it, it would be that character with Alt.
fn to_list(pty: &mut Pty) {
    pty.types("<esc>");
    pty.expect("List of analyses");
}

/// The analysis that is chosen.
fn chosen(person: &Person) -> Option<&'static str> {
    match person.model.picker.chosen(person.model.contents())? {
        Row::Leaf(leaf) => Some(person.model.listings[leaf.listing].entry.about.id),
        Row::Heading(_) => None,
    }
}

fn all_families_are_linked() -> bool {
    let families: BTreeSet<&str> = registry().iter().map(|entry| entry.family()).collect();
    families.len() >= 4
}
