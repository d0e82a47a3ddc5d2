//! The tables themselves: a line is a key, what it does, and how that is called.

use ratatui::crossterm::event::{KeyCode, KeyModifiers};

use super::{Action, Binding, Key};

/// Keys of the list of analyses.
pub(super) const PICKER: &[Binding] = &[
    bind(Action::Enter, ENTER, "open; fold a heading", "open"),
    bind(Action::Filter, &[typed('/')], "type a filter", "filter"),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::Right, RIGHT, "open the heading, or to the published cases", ""),
    bind(Action::Left, LEFT, "fold the heading, or back to it", ""),
    bind(Action::NextPane, TAB, "to the published cases and back", "see cases"),
    bind(Action::PreviousPane, BACK_TAB, "to the list", ""),
    bind(Action::PinAnalysis, &[typed('*')], "pin at the head of the list, or no more", "pin it"),
    bind(Action::Toggle, &[typed(' ')], "mark an exercise as done, or as not done", "done"),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN, "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
    bind(Action::NextProblem, &[typed('b')], "back to the open problem", ""),
    bind(Action::Back, ESC, "one step back", ""),
];

/// Keys of the filter of the list.
pub(super) const FILTER: &[Binding] = &[
    bind(Action::Enter, ENTER, "open", "open"),
    bind(Action::Back, ESC, "drop the filter", "drop the filter"),
    bind(Action::Up, &[plain(KeyCode::Up)], "line up", ""),
    bind(Action::Down, &[plain(KeyCode::Down)], "line down", ""),
    bind(Action::NextPane, TAB, "to the list", "to the list"),
];

/// Keys of the inputs.
pub(super) const FORM: &[Binding] = &[
    bind(Action::Enter, &[plain(KeyCode::Enter), plain(KeyCode::F(2))], "edit or choose", "edit"),
    bind(Action::Clear, &[plain(KeyCode::Delete), plain(KeyCode::Backspace)], "empty the field and type", ""),
    bind(Action::NextPane, TAB, "to the results", "see results"),
    bind(Action::PreviousPane, BACK_TAB, "to the results, backwards", ""),
    bind(Action::NextUnit, &[typed('u')], "next unit", "unit"),
    bind(Action::Nudge(10), &[typed('+'), typed('=')], "last or chosen digit up", "nudge"),
    bind(Action::Nudge(-10), &[typed('-')], "last or chosen digit down", ""),
    bind(Action::Nudge(100), &[shift(KeyCode::Up)], "that digit up by ten", ""),
    bind(Action::Nudge(-100), &[shift(KeyCode::Down), typed('_')], "that digit down by ten", ""),
    bind(
        Action::Nudge(1),
        &[alt(KeyCode::Up), alt(KeyCode::Char('+')), alt(KeyCode::Char('='))],
        "a tenth of that digit up",
        "",
    ),
    bind(Action::Nudge(-1), &[alt(KeyCode::Down), alt(KeyCode::Char('-'))], "a tenth of that digit down", ""),
    bind(Action::Left, LEFT, "digit before, for + and -; alternative before", ""),
    bind(Action::Right, RIGHT, "next digit; next alternative", ""),
    bind(Action::Toggle, &[typed(' ')], "yes or no, in or out", ""),
    bind(Action::AddRow, &[typed('a')], "add a row", ""),
    bind(Action::DuplicateRow, &[typed('d')], "duplicate the row", ""),
    bind(Action::DeleteRow, &[typed('x')], "delete the row, or leave the input out", ""),
    bind(Action::MoveRowUp, &[typed('K')], "move the row up", ""),
    bind(Action::MoveRowDown, &[typed('J')], "move the row down", ""),
    bind(Action::FoldRow, &[typed('f')], "fold the row, or unfold it", ""),
    bind(Action::FoldRows, &[typed('F')], "fold every row of the list, or unfold them", ""),
    bind(Action::Import, &[typed('@')], "import a file into the table", ""),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN, "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
    bind(Action::Rename, &[typed('T')], "rename: give it a title", ""),
];

/// Keys while a field is typed in.
pub(super) const EDIT: &[Binding] = &[
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

/// Keys of answers, tables and sources.
pub(super) const RESULTS: &[Binding] = &[
    bind(Action::Enter, ENTER, "load the case", ""),
    bind(Action::NextDisplayUnit, &[typed('v')], "another unit of an answer", ""),
    bind(Action::NextDigits, &[typed('D')], "another number of digits of an answer", ""),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN_OR_SPACE, "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
];

/// Keys of the worked solution.
pub(super) const WORKING: &[Binding] = &[
    bind(Action::Reveal, &[typed(' ')], "reveal the next step; without covered ones, page down", "reveal"),
    bind(Action::Right, RIGHT, "next symbol", "symbols"),
    bind(Action::Left, LEFT, "symbol before", ""),
    bind(Action::Enter, ENTER, "to the step or input that the symbol comes from", "follow"),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN, "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
];

/// Keys of a plot.
pub(super) const PLOT: &[Binding] = &[
    bind(Action::Left, LEFT, "cursor of the plot to the left", ""),
    bind(Action::Right, RIGHT, "cursor of the plot to the right", ""),
    bind(Action::PageUp, PAGE_UP, "cursor of the plot far to the left", ""),
    bind(Action::PageDown, PAGE_DOWN_OR_SPACE, "cursor of the plot far to the right", ""),
    bind(Action::First, FIRST, "cursor of the plot to its beginning", ""),
    bind(Action::Last, LAST, "cursor of the plot to its end", ""),
    bind(Action::ZoomIn, &[typed('+'), typed('=')], "less of the axis, larger", "zoom"),
    bind(Action::ZoomOut, &[typed('-')], "more of the axis, smaller", ""),
    bind(Action::ZoomAll, &[typed('0')], "all of the axis", ""),
    bind(Action::PanLeft, &[typed('<'), shift(KeyCode::Left)], "what lies further left", "move"),
    bind(Action::PanRight, &[typed('>'), shift(KeyCode::Right)], "what lies further right", ""),
    bind(Action::NextSpread, &[typed('a')], "values linear, logarithmic, in decibels", "log dB"),
    bind(Action::NextSpreadAcross, &[typed('x')], "horizontal axis linear or logarithmic", ""),
    bind(Action::NextExhibit, &[typed('n')], "next plot or drawing", ""),
    bind(Action::NextMarker, &[typed('m')], "other marks for curves", ""),
];

/// Keys of a drawing or a film.
pub(super) const DRAWING: &[Binding] = &[
    bind(Action::Play, &[typed(' ')], "let a film move, or hold it", "film"),
    bind(Action::Left, LEFT, "round a scene in space, to its left", "go round"),
    bind(Action::Right, RIGHT, "round a scene in space, to its right", ""),
    bind(Action::Up, UP, "above a scene in space", ""),
    bind(Action::Down, DOWN, "below a scene in space", ""),
    bind(Action::UsualView, &[typed('i')], "a scene in space as it is usually seen", ""),
    bind(Action::NextExhibit, &[typed('n')], "next plot or drawing", ""),
];

/// Keys of the cells of a tab: of the person's own answers.
pub(super) const CELLS: &[Binding] = &[
    bind(Action::Enter, ENTER, "type in the cell, or choose", "type"),
    bind(Action::Clear, &[plain(KeyCode::Delete), plain(KeyCode::Backspace)], "empty the cell and type", ""),
    bind(Action::Left, LEFT, "another answer, or what may be chosen before", "choose"),
    bind(Action::Right, RIGHT, "another answer, or what may be chosen next", ""),
    bind(Action::Toggle, &[typed(' ')], "show our answer, or cover it", "show ours"),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN, "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
];

/// Keys while a cell is typed in.
pub(super) const CELL: &[Binding] = &[
    bind(Action::Enter, ENTER, "keep the text", "keep"),
    bind(Action::Back, ESC, "keep the text", ""),
    bind(
        Action::Down,
        &[plain(KeyCode::Down), plain(KeyCode::Tab)],
        "keep, and to the next cell",
        "next cell",
    ),
    bind(Action::Up, &[plain(KeyCode::Up), plain(KeyCode::BackTab)], "keep, and to the cell before", ""),
];

/// Keys of every pane of what was found.
pub const PANES: &[Binding] = &[
    bind(Action::NextPane, TAB, "to the inputs", "edit inputs"),
    bind(Action::PreviousPane, BACK_TAB, "to the inputs, backwards", ""),
    bind(Action::PreviousFrame, &[typed(',')], "the frame of a film before", "frames"),
    bind(Action::NextFrame, &[typed('.')], "the next frame of a film", ""),
];

/// Keys of a problem, wherever on its screen.
pub const PROBLEM: &[Binding] = &[
    bind(Action::NextTab, &[typed(']')], "next tab", "tabs"),
    bind(Action::PreviousTab, &[typed('[')], "tab before", ""),
    bind(Action::Undo, &[typed('z')], "undo", "undo"),
    bind(Action::Redo, &[typed('Z')], "redo", ""),
    bind(Action::TryByHand, &[typed('t')], "cover the results to try by hand, or show them", "try by hand"),
    bind(Action::Play, &[typed('p')], "let a film move, or hold it", "film"),
    bind(Action::Expand, &[typed('e')], "this pane alone, or all of them", "expand"),
    bind(Action::Pin, &[typed('c')], "compare with this result, or no more", "compare"),
    bind(Action::Save, &[typed('s'), ctrl('s')], "save", "save"),
    bind(Action::SaveAs, &[typed('S')], "save under another name", ""),
    bind(Action::Copy, &[typed('y')], "copy what the tab shows", "copy"),
    bind(Action::ExportSeen, &[typed('P')], "export the plot or drawing that is seen", "export"),
    bind(Action::Export, &[typed('X')], "export the worked solution", "export"),
    bind(Action::NextProblem, &[typed('b')], "next open problem", ""),
    bind(Action::CloseProblem, &[typed('B')], "close this problem", ""),
    bind(Action::Edit, &[typed('E')], "edit the problem in $EDITOR", ""),
    bind(Action::Back, ESC, "stop a solve that runs, or one step back", "back"),
];

/// Keys of a list to choose from.
pub(super) const LIST: &[Binding] = &[
    bind(Action::Enter, ENTER, "choose", "choose"),
    bind(Action::Back, ESC, "close", "close"),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
];

/// Keys of a text that is asked for, and of the palette.
pub(super) const PROMPT: &[Binding] = &[
    bind(Action::Enter, ENTER, "take it", "take it"),
    bind(Action::Back, ESC, "close", "close"),
    bind(
        Action::Down,
        &[plain(KeyCode::Tab), plain(KeyCode::Down)],
        "the next line; of a path, the next file or folder that is meant",
        "next",
    ),
    bind(Action::Up, &[plain(KeyCode::BackTab), plain(KeyCode::Up)], "the line before", ""),
];

/// Keys of a text of many lines.
pub(super) const SHEET: &[Binding] = &[
    bind(Action::Back, ESC, "keep and close", "keep and close"),
    bind(Action::GiveUp, &[ctrl('g')], "close, as it was before", "as before"),
];

/// Keys of the help.
pub(super) const HELP: &[Binding] = &[
    bind(
        Action::Back,
        &[plain(KeyCode::Esc), plain(KeyCode::Enter), typed('q'), typed('?')],
        "close",
        "close",
    ),
    bind(Action::Up, UP, "line up", ""),
    bind(Action::Down, DOWN, "line down", ""),
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN_OR_SPACE, "page down", ""),
    bind(Action::First, FIRST, "to the first line", ""),
    bind(Action::Last, LAST, "to the last line", ""),
];

/// Keys of every place where characters are no text.
pub const COMMON: &[Binding] = &[
    bind(Action::Help, &[typed('?')], "help", "help"),
    bind(Action::Palette, &[typed(':')], "every action by its name", "actions"),
    bind(Action::Open, &[typed('o')], "open a problem file", ""),
    bind(Action::Language, &[typed('L')], "em português", ""),
    bind(Action::Theme, &[], "theme: how things are coloured", ""),
    bind(Action::Mouse, &[], "mouse: take it, or leave it to the terminal", ""),
    bind(Action::Quit, &[typed('q')], "quit", "quit"),
];

/// Keys of every place.
pub const ALWAYS: &[Binding] = &[
    bind(Action::Help, &[plain(KeyCode::F(1))], "help", ""),
    bind(Action::Suspend, &[ctrl('z')], "to the shell; `fg` comes back", ""),
    bind(Action::Redraw, &[ctrl('l')], "draw the screen again", ""),
    bind(Action::Quit, &[ctrl('c')], "quit", ""),
];

const fn bind(action: Action, keys: &'static [Key], name: &'static str, hint: &'static str) -> Binding {
    Binding { action, keys, name, hint }
}

pub(super) const fn plain(code: KeyCode) -> Key {
    Key(code, KeyModifiers::NONE)
}

pub(super) const fn typed(character: char) -> Key {
    plain(KeyCode::Char(character))
}

pub(super) const fn ctrl(character: char) -> Key {
    Key(KeyCode::Char(character), KeyModifiers::CONTROL)
}

pub(super) const fn shift(code: KeyCode) -> Key {
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
const PAGE_DOWN_OR_SPACE: &[Key] = &[plain(KeyCode::PageDown), ctrl('d'), typed(' ')];
const FIRST: &[Key] = &[plain(KeyCode::Home), typed('g')];
const LAST: &[Key] = &[plain(KeyCode::End), typed('G')];
const TAB: &[Key] = &[plain(KeyCode::Tab)];
const BACK_TAB: &[Key] = &[plain(KeyCode::BackTab)];
const ENTER: &[Key] = &[plain(KeyCode::Enter)];
const ESC: &[Key] = &[plain(KeyCode::Esc)];
