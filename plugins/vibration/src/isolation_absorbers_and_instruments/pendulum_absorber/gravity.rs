//! A pendulum under a mass that moves sideways.

use dalembert_core::{Exhibit, Refusal, Worksheet};
use dalembert_mechanics::Real;

use super::{LengthGiven, PendulumMassGiven, coupled::BodyWithPendulum, exhibits};
use crate::sources::DEN_HARTOG;

/// An oscillating mass with a pendulum.
pub(super) struct MassWithPendulum<N> {
    pub(super) body: N,
    pub(super) stiffness: N,
    pub(super) frequency: N,
    pub(super) force: Option<N>,
    pub(super) gravity: N,
}

impl<N: Real> MassWithPendulum<N> {
    /// Frequencies, amplitudes and, where they are asked for, length and mass of the pendulum.
    pub(super) fn solve<W: Worksheet<Num = N>>(
        &self,
        length: &LengthGiven<W>,
        mass: &PendulumMassGiven<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        // A pendulum that is tuned, or as heavy as its swing asks for, is another one under another force.
        let is_given = matches!((length, mass), (LengthGiven::Given { .. }, PendulumMassGiven::Given { .. }));
        let is_tuned = matches!(length, LengthGiven::Tuned {});
        let (length, gyration) = match length {
            LengthGiven::Given { length, gyration } => (*length, *gyration),
            LengthGiven::Tuned {} => {
                let why =
                    ("Length that tunes the pendulum to the force, from ω² = g/l", DEN_HARTOG.at("ch. 3"));
                let by_springs = || self.gravity * self.body / self.stiffness;
                let what = "the pendulum tuned to the natural frequency of the mass on its springs";
                sheet.common_error("l", what, by_springs);
                let length = sheet.step("l", "m", self.gravity / self.frequency.powi(2), why);
                sheet.answer("length", "Length of the pendulum", length);
                (length, None)
            }
        };
        let why = "Inertia of the pendulum motion per kilogram, about the pivot";
        let square = match gyration {
            Some(gyration) => length.powi(2) + gyration.powi(2),
            None => length.powi(2),
        };
        let square = sheet.step("s²", "m^2", square, why);
        let antiresonance = sheet.step(
            "ω₀",
            "rad/s",
            (self.gravity * length / square).sqrt(),
            (
                "Frequency of the pendulum on a fixed pivot: at this frequency the mass is at rest",
                DEN_HARTOG.at("ch. 3"),
            ),
        );
        let counted = sheet.step("f₀", "Hz", antiresonance, "The same frequency in Hz");
        sheet.answer("antiresonance", "Frequency at which the mass is at rest", counted);
        if is_tuned {
            sheet.check("the pendulum frequency equals the force frequency", antiresonance, self.frequency);
        }
        let limit = if let PendulumMassGiven::Swing { swing } = mass { Some(*swing) } else { None };
        let mass = match mass {
            PendulumMassGiven::Given { mass } => *mass,
            PendulumMassGiven::Swing { swing } => {
                let Some(force) = self.force else {
                    return Err(Refusal::because(
                        "the mass for a limited swing follows from the force: write its amplitude",
                    ));
                };
                if gyration.is_some() {
                    let point = || force / (self.gravity * *swing);
                    sheet.common_error("m", "the pendulum taken as a point mass", point);
                }
                let mass = sheet.step(
                    "m",
                    "kg",
                    force / (length * antiresonance.powi(2) * *swing),
                    "Mass of the pendulum: at its limit angle and its own frequency it absorbs the whole force",
                );
                sheet.answer("mass", "Mass of the pendulum", mass);
                mass
            }
        };
        let motion = BodyWithPendulum {
            on_rotor: false,
            body: sheet.step("M₁", "kg", self.body + mass, "Mass and pendulum move sideways together"),
            coupling: sheet.step(
                "M₁₂",
                "kg*m",
                mass * length,
                "Inertia coupling of mass and pendulum motion",
            ),
            swing: sheet.step(
                "J₂",
                "kg*m^2",
                mass * square,
                "Moment of inertia of the pendulum about its pivot",
            ),
            antiresonance,
            held: Some(self.stiffness),
        };
        if let (Some(limit), Some(force)) = (limit, self.force) {
            sheet.check(
                "with the mass at rest, the pendulum at its limit balances the force, M₁₂ ω₀² φ",
                motion.coupling * antiresonance.powi(2) * limit,
                force,
            );
        }
        for (row, frequency) in motion.frequencies(sheet).into_iter().enumerate() {
            let counted = sheet.step(("f", row + 1), "Hz", frequency, "The same frequency in Hz");
            sheet.answer(("frequency", row + 1), "Natural frequency of mass and pendulum", counted);
        }
        if let Some(force) = self.force {
            motion.steady(self.frequency, force, sheet)?;
        }
        let view = exhibits::SuspendedPendulum {
            pair: motion.pair(),
            frequency: self.frequency.value(),
            length: length.value(),
        };
        sheet.show(|| {
            let plot = view.response();
            Exhibit::Plot(if is_given { plot.over("problem.gravity.frequency") } else { plot })
        });
        sheet.show(|| Exhibit::Drawing(view.drawing()));
        Ok(())
    }
}
