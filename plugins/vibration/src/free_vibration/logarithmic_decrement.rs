//! Logarithmic decrement: what successive amplitudes of a decay, the decrement and the damping ratio say of each
//! other and of the system.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof, section as area, spring};

mod drawing;
mod fit;

use crate::{
    shared::{
        continuous::{ShearModulus, shear_modulus},
        decay::{Decay, damped_frequency_error, decrement, ratio_errors},
        inertia::{Inertia, TranslatingBody, moment_of_inertia},
        oscillator::{
            SpringData, frequency_of,
            parts::{OscillatingBody, TorsionalElasticity},
            stiffness_of,
        },
    },
    sources::{GROVER, RAO},
};

/// Inputs: the decay, the system, and an amplitude ratio of interest.
#[derive(Clone, Debug, Inputs)]
pub struct LogarithmicDecrement {
    /// Decay.
    pub decay: DecayInput,
    /// System.
    pub system: SystemData,
    /// Amplitude ratio for which cycles and time are computed.
    /// The larger amplitude over the smaller one.
    #[input("X₁/X₂", "1", above = 1)]
    pub fall: Option<f64>,
}

/// Given quantity of the decay.
#[derive(Clone, Debug, Inputs)]
pub enum DecayInput {
    /// Two amplitudes
    Amplitudes {
        /// Amplitudes.
        amplitudes: Decay,
    },
    /// Logarithmic decrement given
    Decrement {
        /// Logarithmic decrement.
        #[input("δ", "1", nonnegative)]
        decrement: f64,
    },
    /// Damping ratio given
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// Table of amplitudes
    Peaks {
        /// Amplitudes.
        /// At least three; some cycles may be skipped, and a trough is half a cycle from its peak.
        #[input(table)]
        peaks: Vec<MeasuredPeak>,
    },
}

/// A measured amplitude.
#[derive(Clone, Debug, Inputs)]
pub struct MeasuredPeak {
    /// Cycles since the first amplitude.
    #[input("n", "1")]
    pub cycles: f64,
    /// Amplitude.
    /// In any unit, the same for all, without sign.
    #[input("X", "1", positive)]
    pub amplitude: f64,
}

/// Given quantities of the system.
#[derive(Clone, Debug, Inputs)]
pub enum SystemData {
    /// No further data
    Unknown,
    /// Period of the decaying motion
    Period {
        /// Period.
        #[input("T_d", "s", positive)]
        period: f64,
    },
    /// Mass and stiffness
    MassStiffness {
        /// Mass or weight.
        mass: TranslatingBody,
        /// Springs.
        stiffness: SpringData,
        /// Measured period, for comparison.
        #[input("T_m", "s", positive)]
        period: Option<f64>,
    },
    /// Mass or inertia, and period
    MassPeriod {
        /// Mass or moment of inertia.
        mass: OscillatingBody,
        /// Period.
        #[input("T_d", "s", positive)]
        period: f64,
    },
    /// Stiffness and period
    StiffnessPeriod {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
        /// Period.
        #[input("T_d", "s", positive)]
        period: f64,
    },
    /// Inertia and torsional stiffness
    Torsion {
        /// Moment of inertia.
        inertia: Inertia,
        /// Torsional springs.
        stiffness: TorsionalElasticity,
    },
    /// Inertia on a round shaft
    Shaft {
        /// Moment of inertia.
        #[input("J", "kg*m^2", positive)]
        inertia: f64,
        /// Shear modulus.
        shear: ShearModulus,
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Diameter.
        #[input("d", "m", positive)]
        diameter: f64,
    },
}

register!(LogarithmicDecrement);

impl Analysis for LogarithmicDecrement {
    const ABOUT: About = About {
        id: "vibration/logarithmic-decrement",
        title: "Logarithmic decrement",
        topic: "Free vibration",
        summary: "Decrement, damping ratio and damping of a decay from its amplitudes, and the cycles and time to decay to a given amplitude.",
        main: &["damping_ratio", "decrement", "damping"],
        keywords: "log decrement decay damping ratio successive amplitudes peaks torsional pendulum cycles least squares \
                   decremento logarítmico decaimento amplitude picos pêndulo de torção",
        sources: &[&RAO, &GROVER],
        cases: include_str!("../../cases/logarithmic_decrement.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &LogarithmicDecrementGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (decrement, zeta) = self.decay(given, sheet)?;
        sheet.answer("decrement", "Logarithmic decrement", decrement);
        sheet.answer("damping_ratio", "Damping ratio", zeta);
        light(decrement, zeta, sheet);
        if decrement.value() == 0.0 {
            sheet.warn(|| {
                Text::new("the motion does not decay: there is no damping, and no smaller amplitude is ever reached")
            });
        } else {
            let kept = sheet.step(
                "x₁/x₂",
                "1",
                decrement.exp(),
                ("Ratio of successive amplitudes", RAO.at("§2.6.3")),
            );
            sheet.common_error("ψ", "twice the decrement taken, as for light damping", || decrement * 2.0);
            let first_loss = || W::Num::from(1.0) - (-decrement).exp();
            sheet.common_error("ψ", "the loss of amplitude taken for that of energy", first_loss);
            let lost = sheet.step(
                "ψ",
                "%",
                W::Num::from(1.0) - (-(decrement * 2.0)).exp(),
                (
                    "Fraction of the energy lost per cycle: the energy is proportional to the square of the amplitude",
                    RAO.at("§2.6.4"),
                ),
            );
            let two = sheet.step(
                "ρ",
                "1",
                W::Num::from(2.0),
                "Half the amplitude: the ratio of the amplitudes is 2",
            );
            let linear = || W::Num::from(0.5) / first_loss();
            sheet.common_error("n½", "the loss of the first cycle assumed in every cycle", linear);
            let half = sheet.step("n½", "1", two.ln() / decrement, "Cycles to half amplitude");
            sheet.verify(|| {
                let root = (W::Num::from(1.0) - zeta.powi(2)).sqrt();
                let fallen = |cycles: W::Num| (zeta * cycles * 2.0 * PI / root).exp();
                sheet.check(
                    "ratio of successive amplitudes from the envelope e^(−ζωₙt) over a period",
                    fallen(W::Num::from(1.0)),
                    kept,
                );
                sheet.check(
                    "energies before and after a cycle, as the squares of the amplitudes",
                    W::Num::from(1.0) - kept.powi(-2),
                    lost,
                );
                sheet.check(
                    "after these cycles the envelope e^(−ζωₙt) has decayed to one half",
                    fallen(half),
                    two,
                );
            });
            sheet.answer("amplitude_ratio", "Ratio of successive amplitudes", kept);
            sheet.answer("energy_loss", "Energy lost per cycle", lost);
            sheet.answer("half_cycles", "Cycles to half amplitude", half);
        }
        let period = system(given, zeta, sheet)?;
        if let Some(fall) = given.fall
            && decrement.value() > 0.0
        {
            let one = W::Num::from(1.0);
            let linear = || (one - one / fall) / (one - (-decrement).exp());
            sheet.common_error("n", "the loss of the first cycle assumed in every cycle", linear);
            let decimal = || fall.log10() / decrement;
            sheet.common_error("n", "the logarithm to base 10 used in place of the natural one", decimal);
            let cycles = sheet.step(
                "n",
                "1",
                fall.ln() / decrement,
                ("Cycles for the amplitude to decay by that ratio", RAO.at("§2.6.3")),
            );
            sheet.answer("fall_cycles", "Cycles of that decay", cycles);
            if let Some(Oscillation { period, natural }) = period {
                let undamped = || cycles * 2.0 * PI / natural;
                sheet.common_error("t", "the period without damping used", undamped);
                let time = sheet.step("t", "s", cycles * period, "Duration of these cycles");
                sheet.check("the same time from the envelope e^(−ζωₙt)", fall.ln() / (zeta * natural), time);
                sheet.answer("fall_time", "Duration of that decay", time);
            }
        }
        let numbers = (decrement.value(), self.fall);
        sheet.show(|| Exhibit::Plot(self.decay_plot(numbers)));
        sheet.show(|| Exhibit::Drawing(self.system.drawing()));
        Ok(())
    }
}

/// Frequencies of the oscillation.
struct Oscillation<N> {
    period: N,
    natural: N,
}

impl LogarithmicDecrement {
    /// Decrement and damping ratio from what is known.
    fn decay<W: Worksheet>(
        &self,
        given: &LogarithmicDecrementGiven<W>,
        sheet: W,
    ) -> Result<(W::Num, W::Num), Refusal> {
        match (&self.decay, &given.decay) {
            (DecayInput::Peaks { peaks }, _) => {
                let decrement = fit::least_squares(peaks, sheet)?;
                Ok((decrement, ratio_of(decrement, sheet)))
            }
            (_, DecayInputGiven::Amplitudes { amplitudes }) => {
                let found = decrement(amplitudes, sheet);
                Ok((found.decrement, found.damping_ratio))
            }
            (_, DecayInputGiven::Decrement { decrement }) => Ok((*decrement, ratio_of(*decrement, sheet))),
            (_, DecayInputGiven::Ratio { ratio }) => {
                if ratio.value() >= 1.0 {
                    return Err(Refusal::because(
                        "with a damping ratio of 1 or more the motion does not oscillate and has no decrement: \
                         write a ratio below 1",
                    ));
                }
                let light = || *ratio * 2.0 * PI;
                sheet.common_error("δ", "2π times the damping ratio taken, as for light damping", light);
                let decrement = sheet.step(
                    "δ",
                    "1",
                    sdof::decrement_from_damping_ratio(*ratio),
                    ("Logarithmic decrement", RAO.at("§2.6.3")),
                );
                sheet.check(
                    "the decrement reproduces the damping ratio",
                    sdof::damping_ratio_from_decrement(decrement),
                    *ratio,
                );
                Ok((decrement, *ratio))
            }
            (_, DecayInputGiven::Peaks { .. }) => unreachable!("what is given is made from what is known"),
        }
    }

    /// The decay over its cycles, with what was measured.
    fn decay_plot(&self, (decrement, fall): (f64, Option<f64>)) -> Plot {
        let measured: Vec<(f64, f64)> = match &self.decay {
            DecayInput::Peaks { peaks } => peaks.iter().map(|peak| (peak.cycles, peak.amplitude)).collect(),
            _ => Vec::new(),
        };
        let fallen = fall.filter(|_| decrement > 0.0).map(|fall| fall.ln() / decrement);
        let usual = if decrement > 0.0 { (3.0 / decrement).clamp(2.0, 12.0) } else { 6.0 };
        let last = measured.iter().fold(usual, |last, peak| last.max(peak.0));
        let last = fallen.map_or(last, |n| if n < 40.0 { last.max(1.1 * n) } else { last });
        // Without measured amplitudes the first is 1.
        let first = initial_of(&measured, decrement);
        let cycles = |n: u16| last * f64::from(n) / 480.0;
        let motion = |n: u16| {
            let cycle = cycles(n);
            (cycle, first * (-decrement * cycle).exp() * (std::f64::consts::TAU * cycle).cos())
        };
        let envelope = |n: u16| (cycles(n), first * (-decrement * cycles(n)).exp());
        let mut series = vec![Series::line("envelope", (0..=480).map(envelope).collect())];
        if last <= 40.0 {
            series.insert(0, Series::line("motion", (0..=480).map(motion).collect()));
        }
        if !measured.is_empty() {
            series.push(Series::dots("measured", measured));
        }
        let mut plot = Plot::new(
            "Decay over the cycles",
            Axis::linear("cycles", "1"),
            Axis::linear("amplitude", "1"),
            series,
        );
        if let (Some(n), Some(fall)) = (fallen, fall)
            && n <= last
        {
            plot = plot.mark("requested amplitude", (n, first / fall));
        }
        plot
    }
}

/// Mass, stiffness, damping and frequencies, as far as the system is known.
fn system<W: Worksheet>(
    given: &LogarithmicDecrementGiven<W>,
    zeta: W::Num,
    sheet: W,
) -> Result<Option<Oscillation<W::Num>>, Refusal> {
    Ok(match &given.system {
        SystemDataGiven::Unknown {} => None,
        SystemDataGiven::Period { period } => {
            let natural = natural_of_period(*period, zeta, "ωₙ", sheet);
            sheet.answer("natural_frequency", "Natural frequency", natural);
            Some(Oscillation { period: *period, natural })
        }
        SystemDataGiven::MassStiffness { mass: body, stiffness, period } => {
            let body = body.on_springs(stiffness, sheet)?;
            let oscillation = elastic(body, zeta, LINE, sheet);
            if let Some(measured) = period {
                let natural = natural_of_period(*measured, zeta, "ωₙ′", sheet);
                let off = sheet.step(
                    "Δω",
                    "%",
                    (natural - oscillation.natural) / oscillation.natural,
                    "Deviation of the measured period from that of mass and stiffness",
                );
                sheet.check(
                    "measured frequency, with the same relative error as the period",
                    oscillation.period / *measured - 1.0,
                    off,
                );
                sheet.answer(
                    "measured_natural_frequency",
                    "Natural frequency from the measured period",
                    natural,
                );
                sheet.answer("frequency_difference", "Deviation of the measured frequency", off);
                if off.value().abs() > 0.02 {
                    sheet.warn(|| {
                        Text::new("the measured period differs from that of mass and stiffness by {off}: is the whole mass included?")
                            .with_quantity("off", off.value(), "%")
                    });
                }
            }
            Some(oscillation)
        }
        SystemDataGiven::MassPeriod { mass: body, period } => {
            let mass = body.inertia(sheet)?;
            let motion = body.motion();
            let natural = natural_of_period(*period, zeta, "ωₙ", sheet);
            let stiffness = stiffness_of(motion, mass, natural, sheet);
            sheet.answer("stiffness", motion.of("Stiffness", "Torsional stiffness"), stiffness);
            sheet.answer("natural_frequency", "Natural frequency", natural);
            coefficients([mass, stiffness, zeta, *period], motion.of(LINE, AXIS), sheet);
            Some(Oscillation { period: *period, natural })
        }
        SystemDataGiven::StiffnessPeriod { stiffness, period } => {
            let natural = natural_of_period(*period, zeta, "ωₙ", sheet);
            let mass = sheet.step(
                "m",
                "kg",
                sdof::mass_from_natural_frequency(*stiffness, natural),
                ("Mass that has this natural frequency", RAO.at("§2.2")),
            );
            sheet.answer("mass", "Mass", mass);
            sheet.answer("natural_frequency", "Natural frequency", natural);
            coefficients([mass, *stiffness, zeta, *period], LINE, sheet);
            Some(Oscillation { period: *period, natural })
        }
        SystemDataGiven::Torsion { inertia, stiffness } => {
            let inertia = moment_of_inertia(inertia, sheet, "J".into());
            let [natural, stiffness] = stiffness.frequency_and_stiffness(inertia, sheet)?;
            Some(elastic([inertia, natural, stiffness], zeta, AXIS, sheet))
        }
        SystemDataGiven::Shaft { inertia, shear, length, diameter } => {
            let shear = shear_modulus(shear, sheet, "G");
            let bending = || area::round_second_moment(*diameter);
            sheet.common_error("I_p", "the second moment of area for bending used in torsion", bending);
            let polar = sheet.step(
                "I_p",
                "cm^4",
                area::round_polar_moment(*diameter),
                "Polar second moment of area of a round section",
            );
            let stiffness = sheet.step(
                "kₜ",
                "N*m/rad",
                spring::torsional(shear, polar, *length),
                ("Torsional stiffness of the shaft", RAO.at("§1.7")),
            );
            sheet.verify(|| {
                sheet.check(
                    "torsional stiffness from the shear strain at the rim, 16T/(πGd³), over the radius",
                    shear * diameter.powi(3) * PI / 16.0 * *diameter / 2.0 / *length,
                    stiffness,
                );
            });
            sheet.answer("stiffness", "Torsional stiffness", stiffness);
            let natural = frequency_of(stiffness, *inertia, sheet);
            Some(elastic([*inertia, natural, stiffness], zeta, AXIS, sheet))
        }
    })
}

/// The first amplitude that the least squares give to measured ones.
fn initial_of(measured: &[(f64, f64)], decrement: f64) -> f64 {
    if measured.is_empty() {
        return 1.0;
    }
    let logs = measured.iter().map(|(n, x)| x.ln() + decrement * n);
    (logs.sum::<f64>() / measured.len() as f64).exp()
}

/// The small-damping readings beside the exact ones.
fn light<W: Worksheet>(decrement: W::Num, zeta: W::Num, sheet: W) {
    let light = sheet.step(
        "ζ′",
        "1",
        decrement / (2.0 * PI),
        ("For light damping: δ = 2πζ, since √(1 − ζ²) is nearly 1", RAO.at("§2.6.3")),
    );
    sheet.answer("light_damping_ratio", "Damping ratio, light-damping formula", light);
    if zeta.value() > 0.0 {
        let error = sheet.step("Δζ", "%", (light - zeta) / zeta, "Relative error of that formula");
        sheet.verify(|| {
            let root = (W::Num::from(1.0) - zeta.powi(2)).sqrt();
            sheet.check(
                "error of the light-damping formula from the neglected square root, 1/√(1 − ζ²) − 1",
                zeta.powi(2) / (root * (root + 1.0)),
                error,
            );
        });
        sheet.answer("light_error", "Error of that formula", error);
        if error.value() > 0.02 {
            sheet.warn(|| {
                Text::new("the light-damping formula ζ = δ/2π is in error by {error} here: use the exact one")
                    .with_quantity("error", error.value(), "%")
            });
        }
    }
}

fn ratio_of<W: Worksheet>(decrement: W::Num, sheet: W) -> W::Num {
    ratio_errors("ζ", decrement, sheet);
    let zeta = sheet.step(
        "ζ",
        "1",
        sdof::damping_ratio_from_decrement(decrement),
        ("Damping ratio from that decrement", RAO.at("§2.6.3")),
    );
    sheet.check(
        "the damping ratio reproduces the decrement",
        sdof::decrement_from_damping_ratio(zeta),
        decrement,
    );
    zeta
}

/// The units of a motion along a line or about an axis.
#[derive(Clone, Copy)]
struct Kind {
    symbol: &'static str,
    unit: &'static str,
}

const LINE: Kind = Kind { symbol: "c", unit: "N*s/m" };
const AXIS: Kind = Kind { symbol: "cₜ", unit: "N*m*s/rad" };

/// Frequencies, period and damping of a mass and a stiffness (or an inertia and a torsional stiffness).
fn elastic<W: Worksheet>(
    [mass, natural, stiffness]: [W::Num; 3],
    zeta: W::Num,
    kind: Kind,
    sheet: W,
) -> Oscillation<W::Num> {
    damped_frequency_error("ω_d", natural, zeta, sheet);
    let damped = sheet.step(
        "ω_d",
        "rad/s",
        sdof::damped_frequency(natural, zeta),
        ("Frequency of the decaying motion", RAO.at("§2.6")),
    );
    let period = sheet.step("T_d", "s", W::Num::from(2.0) * PI / damped, "Period of the decaying motion");
    sheet.answer("natural_frequency", "Natural frequency", natural);
    sheet.answer("damped_frequency", "Damped natural frequency", damped);
    sheet.answer("period", "Period", period);
    coefficients([mass, stiffness, zeta, period], kind, sheet);
    Oscillation { period, natural }
}

fn natural_of_period<W: Worksheet>(period: W::Num, zeta: W::Num, symbol: &'static str, sheet: W) -> W::Num {
    let damped_symbol = if symbol == "ωₙ" { "ω_d" } else { "ω_d′" };
    let damped = sheet.step(
        damped_symbol,
        "rad/s",
        sdof::angular_frequency(period),
        ("Frequency of the decaying motion", RAO.at("§2.6")),
    );
    let what = "the frequency of the decaying motion taken as the natural frequency";
    sheet.common_error(symbol, what, || damped);
    let natural = sheet.step(
        symbol,
        "rad/s",
        sdof::natural_frequency_from_damped(damped, zeta),
        ("Natural frequency without damping, above that of the decay", RAO.at("§2.6")),
    );
    sheet.check(
        "the root −ζωₙ + iω_d of the decay has modulus ωₙ",
        (zeta * natural).powi(2) + damped.powi(2),
        natural.powi(2),
    );
    natural
}

fn coefficients<W: Worksheet>([mass, stiffness, zeta, period]: [W::Num; 4], kind: Kind, sheet: W) {
    let critical = sheet.step(
        "c_c",
        kind.unit,
        sdof::critical_damping(stiffness, mass),
        ("Critical damping", RAO.at("§2.6")),
    );
    let decrement = || sdof::decrement_from_damping_ratio(zeta) * critical;
    sheet.common_error(kind.symbol, "the decrement used in place of the damping ratio", decrement);
    let damping =
        sheet.step(kind.symbol, kind.unit, zeta * critical, ("Damping coefficient", RAO.at("§2.6")));
    sheet.check(
        "damping ratio from damping, stiffness and mass",
        sdof::damping_ratio(damping, stiffness, mass),
        zeta,
    );
    sheet.verify(|| {
        let damped = W::Num::from(2.0) * PI / period;
        sheet.check(
            "period from mass, stiffness and damping, ω_d² + (c/2m)² = k/m",
            damped.powi(2) + (damping / (mass * 2.0)).powi(2),
            stiffness / mass,
        );
    });
    sheet.answer("critical_damping", "Critical damping", critical);
    sheet.answer("damping", "Damping coefficient", damping);
}
