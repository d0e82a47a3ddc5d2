//! Motion of the follower at a cam angle, and the extremes of every stroke.

use std::f64::consts::TAU;

use dalembert_core::{Cell, Column, Refusal, TableExhibit, Text, Worksheet, trace::Symbol};
use dalembert_mechanics::Real;
use dalembert_numerics::{differentiation::derivative, quadrature};

use super::{
    law::MotionLaw,
    program::{CamSegmentGiven, Course, Motion, MotionProgramGiven, SegmentCourse},
};
use crate::sources::NORTON;

/// Units of the lift and its derivatives, of a length or of an angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    pub lift: &'static str,
    /// Of the derivatives by the cam angle.
    pub per_radian: [&'static str; 3],
    /// Of velocity, acceleration and jerk.
    pub per_second: [&'static str; 3],
}

impl Units {
    pub(super) fn of(course: &Course) -> Self {
        if course.turning {
            Self { lift: "deg", per_radian: ["1"; 3], per_second: ["rad/s", "rad/s^2", "rad/s^3"] }
        } else {
            Self { lift: "mm", per_radian: ["mm"; 3], per_second: ["m/s", "m/s^2", "m/s^3"] }
        }
    }
}

/// Size of a segment as numbers of a worksheet.
pub(super) struct SegmentSize<N> {
    /// None in a dwell.
    pub lift: Option<N>,
    pub turn: N,
}

/// Motion at a cam angle as numbers of a worksheet.
#[derive(Clone, Copy)]
pub(super) struct Position<N> {
    pub angle: N,
    pub lift: N,
    pub rate: N,
    pub second: N,
}

/// Sizes of all segments.
pub(super) fn sizes<W: Worksheet>(program: &MotionProgramGiven<W>) -> Vec<SegmentSize<W::Num>> {
    match program {
        MotionProgramGiven::Stroke { lift, turn, .. } => {
            vec![SegmentSize { lift: Some(*lift), turn: *turn }]
        }
        MotionProgramGiven::Revolution { segments } => segments
            .iter()
            .map(|segment| match segment {
                CamSegmentGiven::Rise { lift, turn, .. } | CamSegmentGiven::Return { lift, turn, .. } => {
                    SegmentSize { lift: Some(*lift), turn: *turn }
                }
                CamSegmentGiven::Dwell { turn } => SegmentSize { lift: None, turn: *turn },
            })
            .collect(),
    }
}

/// Works out the motion at a cam angle; refused outside of a single stroke.
pub(super) fn at<W: Worksheet>(
    angle: W::Num,
    speed: Option<W::Num>,
    course: &Course,
    sizes: &[SegmentSize<W::Num>],
    sheet: W,
) -> Result<Position<W::Num>, Refusal> {
    let units = Units::of(course);
    let Some((k, x)) = course.place(angle.value()) else {
        return Err(Refusal::because(
            Text::new("the cam angle is not within the stroke: write one from 0 to {turn}").with_quantity(
                "turn",
                course.segments[0].turn,
                "deg",
            ),
        ));
    };
    let segment = &course.segments[k];
    let turns = if course.closed { (angle.value() / TAU + 1e-12).floor() } else { 0.0 };
    let reduced = if turns == 0.0 {
        angle
    } else {
        sheet.step("θ_r", "deg", angle - turns * TAU, "Cam angle within the revolution")
    };
    let signed = |n: usize| {
        let lift = sizes[n].lift?;
        Some(if course.segments[n].rise < 0.0 { -lift } else { lift })
    };
    let before: Vec<W::Num> = (0..k).filter_map(signed).collect();
    let low = if !course.closed && segment.rise < 0.0 {
        sizes[0].lift
    } else if before.is_empty() {
        None
    } else if let [only] = before.as_slice() {
        Some(*only)
    } else {
        Some(sheet.step("s_1", units.lift, W::Num::sum(before), "Lift at which the segment begins"))
    };
    let (Some(law), Some(rise)) = (segment.law, signed(k)) else {
        let why = "The follower dwells at this lift";
        let lift = match low {
            Some(low) => sheet.step("s", units.lift, low, why),
            None => sheet.numerical("s", units.lift, 0.0, why),
        };
        let still = |symbol: &'static str, unit: &'static str| {
            sheet.numerical(symbol, unit, 0.0, "The follower is at rest in a dwell")
        };
        let [first, second, third] = units.per_radian;
        let [rate, second, third] = [still("s′", first), still("s″", second), still("s‴", third)];
        sheet.answer("lift", "Lift", lift);
        sheet.answer("lift_rate", "Velocity per radian of the cam", rate);
        sheet.answer("lift_second", "Acceleration per radian of the cam squared", second);
        sheet.answer("lift_third", "Jerk per radian of the cam cubed", third);
        if speed.is_some() {
            let [first, second, third] = units.per_second;
            sheet.answer("velocity", "Velocity of the follower", still("v", first));
            sheet.answer("acceleration", "Acceleration of the follower", still("a", second));
            sheet.answer("jerk", "Jerk of the follower", still("j", third));
        }
        sheet.verify(|| {
            let (sum, size) = course.segments[..k].iter().fold((0.0, 0.0f64), |(sum, size), segment| {
                (sum + segment.rise, size.max(segment.rise.abs()))
            });
            sheet.check_sum("lift from all strokes before", lift, sum.into(), size);
        });
        return Ok(Position { angle, lift, rate, second });
    };
    let begun = (k > 0).then(|| {
        let turns = sizes[..k].iter().map(|size| size.turn);
        sheet.step("θ_1", "deg", W::Num::sum(turns), "Cam angle at which the segment begins")
    });
    let gone = begun.map_or(reduced, |begun| reduced - begun);
    let turn = sizes[k].turn;
    sheet.common_error("x", "the cam angle divided by the whole revolution", || gone / TAU);
    let share = sheet.step("x", "1", gone / turn, "Part of the cam angle of the segment");
    let piece = law.piece(x);
    let [y, rate, second, third] = law.at(share, piece);
    let y = sheet.step("y", "1", y, (law.formula(piece), NORTON.at("§8.3")));
    let rate = sheet.step("y′", "1", rate, "Its first derivative by x");
    let second = sheet.step("y″", "1", second, "Its second derivative by x");
    let third = sheet.step("y‴", "1", third, "Its third derivative by x");
    let part = rise * y;
    let lift = sheet.step("s", units.lift, low.map_or(part, |low| low + part), "Lift");
    let [first_unit, second_unit, third_unit] = units.per_radian;
    let rate = sheet.step("s′", first_unit, rise * rate / turn, "Velocity per radian of the cam, ds/dθ");
    let second = sheet.step(
        "s″",
        second_unit,
        rise * second / turn.powi(2),
        "Acceleration per radian of the cam squared, d²s/dθ²",
    );
    let third = sheet.step(
        "s‴",
        third_unit,
        rise * third / turn.powi(3),
        "Jerk per radian of the cam cubed, d³s/dθ³",
    );
    sheet.answer("lift", "Lift", lift);
    sheet.answer("lift_rate", "Velocity per radian of the cam", rate);
    sheet.answer("lift_second", "Acceleration per radian of the cam squared", second);
    sheet.answer("lift_third", "Jerk per radian of the cam cubed", third);
    if let Some(speed) = speed {
        let [first_unit, second_unit, third_unit] = units.per_second;
        let velocity = sheet.step("v", first_unit, speed * rate, "Velocity of the follower");
        let acceleration =
            sheet.step("a", second_unit, speed.powi(2) * second, "Acceleration of the follower");
        let jerk = sheet.step("j", third_unit, speed.powi(3) * third, "Jerk of the follower");
        sheet.answer("velocity", "Velocity of the follower", velocity);
        sheet.answer("acceleration", "Acceleration of the follower", acceleration);
        sheet.answer("jerk", "Jerk of the follower", jerk);
        sheet.verify(|| {
            let w = speed.value();
            // By differences over time.
            let moved = |order: usize, time: f64| {
                let motion = segment.at(x + w * time / segment.turn, piece);
                [motion.lift, w * motion.rate, w * w * motion.second][order]
            };
            let step = STEP * segment.turn / w;
            let slopes = [0, 1, 2].map(|order| derivative(|time| moved(order, time), 0.0, step));
            let scales = scales(segment).map(|scale| scale * segment.rise.abs() / segment.turn);
            let [first, second, third] = [0, 1, 2]
                .map(|order| scales[order] * w * (w / segment.turn).powi(i32::try_from(order).unwrap_or(0)));
            sheet.check_sum(
                "velocity by differences of the lift over time",
                velocity,
                slopes[0].into(),
                first,
            );
            let what = "acceleration by differences of the velocity over time";
            sheet.check_sum(what, acceleration, slopes[1].into(), second);
            let what = "jerk by differences of the acceleration over time";
            sheet.check_sum(what, jerk, slopes[2].into(), third);
        });
    }
    sheet.verify(|| {
        let size = segment.rise.abs().max(segment.start);
        let swept = swept(segment, law, x);
        sheet.check_sum("lift as the integral of the velocity", lift, (segment.start + swept).into(), size);
        let [first, other, last] = scales(segment);
        let (h, b) = (segment.rise.abs(), segment.turn);
        let of = |number: fn(&Motion) -> f64| {
            derivative(|x| number(&segment.at(x, piece)), x, STEP) / segment.turn
        };
        let what = "velocity per radian by differences of the lift";
        sheet.check_sum(what, rate, of(|motion| motion.lift).into(), first * h / b);
        let what = "acceleration per radian squared by differences of the velocity";
        sheet.check_sum(what, second, of(|motion| motion.rate).into(), other * h / b.powi(2));
        let what = "jerk per radian cubed by differences of the acceleration";
        sheet.check_sum(what, third, of(|motion| motion.second).into(), last * h / b.powi(3));
    });
    Ok(Position { angle, lift, rate, second })
}

/// Step of differences over the fraction of a segment.
const STEP: f64 = 0.004;

/// Largest sizes of the derivatives of a law.
fn scales(segment: &SegmentCourse) -> [f64; 3] {
    let peaks = segment.law.map_or_else(|| MotionLaw::Uniform.peaks(), MotionLaw::peaks);
    // Where there is none, what rounding is of.
    let most = peaks.acceleration.max(-peaks.deceleration).max(1.0);
    [peaks.velocity, most, peaks.jerk.unwrap_or(most).max(1.0)]
}

/// Lift from the beginning of a segment, by quadrature of its velocity over every piece.
fn swept(segment: &SegmentCourse, law: MotionLaw, x: f64) -> f64 {
    law.breaks()
        .windows(2)
        .enumerate()
        .filter(|(_, ends)| ends[0] < x)
        .map(|(piece, ends)| {
            let rate = |x: f64| segment.at(x, piece).rate * segment.turn;
            quadrature::integral(rate, [ends[0], ends[1].min(x)], 24)
        })
        .sum()
}

/// Extremes of one stroke.
struct StrokePeaks<N> {
    velocity: N,
    acceleration: Option<N>,
    jerk: Option<N>,
}

/// Works out the maximum velocity, acceleration and jerk of all strokes, and answers those of rises and returns.
pub(super) fn peaks<W: Worksheet>(
    speed: Option<W::Num>,
    course: &Course,
    sizes: &[SegmentSize<W::Num>],
    sheet: W,
) {
    let units = Units::of(course);
    let units = if speed.is_some() { units.per_second } else { units.per_radian };
    let mut strokes = Vec::new();
    for (k, (segment, size)) in course.segments.iter().zip(sizes).enumerate() {
        if let (Some(law), Some(lift)) = (segment.law, size.lift) {
            let peaks = stroke(law, (lift, size.turn), speed, (k, segment, course), units, sheet);
            strokes.push((segment.rise > 0.0, peaks));
        }
    }
    let labels = if speed.is_some() {
        [
            (
                "rise_velocity",
                "Maximum velocity on the rise",
                "return_velocity",
                "Maximum velocity on the return",
            ),
            (
                "rise_acceleration",
                "Maximum acceleration on the rise",
                "return_acceleration",
                "Maximum acceleration on the return",
            ),
            ("rise_jerk", "Maximum jerk on the rise", "return_jerk", "Maximum jerk on the return"),
        ]
    } else {
        [
            (
                "rise_rate",
                "Maximum velocity per radian, rise",
                "return_rate",
                "Maximum velocity per radian, return",
            ),
            (
                "rise_second",
                "Maximum acceleration per radian², rise",
                "return_second",
                "Maximum acceleration per radian², return",
            ),
            (
                "rise_third",
                "Maximum jerk per radian³, rise",
                "return_third",
                "Maximum jerk per radian³, return",
            ),
        ]
    };
    for rising in [true, false] {
        let of = |number: &dyn Fn(&StrokePeaks<W::Num>) -> Option<W::Num>| {
            let all = strokes.iter().filter(|(rises, _)| *rises == rising);
            all.filter_map(|(_, peaks)| number(peaks))
                .reduce(|best, next| if next.value() > best.value() { next } else { best })
        };
        // A jerk that is infinite on one of the strokes has no maximum.
        let finite =
            strokes.iter().filter(|(rises, _)| *rises == rising).all(|(_, peaks)| peaks.jerk.is_some());
        let numbers = [
            of(&|peaks| Some(peaks.velocity)),
            of(&|peaks| peaks.acceleration),
            of(&|peaks| peaks.jerk).filter(|_| finite),
        ];
        for ((rise, rise_label, fall, fall_label), number) in labels.into_iter().zip(numbers) {
            if let Some(number) = number {
                let (name, label) = if rising { (rise, rise_label) } else { (fall, fall_label) };
                sheet.answer(name, label, number);
            }
        }
    }
}

/// Extremes of one stroke, by the constants of its law.
fn stroke<W: Worksheet>(
    law: MotionLaw,
    (lift, turn): (W::Num, W::Num),
    speed: Option<W::Num>,
    (k, segment, course): (usize, &SegmentCourse, &Course),
    units: [&'static str; 3],
    sheet: W,
) -> StrokePeaks<W::Num> {
    let peaks = law.peaks();
    let many = course.segments.len() > 1;
    let symbol = |base: &'static str, of: &'static str| -> Symbol {
        let symbol = Symbol { of, ..Symbol::from(base) };
        if many { symbol.row(k + 1) } else { symbol }
    };
    let formulas = law.constants();
    let constant = |of: &'static str, value: f64, words: &'static str, formula: &'static str| {
        let words = Text::new(words).with("formula", formula);
        sheet.numerical(symbol("C", of), "1", value, (words, NORTON.at("§8.3")))
    };
    let reason = |one: &'static str, several: &'static str| {
        if many { Text::new(several).with("n", k + 1) } else { Text::new(one) }
    };
    let (bases, rate) = match speed {
        Some(speed) => (["v", "a", "j"], speed / turn),
        None => (["s′", "s″", "s‴"], W::Num::from(1.0) / turn),
    };
    let factor = constant("v", peaks.velocity, "Constant of the velocity of the law, {formula}", formulas[0]);
    let why = reason("Maximum velocity", "Maximum velocity in segment {n}");
    let velocity = sheet.step(symbol(bases[0], "max"), units[0], factor * lift * rate, why);
    let most = peaks.acceleration.max(-peaks.deceleration);
    let acceleration = (most > 0.0).then(|| {
        let factor = constant("a", most, "Constant of the acceleration of the law, {formula}", formulas[1]);
        let why = reason("Maximum acceleration", "Maximum acceleration in segment {n}");
        sheet.step(symbol(bases[1], "max"), units[1], factor * lift * rate.powi(2), why)
    });
    let jerk = peaks.jerk.filter(|jerk| *jerk > 0.0).map(|jerk| {
        let factor = constant("j", jerk, "Constant of the jerk of the law, {formula}", formulas[2]);
        let why = reason("Maximum jerk", "Maximum jerk in segment {n}");
        sheet.step(symbol(bases[2], "max"), units[2], factor * lift * rate.powi(3), why)
    });
    sheet.verify(|| {
        let same = |other: &SegmentCourse| other.from == segment.from;
        let w = speed.map_or(1.0, Real::value);
        let searched = |number: fn(&Motion) -> f64| {
            course.largest(60, same, |motion| number(motion).abs()).map_or(0.0, |found| found.value)
        };
        let what = "maximum velocity of a search over the stroke";
        sheet.check(what, velocity, (searched(|motion| motion.rate) * w).into());
        if let Some(acceleration) = acceleration {
            let what = "maximum acceleration of a search over the stroke";
            sheet.check(what, acceleration, (searched(|motion| motion.second) * w * w).into());
        }
        if let Some(jerk) = jerk {
            let what = "maximum jerk of a search over the stroke";
            sheet.check(what, jerk, (searched(|motion| motion.third) * w.powi(3)).into());
        }
    });
    StrokePeaks { velocity, acceleration, jerk }
}

/// Answers the cam angles at which velocity or acceleration jumps, and warns of them.
pub(super) fn jumps<W: Worksheet>(course: &Course, sheet: W) {
    let velocity = course.jumps(|motion| motion.rate);
    let acceleration = course.jumps(|motion| motion.second);
    if let Some(first) = velocity.first() {
        sheet.answer_list("velocity_jumps", "Cam angles of velocity jumps", "deg", &velocity);
        sheet.warn(|| {
            Text::new(
                "the velocity jumps, first at the cam angle {angle}: the acceleration is infinite there",
            )
            .with_quantity("angle", *first, "deg")
        });
    }
    if let Some(first) = acceleration.first() {
        sheet.answer_list("acceleration_jumps", "Cam angles of acceleration jumps", "deg", &acceleration);
        sheet.warn(|| {
            Text::new("the acceleration jumps, first at the cam angle {angle}: the jerk is infinite there")
                .with_quantity("angle", *first, "deg")
        });
    }
}

/// Segments with their extremes.
pub(super) fn table(course: &Course, speed: Option<f64>) -> TableExhibit {
    let units = Units::of(course);
    let (w, [first, second, third]) = match speed {
        Some(speed) => (speed, units.per_second),
        None => (1.0, units.per_radian),
    };
    let column = |heading: &'static str, unit: &'static str| Column { heading: heading.into(), unit };
    let row = |segment: &SegmentCourse| -> Vec<Cell> {
        let ends = [segment.from, segment.from + segment.turn, segment.start, segment.start + segment.rise];
        let mut cells: Vec<Cell> = ends.map(Cell::Number).into();
        let numbers = segment.law.map(|law| {
            let peaks = law.peaks();
            let rate = w / segment.turn;
            let h = segment.rise.abs();
            let most = peaks.acceleration.max(-peaks.deceleration);
            [
                Some(h * peaks.velocity * rate),
                Some(h * most * rate * rate),
                peaks.jerk.map(|jerk| h * jerk * rate.powi(3)),
            ]
        });
        let filled = numbers.unwrap_or([Some(0.0); 3]);
        cells.extend(filled.map(|number| number.map_or(Cell::Empty, Cell::Number)));
        cells
    };
    TableExhibit {
        title: "Segments of the motion program".into(),
        columns: vec![
            column("From", "deg"),
            column("To", "deg"),
            column("Lift at the start", units.lift),
            column("Lift at the end", units.lift),
            column("Maximum velocity", first),
            column("Maximum acceleration", second),
            column("Maximum jerk", third),
        ],
        rows: course.segments.iter().map(row).collect(),
        foot: Vec::new(),
    }
}
