//! The problem files in examples/ are read, solved, and answer what they should.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::{
    fs,
    path::{Path, PathBuf},
};

use dalembert_core::{Stop, file};
use dalembert_plugins as _;
use dalembert_units::read_any;

/// Agrees to half a unit of the last place.
fn answers(file_name: &str, expected: &[(&str, &str)]) {
    let text = fs::read_to_string(folder().join(file_name)).unwrap();
    let problem = file::parse(&text).unwrap_or_else(|errors| panic!("{file_name}: {errors:?}"));
    let record =
        problem.draft.read(&problem.entry.shape()).unwrap_or_else(|errors| panic!("{file_name}: {errors:?}"));
    let solution =
        problem.entry.solve(&record, &Stop::new()).unwrap_or_else(|err| panic!("{file_name}: {err}"));
    for (name, text) in expected {
        let wanted = read_any(text).unwrap();
        let ours = solution.answer(name).and_then(dalembert_core::Answer::si);
        let ours = ours.unwrap_or_else(|| panic!("{file_name} does not answer {name}"));
        let off = (ours - wanted.si).abs();
        assert!(off <= 0.5 * wanted.last_place * 1.000001, "{file_name}: {name} is {ours} in SI, not {text}");
    }
}

/// Closed form: k = 3EI/L³, ζ from the peak 1/(2ζ√(1 − ζ²)) = m X/(m₀e) = 8.12, X at r = 0.98579.
#[test]
fn the_fan() {
    answers(
        "fan.toml",
        &[("stiffness", "451389 N/m"), ("damping_ratio", "0.061694"), ("amplitude", "19.456 mm")],
    );
}

/// X = (m₀e/m) r²/√((1 − r²)² + (2ζr)²) with r = π/2, m₀eω², cω²X²/2 with c = 2ζ√(km), E/(2(1 + ν)).
#[test]
fn the_fan_with_questions() {
    answers(
        "fan_questions.toml",
        &[
            ("amplitude", "60.18930 um"),
            ("peak_to_peak", "120.3786 um"),
            ("force_amplitude", "35.53058 N"),
            ("power", "17.87756 mW"),
            ("shear_modulus", "80.76923 GPa"),
        ],
    );
}

/// m = k/(2π fₙ)², m₀e = X m √((1 − r²)² + (2ζr)²)/r².
#[test]
fn the_fan_with_unknowns() {
    answers("mass_from_frequency.toml", &[("mass", "126.51969 kg"), ("unbalance", "0.06056020 kg*m")]);
}

/// Σ m r z about each plane, with complex numbers; a drilled hole lies opposite to an added mass.
#[test]
fn the_rotor() {
    answers(
        "rotor.toml",
        &[
            ("mass_a", "0.0822662 kg"),
            ("angle_a", "35.2987°"),
            ("mass_b", "0.1154433 kg"),
            ("angle_b", "196.4067°"),
        ],
    );
}

/// k = 4 G d⁴/(8 D³ n), δ = ln 8/5, ζ = δ/√(4π² + δ²), ωₙ = ω_d/√(1 − ζ²), m = k/ωₙ².
#[test]
fn the_table() {
    answers(
        "table.toml",
        &[
            ("stiffness", "83.22634 kN/m"),
            ("damping_ratio", "0.06604616"),
            ("mass", "124.8633 kg"),
            ("damping", "425.8193 N*s/m"),
        ],
    );
}

#[test]
fn every_example_is_tested() {
    let mut names: Vec<String> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .filter(|name| Path::new(name).extension().is_some_and(|ending| ending == "toml"))
        .collect();
    names.sort();
    assert_eq!(
        names,
        [
            "added_weight.toml",
            "fan.toml",
            "fan_on_bracket.toml",
            "fan_questions.toml",
            // A plan of a study, carried out by the tests of the command line.
            "fan_study.toml",
            "jansen_leg.toml",
            "mass_from_frequency.toml",
            "mounts_for_a_fan.toml",
            "rotor.toml",
            "table.toml"
        ]
    );
}

fn folder() -> PathBuf {
    xtask::root().join("examples")
}

/// The cheapest mount lets more force through, the softest costs more than is permitted.
#[test]
fn the_mounts_of_a_fan() {
    answers(
        "mounts_for_a_fan.toml",
        &[
            ("size", "3"),
            ("price", "56.80"),
            ("transmitted_force", "55.67883 N"),
            ("static_deflection", "3.153214 mm"),
        ],
    );
}

/// k = 3EI/L³, fₙ = √(k/m)/2π, √(40/42).
#[test]
fn the_fan_on_its_bracket() {
    answers(
        "fan_on_bracket.toml",
        &[
            ("bracket.stiffness", "25200.00 N/m"),
            ("fan.natural_frequency", "25.09980 rad/s"),
            ("fan.force_amplitude", "35.53058 N"),
            ("drop", "0.9759001"),
        ],
    );
}

/// m = 2 kg/((8.2/7.9)² − 1), k = m (2π 8.2 Hz)².
#[test]
fn the_fan_with_an_added_weight() {
    answers("added_weight.toml", &[("mass", "25.84265 kg"), ("support.stiffness.stiffness", "68600.06 N/m")]);
}

#[test]
fn the_leg_of_a_walking_machine() {
    answers(
        "jansen_leg.toml",
        &[
            ("angular_velocity[7]", "3.6215 rad/s"),
            ("effort[1]", "0.075264 N·m"),
            ("reaction[1]", "13.371 N"),
        ],
    );
}
