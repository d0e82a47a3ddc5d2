//! Field mode before a user: begun from the list, in both languages, on screens of any size.

use std::fs;

use dalembert_core::{Draft, Language, Locale, Text};
use dalembert_tests::person::Person;
use dalembert_tui::field::{FieldPage, LineKind, lines, pages, title};

/// A job of two planes up to the correction, as it is typed from a blank one.
const TO_CORRECTION: &[&str] = &[
    "fan<enter>21",
    "1480<enter>180<enter>400<enter>1<enter><enter><esc>",
    "1112<enter>",
    "7.57@244<enter>2.95@185<enter><enter>",
    "25@0<enter>5.17@261<enter>2.41@170<enter><enter>",
    "25@90<enter>7.71@252<enter>2.47@239<enter><enter>",
];
/// The same to a trim, and to the report.
const TO_REPORT: &[&str] =
    &["<enter>", "1.87@179<enter>1.46@184<enter><enter>", "<enter>", "0.2@1<enter>0.3@2<enter><enter>"];

fn begun(mut person: Person) -> Person {
    person.types("<esc>:field balancing<enter>");
    person
}

fn page(person: &Person) -> FieldPage {
    person.model.shown_bench().and_then(|bench| bench.field.as_ref()).expect("field mode").page
}

#[test]
fn the_list_begins_a_job() {
    let mut person = Person::at(80, 24);
    person.types("<esc><home><down>");
    let screen = person.sees();
    assert!(screen.contains("Field balancing, step by step"), "{screen}");
    assert!(person.sees().contains("ask for one thing at a time"));
    person.types("<enter>");
    assert!(person.sees().contains("The job"), "{}", person.sees());
    person.types("<esc>");
    assert!(person.sees().contains("List of analyses"), "{}", person.sees());
}

#[test]
fn a_job_goes_through_its_pages_in_order() {
    let mut person = begun(Person::at(80, 24));
    let mut seen = vec![page(&person)];
    for keys in TO_CORRECTION.iter().chain(TO_REPORT) {
        person.types(keys);
        seen.push(page(&person));
    }
    use FieldPage::{Check, Correction, Initial, Instrument, Job, Report, Trial};
    let wanted = [
        Job,
        Job,
        Instrument,
        Initial,
        Trial(1),
        Trial(2),
        Correction(0),
        Check(1),
        Correction(1),
        Check(2),
        Report,
    ];
    assert_eq!(seen, wanted);
}

#[test]
fn the_correction_is_seen_on_the_clock_face() {
    let mut person = begun(Person::at(80, 24));
    for keys in TO_CORRECTION {
        person.types(keys);
    }
    insta::assert_snapshot!("correction", person.sees());
    person.resizes(60, 20);
    insta::assert_snapshot!("correction_narrow", person.sees());
    let mut person = begun(Person::in_ascii(80, 24));
    person.types(TO_CORRECTION[0]).types(TO_CORRECTION[1]).types("1111<up><up><up><up>");
    insta::assert_snapshot!("conventions_ascii", person.sees());
}

/// A convention that is taken in silence puts weights at wrong angles.
#[test]
fn enter_does_not_choose_for_the_user() {
    let mut person = begun(Person::at(80, 24));
    TO_CORRECTION[..2].iter().for_each(|keys| _ = person.types(keys));
    assert!(!person.sees().contains("rotor turns"), "{}", person.sees());
    person.types("<enter><enter>");
    let screen = person.sees();
    assert!(screen.contains("choose 1 or 2") && !screen.contains("rotor turns"), "{screen}");
    person.types("1");
    let screen = person.sees();
    assert!(screen.contains("rotor turns") && !screen.contains("choose 1 or 2"), "{screen}");
}

#[test]
fn a_grade_is_typed_behind_its_choice() {
    let mut person = begun(Person::at(80, 24));
    person.types(TO_CORRECTION[0]).types("1480<enter>180<enter>400<enter>1G2.5<enter>");
    let problem = &person.model.shown_bench().expect("a problem").problem;
    let shape = problem.entry().shape();
    let grade = problem.inputs.form.draft.at(&shape, "rotor.requirement.grade.grade");
    assert_eq!(grade.map(|(draft, _)| draft), Ok(&Draft::Leaf("G2.5".into())));
    person.types("<enter><esc>");
    assert_eq!(page(&person), FieldPage::Instrument);
}

#[test]
fn what_is_typed_is_checked_at_once() {
    let mut person = begun(Person::at(80, 24));
    for keys in &TO_CORRECTION[..3] {
        person.types(keys);
    }
    for (typed, said) in [
        ("7.57", "two values are needed, such as 4.2 @ 120"),
        ("7.57@400", "an angle from 0 to 360° is needed behind the @"),
        ("7.57 kg@40", "is a mass"),
        ("-7.57@40", "must not be below zero"),
    ] {
        person.types(typed);
        assert!(person.sees().contains(said), "{typed}: {}", person.sees());
        person.types("<enter>");
        assert_eq!(page(&person), FieldPage::Initial);
        assert!(person.sees().contains(said), "{typed}: {}", person.sees());
        person.types("<esc>");
    }
    // Nothing of it was taken: the page asks for the first reading still.
    person.types("<down><pgdn>");
    assert!(person.sees().contains("answer what is asked on this page first"), "{}", person.sees());
}

#[test]
fn a_kept_job_is_an_ordinary_problem_that_is_resumed_where_it_stands() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fan.toml");
    let mut person = begun(Person::at(80, 24));
    for keys in &TO_CORRECTION[..4] {
        person.types(keys);
    }
    person.types("25@0<enter>5.17@261<enter>");
    let text = person.kept.values().next().expect("the job is kept against a crash").clone();
    fs::write(&path, &text).expect("the file is written");
    let mut resumed = Person::at(80, 24).opens_file(&path);
    assert!(resumed.sees().contains("1 value") || resumed.sees().contains("2 values"), "{}", resumed.sees());
    resumed.types(":field balancing<enter>");
    assert_eq!(page(&resumed), FieldPage::Trial(1));
    resumed.types("2.41@170<enter>");
    assert!(resumed.sees().contains("40 %."), "{}", resumed.sees());
}

/// Trial weights that stay on are under everything that follows.
#[test]
fn trial_weights_may_be_left_on() {
    let mut person = begun(Person::at(80, 24));
    for keys in &TO_CORRECTION[..4] {
        person.types(keys);
    }
    person.types("25@0<enter>5.17@261<enter>2.41@170<enter><up>2");
    assert!(person.sees().contains("left on"), "{}", person.sees());
    person.types("<enter>");
    assert!(person.sees().contains("Leave the weight in"), "{}", person.sees());
    // With both on: 25 g at 0° in plane 1 and 25 g at 90° in plane 2.
    person.types("25@90<enter>5.6@270<enter>1.61@244<enter><enter>");
    let screen = person.sees();
    assert!(
        screen.contains("Leave the trial weights on and add") && screen.contains("trial weight"),
        "{screen}"
    );
    // What is to be added and the trial weight make up the correction of 61 g at 318°.
    let solution =
        person.model.shown_bench().and_then(|bench| bench.problem.found.solution.as_ref()).expect("solved");
    let number = |name: &str| solution.answer(name).and_then(dalembert_core::Answer::si).expect("a number");
    let (mass, angle) = (number("trim[1]"), number("trim_angle[1]"));
    let (x, y) = (mass * angle.cos() + 0.025, mass * angle.sin());
    assert!((x.hypot(y) - number("correction[1]")).abs() < 1e-9, "{x} {y}");
}

/// Labels, helps, options and titles of every page are Portuguese, and no label is cut on a screen of 80 columns.
#[test]
fn every_line_has_its_portuguese_and_its_room() {
    let portuguese = Locale::portuguese();
    let same = ["Sensor 1", "Sensor 2", "Rotor", "mm/s", "µm", "m/s²", "mil", "in/s", "g", "oz"];
    let mut person = begun(Person::in_portuguese(80, 24));
    let mut all = 0;
    for keys in std::iter::once(&"").chain(TO_CORRECTION).chain(TO_REPORT) {
        person.types(keys);
        let problem = &person.model.shown_bench().expect("a problem").problem;
        for page in pages(problem) {
            let texts = lines(problem, page).into_iter().flat_map(|line| {
                let options = match line.kind {
                    LineKind::Choice(_, options) => options,
                    _ => Vec::new(),
                };
                [line.label, line.help].into_iter().chain(options)
            });
            for text in texts.chain([title(page, true), title(page, false)]).filter(|text| !text.is_empty()) {
                let (english, portuguese) = (text.english(), text.render(&portuguese));
                all += 1;
                assert!(same.contains(&&*english) || english != portuguese, "{english} has no Portuguese");
            }
        }
        let screen = person.sees();
        let is_cut = |line: &str| line.contains('…') && !line.contains("dalembert");
        assert!(!screen.lines().any(is_cut), "{screen}");
    }
    assert!(all > 300, "{all}");
    assert_eq!(Text::from("Correction").render(&Locale::portuguese()), "Correção");
    assert_eq!(person.model.locale.language, Language::Portuguese);
}

#[test]
fn a_job_is_shown_on_screens_of_any_size() {
    for (columns, rows) in [(1, 1), (20, 6), (40, 10), (60, 20), (120, 36), (250, 70)] {
        let mut person = begun(Person::at(80, 24));
        for keys in TO_CORRECTION.iter().chain(TO_REPORT) {
            person.types(keys).resizes(columns, rows);
            let screen = person.sees();
            assert_eq!(screen.lines().count(), usize::from(rows), "{columns}×{rows}");
            person.resizes(80, 24);
        }
    }
}

/// After another alternative is chosen, no number of the earlier problem stands beside the inputs that are missing.
#[test]
fn results_of_another_problem_do_not_stand_beside_a_half_filled_form() {
    let mut person = Person::at(120, 36).knows(&["balancing/field"]).opens("balancing/field");
    assert!(person.sees().contains("1.6762"), "{}", person.sees());
    person.types("<down><down><down><down><down><down><right>");
    let screen = person.sees();
    assert!(screen.contains("No result yet") && !screen.contains("1.6762"), "{screen}");
}

#[test]
fn what_is_typed_after_a_refused_line_takes_its_place() {
    let mut person = begun(Person::at(80, 24));
    TO_CORRECTION[..3].iter().for_each(|keys| _ = person.types(keys));
    person.types("4,2 kg<enter>");
    let screen = person.sees();
    assert_eq!(screen.matches('✗').count(), 1, "one mark: {screen}");
    person.types("4@30");
    let screen = person.sees();
    assert!(screen.contains("4@30") && !screen.contains("kg4@30"), "{screen}");
}
