//! New problem files, as `dalembert new` writes them: empty, or with the inputs of a published case.

use dalembert_core::{
    Draft, FieldError, Locale, Stop, cases,
    file::{self, locate},
    registry,
};
use dalembert_plugins as _;
use dalembert_testkit::on_all_cores;
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
