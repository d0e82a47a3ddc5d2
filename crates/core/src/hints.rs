//! Hints on the way to an answer, read from the worked solution: principles, then formulas, then numbers.

use crate::{
    Answer, AnswerValue, Cite, Locale, Solution, Symbol, Text, printer,
    trace::{Id, Op},
};

/// Steps of a chain that are written out; of a longer one the last.
const MOST_STEPS: usize = 8;

/// Amount that a hint gives away.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum HintLevel {
    /// Reasons and sources of the steps, in words.
    Principle,
    /// The formulas, in symbols.
    Formulas,
    /// The same with their numbers, to the result.
    Numbers,
}

/// Hint on an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Hint {
    /// Lines, in the order of the working.
    pub lines: Vec<HintLine>,
    /// Number of earlier steps that are left out.
    pub earlier: usize,
}

/// Line of a hint.
#[derive(Clone, Debug, PartialEq)]
pub struct HintLine {
    /// Symbol of the result of the step; empty in a line of words.
    pub symbol: String,
    /// Reason of the step, its formula, or its numbers and its result.
    pub text: String,
    /// Source that states the formula; only beside a reason.
    pub source: String,
}

impl HintLevel {
    /// Every level, the one that gives least away first.
    pub const ALL: [HintLevel; 3] = [HintLevel::Principle, HintLevel::Formulas, HintLevel::Numbers];

    /// Name of the level.
    pub fn name(self) -> &'static str {
        match self {
            HintLevel::Principle => "Principle",
            HintLevel::Formulas => "Formulas",
            HintLevel::Numbers => "Numbers",
        }
    }
}

/// Hint on an answer of a solution. A set has the steps of its limits; an answer that is no number of the trace has those
/// of the whole solution.
pub fn hint(solution: &Solution, answer: &Answer, level: HintLevel, locale: &Locale) -> Hint {
    let limits = solution.limits_of(answer);
    let chosen: Vec<_> = match answer.value {
        AnswerValue::Number(..) => vec![answer.name],
        AnswerValue::Set(..) if !limits.is_empty() => limits.iter().map(|limit| limit.name).collect(),
        _ => solution.answers.iter().map(|known| known.name).collect(),
    };
    let working = solution.working_of(|known| chosen.contains(&known.name));
    let mut lines = Vec::new();
    let mut reasons: Vec<(&Text, Option<&Cite>)> = Vec::new();
    let mut formulas: Vec<(&Text, &str)> = Vec::new();
    for (at, step) in working.steps.iter().enumerate() {
        let written = || printer::step(&working, step, locale);
        let is_last = at + 1 == working.steps.len();
        let line = match level {
            // Steps of several rows have one reason.
            HintLevel::Principle => {
                let reason = (&step.why, step.cite.as_ref());
                if reasons.contains(&reason) {
                    continue;
                }
                reasons.push(reason);
                let source = step.cite.map_or_else(String::new, |cite| cite.render(locale));
                HintLine { symbol: String::new(), text: step.why.render(locale), source }
            }
            HintLevel::Formulas => {
                let Symbol { base, .. } = step.symbol;
                if formulas.contains(&(&step.why, base)) && !is_last {
                    continue;
                }
                formulas.push((&step.why, base));
                let written = written();
                let text = match (step.formula, written.formula.is_empty()) {
                    (None, _) => step.why.render(locale),
                    (Some(id), true) => given(&working, id, locale),
                    (Some(_), false) => written.formula,
                };
                HintLine { symbol: written.symbol, text, source: String::new() }
            }
            HintLevel::Numbers => {
                let written = written();
                let parts =
                    [written.substitution, written.result].into_iter().filter(|part| !part.is_empty());
                let text = parts.collect::<Vec<_>>().join(" = ");
                HintLine { symbol: written.symbol, text, source: String::new() }
            }
        };
        lines.push(line);
    }
    let earlier = lines.len().saturating_sub(MOST_STEPS);
    lines.drain(..earlier);
    Hint { lines, earlier }
}

/// Path of an input whose value a step takes as it is.
fn given(solution: &Solution, id: Id, locale: &Locale) -> String {
    match &solution.trace.node(id).op {
        Op::Given { path, .. } => Text::new("given: {path}").with("path", path.as_str()).render(locale),
        _ => printer::formula(solution, id, locale),
    }
}
