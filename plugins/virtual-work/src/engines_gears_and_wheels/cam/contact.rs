//! Contact of cam and follower: pressure angle, curvature and profile at a cam angle, and their extremes.

use dalembert_core::{Text, Worksheet, trace::Symbol};
use dalembert_mechanics::Real;
use dalembert_numerics::differentiation::derivative;

use super::{
    follower::{Outline, Tangent},
    motion::{Position, Units},
    program::{Course, Found, Motion, SegmentCourse},
};
use crate::sources::{NORTON, SHIGLEY};

/// Works out pressure angle, curvature and profile at a position.
pub(super) fn at<W: Worksheet>(
    position: &Position<W::Num>,
    outline: &Outline<W::Num>,
    course: &Course,
    sheet: W,
) -> Option<W::Num> {
    let numbers = outline.numbers();
    let place = course.place(position.angle.value());
    let pressure = match outline.tangent(position.lift, position.rate, position.second) {
        None => {
            let Outline::Flat { base } = *outline else { return None };
            let why =
                ("Radius of curvature of the profile under a flat face: ρ = R_b + s + s″", NORTON.at("§8.6"));
            let radius = sheet.step("ρ", "mm", base + position.lift + position.second, why);
            sheet.answer("profile_curvature", "Radius of curvature of the profile", radius);
            let why = "Distance of the contact from the line of the follower: ds/dθ";
            let aside = sheet.step("q", "mm", position.rate, why);
            sheet.answer("contact_distance", "Distance of the contact from the axis", aside);
            sheet.verify(|| {
                let Some((k, x)) = place else { return };
                let segment = &course.segments[k];
                let piece = segment.law.map_or(0, |law| law.piece(x));
                let support = base.value() + position.lift.value();
                let step = if segment.law.is_some() { 0.004 } else { 0.0 };
                let slope = |number: fn(&Motion) -> f64| match step {
                    0.0 => 0.0,
                    _ => derivative(|x| number(&segment.at(x, piece)), x, step) / segment.turn,
                };
                let what = "the contact lies where the face turns about it: by differences of the lift";
                let size = support;
                sheet.check_sum(what, aside, slope(|motion| motion.lift).into(), size);
                let what = "radius of curvature: speed of the contact along the face, by differences";
                let along = support + slope(|motion| motion.rate);
                sheet.check_sum(what, radius, along.into(), size);
            });
            None
        }
        Some(tangent) => {
            let tangent = legs(outline, &tangent, "t", sheet);
            let (a, b) = (tangent.a, tangent.b);
            let why = (
                "Pressure angle: between the normal of the pitch curve and the motion of the follower, tan φ = b/a",
                NORTON.at("§8.6"),
            );
            let pressure = sheet.step("φ", "deg", b.atan2(a), why);
            sheet.answer("pressure_angle", "Pressure angle", pressure);
            let denominator = tangent.denominator();
            let straight = denominator.value().abs() <= 1e-9 * tangent.length().value().powi(2);
            let radius = (!straight).then(|| {
                let why = (formula(outline), SHIGLEY.at("ch. 5"));
                let tangent = turning(&tangent, "t", sheet);
                if let Outline::Translating { offset, reach, .. } = *outline {
                    let height = || position.lift + reach;
                    sheet.common_error(
                        "ρ",
                        "the distance of the trace point from the cam centre taken",
                        || (height().powi(2) + offset.powi(2)).sqrt(),
                    );
                    let flat = || height() + position.second;
                    sheet.common_error("ρ", "the formula of a flat face used", flat);
                }
                let radius = sheet.step("ρ", "mm", tangent.length().powi(3) / tangent.denominator(), why);
                sheet.answer("pitch_curvature", "Radius of curvature of the pitch curve", radius);
                if let Some(roller) = outline.roller() {
                    let why =
                        "Radius of curvature of the profile, within that of the pitch curve by the roller";
                    let profile = sheet.step("ρ_c", "mm", radius - roller, why);
                    sheet.answer("profile_curvature", "Radius of curvature of the profile", profile);
                    sheet.check(
                        "radius of the profile and of the roller: that of the pitch curve",
                        profile + roller,
                        radius,
                    );
                }
                radius
            });
            sheet.verify(|| {
                let Some((k, x)) = place else { return };
                check_curve((k, x), (pressure, radius), &numbers, course, sheet);
            });
            Some(pressure)
        }
    };
    profile(position, outline, pressure, course, sheet);
    pressure
}

/// The two legs of the tangent as steps.
fn legs<W: Worksheet>(
    outline: &Outline<W::Num>,
    tangent: &Tangent<W::Num>,
    of: &'static str,
    sheet: W,
) -> Tangent<W::Num> {
    let words = match outline {
        Outline::Oscillating { .. } => [
            "Tangent of the pitch curve per radian of the cam, across the motion of the roller: c sin ψ",
            "The same along the motion of the roller: l (1 ± ψ′) − c cos ψ",
        ],
        _ => [
            "Tangent of the pitch curve per radian of the cam, across the motion of the follower: s + d",
            "The same along the motion of the follower: s′ − e",
        ],
    };
    let a = sheet.step(Symbol { of, ..Symbol::from("a") }, "mm", tangent.a, words[0]);
    let b = sheet.step(Symbol { of, ..Symbol::from("b") }, "mm", tangent.b, words[1]);
    Tangent { a, b, ..*tangent }
}

/// The derivatives of both legs as steps.
fn turning<W: Worksheet>(tangent: &Tangent<W::Num>, of: &'static str, sheet: W) -> Tangent<W::Num> {
    let [across, along] = tangent.second;
    let why = "Derivative of the tangent by θ, across the motion of the follower";
    let across = sheet.step(Symbol { of, ..Symbol::from("a′") }, "mm", across, why);
    let along = sheet.step(Symbol { of, ..Symbol::from("b′") }, "mm", along, "The same along the motion");
    Tangent { second: [across, along], ..*tangent }
}

fn formula<N>(outline: &Outline<N>) -> &'static str {
    match outline {
        Outline::Oscillating { .. } => {
            "Radius of curvature of the pitch curve, (a² + b²)^(3/2)/(b a′ − a b′)"
        }
        _ => {
            "Radius of curvature of the pitch curve, (a² + b²)^(3/2)/(b a′ − a b′): without offset ((R_p + s)² + s′²)^(3/2)/((R_p + s)² + 2s′² − (R_p + s) s″)"
        }
    }
}

/// Trace point in the axes of the cam at a fraction of a segment.
fn trace(outline: &Outline<f64>, segment: &SegmentCourse, x: f64, piece: usize) -> [f64; 2] {
    let motion = segment.at(x, piece);
    outline.tangent_at(&motion).map_or([f64::NAN; 2], |tangent| outline.on_cam(tangent.point, motion.angle))
}

/// Holds pressure angle and curvature to differences of the pitch curve.
fn check_curve<W: Worksheet>(
    (k, x): (usize, f64),
    (pressure, radius): (W::Num, Option<W::Num>),
    outline: &Outline<f64>,
    course: &Course,
    sheet: W,
) {
    let segment = &course.segments[k];
    let piece = segment.law.map_or(0, |law| law.piece(x));
    let step = 0.004 / segment.turn.max(1.0);
    let slope = |x: f64| {
        let part = |n: usize| derivative(|x| trace(outline, segment, x, piece)[n], x, step) / segment.turn;
        [part(0), part(1)]
    };
    let motion = segment.at(x, piece);
    let Some(tangent) = outline.tangent_at(&motion) else { return };
    // Direction of the follower in the axes of the cam.
    let [ux, uy] = tangent.across;
    let along = outline.on_cam([-uy, ux], motion.angle);
    let across = outline.on_cam([ux, uy], motion.angle);
    let [dx, dy] = slope(x);
    let sign = outline.sign();
    let (a, b) = (sign * (dx * across[0] + dy * across[1]), sign * (dx * along[0] + dy * along[1]));
    let what = "pressure angle by differences of the pitch curve";
    sheet.check_sum(what, pressure, b.atan2(a).into(), 1.0);
    if let Some(radius) = radius {
        // The tangent turns by its derivative: curvature is that angle over the length.
        let turned = |x: f64| {
            let motion = segment.at(x, piece);
            outline.tangent_at(&motion).map_or([0.0; 2], |tangent| {
                let [x, y] = tangent.across;
                let at = [tangent.a * x - tangent.b * y, tangent.a * y + tangent.b * x];
                outline.on_cam(at, motion.angle)
            })
        };
        let part = |n: usize| derivative(|x| turned(x)[n], x, step) / segment.turn;
        let ([tx, ty], [sx, sy]) = (turned(x), [part(0), part(1)]);
        let again = tx.hypot(ty).powi(3) / (sign * (ty * sx - tx * sy));
        let what = "radius of curvature by differences of the tangent of the pitch curve";
        let length = tx.hypot(ty);
        // Where the curve is nearly straight, rounding is that of its curvature.
        let scale = radius.value().abs().max(1e-3 * radius.value().powi(2) / length);
        sheet.check_sum(what, radius, again.into(), scale);
    }
}

/// Answers the point of the profile in the axes of the cam. `pressure` is the pressure angle, of a follower that has a
/// trace point.
fn profile<W: Worksheet>(
    position: &Position<W::Num>,
    outline: &Outline<W::Num>,
    pressure: Option<W::Num>,
    course: &Course,
    sheet: W,
) {
    let [x, y] = match (*outline, pressure) {
        (Outline::Translating { offset, reach, roller, .. }, Some(pressure)) => {
            let height = position.lift + reach;
            match roller {
                Some(roller) => [offset + roller * pressure.sin(), height - roller * pressure.cos()],
                None => [offset, height],
            }
        }
        (Outline::Oscillating { pivot, arm, start, roller, .. }, Some(pressure)) => {
            let angle =
                sheet.step("ψ", "deg", start + position.lift, "Angle of the arm to the line of centres");
            let normal = angle - pressure;
            [pivot - arm * angle.cos() - roller * normal.sin(), arm * angle.sin() - roller * normal.cos()]
        }
        _ => outline.contact(position.lift, position.rate, position.second),
    };
    let why = match outline {
        Outline::Flat { .. } => "Contact from the cam centre, across the line of the follower: ds/dθ",
        _ => {
            "Contact from the cam centre, in the axes of the frame: trace point less the roller along the normal"
        }
    };
    let x = sheet.step("x_f", "mm", x, why);
    let y = sheet.step("y_f", "mm", y, "The same along the second axis");
    let angle = position.angle;
    let (sin, cos) = (angle.sin() * outline.sign(), angle.cos());
    let why = (
        "Point of the profile in the axes of the cam, which lie along those of the frame at θ = 0",
        SHIGLEY.at("ch. 5"),
    );
    let on_x = sheet.step("x_c", "mm", x * cos + y * sin, why);
    let on_y = sheet.step("y_c", "mm", y * cos - x * sin, "The same along its second axis");
    sheet.answer("profile_x", "Point of the profile, x", on_x);
    sheet.answer("profile_y", "Point of the profile, y", on_y);
    sheet.verify(|| {
        let numbers = outline.numbers();
        let Some((k, at)) = course.place(position.angle.value()) else { return };
        let segment = &course.segments[k];
        let piece = segment.law.map_or(0, |law| law.piece(at));
        let step = 0.004 / segment.turn.max(1.0);
        if let Outline::Flat { base } = numbers {
            // Distance of the face from the point, and how it changes as the cam turns.
            let face = on_x * angle.sin() + on_y * angle.cos();
            let support = base + segment.at(at, piece).lift;
            sheet.check_sum("the point lies on the face", face, support.into(), support);
            let turning = derivative(|x| segment.at(x, piece).lift, at, step) / segment.turn;
            let what = "envelope: the point does not leave the face as the cam turns";
            sheet.check_sum(what, on_x * angle.cos() - on_y * angle.sin(), turning.into(), support);
            return;
        }
        // Envelope of the rollers: off the pitch curve by the radius, along its normal by differences.
        let [px, py] = trace(&numbers, segment, at, piece);
        let part = |n: usize| derivative(|x| trace(&numbers, segment, x, piece)[n], at, step) / segment.turn;
        let (sx, sy) = (part(0), part(1));
        let reach = numbers.roller().unwrap_or(0.0) * numbers.sign() / sx.hypot(sy);
        let size = px.hypot(py);
        let what = "envelope of the roller by differences of the pitch curve: first axis";
        sheet.check_sum(what, on_x, (px + reach * sy).into(), size);
        let what = "envelope of the roller by differences of the pitch curve: second axis";
        sheet.check_sum(what, on_y, (py - reach * sx).into(), size);
    });
}

/// Motion at an extreme, as found numbers.
fn spot<W: Worksheet>(
    found: &Found,
    of: &'static str,
    words: &'static str,
    (course, is_curved): (&Course, bool),
    sheet: W,
) -> Position<W::Num> {
    let units = Units::of(course);
    let symbol = |base: &'static str| Symbol { of, ..Symbol::from(base) };
    let motion = &found.motion;
    let angle = sheet.numerical(symbol("θ"), "deg", motion.angle, words);
    let lift = sheet.numerical(symbol("s"), units.lift, motion.lift, "Lift there");
    let rate = sheet.numerical(symbol("s′"), units.per_radian[0], motion.rate, "ds/dθ there");
    let second = if is_curved {
        sheet.numerical(symbol("s″"), units.per_radian[1], motion.second, "d²s/dθ² there")
    } else {
        // No formula has it.
        W::Num::from(0.0)
    };
    Position { angle, lift, rate, second }
}

/// Extremes over the program.
pub(super) fn extremes<W: Worksheet>(outline: &Outline<W::Num>, course: &Course, sheet: W) -> Option<Found> {
    if let Outline::Flat { base } = *outline {
        flat(base, course, sheet);
        return None;
    }
    let numbers = outline.numbers();
    let mut steepest: Option<Found> = None;
    for (rising, of, name, place, label, place_label, words) in [
        (
            true,
            "u",
            "rise_pressure_angle",
            "rise_pressure_cam_angle",
            "Maximum pressure angle on the rise",
            "Cam angle of the maximum pressure angle on the rise",
            "Cam angle of the largest pressure angle on a rise, by search",
        ),
        (
            false,
            "r",
            "return_pressure_angle",
            "return_pressure_cam_angle",
            "Maximum pressure angle on the return",
            "Cam angle of the maximum pressure angle on the return",
            "Cam angle of the largest pressure angle on a return, by search",
        ),
    ] {
        let chosen = |segment: &SegmentCourse| if rising { segment.rise > 0.0 } else { segment.rise < 0.0 };
        let number = |motion: &Motion| numbers.pressure(motion).abs();
        let Some(found) = course.largest(48, chosen, number) else { continue };
        let there = spot(&found, of, words, (course, false), sheet);
        let Some(tangent) = outline.tangent(there.lift, there.rate, there.second) else { continue };
        let why = ("Pressure angle there, from the same two legs", NORTON.at("§8.6"));
        let symbol = Symbol { of, ..Symbol::from("φ") };
        let halfway = || {
            let strokes = course.segments.iter().filter(|segment| chosen(segment));
            let motions = strokes.filter_map(|segment| course.at(segment.from + segment.turn / 2.0));
            let angles = motions.map(|motion| numbers.pressure(&motion).abs());
            W::Num::from(angles.fold(f64::NAN, f64::max))
        };
        sheet.common_error(symbol, "the pressure angle in the middle of the stroke taken", halfway);
        let pressure = sheet.step(symbol, "deg", tangent.b.abs().atan2(tangent.a), why);
        sheet.answer(name, label, pressure);
        sheet.answer(place, place_label, there.angle);
        sheet.verify(|| {
            if let Some(again) = course.largest(301, chosen, number) {
                sheet.check("largest pressure angle of a fine search", pressure, again.value.into());
                check_place("its cam angle by that search", there.angle, &again, course, number, sheet);
            }
        });
        if steepest.is_none_or(|most| found.value > most.value) {
            steepest = Some(found);
        }
    }
    curvature(outline, course, sheet);
    steepest
}

/// Holds the place of an extreme to that of another search; where another place is as good, to its value alone.
fn check_place<W: Worksheet>(
    what: &'static str,
    angle: W::Num,
    again: &Found,
    course: &Course,
    number: impl Fn(&Motion) -> f64,
    sheet: W,
) {
    let other = again.motion.angle;
    let is_same = (angle.value() - other).abs() < 1e-5;
    let place = if is_same {
        other
    } else {
        // An equal one elsewhere.
        let equal = course
            .at(angle.value())
            .is_some_and(|motion| (number(&motion) - again.value).abs() <= 1e-9 * again.value.abs());
        if equal { angle.value() } else { other }
    };
    sheet.check_residual(what, angle - place, 1.0, 1e-9);
}

/// Least radius of curvature of pitch curve and profile.
fn curvature<W: Worksheet>(outline: &Outline<W::Num>, course: &Course, sheet: W) {
    let numbers = outline.numbers();
    let number = |motion: &Motion| numbers.curvature(motion);
    let Some(found) = course.largest(48, |_| true, number).filter(|found| found.value > 0.0) else {
        return;
    };
    let words = "Cam angle of the least radius of curvature of the convex pitch curve, by search";
    let there = spot(&found, "ρ", words, (course, true), sheet);
    let Some(tangent) = outline.tangent(there.lift, there.rate, there.second) else { return };
    let tangent = turning(&legs(outline, &tangent, "ρ", sheet), "ρ", sheet);
    let why = ("Least radius of curvature of the pitch curve, by the same formula", NORTON.at("§8.6"));
    let symbol = Symbol { of: "min", ..Symbol::from("ρ") };
    let radius = sheet.step(symbol, "mm", tangent.length().powi(3) / tangent.denominator(), why);
    sheet.answer("least_pitch_curvature", "Least radius of curvature, pitch curve", radius);
    sheet.answer("least_curvature_cam_angle", "Cam angle of least radius of curvature", there.angle);
    if let Some(roller) = outline.roller() {
        let why = "Least radius of curvature of the convex profile";
        let symbol = Symbol { of: "c,min", ..Symbol::from("ρ") };
        let least = sheet.step(symbol, "mm", radius - roller, why);
        sheet.answer("least_profile_curvature", "Least radius of curvature, profile", least);
        sheet.check("that of the profile and the radius of the roller", least + roller, radius);
        if least.value() <= 0.0 {
            sheet.warn(|| {
                Text::new("the profile is undercut at the cam angle {angle}: the radius of curvature of the pitch curve there, {radius}, is not above that of the roller; use a larger base circle or a smaller roller")
                    .with_quantity("angle", there.angle.value(), "deg")
                    .with_quantity("radius", radius.value(), "mm")
            });
        }
    }
    sheet.verify(|| {
        if let Some(again) = course.largest(301, |_| true, number) {
            let what = "largest curvature of a fine search: its inverse";
            sheet.check(what, radius, (1.0 / again.value).into());
            check_place("its cam angle by that search", there.angle, &again, course, number, sheet);
        }
    });
}

/// Extremes of a cam with a flat face.
fn flat<W: Worksheet>(base: W::Num, course: &Course, sheet: W) {
    let number = |motion: &Motion| -(motion.lift + motion.second);
    if let Some(found) = course.largest(48, |_| true, number) {
        let words = "Cam angle at which s + s″ is least, by search";
        let there = spot(&found, "ρ", words, (course, true), sheet);
        let symbol = Symbol { of: "min", ..Symbol::from("ρ") };
        let why = ("Least radius of curvature of the profile: ρ = R_b + s + s″", NORTON.at("§8.6"));
        let radius = sheet.step(symbol, "mm", base + there.lift + there.second, why);
        sheet.answer("least_profile_curvature", "Least radius of curvature, profile", radius);
        sheet.answer("least_curvature_cam_angle", "Cam angle of least radius of curvature", there.angle);
        let symbol = Symbol { of: "b,0", ..Symbol::from("R") };
        let why = "Base circle radius at which the profile has a cusp: it must be larger";
        let least = sheet.step(symbol, "mm", -(there.lift + there.second), why);
        sheet.answer("least_base_radius", "Base circle radius of a cusp", least);
        if radius.value() <= 0.0 {
            sheet.warn(|| {
                Text::new("the profile is undercut at the cam angle {angle}, where R_b + s + s″ is {radius}: a flat face needs a base circle radius above {least}")
                    .with_quantity("angle", there.angle.value(), "deg")
                    .with_quantity("radius", radius.value(), "mm")
                    .with_quantity("least", least.value(), "mm")
            });
        }
        sheet.verify(|| {
            if let Some(again) = course.largest(301, |_| true, number) {
                let size = base.value();
                let what = "least radius of curvature of a fine search";
                sheet.check_sum(what, radius, (size - again.value).into(), size);
                let what = "base circle radius of a cusp by a fine search";
                sheet.check_sum(what, least, again.value.into(), size);
                check_place("its cam angle by that search", there.angle, &again, course, number, sheet);
            }
        });
    }
    let side = |sign: f64| {
        course.largest(48, |_| true, move |motion| sign * motion.rate).map_or(0.0, |found| sign * found.value)
    };
    let (ahead, behind) = (side(1.0).max(0.0), side(-1.0).min(0.0));
    let ahead = sheet.numerical("q₁", "mm", ahead, "Largest ds/dθ: the contact moves out by it on the rise");
    let behind =
        sheet.numerical("q₂", "mm", behind, "Least ds/dθ: the contact moves out by it on the return");
    let why = ("Least width of the face, from the one to the other", NORTON.at("§8.6"));
    let width = sheet.step("w", "mm", ahead - behind, why);
    sheet.answer("rise_contact_distance", "Contact from the axis, rise", ahead);
    sheet.answer("return_contact_distance", "Contact from the axis, return", behind);
    sheet.answer("face_width", "Least width of the face", width);
    sheet.verify(|| {
        let peak = |rising: bool| {
            let of = course.segments.iter().filter(|segment| (segment.rise > 0.0) == rising);
            of.filter_map(|segment| Some(segment.law?.peaks().velocity * segment.rise.abs() / segment.turn))
                .fold(0.0, f64::max)
        };
        let (up, down) = (peak(true), peak(false));
        sheet.check_sum("that distance from the constants of the laws, rise", ahead, up.into(), up + down);
        sheet.check_sum(
            "that distance from the constants of the laws, return",
            behind,
            (-down).into(),
            up + down,
        );
        sheet.check("width from the constants of the laws", width, (up + down).into());
    });
}
