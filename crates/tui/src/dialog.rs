//! Dialogs over a screen, which take the keys: help, palette, lists, questions.

mod names;
mod preview;

use std::path::PathBuf;

use dalembert_core::{Entry, Text, suggestions::Suggestion};
use tui_input::Input;

pub use names::Names;
pub use preview::ImportPreview;

use crate::{files::Crashed, keys::KeyContext, look::Theme, text_entry::TextEntry};

/// Dialog over a screen.
#[derive(Debug)]
pub enum Dialog {
    /// Keyboard shortcuts.
    Help {
        /// Words that keys are searched by.
        search: Input,
        /// The first line that is shown.
        scroll: usize,
    },
    /// Every action by its name.
    Palette {
        /// Text field.
        input: Input,
        /// The chosen line.
        chosen: usize,
    },
    /// Alternatives of a field.
    Choice {
        /// Path of the field.
        path: String,
        /// Options shown.
        options: Vec<Choice>,
        /// The chosen one.
        chosen: usize,
    },
    /// A line of text is asked for.
    Prompt {
        /// Purpose of the text.
        purpose: Purpose,
        /// Text that is typed; a proposal is selected.
        input: TextEntry,
        /// Error of the last text.
        error: Option<Text>,
        /// The files that may be meant, where it is the path of one.
        names: Names,
        /// The file that was read for a table, until it is taken or another is typed.
        preview: Option<Box<ImportPreview>>,
    },
    /// A question with a few answers.
    Ask {
        /// Question.
        question: Text,
        /// Possible answers with their consequences; dismissing the dialog is always possible.
        answers: Vec<(&'static str, Answer)>,
        /// The chosen one.
        chosen: usize,
    },
    /// Something to read.
    Message {
        /// The first line.
        title: Text,
        /// The others.
        lines: Vec<String>,
    },
    /// A table as text.
    Sheet(DialogContent),
}

/// An alternative.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Name for display.
    pub label: String,
    /// Explanation; may be empty.
    pub help: String,
    /// Value that it selects.
    pub value: Chosen,
}

/// Selected value.
#[derive(Clone, Debug)]
pub enum Chosen {
    /// An alternative of a one-of.
    Alternative(usize),
    /// A text.
    Text(String),
    /// A usual question.
    Question(Box<Suggestion>),
    /// A question of the user's own.
    OwnQuestion,
    /// An analysis, for a linked problem of that name.
    Analysis(String, &'static Entry),
    /// A word of the pane that showed the list.
    OfPane(String),
}

/// Purpose of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The path to save under.
    SaveAs,
    /// The path of the worked solution.
    Export,
    /// The path to open.
    Open,
    /// The title of the problem.
    Title,
    /// Name and analysis of a linked problem.
    LinkedProblem,
    /// Name of a configuration.
    Configuration,
    /// The path of the plot or drawing that is seen.
    ExportSeen,
    /// The path of the file that is read into the table under the cursor.
    Import,
    /// The path of the study plan to write.
    SavePlan,
    /// The path of the study plan to read.
    OpenPlan,
}

impl Purpose {
    /// Returns true if the text is a file path.
    pub fn is_path(self) -> bool {
        !matches!(self, Purpose::Title | Purpose::LinkedProblem | Purpose::Configuration)
    }
}

/// Consequence of an answer.
#[derive(Clone, Debug)]
pub enum Answer {
    /// Nothing.
    Cancel,
    /// Save unsaved work first.
    SaveThen(After),
    /// Unsaved work is given up.
    DiscardThen(After),
    /// The theme is taken.
    Theme(Theme),
    /// Edit the same text again.
    EditAgain(Editing),
    /// The copy that was edited is given up.
    DropCopy(PathBuf),
    /// The file is written over.
    Overwrite(PathBuf),
    /// Another name is asked for.
    SaveAs,
    /// Another name for what is exported is asked for.
    ExportAs(Purpose),
    /// Overwrite an existing file with the export.
    ExportOver(Purpose, PathBuf),
    /// The file is read again; changes are given up.
    Reload(PathBuf),
    /// The work of crashed sessions is taken up.
    Restore(Vec<Crashed>),
    /// The work of crashed sessions is removed.
    Forget(Vec<Crashed>),
}

/// A text of many lines that is edited.
#[derive(Clone, Debug)]
pub struct DialogContent {
    /// The field it belongs to.
    pub path: String,
    /// The lines; one at least.
    pub lines: Vec<String>,
    /// The line of the cursor.
    pub row: usize,
    /// The characters before the cursor.
    pub column: usize,
}

impl Dialog {
    /// Place of the key map in which keys are looked up.
    pub fn place(&self) -> KeyContext {
        match self {
            Dialog::Help { .. } | Dialog::Message { .. } => KeyContext::Help,
            Dialog::Palette { .. } | Dialog::Prompt { .. } => KeyContext::Prompt,
            Dialog::Choice { .. } | Dialog::Ask { .. } => KeyContext::List,
            Dialog::Sheet(_) => KeyContext::Sheet,
        }
    }

    /// A line of text is asked for; a proposal gives way to what is typed.
    pub fn prompt(purpose: Purpose, proposal: String) -> Self {
        Self::prompt_with(purpose, TextEntry::selected(proposal), None)
    }

    /// A line of text is asked for, and begun with.
    pub fn prompt_asking(purpose: Purpose, begun: &str) -> Self {
        Self::prompt_with(purpose, TextEntry::new(begun), None)
    }

    /// Prompt again, with an invalid text and its error.
    pub fn prompt_again(purpose: Purpose, typed: String, error: Text) -> Self {
        Self::prompt_with(purpose, TextEntry::new(typed), Some(error))
    }

    /// The file of a table is shown before it is taken; with an error, why it cannot be.
    pub fn preview(preview: ImportPreview, error: Option<Text>) -> Self {
        let input = TextEntry::new(&preview.typed);
        let (purpose, names) = (Purpose::Import, Names::default());
        Dialog::Prompt { purpose, input, error, names, preview: Some(Box::new(preview)) }
    }

    fn prompt_with(purpose: Purpose, input: TextEntry, error: Option<Text>) -> Self {
        Dialog::Prompt { purpose, input, error, names: Names::default(), preview: None }
    }

    /// The help, from its first line.
    pub fn help() -> Self {
        Dialog::Help { search: Input::default(), scroll: 0 }
    }

    /// An empty palette.
    pub fn palette() -> Self {
        Dialog::Palette { input: Input::default(), chosen: 0 }
    }
}

/// Action after unsaved work is saved or discarded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum After {
    /// Nothing more.
    #[default]
    Stay,
    /// The program ends.
    Quit,
    /// The problem is closed.
    Close,
}

/// Object edited in an external editor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Editing {
    /// The file of the problem.
    Own(PathBuf),
    /// A copy of the problem, of this text: it has no file, or is not what its file says.
    Text(String),
    /// Such a copy, at this place.
    Copy(PathBuf),
}

impl DialogContent {
    /// A text with the cursor at its beginning.
    pub fn new(path: String, text: &str) -> Self {
        let lines =
            if text.is_empty() { vec![String::new()] } else { text.lines().map(str::to_owned).collect() };
        Self { path, lines, row: 0, column: 0 }
    }

    /// The whole text.
    pub fn text(&self) -> String {
        self.lines.join("\n")
    }

    /// Puts a text in at the cursor.
    pub fn insert(&mut self, text: &str) {
        let at = self.byte();
        let Some(line) = self.lines.get_mut(self.row) else { return };
        let tail = line.split_off(at);
        let mut pieces = text.replace("\r\n", "\n").replace('\r', "\n");
        pieces.retain(|character| character == '\n' || character == '\t' || !character.is_control());
        let mut pieces = pieces.split('\n');
        line.push_str(pieces.next().unwrap_or_default());
        let more: Vec<String> = pieces.map(str::to_owned).collect();
        let below = self.row + 1;
        self.row += more.len();
        self.lines.splice(below..below, more);
        let line = &mut self.lines[self.row];
        self.column = line.chars().count();
        line.push_str(&tail);
    }

    /// Deletes the character before the cursor.
    pub fn delete_before(&mut self) {
        if self.column > 0 {
            self.column -= 1;
            self.delete_here();
        } else if self.row > 0 {
            let line = self.lines.remove(self.row);
            self.row -= 1;
            self.column = self.lines[self.row].chars().count();
            self.lines[self.row].push_str(&line);
        }
    }

    /// Deletes the character at the cursor.
    pub fn delete_here(&mut self) {
        let at = self.byte();
        if at < self.lines[self.row].len() {
            self.lines[self.row].remove(at);
        } else if self.row + 1 < self.lines.len() {
            let next = self.lines.remove(self.row + 1);
            self.lines[self.row].push_str(&next);
        }
    }

    /// Moves the cursor by so many lines and characters.
    pub fn step(&mut self, rows: isize, columns: isize) {
        self.row = self.row.saturating_add_signed(rows).min(self.lines.len() - 1);
        let length = self.lines[self.row].chars().count();
        self.column = self.column.min(length).saturating_add_signed(columns).min(length);
    }

    fn byte(&self) -> usize {
        let line = &self.lines[self.row];
        line.char_indices().nth(self.column).map_or(line.len(), |(at, _)| at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_is_edited_like_any_text() {
        let mut sheet = DialogContent::new("table".into(), "1; 2\n3; 4");
        sheet.step(1, 0);
        sheet.step(0, 4);
        sheet.insert("\n5; 6\r\n7");
        assert_eq!(sheet.text(), "1; 2\n3; 4\n5; 6\n7");
        assert_eq!((sheet.row, sheet.column), (3, 1));
        sheet.delete_before();
        sheet.delete_before();
        assert_eq!(sheet.text(), "1; 2\n3; 4\n5; 6");
        sheet.step(-2, 0);
        sheet.step(0, -9);
        sheet.delete_here();
        assert_eq!(sheet.text(), "; 2\n3; 4\n5; 6");
        sheet.step(0, 99);
        sheet.delete_here();
        assert_eq!(sheet.text(), "; 23; 4\n5; 6");
    }
}
