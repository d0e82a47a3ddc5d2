//! Holding efforts, stiffness and stored energy of plane mechanisms against each other, by differences of five points.

use dalembert_mechanics::planar::{
    BodyPoint, Effort, Model, PlanarBody, PlanarJoint, PlanarLoad, PlanarMechanism, Profile,
    RelativeCoordinate,
};

use crate::{
    close::{close, found},
    planar::{ends, turning},
};

/// The slope of a function at a place.
fn slope(function: impl Fn(f64) -> f64, at: f64, step: f64) -> f64 {
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| function(at + k * step));
    (a - 8.0 * b + 8.0 * c - d) / (12.0 * step)
}

#[test]
fn an_effort_is_the_loss_of_its_energy_along_the_measure() {
    let profile = Profile::through(&[[0.1, 40.0], [0.3, -25.0], [0.45, 60.0], [0.9, 15.0]], None)
        .expect("the points ascend");
    let gas = |exponent| Effort::Gas { area: 2e-3, pressure: 4e5, column: 0.25, exponent, ambient: 1e5 };
    let efforts = [
        Effort::Constant(-7.3),
        Effort::Spring { stiffness: 350.0, free: 0.21 },
        gas(1.0),
        gas(1.4),
        Effort::Table(profile),
    ];
    for effort in efforts {
        for value in [0.17, 0.37, 0.62] {
            let energy = |value: f64| effort.energy(value).expect("the effort is conservative");
            let thrust: f64 = effort.at(value, 0.0);
            close(slope(energy, value, 5e-4), -thrust, 1e-8);
        }
    }
}

#[test]
fn the_stiffness_is_the_growth_of_the_holding_efforts() {
    let ([o, p], [q, tip]) = (ends(0, 0.8, 0.4), ends(1, 0.7, 0.3));
    let distance =
        |x: f64, y: f64, to: BodyPoint| RelativeCoordinate::Distance { from: BodyPoint::ground([x, y]), to };
    let turn = RelativeCoordinate::Angle { of: Some(1), against: Some(0) };
    let gas = Effort::Gas { area: 5e-4, pressure: 3e5, column: 0.8, exponent: 1.3, ambient: 1e5 };
    let effort = |measure, effort| PlanarLoad::Effort { measure, effort };
    let values = [0.7, -0.4];
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody { mass: 3.1, inertia: 0.2 }, PlanarBody { mass: 1.7, inertia: 0.1 }],
        joints: vec![
            PlanarJoint::Pin { a: BodyPoint::ground([0.1, -0.2]), b: o },
            PlanarJoint::Pin { a: p, b: q },
        ],
        drivers: vec![turning(0, values[0], 0.0, 0.0), turning(1, values[1], 0.0, 0.0)],
        loads: vec![
            effort(distance(1.5, 1.2, tip), Effort::Spring { stiffness: 140.0, free: 0.35 }),
            effort(distance(-0.6, 0.9, BodyPoint::body(0, [0.2, -0.1])), gas),
            effort(turn, Effort::Spring { stiffness: 12.0, free: 0.3 }),
            PlanarLoad::Force {
                at: BodyPoint::body(1, [0.3, 0.2]),
                force: [15.0, -8.0],
                turns_with: Some(0),
            },
            PlanarLoad::Force { at: BodyPoint::body(0, [0.1, 0.3]), force: [-21.0, 13.0], turns_with: None },
        ],
        gravity: [0.7, -9.81],
    };
    let drawn = [[0.4, 0.06, 0.7], [1.0, 0.2, -0.4]];
    let system = found(Model::new(&mechanism, &drawn));
    let positions = found(system.assemble(&drawn));
    let growth = |of: usize, along: usize| {
        let effort = |value: f64| {
            let mut values = values;
            values[along] = value;
            let there = found(system.continue_to(&positions, &values));
            found(system.holding_efforts(&there.positions))[of]
        };
        slope(effort, values[along], 1e-3)
    };
    let stiffness = found(system.stiffness(&positions));
    for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        // The force that turns with a bar has no potential: the symmetric part.
        let expected = f64::midpoint(growth(row, column), growth(column, row));
        close(stiffness[(row, column)], expected, 1e-8);
    }
}
