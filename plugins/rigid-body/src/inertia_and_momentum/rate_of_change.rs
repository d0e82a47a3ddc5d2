//! The rate of change of the angular momentum of a body, term by term in a chosen moving frame.

use std::f64::consts::{PI, TAU};

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Worksheet, register,
};
use dalembert_mechanics::{
    Vector,
    rigid::{self, MassProperties, chain},
};
use nalgebra::Vector3;

use crate::{
    shared::{
        body::Body,
        inertia::WorkedInertia,
        joints::{self, Axes, Joint, WorkedChain, seen_from},
        scene::Scene,
    },
    sources::{BEER, IRODOV, RIUL},
};

/// A body on the last frame of a chain of joints, and the frame in which its momentum is followed.
///
/// The parts of the body are in the axes of the last frame. A frame that does not spin with a body of revolution
/// has the same inertia at all times and simpler components; any other frame gives the same sum.
#[derive(Clone, Debug, Inputs)]
pub struct RateOfChange {
    /// Body.
    pub body: Body,
    /// Joints that move it.
    #[input(min = 1)]
    pub joints: Vec<Joint>,
    /// Moving frame.
    /// All vectors are resolved along its axes.
    pub frame: Axes,
    /// Reference point for moments.
    pub about: MomentCentre,
}

/// A point about which moments are taken.
#[derive(Clone, Debug, Inputs)]
pub enum MomentCentre {
    /// The centre of mass G
    MassCentre,
    /// The fixed origin O
    Origin,
    /// Another fixed point A
    Fixed {
        /// Position from O, in the axes of the moving frame.
        #[input("r_A", "m")]
        at: Vector3<f64>,
    },
}

register!(RateOfChange);

impl Analysis for RateOfChange {
    const ABOUT: About = About {
        id: "rigid-body/rate-of-change",
        title: "Rate of change of angular momentum",
        topic: "Inertia and momentum",
        summary: "dH/dt = (dH/dt) relative + Ω × H of a body on a chain of joints, in a chosen moving frame, and the inertia force and couple at any point.",
        main: &["moment", "moment_size"],
        keywords: "angular momentum rate Euler equations inertia couple d'Alembert momento angular taxa de variação equações de Euler \
                   força e binário de inércia referencial móvel haltere dumbbell",
        sources: &[&RIUL, &BEER, &IRODOV],
        cases: include_str!("../../cases/rate_of_change.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RateOfChangeGiven<W>, sheet: W) -> Result<(), Refusal> {
        let body = self.body.properties()?;
        let frames = joints::frames(&self.joints)?;
        let (axes, last) = (self.frame.place(), self.joints.len());
        let frame = &frames[axes];
        let turned = body.turned(&(frame.rotation.inverse() * frames[last].rotation));
        let mass = sheet.numerical("m", "kg", turned.mass, "Mass of the whole body");
        let inertia = WorkedInertia::found(&turned.inertia, sheet);
        let worked = WorkedChain::new(&self.joints, &given.joints, axes, sheet);
        let (omega, alpha) = (worked.omega[last], worked.alpha[last]);
        let momentum = inertia.momentum(omega, sheet);
        let rate = self.rate(&worked, &inertia, momentum, sheet);
        // The motion of G, and what it adds about another point.
        let arm = sheet.numerical_vector(
            "ρ_G",
            "m",
            turned.centre,
            "Centre of mass G from the origin of the last frame, in the axes of the moving frame",
        );
        let (velocity, acceleration) =
            joints::carried(worked.origins(&given.joints, true, sheet)[last], omega, alpha, arm);
        let velocity =
            sheet.step_vector("v_G", "m/s", velocity, ("Velocity of the centre of mass", BEER.at("§15.5B")));
        let acceleration = sheet.step_vector(
            "a_G",
            "m/s^2",
            acceleration,
            ("Acceleration of the centre of mass", BEER.at("§15.5B")),
        );
        let centre = seen_from(frame, frames[last].point(body.centre).place);
        let from = match &self.about {
            MomentCentre::MassCentre => None,
            MomentCentre::Origin => Some(centre),
            MomentCentre::Fixed { at } => Some(centre - at),
        };
        let (about, moment) = match from.filter(|from| *from != Vector3::zeros()) {
            None => (momentum, rate),
            Some(from) => {
                let from = sheet.numerical_vector(
                    "r",
                    "m",
                    from,
                    "Centre of mass G from the reference point for moments",
                );
                (
                    sheet.step_vector(
                        "H_A",
                        "kg*m^2/s",
                        momentum + from.cross(velocity * mass),
                        ("Angular momentum about the point", BEER.at("§18.1A")),
                    ),
                    sheet.step_vector(
                        "M_A",
                        "N*m",
                        rate + from.cross(acceleration * mass),
                        (
                            "Moment of all forces about the point: dH/dt with the point fixed",
                            RIUL.at("eqs. 22–23"),
                        ),
                    ),
                )
            }
        };
        let force = sheet.step_vector(
            "F_in",
            "N",
            -(acceleration * mass),
            ("Inertia force, opposite to the acceleration of G", RIUL.at("eqs. 22–23")),
        );
        let couple = sheet.step_vector(
            "C_in",
            "N*m",
            -moment,
            ("Corresponding inertia couple at the point", RIUL.at("eqs. 22–23")),
        );
        let size = sheet.step("H", "kg*m^2/s", about.magnitude(), "Magnitude of the angular momentum");
        let along = sheet.step(
            "H_e",
            "kg*m^2/s",
            about.dot(worked.last_axis),
            "Angular momentum along the axis of the last joint",
        );
        if from.is_none() && axes != last {
            sheet.common_error(
                "M",
                "the moments of inertia multiplied by α alone, without the gyroscopic terms",
                || inertia.times(alpha).magnitude(),
            );
            if axes != 0 {
                sheet.common_error(
                    "M",
                    "the angular velocity of the body used in place of that of the moving frame",
                    || (rate - worked.omega[axes].cross(momentum) + omega.cross(momentum)).magnitude(),
                );
            }
        }
        let moment_size = sheet.step("M", "N*m", moment.magnitude(), "Magnitude of the moment");
        sheet.answer_vector("angular_momentum", "Angular momentum about the point", about);
        sheet.answer("angular_momentum_size", "Magnitude of the angular momentum", size);
        sheet.answer("axial_angular_momentum", "Angular momentum along the axis of the last joint", along);
        sheet.answer_vector("moment", "Moment of all forces about the point", moment);
        sheet.answer("moment_size", "Magnitude of the moment", moment_size);
        sheet.answer_vector("rate_about_g", "dH/dt about G", rate);
        sheet.answer_vector("inertia_force", "Inertia force", force);
        sheet.answer_vector("inertia_couple", "Inertia couple at the point", couple);
        let change = matches!(self.joints[..], [_]).then(|| {
            // From the point of the moments to the axis of the joint.
            let axis = worked.last_axis;
            let off = from.map_or_else(Vector3::zeros, |from| from - turned.centre);
            let beside = off.cross(axis.value()).norm() > 1e-14 * off.norm();
            let (turning, why) = if beside {
                let about_axis = axis.dot(momentum + arm.cross(velocity * mass));
                let why =
                    "Over half a revolution everything reverses except the angular momentum about the axis";
                ((about - axis * about_axis).magnitude(), why)
            } else {
                let why = "Over half a revolution the transverse component reverses";
                (axis.cross(about).magnitude(), why)
            };
            sheet.common_error("ΔH", "the whole angular momentum reversed", || about.magnitude() * 2.0);
            let change = sheet.step("ΔH", "kg*m^2/s", turning * 2.0, (why, IRODOV.at("")));
            sheet.answer("half_turn_change", "Change of the angular momentum over half a revolution", change);
            change
        });
        sheet.verify(|| {
            // In axes of the body itself these are the equations that were solved.
            if axes != last {
                sheet.check_vector(
                    "dH/dt about G from Euler's equations: I α + ω × H",
                    inertia.times(alpha) + omega.cross(momentum),
                    rate,
                );
            }
            let point = match &self.about {
                MomentCentre::MassCentre => None,
                MomentCentre::Origin => Some(Vector3::zeros()),
                MomentCentre::Fixed { at } => Some(frame.rotation * at),
            };
            self.check_by_differences(&body, point, about, moment, frame, sheet);
            self.check_force(&body, force, frame, sheet);
            let axis = self.joints[last - 1].plain().axis;
            let axis = frames[last].rotation * (axis / axis.amax()).normalize();
            let now = joints::later(&self.joints, 0.0);
            let Some(at_first) = self.momentum_at(&body, &now, point) else { return };
            let what = "the angular momentum R I Rᵀ ω along the axis of the last joint";
            sheet.check_sum(what, along, axis.dot(at_first).into(), at_first.norm());
            if let (Some(change), [_]) = (change, &self.joints[..]) {
                let mut turned = now;
                turned[0].angle += PI;
                let Some(at_last) = self.momentum_at(&body, &turned, point) else { return };
                let what = "the angular momentum R I Rᵀ ω half a revolution later";
                sheet.check_sum(what, change, (at_last - at_first).norm().into(), at_first.norm());
            }
        });
        let vectors = [about.value(), moment.value(), omega.value()];
        sheet.show(|| self.drawing(&frames, body.centre, vectors));
        sheet.show(|| Exhibit::Plot(self.over_a_turn(&body)));
        Ok(())
    }
}

impl RateOfChange {
    /// dH/dt about G, from what is seen in the moving frame and from the turning of that frame.
    fn rate<W: Worksheet>(
        &self,
        worked: &WorkedChain<'_, W>,
        inertia: &WorkedInertia<W>,
        momentum: W::Vec,
        sheet: W,
    ) -> W::Vec {
        let (axes, last) = (worked.axes, self.joints.len());
        let (omega, alpha) = (worked.omega[last], worked.alpha[last]);
        let turning = worked.omega[axes];
        let component_rates = if axes == last || axes == 0 {
            alpha
        } else {
            sheet.step_vector(
                "ω̇",
                "rad/s^2",
                alpha - turning.cross(omega),
                "Rates of change of the components of ω in the axes of the moving frame",
            )
        };
        let mut seen = inertia.times(component_rates);
        if axes != last {
            let relative = if axes == 0 {
                omega
            } else {
                sheet.step_vector(
                    "ω_rel",
                    "rad/s",
                    omega - turning,
                    "Angular velocity of the body relative to the moving frame",
                )
            };
            let across = sheet.step_vector(
                "ε",
                "rad/s^2",
                relative.cross(omega),
                "Transport term of ω due to the rotation of the body relative to the moving frame",
            );
            let changing = sheet.step_vector(
                "Ḣ_I",
                "N*m",
                relative.cross(momentum) - inertia.times(across),
                "Contribution of the changing moments and products of inertia in these axes; zero for a body of revolution about its own axis",
            );
            seen = seen + changing;
        }
        let seen = sheet.step_vector(
            "Ḣ_rel",
            "N*m",
            seen,
            ("Rate of change relative to the moving frame", RIUL.at("eq. 47")),
        );
        sheet.answer_vector("relative_rate", "(dH/dt) relative to the moving frame, about G", seen);
        if axes == 0 {
            return seen;
        }
        let transport = sheet.step_vector(
            "Ḣ_turn",
            "N*m",
            rigid::transport_rate(turning, momentum),
            ("Transport term Ω × H", RIUL.at("eqs. 42–44")),
        );
        sheet.answer_vector("transport_rate", "Ω × H", transport);
        sheet.step_vector(
            "Ḣ_G",
            "N*m",
            seen + transport,
            ("Rate of change of the angular momentum about G in fixed axes", RIUL.at("eqs. 42–44")),
        )
    }

    /// Angular momentum in the fixed axes at another time, about G or about a fixed point.
    fn momentum_at(
        &self,
        body: &MassProperties,
        joints: &[chain::ChainJoint],
        point: Option<Vector3<f64>>,
    ) -> Option<Vector3<f64>> {
        let frames = chain::frames(joints).ok()?;
        let last = &frames[frames.len() - 1];
        let own = rigid::turned(&body.inertia, &last.rotation) * last.angular_velocity;
        let Some(point) = point else { return Some(own) };
        let centre = last.point(body.centre);
        Some(own + (centre.place - point).cross(centre.velocity * body.mass))
    }

    /// A second method: the whole tensor turned with the body, times the angular velocity, in fixed axes; and the
    /// difference quotient of that product in time.
    fn check_by_differences<W: Worksheet>(
        &self,
        body: &MassProperties,
        point: Option<Vector3<f64>>,
        about: W::Vec,
        moment: W::Vec,
        frame: &chain::ChainFrame,
        sheet: W,
    ) {
        let at = |t: f64| {
            let joints = joints::later(&self.joints, t);
            self.momentum_at(body, &joints, point).unwrap_or_else(|| Vector3::repeat(f64::NAN))
        };
        let period = chain::period(&joints::later(&self.joints, 0.0));
        let speed = TAU / period;
        let reach = point.map_or(0.0, |point| (body.centre.norm() + point.norm()).powi(2)) * body.mass;
        let size = (body.inertia.amax() + reach) * speed;
        let off =
            |ours: W::Vec, other: Vector3<f64>| W::Num::from((frame.rotation * ours.value() - other).norm());
        sheet.check_zero(
            "the angular momentum from the inertia tensor rotated with the body: R I Rᵀ ω",
            off(about, at(0.0)),
            size.max(about.value().norm()),
        );
        if let Ok(rate) = rigid::numerical_rate(at, period) {
            sheet.check_zero(
                "dH/dt from the difference quotient of R I Rᵀ ω",
                off(moment, rate),
                (size * speed).max(moment.value().norm()),
            );
        }
    }

    /// The inertia force by differences of the momentum.
    fn check_force<W: Worksheet>(
        &self,
        body: &MassProperties,
        force: W::Vec,
        frame: &chain::ChainFrame,
        sheet: W,
    ) {
        let momentum = |t: f64| {
            let frames = chain::frames(&joints::later(&self.joints, t));
            let velocity = frames.map(|frames| frames[frames.len() - 1].point(body.centre).velocity);
            velocity.unwrap_or_else(|_| Vector3::repeat(f64::NAN)) * body.mass
        };
        let period = chain::period(&joints::later(&self.joints, 0.0));
        let Ok(rate) = rigid::numerical_rate(momentum, period) else { return };
        let size = Vector::value(momentum(0.0)).norm() * TAU / period;
        sheet.check_zero(
            "the inertia force from the difference quotient of the momentum",
            W::Num::from((frame.rotation * force.value() + rate).norm()),
            size.max(force.value().norm()),
        );
    }

    /// The moment about the fixed origin, or G, in the fixed axes over a turn of the first joint.
    fn over_a_turn(&self, body: &MassProperties) -> Plot {
        let mut curves: [Vec<(f64, f64)>; 3] = Default::default();
        for n in 0..=90 {
            let angle = TAU * f64::from(n) / 90.0;
            let mut joints = joints::later(&self.joints, 0.0);
            joints[0].angle = angle;
            let Ok(frames) = chain::frames(&joints) else { continue };
            let last = &frames[frames.len() - 1];
            let tensor = rigid::turned(&body.inertia, &last.rotation);
            let momentum = tensor * last.angular_velocity;
            let rate = tensor * last.angular_acceleration + last.angular_velocity.cross(momentum);
            curves.iter_mut().zip(rate.iter()).for_each(|(curve, x)| curve.push((angle, *x)));
        }
        let [x, y, z] = curves;
        Plot::new(
            "dH/dt about G in the fixed axes over one revolution of the first joint",
            Axis::linear("angle", "deg"),
            Axis::linear("couple", "N*m"),
            vec![
                Series::line("X", x).of("rate_about_g.x"),
                Series::line("Y", y).of("rate_about_g.y"),
                Series::line("Z", z).of("rate_about_g.z"),
            ],
        )
        // The answers are in the axes that are asked for.
        .over(if self.frame.place() == 0 { "joints[1].motion.now.angle" } else { "" })
    }

    /// The body's frame with ω, H and dH/dt at G, in the moving axes.
    fn drawing(
        &self,
        frames: &[chain::ChainFrame],
        centre: Vector3<f64>,
        vectors: [Vector3<f64>; 3],
    ) -> Exhibit {
        let mut scene = Scene::new();
        let last = &frames[frames.len() - 1];
        let frame = &frames[self.frame.place()];
        let centre = seen_from(frame, last.point(centre).place - frame.origin);
        let base = seen_from(frame, last.origin - frame.origin);
        let size = self
            .body
            .draw_parts(&mut scene, |point| seen_from(frame, last.point(point).place - frame.origin));
        let reach = centre.norm().max(base.norm()).max(size);
        let length = if reach > 0.0 { reach } else { 1.0 };
        scene.axes(Vector3::zeros(), &nalgebra::Matrix3::identity(), length, ["x", "y", "z"]);
        scene.line([Vector3::zeros(), base, centre], Ink::Faint);
        joints::draw(&self.joints, frames, frame, 0.8 * length, &mut scene);
        if let MomentCentre::Fixed { at } = self.about {
            scene.label(at, "r_A");
        }
        scene.label(centre, "G");
        let [momentum, moment, omega] = vectors;
        for (vector, ink, name) in
            [(omega, Ink::Motion, "ω"), (momentum, Ink::Result, "H"), (moment, Ink::Force, "dH/dt")]
        {
            if let Some(along) = vector.try_normalize(0.0) {
                scene.arrow(centre, along * length * 0.9, ink, name);
            }
        }
        scene.exhibit("Angular momentum and its rate of change")
    }
}
