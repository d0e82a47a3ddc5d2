//! The tables themselves: a line is a key, what it does, and how that is called.

use ratatui::crossterm::event::{KeyCode, KeyModifiers};

use super::{Action, Binding, BindingTable, Key};

/// Line by line.
pub(crate) const LINES: &[Binding] =
    &[bind(Action::Up, UP, "line up", ""), bind(Action::Down, DOWN, "line down", "")];

/// Page by page.
pub(crate) const PAGES: &[Binding] =
    &[bind(Action::PageUp, PAGE_UP, "page up", ""), bind(Action::PageDown, PAGE_DOWN, "page down", "")];

/// Page by page, where a space is one too.
pub(crate) const PAGES_BY_SPACE: &[Binding] = &[
    bind(Action::PageUp, PAGE_UP, "page up", ""),
    bind(Action::PageDown, PAGE_DOWN_OR_SPACE, "page down", ""),
];

/// To the ends.
pub(crate) const ENDS: &[Binding] =
    &[bind(Action::First, FIRST, "to the first line", ""), bind(Action::Last, LAST, "to the last line", "")];

/// Keys of the list of analyses.
pub(super) const PICKER: BindingTable = &[
    &[
        bind(Action::Enter, ENTER, "open; expand or collapse a heading", "open"),
        bind(Action::Filter, &[typed('/')], "search", "search"),
    ],
    LINES,
    &[
        bind(Action::Right, RIGHT, "expand the heading, or to the published cases", ""),
        bind(Action::Left, LEFT, "collapse the heading, or back to it", ""),
        bind(Action::NextPane, TAB, "to the published cases, and back", "see cases"),
        bind(Action::PreviousPane, BACK_TAB, "to the list", ""),
        bind(Action::PinAnalysis, &[typed('*')], "pin at the top of the list, or unpin", "pin/unpin"),
        bind(Action::Toggle, &[typed(' ')], "tick or untick an exercise", "done"),
        bind(Action::Blank, BLANK, "blank problem: every input empty", "blank"),
    ],
    PAGES,
    ENDS,
    &[
        bind(Action::NextProblem, &[typed('b')], "back to the open problem", ""),
        bind(Action::Back, ESC, "back", ""),
    ],
];

/// Keys of the filter of the list.
pub(super) const FILTER: BindingTable = &[&[
    bind(Action::Enter, ENTER, "open; expand or collapse a heading", "open"),
    bind(Action::Back, ESC, "clear the search and leave its line", "leave the search"),
    bind(Action::Up, &[plain(KeyCode::Up)], "line up", ""),
    bind(Action::Down, &[plain(KeyCode::Down)], "line down", ""),
    bind(Action::Right, &[plain(KeyCode::Right)], "expand the heading, or to the published cases", ""),
    bind(Action::Left, &[plain(KeyCode::Left)], "collapse the heading, or back to it", ""),
    bind(Action::PageUp, &[plain(KeyCode::PageUp)], "page up", ""),
    bind(Action::PageDown, &[plain(KeyCode::PageDown)], "page down", ""),
    bind(Action::NextPane, TAB, "to the published cases, and back", "see cases"),
    bind(Action::Blank, BLANK, "blank problem: every input empty", ""),
]];

/// Keys of the inputs.
pub(super) const FORM: BindingTable = &[
    &[
        bind(Action::Enter, &[plain(KeyCode::Enter), plain(KeyCode::F(2))], "edit or choose", "edit"),
        bind(Action::Clear, &[plain(KeyCode::Delete), plain(KeyCode::Backspace)], "clear and edit", ""),
        bind(Action::NextPane, TAB, "to the results", "see results"),
        bind(Action::PreviousPane, BACK_TAB, "to the results (reverse)", ""),
        bind(Action::Repair, &[typed('r'), ctrl('r')], "write what the error suggests", "repair"),
        bind(Action::NextUnit, &[typed('u')], "next unit", "unit"),
        bind(Action::Nudge(10), &[typed('+'), typed('=')], "increase the last (or selected) digit", "adjust"),
        bind(Action::Nudge(-10), &[typed('-')], "decrease the last (or selected) digit", ""),
        bind(Action::Nudge(100), &[shift(KeyCode::Up)], "increase by ten of that digit", ""),
        bind(Action::Nudge(-100), &[shift(KeyCode::Down), typed('_')], "decrease by ten of that digit", ""),
        bind(
            Action::Nudge(1),
            &[alt(KeyCode::Up), alt(KeyCode::Char('+')), alt(KeyCode::Char('='))],
            "increase by a tenth of that digit",
            "",
        ),
        bind(
            Action::Nudge(-1),
            &[alt(KeyCode::Down), alt(KeyCode::Char('-'))],
            "decrease by a tenth of that digit",
            "",
        ),
        bind(Action::Left, LEFT, "select digit to the left; previous option", ""),
        bind(Action::Right, RIGHT, "select digit to the right; next option", ""),
        bind(Action::Toggle, &[typed(' ')], "toggle yes/no; include or omit", ""),
        bind(Action::AddRow, &[typed('a')], "add a row", ""),
        bind(Action::DuplicateRow, &[typed('d')], "duplicate the row", ""),
        bind(Action::Define, &[typed('N')], "define a quantity", ""),
        bind(Action::Ask, &[typed('A')], "ask for a quantity", ""),
        bind(Action::Configure, &[typed('C')], "change this input in a configuration", ""),
        bind(Action::Unknown, &[typed('U')], "find this input from given answers", ""),
        bind(Action::DeleteRow, &[typed('x')], "delete the row, or omit the input", ""),
        bind(Action::MoveRowUp, &[typed('K')], "move the row up", ""),
        bind(Action::MoveRowDown, &[typed('J')], "move the row down", ""),
        bind(Action::FoldRow, &[typed('f')], "collapse or expand the row", ""),
        bind(Action::FoldRows, &[typed('F')], "collapse or expand all rows of the list", ""),
        bind(Action::Import, &[typed('@')], "import a file into the table", ""),
        bind(Action::Statement, &[typed('i')], "read the statement on; collapse or expand it", "statement"),
    ],
    LINES,
    PAGES,
    ENDS,
    &[bind(Action::Rename, &[typed('T')], "rename (set the title)", "")],
];

/// Keys while a field is typed in.
pub(super) const EDIT: BindingTable = &[&[
    bind(Action::Enter, ENTER, "accept", "keep"),
    bind(Action::Back, ESC, "cancel", "cancel"),
    bind(Action::Repair, &[ctrl('r')], "write what the error suggests", "repair"),
    bind(
        Action::Down,
        &[plain(KeyCode::Down), plain(KeyCode::Tab)],
        "accept and edit the next field",
        "next field",
    ),
    bind(
        Action::Up,
        &[plain(KeyCode::Up), plain(KeyCode::BackTab)],
        "accept and edit the previous field",
        "",
    ),
]];

/// Keys of a pane that has no table of its own.
pub(super) const RESULTS: BindingTable = &[
    &[
        bind(
            Action::Enter,
            ENTER,
            "show all checks and lists; working of the chosen answer alone; load the case",
            "",
        ),
        bind(Action::NextDisplayUnit, &[typed('v')], "change the unit of an answer", ""),
        bind(Action::NextDigits, &[typed('D')], "change the digits of an answer", ""),
        bind(Action::UsualQuestions, &[typed('a')], "ask a usual question, or one of your own", ""),
        bind(Action::Give, &[typed('=')], "give the value of an answer, to find an input", ""),
    ],
    LINES,
    PAGES_BY_SPACE,
    ENDS,
];

/// Keys of the cells of a tab: of the user's own answers.
pub(super) const CELLS: BindingTable = &[
    &[
        bind(Action::Enter, ENTER, "edit the cell, or choose", "type"),
        bind(
            Action::Clear,
            &[plain(KeyCode::Delete), plain(KeyCode::Backspace)],
            "clear the cell and edit",
            "",
        ),
        bind(Action::Left, LEFT, "previous answer or option", "choose"),
        bind(Action::Right, RIGHT, "next answer or option", ""),
        bind(
            Action::NextHint,
            &[typed('H')],
            "next hint on the answer: principle, formulas, numbers",
            "hint",
        ),
        bind(Action::Toggle, &[typed(' ')], "show or hide the reference value", "show reference"),
        bind(Action::Statement, &[typed('i')], "read the statement on; collapse or expand it", "statement"),
    ],
    LINES,
    PAGES,
    ENDS,
];

/// Keys of the plan of a study.
pub(super) const PLAN: BindingTable = &[
    &[
        bind(Action::Enter, ENTER, "edit the line, or choose", "edit"),
        bind(
            Action::Clear,
            &[plain(KeyCode::Delete), plain(KeyCode::Backspace)],
            "clear the line and edit",
            "",
        ),
        bind(Action::Left, LEFT, "previous kind of study, answer, input", "choose"),
        bind(Action::Right, RIGHT, "next kind of study, answer, input", ""),
        bind(
            Action::Toggle,
            &[typed(' ')],
            "how the input varies: range, list, distribution",
            "how it varies",
        ),
        bind(Action::AddRow, &[typed('a')], "add an input, an answer, a limit, a condition", "add"),
        bind(Action::DeleteRow, &[typed('x')], "remove the line; on the first, everything typed", ""),
        bind(Action::MoveRowUp, &[typed('K')], "move the input up: the first of a grid varies slowest", ""),
        bind(Action::MoveRowDown, &[typed('J')], "move the input down", ""),
        bind(
            Action::SavePlan,
            &[typed('w')],
            "write the study plan to a file, for `dalembert study`",
            "write plan",
        ),
        bind(Action::OpenPlan, &[typed('r')], "read a study plan from a file", "read plan"),
    ],
    LINES,
    PAGES,
    ENDS,
];

/// Keys while a cell is typed in.
pub(super) const CELL: BindingTable = &[&[
    bind(Action::Enter, ENTER, "accept", "keep"),
    bind(Action::Back, ESC, "cancel", "cancel"),
    bind(Action::Down, &[plain(KeyCode::Down), plain(KeyCode::Tab)], "accept, next cell", "next cell"),
    bind(Action::Up, &[plain(KeyCode::Up), plain(KeyCode::BackTab)], "accept, previous cell", ""),
]];

/// Keys of every pane of what was found.
pub const PANES: &[Binding] = &[
    bind(Action::NextPane, TAB, "to the inputs", "edit inputs"),
    bind(Action::PreviousPane, BACK_TAB, "to the inputs (reverse)", ""),
    bind(Action::PreviousFrame, &[typed(',')], "previous frame", "frames"),
    bind(Action::NextFrame, &[typed('.')], "next frame", ""),
];

/// Keys of a problem, wherever on its screen.
pub const PROBLEM: &[Binding] = &[
    bind(Action::NextTab, &[typed(']')], "next tab", "tabs"),
    bind(Action::PreviousTab, &[typed('[')], "previous tab", ""),
    bind(Action::Tab(1), &[alt(KeyCode::Char('1'))], "to tab 1; likewise with 2 to 9", ""),
    bind(Action::Tab(2), &[alt(KeyCode::Char('2'))], "to tab 2", ""),
    bind(Action::Tab(3), &[alt(KeyCode::Char('3'))], "to tab 3", ""),
    bind(Action::Tab(4), &[alt(KeyCode::Char('4'))], "to tab 4", ""),
    bind(Action::Tab(5), &[alt(KeyCode::Char('5'))], "to tab 5", ""),
    bind(Action::Tab(6), &[alt(KeyCode::Char('6'))], "to tab 6", ""),
    bind(Action::Tab(7), &[alt(KeyCode::Char('7'))], "to tab 7", ""),
    bind(Action::Tab(8), &[alt(KeyCode::Char('8'))], "to tab 8", ""),
    bind(Action::Tab(9), &[alt(KeyCode::Char('9'))], "to tab 9", ""),
    bind(Action::NextFilePart, &[typed('}')], "next problem or configuration of the file", "problems"),
    bind(Action::PreviousFilePart, &[typed('{')], "previous problem or configuration of the file", ""),
    bind(Action::BeginProblem, &[], "link another problem: problem NAME ANALYSIS", ""),
    bind(Action::BeginConfiguration, &[], "begin a configuration: configuration NAME", ""),
    bind(Action::RemovePart, &[], "remove this configuration or linked problem", ""),
    bind(Action::Undo, &[typed('z')], "undo", "undo"),
    bind(Action::Redo, &[typed('Z')], "redo", ""),
    bind(
        Action::TryByHand,
        &[typed('t')],
        "hide the results to solve by hand, or show them",
        "solve by hand",
    ),
    bind(Action::NextUnits, &[typed('V')], "change the units of all answers", ""),
    bind(Action::Play, &[typed('p')], "play or pause the animation", "animation"),
    bind(Action::Expand, &[typed('e')], "maximise the pane, or restore all", "maximise"),
    bind(Action::Pin, &[typed('c')], "pin or unpin this result for comparison", "compare"),
    bind(Action::Save, &[typed('s'), ctrl('s')], "save", "save"),
    bind(Action::SaveAs, &[typed('S')], "save under another name", ""),
    bind(Action::Copy, &[typed('y')], "copy what the tab shows", "copy"),
    bind(Action::ExportSeen, &[typed('P')], "export this plot or drawing", "export"),
    bind(Action::Export, &[typed('X')], "export the worked solution", "export"),
    bind(Action::NextProblem, &[typed('b')], "next open problem", ""),
    bind(Action::Blank, BLANK, "blank problem: every input empty", ""),
    bind(Action::CloseProblem, &[typed('B')], "close this problem", ""),
    bind(Action::Edit, &[typed('E')], "edit the problem in $EDITOR", ""),
    bind(Action::Back, ESC, "cancel a running solve, or back", "back"),
];

/// Keys of a page of field mode.
pub(super) const JOB: BindingTable = &[
    &[
        bind(Action::Enter, ENTER, "go on", "go on"),
        bind(Action::Up, UP, "line up", ""),
        bind(Action::Down, DOWN, "line down", "lines"),
        bind(Action::Left, LEFT, "previous option", ""),
        bind(Action::Right, RIGHT, "next option", "choose"),
        bind(Action::PageUp, PAGE_UP, "previous step", ""),
        bind(Action::PageDown, PAGE_DOWN, "next step", "steps"),
        bind(Action::Back, ESC, "previous step, or back", "back"),
        bind(Action::Save, &[typed('s'), ctrl('s')], "save", ""),
        bind(Action::Export, &[typed('X')], "write the report", ""),
        bind(Action::Workbench, &[typed('w')], "open the job in the workbench", ""),
        bind(Action::Undo, &[typed('z')], "undo", ""),
    ],
    ENDS,
];

/// Keys of a line of text of field mode.
pub(super) const JOB_TEXT: BindingTable = &[&[
    bind(Action::Enter, ENTER, "take it and go on", "take it"),
    bind(Action::Up, &[plain(KeyCode::Up), plain(KeyCode::BackTab)], "line up", ""),
    bind(Action::Down, &[plain(KeyCode::Down), plain(KeyCode::Tab)], "line down", "lines"),
    bind(Action::PageUp, &[plain(KeyCode::PageUp)], "previous step", ""),
    bind(Action::PageDown, &[plain(KeyCode::PageDown)], "next step", "steps"),
    bind(Action::Save, &[ctrl('s')], "save", ""),
    bind(Action::Back, ESC, "as it was; previous step, or back", "back"),
]];

/// Keys of a list to choose from.
pub(super) const LIST: BindingTable = &[
    &[bind(Action::Enter, ENTER, "choose", "choose"), bind(Action::Back, ESC, "close", "close")],
    LINES,
    ENDS,
];

/// Keys of a text that is asked for, and of the palette.
pub(super) const PROMPT: BindingTable = &[&[
    bind(Action::Enter, ENTER, "apply", "apply"),
    bind(Action::Back, ESC, "close", "close"),
    bind(
        Action::Down,
        &[plain(KeyCode::Tab), plain(KeyCode::Down)],
        "next line; for a path, next completion",
        "next",
    ),
    bind(Action::Up, &[plain(KeyCode::BackTab), plain(KeyCode::Up)], "previous line", ""),
]];

/// Keys of a text of many lines.
pub(super) const SHEET: BindingTable = &[&[
    bind(Action::Back, ESC, "accept and close", "accept and close"),
    bind(Action::GiveUp, &[ctrl('g')], "close without changes", "cancel"),
]];

/// Keys of the help, where characters search.
pub(super) const HELP: BindingTable = &[&[
    bind(Action::Back, &[plain(KeyCode::Esc), plain(KeyCode::Enter)], "close", "close"),
    bind(Action::Up, &[plain(KeyCode::Up)], "line up", ""),
    bind(Action::Down, &[plain(KeyCode::Down)], "line down", ""),
    bind(Action::PageUp, &[plain(KeyCode::PageUp)], "page up", ""),
    bind(Action::PageDown, &[plain(KeyCode::PageDown)], "page down", ""),
    bind(Action::First, &[plain(KeyCode::Home)], "to the first line", ""),
    bind(Action::Last, &[plain(KeyCode::End)], "to the last line", ""),
]];

/// Keys of every place where characters are no text.
pub const COMMON: &[Binding] = &[
    bind(Action::Palette, &[typed(':')], "command palette", "actions"),
    bind(Action::Help, &[typed('?')], "help", "help"),
    bind(Action::Open, &[typed('o')], "open a problem file", ""),
    bind(Action::Language, &[typed('L')], "em português", ""),
    bind(Action::Theme, &[], "theme", ""),
    bind(Action::Mouse, &[], "mouse: use it here, or leave it to the terminal", ""),
    bind(Action::FieldMode, &[], "field balancing, step by step", ""),
    bind(Action::Quit, &[typed('q')], "quit", "quit"),
];

/// Keys of every place.
pub const ALWAYS: &[Binding] = &[
    bind(Action::Help, &[plain(KeyCode::F(1))], "help", ""),
    bind(Action::Suspend, &[ctrl('z')], "suspend to the shell; `fg` resumes", ""),
    bind(Action::Redraw, &[ctrl('l')], "redraw the screen", ""),
    bind(Action::Quit, &[ctrl('c')], "quit", ""),
];

/// A line of a table.
pub(crate) const fn bind(
    action: Action,
    keys: &'static [Key],
    name: &'static str,
    hint: &'static str,
) -> Binding {
    Binding { action, keys, name, hint }
}

/// A key without modifiers.
pub(crate) const fn plain(code: KeyCode) -> Key {
    Key(code, KeyModifiers::NONE)
}

/// The key of a character.
pub(crate) const fn typed(character: char) -> Key {
    plain(KeyCode::Char(character))
}

/// A character with Ctrl.
pub(crate) const fn ctrl(character: char) -> Key {
    Key(KeyCode::Char(character), KeyModifiers::CONTROL)
}

/// A key with Shift.
pub(crate) const fn shift(code: KeyCode) -> Key {
    Key(code, KeyModifiers::SHIFT)
}

const fn alt(code: KeyCode) -> Key {
    Key(code, KeyModifiers::ALT)
}

/// The usual keys of what every place moves by.
pub(crate) const UP: &[Key] = &[plain(KeyCode::Up), typed('k')];
pub(crate) const DOWN: &[Key] = &[plain(KeyCode::Down), typed('j')];
pub(crate) const LEFT: &[Key] = &[plain(KeyCode::Left), typed('h')];
pub(crate) const RIGHT: &[Key] = &[plain(KeyCode::Right), typed('l')];
pub(crate) const PAGE_UP: &[Key] = &[plain(KeyCode::PageUp), ctrl('u')];
pub(crate) const PAGE_DOWN: &[Key] = &[plain(KeyCode::PageDown), ctrl('d')];
pub(crate) const PAGE_DOWN_OR_SPACE: &[Key] = &[plain(KeyCode::PageDown), ctrl('d'), typed(' ')];
pub(crate) const FIRST: &[Key] = &[plain(KeyCode::Home), typed('g')];
pub(crate) const LAST: &[Key] = &[plain(KeyCode::End), typed('G')];
const TAB: &[Key] = &[plain(KeyCode::Tab)];
const BACK_TAB: &[Key] = &[plain(KeyCode::BackTab)];
pub(crate) const ENTER: &[Key] = &[plain(KeyCode::Enter)];
const BLANK: &[Key] = &[ctrl('n')];
const ESC: &[Key] = &[plain(KeyCode::Esc)];
