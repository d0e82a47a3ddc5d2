//! Momentum, angular momentum and kinetic energy of a body in space.

use dalembert_core::{About, Analysis, Exhibit, Ink, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{Real, Vector, rigid};
use nalgebra::{Matrix3, Vector3};

use crate::{
    shared::{
        body::{
            Body, BodyLine, BodyLineGiven, BodyRotation, BodyVelocity, WorkedBody, directed, matrix_times,
            projection_error, refused,
        },
        scene::Scene,
    },
    sources::{BEER, MERIAM, RIUL},
};

/// A rigid body and its motion at one moment, in axes Oxyz that lie along those of the body at that moment.
#[derive(Clone, Debug, Inputs)]
pub struct Momentum {
    /// Body.
    pub body: Body,
    /// Its rotation.
    pub turning: BodyRotation,
    /// Its motion.
    #[input(default = "mass-centre")]
    pub going: BodyVelocity,
    /// Position of a point A.
    /// The angular momentum about it is also calculated.
    #[input("r_A", "m", default = "(0; 0; 0) m")]
    pub point: Vector3<f64>,
    /// A line.
    /// The angular momentum about it is calculated.
    pub line: Option<BodyLine>,
}

register!(Momentum);

impl Analysis for Momentum {
    const ABOUT: About = About {
        id: "rigid-body/momentum",
        title: "Momentum and kinetic energy of a body",
        topic: "Inertia and momentum",
        summary: "Linear and angular momentum of a body in space about its centre of mass, a point and a line, and its kinetic energy.",
        main: &["momentum_g", "kinetic_energy", "momentum_angle", "angular_velocity"],
        keywords: "angular momentum linear momentum kinetic energy inertia matrix major axis rule energy sink rolling disc \
                   momento angular quantidade de movimento energia cinética corpo rígido regra do eixo maior",
        sources: &[&RIUL, &BEER, &MERIAM],
        cases: include_str!("../../cases/momentum.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MomentumGiven<W>, sheet: W) -> Result<(), Refusal> {
        let body = self.body.work(&given.body, sheet)?;
        let omega = self.turning.work(&given.turning, &body, sheet)?;
        let velocity = self.going.work(&given.going, &body, omega, sheet)?;
        sheet.answer("mass", "Mass", body.mass);
        sheet.answer_vector("centre", "Position of the centre of mass G", body.centre);
        sheet.answer_vector("angular_velocity", "Angular velocity", omega);
        sheet.answer_vector("centre_velocity", "Velocity of the centre of mass", velocity);
        let speed = sheet.step("v", "m/s", velocity.magnitude(), "Speed of the centre of mass");
        sheet.answer("centre_speed", "Speed of the centre of mass", speed);

        let linear =
            sheet.step_vector("L", "kg*m/s", velocity * body.mass, ("Linear momentum", RIUL.at("eq. 22")));
        sheet.answer_vector("linear_momentum", "Linear momentum", linear);
        let size = sheet.step("L_m", "kg*m/s", linear.magnitude(), "Magnitude of the linear momentum");
        sheet.answer("linear_momentum_size", "Magnitude of the linear momentum", size);

        let about_g = sheet.step_vector(
            "H_G",
            "kg*m^2/s",
            body.momentum(omega),
            ("Angular momentum about G: the inertia matrix times ω", BEER.at("§18.1A")),
        );
        sheet.answer_vector("momentum_g", "Angular momentum about G", about_g);
        let without_products = || matrix_times(body.moments, [W::Num::from(0.0); 3], omega);
        let is_oblique = omega.cross(about_g).magnitude().holds(|size| size > 0.0);
        sheet.common_error("H_m", "the products of inertia ignored", || without_products().magnitude());
        sheet.common_error("H_m", "the products of inertia taken with the opposite sign", || {
            matrix_times(body.moments, body.products.map(|product| -product), omega).magnitude()
        });
        if is_oblique {
            sheet.common_error(
                "H_m",
                "the moment of inertia about the axis of rotation multiplied by ω alone",
                || omega.dot(about_g) / omega.magnitude(),
            );
        }
        let size =
            sheet.step("H_m", "kg*m^2/s", about_g.magnitude(), "Magnitude of the angular momentum about G");
        sheet.answer("momentum_g_size", "Magnitude of the angular momentum about G", size);
        let mut angle = None;
        if omega.value() != Vector3::zeros() {
            let found = sheet.step(
                "γ",
                "deg",
                omega.cross(about_g).magnitude().atan2(omega.dot(about_g)),
                "Angle between H_G and ω: zero where ω lies along a principal axis",
            );
            sheet.answer(
                "momentum_angle",
                "Angle between the angular momentum and the angular velocity",
                found,
            );
            angle = Some(found);
        }

        let arm = sheet.step_vector("d_A", "m", body.centre - given.point, "From A to G");
        let about_a = sheet.step_vector(
            "H_A",
            "kg*m^2/s",
            about_g + arm.cross(linear),
            (
                "Angular momentum about A: that about G plus the moment of the linear momentum at G",
                BEER.at("§18.1A"),
            ),
        );
        sheet.answer_vector("momentum_a", "Angular momentum about A", about_a);
        sheet.common_error("H_Am", "the magnitudes of the two parts added as numbers", || {
            about_g.magnitude() + arm.cross(linear).magnitude()
        });
        let size =
            sheet.step("H_Am", "kg*m^2/s", about_a.magnitude(), "Magnitude of the angular momentum about A");
        sheet.answer("momentum_a_size", "Magnitude of the angular momentum about A", size);
        if let (Some(line), Some(given)) = (&self.line, &given.line) {
            line_momentum(line, given, &body, about_g, linear, sheet)?;
        }

        let translation = sheet.step(
            "T_v",
            "J",
            body.mass * speed.powi(2) / 2.0,
            ("Kinetic energy of the motion of G", BEER.at("§18.1C")),
        );
        sheet.common_error("T_ω", "the products of inertia ignored", || {
            rigid::rotational_energy(omega, without_products())
        });
        if is_oblique {
            sheet.common_error(
                "T_ω",
                "½ H ω taken with the magnitudes, the angle between them ignored",
                || about_g.magnitude() * omega.magnitude() / 2.0,
            );
        }
        let rotation = sheet.step(
            "T_ω",
            "J",
            rigid::rotational_energy(omega, about_g),
            ("Kinetic energy of the rotation about G", BEER.at("§18.1C")),
        );
        if matches!(self.going, BodyVelocity::Fixed { .. }) {
            sheet.common_error(
                "T",
                "½ m v_G² added to the energy of the rotation about the fixed point",
                || translation * 2.0 + rotation,
            );
        }
        let total = sheet.step("T", "J", translation + rotation, "Kinetic energy");
        if let Some(angle) = angle {
            sheet.check_sum(
                "twice the kinetic energy of rotation is |ω| |H| cos γ",
                omega.magnitude() * about_g.magnitude() * angle.cos(),
                rotation * 2.0,
                omega.value().norm() * about_g.value().norm(),
            );
        }
        sheet.answer("translation_energy", "Kinetic energy of the motion of the centre of mass", translation);
        sheet.answer("rotation_energy", "Kinetic energy of the rotation about the centre of mass", rotation);
        sheet.answer("kinetic_energy", "Kinetic energy", total);
        self.energy_sink(&body, about_g, rotation, sheet)?;

        let (omega, velocity) = (omega.value(), velocity.value());
        sheet.verify(|| {
            // By way of A: its velocity, and the inertia about it.
            let arm = body.properties.centre - self.point;
            let there = velocity + omega.cross(-arm);
            let tensor = body.properties.inertia_about(self.point);
            let mass = body.properties.mass;
            let second = tensor * omega + arm.cross(there) * mass;
            let size = (tensor * omega).norm() + mass * arm.norm() * there.norm();
            sheet.check_zero(
                "the angular momentum about A from the inertia about A: I_A ω + d × m v_A",
                (second - about_a.value()).norm().into(),
                size,
            );
            let terms = [
                omega.dot(tensor * omega) / 2.0,
                mass * there.norm_squared() / 2.0,
                mass * there.dot(omega.cross(arm)),
            ];
            sheet.check_zero(
                "the kinetic energy from the velocity of A and the inertia about A",
                (terms.iter().sum::<f64>() - total.value()).into(),
                terms.iter().map(|term| term.abs()).sum(),
            );
        });
        let about_g = about_g.value();
        sheet.show(|| self.drawn(&body, omega, about_g));
        Ok(())
    }
}

/// The angular momentum about a line, and the angle between it and the angular momentum about G.
fn line_momentum<W: Worksheet>(
    line: &BodyLine,
    given: &BodyLineGiven<W>,
    body: &WorkedBody<W>,
    about_g: W::Vec,
    linear: W::Vec,
    sheet: W,
) -> Result<(), Refusal> {
    directed(line.direction)?;
    let along = sheet.step_vector(
        "λ",
        "1",
        given.direction / given.direction.magnitude(),
        "Direction cosines of the line",
    );
    let about = sheet.step_vector(
        "H_B",
        "kg*m^2/s",
        about_g + (body.centre - given.through).cross(linear),
        "Angular momentum about a point of the line",
    );
    projection_error(about, along, sheet);
    let component = sheet.step(
        "H_λ",
        "kg*m^2/s",
        along.dot(about),
        ("Angular momentum about the line", MERIAM.at("§7/7")),
    );
    sheet.answer("line_momentum", "Angular momentum about the line", component);
    sheet.verify(|| {
        // Of the moment of the linear momentum only the arm across the line counts, whatever point of it is taken.
        let (way, speed) = (given.direction.value().normalize(), linear.value());
        let arm = body.centre.value() - given.through.value();
        let moment = (arm - way * way.dot(arm)).cross(speed).dot(way);
        let second = moment + about_g.value().dot(way);
        sheet.check_sum(
            "the angular momentum about the line from the perpendicular arm",
            component,
            second.into(),
            about_g.value().norm() + arm.norm() * speed.norm(),
        );
    });
    if about.value() != Vector3::zeros() {
        let angle = sheet.step(
            "γ_B",
            "deg",
            along.cross(about).magnitude().atan2(component),
            "Angle between this angular momentum and the line",
        );
        sheet.verify(|| {
            let size = about.value().norm();
            let projected = about.magnitude() * angle.cos();
            sheet.check_sum("the angle to the line from its cosine", projected, component, size);
        });
        sheet.answer(
            "line_angle",
            "Angle between the angular momentum about a point of the line and the line",
            angle,
        );
    }
    Ok(())
}

impl Momentum {
    /// Final rotation when energy is dissipated inside the body and the angular momentum is conserved.
    fn energy_sink<W: Worksheet>(
        &self,
        body: &WorkedBody<W>,
        about_g: W::Vec,
        rotation: W::Num,
        sheet: W,
    ) -> Result<(), Refusal> {
        if rotation.value() <= 0.0 {
            return Ok(());
        }
        let principal = body.properties.check().map_err(|error| refused(&error, "this body"))?;
        let largest = sheet.numerical(
            "I_max",
            "kg*m^2",
            principal.moments.z,
            ("Maximum principal moment of inertia", MERIAM.at("App. B/2")),
        );
        sheet.common_error(
            "ω_f",
            "the kinetic energy taken as conserved in place of the angular momentum",
            || (rotation * 2.0 / largest).sqrt(),
        );
        sheet.common_error("ω_f", "the final rotation taken about the axis of the smallest moment", || {
            about_g.magnitude() / largest * (principal.moments.z / principal.moments.x)
        });
        let rate = sheet.step(
            "ω_f",
            "rad/s",
            about_g.magnitude() / largest,
            "If energy is dissipated inside the body and no couple acts, H_G is conserved: the rotation ends about the axis of maximum moment of inertia",
        );
        let lost = sheet.step(
            "ΔT/T",
            "1",
            W::Num::from(1.0) - largest * rate.powi(2) / 2.0 / rotation,
            "Fraction of the rotational kinetic energy that is lost by then",
        );
        sheet.answer(
            "final_speed",
            "Angular speed about the axis of the largest moment, with the same angular momentum",
            rate,
        );
        sheet.answer("energy_lost", "Fraction of the rotational kinetic energy lost by then", lost);
        sheet.check_sum(
            "the remaining kinetic energy is half of H ω",
            about_g.magnitude() * rate / 2.0,
            rotation - rotation * lost,
            rotation.value(),
        );
        sheet.verify(|| {
            // H² = Σ (I ω)², 2T = Σ I ω² in principal axes.
            let omega = principal.angular_velocity(about_g.value()).unwrap_or_else(|_| Vector3::zeros());
            let own = principal.axes.inverse() * omega;
            let energy = own.component_mul(&own).dot(principal.moments) / 2.0;
            sheet.check_zero(
                "the kinetic energy of rotation from the principal moments",
                (energy - rotation.value()).into(),
                energy.max(rotation.value()),
            );
        });
        if lost.value().abs() <= 1e-9 {
            sheet.warn(|| {
                Text::new("the body rotates about the axis of its largest moment: no energy can be lost at constant angular momentum")
            });
        }
        Ok(())
    }

    fn drawn<W: Worksheet>(
        &self,
        body: &WorkedBody<W>,
        omega: Vector3<f64>,
        momentum: Vector3<f64>,
    ) -> Exhibit {
        let mut scene = Scene::new();
        if let Ok(principal) = body.properties.check() {
            let size = self.body.draw(&mut scene, &body.properties, &principal);
            scene.axes(Vector3::zeros(), &Matrix3::identity(), 0.6 * size, ["x", "y", "z"]);
            let along = |vector: Vector3<f64>| {
                vector.try_normalize(0.0).map_or_else(Vector3::zeros, |unit| unit * size)
            };
            let centre = body.properties.centre;
            match self.turning {
                BodyRotation::RestingPoints { .. } => scene.arrow(centre, along(omega), Ink::Motion, "ω_0"),
                BodyRotation::Momentum { .. } => scene.arrow(centre, along(omega), Ink::Motion, "ω"),
                _ => {}
            }
            self.turning.label(&mut scene, centre, size);
            self.going.label(&mut scene, centre, 0.7 * size);
            scene.label(self.point, "r_A");
            if let Some(line) = &self.line {
                line.draw(&mut scene, centre, size);
            }
            scene.arrow(centre, along(momentum), Ink::Result, self.momentum_letter());
            scene.label(centre, "G");
        }
        scene.exhibit("The body, its angular velocity and its angular momentum")
    }

    /// The angular momentum is found, or given.
    fn momentum_letter(&self) -> &'static str {
        match self.turning {
            BodyRotation::Momentum { .. } => "H_0",
            _ => "H_G",
        }
    }
}
