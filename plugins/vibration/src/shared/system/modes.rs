//! The natural modes of a system as the analyses show them.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    vibration::modes::{ModesError, NaturalModes, natural_modes},
};
use dalembert_numerics::linalg::LinalgError;
use nalgebra::DMatrix;

use super::{
    Assembled,
    two_degrees::{self, TwoModes},
};
use crate::sources::RAO;

/// Eigenvalues that differ by no more of themselves count as equal.
const COINCIDING: f64 = 1e-10;
/// So many modes are written out.
pub(crate) const SHOWN: usize = 8;

/// Message for a system without modes.
pub(crate) fn refusal(error: ModesError) -> Refusal {
    match error {
        ModesError::Unstable { .. } => Refusal::because(
            "the stiffness matrix is indefinite: the rest position is unstable and does not vibrate",
        ),
        ModesError::Linalg(LinalgError::NotPositiveDefinite { .. }) => Refusal::because(
            "the mass matrix is not positive definite: some motion has no kinetic energy, so it has no frequency",
        ),
        ModesError::Linalg(LinalgError::NotSymmetric { row, column, .. }) => {
            let why = Text::new(
                "the entries ({row}, {column}) and ({column}, {row}) differ: the matrices of masses, springs and \
                 dampers are symmetric",
            );
            Refusal::because(why.with("row", row).with("column", column))
        }
        ModesError::Linalg(LinalgError::NotFinite) => {
            Refusal::because("masses, springs and dampers differ so much in magnitude that numbers overflow")
        }
        ModesError::Linalg(_) => Refusal::because("the modes cannot be computed with sufficient accuracy"),
    }
}

/// Modes and frequencies, with the steps that lead to them.
pub(crate) struct WorkedModes<N> {
    pub(crate) modes: NaturalModes,
    /// ω of the first modes, at most [`SHOWN`].
    pub(crate) frequencies: Vec<N>,
}

/// Finds the modes: two degrees of freedom in closed form, more numerically.
pub(crate) fn find<W: Worksheet>(
    system: &Assembled<W::Num>,
    sheet: W,
) -> Result<WorkedModes<W::Num>, Refusal> {
    let modes = natural_modes(&system.mass, &system.stiffness).map_err(refusal)?;
    let frequencies = match system.two {
        Some((masses, stiffness)) => {
            let two = two_degrees::solve(masses, stiffness, "1", sheet)?;
            sheet.verify(|| agreement(&two, &modes, sheet));
            two.frequencies.to_vec()
        }
        None => frequencies(&modes, sheet),
    };
    sheet.verify(|| {
        let shapes = &modes.shapes;
        let products = [&system.mass, &system.stiffness].map(|matrix| shapes.transpose() * matrix * shapes);
        let largest = modes.squares.last().copied().unwrap_or(0.0);
        checks(&products, largest, &frequencies, sheet);
    });
    coinciding(&modes, sheet);
    Ok(WorkedModes { modes, frequencies })
}

/// The natural frequencies of the first modes, as roots of the frequency equation.
pub(crate) fn frequencies<W: Worksheet>(modes: &NaturalModes, sheet: W) -> Vec<W::Num> {
    (0..modes.squares.len().min(SHOWN)).map(|mode| frequency(modes, mode, sheet)).collect()
}

fn frequency<W: Worksheet>(modes: &NaturalModes, mode: usize, sheet: W) -> W::Num {
    let square = modes.squares[mode];
    let why = if square == 0.0 {
        Text::new("Rigid body mode: the system moves as a whole, no spring is stretched")
    } else {
        Text::new("Eigenvalue, λ = ω²: root of det(K − λM) = 0, found numerically")
    };
    let square = sheet.numerical(("λ", mode + 1), "rad^2/s^2", square, (why, RAO.at("§6.10")));
    sheet.step(("ω", mode + 1), "rad/s", square.sqrt(), "Natural frequency")
}

/// The highest natural frequency of a system, which is not among those of the first modes where it has more than
/// [`SHOWN`].
pub(crate) fn highest_frequency<W: Worksheet>(found: &WorkedModes<W::Num>, sheet: W) -> W::Num {
    let last = found.modes.squares.len() - 1;
    found.frequencies.get(last).copied().unwrap_or_else(|| frequency(&found.modes, last, sheet))
}

/// Warns of modes of one frequency.
pub(crate) fn coinciding<W: Worksheet>(modes: &NaturalModes, sheet: W) {
    let same = (1..modes.squares.len()).find(|&mode| {
        let (a, b) = (modes.squares[mode - 1], modes.squares[mode]);
        b > 0.0 && (b - a) <= COINCIDING * b
    });
    if let Some(mode) = same {
        sheet.warn(|| {
            Text::new(
                "modes {first} and {second} have the same frequency: any linear combination of their shapes is also a mode",
            )
            .with("first", mode)
            .with("second", mode + 1)
        });
    }
}

/// The closed form of two degrees of freedom against the eigenproblem.
pub(crate) fn agreement<W: Worksheet>(two: &TwoModes<W::Num>, modes: &NaturalModes, sheet: W) {
    for (mode, frequency) in two.frequencies.iter().enumerate() {
        sheet.check(
            Text::new("frequency {mode} from the eigenvalues of M⁻¹K").with("mode", mode + 1),
            *frequency,
            modes.squares[mode].sqrt().into(),
        );
    }
    let Some(ratios) = two.ratios else { return };
    let gap = (modes.squares[1] - modes.squares[0]).abs() / modes.squares[1];
    // Of coinciding frequencies, which the eigenproblem takes for equal, any two shapes span the same plane: there is
    // nothing to compare.
    if gap <= COINCIDING {
        return;
    }
    for (mode, ratio) in ratios.iter().enumerate() {
        let shape = modes.shapes.column(mode);
        let second = ratio.value() * shape[0];
        // Rounding turns the modes into each other by its share of the gap between their eigenvalues, and the ratio loses
        // as much.
        let turned = f64::EPSILON / gap;
        let rows = [0, 1].map(|row| modes.shapes.row(row).norm());
        let error = turned * (ratio.value().abs() * rows[0] + rows[1] + second.abs());
        sheet.check_residual(
            Text::new("mode shape {mode} from the eigenvectors of M⁻¹K").with("mode", mode + 1),
            (second - shape[1]).into(),
            second.abs().max(shape[1].abs()),
            error,
        );
    }
}

/// Orthogonality in M and in K, and the energy of each mode, by `ΦᵀMΦ` and `ΦᵀKΦ`; `largest` is the largest ω² of the system.
pub(crate) fn checks<W: Worksheet>(
    [mass, stiffness]: &[DMatrix<f64>; 2],
    largest: f64,
    frequencies: &[W::Num],
    sheet: W,
) {
    let n = mass.ncols();
    let off_diagonal = |a: &DMatrix<f64>| {
        (0..n).flat_map(|j| (0..j).map(move |i| (i, j))).map(|at| a[at].abs()).fold(0.0, f64::max)
    };
    sheet.check_zero(
        "the modes are orthogonal with respect to the mass matrix: φᵢᵀMφⱼ = 0",
        off_diagonal(mass).into(),
        1.0,
    );
    if largest > 0.0 {
        sheet.check_zero(
            "the modes are orthogonal with respect to the stiffness matrix: φᵢᵀKφⱼ = 0",
            off_diagonal(stiffness).into(),
            largest,
        );
    }
    for (mode, frequency) in frequencies.iter().enumerate().take(SHOWN) {
        let square = frequency.value().powi(2);
        if square > 1e-6 * largest {
            sheet.check(
                Text::new("mode {mode}: maximum potential energy φᵀKφ/2 = maximum kinetic energy ω²φᵀMφ/2")
                    .with("mode", mode + 1),
                stiffness[(mode, mode)].into(),
                frequency.powi(2) * mass[(mode, mode)],
            );
        }
    }
}

/// A mode shape with its largest entry 1, the first one of those.
pub(crate) fn largest_one(shape: &[f64]) -> Vec<f64> {
    let largest = shape.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let lead = shape.iter().copied().find(|x| x.abs() >= largest * (1.0 - 1e-9)).unwrap_or(1.0);
    shape.iter().map(|x| x / lead).collect()
}
