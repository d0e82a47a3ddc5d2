//! The body on its supports, and the reactions in other places and at other speeds.

use std::f64::consts::TAU;

use dalembert_core::{Axis, Exhibit, Ink, Name, Plot, Series, Text, Worksheet};
use dalembert_mechanics::{
    Real as _,
    rigid::{
        self, MassProperties,
        chain::{self, ChainFrame},
        supports::Wrench,
    },
};
use nalgebra::Vector3;

use super::{Acts, Found, Held, Reactions, ShaftDrive, SupportKind};
use crate::shared::{
    flat,
    joints::{self, Named, given_name, seen_from},
    scene::{self, Scene},
};

impl Reactions {
    /// The reactions for joints in other places or at other speeds, in the fixed axes; `None` where there are none.
    fn reactions_at(&self, body: &MassProperties, joints: &[chain::ChainJoint]) -> Option<Vec<Vector3<f64>>> {
        let frames = chain::frames(joints).ok()?;
        let held = Held::new(self, &frames).ok()?;
        let found = |acceleration: f64| {
            let mut joints = joints.to_vec();
            joints.last_mut()?.acceleration = acceleration;
            held.reactions(&self.known(body, &chain::frames(&joints).ok()?), true).ok()
        };
        let given = joints.last()?.acceleration;
        let (supports, drive) = found(given)?;
        let supports = match (&self.drive, drive) {
            // The couple of the drive grows with the acceleration along a straight line.
            (ShaftDrive::Couple { couple }, Some(drive)) => {
                let step = 1.0 + given.abs();
                let (_, further) = found(given + step)?;
                found(given + step * (couple - drive) / (further? - drive))?.0
            }
            _ => supports,
        };
        let axes = &frames[self.axes.place()];
        Some(supports.iter().map(|of| axes.rotation * of.force).collect())
    }

    /// The speeds of a shaft at which a wire or a contact carries nothing: its force is `a + b ω²`.
    pub(super) fn unloading<W: Worksheet>(
        &self,
        body: &MassProperties,
        axes: &ChainFrame,
        acceleration: f64,
        sheet: W,
    ) {
        let [joint] = self.joints_with(acceleration)[..] else { return };
        let rate = if joint.rate == 0.0 { TAU / chain::period(&[joint]) } else { joint.rate };
        for (n, support) in self.supports.iter().enumerate() {
            let along = match support.kind {
                SupportKind::Wire { direction } => direction,
                SupportKind::Contact { normal, .. } => normal,
                _ => continue,
            };
            let along = axes.rotation * (along / along.amax()).normalize();
            let force = |rate: f64| {
                self.reactions_at(body, &[chain::ChainJoint { rate, ..joint }]).map(|all| all[n].dot(&along))
            };
            let (Some(still), Some(turning)) = (force(0.0), force(rate)) else { continue };
            let square = still / (still - turning) * rate.powi(2);
            let grows = (still - turning).abs() > 1e-12 * (still.abs() + turning.abs());
            if !(grows && square > 0.0 && square.is_finite()) {
                continue;
            }
            let how =
                "Speed at which the force of {name} is zero: its static part plus a part proportional to ω²";
            let speed =
                sheet.numerical(("ω_0", n + 1), "rad/s", square.sqrt(), Named(how, &support.name, None));
            sheet.answer(("unloaded_speed", n + 1), "Speed at which the support force is zero", speed);
            sheet.row_label(("unloaded_speed", n + 1), &support.name);
            sheet.verify(|| {
                let left = force(speed.value()).unwrap_or(f64::NAN);
                sheet.check_zero(
                    Text::new("the force of {name} at the speed at which it vanishes")
                        .with("name", &support.name),
                    W::Num::from(left),
                    still,
                );
            });
        }
    }

    /// Weight, loads, inertia force and couple, in the axes of the supports.
    fn known(&self, body: &MassProperties, frames: &[ChainFrame]) -> Wrench {
        let axes = &frames[self.axes.place()];
        let last = &frames[frames.len() - 1];
        let point = last.point(body.centre);
        let tensor = rigid::turned(&body.inertia, &last.rotation);
        let momentum = tensor * last.angular_velocity;
        let rate = tensor * last.angular_acceleration + last.angular_velocity.cross(&momentum);
        let force = (self.gravity - point.acceleration) * body.mass;
        let place = seen_from(axes, point.place - axes.origin);
        let mut sum =
            Wrench::force_at(seen_from(axes, force), place) + Wrench::couple(-seen_from(axes, rate));
        for load in &self.loads {
            sum = sum
                + match load.acts {
                    Acts::Force { force, at } => Wrench::force_at(force, at),
                    Acts::Couple { moment } => Wrench::couple(moment),
                };
        }
        sum
    }

    /// Reactions over a turn of the first joint, and against its speed.
    pub(super) fn plots<W: Worksheet>(&self, body: &MassProperties, acceleration: f64, sheet: W) {
        let now = self.joints_with(acceleration);
        sheet.show(|| Exhibit::Plot(self.over_a_turn(body, &now)));
        if let [joint] = now[..]
            && joint.rate != 0.0
        {
            sheet.show(|| Exhibit::Plot(self.against_speed(body, joint)));
        }
    }

    fn over_a_turn(&self, body: &MassProperties, now: &[chain::ChainJoint]) -> Plot {
        let shown = self.supports.len().min(2);
        let mut curves: Vec<[Vec<(f64, f64)>; 3]> = vec![Default::default(); shown];
        for n in 0..=72 {
            let angle = TAU * f64::from(n) / 72.0;
            let mut joints = now.to_vec();
            joints[0].angle = angle;
            let Some(found) = self.reactions_at(body, &joints) else { continue };
            for (curve, force) in curves.iter_mut().zip(&found) {
                curve.iter_mut().zip(force.iter()).for_each(|(curve, x)| curve.push((angle, *x)));
            }
        }
        let largest = curves.iter().flatten().flatten().map(|(_, x)| x.abs()).fold(0.0f64, f64::max);
        let mut series = Vec::new();
        // Without other axes, the axes of the answers are the fixed ones.
        let answer = if self.axes.place() > 0 { "fixed_reaction" } else { "reaction" };
        for ((support, components), row) in self.supports.iter().zip(curves).zip(1..) {
            let names = [("{name}, X", "x"), ("{name}, Y", "y"), ("{name}, Z", "z")];
            for ((name, axis), curve) in names.into_iter().zip(components) {
                if curve.iter().any(|(_, x)| x.abs() > 1e-9 * largest) {
                    let label = Text::new(name).with("name", &support.name);
                    series.push(Series::line(label, curve).of(format_args!("{answer}[{row}].{axis}")));
                }
            }
        }
        Plot::new(
            Text::new("Reactions in the fixed axes over one revolution of {name}")
                .with("name", &self.joints[0].name),
            Axis::linear("angle", "deg"),
            Axis::linear("force", "N"),
            series,
        )
        .over("joints[1].motion.now.angle")
    }

    fn against_speed(&self, body: &MassProperties, joint: chain::ChainJoint) -> Plot {
        let mut curves: Vec<Vec<(f64, f64)>> = vec![Vec::new(); self.supports.len().min(4)];
        let mut now = None;
        for n in 0..=60 {
            let speed = joint.rate * 1.5 * f64::from(n) / 60.0;
            let Some(found) = self.reactions_at(body, &[chain::ChainJoint { rate: speed, ..joint }]) else {
                continue;
            };
            if n == 40 {
                now = found.first().map(|force| (speed.abs(), force.norm()));
            }
            for (curve, force) in curves.iter_mut().zip(&found) {
                curve.push((speed.abs(), force.norm()));
            }
        }
        let named = |((support, curve), row): ((&super::Support, Vec<(f64, f64)>), usize)| {
            Series::line(given_name(&support.name), curve).of(Name::from(("reaction_size", row)))
        };
        let plot = Plot::new(
            "Magnitudes of the reactions against the speed",
            Axis::linear("speed", "rpm"),
            Axis::linear("force", "N"),
            self.supports.iter().zip(curves).zip(1..).map(named).collect(),
        )
        .over("joints[1].motion.now.rate");
        match now {
            Some(at) => plot.mark("at this speed", at),
            None => plot,
        }
    }

    /// Axes, supports with their reactions, G with the angular velocity.
    pub(super) fn drawing(&self, body: &MassProperties, frames: &[ChainFrame], found: &Found) -> Exhibit {
        let mut scene = Scene::new();
        let axes = &frames[self.axes.place()];
        let last = &frames[frames.len() - 1];
        let here = |fixed: Vector3<f64>| seen_from(axes, fixed - axes.origin);
        let centre = here(last.point(body.centre).place);
        let reach = self.supports.iter().map(|support| support.at.norm()).fold(centre.norm(), f64::max);
        let reach = if reach > 0.0 { reach } else { 1.0 };
        scene.axes(Vector3::zeros(), &nalgebra::Matrix3::identity(), reach * 0.4, ["x", "y", "z"]);
        let joint = joints::later(&self.joints, 0.0)[self.joints.len() - 1];
        let axis = seen_from(axes, last.rotation * (joint.axis / joint.axis.amax()).normalize());
        let origin = here(last.origin);
        scene.line([origin - axis * reach * 0.3, origin + axis * reach * 1.2], Ink::Faint);
        joints::draw(&self.joints, frames, axes, 0.6 * reach, &mut scene);
        self.body.draw_parts(&mut scene, |point| here(last.point(point).place));
        if let ShaftDrive::Couple { .. } = self.drive {
            scene.turn("T", origin - axis * reach * 0.2, axis, 0.15 * reach, Ink::Force);
        }
        for load in &self.loads {
            let along = |vector: Vector3<f64>| vector.normalize() * (0.5 * reach);
            match load.acts {
                Acts::Force { force, at } if force.norm() > 0.0 => {
                    scene.arrow(at, along(force), Ink::Force, given_name(&load.name));
                }
                Acts::Couple { moment } if moment.norm() > 0.0 => {
                    scene.turn(given_name(&load.name), centre, moment, 0.2 * reach, Ink::Force);
                }
                _ => {}
            }
        }
        scene.label(centre, "G");
        let largest = found.supports.iter().map(|of| of.force.norm()).fold(0.0f64, f64::max);
        for ((support, of), row) in self.supports.iter().zip(&found.supports).zip(1..) {
            if matches!(support.kind, SupportKind::Bearing { .. } | SupportKind::ThrustBearing) {
                bearing(&mut scene, support.at, axis, 0.08 * reach);
            }
            scene.label(support.at, given_name(&support.name));
            if largest > 0.0 && of.force.norm() > 1e-9 * largest {
                let along = of.force * (reach * 0.6 / largest);
                scene.arrow(support.at, along, Ink::Force, flat::of_row(&["R"], row));
            }
        }
        let omega = seen_from(axes, last.angular_velocity);
        if omega.norm() > 0.0 {
            scene.arrow(centre, omega.normalize() * reach * 0.4, Ink::Motion, "ω");
        }
        scene.exhibit("The body on its supports")
    }
}

/// A bearing of a shaft: a bar on either side of it, along it.
fn bearing(scene: &mut Scene, at: Vector3<f64>, axis: Vector3<f64>, half: f64) {
    for side in scene::across(axis).into_iter().flat_map(|across| [across, -across]) {
        let middle = at + side * (0.5 * half);
        scene.line([middle - axis * half, middle + axis * half], Ink::Body);
    }
}
