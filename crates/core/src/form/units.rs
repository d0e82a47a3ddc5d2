//! A quantity in the next unit of its kind; a number alone in the unit that is there.

use dalembert_units::{self as units, Kind, Style, Unit};

use crate::{Shape, Value, draft};

/// Digits of a value that is written in another unit.
const CONVERTED_DIGITS: u8 = 9;

/// Value converted to the unit that follows the displayed one; in its own unit, as it was typed.
pub fn in_next_unit(typed: &str, shown: &str, shape: &Shape) -> Option<String> {
    let style = Style { digits: CONVERTED_DIGITS, ascii: true, ..Style::default() };
    let next = |unit: &Unit, kind: Kind| {
        let all = kind.units();
        let at = all.iter().position(|known| units::unit(known).is_ok_and(|known| same(&known, unit)));
        units::unit(all.get(at.map_or(0, |at| (at + 1) % all.len()))?).ok()
    };
    let read = |text| draft::read_leaf(text, shape, "").ok();
    match (read(typed)?, read(shown)?, shape) {
        (Value::Quantity(typed_as), Value::Quantity(now), Shape::Quantity(measure)) => {
            let unit = next(&now.unit, measure.of(&now.unit).kind())?;
            Some(if same(&unit, &typed_as.unit) {
                typed.to_owned()
            } else {
                units::write_quantity(typed_as.si, &unit, style)
            })
        }
        (Value::Vector(typed_as), Value::Vector(now), Shape::Vector(measure, _)) => {
            let unit = next(&now.unit, measure.kind())?;
            let components = &typed_as.si[..typed_as.len];
            Some(if same(&unit, &typed_as.unit) {
                typed.to_owned()
            } else {
                units::write_components(components, &unit, style)
            })
        }
        _ => None,
    }
}

/// The unit that a text is written in; `None` where it has none or cannot be read.
pub fn written_unit(text: &str, shape: &Shape) -> Option<Unit> {
    let (own, kind) = asked(shape, text)?;
    if is_number(text, shape) {
        return None;
    }
    read(text, shape, &own, kind).map(|(_, unit)| unit)
}

/// A number alone with a unit after it; any other text as it is.
pub fn with_unit(text: String, unit: Option<&Unit>, shape: &Shape) -> String {
    let (Some(unit), Some((own, kind))) =
        (unit, unit.and_then(|unit| asked(shape, &format!("1 {}", unit.text))))
    else {
        return text;
    };
    if !is_number(&text, shape) {
        return text;
    }
    let number = text.trim();
    let [plain, bracketed] = [format!("{number} {}", unit.text), format!("({number}) {}", unit.text)];
    // Angles with π are not in degrees or turns only because those stood there.
    let Some((meant, _)) = read(number, shape, unit, kind) else { return text };
    // A sum is multiplied by its unit as a whole: 3 + 4 in mm.
    let says = |written: &str| {
        let said = read(written, shape, &own, kind);
        said.is_some_and(|(said, _)| {
            meant.iter().zip(said).all(|(meant, said)| (meant - said).abs() <= 1e-12 * meant.abs())
        })
    };
    if !says(&plain) && says(&bracketed) { bracketed } else { plain }
}

/// Returns true if a text is a number, or numbers, without a unit.
fn is_number(text: &str, shape: &Shape) -> bool {
    read(text, shape, &Unit::ONE, Kind::Other).is_some_and(|(_, unit)| unit.text.is_empty())
}

/// The unit that a number alone is taken in; `None` for what has none.
pub fn own_unit(shape: &Shape) -> Option<Unit> {
    asked(shape, "1").map(|(own, _)| own).filter(|own| !own.text.is_empty())
}

/// The unit and the kind that are asked for, where there are several those that a text is of.
fn asked(shape: &Shape, text: &str) -> Option<(Unit, Kind)> {
    match shape {
        Shape::Quantity(measure) | Shape::Vector(measure, _) => {
            let measure = measure.meant(text);
            Some((measure.own_unit(), measure.kind()))
        }
        _ => None,
    }
}

/// Numbers in SI and their unit, whatever the limits of the field.
fn read(text: &str, shape: &Shape, bare: &Unit, kind: Kind) -> Option<([f64; 3], Unit)> {
    match shape {
        Shape::Vector(_, len) => {
            units::read_vector(text, bare, kind, *len).ok().map(|vector| (vector.si, vector.unit))
        }
        _ => units::read_quantity(text, bare, kind).ok().map(|number| ([number.si, 0.0, 0.0], number.unit)),
    }
}

/// Hz and rev/s are of one size and two units.
fn same(a: &Unit, b: &Unit) -> bool {
    a.ascii() == b.ascii()
}

#[cfg(test)]
mod tests {
    use crate::{FieldLimit, Measure};

    use super::*;

    #[test]
    fn a_unit_goes_round_and_comes_back_as_it_was_typed() {
        let shape = Shape::Quantity(Measure::in_unit("rad/s"));
        let mut shown = "1000.0 rpm".to_owned();
        let mut seen = Vec::new();
        loop {
            shown = in_next_unit("1000.0 rpm", &shown, &shape).expect("an angular velocity has many units");
            let Ok(Value::Quantity(read)) = draft::read_leaf(&shown, &shape, "") else { panic!("{shown}") };
            assert!((read.si / 104.719_755_119_66 - 1.0).abs() < 1e-8, "{shown}");
            seen.push(read.unit.ascii());
            if shown == "1000.0 rpm" {
                break;
            }
        }
        assert_eq!(seen, ["Hz", "rev/s", "deg/s", "rad/s", "rpm"]);
        assert_eq!(in_next_unit("far", "far", &shape), None);
    }

    #[test]
    fn a_number_alone_takes_the_unit_that_is_there_whatever_it_is() {
        for known in dalembert_units::spellings() {
            let Ok(unit) = units::unit(known.symbols[0]) else { continue };
            if unit.sense == dalembert_units::UnitMeaning::Level {
                continue;
            }
            let shape = Shape::Quantity(Measure::in_unit(known.symbols[0]));
            let (own, kind) = asked(&shape, "").expect("a quantity");
            for number in ["25", "-30", "1,5", "2.5e-3", "1/2", "3 + 4", "sqrt(2)", "2^3"] {
                let whole = with_unit(number.to_owned(), Some(&unit), &shape);
                let (said, read_unit) = read(&whole, &shape, &own, kind).unwrap_or_else(|| panic!("{whole}"));
                let (meant, _) = read(number, &shape, &unit, kind).expect("a number");
                assert!((said[0] / meant[0] - 1.0).abs() < 1e-12, "{number} as {whole}");
                assert!(same(&read_unit, &unit), "{whole}");
                assert_eq!(with_unit(whole.clone(), Some(&unit), &shape), whole);
            }
        }
    }

    #[test]
    fn the_unit_of_a_text_is_what_a_user_wrote() {
        let measure = Measure { min: FieldLimit::Excluding(0.0), ..Measure::in_unit("m") };
        let (length, vector) = (Shape::Quantity(measure), Shape::Vector(measure, 3));
        let angle = Shape::Quantity(Measure { unit: "rad", ..measure });
        for (old, shape, typed, wanted) in [
            ("20.3 mm", length, "25", "25 mm"),
            ("-20,3mm", length, "25", "25 mm"),
            ("20.3 mm", length, "25 in", "25 in"),
            ("20.3 mm", length, "3 + 4", "(3 + 4) mm"),
            ("20.3 mm", length, "2*", "2*"),
            ("30 deg", angle, "2*pi", "2*pi"),
            ("0.02", length, "25", "25"),
            ("", length, "25", "25"),
            ("far", length, "25", "25"),
            ("(1; 2; 3) mm", vector, "(4; 5; 6)", "(4; 5; 6) mm"),
            ("(1 i + 2 j) mm", vector, "4; 5; 6", "4; 5; 6 mm"),
            ("(1; 2; 3) mm", vector, "(4 m; 5 m; 6 m)", "(4 m; 5 m; 6 m)"),
            ("name", Shape::Text, "25", "25"),
        ] {
            let unit = written_unit(old, &shape);
            assert_eq!(with_unit(typed.to_owned(), unit.as_ref(), &shape), wanted, "{typed} over {old}");
        }
    }
}
