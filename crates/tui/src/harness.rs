//! The workbench without a terminal: what happens is done at once and on this thread, and the screen is a buffer.
//!
//! Replays without a terminal and tests play on it. Files are the real ones.

use std::{collections::BTreeMap, path::PathBuf};

use dalembert_core::{Entry, Language, Stop};
use ratatui::{
    Terminal,
    backend::TestBackend,
    buffer::{Buffer, Cell},
};

use crate::{
    Effect, Model, Msg,
    dialog::Editing,
    files::{self, Before, Fingerprint, Opened},
    glyphs::{Capabilities, sweep},
    look::Appearance,
    model::EditError,
    remembered::HistoryChange,
    replay::draw_caption,
    solver::{check_cases, solve},
    start, update, view,
};

/// The workbench, its screen, and what left it.
#[derive(Debug)]
pub struct Harness {
    /// State of the workbench.
    pub model: Model,
    /// True once the program has ended.
    pub has_quit: bool,
    /// Text copied last.
    pub clipboard: String,
    /// The unsaved work that would outlive a crash, by the numbers of the problems.
    pub kept: BTreeMap<u64, String>,
    /// Changes for the history of later sessions.
    pub remembered: Vec<HistoryChange>,
    wish: Option<&'static Entry>,
    /// Editor as a function of the text: the identity, unless a test replaces it.
    pub editor: fn(&str) -> String,
    terminal: Terminal<TestBackend>,
    capabilities: Capabilities,
}

impl Harness {
    /// The list of these analyses, on a screen of so many columns and rows.
    pub fn new(
        entries: &[&'static Entry],
        (columns, rows): (u16, u16),
        language: Language,
        capabilities: Capabilities,
    ) -> Self {
        let mut model = Model::new(entries, language, Appearance::new(&capabilities), capabilities.marker);
        model.size = (columns, rows);
        let terminal = match Terminal::new(TestBackend::new(columns, rows)) {
            Ok(terminal) => terminal,
            Err(never) => match never {},
        };
        let mut harness = Self {
            model,
            has_quit: false,
            clipboard: String::new(),
            kept: BTreeMap::new(),
            remembered: Vec::new(),
            wish: None,
            editor: str::to_owned,
            terminal,
            capabilities,
        };
        harness.begins(None, None);
        harness
    }

    /// Opens a problem file, the first case of an analysis, or nothing.
    pub fn begins(&mut self, file: Option<PathBuf>, analysis: Option<&'static Entry>) {
        let effects = start(&mut self.model, file, analysis);
        self.perform(effects);
    }

    /// Something happens.
    pub fn happens(&mut self, msg: Msg) {
        let effects = update(&mut self.model, msg);
        self.perform(effects);
    }

    /// The window is dragged to another size.
    pub fn resizes(&mut self, columns: u16, rows: u16) {
        self.terminal.backend_mut().resize(columns, rows);
        self.happens(Msg::Resize(columns, rows));
    }

    /// The screen as text.
    pub fn text(&mut self) -> String {
        let buffer = self.draws();
        let width = usize::from(buffer.area.width).max(1);
        let rows = buffer.content.chunks(width).map(|row| row.iter().map(Cell::symbol).collect::<String>());
        rows.map(|row| row.trim_end().to_owned() + "\n").collect()
    }

    /// The screen with its colours.
    pub fn draws(&mut self) -> &Buffer {
        if let Some(entry) = self.wish.take() {
            self.happens(Msg::CheckedCase(entry.about.id, check_cases(entry)));
        }
        let (model, capabilities) = (&self.model, &self.capabilities);
        let drawn = self.terminal.draw(|frame| {
            view(model, frame);
            draw_caption(model, frame);
            sweep(frame.buffer_mut(), capabilities);
        });
        match drawn {
            Ok(_) => self.terminal.backend().buffer(),
            Err(never) => match never {},
        }
    }

    fn perform(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            let msg = match effect {
                Effect::Solve(job) => match solve(&job, &Stop::new(), &|_| {}) {
                    Some(outcome) => Msg::Solved(outcome),
                    None => continue,
                },
                Effect::Ask(job) => match solve(&job, &Stop::new(), &|_| {}) {
                    Some(outcome) => Msg::Asked(outcome),
                    None => continue,
                },
                // Done when somebody looks, as the newest wish of several.
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
                Effect::SavePlan { path, text, before } => {
                    let result = files::save(&path, &text, before);
                    Msg::PlanSaved { path, text, result }
                }
                Effect::ReadPlan(path) => {
                    let result = files::read(&path);
                    Msg::PlanRead { path, result }
                }
                Effect::Open(path) => {
                    let result = files::read(&path);
                    Msg::Opened { path, result }
                }
                Effect::ReadLinked { problem, path, text } => {
                    Msg::LinkedRead(problem, files::LinkedTexts::of(&path, &text))
                }
                // A harness stands in no folder: what is there is not part of a session.
                Effect::List(folder) => {
                    let names = if folder.is_absolute() { files::list(&folder) } else { Vec::new() };
                    Msg::Listed(folder, names)
                }
                Effect::ReadTable { field, path, columns } => {
                    let (result, sample) = files::preview_table(&path, columns);
                    Msg::TableRead { field, path, result, sample }
                }
                Effect::Edit(editing) => self.edit(editing),
                Effect::Keep { problem, text, .. } => {
                    self.kept.insert(problem, text);
                    continue;
                }
                Effect::Forget(problem) => {
                    self.kept.remove(&problem);
                    continue;
                }
                Effect::Discard(crashed) => match crashed.discard() {
                    Ok(()) => continue,
                    Err(error) => Msg::Trouble(error),
                },
                Effect::Copy(text) => {
                    self.clipboard = text;
                    continue;
                }
                Effect::Quit => {
                    self.has_quit = true;
                    continue;
                }
                Effect::Cancel
                | Effect::Fault(_)
                | Effect::Suspend
                | Effect::Redraw
                | Effect::Remove(_)
                | Effect::Mouse(_) => continue,
            };
            self.happens(msg);
        }
    }

    /// Lets the editor have the problem.
    fn edit(&self, editing: Editing) -> Msg {
        let (text, file) = match editing {
            Editing::Text(text) => (Ok(text), Editing::Copy(PathBuf::from("copy.toml"))),
            // What could not be read is edited from what it is kept as: here, from nothing.
            Editing::Copy(path) => (Ok(String::new()), Editing::Copy(path)),
            Editing::Own(path) => (files::read(&path).map(|opened| opened.text), Editing::Own(path)),
        };
        let edited = text.map(|text| (self.editor)(&text)).and_then(|text| match &file {
            Editing::Own(path) => {
                let fingerprint = files::save(path, &text, Before::Whatever)?;
                Ok(Opened { linked: files::LinkedTexts::of(path, &text), text, fingerprint })
            }
            _ => Ok(Opened {
                fingerprint: Fingerprint::of(text.as_bytes()),
                text,
                linked: files::LinkedTexts::default(),
            }),
        });
        Msg::Edited { file, result: edited.map_err(EditError::File) }
    }
}
