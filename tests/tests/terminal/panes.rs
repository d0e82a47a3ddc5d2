//! Every pane: how it looks, that keys reach it, that it cuts no word in silence, and that its keys are all reported.

use std::{collections::HashSet, fs, path::Path};

use dalembert_core::{Entry, registry};
use dalembert_tests::person::Person;
use dalembert_tui::{keys::KeyContext, pane::Content, panes};
use insta::assert_snapshot;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

const FAN: &str = "vibration/rotating-unbalance";
const SIZES: [(u16, u16); 3] = [(80, 24), (120, 36), (200, 60)];

/// The screens of a user for the same keys, at every size: in English with its colours, in Portuguese, in ASCII.
fn everywhere(before: impl Fn(Person) -> Person, keys: &str) -> String {
    let screens = SIZES.map(|(columns, rows)| {
        let after = |person: Person| {
            let mut person = before(person);
            person.types(keys);
            person
        };
        let mut english = after(Person::at(columns, rows));
        let (screen, ink) = (english.sees(), english.sees_ink());
        let portuguese = after(Person::in_portuguese(columns, rows)).sees();
        let ascii = after(Person::in_ascii(columns, rows)).sees();
        let size = format!("{columns}×{rows}");
        format!(
            "== {size}\n{screen}== {size} colours\n{ink}== {size} em português\n{portuguese}== {size} in ASCII\n{ascii}"
        )
    });
    screens.concat()
}

#[test]
fn every_pane_of_the_fan_at_every_size() {
    for (name, keys) in [
        ("results", ""),
        ("results_compared", "<end>c<s-up><tab>"),
        ("working", "]<right>"),
        ("plot", "]]<home><right>"),
        ("drawing", "]]]"),
        ("check", "]]]]<down>106,2<enter>"),
        ("sensitivity", "]]]]]"),
        ("study", "]]]]]]"),
        ("sources", "["),
        ("field_wrong", "<end><del>12 kg<enter>"),
        ("choices", "<down><down><enter>"),
        ("question", "<end>+q"),
        ("path", "X"),
        ("help", "?"),
        ("palette", ":comp"),
    ] {
        assert_snapshot!(format!("fan_{name}"), everywhere(|person| person.opens(FAN), keys));
    }
}

/// Panes that the fan lacks: tables, rows within rows, rotating scenes, animations, polar diagrams, marks of weights.
#[test]
fn every_other_pane_at_every_size() {
    for (name, id, keys) in [
        ("table", "vibration/modal-analysis", "]]]]"),
        ("rows", "vibration/rotor-dynamics", "<down><down><down><enter>"),
        ("scene", "rigid-body/free-triaxial", "]]]i<right>"),
        ("animation", "virtual-work/engine", "]]] ."),
        ("polar", "balancing/two-plane", "]]"),
        ("field_job", "balancing/field", "<tab>"),
    ] {
        assert_snapshot!(format!("other_{name}"), everywhere(|person| person.opens(id), keys));
    }
}

#[test]
fn the_list_at_every_size() {
    let course = [
        "vibration/beam-and-springs",
        "vibration/frequency-response-identification",
        FAN,
        "vibration/shaft-clearance",
    ];
    assert_snapshot!("list_everywhere", everywhere(|person| person.knows(&course), "<down><down>"));
}

/// Words of a wide and tall screen, where nothing is cut, hold every word of the smaller ones: one that is not among
/// them was cut, and reports it.
#[test]
fn a_word_is_whole_or_marked_as_cut() {
    let mut faults = Vec::new();
    for entry in one_of_each_topic() {
        let known = whole_words(entry);
        for (columns, rows) in SIZES {
            for (tab, screen) in texts(entry, columns, rows) {
                // The frames have the names of tabs, and the foot has hints that depend on the room.
                let inner = screen.lines().filter(|line| line.starts_with('│')).flat_map(words);
                let is_word = |word: &&str| word.chars().any(char::is_alphabetic) && !word.contains('…');
                let cut = inner.filter(is_word).find(|word| !known.contains(*word));
                faults.extend(cut.map(|word| format!("{} {tab:?} {columns}×{rows}: {word}", entry.about.id)));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The tabs of text of an analysis, and its form beside each.
fn texts(entry: &Entry, columns: u16, rows: u16) -> Vec<(&'static str, String)> {
    let mut person = Person::at(columns, rows).opens(entry.about.id);
    let mut shown = Vec::new();
    loop {
        let bench = person.model.bench.as_ref().expect("a problem is open");
        let (pane, last) = (bench.shown(), bench.tabs().last() == Some(&bench.tab));
        let (name, column) = (pane.name(), pane.content());
        if column != Content::Picture {
            shown.push((name, person.sees()));
        }
        if last {
            return shown;
        }
        person.types("]");
    }
}

/// Words of the form and of every pane where nothing is cut: each alone on a wide and tall screen.
fn whole_words(entry: &Entry) -> HashSet<String> {
    let mut person = Person::at(300, 300).opens(entry.about.id);
    let tabs = person.model.bench.as_ref().map_or(0, |bench| bench.tabs().len());
    let mut screens = person.sees() + &person.types("e").sees();
    person.types("e<tab>e");
    for _ in 0..tabs {
        screens += &person.sees();
        person.types("]");
    }
    // Their numbers stand right before the names of tabs.
    let names = panes::all().into_iter().map(|pane| pane.name().to_owned());
    words(&screens).map(str::to_owned).chain(names).collect()
}

/// Words and what stands in for their rest; curves and frames beside them are none of them.
fn words(screen: &str) -> impl Iterator<Item = &str> {
    screen.split(|c: char| !c.is_alphanumeric() && c != '…').filter(|word| !word.is_empty())
}

/// The first analysis of each topic: what belongs to one topic is drawn alike.
fn one_of_each_topic() -> impl Iterator<Item = &'static Entry> {
    let mut seen = HashSet::new();
    registry().iter().copied().filter(move |entry| seen.insert((entry.family(), entry.about.topic)))
}

#[test]
fn keys_reach_every_tab_plot_and_drawing() {
    for entry in one_of_each_topic() {
        let mut person = Person::at(80, 24).opens(entry.about.id);
        let shown = |person: &Person| {
            let bench = person.model.bench.as_ref().expect("a problem is open");
            (bench.tab, bench.shown().name(), bench.shown().content(), bench.shown().shown())
        };
        let problem = person.model.bench.as_ref().expect("a problem is open");
        let tabs = problem.tabs();
        let (plots, drawings) = (problem.problem.plots().count(), problem.problem.drawings().count());
        let (mut seen, mut plots_seen, mut drawings_seen) = (Vec::new(), HashSet::new(), HashSet::new());
        for _ in 0..tabs.len() {
            let (tab, name, column, _) = shown(&person);
            seen.push(tab);
            if column == Content::Picture {
                for _ in 0..plots.max(drawings) {
                    let (.., at) = shown(&person);
                    if name == "Plot" {
                        plots_seen.insert(at)
                    } else {
                        drawings_seen.insert(at)
                    };
                    person.types("n");
                }
            }
            person.types("]");
        }
        assert_eq!(
            (seen, plots_seen.len(), drawings_seen.len()),
            (tabs, plots, drawings),
            "{}",
            entry.about.id
        );
    }
}

/// A key that no table of the place has changes nothing on the screen, where characters are no text.
#[test]
fn no_key_is_unreported() {
    // A character begins a value in the form, and the user's answer in a cell.
    let begins = |place: KeyContext, code: KeyCode| {
        (place == KeyContext::Form || place.has_cells())
            && matches!(code, KeyCode::Char(c) if c.is_ascii_digit() || "(.,−√-+".contains(c))
    };
    let mut keys: Vec<KeyEvent> =
        (' '..='~').map(|c| KeyEvent::new(KeyCode::Char(c), KeyModifiers::NONE)).collect();
    keys.extend(('a'..='z').map(|c| KeyEvent::new(KeyCode::Char(c), KeyModifiers::CONTROL)));
    let named = [
        KeyCode::Enter,
        KeyCode::Tab,
        KeyCode::BackTab,
        KeyCode::Backspace,
        KeyCode::Delete,
        KeyCode::Insert,
        KeyCode::Home,
        KeyCode::End,
        KeyCode::PageUp,
        KeyCode::PageDown,
        KeyCode::Up,
        KeyCode::Down,
        KeyCode::Left,
        KeyCode::Right,
    ];
    for code in named.into_iter().chain((1..=12).map(KeyCode::F)) {
        for held in [KeyModifiers::NONE, KeyModifiers::SHIFT, KeyModifiers::ALT, KeyModifiers::CONTROL] {
            keys.push(KeyEvent::new(code, held));
        }
    }
    let mut places = HashSet::new();
    for typed in
        ["", "<tab>", "]", "]]", "]]]", "]]]]", "[", "<down><down><enter>", "?", "<esc>", "<esc><esc>"]
    {
        let mut person = Person::at(100, 30).opens(FAN);
        let before = person.types(typed).sees();
        let place = person.model.place();
        places.insert(place.id());
        for key in &keys {
            let means = begins(place, key.code) || person.model.keys.action(place, *key).is_some();
            if place.is_text() || means || dalembert_tui::keys::is_escape_and(*key) {
                continue;
            }
            let after = person.happens(dalembert_tui::Msg::Key(*key)).sees();
            assert_eq!(before, after, "{key:?} does something in {place:?} that nothing tells");
        }
    }
    for place in
        ["inputs", "results", "working", "plot", "drawing", "choices", "help-page", "filter-line", "picker"]
    {
        assert!(places.contains(place), "{place} is not among {places:?}");
    }
}

/// A pane is one file and its `mod` line: no other file of the workbench names it.
#[test]
fn a_pane_is_named_in_its_own_file_alone() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/tui/src");
    let mut files = Vec::new();
    let mut folders = vec![source.clone()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() { folders.push(path) } else { files.push(path) }
        }
    }
    let texts: Vec<(String, String)> = files
        .into_iter()
        .map(|path| {
            let name = path.strip_prefix(&source).expect("within").display().to_string();
            (name, fs::read_to_string(path).expect("a text"))
        })
        .collect();
    let panes: Vec<&str> = texts
        .iter()
        .filter(|(_, text)| text.contains("register_pane!(") && !text.contains("macro_rules! register_pane"))
        .filter_map(|(name, _)| name.strip_prefix("panes/")?.strip_suffix(".rs"))
        .collect();
    assert_eq!(panes.len(), panes::all().len(), "{panes:?}");
    for pane in panes {
        let own = [format!("panes/{pane}.rs"), format!("panes/{pane}/")];
        let others = texts.iter().filter(|(name, _)| !own.iter().any(|own| name.starts_with(own)));
        for (name, text) in others {
            let siblings = text.split("use super::{").nth(1).and_then(|text| text.split("};").next());
            let words = siblings.filter(|_| name.starts_with("panes/")).unwrap_or_default();
            let is_named = text.contains(&format!("panes::{pane}::"))
                || text.contains(&format!("super::{pane}::"))
                || words.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == pane);
            assert!(!is_named, "{name} names the pane {pane}");
        }
        let lines = texts.iter().find(|(name, _)| name == "panes.rs").map_or("", |(_, text)| text).lines();
        let lines: Vec<&str> = lines.filter(|line| line.contains(pane) && !line.starts_with("//")).collect();
        assert_eq!(lines, [format!("pub mod {pane};")], "a line for each pane");
    }
}

#[test]
fn enter_on_an_answer_shows_the_steps_that_lead_to_it_alone() {
    let mut person = Person::at(100, 100).opens("vibration/rotating-unbalance");
    person.turns_to("Working");
    let all = person.sees();
    assert!(all.contains("Damping coefficient") && all.contains("Frequency ratio"), "{all}");
    person.turns_to("Results").types("v");
    let chosen = person.sees();
    let down = chosen.lines().position(|line| line.contains("Natural frequency"));
    let first = chosen.lines().position(|line| line.contains("ratio") || line.contains("Amplitude"));
    assert!(down.is_some() && first.is_some(), "{chosen}");
    for _ in 0..20 {
        person.types("<down>");
    }
    let seen = person.types("<enter>").sees();
    assert!(seen.contains("Steps that lead to"), "{seen}");
    assert!(!seen.contains("of 11 steps hidden") && seen.contains("Stiffness of a cantilever"), "{seen}");
    let again = person.types("<esc>").sees();
    assert!(!again.contains("Steps that lead to") && again.contains("Frequency ratio"), "{again}");
}
