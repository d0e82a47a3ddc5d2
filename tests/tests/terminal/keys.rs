//! Keys and where they go: tabs by number, the pane they are turned to, what is selected, and the line of the search.

use dalembert_core::Draft;
use dalembert_tests::person::Person;
use dalembert_tui::keys::KeyContext;
use ratatui::style::Modifier;

const FAN: &str = "vibration/rotating-unbalance";
const MODES: &str = "vibration/modal-analysis";
/// An analysis with several lists of the same name.
const BEAM: &str = "vibration/beam-with-tip-body";
/// One column, two and three.
const SIZES: [(u16, u16); 4] = [(40, 16), (80, 24), (120, 36), (200, 60)];

fn fan(columns: u16, rows: u16) -> Person {
    Person::at(columns, rows).opens(FAN)
}

/// The name of the shown pane, and whether the keys are in it.
fn shown(person: &Person) -> (&'static str, bool) {
    let bench = person.model.bench.as_ref().expect("a problem is open");
    (bench.shown().name(), person.model.place().is_pane())
}

/// The text of an input.
fn input(person: &Person, path: &str) -> String {
    let problem = &person.model.bench.as_ref().expect("a problem is open").problem;
    match problem.inputs.form.draft.at(&problem.entry().shape(), path) {
        Ok((Draft::Leaf(text), _)) => text.clone(),
        other => panic!("{path}: {other:?}"),
    }
}

fn is_unsaved(person: &Person) -> bool {
    person.model.bench.as_ref().is_some_and(|bench| bench.problem.is_unsaved())
}

/// The line of the screen that holds a text.
#[track_caller]
fn line_with(person: &mut Person, text: &str) -> String {
    let screen = person.sees();
    let line = screen.lines().find(|line| line.contains(text));
    line.unwrap_or_else(|| panic!("`{text}` is not on the screen:\n{screen}")).to_owned()
}

#[test]
fn every_tab_is_reached_by_the_number_that_stands_before_its_name() {
    const TABS: [(&str, char, &str); 9] = [
        ("1", '¹', "Results"),
        ("2", '²', "Working"),
        ("3", '³', "Plot"),
        ("4", '⁴', "Drawing"),
        ("5", '⁵', "Table"),
        ("6", '⁶', "Check"),
        ("7", '⁷', "Sensitivity"),
        ("8", '⁸', "Study"),
        ("9", '⁹', "Sources"),
    ];
    for (columns, rows) in SIZES {
        let mut person = Person::at(columns, rows).opens(MODES);
        for (key, number, name) in TABS {
            // From the form and from another pane.
            for from in ["<a-1><tab>", "<a-2>"] {
                person.types(from).types(&format!("<a-{key}>"));
                assert_eq!(shown(&person), (name, true), "{from}\n{}", person.sees());
                // Its name is whole; of the others at least the numbers are there.
                let tabs = line_with(&mut person, &format!("{number}{name}"));
                assert!(TABS.iter().all(|(_, number, _)| tabs.contains(*number)), "{tabs}");
            }
        }
    }
    // The fan has no table: its number is left out, and the key reports it.
    let mut person = fan(80, 24);
    person.types("<a-3>");
    assert!(!line_with(&mut person, "³Plot").contains('⁵'), "{}", person.sees());
    assert!(person.types("<a-5>").sees().contains("there is no tab 5 now"), "{}", person.sees());
    assert_eq!(shown(&person), ("Plot", true));
    // In a text the keys are no tabs.
    person.types("<tab><home><enter><a-7>");
    assert_eq!(person.model.place(), KeyContext::Edit, "{}", person.sees());
}

#[test]
fn a_number_that_is_typed_after_turning_to_check_lands_in_its_cell() {
    for (columns, rows) in SIZES {
        for keys in ["]]]]", "[[[[", "<a-6>", "<a-1><a-6>", "<a-7>["] {
            let mut person = fan(columns, rows);
            let inputs = |person: &Person| {
                person.model.bench.as_ref().map(|bench| bench.problem.inputs.form.draft.clone())
            };
            let before = inputs(&person);
            person.types(keys).types("7.5<enter>");
            assert_eq!(shown(&person), ("Check", true), "{keys}");
            assert_eq!(inputs(&person), before, "{keys}");
            assert!(!is_unsaved(&person), "{keys}");
            // Its name may go on in a second row.
            assert!(person.sees().contains("▸ Amplitude"), "{keys}: {}", person.sees());
            assert!(line_with(&mut person, " 7.5 ").contains('✗'), "{keys}: {}", person.sees());
        }
    }
}

/// Values that Check asks for stand nowhere else on the screen until they are found.
#[test]
fn nothing_beside_check_gives_its_answers_away() {
    for (columns, rows) in SIZES {
        let screen = fan(columns, rows).types("<a-6>").sees();
        assert!(!screen.contains("19.456") && !screen.contains("106.23"), "{columns}×{rows}:\n{screen}");
    }
}

#[test]
fn what_is_typed_after_enter_replaces_the_text_of_a_field() {
    for (typed, wanted) in [
        ("50<enter>", "50 kg"),
        ("50 lb<enter>", "50 lb"),
        ("<bs>60<enter>", "60 kg"),
        ("<del><enter>", ""),
        // An arrow, Home and End keep it.
        ("<home>1<enter>", "140 kg"),
        ("<left><bs>t<enter>", "40 tg"),
        ("<end><bs><bs>Mg<enter>", "40 Mg"),
        ("<enter>", "40 kg"),
        ("50<esc>", "40 kg"),
        ("<bs><esc>", "40 kg"),
    ] {
        let mut person = fan(100, 30);
        person.types("<home><enter>").types(typed);
        assert_eq!(input(&person, "mass"), wanted, "{typed}:\n{}", person.sees());
    }
    let mut person = fan(100, 30);
    person.types("<home><enter>").pastes("55 kg").types("<enter>");
    assert_eq!(input(&person, "mass"), "55 kg");
    // What would be replaced is seen as such.
    person.types("<enter>");
    let (column, row) = person.place_of("55 kg");
    let is_reversed =
        |person: &mut Person| person.draws()[(column, row)].modifier.contains(Modifier::REVERSED);
    assert!(is_reversed(&mut person), "{}", person.sees_ink());
    person.types("<end>");
    assert!(!is_reversed(&mut person), "{}", person.sees_ink());
}

#[test]
fn escape_in_a_cell_restores_its_text() {
    let mut person = fan(80, 24);
    person.types("<a-8><down><down>");
    let before = line_with(&mut person, "20..60 kg");
    for typed in ["<enter>30..80 kg", "<enter><bs>", "<enter><end>0", "3"] {
        person.types(typed);
        assert_eq!(person.model.place(), KeyContext::Cell, "{typed}");
        person.types("<esc>");
        assert_eq!(line_with(&mut person, "▸ Mass of the machine"), before, "{typed}");
    }
    // An arrow keeps the old text, a character replaces it.
    person.types("<a-6><home>19.46<enter>");
    assert!(line_with(&mut person, "▸ Amplitude").contains('✓'), "{}", person.sees());
    person.types("<enter>2");
    assert!(line_with(&mut person, "▸ Amplitude").contains('✗'), "{}", person.sees());
    person.types("<esc>");
    let line = line_with(&mut person, "▸ Amplitude");
    assert!(line.contains("19.46") && line.contains('✓'), "{}", person.sees());
    person.types("<enter><home>1<enter>");
    assert!(line_with(&mut person, "▸ Amplitude").contains("119.46"), "{}", person.sees());
    // Escape once more leaves the pane for the form.
    person.types("<esc>");
    assert_eq!(person.model.place(), KeyContext::Form);
}

#[test]
fn the_list_opens_with_the_cursor_in_its_search() {
    let place = |person: &Person| person.model.place().id();
    let mut person = Person::at(100, 30);
    assert!(person.sees().contains("/ type to search"), "{}", person.sees());
    // Letters that are keys elsewhere are text; a `/` that is typed first begins nothing anew.
    person.types("q");
    assert!(!person.has_quit && person.sees().contains("/ q"), "{}", person.sees());
    person.types("<esc>");
    assert_eq!(place(&person), "picker", "escape leaves the line");
    person.types("/rotunb");
    assert!(person.sees().contains("/ rotunb"), "{}", person.sees());
    // Enter opens what is chosen; Esc comes back to the search as it was.
    person.types("<enter>");
    assert!(person.sees().contains("Inputs"), "{}", person.sees());
    person.types("<esc>");
    assert_eq!(place(&person), "filter-line");
    assert!(person.sees().contains("/ rotunb"), "{}", person.sees());
    person.types("<esc>");
    assert_eq!(place(&person), "picker");
    assert!(!person.sees().contains("rotunb"), "{}", person.sees());
    // Arrows move and expand without leaving the line.
    let mut person = Person::at(100, 30);
    let rows = |person: &Person| person.model.picker.rows(person.model.contents()).len();
    let chosen = person.model.picker.chosen;
    person.types("<down><down>");
    assert_eq!((person.model.picker.chosen, place(&person)), (chosen + 2, "filter-line"));
    let folded = rows(&person);
    person.types("<right>");
    assert!(rows(&person) > folded, "{}", person.sees());
    person.types("<left>");
    assert_eq!((rows(&person), place(&person)), (folded, "filter-line"));
    // Single letters are keys once the line is left.
    person.types("<esc>q");
    assert!(person.has_quit);
}

#[test]
fn passed_checks_and_long_lists_are_opened_by_enter() {
    for (columns, rows) in [(80, 24), (120, 50), (200, 60)] {
        let mut person = fan(columns, rows);
        person.types("<tab>");
        let passed = |person: &mut Person| person.sees().matches("verified by a second method").count();
        assert!(person.sees().contains("✓ 4 checks passed (differences ≤ 1×10⁻⁹)"), "{}", person.sees());
        assert_eq!(passed(&mut person), 0);
        person.types("<enter>");
        assert_eq!(passed(&mut person), 4, "{}", person.sees());
        assert!(!person.sees().contains("checks passed"), "{}", person.sees());
        // Where an answer is chosen, Enter is for it.
        person.types("<enter>");
        assert!(person.sees().contains("✓ 4 checks passed"), "{}", person.sees());
        person.types("v<enter>");
        assert_eq!(shown(&person), ("Working", true));
    }
    let mut person = Person::at(120, 60).opens(BEAM);
    let lists = line_with(&mut person, " lists; Enter shows them");
    let folded =
        lists.split("││ ").nth(1).and_then(|rest| rest.split_once(": ")).expect("a name and its lists");
    let (name, count) = (folded.0.to_owned(), folded.1.split(' ').next().map(str::to_owned));
    let count: usize = count.and_then(|count| count.parse().ok()).expect("a number of lists");
    person.types("<tab>e<enter>");
    let screen = person.sees();
    let named = |n: usize| screen.contains(&format!("{name} {n}"));
    assert!(count > 2 && (1..=count).all(named), "{count} times {name}:\n{screen}");
    assert!(!screen.contains("Enter shows them"), "{screen}");
}
