//! Key map: one table of bindings for each place where keys are typed.
//!
//! A [`KeyMap`] is these tables with the user's changes; the footer, the help and the palette are made from it, so
//! they cannot say anything else.

mod map;
mod names;
pub mod notation;
pub(crate) mod tables;

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

pub use map::{Bound, KeyChange, KeyMap};
pub use tables::{ALWAYS, COMMON, PANES, PROBLEM};
use tables::{
    CELL, CELLS, EDIT, FILTER, FORM, HELP, JOB, JOB_TEXT, LIST, PICKER, PLAN, PROMPT, RESULTS, SHEET,
};

/// Action of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// To the line above.
    Up,
    /// To the line below.
    Down,
    /// To the left: an alternative, a value of a plot.
    Left,
    /// To the right.
    Right,
    /// A screenful up.
    PageUp,
    /// A screenful down.
    PageDown,
    /// To the first line.
    First,
    /// To the last line.
    Last,
    /// To the other pane.
    NextPane,
    /// To the other pane, backwards.
    PreviousPane,
    /// Opens, edits or chooses what is under the cursor; ends an edit and keeps it.
    Enter,
    /// One step back.
    Back,
    /// Empties the field and begins to type.
    Clear,
    /// Yes or no; in or out.
    Toggle,
    /// The tab of a number.
    Tab(usize),
    /// The next tab.
    NextTab,
    /// The tab before.
    PreviousTab,
    /// The next problem or configuration of the file.
    NextFilePart,
    /// The problem or configuration before.
    PreviousFilePart,
    /// A linked problem more.
    BeginProblem,
    /// A configuration more, which changes nothing yet.
    BeginConfiguration,
    /// Takes the configuration or the linked problem that is shown out of the file.
    RemovePart,
    /// The next plot, drawing or table of the tab.
    NextExhibit,
    /// Another way to draw curves.
    NextMarker,
    /// To where a scene in space is usually seen from.
    UsualView,
    /// The repair that an error offers, in place of the wrong text.
    Repair,
    /// Less of the axis, larger.
    ZoomIn,
    /// More of the axis, smaller.
    ZoomOut,
    /// All of the axis.
    ZoomAll,
    /// Pan to the left.
    PanLeft,
    /// Pan to the right.
    PanRight,
    /// Linear, logarithmic, in decibels.
    NextSpread,
    /// The horizontal axis linear or logarithmic.
    NextSpreadAcross,
    /// Lets animations move, or holds them.
    Play,
    /// Holds the animation at the frame before.
    PreviousFrame,
    /// Holds the animation at the next frame.
    NextFrame,
    /// Covers what was found, to be found by hand first, or covers it no more.
    TryByHand,
    /// Uncovers the next step.
    Reveal,
    /// Compares everything from now on with the present result, or no more.
    Pin,
    /// The pane alone on the screen, or among the others.
    Expand,
    /// Changes the last digit by so many tenths.
    Nudge(i64),
    /// The same quantity in the next unit.
    NextUnit,
    /// This row as its heading alone, or with its lines again.
    FoldRow,
    /// Every row of the list.
    FoldRows,
    /// A file into the table.
    Import,
    /// Close, and leave everything as it was.
    GiveUp,
    /// A row more, below this one.
    AddRow,
    /// A definition more: a named quantity for formulas.
    Define,
    /// A question more: a formula over answers.
    Ask,
    /// A configuration more, in which this input is changed.
    Configure,
    /// The usual questions of the problem, to choose from.
    UsualQuestions,
    /// The next hint on the answer.
    NextHint,
    /// The statement of the exercise: read on, collapsed, expanded.
    Statement,
    /// A blank problem of the analysis.
    Blank,
    /// Makes the input unknown.
    Unknown,
    /// Gives the value of the answer, for an input that is unknown.
    Give,
    /// A copy of this row.
    DuplicateRow,
    /// Deletes this row, or leaves an optional input out.
    DeleteRow,
    /// This row one place up.
    MoveRowUp,
    /// This row one place down.
    MoveRowDown,
    /// Takes the last change back.
    Undo,
    /// Makes it again.
    Redo,
    /// The answer in its next unit.
    NextDisplayUnit,
    /// Everything in the next system of units.
    NextUnits,
    /// The answer with another number of digits.
    NextDigits,
    /// Copies what the pane shows.
    Copy,
    /// Saves the problem.
    Save,
    /// Saves it under another name.
    SaveAs,
    /// Writes the worked solution to a file.
    Export,
    /// Writes the plot or drawing that is seen to a file.
    ExportSeen,
    /// Asks for the title of the problem.
    Rename,
    /// Opens a problem file.
    Open,
    /// Shows the next open problem.
    NextProblem,
    /// Writes the plan of the study to a file.
    SavePlan,
    /// Reads the plan of a study from a file.
    OpenPlan,
    /// Closes the problem.
    CloseProblem,
    /// Puts the analysis at the head of the list, or no more.
    PinAnalysis,
    /// Types into the filter.
    Filter,
    /// The other language.
    Language,
    /// Shows what keys do.
    Help,
    /// Every action by its name.
    Palette,
    /// Leaves the program to the shell for a while.
    Suspend,
    /// Draws the screen again.
    Redraw,
    /// Ends the program.
    Quit,
    /// Opens the problem in the user's editor.
    Edit,
    /// Asks how things are to be coloured.
    Theme,
    /// Takes the mouse, or leaves it to the terminal.
    Mouse,
    /// A job of field balancing, step by step.
    FieldMode,
    /// The job as a problem of the workbench.
    Workbench,
}

/// A line of a table: keys, what they do, and how that is called.
#[derive(Debug, PartialEq, Eq)]
pub struct Binding {
    /// Action.
    pub action: Action,
    /// The keys that do it, the usual one first.
    pub keys: &'static [Key],
    /// The long name, in the help and the palette.
    pub name: &'static str,
    /// The short name, in the footer; empty where it does not belong there.
    pub hint: &'static str,
}

/// Bindings in the order of the help: runs of lines, of which tables share some.
pub type BindingTable = &'static [&'static [Binding]];

/// The keys of a pane that has a table of its own.
#[derive(Debug)]
pub struct PaneKeys {
    /// The name of its place in the settings.
    pub id: &'static str,
    /// The name of its place in the help.
    pub name: &'static str,
    /// The table.
    pub table: BindingTable,
}

impl PartialEq for PaneKeys {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for PaneKeys {}

/// A key with its modifiers; Shift is part of a character.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key(pub KeyCode, pub KeyModifiers);

/// A place where keys are typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeyContext {
    /// The list of analyses.
    Picker,
    /// Filter of the list.
    Filter,
    /// The inputs of a problem.
    Form,
    /// A field that is being typed in.
    Edit,
    /// A pane of what was found.
    Pane,
    /// A pane of what was found that has keys of its own.
    Own(&'static PaneKeys),
    /// A list to choose from.
    List,
    /// A line of text that is asked for.
    Prompt,
    /// A text of many lines.
    Sheet,
    /// The help.
    Help,
    /// The cells of a tab: answers to be checked.
    Cells,
    /// The plan of a study: cells, of which there may be more or less.
    Plan,
    /// A cell that is being typed in.
    Cell,
    /// A page of field mode.
    Job,
    /// A line of text of field mode.
    JobText,
}

impl KeyContext {
    /// Table of the place; shared bindings follow it, see [`bindings`](Self::bindings).
    pub fn table(self) -> BindingTable {
        match self {
            KeyContext::Picker => PICKER,
            KeyContext::Filter => FILTER,
            KeyContext::Form => FORM,
            KeyContext::Edit => EDIT,
            KeyContext::Pane => RESULTS,
            KeyContext::Own(keys) => keys.table,
            KeyContext::List => LIST,
            KeyContext::Prompt => PROMPT,
            KeyContext::Sheet => SHEET,
            KeyContext::Help => HELP,
            KeyContext::Cells => CELLS,
            KeyContext::Plan => PLAN,
            KeyContext::Cell => CELL,
            KeyContext::Job => JOB,
            KeyContext::JobText => JOB_TEXT,
        }
    }

    /// Name in the help.
    pub fn name(self) -> &'static str {
        match self {
            KeyContext::Picker => "List of analyses",
            KeyContext::Filter => "While typing a filter",
            KeyContext::Form => "Inputs",
            KeyContext::Edit => "While typing in a field",
            KeyContext::Pane => "Results",
            KeyContext::Own(keys) => keys.name,
            KeyContext::List => "Lists",
            KeyContext::Prompt => "Text prompt",
            KeyContext::Sheet => "Multi-line text",
            KeyContext::Help => "In this list",
            KeyContext::Cells => "Check, sensitivity",
            KeyContext::Plan => "Study",
            KeyContext::Cell => "While typing in a cell",
            KeyContext::Job => "Field balancing, step by step",
            KeyContext::JobText => "Field balancing, while typing",
        }
    }

    /// Returns true if every character is text here.
    pub fn is_text(self) -> bool {
        matches!(
            self,
            KeyContext::Filter
                | KeyContext::Edit
                | KeyContext::Prompt
                | KeyContext::Sheet
                | KeyContext::Help
                | KeyContext::Cell
                | KeyContext::JobText
        )
    }

    /// Returns true where the keys act on cells.
    pub fn has_cells(self) -> bool {
        matches!(self, KeyContext::Cells | KeyContext::Plan)
    }

    /// Returns true for one of the panes of the results.
    pub fn is_pane(self) -> bool {
        self.has_cells() || matches!(self, KeyContext::Pane | KeyContext::Own(_))
    }

    /// Every binding of the tables that holds here, the most useful first.
    pub fn bindings(self) -> impl Iterator<Item = &'static Binding> {
        let of = |holds: bool, table: &'static [Binding]| if holds { table } else { &[] };
        let in_problem = self.is_pane() || self == KeyContext::Form;
        self.table()
            .iter()
            .copied()
            .flatten()
            .chain(of(self.is_pane(), PANES))
            .chain(of(in_problem, PROBLEM))
            .chain(of(in_problem || matches!(self, KeyContext::Picker | KeyContext::Job), COMMON))
            .chain(ALWAYS)
    }
}

impl Key {
    /// The key of an event.
    pub fn of(event: KeyEvent) -> Self {
        let modifiers = match event.code {
            KeyCode::Char(_) | KeyCode::BackTab => event.modifiers.difference(KeyModifiers::SHIFT),
            _ => event.modifiers,
        };
        Key(event.code, modifiers)
    }

    /// Returns true if the key begins a number where one is expected.
    pub fn begins_a_number(self) -> bool {
        let begins = |c: char| c.is_ascii_digit() || matches!(c, '(' | '.' | ',' | '−' | '√');
        self.is_text() && matches!(self.0, KeyCode::Char(character) if begins(character))
    }

    /// Returns true if the key writes a character where text is typed.
    pub fn is_text(self) -> bool {
        matches!(self.0, KeyCode::Char(_)) && self.1.difference(KeyModifiers::SHIFT).is_empty()
    }
}

/// Returns true for Alt with a key of one byte. A terminal writes Alt as an escape before the key: where Alt with it means
/// nothing, neither as a key nor in a line of text, these were two keys that arrived together, as Esc and `:` do over a
/// slow line.
pub fn is_escape_and(key: KeyEvent) -> bool {
    key.modifiers.contains(KeyModifiers::ALT)
        && matches!(key.code, KeyCode::Char(_) | KeyCode::Enter | KeyCode::Tab | KeyCode::Backspace)
}

/// The place so many further than `at` among `of`, round and round.
pub(crate) fn turned(at: usize, by: isize, of: usize) -> usize {
    let last = of.saturating_sub(1);
    (at.min(last) as isize + by).rem_euclid(of.max(1) as isize) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::places;

    #[test]
    fn a_key_means_one_thing_in_a_place() {
        for place in places() {
            let mut seen: Vec<Key> = Vec::new();
            for key in place.bindings().flat_map(|binding| binding.keys) {
                assert!(!seen.contains(key), "{key:?} is there twice in {place:?}");
                seen.push(*key);
            }
        }
    }

    #[test]
    fn characters_are_text_where_text_is_typed() {
        for place in places().into_iter().filter(|place| place.is_text()) {
            for character in ' '..='~' {
                let event = KeyEvent::new(KeyCode::Char(character), KeyModifiers::NONE);
                assert_eq!(KeyMap::of(&places()).action(place, event), None, "{character} in {place:?}");
            }
        }
    }

    #[test]
    fn escape_and_the_end_are_everywhere() {
        for place in places() {
            let of = |code, modifiers| KeyMap::of(&places()).action(place, KeyEvent::new(code, modifiers));
            assert_eq!(of(KeyCode::Esc, KeyModifiers::NONE), Some(Action::Back), "{place:?}");
            assert_eq!(of(KeyCode::Char('c'), KeyModifiers::CONTROL), Some(Action::Quit), "{place:?}");
        }
    }

    #[test]
    fn shift_is_part_of_a_character() {
        let big = KeyEvent::new(KeyCode::Char('Z'), KeyModifiers::SHIFT);
        assert_eq!(KeyMap::of(&places()).action(KeyContext::Form, big), Some(Action::Redo));
    }
}
