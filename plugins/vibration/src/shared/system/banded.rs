//! Systems of many degrees of freedom by the bands of their matrices: the lowest modes alone.

use dalembert_core::Refusal;
use dalembert_numerics::linalg::{LinalgError, SymmetricBand};
use nalgebra::{DMatrix, DVector};

use super::{Entry, System, SystemMatrices, at_most, chain_entries, has_masses, symmetric};

/// The most degrees of freedom whose modes are found from full matrices: all of them, and at every key.
pub(crate) const MOST_FULL: usize = 100;
/// The most degrees of freedom.
const MOST_BANDED: usize = 100_000;
/// The most entries of a row beside the diagonal, to one side.
const WIDEST: usize = 60;

/// The matrices of a system by their bands.
pub(crate) struct BandedSystem {
    pub(crate) mass: SymmetricBand,
    pub(crate) damping: SymmetricBand,
    pub(crate) stiffness: SymmetricBand,
    parallel: bool,
}

impl SystemMatrices for BandedSystem {
    fn size(&self) -> usize {
        self.mass.size()
    }

    fn is_parallel(&self) -> bool {
        self.parallel
    }

    fn momenta(&self, shape: &DVector<f64>) -> DVector<f64> {
        times(&self.mass, shape)
    }

    fn stiffness_product(&self, shape: &DVector<f64>) -> (f64, f64) {
        self.stiffness.energy(shape.as_slice())
    }
}

impl BandedSystem {
    /// `ΦᵀAΦ` of the mass and the stiffness matrix.
    pub(crate) fn products(&self, shapes: &DMatrix<f64>) -> [DMatrix<f64>; 2] {
        [&self.mass, &self.stiffness].map(|matrix| {
            let columns: Vec<DVector<f64>> =
                shapes.column_iter().map(|shape| times(matrix, &shape.into_owned())).collect();
            shapes.transpose() * DMatrix::from_columns(&columns)
        })
    }

    /// An upper bound of ω²: that of Gershgorin's circles for a diagonal mass matrix.
    pub(crate) fn largest_square(&self) -> f64 {
        (0..self.size())
            .map(|row| 2.0 * self.stiffness.get(row, row) / self.mass.get(row, row))
            .fold(0.0, f64::max)
    }
}

/// `A x`.
fn times(matrix: &SymmetricBand, x: &DVector<f64>) -> DVector<f64> {
    let mut product = DVector::zeros(x.len());
    matrix.multiply(x.as_slice(), product.as_mut_slice());
    product
}

/// Number of degrees of freedom, as far as the inputs tell it.
pub(crate) fn size(system: &System) -> usize {
    match system {
        System::Chain { masses, .. } => masses.len(),
        System::String { masses, .. } => masses.len(),
        System::Uniform { count, .. } => *count,
        System::Matrices { entries } => {
            entries.iter().map(|entry| entry.row.max(entry.column)).fold(0.0, f64::max) as usize
        }
    }
}

/// The bands of a system of more than [`MOST_FULL`] degrees of freedom; `None` for a smaller one, and for one whose
/// entries lie far beside the diagonal.
///
/// # Errors
/// Too many degrees of freedom; a table of matrices that is none.
pub(crate) fn banded(system: &System) -> Result<Option<BandedSystem>, Refusal> {
    let n = size(system);
    if n <= MOST_FULL {
        return Ok(None);
    }
    at_most(n, MOST_BANDED)?;
    let spring = |value: Option<f64>| value.unwrap_or(0.0);
    match system {
        System::Chain { masses, wall } => {
            let of = |own: &dyn Fn(usize) -> f64, ground: &dyn Fn(usize) -> f64, last: f64| {
                chain(n, |place| if place < n { own(place) } else { last }, ground)
            };
            let springs = wall.as_ref().map_or(0.0, |wall| spring(wall.spring));
            let dampers = wall.as_ref().map_or(0.0, |wall| spring(wall.damper));
            let stiffness =
                of(&|at| spring(masses[at].spring), &|at| spring(masses[at].ground_spring), springs);
            let damping =
                of(&|at| spring(masses[at].damper), &|at| spring(masses[at].ground_damper), dampers);
            Ok(Some(in_a_row(&masses.iter().map(|mass| mass.mass).collect::<Vec<_>>(), stiffness, damping)?))
        }
        System::Uniform { mass, spring: stiffness, damper, ends, .. } => {
            let of = |each: f64| chain(n, |place| if ends.hold(place, n) { each } else { 0.0 }, &|_| 0.0);
            Ok(Some(in_a_row(&vec![*mass; n], of(*stiffness), of(spring(*damper)))?))
        }
        System::String { tension, masses, last } => {
            let length = |place: usize| masses.get(place).map_or(*last, |mass| mass.length);
            let stiffness = chain(n, |place| tension / length(place), &|_| 0.0);
            let none = chain(n, |_| 0.0, &|_| 0.0);
            Ok(Some(in_a_row(&masses.iter().map(|mass| mass.mass).collect::<Vec<_>>(), stiffness, none)?))
        }
        System::Matrices { entries } => matrices(entries, n),
    }
}

/// The band of springs, or dampers, in a row: `link` joins a mass to the one before it or to a wall, `ground` to the ground.
fn chain(
    n: usize,
    link: impl Fn(usize) -> f64,
    ground: &dyn Fn(usize) -> f64,
) -> Result<SymmetricBand, LinalgError> {
    let mut band = SymmetricBand::zeros(n, 1)?;
    chain_entries(n, link, ground).for_each(|(row, column, value)| band.add(row, column, value));
    Ok(band)
}

fn in_a_row(
    masses: &[f64],
    stiffness: Result<SymmetricBand, LinalgError>,
    damping: Result<SymmetricBand, LinalgError>,
) -> Result<BandedSystem, Refusal> {
    let mass = SymmetricBand::diagonal(masses);
    let (mass, stiffness, damping) =
        (mass.map_err(refusal)?, stiffness.map_err(refusal)?, damping.map_err(refusal)?);
    Ok(BandedSystem { mass, damping, stiffness, parallel: true })
}

fn refusal(_: LinalgError) -> Refusal {
    Refusal::because("the modes cannot be computed with sufficient accuracy")
}

/// The bands of a table of entries, each of which may be listed with its mirror image.
fn matrices(entries: &[Entry], n: usize) -> Result<Option<BandedSystem>, Refusal> {
    let is_place = |number: f64| number.fract() == 0.0 && number >= 1.0;
    // What is wrong with the entries is said where full matrices are made of them.
    if entries.iter().any(|entry| !is_place(entry.row) || !is_place(entry.column)) {
        return Ok(None);
    }
    let width = entries.iter().map(|entry| (entry.row - entry.column).abs() as usize).max().unwrap_or(0);
    if width > WIDEST {
        return Ok(None);
    }
    let empty = || SymmetricBand::zeros(n, width).map_err(refusal);
    let mut bands = [empty()?, empty()?, empty()?];
    for (row, column, values) in symmetric(entries)? {
        bands.iter_mut().zip(values).for_each(|(band, value)| band.add(row, column, value));
    }
    let [mass, damping, stiffness] = bands;
    has_masses(n, |row| mass.get(row, row))?;
    Ok(Some(BandedSystem { mass, damping, stiffness, parallel: false }))
}
