//! Stiffness, mass and damping of one degree of freedom from its measured frequency response.

use dalembert_core::{
    About, Analysis, Cell, Column, Exhibit, Inputs, Refusal, TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, identification, sdof};

mod circle;
mod complex;
mod few_points;
mod half_power;
mod mode;
mod normal_equations;
mod plots;
mod points;
mod table;

pub use self::{
    complex::{
        AccelerancePart, AccelerancePolar, DampingKind, MobilityPart, MobilityPolar, ReceptancePart,
        ReceptancePolar, ResidualKind, ResponseTable,
    },
    few_points::{MachineExcitation, PeakRead},
};
use crate::shared::oscillator;
use crate::sources::{EWINS, LISTS, RAO};

/// Inputs: the measurement, and the force whose response is computed.
#[derive(Clone, Debug, Inputs)]
pub struct FrequencyResponseIdentification {
    /// Measurement.
    pub measurement: Measurement,
    /// Amplitude of the force.
    /// If given, the amplitude at resonance is also computed in metres.
    #[input("F₀", "N", positive)]
    pub force: Option<f64>,
}

/// Measured receptance, the amplitude of the motion over that of the force.
#[derive(Clone, Debug, Inputs)]
pub enum Measurement {
    /// Static value and peak
    Points {
        /// Static receptance.
        /// Deflection under a constant force, over that force.
        #[input("H₀", "m/N", positive)]
        static_receptance: f64,
        /// Receptance at the peak.
        #[input("Hₚ", "m/N", positive)]
        peak_receptance: f64,
        /// Frequency of the peak.
        #[input("ωₚ", "rad/s", positive)]
        peak_frequency: f64,
    },
    /// Table of the frequency response
    Table {
        /// Points.
        /// In any order; at least five, with the peak among them and not at an end.
        #[input(table)]
        points: Vec<MeasuredPoint>,
    },
    /// Table of the complex frequency response
    /// From a circle fit and complex least squares, compared with estimates from the amplitude alone.
    Complex {
        /// Frequency response.
        response: ResponseTable,
        /// Kind of damping.
        damping: DampingKind,
        /// Other modes.
        residuals: ResidualKind,
        /// Lowest frequency used.
        /// Points below it are ignored.
        #[input("ω_min", "Hz", positive)]
        lowest: Option<f64>,
        /// Highest frequency used.
        /// Points above it are ignored.
        #[input("ω_max", "Hz", positive)]
        highest: Option<f64>,
    },
    /// Frequencies of free vibration and of the forced peak
    FreeAndForced {
        /// Frequency of the free, damped vibration.
        #[input("ω_d", "Hz", positive)]
        damped_frequency: f64,
        /// Frequency of maximum amplitude under a force.
        #[input("ωₚ", "Hz", positive)]
        peak_frequency: f64,
    },
    /// Half-power frequencies
    HalfPower {
        /// Lower half-power frequency.
        /// Below the peak, where the amplitude is 1/√2 of its peak: 3 dB down.
        #[input("ω₁", "Hz", positive)]
        lower_frequency: f64,
        /// Upper half-power frequency.
        #[input("ω₂", "Hz", positive)]
        upper_frequency: f64,
        /// Natural frequency.
        /// Of the peak. If omitted, it follows from the two half-power frequencies.
        #[input("ωₙ", "Hz", positive)]
        natural_frequency: Option<f64>,
    },
    /// Unbalance: amplitudes at resonance and far above it
    ResonanceAndFar {
        /// Amplitude at resonance.
        #[input("X", "m", positive, kind = "Amplitude")]
        resonant_amplitude: f64,
        /// Amplitude far above the resonance.
        /// There it is m₀e/m, whatever the damping.
        #[input("X_∞", "m", positive, kind = "Amplitude")]
        far_amplitude: f64,
        /// The amplitude at resonance was read.
        read: PeakRead,
    },
    /// Unbalance: amplitudes at two speeds
    TwoSpeeds {
        /// Amplitude far above the resonance.
        /// There it is m₀e/m, whatever the damping.
        #[input("X_∞", "m", positive, kind = "Amplitude")]
        far_amplitude: f64,
        /// First speed.
        #[input("ω₁", "rpm", positive)]
        first_speed: f64,
        /// Amplitude at the first speed.
        #[input("X₁", "m", positive, kind = "Amplitude")]
        first_amplitude: f64,
        /// Second speed.
        #[input("ω₂", "rpm", positive)]
        second_speed: f64,
        /// Amplitude at the second speed.
        #[input("X₂", "m", positive, kind = "Amplitude")]
        second_amplitude: f64,
    },
    /// Amplitude at resonance over that at another frequency
    ResonanceRatio {
        /// Excitation.
        excitation: MachineExcitation,
        /// Amplitude at the natural frequency over the other amplitude.
        #[input("q", "1", positive)]
        amplitude_ratio: f64,
        /// Frequency of the other amplitude over the natural frequency.
        #[input("r", "1", positive)]
        frequency_ratio: f64,
    },
}

/// A point of the measured response.
#[derive(Clone, Debug, Inputs)]
pub struct MeasuredPoint {
    /// Frequency.
    #[input("ω", "Hz", nonnegative, default_before = "rad/s")]
    pub frequency: f64,
    /// Receptance.
    #[input("H", "m/N", positive)]
    pub receptance: f64,
}

register!(FrequencyResponseIdentification);

impl Analysis for FrequencyResponseIdentification {
    const ABOUT: About = About {
        id: "vibration/frequency-response-identification",
        title: "Identification from a frequency response",
        topic: "Harmonic excitation",
        summary: "Stiffness, mass and damping of one degree of freedom from a measured frequency response, real or complex, or from a few points of it.",
        main: &["natural_frequency", "damping_ratio", "mass", "stiffness"],
        keywords: "frf receptance sweep modal half-power bandwidth quality factor loss factor 3 dB peak suspension ensaio resposta em frequência \
                   suspensão identificação ressonância receptância \
                   mobility accelerance nyquist circle fit modal testing uff mobilidade acelerância ajuste de círculo 06/1 \
                   sharpness of resonance half-power points agudeza da ressonância meia potência",
        sources: &[&RAO, &EWINS, &LISTS],
        cases: include_str!("../../cases/frequency_response_identification.toml"),
    };

    fn solve<W: Worksheet>(
        &self,
        given: &FrequencyResponseIdentificationGiven<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let (system, measured) = match (&self.measurement, &given.measurement) {
            (Measurement::Table { points }, _) => {
                let points = points.iter().map(|point| (point.frequency, point.receptance)).collect();
                let points = points::ordered(points, sheet)?;
                (table::identify(&points, sheet)?, points)
            }
            (
                Measurement::Points {
                    static_receptance: at_rest,
                    peak_receptance: height,
                    peak_frequency: place,
                },
                MeasurementGiven::Points { static_receptance, peak_receptance, peak_frequency },
            ) => {
                let peak = Peak { receptance: *peak_receptance, frequency: *peak_frequency };
                let system = from_points(*static_receptance, peak, sheet)?;
                (system, vec![(0.0, *at_rest), (*place, *height)])
            }
            (Measurement::Complex { response, damping, residuals, lowest, highest }, _) => {
                let range = [*lowest, *highest];
                return complex::identify(response, *damping, *residuals, range, given.force, sheet);
            }
            (_, MeasurementGiven::HalfPower { lower_frequency, upper_frequency, natural_frequency }) => {
                return half_power::identify(*lower_frequency, *upper_frequency, *natural_frequency, sheet);
            }
            (measured, given) => return few_points::identify(measured, given, sheet),
        };
        let IdentifiedSystem { stiffness, mass, damping, damping_ratio, natural, peak } = system;
        sheet.answer("stiffness", "Stiffness", stiffness);
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("damping_ratio", "Damping ratio", damping_ratio);
        sheet.answer("mass", "Mass", mass);
        sheet.answer("damping", "Damping coefficient", damping);
        textbook(&system, sheet);
        resonance(given.force, &system, sheet);
        if damping_ratio.value() > 0.1 {
            sheet.warn(|| {
                Text::new(
                    "the damping ratio is above 0.1: the textbook method, peak frequency = natural frequency, is in error by more than 1 % in frequency and 2 % in mass",
                )
            });
        }
        let numbers = (stiffness.value(), mass.value(), damping.value());
        sheet.show(|| {
            Exhibit::Plot(plots::receptance(
                numbers,
                measured,
                (peak.frequency.value(), peak.receptance.value()),
            ))
        });
        sheet.show(|| {
            Exhibit::Drawing(oscillator::plots::mass_spring_damper(
                "F₀ cos(ω t)",
                ["m".into(), "k, ωₚ".into()],
            ))
        });
        Ok(())
    }
}

/// One degree of freedom, identified.
#[derive(Clone, Copy)]
struct IdentifiedSystem<N> {
    stiffness: N,
    mass: N,
    damping: N,
    damping_ratio: N,
    natural: N,
    peak: Peak<N>,
}

/// The peak of a receptance.
#[derive(Clone, Copy)]
struct Peak<N> {
    receptance: N,
    frequency: N,
}

/// The exact reading of static value and peak.
fn from_points<W: Worksheet>(
    static_receptance: W::Num,
    peak: Peak<W::Num>,
    sheet: W,
) -> Result<IdentifiedSystem<W::Num>, Refusal> {
    sheet.common_error("k", "the receptance at the peak taken as that of the spring alone", || {
        W::Num::from(1.0) / peak.receptance
    });
    let stiffness = sheet.step(
        "k",
        "N/m",
        sdof::stiffness_from_static_receptance(static_receptance),
        ("At rest only the spring balances the force: the receptance is 1/k", RAO.at("§3.4")),
    );
    let magnification = sheet.step(
        "Mₚ",
        "1",
        peak.receptance / static_receptance,
        ("Ratio of peak height to static value", RAO.at("§3.4")),
    );
    let damping_ratio = sdof::damping_ratio_from_peak(magnification).ok_or_else(|| {
        Refusal::because(
            "the peak is not above the static value, so there is no resonance: write the larger receptance as the peak",
        )
    })?;
    sheet.common_error("ζ", "the formula for light damping, ζ = 1/(2M), used", || {
        W::Num::from(0.5) / magnification
    });
    let damping_ratio = sheet.step(
        "ζ",
        "1",
        damping_ratio,
        ("The peak is 1/(2ζ√(1 − ζ²)), a quadratic equation in ζ²; its smaller root", RAO.at("§3.4")),
    );
    let at_peak = || peak.frequency;
    sheet.common_error("ωₙ", "the frequency of the peak taken as the natural frequency", at_peak);
    sheet.common_error("ωₙ", "the frequency of the peak taken as the damped natural frequency", || {
        sdof::natural_frequency_from_damped(peak.frequency, damping_ratio)
    });
    let natural = sheet.step(
        "ωₙ",
        "rad/s",
        sdof::natural_frequency_from_force_peak(peak.frequency, damping_ratio),
        ("The peak lies at ωₙ√(1 − 2ζ²), below the natural frequency", RAO.at("§3.4")),
    );
    let mass = sheet.step(
        "m",
        "kg",
        sdof::mass_from_natural_frequency(stiffness, natural),
        ("Mass that has this natural frequency", RAO.at("§2.2")),
    );
    let damping = sheet.step(
        "c",
        "N*s/m",
        sdof::damping_from_ratio(damping_ratio, stiffness, mass),
        ("Damping coefficient", RAO.at("§2.6")),
    );
    sheet.check(
        "mass from the parabola of 1/H² over ω² through static value and peak",
        (W::Num::from(1.0) / static_receptance.powi(2) - W::Num::from(1.0) / peak.receptance.powi(2)).sqrt()
            / peak.frequency.powi(2),
        mass,
    );
    sheet.check(
        "damping from mass, stiffness and peak",
        identification::damping_from_mass_and_peak(mass, stiffness, peak.receptance, peak.frequency),
        damping,
    );
    let system = IdentifiedSystem { stiffness, mass, damping, damping_ratio, natural, peak };
    hold_at_peak(&system, sheet);
    Ok(system)
}

/// Holds a system to the peak it was found from: the height, and the slope there.
fn hold_at_peak<W: Worksheet>(system: &IdentifiedSystem<W::Num>, sheet: W) {
    let IdentifiedSystem { stiffness, mass, damping, peak, .. } = *system;
    sheet.check(
        "stiffness, mass and damping reproduce the measured receptance at the peak",
        sdof::receptance(stiffness, mass, damping, peak.frequency),
        peak.receptance,
    );
    sheet.check(
        "the response curve has zero slope at the peak: k = m ωₚ² + c²/(2m)",
        mass * peak.frequency.powi(2) + damping.powi(2) / (mass * 2.0),
        stiffness,
    );
}

/// The reading of most textbooks, which takes the frequency of the peak as the natural one, beside the exact one.
fn textbook<W: Worksheet>(system: &IdentifiedSystem<W::Num>, sheet: W) {
    let peak = system.peak;
    let mass = sheet.step(
        "m′",
        "kg",
        sdof::mass_from_natural_frequency(system.stiffness, peak.frequency),
        ("Textbook approximation: the peak frequency taken as the natural frequency", RAO.at("§3.4")),
    );
    let damping = sheet.step(
        "c′",
        "N*s/m",
        sdof::damping_from_resonant_receptance(peak.receptance, peak.frequency),
        ("Textbook approximation: at resonance only the damper balances the force", RAO.at("§3.4")),
    );
    let mass_error = sheet.step(
        "Δm",
        "%",
        (mass - system.mass) / system.mass,
        "Error of the textbook estimate of the mass",
    );
    let damping_error = sheet.step(
        "Δc",
        "%",
        (damping - system.damping) / system.damping,
        "Error of the textbook estimate of the damping",
    );
    sheet.verify(|| {
        let one = W::Num::from(1.0);
        let squared = system.damping_ratio.powi(2);
        let level = one - squared * 2.0;
        sheet.check(
            "error of the textbook mass from the peak at ωₙ√(1 − 2ζ²): 2ζ²/(1 − 2ζ²)",
            mass_error,
            squared * 2.0 / level,
        );
        let ratio = ((one - squared) / level).sqrt();
        sheet.check(
            "error of the textbook damping from the peak at ωₙ√(1 − 2ζ²) and its height: √((1 − ζ²)/(1 − 2ζ²)) − 1",
            damping_error,
            squared / level / (ratio + 1.0),
        );
    });
    sheet.answer("textbook_mass", "Mass, peak taken as natural frequency", mass);
    sheet.answer("textbook_damping", "Damping, peak taken as natural frequency", damping);
    sheet.answer("textbook_mass_error", "Error of that mass", mass_error);
    sheet.answer("textbook_damping_error", "Error of that damping value", damping_error);
}

/// The amplitude at resonance: for each newton, and for the force where it is given.
fn resonance<W: Worksheet>(force: Option<W::Num>, system: &IdentifiedSystem<W::Num>, sheet: W) {
    let peak = system.peak;
    let for_each_newton = sheet.step(
        "X/F₀",
        "mm/N",
        peak.receptance,
        ("Maximum amplitude per newton of force", RAO.at("§3.4")),
    );
    sheet.answer("resonant_receptance", "Amplitude at resonance per unit force", for_each_newton);
    let Some(force) = force else { return };
    let largest = sheet.step(
        "Xₚ",
        "mm",
        peak.receptance * force,
        ("Maximum amplitude under this force", RAO.at("§3.4")),
    );
    let natural = sheet.step(
        "Xₙ",
        "mm",
        force / (system.damping * system.natural),
        ("Amplitude at the natural frequency, where only the damper balances the force", RAO.at("§3.4")),
    );
    sheet.check(
        "amplitude at the natural frequency from the static deflection over 2ζ",
        force / system.stiffness / (system.damping_ratio * 2.0),
        natural,
    );
    sheet.check(
        "maximum amplitude from the dynamic stiffness at the peak",
        sdof::forced_amplitude(force, system.stiffness, system.mass, system.damping, peak.frequency),
        largest,
    );
    sheet.answer("resonant_amplitude", "Maximum amplitude under the force", largest);
    sheet.answer("natural_amplitude", "Amplitude at the natural frequency", natural);
}

/// Comparison of the methods.
fn comparison(rows: Vec<(Text, [f64; 5])>) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let row = |(method, numbers): (Text, [f64; 5])| {
        std::iter::once(Cell::Text(method)).chain(numbers.map(Cell::Number)).collect()
    };
    TableExhibit {
        title: "Three methods of evaluating the response".into(),
        columns: vec![
            column("method", ""),
            column("stiffness", "N/m"),
            column("mass", "kg"),
            column("damping", "N*s/m"),
            column("damping ratio", "1"),
            column("natural frequency", "rad/s"),
        ],
        rows: rows.into_iter().map(row).collect(),
        foot: Vec::new(),
    }
}
