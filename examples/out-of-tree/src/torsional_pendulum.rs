//! The moment of inertia of a part from its oscillation on a wire.

use std::f64::consts::{PI, TAU};

use dalembert_core::{About, Analysis, Inputs, Refusal, Source, Worksheet, register};
use dalembert_mechanics::{Real, section, spring};

/// A part that hangs on a round wire and turns back and forth.
#[derive(Clone, Debug, Inputs)]
pub struct TorsionalPendulum {
    /// Length of the wire.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Diameter of the wire.
    #[input("d", "mm", positive)]
    pub diameter: f64,
    /// Shear modulus of the wire.
    #[input("G", "GPa", positive)]
    pub shear: f64,
    /// Period.
    /// Of one oscillation back and forth: time many and divide.
    #[input("T", "s", positive)]
    pub period: f64,
}

static RAO: Source =
    Source { short: "Rao", full: "S. S. Rao, Mechanical Vibrations, 5th ed., Prentice Hall, 2011" };

register!(TorsionalPendulum);

impl Analysis for TorsionalPendulum {
    const ABOUT: About = About {
        id: "laboratory/torsional-pendulum",
        title: "Torsional pendulum",
        topic: "Torsion",
        summary: "The moment of inertia of a part from the period of its oscillation on a wire.",
        main: &["moment_of_inertia"],
        keywords: "moment of inertia wire torsion",
        sources: &[&RAO],
        cases: include_str!("../cases/torsional_pendulum.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TorsionalPendulumGiven<W>, sheet: W) -> Result<(), Refusal> {
        let polar = sheet.step(
            "J",
            "mm^4",
            section::round_polar_moment(given.diameter),
            "Polar second moment of the wire",
        );
        let stiffness = sheet.step(
            "k_t",
            "N*m/rad",
            spring::torsional(given.shear, polar, given.length),
            "Torsional stiffness of the wire",
        );
        let natural =
            sheet.step("ωₙ", "rad/s", W::Num::from(TAU) / given.period, "Natural frequency as measured");
        let inertia = sheet.step(
            "I",
            "kg*m^2",
            stiffness / natural.powi(2),
            ("The natural frequency is √(k_t/I)", RAO.at("§2.3")),
        );
        sheet.check(
            "the moment of inertia in one formula, G d⁴ T²/(128 π L)",
            inertia,
            given.shear * given.diameter.powi(4) * given.period.powi(2) / (given.length * (128.0 * PI)),
        );
        sheet.answer("stiffness", "Torsional stiffness", stiffness);
        sheet.answer("moment_of_inertia", "Moment of inertia", inertia);
        Ok(())
    }
}
