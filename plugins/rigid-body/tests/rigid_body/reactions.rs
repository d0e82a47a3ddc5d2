//! Reactions do not depend on how a problem is written down.

use dalembert_core::Solution;
use itertools::Itertools as _;

use crate::solved::{distance, number, size, sound, vector};

const SUPPORTS: &str = "supports = [\n\
    { name = \"A\", at = \"(0; 0; 0) m\", kind = \"thrust-bearing\" },\n\
    { name = \"B\", at = \"(0.8; 0; 0) m\", kind = { bearing = { shaft = \"(1; 0; 0)\" } } },\n]\n";

/// A skew body on a shaft along x.
fn body(about: &str) -> String {
    // Parallel axes by hand: m = 2 kg at (0.3, 0.05, −0.02) m.
    let (moments, products) = match about {
        "mass-centre" => ("(0.02; 0.03; 0.025)", "(0.002; -0.004; 0.003)"),
        _ => ("(0.0258; 0.2108; 0.21)", "(0; -0.016; 0.033)"),
    };
    let about =
        if about == "mass-centre" { "\"mass-centre\"" } else { "{ point = { point = \"(0; 0; 0) m\" } }" };
    format!(
        "body = {{ matrix = {{ mass = \"2 kg\", centre = \"(0.3; 0.05; -0.02) m\", moments = \"{moments} kg*m^2\", \
         products = \"{products} kg*m^2\", about = {about} }} }}\n"
    )
}

fn shaft(angle: f64, rate: f64, acceleration: f64) -> String {
    format!(
        "joints = [ {{ name = \"shaft\", axis = \"(1; 0; 0)\", motion = {{ now = {{ angle = \"{angle} deg\", \
         rate = \"{rate} rad/s\", acceleration = \"{acceleration} rad/s^2\" }} }} }} ]\n"
    )
}

const TURNING: &str = "axes = { frame = { frame = \"shaft\" } }\n";
const FIXED: &str = "axes = \"fixed\"\n";
const MOTION: &str = "drive = \"motion\"\n";

#[test]
fn reactions_are_the_same_in_turning_and_in_fixed_axes() {
    for angle in [0.0, 30.0, 111.0, 270.0] {
        let turning = solve(&[&body("mass-centre"), &shaft(angle, 40.0, 90.0), MOTION, TURNING, SUPPORTS]);
        let fixed = solve(&[&body("mass-centre"), &shaft(angle, 40.0, 90.0), MOTION, FIXED, SUPPORTS]);
        for n in 1..=2 {
            let a = vector(&turning, &format!("fixed_reaction[{n}]"));
            let b = vector(&fixed, &format!("reaction[{n}]"));
            assert!(distance(a, b) < 1e-12 * size(b), "{angle}°: {a:?} and {b:?}");
        }
        assert!((number(&turning, "drive_couple") - number(&fixed, "drive_couple")).abs() < 1e-12);
    }
}

#[test]
fn parallel_axes_there_and_back_leave_the_reactions() {
    let near = solve(&[&body("mass-centre"), &shaft(20.0, 40.0, 90.0), MOTION, TURNING, SUPPORTS]);
    let far = solve(&[&body("origin"), &shaft(20.0, 40.0, 90.0), MOTION, TURNING, SUPPORTS]);
    for name in ["reaction[1]", "reaction[2]"] {
        let (a, b) = (vector(&near, name), vector(&far, name));
        assert!(distance(a, b) < 1e-12 * size(a), "{name}: {a:?} and {b:?}");
    }
}

#[test]
fn the_couple_found_for_an_acceleration_brings_that_acceleration() {
    let found = solve(&[&body("mass-centre"), &shaft(20.0, 40.0, 90.0), MOTION, TURNING, SUPPORTS]);
    let couple = number(&found, "drive_couple");
    let drive = format!("drive = {{ couple = {{ couple = \"{couple:e} N*m\" }} }}\n");
    let back = solve(&[&body("mass-centre"), &shaft(20.0, 40.0, 0.0), &drive, TURNING, SUPPORTS]);
    assert!((number(&back, "angular_acceleration") - 90.0).abs() < 1e-10);
    for name in ["reaction[1]", "reaction[2]", "dynamic_reaction[1]"] {
        let (a, b) = (vector(&found, name), vector(&back, name));
        assert!(distance(a, b) < 1e-11 * size(a), "{name}: {a:?} and {b:?}");
    }
}

#[test]
fn dynamic_reactions_grow_with_the_square_of_the_speed_and_static_ones_do_not() {
    let at = |rate: f64| solve(&[&body("mass-centre"), &shaft(20.0, rate, 0.0), MOTION, TURNING, SUPPORTS]);
    let (slow, fast) = (at(10.0), at(-30.0));
    for n in 1..=2 {
        let (a, b) = (
            vector(&slow, &format!("dynamic_reaction[{n}]")),
            vector(&fast, &format!("dynamic_reaction[{n}]")),
        );
        assert!(distance(a.map(|x| 9.0 * x), b) < 1e-12 * size(b), "{a:?} and {b:?}");
        let name = format!("static_reaction[{n}]");
        assert!(distance(vector(&slow, &name), vector(&fast, &name)) < 1e-12 * 20.0);
    }
}

#[test]
fn every_frame_gives_the_same_rate_of_change() {
    let chain = "joints = [\n\
        { name = \"one\", axis = \"(0; 0; 1)\", motion = { now = { angle = \"20 deg\", rate = \"2 rad/s\", acceleration = \"1 rad/s^2\" } } },\n\
        { name = \"two\", axis = \"(1; 1; 0)\", motion = { now = { angle = \"50 deg\", rate = \"-3 rad/s\", acceleration = \"4 rad/s^2\" } } },\n\
        { name = \"three\", axis = \"(0; 1; 2)\", motion = { now = { angle = \"-70 deg\", rate = \"5 rad/s\" } }, offset = \"(0.1; 0.2; 0.3) m\" },\n]\n";
    for about in ["mass-centre", "origin"] {
        let about = format!("about = \"{about}\"\n");
        let sizes: Vec<[f64; 2]> = [
            "\"fixed\"",
            "{ frame = { frame = \"one\" } }",
            "{ frame = { frame = \"two\" } }",
            "{ frame = { frame = \"three\" } }",
        ]
        .into_iter()
        .map(|frame| {
            let frame = format!("frame = {frame}\n");
            let solution =
                solve_as("rigid-body/rate-of-change", &[&body("mass-centre"), chain, &frame, &about]);
            [number(&solution, "moment_size"), number(&solution, "angular_momentum_size")]
        })
        .collect();
        for other in &sizes[1..] {
            for (a, b) in sizes[0].iter().zip_eq(other) {
                assert!((a - b).abs() < 1e-12 * a, "{sizes:?}");
            }
        }
    }
}

fn solve(inputs: &[&str]) -> Solution {
    solve_as("rigid-body/reactions", inputs)
}

/// Solves, and holds the solution to its own checks.
fn solve_as(analysis: &str, inputs: &[&str]) -> Solution {
    let solution = crate::solved::solve(&format!("analysis = \"{analysis}\"\n[inputs]\n{}", inputs.concat()));
    sound(&solution);
    solution
}
