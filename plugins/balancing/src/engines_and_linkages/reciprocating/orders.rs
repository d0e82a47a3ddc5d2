//! The forces and couples of one order as forward and backward vectors.

use std::f64::consts::{PI, TAU};

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real,
    balance::{
        self,
        reciprocating::{self as engine, Piston, PistonMotion},
    },
    slider_crank,
};

use super::{Terms, checks, layout::Placed};
use crate::sources::DEN_HARTOG;

/// A vector that turns forward and one that turns backward.
#[derive(Clone, Copy)]
pub(super) struct Pair<N> {
    pub forward: [N; 2],
    pub backward: [N; 2],
    pub forward_size: N,
    pub backward_size: N,
}

/// Results of one harmonic order.
pub(super) struct Order<N> {
    pub number: u8,
    /// Sum of the amplitudes, the size of what may cancel.
    pub scale: f64,
    /// The largest distance from the point about which moments are referred.
    pub reach: f64,
    pub force: Pair<N>,
    pub couple: Option<Pair<N>>,
}

struct Names {
    amplitude: &'static str,
    forward: [&'static str; 3],
    backward: [&'static str; 3],
    couple_forward: [&'static str; 3],
    couple_backward: [&'static str; 3],
    most: [&'static str; 4],
    at: [&'static str; 3],
    angle: [&'static str; 2],
}

const NAMES: [Names; 4] = [
    Names {
        amplitude: "K_I",
        forward: ["P_Ix", "P_Iy", "P_I"],
        backward: ["Q_Ix", "Q_Iy", "Q_I"],
        couple_forward: ["M_Ix", "M_Iy", "M_I"],
        couple_backward: ["N_Ix", "N_Iy", "N_I"],
        most: ["F_I", "F′_I", "C_I", "C′_I"],
        at: ["X_I", "Y_I", "R_I"],
        angle: ["θ_I", "β_I"],
    },
    Names {
        amplitude: "K_II",
        forward: ["P_IIx", "P_IIy", "P_II"],
        backward: ["Q_IIx", "Q_IIy", "Q_II"],
        couple_forward: ["M_IIx", "M_IIy", "M_II"],
        couple_backward: ["N_IIx", "N_IIy", "N_II"],
        most: ["F_II", "F′_II", "C_II", "C′_II"],
        at: ["X_II", "Y_II", "R_II"],
        angle: ["θ_II", "β_II"],
    },
    Names {
        amplitude: "K_IV",
        forward: ["P_IVx", "P_IVy", "P_IV"],
        backward: ["Q_IVx", "Q_IVy", "Q_IV"],
        couple_forward: ["M_IVx", "M_IVy", "M_IV"],
        couple_backward: ["N_IVx", "N_IVy", "N_IV"],
        most: ["F_IV", "F′_IV", "C_IV", "C′_IV"],
        at: ["X_IV", "Y_IV", "R_IV"],
        angle: ["θ_IV", "β_IV"],
    },
    Names {
        amplitude: "K_VI",
        forward: ["P_VIx", "P_VIy", "P_VI"],
        backward: ["Q_VIx", "Q_VIy", "Q_VI"],
        couple_forward: ["M_VIx", "M_VIy", "M_VI"],
        couple_backward: ["N_VIx", "N_VIy", "N_VI"],
        most: ["F_VI", "F′_VI", "C_VI", "C′_VI"],
        at: ["X_VI", "Y_VI", "R_VI"],
        angle: ["θ_VI", "β_VI"],
    },
];

fn names(order: u8) -> &'static Names {
    &NAMES[usize::from(order / 2).min(3)]
}

/// The amplitude of an order of every cylinder.
pub(super) fn strengths<W: Worksheet>(
    order: u8,
    motion: Terms,
    cylinders: &[Placed<W::Num>],
    primary: &[W::Num],
    sheet: W,
) -> Vec<W::Num> {
    if order == 1 {
        return primary.to_vec();
    }
    let mut last: Option<W::Num> = None;
    let each = cylinders.iter().zip(primary).map(|(c, primary)| match (last, c.rod) {
        (Some(same), _) if c.row == 0 => same,
        (_, None) => 0.0.into(),
        (_, Some(rod)) => {
            let value = match motion {
                Terms::Two => *primary * (c.crank / rod),
                Terms::Exact => {
                    let ratio = c.crank.value() / rod.value();
                    let harmonic = engine::harmonics(ratio)[usize::from(order / 2 - 1).min(2)];
                    let how = "Amplitude of this order in the motion of a piston, by its Fourier integral";
                    let symbol = match order {
                        2 => "A₂",
                        4 => "A₄",
                        _ => "A₆",
                    };
                    let harmonic = sheet.numerical((symbol, c.row), "1", harmonic, how);
                    if c.row <= 1 {
                        sheet.answer(
                            ("harmonic", usize::from(order)),
                            "Amplitude of the piston's acceleration over that of order 1, order",
                            harmonic,
                        );
                    }
                    sheet.verify(|| {
                        let series = engine::harmonic_by_series(ratio, order);
                        sheet.check_zero(
                            "the same amplitude by its series in λ",
                            harmonic - series,
                            ratio.max(harmonic.value().abs()),
                        );
                    });
                    *primary * harmonic
                }
            };
            let why = ("Amplitude of this order of a cylinder", DEN_HARTOG.at("ch. 5"));
            if order == 2 {
                let symbol = (names(order).amplitude, c.row);
                let what =
                    "λ/4, the coefficient of the displacement of the piston, taken for its acceleration";
                sheet.common_error(symbol, what, || *primary * (c.crank / rod) / 4.0);
                if let Terms::Exact = motion {
                    let what = "the two-term series used, the secondary coefficient taken as λ = r/l";
                    sheet.common_error(symbol, what, || *primary * (c.crank / rod));
                }
            }
            *last.insert(sheet.step((names(order).amplitude, c.row), "N", value, why))
        }
    });
    each.collect()
}

/// Sums of the vectors of all cylinders, and what follows of them.
pub(super) fn of_order<W: Worksheet>(
    order: u8,
    cylinders: &[Placed<W::Num>],
    strengths: &[W::Num],
    about: Option<W::Num>,
    angle: Option<W::Num>,
    sheet: W,
) -> Order<W::Num> {
    let scale: f64 = strengths.iter().map(|k| k.value().abs()).sum();
    let n = usize::from(order);
    let names = names(order);
    let amounts: Vec<W::Num> = strengths.to_vec();
    let why = [
        "Forward rotating vector of the forces: each cylinder contributes half its amplitude",
        "Backward rotating vector of the forces",
    ];
    let force = sums(order, cylinders, &amounts, [names.forward, names.backward], "N", why, sheet);
    sheet.common_error(names.most[0], "the amplitudes of all cylinders added as numbers", || {
        W::Num::sum(strengths.iter().map(|strength| strength.abs()))
    });
    let most = sheet.step(
        names.most[0],
        "N",
        force.forward_size + force.backward_size,
        "Maximum where both vectors point in the same direction",
    );
    let least = sheet.step(
        names.most[1],
        "N",
        (force.forward_size - force.backward_size).abs(),
        "Minimum where they point in opposite directions",
    );
    sheet.answer(("force", n), "Maximum force of order", most);
    sheet.answer(("force_min", n), "Minimum force of order", least);
    sheet.answer(("forward", n), "Forward rotating vector of order", force.forward_size);
    sheet.answer(("backward", n), "Backward rotating vector of order", force.backward_size);
    if force.forward_size.value().min(force.backward_size.value()) > 1e-9 * scale {
        let [angle, direction] = directions(n, &force, names.angle, sheet);
        sheet.verify(|| {
            let turned = f64::from(order) * angle.value();
            let [x, y] = checks::sum_at(order, cylinders, strengths, turned);
            let (along, across) = (most * direction.cos(), most * direction.sin());
            let off = (along.value() - x).hypot(across.value() - y);
            let what = "at this crank angle the piston forces add up to the maximum";
            sheet.check_zero(what, off.into(), scale);
        });
    } else {
        let what = "a single rotating vector has the same magnitude at every crank angle";
        sheet.check_sum(what, most, least, 4.0 * scale);
    }
    sheet.verify(|| {
        let pair = checks::semidiameters(order, cylinders, strengths);
        checks::semi_axes(most, least, pair, scale, sheet);
    });
    let couple = about.map(|about| {
        let arms: Vec<W::Num> =
            strengths.iter().zip(cylinders).map(|(k, c)| *k * (c.position - about)).collect();
        let why = ["Forward rotating vector of the couples", "Backward rotating vector of the couples"];
        let names_of = [names.couple_forward, names.couple_backward];
        let couple = sums(order, cylinders, &arms, names_of, "N*m", why, sheet);
        sheet.common_error(names.most[2], "the couples of all cylinders added as numbers", || {
            W::Num::sum(arms.iter().map(|arm| arm.abs()))
        });
        let most = sheet.step(
            names.most[2],
            "N*m",
            couple.forward_size + couple.backward_size,
            "Maximum where both vectors point in the same direction",
        );
        let least = sheet.step(
            names.most[3],
            "N*m",
            (couple.forward_size - couple.backward_size).abs(),
            "Minimum where they point in opposite directions",
        );
        sheet.answer(("couple", n), "Maximum couple of order", most);
        sheet.answer(("couple_min", n), "Minimum couple of order", least);
        sheet.verify(|| {
            let pair = checks::semidiameters(order, cylinders, &arms);
            checks::semi_axes(most, least, pair, arms.iter().map(|k| k.value().abs()).sum(), sheet);
        });
        couple
    });
    if let Some(angle) = angle {
        let [x, y] = at(order, &force, angle);
        let x = sheet.step(names.at[0], "N", x, "Upward force at the crank angle");
        let y = sheet.step(names.at[1], "N", y, "Transverse force at the crank angle");
        let size = sheet.step(names.at[2], "N", balance::magnitude(x, y), "Force at the crank angle");
        sheet.answer(("force_at", n), "Force at the crank angle, order", size);
        sheet.verify(|| {
            let [x, y] = checks::sum_at(order, cylinders, strengths, f64::from(order) * angle.value());
            let what = "force at the crank angle, added up piston by piston";
            sheet.check_sum(what, size, x.hypot(y).into(), scale);
        });
    }
    let origin = about.map_or(0.0, Real::value);
    let reach = cylinders.iter().map(|c| (c.position.value() - origin).abs()).fold(0.0, f64::max);
    Order { number: order, scale, reach, force, couple }
}

/// Components at a crank angle of a vector that turns forward and one that turns backward.
pub(super) fn at<N: Real>(order: u8, pair: &Pair<N>, angle: N) -> [N; 2] {
    let turned = if order == 1 { angle } else { angle * f64::from(order) };
    let (cosine, sine) = (turned.cos(), turned.sin());
    let ([px, py], [qx, qy]) = (pair.forward, pair.backward);
    [(px + qx) * cosine - (py - qy) * sine, (py + qy) * cosine + (px - qx) * sine]
}

fn sums<W: Worksheet>(
    order: u8,
    cylinders: &[Placed<W::Num>],
    amounts: &[W::Num],
    [forward, backward]: [[&'static str; 3]; 2],
    unit: &'static str,
    [why_forward, why_backward]: [&'static str; 2],
    sheet: W,
) -> Pair<W::Num> {
    let upright = cylinders.iter().all(|c| c.upright);
    let sum = |angle: fn(u8, W::Num, W::Num) -> W::Num, of: fn(W::Num) -> W::Num| {
        W::Num::sum(cylinders.iter().zip(amounts).map(|(c, k)| {
            let turned = match (c.upright, order) {
                (true, 1) => c.throw,
                (true, _) => c.throw * f64::from(order),
                (false, _) => angle(order, c.throw, c.line),
            };
            *k * of(turned)
        })) / 2.0
    };
    let size = |[x, y]: [W::Num; 2], symbol, why: &'static str| {
        sheet.step(symbol, unit, balance::magnitude(x, y), why)
    };
    let cite = DEN_HARTOG.at("ch. 5");
    let px = sheet.step(forward[0], unit, sum(engine::forward_angle, W::Num::cos), (why_forward, cite));
    let py = sheet.step(forward[1], unit, sum(engine::forward_angle, W::Num::sin), (why_forward, cite));
    if upright && order > 1 {
        sheet.verify(|| {
            let sum = |of: fn(W::Num) -> W::Num| {
                W::Num::sum(cylinders.iter().zip(amounts).map(|(c, k)| *k * of(c.throw))) / 2.0
            };
            let wrong = balance::magnitude(sum(W::Num::cos), sum(W::Num::sin));
            // What cancels leaves rounding.
            if wrong.value() > 1e-9 * amounts.iter().map(|k| k.value().abs()).sum::<f64>() {
                let what = "the crank angles themselves taken, as for the primary order";
                sheet.common_error(forward[2], what, || wrong);
            }
        });
    }
    let forward_size = size([px, py], forward[2], "Magnitude of the forward vector");
    if upright {
        let why = "All strokes are in one plane: the backward vector is the mirror image of the forward one";
        let backward_size = sheet.step(backward[2], unit, forward_size, why);
        return Pair { forward: [px, py], backward: [px, -py], forward_size, backward_size };
    }
    let qx = sheet.step(backward[0], unit, sum(engine::backward_angle, W::Num::cos), (why_backward, cite));
    let qy = sheet.step(backward[1], unit, -sum(engine::backward_angle, W::Num::sin), (why_backward, cite));
    let backward_size = size([qx, qy], backward[2], "Magnitude of the backward vector");
    Pair { forward: [px, py], backward: [qx, qy], forward_size, backward_size }
}

/// The crank angle at which the force is largest, and its direction.
fn directions<W: Worksheet>(
    n: usize,
    pair: &Pair<W::Num>,
    symbols: [&'static str; 2],
    sheet: W,
) -> [W::Num; 2] {
    let [p, q] = [pair.forward, pair.backward].map(|[x, y]| balance::marked_direction(x, y));
    let half = (q - p) / (2 * n) as f64;
    // Within one period of the order; rounding below zero stays there.
    let period = PI / n as f64;
    let whole = ((half.value() + 1e-9) / period).floor() * period;
    let angle = sheet.step(
        symbols[0],
        "deg",
        match (half.value() - whole, whole) {
            (small, _) if small.abs() < 1e-11 => 0.0.into(),
            (_, 0.0) => half,
            _ => half - whole,
        },
        (
            "Both rotating vectors point in the same direction: first crank angle of maximum force",
            DEN_HARTOG.at("ch. 5"),
        ),
    );
    sheet.answer(("angle", n), "Crank angle of maximum force of order", angle);
    let direction = p + angle * n as f64;
    let direction = match direction.value() {
        small if small.abs() < 1e-11 => 0.0.into(),
        whole if whole > TAU - 1e-9 => direction - TAU,
        below if below < 0.0 => direction + TAU,
        _ => direction,
    };
    let direction =
        sheet.step(symbols[1], "deg", direction, "Direction of the maximum force, from the vertical");
    sheet.answer(("direction", n), "Direction of the maximum force of order", direction);
    [angle, direction]
}

/// The largest force over a turn from the vectors of the orders; in the exact motion, which has more orders than
/// these, from the accelerations of the slider-cranks.
pub(super) fn largest_again<N: Real>(found: &[Order<N>], pistons: &[Piston], motion: PistonMotion) -> f64 {
    let plain = |[x, y]: [N; 2]| [x.value(), y.value()];
    let force = |angle: f64| {
        let mut sum = [0.0; 2];
        if motion == PistonMotion::Exact {
            for piston in pistons {
                let (crank, rod, turned) = (piston.ratio, 1.0, angle + piston.throw - piston.line);
                let swing = slider_crank::rod_angle(crank, rod, 0.0, turned);
                let speed = slider_crank::rod_speed(crank, rod, turned, swing, 1.0);
                let turning = slider_crank::rod_acceleration(crank, rod, turned, swing, 1.0, speed, 0.0);
                let along =
                    slider_crank::slider_acceleration(crank, rod, turned, swing, 1.0, speed, 0.0, turning);
                let along = -piston.amplitude * along / crank;
                sum[0] += along * piston.line.cos();
                sum[1] += along * piston.line.sin();
            }
        } else {
            for order in found {
                let pair = Pair {
                    forward: plain(order.force.forward),
                    backward: plain(order.force.backward),
                    forward_size: order.force.forward_size.value(),
                    backward_size: order.force.backward_size.value(),
                };
                let [x, y] = at(order.number, &pair, angle);
                sum[0] += x;
                sum[1] += y;
            }
        }
        sum
    };
    engine::largest(force).1
}

/// Every order again, as the Fourier integral of the forces of all pistons added up one by one.
pub(super) fn check<W: Worksheet>(
    found: &[Order<W::Num>],
    pistons: &[Piston],
    motion: PistonMotion,
    about: f64,
    sheet: W,
) {
    let points: u32 = if motion == PistonMotion::Exact { 512 } else { 32 };
    let forces: Vec<_> = (0..points)
        .map(|k| TAU * f64::from(k) / f64::from(points))
        .map(|angle| (angle, engine::shaking(pistons, motion, about, angle)))
        .collect();
    let reach = pistons.iter().map(|p| (p.position - about).abs()).fold(0.0, f64::max);
    let scale: f64 = pistons.iter().map(|p| p.amplitude).sum();
    for order in found {
        let h = f64::from(order.number);
        let vector = |sign: f64, couple: bool| {
            let (mut x, mut y) = (0.0, 0.0);
            for (angle, (force, moment)) in &forces {
                let [a, b] = if couple { *moment } else { *force };
                let (sine, cosine) = (sign * h * angle).sin_cos();
                x += a * cosine + b * sine;
                y += b * cosine - a * sine;
            }
            (x / f64::from(points)).hypot(y / f64::from(points))
        };
        let what = "the order by the Fourier integral of the piston forces over a revolution";
        for (sign, size) in [(1.0, order.force.forward_size), (-1.0, order.force.backward_size)] {
            sheet.check_sum(what, size, vector(sign, false).into(), scale);
        }
        if let Some(couple) = &order.couple {
            for (sign, size) in [(1.0, couple.forward_size), (-1.0, couple.backward_size)] {
                sheet.check_sum(what, size, vector(sign, true).into(), scale * reach);
            }
        }
    }
}
