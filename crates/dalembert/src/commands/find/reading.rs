//! Input, range and value that are asked for, as they are typed.

use dalembert_core::{
    Answer, Locale, Record, Text,
    study::Amount,
    vary::{self, VariedInput},
};
use dalembert_units::{self as units, Kind};

use super::Asked;
use crate::failure::Failure;

/// The input that is to be found.
pub(super) fn input_of(asked: &Asked<'_>, record: &Record) -> Result<VariedInput, Failure> {
    let inputs = vary::inputs(record);
    let found = inputs.iter().find(|input| input.path == asked.input).cloned();
    found.ok_or_else(|| Failure::input(vary::unknown_number(&inputs, asked.input)))
}

/// The range that is asked for, or that about the value of the problem, in SI.
pub(super) fn range_of(asked: &Asked<'_>, input: &VariedInput) -> Result<[f64; 2], Failure> {
    let read = |option: &'static str, text: &str| {
        input.read(text).map_err(|why| {
            let error = Text::new("{option} {text}: {why}").with("option", option).with("text", text);
            Failure::input(error.with_text("why", why))
        })
    };
    let range = match (&asked.arguments.from, &asked.arguments.to) {
        (Some(from), Some(to)) => [read("--from", from)?, read("--to", to)?],
        _ => {
            let around = if input.si == 0.0 { input.measure.own_unit().si(1.0) } else { input.si };
            input.range_around(around)
        }
    };
    if range[0] < range[1] {
        return Ok(range);
    }
    let [from, to] = range.map(|si| units::write_quantity(si, &input.unit, Locale::english().style));
    let why = Text::new(
        "the range from {from} to {to} of `{path}` is empty: write --from and --to in ascending order",
    );
    Err(Failure::input(why.with("from", from).with("to", to).with("path", asked.input)))
}

/// A value of an answer, in SI; a number alone is in its unit.
pub(super) fn value_of(answer: &Answer, text: &str) -> Result<f64, Text> {
    if text.is_empty() {
        let unit = answer.unit.ascii();
        return Err(Text::new("a value is missing; write one in {unit}, as in 1.5 {unit}").with("unit", unit));
    }
    Amount::Text(text.to_owned()).si(&answer.unit, Kind::of(&answer.unit))
}
