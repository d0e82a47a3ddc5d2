//! Formulas as the printer writes them, read again as what they are made of, so that they can be set as mathematics.
//!
//! Nothing is refused: what the notation does not know is kept unchanged.

pub(crate) mod breaking;
pub(crate) mod prose;

use dalembert_core::{ascii, printer::WrittenStep};

/// A formula or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Math {
    /// Parts side by side.
    Row(Vec<Math>),
    /// A number with its decimal mark: `1.3`.
    Number(String),
    /// A unit or a word, upright.
    Upright(String),
    /// A symbol and its index, which may be empty.
    Symbol(String, String),
    /// A sign between or before others.
    Operator(char),
    /// Room between factors.
    Gap,
    /// Something over something.
    Fraction(Box<Math>, Box<Math>),
    /// The root of something; its degree is empty for a square root.
    Root(String, Box<Math>),
    /// Something with a power.
    Power(Box<Math>, String),
    /// Something with an index.
    Index(Box<Math>, String),
    /// Something in brackets of this kind: `(`, `[` or `|`.
    Brackets(char, Box<Math>),
}

/// The bracket that closes what another one opens; a stroke closes itself.
pub(crate) fn closing(open: char) -> char {
    match open {
        '(' => ')',
        '[' => ']',
        other => other,
    }
}

/// A formula of symbols.
pub(crate) fn symbols(text: &str) -> Math {
    Reader { rest: text.chars().collect(), at: 0, values: false }.row(None)
}

/// The same with its values: letters are units.
pub(crate) fn values(text: &str) -> Math {
    Reader { rest: text.chars().collect(), at: 0, values: true }.row(None)
}

/// Sides of a chain of equations: symbol, formula, substitution, result.
pub(crate) fn sides(step: &WrittenStep) -> Vec<Math> {
    let mut sides = Vec::new();
    if !step.formula.is_empty() {
        sides.push(symbols(&step.formula));
    }
    sides.extend(
        [&step.substitution, &step.result]
            .into_iter()
            .filter(|side| !side.is_empty())
            .map(|side| values(side)),
    );
    sides
}

/// Functions that are written upright.
const FUNCTIONS: [&str; 10] =
    ["sin", "cos", "tan", "arcsin", "arccos", "arctan", "exp", "ln", "atan2", "abs"];

/// The plain character that a raised one stands for.
pub(crate) fn lowered(character: char) -> Option<char> {
    ascii::power(character).map(minus)
}

/// The plain character that a lowered one stands for.
pub(crate) fn raised(character: char) -> Option<char> {
    ascii::index(character).map(minus)
}

/// The minus of mathematics for that of the keyboard.
fn minus(character: char) -> char {
    if character == '-' { '−' } else { character }
}

/// A part, or the sign that parts what stands over from what stands under it.
enum Piece {
    Part(Math),
    Over,
}

/// True where an operand must follow: a bar there begins another absolute value.
fn wants_operand(pieces: &[Piece]) -> bool {
    let last = pieces.iter().rev().find(|piece| !matches!(piece, Piece::Part(Math::Gap)));
    matches!(last, None | Some(Piece::Over | Piece::Part(Math::Operator(_))))
}

struct Reader {
    rest: Vec<char>,
    at: usize,
    values: bool,
}

impl Reader {
    fn peek(&self) -> Option<char> {
        self.rest.get(self.at).copied()
    }

    fn after(&self, n: usize) -> Option<char> {
        self.rest.get(self.at + n).copied()
    }

    fn take_while(&mut self, mut wanted: impl FnMut(&Self, char) -> bool) -> String {
        let mut text = String::new();
        while let Some(character) = self.peek()
            && wanted(self, character)
        {
            text.push(character);
            self.at += 1;
        }
        text
    }

    fn raised(&mut self) -> String {
        self.take_while(|_, c| lowered(c).is_some()).chars().filter_map(lowered).collect()
    }

    /// Everything up to a closing bracket of this kind, or to the end.
    fn row(&mut self, close: Option<char>) -> Math {
        let mut pieces: Vec<Piece> = Vec::new();
        while let Some(character) = self.peek() {
            if Some(character) == close && !(character == '|' && wants_operand(&pieces)) {
                break;
            }
            match character {
                ' ' => {
                    self.at += 1;
                    pieces.push(Piece::Part(Math::Gap));
                }
                '/' if self.after(1) == Some(' ') => {
                    self.at += 1;
                    pieces.push(Piece::Over);
                }
                _ if lowered(character).is_some() => {
                    let power = self.raised();
                    if self.peek() == Some('√') {
                        self.at += 1;
                        let of = self.under_root();
                        pieces.push(Piece::Part(Math::Root(power, Box::new(of))));
                    } else {
                        match pieces.pop() {
                            Some(Piece::Part(base)) if base != Math::Gap => {
                                pieces.push(Piece::Part(Math::Power(Box::new(base), power)));
                            }
                            other => {
                                pieces.extend(other);
                                pieces.push(Piece::Part(Math::Upright(power)));
                            }
                        }
                    }
                }
                _ => {
                    let part = self.atom();
                    let indexed = matches!(part, Math::Brackets(..)) && self.begins_index();
                    pieces.push(Piece::Part(if indexed {
                        let index = self.index();
                        Math::Index(Box::new(part), index)
                    } else {
                        part
                    }));
                }
            }
        }
        arranged(pieces)
    }

    fn begins_index(&self) -> bool {
        match self.peek() {
            Some('_') => true,
            Some(character) => raised(character).is_some(),
            None => false,
        }
    }

    /// `₁,₂`, `_x`, `_G₂`, `₁_x`
    fn index(&mut self) -> String {
        // Behind the line `I_G₂` and `ω₁_x` go on with letters; `m₀e` is a product.
        let mut named = false;
        let text = self.take_while(|reader, c| {
            named |= c == '_';
            c == '_'
                || named && c.is_alphanumeric() && lowered(c).is_none()
                || raised(c).is_some()
                || matches!(c, '\'' | '′')
                || c == ',' && reader.after(1).is_some_and(|next| raised(next).is_some())
        });
        text.chars().filter(|c| *c != '_').map(|c| raised(c).unwrap_or(c)).collect()
    }

    fn under_root(&mut self) -> Math {
        match self.peek() {
            Some(_) => match self.atom() {
                Math::Brackets('(', inner) => *inner,
                other => other,
            },
            None => Math::Row(Vec::new()),
        }
    }

    /// A number, a symbol, a bracket, a sign.
    fn atom(&mut self) -> Math {
        let Some(character) = self.peek() else { return Math::Row(Vec::new()) };
        match character {
            '0'..='9' => self.number(),
            '(' | '[' | '|' => {
                self.at += 1;
                let close = closing(character);
                let inner = self.row(Some(close));
                self.at += usize::from(self.peek() == Some(close));
                Math::Brackets(character, Box::new(inner))
            }
            '√' => {
                self.at += 1;
                Math::Root(String::new(), Box::new(self.under_root()))
            }
            '%' | '°' | '‰' => self.unit(),
            'Σ' if !self.values && !self.after(1).is_some_and(char::is_alphanumeric) => {
                self.at += 1;
                Math::Operator('∑')
            }
            _ if character.is_alphabetic() => self.word(),
            _ => {
                self.at += 1;
                Math::Operator(character)
            }
        }
    }

    /// `1.3`, `1,3`, `1.3×10⁻⁶`
    fn number(&mut self) -> Math {
        let digits = self.take_while(|reader, c| {
            c.is_ascii_digit()
                || matches!(c, '.' | ',') && reader.after(1).is_some_and(|next| next.is_ascii_digit())
        });
        let number = Math::Number(digits);
        let ten: String = self.rest.iter().skip(self.at).take(3).collect();
        if ten == "×10" && self.after(3).is_some_and(|next| lowered(next).is_some()) {
            self.at += 3;
            let power = Math::Power(Box::new(Math::Number("10".to_owned())), self.raised());
            return Math::Row(vec![number, Math::Operator('×'), power]);
        }
        number
    }

    fn word(&mut self) -> Math {
        let begin = self.at;
        let letters = self.take_while(|_, c| c.is_ascii_alphanumeric());
        if FUNCTIONS.contains(&letters.as_str()) && !self.begins_index() {
            return Math::Upright(letters);
        }
        let alone =
            !self.peek().is_some_and(|next| next.is_alphanumeric() || matches!(next, '·' | '/' | '²'));
        if self.values && !(alone && matches!(letters.as_str(), "i" | "j" | "k")) {
            self.at = begin;
            if self.peek() == Some('π') {
                self.at += 1;
                return Math::Symbol("π".to_owned(), String::new());
            }
            return self.unit();
        }
        self.at = begin;
        let base = self.take_while(|_, c| {
            (c.is_alphanumeric() && lowered(c).is_none() && raised(c).is_none())
                || ('\u{300}'..='\u{36F}').contains(&c)
                || matches!(c, '\'' | '′' | '*' | 'Σ')
        });
        if base.is_empty() {
            // A lowered letter with nothing before it.
            let index = self.index();
            return Math::Upright(index);
        }
        let index = if self.begins_index() { self.index() } else { String::new() };
        Math::Symbol(base, index)
    }

    /// `kN/mm²`, `kg/(m·s)`
    fn unit(&mut self) -> Math {
        let mut open = 0;
        Math::Upright(self.take_while(|reader, c| {
            let before = reader.at.checked_sub(1).and_then(|at| reader.rest.get(at)).copied();
            match c {
                '(' if before == Some('/') => open += 1,
                ')' if open > 0 => open -= 1,
                '·' | '/' | '%' | '°' | '‰' | '′' | '″' | '_' => {}
                _ if c.is_alphanumeric() || lowered(c).is_some() => {}
                _ => return false,
            }
            true
        }))
    }
}

/// Parts with their fractions: what stands before `/` back to a sum sign is over what stands after it up to the next.
fn arranged(pieces: Vec<Piece>) -> Math {
    let mut out: Vec<Math> = Vec::new();
    let mut term: Vec<Math> = Vec::new();
    let mut over: Option<Vec<Math>> = None;
    for piece in pieces {
        match piece {
            Piece::Over => {
                let top = std::mem::take(&mut term);
                // A second stroke divides what the first one made.
                over = Some(match over.take() {
                    Some(first) => vec![fraction(first, top)],
                    None => top,
                });
            }
            Piece::Part(
                sign @ Math::Operator('+' | '−' | '-' | '=' | '≤' | '≥' | '<' | '>' | '±' | ',' | ';'),
            ) => {
                close(&mut out, &mut term, &mut over);
                out.push(sign);
            }
            Piece::Part(part) => term.push(part),
        }
    }
    close(&mut out, &mut term, &mut over);
    match out.len() {
        1 => out.remove(0),
        _ => Math::Row(out),
    }
}

fn close(out: &mut Vec<Math>, term: &mut Vec<Math>, over: &mut Option<Vec<Math>>) {
    let mut term = std::mem::take(term);
    if let Some(top) = over.take() {
        // `(a / b) i`: the direction stands beside the fraction.
        let trimmed = trimmed(term);
        let direction = match &trimmed[..] {
            [_, .., Math::Gap, Math::Symbol(axis, index)]
                if index.is_empty() && matches!(axis.as_str(), "i" | "j" | "k") =>
            {
                trimmed.len() - 2
            }
            _ => trimmed.len(),
        };
        let mut under = trimmed;
        let rest = under.split_off(direction);
        term = vec![fraction(top, under)];
        term.extend(rest);
    }
    out.extend(tidied(trimmed(term)));
}

fn fraction(top: Vec<Math>, bottom: Vec<Math>) -> Math {
    let whole = |parts: Vec<Math>| {
        let mut parts = tidied(trimmed(parts));
        let only = if parts.len() == 1 { parts.pop() } else { None };
        match only {
            Some(Math::Brackets('(', inner)) => inner,
            Some(other) => Box::new(other),
            None => Box::new(Math::Row(parts)),
        }
    };
    Math::Fraction(whole(top), whole(bottom))
}

/// Without room at its ends.
fn trimmed(mut parts: Vec<Math>) -> Vec<Math> {
    while parts.last() == Some(&Math::Gap) {
        parts.pop();
    }
    let begin = parts.iter().position(|part| *part != Math::Gap).unwrap_or(parts.len());
    parts.drain(..begin);
    parts
}

/// Without room beside signs, which bring their own.
fn tidied(parts: Vec<Math>) -> Vec<Math> {
    let sign = |part: Option<&Math>| matches!(part, Some(Math::Operator(_)));
    let keep: Vec<bool> = (0..parts.len())
        .map(|at| parts[at] != Math::Gap || !(sign(parts.get(at + 1)) || at > 0 && sign(parts.get(at - 1))))
        .collect();
    parts.into_iter().zip(keep).filter(|(_, keep)| *keep).map(|(part, _)| part).collect()
}

#[cfg(test)]
mod tests;
