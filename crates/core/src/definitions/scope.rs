//! Scopes of names: the problem, those that are linked to it, and the configurations of each.

use super::{
    fields::linked_problem,
    rows::{rows, text_of},
};
use crate::{
    Record, Value,
    intern::intern,
    linked::{file_link, name_of_file},
};

/// The problem of the file itself.
pub(super) const TOP: usize = 0;

/// A problem or a configuration: what its formulas name without a prefix.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scope {
    /// Name from outside: `fan`, `weighted`, `fan.weighted`; empty for the problem of the file itself.
    pub(super) name: &'static str,
    /// The problem whose inputs it has, by its place: itself, or for a configuration the one that is changed.
    pub(super) problem: usize,
}

impl Scope {
    /// A name of this scope as it is called from outside.
    pub(super) fn outside(&self, name: &str) -> String {
        if self.name.is_empty() { name.to_owned() } else { format!("{}.{name}", self.name) }
    }

    /// The rest of a name from outside: `amplitude` of `fan.amplitude`; the whole name at the top.
    pub(super) fn inside<'n>(&self, name: &'n str) -> Option<&'n str> {
        if self.name.is_empty() { Some(name) } else { name.strip_prefix(self.name)?.strip_prefix('.') }
    }
}

/// The scopes of a problem: itself first, then those that are linked, then configurations.
pub(super) fn scopes(record: &Record) -> Vec<Scope> {
    let mut found = vec![Scope { name: "", problem: TOP }];
    linked(record, "", &mut found);
    for problem in 0..found.len() {
        for row in rows(record_of(record, &found[problem]), "configuration") {
            let name = found[problem].outside(text_of(row, "name"));
            if !found.iter().any(|scope| scope.name == name) {
                found.push(Scope { name: intern(&name), problem });
            }
        }
    }
    found
}

/// Adds the problems that are linked to the one of a name, and those linked to them.
fn linked(record: &Record, name: &str, found: &mut Vec<Scope>) {
    for (field, value) in record.fields.iter().zip(&record.values) {
        if let Some(inner) = linked_problem(value) {
            let name = if name.is_empty() { field.name } else { intern(&format!("{name}.{}", field.name)) };
            found.push(Scope { name, problem: found.len() });
            linked(inner, name, found);
        }
    }
}

/// The inputs of a problem, its definitions and questions among them.
pub(super) fn record_of<'r>(record: &'r Record, problem: &Scope) -> &'r Record {
    problem.name.split('.').filter(|name| !name.is_empty()).fold(record, |record, name| {
        match record.get(name) {
            Some(Value::Group(inner)) => inner,
            _ => record,
        }
    })
}

/// A link to a file as a name: `beam.stiffness` of `@beam.toml:stiffness`.
pub(super) fn without_file(name: &str) -> std::borrow::Cow<'_, str> {
    match file_link(name) {
        Some((file, rest)) => format!("{}.{rest}", name_of_file(file)).into(),
        None => name.into(),
    }
}
