//! Benchmark of a rigid body in space: a million steps of a free rotation that conserves energy and angular momentum,
//! and the heavy top of the benchmark to 10⁻⁹.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them. MuJoCo is timed in the
//! same run where it is installed: its ratio to ours is what can be compared.

use std::{hint::black_box, time::Instant};

use dalembert_mechanics::rigid::simulate::{
    FreeRotation, Loads, RotatingBody, RotationRun, RotationState, simulate,
};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

#[path = "yardstick/python.rs"]
mod python;

const STEPS: usize = 1_000_000;
const ROUNDS: usize = 7;

/// MuJoCo on the same body, by Runge and Kutta; prints the seconds of its million steps.
const YARDSTICK: &str = "
import time, mujoco
m = mujoco.MjModel.from_xml_string('<mujoco><compiler balanceinertia=\"false\"/>'
    '<option timestep=\"1e-4\" gravity=\"0 0 0\" integrator=\"RK4\"><flag contact=\"disable\"/></option><worldbody><body>'
    '<freejoint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 2 3\"/></body></worldbody></mujoco>')
d = mujoco.MjData(m); d.qvel[-3:] = [.01, 5, .01]
t = time.perf_counter(); mujoco.mj_step(m, d, 1000000); print(time.perf_counter() - t)
";

fn main() {
    free();
    heavy_top();
}

/// 100 s of a body near its unstable axis, in steps of 0.1 ms.
fn free() {
    let moments = Vector3::new(1.0, 2.0, 3.0);
    let omega = Vector3::new(0.01, 5.0, 0.01);
    let start = FreeRotation::new(moments, UnitQuaternion::identity(), omega, 1e-4);
    let start = start.expect("a step of half a milliradian is short enough");
    let mut end = start.clone();
    let time = best(|| {
        end = black_box(&start).clone();
        (0..STEPS).for_each(|_| end.advance());
        black_box(&end);
    });
    let beside =
        python::figures(YARDSTICK).map_or(String::new(), |[seconds]| format!(", MuJoCo {seconds:.2} s"));
    println!("free rotation, 1e6 steps\t{:.3} s{beside}\t≤ 0.06 s (MuJoCo 4.1 s)", time / 1e3);
    let energy = (end.energy() / start.energy() - 1.0).abs();
    let momentum =
        (end.momentum_in_space() - start.momentum_in_space()).norm() / start.momentum_in_space().norm();
    println!("free rotation, drift of energy and of angular momentum\t{energy:.0e}, {momentum:.0e}\t≤ 1e-12");
    // A Taylor series in 30 digits.
    let exact = Vector3::new(0.06021783543923199, 4.999647368794625, 0.03571268544456075);
    println!("free rotation, error of ω after 100 s\t{:.0e} rad/s\t", (end.omega_body() - exact).amax());
}

/// 2 s of the top of Brüls, Cardona and Arnold.
fn heavy_top() {
    let body = RotatingBody {
        mass: 15.0,
        inertia: Matrix3::from_diagonal(&Vector3::new(15.234375, 0.46875, 15.234375)),
        arm: Vector3::y(),
    };
    let from = RotationState {
        attitude: UnitQuaternion::identity(),
        omega_body: Vector3::new(0.0, 150.0, -4.61538),
    };
    let loads = Loads { gravity: Vector3::z() * -9.81, torques: Vec::new() };
    let run = RotationRun {
        duration: 2.0,
        tolerance: 1e-11,
        samples: 2,
        ends: &[],
        most_steps: 100_000,
        cancelled: &|| false,
    };
    let mut found = None;
    let time = best(|| found = Some(simulate(black_box(&body), black_box(&from), &loads, &run)));
    let motion = found.expect("it ran").expect("the top can be followed");
    let end = motion.samples.last().expect("a motion has its end");
    let centre = end.turning.attitude * body.arm;
    let exact = Vector3::new(-0.150416822747, -0.724165591637, -0.673022269560);
    println!("heavy top, 2 s\t{time:.3} ms\t≤ 0.25 ms");
    println!("heavy top, error of the centre of mass\t{:.0e} m\t≤ 1e-9", (centre - exact).norm());
    println!("heavy top, error of ω_y\t{:.0e} rad/s\t≤ 1e-8", (end.omega.y + 106.163804142).abs());
    let drift = (motion.energy_drift(), motion.momentum_drift(Some(loads.gravity)));
    println!("heavy top, drift of energy and of H_Z\t{:.0e}, {:.0e}\t≤ 1e-10", drift.0, drift.1);
}

/// The shortest of some rounds, in milliseconds.
fn best(mut work: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        work();
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    best
}
