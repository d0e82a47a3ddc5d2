//! Rows that are folded: only their headings are lines of the form.

use std::collections::BTreeSet;

use dalembert_core::{Draft, is_within};

use dalembert_core::form::summary;

use super::{Form, FormLine, Role};

impl Form {
    /// Every line of the part that is shown, those of folded rows among them.
    pub(super) fn all_lines(&self) -> Vec<FormLine> {
        self.lines_of(&self.part())
    }

    /// Returns true if the row of a path is collapsed.
    pub fn is_folded(&self, path: &str) -> bool {
        self.folded.contains(path)
    }

    /// Returns true if a path lies in a collapsed row.
    pub(super) fn is_hidden(&self, path: &str) -> bool {
        !self.folded.is_empty() && rows_around(path).any(|row| self.folded.contains(row))
    }

    /// Unfolds the rows that a path lies in.
    pub(super) fn reveal(&mut self, path: &str) {
        for row in rows_around(path) {
            self.folded.remove(row);
        }
    }

    /// The texts of what stands at a path, beside each other.
    pub fn summary(&self, path: &str) -> String {
        self.draft.at(&self.shape, path).map_or_else(|_| String::new(), |(draft, _)| summary(draft))
    }

    /// Folds the innermost row of the cursor that has lines of its own, or unfolds it.
    pub fn fold_row(&mut self) -> bool {
        let Some(row) = self.foldable_row() else { return false };
        if !self.folded.remove(&row) {
            self.folded.insert(row.clone());
        }
        self.go_to(&row);
        true
    }

    /// Folds every row of the list of the cursor, or unfolds them where all are folded.
    pub fn fold_rows(&mut self) -> bool {
        let Some(line) = self.line() else { return false };
        let row = self.foldable_row();
        let list = match (&line.role, &row) {
            (Role::Rows { .. }, _) => line.path.clone(),
            (_, Some(row)) => row[..row.rfind('[').unwrap_or(0)].to_owned(),
            _ => return false,
        };
        let Ok((Draft::Rows(rows), _)) = self.draft.at(&self.shape, &list) else { return false };
        let all = self.all_lines();
        let rows: BTreeSet<String> =
            (1..=rows.len()).map(|n| format!("{list}[{n}]")).filter(|row| has_lines(&all, row)).collect();
        if rows.is_empty() {
            return false;
        }
        if rows.is_subset(&self.folded) {
            self.folded.retain(|row| !rows.contains(row));
        } else {
            self.folded.extend(rows);
        }
        let at = match line.role {
            Role::Rows { .. } => line.path,
            _ => row.unwrap_or(line.path),
        };
        self.go_to(&at);
        true
    }

    /// Keeps rows of a list folded where they went: `to` says the new place of a place, both counted from 0.
    pub(super) fn renumber(&mut self, list: &str, to: impl Fn(usize) -> Option<usize>) {
        let moved = |path: &String| {
            let Some((row, rest)) =
                path.strip_prefix(list).and_then(|rest| rest.strip_prefix('[')?.split_once(']'))
            else {
                return Some(path.clone());
            };
            let row: usize = row.parse().ok()?;
            Some(format!("{list}[{}]{rest}", to(row.checked_sub(1)?)? + 1))
        };
        self.folded = self.folded.iter().filter_map(moved).collect();
    }

    fn foldable_row(&self) -> Option<String> {
        let path = self.line()?.path;
        let all = self.all_lines();
        let rows = rows_around(&path).chain([path.as_str()]);
        rows.filter(|row| row.ends_with(']') && has_lines(&all, row)).last().map(str::to_owned)
    }
}

/// The rows that a path lies in, from the outermost: `a[1].b[2].c` lies in `a[1]` and `a[1].b[2]`.
fn rows_around(path: &str) -> impl Iterator<Item = &str> {
    path.match_indices(']').map(|(at, _)| &path[..=at]).filter(move |row| row.len() < path.len())
}

/// Returns true if a row has lines below its heading.
fn has_lines(all: &[FormLine], row: &str) -> bool {
    all.iter().any(|line| line.path != row && is_within(&line.path, row))
}
