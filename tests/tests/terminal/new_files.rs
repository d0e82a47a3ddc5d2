//! New problems: files as `dalembert new` writes them, empty or with the inputs of a published case, and blank forms of
//! the workbench.

use std::f64::consts::PI;

use dalembert_core::{
    Draft, FieldError, Locale, Stop, cases,
    file::{self, locate},
    registry,
};
use dalembert_plugins as _;
use dalembert_testkit::on_all_cores;
use dalembert_tests::person::Person;
use itertools::zip_eq;

const LANGUAGES: [fn() -> Locale; 2] = [Locale::english, Locale::portuguese];

#[test]
fn an_empty_file_is_read_and_its_errors_are_what_is_missing() {
    for entry in registry() {
        let (id, shape) = (entry.about.id, entry.shape());
        for locale in LANGUAGES {
            let text = file::template(entry, None, &locale());
            let problem = file::parse(&text).unwrap_or_else(|errors| panic!("{id}: {errors:?}\n{text}"));
            assert_eq!((problem.entry.about.id, problem.notes.len()), (id, 0));
            let first = Draft::blank(&shape).with_first_alternatives(&shape);
            let errors = |draft: &Draft| draft.read(&shape).err().unwrap_or_default();
            let paths = |errors: &[FieldError]| {
                let mut paths: Vec<String> = errors.iter().map(|error| error.path.clone()).collect();
                paths.sort();
                paths
            };
            let found = errors(&problem.draft);
            assert_eq!(paths(&found), paths(&errors(&first)), "{id}\n{text}");
            // Each is found where its value is to be written.
            for (error, place) in zip_eq(&found, locate(&text, &found)) {
                let place = place.unwrap_or_else(|| panic!("{id}: {} has no place\n{text}", error.path));
                let value = &text[place];
                let is_empty = value == "\"\"" || (value.starts_with("'''") && value.lines().count() == 3);
                assert!(is_empty || value.starts_with('['), "{id}: {} = {value}", error.path);
            }
            for line in text.lines() {
                assert!(line.chars().count() <= 200, "{id}: {line}");
            }
        }
    }
}

#[test]
fn the_file_of_a_case_solves_to_its_answers() {
    on_all_cores(registry(), |_, entry| {
        let (id, shape) = (entry.about.id, entry.shape());
        for case in cases::cases(entry).expect("the cases can be read") {
            let expected = case.draft.read(&shape).expect("the case can be read");
            let text = file::template(entry, Some(&case), &Locale::english());
            let problem = file::parse(&text).unwrap_or_else(|errors| panic!("{id}: {errors:?}\n{text}"));
            assert_eq!((problem.title.as_str(), problem.notes.len()), (case.name.as_str(), 0));
            let record =
                problem.draft.read(&shape).unwrap_or_else(|errors| panic!("{id}: {errors:?}\n{text}"));
            let solve =
                |record| format!("{:?}", entry.solve(record, &Stop::new()).map(|solution| solution.answers));
            assert_eq!(solve(&record), solve(&expected), "{id}, {}\n{text}", case.name);
        }
    });
}

#[test]
fn every_input_is_explained() {
    for entry in registry() {
        let text = file::template(entry, None, &Locale::english());
        for field in entry.fields() {
            let key = field.name;
            let stands = text.lines().any(|line| {
                let line = line.trim_start_matches("# ").trim_start_matches(['[']);
                let line = line.strip_prefix("inputs.").unwrap_or(line);
                line.strip_prefix(key).is_some_and(|rest| rest.starts_with([' ', '.', ']']))
            });
            assert!(
                stands && text.contains(&format!("## {}", field.label.split(' ').next().unwrap_or_default())),
                "{}: {key}\n{text}",
                entry.about.id
            );
        }
    }
}

const FAN: &str = "vibration/rotating-unbalance";

/// Types a value into the field under the cursor and goes to the next one.
fn fills(person: &mut Person, values: &[&str]) {
    for value in values {
        person.types(value).types("<down>");
    }
}

#[test]
fn a_blank_problem_is_typed_to_its_answer() {
    let mut person = Person::at(80, 24).knows(&[FAN]);
    person.types("/unbalance<c-n>");
    let screen = person.sees();
    assert!(screen.contains("5 values missing"), "{screen}");
    for missing in ["Mass of the machine", "Unbalance", "Support", "Damping", "Speed of the machine"] {
        let listed = screen.lines().any(|line| line.contains(&format!("· {missing}")));
        assert!(listed, "{missing} is listed as missing:\n{screen}");
    }
    // Its units stand in the empty fields, and nothing of the published case does.
    assert!(screen.contains("needed · kg"), "{screen}");
    assert!(!screen.contains("40 kg") && !screen.contains("19.456"), "{screen}");
    fills(&mut person, &["40 kg", "0.1 kg*m"]);
    assert!(person.sees().contains("3 values missing"), "{}", person.sees());
    // The stiffness itself and the damping ratio are chosen, and asked for at once.
    person.types("<enter><enter><down>");
    fills(&mut person, &["451.4 kN/m"]);
    person.types("<enter><enter><down>");
    assert!(person.sees().contains("2 values missing"), "{}", person.sees());
    fills(&mut person, &["0.05"]);
    assert!(person.sees().contains("one value missing"), "{}", person.sees());
    person.types("1000 rpm");
    // It is solved as soon as it is complete.
    let (mass, unbalance, stiffness, damping, speed) = (40.0, 0.1, 451.4e3, 0.05, 1000.0 * PI / 30.0);
    let impedance =
        (stiffness - mass * speed * speed).hypot(2.0 * damping * (stiffness * mass).sqrt() * speed);
    let amplitude = unbalance * speed * speed / impedance;
    let bench = person.model.bench.as_ref().expect("a problem is open");
    let solution = bench.problem.found.solution.as_ref().expect("it is solved");
    let found =
        solution.answer("amplitude").and_then(dalembert_core::Answer::si).expect("it has an amplitude");
    assert!((found - amplitude).abs() < 1e-12 * amplitude, "{found} {amplitude}");
    let shown = dalembert_units::write_number(1e3 * amplitude, dalembert_units::Style::default());
    let screen = person.sees();
    let line = screen.lines().find(|line| line.contains("Amplitude at this speed")).unwrap_or_default();
    let words: Vec<&str> = line.split_whitespace().collect();
    assert!(words.windows(2).any(|words| words == [shown.as_str(), "mm"]), "{shown}\n{screen}");
}

#[test]
fn a_blank_problem_is_begun_in_portuguese() {
    let mut person = Person::in_portuguese(80, 24).opens(FAN);
    person.types("<c-n>");
    let screen = person.sees();
    for said in ["faltam 5 valores", "· Massa da máquina", "· Amortecimento", "falta · kg", "falta · rad/s"]
    {
        assert!(screen.contains(said), "{said}:\n{screen}");
    }
    person.types("?");
    let is_in_the_help = (0..10).any(|_| person.types("<pgdn>").sees().contains("Ctrl-N"));
    assert!(is_in_the_help, "{}", person.sees());
}

#[test]
fn a_blank_problem_leaves_the_one_that_is_worked_on_alone() {
    let mut person = Person::at(120, 40).opens(FAN);
    // Nothing was done to it: the blank one takes its place.
    person.types("<c-n>");
    assert_eq!(person.model.problems().len(), 1);
    assert!(person.sees().contains("values missing"), "{}", person.sees());
    person.types("<del>50 kg<enter>");
    // What was typed stays, beside another blank one; nothing of it is seen there.
    person.types("<c-n>");
    assert_eq!(person.model.problems().len(), 2);
    assert!(!person.sees().contains("50 kg"), "{}", person.sees());
    person.types("b");
    assert!(person.sees().contains("50 kg"), "{}", person.sees());
}

#[test]
fn every_analysis_has_a_blank_form_that_says_what_is_missing() {
    let mut seen = 0;
    for entry in registry() {
        let (id, shape) = (entry.about.id, entry.shape());
        let mut person = Person::at(80, 24).opens(id);
        person.types("<c-n>");
        let bench = person.model.bench.as_ref().expect("a problem is open");
        let problem = &bench.problem;
        assert_eq!(problem.inputs.form.draft, Draft::blank(&shape), "{id}");
        assert!(problem.found.solution.is_none() && problem.document.origin.is_none(), "{id}");
        let first = problem.needed().next().map(|error| error.path.clone());
        assert_eq!(problem.wrong().next(), None, "{id}");
        let line = problem.inputs.form.line().expect("the cursor is on a line");
        // The cursor is on the first empty input. A mechanism begins with empty lists, and reports it when it is solved.
        match first {
            Some(first) => assert_eq!(line.path, first, "{id}"),
            None => assert!(problem.found.failure.is_some(), "{id}"),
        }
        seen += 1;
    }
    assert!(seen >= 120, "{seen}");
}
