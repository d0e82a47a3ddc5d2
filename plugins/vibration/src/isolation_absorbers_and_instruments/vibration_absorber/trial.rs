//! The main system behind the two resonances with a trial absorber, and the absorber that keeps them out of a range.

use dalembert_core::{Exhibit, Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, sdof, vibration::absorber};
use dalembert_numerics::linalg;
use nalgebra::DMatrix;

use super::{
    exhibits::{self, AbsorberResponse},
    motion::AbsorberMotion,
};
use crate::sources::{GROVER, RAO};

/// The trial absorber.
#[derive(Clone, Debug, Inputs)]
pub enum TrialBody {
    /// Mass on a spring
    Mass {
        /// Mass of the trial absorber.
        #[input("m_t", "kg", positive)]
        mass: f64,
    },
    /// Disc on a torsional spring
    Inertia {
        /// Inertia of the trial absorber.
        #[input("J_t", "kg*m^2", positive)]
        inertia: f64,
    },
}

/// Speeds that both resonances must lie outside of.
#[derive(Clone, Debug, Inputs)]
pub struct KeptOut {
    /// Minimum speed.
    #[input("ω_l", "rad/s", positive)]
    pub lowest: f64,
    /// Maximum speed.
    #[input("ω_h", "rad/s", positive)]
    pub highest: f64,
}

/// Refuses a range that does not hold the speed that the absorber is tuned to.
pub(super) fn holds_speed(lowest: f64, speed: f64, highest: f64) -> Result<(), Refusal> {
    if lowest < speed && speed < highest {
        Ok(())
    } else {
        Err(Refusal::because(
            "the range does not contain the speed to which the absorber is tuned, whose resonances enclose it: write a lowest speed below it and a highest speed above it",
        ))
    }
}

/// One reading of the measurement: the main system, and its new absorber.
struct TrialReading<N> {
    mass: N,
    stiffness: N,
    natural: N,
}

pub(super) fn solve<W: Worksheet>(
    body: &TrialBodyGiven<W>,
    tuned: W::Num,
    [lower, upper]: [W::Num; 2],
    kept_out: Option<&KeptOutGiven<W>>,
    sheet: W,
) -> Result<(), Refusal> {
    let (motion, trial) = match body {
        TrialBodyGiven::Mass { mass } => (AbsorberMotion::Translation, *mass),
        TrialBodyGiven::Inertia { inertia } => (AbsorberMotion::Torsion, *inertia),
    };
    if !(lower.value() < tuned.value() && tuned.value() < upper.value()) {
        return Err(Refusal::because(
            "the natural frequency of the absorber does not lie between the two resonances, as it must for any undamped absorber: check the measured frequencies",
        ));
    }
    let first = sheet.step("p₁", "1", lower / tuned, "Lower resonance over the frequency of the absorber");
    let second = sheet.step("p₂", "1", upper / tuned, "Upper resonance over the frequency of the absorber");

    // The book: the main system has the frequency of the absorber, and each resonance gives a mass ratio.
    let each = "Mass ratio by the lower resonance, if the absorber were tuned to the natural frequency of the main system";
    let by_lower = sheet.step("μ₁", "1", absorber::mass_ratio_when_tuned(first), (each, GROVER.at("§5.7")));
    let each = "Mass ratio by the upper resonance";
    let by_upper = sheet.step("μ₂", "1", absorber::mass_ratio_when_tuned(second), (each, GROVER.at("§5.7")));
    let why = ("Mean of the two, which differ because the tuning is not exact", GROVER.at("§5.7"));
    let mean = sheet.step("μ̄", "1", (by_lower + by_upper) / 2.0, why);
    let why = ("Main system by the mean", GROVER.at("§5.7"));
    let mass = sheet.step(motion.main_mass(), motion.mass_unit(), trial / mean, why);
    let why = ("Stiffness, from the natural frequency of the absorber", RAO.at("§2.2"));
    let stiffness = sdof::stiffness_from_natural_frequency(mass, tuned);
    let stiffness = sheet.step(motion.main_stiffness(), motion.stiffness_unit(), stiffness, why);
    let averaged = TrialReading { mass, stiffness, natural: tuned };

    // Both resonances at once: two equations for two unknowns.
    let why = (
        "From both resonances: natural frequency of the main system, since the product of the two resonances equals that of the two natural frequencies",
        RAO.at("§9.11"),
    );
    let middle = || (lower + upper) / 2.0;
    sheet.common_error("ω_m", "the mean of the two resonances taken as the natural frequency", middle);
    let geometric = || (lower * upper).sqrt();
    let what = "the geometric mean of the two resonances taken as the natural frequency";
    sheet.common_error("ω_m", what, geometric);
    let natural = sheet.step("ω_m", "rad/s", lower * upper / tuned, why);
    let why = ("Mass ratio, from the sum of the squares of the two resonances", RAO.at("§9.11"));
    let ratio = sheet.step("μ", "1", absorber::mass_ratio_of_split(first, second), why);
    let exact_symbols = match motion {
        AbsorberMotion::Translation => ["m′", "k′", "m_a′", "k_a′"],
        AbsorberMotion::Torsion => ["J′", "k_t′", "J_a′", "k_ta′"],
    };
    let mass = sheet.step(
        exact_symbols[0],
        motion.mass_unit(),
        trial / ratio,
        "Main system that has exactly these resonances",
    );
    let why = ("Its stiffness", RAO.at("§2.2"));
    let stiffness = sdof::stiffness_from_natural_frequency(mass, natural);
    let stiffness = sheet.step(exact_symbols[1], motion.stiffness_unit(), stiffness, why);
    let exact = TrialReading { mass, stiffness, natural };

    let trial_stiffness = sdof::stiffness_from_natural_frequency(trial, tuned);
    sheet.verify(|| {
        let found = eigenvalues(&exact, trial.value(), trial_stiffness.value());
        if let Some(found) = found.map(|found| found.map(W::Num::from)) {
            sheet.check("lower resonance, as an eigenvalue of the two-mass system", lower, found[0]);
            sheet.check("upper resonance, as an eigenvalue of the two-mass system", upper, found[1]);
        }
    });
    sheet.verify(|| {
        let found = eigenvalues(&averaged, trial.value(), trial_stiffness.value());
        if let Some(found) = found {
            // p² + 1/p² = 2 + μ of both resonances, averaged.
            let tuned = tuned.value().powi(2);
            let sum = [first, second].map(|p| p.value().powi(2) + p.value().powi(-2)).iter().sum::<f64>() / 2.0;
            sheet.check(
                "main system by the mean: sum of the squares of its resonances with the trial absorber, as eigenvalues",
                W::Num::from((found[0].powi(2) + found[1].powi(2)) / tuned),
                W::Num::from(sum),
            );
        }
    });
    let off = ratio.value() / mean.value() - 1.0;
    if off.abs() > 0.05 {
        sheet.warn(|| {
            Text::new(
                "the trial absorber is not tuned to the natural frequency of the main system: the mean of the mass ratios is in error by {off}; use the exact main system",
            )
            .with_quantity("off", off, "%")
        });
    }
    let [main, main_exact] = match motion {
        AbsorberMotion::Translation => {
            [("main_mass", "Mass, by the mean"), ("exact_main_mass", "Mass, exact")]
        }
        AbsorberMotion::Torsion => {
            [("main_inertia", "Inertia, by the mean"), ("exact_main_inertia", "Inertia, exact")]
        }
    };
    sheet.answer(main.0, main.1, averaged.mass);
    sheet.answer("main_stiffness", "Stiffness, from the mean", averaged.stiffness);
    sheet.answer(main_exact.0, main_exact.1, exact.mass);
    sheet.answer("exact_main_stiffness", "Stiffness, exact", exact.stiffness);
    sheet.answer("exact_natural_frequency", "Natural frequency of the main system, exact", exact.natural);

    let mut new = None;
    if let Some(range) = kept_out {
        new = Some(absorber_for(motion, tuned, range, [&averaged, &exact], exact_symbols, sheet)?);
    }
    let response = |absorber_mass: f64, absorber_stiffness: f64| AbsorberResponse {
        mass: exact.mass.value(),
        stiffness: exact.stiffness.value(),
        absorber_mass,
        absorber_stiffness,
    };
    let tuned = tuned.value();
    let measured = [lower.value(), upper.value()];
    sheet.show(|| {
        let trial = response(trial.value(), trial_stiffness.value());
        Exhibit::Plot(trial.main_mass(tuned, measured, None))
    });
    if let (Some([mass, stiffness]), Some(range)) = (new, kept_out) {
        sheet.show(|| {
            let resonances = eigenvalues(&exact, mass, stiffness).unwrap_or(measured);
            let range = [range.lowest.value(), range.highest.value()];
            Exhibit::Plot(response(mass, stiffness).main_mass(tuned, resonances, Some(range)))
        });
    }
    sheet.show(|| Exhibit::Drawing(exhibits::drawing(motion)));
    Ok(())
}

/// The lightest absorber with both resonances outside the range, by the mean and exactly. The result is the exact one.
fn absorber_for<W: Worksheet>(
    motion: AbsorberMotion,
    tuned: W::Num,
    range: &KeptOutGiven<W>,
    [averaged, exact]: [&TrialReading<W::Num>; 2],
    symbols: [&'static str; 4],
    sheet: W,
) -> Result<[f64; 2], Refusal> {
    holds_speed(range.lowest.value(), tuned.value(), range.highest.value())?;
    let low = sheet.step(
        "q₁",
        "1",
        range.lowest / tuned,
        "Lower end of the range, over the frequency of the absorber",
    );
    let high = sheet.step(
        "q₂",
        "1",
        range.highest / tuned,
        "Upper limit of the range, over the frequency of the absorber",
    );
    let both = |symbols: [&'static str; 2], of: &dyn Fn(W::Num) -> W::Num| {
        let why = ("Mass ratio that places the lower resonance at the lower end", RAO.at("§9.11"));
        let lower = sheet.step(symbols[0], "1", of(low), why);
        let why = ("Mass ratio that places the upper resonance at the upper end", RAO.at("§9.11"));
        let upper = sheet.step(symbols[1], "1", of(high), why);
        if lower.value() >= upper.value() { lower } else { upper }
    };
    let ratio = both(["μ_l", "μ_h"], &absorber::mass_ratio_when_tuned);
    let why = "New absorber: the larger of the two mass ratios keeps both resonances out of the range";
    let mass = sheet.step(
        motion.absorber_mass(),
        motion.mass_unit(),
        ratio * averaged.mass,
        (why, GROVER.at("§5.7")),
    );
    let stiffness = sdof::stiffness_from_natural_frequency(mass, tuned);
    let why = ("Its stiffness, tuned like the trial absorber", GROVER.at("§5.7"));
    let stiffness = sheet.step(motion.absorber_stiffness(), motion.stiffness_unit(), stiffness, why);
    let (name, label) = match motion {
        AbsorberMotion::Translation => ("absorber_mass", "Mass of the new absorber, by the mean"),
        AbsorberMotion::Torsion => ("absorber_inertia", "Inertia of the new absorber, by the mean"),
    };
    sheet.answer(name, label, mass);
    sheet.answer("absorber_stiffness", "Stiffness of the new absorber, from the mean", stiffness);

    let why = ("Tuning of the absorber to the exact main system", RAO.at("§9.11"));
    let tuning = sheet.step("f", "1", tuned / exact.natural, why);
    let ratio = both(["μ_l′", "μ_h′"], &|p| absorber::mass_ratio_of_resonance(p, tuning));
    if ratio.value() <= 0.0 {
        return Err(Refusal::because(
            "the resonances lie outside of that range with any absorber, however light, as the natural frequency \
             of the main system does not lie in it: give the stroke or the mass of the absorber instead",
        ));
    }
    let why = "New absorber for the exact main system";
    let mass = sheet.step(symbols[2], motion.mass_unit(), ratio * exact.mass, why);
    let stiffness = sdof::stiffness_from_natural_frequency(mass, tuned);
    let why = ("Its stiffness, tuned like the trial absorber", GROVER.at("§5.7"));
    let stiffness = sheet.step(symbols[3], motion.stiffness_unit(), stiffness, why);
    sheet.verify(|| {
        if let Some(found) = eigenvalues(exact, mass.value(), stiffness.value()) {
            let [low, high] = [range.lowest.value(), range.highest.value()];
            // The one that asked for more lies at its end of the range, the other further out.
            let at_low = (found[0] / low - 1.0).abs() <= (found[1] / high - 1.0).abs();
            let (end, found) = if at_low { (range.lowest, found[0]) } else { (range.highest, found[1]) };
            sheet.check("one resonance at the end of the range, as an eigenvalue", W::Num::from(found), end);
        }
    });
    let (name, label) = match motion {
        AbsorberMotion::Translation => ("exact_absorber_mass", "Mass of the new absorber, exact"),
        AbsorberMotion::Torsion => ("exact_absorber_inertia", "Inertia of the new absorber, exact"),
    };
    sheet.answer(name, label, mass);
    sheet.answer("exact_absorber_stiffness", "Stiffness of the new absorber, exact", stiffness);
    Ok([mass.value(), stiffness.value()])
}

/// The two resonances of the main system with an absorber, as eigenvalues.
fn eigenvalues<N: Real>(main: &TrialReading<N>, mass: f64, stiffness: f64) -> Option<[f64; 2]> {
    let k = main.stiffness.value();
    let matrix = DMatrix::from_row_slice(2, 2, &[k + stiffness, -stiffness, -stiffness, stiffness]);
    let masses = DMatrix::from_row_slice(2, 2, &[main.mass.value(), 0.0, 0.0, mass]);
    let squares = linalg::generalised_eigenvalues(&matrix, &masses).ok()?;
    Some([squares[0], squares[1]].map(|square| square.max(0.0).sqrt()))
}
