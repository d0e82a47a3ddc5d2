//! Systems of many degrees of freedom: how they are given, their matrices, their pictures.

use std::collections::HashMap;

use dalembert_core::{Inputs, Refusal, Symbol, Text, Worksheet};
use dalembert_mechanics::Real;
use dalembert_numerics::linalg::MOST_DENSE;
use nalgebra::{DMatrix, DVector};

pub(crate) mod banded;
pub(crate) mod damping;
pub(crate) mod excitation;
pub(crate) mod histories;
pub(crate) mod modal_properties;
pub(crate) mod modes;
pub(crate) mod picture;
pub(crate) mod two_degrees;

use crate::sources::RAO;

/// Up to so many degrees of freedom the entries of the matrices are written out.
const WRITTEN: usize = 3;

/// The most degrees of freedom of full matrices, which are solved again at every key.
pub(crate) const MOST: usize = 500;

/// Vibrating system.
#[derive(Clone, Debug, Inputs)]
pub enum System {
    /// Chain of masses, springs and dampers
    Chain {
        /// Masses.
        /// From left to right. The spring and the damper of a mass connect it to the previous mass; those of the first
        /// mass, to the wall on the left.
        #[input(min = 1)]
        masses: Vec<ChainMass>,
        /// Wall on the right.
        wall: Option<Wall>,
    },
    /// Equal masses, springs and dampers in a chain
    Uniform {
        /// Number of masses.
        #[input(min = 1, max = 100000)]
        count: usize,
        /// Mass of each.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Stiffness of each spring.
        #[input("k", "N/m", positive)]
        spring: f64,
        /// Damping coefficient of each damper.
        #[input("c", "N*s/m", nonnegative)]
        damper: Option<f64>,
        /// Ends.
        ends: ChainEnds,
    },
    /// Masses on a stretched string
    String {
        /// Tension.
        #[input("T", "N", positive)]
        tension: f64,
        /// Masses.
        /// From left to right, each with the length of string before it.
        #[input(min = 1)]
        masses: Vec<StringMass>,
        /// Length after the last mass.
        #[input("l_e", "m", positive)]
        last: f64,
    },
    /// Mass, damping and stiffness matrices
    Matrices {
        /// Matrix entries.
        /// Row, column, mass, damping, stiffness. Entries not listed are zero; an off-diagonal entry also applies to its
        /// mirror image. Angles are written in SI as if they were lengths.
        #[input(table)]
        entries: Vec<Entry>,
    },
}

/// End conditions of a chain of equal masses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum ChainEnds {
    /// Springs to a wall at both ends
    BothFixed,
    /// Spring to a wall before the first mass, last mass free
    FirstFixed,
    /// Both ends free
    Free,
}

impl ChainEnds {
    /// Returns true if there is a spring at a place: 0 lies before the first mass.
    pub(crate) fn hold(self, place: usize, masses: usize) -> bool {
        match self {
            ChainEnds::BothFixed => true,
            ChainEnds::FirstFixed => place < masses,
            ChainEnds::Free => place > 0 && place < masses,
        }
    }
}

/// A mass of a chain, with what holds it.
#[derive(Clone, Debug, Inputs)]
pub struct ChainMass {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Spring to the previous mass.
    /// To the wall, for the first one.
    #[input("k", "N/m", nonnegative)]
    pub spring: Option<f64>,
    /// Damper to the previous mass.
    #[input("c", "N*s/m", nonnegative)]
    pub damper: Option<f64>,
    /// Spring to the ground.
    #[input("k_g", "N/m", nonnegative)]
    pub ground_spring: Option<f64>,
    /// Damper to the ground.
    #[input("c_g", "N*s/m", nonnegative)]
    pub ground_damper: Option<f64>,
}

/// Connection of the last mass to a wall.
#[derive(Clone, Debug, Inputs)]
pub struct Wall {
    /// Spring to the wall on the right.
    #[input("k_w", "N/m", nonnegative)]
    pub spring: Option<f64>,
    /// Damper to the wall on the right.
    #[input("c_w", "N*s/m", nonnegative)]
    pub damper: Option<f64>,
}

/// A mass on a string.
#[derive(Clone, Debug, Inputs)]
pub struct StringMass {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Length of string before it.
    #[input("l", "m", positive)]
    pub length: f64,
}

/// An entry of the three matrices.
#[derive(Clone, Debug, Inputs)]
pub struct Entry {
    /// Row.
    #[input("i", "1", min = 1)]
    pub row: f64,
    /// Column.
    #[input("j", "1", min = 1)]
    pub column: f64,
    /// Mass.
    #[input("m", "kg")]
    pub mass: f64,
    /// Damping.
    #[input("c", "N*s/m")]
    pub damping: f64,
    /// Stiffness.
    #[input("k", "N/m")]
    pub stiffness: f64,
}

/// The matrices of a system and, where they are written out, the numbers of their entries.
pub(crate) struct Assembled<N> {
    pub(crate) mass: DMatrix<f64>,
    pub(crate) damping: DMatrix<f64>,
    pub(crate) stiffness: DMatrix<f64>,
    /// Two masses and the entries K₁₁, K₁₂, K₂₂, for a system of two masses without a common inertia.
    pub(crate) two: Option<([N; 2], [N; 3])>,
    /// True if all coordinates are parallel displacements: a motion of the ground moves all alike.
    pub(crate) parallel: bool,
}

/// Products of the matrices of a system with displacements, whether they are full or banded.
pub(crate) trait SystemMatrices {
    /// Number of degrees of freedom.
    fn size(&self) -> usize;

    /// True if all coordinates are parallel displacements.
    fn is_parallel(&self) -> bool;

    /// `M x`.
    fn momenta(&self, shape: &DVector<f64>) -> DVector<f64>;

    /// `xᵀK x`, and the same with every term made positive: what rounding is measured by.
    fn stiffness_product(&self, shape: &DVector<f64>) -> (f64, f64);
}

impl<N> SystemMatrices for Assembled<N> {
    fn size(&self) -> usize {
        self.mass.nrows()
    }

    fn is_parallel(&self) -> bool {
        self.parallel
    }

    fn momenta(&self, shape: &DVector<f64>) -> DVector<f64> {
        &self.mass * shape
    }

    fn stiffness_product(&self, shape: &DVector<f64>) -> (f64, f64) {
        (shape.dot(&(&self.stiffness * shape)), shape.abs().dot(&(self.stiffness.abs() * shape.abs())))
    }
}

impl<N> Assembled<N> {
    pub(crate) fn size(&self) -> usize {
        self.mass.nrows()
    }
}

/// Connections of a mass: to the one before, and to the ground.
#[derive(Clone, Copy)]
struct Link<N> {
    spring: Option<N>,
    damper: Option<N>,
    ground_spring: Option<N>,
    ground_damper: Option<N>,
}

/// The matrices, with the steps that lead to their entries where they are few.
pub(crate) fn assemble<W: Worksheet>(
    system: &System,
    given: &SystemGiven<W>,
    sheet: W,
) -> Result<Assembled<W::Num>, Refusal> {
    match (system, given) {
        (System::Matrices { entries }, _) => matrices(entries, sheet),
        (_, SystemGiven::Chain { masses, wall }) => {
            let links: Vec<Link<W::Num>> = masses
                .iter()
                .map(|mass| Link {
                    spring: mass.spring,
                    damper: mass.damper,
                    ground_spring: mass.ground_spring,
                    ground_damper: mass.ground_damper,
                })
                .chain([Link {
                    spring: wall.as_ref().and_then(|wall| wall.spring),
                    damper: wall.as_ref().and_then(|wall| wall.damper),
                    ground_spring: None,
                    ground_damper: None,
                }])
                .collect();
            chain(&masses.iter().map(|mass| mass.mass).collect::<Vec<_>>(), &links, sheet)
        }
        (System::Uniform { count, ends, .. }, SystemGiven::Uniform { mass, spring, damper, .. }) => {
            let links: Vec<Link<W::Num>> = (0..=*count)
                .map(|place| {
                    let held = ends.hold(place, *count);
                    Link {
                        spring: held.then_some(*spring),
                        damper: damper.filter(|_| held),
                        ground_spring: None,
                        ground_damper: None,
                    }
                })
                .collect();
            chain(&vec![*mass; *count], &links, sheet)
        }
        (_, SystemGiven::String { tension, masses, last }) => {
            let lengths = masses.iter().map(|mass| mass.length).chain([*last]);
            let links: Vec<Link<W::Num>> = lengths
                .enumerate()
                .map(|(n, length)| Link {
                    spring: Some(sheet.step(
                        ("k", n + 1),
                        "N/m",
                        *tension / length,
                        (
                            "A taut string resists a small transverse offset between its ends with T/l",
                            RAO.at("§8.2"),
                        ),
                    )),
                    damper: None,
                    ground_spring: None,
                    ground_damper: None,
                })
                .collect();
            chain(&masses.iter().map(|mass| mass.mass).collect::<Vec<_>>(), &links, sheet)
        }
        (_, SystemGiven::Matrices { .. } | SystemGiven::Uniform { .. }) => {
            unreachable!("what is given is made from the system")
        }
    }
}

/// The matrices of masses in a row; one link more than masses, the last one to the wall.
fn chain<W: Worksheet>(
    masses: &[W::Num],
    links: &[Link<W::Num>],
    sheet: W,
) -> Result<Assembled<W::Num>, Refusal> {
    let n = masses.len();
    not_too_many(n)?;
    let value = |number: Option<W::Num>| number.map_or(0.0, Real::value);
    let fill = |own: fn(&Link<W::Num>) -> Option<W::Num>, ground: fn(&Link<W::Num>) -> Option<W::Num>| {
        full(n, chain_entries(n, |place| value(own(&links[place])), |place| value(ground(&links[place]))))
    };
    let mass = DMatrix::from_fn(n, n, |i, j| if i == j { masses[i].value() } else { 0.0 });
    let stiffness = fill(|link| link.spring, |link| link.ground_spring);
    let damping = fill(|link| link.damper, |link| link.ground_damper);
    let mut written = Vec::new();
    if (2..=WRITTEN).contains(&n) {
        for row in 0..n {
            let springs = [links[row].spring, links[row].ground_spring, links[row + 1].spring];
            written.push(sheet.step(
                symbol("K", row, row),
                "N/m",
                sum(springs),
                ("Stiffness matrix entry: force on the mass for its own unit displacement", RAO.at("§6.4")),
            ));
            if let (Some(spring), true) = (links[row + 1].spring, row + 1 < n) {
                written.push(sheet.step(
                    symbol("K", row, row + 1),
                    "N/m",
                    -spring,
                    "The force on a mass for a unit displacement of its neighbour",
                ));
            }
        }
    }
    let two = match (masses, &written[..]) {
        ([first, second], [k11, k12, k22]) => Some(([*first, *second], [*k11, *k12, *k22])),
        _ => None,
    };
    Ok(Assembled { mass, damping, stiffness, two, parallel: true })
}

/// The entries of the matrix of springs, or of dampers, in a row, each with its mirror image once: `link` joins a mass to
/// the one before it or to a wall, `ground` to the ground.
fn chain_entries(
    n: usize,
    link: impl Fn(usize) -> f64,
    ground: impl Fn(usize) -> f64,
) -> impl Iterator<Item = (usize, usize, f64)> {
    (0..n).flat_map(move |row| {
        let diagonal = (row, row, link(row) + ground(row) + link(row + 1));
        let beside = (row > 0).then(|| (row, row - 1, -link(row)));
        [diagonal].into_iter().chain(beside)
    })
}

/// The full symmetric matrix of entries that are listed with their mirror image once.
fn full(n: usize, entries: impl IntoIterator<Item = (usize, usize, f64)>) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(n, n);
    for (row, column, value) in entries {
        matrix[(row, column)] += value;
        if row != column {
            matrix[(column, row)] += value;
        }
    }
    matrix
}

/// The matrices from a table of entries.
fn matrices<W: Worksheet>(entries: &[Entry], sheet: W) -> Result<Assembled<W::Num>, Refusal> {
    let place = |number: f64| {
        if number.fract() == 0.0 && number >= 1.0 && number <= MOST_DENSE as f64 {
            Ok(number as usize - 1)
        } else {
            let why = Text::new(
                "{number} is not a row or column of a matrix: write whole numbers from 1 to {most}",
            );
            Err(Refusal::because(why.with("number", number.to_string()).with("most", MOST)))
        }
    };
    let mut n = 0;
    for entry in entries {
        n = n.max(place(entry.row)? + 1).max(place(entry.column)? + 1);
    }
    not_too_many(n)?;
    let listed = symmetric(entries)?;
    let [mass, damping, stiffness] =
        [0, 1, 2].map(|of| full(n, listed.iter().map(|(row, column, values)| (*row, *column, values[of]))));
    has_masses(n, |row| mass[(row, row)])?;
    let two = (n == 2 && mass[(0, 1)] == 0.0 && stiffness[(0, 1)] != 0.0).then(|| {
        let listed = |base, row, column, unit, value| {
            sheet.numerical(symbol(base, row, column), unit, value, "From the table of the matrices")
        };
        let masses = [0, 1].map(|row| listed("M", row, row, "kg", mass[(row, row)]));
        let places = [(0, 0), (0, 1), (1, 1)];
        (masses, places.map(|(row, column)| listed("K", row, column, "N/m", stiffness[(row, column)])))
    });
    Ok(Assembled { mass, damping, stiffness, two, parallel: false })
}

/// The entries of a table with their mirror image once, counted from 0: row, column, the values of the three matrices.
///
/// # Errors
/// An entry that is listed twice; one that differs from its mirror image.
fn symmetric(entries: &[Entry]) -> Result<Vec<(usize, usize, [f64; 3])>, Refusal> {
    let mut found = Vec::new();
    let mut listed = HashMap::new();
    for entry in entries {
        let (row, column) = (entry.row as usize - 1, entry.column as usize - 1);
        let values = [entry.mass, entry.damping, entry.stiffness];
        let at = |why: &'static str| {
            Refusal::because(Text::new(why).with("row", row + 1).with("column", column + 1))
        };
        if listed.insert((row, column), values).is_some() {
            return Err(at("the entry ({row}, {column}) is listed twice: keep one line for it"));
        }
        match listed.get(&(column, row)) {
            Some(mirrored) if row != column && *mirrored != values => {
                return Err(at(
                    "the entries ({row}, {column}) and ({column}, {row}) differ: the matrices of masses, springs and \
                     dampers are symmetric",
                ));
            }
            Some(_) if row != column => {}
            _ => found.push((row, column, values)),
        }
    }
    Ok(found)
}

/// Refuses a coordinate without mass.
fn has_masses(n: usize, mass: impl Fn(usize) -> f64) -> Result<(), Refusal> {
    match (0..n).find(|row| mass(*row) <= 0.0) {
        Some(row) => {
            let why = Text::new(
                "coordinate {row} has no mass: write a positive mass on the diagonal, or eliminate it",
            );
            Err(Refusal::because(why.with("row", row + 1)))
        }
        None => Ok(()),
    }
}

fn not_too_many(n: usize) -> Result<(), Refusal> {
    at_most(n, MOST)
}

/// Refuses more degrees of freedom than can be solved.
pub(crate) fn at_most(n: usize, most: usize) -> Result<(), Refusal> {
    if n <= most {
        return Ok(());
    }
    let why = Text::new("{have} degrees of freedom exceed the limit of {most} for interactive solution");
    Err(Refusal::because(why.with("have", n).with("most", most)))
}

/// The symbol of an entry of a matrix, counted from 0.
pub(crate) fn symbol(base: &'static str, row: usize, column: usize) -> Symbol {
    Symbol::from(base).row(row + 1).row(column + 1)
}

fn sum<N: Real>(numbers: [Option<N>; 3]) -> N {
    let mut numbers = numbers.into_iter().flatten();
    match numbers.next() {
        Some(first) => numbers.fold(first, |sum, number| sum + number),
        None => N::from(0.0),
    }
}
