//! Modal masses and damping of a system: steps and answers.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    vibration::modes::{ComplexMode, complex_modes},
};
use nalgebra::{Complex, DVector};

mod checks;

use super::{
    Assembled, SystemMatrices,
    damping::ModalDamping,
    modes::{self, SHOWN, WorkedModes},
};
use crate::{
    shared::decay::damped_frequency_error,
    sources::{EWINS, RAO},
};

/// Modal mass, stiffness and participation of each mode, for the size that its shape has, and its damping: a ratio where
/// the damping leaves the modes alone, a complex mode where it couples them.
pub(crate) fn modal_properties<W: Worksheet>(
    system: &Assembled<W::Num>,
    found: &WorkedModes<W::Num>,
    damped: &ModalDamping,
    shapes: &[Vec<f64>],
    sheet: W,
) -> Result<(), Refusal> {
    masses(system, found, shapes, sheet);
    if damped.any() && damped.proportional {
        let shown = ratios(found, &damped.decays(), sheet);
        sheet.verify(|| check_roots(found, damped, shown, sheet));
    } else if damped.any() {
        complex(system, damped, found, sheet)?;
    }
    Ok(())
}

/// Modal masses and, where the coordinates are parallel, the share of each mode in a motion of the ground.
pub(crate) fn masses<W: Worksheet>(
    system: &impl SystemMatrices,
    found: &WorkedModes<W::Num>,
    shapes: &[Vec<f64>],
    sheet: W,
) {
    let unit = DVector::from_element(system.size(), 1.0);
    let total = unit.dot(&system.momenta(&unit));
    let mut effective_sum = 0.0;
    for (mode, frequency) in found.frequencies.iter().enumerate() {
        let shape = DVector::from_column_slice(&shapes[mode]);
        let momenta = system.momenta(&shape);
        let mass = sheet.numerical(
            ("μ", mode + 1),
            "kg",
            shape.dot(&momenta),
            ("Modal mass φᵀMφ, for the chosen normalisation", RAO.at("§6.11")),
        );
        sheet.answer(("modal_mass", mode + 1), "Modal mass", mass);
        if frequency.value() > 0.0 {
            let stiffness = sheet.step(
                ("κ", mode + 1),
                "N/m",
                frequency.powi(2) * mass,
                ("Modal stiffness φᵀKφ = ω²φᵀMφ", RAO.at("§6.11")),
            );
            sheet.answer(("modal_stiffness", mode + 1), "Modal stiffness", stiffness);
            sheet.verify(|| checks::stiffness(system, &shape, mode + 1, stiffness, sheet));
        }
        if system.is_parallel() {
            let excitation = unit.dot(&momenta);
            let nothing = excitation.abs() <= 1e-12 * momenta.lp_norm(1);
            let excited = sheet.numerical(
                ("L", mode + 1),
                "kg",
                if nothing { 0.0 } else { excitation },
                "Excitation by uniform motion of the ground at all springs: φᵀM1",
            );
            let effective = sheet.step(
                ("m_e", mode + 1),
                "kg",
                excited.powi(2) / mass,
                "Effective mass: the part of the total mass that moves with the ground in this mode",
            );
            effective_sum += effective.value();
            sheet.answer(("effective_mass", mode + 1), "Effective mass", effective);
        }
    }
    if system.is_parallel() && found.frequencies.len() == system.size() {
        sheet.check("the effective masses add up to the total mass", effective_sum.into(), total.into());
    }
}

/// Damping ratios where the damping leaves the modes alone, by 2ζω of each mode. Returns the modes that oscillate, with
/// natural frequency, damping ratio and damped frequency.
pub(crate) fn ratios<W: Worksheet>(
    found: &WorkedModes<W::Num>,
    decays: &[f64],
    sheet: W,
) -> Vec<(usize, [f64; 3])> {
    let mut shown = Vec::new();
    for (mode, frequency) in found.frequencies.iter().enumerate() {
        if frequency.value() == 0.0 {
            continue;
        }
        let decay = sheet.numerical(
            ("γ", mode + 1),
            "1/s",
            decays[mode],
            ("Damping of the mode φᵀCφ/φᵀMφ: C does not couple the modes, so the mode shapes are unchanged", RAO.at("§6.15")),
        );
        let ratio = sheet.step(
            ("ζ", mode + 1),
            "1",
            decay / *frequency / 2.0,
            ("Damping ratio of the mode", RAO.at("§6.15")),
        );
        sheet.answer(("damping_ratio", mode + 1), "Damping ratio", ratio);
        if ratio.value() < 1.0 {
            let one = W::Num::from(1.0);
            let natural = *frequency;
            damped_frequency_error(("ω_d", mode + 1), natural, ratio, sheet);
            let frequency = sheet.step(
                ("ω_d", mode + 1),
                "rad/s",
                *frequency * (one - ratio.powi(2)).sqrt(),
                ("Frequency of the free damped vibration", RAO.at("§2.6")),
            );
            sheet.answer(("damped_frequency", mode + 1), "Damped frequency", frequency);
            shown.push((mode + 1, [natural, ratio, frequency].map(Real::value)));
        } else {
            sheet.warn(|| {
                Text::new("mode {mode} is overdamped: it returns without oscillating").with("mode", mode + 1)
            });
        }
    }
    shown
}

/// Compares the damped modes with the roots of the whole damped system, one after another.
fn check_roots<W: Worksheet>(
    found: &WorkedModes<W::Num>,
    damped: &ModalDamping,
    shown: Vec<(usize, [f64; 3])>,
    sheet: W,
) {
    if let Ok(all) = complex_modes(&found.modes, &damped.physical)
        && found.modes.squares[0] > 0.0
    {
        for (mode, numbers) in shown {
            checks::root(numbers, mode, &all, sheet);
        }
        let lowest = all.iter().filter(|mode| mode.root.im > 0.0).map(ComplexMode::natural).reduce(f64::min);
        if let (Some(lowest), true) = (lowest, damped.decay(0) < 1.99 * found.modes.squares[0].sqrt()) {
            sheet.check_zero(
                "the lowest root of det(λ²M + λC + K) = 0 lies at the lowest natural frequency",
                (lowest - found.modes.squares[0].sqrt()).into(),
                found.modes.squares[found.modes.squares.len() - 1].sqrt(),
            );
        }
    }
}

/// Complex modes, for damping that couples the modes.
fn complex<W: Worksheet>(
    system: &Assembled<W::Num>,
    damping: &ModalDamping,
    found: &WorkedModes<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    sheet.warn(|| {
        Text::new(
            "the damping couples the modes without damping: the masses no longer pass through rest together, and the \
             damped modes are complex",
        )
    });
    let all = complex_modes(&found.modes, &damping.physical).map_err(modes::refusal)?;
    let mut oscillations = 0;
    for (at, mode) in all.iter().take(SHOWN).enumerate() {
        let size = mode.natural();
        if size <= 1e-9 * all[all.len() - 1].natural() {
            continue;
        }
        let place = at + 1;
        let real = sheet.numerical(
            ("Re λ", place),
            "1/s",
            mode.root.re,
            ("Root of det(λ²M + λC + K) = 0, from the first-order state equations", EWINS.at("ch. 2")),
        );
        if mode.root.im <= 0.0 {
            sheet.answer(("decay_rate", place), "Root without oscillation", real);
            continue;
        }
        oscillations += 1;
        let damped = sheet.numerical(
            ("ω_d", place),
            "rad/s",
            mode.root.im,
            "Its imaginary part: frequency of the damped motion",
        );
        let natural = sheet.step(
            ("|λ|", place),
            "rad/s",
            (real.powi(2) + damped.powi(2)).sqrt(),
            "Its modulus: natural frequency of the damped mode",
        );
        let over_damped = || -real / damped;
        let what = "the decay rate divided by the damped frequency";
        sheet.common_error(("ζ", place), what, over_damped);
        let ratio = sheet.step(("ζ", place), "1", -real / natural, "Damping ratio of the damped mode");
        sheet.answer(("complex_frequency", place), "Natural frequency of the damped mode", natural);
        sheet.answer(("damped_frequency", place), "Damped frequency", damped);
        sheet.answer(("damping_ratio", place), "Damping ratio", ratio);
        sheet.verify(|| {
            let shown = [natural, ratio, damped].map(Real::value);
            let fastest = all[all.len() - 1].natural();
            checks::complex((system, damping), shown, (place, mode), fastest, sheet);
        });
        let lead = mode
            .shape
            .iter()
            .copied()
            .fold(None, |best: Option<Complex<f64>>, x| match best {
                Some(best) if x.norm() <= best.norm() * (1.0 + 1e-9) => Some(best),
                _ => Some(x),
            })
            .unwrap_or(Complex::ONE);
        // What does not move but for rounding has no phase.
        let relative = mode.shape.iter().map(|x| x / lead);
        let relative: Vec<Complex<f64>> =
            relative.map(|x| if x.norm() > 1e-10 { x } else { Complex::ZERO }).collect();
        let sizes: Vec<f64> = relative.iter().map(|x| x.norm()).collect();
        let phases: Vec<f64> = relative.iter().map(|x| x.arg()).collect();
        sheet.answer_list(("amplitudes", place), "Amplitudes of the damped mode", "1", &sizes);
        sheet.answer_list(("phases", place), "Phases of the damped mode", "deg", &phases);
    }
    // The roots of a polynomial sum up to its second coefficient: −tr M⁻¹C.
    sheet.verify(|| {
        let sum: f64 =
            all.iter().map(|mode| if mode.root.im > 0.0 { 2.0 * mode.root.re } else { mode.root.re }).sum();
        let trace = damping.matrix.trace();
        sheet.check("the sum of all roots is −tr(M⁻¹C)", (-sum).into(), trace.into());
    });
    if oscillations == 0 {
        sheet.warn(|| Text::new("every mode is overdamped: the system returns without oscillating"));
    }
    Ok(())
}
