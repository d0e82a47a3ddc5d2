//! A mass on a spring that is released: a small analysis to begin with. Make it yours.
//!
//! This file is all there is: `register!` puts the analysis into the workbench, the command line, the reference
//! and the tests. Its cases stand in `cases/analysis_name.toml`.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Source, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof};

/// The problem: its fields are what the form asks for. The first line of a comment is the label of its field, what
/// follows is the help. The attribute holds the symbol in formulas, the unit, and the limits.
#[derive(Clone, Debug, Inputs)]
pub struct AnalysisName {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Stiffness of the spring.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Deflection at the start.
    /// From the rest position; the mass is released without initial velocity.
    #[input("X", "m", positive, kind = "Amplitude")]
    pub deflection: f64,
}

/// A source that several analyses follow belongs into `sources.rs` of this family.
static TEXTBOOK: Source =
    Source { short: "Rao", full: "S. S. Rao, Mechanical Vibrations, 5th ed., Prentice Hall, 2011" };

register!(AnalysisName);

impl Analysis for AnalysisName {
    const ABOUT: About = About {
        id: "family/analysis-name",
        title: "Analysis name",
        topic: "Topic of it",
        summary: "Natural frequency, period and maximum speed of a mass on a spring, released from rest.",
        main: &["natural_frequency"],
        keywords: "mass spring free vibration natural frequency massa mola",
        sources: &[&TEXTBOOK],
        cases: include_str!("../../cases/analysis_name.toml"),
    };

    // Every formula is written once. Read with `f64` it is the number of a sweep; read with a term of the worksheet it
    // is also the line of the worked solution. `given` holds the inputs as numbers of the worksheet, `self` in SI.
    fn solve<W: Worksheet>(&self, given: &AnalysisNameGiven<W>, sheet: W) -> Result<(), Refusal> {
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(given.stiffness, given.mass),
            ("Natural frequency without damping", TEXTBOOK.at("§2.2")),
        );
        let period = sheet.step(
            "T",
            "s",
            W::Num::from(TAU) / natural,
            ("Period of one oscillation", TEXTBOOK.at("§2.2")),
        );
        let speed = sheet.step(
            "v",
            "m/s",
            natural * given.deflection,
            ("Maximum speed, at the rest position", TEXTBOOK.at("§2.2")),
        );
        // A second method to the same numbers: the energy of the spring becomes that of the motion.
        sheet.check(
            "the energy of the motion is that of the deflected spring",
            given.mass * speed.powi(2) / 2.0,
            given.stiffness * given.deflection.powi(2) / 2.0,
        );
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("period", "Period", period);
        sheet.answer("maximum_speed", "Maximum speed", speed);
        // Plots and drawings are built only when somebody looks.
        sheet.show(|| Exhibit::Plot(self.over_mass()));
        sheet.show(|| Exhibit::Drawing(sketch()));
        Ok(())
    }
}

impl AnalysisName {
    /// A plot names the input that it is over and the answer that each of its curves is of: a test solves at the points.
    fn over_mass(&self) -> Plot {
        let at = |n: u16| {
            let mass = 3.0 * self.mass * f64::from(n) / 300.0;
            (mass, TAU / sdof::natural_frequency(self.stiffness, mass))
        };
        Plot::new(
            "Period against mass",
            Axis::linear("mass", "kg"),
            Axis::linear("period", "s"),
            vec![Series::line("T", (1..=300).map(at).collect()).of("period")],
        )
        .over("mass")
    }
}

/// The mass on its spring; metres, y up. Symbols are placed by points, and their names find their places themselves.
fn sketch() -> Drawing {
    Sketch::new("The mass on its spring")
        .ground((-0.6, 0.0), (0.6, 0.0))
        .spring("k", (0.0, 0.0), (0.0, 1.0))
        .mass("m", (-0.4, 1.0), (0.4, 1.6))
        .motion("x", (0.7, 1.1), (0.7, 1.6))
        .finish()
}
