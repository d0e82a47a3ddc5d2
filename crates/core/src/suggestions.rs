//! The usual questions of a problem: formulas over what its solution offers, ready to be asked.
//!
//! Two tables make them. A role (`roles`) is a physical quantity, and says under which name the analyses have it: the
//! amplitude of a harmonic motion, the frequency of that motion, the stiffness of the spring that it deflects. A rule
//! (`rules`) is a formula over roles: `{frequency}*{amplitude}` is the amplitude of the velocity. A rule is suggested
//! where every role of it has a value in the solution, where its own value is finite and not zero, and where no answer
//! has that value already.

mod roles;
mod rules;

use dalembert_units::{self as units, Dim, Style, Unit};

use self::{
    roles::ROLES,
    rules::{RULES, Rule},
};
use crate::{
    AnswerValue, Draft, Entry, FieldError, Locale, Number, Plain, Shape, Solution, Stop, Text,
    formula::{Formula, Operand, evaluate, normalised},
    gravity, printer,
    trace::{Id, Op, ROUNDING},
};

/// Relative difference below which two values are one.
const SAME: f64 = 1e-9;

/// A question that is usual for a problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Suggestion {
    /// The quantity in words, in English.
    pub label: &'static str,
    /// The key of its answer in files and on the command line.
    pub key: &'static str,
    /// The symbol in the worked solution; empty where the problem has it for another quantity.
    pub symbol: &'static str,
    /// The unit of its value.
    pub unit: &'static str,
    /// The formula over inputs and answers, by their names.
    pub formula: String,
    /// Value for these inputs, in SI.
    pub si: f64,
    /// True if the formula has a number that its user is to change: a section, a number of mounts.
    pub is_example: bool,
}

/// The words of every question, in English.
pub fn labels() -> impl Iterator<Item = &'static str> {
    RULES.iter().map(|rule| rule.label)
}

/// The usual questions of a solved problem, in the order of the table; none that an answer has the value of already.
pub fn suggestions(entry: &Entry, solution: &Solution) -> Vec<Suggestion> {
    let mut found: Vec<Suggestion> = Vec::new();
    for rule in RULES {
        let is_there = |key: &str| {
            found.iter().any(|before| before.key == key)
                || solution.answers.iter().any(|answer| answer.name.is(key))
        };
        if !is_there(rule.key) {
            found.extend(suggestion(rule, entry, solution));
        }
    }
    found
}

fn suggestion(rule: &Rule, entry: &Entry, solution: &Solution) -> Option<Suggestion> {
    let formula = written(rule.formula, entry, solution)?;
    let unit = units::unit(rule.unit).ok()?;
    let si = value(&formula, &unit, solution)?;
    let is_answered = solution.answers.iter().any(|answer| {
        let same = |other: f64| (other.abs() - si.abs()).abs() <= SAME * si.abs();
        answer.dim().agrees(unit.dim) && answer.si().is_some_and(same)
    });
    let symbol = if has_symbol(solution, rule.symbol) { "" } else { rule.symbol };
    let Rule { label, key, unit, is_example, .. } = *rule;
    (!is_answered).then_some(Suggestion { label, key, symbol, unit, formula, si, is_example })
}

/// The formula of a rule with the names that its roles have in the problem; `None` where one has none.
fn written(template: &str, entry: &Entry, solution: &Solution) -> Option<String> {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        let (role, after) = after.split_once('}')?;
        text += before;
        text += &name_of(role, entry, solution)?;
        rest = after;
    }
    Some(text + rest)
}

/// The name of a role in a problem: an input by its path, or an answer.
fn name_of(role: &str, entry: &Entry, solution: &Solution) -> Option<String> {
    if role == "gravity" {
        return Some(gravity_of(solution));
    }
    let role = ROLES.iter().find(|known| known.name == role)?;
    let dim = units::unit(role.unit).ok()?.dim;
    let names = role.of.iter().find(|(scope, _)| is_within(entry, scope)).map(|(_, names)| *names)?;
    let is_it =
        |name: &&&str| number(solution, name).is_some_and(|(si, found)| si != 0.0 && found.agrees(dim));
    names.iter().find(is_it).map(|name| (*name).to_owned())
}

/// Returns true if an analysis is in a scope: its id, its topic, its family with a stroke, or all, which is empty.
fn is_within(entry: &Entry, scope: &str) -> bool {
    let about = entry.about;
    scope.is_empty()
        || about.id == scope
        || about.topic == scope
        || scope.ends_with('/') && about.id.starts_with(scope)
}

/// The gravity that a problem states, by its path, or else the usual one.
fn gravity_of(solution: &Solution) -> String {
    let stated = solution.trace.nodes.iter().find_map(|node| match (&node.op, node.number) {
        (Op::Given { symbol, path, .. }, Number::Scalar(_)) if symbol.base == "g" => Some(path.clone()),
        _ => None,
    });
    stated
        .filter(|path| number(solution, path).is_some_and(|(_, dim)| dim.agrees(ACCELERATION)))
        .unwrap_or_else(|| format!("({})", gravity::METRIC))
}

const ACCELERATION: Dim = Dim::new(1, 0, -2, 0);

/// Value, in SI, and dimension of a name as a question reads it: the path of an input before an answer.
fn number(solution: &Solution, name: &str) -> Option<(f64, Dim)> {
    let node = |id: Id| {
        let node = solution.trace.node(id);
        match node.number {
            // What rounding leaves of a difference is zero.
            Number::Scalar(si) => Some((if si.abs() < ROUNDING * node.scale { 0.0 } else { si }, node.dim)),
            Number::Vector(_) => None,
        }
    };
    if let Some((_, id)) = solution.computed.iter().find(|(path, _)| path == name) {
        return node(*id);
    }
    let is_it = |op: &Op| matches!(op, Op::Given { path, .. } if path == name);
    if let Some(at) = solution.trace.nodes.iter().position(|node| is_it(&node.op)) {
        return node(at as Id);
    }
    match solution.answer(name)?.value {
        AnswerValue::Number(_, id) => node(id),
        _ => None,
    }
}

/// The value of a formula, in SI; `None` where it is none of that unit, not finite or zero.
fn value(text: &str, unit: &Unit, solution: &Solution) -> Option<f64> {
    let formula = Formula::parse(text, &|name| number(solution, name).is_some()).ok()?;
    let scope = |name: &str| Ok(number(solution, name).map(|(si, dim)| Operand::Number(si, dim)));
    let stop = Stop::new();
    match evaluate::<&Plain<'_>>(&formula, &scope, &Plain::new(&stop)).ok()? {
        Operand::Number(si, dim) => (dim.agrees(unit.dim) && si.is_finite() && si != 0.0).then_some(si),
        _ => None,
    }
}

/// Returns true if an input or a step has a symbol.
fn has_symbol(solution: &Solution, symbol: &str) -> bool {
    let wanted = normalised(symbol);
    let given = solution.trace.nodes.iter().filter_map(|node| match &node.op {
        Op::Given { symbol, .. } => Some(symbol),
        _ => None,
    });
    let mut all = given.chain(solution.steps.iter().map(|step| &step.symbol));
    all.any(|known| normalised(&printer::symbol(known)) == wanted)
}

impl Suggestion {
    /// Returns true if it is called so: its key, or its words in English or in the language.
    pub fn is(&self, name: &str, locale: &Locale) -> bool {
        let name = name.trim();
        name == self.key || name == self.label || name == self.title(locale)
    }

    /// The quantity in words.
    pub fn title(&self, locale: &Locale) -> String {
        Text::from(self.label).render(locale)
    }

    /// Value in its unit.
    pub fn shown(&self, style: Style) -> String {
        units::unit(self.unit)
            .map_or_else(|_| String::new(), |unit| units::write_quantity(self.si, &unit, style))
    }

    /// Asks the question in a draft, in the words of a language; the path of its row. `shape` is that of the whole problem.
    ///
    /// # Errors
    /// As [`Draft::set`].
    pub fn ask(&self, draft: &mut Draft, shape: &Shape, locale: &Locale) -> Result<String, FieldError> {
        let name = self.title(locale);
        draft.ask(shape, &name, &self.formula)?;
        let (Draft::Rows(rows), _) = draft.at(shape, "ask")? else {
            return Err(FieldError::new("ask", "is missing"));
        };
        let is_it = |row: &Draft| matches!(row, Draft::Group(parts) if parts.first() == Some(&Draft::Leaf(name.clone())));
        let row = format!("ask[{}]", rows.iter().position(is_it).unwrap_or(0) + 1);
        for (part, text) in [("unit", self.unit), ("symbol", self.symbol), ("key", self.key)] {
            draft.set(shape, &format!("{row}.{part}"), text)?;
        }
        Ok(row)
    }
}
