//! Worksheet of a solve, and the plain reading that keeps only numbers.

use std::cell::RefCell;

use dalembert_numerics::intervals::IntervalSet;
use dalembert_numerics::{
    Real, Vector,
    simd::{SimdVector, SimdVector3},
};
use dalembert_units::Unit;
use nalgebra::Vector3;

use crate::{Cite, Exhibit, Field, Name, Refusal, Stop, Symbol, Text, Value};

/// Worksheet of a solve. Written once over `W: Worksheet`, a solve has two readings: on a [`Sheet`](crate::Sheet) it
/// leaves the worked solution, on [`Plain`] only its answers, at the speed of its formulas.
pub trait Worksheet: Copy {
    /// The numbers of this worksheet.
    type Num: Real;
    /// The vectors of this worksheet.
    type Vec: Vector<Scalar = Self::Num>;

    /// An input: a value in SI, by its symbol, in the unit it was typed in.
    #[doc(hidden)]
    fn given(self, input: InputNumber<'_>, si: f64) -> Self::Num;
    /// An input vector.
    #[doc(hidden)]
    fn given_vector(self, input: InputNumber<'_>, si: Vector3<f64>) -> Self::Vec;

    /// A number with a unit in a formula that a user wrote.
    #[doc(hidden)]
    fn constant(self, si: f64, unit: &Unit) -> Self::Num;

    /// Writes `symbol = formula = substitution = result in unit` and goes on with the symbol.
    fn step(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        value: Self::Num,
        why: impl Into<Reason>,
    ) -> Self::Num;
    /// Writes a step whose result is a vector.
    fn step_vector(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        value: Self::Vec,
        why: impl Into<Reason>,
    ) -> Self::Vec;
    /// Brings in a number (SI) that a numerical method found, saying how; a [`check`](Worksheet::check)
    /// must then verify its equation.
    fn numerical(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        si: f64,
        how: impl Into<Reason>,
    ) -> Self::Num;
    /// Brings in a number (SI) that a numerical method found with an error of no more than `error` (SI): its condition
    /// number times the rounding of what it was found from. Checks that rest on it allow for as much.
    fn numerical_within(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        si: f64,
        error: f64,
        how: impl Into<Reason>,
    ) -> Self::Num;
    /// Brings in a vector (SI) that a numerical method found, as [`numerical`](Worksheet::numerical) does a number.
    fn numerical_vector(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        si: Vector3<f64>,
        how: impl Into<Reason>,
    ) -> Self::Vec;
    /// Records a common error: what people compute in place of the next step of this symbol, and its name in words. It is
    /// searched for when an answer is wrong.
    fn common_error(
        self,
        symbol: impl Into<Symbol>,
        what: impl Into<Text>,
        wrong: impl FnOnce() -> Self::Num,
    );
    /// Holds two ways to the same number together, to within 10⁻⁹ of the larger; where digits are lost by cancellation on
    /// the way, to within what rounding leaves of them.
    fn check(self, what: impl Into<Text>, left: Self::Num, right: Self::Num);
    /// Holds a sum to zero, to within 10⁻⁹ of `scale`, the size of its largest term, or what rounding leaves of it.
    fn check_zero(self, what: impl Into<Text>, residual: Self::Num, scale: f64);
    /// Holds two ways to the same number together beside `scale`, the size of what was added up to make it: a sum that
    /// may cancel.
    fn check_sum(self, what: impl Into<Text>, left: Self::Num, right: Self::Num, scale: f64);
    /// Holds a residual that a numerical method left to zero beside `scale`. `error` is what the last places of its
    /// numbers may change in it, beside what the trace knows of: its derivative times their rounding, or what differences
    /// of it show.
    fn check_residual(self, what: impl Into<Text>, residual: Self::Num, scale: f64, error: f64);
    /// Holds several residuals of one kind to zero at once: the worst of them speaks for all.
    fn check_zeros(self, what: impl Into<Text>, residuals: impl IntoIterator<Item = f64>, scale: f64) {
        let worse = |worst: f64, residual: f64| {
            // What is not a number is never forgotten.
            if worst.is_nan() || residual.abs() <= worst.abs() { worst } else { residual }
        };
        self.check_zero(what, Self::Num::from(residuals.into_iter().fold(0.0, worse)), scale);
    }
    /// Holds two ways to the same vector together, to within 10⁻⁹ of the longer.
    fn check_vector(self, what: impl Into<Text>, left: Self::Vec, right: Self::Vec);
    /// Runs `checks`, which only check and warn: the plain reading leaves them out.
    fn verify(self, checks: impl FnOnce()) {
        checks();
    }
    /// Names an answer. `value` must be the result of a step or found.
    fn answer(self, name: impl Into<Name>, label: &'static str, value: Self::Num);
    /// Names an answer that is a vector.
    fn answer_vector(self, name: impl Into<Name>, label: &'static str, value: Self::Vec);
    /// Names an answer that is numbers in SI in an order of their own, shown in `unit`: a mode shape.
    fn answer_list(self, name: impl Into<Name>, label: &'static str, unit: &'static str, numbers: &[f64]);
    /// Names an answer that is a set of numbers in SI, shown in `unit`; `limits` says what limits each end.
    fn answer_set(
        self,
        name: impl Into<Name>,
        label: &'static str,
        unit: &'static str,
        set: &IntervalSet,
        limits: Vec<Text>,
    );
    /// Says which row of the inputs an answer that was given is about, by the name the user gave it: people read
    /// `Angle of the body, coupler` for `angle[2]`.
    fn row_label(self, name: impl Into<Name>, label: &str);
    /// Shows something beside the numbers. Only built when someone looks.
    fn show(self, exhibit: impl FnOnce() -> Exhibit);
    /// Warns of a valid but doubtful result.
    fn warn(self, warning: impl FnOnce() -> Text);
    /// Ends a long computation that nobody waits for any more, or whose wanted answers are all there: stands before
    /// whatever takes long.
    fn keep_going(self) -> Result<(), Refusal>;
}

/// Reason of a step, and its source.
#[derive(Clone, Debug, PartialEq)]
pub struct Reason {
    /// The reason, in words.
    pub reason: Text,
    /// The source.
    pub cite: Option<Cite>,
}

/// Input on a worksheet: symbol, path, and the unit it was typed in.
#[derive(Clone, Copy)]
pub struct InputNumber<'t> {
    /// The field.
    pub field: &'static Field,
    /// The place of the field in the group that `value` and `field_path` are of; `None` where they are of the number itself, a
    /// row of a list.
    pub at: Option<usize>,
    /// Value as typed, for its unit.
    pub value: Option<&'t Value>,
    /// The way there.
    pub field_path: &'t FieldPath<'t>,
}

/// The way from the top of a problem to one of its fields, on the stack.
#[derive(Clone, Copy)]
pub struct FieldPath<'t> {
    /// The way to the enclosing field; `None` at the top.
    pub parent: Option<&'t FieldPath<'t>>,
    /// The last part.
    pub part: PathSegment,
}

/// A part of a [`FieldPath`].
#[derive(Clone, Copy)]
pub enum PathSegment {
    /// The problem itself.
    Top,
    /// A field or an alternative, by name, and the index of symbols inside it; may be empty.
    Name(&'static str, &'static str),
    /// A row, counted from 1.
    Row(usize),
}

/// Reads a solve as plain numbers: those of one sample (`f64`), or of as many as a [`SimdVector`] has lanes. Nothing is
/// recorded but the answers.
pub struct Plain<'a, N = f64> {
    answers: RefCell<Vec<(Name, N)>>,
    /// The answers that are wanted, each with its expected place; none where all are.
    wanted: &'a [(usize, Name)],
    /// The inputs that differ from sample to sample, by the places of their [marks](mark).
    varied: &'a [N],
    stop: &'a Stop,
}

/// The numbers of a plain reading.
pub trait PlainNumber: Real {
    /// Their vectors in space.
    type Vector: Vector<Scalar = Self>;
    /// The number that an input is lifted to: its value, or that at the place of a mark among `varied`.
    fn lift(si: f64, varied: &[Self]) -> Self;
}

impl PlainNumber for f64 {
    type Vector = Vector3<f64>;
    #[inline]
    fn lift(si: f64, _: &[f64]) -> f64 {
        si
    }
}

impl PlainNumber for SimdVector {
    type Vector = SimdVector3;
    #[inline]
    fn lift(si: f64, varied: &[Self]) -> Self {
        if si.is_nan()
            && let Some(number) = varied.get((si.to_bits() & !f64::NAN.to_bits()) as usize)
        {
            return *number;
        }
        si.into()
    }
}

/// The value of an input in the fields of a problem that several samples are read of at once: a NaN whose bits hold a
/// place among the varied inputs. So what is computed from the field itself, and not from its lifted number, is no number
/// of a sample either.
pub(crate) fn mark(place: usize) -> f64 {
    f64::from_bits(f64::NAN.to_bits() | place as u64)
}

impl<'a> Plain<'a> {
    /// A worksheet without answers.
    #[inline]
    pub fn new(stop: &'a Stop) -> Self {
        Self::until(stop, &[])
    }

    /// A worksheet that goes on only until it has these answers, each with its expected place.
    pub(crate) fn until(stop: &'a Stop, wanted: &'a [(usize, Name)]) -> Self {
        Self { answers: RefCell::default(), wanted, varied: &[], stop }
    }
}

impl<'a> Plain<'a, SimdVector> {
    /// The same for several samples, which differ in these inputs. `answers` is memory that is used again.
    pub(crate) fn samples(
        stop: &'a Stop,
        wanted: &'a [(usize, Name)],
        varied: &'a [SimdVector],
        mut answers: Vec<(Name, SimdVector)>,
    ) -> Self {
        answers.clear();
        Self { answers: answers.into(), wanted, varied, stop }
    }

    /// All answers, in the order they were named.
    pub(crate) fn into_answers(self) -> Vec<(Name, SimdVector)> {
        self.answers.into_inner()
    }
}

impl<N: Copy> Plain<'_, N> {
    /// Returns true if every wanted answer is there.
    pub(crate) fn is_complete(&self) -> bool {
        let count = self.answers.borrow().len();
        let is_there = |(at, name): &(usize, Name)| *at < count && self.answer_at(*at, *name).is_some();
        !self.wanted.is_empty() && self.wanted.iter().all(is_there)
    }

    /// Forgets the answers, for the next reading.
    #[inline]
    pub fn clear(&self) {
        self.answers.borrow_mut().clear();
    }

    /// The answer of that name, expected (but not required) as the `at`th.
    #[inline]
    pub fn answer_at(&self, at: usize, name: Name) -> Option<N> {
        let answers = self.answers.borrow();
        if let Some((found, value)) = answers.get(at)
            && std::ptr::eq(found.base, name.base)
            && found.rows == name.rows
        {
            return Some(*value);
        }
        answers.iter().find(|(found, _)| *found == name).map(|(_, value)| *value)
    }

    /// All answers, in the order they were named.
    pub fn answers(&self) -> Vec<(Name, N)> {
        self.answers.borrow().clone()
    }
}

impl<N: PlainNumber> Worksheet for &Plain<'_, N> {
    type Num = N;
    type Vec = N::Vector;

    #[inline]
    fn given(self, _: InputNumber<'_>, si: f64) -> N {
        N::lift(si, self.varied)
    }
    #[inline]
    fn given_vector(self, _: InputNumber<'_>, si: Vector3<f64>) -> N::Vector {
        let [x, y, z] = [si.x, si.y, si.z].map(|si| N::lift(si, self.varied));
        N::Vector::from_components(x, y, z)
    }
    #[inline]
    fn constant(self, si: f64, _: &Unit) -> N {
        si.into()
    }
    #[inline]
    fn step(self, _: impl Into<Symbol>, _: &'static str, value: N, _: impl Into<Reason>) -> N {
        value
    }
    #[inline]
    fn step_vector(
        self,
        _: impl Into<Symbol>,
        _: &'static str,
        value: N::Vector,
        _: impl Into<Reason>,
    ) -> N::Vector {
        value
    }
    #[inline]
    fn numerical(self, _: impl Into<Symbol>, _: &'static str, si: f64, _: impl Into<Reason>) -> N {
        si.into()
    }
    #[inline]
    fn numerical_within(
        self,
        _: impl Into<Symbol>,
        _: &'static str,
        si: f64,
        _: f64,
        _: impl Into<Reason>,
    ) -> N {
        si.into()
    }
    #[inline]
    fn numerical_vector(
        self,
        _: impl Into<Symbol>,
        _: &'static str,
        si: Vector3<f64>,
        _: impl Into<Reason>,
    ) -> N::Vector {
        N::Vector::from_components(si.x.into(), si.y.into(), si.z.into())
    }
    #[inline]
    fn common_error(self, _: impl Into<Symbol>, _: impl Into<Text>, _: impl FnOnce() -> N) {}
    #[inline]
    fn check(self, _: impl Into<Text>, _: N, _: N) {}
    #[inline]
    fn check_zero(self, _: impl Into<Text>, _: N, _: f64) {}
    #[inline]
    fn check_sum(self, _: impl Into<Text>, _: N, _: N, _: f64) {}
    #[inline]
    fn check_residual(self, _: impl Into<Text>, _: N, _: f64, _: f64) {}
    #[inline]
    fn check_vector(self, _: impl Into<Text>, _: N::Vector, _: N::Vector) {}
    #[inline]
    fn verify(self, _: impl FnOnce()) {}
    #[inline]
    fn answer(self, name: impl Into<Name>, _: &'static str, value: N) {
        self.answers.borrow_mut().push((name.into(), value));
    }
    #[inline]
    fn answer_vector(self, _: impl Into<Name>, _: &'static str, _: N::Vector) {}
    #[inline]
    fn answer_list(self, _: impl Into<Name>, _: &'static str, _: &'static str, _: &[f64]) {}
    #[inline]
    fn answer_set(self, _: impl Into<Name>, _: &'static str, _: &'static str, _: &IntervalSet, _: Vec<Text>) {
    }
    #[inline]
    fn row_label(self, _: impl Into<Name>, _: &str) {}
    #[inline]
    fn show(self, _: impl FnOnce() -> Exhibit) {}
    #[inline]
    fn warn(self, _: impl FnOnce() -> Text) {}
    #[inline]
    fn keep_going(self) -> Result<(), Refusal> {
        self.stop.check()?;
        if self.is_complete() { Err(Refusal::Stopped) } else { Ok(()) }
    }
}

impl<'t> FieldPath<'t> {
    /// The way to the problem itself.
    pub const TOP: FieldPath<'static> = FieldPath { parent: None, part: PathSegment::Top };

    /// The way to a field of what is here.
    #[must_use]
    pub fn field(&'t self, name: &'static str) -> FieldPath<'t> {
        FieldPath { parent: Some(self), part: PathSegment::Name(name, "") }
    }

    /// The way to a field whose symbols carry an index: `r_A` of the correction in plane A.
    #[must_use]
    pub fn field_of(&'t self, name: &'static str, of: &'static str) -> FieldPath<'t> {
        FieldPath { parent: Some(self), part: PathSegment::Name(name, of) }
    }

    /// The way to a row, counted from 0, of what is here.
    #[must_use]
    pub fn row(&'t self, row: usize) -> FieldPath<'t> {
        FieldPath { parent: Some(self), part: PathSegment::Row(row + 1) }
    }

    /// `masses[1].radius`
    pub fn path(&self) -> String {
        let mut path = self.parent.map_or_else(String::new, FieldPath::path);
        match self.part {
            PathSegment::Top => {}
            PathSegment::Name(name, _) if path.is_empty() => path.push_str(name),
            PathSegment::Name(name, _) => {
                path.push('.');
                path.push_str(name);
            }
            PathSegment::Row(row) => path += &format!("[{row}]"),
        }
        path
    }

    /// `base` with the parts and rows on the way as its indices.
    pub fn symbol(&self, base: &'static str) -> Symbol {
        let symbol = self.parent.map_or_else(|| Symbol::from(base), |parent| parent.symbol(base));
        match self.part {
            PathSegment::Row(row) => symbol.row(row),
            PathSegment::Name(_, of) if !of.is_empty() => Symbol { of, ..symbol },
            _ => symbol,
        }
    }
}

impl From<&'static str> for Reason {
    fn from(reason: &'static str) -> Self {
        Self { reason: reason.into(), cite: None }
    }
}

impl From<Text> for Reason {
    fn from(reason: Text) -> Self {
        Self { reason, cite: None }
    }
}

/// A reason with arguments, which the plain reading does not write.
impl<F: FnOnce() -> Text> From<F> for Reason {
    fn from(reason: F) -> Self {
        reason().into()
    }
}

impl<T: Into<Text>> From<(T, Cite)> for Reason {
    fn from((reason, cite): (T, Cite)) -> Self {
        Self { reason: reason.into(), cite: Some(cite) }
    }
}
