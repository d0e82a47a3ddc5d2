//! Candidate answers: the results that common mistakes would give, the most frequent mistakes first.

use std::f64::consts::{PI, SQRT_2, TAU};

use dalembert_units::{self as units, Dim, Kind, Unit};

use super::{Mistake, NumberChange, wrong::Wrong};
use crate::{
    AnswerValue, Entry, Number, Record, Refusal, Solution, SolveError, Stop,
    reevaluate::{ancestors, reevaluate},
    trace::{Function, Id, Op},
    vary::{self, Perturbed, VariedInput},
};

/// Problems of more inputs have so many pairs that may be interchanged.
const MOST_PAIRS: usize = 60;
/// Worked solutions of more numbers are not read again.
const LONGEST_TRACE: usize = 20_000;
/// So many slips within steps are tried.
const MOST_STEPS: usize = 300;
/// Accelerations of gravity that people take, in m/s².
const GRAVITY: [f64; 4] = [9.81, 10.0, 9.806_65, 9.8];
/// Units that are mixed up with others in countries that use them.
const CUSTOMARY: [&str; 7] = ["in", "ft", "lb", "slug", "oz", "psi", "mil"];

/// A slip, and what each of the wrong answers would be with it.
pub(super) struct Candidate {
    pub(super) slip: Mistake,
    /// NaN where the slip does not concern an answer.
    pub(super) values: Vec<f64>,
    /// Made once, it shows in every answer.
    pub(super) shared: bool,
    /// It is made of what the user said, so it hits by no accident.
    pub(super) free: bool,
}

pub(super) fn candidates(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    wrong: &[Wrong<'_>],
    stop: &Stop,
) -> Result<Vec<Candidate>, Refusal> {
    let mut all = Tries { wrong, found: Vec::new() };
    all.follow(solution);
    all.units(false);
    all.answer(&NumberChange::Sign, |x, _| -x);
    all.times(&[(2.0, "2"), (0.5, "2")]);
    all.others(solution);
    for degrees in [90u16, 180, 360] {
        let turn = f64::from(degrees).to_radians();
        all.angle(&NumberChange::Complement(degrees), |x| turn - x);
        all.angle(&NumberChange::Complement(degrees), |x| x - turn);
        all.angle(&NumberChange::Complement(degrees), |x| x + turn);
    }
    let names = wrong.iter().map(|one| one.name.to_owned()).collect();
    let again = match Perturbed::new(entry, record, vary::inputs(record), names) {
        Ok(again) => Some(again),
        Err(SolveError::Refused(Refusal::Stopped)) => return Err(Refusal::Stopped),
        Err(_) => None,
    };
    let mut inputs = again.map(|again| Inputs::of(again, wrong));
    if let Some(inputs) = &mut inputs {
        inputs.usual(&mut all, stop)?;
    }
    all.times(&[(TAU, "2π"), (1.0 / TAU, "2π"), (10.0, "10"), (0.1, "10"), (1e3, "1000"), (1e-3, "1000")]);
    all.answer(&NumberChange::Squared, |x, _| x * x);
    all.answer(&NumberChange::Rooted, |x, _| x.sqrt());
    all.times(&[(PI, "π"), (1.0 / PI, "π"), (4.0, "4"), (0.25, "4"), (SQRT_2, "√2"), (1.0 / SQRT_2, "√2")]);
    if let Some(inputs) = &mut inputs {
        inputs.interchanged(&mut all, stop)?;
        inputs.less_usual(&mut all, stop)?;
    }
    all.steps(solution, stop)?;
    all.times(&[
        (9.81, "g"),
        (1.0 / 9.81, "g"),
        (10.0, "g"),
        (3.0, "3"),
        (1.0 / 3.0, "3"),
        (1e2, "100"),
        (1e-2, "100"),
    ]);
    all.times(&[(1e6, "10⁶"), (1e-6, "10⁶"), (-2.0, "−2"), (-0.5, "−2")]);
    all.answer(&NumberChange::Inverted, |x, _| 1.0 / x);
    all.units(true);
    if let Some(inputs) = &mut inputs {
        inputs.rare(&mut all, stop)?;
    }
    Ok(all.found)
}

struct Tries<'w, 's> {
    wrong: &'w [Wrong<'s>],
    found: Vec<Candidate>,
}

impl Tries<'_, '_> {
    fn push(&mut self, slip: Mistake, values: Vec<f64>, shared: bool) {
        if values.iter().any(|value| value.is_finite()) {
            self.found.push(Candidate { slip, values, shared, free: false });
        }
    }

    /// The answers changed at the end.
    fn answer(&mut self, change: &NumberChange, by: impl Fn(f64, &Wrong<'_>) -> f64) {
        let values = self.wrong.iter().map(|one| by(one.computed, one)).collect();
        self.push(Mistake::Answer(change.clone()), values, false);
    }

    fn times(&mut self, factors: &[(f64, &'static str)]) {
        for (factor, written) in factors {
            self.answer(&NumberChange::Times(*factor, written), |x, _| factor * x);
        }
    }

    fn angle(&mut self, change: &NumberChange, by: impl Fn(f64) -> f64) {
        self.answer(change, |x, one| if one.answer.dim() == Dim::ANGLE { by(x) } else { f64::NAN });
    }

    /// The number of another unit before the unit that was typed.
    fn units(&mut self, customary: bool) {
        for at in 0..self.wrong.len() {
            let one = &self.wrong[at];
            let typed = &one.unit;
            let tries: Vec<(NumberChange, f64)> = units_of(Kind::of(&one.answer.unit), typed, customary)
                .map(|taken| {
                    let value = typed.si(taken.value(one.computed));
                    (NumberChange::Unit { is: typed.pretty(), taken: taken.pretty() }, value)
                })
                .collect();
            for (change, value) in tries {
                let mut values = vec![f64::NAN; self.wrong.len()];
                values[at] = value;
                self.push(Mistake::Answer(change), values, false);
            }
        }
    }

    /// The other answers of the problem.
    fn others(&mut self, solution: &Solution) {
        for other in &solution.answers {
            let Some(si) = other.si() else { continue };
            let name = other.name.to_string();
            let value = |one: &Wrong<'_>| {
                if other.dim().agrees(one.answer.dim()) && one.name != name { si } else { f64::NAN }
            };
            let values = self.wrong.iter().map(value).collect();
            self.push(Mistake::Other(name.clone()), values, false);
        }
    }

    /// Adds the consequences of the user's other answers (error carried forward).
    fn follow(&mut self, solution: &Solution) {
        let node = |one: &Wrong<'_>| match &one.answer.value {
            AnswerValue::Number(_, id) => Some(*id),
            _ => None,
        };
        let given: Vec<(usize, Id)> =
            self.wrong.iter().enumerate().filter_map(|(at, one)| Some((at, node(one)?))).collect();
        if given.len() < 2 || solution.trace.nodes.len() > LONGEST_TRACE {
            return;
        }
        for &(at, id) in &given {
            let before = ancestors(solution, id);
            let causes: Vec<&(usize, Id)> =
                given.iter().filter(|(other, cause)| *other != at && before.contains(cause)).collect();
            if causes.is_empty() {
                continue;
            }
            let set: Vec<(Id, Number)> = causes
                .iter()
                .map(|(other, cause)| (*cause, Number::Scalar(self.wrong[*other].answered)))
                .collect();
            let numbers = reevaluate(solution, &set, None);
            let mut values = vec![f64::NAN; self.wrong.len()];
            values[at] = scalar(numbers[id as usize]);
            let names = causes.iter().map(|(other, _)| self.wrong[*other].name.to_owned()).collect();
            self.found.push(Candidate { slip: Mistake::Follows(names), values, shared: false, free: true });
        }
    }

    /// Slips within the steps before the wrong answers.
    fn steps(&mut self, solution: &Solution, stop: &Stop) -> Result<(), Refusal> {
        if solution.trace.nodes.len() > LONGEST_TRACE {
            return Ok(());
        }
        let ids: Vec<Option<Id>> = self
            .wrong
            .iter()
            .map(|one| if let AnswerValue::Number(_, id) = &one.answer.value { Some(*id) } else { None })
            .collect();
        let mut before: Vec<Id> = ids.iter().flatten().flat_map(|id| ancestors(solution, *id)).collect();
        before.sort_unstable();
        before.dedup();
        let mut tries = 0;
        for (place, step) in solution.steps.iter().enumerate() {
            if before.binary_search(&step.result).is_err() {
                continue;
            }
            let others = step.formula.map_or_else(Vec::new, |formula| within(solution, formula));
            let value = solution.trace.node(step.result).number;
            let results = [
                (NumberChange::Sign, scaled(value, -1.0)),
                (NumberChange::Times(2.0, "2"), scaled(value, 2.0)),
                (NumberChange::Times(0.5, "2"), scaled(value, 0.5)),
            ];
            let of_formula =
                others.iter().map(|(change, id, op)| (change, reevaluate(solution, &[], Some((*id, op)))));
            let of_result = results
                .iter()
                .map(|(change, number)| (change, reevaluate(solution, &[(step.result, *number)], None)));
            for (change, numbers) in of_formula.chain(of_result) {
                stop.check()?;
                tries += 1;
                if tries > MOST_STEPS {
                    return Ok(());
                }
                let values =
                    ids.iter().map(|id| id.map_or(f64::NAN, |id| scalar(numbers[id as usize]))).collect();
                self.push(Mistake::Step(place, step.symbol, change.clone()), values, true);
            }
        }
        Ok(())
    }
}

/// The problem solved again with inputs taken otherwise.
struct Inputs {
    again: Perturbed,
    /// Index of each wrong answer in the list of answers, `None` where it is absent.
    places: Vec<Option<usize>>,
}

impl Inputs {
    fn of(again: Perturbed, wrong: &[Wrong<'_>]) -> Self {
        let place = |one: &Wrong<'_>| again.answers.iter().position(|name| name == one.name);
        let places = wrong.iter().map(place).collect();
        Self { again, places }
    }

    fn solved(&mut self, changes: &[(usize, f64)], stop: &Stop) -> Result<Vec<f64>, Refusal> {
        let found = self.again.with(changes, stop)?;
        Ok(self.places.iter().map(|place| place.map_or(f64::NAN, |place| found[place])).collect())
    }

    /// One input after the other taken in these ways.
    fn each(
        &mut self,
        all: &mut Tries<'_, '_>,
        stop: &Stop,
        ways: impl Fn(&VariedInput) -> Vec<(NumberChange, f64)>,
    ) -> Result<(), Refusal> {
        for at in 0..self.again.inputs.len() {
            let input = &self.again.inputs[at];
            let (path, label, ways) = (input.path.clone(), input.label.clone(), ways(input));
            for (change, si) in ways {
                let values = self.solved(&[(at, si)], stop)?;
                all.push(Mistake::Input(path.clone(), label.clone(), change), values, true);
            }
        }
        Ok(())
    }

    fn usual(&mut self, all: &mut Tries<'_, '_>, stop: &Stop) -> Result<(), Refusal> {
        self.each(all, stop, |input| {
            let kind = input.measure.kind();
            let mut ways = Vec::new();
            for taken in units_of(kind, &input.unit, false) {
                let turning = [Kind::AngularVelocity, Kind::Angle].contains(&kind)
                    && ["rad/s", "rpm", "Hz", "rad", "deg"].contains(&taken.ascii().as_str());
                if taken.factor == 1.0 || turning {
                    ways.push(as_if(input, &taken));
                }
            }
            if kind == Kind::Length {
                ways.push((NumberChange::Diameter, 2.0 * input.si));
                ways.push((NumberChange::Diameter, 0.5 * input.si));
            }
            if kind == Kind::Acceleration && (9.5..10.2).contains(&input.si) {
                let other = |g: &&f64| **g != input.si;
                ways.extend(GRAVITY.iter().filter(other).map(|g| (NumberChange::Gravity(*g), *g)));
            }
            if input.si != 0.0 {
                ways.push((NumberChange::LeftOut, 0.0));
            }
            ways
        })
    }

    fn less_usual(&mut self, all: &mut Tries<'_, '_>, stop: &Stop) -> Result<(), Refusal> {
        self.each(all, stop, |input| {
            let mut ways = vec![(NumberChange::Sign, -input.si)];
            if input.measure.kind() == Kind::Angle {
                ways.extend(
                    [90u16, 180].map(|turn| {
                        (NumberChange::Complement(turn), f64::from(turn).to_radians() - input.si)
                    }),
                );
            }
            if input.measure.kind() != Kind::Length {
                ways.push((NumberChange::Times(2.0, "2"), 2.0 * input.si));
                ways.push((NumberChange::Times(0.5, "2"), 0.5 * input.si));
            }
            ways
        })
    }

    fn rare(&mut self, all: &mut Tries<'_, '_>, stop: &Stop) -> Result<(), Refusal> {
        self.each(all, stop, |input| {
            let mut ways: Vec<_> = units_of(input.measure.kind(), &input.unit, false)
                .map(|taken| as_if(input, &taken))
                .collect();
            for (factor, written) in
                [(10.0, "10"), (0.1, "10"), (1e3, "1000"), (1e-3, "1000"), (TAU, "2π"), (1.0 / TAU, "2π")]
            {
                ways.push((NumberChange::Times(factor, written), factor * input.si));
            }
            ways
        })
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
            let named = |at: usize| {
                let input: &VariedInput = &self.again.inputs[at];
                (input.path.clone(), input.label.clone())
            };
            let slip = Mistake::Interchanged(Box::new([named(first), named(second)]));
            let changes = [(first, self.again.inputs[second].si), (second, self.again.inputs[first].si)];
            let values = self.solved(&changes, stop)?;
            all.push(slip, values, true);
        }
        Ok(())
    }
}

/// The number of an input taken in another unit.
fn as_if(input: &VariedInput, taken: &Unit) -> (NumberChange, f64) {
    let change = NumberChange::Unit { is: input.unit.pretty(), taken: taken.pretty() };
    (change, taken.si(input.unit.value(input.si)))
}

/// The other units of a kind: those of the SI and what stands beside it, or the customary ones.
fn units_of(kind: Kind, but: &Unit, customary: bool) -> impl Iterator<Item = Unit> {
    let but = but.ascii();
    let is_customary = |unit: &str| CUSTOMARY.iter().any(|name| unit.contains(name) && !unit.contains("min"));
    kind.units()
        .iter()
        .filter(move |unit| is_customary(unit) == customary && !["dB", "1", "%"].contains(*unit))
        .filter_map(|unit| units::unit(unit).ok())
        .filter(move |unit| unit.ascii() != but)
}

/// Mistakes within a formula: alternative operations at one of its nodes.
fn within(solution: &Solution, formula: Id) -> Vec<(NumberChange, Id, Op)> {
    let mut found = Vec::new();
    let mut open = vec![formula];
    while let Some(id) = open.pop() {
        open.extend(solution.trace.operands(id));
        let mut may = |change: NumberChange, op: Op| found.push((change, id, op));
        // The first power of a number is the number.
        let alone = |id: Id| Op::Power(id, 1);
        match &solution.trace.node(id).op {
            Op::Power(a, n) if *n > 1 => may(NumberChange::PowerLeftOut, alone(*a)),
            Op::Power(a, n) if *n < -1 => may(NumberChange::PowerLeftOut, Op::Power(*a, -1)),
            Op::Root(a, _) => may(NumberChange::RootLeftOut, alone(*a)),
            Op::Call(Function::Sin, a) => may(NumberChange::SineForCosine, Op::Call(Function::Cos, *a)),
            Op::Call(Function::Cos, a) => may(NumberChange::SineForCosine, Op::Call(Function::Sin, *a)),
            Op::Neg(a) => may(NumberChange::TermSign, alone(*a)),
            Op::Add(a, b) => {
                may(NumberChange::TermSign, Op::Sub(*a, *b));
                may(NumberChange::TermLeftOut, alone(*a));
                may(NumberChange::TermLeftOut, alone(*b));
            }
            Op::Sub(a, b) => {
                may(NumberChange::TermSign, Op::Add(*a, *b));
                may(NumberChange::TermLeftOut, alone(*a));
                may(NumberChange::TermLeftOut, alone(*b));
            }
            Op::Mul(a, b) => may(NumberChange::DividedForMultiplied, Op::Div(*a, *b)),
            Op::Div(a, b) => may(NumberChange::DividedForMultiplied, Op::Mul(*a, *b)),
            _ => {}
        }
    }
    found
}

fn scaled(number: Number, by: f64) -> Number {
    match number {
        Number::Scalar(x) => Number::Scalar(by * x),
        Number::Vector(v) => Number::Vector(v.map(|x| by * x)),
    }
}

fn scalar(number: Number) -> f64 {
    if let Number::Scalar(x) = number { x } else { f64::NAN }
}
