//! Symmetries and limits of the rod on a shaft and of the disc on an arm.

use dalembert_core::Solution;

use crate::solved::{distance, number, solve, sound, vector};

#[test]
fn the_rod_is_the_same_from_whichever_line_its_angle_is_measured() {
    for degrees in [-80, -33, 0, 10, 45, 60, 89, 90, 120] {
        let level = rod(&format!("from-horizontal = {{ angle = \"{degrees} deg\" }}"), 20.0, 7.0);
        let shaft = rod(&format!("from-shaft = {{ angle = \"{} deg\" }}", 90 - degrees), 20.0, 7.0);
        for name in ["angular_momentum", "couple", "fixed_couple", "relative_rate", "transport_rate"] {
            let (a, b) = (vector(&level, name), vector(&shaft, name));
            assert!(distance(a, b) < 1e-12 * 36.0, "{degrees}°, {name}: {a:?} and {b:?}");
        }
        sound(&level);
        sound(&shaft);
    }
}

#[test]
fn a_rod_on_a_principal_axis_needs_no_couple_and_reports_it() {
    for degrees in [0, 90, 180, -90] {
        let solution = rod(&format!("from-horizontal = {{ angle = \"{degrees} deg\" }}"), 20.0, 0.0);
        // m b² ω²/6 = 36 N·m is what it would be at 45°.
        assert!(vector(&solution, "couple").iter().all(|x| x.abs() < 36.0 * 1e-12), "{degrees}°");
        assert_eq!(solution.warnings.len(), 1, "{degrees}°");
        assert!(solution.warnings[0].english().contains("principal axis"), "{degrees}°");
    }
    assert!(rod("from-horizontal = { angle = \"45 deg\" }", 20.0, 0.0).warnings.is_empty());
}

#[test]
fn the_couple_on_the_rod_follows_the_square_of_the_speed() {
    let couple =
        |speed: f64| number(&rod("from-horizontal = { angle = \"20 deg\" }", speed, 0.0), "tilting_couple");
    let once = couple(5.0);
    assert!((couple(10.0) / once - 4.0).abs() < 1e-12);
    assert_eq!(couple(-5.0).to_bits(), once.to_bits());
    assert_eq!(couple(0.0).abs(), 0.0);
}

#[test]
fn the_gyroscopic_couple_changes_sign_with_either_rotation() {
    let couple = |arm: f64, spin: f64| vector(&disc(arm, spin, 0.0, 0.0, 0.0), "couple");
    // m r² / 2 = 0.08 kg·m², times 5 · 10 rad²/s².
    assert!(distance(couple(5.0, 10.0), [4.0, 0.0, 0.0]) < 1e-12);
    assert!(distance(couple(-5.0, 10.0), [-4.0, 0.0, 0.0]) < 1e-12);
    assert!(distance(couple(5.0, -10.0), [-4.0, 0.0, 0.0]) < 1e-12);
    assert!(distance(couple(0.0, 10.0), [0.0; 3]) < 1e-12);
    assert!(distance(couple(5.0, 0.0), [0.0; 3]) < 1e-12);
}

#[test]
fn the_couple_in_fixed_axes_turns_with_the_arm() {
    let couple = |degrees: f64| vector(&disc(5.0, 10.0, 0.0, 0.0, degrees), "fixed_couple");
    let half = 4.0 * std::f64::consts::FRAC_1_SQRT_2;
    for (degrees, expected) in [
        (0.0, [4.0, 0.0, 0.0]),
        (45.0, [half, 0.0, -half]),
        (90.0, [0.0, 0.0, -4.0]),
        (180.0, [-4.0, 0.0, 0.0]),
    ] {
        assert!(distance(couple(degrees), expected) < 1e-12, "{degrees}°: {:?}", couple(degrees));
    }
}

#[test]
fn every_way_to_the_couple_agrees_for_any_motion() {
    for arm in [-40.0, -1.0, 0.0, 0.3, 25.0] {
        for spin in [-300.0, 0.0, 2.0, 80.0] {
            for (arm_rate, spin_rate) in [(0.0, 0.0), (12.0, 0.0), (-3.0, 150.0)] {
                sound(&disc(arm, spin, arm_rate, spin_rate, 77.0));
            }
        }
    }
}

fn rod(inclination: &str, speed: f64, acceleration: f64) -> Solution {
    solve(&format!(
        "analysis = \"rigid-body/rod-on-shaft\"\n[inputs]\nmass = \"6 kg\"\nhalf_length = \"0.3 m\"\n\
         inclination.{inclination}\nspeed = \"{speed} rad/s\"\nacceleration = \"{acceleration} rad/s^2\"\n\
         shaft_angle = \"25 deg\"\n"
    ))
}

fn disc(arm: f64, spin: f64, arm_rate: f64, spin_rate: f64, degrees: f64) -> Solution {
    solve(&format!(
        "analysis = \"rigid-body/spinning-disc-on-arm\"\n[inputs]\nmass = \"4 kg\"\nradius = \"0.2 m\"\n\
         arm_speed = \"{arm} rad/s\"\nspin = \"{spin} rad/s\"\narm_acceleration = \"{arm_rate} rad/s^2\"\n\
         spin_acceleration = \"{spin_rate} rad/s^2\"\narm_angle = \"{degrees} deg\"\n"
    ))
}
