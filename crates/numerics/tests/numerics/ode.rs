//! Motions against closed forms: the order of the method, its polynomial between steps, and where a motion ends.

use itertools::Itertools as _;
use std::f64::consts::TAU;

use dalembert_numerics::ode::{Integrator, OdeError, OdeFunction, OdeSystem, states};

use crate::close::{close, found};

/// `ẍ = −x` from (1, 0): (cos t, −sin t).
fn oscillator(tolerance: f64) -> OdeFunction<impl FnMut(f64, &[f64], &mut [f64])> {
    let rates = |_: f64, y: &[f64], rates: &mut [f64]| (rates[0], rates[1]) = (y[1], -y[0]);
    OdeFunction { rates, relative: 0.0, absolute: tolerance }
}

/// Steps of a given length, whatever their error.
struct Fixed;

impl OdeSystem for Fixed {
    fn rates(&mut self, _: f64, y: &[f64], rates: &mut [f64]) {
        (rates[0], rates[1]) = (y[1], -y[0]);
    }

    fn allowed(&mut self, _: &[f64], _: &[f64], allowed: &mut [f64]) {
        allowed.fill(1e12);
    }
}

#[test]
fn the_error_falls_with_the_eighth_power_of_the_step() {
    let error = |steps: u32| {
        let mut integrator = found(Integrator::new(&mut Fixed, 0.0, &[1.0, 0.0], 4.0, 1000));
        for step in 1..=steps {
            let until = 4.0 * f64::from(step) / f64::from(steps);
            while integrator.time() < until {
                found(integrator.advance(&mut Fixed, until));
            }
        }
        assert_eq!(integrator.steps(), steps as usize);
        let [x, v] = [integrator.state()[0], integrator.state()[1]];
        (x - 4f64.cos()).hypot(v + 4f64.sin())
    };
    for steps in [4, 6] {
        let order = (error(steps) / error(2 * steps)).log2();
        assert!((7.6..8.8).contains(&order), "order {order} from {steps} steps");
    }
}

#[test]
fn a_turn_is_compared_with_its_tolerance() {
    for tolerance in [1e-5, 1e-8, 1e-11] {
        let states = found(states(&mut oscillator(tolerance), &[1.0, 0.0], &[0.0, 5.0 * TAU], 1000));
        let error = (states[1][0] - 1.0).hypot(states[1][1]);
        assert!(error < 30.0 * tolerance, "{error:e} at {tolerance:e}");
    }
}

#[test]
fn between_the_steps_the_motion_is_as_exact_as_at_their_ends() {
    let mut problem = oscillator(1e-11);
    let times: Vec<f64> = (0..=400).map(|n| f64::from(n) * 0.05).collect();
    let states = found(states(&mut problem, &[1.0, 0.0], &times, 1000));
    for (time, state) in times.iter().zip_eq(states) {
        assert!((state[0] - time.cos()).abs() < 1e-9 && (state[1] + time.sin()).abs() < 1e-9, "{time}");
    }
}

#[test]
fn the_first_zero_of_a_number_is_found_once() {
    let mut problem = oscillator(1e-12);
    let mut integrator = found(Integrator::new(&mut problem, 0.0, &[1.0, 0.0], 20.0, 1000));
    let mut zeros = Vec::new();
    while integrator.time() < 20.0 {
        found(integrator.advance(&mut problem, 20.0));
        zeros.extend(integrator.first_zero(&mut problem, |_, _, state| state[1]));
    }
    // The start itself, where the velocity is zero, is none.
    assert_eq!(zeros.len(), 6);
    for (zero, n) in zeros.iter().zip(1..) {
        close(*zero, f64::from(n) * TAU / 2.0, 1e-10);
    }
}

#[test]
fn a_stiff_motion_is_followed_as_long_as_there_are_steps() {
    // ẏ = −λ (y − cos t) approaches (λ² cos t + λ sin t)/(λ² + 1).
    const LAMBDA: f64 = 1e4;
    let rates = |t: f64, y: &[f64], rates: &mut [f64]| rates[0] = -LAMBDA * (y[0] - t.cos());
    for tolerance in [1e-6, 1e-8, 1e-10] {
        let mut problem = OdeFunction { rates, relative: 0.0, absolute: tolerance };
        let states = found(states(&mut problem, &[0.0], &[0.0, 10.0], 100_000));
        let exact = (LAMBDA * LAMBDA * 10f64.cos() + LAMBDA * 10f64.sin()) / (LAMBDA * LAMBDA + 1.0);
        assert!((states[1][0] - exact).abs() < 30.0 * tolerance, "{:e}", states[1][0] - exact);
    }
}

#[test]
fn what_cannot_go_on_is_named() {
    let blow_up = |_: f64, y: &[f64], rates: &mut [f64]| rates[0] = y[0] * y[0];
    let mut problem = OdeFunction { rates: blow_up, relative: 1e-8, absolute: 1e-8 };
    assert!(matches!(
        states(&mut problem, &[1.0], &[0.0, 2.0], 10_000),
        Err(OdeError::TooShort { at } | OdeError::NotFinite { at }) if (at - 1.0).abs() < 1e-3
    ));
    let stiff = |_: f64, y: &[f64], rates: &mut [f64]| rates[0] = -1e7 * (y[0] - 1.0);
    let mut problem = OdeFunction { rates: stiff, relative: 1e-6, absolute: 1e-6 };
    assert!(matches!(states(&mut problem, &[0.0], &[0.0, 10.0], 100_000), Err(OdeError::Stiff { .. })));
    let mut problem = oscillator(1e-10);
    assert!(matches!(
        states(&mut problem, &[1.0, 0.0], &[0.0, 1e6], 50),
        Err(OdeError::TooManySteps { steps: 50, .. })
    ));
    let mut problem = oscillator(0.0);
    assert_eq!(states(&mut problem, &[1.0, 0.0], &[0.0, 1.0], 50), Err(OdeError::Input));
}
