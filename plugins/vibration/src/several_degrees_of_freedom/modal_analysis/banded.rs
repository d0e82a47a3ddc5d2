//! Modal analysis of large systems: the lowest modes by the bands of the matrices.

use dalembert_core::{Exhibit, Refusal, Text, Worksheet};
use dalembert_mechanics::vibration::modes::NaturalModes;
use dalembert_numerics::linalg::{LinalgError, lowest_modes};

use super::{LISTED, ModalAnalysis, ModalAnalysisGiven, nodes, plot_of_shapes, table_of_frequencies};
use crate::shared::system::{
    MOST, SystemMatrices as _,
    banded::BandedSystem,
    damping::decays,
    modal_properties::{masses, ratios},
    modes::{SHOWN, WorkedModes, checks, coinciding, frequencies, refusal},
    picture,
};

/// The share of the largest entry of C by which dampers may be out of proportion to masses and springs.
const COUPLED: f64 = 1e-12;

impl ModalAnalysis {
    /// Writes the lowest modes of a large system. False where its dampers couple the modes, so that they are found from full
    /// matrices.
    ///
    /// # Errors
    /// A system without modes; dampers that couple the modes of a system that is too large for full matrices.
    pub(super) fn solve_banded<W: Worksheet>(
        &self,
        given: &ModalAnalysisGiven<W>,
        system: &BandedSystem,
        sheet: W,
    ) -> Result<bool, Refusal> {
        let n = system.size();
        let modes = lowest(system)?;
        let decays = match decays(&self.damping, &given.damping, &modes.squares, sheet)? {
            Some(decays) => decays,
            None => match of_dampers(system, &modes) {
                Some(decays) => decays,
                None if n <= MOST => return Ok(false),
                None => {
                    let why = Text::new(
                        "the dampers couple the modes: their complex modes are found of at most {most} degrees of freedom; enter damping ratios or Rayleigh damping",
                    );
                    return Err(Refusal::because(why.with("most", MOST)));
                }
            },
        };
        let frequencies = frequencies(&modes, sheet);
        sheet.verify(|| {
            checks(&system.products(&modes.shapes), system.largest_square(), &frequencies, sheet);
        });
        coinciding(&modes, sheet);
        sheet.keep_going()?;
        let shapes = self.normalised(&modes.shapes)?;
        for (mode, frequency) in frequencies.iter().enumerate() {
            sheet.answer(("frequency", mode + 1), "Natural frequency", *frequency);
        }
        for (mode, shape) in shapes.iter().enumerate().filter(|_| n <= LISTED) {
            sheet.answer_list(("mode", mode + 1), "Mode shape", "1", shape);
            let nodes = if system.is_parallel() { nodes(shape) } else { Vec::new() };
            if !nodes.is_empty() {
                sheet.answer_list(("nodes", mode + 1), "Nodes (position in mass spacings)", "1", &nodes);
            }
        }
        let found = WorkedModes { modes, frequencies };
        masses(system, &found, &shapes, sheet);
        let is_damped = decays.iter().any(|decay| *decay > 0.0);
        if is_damped {
            ratios(&found, &decays, sheet);
        }
        sheet.show(|| Exhibit::Drawing(picture::at_rest(&self.system, &[])));
        sheet.show(|| Exhibit::Plot(plot_of_shapes(&shapes)));
        sheet.show(|| {
            Exhibit::Table(table_of_frequencies(&found.modes.squares, is_damped.then_some(&decays)))
        });
        Ok(true)
    }
}

/// The lowest modes, with `φᵀMφ = 1`.
fn lowest(system: &BandedSystem) -> Result<NaturalModes, Refusal> {
    let found = lowest_modes(&system.stiffness, &system.mass, SHOWN).map_err(|error| match error {
        LinalgError::NotPositiveDefinite { matrix: "stiffness", .. } => Refusal::because(
            "the stiffness matrix is indefinite: the rest position is unstable and does not vibrate",
        ),
        error => refusal(error.into()),
    })?;
    // What is below rounding of the largest entry is the frequency of a motion as a whole.
    let rounding = 1e-14 * system.largest_square() / system.size() as f64;
    let squares = found.values.iter().map(|square| if *square <= rounding { 0.0 } else { *square });
    Ok(NaturalModes { squares: squares.collect(), shapes: found.vectors })
}

/// 2ζω of the modes by dampers in proportion to masses and springs, `C = αM + βK` for every entry; `None` where they are not.
/// The modes themselves would tell less: the force of dampers in a low mode of a long chain is a small difference.
fn of_dampers(system: &BandedSystem, modes: &NaturalModes) -> Option<Vec<f64>> {
    let BandedSystem { mass, damping, stiffness, .. } = system;
    let width = mass.width().max(damping.width()).max(stiffness.width());
    let entries = || {
        let places =
            (0..system.size()).flat_map(|row| (row.saturating_sub(width)..=row).map(move |at| (row, at)));
        places.map(|(row, at)| [mass, damping, stiffness].map(|matrix| matrix.get(row, at)))
    };
    let largest =
        entries().fold([0.0; 3], |most: [f64; 3], entry| [0, 1, 2].map(|n| most[n].max(entry[n].abs())));
    let [of_mass, of_damping, of_stiffness] = largest;
    if of_damping == 0.0 {
        return Some(vec![0.0; modes.squares.len()]);
    }
    // Least squares in matrices whose largest entry is 1.
    let (mut mm, mut mk, mut kk, mut mc, mut kc) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for [m, c, k] in entries() {
        let (m, c, k) = (m / of_mass, c / of_damping, k / of_stiffness);
        mm += m * m;
        mk += m * k;
        kk += k * k;
        mc += m * c;
        kc += k * c;
    }
    let determinant = mm * kk - mk * mk;
    let (alpha, beta) = if determinant > 1e-12 * mm * kk {
        ((mc * kk - kc * mk) / determinant, (kc * mm - mc * mk) / determinant)
    } else {
        (0.0, kc / kk)
    };
    let rest = |[m, c, k]: [f64; 3]| c / of_damping - alpha * m / of_mass - beta * k / of_stiffness;
    let is_proportional = entries().all(|entry| rest(entry).abs() <= COUPLED);
    let (alpha, beta) = (alpha * of_damping / of_mass, beta * of_damping / of_stiffness);
    is_proportional.then(|| modes.squares.iter().map(|square| (alpha + beta * square).max(0.0)).collect())
}
