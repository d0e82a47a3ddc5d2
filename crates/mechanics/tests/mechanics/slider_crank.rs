use itertools::Itertools as _;
use std::f64::consts::{FRAC_PI_2, PI};

use dalembert_mechanics::slider_crank::{
    self, Branch, CrankMotion, SliderCrank, SliderCrankError, SliderCrankMotion,
};
use proptest::prelude::*;

use crate::close::{ROUNDING, close, found, printed};

#[test]
fn closure_of_example_1_needs_another_rod_speed() {
    let (crank, rod) = (30f64.to_radians(), (-22f64).to_radians());
    printed(slider_crank::rod_speed_in_line(crank, rod, 20.0), -14.0, 1);
    // A crank that gives the slider its −500 m/s, with the rod that reaches back to the line.
    let r = slider_crank::crank_from_slider_velocity(-500.0, crank, rod, 20.0);
    let l = -r * crank.sin() / rod.sin();
    close(slider_crank::rod_angle(r, l, 0.0, crank), rod, ROUNDING);
    let rod_speed = slider_crank::rod_speed(r, l, crank, rod, 20.0);
    close(rod_speed, slider_crank::rod_speed_in_line(crank, rod, 20.0), ROUNDING);
    let velocity = slider_crank::slider_velocity(r, l, crank, rod, 20.0, rod_speed);
    close(velocity, -500.0, ROUNDING);
}

fn at(mechanism: SliderCrank, t: f64, speed: f64, acceleration: f64) -> SliderCrankMotion {
    found(mechanism.motion(CrankMotion {
        angle: 0.7 + speed * t + 0.5 * acceleration * t * t,
        speed: speed + acceleration * t,
        acceleration,
    }))
}

proptest! {
    #[test]
    fn loop_closes_and_rates_are_derivatives(
        crank in 0.05..1.0, slenderness in 1.5..6.0, lift in -0.4..0.4,
        speed in -30.0..30.0f64, acceleration in -50.0..50.0f64, ahead in any::<bool>(),
    ) {
        let branch = if ahead { Branch::Ahead } else { Branch::Behind };
        let mechanism = SliderCrank { crank, rod: crank * slenderness, offset: crank * lift, branch };
        let now = at(mechanism, 0.0, speed, acceleration);
        let height = crank * 0.7f64.sin() + mechanism.rod * now.rod_angle.sin();
        prop_assert!((height - mechanism.offset).abs() <= 1e-13 * mechanism.rod);
        prop_assert_eq!(now.rod_angle.cos() > 0.0, ahead);
        prop_assert!((now.slider_position - 0.7f64.cos() * crank > 0.0) == ahead);

        // Central differences of eighth order.
        let quick = speed.abs() + acceleration.abs().sqrt() + 1.0;
        let step = 0.02 / quick;
        let rate = |of: &dyn Fn(SliderCrankMotion) -> f64| {
            [672.0, -168.0, 32.0, -3.0]
                .into_iter()
                .zip_eq([1.0, 2.0, 3.0, 4.0])
                .map(|(weight, k)| {
                    let part = |k: f64| of(at(mechanism, k * step, speed, acceleration));
                    weight * (part(k) - part(-k))
                })
                .sum::<f64>()
                / (840.0 * step)
        };
        let length = mechanism.rod;
        prop_assert!((rate(&|m| m.rod_angle) - now.rod_speed).abs() <= 1e-9 * quick);
        prop_assert!((rate(&|m| m.rod_speed) - now.rod_acceleration).abs() <= 1e-9 * quick.powi(2) * 4.0);
        prop_assert!((rate(&|m| m.slider_position) - now.slider_velocity).abs() <= 1e-9 * quick * length);
        let gap = rate(&|m| m.slider_velocity) - now.slider_acceleration;
        prop_assert!(gap.abs() <= 1e-9 * quick.powi(2) * length * 4.0);
    }
}

#[test]
fn dead_centres_of_the_in_line_mechanism() {
    let mechanism = SliderCrank { crank: 0.1, rod: 0.4, offset: 0.0, branch: Branch::Ahead };
    let at = |angle: f64| found(mechanism.motion(CrankMotion { angle, speed: 10.0, acceleration: 0.0 }));
    // Textbook: a = −r ω² (1 ± r/l) at the dead centres, v = −r ω at a quarter turn.
    close(at(0.0).slider_acceleration, -0.1 * 100.0 * (1.0 + 0.25), ROUNDING);
    close(at(PI).slider_acceleration, 0.1 * 100.0 * (1.0 - 0.25), ROUNDING);
    close(at(FRAC_PI_2).slider_velocity, -1.0, ROUNDING);
    assert!(at(PI).slider_velocity.abs() < 1e-15);
    close(at(0.0).slider_position, 0.5, ROUNDING);
}

#[test]
fn what_cannot_be_assembled_is_refused() {
    let short = SliderCrank { crank: 0.2, rod: 0.1, offset: 0.0, branch: Branch::Ahead };
    let turn = |angle: f64| CrankMotion { angle, speed: 1.0, acceleration: 0.0 };
    assert!(matches!(
        short.motion(turn(FRAC_PI_2)),
        Err(SliderCrankError::CannotAssemble { distance, .. }) if (distance - 0.2).abs() < 1e-15
    ));
    let limit = (0.5f64).asin();
    for distance in [1e-15, 1e-16, 0.0] {
        let refused = short.motion(turn(limit - distance));
        assert!(matches!(refused, Err(SliderCrankError::LimitPosition { .. })), "{refused:?}");
    }
    assert!(short.motion(turn(limit - 1e-9)).is_ok());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = SliderCrank { rod: bad, ..short }.motion(turn(0.0));
        assert_eq!(refused, Err(SliderCrankError::NotAMechanism));
    }
}
