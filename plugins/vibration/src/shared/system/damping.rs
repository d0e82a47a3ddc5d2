//! Damping of a system, and the damping ratios of its modes.

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    vibration::modes::{NaturalModes, is_proportional},
};
use nalgebra::DMatrix;

use crate::sources::RAO;

/// Common errors of the coefficients of Rayleigh damping.
pub(crate) const ONE_TERM: &str =
    "the coefficient found from one mode, the other term of the damping left out";
pub(crate) const MEAN_RATIO: &str = "the mean damping ratio used for both modes";

/// Damping of the system.
#[derive(Clone, Debug, Inputs)]
pub enum SystemDamping {
    /// The dampers of the system, if any
    Dampers,
    /// The same damping ratio in every mode
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// A damping ratio for each mode
    Ratios {
        /// Damping ratios.
        /// One per line, from the lowest mode up; the last applies to all higher modes.
        #[input(table)]
        ratios: Vec<ModeRatio>,
    },
    /// Rayleigh damping C = αM + βK
    Rayleigh {
        /// Mass-proportional coefficient.
        #[input("α", "1/s", nonnegative)]
        alpha: f64,
        /// Stiffness-proportional coefficient.
        #[input("β", "s", nonnegative)]
        beta: f64,
    },
    /// Rayleigh damping through two points
    TwoPoints {
        /// Damping ratio at the first frequency.
        #[input("ζ_a", "1", nonnegative)]
        first_ratio: f64,
        /// First frequency.
        #[input("ω_a", "rad/s", positive)]
        first_frequency: f64,
        /// Damping ratio at the second frequency.
        #[input("ζ_b", "1", nonnegative)]
        second_ratio: f64,
        /// Second frequency.
        #[input("ω_b", "rad/s", positive)]
        second_frequency: f64,
    },
}

/// The damping ratio of a mode.
#[derive(Clone, Debug, Inputs)]
pub struct ModeRatio {
    /// Damping ratio.
    #[input("ζ", "1", nonnegative)]
    pub ratio: f64,
}

/// The damping of a system in its modes.
pub(crate) struct ModalDamping {
    /// `ΦᵀCΦ` for unit modal masses.
    pub(crate) matrix: DMatrix<f64>,
    /// The damping matrix itself.
    pub(crate) physical: DMatrix<f64>,
    /// True for proportional damping: the undamped modes remain.
    pub(crate) proportional: bool,
}

impl ModalDamping {
    /// Returns true if there is any damping.
    pub(crate) fn any(&self) -> bool {
        self.matrix.iter().any(|entry| *entry != 0.0)
    }

    /// 2ζω of a mode, where the damping is proportional.
    pub(crate) fn decay(&self, mode: usize) -> f64 {
        self.matrix[(mode, mode)]
    }

    /// All 2ζω.
    pub(crate) fn decays(&self) -> Vec<f64> {
        self.matrix.diagonal().iter().copied().collect()
    }
}

/// The damping in the modes; writes α and β where they follow from two points.
pub(crate) fn in_modes<W: Worksheet>(
    damping: &SystemDamping,
    given: &SystemDampingGiven<W>,
    dampers: &DMatrix<f64>,
    mass: &DMatrix<f64>,
    modes: &NaturalModes,
    sheet: W,
) -> Result<ModalDamping, Refusal> {
    let n = modes.squares.len();
    let damped = match decays(damping, given, &modes.squares, sheet)? {
        Some(decays) => {
            let matrix = DMatrix::from_fn(n, n, |i, j| if i == j { decays[i] } else { 0.0 });
            let momenta = mass * &modes.shapes;
            let physical = &momenta * &matrix * momenta.transpose();
            ModalDamping { matrix, physical, proportional: true }
        }
        None => {
            let mut matrix = modes.damping(dampers);
            let proportional = is_proportional(&matrix);
            if proportional {
                matrix = DMatrix::from_diagonal(&matrix.diagonal());
            }
            ModalDamping { matrix, physical: dampers.clone(), proportional }
        }
    };
    if damped.physical.iter().all(|entry| entry.is_finite()) {
        return Ok(damped);
    }
    Err(Refusal::because("these inputs lead to a damping that cannot be represented"))
}

/// 2ζω of modes with these squares of their frequencies; `None` where it follows from dampers. Writes α and β where they
/// follow from two points.
pub(crate) fn decays<W: Worksheet>(
    damping: &SystemDamping,
    given: &SystemDampingGiven<W>,
    squares: &[f64],
    sheet: W,
) -> Result<Option<Vec<f64>>, Refusal> {
    let rayleigh =
        |alpha: f64, beta: f64| squares.iter().map(|square| alpha + beta * square).collect::<Vec<f64>>();
    Ok(Some(match (damping, given) {
        (SystemDamping::Dampers, _) => return Ok(None),
        (SystemDamping::Ratio { ratio }, _) => {
            squares.iter().map(|square| 2.0 * ratio * square.sqrt()).collect()
        }
        (SystemDamping::Ratios { ratios }, _) => {
            let ratio = |mode: usize| ratios[mode.min(ratios.len() - 1)].ratio;
            squares.iter().enumerate().map(|(mode, square)| 2.0 * ratio(mode) * square.sqrt()).collect()
        }
        (SystemDamping::Rayleigh { alpha, beta }, _) => rayleigh(*alpha, *beta),
        (
            SystemDamping::TwoPoints { first_frequency: a, second_frequency: b, .. },
            SystemDampingGiven::TwoPoints { first_ratio, first_frequency, second_ratio, second_frequency },
        ) => {
            if a == b {
                return Err(Refusal::because(
                    "the two frequencies of the Rayleigh damping are the same: write two different ones",
                ));
            }
            let (z1, w1, z2, w2) = (*first_ratio, *first_frequency, *second_ratio, *second_frequency);
            sheet.common_error("β", ONE_TERM, || z2 * 2.0 / w2);
            sheet.common_error("β", MEAN_RATIO, || (z1 + z2) / (w1 + w2));
            let beta = sheet.step(
                "β",
                "s",
                (z2 * w2 - z1 * w1) * 2.0 / (w2.powi(2) - w1.powi(2)),
                ("Rayleigh damping has ζ = α/(2ω) + βω/2; from the two points", RAO.at("§6.15")),
            );
            sheet.common_error("α", MEAN_RATIO, || (z1 + z2) * w1 * w2 / (w1 + w2));
            let alpha =
                sheet.step("α", "1/s", z1 * w1 * 2.0 - beta * w1.powi(2), "From the first of the two points");
            if alpha.value() < 0.0 || beta.value() < 0.0 {
                sheet.warn(|| {
                    Text::new(
                        "α or β is negative: between the two frequencies the damping fits, outside them it becomes negative and the motion grows",
                    )
                });
            }
            sheet.check("Rayleigh damping at the second point", alpha / w2 / 2.0 + beta * w2 / 2.0, z2);
            rayleigh(alpha.value(), beta.value())
        }
        _ => unreachable!("what is given is made from the damping"),
    }))
}
