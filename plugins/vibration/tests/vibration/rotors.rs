//! Random rotors as a user enters them: every one is answered, and every check of it holds.

use itertools::Itertools as _;
use std::{f64::consts::TAU, ops::Range};

use dalembert_core::{Analysis, FieldPath, Inputs, Lift, Sheet, Solution, Stop};
use dalembert_vibration::shafts_and_rotors::rotor_dynamics::{
    Bearing, DiscSize, InternalDamping, RotorDisc, RotorDynamics, RotorSupport, ShaftMaterial, ShaftSegment,
    ShaftTheory, SpeedRow,
};

const RPM: f64 = TAU / 60.0;

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

    fn rotor(&mut self, coupled: bool) -> RotorDynamics {
        let length = self.between(0.5, 2.0);
        let segment =
            ShaftSegment { length, outer: self.between(0.02, 0.15), outer_right: None, inner: None };
        let material = ShaftMaterial {
            young: self.between(190e9, 215e9),
            shear: self.between(75e9, 83e9),
            density: self.between(7600.0, 8000.0),
            damping: InternalDamping::None,
        };
        let (mass, radius) = (self.decades(1.0, 300.0), self.between(0.08, 0.4));
        let size = DiscSize::Inertia {
            mass,
            diametral: mass * radius.powi(2) / 3.4,
            polar: mass * radius.powi(2) / 2.0,
        };
        let highest_speed = self.decades(1500.0, 14000.0) * RPM;
        let bearings = [0, 1].map(|_| if coupled { self.coupled(highest_speed) } else { self.plain() });
        let supports = [0.0, length].into_iter().zip_eq(bearings);
        RotorDynamics {
            segments: vec![segment],
            material,
            discs: vec![RotorDisc { position: length * self.between(0.1, 0.9), size }],
            supports: supports.map(|(position, bearing)| RotorSupport { position, bearing }).collect(),
            unbalances: Vec::new(),
            speed: if self.unit() < 0.1 { 0.0 } else { highest_speed * self.between(0.01, 1.0) },
            highest_speed,
            slope: 1.0,
            place: None,
            tension: None,
            theory: if self.unit() < 0.5 { ShaftTheory::Timoshenko } else { ShaftTheory::EulerBernoulli },
            elements: self.count(2, 20),
            modes: self.count(2, 8),
        }
    }

    fn plain(&mut self) -> Bearing {
        Bearing::Isotropic { stiffness: self.decades(1e4, 1e8), damping: 0.0 }
    }

    fn coupled(&mut self, highest: f64) -> Bearing {
        let k = self.decades(1e4, 1e8);
        let rows = if self.unit() < 0.34 { 4 } else { 1 };
        let row = |n: i32| {
            let cross = k * self.between(0.02, 0.3);
            let damping = k * self.decades(1e-6, 3e-4);
            SpeedRow {
                speed: highest * f64::from(n) / 3.0,
                kxx: k * self.between(0.7, 1.3),
                kxy: cross,
                kyx: -cross,
                kyy: k * self.between(0.5, 0.9),
                cxx: damping,
                cxy: 0.0,
                cyx: 0.0,
                cyy: damping,
            }
        };
        Bearing::Table { rows: (0..rows).map(row).collect() }
    }
}

fn solved(problem: &RotorDynamics) -> Result<Solution, String> {
    let stop = Stop::new();
    let sheet = Sheet::new(&stop);
    let given = problem.given(Lift { sheet: &sheet, value: None, field_path: &FieldPath::TOP });
    problem.solve(&given, &sheet).map_err(|refusal| format!("{refusal:?}"))?;
    sheet.into_solution().map_err(|refusal| format!("{refusal:?}"))
}

#[test]
fn random_rotors_are_answered_and_their_checks_hold() {
    answered(0..24);
}

/// The third and the fourth mode of this one have the same frequency at a low speed, and the one of them grows.
#[test]
fn a_mode_that_grows_beside_the_last_one_is_examined() {
    answered(127..128);
}

/// The same of many more, as `cargo xtask soak rotors` runs it.
#[test]
#[ignore = "takes minutes"]
fn two_thousand_random_rotors_are_answered_and_their_checks_hold() {
    answered(0..2000);
}

fn answered(draws: Range<u64>) {
    let (mut refused, mut failed, mut missing, mut checks) = (Vec::new(), Vec::new(), Vec::new(), 0);
    for n in draws.clone() {
        let problem = Draw(n).rotor(n % 2 == 1);
        match solved(&problem) {
            Err(why) => {
                // A rotor all of whose motions are damped away has no mode to answer.
                if !why.contains("no mode oscillates") {
                    refused.push((n, why));
                }
            }
            Ok(solution) => {
                checks += solution.checks.len();
                let bad = solution.checks.iter().filter(|check| !check.passed);
                failed.extend(bad.map(|check| (n, format!("{:?} {:e}", check.what, check.residual))));
                let said: Vec<String> = solution.warnings.iter().map(|text| format!("{text:?}")).collect();
                missing.extend(
                    said.iter().filter(|said| said.contains("omitted")).map(|said| (n, said.clone())),
                );
                let grows = said.iter().any(|said| said.contains("a mode is unstable at this speed"));
                let stable = said
                    .iter()
                    .any(|said| said.contains("no mode grows at") || said.contains("no mode can grow"));
                assert!(!(grows && stable), "rotor {n} is called stable and unstable");
            }
        }
    }
    assert!(checks > 0);
    assert!(
        refused.is_empty() && failed.is_empty() && missing.is_empty(),
        "of {draws:?}: refused {refused:#?}, failed {failed:#?}, missing {missing:#?}"
    );
}
