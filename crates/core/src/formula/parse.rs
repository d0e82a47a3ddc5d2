//! Reading a formula.

use dalembert_units as units;

use super::{Expression, FormulaError, Function, Operator};
use crate::{
    Text,
    ascii::{index, power},
    path::nearest,
    reading,
};

/// The longest formula, in bytes.
const LONGEST: usize = 1_000;
/// The deepest nesting of brackets, roots, powers and signs.
const DEEPEST: usize = 32;

pub(super) fn parse(text: &str, is_name: &dyn Fn(&str) -> bool) -> Result<Expression, FormulaError> {
    if text.trim().is_empty() {
        return Err(FormulaError { why: "a formula is needed, for example 2*X".into(), span: None });
    }
    if text.len() > LONGEST {
        let why = Text::new("{have} characters: at most {most} are accepted");
        return Err(FormulaError { why: why.with("have", text.len()).with("most", LONGEST), span: None });
    }
    let mut parser = Parser { text, at: 0, is_name, depth: 0 };
    let root = parser.sum()?;
    parser.skip_space();
    if parser.at < text.len() { Err(parser.unexpected("an operator")) } else { Ok(root) }
}

/// Returns true if a character begins a name or a unit.
fn begins_word(c: char) -> bool {
    c.is_alphabetic() || matches!(c, '_' | '°' | '%' | '′' | '″')
}

/// Returns true if a character goes on with a name.
fn continues_word(c: char) -> bool {
    begins_word(c) || c.is_alphanumeric() || index(c).is_some()
}

/// The digit of a raised one.
fn raised(c: char) -> Option<char> {
    power(c).filter(char::is_ascii_digit)
}

struct Parser<'t> {
    text: &'t str,
    at: usize,
    is_name: &'t dyn Fn(&str) -> bool,
    depth: usize,
}

impl<'t> Parser<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn skip_space(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    /// Goes past one of these characters, if it is next after white space.
    fn eat(&mut self, wanted: &[char]) -> Option<char> {
        self.skip_space();
        let next = self.peek().filter(|next| wanted.contains(next))?;
        self.at += next.len_utf8();
        Some(next)
    }

    fn unexpected(&self, expected: &'static str) -> FormulaError {
        match self.peek() {
            Some(found) => {
                let why = Text::new("unexpected `{found}`: {expected} expected");
                let why = why.with("found", found).with_text("expected", expected);
                FormulaError::at(self.at..self.at + found.len_utf8(), why)
            }
            None => {
                let why = Text::new("`{text}` is incomplete: {expected} expected");
                let why = why.with("text", self.text.trim()).with_text("expected", expected);
                FormulaError::at(self.at..self.at, why)
            }
        }
    }

    /// One level deeper, within the limit.
    fn nested<T>(
        &mut self,
        inner: impl FnOnce(&mut Self) -> Result<T, FormulaError>,
    ) -> Result<T, FormulaError> {
        if self.depth == DEEPEST {
            let why = Text::new(
                "more than {limit} nested brackets, roots, powers and signs: write a simpler expression",
            );
            return Err(FormulaError::at(self.at..self.at, why.with("limit", DEEPEST)));
        }
        self.depth += 1;
        let found = inner(self);
        self.depth -= 1;
        found
    }

    fn sum(&mut self) -> Result<Expression, FormulaError> {
        self.skip_space();
        let start = self.at;
        let mut left = self.product()?;
        while let Some(sign) = self.eat(&['+', '-', '−']) {
            let operator = if sign == '+' { Operator::Add } else { Operator::Subtract };
            let right = self.product()?;
            left = self.binary(operator, left, right, start);
        }
        Ok(left)
    }

    fn product(&mut self) -> Result<Expression, FormulaError> {
        self.skip_space();
        let start = self.at;
        let mut left = self.signed()?;
        while let Some(sign) = self.eat(&['*', '·', '×', '/', '÷']) {
            let operator = if matches!(sign, '/' | '÷') { Operator::Divide } else { Operator::Multiply };
            let right = self.signed()?;
            left = self.binary(operator, left, right, start);
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<Expression, FormulaError> {
        match self.eat(&['-', '−', '+']) {
            Some('+') => self.nested(Self::signed),
            Some(_) => Ok(Expression::Negative(Box::new(self.nested(Self::signed)?))),
            None => self.power(),
        }
    }

    fn power(&mut self) -> Result<Expression, FormulaError> {
        self.skip_space();
        let start = self.at;
        let base = self.atom()?;
        if self.eat(&['^']).is_some() {
            let exponent = self.nested(Self::signed)?;
            return Ok(self.binary(Operator::Power, base, exponent, start));
        }
        let (minus, digits) = match self.rest().strip_prefix('⁻') {
            Some(rest) => ("-", rest),
            None => ("", self.rest()),
        };
        let exponent: String = digits.chars().map_while(raised).collect();
        if exponent.is_empty() {
            return Ok(base);
        }
        let signs = minus.len().min(1) * '⁻'.len_utf8();
        self.at += signs + digits.chars().map_while(|c| raised(c).map(|_| c.len_utf8())).sum::<usize>();
        let number = units::read_any(&format!("{minus}{exponent}"))
            .map_err(|error| FormulaError::at(start..self.at, reading::text(&error)))?;
        Ok(self.binary(Operator::Power, base, Expression::Quantity(number), start))
    }

    fn binary(&self, operator: Operator, left: Expression, right: Expression, start: usize) -> Expression {
        Expression::Binary(operator, Box::new(left), Box::new(right), start..self.at)
    }

    fn atom(&mut self) -> Result<Expression, FormulaError> {
        self.skip_space();
        let start = self.at;
        match self.peek() {
            Some('(') => {
                self.at += 1;
                let inner = self.nested(Self::sum)?;
                match self.eat(&[')', ';']) {
                    Some(')') => Ok(inner),
                    Some(_) => self.vector(inner, start),
                    None => Err(self.unexpected("a closing bracket")),
                }
            }
            Some('√') => {
                self.at += '√'.len_utf8();
                let inner = self.nested(Self::atom)?;
                Ok(Expression::Call(Function::Sqrt, vec![inner], start..self.at))
            }
            Some(c) if matches!(c, '0'..='9' | '.') || units::vulgar_fraction(c).is_some() => self.quantity(),
            Some(c) if begins_word(c) => self.word(),
            Some('@') => self.link(),
            _ => Err(self.unexpected("a number, a name or a bracket")),
        }
    }

    /// The components of a vector behind the first one, and the unit behind its brackets.
    fn vector(&mut self, first: Expression, start: usize) -> Result<Expression, FormulaError> {
        let mut components = vec![first, self.nested(Self::sum)?];
        if self.eat(&[';']).is_some() {
            components.push(self.nested(Self::sum)?);
        }
        if self.eat(&[')']).is_none() {
            return Err(self.unexpected("a closing bracket behind 2 or 3 components"));
        }
        let end = self.at;
        self.unit(end, start)?;
        let unit = self.text[end..self.at].trim();
        let unit = if unit.is_empty() { Ok(units::Unit::ONE) } else { units::unit(unit) }
            .map_err(|error| FormulaError::at(end..self.at, reading::text(&error)))?;
        Ok(Expression::Vector(components, unit, start..self.at))
    }

    /// A number and the unit directly behind it.
    fn quantity(&mut self) -> Result<Expression, FormulaError> {
        let start = self.at;
        self.number();
        if self.rest().starts_with(',') && self.rest()[1..].starts_with(|c: char| c.is_ascii_digit()) {
            let digits = self.rest()[1..].bytes().take_while(u8::is_ascii_digit).count();
            let number = &self.text[start..self.at + 1 + digits];
            // `1,000` may be a thousand.
            let why = match units::read_any(number) {
                Err(error @ units::ReadError::Ambiguous { .. }) => reading::text(&error),
                _ => "write a decimal point in formulas, and a blank after a comma between arguments: `1.5`, `max(1, 5)`".into(),
            };
            return Err(FormulaError::at(start..self.at + 1, why));
        }
        let number_end = self.at;
        self.unit(number_end, start)?;
        let text = &self.text[start..self.at];
        let quantity = units::read_any(text).map_err(|error| {
            let span = error.span().map_or(start..self.at, |span| start + span.start..start + span.end);
            FormulaError::at(span, reading::text(&error))
        })?;
        Ok(Expression::Quantity(quantity))
    }

    /// Goes past digits and groups of them, the point, and a power of ten, or a fraction such as ½.
    fn number(&mut self) {
        let start = self.at;
        let digits = |rest: &str| rest.bytes().take_while(u8::is_ascii_digit).count();
        self.at += digits(self.rest());
        while let Some(mark) = units::group_mark(&self.text[start..self.at], self.rest()) {
            self.at += mark;
            self.at += digits(self.rest());
        }
        let behind = self.rest().trim_start();
        if let Some(fraction) = behind.chars().next().filter(|c| units::vulgar_fraction(*c).is_some()) {
            self.at = self.text.len() - behind.len() + fraction.len_utf8();
            return;
        }
        if self.rest().starts_with('.') {
            self.at += 1;
            self.at += digits(self.rest());
        }
        if self.rest().starts_with(['e', 'E']) {
            let tail = &self.rest()[1..];
            let sign = usize::from(tail.starts_with(['+', '-']));
            let exponent = digits(&tail[sign..]);
            if exponent > 0 {
                self.at += 1 + sign + exponent;
            }
        }
    }

    /// Goes past the unit behind a number: words that are units, side by side or with `*`, `/` and powers between them.
    fn unit(&mut self, number_end: usize, start: usize) -> Result<(), FormulaError> {
        let mut first = true;
        loop {
            if !first && self.hyphen(number_end) {
                continue;
            }
            let end = self.at;
            let operator = if first { None } else { self.eat(&['*', '·', '/']) };
            self.skip_space();
            let from = self.at;
            let opens = operator == Some('/') && self.peek() == Some('(');
            let word = if opens { self.bracket() } else { self.unit_word() };
            let is_unit = !word.is_empty() && units::unit(word).is_ok();
            if !is_unit {
                self.at = end;
                let name = self.word_ahead(from);
                if operator.is_none() && !name.is_empty() {
                    let refusal = units::unit(name).err().filter(|_| !(self.is_name)(name));
                    let why = match refusal {
                        Some(error @ units::ReadError::SeveralUnits { .. }) => reading::text(&error),
                        Some(units::ReadError::UnknownUnit { nearest, .. }) if !nearest.is_empty() => {
                            Text::new("unknown unit `{symbol}`: did you mean {nearest}?")
                                .with("symbol", name)
                                .with("nearest", format!("`{}`", nearest[0]))
                        }
                        _ => Text::new("a word directly behind a number is a unit, and `{name}` is none: write `{number}*{name}`")
                            .with("name", name)
                            .with("number", &self.text[start..number_end]),
                    };
                    return Err(FormulaError::at(from..from + name.len(), why));
                }
                return Ok(());
            }
            // Behind a stroke stands a unit, as in 7850 kg/m^3, whatever m is. Behind a sign of multiplication it may be
            // either.
            if operator.is_some() && (opens || operator != Some('/')) {
                let names = word_parts(word);
                if let Some(name) = names.into_iter().find(|name| (self.is_name)(name)) {
                    // A unit written out, such as miles, is the name of something else here.
                    if opens || units::unit(name).is_ok_and(|unit| unit.text != name) {
                        self.at = end;
                        return Ok(());
                    }
                    let before = self.text[start..end].trim_end();
                    let (as_unit, as_name) = (format!("{before} {word}"), format!("{before}*({name})"));
                    let why = Text::new("`{text}` can be read in two ways: write `{first}` or `{second}`")
                        .with("text", &self.text[start..self.at])
                        .with("first", as_unit)
                        .with("second", as_name);
                    return Err(FormulaError::at(start..self.at, why));
                }
            }
            first = false;
        }
    }

    /// Goes past a hyphen between two units and the second of them, `25 N-m`: one of another dimension, which could not be
    /// subtracted, and no visible name.
    fn hyphen(&mut self, number_end: usize) -> bool {
        let end = self.at;
        if !self.rest().starts_with('-') {
            return false;
        }
        self.at += 1;
        let word = self.unit_word();
        let free = !word.is_empty() && !word_parts(word).into_iter().any(|name| (self.is_name)(name));
        let dim = |text: &str| units::unit(text).ok().map(|unit| unit.dim);
        let product = match (dim(&self.text[number_end..end]), dim(word)) {
            (Some(before), Some(after)) => free && !before.agrees(after),
            _ => false,
        };
        if !product {
            self.at = end;
        }
        product
    }

    /// A unit with its power, such as `mm^2`, `s⁻¹` or `in2`.
    fn unit_word(&mut self) -> &'t str {
        let from = self.at;
        let rest = self.rest();
        let word = rest.char_indices().find(|(_, c)| !(begins_word(*c) || c.is_ascii_digit() && *c != '.'));
        let length = word.map_or(rest.len(), |(at, _)| at);
        if !rest.starts_with(begins_word) {
            return "";
        }
        self.at += units::unit_of_two_words(rest).map_or(length, str::len);
        let tail = self.rest();
        if let Some(power) = tail.strip_prefix('^') {
            let sign = usize::from(power.starts_with(['-', '+']));
            let digits = power[sign..].bytes().take_while(u8::is_ascii_digit).count();
            if digits > 0 {
                self.at += 1 + sign + digits;
            }
        } else {
            let length: usize =
                tail.chars().take_while(|c| raised(*c).is_some() || *c == '⁻').map(char::len_utf8).sum();
            self.at += length;
        }
        &self.text[from..self.at]
    }

    /// The text of a bracket, its brackets included.
    fn bracket(&mut self) -> &'t str {
        let from = self.at;
        let Some(length) = self.rest().find(')') else { return "" };
        self.at += length + 1;
        &self.text[from..self.at]
    }

    /// The word at a place.
    fn word_ahead(&self, from: usize) -> &'t str {
        let rest = &self.text[from..];
        if !rest.starts_with(begins_word) {
            return "";
        }
        let end = rest.char_indices().find(|(_, c)| !continues_word(*c)).map_or(rest.len(), |(at, _)| at);
        &rest[..end]
    }

    /// A name with its path and rows: `support.stiffness`, `frequency[2]`; a function with its arguments; π.
    fn word(&mut self) -> Result<Expression, FormulaError> {
        let start = self.at;
        loop {
            self.at += self.word_ahead(self.at).len();
            // Rows, of an answer also two: `mode[1][3]`.
            while self.rest().starts_with('[') {
                let Some(end) = self.rest().find(']') else { break };
                let row = &self.rest()[1..end];
                if row.is_empty() || !row.bytes().all(|byte| byte.is_ascii_digit()) {
                    break;
                }
                self.at += end + 1;
            }
            let goes_on =
                self.rest().strip_prefix(['.', '-']).is_some_and(|rest| rest.starts_with(begins_word));
            // An alternative may have a hyphen in its name; elsewhere that is a minus.
            let hyphen = self.rest().starts_with('-');
            if !goes_on || hyphen && !self.names_go_on(start) {
                break;
            }
            self.at += 1;
        }
        let name = &self.text[start..self.at];
        let mut ahead = self.at;
        ahead += self.rest().len() - self.rest().trim_start().len();
        if self.text[ahead..].starts_with('(') {
            let Some(function) = Function::of(name) else {
                let known = Function::names().collect::<Vec<_>>().join(", ");
                let why = match nearest(name, Function::names()) {
                    _ if (self.is_name)(name) => {
                        Text::new("`{name}` is no function: write `{name}*(…)` for a product")
                    }
                    Some(near) => {
                        Text::new("there is no function `{name}`; did you mean `{near}`?").with("near", near)
                    }
                    None => {
                        Text::new("there is no function `{name}`; there are {known}").with("known", known)
                    }
                };
                return Err(FormulaError::at(start..self.at, why.with("name", name)));
            };
            self.at = ahead + 1;
            return self.call(function, start);
        }
        if matches!(name, "pi" | "π") && !(self.is_name)(name) {
            return Ok(Expression::Pi);
        }
        Ok(Expression::Name(name.to_owned(), start..self.at))
    }

    /// A name of a problem of another file: `@beam.toml:stiffness`.
    fn link(&mut self) -> Result<Expression, FormulaError> {
        let start = self.at;
        let file = self.rest().split(|c: char| c.is_whitespace() || c == ':').next().unwrap_or_default();
        if !self.rest()[file.len()..].starts_with(':') {
            let why = "a link names a file and an answer of it, as in @beam.toml:stiffness";
            return Err(FormulaError::at(start..start + file.len(), why));
        }
        self.at += file.len() + 1;
        if !self.rest().starts_with(begins_word) {
            return Err(self.unexpected("the name of an answer"));
        }
        self.word()?;
        Ok(Expression::Name(self.text[start..self.at].to_owned(), start..self.at))
    }

    /// Returns true if a hyphen goes on with a name: the longer name is one, or the beginning of a path.
    fn names_go_on(&self, start: usize) -> bool {
        let rest = &self.text[start..];
        let end = rest
            .char_indices()
            .find(|(_, c)| !(continues_word(*c) || matches!(c, '.' | '-' | '[' | ']')))
            .map_or(rest.len(), |(at, _)| at);
        (self.is_name)(&rest[..end])
    }

    fn call(&mut self, function: Function, start: usize) -> Result<Expression, FormulaError> {
        let mut arguments = Vec::new();
        if self.eat(&[')']).is_none() {
            loop {
                arguments.push(self.nested(Self::sum)?);
                match self.eat(&[',', ';', ')']) {
                    Some(')') => break,
                    Some(_) => {}
                    None => return Err(self.unexpected("a comma or a closing bracket")),
                }
            }
        }
        let wanted = function.arguments();
        if !wanted.contains(&arguments.len()) {
            let why = Text::new("{name} takes {wanted}; there are {have}")
                .with("name", function.name())
                .with_text("wanted", arguments_text(&wanted))
                .with("have", arguments.len());
            return Err(FormulaError::at(start..self.at, why));
        }
        Ok(Expression::Call(function, arguments, start..self.at))
    }
}

fn arguments_text(wanted: &std::ops::RangeInclusive<usize>) -> Text {
    match (*wanted.start(), *wanted.end()) {
        (1, 1) => Text::new("one argument"),
        (2, 2) => Text::new("two arguments"),
        (from, super::MOST_ARGUMENTS) => Text::new("{from} or more arguments").with("from", from),
        (from, to) => Text::new("{from} to {to} arguments").with("from", from).with("to", to),
    }
}

/// The words of a unit.
fn word_parts(unit: &str) -> Vec<&str> {
    unit.split(|c: char| !begins_word(c)).filter(|part| !part.is_empty()).collect()
}
