//! Rules, symmetries and ways there and back of the gyroscopic couples.

use dalembert_core::Solution;

use crate::solved::{number, solve, sound};

#[test]
fn effects_of_a_rotor_clockwise_from_the_stern_are_those_of_the_textbooks() {
    for (motion, words) in [
        ("steady-turn = { speed = \"10 m/s\", radius = \"100 m\", towards = \"left\" }", "raises the bow"),
        ("steady-turn = { speed = \"10 m/s\", radius = \"100 m\", towards = \"right\" }", "lowers the bow"),
        ("pitching = { rate = \"0.1 rad/s\", bow = \"rising\" }", "turns the bow to starboard"),
        ("pitching = { rate = \"0.1 rad/s\", bow = \"falling\" }", "turns the bow to port"),
    ] {
        let solution = rotor("clockwise", "behind", motion);
        effect(&solution, words);
        // The same spin, seen from the other end.
        effect(&rotor("counter-clockwise", "ahead", motion), words);
        // The other spin has another effect.
        let other = rotor("counter-clockwise", "behind", motion);
        assert!(!labels(&other).any(|label| label.contains(words)), "{motion}");
        sound(&solution);
        sound(&other);
    }
}

#[test]
fn rolling_about_the_axle_has_no_effect_and_reports_it() {
    let solution = rotor("clockwise", "behind", "rolling = { rate = \"0.1 rad/s\", falling = \"left\" }");
    assert_eq!(number(&solution, "couple").abs(), 0.0);
    assert!(!labels(&solution).any(|label| label.starts_with("Effect")));
    assert!(solution.warnings.iter().any(|warning| warning.english().contains("no gyroscopic couple")));
}

#[test]
fn an_oblique_axle_without_its_transverse_moment_is_warned_of() {
    let motion = "any-precession = { precession = \"(0.1; 0; 0.2) rad/s\" }";
    let solution = rotor("clockwise", "behind", motion);
    assert!(solution.warnings.iter().any(|warning| warning.english().contains("not normal to the axle")));
}

#[test]
fn at_the_limiting_speed_one_wheel_carries_nothing() {
    let engines = [
        "",
        "engine = { inertia = \"2 kg*m^2\", ratio = \"4\", shaft = \"across-like-wheels\" }\n",
        "engine = { inertia = \"2 kg*m^2\", ratio = \"4\", shaft = \"across-against-wheels\" }\n",
        "engine = { inertia = \"2 kg*m^2\", ratio = \"4\", shaft = \"along-clockwise-from-front\" }\n",
        "engine = { inertia = \"2 kg*m^2\", ratio = \"4\", shaft = \"along-clockwise-from-rear\" }\n",
    ];
    for engine in engines {
        for bank in [0.0, 4.0, 15.0] {
            for side in ["left", "right"] {
                let limit = number(&car(engine, bank, side, None), "lifting_speed");
                let solution = car(engine, bank, side, Some(limit));
                let loads = ["front_inner_load", "rear_inner_load", "front_outer_load", "rear_outer_load"]
                    .map(|name| number(&solution, name));
                let least = loads.iter().copied().fold(f64::INFINITY, f64::min);
                assert!(least.abs() < 1e-9 * 14_715.0, "{engine}, {bank}°, {side}: {loads:?}");
                sound(&solution);
            }
        }
    }
}

#[test]
fn lean_and_speed_of_a_two_wheeler_lead_to_each_other() {
    for measured in ["centre-of-mass", "track"] {
        for difference in
            ["", "inertia_difference = \"-10 kg*m^2\"\n", "inertia_difference = \"20 kg*m^2\"\n"]
        {
            for degrees in [0.0, 1.0, 20.0, 45.0, 60.0] {
                let given =
                    two_wheeler(measured, difference, &format!("lean = {{ lean = \"{degrees} deg\" }}"));
                let speed = number(&given, "speed");
                let solution =
                    two_wheeler(measured, difference, &format!("speed = {{ speed = \"{speed} m/s\" }}"));
                let lean = number(&solution, "lean").to_degrees();
                assert!((lean - degrees).abs() < 1e-8, "{measured}, {difference}: {degrees}° and {lean}°");
                sound(&given);
                sound(&solution);
            }
        }
    }
}

#[test]
fn rate_and_reading_of_a_turn_indicator_lead_to_each_other() {
    for degrees in [0.0, 0.5, 10.0, 60.0, 85.0] {
        let reading = indicator(&format!("reading = {{ angle = \"{degrees} deg\" }}"));
        let rate = number(&reading, "rate_of_turn");
        let solution = indicator(&format!("rate = {{ rate = \"{rate} rad/s\" }}"));
        let angle = number(&solution, "angle").to_degrees();
        assert!((angle - degrees).abs() < 1e-8, "{degrees}° and {angle}°");
        sound(&solution);
        sound(&reading);
    }
}

fn rotor(sense: &str, seen_from: &str, motion: &str) -> Solution {
    solve(&format!(
        "analysis = \"rigid-body/gyroscopic-couple\"\n[inputs]\ncarrier = \"ship\"\n\
         rotor.moment-of-inertia = {{ inertia = \"100 kg*m^2\" }}\nspin = \"200 rad/s\"\nsense = \"{sense}\"\n\
         seen_from = \"{seen_from}\"\nmotion.{motion}\n"
    ))
}

fn car(engine: &str, bank: f64, side: &str, speed: Option<f64>) -> Solution {
    let speed = speed.map_or_else(String::new, |speed| format!("speed = \"{speed} m/s\"\n"));
    solve(&format!(
        "analysis = \"rigid-body/wheel-loads\"\n[inputs]\nmass = \"1500 kg\"\ncentre_height = \"0.6 m\"\n\
         track = \"1.5 m\"\nlayout.two-axles = {{ wheelbase = \"2.5 m\", behind_front = \"1.1 m\", front_share = \"0.55\" }}\n\
         wheel_radius = \"0.3 m\"\nwheels.each-wheel = {{ inertia = \"1 kg*m^2\" }}\n\
         transverse_inertia = \"1.4 kg*m^2\"\nradius = \"50 m\"\ntowards = \"{side}\"\nbank = \"{bank} deg\"\n{engine}{speed}"
    ))
}

fn two_wheeler(measured: &str, difference: &str, motion: &str) -> Solution {
    solve(&format!(
        "analysis = \"rigid-body/two-wheeler-lean\"\n[inputs]\nmass = \"250 kg\"\ncentre_height = \"0.6 m\"\n\
         wheel_radius = \"0.3 m\"\nwheel_inertia = \"1 kg*m^2\"\n\
         engine = {{ inertia = \"0.3 kg*m^2\", ratio = \"5\", sense = \"like\" }}\nradius = \"8 m\"\n\
         measured = \"{measured}\"\n{difference}motion.{motion}\n"
    ))
}

fn indicator(turn: &str) -> Solution {
    solve(&format!(
        "analysis = \"rigid-body/turn-indicator\"\n[inputs]\n\
         rotor.moments = {{ axial = \"0.002 kg*m^2\", transverse = \"0.0012 kg*m^2\" }}\nspin = \"60 rad/s\"\n\
         stiffness = \"100 N/m\"\nspacing = \"100 mm\"\nturn.{turn}\n"
    ))
}

fn labels(solution: &Solution) -> impl Iterator<Item = &str> {
    solution.answers.iter().map(|answer| answer.label)
}

fn effect(solution: &Solution, words: &str) {
    let all: Vec<&str> = labels(solution).collect();
    assert!(all.iter().any(|label| label.contains(words)), "{words}: {all:?}");
}
