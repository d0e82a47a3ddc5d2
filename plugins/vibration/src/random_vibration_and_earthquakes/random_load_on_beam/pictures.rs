//! Plots and drawing of the loaded beam.

use dalembert_core::{Axis, Drawing, Plot, Series, Sketch};
use dalembert_mechanics::Real;

use super::{
    RandomBeamLoad, RandomLoadOnBeam,
    responses::{LoadedBeam, LoadedMode},
};
use crate::shared::{continuous::draw_support, support::Support};

/// Parts of the beam in the plots along it.
const PARTS: u16 = 40;

impl<N: Real> LoadedBeam<N> {
    /// The spectral density of the displacement; where there is none, of the bending moment.
    pub(super) fn density_plot(&self) -> Plot {
        let unit = self.unit_moment.value();
        let (sum, axis) = if self.moves() {
            (self.sum(|mode| mode.deflection, 0), Axis::log("density of the displacement", "mm^2/Hz"))
        } else {
            (
                self.sum(|mode| mode.curvature * unit, 0),
                Axis::log("density of the bending moment", "N^2*m^2/Hz"),
            )
        };
        let ends = self.spectrum.ends();
        let naturals = self.modes.iter().map(|mode| mode.resonance.natural);
        let first = naturals.clone().fold(f64::INFINITY, f64::min);
        let top = naturals.fold(0.0, f64::max);
        let from = ends[0].max(0.2 * first);
        let to = ends[ends.len() - 1].min(1.5 * top).max(2.0 * from);
        let frequency = |n: u16| from * ((to / from).ln() * f64::from(n) / 500.0).exp();
        let points = (0..=500).map(|n| (frequency(n), sum.density(frequency(n)))).collect();
        Plot::new(
            "Power spectral density of the response",
            Axis::log("frequency", "Hz"),
            axis,
            vec![Series::line("response", points)],
        )
    }

    /// The root mean square of the displacement along the beam.
    pub(super) fn displacement_plot(&self, length: f64) -> Plot {
        let at = |xi: f64| self.sum(|mode| mode.shape.state(xi).deflection, 0).value();
        let points = along(length, at);
        Plot::new(
            "Root mean square of the displacement along the beam",
            Axis::linear("distance from the left end", "m"),
            Axis::linear("displacement", "mm"),
            vec![Series::line("σ_w", points).of("displacement")],
        )
        .over("place")
        .mark("x", (self.place * length, self.here(|mode| mode.deflection)))
    }

    /// The root mean square of the bending moment along the beam.
    pub(super) fn moment_plot(&self, length: f64) -> Plot {
        let unit = self.unit_moment.value();
        let at = |xi: f64| self.sum(|mode| mode.shape.state(xi).moment * unit, 0).value();
        let points = along(length, at);
        Plot::new(
            "Root mean square of the bending moment along the beam",
            Axis::linear("distance from the left end", "m"),
            Axis::linear("bending moment", "N*m"),
            vec![Series::line("σ_M", points).of("bending_moment")],
        )
        .over("place")
        .mark("x", (self.place * length, self.here(|mode| mode.curvature * unit)))
    }

    /// A root mean square at the place.
    fn here(&self, share: impl Fn(&LoadedMode<N>) -> f64) -> f64 {
        self.sum(share, 0).value().map_or(f64::NAN, f64::sqrt)
    }
}

/// Points along the beam, without its ends.
fn along<E>(length: f64, mean_square: impl Fn(f64) -> Result<f64, E>) -> Vec<(f64, f64)> {
    let xi = |n: u16| f64::from(n) / f64::from(PARTS);
    (1..PARTS)
        .filter_map(|n| Some((xi(n) * length, mean_square(xi(n)).ok()?.sqrt())))
        .filter(|(_, value)| value.is_finite())
        .collect()
}

impl RandomLoadOnBeam {
    /// The beam on its supports.
    pub(super) fn drawing(&self) -> Drawing {
        const WIDTH: f64 = 6.0;
        let mut sketch = Sketch::new("The beam and its load");
        sketch.bars([(0.0, 0.0), (WIDTH, 0.0)]);
        for (support, x) in [(&self.left, 0.0), (&self.right, WIDTH)] {
            let held = matches!(support, Support::Pinned | Support::Clamped);
            let clamped = matches!(support, Support::Clamped | Support::Guided);
            draw_support(&mut sketch, (held, clamped), (x, 0.0), x == 0.0);
            if let Support::Springs { .. } = support {
                sketch.spring("", (x, -1.0), (x, 0.0)).ground((x - 0.4, -1.0), (x + 0.4, -1.0));
            }
        }
        match self.load {
            RandomBeamLoad::Point { distance, .. } => {
                let x = (distance / self.length).min(1.0) * WIDTH;
                sketch.force("F(t)", (x, 1.4), (x, 0.1)).dimension("a", (0.0, 0.0), (x, 0.0), 2.0);
            }
            RandomBeamLoad::Uniform { .. } | RandomBeamLoad::Uncorrelated { .. } => {
                for n in 0..=8u8 {
                    let x = WIDTH * f64::from(n) / 8.0;
                    let name = if n == 4 { "q(t)" } else { "" };
                    sketch.force(name, (x, 0.9), (x, 0.1));
                }
            }
            RandomBeamLoad::Supports { .. } => {
                sketch.motion("ÿ(t)", (-0.8, -0.6), (-0.8, 0.6));
            }
        }
        let x = (self.place / self.length).min(1.0) * WIDTH;
        sketch.dimension("x", (0.0, -1.0), (x, -1.0), 0.0).dimension("L", (0.0, -1.5), (WIDTH, -1.5), 0.0);
        self.section.draw(&mut sketch, (WIDTH + 1.9, 0.2), 0.8);
        sketch.finish()
    }
}
