//! The usual questions of a problem: formulas over what its solution offers, ready to be asked.
//!
//! Two tables make them. A role (`roles`) is a physical quantity, and says under which name the analyses have it: the
//! amplitude of a harmonic motion, the frequency of that motion, the stiffness of the spring that it deflects. A rule
//! (`rules`) is a formula over roles: `{frequency}*{amplitude}` is the amplitude of the velocity. A rule is suggested
//! where every role of it has a value in the solution, where its own value is finite and not zero, and where no answer
//! has that value already.

mod roles;
mod rules;

use dalembert_units::{self as units, Dim, Style, Unit, UnitSystem};

use self::{
    roles::ROLES,
    rules::{RULES, Rule},
};
use crate::{
    AnswerValue, Draft, Entry, FieldError, Locale, Number, Plain, Shape, Solution, Stop, Text,
    draft::join,
    formula::{Formula, Operand, evaluate, normalised},
    gravity, printer,
    trace::{Id, Op, ROUNDING},
    unit_system,
};

/// Relative difference below which two values are one.
const SAME: f64 = 1e-9;

/// A question that is usual for a problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Suggestion {
    /// Name of the linked problem that it is a question of; empty where there is one problem alone.
    pub problem: &'static str,
    /// The quantity in words, in English.
    pub label: &'static str,
    /// The key of its answer within its problem.
    pub key: &'static str,
    /// The symbol in the worked solution; empty where the problem has it for another quantity.
    pub symbol: &'static str,
    /// The unit of its value, in the system that the solution is shown in.
    pub unit: &'static str,
    /// The formula over inputs and answers, by their names within the problem.
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

/// The usual questions of a solved problem, in the order of the table, of linked problems one after the other; none that an
/// answer has the value of already. A problem of another file has its questions there.
pub fn suggestions(entry: &Entry, solution: &Solution) -> Vec<Suggestion> {
    let of = |name, entry| SolvedProblem { name, entry, solution }.suggestions();
    if entry.linked().is_empty() {
        return of("", entry);
    }
    let own = entry.linked().iter().filter(|problem| problem.file.is_none());
    own.flat_map(|problem| of(problem.name, problem.entry)).collect()
}

/// One of the problems of a solution.
#[derive(Clone, Copy)]
struct SolvedProblem<'s> {
    /// Name before its inputs and answers; empty where there is one problem alone.
    name: &'static str,
    entry: &'s Entry,
    solution: &'s Solution,
}

impl SolvedProblem<'_> {
    fn suggestions(self) -> Vec<Suggestion> {
        let mut found: Vec<Suggestion> = Vec::new();
        for rule in RULES {
            let is_there = |key: &str| {
                found.iter().any(|before| before.key == key)
                    || self.solution.answers.iter().any(|answer| answer.name.is(&join(self.name, key)))
            };
            if !is_there(rule.key) {
                found.extend(self.suggestion(rule));
            }
        }
        found
    }

    fn suggestion(self, rule: &Rule) -> Option<Suggestion> {
        let formula = self.written(rule.formula)?;
        let unit = units::unit(rule.unit).ok()?;
        let si = self.value(&formula, &unit)?;
        let is_answered = self.solution.answers.iter().any(|answer| {
            let same = |other: f64| (other.abs() - si.abs()).abs() <= SAME * si.abs();
            answer.problem == self.name && answer.dim().agrees(unit.dim) && answer.si().is_some_and(same)
        });
        let symbol = if self.has_symbol(rule.symbol) { "" } else { rule.symbol };
        let Rule { label, key, unit, is_example, .. } = *rule;
        let unit = self.solution.units.map_or(unit, |units| unit_system::of_text(unit, units.system));
        let problem = self.name;
        (!is_answered).then_some(Suggestion { problem, label, key, symbol, unit, formula, si, is_example })
    }

    /// The formula of a rule with the names that its roles have in the problem; `None` where one has none.
    fn written(self, template: &str) -> Option<String> {
        let mut text = String::new();
        let mut rest = template;
        while let Some((before, after)) = rest.split_once('{') {
            let (role, after) = after.split_once('}')?;
            text += before;
            text += &self.name_of(role)?;
            rest = after;
        }
        Some(text + rest)
    }

    /// The name of a role in the problem: an input by its path, or an answer.
    fn name_of(self, role: &str) -> Option<String> {
        if role == "gravity" {
            return Some(self.gravity());
        }
        let role = ROLES.iter().find(|known| known.name == role)?;
        let dim = units::unit(role.unit).ok()?.dim;
        let names =
            role.of.iter().find(|(scope, _)| is_within(self.entry, scope)).map(|(_, names)| *names)?;
        let is_it =
            |name: &&&str| self.number(name).is_some_and(|(si, found)| si != 0.0 && found.agrees(dim));
        names.iter().find(is_it).map(|name| (*name).to_owned())
    }

    /// The gravity that the problem states, by its path, or else the usual one.
    fn gravity(self) -> String {
        let stated = self.solution.trace.nodes.iter().find_map(|node| match (&node.op, node.number) {
            (Op::Given { symbol, path, .. }, Number::Scalar(_)) if symbol.base == "g" => self.inside(path),
            _ => None,
        });
        let is_acceleration =
            |path: &&str| self.number(path).is_some_and(|(_, dim)| dim.agrees(ACCELERATION));
        let usual = match self.solution.units.map(|units| units.system) {
            Some(UnitSystem::InchPound | UnitSystem::FootSlug) => gravity::CUSTOMARY,
            _ => gravity::METRIC,
        };
        stated.filter(is_acceleration).map_or_else(|| format!("({usual})"), str::to_owned)
    }

    /// A name from outside as it is within the problem; `None` where it is of another one.
    fn inside(self, name: &str) -> Option<&str> {
        if self.name.is_empty() { Some(name) } else { name.strip_prefix(self.name)?.strip_prefix('.') }
    }

    /// Value, in SI, and dimension of a name as a question reads it: the path of an input before an answer.
    fn number(self, name: &str) -> Option<(f64, Dim)> {
        let (solution, name) = (self.solution, &join(self.name, name));
        let node = |id: Id| {
            let node = solution.trace.node(id);
            match node.number {
                // What rounding leaves of a difference is zero.
                Number::Scalar(si) => {
                    Some((if si.abs() < ROUNDING * node.scale { 0.0 } else { si }, node.dim))
                }
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
    fn value(self, text: &str, unit: &Unit) -> Option<f64> {
        let formula = Formula::parse(text, &|name| self.number(name).is_some()).ok()?;
        let scope = |name: &str| Ok(self.number(name).map(|(si, dim)| Operand::Number(si, dim)));
        let stop = Stop::new();
        match evaluate::<&Plain<'_>>(&formula, &scope, &|_| Vec::new(), &Plain::new(&stop)).ok()? {
            Operand::Number(si, dim) => (dim.agrees(unit.dim) && si.is_finite() && si != 0.0).then_some(si),
            _ => None,
        }
    }

    /// Returns true if an input or a step of the problem has a symbol.
    fn has_symbol(self, symbol: &str) -> bool {
        let (wanted, solution) = (normalised(symbol), self.solution);
        let given = solution.trace.nodes.iter().filter_map(|node| match &node.op {
            Op::Given { symbol, path, .. } => self.inside(path).map(|_| symbol),
            _ => None,
        });
        let is_own = |n: &usize| {
            let of = solution.problems.iter().find(|problem| problem.steps.contains(n));
            of.is_none_or(|problem| problem.name == self.name)
        };
        let steps = (0..solution.steps.len()).filter(is_own).map(|n| &solution.steps[n].symbol);
        given.chain(steps).any(|known| normalised(&printer::symbol(known)) == wanted)
    }
}

/// Returns true if an analysis is in a scope: its id, its topic, its family with a stroke, or all, which is empty.
fn is_within(entry: &Entry, scope: &str) -> bool {
    let about = entry.about;
    scope.is_empty()
        || about.id == scope
        || about.topic == scope
        || scope.ends_with('/') && about.id.starts_with(scope)
}

const ACCELERATION: Dim = Dim::new(1, 0, -2, 0);

impl Suggestion {
    /// Key from outside, in files and on the command line: `fan.rms_velocity`.
    pub fn name(&self) -> String {
        join(self.problem, self.key)
    }

    /// Returns true if it is called so: its key, or its words in English or in the language.
    pub fn is(&self, name: &str, locale: &Locale) -> bool {
        let name = name.trim();
        let is_words = self.problem.is_empty() && name == self.label;
        name == self.name() || is_words || name == self.title(locale)
    }

    /// The quantity in words, behind the name of its problem where that is linked.
    pub fn title(&self, locale: &Locale) -> String {
        match self.problem {
            "" => self.words(locale),
            problem => format!("{problem}: {}", self.words(locale)),
        }
    }

    fn words(&self, locale: &Locale) -> String {
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
        let (name, list) = (self.words(locale), join(self.problem, "ask"));
        draft.ask(shape, &join(self.problem, &name), &self.formula)?;
        let (Draft::Rows(rows), _) = draft.at(shape, &list)? else {
            return Err(FieldError::new(list, "is missing"));
        };
        let is_it = |row: &Draft| matches!(row, Draft::Group(parts) if parts.first() == Some(&Draft::Leaf(name.clone())));
        let row = format!("{list}[{}]", rows.iter().position(is_it).unwrap_or(0) + 1);
        for (part, text) in [("unit", self.unit), ("symbol", self.symbol), ("key", self.key)] {
            draft.set(shape, &format!("{row}.{part}"), text)?;
        }
        Ok(row)
    }
}
