//! Turns in formulas: frequencies in cycles, `f = ω/(2π)`.

use dalembert_units::{self as units, Style};

use super::Writer;
use crate::{
    Solution, Step, Symbol,
    trace::{Id, Op},
};

/// Returns true if a step is a frequency f in cycles and its formula one of the angular frequency: it is written
/// `f = ω/(2π)`, though the number of the trace is that of ω.
pub fn is_in_cycles(solution: &Solution, step: &Step) -> bool {
    let writer = Writer { solution, values: false, general: false, radians: false, style: Style::default() };
    step.formula.is_some_and(|id| writer.is_cyclic_step(step, id))
}

impl Writer<'_> {
    /// Returns true if a step is a frequency f in cycles of which the formula gives the angular frequency: `f = ω/(2π)`.
    /// A formula over other frequencies in cycles needs no 2π.
    fn is_cyclic_step(&self, step: &Step, id: Id) -> bool {
        let is_cyclic = |symbol: &Symbol, unit: &units::Unit| {
            let hertz = units::unit("Hz").unwrap_or(units::Unit::ONE);
            symbol.base.starts_with(['f', 'ν']) && unit.dim == hertz.dim && unit.si(1.0) != 1.0
        };
        let is_over_cycles = |operand: Id| match self.op(operand) {
            Op::Given { symbol, unit, .. } => is_cyclic(symbol, unit),
            Op::Step(step) => {
                let step = &self.solution.steps[*step];
                is_cyclic(&step.symbol, &step.unit)
            }
            _ => false,
        };
        is_cyclic(&step.symbol, &step.unit) && !self.any_below(id, &is_over_cycles)
    }

    /// The unit in which the result of a step is read off a calculator: an angular frequency in hertz is one in radians
    /// per second, unless its formula is of others in the same unit.
    pub(super) fn unit_of_result(&self, step: &Step) -> units::Unit {
        let has_unit = |operand| self.unit_of(operand).is_some_and(|unit| unit.text == step.unit.text);
        let is_angular = step.symbol.base.starts_with(['ω', 'Ω']) && step.unit.text.ends_with("Hz");
        match step.formula {
            Some(id) if is_angular && !self.any_below(id, &has_unit) => self.unit_of_dim(step.unit.dim),
            _ => step.unit.clone(),
        }
    }

    /// Returns true if a formula has such an operand.
    fn any_below(&self, id: Id, is: &dyn Fn(Id) -> bool) -> bool {
        is(id) || self.solution.trace.operands(id).into_iter().any(|operand| self.any_below(operand, is))
    }

    /// A formula over 2π.
    pub(super) fn over_a_turn(&self, id: Id) -> String {
        if matches!(self.op(id), Op::Add(..) | Op::Sub(..) | Op::Sum(_)) {
            return format!("{} / ({})", self.factor(id), self.bare(std::f64::consts::TAU));
        }
        let (product, negative) = self.product(id, false, true);
        format!("{}{product}", self.sign(true, negative))
    }
}
