//! `dalembert find` with limits: intervals against closed forms, what limits them, and what is certified.

use std::process::Output;

use itertools::zip_eq;
use serde_json::Value as Json;

const FAN: &str = "vibration/rotating-unbalance";
/// Stiffness of the cantilever, mass, unbalance and largest amplitude of the fan of list 07, question 2, in SI.
const YOUNG_TIMES_MOMENT: f64 = 200e9 * 1.3e-6;
const MASS: f64 = 40.0;
const UNBALANCE: f64 = 0.1;
const PEAK: f64 = 0.0203;

fn run(arguments: &[&str]) -> Output {
    crate::program().arg("find").args(arguments).output().expect("the program runs")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&[&output.stdout[..], &output.stderr[..]].concat()).into_owned()
}

fn json(arguments: &[&str], status: i32) -> Json {
    let output = run(&[arguments, &["--json"]].concat());
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", said(&output));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// The ends of the intervals, and what limits them.
fn intervals(found: &Json) -> Vec<([f64; 2], [String; 2])> {
    let all = found["intervals"].as_array().expect("intervals");
    all.iter()
        .map(|one| {
            let limit = |n: usize| one["limited_by"][n].as_str().expect("a name").to_owned();
            (
                [one["from"].as_f64().expect("a number"), one["to"].as_f64().expect("a number")],
                [limit(0), limit(1)],
            )
        })
        .collect()
}

fn assert_near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} in place of {expected}");
}

/// The squares of the frequency ratios at which the amplitude of the fan is a wanted one: with `q = m X/(m₀e)` and
/// `u = r²`, `(1 − q²) u² + (2 − 4ζ²) q² u − q² = 0`, where `2ζ√(1 − ζ²) = m₀e/(m Xₘₐₓ)`.
fn squares_of_ratios(amplitude: f64) -> Vec<f64> {
    let s = (UNBALANCE / (MASS * PEAK)).powi(2) / 4.0;
    let damping = (1.0 - (1.0 - 4.0 * s).sqrt()) / 2.0;
    let q = (MASS * amplitude / UNBALANCE).powi(2);
    let (a, b) = (1.0 - q, (2.0 - 4.0 * damping) * q);
    let root = (b * b + 4.0 * a * q).sqrt();
    let mut all: Vec<f64> = [(-b + root) / (2.0 * a), (-b - root) / (2.0 * a)].to_vec();
    all.retain(|u| *u > 0.0);
    all.sort_by(f64::total_cmp);
    all
}

/// Question 07/2: the speeds at which the amplitude of the fan stays below 10 mm lie on both sides of the resonance.
#[test]
fn the_speeds_of_an_amplitude_are_those_of_the_quadratic_equation() {
    let natural = (3.0 * YOUNG_TIMES_MOMENT / 1.2f64.powi(3) / MASS).sqrt();
    let rpm = |u: f64| u.sqrt() * natural * 30.0 / std::f64::consts::PI;
    let [low, high] = squares_of_ratios(0.010)[..] else { panic!("two solutions") };
    let asked = [FAN, "speed", "amplitude<=10 mm", "--from", "100 rpm", "--to", "6000 rpm"];
    let found = json(&asked, 0);
    assert_eq!(found["verdict"], "limits");
    assert_eq!(found["proof"]["certified"], true, "{found:#}");
    assert!(found["proof"]["undecided_share"].as_f64().unwrap() <= 1e-6);
    let [(first, first_limits), (second, second_limits)] = &intervals(&found)[..] else {
        panic!("{found:#}")
    };
    assert_eq!(first_limits.each_ref().map(String::as_str), ["range", "equality"]);
    assert_eq!(second_limits.each_ref().map(String::as_str), ["equality", "range"]);
    assert_near(first[0], 100.0);
    assert_near(first[1], rpm(low));
    assert_near(second[0], rpm(high));
    assert_near(second[1], 6000.0);
    // The other direction is what lies between.
    let found = json(&[FAN, "speed", "amplitude >= 10 mm", "--from", "100 rpm", "--to", "6000 rpm"], 0);
    let [(between, limits)] = &intervals(&found)[..] else { panic!("{found:#}") };
    assert_eq!(limits.each_ref().map(String::as_str), ["equality", "equality"]);
    assert_near(between[0], rpm(low));
    assert_near(between[1], rpm(high));
    // The values themselves: two, proven to be all.
    let found = json(&[FAN, "speed", "amplitude=10 mm", "--from", "100 rpm", "--to", "6000 rpm"], 0);
    let solutions = found["proof"]["solutions"].as_array().expect("solutions");
    assert_eq!((solutions.len(), &found["proof"]["certified"]), (2, &Json::Bool(true)), "{found:#}");
    for (found, expected) in zip_eq(solutions, [rpm(low), rpm(high)]) {
        let [from, to] = [0, 1].map(|n| found[n].as_f64().unwrap());
        assert!(from <= expected * (1.0 + 1e-14) && expected * (1.0 - 1e-14) <= to, "{found} {expected}");
        assert!(to - from <= 1e-9 * expected, "{found}");
    }
}

/// Question 07/2 for the length of the cantilever: `L³ = 3 E I u/(m ω²)`.
#[test]
fn the_lengths_of_an_amplitude_are_those_of_the_quadratic_equation() {
    let speed = 1000.0 * std::f64::consts::PI / 30.0;
    let length = |u: f64| (3.0 * YOUNG_TIMES_MOMENT * u / (MASS * speed * speed)).cbrt();
    let [low, high] = squares_of_ratios(0.005)[..] else { panic!("two solutions") };
    let asked = [FAN, "support.cantilever.length", "amplitude<=5 mm", "--from", "0.2 m", "--to", "4 m"];
    let found = json(&asked, 0);
    assert_eq!(found["proof"]["certified"], true, "{found:#}");
    let [(first, _), (second, _)] = &intervals(&found)[..] else { panic!("{found:#}") };
    assert_near(first[1], length(low));
    assert_near(second[0], length(high));
    let text = said(&run(&asked));
    for words in
        ["≤ 5 mm, from 0.2 m to 4 m:", "end of the range; limit reached", "certified by interval arithmetic"]
    {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(text.contains("the same formulas were seen at 33 points of the range"), "{text}");
    let text = said(&run(&[&asked[..], &["--lang", "pt-BR"]].concat()));
    assert!(
        text.contains("certificado por aritmética intervalar") && text.contains("limite atingido"),
        "{text}"
    );
}

/// Question 08/3: the damping ratios with which no shaft lets the rotor move by more than 0.05 mm; the peak is
/// `e/(2ζ√(1 − ζ²))`, and from `ζ = 1/√2` on there is none.
#[test]
fn an_interval_ends_where_the_answer_does() {
    let eccentricity: f64 = 5e-3 / 250.0;
    let s = (eccentricity / 0.05e-3).powi(2) / 4.0;
    let least = ((1.0 - (1.0 - 4.0 * s).sqrt()) / 2.0).sqrt();
    let asked = ["vibration/shaft-clearance", "damping.ratio.ratio", "largest_amplitude<=0.05 mm"];
    let found = json(&[&asked[..], &["--from", "1 %", "--to", "95 %"]].concat(), 0);
    let [(ends, limits)] = &intervals(&found)[..] else { panic!("{found:#}") };
    assert_near(ends[0], 100.0 * least);
    assert_near(ends[1], 100.0 * std::f64::consts::FRAC_1_SQRT_2);
    assert_eq!(limits.each_ref().map(String::as_str), ["equality", "no-answer"]);
}

#[test]
fn limits_that_always_or_never_hold_are_named() {
    let range = ["--from", "100 rpm", "--to", "6000 rpm"];
    let always = [&[FAN, "speed", "amplitude<=21 mm"][..], &range].concat();
    assert_eq!(json(&always, 0)["verdict"], "not-a-constraint");
    assert!(said(&run(&always)).contains("not a constraint: every value of the range meets it"));
    let never = [&[FAN, "speed", "amplitude>=21 mm"][..], &range].concat();
    let found = json(&never, 1);
    assert_eq!((&found["verdict"], &found["proof"]["certified"]), (&"impossible".into(), &true.into()));
    let text = said(&run(&never));
    assert!(text.contains("impossible: no value of the range meets it; the answer lies between"), "{text}");
}

/// Without damping the amplitude has a pole at the resonance: beside it nothing is decided, in next to nothing of the range.
#[test]
fn a_pole_is_left_undecided() {
    let asked = [FAN, "speed", "amplitude<=10 mm", "--from", "100 rpm", "--to", "6000 rpm", "--case", "3"];
    let undamped = [&asked[..], &["--set", "damping.ratio.ratio=0"]].concat();
    let found = json(&undamped, 0);
    assert_eq!(intervals(&found).len(), 2, "{found:#}");
    assert!(found["proof"]["undecided_share"].as_f64().unwrap() <= 1e-6, "{found:#}");
    // Beside the pole the amplitude exceeds what any scan meets: 1000 km is reached where `u = q/(q ± 1)`.
    let limits = |limit: &'static str, status: i32| {
        json(&[&[FAN, "speed", limit][..], &undamped[3..]].concat(), status)
    };
    let found = limits("amplitude>=1000 km", 0);
    let [(below, _), (above, _)] = &intervals(&found)[..] else { panic!("{found:#}") };
    let natural = (3.0 * YOUNG_TIMES_MOMENT / 1.2f64.powi(3) / MASS).sqrt() * 30.0 / std::f64::consts::PI;
    let q = MASS * 1e6 / UNBALANCE;
    for (found, u) in [(below[0], q / (q + 1.0)), (above[1], q / (q - 1.0))] {
        assert!((found / (u.sqrt() * natural) - 1.0).abs() < 1e-12, "{found}");
    }
    assert_eq!(limits("amplitude>=10000000000 km", 1)["verdict"], "undecided");
}

#[test]
fn the_default_range_is_printed() {
    let text = said(&run(&[FAN, "speed", "amplitude<=10 mm"]));
    assert!(text.contains("from 1 rpm to 1×10⁶ rpm:"), "{text}");
}

#[test]
fn what_is_wrong_is_named_with_its_repair() {
    for (wrong, words) in [
        (&["spee", "amplitude<=1 mm"][..], "`spee` is not a number among the inputs; did you mean `speed`?"),
        (&["speed", "amplitud<=1 mm"], "did you mean `amplitude`?"),
        (&["speed", "amplitude<="], "a value is missing; write one in mm"),
        (&["speed", "amplitude<=3 kg"], "amplitude ≤ 3 kg: "),
        (
            &["speed", "amplitude<=3 mm", "--from", "9 rpm", "--to", "3 rpm"],
            "write --from and --to in ascending order",
        ),
        (&["speed", "amplitude<=3 mm", "--from", "9 kg", "--to", "3 rpm"], "--from 9 kg: "),
        (&["speed", "amplitude<=3 mm", "--from", "9 rpm"], "--to"),
        (&["speed"], "ANSWER=VALUE"),
    ] {
        let output = run(&[&[FAN][..], wrong].concat());
        assert_eq!(output.status.code(), Some(2), "{wrong:?}: {}", said(&output));
        assert!(said(&output).contains(words), "{wrong:?}: {}", said(&output));
    }
}
