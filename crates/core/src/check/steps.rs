//! Mistakes within the steps of the worked solution: edits of its trace.

use std::{
    collections::HashSet,
    f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2, TAU},
};

use dalembert_units::Dim;

use super::{
    Change, Mistake, Place,
    digits::other_digit,
    products::of_product,
    slip::{Slip, UNKNOWN, alone, is_scalar},
    tries::Tries,
    wrong::Wrong,
};
use crate::{
    AnswerValue, CommonError, Refusal, Solution, Stop,
    reevaluate::{Edit, Reevaluation},
    trace::{Function, Id, Number, Op},
};

/// Worked solutions of more numbers are not edited.
pub(super) const LONGEST_TRACE: usize = 20_000;
/// So many edits are tried at most; of longer solutions those of the last steps.
const MOST: usize = 4_000;

/// The node of an answer that is a number.
pub(super) fn node_of(wrong: &Wrong<'_>) -> Option<Id> {
    if let AnswerValue::Number(_, id) = &wrong.answer.value { Some(*id) } else { None }
}

/// A number of the trace as a scalar; NaN for a vector.
pub(super) fn scalar(number: Number) -> f64 {
    if let Number::Scalar(x) = number { x } else { f64::NAN }
}

/// Adds the results of every edit of a step before the wrong answers.
pub(super) fn steps(all: &mut Tries<'_, '_>, solution: &Solution, stop: &Stop) -> Result<(), Refusal> {
    if solution.trace.nodes.len() > LONGEST_TRACE {
        return Ok(());
    }
    let wanted: Vec<Option<Id>> = all.wrong.iter().map(node_of).collect();
    let nodes: Vec<Id> = wanted.iter().flatten().copied().collect();
    let mut again = Reevaluation::new(solution, &nodes);
    let mut tries = 0;
    for (place, step) in solution.steps.iter().enumerate().rev() {
        if !again.uses(step.result) {
            continue;
        }
        for Slip { prior, change, edit, of } in of_step(solution, place) {
            stop.check()?;
            tries += 1;
            if tries > MOST {
                return Ok(());
            }
            let mut mistake = Mistake::new(Place::Step(place, step.symbol), change).of(of);
            let mut asked = wanted.clone();
            asked.push(Some(step.result));
            let mut numbers = again.with(&[&edit], &asked);
            let result = numbers.pop().map_or(f64::NAN, scalar);
            if edit.at == step.result {
                mistake = mistake.taken(result);
            }
            let values = numbers.into_iter().map(scalar).collect();
            all.edit(prior, mistake.by(edit), values);
        }
        for (change, edits) in of_calculator(solution, place) {
            stop.check()?;
            let all_edits: Vec<&Edit> = edits.iter().collect();
            let values = again.with(&all_edits, &wanted).into_iter().map(scalar).collect();
            all.push(2.0, Mistake::new(Place::Step(place, step.symbol), change), values, true, edits);
        }
    }
    Ok(())
}

/// Every trigonometric function of a step at once, where there are several, by a calculator in the wrong mode.
fn of_calculator(solution: &Solution, place: usize) -> Vec<(Change, Vec<Edit>)> {
    let mut open: Vec<Id> = solution.steps[place].formula.into_iter().collect();
    let mut seen: HashSet<Id> = HashSet::new();
    let mut calls: Vec<(Id, Function, Id)> = Vec::new();
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        if let Op::Call(function @ (Function::Sin | Function::Cos | Function::Tan), argument) =
            solution.trace.node(id).op
        {
            calls.push((id, function, argument));
        }
        open.extend(solution.trace.operands(id));
    }
    // One argument that they share is changed where it is computed.
    let is_shared = |argument: Id| {
        let is_named = matches!(solution.trace.node(argument).op, Op::Step(_) | Op::Given { .. });
        !is_named && calls.iter().all(|(.., other)| *other == argument)
    };
    if calls.len() < 2 || is_shared(calls[0].2) {
        return Vec::new();
    }
    let first = Edit::first_new(solution);
    let with = |factor: f64| -> Vec<Edit> {
        let edit = |&(at, function, argument): &(Id, Function, Id)| {
            let ops = vec![
                (Op::Literal, Number::Scalar(factor)),
                (Op::Mul(first, argument), UNKNOWN),
                (Op::Call(function, first + 1), UNKNOWN),
            ];
            Edit { at, ops }
        };
        calls.iter().map(edit).collect()
    };
    vec![(Change::Calculator(true), with(PI / 180.0)), (Change::Calculator(false), with(180.0 / PI))]
}

/// Edits of a step: of its result and of its formula.
pub(super) fn of_step(solution: &Solution, place: usize) -> Vec<Slip> {
    let mut edits = of_result(solution, place);
    let declared = of_common_errors(solution, place);
    let is_declared = declared.iter().any(|slip| is_arctangent(solution, &slip.edit));
    edits.extend(declared);
    if let Some(formula) = solution.steps[place].formula {
        of_formula(solution, formula, &mut edits);
    }
    // The analysis has its own words for it.
    edits.retain(|slip| slip.change != Change::Quadrant || !is_declared);
    edits.extend(copied(solution, place));
    edits
}

/// A digit of the result copied wrongly into the next formula, as it is written with three or four digits.
fn copied(solution: &Solution, place: usize) -> Vec<Slip> {
    let step = &solution.steps[place];
    let mut found = Vec::new();
    let Number::Scalar(si) = solution.trace.node(step.result).number else { return found };
    for digits in [3, 4] {
        let right = step.unit.value(rounded(si, &step.unit, digits));
        for (change, taken) in other_digit(right) {
            let prior = if matches!(change, Change::Swapped(..)) { 0.3 } else { 0.1 };
            let edit = Edit::number(step.result, Number::Scalar(step.unit.si(taken)));
            found.push(Slip::new(prior, change, edit));
        }
    }
    found
}

/// Edits of the result of a step.
fn of_result(solution: &Solution, place: usize) -> Vec<Slip> {
    let step = &solution.steps[place];
    let at = step.result;
    let node = solution.trace.node(at);
    let times = |factor: f64| Edit::with_literal(solution, at, factor, |own, by| Op::Mul(by, own));
    let mut found = vec![Slip::new(2.0, Change::Sign, times(-1.0))];
    if matches!(node.number, Number::Vector(_)) {
        return found;
    }
    for (prior, factor, written) in [
        (2.2, 2.0, "2"),
        (3.2, 0.5, "2"),
        (0.4, TAU, "2π"),
        (0.8, 1.0 / TAU, "2π"),
        (0.2, PI, "π"),
        (0.3, 1.0 / PI, "π"),
        (0.5, 4.0, "4"),
        (0.5, 0.25, "4"),
        (0.1, SQRT_2, "√2"),
        (0.1, FRAC_1_SQRT_2, "√2"),
        (0.6, 9.81, "g"),
        (1.0, 1.0 / 9.81, "g"),
        (0.15, 3.0, "3"),
        (0.3, 1.0 / 3.0, "3"),
    ] {
        found.push(Slip::new(prior, Change::Times(factor, written), times(factor)));
    }
    for places in [-6i8, -4, -3, -2, -1, 1, 2, 3, 4, 6] {
        let prior = if [-1, 1].contains(&places) { 1.3 } else { 0.1 };
        found.push(Slip::new(prior, Change::PowerOfTen(places), times(10f64.powi(places.into()))));
    }
    let prior = if node.dim == Dim::NONE { 8.0 } else { 1.2 };
    found.push(Slip::new(
        prior,
        Change::Inverted,
        Edit::with_literal(solution, at, 1.0, |own, one| Op::Div(one, own)),
    ));
    found.push(Slip::new(0.3, Change::Squared, Edit::then(solution, at, |own| Op::Power(own, 2))));
    found.push(Slip::new(0.6, Change::Rooted, Edit::then(solution, at, |own| Op::Root(own, 2))));
    if node.dim == Dim::ANGLE {
        let in_degrees = 180.0 / PI;
        found.push(Slip::new(5.0, Change::Degrees, times(in_degrees)));
        found.push(Slip::new(3.0, Change::Degrees, times(1.0 / in_degrees)));
        for turn in [PI / 2.0, PI, TAU] {
            let minus = |own, turn| Op::Sub(turn, own);
            found.push(Slip::new(2.5, Change::Direction, Edit::with_literal(solution, at, turn, minus)));
            found.push(Slip::new(0.5, Change::Direction, Edit::with_literal(solution, at, turn, Op::Add)));
            found.push(Slip::new(0.5, Change::Direction, Edit::with_literal(solution, at, turn, Op::Sub)));
        }
    } else if node.dim.angle != 0 {
        let per_degree = (PI / 180.0).powi(node.dim.angle.into());
        found.push(Slip::new(1.5, Change::Degrees, times(per_degree)));
        found.push(Slip::new(1.5, Change::Degrees, times(1.0 / per_degree)));
    }
    found
}

/// The common errors that the analysis knows of a step.
pub(super) fn of_common_errors(solution: &Solution, place: usize) -> Vec<Slip> {
    let at = solution.steps[place].result;
    let of_step = solution.common_errors.iter().filter(|error| error.step == place);
    let slip = |error: &CommonError| {
        Slip::new(10.0, Change::Common(error.what.clone()), Edit::op(at, alone(error.formula)))
    };
    of_step.map(slip).collect()
}

/// True for a declared error that is the arctangent of a quotient alone.
fn is_arctangent(solution: &Solution, declared: &Edit) -> bool {
    let of = |id: Id| &solution.trace.node(id).op;
    let Some((Op::Sum(all), _)) = declared.ops.last() else { return false };
    match &all[..] {
        [formula] => {
            matches!(of(*formula), Op::Atan2(y, x) if matches!((of(*y), of(*x)), (Op::Div(..), Op::Literal)))
        }
        _ => false,
    }
}

/// Edits of the operations of a formula.
pub(super) fn of_formula(solution: &Solution, formula: Id, found: &mut Vec<Slip>) {
    let mut seen: HashSet<Id> = HashSet::new();
    // Each node with the operation that it goes into: sums and products are edited as a whole.
    let mut open = vec![(formula, Part::Alone)];
    while let Some((id, part)) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        let kind = match &solution.trace.node(id).op {
            Op::Add(..) | Op::Sub(..) | Op::Sum(_) => Part::OfSum,
            Op::Mul(..) | Op::Div(..) => Part::OfProduct,
            Op::Neg(_) => part,
            _ => Part::Alone,
        };
        open.extend(solution.trace.operands(id).into_iter().map(|operand| (operand, kind)));
        match kind {
            Part::OfSum if part != Part::OfSum => of_sum(solution, id, found),
            Part::OfProduct if part != Part::OfProduct => of_product(solution, id, found),
            _ => {}
        }
        of_operation(solution, id, found);
    }
}

/// Operation that a node of a formula is a part of.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Alone,
    OfSum,
    OfProduct,
}

/// The terms of a sum, each with its sign.
fn terms(solution: &Solution, id: Id, sign: f64, out: &mut Vec<(Id, f64)>) {
    match &solution.trace.node(id).op {
        Op::Add(a, b) => {
            terms(solution, *a, sign, out);
            terms(solution, *b, sign, out);
        }
        Op::Sub(a, b) => {
            terms(solution, *a, sign, out);
            terms(solution, *b, -sign, out);
        }
        Op::Neg(a) => terms(solution, *a, -sign, out),
        Op::Sum(all) => all.iter().for_each(|id| terms(solution, *id, sign, out)),
        _ => out.push((id, sign)),
    }
}

/// Each term of a sum with the other sign, left out, or taken twice: the sum of all terms written anew.
fn of_sum(solution: &Solution, id: Id, found: &mut Vec<Slip>) {
    let mut all = Vec::new();
    terms(solution, id, 1.0, &mut all);
    if all.len() < 2 {
        return;
    }
    if let [(a, 1.0), (b, 1.0)] = all[..]
        && [a, b].iter().all(|id| is_scalar(solution, *id))
    {
        let first = Edit::first_new(solution);
        let series =
            vec![(Op::Mul(a, b), UNKNOWN), (Op::Add(a, b), UNKNOWN), (Op::Div(first, first + 1), UNKNOWN)];
        found.push(Slip::new(1.0, Change::SeriesForParallel, Edit { at: id, ops: series }));
        let squares = vec![
            (Op::Power(a, 2), UNKNOWN),
            (Op::Power(b, 2), UNKNOWN),
            (Op::Add(first, first + 1), UNKNOWN),
            (Op::Root(first + 2, 2), UNKNOWN),
        ];
        found.push(Slip::new(0.5, Change::AddedAsVectors, Edit { at: id, ops: squares }));
    }
    for at in 0..all.len() {
        let mut with = |prior: f64, change: Change, factor: f64| {
            let edit = sum_of(solution, id, &all, at, factor);
            found.push(Slip::new(prior, change, edit).of(all[at].0));
        };
        // A term that is a step of its own may have its sign wrong there.
        let is_step = matches!(solution.trace.node(all[at].0).op, Op::Step(_));
        with(if is_step { 6.0 } else { 7.5 }, Change::TermSign, -1.0);
        with(11.0, Change::TermLeftOut, 0.0);
        with(1.0, Change::TermTwice, 2.0);
        with(0.4, Change::PowerOfTen(1), 10.0);
        with(0.3, Change::PowerOfTen(-1), 0.1);
        with(0.1, Change::PowerOfTen(3), 1e3);
        with(0.1, Change::PowerOfTen(-3), 1e-3);
        with(0.7, Change::Times(0.5, "2"), 0.5);
    }
}

/// A sum with one term so many times.
fn sum_of(solution: &Solution, id: Id, all: &[(Id, f64)], changed: usize, factor: f64) -> Edit {
    let first = Edit::first_new(solution);
    let mut ops: Vec<(Op, Number)> = Vec::new();
    let mut sum: Option<Id> = None;
    for (at, (term, sign)) in all.iter().enumerate() {
        let by = sign * if at == changed { factor } else { 1.0 };
        if by == 0.0 {
            continue;
        }
        let mut add = |op: Op, number: f64| {
            ops.push((op, Number::Scalar(number)));
            first + ops.len() as Id - 1
        };
        let size = if by.abs() == 1.0 {
            *term
        } else {
            let literal = add(Op::Literal, by.abs());
            add(Op::Mul(literal, *term), f64::NAN)
        };
        sum = Some(match sum {
            None if by > 0.0 => size,
            None => add(Op::Neg(size), f64::NAN),
            Some(sum) if by > 0.0 => add(Op::Add(sum, size), f64::NAN),
            Some(sum) => add(Op::Sub(sum, size), f64::NAN),
        });
    }
    match sum {
        Some(only) if ops.is_empty() => Edit::op(id, alone(only)),
        _ => Edit { at: id, ops },
    }
}

/// The numbers of which a sum adds the squares.
fn squares(solution: &Solution, sum: Id) -> Option<(Id, Id)> {
    let mut all = Vec::new();
    terms(solution, sum, 1.0, &mut all);
    let base = |(id, _): &(Id, f64)| match solution.trace.node(*id).op {
        Op::Power(base, 2) => Some(base),
        _ => None,
    };
    match &all[..] {
        [first, second] => Some((base(first)?, base(second)?)),
        _ => None,
    }
}

/// Other operations in place of one.
fn of_operation(solution: &Solution, id: Id, found: &mut Vec<Slip>) {
    let mut may = |prior: f64, change: Change, op: Op, of: Id| {
        found.push(Slip::new(prior, change, Edit::op(id, op)).of(of));
    };
    match &solution.trace.node(id).op {
        Op::Power(a, n) if *n > 1 => {
            may(if *n == 2 { 15.0 } else { 8.0 }, Change::Exponent(*n, 1), alone(*a), *a);
            if *n > 2 {
                may(15.0, Change::Exponent(*n, n - 1), Op::Power(*a, n - 1), *a);
            }
            may(1.0, Change::Exponent(*n, n + 1), Op::Power(*a, n + 1), *a);
        }
        Op::Power(a, n) if *n < -1 => may(5.0, Change::Exponent(*n, -1), Op::Power(*a, -1), *a),
        Op::Root(a, n) => {
            may(20.0, Change::RootLeftOut, alone(*a), *a);
            if let (2, Some((first, second))) = (*n, squares(solution, *a)) {
                found.extend(added_directly(solution, id, |_| (Vec::new(), [first, second])));
            }
        }
        Op::Magnitude(a) => {
            may(5.0, Change::RootLeftOut, Op::Dot(*a, *a), *a);
            let component = |axis| (Op::Component(*a, axis), UNKNOWN);
            let components = |first| (vec![component(0), component(1)], [first, first + 1]);
            found.extend(added_directly(solution, id, components));
        }
        Op::Call(function, a) => of_function(solution, id, *function, *a, found),
        Op::Neg(a) => may(7.0, Change::TermSign, alone(*a), *a),
        Op::Atan2(y, x) => {
            may(3.0, Change::Inverted, Op::Atan2(*x, *y), id);
            for function in [Function::Asin, Function::Acos] {
                let first = Edit::first_new(solution);
                let ops = vec![(Op::Div(*y, *x), UNKNOWN), (Op::Call(function, first), UNKNOWN)];
                let change = Change::Trigonometric("arctan", crate::printer::function(function));
                found.push(Slip::new(4.0, change, Edit { at: id, ops }));
            }
            found.extend(without_quadrant(solution, id, *y, *x));
        }
        Op::Cross(a, b) => may(2.0, Change::TermSign, Op::Cross(*b, *a), id),
        Op::Compose(parts) => {
            for axis in 0..3 {
                let first = Edit::first_new(solution);
                let minus = (Op::Neg(parts[axis]), UNKNOWN);
                let zero = (Op::Literal, Number::Scalar(0.0));
                for (prior, change, part) in
                    [(3.0, Change::TermSign, minus), (4.0, Change::TermLeftOut, zero)]
                {
                    let mut others = *parts;
                    others[axis] = first;
                    let whole = (Op::Compose(others), UNKNOWN);
                    found.push(
                        Slip::new(prior, change, Edit { at: id, ops: vec![part, whole] }).of(parts[axis]),
                    );
                }
            }
        }
        _ => {}
    }
}

/// Another function, or an argument in degrees.
fn of_function(solution: &Solution, id: Id, function: Function, argument: Id, found: &mut Vec<Slip>) {
    use Function::{Acos, Asin, Cos, Sin, Tan};
    let name = crate::printer::function;
    let others: &[(f64, Function)] = match function {
        Sin => &[(12.0, Cos), (1.0, Tan)],
        Cos => &[(20.0, Sin), (1.0, Tan)],
        Tan => &[(8.0, Sin), (6.0, Cos)],
        Asin => &[(8.0, Acos)],
        Acos => &[(8.0, Asin)],
        _ => &[],
    };
    for (prior, other) in others {
        let change = Change::Trigonometric(name(function), name(*other));
        found.push(Slip::new(*prior, change, Edit::op(id, Op::Call(*other, argument))).of(argument));
    }
    if function == Tan {
        let inverse = Edit::with_literal(solution, id, 1.0, |own, one| Op::Div(one, own));
        found.push(Slip::new(3.0, Change::Inverted, inverse));
    }
    if function == Function::Ln {
        let other = Edit::op(id, Op::Call(Function::Log10, argument));
        found.push(Slip::new(10.0, Change::Trigonometric(name(function), name(Function::Log10)), other));
    }
    if matches!(function, Sin | Cos | Tan) {
        let first = Edit::first_new(solution);
        for (prior, change, factor) in [
            (2.0, Change::Degrees, 180.0 / PI),
            (2.0, Change::Degrees, PI / 180.0),
            (0.4, Change::Times(2.0, "2"), 2.0),
            (0.4, Change::Times(0.5, "2"), 0.5),
        ] {
            let ops = vec![
                (Op::Literal, Number::Scalar(factor)),
                (Op::Mul(first, argument), UNKNOWN),
                (Op::Call(function, first + 1), UNKNOWN),
            ];
            found.push(Slip::new(prior, change, Edit { at: id, ops }));
        }
        // A calculator in the wrong mode is so for every function of the angle.
        if !matches!(solution.trace.node(argument).op, Op::Step(_) | Op::Given { .. }) {
            for factor in [180.0 / PI, PI / 180.0] {
                let edit = Edit::with_literal(solution, argument, factor, |own, by| Op::Mul(by, own));
                found.push(Slip::new(2.0, Change::Degrees, edit));
            }
        }
    }
    // The other angle of the same sine or cosine.
    let other: Option<(f64, fn(Id, Id) -> Op)> = match function {
        Asin => Some((PI, |own, turn| Op::Sub(turn, own))),
        Acos => Some((0.0, |own, zero| Op::Sub(zero, own))),
        _ => None,
    };
    if let Some((turn, op)) = other {
        found.push(Slip::new(3.0, Change::OtherAngle, Edit::with_literal(solution, id, turn, op)));
    }
}

/// The arctangent of the quotient in place of the angle of a direction on the left, and the acute angle of its size.
fn without_quadrant(solution: &Solution, id: Id, y: Id, x: Id) -> Vec<Slip> {
    let [up, along] = [y, x].map(|id| scalar(solution.trace.node(id).number));
    let first = Edit::first_new(solution);
    let one = (Op::Literal, Number::Scalar(1.0));
    let mut found = Vec::new();
    if along < 0.0 {
        let ops = vec![(Op::Div(y, x), UNKNOWN), one.clone(), (Op::Atan2(first, first + 1), UNKNOWN)];
        found.push(Slip::new(6.0, Change::Quadrant, Edit { at: id, ops }));
    }
    // Below the axis the arctangent is acute itself.
    if along < 0.0 && up > 0.0 {
        let ops = vec![
            (Op::Div(y, x), UNKNOWN),
            (Op::Call(Function::Abs, first), UNKNOWN),
            one,
            (Op::Atan2(first + 1, first + 2), UNKNOWN),
        ];
        found.push(Slip::new(6.0, Change::AcuteAngle, Edit { at: id, ops }));
    }
    found
}

/// Two components added as numbers in place of the root of the sum of their squares: with their signs, with the sum of
/// both signs, or without signs.
fn added_directly(
    solution: &Solution,
    id: Id,
    components: impl Fn(Id) -> (Vec<(Op, Number)>, [Id; 2]),
) -> [Slip; 3] {
    let begun = || {
        let (ops, both) = components(Edit::first_new(solution));
        let next = Edit::first_new(solution) + ops.len() as Id;
        (ops, both, next)
    };
    let slip = |ops| Slip::new(5.0, Change::AddedDirectly, Edit { at: id, ops });
    let (mut sum, [a, b], next) = begun();
    sum.push((Op::Add(a, b), UNKNOWN));
    let mut size = sum.clone();
    size.push((Op::Call(Function::Abs, next), UNKNOWN));
    let (mut sizes, [a, b], next) = begun();
    sizes.push((Op::Call(Function::Abs, a), UNKNOWN));
    sizes.push((Op::Call(Function::Abs, b), UNKNOWN));
    sizes.push((Op::Add(next, next + 1), UNKNOWN));
    [slip(sum), slip(size), slip(sizes)]
}

/// The last edit of a number that is read as it is.
pub(super) fn rounded(value: f64, unit: &dalembert_units::Unit, digits: i32) -> f64 {
    let shown = unit.value(value);
    if shown == 0.0 || !shown.is_finite() {
        return value;
    }
    let place = 10f64.powi(digits - 1 - shown.abs().log10().floor() as i32);
    unit.si((shown * place).round() / place)
}
