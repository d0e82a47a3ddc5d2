//! Instant centres and the forces between the parts of a mechanism, held against closed forms and the balance of the
//! whole.

use dalembert_mechanics::planar::{
    BodyFrame, BodyPoint, Effort, InstantCentre, Model, PlanarBody, PlanarJoint, PlanarLoad, PlanarMechanism,
    PlanarState, RelativeCoordinate,
};

use crate::{
    close::{ROUNDING, all_close, close, found},
    planar::{drawn, ends, four_bar, moving, slider_crank, turning},
};

const LENGTHS: [f64; 4] = [0.05, 0.151, 0.111, 0.1];

fn four_bar_at(angle: f64) -> (Model, PlanarState) {
    let driver = turning(0, angle, 95.0, 0.0);
    moving(&four_bar(LENGTHS, [PlanarBody::default(); 3], driver), &drawn(LENGTHS, [angle, 0.3, 1.3]))
}

fn centre(system: &Model, state: &PlanarState, parts: [BodyFrame; 2]) -> InstantCentre {
    system.instant_centre(parts, &state.positions, &state.velocities)
}

#[track_caller]
fn point(system: &Model, state: &PlanarState, parts: [BodyFrame; 2]) -> [f64; 2] {
    match centre(system, state, parts) {
        InstantCentre::At(at) => at,
        other => panic!("{parts:?}: {other:?}"),
    }
}

#[test]
fn the_centres_of_a_four_bar_are_its_pins_and_where_its_lines_meet() {
    let [a, _, c, d] = LENGTHS;
    for angle in [0.7, 2.1, 2.8] {
        let (system, state) = four_bar_at(angle);
        let [crank, coupler, rocker] = [0, 1, 2].map(Some);
        let at = |parts: [BodyFrame; 2]| point(&system, &state, parts);
        let crank_pin = [a * angle.cos(), a * angle.sin()];
        let swing = state.positions[2][2];
        let rocker_pin = [d + c * swing.cos(), c * swing.sin()];
        for (parts, pin) in [
            ([None, crank], [0.0, 0.0]),
            ([crank, coupler], crank_pin),
            ([coupler, rocker], rocker_pin),
            ([None, rocker], [d, 0.0]),
        ] {
            let [x, y] = at(parts);
            assert!((x - pin[0]).hypot(y - pin[1]) < 1e-12, "{parts:?} at {angle}: ({x}, {y}), not {pin:?}");
        }
        // Crank and rocker: x ω₂ = (x − d) ω₄ on the line of the frame.
        let [fast, slow] = [0, 2].map(|body: usize| state.velocities[body][2]);
        let [x, y] = at([crank, rocker]);
        close(x, -slow * d / (fast - slow), 1e-11);
        assert!(y.abs() < 1e-12 * x.abs().max(d));
        // Coupler and ground: on the line of the crank, so far from its pin that a ω₂ = −ρ ω₃.
        let way = a * (1.0 - fast / state.velocities[1][2]);
        all_close(at([None, coupler]), [way * angle.cos(), way * angle.sin()], 1e-11);
    }
}

#[test]
fn a_centre_does_not_depend_on_the_speed() {
    let (system, state) = four_bar_at(2.1);
    for share in [1e-13, 1e9] {
        let velocities: Vec<[f64; 3]> = state.velocities.iter().map(|v| v.map(|v| share * v)).collect();
        for parts in [[None, Some(1)], [Some(0), Some(2)], [Some(2), Some(1)]] {
            match system.instant_centre(parts, &state.positions, &velocities) {
                InstantCentre::At(at) => all_close(at, point(&system, &state, parts), ROUNDING),
                other => panic!("{parts:?}, {share:e} times as fast: {other:?}"),
            }
        }
    }
}

#[test]
fn three_centres_of_three_parts_lie_on_a_line() {
    let (system, state) = four_bar_at(2.1);
    let parts = [None, Some(0), Some(1), Some(2)];
    for left_out in parts {
        let three: Vec<BodyFrame> = parts.into_iter().filter(|part| *part != left_out).collect();
        let [p, q, r] = [[0, 1], [1, 2], [0, 2]].map(|pair| point(&system, &state, pair.map(|k| three[k])));
        let ([ux, uy], [vx, vy]) = ([q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]);
        let size = ux.hypot(uy) * vx.hypot(vy);
        assert!(size > 1e-4 && (ux * vy - uy * vx).abs() < 1e-11 * size, "{three:?}");
    }
}

#[test]
fn parts_that_turn_alike_have_their_centre_at_infinity() {
    let (mechanism, angle) = braced();
    let (system, state) = moving(&mechanism, &[[0.0, 0.0, angle], [0.2, 0.04, -0.4], [0.3, 0.0, 0.0]]);
    let InstantCentre::Far([x, y]) = centre(&system, &state, [None, Some(2)]) else { panic!("it slides") };
    assert!(x.abs() < 1e-12 && (y.abs() - 1.0).abs() < 1e-15, "({x}, {y}) is not across the line");
    // The slider moves as the crank would where the rod meets the normal of the line through the bearing.
    let [x, y] = point(&system, &state, [Some(0), Some(2)]);
    assert!(x.abs() < 1e-12);
    close(y * 20.0, -state.velocities[2][0], 1e-11);
    assert_eq!(centre(&system, &state, [Some(1), Some(1)]), InstantCentre::Everywhere);
}

#[test]
fn a_joint_pulls_its_two_parts_with_opposite_forces_and_the_ground_takes_what_is_left() {
    let (mechanism, angle) = braced();
    let disc = {
        let mut disc = mechanism.clone();
        let (centre, floor) = (BodyPoint::body(2, [0.0; 2]), BodyPoint::ground([0.0, -0.15]));
        disc.bodies[2].inertia = 0.045;
        disc.joints.pop();
        disc.joints.push(PlanarJoint::Slot { guide: floor, direction: 0.0, pin: centre, offset: 0.15 });
        disc.joints.push(PlanarJoint::Rack { guide: floor, direction: 0.0, centre, radius: 0.15 });
        disc
    };
    for mechanism in [mechanism, disc] {
        let (system, state) = moving(&mechanism, &[[0.0, 0.0, angle], [0.2, 0.04, -0.4], [0.3, 0.0, 0.0]]);
        let dynamics = found(system.inverse_dynamics(&state));
        let on = |part: BodyFrame, owner: usize| {
            system.force_on(part, owner, &state.positions, &dynamics.multipliers)
        };
        let mut ground = spring_on_the_wall(&system, &state);
        for owner in 0..mechanism.joints.len() + mechanism.drivers.len() {
            let parts = system.connected_parts(owner);
            if let [first, second] = parts[..] {
                all_close(on(first, owner), on(second, owner).map(|force| -force), ROUNDING);
            }
            let [x, y] = on(None, owner);
            ground = [ground[0] + x, ground[1] + y];
        }
        assert_eq!(on(Some(0), 0), [dynamics.multipliers[0], dynamics.multipliers[1]]);
        all_close(system.shaking_force(&state), ground, 1e-11);
    }
}

/// A slider-crank at 30° with a force that turns with its rod, and a spring and a damper from a wall.
fn braced() -> (PlanarMechanism, f64) {
    let (rod, angle, wall) = (0.2, 30f64.to_radians(), wall());
    let [_, end] = ends(1, rod, rod / 2.0);
    let loads = vec![
        PlanarLoad::Force { at: end, force: [500.0, 70.0], turns_with: Some(1) },
        PlanarLoad::Effort { measure: wall, effort: Effort::Spring { stiffness: 800.0, free: 0.1 } },
        PlanarLoad::Effort { measure: wall, effort: Effort::Damper { coefficient: 25.0 } },
    ];
    (slider_crank([0.15, rod], angle, loads), angle)
}

fn wall() -> RelativeCoordinate {
    RelativeCoordinate::Distance { from: BodyPoint::ground([-0.2, 0.1]), to: BodyPoint::body(2, [0.0, 0.0]) }
}

/// Force of spring and damper on the wall.
fn spring_on_the_wall(system: &Model, state: &PlanarState) -> [f64; 2] {
    let (length, rate) = (system.value(&wall(), &state.positions), system.rate(&wall(), state));
    let thrust = -800.0 * (length - 0.1) - 25.0 * rate;
    let [x, y, _] = state.positions[2];
    [-thrust * (x + 0.2) / length, -thrust * (y - 0.1) / length]
}
