//! Formulas in the cells of tables.

use dalembert_units::Dim;

use super::{
    Pending, Plan, PlannedInput, formula_of,
    names::{self, Names},
};
use crate::{
    FieldError, Number, Plain, Record, Shape, Stop, Symbol, Text,
    cell::{CellPlace, HeadingWords, of_line},
    formula::{Formula, FormulaError, Operand, evaluate},
    path::segments,
};

impl Plan {
    /// Takes the text of a cell for a formula. One without names is a number, in the unit of its column if it has none.
    pub(super) fn take_cell(
        &mut self,
        pending: Pending,
        names: &Names,
        record: &mut Record,
    ) -> Result<(), FieldError> {
        let Pending { path, text, error, cell } = pending;
        let Some(cell) = cell else { return Err(error) };
        let Some(mut input) = planned(&path, &cell, &error.path, names, record) else { return Err(error) };
        let table = error.path.clone();
        // The bytes that are wrong are those of the cell.
        let of_cell = |wrong: FormulaError| FieldError::new(&table, of_line(cell.line, wrong.why));
        let scope = input.scope;
        let parsed = Formula::parse(&text, &|name| names.contains(scope, name));
        if let Ok(formula) = &parsed
            && formula.names().is_empty()
        {
            input.value = Number::Scalar(constant(formula, &cell).map_err(of_cell)?);
            names::write(record, &path, super::value_of(&input));
            return Ok(());
        }
        let formula = formula_of(parsed, &text, scope, names);
        let formula = formula.map_err(|wrong| wrong.map_or(error, of_cell))?;
        input.formula = Some(formula);
        self.inputs.push(input);
        Ok(())
    }
}

impl Names {
    /// The refusal of a heading whose words are all names of definitions: it may be meant as the first row.
    pub(super) fn in_heading(&self, path: &str, heading: &HeadingWords) -> Option<FieldError> {
        let scope = self.scope_of_input(path);
        if !heading.cells.iter().all(|word| self.is_definition(scope, word)) {
            return None;
        }
        let why = Text::new(
            "a row of names without a number is a heading, but these are definitions: write 1*{first} for its value, or the units of a heading behind its names",
        );
        let first = heading.cells.first().map_or("", String::as_str);
        Some(FieldError::new(path, of_line(heading.line, why.with("first", first))))
    }
}

/// The cell at a path as an input.
fn planned(
    path: &str,
    cell: &CellPlace,
    error_path: &str,
    names: &Names,
    record: &mut Record,
) -> Option<PlannedInput> {
    let segments = segments(path).ok()?;
    let (_, shape, _) = record.place_mut(&segments)?;
    let Shape::Table(columns) = shape else { return None };
    let column = columns().get(cell.column)?;
    let measure = column.shape.measure()?.of(&cell.unit);
    let scope = names.scope_of_input(path);
    Some(PlannedInput {
        scope,
        inner: names.scopes[scope].inside(path).unwrap_or(path).to_owned(),
        path: path.to_owned(),
        error_path: error_path.to_owned(),
        label: column.label,
        symbol: Symbol::from(column.symbol).row(cell.row + 1),
        measure,
        components: 1,
        unit: cell.unit.clone(),
        value: Number::Scalar(f64::NAN),
        formula: None,
        is_cell: true,
    })
}

/// The value of a formula without names, in SI.
fn constant(formula: &Formula, cell: &CellPlace) -> Result<f64, FormulaError> {
    let stop = Stop::new();
    let plain = Plain::new(&stop);
    let found = evaluate::<&Plain<'_>>(formula, &|_| Ok(None), &|_| Vec::new(), &plain)?;
    let unit = &cell.unit;
    match found {
        Operand::Number(number, dim) if dim == Dim::NONE => Ok(unit.si(number)),
        Operand::Number(number, dim) if unit.dim.agrees(dim) => Ok(number),
        Operand::Number(_, dim) => {
            let why = crate::reading::of_another_dimension(&formula.text, dim, unit);
            Err(FormulaError { why, span: None })
        }
        _ => {
            let why = Text::new("`{text}` is no single number").with("text", &formula.text);
            Err(FormulaError { why, span: None })
        }
    }
}
