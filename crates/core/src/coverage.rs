//! Coverage of answers by checks: whether a wrong answer would be noticed, found out and not declared.
//!
//! An answer is *covered* by a check that passes, and fails once the number of the answer is wrong by
//! [`PERTURBATION`](crate::mutation::PERTURBATION) where its step finds it, with everything after that step worked again
//! from the wrong number. Two ways that rest on the answer alike do not notice, nor does a residual in which it
//! cancels, and what numerical methods were handed need not be in the trace to be followed. A check whose two sides are
//! the same tree covers nothing. An answer that is an input typed in again has nothing to be checked; one that is a
//! multiple, the inverse, the magnitude or a component of a number that is covered or typed is another form of it. An
//! answer is covered when one case of its analysis covers it, and one of several (`frequency[2]`) covers the others of
//! its name.
//!
//! Whatever is left needs a reason, in the case file of the analysis:
//!
//! ```toml
//! [uncovered]
//! "definition" = ["contact_ratio"]
//! ```

use std::collections::HashMap;

use crate::{
    AnswerValue, Check, Entry, Record, Refusal, Sides, Solution, SolveError, Stop, Text, cases, file,
    mutation::{Mutant, Mutation},
    trace::{Function, Id, Number, Op, TraceNode},
};

/// The rows of one name that are tried in each case.
const ROWS: usize = 3;

/// An answer of an analysis, and what holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Coverage {
    /// Name of the answer, without its index.
    pub answer: &'static str,
    /// Coverage of the answer by checks.
    pub status: CoverageStatus,
    /// The reason that the case file gives for an answer that nothing covers.
    pub reason: Option<Reason>,
}

/// Coverage of an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum CoverageStatus {
    /// A check that notices when it is wrong, by what it compares.
    Covered(Text),
    /// It is an input.
    Input,
    /// It is another form of a number that is covered or typed.
    Form,
    /// Nothing.
    Uncovered,
}

/// Reason for which no check covers an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reason {
    /// It is its own definition.
    Definition,
    /// It is counted, not measured.
    Count,
    /// It is a list or a set, whose numbers have no steps.
    List,
    /// A standard or an empirical rule gives it.
    Rule,
}

/// Coverage of each answer of an analysis, over all its cases. `Err` says what is wrong with its case file.
pub fn coverage(entry: &Entry, stop: &Stop) -> Result<Vec<Coverage>, String> {
    let mut found: Vec<Coverage> = Vec::new();
    for case in cases::cases(entry)?.iter().filter(|case| case.refused.is_none()) {
        let solved = case.record(entry).and_then(|record| Ok((entry.solve(&record, stop)?, record)));
        let (solution, record) = solved.map_err(|err| format!("{}: {err}", case.name))?;
        let mut tried: HashMap<&str, usize> = HashMap::new();
        let mut known = HashMap::new();
        // A question of a case is its own formula; no second method is expected of it.
        for answer in solution.answers.iter().filter(|answer| !answer.asked) {
            let at = found.iter().position(|one| one.answer == answer.name.base).unwrap_or_else(|| {
                let status = CoverageStatus::Uncovered;
                found.push(Coverage { answer: answer.name.base, status, reason: None });
                found.len() - 1
            });
            let AnswerValue::Number(_, id) = answer.value else { continue };
            let tries = tried.entry(answer.name.base).or_default();
            *tries += 1;
            if matches!(found[at].status, CoverageStatus::Covered(_)) || *tries > ROWS {
                continue;
            }
            let here = status(entry, &record, &solution, id, &mut known, stop)
                .map_err(|err| format!("{}: {err}", case.name))?;
            if rank(&here) > rank(&found[at].status) {
                found[at].status = here;
            }
        }
    }
    for (answer, reason) in reasons(entry)? {
        let one = found.iter_mut().find(|one| one.answer == answer);
        let one = one.ok_or_else(|| format!("[uncovered]: there is no answer `{answer}` in any case"))?;
        if one.reason.replace(reason).is_some() {
            return Err(format!("[uncovered]: `{answer}` appears twice"));
        }
    }
    Ok(found)
}

/// The checks of which both sides are the same tree: the same operations, down to the same inputs. They check nothing.
pub fn same_trees(solution: &Solution) -> Vec<&Check> {
    let classes = classes(solution);
    solution.checks.iter().filter(|check| is_same_tree(solution, check, &classes)).collect()
}

fn rank(status: &CoverageStatus) -> u8 {
    match status {
        CoverageStatus::Uncovered => 0,
        CoverageStatus::Form => 1,
        CoverageStatus::Input => 2,
        CoverageStatus::Covered(_) => 3,
    }
}

type Known = HashMap<usize, Option<Text>>;

fn status(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    id: Id,
    known: &mut Known,
    stop: &Stop,
) -> Result<CoverageStatus, SolveError> {
    let mut is_form = false;
    let mut at = id;
    loop {
        let node = solution.trace.node(at);
        match &node.op {
            Op::Given { .. } => {
                return Ok(if is_form { CoverageStatus::Form } else { CoverageStatus::Input });
            }
            Op::Step(step) => {
                // A step that only names what another one found is that one.
                let formula = solution.steps[*step].formula;
                let named = formula
                    .filter(|of| matches!(solution.trace.node(*of).op, Op::Step(_) | Op::Given { .. }));
                if let Some(of) = named {
                    at = of;
                    continue;
                }
                if !known.contains_key(step) {
                    known.insert(*step, noticing(entry, record, solution, *step, stop)?);
                }
                match (&known[step], formula) {
                    (Some(_), _) if is_form => return Ok(CoverageStatus::Form),
                    (Some(what), _) => return Ok(CoverageStatus::Covered(what.clone())),
                    (None, Some(formula)) => at = formula,
                    (None, None) => return Ok(CoverageStatus::Uncovered),
                }
            }
            op => match form_of(solution, op) {
                Some(of) => (at, is_form) = (of, true),
                None => return Ok(CoverageStatus::Uncovered),
            },
        }
    }
}

/// The one operand that is not a number of the formula itself, of an operation that only puts it in another form.
fn form_of(solution: &Solution, op: &Op) -> Option<Id> {
    let literal = |id: Id| matches!(solution.trace.node(id).op, Op::Literal);
    match *op {
        Op::Mul(a, b) | Op::Div(a, b) if literal(a) => Some(b),
        Op::Mul(a, b) | Op::Div(a, b) if literal(b) => Some(a),
        Op::Neg(a) | Op::Magnitude(a) | Op::Component(a, _) | Op::Call(Function::Abs, a) => Some(a),
        _ => None,
    }
}

/// Subject of the first check that passes, and fails once the result of a step is wrong.
fn noticing(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    step: usize,
    stop: &Stop,
) -> Result<Option<Text>, SolveError> {
    let mutant = Mutant { at: solution.steps[step].result, mutation: Mutation::Perturbed };
    let wrong = match entry.solve_mutated(record, mutant, stop) {
        Ok(wrong) => wrong,
        Err(SolveError::Refused(Refusal::Stopped)) => return Err(Refusal::Stopped.into()),
        // No answer is no wrong answer, but it was not a check that noticed.
        Err(_) => return Ok(None),
    };
    if wrong.checks.len() != solution.checks.len() {
        return Ok(None);
    }
    let classes = classes(solution);
    let mut pairs = solution.checks.iter().zip(&wrong.checks);
    let noticed = pairs
        .find(|(right, wrong)| right.passed && !wrong.passed && !is_same_tree(solution, right, &classes));
    Ok(noticed.map(|(check, _)| check.what.clone()))
}

fn is_same_tree(solution: &Solution, check: &Check, classes: &[u32]) -> bool {
    let class = |id: Id| classes[id as usize];
    match check.sides {
        Sides::Both(left, right) => class(left) == class(right),
        Sides::Residual(residual) => match solution.trace.node(residual).op {
            Op::Sub(left, right) => class(left) == class(right),
            _ => false,
        },
        Sides::One(_) | Sides::Plain => false,
    }
}

/// A class for each node of the trace: nodes of one class are the same tree. A step is its formula, the order of terms
/// and factors does not matter, and what a numerical method found is like nothing else.
fn classes(solution: &Solution) -> Vec<u32> {
    let mut of_key: HashMap<(u8, Vec<u64>, &str), u32> = HashMap::new();
    let mut classes: Vec<u32> = Vec::with_capacity(solution.trace.nodes.len());
    for (at, node) in solution.trace.nodes.iter().enumerate() {
        let class = |id: &Id| u64::from(classes[*id as usize]);
        let ordered = |ids: [&Id; 2]| ids.map(class).to_vec();
        let any_order = |ids: &[Id]| {
            let mut all: Vec<u64> = ids.iter().map(class).collect();
            all.sort_unstable();
            all
        };
        let key = match &node.op {
            Op::Literal => (0, vec![node.number.size().to_bits(), u64::from(is_negative(node))], ""),
            Op::Given { path, .. } => (1, Vec::new(), path.as_str()),
            Op::Step(step) => match &solution.steps[*step].formula {
                Some(formula) => {
                    classes.push(classes[*formula as usize]);
                    continue;
                }
                None => (2, vec![at as u64], ""),
            },
            Op::Add(a, b) => (3, any_order(&[*a, *b]), ""),
            Op::Sub(a, b) => (4, ordered([a, b]), ""),
            Op::Mul(a, b) => (5, any_order(&[*a, *b]), ""),
            Op::Div(a, b) => (6, ordered([a, b]), ""),
            Op::Neg(a) => (7, vec![class(a)], ""),
            Op::Power(a, n) => (8, vec![class(a), n.cast_unsigned().into()], ""),
            Op::Root(a, n) => (9, vec![class(a), u64::from(*n)], ""),
            Op::Call(function, a) => (10, vec![class(a), *function as u64], ""),
            Op::Atan2(y, x) => (11, ordered([y, x]), ""),
            Op::Sum(all) => (12, any_order(all), ""),
            Op::Dot(a, b) => (13, any_order(&[*a, *b]), ""),
            Op::Cross(a, b) => (14, ordered([a, b]), ""),
            Op::Magnitude(a) => (15, vec![class(a)], ""),
            Op::Component(a, axis) => (16, vec![class(a), u64::from(*axis)], ""),
            Op::Compose(all) => (17, all.iter().map(class).collect(), ""),
            Op::Constant(_) => (18, vec![node.number.size().to_bits(), u64::from(is_negative(node))], ""),
            Op::Raised(a, b) => (19, ordered([a, b]), ""),
            Op::Min(a, b) => (20, any_order(&[*a, *b]), ""),
            Op::Max(a, b) => (21, any_order(&[*a, *b]), ""),
        };
        let next = u32::try_from(of_key.len()).expect("a trace has fewer than 2³² nodes");
        classes.push(*of_key.entry(key).or_insert(next));
    }
    classes
}

fn is_negative(node: &TraceNode) -> bool {
    matches!(node.number, Number::Scalar(x) if x.is_sign_negative())
}

/// The reasons of a case file, by answer.
fn reasons(entry: &Entry) -> Result<Vec<(String, Reason)>, String> {
    let document = file::document(entry.about.cases).map_err(|_| "the case file cannot be read")?;
    let Some(table) = document.as_table().get("uncovered") else { return Ok(Vec::new()) };
    let table = table.as_table_like().ok_or("[uncovered] is a table of reasons")?;
    let mut all = Vec::new();
    for (name, answers) in table.iter() {
        let reason = Reason::ALL.into_iter().find(|reason| reason.name() == name);
        let reason = reason.ok_or_else(|| format!("[uncovered]: `{name}` is not a reason"))?;
        let answers = answers.as_array().ok_or_else(|| format!("[uncovered]: {name}: write a list"))?;
        for answer in answers {
            let answer = answer.as_str().ok_or_else(|| format!("[uncovered]: {name}: write names"))?;
            all.push((answer.to_owned(), reason));
        }
    }
    Ok(all)
}

impl Coverage {
    /// Returns true if a reason is stated for an answer that a check covers all the same.
    pub fn is_stale(&self) -> bool {
        self.reason.is_some() && self.status != CoverageStatus::Uncovered
    }
}

impl Reason {
    /// All of them.
    pub const ALL: [Reason; 4] = [Reason::Definition, Reason::Count, Reason::List, Reason::Rule];

    /// The name in case files.
    pub const fn name(self) -> &'static str {
        match self {
            Reason::Definition => "definition",
            Reason::Count => "count",
            Reason::List => "list",
            Reason::Rule => "rule",
        }
    }

    /// The reason in words.
    pub fn words(self) -> Text {
        Text::from(match self {
            Reason::Definition => "definition: no independent check exists",
            Reason::Count => "a count",
            Reason::List => "a list or set: its numbers have no traced steps",
            Reason::Rule => "given by a standard or an empirical rule",
        })
    }
}
