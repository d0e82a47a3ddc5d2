//! A thin disc that spins on an arm, while the arm turns.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, Vector, rigid};
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::{
    shared::scene::Scene,
    sources::{BEER, RIUL},
};

/// The disc, its spin, and the arm that carries it.
///
/// The axes Axyz have their origin in the centre A of the disc and turn with the arm: y along the axis of the arm,
/// z along the axis of the disc. XYZ are fixed, and the same at arm angle zero.
#[derive(Clone, Debug, Inputs)]
pub struct SpinningDiscOnArm {
    /// Mass of the disc.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Radius of the disc.
    #[input("r", "m", positive)]
    pub radius: f64,
    /// Angular velocity of the arm.
    /// About the y axis.
    #[input("ω₁", "rad/s")]
    pub arm_speed: f64,
    /// Spin of the disc relative to the arm.
    /// About the z axis, relative to the arm.
    #[input("ω₂", "rad/s")]
    pub spin: f64,
    /// Angular acceleration of the arm.
    #[input("α₁", "rad/s^2", default = "0 rad/s^2")]
    pub arm_acceleration: f64,
    /// Rate of change of the spin.
    #[input("α₂", "rad/s^2", default = "0 rad/s^2")]
    pub spin_acceleration: f64,
    /// Angle of the arm.
    /// From the fixed axes to the axes rotating with the arm, about y.
    #[input("φ", "rad", default = "0 deg")]
    pub arm_angle: f64,
    /// Distance of the disc's centre from the axis of the arm.
    /// For the kinetic energy of the complete motion; it does not affect the angular momentum about A.
    #[input("d", "m", nonnegative)]
    pub centre_distance: Option<f64>,
}

register!(SpinningDiscOnArm);

impl Analysis for SpinningDiscOnArm {
    const ABOUT: About = About {
        id: "rigid-body/spinning-disc-on-arm",
        title: "Disc spinning on a turning arm",
        topic: "Bodies on rotating shafts",
        summary: "Angular momentum of a thin disc that spins on a rotating arm, its rate of change, and the couple that the arm exerts.",
        main: &["couple", "angular_acceleration", "angular_momentum"],
        keywords: "gyroscope gyroscopic couple disc arm giroscópio giroscópico disco braço momento angular exemplo 3",
        sources: &[&RIUL, &BEER],
        cases: include_str!("../../cases/spinning_disc_on_arm.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &SpinningDiscOnArmGiven<W>, sheet: W) -> Result<(), Refusal> {
        let zero = W::Num::from(0.0);
        let diametral = sheet.step(
            "I_d",
            "kg*m^2",
            rigid::disc_diametral_inertia(given.mass, given.radius),
            ("Moment of inertia about a diameter: Iₓ = I_y", RIUL.at("example 3")),
        );
        let axial = sheet.step(
            "I_z",
            "kg*m^2",
            rigid::disc_axial_inertia(given.mass, given.radius),
            ("Moment of inertia about the axis of the disc", RIUL.at("example 3")),
        );
        let inertia = [diametral, diametral, axial];
        let axes = sheet.step_vector(
            "Ω",
            "rad/s",
            W::Vec::from_components(zero, given.arm_speed, zero),
            ("The axes xyz rotate with the arm", RIUL.at("eq. 44")),
        );
        let omega = sheet.step_vector(
            "ω",
            "rad/s",
            W::Vec::from_components(zero, given.arm_speed, given.spin),
            (
                "Angular velocity of the disc: rotation of the arm plus the spin relative to it",
                RIUL.at("example 3"),
            ),
        );
        let relative = sheet.step_vector(
            "ω̇",
            "rad/s^2",
            W::Vec::from_components(zero, given.arm_acceleration, given.spin_acceleration),
            "Rates of change of the components of ω in axes rotating with the arm",
        );
        let alpha = sheet.step_vector(
            "α",
            "rad/s^2",
            relative + axes.cross(omega),
            ("Angular acceleration of the disc", BEER.at("§15.5A")),
        );
        let momentum = sheet.step_vector(
            "H_A",
            "kg*m^2/s",
            rigid::angular_momentum(inertia, omega),
            (
                "Angular momentum about the centre: x, y and z are principal axes, whatever the spin angle of the disc",
                RIUL.at("eqs. 45–46"),
            ),
        );
        let seen = sheet.step_vector(
            "Ḣ_rel",
            "N*m",
            rigid::relative_rate(inertia, relative),
            ("Rate of change relative to axes rotating with the arm", RIUL.at("eq. 47")),
        );
        let turned = sheet.step_vector(
            "Ḣ_turn",
            "N*m",
            rigid::transport_rate(axes, momentum),
            ("Transport term Ω × H", RIUL.at("eq. 44")),
        );
        let couple = sheet.step_vector(
            "M_A",
            "N*m",
            seen + turned,
            ("Couple that the arm exerts on the disc: ΣM = dH/dt", RIUL.at("eqs. 23, 44")),
        );
        let without_rates = || (axial - diametral) * given.arm_speed * given.spin;
        let what = "Euler's equations for axes fixed in the disc used with the rates of ω omitted";
        sheet.common_error("Mₓ", what, without_rates);
        let resultant = || (given.arm_speed.powi(2) + given.spin.powi(2)).sqrt();
        let of_resultant = || axial * given.arm_speed * resultant();
        let what = "magnitude of the resultant angular velocity used as the spin";
        sheet.common_error("Mₓ", what, of_resultant);
        let of_both = || (axial + diametral) * given.arm_speed * given.spin;
        let what = "rotation of the axes counted twice: I_d α added to Ω × H";
        sheet.common_error("Mₓ", what, of_both);
        let gyroscopic = sheet.step(
            "Mₓ",
            "N*m",
            axial * given.arm_speed * given.spin,
            ("Gyroscopic couple: its component along x in closed form", BEER.at("§18.3")),
        );
        let fixed_momentum = sheet.step_vector(
            "H_XYZ",
            "kg*m^2/s",
            rigid::to_fixed_axes(rigid::Axis::Y, given.arm_angle, momentum),
            "Components of the angular momentum in the fixed axes",
        );
        let fixed_couple = sheet.step_vector(
            "M_XYZ",
            "N*m",
            rigid::to_fixed_axes(rigid::Axis::Y, given.arm_angle, couple),
            "Components of the couple in the fixed axes",
        );
        let of_spin = || axial * given.spin.powi(2) / 2.0;
        sheet.common_error("T_rot", "energy of the spin alone taken", of_spin);
        let of_resultant = || axial * resultant().powi(2) / 2.0;
        let what = "½I_z ω² used with the resultant angular velocity";
        sheet.common_error("T_rot", what, of_resultant);
        let rotation_energy = sheet.step(
            "T_rot",
            "J",
            rigid::rotational_energy(omega, momentum),
            ("Kinetic energy of rotation about the centre", BEER.at("§18.1C")),
        );
        sheet.answer("diametral_inertia", "Moment of inertia about a diameter", diametral);
        sheet.answer("axial_inertia", "Moment of inertia about the axis of the disc", axial);
        sheet.answer_vector("angular_velocity", "Angular velocity of the disc", omega);
        sheet.answer_vector("angular_acceleration", "Angular acceleration of the disc", alpha);
        sheet.answer_vector(
            "angular_momentum",
            "Angular momentum about the centre, axes of the arm",
            momentum,
        );
        sheet.answer_vector("relative_rate", "(dH/dt) relative to the axes of the arm", seen);
        sheet.answer_vector("transport_rate", "Ω × H", turned);
        sheet.answer_vector("couple", "Couple on the disc, axes of the arm", couple);
        sheet.answer("gyroscopic_couple", "Gyroscopic couple about x", gyroscopic);
        sheet.answer_vector(
            "fixed_angular_momentum",
            "Angular momentum about the centre, fixed axes",
            fixed_momentum,
        );
        sheet.answer_vector("fixed_couple", "Couple on the disc, fixed axes", fixed_couple);
        sheet.answer("rotational_energy", "Kinetic energy of rotation", rotation_energy);
        sheet.verify(|| {
            sheet.check_sum(
                "the gyroscopic couple is the component of the couple along x",
                gyroscopic,
                couple.components()[0],
                couple.value().norm(),
            );
            sheet.check(
                "the kinetic energy of rotation from the squares of both speeds",
                rotation_energy,
                (diametral * given.arm_speed.powi(2) + axial * given.spin.powi(2)) / 2.0,
            );
        });
        if let Some(distance) = given.centre_distance {
            let of_resultant = || distance * resultant();
            let what = "resultant angular velocity of the disc used for the motion of its centre";
            sheet.common_error("v_A", what, of_resultant);
            let speed = sheet.step(
                "v_A",
                "m/s",
                distance * given.arm_speed.abs(),
                "Speed of the centre on its circle about the axis of the arm",
            );
            let energy = sheet.step(
                "T",
                "J",
                given.mass * speed.powi(2) / 2.0 + rotation_energy,
                ("Kinetic energy of the complete motion", BEER.at("§18.1C")),
            );
            sheet.answer("centre_speed", "Speed of the centre", speed);
            sheet.answer("kinetic_energy", "Kinetic energy", energy);
            // About the axis of the arm everything but the spin turns as one body.
            let about_arm = diametral + given.mass * distance.powi(2);
            sheet.check(
                "the kinetic energy from the moment of inertia about the axis of the arm",
                energy,
                (about_arm * given.arm_speed.powi(2) + axial * given.spin.powi(2)) / 2.0,
            );
        }
        sheet.verify(|| {
            sheet.check_vector(
                "the couple from Euler's equations in axes fixed in the disc",
                rigid::euler_moment(inertia, omega, alpha),
                couple,
            );
            self.check_by_rotation(sheet, fixed_momentum, fixed_couple);
        });
        let (momentum, couple) = (momentum.value(), couple.value());
        sheet.show(|| self.disc_on_arm(momentum, couple));
        sheet.show(|| Exhibit::Plot(self.couple_over_a_turn(couple)));
        Ok(())
    }
}

impl SpinningDiscOnArm {
    /// A second method to everything: the whole tensor, turned by finite rotations, times the angular velocity, in fixed
    /// axes; and the difference quotient of that product in time.
    fn check_by_rotation<W: Worksheet>(&self, sheet: W, momentum: W::Vec, couple: W::Vec) {
        let Ok(tensor) = rigid::disc_tensor(self.mass, self.radius, Vector3::z()) else { return };
        let momentum_at = |t: f64| {
            let arm = self.arm_angle + (self.arm_speed + self.arm_acceleration * t / 2.0) * t;
            let spin = (self.spin + self.spin_acceleration * t / 2.0) * t;
            let arm = Rotation3::from_axis_angle(&Vector3::y_axis(), arm);
            let disc = arm * Rotation3::from_axis_angle(&Vector3::z_axis(), spin);
            let omega = Vector3::y() * (self.arm_speed + self.arm_acceleration * t)
                + arm * Vector3::z() * (self.spin + self.spin_acceleration * t);
            rigid::turned(&tensor, &disc) * omega
        };
        sheet.check_zero(
            "the angular momentum from the inertia tensor rotated with the disc: R I Rᵀ ω",
            W::Num::from((momentum_at(0.0) - momentum.value()).norm()),
            momentum.value().norm(),
        );
        // The spin leaves the tensor of a disc as it is: only the turning of the arm sets the time scale.
        let period = (TAU / self.arm_speed.abs()).min((TAU / self.arm_acceleration.abs()).sqrt());
        let period = if period.is_finite() { period } else { 1.0 };
        let Ok(rate) = rigid::numerical_rate(momentum_at, period) else { return };
        sheet.check_zero(
            "the couple from the difference quotient of R I Rᵀ ω",
            W::Num::from((rate - couple.value()).norm()),
            momentum.value().norm() * TAU / period + couple.value().norm(),
        );
    }

    /// The couple in fixed axes over a turn of the arm, at the rates of the moment.
    fn couple_over_a_turn(&self, couple: Vector3<f64>) -> Plot {
        let at = |angle: f64| rigid::to_fixed_axes(rigid::Axis::Y, angle, couple);
        let along = |axis: usize| -> Vec<(f64, f64)> {
            (0..=180).map(|n| TAU * f64::from(n) / 180.0).map(|angle| (angle, at(angle)[axis])).collect()
        };
        let here = self.arm_angle.rem_euclid(TAU);
        Plot::new(
            "Couple on the disc in fixed axes over a revolution of the arm",
            Axis::linear("angle of the arm", "deg"),
            Axis::linear("couple", "N*m"),
            vec![
                Series::line("M_X", along(0)).of("fixed_couple.x"),
                Series::line("M_Y", along(1)).of("fixed_couple.y"),
                Series::line("M_Z", along(2)).of("fixed_couple.z"),
            ],
        )
        .over("arm_angle")
        .mark("M_X at this angle", (here, at(here).x))
        .mark("M_Z at this angle", (here, at(here).z))
    }

    /// The disc on its arm, in the axes that turn with the arm; the fixed axes stand at the foot of the shaft.
    fn disc_on_arm(&self, momentum: Vector3<f64>, couple: Vector3<f64>) -> Exhibit {
        let mut scene = Scene::y_up();
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let centre = z * 2.4;
        // The disc hangs in the air, well above the bearing of the shaft: it rolls on nothing.
        let foot = y * -2.6;
        scene.line([foot, y * 1.2], Ink::Body);
        scene.cuboid(foot, &Matrix3::identity(), Vector3::new(0.5, 0.5, 0.5), Ink::Body);
        scene.line([Vector3::zeros(), centre], Ink::Body);
        scene.disc(centre, &Matrix3::identity(), 1.0, Ink::Body);
        scene.label(centre + (x - y) * 0.7, "m");
        let (sin, cos) = 0.8_f64.sin_cos();
        scene.line([centre, centre + x * -cos + y * sin], Ink::Faint);
        scene.label(centre + (x * -cos + y * sin) * 0.6, "r");
        for (axis, name) in [(x, "x"), (y, "y"), (z, "z")] {
            scene.arrow(centre, axis * 1.5, Ink::Faint, name);
        }
        scene.label(centre, "A");
        // The fixed axes lie behind the arm by its angle.
        let fixed = Rotation3::from_axis_angle(&Vector3::y_axis(), -self.arm_angle);
        scene.arrow(foot, fixed * z * 1.6, Ink::Faint, "Z");
        scene.arrow(foot, fixed * x * 1.6, Ink::Faint, "X");
        if self.arm_angle != 0.0 {
            scene.line([foot, foot + z * 1.4], Ink::Faint);
            scene.angle("φ", foot, [fixed * z, z], 1.0);
        }
        scene.turn(both("ω₁", "α₁", self.arm_acceleration), y * 0.9, y * self.arm_speed, 0.4, Ink::Motion);
        let spin = both("ω₂", "α₂", self.spin_acceleration);
        scene.turn(spin, centre + z * 0.8, z * self.spin, 0.4, Ink::Motion);
        if self.centre_distance.is_some() {
            scene.dimension("d", [Vector3::zeros(), centre], y * -1.2);
        }
        for (vector, length, ink, name) in
            [(momentum, 1.9, Ink::Result, "H_A"), (couple, 2.2, Ink::Force, "M_A")]
        {
            if let Some(along) = vector.try_normalize(0.0) {
                scene.arrow(centre, along * length, ink, name);
            }
        }
        scene.exhibit("The disc on its arm")
    }
}

/// The letter of a speed, with that of its rate of change where there is one.
fn both(speed: &'static str, rate: &'static str, value: f64) -> Text {
    if value == 0.0 { speed.into() } else { Text::verbatim(format!("{speed}, {rate}")) }
}
