//! Data that come in many numbers: tables of measurements, and rows of a list.

use std::fs;

use dalembert_core::{Draft, cases};
use dalembert_tests::person::Person;

pub(super) const RESPONSE: &str = "vibration/frequency-response-identification";
pub(super) const PARTS: &str = "measurement.complex.response.accelerance-parts.points";

/// A user before the form of a case whose name holds these words, on the line of a path.
pub(super) fn before(mut person: Person, words: &str, path: &str) -> Person {
    let bench = person.model.bench.as_mut().expect("a problem is open");
    let cases = cases::cases(bench.problem.entry()).expect("the cases can be read");
    let case = cases.into_iter().find(|case| case.name.contains(words)).expect("there is such a case");
    let entry = bench.problem.entry();
    bench.problem.inputs.form.replace(entry, case.draft);
    bench.problem.inputs.form.go_to(path);
    person
}

/// The text of a field.
pub(super) fn text(person: &Person, path: &str) -> String {
    let bench = person.model.bench.as_ref().expect("a problem is open");
    match bench.problem.inputs.form.draft.at(&bench.problem.entry().shape(), path) {
        Ok((Draft::Leaf(text), _)) => text.clone(),
        other => panic!("{path}: {other:?}"),
    }
}

/// The screen with its words apart by single blanks, so that sentences are found across lines.
pub(super) fn words(person: &mut Person) -> String {
    let screen = person.sees().replace(['│', '┃'], " ");
    screen.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_editor_of_a_table_tells_its_columns_and_is_left_without_keeping() {
    let mut person = before(Person::at(80, 24).opens(RESPONSE), "accelerance", PARTS);
    let kept = text(&person, PARTS);
    person.types("<enter>");
    let seen = words(&mut person);
    for reported in [
        "Frequency [Hz]; Real part [1/kg]; Imaginary part [1/kg]",
        "One row per line",
        "@name reads a file",
        "Ctrl-G",
    ] {
        assert!(seen.contains(reported), "`{reported}`: {}", person.sees());
    }
    assert!(!seen.contains(PARTS), "the title is in words: {}", person.sees());
    person.types("1; 2<enter>");
    let seen = words(&mut person);
    assert!(
        seen.contains("2 columns separated by semicolons instead of 3: Frequency; Real part; Imaginary part"),
        "{}",
        person.sees()
    );
    person.types("<c-g>");
    assert_eq!(text(&person, PARTS), kept);
    assert!(person.model.dialog.is_none());
    person.types("<enter>1; 2<enter><esc>");
    assert_ne!(text(&person, PARTS), kept);
    person.types("z");
    assert_eq!(text(&person, PARTS), kept);

    let mut person = before(Person::in_portuguese(80, 24).opens(RESPONSE), "accelerance", PARTS);
    person.types("<enter>1; 2<enter>");
    let seen = words(&mut person);
    for reported in [
        "Frequência [Hz]; Parte real [1/kg]",
        "separadas por ponto e vírgula em vez de 3",
        "Uma linha por ponto",
    ] {
        assert!(seen.contains(reported), "`{reported}`: {}", person.sees());
    }
}

#[test]
fn a_digit_on_a_heading_is_answered_by_the_key_that_serves_there() {
    let mut person = Person::at(80, 24).opens("balancing/field");
    move_to(&mut person, "measured.influence.runs.runs");
    person.types("9");
    assert!(words(&mut person).contains("a list: a adds a row"), "{}", person.sees());
    move_to(&mut person, "measured");
    person.types("1");
    assert!(words(&mut person).contains("a heading: Enter goes to its fields"), "{}", person.sees());
}

const ROTOR: &str = "vibration/rotor-dynamics";

/// A user before the first case of an analysis, on the line of a path.
fn on(mut person: Person, path: &str) -> Person {
    move_to(&mut person, path);
    person
}

fn move_to(person: &mut Person, path: &str) {
    person.model.bench.as_mut().expect("a problem is open").problem.inputs.form.go_to(path);
}

fn rows(person: &Person, path: &str) -> usize {
    let bench = person.model.bench.as_ref().expect("a problem is open");
    match bench.problem.inputs.form.draft.at(&bench.problem.entry().shape(), path) {
        Ok((Draft::Rows(rows), _)) => rows.len(),
        other => panic!("{path}: {other:?}"),
    }
}

#[test]
fn a_pasted_table_fills_rows() {
    let mut person = on(Person::at(100, 30).opens(ROTOR), "segments");
    let before = rows(&person, "segments");
    let kept = person.model.bench.as_ref().map(|bench| bench.problem.inputs.form.draft.clone());
    person.pastes("L\tD\r\n0.2 m\t40 mm\r\n0.3 m\t50 mm\r\n0.4 m\t60 mm\r\n");
    assert_eq!(rows(&person, "segments"), before.max(3));
    for (row, (length, outer)) in
        [("0.2 m", "40 mm"), ("0.3 m", "50 mm"), ("0.4 m", "60 mm")].into_iter().enumerate()
    {
        assert_eq!(text(&person, &format!("segments[{}].length", row + 1)), length);
        assert_eq!(text(&person, &format!("segments[{}].outer", row + 1)), outer);
    }
    let seen = words(&mut person);
    assert!(seen.contains("3 rows filled; first line skipped (heading)"), "{}", person.sees());
    person.types("z");
    assert_eq!(
        person.model.bench.as_ref().map(|bench| bench.problem.inputs.form.draft.clone()),
        kept,
        "one undo"
    );
    // From a cell it goes down and to the right; what has no field is reported.
    person.model.bench.as_mut().expect("a problem is open").problem.inputs.form.go_to("segments[1].outer");
    let length = text(&person, "segments[1].length");
    person.pastes("41 mm\t\t5 mm\t9\n42 mm");
    assert_eq!(text(&person, "segments[1].length"), length);
    assert_eq!(text(&person, "segments[1].outer"), "41 mm");
    assert_eq!(text(&person, "segments[1].inner"), "5 mm");
    assert_eq!(text(&person, "segments[2].outer"), "42 mm");
    assert!(words(&mut person).contains("ignored, beyond the last field of a row: 1"), "{}", person.sees());
    // One cell for one field is what it was.
    person.pastes("43 mm\n");
    assert_eq!(text(&person, "segments[1].outer"), "43 mm");
    let mut person = on(Person::in_portuguese(100, 30).opens(ROTOR), "segments");
    person.pastes("0,2 m\t40 mm");
    assert!(words(&mut person).contains("uma linha preenchida"), "{}", person.sees());
}

#[test]
fn rows_are_folded_one_by_one_and_all_together() {
    let mut person = on(Person::at(80, 40).opens(ROTOR), "segments");
    person.pastes("0.2 m\t40 mm\n0.3 m\t50 mm\n0.4 m\t60 mm");
    let lines = |person: &Person| {
        person.model.bench.as_ref().expect("a problem is open").problem.inputs.form.lines().len()
    };
    let path = |person: &Person| {
        person
            .model
            .bench
            .as_ref()
            .and_then(|bench| bench.problem.inputs.form.line())
            .map(|line| line.path)
            .unwrap_or_default()
    };
    let all = lines(&person);
    person.model.bench.as_mut().expect("a problem is open").problem.inputs.form.go_to("segments[2].outer");
    person.types("f");
    assert_eq!(path(&person), "segments[2]");
    let folded = lines(&person);
    assert!(folded < all, "{}", person.sees());
    assert!(person.sees().contains("2 ▸  0.3 m · 50 mm"), "{}", person.sees());
    // It stays folded where it goes, and is gone into by Enter.
    person.types("K");
    assert_eq!((path(&person), lines(&person)), ("segments[1]".to_owned(), folded));
    assert!(person.sees().contains("1 ▸  0.3 m · 50 mm"), "{}", person.sees());
    person.types("<enter>");
    assert_eq!((path(&person), lines(&person)), ("segments[1].length".to_owned(), all));
    person.types("F");
    assert_eq!(path(&person), "segments[1]");
    let count = rows(&person, "segments");
    assert_eq!(lines(&person), all - count * (all - folded));
    // What is wrong in a folded row marks its heading, and a change that is taken back is seen.
    person.model.bench.as_mut().expect("a problem is open").problem.inputs.form.go_to("segments[2].length");
    person.types("<del>7 kg<enter>F<down>");
    let heading = person.sees().lines().find(|line| line.contains("7 kg · 40 mm")).map(str::to_owned);
    assert!(heading.is_some_and(|line| line.contains("✗")), "{}", person.sees());
    person.types("F");
    assert_eq!(lines(&person), all);
    person.types("Fz");
    assert_eq!(path(&person), "segments[2].length");
    person.types("?");
    for _ in 0..4 {
        if person.sees().contains("collapse or expand all rows of the list") {
            return;
        }
        person.types("<pgdn>");
    }
    panic!("the help tells the keys:\n{}", person.sees());
}

const NETWORK: &str = "vibration/spring-network";

#[test]
fn errors_name_their_row_and_names_are_one_row_s_alone() {
    let mut person = on(Person::at(60, 30).opens(NETWORK), "nodes[2].mass");
    person.types("<del>3 m<enter><tab>");
    let seen = words(&mut person);
    assert!(seen.contains("Nodes 2, Mass:"), "{}", person.sees());
    let mut person = on(Person::at(60, 30).opens(NETWORK), "nodes[1].name");
    let (first, second) = (text(&person, "nodes[1].name"), text(&person, "nodes[2].name"));
    assert_eq!(text(&person, "loaded"), first, "the case loads its first node by its name");
    // References follow, through names that others have on the way, and are taken back with the name.
    person.types("<del>").types(&second);
    assert!(words(&mut person).contains("is called"), "{}", person.sees());
    person.types(" too<enter>");
    let name = format!("{second} too");
    assert_eq!(text(&person, "nodes[1].name"), name);
    assert_eq!(text(&person, "loaded"), name);
    assert_eq!(text(&person, "elements[1].from"), name);
    assert_eq!(text(&person, "elements[1].to"), second);
    assert!(
        person.model.bench.as_ref().is_some_and(|bench| bench.problem.wrong().next().is_none()),
        "{}",
        person.sees()
    );
    person.types("z");
    assert_eq!((text(&person, "nodes[1].name"), text(&person, "loaded")), (first.clone(), first.clone()));
    // Without a name its number is left.
    person.types("<del><enter>");
    assert_eq!(text(&person, "loaded"), "1");
    person.types("z<del>").types(&second).types("<enter><tab>");
    let seen = words(&mut person);
    assert!(seen.contains(&format!("Nodes 2, Name: row 1 is called `{second}` too")), "{}", person.sees());
}

#[test]
fn a_copied_row_has_a_name_of_its_own_and_rows_that_are_alike_change_places() {
    let mut person = on(Person::at(60, 30).opens(NETWORK), "nodes[2].name");
    let name = text(&person, "nodes[2].name");
    person.types("dd");
    let copies = ["nodes[3].name", "nodes[4].name"].map(|path| text(&person, path));
    assert_eq!(copies, [format!("{name} 2"), format!("{name} 3")]);
    assert!(
        person.model.bench.as_ref().is_some_and(|bench| bench.problem.wrong().next().is_none()),
        "{}",
        person.sees()
    );
    let mut person = on(Person::at(80, 40).opens(ROTOR), "segments[1].length");
    let place = |person: &Person| {
        let bench = person.model.bench.as_ref().expect("a problem is open");
        bench.problem.inputs.form.line().map(|line| line.path)
    };
    person.types("d");
    let copy = place(&person);
    person.types("K");
    assert_ne!(place(&person), copy, "{}", person.sees());
}

#[test]
fn a_read_only_start_and_doubtful_thousands_are_reported() {
    let mut person = on(Person::at(80, 24).opens("vibration/rotating-unbalance"), "speed");
    assert!(!person.sees().contains("read-only"));
    person.model.readonly = true;
    assert!(
        person.sees().lines().next().is_some_and(|title| title.contains("read-only")),
        "{}",
        person.sees()
    );
    person.types("<del>1,500 rpm<enter>");
    assert!(person.sees().contains("can be read in two ways"), "{}", person.sees());
    person.types("<del>1.500 rpm<enter>");
    assert!(!person.sees().contains("has a decimal mark"), "{}", person.sees());
    let mut person = on(Person::in_portuguese(80, 24).opens("vibration/rotating-unbalance"), "speed");
    person.types("<del>1.500 rpm<enter>");
    assert!(person.sees().contains("1.500 tem um sinal decimal"), "{}", person.sees());
    // A comma is a decimal mark there; what is kept has a point, as files have.
    person.types("<del>1,500 rpm<enter>");
    assert_eq!(typed_at(&person, "speed"), "1.500 rpm");
    person.pastes("0,125 rpm");
    assert_eq!(typed_at(&person, "speed"), "0.125 rpm");
}

/// Text of the draft at a path.
fn typed_at(person: &Person, path: &str) -> String {
    let bench = person.model.bench.as_ref().expect("a problem is open");
    match bench.problem.inputs.form.draft.at(&bench.problem.entry().shape(), path) {
        Ok((Draft::Leaf(text), _)) => text.clone(),
        other => panic!("{path}: {other:?}"),
    }
}

#[test]
fn numbers_of_other_inputs_do_not_stand_beside_a_half_filled_form() {
    for size in [(80, 40), (200, 60)] {
        let mut person = on(Person::at(size.0, size.1).opens("balancing/field"), "measured.influence");
        let correction = "1.6762 oz";
        assert!(person.sees().contains(correction), "{}", person.sees());
        person.types("<enter><down><enter>");
        let screen = person.sees();
        assert!(screen.contains("No result yet: ") && screen.contains("value missing"), "{screen}");
        assert!(!screen.contains(correction), "{screen}");
        // They come back with the inputs.
        person.types("z");
        assert!(person.sees().contains(correction), "{}", person.sees());
    }
    // A slip in one field leaves what was found, marked as that of the inputs before.
    let mut person = on(Person::at(80, 24).opens("vibration/rotating-unbalance"), "mass");
    person.types("<del>40 kgg<enter>");
    let screen = person.sees();
    assert!(screen.contains("results for the previous, complete") && screen.contains("19.456"), "{screen}");
    // A second one hides it.
    person.types("<end><del>fast<enter>");
    let screen = person.sees();
    assert!(screen.contains("No result yet: 2 errors") && !screen.contains("19.456"), "{screen}");
    // It stays hidden until there is a result of the inputs that are there.
    person.types("<del>1000 rpm<enter>");
    assert!(!person.sees().contains("19.456"), "{}", person.sees());
}

#[test]
fn a_choice_that_a_file_leaves_out_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("wheel.toml");
    let text = "format = 2\nanalysis = \"rigid-body/rolling-stability\"\n[inputs]\nradius = \"0.3 m\"\n";
    fs::write(&path, text).expect("written");
    let mut person = on(Person::at(100, 30).opens_file(&path), "wheel");
    let screen = person.sees();
    assert!(screen.contains("choose one of 4") && screen.contains("No result yet"), "{screen}");
    // It is saved without one, and chosen like any other.
    person.types("s");
    let saved = fs::read_to_string(&path).expect("the file is there");
    assert!(saved.starts_with(text) && !saved.contains("wheel"), "{saved}");
    person.types("<enter><down><enter>");
    assert!(!person.sees().contains("choose one of 4"), "{}", person.sees());
}

#[test]
fn a_definition_and_a_question_are_typed_into_the_form() {
    let mut person = Person::at(120, 40).opens("vibration/rotating-unbalance");
    assert!(!person.sees().contains("Definitions"), "{}", person.sees());
    // 12 g at 8.3333 m: the unbalance of the case.
    person.types("N<enter>bolt<tab>12 g<enter>");
    assert!(person.sees().contains("Definitions"), "{}", person.sees());
    move_to(&mut person, "unbalance");
    person.types("<enter><c-u>bolt*25 m/3<enter>");
    assert!(person.sees().contains("19.456") && person.sees().contains("bolt*25 m/3"), "{}", person.sees());
    assert!(person.sees().contains("bolt*25 m/3  = 0.1 kg·m"), "{}", person.sees());
    person.types("A<enter>peak to peak<tab>2*X<enter>");
    let screen = person.sees();
    assert!(screen.contains("Questions") && screen.contains("38.913"), "{screen}");
    // What is wrong with a formula is named at its field, and mended there.
    person.types("<enter><c-u>2*Xx<enter>");
    assert!(person.sees().contains("there is no `Xx` here"), "{}", person.sees());
    person.types("<enter><end><bs><enter>");
    assert!(person.sees().contains("38.913"), "{}", person.sees());
    // A definition may change like an input, and the change is taken back.
    move_to(&mut person, "let[1].formula");
    person.types("<enter><c-u>24 g<enter>");
    assert!(!person.sees().contains("38.913"), "{}", person.sees());
    person.types("z");
    assert!(person.sees().contains("38.913"), "{}", person.sees());
}

#[test]
fn a_configuration_is_typed_in_the_form() {
    let mut person = Person::at(120, 60).opens("vibration/rotating-unbalance");
    // C on the support: another one, of 100 kN/m on 40 kg.
    person.types("<home><down><down>C<enter>soft<enter>");
    move_to(&mut person, "configuration[1].input");
    person.types("<enter><end>.stiffness.stiffness<enter>");
    move_to(&mut person, "configuration[1].formula");
    person.types("<enter>100 kN/m<enter>");
    let screen = person.sees();
    assert!(screen.contains("soft") && screen.contains("2.0944"), "{screen}");
    person.types("zzzz");
    assert!(!person.sees().contains("soft"), "{}", person.sees());
    // C on the mass: its name, then what it is there.
    person.types("<home>C<enter>weighted<enter>");
    move_to(&mut person, "configuration[1].formula");
    person.types("<enter>m + 2 kg<enter>");
    // ωₙ = √(451 389 N/m/42 kg).
    let screen = person.sees();
    assert!(screen.contains("Configurations") && screen.contains("103.67"), "{screen}");
    assert!(screen.contains("weighted") && screen.contains("106.23"), "{screen}");
    person.types("zzz");
    assert!(!person.sees().contains("103.67"), "{}", person.sees());
}

#[test]
fn linked_problems_change_each_other_in_one_form() {
    let text = fs::read_to_string(xtask::root().join("examples/fan_on_bracket.toml")).expect("an example");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fan.toml");
    fs::write(&path, text).expect("written");
    for (width, height) in [(80, 24), (160, 45)] {
        let mut person = Person::at(width, height);
        person.types("<esc>o<c-u>").types(path.to_str().expect("a readable path")).types("<enter>");
        assert!(person.sees().contains("25.2"), "{}", person.sees());
        // The thickness of the bracket doubled: its stiffness eightfold, 201.6 kN/m, and the fan takes it.
        move_to(&mut person, "bracket.motion.translation.springs.cantilever.section.rectangle.height");
        person.types("<enter><c-u>20 mm<enter>");
        let screen = person.sees();
        assert!(screen.contains("201.6"), "{screen}");
        move_to(&mut person, "fan.support.stiffness.stiffness");
        // In a narrow form the formula alone has room; what it gives stands in the line below in any case.
        let beside = if width < 100 { "bracket.stiffness  = 201.6 kN/m" } else { "bracket.stiffness" };
        let screen = person.sees();
        assert!(screen.contains(beside), "{screen}");
        assert!(screen.lines().rev().nth(1).is_some_and(|line| line.contains(" · = 201.6 kN/m")), "{screen}");
        // The mass of the fan is that on the bracket.
        move_to(&mut person, "fan.mass");
        person.types("<enter><c-u>50 kg<enter>");
        move_to(&mut person, "bracket.motion.translation.load.mass.mass");
        assert!(person.sees().contains("= 50 kg"), "{}", person.sees());
    }
}

#[test]
fn a_link_that_is_typed_is_read_when_the_problem_is_opened_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let spring = "format = 2\nanalysis = \"vibration/equivalent-stiffness\"\n[inputs]\nmotion.translation.springs.stiffness.stiffness = \"30 kN/m\"\n";
    fs::write(folder.path().join("spring.toml"), spring).expect("written");
    let path = folder.path().join("fan.toml");
    let path = path.to_str().expect("a readable path");
    let mut person = Person::at(160, 45).opens("vibration/rotating-unbalance");
    move_to(&mut person, "support.cantilever.length");
    person.types("<enter><c-u>@spring.toml:period*1 m/s<enter>");
    assert!(person.sees().contains("the linked file is not read yet"), "{}", person.sees());
    let text = fs::read_to_string(xtask::root().join("examples/fan_questions.toml")).expect("an example");
    let stiffness = text.lines().find(|line| line.contains("stiffness")).expect("it has a stiffness");
    fs::write(path, text.replace(stiffness, "support.stiffness.stiffness = \"2*@spring.toml:stiffness\""))
        .expect("written");
    person.types("o<c-u>").types(path).types("<enter>");
    let screen = person.sees();
    assert!(screen.contains("@spring.toml") && screen.contains("= 60 kN/m"), "{screen}");
}

#[test]
fn an_unknown_is_found_from_an_answer_that_is_given_in_results() {
    let mut person = Person::at(120, 40).opens("vibration/rotating-unbalance");
    // Only a quantity can be unknown: the support is a choice.
    person.types("<home><down><down>U");
    assert!(person.sees().contains("only a quantity can be unknown"), "{}", person.sees());
    person.types("<home>U");
    assert!(person.sees().contains("more unknowns (1) than given answers (0)"), "{}", person.sees());
    // = chooses among the answers, and gives the fourth one: the natural frequency.
    person.types("<tab>=<down><down><down>=");
    let screen = person.sees();
    assert!(screen.contains("Given answers") && screen.contains("106.23 rad/s"), "{screen}");
    // m = k/(2π fₙ)² = 451 389 N/m/(24π/s)².
    person.types("<enter><c-u>12 Hz<enter>");
    assert!(person.sees().contains("79.401"), "{}", person.sees());
    assert!(person.sees().contains("?  = 79.401 kg"), "{}", person.sees());
    // A range that leaves it out is refused with what the answer covers there.
    let bench = person.model.bench.as_mut().expect("a problem is open");
    bench.problem.inputs.form.go_to("mass");
    person.types("<enter><c-u>? 1 kg .. 50 kg<enter>");
    assert!(person.sees().contains("the answer lies"), "{}", person.sees());
    person.types("zz");
    assert!(person.sees().contains("106.23 rad/s"), "{}", person.sees());
}
