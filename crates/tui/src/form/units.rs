//! A quantity in the next unit of its kind.

use dalembert_core::{Shape, Value, draft};
use dalembert_units::{self as units, Decimal, Kind, Style, Unit};

/// Digits of a value that is written in another unit.
const CONVERTED_DIGITS: u8 = 9;

/// What was typed, in the unit after that of what is shown; in its own unit, as it was typed.
pub(super) fn in_next_unit(typed: &str, shown: &str, shape: &Shape, decimal: Decimal) -> Option<String> {
    let style = Style { digits: CONVERTED_DIGITS, decimal, ascii: true };
    let next = |unit: &Unit, kind: Kind| {
        let all = kind.units();
        let at = all.iter().position(|known| units::unit(known).is_ok_and(|known| same(&known, unit)));
        units::unit(all.get(at.map_or(0, |at| (at + 1) % all.len()))?).ok()
    };
    let read = |text| draft::read_leaf(text, shape, "").ok();
    match (read(typed)?, read(shown)?, shape) {
        (Value::Quantity(typed_as), Value::Quantity(now), Shape::Quantity(measure)) => {
            let unit = next(&now.unit, measure.kind())?;
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

/// Hz and rev/s are of one size and two units.
fn same(a: &Unit, b: &Unit) -> bool {
    a.ascii() == b.ascii()
}

#[cfg(test)]
mod tests {
    use dalembert_core::{Limit, Measure};

    use super::*;

    #[test]
    fn a_unit_goes_round_and_comes_back_as_it_was_typed() {
        let shape =
            Shape::Quantity(Measure { unit: "rad/s", kind: None, min: Limit::None, max: Limit::None });
        let mut shown = "1000,0 rpm".to_owned();
        let mut seen = Vec::new();
        loop {
            shown = in_next_unit("1000,0 rpm", &shown, &shape, Decimal::Comma)
                .expect("an angular velocity has many units");
            assert!(!shown.contains('.'), "{shown}");
            let Ok(Value::Quantity(read)) = draft::read_leaf(&shown, &shape, "") else { panic!("{shown}") };
            assert!((read.si / 104.719_755_119_66 - 1.0).abs() < 1e-8, "{shown}");
            seen.push(read.unit.ascii());
            if shown == "1000,0 rpm" {
                break;
            }
        }
        assert_eq!(seen, ["Hz", "rev/s", "deg/s", "rad/s", "rpm"]);
        assert_eq!(in_next_unit("far", "far", &shape, Decimal::Point), None);
    }
}
