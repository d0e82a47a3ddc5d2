//! The turn indicator of an aircraft: a gyroscope in a yoke that springs hold.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, gyroscope},
};
use nalgebra::Vector3;

use crate::{
    shared::{common_errors, differences::check_disc, flat::into_page},
    sources::{BEER, KHURMI},
};

/// A rotor with its axle across the aircraft, in a yoke that can turn about the fore-and-aft axis, held by two equal
/// upright springs at equal distances from that axis.
///
/// The springs are without tension at yoke angle zero and so long that they stay upright.
#[derive(Clone, Debug, Inputs)]
pub struct TurnIndicator {
    /// Rotor.
    pub rotor: IndicatorRotor,
    /// Speed of the rotor.
    /// Relative to the yoke.
    #[input("ω", "rad/s", positive)]
    pub spin: f64,
    /// Stiffness of each spring.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Distance between the springs.
    /// Each acts at half this distance from the axis of the yoke.
    #[input("d", "m", positive)]
    pub spacing: f64,
    /// Turn.
    pub turn: Turn,
}

/// The rotor.
#[derive(Clone, Debug, Inputs)]
pub enum IndicatorRotor {
    /// Thin disc
    Disc {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius.
        #[input("r", "m", positive)]
        radius: f64,
    },
    /// Moments of inertia
    Moments {
        /// Moment of inertia about the axle.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
        /// Moment of inertia transverse to the axle.
        #[input("I_t", "kg*m^2", positive)]
        transverse: f64,
    },
}

/// Given quantity of the turn.
#[derive(Clone, Debug, Inputs)]
pub enum Turn {
    /// Speed and radius
    SpeedAndRadius {
        /// Speed of the aircraft.
        #[input("v", "m/s", nonnegative)]
        speed: f64,
        /// Radius of the turn.
        #[input("R", "m", positive)]
        radius: f64,
    },
    /// Rate of turn
    Rate {
        /// Angular velocity of the aircraft about the vertical.
        #[input("Ω", "rad/s", nonnegative)]
        rate: f64,
    },
    /// The indicator shows an angle
    Reading {
        /// Angle of the yoke.
        #[input("θ", "rad", nonnegative, max = 1.5)]
        angle: f64,
    },
}

const FIXED_ARM: &str = "lever arm of the springs not reduced by cos θ";
const FIXED_COUPLE: &str = "gyroscopic couple not reduced by cos θ";

register!(TurnIndicator);

impl Analysis for TurnIndicator {
    const ABOUT: About = About {
        id: "rigid-body/turn-indicator",
        title: "Turn indicator of an aircraft",
        topic: "Gyroscopes and vehicles",
        summary: "Angle of a yoke with a spinning rotor and two springs in a level turn, or the rate of turn indicated by an angle.",
        main: &["angle", "rate_of_turn"],
        keywords: "turn indicator rate gyro yoke springs aircraft giroscópio indicador de curva molas garfo aeronave",
        sources: &[&BEER, &KHURMI],
        cases: include_str!("../../cases/turn_indicator.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TurnIndicatorGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (axial, transverse) = match given.rotor {
            IndicatorRotorGiven::Disc { mass, radius } => {
                common_errors::of_disc("I_a", mass, radius, sheet);
                let axial = sheet.step(
                    "I_a",
                    "kg*m^2",
                    rigid::disc_axial_inertia(mass, radius),
                    "Moment of inertia of a disc about its axle",
                );
                let transverse = sheet.step(
                    "I_t",
                    "kg*m^2",
                    rigid::disc_diametral_inertia(mass, radius),
                    "Moment of inertia of a disc about a diameter",
                );
                sheet.answer("axial_inertia", "Moment of inertia about the axle", axial);
                check_disc(axial, mass, radius, sheet);
                (axial, transverse)
            }
            IndicatorRotorGiven::Moments { axial, transverse } => (axial, transverse),
        };
        let whole = || given.stiffness * 2.0 * given.spacing.powi(2);
        let what = "whole distance between the springs taken as the lever arm of each";
        sheet.common_error("K", what, whole);
        let in_series = || given.stiffness / 2.0 * (given.spacing / 2.0).powi(2);
        sheet.common_error("K", "the two springs taken in series", in_series);
        let spring = sheet.step(
            "K",
            "N*m",
            given.stiffness * 2.0 * (given.spacing / 2.0).powi(2),
            "Couple of the two springs on the yoke: K sin θ cos θ, since their ends move by (d/2) sin θ with lever arms of (d/2) cos θ",
        );
        let (rate, sine, angle) = match given.turn {
            TurnGiven::Reading { angle } => {
                let sine = sheet.step("s", "1", angle.sin(), "Sine of the angle of the yoke");
                let momentum =
                    sheet.step("h", "kg*m^2/s", axial * given.spin, "Angular momentum of the spin");
                let fixed_arm = || spring * angle.tan() / momentum;
                sheet.common_error("Ω", FIXED_ARM, fixed_arm);
                let fixed_couple = || spring * sine * angle.cos() / momentum;
                sheet.common_error("Ω", FIXED_COUPLE, fixed_couple);
                let small = || spring * angle / momentum;
                sheet.common_error("Ω", "small angle of the yoke assumed: sin θ replaced by θ", small);
                let rate = sheet.step(
                    "Ω",
                    "rad/s",
                    spring * sine * 2.0
                        / (momentum + (momentum.powi(2) + (axial - transverse) * spring * sine.powi(2) * 4.0).sqrt()),
                    "Rate of turn: the root of I_a ω Ω + (I_a − I_t) Ω² sin θ = K sin θ that is zero at θ = 0",
                );
                if !rate.value().is_finite() {
                    return Err(Refusal::because(
                        "no rate of turn holds the yoke at that angle: the springs are too stiff for the rotor",
                    ));
                }
                (rate, sine, angle)
            }
            TurnGiven::SpeedAndRadius { .. } | TurnGiven::Rate { .. } => {
                let rate = match given.turn {
                    TurnGiven::SpeedAndRadius { speed, radius } => {
                        sheet.step("Ω", "rad/s", speed / radius, "Rate of turn")
                    }
                    TurnGiven::Rate { rate } => rate,
                    TurnGiven::Reading { .. } => unreachable!("the reading has its own way"),
                };
                let sine = sheet.step(
                    "s",
                    "1",
                    axial * given.spin * rate / (spring - (axial - transverse) * rate.powi(2)),
                    (
                        "Sine of the angle of the yoke: (I_a ω + (I_a − I_t) Ω sin θ) Ω cos θ = K sin θ cos θ",
                        BEER.at("§18.3"),
                    ),
                );
                if !(0.0..1.0).contains(&sine.value()) {
                    return Err(Refusal::because(
                        "the springs are too soft: the rotor tilts the yoke until its axle is vertical; a slower rotor, a wider spacing or stiffer springs hold it",
                    ));
                }
                let ratio = || gyroscope::right_angled_couple(axial, given.spin, rate) / spring;
                sheet.common_error("θ", FIXED_ARM, || ratio().atan2(W::Num::from(1.0)));
                sheet.common_error("θ", FIXED_COUPLE, || (ratio() * 2.0).asin() / 2.0);
                let what = "small angle of the yoke assumed: sin θ replaced by θ";
                sheet.common_error("θ", what, || sine);
                (rate, sine, sheet.step("θ", "deg", sine.asin(), "Angle of the yoke"))
            }
        };
        let couple = sheet.step(
            "C",
            "N*m",
            (axial * given.spin + (axial - transverse) * rate * sine) * rate * angle.cos(),
            ("Gyroscopic couple on the tilted rotor", BEER.at("§18.3")),
        );
        let level = sheet.step(
            "C₀",
            "N*m",
            gyroscope::right_angled_couple(axial, given.spin, rate),
            ("Gyroscopic couple with the axle level", KHURMI.at("§14.3")),
        );
        let force = sheet.step(
            "F",
            "N",
            given.stiffness * given.spacing / 2.0 * sine,
            "Force of each spring: one is longer by (d/2) sin θ, the other shorter",
        );
        if !matches!(self.turn, Turn::Reading { .. }) {
            sheet.answer("angle", "Angle of the yoke", angle);
        }
        if !matches!(self.turn, Turn::Rate { .. }) {
            sheet.answer("rate_of_turn", "Rate of turn", rate);
        }
        sheet.answer("level_couple", "Gyroscopic couple with the axle level", level);
        sheet.answer("couple", "Gyroscopic couple", couple);
        sheet.answer("spring_force", "Force of each spring", force);
        let (axial_inertia, transverse_inertia, rate_of_turn) = (axial, transverse, rate);
        let (axial, transverse, rate) = (axial.value(), transverse.value(), rate.value());
        sheet.verify(|| {
            sheet.check("the couple of the springs", force * given.spacing * angle.cos(), couple);
            let height = given.spacing / 2.0 * angle.sin();
            sheet.check(
                "the couple of the springs from the displacement of their ends",
                given.stiffness * height * given.spacing * angle.cos(),
                couple,
            );
            let tilted = (axial_inertia - transverse_inertia) * rate_of_turn.powi(2) * sine;
            sheet.check_sum(
                "the couple with the axle horizontal, and the contribution of the tilt",
                (level + tilted) * angle.cos(),
                couple,
                level.value() + tilted.value().abs(),
            );
            // The axle points to the left and, tilted, up; the aircraft turns to the left.
            let axle = Vector3::new(0.0, angle.value().cos(), angle.value().sin());
            let tensor = gyroscope::symmetric_tensor(axial, transverse, axle);
            let about = Vector3::z() * rate;
            let momentum_at = |t: f64| {
                let carrier = nalgebra::Rotation3::from_scaled_axis(about * t);
                rigid::turned(&tensor, &carrier) * (about + carrier * axle * self.spin)
            };
            let period = if rate > 0.0 { TAU / rate } else { 1.0 };
            if let Ok(derivative) = rigid::numerical_rate(momentum_at, period) {
                sheet.check_zero(
                    "the couple from the difference quotient of R I Rᵀ ω",
                    W::Num::from(derivative.norm() - couple.value()),
                    Vector::value(momentum_at(0.0)).norm() * TAU / period,
                );
            }
        });
        sheet.show(|| Exhibit::Plot(self.angle_over_rate(axial, transverse, (rate, angle.value()))));
        sheet.show(|| Exhibit::Drawing(self.sketch(angle.value())));
        Ok(())
    }
}

impl TurnIndicator {
    fn angle_over_rate(&self, axial: f64, transverse: f64, here: (f64, f64)) -> Plot {
        let spring = 2.0 * self.stiffness * (self.spacing / 2.0).powi(2);
        // Up to half a right angle, or to twice the turn at hand.
        let full = spring * 0.7 / (axial * self.spin);
        let most = if here.0 > 0.0 { full.min(3.0 * here.0).max(1.2 * here.0) } else { full };
        let at = |n: u16| {
            let rate = most * f64::from(n) / 120.0;
            let sine = axial * self.spin * rate / (spring - (axial - transverse) * rate.powi(2));
            (rate, sine.asin())
        };
        Plot::new(
            "Angle of the yoke against the rate of turn",
            Axis::linear("rate of turn", "deg/s"),
            Axis::linear("angle of the yoke", "deg"),
            vec![Series::line("θ", (0..=120).map(at).collect()).of("angle")],
        )
        .over("turn.rate.rate")
        .mark("this turn", here)
    }
}

impl TurnIndicator {
    /// The yoke from behind: the rotor on its axle across, the springs, and the turn of the aircraft.
    fn sketch(&self, angle: f64) -> Drawing {
        let (sin, cos) = angle.sin_cos();
        let at = |along: f64, up: f64| (along * cos - up * sin, along * sin + up * cos);
        let (left, right) = (at(-1.0, 0.0), at(1.0, 0.0));
        let (radius, letters) = match self.rotor {
            IndicatorRotor::Disc { .. } => ("r", "m"),
            IndicatorRotor::Moments { .. } => ("", "I_a, I_t"),
        };
        let mut sketch = Sketch::new("The yoke of the indicator from behind");
        sketch
            .ground((-1.3, -1.6), (1.3, -1.6))
            .axis((-1.4, 0.0), (1.4, 0.0))
            .spring("k", (left.0, -1.6), left)
            .spring("k", (right.0, -1.6), right)
            .dimension("d", (left.0, -1.6), (right.0, -1.6), -2.5)
            .bars([left, right])
            .bars([at(-0.55, 0.0), at(-0.55, 0.9), at(0.55, 0.9), at(0.55, 0.0)])
            .axis(at(-0.55, 0.7), at(0.55, 0.7))
            .body("", [at(-0.06, 0.2), at(-0.06, 1.2), at(0.06, 1.2), at(0.06, 0.2)])
            .label(letters, at(0.0, 1.2))
            .motion("ω", at(-0.55, 0.7), at(-1.0, 0.7))
            .joint("", (0.0, 0.0))
            .arc((0.0, 0.0), 1.3, (angle.min(0.0), angle.max(0.0)), Ink::Faint)
            .label("θ", (1.3 * (angle / 2.0).cos(), 1.3 * (angle / 2.0).sin()));
        if !radius.is_empty() {
            sketch.dimension(radius, at(0.06, 0.7), at(0.06, 1.2), -1.0);
        }
        match self.turn {
            Turn::SpeedAndRadius { .. } => {
                into_page(&mut sketch, "v", (-1.9, 0.1), 0.12);
                sketch.axis((-3.2, -0.5), (-3.2, 1.2)).dimension("R", (-3.2, 0.6), (0.0, 0.6), 0.0);
            }
            _ => {
                sketch.axis((-1.9, -0.3), (-1.9, 0.9)).motion("Ω", (-1.9, 0.3), (-1.9, 0.9));
            }
        }
        sketch.finish()
    }
}
