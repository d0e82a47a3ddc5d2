//! Followers of a cam: their sizes, and the frame of the contact at any lift.

use std::f64::consts::PI;

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::Real;

use super::program::{Course, Motion};
use crate::sources::{NORTON, SHIGLEY};

/// Follower of the cam.
#[derive(Clone, Debug, Inputs)]
pub enum CamFollower {
    /// Motion alone
    /// No contact and no profile.
    Motion,
    /// Translating, knife edge
    KnifeEdge {
        /// Size of the cam.
        size: CamSize,
        /// Offset of the follower.
        /// Distance of its line from the centre of the cam; positive on the side on which the cam moves along with a rise.
        #[input("e", "mm", default = "0 mm")]
        offset: f64,
    },
    /// Translating, roller
    Roller {
        /// Size of the cam.
        size: CamSize,
        /// Radius of the roller.
        #[input("R_r", "mm", positive)]
        roller: f64,
        /// Offset of the follower.
        /// Distance of its line from the centre of the cam; positive on the side on which the cam moves along with a rise.
        #[input("e", "mm", default = "0 mm")]
        offset: f64,
    },
    /// Translating, flat face
    /// Perpendicular to its motion.
    FlatFaced {
        /// Size of the cam.
        size: FlatCamSize,
    },
    /// Oscillating, roller on an arm
    Oscillating {
        /// Distance of the pivot from the cam centre.
        #[input("c", "mm", positive)]
        pivot: f64,
        /// Length of the arm.
        /// From the pivot to the centre of the roller.
        #[input("l", "mm", positive)]
        arm: f64,
        /// Size of the cam.
        size: CamRadius,
        /// Radius of the roller.
        #[input("R_r", "mm", positive)]
        roller: f64,
        /// Motion of the cam at the roller.
        sense: CamSense,
    },
}

/// Radius from which a cam is laid out.
#[derive(Clone, Debug, Inputs)]
pub enum CamRadius {
    /// Base circle
    Base {
        /// Base circle radius.
        /// Least radius of the profile.
        #[input("R_b", "mm", positive)]
        base: f64,
    },
    /// Prime circle
    Prime {
        /// Prime circle radius.
        /// Distance of the centre of the roller, or of the knife edge, at the lowest position.
        #[input("R_p", "mm", positive)]
        prime: f64,
    },
}

/// Size of a cam with a translating roller or knife edge.
#[derive(Clone, Debug, Inputs)]
pub enum CamSize {
    /// A radius that is given
    #[input(flatten)]
    Radius(CamRadius),
    /// Smallest for a pressure angle
    PressureAngle {
        /// Allowable pressure angle.
        /// On rises and returns.
        #[input("φ_a", "deg", positive, below = 90)]
        allowable: f64,
    },
}

/// Size of a cam with a flat-faced follower.
#[derive(Clone, Debug, Inputs)]
pub enum FlatCamSize {
    /// Base circle
    Base {
        /// Base circle radius.
        #[input("R_b", "mm", positive)]
        base: f64,
    },
    /// Smallest for a radius of curvature
    Curvature {
        /// Least radius of curvature of the profile.
        #[input("ρ_a", "mm", nonnegative)]
        least: f64,
    },
}

/// Sense of the cam's surface at the roller of an oscillating follower.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum CamSense {
    /// Away from the pivot
    Away,
    /// Towards the pivot
    Towards,
}

/// Geometry of the contact, in the axes of the frame about the centre of the cam.
#[derive(Clone, Copy, Debug)]
pub(super) enum Outline<N> {
    Translating { prime: N, offset: N, reach: N, roller: Option<N> },
    Flat { base: N },
    Oscillating { pivot: N, arm: N, start: N, roller: N, sign: f64 },
}

/// Tangent of the path of the trace point over the turning cam, across (`a`) and along (`b`) the motion of the follower,
/// and its derivative by the cam angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tangent<N> {
    pub a: N,
    pub b: N,
    pub second: [N; 2],
    /// Trace point.
    pub point: [N; 2],
    /// Unit vector across the motion.
    pub across: [N; 2],
}

impl<N: Real> Outline<N> {
    pub(super) fn numbers(&self) -> Outline<f64> {
        match *self {
            Outline::Translating { prime, offset, reach, roller } => Outline::Translating {
                prime: prime.value(),
                offset: offset.value(),
                reach: reach.value(),
                roller: roller.map(N::value),
            },
            Outline::Flat { base } => Outline::Flat { base: base.value() },
            Outline::Oscillating { pivot, arm, start, roller, sign } => Outline::Oscillating {
                pivot: pivot.value(),
                arm: arm.value(),
                start: start.value(),
                roller: roller.value(),
                sign,
            },
        }
    }

    /// Radius of the roller; none of a knife edge.
    pub(super) fn roller(&self) -> Option<N> {
        match *self {
            Outline::Translating { roller, .. } => roller,
            Outline::Flat { .. } => None,
            Outline::Oscillating { roller, .. } => Some(roller),
        }
    }

    /// Sense of the cam: 1 counter-clockwise.
    pub(super) fn sign(&self) -> f64 {
        if let Outline::Oscillating { sign, .. } = *self { sign } else { 1.0 }
    }

    /// Tangent of the pitch curve, by derivatives of the lift. R. L. Norton, *Design of Machinery*, §8.6; J. J. Uicker, G. R.
    /// Pennock, J. E. Shigley, *Theory of Machines and Mechanisms*, ch. 5. None of a flat face, which has no trace point.
    pub(super) fn tangent(&self, lift: N, rate: N, second: N) -> Option<Tangent<N>> {
        match *self {
            Outline::Translating { offset, reach, .. } => {
                let height = lift + reach;
                Some(Tangent {
                    a: height,
                    b: rate - offset,
                    second: [rate * 2.0 - offset, second - height],
                    point: [offset, height],
                    across: [N::from(1.0), N::from(0.0)],
                })
            }
            Outline::Flat { .. } => None,
            Outline::Oscillating { pivot, arm, start, sign, .. } => {
                let angle = start + lift;
                let (sin, cos) = (angle.sin(), angle.cos());
                let rate = rate * sign;
                let turned = arm * (rate + 1.0);
                let (a, b) = (pivot * sin, turned - pivot * cos);
                Some(Tangent {
                    a,
                    b,
                    second: [b + turned * rate, arm * second - a],
                    point: [pivot - arm * cos, arm * sin],
                    across: [cos, -sin],
                })
            }
        }
    }

    /// Point of contact, in the axes of the frame.
    pub(super) fn contact(&self, lift: N, rate: N, second: N) -> [N; 2] {
        let Some(tangent) = self.tangent(lift, rate, second) else {
            let Outline::Flat { base } = *self else { unreachable!("only a flat face has no trace point") };
            return [rate, base + lift];
        };
        match self.roller() {
            None => tangent.point,
            Some(roller) => {
                let [x, y] = tangent.normal();
                [tangent.point[0] - roller * x, tangent.point[1] - roller * y]
            }
        }
    }
}

impl<N: Real> Tangent<N> {
    pub(super) fn length(&self) -> N {
        (self.a.powi(2) + self.b.powi(2)).sqrt()
    }

    /// Outward unit normal.
    pub(super) fn normal(&self) -> [N; 2] {
        let ([x, y], length) = (self.across, self.length());
        // Across is turned a quarter to lie along the motion: (−y, x).
        [(self.a * -y - self.b * x) / length, (self.a * x - self.b * y) / length]
    }

    /// Denominator of the radius of curvature: zero where the curve is straight.
    pub(super) fn denominator(&self) -> N {
        self.b * self.second[0] - self.a * self.second[1]
    }
}

impl Outline<f64> {
    pub(super) fn tangent_at(&self, motion: &Motion) -> Option<Tangent<f64>> {
        self.tangent(motion.lift, motion.rate, motion.second)
    }

    /// Curvature of the pitch curve, or the radius of curvature under a flat face.
    pub(super) fn curvature(&self, motion: &Motion) -> f64 {
        self.tangent_at(motion).map_or(f64::NAN, |tangent| tangent.denominator() / tangent.length().powi(3))
    }

    pub(super) fn pressure(&self, motion: &Motion) -> f64 {
        self.tangent_at(motion).map_or(0.0, |tangent| tangent.b.atan2(tangent.a))
    }

    /// A point of the frame in the axes of the cam at a cam angle.
    pub(super) fn on_cam(&self, [x, y]: [f64; 2], angle: f64) -> [f64; 2] {
        let (sin, cos) = (self.sign() * angle).sin_cos();
        [x * cos + y * sin, y * cos - x * sin]
    }
}

impl CamFollower {
    /// Refuses a lift of the wrong kind.
    pub(super) fn fits(&self, course: &Course) -> Result<(), Refusal> {
        match self {
            CamFollower::Oscillating { .. } if !course.turning => Err(Refusal::because(
                "the lift of an oscillating follower is the angle of its arm: write it in degrees",
            )),
            CamFollower::Motion | CamFollower::Oscillating { .. } => Ok(()),
            _ if course.turning => Err(Refusal::because(
                "the lift of a translating follower is a length: write it in mm, or choose an oscillating follower",
            )),
            _ => Ok(()),
        }
    }
}

/// Geometry of the follower with its sizes; none where motion alone is asked for.
pub(super) fn outline<W: Worksheet>(
    follower: &CamFollower,
    given: &CamFollowerGiven<W>,
    course: &Course,
    sheet: W,
) -> Result<Option<Outline<W::Num>>, Refusal> {
    let found = match (follower, given) {
        (_, CamFollowerGiven::Motion {}) => return Ok(None),
        (_, CamFollowerGiven::KnifeEdge { size, offset }) => translating(size, *offset, None, course, sheet)?,
        (_, CamFollowerGiven::Roller { size, roller, offset }) => {
            translating(size, *offset, Some(*roller), course, sheet)?
        }
        (_, CamFollowerGiven::FlatFaced { size }) => Outline::Flat { base: flat(size, course, sheet)? },
        (
            CamFollower::Oscillating { sense, .. },
            CamFollowerGiven::Oscillating { pivot, arm, size, roller, .. },
        ) => {
            let prime = radius(size, Some(*roller), sheet)?;
            oscillating([*pivot, *arm, prime, *roller], *sense, course, sheet)?
        }
        _ => unreachable!("what is given is made from the inputs"),
    };
    Ok(Some(found))
}

/// Prime circle radius from the radius that is given.
fn radius<W: Worksheet>(
    size: &CamRadiusGiven<W>,
    roller: Option<W::Num>,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let Some(roller) = roller else {
        return Ok(match size {
            CamRadiusGiven::Base { base } => *base,
            CamRadiusGiven::Prime { prime } => *prime,
        });
    };
    match size {
        CamRadiusGiven::Base { base } => {
            let prime = sheet.step("R_p", "mm", *base + roller, "Prime circle radius");
            sheet.answer("prime_radius", "Prime circle radius", prime);
            sheet.answer("base_radius", "Base circle radius", *base);
            sheet.check("base circle radius and radius of the roller", prime - *base, roller);
            Ok(prime)
        }
        CamRadiusGiven::Prime { prime } => {
            base_of(*prime, roller, sheet)?;
            Ok(*prime)
        }
    }
}

/// Base circle radius under a roller, answered.
fn base_of<W: Worksheet>(prime: W::Num, roller: W::Num, sheet: W) -> Result<(), Refusal> {
    if prime.value() <= roller.value() {
        return Err(Refusal::because(
            Text::new("a prime circle of {prime} leaves no cam within a roller of {roller}: write a larger prime circle or a smaller roller")
                .with_quantity("prime", prime.value(), "mm")
                .with_quantity("roller", roller.value(), "mm"),
        ));
    }
    let base = sheet.step("R_b", "mm", prime - roller, "Base circle radius");
    sheet.answer("prime_radius", "Prime circle radius", prime);
    sheet.answer("base_radius", "Base circle radius", base);
    sheet.check("base circle radius and radius of the roller", base + roller, prime);
    Ok(())
}

fn translating<W: Worksheet>(
    size: &CamSizeGiven<W>,
    offset: W::Num,
    roller: Option<W::Num>,
    course: &Course,
    sheet: W,
) -> Result<Outline<W::Num>, Refusal> {
    let size = match size {
        CamSizeGiven::PressureAngle { allowable } => {
            return smallest(*allowable, offset, roller, course, sheet);
        }
        CamSizeGiven::Radius(size) => size,
    };
    let prime = radius(size, roller, sheet)?;
    if offset.value().abs() >= prime.value() {
        return Err(Refusal::because(
            Text::new("the line of the follower passes outside of the prime circle of {prime}: write an offset below it")
                .with_quantity("prime", prime.value(), "mm"),
        ));
    }
    let reach = if offset.value() == 0.0 {
        prime
    } else {
        let why =
            ("Height of the trace point above the cam centre at the lowest position", NORTON.at("§8.6"));
        sheet.step("d", "mm", (prime.powi(2) - offset.powi(2)).sqrt(), why)
    };
    Ok(Outline::Translating { prime, offset, reach, roller })
}

/// Smallest cam with which no pressure angle exceeds the allowable one.
fn smallest<W: Worksheet>(
    allowable: W::Num,
    offset: W::Num,
    roller: Option<W::Num>,
    course: &Course,
    sheet: W,
) -> Result<Outline<W::Num>, Refusal> {
    let (aside, tan) = (offset.value(), allowable.value().tan());
    // Either side of the absolute value alone is smooth.
    let need = |sign: f64| {
        let number = move |motion: &Motion| sign * (motion.rate - aside) / tan - motion.lift;
        course.largest(48, |_| true, number)
    };
    let found = [1.0, -1.0]
        .into_iter()
        .filter_map(need)
        .reduce(|best, other| if other.value > best.value { other } else { best });
    let Some(found) = found.filter(|found| found.value > 0.0) else {
        return Err(Refusal::because(
            "every cam keeps this pressure angle: write the radius of the base circle",
        ));
    };
    let angle = sheet.numerical(
        "θ_a",
        "deg",
        found.motion.angle,
        "Cam angle that needs the largest cam, by search over the program",
    );
    let lift = sheet.numerical("s_a", "mm", found.motion.lift, "Lift there");
    let rate = sheet.numerical("u_a", "mm", found.motion.rate, "Velocity there per radian of the cam, ds/dθ");
    let why = (
        "Height of the trace point at the lowest position, from tan φ = |ds/dθ − e|/(s + d)",
        NORTON.at("§8.6"),
    );
    let reach = sheet.step("d", "mm", (rate - offset).abs() / allowable.tan() - lift, why);
    let prime = if aside == 0.0 {
        sheet.step("R_p", "mm", reach, "Smallest prime circle radius")
    } else {
        let value = (reach.powi(2) + offset.powi(2)).sqrt();
        sheet.step("R_p", "mm", value, "Smallest prime circle radius")
    };
    sheet.answer("size_angle", "Cam angle that needs the largest cam", angle);
    match roller {
        Some(roller) => base_of(prime, roller, sheet)?,
        None => sheet.answer("base_radius", "Base circle radius", prime),
    }
    let outline = Outline::Translating { prime, offset, reach, roller };
    sheet.verify(|| {
        // The same cam, searched for its pressure angles.
        let numbers = outline.numbers();
        let steepest = |motion: &Motion| numbers.pressure(motion).abs();
        if let Some(most) = course.largest(300, |_| true, steepest) {
            let what = "largest pressure angle of a fine search with that cam: the allowable one";
            let reach = (rate - offset).abs() / W::Num::from(most.value.tan()) - lift;
            sheet.check_sum(what, prime.powi(2) - offset.powi(2), reach.powi(2), prime.value().powi(2));
            let what = "cam angle of that pressure angle";
            sheet.check_residual(what, angle - most.motion.angle, 1.0, 1e-9);
        }
    });
    Ok(outline)
}

/// Base circle radius of a cam for a flat face.
fn flat<W: Worksheet>(size: &FlatCamSizeGiven<W>, course: &Course, sheet: W) -> Result<W::Num, Refusal> {
    let least = match size {
        FlatCamSizeGiven::Base { base } => return Ok(*base),
        FlatCamSizeGiven::Curvature { least } => least,
    };
    let Some(found) = course.largest(48, |_| true, |motion| -(motion.lift + motion.second)) else {
        return Err(Refusal::because(
            "every cam has this radius of curvature: write the radius of the base circle",
        ));
    };
    let lift = sheet.numerical(
        "s_c",
        "mm",
        found.motion.lift,
        "Lift at the cam angle at which s + d²s/dθ² is least, by search over the program",
    );
    let second = sheet.numerical("w_c", "mm", found.motion.second, "d²s/dθ² there");
    let why = ("Smallest base circle radius, from ρ = R_b + s + d²s/dθ²", NORTON.at("§8.6"));
    let base = sheet.step("R_b", "mm", *least - lift - second, why);
    if base.value() <= 0.0 {
        return Err(Refusal::because(
            "every cam has this radius of curvature: write the radius of the base circle",
        ));
    }
    sheet.answer("base_radius", "Base circle radius", base);
    sheet.verify(|| {
        if let Some(again) = course.largest(300, |_| true, |motion| -(motion.lift + motion.second)) {
            let what = "base circle radius by a fine search over the program";
            sheet.check_sum(what, base - *least, again.value.into(), base.value());
        }
    });
    Ok(base)
}

fn oscillating<W: Worksheet>(
    [pivot, arm, prime, roller]: [W::Num; 4],
    sense: CamSense,
    course: &Course,
    sheet: W,
) -> Result<Outline<W::Num>, Refusal> {
    let cosine = (pivot.powi(2) + arm.powi(2) - prime.powi(2)) / (pivot * arm * 2.0);
    if cosine.value().abs() >= 1.0 {
        return Err(Refusal::because(
            Text::new("distance of the pivot, arm and prime circle radius of {prime} make no triangle: mend one of them")
                .with_quantity("prime", prime.value(), "mm"),
        ));
    }
    let why = (
        "Angle of the arm to the line of centres at the lowest position, by the cosine rule",
        SHIGLEY.at("ch. 5"),
    );
    let start = sheet.step("ψ_0", "deg", cosine.acos(), why);
    sheet.answer("start_angle", "Angle of the arm at the lowest position", start);
    sheet.verify(|| {
        let (x, y) = (pivot - arm * start.cos(), arm * start.sin());
        let what = "distance of the roller from the cam centre at that angle: the prime circle radius";
        sheet.check(what, (x.powi(2) + y.powi(2)).sqrt(), prime);
    });
    let highest = course.largest(4, |_| true, |motion| motion.lift).map_or(0.0, |found| found.value);
    if start.value() + highest >= PI {
        return Err(Refusal::because(
            Text::new("the arm would swing up to {angle} and pass the line of centres: write a smaller lift or prime circle")
                .with_quantity("angle", start.value() + highest, "deg"),
        ));
    }
    let sign = if sense == CamSense::Away { 1.0 } else { -1.0 };
    Ok(Outline::Oscillating { pivot, arm, start, roller, sign })
}
