//! Sums that are too long to be written out: their general term, and their terms with values.

use dalembert_units as units;

use super::{LONGEST_SUM, Precedence, Writer, number};
use crate::trace::{Id, Op};

impl Writer<'_> {
    /// `Σ mᵢ rᵢ cos θᵢ`, where the terms differ in their row alone.
    pub(super) fn sigma(&self, all: &[Id]) -> String {
        let sign = if self.style.ascii { "sum of" } else { "Σ" };
        let terms: Vec<String> = all.iter().map(|id| self.general(*id)).collect();
        match terms.split_first() {
            Some((first, rest)) if !self.values && rest.iter().all(|term| term == first) => {
                format!("{sign} {first}")
            }
            _ if self.values => {
                let all = self.bare(all.len() as f64);
                format!("{sign}({all})")
            }
            _ => self.bracketed(&self.terms(all)),
        }
    }

    /// A term with its innermost row replaced by the index of summation.
    fn general(&self, id: Id) -> String {
        let writer = Self { values: false, general: true, ..*self };
        if self.tightness(id) == Precedence::Sum { writer.factor(id) } else { writer.expression(id) }
    }

    /// The terms of every long sum below `id`, each with its value.
    pub(super) fn long_sums(&self, id: Id, unit: &units::Unit, out: &mut Vec<(String, String)>) {
        if let Op::Sum(all) = self.op(id)
            && all.len() > LONGEST_SUM
        {
            for id in all {
                let node = self.solution.trace.node(*id);
                let unit = if node.dim.agrees(unit.dim) { unit.clone() } else { self.unit_of_dim(node.dim) };
                out.push((
                    self.expression(*id),
                    number(self.solution.trace.without_noise(*id), &unit, self.style),
                ));
            }
            return;
        }
        for operand in self.solution.trace.operands(id) {
            self.long_sums(operand, unit, out);
        }
    }
}
