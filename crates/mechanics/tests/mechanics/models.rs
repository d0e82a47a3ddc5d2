//! The mechanisms that the field measures its programs by.

use itertools::Itertools as _;
use std::f64::consts::FRAC_PI_2;

use dalembert_mechanics::planar::{
    BodyPoint, Driver, Effort, Model, PlanarBody, PlanarJoint, PlanarLoad, PlanarMechanism,
    RelativeCoordinate,
};

/// 2 N + 1 rods of 1 m and 1 kg: the upright ones first, then those that join their tops.
pub(crate) fn four_bars(n: usize) -> (Model, Vec<[f64; 3]>) {
    let rod = PlanarBody { mass: 1.0, inertia: 1.0 / 12.0 };
    let ends = |body| [BodyPoint::body(body, [-0.5, 0.0]), BodyPoint::body(body, [0.5, 0.0])];
    let mut joints: Vec<PlanarJoint> =
        (0..=n).map(|k| PlanarJoint::Pin { a: BodyPoint::ground([k as f64, 0.0]), b: ends(k)[0] }).collect();
    for k in 0..n {
        let [left, right] = ends(n + 1 + k);
        joints.push(PlanarJoint::Pin { a: ends(k)[1], b: left });
        joints.push(PlanarJoint::Pin { a: ends(k + 1)[1], b: right });
    }
    let upright = (0..=n).map(|k| [k as f64, 0.5, FRAC_PI_2]);
    let across = (0..n).map(|k| [k as f64 + 0.5, 1.0, 0.0]);
    let drawn: Vec<[f64; 3]> = upright.chain(across).collect();
    let mechanism = PlanarMechanism {
        bodies: vec![rod; 2 * n + 1],
        joints,
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    (Model::new(&mechanism, &drawn).expect("four-bars are well formed"), drawn)
}

const CRANK: f64 = -0.06171389001427645;

/// Andrews' squeezing mechanism, and its bodies in the position with the crank at -0.0617.
pub(crate) fn andrews() -> (Model, Vec<[f64; 3]>) {
    let [a, b, c] = [[-0.06934, -0.00227], [-0.03635, 0.03273], [0.014, 0.072]];
    let [gamma, phi, delta, omega, epsilon] = [
        0.45527981916307037,
        0.22266839016588588,
        0.48736497954384256,
        -0.22266839016588588,
        1.2305474445498212,
    ];
    let (rr, d, ss, e, zt, zf, u) = (0.007, 0.028, 0.035, 0.02, 0.04, 0.02, 0.04);
    let (da, ea, ra, sa, sb, sc, sd) = (0.0115, 0.01421, 0.00092, 0.01874, 0.01043, 0.018, 0.02);
    let (ta, tb, ua, ub, fa) = (0.02308, 0.00916, 0.01228, 0.00449, 0.01421);
    let body = BodyPoint::body;
    let turned =
        |[x, y]: [f64; 2], angle: f64| [angle.cos() * x - angle.sin() * y, angle.sin() * x + angle.cos() * y];
    let placed = |at: [f64; 2], own: [f64; 2], angle: f64| {
        let [x, y] = turned(own, angle);
        [at[0] - x, at[1] - y, angle]
    };
    let f = turned([rr, 0.0], CRANK);
    let (g, h) = (turned([zt, 0.0], delta), turned([0.0, -u], epsilon));
    let (g, h) = ([a[0] + g[0], a[1] + g[1]], [a[0] + h[0], a[1] + h[1]]);
    let drawn = vec![
        placed([0.0, 0.0], [-ra, 0.0], CRANK),
        placed(f, [da, 0.0], CRANK),
        placed(b, [-sb, sa], gamma),
        placed(g, [0.0, e - ea], phi + delta),
        placed(a, [-ta, tb], delta),
        placed(h, [fa - zf, 0.0], omega + epsilon),
        placed(a, [-ua, ub], epsilon),
    ];
    let masses = [0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498];
    let inertias = [2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5];
    let pin = |a, b| PlanarJoint::Pin { a, b };
    let eye = body(1, [da - d, 0.0]);
    let spring = RelativeCoordinate::Distance { from: BodyPoint::ground(c), to: body(2, [sd - sb, sa - sc]) };
    let mechanism = PlanarMechanism {
        bodies: masses.iter().zip_eq(inertias).map(|(&mass, inertia)| PlanarBody { mass, inertia }).collect(),
        joints: vec![
            pin(eye, body(2, [-sb, sa - ss])),
            pin(eye, body(3, [0.0, -ea])),
            pin(eye, body(5, [fa, 0.0])),
            pin(BodyPoint::ground([0.0, 0.0]), body(0, [-ra, 0.0])),
            pin(body(0, [rr - ra, 0.0]), body(1, [da, 0.0])),
            pin(BodyPoint::ground(b), body(2, [-sb, sa])),
            pin(BodyPoint::ground(a), body(4, [-ta, tb])),
            pin(body(4, [zt - ta, tb]), body(3, [0.0, e - ea])),
            pin(BodyPoint::ground(a), body(6, [-ua, ub])),
            pin(body(6, [-ua, ub - u]), body(5, [fa - zf, 0.0])),
        ],
        drivers: vec![],
        loads: vec![
            PlanarLoad::Effort {
                measure: RelativeCoordinate::Angle { of: Some(0), against: None },
                effort: Effort::Constant(0.033),
            },
            PlanarLoad::Effort {
                measure: spring,
                effort: Effort::Spring { stiffness: 4530.0, free: 0.07785 },
            },
        ],
        gravity: [0.0, 0.0],
    };
    (Model::new(&mechanism, &drawn).expect("the mechanism is well formed"), drawn)
}

/// A mechanism driven by the angle of its first body, and where it is drawn.
pub(crate) type Driven = (Model, Vec<[f64; 3]>);

fn turned_by(mechanism: PlanarMechanism, drawn: &[[f64; 3]], [velocity, acceleration]: [f64; 2]) -> Driven {
    let measure = RelativeCoordinate::Angle { of: Some(0), against: None };
    let driver = Driver { measure, value: drawn[0][2], velocity, acceleration };
    let mechanism = PlanarMechanism { drivers: vec![driver], ..mechanism };
    let system = Model::new(&mechanism, drawn).expect("the mechanism is well formed");
    let drawn = system.assemble(drawn).expect("the mechanism closes");
    (system, drawn)
}

/// A point of a bar of which the centre of mass is in the middle, from its first end.
fn along(body: usize, length: f64, at: f64) -> BodyPoint {
    BodyPoint::body(body, [at - length / 2.0, 0.0])
}

fn pin(a: BodyPoint, b: BodyPoint) -> PlanarJoint {
    PlanarJoint::Pin { a, b }
}

/// The crank-rocker of the yardstick: ground 0.30, crank 0.10, coupler 0.28, rocker 0.20 m, 5 N m against the rocker.
pub(crate) fn crank_rocker(rates: [f64; 2]) -> Driven {
    let mechanism = PlanarMechanism {
        bodies: vec![
            PlanarBody { mass: 0.5, inertia: 0.5 * 0.01 / 12.0 },
            PlanarBody { mass: 1.0, inertia: 0.0784 / 12.0 },
            PlanarBody { mass: 0.8, inertia: 0.8 * 0.04 / 12.0 },
        ],
        joints: vec![
            pin(BodyPoint::ground([0.0, 0.0]), along(0, 0.1, 0.0)),
            pin(along(0, 0.1, 0.1), along(1, 0.28, 0.0)),
            pin(along(1, 0.28, 0.28), along(2, 0.2, 0.2)),
            pin(BodyPoint::ground([0.3, 0.0]), along(2, 0.2, 0.0)),
        ],
        loads: vec![PlanarLoad::Effort {
            measure: RelativeCoordinate::Angle { of: Some(2), against: None },
            effort: Effort::Constant(-5.0),
        }],
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    turned_by(mechanism, &[[0.05, 0.01, 0.3], [0.23, 0.1, 0.5], [0.28, 0.1, 1.9]], rates)
}

/// The slider-crank of the yardstick, with a spring behind the slider and a damper at it.
pub(crate) fn driven_slider(rates: [f64; 2]) -> Driven {
    let slider = BodyPoint::body(2, [0.0, 0.0]);
    let way = RelativeCoordinate::Component {
        direction: [1.0, 0.0],
        from: BodyPoint::ground([0.0, 0.0]),
        to: slider,
    };
    let mechanism = PlanarMechanism {
        bodies: vec![
            PlanarBody { mass: 1.2, inertia: 8e-4 },
            PlanarBody { mass: 0.8, inertia: 3.5e-3 },
            PlanarBody { mass: 0.5, inertia: 0.0 },
        ],
        joints: vec![
            pin(BodyPoint::ground([0.0, 0.0]), BodyPoint::body(0, [-0.02, 0.0])),
            pin(BodyPoint::body(0, [0.03, 0.0]), BodyPoint::body(1, [-0.07, 0.0])),
            pin(BodyPoint::body(1, [0.13, 0.0]), slider),
            PlanarJoint::Slider {
                guide: BodyPoint::ground([0.0, 0.0]),
                direction: 0.0,
                slides: slider,
                angle: 0.0,
            },
        ],
        loads: vec![
            PlanarLoad::Force { at: slider, force: [-200.0, 0.0], turns_with: None },
            PlanarLoad::Effort { measure: way, effort: Effort::Spring { stiffness: 900.0, free: 0.2 } },
            PlanarLoad::Effort { measure: way, effort: Effort::Damper { coefficient: 12.0 } },
        ],
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    turned_by(mechanism, &[[0.02, 0.0, 0.3], [0.1, 0.0, -0.1], [0.24, 0.0, 0.0]], rates)
}

/// A six-bar of Stephenson's third kind: a crank-rocker whose coupler point drives a dyad to a third pivot.
pub(crate) fn six_bar(rates: [f64; 2]) -> Driven {
    let bar = |mass: f64, length: f64| PlanarBody { mass, inertia: mass * length * length / 12.0 };
    let mechanism = PlanarMechanism {
        bodies: vec![bar(0.5, 0.1), bar(1.0, 0.28), bar(0.8, 0.2), bar(0.9, 0.3), bar(0.7, 0.25)],
        joints: vec![
            pin(BodyPoint::ground([0.0, 0.0]), along(0, 0.1, 0.0)),
            pin(along(0, 0.1, 0.1), along(1, 0.28, 0.0)),
            pin(along(1, 0.28, 0.28), along(2, 0.2, 0.2)),
            pin(BodyPoint::ground([0.3, 0.0]), along(2, 0.2, 0.0)),
            pin(BodyPoint::body(1, [0.02, 0.1]), along(3, 0.3, 0.0)),
            pin(along(3, 0.3, 0.3), along(4, 0.25, 0.25)),
            pin(BodyPoint::ground([0.5, 0.25]), along(4, 0.25, 0.0)),
        ],
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    let drawn = [[0.05, 0.01, 0.3], [0.23, 0.1, 0.5], [0.28, 0.1, 1.9], [0.3, 0.32, 0.8], [0.45, 0.37, 2.0]];
    turned_by(mechanism, &drawn, rates)
}

/// Andrews' mechanism with its crank driven.
pub(crate) fn driven_squeezer(rates: [f64; 2]) -> Driven {
    let (system, drawn) = andrews();
    turned_by(system.mechanism().clone(), &drawn, rates)
}

/// The distance of two neighbouring pivots on the ground, and the length of the couplers, of [`drag_links`], m.
const DRAG_LINKS: [f64; 2] = [0.15, 0.8];

/// The angles of the cranks of [`drag_links`] with the first at an angle, one after the other by the triangle of two
/// pivots and a circle about each.
pub(crate) fn angles_of_drag_links(n: usize, first: f64) -> Vec<f64> {
    let [ground, coupler] = DRAG_LINKS;
    let mut angles = vec![first];
    for k in 0..n {
        // The end of the crank, from the next pivot.
        let [x, y] = [angles[k].cos() - ground, angles[k].sin()];
        let far = x.hypot(y);
        let ahead = y.atan2(x) + ((1.0 + far * far - coupler * coupler) / (2.0 * far)).acos() - angles[k];
        angles.push(angles[k] + ahead.rem_euclid(std::f64::consts::TAU));
    }
    angles
}

/// Four-bars in a row, each of which turns the first crank of the next, all by whole turns: `n + 1` cranks of 1 m, then
/// `n` couplers; their rods have 1 kg/m.
pub(crate) fn drag_links(n: usize, rates: [f64; 2]) -> Driven {
    let [ground, coupler] = DRAG_LINKS;
    let rod = |length: f64| PlanarBody { mass: length, inertia: length.powi(3) / 12.0 };
    let mut joints: Vec<PlanarJoint> =
        (0..=n).map(|k| pin(BodyPoint::ground([ground * k as f64, 0.0]), along(k, 1.0, 0.0))).collect();
    for k in 0..n {
        joints.push(pin(along(k, 1.0, 1.0), along(n + 1 + k, coupler, 0.0)));
        joints.push(pin(along(k + 1, 1.0, 1.0), along(n + 1 + k, coupler, coupler)));
    }
    let angles = angles_of_drag_links(n, 0.3);
    let end = |k: usize, part: f64| [ground * k as f64 + part * angles[k].cos(), part * angles[k].sin()];
    let cranks = (0..=n).map(|k| [end(k, 0.5)[0], end(k, 0.5)[1], angles[k]]);
    let couplers = (0..n).map(|k| {
        let ([ax, ay], [bx, by]) = (end(k, 1.0), end(k + 1, 1.0));
        [f64::midpoint(ax, bx), f64::midpoint(ay, by), (by - ay).atan2(bx - ax)]
    });
    let drawn: Vec<[f64; 3]> = cranks.chain(couplers).collect();
    let mechanism = PlanarMechanism {
        bodies: [vec![rod(1.0); n + 1], vec![rod(coupler); n]].concat(),
        joints,
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    turned_by(mechanism, &drawn, rates)
}
