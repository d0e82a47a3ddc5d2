//! Typing in a field.

use dalembert_core::{
    Draft, Shape,
    form::{own_unit, with_unit, written_unit},
};
use dalembert_units::{Decimal, Unit};
use tui_input::InputRequest;

use super::{Change, Form, FormLine, Role, Snapshot, in_language, parts::Target, settled};
use crate::text_entry::TextEntry;

/// A field that is being typed in.
#[derive(Clone, Debug)]
pub struct Edit {
    /// Path of the field.
    pub path: String,
    /// The text and the cursor in it.
    pub input: TextEntry,
    /// Place of the text.
    target: Target,
    /// Everything as it was before.
    before: Draft,
    /// The unit of a number that is typed alone: the one that the field showed, or its own.
    unit: Option<Unit>,
}

/// A sign that was typed on a field, where it means more or less: a number that follows at once begins with it.
#[derive(Clone, Debug)]
pub struct Sign {
    character: char,
    path: String,
    /// Everything as it was before.
    before: Draft,
}

impl Form {
    /// Begins to type in the field under the cursor, in its text, with the decimal mark of the language, or in another one.
    pub fn begin(&mut self, text: Option<String>, decimal: Decimal) -> bool {
        let Some(FormLine { path, role: Role::Leaf { text: old, shape }, .. }) = self.line() else {
            return false;
        };
        let replaced = text.is_some();
        let unit = written_unit(&old, &shape).or_else(|| own_unit(&shape));
        let input =
            text.map_or_else(|| TextEntry::selected(in_language(&old, &shape, decimal)), TextEntry::new);
        let target = self.target(&path);
        self.edit = Some(Edit { path, input, target, before: self.draft.clone(), unit });
        if replaced {
            self.typed(Decimal::Point);
        }
        true
    }

    /// Begins a number in the field under the cursor with its first character, after the sign that was typed just
    /// before; whether a number can be typed there.
    pub fn begin_number(&mut self, character: char, sign: Option<Sign>, decimal: Decimal) -> bool {
        match self.line().map(|line| line.role) {
            Some(Role::Leaf { shape: Shape::Flag, .. }) => return false,
            Some(Role::Leaf { shape: Shape::Reference(list), .. }) if !self.names(list).is_empty() => {
                return false;
            }
            Some(Role::Leaf { .. }) => {}
            _ => return false,
        }
        let sign = sign.and_then(|sign| self.take_back(sign));
        self.begin(Some(String::new()), decimal);
        let Some(edit) = &mut self.edit else { return false };
        for character in sign.into_iter().chain([character]) {
            edit.input.handle(InputRequest::InsertChar(character));
        }
        self.typed(decimal);
        true
    }

    /// Takes the text of the edit into the draft, with a decimal point: a number alone in the unit that was there.
    pub fn typed(&mut self, decimal: Decimal) {
        let Some(edit) = &self.edit else { return };
        // From how it was before: what follows a name follows from what the row was called then.
        self.draft.clone_from(&edit.before);
        let text = edit.input.value().to_owned();
        let text = match self.draft.at(&self.shape, &edit.path) {
            Ok((_, shape)) => {
                let shape = shape.present();
                with_unit(settled(text, &shape, decimal), edit.unit.as_ref(), &shape)
            }
            Err(_) => text,
        };
        // What is edited is a leaf of the draft.
        let _ = edit.target.write(&mut self.draft, &self.shape, text);
        self.draft.keep_first(&edit.before, &self.shape);
    }

    /// Ends the edit and keeps its text.
    pub fn keep(&mut self) {
        if let Some(edit) = self.edit.take()
            && edit.before != self.draft
        {
            self.remember(Snapshot { entry: self.entry, draft: edit.before }, Change::Other);
        }
    }

    /// Ends the edit; everything is as it was before.
    pub fn drop_edit(&mut self) {
        if let Some(edit) = self.edit.take() {
            self.draft = edit.before;
        }
    }

    /// The unit of a number that is typed alone on this line.
    pub fn unit_of_number(&self, line: &FormLine) -> Option<Unit> {
        let Role::Leaf { text, shape } = &line.role else { return None };
        match self.edit.as_ref().filter(|edit| edit.path == line.path) {
            Some(edit) => edit.unit.clone(),
            None => written_unit(text, shape).or_else(|| own_unit(shape)),
        }
    }

    /// A sign that is about to be taken for more or less.
    pub fn sign_typed(&self, character: char) -> Option<Sign> {
        let path = self.line()?.path;
        Some(Sign { character, path, before: self.draft.clone() })
    }

    /// Takes back what a sign did to the field under the cursor; answers the sign.
    pub fn take_back(&mut self, sign: Sign) -> Option<char> {
        if self.line().is_none_or(|line| line.path != sign.path) {
            return None;
        }
        if self.undo.last().is_some_and(|last| last.draft == sign.before) {
            self.undo.pop();
            self.last = None;
        }
        self.draft = sign.before;
        Some(sign.character)
    }
}
