//! Formula of an unknown, where the given answer follows from it through one path of operations that have an inverse.
//!
//! The path is read off the trace of the problem solved with the unknown found. It stands for the whole problem only if it
//! gives the answer of the plain reading at every point of the range that was examined: a number that a numerical method
//! found, or that depends on the unknown behind `.value()`, is noticed there.

use std::{
    collections::{BTreeMap, BTreeSet},
    f64::consts::{PI, TAU},
    sync::Arc,
};

use dalembert_numerics::Real;

use super::{
    DeterminedInput, ReachedAnswer,
    search::{ACCEPTED, Evaluate, is_same},
};
use crate::{
    AnswerValue, Number, Reason, Refusal, Sheet, Solution, Symbol, Term, Text, Worksheet,
    intern::unit_text,
    trace::{Function, Id, Op},
};

/// The most operations of a formula.
const LONGEST: usize = 30;
/// The most nodes that the operands of a formula were made from.
const MOST_NODES: usize = 500;
/// The most branches that are followed.
const MOST_BRANCHES: usize = 64;
/// The share of an answer by which path and plain reading may differ.
const AGREEMENT: f64 = 1e-7;
/// The share of itself by which a solution of the search may miss that of the formula, which it finds less well where
/// the answer only touches the given one.
const NEAR: f64 = 1e-4;

/// Formula of an unknown: the operations that lead from the given answer back to it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Inverse {
    /// The solution whose trace the operations are of.
    base: Arc<Solution>,
    /// The operations from the answer to the unknown, each with the branch of its inverse.
    operations: Vec<(Operation, i32)>,
    /// The nodes that other operands were made from, ascending.
    operands: Vec<Id>,
    /// Symbol of the given answer.
    symbol: Symbol,
    /// Path of the value of the given answer.
    path: String,
    /// The operations of which the solutions take several branches.
    branches: Vec<Text>,
    /// The first solution as the search found it, where it was found well.
    searched: Option<f64>,
}

/// An operation on `x`, and its other operand.
#[derive(Clone, Debug, PartialEq)]
enum Operation {
    /// `x + a`, the sum of several others too.
    Plus(Vec<Id>),
    /// `x − a`
    Minus(Id),
    /// `a − x`
    From(Id),
    /// `a x`
    Times(Id),
    /// `x / a`
    Over(Id),
    /// `a / x`
    Under(Id),
    /// `−x`
    Negated,
    /// `xⁿ`
    Power(i8),
    /// The `n`th root.
    Root(u8),
    /// `xᵃ`
    RaisedTo(Id),
    /// `aˣ`
    Exponent(Id),
    /// A function of one number.
    Call(Function),
    /// `atan2(x, a)`
    AngleOver(Id),
    /// `atan2(a, x)`
    AngleUnder(Id),
}

/// Search for the inverse of a trace: the unknown, the given answer, and what is known of the range.
pub(super) struct Question<'a, 'e> {
    /// The unknown.
    pub(super) unknown: &'a DeterminedInput,
    /// The given answer.
    pub(super) given: &'a ReachedAnswer,
    /// Path of the row of the given answer.
    pub(super) row: &'a str,
    /// Solutions that the search found.
    pub(super) found: &'a [Vec<f64>],
    /// Points examined, each with the answer there.
    pub(super) scan: &'a [(f64, f64)],
    /// The size of an answer that a solution is compared with.
    pub(super) size: f64,
    /// Plain reading.
    pub(super) evaluate: &'a mut Evaluate<'e>,
}

/// Every solution in the range, ascending, and the formula of the first one; `None` where the trace has no inverse, or its
/// solutions are not those of the search.
///
/// # Errors
/// [`Refusal::Stopped`] alone.
pub(super) fn inverse(
    base: Solution,
    question: Question<'_, '_>,
) -> Result<Option<(Vec<Vec<f64>>, Inverse)>, Refusal> {
    let Question { unknown, given, row, found, scan, size, evaluate } = question;
    let of_name = base.computed.iter().find(|(path, _)| *path == unknown.name);
    let value = base.answer(&given.name).map(|answer| &answer.value);
    let (Some((_, from)), Some(&AnswerValue::Number(_, to))) = (of_name, value) else { return Ok(None) };
    let Some(operations) = path(&base, *from, to) else { return Ok(None) };
    let (Some(symbol), Some(operands)) = (symbol_of(&base, to), operands(&base, &operations)) else {
        return Ok(None);
    };
    let of = |id: Id| scalar(&base, id).unwrap_or(f64::NAN);
    let Some(covered) = covered(&operations, scan, &of) else { return Ok(None) };
    let Some(candidates) = candidates(&operations, &covered, given.given, &of) else { return Ok(None) };
    let [from, to] = unknown.range;
    let mut solutions: Vec<(f64, Vec<i32>)> = Vec::new();
    for (x, branches) in candidates {
        let is_known = || solutions.iter().any(|(known, _)| is_same(&[*known], &[x]));
        if (from..=to).contains(&x)
            && !is_known()
            && (evaluate(&[x])?[0] - given.given).abs() <= ACCEPTED * size
        {
            solutions.push((x, branches));
        }
    }
    solutions.sort_by(|a, b| a.0.total_cmp(&b.0));
    let is_there = |x: f64| solutions.iter().any(|(known, _)| (known - x).abs() <= NEAR * known.abs());
    let (true, Some((x, first))) = (found.iter().all(|x| is_there(x[0])), solutions.first()) else {
        return Ok(None);
    };
    let differ = |n: usize| solutions.iter().any(|(_, branches)| branches[n] != first[n]);
    let branches = operations.iter().enumerate().filter(|(n, _)| differ(*n));
    let branches = branches.map(|(_, operation)| operation.branches_in_words()).collect();
    let operations = operations.into_iter().zip(first.iter().copied()).collect();
    let is_close = |searched: &f64| (searched - x).abs() <= ACCEPTED * x.abs();
    let searched = found.iter().map(|x| x[0]).find(is_close);
    let all = solutions.iter().map(|(x, _)| vec![*x]).collect();
    let path = format!("{row}.value");
    let base = Arc::new(base);
    Ok(Some((all, Inverse { base, operations, operands, symbol, path, branches, searched })))
}

fn scalar(solution: &Solution, id: Id) -> Option<f64> {
    match solution.trace.node(id).number {
        Number::Scalar(x) => Some(x),
        Number::Vector(_) => None,
    }
}

fn symbol_of(solution: &Solution, id: Id) -> Option<Symbol> {
    let Op::Step(step) = solution.trace.node(id).op else { return None };
    Some(solution.steps[step].symbol)
}

/// The operations from an answer back to the unknown; `None` where several paths lead there, or one of operations without
/// an inverse.
fn path(solution: &Solution, unknown: Id, answer: Id) -> Option<Vec<Operation>> {
    let mut depends = vec![false; answer as usize + 1];
    for id in 0..=answer {
        let operands = solution.operands(id);
        depends[id as usize] = id == unknown || operands.iter().any(|operand| depends[*operand as usize]);
    }
    let depends = |id: &Id| depends[*id as usize];
    // The operand that depends on the unknown: the left one, or the right.
    let side = |a: Id, b: Id, left: fn(Id) -> Operation, right: fn(Id) -> Operation| match (
        depends(&a),
        depends(&b),
    ) {
        (true, false) => Some((a, left(b))),
        (false, true) => Some((b, right(a))),
        _ => None,
    };
    let plus = |id: Id| Operation::Plus(vec![id]);
    let mut operations = Vec::new();
    let mut at = answer;
    while at != unknown {
        scalar(solution, at)?;
        let (next, operation) = match solution.trace.node(at).op {
            Op::Step(step) => {
                at = solution.steps[step].formula?;
                continue;
            }
            Op::Add(a, b) => side(a, b, plus, plus)?,
            Op::Sub(a, b) => side(a, b, Operation::Minus, Operation::From)?,
            Op::Mul(a, b) if a == b => (a, Operation::Power(2)),
            Op::Mul(a, b) => side(a, b, Operation::Times, Operation::Times)?,
            Op::Div(a, b) => side(a, b, Operation::Over, Operation::Under)?,
            Op::Neg(a) => (a, Operation::Negated),
            Op::Power(a, n) if n != 0 => (a, Operation::Power(n)),
            Op::Root(a, n) if n > 0 && i8::try_from(n).is_ok() => (a, Operation::Root(n)),
            Op::Raised(a, b) => side(a, b, Operation::RaisedTo, Operation::Exponent)?,
            Op::Atan2(y, x) => side(y, x, Operation::AngleOver, Operation::AngleUnder)?,
            Op::Call(function, a) if has_inverse(function) => (a, Operation::Call(function)),
            Op::Sum(ref all) => {
                let (inner, others): (Vec<Id>, Vec<Id>) = all.iter().copied().partition(depends);
                let [one] = inner[..] else { return None };
                (one, Operation::Plus(others))
            }
            _ => return None,
        };
        operations.push(operation);
        at = next;
    }
    (1..=LONGEST).contains(&operations.len()).then_some(operations)
}

fn has_inverse(function: Function) -> bool {
    !matches!(function, Function::Sinh | Function::Cosh | Function::Tanh)
}

/// The nodes that the other operands were made from, ascending, where each can be written again.
fn operands(solution: &Solution, operations: &[Operation]) -> Option<Vec<Id>> {
    let mut all = BTreeSet::new();
    for id in operations.iter().flat_map(Operation::others) {
        all.extend(solution.ancestors(id));
    }
    let is_scalar = |id: &Id| {
        let has_operation = !matches!(
            solution.trace.node(*id).op,
            Op::Dot(..) | Op::Cross(..) | Op::Magnitude(_) | Op::Component(..) | Op::Compose(_)
        );
        has_operation && scalar(solution, *id).is_some()
    };
    (all.len() <= MOST_NODES && all.iter().all(is_scalar)).then(|| all.into_iter().collect())
}

/// The least and the largest `x` of each operation in the range; `None` where the operations do not give the answer of
/// the plain reading.
fn covered(operations: &[Operation], scan: &[(f64, f64)], of: &impl Fn(Id) -> f64) -> Option<Vec<[f64; 2]>> {
    let largest = scan.iter().map(|(_, answer)| answer.abs()).filter(|size| size.is_finite());
    let noise = 1e-12 * largest.fold(0.0, f64::max);
    let mut covered = vec![[f64::INFINITY, f64::NEG_INFINITY]; operations.len()];
    for &(at, answer) in scan {
        let mut x = at;
        for (operation, [least, most]) in operations.iter().zip(&mut covered).rev() {
            (*least, *most) = (least.min(x), most.max(x));
            x = operation.applied(x, of);
        }
        let near = |x: f64| (x - answer).abs() <= AGREEMENT * x.abs().max(answer.abs()) + noise;
        if answer.is_finite() && !near(x) {
            return None;
        }
    }
    Some(covered)
}

/// Values of the unknown for every branch, with the branches taken; `None` where there are too many.
fn candidates(
    operations: &[Operation],
    covered: &[[f64; 2]],
    given: f64,
    of: &impl Fn(Id) -> f64,
) -> Option<Vec<(f64, Vec<i32>)>> {
    let mut all = vec![(given, Vec::new())];
    for (operation, covered) in operations.iter().zip(covered) {
        let mut next = Vec::new();
        for (y, taken) in &all {
            for branch in operation.branches(*covered) {
                let mut taken: Vec<i32> = taken.clone();
                taken.push(branch);
                next.push((operation.undone(*y, branch, of), taken));
            }
        }
        next.retain(|(x, _)| x.is_finite());
        if next.len() > MOST_BRANCHES {
            return None;
        }
        all = next;
    }
    Some(all)
}

impl Operation {
    fn others(&self) -> Vec<Id> {
        match self {
            Operation::Plus(all) => all.clone(),
            Operation::Minus(a)
            | Operation::From(a)
            | Operation::Times(a)
            | Operation::Over(a)
            | Operation::Under(a)
            | Operation::RaisedTo(a)
            | Operation::Exponent(a)
            | Operation::AngleOver(a)
            | Operation::AngleUnder(a) => vec![*a],
            Operation::Negated | Operation::Power(_) | Operation::Root(_) | Operation::Call(_) => Vec::new(),
        }
    }

    /// The result of the operation.
    fn applied(&self, x: f64, of: &impl Fn(Id) -> f64) -> f64 {
        match self {
            Operation::Plus(all) => x + all.iter().map(|id| of(*id)).sum::<f64>(),
            Operation::Minus(a) => x - of(*a),
            Operation::From(a) => of(*a) - x,
            Operation::Times(a) => of(*a) * x,
            Operation::Over(a) => x / of(*a),
            Operation::Under(a) => of(*a) / x,
            Operation::Negated => -x,
            Operation::Power(n) => x.powi((*n).into()),
            Operation::Root(n) => Real::root(x, *n),
            Operation::RaisedTo(a) => x.powf(of(*a)),
            Operation::Exponent(a) => of(*a).powf(x),
            Operation::Call(function) => function.of(x),
            Operation::AngleOver(a) => x.atan2(of(*a)),
            Operation::AngleUnder(a) => of(*a).atan2(x),
        }
    }

    /// The operand of a result, on a branch of the inverse: 0, or 1 for the other sign; of an angle the half turns.
    fn undone<N: Real>(&self, y: N, branch: i32, of: &impl Fn(Id) -> N) -> N {
        let signed = |x: N| if branch == 1 { -x } else { x };
        let turns = TAU * f64::from(branch.div_euclid(2));
        let is_other = branch.rem_euclid(2) == 1;
        let plus = |x: N, constant: f64| if constant == 0.0 { x } else { x + N::from(constant) };
        match self {
            Operation::Plus(all) => all.iter().fold(y, |y, a| y - of(*a)),
            Operation::Minus(a) => y + of(*a),
            Operation::From(a) => of(*a) - y,
            Operation::Times(a) => y / of(*a),
            Operation::Over(a) => of(*a) * y,
            Operation::Under(a) => of(*a) / y,
            Operation::Negated => -y,
            Operation::Power(n) => {
                let y = if *n < 0 { N::from(1.0) / y } else { y };
                match n.unsigned_abs() {
                    1 => y,
                    n if n % 2 == 1 && y.value() < 0.0 => -(-y).root(n),
                    n => signed(y.root(n)),
                }
            }
            // A root of an even order is never negative.
            Operation::Root(n) if n % 2 == 0 && y.value() < 0.0 => N::from(f64::NAN),
            Operation::Root(n) => y.powi(i8::try_from(*n).unwrap_or(i8::MAX)),
            Operation::RaisedTo(a) => y.pow(N::from(1.0) / of(*a)),
            Operation::Exponent(a) => y.ln() / of(*a).ln(),
            Operation::AngleOver(a) => of(*a) * y.tan(),
            Operation::AngleUnder(a) => of(*a) / y.tan(),
            Operation::Call(function) => match function {
                Function::Sin if is_other => N::from(PI + turns) - y.asin(),
                Function::Sin => plus(y.asin(), turns),
                Function::Cos if is_other => plus(-y.acos(), turns),
                Function::Cos => plus(y.acos(), turns),
                Function::Tan => plus(y.atan2(N::from(1.0)), PI * f64::from(branch)),
                Function::Asin => y.sin(),
                Function::Acos => y.cos(),
                Function::Exp => y.ln(),
                Function::Ln => y.exp(),
                Function::Log10 => N::from(10.0).pow(y),
                Function::Abs => signed(y),
                Function::Sinh | Function::Cosh | Function::Tanh => N::from(f64::NAN),
            },
        }
    }

    /// The branches that may give an operand between two values.
    fn branches(&self, [least, most]: [f64; 2]) -> Vec<i32> {
        let between = |half_turns: f64| {
            let limit = |x: f64| (x / PI).clamp(-1e4, 1e4) as i32;
            let outer = half_turns as i32;
            (limit(least) - outer..=limit(most) + outer).take(2 * MOST_BRANCHES).collect()
        };
        match self {
            Operation::Power(n) if n % 2 == 0 => vec![0, 1],
            Operation::Call(Function::Abs) => vec![0, 1],
            Operation::Call(Function::Sin | Function::Cos) => between(3.0),
            Operation::Call(Function::Tan) => between(2.0),
            _ => vec![0],
        }
    }

    /// The branches of the inverse, in words.
    fn branches_in_words(&self) -> Text {
        match self {
            Operation::Power(_) => Text::new("both signs of the root"),
            Operation::Call(Function::Sin) => Text::new("the angles of the arcsine"),
            Operation::Call(Function::Cos) => Text::new("the angles of the arccosine"),
            Operation::Call(Function::Tan) => Text::new("the angles of the arctangent"),
            _ => Text::new("both signs of the absolute value"),
        }
    }
}

impl Inverse {
    /// The operations of which the solutions take several branches, in words; none where each operation is one-to-one in the
    /// range.
    pub(super) fn branches(&self) -> &[Text] {
        &self.branches
    }

    /// The first solution as the search found it.
    pub(super) fn searched(&self) -> Option<f64> {
        self.searched
    }

    /// Writes the formula of the unknown as a step, and before it the steps that its operands are results of.
    pub(super) fn write<'s>(
        &self,
        sheet: &'s Sheet<'s>,
        (symbol, unit): (Symbol, &'static str),
        given: &ReachedAnswer,
        why: Text,
    ) -> Term<'s> {
        let mut written: BTreeMap<Id, Term<'s>> = BTreeMap::new();
        for id in &self.operands {
            let term = self.again(*id, &written, sheet);
            written.insert(*id, term);
        }
        let given = match sheet.lifted(&self.path) {
            Some(id) => id,
            None => sheet.lift(&self.path, self.symbol, &given.unit, Number::Scalar(given.given)),
        };
        let of = |id: Id| written[&id];
        let undone = |y: Term<'s>, (operation, branch): &(Operation, i32)| operation.undone(y, *branch, &of);
        let value = self.operations.iter().fold(sheet.term(given), undone);
        sheet.step(symbol, unit, value, why)
    }

    /// Writes a node of the trace again on a sheet that has its operands.
    fn again<'s>(&self, id: Id, written: &BTreeMap<Id, Term<'s>>, sheet: &'s Sheet<'s>) -> Term<'s> {
        let node = self.base.trace.node(id);
        let value = scalar(&self.base, id).unwrap_or(f64::NAN);
        let of = |id: &Id| written[id];
        match &node.op {
            Op::Literal => Term::from(value),
            Op::Constant(unit) => sheet.constant(value, unit),
            Op::Given { symbol, unit, path } => {
                let lifted = sheet.lifted(path);
                sheet.term(lifted.unwrap_or_else(|| sheet.lift(path, *symbol, unit, node.number)))
            }
            Op::Step(step) => {
                let step = &self.base.steps[*step];
                let unit = unit_text(&step.unit);
                let why = Reason { reason: step.why.clone(), cite: step.cite };
                let formula = step.formula.map(|formula| of(&formula));
                let value_of = formula.map(|formula| Number::Scalar(formula.value()));
                sheet.step_early(step.symbol, value_of, &step.why, || match formula {
                    Some(formula) => sheet.step(step.symbol, unit, formula, why),
                    None => sheet.numerical_within(step.symbol, unit, value, node.error, why),
                })
            }
            Op::Add(a, b) => of(a) + of(b),
            Op::Sub(a, b) => of(a) - of(b),
            Op::Mul(a, b) => of(a) * of(b),
            Op::Div(a, b) => of(a) / of(b),
            Op::Neg(a) => -of(a),
            Op::Power(a, n) => of(a).powi(*n),
            Op::Root(a, n) => of(a).root(*n),
            Op::Raised(a, b) => of(a).pow(of(b)),
            Op::Min(a, b) => of(a).min(of(b)),
            Op::Max(a, b) => of(a).max(of(b)),
            Op::Atan2(y, x) => of(y).atan2(of(x)),
            Op::Sum(all) => Real::sum(all.iter().map(of)),
            Op::Call(function, a) => function.of(of(a)),
            // `operands` lets no vector pass.
            Op::Dot(..) | Op::Cross(..) | Op::Magnitude(_) | Op::Component(..) | Op::Compose(_) => {
                Term::from(f64::NAN)
            }
        }
    }
}
