//! Mistakes in the data: inputs that are taken otherwise than they are given.

use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2, TAU};

use dalembert_units::{self as units, Dim, Kind, Unit};
use itertools::Itertools as _;

use super::{
    Change, Mistake, Place,
    digits::{is_shifted, looks_alike, other_digit},
    steps::{LONGEST_TRACE, node_of, scalar},
    tries::{Candidate, Tries},
    weight::{is_customary, weights},
    wrong::Wrong,
};
use crate::{
    Entry, Record, Refusal, Solution, SolveError, Stop,
    reevaluate::{Edit, Reevaluation},
    trace::{Id, Number, Op},
    vary::{self, Perturbed, VariedInput},
};

/// Problems of more inputs have so many pairs that may be interchanged.
const MOST_PAIRS: usize = 60;
/// Accelerations of gravity that people take, in m/s².
const GRAVITY: [f64; 4] = [9.81, 10.0, 9.806_65, 9.8];

/// One way to take an input otherwise.
struct Way {
    prior: f64,
    change: Change,
    /// The number that was taken, in SI.
    si: f64,
}

/// Adds the results of every input taken otherwise, the likeliest first; `so_far` receives them before those of single
/// digits.
pub(super) fn inputs(
    all: &mut Tries<'_, '_>,
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    stop: &Stop,
    so_far: &mut dyn FnMut(&[Candidate]),
) -> Result<(), Refusal> {
    let names = all.wrong.iter().map(|one| one.name.to_owned()).collect();
    let again = match Perturbed::new(entry, record, vary::inputs(record), names) {
        Ok(again) => again,
        Err(SolveError::Refused(Refusal::Stopped)) => return Err(Refusal::Stopped),
        Err(_) => return Ok(()),
    };
    let mut inputs = Inputs::of(again, all.wrong, solution);
    let given = &inputs.again.inputs;
    let of_each = |ways: &dyn Fn(&VariedInput) -> Vec<Way>| {
        let mut all: Vec<(usize, Way)> = Vec::new();
        for (at, input) in given.iter().enumerate() {
            all.extend(ways(input).into_iter().map(|way| (at, way)));
        }
        all.sort_by(|(_, a), (_, b)| b.prior.total_cmp(&a.prior));
        all
    };
    let (whole, digits) = (of_each(&|input| ways(input, given)), of_each(&digits));
    inputs.each(all, whole, stop)?;
    inputs.interchanged(all, stop)?;
    so_far(all.ranked());
    inputs.each(all, digits, stop)
}

/// The problem with inputs taken otherwise: by its trace where that is all that an input goes into, solved again where not.
struct Inputs<'s> {
    again: Perturbed,
    /// Place of each wrong answer in the list of answers, `None` where it is absent.
    places: Vec<Option<usize>>,
    trace: Option<Traced<'s>>,
}

/// The trace that the wrong answers were made from.
struct Traced<'s> {
    reevaluation: Reevaluation<'s>,
    wanted: Vec<Option<Id>>,
    solution: &'s Solution,
    /// For each input whether the trace gives what solving again gives; not known yet for those not asked for.
    is_whole: Vec<Option<bool>>,
}

impl<'s> Inputs<'s> {
    fn of(again: Perturbed, wrong: &[Wrong<'_>], solution: &'s Solution) -> Self {
        let place = |one: &Wrong<'_>| again.answers.iter().position(|name| name == one.name);
        let places = wrong.iter().map(place).collect();
        let trace = (solution.trace.nodes.len() <= LONGEST_TRACE).then(|| {
            let wanted: Vec<Option<Id>> = wrong.iter().map(node_of).collect();
            let nodes: Vec<Id> = wanted.iter().flatten().copied().collect();
            let is_whole = vec![None; again.inputs.len()];
            Traced { reevaluation: Reevaluation::new(solution, &nodes), wanted, solution, is_whole }
        });
        Self { again, places, trace }
    }

    fn solved(&mut self, changes: &[(usize, f64)], stop: &Stop) -> Result<Vec<f64>, Refusal> {
        let found = self.again.with(changes, stop)?;
        Ok(self.places.iter().map(|place| place.map_or(f64::NAN, |place| found[place])).collect())
    }

    /// The edits of the trace that give an input another number; none where it does not stand in the trace alone.
    fn edits(&mut self, at: usize, si: f64, stop: &Stop) -> Result<Vec<Edit>, Refusal> {
        let known = self.trace.as_ref().and_then(|trace| trace.is_whole[at]);
        let is_whole = match (known, &self.trace) {
            (Some(known), _) => known,
            (None, None) => false,
            (None, Some(_)) => {
                let near = 1.01 * self.again.inputs[at].si;
                let solved = self.solved(&[(at, near)], stop)?;
                let input = self.again.inputs[at].clone();
                let trace = self.trace.as_mut().expect("there is a trace");
                let edits = trace.edits(&input, near);
                let traced = trace.values(&edits);
                let is_same =
                    |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-9 * b.abs() || a.is_nan() && b.is_nan();
                let is_whole = near != 0.0 && solved.iter().zip(&traced).all(is_same);
                trace.is_whole[at] = Some(is_whole);
                is_whole
            }
        };
        let input = self.again.inputs[at].clone();
        Ok(match &self.trace {
            Some(trace) if is_whole => trace.edits(&input, si),
            _ => Vec::new(),
        })
    }

    /// The wrong answers with inputs changed, and the edits of the trace that do the same.
    fn changed(&mut self, changes: &[(usize, f64)], stop: &Stop) -> Result<(Vec<f64>, Vec<Edit>), Refusal> {
        let mut all = Vec::new();
        for (at, si) in changes {
            let edits = self.edits(*at, *si, stop)?;
            if edits.is_empty() {
                return Ok((self.solved(changes, stop)?, Vec::new()));
            }
            all.extend(edits);
        }
        stop.check()?;
        let trace = self.trace.as_mut().expect("the edits are those of a trace");
        let values = trace.values(&all);
        // Where a formula of the trace has no value, the problem may have another one: a root turned negative.
        if values.iter().all(|value| !value.is_finite()) {
            return Ok((self.solved(changes, stop)?, Vec::new()));
        }
        Ok((values, all))
    }

    fn each(&mut self, all: &mut Tries<'_, '_>, ways: Vec<(usize, Way)>, stop: &Stop) -> Result<(), Refusal> {
        for (at, way) in ways {
            let (values, edits) = self.changed(&[(at, way.si)], stop)?;
            let input = &self.again.inputs[at];
            let place = Place::Input(input.path.clone(), input.label.clone());
            all.data(way.prior, Mistake::new(place, way.change).taken(way.si), values, edits);
        }
        Ok(())
    }

    fn interchanged(&mut self, all: &mut Tries<'_, '_>, stop: &Stop) -> Result<(), Refusal> {
        let inputs = &self.again.inputs;
        let pairs: Vec<(usize, usize)> = (0..inputs.len())
            .flat_map(|first| (first + 1..inputs.len()).map(move |second| (first, second)))
            .filter(|(first, second)| {
                let (first, second) = (&inputs[*first], &inputs[*second]);
                first.unit.dim.agrees(second.unit.dim) && first.si != second.si
            })
            .take(MOST_PAIRS)
            .collect();
        for (first, second) in pairs {
            let changes = [(first, self.again.inputs[second].si), (second, self.again.inputs[first].si)];
            let (values, edits) = self.changed(&changes, stop)?;
            let [first, second] = [first, second].map(|at| &self.again.inputs[at]);
            let place = Place::Input(first.path.clone(), first.label.clone());
            let change = Change::Interchanged(second.path.clone(), second.label.clone());
            all.data(4.0, Mistake::new(place, change), values, edits);
        }
        Ok(())
    }
}

impl Traced<'_> {
    /// Another number in every node of an input.
    fn edits(&self, input: &VariedInput, si: f64) -> Vec<Edit> {
        let axis = ["x", "y", "z"].iter().position(|axis| input.path.ends_with(&format!(".{axis}")));
        let nodes = (0..).zip(&self.solution.trace.nodes);
        let given = nodes.filter_map(|(id, node)| match (&node.op, axis, node.number) {
            (Op::Given { path, .. }, _, Number::Scalar(_)) if *path == input.path => {
                Some(Edit::number(id, Number::Scalar(si)))
            }
            (Op::Given { path, .. }, Some(axis), Number::Vector(mut v))
                if input.path.strip_suffix(['x', 'y', 'z']).and_then(|path| path.strip_suffix('.'))
                    == Some(path) =>
            {
                v[axis] = si;
                Some(Edit::number(id, Number::Vector(v)))
            }
            _ => None,
        });
        given.collect()
    }

    fn values(&mut self, edits: &[Edit]) -> Vec<f64> {
        let edits: Vec<&Edit> = edits.iter().collect();
        self.reevaluation.with(&edits, &self.wanted).into_iter().map(scalar).collect()
    }
}

/// The ways to take an input otherwise, those of single digits apart.
fn ways(input: &VariedInput, others: &[VariedInput]) -> Vec<Way> {
    let (kind, si) = (input.measure.kind(), input.si);
    let words = input.label.english().to_lowercase();
    let has = |all: &[&str]| all.iter().any(|word| words.contains(word));
    let mut found = Vec::new();
    let mut may = |prior: f64, change: Change, si: f64| found.push(Way { prior, change, si });
    for customary in [false, true] {
        for taken in units_of(kind, &input.unit, customary) {
            let turning = [Kind::AngularVelocity, Kind::Angle].contains(&kind)
                && ["rad/s", "rpm", "Hz", "rad", "deg"].contains(&taken.ascii().as_str());
            let prior = match (taken.factor == 1.0 || turning, customary) {
                (true, _) => 12.0,
                (false, _) => 0.15,
            };
            let change = Change::Unit { is: input.unit.pretty(), taken: taken.pretty() };
            may(prior, change, taken.si(input.unit.value(si)));
        }
    }
    let whole_or_half =
        has(&["diameter", "radius", "peak", "amplitude", "width", "half", "stroke", "eccentricity"]);
    let prior = if whole_or_half {
        11.0
    } else if kind == Kind::Length {
        4.0
    } else {
        1.2
    };
    for (factor, prior) in [(2.0, prior), (0.5, if prior < 4.0 { 0.8 } else { prior })] {
        let change =
            if whole_or_half || kind == Kind::Length { Change::Half } else { Change::Times(factor, "2") };
        may(prior, change, factor * si);
    }
    if whole_or_half {
        may(0.6, Change::Times(SQRT_2, "√2"), SQRT_2 * si);
        may(1.5, Change::Times(FRAC_1_SQRT_2, "√2"), FRAC_1_SQRT_2 * si);
    }
    if kind == Kind::Acceleration && (9.5..10.2).contains(&si) {
        for g in GRAVITY.into_iter().filter(|g| *g != si) {
            may(2.0, Change::Gravity(g), g);
        }
    }
    if si != 0.0 {
        may(if has(&["damp"]) { 4.0 } else { 2.3 }, Change::LeftOut, 0.0);
        may(if is_signed(input) { 6.0 } else { 1.0 }, Change::Sign, -si);
    }
    let share = match kind {
        Kind::Mass | Kind::Force => Some(1.0),
        // Moments of inertia, unbalances and mass per length are confused as well, but seldom.
        _ => (input.unit.dim.mass == 1 && input.unit.dim.time == 0).then_some(0.3),
    };
    for (share, (prior, g)) in share.into_iter().cartesian_product(weights(&input.unit)) {
        may(share * prior, Change::Weight, si * g);
        may(share * prior, Change::Weight, si / g);
    }
    if kind == Kind::Angle {
        for turn in [0.5 * PI, PI, TAU] {
            may(3.0, Change::Direction, turn - si);
            may(0.8, Change::Direction, turn + si);
            may(0.8, Change::Direction, si - turn);
        }
    }
    if kind == Kind::AngularVelocity {
        let confused = |is: &str, taken: &str| Change::Unit { is: is.to_owned(), taken: taken.to_owned() };
        may(11.0, confused("rad/s", "Hz"), TAU * si);
        may(11.0, confused("Hz", "rad/s"), si / TAU);
        may(0.3, Change::Times(3600.0, "3600"), 3600.0 * si);
        may(0.3, Change::Times(1.0 / 3600.0, "3600"), si / 3600.0);
    }
    for places in [-3i8, -2, -1, 1, 2, 3] {
        let prior = match places.abs() {
            1 => 2.5,
            3 => 1.0,
            _ => 0.3,
        };
        may(prior, Change::PowerOfTen(places), si * 10f64.powi(places.into()));
    }
    if kind == Kind::Length {
        let is_whole = |other: &&VariedInput| other.measure.kind() == Kind::Length && other.si > si;
        for whole in others.iter().filter(is_whole) {
            may(2.7, Change::OtherEnd(whole.label.clone()), whole.si - si);
        }
    }
    if kind == Kind::Ratio {
        may(3.0, Change::Complement, 1.0 - si);
        may(0.8, Change::Times(1e-2, "100"), 0.01 * si);
        may(0.8, Change::Times(1e2, "100"), 100.0 * si);
        // What is counted in whole numbers.
        if si >= 1.0 && si.fract() == 0.0 && has(&["number", "count"]) {
            may(12.0, Change::Count, si + 1.0);
            may(12.0, Change::Count, si - 1.0);
        }
    }
    may(0.2, Change::Squared, si * si);
    if si > 0.0 {
        may(0.1, Change::Rooted, si.sqrt());
        may(0.7, Change::Inverted, 1.0 / si);
    }
    found
}

/// True if the sign of an input is a convention: components, angles, numbers below zero.
fn is_signed(input: &VariedInput) -> bool {
    let is_component = [".x", ".y", ".z"].iter().any(|axis| input.path.ends_with(axis));
    is_component || input.si < 0.0 || input.unit.dim == Dim::ANGLE || input.permits(-input.si)
}

/// One digit copied wrongly, or two interchanged.
fn digits(input: &VariedInput) -> Vec<Way> {
    let right = input.unit.value(input.si);
    let way = |(change, value): (Change, f64)| {
        let prior = match &change {
            Change::Swapped(..) if is_shifted(value / right) => 0.2,
            Change::Swapped(..) => 9.0,
            Change::Digit(right, taken) if looks_alike(right, taken) => 2.4,
            _ => 0.4,
        };
        Way { prior, change, si: input.unit.si(value) }
    };
    other_digit(right).into_iter().map(way).collect()
}

/// The other units of a kind: those of the SI and what stands beside it, or the customary ones.
pub(super) fn units_of(kind: Kind, but: &Unit, customary: bool) -> impl Iterator<Item = Unit> {
    let but = but.ascii();
    kind.units()
        .iter()
        .filter(move |unit| is_customary(unit) == customary && !["dB", "1", "%"].contains(*unit))
        .filter_map(|unit| units::unit(unit).ok())
        .filter(move |unit| unit.ascii() != but)
}
