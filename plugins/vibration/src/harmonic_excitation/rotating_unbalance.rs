//! A machine with a rotating unbalance on an elastic, damped support.

use std::f64::consts::FRAC_1_SQRT_2;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet,
    register,
};
use dalembert_mechanics::{Real, sdof};

use crate::{
    shared::{
        decay::{Decay, decrement},
        spring::{Spring, sketch, stiffness},
    },
    sources::{KELLY, LISTS, RAO},
};

/// The machine, what carries it, and what damps it.
#[derive(Clone, Debug, Inputs)]
pub struct RotatingUnbalance {
    /// Mass of the machine.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Unbalance.
    /// The eccentric mass times its eccentricity.
    #[input("m₀e", "kg*m", positive)]
    pub unbalance: f64,
    /// Support.
    pub support: Spring,
    /// Damping.
    pub damping: MachineDamping,
    /// Speed of the machine.
    #[input("ω", "rad/s", positive)]
    pub speed: f64,
}

/// Damping of the machine.
#[derive(Clone, Debug, Inputs)]
pub enum MachineDamping {
    /// Damping ratio given
    Ratio {
        /// Damping ratio.
        /// Zero for no damping.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping ratio between two values
    /// The amplitude is largest with the minimum damping, for which all other results are computed.
    Between {
        /// Minimum damping ratio.
        #[input("ζ", "1", nonnegative)]
        least: f64,
        /// Maximum damping ratio.
        #[input("ζ_b", "1", nonnegative)]
        most: f64,
    },
    /// Damping coefficient given
    Coefficient {
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative)]
        coefficient: f64,
    },
    /// From the maximum steady-state amplitude at any speed
    LargestAmplitude {
        /// Maximum steady-state amplitude.
        #[input("Xₘₐₓ", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
    /// From a free decay
    Decay {
        /// Amplitudes.
        amplitudes: Decay,
    },
}

register!(RotatingUnbalance);

impl Analysis for RotatingUnbalance {
    const ABOUT: About = About {
        id: "vibration/rotating-unbalance",
        title: "Rotating unbalance",
        topic: "Harmonic excitation",
        summary: "Steady-state amplitude, phase and transmitted force of an unbalanced machine on an elastic, damped support.",
        main: &["amplitude", "transmitted_force", "largest_amplitude"],
        keywords: "fan ventilador desbalanceamento desbalanceado cantilever amplitude resonance 07/2 rotating \
                   imbalance",
        sources: &[&RAO, &KELLY, &LISTS],
        cases: include_str!("../../cases/rotating_unbalance.toml"),
    };
    const SIMD: bool = true;

    #[inline(always)]
    fn solve<W: Worksheet>(&self, given: &RotatingUnbalanceGiven<W>, sheet: W) -> Result<(), Refusal> {
        let k = stiffness(&given.support, sheet)?;
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(k, given.mass),
            ("Natural frequency without damping", RAO.at("§2.2")),
        );
        let ratio = sheet.step("r", "1", sdof::frequency_ratio(given.speed, natural), "Frequency ratio");
        let zeta = match &given.damping {
            MachineDampingGiven::Ratio { ratio } => *ratio,
            MachineDampingGiven::Between { least, most } => {
                if least.holds_with(*most, |least, most| least > most) {
                    return Err(Refusal::because(
                        "the minimum damping ratio exceeds the maximum one: exchange them",
                    ));
                }
                *least
            }
            MachineDampingGiven::Coefficient { coefficient } => sheet.step(
                "ζ",
                "1",
                sdof::damping_ratio(*coefficient, k, given.mass),
                ("Damping ratio: damping over critical damping", RAO.at("§2.6")),
            ),
            MachineDampingGiven::LargestAmplitude { amplitude } => {
                let peak = sheet.step(
                    "Λₘₐₓ",
                    "1",
                    *amplitude * given.mass / given.unbalance,
                    "Maximum amplitude as a multiple of m₀e/m",
                );
                let zeta = sdof::damping_ratio_from_peak(peak).ok_or_else(|| {
                    Refusal::because(
                        "the largest amplitude is not above m₀e/m, so no damping gives a peak at a finite speed",
                    )
                })?;
                let light = || W::Num::from(0.5) / peak;
                sheet.common_error("ζ", "the formula for light damping, ζ = 1/(2Λ), used", light);
                sheet.common_error("ζ", "ζ = 1/√2 assumed", || W::Num::from(FRAC_1_SQRT_2));
                let zeta = sheet.step(
                    "ζ",
                    "1",
                    zeta,
                    (
                        "The peak is 1/(2ζ√(1 − ζ²)), a quadratic equation in ζ²; its smaller root",
                        KELLY.at("§4.5"),
                    ),
                );
                if let Some(other) = sdof::extraneous_damping_ratio_from_peak(peak) {
                    sheet.step(
                        "ζ₂",
                        "1",
                        other,
                        "Its larger root lies above 1/√2, where the response has no peak: rejected",
                    );
                }
                sheet.check(
                    "substituting ζ reproduces the given peak amplitude",
                    sdof::peak_magnification(zeta),
                    peak,
                );
                zeta
            }
            MachineDampingGiven::Decay { amplitudes } => decrement(amplitudes, sheet).damping_ratio,
        };
        if zeta.holds_with(ratio, |zeta, ratio| zeta == 0.0 && ratio == 1.0) {
            return Err(Refusal::because(
                "without damping, the amplitude at the natural frequency grows without bound: there is no steady state",
            ));
        }
        let c = sheet.step(
            "c",
            "N*s/m",
            sdof::damping_from_ratio(zeta, k, given.mass),
            ("Damping coefficient", RAO.at("§2.6")),
        );
        let far = || given.unbalance / given.mass;
        sheet.common_error("X", "the transmissibility used in place of the response to an unbalance", || {
            far() * sdof::transmissibility(ratio, zeta)
        });
        sheet.common_error("X", "the amplitude far above the resonance, m₀e/m, taken", far);
        sheet.common_error("X", "the centrifugal force of the unbalance taken as a static load", || {
            given.unbalance * given.speed.powi(2) / k
        });
        let amplitude = sheet.step(
            "X",
            "mm",
            given.unbalance / given.mass * sdof::unbalance_magnification(ratio, zeta),
            ("Steady-state amplitude at the running speed", RAO.at("§3.7")),
        );
        let phase = sheet.step(
            "φ",
            "deg",
            sdof::phase_lag_from_ratios(ratio, zeta),
            ("The motion lags the unbalance by", RAO.at("§3.7")),
        );
        let centrifugal = || given.unbalance * given.speed.powi(2);
        sheet.common_error("F_T", "the centrifugal force taken as the force transmitted", centrifugal);
        sheet.common_error("F_T", "the amplitude ratio mX/(m₀e) used as the transmissibility", || {
            centrifugal() * sdof::unbalance_magnification(ratio, zeta)
        });
        sheet.common_error("F_T", "the transmissibility without damping used", || {
            centrifugal() / (W::Num::from(1.0) - ratio.powi(2)).abs()
        });
        let force = sheet.step(
            "F_T",
            "N",
            sdof::transmitted_force(amplitude, k, c, given.speed),
            ("Amplitude of the force transmitted to the foundation", RAO.at("§3.7")),
        );
        // A sweep has no use for the checks: not even for their formulas.
        sheet.verify(|| {
            sheet.check(
                "amplitude from the dynamic stiffness",
                sdof::unbalance_amplitude(given.unbalance, k, given.mass, c, given.speed),
                amplitude,
            );
            sheet.check(
                "transmitted force from the transmissibility of the unbalance force",
                given.unbalance * given.speed.powi(2) * sdof::transmissibility(ratio, zeta),
                force,
            );
            sheet.check(
                "phase lag from stiffness, mass and damping",
                sdof::phase_lag(k, given.mass, c, given.speed),
                phase,
            );
        });
        sheet.answer("stiffness", "Stiffness of the support", k);
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("frequency_ratio", "Frequency ratio", ratio);
        sheet.answer("damping_ratio", "Damping ratio", zeta);
        sheet.answer("damping", "Damping coefficient", c);
        sheet.answer("amplitude", "Amplitude at this speed", amplitude);
        sheet.answer("phase", "Phase lag", phase);
        sheet.answer("transmitted_force", "Force transmitted to the foundation", force);
        if let MachineDampingGiven::Between { most, .. } = &given.damping {
            let least = sheet.step(
                "X_b",
                "mm",
                given.unbalance / given.mass * sdof::unbalance_magnification(ratio, *most),
                ("Steady-state amplitude with the maximum damping", RAO.at("§3.7")),
            );
            sheet.verify(|| {
                let c = *most * given.mass * natural * 2.0;
                sheet.check(
                    "amplitude with the largest damping from the dynamic stiffness",
                    sdof::unbalance_amplitude(given.unbalance, k, given.mass, c, given.speed),
                    least,
                );
            });
            sheet.answer("least_amplitude", "Amplitude with the maximum damping", least);
        }
        if zeta.holds(|zeta| zeta > 0.0 && zeta < FRAC_1_SQRT_2) {
            sheet.common_error("ωₘₐₓ", "the peak for a force of constant amplitude taken", || {
                natural * sdof::magnification_peak_ratio(zeta)
            });
            sheet.common_error(
                "ωₘₐₓ",
                "the damped natural frequency taken as that of the peak",
                || sdof::damped_frequency(natural, zeta),
            );
            let worst = sheet.step(
                "ωₘₐₓ",
                "rpm",
                natural * sdof::unbalance_peak_ratio(zeta),
                ("Speed of maximum steady-state amplitude", RAO.at("§3.7")),
            );
            sheet.answer("worst_speed", "Peak-response speed", worst);
            if !matches!(self.damping, MachineDamping::LargestAmplitude { .. }) {
                sheet.common_error(
                    "Xₘₐₓ",
                    "the amplitude at the natural frequency taken as the maximum",
                    || far() * sdof::quality_factor(zeta),
                );
                let largest = sheet.step(
                    "Xₘₐₓ",
                    "mm",
                    given.unbalance / given.mass * sdof::peak_magnification(zeta),
                    ("Maximum steady-state amplitude at any speed", RAO.at("§3.7")),
                );
                sheet.check(
                    "maximum amplitude from the dynamic stiffness at its speed",
                    sdof::unbalance_amplitude(given.unbalance, k, given.mass, c, worst),
                    largest,
                );
                sheet.answer("largest_amplitude", "Maximum amplitude at any speed", largest);
            }
        }
        sheet.verify(|| {
            if zeta.value() < 0.05 && (ratio.value() - 1.0).abs() < 0.05 {
                sheet.warn(|| {
                    Text::new(
                        "the machine runs within 5 % of its natural frequency with little damping: small errors of mass, \
                         stiffness or speed change the amplitude greatly",
                    )
                });
            }
        });
        sheet.show(|| {
            Exhibit::Plot(self.amplitude_over_speed(natural.value(), zeta.value(), amplitude.value()))
        });
        sheet.show(|| Exhibit::Drawing(self.machine()));
        Ok(())
    }
}

impl RotatingUnbalance {
    fn amplitude_over_speed(&self, natural: f64, zeta: f64, amplitude: f64) -> Plot {
        let last = 2.5 * natural.max(0.6 * self.speed);
        let at = |n: u16| {
            let speed = last * f64::from(n) / 400.0;
            (speed, self.unbalance / self.mass * sdof::unbalance_magnification(speed / natural, zeta))
        };
        Plot::new(
            "Steady-state amplitude against speed",
            Axis::linear("speed of the machine", "rpm"),
            Axis::linear("amplitude", "mm"),
            vec![Series::line("X", (0..=400).map(at).collect()).of("amplitude")],
        )
        .over("speed")
        .mark("at this speed", (self.speed, amplitude))
    }

    /// The machine on its support.
    fn machine(&self) -> Drawing {
        let mut sketch = Sketch::new("The machine on its support");
        sketch::carrying(&self.support, &mut sketch);
        let motion = match self.damping {
            MachineDamping::LargestAmplitude { .. } => "X ≤ Xₘₐₓ",
            _ => "X",
        };
        sketch
            .mass("", (-0.6, -0.4), (0.6, 0.8))
            .label("m", (-0.4, -0.2))
            .circle((0.0, 0.2), 0.4, Ink::Faint)
            .axis((0.0, 0.2), (0.28, 0.48))
            .round("m₀e", (0.28, 0.48), 0.08, Ink::Danger)
            .joint("", (0.0, 0.2))
            .couple("ω", (0.0, 0.2), (3.6, 5.4), Ink::Motion)
            .motion(motion, (0.9, -0.3), (0.9, 0.7))
            .finish()
    }
}
