//! The motion again, a little way from a moment that is kept.

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real,
    rigid::simulate::{
        self as follow, History, Loads, RigidBodyMotion, RotatingBody, RotationRun, RotationSample,
        RotationState,
    },
};
use dalembert_numerics::extremes::Extreme;
use nalgebra::Vector3;

/// Error of a state between two steps, in parts of a radian.
pub(super) const INTEGRATION_ERROR: f64 = 1e-10;

/// The state at a time, followed on from the kept moment before it.
pub(super) fn integrated(
    body: &RotatingBody,
    loads: &Loads,
    run: &RotationRun<'_>,
    moved: &RigidBodyMotion,
    time: f64,
) -> Option<RotationState> {
    let before = moved.samples[..moved.samples.partition_point(|sample| sample.time < time)].last()?;
    let mut loads = loads.clone();
    for torque in &mut loads.torques {
        match &mut torque.history {
            History::Constant => {}
            History::Harmonic { frequency, phase } => *phase += *frequency * before.time,
            History::Table(rows) => rows.iter_mut().for_each(|[at, _]| *at -= before.time),
        }
    }
    let run = RotationRun { duration: time - before.time, samples: 2, ends: &[], ..*run };
    let on = follow::simulate(body, &before.turning, &loads, &run).ok()?;
    Some(on.samples.last()?.turning)
}

/// Holds the least and the largest tilt of an axis to the states there, and to those that are kept.
pub(super) fn tilts<W: Worksheet>(
    body: &RotatingBody,
    loads: &Loads,
    run: &RotationRun<'_>,
    moved: &RigidBodyMotion,
    axis: Vector3<f64>,
    shown: [(W::Num, Extreme); 2],
    sheet: W,
) {
    let tilt = |turning: &RotationState| {
        let axis = turning.attitude * axis;
        axis.xy().norm().atan2(axis.z)
    };
    let [(least, _), (largest, _)] = shown;
    for (angle, at) in shown {
        let Some(there) = integrated(body, loads, run, moved, at.time) else { continue };
        let what = "the minimum and maximum tilt, continued from the previous instant";
        sheet.check_residual(what, (angle.value() - tilt(&there)).into(), 1.0, INTEGRATION_ERROR);
    }
    let beyond = moved.samples.iter().map(|sample| tilt(&sample.turning));
    let beyond = beyond.map(|tilt| (least.value() - tilt).max(tilt - largest.value()).max(0.0));
    sheet.check_zeros("no tilt during the motion lies outside the minimum and the maximum", beyond, 1.0);
}

/// The largest energy of a moment.
pub(super) fn energy(sample: &RotationSample) -> f64 {
    sample.kinetic.max(sample.potential.abs()).max(sample.work.abs())
}
