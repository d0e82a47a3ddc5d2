//! Tests of `balance::locomotive`.

use dalembert_mechanics::balance::locomotive::*;

#[test]
fn cranks_at_right_angles_give_the_root_of_two() {
    let right = std::f64::consts::FRAC_PI_2;
    let root = 2f64.sqrt();
    assert!((sum_of_cranks(right) - root).abs() < 1e-15);
    assert!((crank_difference(right) - root).abs() < 1e-15);
    let largest =
        |f: &dyn Fn(f64) -> f64| (0..3600).map(|k| f(f64::from(k) * 0.1f64.to_radians())).fold(0.0, f64::max);
    assert!((largest(&|angle| tractive_effort(1.0, angle, right)) - root).abs() < 1e-6);
    assert!((largest(&|angle| swaying_couple(1.0, 2.0, angle, right)) - root).abs() < 1e-6);
}

#[test]
fn the_shares_carry_force_and_moment() {
    let (w, a) = (1.4, 1.8);
    assert!((near_share(w, a) + far_share(w, a) - 1.0f64).abs() < 1e-15);
    assert!(((near_share(w, a) - far_share(w, a)) * w - a).abs() < 1e-15);
}
