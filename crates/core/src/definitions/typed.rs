//! Definitions, questions and given answers of a draft, by their names.

use dalembert_units::{self as units, Style};

use super::{
    fields::{are_of_problem, within_problem},
    unknowns::split_tolerance,
};
use crate::{Determined, Draft, FieldError, Shape};

impl Draft {
    /// Defines a quantity by its name, or gives the definition of that name another formula. `shape` is that of the whole
    /// problem.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn define(&mut self, shape: &Shape, name: &str, formula: &str) -> Result<(), FieldError> {
        self.set_named(shape, ["let", "formula"], name, formula)
    }

    /// Asks a question, or gives the question of that name another formula. `shape` is that of the whole problem.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn ask(&mut self, shape: &Shape, name: &str, formula: &str) -> Result<(), FieldError> {
        self.set_named(shape, ["ask", "formula"], name, formula)
    }

    /// Gives the value of an answer, or another value to the one that is given. `shape` is that of the whole problem.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn give(&mut self, shape: &Shape, name: &str, value: &str) -> Result<(), FieldError> {
        self.set_named(shape, ["given", "value"], name, value)
    }

    /// Replaces the unknowns by the values that were found, each with its tolerance, and asks for nothing to be found.
    /// `shape` is that of the whole problem.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn take_found(&mut self, shape: &Shape, found: &Determined) -> Result<(), FieldError> {
        let style = Style { digits: 15, ascii: true, ..Style::default() };
        let values = found.solutions.first().into_iter().flatten();
        for (unknown, si) in found.unknowns.iter().zip(values) {
            let mut text = units::write_quantity(*si, &unknown.unit, style);
            match self.at(shape, &unknown.name) {
                Ok((Draft::Leaf(typed), _)) => {
                    if let (_, Some(tolerance)) = split_tolerance(typed) {
                        text = format!("{text} ± {tolerance}");
                    }
                    self.set(shape, &unknown.name, &text)?;
                }
                Ok(_) => self.set(shape, &unknown.name, &text)?,
                Err(_) => self.define(shape, &unknown.name, &text)?,
            }
        }
        self.forget_givens(shape);
        Ok(())
    }

    fn forget_givens(&mut self, shape: &Shape) {
        let (Shape::Group(fields), Draft::Group(all)) = (shape.present(), self) else { return };
        for (field, draft) in fields().iter().zip(all) {
            if field.name == "given" {
                *draft = Draft::Rows(Vec::new());
            } else if are_of_problem(field.shape.fields(None)) {
                draft.forget_givens(&field.shape);
            }
        }
    }

    /// Changes an input in a configuration, `weighted.mass`, or gives it another formula there. `shape` is that of the
    /// whole problem.
    ///
    /// # Errors
    /// A name that is none of a configuration and an input; as [`set`](Self::set).
    pub fn configure(&mut self, shape: &Shape, name: &str, formula: &str) -> Result<(), FieldError> {
        let (problem, name) = within_problem(shape.fields(None), name.trim());
        let Some((configuration, input)) = name.split_once('.') else {
            let why = "a configuration and an input are needed, as in weighted.mass";
            return Err(FieldError::new(name, why));
        };
        let list = inside(problem, "configuration");
        let (Draft::Rows(rows), _) = self.at(shape, &list)? else {
            return Err(FieldError::new(list, "is missing"));
        };
        let leaf = |text: &str| Draft::Leaf(text.to_owned());
        let is_it = |row: &Draft| matches!(row, Draft::Group(parts) if parts.starts_with(&[leaf(configuration), leaf(input)]));
        let row = rows.iter().position(is_it).unwrap_or(rows.len()) + 1;
        for (field, text) in [("name", configuration), ("input", input), ("formula", formula.trim())] {
            self.set(shape, &format!("{list}[{row}].{field}"), text)?;
        }
        Ok(())
    }

    fn set_named(
        &mut self,
        shape: &Shape,
        [list, field]: [&str; 2],
        name: &str,
        text: &str,
    ) -> Result<(), FieldError> {
        let (name, text) = (name.trim(), text.trim());
        let (problem, name) =
            if list == "given" { ("", name) } else { within_problem(shape.fields(None), name) };
        let list = inside(problem, list);
        let (Draft::Rows(rows), _) = self.at(shape, &list)? else {
            return Err(FieldError::new(list, "is missing"));
        };
        let is_named = |row: &Draft| matches!(row, Draft::Group(parts) if parts.first() == Some(&Draft::Leaf(name.to_owned())));
        let row = rows.iter().position(is_named).unwrap_or(rows.len()) + 1;
        self.set(shape, &format!("{list}[{row}].name"), name)?;
        self.set(shape, &format!("{list}[{row}].{field}"), text)
    }
}

fn inside(problem: &str, list: &str) -> String {
    if problem.is_empty() { list.to_owned() } else { format!("{problem}.{list}") }
}
