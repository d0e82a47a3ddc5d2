//! Free decay: the damping that successive amplitudes tell of.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Inputs, Symbol, Worksheet};
use dalembert_mechanics::{Real, sdof};

use crate::sources::RAO;

/// Amplitudes of a free decay.
#[derive(Clone, Debug, Inputs)]
pub struct Decay {
    /// Ratio of the first amplitude to the last.
    /// 1 stands for a motion that does not decay.
    #[input("(x₁/xₙ)", "1", min = 1)]
    pub amplitude_ratio: f64,
    /// Counted quantity.
    pub counted: DecayCount,
}

/// Number of cycles, or time, from the first amplitude to the last.
#[derive(Clone, Debug, Inputs)]
pub enum DecayCount {
    /// Cycles between the two amplitudes
    Cycles {
        /// Number of cycles.
        #[input("N", "1", positive)]
        cycles: f64,
    },
    /// Successive amplitudes, including both ends
    /// Seven successive amplitudes span six cycles.
    Amplitudes {
        /// Number of amplitudes.
        #[input("n", "1", min = 2)]
        amplitudes: f64,
    },
}

/// The damping ratio of a decay, with the steps that lead to it.
pub(crate) struct FreeDecay<N> {
    /// Cycles between the two amplitudes.
    pub(crate) cycles: N,
    /// Logarithmic decrement.
    pub(crate) decrement: N,
    /// Damping ratio.
    pub(crate) damping_ratio: N,
}

/// Writes `N`, `δ` and `ζ`.
#[inline]
pub(crate) fn decrement<W: Worksheet>(given: &DecayGiven<W>, sheet: W) -> FreeDecay<W::Num> {
    let cycles = match &given.counted {
        DecayCountGiven::Cycles { cycles } => *cycles,
        DecayCountGiven::Amplitudes { amplitudes } => {
            sheet.step("N", "1", *amplitudes - 1.0, "Successive amplitudes are one cycle apart")
        }
    };
    let ratio = given.amplitude_ratio;
    let decimal = || ratio.log10() / cycles;
    sheet.common_error("δ", "the logarithm to base 10 used in place of the natural one", decimal);
    let together = || ratio.ln();
    sheet.common_error("δ", "the decrement over all cycles taken as that of one cycle", together);
    let decrement = sheet.step(
        "δ",
        "1",
        sdof::logarithmic_decrement(ratio, cycles),
        ("Logarithmic decrement", RAO.at("§2.6.3")),
    );
    ratio_errors("ζ", decrement, sheet);
    let damping_ratio = sheet.step(
        "ζ",
        "1",
        sdof::damping_ratio_from_decrement(decrement),
        ("Damping ratio from that decrement", RAO.at("§2.6.3")),
    );
    sheet.check(
        "the damping ratio reproduces the decrement",
        sdof::decrement_from_damping_ratio(damping_ratio),
        decrement,
    );
    FreeDecay { cycles, decrement, damping_ratio }
}

/// Records the common error of the damped natural frequency `symbol`.
pub(crate) fn damped_frequency_error<W: Worksheet>(
    symbol: impl Into<Symbol>,
    natural: W::Num,
    damping_ratio: W::Num,
    sheet: W,
) {
    let peak = || natural * sdof::magnification_peak_ratio(damping_ratio);
    sheet.common_error(symbol, "the frequency of the resonance peak taken, ωₙ√(1 − 2ζ²)", peak);
}

/// Records the common errors of the damping ratio `symbol` of a decrement.
pub(crate) fn ratio_errors<W: Worksheet>(symbol: &'static str, decrement: W::Num, sheet: W) {
    sheet.common_error(symbol, "the decrement divided by 2π, as for light damping", || decrement / TAU);
    let overshoot = || decrement / (decrement.powi(2) + PI * PI).sqrt();
    let what = "the formula for the overshoot after half a cycle used for a whole cycle";
    sheet.common_error(symbol, what, overshoot);
}
