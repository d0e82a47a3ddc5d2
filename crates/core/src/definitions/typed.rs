//! Definitions and questions of a draft, by their names.

use crate::{Draft, FieldError, Shape};

impl Draft {
    /// Defines a quantity by its name, or gives the definition of that name another formula. `shape` is that of the whole
    /// problem.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn define(&mut self, shape: &Shape, name: &str, formula: &str) -> Result<(), FieldError> {
        self.set_named(shape, "let", name, formula)
    }

    /// Asks a question, or gives the question of that name another formula. `shape` is that of the whole problem.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn ask(&mut self, shape: &Shape, name: &str, formula: &str) -> Result<(), FieldError> {
        self.set_named(shape, "ask", name, formula)
    }

    fn set_named(&mut self, shape: &Shape, list: &str, name: &str, formula: &str) -> Result<(), FieldError> {
        let (name, formula) = (name.trim(), formula.trim());
        let (Draft::Rows(rows), _) = self.at(shape, list)? else {
            return Err(FieldError::new(list, "is missing"));
        };
        let is_named = |row: &Draft| matches!(row, Draft::Group(parts) if parts.first() == Some(&Draft::Leaf(name.to_owned())));
        let row = rows.iter().position(is_named).unwrap_or(rows.len()) + 1;
        self.set(shape, &format!("{list}[{row}].name"), name)?;
        self.set(shape, &format!("{list}[{row}].formula"), formula)
    }
}
