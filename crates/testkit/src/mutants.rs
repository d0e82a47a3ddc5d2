//! Mutants of formulas: each formula of a worked solution with one operation made wrongly, and whether a published answer or
//! a check notices.
//!
//! A mutant is a formula of an analysis, one place in it and a [`Mutation`]; it is tried in every case whose worked solution
//! has the formula, and solved from there with the wrong number, so that numerical methods go on with it too. It is caught if
//! one of these cases has no solution any more, or a published answer that differs, or a check that fails. A survivor is a
//! formula that nothing holds.

use std::{
    collections::BTreeMap,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::{
        Arc, Mutex,
        atomic::{AtomicBool, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    Answer, Entry, Locale, Solution, Step, Stop,
    cases::{Case, Comparison},
    mutation::{Mutant, Mutation},
    printer,
    trace::{Id, Op},
};
use dalembert_numerics::random::uniform_bits;

use crate::{
    problems::{SolvedCase, cases_of, numbers, on_all_cores, solved_cases},
    some,
};

/// Time in which a mutant is solved, or counts as caught: one that no user would wait for.
const PATIENCE: Duration = Duration::from_secs(20);

/// Number of the mutants that were judged, and what became of them.
#[derive(Clone, Debug, Default)]
pub struct Verdicts {
    /// All mutants of the analyses.
    pub all: usize,
    /// Those that were drawn.
    pub drawn: usize,
    /// Caught by a published answer that differs, or a case that has no solution any more.
    pub by_answers: usize,
    /// Caught by a check alone.
    pub by_checks: usize,
    /// Caught because the solve did not end, or panicked.
    pub by_failure: usize,
    /// Those that make an answer wrong, and nothing notices: analysis, step and what was done.
    pub survivors: Vec<String>,
    /// Those that make no answer wrong.
    pub without_effect: Vec<String>,
}

/// A formula, the place of an operation in it, and what is done wrongly.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    symbol: (&'static str, &'static str),
    formula: String,
    path: Vec<usize>,
    mutation: &'static str,
}

/// A case with its solution.
type Solved = (Case, &'static SolvedCase);

/// Occurrences of a mutant: the number of each case, and the mutant there.
type Occurrences = Vec<(usize, Mutant)>;

/// The verdict on a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Verdict {
    /// No answer is another: the step is part of the working alone, or the wrong operation gives the same answers.
    WithoutEffect,
    /// An answer is wrong, and nothing notices.
    Unnoticed,
    ByFailure,
    ByCheck,
    ByAnswer,
}

/// Judges `times` mutants of these analyses, drawn by a seed; all of them, where there are no more.
pub fn verdicts(entries: &[&'static Entry], times: u64, seed: u64) -> Verdicts {
    some(entries);
    let found = Mutex::new(Vec::new());
    on_all_cores(entries, |_, entry| {
        let (cases, mutants) = mutants_of(entry);
        let cases = Arc::new(cases);
        let mut found = found.lock().expect("no analysis panics with the list");
        found.extend(mutants.into_iter().map(|(place, at)| (*entry, cases.clone(), place, at)));
    });
    let mut found = found.into_inner().expect("no analysis panics with the list");
    found.sort_by(|(one, _, at, _), (other, _, there, _)| (one.about.id, at).cmp(&(other.about.id, there)));
    let mut drawn: Vec<usize> = (0..found.len()).collect();
    drawn.sort_by_key(|place| uniform_bits(seed, 0, *place as u64));
    drawn.truncate(usize::try_from(times).unwrap_or(usize::MAX));
    let verdicts = Mutex::new(Verdicts { all: found.len(), drawn: drawn.len(), ..Verdicts::default() });
    let watch = Watch::default();
    thread::scope(|scope| {
        scope.spawn(|| watch.run());
        on_all_cores(&drawn, |_, at| {
            let (entry, cases, place, occurrences) = &found[*at];
            let verdict = verdict(cases, occurrences, &watch);
            let mut verdicts = verdicts.lock().expect("no mutant panics with the list");
            match verdict {
                Verdict::ByAnswer => verdicts.by_answers += 1,
                Verdict::ByCheck => verdicts.by_checks += 1,
                Verdict::ByFailure => verdicts.by_failure += 1,
                Verdict::Unnoticed => verdicts.survivors.push(words(entry, cases, place, occurrences)),
                Verdict::WithoutEffect => {
                    verdicts.without_effect.push(words(entry, cases, place, occurrences));
                }
            }
        });
        watch.ended.store(true, Ordering::Relaxed);
    });
    let mut verdicts = verdicts.into_inner().expect("no mutant panics with the list");
    verdicts.survivors.sort();
    verdicts.without_effect.sort();
    verdicts
}

/// The cases of an analysis that have a solution, and its mutants.
fn mutants_of(entry: &'static Entry) -> (Vec<Solved>, BTreeMap<Place, Occurrences>) {
    let cases = cases_of(entry).into_iter().filter(|case| case.refused.is_none());
    let solved: Vec<Solved> = cases.zip(solved_cases(entry)).collect();
    let mut mutants: BTreeMap<Place, Occurrences> = BTreeMap::new();
    for (case, (_, SolvedCase { solution, .. })) in solved.iter().enumerate() {
        // A formula that a case itself gives for an input is data.
        let is_of_analysis = |step: &&Step| solution.computed.iter().all(|(_, id)| *id != step.result);
        for step in solution.steps.iter().filter(is_of_analysis) {
            let Some(root) = step.formula else { continue };
            let formula = shape(solution, root);
            let mut note = |path: Vec<usize>, at: Id| {
                for mutation in Mutation::ALL {
                    let mutant = Mutant { at, mutation };
                    if mutant.number(&solution.trace).is_none() {
                        continue;
                    }
                    let symbol = (step.symbol.base, step.symbol.of);
                    let (formula, path) = (formula.clone(), path.clone());
                    let place = Place { symbol, formula, path, mutation: mutation.name() };
                    let occurrences = mutants.entry(place).or_default();
                    // One step of a case stands for the same of its other rows.
                    if occurrences.last().is_none_or(|(last, _)| *last != case) {
                        occurrences.push((case, mutant));
                    }
                }
            };
            note(Vec::new(), step.result);
            within(solution, root, vec![0], &mut note);
        }
    }
    (solved, mutants)
}

/// Visits every operation of a formula with its path: the place of each operand, those of a sum all alike.
fn within(solution: &Solution, id: Id, path: Vec<usize>, visit: &mut dyn FnMut(Vec<usize>, Id)) {
    let is_sum = matches!(solution.trace.node(id).op, Op::Sum(_));
    for (place, operand) in solution.trace.operands(id).into_iter().enumerate() {
        let mut path = path.clone();
        path.push(if is_sum { 0 } else { place });
        within(solution, operand, path, visit);
    }
    if !solution.trace.operands(id).is_empty() {
        visit(path, id);
    }
}

/// A formula without rows, so that it is the same for each of them and for each number of terms.
fn shape(solution: &Solution, id: Id) -> String {
    let node = solution.trace.node(id);
    let operands = || solution.trace.operands(id).into_iter().map(|id| shape(solution, id));
    let symbol = |base: &str, of: &str| format!("{base}{of}");
    match &node.op {
        Op::Literal | Op::Constant(_) => format!("{:e}", node.number.size()),
        Op::Given { symbol: s, .. } => symbol(s.base, s.of),
        Op::Step(step) => symbol(solution.steps[*step].symbol.base, solution.steps[*step].symbol.of),
        Op::Sum(_) => {
            let mut terms: Vec<String> = operands().collect();
            terms.sort();
            terms.dedup();
            format!("Σ({})", terms.join(" "))
        }
        op => {
            let name = format!("{op:?}");
            let name = name.split('(').next().unwrap_or_default();
            format!("{name}({})", operands().collect::<Vec<_>>().join(" "))
        }
    }
}

/// The strongest verdict of all cases in which a mutant occurs.
fn verdict(cases: &[Solved], occurrences: &Occurrences, watch: &Watch) -> Verdict {
    let mut strongest = Verdict::WithoutEffect;
    for (case, mutant) in occurrences {
        strongest = strongest.max(in_case(&cases[*case], *mutant, watch));
        if strongest == Verdict::ByAnswer {
            break;
        }
    }
    strongest
}

fn in_case((case, right): &Solved, mutant: Mutant, watch: &Watch) -> Verdict {
    let stop = watch.begin();
    let solved = catch_unwind(AssertUnwindSafe(|| right.entry.solve_mutated(&right.record, mutant, &stop)));
    let wrong = match solved {
        _ if stop.check().is_err() => return Verdict::ByFailure,
        Err(_) => return Verdict::ByFailure,
        Ok(Err(_)) => return Verdict::ByAnswer,
        Ok(Ok(wrong)) => wrong,
    };
    let mut verdicts = case.verdicts(&wrong);
    verdicts.retain(|verdict| verdict.outcome == Comparison::Differing);
    if verdicts.iter().any(|verdict| verdict.answer != "check") {
        Verdict::ByAnswer
    } else if !verdicts.is_empty() {
        Verdict::ByCheck
    } else if are_alike(&right.solution, &wrong) {
        Verdict::WithoutEffect
    } else {
        Verdict::Unnoticed
    }
}

/// True if two solutions have the same answers, but for rounding.
fn are_alike(right: &Solution, wrong: &Solution) -> bool {
    let is_alike = |(one, other): (&Answer, &Answer)| {
        let (a, b) = (numbers(&one.value), numbers(&other.value));
        let near =
            |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + one.noise.max(other.noise);
        one.name == other.name && a.len() == b.len() && a.iter().zip(&b).all(near)
    };
    right.answers.len() == wrong.answers.len() && right.answers.iter().zip(&wrong.answers).all(is_alike)
}

/// A survivor in words, by its first case.
fn words(entry: &Entry, cases: &[Solved], place: &Place, occurrences: &Occurrences) -> String {
    let (case, mutant) = occurrences[0];
    let (case, SolvedCase { solution, .. }) = &cases[case];
    let at = match solution.trace.node(mutant.at).op {
        Op::Step(step) => solution.steps[step].formula.unwrap_or(mutant.at),
        _ => mutant.at,
    };
    let formula = printer::formula(solution, at, &Locale::english());
    let (base, of) = place.symbol;
    let count = occurrences.len();
    format!(
        "{}: step {base}{of}, {} of {formula}, in {count} cases, first {}",
        entry.about.id, place.mutation, case.name
    )
}

/// Ends solves that take too long.
#[derive(Default)]
struct Watch {
    running: Mutex<Vec<(Instant, Arc<Stop>)>>,
    ended: AtomicBool,
}

impl Watch {
    fn begin(&self) -> Arc<Stop> {
        let stop = Arc::new(Stop::new());
        let mut running = self.running.lock().expect("no panic while it is held");
        // Those that nobody else holds are over.
        running.retain(|(_, stop)| Arc::strong_count(stop) > 1);
        running.push((Instant::now(), stop.clone()));
        stop
    }

    fn run(&self) {
        while !self.ended.load(Ordering::Relaxed) {
            thread::sleep(Duration::from_millis(100));
            let running = self.running.lock().expect("no panic while it is held");
            running.iter().filter(|(since, _)| since.elapsed() > PATIENCE).for_each(|(_, stop)| stop.stop());
        }
    }
}
