//! Motions of a rigid body in space against closed forms, published benchmarks and their own invariants.

use itertools::Itertools as _;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_mechanics::rigid::{
    simulate::{
        AppliedTorque, FreeRotation, History, Loads, RigidBodyMotion, RotatingBody, RotationEvent,
        RotationRun, RotationState, SimulateError, WatchedAngles, simulate, simulate_free,
        simulate_free_watching, simulate_watching,
    },
    torque_free::FreeBody,
};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

const RUN: RotationRun<'static> = RotationRun {
    duration: 1.0,
    tolerance: 1e-13,
    samples: 2,
    ends: &[],
    most_steps: 1_000_000,
    cancelled: &|| false,
};

fn diagonal(x: f64, y: f64, z: f64) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(x, y, z))
}

fn free(inertia: Matrix3<f64>) -> RotatingBody {
    RotatingBody { mass: 1.0, inertia, arm: Vector3::zeros() }
}

fn start(x: f64, y: f64, z: f64) -> RotationState {
    RotationState { attitude: UnitQuaternion::identity(), omega_body: Vector3::new(x, y, z) }
}

/// The heavy top of Brüls, Cardona and Arnold.
fn heavy_top() -> (RotatingBody, RotationState, Loads) {
    let body =
        RotatingBody { mass: 15.0, inertia: diagonal(15.234375, 0.46875, 15.234375), arm: Vector3::y() };
    let loads = Loads { gravity: Vector3::z() * -9.81, torques: Vec::new() };
    (body, start(0.0, 150.0, -4.61538), loads)
}

fn last(motion: &RigidBodyMotion) -> dalembert_mechanics::rigid::simulate::RotationSample {
    *motion.samples.last().expect("a motion has its start")
}

/// G. Brüls, A. Cardona, M. Arnold, Mechanism and Machine Theory 48 (2012); converged values of two other programs,
/// and a solution to 10⁻¹³ in quaternions.
#[test]
fn the_heavy_top_after_two_seconds() {
    let (body, from, loads) = heavy_top();
    let motion = simulate(&body, &from, &loads, &RotationRun { duration: 2.0, ..RUN }).unwrap();
    let end = last(&motion);
    assert!((end.omega.y - -106.163804142).abs() < 1e-8, "{}", end.omega.y);
    let centre = end.turning.attitude * body.arm;
    let wanted = Vector3::new(-0.150416822747, -0.724165591637, -0.673022269560);
    assert!((centre - wanted).norm() < 3e-11, "{centre}");
    let q = end.turning.attitude.into_inner();
    let wanted = Quaternion::new(0.122947135042, -0.491079892552, 0.350430030343, -0.787986887550);
    assert!((q - wanted).norm().min((q + wanted).norm()) < 3e-11, "{q}");
    let wanted = Vector3::new(0.1222332195, 150.0, -5.8556245892);
    assert!((end.turning.omega_body - wanted).norm() < 1e-9, "{}", end.turning.omega_body);
    assert!(motion.energy_drift() < 1e-12 && motion.momentum_drift(Some(loads.gravity)) < 1e-12);
    // The axis moves slowly: the steps are few, since the spin has no part in them.
    assert!(motion.steps < 200, "{}", motion.steps);
    let early = last(&simulate(&body, &from, &loads, &RotationRun { duration: 0.01, ..RUN }).unwrap());
    assert!((early.omega.y - 149.8473939540).abs() < 1e-9, "{}", early.omega.y);
}

/// The same top made a little triaxial takes every turn of the spin in steps of its own, and comes to nearly the same.
#[test]
fn the_axes_without_spin_change_nothing() {
    let (body, from, loads) = heavy_top();
    let nearly = RotatingBody { inertia: diagonal(15.234375 * (1.0 + 1e-12), 0.46875, 15.234375), ..body };
    let run = RotationRun { duration: 2.0, ..RUN };
    let (one, other) = (simulate(&body, &from, &loads, &run), simulate(&nearly, &from, &loads, &run));
    let (one, other) = (one.unwrap(), other.unwrap());
    assert!(other.steps > 3 * one.steps);
    assert!(last(&one).turning.attitude.angle_to(&last(&other).turning.attitude) < 1e-9);
}

#[test]
fn the_accelerations_with_which_the_heavy_top_starts() {
    let (body, from, loads) = heavy_top();
    let alpha = body.acceleration(&from, &loads).unwrap();
    assert!((alpha - Vector3::new(661.3461692307692, 0.0, 0.0)).norm() < 1e-9);
    let acceleration =
        dalembert_mechanics::rigid::acceleration_of_point(Vector3::zeros(), from.omega_body, alpha, body.arm);
    assert!(
        (acceleration.y - -21.3017325444).abs() < 1e-9 && (acceleration.z - -30.960830769230824).abs() < 1e-6
    );
}

/// J. C. Simo, K. K. Wong (1991): a fast top starts with its axis at rest, and nutates between its limits, the roots of
/// a cubic (Goldstein, §5.7).
#[test]
fn the_nutation_of_a_fast_top() {
    let body = RotatingBody { mass: 20.0, inertia: diagonal(5.0, 5.0, 1.0), arm: Vector3::z() };
    let tilted = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.05);
    let from = RotationState { attitude: tilted, omega_body: Vector3::new(0.0, 0.0, 50.0) };
    let loads = Loads { gravity: -Vector3::z(), torques: Vec::new() };
    let motion =
        simulate(&body, &from, &loads, &RotationRun { duration: 10.0, samples: 20_001, ..RUN }).unwrap();
    let first = motion.samples[0];
    assert!((first.kinetic + first.potential - 1269.9750052078994).abs() < 1e-9);
    let tilt = |sample: &dalembert_mechanics::rigid::simulate::RotationSample| {
        (sample.turning.attitude * Vector3::z()).angle(&Vector3::z())
    };
    let most = motion.samples.iter().map(tilt).fold(0.0, f64::max);
    let least = motion.samples.iter().map(tilt).fold(PI, f64::min);
    assert!((most - 0.05455169018858949).abs() < 1e-8 && (least - 0.05).abs() < 1e-12, "{least} {most}");
    let axis = last(&motion).turning.attitude * Vector3::z();
    let wanted = Vector3::new(-0.047132231441, 0.026748686360, 0.998530450481);
    assert!((axis - wanted).norm() < 3e-11, "{axis}");
}

/// With equal moments the attitude is `rot(H, |H| t/I_t) rot(z, (1 − I_a/I_t) ω_z t)`.
#[test]
fn free_motions_of_a_body_of_revolution_are_two_rotations() {
    let (transverse, axial, time) = (1.0, 0.5, 5.0);
    let body = free(diagonal(transverse, transverse, axial));
    let from = start(0.5, 0.5, 1.0);
    let momentum = body.inertia * from.omega_body;
    let closed = UnitQuaternion::new(momentum * (time / transverse))
        * UnitQuaternion::new(Vector3::z() * ((1.0 - axial / transverse) * from.omega_body.z * time));
    let run = RotationRun { duration: time, ..RUN };
    let followed = last(&simulate(&body, &from, &Loads::default(), &run).unwrap());
    let kept = last(&simulate_free(&body, &from, 0.02, &run).unwrap());
    assert!(followed.turning.attitude.angle_to(&closed) < 1e-11);
    assert!(kept.turning.attitude.angle_to(&closed) < 1e-11);
    let wanted = [-0.6305141458392188, 0.6048049849401341, -0.3031242390572902, -0.38049775003821373];
    let q = closed.into_inner();
    let off =
        (q.w - wanted[0]).abs() + (q.i - wanted[1]).abs() + (q.j - wanted[2]).abs() + (q.k - wanted[3]).abs();
    assert!(off < 1e-11, "{q}");
}

#[test]
fn every_sample_of_a_free_motion_is_where_its_two_rotations_lead() {
    let (transverse, axial) = (1.7, 0.6);
    let body = free(diagonal(transverse, transverse, axial));
    let from = start(0.4, -0.3, 1.1);
    let momentum = body.inertia * from.omega_body;
    let spin = Vector3::z() * ((1.0 - axial / transverse) * from.omega_body.z);
    let run = RotationRun { duration: 5.0, samples: 8, ..RUN };
    for motion in [
        simulate_free(&body, &from, 0.02, &run).unwrap(),
        simulate(&body, &from, &Loads::default(), &run).unwrap(),
    ] {
        assert_eq!(motion.samples.len(), 8);
        for (n, sample) in motion.samples.iter().enumerate() {
            let time = 5.0 * n as f64 / 7.0;
            let closed =
                UnitQuaternion::new(momentum * (time / transverse)) * UnitQuaternion::new(spin * time);
            assert!((sample.time - time).abs() < 1e-14);
            assert!(sample.turning.attitude.angle_to(&closed) < 1e-10, "after {time} s");
        }
    }
}

/// The axis of revolution goes round the momentum with `|H|/I_t`: it is nearest to a direction 0.3 rad from the momentum
/// where it passes between the two, and farthest half a turn later.
#[test]
fn a_precessing_axis_passes_a_watched_direction_when_it_must() {
    let (transverse, axial, away, ahead) = (1.7, 0.6, 0.3f64, 2.3);
    let body = free(diagonal(transverse, transverse, axial));
    let from = start(0.4, -0.3, 1.1);
    let momentum = body.inertia * from.omega_body;
    let (along, rate) = (momentum.normalize(), momentum.norm() / transverse);
    let tilt = along.angle(&Vector3::z());
    let toward = (Vector3::z() - along * along.z).normalize();
    let against = UnitQuaternion::new(along * ahead) * (along * away.cos() + toward * away.sin());
    let watched = Some(WatchedAngles { of: Vector3::z(), against });
    let run = RotationRun { duration: 6.0 / rate, samples: 7, ..RUN };
    for motion in [
        simulate_free_watching(&body, &from, 0.02, &run, watched).unwrap(),
        simulate_watching(&body, &from, &Loads::default(), &run, watched).unwrap(),
    ] {
        let angles = motion.angles.expect("an angle is watched");
        for (extreme, turned, angle) in
            [(angles.least, ahead, tilt - away), (angles.largest, ahead + PI, tilt + away)]
        {
            assert!((extreme.time * rate - turned).abs() < 1e-8, "{extreme:?}, not after {turned} rad");
            assert!((extreme.value - angle).abs() < 1e-9, "{extreme:?}, not {angle} rad");
        }
    }
}

#[test]
fn a_table_goes_on_straight_lines_and_stays_at_its_ends() {
    let table = History::Table(vec![[0.3, 0.7], [1.1, -2.3], [1.6, 0.4], [2.9, 1.8]]);
    let third = 1.0 / 3.0;
    for (time, value) in [
        (-0.7, 0.7),
        (0.3, 0.7),
        (0.3 + 0.8 * third, 0.7 - 3.0 * third),
        (1.1, -2.3),
        (1.1 + 0.5 * third, -2.3 + 2.7 * third),
        (1.6, 0.4),
        (1.6 + 1.3 * third, 0.4 + 1.4 * third),
        (2.9, 1.8),
        (4.3, 1.8),
    ] {
        assert!((table.at(time) - value).abs() < 1e-14, "{} after {time} s", table.at(time));
    }
}

/// Near the unstable axis, against a Taylor series in 30 digits.
#[test]
fn a_body_near_its_unstable_axis() {
    let body = free(diagonal(1.0, 2.0, 3.0));
    let from = start(0.01, 5.0, 0.01);
    for (time, wanted, within) in [
        (10.0, [0.012714870629462084, 4.999993833202685, 0.010979798649094277], 1e-12),
        (100.0, [0.06021783543923199, 4.999647368794625, 0.03571268544456075], 5e-11),
    ] {
        let run = RotationRun { duration: time, tolerance: 1e-14, ..RUN };
        let kept = last(&simulate_free(&body, &from, 0.005, &run).unwrap()).turning.omega_body;
        let followed = last(&simulate(&body, &from, &Loads::default(), &run).unwrap()).turning.omega_body;
        assert!((kept - Vector3::from(wanted)).amax() < within, "{time}: {kept}");
        assert!((followed - Vector3::from(wanted)).amax() < 100.0 * within, "{time}: {followed}");
    }
}

/// A body that turns freely for some revolutions, and by how much energy and momentum in space are off, relatively.
fn long(seed: u64, revolutions: f64) -> [f64; 2] {
    let mut random = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut next = || {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 11) as f64 / (1u64 << 53) as f64
    };
    // The moments of three masses on the axes make any body.
    let [a, b, c] = [0.2 + next(), 0.2 + next(), 0.2 + next()];
    let moments = Vector3::new(b + c, c + a, a + b);
    let omega = Vector3::new(next() - 0.5, next() - 0.5, next() - 0.5).normalize() * (1.0 + next());
    let fastest = moments.component_mul(&omega).norm() / moments.min();
    let step = 0.3 / fastest;
    let steps = (revolutions * TAU / omega.norm() / step) as u64;
    let attitude = UnitQuaternion::new(Vector3::new(next(), next(), next()));
    let mut rotation = FreeRotation::new(moments, attitude, omega, step).expect("a short step");
    let (energy, momentum) = (rotation.energy(), rotation.momentum_in_space());
    let mut off = [0.0_f64; 2];
    for n in 0..steps {
        rotation.advance();
        if n % 64 == 63 || n + 1 == steps {
            off[0] = off[0].max((rotation.energy() / energy - 1.0).abs());
            off[1] = off[1].max((rotation.momentum_in_space() - momentum).norm() / momentum.norm());
        }
    }
    off
}

#[test]
fn energy_and_momentum_are_kept_over_a_thousand_revolutions() {
    for seed in 1..=20 {
        let [energy, momentum] = long(seed, 1e3);
        assert!(energy < 5e-14 && momentum < 5e-14, "body {seed}: {energy:e} {momentum:e}");
    }
}

/// Over so many steps that their rounding is taken back several times.
#[test]
fn a_body_turns_through_the_same_attitudes_however_fast_it_is() {
    let (moments, omega, step) = (Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.6, 0.3, 1.1), 0.16);
    let after = |slower: f64| {
        let mut rotation =
            FreeRotation::new(moments, UnitQuaternion::identity(), omega / slower, step * slower)
                .expect("a short step");
        for _ in 0..80_000 {
            rotation.advance();
        }
        rotation
    };
    let own = after(1.0);
    for slower in [1024.0, 1.0 / 1024.0] {
        let other = after(slower);
        let off = other.attitude().angle_to(&own.attitude());
        assert!(off < 1e-12, "{slower} times slower: {off:e} rad");
        let off = (other.omega_body() * slower - own.omega_body()).norm();
        assert!(off < 1e-12, "{slower} times slower: {off:e} rad/s");
    }
}

/// Steps of a twentieth of a radian against Jacobi's solution, after a thousand revolutions.
#[test]
fn the_attitude_after_a_thousand_revolutions_is_that_of_jacobi() {
    for (moments, omega) in [
        ([1.0, 2.0, 3.0], [0.6, 0.3, 1.1]),
        ([1.0, 2.0, 2.5], [1.4, 0.2, 0.3]),
        ([0.7, 0.9, 1.5], [0.1, 0.9, 0.8]),
    ] {
        let (moments, omega) = (Vector3::<f64>::from(moments), Vector3::<f64>::from(omega));
        let time = 1e3 * TAU / omega.norm();
        let steps = (time * moments.component_mul(&omega).norm() / moments.min() / 0.05).ceil();
        let mut rotation =
            FreeRotation::new(moments, UnitQuaternion::identity(), omega, time / steps).expect("short steps");
        for _ in 0..steps as u64 {
            rotation.advance();
        }
        let exact = FreeBody::new(moments, omega).expect("a body").attitude(time);
        let off = rotation.attitude().angle_to(&UnitQuaternion::from_rotation_matrix(&exact));
        assert!(off < 1e-9, "{moments:?} turning with {omega:?}: {off:e} rad");
    }
}

#[test]
#[ignore = "minutes; the long bench of the integrator"]
fn energy_and_momentum_are_kept_over_a_million_revolutions() {
    for seed in 1..=20 {
        let [energy, momentum] = long(seed, 1e6);
        println!("body {seed}: energy {energy:e}, momentum {momentum:e}");
        assert!(energy < 1e-12 && momentum < 1e-12, "body {seed}: {energy:e} {momentum:e}");
    }
}

/// `ω_z = ω_z0 + M t/I_a`, and the transverse part turns by `λ ∫ω_z dt`, `λ = (I_a − I_t)/I_t`.
#[test]
fn a_torque_about_the_axis_of_revolution() {
    let (axial, transverse, torque, time) = (2.0, 3.0, 0.5, 6.0);
    let body = free(diagonal(transverse, transverse, axial));
    let loads = Loads {
        gravity: Vector3::zeros(),
        torques: vec![AppliedTorque {
            vector: Vector3::z() * torque,
            in_body: true,
            history: History::Constant,
        }],
    };
    let motion =
        simulate(&body, &start(0.3, 0.0, 1.0), &loads, &RotationRun { duration: time, ..RUN }).unwrap();
    let turned = (axial - transverse) / transverse * (time + torque / axial * time * time / 2.0);
    let wanted = Vector3::new(0.3 * turned.cos(), 0.3 * turned.sin(), 1.0 + torque / axial * time);
    assert!((last(&motion).turning.omega_body - wanted).norm() < 1e-11);
    assert!(motion.energy_drift() < 1e-12 && motion.momentum_drift(None) < 1e-12);
}

/// `ω₁ + iω₂` goes round `(M₂ − iM₁)/(I_t κ)` with `−κ`, `κ = (1 − I_a/I_t) ω₃`.
#[test]
fn a_torque_across_the_axis_of_revolution() {
    let (axial, transverse, time) = (2.0, 3.0, 6.0);
    let body = free(diagonal(transverse, transverse, axial));
    let torque = Vector3::new(0.5, -0.8, 0.0);
    let loads = Loads {
        gravity: Vector3::zeros(),
        torques: vec![AppliedTorque { vector: torque, in_body: true, history: History::Constant }],
    };
    let from = start(0.3, -0.2, 1.4);
    let motion = simulate(&body, &from, &loads, &RotationRun { duration: time, ..RUN }).unwrap();
    let rate = (1.0 - axial / transverse) * from.omega_body.z;
    let middle = Vector3::new(torque.y, -torque.x, 0.0) / (transverse * rate);
    let round = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -rate * time);
    let wanted = middle + round * (from.omega_body - middle);
    assert!((last(&motion).turning.omega_body - wanted).norm() < 1e-10);
    assert!(motion.energy_drift() < 1e-11 && motion.momentum_drift(None) < 1e-11);
}

/// Torques that change, on a triaxial body given in axes that are not principal: what they do is in the balances, and
/// the body's axes change nothing.
#[test]
fn work_and_impulse_of_changing_torques() {
    let turn = UnitQuaternion::new(Vector3::new(0.4, -0.7, 1.1));
    let rotation = turn.to_rotation_matrix().into_inner();
    let inertia = diagonal(1.0, 2.0, 2.5);
    let table = History::Table(vec![[0.0, 0.0], [1.0, 2.0], [1.5, -1.0], [3.0, 0.5]]);
    let torque = |in_body, vector: Vector3<f64>, history| AppliedTorque { vector, in_body, history };
    let harmonic = History::Harmonic { frequency: 3.0, phase: 0.4 };
    let loads = |of: &dyn Fn(Vector3<f64>) -> Vector3<f64>| Loads {
        gravity: Vector3::zeros(),
        torques: vec![
            torque(true, of(Vector3::new(0.3, 0.1, -0.2)), table.clone()),
            torque(false, Vector3::new(0.0, 0.5, 0.2), harmonic.clone()),
        ],
    };
    let run = RotationRun { duration: 4.0, samples: 41, ..RUN };
    let plain = simulate(&free(inertia), &start(0.2, 1.0, -0.3), &loads(&|v| v), &run).unwrap();
    assert!(plain.energy_drift() < 1e-11, "{}", plain.energy_drift());
    assert!(plain.momentum_drift(None) < 1e-11, "{}", plain.momentum_drift(None));
    let body = free(rotation * inertia * rotation.transpose());
    let from = RotationState { attitude: turn.inverse(), omega_body: turn * Vector3::new(0.2, 1.0, -0.3) };
    let turned = simulate(&body, &from, &loads(&|v| turn * v), &run).unwrap();
    for (a, b) in plain.samples.iter().zip_eq(&turned.samples) {
        assert!((a.omega - b.omega).norm() < 1e-10 && (a.work - b.work).abs() < 1e-10);
    }
}

/// A pendulum released level turns through the angle of its end at a known speed: `ω² = 2 m g a sin φ/J`.
#[test]
fn a_motion_ends_at_an_angle_or_a_reversal() {
    let body = RotatingBody { mass: 2.0, inertia: diagonal(1.0, 0.5, 1.2), arm: Vector3::new(0.3, 0.0, 0.0) };
    let loads = Loads { gravity: Vector3::z() * -9.81, torques: Vec::new() };
    let ends = [RotationEvent::Angle { of: Vector3::x(), against: Vector3::z(), angle: FRAC_PI_2 + 1.0 }];
    let run = RotationRun { duration: 5.0, ends: &ends, ..RUN };
    let end = simulate(&body, &start(0.0, 0.0, 0.0), &loads, &run).unwrap();
    assert_eq!(end.ended, Some(0));
    let speed = (2.0 * 2.0 * 9.81 * 0.3 * 1.0_f64.sin() / 0.5).sqrt();
    assert!((last(&end).turning.omega_body.y - speed).abs() < 1e-10);
    let run = RotationRun { duration: 5.0, ends: &[RotationEvent::Reverses(1)], ..RUN };
    let end = simulate(&body, &start(0.0, 0.0, 0.0), &loads, &run).unwrap();
    // It comes to rest on the other side, as high as it began.
    assert!((last(&end).turning.attitude * Vector3::x()).angle(&-Vector3::x()) < 1e-6);
}

#[test]
fn what_cannot_be_followed_is_refused() {
    let none = Loads::default();
    for inertia in [diagonal(1.0, 0.0, 1.0), diagonal(1.0, -1.0, 2.0)] {
        assert_eq!(simulate(&free(inertia), &start(1.0, 0.0, 0.0), &none, &RUN), Err(SimulateError::Inertia));
    }
    let body = free(diagonal(1.0, 2.0, 3.0));
    let endless = RotationRun { duration: f64::INFINITY, ..RUN };
    assert_eq!(simulate(&body, &start(1.0, 0.0, 0.0), &none, &endless), Err(SimulateError::NotFinite));
    let long = RotationRun { duration: 1e9, ..RUN };
    assert!(matches!(simulate_free(&body, &start(1.0, 0.0, 0.0), 0.1, &long), Err(SimulateError::Motion(_))));
    assert!(matches!(
        FreeRotation::new(Vector3::new(1.0, 2.0, 3.0), UnitQuaternion::identity(), Vector3::x(), 1.0),
        Err(SimulateError::Step { .. })
    ));
    // At rest without torques it stays.
    let rest = simulate(&body, &start(0.0, 0.0, 0.0), &none, &RUN).unwrap();
    assert_eq!(last(&rest).omega, Vector3::zeros());
}
