//! Mistakes in a product: its factors missing, inverted or squared, and its coefficient another number.

use dalembert_units::{Dim, Kind};

use super::{
    Change,
    slip::{Slip, UNKNOWN, alone, is_scalar},
};
use crate::{
    Solution,
    reevaluate::Edit,
    trace::{Id, Number, Op},
};

/// Dimension of the acceleration of gravity.
const GRAVITY: Dim = Dim::new(1, 0, -2, 0);

/// Coefficients of the formulas of mechanics: of moments of inertia, second moments of area, beams, springs.
const COEFFICIENTS: [f64; 15] =
    [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0, 192.0];

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
    for factor in &all {
        if is_vector(factor) {
            continue;
        }
        let number = solution.trace.node(factor.id).number;
        let is_this = |other: &Factor| other.id == factor.id;
        if number == Number::Scalar(-1.0) {
            found.extend(without(&is_this).map(|edit| Slip::new(0.8, Change::TermSign, edit)));
            continue;
        }
        let prior = if is_literal(factor) { 0.75 } else { 0.45 };
        let is_gravity = solution.trace.node(factor.id).dim.agrees(GRAVITY)
            && matches!(number, Number::Scalar(g) if (9.5..10.2).contains(&g.abs()));
        let slip = |prior: f64, change: Change, edit: Edit| Slip::new(prior, change, edit).of(factor.id);
        let change = if is_gravity { Change::Weight } else { Change::FactorLeftOut };
        found.extend(without(&is_this).map(|edit| slip(prior, change, edit)));
        if !is_literal(factor) && all.iter().any(is_literal) {
            let with_literals = |other: &Factor| is_this(other) || is_literal(other);
            found.extend(without(&with_literals).map(|edit| slip(0.3, Change::FactorLeftOut, edit)));
        }
        let turned: Vec<Factor> =
            all.iter().map(|one| Factor { divides: one.divides != is_this(one), ..*one }).collect();
        let change = if is_literal(factor) { Change::FactorInverted } else { Change::DividedForMultiplied };
        found.extend(product_of(solution, id, &turned, 1.0).map(|edit| slip(0.4, change, edit)));
        let twice: Vec<Factor> = all.iter().copied().chain([*factor]).collect();
        let prior = if is_literal(factor) { 0.15 } else { 0.4 };
        found.extend(
            product_of(solution, id, &twice, 1.0).map(|edit| slip(prior, Change::FactorSquared, edit)),
        );
    }
    if !all.iter().any(is_vector) {
        let inverse: Vec<Factor> = all.iter().map(|one| Factor { divides: !one.divides, ..*one }).collect();
        found.extend(
            product_of(solution, id, &inverse, 1.0).map(|edit| Slip::new(0.4, Change::Inverted, edit)),
        );
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
    let prior = if is_remembered(solution.trace.node(id).dim) { 0.72 } else { 0.25 };
    // A coefficient ten times as large is a power of ten, which others look for.
    let is_another = |other: &f64| {
        let places = (other / present).log10();
        (places - places.round()).abs() > 1e-9
    };
    for other in taken.filter(is_another) {
        let change = Change::Coefficient(present, other);
        found.extend(product_of(solution, id, &others, other).map(|edit| Slip::new(prior, change, edit)));
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
