//! Motion program of a cam: its segments, and the motion of the follower at every cam angle.

use std::f64::consts::TAU;

use dalembert_core::{Inputs, MeasuredQuantity, Refusal, Text};
use dalembert_numerics::{differentiation::derivative, extremes, roots};

use super::law::MotionLaw;

/// Motion of the follower over the cam angle.
#[derive(Clone, Debug, Inputs)]
pub enum MotionProgram {
    /// One rise or return
    /// Alone, between two dwells.
    Stroke {
        /// Direction.
        direction: StrokeDirection,
        /// Law of motion.
        law: MotionLaw,
        /// Lift.
        #[input("h", "mm | deg", positive)]
        lift: MeasuredQuantity,
        /// Cam angle of the stroke.
        #[input("β", "deg", positive, max = 360)]
        turn: f64,
    },
    /// Segments of a full revolution
    /// In order; their cam angles make up 360°, and the returns bring the follower down by all rises.
    Revolution {
        /// Segments.
        #[input(min = 2, most = 40)]
        segments: Vec<CamSegment>,
    },
}

/// Direction of a single stroke.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum StrokeDirection {
    /// Rise
    Rise,
    /// Return
    Return,
}

/// Segment of a motion program.
#[derive(Clone, Debug, Inputs)]
pub enum CamSegment {
    /// Rise
    Rise {
        /// Law of motion.
        law: MotionLaw,
        /// Lift.
        #[input("h", "mm | deg", positive)]
        lift: MeasuredQuantity,
        /// Cam angle of the segment.
        #[input("β", "deg", positive, max = 360)]
        turn: f64,
    },
    /// Return
    Return {
        /// Law of motion.
        law: MotionLaw,
        /// Lift.
        /// By which the follower comes down.
        #[input("h", "mm | deg", positive)]
        lift: MeasuredQuantity,
        /// Cam angle of the segment.
        #[input("β", "deg", positive, max = 360)]
        turn: f64,
    },
    /// Dwell
    Dwell {
        /// Cam angle of the segment.
        #[input("β", "deg", positive, max = 360)]
        turn: f64,
    },
}

/// A segment with the place where it begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct SegmentCourse {
    /// Law; none in a dwell.
    pub law: Option<MotionLaw>,
    /// Cam angle where it begins, rad.
    pub from: f64,
    /// Cam angle over which it lasts, rad.
    pub turn: f64,
    /// Lift where it begins.
    pub start: f64,
    /// Change of the lift, negative in a return.
    pub rise: f64,
}

/// Motion of the follower at a cam angle, with its derivatives by that angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    pub angle: f64,
    pub lift: f64,
    pub rate: f64,
    pub second: f64,
    pub third: f64,
}

/// Place of an extreme on the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub value: f64,
    pub motion: Motion,
}

/// All segments, and whether they are a full revolution.
#[derive(Clone, Debug)]
pub(super) struct Course {
    pub segments: Vec<SegmentCourse>,
    pub closed: bool,
    /// True where the lift is an angle.
    pub turning: bool,
}

impl SegmentCourse {
    /// Motion at the fraction `x` of the segment, by one piece of its law.
    pub(super) fn at(&self, x: f64, piece: usize) -> Motion {
        let [y, rate, second, third] = self.law.map_or([0.0; 4], |law| law.at(x, piece));
        let b = self.turn;
        Motion {
            angle: self.from + x * b,
            lift: self.start + self.rise * y,
            rate: self.rise * rate / b,
            second: self.rise * second / (b * b),
            third: self.rise * third / (b * b * b),
        }
    }

    fn breaks(&self) -> &'static [f64] {
        self.law.map_or(&[0.0, 1.0], MotionLaw::breaks)
    }
}

impl CamSegment {
    fn parts(&self) -> (Option<MotionLaw>, f64, Option<MeasuredQuantity>, f64) {
        match self {
            CamSegment::Rise { law, lift, turn } => (Some(*law), 1.0, Some(*lift), *turn),
            CamSegment::Return { law, lift, turn } => (Some(*law), -1.0, Some(*lift), *turn),
            CamSegment::Dwell { turn } => (None, 0.0, None, *turn),
        }
    }
}

impl MotionProgram {
    /// The course of the lift, refused where a revolution does not close.
    pub(super) fn course(&self) -> Result<Course, Refusal> {
        let segments = match self {
            MotionProgram::Stroke { direction, law, lift, turn } => {
                let (low, rise) = match direction {
                    StrokeDirection::Rise => (0.0, lift.si),
                    StrokeDirection::Return => (lift.si, -lift.si),
                };
                let only = SegmentCourse { law: Some(*law), from: 0.0, turn: *turn, start: low, rise };
                return Ok(Course { segments: vec![only], closed: false, turning: lift.unit == "deg" });
            }
            MotionProgram::Revolution { segments } => segments,
        };
        let mut courses = Vec::new();
        let (mut from, mut low, mut largest, mut turning) = (0.0, 0.0, 0.0f64, false);
        for (n, segment) in (1..).zip(segments) {
            let (law, sign, lift, turn) = segment.parts();
            let rise = lift.map_or(0.0, |lift| sign * lift.si);
            turning |= lift.is_some_and(|lift| lift.unit == "deg");
            courses.push(SegmentCourse { law, from, turn, start: low, rise });
            from += turn;
            low += rise;
            largest = largest.max(low);
            if low < -1e-9 * rise.abs() {
                return Err(Refusal::because(
                    Text::new("segment {n} brings the follower below its lowest position: begin with the rises, or write a smaller lift")
                        .with("n", n),
                ));
            }
        }
        if (from - TAU).abs() > 1e-6 {
            return Err(Refusal::because(
                Text::new("the cam angles of the segments make up {sum}, and must make up 360°: mend an angle or add a dwell")
                    .with_quantity("sum", from, "deg"),
            ));
        }
        if largest == 0.0 {
            return Err(Refusal::because("all segments are dwells: write a rise and a return"));
        }
        if low.abs() > 1e-6 * largest {
            return Err(Refusal::because(
                Text::new("the follower ends {rest} above its beginning: the returns must bring it down by all rises")
                    .with_quantity("rest", low, if turning { "deg" } else { "mm" }),
            ));
        }
        Ok(Course { segments: courses, closed: true, turning })
    }
}

impl Course {
    /// The segment and the fraction of it at a cam angle; none outside of a single stroke.
    pub(super) fn place(&self, angle: f64) -> Option<(usize, f64)> {
        let last = self.segments.len() - 1;
        let (angle, whole) =
            if self.closed { (angle.rem_euclid(TAU), TAU) } else { (angle, self.segments[0].turn) };
        if angle < -1e-12 * whole || angle > whole * (1.0 + 1e-12) {
            return None;
        }
        let after = |segment: &SegmentCourse| segment.from <= angle + 1e-12 * whole;
        let k = self.segments.iter().rposition(after).unwrap_or(0);
        // Rounding at the end of the last one.
        let (k, gone) = if self.closed && k == last && TAU - angle < 1e-12 * TAU {
            (0, 0.0)
        } else {
            (k, angle - self.segments[k].from)
        };
        Some((k, (gone / self.segments[k].turn).clamp(0.0, 1.0)))
    }

    /// Motion at a cam angle.
    pub(super) fn at(&self, angle: f64) -> Option<Motion> {
        let (k, x) = self.place(angle)?;
        let segment = &self.segments[k];
        Some(segment.at(x, segment.law.map_or(0, |law| law.piece(x))))
    }

    /// Largest value of a number over some of the segments, each piece by its own formula up to both of its ends.
    pub(super) fn largest(
        &self,
        parts: u16,
        chosen: impl Fn(&SegmentCourse) -> bool,
        number: impl Fn(&Motion) -> f64,
    ) -> Option<Found> {
        let mut best: Option<Found> = None;
        for segment in self.segments.iter().filter(|segment| chosen(segment)) {
            for (piece, ends) in segment.breaks().windows(2).enumerate() {
                let place = |n: u16| ends[0] + (ends[1] - ends[0]) * f64::from(n) / f64::from(parts);
                let places: Vec<f64> = (0..=parts).map(place).collect();
                let Some(top) = extremes::largest(|x| number(&segment.at(x, piece)), &places) else {
                    continue;
                };
                // What rounding alone tells apart is not higher.
                let beyond = best.is_none_or(|best| top.value > best.value + 1e-12 * best.value.abs());
                if beyond && top.value.is_finite() {
                    let x = sharpened(|x| number(&segment.at(x, piece)), top.time, [ends[0], ends[1]]);
                    best = Some(Found { value: top.value, motion: segment.at(x, piece) });
                }
            }
        }
        best
    }

    /// Cam angles at which a derivative jumps, with the dwells before and after a single stroke.
    pub(super) fn jumps(&self, of: impl Fn(&Motion) -> f64) -> Vec<f64> {
        let all = |_: &SegmentCourse| true;
        let scale = self.largest(16, all, |motion| of(motion).abs()).map_or(0.0, |found| found.value);
        let mut places = Vec::new();
        // Values at both ends of every piece, in order.
        let ends: Vec<(f64, f64, f64)> = self
            .segments
            .iter()
            .flat_map(|segment| {
                segment.breaks().windows(2).enumerate().map(|(piece, ends)| {
                    let [first, last] = [ends[0], ends[1]].map(|x| segment.at(x, piece));
                    (first.angle, of(&first), of(&last))
                })
            })
            .collect();
        let before = if self.closed { ends.last().map_or(0.0, |end| end.2) } else { 0.0 };
        let mut earlier = before;
        for (angle, first, last) in &ends {
            if (first - earlier).abs() > 1e-9 * scale {
                places.push(*angle);
            }
            earlier = *last;
        }
        if !self.closed && earlier.abs() > 1e-9 * scale {
            places.push(self.segments[0].turn);
        }
        places
    }

    /// Angles of a plot, dense, with both sides of every end of a piece.
    pub(super) fn motions(&self) -> Vec<Motion> {
        const PARTS: u16 = 40;
        let piece = |segment: &SegmentCourse, piece: usize, ends: [f64; 2]| -> Vec<Motion> {
            let width = ends[1] - ends[0];
            let parts = if segment.law.is_none() { 8 } else { PARTS };
            (0..=parts)
                .map(|n| {
                    // The end itself is the beginning of the next one.
                    let share = (f64::from(n) / f64::from(parts)).min(1.0 - 1e-9);
                    segment.at(ends[0] + width * share, piece)
                })
                .collect()
        };
        self.segments
            .iter()
            .flat_map(|segment| {
                let pieces = segment.breaks().windows(2).enumerate();
                pieces.flat_map(|(n, ends)| piece(segment, n, [ends[0], ends[1]])).collect::<Vec<_>>()
            })
            .collect()
    }
}

/// Place of a maximum, as the zero of the derivative about it: its value alone tells it to half of the digits only.
fn sharpened(number: impl Fn(f64) -> f64, x: f64, [from, to]: [f64; 2]) -> f64 {
    const REACH: f64 = 1e-4;
    let slope = |x: f64| derivative(&number, x, 0.004);
    let ends = [x - REACH, x + REACH];
    if ends[0] <= from || ends[1] >= to {
        return x;
    }
    roots::crossing(&ends.map(|x| (x, slope(x))), slope).unwrap_or(x)
}
