//! Warnings about assumed inputs, shown beside the answers.

use crate::{Record, Text, Value, gravity};

/// A warning for each table whose units nobody wrote, and for two values of gravity.
pub(crate) fn warnings(record: &Record) -> Vec<Text> {
    let mut warnings = Vec::new();
    record.leaves(&mut |_, field, value| {
        let Value::Table(table) = value else { return };
        let taken = table.units.iter().zip(&table.assumed).filter(|(_, assumed)| **assumed);
        let taken: Vec<String> = taken.map(|(unit, _)| unit.pretty()).collect();
        if !taken.is_empty() {
            let warning = Text::new("{table}: no unit in the heading; {units} assumed");
            warnings.push(warning.with_text("table", field.label).with("units", taken.join(", ")));
        }
    });
    warnings.extend(gravity::warning(record));
    warnings
}
