//! The motion of the piston, worked.

use dalembert_core::{Reason, Refusal, Worksheet};
use dalembert_mechanics::{
    Real,
    balance::reciprocating::{PistonMotion, harmonic_by_series, inertia_force},
    slider_crank::{
        CrankMotion,
        piston::{self, harmonics, two_term},
    },
};
use dalembert_numerics::{differentiation::derivative, gauss_legendre, roots};

use super::{
    Engine, EngineGiven, EngineMotion, EngineMotionGiven, RodLengthGiven, Terms, ThrowGiven, too_short,
};
use crate::sources::KHURMI;

/// Lengths of the engine.
pub(super) struct Lengths<N> {
    pub crank: N,
    pub rod: N,
    /// `l/r`.
    pub ratio: N,
    /// Offset, if it is not zero.
    pub offset: Option<N>,
}

/// The motion at the crank angle.
pub(super) struct PistonState<N> {
    pub angle: N,
    /// Speed, if the engine runs.
    pub speed: Option<N>,
    /// Angular acceleration of the crank, where it is not zero.
    pub turning: Option<N>,
    pub obliquity: N,
    pub displacement: N,
    /// Way of the piston for the angle of the crank.
    pub arm: N,
    /// Turn of the rod for that of the crank; where the engine runs.
    pub turn: Option<N>,
    /// Of the piston, towards the crank; none where it stands.
    pub acceleration: Option<N>,
    pub rod_acceleration: Option<N>,
    pub velocity: Option<N>,
    pub rod_speed: Option<N>,
}

impl<N: Real> PistonState<N> {
    pub(super) fn crank(&self) -> CrankMotion {
        CrankMotion {
            angle: self.angle.value(),
            speed: self.speed.map_or(0.0, Real::value),
            acceleration: self.turning.map_or(0.0, Real::value),
        }
    }
}

pub(super) fn lengths<W: Worksheet>(
    problem: &Engine,
    given: &EngineGiven<W>,
    sheet: W,
) -> Result<Lengths<W::Num>, Refusal> {
    let crank = match &given.throw {
        ThrowGiven::Radius { radius } => *radius,
        ThrowGiven::Stroke { stroke } => {
            if problem.offset != 0.0 {
                return Err(Refusal::because(
                    "with an offset the stroke is not twice the crank radius: give the crank radius",
                ));
            }
            sheet.step("r", "mm", *stroke / 2.0, "The crank is half the stroke")
        }
    };
    let (rod, ratio) = match &given.rod {
        RodLengthGiven::Length { length } => {
            (*length, sheet.step("n", "1", *length / crank, "Ratio of rod and crank"))
        }
        RodLengthGiven::Ratio { ratio } => {
            (sheet.step("l", "mm", *ratio * crank, "Length of the rod"), *ratio)
        }
    };
    let least = 1.01 * (crank.value() + problem.offset.abs());
    if rod.value() < least {
        return Err(too_short(rod.value(), least));
    }
    let offset = (problem.offset != 0.0).then_some(given.offset);
    Ok(Lengths { crank, rod, ratio, offset })
}

pub(super) fn motion<W: Worksheet>(
    problem: &Engine,
    given: &EngineGiven<W>,
    lengths: &Lengths<W::Num>,
    sheet: W,
) -> PistonState<W::Num> {
    let &Lengths { crank, rod, ratio, offset } = lengths;
    let angle = given.angle;
    let obliquity = sheet.step(
        "φ",
        "deg",
        match offset {
            None => piston::obliquity(ratio, angle),
            Some(offset) => piston::obliquity_with_offset(crank, rod, offset, angle),
        },
        ("Obliquity of the rod: crank pin and gudgeon pin are at the ends of both", KHURMI.at("ch. 15")),
    );
    sheet.answer("rod_angle", "Obliquity of the rod", obliquity);
    let amplitudes = amplitudes(problem, ratio, sheet);
    let displacement = displacement(problem, lengths, [angle, obliquity], &amplitudes, sheet);
    sheet.common_error("h", "the obliquity of the rod neglected, the arm r sin θ used", || {
        crank * angle.sin()
    });
    let arm = sheet.step(
        "h",
        "mm",
        piston::arm(crank, angle, obliquity),
        "Virtual displacement of the piston for that of the crank, δs = h δθ: the arm of the effort along the stroke",
    );
    sheet.answer("arm", "Arm of the piston effort about the crankshaft", arm);
    let mut moving = PistonState {
        angle,
        speed: None,
        turning: None,
        obliquity,
        displacement,
        arm,
        turn: None,
        acceleration: None,
        rod_acceleration: None,
        velocity: None,
        rod_speed: None,
    };
    match (&problem.motion, &given.motion) {
        (
            EngineMotion::Running { acceleration: alpha, .. },
            EngineMotionGiven::Running { speed, acceleration },
        ) => {
            moving.speed = Some(*speed);
            moving.turning = (*alpha != 0.0).then_some(*acceleration);
            running(problem, lengths, &amplitudes, &mut moving, *speed, sheet);
        }
        (_, EngineMotionGiven::PistonAcceleration { acceleration }) => {
            moving.acceleration = Some(*acceleration);
        }
        _ => {}
    }
    moving
}

fn displacement<W: Worksheet>(
    problem: &Engine,
    lengths: &Lengths<W::Num>,
    [angle, obliquity]: [W::Num; 2],
    amplitudes: &[W::Num],
    sheet: W,
) -> W::Num {
    let &Lengths { crank, rod, ratio, offset } = lengths;
    let position = sheet.step(
        "x",
        "mm",
        piston::position(crank, rod, angle, obliquity),
        "Distance of the gudgeon pin from the crankshaft, along the stroke",
    );
    sheet.answer("position", "Distance of the gudgeon pin from the crankshaft", position);
    let across = crank * angle.sin();
    let across = offset.map_or(across, |offset| across - offset);
    sheet.verify(|| {
        let along = position - crank * angle.cos();
        let what = "the rod spans from the crank pin to the gudgeon pin";
        sheet.check(what, along.powi(2) + across.powi(2), rod.powi(2));
    });
    let value = match (&problem.terms, offset) {
        (Terms::Exact, None) => piston::displacement(crank, ratio, angle, obliquity),
        (Terms::Exact, Some(offset)) => piston::farthest(crank, rod, offset) - position,
        (Terms::Two, _) => two_term::displacement(crank, ratio, angle),
        (Terms::Harmonics { .. }, _) => harmonics::displacement(crank, amplitudes, angle),
    };
    let why = "Displacement of the piston from the dead centre farthest from the crankshaft";
    let displacement = sheet.step("s", "mm", value, (why, KHURMI.at("ch. 15")));
    sheet.answer("displacement", "Displacement of the piston", displacement);
    sheet.verify(|| {
        let size = crank.value() + rod.value();
        if let Terms::Exact = problem.terms {
            let far = (crank + rod).powi(2);
            let far = offset.map_or(far, |offset| far - offset.powi(2)).sqrt();
            let here = crank * angle.cos() + (rod.powi(2) - across.powi(2)).sqrt();
            let what =
                "displacement from the distances of the gudgeon pin with crank and rod collinear and at this angle";
            sheet.check_sum(what, displacement, far - here, size);
            return;
        }
        let (r, n) = (crank.value(), ratio.value());
        let plain: Vec<f64> = amplitudes.iter().map(|a| a.value()).collect();
        let way = angle.value().sin().atan2(angle.value().cos());
        let slope = |angle: f64| match problem.terms {
            Terms::Two => two_term::velocity(r, n, angle, 1.0),
            _ => harmonics::velocity(r, &plain, angle, 1.0),
        };
        let gone = way * gauss_legendre::integral(24, |part| slope(part * way));
        sheet.check_sum("displacement as the integral of the velocity", displacement, gone.into(), size);
    });
    displacement
}

/// Amplitudes of the even orders, where harmonics are asked for.
fn amplitudes<W: Worksheet>(problem: &Engine, ratio: W::Num, sheet: W) -> Vec<W::Num> {
    let Terms::Harmonics { highest } = problem.terms else { return Vec::new() };
    let lambda = 1.0 / ratio.value();
    let even = (1..=highest / 2).map(|half| {
        let order = u8::try_from(2 * half).unwrap_or(u8::MAX);
        let series = harmonic_by_series(lambda, order);
        let how = "Amplitude of this order of the acceleration over r ω², by its series in 1/n";
        let amplitude = sheet.numerical(("A", usize::from(order)), "1", series, how);
        sheet.verify(|| {
            const POINTS: u32 = 512;
            let turn = std::f64::consts::TAU;
            let integral: f64 = (0..POINTS)
                .map(|k| turn * f64::from(k) / f64::from(POINTS))
                .map(|angle| {
                    let force = inertia_force(PistonMotion::Exact, lambda, angle);
                    force * (f64::from(order) * angle).cos()
                })
                .sum();
            let residual = amplitude.value() - 2.0 * integral / f64::from(POINTS);
            let what = "the same amplitude by its Fourier integral over one revolution";
            sheet.check_zero(what, residual.into(), 1.0);
        });
        amplitude
    });
    even.collect()
}

fn running<W: Worksheet>(
    problem: &Engine,
    lengths: &Lengths<W::Num>,
    amplitudes: &[W::Num],
    moving: &mut PistonState<W::Num>,
    speed: W::Num,
    sheet: W,
) {
    let &Lengths { crank, rod, ratio, .. } = lengths;
    let &mut PistonState { angle, obliquity, arm, turning, .. } = moving;
    let turn = sheet.step(
        "φ′",
        "1",
        piston::turn(crank, rod, angle, obliquity),
        "Virtual rotation of the rod for that of the crank, δφ = φ′ δθ",
    );
    let velocity = match problem.terms {
        Terms::Exact => arm * speed,
        Terms::Two => two_term::velocity(crank, ratio, angle, speed),
        Terms::Harmonics { .. } => harmonics::velocity(crank, amplitudes, angle, speed),
    };
    let velocity =
        sheet.step("v", "m/s", velocity, ("Velocity of the piston, towards the crank", KHURMI.at("ch. 15")));
    let rod_speed = match problem.terms {
        Terms::Two => two_term::rod_speed(ratio, angle, speed),
        _ => turn * speed,
    };
    let rod_speed = sheet.step("ω_r", "rad/s", rod_speed, "Angular velocity of the rod");
    let rod_acceleration = match problem.terms {
        Terms::Two => two_term::rod_acceleration(ratio, angle, speed, turning),
        _ => piston::rod_acceleration([crank, rod], [angle, obliquity], [speed, rod_speed], turning),
    };
    let rod_acceleration = sheet.step(
        "α_r",
        "rad/s^2",
        rod_acceleration,
        ("Angular acceleration of the rod, positive for increasing obliquity", KHURMI.at("ch. 15")),
    );
    let acceleration = match problem.terms {
        Terms::Exact => piston::acceleration(
            [crank, rod],
            [angle, obliquity],
            [speed, rod_speed],
            rod_acceleration,
            turning,
        ),
        Terms::Two => two_term::acceleration(crank, ratio, angle, speed, turning),
        Terms::Harmonics { .. } => harmonics::acceleration(crank, amplitudes, angle, speed, turning),
    };
    sheet.common_error("a", "the normal acceleration r ω² of the crank pin used", || crank * speed.powi(2));
    if !matches!(problem.terms, Terms::Two) {
        let harmonic = || crank * speed.powi(2) * angle.cos();
        sheet.common_error("a", "the obliquity of the rod neglected, r ω² cos θ used", harmonic);
    }
    let acceleration = sheet.step(
        "a",
        "m/s^2",
        acceleration,
        ("Acceleration of the piston, towards the crank", KHURMI.at("ch. 15")),
    );
    sheet.answer("velocity", "Velocity of the piston", velocity);
    sheet.answer("acceleration", "Acceleration of the piston", acceleration);
    sheet.answer("rod_speed", "Angular velocity of the rod", rod_speed);
    sheet.answer("rod_acceleration", "Angular acceleration of the rod", rod_acceleration);
    zero_acceleration(problem, lengths, amplitudes, speed, sheet);
    moving.turn = Some(turn);
    moving.velocity = Some(velocity);
    moving.rod_speed = Some(rod_speed);
    moving.acceleration = Some(acceleration);
    moving.rod_acceleration = Some(rod_acceleration);
}

/// The crank angle below 180° at which the piston has no acceleration at a steady speed.
fn zero_acceleration<W: Worksheet>(
    problem: &Engine,
    lengths: &Lengths<W::Num>,
    amplitudes: &[W::Num],
    speed: W::Num,
    sheet: W,
) {
    let &Lengths { crank, rod, ratio, offset } = lengths;
    let (r, l, e) = (crank.value(), rod.value(), offset.map_or(0.0, Real::value));
    let exact = |angle: f64| {
        let obliquity = piston::obliquity_with_offset(r, l, e, angle);
        let speed = piston::turn(r, l, angle, obliquity);
        let both = ([r, l], [angle, obliquity], [1.0, speed]);
        let swing = piston::rod_acceleration(both.0, both.1, both.2, None);
        piston::acceleration(both.0, both.1, both.2, swing, None)
    };
    let plain: Vec<f64> = amplitudes.iter().map(|a| a.value()).collect();
    let why = "Crank angle, with the piston moving towards the crank, at which its acceleration is zero and its velocity maximum";
    let found = |acceleration: &dyn Fn(f64) -> f64| {
        let keep_on = |_| std::ops::ControlFlow::Continue(());
        let angle = roots::find(acceleration, [0.0, std::f64::consts::PI], keep_on).ok()?;
        Some(sheet.numerical("θ₀", "deg", angle, Reason::from((why, KHURMI.at("ch. 15")))))
    };
    sheet.common_error("θ₀", "crank and rod taken as perpendicular at the maximum velocity", || {
        ratio.atan2(1.0.into())
    });
    let angle = match problem.terms {
        Terms::Two => {
            let cosine = two_term::zero_acceleration(ratio);
            Some(sheet.step("θ₀", "deg", cosine, (why, KHURMI.at("ch. 15"))))
        }
        Terms::Exact => found(&exact),
        Terms::Harmonics { .. } => found(&|angle| harmonics::acceleration(r, &plain, angle, 1.0, None)),
    };
    let Some(angle) = angle else { return };
    sheet.answer("zero_acceleration_angle", "Crank angle at zero piston acceleration", angle);
    greatest_velocity(problem, lengths, amplitudes, [angle, speed], sheet);
    sheet.verify(|| match problem.terms {
        Terms::Two => {
            let residual = ratio * angle.cos() + (angle * 2.0).cos();
            sheet.check_zero("n cos θ₀ + cos 2θ₀ = 0", residual, ratio.value());
        }
        Terms::Exact if offset.is_none() => {
            let square = angle.sin().powi(2);
            let residual = square.powi(3) - ratio.powi(2) * square.powi(2)
                + ratio.powi(4) * (W::Num::from(1.0) - square);
            let what = "sin⁶θ₀ − n² sin⁴θ₀ − n⁴ sin²θ₀ + n⁴ = 0 at the angle of zero acceleration";
            sheet.check_zero(what, residual, ratio.value().powi(4));
        }
        Terms::Exact => {
            let mechanism = dalembert_mechanics::slider_crank::SliderCrank {
                crank: r,
                rod: l,
                offset: e,
                branch: dalembert_mechanics::slider_crank::Branch::Ahead,
            };
            let at = CrankMotion { angle: angle.value(), speed: 1.0, acceleration: 0.0 };
            if let Ok(motion) = mechanism.motion(at) {
                let what = "zero acceleration there from the loop closure of the slider-crank";
                sheet.check_zero(what, motion.slider_acceleration.into(), r);
            }
        }
        Terms::Harmonics { .. } => {
            let orders = amplitudes.iter().zip((1u32..).map(|half| f64::from(2 * half)));
            let higher: f64 = orders.map(|(a, k)| a.value() * (k * angle.value()).cos()).sum();
            let residual = angle.cos() + higher;
            sheet.check_zero("the harmonics cancel at the angle of zero acceleration", residual, 1.0);
        }
    });
}

/// The velocity of the piston at the crank angle at which its acceleration is zero.
fn greatest_velocity<W: Worksheet>(
    problem: &Engine,
    lengths: &Lengths<W::Num>,
    amplitudes: &[W::Num],
    [angle, speed]: [W::Num; 2],
    sheet: W,
) {
    let &Lengths { crank, rod, ratio, offset } = lengths;
    let velocity = match problem.terms {
        Terms::Exact => {
            let obliquity = match offset {
                None => piston::obliquity(ratio, angle),
                Some(offset) => piston::obliquity_with_offset(crank, rod, offset, angle),
            };
            let obliquity = sheet.step("φ₀", "deg", obliquity, "Obliquity of the rod there");
            piston::arm(crank, angle, obliquity) * speed
        }
        Terms::Two => two_term::velocity(crank, ratio, angle, speed),
        Terms::Harmonics { .. } => harmonics::velocity(crank, amplitudes, angle, speed),
    };
    sheet.common_error("v_max", "the speed r ω of the crank pin taken", || crank * speed);
    let velocity =
        sheet.step("v_max", "m/s", velocity, "Maximum velocity of the piston, at that crank angle");
    sheet.answer("greatest_velocity", "Maximum velocity of the piston", velocity);
    sheet.verify(|| {
        let (r, l, e) = (crank.value(), rod.value(), offset.map_or(0.0, Real::value));
        let plain: Vec<f64> = amplitudes.iter().map(|a| a.value()).collect();
        let gone = |angle: f64| match problem.terms {
            Terms::Exact => {
                let obliquity = piston::obliquity_with_offset(r, l, e, angle);
                piston::farthest(r, l, e) - piston::position(r, l, angle, obliquity)
            }
            Terms::Two => two_term::displacement(r, l / r, angle),
            Terms::Harmonics { .. } => harmonics::displacement(r, &plain, angle),
        };
        let slope = derivative(gone, angle.value(), 2e-3);
        let what = "maximum velocity as the slope of the displacement at that crank angle";
        sheet.check_sum(what, velocity, (speed.value() * slope).into(), speed.value() * (r + l));
    });
}
