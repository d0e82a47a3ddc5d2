//! Benchmark of a rotor of thirty elements: a Campbell diagram at fifty speeds, and its unbalance response at 501.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them. ROSS is timed in the same
//! run where it is installed: the ratio to it is what can be compared.

use std::{hint::black_box, time::Instant};

use dalembert_mechanics::rotor::{
    Assembled, BearingSupport, Coefficients, RigidDisc, Rotor,
    campbell::campbell,
    disc,
    element::{BeamTheory, Material, ShaftElement},
    modes::ReducedRotor,
    response::{Unbalance, unbalance_response},
};

#[path = "yardstick/python.rs"]
mod python;

/// Milliseconds of ROSS for the same rotor.
const YARDSTICK: &str = include_str!("yardstick/rotor.py");

const ELEMENTS: usize = 30;
const ROUNDS: usize = 9;

fn main() {
    let modes = |count: usize| {
        measure(|| {
            let rotor = Assembled::new(&rotor()).expect("the rotor is well formed");
            let reduced = ReducedRotor::new(&rotor, count, &[0.0, 1000.0]).expect("the rotor has modes");
            let speeds: Vec<f64> = (0..50).map(|n| f64::from(n) * 1000.0 / 49.0).collect();
            black_box(campbell(&reduced, &speeds).expect("the rotor has modes"));
        })
    };
    // Six modes are what the Campbell diagram of the yardstick shows.
    let (six, twelve) = (modes(6), modes(12));
    let response = measure(|| {
        let rotor = Assembled::new(&rotor()).expect("the rotor is well formed");
        let unbalance = Unbalance { node: ELEMENTS / 3, size: 1e-3, angle: 0.0 };
        for n in 0..501 {
            let speed = f64::from(n) * 1000.0 / 500.0;
            black_box(unbalance_response(&rotor, &[unbalance], speed).expect("the rotor is damped"));
        }
    });
    println!("rotor of 30 elements, 6 modes at 50 speeds\t{six:.1} ms\t");
    println!("rotor of 30 elements, 12 modes at 50 speeds\t{twelve:.1} ms\t");
    println!("rotor of 30 elements, unbalance at 501 speeds\t{response:.1} ms\t");
    let ross = python::figures(YARDSTICK).map_or(String::new(), |[both]| format!(" (ROSS {both:.0} ms)"));
    println!(
        "rotor of 30 elements, 6 modes and unbalance\t{:.1} ms{ross}\t≤ 50 ms (ROSS 5300 ms)",
        six + response
    );
}

/// The median time of a few rounds, ms.
fn measure(work: impl Fn()) -> f64 {
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}

fn rotor() -> Rotor {
    let material =
        Material { young: 211e9, shear: 81.2e9, density: 7810.0, viscous_damping: 0.0, loss_factor: 0.0 };
    let element = ShaftElement { length: 1.5 / ELEMENTS as f64, outer: [0.05; 2], inner: [0.0; 2], material };
    let mass = disc::mass(7810.0, 0.28, 0.05, 0.07);
    let polar = disc::polar(mass, 0.28, 0.05);
    let diametral = disc::diametral(mass, polar, 0.07);
    let bearing = Coefficients::orthotropic([1e6, 0.8e6], [200.0, 150.0]);
    Rotor {
        elements: vec![element; ELEMENTS],
        theory: BeamTheory::Timoshenko,
        tension: 0.0,
        discs: [ELEMENTS / 3, 2 * ELEMENTS / 3]
            .map(|node| RigidDisc { node, mass, diametral, polar })
            .to_vec(),
        supports: [0, ELEMENTS].map(|node| BearingSupport::bearing(node, bearing)).to_vec(),
    }
}
