//! Studies of a permitted set: both branches, and the reason of a gap.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::path::PathBuf;

use dalembert_plugins as _;
use dalembert_tests::person::Person;
use tempfile::{TempDir, tempdir};

/// Turns to a tab of the results.
fn at(mut person: Person, tab: &str) -> Person {
    person.types("<tab>");
    person.turns_to(tab);
    person
}

/// A shaft with a clearance and negligible damping: diameters up to one limit and from another are permitted.
fn shaft(folder: &TempDir) -> PathBuf {
    let path = folder.path().join("shaft.toml");
    let text = r#"analysis = "vibration/shaft-clearance"
format = 2

[inputs]
mass = "250 kg"
clearance = "5 mm"
damping.ratio.ratio = "0.1 %"
sought.diameter.unbalance = "5 kg*mm"
sought.diameter.speeds = { lowest = "600 rpm", highest = "6000 rpm", margin = "20 %" }
sought.diameter.shaft = { mounting = "cantilever", length = "2 m", young = "207 GPa" }
"#;
    std::fs::write(&path, text).unwrap();
    path
}

#[test]
fn both_branches_of_a_permitted_set_are_swept_together() {
    let folder = tempdir().unwrap();
    let mut person = at(Person::at(120, 40).opens_file(shaft(&folder)), "Study");
    // It begins with the clearance, which moves both limits.
    person.types("<tab><home><down><tab>[]");
    let screen = person.sees();
    assert!(screen.contains("Maximum diameter, supercritical operation"), "{screen}");
    assert!(screen.contains("Minimum diameter, subcritical operation"), "{screen}");
    let studied = person.model.bench.as_ref().unwrap().problem.studied().collect::<Vec<_>>();
    assert_eq!(studied.len(), 1, "one plot");
    let plot = studied[0];
    assert_eq!(plot.series.len(), 2, "{:?}", plot.title);
    let [soft, stiff] = ["soft_limit", "stiff_limit"].map(|name| {
        let solution = person.model.bench.as_ref().unwrap().problem.found.solution.as_ref().unwrap();
        solution.answer(name).unwrap().si().unwrap()
    });
    let marks: Vec<f64> = plot.marks.iter().map(|mark| mark.at.1).collect();
    assert_eq!(marks, [soft, stiff], "each branch is marked where the problem stands");
    let ends = plot.series.iter().map(|series| series.points.last().unwrap().1);
    assert!(ends.collect::<Vec<_>>().windows(2).all(|pair| pair[0] < pair[1]), "{:?}", plot.series);
}

/// From a damping on at which no shaft touches there are no limits of the diameter: that is the reason of the gap.
#[test]
fn a_gap_has_its_reason() {
    let folder = tempdir().unwrap();
    let mut person = at(Person::at(160, 45).opens_file(shaft(&folder)), "Study");
    person.types("<tab><home><down><down><down><tab>[]<home><down><down>");
    person.types("<enter><c-u>0.1 %..1 %:46<enter>");
    let screen = person.sees();
    assert!(screen.contains("no answer from 0.2"), "{screen}");
    assert!(screen.contains("the clearance is"), "{screen}");
    assert!(!screen.contains("no reason"), "{screen}");
}
