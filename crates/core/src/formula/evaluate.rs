//! The value of a formula on a worksheet: the same operations in the same order, whether they are recorded or not.

use std::ops::Range;

use dalembert_numerics::{Real, Vector};
use dalembert_units::{Dim, ReadError, Unit};

use super::{Expression, Formula, FormulaError, Function, Operator, names::missing};
use crate::{Text, Worksheet, reading, reading::of_dim};

/// A value in a formula.
pub(crate) enum Operand<W: Worksheet> {
    /// A number.
    Number(W::Num, Dim),
    /// A vector.
    Vector(W::Vec, Dim),
    /// A list, such as a mode shape, or a column.
    List(Vec<W::Num>, Dim),
}

impl<W: Worksheet> Clone for Operand<W> {
    fn clone(&self) -> Self {
        match self {
            Operand::Number(number, dim) => Operand::Number(*number, *dim),
            Operand::Vector(vector, dim) => Operand::Vector(*vector, *dim),
            Operand::List(list, dim) => Operand::List(list.clone(), *dim),
        }
    }
}

/// The value of a name; `None` where nothing has it.
pub(crate) type NameLookup<'s, W> = dyn Fn(&str) -> Result<Option<Operand<W>>, Text> + 's;

/// The value of a formula; `known` gives the names that another one, which nothing has, may have been meant as.
///
/// # Errors
/// A name that nothing has, dimensions that do not fit, a result that is not finite: with the part of the formula.
pub(crate) fn evaluate<W: Worksheet>(
    formula: &Formula,
    scope: &NameLookup<'_, W>,
    known: &dyn Fn(&str) -> Vec<String>,
    sheet: W,
) -> Result<Operand<W>, FormulaError> {
    let evaluator = Evaluator { scope, known, sheet, text: &formula.text };
    evaluator.value(&formula.root)
}

struct Evaluator<'s, W: Worksheet> {
    scope: &'s NameLookup<'s, W>,
    known: &'s dyn Fn(&str) -> Vec<String>,
    sheet: W,
    text: &'s str,
}

impl<W: Worksheet> Evaluator<'_, W> {
    fn value(&self, expression: &Expression) -> Result<Operand<W>, FormulaError> {
        match expression {
            Expression::Quantity(quantity) if quantity.unit.text.is_empty() => {
                Ok(Operand::Number(quantity.si.into(), Dim::NONE))
            }
            Expression::Quantity(quantity) => {
                let number = self.sheet.constant(quantity.si, &quantity.unit);
                Ok(Operand::Number(number, quantity.unit.dim))
            }
            Expression::Pi => Ok(Operand::Number(std::f64::consts::PI.into(), Dim::NONE)),
            Expression::Name(name, span) => self.named(name, span),
            Expression::Negative(inner) => Ok(match self.value(inner)? {
                Operand::Number(x, dim) => Operand::Number(-x, dim),
                Operand::Vector(v, dim) => Operand::Vector(-v, dim),
                Operand::List(all, dim) => Operand::List(all.into_iter().map(|x| -x).collect(), dim),
            }),
            Expression::Binary(operator, left, right, span) => {
                let found = self.binary(*operator, left, right, span)?;
                self.finite(found, span)
            }
            Expression::Call(function, arguments, span) => {
                let found = self.call(*function, arguments, span)?;
                self.finite(found, span)
            }
            Expression::Vector(components, unit, span) => self.vector(components, unit, span),
        }
    }

    /// A vector of its components. The unit goes with those that are numbers without one; a zero needs none.
    fn vector(
        &self,
        components: &[Expression],
        unit: &Unit,
        span: &Range<usize>,
    ) -> Result<Operand<W>, FormulaError> {
        let is_zero = |component: &Expression| matches!(component, Expression::Quantity(quantity) if quantity.unit.text.is_empty() && quantity.si == 0.0);
        let mut found: [W::Num; 3] = [0.0.into(); 3];
        let mut of: Option<Operand<W>> = None;
        for (place, component) in
            found.iter_mut().zip(components).filter(|(_, component)| !is_zero(component))
        {
            let (number, dim) = match (component, self.value(component)?) {
                (Expression::Quantity(quantity), Operand::Number(..)) if quantity.unit.text.is_empty() => {
                    (self.sheet.constant(unit.si(quantity.si), unit), unit.dim)
                }
                (_, Operand::Number(x, dim)) if dim == Dim::NONE && unit.dim != Dim::NONE => {
                    (x * self.sheet.constant(unit.si(1.0), unit), unit.dim)
                }
                (_, Operand::Number(x, dim)) => (x, dim),
                _ => return Err(self.mixed(span)),
            };
            *place = number;
            let number = Operand::Number(number, dim);
            if let Some(before) = &of {
                self.same_dim(before, &number, span)?;
            }
            of.get_or_insert(number);
        }
        let [x, y, z] = found;
        let dim = of.map_or(unit.dim, |of| of.dim());
        Ok(Operand::Vector(W::Vec::from_components(x, y, z), dim))
    }

    fn named(&self, name: &str, span: &Range<usize>) -> Result<Operand<W>, FormulaError> {
        let fail = |why: Text| FormulaError { why, span: Some(span.clone()) };
        if let Some(found) = (self.scope)(name).map_err(fail)? {
            return Ok(found);
        }
        // The x component of a vector.
        if let Some((whole, axis)) = name.rsplit_once(['.', '_'])
            && let Some(axis) = ["x", "y", "z"].iter().position(|known| *known == axis)
            && let Some(Operand::Vector(vector, dim)) = (self.scope)(whole).map_err(fail)?
        {
            return Ok(Operand::Number(vector.components()[axis], dim));
        }
        match dalembert_units::unit(name) {
            Ok(unit) => {
                let si = unit.si(1.0);
                Ok(Operand::Number(self.sheet.constant(si, &unit), unit.dim))
            }
            Err(_) => Err(fail(missing(name, &(self.known)(name)))),
        }
    }

    fn finite(&self, operand: Operand<W>, span: &Range<usize>) -> Result<Operand<W>, FormulaError> {
        let is_finite = match &operand {
            Operand::Number(x, _) => x.value().is_finite(),
            Operand::Vector(v, _) => v.value().iter().all(|x| x.is_finite()),
            Operand::List(all, _) => all.iter().all(|x| x.value().is_finite()),
        };
        if is_finite {
            return Ok(operand);
        }
        let why = Text::new("`{text}` has no finite value with these numbers");
        Err(FormulaError::at(span.clone(), why.with("text", self.part(span))))
    }

    fn part(&self, span: &Range<usize>) -> &str {
        self.text.get(span.clone()).unwrap_or(self.text)
    }

    fn binary(
        &self,
        operator: Operator,
        left: &Expression,
        right: &Expression,
        span: &Range<usize>,
    ) -> Result<Operand<W>, FormulaError> {
        use Operand::{List, Number, Vector};
        if operator == Operator::Power {
            return self.power(left, right, span);
        }
        let (a, b) = (self.value(left)?, self.value(right)?);
        if matches!(operator, Operator::Add | Operator::Subtract) {
            let dim = self.same_dim(&a, &b, span)?;
            let minus = operator == Operator::Subtract;
            return match (a, b) {
                (Number(a, _), Number(b, _)) => Ok(Number(if minus { a - b } else { a + b }, dim)),
                (Vector(a, _), Vector(b, _)) => Ok(Vector(if minus { a - b } else { a + b }, dim)),
                _ => Err(self.mixed(span)),
            };
        }
        if operator == Operator::Divide
            && let Number(divisor, _) = &b
            && divisor.value() == 0.0
        {
            let why = Text::new("`{text}` divides by zero: write another divisor");
            return Err(FormulaError::at(span.clone(), why.with("text", self.part(span))));
        }
        Ok(match (operator, a, b) {
            (Operator::Multiply, Number(a, p), Number(b, q)) => Number(a * b, p * q),
            (Operator::Multiply, Number(a, p), Vector(v, q))
            | (Operator::Multiply, Vector(v, q), Number(a, p)) => Vector(v * a, p * q),
            (Operator::Multiply, Number(a, p), List(all, q))
            | (Operator::Multiply, List(all, q), Number(a, p)) => {
                List(all.into_iter().map(|x| x * a).collect(), p * q)
            }
            (Operator::Divide, Number(a, p), Number(b, q)) => Number(a / b, p / q),
            (Operator::Divide, Vector(v, p), Number(b, q)) => Vector(v / b, p / q),
            (Operator::Divide, List(all, p), Number(b, q)) => {
                List(all.into_iter().map(|x| x / b).collect(), p / q)
            }
            _ => return Err(self.mixed(span)),
        })
    }

    fn power(
        &self,
        base: &Expression,
        exponent: &Expression,
        span: &Range<usize>,
    ) -> Result<Operand<W>, FormulaError> {
        let (Operand::Number(base, dim), Operand::Number(power, of_power)) =
            (self.value(base)?, self.value(exponent)?)
        else {
            return Err(self.mixed(span));
        };
        if !of_power.agrees(Dim::NONE) {
            let why = Text::new("an exponent is a number without a unit; that of `{text}` is {found}");
            let why = why.with("text", self.part(span)).with_text("found", of_dim(of_power));
            return Err(FormulaError::at(span.clone(), why));
        }
        let n = power.value();
        let Some(raised) = dim.powf(n) else {
            let why = Text::new("{found} to the power {power} is not a quantity");
            let why = why.with_text("found", of_dim(dim)).with("power", n);
            return Err(FormulaError::at(span.clone(), why));
        };
        // A constant whole exponent, or a root, is written as such.
        let is_constant = matches!(exponent, Expression::Quantity(_) | Expression::Negative(_));
        let value = if is_constant && n == n.trunc() && n.abs() <= f64::from(i8::MAX) {
            base.powi(n as i8)
        } else if is_constant && n == 0.5 {
            base.sqrt()
        } else {
            base.pow(power)
        };
        Ok(Operand::Number(value, raised))
    }

    fn call(
        &self,
        function: Function,
        arguments: &[Expression],
        span: &Range<usize>,
    ) -> Result<Operand<W>, FormulaError> {
        let values = arguments.iter().map(|argument| self.value(argument)).collect::<Result<Vec<_>, _>>()?;
        match function {
            Function::Norm | Function::Dot | Function::Cross => {
                return self.of_vectors(function, &values, span);
            }
            Function::Sum | Function::Mean | Function::Maximum | Function::Minimum => {
                return self.of_list(function, values, span);
            }
            Function::Choose => return self.chosen(values, span),
            _ => {}
        }
        let mut numbers = Vec::new();
        for value in &values {
            match value {
                Operand::Number(x, dim) => numbers.push((*x, *dim)),
                // |F| of a vector.
                Operand::Vector(v, dim) if function == Function::Abs => {
                    return Ok(Operand::Number(v.magnitude(), *dim));
                }
                _ => return Err(self.mixed(span)),
            }
        }
        let (x, dim) = numbers[0];
        let takes_any = matches!(
            function,
            Function::Sqrt
                | Function::Cbrt
                | Function::Abs
                | Function::Min
                | Function::Max
                | Function::Hypot
                | Function::Atan2
        );
        if !takes_any && !dim.agrees(Dim::NONE) {
            let why = Text::new("{name} is of a number without a unit or of an angle; `{text}` has {found}");
            let why = why.with("name", function.name()).with("text", self.part(span));
            return Err(FormulaError::at(span.clone(), why.with_text("found", of_dim(dim))));
        }
        let pure = |result: W::Num, of: Dim| Ok(Operand::Number(result, of));
        match function {
            Function::Sin | Function::Cos | Function::Tan => {
                if let Expression::Quantity(quantity) = &arguments[0]
                    && quantity.unit.text.is_empty()
                    && quantity.si != 0.0
                {
                    let why = Text::new(
                        "an angle needs its unit: write `{name}({number} deg)` or `{name}({number} rad)`",
                    );
                    let number = self.part(span);
                    let number =
                        number.split_once('(').map_or(number, |(_, rest)| rest.trim_end_matches(')'));
                    let why = why.with("name", function.name()).with("number", number.trim());
                    return Err(FormulaError::at(span.clone(), why));
                }
                let value = match function {
                    Function::Sin => x.sin(),
                    Function::Cos => x.cos(),
                    _ => x.tan(),
                };
                pure(value, Dim::NONE)
            }
            Function::Asin | Function::Acos if x.value().abs() > 1.0 => {
                let why = Text::new("`{text}` has no value: a sine or cosine is between −1 and 1");
                Err(FormulaError::at(span.clone(), why.with("text", self.part(span))))
            }
            Function::Asin => pure(x.asin(), Dim::ANGLE),
            Function::Acos => pure(x.acos(), Dim::ANGLE),
            Function::Atan => pure(x.atan2(1.0.into()), Dim::ANGLE),
            Function::Sinh => pure(x.sinh(), Dim::NONE),
            Function::Cosh => pure(x.cosh(), Dim::NONE),
            Function::Tanh => pure(x.tanh(), Dim::NONE),
            Function::Exp => pure(x.exp(), Dim::NONE),
            Function::Ln => pure(x.ln(), Dim::NONE),
            Function::Log10 => pure(x.log10(), Dim::NONE),
            Function::Sqrt | Function::Cbrt => {
                let order = if function == Function::Sqrt { 2 } else { 3 };
                let Some(root) = dim.root(order) else {
                    let why = Text::new("{found} has no such root: `{text}`");
                    let why = why.with_text("found", of_dim(dim)).with("text", self.part(span));
                    return Err(FormulaError::at(span.clone(), why));
                };
                Ok(Operand::Number(x.root(order), root))
            }
            Function::Abs => Ok(Operand::Number(x.abs(), dim)),
            Function::Min | Function::Max => {
                let mut least = x;
                for pair in values.windows(2) {
                    self.same_dim(&pair[0], &pair[1], span)?;
                }
                for (other, _) in &numbers[1..] {
                    least = if function == Function::Min { least.min(*other) } else { least.max(*other) };
                }
                Ok(Operand::Number(least, dim))
            }
            Function::Hypot => {
                for pair in values.windows(2) {
                    self.same_dim(&pair[0], &pair[1], span)?;
                }
                let squares = numbers.iter().map(|(x, _)| x.powi(2));
                Ok(Operand::Number(W::Num::sum(squares).sqrt(), dim))
            }
            Function::Atan2 => {
                self.same_dim(&values[0], &values[1], span)?;
                Ok(Operand::Number(x.atan2(numbers[1].0), Dim::ANGLE))
            }
            Function::Norm
            | Function::Dot
            | Function::Cross
            | Function::Sum
            | Function::Mean
            | Function::Maximum
            | Function::Minimum
            | Function::Choose => Err(self.mixed(span)),
        }
    }

    /// Of the arguments behind the first one, that whose number the first one is.
    fn chosen(&self, values: Vec<Operand<W>>, span: &Range<usize>) -> Result<Operand<W>, FormulaError> {
        let count = values.len() - 1;
        for pair in values[1..].windows(2) {
            self.same_dim(&pair[0], &pair[1], span)?;
        }
        let number = match &values[0] {
            Operand::Number(x, dim) if dim.agrees(Dim::NONE) => x.value(),
            _ => f64::NAN,
        };
        if number.fract() == 0.0 && (1.0..=count as f64).contains(&number) {
            values.into_iter().nth(number as usize).ok_or_else(|| self.mixed(span))
        } else {
            let why = Text::new(
                "`{text}`: the first argument is the number of one of the others, from 1 to {count}",
            );
            Err(FormulaError::at(span.clone(), why.with("text", self.part(span)).with("count", count)))
        }
    }

    fn of_vectors(
        &self,
        function: Function,
        values: &[Operand<W>],
        span: &Range<usize>,
    ) -> Result<Operand<W>, FormulaError> {
        match (function, values) {
            (Function::Norm, [Operand::Vector(v, dim)]) => Ok(Operand::Number(v.magnitude(), *dim)),
            (Function::Norm, [Operand::Number(x, dim)]) => Ok(Operand::Number(x.abs(), *dim)),
            (Function::Norm, [Operand::List(all, dim)]) => {
                Ok(Operand::Number(W::Num::sum(all.iter().map(|x| x.powi(2))).sqrt(), *dim))
            }
            (Function::Dot, [Operand::Vector(a, p), Operand::Vector(b, q)]) => {
                Ok(Operand::Number(a.dot(*b), *p * *q))
            }
            (Function::Cross, [Operand::Vector(a, p), Operand::Vector(b, q)]) => {
                Ok(Operand::Vector(a.cross(*b), *p * *q))
            }
            _ => Err(self.mixed(span)),
        }
    }

    /// Functions of the items of lists and of single numbers beside them.
    fn of_list(
        &self,
        function: Function,
        values: Vec<Operand<W>>,
        span: &Range<usize>,
    ) -> Result<Operand<W>, FormulaError> {
        for pair in values.windows(2) {
            self.same_dim(&pair[0], &pair[1], span)?;
        }
        let mut all = Vec::new();
        let mut of = Dim::NONE;
        for value in values {
            match value {
                Operand::Number(x, dim) => {
                    of = dim;
                    all.push(x);
                }
                Operand::List(list, dim) => {
                    of = dim;
                    all.extend(list);
                }
                Operand::Vector(..) => return Err(self.mixed(span)),
            }
        }
        let Some((&first, rest)) = all.split_first() else {
            let why = Text::new("`{text}` is of an empty list").with("text", self.part(span));
            return Err(FormulaError::at(span.clone(), why));
        };
        let value = match function {
            Function::Maximum => rest.iter().fold(first, |most, x| most.max(*x)),
            Function::Minimum => rest.iter().fold(first, |least, x| least.min(*x)),
            Function::Mean => W::Num::sum(all.iter().copied()) / all.len() as f64,
            _ => W::Num::sum(all.iter().copied()),
        };
        Ok(Operand::Number(value, of))
    }

    fn same_dim(&self, a: &Operand<W>, b: &Operand<W>, span: &Range<usize>) -> Result<Dim, FormulaError> {
        let (left, right) = (a.dim(), b.dim());
        if left.agrees(right) {
            return Ok(left);
        }
        // `5 lb + 3 lbf`
        if let Err(error @ ReadError::Sum { .. }) = dalembert_units::read_any(self.part(span))
            && let ReadError::Sum { repairs, .. } = &error
            && !repairs.is_empty()
        {
            return Err(FormulaError::at(span.clone(), reading::text(&error)));
        }
        let why =
            Text::new("`{text}` compares or adds {left} and {right}: both must be the same kind of quantity");
        let why = why.with("text", self.part(span)).with_text("left", of_dim(left));
        Err(FormulaError::at(span.clone(), why.with_text("right", of_dim(right))))
    }

    fn mixed(&self, span: &Range<usize>) -> FormulaError {
        let why = Text::new("`{text}` mixes numbers, vectors or lists in a way that has no meaning");
        FormulaError::at(span.clone(), why.with("text", self.part(span)))
    }
}

impl<W: Worksheet> Operand<W> {
    /// Dimension of the value.
    pub(crate) fn dim(&self) -> Dim {
        match self {
            Operand::Number(_, dim) | Operand::Vector(_, dim) | Operand::List(_, dim) => *dim,
        }
    }
}

/// The unit that a result of a dimension is shown in: that of the first part of its formula that has it, else the usual
/// SI unit.
pub(crate) fn unit_of(formula: &Formula, dim: Dim, unit_of_name: &dyn Fn(&str) -> Option<Unit>) -> Unit {
    let mut found = None;
    first_unit(&formula.root, dim, unit_of_name, &mut found);
    found.unwrap_or_else(|| crate::printer::si_unit(without_angle(dim)))
}

/// The dimension of a product in which an angle drops out: m e ω² is a force. Angles, rates of angles and quantities
/// per angle keep theirs.
fn without_angle(dim: Dim) -> Dim {
    if dim.angle > 0 && (dim.length, dim.mass) != (0, 0) { Dim { angle: 0, ..dim } } else { dim }
}

fn first_unit(
    expression: &Expression,
    dim: Dim,
    unit_of_name: &dyn Fn(&str) -> Option<Unit>,
    found: &mut Option<Unit>,
) {
    if found.is_some() {
        return;
    }
    let mut take = |unit: Unit| {
        if unit.dim == dim && dim != Dim::NONE {
            *found = Some(unit);
        }
    };
    match expression {
        Expression::Quantity(quantity) => take(quantity.unit.clone()),
        Expression::Pi => {}
        Expression::Name(name, _) => {
            if let Some(unit) = unit_of_name(name).or_else(|| dalembert_units::unit(name).ok()) {
                take(unit);
            }
        }
        Expression::Negative(inner) => first_unit(inner, dim, unit_of_name, found),
        Expression::Binary(Operator::Power, base, ..) => first_unit(base, dim, unit_of_name, found),
        Expression::Binary(_, left, right, _) => {
            first_unit(left, dim, unit_of_name, found);
            first_unit(right, dim, unit_of_name, found);
        }
        Expression::Vector(components, unit, _) => {
            take(unit.clone());
            for component in components {
                first_unit(component, dim, unit_of_name, found);
            }
        }
        Expression::Call(_, arguments, _) => {
            for argument in arguments {
                first_unit(argument, dim, unit_of_name, found);
            }
        }
    }
}
