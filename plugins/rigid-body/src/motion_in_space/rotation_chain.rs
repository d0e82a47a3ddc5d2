//! Angular velocity and acceleration at the end of a chain of joints, and the motion of points.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Reference, Refusal, Series, TableExhibit, Text,
    Worksheet,
    exhibit::{Cell, Column},
    register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, chain},
};
use nalgebra::{Matrix3, Vector3};

use crate::{
    shared::{
        joints::{self, Axes, Joint, Named, WorkedChain, given_name, seen_from},
        scene::{self, Scene},
    },
    sources::{BEER, MERIAM},
};

/// A chain of joints and the points that its frames carry.
///
/// The first joint turns about an axis of the fixed frame, each further one about an axis of the frame before it:
/// precession, nutation and spin; a shaft, an arm and a disc; a ship and its rotor. All frames coincide when all
/// angles are zero, but for their origins.
#[derive(Clone, Debug, Inputs)]
pub struct RotationChain {
    /// Joints.
    #[input(min = 1)]
    pub joints: Vec<Joint>,
    /// Points.
    pub points: Vec<Spot>,
    /// Axes of the answers.
    pub axes: Axes,
}

/// A point that a frame carries.
#[derive(Clone, Debug, Inputs)]
pub struct Spot {
    /// Name.
    pub name: String,
    /// Frame to which it is attached.
    #[input(rows = "joints")]
    pub frame: Reference,
    /// Position, in the axes of that frame.
    #[input("r", "m")]
    pub place: Vector3<f64>,
}

/// Time of the animation on the screen, s.
const SHOWN: f64 = 6.0;

register!(RotationChain);

impl Analysis for RotationChain {
    const ABOUT: About = About {
        id: "rigid-body/rotation-chain",
        title: "Chain of rotations",
        topic: "Motion in space",
        summary: "Angular velocity and acceleration of every frame of a chain of joints, and velocity and acceleration of points, in any axes.",
        main: &["angular_velocity", "angular_acceleration", "velocity", "acceleration"],
        keywords: "angular velocity acceleration precession nutation spin Euler angles precessão nutação rotação própria velocidade aceleração angular \
                   composição de rotações addition theorem arm disc braço disco ship pitch roll arfagem balanço vehicle turn",
        sources: &[&BEER, &MERIAM],
        cases: include_str!("../../cases/rotation_chain.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RotationChainGiven<W>, sheet: W) -> Result<(), Refusal> {
        let frames = joints::frames(&self.joints)?;
        let axes = self.axes.place();
        let worked = WorkedChain::new(&self.joints, &given.joints, axes, sheet);
        let last = self.joints.len();
        if last > 1 {
            for n in 1..=last {
                sheet.answer_vector(
                    ("frame_angular_velocity", n),
                    "Angular velocity of the frame",
                    worked.omega[n],
                );
                sheet.answer_vector(
                    ("frame_angular_acceleration", n),
                    "Angular acceleration of the frame",
                    worked.alpha[n],
                );
            }
        }
        sheet.verify(|| wrong_magnitudes(&worked, last, sheet));
        let speed = sheet.step(
            "ω",
            "rad/s",
            worked.omega[last].magnitude(),
            "Magnitude of the angular velocity of the last frame",
        );
        let alpha = sheet.step(
            "α",
            "rad/s^2",
            worked.alpha[last].magnitude(),
            "Magnitude of the angular acceleration of the last frame",
        );
        sheet.answer_vector("angular_velocity", "Angular velocity of the last frame", worked.omega[last]);
        sheet.answer_vector(
            "angular_acceleration",
            "Angular acceleration of the last frame",
            worked.alpha[last],
        );
        sheet.answer("angular_speed", "Magnitude of the angular velocity", speed);
        sheet.answer("angular_acceleration_size", "Magnitude of the angular acceleration", alpha);
        let points = self.points(given, &worked, sheet);
        sheet.verify(|| self.check_by_differences(&frames, &worked, &points, sheet));
        sheet.show(|| Exhibit::Table(orientation(&self.joints, &frames, axes)));
        sheet.show(|| self.animation(&frames));
        sheet.show(|| Exhibit::Plot(self.over_time(&frames[axes], axes)));
        Ok(())
    }
}

impl RotationChain {
    /// Velocity and acceleration of every point, by way of the origins of the frames.
    fn points<W: Worksheet>(
        &self,
        given: &RotationChainGiven<W>,
        worked: &WorkedChain<'_, W>,
        sheet: W,
    ) -> Vec<[W::Vec; 2]> {
        if self.points.is_empty() {
            return Vec::new();
        }
        let origins = worked.origins(&given.joints, true, sheet);
        let mut points = Vec::new();
        for (n, (point, this)) in self.points.iter().zip(&given.points).enumerate() {
            let frame = point.frame.0 + 1;
            let arm = worked.expressed(
                this.place,
                frame,
                (["ρ", "ρ′", "ρ″", "ρ‴"], n + 1, "m"),
                ("Position of {name} in its frame, in axes rotated by {by}", &point.name),
                sheet,
            );
            let (velocity, acceleration) =
                joints::carried(origins[frame], worked.omega[frame], worked.alpha[frame], arm);
            let velocity = sheet.step_vector(
                ("v_P", n + 1),
                "m/s",
                velocity,
                Named("Velocity of {name}", &point.name, Some(BEER.at("§15.5B"))),
            );
            let acceleration = sheet.step_vector(
                ("a_P", n + 1),
                "m/s^2",
                acceleration,
                Named("Acceleration of {name}", &point.name, Some(BEER.at("§15.5B"))),
            );
            sheet.answer_vector(("velocity", n + 1), "Velocity of the point", velocity);
            sheet.answer_vector(("acceleration", n + 1), "Acceleration of the point", acceleration);
            points.push([velocity, acceleration]);
        }
        points
    }

    /// A second method: orientation and places at other times, by differences.
    fn check_by_differences<W: Worksheet>(
        &self,
        frames: &[chain::ChainFrame],
        worked: &WorkedChain<'_, W>,
        points: &[[W::Vec; 2]],
        sheet: W,
    ) {
        let last = self.joints.len();
        let axes = &frames[worked.axes];
        let period = chain::period(&joints::later(&self.joints, 0.0));
        let off =
            |ours: W::Vec, other: Vector3<f64>| W::Num::from((ours.value() - seen_from(axes, other)).norm());
        if let Ok((omega, alpha)) = joints::rates_by_differences(&self.joints, last) {
            let size = TAU / period;
            sheet.check_zero(
                "the angular velocity from the difference quotients of the axes of the last frame",
                off(worked.omega[last], omega),
                size,
            );
            sheet.check_zero(
                "the angular acceleration from the difference quotient of the angular velocity",
                off(worked.alpha[last], alpha),
                size.powi(2),
            );
        }
        for (point, [velocity, acceleration]) in self.points.iter().zip(points) {
            let at = |t: f64| {
                chain::frames(&joints::later(&self.joints, t))
                    .map(|all| all[point.frame.0 + 1].point(point.place))
            };
            let lost = Vector3::repeat(f64::NAN);
            let place = |t: f64| at(t).map_or(lost, |point| point.place);
            let (Ok(first), Ok(second)) = (
                rigid::numerical_rate(place, period),
                rigid::numerical_rate(|t| at(t).map_or(lost, |point| point.velocity), period),
            ) else {
                continue;
            };
            let reach = place(0.0).norm() + point.place.norm();
            let name = |what: &'static str| Text::new(what).with("name", &point.name);
            sheet.check_zero(
                name("the velocity of {name} from the difference quotient of its position"),
                off(*velocity, first),
                reach * TAU / period,
            );
            sheet.check_zero(
                name("the acceleration of {name} from the difference quotient of its velocity"),
                off(*acceleration, second),
                reach * (TAU / period).powi(2),
            );
        }
    }

    /// The frames with their axes, the angular velocity and the angular acceleration of the last.
    fn scene(&self, frames: &[chain::ChainFrame]) -> Scene {
        let mut scene = Scene::new();
        let offsets: f64 = self.joints.iter().map(|joint| joint.offset.norm()).sum();
        let reach = self.points.iter().map(|point| point.place.norm()).fold(offsets, f64::max);
        let length = if reach > 0.0 { reach / 2.0 } else { 1.0 };
        scene.axes(Vector3::zeros(), &Matrix3::identity(), length, ["X", "Y", "Z"]);
        scene.line(frames.iter().map(|frame| frame.origin), Ink::Body);
        joints::draw(&self.joints, frames, &frames[0], length, &mut scene);
        let last = &frames[frames.len() - 1];
        scene.axes(last.origin, last.rotation.matrix(), length, ["x", "y", "z"]);
        let along =
            |vector: Vector3<f64>| vector.try_normalize(0.0).unwrap_or_else(Vector3::zeros) * length * 1.2;
        scene.arrow(last.origin, along(last.angular_velocity), Ink::Motion, "ω");
        scene.arrow(last.origin, along(last.angular_acceleration), Ink::Result, "α");
        for point in &self.points {
            let frame = &frames[point.frame.0 + 1];
            let place = frame.point(point.place).place;
            scene.line([frame.origin, place], Ink::Body);
            scene.label(place, given_name(&point.name));
        }
        scene
    }

    /// The frames while the joints go on with their accelerations.
    fn animation(&self, now: &[chain::ChainFrame]) -> Exhibit {
        let span = chain::period(&joints::later(&self.joints, 0.0));
        scene::animation("The frames of the chain", SHOWN, |part| {
            let later = chain::frames(&joints::later(&self.joints, part * span));
            self.scene(later.as_deref().unwrap_or(now))
        })
    }

    /// Components of the angular velocity of the last frame while the joints go on with their accelerations.
    fn over_time(&self, now: &chain::ChainFrame, axes: usize) -> Plot {
        let span = chain::period(&joints::later(&self.joints, 0.0));
        let mut curves: [Vec<(f64, f64)>; 3] = Default::default();
        for n in 0..=120 {
            let t = span * f64::from(n) / 120.0;
            let Ok(all) = chain::frames(&joints::later(&self.joints, t)) else { continue };
            let seen = if axes == 0 { now } else { &all[axes] };
            let omega = seen_from(seen, all[all.len() - 1].angular_velocity);
            curves.iter_mut().zip(omega.iter()).for_each(|(curve, x)| curve.push((t, *x)));
        }
        let [x, y, z] = curves;
        Plot::new(
            "Angular velocity of the last frame, with the given accelerations",
            Axis::linear("time", "s"),
            Axis::linear("angular velocity", "rad/s"),
            vec![Series::line("ωₓ", x), Series::line("ω_y", y), Series::line("ω_z", z)],
        )
    }
}

/// Declares what people find for the magnitudes of angular velocity and acceleration of the last frame.
fn wrong_magnitudes<W: Worksheet>(worked: &WorkedChain<'_, W>, last: usize, sheet: W) {
    if last == 1 {
        return;
    }
    let (omega, alpha) = (&worked.omega, &worked.alpha);
    let relative = |n: usize| if n == 1 { omega[1] } else { omega[n] - omega[n - 1] };
    let speeds = || (1..=last).map(|n| relative(n).magnitude());
    sheet.common_error("ω", "the angular speeds of the joints added as numbers", || W::Num::sum(speeds()));
    sheet.common_error("ω", "the axes of the joints taken as perpendicular", || {
        W::Num::sum(speeds().map(|speed| speed.powi(2))).sqrt()
    });
    sheet.common_error("ω", "the angular velocity relative to the preceding frame taken", || {
        relative(last).magnitude()
    });
    let carried = W::Vec::sum((2..=last).map(|n| omega[n - 1].cross(relative(n))));
    let own = alpha[last] - carried;
    // Joints that turn steadily leave rounding.
    if own.value().norm() > 1e-9 * carried.value().norm() {
        let what = "the angular accelerations of the joints added, the rotation of their axes neglected";
        sheet.common_error("α", what, || own.magnitude());
    }
}

/// The axes of each frame, in the axes of the answers.
pub(crate) fn orientation(joints: &[Joint], frames: &[chain::ChainFrame], axes: usize) -> TableExhibit {
    let number = |heading: &'static str| Column { heading: heading.into(), unit: "1" };
    let mut rows = Vec::new();
    for (joint, frame) in joints.iter().zip(&frames[1..]) {
        let seen = frames[axes].rotation.inverse() * frame.rotation;
        for (n, name) in ["x of {name}", "y of {name}", "z of {name}"].into_iter().enumerate() {
            let column = seen.matrix().column(n);
            // What is left of a cosine of 90° is no component.
            let clean = |x: f64| Cell::Number(if x.abs() < 1e-15 { 0.0 } else { x });
            rows.push(vec![
                Cell::Text(Text::new(name).with("name", &joint.name)),
                clean(column[0]),
                clean(column[1]),
                clean(column[2]),
            ]);
        }
    }
    TableExhibit {
        title: "Direction cosines of the axes of the frames".into(),
        columns: vec![Column { heading: "Axis".into(), unit: "" }, number("x"), number("y"), number("z")],
        rows,
        foot: Vec::new(),
    }
}
