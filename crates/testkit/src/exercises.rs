//! Statements of exercises: whoever has the statement alone can solve the problem, and does not learn the answer.

use dalembert_core::{
    Draft, Entry, Field, Language, Locale, Shape, Stop, Value, cases::Case, draft, text::is_translated,
};
use dalembert_units::Decimal;

use crate::{problems::cases_of, some};

/// Share by which two numbers may differ and be the same number.
const SAME: f64 = 1e-12;
/// Share of an answer within which a number of a statement gives it away.
const GIVEN_AWAY: f64 = 0.005;

/// A number of the inputs, as it must stand in the statement.
struct Datum {
    path: String,
    text: String,
    numbers: Vec<f64>,
    /// Unit as a statement has it; empty for a pure number.
    unit: String,
}

/// Every statement names each number of its inputs that is no default, with its unit, in both languages; what it asks for
/// are answers of the solution, and none of them stands in it. The number of statements.
pub fn statements_are_complete(entries: &[&'static Entry]) -> usize {
    some(entries);
    let (mut faults, mut count) = (Vec::new(), 0);
    for entry in entries {
        for case in cases_of(entry).iter().filter(|case| !case.statement.is_empty()) {
            count += 1;
            let name = format!("{}, {}", entry.about.id, case.name);
            faults.extend(faults_of(entry, case).into_iter().map(|fault| format!("{name}: {fault}")));
        }
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
    count
}

fn faults_of(entry: &'static Entry, case: &Case) -> Vec<String> {
    let mut faults = Vec::new();
    let mut data = Vec::new();
    collect(&case.draft, &entry.shape(), "", &mut data);
    let record = match case.record(entry) {
        Ok(record) => record,
        Err(why) => return vec![why.to_string()],
    };
    let solution = match entry.solve(&record, &Stop::new()) {
        Ok(solution) => solution,
        Err(why) => return vec![why.to_string()],
    };
    if !is_translated(&case.statement.english()) {
        faults.push("the statement has no Portuguese".to_owned());
    }
    for locale in [Locale::english(), Locale::portuguese()] {
        let text = case.statement.render(&locale.at(entry.about.id));
        let decimal = if locale.language == Language::English { Decimal::Point } else { Decimal::Comma };
        let stated = numbers(&text, decimal);
        for datum in &data {
            for number in &datum.numbers {
                if !stated.iter().any(|other| is_near(*other, *number, SAME)) {
                    faults
                        .push(format!("{:?}: {} of {} is missing", locale.language, datum.text, datum.path));
                }
            }
            if !text.contains(&datum.unit) {
                faults.push(format!(
                    "{:?}: the unit {} of {} is missing",
                    locale.language, datum.unit, datum.path
                ));
            }
        }
        let given: Vec<f64> = data.iter().flat_map(|datum| datum.numbers.iter().copied()).collect();
        let is_given = |number: f64| given.iter().any(|other| is_near(*other, number, SAME));
        for name in &case.asked {
            let Some(answer) = solution.answer(name) else {
                faults.push(format!("{name} is asked for and is no answer"));
                continue;
            };
            let shown = numbers(&answer.shown(&Locale::english().digits(6)), Decimal::Point);
            let away = stated.iter().find(|stated| {
                !is_given(**stated) && shown.iter().any(|shown| is_near(**stated, *shown, GIVEN_AWAY))
            });
            if let Some(number) = away.filter(|_| answer.si().is_some()) {
                faults.push(format!("{:?}: {number} gives {name} away", locale.language));
            }
        }
    }
    faults
}

/// The same size; signs are said in words.
fn is_near(a: f64, b: f64, share: f64) -> bool {
    a != 0.0 && (a.abs() - b.abs()).abs() <= share * b.abs()
}

/// The numbers of a draft. Zero, one of something, and axes along the coordinates are said in words.
fn collect(part: &Draft, shape: &Shape, path: &str, data: &mut Vec<Datum>) {
    let fields = |fields: &'static [Field], parts: &Draft, data: &mut Vec<Datum>| {
        let Draft::Group(parts) = parts else { return };
        for (field, part) in fields.iter().zip(parts) {
            let is_default =
                matches!((part, field.default), (Draft::Leaf(text), Some(usual)) if text == usual);
            if !is_default {
                collect(part, &field.shape, &format!("{path}.{}", field.name), data);
            }
        }
    };
    let shape = shape.present();
    match (part, &shape) {
        (Draft::Group(_), Shape::Group(_)) => fields(shape.fields(None), part, data),
        (Draft::OneOf(at, inner), Shape::OneOf(_)) => fields(shape.fields(Some(*at)), inner, data),
        (Draft::Rows(rows), Shape::Rows { item, .. }) => {
            for row in rows {
                collect(row, item(), path, data);
            }
        }
        (
            Draft::Leaf(text),
            Shape::Quantity(_) | Shape::Vector(..) | Shape::Count { .. } | Shape::Table(_),
        ) => {
            let mut numbers = numbers(text, Decimal::Point);
            numbers.retain(|number| *number != 0.0);
            let mut unit = String::new();
            match draft::read_leaf(text, &shape, path) {
                Ok(Value::Quantity(quantity)) => unit = quantity.unit.pretty(),
                Ok(Value::Vector(vector)) => {
                    unit = vector.unit.pretty();
                    if unit.is_empty() {
                        numbers.retain(|number| *number != 1.0);
                    }
                }
                Ok(Value::Count(1)) => numbers.clear(),
                _ => {}
            }
            if numbers.is_empty() {
                unit.clear();
            }
            data.push(Datum { path: path.to_owned(), text: text.clone(), numbers, unit });
        }
        _ => {}
    }
}

/// The numbers of a text, without their signs: `2.0e-4`, `1.3×10⁻⁶`, `40/32.2`. Digits of names, exponents and
/// subscripts are none.
fn numbers(text: &str, decimal: Decimal) -> Vec<f64> {
    let mark = if decimal == Decimal::Point { '.' } else { ',' };
    let chars: Vec<char> = text.chars().collect();
    let digit = |at: usize| chars.get(at).is_some_and(char::is_ascii_digit);
    let (mut found, mut at) = (Vec::new(), 0);
    while at < chars.len() {
        let before = at.checked_sub(1).map(|before| chars[before]);
        let is_name = before.is_some_and(|c| c.is_alphabetic() || matches!(c, '_' | '^'));
        if !digit(at) {
            at += 1;
            continue;
        }
        if is_name {
            while digit(at) {
                at += 1;
            }
            continue;
        }
        let mut number = String::new();
        while digit(at) || (chars.get(at) == Some(&mark) && digit(at + 1) && !number.contains('.')) {
            number.push(if chars[at] == mark { '.' } else { chars[at] });
            at += 1;
        }
        let exponent: String = match chars.get(at..at + 3) {
            Some(['×', '1', '0']) => chars[at + 3..].iter().map_while(|c| lowered(*c)).collect(),
            _ => String::new(),
        };
        if !exponent.is_empty() {
            at += 3 + exponent.chars().count();
        } else if chars.get(at) == Some(&'e')
            && (digit(at + 1) || (chars.get(at + 1) == Some(&'-') && digit(at + 2)))
        {
            let rest: String =
                chars[at + 1..].iter().take_while(|c| c.is_ascii_digit() || **c == '-').collect();
            at += 1 + rest.len();
            number += &format!("e{rest}");
        }
        if !exponent.is_empty() {
            number += &format!("e{exponent}");
        }
        found.extend(number.parse::<f64>());
    }
    found
}

/// The character that a superscript raises.
fn lowered(raised: char) -> Option<char> {
    let at = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|c| c == raised)?;
    "-0123456789".chars().nth(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_a_text_are_found() {
        let english =
            numbers("2.0×10⁻⁴ m/N at 12 rad/s, 40/32.2 slug and √48. I_2 and m^3 are none.", Decimal::Point);
        assert_eq!(english, [2.0e-4, 12.0, 40.0, 32.2, 48.0]);
        assert_eq!(numbers("T = 1,5×10⁵ N, 3,0°", Decimal::Comma), [1.5e5, 3.0]);
        assert_eq!(numbers("1.3e-6 m^4; 5e5 N/m; (−0.15; 0) m", Decimal::Point), [1.3e-6, 5e5, 0.15, 0.0]);
    }
}
