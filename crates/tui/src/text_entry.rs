//! A line of text that is typed in: a proposal or an old value gives way to what is typed.

use tui_input::{Input, InputRequest};

/// A line of text with a cursor. While all of it is selected, a character replaces it and an arrow keeps it.
#[derive(Clone, Debug, Default)]
pub struct TextEntry {
    input: Input,
    is_selected: bool,
    /// The text that it began with.
    original: String,
}

impl TextEntry {
    /// An empty line, or a text that goes on at its end.
    pub fn new(text: impl Into<String>) -> Self {
        let text = text.into();
        Self { input: Input::new(text.clone()), is_selected: false, original: text }
    }

    /// A text that gives way to the first character typed.
    pub fn selected(text: impl Into<String>) -> Self {
        let entry = Self::new(text);
        Self { is_selected: !entry.original.is_empty(), ..entry }
    }

    /// The same in place of another text, which it began with.
    #[must_use]
    pub fn begun_from(self, original: String) -> Self {
        Self { original, ..self }
    }

    /// The text.
    pub fn value(&self) -> &str {
        self.input.value()
    }

    /// The text that it began with.
    pub fn original(&self) -> &str {
        &self.original
    }

    /// The text and the cursor, to be drawn.
    pub fn input(&self) -> &Input {
        &self.input
    }

    /// True if the text is another than it began with.
    pub fn is_changed(&self) -> bool {
        self.value() != self.original
    }

    /// True while all of it is selected.
    pub fn is_selected(&self) -> bool {
        self.is_selected
    }

    /// Does what a key asks for; whether the text is another then.
    pub fn handle(&mut self, request: InputRequest) -> bool {
        if std::mem::take(&mut self.is_selected) {
            match request {
                InputRequest::InsertChar(_) => self.input.reset(),
                InputRequest::DeletePrevChar
                | InputRequest::DeleteNextChar
                | InputRequest::DeletePrevWord
                | InputRequest::DeleteNextWord => {
                    self.input.reset();
                    return true;
                }
                _ => {}
            }
        }
        self.input.handle(request).is_some_and(|state| state.value)
    }

    /// Puts a text in place of the old one.
    pub fn replace(&mut self, text: String) {
        self.input = text.into();
        self.is_selected = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_character_replaces_what_is_selected_and_an_arrow_keeps_it() {
        let mut entry = TextEntry::selected("40 kg");
        assert!(entry.handle(InputRequest::InsertChar('5')));
        assert!(entry.handle(InputRequest::InsertChar('0')));
        assert_eq!(entry.value(), "50");
        let mut entry = TextEntry::selected("40 kg");
        assert!(!entry.handle(InputRequest::GoToPrevChar));
        assert!(entry.handle(InputRequest::InsertChar('k')));
        assert_eq!(entry.value(), "40 kkg");
        let mut entry = TextEntry::selected("40 kg");
        assert!(entry.handle(InputRequest::DeletePrevChar));
        assert_eq!((entry.value(), entry.original()), ("", "40 kg"));
        let mut entry = TextEntry::new("40 kg");
        assert!(entry.handle(InputRequest::DeletePrevChar));
        assert_eq!(entry.value(), "40 k");
    }
}
