//! A plan on its way through a sheet: what is worked out so far.

use std::collections::BTreeMap;

use super::{
    Plan,
    names::{self, Named, Place},
    scope, value_of,
};
use crate::{Entry, Number, Record, Sheet, formula::Operand, trace::Id};

/// A plan on its way through a sheet.
pub(super) struct Working<'w, 's> {
    pub(super) plan: Plan,
    pub(super) sheet: &'s Sheet<'s>,
    pub(super) entry: &'w Entry,
    pub(super) record: Record,
    pub(super) nodes: BTreeMap<Place, Id>,
}

impl Working<'_, '_> {
    /// Node of a definition or an input.
    pub(super) fn node(&self, named: &Named) -> Option<Id> {
        self.nodes.get(&self.plan.place(named)?).copied()
    }
}

impl Plan {
    /// The inputs of a scope with the values of all formulas.
    pub(super) fn record_of(&self, scope: usize, record: &Record) -> Record {
        let problem = self.names.scopes[scope].problem;
        let mut inputs = scope::record_of(record, &self.names.scopes[problem]).clone();
        if scope != problem {
            for part in self.replacements.iter().filter(|part| part.scope == scope) {
                names::replace(&mut inputs, &part.inner, part.value.clone());
            }
            for input in self.inputs.iter().filter(|input| input.scope == scope) {
                names::write(&mut inputs, &input.inner, value_of(input));
            }
        }
        inputs
    }
}

/// The analysis of the problem of a name; `None` where a file is of linked problems alone.
pub(super) fn entry_of<'e>(entry: &'e Entry, name: &str) -> Option<&'e Entry> {
    if entry.linked().is_empty() {
        return name.is_empty().then_some(entry);
    }
    entry.linked().iter().find_map(|problem| {
        let rest = name.strip_prefix(problem.name)?;
        match rest.strip_prefix('.') {
            Some(rest) if !problem.name.is_empty() => entry_of(problem.entry, rest),
            _ if rest.is_empty() => entry_of(problem.entry, ""),
            _ => None,
        }
    })
}

/// A node of the sheet as a value in a formula.
pub(super) fn operand_at<'s>(sheet: &'s Sheet<'s>, id: Id) -> Operand<&'s Sheet<'s>> {
    let (number, dim) = {
        let solution = sheet.solution();
        let node = solution.trace.node(id);
        (node.number, node.dim)
    };
    match number {
        Number::Scalar(_) => Operand::Number(sheet.term(id), dim),
        Number::Vector(_) => Operand::Vector(sheet.vector_term(id), dim),
    }
}
