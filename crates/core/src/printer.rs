//! Writes what a solution found as a user would: formulas with their symbols, the same with their values.

mod answer;
mod constants;
mod products;
mod sums;
mod turns;

use dalembert_units::{self as units, Style};

use self::constants::{Constant, has_factor};
pub use turns::is_in_cycles;

use crate::{
    Locale, Solution, Step, Symbol,
    trace::{Function, Id, Number, Op},
};

/// A step as it is read: `symbol = formula = substitution = result`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenStep {
    /// `k`
    pub symbol: String,
    /// `3 E I / L³`; empty where a numerical method found the number.
    pub formula: String,
    /// `3 × 200 kN/mm² × 1.3×10⁻⁶ m⁴ / (1.2 m)³`; empty where it would repeat the result.
    pub substitution: String,
    /// `451.39 kN/m`
    pub result: String,
    /// Reason of the step.
    pub why: String,
    /// Source that states the formula.
    pub source: String,
    /// The terms of a sum that is too long for a line, each with its value.
    pub terms: Vec<(String, String)>,
}

impl WrittenStep {
    /// The step with every text of it changed.
    #[must_use]
    pub fn map(&self, change: &impl Fn(&str) -> String) -> Self {
        Self {
            symbol: change(&self.symbol),
            formula: change(&self.formula),
            substitution: change(&self.substitution),
            result: change(&self.result),
            why: change(&self.why),
            source: change(&self.source),
            terms: self.terms.iter().map(|(term, value)| (change(term), change(value))).collect(),
        }
    }
}

/// The longest sum that is written out.
const LONGEST_SUM: usize = 4;

/// A step as it is read.
pub fn step(solution: &Solution, step: &Step, locale: &Locale) -> WrittenStep {
    let writer = |values| Writer { solution, values, general: false, radians: false, style: locale.style };
    let in_cycles = is_in_cycles(solution, step);
    let unit = writer(false).unit_of_result(step);
    let written =
        |writer: Writer<'_>, id| if in_cycles { writer.over_a_turn(id) } else { writer.expression(id) };
    let (formula, mut substitution, mut terms) = (
        step.formula.map_or_else(String::new, |id| written(writer(false), id)),
        step.formula.map_or_else(String::new, |id| {
            let radians = in_cycles || writer(true).needs_radians(id, &unit);
            written(Writer { radians, ..writer(true) }, id)
        }),
        Vec::new(),
    );
    let result = number(solution.trace.without_noise(step.result), &unit, locale.style);
    if let Some(id) = step.formula {
        writer(false).long_sums(id, &unit, &mut terms);
    }
    if substitution == result {
        substitution.clear();
    }
    let symbol = symbol_in(&step.symbol, locale.style);
    WrittenStep {
        // An input that is another quantity of the same symbol.
        formula: if formula == symbol { String::new() } else { formula },
        symbol,
        substitution,
        result,
        why: step.why.render(locale),
        source: step.cite.map_or_else(String::new, |cite| cite.render(locale)),
        terms,
    }
}

/// Another number in place of the result of a step, written as that is.
pub fn in_place_of_result(solution: &Solution, step: &Step, other: Number, style: Style) -> String {
    let writer = Writer { solution, values: false, general: false, radians: false, style };
    number(other, &writer.unit_of_result(step), style)
}

/// A number of the trace as a formula of symbols.
pub fn formula(solution: &Solution, id: Id, locale: &Locale) -> String {
    Writer { solution, values: false, general: false, radians: false, style: locale.style }.expression(id)
}

/// A symbol with its rows: `m₁`, `I_G₂`.
pub fn symbol(symbol: &Symbol) -> String {
    symbol_in(symbol, Style::default())
}

/// A symbol in the characters of a style.
pub fn symbol_in(symbol: &Symbol, style: Style) -> String {
    let mut text = symbol.base.to_owned();
    if !symbol.of.is_empty() {
        text.push('_');
        text += symbol.of;
    }
    for (n, row) in symbol.rows.iter().take_while(|row| **row != 0).enumerate() {
        if n > 0 {
            text.push(',');
        }
        match (*row, style.ascii) {
            (SUMMED, false) => text.push('ᵢ'),
            (SUMMED, true) => text.push_str("_i"),
            (row, false) => text += &units::subscript(row.into()),
            (row, true) => text += &row.to_string(),
        }
    }
    text
}

/// The name of a function.
pub fn function(function: Function) -> &'static str {
    match function {
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Asin => "arcsin",
        Function::Acos => "arccos",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Log10 => "log10",
        Function::Sinh => "sinh",
        Function::Cosh => "cosh",
        Function::Tanh => "tanh",
        Function::Abs => "abs",
    }
}

/// A number or vector in SI, in `unit`.
pub fn number(value: Number, unit: &units::Unit, style: Style) -> String {
    match value {
        Number::Scalar(si) => units::write_quantity(si, unit, style),
        Number::Vector(si) => units::write_vector(si, unit, style),
    }
}

/// The row index that stands for all rows, in the general term of a long sum.
const SUMMED: u16 = u16::MAX;

#[derive(Clone, Copy)]
struct Writer<'s> {
    solution: &'s Solution,
    /// True if values are written in place of symbols.
    values: bool,
    /// True if the innermost row of a symbol is written as the index of a sum.
    general: bool,
    /// True if values that contain an angle are written in radians, as formulas take them.
    radians: bool,
    style: Style,
}

/// Operator precedence of a text, which decides on brackets.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Factor,
}

impl<'s> Writer<'s> {
    fn op(&self, id: Id) -> &'s Op {
        &self.solution.trace.node(id).op
    }

    fn value(&self, id: Id) -> Number {
        self.solution.trace.node(id).number
    }

    fn times(&self) -> &'static str {
        match (self.values, self.style.ascii) {
            (false, _) => " ",
            (true, false) => " × ",
            (true, true) => " * ",
        }
    }

    /// Factors one after another; between two numbers stands a sign, as in `4 × 210 N/mm`.
    fn joined(&self, factors: &[String]) -> String {
        let is_number = |factor: &str| factor.starts_with(|c: char| c.is_ascii_digit());
        let mut text = String::new();
        let mut after_number = false;
        for factor in factors {
            let both = after_number && is_number(factor);
            text += match (text.is_empty(), both, self.style.ascii) {
                (true, ..) => "",
                (false, true, false) => " × ",
                (false, true, true) => " * ",
                (false, false, _) => self.times(),
            };
            text += factor;
            after_number = is_number(factor);
        }
        text
    }

    /// Sign before a term of a sum.
    fn sign(&self, first: bool, negative: bool) -> &'static str {
        match (first, negative, self.style.ascii) {
            (true, false, _) => "",
            (true, true, false) => "−",
            (true, true, true) => "-",
            (false, false, _) => " + ",
            (false, true, false) => " − ",
            (false, true, true) => " - ",
        }
    }

    /// A sum, its terms in the order they were added.
    fn expression(&self, id: Id) -> String {
        let addends = self.terms(&[id]);
        // A vector by its components needs brackets only beside something else.
        if let [(only, false)] = addends[..]
            && let Op::Compose(parts) = self.op(only)
        {
            return self.components(*parts);
        }
        self.sum(&addends)
    }

    /// The terms of numbers that are added up, each with its sign, without those that are literally zero.
    fn terms(&self, of: &[Id]) -> Vec<(Id, bool)> {
        let mut addends = Vec::new();
        for id in of {
            self.addends(*id, false, &mut addends);
        }
        let first = addends.first().copied();
        addends.retain(|(id, _)| !self.is_nothing(*id));
        if addends.is_empty() {
            addends.extend(first);
        }
        addends
    }

    /// A sum as a factor.
    fn bracketed(&self, addends: &[(Id, bool)]) -> String {
        match addends {
            [(only, false)] => self.factor(*only),
            several => format!("({})", self.sum(several)),
        }
    }

    fn sum(&self, addends: &[(Id, bool)]) -> String {
        let mut text = String::new();
        for &(id, negative) in addends {
            // A negative value needs no brackets where nothing stands before it.
            if text.is_empty() && !negative && self.is_negative(id) && self.unit_of(id).is_some() {
                text = self.named(id);
                continue;
            }
            let (product, negative) = self.signed_product(id, negative);
            text += self.sign(text.is_empty(), negative);
            text += &product;
        }
        text
    }

    fn addends(&self, id: Id, negative: bool, out: &mut Vec<(Id, bool)>) {
        match self.op(id) {
            Op::Add(a, b) => {
                self.addends(*a, negative, out);
                self.addends(*b, negative, out);
            }
            Op::Sub(a, b) => {
                self.addends(*a, negative, out);
                self.addends(*b, !negative, out);
            }
            Op::Neg(a) => self.addends(*a, !negative, out),
            Op::Sum(all) if all.len() <= LONGEST_SUM => {
                for id in all {
                    self.addends(*id, negative, out);
                }
            }
            _ => out.push((id, negative)),
        }
    }

    /// A factor that stands alone between plus and minus signs: it needs no brackets.
    fn alone(&self, id: Id) -> String {
        match self.op(id) {
            Op::Given { .. } | Op::Step(_) if self.values && !self.is_negative(id) => self.named(id),
            Op::Cross(a, b) => format!("{} × {}", self.operand(*a), self.operand(*b)),
            Op::Dot(a, b) => format!("{} · {}", self.operand(*a), self.operand(*b)),
            _ => self.factor(id),
        }
    }

    fn factor(&self, id: Id) -> String {
        match self.op(id) {
            Op::Literal => self.literal(id),
            Op::Constant(unit) => {
                let text = number(self.value(id), unit, self.style);
                if self.value(id).size() > 0.0 && text.starts_with(['-', '−']) {
                    format!("({text})")
                } else {
                    text
                }
            }
            Op::Given { .. } | Op::Step(_) if self.is_negative(id) => format!("({})", self.named(id)),
            Op::Given { .. } | Op::Step(_) => self.named(id),
            Op::Power(base, n) => format!("{}{}", self.base(*base), self.power(*n)),
            Op::Root(of, n) => {
                let sign = match (*n, self.style.ascii) {
                    (2, false) => "√".to_owned(),
                    (2, true) => "sqrt".to_owned(),
                    (n, false) => format!("{}√", units::superscript(n.into())),
                    (n, true) => format!("root{n}"),
                };
                format!(
                    "{sign}{}",
                    if self.style.ascii { format!("({})", self.expression(*of)) } else { self.base(*of) }
                )
            }
            Op::Call(Function::Abs, of) | Op::Magnitude(of) => format!("|{}|", self.expression(*of)),
            Op::Call(name, of) => format!("{}{}", function(*name), self.argument(*of)),
            Op::Atan2(y, x) => format!("atan2({}, {})", self.expression(*y), self.expression(*x)),
            Op::Raised(base, exponent) => format!("{}^({})", self.base(*base), self.expression(*exponent)),
            Op::Min(a, b) => format!("min({}, {})", self.expression(*a), self.expression(*b)),
            Op::Max(a, b) => format!("max({}, {})", self.expression(*a), self.expression(*b)),
            Op::Sum(all) if all.len() > LONGEST_SUM => self.sigma(all),
            Op::Dot(a, b) => format!("({} · {})", self.operand(*a), self.operand(*b)),
            Op::Cross(a, b) => format!("({} × {})", self.operand(*a), self.operand(*b)),
            Op::Component(of, axis) => self.component(*of, *axis),
            Op::Compose(parts) => format!("({})", self.components(*parts)),
            Op::Add(..) | Op::Sub(..) | Op::Sum(_) => self.bracketed(&self.terms(&[id])),
            Op::Neg(_) | Op::Mul(..) | Op::Div(..) => format!("({})", self.expression(id)),
        }
    }

    /// An operand of a vector product: brackets round everything but a name and its multiples.
    fn operand(&self, id: Id) -> String {
        match self.op(id) {
            Op::Mul(..) | Op::Div(..) => format!("({})", self.expression(id)),
            _ => self.factor(id),
        }
    }

    fn literal(&self, id: Id) -> String {
        match self.value(id) {
            Number::Scalar(value) => match Constant::of(value.abs()) {
                Some(constant) if constant.denominator != 1 => {
                    format!("({} / {})", constant.numerator(self.style, self.times()), constant.denominator)
                }
                _ => self.bare(value.abs()),
            },
            Number::Vector(value) => match value {
                [1.0, 0.0, 0.0] => "i".into(),
                [0.0, 1.0, 0.0] => "j".into(),
                [0.0, 0.0, 1.0] => "k".into(),
                value => units::write_vector(value, &units::Unit::ONE, self.style),
            },
        }
    }

    /// A number of a formula that is no fraction.
    fn bare(&self, value: f64) -> String {
        match Constant::of(value) {
            Some(constant) if constant.denominator == 1 => constant.numerator(self.style, self.times()),
            // The numbers of a formula are exact: as many digits as it takes.
            _ => units::write_number(value, Style { digits: 15, ..self.style }),
        }
    }

    /// The symbol, or the value in the unit it was typed or found in.
    fn named(&self, id: Id) -> String {
        let (symbol, unit) = match self.op(id) {
            Op::Given { symbol, unit, .. } => (symbol, unit),
            Op::Step(step) => (&self.solution.steps[*step].symbol, &self.solution.steps[*step].unit),
            _ => unreachable!("only inputs and steps have names"),
        };
        if self.values {
            return number(self.solution.trace.without_noise(id), &self.written_in(unit), self.style);
        }
        let mut symbol = *symbol;
        if self.general
            && let Some(innermost) = symbol.rows.iter_mut().rev().find(|row| **row != 0)
        {
            *innermost = SUMMED;
        }
        symbol_in(&symbol, self.style)
    }

    /// Returns true if a reader's calculator gives the result only where angles are in radians: `31.416 rad/s × 0.1 m`,
    /// not `300 rpm × 0.1 m`. It does not matter where all values and the result share one unit, or the result is a
    /// ratio.
    fn needs_radians(&self, id: Id, result: &units::Unit) -> bool {
        let mut units = Vec::new();
        self.units_below(id, &mut units);
        let shared = |unit: &&units::Unit| result.dim == units::Dim::NONE || unit.text == result.text;
        let alone = matches!(self.op(id), Op::Given { .. } | Op::Step(_));
        !alone && !units.iter().all(|unit| unit.text == units[0].text && shared(unit))
    }

    /// The units of the values of a formula that have any. What a function is of decides for itself.
    fn units_below(&self, id: Id, out: &mut Vec<&'s units::Unit>) {
        if let Some(unit) = self.unit_of(id).filter(|unit| unit.dim != units::Dim::NONE) {
            out.push(unit);
        }
        let inner = match self.op(id) {
            Op::Call(function, _) if *function != Function::Abs => Vec::new(),
            Op::Atan2(..) => Vec::new(),
            Op::Raised(base, _) => vec![*base],
            _ => self.solution.trace.operands(id),
        };
        for operand in inner {
            self.units_below(operand, out);
        }
    }

    /// The unit of a value as it was typed or found in, or the one of the system that has radians in its place.
    fn written_in(&self, unit: &units::Unit) -> units::Unit {
        if self.radians && unit.dim.angle != 0 && !unit.is_decimal() {
            self.unit_of_dim(unit.dim)
        } else {
            unit.clone()
        }
    }

    /// The coherent unit of a dimension, in the system of the solution.
    fn unit_of_dim(&self, dim: units::Dim) -> units::Unit {
        self.solution.units.map_or_else(|| si_unit(dim), |shown| shown.system.of_dim(dim))
    }

    fn unit_of(&self, id: Id) -> Option<&'s units::Unit> {
        match self.op(id) {
            Op::Given { unit, .. } => Some(unit),
            Op::Step(step) => Some(&self.solution.steps[*step].unit),
            _ => None,
        }
    }

    fn is_negative(&self, id: Id) -> bool {
        self.values && matches!(self.solution.trace.without_noise(id), Number::Scalar(value) if value < 0.0)
    }

    fn base(&self, id: Id) -> String {
        let bare = match self.op(id) {
            Op::Literal => true,
            Op::Given { .. } | Op::Step(_) => {
                !self.values
                    || (!self.is_negative(id)
                        && self.unit_of(id).is_some_and(|unit| unit.pretty().is_empty()))
            }
            _ => false,
        };
        match self.op(id) {
            _ if bare => {
                let text = self.factor(id);
                // 1.3×10⁻⁶, 2π and symbols of several letters with a power need brackets.
                let several = text.contains(['×', '*', '²', ' ']) || has_factor(&text);
                if several && !text.starts_with('(') { format!("({text})") } else { text }
            }
            // These bring brackets of their own.
            Op::Call(Function::Abs, _) | Op::Magnitude(_) => self.factor(id),
            Op::Given { .. } | Op::Step(_) if self.is_negative(id) => self.factor(id),
            _ => format!("({})", self.expression(id)),
        }
    }

    fn power(&self, n: i8) -> String {
        if self.style.ascii { format!("^{n}") } else { units::superscript(n.into()) }
    }

    /// Argument of a function, in brackets.
    fn argument(&self, id: Id) -> String {
        let mut units = Vec::new();
        self.units_below(id, &mut units);
        let writer = Self { radians: units.iter().any(|unit| unit.text != units[0].text), ..*self };
        match self.op(id) {
            Op::Given { .. } | Op::Step(_) if !self.values => format!(" {}", writer.factor(id)),
            _ => format!("({})", writer.expression(id)),
        }
    }

    fn component(&self, of: Id, axis: u8) -> String {
        let name = ["x", "y", "z"][usize::from(axis.min(2))];
        match (self.op(of), self.value(of)) {
            (Op::Given { .. } | Op::Step(_), Number::Vector(value)) if self.values => {
                let unit = self.unit_of(of).map_or(units::Unit::ONE, |unit| self.written_in(unit));
                let text = units::write_quantity(value[usize::from(axis.min(2))], &unit, self.style);
                if value[usize::from(axis.min(2))] < 0.0 { format!("({text})") } else { text }
            }
            (Op::Given { .. } | Op::Step(_), _) => format!("{}_{name}", self.named(of)),
            _ => format!("({})_{name}", self.expression(of)),
        }
    }

    /// `x i + y j + z k`, without what is literally zero.
    fn components(&self, parts: [Id; 3]) -> String {
        let mut text = String::new();
        for (id, axis) in parts.into_iter().zip(["i", "j", "k"]) {
            if matches!(self.op(id), Op::Literal) && self.value(id).size() == 0.0 {
                continue;
            }
            let (product, negative) = self.signed_product(id, false);
            let product = if self.tightness(id) == Precedence::Sum {
                format!("({})", self.expression(id))
            } else {
                product
            };
            text += self.sign(text.is_empty(), negative);
            text += &format!("{product} {axis}");
        }
        if text.is_empty() { "0".into() } else { text }
    }

    fn tightness(&self, id: Id) -> Precedence {
        match self.op(id) {
            Op::Add(..) | Op::Sub(..) => Precedence::Sum,
            Op::Sum(all) if all.len() <= LONGEST_SUM => Precedence::Sum,
            Op::Mul(..) | Op::Div(..) | Op::Neg(_) => Precedence::Product,
            _ => Precedence::Factor,
        }
    }
}

/// The SI unit of a dimension, as the field writes it.
pub(crate) fn si_unit(dim: units::Dim) -> units::Unit {
    let usual =
        units::Kind::of_dim(dim).units().first().map_or_else(|| dim.to_string(), |unit| (*unit).to_owned());
    units::unit(&usual).unwrap_or(units::Unit::ONE)
}
