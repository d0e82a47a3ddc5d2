//! Intents: the next action that an update wants. Updates return them, and only `update` carries them out.

use std::path::PathBuf;

use dalembert_core::{Entry, Text, suggestions::Suggestion};
use ratatui::crossterm::event::KeyEvent;

use crate::{
    dialog::{After, Dialog, Purpose},
    effect::Effect,
    files::{Before, Crashed, Opened},
    keys::{Action, KeyContext},
    plot::Marker,
    problem::Problem,
    remembered::{HistoryChange, Progress},
    solver::Work,
};

/// A pane, by its place among all: that of its tab.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tab(pub usize);

/// Something to be done next.
#[derive(Debug)]
pub enum Intent {
    /// A message to the user.
    Say(Text),
    /// A message to the user: something went wrong.
    Complain(Text),
    /// A message to the user: nothing is saved.
    Refuse,
    /// A dialog lies over the screen.
    Show(Dialog),
    /// Something outside of the model.
    Do(Effect),
    /// A key is pressed.
    Key(KeyEvent),
    /// A key of a place has its meaning.
    Press(KeyContext, Action),

    /// The inputs are others: they are read, solved, and kept against a crash.
    Changed,
    /// The problem is kept against a crash; its inputs are the same.
    Keep,
    /// The cursor goes to the input at a path, or to the innermost part of it that has a line.
    GoToInput(String),
    /// The cursor goes to the first input that is still empty.
    GoToMissing,
    /// A usual question is asked.
    AskUsual(Box<Suggestion>),
    /// The text of a table is taken, or the file that it names.
    TakeTable(String, String),
    /// A file is read for the table under the cursor.
    Import(String),
    /// The text of a file takes the place of that of a table.
    ReplaceTable(String, String),
    /// The problem has another title.
    Rename(String),

    /// A part of the file is shown, by the place of its tab.
    ShowPart(usize),
    /// The panes show what they have of the part that is shown.
    BringResults,
    /// A linked problem is begun: its name, and an analysis or words that it is found by.
    BeginProblem(String),
    /// A problem of an analysis is linked under a name.
    LinkProblem(String, &'static Entry),
    /// A configuration is begun.
    BeginConfiguration(String),

    /// A pane is shown.
    Turn(Tab),
    /// The pane of a name is shown from its first line.
    TurnTo(&'static str),
    /// The text of a cell is complete.
    EndEdit,
    /// The cursor of the shown pane goes to a part of its page.
    GoToPart(usize),
    /// A part of the shown pane is brought into view.
    BringIn(usize),
    /// A pane is scrolled by so many lines.
    Scroll(Tab, isize),
    /// The shown pane asks again what takes time.
    Ask,
    /// The shown pane waits for some work.
    Await(Work),
    /// Curves are drawn with this marker.
    Mark(Marker),

    /// A case of an analysis is opened.
    OpenCase(&'static Entry, usize),
    /// A case of an analysis is opened as an exercise: with its statement, and with its results covered.
    OpenExercise(&'static Entry, usize),
    /// A blank problem of an analysis is opened.
    OpenBlank(&'static Entry),
    /// A problem is opened beside the others.
    Open(Box<Problem>),
    /// A problem takes the place of the one that is shown.
    Replace(Box<Problem>),
    /// An open problem is shown.
    Bring(u64),
    /// The next open problem is shown.
    NextProblem,
    /// Problems or the program end, once unsaved work is seen to.
    Leave(After),
    /// Problems or the program end once what is not saved is saved.
    SaveThen(After),
    /// Problems or the program end, whatever is not saved.
    Discard(After),
    /// The dialog is closed; what was typed in it counts.
    Close,

    /// The problem is saved in its file, or a file is asked for.
    Save,
    /// The problem is saved under a name that must be free, unless it is its own.
    SaveAs(PathBuf),
    /// The problem is saved over whatever is there.
    Overwrite(PathBuf),
    /// A file is asked for: to save in, or to export to.
    AskPath(Purpose),
    /// An export is written.
    Export(Purpose, PathBuf, Before),
    /// Files that an input links to by now are read.
    FollowLinks,
    /// Linked files that are open, or were, are read as they are now.
    ReadLinked,
    /// A file was read: it becomes a problem.
    Opened(PathBuf, Opened),
    /// The work of crashed sessions is taken up.
    Restore(Vec<Crashed>),
    /// The problem is edited in the user's editor.
    EditOutside,

    /// The list is shown.
    List,
    /// The list shows what is chosen in it.
    Preview,
    /// Later sessions remember this.
    Remember(HistoryChange),
    /// The published case that is shown is worked through so far.
    Reach(Progress),
}

impl Intent {
    /// A message to the user.
    pub fn say(text: impl Into<Text>) -> Vec<Self> {
        vec![Self::Say(text.into())]
    }

    /// A message to the user: something went wrong.
    pub fn report_error(text: impl Into<Text>) -> Vec<Self> {
        vec![Self::Complain(text.into())]
    }
}
