//! A chain of masses on springs that stands on its base, with its modes written out.

use dalembert_core::{Inputs, Refusal, Sketch, Symbol, Worksheet};
use dalembert_mechanics::{
    Real,
    vibration::base_modes::{self, BaseMode},
};

use crate::{
    shared::{
        letters::of_row,
        oscillator::{Mass, mass},
    },
    sources::CHOPRA,
};

/// A mass and the spring that joins it to the one before, the first one to the base.
#[derive(Clone, Debug, Inputs)]
pub struct ChainMass {
    /// Mass.
    pub mass: Mass,
    /// Stiffness of its spring.
    /// Towards the previous mass, or the base.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
}

/// The most masses of a chain.
const MOST_LINKS: usize = 12;

/// A mode with its numbers on a worksheet.
pub(crate) struct WorkedMode<N> {
    /// Natural frequency.
    pub(crate) natural: N,
    /// `Γφᵢ` at each mass: the share of this mode in a unit displacement of all masses.
    pub(crate) shares: Vec<N>,
    /// The numbers themselves.
    pub(crate) numbers: BaseMode,
    /// The masses of the chain.
    pub(crate) masses: Vec<f64>,
}

/// Writes the natural frequencies and the shares of the modes in the motion of the base.
///
/// # Errors
/// No masses or too many; numbers that leave the range of the eigenvalue problem.
pub(crate) fn modes<W: Worksheet>(
    links: &[ChainMassGiven<W>],
    sheet: W,
) -> Result<Vec<WorkedMode<W::Num>>, Refusal> {
    if links.len() > MOST_LINKS {
        return Err(Refusal::because(
            "a chain of more than twelve masses is not written out here: join some of them",
        ));
    }
    let masses: Vec<W::Num> = links.iter().map(|link| mass(&link.mass, sheet)).collect();
    let weights: Vec<f64> = masses.iter().map(|mass| mass.value()).collect();
    let springs: Vec<f64> = links.iter().map(|link| link.stiffness.value()).collect();
    let found = base_modes::base_modes(&weights, &springs).map_err(|_| {
        Refusal::because("the modes of these masses and springs were not found: check their units")
    })?;
    let total: f64 = weights.iter().sum();
    let highest = found.last().map_or(0.0, |mode| mode.natural);
    let mut modes = Vec::new();
    for (n, numbers) in found.into_iter().enumerate() {
        let why = (
            "Natural frequency of this mode: an eigenvalue of the stiffness and mass matrices of the chain",
            CHOPRA.at("§10.2"),
        );
        let natural = sheet.numerical(Symbol::from("ω").row(n + 1), "rad/s", numbers.natural, why);
        let shares = numbers.shape.iter().enumerate().map(|(i, shape)| {
            let why = (
                "Modal contribution to the motion of this mass under base excitation: Γφ, with Γ = Σmφ/Σmφ²",
                CHOPRA.at("§13.1"),
            );
            let symbol = Symbol::from("Γφ").row(n + 1).row(i + 1);
            sheet.numerical(symbol, "1", numbers.participation * shape, why)
        });
        let shares = shares.collect();
        modes.push(WorkedMode { natural, shares, numbers, masses: weights.clone() });
    }
    sheet.verify(|| {
        for i in 0..links.len() {
            let shares: f64 = modes.iter().map(|mode| mode.shares[i].value()).sum();
            let what = "the contributions of all modes to the motion of a mass sum to one";
            sheet.check(what, shares.into(), W::Num::from(1.0));
        }
    });
    let mut together = W::Num::from(0.0);
    for (n, mode) in modes.iter().enumerate() {
        let symbol = Symbol::from("f_n").row(n + 1);
        let alone = || (links[n].stiffness / masses[n]).sqrt();
        sheet.common_error(symbol, "each mass taken alone on its own spring", alone);
        if n == 0 {
            let lumped = || (links[0].stiffness / W::Num::sum(masses.iter().copied())).sqrt();
            sheet.common_error(symbol, "all masses taken together on the first spring", lumped);
            let one = W::Num::from(1.0);
            let soft = || W::Num::sum(links.iter().map(|link| one / link.stiffness));
            let series = || (one / soft() / W::Num::sum(masses.iter().copied())).sqrt();
            sheet.common_error(symbol, "all masses taken together on the springs in series", series);
        }
        let frequency = sheet.step(symbol, "Hz", mode.natural, "The same in Hz");
        sheet.answer(("frequency", n + 1), "Natural frequency", frequency);
        sheet.verify(|| {
            let walk =
                |by: f64| base_modes::holzer_residual(&weights, &springs, frequency.value() * (1.0 + by));
            let residual = walk(0.0);
            // All eigenvalues are known to the last places of the largest.
            let doubt = f64::EPSILON * links.len() as f64 * (highest / mode.numbers.natural).powi(2);
            let error = (walk(doubt) - residual).abs().max((walk(-doubt) - residual).abs());
            let what =
                "the base is at rest when Holzer's table is evaluated along the chain at this frequency";
            sheet.check_residual(what, residual.into(), 1.0, error);
        });
        let mass = mode.numbers.participation.powi(2) / total;
        let why = (
            "Effective mass of the mode over the whole mass: how much of it moves with the base",
            CHOPRA.at("§13.2"),
        );
        let mass = sheet.numerical(Symbol::from("μ").row(n + 1), "%", mass, why);
        sheet.answer(("effective_mass", n + 1), "Effective mass of the mode", mass);
        together = together + mass;
    }
    sheet.check("the contributions of all modes to the total mass sum to one", together, W::Num::from(1.0));
    Ok(modes)
}

/// Holds the displacements of the masses in a mode, each of them in every mode, to the equations of motion
/// `mᵢω²xᵢ = kᵢ(xᵢ − xᵢ₋₁) − kᵢ₊₁(xᵢ₊₁ − xᵢ)`.
pub(crate) fn check_motions<W: Worksheet>(
    links: &[ChainMassGiven<W>],
    modes: &[WorkedMode<W::Num>],
    moved: &[Vec<W::Num>],
    sheet: W,
) {
    let springs: Vec<f64> = links.iter().map(|link| link.stiffness.value()).collect();
    let highest = modes.iter().fold(0.0, |highest: f64, mode| highest.max(mode.natural.value()));
    for (n, mode) in modes.iter().enumerate() {
        let x: Vec<f64> = moved.iter().map(|parts| parts[n].value()).collect();
        // Displacements times the root of the mass, in which the matrix of the modes is symmetric.
        let root = |i: usize| mode.masses[i].sqrt();
        let size = x.iter().enumerate().fold(0.0, |size: f64, (i, x)| size.max(root(i) * x.abs()));
        let residuals = (0..x.len()).map(|i| {
            let before = if i == 0 { 0.0 } else { x[i - 1] };
            let after = x.get(i + 1).map_or(0.0, |after| springs[i + 1] * (after - x[i]));
            let inertia = mode.masses[i] * mode.natural.value().powi(2) * x[i];
            (inertia - springs[i] * (x[i] - before) + after) / root(i)
        });
        let what = "displacements of a mode: inertia and springs balance at every mass";
        sheet.check_zeros(what, residuals, size * highest.powi(2));
    }
}

impl ChainMass {
    /// The letter of its mass, or of its weight.
    fn letter(&self) -> &'static str {
        match self.mass {
            Mass::Mass { .. } => "m",
            Mass::Weight { .. } => "W",
        }
    }
}

/// A chain as a building: floors that carry the masses, on columns, from the moving base.
pub(crate) fn drawing(links: &[ChainMass]) -> Sketch {
    const FLOORS: usize = 8;
    let mut sketch = Sketch::new("The chain as a building on its moving base");
    let (half, storey, thick) = (1.6, 1.3, 0.45);
    sketch.ground((-2.0, 0.0), (2.0, 0.0)).motion("ÿ(t)", (-3.4, -0.15), (-2.4, -0.15));
    for (link, row) in links.iter().take(FLOORS).zip(1..) {
        let (low, high) = (storey * (row - 1) as f64, storey * row as f64);
        let foot = if row == 1 { low } else { low + thick };
        for side in [-0.85, 0.85] {
            sketch.bars([(side * half, foot), (side * half, high)]);
        }
        sketch
            .mass(of_row(&[link.letter()], row), (-half, high), (half, high + thick))
            .label(of_row(&["k"], row), (0.85 * half, f64::midpoint(foot, high)))
            .motion(of_row(&["x"], row), (half + 0.2, high + thick / 2.0), (half + 0.9, high + thick / 2.0));
    }
    sketch
}
