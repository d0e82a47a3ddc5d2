//! Study plans between the workbench and the command line.

use std::fs;

use dalembert_tests::person::Person;
use serde_json::Value as Json;

use crate::study::{example, printed};

/// A plan that is tried in the workbench runs on the command line unchanged, and back.
#[test]
fn a_plan_of_the_workbench_runs_on_the_command_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let fan = folder.path().join("fan.toml");
    fs::copy(xtask::root().join("examples/fan.toml"), &fan).expect("an example");
    let mut person = Person::at(120, 36).opens_file(&fan);
    person.turns_to("Study");
    // Tolerances of every input, with a limit; the file that is proposed.
    person.types("<left><down>a<end><up><up><up><enter><c-u>amplitude > 20 mm<enter>");
    person.types("w<enter>");
    assert!(person.sees().contains("study plan written to"), "{}", person.sees());
    let written = fs::read_to_string(folder.path().join("fan_study.toml")).expect("a plan");
    assert!(
        written.starts_with("problem = \"fan.toml\"\nanswers = [\"amplitude\"]\nsamples = 2000\n"),
        "{written}"
    );
    let json: Json =
        serde_json::from_str(&printed(folder.path(), &["fan_study.toml", "--json"])).expect("JSON");
    let limit = &json["answers"][0]["exceedances"][0];
    let share = 100.0 * limit["probability"].as_f64().expect("a probability");
    assert!(share > 1.0 && share < 99.0, "{limit}");
    let screen = person.types("e").sees();
    // Shares are shown to three digits.
    let said = screen.split("above 20 mm: ").nth(1).and_then(|rest| rest.split(' ').next());
    let said: f64 = said.and_then(|said| said.parse().ok()).unwrap_or_else(|| panic!("{share}: {screen}"));
    assert!((said - share).abs() <= 0.0501, "{said} {share}");
    // Back: a comment stays, a change of the file is shown, and what is changed on the screen is reported.
    let commented = format!("# from the bench\n{}", written.replace("samples = 2000", "samples = 500 # few"));
    fs::write(folder.path().join("fan_study.toml"), &commented).expect("a plan");
    person.types("rfan_study.toml<enter>");
    let screen = person.sees();
    assert!(screen.contains("plan fan_study.toml ▾") && screen.contains("500"), "{screen}");
    person.types("<home>").types(&"<down>".repeat(12)).types("<up>250<enter>");
    assert!(person.sees().contains("plan fan_study.toml (changed)"), "{}", person.sees());
    person.types("w");
    assert!(person.sees().contains("study plan written to"), "{}", person.sees());
    let saved = fs::read_to_string(folder.path().join("fan_study.toml")).expect("a plan");
    assert_eq!(saved, commented.replace("samples = 500", "samples = 250"));
    // The example has a grid, distributions and a limit: it is written as it was.
    let example = fs::read_to_string(xtask::root().join("examples/fan_study.toml")).expect("an example");
    fs::write(folder.path().join("example.toml"), &example).expect("a plan");
    person.types("rexample.toml<enter>");
    assert!(person.sees().contains("600..1800 rpm:5"), "{}", person.sees());
    person.types("w");
    assert_eq!(fs::read_to_string(folder.path().join("example.toml")).expect("a plan"), example);
}

#[test]
fn a_file_that_is_no_plan_changes_nothing() {
    let folder = example();
    let mut person = Person::at(120, 36).opens_file(folder.path().join("fan.toml"));
    person.turns_to("Study");
    let before = person.sees();
    for (text, why) in [
        ("problem = \"fan.toml\"\n[[vary]]\ninput = \"mass\"\nvalue = 3\n", "line 4: unknown field `value`"),
        ("analysis = \"vibration/free-vibration\"\n", "this is a problem file"),
        ("problem = \"fan.toml\"\nseed =\n", "line 2"),
    ] {
        fs::write(folder.path().join("broken.toml"), text).expect("a file");
        let screen = person.types("rbroken.toml<enter>").sees();
        assert!(screen.contains(why), "{why}: {screen}");
        assert_eq!(fs::read_to_string(folder.path().join("broken.toml")).expect("a file"), text);
        person.types("<esc>");
        assert_eq!(person.sees(), before);
    }
    // A plan that does not fit the problem is shown, with each error at its line, and may be repaired.
    let unfit = "problem = \"fan.toml\"\nanswers = [\"amplitud\"]\n[[vary]]\ninput = \"mas\"\nvalues = [1]\n[[vary]]\ninput = \"speed\"\nfrom = \"3 s\"\nto = \"900 rpm\"\npoints = 3\n";
    fs::write(folder.path().join("broken.toml"), unfit).expect("a file");
    let screen = person.types("rbroken.toml<enter>").sees();
    assert!(screen.contains("`mass`?") && screen.contains("from: "), "{screen}");
    person.types("<home><down><down><right><down><del>600..900 rpm<enter>");
    assert!(person.sees().contains("`amplitude`?"), "{}", person.sees());
    person.types("<home><down><right>");
    let screen = person.sees();
    assert!(!screen.contains("did you mean") && screen.contains("minimum"), "{screen}");
}

/// Parts of a plan that the workbench does not show are written as they were read.
#[test]
fn maps_and_indices_outlive_the_workbench() {
    let folder = example();
    let path = folder.path().join("fan_study.toml");
    let plan = "problem = \"fan.toml\"\nanswers = [\"amplitude\"]\nsamples = 64\nsampling = \"sobol\"\nseed = 1\nsobol_indices = true\n\n[[vary]]\ninput = \"mass\"\ndistribution = \"normal\"\ndeviation = \"2 %\"\n\n[[vary]]\ninput = \"speed\"\ndistribution = \"uniform\"\ntolerance = \"5 %\"\n\n[[map]]\ninputs = [\"speed\", \"mass\"]\n";
    fs::write(&path, plan).expect("a plan");
    let mut person = Person::at(120, 36).opens_file(folder.path().join("fan.toml"));
    person.turns_to("Study");
    person.types("rfan_study.toml<enter>");
    assert!(person.sees().contains("plan fan_study.toml"), "{}", person.sees());
    person.types("<end><enter><c-u>7<enter>w");
    assert_eq!(fs::read_to_string(&path).expect("a plan"), plan.replace("seed = 1", "seed = 7"));
    let json: Json =
        serde_json::from_str(&printed(folder.path(), &["fan_study.toml", "--json"])).expect("JSON");
    assert_eq!(json["answers"][0]["sobol_indices"]["samples"], 64);
}
