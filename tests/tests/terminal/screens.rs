//! The workbench as a user sees it: keys in, screens out.
// Long because every key and every screen has its test here, and they share their words.

use dalembert_core::registry;
use dalembert_testkit::on_all_cores;
use dalembert_tests::person::Person;
use dalembert_tui::{
    Msg,
    keys::{Action, KeyContext},
    panes::{self, places, working::Working},
    tempo,
};
use insta::assert_snapshot;
use itertools::Itertools as _;
use ratatui::style::Color;

const FAN: &str = "vibration/rotating-unbalance";
const ROTOR: &str = "balancing/two-plane";
/// The lists on these screens are of these analyses, so that another analysis changes no snapshot.
const COURSE: [&str; 8] = [
    "balancing/two-plane",
    "rigid-body/rod-on-shaft",
    "rigid-body/spinning-disc-on-arm",
    "vibration/beam-and-springs",
    "vibration/frequency-response-identification",
    "vibration/rotating-unbalance",
    "vibration/shaft-clearance",
    "virtual-work/virtual-power",
];

fn fan(columns: u16, rows: u16) -> Person {
    Person::at(columns, rows).opens(FAN)
}

/// The line of the screen that holds a text.
#[track_caller]
fn line_with(screen: &str, text: &str) -> String {
    let line = screen.lines().find(|line| line.contains(text));
    line.unwrap_or_else(|| panic!("`{text}` is not on the screen:\n{screen}")).to_owned()
}

/// From a text to the end of its line, without the frame.
#[track_caller]
fn after(screen: &str, text: &str) -> String {
    let line = line_with(screen, text);
    let rest = line.split_once(text).map(|(_, rest)| rest).unwrap_or_default();
    rest.split('│').next().unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_list() {
    assert_snapshot!(Person::at(80, 24).knows(&COURSE).sees());
}

#[test]
fn the_list_filtered() {
    assert_snapshot!(Person::at(80, 24).knows(&COURSE).types("/fan").sees());
}

#[test]
fn the_filter_looks_in_titles_keywords_sources_and_cases() {
    for (filter, title) in [
        ("rotunb", "Rotating unbalance"),
        ("ventilador viga", "Rotating unbalance"),
        ("balancear ventilador", "Field balancing"),
        ("fan balancing", "Field balancing"),
        ("fan on a", "Rotating unbalance"),
        ("vibration/rotating-u", "Rotating unbalance"),
    ] {
        let mut person = Person::at(80, 24);
        person.types("/").types(filter);
        let chosen = line_with(&person.sees(), "▸");
        assert!(chosen.contains(title), "{filter}: {chosen}");
        assert!(person.types("<enter>").sees().contains("Inputs"), "{filter}");
    }
    let none = Person::at(80, 24).types("/zzzzqq").sees();
    assert!(none.contains("no match"), "{none}");
}

#[test]
fn escape_goes_back_one_step_at_a_time_and_never_ends_the_program() {
    let mut person = Person::at(80, 24).knows(&COURSE);
    person.types("/rotunb<enter><end><enter>99");
    assert!(person.sees().contains("Enter keep"), "{}", person.sees());
    person.types("<esc>");
    assert!(person.sees().contains("Inputs"));
    person.types("<esc>");
    assert!(person.sees().contains("analyses 1/"), "the filter is still there:\n{}", person.sees());
    person.types("<esc>");
    assert!(!person.sees().contains("analyses 1/"));
    person.types("<esc><esc><esc>");
    assert!(!person.has_quit);
    assert!(person.types("q").has_quit);
}

#[test]
fn every_tab_of_the_fan() {
    let mut person = fan(80, 24);
    for tab in ["results", "working", "plot", "drawing", "check", "sensitivity", "study", "sources"] {
        assert_snapshot!(format!("fan_{tab}"), person.sees());
        person.types("]");
    }
}

#[test]
fn a_wide_screen_has_three_columns() {
    assert_snapshot!(fan(160, 50).sees());
}

#[test]
fn a_wide_screen_has_room_for_the_names_of_materials() {
    // So many lines of a form stand on the screen at once.
    const FIT: usize = 45;
    let mut seen = 0;
    for entry in registry().iter().filter(|entry| entry.about.cases.contains("young")) {
        let cases = dalembert_core::cases::cases(entry).expect("the cases of an analysis can be read");
        let mut person = Person::at(160, 80).opens(entry.about.id);
        person.types("[");
        for (at, case) in cases.iter().enumerate() {
            person.types(if at == 0 { "<enter><tab>" } else { "<tab><down><enter><tab>" });
            let form = &person.model.bench.as_ref().expect("a problem is open").problem.inputs.form;
            let lines = form.lines();
            let fit = lines.iter().take(FIT);
            let wanted = fit.filter(|line| line.field.label == "Young's modulus").count();
            let screen = person.sees();
            assert!(
                screen.matches("Young's modulus").count() >= wanted && !screen.contains("Young's m…"),
                "{}, {}:\n{screen}",
                entry.about.id,
                case.name
            );
            seen += wanted;
        }
    }
    assert!(seen > 0, "some case has a Young's modulus");
}

#[test]
fn a_small_screen_has_one() {
    let mut person = fan(40, 12);
    assert_snapshot!("small_form", person.sees());
    assert_snapshot!("small_results", person.types("<tab>").sees());
    assert_snapshot!("small_list", Person::at(40, 12).knows(&COURSE).sees());
}

#[test]
fn everything_in_ascii_without_colours() {
    let mut person = Person::in_ascii(80, 24).opens(FAN);
    for tab in ["results", "working", "plot", "drawing", "check", "sensitivity", "study", "sources"] {
        let screen = person.sees();
        assert!(screen.is_ascii(), "{screen}");
        assert!(person.draws().content.iter().all(|cell| cell.fg == Color::Reset && cell.bg == Color::Reset));
        if tab == "plot" || tab == "results" {
            assert_snapshot!(format!("ascii_{tab}"), screen);
        }
        person.types("]");
    }
}

#[test]
fn portuguese_with_the_decimal_comma() {
    let mut person = Person::in_portuguese(80, 24).opens(FAN);
    assert_snapshot!("portuguese_results", person.sees());
    assert_snapshot!("portuguese_working", person.types("]").sees());
    assert_snapshot!("portuguese_list", Person::in_portuguese(80, 24).knows(&COURSE).sees());
}

#[test]
fn the_language_changes_at_once() {
    let mut person = fan(110, 30);
    assert!(after(&person.sees(), "Natural frequency").contains("106.23"));
    person.types("L");
    let screen = person.sees();
    assert!(screen.contains("Dados de entrada") && screen.contains("106,23"), "{screen}");
    assert!(person.types("L").sees().contains("106.23"));
}

#[test]
fn a_key_changes_amplitude_working_and_plot_at_once() {
    let mut person = fan(110, 30);
    assert_eq!(after(&person.sees(), "Amplitude at this speed"), "X 19.456 mm");
    person.types("<end><del>1500 rpm");
    // X = (m₀e/m) r²/√((1 − r²)² + (2ζr)²), with the damping that a largest amplitude of 20.3 mm fixes.
    let (natural, ratio) = ((3.0 * 200e9 * 1.3e-6 / 1.2_f64.powi(3) / 40.0).sqrt(), 40.0 * 0.0203 / 0.1);
    let zeta = (0.5 - 0.5 * (1.0 - 1.0_f64 / (ratio * ratio)).sqrt()).sqrt();
    let r = 1500.0 * std::f64::consts::PI / 30.0 / natural;
    let amplitude = 0.1 / 40.0 * r * r / (1.0 - r * r).hypot(2.0 * zeta * r);
    let wanted = format!("X {:.4} mm", amplitude * 1e3);
    let screen = person.sees();
    assert!(screen.contains("Enter keep"), "still typing:\n{screen}");
    assert_eq!(after(&screen, "Amplitude at this speed"), wanted);
    assert!(!person.sees_dim("Amplitude at this speed"));
    person.types("<enter>]<end>");
    assert_eq!(after(&person.sees(), "Amplitude at this speed"), wanted);
    person.types("]<right>");
    assert!(person.sees().contains("1500 rpm"), "{}", person.sees());
}

#[test]
fn results_follow_every_key() {
    let mut person = fan(110, 30);
    person.types("<end><del>");
    let mut seen = Vec::new();
    for key in ["1", "5", "0", "0", " ", "r", "p", "m"] {
        person.types(key);
        seen.push(person.sees_dim("Amplitude at this speed"));
    }
    // `1500 r` and `1500 rp` cannot be read; everything else can, and is solved.
    assert_eq!(seen, [false, false, false, false, false, true, true, false]);
}

/// 24 frames are one swing.
#[test]
fn an_animation_moves_until_it_is_held() {
    let mut person = Person::at(160, 50).opens("vibration/large-pendulum");
    assert!(tempo(&person.model).is_none(), "it begins held at the position of the problem");
    let first = person.types("p").sees();
    assert!(tempo(&person.model).is_some());
    person.happens(Msg::Tick);
    assert_ne!(person.sees(), first);
    for _ in 1..24 {
        person.happens(Msg::Tick);
    }
    assert_eq!(person.sees(), first);
    person.types("p");
    assert!(tempo(&person.model).is_none());
    person.types("p?");
    assert!(tempo(&person.model).is_none(), "what lies over an animation holds it");
    person.types("<esc>");
    assert!(tempo(&person.model).is_some());
    // On a narrow screen it moves while its tab is shown.
    let mut narrow = Person::at(80, 24).opens("vibration/large-pendulum");
    assert!(tempo(&narrow.model).is_none());
    narrow.types("]]]p");
    assert!(tempo(&narrow.model).is_some(), "{}", narrow.sees());
    narrow.types("[");
    assert!(tempo(&narrow.model).is_none(), "{}", narrow.sees());
}

#[test]
fn an_animation_is_stepped_frame_by_frame() {
    let mut person = Person::at(80, 24).opens("vibration/large-pendulum");
    assert!(!person.sees().contains("animation"), "{}", person.sees());
    assert!(person.types("p").sees().contains("no animation on the screen"));
    person.types("]]]");
    assert!(person.sees().contains("Space animation"), "{}", person.sees());
    let screen = Person::at(96, 24).opens("vibration/large-pendulum").types("]]]").sees();
    assert!(screen.contains("Space animation") && screen.contains(", . frame"), "{screen}");
    let first = person.sees();
    assert_snapshot!("animation_held", person.types("...").sees());
    assert!(tempo(&person.model).is_none(), "a step holds it");
    assert!(line_with(&person.sees(), "/24").contains(" 4/24"), "{}", person.sees());
    // Backwards over the beginning it goes on from the end; a whole round ends where it began.
    person.types(",,,,");
    assert!(person.sees().contains("24/24"), "{}", person.sees());
    assert_eq!(person.types(".").sees(), first);
    person.types(" ");
    assert!(tempo(&person.model).is_some());
}

#[test]
fn an_animation_in_ascii_and_in_portuguese_on_a_wide_screen() {
    let mut ascii = Person::in_ascii(80, 24).opens("vibration/large-pendulum");
    let screen = ascii.types("]]].").sees();
    assert!(screen.is_ascii());
    assert_snapshot!("animation_ascii", screen);
    let mut wide = Person::in_portuguese(160, 50).opens("vibration/large-pendulum");
    let screen = wide.types("<tab>").types(".").sees();
    assert!(screen.contains(" 2/24"), "{screen}");
    assert!(wide.types("<tab>").sees().contains("p animação"), "{}", wide.sees());
}

#[test]
fn a_pane_takes_the_whole_screen_and_returns_it() {
    for (columns, rows) in [(80, 24), (160, 50)] {
        let mut person = fan(columns, rows);
        let together = person.sees();
        person.types("e");
        assert!(!person.sees().contains("Results"), "{}", person.sees());
        assert_eq!(person.types("e").sees(), together);
        let tabs = ["Results", "Working", "Plot", "Drawing", "Sources"];
        for (tab, keys) in tabs.into_iter().zip_eq(["<tab>e", "]", "]", "]", "<a-9>"]) {
            person.types(keys);
            let screen = person.sees();
            assert!(screen.contains(tab) && !screen.contains("Inputs"), "{tab}:\n{screen}");
        }
        // Escape brings the others back: on a narrow screen the strip of results, on a wide one the form.
        let other = if columns < 100 { "╭─ Results " } else { "╭─ Inputs " };
        let screen = person.types("<esc>").sees();
        assert!(screen.contains(other), "{other}:\n{screen}");
    }
    assert_snapshot!("expanded_working", fan(160, 50).types("]e").sees());
    assert_snapshot!("expanded_plot", fan(80, 24).types("]]e").sees());
}

#[test]
fn what_cannot_be_read_is_said_and_old_results_are_not_passed_off() {
    let mut person = fan(80, 24);
    person.types("<end><del>fast<enter>");
    let screen = person.sees();
    assert_snapshot!("error", screen);
    assert!(person.sees_dim("Amplitude at this speed"));
    assert!(screen.contains("results for the previous, complete"), "{screen}");
    let red = person.draws().content.iter().filter(|cell| cell.fg == Color::Red).count();
    assert!(red > 10, "{red} red cells");
    // Nothing stale is copied.
    assert!(person.types("y").clipboard.is_empty());
    person.types("z");
    assert!(!person.sees_dim("Amplitude at this speed"));
}

#[test]
fn every_kind_of_wrong_text_names_field_value_and_repair() {
    for (typed, said) in [
        ("abc", "abc"),
        ("3 kg", "is a mass"),
        ("1.000,5 rpm", "1.000,5"),
        ("-5 rpm", "above zero"),
        ("1e400 rpm", "1e400"),
        ("nan", "nan"),
    ] {
        let mut person = fan(100, 40);
        person.types("<end><del>").types(typed).types("<enter>");
        let screen = person.sees();
        assert!(screen.contains("Speed of the machine: "), "{typed}:\n{screen}");
        assert!(screen.contains(said), "{typed} does not say {said}:\n{screen}");
        assert!(person.sees_dim("Amplitude at this speed"), "{typed}");
    }
}

#[test]
fn an_empty_input_is_needed_and_not_wrong() {
    // No drawing is beside it, which has red of its own.
    let mut person = fan(90, 24);
    let red =
        |person: &mut Person| person.draws().content.iter().filter(|cell| cell.fg == Color::Red).count();
    let before = red(&mut person);
    person.types("<end><del><enter>");
    let screen = person.sees();
    assert_eq!(screen.matches("1 value missing").count(), 2, "inputs and results say it:\n{screen}");
    assert!(after(&screen, "▸ Speed").contains("needed"), "{screen}");
    assert!(person.sees_dim("Amplitude at this speed"));
    assert_eq!(red(&mut person), before, "{screen}");
    // What is wrong comes before what is missing, on every tab.
    person.types("<home><del>heavy<enter>");
    assert!(person.sees().contains("1 error"), "{}", person.sees());
}

#[test]
fn a_row_that_is_added_waits_at_its_first_field() {
    let mut person = Person::at(80, 40).opens(ROTOR);
    let form = &mut person.model.bench.as_mut().expect("a problem is open").problem.inputs.form;
    let row = form.lines().iter().find_map(|line| line.number.map(|_| line.path.clone()));
    form.go_to(&row.expect("it has rows"));
    person.types("a");
    let form = &person.model.bench.as_ref().expect("a problem is open").problem.inputs.form;
    let at = form.line().expect("the cursor is on a line");
    assert!(matches!(at.role, dalembert_tui::form::Role::Leaf { .. }), "{at:?}");
    assert!(at.path.contains("[2]."), "{}", at.path);
    let needed = person.model.bench.as_ref().expect("a problem is open").problem.needed().count();
    let screen = person.sees();
    assert!(needed > 1 && screen.contains(&format!("{needed} values missing")), "{screen}");
    assert!(!screen.contains(" errors") && !screen.contains("✗"), "{screen}");
    assert_eq!(screen.matches(" needed").count(), needed, "{screen}");
}

#[test]
fn a_digit_on_a_field_with_a_list_says_what_opens_it() {
    let mut person = fan(80, 24);
    person.types("<down><down>4");
    assert!(person.sees().contains("Enter opens the options"), "{}", person.sees());
    assert!(person.types("<esc>").model.bench.as_ref().is_some_and(|bench| !bench.problem.is_unsaved()));
}

#[test]
fn a_refusal_is_in_words() {
    let mut person = fan(80, 24);
    // The largest amplitude below m₀e/m: no damping gives it.
    person.types("<end><up><del>1 mm<enter>");
    assert_snapshot!(person.sees());
}

#[test]
fn pastes_are_one_clean_line_of_limited_length() {
    let mut person = fan(80, 24);
    person.types("<end>").pastes("1500\u{1b}[31m\u{202e} r\u{0}pm\n");
    let screen = person.sees();
    assert!(!screen.contains('\u{1b}') && screen.contains("1500[31m rpm"), "{screen}");
    person.types("<enter>").pastes("<enter>quit");
    assert!(!person.has_quit, "a paste is no command");
    let mut person = fan(80, 24);
    person.types("<end><del>").pastes(&"9".repeat(10_000_000));
    let screen = person.sees();
    assert!(screen.contains("truncated"), "{screen}");
    person.types("<esc>");
    assert!(!person.sees_dim("Amplitude at this speed"));
}

#[test]
fn changes_are_taken_back_and_made_again() {
    let mut person = fan(80, 24);
    person.types("<end><del>1500 rpm<enter><home><del>50 kg<enter>");
    let both = person.sees();
    assert!(both.contains("50 kg") && both.contains("1500 rpm"));
    person.types("z");
    assert!(person.sees().contains("40 kg") && person.sees().contains("1500 rpm"));
    person.types("z");
    assert!(person.sees().contains("1000 rpm"));
    person.types("ZZ");
    let again = person.sees();
    assert!(again.contains("50 kg") && again.contains("1500 rpm"), "{again}");
    // Nudges of one field are one change.
    person.types("<end>+++z");
    assert!(person.sees().contains("1500 rpm"), "{}", person.sees());
}

#[test]
fn the_last_digit_is_nudged() {
    let mut person = fan(110, 30);
    for (keys, value) in [
        ("+", "1001 rpm"),
        ("-", "1000 rpm"),
        ("<s-up>", "1010 rpm"),
        ("<s-down>", "1000 rpm"),
        ("<a-up>", "1000.1 rpm"),
    ] {
        person.types("<end>").types(keys);
        assert_eq!(
            after(&person.sees(), "▸ Speed of the machine")
                .split_once(' ')
                .map(|(_, shown)| shown.split(" = ").next()),
            Some(Some(value))
        );
    }
}

#[test]
fn a_digit_is_chosen_to_be_nudged() {
    let mut person = fan(80, 24);
    person.types("<end><left><left>+");
    assert!(person.sees().contains("1100 rpm"), "{}", person.sees());
    person.types("<right>-");
    assert!(person.sees().contains("1090 rpm"), "{}", person.sees());
    // No further than the first digit, nor than the last; each field has its own.
    person.types("<left><left><left><left><left>+");
    assert!(person.sees().contains("2090 rpm"), "{}", person.sees());
    person.types("<right><right><right><right><right>+<up><down>+");
    assert!(person.sees().contains("2092 rpm"), "{}", person.sees());
}

#[test]
fn units_are_cycled_without_changing_the_quantity() {
    let mut person = fan(110, 30);
    person.types("<end>");
    let before = after(&person.sees(), "Amplitude at this speed");
    for unit in ["Hz", "rev/s", "deg/s", "rad/s", "rpm"] {
        person.types("u");
        let screen = person.sees();
        assert!(line_with(&screen, "▸ Speed").contains(unit), "{unit}:\n{screen}");
        assert_eq!(after(&screen, "Amplitude at this speed"), before, "{unit}");
    }
    assert!(line_with(&person.sees(), "▸ Speed").contains("1000 rpm"), "{}", person.sees());
}

#[test]
fn a_converted_number_is_written_and_nudged_as_a_user_would() {
    let mut person = Person::in_portuguese(110, 30).opens(FAN);
    person.types("<end>uuuu");
    assert!(line_with(&person.sees(), "▸ Rotação").contains("104,719755 rad/s"), "{}", person.sees());
    person.types("+");
    assert!(line_with(&person.sees(), "▸ Rotação").contains("104,819755 rad/s"), "{}", person.sees());
}

#[test]
fn an_alternative_is_chosen_and_keeps_what_is_common() {
    let mut person = fan(80, 24);
    person.types("<down><down><enter>");
    assert_snapshot!("choice", person.sees());
    person.types("<down><enter>");
    let screen = person.sees();
    assert!(
        screen.contains("Simply supported")
            && screen.contains("1.3e-6 m^4")
            && screen.contains("200 kN/mm^2"),
        "{screen}"
    );
    // Past an alternative without these fields, and back.
    person.types("<left><left><right>");
    assert!(person.sees().contains("200 kN/mm^2"), "{}", person.sees());
}

#[test]
fn rows_are_added_duplicated_moved_and_deleted() {
    let mut person = Person::at(80, 40).opens(ROTOR);
    let rows = |person: &mut Person| {
        let draft = person.model.bench.as_ref().expect("a problem is open").problem.inputs.form.draft.clone();
        let dalembert_core::Draft::Group(fields) = draft else { panic!("a problem is a group") };
        fields
            .into_iter()
            .find_map(|field| if let dalembert_core::Draft::Rows(rows) = field { Some(rows) } else { None })
            .expect("it has rows")
    };
    let before = rows(&mut person);
    let path = person
        .model
        .bench
        .as_ref()
        .unwrap()
        .problem
        .inputs
        .form
        .lines()
        .iter()
        .find_map(|line| line.number.map(|_| line.path.clone()))
        .unwrap();
    person.model.bench.as_mut().unwrap().problem.inputs.form.go_to(&path);
    assert_snapshot!("rows", person.sees());
    person.types("d");
    assert_eq!(rows(&mut person)[1], before[0]);
    assert_eq!(rows(&mut person).len(), before.len() + 1);
    person.types("J");
    assert_eq!(rows(&mut person)[1], before[1]);
    assert_eq!(rows(&mut person)[2], before[0]);
    person.types("K");
    assert_eq!(rows(&mut person)[1], before[0]);
    person.types("x");
    assert_eq!(rows(&mut person), before);
    person.types("a");
    assert_eq!(rows(&mut person).len(), before.len() + 1);
    person.types("zzzzz");
    assert_eq!(rows(&mut person), before);
}

#[test]
fn every_analysis_opens_with_its_first_case_solved() {
    on_all_cores(registry(), |_, entry| {
        let id = entry.about.id;
        for (columns, rows) in [(80, 24), (160, 50)] {
            let mut person = Person::at(columns, rows).opens(id);
            let bench = person.model.bench.as_ref().expect("a problem is open");
            assert_eq!(bench.problem.wrong().chain(bench.problem.needed()).next(), None, "{id}");
            assert_eq!(bench.problem.found.failure, None, "{id}");
            assert!(
                bench.problem.found.solution.as_ref().is_some_and(|solution| !solution.answers.is_empty()),
                "{id}"
            );
            for _ in 0..6 {
                let screen = person.types("]").sees();
                assert!(!screen.contains("nothing to show"), "{id}:\n{screen}");
            }
        }
    });
}

#[test]
fn no_text_is_cut_without_a_mark() {
    for entry in registry() {
        let mut person = Person::at(80, 24).opens(entry.about.id);
        for _ in 0..6 {
            let screen = person.types("]").sees();
            for line in screen.lines().skip(1).take(20) {
                // The frames are whole: nothing was drawn over them.
                let last = line.chars().last();
                assert!(matches!(last, Some('│' | '╮' | '╯')), "{}: {line}", entry.about.id);
            }
        }
    }
}

#[test]
fn cases_are_loaded_from_the_sources() {
    let mut person = fan(80, 24);
    person.types("<end><del>1500 rpm<enter>[<enter>");
    assert!(person.sees().contains("loaded;"), "{}", person.sees());
    assert!(person.types("<tab>").sees().contains("1000 rpm"), "{}", person.sees());
    assert!(person.types("z").sees().contains("1500 rpm"), "{}", person.sees());
}

#[test]
fn the_plot_has_a_cursor_that_reads_values() {
    let mut person = fan(80, 24);
    person.types("]]");
    let without = person.sees();
    person.types("<right>");
    assert_ne!(person.sees(), without);
    assert!(person.sees().contains("rpm") && person.sees().contains("mm"));
    person.types("<esc>");
    assert_eq!(person.sees(), without);
    assert_snapshot!(person.types("m<left>").sees());
}

#[test]
fn a_plot_is_zoomed_and_panned() {
    let mut person = fan(80, 24);
    let whole = person.types("]]").sees();
    assert!(!whole.contains("< > move"), "{whole}");
    assert!(person.types(">").sees().contains("full range is shown"));
    let near = person.types("++").sees();
    assert_ne!(near, whole);
    assert!(near.contains("< > move") && near.contains("0 shows the full range"), "{near}");
    assert_snapshot!("zoomed_plot", near);
    let right = person.types(">").sees();
    assert_ne!(right, near);
    assert_eq!(person.types("<lt>").sees(), near);
    // To the end of the axis and no further.
    assert!(person.types(&">".repeat(30)).sees().contains("end of the range"), "{}", person.sees());
    assert!(person.types(&"<lt>".repeat(30)).sees().contains("start of the range"));
    person.types("0");
    assert_eq!(person.sees(), whole);
    person.types("0");
    assert!(person.sees().contains("full range is shown"));
    // The cursor stays where it is on the screen, and what is shown follows it.
    let column = |screen: &str| line_with(screen, "┬").chars().position(|c| c == '●');
    let before = person.types("<right>").sees();
    let after = person.types("+").sees();
    assert_eq!(line_with(&before, "speed ="), line_with(&after, "speed ="));
    assert_eq!(column(&before), column(&after));
    assert_snapshot!("zoomed_plot_at_its_beginning", person.types("+<home>").sees());
}

#[test]
fn the_values_of_a_plot_are_spread_as_they_allow() {
    let mut person = fan(160, 50);
    let linear = person.types("]]").sees();
    let logarithmic = person.types("a").sees();
    assert_ne!(logarithmic, linear);
    let decibels = person.types("a<right>").sees();
    assert!(decibels.contains("[dB over 1 mm]") && decibels.contains(" dB"), "{decibels}");
    assert_snapshot!("plot_in_decibels", decibels);
    assert_eq!(person.types("<esc>a").sees(), linear);
    // What goes below zero has no logarithm, and that is said.
    let mut swing = Person::in_portuguese(80, 24).opens("vibration/free-vibration");
    let before = swing.types("]]").sees();
    assert!(swing.types("a").sees().contains("valores negativos não têm logaritmo"), "{}", swing.sees());
    swing.types("<esc><tab>");
    assert_eq!(swing.sees(), before);
    assert_snapshot!("ascii_plot_in_decibels", Person::in_ascii(80, 24).opens(FAN).types("]]aa+").sees());
}

#[test]
fn a_pinned_result_is_compared_with() {
    let mut person = fan(80, 24);
    let before = person.types("<end>").sees();
    let same = person.types("c<end>").sees();
    assert!(same.contains("pinned") && !same.contains("%)"), "{same}");
    person.types("<end><del>1100 rpm<enter>");
    let screen = person.sees();
    assert_snapshot!("compared_results", screen);
    assert!(line_with(&screen, "Amplitude").contains("mm"), "{screen}");
    assert!(screen.contains(" %)"), "{screen}");
    let plot = person.types("]]").sees();
    assert!(plot.contains("┄○ before"), "{plot}");
    person.types("c[[<tab>z");
    assert_eq!(person.sees(), before, "unpinned, nothing is compared");
    // What cannot be read has no result to pin.
    person.types("<end><del>x<enter>c");
    assert!(person.sees().contains("no result to pin"), "{}", person.sees());
}

#[test]
fn a_pinned_result_on_a_wide_screen_and_in_ascii() {
    let mut wide = Person::in_portuguese(160, 50).opens(FAN);
    assert_snapshot!("compared_wide", wide.types("c<end><del>1100 rpm<enter>").sees());
    let mut ascii = Person::in_ascii(80, 24).opens(FAN);
    let screen = ascii.types("c<end><del>1100 rpm<enter>]]").sees();
    assert!(screen.is_ascii());
    assert_snapshot!("compared_ascii", screen);
}

#[test]
fn the_working_is_revealed_step_by_step() {
    let mut person = fan(80, 24);
    let shown = person.sees();
    let steps = person.model.bench.as_ref().unwrap().problem.found.solution.as_ref().unwrap().steps.len();
    person.types("t");
    assert!(person.sees().contains("Space in Working"), "{}", person.sees());
    person.types("<home>");
    assert_snapshot!("covered_results", person.sees());
    person.types("]");
    assert_snapshot!("covered_working", person.types("  ").sees());
    assert!(person.types("]").sees().contains("hidden until every step"), "{}", person.sees());
    person.types("y");
    assert_eq!(person.clipboard, "", "what is covered is not copied");
    person.types("[").types(&" ".repeat(steps - 2));
    assert!(person.sees().contains("every step is revealed"), "{}", person.sees());
    person.types("[<tab><home>");
    assert_eq!(person.sees(), shown.clone());
    person.types("tt<home>");
    assert_eq!(person.sees(), shown, "the same key uncovers everything");
    let mut wide = Person::in_portuguese(160, 50).opens(FAN);
    assert_snapshot!("covered_wide", wide.types("t]   <left>").sees());
}

#[test]
fn a_covered_problem_keeps_its_sketch_and_gives_nothing_away() {
    // The body and its angular velocity are given, the angular momentum is to be found.
    let mut person = Person::at(120, 40).opens("rigid-body/momentum");
    let open = person.types("<tab>]]e").sees();
    assert!(["ω", "H_G"].iter().all(|name| open.contains(name)), "{open}");
    let covered = person.types("t").sees();
    assert!(covered.contains('ω') && !covered.contains("H_G"), "{covered}");
    let sources = person.types("[[[").sees();
    assert!(sources.contains("published values hidden") && !sources.contains("agreed"), "{sources}");
    let sources = person.types("t").sees();
    assert!(!sources.contains("published values hidden") && sources.contains("agreed"), "{sources}");
}

#[test]
fn a_symbol_leads_to_the_step_that_made_it_and_back() {
    let mut person = fan(80, 24);
    let place = |person: &Person| person.model.bench.as_ref()?.find::<Working>()?.symbol();
    person.types("]");
    let whole = person.types("<right>").sees();
    assert!(whole.contains("depends on"), "{whole}");
    assert_snapshot!("symbols", whole);
    // On to a symbol that some step has made, and along it.
    let from = (0..100)
        .find_map(|_| {
            let line = line_with(&person.sees(), "depends on");
            let here = place(&person)?;
            person.types("<enter>");
            if person.model.place() == KeyContext::Form {
                person.types("<tab><right>");
                return None;
            }
            Some((here, line))
        })
        .expect("some step is made of another");
    let to = place(&person).unwrap();
    assert!(to.0 < from.0.0, "{from:?} {to:?}");
    assert!(from.1.contains(&format!("({})", to.0 + 1)), "{from:?} {to:?}");
    person.types("<esc>");
    assert_eq!(place(&person), Some(from.0), "escape comes back");
    person.types("<esc>");
    assert_eq!(place(&person), None);
    // A symbol that is an input leads to its field.
    let mut person = fan(80, 24);
    person.types("]<right><enter>");
    assert_eq!(person.model.place(), KeyContext::Form);
    person.types("<esc>");
    assert_eq!((person.model.place().id(), place(&person).is_some()), ("working", true), "escape comes back");
}

#[test]
fn the_palette_knows_every_action_by_its_name() {
    let mut person = fan(80, 24);
    assert_snapshot!("palette", person.types(":undo").sees());
    person.types("<esc><end><del>7 rpm<enter>:undo<enter>");
    assert!(person.sees().contains("1000 rpm"));
    person.types(":em portugu<enter>");
    assert!(person.sees().contains("Dados de entrada"), "{}", person.sees());
    person.types(":quit<enter>");
    assert!(person.has_quit);
    let nothing = fan(80, 24).types(":zzqqxx<enter>").sees();
    assert!(nothing.contains("unknown command `zzqqxx`"), "{nothing}");
}

#[test]
fn the_help_is_the_table_of_keys() {
    assert_snapshot!("help", fan(80, 24).types("?").sees());
    let mut person = fan(80, 200);
    // Long lines go on in the next.
    let help = person.types("<f1>").sees().replace('│', " ");
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    for place in places().into_iter().filter(|place| place.is_pane() || *place == KeyContext::Form) {
        // The tabs by their numbers are one line.
        for binding in place.bindings().filter(|binding| !matches!(binding.action, Action::Tab(2..))) {
            assert!(help.contains(binding.name), "{}:\n{help}", binding.name);
        }
    }
    // A section is found by its name.
    let found = fan(80, 24).types("?sens").sees();
    assert!(found.contains("Check, sensitivity"), "{found}");
    assert!(person.types("<esc>").sees().contains("Inputs"));
}

#[test]
fn quitting_with_unsaved_changes_asks() {
    let mut person = fan(80, 24);
    person.types("<end>+q");
    assert_snapshot!(person.sees());
    assert!(!person.has_quit);
    person.types("<esc>");
    assert!(person.sees().contains("1001 rpm") && person.sees().contains("●"));
    assert!(person.kept.values().any(|text| text.contains("1001 rpm")), "{:?}", person.kept);
    person.types("q<down><enter>");
    assert!(person.has_quit && person.kept.is_empty());
}

#[test]
fn tables_are_edited_and_pasted() {
    let mut person = Person::at(100, 30).opens("vibration/frequency-response-identification");
    // The case with a table of points.
    person.types("[");
    let at = person
        .model
        .bench
        .as_ref()
        .unwrap()
        .problem
        .cases
        .iter()
        .position(|judged| judged.case.name.contains("table of points"));
    for _ in 0..at.expect("there is a case with a table") {
        person.types("<down>");
    }
    person.types("<enter>[[[[<tab>");
    let form = &mut person.model.bench.as_mut().unwrap().problem.inputs.form;
    let table = form.lines().iter().find_map(|line| {
        matches!(line.role, dalembert_tui::form::Role::Table { .. }).then(|| line.path.clone())
    });
    form.go_to(&table.expect("the case has a table"));
    let rows = |person: &mut Person| -> usize {
        let screen = person.sees();
        line_with(&screen, " rows")
            .split_whitespace()
            .rev()
            .skip_while(|word| *word != "rows")
            .nth(1)
            .unwrap()
            .parse()
            .unwrap()
    };
    let before = rows(&mut person);
    person.types("<enter>");
    assert!(person.sees().contains("accept and close"), "{}", person.sees());
    person.types("<down># a remark<enter>30; 0.1<enter><esc>");
    assert_eq!(rows(&mut person), before + 1);
    person.types("z");
    assert_eq!(rows(&mut person), before);
    person.pastes("1; 2\n3");
    assert_eq!(rows(&mut person), 2);
    assert!(person.sees().contains("line 2"), "the line of the fault is named:\n{}", person.sees());
}

/// Dataset 58b: complex accelerances over even frequencies, big ends first.
fn universal_file() -> Vec<u8> {
    let axis = |kind: u32, unit: &str| format!("{kind:10}    0    0    0 NONE                 {unit:<20}\n");
    let mut file = format!(
        "    -1\n    58b     2     2          11          64     0     0           0           0\nPoint 1\nNONE\nNONE\n\
         NONE\nNONE\n    4         0    0         0       NONE         1   3       NONE         1   3\n{:10}{:10}{:10}  \
         1.00000E+01  2.00000E+00  0.00000E+00\n",
        6, 4, 1,
    )
    .into_bytes();
    for axis in [axis(18, "Hz"), axis(12, "m/s^2"), axis(13, "N"), axis(0, "NONE")] {
        file.extend(axis.bytes());
    }
    for part in [0.5f64, 0.1, 1.5, 2.5, -2.0, 1.5, -0.5, 0.2] {
        file.extend(part.to_be_bytes());
    }
    file.extend(b"    -1\n");
    file
}

#[test]
fn a_table_is_read_from_the_file_it_names() {
    let folder = tempfile::tempdir().unwrap();
    let (good, bad) = (folder.path().join("point.uff"), folder.path().join("point.txt"));
    std::fs::write(&good, universal_file()).unwrap();
    std::fs::write(&bad, "no table\n").unwrap();
    let mut person = Person::at(100, 30).opens("vibration/frequency-response-identification");
    let path = "measurement.complex.response.accelerance-parts.points";
    let bench = person.model.bench.as_mut().unwrap();
    let cases = dalembert_core::cases::cases(bench.problem.entry()).unwrap();
    let case = cases.into_iter().find(|case| case.name.contains("accelerance")).unwrap();
    let entry = bench.problem.entry();
    bench.problem.inputs.form.replace(entry, case.draft);
    bench.problem.inputs.form.go_to(path);
    let text = |person: &Person| {
        let bench = person.model.bench.as_ref().unwrap();
        match bench.problem.inputs.form.draft.at(&bench.problem.entry().shape(), path) {
            Ok((dalembert_core::Draft::Leaf(text), _)) => text.clone(),
            other => panic!("{other:?}"),
        }
    };
    let before = text(&person);
    person.pastes(&format!("@{}", good.display()));
    assert_eq!(text(&person), before, "a file is shown before it is taken");
    assert!(person.sees().contains("4 rows"), "{}", person.sees());
    person.types("<enter>");
    let read = text(&person);
    assert!(
        read.contains("[Hz]; [(m/s^2)/N]; [(m/s^2)/N]\n10; 0.5; 0.1\n12; 1.5; 2.5\n14; -2; 1.5"),
        "{read}"
    );
    // A file that is not there leaves the table as it is, and reports it.
    person.pastes(&format!("@{}", folder.path().join("nothing.uff").display()));
    assert_eq!(text(&person), read);
    assert!(person.sees().contains("not found: check"), "{}", person.sees());
    person.pastes(&format!("@{}", bad.display()));
    assert!(person.sees().contains("no row of numbers"), "{}", person.sees());
    assert_eq!(text(&person), read);
}

#[test]
fn every_word_of_the_interface_is_translated() {
    use dalembert_core::text::is_translated;
    let of_places = places().into_iter().flat_map(|place| {
        let names = place.bindings().flat_map(|binding| [binding.name, binding.hint]);
        names.chain([place.name()]).collect::<Vec<_>>()
    });
    let missing: Vec<&str> = of_places
        .chain(panes::all().iter().map(|pane| pane.name()))
        .filter(|word| !word.is_empty() && !is_translated(word))
        .collect();
    assert_eq!(missing, [""; 0]);
}

#[test]
fn every_size_can_be_drawn_on_every_screen() {
    // Every size up to 24 × 60, and beyond it in steps that share no factor.
    draw_sizes(|rows, columns| (rows <= 24 && columns <= 60) || (rows % 7 == 0 && columns % 13 == 0));
}

#[test]
#[ignore = "takes minutes: every size up to 60 × 160 on every screen"]
fn really_every_size_can_be_drawn() {
    draw_sizes(|_, _| true);
}

fn draw_sizes(drawn: fn(u16, u16) -> bool) {
    let screens: [(Option<&str>, &[&str]); 4] = [
        (None, &["", "/fan", "?", ":", "o", "<tab>"]),
        (
            Some(FAN),
            &[
                "",
                "]",
                "]]",
                "[",
                "<tab>]]<right>",
                "<end><del>x<enter>",
                "s",
                "<down><down><enter>",
                "<end>+q",
                "?",
                ":",
            ],
        ),
        (Some(ROTOR), &["", "]"]),
        (Some("vibration/shaft-clearance"), &["]]"]),
    ];
    for (id, openings) in screens {
        for keys in openings {
            let mut person = Person::at(80, 24);
            if let Some(id) = id {
                person = person.opens(id);
            }
            person.types(keys);
            for rows in 1..=60 {
                for columns in (1..=160).filter(|columns| drawn(rows, *columns)) {
                    person.resizes(columns, rows);
                    person.draws();
                }
            }
        }
    }
}

#[test]
fn in_ascii_keys_and_greek_letters_are_called_by_their_names() {
    let mut person = Person::in_ascii(80, 24).opens("vibration/rotating-unbalance");
    assert!(person.sees().contains(" omega "), "{}", person.sees());
    let seen = person.turns_to("Plot").sees();
    assert!(seen.contains("Left Right move the cursor"), "{seen}");
    person.turns_to("Working");
    let mut seen = person.sees();
    for _ in 0..8 {
        seen += &person.types("<pgdn>").sees();
    }
    assert!(seen.contains("omega_n") && seen.contains("zeta"), "{seen}");
}

#[test]
fn in_portuguese_printed_numbers_have_the_comma_of_ours() {
    let mut person = Person::in_portuguese(140, 40).opens("vibration/rotating-unbalance");
    person.turns_to("Sources");
    let seen = person.sees();
    assert!(seen.contains("Casos publicados"), "{seen}");
    assert!(seen.matches("106,23 rad/s").count() >= 2 && !seen.contains("106.23"), "{seen}");
}
