//! A chain of joints as a user describes it, and its angular velocities and accelerations worked joint by joint.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Cite, Ink, Inputs, Reason, Reference, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, RigidError, chain},
};
use nalgebra::Vector3;

use crate::{
    shared::{flat, scene::Scene},
    sources::BEER,
};

/// A joint: the frame after it turns about an axis of the frame before it.
#[derive(Clone, Debug, Inputs)]
pub struct Joint {
    /// Name of the joint and of the frame after it.
    pub name: String,
    /// Axis.
    /// Any vector along it, in the preceding frame; angles are positive by the right-hand rule.
    #[input("a_j", "1")]
    pub axis: Vector3<f64>,
    /// Motion of the joint.
    pub motion: JointRotation,
    /// Origin of the frame after the joint.
    /// In the axes of the preceding frame.
    #[input("d", "m", default = "(0; 0; 0) m")]
    pub offset: Vector3<f64>,
}

/// Rotation of a joint.
#[derive(Clone, Debug, Inputs)]
pub enum JointRotation {
    /// Values at this instant
    Now {
        /// Angle.
        #[input("θ", "rad", default = "0 deg")]
        angle: f64,
        /// Angular velocity.
        /// Relative to the preceding frame.
        #[input("θ̇", "rad/s", default = "0 rad/s")]
        rate: f64,
        /// Angular acceleration.
        /// Relative to the preceding frame.
        #[input("θ̈", "rad/s^2", default = "0 rad/s^2")]
        acceleration: f64,
    },
    /// Harmonic oscillation: pitch or roll
    Harmonic {
        /// Amplitude.
        #[input("A", "rad")]
        amplitude: f64,
        /// Period.
        #[input("T", "s", positive)]
        period: f64,
        /// Time since the upward passage through mid-position.
        #[input("t", "s", default = "0 s")]
        time: f64,
        /// Mean angle.
        #[input("θ_m", "rad", default = "0 deg")]
        middle: f64,
    },
    /// Turn of a vehicle on a circle
    Circle {
        /// Speed.
        /// Positive by the right-hand rule about the axis.
        #[input("v", "m/s")]
        speed: f64,
        /// Radius of the circle.
        #[input("R", "m", positive)]
        radius: f64,
        /// Acceleration along the path.
        #[input("v̇", "m/s^2", default = "0 m/s^2")]
        acceleration: f64,
        /// Angle of rotation so far.
        #[input("θ", "rad", default = "0 deg")]
        angle: f64,
    },
}

impl Joint {
    /// The joint as the kernel knows it.
    pub(crate) fn plain(&self) -> chain::ChainJoint {
        let (angle, rate, acceleration) = match self.motion {
            JointRotation::Now { angle, rate, acceleration } => (angle, rate, acceleration),
            JointRotation::Harmonic { amplitude, period, time, middle } => {
                let speed = TAU / period;
                let phase = TAU * time / period;
                let swing = amplitude * phase.sin();
                (middle + swing, amplitude * speed * phase.cos(), -(speed.powi(2) * swing))
            }
            JointRotation::Circle { speed, radius, acceleration, angle } => {
                (angle, speed / radius, acceleration / radius)
            }
        };
        chain::ChainJoint { axis: self.axis, angle, rate, acceleration, offset: self.offset }
    }
}

/// The axes in which vectors are written.
#[derive(Clone, Debug, Inputs)]
pub enum Axes {
    /// Fixed axes
    Fixed,
    /// Axes of a frame
    Frame {
        /// Frame of the chain.
        #[input(rows = "joints")]
        frame: Reference,
    },
}

impl Axes {
    /// The place of the frame among all, the fixed one first.
    pub(crate) fn place(&self) -> usize {
        match self {
            Axes::Fixed => 0,
            Axes::Frame { frame } => frame.0 + 1,
        }
    }
}

/// All frames of a chain, the fixed one first.
///
/// # Errors
/// A refusal that names the joint.
pub(crate) fn frames(joints: &[Joint]) -> Result<Vec<chain::ChainFrame>, Refusal> {
    let mut all = vec![chain::ChainFrame::fixed()];
    for joint in joints {
        let next = all[all.len() - 1].next(&joint.plain()).map_err(|error| {
            Refusal::NoAnswer(
                Text::new(match error {
                    RigidError::Direction => {
                        "the axis of {name} has no length: write any vector along it, such as (0; 0; 1)"
                    }
                    RigidError::NotFinite => {
                        "the motion of {name} exceeds the numerical range: check its units"
                    }
                })
                .with("name", &joint.name),
            )
        })?;
        all.push(next);
    }
    Ok(all)
}

/// The joints with their motion a time `t` later.
pub(crate) fn later(joints: &[Joint], t: f64) -> Vec<chain::ChainJoint> {
    joints.iter().map(|joint| joint.plain().after(t)).collect()
}

/// Draws the axes of joints with their letters, in the axes of one of their frames.
pub(crate) fn draw(
    joints: &[Joint],
    frames: &[chain::ChainFrame],
    axes: &chain::ChainFrame,
    length: f64,
    scene: &mut Scene,
) {
    let here = |point: Vector3<f64>| seen_from(axes, point - axes.origin);
    for ((joint, pair), row) in joints.iter().zip(frames.windows(2)).zip(1..) {
        let [before, frame] = pair else { continue };
        // The frames have been found sound: every axis has a length.
        let axis = seen_from(axes, frame.rotation * (joint.axis / joint.axis.amax()).normalize());
        let (from, at) = (here(before.origin), here(frame.origin));
        scene.line([-0.4, 0.8].map(|end| at + axis * length * end), Ink::Body);
        let motion: &[&'static str] = match joint.motion {
            JointRotation::Now { .. } => &["θ", "θ̇"],
            JointRotation::Harmonic { .. } => &["A", "T"],
            JointRotation::Circle { .. } => &["v", "R", "θ"],
        };
        let turn = axis * length * (0.55 + 0.2 * ((row - 1) % 2) as f64);
        scene.turn(flat::of_row(motion, row), at + turn, axis, 0.16 * length, Ink::Motion);
        // What the joint turns, across its axis.
        scene.circle(at, axis, if row == joints.len() { 0.25 } else { 0.12 } * length, Ink::Body);
        if (at - from).norm() > 1e-9 * length {
            scene.dimension(flat::of_row(&["d"], row), [from, at], Vector3::zeros());
        }
    }
}

/// A name that a user gave: it stands as it is in every language.
pub(crate) fn given_name(name: &str) -> Text {
    Text::new("{given_name}").with("given_name", name)
}

/// A reason with names in it; written only where somebody reads it.
pub(crate) struct Named<'a>(pub &'static str, pub &'a str, pub Option<Cite>);

impl From<Named<'_>> for Reason {
    fn from(Named(reason, name, cite): Named<'_>) -> Self {
        Reason { reason: Text::new(reason).with("name", name), cite }
    }
}

/// A reason with two names in it.
struct Between<'a>(&'static str, &'a str, &'a str);

impl From<Between<'_>> for Reason {
    fn from(Between(reason, name, by): Between<'_>) -> Self {
        Text::new(reason).with("name", name).with("by", by).into()
    }
}

/// The angular motion of all frames of a chain, in the axes of one of them.
pub(crate) struct WorkedChain<'a, W: Worksheet> {
    joints: &'a [Joint],
    /// Unit vectors along the axes of the joints, each in the frames beside its joint.
    own: Vec<W::Vec>,
    angles: Vec<W::Num>,
    /// The frame whose axes are used: 0 for the fixed one.
    pub axes: usize,
    /// Angular velocity of each frame; zero for the fixed one.
    pub omega: Vec<W::Vec>,
    /// Angular acceleration of each frame.
    pub alpha: Vec<W::Vec>,
    /// Unit vector along the axis of the last joint, in the axes used.
    pub last_axis: W::Vec,
}

impl<'a, W: Worksheet> WorkedChain<'a, W> {
    /// Works the chain in the axes of frame `axes` (0 for the fixed ones), which [`frames`] has found sound.
    pub(crate) fn new(joints: &'a [Joint], given: &[JointGiven<W>], axes: usize, sheet: W) -> Self {
        let motions: Vec<[W::Num; 3]> = (1..).zip(given).map(|(n, given)| motion(n, given, sheet)).collect();
        let own = joints
            .iter()
            .zip(given)
            .enumerate()
            .map(|(n, (joint, given))| {
                if joint.axis.norm_squared() == 1.0 {
                    return given.axis;
                }
                let along = given.axis / given.axis.magnitude();
                let why =
                    Named("Unit vector along the axis of {name}, in the preceding frame", &joint.name, None);
                sheet.step_vector(("u", n + 1), "1", along, why)
            })
            .collect();
        let angles = motions.iter().map(|[angle, ..]| *angle).collect();
        let zero = W::Num::from(0.0);
        let still = W::Vec::from_components(zero, zero, zero);
        let (omega, alpha) = (vec![still], vec![still]);
        let mut this = Self { joints, own, angles, axes, omega, alpha, last_axis: still };
        for (n, joint) in joints.iter().enumerate() {
            let [_, rate, acceleration] = motions[n];
            // The axis is the same in the frames on both sides of the joint: that nearer to the axes used is taken.
            let from = if axes > n { n + 1 } else { n };
            let axis = this.expressed(
                this.own[n],
                from,
                (["e_u", "e_u′", "e_u″", "e_u‴"], n + 1, "1"),
                ("Axis of {name}, in axes rotated by {by}", &joint.name),
                sheet,
            );
            this.last_axis = axis;
            let (before, turning) = (this.alpha[n], this.omega[n]);
            let omega = if n == 0 { axis * rate } else { turning + axis * rate };
            // What is at rest or turns steadily is not written down.
            let own = (n == 0 || acceleration.value() != 0.0).then(|| axis * acceleration);
            let carried = (n > 0).then(|| turning.cross(axis * rate));
            let before = (before.value() != Vector3::zeros()).then_some(before);
            let alpha = before
                .into_iter()
                .chain(own)
                .chain(carried)
                .reduce(|sum, term| sum + term)
                .expect("the first joint has an acceleration of its own, the others are carried");
            this.omega.push(sheet.step_vector(
                ("ω", n + 1),
                "rad/s",
                omega,
                Named(
                    if n == 0 {
                        "Angular velocity of {name}, about its fixed axis"
                    } else {
                        "Angular velocity of {name}: relative angular velocities add"
                    },
                    &joint.name,
                    Some(BEER.at("§15.5A")),
                ),
            ));
            this.alpha.push(sheet.step_vector(
                ("α", n + 1),
                "rad/s^2",
                alpha,
                Named(
                    if n == 0 {
                        "Angular acceleration of {name}, about its fixed axis"
                    } else {
                        "Angular acceleration of {name}: the joint axis is itself rotated by the preceding frame"
                    },
                    &joint.name,
                    Some(BEER.at("§15.5A")),
                ),
            ));
        }
        this
    }

    /// Velocity and acceleration of the origin of every frame, the fixed one first; `None` where it is at rest. The
    /// velocities are written down if they are asked for.
    pub(crate) fn origins(
        &self,
        given: &[JointGiven<W>],
        velocities: bool,
        sheet: W,
    ) -> Vec<Option<[W::Vec; 2]>> {
        let mut origins: Vec<Option<[W::Vec; 2]>> = vec![None];
        for (n, (joint, this)) in self.joints.iter().zip(given).enumerate() {
            let mut origin = origins[n];
            // The origin of the first frame is carried by the fixed one.
            if n > 0 && joint.offset != Vector3::zeros() {
                let arm = self.expressed(
                    this.offset,
                    n,
                    (["δ", "δ′", "δ″", "δ‴"], n + 1, "m"),
                    (
                        "Position of the origin of {name} in the preceding frame, in axes rotated by {by}",
                        &joint.name,
                    ),
                    sheet,
                );
                let (velocity, acceleration) = carried(origin, self.omega[n], self.alpha[n], arm);
                let named = |reason| Named(reason, &joint.name, Some(BEER.at("§15.5B")));
                let velocity = if velocities {
                    let why = named("Velocity of the origin of {name}");
                    sheet.step_vector(("v_O", n + 1), "m/s", velocity, why)
                } else {
                    velocity
                };
                let why = named("Acceleration of the origin of {name}");
                origin = Some([velocity, sheet.step_vector(("a_O", n + 1), "m/s^2", acceleration, why)]);
            }
            origins.push(origin);
        }
        origins
    }

    /// A vector with components in frame `from`, in the axes used; the last of `symbols` first.
    pub(crate) fn expressed(
        &self,
        vector: W::Vec,
        from: usize,
        (symbols, row, unit): ([&'static str; 4], usize, &'static str),
        (reason, name): (&'static str, &str),
        sheet: W,
    ) -> W::Vec {
        let turns: Vec<(usize, bool)> = if self.axes > from {
            (from..self.axes).map(|joint| (joint, true)).collect()
        } else {
            (self.axes..from).rev().map(|joint| (joint, false)).collect()
        };
        // Turns that change nothing are left out.
        let mut value = vector.value();
        let turns: Vec<(usize, bool)> = turns
            .into_iter()
            .filter(|&(joint, back)| {
                let angle = if back { -self.angles[joint].value() } else { self.angles[joint].value() };
                let before = value;
                value = chain::turned_about(self.own[joint].value(), angle, value);
                angle != 0.0 && (value - before).amax() > 1e-15 * before.amax()
            })
            .collect();
        let mut vector = vector;
        for (place, &(joint, back)) in turns.iter().enumerate() {
            let angle = if back { -self.angles[joint] } else { self.angles[joint] };
            let left = (turns.len() - 1 - place).min(3);
            vector = sheet.step_vector(
                (symbols[left], row),
                unit,
                chain::turned_about(self.own[joint], angle, vector),
                Between(reason, name, &self.joints[joint].name),
            );
        }
        vector
    }
}

/// Velocity and acceleration at the end of an arm from an origin that moves, or is at rest.
pub(crate) fn carried<V: Vector>(origin: Option<[V; 2]>, omega: V, alpha: V, arm: V) -> (V, V) {
    let towards_the_axis = omega.cross(omega.cross(arm));
    // What does not speed up is not written down.
    let turning = (alpha.value() != Vector3::zeros()).then(|| alpha.cross(arm));
    let about = turning.map_or(towards_the_axis, |turning| turning + towards_the_axis);
    match origin {
        Some([velocity, acceleration]) if arm.value() == Vector3::zeros() => (velocity, acceleration),
        None => (omega.cross(arm), about),
        Some([velocity, acceleration]) => {
            (rigid::velocity_of_point(velocity, omega, arm), acceleration + about)
        }
    }
}

const IN_DEGREES: &str = "the phase in radians evaluated with the calculator in degrees";

/// Angle, rate and acceleration of joint `n`, counted from 1.
fn motion<W: Worksheet>(n: usize, given: &JointGiven<W>, sheet: W) -> [W::Num; 3] {
    match given.motion {
        JointRotationGiven::Now { angle, rate, acceleration } => [angle, rate, acceleration],
        JointRotationGiven::Harmonic { amplitude, period, time, middle } => {
            let turn = W::Num::from(TAU);
            let speed = sheet.step(("p", n), "rad/s", turn / period, "Angular frequency of the oscillation");
            let phase = turn * time / period;
            let swing = amplitude * phase.sin();
            let wrong = || phase * (PI / 180.0);
            sheet.common_error(("θ", n), IN_DEGREES, || middle + amplitude * wrong().sin());
            sheet.common_error(("θ̇", n), IN_DEGREES, || amplitude * speed * wrong().cos());
            sheet.common_error(("θ̈", n), IN_DEGREES, || -(speed.powi(2) * amplitude * wrong().sin()));
            [
                sheet.step(("θ", n), "deg", middle + swing, "Angle of the oscillation at this time"),
                sheet.step(
                    ("θ̇", n),
                    "rad/s",
                    amplitude * speed * phase.cos(),
                    "Angular velocity of the oscillation",
                ),
                sheet.step(
                    ("θ̈", n),
                    "rad/s^2",
                    -(speed.powi(2) * swing),
                    "Angular acceleration of the oscillation",
                ),
            ]
        }
        JointRotationGiven::Circle { speed, radius, acceleration, angle } => [
            angle,
            sheet.step(("θ̇", n), "rad/s", speed / radius, "The vehicle rotates once per lap of the circle"),
            sheet.step(("θ̈", n), "rad/s^2", acceleration / radius, "Angular acceleration of the vehicle"),
        ],
    }
}

/// Components in the axes of `frame`, of a vector in the fixed axes.
pub(crate) fn seen_from(frame: &chain::ChainFrame, vector: Vector3<f64>) -> Vector3<f64> {
    frame.rotation.inverse() * vector
}

/// A second method to angular velocities and accelerations: the orientation of the frame at other times, by
/// differences. In the fixed axes.
pub(crate) fn rates_by_differences(
    joints: &[Joint],
    frame: usize,
) -> Result<(Vector3<f64>, Vector3<f64>), RigidError> {
    let period = chain::period(&later(joints, 0.0));
    let at = |t: f64| chain::frames(&later(joints, t)).map(|all| all[frame]);
    let now = at(0.0)?;
    // ω = ½ Σ e × ė over the three axes of the frame.
    let mut omega = Vector3::zeros();
    for n in 0..3 {
        let axis =
            |frame: chain::ChainFrame| -> Vector3<f64> { frame.rotation.matrix().column(n).into_owned() };
        let rate = rigid::numerical_rate(|t| at(t).map_or_else(|_| Vector3::repeat(f64::NAN), axis), period)?;
        omega += nalgebra::Matrix::cross(&axis(now), &rate) / 2.0;
    }
    let alpha = rigid::numerical_rate(
        |t| at(t).map_or_else(|_| Vector3::repeat(f64::NAN), |frame| frame.angular_velocity),
        period,
    )?;
    Ok((omega, alpha))
}
