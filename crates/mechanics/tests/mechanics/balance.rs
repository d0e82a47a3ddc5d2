use std::f64::consts::TAU;

use dalembert_mechanics::balance::{self, BalanceError, PlaneUnbalance, balance_two_planes};
use proptest::prelude::*;

use crate::close::{ROUNDING, all_close, close, found, printed};

fn unbalance(mass: f64, radius: f64, degrees: f64, position: f64) -> PlaneUnbalance {
    let angle = degrees.to_radians();
    PlaneUnbalance {
        position,
        components: [balance::component_x(mass, radius, angle), balance::component_y(mass, radius, angle)],
    }
}

/// Corrections by the closed formulas, one component at a time.
fn by_formulas(unbalances: &[PlaneUnbalance], a: f64, b: f64) -> [[f64; 2]; 2] {
    let component = |axis: usize| {
        let at = || unbalances.iter().map(|u| (u.components[axis], u.position));
        let in_b = balance::correction_in_b(at(), a, b);
        let in_a = balance::correction_in_a(at().map(|(u, _)| u), in_b);
        [in_a, in_b]
    };
    let ([ax, bx], [ay, by]) = (component(0), component(1));
    [[ax, ay], [bx, by]]
}

fn degrees([x, y]: [f64; 2]) -> f64 {
    balance::direction(x, y).to_degrees().rem_euclid(360.0)
}

#[test]
fn rotor_of_example_2() {
    // The printed numbers need the second mass 65 mm from plane A; the text says 25 mm.
    for (second, mass_a, at_a, mass_b, at_b) in
        [(65.0, 7.200, 256.82, 8.371, 19.68), (25.0, 5.531, 318.34, 2.170, 346.28)]
    {
        let rotor = [unbalance(9.0, 0.030, 60.0, 0.020), unbalance(6.0, 0.050, 210.0, second * 1e-3)];
        let [in_a, in_b] = by_formulas(&rotor, 0.0, 0.090);
        printed(balance::correction_mass(in_a[0], in_a[1], 0.020), mass_a, 3);
        printed(balance::correction_mass(in_b[0], in_b[1], 0.020), mass_b, 3);
        printed(degrees(in_a), at_a, 2);
        printed(degrees(in_b), at_b, 2);

        let solved = found(balance_two_planes(&rotor, [0.0, 0.090]));
        all_close(solved.in_a, in_a, ROUNDING);
        all_close(solved.in_b, in_b, ROUNDING);
    }
}

#[test]
fn sums_and_moments_of_example_2() {
    // Weights in N and radii in mm, as the notes have them.
    let (w1, w2) = (90.0, 60.0);
    let x = [
        balance::component_x(w1, 30.0, 60f64.to_radians()),
        balance::component_x(w2, 50.0, 210f64.to_radians()),
    ];
    let y = [
        balance::component_y(w1, 30.0, 60f64.to_radians()),
        balance::component_y(w2, 50.0, 210f64.to_radians()),
    ];
    printed(balance::resultant(x), -1248.1, 1);
    printed(balance::resultant(y), 838.3, 1);
    let b = |c: [f64; 2]| balance::correction_in_b([(c[0], 20.0), (c[1], 65.0)], 0.0, 90.0);
    printed(b(x), 1576.4, 1);
    printed(b(y), 563.7, 1);
    printed(balance::magnitude(b(x), b(y)), 1674.2, 1);
}

#[test]
fn one_plane() {
    let rotor = [unbalance(2.0, 0.1, 0.0, 0.0), unbalance(1.0, 0.2, 90.0, 0.0)];
    let sum = |axis: usize| balance::single_plane_correction(rotor.iter().map(|u| u.components[axis]));
    close(balance::magnitude(sum(0), sum(1)), 0.2 * 2f64.sqrt(), ROUNDING);
    close(degrees([sum(0), sum(1)]), 225.0, ROUNDING);
    // A 1 kg mass at 0.2 m and 100 rad/s pulls with 2 kN.
    close(balance::centrifugal_force(0.2, 100.0), 2000.0, ROUNDING);
}

#[test]
fn coincident_planes_are_refused_and_near_ones_are_not() {
    let rotor = [unbalance(9.0, 0.030, 60.0, 0.020), unbalance(6.0, 0.050, 210.0, 0.065)];
    for at in [0.0, 0.04, -7.0] {
        let refused = Err(BalanceError::CoincidentPlanes { a: at, b: at });
        assert_eq!(balance_two_planes(&rotor, [at, at]), refused);
    }
    let near = |distance: f64| balance_two_planes(&rotor, [0.03, 0.03 + distance]);
    assert!(matches!(near(1e-17), Err(BalanceError::CoincidentPlanes { .. })));
    assert!(matches!(near(1e-16), Err(BalanceError::CoincidentPlanes { .. })));
    let [_, in_b] = by_formulas(&rotor, 0.03, 0.03 + 1e-6);
    let solved = found(near(1e-6));
    all_close(solved.in_b, in_b, 1e-9);
    assert!(solved.condition > 1e4 && solved.condition < 1e6, "{}", solved.condition);
    assert_eq!(balance_two_planes(&[], [1.0, 1.0]), Err(BalanceError::CoincidentPlanes { a: 1.0, b: 1.0 }));
}

#[test]
fn planes_at_the_ends_are_the_best_conditioned() {
    let rotor = [unbalance(1.0, 0.1, 10.0, 0.5)];
    close(found(balance_two_planes(&rotor, [0.0, 1.0])).condition, 1.0, ROUNDING);
}

#[test]
fn what_is_not_a_number_is_refused() {
    let bad = [unbalance(1.0, f64::NAN, 0.0, 0.1)];
    assert_eq!(balance_two_planes(&bad, [0.0, 1.0]), Err(BalanceError::NotFinite));
    let bad = [unbalance(1.0, 1.0, 0.0, f64::INFINITY)];
    assert_eq!(balance_two_planes(&bad, [0.0, 1.0]), Err(BalanceError::NotFinite));
    assert_eq!(balance_two_planes(&[], [0.0, f64::NAN]), Err(BalanceError::NotFinite));
}

#[test]
fn a_balanced_rotor_needs_nothing() {
    let pair = [unbalance(1.0, 0.1, 30.0, 0.2), unbalance(1.0, 0.1, 210.0, 0.2)];
    let solved = found(balance_two_planes(&pair, [0.0, 1.0]));
    assert!(balance::magnitude(solved.in_a[0], solved.in_a[1]) < 1e-16);
}

fn rotors() -> impl Strategy<Value = Vec<PlaneUnbalance>> {
    let plane = (0.001..10.0, 0.001..1.0, 0.0..360.0, -2.0..2.0)
        .prop_map(|(mass, radius, angle, position)| unbalance(mass, radius, angle, position));
    prop::collection::vec(plane, 1..20)
}

proptest! {
    #[test]
    fn nothing_remains(rotor in rotors(), a in -2.0..2.0f64, b in -2.0..2.0f64) {
        prop_assume!((a - b).abs() > 0.05);
        let solved = found(balance_two_planes(&rotor, [a, b]));
        let size: f64 = rotor.iter().map(|u| balance::magnitude(u.components[0], u.components[1])).sum();
        let amplification = 4.0 / (a - b).abs();
        prop_assert!(solved.residual <= 1e-14 * size * amplification);
        prop_assert!(solved.residual_moment <= 1e-14 * size * amplification);
        let [in_a, in_b] = by_formulas(&rotor, a, b);
        all_close(solved.in_a, in_a, 1e-9);
        all_close(solved.in_b, in_b, 1e-9);
        for (axis, expected) in in_a.into_iter().enumerate() {
            let at = rotor.iter().map(|u| (u.components[axis], u.position));
            let second_method = balance::correction_in_a_by_moments(at, a, b);
            prop_assert!((second_method - expected).abs() <= 1e-12 * size * amplification);
        }
    }

    #[test]
    fn origin_datum_and_names_of_planes_do_not_matter(
        rotor in rotors(), shift in -5.0..5.0, turn in 0.0..TAU, flip in any::<bool>(),
    ) {
        let planes = [-1.0, 1.5];
        let solved = found(balance_two_planes(&rotor, planes));
        let rotated = |[x, y]: [f64; 2]| [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
        let moved: Vec<_> = rotor
            .iter()
            .map(|u| PlaneUnbalance { position: u.position + shift, components: rotated(u.components) })
            .collect();
        let [a, b] = planes.map(|z| z + shift);
        let again = found(balance_two_planes(&moved, if flip { [b, a] } else { [a, b] }));
        let (in_a, in_b) = if flip { (again.in_b, again.in_a) } else { (again.in_a, again.in_b) };
        let size: f64 = rotor.iter().map(|u| balance::magnitude(u.components[0], u.components[1])).sum();
        for (ours, expected) in [(in_a, rotated(solved.in_a)), (in_b, rotated(solved.in_b))] {
            for axis in 0..2 {
                prop_assert!((ours[axis] - expected[axis]).abs() <= 1e-12 * size);
            }
        }
        close(again.condition, solved.condition, 1e-10);
    }

    #[test]
    fn the_equivalent_unbalances_have_the_resultant_and_the_moment(
        rotor in rotors(), first in -2.0..2.0f64, second in -2.0..2.0f64, about in -3.0..3.0f64,
    ) {
        prop_assume!((first - second).abs() > 0.05);
        let size: f64 = rotor.iter().map(|u| balance::magnitude(u.components[0], u.components[1])).sum();
        let rounding = 1e-12 * size / (first - second).abs();
        for axis in 0..2 {
            let at = || rotor.iter().map(|u| (u.components[axis], u.position));
            let one = balance::equivalent_in_first(at(), first, second);
            let other = balance::equivalent_in_second(at(), first, second);
            prop_assert!((one + other - balance::resultant(at().map(|(u, _)| u))).abs() <= rounding);
            let moment = balance::moment([(one, first), (other, second)], about);
            prop_assert!((moment - balance::moment(at(), about)).abs() <= rounding);
        }
    }

    #[test]
    fn static_and_couple_parts_make_up_the_whole(rotor in rotors()) {
        let solved = found(balance_two_planes(&rotor, [0.0, 1.0]));
        for axis in 0..2 {
            let (a, b) = (solved.in_a[axis], solved.in_b[axis]);
            let (even, odd) = (balance::static_part(a, b), balance::couple_part(a, b));
            prop_assert!((even + odd - a).abs() <= 1e-13 * (a.abs() + b.abs()));
            prop_assert!((even - odd - b).abs() <= 1e-13 * (a.abs() + b.abs()));
            // The couple part has no resultant, and the static part no moment about the middle.
            let couple = balance::moment([(even, 0.0), (even, 1.0)], 0.5);
            prop_assert!(couple.abs() <= 1e-15 * even.abs());
        }
    }
}
