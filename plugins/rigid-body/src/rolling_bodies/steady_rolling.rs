//! A disc or hoop that rolls steadily on a circle, inclined to the floor.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    rigid::rolling::{self, Rolling},
};
use nalgebra::{Matrix3, Vector3};

use crate::{
    shared::{
        scene::Scene,
        wheel::{self, Wheel},
    },
    sources::{HIBBELER, ROUTH},
};

/// A disc or hoop that rolls without slip on a level floor, its centre on a circle.
///
/// It leans inwards, towards the centre of that circle. The axes 1, 2 and 3 through its centre G precess with it but do
/// not spin: 1 horizontal in its plane, 2 in its plane away from the contact, 3 along its axis.
#[derive(Clone, Debug, Inputs)]
pub struct SteadyRolling {
    /// Mass.
    #[input("m", "kg", positive, default = "1 kg")]
    pub mass: f64,
    /// Radius of the circle that touches the floor.
    #[input("r", "m", positive)]
    pub radius: f64,
    /// It is a.
    pub wheel: Wheel,
    /// Given.
    pub known: RollingMotionInput,
    /// Coefficient of friction with the floor.
    #[input("μ", "1", nonnegative)]
    pub friction: Option<f64>,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// Known quantity of the motion.
#[derive(Clone, Debug, Inputs)]
pub enum RollingMotionInput {
    /// Angle and circle of the centre
    CentreCircle {
        /// Angle between its plane and the floor.
        #[input("θ", "deg", above = 0, below = 90)]
        inclination: f64,
        /// Radius of the circle of the centre.
        #[input("a", "m", nonnegative)]
        radius: f64,
    },
    /// Angle and circle on the floor
    FloorCircle {
        /// Angle between its plane and the floor.
        #[input("θ", "deg", above = 0, below = 90)]
        inclination: f64,
        /// Radius of the circle on the floor.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Angle and precession
    Precession {
        /// Angle between its plane and the floor.
        #[input("θ", "deg", above = 0, below = 90)]
        inclination: f64,
        /// Precession.
        #[input("Ω", "rad/s", positive)]
        precession: f64,
    },
    /// Circle and speed of the centre
    Speed {
        /// Radius of the circle of the centre.
        #[input("a", "m", positive)]
        radius: f64,
        /// Speed of the centre.
        #[input("v", "m/s", positive)]
        speed: f64,
    },
}

register!(SteadyRolling);

const PARTICLE: &str = "the disc taken as a particle, tan λ = v²/(g a)";
const ON_FLOOR: &str = "the circle on the floor used in place of that of the centre";

impl Analysis for SteadyRolling {
    const ABOUT: About = About {
        id: "rigid-body/steady-rolling",
        title: "Disc or hoop rolling steadily on a circle",
        topic: "Rolling bodies",
        summary: "Precession, angle or circle of a disc or hoop rolling without slipping, inclined to the floor: spin, normal force, required friction and stability of the motion.",
        main: &["precession", "lean", "spin", "inclination"],
        keywords: "rolling disc hoop coin wheel circle precession lean rolamento disco aro moeda roda circunferência precessão inclinação sem deslizamento hibbeler 21-69",
        sources: &[&ROUTH, &HIBBELER],
        cases: include_str!("../../cases/steady_rolling.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &SteadyRollingGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (mass, radius, gravity) = (given.mass, given.radius, given.gravity);
        let moments = wheel::moments(&given.wheel, mass, radius, true, sheet);
        let disc = Rolling {
            mass: self.mass,
            radius: self.radius,
            axial: moments[0].value(),
            transverse: moments[1].value(),
            gravity: self.gravity,
        };
        let precession = |inclination: W::Num, centre: W::Num| {
            let squared =
                rolling::steady_precession_squared(mass, radius, moments, gravity, inclination, centre);
            sheet.common_error("φ̇", PARTICLE, || (gravity / (centre * inclination.tan())).sqrt());
            sheet.common_error("φ̇", "the moment of the friction about the centre of mass omitted", || {
                let own = moments[0] * centre / radius + moments[1] * inclination.cos();
                (mass * gravity * radius / (inclination.tan() * own)).sqrt()
            });
            sheet.step(
                "φ̇",
                "rad/s",
                squared.sqrt(),
                (
                    "Moments about the horizontal diameter: (I_a + m r²) ω₂ ω₃ − I_t ω₂ φ̇ cos θ + m g r cos θ = 0 with ω₂ = φ̇ sin θ and ω₃ = −φ̇ a/r",
                    ROUTH.at("ch. V"),
                ),
            )
        };
        let (inclination, centre, precession) = match given.known {
            RollingMotionInputGiven::CentreCircle { inclination, radius: centre } => {
                (inclination, centre, precession(inclination, centre))
            }
            RollingMotionInputGiven::FloorCircle { inclination, radius: floor } => {
                let centre = sheet.step(
                    "a",
                    "m",
                    floor - radius * inclination.cos(),
                    "The centre lies inward of the contact by r cos θ",
                );
                if centre.value() < 0.0 {
                    return Err(Refusal::because(
                        "the circle on the floor is so small that the centre would be beyond its axis; make the circle or the angle larger",
                    ));
                }
                (inclination, centre, precession(inclination, centre))
            }
            RollingMotionInputGiven::Precession { inclination, precession } => {
                sheet.common_error("a", PARTICLE, || gravity / (precession.powi(2) * inclination.tan()));
                let centre = sheet.step(
                    "a",
                    "m",
                    rolling::steady_centre_radius(mass, radius, moments, gravity, inclination, precession),
                    (
                        "Moments about the horizontal diameter, solved for the circle of the centre",
                        ROUTH.at("ch. V"),
                    ),
                );
                if centre.value() < 0.0 {
                    sheet.warn(|| {
                        "the precession is so fast that the centre circles on the far side of the axis: the radius a is negative".into()
                    });
                }
                (inclination, centre, precession)
            }
            RollingMotionInputGiven::Speed { radius: centre, speed } => {
                let precession =
                    sheet.step("φ̇", "rad/s", speed / centre, "The centre completes one revolution in 2π a/v");
                let found = disc.steady_inclinations(centre.value(), precession.value());
                let Some(&angle) = found.first() else {
                    return Err(Refusal::because(
                        "no angle was found for this rolling motion; the speed is too small or too large for the circle",
                    ));
                };
                sheet.common_error("λ", PARTICLE, || speed.powi(2).atan2(gravity * centre));
                sheet.common_error("θ", PARTICLE, || (gravity * centre).atan2(speed.powi(2)));
                let inclination = sheet.numerical(
                    "θ",
                    "deg",
                    angle,
                    "Zero of the moments about the horizontal diameter: φ̇² sin θ ((I_a + m r²) a/r + I_t cos θ) = m g r cos θ",
                );
                (inclination, centre, precession)
            }
        };
        let lean = sheet.numerical(
            "λ",
            "deg",
            FRAC_PI_2 - inclination.value(),
            "Lean angle from the vertical: complement to 90°",
        );
        let floor = sheet.step(
            "R",
            "m",
            centre + radius * inclination.cos(),
            "Radius of the circle on the floor: the contact lies outward of the centre",
        );
        let speed = sheet.step("v", "m/s", (centre * precession).abs(), "Speed of the centre");
        sheet.common_error("ω₃", ON_FLOOR, || -(precession * floor / radius));
        let third = sheet.step(
            "ω₃",
            "rad/s",
            -(precession * centre / radius),
            "No slip: the contact point is at rest, v = −r ω₃ along 1",
        );
        let second = sheet.step(
            "ω₂",
            "rad/s",
            precession * inclination.sin(),
            "Component of the angular velocity along the diameter through the contact",
        );
        let spin = sheet.step(
            "ψ̇",
            "rad/s",
            third - precession * inclination.cos(),
            "Spin relative to the precessing axes: ω₃ = ψ̇ + φ̇ cos θ",
        );
        let normal =
            sheet.step("N", "N", mass * gravity, "Normal force: the height of the centre is constant");
        sheet.common_error("F", ON_FLOOR, || mass * floor * precession.powi(2));
        let force = sheet.step(
            "F",
            "N",
            mass * centre * precession.powi(2),
            "Friction, towards the axis of the circle: it changes the direction of the velocity of the centre",
        );
        let demand = sheet.step(
            "μ_min",
            "1",
            force.abs() / normal,
            "Coefficient of friction required for this motion",
        );
        let slopes = rolling::tilting_slopes(mass, radius, moments, inclination, [second, third]);
        let slopes = [
            sheet.step(
                "ω₂′",
                "1/s",
                slopes[0],
                "Variation of ω₂ as the disc tilts: I_t ω̇₂ = (I_a ω₃ − I_t ω₂ cot θ) θ̇",
            ),
            sheet.step(
                "ω₃′",
                "1/s",
                slopes[1],
                "Variation of ω₃ as the disc tilts: (I_a + m r²) ω̇₃ = m r² ω₂ θ̇",
            ),
        ];
        let stiffness = sheet.step(
            "K",
            "1/s^2",
            rolling::tilting_stiffness(mass, radius, moments, gravity, inclination, [second, third], slopes),
            "Small oscillations of the angle, ε̈ + K ε = 0: derivative of the moments about the tangent at the contact, divided by I_t + m r²",
        );
        match self.known {
            RollingMotionInput::Precession { .. } => {}
            RollingMotionInput::CentreCircle { .. } | RollingMotionInput::FloorCircle { .. } => {
                sheet.answer("precession", "Precession", precession);
            }
            RollingMotionInput::Speed { .. } => {
                sheet.answer("precession", "Precession", precession);
                sheet.answer("inclination", "Angle between its plane and the floor", inclination);
            }
        }
        sheet.answer("lean", "Lean angle from the vertical", lean);
        if matches!(
            self.known,
            RollingMotionInput::FloorCircle { .. } | RollingMotionInput::Precession { .. }
        ) {
            sheet.answer("centre_radius", "Radius of the circle of the centre", centre);
        }
        sheet.answer("floor_radius", "Radius of the circle on the floor", floor);
        sheet.answer("speed", "Speed of the centre", speed);
        sheet.answer("spin", "Spin", spin);
        sheet.answer("axial_omega", "Angular velocity about the axis", third);
        sheet.answer("normal", "Normal force", normal);
        sheet.answer("friction", "Friction towards the axis of the circle", force);
        sheet.answer("friction_needed", "Required coefficient of friction", demand);
        sheet.answer("stiffness", "Stiffness of small oscillations", stiffness);
        let mut wobble = None;
        if stiffness.value() > 0.0 {
            let period =
                sheet.step("ω_n", "rad/s", stiffness.sqrt(), "Stable: angular frequency of the oscillation");
            sheet.answer("wobble", "Angular frequency of the oscillation", period);
            wobble = Some(period);
        } else {
            sheet.warn(|| "the steady motion is unstable: the angle diverges from it".into());
        }
        if self.friction.is_some_and(|friction| friction < demand.value()) {
            sheet.warn(|| {
                Text::new("it would slip: the motion requires a coefficient of friction of {needed}")
                    .with_quantity("needed", demand.value(), "1")
            });
        }
        sheet.verify(|| {
            let omega = [0.0, second.value(), third.value()];
            let rates = disc.accelerations(inclination.value(), omega);
            let scale = self.gravity / self.radius + second.value().powi(2) + third.value().powi(2);
            sheet.check_zero(
                "the equations of the rolling disc keep the angle constant",
                rates[0].into(),
                scale,
            );
            sheet.check_sum(
                "the length rolled on the floor equals that on the rim",
                floor * precession,
                -(radius * spin),
                (radius * spin).value().abs() + (centre * precession).value().abs(),
            );
            sheet.check(
                "the friction supplies the centripetal force of the centre, F a = m v²",
                force * centre,
                mass * speed.powi(2),
            );
            let [second_slope, third_slope] = slopes.map(Real::value);
            let tilted = |by: f64| {
                let omega = [0.0, second.value() + second_slope * by, third.value() + third_slope * by];
                disc.accelerations(inclination.value() + by, omega)[0]
            };
            let step = 1e-3 * inclination.value().sin();
            let slope = (8.0 * (tilted(step) - tilted(-step)) - (tilted(2.0 * step) - tilted(-2.0 * step)))
                / (12.0 * step);
            sheet.check_sum(
                "the stiffness from differences of the equations of the rolling disc",
                stiffness,
                (-slope).into(),
                scale / inclination.value().sin().powi(2),
            );
            if let Some(wobble) = wobble {
                sheet.check_sum(
                    "square of the oscillation frequency from the same differences",
                    wobble.powi(2),
                    (-slope).into(),
                    scale / inclination.value().sin().powi(2),
                );
            }
            sheet.check_sum(
                "inward offset of the centre from the contact, from the lean",
                radius * lean.sin(),
                floor - centre,
                floor.value().abs() + centre.value().abs(),
            );
            if let RollingMotionInputGiven::FloorCircle { radius: circle, .. } = given.known {
                let size = floor.value().abs() + centre.value().abs();
                sheet.check_sum("the circle on the floor is the given one", floor, circle, size);
            }
            let (other, [_, across]) = disc.contact_forces(inclination.value(), omega);
            sheet.check_sum("the normal force from m a_G", normal, other.into(), normal.value());
            sheet.check_sum(
                "the friction from m a_G",
                force,
                across.into(),
                normal.value() + force.value().abs(),
            );
        });
        let (angle, circle) = (inclination.value(), centre.value());
        sheet.show(|| self.picture(angle, circle));
        sheet.show(|| Exhibit::Plot(precessions(&disc, angle, circle, precession.value())));
        Ok(())
    }
}

/// The precession over the angle, on the same circle of the centre.
fn precessions(disc: &Rolling, angle: f64, circle: f64, precession: f64) -> Plot {
    let at = |n: u16| {
        let angle = FRAC_PI_2 * f64::from(n) / 180.0;
        let moments = [disc.axial, disc.transverse];
        let squared = rolling::steady_precession_squared(
            disc.mass,
            disc.radius,
            moments,
            disc.gravity,
            angle,
            circle.max(0.0),
        );
        (angle, squared.sqrt())
    };
    Plot::new(
        "Precession against the angle, for the same circle of the centre",
        Axis::linear("angle of the plane to the floor", "deg"),
        Axis::linear("precession", "rad/s"),
        vec![Series::line("φ̇", (18..=178).map(at).collect()).of("precession")],
    )
    .over("known.centre-circle.inclination")
    .mark("this motion", (angle, precession))
}

impl SteadyRolling {
    /// The disc beside the axis of its circle, seen from obliquely above; a circle far wider than the disc is drawn
    /// smaller.
    fn picture(&self, angle: f64, circle: f64) -> Exhibit {
        let (sin, cos) = angle.sin_cos();
        // In radii of the disc; it leans towards the axis z from +y.
        let (least, most) = (1.2 * cos + 0.4, 1.5);
        let drawn = (circle.abs() / self.radius).min(most).max(if circle == 0.0 { 0.0 } else { least });
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let centre = y * drawn + z * sin;
        let contact = y * (drawn + cos);
        let plane = y * -cos + z * sin;
        let axle = x.cross(&plane);
        let mut scene = Scene::seen_from(-0.9, 0.4);
        scene.circle(Vector3::zeros(), z, drawn + cos, Ink::Faint);
        scene.disc(centre, &Matrix3::from_columns(&[plane, -x, axle]), 1.0, Ink::Body);
        scene.line([Vector3::zeros(), z * 1.9], Ink::Faint);
        scene.line([contact, y * (drawn - cos).max(0.0)], Ink::Faint);
        scene.label(centre + (plane - x) * 0.75, self.wheel.letters());
        scene.label(centre - plane * 0.5, "r");
        scene.angle("θ", contact, [-y, plane], 0.6);
        scene.arrow(contact, z * 0.9, Ink::Force, "N");
        scene.arrow(contact, y * -0.9, Ink::Force, "F");
        scene.arrow(centre, z * -0.9, Ink::Force, "m g");
        scene.label(centre, "G");
        let rate = match self.known {
            RollingMotionInput::Precession { .. } => "Ω",
            _ => "φ̇",
        };
        scene.turn(rate, z * 1.6, z, 0.35, Ink::Motion);
        match self.known {
            RollingMotionInput::FloorCircle { .. } => {
                scene.dimension("R", [Vector3::zeros(), contact], Vector3::zeros());
            }
            _ => scene.dimension("a", [z * sin, centre], Vector3::zeros()),
        }
        if matches!(self.known, RollingMotionInput::Speed { .. }) {
            scene.arrow(centre, x * -1.2, Ink::Motion, "v");
        }
        if (drawn - circle.abs() / self.radius).abs() > 1e-9 {
            scene.exhibit("The disc on its circle (the circle is not to scale)")
        } else {
            scene.exhibit("The disc on its circle")
        }
    }
}
