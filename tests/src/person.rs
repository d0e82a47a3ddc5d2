//! A person before the workbench: types keys, reads the screen.
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

use std::{collections::BTreeMap, path::PathBuf};

use dalembert_core::{Entry, Language, Stop, find, registry};
use dalembert_plugins as _;
use dalembert_tui::{
    Effect, Model, Msg,
    files::{self, Fingerprint, Opened},
    glyphs::{Capabilities, Colors, Glyphs, PlotMarker, sweep},
    look::Look,
    model::Editing,
    remembered::Change,
    solver::{judge, solve},
    start, update, view,
};
use ratatui::{
    Terminal,
    backend::TestBackend,
    buffer::{Buffer, Cell},
    crossterm::event::{KeyCode, KeyEvent, KeyModifiers},
    style::Modifier,
};

/// A person at a screen.
pub struct Person {
    /// What the workbench knows.
    pub model: Model,
    /// Whether the program has ended.
    pub has_left: bool,
    /// What was copied last.
    pub clipboard: String,
    /// The unsaved work that would outlive a crash, by the numbers of the problems.
    pub kept: BTreeMap<u64, String>,
    /// What later sessions would remember.
    pub remembered: Vec<Change>,
    wish: Option<&'static Entry>,
    /// What the editor makes of a text.
    pub editor: fn(&str) -> String,
    terminal: Terminal<TestBackend>,
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
        let mut model = Model::new(registry(), language, Look::new(&capabilities), capabilities.marker);
        model.size = (columns, rows);
        let terminal = Terminal::new(TestBackend::new(columns, rows)).expect("a test terminal");
        let effects = start(&mut model, None, None);
        let mut person = Self {
            model,
            has_left: false,
            clipboard: String::new(),
            kept: BTreeMap::new(),
            remembered: Vec::new(),
            wish: None,
            editor: str::to_owned,
            terminal,
            capabilities,
        };
        person.perform(effects);
        person
    }

    /// Before a list of these analyses alone, not of all that are linked.
    #[must_use]
    pub fn knows(mut self, ids: &[&str]) -> Self {
        let entries: Vec<_> = ids.iter().map(|id| find(id).expect("the analysis is linked")).collect();
        let (size, language, look, marker) =
            (self.model.size, self.model.locale.language, self.model.look, self.capabilities.marker);
        self.model = Model::new(&entries, language, look, marker);
        self.model.size = size;
        let effects = start(&mut self.model, None, None);
        self.perform(effects);
        self
    }

    /// Opens the first case of an analysis.
    #[must_use]
    pub fn opens(mut self, id: &str) -> Self {
        let effects = start(&mut self.model, None, Some(find(id).expect("the analysis is linked")));
        self.perform(effects);
        self
    }

    /// Opens a problem file.
    #[must_use]
    pub fn opens_file(mut self, path: impl Into<PathBuf>) -> Self {
        let effects = start(&mut self.model, Some(path.into()), None);
        self.perform(effects);
        self
    }

    /// Types text and `<named>` keys: `<down>`, `<enter>`, `<del>`, `<s-tab>`, `<c-c>`, `<a-up>`, `<f1>`, `<lt>`.
    pub fn types(&mut self, keys: &str) -> &mut Self {
        for key in keys_of(keys) {
            self.happens(Msg::Key(key));
        }
        self
    }

    /// Pastes a text.
    pub fn pastes(&mut self, text: &str) -> &mut Self {
        self.happens(Msg::Paste(text.to_owned()));
        self
    }

    /// Drags the window to another size.
    pub fn resizes(&mut self, columns: u16, rows: u16) -> &mut Self {
        self.terminal.backend_mut().resize(columns, rows);
        self.happens(Msg::Resize(columns, rows));
        self
    }

    /// Something happens.
    pub fn happens(&mut self, msg: Msg) -> &mut Self {
        let effects = update(&mut self.model, msg);
        self.perform(effects);
        self
    }

    /// The screen as text.
    pub fn sees(&mut self) -> String {
        self.draws();
        let buffer = self.terminal.backend().buffer();
        let width = usize::from(buffer.area.width).max(1);
        let rows = buffer.content.chunks(width).map(|row| row.iter().map(Cell::symbol).collect::<String>());
        rows.map(|row| row.trim_end().to_owned() + "\n").collect()
    }

    /// The screen with its colours.
    pub fn draws(&mut self) -> &Buffer {
        if let Some(entry) = self.wish.take() {
            self.happens(Msg::Judged(entry.about.id, judge(entry)));
        }
        let (model, capabilities) = (&self.model, &self.capabilities);
        self.terminal
            .draw(|frame| {
                view(model, frame);
                sweep(frame.buffer_mut(), capabilities);
            })
            .expect("a test terminal draws");
        self.terminal.backend().buffer()
    }

    /// Whether the first place of a text on the screen is drawn dim: passed over, not current.
    pub fn sees_dim(&mut self, text: &str) -> bool {
        let screen = self.sees();
        let row = screen.lines().position(|line| line.contains(text)).expect("the text is on the screen");
        let line = screen.lines().nth(row).unwrap_or_default();
        let column = line[..line.find(text).unwrap_or(0)].chars().count();
        let cell = &self.terminal.backend().buffer()[(column as u16, row as u16)];
        cell.modifier.contains(Modifier::DIM)
    }

    fn perform(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            let msg = match effect {
                Effect::Solve(job) => match solve(&job, &Stop::new()) {
                    Some(outcome) => Msg::Solved(outcome),
                    None => continue,
                },
                Effect::Ask(job) => match solve(&job, &Stop::new()) {
                    Some(outcome) => Msg::Asked(outcome),
                    None => continue,
                },
                // Done when the person looks, as the newest wish of several.
                Effect::Judge(entry) => {
                    self.wish = Some(entry);
                    continue;
                }
                Effect::Remember(change) => {
                    self.remembered.push(change);
                    continue;
                }
                Effect::Save { path, text, before } => {
                    let result = files::save(&path, &text, before);
                    Msg::Saved { path, text, result }
                }
                Effect::Export { files, before } => {
                    let (path, result) = files::save_all(&files, before);
                    Msg::Exported { path, result }
                }
                Effect::Open(path) => {
                    let result = files::read(&path);
                    Msg::Opened { path, result }
                }
                Effect::ReadTable { field, path, columns } => {
                    Msg::TableRead { field, result: files::read_table(&path, columns) }
                }
                Effect::Edit(editing) => {
                    let (text, file) = match editing {
                        Editing::Text(text) => (text, Editing::Copy(PathBuf::from("copy.toml"))),
                        // What could not be read is edited from what it is kept as: here, from nothing.
                        Editing::Copy(path) => (String::new(), Editing::Copy(path)),
                        Editing::Own(path) => {
                            (files::read(&path).expect("the file of the test").text, Editing::Own(path))
                        }
                    };
                    let text = (self.editor)(&text);
                    if let Editing::Own(path) = &file {
                        std::fs::write(path, &text).expect("the file of the test can be written");
                    }
                    let fingerprint = Fingerprint::of(text.as_bytes());
                    Msg::Edited { file, result: Ok(Opened { text, fingerprint }) }
                }
                Effect::Keep { problem, text, .. } => {
                    self.kept.insert(problem, text);
                    continue;
                }
                Effect::Forget(problem) => {
                    self.kept.remove(&problem);
                    continue;
                }
                Effect::Discard(crashed) => {
                    crashed.discard().expect("the file of the test can be removed");
                    continue;
                }
                Effect::Copy(text) => {
                    self.clipboard = text;
                    continue;
                }
                Effect::Quit => {
                    self.has_left = true;
                    continue;
                }
                Effect::Fault(_)
                | Effect::Suspend
                | Effect::Redraw
                | Effect::Remove(_)
                | Effect::Mouse(_) => continue,
            };
            self.happens(msg);
        }
    }
}

fn keys_of(text: &str) -> Vec<KeyEvent> {
    let mut keys = Vec::new();
    let mut rest = text;
    while let Some(character) = rest.chars().next() {
        match rest.strip_prefix('<').and_then(|named| named.split_once('>')) {
            Some((name, after)) => {
                keys.push(named(name));
                rest = after;
            }
            None => {
                keys.push(KeyEvent::new(KeyCode::Char(character), KeyModifiers::NONE));
                rest = &rest[character.len_utf8()..];
            }
        }
    }
    keys
}

fn named(name: &str) -> KeyEvent {
    let (mut modifiers, mut base) = (KeyModifiers::NONE, name);
    while let Some((modifier, rest)) =
        base.split_once('-').filter(|(modifier, rest)| modifier.len() == 1 && !rest.is_empty())
    {
        modifiers |= match modifier {
            "s" => KeyModifiers::SHIFT,
            "a" => KeyModifiers::ALT,
            "c" => KeyModifiers::CONTROL,
            _ => panic!("no key is called <{name}>"),
        };
        base = rest;
    }
    let code = match base {
        "tab" if modifiers.contains(KeyModifiers::SHIFT) => KeyCode::BackTab,
        "tab" => KeyCode::Tab,
        "enter" => KeyCode::Enter,
        "esc" => KeyCode::Esc,
        "bs" => KeyCode::Backspace,
        "del" => KeyCode::Delete,
        "up" => KeyCode::Up,
        "down" => KeyCode::Down,
        "left" => KeyCode::Left,
        "right" => KeyCode::Right,
        "home" => KeyCode::Home,
        "end" => KeyCode::End,
        "pgup" => KeyCode::PageUp,
        "pgdn" => KeyCode::PageDown,
        "space" => KeyCode::Char(' '),
        "lt" => KeyCode::Char('<'),
        _ if base.len() > 1 && base.strip_prefix('f').is_some_and(|n| n.parse::<u8>().is_ok()) => {
            KeyCode::F(base[1..].parse().expect("a number was found"))
        }
        _ => match base.chars().next().filter(|_| base.chars().count() == 1) {
            Some(character) => KeyCode::Char(character),
            None => panic!("no key is called <{name}>"),
        },
    };
    KeyEvent::new(code, modifiers)
}
