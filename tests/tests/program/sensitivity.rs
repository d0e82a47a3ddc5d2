//! `dalembert sensitivity`: closed forms of a product of powers, tolerances of the problem, a nonlinear answer.

use std::process::Output;

use serde_json::Value as Json;

const FAN: &str = "vibration/rotating-unbalance";

fn run(arguments: &[&str]) -> Output {
    crate::program().arg("sensitivity").args(arguments).output().expect("the program runs")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&[&output.stdout[..], &output.stderr[..]].concat()).into_owned()
}

fn json(arguments: &[&str]) -> Json {
    let output = run(&[arguments, &["--format", "json"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", said(&output));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

fn input<'j>(found: &'j Json, path: &str) -> &'j Json {
    let all = found["inputs"].as_array().expect("inputs");
    all.iter().find(|one| one["path"] == path).unwrap_or_else(|| panic!("no {path} in {found:#}"))
}

fn assert_near(found: &Json, expected: f64, within: f64) {
    let found = found.as_f64().unwrap_or_else(|| panic!("{found} is not a number"));
    assert!((found / expected - 1.0).abs() < within, "{found} in place of {expected}");
}

/// `ω = √(3 E I/(m L³))`: the elasticities are the exponents.
#[test]
fn the_natural_frequency_of_the_fan_is_a_product_of_powers() {
    let tolerances = ["--tolerance", "mass=2 %", "--tolerance", "support.cantilever.length=12 mm"];
    let found = json(&[&[FAN, "natural_frequency"][..], &tolerances].concat());
    let value = found["value"].as_f64().expect("a value");
    for (path, exponent) in
        [("mass", -0.5), ("support.cantilever.length", -1.5), ("support.cantilever.young", 0.5)]
    {
        assert_near(&input(&found, path)["elasticity"], exponent, 1e-6);
    }
    assert_near(&input(&found, "mass")["derivative"]["value"], -0.5 * value / 40.0, 1e-6);
    assert_eq!(
        input(&found, "mass")["derivative"]["unit"],
        format!("{} / kg", found["unit"].as_str().unwrap())
    );
    // 12 mm is 1 % of the length of 1.2 m.
    let at = |mass: f64, length: f64| value / (mass * length.powi(3)).sqrt();
    assert_near(&found["worst_case"][0], at(1.02, 1.01), 1e-9);
    assert_near(&found["worst_case"][1], at(0.98, 0.99), 1e-9);
    let likely = (at(0.98, 1.0) - value).hypot(at(1.0, 0.99) - value);
    assert_near(&found["root_sum_square"], likely, 1e-9);
    assert_near(&input(&found, "mass")["at_tolerance"][1], at(1.02, 1.0), 1e-9);
    // The product of powers is nearly linear in 2 %: both ways to combine the tolerances agree.
    let interval = [0, 1].map(|n| found["monte_carlo"]["interval_95"][n].as_f64().unwrap());
    assert!((interval[1] - interval[0] - 2.0 * likely).abs() < 0.05 * 2.0 * likely, "{interval:?} {likely}");
    assert!(found["remarks"].as_array().unwrap().is_empty(), "{found:#}");
    assert_eq!(found["monte_carlo"]["samples"], 10_000);
    assert_eq!(json(&[&[FAN, "natural_frequency"][..], &tolerances].concat()), found, "seeded");
    let other = json(&[&[FAN, "natural_frequency", "--seed", "2"][..], &tolerances].concat());
    assert_ne!(other["monte_carlo"], found["monte_carlo"]);
    assert_eq!(other["worst_case"], found["worst_case"]);
}

#[test]
fn tolerances_of_the_problem_count_and_those_of_the_line_take_their_place() {
    let held = [FAN, "natural_frequency", "--case", "1", "--set", "mass=40 kg ± 5 %"];
    let found = json(&held);
    assert_near(&input(&found, "mass")["tolerance"], 2.0, 1e-12);
    assert_eq!(input(&found, "support.cantilever.length")["tolerance"], 0.0);
    let found = json(&[&held[..], &["--tolerance", "mass=1 kg"]].concat());
    assert_near(&input(&found, "mass")["tolerance"], 1.0, 1e-12);
    // Without any, every input has the usual one, which is said.
    let found = json(&[FAN, "natural_frequency"]);
    assert_near(&input(&found, "mass")["tolerance"], 0.4, 1e-12);
    assert!(found["remarks"][0].as_str().unwrap().starts_with("no tolerance is given: 1 %"), "{found:#}");
}

/// Close to the resonance the amplitude bends within the tolerance of the speed.
#[test]
fn a_nonlinear_answer_is_warned_of() {
    let asked = [FAN, "amplitude", "--tolerance", "speed=3 %"];
    let text = said(&run(&asked));
    for words in [
        "Amplitude at this speed = 19.456 mm",
        "worst case at the ends",
        "± 3",
        "Monte Carlo:",
        "warning: Monte Carlo and root",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let text = said(&run(&[&asked[..], &["--lang", "pt-BR"]].concat()));
    assert!(text.contains("Elasticidade") && text.contains("aviso: Monte Carlo"), "{text}");
    let csv = said(&run(&[&asked[..], &["--format", "csv"]].concat()));
    let rows: Vec<&str> = csv.lines().collect();
    assert!(rows[0].starts_with("input,value,unit,elasticity,derivative"), "{csv}");
    assert!(rows.iter().all(|row| row.matches(',').count() == 9), "{csv}");
    assert!(rows.iter().any(|row| row.starts_with("(Monte Carlo),")), "{csv}");
}

#[test]
fn the_main_answer_is_taken_where_none_is_named() {
    assert_eq!(json(&[FAN])["answer"], "amplitude");
}

#[test]
fn what_is_wrong_is_named_with_its_repair() {
    for (wrong, status, words) in [
        (&[FAN, "amplitud"][..], 2, "did you mean `amplitude`?"),
        (&[FAN, "--tolerance", "mass"], 2, "write an input and its tolerance, as in --tolerance mass='2 %'"),
        (&[FAN, "--tolerance", "mas=2 %"], 2, "did you mean `mass`?"),
        (&[FAN, "--tolerance", "mass=-2 %"], 2, "--tolerance mass=-2 %: a tolerance cannot be negative"),
        (&[FAN, "--tolerance", "mass=2 mm"], 2, "--tolerance mass=2 mm: "),
        (
            &[FAN, "--case", "1", "--set", "damping.largest-amplitude.amplitude=1 mm"],
            1,
            "no answer: the largest amplitude",
        ),
        (&["vibration/nothing"], 2, "vibration/nothing"),
    ] {
        let output = run(wrong);
        assert_eq!(output.status.code(), Some(status), "{wrong:?}: {}", said(&output));
        assert!(said(&output).contains(words), "{wrong:?}: {}", said(&output));
    }
}
