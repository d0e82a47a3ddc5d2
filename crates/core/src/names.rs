//! Names of rows: those that others refer to by them, and references that follow a name.

use crate::{
    Draft, FieldError, Shape,
    path::{Segment, segments},
    within_problem,
};

impl Draft {
    /// Writes the text of a leaf. Where it is the name of a row that others refer to, they follow: to the new name, or to
    /// the number of the row where it has none any more. `shape` is that of the whole problem.
    pub fn write(&mut self, shape: &Shape, path: &str, text: String) -> Result<(), FieldError> {
        let (problem, inner) = within_problem(shape.fields(None), path);
        if !problem.is_empty() {
            // The names of a linked problem are its own.
            let (draft, shape) = self.at_mut(shape, problem)?;
            return draft.write(&shape, inner, text);
        }
        if let Some((list, row)) = named_row(path)
            && let Some(old) = self.name_that_is_one_row_s_alone(shape, &list, path)
        {
            let new = match text.trim() {
                "" => (row + 1).to_string(),
                name => name.to_owned(),
            };
            follow(self, shape, &list, &old, &new);
        }
        *self.at_mut(shape, path)?.0 = Draft::Leaf(text);
        Ok(())
    }

    /// Gives a copy of a row a name that none of the rows has: that of `rocker` is called `rocker 2`. Rows without a
    /// name have none to give. `shape` is that of a row.
    pub fn rename_among(&mut self, rows: &[Draft], shape: &Shape) {
        let name_of = |row: &Draft| match row.at(shape, "name") {
            Ok((Draft::Leaf(name), _)) if !name.trim().is_empty() => Some(name.trim().to_owned()),
            _ => None,
        };
        let Some(name) = name_of(self) else { return };
        let taken: Vec<String> = rows.iter().filter_map(name_of).collect();
        let stem = match name.rsplit_once(' ') {
            Some((stem, number)) if number.parse::<u32>().is_ok() => stem,
            _ => &name,
        };
        let free = (2..taken.len() + 3).map(|n| format!("{stem} {n}")).find(|name| !taken.contains(name));
        if let (Some(free), Ok((place, _))) = (free, self.at_mut(shape, "name")) {
            *place = Draft::Leaf(free);
        }
    }

    fn name_that_is_one_row_s_alone(&self, shape: &Shape, list: &str, path: &str) -> Option<String> {
        let (Draft::Leaf(name), _) = self.at(shape, path).ok()? else { return None };
        let (Draft::Rows(rows), _) = self.at(shape, list).ok()? else { return None };
        let same = (1..=rows.len())
            .filter_map(|row| self.at(shape, &format!("{list}[{row}].name")).ok())
            .filter(|(other, _)| matches!(other, Draft::Leaf(other) if other.trim() == name.trim()));
        (!name.trim().is_empty() && same.count() == 1).then(|| name.trim().to_owned())
    }
}

/// The top-level list and the place of the row whose name stands at a path.
fn named_row(path: &str) -> Option<(String, usize)> {
    match segments(path).ok()?.as_slice() {
        [Segment::Name(list), Segment::Row(row), Segment::Name(name)] if name == "name" => {
            Some((list.clone(), *row))
        }
        _ => None,
    }
}

fn follow(draft: &mut Draft, shape: &Shape, list: &str, old: &str, new: &str) {
    match (shape.present(), draft) {
        (Shape::Reference(of), Draft::Leaf(text)) if of == list && text.trim() == old => {
            new.clone_into(text);
        }
        (Shape::Group(fields), Draft::Group(drafts)) => {
            for (field, draft) in fields().iter().zip(drafts) {
                follow(draft, &field.shape, list, old, new);
            }
        }
        (Shape::OneOf(variants), Draft::OneOf(chosen, inner)) => {
            if let Some(variant) = variants().get(*chosen) {
                follow(inner, &Shape::Group(variant.fields), list, old, new);
            }
        }
        (Shape::Rows { item, .. }, Draft::Rows(rows)) => {
            for row in rows {
                follow(row, item(), list, old, new);
            }
        }
        _ => {}
    }
}
