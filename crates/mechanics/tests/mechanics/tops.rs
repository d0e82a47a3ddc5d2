//! Tops and free bodies: published and independent numbers, the integrated equations, limits.

use itertools::Itertools as _;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_mechanics::rigid::{
    self,
    top::{self, Nutation, Top, TopError, Trace},
    torque_free::{self, FreeBody, Polhode},
};
use dalembert_numerics::ode;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::close::{all_close, close, found};

fn free(inertia: [f64; 3], start: [f64; 3]) -> FreeBody {
    found(FreeBody::new(inertia.into(), start.into()))
}

/// Body axes and attitude by Euler's equations and quaternions, at ascending times from 0.
fn integrated(inertia: [f64; 3], start: [f64; 3], times: &[f64]) -> Vec<(Vector3<f64>, UnitQuaternion<f64>)> {
    let rates = |_: f64, y: &[f64], dy: &mut [f64]| {
        let omega = Vector3::new(y[0], y[1], y[2]);
        let momentum = Vector3::from(inertia).component_mul(&omega);
        let rate = momentum.cross(&omega).component_div(&Vector3::from(inertia));
        let turn = Quaternion::new(y[3], y[4], y[5], y[6]) * Quaternion::from_imag(omega) * 0.5;
        dy[..3].copy_from_slice(rate.as_slice());
        dy[3..].copy_from_slice(&[turn.w, turn.i, turn.j, turn.k]);
    };
    let mut problem = ode::OdeFunction { rates, relative: 1e-13, absolute: 1e-13 };
    let state = [start[0], start[1], start[2], 1.0, 0.0, 0.0, 0.0];
    found(ode::states(&mut problem, &state, times, 10_000_000))
        .into_iter()
        .map(|y| {
            let turn = Quaternion::new(y[3], y[4], y[5], y[6]);
            (Vector3::new(y[0], y[1], y[2]), UnitQuaternion::from_quaternion(turn))
        })
        .collect()
}

/// Thirty digits by Taylor series, beside the unstable axis.
#[test]
fn rotation_about_the_middle_axis_to_twelve_digits() {
    let body = free([1.0, 2.0, 3.0], [0.01, 5.0, 0.01]);
    all_close(
        body.velocity(10.0).into(),
        [0.012714870629462085, 4.9999938332026845, 0.010979798649094277],
        1e-13,
    );
    let late = body.velocity(100.0);
    all_close(late.into(), [0.06021783543923199, 4.999647368794625, 0.03571268544456075], 1e-12);
    close(late.x, 0.06021783543923199, 1e-11);
}

#[test]
fn a_free_body_turns_as_its_equations_say() {
    let orders = [[1.0, 2.0, 2.5], [2.0, 1.0, 2.5], [2.5, 2.0, 1.0], [1.0, 2.5, 2.0], [2.0, 2.5, 1.0]];
    let starts = [[0.6, 0.3, 1.1], [-1.2, 0.4, 0.1], [0.2, 1.0, -0.3], [0.0, -0.4, 0.9], [0.3, 0.3, 0.0]];
    let symmetric = [[1.0, 1.0, 0.5], [1.0, 2.0, 2.0], [2.0, 1.0, 2.0]];
    for inertia in orders.into_iter().chain(symmetric) {
        for start in starts {
            let body = free(inertia, start);
            for (time, (omega, attitude)) in
                [0.0, 1.7, 5.0, 13.0].into_iter().zip_eq(integrated(inertia, start, &[0.0, 1.7, 5.0, 13.0]))
            {
                let gap = (body.velocity(time) - omega).norm();
                assert!(gap < 1e-11, "{inertia:?} {start:?} at {time}: {gap:e}");
                let turned = body.attitude(time);
                let orthogonal = turned.matrix() * turned.matrix().transpose();
                assert!((orthogonal - nalgebra::Matrix3::identity()).norm() < 1e-14);
                let off = (turned.matrix() - attitude.to_rotation_matrix().matrix()).norm();
                assert!(off < 1e-10, "{inertia:?} {start:?} at {time}: attitude off by {off:e}");
            }
        }
    }
}

#[test]
fn the_attitude_holds_for_a_thousand_revolutions() {
    let (inertia, start) = ([1.0, 2.0, 2.5], [0.6, 0.3, 1.1]);
    let end = 1000.0 * TAU / Vector3::from(start).norm();
    let last = integrated(inertia, start, &[0.0, end])[1].1.to_rotation_matrix();
    let angle = (free(inertia, start).attitude(end).inverse() * last).angle();
    assert!(angle < 1e-9, "off by {angle:e} rad");
}

/// `k`, period and flips of free bodies, and the separatrix, a rotation from one end of the middle axis to the other.
#[test]
fn polhodes_have_their_names_and_periods() {
    let body = free([1.0, 2.0, 3.0], [0.6, 0.3, 1.1]);
    assert_eq!(body.polhode(), Polhode::Around(2));
    close(body.modulus().0.powi(2), 0.12096774193548387, 1e-14);
    close(body.period(), 5.825792706791326, 1e-13);
    let flips = free([1.0, 2.0, 3.0], [0.001, 5.0, 0.001]);
    close(flips.period() / 2.0, 6.621223980898226, 1e-10);
    close(flips.first_flip().expect("it flips"), 3.538715786435652, 1e-10);
    assert_eq!(free([1.0, 2.0, 3.0], [1.0, 0.2, 0.1]).polhode(), Polhode::Around(0));
    assert_eq!(free([1.0, 2.0, 3.0], [0.0, 5.0, 0.0]).polhode(), Polhode::Permanent);
    assert_eq!(free([2.0, 2.0, 2.0], [1.0, 5.0, 2.0]).polhode(), Polhode::Permanent);
    // H² = 2 T I_b without rounding: 6·2·ω_x² = 12·4·ω_z².
    let (inertia, start) = ([6.0, 8.0, 12.0], [2.0, -1.0, 1.0]);
    let separatrix = free(inertia, start);
    assert_eq!(separatrix.polhode(), Polhode::Separatrix);
    let (omega, attitude) = integrated(inertia, start, &[0.0, 1.5])[1];
    all_close(separatrix.velocity(1.5).into(), omega.into(), 1e-11);
    assert!((separatrix.attitude(1.5).matrix() - attitude.to_rotation_matrix().matrix()).norm() < 1e-10);
    assert_eq!(separatrix.first_flip().is_some(), separatrix.velocity(100.0).y > 0.0);
}

/// The closed form of a body of revolution and the elliptic functions are one.
#[test]
fn a_body_of_revolution_is_the_limit_of_any_body() {
    let start = Vector3::new(0.5, 0.5, 1.0);
    for (transverse, axial) in [(1.0, 0.5), (1.0, 1.9)] {
        let body = free([transverse, transverse, axial], start.into());
        for time in [0.3, 5.0, 100.0] {
            let closed = torque_free::axisymmetric_velocity(axial / transverse, start, time);
            all_close(body.velocity(time).into(), closed.into(), 1e-12);
            let closed = torque_free::axisymmetric_attitude(axial / transverse, start, time);
            assert!((closed.matrix() - body.attitude(time).matrix()).norm() < 1e-12);
        }
    }
}

fn axis(motion: &Nutation, time: f64, azimuth: f64) -> [f64; 3] {
    let at = motion.at(time);
    let (sin, cos) = at.nutation.sin_cos();
    let turned = azimuth + at.precession;
    [sin * turned.cos(), sin * turned.sin(), cos]
}

/// Own and others' integrations of two tops of the literature, to their digits.
#[test]
fn tops_of_the_literature() {
    let heavy = Top { axial: 0.46875, transverse: 15.234375, couple: 15.0 * 9.81 };
    let motion = found(heavy.released(FRAC_PI_2, 0.0, -4.61538, 150.0));
    for (time, expected) in [
        (0.2, [0.605550561377, 0.598957681795, -0.523983027430]),
        (1.0, [0.173343964098, 0.640088592070, -0.748490791134]),
        (2.0, [-0.150416822747, -0.724165591637, -0.673022269560]),
    ] {
        all_close(axis(&motion, time, FRAC_PI_2), expected, 2e-12);
    }
    let fast = Top { axial: 1.0, transverse: 5.0, couple: 20.0 };
    let motion = found(fast.released(0.05, 0.0, 0.0, 50.0));
    close(motion.limits()[1], 0.05455169022434166, 1e-13);
    for (time, expected) in [
        (1.0, [0.021541104974, -0.050010335483, 0.998516372996]),
        (10.0, [-0.047132231441, 0.026748686360, 0.998530450481]),
    ] {
        all_close(axis(&motion, time, -FRAC_PI_2), expected, 2e-12);
    }
}

/// `θ̈`, `φ̇` and `ψ̇` of the top, integrated.
#[test]
fn a_top_moves_as_its_equations_say() {
    let body = Top { axial: 4e-4, transverse: 2.2e-3, couple: 0.2943 };
    let starts: [[f64; 4]; 6] = [
        [0.6, 0.0, 0.0, 160.0],
        [0.6, 3.0, -4.0, 160.0],
        [0.6, -3.0, 12.0, 160.0],
        [1.7, 1.0, 5.0, -60.0],
        [2.5, -4.0, 1.0, 0.0],
        [0.02, 0.5, 10.0, 100.0],
    ];
    for [theta, theta_rate, phi_rate, axial_velocity] in starts {
        let momentum = body.axial * axial_velocity;
        let vertical = body.transverse * phi_rate * theta.sin().powi(2) + momentum * theta.cos();
        let rates = |_: f64, y: &[f64], dy: &mut [f64]| {
            let (sin, cos) = y[0].sin_cos();
            let phi_rate = (vertical - momentum * cos) / (body.transverse * sin * sin);
            dy[0] = y[1];
            dy[1] = (body.transverse * phi_rate * phi_rate * cos - momentum * phi_rate + body.couple) * sin
                / body.transverse;
            dy[2] = phi_rate;
            dy[3] = axial_velocity - phi_rate * cos;
        };
        let mut problem = ode::OdeFunction { rates, relative: 1e-13, absolute: 1e-13 };
        let times = [0.0, 0.05, 0.4, 1.0];
        let states = found(ode::states(&mut problem, &[theta, theta_rate, 0.0, 0.0], &times, 1_000_000));
        let motion = found(body.released(theta, theta_rate, phi_rate, axial_velocity));
        for (time, state) in times.into_iter().zip_eq(states) {
            let at = motion.at(time);
            for (ours, integrated) in
                [at.nutation, at.nutation_rate, at.precession, at.spin].into_iter().zip_eq(state)
            {
                let gap = (ours - integrated).abs();
                assert!(gap < 2e-9 * integrated.abs().max(1.0), "{theta} {phi_rate} at {time}: {gap:e}");
            }
        }
        let period = motion.period();
        close(motion.at(period).precession, motion.advance(), 1e-10);
        close(motion.at(3.0 * period).nutation, theta, 1e-10);
    }
}

/// With `L_z = I_a ω₃` the precession is `(I_a/I_t) ω₃/(1 + cos θ)`; the axis turns back where it takes all energy.
#[test]
fn a_top_that_could_pass_the_vertical_turns_back_where_its_energy_ends() {
    let body = Top { axial: 4e-4, transverse: 2.2e-3, couple: 0.2943 };
    let beta = 2.0 * body.couple / body.transverse;
    for (nutation_rate, axial_velocity) in [(1.0, 30.0), (-2.5, 45.0), (4.0, -20.0)] {
        let rate = body.axial * axial_velocity / body.transverse;
        // 1 − cos θ at the start.
        let height = 2.0 * (FRAC_PI_2 / 2.0).sin().powi(2);
        let motion = found(body.released(FRAC_PI_2, nutation_rate, rate * height, axial_velocity));
        let [high, low] = motion.limits();
        assert!(high < FRAC_PI_2 && low > FRAC_PI_2);
        for (angle, ours) in [high, low].into_iter().zip_eq(motion.precession_at_limits()) {
            let precession = rate / (1.0 + angle.cos());
            close(ours, precession, 1e-12);
            let energy = (precession * angle.sin()).powi(2) + beta * angle.cos();
            let start = nutation_rate * nutation_rate + rate * rate;
            assert!((energy - start).abs() < 1e-12 * beta, "{energy} is not {start} at {angle}");
        }
    }
}

#[test]
fn traces_have_their_names() {
    let body = Top { axial: 4e-4, transverse: 2.2e-3, couple: 0.2943 };
    let theta = 35f64.to_radians();
    let trace = |precession| found(body.released(theta, 0.0, precession, 160.0)).trace();
    assert_eq!(trace(0.0), Trace::Cusp);
    assert_eq!(trace(-3.0), Trace::Loop);
    assert_eq!(trace(2.0), Trace::Wave);
    let cusp = found(body.released(theta, 0.0, 0.0, 160.0));
    close(cusp.limits()[1].to_degrees(), 51.13498788333377, 1e-13);
    close(cusp.limits()[0], theta, 1e-14);
    // Steady precession from the quadratic, with ω₃: the axis keeps its angle, and nutates at the closed frequency.
    let momentum = body.axial * 160.0;
    let square = body.transverse * theta.cos();
    let root = top::discriminant(momentum, square, body.couple).sqrt();
    for steady in
        [top::slow_precession(body.couple, momentum, root), top::fast_precession(square, momentum, root)]
    {
        let motion = found(body.released(theta, 0.0, steady, 160.0));
        let [high, low] = motion.limits();
        assert!((high - theta).abs() < 1e-7 && (low - theta).abs() < 1e-7, "{high} {low}");
        close(motion.advance() / motion.period(), steady, 1e-7);
        let frequency = top::nutation_frequency(body.axial / body.transverse, 160.0, steady, theta);
        close(TAU / motion.period(), frequency, 1e-7);
    }
}

#[test]
fn a_sleeping_top_wakes_below_its_threshold() {
    let body = Top { axial: 4e-4, transverse: 2.2e-3, couple: 0.2943 };
    let threshold = top::sleeping_threshold(body.axial, body.transverse, body.couple);
    close(threshold, 127.22617655184014, 1e-14);
    // Released 0.1 mrad off, its axis turning as fast as that of an upright one.
    let tilt = |part: f64| found(body.released(1e-4, 0.0, 0.0, part * threshold)).limits()[1];
    assert!(tilt(1.05) < 1e-3 && tilt(0.95) > 0.5);
    assert_eq!(body.released(0.0, 0.0, 0.0, 100.0), Err(TopError::Vertical));
    assert_eq!(body.released(PI, 0.0, 0.0, 100.0), Err(TopError::Vertical));
}

/// A spherical pendulum without spin or turning is a plane one.
#[test]
fn a_top_that_does_not_turn_is_a_pendulum() {
    let body = Top { axial: 0.1, transverse: 2.0, couple: 2.0 * 9.81 };
    let motion = found(body.released(FRAC_PI_2, 0.0, 0.0, 0.0));
    let [_, low] = motion.limits();
    close(low, PI, 1e-14);
    // From level to level: half the period of the pendulum, 2.3678419475762373 s.
    close(motion.period(), 2.3678419475762373 / 2.0, 1e-13);
}

/// Steady motions balance `Ω × H` and the moment of the weight.
#[test]
fn steady_precession_balances_the_weight() {
    let (axial, transverse, couple, theta, spin) = (4e-4, 2.2e-3, 0.2943, 35f64.to_radians(), 160.0);
    let square = (transverse - axial) * theta.cos();
    let root = top::discriminant(axial * spin, square, couple).sqrt();
    let slow: f64 = top::slow_precession(couple, axial * spin, root);
    let fast = top::fast_precession(square, axial * spin, root);
    all_close([slow, fast], [5.228170658090176, 38.177148053428255], 1e-14);
    for precession in [slow, fast] {
        // Axes x (nodes), y, z (axis) that follow the axis but not the spin.
        let frame = Vector3::new(0.0, precession * theta.sin(), precession * theta.cos());
        let body = frame + Vector3::new(0.0, 0.0, spin);
        let momentum = rigid::angular_momentum([transverse, transverse, axial], body);
        close(rigid::transport_rate(frame, momentum).x, couple * theta.sin(), 1e-13);
        close(top::spin_for(axial, transverse, couple, precession, theta), spin, 1e-13);
    }
}
