//! Every case of every analysis with all its numbers changed at random by up to 30 %. `cargo xtask soak perturb --draws N`
//! draws more.

use std::fs;

use dalembert_core::{Value, cases};
use dalembert_plugins as _;
use dalembert_testkit::perturbation::{self, CHANGE, Draws, perturbed, verdicts};
use dalembert_tests::chosen;

const REFUSALS: &str = include_str!("../../../docs/refusals.md");

#[test]
fn numbers_near_those_of_a_case_are_answered_or_refused_with_reason() {
    let asked = number("DALEMBERT_DRAWS");
    // The same draws every day: a sentence that comes once in ten thousand is met by who asks for more, not by who happens
    // to commit something else.
    let seed = asked.and_then(|_| number("PROPTEST_RNG_SEED")).unwrap_or(0);
    let usual = Draws::default();
    let draws = Draws { count: asked.unwrap_or(usual.count), seed, refusals: Some(REFUSALS) };
    perturbation::numbers_near_those_of_a_case_are_answered_or_refused_with_reason(
        &chosen(),
        &draws,
        |report| {
            if let Ok(path) = std::env::var("DALEMBERT_REPORT") {
                fs::write(path, report).expect("the report can be written");
            }
        },
    );
}

/// A refusal that is verdicts twice, or that no sentence of the program is like, would say nothing.
#[test]
fn the_table_of_refusals_is_sound() {
    let verdicts = verdicts(REFUSALS);
    assert!(verdicts.len() >= 20, "docs/refusals.md has {} rows", verdicts.len());
    for (template, verdict) in verdicts {
        assert!(["input at fault", "ours"].contains(&verdict.as_str()), "{template}: {verdict}");
    }
}

fn number(name: &str) -> Option<u64> {
    std::env::var(name).ok().map(|text| text.parse().unwrap_or_else(|_| panic!("{name} is a number: {text}")))
}

#[test]
fn a_perturbed_number_stays_within_its_share_and_is_drawn_again() {
    let entry = dalembert_core::find("vibration/free-vibration").unwrap();
    let record = cases::cases(entry).unwrap()[0].record(entry).unwrap();
    let one = perturbed(&record, 7, 1);
    assert_eq!(one, perturbed(&record, 7, 1));
    assert_ne!(one, perturbed(&record, 7, 2));
    let mut seen = 0;
    let mut numbers = Vec::new();
    record.leaves(&mut |_, _, value| {
        if let Value::Quantity(quantity) = value {
            numbers.push(quantity.si);
        }
    });
    one.leaves(&mut |path, _, value| {
        if let Value::Quantity(quantity) = value {
            let change = (quantity.si - numbers[seen]).abs();
            assert!(change <= CHANGE * numbers[seen].abs(), "{path}");
            seen += 1;
        }
    });
    assert!(seen > 0);
}
