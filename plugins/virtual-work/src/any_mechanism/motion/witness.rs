//! The second methods to a motion: its energy balance, its last stretch integrated again, and how its joints slide.

use dalembert_core::{Text, Worksheet};
use dalembert_mechanics::{
    Real,
    planar::{self, BodyFrame, Contact, JointFriction, PlanarRun, PlanarState},
};

use super::{DOUBTFUL, ROUNDINGS, STEPS, Solved, WRONG};
use crate::shared::parts::PartLoad;

impl Solved<'_> {
    /// Answers the sliding velocity of a joint with friction at the end.
    pub(super) fn sliding<W: Worksheet>(
        &self,
        joint_friction: &JointFriction,
        shown: &PlanarState,
        sheet: W,
    ) {
        let row = joint_friction.load + 1;
        let name = &self.parts.loads[joint_friction.load].name;
        let (reason, sliding) = match joint_friction.contact {
            Contact::Sliding { .. } => ("Sliding velocity against {name} at the end", joint_friction.sliding),
            Contact::Sticking | Contact::Indeterminate => {
                ("At the end {name} is sticking: its joint does not slide", 0.0)
            }
        };
        let unit = if joint_friction.pin { "rad/s" } else { "m/s" };
        let why = Text::new(reason).with("name", name);
        let sliding = sheet.numerical(("u", row), unit, sliding, why);
        sheet.answer(("sliding", row), "Sliding velocity against friction at the end", sliding);
        sheet.row_label(("sliding", row), name);
        let (Contact::Sliding { .. }, PartLoad::Friction { joint, .. }) =
            (joint_friction.contact, &self.parts.loads[joint_friction.load].load)
        else {
            return;
        };
        let joints = &self.system.mechanism().joints;
        let Some(owner) = self.rows.iter().position(|row| *row == joint.0) else { return };
        sheet.verify(|| {
            let turn = |part: BodyFrame| part.map_or(0.0, |body| shown.velocities[body][2]);
            let (again, size) = match joints[owner] {
                planar::PlanarJoint::Pin { a, b } => {
                    (turn(b.on) - turn(a.on), turn(b.on).abs() + turn(a.on).abs())
                }
                planar::PlanarJoint::Slider { guide, direction, slides: at, .. }
                | planar::PlanarJoint::Slot { guide, direction, pin: at, .. } => {
                    let [[start, of_start, _], [end, of_end, _]] =
                        [guide, at].map(|point| self.system.point(point, shown));
                    let tilt = direction + guide.on.map_or(0.0, |body| shown.positions[body][2]);
                    let (sin, cos) = tilt.sin_cos();
                    let [x, y] = [end[0] - start[0], end[1] - start[1]];
                    let along = cos * (of_end[0] - of_start[0]) + sin * (of_end[1] - of_start[1]);
                    let carried = turn(guide.on) * (cos * y - sin * x);
                    let size = of_end[0].hypot(of_end[1]) + of_start[0].hypot(of_start[1]) + carried.abs();
                    (along + carried, size)
                }
                _ => return,
            };
            let what = Text::new("sliding velocity against {name} from the motions of both its bodies");
            let error = self.tolerance * size;
            sheet.check_residual(what.with("name", name), (sliding.value() - again).into(), size, error);
        });
    }

    /// Follows the last stretch of the motion again, to the time of its end. Where a driver moves or a friction may
    /// stick, a motion does not start again as it was going on.
    pub(super) fn check_time<W: Worksheet>(&self, time: f64, sheet: W) {
        let goes_on = self.parts.drivers.is_empty() && self.dynamics.frictions.is_empty();
        let (samples, Some(last)) = (&self.moved.samples, self.moved.samples.last()) else { return };
        let before = samples.iter().rev().find(|moment| moment.time < last.time * (1.0 - 1e-3));
        let (true, Some(before)) = (goes_on, before) else { return };
        let run = PlanarRun {
            duration: time - before.time,
            tolerance: self.tolerance,
            samples: 2,
            ends: &[],
            most_steps: STEPS,
            cancelled: &|| sheet.keep_going().is_err(),
        };
        let PlanarState { positions, velocities, .. } = &before.state;
        let Ok(again) = self.system.simulate(positions, velocities, &run) else { return };
        let Some(again) = again.samples.last() else { return };
        let arm = self.system.size();
        let far = |[x, y, turn]: [f64; 3]| x.hypot(y).max(turn.abs() * arm);
        let pairs = again.state.positions.iter().zip(&last.state.positions);
        let apart = |(one, other): (&[f64; 3], &[f64; 3])| far([0, 1, 2].map(|n| one[n] - other[n]));
        let gap = pairs.map(apart).fold(0.0, f64::max);
        let size = last.state.positions.iter().map(|at| far(*at)).fold(arm, f64::max);
        let what = "the last part of the motion, integrated again to the end time";
        // Each step may add its error, which the motion carries on.
        sheet.check_residual(what, gap.into(), size, 100.0 * self.tolerance * size);
    }

    /// The energy balance, the witness of the motion.
    pub(super) fn balance<W: Worksheet>(&self, kinetic: W::Num, sheet: W) {
        let first = &self.moved.samples[0];
        let (start, mut size, mut stored) = (first.stored, first.kinetic, 0.0f64);
        for moment in &self.moved.samples {
            size = size.max(moment.kinetic).max((moment.stored - start).abs()).max(moment.work.abs());
            stored = stored.max(moment.stored.abs());
        }
        // Where nothing moves, the change of the stored energy is the rounding of its value.
        let rounding = f64::EPSILON * stored;
        size = size.max(rounding);
        let last = self.moved.samples.last().unwrap_or(first);
        let gained = sheet.numerical(
            "V",
            "J",
            self.without_error(last.stored - start, size),
            "Energy gained by weights, springs and constant forces since the start",
        );
        sheet.answer("stored_energy", "Energy stored since the start", gained);
        let work = sheet.numerical(
            "W",
            "J",
            last.work,
            "Work of the drivers, dampers, friction and follower forces since the start",
        );
        sheet.answer("work", "Work done since the start", work);
        let left = self.moved.imbalance();
        let what = "the energy balance T + V − W over the motion";
        if left > DOUBTFUL * size && left > ROUNDINGS * rounding {
            sheet.warn(|| {
                Text::new("the energy balance closes only to within {left}, of {size}: at a dead centre or change point the motion depends on digits lost there")
                    .with_quantity("left", left, "J")
                    .with_quantity("size", size, "J")
            });
            sheet.check_residual(what, left.into(), size, WRONG * size);
        } else {
            sheet.check_residual(what, left.into(), size, rounding);
            let end = kinetic.value() + gained.value() - work.value();
            let what = "T + V − W at the end equals the initial kinetic energy";
            sheet.check_residual(what, (end - first.kinetic).into(), size, self.tolerance * size + rounding);
        }
    }
}
