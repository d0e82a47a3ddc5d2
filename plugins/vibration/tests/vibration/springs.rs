//! Springs by their tables, and networks of them.

use dalembert_core::{FieldPath, Inputs, Lift, Plain, Refusal, Stop};
use dalembert_vibration::{
    shared::section::{RoundSection, Section, ShaftSection},
    shared::spring::{ShearModulus, Spring, stiffness},
};
use itertools::Itertools as _;

fn stiffness_of(spring: &Spring) -> Result<f64, Refusal> {
    let stop = Stop::new();
    let plain = Plain::new(&stop);
    let given = spring.given(Lift { sheet: &plain, value: None, field_path: &FieldPath::TOP });
    stiffness(&given, &plain)
}

fn close(computed: f64, expected: f64) {
    assert!((computed - expected).abs() <= 1e-12 * expected.abs(), "{computed} is not {expected}");
}

fn given(stiffness: f64) -> Spring {
    Spring::Stiffness { stiffness }
}

fn section() -> Section {
    Section::Rectangle { breadth: 0.04, height: 0.01 }
}

/// The three beams whose load may stand anywhere.
fn beams(distance: Option<f64>) -> [Spring; 3] {
    let (length, young) = (1.2, 210e9);
    [
        Spring::SimplySupported { length, distance, young, section: section() },
        Spring::Clamped { length, distance, young, section: section() },
        Spring::ClampedPinned { length, distance, young, section: section() },
    ]
}

#[test]
fn a_network_is_its_series_and_parallels() {
    let parallel = Spring::Parallel { members: vec![given(1.0), given(2.0)] };
    let network = Spring::Series { members: vec![parallel, given(6.0), given(2.0)] };
    close(stiffness_of(&network).unwrap(), 1.0);
    let one = Spring::Series { members: vec![Spring::Parallel { members: vec![given(7.0)] }] };
    close(stiffness_of(&one).unwrap(), 7.0);
}

#[test]
fn a_load_without_a_distance_is_at_the_middle() {
    for (middle, placed) in beams(None).iter().zip_eq(&beams(Some(0.6))) {
        close(stiffness_of(middle).unwrap(), stiffness_of(placed).unwrap());
    }
}

#[test]
fn beams_by_their_tables() {
    // E I = 700 N m²; 48, 192 and 768/7 times E I/L³.
    let [simple, clamped, mixed] = beams(None).map(|beam| stiffness_of(&beam).unwrap());
    close(simple, 48.0 * 700.0 / 1.728);
    close(clamped, 4.0 * simple);
    close(mixed, 16.0 / 7.0 * simple);
}

#[test]
fn a_load_at_the_far_support_is_refused() {
    for beam in beams(Some(1.2)) {
        let refusal = stiffness_of(&beam).unwrap_err().to_string();
        assert!(refusal.contains("write a distance smaller than the span"), "{refusal}");
    }
}

#[test]
fn a_tube_needs_a_wall() {
    let tube = |inner| Spring::Cantilever {
        length: 1.0,
        young: 1.0,
        section: Section::Round(RoundSection::Tube { outer: 0.1, inner }),
    };
    assert!(stiffness_of(&tube(0.1)).unwrap_err().to_string().contains("outer"));
    // I = π(D⁴ − d⁴)/64: half the diameter inside takes a sixteenth away.
    let solid = Spring::Cantilever {
        length: 1.0,
        young: 1.0,
        section: Section::Round(RoundSection::Round { diameter: 0.1 }),
    };
    close(stiffness_of(&tube(0.05)).unwrap(), stiffness_of(&solid).unwrap() * 15.0 / 16.0);
}

#[test]
fn a_torsion_bar_is_a_helical_spring_unwound() {
    // A wire of n turns is a torsion bar of length π D n on a lever D/2: k = G d⁴/(8 D³ n).
    let (wire_diameter, coil_diameter, coils) = (0.02, 0.2, 5.0);
    let shear = || ShearModulus::Given { shear: 80e9 };
    let helical = Spring::Helical { shear: shear(), wire_diameter, coil_diameter, coils };
    let bar = Spring::TorsionBar {
        length: std::f64::consts::PI * coil_diameter * coils,
        shear: shear(),
        section: ShaftSection::Round(RoundSection::Round { diameter: wire_diameter }),
        lever: coil_diameter / 2.0,
    };
    close(stiffness_of(&helical).unwrap(), 40e3);
    close(stiffness_of(&bar).unwrap(), 40e3);
}

#[test]
fn a_lever_and_an_inclination_count_twice() {
    let lever = Spring::Lever { spring_arm: 0.5, load_arm: 2.0, members: vec![given(9.0), given(7.0)] };
    close(stiffness_of(&lever).unwrap(), 1.0);
    let inclined =
        Spring::Inclined { angle: std::f64::consts::FRAC_PI_3, members: vec![given(3.0), given(5.0)] };
    close(stiffness_of(&inclined).unwrap(), 2.0);
}

#[test]
fn what_gravity_and_tension_bring_back() {
    let g = 9.81;
    close(stiffness_of(&Spring::TautString { tension: 10.0, left: 2.0, right: 0.5 }).unwrap(), 25.0);
    close(stiffness_of(&Spring::Pendulum { mass: 2.0, length: 0.5, gravity: g }).unwrap(), 4.0 * g);
    close(stiffness_of(&Spring::Buoyancy { density: 1e3, area: 0.1, gravity: g }).unwrap(), 100.0 * g);
    close(stiffness_of(&Spring::UTube { density: 1e3, area: 0.1, gravity: g }).unwrap(), 200.0 * g);
    let gas = Spring::Gas { exponent: 1.4, pressure: 5e5, area: 0.01, volume: 0.002 };
    close(stiffness_of(&gas).unwrap(), 35e3);
}
