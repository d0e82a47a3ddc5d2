//! Cancellation: every formula of every analysis read again with 77 digits, from the same inputs.
//!
//! The trace of a solution holds each operation, so that the whole computation is repeated with numbers of
//! [`PRECISION`] bits. What a numerical method found, and what was typed, is taken as exact. With the exact result
//! `y(x₁, x₂, …)` of a number that was computed as `ŷ`, the formula is sound if
//!
//! `|ŷ − y| ≤ max(10⁻¹² |y|, 16 ε Σ |xᵢ ∂y/∂xᵢ|)`, `ε = 2⁻⁵²`:
//!
//! what is lost beyond twelve digits is what the last places of the inputs change, and no formula for these inputs keeps
//! more. Where `y` is zero, `ŷ` is noise that the program shows as zero. A formula that subtracts two nearly equal numbers, as `L − L cos α` at a small angle, is not.

use std::{
    collections::BTreeMap,
    f64::consts::TAU,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
};

use astro_float_num::{BigFloat, Consts, RoundingMode};
use dalembert_core::{
    AnswerValue, Entry, Number, Record, Solution, Stop,
    trace::{self, Function, Id, Op},
    vary,
};
use itertools::Itertools as _;

use crate::{
    perturbation::perturbed,
    problems::{cases_of, on_all_cores},
    some,
};

/// Bits of the exact numbers: 77 decimal digits.
pub const PRECISION: usize = 256;
/// Relative error that no formula has to explain.
const FLOOR: f64 = 1e-12;
/// Multiple of the condition that rounding on the way explains.
const STEPS: f64 = 16.0;
/// Factors by which one input after the other is changed, to come near the singular points of a formula: angles, lengths
/// and ratios that vanish.
pub const SMALL: [f64; 2] = [1e-3, 1e-6];
/// Relative change by the last places of the inputs beyond which it is not small.
const LOST: f64 = 1e-3;
/// Size below which a number of many digits is zero, over what was added up to make it.
const ZERO: f64 = 1e-60;
const ROUNDING: RoundingMode = RoundingMode::ToEven;

/// Extent of a comparison, and the formulas that were found wanting.
#[derive(Clone, Debug, Default)]
pub struct Compared {
    /// Solutions read again.
    pub solutions: usize,
    /// Numbers compared: answers and results of steps.
    pub numbers: usize,
    /// Numbers with fewer than twelve digits that their condition explains.
    pub explained: usize,
    /// Formulas with fewer digits than their condition lets them have: analysis and quantity, how often, and the first.
    pub faults: BTreeMap<String, (usize, String)>,
}

/// Compares the formulas of every analysis with exact arithmetic: at each case, at `draws` problems with all numbers
/// changed at random, and with one input after the other times each of `factors`, such as [`SMALL`].
pub fn compared(entries: &[&'static Entry], draws: u64, factors: &[f64], seed: u64) -> Compared {
    some(entries);
    let jobs: Vec<(&'static Entry, String, Record)> = entries
        .iter()
        .flat_map(|entry| cases_of(entry).into_iter().map(move |case| (*entry, case)))
        .filter(|(_, case)| case.refused.is_none())
        .filter_map(|(entry, case)| Some((entry, case.name.clone(), case.record(entry).ok()?)))
        .collect();
    let (compared, solved) = (Mutex::new(Compared::default()), AtomicUsize::new(0));
    on_all_cores(&jobs, |at, (entry, case, record)| {
        let mut records = vec![("as given".to_owned(), record.clone())];
        let key = (at as u64).wrapping_mul(0x0100_0000_01b3);
        records.extend((0..draws).map(|draw| (format!("draw {draw}"), perturbed(record, seed, key + draw))));
        for (input, factor) in vary::inputs(record).iter().cartesian_product(factors) {
            if let Some(changed) = vary::changed(record, &input.path, factor * input.si) {
                records.push((format!("{} × {factor:e}", input.path), changed));
            }
        }
        let mut consts = Consts::new().expect("there is memory");
        for (name, record) in records {
            let Ok(solution) = entry.solve(&record, &Stop::new()) else { continue };
            solved.fetch_add(1, Ordering::Relaxed);
            let exact = Exact::of(&solution, &mut consts);
            let mut met = compared.lock().expect("no panic while it is held");
            for (quantity, id) in targets(&solution) {
                met.numbers += 1;
                match exact.verdict(id, &mut consts) {
                    Verdict::Sound => {}
                    Verdict::Explained => met.explained += 1,
                    Verdict::Lost(words) => {
                        let first = || (0, format!("{case}, {name}: {words}"));
                        met.faults
                            .entry(format!("{}: {quantity}", entry.about.id))
                            .or_insert_with(first)
                            .0 += 1;
                    }
                }
            }
        }
    });
    let mut compared = compared.into_inner().expect("no panic while it was held");
    compared.solutions = solved.into_inner();
    compared
}

/// Answers, and results of steps, by name and node.
fn targets(solution: &Solution) -> Vec<(String, Id)> {
    let answers = solution.answers.iter().filter_map(|answer| match &answer.value {
        AnswerValue::Number(_, id) => Some((answer.name.to_string(), *id)),
        _ => None,
    });
    let steps = solution
        .steps
        .iter()
        .filter_map(|step| Some((format!("step {}{}", step.symbol.base, step.symbol.of), step.formula?)));
    answers.chain(steps).collect()
}

enum Verdict {
    Sound,
    Explained,
    Lost(String),
}

/// A number of many digits.
#[derive(Clone)]
enum Many {
    Scalar(BigFloat),
    Vector(Box<[BigFloat; 3]>),
}

/// The numbers of a trace with many digits.
struct Exact<'s> {
    solution: &'s Solution,
    numbers: Vec<Many>,
}

impl<'s> Exact<'s> {
    fn of(solution: &'s Solution, consts: &mut Consts) -> Self {
        let mut numbers: Vec<Many> = Vec::with_capacity(solution.trace.nodes.len());
        for node in &solution.trace.nodes {
            let number = match node.op {
                Op::Literal | Op::Constant(_) | Op::Given { .. } => taken(node.number),
                Op::Step(step) => match solution.steps[step].formula {
                    Some(id) => numbers[id as usize].clone(),
                    None => taken(node.number),
                },
                ref op => operation(op, &numbers, consts),
            };
            numbers.push(number);
        }
        Self { solution, numbers }
    }

    fn verdict(&self, id: Id, consts: &mut Consts) -> Verdict {
        let (node, exact) = (self.solution.trace.node(id), &self.numbers[id as usize]);
        let off = size(&difference(&taken(node.number), exact), consts);
        let value = size(exact, consts);
        // Zero, but for the last of the many digits: the program shows it as zero.
        if value <= ZERO * node.scale && off <= trace::ROUNDING * node.scale {
            return Verdict::Sound;
        }
        // The exact value of an operation may not exist beside that of rounded operands: `arccos(1 + 10⁻²⁰)`.
        if off <= FLOOR * value || !off.is_finite() {
            return Verdict::Sound;
        }
        let input = self.input_error(id);
        // To first order; where the inputs leave no digit at all, the first order says nothing more.
        if off <= STEPS * f64::EPSILON * input
            || input.is_nan()
            || STEPS * f64::EPSILON * input >= LOST * value
        {
            return Verdict::Explained;
        }
        // Both sides of the angle at which a full turn begins.
        if matches!(node.op, Op::Atan2(..)) && (off - TAU).abs() <= FLOOR * TAU {
            return Verdict::Sound;
        }
        let (off, condition) = (off / value, input / value);
        Verdict::Lost(format!("relative error {off:.1e} of {value:.3e}, condition {condition:.1e}"))
    }

    /// `Σ |xᵢ ∂y/∂xᵢ|` over the inputs of a number, its derivatives by reverse accumulation. A vector is taken as the sum
    /// of its components.
    fn input_error(&self, id: Id) -> f64 {
        let nodes = &self.solution.trace.nodes;
        let zero = |at: usize| match self.numbers[at] {
            Many::Scalar(_) => vec![0.0],
            Many::Vector(_) => vec![0.0; 3],
        };
        let mut total = 0.0;
        for component in 0..zero(id as usize).len() {
            let mut derivatives: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
            let mut own = zero(id as usize);
            own[component] = 1.0;
            derivatives.insert(id as usize, own);
            while let Some((at, upstream)) = derivatives.pop_last() {
                let operands = match nodes[at].op {
                    Op::Step(step) => self.solution.steps[step].formula.into_iter().collect(),
                    _ => self.solution.trace.operands(at as Id),
                };
                if operands.is_empty() {
                    let x = values(&self.numbers[at]);
                    total += x.iter().zip(&upstream).map(|(x, upstream)| (x * upstream).abs()).sum::<f64>();
                }
                for (place, operand) in operands.iter().enumerate() {
                    let passed = self.passed(at, place, &operands, &upstream);
                    let sum = derivatives.entry(*operand as usize).or_insert_with(|| zero(*operand as usize));
                    sum.iter_mut().zip(passed).for_each(|(sum, upstream)| *sum += upstream);
                }
            }
        }
        total
    }

    /// The derivative of an operation by one of its operands, times the derivative by its result.
    fn passed(&self, at: usize, place: usize, operands: &[Id], upstream: &[f64]) -> Vec<f64> {
        let value = |n: usize| values(&self.numbers[operands[n] as usize]);
        let x = |n: usize| value(n)[0];
        let result = values(&self.numbers[at]);
        let times = |factor: f64| upstream.iter().map(|upstream| upstream * factor).collect::<Vec<_>>();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let cross = |a: &[f64], b: &[f64]| {
            vec![a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        match &self.solution.trace.nodes[at].op {
            Op::Literal | Op::Constant(_) | Op::Given { .. } => Vec::new(),
            Op::Step(_) | Op::Add(..) | Op::Sum(_) => times(1.0),
            Op::Sub(..) => times(if place == 0 { 1.0 } else { -1.0 }),
            Op::Neg(_) => times(-1.0),
            Op::Mul(..) => {
                let (own, other) = (value(place), value(1 - place));
                match (own.len(), other.len()) {
                    (_, 1) => times(other[0]),
                    _ => vec![dot(upstream, &other)],
                }
            }
            Op::Div(..) if place == 0 => times(1.0 / x(1)),
            Op::Div(..) => vec![-dot(upstream, &result) / x(1)],
            Op::Power(_, n) => times(f64::from(*n) * x(0).powi(i32::from(*n) - 1)),
            Op::Root(_, n) => times(result[0] / (f64::from(*n) * x(0))),
            Op::Raised(..) if place == 0 => times(result[0] * x(1) / x(0)),
            Op::Raised(..) => times(result[0] * x(0).ln()),
            Op::Min(..) | Op::Max(..) => times(if result[0] == x(place) { 1.0 } else { 0.0 }),
            Op::Call(function, _) => times(derivative(*function, x(0), result[0])),
            Op::Atan2(..) => {
                let square = x(0).powi(2) + x(1).powi(2);
                times(if place == 0 { x(1) / square } else { -x(0) / square })
            }
            Op::Dot(..) => value(1 - place).iter().map(|other| upstream[0] * other).collect(),
            Op::Cross(..) if place == 0 => cross(&value(1), upstream),
            Op::Cross(..) => cross(upstream, &value(0)),
            Op::Magnitude(_) => value(0).iter().map(|x| upstream[0] * x / result[0]).collect(),
            Op::Component(_, axis) => (0..3).map(|n| if n == *axis { upstream[0] } else { 0.0 }).collect(),
            Op::Compose(_) => vec![upstream[place]],
        }
    }
}

fn derivative(function: Function, x: f64, result: f64) -> f64 {
    match function {
        Function::Sin => x.cos(),
        Function::Cos => -x.sin(),
        Function::Tan => 1.0 + result * result,
        Function::Asin => 1.0 / ((1.0 - x) * (1.0 + x)).sqrt(),
        Function::Acos => -1.0 / ((1.0 - x) * (1.0 + x)).sqrt(),
        Function::Exp => result,
        Function::Ln => 1.0 / x,
        Function::Log10 => std::f64::consts::LOG10_E / x,
        Function::Sinh => x.cosh(),
        Function::Cosh => x.sinh(),
        Function::Tanh => 1.0 - result * result,
        Function::Abs => x.signum(),
    }
}

fn big(x: f64) -> BigFloat {
    BigFloat::from_f64(x, PRECISION)
}

fn taken(number: Number) -> Many {
    match number {
        Number::Scalar(x) => Many::Scalar(big(x)),
        Number::Vector(v) => Many::Vector(Box::new(v.map(big))),
    }
}

/// Double precision of a number, without its last place.
fn rounded(x: &BigFloat) -> f64 {
    if x.is_zero() {
        return 0.0;
    }
    let Some((words, _, sign, exponent, _)) = x.as_raw_parts() else { return f64::NAN };
    // The mantissa is 0.w₁w₂…, its last word the first after the point; its first bit is set.
    let top = words.iter().rev().take(2).rev().fold(0.0, |low, word| (low + *word as f64) / 2_f64.powi(64));
    let half = exponent / 2;
    let size = top * 2_f64.powi(half) * 2_f64.powi(exponent - half);
    if sign.is_negative() { -size } else { size }
}

fn values(number: &Many) -> Vec<f64> {
    match number {
        Many::Scalar(x) => vec![rounded(x)],
        Many::Vector(v) => v.iter().map(rounded).collect(),
    }
}

fn add(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.add(b, PRECISION, ROUNDING)
}

fn sub(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.sub(b, PRECISION, ROUNDING)
}

fn mul(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.mul(b, PRECISION, ROUNDING)
}

fn div(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.div(b, PRECISION, ROUNDING)
}

fn difference(a: &Many, b: &Many) -> Many {
    componentwise(a, b, sub)
}

fn componentwise(a: &Many, b: &Many, by: fn(&BigFloat, &BigFloat) -> BigFloat) -> Many {
    match (a, b) {
        (Many::Scalar(a), Many::Scalar(b)) => Many::Scalar(by(a, b)),
        (Many::Vector(a), Many::Vector(b)) => Many::Vector(Box::new([0, 1, 2].map(|n| by(&a[n], &b[n])))),
        _ => panic!("a number is added to a vector"),
    }
}

fn dot(a: &[BigFloat; 3], b: &[BigFloat; 3]) -> BigFloat {
    let parts = [0, 1, 2].map(|n| mul(&a[n], &b[n]));
    add(&add(&parts[0], &parts[1]), &parts[2])
}

/// Magnitude in double precision.
fn size(number: &Many, consts: &mut Consts) -> f64 {
    match number {
        Many::Scalar(x) => rounded(x).abs(),
        Many::Vector(v) => rounded(&root(&dot(v, v), 2, consts)),
    }
}

/// The `n`th root; of a number below zero by rounding alone, zero.
fn root(x: &BigFloat, n: u8, consts: &mut Consts) -> BigFloat {
    match n {
        2 if x.is_negative() => big(0.0),
        2 => x.sqrt(PRECISION, ROUNDING),
        3 => x.cbrt(PRECISION, ROUNDING),
        n if n % 2 == 1 && x.is_negative() => root(&x.neg(), n, consts).neg(),
        n => x.pow(&div(&big(1.0), &big(f64::from(n))), PRECISION, ROUNDING, consts),
    }
}

/// A cosine or sine; beyond one by rounding alone, one.
fn within_one(x: &BigFloat) -> BigFloat {
    x.clamp(&big(-1.0), &big(1.0))
}

fn call(function: Function, x: &BigFloat, cc: &mut Consts) -> BigFloat {
    let (p, rm) = (PRECISION, ROUNDING);
    match function {
        Function::Sin => x.sin(p, rm, cc),
        Function::Cos => x.cos(p, rm, cc),
        Function::Tan => x.tan(p, rm, cc),
        Function::Asin => within_one(x).asin(p, rm, cc),
        Function::Acos => within_one(x).acos(p, rm, cc),
        Function::Exp => x.exp(p, rm, cc),
        Function::Ln => x.ln(p, rm, cc),
        Function::Log10 => x.log10(p, rm, cc),
        Function::Sinh => x.sinh(p, rm, cc),
        Function::Cosh => x.cosh(p, rm, cc),
        Function::Tanh => x.tanh(p, rm, cc),
        Function::Abs => x.abs(),
    }
}

/// The angle of the direction `(x, y)`, in `(−π, π]`.
fn atan2(y: &BigFloat, x: &BigFloat, cc: &mut Consts) -> BigFloat {
    let pi = cc.pi(PRECISION, ROUNDING);
    let half = div(&pi, &big(2.0));
    if x.is_zero() {
        return if y.is_zero() {
            big(0.0)
        } else if y.is_negative() {
            half.neg()
        } else {
            half
        };
    }
    let principal = div(y, x).atan(PRECISION, ROUNDING, cc);
    match (x.is_negative(), y.is_negative() && !y.is_zero()) {
        (false, _) => principal,
        (true, false) => add(&principal, &pi),
        (true, true) => sub(&principal, &pi),
    }
}

fn operation(op: &Op, numbers: &[Many], cc: &mut Consts) -> Many {
    use Many::{Scalar, Vector};
    let of = |id: Id| &numbers[id as usize];
    let scalar = |id: Id| match of(id) {
        Scalar(x) => x,
        Vector(_) => panic!("{op:?} of a vector"),
    };
    let vector = |id: Id| match of(id) {
        Vector(v) => &**v,
        Scalar(_) => panic!("{op:?} of a number"),
    };
    let each = |v: &[BigFloat; 3], by: &dyn Fn(&BigFloat) -> BigFloat| {
        Vector(Box::new([0, 1, 2].map(|n| by(&v[n]))))
    };
    match op {
        Op::Literal | Op::Constant(_) | Op::Given { .. } | Op::Step(_) => panic!("{op:?} is no operation"),
        Op::Add(a, b) => componentwise(of(*a), of(*b), add),
        Op::Sub(a, b) => componentwise(of(*a), of(*b), sub),
        Op::Mul(a, b) => match (of(*a), of(*b)) {
            (Scalar(a), Scalar(b)) => Scalar(mul(a, b)),
            (Scalar(a), Vector(v)) | (Vector(v), Scalar(a)) => each(v, &|x| mul(a, x)),
            _ => panic!("a vector times a vector"),
        },
        Op::Div(a, b) => match of(*a) {
            Scalar(a) => Scalar(div(a, scalar(*b))),
            Vector(v) => each(v, &|x| div(x, scalar(*b))),
        },
        Op::Neg(a) => match of(*a) {
            Scalar(a) => Scalar(a.neg()),
            Vector(v) => each(v, &BigFloat::neg),
        },
        Op::Power(a, n) => {
            let power = scalar(*a).powi(usize::from(n.unsigned_abs()), PRECISION, ROUNDING);
            Scalar(if *n < 0 { div(&big(1.0), &power) } else { power })
        }
        Op::Root(a, n) => Scalar(root(scalar(*a), *n, cc)),
        Op::Raised(a, b) => Scalar(scalar(*a).pow(scalar(*b), PRECISION, ROUNDING, cc)),
        Op::Min(a, b) => Scalar(scalar(*a).min(scalar(*b))),
        Op::Max(a, b) => Scalar(scalar(*a).max(scalar(*b))),
        Op::Call(function, a) => Scalar(call(*function, scalar(*a), cc)),
        Op::Atan2(y, x) => Scalar(atan2(scalar(*y), scalar(*x), cc)),
        Op::Sum(all) => {
            let mut all = all.iter().map(|id| of(*id));
            let first = all.next().cloned().unwrap_or_else(|| Scalar(big(0.0)));
            all.fold(first, |sum, x| componentwise(&sum, x, add))
        }
        Op::Dot(a, b) => Scalar(dot(vector(*a), vector(*b))),
        Op::Cross(a, b) => {
            let (a, b) = (vector(*a), vector(*b));
            let part = |i: usize, j: usize| sub(&mul(&a[i], &b[j]), &mul(&a[j], &b[i]));
            Vector(Box::new([part(1, 2), part(2, 0), part(0, 1)]))
        }
        Op::Magnitude(a) => match of(*a) {
            Vector(v) => Scalar(root(&dot(v, v), 2, cc)),
            Scalar(x) => Scalar(x.abs()),
        },
        Op::Component(a, axis) => Scalar(vector(*a)[usize::from(*axis).min(2)].clone()),
        Op::Compose(all) => Vector(Box::new(all.map(|id| scalar(id).clone()))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_go_there_and_back() {
        for x in [1.0, -2.5, 1e-300, -7.1e250, std::f64::consts::PI, 0.0] {
            assert_eq!(rounded(&big(x)), x);
        }
    }

    #[test]
    fn directions_in_all_quadrants() {
        let mut cc = Consts::new().unwrap();
        for (y, x) in
            [(1.0, 2.0), (1.0, -2.0), (-1.0, -2.0), (-1.0, 2.0), (0.0, -1.0), (3.0, 0.0), (-3.0, 0.0)]
        {
            let angle = rounded(&atan2(&big(y), &big(x), &mut cc));
            assert!((angle - f64::atan2(y, x)).abs() < 1e-15, "{y} {x}: {angle}");
        }
    }
}
