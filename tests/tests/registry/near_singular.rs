//! Answers near singular points beside those of arithmetic with 50 digits.

use dalembert_plugins as _;
use dalembert_testkit::near_singular;

#[test]
fn near_singular_points_are_answered_as_their_condition_allows() {
    let (points, families) = near_singular::near_singular_points_are_answered_as_their_condition_allows(
        include_str!("../../data/near_singular.toml"),
    );
    assert!(points >= 77 && families >= 9, "{points} points of {families} families");
}
