//! Force on a translating follower, torque of the cam shaft, and loss of contact.

use dalembert_core::{Inputs, Refusal, Text, Worksheet, trace::Symbol};
use dalembert_mechanics::Real;
use dalembert_numerics::{differentiation::derivative, roots};

use super::{
    follower::Outline,
    motion::Position,
    program::{Course, Found, Motion},
};
use crate::sources::NORTON;

/// Mass, spring and load that press a translating follower on the cam.
#[derive(Clone, Debug, Inputs)]
pub struct FollowerLoad {
    /// Mass of the follower.
    /// All that moves with it, and a third of the spring.
    #[input("m", "kg", nonnegative)]
    pub mass: f64,
    /// Stiffness of the spring.
    #[input("k", "N/m", nonnegative, default = "0 N/m")]
    pub stiffness: f64,
    /// Preload of the spring.
    /// Its force at the lowest position.
    #[input("F_0", "N", nonnegative, default = "0 N")]
    pub preload: f64,
    /// Damping coefficient.
    #[input("c", "N*s/m", nonnegative, default = "0 N*s/m")]
    pub damping: f64,
    /// Constant load.
    /// Weight and working load, positive towards the cam.
    #[input("P", "N", default = "0 N")]
    pub constant: f64,
}

/// The load as numbers.
#[derive(Clone, Copy)]
pub(super) struct Load {
    mass: f64,
    stiffness: f64,
    damping: f64,
    /// Preload and constant load.
    steady: f64,
    speed: f64,
}

impl Load {
    pub(super) fn force(&self, motion: &Motion) -> f64 {
        let w = self.speed;
        self.mass * w * w * motion.second
            + self.damping * w * motion.rate
            + self.stiffness * motion.lift
            + self.steady
    }

    pub(super) fn torque(&self, motion: &Motion) -> f64 {
        self.force(motion) * motion.rate
    }

    /// Force without that of inertia.
    fn held(&self, motion: &Motion) -> f64 {
        self.stiffness * motion.lift + self.steady
    }

    /// Largest terms of the force and of the torque.
    fn scales(&self, course: &Course) -> (f64, f64) {
        let most = |number: fn(&Motion) -> f64| {
            course.largest(16, |_| true, move |motion| number(motion).abs()).map_or(0.0, |found| found.value)
        };
        let (lift, rate, second) = (most(|m| m.lift), most(|m| m.rate), most(|m| m.second));
        let w = self.speed;
        let force =
            self.mass * w * w * second + self.damping * w * rate + self.stiffness * lift + self.steady.abs();
        (force, force * rate)
    }
}

/// Position, contact and pressure angle, where there are any.
pub(super) type Place<'a, N> = (Option<&'a Position<N>>, Option<&'a Outline<N>>, Option<N>);

/// Works out forces and torque; refused where an inertia force needs the speed.
pub(super) fn solve<W: Worksheet>(
    given: &FollowerLoadGiven<W>,
    speed: Option<W::Num>,
    course: &Course,
    (position, outline, pressure): Place<'_, W::Num>,
    sheet: W,
) -> Result<Load, Refusal> {
    if course.turning {
        return Err(Refusal::because(
            "a force is that of a translating follower, whose lift is a length: write the lift in mm, or leave the force out",
        ));
    }
    let moves = given.mass.value() > 0.0 || given.damping.value() > 0.0;
    if moves && speed.is_none() {
        return Err(Refusal::because(
            "mass and damping of the follower act by the speed of the cam: write that speed",
        ));
    }
    let numbers = Load {
        mass: given.mass.value(),
        stiffness: given.stiffness.value(),
        damping: given.damping.value(),
        steady: given.preload.value() + given.constant.value(),
        speed: speed.map_or(0.0, Real::value),
    };
    let (size, torque_size) = numbers.scales(course);
    if size == 0.0 {
        return Err(Refusal::because(
            "no force acts on the follower: write a mass, a spring, a preload or a load",
        ));
    }
    let force = |at: &Position<W::Num>| {
        let mut terms = vec![given.stiffness * at.lift + given.preload + given.constant];
        if let Some(speed) = speed {
            terms.push(given.mass * speed.powi(2) * at.second);
            if given.damping.value() > 0.0 {
                terms.push(given.damping * speed * at.rate);
            }
        }
        W::Num::sum(terms)
    };
    if let Some(at) = position {
        let why = (
            "Force of the cam along the motion of the follower: k s + F_0 + P + m ω² s″ + c ω s′",
            NORTON.at("ch. 15"),
        );
        let along = sheet.step("F", "N", force(at), why);
        sheet.answer("contact_force", "Force of the cam along the motion", along);
        let why = ("Torque on the cam shaft, by virtual work: T δθ = F δs", NORTON.at("ch. 15"));
        if let Some(&Outline::Translating { offset, reach, .. }) = outline {
            sheet.common_error(
                "T",
                "the distance of the trace point from the cam centre used as the arm",
                || along * ((at.lift + reach).powi(2) + offset.powi(2)).sqrt(),
            );
        }
        let torque = sheet.step("T", "N*m", along * at.rate, why);
        sheet.answer("torque", "Torque on the cam shaft", torque);
        check_energy(&numbers, (at, along, torque), course, (size, torque_size), sheet);
        let tangent = outline.and_then(|outline| outline.tangent(at.lift, at.rate, at.second));
        if let (Some(tangent), Some(pressure)) = (tangent, pressure) {
            let why = "Force along the normal, without friction: F/cos φ";
            let normal = sheet.step("N", "N", along / pressure.cos(), why);
            let why = "Side thrust on the guide: F tan φ";
            let side = sheet.step("H", "N", along * pressure.tan(), why);
            sheet.answer("normal_force", "Normal force at the contact", normal);
            sheet.answer("side_thrust", "Side thrust on the guide", side);
            sheet.verify(|| {
                let [nx, ny] = tangent.normal();
                let [px, py] = tangent.point;
                let what = "moment of the normal force about the cam centre: the torque";
                sheet.check_sum(
                    what,
                    normal * (px * ny - py * nx),
                    torque,
                    torque_size + size * px.value().abs(),
                );
                let what = "components of the normal force: along and across the motion";
                sheet.check(what, along.powi(2) + side.powi(2), normal.powi(2));
            });
        }
    }
    let over = Over { numbers, course, size };
    let most = over.extreme(
        1.0,
        ("a", "Cam angle of the largest force, by search", "F_max"),
        [
            ("largest_force", "Largest force of the cam"),
            ("largest_force_cam_angle", "Cam angle of the largest force"),
        ],
        &force,
        sheet,
    );
    let least = over.extreme(
        -1.0,
        ("b", "Cam angle of the least force, by search", "F_min"),
        [
            ("least_force", "Least force of the cam"),
            ("least_force_cam_angle", "Cam angle of the least force"),
        ],
        &force,
        sheet,
    );
    over.torques(&force, torque_size, sheet);
    if let (Some(_), Some(least)) = (most, least) {
        over.contact(given, least, sheet);
    }
    Ok(numbers)
}

/// Holds force and torque to the power of the follower.
fn check_energy<W: Worksheet>(
    load: &Load,
    (at, force, torque): (&Position<W::Num>, W::Num, W::Num),
    course: &Course,
    (size, torque_size): (f64, f64),
    sheet: W,
) {
    sheet.verify(|| {
        let Some((k, x)) = course.place(at.angle.value()) else { return };
        let segment = &course.segments[k];
        let Some(law) = segment.law else { return };
        let piece = law.piece(x);
        let w = load.speed;
        let energy = |x: f64| {
            let motion = segment.at(x, piece);
            0.5 * load.mass * (w * motion.rate).powi(2)
                + 0.5 * load.stiffness * motion.lift.powi(2)
                + load.steady * motion.lift
        };
        let motion = segment.at(x, piece);
        let lost = load.damping * w * motion.rate.powi(2);
        let power = derivative(energy, x, 0.004) / segment.turn + lost;
        let what = "torque from the energy of mass, spring and load over the cam angle, and the damping";
        sheet.check_sum(what, torque, power.into(), torque_size);
        let second = derivative(|x| segment.at(x, piece).rate, x, 0.004) / segment.turn;
        let again = load.force(&Motion { second, ..motion });
        let what = "force with the acceleration by differences of the velocity";
        sheet.check_sum(what, force, again.into(), size);
    });
}

/// Extremes over a program.
struct Over<'a> {
    numbers: Load,
    course: &'a Course,
    size: f64,
}

/// Names and labels of an extreme and of its place.
type Names = [(&'static str, &'static str); 2];

impl Over<'_> {
    fn spot<W: Worksheet>(
        &self,
        found: &Found,
        of: &'static str,
        words: &'static str,
        sheet: W,
    ) -> Position<W::Num> {
        let symbol = |base: &'static str| Symbol { of, ..Symbol::from(base) };
        let motion = &found.motion;
        Position {
            angle: sheet.numerical(symbol("θ"), "deg", motion.angle, words),
            lift: sheet.numerical(symbol("s"), "mm", motion.lift, "Lift there"),
            rate: sheet.numerical(symbol("s′"), "mm", motion.rate, "ds/dθ there"),
            second: sheet.numerical(symbol("s″"), "mm", motion.second, "d²s/dθ² there"),
        }
    }

    /// An extreme force, answered with its place.
    fn extreme<W: Worksheet>(
        &self,
        sign: f64,
        (of, words, symbol): (&'static str, &'static str, &'static str),
        [(name, label), (place, place_label)]: Names,
        force: &impl Fn(&Position<W::Num>) -> W::Num,
        sheet: W,
    ) -> Option<W::Num> {
        let load = self.numbers;
        let number = move |motion: &Motion| sign * load.force(motion);
        let found = self.course.largest(48, |_| true, number)?;
        let there = self.spot(&found, of, words, sheet);
        let value = sheet.step(symbol, "N", force(&there), "Force there, by the same formula");
        sheet.answer(name, label, value);
        sheet.answer(place, place_label, there.angle);
        sheet.verify(|| {
            if let Some(again) = self.course.largest(301, |_| true, number) {
                let what = "force at that place by a fine search";
                sheet.check_sum(what, value, (sign * again.value).into(), self.size);
                self.check_place(there.angle, &again, number, sheet);
            }
        });
        Some(value)
    }

    fn check_place<W: Worksheet>(
        &self,
        angle: W::Num,
        again: &Found,
        number: impl Fn(&Motion) -> f64,
        sheet: W,
    ) {
        let other = again.motion.angle;
        let near = (angle.value() - other).abs() < 1e-5;
        let equal = self
            .course
            .at(angle.value())
            .is_some_and(|motion| (number(&motion) - again.value).abs() <= 1e-9 * again.value.abs());
        let place = if !near && equal { angle.value() } else { other };
        sheet.check_residual("its cam angle by that search", angle - place, 1.0, 1e-9);
    }

    /// Extremes of the torque.
    fn torques<W: Worksheet>(&self, force: &impl Fn(&Position<W::Num>) -> W::Num, scale: f64, sheet: W) {
        let load = self.numbers;
        for (sign, of, symbol, name, label, words) in [
            (
                1.0,
                "c",
                "T_max",
                "largest_torque",
                "Largest torque on the cam shaft",
                "Cam angle of the largest torque, by search",
            ),
            (
                -1.0,
                "d",
                "T_min",
                "least_torque",
                "Least torque on the cam shaft",
                "Cam angle of the least torque, by search",
            ),
        ] {
            let number = move |motion: &Motion| sign * load.torque(motion);
            let Some(found) = self.course.largest(48, |_| true, number) else { continue };
            let there = self.spot(&found, of, words, sheet);
            let value = sheet.step(symbol, "N*m", force(&there) * there.rate, "Torque there, T = F s′");
            sheet.answer(name, label, value);
            sheet.verify(|| {
                if let Some(again) = self.course.largest(301, |_| true, number) {
                    let what = "torque at that place by a fine search";
                    sheet.check_sum(what, value, (sign * again.value).into(), scale);
                }
            });
        }
    }

    /// Preload that just keeps contact, and the speed at which contact is lost.
    fn contact<W: Worksheet>(&self, given: &FollowerLoadGiven<W>, least: W::Num, sheet: W) {
        let load = self.numbers;
        let needed = given.preload - least;
        if needed.value() > 0.0 {
            let why = "Preload with which the least force is zero";
            let needed = sheet.step("F_0,min", "N", needed, why);
            sheet.answer("least_preload", "Least preload that keeps contact", needed);
            sheet.verify(|| {
                let with = Load { steady: needed.value() + given.constant.value(), ..load };
                let again = self.course.largest(301, |_| true, |motion| -with.force(motion));
                let rest = again.map_or(0.0, |found| found.value);
                // What remains of a force with that preload is what it is wrong by.
                let sought = needed.value() + rest;
                sheet.check_sum(
                    "preload with which a fine search finds no force left",
                    needed,
                    sought.into(),
                    self.size,
                );
            });
        }
        if least.value() < -1e-9 * self.size {
            let lost = self.first_loss();
            sheet.warn(|| {
                Text::new("contact is lost at the cam angle {angle}: to follow the program the cam would have to pull, with up to {force}; use a larger preload or a stiffer spring")
                    .with_quantity("angle", lost, "deg")
                    .with_quantity("force", -least.value(), "N")
            });
        }
        if load.damping > 0.0 || load.mass == 0.0 {
            return;
        }
        let held =
            self.course.largest(48, |_| true, |motion| -load.held(motion)).map_or(0.0, |found| -found.value);
        if held <= 0.0 {
            return;
        }
        let number = |motion: &Motion| -motion.second / load.held(motion);
        let Some(found) = self.course.largest(48, |_| true, number).filter(|found| found.value > 0.0) else {
            return;
        };
        let words = "Cam angle at which contact is lost first as the speed rises, by search";
        let there = self.spot(&found, "j", words, sheet);
        let held = given.stiffness * there.lift + given.preload + given.constant;
        let why = ("Speed at which the force there is zero: m ω² |s″| = k s + F_0 + P", NORTON.at("ch. 15"));
        let speed = sheet.step("ω_j", "rpm", (held / (given.mass * -there.second)).sqrt(), why);
        sheet.answer("jump_speed", "Cam speed at which contact is lost", speed);
        sheet.verify(|| {
            let at = Load { speed: speed.value(), ..load };
            if let Some(again) = self.course.largest(301, |_| true, |motion| -at.force(motion)) {
                let left = at.held(&again.motion) / (load.mass * -again.motion.second);
                let what = "speed at which the least force of a fine search is zero";
                sheet.check_sum(what, speed.powi(2), left.into(), left);
            }
        });
    }

    /// Cam angle at which the force first becomes negative, rad.
    fn first_loss(&self) -> f64 {
        let motions = self.course.motions();
        let force = |motion: &Motion| self.numbers.force(motion);
        let Some(first) = motions.iter().position(|motion| force(motion) < 0.0) else { return 0.0 };
        let here = &motions[first];
        let Some(before) = first.checked_sub(1).map(|n| &motions[n]) else { return here.angle };
        let at = |angle: f64| self.course.at(angle).map_or(f64::NAN, |motion| force(&motion));
        let ends = [(before.angle, force(before)), (here.angle, force(here))];
        roots::crossing(&ends, at).unwrap_or(here.angle)
    }
}
