//! The numbers among the inputs of a problem, and the same problem solved again with some of them changed.

use dalembert_units::{self as units, Dim, Kind, Quantity, Unit};

use crate::{
    Entry, Evaluate, FieldLimit, Measure, Record, Refusal, Shape, SolveError, Stop, Text, Value,
    definitions::{Plan, within_problem},
    field::ValueLimits,
    gravity,
    intern::intern,
    kept,
    path::{Segment, nearest, segments, step},
    reading,
};

/// The share of an input that its influence is shown for.
const PERCENT: f64 = 0.01;

/// Factor of a range that was assumed, to both sides.
pub(crate) const WIDE: f64 = 1000.0;

/// A number among the inputs: a quantity, or one component of a vector.
#[derive(Clone, Debug)]
pub struct VariedInput {
    /// Path of the input: `masses[1].radius`, `force.x`.
    pub path: String,
    /// Label in words, followed by its rows: `Radius 1`.
    pub label: Text,
    /// Symbol in formulas.
    pub symbol: &'static str,
    /// Unit, kind and limits.
    pub measure: Measure,
    /// The unit it was typed in.
    pub unit: Unit,
    /// Value, in SI.
    pub si: f64,
}

/// A problem that is solved again and again with other numbers.
pub struct Perturbed {
    /// The inputs that can be changed.
    pub inputs: Vec<VariedInput>,
    /// The names of the answers that are found each time.
    pub answers: Vec<String>,
    evaluate: Box<dyn Evaluate>,
    limits: InputLimits,
}

/// The limits of several inputs, read once for many points: an analysis does not look at them.
#[derive(Debug)]
pub struct InputLimits(Vec<ValueLimits>);

impl InputLimits {
    /// The limits of inputs that are so measured.
    pub fn of<'m>(measures: impl IntoIterator<Item = &'m Measure>) -> Self {
        Self(measures.into_iter().map(Measure::limits).collect())
    }

    /// The points, in SI, a point a row, with a value outside the limits of its input: row, and the place of the first such
    /// value.
    pub fn outside<'p>(&'p self, points: &'p [f64]) -> impl Iterator<Item = (usize, usize)> + 'p {
        let width = self.0.len().max(1);
        // Hardly ever is there one: a look at each column finds that sooner than one at each row.
        let of_input = |(at, limits): (usize, &ValueLimits)| {
            points.iter().skip(at).step_by(width).fold(true, |all, si| all & limits.permit(*si))
        };
        let rows = if self.0.iter().enumerate().all(of_input) { &[] } else { points };
        rows.chunks_exact(width).enumerate().filter_map(|(row, point)| {
            let at = self.0.iter().zip(point).position(|(limits, si)| !limits.permit(*si))?;
            Some((row, at))
        })
    }
}

/// Error of a name that is no path of these inputs: the nearest path, or all of them.
pub fn unknown_number(inputs: &[VariedInput], name: &str) -> Text {
    let paths = || inputs.iter().map(|input| input.path.as_str());
    let why = match nearest(name, paths()) {
        Some(near) => {
            Text::new("`{name}` is not a number among the inputs; did you mean `{near}`?").with("near", near)
        }
        None => Text::new("`{name}` is not a number among the inputs: {known}")
            .with("known", paths().collect::<Vec<_>>().join(", ")),
    };
    why.with("name", name)
}

/// Every number among the inputs, in the order of the form. Whole numbers and tables are none; gravity is one.
pub fn inputs(record: &Record) -> Vec<VariedInput> {
    let mut found: Vec<VariedInput> = Vec::new();
    record.leaves(&mut |path, field, value| {
        let Some(measure) = field.shape.measure() else { return };
        if gravity::is_gravity(field)
            && gravity::shared(record, path).first().is_some_and(|first| first != path)
        {
            return;
        }
        let input = |path: String, axis: &str, unit: &Unit, si: f64| VariedInput {
            label: of_problem(record, &path, label(field.label, &path, axis)),
            path,
            symbol: field.symbol,
            measure: measure.of(unit),
            unit: unit.clone(),
            si,
        };
        match value {
            Value::Quantity(quantity) => {
                found.push(input(path.to_owned(), "", &quantity.unit, quantity.si));
            }
            Value::Vector(vector) => {
                let axes = ["x", "y", "z"].into_iter().zip(vector.si).take(vector.len);
                found.extend(axes.map(|(axis, si)| input(format!("{path}.{axis}"), axis, &vector.unit, si)));
            }
            _ => {}
        }
    });
    if let Some(plan) = &record.plan {
        found.retain(|input| !plan.has_formula(&input.path) && !plan.is_unknown(&input.path));
        let levers = plan.levers().filter(|(name, ..)| !plan.is_unknown(name));
        found.extend(levers.map(|(name, unit, si)| VariedInput {
            label: Text::verbatim(&name),
            symbol: intern(&name),
            path: name,
            measure: Measure { kind: Some(Kind::Other), ..Measure::in_unit(intern(&unit.ascii())) },
            unit: unit.clone(),
            si,
        }));
    }
    found
}

/// The record with another number at a path of [`inputs`], or at that of an optional one that was left out; `None` where
/// there is none.
pub fn changed(record: &Record, path: &str, si: f64) -> Option<Record> {
    changed_together(record, [(path, si)])
}

/// The record with other numbers at several paths.
pub(crate) fn changed_together<'p>(
    record: &Record,
    changes: impl IntoIterator<Item = (&'p str, f64)>,
) -> Option<Record> {
    let mut record = record.clone();
    let mut plan = record.plan.take().map(|plan| Plan::clone(&plan));
    for (path, si) in changes {
        if let Some(definition) = plan.as_ref().and_then(|plan| plan.lever(path)) {
            plan.as_mut()?.set(definition, si);
        } else {
            for path in places(&mut record, path) {
                *number(&mut record, &path)? = si;
            }
        }
    }
    if let Some(mut plan) = plan {
        plan.renew(&mut record).ok()?;
        record.plan = Some(plan.into());
    }
    Some(record)
}

/// The paths that take another number at a path, several for a gravity that is asked for more than once. Their present
/// values are kept where a field beside them keeps the first one.
pub(crate) fn places(record: &mut Record, path: &str) -> Vec<String> {
    let all = gravity::shared(record, path);
    for path in &all {
        kept::keep(record, path);
    }
    all
}

/// The number at a path. An optional one that was left out is put there.
pub(crate) fn number<'r>(record: &'r mut Record, path: &str) -> Option<&'r mut f64> {
    let segments = segments(path).ok()?;
    let (value, shape, rest) = record.place_mut(&segments)?;
    if let (Value::Absent, Shape::Quantity(measure), []) = (&*value, shape, rest) {
        *value = Value::Quantity(Quantity { si: 0.0, unit: measure.own_unit(), last_place: 0.0 });
    }
    match (value, rest) {
        (Value::Quantity(quantity), []) => Some(&mut quantity.si),
        (Value::Vector(vector), [Segment::Name(axis)]) => {
            vector.si.get_mut(["x", "y", "z"].iter().position(|known| known == axis)?)
        }
        _ => None,
    }
}

/// Reason for which the problem does not have an answer with another number at that path; `None` if it has it. Where it
/// has others, what is doubtful about them is the reason: a limit that is not active is none.
pub fn why_not(
    entry: &Entry,
    record: &Record,
    (input, si): (&VariedInput, f64),
    answer: &str,
    stop: &Stop,
) -> Option<Text> {
    if !input.permits(si) {
        return Some(Text::new("outside the limits of this input"));
    }
    match entry.solve(&changed(record, &input.path, si)?, stop) {
        Err(SolveError::Refused(Refusal::NoAnswer(why))) => Some(why),
        Err(SolveError::Fields(errors)) => errors.into_iter().next().map(|error| error.why),
        Ok(solution) if solution.answer(answer).is_none() => {
            let warning = solution.warnings.into_iter().next();
            Some(warning.unwrap_or_else(|| Text::new("the problem has other answers there")))
        }
        Err(SolveError::Refused(Refusal::Stopped)) | Ok(_) => None,
    }
}

impl VariedInput {
    /// A value of this input as it is typed; a number alone is in the unit of the input.
    ///
    /// # Errors
    /// Why it cannot be read.
    pub fn read(&self, text: &str) -> Result<f64, Text> {
        let read = units::read_quantity(text, &self.unit, self.measure.kind());
        read.map(|read| read.si).map_err(|error| reading::text(&error))
    }

    /// The small change that inputs are compared by, in SI: 1 % of its value, which keeps the sign of the value, or a
    /// degree where it is an angle, whose size says nothing: it depends on where the angle is counted from.
    pub fn step(&self) -> f64 {
        if self.is_angle() { 1f64.to_radians() } else { PERCENT * self.si }
    }

    /// [`step`](Self::step) as it is written.
    pub fn step_text(&self) -> &'static str {
        if self.is_angle() { "1°" } else { "1 %" }
    }

    /// A tolerance as it is typed, in SI: `2 %` of the value, `0.05 mm` to either side. A number alone is in percent, or
    /// in the unit of an angle.
    ///
    /// # Errors
    /// Why it cannot be read.
    pub fn tolerance(&self, text: &str) -> Result<f64, Text> {
        let percent = units::unit("%").expect("percent is a unit");
        let width = match units::read_quantity(text, &percent, Kind::Ratio) {
            Ok(share) if !self.is_angle() || text.contains('%') => share.si * self.si.abs(),
            _ => self.read(text)?,
        };
        if width >= 0.0 {
            Ok(width)
        } else {
            Err(Text::new("a tolerance cannot be negative; it applies to both sides"))
        }
    }

    pub(crate) fn is_angle(&self) -> bool {
        self.unit.dim == Dim::ANGLE
    }

    /// The part of a range, in SI, that is within the limits of the input; ends that it may not take are left out by a
    /// millionth.
    pub(crate) fn permitted(&self, [from, to]: [f64; 2]) -> [f64; 2] {
        let own = self.measure.own_unit();
        let inner =
            |limit: f64, sign: f64| limit + sign * 1e-6 * if limit == 0.0 { 1.0 } else { limit.abs() };
        let low = match self.measure.min {
            FieldLimit::Including(min) => from.max(own.si(min)),
            FieldLimit::Excluding(min) if from <= own.si(min) => own.si(inner(min, 1.0)),
            FieldLimit::None | FieldLimit::Excluding(_) => from,
        };
        let high = match self.measure.max {
            FieldLimit::Including(max) => to.min(own.si(max)),
            FieldLimit::Excluding(max) if to >= own.si(max) => own.si(inner(max, -1.0)),
            FieldLimit::None | FieldLimit::Excluding(_) => to,
        };
        [low, high]
    }

    /// The range that is searched where none is given, in SI: from 1/1000 to 1000 times a value, within the limits of the
    /// input; of an angle a whole turn.
    pub fn range_around(&self, si: f64) -> [f64; 2] {
        if self.is_angle() {
            return self.permitted([-std::f64::consts::PI, std::f64::consts::PI]);
        }
        let ends = [si / WIDE, si * WIDE];
        self.permitted([ends[0].min(ends[1]), ends[0].max(ends[1])])
    }

    /// Returns true if a value, in SI, is within the limits of the input.
    pub fn permits(&self, si: f64) -> bool {
        self.measure.permits(si)
    }
}

impl Perturbed {
    /// Ready to solve the problem with other numbers at `inputs` for these answers. Inputs that the analysis cannot
    /// change, and answers that are no single numbers, are dropped.
    ///
    /// # Errors
    /// Why the problem as given has no answer.
    pub fn new(
        entry: &Entry,
        record: &Record,
        mut inputs: Vec<VariedInput>,
        mut answers: Vec<String>,
    ) -> Result<Self, SolveError> {
        loop {
            let vary: Vec<&str> = inputs.iter().map(|input| input.path.as_str()).collect();
            let wanted: Vec<&str> = answers.iter().map(String::as_str).collect();
            let error = match entry.prepare(record, &vary, &wanted) {
                Ok(evaluate) => {
                    let limits = InputLimits::of(inputs.iter().map(|input| &input.measure));
                    return Ok(Self { inputs, answers, evaluate, limits });
                }
                Err(error) => error,
            };
            let SolveError::Fields(errors) = &error else { return Err(error) };
            let before = inputs.len() + answers.len();
            let fits = |path: &str| errors.iter().all(|error| error.path != path);
            inputs.retain(|input| fits(&input.path));
            answers.retain(|answer| fits(answer));
            if inputs.len() + answers.len() == before {
                return Err(error);
            }
        }
    }

    /// Returns true if the input at a path can be changed.
    pub fn has_input(&self, path: &str) -> bool {
        self.inputs.iter().any(|input| input.path == path)
    }

    /// The answers with these inputs, by their places, changed; NaN where there is none. Values outside the limits of
    /// an input have none.
    ///
    /// # Errors
    /// [`Refusal::Stopped`] alone.
    pub fn with(&mut self, changes: &[(usize, f64)], stop: &Stop) -> Result<Vec<f64>, Refusal> {
        stop.check()?;
        let mut answers = vec![f64::NAN; self.answers.len()];
        if changes.iter().any(|(at, si)| !self.limits.0[*at].permit(*si)) {
            return Ok(answers);
        }
        let mut point: Vec<f64> = self.inputs.iter().map(|input| input.si).collect();
        for (at, si) in changes {
            point[*at] = *si;
        }
        // Without an input there is still one point.
        let point = if point.is_empty() { vec![0.0] } else { point };
        match self.evaluate.sweep(&point, &mut answers, stop) {
            Err(Refusal::Stopped) => Err(Refusal::Stopped),
            _ => Ok(answers),
        }
    }
}

impl std::fmt::Debug for Perturbed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Perturbed")
            .field("inputs", &self.inputs)
            .field("answers", &self.answers)
            .finish_non_exhaustive()
    }
}

/// Label of an input behind the name of its problem, where that is linked.
fn of_problem(record: &Record, path: &str, label: Text) -> Text {
    match within_problem(record.fields, path) {
        ("", _) => label,
        (problem, _) => Text::new("{problem}: {title}").with("problem", problem).with_text("title", label),
    }
}

/// The label of the input that a path leads to, with its rows and its axis: `Radius 1` for `masses[1].radius`.
pub fn title_of(shape: &Shape, path: &str) -> Option<Text> {
    let (mut shape, mut label, mut axis) = (*shape, None, String::new());
    for segment in segments(path).ok()? {
        shape = match (shape.present(), &segment) {
            (Shape::Vector(measure, _), Segment::Name(name)) => {
                name.clone_into(&mut axis);
                Shape::Quantity(measure)
            }
            (table @ Shape::Table(_), Segment::Row(_)) => table,
            (Shape::Table(columns), Segment::Name(name)) => {
                let column = columns().iter().find(|column| column.name == *name)?;
                label = Some(column.label);
                column.shape
            }
            (present, segment) => {
                let (at, inner) = step(&present, segment, path).ok()?;
                if let Shape::Group(fields) = present {
                    label = Some(fields()[at].label);
                }
                inner
            }
        };
    }
    Some(self::label(label?, path, &axis))
}

/// A label with the rows of its path and its axis.
fn label(label: &'static str, path: &str, axis: &str) -> Text {
    let rows = path.split('[').skip(1).filter_map(|rest| rest.split_once(']').map(|(row, _)| row));
    let place: Vec<&str> = rows.chain((!axis.is_empty()).then_some(axis)).collect();
    if place.is_empty() {
        return Text::from(label);
    }
    Text::new("{label} {place}").with_text("label", label).with("place", place.join(" "))
}
