//! Changes of a form.

use dalembert_core::{
    Draft, FieldError, Locale, Shape,
    form::{alternative, insert_row, own_unit, put_in, rows_mut, settled, with_unit, written_unit},
};
use dalembert_report::{RequestError, typed};
use serde::Deserialize;

use crate::problem::Problem;

/// A change of a form: what is done, and where.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case")]
pub(crate) enum Change {
    /// Writes the text of an input, as a user of the language types it; a number alone keeps the unit that is there.
    Write { path: String, text: String },
    /// Chooses an alternative by its name. Texts of fields that both have are kept.
    Choose { path: String, text: String },
    /// Puts in an optional input.
    PutIn { path: String },
    /// Leaves out an optional input.
    LeaveOut { path: String },
    /// Adds a row at the end of a list.
    Add { path: String },
    /// Takes out a row, counted from 1.
    TakeOut { path: String, row: usize },
}

impl Change {
    /// Makes the change.
    ///
    /// # Errors
    /// Why it cannot be made.
    pub(crate) fn apply(self, problem: &mut Problem, locale: &Locale) -> Result<(), Vec<RequestError>> {
        let before = problem.file.draft.clone();
        let shape = problem.shape;
        let made = self.make(&mut problem.file.draft, &shape, locale);
        problem.file.draft.keep_first(&before, &shape);
        made.map_err(|error| problem.errors(&[error], locale))
    }

    fn make(self, draft: &mut Draft, shape: &Shape, locale: &Locale) -> Result<(), FieldError> {
        let impossible =
            |path: &str| FieldError::new(path, "is not an input of the problem with its present options");
        match self {
            Change::Write { path, text } => {
                let text = match draft.at(shape, &path) {
                    Ok((_, inner)) => {
                        let inner = inner.present();
                        let old = typed(draft, shape, &path);
                        let unit = written_unit(&old, &inner).or_else(|| own_unit(&inner));
                        with_unit(settled(text, &inner, locale.style.decimal), unit.as_ref(), &inner)
                    }
                    Err(_) => text,
                };
                draft.set(shape, &path, &text)
            }
            Change::Choose { path, text } => {
                let (old, inner) = draft.at(shape, &path)?;
                let inner = inner.present();
                let Shape::OneOf(variants) = inner else { return Err(impossible(&path)) };
                let to = variants().iter().position(|variant| variant.name == text);
                match to.map(|to| alternative(&inner, old, to)) {
                    // It says which names there are.
                    None => draft.set(shape, &path, &text),
                    Some(Some(new)) => {
                        *draft.at_mut(shape, &path)?.0 = new;
                        Ok(())
                    }
                    Some(None) => Ok(()),
                }
            }
            Change::PutIn { path } => put_in(draft, shape, &path).ok_or_else(|| impossible(&path)),
            Change::LeaveOut { path } => {
                *draft.at_mut(shape, &path)?.0 = Draft::Absent;
                Ok(())
            }
            Change::Add { path } => {
                let added = insert_row(draft, shape, &path, None);
                added.map(|_| ()).ok_or_else(|| impossible(&path))
            }
            Change::TakeOut { path, row } => {
                let rows = rows_mut(draft, shape, &path).map(|(rows, _)| rows);
                match rows.filter(|rows| (1..=rows.len()).contains(&row)) {
                    Some(rows) => {
                        rows.remove(row - 1);
                        Ok(())
                    }
                    None => Err(impossible(&path)),
                }
            }
        }
    }
}
