//! Tests of `four_bar`.

use dalembert_mechanics::four_bar::*;
use dalembert_mechanics::linkage::{LinkMass, PointMotion, ReducedMasses};

const LENGTHS: FourBar<f64> = FourBar { frame: 0.30, crank: 0.10, coupler: 0.28, rocker: 0.20 };

fn masses(links: &Links<f64>) -> ReducedMasses<f64> {
    let rod = |mass: f64, length: f64| LinkMass {
        mass,
        centre: [length / 2.0, 0.0],
        inertia: mass * length * length / 12.0,
    };
    rod(0.5, LENGTHS.crank)
        .reduced(PointMotion::fixed([0.0; 2]), links.crank)
        .and(rod(1.0, LENGTHS.coupler).reduced(links.crank_pin, links.coupler))
        .and(rod(0.8, LENGTHS.rocker).reduced(LENGTHS.fixed_pin(), links.rocker))
}

#[test]
fn torque_is_that_of_the_equation_of_motion() {
    // Lagrange's equation derived by computer algebra; compared with the rate of the energy.
    let torques =
        [-5.037504590790, 5.660819057759, -0.988805188559, -2.204232306681, 1.597334060676, 2.482987048630];
    for (step, printed) in (0..).zip(torques) {
        let angle = 0.3 + f64::from(step) * std::f64::consts::FRAC_PI_3;
        let links = LENGTHS.links(angle, Branch::Open);
        let torque = masses(&links).torque(30.0, 5.0, 9.81) + 5.0 * links.rocker.first;
        assert!((torque - printed).abs() < 1e-11, "at {angle}: {torque} for {printed}");
    }
}

#[test]
fn loop_closes_and_coefficients_are_derivatives_on_both_branches() {
    for branch in [Branch::Open, Branch::Crossed] {
        for step in 0..12 {
            let angle = 0.1 + 0.5 * f64::from(step);
            let at = |angle| LENGTHS.links(angle, branch);
            let links = at(angle);
            let along = |length| [length, 0.0];
            let by_coupler = links.crank_pin.to(links.coupler, along(LENGTHS.coupler));
            let by_rocker = LENGTHS.fixed_pin().to(links.rocker, along(LENGTHS.rocker));
            for axis in 0..2 {
                assert!((by_coupler.at[axis] - by_rocker.at[axis]).abs() < 1e-15);
                assert!((by_coupler.first[axis] - by_rocker.first[axis]).abs() < 1e-14);
                assert!((by_coupler.second[axis] - by_rocker.second[axis]).abs() < 1e-13);
            }
            let (before, after) = (masses(&at(angle - 1e-5)), masses(&at(angle + 1e-5)));
            let slope = (after.inertia - before.inertia) / 4e-5;
            assert!((slope - masses(&links).half_slope).abs() < 1e-9, "at {angle}: {slope}");
        }
    }
}

#[test]
fn there_is_no_number_where_the_linkage_does_not_close() {
    let short = FourBar { coupler: 0.05, ..LENGTHS };
    assert!(short.links(3.0, Branch::Open).coupler.first.is_nan());
}
