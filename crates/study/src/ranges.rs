//! Values of an input with which an answer is a wanted one, or within a limit: a union of intervals of its range.
//!
//! The range is scanned first. Where the worked solution has the same formulas at all points of a part of it, enclosures of
//! these formulas prove the sign of answer less limit in that part ([`Basis::Formulas`]); that the formulas do not change
//! between the points is seen, not proven, since an analysis may choose among them by conditions that are no part of its
//! trace. Otherwise the signs are those of the scan ([`Basis::Scan`]).

mod formulas;

use dalembert_core::{
    Answer, Entry, Record, Refusal, SolveError, Stop, Text,
    study::find_target,
    vary::{self, Perturbed, VariedInput},
};
use dalembert_numerics::{
    enclosure::Jet,
    signs::{Sign, SignedPart, signs},
};

use self::formulas::{Formulas, Operation};

/// Points of a part of the range at which the formulas are compared.
const COMPARED: usize = 33;
/// Changes of the formulas that are followed in a range.
const MOST_CHANGES: usize = 8;
/// Operations of the longest formulas that are enclosed.
const LONGEST: usize = 20_000;
/// Share by which an answer may miss the enclosure of its formulas: the rounding of its computation.
const ROUNDING: f64 = 1e-9;

/// Requirement of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// The value itself.
    Equal,
    /// No more than it.
    AtMost,
    /// No less than it.
    AtLeast,
}

/// Question: which values of an input in a range meet a requirement of an answer. In SI.
#[derive(Clone, Copy, Debug)]
pub struct RangeQuestion<'q> {
    /// The path of the input.
    pub input: &'q str,
    /// Range of the input.
    pub range: [f64; 2],
    /// The answer.
    pub answer: &'q Answer,
    /// Relation of answer and value.
    pub relation: Relation,
    /// Value of the answer.
    pub wanted: f64,
}

/// Ground on which the parts of a range are known.
#[derive(Clone, Debug, PartialEq)]
pub enum Basis {
    /// Enclosures of formulas, which were the same at so many points of each part with an answer.
    Formulas {
        /// Points at which the formulas were compared.
        points: usize,
    },
    /// A scan of so many points, and why there are no formulas.
    Scan {
        /// Points that were examined.
        points: usize,
        /// Reason for which nothing is proven.
        why: Text,
    },
}

/// Limit of a permitted interval.
#[derive(Clone, Debug, PartialEq)]
pub enum LimitedBy {
    /// The answer has the wanted value there.
    Equality,
    /// The end of the range.
    Range,
    /// Beyond it there is no answer, and why.
    NoAnswer(Option<Text>),
    /// Beyond it nothing is decided.
    Undecided,
}

/// Permitted interval of an input, each end with what limits it.
#[derive(Clone, Debug, PartialEq)]
pub struct PermittedInterval {
    /// Ends, in SI.
    pub ends: [f64; 2],
    /// Limit of each end.
    pub limited_by: [LimitedBy; 2],
}

/// Parts of a range by the sign of answer less wanted value.
#[derive(Clone, Debug)]
pub struct FoundRanges {
    /// The input.
    pub input: VariedInput,
    /// Requirement of the answer.
    pub relation: Relation,
    /// The parts, ascending; [`Sign::Undefined`] where the problem has no answer.
    pub parts: Vec<SignedPart>,
    /// Reason for which there is no answer in each part without one.
    pub refused: Vec<Option<Text>>,
    /// Ground on which they are known.
    pub basis: Basis,
    /// The least and the largest answer of the scan, each at its place.
    pub covered: Option<[(f64, f64); 2]>,
    /// True if the answer is the same for all of the range.
    pub is_constant: bool,
}

/// Finds the parts of the range.
///
/// # Errors
/// Why the problem as given has no answer; an input that is no number or cannot be varied; an empty range; a stop.
pub fn find(
    (entry, record): (&Entry, &Record),
    question: RangeQuestion<'_>,
    stop: &Stop,
) -> Result<FoundRanges, SolveError> {
    let RangeQuestion { input: path, range, answer, wanted, relation } = question;
    let target = find_target(entry, record, (path, range), (answer, wanted), stop)?;
    let inputs = vary::inputs(record);
    let input = inputs.into_iter().find(|input| input.path == path);
    let input = input.ok_or_else(|| Refusal::because("this input cannot be varied"))?;
    let name = answer.name.to_string();
    let mut again = Perturbed::new(entry, record, vec![input.clone()], vec![name.clone()])?;
    let finite = || target.scan.iter().copied().filter(|(_, value)| value.is_finite());
    let least = finite().min_by(|a, b| a.1.total_cmp(&b.1));
    let covered = least.zip(finite().max_by(|a, b| a.1.total_cmp(&b.1))).map(|(a, b)| [a, b]);
    let is_constant = covered.is_some_and(|[a, b]| b.1 - a.1 <= 1e-12 * a.1.abs().max(b.1.abs()));
    let mut scan = Scan { again: &mut again, stop, points: &target.scan };
    let with_answer = scan.with_answer()?;
    let mut prover = Prover { problem: (entry, record), path, answer: &name, stop, compared: 0, changes: 0 };
    let proven = prover.prove(&with_answer, wanted)?;
    let (inner, basis) = match proven {
        Ok(parts) if agrees(&parts, &target.scan, wanted) => {
            (parts, Basis::Formulas { points: prover.compared })
        }
        other => {
            let why = other.err().unwrap_or_else(|| {
                Text::from("the answers of the scan are not those of the formulas at the compared points")
            });
            let parts =
                with_answer.iter().flat_map(|ends| by_scan(*ends, &target.scan, &target.values, wanted));
            (parts.collect(), Basis::Scan { points: target.scan.len(), why })
        }
    };
    let parts = filled(inner, [range[0].min(range[1]), range[0].max(range[1])]);
    let refused = parts.iter().map(|part| {
        let middle = f64::midpoint(part.from, part.to);
        let is_refused = part.sign == Sign::Undefined;
        is_refused.then(|| vary::why_not(entry, record, (&input, middle), &name, stop)).flatten()
    });
    let refused = refused.collect();
    Ok(FoundRanges { input, relation, parts, refused, basis, covered, is_constant })
}

impl FoundRanges {
    /// The solutions of an equality: intervals that each hold one.
    pub fn solutions(&self) -> Vec<[f64; 2]> {
        let is_one = |part: &&SignedPart| part.sign == Sign::Crossing;
        self.parts.iter().filter(is_one).map(|part| [part.from, part.to]).collect()
    }

    /// The parts that are not decided.
    pub fn undecided(&self) -> Vec<[f64; 2]> {
        let is_open = |part: &&SignedPart| part.sign == Sign::Undecided;
        self.parts.iter().filter(is_open).map(|part| [part.from, part.to]).collect()
    }

    /// Permitted intervals of an inequality, ascending.
    pub fn permitted(&self) -> Vec<PermittedInterval> {
        let is_permitted = |part: &SignedPart| match self.relation {
            Relation::Equal => part.sign == Sign::Crossing,
            Relation::AtMost => part.sign == Sign::Below,
            Relation::AtLeast => part.sign == Sign::Above,
        };
        let limit = |beyond: Option<usize>| match beyond.map(|at| (self.parts[at].sign, at)) {
            None => LimitedBy::Range,
            Some((Sign::Undefined, at)) => LimitedBy::NoAnswer(self.refused[at].clone()),
            Some((Sign::Undecided, _)) => LimitedBy::Undecided,
            Some(_) => LimitedBy::Equality,
        };
        let mut found = Vec::new();
        for (at, part) in self.parts.iter().enumerate().filter(|(_, part)| is_permitted(part)) {
            let behind = Some(at + 1).filter(|at| *at < self.parts.len());
            let limited_by = [limit(at.checked_sub(1)), limit(behind)];
            found.push(PermittedInterval { ends: [part.from, part.to], limited_by });
        }
        found
    }

    /// Returns true if every value of the range meets the requirement.
    pub fn is_no_constraint(&self) -> bool {
        match (self.relation, &self.permitted()[..]) {
            (Relation::AtMost | Relation::AtLeast, [all]) => {
                all.limited_by == [LimitedBy::Range, LimitedBy::Range]
            }
            _ => false,
        }
    }

    /// Returns true if no value of the range meets the requirement.
    pub fn is_impossible(&self) -> bool {
        self.permitted().is_empty() && self.undecided().is_empty()
    }
}

/// The answers at points of the range.
struct Scan<'s> {
    again: &'s mut Perturbed,
    stop: &'s Stop,
    points: &'s [(f64, f64)],
}

impl Scan<'_> {
    /// The parts of the range with an answer.
    fn with_answer(&mut self) -> Result<Vec<[f64; 2]>, Refusal> {
        let mut parts: Vec<[f64; 2]> = Vec::new();
        let mut before: Option<(f64, bool)> = None;
        for &(at, value) in self.points {
            let has = value.is_finite();
            match (before, has) {
                (Some((last, false)), true) => parts.push([self.edge(at, last)?, at]),
                (None, true) => parts.push([at, at]),
                (Some((last, true)), false) => {
                    let edge = self.edge(last, at)?;
                    if let Some(part) = parts.last_mut() {
                        part[1] = edge;
                    }
                }
                (Some((_, true)), true) | (_, false) => {}
            }
            if let (true, Some(part)) = (has, parts.last_mut()) {
                part[1] = part[1].max(at);
            }
            before = Some((at, has));
        }
        Ok(parts)
    }

    /// The last place with an answer between one that has it and one that has not.
    fn edge(&mut self, mut has: f64, mut has_not: f64) -> Result<f64, Refusal> {
        for _ in 0..200 {
            let middle = f64::midpoint(has, has_not);
            if middle == has || middle == has_not || (has - has_not).abs() <= 1e-13 * has.abs() {
                break;
            }
            let value = self.again.with(&[(0, middle)], self.stop)?[0];
            *(if value.is_finite() { &mut has } else { &mut has_not }) = middle;
        }
        Ok(has)
    }
}

/// Comparison of formulas over the range, and the proof of signs from them.
struct Prover<'p> {
    problem: (&'p Entry, &'p Record),
    path: &'p str,
    answer: &'p str,
    stop: &'p Stop,
    /// Points at which formulas were compared.
    compared: usize,
    /// Changes of the formulas that were followed.
    changes: usize,
}

/// The formulas at a point, and their operations.
type At = (f64, Formulas, Vec<Operation>);

/// Result of a try, or the reason for which there is none.
type Tried<T> = Result<T, Text>;

impl Prover<'_> {
    /// The formulas at a value of the input.
    fn at(&mut self, x: f64) -> Result<Tried<At>, SolveError> {
        self.stop.check()?;
        let (entry, record) = self.problem;
        let Some(record) = vary::changed(record, self.path, x) else {
            return Ok(Err("this input cannot be varied".into()));
        };
        let solution = match entry.solve(&record, self.stop) {
            Ok(solution) => solution,
            Err(SolveError::Refused(Refusal::Stopped)) => return Err(Refusal::Stopped.into()),
            Err(_) => {
                return Ok(Err("the worked solution has no answer where the plain reading has one".into()));
            }
        };
        self.compared += 1;
        let value = solution.answer(self.answer).and_then(Answer::si);
        let formulas = Formulas::of(solution, self.answer, self.path);
        let (Some(mut formulas), Some(value)) = (formulas, value) else {
            return Ok(Err("the answer is not computed by formulas alone".into()));
        };
        if formulas.len() > LONGEST {
            return Ok(Err("the formulas of the answer are too long to be enclosed".into()));
        }
        let enclosed = formulas.enclosed([x, x]).value;
        let slack = ROUNDING * value.abs();
        if !(enclosed.low - slack <= value && value <= enclosed.high + slack) {
            return Ok(Err("the enclosure of the formulas is not that of the answer".into()));
        }
        let operations = formulas.operations();
        Ok(Ok((x, formulas, operations)))
    }

    /// The signs in the parts with an answer.
    fn prove(&mut self, parts: &[[f64; 2]], wanted: f64) -> Result<Tried<Vec<SignedPart>>, SolveError> {
        let mut proven = Vec::new();
        for &[from, to] in parts {
            let places = (0..COMPARED).map(|n| place([from, to], n as f64 / (COMPARED - 1) as f64));
            let mut points = Vec::new();
            for x in places {
                match self.at(x)? {
                    Ok(point) => points.push(point),
                    Err(why) => return Ok(Err(why)),
                }
            }
            let mut begin = from;
            for n in 1..=points.len() {
                let is_same = points.get(n).is_some_and(|next| next.2 == points[n - 1].2);
                if is_same {
                    continue;
                }
                let mut end = [to, to];
                if n < points.len() {
                    end = match self.change(&points[n - 1], &points[n])? {
                        Ok(end) => end,
                        Err(why) => return Ok(Err(why)),
                    };
                }
                let formulas = &mut points[n - 1].1;
                let mut function = |x: [f64; 2]| formulas.enclosed(x) - Jet::constant(wanted);
                proven.extend(signs(&mut function, [begin, end[0]]));
                proven.push(SignedPart { from: end[0], to: end[1], sign: Sign::Undecided });
                begin = end[1];
            }
        }
        proven.retain(|part| part.from < part.to);
        Ok(Ok(proven))
    }

    /// The neighbouring places between which one group of formulas follows another.
    fn change(&mut self, before: &At, behind: &At) -> Result<Tried<[f64; 2]>, SolveError> {
        self.changes += 1;
        let is_number = |a: &Operation, b: &Operation| a.has_same_operation(b);
        let alike =
            before.2.len() == behind.2.len() && before.2.iter().zip(&behind.2).all(|(a, b)| is_number(a, b));
        if alike {
            return Ok(Err("a number in the formulas changes with the input: a numerical method found it, or code outside of the formulas".into()));
        }
        if self.changes > MOST_CHANGES {
            return Ok(Err("the formulas of the answer change too often over the range".into()));
        }
        let (mut low, mut high) = (before.0, behind.0);
        while high - low > 1e-12 * low.abs().max(high.abs()) {
            let middle = f64::midpoint(low, high);
            if middle <= low || middle >= high {
                break;
            }
            match self.at(middle)? {
                Ok(point) if point.2 == before.2 => low = middle,
                Ok(point) if point.2 == behind.2 => high = middle,
                Ok(_) => return Ok(Err("the formulas of the answer change too often over the range".into())),
                Err(why) => return Ok(Err(why)),
            }
        }
        Ok(Ok([low, high]))
    }
}

/// Place at a share of a range.
fn place([from, to]: [f64; 2], share: f64) -> f64 {
    if share >= 1.0 {
        to
    } else if from > 0.0 && to / from > 30.0 {
        (from * (to / from).powf(share)).clamp(from, to)
    } else {
        (from + (to - from) * share).clamp(from, to)
    }
}

/// Returns true if the proven signs are those of the scan.
fn agrees(parts: &[SignedPart], scan: &[(f64, f64)], wanted: f64) -> bool {
    scan.iter().filter(|(_, value)| value.is_finite()).all(|(x, value)| {
        let mut around = parts.iter().filter(|part| part.from <= *x && *x <= part.to);
        let off = value - wanted;
        let is_near = off.abs() <= ROUNDING * value.abs().max(wanted.abs());
        is_near
            || around.any(|part| match part.sign {
                Sign::Below => off < 0.0,
                Sign::Above => off > 0.0,
                Sign::Crossing | Sign::Undecided => true,
                Sign::Undefined => false,
            })
    })
}

/// The signs of the scan in a part with an answer, between the zeros that were found.
fn by_scan([from, to]: [f64; 2], scan: &[(f64, f64)], zeros: &[f64], wanted: f64) -> Vec<SignedPart> {
    let mut ends = vec![from];
    ends.extend(zeros.iter().copied().filter(|zero| (from..=to).contains(zero)));
    ends.push(to);
    let mut parts = Vec::new();
    for (n, pair) in ends.windows(2).enumerate() {
        let [first, end] = [pair[0], pair[1]];
        let mut begin = first;
        if n > 0 {
            parts.push(SignedPart { from: begin, to: begin, sign: Sign::Crossing });
        }
        let mut last: Option<(f64, Sign)> = None;
        for (x, value) in scan.iter().copied().filter(|(x, _)| first <= *x && *x <= end) {
            let off = value - wanted;
            // Next to a zero there is its rounding alone.
            if !value.is_finite() || off.abs() <= ROUNDING * value.abs().max(wanted.abs()) {
                continue;
            }
            let sign = if off < 0.0 { Sign::Below } else { Sign::Above };
            // The sign changes without a zero: the answer jumps.
            if let Some((before, known)) = last.filter(|(_, known)| *known != sign) {
                parts.push(SignedPart { from: begin, to: before, sign: known });
                parts.push(SignedPart { from: before, to: x, sign: Sign::Undecided });
                begin = x;
            }
            last = Some((x, sign));
        }
        if begin < end {
            parts.push(SignedPart {
                from: begin,
                to: end,
                sign: last.map_or(Sign::Undecided, |(_, sign)| sign),
            });
        }
    }
    parts
}

/// The parts of the whole range: between those with an answer there is none.
fn filled(inner: Vec<SignedPart>, [from, to]: [f64; 2]) -> Vec<SignedPart> {
    let mut all: Vec<SignedPart> = Vec::new();
    let mut at = from;
    for part in inner {
        if part.from > at {
            all.push(SignedPart { from: at, to: part.from, sign: Sign::Undefined });
        }
        at = part.to;
        match all.last_mut() {
            Some(last) if last.sign == part.sign && last.to == part.from && part.sign != Sign::Crossing => {
                last.to = part.to;
            }
            _ => all.push(part),
        }
    }
    if at < to {
        all.push(SignedPart { from: at, to, sign: Sign::Undefined });
    }
    all
}
