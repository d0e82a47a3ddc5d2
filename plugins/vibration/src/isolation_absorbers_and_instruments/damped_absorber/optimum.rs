//! The best absorbers: by the fixed points, for the least peak, and viscous without spring.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    vibration::absorber::{self, DampedAbsorber as Kernel},
};
use dalembert_numerics::linalg;
use nalgebra::{Complex, DMatrix};

use super::{AbsorberSystem, Chosen, no_peaks};
use crate::sources::{BROCK, DEN_HARTOG, NISHIHARA};

/// Names and labels of the damping by the fixed points: relative to the absorber, and to the main frequency.
const FIXED_POINTS: [(&str, &str); 2] = [
    ("damping_ratio_absorber", "Damping ratio relative to the absorber, c/(2 m_a ω_a), fixed points"),
    ("damping_ratio_main", "Damping ratio relative to the main frequency, c/(2 m_a ω_m), fixed points"),
];

/// Names and labels of the damping for the minimum peak.
const LEAST_PEAK: [(&str, &str); 2] = [
    ("best_damping_ratio_absorber", "Damping ratio relative to the absorber, c/(2 m_a ω_a), minimum peak"),
    ("best_damping_ratio_main", "Damping ratio relative to the main frequency, c/(2 m_a ω_m), minimum peak"),
];

/// Den Hartog's tuning and Brock's damping.
pub(super) fn fixed_points<W: Worksheet>(system: &AbsorberSystem<W::Num>, sheet: W) -> Chosen<W::Num> {
    let ratio = system.ratio;
    if system.zeta.value() > 0.0 {
        sheet.warn(|| {
            Text::new(
                "the main system is damped: it has no fixed points, whose formulas hold only for an undamped one; the minimum peak takes its damping into account",
            )
        });
    }
    let why = (
        "Tuning by the fixed points: the two frequencies at which the response is independent of damping, brought to equal height",
        DEN_HARTOG.at("§3.3"),
    );
    let natural = || W::Num::from(1.0);
    sheet.common_error("f_opt", "the absorber tuned to the natural frequency of the main system", natural);
    let random = || (ratio / 2.0 + 1.0).sqrt() / (ratio + 1.0);
    sheet.common_error("f_opt", "the tuning for a random force used", random);
    let tuning = sheet.step("f_opt", "1", absorber::den_hartog_tuning(ratio), why);
    let why = ("Squares of the ratios of the fixed points: their mean", DEN_HARTOG.at("§3.3"));
    let mean = sheet.step("b", "1", absorber::fixed_points_mean(ratio, tuning), why);
    let why = ("Half of their difference", DEN_HARTOG.at("§3.3"));
    let half = sheet.step("d", "1", absorber::fixed_points_half_difference(ratio, tuning, mean), why);
    let lower = sheet.step("g_P", "1", (mean - half).sqrt(), "Lower fixed point");
    let upper = sheet.step("g_Q", "1", (mean + half).sqrt(), "Upper fixed point");
    let why = ("Magnification at both points", DEN_HARTOG.at("§3.3"));
    let height = sheet.step("H_PQ", "1", absorber::fixed_point_height(ratio), why);
    for (point, what) in [
        (lower, "height of the lower fixed point, with the masses locked together"),
        (upper, "height of the upper fixed point, with the masses locked together"),
    ] {
        sheet.check(what, absorber::magnification_as_one(ratio, point), height);
    }
    let why = (
        "Damping: mean square of the two values that give zero slope of the response at one or the other fixed point",
        BROCK.at(""),
    );
    let one_point =
        || (ratio * (W::Num::from(3.0) - (ratio / (ratio + 2.0)).sqrt()) / ((ratio + 1.0) * 8.0)).sqrt();
    let what = "the damping for zero slope at the lower fixed point alone used";
    sheet.common_error("ζ_opt", what, one_point);
    let random = || (ratio * (ratio * 0.75 + 1.0) / ((ratio + 1.0) * (ratio / 2.0 + 1.0) * 4.0)).sqrt();
    sheet.common_error("ζ_opt", "the damping for a random force used", random);
    let own = sheet.step("ζ_opt", "1", absorber::den_hartog_damping(ratio), why);
    sheet.answer("tuning", "Tuning by the fixed points", tuning);
    let damping = answer_dampings(tuning, own, FIXED_POINTS, "γ_opt", sheet);
    sheet.verify(|| {
        let square = |point: W::Num| {
            absorber::level_damping_squared(ratio.value(), tuning.value(), point.value().powi(2))
        };
        let mean = f64::midpoint(square(lower), square(upper));
        sheet.check(
            "mean of the squares of the two damping ratios with a horizontal tangent at a fixed point",
            W::Num::from(mean),
            damping.powi(2),
        );
    });
    sheet.answer("lower_fixed_point", "Lower fixed point", lower);
    sheet.answer("upper_fixed_point", "Upper fixed point", upper);
    sheet.answer("fixed_point_height", "Magnification at the fixed points", height);
    let chosen = Chosen { tuning: Some(tuning), damping };
    let kernel = system.kernel(&chosen);
    if let Some(peak) = kernel.largest_peak() {
        let how = "Maximum magnification with this tuning and damping: the peaks lie a little above the fixed points";
        let found = sheet.numerical("H_opt", "1", peak.height, how);
        sheet.verify(|| {
            let [main, _] = equations(&kernel, peak.ratio);
            sheet.check("that magnification from the equations of both masses", W::Num::from(main), found);
        });
        sheet.answer("fixed_point_peak", "Maximum magnification by the fixed points", found);
    }
    chosen
}

/// Tuning and damping of the least possible peak; `None` where the main system is too damped for one.
pub(super) fn least_peak<W: Worksheet>(system: &AbsorberSystem<W::Num>, sheet: W) -> Option<Chosen<W::Num>> {
    let (ratio, zeta) = (system.ratio, system.zeta.value());
    let found = absorber::least_peak(ratio.value(), zeta).ok();
    let (chosen, height) = if zeta == 0.0 {
        let s =
            sheet.step("s", "1", absorber::least_peak_root(ratio), ("Auxiliary number", NISHIHARA.at("")));
        let why = ("Optimum tuning, exact: two peaks of equal and minimum height", NISHIHARA.at(""));
        let tuning = sheet.step("f*", "1", absorber::least_peak_tuning(s), why);
        let why = ("Damping for the minimum peak", NISHIHARA.at(""));
        let own = sheet.step("ζ_a*", "1", absorber::least_peak_damping(ratio, s), why);
        sheet.answer("best_tuning", "Optimum tuning, minimum peak", tuning);
        let damping = answer_dampings(tuning, own, LEAST_PEAK, "γ*", sheet);
        let why = ("The minimum peak", NISHIHARA.at(""));
        let height = sheet.step("H*", "1", absorber::least_peak_height(ratio, s), why);
        (Chosen { tuning: Some(tuning), damping }, height)
    } else {
        let Some(found) = found else {
            sheet.warn(|| {
                Text::new("the main system is so heavily damped that there are no two peaks to equalise: there is no minimum peak")
            });
            return None;
        };
        let how = "Optimum tuning with this damping of the main system: two peaks of equal height, where no change lowers both (Newton's method)";
        let tuning = sheet.numerical("f*", "1", found.absorber.tuning, how);
        let how = "Its damping ratio, relative to the absorber alone";
        let own = sheet.numerical("ζ_a*", "1", found.absorber.damping / found.absorber.tuning, how);
        sheet.answer("best_tuning", "Optimum tuning, minimum peak", tuning);
        let damping = answer_dampings(tuning, own, LEAST_PEAK, "γ*", sheet);
        let height = sheet.numerical("H*", "1", found.height, "The minimum peak");
        (Chosen { tuning: Some(tuning), damping }, height)
    };
    sheet.verify(|| {
        let peaks = system.kernel(&chosen).peaks();
        if let [lower, upper] = peaks[..] {
            sheet.check("the lower-frequency peak", W::Num::from(lower.height), height);
            sheet.check("the higher-frequency peak", W::Num::from(upper.height), height);
        }
        if let (true, Some(found)) = (zeta == 0.0, found) {
            sheet.check("the minimum peak by Newton's method", W::Num::from(found.height), height);
        }
    });
    sheet.answer("best_peak", "Minimum possible peak magnification", height);
    Some(chosen)
}

/// Answers a damping by the frequency of the absorber and by that of the main system; the result is the second.
fn answer_dampings<W: Worksheet>(
    tuning: W::Num,
    by_absorber: W::Num,
    answers: [(&'static str, &'static str); 2],
    symbol: &'static str,
    sheet: W,
) -> W::Num {
    let why = ("The same damping relative to the main frequency, c/(2 m_a ω_m)", DEN_HARTOG.at("§3.3"));
    let by_main = sheet.step(symbol, "1", tuning * by_absorber, why);
    for ((name, label), damping) in answers.into_iter().zip([by_absorber, by_main]) {
        sheet.answer(name, label, damping);
    }
    by_main
}

/// Best damping of an absorber without spring.
pub(super) fn viscous<W: Worksheet>(
    system: &AbsorberSystem<W::Num>,
    sheet: W,
) -> Result<Chosen<W::Num>, Refusal> {
    let (ratio, zeta) = (system.ratio, system.zeta.value());
    let why = (
        "Optimum damping relative to the main frequency, c/(2 m_a ω_m): the peak lies at the fixed point of an undamped main system",
        DEN_HARTOG.at("§3.3"),
    );
    let with_spring = || (ratio * 3.0 / ((ratio + 1.0).powi(3) * 8.0)).sqrt();
    sheet.common_error("γ_h", "the damping of a tuned absorber, with a spring, used", with_spring);
    let damping = sheet.step("γ_h", "1", absorber::viscous_damping(ratio), why);
    let why = ("Frequency ratio of the fixed point", DEN_HARTOG.at("§3.3"));
    let point = sheet.step("g_h", "1", absorber::viscous_fixed_point(ratio), why);
    let why = ("Magnification at this point", DEN_HARTOG.at("§3.3"));
    let height = sheet.step("H_h", "1", absorber::viscous_height(ratio), why);
    sheet.check(
        "height of the fixed point, with the masses locked together",
        absorber::magnification_as_one(ratio, point),
        height,
    );
    let [_, (name, label)] = FIXED_POINTS;
    sheet.answer(name, label, damping);
    sheet.answer("fixed_point", "Fixed point", point);
    sheet.answer("fixed_point_height", "Magnification at the fixed point", height);
    let found = absorber::least_peak_viscous(ratio.value(), zeta).map_err(|_| no_peaks());
    if zeta == 0.0 {
        sheet.verify(|| {
            if let Ok(found) = found {
                sheet.check(
                    "optimum damping by Newton's method",
                    W::Num::from(found.absorber.damping),
                    damping,
                );
                sheet.check("minimum peak by Newton's method", W::Num::from(found.height), height);
            }
        });
        return Ok(Chosen { tuning: None, damping });
    }
    sheet.warn(|| {
        Text::new(
            "the main system is damped: it has no fixed points, whose formulas hold only for an undamped one; the minimum peak takes its damping into account",
        )
    });
    let found = found?;
    let how = "Damping for the minimum peak with this damping of the main system (Newton's method)";
    let best = sheet.numerical("γ*", "1", found.absorber.damping, how);
    let least = sheet.numerical("H*", "1", found.height, "The minimum peak");
    sheet.verify(|| {
        if let Some(peak) = found.absorber.largest_peak() {
            sheet.check("the highest of all peaks", W::Num::from(peak.height), least);
        }
    });
    let [_, (name, label)] = LEAST_PEAK;
    sheet.answer(name, label, best);
    sheet.answer("best_peak", "Minimum possible peak magnification", least);
    Ok(Chosen { tuning: None, damping: best })
}

/// Magnification and relative motion from the complex equations of both masses.
pub(super) fn equations(kernel: &Kernel, ratio: f64) -> [f64; 2] {
    let Kernel { mass_ratio: mu, main_damping: zeta, tuning: f, damping: gamma } = *kernel;
    let square = ratio * ratio;
    let link = Complex::new(mu * f * f, 2.0 * mu * gamma * ratio);
    let own = Complex::new(1.0 - square, 2.0 * zeta * ratio);
    let matrix = DMatrix::from_row_slice(2, 2, &[own + link, -link, -link, link - mu * square]);
    let force = DMatrix::from_row_slice(2, 1, &[Complex::new(1.0, 0.0), Complex::new(0.0, 0.0)]);
    match linalg::solve_complex(&matrix, &force) {
        Ok(x) => [x[(0, 0)].norm(), (x[(1, 0)] - x[(0, 0)]).norm()],
        Err(_) => [f64::INFINITY; 2],
    }
}
