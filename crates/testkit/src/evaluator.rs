//! A small evaluator of printed substitutions, which knows nothing of the printer.

use dalembert_core::{Number, printer::WrittenStep};
use dalembert_units::{self as units, Dim};

/// Compares a substitution with the result, within what the rounding of the shown numbers permits.
pub(crate) fn hold(
    written: &WrittenStep,
    result: Number,
    dim: Dim,
    digits: u8,
    noise: f64,
) -> Result<(), String> {
    let found = evaluate(&written.substitution, &written.terms, digits)?;
    let wanted = match result {
        Number::Scalar(x) => [x, 0.0, 0.0],
        Number::Vector(v) => v,
    };
    let size_wanted = size(wanted);
    // Zero has every dimension.
    if size_wanted != 0.0 && size(found.number) != 0.0 && !found.dim.agrees(dim) {
        return Err(format!("it is in {}, not in {dim}", found.dim));
    }
    // The numbers are rounded as they are shown; the arithmetic on the way rounds to 16 digits.
    let tolerance = found.error + 1e-13 * size_wanted + noise;
    let off = distance(found.number, wanted);
    if off.is_nan() || off > tolerance {
        return Err(format!(
            "it gives {:?}, {off:e} away from {wanted:?}; rounding explains {tolerance:e}",
            found.number
        ));
    }
    Ok(())
}

fn size([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    size([a[0] - b[0], a[1] - b[1], a[2] - b[2]])
}

/// A number (in the first component) or a vector in SI, with the largest error that rounding what is shown can make.
#[derive(Clone, Copy, Debug)]
struct Value {
    number: [f64; 3],
    vector: bool,
    dim: Dim,
    error: f64,
}

impl Value {
    fn scalar(number: f64, dim: Dim, error: f64) -> Self {
        Self { number: [number, 0.0, 0.0], vector: false, dim, error }
    }

    fn times(self, other: Self) -> Self {
        let (factor, of) = match (self.vector, other.vector) {
            (false, _) => (self, other),
            (true, false) => (other, self),
            (true, true) => return self.cross(other),
        };
        let number = of.number.map(|x| x * factor.number[0]);
        Self { number, vector: of.vector, dim: self.dim * other.dim, error: self.product_error(other) }
    }

    fn product_error(self, other: Self) -> f64 {
        size(self.number) * other.error + size(other.number) * self.error + self.error * other.error
    }

    fn over(self, other: Self) -> Result<Self, String> {
        if other.vector || other.number[0] == 0.0 {
            return Err("divided by a vector or by zero".into());
        }
        let by = other.number[0];
        let least = (by.abs() - other.error).max(0.0);
        let number = self.number.map(|x| x / by);
        let error = (self.error + size(number) * other.error) / least;
        Ok(Self { number, vector: self.vector, dim: self.dim / other.dim, error })
    }

    fn plus(self, other: Self, sign: f64) -> Result<Self, String> {
        let zero = |value: &Self| size(value.number) == 0.0;
        if !zero(&self) && !zero(&other) && (!self.dim.agrees(other.dim) || self.vector != other.vector) {
            return Err(format!("a sum of {} and {}", self.dim, other.dim));
        }
        let [a, b] = [self.number, other.number];
        let number = [a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]];
        let dim = if zero(&self) { other.dim } else { self.dim };
        // Where nearly equal numbers are subtracted, the arithmetic itself is rounded.
        let error = self.error + other.error + 2.0 * f64::EPSILON * (size(a) + size(b));
        Ok(Self { number, vector: self.vector || other.vector, dim, error })
    }

    fn dot(self, other: Self) -> Self {
        let [a, b] = [self.number, other.number];
        let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let rounding = 4.0 * f64::EPSILON * size(a) * size(b);
        Self::scalar(dot, self.dim * other.dim, self.product_error(other) + rounding)
    }

    fn cross(self, other: Self) -> Self {
        let [a, b] = [self.number, other.number];
        let number = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let rounding = 4.0 * f64::EPSILON * size(a) * size(b);
        Self { number, vector: true, dim: self.dim * other.dim, error: self.product_error(other) + rounding }
    }

    /// A function of a number; the error is how far it moves when the number moves by its own.
    fn map(self, dim: Dim, domain: (f64, f64), f: impl Fn(f64) -> f64) -> Result<Self, String> {
        if self.vector {
            return Err("a function of a vector".into());
        }
        let x = self.number[0];
        let at = |x: f64| f(x.clamp(domain.0, domain.1));
        let error = (at(x + self.error) - at(x)).abs().max((at(x - self.error) - at(x)).abs());
        // Near the top of a curve both sides move little.
        Ok(Self::scalar(at(x), dim, error + self.error * self.error + 4.0 * f64::EPSILON * at(x).abs()))
    }

    fn power(self, n: i32) -> Result<Self, String> {
        let dim = self.dim.powi(i8::try_from(n).map_err(|_| "a power too high")?);
        self.map(dim, (f64::NEG_INFINITY, f64::INFINITY), |x| x.powi(n))
    }

    /// A positive number to the power of any other.
    fn power_of(self, exponent: &Self) -> Result<Self, String> {
        if self.dim != Dim::NONE || exponent.dim != Dim::NONE {
            return Err(format!("{} to the power of {}", self.dim, exponent.dim));
        }
        let error = self.number[0].powf(exponent.number[0]) * self.number[0].ln().abs() * exponent.error;
        let mut power = self.map(Dim::NONE, (0.0, f64::INFINITY), |x| x.powf(exponent.number[0]))?;
        power.error += error;
        Ok(power)
    }

    fn root(self, n: u8) -> Result<Self, String> {
        let dim = self.dim.root(n).ok_or_else(|| format!("root {n} of {}", self.dim))?;
        let even = n.is_multiple_of(2);
        let lowest = if even { 0.0 } else { f64::NEG_INFINITY };
        if even && self.number[0] < -self.error {
            return Err(format!("root {n} of {}", self.number[0]));
        }
        self.map(dim, (lowest, f64::INFINITY), |x| x.abs().powf(1.0 / f64::from(n)).copysign(x))
    }
}

/// The value of a printed substitution. `terms` are those of its long sums, in their order.
fn evaluate(text: &str, terms: &[(String, String)], digits: u8) -> Result<Value, String> {
    let mut reader = Reader { rest: text, terms, digits };
    let value = reader.sum()?;
    reader.blanks();
    if reader.rest.is_empty() { Ok(value) } else { Err(format!("`{}` is left over", reader.rest)) }
}

struct Reader<'t> {
    rest: &'t str,
    terms: &'t [(String, String)],
    digits: u8,
}

impl<'t> Reader<'t> {
    fn blanks(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn eat(&mut self, what: &str) -> bool {
        match self.rest.strip_prefix(what) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn expect(&mut self, what: &str) -> Result<(), String> {
        self.blanks();
        if self.eat(what) { Ok(()) } else { Err(format!("`{what}` should stand before `{}`", self.rest)) }
    }

    fn sum(&mut self) -> Result<Value, String> {
        self.blanks();
        let negative = self.eat("−") || self.eat("-");
        let mut sum = self.product()?;
        if negative {
            sum.number = sum.number.map(|x| -x);
        }
        loop {
            if self.eat(" + ") {
                sum = sum.plus(self.product()?, 1.0)?;
            } else if self.eat(" − ") || self.eat(" - ") {
                sum = sum.plus(self.product()?, -1.0)?;
            } else {
                return Ok(sum);
            }
        }
    }

    /// Factors; a direction behind them makes a vector.
    fn product(&mut self) -> Result<Value, String> {
        let mut product = self.factor()?;
        loop {
            if self.eat(" × ") || self.eat(" * ") || self.eat(" ×") {
                product = product.times(self.factor()?);
            } else if self.eat(" · ") {
                product = product.dot(self.factor()?);
            } else if self.eat(" / ") {
                product = product.over(self.factor()?)?;
            } else if let Some(direction) = self.rest.strip_prefix(' ').and_then(direction) {
                self.rest = &self.rest[2..];
                product = product.times(direction);
            } else {
                return Ok(product);
            }
        }
    }

    fn factor(&mut self) -> Result<Value, String> {
        let base = self.base()?;
        let power: String = self.rest.chars().map_while(superscript).collect();
        if !power.is_empty() {
            self.rest =
                &self.rest[self.rest.char_indices().nth(power.len()).map_or(self.rest.len(), |(at, _)| at)..];
            return base.power(power.parse().map_err(|_| "no power")?);
        }
        if self.eat("^(") {
            let exponent = self.sum()?;
            self.expect(")")?;
            return base.power_of(&exponent);
        }
        if self.eat("^") {
            let digits: usize = self.rest.chars().take_while(|c| *c == '-' || c.is_ascii_digit()).count();
            let (power, rest) = self.rest.split_at(digits);
            self.rest = rest;
            return base.power(power.parse().map_err(|_| "no power")?);
        }
        Ok(base)
    }

    fn base(&mut self) -> Result<Value, String> {
        const ANY: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);
        self.blanks();
        if let Some(direction) = direction(self.rest) {
            self.rest = &self.rest[1..];
            return Ok(direction);
        }
        if self.eat("π") || self.eat("pi") {
            return Ok(Value::scalar(std::f64::consts::PI, Dim::NONE, 0.0));
        }
        if self.eat("|") {
            let inner = self.sum()?;
            self.expect("|")?;
            let error = inner.error;
            return Ok(Value::scalar(size(inner.number), inner.dim, error));
        }
        if let Some(n) = self.root() {
            return self.base()?.root(n);
        }
        for (name, domain, f) in [
            ("arcsin", (-1.0, 1.0), f64::asin as fn(f64) -> f64),
            ("arccos", (-1.0, 1.0), f64::acos),
            ("sin", ANY, f64::sin),
            ("cos", ANY, f64::cos),
            ("tan", ANY, f64::tan),
            ("exp", ANY, f64::exp),
            ("ln", (f64::MIN_POSITIVE, f64::INFINITY), f64::ln),
        ] {
            if self.eat(&format!("{name}(")) {
                let of = self.sum()?;
                self.expect(")")?;
                if !of.dim.agrees(Dim::NONE) {
                    return Err(format!("{name} of a number in {}", of.dim));
                }
                return of.map(if name.starts_with("arc") { Dim::ANGLE } else { Dim::NONE }, domain, f);
            }
        }
        if self.eat("atan2(") {
            let y = self.sum()?;
            self.expect(",")?;
            let x = self.sum()?;
            self.expect(")")?;
            let (y_value, x_value) = (y.number[0], x.number[0]);
            let error = y.error.hypot(x.error) / y_value.hypot(x_value) + 4.0 * f64::EPSILON;
            return Ok(Value::scalar(y_value.atan2(x_value), Dim::ANGLE, error));
        }
        if self.eat("Σ(") || self.eat("sum of(") {
            return self.long_sum();
        }
        if self.eat("(") {
            let inner = self.sum()?;
            self.expect(")")?;
            let value = self.with_component(inner);
            return self.with_unit(value);
        }
        self.quantity()
    }

    /// `√`, `³√`, `sqrt`, `root3`
    fn root(&mut self) -> Option<u8> {
        if self.eat("√") || (self.rest.starts_with("sqrt(") && self.eat("sqrt")) {
            return Some(2);
        }
        let order: String = self.rest.chars().map_while(superscript).collect();
        if !order.is_empty() {
            let (at, _) = self.rest.char_indices().nth(order.len())?;
            let rest = self.rest[at..].strip_prefix('√')?;
            self.rest = rest;
            return order.parse().ok();
        }
        let rest = self.rest.strip_prefix("root")?;
        let at = rest.find('(')?;
        let order = rest[..at].parse().ok()?;
        self.rest = &rest[at..];
        Some(order)
    }

    /// The terms of a sum that is too long for a line stand in a table beside it.
    fn long_sum(&mut self) -> Result<Value, String> {
        let count: usize = self.number_text()?.parse().map_err(|_| "no count of terms")?;
        self.expect(")")?;
        if count > self.terms.len() {
            return Err(format!("{count} terms of {}", self.terms.len()));
        }
        let (mine, others) = self.terms.split_at(count);
        self.terms = others;
        let mut sum: Option<Value> = None;
        for (_, value) in mine {
            let term = evaluate(value, &[], self.digits)?;
            sum = Some(match sum {
                None => term,
                Some(sum) => sum.plus(term, 1.0)?,
            });
        }
        sum.ok_or_else(|| "a sum of nothing".into())
    }

    /// `(…)_x`
    fn with_component(&mut self, value: Value) -> Value {
        for (n, axis) in ["_x", "_y", "_z"].into_iter().enumerate() {
            if self.eat(axis) {
                return Value::scalar(value.number[n], value.dim, value.error);
            }
        }
        value
    }

    /// The unit behind the brackets of a vector.
    fn with_unit(&mut self, value: Value) -> Result<Value, String> {
        let rest = self.rest.strip_prefix(' ').unwrap_or(self.rest);
        let text = unit_text(rest);
        if text.is_empty() || direction(rest).is_some() {
            return Ok(value);
        }
        let unit = units::unit(text).map_err(|err| err.to_string())?;
        self.rest = &rest[text.len()..];
        Ok(value.times(Value::scalar(unit.factor, unit.dim, 0.0)))
    }

    /// A number with its unit, if it has one.
    fn quantity(&mut self) -> Result<Value, String> {
        let number = self.number_text()?;
        let rest = self.rest.strip_prefix(' ').unwrap_or(self.rest);
        let unit = match direction(rest) {
            Some(_) => "",
            None if rest.starts_with("pi") => "",
            None => unit_text(rest),
        };
        if !unit.is_empty() {
            self.rest = &rest[unit.len()..];
        }
        if let Some(rest) = self.rest.strip_prefix('π').or_else(|| self.rest.strip_prefix(" pi")) {
            // `2π` and `4 pi^2` are numbers of the formula itself.
            let squared = rest.strip_prefix('²').or_else(|| rest.strip_prefix("^2"));
            self.rest = squared.unwrap_or(rest);
            let factor: f64 = number.parse().map_err(|_| "no factor of π")?;
            let pi = std::f64::consts::PI;
            return Ok(Value::scalar(factor * if squared.is_some() { pi * pi } else { pi }, Dim::NONE, 0.0));
        }
        let quantity = units::read_any(&format!("{number} {unit}")).map_err(|err| err.to_string())?;
        let error = 5.0 * 10f64.powi(-i32::from(self.digits)) * quantity.si.abs();
        Ok(Value::scalar(quantity.si, quantity.unit.dim, error))
    }

    /// `0.5`, `0,5`, `1.3×10⁻⁶`, `1.3e-6`
    fn number_text(&mut self) -> Result<&'t str, String> {
        let mut end = 0;
        let bytes = self.rest.as_bytes();
        let digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
        while digit(end) || (end > 0 && matches!(bytes.get(end), Some(b'.' | b',')) && digit(end + 1)) {
            end += 1;
        }
        if end == 0 {
            return Err(format!("a number should stand at `{}`", self.rest));
        }
        if bytes.get(end) == Some(&b'e') {
            let sign = usize::from(bytes.get(end + 1) == Some(&b'-'));
            if digit(end + 1 + sign) {
                end += 1 + sign;
                while digit(end) {
                    end += 1;
                }
            }
        } else if let Some(power) = self.rest[end..].strip_prefix("×10") {
            end += "×10".len()
                + power.chars().map_while(|c| superscript(c).map(|_| c.len_utf8())).sum::<usize>();
        }
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        Ok(number)
    }
}

/// A unit vector, as long as nothing follows that would make it a word.
fn direction(text: &str) -> Option<Value> {
    let axis = ["i", "j", "k"].iter().position(|axis| text.starts_with(axis))?;
    if text[1..].starts_with(|c: char| c.is_alphanumeric() || matches!(c, '/' | '·' | '*' | '^')) {
        return None;
    }
    let mut number = [0.0; 3];
    number[axis] = 1.0;
    Some(Value { number, vector: true, dim: Dim::NONE, error: 0.0 })
}

/// The unit at the beginning of a text: `kN/mm²`, `1/(rad·s)`, `mm rms`.
fn unit_text(text: &str) -> &str {
    if !text.starts_with(|c: char| c.is_alphabetic() || matches!(c, '°' | '%' | 'µ' | '‰' | '1' | '\'' | '"'))
    {
        return "";
    }
    let mut depth = 0;
    let end = text
        .char_indices()
        .find(|(_, c)| {
            match c {
                '(' => depth += 1,
                ')' => depth -= 1,
                _ => {}
            }
            depth < 0 || *c == ' ' || *c == ',' || *c == '|'
        })
        .map_or(text.len(), |(at, _)| at);
    let suffixed = ["rms", "pp", "peak"].into_iter().find_map(|suffix| {
        let rest = text[end..].strip_prefix(' ')?.strip_prefix(suffix)?;
        (!rest.starts_with(char::is_alphanumeric)).then_some(end + 1 + suffix.len())
    });
    &text[..suffixed.unwrap_or(end)]
}

fn superscript(c: char) -> Option<char> {
    let plain = "⁰0¹1²2³3⁴4⁵5⁶6⁷7⁸8⁹9⁻-".chars().collect::<Vec<_>>();
    plain.chunks(2).find(|pair| pair[0] == c).map(|pair| pair[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_evaluator_reads_what_a_user_would() {
        let value = |text: &str| match evaluate(text, &[], 15).map(|value| value.number) {
            Ok([x, 0.0, 0.0]) => x,
            other => panic!("{text}: {other:?}"),
        };
        for (text, expected) in [
            ("3 × 200 kN/mm² × 1.3×10⁻⁶ m⁴ / (1.2 m)³", 451388.888888889),
            ("√(451.39 kN/m / 40 kg)", 106.229703943859),
            ("−(2 m − 5 m) × 2", 6.0),
            ("8 / (2 × 2)", 2.0),
            ("|−3 N|", 3.0),
            ("atan2(1,5 N, −1,5 N)", 2.35619449019),
            ("2 × cos(60°) + 1 kg × 0", 1.0),
            ("³√(8 m³)", 2.0),
            ("root3(8 m^3) * 2^3", 16.0),
            ("sqrt(1.3e-6 m^4)", 0.00114017542510),
            ("((300 i + 200 j) m/s) · (2 N i)", 600.0),
            ("|(3 i) m × (4 j) N|", 12.0),
            ("2π × 3 rad/s", 18.8495559215),
            ("4 pi^2 * 2 + 0", 78.9568352087),
        ] {
            let found = value(text);
            assert!((found - expected).abs() <= 1e-11 * expected.abs(), "{text} = {found}, not {expected}");
        }
        for wrong in ["2 +", "(3 m", "5 m 6", "foo(3)", "3 m + 2 kg"] {
            assert!(evaluate(wrong, &[], 15).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_wrong_result_is_found_out() {
        let written = |substitution: &str| WrittenStep {
            symbol: "k".into(),
            formula: String::new(),
            substitution: substitution.into(),
            result: String::new(),
            why: String::new(),
            source: String::new(),
            terms: Vec::new(),
        };
        let step = written("3 × 200 kN/mm² × 1.3×10⁻⁶ m⁴ / (1.2 m)³");
        let dim = units::unit("N/m").unwrap().dim;
        let right = 451388.8888888889;
        assert_eq!(hold(&step, Number::Scalar(right), dim, 15, 0.0), Ok(()));
        assert!(hold(&step, Number::Scalar(right * (1.0 + 1e-9)), dim, 15, 0.0).is_err());
        assert!(hold(&step, Number::Scalar(right * 1.001), dim, 5, 0.0).is_err());
        assert!(hold(&step, Number::Scalar(right), units::unit("N").unwrap().dim, 15, 0.0).is_err());
    }
}
