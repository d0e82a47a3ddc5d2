//! The motion that a harmonic force, or a shaking base, builds up from rest.

use dalembert_core::{Axis, Exhibit, Inputs, Plot, Series, Text, Worksheet};
use dalembert_mechanics::{
    Real, sdof,
    vibration::transient_from_rest::{HarmonicDrive, history},
};

use super::{AtFrequency, is_one, motion::OscillatorMotion};
use crate::sources::RAO;

/// Waveform of a harmonic from its start: sine or cosine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Wave {
    /// Sine: starts at zero
    Sine,
    /// Cosine: starts at its maximum
    Cosine,
}

/// Response that builds up from rest.
#[derive(Clone, Copy)]
pub(crate) struct BuildUp<N> {
    /// Translation or rotation.
    pub(crate) motion: OscillatorMotion,
    /// Deflection that the harmonic would hold at rest, m or rad.
    pub(crate) deflection: N,
    /// Frequency of the harmonic, rad/s.
    pub(crate) frequency: N,
    /// Natural frequency, rad/s.
    pub(crate) natural: N,
    /// Ratios at the frequency.
    pub(crate) at: AtFrequency<N>,
    /// Amplitude and lag of the steady motion; `None` where there is none.
    pub(crate) steady: Option<(N, N)>,
    /// Waveform of the excitation: sine or cosine.
    pub(crate) wave: Wave,
    /// True if the dashpot transmits the excitation too, as in base excitation.
    pub(crate) through_dashpot: bool,
}

impl<N: Real> BuildUp<N> {
    /// Writes the displacement at `time`, m or rad.
    pub(crate) fn displacement<W: Worksheet<Num = N>>(&self, time: N, sheet: W) -> N {
        let (x, scale) = match self.steady {
            None => self.at_resonance(time, sheet),
            Some((amplitude, lag)) => {
                let zeta = self.at.damping_ratio;
                if is_one(zeta.value()) {
                    self.critical(amplitude, lag, time, sheet)
                } else if zeta.value() < 1.0 {
                    self.oscillating(amplitude, lag, time, sheet)
                } else {
                    self.creeping(amplitude, lag, time, sheet)
                }
            }
        };
        sheet.verify(|| {
            if let Some(&(_, other)) = self.history(time.value(), 1).as_deref().and_then(<[_]>::last) {
                sheet.check_sum(
                    "displacement from the exponential of the matrix of the system",
                    x,
                    other.into(),
                    scale,
                );
            }
        });
        x
    }

    /// Shows the motion up to `time`.
    pub(crate) fn show<W: Worksheet<Num = N>>(&self, time: f64, label: &'static str, at: f64, sheet: W) {
        sheet.show(|| {
            let points = self.history(time, 400).unwrap_or_default();
            let mut series = vec![Series::line(self.motion.displacement(), points).of("displacement")];
            if let Some((amplitude, _)) = self.steady {
                let level = amplitude.value();
                series.push(Series::line("steady-state amplitude", vec![(0.0, level), (time, level)]));
            } else {
                let growth = 0.5 * self.deflection.value() * self.natural.value();
                series.push(Series::line("envelope", vec![(0.0, 0.0), (time, growth * time)]));
            }
            let plot = Plot::new(
                Text::new(label),
                Axis::linear("time", "s"),
                Axis::linear(self.motion.of("displacement", "angle"), self.motion.displacement_unit()),
                series,
            )
            .over("start.time");
            Exhibit::Plot(plot.mark("requested", (time, at)))
        });
    }

    fn history(&self, last: f64, count: u16) -> Option<Vec<(f64, f64)>> {
        let deflection = self.deflection.value();
        let dashpot = if self.through_dashpot {
            2.0 * self.at.damping_ratio.value() * self.at.ratio.value() * deflection
        } else {
            0.0
        };
        let (sine, cosine) = match self.wave {
            Wave::Sine => (deflection, dashpot),
            Wave::Cosine => (-dashpot, deflection),
        };
        let drive = HarmonicDrive { frequency: self.frequency.value(), sine, cosine };
        history(self.natural.value(), self.at.damping_ratio.value(), drive, last, count)
    }

    /// Without damping at the natural frequency.
    fn at_resonance<W: Worksheet<Num = N>>(&self, time: N, sheet: W) -> (N, f64) {
        let (deflection, frequency) = (self.deflection, self.frequency);
        let angle = frequency * time;
        let growing = match self.wave {
            Wave::Sine => deflection / 2.0 * (angle.sin() - angle * angle.cos()),
            Wave::Cosine => deflection / 2.0 * angle * angle.sin(),
        };
        let why = "Without damping at the natural frequency the motion grows with the time";
        sheet.common_error(
            self.motion.displacement(),
            "the envelope of the growing motion taken as the displacement",
            || deflection / 2.0 * angle,
        );
        let x = sheet.step(
            self.motion.displacement(),
            self.motion.displacement_unit(),
            growing,
            (why, RAO.at("§3.3")),
        );
        (x, deflection.value() * (1.0 + angle.value()))
    }

    /// The steady motion at a time.
    fn steady_motion(&self, amplitude: N, lag: N, time: N) -> N {
        let angle = self.frequency * time - lag;
        match self.wave {
            Wave::Sine => amplitude * angle.sin(),
            Wave::Cosine => amplitude * angle.cos(),
        }
    }

    /// Displacement and velocity that the steady motion would begin with, both with their sign turned: what the free
    /// motion begins with.
    fn beginning<W: Worksheet<Num = N>>(&self, amplitude: N, lag: N, sheet: W) -> (N, N) {
        let speed = amplitude * self.frequency;
        let (x, v) = match self.wave {
            Wave::Sine => (amplitude * lag.sin(), -(speed * lag.cos())),
            Wave::Cosine => (-(amplitude * lag.cos()), -(speed * lag.sin())),
        };
        let why = "The initial free displacement cancels that of the steady-state motion";
        let x =
            sheet.step(self.motion.of("x₀", "θ₀"), self.motion.displacement_unit(), x, (why, RAO.at("§3.4")));
        let why = "and the initial free velocity cancels that of the steady-state motion: together, rest";
        (x, sheet.step(self.motion.of("v₀", "Ω₀"), self.motion.velocity_unit(), v, why))
    }

    fn oscillating<W: Worksheet<Num = N>>(&self, amplitude: N, lag: N, time: N, sheet: W) -> (N, f64) {
        let (x0, v0) = self.beginning(amplitude, lag, sheet);
        let (wn, zeta) = (self.natural, self.at.damping_ratio);
        let (wd, b) = if zeta.value() == 0.0 {
            (
                wn,
                sheet.step(
                    "B",
                    self.motion.displacement_unit(),
                    v0 / wn,
                    "Sine component of the free vibration",
                ),
            )
        } else {
            let why = ("Frequency of the free vibration", RAO.at("§2.6"));
            let wd = sheet.step("ω_d", "rad/s", sdof::damped_frequency(wn, zeta), why);
            let why = ("Sine component of the free vibration", RAO.at("§2.6"));
            (wd, sheet.step("B", self.motion.displacement_unit(), (v0 + zeta * wn * x0) / wd, why))
        };
        let steady = self.steady_motion(amplitude, lag, time);
        let free = x0 * (wd * time).cos() + b * (wd * time).sin();
        let motion =
            if zeta.value() == 0.0 { steady + free } else { steady + (-(zeta * wn * time)).exp() * free };
        let why = if zeta.value() == 0.0 {
            (
                "Displacement: steady-state motion and free vibration, which does not decay without damping",
                RAO.at("§3.3"),
            )
        } else {
            ("Displacement: steady-state motion and decaying free vibration", RAO.at("§3.4"))
        };
        if zeta.value() != 0.0 {
            sheet.common_error(
                self.motion.displacement(),
                "the frequency of the excitation used in the decay of the free vibration",
                || steady + (-(zeta * self.frequency * time)).exp() * free,
            );
        }
        let x = sheet.step(self.motion.displacement(), self.motion.displacement_unit(), motion, why);
        (x, amplitude.value() + x0.value().abs() + b.value().abs())
    }

    fn critical<W: Worksheet<Num = N>>(&self, amplitude: N, lag: N, time: N, sheet: W) -> (N, f64) {
        let (x0, v0) = self.beginning(amplitude, lag, sheet);
        let wn = self.natural;
        let why = ("Growing part of the critically damped free motion", RAO.at("§2.6"));
        let b = sheet.step("B", self.motion.velocity_unit(), v0 + wn * x0, why);
        let steady = self.steady_motion(amplitude, lag, time);
        let why = ("Displacement: steady-state motion and decaying free vibration", RAO.at("§3.4"));
        let x = sheet.step(
            self.motion.displacement(),
            self.motion.displacement_unit(),
            steady + (-(wn * time)).exp() * (x0 + b * time),
            why,
        );
        (x, amplitude.value() + x0.value().abs() + (b / wn).value().abs())
    }

    fn creeping<W: Worksheet<Num = N>>(&self, amplitude: N, lag: N, time: N, sheet: W) -> (N, f64) {
        let (x0, v0) = self.beginning(amplitude, lag, sheet);
        let (wn, zeta) = (self.natural, self.at.damping_ratio);
        let width = (zeta.powi(2) - 1.0).sqrt();
        let why = ("The slower and the faster decay of the free motion", RAO.at("§2.6"));
        let slow = sheet.step("s₁", "1/s", -(wn / (zeta + width)), why);
        let fast = sheet.step("s₂", "1/s", -(wn * (zeta + width)), "The faster decay");
        let why = "Coefficient of the slower-decaying term";
        let c1 = sheet.step("C₁", self.motion.displacement_unit(), (v0 - fast * x0) / (slow - fast), why);
        let c2 = sheet.step(
            "C₂",
            self.motion.displacement_unit(),
            (slow * x0 - v0) / (slow - fast),
            "Coefficient of the faster-decaying term",
        );
        let steady = self.steady_motion(amplitude, lag, time);
        let motion = steady + c1 * (slow * time).exp() + c2 * (fast * time).exp();
        let why = ("Displacement: steady-state motion and decaying free vibration", RAO.at("§3.4"));
        let x = sheet.step(self.motion.displacement(), self.motion.displacement_unit(), motion, why);
        (x, amplitude.value() + c1.value().abs() + c2.value().abs())
    }
}
