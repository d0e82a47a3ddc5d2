//! A machine with a rotating unbalance on an elastic, damped support.

use dalembert_core::{
    About, Analysis, Axis, Drawing, DrawnShape, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, beam, sdof};

use crate::sources::{KELLY, LISTS, RAO};

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
    pub support: Support,
    /// Damping.
    pub damping: Damping,
    /// Speed of the machine.
    #[input("ω", "rad/s", positive)]
    pub speed: f64,
}

/// What carries the machine.
#[derive(Clone, Debug, Inputs)]
pub enum Support {
    /// Stiffness given
    Stiffness {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Free end of a cantilever
    Cantilever {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Second moment of area.
        #[input("I", "m^4", positive)]
        second_moment: f64,
    },
    /// Middle of a simply supported beam
    SimplySupported {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Second moment of area.
        #[input("I", "m^4", positive)]
        second_moment: f64,
    },
    /// Middle of a beam clamped at both ends
    Clamped {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Second moment of area.
        #[input("I", "m^4", positive)]
        second_moment: f64,
    },
}

/// What damps the machine.
#[derive(Clone, Debug, Inputs)]
pub enum Damping {
    /// Damping ratio given
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping coefficient given
    Coefficient {
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative)]
        coefficient: f64,
    },
    /// From the largest steady amplitude at any speed
    LargestAmplitude {
        /// Largest steady amplitude.
        #[input("Xₘₐₓ", "m", positive)]
        amplitude: f64,
    },
    /// From a free decay
    Decay {
        /// Ratio of the first amplitude to the last.
        #[input("x₀/xₙ", "1", above = 1)]
        amplitude_ratio: f64,
        /// Number of cycles between them.
        /// Seven successive amplitudes are six cycles apart.
        #[input("n", "1", positive)]
        cycles: f64,
    },
}

register!(RotatingUnbalance);

impl Analysis for RotatingUnbalance {
    const ABOUT: About = About {
        id: "vibration/rotating-unbalance",
        title: "Rotating unbalance",
        summary: "Steady amplitude, phase and transmitted force of an unbalanced machine on an elastic, damped support.",
        keywords: "fan ventilador desbalanceamento desbalanceado cantilever amplitude resonance 07/2",
        sources: &[&RAO, &KELLY, &LISTS],
        cases: include_str!("../cases/rotating_unbalance.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RotatingUnbalanceGiven<W>, sheet: W) -> Result<(), Refusal> {
        let k = match &given.support {
            SupportGiven::Stiffness { stiffness } => *stiffness,
            SupportGiven::Cantilever { length, young, second_moment } => sheet.step(
                "k",
                "kN/m",
                beam::cantilever(*young, *second_moment, *length),
                ("Stiffness of a cantilever loaded at its free end", RAO.at("§1.7")),
            ),
            SupportGiven::SimplySupported { length, young, second_moment } => sheet.step(
                "k",
                "kN/m",
                beam::simply_supported_middle(*young, *second_moment, *length),
                ("Stiffness of a simply supported beam loaded in the middle", RAO.at("§1.7")),
            ),
            SupportGiven::Clamped { length, young, second_moment } => sheet.step(
                "k",
                "kN/m",
                beam::clamped_clamped_middle(*young, *second_moment, *length),
                ("Stiffness of a beam clamped at both ends, loaded in the middle", RAO.at("§1.7")),
            ),
        };
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(k, given.mass),
            ("Natural frequency without damping", RAO.at("§2.2")),
        );
        let ratio = sheet.step("r", "1", sdof::frequency_ratio(given.speed, natural), "Frequency ratio");
        let zeta = match &given.damping {
            DampingGiven::Ratio { ratio } => *ratio,
            DampingGiven::Coefficient { coefficient } => sheet.step(
                "ζ",
                "1",
                sdof::damping_ratio(*coefficient, k, given.mass),
                ("Damping ratio: damping over critical damping", RAO.at("§2.6")),
            ),
            DampingGiven::LargestAmplitude { amplitude } => {
                let peak = sheet.step(
                    "Λₘₐₓ",
                    "1",
                    *amplitude * given.mass / given.unbalance,
                    "Largest amplitude as a multiple of m₀e/m",
                );
                let zeta = sdof::damping_ratio_from_peak(peak).ok_or_else(|| {
                    Refusal::because(
                        "the largest amplitude is not above m₀e/m, so no damping gives a peak at a finite speed",
                    )
                })?;
                let zeta = sheet.step(
                    "ζ",
                    "1",
                    zeta,
                    ("Damping ratio whose peak 1/(2ζ√(1−ζ²)) is Λₘₐₓ, the smaller root", KELLY.at("§4.5")),
                );
                sheet.check("the damping ratio gives the largest amplitude back", sdof::peak_magnification(zeta), peak);
                zeta
            }
            DampingGiven::Decay { amplitude_ratio, cycles } => {
                let decrement = sheet.step(
                    "δ",
                    "1",
                    sdof::logarithmic_decrement(*amplitude_ratio, *cycles),
                    ("Logarithmic decrement", RAO.at("§2.6.3")),
                );
                sheet.step(
                    "ζ",
                    "1",
                    sdof::damping_ratio_from_decrement(decrement),
                    ("Damping ratio from the decrement", RAO.at("§2.6.3")),
                )
            }
        };
        if zeta.value() == 0.0 && ratio.value() == 1.0 {
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
        let amplitude = sheet.step(
            "X",
            "mm",
            given.unbalance / given.mass * sdof::unbalance_magnification(ratio, zeta),
            ("Steady amplitude at the speed of the machine", RAO.at("§3.7")),
        );
        let phase = sheet.step(
            "φ",
            "deg",
            sdof::phase_lag_from_ratios(ratio, zeta),
            ("The motion lags the unbalance by", RAO.at("§3.7")),
        );
        let force = sheet.step(
            "F_T",
            "N",
            sdof::transmitted_force(amplitude, k, c, given.speed),
            ("Amplitude of the force on the foundation", RAO.at("§3.7")),
        );
        sheet.check(
            "amplitude from the dynamic stiffness",
            sdof::unbalance_amplitude(given.unbalance, k, given.mass, c, given.speed),
            amplitude,
        );
        sheet.answer("stiffness", "Stiffness of the support", k);
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("frequency_ratio", "Frequency ratio", ratio);
        sheet.answer("damping_ratio", "Damping ratio", zeta);
        sheet.answer("damping", "Damping coefficient", c);
        sheet.answer("amplitude", "Amplitude at this speed", amplitude);
        sheet.answer("phase", "Phase lag", phase);
        sheet.answer("transmitted_force", "Force on the foundation", force);
        if zeta.value() < std::f64::consts::FRAC_1_SQRT_2 {
            let worst = sheet.step(
                "ωₘₐₓ",
                "rpm",
                natural * sdof::unbalance_peak_ratio(zeta),
                ("Speed of the largest steady amplitude", RAO.at("§3.7")),
            );
            sheet.answer("worst_speed", "Speed of the largest amplitude", worst);
        }
        let (wn, zeta) = (natural.value(), zeta.value());
        sheet.show(|| Exhibit::Plot(self.amplitude_over_speed(wn, zeta, amplitude.value())));
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
            "Steady amplitude against speed",
            Axis::linear("speed", "rpm"),
            Axis::linear("amplitude", "mm"),
            vec![Series::line("X", (0..=400).map(at).collect())],
        )
        .mark("at this speed", (self.speed, amplitude))
    }

    /// The machine on its support, with the unbalance at its radius.
    fn machine(&self) -> Drawing {
        let mut shapes = match self.support {
            Support::Stiffness { .. } => vec![
                DrawnShape::Ground((-1.0, -1.5), (1.0, -1.5)),
                DrawnShape::Spring((-0.4, -1.5), (-0.4, -0.4)),
                DrawnShape::Damper((0.4, -1.5), (0.4, -0.4)),
            ],
            Support::Cantilever { .. } => vec![
                DrawnShape::Ground((-3.0, 0.5), (-3.0, -1.5)),
                DrawnShape::Polyline(vec![(-3.0, -0.5), (0.6, -0.5)], Ink::Body),
            ],
            Support::SimplySupported { .. } => vec![
                DrawnShape::Polyline(vec![(-2.5, -0.5), (2.5, -0.5)], Ink::Body),
                DrawnShape::Pin((-2.5, -0.5)),
                DrawnShape::Pin((2.5, -0.5)),
            ],
            Support::Clamped { .. } => vec![
                DrawnShape::Ground((-2.5, 0.5), (-2.5, -1.5)),
                DrawnShape::Ground((2.5, -1.5), (2.5, 0.5)),
                DrawnShape::Polyline(vec![(-2.5, -0.5), (2.5, -0.5)], Ink::Body),
            ],
        };
        shapes.extend([
            DrawnShape::Block((-0.6, -0.4), (0.6, 0.8), Ink::Body),
            DrawnShape::Circle((0.0, 0.2), 0.4, Ink::Faint),
            DrawnShape::Circle((0.28, 0.48), 0.08, Ink::Danger),
            DrawnShape::Label((0.45, 0.6), Text::from("m₀e")),
            DrawnShape::Arrow((0.9, -0.3), (0.9, 0.7), Ink::Motion),
            DrawnShape::Label((1.0, 0.7), Text::from("X")),
        ]);
        Drawing { title: "The machine on its support".into(), shapes }
    }
}
