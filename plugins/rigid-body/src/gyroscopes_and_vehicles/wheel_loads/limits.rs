//! The speeds at which a wheel lifts or the vehicle slides.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;

use super::{
    AxleLayout, AxleLayoutGiven, GEAR_SQUARED, GearedInertia, WheelLoads, WheelLoadsGiven,
    wheels::{self, Constants, Wheel},
};
use crate::sources::KHURMI;

impl WheelLoads {
    /// The speeds at which the first wheel lifts and at which the vehicle slides.
    pub(super) fn limits<W: Worksheet>(&self, given: &WheelLoadsGiven<W>, inertia: W::Num, sheet: W) {
        let wheels = self.wheel_list();
        let constants = self.constants(inertia.value());
        let first = wheels
            .iter()
            .filter_map(|wheel| constants.lifting_speed(wheel).map(|speed| (wheel, speed)))
            .min_by(|(_, a), (_, b)| a.total_cmp(b));
        if wheels.iter().any(|wheel| constants.load(wheel, 0.0) < 0.0) {
            sheet.warn(|| "the bank is so steep that the vehicle tips over to the inside at rest".into());
        }
        if let Some((wheel, _)) = first {
            let lifting = self.lifting_steps(given, inertia, wheel, sheet);
            sheet.answer("lifting_speed", wheel.lifts, lifting);
            sheet.verify(|| {
                let left = constants.load(wheel, lifting.value());
                let what = "load of the wheel that lifts first at that speed, from moments about the others";
                sheet.check_zero(what, left.into(), constants.load(wheel, 0.0));
            });
        } else {
            sheet.warn(|| "no wheel lifts at any speed".into());
        }
        let Some(friction) = given.friction else { return };
        let (sin, cos) = (given.bank.sin(), given.bank.cos());
        if cos.value() <= (friction * sin).value() {
            sheet.warn(|| "on this bank the vehicle does not slide outwards at any speed".into());
            return;
        }
        let square = if self.bank == 0.0 {
            friction * given.gravity * given.radius
        } else {
            given.gravity * given.radius * (sin + friction * cos) / (cos - friction * sin)
        };
        if self.bank != 0.0 {
            let added = || (given.gravity * given.radius * (friction + sin / cos)).sqrt();
            sheet.common_error("v_s", "tangent of the bank simply added to the friction coefficient", added);
        }
        let sliding = sheet.step(
            "v_s",
            "m/s",
            square.sqrt(),
            "Speed at which the side force reaches the friction: S = µ P",
        );
        sheet.answer("sliding_speed", "Speed at which the vehicle slides outwards", sliding);
        sheet.verify(|| {
            let outwards = sliding.powi(2) / given.radius;
            let side = outwards * cos - given.gravity * sin;
            let normal = given.gravity * cos + outwards * sin;
            let size = outwards.value() + self.gravity;
            sheet.check_sum("side force and friction at that speed", side, friction * normal, size);
        });
        if first.is_some_and(|(_, lifting)| lifting < sliding.value()) {
            sheet.warn(|| "a wheel lifts before the vehicle slides: it overturns".into());
        }
    }

    /// The speed at which one wheel lifts: its load at rest, and what it loses per square of speed.
    fn lifting_steps<W: Worksheet>(
        &self,
        given: &WheelLoadsGiven<W>,
        inertia: W::Num,
        wheel: &Wheel,
        sheet: W,
    ) -> W::Num {
        let banked = self.bank != 0.0;
        let reduced = match &given.engine {
            Some(engine) if !self.engine.as_ref().is_some_and(GearedInertia::lies_along) => {
                let share = engine.ratio * engine.inertia;
                if self.engine_sign() > 0.0 { inertia + share } else { inertia - share }
            }
            _ => inertia,
        };
        let level =
            given.mass * given.centre_height / given.radius + reduced / (given.wheel_radius * given.radius);
        let per_square = if banked { level * given.bank.cos() } else { level };
        let per_square = match given.transverse_inertia {
            Some(transverse) if banked => {
                per_square
                    - (inertia - transverse * self.axles()) * given.bank.sin() * given.bank.cos()
                        / given.radius.powi(2)
            }
            _ => per_square,
        };
        if let Some(engine) = &given.engine
            && !self.engine.as_ref().is_some_and(GearedInertia::lies_along)
        {
            let squared = || {
                let more = engine.ratio * (engine.ratio - 1.0) * engine.inertia
                    / (given.wheel_radius * given.radius);
                let more = if banked { more * given.bank.cos() } else { more };
                if self.engine_sign() > 0.0 { per_square + more } else { per_square - more }
            };
            sheet.common_error("K", GEAR_SQUARED, squared);
        }
        let per_square = sheet.step(
            "K",
            "kg",
            per_square,
            (
                "Overturning couple per square of speed: C = K v² (less m g h sin β on a bank)",
                KHURMI.at("§14.9"),
            ),
        );
        // The parts of this wheel of what all wheels carry, and of what goes from side to side.
        let own = |all: W::Num| match given.layout {
            AxleLayoutGiven::TwoAxles { wheelbase, behind_front, .. } if wheel.front => {
                all * (wheelbase - behind_front) / (wheelbase * 2.0)
            }
            AxleLayoutGiven::TwoAxles { wheelbase, behind_front, .. } => {
                all * behind_front / (wheelbase * 2.0)
            }
            AxleLayoutGiven::TwoEqualAxles { .. } => all / 4.0,
            AxleLayoutGiven::OneAxle { .. } => all / 2.0,
        };
        let shifted = |all: W::Num| match given.layout {
            AxleLayoutGiven::TwoAxles { front_share, .. } if wheel.front => all * front_share,
            AxleLayoutGiven::TwoAxles { front_share, .. } => all * (W::Num::from(1.0) - front_share),
            AxleLayoutGiven::TwoEqualAxles { .. } => all / 2.0,
            AxleLayoutGiven::OneAxle { .. } => all,
        };
        let weight = given.mass * given.gravity;
        let rest = if banked {
            let inwards = shifted(weight * given.centre_height * given.bank.sin() / given.track);
            let own = own(weight * given.bank.cos());
            if wheel.outer { own - inwards } else { own + inwards }
        } else {
            own(weight)
        };
        let rest = sheet.step("N₀", "N", rest, "Static load of the first wheel to lift");
        let outwards = shifted(per_square / given.track);
        let loss = if wheel.outer { -outwards } else { outwards };
        let loss = if banked { loss - own(given.mass * given.bank.sin() / given.radius) } else { loss };
        let loss = match (&given.engine, given.layout_base()) {
            (Some(engine), Some(wheelbase))
                if self.engine.as_ref().is_some_and(GearedInertia::lies_along) =>
            {
                let couple = engine.ratio * engine.inertia / (given.wheel_radius * given.radius);
                let couple = if banked { couple * given.bank.cos() } else { couple };
                let part = couple / (wheelbase * 2.0);
                let relieved = (self.engine_sign() > 0.0) != wheel.front;
                if relieved { loss + part } else { loss - part }
            }
            _ => loss,
        };
        let loss = sheet.step("n", "kg/m", loss, "Load reduction per unit of speed squared");
        if !banked && matches!(self.layout, AxleLayout::TwoAxles { .. }) {
            let as_a_whole = || (weight * given.track / (per_square * 2.0)).sqrt();
            let what = "vehicle assumed to overturn as a whole, without regard to the load of each axle";
            sheet.common_error("v_l", what, as_a_whole);
        }
        sheet.step("v_l", "m/s", (rest / loss).sqrt(), "Speed at which the load vanishes: N₀ = n v²")
    }

    /// A second method to the limiting speed: the loads there, from moments about the other wheels.
    pub(super) fn check_limits<W: Worksheet>(&self, inertia: f64, sheet: W) {
        let constants = self.constants(inertia);
        for wheel in self.wheel_list() {
            if let Some(speed) = constants.lifting_speed(&wheel) {
                sheet.check_zero(
                    "the load is zero at the lifting speed",
                    W::Num::from(constants.load(&wheel, speed)),
                    constants.load(&wheel, 0.0),
                );
            }
        }
    }

    /// The loads as they depend on speed, in plain numbers.
    pub(super) fn constants(&self, inertia: f64) -> Constants {
        let (sin, cos) = self.bank.sin_cos();
        let weight = self.mass * self.gravity;
        let engine =
            self.engine.as_ref().map_or(0.0, |engine| engine.inertia * engine.ratio) * self.engine_sign();
        let along = self.engine.as_ref().is_some_and(GearedInertia::lies_along);
        let across = if along { 0.0 } else { engine };
        let transverse = self.transverse_inertia.map_or(inertia, |transverse| transverse * self.axles());
        let tilting = (self.mass * self.centre_height + (inertia + across) / self.wheel_radius) * cos
            / self.radius
            - (inertia - transverse) * sin * cos / self.radius.powi(2);
        let base =
            if let AxleLayout::TwoAxles { wheelbase, .. } = self.layout { wheelbase } else { f64::INFINITY };
        let pitching = if along { engine * cos / (self.wheel_radius * self.radius) / base } else { 0.0 };
        Constants {
            normal: (weight * cos, self.mass * sin / self.radius),
            transfer: (-weight * sin * self.centre_height / self.track, tilting / self.track),
            pitching,
        }
    }

    /// The wheels that differ from each other.
    pub(super) fn wheel_list(&self) -> Vec<Wheel> {
        match self.layout {
            AxleLayout::TwoEqualAxles => wheels::alike(0.5),
            AxleLayout::OneAxle => wheels::alike(1.0),
            AxleLayout::TwoAxles { wheelbase, behind_front, front_share } => {
                wheels::four((wheelbase - behind_front) / wheelbase, front_share)
            }
        }
    }
}

impl<W: Worksheet> WheelLoadsGiven<W> {
    /// The wheelbase, where it is given.
    fn layout_base(&self) -> Option<W::Num> {
        match self.layout {
            AxleLayoutGiven::TwoAxles { wheelbase, .. } => Some(wheelbase),
            _ => None,
        }
    }
}
