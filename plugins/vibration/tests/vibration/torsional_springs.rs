//! Torsional springs by their tables, and networks of them.

use dalembert_core::{FieldPath, Inputs, Lift, Plain, Stop};
use dalembert_vibration::{
    shared::section::{RoundSection, Section, ShaftSection},
    shared::spring::{
        ShearModulus, Spring,
        torsional::{TorsionalSpring, stiffness},
    },
};

fn stiffness_of(spring: &TorsionalSpring) -> f64 {
    let stop = Stop::new();
    let plain = Plain::new(&stop);
    let given = spring.given(Lift { sheet: &plain, value: None, field_path: &FieldPath::TOP });
    stiffness(&given, &plain).unwrap()
}

fn close(computed: f64, expected: f64) {
    assert!((computed - expected).abs() <= 1e-12 * expected.abs(), "{computed} is not {expected}");
}

#[test]
fn a_hollow_shaft_of_half_the_bore_loses_a_sixteenth() {
    let shaft =
        |section| TorsionalSpring::Shaft { length: 0.7, shear: ShearModulus::Given { shear: 80e9 }, section };
    let solid = stiffness_of(&shaft(ShaftSection::Round(RoundSection::Round { diameter: 0.04 })));
    let hollow = stiffness_of(&shaft(ShaftSection::Round(RoundSection::Tube { outer: 0.04, inner: 0.02 })));
    close(hollow, solid * 15.0 / 16.0);
}

#[test]
fn a_beam_turned_at_its_end() {
    // E I/L = 200 N m: 1, 3 and 4 times for a cantilever, a simply supported and a propped beam.
    let (length, young) = (2.0, 2e11);
    let section = || Section::Given { second_moment: 2e-9 };
    close(stiffness_of(&TorsionalSpring::Cantilever { length, young, section: section() }), 200.0);
    close(stiffness_of(&TorsionalSpring::SimplySupported { length, young, section: section() }), 600.0);
    close(stiffness_of(&TorsionalSpring::ClampedPinned { length, young, section: section() }), 800.0);
    close(stiffness_of(&TorsionalSpring::Spiral { length, young, section: section() }), 200.0);
}

#[test]
fn a_helical_spring_turned_bends_its_unwound_wire() {
    let (young, wire_diameter, coil_diameter, coils) = (200e9, 0.004, 0.03, 8.0);
    let helical = TorsionalSpring::Helical { young, wire_diameter, coil_diameter, coils };
    let wire = TorsionalSpring::Spiral {
        length: std::f64::consts::PI * coil_diameter * coils,
        young,
        section: Section::Round(RoundSection::Round { diameter: wire_diameter }),
    };
    close(stiffness_of(&helical), stiffness_of(&wire));
}

#[test]
fn arms_gears_and_what_gravity_brings_back() {
    let linear = |stiffness| Spring::Stiffness { stiffness };
    close(stiffness_of(&TorsionalSpring::Arm { arm: 0.5, members: vec![linear(3.0), linear(5.0)] }), 2.0);
    let behind = TorsionalSpring::Stiffness { stiffness: 7.0 };
    close(stiffness_of(&TorsionalSpring::Gears { ratio: 3.0, members: vec![behind] }), 63.0);
    close(stiffness_of(&TorsionalSpring::Pendulum { mass: 2.0, distance: 0.5, gravity: 9.81 }), 9.81);
    let wires = TorsionalSpring::Wires { mass: 2.0, radius: 0.5, length: 0.25, gravity: 9.81 };
    close(stiffness_of(&wires), 19.62);
}
