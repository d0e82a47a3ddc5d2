//! Statement with the data of a variant in place of its numbers.

use std::ops::Range as Place;

use dalembert_core::Locale;
use dalembert_units::{self as units, Quantity, Style};

use crate::Datum;

/// The most words behind a number that are read as its unit.
const MOST_WORDS: usize = 3;

/// The statement, in the language of `locale`, with each datum in place of the number that it has in the problem itself.
/// `None` where one of them stands nowhere, or in several places, or where two have the same value: nothing is guessed.
pub fn rewritten(statement: &str, data: &[Datum], locale: &Locale) -> Option<String> {
    let numbers = numbers(statement, locale);
    let mut places: Vec<(Place<usize>, String)> = Vec::new();
    for datum in data {
        let mut found = numbers.iter().filter_map(|number| number.of(datum));
        let (place, quantity) = found.next()?;
        if found.next().is_some() || places.iter().any(|(known, _)| known.start == place.start) {
            return None;
        }
        let written = written(&statement[place.clone()], quantity, datum, locale);
        places.push((place, written));
    }
    places.sort_by_key(|(place, _)| place.start);
    let (mut text, mut at) = (String::new(), 0);
    for (place, written) in places {
        text += &statement[at..place.start];
        text += &written;
        at = place.end;
    }
    Some(text + &statement[at..])
}

/// The datum in the unit of the number that it replaces, as that unit is written there.
fn written(old: &str, quantity: &Quantity, datum: &Datum, locale: &Locale) -> String {
    let style = Style { digits: 12, ..locale.style };
    let number = units::write_number(quantity.unit.value(datum.si), style);
    let literal = old.trim_start_matches(['-', '−']);
    let end =
        literal.find(|c: char| !c.is_ascii_digit() && !['.', ','].contains(&c)).unwrap_or(literal.len());
    let unit = &literal[end..];
    if unit.contains(['×', '^']) && unit.trim_start().starts_with(['×', 'x', '*']) {
        return units::write_quantity(datum.si, &quantity.unit, style);
    }
    number + unit
}

/// A number in a sentence, with what it may be with the words behind it.
struct WrittenNumber {
    readings: Vec<(Place<usize>, Quantity)>,
}

impl WrittenNumber {
    /// The longest reading that is the value of the datum in the problem itself.
    fn of(&self, datum: &Datum) -> Option<(Place<usize>, &Quantity)> {
        let is_it = |(_, quantity): &&(Place<usize>, Quantity)| {
            quantity.unit.dim == datum.unit.dim
                && (quantity.si - datum.before).abs() <= 1e-9 * datum.before.abs()
        };
        let found = self.readings.iter().rev().find(is_it)?;
        Some((found.0.clone(), &found.1))
    }
}

fn numbers(text: &str, locale: &Locale) -> Vec<WrittenNumber> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find(|c: char| c.is_ascii_digit()).map(|next| at + next) {
        let end = text[start..]
            .find(|c: char| !c.is_ascii_digit() && !['.', ','].contains(&c))
            .map_or(text.len(), |length| start + length);
        at = end;
        let before = text[..start].chars().next_back();
        // The digits of a name or of an exponent are no datum.
        if before.is_some_and(|c| c.is_alphanumeric() || ['^', '_', '.', ','].contains(&c)) {
            continue;
        }
        let signed = match before {
            Some(sign @ ('-' | '−')) => {
                let sign = start - sign.len_utf8();
                let is_hyphen =
                    text[..sign].chars().next_back().is_some_and(|c| c.is_alphanumeric() || c == ')');
                if is_hyphen { start } else { sign }
            }
            _ => start,
        };
        found.push(WrittenNumber { readings: readings(text, signed, end, locale) });
    }
    found
}

/// Quantities that a text from a place on may be: the number alone, and with the words behind it.
fn readings(text: &str, start: usize, end: usize, locale: &Locale) -> Vec<(Place<usize>, Quantity)> {
    let trimmed = |end: usize| {
        start
            + text[start..end].trim_end_matches(['.', ',', ';', ':', ')', '(', '?', '!', ' ', '\u{a0}']).len()
    };
    let mut ends = vec![trimmed(end)];
    let mut at = end;
    for _ in 0..=MOST_WORDS {
        let rest = &text[at..];
        let word = rest.trim_start_matches([' ', '\u{a0}', '\u{202f}']);
        let length = word.find(char::is_whitespace).unwrap_or(word.len());
        if word.is_empty() {
            break;
        }
        at += rest.len() - word.len() + length;
        ends.push(trimmed(at));
    }
    ends.dedup();
    let read = |end: usize| {
        let typed = locale.style.decimal.to_point(&text[start..end]);
        Some((start..end, units::quantity_of(&typed)?))
    };
    ends.into_iter().filter_map(read).collect()
}

#[cfg(test)]
mod tests {
    use dalembert_core::Text;

    use super::*;

    fn datum(before: &str, now: &str) -> Datum {
        let [before, now] = [before, now].map(|text| units::read_any(text).unwrap());
        let typed = String::new();
        let (label, symbol, paths) = (Text::from("Mass"), "m", Vec::new());
        Datum { paths, label, symbol, before: before.si, si: now.si, typed, unit: before.unit }
    }

    #[test]
    fn numbers_of_a_sentence_are_replaced() {
        let english = Locale::english();
        let fan = "A fan of 40 kg runs at 1000 rpm (list 7, question 2) with an unbalance of 0.1 kg·m.";
        let data = [datum("40 kg", "35 kg"), datum("0.1 kg*m", "0.12 kg*m"), datum("1000 rpm", "1250 rpm")];
        assert_eq!(
            rewritten(fan, &data, &english).as_deref(),
            Some("A fan of 35 kg runs at 1250 rpm (list 7, question 2) with an unbalance of 0.12 kg·m.")
        );
        let portuguese = "Um ventilador de 1,2 m, com ζ = 0,05.";
        let data = [datum("1.2 m", "1.35 m"), datum("0.05", "0.065")];
        assert_eq!(
            rewritten(portuguese, &data, &Locale::portuguese()).as_deref(),
            Some("Um ventilador de 1,35 m, com ζ = 0,065.")
        );
        let section = "with I = 1.3×10⁻⁶ m⁴ and a force of −20 N";
        let data = [datum("1.3e-6 m^4", "1.5e-6 m^4"), datum("-20 N", "-25 N")];
        assert_eq!(
            rewritten(section, &data, &english).as_deref(),
            Some("with I = 1.5×10⁻⁶ m⁴ and a force of −25 N")
        );
        // The unit of the sentence stays.
        let grams = "A mass of 500 g.";
        assert_eq!(
            rewritten(grams, &[datum("0.5 kg", "0.65 kg")], &english).as_deref(),
            Some("A mass of 650 g.")
        );
    }

    #[test]
    fn nothing_is_guessed() {
        let english = Locale::english();
        for (statement, data) in [
            // Nowhere.
            ("A fan of 41 kg.", vec![datum("40 kg", "35 kg")]),
            ("A fan of 40 N.", vec![datum("40 kg", "35 kg")]),
            ("Masses of 2, 3 and 4 kg.", vec![datum("2 kg", "2.5 kg")]),
            // In two places.
            ("A fan of 40 kg and a motor of 40 kg.", vec![datum("40 kg", "35 kg")]),
            // Two inputs of one value.
            ("A fan of 40 kg.", vec![datum("40 kg", "35 kg"), datum("40 kg", "45 kg")]),
            // A part of a name.
            ("The bolt M40 holds.", vec![datum("40", "35")]),
        ] {
            assert_eq!(rewritten(statement, &data, &english), None, "{statement}");
        }
    }
}
