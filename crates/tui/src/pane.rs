//! A pane of what was found. Each is one file of [`panes`](crate::panes), with its state, its keys and its view.

use std::{any::Any, fmt::Debug};

use dalembert_core::{FieldError, Locale, Text, study::StudyPlan};
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    text::Line,
};

pub use crate::intent::Tab;
use crate::{
    ask::{Question, Reply},
    intent::Intent,
    keys::{Action, KeyContext, KeyMap},
    look::Appearance,
    pixels::Picture,
    plot::Marker,
    problem::{OpenFile, Problem},
    text::draw_lines,
    text_entry::TextEntry,
};

/// A pane in the registry of all.
#[derive(Clone, Copy, Debug)]
pub struct PaneEntry {
    /// The order of its tab: it stands to the right of those of a smaller number.
    pub order: u16,
    /// The pane, as a problem begins with it.
    pub new: fn() -> Box<dyn Pane>,
}

dalembert_core::inventory::collect!(PaneEntry);

/// Registers a pane: its type, which has a default, and the order of its tab.
macro_rules! register_pane {
    ($pane:ty, $order:expr) => {
        dalembert_core::inventory::submit! {
            $crate::pane::PaneEntry { order: $order, new: || Box::new(<$pane>::default()) }
        }
    };
}

pub(crate) use register_pane;

/// Content of a pane, by which it is given room on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Text to read: as many rows as it has.
    Text,
    /// A picture: the more room the better.
    Picture,
    /// Cells to type in, and what comes of them: never seen beside another pane without being asked for.
    Cells,
}

/// The lines of a pane, and at which of them its parts begin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Page {
    /// The lines, none wider than was asked for.
    pub lines: Vec<Line<'static>>,
    /// The first line of each step or case.
    pub starts: Vec<usize>,
    /// So many of the first lines are seen whatever else is: the main answers.
    pub head: usize,
}

/// The surroundings of a pane: the user's look, language and keys, and where the pane is seen.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is a state of its own")]
pub struct Ui<'a> {
    /// Colours and pictograms.
    pub look: &'a Appearance,
    /// The language.
    pub locale: &'a Locale,
    /// The meaning of keys.
    pub keys: &'a KeyMap,
    /// True if animations move.
    pub playing: bool,
    /// The marker that curves are drawn with.
    pub marker: Marker,
    /// True if the keys act on the pane.
    pub focused: bool,
    /// The text that is being typed in the cell under its cursor.
    pub edit: Option<&'a TextEntry>,
    /// True if it waits for what takes time.
    pub waits: bool,
    /// True if pictures must not show what is to be found.
    pub covered: bool,
    /// The inside of the pane.
    pub area: Rect,
    /// The first line that it shows.
    pub scroll: usize,
}

/// A movement of the mouse on a pane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gesture {
    /// The button goes down.
    Press,
    /// The pointer comes from this column with the button down.
    Drag(u16),
    /// The pointer is moved there without a button.
    Hover,
    /// The pointer leaves the pane.
    Leave,
    /// The wheel turns up.
    WheelUp,
    /// The wheel turns down.
    WheelDown,
}

/// A pane. What it does not say is that of a pane of text, which is only read.
pub trait Pane: Any + Debug {
    /// The name of its tab.
    fn name(&self) -> &'static str;

    /// The place where its keys are typed.
    fn place(&self) -> KeyContext {
        KeyContext::Pane
    }

    /// The content, by which the pane is given room.
    fn content(&self) -> Content {
        if self.place().has_cells() { Content::Cells } else { Content::Text }
    }

    /// True if it asks for what the results would give away beside it.
    fn covers_results(&self, _problem: &Problem) -> bool {
        false
    }

    /// True if it has something to show.
    fn is_useful(&self, _problem: &Problem) -> bool {
        true
    }

    /// The lines of its page; a picture has none.
    fn page(&self, _problem: &Problem, _ui: &Ui<'_>, _width: u16) -> Page {
        Page::default()
    }

    /// Draws what is no text, in the room that its lines leave; what is shown in pixels comes back.
    fn draw(&self, _problem: &Problem, _ui: &Ui<'_>, _room: Rect, _buffer: &mut Buffer) -> Vec<Picture> {
        Vec::new()
    }

    /// The line of help below it.
    fn about(&self, _problem: &Problem, _ui: &Ui<'_>) -> Vec<Text> {
        Vec::new()
    }

    /// True if a key of its footer serves now.
    fn serves(&self, _problem: &Problem, _action: Action) -> bool {
        true
    }

    /// Takes what was chosen in a list that it showed, by its word.
    fn chosen(&mut self, _problem: &mut Problem, _what: &str) -> Vec<Intent> {
        Vec::new()
    }

    /// Does what a key means; `None` where it is none of its own.
    fn act(&mut self, _problem: &mut Problem, _ui: &Ui<'_>, _action: Action) -> Option<Vec<Intent>> {
        None
    }

    /// Shows what it has of the problem or configuration of a name.
    fn turn_to(&mut self, _problem: &Problem, _name: &str) {}

    /// The first part of its page about the problem or configuration of a name.
    fn first_part_of(&self, _problem: &Problem, _name: &str) -> Option<usize> {
        None
    }

    /// The part of its page under the cursor, where it has one: a case, an answer, a cell.
    fn cursor<'a>(&'a mut self, _problem: &'a mut Problem) -> Option<&'a mut usize> {
        None
    }

    /// The text that a copy takes.
    fn copied(&self, problem: &Problem, ui: &Ui<'_>) -> String {
        let page = self.page(problem, ui, 100);
        page.lines.iter().map(|line| format!("{line}").trim_end().to_owned() + "\n").collect()
    }

    /// Prepares the pane when its tab is turned to.
    fn turned_to(&mut self, _problem: &mut Problem) -> Vec<Intent> {
        Vec::new()
    }

    /// There is another solution, or its steps are covered otherwise.
    fn restart(&mut self) {}

    /// True if one of its symbols led to the input under the cursor of the form: Esc comes back to it.
    fn led_to_input(&self) -> bool {
        false
    }

    /// Does what the mouse means; whether it means something.
    fn mouse(&mut self, _problem: &Problem, _ui: &Ui<'_>, _gesture: Gesture, _at: Position) -> bool {
        false
    }

    /// True if a line has arrows at its ends, for the mouse: they do what Left and Right do.
    fn has_arrows(&self, _line: usize) -> bool {
        false
    }

    /// Number of cells to type in or to choose in.
    fn cells(&self, _problem: &Problem) -> usize {
        0
    }

    /// The text of the cell under the cursor; `None` where nothing is typed there.
    fn cell(&self, _problem: &Problem) -> Option<String> {
        None
    }

    /// The wanted form of a text for the cell under the cursor, and what the text is.
    fn about_cell(&self, _problem: &Problem, _ui: &Ui<'_>) -> Vec<Text> {
        Vec::new()
    }

    /// Takes the text of the cell under the cursor, as it is typed.
    fn typed(&mut self, _problem: &mut Problem, _text: String) {}

    /// The text of a cell is complete.
    fn kept(&mut self, _problem: &mut Problem) -> Vec<Intent> {
        Vec::new()
    }

    /// The file of the plan that it edits.
    fn plan_file(&self) -> Option<&OpenFile> {
        None
    }

    /// The plan that it edits, without the name of its problem.
    ///
    /// # Errors
    /// Every text that cannot be read, or that there is no plan.
    fn plan(&self, _problem: &Problem) -> Result<StudyPlan, Vec<FieldError>> {
        Err(Vec::new())
    }

    /// Takes the plan of a file, as it was read or written.
    fn take_plan(&mut self, _problem: &mut Problem, _plan: &StudyPlan, _file: OpenFile) {}

    /// The question that it has and that takes time.
    fn question(&self, _problem: &Problem) -> Option<Question> {
        None
    }

    /// True if it has the answer to it.
    fn is_answered(&self, _problem: &Problem) -> bool {
        false
    }

    /// Takes the answer; `None`: the program failed.
    fn answered(&mut self, _problem: &mut Problem, _reply: Option<Reply>) -> Vec<Intent> {
        Vec::new()
    }

    /// The answer counts no more; `inputs`: since the inputs are others.
    fn forget(&mut self, _problem: &mut Problem, _inputs: bool) {}

    /// Number of pictures, of which one is shown.
    fn pictures(&self, _problem: &Problem) -> usize {
        0
    }

    /// The place of the picture that it shows.
    fn shown(&self) -> usize {
        0
    }

    /// Draws the picture after the one that is shown, where a tall screen has room for it.
    fn draw_next(&self, _problem: &Problem, _ui: &Ui<'_>, _room: Rect, _buffer: &mut Buffer) -> Vec<Picture> {
        Vec::new()
    }

    /// Rows that the picture in use fills in so many columns, or the next one; `None` of a picture that is the better
    /// for every row.
    fn rows(&self, _problem: &Problem, _ui: &Ui<'_>, _next: bool, _width: u16) -> Option<u16> {
        None
    }

    /// The frames of what moves in it, and the time that they take.
    fn frames(&self, _problem: &Problem) -> (usize, f64) {
        (0, 0.0)
    }

    /// The frame that is shown.
    fn frame(&mut self) -> Option<&mut usize> {
        None
    }

    /// The name of its pictures in the names of files, and what is said where the name of a file does not do.
    fn file_names(&self) -> (&'static str, &'static str) {
        ("picture", "enter a name ending in .svg")
    }

    /// The reason why its picture cannot be exported now.
    fn hindrance(&self, _problem: &Problem) -> Option<Text> {
        None
    }

    /// The picture that is shown as a file with this ending; `None` where it has no such form.
    fn file(&self, _problem: &Problem, _ending: &str, _locale: &Locale) -> Option<String> {
        None
    }
}

impl Page {
    /// The part that a line belongs to. After the last part an empty line follows.
    pub fn part_at(&self, line: usize) -> Option<usize> {
        let part = self.starts.iter().rposition(|start| *start <= line)?;
        let own = self.lines.get(self.starts[part]..=line)?;
        own.iter().all(|line| line.width() > 0).then_some(part)
    }

    /// Lines without parts.
    pub fn of(lines: Vec<Line<'static>>) -> Self {
        Self { lines, ..Self::default() }
    }

    /// Draws the lines from one on.
    pub fn draw(&self, first: usize, area: Rect, buffer: &mut Buffer) {
        draw_lines(&self.lines, first, area, buffer);
    }

    /// The page with other lines for its own, more of them at the beginning.
    #[must_use]
    pub fn behind(self, lines: Vec<Line<'static>>) -> Self {
        let more = lines.len() - self.lines.len();
        let head = if self.head > 0 { self.head + more } else { 0 };
        Self { lines, starts: self.starts.into_iter().map(|start| start + more).collect(), head }
    }
}

impl Ui<'_> {
    /// The usual key of an action in a place, as a user reads it; empty where there is none.
    pub fn key(&self, place: KeyContext, action: Action) -> String {
        self.keys.key(place, action).map_or_else(String::new, |key| key.name(self.locale))
    }

    /// The keys of two actions, side by side.
    pub fn pair(&self, place: KeyContext, one: Action, other: Action) -> String {
        format!("{} {}", self.key(place, one), self.key(place, other))
    }
}
