//! Damping from the natural frequency and the two half-power frequencies.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, identification, sdof};

use super::few_points;
use crate::sources::{EWINS, RAO};

/// The reading of the bandwidth, and the exact one of the two half-power frequencies.
pub(super) fn identify<W: Worksheet>(
    lower: W::Num,
    upper: W::Num,
    natural: Option<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    if lower.value() >= upper.value() {
        return Err(Refusal::because(
            "the lower half-power frequency is not below the upper one: exchange the two frequencies",
        ));
    }
    if let Some(given) = natural
        && !(lower.value() < given.value() && given.value() < upper.value())
    {
        return Err(Refusal::because(
            "the natural frequency does not lie between the two half-power frequencies: write the frequency of the peak between them",
        ));
    }
    let one = W::Num::from(1.0);
    let width = sheet.step(
        "Δω",
        "Hz",
        upper - lower,
        (
            "Half-power bandwidth: between the frequencies at which the amplitude is 1/√2 of its peak",
            RAO.at("§3.4"),
        ),
    );
    sheet.answer("bandwidth", "Half-power bandwidth", width);
    let exact = sheet.step(
        "ζₑ",
        "1",
        sdof::damping_ratio_from_half_power(lower, upper),
        (
            "Exact damping ratio: ω₁² and ω₂² are ωₙ²(1 − 2ζ² ∓ 2ζ√(1 − ζ²)), and with ζ = sin α, tan 2α = (ω₂² − ω₁²)/(ω₂² + ω₁²)",
            RAO.at("§3.4"),
        ),
    );
    sheet.common_error("ωₚ", "the arithmetic mean of the half-power frequencies taken", || {
        (lower + upper) / 2.0
    });
    sheet.common_error("ωₚ", "the geometric mean of the half-power frequencies taken", || {
        (lower * upper).sqrt()
    });
    let peak = sheet.step(
        "ωₚ",
        "Hz",
        identification::peak_between_half_power(lower, upper),
        "Frequency of the peak between them: ωₚ² is the mean of ω₁² and ω₂²",
    );
    let exact_natural = sheet.step(
        "ωₙₑ",
        "Hz",
        sdof::natural_frequency_from_force_peak(peak, exact),
        ("Natural frequency without damping", RAO.at("§3.4")),
    );
    let hysteretic = sheet.step(
        "ηₑ",
        "1",
        (upper.powi(2) - lower.powi(2)) / (peak.powi(2) * 2.0),
        ("Exact loss factor with hysteretic damping: ω₁² and ω₂² are ωₙ²(1 ∓ η)", EWINS.at("§4.3.3")),
    );
    let middle = natural.unwrap_or(peak);
    let zeta = sheet.step(
        "ζ",
        "1",
        sdof::damping_ratio_from_bandwidth(lower, upper, middle),
        ("Damping ratio from the bandwidth, for light damping", RAO.at("§3.4")),
    );
    few_points::answer(zeta, sheet);
    let loss = sheet.step("η", "1", width / middle, ("Loss factor, for light damping", EWINS.at("§4.3.3")));
    sheet.answer("loss_factor", "Loss factor", loss);
    sheet.answer("half_power_damping_ratio", "Damping ratio, half-power points", exact);
    sheet.answer("natural_frequency", "Natural frequency", exact_natural);
    sheet.answer("half_power_loss_factor", "Loss factor, half-power points", hysteretic);
    sheet.verify(|| {
        let [below, above] = [sdof::lower_half_power_ratio(exact), sdof::upper_half_power_ratio(exact)];
        let down = sdof::peak_magnification(exact) / 2.0_f64.sqrt();
        for (what, at) in [
            ("amplitude at the lower half-power frequency: 1/√2 of the peak", lower),
            ("amplitude at the upper half-power frequency: 1/√2 of the peak", upper),
        ] {
            sheet.check(what, sdof::magnification(at / exact_natural, exact), down);
        }
        sheet.check(
            "bandwidth of a mode with the exact damping ratio, from its half-power frequencies in closed form",
            (above - below) * exact_natural,
            width,
        );
        sheet.check("bandwidth over twice the damping ratio: the frequency between", width / (zeta * 2.0), middle);
        sheet.check("the loss factor at resonance is twice the damping ratio", loss, zeta * 2.0);
        // |1 − r² + iη| is η at the peak and η√2 where 1 − r² = η.
        let gap = one - (lower / peak).powi(2);
        sheet.check(
            "hysteretic damping: half the power of the peak where 1 − (ω/ωₙ)² is the loss factor",
            (gap.powi(2) + hysteretic.powi(2)).sqrt(),
            hysteretic * 2.0_f64.sqrt(),
        );
    });
    if let Some(given) = natural
        && (given.value() / peak.value() - 1.0).abs() > 0.1 * (width / peak).value()
    {
        sheet.warn(|| {
            Text::new(
                "the natural frequency lies away from the middle of the two half-power frequencies, where one mode alone has its peak ({peak}): another mode or an error of reading is in these numbers",
            )
            .with_quantity("peak", peak.value(), "Hz")
        });
    }
    let point = |at: W::Num| {
        let ratio = (at / exact_natural).value();
        (ratio, sdof::magnification(ratio, exact.value()))
    };
    few_points::show(exact, false, vec![point(lower), point(peak), point(upper)], sheet);
    Ok(())
}
