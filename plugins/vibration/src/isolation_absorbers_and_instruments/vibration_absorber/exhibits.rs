//! Response with and without the absorber, the split of the resonances over the mass ratio, and a sketch.

use dalembert_core::{Axis, Drawing, Ink, Plot, Series, Sketch};
use dalembert_mechanics::vibration::absorber;

use super::motion::AbsorberMotion;

/// Both masses and springs.
pub(super) struct AbsorberResponse {
    pub(super) mass: f64,
    pub(super) stiffness: f64,
    pub(super) absorber_mass: f64,
    pub(super) absorber_stiffness: f64,
}

/// Amplitudes above this many static deflections are not drawn.
const TOP: f64 = 30.0;

impl AbsorberResponse {
    /// Amplitudes of main mass and absorber over the static deflection of the main mass.
    fn at(&self, frequency: f64) -> [f64; 2] {
        let determinant = absorber::determinant(
            self.mass,
            self.stiffness,
            self.absorber_mass,
            self.absorber_stiffness,
            frequency,
        );
        let below = self.stiffness / determinant;
        let own = self.absorber_stiffness - self.absorber_mass * frequency * frequency;
        [own * below, self.absorber_stiffness * below].map(f64::abs)
    }

    /// The main mass, before and after.
    pub(super) fn main_mass(&self, speed: f64, [lower, upper]: [f64; 2], range: Option<[f64; 2]>) -> Plot {
        let frequencies = frequencies(lower, upper);
        let before = |w: f64| 1.0 / (1.0 - w * w * self.mass / self.stiffness).abs();
        let curve = |of: &dyn Fn(f64) -> f64| frequencies.iter().map(|&w| (w, drawn(of(w)))).collect();
        let plot = Plot::new(
            "Amplitude of the main system, with and without the absorber",
            Axis::linear("frequency", "rpm"),
            Axis::linear("amplitude over static deflection", "1"),
            vec![
                Series::line("with the absorber", curve(&|w| self.at(w)[0])),
                Series::line("without it", curve(&before)),
            ],
        )
        .mark("at this speed", (speed, drawn(self.at(speed)[0])));
        match range {
            Some([from, to]) => plot.band("without resonance", from, to, true),
            None => plot,
        }
    }

    /// The absorber.
    pub(super) fn absorber(&self, speed: f64, [lower, upper]: [f64; 2]) -> Plot {
        let points = frequencies(lower, upper).iter().map(|&w| (w, drawn(self.at(w)[1]))).collect();
        Plot::new(
            "Amplitude of the absorber",
            Axis::linear("frequency", "rpm"),
            Axis::linear("amplitude over static deflection", "1"),
            vec![Series::line("absorber", points)],
        )
        .mark("at this speed", (speed, drawn(self.at(speed)[1])))
    }

    /// Both resonances over the mass ratio, with the tuning as it is.
    pub(super) fn split(&self, tuned: Option<f64>) -> Plot {
        let natural = (self.stiffness / self.mass).sqrt();
        let own = tuned.unwrap_or_else(|| (self.absorber_stiffness / self.absorber_mass).sqrt());
        let (tuning, ratio) = (own / natural, self.absorber_mass / self.mass);
        let last = (2.0 * ratio).max(0.5);
        let at = |mu: f64| {
            let upper = absorber::resonance_sum(tuning, mu) + absorber::resonance_difference(tuning, mu);
            let upper = upper / 2.0;
            [tuning / upper * natural, upper * natural]
        };
        let curve = |which: usize| {
            (0..=100u16).map(|n| last * f64::from(n) / 100.0).map(|mu| (mu, at(mu)[which])).collect()
        };
        let [lower, upper] = at(ratio);
        Plot::new(
            "Resonances against the mass ratio",
            Axis::linear("mass ratio", "1"),
            Axis::linear("resonance", "rpm"),
            vec![Series::line("lower resonance", curve(0)), Series::line("upper resonance", curve(1))],
        )
        .mark("Ω₁", (ratio, lower))
        .mark("Ω₂", (ratio, upper))
    }
}

/// Frequencies around both resonances.
fn frequencies(lower: f64, upper: f64) -> Vec<f64> {
    let last = 1.5 * upper.max(lower);
    (0..=400u16).map(|n| last * f64::from(n) / 400.0).collect()
}

/// Breaks the line near a resonance, where the amplitude has no bound.
fn drawn(amplitude: f64) -> f64 {
    if amplitude <= TOP { amplitude } else { f64::INFINITY }
}

pub(super) fn drawing(motion: AbsorberMotion) -> Drawing {
    let mut sketch = Sketch::new("The main system and its absorber");
    match motion {
        AbsorberMotion::Translation => sketch
            .ground((-1.5, -2.4), (1.5, -2.4))
            .spring("", (-0.6, -2.4), (-0.6, -1.0))
            .spring("k", (0.6, -2.4), (0.6, -1.0))
            .mass("m", (-1.2, -1.0), (1.2, 0.2))
            .force("F₀ cos(ω t)", (-1.5, -1.0), (-1.5, 0.2))
            .spring("k_a", (0.0, 0.2), (0.0, 1.3))
            .block("m_a", (-0.6, 1.3), (0.6, 2.0), Ink::Result)
            .motion("X_s", (0.8, 1.3), (0.8, 2.0)),
        AbsorberMotion::Torsion => sketch
            .ground((-2.6, 0.9), (-2.6, -0.9))
            .link("k_t", (-2.6, 0.06), (-0.5, 0.06))
            .link("", (-2.6, -0.06), (-0.5, -0.06))
            .mass("J", (-0.5, -1.3), (0.2, 1.3))
            .spring("", (0.2, 0.7), (1.2, 0.7))
            .spring("k_ta", (0.2, -0.7), (1.2, -0.7))
            .block("J_a", (1.2, -0.95), (1.6, 0.95), Ink::Result)
            .force("T cos(ω t)", (-0.8, -0.5), (-0.8, 0.5)),
    };
    sketch.finish()
}
