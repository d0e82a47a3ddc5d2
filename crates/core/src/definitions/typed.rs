//! Definitions, questions and given answers of a draft, by their names.

use super::fields::are_of_problem;
use crate::{Draft, FieldError, Shape};

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

    fn set_named(
        &mut self,
        shape: &Shape,
        [list, field]: [&str; 2],
        name: &str,
        text: &str,
    ) -> Result<(), FieldError> {
        let (name, text) = (name.trim(), text.trim());
        // Of a linked problem, behind its name: fan.bolt.
        let linked = name.split_once('.').filter(|(problem, _)| {
            let field = shape.fields(None).iter().find(|field| field.name == *problem);
            field.is_some_and(|field| are_of_problem(field.shape.fields(None)))
        });
        let (list, name) = match linked {
            Some((problem, name)) if list != "given" => (&*format!("{problem}.{list}"), name),
            _ => (list, name),
        };
        let (Draft::Rows(rows), _) = self.at(shape, list)? else {
            return Err(FieldError::new(list, "is missing"));
        };
        let is_named = |row: &Draft| matches!(row, Draft::Group(parts) if parts.first() == Some(&Draft::Leaf(name.to_owned())));
        let row = rows.iter().position(is_named).unwrap_or(rows.len()) + 1;
        self.set(shape, &format!("{list}[{row}].name"), name)?;
        self.set(shape, &format!("{list}[{row}].{field}"), text)
    }
}
