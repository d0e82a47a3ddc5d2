//! `dalembert optimise`: on the line, from a file, to a problem file, of two answers.

use std::{fs, path::Path, process::Output};

use serde_json::Value as Json;

fn optimise(folder: &Path, arguments: &[&str]) -> Output {
    crate::program().current_dir(folder).arg("optimise").args(arguments).output().expect("the program runs")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&[&output.stdout[..], &output.stderr[..]].concat()).into_owned()
}

/// The answers of a problem that is optimised, in SI.
fn answers(folder: &Path, arguments: &[&str]) -> Json {
    let output = optimise(folder, &[arguments, &["--format", "json"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", said(&output));
    let json: Json = serde_json::from_slice(&output.stdout).expect("JSON");
    json["answers"].clone()
}

fn number(answers: &Json, name: &str) -> f64 {
    answers[name]["si"].as_f64().unwrap_or_else(|| panic!("{name} is not a number in {answers:#}"))
}

/// Den Hartog's machine: what the analysis computes by the formulas of Nishihara and Asami is found by search.
#[test]
fn an_optimum_is_asked_for_on_the_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let line = [
        "vibration/damped-absorber",
        "--set",
        "main.ratio.ratio=0.25",
        "--vary",
        "absorber.given.tuning.ratio.ratio=0.5 .. 1.2",
        "--vary",
        "absorber.given.damping.by-absorber.ratio=0.05 .. 0.6",
        "--minimise",
        "peak",
    ];
    let found = answers(folder.path(), &line);
    let tuning = number(&found, "absorber.given.tuning.ratio.ratio");
    assert!((tuning / number(&found, "best_tuning") - 1.0).abs() < 1e-5, "{tuning}");
    assert!((number(&found, "peak") / number(&found, "best_peak") - 1.0).abs() < 1e-9, "{found:#}");
}

/// The problem with its optimum is a problem file like any other, and keeps comments and tolerances.
#[test]
fn an_optimum_is_written_as_a_problem() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::copy(xtask::root().join("examples/mounts_for_a_fan.toml"), folder.path().join("mounts.toml"))
        .expect("an example");
    let before = answers(folder.path(), &["mounts.toml"]);
    let output = optimise(folder.path(), &["mounts.toml", "-o", "best.toml"]);
    assert!(output.status.success(), "{}", said(&output));
    let written = fs::read_to_string(folder.path().join("best.toml")).expect("a problem");
    assert!(written.starts_with('#') && written.contains("± 5 %") && !written.contains("\"?"), "{written}");
    let solved = crate::program()
        .current_dir(folder.path())
        .args(["solve", "best.toml", "--format", "json"])
        .output()
        .expect("the program runs");
    assert!(solved.status.success(), "{}", said(&solved));
    let after: Json = serde_json::from_slice(&solved.stdout).expect("JSON");
    for name in ["transmitted_force", "price"] {
        assert_eq!(number(&before, name).to_bits(), number(&after["answers"], name).to_bits(), "{name}");
    }
    let again = optimise(folder.path(), &["mounts.toml", "-o", "best.toml"]);
    assert!(said(&again).contains("is a problem file"), "{}", said(&again));
}

#[test]
fn two_answers_have_a_front() {
    let folder = tempfile::tempdir().expect("a folder");
    let line = [
        "vibration/damped-absorber",
        "--set=main.ratio.ratio=0.1",
        "--vary=absorber.given.tuning.ratio.ratio=0.6 .. 1.1",
        "--vary=absorber.given.damping.by-absorber.ratio=0.05 .. 0.5",
        "--minimise=peak",
        "--minimise=stroke_ratio",
        "--format=csv",
        "--table=plot-1",
    ];
    let output = optimise(folder.path(), &line);
    assert!(output.status.success(), "{}", said(&output));
    let rows = String::from_utf8_lossy(&output.stdout).lines().count();
    assert!(rows > 10, "{}", said(&output));
}

#[test]
fn what_cannot_be_optimised_says_why() {
    let folder = tempfile::tempdir().expect("a folder");
    for (line, words) in [
        (&["vibration/rotating-unbalance"][..], "no answer is to be the least or the largest"),
        (&["vibration/rotating-unbalance", "--minimise", "amplitude"], "nothing is unknown"),
        (
            &["vibration/rotating-unbalance", "--vary", "mass", "--minimise", "amplitude"],
            "--vary mass: write an input",
        ),
        (
            &[
                "vibration/rotating-unbalance",
                "--vary",
                "mass=20 kg..100 kg",
                "--minimise",
                "amplitude",
                "--limit",
                "phase",
            ],
            "--limit phase: write an answer and a value",
        ),
        (
            &["vibration/rotating-unbalance", "--vary", "mass=20 kg..100 kg", "--minimise", "amplitud"],
            "no answer `amplitud`",
        ),
    ] {
        let output = optimise(folder.path(), line);
        assert_eq!(output.status.code(), Some(2), "{line:?}: {}", said(&output));
        assert!(said(&output).contains(words), "{line:?}: {}", said(&output));
    }
}
