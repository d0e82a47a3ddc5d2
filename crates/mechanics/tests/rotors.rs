//! Random rotors: every one is answered, and its natural frequencies are those of dense matrices in double precision
//! and of banded ones in numbers of 40 digits.
//!
//! `ROTOR_DRAWS=2000 cargo test --release --test rotors` looks further.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::f64::consts::PI;

use dalembert_mechanics::rotor::{
    Assembled, BearingSupport, Coefficients, Complex, RigidDisc, Rotor, SupportType,
    campbell::campbell,
    critical,
    element::{BeamTheory, Material, ShaftElement},
    modes::{self, ReducedRotor},
};
use dalembert_numerics::linalg;
use itertools::{Itertools as _, zip_eq};
use nalgebra::{DMatrix, Matrix4};

/// The agreement that is promised.
const PROMISED: f64 = 1e-9;

/// Numbers that look random, the same at every run.
struct Draw(u64);

impl Draw {
    fn unit(&mut self) -> f64 {
        // SplitMix64.
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }

    fn decades(&mut self, from: f64, to: f64) -> f64 {
        from * (to / from).powf(self.unit())
    }

    fn count(&mut self, from: usize, to: usize) -> usize {
        from + (self.unit() * (to - from + 1) as f64) as usize
    }

    /// A uniform shaft with a disc, and its length in elements.
    fn shaft(&mut self) -> (Rotor, usize) {
        let count = self.count(4, 40);
        let length = self.between(0.5, 2.0);
        let material = Material {
            young: self.between(190e9, 215e9),
            shear: self.between(75e9, 83e9),
            density: self.between(7600.0, 8000.0),
            viscous_damping: 0.0,
            loss_factor: 0.0,
        };
        let element = ShaftElement {
            length: length / count as f64,
            outer: [self.between(0.02, 0.15); 2],
            inner: [0.0; 2],
            material,
        };
        let (mass, radius) = (self.decades(1.0, 300.0), self.between(0.08, 0.4));
        let disc = RigidDisc {
            node: self.count(1, count - 1),
            mass,
            diametral: mass * radius.powi(2) / 3.4,
            polar: mass * radius.powi(2) / 2.0,
        };
        let theory = if self.unit() < 0.5 { BeamTheory::Timoshenko } else { BeamTheory::EulerBernoulli };
        let elements = vec![element; count];
        (Rotor { elements, theory, tension: 0.0, discs: vec![disc], supports: Vec::new() }, count)
    }

    /// Two bearings alike in all directions, without damping.
    fn plain(&mut self) -> Rotor {
        let (mut rotor, count) = self.shaft();
        for node in [0, count] {
            let here = Coefficients::isotropic(self.decades(1e4, 1e8), 0.0);
            rotor.supports.push(BearingSupport::bearing(node, here));
        }
        rotor
    }

    /// Bearings with antisymmetric coupling, light damping, and every third by a table.
    fn coupled(&mut self) -> Rotor {
        let (mut rotor, count) = self.shaft();
        for node in [0, count] {
            let k = self.decades(1e4, 1e8);
            let row = |draw: &mut Self| {
                let (stiff, along) = (k * draw.between(0.7, 1.3), k * draw.between(0.5, 0.9));
                let cross = k * draw.between(0.02, 0.3);
                let damping = k * draw.decades(1e-6, 3e-4);
                Coefficients {
                    stiffness: [[stiff, cross], [-cross, along]],
                    damping: [[damping, 0.0], [0.0, damping]],
                }
            };
            let rows = if self.unit() < 0.34 { 4 } else { 1 };
            let table = (0..rows).map(|n| (500.0 * f64::from(n), row(self))).collect();
            rotor.supports.push(BearingSupport { node, hold: SupportType::Bearing(table) });
        }
        rotor
    }
}

/// Mass, rotary inertia doubled, and stiffness of a uniform element in closed form: Nelson, J. Mech. Des. 102 (1980)
/// 793–803.
fn closed(element: &ShaftElement, theory: BeamTheory) -> [Matrix4<f64>; 3] {
    let ShaftElement { length: l, outer: [d, _], material, .. } = *element;
    let (area, moment) = (PI * d.powi(2) / 4.0, PI * d.powi(4) / 64.0);
    let poisson = material.young / (2.0 * material.shear) - 1.0;
    let kappa = 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson);
    let p = match theory {
        BeamTheory::Timoshenko => {
            12.0 * material.young * moment / (kappa * material.shear * area * l.powi(2))
        }
        BeamTheory::EulerBernoulli => 0.0,
    };
    let scaled = |factor: f64, rows: [f64; 16]| Matrix4::from_row_slice(&rows) * factor;
    let stiffness = scaled(
        material.young * moment / ((1.0 + p) * l.powi(3)),
        [
            12.0,
            6.0 * l,
            -12.0,
            6.0 * l,
            6.0 * l,
            (4.0 + p) * l * l,
            -6.0 * l,
            (2.0 - p) * l * l,
            -12.0,
            -6.0 * l,
            12.0,
            -6.0 * l,
            6.0 * l,
            (2.0 - p) * l * l,
            -6.0 * l,
            (4.0 + p) * l * l,
        ],
    );
    let m = [
        312.0 + 588.0 * p + 280.0 * p * p,
        (44.0 + 77.0 * p + 35.0 * p * p) * l,
        108.0 + 252.0 * p + 140.0 * p * p,
        -(26.0 + 63.0 * p + 35.0 * p * p) * l,
        (8.0 + 14.0 * p + 7.0 * p * p) * l * l,
        -(6.0 + 14.0 * p + 7.0 * p * p) * l * l,
    ];
    let straight = scaled(
        material.density * area * l / (840.0 * (1.0 + p).powi(2)),
        [m[0], m[1], m[2], m[3], m[1], m[4], -m[3], m[5], m[2], -m[3], m[0], -m[1], m[3], m[5], -m[1], m[4]],
    );
    let r = [
        36.0,
        (3.0 - 15.0 * p) * l,
        (4.0 + 5.0 * p + 10.0 * p * p) * l * l,
        (-1.0 - 5.0 * p + 5.0 * p * p) * l * l,
    ];
    let rotary = scaled(
        material.density * moment / (30.0 * l * (1.0 + p).powi(2)),
        [
            r[0], r[1], -r[0], r[1], r[1], r[2], -r[1], r[3], -r[0], -r[1], r[0], -r[1], r[1], r[3], -r[1],
            r[2],
        ],
    );
    [straight + rotary, rotary * 2.0, stiffness]
}

/// The eigenvalues that swing, by frequency, from dense matrices; and the condition number of the stiffness in the
/// mass.
fn dense(rotor: &Rotor, speed: f64) -> (Vec<Complex<f64>>, f64) {
    let m = 2 * rotor.nodes();
    let [mut mass, mut gyroscopic, mut shaft] = [(); 3].map(|()| DMatrix::<f64>::zeros(m, m));
    for (n, element) in rotor.elements.iter().enumerate() {
        for (into, of) in
            [&mut mass, &mut gyroscopic, &mut shaft].into_iter().zip_eq(closed(element, rotor.theory))
        {
            let mut block = into.view_mut((2 * n, 2 * n), (4, 4));
            block += of;
        }
    }
    for disc in &rotor.discs {
        mass[(2 * disc.node, 2 * disc.node)] += disc.mass;
        mass[(2 * disc.node + 1, 2 * disc.node + 1)] += disc.diametral;
        gyroscopic[(2 * disc.node + 1, 2 * disc.node + 1)] += disc.polar;
    }
    let mut held = shaft.clone();
    for support in &rotor.supports {
        held[(2 * support.node, 2 * support.node)] += support.at(speed).unwrap().stiffness[1][1];
    }
    // The modes of the held shaft are coordinates in which the mass is one.
    let eigen = linalg::generalised_eigen(&held, &mass).unwrap();
    let condition = eigen.values.max() / eigen.values.min();
    let modes = eigen.vectors;
    let (shaft, gyroscopic) = (modes.tr_mul(&(&shaft * &modes)), modes.tr_mul(&(&gyroscopic * &modes)));
    let scale: Vec<f64> = eigen.values.iter().map(|value| value.sqrt()).collect();
    let mut stiffness = DMatrix::zeros(2 * m, 2 * m);
    let mut damping = DMatrix::zeros(2 * m, 2 * m);
    for (i, j) in (0..m).flat_map(|i| (0..m).map(move |j| (i, j))) {
        stiffness[(i, j)] = shaft[(i, j)];
        stiffness[(m + i, m + j)] = shaft[(i, j)];
        damping[(i, m + j)] = speed * gyroscopic[(i, j)];
        damping[(m + i, j)] = -speed * gyroscopic[(i, j)];
        for support in &rotor.supports {
            let here = support.at(speed).unwrap();
            let both = modes[(2 * support.node, i)] * modes[(2 * support.node, j)];
            for (p, q) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                stiffness[(p * m + i, q * m + j)] += here.stiffness[p][q] * both;
                damping[(p * m + i, q * m + j)] += here.damping[p][q] * both;
            }
        }
    }
    let mut state = DMatrix::zeros(4 * m, 4 * m);
    for i in 0..2 * m {
        state[(i, 2 * m + i)] = scale[i % m];
        for j in 0..2 * m {
            state[(2 * m + i, j)] = -stiffness[(i, j)] / scale[j % m];
            state[(2 * m + i, 2 * m + j)] = -damping[(i, j)];
        }
    }
    let values = linalg::complex_eigenvalues(&state).unwrap();
    let mut swings: Vec<Complex<f64>> =
        values.into_iter().filter(|value| value.im > 0.3 * value.norm()).collect();
    swings.sort_by(|a, b| a.im.total_cmp(&b.im));
    (swings, condition)
}

/// Holds all that is answered of a rotor up to a speed; how many critical speeds and limits of stability could not be
/// refined.
fn hold(rotor: &Rotor, speed: f64, count: usize, what: &str) -> usize {
    let all = Assembled::new(rotor).unwrap();
    let highest = 1500.0;
    let reduced =
        ReducedRotor::new(&all, count, &[speed, highest]).unwrap_or_else(|error| panic!("{what}: {error}"));
    let spectrum = reduced.modes(speed).unwrap();
    assert_eq!(spectrum.modes.len(), count, "{what}");
    let (theirs, condition) = dense(rotor, speed);
    let limit = PROMISED.max(1e-15 * condition);
    for (n, (mode, theirs)) in spectrum.modes.iter().zip_eq(&theirs[..count]).enumerate() {
        let exact =
            modes::polished(&all, mode, speed).unwrap_or_else(|error| panic!("{what}, mode {n}: {error}"));
        let lambda = exact.mode.lambda;
        let off = (lambda - theirs).norm() / theirs.norm();
        assert!(off < limit, "{what}, mode {n}: {lambda} is not {theirs}, {off:e} of {limit:e}");
        let other = modes::energy_eigenvalue(&all, &exact.mode, speed).unwrap();
        let off = (other - lambda).norm() / lambda.norm();
        let allowed = PROMISED.max(32.0 * exact.rounding);
        assert!(allowed < 1e-7 && off < allowed, "{what}, mode {n}: {other} is not {lambda}, {off:e}");
        if rotor.is_undamped() {
            let growth = lambda.re.abs() / lambda.norm();
            assert!(growth <= 32.0 * exact.rounding, "{what}, mode {n}: {growth:e}, {:e}", exact.rounding);
        }
    }
    if rotor.is_conservative() {
        let criticals =
            critical::direct(&reduced, 1.0, highest).unwrap_or_else(|error| panic!("{what}: {error}"));
        for critical in &criticals.found {
            let there = modes::polished(&all, &critical.mode, critical.speed).unwrap();
            let off = (there.mode.lambda.im - critical.speed).abs() / critical.speed;
            let allowed = PROMISED.max(32.0 * there.rounding);
            assert!(off < allowed, "{what}: critical speed {}, {off:e}", critical.speed);
        }
        criticals.lost.len()
    } else {
        let even = (0..=14).map(|n| highest * f64::from(n) / 14.0);
        let mut speeds: Vec<f64> = even.chain([speed, 500.0, 1000.0]).collect();
        speeds.sort_by(f64::total_cmp);
        let diagram = campbell(&reduced, &speeds).unwrap();
        let criticals = critical::crossings(&reduced, &diagram, 1.0).unwrap();
        for critical in &criticals.found {
            let there = modes::energy_eigenvalue(&all, &critical.mode, critical.speed).unwrap();
            let off = (there.im - critical.speed).abs() / critical.speed;
            assert!(off < PROMISED, "{what}: critical speed {}, {off:e}", critical.speed);
        }
        let instability = critical::instability(&reduced, &diagram).unwrap();
        for end in instability.bands.iter().flat_map(|band| band.from.iter().chain(&band.to)) {
            let there = modes::energy_eigenvalue(&all, &end.mode, end.speed).unwrap();
            assert!(there.re.abs() < PROMISED * there.norm(), "{what}: threshold {}", end.speed);
        }
        let grows = theirs[..count].iter().any(|theirs| theirs.re > 1e-8 * theirs.norm());
        let within = instability.bands.iter().any(|band| {
            band.from.as_ref().is_none_or(|from| from.speed <= speed * (1.0 + 1e-6))
                && band.to.as_ref().is_none_or(|to| to.speed >= speed * (1.0 - 1e-6))
        });
        assert!(!grows || within, "{what}: a mode grows at {speed}, {:?}", instability.bands.len());
        criticals.lost.len() + instability.lost.len()
    }
}

#[test]
fn random_rotors_are_answered_as_by_dense_matrices() {
    let draws: u64 = std::env::var("ROTOR_DRAWS").map_or(40, |draws| draws.parse().unwrap());
    let first: u64 = std::env::var("ROTOR_FIRST").map_or(0, |first| first.parse().unwrap());
    assert!(draws > 0);
    let (mut bad, mut lost) = (Vec::new(), 0);
    for n in first..first + draws {
        let mut draw = Draw(n);
        let rotor = if n % 2 == 0 { draw.plain() } else { draw.coupled() };
        let speed = if n % 10 == 0 { 0.0 } else { draw.between(5.0, 1450.0) };
        let count = draw.count(2, 6);
        let what = format!("rotor {n}, {} elements, {:?}", rotor.elements.len(), rotor.theory);
        let held = std::panic::catch_unwind(|| hold(&rotor, speed, count, &what));
        match held {
            Ok(more) => lost += more as u64,
            Err(_) => bad.push(n),
        }
    }
    assert!(bad.is_empty(), "{} of {draws}: {bad:?}", bad.len());
    // A mode at the limit of overdamping has a frequency that no neighbourhood holds: it costs one critical speed.
    assert!(lost * 1000 <= draws, "{lost} of {draws} rotors lack a critical speed or a limit of stability");
}

#[test]
fn random_rotors_have_the_eigenvalues_of_forty_digits() {
    let text = include_str!("reference/rotors.txt");
    let lines: Vec<Vec<f64>> = text
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect())
        .collect();
    let mut held = 0;
    for (number, pair) in lines.chunks(2).enumerate() {
        let [given, values] = pair else { panic!("an odd number of lines") };
        let &[
            n,
            length,
            diameter,
            young,
            shear,
            density,
            shearing,
            node,
            mass,
            diametral,
            polar,
            ref rest @ ..,
        ] = given.as_slice()
        else {
            panic!("too few numbers")
        };
        let (bearings, speed) = rest.split_at(12);
        let material = Material { young, shear, density, viscous_damping: 0.0, loss_factor: 0.0 };
        let element = ShaftElement { length: length / n, outer: [diameter; 2], inner: [0.0; 2], material };
        let support = |row: &[f64]| {
            let here = Coefficients {
                stiffness: [[row[1], row[2]], [row[3], row[4]]],
                damping: [[row[5], 0.0], [0.0, row[5]]],
            };
            BearingSupport::bearing(row[0] as usize, here)
        };
        let rotor = Rotor {
            elements: vec![element; n as usize],
            theory: if shearing == 1.0 { BeamTheory::Timoshenko } else { BeamTheory::EulerBernoulli },
            tension: 0.0,
            discs: vec![RigidDisc { node: node as usize, mass, diametral, polar }],
            supports: bearings.chunks(6).map(support).collect(),
        };
        let all = Assembled::new(&rotor).unwrap();
        let theirs: Vec<Complex<f64>> = values.chunks(2).map(|pair| Complex::new(pair[0], pair[1])).collect();
        let found = ReducedRotor::new(&all, theirs.len(), speed).unwrap().modes(speed[0]).unwrap().modes;
        for (mode, theirs) in zip_eq(&found, &theirs) {
            let exact = modes::polished(&all, mode, speed[0]).unwrap();
            let off = (exact.mode.lambda - theirs).norm() / theirs.norm();
            assert!(off < PROMISED, "rotor {number}: {} is not {theirs}, {off:e}", exact.mode.lambda);
            held += 1;
        }
    }
    assert!(held >= 800, "{held}");
}

/// A shaft of 50 mm with a disc of 40 kg in the middle.
fn middle(supports: [SupportType; 2]) -> Rotor {
    let material =
        Material { young: 210e9, shear: 81e9, density: 7850.0, viscous_damping: 0.0, loss_factor: 0.0 };
    let element = ShaftElement { length: 1.0 / 12.0, outer: [0.05; 2], inner: [0.0; 2], material };
    Rotor {
        elements: vec![element; 12],
        theory: BeamTheory::Timoshenko,
        tension: 0.0,
        discs: vec![RigidDisc { node: 6, mass: 40.0, diametral: 0.4, polar: 0.8 }],
        supports: [0, 12]
            .into_iter()
            .zip_eq(supports)
            .map(|(node, hold)| BearingSupport { node, hold })
            .collect(),
    }
}

/// Bands of instability, rpm, of a rotor whose diagram has fourteen steps, the rows of its tables and a speed.
fn bands(rotor: &Rotor, speed: f64, highest: f64, count: usize) -> Vec<[Option<f64>; 2]> {
    let rpm = PI / 30.0;
    let all = Assembled::new(rotor).unwrap();
    let reduced = ReducedRotor::new(&all, count, &[speed * rpm, highest * rpm]).unwrap();
    let even = (0..=14).map(|n| highest * f64::from(n) / 14.0);
    let rows = [5100.0, 5300.0, 5600.0].into_iter().filter(|row| *row < highest);
    let mut speeds: Vec<f64> = even.chain(rows).chain([speed]).map(|speed| speed * rpm).collect();
    speeds.sort_by(f64::total_cmp);
    speeds.dedup();
    let found = critical::instability(&reduced, &campbell(&reduced, &speeds).unwrap()).unwrap();
    assert!(found.lost.is_empty(), "{:?}", found.lost);
    let speed = |end: Option<critical::Critical>| end.map(|end| end.speed / rpm);
    found.bands.into_iter().map(|band| [speed(band.from), speed(band.to)]).collect()
}

/// Ends of the bands by the eigenvalues of 40 digits, and by LAPACK.
#[test]
fn bands_of_instability_have_both_ends_wherever_they_lie() {
    let row = |kxy: f64, kyy: f64, cxx: f64| Coefficients {
        stiffness: [[1e8, kxy], [-kxy, kyy]],
        damping: [[cxx, 0.0], [0.0, cxx]],
    };
    let rpm = PI / 30.0;
    let table = [(0.0, 0.0), (5100.0, 0.0), (5300.0, 5e7), (5600.0, 0.0), (14000.0, 0.0)];
    let table = table.map(|(speed, kxy)| (speed * rpm, row(kxy, 7.5e7, 1e4))).to_vec();
    let constant = |here: Coefficients| SupportType::Bearing(vec![(0.0, here)]);
    let rotor = middle([constant(row(0.0, 6e7, 1e4)), SupportType::Bearing(table)]);
    for speed in [4000.0, 5300.0] {
        let found = bands(&rotor, speed, 14000.0, 4);
        let [[Some(from), Some(to)]] = found[..] else { panic!("{found:?}") };
        assert!((from / 5161.74037992 - 1.0).abs() < PROMISED, "{from}");
        assert!((to / 5512.05661943 - 1.0).abs() < PROMISED, "{to}");
    }
    let rotor = middle([constant(row(2e7, 6e7, 3e3)), constant(row(0.0, 7.5e7, 1e4))]);
    for highest in [500.0, 1500.0, 7200.0, 30000.0] {
        let found = bands(&rotor, 100.0, highest, 6);
        let [[Some(from), None]] = found[..] else { panic!("{found:?} up to {highest}") };
        assert!((from / 27.219_933_2 - 1.0).abs() < 1e-8, "{from} up to {highest}");
    }
}

/// Bending alone on soft bearings, by the eigenvalues of 40 digits, Hz.
#[test]
fn soft_bearings_keep_their_digits_on_a_fine_mesh() {
    for (count, k, speed, theirs) in [
        (5, 30e3, 600.0, [6.938_368_142, 6.938_368_151, 8.905_936_788, 9.054_820_526]),
        (8, 30e3, 600.0, [6.938_368_028, 6.938_368_037, 8.905_936_659, 9.054_820_388]),
        (20, 300e3, 0.0, [21.930_273_51, 21.930_273_51, 28.397_093_53, 28.397_093_53]),
    ] {
        let material =
            Material { young: 207e9, shear: 80e9, density: 7850.0, viscous_damping: 0.0, loss_factor: 0.0 };
        let stretch = |length: f64| {
            let element =
                ShaftElement { length: length / count as f64, outer: [0.08; 2], inner: [0.0; 2], material };
            vec![element; count]
        };
        let supports =
            [count, 2 * count].map(|node| BearingSupport::bearing(node, Coefficients::isotropic(k, 0.0)));
        let rotor = Rotor {
            elements: [0.1, 0.6, 0.1].into_iter().flat_map(stretch).collect(),
            theory: BeamTheory::EulerBernoulli,
            tension: 0.0,
            discs: Vec::new(),
            supports: supports.to_vec(),
        };
        let all = Assembled::new(&rotor).unwrap();
        let speed = speed * PI / 30.0;
        let found = ReducedRotor::new(&all, 4, &[speed, 200.0 * PI]).unwrap().modes(speed).unwrap().modes;
        for (mode, theirs) in zip_eq(&found, theirs) {
            let exact = modes::polished(&all, mode, speed).unwrap().mode.frequency() / (2.0 * PI);
            assert!((exact / theirs - 1.0).abs() < PROMISED, "{exact} is not {theirs}");
        }
    }
}
