//! Damping and natural frequency from two or three measured numbers.

use dalembert_core::{Exhibit, Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, identification, sdof};

use super::{Measurement, MeasurementGiven, plots};
use crate::sources::RAO;

/// Frequency at which the resonance amplitude was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum PeakRead {
    /// At the natural frequency
    AtNatural,
    /// As the maximum of all amplitudes
    Largest,
}

/// Excitation of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum MachineExcitation {
    /// A force of constant amplitude
    Force,
    /// A rotating unbalance
    Unbalance,
}

/// The readings that need a few points only.
pub(super) fn identify<W: Worksheet>(
    measured: &Measurement,
    given: &MeasurementGiven<W>,
    sheet: W,
) -> Result<(), Refusal> {
    let (zeta, unbalance, points) = match (measured, given) {
        (_, MeasurementGiven::FreeAndForced { damped_frequency, peak_frequency }) => {
            let (zeta, natural) = free_and_forced(*damped_frequency, *peak_frequency, sheet)?;
            let ratio = peak_frequency.value() / natural.value();
            (zeta, false, vec![(ratio, sdof::magnification(ratio, zeta.value()))])
        }
        (
            Measurement::ResonanceAndFar { read, .. },
            MeasurementGiven::ResonanceAndFar { resonant_amplitude, far_amplitude, .. },
        ) => {
            let zeta = resonance_and_far(*resonant_amplitude, *far_amplitude, *read, sheet)?;
            let at = match read {
                PeakRead::AtNatural => 1.0,
                PeakRead::Largest => sdof::unbalance_peak_ratio(zeta.value()),
            };
            (zeta, true, vec![(at, resonant_amplitude.value() / far_amplitude.value())])
        }
        (
            _,
            MeasurementGiven::TwoSpeeds {
                far_amplitude,
                first_speed,
                first_amplitude,
                second_speed,
                second_amplitude,
            },
        ) => {
            let speeds = [*first_speed, *second_speed];
            let (zeta, natural) =
                two_speeds(*far_amplitude, speeds, [*first_amplitude, *second_amplitude], sheet)?;
            let point = |speed: W::Num, amplitude: W::Num| {
                (speed.value() / natural.value(), amplitude.value() / far_amplitude.value())
            };
            (zeta, true, vec![point(speeds[0], *first_amplitude), point(speeds[1], *second_amplitude)])
        }
        (
            Measurement::ResonanceRatio { excitation, .. },
            MeasurementGiven::ResonanceRatio { amplitude_ratio, frequency_ratio, .. },
        ) => {
            let zeta = resonance_ratio(*excitation, *amplitude_ratio, *frequency_ratio, sheet)?;
            let unbalance = *excitation == MachineExcitation::Unbalance;
            let height = 0.5 / zeta.value();
            let other = (frequency_ratio.value(), height / amplitude_ratio.value());
            (zeta, unbalance, vec![(1.0, height), other])
        }
        _ => unreachable!("tables, the static value and half-power frequencies are read elsewhere"),
    };
    show(zeta, unbalance, points, sheet);
    Ok(())
}

/// Warns of heavy damping and shows the curve of one degree of freedom with these points of it.
pub(super) fn show<W: Worksheet>(zeta: W::Num, unbalance: bool, points: Vec<(f64, f64)>, sheet: W) {
    if zeta.value() > 0.1 {
        sheet.warn(|| {
            Text::new(
                "the damping ratio is above 0.1: readings that take the peak frequency as the natural frequency are in error by more than 1 %",
            )
        });
    }
    let zeta = zeta.value();
    sheet.show(|| Exhibit::Plot(plots::magnification(zeta, unbalance, points)));
}

/// Answers damping ratio and quality factor.
pub(super) fn answer<W: Worksheet>(zeta: W::Num, sheet: W) {
    sheet.answer("damping_ratio", "Damping ratio", zeta);
    let quality = sheet.step("Q", "1", sdof::quality_factor(zeta), ("Quality factor", RAO.at("§3.4")));
    sheet.answer("quality_factor", "Quality factor", quality);
}

fn free_and_forced<W: Worksheet>(
    damped: W::Num,
    peak: W::Num,
    sheet: W,
) -> Result<(W::Num, W::Num), Refusal> {
    if peak.value() > damped.value() {
        return Err(Refusal::because(
            "the peak under a force lies above the frequency of the free vibration, which is impossible with any damping: exchange the two frequencies, or interpret the peak as that of an unbalance",
        ));
    }
    if peak.value() == damped.value() {
        return Err(Refusal::because(
            "the two frequencies are the same: there is no damping, or it is too light to be read from them",
        ));
    }
    let share = || W::Num::from(1.0) - (peak / damped).powi(2);
    sheet.common_error("ζ", "the frequency of the free vibration taken as the undamped one", || {
        (share() / 2.0).sqrt()
    });
    sheet.common_error(
        "ζ",
        "the peak taken as the damped natural frequency, the free vibration as the undamped one",
        || share().sqrt(),
    );
    let zeta = sheet.step(
        "ζ",
        "1",
        identification::damping_ratio_from_free_and_forced(damped, peak),
        (
            "Damping ratio: ω_d = ωₙ√(1 − ζ²) and ωₚ = ωₙ√(1 − 2ζ²), so that (ωₚ/ω_d)² = (1 − 2ζ²)/(1 − ζ²)",
            RAO.at("§3.4"),
        ),
    );
    let natural = sheet.step(
        "ωₙ",
        "Hz",
        sdof::natural_frequency_from_damped(damped, zeta),
        ("Natural frequency without damping", RAO.at("§2.6")),
    );
    sheet.check(
        "natural frequency from the forced peak",
        sdof::natural_frequency_from_force_peak(peak, zeta),
        natural,
    );
    answer(zeta, sheet);
    sheet.answer("natural_frequency", "Natural frequency", natural);
    if (damped.value() - peak.value()) / damped.value() < 5e-3 {
        sheet.warn(|| {
            Text::new(
                "the two frequencies differ by less than 0.5 %: the damping ratio follows from their difference, so that a small error in either changes it greatly",
            )
        });
    }
    Ok((zeta, natural))
}

fn resonance_and_far<W: Worksheet>(
    resonant: W::Num,
    far: W::Num,
    read: PeakRead,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let zeta = match read {
        PeakRead::AtNatural => {
            let zeta = sheet.step(
                "ζ",
                "1",
                identification::damping_ratio_from_resonance_and_far(resonant, far),
                ("At the natural frequency the amplitude is m₀e/(2ζm), far above it m₀e/m", RAO.at("§3.7")),
            );
            sheet.check(
                "the damping ratio reproduces the amplitude at the natural frequency",
                far * sdof::unbalance_magnification(W::Num::from(1.0), zeta),
                resonant,
            );
            zeta
        }
        PeakRead::Largest => {
            let peak = sheet.step(
                "Λₘₐₓ",
                "1",
                resonant / far,
                "Maximum amplitude as a multiple of that far above the resonance",
            );
            let zeta = sdof::damping_ratio_from_peak(peak).ok_or_else(|| {
                Refusal::because(
                    "the amplitude at resonance does not exceed that far above it, so there is no resonance: write the larger amplitude as that at resonance",
                )
            })?;
            let light = || W::Num::from(0.5) / peak;
            sheet.common_error("ζ", "the formula for light damping, ζ = 1/(2Λ), used", light);
            let zeta = sheet.step(
                "ζ",
                "1",
                zeta,
                ("The peak is 1/(2ζ√(1 − ζ²)), a quadratic equation in ζ²; its smaller root", RAO.at("§3.7")),
            );
            sheet.check(
                "substituting ζ reproduces the given peak amplitude",
                sdof::peak_magnification(zeta),
                peak,
            );
            zeta
        }
    };
    answer(zeta, sheet);
    Ok(zeta)
}

fn two_speeds<W: Worksheet>(
    far: W::Num,
    speeds: [W::Num; 2],
    amplitudes: [W::Num; 2],
    sheet: W,
) -> Result<(W::Num, W::Num), Refusal> {
    if speeds[0].value() == speeds[1].value() {
        return Err(Refusal::because("the two speeds are the same: measure at another one"));
    }
    let why = "Amplitude as a multiple of m₀e/m";
    let first = sheet.step("Λ₁", "1", amplitudes[0] / far, why);
    let second = sheet.step("Λ₂", "1", amplitudes[1] / far, why);
    let [s1, s2] = speeds.map(|speed| speed.value().powi(2));
    let [l1, l2] = [first, second].map(|magnification| magnification.value().powi(-2) - 1.0);
    if (s1 * l1 - s2 * l2) / (1.0 / s1 - 1.0 / s2) <= 0.0 {
        return Err(Refusal::because(
            "no natural frequency gives these amplitudes at these speeds: do amplitudes, speeds and m₀e/m belong to one mass on one spring?",
        ));
    }
    let natural = sheet.step(
        "ωₙ",
        "rpm",
        identification::natural_frequency_from_two_speeds(speeds, [first, second]),
        (
            "Natural frequency: at each speed ωₙ⁴ − 2ωₙ²ω² + 4ζ²ωₙ²ω² = ω⁴(1/Λ² − 1); subtracting the two leaves only ωₙ⁴",
            RAO.at("§3.7"),
        ),
    );
    let p = natural.value().powi(2);
    if 2.0 * p + s1 * l1 - p * p / s1 < 0.0 {
        return Err(Refusal::because(
            "these amplitudes are larger than any damping allows: do amplitudes, speeds and m₀e/m belong to one mass on one spring?",
        ));
    }
    sheet.common_error("ζ", "the first speed taken as that of resonance, ζ = 1/(2Λ₁)", || {
        W::Num::from(0.5) / first
    });
    let zeta = sheet.step(
        "ζ",
        "1",
        identification::damping_ratio_from_speed(natural, speeds[0], first),
        ("Damping ratio: the same equation at the first speed", RAO.at("§3.7")),
    );
    let scale = 1.0 + first.value().powi(-2) + (p / s1).powi(2);
    for (what, speed, magnification) in [
        ("the amplitude at the first speed", speeds[0], first),
        ("the amplitude at the second speed", speeds[1], second),
    ] {
        let r = speed / natural;
        let one = W::Num::from(1.0);
        // Without a division by what may be next to nothing at a resonance without damping.
        let left = (one - r.powi(2)).powi(2) + (zeta * r * 2.0).powi(2);
        sheet.check_zero(what, left - r.powi(4) / magnification.powi(2), scale * (1.0 + r.value().powi(4)));
    }
    answer(zeta, sheet);
    sheet.answer("natural_frequency", "Natural frequency", natural);
    Ok((zeta, natural))
}

fn resonance_ratio<W: Worksheet>(
    excitation: MachineExcitation,
    amplitude_ratio: W::Num,
    frequency_ratio: W::Num,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let (q, r) = (amplitude_ratio.value(), frequency_ratio.value());
    if r == 1.0 {
        return Err(Refusal::because(
            "both amplitudes are those at the natural frequency: measure one at another frequency",
        ));
    }
    let (least, zeta, why) = match excitation {
        MachineExcitation::Force => (
            r,
            identification::damping_ratio_from_force_ratio(amplitude_ratio, frequency_ratio),
            "Damping ratio, from q² = ((1 − r²)² + (2ζr)²)/(2ζ)²",
        ),
        MachineExcitation::Unbalance => (
            1.0 / r,
            identification::damping_ratio_from_unbalance_ratio(amplitude_ratio, frequency_ratio),
            "Damping ratio, from q² = ((1 − r²)² + (2ζr)²)/(2ζr²)²",
        ),
    };
    if q <= least {
        let why = Text::new("no damping gives an amplitude ratio as small as this: it must be above {least}");
        return Err(Refusal::because(why.with_quantity("least", least, "1")));
    }
    let undamped = || {
        let detuned = (W::Num::from(1.0) - frequency_ratio.powi(2)).abs() / (amplitude_ratio * 2.0);
        match excitation {
            MachineExcitation::Force => detuned,
            MachineExcitation::Unbalance => detuned / frequency_ratio.powi(2),
        }
    };
    sheet.common_error("ζ", "the damping neglected at the other frequency", undamped);
    sheet.common_error("ζ", "the ratio of the amplitudes taken as the magnification at resonance", || {
        W::Num::from(0.5) / amplitude_ratio
    });
    let zeta = sheet.step("ζ", "1", zeta, (why, RAO.at("§3.4")));
    let one = W::Num::from(1.0);
    let ratio = match excitation {
        MachineExcitation::Force => {
            sdof::magnification(one, zeta) / sdof::magnification(frequency_ratio, zeta)
        }
        MachineExcitation::Unbalance => {
            sdof::unbalance_magnification(one, zeta) / sdof::unbalance_magnification(frequency_ratio, zeta)
        }
    };
    sheet.check("the damping ratio reproduces the amplitude ratio", ratio, amplitude_ratio);
    answer(zeta, sheet);
    Ok(zeta)
}
