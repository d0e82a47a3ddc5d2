//! Every pane: how it looks, and that its keys are all told.

use std::collections::HashSet;

use dalembert_tests::person::Person;
use dalembert_tui::keys::Place;
use insta::assert_snapshot;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

const FAN: &str = "vibration/rotating-unbalance";
const SIZES: [(u16, u16); 3] = [(80, 24), (120, 36), (200, 60)];

/// The screens of a person for the same keys: at three sizes, in Portuguese, and in ASCII.
fn everywhere(before: impl Fn(Person) -> Person, keys: &str) -> String {
    let people = SIZES
        .map(|(columns, rows)| (format!("{columns}×{rows}"), Person::at(columns, rows)))
        .into_iter()
        .chain([
            ("80×24 em português".to_owned(), Person::in_portuguese(80, 24)),
            ("80×24 in ASCII".to_owned(), Person::in_ascii(80, 24)),
        ]);
    let screens = people.map(|(what, person)| {
        let screen = before(person).types(keys).sees();
        format!("== {what}\n{screen}")
    });
    screens.collect::<Vec<_>>().concat()
}

#[test]
fn every_pane_of_the_fan_at_every_size() {
    for (name, keys) in [
        ("results", ""),
        ("results_compared", "<end>c<s-up><tab>"),
        ("working", "]<tab><right>"),
        ("plot", "]]<tab><home><right>"),
        ("drawing", "]]]<tab>"),
        ("sources", "[<tab>"),
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

/// A key that no table of the place has changes nothing on the screen, where characters are no text.
#[test]
fn no_key_is_untold() {
    // A character begins a value in the form, and an answer of one's own in a cell.
    let begins = |place: Place, code: KeyCode| {
        matches!(place, Place::Form | Place::Cells)
            && matches!(code, KeyCode::Char(c) if c.is_ascii_digit() || "(.,−√-+".contains(c))
    };
    let mut keys: Vec<KeyEvent> =
        (' '..='~').map(|c| KeyEvent::new(KeyCode::Char(c), KeyModifiers::NONE)).collect();
    keys.extend(('a'..='z').map(|c| KeyEvent::new(KeyCode::Char(c), KeyModifiers::CONTROL)));
    keys.extend(('a'..='z').map(|c| KeyEvent::new(KeyCode::Char(c), KeyModifiers::ALT)));
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
    for typed in [
        "",
        "<tab>",
        "]<tab>",
        "]]<tab>",
        "]]]<tab>",
        "]]]]<tab>",
        "[<tab>",
        "<down><down><enter>",
        "?",
        "<esc>",
    ] {
        let mut person = Person::at(100, 30).opens(FAN);
        let before = person.types(typed).sees();
        let place = person.model.place();
        places.insert(format!("{place:?}"));
        for key in &keys {
            if place.is_text() || begins(place, key.code) || person.model.keys.action(place, *key).is_some() {
                continue;
            }
            let after = person.happens(dalembert_tui::Msg::Key(*key)).sees();
            assert_eq!(before, after, "{key:?} does something in {place:?} that nothing tells");
        }
    }
    for place in ["Form", "Pane", "Working", "Plot", "Drawing", "List", "Help", "Picker"] {
        assert!(places.contains(place), "{place} is not among {places:?}");
    }
}
