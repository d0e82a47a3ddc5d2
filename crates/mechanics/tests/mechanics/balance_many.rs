//! Rotors with many planes or with unknowns, and linkages.

use itertools::Itertools as _;
use std::f64::consts::TAU;

use dalembert_mechanics::balance::{
    self, BalanceError, PartlyKnown, PlaneUnbalance, UnbalanceKind, UnknownsError, Vanishing, balance_planes,
    balance_unknowns,
    linkage::{Counterweight, Follower, LinkInertia, Linkage},
};
use proptest::prelude::*;

use crate::close::{close, found};

fn rotors() -> impl Strategy<Value = Vec<PlaneUnbalance>> {
    let plane = (0.001..10.0, 0.001..1.0, 0.0..TAU, -2.0..2.0).prop_map(
        |(mass, radius, angle, position): (f64, f64, f64, f64)| PlaneUnbalance {
            position,
            components: [mass * radius * angle.cos(), mass * radius * angle.sin()],
        },
    );
    prop::collection::vec(plane, 2..20)
}

fn size(rotor: &[PlaneUnbalance]) -> f64 {
    rotor.iter().map(|u| u.components[0].hypot(u.components[1])).sum()
}

fn spread(planes: &[f64]) -> f64 {
    let low = planes.iter().copied().fold(f64::INFINITY, f64::min);
    planes.iter().copied().fold(f64::NEG_INFINITY, f64::max) - low
}

proptest! {
    #[test]
    fn many_planes_leave_nothing_and_no_smaller_corrections_would(
        rotor in rotors(),
        planes in prop::collection::vec(-2.0..2.0f64, 2..20),
    ) {
        prop_assume!(spread(&planes) > 0.5);
        let corrections = found(balance_planes(&rotor, &planes));
        let size = size(&rotor);
        for axis in 0..2 {
            let all = || {
                let masses = rotor.iter().map(|u| (u.components[axis], u.position));
                masses.chain(corrections.iter().map(|u| u[axis]).zip_eq(planes.iter().copied()))
            };
            let force: f64 = all().map(|(u, _)| u).sum();
            let moment: f64 = all().map(|(u, z)| u * z).sum();
            prop_assert!(force.abs() <= 1e-12 * size, "{force}");
            prop_assert!(moment.abs() <= 1e-12 * size, "{moment}");
            // The least corrections are a straight line along the shaft.
            let mean = planes.iter().sum::<f64>() / planes.len() as f64;
            let arms: f64 = planes.iter().map(|z| (z - mean) * (z - mean)).sum();
            let masses = || rotor.iter().map(|u| (u.components[axis], u.position));
            let (total, about) = (balance::resultant(masses().map(|(u, _)| u)), balance::moment(masses(), mean));
            for (z, u) in planes.iter().zip_eq(&corrections) {
                let line = balance::least_correction(total, about, planes.len() as f64, z - mean, arms);
                prop_assert!((u[axis] - line).abs() <= 1e-11 * size);
            }
        }
    }

    #[test]
    fn origin_datum_and_order_of_many_planes_do_not_matter(
        rotor in rotors(),
        planes in prop::collection::vec(-2.0..2.0f64, 3..20),
        shift in -5.0..5.0f64,
        turn in 0.0..TAU,
    ) {
        prop_assume!(spread(&planes) > 0.5);
        let corrections = found(balance_planes(&rotor, &planes));
        let turned = |[x, y]: [f64; 2]| [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
        let moved: Vec<PlaneUnbalance> = rotor
            .iter()
            .rev()
            .map(|u| PlaneUnbalance { position: u.position + shift, components: turned(u.components) })
            .collect();
        let reversed: Vec<f64> = planes.iter().rev().map(|z| z + shift).collect();
        let again = found(balance_planes(&moved, &reversed));
        for (ours, expected) in again.iter().rev().zip_eq(&corrections) {
            let expected = turned(*expected);
            for axis in 0..2 {
                prop_assert!((ours[axis] - expected[axis]).abs() <= 1e-11 * size(&rotor));
            }
        }
    }

    #[test]
    fn what_was_hidden_of_a_balanced_rotor_is_found(rotor in rotors(), hidden in 0..5usize) {
        let rotor = &rotor[..2];
        prop_assume!((rotor[0].position - rotor[1].position).abs() > 0.2);
        let corrections = found(balance_planes(rotor, &[-1.0, 1.5]));
        let masses = rotor.iter().map(|u| (u.components, u.position));
        let all: Vec<([f64; 2], f64)> =
            masses.chain([(corrections[0], -1.0), (corrections[1], 1.5)]).collect();
        let product = |u: [f64; 2]| u[0].hypot(u[1]);
        let angle = |u: [f64; 2]| u[1].atan2(u[0]).rem_euclid(TAU);
        prop_assume!(all.iter().all(|(u, _)| product(*u) > 0.02 * size(rotor)));
        let whole = |(u, z): ([f64; 2], f64)| PartlyKnown {
            product: Some(product(u)),
            angle: Some(angle(u)),
            position: Some(z),
        };
        let mut given: Vec<PartlyKnown> = all.iter().copied().map(whole).collect();
        match hidden {
            // Two whole vectors; a vector with its place and another place; a vector and two angles; two products,
            // an angle and a place; two products and their places.
            0 => {
                for mass in &mut given[2..] {
                    (mass.product, mass.angle) = (None, None);
                }
            }
            1 => {
                (given[3].product, given[3].angle, given[3].position) = (None, None, None);
                given[2].position = None;
            }
            2 => {
                (given[3].product, given[3].angle) = (None, None);
                (given[2].angle, given[1].angle) = (None, None);
            }
            3 => {
                (given[3].product, given[3].angle, given[3].position) = (None, None, None);
                given[2].product = None;
            }
            _ => {
                for mass in &mut given[..2] {
                    (mass.product, mass.position) = (None, None);
                }
            }
        }
        match balance_unknowns(&given, Vanishing::ForceAndCouple) {
            Ok(balances) => {
                let scale = size(rotor);
                let is_it = |balance: &Vec<balance::RotorMass>| {
                    balance.iter().zip_eq(&all).all(|(found, (u, z))| {
                        let [x, y] = [found.product * found.angle.cos(), found.product * found.angle.sin()];
                        (x - u[0]).hypot(y - u[1]) < 1e-5 * scale && (found.position - z).abs() < 1e-4
                    })
                };
                prop_assert!(balances.iter().any(is_it), "{balances:?} lacks {all:?}");
                for balance in &balances {
                    for of in [f64::cos, f64::sin] {
                        let force: f64 = balance.iter().map(|m| m.product * of(m.angle)).sum();
                        let moment: f64 = balance.iter().map(|m| m.product * of(m.angle) * m.position).sum();
                        let reach = balance.iter().map(|m| m.position.abs()).fold(2.0, f64::max);
                        let all: f64 = balance.iter().map(|m| m.product).sum();
                        prop_assert!(force.abs() < 1e-10 * all && moment.abs() < 1e-10 * all * reach);
                    }
                }
            }
            // Masses in one plane through the axis do not tell their places apart.
            Err(error) => prop_assert!(error == UnknownsError::NotDetermined, "{error}"),
        }
    }
}

#[test]
fn coincident_or_single_planes_are_refused() {
    let rotor = [PlaneUnbalance { position: 0.1, components: [1.0, 0.0] }];
    for planes in [&[0.5][..], &[0.5; 2], &[0.5; 3], &[]] {
        let refused = balance_planes(&rotor, planes);
        assert!(matches!(refused, Err(BalanceError::CoincidentPlanes { .. })), "{refused:?}");
    }
}

#[test]
fn what_is_not_determined_is_refused_by_name() {
    let mass = |product, angle, position| PartlyKnown { product, angle, position };
    let both = Vanishing::ForceAndCouple;
    let count = balance_unknowns(&[mass(Some(1.0), None, Some(0.0))], both);
    assert_eq!(count, Err(UnknownsError::Count { unknowns: 1, equations: 4 }));
    let turned = [mass(Some(1.0), None, None), mass(Some(1.0), None, None)];
    assert_eq!(balance_unknowns(&turned, Vanishing::Force), Err(UnknownsError::NoDatum));
    let grown = [mass(None, Some(0.0), None), mass(None, Some(1.0), None)];
    assert_eq!(balance_unknowns(&grown, Vanishing::Force), Err(UnknownsError::NoScale));
    let opposed =
        [mass(Some(1.0), Some(0.0), None), mass(None, Some(0.1), None), mass(None, Some(0.2), None)];
    assert!(matches!(balance_unknowns(&opposed, Vanishing::Force), Err(UnknownsError::Negative(_))));
    let short = [mass(Some(1.0), Some(0.0), None), mass(Some(0.2), None, None), mass(Some(0.2), None, None)];
    assert_eq!(balance_unknowns(&short, Vanishing::Force), Err(UnknownsError::Contradiction));
    let one_place =
        [mass(Some(1.0), Some(0.0), Some(1.0)), mass(None, None, None), mass(Some(1.0), Some(0.0), None)];
    assert_eq!(balance_unknowns(&one_place, both), Err(UnknownsError::NoLength));
}

#[test]
fn kinds_of_unbalance() {
    let at = |x: f64, y: f64, position: f64| PlaneUnbalance { position, components: [x, y] };
    let kind = |all: &[PlaneUnbalance]| balance::kind(all, 0.0, 1e-9);
    assert_eq!(kind(&[at(1.0, 0.0, 1.0), at(-1.0, 0.0, 1.0)]), UnbalanceKind::Balanced);
    assert_eq!(kind(&[at(1.0, 2.0, 1.0), at(1.0, 2.0, -1.0)]), UnbalanceKind::Static);
    assert_eq!(kind(&[at(1.0, 2.0, 1.0), at(-1.0, -2.0, -1.0)]), UnbalanceKind::Couple);
    assert_eq!(kind(&[at(1.0, 2.0, 1.0)]), UnbalanceKind::QuasiStatic);
    assert_eq!(kind(&[at(1.0, 0.0, 1.0), at(0.0, 1.0, -1.0)]), UnbalanceKind::Dynamic);
}

#[test]
fn a_four_bar_linkage_is_balanced_by_two_counterweights() {
    let bar = |mass, distance, inertia| LinkInertia { mass, distance, offset: 0.0, inertia };
    let linkage = Linkage {
        crank: 0.04,
        coupler: 0.12,
        crank_link: bar(0.2, 0.02, 0.0),
        coupler_link: bar(0.5, 0.06, 6e-4),
        follower: Follower::Rocker { frame: 0.1, length: 0.08, crossed: false, link: bar(0.3, 0.04, 1e-4) },
    };
    let added = [
        Counterweight { link: 0, mass: 0.35, distance: 0.04, angle: TAU / 2.0 },
        Counterweight { link: 2, mass: 0.032 / 0.06, distance: 0.06, angle: TAU / 2.0 },
    ];
    for step in 0..24 {
        let angle = TAU * f64::from(step) / 24.0;
        let at = |angle: f64| linkage.pose(angle, 50.0).expect("a crank that turns round");
        let (pose, small) = (at(angle), 1e-3);
        let shaking = linkage.shaking(&pose, &added);
        assert!(shaking.force[0].hypot(shaking.force[1]) < 1e-11 * 168.0);
        // Velocities and forces against differences of places, momenta and energies.
        let [ahead, behind] = [1.0, -1.0].map(|side| at(angle + side * small));
        for link in 1..3 {
            let slope = (ahead.angles[link] - behind.angles[link]) / (2.0 * small) * 50.0;
            close(pose.velocities[link], slope, 1e-4);
        }
        let own = linkage.shaking(&pose, &[]);
        let [ahead, behind] = [ahead, behind].map(|pose| linkage.shaking(&pose, &[]));
        let torque = (ahead.energy - behind.energy) / (2.0 * small);
        assert!((own.torque - torque).abs() < 1e-4, "{} {torque}", own.torque);
        for axis in 0..2 {
            let second = ahead.first_moment[axis] - 2.0 * own.first_moment[axis] + behind.first_moment[axis];
            let force = -second / (small * small) * 2500.0;
            assert!((own.force[axis] - force).abs() < 1e-3, "{} {force}", own.force[axis]);
        }
    }
}
