//! Problem files as a user opens, changes and saves them in the workbench.

use std::fs;

use dalembert_core::{Answer, Stop, Text, cases, file, find, registry};
use dalembert_tests::person::Person;
use dalembert_tui::{Msg, files::FileError};

const FAN: &str = "vibration/rotating-unbalance";

fn fan(columns: u16, rows: u16) -> Person {
    Person::at(columns, rows).opens(FAN)
}

#[test]
fn a_problem_is_saved_and_opened_with_its_comments() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fan.toml");
    let mut person = fan(80, 24);
    person.types("<end>+s<c-u>").types(path.to_str().expect("a readable path"));
    assert!(person.sees().contains("Save as"));
    person.types("<enter>");
    assert!(person.sees().contains("saved as") && !person.sees().contains("●"), "{}", person.sees());
    let text = fs::read_to_string(&path).expect("the file is there");
    assert!(text.contains("1001 rpm"), "{text}");

    fs::write(&path, text.replace("speed =", "# measured on Monday\nspeed =")).expect("written");
    let mut person = Person::at(80, 24).opens_file(&path);
    assert!(person.sees().contains("1001 rpm") && person.sees().contains("fan.toml"), "{}", person.sees());
    person.types("<end>+");
    assert!(person.sees().contains("● fan.toml"), "{}", person.sees());
    person.types("s");
    let text = fs::read_to_string(&path).expect("the file is there");
    assert!(text.contains("# measured on Monday") && text.contains("1002 rpm"), "{text}");
}

#[test]
fn a_name_that_is_typed_takes_the_place_of_the_proposed_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine.toml");
    let mut person = fan(80, 24);
    person.types("s");
    assert!(person.sees().contains("rotating-unbalance.toml"));
    person.types(path.to_str().expect("a readable path")).types("<enter>");
    assert!(path.exists(), "{}", person.sees());
    // After a key that moves the cursor the proposal is edited.
    person.types("S<end><bs><bs><bs><bs><bs>2<enter>");
    assert!(folder.path().join("mine2.toml").exists(), "{}", person.sees());
}

#[test]
fn the_name_of_a_published_case_does_not_stay_on_other_inputs() {
    let folder = tempfile::tempdir().expect("a folder");
    let saved = |person: &mut Person, name: &str| {
        let path = folder.path().join(name);
        person.types("S").types(path.to_str().expect("a readable path")).types("<enter>");
        fs::read_to_string(&path).expect("the file is there")
    };
    let mut person = fan(80, 24);
    let case = "Fan on a cantilever";
    assert!(saved(&mut person, "case.toml").contains(&format!("title = \"{case}\"")));
    person.types("<end>+");
    assert!(person.sees().contains(&format!("{case} (changed)")), "{}", person.sees());
    assert!(!saved(&mut person, "changed.toml").contains(case));
    // Back to the case, and back to its name.
    person.types("-");
    assert!(!person.sees().contains("(changed)") && person.sees().contains(case), "{}", person.sees());

    // The same from the file of the case.
    let mut person = Person::at(80, 24).opens_file(folder.path().join("case.toml"));
    assert!(person.sees().contains(case) && !person.sees().contains("(changed)"), "{}", person.sees());
    person.types("<end>+s");
    let text = fs::read_to_string(folder.path().join("case.toml")).expect("the file is there");
    assert!(!text.contains(case) && text.contains("1001 rpm"), "{text}");

    // A title that the user gives stays.
    person.types(":rename<enter>Paint shop<enter>");
    assert!(
        person.sees().contains("● case.toml") && person.sees().contains("Paint shop"),
        "{}",
        person.sees()
    );
    person.types("+s");
    let text = fs::read_to_string(folder.path().join("case.toml")).expect("the file is there");
    assert!(text.contains("title = \"Paint shop\""), "{text}");
}

#[test]
fn a_file_that_changed_on_disk_is_never_written_over_unasked() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fan.toml");
    let mut person = fan(80, 24);
    person.types("s<c-u>").types(path.to_str().expect("a readable path")).types("<enter>");
    let ours = fs::read_to_string(&path).expect("the file is there");
    let theirs = ours.replace("1000 rpm", "800 rpm");
    fs::write(&path, &theirs).expect("written");
    person.types("<end>+s");
    assert!(person.sees().contains("was changed by another program"), "{}", person.sees());
    assert_eq!(fs::read_to_string(&path).expect("the file is there"), theirs);
    // Stay: nothing happens. Read again: theirs. Write over: ours.
    person.types("<esc>");
    assert!(person.sees().contains("1001 rpm"));
    person.types("s<down><enter>");
    assert!(person.sees().contains("800 rpm"), "{}", person.sees());
    fs::write(&path, &ours).expect("written");
    person.types("<end>+s<end><up><enter>");
    assert!(fs::read_to_string(&path).expect("the file is there").contains("801 rpm"), "{}", person.sees());

    // Another problem under the same name asks too.
    let mut person = fan(80, 24);
    person.types("s<c-u>").types(path.to_str().expect("a readable path")).types("<enter>");
    assert!(person.sees().contains("already exists"), "{}", person.sees());
    assert!(fs::read_to_string(&path).expect("the file is there").contains("801 rpm"));
}

#[test]
fn the_end_keeps_what_is_being_typed() {
    let mut person = fan(80, 24);
    person.types("<end><del>77 rpm<c-c>");
    assert!(person.sees().contains("not saved") && !person.has_quit, "{}", person.sees());
    assert!(person.types("<esc>").sees().contains("77 rpm"));
    // A question that is asked while saving before the end does not end the program later.
    person.types("q<enter>");
    assert!(person.sees().contains("Save as"));
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("late.toml");
    person.types("<esc>s<c-u>").types(path.to_str().expect("a readable path")).types("<enter>");
    assert!(path.exists() && !person.has_quit);
}

#[test]
fn saving_before_the_end_ends() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("last.toml");
    let mut person = fan(80, 24);
    person.types("<end>+q<enter><c-u>").types(path.to_str().expect("a readable path")).types("<enter>");
    assert!(person.has_quit);
    assert!(fs::read_to_string(&path).expect("the file is there").contains("1001 rpm"));
}

#[test]
fn what_cannot_be_opened_or_saved_says_why_and_asks_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let missing = folder.path().join("nothing.toml");
    let mut person = Person::at(80, 24);
    person.types("<esc>o").types(missing.to_str().expect("a readable path")).types("<enter>");
    assert!(person.sees().contains("not found: check"), "{}", person.sees());
    person.types("<esc>o").types(folder.path().to_str().expect("a readable path")).types("<enter>");
    assert!(person.sees().contains("is a folder"), "{}", person.sees());
    person.types("<esc>");
    let wrong = folder.path().join("wrong.toml");
    fs::write(&wrong, "analysis = \"vibration/rotating-unbalence\"\n").expect("written");
    person.types("o").types(wrong.to_str().expect("a readable path")).types("<enter>");
    let screen = person.sees();
    assert!(screen.contains("line 1") && screen.contains("rotating-unbalance"), "{screen}");
    person.types("<esc>/rotunb<enter>s<c-u>/nowhere/at/all.toml<enter>");
    assert!(person.sees().contains("/nowhere/at/all.toml"), "{}", person.sees());
    assert!(person.sees().contains("Save as"));
}

#[test]
fn the_title_of_a_file_cannot_drive_the_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("evil.toml");
    fs::write(&path, format!("analysis = \"{FAN}\"\ntitle = \"a\\u001b[31m\\u202eb\"\n[inputs]\nmass = \"4\\u001b]0;x\\u0007 kg\"\n"))
        .expect("written");
    let mut person = Person::at(80, 24).opens_file(&path);
    for _ in 0..6 {
        let screen = person.types("]").sees();
        assert!(!screen.chars().any(|c| c.is_control() && c != '\n'), "{screen:?}");
        assert!(!screen.contains('\u{202e}'));
    }
}

#[test]
fn every_question_shows_its_answers_however_small_the_screen() {
    let questions: [(Asked, &[&str]); 3] = [
        (|person| _ = person.types("<end>+q"), &["save and quit", "quit without", "stay"]),
        (|person| is_refused(person, FileError::Exists(DEEP.into())), &["save under", "overwrite", "stay"]),
        (
            |person| is_refused(person, FileError::Changed(DEEP.into())),
            &["save under", "reload the file", "overwrite", "stay"],
        ),
    ];
    for (columns, rows) in [(20, 6), (30, 8), (40, 12), (80, 24)] {
        for (asked, answers) in &questions {
            let mut person = fan(columns, rows);
            asked(&mut person);
            let screen = person.sees();
            for answer in *answers {
                assert!(screen.contains(answer), "{columns} × {rows} hides `{answer}`:\n{screen}");
            }
            assert!(screen.contains("Esc close"), "{columns} × {rows}:\n{screen}");
        }
    }
}

/// Actions that lead to a question.
type Asked = fn(&mut Person);

/// A path that takes a line and more of a small screen.
const DEEP: &str = "/a/long/way/down/to/the/fan.toml";

/// A save ends in an error.
fn is_refused(person: &mut Person, error: FileError) {
    person.happens(Msg::Saved { path: DEEP.into(), text: String::new(), result: Err(error) });
}

/// A job of field balancing: the initial run, and a run with 5 g.
fn job(first: &str, trial: &str) -> String {
    format!(
        "{first} = [{{ amplitude = \"80\", phase = \"30 deg\" }}]\n\
         {trial}.after = \"taken-off\"\n\
         {trial}.runs = [{{ plane = 1, mass = \"5 g\", angle = \"0 deg\", readings = [{{ amplitude = \"2*50\", phase = \"75 deg\" }}] }}]\n"
    )
}

fn field_balancing(inputs: &str) -> String {
    format!(
        "format = 2\nanalysis = \"balancing/field\"\n[inputs]\nphase = \"lead\"\nangles = \"with\"\n\
         method = \"least-squares\"\n{inputs}"
    )
}

#[test]
fn what_was_measured_was_an_alternative_in_earlier_files() {
    let mut answers = Vec::new();
    for (was, unit) in
        [("displacement", "um"), ("velocity", "mm/s"), ("acceleration", "m/s^2"), ("number", "")]
    {
        let old = field_balancing(&job(
            &format!("measured.{was}.first"),
            &format!("measured.{was}.influence.runs"),
        ));
        let parsed = file::parse(&old).unwrap_or_else(|errors| panic!("{old}: {errors:?}"));
        let notes: Vec<String> = parsed.notes.iter().map(Text::english).collect();
        assert_eq!(
            notes,
            [format!("inputs.measured.{was}: read as inputs.measured; the units now say what was measured")]
        );
        let saved = file::write(&parsed, &old);
        assert!(!saved.contains(&format!("measured.{was}")), "{saved}");
        let again = file::parse(&saved).unwrap_or_else(|errors| panic!("{saved}: {errors:?}"));
        assert!(again.notes.is_empty(), "{:?}", again.notes);
        assert_eq!(again.draft, parsed.draft, "{saved}");
        let record = parsed.draft.read(&parsed.entry.shape()).unwrap_or_else(|errors| panic!("{errors:?}"));
        let solution = parsed.entry.solve(&record, &Stop::new()).expect("the job is solved");
        let number = |name: &str| solution.answer(name).and_then(Answer::si).expect("a number");
        answers.push(number("correction[1]"));
        let residual = solution.answer("largest_residual").expect("an answer");
        assert_eq!(residual.unit.ascii(), unit, "{old}");
    }
    // Whatever is measured, the weight is the same.
    assert!(answers.iter().all(|mass| (mass / answers[0] - 1.0).abs() < 1e-12), "{answers:?}");
    let known = |unit: &str| {
        format!(
            "measured.velocity.first = [{{ amplitude = \"80\", phase = \"30 deg\" }}]\n\
             measured.velocity.influence.known.coefficients = \"\"\"\n{unit}1; 1; 4; 20\n\"\"\"\n"
        )
    };
    let solved = |text: &str| {
        let parsed = file::parse(text).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
        let record = parsed.draft.read(&parsed.entry.shape()).unwrap_or_else(|errors| panic!("{errors:?}"));
        let solution = parsed.entry.solve(&record, &Stop::new()).expect("the job is solved");
        solution.answer("correction[1]").and_then(Answer::si).expect("a number")
    };
    let bare = solved(&field_balancing(&known("")));
    let stated = solved(&field_balancing(&known("[1]; [1]; [mm/(s*g)]; [deg]\n")));
    assert_eq!(bare.to_bits(), stated.to_bits());
}

#[test]
fn a_path_of_an_earlier_file_is_read_with_the_unit_it_meant() {
    let shape = find("balancing/field").expect("it is registered").shape();
    let now = |path: &str, text: &str| file::named_input(&shape, path, text).map(|now| (now.path, now.text));
    let pair = |path: &str, text: &str| Some((path.to_owned(), text.to_owned()));
    let first = "measured.first[1].amplitude";
    assert_eq!(now("measured.velocity.first[1].amplitude", "80"), pair(first, "80 mm/s"));
    assert_eq!(now("measured.displacement.first[1].amplitude", "2*50"), pair(first, "(2*50) um"));
    assert_eq!(now("measured.acceleration.first[1].amplitude", "3 in/s^2"), pair(first, "3 in/s^2"));
    assert_eq!(now("measured.number.first[1].phase", "30 deg"), pair("measured.first[1].phase", "30 deg"));
    // Today's paths, and paths of nothing, are left alone.
    for path in [first, "measured", "measured.speed.first", "velocity.first"] {
        assert_eq!(now(path, "80"), None, "{path}");
    }
}

#[test]
fn a_case_is_found_by_its_former_title() {
    let mut renamed = 0;
    for entry in registry() {
        let cases = cases::cases(entry).expect("the cases can be read");
        for former in cases.iter().filter_map(|case| case.former.as_deref()) {
            let named = cases.iter().filter(|case| case.is_named(former)).count();
            assert_eq!(named, 1, "{}: {former}", entry.about.id);
            renamed += 1;
        }
    }
    assert!(renamed > 250, "{renamed}");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fan.toml");
    let mut person = fan(80, 24);
    person.types("S<c-u>").types(path.to_str().expect("a readable path")).types("<enter>");
    let text = fs::read_to_string(&path).expect("the file is there");
    let old = text.replace("Fan on a cantilever", "The fan as it should have come out");
    fs::write(&path, old).expect("written");
    let person = Person::at(80, 24).opens_file(&path);
    let bench = person.model.bench.as_ref().expect("a problem is open");
    let origin = bench.problem.document.origin.as_ref().map(|case| case.name.as_str());
    assert_eq!(origin, Some("Fan on a cantilever, corrected"), "{text}");
}

#[test]
fn quantities_of_one_of_several_kinds_are_all_of_one() {
    let with = |first: &str, second: &str| {
        let inputs = format!(
            "vectors.readings.first = {{ amplitude = \"{first}\", phase = \"30 deg\" }}\n\
             vectors.readings.second = {{ amplitude = \"{second}\", phase = \"200 deg\" }}\n"
        );
        let text = format!("format = 2\nanalysis = \"balancing/static-couple\"\n[inputs]\n{inputs}");
        let parsed = file::parse(&text).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
        parsed.draft.read(&parsed.entry.shape()).map_err(|errors| {
            errors.iter().map(|error| format!("{}: {}", error.path, error.why.english())).collect::<Vec<_>>()
        })
    };
    for [first, second] in [["100 um", "3 mil"], ["4 mm/s", "0.2 in/s"], ["0.1 g0", "1 m/s^2"], ["12", "7.5"]]
    {
        with(first, second).unwrap_or_else(|errors| panic!("{first}, {second}: {errors:?}"));
    }
    assert_eq!(
        with("4 mm/s", "80 um").unwrap_err(),
        [
            "vectors.readings.second.amplitude: 80 µm is of another kind than vectors.readings.first.amplitude = 4 mm/s: \
          write all of these in units of one kind"
        ]
    );
    let [error] = &with("4 kg", "80 um").unwrap_err()[..] else { panic!("one error") };
    assert!(error.ends_with("units of any of these kinds are accepted: µm | mm/s | m/s² | 1"), "{error}");
}
