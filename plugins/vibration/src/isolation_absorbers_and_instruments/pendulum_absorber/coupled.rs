//! A body and a swing that are coupled by inertia alone: their frequencies and their steady motion.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, vibration::pendulum_absorber::Pair};

use crate::sources::DEN_HARTOG;

/// Common error of the steady motion.
const LOCKED: &str = "the pendulum taken as locked to the body that carries it";

/// A body with a pendulum.
pub(super) struct BodyWithPendulum<N> {
    /// True for a rotor, false for a body in translation.
    pub(super) on_rotor: bool,
    /// Inertia of the body with what hangs on it.
    pub(super) body: N,
    pub(super) coupling: N,
    pub(super) swing: N,
    /// Frequency of the swing with the body at rest.
    pub(super) antiresonance: N,
    /// Stiffness of the suspension of the body.
    pub(super) held: Option<N>,
}

impl<N: Real> BodyWithPendulum<N> {
    /// The numbers of it.
    pub(super) fn pair(&self) -> Pair {
        Pair {
            body: self.body.value(),
            coupling: self.coupling.value(),
            swing: self.swing.value(),
            held: self.held.map_or(0.0, Real::value),
            back: self.swing.value() * self.antiresonance.value().powi(2),
        }
    }

    /// The natural frequencies that are not zero, rad/s, ascending.
    pub(super) fn frequencies<W: Worksheet<Num = N>>(&self, sheet: W) -> Vec<N> {
        let antiresonance = self.antiresonance;
        let closeness = self.coupling.powi(2) / (self.body * self.swing);
        let closeness = sheet.step("ε", "1", closeness, "Coupling coefficient of body and pendulum motion");
        let found = match self.held {
            None => {
                let why = "The rotor is unrestrained: rotor and pendulum oscillate against each other";
                let only = antiresonance / (N::from(1.0) - closeness).sqrt();
                vec![sheet.step(("ω", 1), "rad/s", only, why)]
            }
            Some(held) => {
                let natural =
                    sheet.step("p", "rad/s", (held / self.body).sqrt(), "Frequency with the pendulum locked");
                let sum = natural.powi(2) + antiresonance.powi(2);
                let apart = (natural.powi(2) - antiresonance.powi(2)).powi(2)
                    + closeness * natural.powi(2) * antiresonance.powi(2) * 4.0;
                let larger = sheet.step(
                    ("λ", 2),
                    "rad^2/s^2",
                    (sum + apart.sqrt()) / ((N::from(1.0) - closeness) * 2.0),
                    (
                        "The larger root of (1 − ε) λ² − (p² + ω₀²) λ + p² ω₀² = 0, with λ = ω²",
                        DEN_HARTOG.at("ch. 3"),
                    ),
                );
                let lower = natural * antiresonance / ((N::from(1.0) - closeness) * larger).sqrt();
                let lower =
                    sheet.step(("ω", 1), "rad/s", lower, "The product of the roots is p² ω₀²/(1 − ε)");
                vec![lower, sheet.step(("ω", 2), "rad/s", larger.sqrt(), "Upper natural frequency")]
            }
        };
        sheet.verify(|| {
            let own = self.pair().frequencies();
            for (ours, other) in found.iter().zip(&own[2 - found.len()..]) {
                sheet.check("frequency from the matrices of the small motions", *ours, N::from(*other));
            }
        });
        found
    }

    /// The steady amplitudes under a harmonic load on the body.
    pub(super) fn steady<W: Worksheet<Num = N>>(
        &self,
        frequency: N,
        load: N,
        sheet: W,
    ) -> Result<(), Refusal> {
        let square = frequency.powi(2);
        let still = match self.held {
            Some(held) => held - self.body * square,
            None => -(self.body * square),
        };
        let rest = self.swing * (self.antiresonance.powi(2) - square);
        let coupling = self.coupling * square;
        let determinant = sheet.step(
            "D",
            if self.on_rotor { "N^2*m^2" } else { "N^2" },
            still * rest - coupling.powi(2),
            ("Determinant of the two equations of the steady-state motion", DEN_HARTOG.at("ch. 3")),
        );
        let meets = |own: &f64| (own / frequency.value() - 1.0).abs() < 1e-12;
        if self.pair().frequencies().iter().any(meets) {
            return Err(Refusal::because(
                "the load frequency coincides with a natural frequency of body and pendulum: without damping the motion grows without bound and there is no steady state",
            ));
        }
        let (body, swing) = (load * rest / determinant, load * coupling / determinant);
        let why = "Amplitude of the body; negative if opposed to the load";
        let body = if self.on_rotor {
            sheet.common_error("Θ", LOCKED, || load / still);
            let body = sheet.step("Θ", "deg", body, why);
            sheet.answer("rotor_amplitude", "Amplitude of the rotor", body);
            body
        } else {
            sheet.common_error("X", LOCKED, || load / still);
            let body = sheet.step("X", "mm", body, why);
            sheet.answer("amplitude", "Amplitude of the mass", body);
            body
        };
        let swing =
            sheet.step("Φ", "deg", swing, "Swing amplitude of the pendulum; negative if opposed to the load");
        sheet.answer("swing", "Swing amplitude of the pendulum", swing);
        sheet.verify(|| {
            let [first, second] = self.pair().steady(load.value(), frequency.value());
            let left = self.pair();
            let size = load.value().abs()
                + (left.held + left.body * square.value()) * first.abs()
                + left.coupling * square.value() * second.abs();
            let sum = (left.held - left.body * square.value()) * body.value()
                - left.coupling * square.value() * swing.value()
                - load.value();
            sheet.check_zero("load, inertia and springs are in equilibrium at the body", N::from(sum), size);
            sheet.check("oscillation from the matrices of the small motions", swing, N::from(second));
        });
        if swing.value().abs() > 0.35 {
            sheet.warn(|| {
                Text::new(
                    "the swing angle is above 20°: the frequency of a pendulum on a circle decreases with amplitude, and the results hold for small oscillations",
                )
            });
        }
        Ok(())
    }
}
