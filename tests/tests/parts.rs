//! Problems, configurations and linked files of a problem file as tabs of the workbench.

use std::{fs, path::Path};

use dalembert_tests::person::Person;

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

/// The first line of the screen below its title: that of the tabs.
fn tabs(person: &mut Person) -> String {
    person.sees().lines().nth(1).expect("a line").to_owned()
}

#[test]
fn problems_and_configurations_are_tabs_that_change_each_other() {
    let folder = tempfile::tempdir().expect("a folder");
    for (columns, rows) in [(80, 24), (160, 45), (60, 20)] {
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
        let mass =
            screen.lines().find(|line| line.contains("m + 2 kg")).unwrap_or_else(|| panic!("{screen}"));
        assert!(mass.contains('●'), "{screen}");
        let speed =
            screen.lines().find(|line| line.contains("1500 rpm")).unwrap_or_else(|| panic!("{screen}"));
        assert!(!speed.contains('●'), "{screen}");
        // A mass of 50 kg on the tab of the fan: 52 kg on that of the configuration, 50 kg on the bracket.
        person.types("{");
        move_to(&mut person, "fan.mass");
        person.types("50<enter>}");
        assert_eq!(shown(&person), "fan.weighted");
        let form = &person.model.bench.as_ref().expect("open").problem;
        let found = form.found.solution.as_ref().expect("solved");
        assert_eq!(found.computed_input("fan.weighted.mass").map(|(si, _)| si), Some(52.0));
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
        // Tabs are clicked.
        person.clicks("fan.weighted");
        assert_eq!(shown(&person), "fan.weighted");
    }
}

#[test]
fn a_configuration_takes_what_is_typed_on_its_tab_and_gives_it_back() {
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
    let speed = screen.lines().find(|line| line.contains("1200 rpm")).unwrap_or_else(|| panic!("{screen}"));
    assert!(speed.contains('●'), "{screen}");
    assert!(screen.contains("1500 rpm in the problem itself"), "{screen}");
    person.types("{");
    assert!(person.sees().contains("1500 rpm") && !person.sees().contains('●'), "{}", person.sees());
    person.types("}s");
    let wanted = before.replace("mass = \"m + 2 kg\"", "mass = \"m + 2 kg\"\nspeed = \"1200 rpm\"");
    assert_eq!(fs::read_to_string(&path).expect("the file"), wanted);
    // More, less, another unit: of the configuration alone.
    person.types("+");
    assert!(person.sees().contains("1201 rpm"), "{}", person.sees());
    person.types("z");
    assert_eq!(shown(&person), "fan.weighted");
    assert!(person.sees().contains("1200 rpm"), "{}", person.sees());
    // x gives it back, and so does an empty text; undo takes that back on the same tab.
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
    let mut person = Person::at(100, 30).opens(FAN);
    person.types("}");
    assert!(person.sees().contains("one problem without configurations"), "{}", person.sees());
    person.types(":configuration weighted<enter>");
    assert_eq!(shown(&person), "weighted");
    assert!(tabs(&mut person).contains("Base problem weighted"), "{}", person.sees());
    // Both have the same natural frequency until something is changed.
    assert_eq!(person.sees().matches("106.23 rad/s").count(), 2, "{}", person.sees());
    move_to(&mut person, "mass");
    person.types("<enter><c-u>m + 2 kg<enter>");
    assert!(person.sees().contains("103.67 rad/s"), "{}", person.sees());
    person.types(":configuration 2<enter>");
    assert!(person.sees().contains("a name of letters and digits is needed"), "{}", person.sees());
    person.types("<esc>zz");
    assert!(!tabs(&mut person).contains("weighted"), "{}", person.sees());
}
