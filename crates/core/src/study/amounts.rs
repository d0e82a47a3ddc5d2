//! Amounts of a plan in the units of inputs.

use dalembert_units::{self as units, Unit};

use super::plan::{Amount, DataColumn};
use crate::{FieldError, Text, vary::VariedInput};

/// An amount of an input, in SI.
pub(super) fn amount(input: &VariedInput, path: &str, amount: &Amount) -> Result<f64, FieldError> {
    let si = amount.si(&input.unit, input.measure.kind()).map_err(|why| FieldError::new(path, why))?;
    if si.is_finite() { Ok(si) } else { Err(FieldError::new(path, "is not a finite number")) }
}

/// The unit of a column of a file, which must measure what the input does.
pub(super) fn unit_of(path: &str, column: &DataColumn, input: &VariedInput) -> Result<Unit, FieldError> {
    if column.unit.is_empty() {
        return Ok(input.unit.clone());
    }
    let unit = units::unit(&column.unit).ok().filter(|unit| unit.dim == input.unit.dim);
    unit.ok_or_else(|| {
        let why = Text::new("`{unit}` is no unit of `{input}`, which is in {own}")
            .with("unit", &column.unit)
            .with("input", &input.path)
            .with("own", input.unit.ascii());
        FieldError::new(path, why)
    })
}

/// An SI value in a unit, with the digits that were written where rounding has changed the last one.
pub(super) fn shown(unit: &Unit, si: f64) -> f64 {
    let value = unit.value(si);
    let written = format!("{value:.14e}").parse().unwrap_or(value);
    if unit.si(written) == si { written } else { value }
}
