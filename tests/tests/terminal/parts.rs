//! Problems, configurations and linked files of a problem file as tabs of the workbench.

use std::{fs, path::Path};

use dalembert_core::file;
use dalembert_tests::person::Person;
use dalembert_tui::{Msg, files::Autosave};

const FAN: &str = "vibration/rotating-unbalance";

/// A person with the example of a fan on a bracket open, from a folder of its own.
fn with_fan_on_bracket(folder: &Path, columns: u16, rows: u16) -> Person {
    let text = fs::read_to_string(xtask::root().join("examples/fan_on_bracket.toml")).expect("an example");
    let path = folder.join("fan.toml");
    fs::write(&path, text).expect("written");
    Person::at(columns, rows).opens_file(path)
}

fn move_to(person: &mut Person, path: &str) {
    let form = &mut person.model.bench.as_mut().expect("a problem is open").problem.inputs.form;
    form.go_to(path);
    assert_eq!(form.line().expect("a line").path, path);
}

fn shown(person: &Person) -> String {
    let form = &person.model.bench.as_ref().expect("a problem is open").problem.inputs.form;
    form.part().title().english()
}

/// The rows of the form that begin with these words and have a value, which may stand in the row below them.
fn field(screen: &str, label: &str, value: &str) -> String {
    let form: Vec<&str> = screen.lines().filter_map(|line| line.split('│').nth(1)).collect();
    let at = form.iter().position(|row| row.trim_start_matches([' ', '▸', '●', '✗']).starts_with(label));
    let at = at.unwrap_or_else(|| panic!("no field `{label}`:\n{screen}"));
    let rows = form[at..].iter().take(2).take_while(|row| **row == form[at] || !form[at].contains(value));
    let rows: String = rows.copied().collect();
    assert!(rows.contains(value), "`{label}` is not {value}:\n{screen}");
    rows
}

/// The first line of the screen below its title: that of the tabs.
fn tabs(person: &mut Person) -> String {
    person.sees().lines().nth(1).expect("a line").to_owned()
}

#[test]
fn problems_and_configurations_are_tabs_that_change_each_other() {
    let folder = tempfile::tempdir().expect("a folder");
    for (columns, rows) in [(80, 24), (160, 45), (60, 20)] {
        let is_wide = columns > 140;
        let mut person = with_fan_on_bracket(folder.path(), columns, rows);
        for tab in ["bracket", "fan", "fan.weighted", "All problems"] {
            assert!(tabs(&mut person).contains(tab), "{}", person.sees());
        }
        // The bracket has its own inputs, and nothing of the fan.
        assert_eq!(shown(&person), "bracket");
        let screen = person.sees();
        assert!(screen.contains("Equivalent") && !screen.contains("12 g"), "{screen}");
        person.types("}");
        assert_eq!(shown(&person), "fan");
        let screen = person.sees();
        assert!(screen.contains("40 kg") && screen.contains("Rotating unbalance"), "{screen}");
        person.types("}");
        assert_eq!(shown(&person), "fan.weighted");
        // Its mass is another one, which is marked; the rest is that of the fan.
        let screen = person.sees();
        assert!(field(&screen, "Mass of the", "m + 2 kg").contains('●'), "{screen}");
        assert!(!field(&screen, "Speed of the", "1500 rpm").contains('●'), "{screen}");
        // A mass of 50 kg on the tab of the fan: 52 kg on that of the configuration, 50 kg on the bracket.
        person.types("{");
        move_to(&mut person, "fan.mass");
        person.types("50<enter>}");
        assert_eq!(shown(&person), "fan.weighted");
        let form = &person.model.bench.as_ref().expect("open").problem;
        let found = form.found.solution.as_ref().expect("solved");
        assert_eq!(found.computed_input("fan.weighted.mass").map(|(si, _)| si), Some(52.0));
        if is_wide {
            // The pictures are those of the part as well.
            assert!(person.sees().contains("fan.weighted: "), "{}", person.sees());
        }
        if columns > 60 {
            // ωₙ = √(25.2 kN/m/52 kg) stands in the results, which begin with the shown part.
            assert!(person.sees().contains("22.014"), "{}", person.sees());
        }
        person.types("{{");
        move_to(&mut person, "bracket.motion.translation.load.mass.mass");
        assert!(person.sees().contains("fan.mass"), "{}", person.sees());
        // Over the end, back to the beginning.
        person.types("}}}");
        assert_eq!(shown(&person), "All problems");
        assert!(person.sees().contains("share"), "{}", person.sees());
        person.types("}");
        assert_eq!(shown(&person), "bracket");
        // What names an input of a configuration leads to its tab.
        let form = &mut person.model.bench.as_mut().expect("open").problem.inputs.form;
        form.go_to_nearest("fan.weighted.mass");
        assert_eq!(
            (form.line().expect("a line").path, shown(&person)),
            ("fan.mass".into(), "fan.weighted".into())
        );
        person.types("}}");
        assert_eq!(shown(&person), "bracket");
        // Tabs are clicked.
        person.clicks("fan.weighted");
        assert_eq!(shown(&person), "fan.weighted");
    }
}

#[test]
fn a_configuration_takes_what_is_typed_on_its_tab_and_returns_to_the_problem() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut person = with_fan_on_bracket(folder.path(), 120, 40);
    let path = folder.path().join("fan.toml");
    let before = fs::read_to_string(&path).expect("the file");
    person.types("}}");
    assert_eq!(shown(&person), "fan.weighted");
    // The speed of the configuration alone, by digits: the unit of the fan is kept.
    move_to(&mut person, "fan.speed");
    person.types("1200<enter>");
    let screen = person.sees();
    assert!(field(&screen, "Speed of the", "1200 rpm").contains('●'), "{screen}");
    assert!(screen.contains("1500 rpm in the problem itself"), "{screen}");
    person.types("{");
    move_to(&mut person, "fan.speed");
    let screen = person.sees();
    assert!(!field(&screen, "Speed of the", "1500 rpm").contains('●'), "{screen}");
    person.types("}s");
    let wanted = before.replace("mass = \"m + 2 kg\"", "mass = \"m + 2 kg\"\nspeed = \"1200 rpm\"");
    assert_eq!(fs::read_to_string(&path).expect("the file"), wanted);
    // More, less, another unit: of the configuration alone.
    person.types("+");
    assert!(person.sees().contains("1201 rpm"), "{}", person.sees());
    person.types("z");
    assert_eq!(shown(&person), "fan.weighted");
    assert!(person.sees().contains("1200 rpm"), "{}", person.sees());
    // x returns to the problem, and so does an empty text; undo takes that back on the same tab.
    person.types("x");
    assert!(person.sees().contains("1500 rpm"), "{}", person.sees());
    person.types("z");
    assert!(person.sees().contains("1200 rpm"), "{}", person.sees());
    person.types("<del><enter>s");
    assert_eq!(fs::read_to_string(&path).expect("the file"), before);
    // The last change of a configuration leaves it there, equal to the problem.
    move_to(&mut person, "fan.mass");
    person.types("xs");
    assert_eq!(shown(&person), "fan.weighted");
    let wanted = before.replace("mass = \"m + 2 kg\"\n", "");
    assert_eq!(fs::read_to_string(&path).expect("the file"), wanted);
    // A choice is changed in the problem alone; N and A are of the problem.
    move_to(&mut person, "fan.damping");
    person.types("<enter>");
    assert!(person.sees().contains("change this in the problem itself"), "{}", person.sees());
    assert!(person.model.dialog.is_none());
    person.types("N");
    assert_eq!(shown(&person), "fan");
}

#[test]
fn an_error_of_a_configuration_is_on_its_tab() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut person = with_fan_on_bracket(folder.path(), 120, 40);
    person.types("}}");
    move_to(&mut person, "fan.mass");
    person.types("<enter><c-u>m - 50 kg<enter>");
    let screen = person.sees();
    assert!(screen.contains("must be above zero"), "{screen}");
    assert_eq!(shown(&person), "fan.weighted");
    person.types("{");
    assert!(tabs(&mut person).contains("✗fan.weighted"), "{}", person.sees());
    assert!(!tabs(&mut person).contains("✗fan "), "{}", person.sees());
}

#[test]
fn a_configuration_is_begun_by_name() {
    let mut person = Person::at(100, 20).opens(FAN);
    person.types("}");
    assert!(person.sees().contains("one problem without configurations"), "{}", person.sees());
    person.types(":configuration weighted<enter>");
    assert_eq!(shown(&person), "weighted");
    assert!(tabs(&mut person).contains("Base problem weighted"), "{}", person.sees());
    // Both have the same natural frequency until something is changed.
    let screen = person.sees();
    assert_eq!(screen.matches("106.23 ").count(), 1, "{screen}");
    assert!(screen.lines().nth(3).is_some_and(|line| line.contains("weighted")), "{screen}");
    move_to(&mut person, "mass");
    person.types("<enter><c-u>m + 2 kg<enter>");
    assert!(person.sees().contains("103.67 "), "{}", person.sees());
    person.types(":configuration 2<enter>");
    assert!(person.sees().contains("a name of letters and digits is needed"), "{}", person.sees());
    person.types("<esc>zz");
    assert!(!tabs(&mut person).contains("weighted"), "{}", person.sees());
}

/// Natural frequency of a mass on a bar of steel, 0.5 m long, 60 mm by 10 mm.
fn on_the_bar(mass: f64) -> f64 {
    let stiffness = 3.0 * 210e9 * (0.06 * 0.01f64.powi(3) / 12.0) / 0.5f64.powi(3);
    (stiffness / mass).sqrt()
}

fn answer(person: &Person, name: &str) -> f64 {
    let problem = &person.model.bench.as_ref().expect("a problem is open").problem;
    assert!(!problem.is_stale(), "{:?}", problem.found.failure);
    let solution = problem.found.solution.as_ref().expect("it is solved");
    let answer = solution.answer(name).unwrap_or_else(|| panic!("there is no answer {name}"));
    answer.si().expect("a number")
}

fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() <= 1e-9 * wanted.abs(), "{found} in place of {wanted}");
}

/// Types a text in the field at a path.
fn enter(person: &mut Person, path: &str, text: &str) {
    move_to(person, path);
    person.types("<enter><c-u>").types(text).types("<enter>");
}

/// Chooses an alternative of the field at a path by its name on the screen.
fn choose(person: &mut Person, path: &str, name: &str) {
    move_to(person, path);
    person.types("<enter>");
    let options = match &person.model.dialog {
        Some(dalembert_tui::dialog::Dialog::Choice { options, .. }) => options.clone(),
        _ => panic!("no options:\n{}", person.sees()),
    };
    let at = options.iter().position(|option| option.label == name);
    let at = at.unwrap_or_else(|| panic!("{name} is no option:\n{}", person.sees()));
    person.types("<home>").types(&"<down>".repeat(at)).types("<enter>");
}

#[test]
fn an_exam_question_of_several_steps_is_entered_without_an_editor() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("exam.toml");
    let mut person = Person::at(120, 40).opens(FAN);
    // The fan stands on a support of known stiffness; it is a problem among several from now on.
    choose(&mut person, "support", "Stiffness given");
    enter(&mut person, "support.stiffness.stiffness", "400 kN/m");
    enter(&mut person, "mass", "40 kg");
    person.types(":problem fan<enter>");
    assert!(person.sees().contains("the problem is called fan now"), "{}", person.sees());
    near(answer(&person, "fan.natural_frequency"), 100.0);
    // A bracket more, by words; the best match is the first that is offered.
    person.types(":problem bracket equivalent stiffness<enter>");
    assert!(person.sees().contains("vibration/equivalent-stiffness"), "{}", person.sees());
    person.types("<enter>");
    assert_eq!(shown(&person), "bracket");
    assert!(tabs(&mut person).contains("fan bracket All problems"), "{}", person.sees());
    let springs = "bracket.motion.translation.springs";
    choose(&mut person, "bracket.motion", "Along a line");
    choose(&mut person, springs, "Cantilever");
    enter(&mut person, &format!("{springs}.cantilever.length"), "0.5 m");
    enter(&mut person, &format!("{springs}.cantilever.young"), "210 GPa");
    choose(&mut person, &format!("{springs}.cantilever.section"), "Rectangle");
    enter(&mut person, &format!("{springs}.cantilever.section.rectangle.breadth"), "60 mm");
    enter(&mut person, &format!("{springs}.cantilever.section.rectangle.height"), "10 mm");
    enter(&mut person, "fan.support.stiffness.stiffness", "bracket.stiffness");
    near(answer(&person, "fan.natural_frequency"), on_the_bar(40.0));
    // A configuration of the fan, and a question over all.
    move_to(&mut person, "fan.mass");
    person.types(":configuration weighted<enter>");
    assert_eq!(shown(&person), "fan.weighted");
    enter(&mut person, "fan.mass", "m + 2 kg");
    near(answer(&person, "fan.weighted.natural_frequency"), on_the_bar(42.0));
    person
        .clicks("All problems")
        .types("A<enter>drop<tab><enter>fan.weighted.natural_frequency/fan.natural_frequency<enter>");
    near(answer(&person, "drop"), (40.0f64 / 42.0).sqrt());
    // One file, which says the same when it is read again.
    person.types("S<c-u>").types(path.to_str().expect("readable")).types("<enter>");
    assert!(person.sees().contains("saved as"), "{}", person.sees());
    let text = fs::read_to_string(&path).expect("the file");
    assert_eq!(text.matches("analysis = ").count(), 2, "{text}");
    let mut again = Person::at(120, 40).opens_file(&path);
    near(answer(&again, "drop"), (40.0f64 / 42.0).sqrt());
    assert!(tabs(&mut again).contains("fan fan.weighted bracket All problems"), "{}", again.sees());
    assert!(!again.model.bench.as_ref().expect("open").problem.is_unsaved());
    // All of it is undone, to the problem that it began as.
    person.types(&"z".repeat(30));
    assert!(!person.sees().contains("bracket"), "{}", person.sees());
    person.types(&"Z".repeat(30));
    near(answer(&person, "drop"), (40.0f64 / 42.0).sqrt());
}

const COMMENTED: &str = r#"# A fan.
format = 2
analysis = "vibration/rotating-unbalance"

[let]
bolt = "12 g" # of steel

[inputs] # measured
mass = "40 kg" # on a scale
unbalance = "bolt * 120 mm"
support.stiffness.stiffness = "25.2 kN/m"
damping.ratio.ratio = "0.05"
speed = "1500 rpm"

[show]
amplitude = "um"
"#;

#[test]
fn a_file_that_is_linked_to_another_problem_keeps_its_comments() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fan.toml");
    fs::write(&path, COMMENTED).expect("written");
    let mut person = Person::at(120, 40).opens_file(&path);
    person.types(":problem fan<enter>");
    assert!(person.sees().contains("µm"), "{}", person.sees());
    person.types("s");
    let wanted = COMMENTED
        .replace("analysis =", "\n[problem.fan]\nanalysis =")
        .replace("[let]", "[problem.fan.let]")
        .replace("[inputs]", "[problem.fan.inputs]")
        .replace("[show]", "[problem.fan.show]");
    assert_eq!(fs::read_to_string(&path).expect("the file"), wanted);
    // Undone and saved, it is the file that it was.
    person.types("zs");
    let text = fs::read_to_string(&path).expect("the file");
    assert!(!text.contains("[problem"), "{text}");
    let (before, after) = (file::parse(COMMENTED).expect("read"), file::parse(&text).expect("read"));
    assert_eq!((before.draft, before.show), (after.draft, after.show));
    // The name of another problem, and an analysis that there is none of, are asked for again.
    person.types(":problem fan<enter>:problem fan tolerance<enter>");
    assert!(person.sees().contains("two linked problems are called `fan`"), "{}", person.sees());
    person.types("<c-u>base qqqq<enter>");
    assert!(person.sees().contains("no analysis is found for `qqqq`"), "{}", person.sees());
}

const BEAM: &str = r#"format = 2
analysis = "vibration/equivalent-stiffness"
[inputs]
motion.translation.springs.cantilever = { length = "0.5 m", young = "210 GPa", section.rectangle = { breadth = "60 mm", height = "10 mm" } }
"#;

const ON_BEAM: &str = r#"format = 2
analysis = "vibration/rotating-unbalance"
[inputs]
mass = "40 kg"
unbalance = "0.1 kg m"
support.stiffness.stiffness = "@parts/beam.toml:stiffness"
damping.ratio.ratio = "0.05"
speed = "1500 rpm"
"#;

/// A fan on the beam of another file, in a folder.
fn with_beam(folder: &Path) -> std::path::PathBuf {
    fs::create_dir(folder.join("parts")).expect("a folder");
    fs::write(folder.join("parts/beam.toml"), BEAM).expect("written");
    fs::write(folder.join("fan.toml"), ON_BEAM).expect("written");
    folder.join("fan.toml")
}

#[test]
fn a_linked_file_is_used_as_it_is_open() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = with_beam(folder.path());
    let mut person = Person::at(120, 40).opens_file(&path);
    near(answer(&person, "natural_frequency"), on_the_bar(40.0));
    // Its tab shows what it is, to be changed in its own file.
    person.types("}");
    assert!(tabs(&mut person).contains("@parts/beam.toml"), "{}", person.sees());
    assert!(person.sees().contains("0.5 m"), "{}", person.sees());
    move_to(&mut person, "beam.motion.translation.springs.cantilever.length");
    person.types("1");
    assert!(person.sees().contains("changed in that file"), "{}", person.sees());
    person.types("x");
    near(answer(&person, "natural_frequency"), on_the_bar(40.0));
    // Enter opens it; a beam of twice the height, not saved, is that of the fan at once.
    person.types("<enter>");
    assert_eq!(person.model.problems().len(), 2, "{}", person.sees());
    enter(&mut person, "motion.translation.springs.cantilever.section.rectangle.height", "20 mm");
    person.types("b");
    let said = "linked file parts/beam.toml is used as it is open, with unsaved changes";
    let flat = |person: &mut Person| person.sees().split_whitespace().collect::<Vec<_>>().join(" ");
    near(answer(&person, "natural_frequency"), 8.0f64.sqrt() * on_the_bar(40.0));
    assert!(flat(&mut person).contains("is used as it is open"), "{}", person.sees());
    // That is no change of the fan, and undo has nothing to take back.
    assert!(!person.model.bench.as_ref().expect("open").problem.is_unsaved());
    person.types("z");
    assert!(person.sees().contains("nothing to undo"), "{}", person.sees());
    // The report states it too.
    let report = folder.path().join("fan.md");
    person.types("X<c-u>").types(report.to_str().expect("readable")).types("<enter>");
    let report = fs::read_to_string(&report).expect("the report");
    assert!(report.contains("as it is open, with unsaved changes, SHA-256"), "{report}");
    // Saved, it is a linked file like any other.
    person.types("bsb");
    near(answer(&person, "natural_frequency"), 8.0f64.sqrt() * on_the_bar(40.0));
    assert!(!flat(&mut person).contains(said) && !flat(&mut person).contains("is used as it is open"));
    // A fan that is opened now finds what is open and not saved.
    person.types("b");
    enter(&mut person, "motion.translation.springs.cantilever.section.rectangle.height", "10 mm");
    person.types("b").types("B");
    let mut person = person.opens_file(&path);
    near(answer(&person, "natural_frequency"), on_the_bar(40.0));
    assert!(flat(&mut person).contains("is used as it is open"), "{}", person.sees());
    // Given up, what is in the file counts.
    person.types("b").types("B<down><enter>");
    near(answer(&person, "natural_frequency"), 8.0f64.sqrt() * on_the_bar(40.0));
}

#[test]
fn unsaved_work_is_recovered_with_its_links() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = with_beam(folder.path());
    let mut person = Person::at(120, 40).opens_file(&path);
    enter(&mut person, "mass", "50 kg");
    let text = person.kept.values().next().expect("it is kept").clone();
    let recovered = |folder: &Path| {
        let state = folder.join("autosave");
        let autosave = Autosave::in_folder(state.clone()).expect("a folder of its own");
        autosave.note(1, Some(&path), text.clone());
        autosave.flush().expect("written");
        let file = fs::read_dir(&state).expect("there").flatten().next().expect("it is kept").path();
        // As if it had begun at another time: the process of this number is another one now.
        let kept = fs::read_to_string(&file).expect("readable");
        let (before, after) = kept.split_once(" began=").expect("the header has it");
        fs::write(file, format!("{before} began=1{after}")).expect("written");
        let mut next = Person::at(120, 40);
        next.happens(Msg::Crashed(Autosave::in_folder(state).expect("there").crashed()));
        next.types("<enter>");
        next
    };
    let mut next = recovered(folder.path());
    near(answer(&next, "natural_frequency"), on_the_bar(50.0));
    assert!(tabs(&mut next).contains("@parts/beam.toml"), "{}", next.sees());
    assert!(next.model.bench.as_ref().expect("open").problem.is_unsaved());
    // Without the linked file, everything that was typed is there; its place says what is missing.
    fs::remove_file(folder.path().join("parts/beam.toml")).expect("removed");
    let mut next = recovered(folder.path());
    let screen = next.sees();
    assert!(screen.contains("50 kg") && screen.contains("the linked file is not read yet"), "{screen}");
}

#[test]
fn names_of_rows_are_followed_within_a_linked_problem() {
    let mut person = Person::at(100, 40).opens("vibration/spring-network");
    let text = |person: &Person, path: &str| {
        let problem = &person.model.bench.as_ref().expect("a problem is open").problem;
        match problem.inputs.form.draft.at(&problem.entry().shape(), path) {
            Ok((dalembert_core::Draft::Leaf(text), _)) => text.clone(),
            _ => panic!("{path} is no text"),
        }
    };
    person.types(":problem net<enter>");
    assert_eq!(text(&person, "net.loaded"), text(&person, "net.nodes[1].name"));
    enter(&mut person, "net.nodes[1].name", "cart");
    assert_eq!(text(&person, "net.loaded"), "cart");
    assert!(person.model.bench.as_ref().is_some_and(|bench| bench.problem.wrong().next().is_none()));
    // The names are offered for a reference.
    move_to(&mut person, "net.loaded");
    person.types("<enter>");
    assert!(person.sees().contains("Choose one") && person.sees().contains("cart"), "{}", person.sees());
}

#[test]
fn a_link_that_is_typed_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = with_beam(folder.path());
    fs::write(&path, ON_BEAM.replace("@parts/beam.toml:stiffness", "400 kN/m")).expect("written");
    let mut person = Person::at(120, 40).opens_file(&path);
    near(answer(&person, "natural_frequency"), 100.0);
    enter(&mut person, "support.stiffness.stiffness", "@parts/beam.toml:stiffness");
    near(answer(&person, "natural_frequency"), on_the_bar(40.0));
    assert!(tabs(&mut person).contains("Base problem @parts/beam.toml"), "{}", person.sees());
    person.types("z");
    near(answer(&person, "natural_frequency"), 100.0);
    person.types("Zs");
    assert_eq!(fs::read_to_string(&path).expect("the file"), ON_BEAM);
    // Saved in another folder, it links to what lies there.
    let other = folder.path().join("other");
    fs::create_dir_all(other.join("parts")).expect("a folder");
    fs::write(other.join("parts/beam.toml"), BEAM.replace("10 mm", "20 mm")).expect("written");
    person.types("S<c-u>").types(other.join("fan.toml").to_str().expect("readable")).types("<enter>");
    near(answer(&person, "natural_frequency"), 8.0f64.sqrt() * on_the_bar(40.0));
    person.types("S<c-u>").types(path.to_str().expect("readable")).types("<enter><down><enter>");
    near(answer(&person, "natural_frequency"), on_the_bar(40.0));
    // One that is not there is named.
    enter(&mut person, "support.stiffness.stiffness", "@parts/bar.toml:stiffness");
    assert!(person.sees().contains("bar.toml not found"), "{}", person.sees());
    // A problem without a file is saved first.
    let mut person = Person::at(120, 40).opens(FAN);
    choose(&mut person, "support", "Stiffness given");
    enter(&mut person, "mass", "40 kg");
    enter(&mut person, "support.stiffness.stiffness", "@parts/beam.toml:stiffness");
    assert!(person.sees().contains("the linked file is not read yet"), "{}", person.sees());
    let path = folder.path().join("other.toml");
    person.types("S<c-u>").types(path.to_str().expect("readable")).types("<enter>");
    near(answer(&person, "natural_frequency"), on_the_bar(40.0));
}

#[test]
fn a_part_of_a_file_is_removed() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut person = with_fan_on_bracket(folder.path(), 120, 40);
    let path = folder.path().join("fan.toml");
    let before = fs::read_to_string(&path).expect("the file");
    let remove = ":remove this configuration or linked problem<enter>";
    // A configuration; what names it has no value.
    person.types("}}").types(remove);
    assert!(tabs(&mut person).contains("bracket fan All problems"), "{}", person.sees());
    assert!(shown(&person) == "fan" && person.sees().contains("drop: no value"), "{}", person.sees());
    person.types("z");
    assert!(tabs(&mut person).contains("fan.weighted"), "{}", person.sees());
    // A problem, with its configurations; the fan takes its stiffness from it no more.
    person.types("}".repeat(4).as_str());
    while shown(&person) != "bracket" {
        person.types("}");
    }
    person.types(remove);
    assert!(tabs(&mut person).starts_with(" ✗fan fan.weighted All problems"), "{}", person.sees());
    enter(&mut person, "fan.support.stiffness.stiffness", "400 kN/m");
    enter(&mut person, "ask[1].formula", "fan.X/fan.weighted.X");
    near(answer(&person, "fan.natural_frequency"), 100.0);
    person.types("s");
    let text = fs::read_to_string(&path).expect("the file");
    assert!(!text.contains("[problem.bracket") && text.contains("[problem.fan]"), "{text}");
    // The last one stays.
    person.types("{{{");
    while shown(&person) != "fan" {
        person.types("}");
    }
    person.types(remove);
    assert!(person.sees().contains("one of several problems, can be removed"), "{}", person.sees());
    person.types("zzzs");
    // The problem stands behind the others in the file now, and says the same.
    let [before, again] = [before, fs::read_to_string(&path).expect("the file")].map(|text| {
        let problem = file::parse(&text).expect("it is read");
        ["bracket", "fan", "let", "ask"]
            .map(|name| problem.draft.at(&problem.entry.shape(), name).expect("a part").0.clone())
    });
    assert_eq!(before, again);
}
