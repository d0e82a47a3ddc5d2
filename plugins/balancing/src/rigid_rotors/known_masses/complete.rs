//! Static and complete balance by quantities that were left empty.

use std::f64::consts::TAU;

use dalembert_core::{Cell, Column, Exhibit, Refusal, Symbol, TableExhibit, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    balance::{self, PartlyKnown, RotorMass, UnknownsError, Vanishing},
};

use super::{Load, Partly, Product, Unbalance};
use crate::sources::KHURMI;

/// The most balances that are answered; more are in the table only.
const MOST: usize = 4;

/// Finds what was left empty; the first balance is worked, the others are answered and tabulated.
pub(super) fn find<W: Worksheet>(
    partly: &[Partly<W::Num>],
    vanishing: Vanishing,
    sheet: W,
) -> Result<Vec<Load<W::Num>>, Refusal> {
    let mut given = Vec::new();
    for m in partly {
        if m.mass.is_none() && m.radius.is_none() && !m.only_product {
            return Err(Refusal::because(
                Text::new("of mass {n} only the mass–radius product is determined; give its mass or its radius, or ask for the product")
                    .with("n", m.row),
            ));
        }
        let product = match (m.mass, m.radius) {
            (Some(mass), Some(radius)) => Some(mass.value() * radius.value()),
            _ => m.product.map(Real::value),
        };
        given.push(PartlyKnown {
            product,
            angle: m.angle.map(Real::value),
            position: m.position.map(Real::value),
        });
    }
    let balances = balance::balance_unknowns(&given, vanishing).map_err(refusal)?;
    let both = vanishing == Vanishing::ForceAndCouple;
    let first = balances.first().ok_or_else(|| refusal(UnknownsError::Contradiction))?;
    let loads = partly.iter().zip(first).map(|(m, found)| load(m, *found, both, sheet)).collect();
    for (k, other) in (1..).zip(&balances).take(MOST).skip(1) {
        for (m, found) in partly.iter().zip(other) {
            another(m, *found, k, both, sheet);
        }
    }
    if balances.len() > 1 {
        sheet.warn(|| {
            Text::new("{count} arrangements balance the rotor; the first is worked, all are in the table")
                .with("count", balances.len())
        });
    }
    sheet.show(|| Exhibit::Table(table(&balances, both)));
    Ok(loads)
}

/// Holds the balance to its equations, and by the closing sides of the polygons to one another.
pub(super) fn check<W: Worksheet>(masses: &[Unbalance<W::Num>], both: bool, sheet: W) {
    sheet.verify(|| {
        let force: f64 = masses.iter().map(Unbalance::size).sum();
        for of in [(|u| u.x) as fn(&Unbalance<W::Num>) -> W::Num, |u| u.y] {
            sheet.check_zero(
                "the polygon of forces closes",
                balance::resultant(masses.iter().map(of)),
                force,
            );
            if both {
                // About the first mass: another point than the one the equations were solved about.
                let origin = masses[0].z.value();
                let reach = masses.iter().map(|m| (m.z.value() - origin).abs()).fold(0.0, f64::max);
                let moment = masses.iter().map(|m| of(m).value() * (m.z.value() - origin)).sum::<f64>();
                sheet.check_zero("the polygon of couples closes", moment.into(), force * reach);
            }
        }
    });
}

/// A mass of the first balance, with what was found of it as answers.
fn load<W: Worksheet>(m: &Partly<W::Num>, found: RotorMass, both: bool, sheet: W) -> Load<W::Num> {
    let row = m.row;
    let why = || {
        let reason = if both {
            "Solution that closes the force and couple polygons, by Newton's method from many starting points"
        } else {
            "Solution that closes the force polygon, by Newton's method from many starting points"
        };
        (reason, KHURMI.at("ch. 21"))
    };
    let size = || sheet.numerical(("U", row), "kg*mm", found.product, why());
    let product = match (m.mass, m.radius, m.product) {
        (Some(mass), Some(radius), _) => Product::Of(mass, radius),
        (_, _, Some(product)) => Product::Is(product),
        (None, Some(radius), None) => {
            let mass = sheet.step(("m", row), "kg", size() / radius, "Mass at the given radius");
            sheet.answer(("mass", row), "Mass", mass);
            Product::Of(mass, radius)
        }
        (Some(mass), None, None) => {
            let radius = sheet.step(("r", row), "mm", size() / mass, "Radius of the given mass");
            sheet.answer(("radius", row), "Radius", radius);
            Product::Of(mass, radius)
        }
        (None, None, None) => {
            let product = size();
            sheet.answer(("unbalance", row), "Unbalance", product);
            Product::Is(product)
        }
    };
    let angle = m.angle.unwrap_or_else(|| {
        let angle = sheet.numerical(("θ", row), "deg", found.angle, why());
        sheet.answer(("angle", row), "Angle", angle);
        let why = "The same position, measured in the opposite sense";
        let other = sheet.step(("θ′", row), "deg", -angle + TAU, why);
        sheet.answer(("other_angle", row), "Angle in the opposite sense", other);
        sheet.verify(|| {
            let what = "transverse to the mark, the angle in the opposite sense gives the opposite component";
            sheet.check_sum(what, other.sin(), -angle.sin(), 1.0);
            sheet.check_sum(
                "along the mark, the angle in the opposite sense gives the same component",
                other.cos(),
                angle.cos(),
                1.0,
            );
        });
        angle
    });
    let position = if both {
        Some(m.position.unwrap_or_else(|| {
            let position = sheet.numerical(("z", row), "mm", found.position, why());
            sheet.answer(("position", row), "Position", position);
            position
        }))
    } else {
        m.position
    };
    Load { row, product, angle, position }
}

/// Answers the unknowns of a mass in the `k`-th balance.
fn another<W: Worksheet>(m: &Partly<W::Num>, found: RotorMass, k: usize, both: bool, sheet: W) {
    let row = m.row;
    let symbol = |base: &'static str| Symbol::from(base).row(row).row(k);
    let why = || Text::new("Another arrangement that closes the polygons, number {number}").with("number", k);
    let found_here = |base, unit, si| sheet.numerical(symbol(base), unit, si, why());
    match (m.mass, m.radius, m.product) {
        (None, Some(radius), None) => {
            let mass = found_here("m", "kg", found.product / radius.value());
            sheet.answer(("mass", k, row), "Mass in arrangement", mass);
        }
        (Some(mass), None, None) => {
            let radius = found_here("r", "mm", found.product / mass.value());
            sheet.answer(("radius", k, row), "Radius in arrangement", radius);
        }
        (None, None, None) => {
            let product = found_here("U", "kg*mm", found.product);
            sheet.answer(("unbalance", k, row), "Unbalance in arrangement", product);
        }
        _ => {}
    }
    if m.angle.is_none() {
        let angle = found_here("θ", "deg", found.angle);
        sheet.answer(("angle", k, row), "Angle in arrangement", angle);
    }
    if both && m.position.is_none() {
        let position = found_here("z", "mm", found.position);
        sheet.answer(("position", k, row), "Position in arrangement", position);
    }
}

fn table(balances: &[Vec<RotorMass>], both: bool) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let mut columns =
        vec![column("Arrangement", ""), column("", ""), column("m r", "kg*mm"), column("θ", "deg")];
    if both {
        columns.push(column("z", "mm"));
    }
    let rows = (1..).zip(balances).flat_map(|(k, balance)| {
        let row = move |(n, mass): (usize, &RotorMass)| -> Vec<Cell> {
            let mut cells: Vec<Cell> = vec![
                Text::new("{number}").with("number", k).into(),
                Text::new("mass {n}").with("n", n).into(),
                mass.product.into(),
                mass.angle.into(),
            ];
            if both {
                cells.push(mass.position.into());
            }
            cells
        };
        (1..).zip(balance).map(row).collect::<Vec<_>>()
    });
    TableExhibit {
        title: "Arrangements that balance the rotor".into(),
        columns,
        rows: rows.collect(),
        foot: Vec::new(),
    }
}

fn refusal(error: UnknownsError) -> Refusal {
    Refusal::because(match error {
        UnknownsError::Count { unknowns, equations } => {
            let text = if unknowns > equations {
                "{unknowns} quantities are left empty, but there are only {equations} equations, so the balance is not unique; give more of them"
            } else {
                "{unknowns} quantities are left empty, but there are {equations} equations; leave more of them empty, or ask for corrections in planes"
            };
            Text::new(text).with("unknowns", unknowns).with("equations", equations)
        }
        UnknownsError::NoDatum => Text::new(
            "no angle is given, so the orientation of the rotor is arbitrary; give one angle, for example 0°",
        ),
        UnknownsError::NoScale => Text::new(
            "no mass–radius product is given, so the masses are known only up to a common factor; give mass and radius of one of them",
        ),
        UnknownsError::NoLength => Text::new(
            "fewer than two different positions are given, so the axial scale is undetermined; give two different positions",
        ),
        UnknownsError::Contradiction => Text::new(
            "no values of what is left empty close the polygons: the given masses contradict each other; check them, or leave other quantities empty",
        ),
        UnknownsError::NotDetermined => Text::new(
            "infinitely many values balance the rotor, so the empty quantities are not determined; leave other quantities empty",
        ),
        UnknownsError::Negative(row) => Text::new(
            "mass {n} would have to be negative at its angle; turn it by 180°, or leave its angle empty",
        )
        .with("n", row),
        UnknownsError::NotFinite => {
            Text::new("the masses and positions differ so much in size that their sums cannot be represented")
        }
    })
}
