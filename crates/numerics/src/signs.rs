//! Signs of a function over a range, proven by enclosures of the function and of its derivative.
//!
//! The range is divided until each part has one sign, or the function is monotone in it; a monotone part has at most one
//! zero, which bisection encloses by the signs that are proven at single points. What cannot be decided so in parts of
//! [`LEAST`] of their place, where the function touches zero without crossing it or is not defined, is left undecided.
//!
//! ```
//! use dalembert_numerics::{
//!     enclosure::Jet,
//!     signs::{Sign, signs},
//! };
//!
//! // x² − 2 from 0 to 3: negative, a zero in a narrow part about √2, positive.
//! let parts = signs(&mut |x| Jet::variable(x).powi(2) - Jet::constant(2.0), [0.0, 3.0]);
//! let crossing = parts.iter().position(|part| part.sign == Sign::Crossing).expect("there is a zero");
//! assert!((parts[crossing].from..=parts[crossing].to).contains(&2_f64.sqrt()));
//! assert!(parts[crossing].to - parts[crossing].from < 1e-9);
//! assert!(parts[..crossing].iter().all(|part| part.sign == Sign::Below));
//! assert!(parts[crossing + 1..].iter().all(|part| part.sign == Sign::Above));
//! ```

use std::collections::VecDeque;

use crate::enclosure::{Enclosure, Jet};

/// Width of the smallest parts, as a share of their place.
pub const LEAST: f64 = 2e-10;
/// The same as a share of the range, near zero.
const LEAST_OF_RANGE: f64 = 1e-14;
/// Parts that are examined at most.
const MOST: usize = 100_000;

/// Sign of a function in a part of its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Negative.
    Below,
    /// Positive.
    Above,
    /// Exactly one zero, at which the sign changes.
    Crossing,
    /// Not defined.
    Undefined,
    /// Not decided.
    Undecided,
}

/// A part of a range with one sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignedPart {
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// Sign.
    pub sign: Sign,
}

/// A part while it is examined.
#[derive(Clone, Copy, PartialEq)]
enum Class {
    Signed(Sign),
    /// Monotone: 1 ascending, −1 descending.
    Monotone(i8),
}

/// Signs of a function in all of a range, ascending, each part beginning where the one before ends.
pub fn signs(function: &mut dyn FnMut([f64; 2]) -> Jet, [from, to]: [f64; 2]) -> Vec<SignedPart> {
    let least = |a: f64, b: f64| (LEAST * a.abs().max(b.abs())).max(LEAST_OF_RANGE * (to - from));
    let mut open = VecDeque::from([[from, to]]);
    let mut classes: Vec<([f64; 2], Class)> = Vec::new();
    let mut examined = 0;
    while let Some([a, b]) = open.pop_front() {
        examined += 1;
        let middle = middle(a, b);
        let class = match class(function([a, b])) {
            Some(class) => class,
            None if b - a > least(a, b) && examined < MOST && a < middle && middle < b => {
                open.push_front([middle, b]);
                open.push_front([a, middle]);
                continue;
            }
            None => Class::Signed(Sign::Undecided),
        };
        match classes.last_mut() {
            Some((last, known)) if *known == class => last[1] = b,
            _ => classes.push(([a, b], class)),
        }
    }
    let mut parts = Vec::new();
    for (range, class) in classes {
        match class {
            Class::Signed(sign) => append(&mut parts, range, sign),
            Class::Monotone(direction) => resolve(function, range, direction, &mut parts),
        }
    }
    parts
}

/// Class that an enclosure proves of a part; `None` where it is to be divided.
fn class(jet: Jet) -> Option<Class> {
    let Jet { value, slope } = jet;
    match () {
        () if value.is_none() => Some(Class::Signed(Sign::Undefined)),
        () if !value.is_defined => None,
        () if value.high < 0.0 => Some(Class::Signed(Sign::Below)),
        () if value.low > 0.0 => Some(Class::Signed(Sign::Above)),
        () if slope.is_none() => None,
        () if slope.low > 0.0 => Some(Class::Monotone(1)),
        () if slope.high < 0.0 => Some(Class::Monotone(-1)),
        () => None,
    }
}

/// The sign that is proven of a number: 0 where none is.
fn proven(value: Enclosure) -> i8 {
    match () {
        () if !value.is_defined => 0,
        () if value.high < 0.0 => -1,
        () if value.low > 0.0 => 1,
        () => 0,
    }
}

/// Encloses the zero of a monotone part, if there is one.
fn resolve(
    function: &mut dyn FnMut([f64; 2]) -> Jet,
    [from, to]: [f64; 2],
    direction: i8,
    parts: &mut Vec<SignedPart>,
) {
    let sign = |sign: i8| if sign < 0 { Sign::Below } else { Sign::Above };
    // The sign before the zero and behind it.
    let (before, behind) = (-direction, direction);
    let mut at = |x: f64| proven(function([x, x]).value);
    let (first, last) = (at(from), at(to));
    if first == behind || last == before {
        let all = if first == behind { behind } else { before };
        append(parts, [from, to], sign(all));
        return;
    }
    let (mut low, mut high) = (from, to);
    if first == before {
        let mut unproven = to;
        while let Some(middle) = between(low, unproven) {
            if at(middle) == before { low = middle } else { unproven = middle }
        }
    }
    if last == behind {
        let mut unproven = low;
        while let Some(middle) = between(unproven, high) {
            if at(middle) == behind { high = middle } else { unproven = middle }
        }
    }
    let is_crossing = first == before && last == behind;
    append(parts, [from, low], sign(before));
    append(parts, [low, high], if is_crossing { Sign::Crossing } else { Sign::Undecided });
    append(parts, [high, to], sign(behind));
}

/// Appends a part that is not empty.
fn append(parts: &mut Vec<SignedPart>, [from, to]: [f64; 2], sign: Sign) {
    match parts.last_mut() {
        _ if from >= to => {}
        Some(last) if last.sign == sign && sign != Sign::Crossing => last.to = to,
        _ => parts.push(SignedPart { from, to, sign }),
    }
}

/// The middle of a part: of its ends' ratio where that is large.
fn middle(a: f64, b: f64) -> f64 {
    if a > 0.0 && b > 4.0 * a {
        a.sqrt() * b.sqrt()
    } else if b < 0.0 && a < 4.0 * b {
        -((-a).sqrt() * (-b).sqrt())
    } else {
        a / 2.0 + b / 2.0
    }
}

/// A number between two; `None` once they are neighbours, or next to it.
fn between(a: f64, b: f64) -> Option<f64> {
    let middle = middle(a, b);
    let is_apart = b - a > 4.0 * f64::EPSILON * a.abs().max(b.abs());
    (is_apart && a < middle && middle < b).then_some(middle)
}
