//! Tests of `rotor`.

use dalembert_mechanics::rotor::{
    campbell::campbell,
    element::{BeamTheory, Material, ShaftElement},
    mesh::{Segment, mesh},
    modes::{ReducedRotor, WhirlDirection, WhirlMode},
    response::{Unbalance, unbalance_response},
    *,
};
use dalembert_mechanics::section;
use itertools::Itertools as _;

const STEEL: Material =
    Material { young: 211e9, shear: 81.2e9, density: 7810.0, viscous_damping: 0.0, loss_factor: 0.0 };

/// 1.5 m of 50 mm shaft with two equal discs at the thirds.
fn two_discs(elements: usize, bearing: Coefficients) -> Rotor {
    let element =
        ShaftElement { length: 1.5 / elements as f64, outer: [0.05; 2], inner: [0.0; 2], material: STEEL };
    let mass = disc::mass(7810.0, 0.28, 0.05, 0.07);
    let polar = disc::polar(mass, 0.28, 0.05);
    let diametral = disc::diametral(mass, polar, 0.07);
    Rotor {
        elements: vec![element; elements],
        theory: BeamTheory::Timoshenko,
        tension: 0.0,
        discs: [elements / 3, 2 * elements / 3]
            .map(|node| RigidDisc { node, mass, diametral, polar })
            .to_vec(),
        supports: [0, elements].map(|node| BearingSupport::bearing(node, bearing)).to_vec(),
    }
}

fn close(ours: f64, theirs: f64, relative: f64, what: &str) {
    assert!((ours - theirs).abs() <= relative * theirs.abs(), "{what}: {ours} is not {theirs}");
}

/// A speed, natural frequencies and damping ratios there.
type Row = (f64, [f64; 6], [f64; 4]);

/// Natural frequencies of ROSS 2.3.0 for its example rotor and for a finer, damped one.
#[test]
fn natural_frequencies_agree_with_another_program_to_eight_digits() {
    let undamped = Assembled::new(&two_discs(6, Coefficients::orthotropic([1e6, 0.8e6], [0.0; 2]))).unwrap();
    let damped =
        Assembled::new(&two_discs(30, Coefficients::orthotropic([1e6, 0.8e6], [200.0, 150.0]))).unwrap();
    let coarse: [Row; 2] = [
        (0.0, [91.79655318, 96.28899977, 274.56594513, 296.50048532, 722.89787495, 765.00042916], [0.0; 4]),
        (100.0, [91.7867699, 96.29604015, 274.05989215, 296.99412467, 717.35166009, 770.20362427], [0.0; 4]),
    ];
    let fine: [Row; 3] = [
        (
            0.0,
            [91.7998268747, 96.2931777077, 274.6378558191, 296.6173012617, 722.8162835349, 765.0453931282],
            [0.00392825, 0.00385417, 0.01841769, 0.01960551],
        ),
        (
            400.0,
            [91.6467743277, 96.4023387288, 268.2142883262, 302.8430875382, 674.6234490146, 0.0],
            [0.00387923, 0.00389693, 0.01882543, 0.01908382],
        ),
        (
            1000.0,
            [90.9334237425, 96.8854093548, 250.1493503231, 319.9157534865, 577.0680289530, 0.0],
            [0.00368016, 0.00406332, 0.01920090, 0.01812653],
        ),
    ];
    for (rotor, rows) in [(&undamped, &coarse[..]), (&damped, &fine[..])] {
        let speeds: Vec<f64> = rows.iter().map(|row| row.0).collect();
        let reduced = ReducedRotor::new(rotor, 6, &speeds).unwrap();
        for (speed, natural, damping) in rows {
            let modes = reduced.modes(*speed).unwrap().modes;
            for (n, (mode, theirs)) in modes.iter().zip_eq(natural).enumerate() {
                if *theirs > 0.0 {
                    close(mode.lambda.norm(), *theirs, 5e-9, &format!("mode {n} at {speed} rad/s"));
                    let exact = modes::polished(rotor, mode, *speed).unwrap().mode.lambda;
                    assert!((exact - mode.lambda).norm() < 1e-9 * exact.norm());
                }
                if let Some(zeta) = damping.get(n) {
                    let found = -mode.lambda.re / mode.lambda.norm();
                    assert!((found - zeta).abs() < 6e-9, "{found} {zeta}");
                }
            }
        }
    }
}

/// Unbalance response of ROSS 2.3.0 at the first disc, along x.
#[test]
fn unbalance_response_agrees_with_another_program_to_eight_digits() {
    let published = [
        (6, [1.6859023349e-4, 3.6138382167e-5, 1.7587913240e-5]),
        (30, [1.6858131559e-4, 3.6130967620e-5, 1.7521538389e-5]),
        (60, [1.6858122341e-4, 3.6130890106e-5, 1.7520807270e-5]),
    ];
    for (elements, row) in published {
        let rotor = two_discs(elements, Coefficients::orthotropic([1e6, 0.8e6], [200.0, 150.0]));
        let rotor = Assembled::new(&rotor).unwrap();
        let unbalance = Unbalance { node: elements / 3, size: 1e-3, angle: 0.0 };
        for (speed, theirs) in [100.0, 400.0, 1000.0].into_iter().zip_eq(row) {
            let response = unbalance_response(&rotor, &[unbalance], speed).unwrap();
            close(
                response[elements / 3][0].norm(),
                theirs,
                1e-9,
                &format!("{elements} elements, {speed} rad/s"),
            );
        }
    }
}

#[test]
fn directions_of_a_symmetric_rotor_alternate() {
    let rotor = Assembled::new(&two_discs(6, Coefficients::isotropic(1e6, 0.0))).unwrap();
    let speeds: Vec<f64> = (0..=20).map(|n| f64::from(n) * 20.0).collect();
    let reduced = ReducedRotor::new(&rotor, 6, &[0.0, 400.0]).unwrap();
    let diagram = campbell(&reduced, &speeds).unwrap();
    assert_eq!(diagram.branches.len(), 6);
    for (n, branch) in diagram.branches.iter().enumerate() {
        for mode in branch[1..].iter().flatten() {
            assert_ne!(mode.direction(), WhirlDirection::Mixed, "{n}");
            assert_ne!(mode.direction(), WhirlDirection::Planar, "{n}");
        }
    }
}

/// The rotor of Nelson and McVaugh (1976): ends of the stations (mm), outer and inner diameters (mm).
const STATIONS: [(f64, f64, f64); 18] = [
    (12.7, 10.2, 0.0),
    (50.8, 20.4, 0.0),
    (76.2, 15.2, 0.0),
    (88.9, 40.6, 0.0),
    (101.6, 40.6, 0.0),
    (106.7, 66.0, 0.0),
    (114.3, 66.0, 30.4),
    (127.0, 50.8, 35.6),
    (134.6, 50.8, 0.0),
    (165.1, 25.4, 0.0),
    (190.5, 25.4, 0.0),
    (228.6, 30.4, 0.0),
    (266.7, 30.4, 0.0),
    (287.0, 25.4, 0.0),
    (304.8, 25.4, 0.0),
    (315.0, 76.2, 0.0),
    (345.4, 40.6, 0.0),
    (355.0, 40.6, 30.4),
];

fn nelson_mcvaugh() -> Rotor {
    let material = Material { young: 207.8e9, shear: 81e9, density: 7806.0, ..STEEL };
    let mut from = 0.0;
    let segments: Vec<Segment> = STATIONS
        .iter()
        .map(|&(to, outer, inner)| {
            let length = (to - from) * 1e-3;
            from = to;
            Segment { length, outer: [outer * 1e-3; 2], inner: [inner * 1e-3; 2], material }
        })
        .collect();
    let mesh = mesh(&segments, &[0.0889, 0.1651, 0.287], 1).expect("the stations lie on the shaft");
    assert_eq!(mesh.stations, [4, 10, 14]);
    Rotor {
        elements: mesh.elements,
        theory: BeamTheory::EulerBernoulli,
        tension: 0.0,
        discs: vec![RigidDisc { node: 4, mass: 1.401, diametral: 0.00136, polar: 0.002 }],
        supports: [10, 14]
            .map(|node| BearingSupport::bearing(node, Coefficients::isotropic(4.378e7, 0.0)))
            .to_vec(),
    }
}

#[test]
fn critical_speeds_found_directly_are_where_the_branches_cross_the_line() {
    let rotor = Assembled::new(&nelson_mcvaugh()).unwrap();
    let rpm = std::f64::consts::PI / 30.0;
    for (slope, highest, ours) in [
        (1.0, 1e5, [15486.33, 17148.06, 46749.43, 50127.68, 64857.59, 95882.9]),
        (4.0, 2.1e4, [4016.807, 4120.531, 12024.92, 12235.9, 18188.97, 20130.45]),
    ] {
        let reduced = ReducedRotor::new(&rotor, 8, &[0.0, highest * rpm]).unwrap();
        let speeds: Vec<f64> = (0..=20).map(|n| f64::from(n) * highest * rpm / 20.0).collect();
        let diagram = campbell(&reduced, &speeds).unwrap();
        let crossings = critical::crossings(&reduced, &diagram, slope).unwrap().found;
        let direct = critical::direct(&reduced, slope, highest * rpm).unwrap().found;
        assert_eq!(direct.len(), crossings.len());
        for ((direct, crossing), ours) in direct.iter().zip_eq(&crossings).zip_eq(ours) {
            close(direct.speed, crossing.speed, 1e-9, "critical speed");
            close(direct.speed / rpm, ours, 1e-6, "critical speed");
        }
    }
}

#[test]
fn the_range_of_critical_speeds_ends_where_it_is_said_to() {
    let rotor = Assembled::new(&nelson_mcvaugh()).unwrap();
    let highest = 1e4;
    let speeds = |reduced: &ReducedRotor<'_>, highest: f64| -> Vec<f64> {
        let criticals = critical::direct(reduced, 1.0, highest).unwrap();
        criticals.found.iter().map(|critical| critical.speed).collect()
    };
    let rough = speeds(&ReducedRotor::new(&rotor, 8, &[0.0, highest]).unwrap(), highest);
    let reduced = ReducedRotor::new(&rotor, 8, &rough).unwrap();
    let all = speeds(&reduced, highest);
    assert_eq!(all.len(), 5);
    for (n, speed) in all.iter().enumerate() {
        assert_eq!(speeds(&reduced, speed * (1.0 + 1e-9)), all[..=n]);
        assert_eq!(speeds(&reduced, speed * (1.0 - 1e-9)), all[..n]);
    }
}

/// A heavy end of a bar that turns about its other end: a spring along `x` that stiffens with the speed, so that
/// `m ω² = k(Ω)` passes the line upwards, and a damper along `y` that lets that motion swing from a speed beyond on.
#[test]
fn a_critical_speed_is_found_where_another_motion_begins_to_swing() {
    let (length, diameter): (f64, f64) = (0.5, 0.04);
    let material = Material { density: 1.0, ..STEEL };
    let mut rotor = uniform(1, length, diameter, material, &SupportType::Pinned);
    let row = |speed: f64, k: f64, c: f64| (speed, Coefficients::orthotropic([k, 36e3], [0.0, c]));
    let [from, to] = [64e3, 529e3];
    rotor.supports[1].hold = SupportType::Bearing(vec![row(100.0, from, 1440.0), row(200.0, to, 600.0)]);
    rotor.discs = vec![RigidDisc { node: 1, mass: 10.0, diametral: 1e-4, polar: 0.0 }];
    let (area, moment) = (section::round_area(diameter), section::round_second_moment(diameter));
    let mass = 10.0 + 1e-4 / length.powi(2) + length * (area / 3.0 + moment / length.powi(2));
    let rise = (to - from) / 100.0;
    let speed = (rise - (rise * rise - 4.0 * mass * (100.0 * rise - from)).sqrt()) / (2.0 * mass);

    let rotor = Assembled::new(&rotor).unwrap();
    let reduced = ReducedRotor::new(&rotor, 2, &[100.0, 200.0]).unwrap();
    let diagram = campbell(&reduced, &[100.0, 200.0]).unwrap();
    assert_eq!([0, 1].map(|n| diagram.spectra[n].overdamped.is_empty()), [false, true]);
    let criticals = critical::crossings(&reduced, &diagram, 1.0).unwrap();
    assert_eq!((criticals.found.len(), criticals.lost.len()), (1, 0));
    close(criticals.found[0].speed, speed, 1e-7, "critical speed");
}

#[test]
fn the_nodes_of_a_tapered_shaft_have_its_diameters() {
    let segments = [
        Segment { length: 0.37, outer: [0.05, 0.083], inner: [0.011, 0.024], material: STEEL },
        Segment { length: 0.21, outer: [0.061, 0.04], inner: [0.02, 0.013], material: STEEL },
    ];
    let stations = [0.45, 0.23];
    let mesh = mesh(&segments, &stations, 3).unwrap();
    let mut at = 0.0;
    let mut nodes = vec![at];
    for element in &mesh.elements {
        let (segment, start) = if at < 0.37 - 1e-9 { (&segments[0], 0.0) } else { (&segments[1], 0.37) };
        for (end, place) in [at, at + element.length].into_iter().enumerate() {
            let share = (place - start) / segment.length;
            for (ours, whole) in [(element.outer, segment.outer), (element.inner, segment.inner)] {
                close(ours[end], whole[0] + share * (whole[1] - whole[0]), 1e-12, "diameter");
            }
        }
        at += element.length;
        nodes.push(at);
    }
    assert_eq!(mesh.elements.len(), 12);
    close(at, 0.58, 1e-12, "length");
    for (station, node) in stations.iter().zip_eq(mesh.stations) {
        close(nodes[node], *station, 1e-12, "station");
    }
}

/// A uniform shaft between two equal supports.
fn uniform(elements: usize, length: f64, diameter: f64, material: Material, hold: &SupportType) -> Rotor {
    let element =
        ShaftElement { length: length / elements as f64, outer: [diameter; 2], inner: [0.0; 2], material };
    Rotor {
        elements: vec![element; elements],
        theory: BeamTheory::EulerBernoulli,
        tension: 0.0,
        discs: Vec::new(),
        supports: [0, elements].map(|node| BearingSupport { node, hold: hold.clone() }).to_vec(),
    }
}

/// Internal damping alone is marginal where the whirl is as fast as the spin: at the forward critical speed.
#[test]
fn internal_damping_turns_a_shaft_unstable_at_its_first_forward_critical_speed() {
    let material =
        Material { young: 210e9, shear: 81e9, density: 7800.0, viscous_damping: 2e-4, loss_factor: 0.0 };
    let bearing = SupportType::Bearing(vec![(0.0, Coefficients::isotropic(1.75e7, 0.0))]);
    for hold in [bearing, SupportType::Pinned] {
        let rotor = Assembled::new(&uniform(5, 1.27, 0.1016, material, &hold)).unwrap();
        let speeds: Vec<f64> = (0..=16).map(|n| f64::from(n) * 1600.0 / 16.0).collect();
        let reduced = ReducedRotor::new(&rotor, 4, &[539.25, 1600.0]).unwrap();
        let diagram = campbell(&reduced, &speeds).unwrap();
        let instability = critical::instability(&reduced, &diagram).unwrap();
        assert_eq!((instability.bands.len(), instability.lost.len()), (1, 0));
        assert_eq!(instability.bands[0].to, None);
        let threshold = instability.bands[0].from.clone().unwrap();
        assert_eq!(threshold.mode.direction(), WhirlDirection::Forward);
        let criticals = critical::crossings(&reduced, &diagram, 1.0).unwrap().found;
        let first =
            criticals.iter().find(|critical| critical.mode.direction() == WhirlDirection::Forward).unwrap();
        close(threshold.speed, first.speed, 1e-9, "threshold");
    }
}

/// Frequencies of a uniform shaft on rigid bearings: `ρA(1 + Ik²/A)ω² ∓ 2ρIk²Ωω = EIk⁴ + Tk²` with `k = nπ/L`.
#[test]
fn a_uniform_shaft_on_rigid_bearings_whirls_as_the_closed_form_says() {
    let (length, diameter) = (1.0, 0.04);
    let (area, moment) = (section::round_area(diameter), section::round_second_moment(diameter));
    for (tension, speed) in [0.0, 3e5, -1e5].into_iter().cartesian_product([0.0, 700.0, 5000.0]) {
        let shaft = uniform(24, length, diameter, STEEL, &SupportType::Pinned);
        let rotor = Assembled::new(&Rotor { tension, ..shaft }).unwrap();
        let modes = ReducedRotor::new(&rotor, 4, &[speed]).unwrap().modes(speed).unwrap().modes;
        for (n, pair) in modes.chunks(2).enumerate() {
            let k = (n as f64 + 1.0) * std::f64::consts::PI / length;
            let a = STEEL.density * (area + moment * k.powi(2));
            let b = STEEL.density * moment * k.powi(2) * speed;
            let held = STEEL.young * moment * k.powi(4) + tension * k.powi(2);
            let root = (b * b + a * held).sqrt();
            close(pair[0].frequency(), (root - b) / a, 5e-6, "backward");
            close(pair[1].frequency(), (root + b) / a, 5e-6, "forward");
            if speed > 0.0 {
                assert_eq!(pair[0].direction(), WhirlDirection::Backward);
                assert_eq!(pair[1].direction(), WhirlDirection::Forward);
            }
        }
    }
}

/// `a z̈ + (ηᵥe − iΩg) ż + e ((1 + ηₕ)/p − i(Ωηᵥ + ηₕ/p)) z = 0` with `z = x + iy`, `e = EIk⁴` and `p = √(1 + ηₕ²)`.
#[test]
fn internal_damping_of_a_uniform_shaft_has_a_closed_form() {
    let (length, diameter): (f64, f64) = (1.0, 0.04);
    let (area, moment) = (section::round_area(diameter), section::round_second_moment(diameter));
    for (viscous_damping, loss_factor) in [(4e-5, 0.0), (0.0, 0.03), (3e-5, 0.02)] {
        let material = Material { viscous_damping, loss_factor, ..STEEL };
        let rotor = Assembled::new(&uniform(40, length, diameter, material, &SupportType::Pinned)).unwrap();
        let phase = f64::hypot(loss_factor, 1.0);
        for speed in [200.0, 900.0] {
            let modes = ReducedRotor::new(&rotor, 4, &[speed]).unwrap().modes(speed).unwrap().modes;
            for (n, pair) in modes.chunks(2).enumerate() {
                let k = (n as f64 + 1.0) * std::f64::consts::PI / length;
                let a = STEEL.density * (area + moment * k.powi(2));
                let e = STEEL.young * moment * k.powi(4);
                let b = Complex::new(viscous_damping * e, -2.0 * STEEL.density * moment * k.powi(2) * speed);
                let across = speed * viscous_damping + loss_factor / phase;
                let c = Complex::new((1.0 + loss_factor) / phase, -across) * e;
                let root = (b * b - c * (4.0 * a)).sqrt();
                // With the spin, and against it as its conjugate.
                let lambda = |root: Complex<f64>| (root - b) / (2.0 * a);
                let mut theirs =
                    [root, -root].map(lambda).map(|lambda| Complex::new(lambda.re, lambda.im.abs()));
                theirs.sort_by(|one, other| one.im.total_cmp(&other.im));
                for (mode, theirs) in pair.iter().zip_eq(theirs) {
                    let ours = modes::polished(&rotor, mode, speed).unwrap().mode.lambda;
                    assert!((ours - theirs).norm() < 2e-6 * theirs.norm(), "{ours} is not {theirs}");
                }
            }
        }
    }
}

/// Euler's load, Engesser's `1/(1/P + 1/κGA)` where the shaft shears, and `kL/2` where the bearings give way before.
#[test]
fn a_compressed_shaft_is_refused_from_its_buckling_load_on() {
    let (length, diameter): (f64, f64) = (1.3, 0.04);
    let (area, moment) = (section::round_area(diameter), section::round_second_moment(diameter));
    let euler = (std::f64::consts::PI / length).powi(2) * STEEL.young * moment;
    let poisson = STEEL.young / (2.0 * STEEL.shear) - 1.0;
    let shear = element::shear_factor(poisson, 0.0) * STEEL.shear * area;
    let tilting = 0.7 * euler;
    let soft = Coefficients::isotropic(2.0 * tilting / length, 0.0);
    let soft = SupportType::Bearing(vec![(0.0, soft)]);
    for (theory, hold, load) in [
        (BeamTheory::EulerBernoulli, &SupportType::Pinned, euler),
        (BeamTheory::Timoshenko, &SupportType::Pinned, 1.0 / (1.0 / euler + 1.0 / shear)),
        (BeamTheory::EulerBernoulli, &soft, tilting),
        (BeamTheory::Timoshenko, &soft, tilting),
    ] {
        for (share, answer) in [(1.0 - 1e-5, None), (1.0 + 1e-5, Some(RotorError::Buckled))] {
            let shaft = uniform(40, length, diameter, STEEL, hold);
            let rotor = Assembled::new(&Rotor { theory, tension: -share * load, ..shaft }).unwrap();
            let refused = ReducedRotor::new(&rotor, 4, &[0.0]).err();
            assert_eq!(refused, answer, "{theory:?}, {hold:?}, {share}");
        }
    }
}

/// Bearings that push across or with the motion, internal damping, and compression.
#[test]
fn a_rotor_can_grow_only_where_something_feeds_it() {
    let bearing = |across: [f64; 2], damping: f64| Coefficients {
        stiffness: [[1e6, across[0]], [across[1], 0.8e6]],
        damping: [[damping, 0.0], [0.0, 150.0]],
    };
    let plain = two_discs(6, bearing([0.0; 2], 200.0));
    let mut inside = plain.clone();
    for element in &mut inside.elements {
        element.material.viscous_damping = 2e-4;
    }
    let grows = |rotor: &Rotor| {
        let rotor = Assembled::new(rotor).unwrap();
        let modes = ReducedRotor::new(&rotor, 6, &[1500.0]).unwrap().modes(1500.0).unwrap().modes;
        modes.iter().any(|mode| mode.lambda.re > 1e-9 * mode.lambda.norm())
    };
    let stretched = Rotor { tension: 2e4, ..plain.clone() };
    for rotor in [&plain, &stretched, &two_discs(6, bearing([3e5, 3e5], 200.0))] {
        assert!(rotor.cannot_grow() && !grows(rotor), "{rotor:?}");
    }
    let pushed = [bearing([5e5, -5e5], 200.0), bearing([0.0; 2], -900.0)].map(|here| two_discs(6, here));
    for rotor in [&inside, &pushed[0], &pushed[1]] {
        assert!(!rotor.cannot_grow() && grows(rotor), "{rotor:?}");
    }
    assert!(!Rotor { tension: -2e4, ..plain }.cannot_grow());
}

/// A spin the other way turns every whirl round and changes nothing else.
#[test]
fn the_other_spin_turns_every_whirl_round() {
    let rotor =
        Assembled::new(&two_discs(6, Coefficients::orthotropic([1e6, 0.8e6], [200.0, 150.0]))).unwrap();
    let reduced = ReducedRotor::new(&rotor, 6, &[-400.0, 400.0]).unwrap();
    let (one, other) = (reduced.modes(400.0).unwrap().modes, reduced.modes(-400.0).unwrap().modes);
    for (a, b) in one.iter().zip_eq(&other) {
        assert!((a.lambda - b.lambda).norm() < 1e-9 * a.lambda.norm());
        let (a, b) = (a.orbit(2), b.orbit(2));
        assert!((a.minor / a.major + b.minor / b.major).abs() < 1e-6);
    }
}

/// On bearings alike in all directions both planes have the same frequencies at rest, and these do not depend on how
/// the axes of unequal bearings are turned.
/// An undamped rotor is solved as a symmetric problem, any other one as a general one.
#[test]
fn an_undamped_rotor_has_the_modes_of_one_that_is_hardly_damped() {
    for stiffness in [[1e6, 1e6], [1e6, 0.8e6]] {
        let [undamped, damped] = [0.0, 1e-6]
            .map(|c| Assembled::new(&two_discs(6, Coefficients::orthotropic(stiffness, [c; 2]))).unwrap());
        let speeds = [-700.0, 0.0, 30.0, 400.0];
        let [undamped, damped] =
            [&undamped, &damped].map(|rotor| ReducedRotor::new(rotor, 6, &speeds).unwrap());
        for speed in speeds {
            let [one, other] = [&undamped, &damped].map(|reduced| reduced.modes(speed).unwrap().modes);
            assert_eq!(one.len(), 6);
            for (one, other) in one.iter().zip_eq(&other) {
                close(one.frequency(), other.frequency(), 1e-9, "frequency");
                assert_eq!(one.lambda.re, 0.0);
                if speed == 0.0 {
                    continue;
                }
                assert_eq!(one.direction(), other.direction(), "at {speed} rad/s");
                // Of one shape, up to a complex factor.
                let product: Complex<f64> = one
                    .shape
                    .iter()
                    .flatten()
                    .zip_eq(other.shape.iter().flatten())
                    .map(|(a, b)| a.conj() * b)
                    .sum();
                let size = |mode: &WhirlMode| mode.shape.iter().flatten().map(Complex::norm_sqr).sum::<f64>();
                close(product.norm_sqr(), size(one) * size(other), 1e-7, "overlap of the shapes");
            }
        }
    }
}

#[test]
fn axes_do_not_matter() {
    let isotropic = Assembled::new(&two_discs(6, Coefficients::isotropic(1e6, 100.0))).unwrap();
    let modes = ReducedRotor::new(&isotropic, 6, &[0.0]).unwrap().modes(0.0).unwrap().modes;
    for pair in modes.chunks(2) {
        close(pair[0].lambda.im, pair[1].lambda.im, 1e-10, "two planes");
    }
    let turned = |angle: f64| {
        let (c, s) = (angle.cos(), angle.sin());
        let turn = |[a, b]: [f64; 2]| {
            [[a * c * c + b * s * s, (a - b) * s * c], [(a - b) * s * c, a * s * s + b * c * c]]
        };
        Coefficients { stiffness: turn([1e6, 0.4e6]), damping: turn([200.0, 150.0]) }
    };
    let seen = [0.0, 0.7].map(|angle| {
        let rotor = Assembled::new(&two_discs(6, turned(angle))).unwrap();
        let modes = ReducedRotor::new(&rotor, 6, &[300.0]).unwrap().modes(300.0).unwrap().modes;
        let unbalance = Unbalance { node: 2, size: 1e-3, angle };
        let response = unbalance_response(&rotor, &[unbalance], 300.0).unwrap();
        let orbit = response::Orbit::of(response[4][0], response[4][2]);
        (modes.into_iter().map(|mode| mode.lambda).collect::<Vec<_>>(), orbit)
    });
    let [(straight, orbit), (turned, other)] = &seen;
    for (a, b) in straight.iter().zip_eq(turned) {
        assert!((a - b).norm() < 1e-9 * a.norm());
    }
    close(orbit.major, other.major, 1e-9, "long axis");
    close(orbit.minor, other.minor, 1e-9, "short axis");
    close(orbit.inclination + 0.7, other.inclination, 1e-9, "inclination");
}

/// Between neighbouring speeds every mode stays itself, through all crossings.
#[test]
fn no_two_modes_are_exchanged_over_speed() {
    let rotor =
        Assembled::new(&two_discs(6, Coefficients::orthotropic([1e6, 0.5e6], [200.0, 150.0]))).unwrap();
    let reduced = ReducedRotor::new(&rotor, 8, &[0.0, 1500.0]).unwrap();
    for count in [10, 60] {
        let speeds: Vec<f64> = (0..=count).map(|n| 1500.0 * f64::from(n) / f64::from(count)).collect();
        let diagram = campbell(&reduced, &speeds).unwrap();
        let ends: Vec<(f64, f64)> = diagram
            .branches
            .iter()
            .filter_map(|branch| {
                Some((branch.first()?.as_ref()?.frequency(), branch.last()?.as_ref()?.frequency()))
            })
            .collect();
        // The pairs of frequencies at rest and at the highest speed, as the finest diagram joins them.
        let fine: Vec<f64> = (0..=600).map(|n| 2.5 * f64::from(n)).collect();
        let reference = campbell(&reduced, &fine).unwrap();
        for (first, last) in ends {
            let same = reference.branches.iter().any(|branch| {
                let of = |mode: &Option<WhirlMode>| mode.as_ref().map_or(0.0, WhirlMode::frequency);
                (of(&branch[0]) - first).abs() < 1e-9 * first && (of(&branch[600]) - last).abs() < 1e-9 * last
            });
            assert!(same, "{first} at rest becomes {last} with {count} steps");
        }
    }
}

/// Polar inertia above the diametral one: the tilting of the disc has no forward critical speed.
#[test]
fn a_thin_overhung_disc_has_one_forward_critical_speed() {
    let material = Material { density: 1e-3, young: 196e9, ..STEEL };
    let diameter = section::round_diameter(1e-7);
    let mut rotor = uniform(4, 0.3, diameter, material, &SupportType::Clamped);
    rotor.supports.truncate(1);
    rotor.discs = vec![RigidDisc { node: 4, mass: 10.0, diametral: 0.075, polar: 0.144 }];
    let rotor = Assembled::new(&rotor).unwrap();
    let reduced = ReducedRotor::new(&rotor, 4, &[0.0, 3000.0]).unwrap();
    let rpm = std::f64::consts::PI / 30.0;
    let found: Vec<(f64, WhirlDirection)> = critical::direct(&reduced, 1.0, 3000.0)
        .unwrap()
        .found
        .iter()
        .map(|critical| (critical.speed / rpm, critical.mode.direction()))
        .collect();
    assert_eq!(found.len(), 3, "{found:?}");
    for ((speed, direction), (ours, way)) in found.iter().zip_eq([
        (3504.3, WhirlDirection::Backward),
        (4866.4, WhirlDirection::Forward),
        (13265.4, WhirlDirection::Backward),
    ]) {
        close(*speed, ours, 2e-5, "critical speed");
        assert_eq!(*direction, way);
    }
}

/// At a critical speed without damping there is no steady response; beside it there is.
#[test]
fn the_response_at_an_undamped_critical_speed_is_refused() {
    let rotor = Assembled::new(&two_discs(6, Coefficients::isotropic(1e6, 0.0))).unwrap();
    let reduced = ReducedRotor::new(&rotor, 6, &[0.0, 400.0]).unwrap();
    let forward = critical::direct(&reduced, 1.0, 400.0)
        .unwrap()
        .found
        .into_iter()
        .find(|critical| critical.mode.direction() == WhirlDirection::Forward)
        .unwrap();
    let unbalance = [Unbalance { node: 2, size: 1e-3, angle: 0.0 }];
    let at = |speed: f64| unbalance_response(&rotor, &unbalance, speed);
    assert!(matches!(at(forward.speed), Err(RotorError::Unbounded { .. })));
    let response = at(forward.speed * 1.001).unwrap();
    assert!(response::residual(&rotor, &unbalance, forward.speed * 1.001, &response).unwrap() < 1e-9);
}

/// From bearings as soft as a hand to bearings like rock.
#[test]
fn critical_speeds_over_the_stiffness_of_the_bearings_are_those_found_for_each() {
    let rotor = two_discs(12, Coefficients::isotropic(1e6, 0.0));
    let map = stiffness_map::StiffnessMap::new(&rotor, &[1.0, 0.5], 3, 1e3).unwrap();
    for stiffness in [1e2, 1e5, 1e6, 3e7, 1e9, 1e13] {
        let mut rotor = rotor.clone();
        for (support, share) in rotor.supports.iter_mut().zip_eq([1.0, 0.5]) {
            *support = BearingSupport::bearing(support.node, Coefficients::isotropic(share * stiffness, 0.0));
        }
        let all = Assembled::new(&rotor).unwrap();
        let reduced = ReducedRotor::new(&all, 6, &[0.0, 1000.0]).unwrap();
        let exact = critical::direct(&reduced, 1.0, 1e4).unwrap().found;
        let ours = map.at(stiffness, 1.0).unwrap();
        for (direction, ours) in
            [(WhirlDirection::Forward, ours.forward), (WhirlDirection::Backward, ours.backward)]
        {
            let theirs = exact.iter().filter(|critical| critical.mode.direction() == direction);
            let theirs: Vec<f64> = theirs.map(|critical| critical.speed).take(2).collect();
            assert!(!theirs.is_empty());
            for (ours, theirs) in ours[..theirs.len()].iter().zip_eq(theirs) {
                close(*ours, theirs, 1e-4, &format!("{direction:?} at {stiffness:e} N/m"));
            }
        }
    }
}
