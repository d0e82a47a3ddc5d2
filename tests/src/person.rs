//! A user before the workbench: types keys, reads the screen.
//!
//! ```
//! use dalembert_tests::person::Person;
//!
//! let mut person = Person::at(80, 24);
//! assert!(person.types("/fan").sees().contains("Rotating unbalance"));
//! ```
//!
//! Effects are carried out at once and on this thread, files against the real file system: nothing sleeps, nothing
//! races. The terminal alone is missing.

use itertools::Itertools as _;
use std::{
    collections::BTreeSet,
    ops::{Deref, DerefMut},
    path::PathBuf,
};

use dalembert_core::{Language, find, registry};
use dalembert_plugins as _;
use dalembert_tui::{
    Msg,
    glyphs::{Capabilities, Colors, Glyphs, PlotMarker},
    harness::Harness,
    keys::notation::keys_of,
    panes,
};
use ratatui::{
    buffer::Cell,
    crossterm::event::{KeyModifiers, MouseButton, MouseEvent, MouseEventKind},
    style::{Color, Modifier},
};

/// A user at a screen.
pub struct Person {
    harness: Harness,
    capabilities: Capabilities,
}

impl Person {
    /// Before a screen of so many columns and rows that can show everything, on the list of analyses.
    pub fn at(columns: u16, rows: u16) -> Self {
        Self::before(
            columns,
            rows,
            Language::English,
            Capabilities { colors: Colors::Sixteen, ..Capabilities::default() },
        )
    }

    /// The same, in Portuguese.
    pub fn in_portuguese(columns: u16, rows: u16) -> Self {
        Self::before(
            columns,
            rows,
            Language::Portuguese,
            Capabilities { colors: Colors::Sixteen, ..Capabilities::default() },
        )
    }

    /// The same, before a screen that knows ASCII and no colours.
    pub fn in_ascii(columns: u16, rows: u16) -> Self {
        let plain = Capabilities { glyphs: Glyphs::Ascii, colors: Colors::None, marker: PlotMarker::Ascii };
        Self::before(columns, rows, Language::English, plain)
    }

    fn before(columns: u16, rows: u16, language: Language, capabilities: Capabilities) -> Self {
        Self { harness: Harness::new(registry(), (columns, rows), language, capabilities), capabilities }
    }

    /// Before a list of these analyses alone, not of all that are linked.
    #[must_use]
    pub fn knows(mut self, ids: &[&str]) -> Self {
        let entries: Vec<_> = ids.iter().map(|id| find(id).expect("the analysis is linked")).collect();
        let (size, language) = (self.model.size, self.model.locale.language);
        self.harness = Harness::new(&entries, size, language, self.capabilities);
        self
    }

    /// Opens the first case of an analysis.
    #[must_use]
    pub fn opens(mut self, id: &str) -> Self {
        self.harness.begins(None, Some(find(id).expect("the analysis is linked")));
        self
    }

    /// Opens a problem file.
    #[must_use]
    pub fn opens_file(mut self, path: impl Into<PathBuf>) -> Self {
        self.harness.begins(Some(path.into()), None);
        self
    }

    /// Types text and `<named>` keys: `<down>`, `<enter>`, `<del>`, `<s-tab>`, `<c-c>`, `<a-up>`, `<f1>`, `<lt>`.
    pub fn types(&mut self, keys: &str) -> &mut Self {
        for key in keys_of(keys).unwrap_or_else(|name| panic!("no key is called {name}")) {
            self.happens(Msg::Key(key));
        }
        self
    }

    /// Pastes a text.
    pub fn pastes(&mut self, text: &str) -> &mut Self {
        self.happens(Msg::Paste(text.to_owned()))
    }

    /// Drags the window to another size.
    pub fn resizes(&mut self, columns: u16, rows: u16) -> &mut Self {
        self.harness.resizes(columns, rows);
        self
    }

    /// Something happens.
    pub fn happens(&mut self, msg: Msg) -> &mut Self {
        self.harness.happens(msg);
        self
    }

    /// The screen as text.
    pub fn sees(&mut self) -> String {
        self.harness.text()
    }

    /// The colours and attributes of the screen: a letter for each cell, and below what the letters mean. Plain cells are
    /// blank.
    pub fn sees_ink(&mut self) -> String {
        let inks: Vec<Vec<String>> = {
            let buffer = self.draws();
            let row = |y| (0..buffer.area.width).map(|x| ink(&buffer[(x, y)])).collect();
            (0..buffer.area.height).map(row).collect()
        };
        let known: BTreeSet<&str> =
            inks.iter().flatten().map(String::as_str).filter(|ink| !ink.is_empty()).collect();
        let letters = ('a'..='z').chain('A'..='Z').take(known.len());
        let known: Vec<(char, &str)> = letters.zip_eq(known).collect();
        let letter =
            |ink: &String| known.iter().find(|(_, known)| known == ink).map_or(' ', |(letter, _)| *letter);
        let rows =
            inks.iter().map(|row| row.iter().map(letter).collect::<String>().trim_end().to_owned() + "\n");
        rows.chain(known.iter().map(|(letter, ink)| format!("{letter}: {ink}\n"))).collect()
    }

    /// Column and row where a text first stands on the screen.
    pub fn place_of(&mut self, text: &str) -> (u16, u16) {
        let screen = self.sees();
        let mut lines = screen.lines().zip(0..);
        let found =
            lines.find_map(|(line, row)| Some((line[..line.find(text)?].chars().count() as u16, row)));
        found.unwrap_or_else(|| panic!("`{text}` is not on the screen:\n{screen}"))
    }

    /// Returns true if the first occurrence of a text on the screen is dim.
    pub fn sees_dim(&mut self, text: &str) -> bool {
        let place = self.place_of(text);
        self.draws()[place].modifier.contains(Modifier::DIM)
    }

    /// Does something with the mouse.
    pub fn mouse(&mut self, kind: MouseEventKind, (column, row): (u16, u16)) -> &mut Self {
        self.happens(Msg::Mouse(MouseEvent { kind, column, row, modifiers: KeyModifiers::NONE }))
    }

    /// Clicks on a text on the screen.
    pub fn clicks(&mut self, text: &str) -> &mut Self {
        let place = self.place_of(text);
        let button = MouseButton::Left;
        self.mouse(MouseEventKind::Down(button), place).mouse(MouseEventKind::Up(button), place)
    }

    /// Turns the tabs until the one of this name is shown.
    pub fn turns_to(&mut self, tab: &str) -> &mut Self {
        for _ in panes::all() {
            if self.model.bench.as_ref().is_some_and(|bench| bench.shown().name() == tab) {
                return self;
            }
            self.types("]");
        }
        panic!("{tab} is no tab of this problem:\n{}", self.sees());
    }
}

/// Style of a cell, in words; empty for a plain one.
fn ink(cell: &Cell) -> String {
    let mut words: Vec<String> = cell.modifier.iter_names().map(|(name, _)| name.to_lowercase()).collect();
    let shown = |color: Color| (color != Color::Reset).then(|| color.to_string().to_lowercase());
    words.extend(shown(cell.fg));
    words.extend(shown(cell.bg).map(|ground| format!("on {ground}")));
    words.join(" ")
}

impl Deref for Person {
    type Target = Harness;

    fn deref(&self) -> &Harness {
        &self.harness
    }
}

impl DerefMut for Person {
    fn deref_mut(&mut self) -> &mut Harness {
        &mut self.harness
    }
}
