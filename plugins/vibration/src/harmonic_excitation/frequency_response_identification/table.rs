//! Three readings of a measured response: least squares, peak, half-power points.

use dalembert_core::{Exhibit, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    identification::{self, FitError, MeasuredPeak},
    sdof,
};

use super::{IdentifiedSystem, Peak, comparison, hold_at_peak};
use crate::sources::{EWINS, RAO};

/// The fewest points that a least-squares fit is worth the name with.
const FEWEST: usize = 5;

/// The system of the least squares over all points, beside the other readings.
pub(super) fn identify<W: Worksheet>(
    points: &[(f64, f64)],
    sheet: W,
) -> Result<IdentifiedSystem<W::Num>, Refusal> {
    if points.len() < FEWEST {
        return Err(Refusal::because("the table has fewer than five points: measure more frequencies"));
    }
    let measured = identification::measured_peak(points).ok_or_else(|| {
        Refusal::because(
            "the largest receptance is the first or the last of the table, so the peak was not measured: continue the measurement beyond it",
        )
    })?;

    let system = least_squares(points, sheet)?;
    let by_peak = from_peak(points[0], &measured, sheet);
    let mut rows = vec![("least squares", system), ("peak and lowest frequency", by_peak)];
    match measured.half_power {
        [Some(lower), Some(upper)] => {
            rows.push(("peak and half-power points", from_half_power(lower, upper, &measured, sheet)));
        }
        _ => sheet.warn(|| {
            Text::new(
                "the table does not reach down to 1/√2 of the peak on both sides: there is no half-power reading",
            )
        }),
    }
    spread(&rows, sheet);
    sheet.show(|| {
        let numbers = |system: &IdentifiedSystem<W::Num>| {
            [system.stiffness, system.mass, system.damping, system.damping_ratio, system.natural]
                .map(Real::value)
        };
        let row = |(method, system): &(&'static str, IdentifiedSystem<W::Num>)| {
            (Text::new(*method), numbers(system))
        };
        Exhibit::Table(comparison(rows.iter().map(row).collect()))
    });
    Ok(system)
}

/// Least squares of `1/H²` over all points.
fn least_squares<W: Worksheet>(points: &[(f64, f64)], sheet: W) -> Result<IdentifiedSystem<W::Num>, Refusal> {
    let fit = identification::fit_receptance(points).map_err(|err| match err {
        FitError::NegativeDamping => Refusal::because(
            "the points are higher than any damping allows: do they belong to one mass on one spring?",
        ),
        _ => Refusal::because(
            "no stiffness and mass fit these points: do they belong to one mass on one spring?",
        ),
    })?;
    if fit.damping == 0.0 {
        return Err(Refusal::because(
            "the least-squares fit finds no damping: measure more points about the peak",
        ));
    }
    let stiffness = sheet.numerical(
        "k",
        "N/m",
        fit.stiffness,
        (
            "Stiffness by least squares over all points: 1/H² = (k − m ω²)² + (c ω)² is linear in k², c² − 2km and m²",
            EWINS.at("§4.3"),
        ),
    );
    let mass = sheet.numerical("m", "kg", fit.mass, "Mass by the same least squares");
    let damping = sheet.numerical("c", "N*s/m", fit.damping, "Damping by the same least squares");
    sheet.check_zeros("the least-squares solution satisfies its normal equations", fit.normal_equations, 1.0);
    let misfit = sheet.numerical(
        "ε",
        "%",
        fit.misfit / 2.0,
        "Root mean square of the relative differences between the fitted receptance and the measured one",
    );
    sheet.verify(|| {
        let (k, m, c) = (stiffness.value(), mass.value(), damping.value());
        let differences = points.iter().map(|&(frequency, receptance)| {
            let elastic = k - m * frequency.powi(2);
            (elastic.powi(2) + (c * frequency).powi(2)) * receptance.powi(2) - 1.0
        });
        let (sum, size) = differences.fold((0.0, 0.0), |(sum, size), off| (sum + off, size + off.abs()));
        let squares = 4.0 * points.len() as f64 * misfit.value().powi(2);
        sheet.check_residual(
            "scatter: the relative residuals of 1/H² are orthogonal to the fit, so that Σd² = −Σd",
            (squares + sum).into(),
            size,
            16.0 * f64::EPSILON * points.len() as f64,
        );
    });
    sheet.answer("misfit", "Fit residual of the points", misfit);
    if fit.misfit > 0.1 {
        sheet.warn(|| {
            Text::new("the points scatter by more than 5 % about the fit: noise, or more than one mode in this range")
        });
    }
    let (natural, damping_ratio) = ratios(stiffness, mass, damping, ["ωₙ", "ζ"], sheet);
    let peak = fitted_peak(stiffness, natural, damping_ratio, sheet)?;
    let system = IdentifiedSystem { stiffness, mass, damping, damping_ratio, natural, peak };
    hold_at_peak(&system, sheet);
    Ok(system)
}

/// Natural frequency and damping ratio of a reading.
fn ratios<W: Worksheet>(
    stiffness: W::Num,
    mass: W::Num,
    damping: W::Num,
    [natural, ratio]: [&'static str; 2],
    sheet: W,
) -> (W::Num, W::Num) {
    let natural = sheet.step(
        natural,
        "rad/s",
        sdof::natural_frequency(stiffness, mass),
        ("Natural frequency without damping", RAO.at("§2.2")),
    );
    let damping_ratio = sheet.step(
        ratio,
        "1",
        sdof::damping_ratio(damping, stiffness, mass),
        ("Damping ratio: damping over critical damping", RAO.at("§2.6")),
    );
    (natural, damping_ratio)
}

/// The peak of the fitted response.
fn fitted_peak<W: Worksheet>(
    stiffness: W::Num,
    natural: W::Num,
    damping_ratio: W::Num,
    sheet: W,
) -> Result<Peak<W::Num>, Refusal> {
    if damping_ratio.value() >= std::f64::consts::FRAC_1_SQRT_2 {
        return Err(Refusal::because("the fitted damping is so strong that the response has no peak"));
    }
    let frequency = sheet.step(
        "ωₚ",
        "rad/s",
        natural * sdof::magnification_peak_ratio(damping_ratio),
        ("Peak of the fitted response", RAO.at("§3.4")),
    );
    let receptance = sheet.step(
        "Hₚ",
        "mm/N",
        sdof::peak_magnification(damping_ratio) / stiffness,
        ("Its height", RAO.at("§3.4")),
    );
    sheet.answer("peak_frequency", "Frequency of the peak", frequency);
    Ok(Peak { receptance, frequency })
}

/// The reading of the peak and the point of lowest frequency.
pub(super) fn from_peak<W: Worksheet>(
    lowest: (f64, f64),
    measured: &MeasuredPeak,
    sheet: W,
) -> IdentifiedSystem<W::Num> {
    let frequency = sheet.numerical(
        "ωₕ",
        "rad/s",
        measured.frequency,
        "The measured peak: vertex of the parabola of 1/H² over ω² through the highest point and its neighbours",
    );
    let receptance = sheet.numerical("Hₕ", "mm/N", measured.receptance, "Height of the measured peak");
    let first = sheet.numerical("ω₀", "rad/s", lowest.0, "Lowest frequency of the table");
    let at_first = sheet.numerical("H₀", "mm/N", lowest.1, "Receptance at this point");
    let mass = sheet.step(
        "mₕ",
        "kg",
        identification::mass_from_peak_and_point(receptance, frequency, at_first, first),
        "Mass from peak and lowest frequency: 1/H² = 1/Hₕ² + m²(ω² − ωₕ²)² at every frequency",
    );
    let system = from_mass(mass, receptance, frequency, ["kₕ", "cₕ", "ωₙₕ", "ζₕ"], sheet);
    sheet.check(
        "mass, stiffness and damping reproduce the measured receptance at the lowest frequency",
        sdof::receptance(system.stiffness, system.mass, system.damping, first),
        at_first,
    );
    system
}

/// The reading of the half-power points.
pub(super) fn from_half_power<W: Worksheet>(
    lower: f64,
    upper: f64,
    measured: &MeasuredPeak,
    sheet: W,
) -> IdentifiedSystem<W::Num> {
    let below = "Half-power frequency below the peak: the receptance is 1/√2 of the peak value";
    let lower = sheet.numerical("ω₁", "rad/s", lower, (below, RAO.at("§3.4")));
    let upper = sheet.numerical("ω₂", "rad/s", upper, "Half-power frequency above the peak");
    let receptance = sheet.numerical("H_b", "mm/N", measured.receptance, "Height of the measured peak");
    let mass = sheet.step(
        "m_b",
        "kg",
        identification::mass_from_half_power(receptance, lower, upper),
        "Mass from the half-power frequencies: there m²(ω² − ω_b²)² = 1/H_b²",
    );
    let frequency = sheet.step(
        "ω_b",
        "rad/s",
        identification::peak_between_half_power(lower, upper),
        "Frequency of the peak between them",
    );
    let system = from_mass(mass, receptance, frequency, ["k_b", "c_b", "ωₙ_b", "ζ_b"], sheet);
    sheet.check(
        "damping ratio from the half-power frequencies alone",
        sdof::damping_ratio_from_half_power(lower, upper),
        system.damping_ratio,
    );
    let light = sheet.step(
        "ζ′",
        "1",
        sdof::damping_ratio_from_bandwidth(lower, upper, frequency),
        ("Textbook approximation of the bandwidth, for light damping", RAO.at("§3.4")),
    );
    let [below, above] = [
        sdof::lower_half_power_ratio(system.damping_ratio),
        sdof::upper_half_power_ratio(system.damping_ratio),
    ];
    if below.value().is_finite() && above.value().is_finite() {
        sheet.check(
            "bandwidth of a mode with that damping ratio, from its half-power frequencies in closed form",
            (above - below) * system.natural / (frequency * 2.0),
            light,
        );
    }
    sheet.answer("half_power_damping_ratio", "Damping ratio, half-power points", system.damping_ratio);
    sheet.answer("bandwidth_damping_ratio", "Damping ratio, bandwidth over twice the peak frequency", light);
    system
}

/// The rest of a reading that gave the mass.
fn from_mass<W: Worksheet>(
    mass: W::Num,
    receptance: W::Num,
    frequency: W::Num,
    [k, c, natural, ratio]: [&'static str; 4],
    sheet: W,
) -> IdentifiedSystem<W::Num> {
    let stiffness = sheet.step(
        k,
        "N/m",
        identification::stiffness_from_mass_and_peak(mass, receptance, frequency),
        "Stiffness: the same parabola at ω = 0, where 1/H² = k²",
    );
    let damping = sheet.step(
        c,
        "N*s/m",
        identification::damping_from_mass_and_peak(mass, stiffness, receptance, frequency),
        "Damping: the response has zero slope at the peak, c² = 2m(k − m ω²)",
    );
    let (natural, damping_ratio) = ratios(stiffness, mass, damping, [natural, ratio], sheet);
    let peak = Peak { receptance, frequency };
    let system = IdentifiedSystem { stiffness, mass, damping, damping_ratio, natural, peak };
    hold_at_peak(&system, sheet);
    system
}

/// Difference between the damping ratio readings.
fn spread<W: Worksheet>(rows: &[(&'static str, IdentifiedSystem<W::Num>)], sheet: W) {
    let by_size = |a: &W::Num, b: &W::Num| a.value().total_cmp(&b.value());
    let ratios = || rows.iter().map(|(_, system)| system.damping_ratio);
    let (Some(least), Some(most)) = (ratios().min_by(by_size), ratios().max_by(by_size)) else { return };
    let spread =
        sheet.step("Δζ", "%", (most - least) / most, "Difference between the damping ratio readings");
    sheet.answer("damping_spread", "Spread of the damping ratio", spread);
    if spread.value() > 0.1 {
        sheet.warn(|| {
            Text::new(
                "the readings of the damping ratio differ by {spread}: the points about the peak are too few or too \
                 noisy, or this is not one mass on one spring",
            )
            .with_quantity("spread", spread.value(), "%")
        });
    }
}
