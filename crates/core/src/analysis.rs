//! Analyses and their registry.

mod prepared;

use std::{
    fmt,
    sync::{
        OnceLock,
        atomic::{AtomicBool, AtomicU32, Ordering},
    },
};

use crate::{
    Answer, Exhibit, Field, FieldError, FieldPath, Inputs, LinkedProblem, Record, Shape, Sheet, Solution,
    Source, Text, Value, Worksheet, assumed, definitions, exhibit::mark_given, input::Lift, mutation::Mutant,
    tolerances, unknowns, vary,
};

/// Description of an analysis, read before picking it.
#[derive(Debug)]
pub struct About {
    /// `family/name`, in kebab case: the name on the command line and in files.
    pub id: &'static str,
    /// A few words.
    pub title: &'static str,
    /// The topic of its family that it stands under in the list, a few words: one that is there already, if it fits.
    pub topic: &'static str,
    /// One sentence: what goes in and what comes out.
    pub summary: &'static str,
    /// Names of the main answers, those for which one opens it, the most wanted first. Of them those that a solution has
    /// stand before its other answers.
    pub main: &'static [&'static str],
    /// Words people search for, in any language.
    pub keywords: &'static str,
    /// The books and notes it follows.
    pub sources: &'static [&'static Source],
    /// Published cases, in TOML. The first one is what the form opens with.
    pub cases: &'static str,
}

/// A problem: its fields are the inputs, and it knows how it is solved.
pub trait Analysis: Inputs {
    /// Description shown in the list of analyses.
    const ABOUT: About;
    /// Sweeps and studies read several points at once by SIMD. For that, [`solve`](Analysis::solve) takes the numbers of
    /// formulas and conditions from `given`, none from the fields of `self`, and asks conditions by
    /// [`Real::holds`](dalembert_numerics::Real::holds). Points whose conditions differ, or whose solve needs a
    /// [`value`](dalembert_numerics::Real::value), are read one by one.
    const SIMD: bool = false;

    /// Writes the solution on `sheet`. `given` holds the inputs as numbers of that worksheet, `self` in SI.
    fn solve<W: Worksheet>(&self, given: &Self::Given<W>, sheet: W) -> Result<(), Refusal>;
}

/// Reason for which valid inputs have no solution.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The problem is well written but has no answer, and why.
    NoAnswer(Text),
    /// Nobody waits for the answer any more.
    Stopped,
}

/// Reason for which there is no solution: invalid inputs, a refusal, a stop.
#[derive(Clone, Debug, PartialEq)]
pub enum SolveError {
    /// Inputs that cannot be read or may not stand: all of them.
    Fields(Vec<FieldError>),
    /// Inputs without an answer.
    Refused(Refusal),
}

/// A signal that ends a solve early, and the part of a long one that is done.
#[derive(Debug, Default)]
pub struct Stop {
    given: AtomicBool,
    /// Percentage of the work that is done; 0 where nothing is known of it.
    done: AtomicU32,
}

/// One registered analysis, with its types erased.
#[derive(Clone, Copy)]
pub struct Entry {
    /// Description shown in the list of analyses.
    pub about: &'static About,
    /// Sweeps read several points at once by SIMD ([`Analysis::SIMD`]).
    pub simd: bool,
    shape: Shape,
    inputs: Shape,
    write: Write,
    prepare: Prepare,
    /// The problems that are linked; none of an analysis itself.
    linked: &'static [LinkedProblem],
    /// The linked problem whose pictures come first; empty for the order in which they are solved.
    pictured: &'static str,
}

/// Writes the solution of the inputs at a path onto a sheet.
type Write = fn(&Value, &FieldPath<'_>, &Sheet<'_>) -> Result<(), SolveError>;
type Prepare = fn(&Record, vary: &[&str], wanted: &[&str]) -> Result<Box<dyn Evaluate>, SolveError>;

/// The plain reading of a problem, ready to be repeated with other inputs.
pub trait Evaluate: Send {
    /// Solves once for each row of `points` (row-major, one column for each varied input, in SI) and writes the
    /// wanted answers into `answers` (row-major). A point without an answer gives NaN in its row.
    fn sweep(&mut self, points: &[f64], answers: &mut [f64], stop: &Stop) -> Result<(), Refusal> {
        self.sweep_with_reasons(points, answers, &mut |_, _| {}, stop)
    }

    /// The same; `refused` receives each row without an answer, and why.
    fn sweep_with_reasons(
        &mut self,
        points: &[f64],
        answers: &mut [f64],
        refused: &mut dyn FnMut(usize, Text),
        stop: &Stop,
    ) -> Result<(), Refusal>;

    /// Points that have been read by SIMD so far, several at once.
    fn points_by_simd(&self) -> u64 {
        0
    }
}

inventory::collect!(Entry);

/// Registers an [`Analysis`]. Stands at the top level of a file.
#[macro_export]
macro_rules! register {
    ($analysis:ty) => {
        $crate::inventory::submit! { $crate::Entry::of::<$analysis>() }
    };
}

/// Every linked analysis, in the order of their ids. Of those with the same id, the first by title.
pub fn registry() -> &'static [&'static Entry] {
    &linked()[0]
}

/// Analyses that are left out, because another has their id.
pub fn duplicates() -> &'static [&'static Entry] {
    &linked()[1]
}

/// The analyses with an id of their own, and the others.
fn linked() -> &'static [Vec<&'static Entry>; 2] {
    static LINKED: OnceLock<[Vec<&'static Entry>; 2]> = OnceLock::new();
    LINKED.get_or_init(|| {
        let mut all: Vec<&'static Entry> = inventory::iter::<Entry>().collect();
        all.sort_by_key(|entry| (entry.about.id, entry.about.title));
        let mut duplicates = Vec::new();
        all.dedup_by(|entry, before| {
            let is_taken = entry.about.id == before.about.id;
            if is_taken {
                duplicates.push(*entry);
            }
            is_taken
        });
        [all, duplicates]
    })
}

/// The analysis of that id.
pub fn find_analysis(id: &str) -> Option<&'static Entry> {
    registry().iter().find(|entry| entry.about.id == id).copied()
}

impl Entry {
    /// The entry of an analysis.
    pub const fn of<A: Analysis>() -> Self {
        Self {
            about: &A::ABOUT,
            simd: A::SIMD,
            shape: definitions::shape_of::<A>(),
            inputs: A::SHAPE,
            write: write::<A>,
            prepare: prepared::prepare::<A>,
            linked: &[],
            pictured: "",
        }
    }

    /// The entry of linked problems: its inputs are theirs, each in a group of its name.
    pub(crate) const fn of_linked(
        about: &'static About,
        [inputs, shape]: [Shape; 2],
        linked: &'static [LinkedProblem],
    ) -> Self {
        let write: Write = |_, _, _| Ok(());
        let prepare: Prepare =
            |_, _, _| Err(Refusal::because("linked problems are solved one by one").into());
        Self { about, simd: false, shape, inputs, write, prepare, linked, pictured: "" }
    }

    /// The same entry under another description.
    pub(crate) fn with_about(self, about: &'static About) -> Self {
        Self { about, ..self }
    }

    /// The same entry with the pictures of one of its linked problems first; empty for the order in which they are solved.
    pub(crate) fn with_pictured(self, pictured: &'static str) -> Self {
        Self { pictured, ..self }
    }

    /// The linked problem whose pictures come first; empty where none was chosen.
    pub(crate) fn pictured(&self) -> &'static str {
        self.pictured
    }

    /// True where the pictures of a chosen one of its linked problems come first.
    pub fn is_pictured(&self) -> bool {
        !self.pictured.is_empty()
    }

    /// The problems that are linked; none of an analysis itself.
    pub fn linked(&self) -> &'static [LinkedProblem] {
        self.linked
    }

    /// The shape of a problem of it: a group of its inputs, and behind them definitions and questions.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Shape of the inputs of the analysis itself: a group.
    pub(crate) fn inputs(&self) -> Shape {
        self.inputs
    }

    /// Writes the solution of inputs, whose formulas have their values, onto a sheet. `field_path` leads to them.
    pub(crate) fn write(
        &self,
        inputs: &Value,
        field_path: &FieldPath<'_>,
        sheet: &Sheet<'_>,
    ) -> Result<(), SolveError> {
        let before = sheet.mark();
        (self.write)(inputs, field_path, sheet)?;
        sheet.rank_answers(before, self.about.main);
        Ok(())
    }

    /// Input fields of the analysis itself.
    pub fn fields(&self) -> &'static [Field] {
        self.inputs().fields(None)
    }

    /// The family: the part of the id before `/`.
    pub fn family(&self) -> &'static str {
        self.about.id.split_once('/').map_or(self.about.id, |(family, _)| family)
    }

    /// Solves, leaving the worked solution.
    pub fn solve(&self, record: &Record, stop: &Stop) -> Result<Solution, SolveError> {
        let determined = unknowns::determine(self, record, stop)?;
        let record = determined.as_ref().unwrap_or(record);
        let mut solution = worked(self, record, stop, None)?;
        solution.exhibits.extend(tolerances::table(self, record, &solution, stop)?.map(Exhibit::Table));
        Ok(solution)
    }

    /// Solves at the values as they are, without the worst case over the tolerances.
    pub(crate) fn solve_nominal(&self, record: &Record, stop: &Stop) -> Result<Solution, SolveError> {
        let determined = unknowns::determine(self, record, stop)?;
        worked(self, determined.as_ref().unwrap_or(record), stop, None)
    }

    /// Solves with one number of the worked solution made wrongly, to see which checks and published answers notice.
    pub fn solve_mutated(
        &self,
        record: &Record,
        mutant: Mutant,
        stop: &Stop,
    ) -> Result<Solution, SolveError> {
        let determined = unknowns::determine(self, record, stop)?;
        worked(self, determined.as_ref().unwrap_or(record), stop, Some(mutant))
    }

    /// Prepares the plain reading: `vary` are paths of quantities, `wanted` names of answers that are numbers.
    pub fn prepare(
        &self,
        record: &Record,
        vary: &[&str],
        wanted: &[&str],
    ) -> Result<Box<dyn Evaluate>, SolveError> {
        match &record.plan {
            Some(plan) => definitions::prepare(self, record, plan, vary, wanted),
            None => (self.prepare)(record, vary, wanted),
        }
    }
}

impl fmt::Debug for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Entry").field(&self.about.id).finish()
    }
}

impl Refusal {
    /// There is no answer, and why: `return Err(Refusal::because("the speed is zero"))`.
    pub fn because(why: impl Into<Text>) -> Self {
        Refusal::NoAnswer(why.into())
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::NoAnswer(why) => f.write_str(&why.english()),
            Refusal::Stopped => f.write_str("cancelled"),
        }
    }
}

impl fmt::Display for SolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SolveError::Fields(errors) => {
                for (n, err) in errors.iter().enumerate() {
                    write!(f, "{}{err}", if n == 0 { "" } else { "; " })?;
                }
                Ok(())
            }
            SolveError::Refused(refusal) => refusal.fmt(f),
        }
    }
}

impl std::error::Error for SolveError {}

impl From<Refusal> for SolveError {
    fn from(refusal: Refusal) -> Self {
        SolveError::Refused(refusal)
    }
}

impl Stop {
    /// A signal that has not been given.
    pub const fn new() -> Self {
        Self { given: AtomicBool::new(false), done: AtomicU32::new(0) }
    }

    /// Gives the signal.
    pub fn stop(&self) {
        self.given.store(true, Ordering::Relaxed);
    }

    /// `Err` once the signal has been given.
    #[inline]
    pub fn check(&self) -> Result<(), Refusal> {
        if self.given.load(Ordering::Relaxed) { Err(Refusal::Stopped) } else { Ok(()) }
    }

    /// Reports that a part of the work is done, of so many equal ones.
    pub fn report(&self, part: usize, of: usize) {
        self.done.store((100 * part / of.max(1)) as u32, Ordering::Relaxed);
    }

    /// Percentage of the work that is done, once the solve has reported it.
    pub fn percentage(&self) -> Option<u32> {
        Some(self.done.load(Ordering::Relaxed)).filter(|done| *done > 0)
    }
}

fn write<A: Analysis>(
    inputs: &Value,
    field_path: &FieldPath<'_>,
    sheet: &Sheet<'_>,
) -> Result<(), SolveError> {
    let mut errors = Vec::new();
    let problem = A::read(inputs, field_path, &mut errors);
    let Some(problem) = problem.filter(|_| errors.is_empty()) else { return Err(SolveError::Fields(errors)) };
    let given = problem.given(Lift { sheet, value: Some(inputs), field_path });
    Ok(problem.solve(&given, sheet)?)
}

/// Solves on a worksheet: the part that is the same for every analysis, compiled once.
fn worked(
    entry: &Entry,
    record: &Record,
    stop: &Stop,
    mutant: Option<Mutant>,
) -> Result<Solution, SolveError> {
    let sheet = mutant.map_or_else(|| Sheet::new(stop), |mutant| Sheet::mutated(stop, mutant));
    match &record.plan {
        Some(plan) => plan.solve(entry, record, &sheet)?,
        None => entry.write(&Value::Group(record.clone()), &FieldPath::TOP, &sheet)?,
    }
    if let Some(plan) = &record.plan
        && let Some(determined) = plan.determined()
    {
        determined.conclude(plan, &sheet);
    }
    let mut solution = sheet.into_solution()?;
    // What was unknown is what was asked for: it comes first.
    if let Some(determined) = record.plan.as_ref().and_then(|plan| plan.determined()) {
        let found = |answer: &Answer| determined.unknowns.iter().any(|unknown| answer.name.is(&unknown.name));
        solution.answers.sort_by_key(|answer| !(answer.asked && found(answer)));
        solution.determined = Some(determined.clone());
    }
    solution.warnings.splice(0..0, assumed::warnings(record));
    forget_absent(&mut solution.exhibits, record.clone());
    mark_given(&mut solution.exhibits, record, &solution.answers);
    Ok(solution)
}

/// Forgets inputs that exhibits run over where the problem has none of that name: another alternative is chosen.
fn forget_absent(exhibits: &mut [Exhibit], mut record: Record) {
    let mut has = |path: &str| vary::number(&mut record, path).is_some();
    for exhibit in exhibits {
        match exhibit {
            Exhibit::Plot(plot) => {
                plot.over = plot.over.take().filter(|over| has(&over.input));
                for series in &mut plot.series {
                    let is_asked = series.with.iter().all(|(input, _)| has(input));
                    series.of = series.of.take().filter(|_| is_asked);
                }
            }
            Exhibit::Animation(animation) => {
                animation.over = animation.over.take().filter(|(input, _)| has(input));
            }
            _ => {}
        }
    }
}
