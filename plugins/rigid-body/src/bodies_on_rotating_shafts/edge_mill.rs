//! An edge mill: rollers that are driven round on a pan press harder than they weigh.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Worksheet, register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, gyroscope},
};
use nalgebra::{Rotation3, Vector3};

use crate::{
    shared::{
        common_errors,
        differences::second_rate,
        scene::{self, Scene},
    },
    sources::BEER,
};

/// A roller on a level arm that is hinged to the upright shaft, and rolls on the pan without slip.
///
/// The axes go with the arm: x outward along it, y the way the roller moves, z up. The hinge lies on the shaft at the
/// height of the roller's axis.
#[derive(Clone, Debug, Inputs)]
pub struct EdgeMill {
    /// Mass of a roller.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Radius of a roller.
    #[input("r", "m", positive)]
    pub radius: f64,
    /// Moment of inertia of the roller about its axis.
    pub inertia: RollerInertia,
    /// Arm.
    /// From the shaft to the middle of the roller.
    #[input("R", "m", positive)]
    pub arm: f64,
    /// Number of rollers.
    #[input(min = 1, max = 12, default = "1")]
    pub rollers: u32,
    /// Speed.
    pub speed: MillSpeed,
    /// Width of the roller.
    /// For the slip at its edges, which does the grinding.
    #[input("b", "m", positive)]
    pub width: Option<f64>,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// The roller about its axis.
#[derive(Clone, Debug, Inputs)]
pub enum RollerInertia {
    /// Solid disc or cylinder
    Solid,
    /// Radius of gyration
    RadiusOfGyration {
        /// Radius of gyration.
        #[input("k", "m", positive)]
        radius_of_gyration: f64,
    },
    /// Given
    Given {
        /// Moment of inertia.
        #[input("I_a", "kg*m^2", positive)]
        inertia: f64,
    },
}

/// Known quantity of the motion.
#[derive(Clone, Debug, Inputs)]
pub enum MillSpeed {
    /// Speed of the shaft
    Shaft {
        /// Speed of the shaft.
        #[input("Ω", "rad/s", nonnegative)]
        speed: f64,
    },
    /// Required crushing force
    CrushingForce {
        /// Force of one roller on the pan.
        #[input("N", "N", positive)]
        force: f64,
    },
}

const ABOUT_CONTACT: &str = "moment of inertia of the roller taken about the point of contact";

register!(EdgeMill);

impl Analysis for EdgeMill {
    const ABOUT: About = About {
        id: "rigid-body/edge-mill",
        title: "Edge mill",
        topic: "Bodies on rotating shafts",
        summary: "Crushing force of a roller driven round on a pan, with its gyroscopic component, the pull of the arm, and the speed for a required force.",
        main: &["crushing_force", "force_ratio"],
        keywords: "edge runner mill Chile mill pan roller crushing grinding gyroscopic moinho moenda galga rolo moagem giroscópico",
        sources: &[&BEER],
        cases: include_str!("../../cases/edge_mill.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EdgeMillGiven<W>, sheet: W) -> Result<(), Refusal> {
        let inertia = match given.inertia {
            RollerInertiaGiven::Solid { .. } => {
                let axial = rigid::disc_axial_inertia(given.mass, given.radius);
                let about_contact = || rigid::parallel_axis(axial, given.mass, given.radius);
                sheet.common_error("I_a", ABOUT_CONTACT, about_contact);
                common_errors::of_disc("I_a", given.mass, given.radius, sheet);
                let why = "Moment of inertia of a solid roller about its axis";
                sheet.step("I_a", "kg*m^2", axial, why)
            }
            RollerInertiaGiven::RadiusOfGyration { radius_of_gyration } => {
                let axial = given.mass * radius_of_gyration.powi(2);
                let about_contact = || rigid::parallel_axis(axial, given.mass, given.radius);
                sheet.common_error("I_a", ABOUT_CONTACT, about_contact);
                sheet.common_error("I_a", common_errors::AS_DISC, || axial / 2.0);
                let why = "Moment of inertia about the axis, from the radius of gyration";
                sheet.step("I_a", "kg*m^2", axial, why)
            }
            RollerInertiaGiven::Given { inertia } => inertia,
        };
        let weight = sheet.step("W", "N", given.mass * given.gravity, "Weight of the roller");
        let (omega, wanted) = match given.speed {
            MillSpeedGiven::Shaft { speed } => (speed, None),
            MillSpeedGiven::CrushingForce { force } => {
                if force.value() < weight.value() {
                    return Err(Refusal::because(
                        "the required force is below the weight of the roller, which already acts at rest: write a larger one",
                    ));
                }
                let omega = sheet.step(
                    "Ω",
                    "rad/s",
                    ((force - weight) * given.radius / inertia).sqrt(),
                    "Speed of the shaft: the gyroscopic component of the force is I_a Ω²/r",
                );
                sheet.answer("shaft_speed", "Speed of the shaft", omega);
                (omega, Some(force))
            }
        };
        sheet.common_error("ω", "roller assumed to spin at the speed of the shaft", || omega);
        let resultant = || omega * (given.arm.powi(2) + given.radius.powi(2)).sqrt() / given.radius;
        sheet.common_error("ω", "resultant angular velocity of the roller used as its spin", resultant);
        let spin = sheet.step(
            "ω",
            "rad/s",
            omega * given.arm / given.radius,
            ("The roller rolls: its centre moves at Ω R = ω r", BEER.at("§15.2C")),
        );
        let couple = sheet.step(
            "C",
            "N*m",
            gyroscope::right_angled_couple(inertia, spin, omega),
            (
                "Gyroscopic couple: the arm rotates the spin angular momentum I_a ω at the rate Ω",
                BEER.at("§18.3"),
            ),
        );
        let slant = || couple / (given.arm.powi(2) + given.radius.powi(2)).sqrt();
        let what = "straight-line distance from the hinge to the point of contact taken as the lever arm";
        sheet.common_error("N_g", what, slant);
        let share = sheet.step(
            "N_g",
            "N",
            couple / given.arm,
            "Gyroscopic component of the force: the pan exerts the couple about the hinge with the lever arm R",
        );
        let force = sheet.step(
            "N",
            "N",
            weight + share,
            ("Force between roller and pan: moments about the hinge", BEER.at("§18.2")),
        );
        let ratio = sheet.step("n", "1", force / weight, "Force as a multiple of the weight");
        let of_spin = || given.mass * spin.powi(2) * given.arm;
        let what = "spin of the roller used in place of the speed of the shaft in the centripetal force";
        sheet.common_error("S", what, of_spin);
        let pull = sheet.step(
            "S",
            "N",
            given.mass * omega.powi(2) * given.arm,
            "Pull of the arm, which keeps the roller on its circle",
        );
        let lift = sheet.step(
            "V",
            "N",
            -share,
            "Vertical force of the hinge on the arm, positive upwards: it holds the arm down",
        );
        sheet.answer("crushing_force", "Force of a roller on the pan", force);
        sheet.answer("force_ratio", "Force as a multiple of the weight", ratio);
        sheet.answer("gyroscopic_force", "Gyroscopic component of the force", share);
        sheet.answer("couple", "Gyroscopic couple", couple);
        sheet.answer("spin", "Angular speed of the roller about its axis", spin);
        sheet.answer("arm_pull", "Pull of the arm", pull);
        sheet.answer("hinge_force", "Vertical force of the hinge on the arm, upwards", lift);
        if self.rollers > 1 {
            let total =
                sheet.step("ΣN", "N", force * f64::from(self.rollers), "Force of all rollers on the pan");
            sheet.answer("total_force", "Force of all rollers on the pan", total);
        }
        let sliding = given.width.map(|width| {
            let of_spin = || spin * width / 2.0;
            sheet.common_error("v_s", "spin of the roller used in place of the speed of the shaft", of_spin);
            let whole = || omega * (given.arm + width / 2.0);
            let what = "whole speed of the edge about the shaft taken, that of rolling not subtracted";
            sheet.common_error("v_s", what, whole);
            let sliding = sheet.step(
                "v_s",
                "m/s",
                omega * width / 2.0,
                "Sliding at the edges of the roller: only its middle rolls without slipping",
            );
            sheet.answer("edge_sliding", "Sliding speed at the edges", sliding);
            if width.value() >= 2.0 * self.arm {
                sheet.warn(|| "the roller is so wide that it reaches the shaft".into());
            }
            sliding
        });
        let (omega, inertia) = (omega.value(), inertia.value());
        sheet.verify(|| {
            if let Some(wanted) = wanted {
                sheet.check("the force at that speed is the required one", force, wanted);
            }
            let centre =
                |t: f64| Rotation3::from_scaled_axis(Vector3::z() * (omega * t)) * Vector3::x() * self.arm;
            if let Some(acceleration) = second_rate(centre, TAU / omega) {
                let what = "mass times the acceleration of the centre, by finite differences of its position";
                sheet.check(what, pull, (self.mass * acceleration.norm()).into());
            }
            if let Some(sliding) = sliding {
                let edge = omega * (self.arm + self.width.unwrap_or(0.0) / 2.0);
                let what = "speed over the pan at the edge less that of the rim";
                sheet.check_sum(what, sliding, (edge - spin.value() * self.radius).into(), edge);
            }
            let moment = self.moment_about_hinge(inertia, omega);
            let size = force.value().abs() * self.arm + couple.value();
            if let Ok(rate) = moment {
                // Weight at R, pan force at R: (N − m g) (−y) R, and nothing about the upright.
                let expected = Vector3::new(0.0, -(force.value() - weight.value()) * self.arm, 0.0);
                sheet.check_zero(
                    "the moments about the hinge from the difference quotient of the angular momentum",
                    W::Num::from((rate - expected).norm()),
                    size,
                );
            }
        });
        sheet.show(|| Exhibit::Plot(self.force_over_speed(inertia, omega, force.value())));
        sheet.show(|| self.animation());
        Ok(())
    }
}

impl EdgeMill {
    /// Rate of change of the angular momentum about the hinge, from the tensor turned with the roller and the momentum
    /// of its centre. The transverse moment of inertia has no part in it.
    fn moment_about_hinge(&self, inertia: f64, omega: f64) -> Result<Vector3<f64>, rigid::RigidError> {
        // Rolling the way of +y on the floor below, the roller turns about −x.
        let spin = omega * self.arm / self.radius;
        let tensor = gyroscope::symmetric_tensor(inertia, inertia, Vector3::x());
        let about = Vector3::z() * omega;
        let momentum_at = |t: f64| {
            let centre = Rotation3::from_scaled_axis(about * t) * Vector3::x() * self.arm;
            let velocity = Vector::cross(about, centre);
            gyroscope::momentum_at(&tensor, spin, -Vector3::x(), about, t)
                + Vector::cross(centre, velocity) * self.mass
        };
        let period = if omega > 0.0 { TAU / omega } else { 1.0 };
        rigid::numerical_rate(momentum_at, period)
    }

    fn force_over_speed(&self, inertia: f64, omega: f64, force: f64) -> Plot {
        let weight = self.mass * self.gravity;
        // Up to four times the weight where the mill is at rest.
        let most = if omega > 0.0 { 1.6 * omega } else { (3.0 * weight * self.radius / inertia).sqrt() };
        let at = |n: u16| {
            let omega = most * f64::from(n) / 200.0;
            (omega, weight + inertia * omega.powi(2) / self.radius)
        };
        Plot::new(
            "Crushing force against the speed of the shaft",
            Axis::linear("speed of the shaft", "rpm"),
            Axis::linear("force of a roller", "N"),
            vec![Series::line("N", (0..=200).map(at).collect()).of("crushing_force")],
        )
        .over("speed.shaft.speed")
        .level("weight", weight)
        .mark("at this speed", (omega, force))
    }

    /// The rollers on the pan over a turn of the shaft, with the radius of the roller and the arm to scale.
    fn animation(&self) -> Exhibit {
        let size = self.arm.max(self.radius);
        let (arm, radius) = (self.arm / size, self.radius / size);
        let count = self.rollers.min(4);
        scene::animation("The rollers on the pan", 4.0, |t| {
            let mut scene = Scene::new();
            scene.circle(Vector3::zeros(), Vector3::z(), arm, Ink::Faint);
            scene.circle(Vector3::zeros(), Vector3::z(), 1.3 * arm, Ink::Body);
            scene.line([Vector3::zeros(), Vector3::z() * (radius + 0.6)], Ink::Body);
            for roller in 0..count {
                let angle = TAU * (t + f64::from(roller) / f64::from(count));
                let carrier = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
                let hub = Vector3::z() * radius;
                let centre = hub + carrier * Vector3::x() * arm;
                // The third axis of the disc along the arm.
                let level = Rotation3::from_axis_angle(&Vector3::y_axis(), TAU / 4.0);
                let spin = Rotation3::from_axis_angle(&Vector3::z_axis(), -TAU * t * arm / radius);
                scene.disc(centre, (carrier * level * spin).matrix(), radius, Ink::Body);
                scene.line([hub, centre], Ink::Body);
                if roller == 0 {
                    let [out, along] = [carrier * Vector3::x(), carrier * Vector3::y()];
                    scene.dimension("R", [hub, centre], Vector3::z() * 0.25);
                    scene.line([centre, centre - Vector3::z() * radius], Ink::Faint);
                    scene.label(centre - Vector3::z() * (0.5 * radius), "r");
                    let letters = match self.inertia {
                        RollerInertia::Solid => "m",
                        RollerInertia::RadiusOfGyration { .. } => "m, k",
                        RollerInertia::Given { .. } => "m, I_a",
                    };
                    scene.label(centre + (along + Vector3::z()) * (0.71 * radius), letters);
                    if let Some(width) = self.width {
                        let half = out * (width / size / 2.0);
                        let top = centre + Vector3::z() * radius;
                        scene.dimension("b", [top - half, top + half], Vector3::z() * 0.12);
                    }
                    let foot = centre - Vector3::z() * radius;
                    scene.arrow(foot - Vector3::z() * 0.5, Vector3::z() * 0.5, Ink::Force, "");
                    scene.label(foot - Vector3::z() * 0.5, "N");
                }
            }
            scene.turn("Ω", Vector3::z() * (radius + 0.4), Vector3::z(), 0.25, Ink::Motion);
            scene
        })
    }
}
