//! Sensitivity of answers to inputs, and their spread within tolerances.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use dalembert_core::{Stop, cases, find, sensitivity, vary};
use dalembert_plugins as _;

use super::studies::{Problem, fan};

/// An answer's sensitivity, by the path of the input.
fn elasticity(problem: &Problem, answer: &str, path: &str) -> f64 {
    let found =
        sensitivity::sensitivity(problem.entry, &problem.record, answer, (&[], 1.0), &Stop::new()).unwrap();
    let one = found.influences.iter().find(|one| one.input.path == path).unwrap();
    one.elasticity(found.value)
}

#[test]
fn elasticities_are_the_exponents_of_the_formulas() {
    let fan = fan();
    // ωₙ = √(3EI/(mL³)).
    for (path, exponent) in [
        ("mass", -0.5),
        ("support.cantilever.young", 0.5),
        ("support.cantilever.length", -1.5),
        ("support.cantilever.section.given.second_moment", 0.5),
        ("speed", 0.0),
    ] {
        let found = elasticity(&fan, "natural_frequency", path);
        assert!((found - exponent).abs() < 1e-6, "{path}: {found}");
    }
}

/// The size of an angle depends on where it is counted from: it is taken by degrees, as it is also at zero.
#[test]
fn a_tolerance_is_a_share_or_a_width() {
    let inputs = |id: &str| {
        let entry = find(id).unwrap();
        vary::inputs(&cases::first(entry).unwrap().record(entry).unwrap())
    };
    let of = |inputs: &[vary::VariedInput], path: &str| {
        inputs.iter().find(|input| input.path == path).unwrap().clone()
    };
    let mass = of(&inputs("vibration/rotating-unbalance"), "mass");
    let angle =
        inputs("virtual-work/slider-crank").into_iter().find(|input| input.unit.pretty() == "°").unwrap();
    for (input, typed, width) in [
        (&mass, "2 %", 0.8),
        (&mass, "2", 0.8),
        (&mass, "500 g", 0.5),
        (&angle, "2", 2f64.to_radians()),
        (&angle, "0.01 rad", 0.01),
        (&angle, "10 %", 0.1 * angle.si.abs()),
    ] {
        assert!((input.tolerance(typed).unwrap() - width).abs() < 1e-12, "{typed} of {}", input.path);
    }
    assert_eq!((mass.step(), angle.step()), (0.4, 1f64.to_radians()));
    assert!(
        mass.tolerance("3 mm").is_err() && mass.tolerance("-1 %").is_err() && mass.tolerance("").is_err()
    );
}

/// One percent of a negative input is one percent more of it; a tolerance is a width, and holds to both sides.
#[test]
fn a_negative_input_has_a_step_of_its_sign_and_a_tolerance_of_none() {
    let entry = find("virtual-work/mechanism").unwrap();
    let record = cases::first(entry).unwrap().record(entry).unwrap();
    let record = vary::changed(&record, "gravity.y", -9.81).unwrap();
    let found = sensitivity::sensitivity(entry, &record, "effort[1]", (&[], 1.0), &Stop::new()).unwrap();
    let gravity = found.influences.iter().find(|one| one.input.path == "gravity.y").unwrap();
    let (step, size) = (gravity.input.step(), gravity.input.si.abs());
    assert!(gravity.input.si < 0.0 && (step + 0.01 * size).abs() < 1e-12, "{gravity:?}");
    assert!((gravity.tolerance - 0.01 * size).abs() < 1e-12, "{gravity:?}");
    assert!(found.influences.iter().all(|one| one.tolerance >= 0.0), "{:?}", found.influences);
}

#[test]
fn tolerances_add_up_at_worst_and_in_squares() {
    let fan = fan();
    let tolerances = [("mass".to_owned(), 0.8), ("support.cantilever.young".to_owned(), 8e9)];
    let found = sensitivity::sensitivity(
        fan.entry,
        &fan.record,
        "natural_frequency",
        (&tolerances, 0.0),
        &Stop::new(),
    )
    .unwrap();
    let spread = found.spread;
    // ω ∝ √(E/m): the stiffest material with the lightest mass, and the other way round.
    let [least, most] = spread.worst.map(|end| end / found.value);
    assert!((least - (0.96f64 / 1.02).sqrt()).abs() < 1e-12, "{spread:?}");
    assert!((most - (1.04f64 / 0.98).sqrt()).abs() < 1e-12, "{spread:?}");
    // ½ · 2 % and ½ · 4 %, to the second order of what is left out.
    assert!(
        (spread.likely / found.value - (0.01f64.powi(2) + 0.02f64.powi(2)).sqrt()).abs() < 5e-4,
        "{spread:?}"
    );
}

/// Near the peak of a resonance too, what all do together is no less than what each does alone.
#[test]
fn the_worst_of_all_tolerances_holds_that_of_each() {
    let fan = fan();
    for answer in ["amplitude", "frequency_ratio", "phase", "damping_ratio"] {
        let found =
            sensitivity::sensitivity(fan.entry, &fan.record, answer, (&[], 3.0), &Stop::new()).unwrap();
        let [least, most] = found.spread.worst;
        let ends = found.influences.iter().flat_map(|one| one.at_tolerance).filter(|end| end.is_finite());
        for end in ends.chain([found.value]) {
            assert!((least..=most).contains(&end), "{answer}: {end} in {least} to {most}");
        }
        assert!(least < found.value && found.value < most, "{answer}");
    }
}
