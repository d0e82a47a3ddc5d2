//! A two-bladed propeller whose carrier turns: the couple pulses twice in each turn.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, gyroscope},
};
use dalembert_numerics::quadrature;
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::{
    shared::scene::{self, Scene},
    sources::{BEER, BEVAN},
};

/// The rotor, its spin, and the precession of its carrier about an axis normal to that of the spin.
///
/// The axes go with the carrier: x along the spin, y along the precession, z normal to both (x × y).
#[derive(Clone, Debug, Inputs)]
pub struct TwoBladedRotor {
    /// Rotor.
    pub rotor: Blades,
    /// Speed of the rotor.
    /// Relative to the carrier, about x.
    #[input("ω", "rad/s")]
    pub spin: f64,
    /// Precession.
    pub precession: Precession,
    /// Angle of the blades.
    /// From the precession axis, in the sense of the spin.
    #[input("χ", "rad", default = "0 deg")]
    pub angle: f64,
}

/// Moments of inertia of the rotor.
#[derive(Clone, Debug, Inputs)]
pub enum Blades {
    /// Slender blades
    /// The moment of inertia along them is neglected.
    Slender {
        /// Moment of inertia about the spin axis.
        #[input("I_a", "kg*m^2", positive)]
        inertia: f64,
    },
    /// Uniform slender rod
    Rod {
        /// Mass of both blades.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Length from tip to tip.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Three principal moments of inertia
    Principal {
        /// Moment of inertia about the spin axis.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
        /// Moment of inertia about the line of the blades.
        #[input("I_b", "kg*m^2", nonnegative)]
        along: f64,
        /// Moment of inertia about the line across the blades.
        #[input("I_c", "kg*m^2", positive)]
        across: f64,
    },
}

/// Angular velocity of the carrier.
#[derive(Clone, Debug, Inputs)]
pub enum Precession {
    /// On a curve
    Turn {
        /// Speed.
        #[input("v", "m/s")]
        speed: f64,
        /// Radius of the curve.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// At an angular velocity
    Rate {
        /// Angular velocity of the carrier.
        #[input("Ω", "rad/s")]
        rate: f64,
    },
}

register!(TwoBladedRotor);

impl Analysis for TwoBladedRotor {
    const ABOUT: About = About {
        id: "rigid-body/two-bladed-rotor",
        title: "Gyroscopic couple of a two-bladed propeller",
        topic: "Bodies on rotating shafts",
        summary: "Couple on a two-bladed rotor whose carrier turns: components about the spin axis, the precession axis and their normal, variation with the blade angle, and mean.",
        main: &["mean_couple", "pulsation", "couple"],
        keywords: "propeller airscrew two blades gyroscopic pulsating hélice duas pás giroscópico pulsante wind turbine aerogerador",
        sources: &[&BEVAN, &BEER],
        cases: include_str!("../../cases/two_bladed_rotor.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TwoBladedRotorGiven<W>, sheet: W) -> Result<(), Refusal> {
        let zero = W::Num::from(0.0);
        let (axial_inertia, difference, along_blades) = match given.rotor {
            BladesGiven::Slender { inertia } => (inertia, inertia, zero),
            BladesGiven::Rod { mass, length } => {
                let about_end = || mass * length.powi(2) / 3.0;
                let what = "moment of inertia of the rod taken about one end, mL²/3";
                sheet.common_error("I_a", what, about_end);
                let disc = || rigid::disc_axial_inertia(mass, length / 2.0);
                sheet.common_error("I_a", "rotor treated as a solid disc of the same diameter", disc);
                let tips = || mass * (length / 2.0).powi(2);
                sheet.common_error("I_a", "mass of the blades taken at their tips", tips);
                let inertia = sheet.step(
                    "I_a",
                    "kg*m^2",
                    rigid::rod_inertia(mass, length),
                    "Moment of inertia of the rod about the spin axis, and across the blades; along them it is zero",
                );
                sheet.answer("axial_inertia", "Moment of inertia about the spin axis", inertia);
                sheet.verify(|| {
                    let half = length.value() / 2.0;
                    let sum = quadrature::integral(|x| x * x, [-half, half], 1) * mass.value() / (2.0 * half);
                    sheet.check("moment of inertia of the rod, piece by piece", inertia, sum.into());
                });
                (inertia, inertia, zero)
            }
            BladesGiven::Principal { axial, along, across } => {
                hold_to_triangle([axial, along, across].map(Real::value))?;
                let difference = sheet.step(
                    "D",
                    "kg*m^2",
                    across - along,
                    "Difference between the moments of inertia across and along the blades",
                );
                (axial, difference, along)
            }
        };
        let rate = match given.precession {
            PrecessionGiven::Turn { speed, radius } => {
                let rate =
                    sheet.step("Ω", "rad/s", speed / radius, "Angular velocity of the carrier on its curve");
                sheet.answer("precession_rate", "Angular velocity of the precession", rate);
                sheet.verify(|| {
                    let at = |t: f64| {
                        let turned = Rotation3::from_scaled_axis(Vector3::y() * (rate.value() * t));
                        turned * Vector3::x() * radius.value()
                    };
                    let Ok(velocity) = rigid::numerical_rate(at, TAU / rate.value().abs()) else { return };
                    let what = "speed on the curve, by finite differences of the position";
                    sheet.check(what, speed.abs(), velocity.norm().into());
                });
                rate
            }
            PrecessionGiven::Rate { rate } => rate,
        };
        let (spin, angle) = (given.spin, given.angle);
        let mean = sheet.step(
            "C_m",
            "N*m",
            gyroscope::right_angled_couple(axial_inertia, spin, rate),
            "Mean over a revolution: the couple of a symmetric rotor with the same moment of inertia about its axis",
        );
        if let BladesGiven::Principal { axial, .. } = given.rotor {
            let what = "moment of inertia about the spin axis used in the pulsating part";
            sheet.common_error("C_p", what, || spin * rate * axial);
        }
        let swing = sheet.step(
            "C_p",
            "N*m",
            spin * rate * difference,
            "Amplitude of the component at twice per revolution",
        );
        let normal = sheet.step(
            "M_z",
            "N*m",
            gyroscope::blades_couple_normal(axial_inertia, difference, spin, rate, angle),
            (
                "Couple about the normal to spin and precession: Euler's equations in the axes of the blades, rotated back by χ",
                BEVAN.at("ch. 2"),
            ),
        );
        let with_mean = || mean + swing * (angle * 2.0).sin();
        sheet.common_error("M_y", "mean couple added to the component about the precession axis", with_mean);
        let along = sheet.step(
            "M_y",
            "N*m",
            gyroscope::blades_couple_precession(difference, spin, rate, angle),
            ("Couple about the precession axis", BEVAN.at("ch. 2")),
        );
        let axial = sheet.step(
            "Mₓ",
            "N*m",
            gyroscope::blades_couple_spin(difference, rate, angle),
            ("Couple about the spin axis, which books neglect: it keeps the spin constant", BEER.at("§18.2")),
        );
        let couple = sheet.step_vector(
            "M",
            "N*m",
            W::Vec::from_components(axial, along, normal),
            "Couple on the rotor",
        );
        let across = sheet.step(
            "C",
            "N*m",
            (along.powi(2) + normal.powi(2)).sqrt(),
            "Resultant of the couple normal to the axle: it bends the shaft",
        );
        let at_right_angles = || (mean.powi(2) + swing.powi(2)).sqrt();
        let what = "mean and pulsating part combined as components at right angles";
        sheet.common_error("C_max", what, at_right_angles);
        let largest = sheet.step(
            "C_max",
            "N*m",
            mean.abs() + swing.abs(),
            "Maximum resultant, twice per revolution: with slender blades, where they lie along the precession axis",
        );
        let least = sheet.step(
            "C_min",
            "N*m",
            (mean.abs() - swing.abs()).abs(),
            "Minimum resultant, a quarter of a revolution later",
        );
        let reaction =
            sheet.step_vector("M_R", "N*m", -couple, "Reaction on the carrier: equal and opposite");
        sheet.answer("mean_couple", "Mean couple", mean);
        sheet.answer("pulsation", "Amplitude of the pulsating part", swing);
        sheet.answer("couple_normal", "Couple about the normal to spin and precession", normal);
        sheet.answer("couple_precession", "Couple about the precession axis", along);
        sheet.answer("couple_spin", "Couple about the spin axis", axial);
        sheet.answer_vector("couple", "Couple on the rotor (spin, precession, normal)", couple);
        sheet.answer("resultant", "Resultant normal to the axle", across);
        sheet.answer("largest_resultant", "Maximum resultant over a revolution", largest);
        sheet.answer("least_resultant", "Minimum resultant over a revolution", least);
        sheet.answer_vector("reaction", "Reaction on the carrier (spin, precession, normal)", reaction);
        let (along, across_blades) = (along_blades.value(), (along_blades + difference).value());
        let (inertia, rate) = ([axial_inertia.value(), along, across_blades], rate.value());
        sheet.verify(|| {
            let twice = mean * swing * (angle * 2.0).cos() * 2.0;
            let size = mean.value().powi(2) + swing.value().powi(2);
            sheet.check_sum(
                "the resultant from its mean and its pulsating part by the law of cosines",
                across.powi(2),
                mean.powi(2) + swing.powi(2) + twice,
                size,
            );
            sheet.check_sum(
                "the product of the maximum and the minimum resultant",
                largest * least,
                (mean.powi(2) - swing.powi(2)).abs(),
                size,
            );
            self.check_by_rotation(inertia, rate, couple, sheet);
            // What the kinetic energy of the precession changes by with the angle of the blades.
            let at_rest = Matrix3::from_diagonal(&inertia.into());
            let energy = |turned: f64| {
                let blades = Rotation3::from_axis_angle(&Vector3::x_axis(), self.angle + turned);
                Vector3::x() * (rigid::turned(&at_rest, &blades)[(1, 1)] * rate.powi(2) / 2.0)
            };
            if let Ok(slope) = rigid::numerical_rate(energy, PI) {
                sheet.check_sum(
                    "couple of the spin from the kinetic energy by Lagrange's equation",
                    axial,
                    (-slope.x).into(),
                    (inertia[1] + inertia[2]) * rate.powi(2),
                );
            }
        });
        sheet.show(|| Exhibit::Plot(self.couple_over_a_turn(inertia, rate, across.value())));
        sheet.show(|| self.animation(couple.value()));
        Ok(())
    }
}

/// No moment of inertia is larger than the sum of the other two.
fn hold_to_triangle([axial, along, across]: [f64; 3]) -> Result<(), Refusal> {
    let broken =
        [("I_a", axial, along + across), ("I_b", along, across + axial), ("I_c", across, axial + along)]
            .into_iter()
            .find(|(_, one, others)| *one > others * (1.0 + 1e-9));
    match broken {
        None => Ok(()),
        Some((name, ..)) => Err(Refusal::because(
            Text::new("these moments of inertia violate the triangle inequality: {name} is larger than the sum of the other two")
                .with("name", name),
        )),
    }
}

impl TwoBladedRotor {
    /// A second method: the whole tensor turned with the rotor, times its angular velocity, and the difference quotient of
    /// that product in time.
    fn check_by_rotation<W: Worksheet>(&self, inertia: [f64; 3], rate: f64, couple: W::Vec, sheet: W) {
        // At angle zero the blades lie along y.
        let at_rest = Matrix3::from_diagonal(&inertia.into());
        let start = Rotation3::from_axis_angle(&Vector3::x_axis(), self.angle);
        let tensor = rigid::turned(&at_rest, &start);
        let precession = Vector3::y() * rate;
        let momentum_at = |t: f64| gyroscope::momentum_at(&tensor, self.spin, Vector3::x(), precession, t);
        let fastest = 2.0 * self.spin.abs() + rate.abs();
        let period = if fastest > 0.0 { TAU / fastest } else { 1.0 };
        let Ok(derivative) = rigid::numerical_rate(momentum_at, period) else { return };
        sheet.check_zero(
            "the couple from the difference quotient of R I Rᵀ ω",
            W::Num::from((derivative - couple.value()).norm()),
            inertia[0].max(inertia[2]) * (self.spin.abs() + rate.abs()) * fastest,
        );
    }

    fn couple_over_a_turn(&self, inertia: [f64; 3], rate: f64, here: f64) -> Plot {
        let along = |couple: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
            (0..=180).map(|n| TAU * f64::from(n) / 180.0).map(|angle| (angle, couple(angle))).collect()
        };
        let [axial, along_blades, across] = inertia;
        let difference = across - along_blades;
        let normal = |angle: f64| gyroscope::blades_couple_normal(axial, difference, self.spin, rate, angle);
        let precession = |angle: f64| gyroscope::blades_couple_precession(difference, self.spin, rate, angle);
        let resultant = |angle: f64| normal(angle).hypot(precession(angle));
        Plot::new(
            "Couple on the rotor over a revolution of the blades",
            Axis::linear("angle of the blades", "deg"),
            Axis::linear("couple", "N*m"),
            vec![
                Series::line("C", along(&resultant)).of("resultant"),
                Series::line("M_y", along(&precession)).of("couple_precession"),
                Series::line("M_z", along(&normal)).of("couple_normal"),
            ],
        )
        .over("angle")
        .mark("at this angle", (self.angle.rem_euclid(TAU), here))
    }

    /// The rotor from its angle on over a turn, seen from the front and below.
    fn animation(&self, couple: Vector3<f64>) -> Exhibit {
        scene::animation("Blades over one revolution: axle along x, precession about y", 4.0, |t| {
            let mut scene = Scene::y_up_from(0.9, -0.3);
            let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
            let angle = self.angle + if self.spin < 0.0 { -TAU * t } else { TAU * t };
            // The scene has y up: x, the axle, to the right, z to the left.
            let along = |angle: f64| y * angle.cos() + z * angle.sin();
            let (blade, across) = (along(angle), along(angle + FRAC_PI_2) * 0.12);
            scene.line([x * -1.4, x * 0.6], Ink::Body);
            for bearing in [-1.2, -0.5] {
                scene.circle(x * bearing, x, 0.15, Ink::Body);
            }
            scene.circle(Vector3::zeros(), x, 1.0, Ink::Faint);
            scene.line([blade, across, -blade, -across, blade], Ink::Body);
            scene.label(blade, self.letters());
            if self.length().is_some() {
                scene.dimension("L", [blade, -blade], across * 2.0);
            }
            scene.line([Vector3::zeros(), y * 1.2], Ink::Faint);
            scene.angle("χ", Vector3::zeros(), [y, blade], 0.55);
            for (axis, name) in [(x, "x"), (y, "y"), (z, "z")] {
                scene.arrow(axis * if name == "x" { 0.6 } else { 1.1 }, axis * 0.4, Ink::Faint, name);
            }
            scene.turn("ω", x * 0.7, x * self.spin, 0.25, Ink::Motion);
            scene.turn("Ω", y * 1.3, y, 0.25, Ink::Motion);
            if t == 0.0
                && let Some(unit) = couple.try_normalize(0.0)
            {
                scene.arrow(Vector3::zeros(), unit * 1.3, Ink::Force, "M");
            }
            if matches!(self.precession, Precession::Turn { .. }) {
                scene.arrow(x * -1.4, z * 0.7, Ink::Motion, "v, R");
            }
            scene
        })
    }

    /// The letters of the inertia of the blades.
    fn letters(&self) -> &'static str {
        match self.rotor {
            Blades::Slender { .. } => "I_a",
            Blades::Rod { .. } => "m",
            Blades::Principal { .. } => "I_a, I_b, I_c",
        }
    }

    fn length(&self) -> Option<f64> {
        match self.rotor {
            Blades::Rod { length, .. } => Some(length),
            _ => None,
        }
    }
}
