//! The mechanisms that the field measures its programs by.

use std::f64::consts::FRAC_PI_2;

use dalembert_mechanics::planar::{Body, Effort, Joint, Load, Measure, Mechanism, Point, System};

/// 2 N + 1 rods of 1 m and 1 kg: the upright ones first, then those that join their tops.
pub(crate) fn four_bars(n: usize) -> (System, Vec<[f64; 3]>) {
    let rod = Body { mass: 1.0, inertia: 1.0 / 12.0 };
    let ends = |body| [Point::body(body, [-0.5, 0.0]), Point::body(body, [0.5, 0.0])];
    let mut joints: Vec<Joint> =
        (0..=n).map(|k| Joint::Pin { a: Point::ground([k as f64, 0.0]), b: ends(k)[0] }).collect();
    for k in 0..n {
        let [left, right] = ends(n + 1 + k);
        joints.push(Joint::Pin { a: ends(k)[1], b: left });
        joints.push(Joint::Pin { a: ends(k + 1)[1], b: right });
    }
    let upright = (0..=n).map(|k| [k as f64, 0.5, FRAC_PI_2]);
    let across = (0..n).map(|k| [k as f64 + 0.5, 1.0, 0.0]);
    let drawn: Vec<[f64; 3]> = upright.chain(across).collect();
    let mechanism =
        Mechanism { bodies: vec![rod; 2 * n + 1], joints, gravity: [0.0, -9.81], ..Mechanism::default() };
    (System::new(&mechanism, &drawn).expect("four-bars are well formed"), drawn)
}

const CRANK: f64 = -0.06171389001427645;

/// Andrews' squeezing mechanism, and its bodies in the position with the crank at -0.0617.
pub(crate) fn andrews() -> (System, Vec<[f64; 3]>) {
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
    let body = Point::body;
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
    let pin = |a, b| Joint::Pin { a, b };
    let eye = body(1, [da - d, 0.0]);
    let spring = Measure::Distance { from: Point::ground(c), to: body(2, [sd - sb, sa - sc]) };
    let mechanism = Mechanism {
        bodies: masses.iter().zip(inertias).map(|(&mass, inertia)| Body { mass, inertia }).collect(),
        joints: vec![
            pin(eye, body(2, [-sb, sa - ss])),
            pin(eye, body(3, [0.0, -ea])),
            pin(eye, body(5, [fa, 0.0])),
            pin(Point::ground([0.0, 0.0]), body(0, [-ra, 0.0])),
            pin(body(0, [rr - ra, 0.0]), body(1, [da, 0.0])),
            pin(Point::ground(b), body(2, [-sb, sa])),
            pin(Point::ground(a), body(4, [-ta, tb])),
            pin(body(4, [zt - ta, tb]), body(3, [0.0, e - ea])),
            pin(Point::ground(a), body(6, [-ua, ub])),
            pin(body(6, [-ua, ub - u]), body(5, [fa - zf, 0.0])),
        ],
        drivers: vec![],
        loads: vec![
            Load::Effort {
                measure: Measure::Angle { of: Some(0), against: None },
                effort: Effort::Constant(0.033),
            },
            Load::Effort { measure: spring, effort: Effort::Spring { stiffness: 4530.0, free: 0.07785 } },
        ],
        gravity: [0.0, 0.0],
    };
    (System::new(&mechanism, &drawn).expect("the mechanism is well formed"), drawn)
}
