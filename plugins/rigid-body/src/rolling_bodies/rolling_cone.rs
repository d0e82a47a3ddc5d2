//! A cone that rolls on a level plane about its fixed apex.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Worksheet, register,
};
use dalembert_mechanics::{Real, Vector, rigid, rigid::rolling};
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::{
    shared::{
        differences::second_rate,
        scene::{self, Scene},
    },
    sources::{BEER, LANDAU},
};

/// A cone that rolls without slip, lying on a level plane along a generator, about its apex.
///
/// The axes xyz have their origin in the apex O and turn with the line of contact: x along it, z up.
#[derive(Clone, Debug, Inputs)]
pub struct RollingCone {
    /// Mass.
    #[input("m", "kg", positive, default = "1 kg")]
    pub mass: f64,
    /// Height.
    #[input("h", "m", positive)]
    pub height: f64,
    /// Half the angle at the apex.
    #[input("α", "deg", above = 0, below = 90)]
    pub half_angle: f64,
    /// Cone.
    pub cone: Cone,
    /// Given.
    pub known: ConeMotionInput,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// The mass of a cone, spread.
#[derive(Clone, Debug, Inputs)]
pub enum Cone {
    /// Solid
    Solid,
    /// A thin shell without a base
    Shell,
    /// Properties given
    Given {
        /// Centre of mass from the apex, on the axis.
        #[input("l", "m", positive)]
        centre: f64,
        /// Moment of inertia about the axis.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
        /// Transverse moment of inertia, about the apex.
        #[input("I_t", "kg*m^2", positive)]
        transverse: f64,
    },
}

/// Known quantity of the motion.
#[derive(Clone, Debug, Inputs)]
pub enum ConeMotionInput {
    /// Precession
    Precession {
        /// Angular velocity of the line of contact.
        #[input("φ̇", "rad/s", nonnegative)]
        precession: f64,
    },
    /// Angular velocity of the cone
    Omega {
        /// Angular velocity of the cone, along the line of contact.
        #[input("ω", "rad/s", nonnegative)]
        omega: f64,
    },
}

register!(RollingCone);

impl Analysis for RollingCone {
    const ABOUT: About = About {
        id: "rigid-body/rolling-cone",
        title: "Cone rolling on a plane about its apex",
        topic: "Rolling bodies",
        summary: "Angular velocity, angular momentum and kinetic energy of a cone that rolls about its apex, position of the normal force, required friction, and the precession at which it tips.",
        main: &["normal", "friction", "precession", "tipping"],
        keywords: "cone rolling apex precession tipping cone rolamento vértice geratriz precessão tombamento landau",
        sources: &[&LANDAU, &BEER],
        cases: include_str!("../../cases/rolling_cone.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RollingConeGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (mass, height, angle, gravity) = (given.mass, given.height, given.half_angle, given.gravity);
        let (sin, cos, tan) = (angle.sin(), angle.cos(), angle.tan());
        let radius = sheet.step("r", "m", height * tan, "Radius of the base");
        let slant = sheet.step("s", "m", height / cos, "Length of the line of contact");
        cone_errors(&given.cone, mass, [radius, height], sheet);
        let (centre, axial, transverse) = match given.cone {
            ConeGiven::Given { centre, axial, transverse } => (centre, axial, transverse),
            ConeGiven::Solid {} => (
                sheet.step("l", "m", height * 3.0 / 4.0, "Centre of mass of a solid cone, from the apex"),
                sheet.step(
                    "I_a",
                    "kg*m^2",
                    mass * radius.powi(2) * 3.0 / 10.0,
                    "Moment of inertia of a solid cone about its axis",
                ),
                sheet.step(
                    "I_t",
                    "kg*m^2",
                    mass * (radius.powi(2) / 4.0 + height.powi(2)) * 3.0 / 5.0,
                    "Transverse moment of inertia of a solid cone, about the apex",
                ),
            ),
            ConeGiven::Shell {} => (
                sheet.step("l", "m", height * 2.0 / 3.0, "Centre of mass of a conical shell, from the apex"),
                sheet.step(
                    "I_a",
                    "kg*m^2",
                    mass * radius.powi(2) / 2.0,
                    "Moment of inertia of a conical shell about its axis",
                ),
                sheet.step(
                    "I_t",
                    "kg*m^2",
                    mass * (radius.powi(2) / 4.0 + height.powi(2) / 2.0),
                    "Transverse moment of inertia of a conical shell, about the apex",
                ),
            ),
        };
        if (centre * cos).value() > slant.value() {
            return Err(Refusal::because(
                "the centre of mass lies beyond the edge of the base, measured along the line of contact: the cone tips at rest; write a centre of mass nearer to the apex",
            ));
        }
        let (precession, omega) = match given.known {
            ConeMotionInputGiven::Precession { precession } => {
                sheet.common_error("ω", SPIN, || precession / sin);
                let omega = sheet.step(
                    "ω",
                    "rad/s",
                    rolling::cone_angular_velocity(precession, angle),
                    (
                        "The line of contact is at rest: ω lies along it, and the centre of mass moves with φ̇ l cos α = ω l sin α",
                        LANDAU.at("§32, problem 7"),
                    ),
                );
                (precession, omega)
            }
            ConeMotionInputGiven::Omega { omega } => {
                sheet.common_error("φ̇", SPIN, || omega * sin);
                let precession = sheet.step(
                    "φ̇",
                    "rad/s",
                    omega * tan,
                    (
                        "The line of contact is at rest: the centre of mass moves with φ̇ l cos α = ω l sin α",
                        LANDAU.at("§32, problem 7"),
                    ),
                );
                (precession, omega)
            }
        };
        let along = sheet.step("ω_a", "rad/s", omega * cos, "Component of ω along the axis of the cone");
        let across = sheet.step("ω_t", "rad/s", omega * sin, "Transverse component of ω");
        sheet.common_error("T", "½ m v_G² added, although the moments are about the apex", || {
            let rotation = axial * along.powi(2) + transverse * across.powi(2);
            (rotation + mass * (precession * centre * cos).powi(2)) / 2.0
        });
        sheet.common_error("T", "½ I_a ω² taken, as if ω lay along the axis of the cone", || {
            axial * omega.powi(2) / 2.0
        });
        let energy = sheet.step(
            "T",
            "J",
            (axial * along.powi(2) + transverse * across.powi(2)) / 2.0,
            ("Kinetic energy: the apex is at rest", BEER.at("§18.1C")),
        );
        // The axis of the cone is (cos α; 0; sin α), the direction across it and down (sin α; 0; −cos α).
        let momentum = sheet.step_vector(
            "H",
            "kg*m^2/s",
            W::Vec::from_components(
                axial * along * cos + transverse * across * sin,
                W::Num::from(0.0),
                axial * along * sin - transverse * across * cos,
            ),
            "Angular momentum about the apex, for ω along +x: axial I_a ω_a, transverse I_t ω_t",
        );
        // Rolling with ω along +x, the cone precesses about −z.
        let turning = W::Vec::from_components(W::Num::from(0.0), W::Num::from(0.0), -precession);
        let rate = sheet.step_vector(
            "Ḣ",
            "N*m",
            rigid::transport_rate(turning, momentum),
            ("Rate of change: H is constant in axes rotating with the line of contact, so Ω × H with Ω = −φ̇ k", BEER.at("§18.2")),
        );
        let [_, couple, _] = rate.components();
        let normal = sheet.step("N", "N", mass * gravity, "Total normal force of the plane");
        let lever = sheet.step("x_G", "m", centre * cos, "Centre of mass, along the line of contact");
        sheet.common_error("x_N", NO_COUPLE, || lever + precession.powi(2) * lever * centre * sin / gravity);
        let place = sheet.step(
            "x_N",
            "m",
            lever - couple / normal,
            "Distance of the normal force from the apex: moments about y, m g x_G − N x_N = Ḣ_y",
        );
        sheet.common_error("F", "the angular velocity of the cone used in place of its precession", || {
            mass * omega.powi(2) * lever
        });
        let force = sheet.step(
            "F",
            "N",
            mass * precession.powi(2) * lever,
            "Horizontal force on the cone, towards the vertical through the apex",
        );
        let demand = sheet.step(
            "μ_min",
            "1",
            force / normal,
            "Coefficient of friction required for this motion, with only friction at the apex",
        );
        // Of the couple all is in the square of the precession.
        let momentum_part = sheet.step(
            "I_c",
            "kg*m^2",
            (axial * cos.powi(2) + transverse * sin.powi(2)) * cos / sin,
            "Couple divided by the square of the precession rate: |Ḣ|/φ̇² = (I_a cos² α + I_t sin² α) cot α",
        );
        sheet.common_error("φ̇_max", NO_COUPLE, || {
            (gravity * (slant - lever) / (lever * centre * sin)).sqrt()
        });
        let tipping = sheet.step(
            "φ̇_max",
            "rad/s",
            (normal * (slant - lever) / momentum_part).sqrt(),
            "Precession at which the normal force reaches the edge of the base, x_N = s: above it the apex would lift",
        );
        match self.known {
            ConeMotionInput::Precession { .. } => {
                sheet.answer("omega", "Angular velocity of the cone", omega);
            }
            ConeMotionInput::Omega { .. } => sheet.answer("precession", "Precession", precession),
        }
        sheet.answer("energy", "Kinetic energy", energy);
        sheet.answer_vector("momentum", "Angular momentum about the apex", momentum);
        sheet.answer_vector("momentum_rate", "Rate of change of the angular momentum", rate);
        sheet.answer("normal", "Normal force", normal);
        sheet.answer("normal_place", "Distance of the normal force from the apex", place);
        sheet.answer("slant", "Length of the line of contact", slant);
        sheet.answer("friction", "Horizontal force towards the axis", force);
        sheet.answer("friction_needed", "Required coefficient of friction", demand);
        sheet.answer("tipping", "Precession at tipping", tipping);
        if place.value() > slant.value() {
            sheet.warn(|| "the normal force would have to act beyond the base: the cone tips about its edge and cannot roll in this way".into());
        }
        sheet.verify(|| {
            if matches!(self.cone, Cone::Solid) {
                sheet.check(
                    "the kinetic energy in closed form, 3 m h² φ̇² (1 + 5 cos² α)/40",
                    energy,
                    rolling::cone_energy(mass, height, precession, angle),
                );
            }
            sheet.check("the line of contact by Pythagoras", slant.powi(2), height.powi(2) + radius.powi(2));
            sheet.check_sum(
                "moments of the weight and of the normal force about the apex",
                mass * gravity * lever - couple,
                normal * place,
                (mass * gravity * lever).value() + couple.value().abs(),
            );
            let about = -Vector3::z() * precession.value();
            let centre = Vector3::new(lever.value(), 0.0, (centre * sin).value());
            let at = |t: f64| Rotation3::from_scaled_axis(about * t) * centre;
            if let Some(acceleration) = second_rate(at, TAU / precession.value()) {
                let what =
                    "mass times the acceleration of the centre of mass, by finite differences of its position";
                sheet.check(what, force, (-self.mass * acceleration.x).into());
            }
            sheet.check(
                "the couple from its coefficient of φ̇²",
                couple.abs(),
                momentum_part * precession.powi(2),
            );
            sheet.check(
                "at the tipping speed the couple brings the normal force to the edge",
                couple.abs() * (tipping / precession).powi(2),
                normal * (slant - lever),
            );
            let (a, t) = (axial.value(), transverse.value());
            self.check_by_rotation(sheet, [a, t], precession.value(), rate.value());
        });
        sheet.show(|| self.animation());
        let [part, normal, lever, slant] = [momentum_part, normal, lever, slant].map(Real::value);
        let (now, tips) = (precession.value(), tipping.value());
        sheet.show(|| {
            let most = (1.2 * tips).max(now);
            let at = |n: u16| {
                let speed = most * f64::from(n) / 200.0;
                (speed, lever + part * speed * speed / normal)
            };
            let plot = Plot::new(
                "Position of the normal force",
                Axis::linear("precession", "rad/s"),
                Axis::linear("distance from the apex", "mm"),
                vec![Series::line("x_N", (0..=200).map(at).collect()).of("normal_place")],
            );
            let plot = match self.known {
                ConeMotionInput::Precession { .. } => plot.over("known.precession.precession"),
                ConeMotionInput::Omega { .. } => plot.over_answer("known.omega.omega", "precession"),
            };
            Exhibit::Plot(
                plot.level("edge of the base", slant).mark("here", at_point(now, lever, part, normal)),
            )
        });
        Ok(())
    }
}

const NO_COUPLE: &str = "the moment of m a_G alone taken, without the couple of the rotation about G";
const SPIN: &str = "the spin about the axis of the cone taken as its angular velocity";

/// Records the errors of the centre of mass and of the moments of inertia of a cone.
fn cone_errors<W: Worksheet>(cone: &ConeGiven<W>, mass: W::Num, [radius, height]: [W::Num; 2], sheet: W) {
    match cone {
        ConeGiven::Given { .. } => {}
        ConeGiven::Solid {} => {
            sheet.common_error("l", "the centroid of a triangle used for the cone", || height * 2.0 / 3.0);
            sheet.common_error("l", "the centre of mass measured from the base", || height / 4.0);
            sheet.common_error(
                "I_a",
                "the moment of inertia of a cylinder about its axis used for the cone",
                || mass * radius.powi(2) / 2.0,
            );
            sheet.common_error(
                "I_t",
                "the transverse moment of inertia taken about the centre of mass",
                || mass * (radius.powi(2) * 4.0 + height.powi(2)) * 3.0 / 80.0,
            );
        }
        ConeGiven::Shell {} => {
            sheet.common_error("l", "the centre of mass of a solid cone used for the shell", || {
                height * 3.0 / 4.0
            });
            sheet.common_error("I_a", "the moment of inertia of a solid cone used for the shell", || {
                mass * radius.powi(2) * 3.0 / 10.0
            });
            sheet.common_error(
                "I_t",
                "the transverse moment of inertia taken about the centre of mass",
                || mass * (radius.powi(2) * 9.0 + height.powi(2) * 2.0) / 36.0,
            );
        }
    }
}

fn at_point(speed: f64, lever: f64, part: f64, normal: f64) -> (f64, f64) {
    (speed, lever + part * speed * speed / normal)
}

impl RollingCone {
    /// A second method: the whole tensor turned with the cone, times ω, and the difference quotient in time.
    fn check_by_rotation<W: Worksheet>(
        &self,
        sheet: W,
        [axial, transverse]: [f64; 2],
        precession: f64,
        rate: Vector3<f64>,
    ) {
        if precession == 0.0 {
            return;
        }
        let (sin, cos) = self.half_angle.sin_cos();
        let momentum_at = |t: f64| {
            let (turned_sin, turned_cos) = (-precession * t).sin_cos();
            let line = Vector3::new(turned_cos, turned_sin, 0.0);
            let axis = line * cos + Vector3::z() * sin;
            let tensor = Matrix3::identity() * transverse + axis * axis.transpose() * (axial - transverse);
            tensor * line * (precession * cos / sin)
        };
        let period = TAU / precession;
        let Ok(found) = rigid::numerical_rate(momentum_at, period) else { return };
        sheet.check_zero(
            "the rate from the difference quotient of J ω, with the tensor rotated",
            W::Num::from((found - rate).norm()),
            momentum_at(0.0).norm() * precession,
        );
    }

    /// The letters of what is given of its mass.
    fn letters(&self) -> &'static str {
        match self.cone {
            Cone::Solid | Cone::Shell => "m",
            Cone::Given { .. } => "m, I_a, I_t",
        }
    }

    /// One turn about the vertical.
    fn animation(&self) -> Exhibit {
        let (sin, cos) = self.half_angle.sin_cos();
        let slant = self.height / cos;
        scene::animation("The rolling cone", 6.0, |part| {
            let turn = -TAU * part;
            let line = Vector3::new(turn.cos(), turn.sin(), 0.0);
            let axis = line * cos + Vector3::z() * sin;
            let radius = self.height * sin / cos;
            let mut scene = Scene::seen_from(-1.1, 0.4);
            scene.circle(Vector3::zeros(), Vector3::z(), slant, Ink::Faint);
            scene.cone(Vector3::zeros(), axis * self.height, radius, Ink::Body);
            // A mark on the base that turns as the cone rolls.
            let across = Vector3::z().cross(line);
            let down = axis.cross(across);
            let (s, c) = (TAU * part * slant / radius).sin_cos();
            let rim = axis * self.height + (down * c + across * s) * radius;
            scene.line([axis * self.height, rim], Ink::Body);
            scene.line([Vector3::zeros(), axis * self.height], Ink::Faint);
            scene.angle("α", Vector3::zeros(), [line, axis], 0.5 * self.height);
            scene.dimension("h", [Vector3::zeros(), axis * self.height], -down * (1.25 * radius));
            scene.label(axis * self.height + across * radius, self.letters());
            if let Cone::Given { centre, .. } = self.cone {
                scene.dimension("l", [Vector3::zeros(), axis * centre], -down * (0.9 * radius));
            }
            scene.label(Vector3::zeros(), "O");
            scene.arrow(Vector3::zeros(), line * (1.25 * slant), Ink::Motion, "ω");
            scene.arrow(Vector3::zeros(), Vector3::z() * (-0.6 * slant), Ink::Motion, "φ̇");
            scene
        })
    }
}
