//! Mistakes in a product: its factors missing, inverted or squared, and its coefficient another number.

use std::f64::consts::PI;

use dalembert_units::{Dim, Kind, Unit};

use super::{
    Change,
    digits::is_shifted,
    slip::{Slip, UNKNOWN, alone, is_scalar},
    weight::weights,
};
use crate::{
    Solution,
    reevaluate::Edit,
    trace::{Id, Number, Op},
};

/// Dimension of the acceleration of gravity.
const GRAVITY: Dim = Dim::new(1, 0, -2, 0);

const MASS: Dim = Dim::new(0, 1, 0, 0);

/// Coefficients of the formulas of mechanics: of moments of inertia, second moments of area, beams, springs.
const COEFFICIENTS: [f64; 15] =
    [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0, 192.0];

/// Coefficients of moments of inertia: rods about an end and the middle, discs, rings, spheres.
const INERTIA: [f64; 6] = [1.0 / 3.0, 1.0 / 12.0, 1.0 / 2.0, 1.0 / 4.0, 2.0 / 5.0, 2.0 / 3.0];

/// A factor of a product, and whether it divides.
#[derive(Clone, Copy)]
struct Factor {
    id: Id,
    divides: bool,
}

/// The factors of a product.
fn factors(solution: &Solution, id: Id, divides: bool, out: &mut Vec<Factor>) {
    match solution.trace.node(id).op {
        Op::Mul(a, b) => {
            factors(solution, a, divides, out);
            factors(solution, b, divides, out);
        }
        Op::Div(a, b) => {
            factors(solution, a, divides, out);
            factors(solution, b, !divides, out);
        }
        _ => out.push(Factor { id, divides }),
    }
}

/// Every factor of a product left out, on the other side of the stroke, or taken twice; another coefficient.
pub(super) fn of_product(solution: &Solution, id: Id, found: &mut Vec<Slip>) {
    let mut all = Vec::new();
    factors(solution, id, false, &mut all);
    let is_literal = |factor: &Factor| solution.trace.node(factor.id).op == Op::Literal;
    let is_vector = |factor: &Factor| !is_scalar(solution, factor.id);
    let without = |dropped: &dyn Fn(&Factor) -> bool| {
        let kept: Vec<Factor> = all.iter().filter(|factor| !dropped(factor)).copied().collect();
        product_of(solution, id, &kept, 1.0)
    };
    // Multiplied in place of divided, or the other way round.
    let turned = |is_turned: &dyn Fn(&Factor) -> bool| {
        let turned = |one: &Factor| Factor { divides: one.divides != is_turned(one), ..*one };
        product_of(solution, id, &all.iter().map(turned).collect::<Vec<_>>(), 1.0)
    };
    for factor in &all {
        if is_vector(factor) {
            continue;
        }
        let number = solution.trace.node(factor.id).number;
        let is_this = |other: &Factor| other.id == factor.id;
        if number == Number::Scalar(-1.0) {
            found.extend(without(&is_this).map(|edit| Slip::new(5.0, Change::TermSign, edit)));
            continue;
        }
        let prior = if is_literal(factor) { 9.0 } else { 2.5 };
        let is_gravity = solution.trace.node(factor.id).dim.agrees(GRAVITY)
            && matches!(number, Number::Scalar(g) if (9.5..10.2).contains(&g.abs()));
        let slip = |prior: f64, change: Change, edit: Edit| Slip::new(prior, change, edit).of(factor.id);
        let (prior, change) =
            if is_gravity { (15.0, Change::Weight) } else { (prior, Change::FactorLeftOut) };
        found.extend(without(&is_this).map(|edit| slip(prior, change, edit)));
        if !is_literal(factor) && all.iter().any(is_literal) {
            let with_literals = |other: &Factor| is_this(other) || is_literal(other);
            found.extend(without(&with_literals).map(|edit| slip(2.0, Change::FactorLeftOut, edit)));
        }
        let change = if is_literal(factor) { Change::FactorInverted } else { Change::DividedForMultiplied };
        let prior = if is_literal(factor) { 0.4 } else { 1.0 };
        found.extend(turned(&is_this).map(|edit| slip(prior, change, edit)));
        if !is_literal(factor) && all.iter().any(is_literal) {
            let edit = turned(&|one| is_this(one) || is_literal(one));
            found.extend(edit.map(|edit| slip(0.6, Change::DividedForMultiplied, edit)));
        }
        // A ratio of two like quantities upside down.
        let dim = |one: &Factor| solution.trace.node(one.id).dim;
        let is_under = |one: &&Factor| one.divides && !factor.divides && dim(one).agrees(dim(factor));
        for under in all.iter().filter(is_under).filter(|under| !is_literal(under) && !is_vector(under)) {
            let edit = turned(&|one| is_this(one) || one.id == under.id);
            found.extend(edit.map(|edit| slip(3.0, Change::Inverted, edit)));
        }
        // An arc is its radius times an angle in radians.
        if dim(factor) == Dim::ANGLE {
            let edit = product_of(solution, id, &all, (PI / 180.0).powi(if factor.divides { 1 } else { -1 }));
            found.extend(edit.map(|edit| slip(2.0, Change::Degrees, edit)));
        }
        // Weight where the mass belongs, here alone.
        if dim(factor).agrees(MASS) && !all.iter().any(|one| dim(one).agrees(GRAVITY)) {
            let unit = match &solution.trace.node(factor.id).op {
                Op::Given { unit, .. } => unit,
                _ => &Unit::ONE,
            };
            for (prior, g) in weights(unit) {
                for (share, g) in [(0.3, *g), (0.09, 1.0 / g)] {
                    let g = if factor.divides { 1.0 / g } else { g };
                    let edit = product_of(solution, id, &all, g);
                    found.extend(edit.map(|edit| slip(share * prior, Change::Weight, edit)));
                }
            }
        }
        let twice: Vec<Factor> = all.iter().copied().chain([*factor]).collect();
        let prior = if is_literal(factor) { 0.1 } else { 0.5 };
        found.extend(
            product_of(solution, id, &twice, 1.0).map(|edit| slip(prior, Change::FactorSquared, edit)),
        );
    }
    if !all.iter().any(is_vector) {
        found.extend(turned(&|_| true).map(|edit| Slip::new(1.8, Change::Inverted, edit)));
    }
    coefficients(solution, id, &all, found);
}

/// True for a quantity whose formulas are remembered by their coefficients: moments of inertia, second moments of area,
/// stiffnesses, areas.
fn is_remembered(dim: Dim) -> bool {
    [Kind::MomentOfInertia, Kind::SecondMoment, Kind::Stiffness, Kind::TorsionalStiffness, Kind::Area]
        .iter()
        .any(|kind| kind.dim().is_some_and(|of| of.agrees(dim)))
}

/// The product with another coefficient in place of its numbers.
fn coefficients(solution: &Solution, id: Id, all: &[Factor], found: &mut Vec<Slip>) {
    let number =
        |factor: &Factor| match (&solution.trace.node(factor.id).op, solution.trace.node(factor.id).number) {
            (Op::Literal, Number::Scalar(x)) => Some(if factor.divides { 1.0 / x } else { x }),
            _ => None,
        };
    let numbers: Vec<f64> = all.iter().filter_map(number).collect();
    let others: Vec<Factor> = all.iter().filter(|factor| number(factor).is_none()).copied().collect();
    if numbers.is_empty() || others.is_empty() {
        return;
    }
    let present: f64 = numbers.iter().product();
    let taken = COEFFICIENTS.into_iter().map(|other| if present.abs() < 1.0 { 1.0 / other } else { other });
    let taken = taken.chain([2.0 / 5.0, 2.0 / 3.0, 3.0 / 10.0]).map(|other| other.copysign(present));
    let dim = solution.trace.node(id).dim;
    let is_inertia = |factor: f64| {
        INERTIA.iter().any(|known| (known - factor.abs()).abs() < 1e-9)
            && Kind::MomentOfInertia.dim().is_some_and(|of| of.agrees(dim))
    };
    let prior = |other: f64| match (is_inertia(present) && is_inertia(other), is_remembered(dim)) {
        (true, _) => 8.0,
        (false, true) => 1.5,
        (false, false) => 0.3,
    };
    // A coefficient ten times as large is a power of ten, which others look for.
    let is_another = |other: &f64| !is_shifted(other / present);
    for other in taken.filter(is_another) {
        let change = Change::Coefficient(present, other);
        let edit = product_of(solution, id, &others, other);
        found.extend(edit.map(|edit| Slip::new(prior(other), change, edit)));
    }
}

/// A product of these factors and a coefficient, in place of a node; `None` where no factor is left.
fn product_of(solution: &Solution, id: Id, factors: &[Factor], coefficient: f64) -> Option<Edit> {
    let first = Edit::first_new(solution);
    let mut ops: Vec<(Op, Number)> = Vec::new();
    let mut add = |op: Op, number: Number| {
        ops.push((op, number));
        first + ops.len() as Id - 1
    };
    let mut over: Option<Id> = None;
    let mut under: Option<Id> = None;
    if coefficient != 1.0 {
        over = Some(add(Op::Literal, Number::Scalar(coefficient)));
    }
    for factor in factors {
        let side = if factor.divides { &mut under } else { &mut over };
        *side = Some(match *side {
            None => factor.id,
            Some(product) => add(Op::Mul(product, factor.id), UNKNOWN),
        });
    }
    match (over, under) {
        (Some(over), Some(under)) => {
            add(Op::Div(over, under), UNKNOWN);
        }
        (None, Some(under)) => {
            let one = add(Op::Literal, Number::Scalar(1.0));
            add(Op::Div(one, under), UNKNOWN);
        }
        (Some(over), None) if ops.is_empty() => return Some(Edit::op(id, alone(over))),
        (Some(_), None) => {}
        (None, None) => return None,
    }
    Some(Edit { at: id, ops })
}
