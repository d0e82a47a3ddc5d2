//! A rigid rotor with known masses in many planes: its corrections, its complete balance, its bearing forces.

use dalembert_core::{About, Analysis, Exhibit, Ink, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    balance::{self, PlaneUnbalance, Vanishing},
};

use crate::{
    shared::{
        rotor::letter,
        rotor::{Angles, Correction, CorrectionMethod},
        views::{self, ListedUnbalance},
    },
    sources::{ISO_TERMS, KHURMI, NORTON, RIUL},
};

mod complete;
mod corrections;
mod state;

/// The masses of a rotor and what is asked of them.
#[derive(Clone, Debug, Inputs)]
pub struct KnownMasses {
    /// Masses on the rotor.
    /// In a complete balance, leave the unknown quantities empty.
    #[input(min = 1)]
    pub masses: Vec<RotorMass>,
    /// Angle convention.
    pub angles: Angles,
    /// Find.
    pub task: Task,
    /// Gravity.
    /// Only turns masses into weights; the balance does not depend on it.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
    /// Bearings and speed.
    /// For the forces on the bearings.
    pub bearings: Option<BearingPositions>,
    /// Planes for the equivalent unbalance.
    /// Any two planes: the unbalance of the masses as two vectors, and as a static and a couple component.
    pub equivalent: Option<EquivalentPlanes>,
}

/// A mass on a rotor.
#[derive(Clone, Debug, Inputs)]
pub struct RotorMass {
    /// Quantity given.
    pub amount: UnbalanceAmount,
    /// Radius.
    #[input("r", "mm", nonnegative)]
    pub radius: Option<f64>,
    /// Angle.
    /// The answers use the same sense.
    #[input("θ", "deg")]
    pub angle: Option<f64>,
    /// Position.
    /// Along the shaft, from any origin.
    #[input("z", "mm")]
    pub position: Option<f64>,
}

/// Magnitude of an unbalance.
#[derive(Clone, Debug, Inputs)]
pub enum UnbalanceAmount {
    /// Mass
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: Option<f64>,
    },
    /// Weight
    Weight {
        /// Weight.
        #[input("W", "N", positive)]
        weight: Option<f64>,
    },
    /// Mass–radius product
    Product {
        /// Mass–radius product.
        #[input("U", "kg*mm", positive)]
        product: Option<f64>,
    },
}

/// Task of the analysis.
#[derive(Clone, Debug, Inputs)]
pub enum Task {
    /// Corrections in one plane or more
    /// In more than two planes, those with the least sum of squares.
    Planes {
        /// Correction planes.
        #[input(min = 1)]
        planes: Vec<CorrectionPlane>,
        /// Correction method.
        way: CorrectionMethod,
    },
    /// Complete balance: four unknown quantities, left empty
    /// Neither a rotating force nor a rotating couple remains.
    Complete,
    /// Static balance: two unknown quantities, left empty
    /// No rotating force remains; a couple may.
    Static,
    /// The rotor without corrections
    State,
}

/// A plane where mass may be put on or taken off.
#[derive(Clone, Debug, Inputs)]
pub struct CorrectionPlane {
    /// Position.
    /// Along the shaft, from the same origin as the masses.
    #[input("z_P", "mm")]
    pub position: f64,
    /// Correction.
    pub correction: Correction,
}

/// Axial positions of the bearings.
#[derive(Clone, Debug, Inputs)]
pub struct BearingPositions {
    /// Position of the first bearing.
    #[input("z_I", "mm")]
    pub first: f64,
    /// Position of the second bearing.
    #[input("z_J", "mm")]
    pub second: f64,
    /// Speed.
    #[input("ω", "rpm", positive)]
    pub speed: f64,
    /// The rotor as a whole.
    /// For the loads with its weight, and to distinguish static from quasi-static unbalance.
    pub rotor: Option<WholeRotor>,
}

/// A rotor as a whole.
#[derive(Clone, Debug, Inputs)]
pub struct WholeRotor {
    /// Mass.
    #[input("m_G", "kg", positive)]
    pub mass: f64,
    /// Position of the centre of mass.
    #[input("z_G", "mm")]
    pub centre: f64,
}

/// Two planes in which an unbalance is reported.
#[derive(Clone, Debug, Inputs)]
pub struct EquivalentPlanes {
    /// First plane.
    #[input("z_I", "mm")]
    pub first: f64,
    /// Second plane.
    #[input("z_II", "mm")]
    pub second: f64,
}

register!(KnownMasses);

impl Analysis for KnownMasses {
    const ABOUT: About = About {
        id: "balancing/known-masses",
        title: "Rotor with known masses in many planes",
        topic: "Rigid rotors",
        summary: "Corrections in any number of planes, complete balance with unknown masses, radii, angles or positions, kind of unbalance and bearing forces of a rigid rotor.",
        main: &[
            "correction",
            "correction_mass",
            "correction_angle",
            "mass",
            "angle",
            "position",
            "static_part",
            "static_angle",
            "couple_part",
            "couple_angle",
            "bearing_first",
            "bearing_second",
        ],
        keywords: "balanceamento dinâmico rotor rígido vários planos massas giratórias mancal desbalanceamento estático conjugado \
                   quase-estático rotating masses several planes complete balance dynamic static couple bearing force camshaft pulleys \
                   quasi-static unbalance static unbalance couple unbalance dynamic unbalance kinds of unbalance desbalanceamento quase-estático de momento dinâmico",
        sources: &[&RIUL, &KHURMI, &NORTON, &ISO_TERMS],
        cases: include_str!("../../cases/known_masses.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &KnownMassesGiven<W>, sheet: W) -> Result<(), Refusal> {
        let partly = self.partly(given, sheet)?;
        let (loads, found) = match &self.task {
            Task::Complete => (complete::find(&partly, Vanishing::ForceAndCouple, sheet)?, true),
            Task::Static => (complete::find(&partly, Vanishing::Force, sheet)?, true),
            Task::Planes { .. } | Task::State => {
                (partly.iter().map(Partly::whole).collect::<Result<Vec<_>, _>>()?, false)
            }
        };
        sheet.keep_going()?;
        let masses = unbalances(&loads, sheet);
        let scale: f64 = masses.iter().map(Unbalance::size).sum();
        if scale == 0.0 {
            return Err(Refusal::because(
                "every mass is on the axis, so there is no unbalance; give at least one of them a radius",
            ));
        }
        if found {
            complete::check(&masses, matches!(self.task, Task::Complete), sheet);
        }
        let corrections = match (&self.task, &given.task) {
            (Task::Planes { planes, way }, TaskGiven::Planes { planes: known, .. }) => {
                corrections::find(&masses, planes, known, *way, given.gravity, sheet)?
            }
            _ => Vec::new(),
        };
        let planes = masses.iter().all(|m| m.placed);
        if planes {
            let reference = self.reference(given, sheet)?;
            state::of_the_masses(&masses, reference, sheet);
            if let (Some(known), Some(bearings), Some(reference)) =
                (&self.bearings, &given.bearings, reference)
            {
                let after = (!corrections.is_empty()).then_some(corrections.as_slice());
                state::bearing_forces(&masses, after, known, bearings, given.gravity, reference, sheet);
            }
            if let (Some(known), Some(equivalent)) = (&self.equivalent, &given.equivalent) {
                state::equivalent(&masses, known, equivalent, sheet)?;
            }
            let centre = self.bearings.as_ref().and_then(|b| b.rotor.as_ref()).map(|rotor| rotor.centre);
            sheet.show(|| {
                let after = (!corrections.is_empty()).then_some(corrections.as_slice());
                Exhibit::Table(state::kinds(&masses, after, centre, reference.map_or(0.0, Real::value)))
            });
        }
        let shown = || shown(&loads, &masses, &corrections);
        sheet.show(|| Exhibit::Table(views::table(&shown(), planes)));
        sheet.show(|| Exhibit::Drawing(views::polar(&shown(), self.bearings.as_ref().map(|_| "ω"))));
        sheet.show(|| Exhibit::Drawing(views::force_polygon(&shown())));
        if planes {
            sheet.show(|| Exhibit::Drawing(views::couple_polygon(&shown())));
            let bearings = self.bearings.as_ref().map(|b| [(b.first, "z_I"), (b.second, "z_J")]);
            sheet
                .show(|| Exhibit::Drawing(views::side(&shown(), bearings.as_ref().map_or(&[], |both| both))));
        }
        Ok(())
    }
}

/// Known quantities of a mass, as numbers of a worksheet.
struct Partly<N> {
    row: usize,
    mass: Option<N>,
    radius: Option<N>,
    /// Mass times radius, where it is given as such or both are.
    product: Option<N>,
    /// True if the product mr itself is the unknown, without mass and radius.
    only_product: bool,
    angle: Option<N>,
    position: Option<N>,
}

/// A mass of which everything is known.
struct Load<N> {
    row: usize,
    product: Product<N>,
    angle: N,
    position: Option<N>,
}

/// Mass and radius, or their product.
enum Product<N> {
    Of(N, N),
    Is(N),
}

/// The components of an unbalance and where it is.
struct Unbalance<N> {
    x: N,
    y: N,
    z: N,
    /// True if the axial position is given.
    placed: bool,
}

impl<N: Real> Unbalance<N> {
    fn size(&self) -> f64 {
        self.x.value().hypot(self.y.value())
    }

    fn plain(&self) -> PlaneUnbalance {
        PlaneUnbalance { position: self.z.value(), components: [self.x.value(), self.y.value()] }
    }
}

impl<N: Real> Partly<N> {
    fn whole(&self) -> Result<Load<N>, Refusal> {
        let missing = |what: &'static str| {
            Refusal::because(
                Text::new(
                    "of mass {n} the {what} is missing; give it, or ask for a complete or a static balance",
                )
                .with("n", self.row)
                .with_text("what", what),
            )
        };
        let product = match (self.mass, self.radius, self.product) {
            (Some(mass), Some(radius), _) => Product::Of(mass, radius),
            (_, _, Some(product)) => Product::Is(product),
            (None, _, None) => return Err(missing("mass")),
            (_, None, None) => return Err(missing("radius")),
        };
        let angle = self.angle.ok_or_else(|| missing("angle"))?;
        let position = self.position.ok_or_else(|| missing("position"))?;
        Ok(Load { row: self.row, product, angle, position: Some(position) })
    }
}

impl KnownMasses {
    /// The masses as numbers: weights become masses, successive angles are added up.
    fn partly<W: Worksheet>(
        &self,
        given: &KnownMassesGiven<W>,
        sheet: W,
    ) -> Result<Vec<Partly<W::Num>>, Refusal> {
        let mut before: Option<W::Num> = None;
        let mut all = Vec::new();
        for (row, m) in (1..).zip(&given.masses) {
            let (mass, product, only_product) = match m.amount {
                UnbalanceAmountGiven::Mass { mass } => (mass, None, false),
                UnbalanceAmountGiven::Weight { weight } => {
                    let mass = weight.map(|weight| {
                        sheet.step(("m", row), "kg", weight / given.gravity, "Mass of the weight")
                    });
                    (mass, None, false)
                }
                UnbalanceAmountGiven::Product { product } => (None, product, true),
            };
            let angle = match (self.angles, m.angle) {
                (Angles::Absolute, angle) => angle,
                (Angles::Successive, None) => {
                    return Err(Refusal::because(
                        "relative angles cannot be counted past an empty one; give the angles from the mark",
                    ));
                }
                (Angles::Successive, Some(angle)) => Some(match before {
                    Some(before) => sheet.step(("φ", row), "deg", before + angle, "Angle from the mark"),
                    None => angle,
                }),
            };
            before = angle;
            all.push(Partly {
                row,
                mass,
                radius: m.radius,
                product,
                only_product,
                angle,
                position: m.position,
            });
        }
        Ok(all)
    }

    /// The point about which moments are referred: the centre of mass, or the middle of the bearings, or the origin.
    fn reference<W: Worksheet>(
        &self,
        given: &KnownMassesGiven<W>,
        sheet: W,
    ) -> Result<Option<W::Num>, Refusal> {
        let Some(bearings) = &given.bearings else { return Ok(None) };
        if bearings.first.value() == bearings.second.value() {
            return Err(Refusal::because(
                "both bearings are at the same position; give them different positions",
            ));
        }
        Ok(Some(match &bearings.rotor {
            Some(rotor) => rotor.centre,
            None => sheet.step(
                "z₀",
                "mm",
                (bearings.first + bearings.second) / 2.0,
                "Reference point for moments: midway between the bearings",
            ),
        }))
    }
}

/// The components of every mass, direction by direction.
fn unbalances<W: Worksheet>(loads: &[Load<W::Num>], sheet: W) -> Vec<Unbalance<W::Num>> {
    let along = |of_mass: fn(W::Num, W::Num, W::Num) -> W::Num,
                 of_angle: fn(W::Num) -> W::Num,
                 symbol: &'static str,
                 why: &'static str| {
        let each = loads.iter().map(|load| {
            let component = match load.product {
                Product::Of(mass, radius) => of_mass(mass, radius, load.angle),
                Product::Is(product) => product * of_angle(load.angle),
            };
            sheet.step((symbol, load.row), "kg*mm", component, why)
        });
        each.collect::<Vec<W::Num>>()
    };
    let x = along(balance::component_x, W::Num::cos, "U_x", "Unbalance of each mass along x");
    let y = along(balance::component_y, W::Num::sin, "U_y", "Unbalance of each mass along y");
    let all = loads.iter().zip(x).zip(y).map(|((load, x), y)| Unbalance {
        x,
        y,
        z: load.position.unwrap_or(0.0.into()),
        placed: load.position.is_some(),
    });
    all.collect()
}

/// The masses and the corrections, to be listed and drawn.
fn shown<N: Real>(
    loads: &[Load<N>],
    masses: &[Unbalance<N>],
    corrections: &[corrections::Corrected<N>],
) -> Vec<ListedUnbalance> {
    let of_masses = loads.iter().zip(masses).map(|(load, u)| ListedUnbalance {
        name: Text::new("mass {n}").with("n", load.row),
        label: letter("m", load.row),
        polar: match load.product {
            Product::Of(..) => format!("{} {}", letter("m", load.row), letter("r", load.row)),
            Product::Is(_) => letter("U", load.row),
        } + &format!(" ∠ {}", letter("θ", load.row)),
        place: if load.position.is_some() { letter("z", load.row) } else { String::new() },
        mass_and_radius: match load.product {
            Product::Of(mass, radius) => Some((mass.value(), radius.value())),
            Product::Is(_) => None,
        },
        unbalance: (u.x.value(), u.y.value()),
        position: u.z.value(),
        ink: Ink::Force,
    });
    let of_planes = corrections.iter().zip(1..).map(|(c, n)| ListedUnbalance {
        name: Text::new("plane {n}").with("n", n),
        label: letter("P", n),
        polar: match c.mass_and_radius {
            Some(_) => format!("{} {}", letter("m_c", n), letter("r_c", n)),
            None => letter("P", n),
        },
        place: letter("z_P", n),
        mass_and_radius: c.mass_and_radius,
        unbalance: (c.unbalance.x.value(), c.unbalance.y.value()),
        position: c.unbalance.z.value(),
        ink: Ink::Result,
    });
    of_masses.chain(of_planes).collect()
}

/// The square of the resultant of masses at arms by the law of cosines over all pairs, and the square of the sum of their
/// sizes.
fn by_pairs<N: Real>(masses: &[Unbalance<N>], arm: &dyn Fn(&Unbalance<N>) -> f64) -> (f64, f64) {
    let all = masses.iter().map(|u| (u.size() * arm(u), u.y.value().atan2(u.x.value())));
    crate::shared::rotor::by_pairs(&all.collect::<Vec<_>>())
}
