//! Reactions of the supports of a body that turns about a shaft or on a chain of joints.

mod pictures;
mod second_methods;
mod supports;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, MassProperties, chain, supports::Wrench},
};
use nalgebra::{Rotation3, Vector3};

use crate::{
    shared::{
        body::Body,
        inertia::WorkedInertia,
        joints::{self, Axes, Joint, Named, WorkedChain, seen_from},
    },
    sources::{BEER, HIBBELER, KHURMI, MERIAM, RIUL},
};
use second_methods::ReactionParts;
use supports::{Held, common_errors};

pub use supports::{Support, SupportGiven, SupportKind, SupportKindGiven};

/// A rigid body whose motion is given, its supports and its loads.
///
/// The body turns with the last joint, and its parts are given in the axes of that frame. Supports, loads and
/// reactions are in the axes chosen for them, from the origin of these: those of the shaft, or the fixed ones.
#[derive(Clone, Debug, Inputs)]
pub struct Reactions {
    /// Body.
    pub body: Body,
    /// Joints that move it.
    /// One for a body on a shaft; a chain for a body carried by a moving support.
    #[input(min = 1)]
    pub joints: Vec<Joint>,
    /// Drive of the last joint.
    pub drive: ShaftDrive,
    /// Axes of supports, loads and reactions.
    pub axes: Axes,
    /// Supports.
    #[input(min = 1)]
    pub supports: Vec<Support>,
    /// Loads.
    pub loads: Vec<AppliedLoad>,
    /// Acceleration of gravity, in the fixed axes.
    /// Zero to neglect the weight.
    #[input("g", "m/s^2", default = "(0; 0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
}

/// Given quantity of the drive.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftDrive {
    /// Given motion; its couple is calculated
    Motion,
    /// Given couple about the axis; the acceleration is calculated
    Couple {
        /// Couple about the axis of the last joint.
        /// Zero for a body that turns freely.
        #[input("T", "N*m", default = "0 N*m")]
        couple: f64,
    },
}

/// A load besides the weight.
#[derive(Clone, Debug, Inputs)]
pub struct AppliedLoad {
    /// Name.
    pub name: String,
    /// Type of load.
    pub acts: Acts,
}

/// A force or a couple.
#[derive(Clone, Debug, Inputs)]
pub enum Acts {
    /// A force
    Force {
        /// Force.
        #[input("F", "N")]
        force: Vector3<f64>,
        /// Point of application.
        #[input("r_F", "m")]
        at: Vector3<f64>,
    },
    /// A couple
    Couple {
        /// Moment.
        #[input("M", "N*m")]
        moment: Vector3<f64>,
    },
}

register!(Reactions);

impl Analysis for Reactions {
    const ABOUT: About = About {
        id: "rigid-body/reactions",
        title: "Reactions on a rotating body",
        topic: "Bodies on rotating shafts",
        summary: "Forces and couples of bearings, hinges, welds, wires and contacts on a body that turns about a shaft or on a chain of joints, by d'Alembert.",
        main: &["reaction", "reaction_size", "tension", "normal_force", "drive_couple"],
        keywords: "dynamic reactions bearings ball joint socket unbalance shaft plate rod reações dinâmicas mancais mancal rótula pino engaste cabo fio contato \
                   d'Alembert binário motor giroscópico desbalanceamento estática isostático hiperestático",
        sources: &[&BEER, &RIUL, &MERIAM, &HIBBELER, &KHURMI],
        cases: include_str!("../../cases/reactions.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ReactionsGiven<W>, sheet: W) -> Result<(), Refusal> {
        let body = self.body.properties()?;
        let frames = joints::frames(&self.joints)?;
        if matches!(self.drive, ShaftDrive::Couple { .. })
            && self.joints.last().is_some_and(|joint| joint.plain().acceleration != 0.0)
        {
            return Err(Refusal::because(
                "the driving torque is given, and the acceleration of the last joint too: leave that at zero, or let the torque be calculated",
            ));
        }
        let axes = self.axes.place();
        let held = Held::new(self, &frames)?;
        let motion = self.motion(given, &body, &frames, sheet);
        let loads = self.loads(given, &motion, sheet);
        let moved = self.driven(given, &motion, loads, &held, sheet)?;
        let reactions = self.reactions(given, &motion, loads, &moved, &held, sheet)?;
        self.unloading(&body, &frames[axes], moved.joint_acceleration, sheet);
        sheet.keep_going()?;
        sheet.verify(|| self.check_by_differences(&body, &moved, &reactions, &frames[axes], sheet));
        sheet.show(|| Exhibit::Table(held.table(self, &reactions)));
        sheet.show(|| self.drawing(&body, &frames, &reactions));
        self.plots(&body, moved.joint_acceleration, sheet);
        Ok(())
    }
}

/// The motion of the body in the axes of the supports.
struct ShaftMotion<'a, W: Worksheet> {
    worked: WorkedChain<'a, W>,
    mass: W::Num,
    inertia: WorkedInertia<W>,
    /// From the origin of the axes to G.
    centre: W::Vec,
    /// From the origin of the last frame to G.
    arm: W::Vec,
    /// From the origin of the axes to that of the last frame.
    origin: Vector3<f64>,
    /// From the axes of the supports to the fixed ones.
    to_fixed: Rotation3<f64>,
    momentum: W::Vec,
    /// Acceleration of G.
    acceleration: W::Vec,
    alpha: W::Vec,
}

/// The motion with the acceleration that a given couple brings.
struct Moved<W: Worksheet> {
    acceleration: W::Vec,
    rate: W::Vec,
    /// Acceleration of the last joint, rad/s².
    joint_acceleration: f64,
    /// The given couple.
    couple: Option<W::Num>,
}

/// Forces known beforehand, and their moments about the origin of the axes.
#[derive(Clone, Copy)]
struct Known<W: Worksheet> {
    force: Option<W::Vec>,
    moment: Option<W::Vec>,
}

impl<W: Worksheet> Known<W> {
    fn plain(self) -> Wrench {
        let value = |vector: Option<W::Vec>| vector.map_or_else(Vector3::zeros, Vector::value);
        Wrench { force: value(self.force), moment: value(self.moment) }
    }
}

/// Results for the supports.
struct Found {
    /// Force and couple of each support.
    supports: Vec<Wrench>,
    /// The same of the known loads, and of the drive; about the origin of the axes.
    known: Wrench,
    drive: Wrench,
    /// The sum of the reactions in the fixed axes, where these are others.
    fixed: Option<Vector3<f64>>,
}

impl Reactions {
    fn motion<'a, W: Worksheet>(
        &'a self,
        given: &ReactionsGiven<W>,
        body: &MassProperties,
        frames: &[chain::ChainFrame],
        sheet: W,
    ) -> ShaftMotion<'a, W> {
        let axes = self.axes.place();
        let last = &frames[self.joints.len()];
        let turned = body.turned(&(frames[axes].rotation.inverse() * last.rotation));
        let origin = seen_from(&frames[axes], last.origin - frames[axes].origin);
        let mass = sheet.numerical("m", "kg", turned.mass, "Mass of the whole body");
        let arm = sheet.numerical_vector(
            "ρ_G",
            "m",
            turned.centre,
            "Centre of mass G from the origin of the last frame, in the axes of the supports",
        );
        let centre = if origin == Vector3::zeros() {
            arm
        } else {
            let why = "Centre of mass G from the origin of the axes of the supports";
            sheet.numerical_vector("r_G", "m", turned.centre + origin, why)
        };
        let inertia = WorkedInertia::found(&turned.inertia, sheet);
        let worked = WorkedChain::new(&self.joints, &given.joints, axes, sheet);
        let n = self.joints.len();
        let (omega, alpha) = (worked.omega[n], worked.alpha[n]);
        let base = worked.origins(&given.joints, false, sheet)[n];
        let (_, acceleration) = joints::carried(base, omega, alpha, arm);
        let acceleration = sheet.step_vector(
            if matches!(self.drive, ShaftDrive::Motion) { "a_G" } else { "a_0" },
            "m/s^2",
            acceleration,
            match self.drive {
                ShaftDrive::Motion => ("Acceleration of the centre of mass", BEER.at("§15.5B")),
                ShaftDrive::Couple { .. } => {
                    ("Acceleration of the centre of mass excluding that of the last joint", BEER.at("§15.5B"))
                }
            },
        );
        let momentum = inertia.momentum(omega, sheet);
        let to_fixed = frames[axes].rotation;
        ShaftMotion { worked, mass, inertia, centre, arm, origin, to_fixed, momentum, acceleration, alpha }
    }

    /// Weight and loads.
    fn loads<W: Worksheet>(
        &self,
        given: &ReactionsGiven<W>,
        motion: &ShaftMotion<'_, W>,
        sheet: W,
    ) -> Known<W> {
        let (mut forces, mut moments) = (Vec::new(), Vec::new());
        if self.gravity != Vector3::zeros() {
            let gravity = motion.worked.expressed(
                given.gravity,
                0,
                (["g′", "g″", "g‴", "g⁗"], 0, "m/s^2"),
                ("Acceleration of gravity in axes rotated by {by}", ""),
                sheet,
            );
            let weight = sheet.step_vector("W", "N", gravity * motion.mass, "Weight of the body, at G");
            forces.push(weight);
            if motion.centre.value() != Vector3::zeros() {
                moments.push(rigid::moment_of_force(motion.centre, weight));
            }
        }
        for load in &given.loads {
            match load.acts {
                ActsGiven::Force { force, at } => {
                    forces.push(force);
                    moments.push(rigid::moment_of_force(at, force));
                }
                ActsGiven::Couple { moment } => moments.push(moment),
            }
        }
        let force = (!forces.is_empty())
            .then(|| sheet.step_vector("F_L", "N", W::Vec::sum(forces), "Sum of weight and loads"));
        let moment = (!moments.is_empty()).then(|| {
            let why = "Moment of weight and loads about the origin of the axes of the supports";
            sheet.step_vector("M_L", "N*m", W::Vec::sum(moments), why)
        });
        Known { force, moment }
    }

    /// Takes in the acceleration of the last joint, where the couple of its drive is given.
    fn driven<W: Worksheet>(
        &self,
        given: &ReactionsGiven<W>,
        motion: &ShaftMotion<'_, W>,
        loads: Known<W>,
        held: &Held<'_>,
        sheet: W,
    ) -> Result<Moved<W>, Refusal> {
        let omega = motion.worked.omega[self.joints.len()];
        // (dH/dt) relative to the axes of the body, and Ω × H with these.
        let sum = |symbols: [&'static str; 2], alpha: W::Vec, why: &'static str| {
            let turned = rigid::transport_rate(omega, motion.momentum);
            let turned = if alpha.value() == Vector3::zeros() {
                turned
            } else {
                let seen = sheet.step_vector(
                    symbols[0],
                    "N*m",
                    motion.inertia.times(alpha),
                    ("Rate of change relative to axes rotating with the body", RIUL.at("eq. 47")),
                );
                seen + turned
            };
            sheet.step_vector(symbols[1], "N*m", turned, (why, RIUL.at("eqs. 42–44")))
        };
        let rate_with = |alpha: W::Vec| {
            let why =
                "Rate of change of the angular momentum about G, with Ω × H for axes rotating with the body";
            sum(["Ḣ_rel", "Ḣ_G"], alpha, why)
        };
        let last = &self.joints[self.joints.len() - 1];
        let ShaftDriveGiven::Couple { couple } = given.drive else {
            return Ok(Moved {
                acceleration: motion.acceleration,
                rate: rate_with(motion.alpha),
                joint_acceleration: last.plain().acceleration,
                couple: None,
            });
        };
        if held.against_the_drive() {
            return Err(Refusal::NoAnswer(
                Text::new("the supports hold the body against turning about {name}: use the given motion, with its acceleration")
                    .with("name", &last.name),
            ));
        }
        let (axis, arm) = (motion.worked.last_axis, motion.arm);
        let before = sum(
            ["Ḣ_rel0", "Ḣ_0"],
            motion.alpha,
            "Rate of change of the angular momentum about G without that acceleration",
        );
        let about_axis = sheet.step(
            "J",
            "kg*m^2",
            axis.dot(motion.inertia.times(axis)) + motion.mass * axis.cross(arm).magnitude().powi(2),
            ("Moment of inertia about the axis of the last joint", BEER.at("§18.1A")),
        );
        if about_axis.value()
            <= 1e-14 * (motion.inertia.size() + motion.mass.value() * arm.value().norm_squared())
        {
            return Err(Refusal::because(
                "the body has no moment of inertia about the axis of the last joint: a couple cannot determine its acceleration",
            ));
        }
        // Loads about a point of the axis: the origin of the last frame.
        let mut moment = couple;
        if let Some(sum) = loads.moment {
            moment = moment + axis.dot(sum);
        }
        if let (Some(force), true) = (loads.force, motion.origin != Vector3::zeros()) {
            let origin = sheet.numerical_vector(
                "r_O",
                "m",
                motion.origin,
                "Origin of the last frame, in the axes of the supports",
            );
            moment = moment - axis.dot(origin.cross(force));
        }
        let inertia = axis.dot(before + arm.cross(motion.acceleration * motion.mass));
        let joint_acceleration = sheet.step(
            ("θ̈_r", self.joints.len()),
            "rad/s^2",
            (moment - inertia) / about_axis,
            (
                "Moments about the axis of the last joint, about which the supports exert none: T + M − e · (Ḣ + ρ × m a) = J θ̈",
                BEER.at("§18.2"),
            ),
        );
        let name = "Angular acceleration of the body, including that of the last joint";
        let alpha = if motion.alpha.value() == Vector3::zeros() {
            axis * joint_acceleration
        } else {
            motion.alpha + axis * joint_acceleration
        };
        let alpha = sheet.step_vector("α", "rad/s^2", alpha, name);
        let acceleration = sheet.step_vector(
            "a_G",
            "m/s^2",
            motion.acceleration + (axis * joint_acceleration).cross(arm),
            "Acceleration of the centre of mass, including that of the last joint",
        );
        let rate = rate_with(alpha);
        sheet.answer("angular_acceleration", "Angular acceleration of the last joint", joint_acceleration);
        sheet.answer("axial_inertia", "Moment of inertia about the axis of the last joint", about_axis);
        Ok(Moved { acceleration, rate, joint_acceleration: joint_acceleration.value(), couple: Some(couple) })
    }

    /// The six equations, and the unknowns that solve them.
    fn reactions<W: Worksheet>(
        &self,
        given: &ReactionsGiven<W>,
        motion: &ShaftMotion<'_, W>,
        loads: Known<W>,
        moved: &Moved<W>,
        held: &Held<'_>,
        sheet: W,
    ) -> Result<Found, Refusal> {
        let force = sheet.step_vector(
            "F_in",
            "N",
            -(moved.acceleration * motion.mass),
            ("Inertia force, opposite to the acceleration of G", RIUL.at("eqs. 22–23")),
        );
        let couple = sheet.step_vector(
            "C_in",
            "N*m",
            -moved.rate,
            ("Inertia couple, opposite to the rate of change of the angular momentum", RIUL.at("eqs. 22–23")),
        );
        let all = sheet.step_vector(
            "ΣF",
            "N",
            loads.force.map_or(force, |loads| loads + force),
            "Forces to be balanced by the supports",
        );
        let mut moments: Vec<W::Vec> = loads.moment.into_iter().collect();
        if motion.centre.value() != Vector3::zeros() {
            moments.push(motion.centre.cross(force));
        }
        moments.push(couple);
        moments.extend(moved.couple.map(|couple| motion.worked.last_axis * couple));
        let moment = sheet.step_vector(
            "ΣM",
            "N*m",
            W::Vec::sum(moments),
            "Moments to be balanced by the supports, about the origin of their axes",
        );
        let known = Wrench { force: all.value(), moment: moment.value() };
        let axis = motion.worked.last_axis;
        let without = moved.couple.map(|couple| known + Wrench::couple(-(axis * couple).value()));
        let found = held.reactions(&known, moved.couple.is_none());
        // An acceleration that does not fit the given couple shows where the couple is found.
        let (supports, drive) = match (found, &without) {
            (Err(refusal), Some(without)) => held.reactions(without, true).map_err(|_| refusal)?,
            (found, _) => found?,
        };
        // Weight and loads with the body at rest, held by a couple about the axis of the last joint.
        let at_rest = held.reactions(&loads.plain(), true).ok();
        let mut without_couple = None;
        if moved.couple.is_none() {
            sheet.verify(|| {
                let forces = known + Wrench::couple(-couple.value());
                without_couple = held.reactions(&forces, true).ok();
            });
        }
        let loaded = self.gravity != Vector3::zeros() || !self.loads.is_empty();
        let mut parts = ReactionParts::default();
        let mut total = all;
        let mut turning = moment;
        for (n, (support, of)) in self.supports.iter().zip(&supports).enumerate() {
            let how =
                "Reaction of {name}, from the six equations of equilibrium with the inertia force and couple";
            let reaction = sheet.numerical_vector(
                ("F_R", n + 1),
                "N",
                of.force,
                Named(how, &support.name, Some(BEER.at("§18.2"))),
            );
            let still = at_rest.as_ref().map(|(all, _)| &all[n]);
            let mut wrong = Vec::new();
            sheet.verify(|| {
                let still = still.filter(|_| loaded).map(|of| of.force);
                let without = without_couple.as_ref().map(|(all, _)| all[n].force);
                wrong = common_errors(of.force, still, without);
            });
            for &(what, force) in &wrong {
                let share = force.norm() / of.force.norm();
                sheet.common_error(("|R|", n + 1), what, || reaction.magnitude() * share);
            }
            let size = sheet.step(
                ("|R|", n + 1),
                "N",
                reaction.magnitude(),
                Named("Magnitude of the reaction of {name}", &support.name, None),
            );
            sheet.answer_vector(("reaction", n + 1), "Reaction", reaction);
            sheet.row_label(("reaction", n + 1), &support.name);
            sheet.answer(("reaction_size", n + 1), "Magnitude of the reaction", size);
            sheet.row_label(("reaction_size", n + 1), &support.name);
            total = total + reaction;
            turning = turning + given.supports[n].at.cross(reaction);
            if held.has_couples(n) {
                let own = of.moment_about(support.at);
                let how = "Couple of {name}, from the same equations";
                let couple =
                    sheet.numerical_vector(("C", n + 1), "N*m", own, Named(how, &support.name, None));
                sheet.answer_vector(("reaction_couple", n + 1), "Support couple", couple);
                sheet.row_label(("reaction_couple", n + 1), &support.name);
                turning = turning + couple;
            }
            let fixed = motion.to_fixed * of.force;
            self.shares(n, fixed, still, reaction, &mut parts, sheet);
            held.own_numbers(n, of, reaction, &given.supports[n], &wrong, sheet);
        }
        if let (Some(drive), None) = (drive, moved.couple) {
            let how = "Driving torque about the axis of the last joint, from the same equations";
            // Not −0.
            let drive = sheet.numerical("T", "N*m", drive + 0.0, how);
            sheet.answer("drive_couple", "Driving torque", drive);
            turning = turning + motion.worked.last_axis * drive;
        }
        sheet.answer_vector("inertia_force", "Inertia force at G", force);
        sheet.answer_vector("inertia_couple", "Inertia couple", couple);
        let length = held.length().max(motion.centre.value().norm());
        let largest = supports.iter().map(|of| of.force.norm()).fold(known.force.norm(), f64::max);
        let largest_moment = supports
            .iter()
            .map(|of| of.moment.norm())
            .fold(known.moment.norm().max(largest * length).max(couple.value().norm()), f64::max);
        sheet.check_zero(
            "the forces of the supports balance all others",
            W::Num::from(total.value().norm()),
            largest,
        );
        sheet.check_zero(
            "the moments of the supports balance all others",
            W::Num::from(turning.value().norm()),
            largest_moment,
        );
        if let (Some(without), Some(couple)) = (&without, moved.couple)
            && let Ok((_, Some(drive))) = held.reactions(without, true)
        {
            let what = "the driving torque from the six equations";
            sheet.check_sum(what, couple, drive.into(), largest_moment);
        }
        if let Some((still, holding)) = &at_rest {
            let inertia = Wrench { force: force.value(), moment: couple.value() }
                + Wrench::couple(motion.centre.value().cross(force.value()));
            let holding = Wrench::couple(axis.value() * holding.unwrap_or(0.0));
            sheet.verify(|| {
                parts.check(still, loads.plain() + holding, held.reactions(&inertia, true).ok(), sheet);
            });
        }
        held.warn(self, &supports, sheet);
        let about = motion.worked.last_axis.value();
        let drive = match moved.couple {
            Some(couple) => couple.value(),
            None => drive.unwrap_or(0.0),
        };
        let known = loads.plain();
        let fixed = (self.axes.place() > 0).then(|| parts.fixed.iter().sum());
        Ok(Found { supports, known, drive: Wrench::couple(about * drive), fixed })
    }

    /// The same reaction in the fixed axes, and its parts at rest and from the motion.
    fn shares<W: Worksheet>(
        &self,
        n: usize,
        fixed: Vector3<f64>,
        at_rest: Option<&Wrench>,
        reaction: W::Vec,
        parts: &mut ReactionParts,
        sheet: W,
    ) {
        let name = &self.supports[n].name;
        if let Some(at_rest) = at_rest.filter(|_| self.gravity != Vector3::zeros() || !self.loads.is_empty())
        {
            let how = "Reaction of {name} to weight and loads at rest, with the body restrained by a couple about the last axis";
            let static_part =
                sheet.numerical_vector(("R_s", n + 1), "N", at_rest.force, Named(how, name, None));
            let dynamic = sheet.step_vector(
                ("R_d", n + 1),
                "N",
                reaction - static_part,
                Named("Dynamic part of the reaction of {name}", name, None),
            );
            sheet.answer_vector(("static_reaction", n + 1), "Static reaction", static_part);
            sheet.row_label(("static_reaction", n + 1), name);
            sheet.answer_vector(("dynamic_reaction", n + 1), "Dynamic reaction", dynamic);
            sheet.row_label(("dynamic_reaction", n + 1), name);
            parts.at_rest.push(static_part.value());
            parts.added.push(dynamic.value());
        }
        if self.axes.place() > 0 {
            let how = "Reaction of {name} in the fixed axes";
            let fixed = sheet.numerical_vector(("R_F", n + 1), "N", fixed, Named(how, name, None));
            sheet.answer_vector(("fixed_reaction", n + 1), "Reaction in the fixed axes", fixed);
            sheet.row_label(("fixed_reaction", n + 1), name);
            parts.fixed.push(fixed.value());
        }
    }

    /// The joints, the last with that acceleration.
    fn joints_with(&self, acceleration: f64) -> Vec<chain::ChainJoint> {
        let mut all = joints::later(&self.joints, 0.0);
        if let Some(last) = all.last_mut() {
            last.acceleration = acceleration;
        }
        all
    }
}
