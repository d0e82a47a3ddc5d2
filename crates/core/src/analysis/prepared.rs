//! The plain reading of an analysis, prepared for many points: one after the other, or several at once by SIMD.

use dalembert_numerics::simd::{self, SimdVector, WIDTH};

use super::{Analysis, Evaluate, Refusal, SolveError, Stop};
use crate::{
    FieldError, FieldPath, Inputs, Name, Plain, Record, Shape, Text, Value, gravity, input::Lift, kept,
    worksheet,
};

/// A problem whose type is erased, for the plain reading.
trait Problem: Send {
    fn slot(&mut self, path: &[usize]) -> Option<&mut f64>;
    fn solve_plain(&self, plain: &Plain<'_>) -> Result<(), Refusal>;
    /// Solves at several points at once; `None` where the analysis is not read by SIMD, or the points diverge.
    fn solve_samples(&self, plain: &Plain<'_, SimdVector>) -> Option<Result<(), Refusal>>;
}

impl<A: Analysis> Problem for A {
    fn slot(&mut self, path: &[usize]) -> Option<&mut f64> {
        Inputs::slot(self, path)
    }

    fn solve_plain(&self, plain: &Plain<'_>) -> Result<(), Refusal> {
        let given = self.given(Lift { sheet: plain, value: None, field_path: &FieldPath::TOP });
        self.solve(&given, plain)
    }

    fn solve_samples(&self, plain: &Plain<'_, SimdVector>) -> Option<Result<(), Refusal>> {
        // A constant, so that the SIMD reading of other analyses is never compiled.
        if A::SIMD {
            let lift = Lift { sheet: plain, value: None, field_path: &FieldPath::TOP };
            simd::converged(|| {
                simd::widest(
                    #[inline(always)]
                    || {
                        let given = self.given(lift);
                        self.solve(&given, plain)
                    },
                )
            })
        } else {
            None
        }
    }
}

struct Prepared {
    problem: VariedProblem,
    wanted: Vec<(usize, Name)>,
    blocks: Blocks,
}

/// A problem and the inputs that vary.
struct VariedProblem {
    problem: Box<dyn Problem>,
    /// The places of each input: several for the gravity of a problem that asks for it more than once.
    vary: Vec<Vec<Vec<usize>>>,
}

/// Working data of blocks of points that are read by SIMD.
struct Blocks {
    /// Blocks that were read, less those whose points diverged; below zero, points are read one by one.
    balance: i64,
    /// Blocks that were read.
    read: u64,
    varied: Vec<SimdVector>,
    answers: Vec<(Name, SimdVector)>,
}

/// Blocks that are tried before an analysis is read one point after the other.
const TRIED: i64 = 8;

/// Prepares the plain reading of an analysis.
pub(super) fn prepare<A: Analysis>(
    record: &Record,
    vary: &[&str],
    wanted: &[&str],
) -> Result<Box<dyn Evaluate>, SolveError> {
    let read =
        |value: &Value| -> Result<Box<dyn Problem>, Vec<FieldError>> { Ok(Box::new(A::read_all(value)?)) };
    prepared(record, [vary, wanted], (&A::SHAPE, A::SIMD), read)
}

fn prepared(
    record: &Record,
    [vary, wanted]: [&[&str]; 2],
    (shape, is_simd): (&Shape, bool),
    read: fn(&Value) -> Result<Box<dyn Problem>, Vec<FieldError>>,
) -> Result<Box<dyn Evaluate>, SolveError> {
    let mut varied = record.clone();
    for path in vary {
        kept::keep(&mut varied, path);
    }
    let mut problem = read(&Value::Group(varied)).map_err(SolveError::Fields)?;
    let unknown =
        |path: &str, why: &'static str| SolveError::Fields(vec![FieldError::new(path, Text::from(why))]);
    let mut slots = Vec::new();
    for path in vary {
        let mut places = Vec::new();
        for place in gravity::shared(record, path) {
            let slot = crate::path::indices(shape, &place).map_err(|err| SolveError::Fields(vec![err]))?;
            if problem.slot(&slot).is_none() {
                return Err(unknown(path, "is not a quantity of this problem, so it cannot be varied"));
            }
            places.push(slot);
        }
        slots.push(places);
    }
    // The places of the answers, from one reading of the problem as given.
    let stop = Stop::new();
    let plain = Plain::new(&stop);
    problem.solve_plain(&plain)?;
    let names: Vec<Name> = plain.answers().into_iter().map(|(name, _)| name).collect();
    let wanted = wanted
        .iter()
        .map(|&name| {
            let at = names.iter().position(|found| found.is(name));
            at.map(|at| (at, names[at])).ok_or_else(|| unknown(name, "is not a number among the answers"))
        })
        .collect::<Result<_, _>>()?;
    let blocks = Blocks {
        balance: if is_simd { TRIED } else { -1 },
        read: 0,
        varied: vec![0.0.into(); vary.len()],
        answers: Vec::new(),
    };
    let problem = VariedProblem { problem, vary: slots };
    Ok(Box::new(Prepared { problem, wanted, blocks }))
}

impl VariedProblem {
    fn set(&mut self, input: usize, value: f64) {
        for slot in &self.vary[input] {
            if let Some(place) = self.problem.slot(slot) {
                *place = value;
            }
        }
    }

    /// Solves a point for the wanted answers of the worksheet.
    fn solve(&mut self, point: &[f64], plain: &Plain<'_>, stop: &Stop) -> Result<(), Refusal> {
        for (input, value) in point.iter().enumerate().take(self.vary.len()) {
            self.set(input, *value);
        }
        plain.clear();
        match self.problem.solve_plain(plain) {
            Err(Refusal::Stopped) if stop.check().is_ok() && plain.is_complete() => Ok(()),
            solved => solved,
        }
    }
}

impl Blocks {
    /// Solves a block of as many points as a SIMD vector has lanes. Returns false where that has to be done one by one:
    /// the points diverge, have no answer, or one that is not finite.
    fn solve(
        &mut self,
        problem: &mut VariedProblem,
        wanted: &[(usize, Name)],
        (points, answers): (&[f64], &mut [f64]),
        stop: &Stop,
    ) -> bool {
        let columns = self.varied.len();
        for (input, varied) in self.varied.iter_mut().enumerate() {
            problem.set(input, worksheet::mark(input));
            *varied = SimdVector::of(|lane| points[lane * columns + input]);
        }
        let memory = std::mem::take(&mut self.answers);
        let plain = Plain::samples(stop, wanted, &self.varied, memory);
        let mut is_solved = match problem.problem.solve_samples(&plain) {
            Some(Ok(())) => true,
            Some(Err(Refusal::Stopped)) => plain.is_complete(),
            Some(Err(Refusal::NoAnswer(_))) | None => false,
        };
        if is_solved {
            for (n, (at, name)) in wanted.iter().enumerate() {
                let found = plain.answer_at(*at, *name).unwrap_or(f64::NAN.into());
                for (lane, value) in found.0.into_iter().enumerate() {
                    answers[lane * wanted.len() + n] = value;
                    is_solved &= value.is_finite();
                }
            }
        }
        self.answers = plain.into_answers();
        self.balance += if is_solved { 1 } else { -1 };
        self.read += u64::from(is_solved);
        is_solved
    }
}

impl Evaluate for Prepared {
    fn sweep_with_reasons(
        &mut self,
        points: &[f64],
        answers: &mut [f64],
        refused: &mut dyn FnMut(usize, Text),
        stop: &Stop,
    ) -> Result<(), Refusal> {
        let Self { problem, wanted: names, blocks } = self;
        let (columns, wanted) = (problem.vary.len().max(1), names.len().max(1));
        let plain = Plain::until(stop, names);
        let parts = points.chunks(columns * WIDTH).zip(answers.chunks_mut(wanted * WIDTH));
        for (n, (points, rows)) in parts.enumerate() {
            stop.check()?;
            let is_whole = points.len() == problem.vary.len() * WIDTH && rows.len() == wanted * WIDTH;
            if blocks.balance >= 0 && is_whole && blocks.solve(problem, names, (points, &mut *rows), stop) {
                continue;
            }
            for (lane, (point, row)) in points.chunks(columns).zip(rows.chunks_mut(wanted)).enumerate() {
                stop.check()?;
                match problem.solve(point, &plain, stop) {
                    Ok(()) => {
                        for ((at, name), place) in names.iter().zip(row) {
                            *place = plain.answer_at(*at, *name).unwrap_or(f64::NAN);
                        }
                    }
                    Err(Refusal::NoAnswer(why)) => {
                        row.fill(f64::NAN);
                        refused(n * WIDTH + lane, why);
                    }
                    Err(Refusal::Stopped) => return Err(Refusal::Stopped),
                }
            }
        }
        Ok(())
    }

    fn points_by_simd(&self) -> u64 {
        self.blocks.read * WIDTH as u64
    }
}
