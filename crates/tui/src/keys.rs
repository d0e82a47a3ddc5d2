//! What keys mean: one table for each place where keys are typed.
//!
//! The footer, the help and the palette are made from these tables, so they cannot say anything else.

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// What a person wants when pressing a key.
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
    /// The next tab.
    NextTab,
    /// The tab before.
    PreviousTab,
    /// The next plot, drawing or table of the tab.
    NextExhibit,
    /// Another way to draw curves.
    NextMarker,
    /// Lets films move, or holds them.
    Play,
    /// Changes the last digit by so many tenths.
    Nudge(i64),
    /// The same quantity in the next unit.
    NextUnit,
    /// A row more, below this one.
    AddRow,
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
    /// Copies what the pane shows.
    Copy,
    /// Saves the problem.
    Save,
    /// Saves it under another name.
    SaveAs,
    /// Asks for the title of the problem.
    Rename,
    /// Opens a problem file.
    Open,
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
}

/// A line of a table: keys, what they do, and how that is called.
#[derive(Debug)]
pub struct Binding {
    /// What is done.
    pub action: Action,
    /// The keys that do it, the usual one first.
    pub keys: &'static [Key],
    /// The long name, in the help and the palette.
    pub name: &'static str,
    /// The short name, in the footer; empty where it does not belong there.
    pub hint: &'static str,
}

/// A key with its modifiers; Shift is part of a character.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key(pub KeyCode, pub KeyModifiers);

/// A place where keys are typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The list of analyses.
    Picker,
    /// Its filter.
    Filter,
    /// The inputs of a problem.
    Form,
    /// A field that is being typed in.
    Edit,
    /// What was found.
    Pane,
    /// A list to choose from.
    List,
    /// A line of text that is asked for.
    Prompt,
    /// A text of many lines.
    Sheet,
    /// The help.
    Help,
}

impl Place {
    /// Its table; for places with the common keys, [`COMMON`] comes after it.
    pub fn table(self) -> &'static [Binding] {
        match self {
            Place::Picker => PICKER,
            Place::Filter => FILTER,
            Place::Form => FORM,
            Place::Edit => EDIT,
            Place::Pane => PANE,
            Place::List => LIST,
            Place::Prompt => PROMPT,
            Place::Sheet => SHEET,
            Place::Help => HELP,
        }
    }

    /// Its name in the help.
    pub fn name(self) -> &'static str {
        match self {
            Place::Picker => "List of analyses",
            Place::Filter => "While typing a filter",
            Place::Form => "Inputs",
            Place::Edit => "While typing in a field",
            Place::Pane => "Results",
            Place::List => "Lists",
            Place::Prompt => "Asked for a text",
            Place::Sheet => "Text of many lines",
            Place::Help => "In this list of keys",
        }
    }

    /// Whether every character is text here.
    pub fn is_text(self) -> bool {
        matches!(self, Place::Filter | Place::Edit | Place::Prompt | Place::Sheet)
    }

    /// What a key means here.
    pub fn action(self, event: KeyEvent) -> Option<Action> {
        let key = Key::of(event);
        self.bindings().find(|binding| binding.keys.contains(&key)).map(|binding| binding.action)
    }

    /// Every binding that holds here, the most useful first.
    pub fn bindings(self) -> impl Iterator<Item = &'static Binding> {
        let common = match self {
            Place::Picker | Place::Form | Place::Pane => COMMON,
            _ => &[],
        };
        self.table().iter().chain(common).chain(ALWAYS)
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

    /// How it is written: `Ctrl-C`, `↑`, `Esc`.
    pub fn name(self) -> String {
        let mut name = String::new();
        for (modifier, text) in
            [(KeyModifiers::CONTROL, "Ctrl-"), (KeyModifiers::ALT, "Alt-"), (KeyModifiers::SHIFT, "Shift-")]
        {
            if self.1.contains(modifier) {
                name += text;
            }
        }
        name + &match self.0 {
            KeyCode::Char(' ') => "Space".to_owned(),
            KeyCode::Char(c) if self.1.contains(KeyModifiers::CONTROL) => c.to_uppercase().to_string(),
            KeyCode::Char(c) => c.to_string(),
            KeyCode::F(n) => format!("F{n}"),
            KeyCode::Up => "↑".into(),
            KeyCode::Down => "↓".into(),
            KeyCode::Left => "←".into(),
            KeyCode::Right => "→".into(),
            KeyCode::BackTab => "Shift-Tab".into(),
            KeyCode::PageUp => "PgUp".into(),
            KeyCode::PageDown => "PgDn".into(),
            KeyCode::Delete => "Del".into(),
            other => other.to_string(),
        }
    }
}

const fn bind(action: Action, keys: &'static [Key], name: &'static str, hint: &'static str) -> Binding {
    Binding { action, keys, name, hint }
}

const fn plain(code: KeyCode) -> Key {
    Key(code, KeyModifiers::NONE)
}

const fn typed(character: char) -> Key {
    plain(KeyCode::Char(character))
}

const fn ctrl(character: char) -> Key {
    Key(KeyCode::Char(character), KeyModifiers::CONTROL)
}

const fn shift(code: KeyCode) -> Key {
    Key(code, KeyModifiers::SHIFT)
}

const fn alt(code: KeyCode) -> Key {
    Key(code, KeyModifiers::ALT)
}

const UP: &[Key] = &[plain(KeyCode::Up), typed('k')];
const DOWN: &[Key] = &[plain(KeyCode::Down), typed('j')];
const LEFT: &[Key] = &[plain(KeyCode::Left), typed('h')];
const RIGHT: &[Key] = &[plain(KeyCode::Right), typed('l')];
const PAGE_UP: &[Key] = &[plain(KeyCode::PageUp), ctrl('u')];
const PAGE_DOWN: &[Key] = &[plain(KeyCode::PageDown), ctrl('d')];
const FIRST: &[Key] = &[plain(KeyCode::Home), typed('g')];
const LAST: &[Key] = &[plain(KeyCode::End), typed('G')];
const TAB: &[Key] = &[plain(KeyCode::Tab)];
const BACK_TAB: &[Key] = &[plain(KeyCode::BackTab)];
const ENTER: &[Key] = &[plain(KeyCode::Enter)];
const ESC: &[Key] = &[plain(KeyCode::Esc)];

/// Keys of the list of analyses.
pub const PICKER: &[Binding] = &[
    bind(Action::Enter, ENTER, "open", "open"),
    bind(Action::Filter, &[typed('/')], "type a filter", "filter"),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(
        Action::NextPane,
        &[plain(KeyCode::Tab), plain(KeyCode::Right), typed('l')],
        "to the published cases",
        "see cases",
    ),
    bind(
        Action::PreviousPane,
        &[plain(KeyCode::BackTab), plain(KeyCode::Left), typed('h')],
        "to the list",
        "",
    ),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN, "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
    bind(Action::Back, ESC, "one step back", ""),
];

/// Keys of the filter of the list.
pub const FILTER: &[Binding] = &[
    bind(Action::Enter, ENTER, "open", "open"),
    bind(Action::Back, ESC, "drop the filter", "drop the filter"),
    bind(Action::Up, &[plain(KeyCode::Up)], "line up", ""),
    bind(Action::Down, &[plain(KeyCode::Down)], "line down", ""),
    bind(Action::NextPane, TAB, "to the list", "to the list"),
];

/// Keys of the inputs.
pub const FORM: &[Binding] = &[
    bind(Action::Enter, &[plain(KeyCode::Enter), plain(KeyCode::F(2))], "edit or choose", "edit"),
    bind(Action::Clear, &[plain(KeyCode::Delete), plain(KeyCode::Backspace)], "empty the field and type", ""),
    bind(Action::NextPane, TAB, "to the results", "see results"),
    bind(Action::PreviousPane, BACK_TAB, "to the results, backwards", ""),
    bind(Action::NextTab, &[typed(']')], "next tab", "tabs"),
    bind(Action::NextUnit, &[typed('u')], "next unit", "unit"),
    bind(Action::Nudge(10), &[typed('+'), typed('=')], "last digit up", "nudge"),
    bind(Action::Nudge(-10), &[typed('-')], "last digit down", ""),
    bind(Action::Nudge(100), &[shift(KeyCode::Up)], "last digit up by ten", ""),
    bind(Action::Nudge(-100), &[shift(KeyCode::Down), typed('_')], "last digit down by ten", ""),
    bind(
        Action::Nudge(1),
        &[alt(KeyCode::Up), alt(KeyCode::Char('+')), alt(KeyCode::Char('='))],
        "a tenth of the last digit up",
        "",
    ),
    bind(
        Action::Nudge(-1),
        &[alt(KeyCode::Down), alt(KeyCode::Char('-'))],
        "a tenth of the last digit down",
        "",
    ),
    bind(Action::Left, LEFT, "alternative before", ""),
    bind(Action::Right, RIGHT, "next alternative", ""),
    bind(Action::Toggle, &[typed(' ')], "yes or no, in or out", ""),
    bind(Action::AddRow, &[typed('a')], "add a row", ""),
    bind(Action::DuplicateRow, &[typed('d')], "duplicate the row", ""),
    bind(Action::DeleteRow, &[typed('x')], "delete the row, or leave the input out", ""),
    bind(Action::MoveRowUp, &[typed('K')], "move the row up", ""),
    bind(Action::MoveRowDown, &[typed('J')], "move the row down", ""),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN, "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
    bind(Action::PreviousTab, &[typed('[')], "tab before", ""),
    bind(Action::Play, &[typed('p')], "let a film move, or hold it", ""),
    bind(Action::Undo, &[typed('z')], "undo", "undo"),
    bind(Action::Redo, &[typed('Z')], "redo", ""),
    bind(Action::Save, &[typed('s'), ctrl('s')], "save", "save"),
    bind(Action::SaveAs, &[typed('S')], "save under another name", ""),
    bind(Action::Rename, &[typed('T')], "rename: give it a title", ""),
    bind(Action::Copy, &[typed('y')], "copy what the tab shows", ""),
    bind(Action::Back, ESC, "one step back", ""),
];

/// Keys while a field is typed in.
pub const EDIT: &[Binding] = &[
    bind(Action::Enter, ENTER, "keep the text", "keep"),
    bind(Action::Back, ESC, "as it was before", "as before"),
    bind(
        Action::Down,
        &[plain(KeyCode::Down), plain(KeyCode::Tab)],
        "keep, and edit the next field",
        "next field",
    ),
    bind(Action::Up, &[plain(KeyCode::Up), plain(KeyCode::BackTab)], "keep, and edit the field before", ""),
];

/// Keys of the results.
pub const PANE: &[Binding] = &[
    bind(Action::NextTab, &[typed(']')], "next tab", "tabs"),
    bind(Action::PreviousTab, &[typed('[')], "tab before", ""),
    bind(Action::NextPane, TAB, "to the inputs", "edit inputs"),
    bind(Action::PreviousPane, BACK_TAB, "to the inputs, backwards", ""),
    bind(Action::Enter, ENTER, "load the case", ""),
    bind(Action::Copy, &[typed('y')], "copy what the tab shows", "copy"),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::Left, LEFT, "cursor of the plot to the left", ""),
    bind(Action::Right, RIGHT, "cursor of the plot to the right", ""),
    bind(Action::NextExhibit, &[typed('n')], "next plot, drawing or table", ""),
    bind(Action::NextMarker, &[typed('m')], "other marks for curves", ""),
    bind(Action::Play, &[typed('p')], "let a film move, or hold it", ""),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, &[plain(KeyCode::PageDown), ctrl('d'), typed(' ')], "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
    bind(Action::Undo, &[typed('z')], "undo", ""),
    bind(Action::Redo, &[typed('Z')], "redo", ""),
    bind(Action::Save, &[typed('s'), ctrl('s')], "save", ""),
    bind(Action::SaveAs, &[typed('S')], "save under another name", ""),
    bind(Action::Back, ESC, "one step back", "back"),
];

/// Keys of a list to choose from.
pub const LIST: &[Binding] = &[
    bind(Action::Enter, ENTER, "choose", "choose"),
    bind(Action::Back, ESC, "close", "close"),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
];

/// Keys of a text that is asked for, and of the palette.
pub const PROMPT: &[Binding] = &[
    bind(Action::Enter, ENTER, "take it", "take it"),
    bind(Action::Back, ESC, "close", "close"),
    bind(Action::Up, &[plain(KeyCode::Up), plain(KeyCode::BackTab)], "line up", ""),
    bind(Action::Down, &[plain(KeyCode::Down), plain(KeyCode::Tab)], "line down", ""),
];

/// Keys of a text of many lines.
pub const SHEET: &[Binding] = &[bind(Action::Back, ESC, "keep and close", "keep and close")];

/// Keys of the help.
pub const HELP: &[Binding] = &[
    bind(
        Action::Back,
        &[plain(KeyCode::Esc), plain(KeyCode::Enter), typed('q'), typed('?')],
        "close",
        "close",
    ),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, &[plain(KeyCode::PageDown), ctrl('d'), typed(' ')], "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
];

/// Keys of every place where characters are no text.
pub const COMMON: &[Binding] = &[
    bind(Action::Help, &[typed('?')], "help", "help"),
    bind(Action::Palette, &[typed(':')], "every action by its name", "actions"),
    bind(Action::Open, &[typed('o')], "open a problem file", ""),
    bind(Action::Language, &[typed('L')], "em português", ""),
    bind(Action::Quit, &[typed('q')], "quit", "quit"),
];

/// Keys of every place.
pub const ALWAYS: &[Binding] = &[
    bind(Action::Help, &[plain(KeyCode::F(1))], "help", ""),
    bind(Action::Suspend, &[ctrl('z')], "to the shell; `fg` comes back", ""),
    bind(Action::Redraw, &[ctrl('l')], "draw the screen again", ""),
    bind(Action::Quit, &[ctrl('c')], "quit", ""),
];

#[cfg(test)]
mod tests {
    use super::*;

    const PLACES: [Place; 9] = [
        Place::Picker,
        Place::Filter,
        Place::Form,
        Place::Edit,
        Place::Pane,
        Place::List,
        Place::Prompt,
        Place::Sheet,
        Place::Help,
    ];

    #[test]
    fn a_key_means_one_thing_in_a_place() {
        for place in PLACES {
            let mut seen: Vec<Key> = Vec::new();
            for key in place.bindings().flat_map(|binding| binding.keys) {
                assert!(!seen.contains(key), "{key:?} is there twice in {place:?}");
                seen.push(*key);
            }
        }
    }

    #[test]
    fn characters_are_text_where_text_is_typed() {
        for place in PLACES.into_iter().filter(|place| place.is_text()) {
            for character in ' '..='~' {
                let event = KeyEvent::new(KeyCode::Char(character), KeyModifiers::NONE);
                assert_eq!(place.action(event), None, "{character} in {place:?}");
            }
        }
    }

    #[test]
    fn escape_and_the_end_are_everywhere() {
        for place in PLACES {
            let of = |code, modifiers| place.action(KeyEvent::new(code, modifiers));
            assert_eq!(of(KeyCode::Esc, KeyModifiers::NONE), Some(Action::Back), "{place:?}");
            assert_eq!(of(KeyCode::Char('c'), KeyModifiers::CONTROL), Some(Action::Quit), "{place:?}");
        }
    }

    #[test]
    fn keys_are_named_as_they_are_printed() {
        assert_eq!(ctrl('c').name(), "Ctrl-C");
        assert_eq!(shift(KeyCode::Up).name(), "Shift-↑");
        assert_eq!(typed(' ').name(), "Space");
        assert_eq!(plain(KeyCode::F(1)).name(), "F1");
        let big = KeyEvent::new(KeyCode::Char('Z'), KeyModifiers::SHIFT);
        assert_eq!(Place::Form.action(big), Some(Action::Redo));
    }
}
