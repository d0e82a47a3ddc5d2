//! A seismic instrument: in which frequencies its reading is right, and what a reading says of the true motion.

use std::f64::consts::FRAC_1_SQRT_2;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Symbol, Text, Worksheet,
    register,
};
use dalembert_mechanics::{
    Real, sdof,
    vibration::instrument::{self, usable_ratios},
};
use dalembert_numerics::intervals::IntervalSet;

mod record;

use crate::{
    shared::oscillator::{is_one, plots, resisting_force},
    sources::{RAO, THOMSON},
};

/// The instrument, and what is asked of it.
#[derive(Clone, Debug, Inputs)]
pub struct VibrationInstrument {
    /// Instrument.
    pub instrument: Instrument,
    /// Natural frequency.
    /// Without damping.
    #[input("ωₙ", "Hz", positive)]
    pub natural_frequency: f64,
    /// Damping.
    pub damping: InstrumentDamping,
    /// Allowed error.
    /// Of the amplitude, up or down: the frequencies within it are reported.
    #[input("p", "%", positive, below = 100)]
    pub allowed_error: Option<f64>,
    /// Frequency of the motion.
    /// Amplitude and phase errors are computed at this frequency.
    #[input("ω", "Hz", positive)]
    pub frequency: Option<f64>,
    /// Reading.
    /// The true motion at that frequency is computed.
    pub reading: Option<InstrumentReading>,
    /// Harmonic components of a motion.
    /// How each tone is recorded, and whether the record preserves the waveform.
    #[input(table)]
    pub tones: Option<Vec<Tone>>,
}

/// One tone of a motion.
#[derive(Clone, Debug, Inputs)]
pub struct Tone {
    /// Frequency.
    #[input("ω", "Hz", positive)]
    pub frequency: f64,
    /// True amplitude.
    /// In any one unit: only the shape matters.
    #[input("Y", "1", nonnegative)]
    pub amplitude: f64,
}

/// Quantity that the instrument measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Instrument {
    /// Vibrometer or seismometer: displacement
    /// Used above its natural frequency, where the seismic mass remains at rest.
    Vibrometer,
    /// Accelerometer
    /// Used below its natural frequency, where the seismic mass follows the base.
    Accelerometer,
}

/// Damping of the seismic mass.
#[derive(Clone, Debug, Inputs)]
pub enum InstrumentDamping {
    /// Damping ratio given
    Ratio {
        /// Damping ratio.
        /// Zero for no damping.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// From the frequency of the damped free vibration
    DampedFrequency {
        /// Frequency of the free vibration.
        #[input("ω_d", "Hz", positive)]
        frequency: f64,
    },
}

/// Reading of the instrument.
#[derive(Clone, Debug, Inputs)]
pub enum InstrumentReading {
    /// Displacement
    /// The relative motion of the seismic mass, as a vibrometer shows it.
    Displacement {
        /// Amplitude reading.
        /// Zero to peak; write mm pp for a peak-to-peak reading.
        #[input("Z", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
    /// Acceleration
    /// As indicated by an accelerometer.
    Acceleration {
        /// Acceleration reading.
        /// Its amplitude, zero to peak.
        #[input("A_r", "m/s^2", positive)]
        acceleration: f64,
    },
}

/// Common errors of an instrument.
const OTHER_INSTRUMENT: &str = "the formula of the other kind of instrument used";
const BY_NATURAL: &str = "the natural frequency of the instrument used in place of that of the motion";

register!(VibrationInstrument);

impl Analysis for VibrationInstrument {
    const ABOUT: About = About {
        id: "vibration/vibration-instrument",
        title: "Vibrometer and accelerometer",
        topic: "Isolation, absorbers and instruments",
        summary: "Usable frequencies of a seismic instrument for an allowed error, its amplitude and phase error at a frequency, and the true motion for a given reading.",
        main: &["amplitude", "factor", "error", "usable_frequencies", "distortion"],
        keywords: "seismometer seismograph pickup transducer usable range phase distortion torsiograph \
                   vibrômetro acelerômetro sismógrafo torsiógrafo sensor faixa de uso erro de fase measuring \
                   instrument measurement device vibration measurement instrumento de medição medidor seismic \
                   mass massa sísmica",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/vibration_instrument.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &VibrationInstrumentGiven<W>, sheet: W) -> Result<(), Refusal> {
        let zeta = damping_ratio(given, sheet)?;
        sheet.answer("natural_frequency", "Natural frequency", given.natural_frequency);
        sheet.answer("damping_ratio", "Damping ratio", zeta);
        if given.allowed_error.is_none() && given.frequency.is_none() && self.tones.is_none() {
            return Err(Refusal::because(
                "no result is requested: write an allowed error, the frequency of the motion, or its tones",
            ));
        }
        if given.frequency.is_none() && given.reading.is_some() {
            return Err(Refusal::because(
                "the true motion behind a reading needs the frequency of the motion",
            ));
        }
        let ratio = match given.frequency {
            Some(frequency) => Some(self.at_frequency(given, frequency, zeta, sheet)?),
            None => None,
        };
        let band = match given.allowed_error {
            Some(error) => Some(self.usable(given, error, zeta, sheet)?),
            None => None,
        };
        self.peak(zeta, given.natural_frequency, sheet);
        if let Some(tones) = &self.tones {
            record::solve(self, tones, given.natural_frequency, zeta, sheet)?;
        }
        let (wn, zeta) = (given.natural_frequency.value(), zeta.value());
        let ratio = ratio.map(Real::value);
        sheet.show(|| Exhibit::Plot(self.reading_over_frequency(wn, zeta, ratio, band.as_ref())));
        sheet.show(|| {
            let lag = |r: f64| sdof::phase_lag_from_ratios(r, zeta);
            let here = ratio.unwrap_or(1.0);
            let y = Axis::linear("phase lag", "deg");
            let title = "Phase lag against frequency ratio";
            let plot = plots::family(title, y, (here, lag(here)), lag, sdof::phase_lag_from_ratios);
            Exhibit::Plot(plots::answered(plot, "frequency", "phase"))
        });
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

fn damping_ratio<W: Worksheet>(given: &VibrationInstrumentGiven<W>, sheet: W) -> Result<W::Num, Refusal> {
    match &given.damping {
        InstrumentDampingGiven::Ratio { ratio } => Ok(*ratio),
        InstrumentDampingGiven::DampedFrequency { frequency } => {
            let natural = given.natural_frequency;
            if frequency.value() > natural.value() {
                return Err(Refusal::because(
                    "the damped natural frequency never exceeds the natural frequency: write the larger frequency as the natural one",
                ));
            }
            let zeta = (W::Num::from(1.0) - (*frequency / natural).powi(2)).sqrt();
            let of_peak = || ((W::Num::from(1.0) - (*frequency / natural).powi(2)) / 2.0).sqrt();
            let what = "the frequency of the free vibration taken as that of the largest reading";
            sheet.common_error("ζ", what, of_peak);
            let zeta = sheet.step("ζ", "1", zeta, ("Damping ratio, from ω_d = ωₙ√(1 − ζ²)", RAO.at("§2.6")));
            sheet.check_zero(
                "the damping ratio reproduces the damped frequency",
                sdof::damped_frequency(natural, zeta) - *frequency,
                natural.value(),
            );
            Ok(zeta)
        }
    }
}

impl VibrationInstrument {
    /// Ratio of reading to motion at a frequency ratio.
    fn factor<N: Real>(&self, ratio: N, zeta: N) -> N {
        match self.instrument {
            Instrument::Vibrometer => sdof::unbalance_magnification(ratio, zeta),
            Instrument::Accelerometer => sdof::magnification(ratio, zeta),
        }
    }

    /// Common errors in the ratio of reading to motion.
    fn factor_errors<W: Worksheet>(&self, symbol: Symbol, ratio: W::Num, zeta: W::Num, sheet: W) {
        let other = || match self.instrument {
            Instrument::Vibrometer => sdof::magnification(ratio, zeta),
            Instrument::Accelerometer => sdof::unbalance_magnification(ratio, zeta),
        };
        sheet.common_error(symbol, OTHER_INSTRUMENT, other);
        let absolute = || sdof::transmissibility(ratio, zeta);
        let what = "the transmissibility used, as for the absolute motion of the mass";
        sheet.common_error(symbol, what, absolute);
    }

    /// The factor from the square of the frequency ratio alone: another arrangement.
    fn factor_of_square<N: Real>(&self, ratio: N, zeta: N) -> N {
        let square = match self.instrument {
            Instrument::Vibrometer => N::from(1.0) / ratio.powi(2),
            Instrument::Accelerometer => ratio.powi(2),
        };
        N::from(1.0) / (square * (square - 2.0 + zeta.powi(2) * 4.0) + 1.0).sqrt()
    }

    /// Error of amplitude and phase at a frequency, and the true motion behind a reading; the frequency ratio.
    fn at_frequency<W: Worksheet>(
        &self,
        given: &VibrationInstrumentGiven<W>,
        frequency: W::Num,
        zeta: W::Num,
        sheet: W,
    ) -> Result<W::Num, Refusal> {
        let ratio = sheet.step(
            "r",
            "1",
            sdof::frequency_ratio(frequency, given.natural_frequency),
            "Frequency ratio",
        );
        if zeta.value() == 0.0 && is_one(ratio.value()) {
            return Err(Refusal::because(
                "without damping, the reading at the natural frequency grows without bound: there is no steady state",
            ));
        }
        let why = match self.instrument {
            Instrument::Vibrometer => "Ratio of reading to true displacement",
            Instrument::Accelerometer => "Ratio of reading to true acceleration",
        };
        self.factor_errors("M".into(), ratio, zeta, sheet);
        let factor = sheet.step("M", "1", self.factor(ratio, zeta), (why, RAO.at("§10.3")));
        sheet.verify(|| {
            let other = self.factor_of_square(ratio, zeta);
            sheet.check("the same from the square of the frequency ratio", other, factor);
        });
        let of_reading = || W::Num::from(1.0) - W::Num::from(1.0) / factor;
        sheet.common_error("e", "the error taken as a fraction of the reading", of_reading);
        let error = sheet.step(
            "e",
            "%",
            factor - 1.0,
            "Error of the amplitude; where it is positive the reading is too high",
        );
        let principal = || {
            let tangent = zeta * ratio * 2.0 / (W::Num::from(1.0) - ratio.powi(2));
            tangent.atan2(W::Num::from(1.0))
        };
        let what = "the principal value of the arctangent taken, the quadrant ignored";
        sheet.common_error("φ", what, principal);
        let absolute = || sdof::transmissibility_phase(ratio, zeta);
        sheet.common_error("φ", "the phase of the absolute motion of the mass taken", absolute);
        let lag = sheet.step(
            "φ",
            "deg",
            sdof::phase_lag_from_ratios(ratio, zeta),
            ("The relative motion lags the motion by", RAO.at("§10.3")),
        );
        let delay = sheet.step(
            "t_φ",
            "ms",
            lag / frequency,
            (
                "Time delay of the record; without distortion it would be the same at every frequency",
                RAO.at("§10.3"),
            ),
        );
        sheet.answer("frequency_ratio", "Frequency ratio", ratio);
        sheet.answer("factor", "Ratio of reading to true value", factor);
        sheet.answer("error", "Error of the amplitude", error);
        sheet.answer("phase", "Phase lag", lag);
        sheet.answer("delay", "Delay of the record", delay);
        sheet.verify(|| {
            let one = W::Num::from(1.0);
            let what = "the error from the forces of inertia, spring and damper for a unit reading";
            let square = self.factor_of_square(ratio, zeta).powi(2);
            sheet.check(what, (error + 1.0).powi(2), square);
            let drive = match self.instrument {
                Instrument::Vibrometer => ratio.powi(2),
                Instrument::Accelerometer => one,
            };
            let ([in_phase, across], size) = resisting_force([ratio, zeta], factor, frequency * delay);
            let what =
                "equation of relative motion with this delay: component in phase with the motion of the case";
            sheet.check_sum(what, in_phase, drive, size);
            let what = "equation of relative motion with this delay: quadrature component (90° ahead)";
            sheet.check_zero(what, across, size);
        });
        let natural = given.natural_frequency;
        let compared_with = |relative: W::Num, motion: W::Num, acceleration: W::Num| {
            let ([in_phase, _], _) = resisting_force([ratio, zeta], relative, lag);
            let what = "equation of the relative motion under the true acceleration";
            sheet.check(what, in_phase * natural.powi(2), acceleration);
            let what = "equation of the relative motion under the true displacement";
            sheet.check(what, in_phase, motion * ratio.powi(2));
        };
        match (&given.reading, self.instrument) {
            (None, _) => {}
            (Some(InstrumentReadingGiven::Displacement { amplitude }), Instrument::Vibrometer) => {
                let why = ("True amplitude for the given reading", RAO.at("§10.3"));
                let motion = sheet.step("Y", "mm", *amplitude / factor, why);
                let why = "Its acceleration";
                sheet.common_error("A", BY_NATURAL, || motion * natural.powi(2));
                let acceleration = sheet.step("A", "m/s^2", motion * frequency.powi(2), why);
                sheet.answer("amplitude", "True amplitude", motion);
                sheet.answer("acceleration", "True acceleration", acceleration);
                sheet.verify(|| compared_with(*amplitude, motion, acceleration));
            }
            (Some(InstrumentReadingGiven::Acceleration { acceleration }), Instrument::Accelerometer) => {
                let why = ("True acceleration for the given reading", RAO.at("§10.3"));
                let truth = sheet.step("A", "m/s^2", *acceleration / factor, why);
                let why = "Amplitude of the motion with this acceleration";
                sheet.common_error("Y", BY_NATURAL, || truth / natural.powi(2));
                let motion = sheet.step("Y", "mm", truth / frequency.powi(2), why);
                sheet.answer("amplitude", "True amplitude", motion);
                sheet.answer("acceleration", "True acceleration", truth);
                sheet.verify(|| compared_with(*acceleration / natural.powi(2), motion, truth));
            }
            (Some(_), Instrument::Vibrometer) => {
                return Err(Refusal::because(
                    "a vibrometer reads a displacement: write the reading as a displacement",
                ));
            }
            (Some(_), Instrument::Accelerometer) => {
                return Err(Refusal::because(
                    "an accelerometer reads an acceleration: write the reading as an acceleration",
                ));
            }
        }
        Ok(ratio)
    }

    /// The frequencies whose amplitude error is allowed.
    fn usable<W: Worksheet>(
        &self,
        given: &VibrationInstrumentGiven<W>,
        error: W::Num,
        zeta: W::Num,
        sheet: W,
    ) -> Result<IntervalSet, Refusal> {
        use std::ops::Bound::{Excluded, Included, Unbounded};
        let natural = given.natural_frequency;
        let reads = match self.instrument {
            Instrument::Vibrometer => instrument::Reads::Displacement,
            Instrument::Accelerometer => instrument::Reads::Acceleration,
        };
        let ratios = usable_ratios(reads, zeta.value(), error.value());
        let end = |bound| match bound {
            Included(r) | Excluded(r) if r > 0.0 => Some(r),
            _ => None,
        };
        // The end of the range that the instrument is made for.
        let limit = match self.instrument {
            Instrument::Vibrometer => ratios
                .intervals()
                .last()
                .filter(|last| last.upper == Unbounded)
                .and_then(|last| end(last.lower)),
            Instrument::Accelerometer => ratios
                .intervals()
                .next()
                .filter(|first| end(first.lower).is_none())
                .and_then(|first| end(first.upper)),
        };
        let Some(limit) = limit.filter(|r| (r * natural.value()).is_finite()) else {
            return Err(Refusal::because("these numbers lead to values outside the representable range"));
        };
        let why = (
            "Frequency ratio at which the allowed error is reached: a root of the quadratic equation in r² of the error",
            RAO.at("§10.3"),
        );
        let undamped = || match self.instrument {
            Instrument::Vibrometer => ((error + 1.0) / error).sqrt(),
            Instrument::Accelerometer => (error / (error + 1.0)).sqrt(),
        };
        sheet.common_error("r_p", "the damping of the instrument neglected", undamped);
        let limit = sheet.numerical("r_p", "1", limit, why);
        let high = self.factor(limit, zeta).value() > 1.0;
        let reached = if high { error + 1.0 } else { W::Num::from(1.0) - error };
        let rounding = "the error of the reading at that ratio equals the allowed error";
        sheet.check(rounding, self.factor(limit, zeta), reached);
        let (symbol, name, label, why) = match self.instrument {
            Instrument::Vibrometer => (
                "ω_min",
                "lowest_frequency",
                "Lowest usable frequency",
                "Lowest frequency above which the error stays within the limit",
            ),
            Instrument::Accelerometer => (
                "ω_max",
                "highest_frequency",
                "Highest usable frequency",
                "Highest frequency below which the error stays within the limit",
            ),
        };
        let frequency = sheet.step(symbol, "Hz", limit * natural, why);
        sheet.answer(name, label, frequency);
        let rounding = "the error of the reading at that frequency equals the allowed error";
        sheet.check(rounding, self.factor_of_square(frequency / natural, zeta), reached);
        let needed = given.frequency.map(|frequency| {
            let why = "Natural frequency of an instrument of this damping that reads this frequency exactly at the error limit";
            sheet.step("ω_lim", "Hz", frequency / limit, why)
        });
        if let Some(needed) = needed {
            sheet.answer("needed_natural_frequency", "Natural frequency needed at this frequency", needed);
        }
        if let (Some(frequency), Some(needed)) = (given.frequency, needed) {
            let what = "an instrument with the required natural frequency reads this frequency with the allowed error";
            sheet.check(what, self.factor_of_square(frequency / needed, zeta), reached);
        }
        let most = sheet.step("Λ", "1", error + 1.0, "Maximum permitted ratio of reading to true value");
        let best = sdof::damping_ratio_from_peak(most);
        if let Some(best) = best.filter(|best| best.value().is_finite()) {
            let why = "Damping ratio for the widest band: the peak just reaches the allowed error";
            let usual = || W::Num::from(FRAC_1_SQRT_2);
            sheet.common_error("ζ_p", "ζ = 1/√2 assumed", usual);
            let light = || W::Num::from(0.5) / most;
            sheet.common_error("ζ_p", "the formula for light damping, ζ = 1/(2Λ), used", light);
            let best = sheet.step("ζ_p", "1", best, (why, RAO.at("§10.3")));
            sheet.check("its peak is the allowed error", sdof::peak_magnification(best), most);
            sheet.answer("best_damping_ratio", "Damping ratio for the widest band", best);
        }
        let frequencies = ratios.map_ascending(|r| r * natural.value());
        let ends = frequencies.intervals().flat_map(|interval| [interval.lower, interval.upper]);
        let limits = ends
            .filter_map(end)
            .map(|frequency| {
                let reading = self.factor(frequency / natural.value(), zeta.value());
                if reading > 1.0 {
                    Text::new("the reading exceeds the true value by the allowed error")
                } else {
                    Text::new("the reading is below the true value by the allowed error")
                }
            })
            .collect();
        sheet.answer_set(
            "usable_frequencies",
            "Frequencies within the allowed error",
            "Hz",
            &frequencies,
            limits,
        );
        Ok(frequencies)
    }

    /// Peak of the reading over frequency.
    fn peak<W: Worksheet>(&self, zeta: W::Num, natural: W::Num, sheet: W) {
        if zeta.value() == 0.0 || zeta.value() >= FRAC_1_SQRT_2 {
            return;
        }
        let ratio = match self.instrument {
            Instrument::Vibrometer => sdof::unbalance_peak_ratio(zeta),
            Instrument::Accelerometer => sdof::magnification_peak_ratio(zeta),
        };
        let damped = || sdof::damped_frequency(natural, zeta);
        sheet.common_error("ωₚ", "the frequency of the damped free vibration used", damped);
        let at = sheet.step("ωₚ", "Hz", natural * ratio, ("Frequency of maximum reading", RAO.at("§10.3")));
        let at_natural = || W::Num::from(0.5) / zeta;
        sheet.common_error("Mₚ", "the ratio at the natural frequency, 1/(2ζ), used", at_natural);
        let peak =
            sheet.step("Mₚ", "1", sdof::peak_magnification(zeta), "Maximum ratio of reading to true value");
        sheet.check("maximum reading at its frequency", self.factor(at / natural, zeta), peak);
        let square = match self.instrument {
            Instrument::Vibrometer => (natural / at).powi(2),
            Instrument::Accelerometer => (at / natural).powi(2),
        };
        sheet.check_zero(
            "maximum reading: zero slope of the reading with respect to frequency",
            square + zeta.powi(2) * 2.0 - 1.0,
            1.0,
        );
        sheet.answer("peak_frequency", "Frequency of maximum reading", at);
        sheet.answer("peak", "Maximum ratio of reading to true value", peak);
    }

    fn reading_over_frequency(
        &self,
        natural: f64,
        zeta: f64,
        ratio: Option<f64>,
        band: Option<&IntervalSet>,
    ) -> Plot {
        let last = ratio.map_or(4.0, |r| (1.3 * r).clamp(4.0, 20.0));
        let at = |n: u16| last * f64::from(n) / 300.0;
        let of = |r: f64| {
            let factor = if r == 0.0 && self.instrument == Instrument::Vibrometer {
                0.0
            } else {
                self.factor(r, zeta)
            };
            (r * natural, plots::below(factor, 5.0))
        };
        let mut plot = Plot::new(
            "Ratio of reading to true value against frequency",
            Axis::linear("frequency", "Hz"),
            Axis::linear("reading over true value", "1"),
            vec![Series::line("this instrument", (0..=300).map(at).map(of).collect()).of("factor")],
        )
        .over("frequency");
        if let Some(r) = ratio {
            plot = plot.mark("at this frequency", of(r));
        }
        for interval in band.into_iter().flat_map(IntervalSet::intervals) {
            use std::ops::Bound::{Excluded, Included, Unbounded};
            let end = |bound, open: f64| match bound {
                Included(x) | Excluded(x) => x,
                Unbounded => open,
            };
            plot = plot.band("usable", end(interval.lower, 0.0), end(interval.upper, f64::INFINITY), true);
        }
        plot
    }
}

impl VibrationInstrument {
    fn drawing(&self) -> Drawing {
        let reading = match self.reading {
            Some(InstrumentReading::Displacement { .. }) => "z, Z",
            Some(InstrumentReading::Acceleration { .. }) => "z, A_r",
            None => "z",
        };
        Sketch::new("The seismic mass in its case")
            .body("", [(-1.3, -1.5), (-1.3, 1.1), (1.3, 1.1), (1.3, -1.5)])
            .ground((-1.6, -1.5), (1.6, -1.5))
            .spring("k", (-0.4, -1.5), (-0.4, -0.4))
            .damper("c", (0.4, -1.5), (0.4, -0.4))
            .mass("m", (-0.8, -0.4), (0.8, 0.3))
            .motion(reading, (1.0, -0.3), (1.0, 0.4))
            .motion("y", (1.7, -1.7), (1.7, -1.0))
            .finish()
    }
}
