//! Plays a session without a terminal, at once.

use std::{
    fmt,
    path::{Path, PathBuf},
    time::Duration,
};

use dalembert_core::{Entry, Text, catalogue, find};

use super::{Act, Replay, key_to_tab, svg};
use crate::{Msg, harness::Harness, panes, view::tempo};

/// Result of a replayed session.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReplayResult {
    /// The screens it marked, in their order.
    pub pictures: Vec<Picture>,
    /// The last screen, as text.
    pub last: String,
}

/// A screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Name.
    pub name: String,
    /// Text of the screen.
    pub text: String,
    /// SVG of the screen.
    pub svg: String,
}

/// Reason for which a replay stopped early.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReplayFailure {
    /// Session that opens neither an analysis nor a file.
    NothingToOpen(String),
    /// The screen does not show what it should.
    NotSeen {
        /// The line of the session.
        line: usize,
        /// Expected text.
        text: String,
        /// Text of the screen.
        screen: String,
    },
    /// The problem has no pane of this name, which this line asks for.
    NoTab(usize, String),
    /// The program ended before the session, which goes on in this line.
    Ended(usize),
}

impl ReplayFailure {
    /// The sentence, for a user.
    pub fn text(&self) -> Text {
        match self {
            ReplayFailure::NothingToOpen(named) => {
                let words = "`{named}` is neither the id of an analysis nor a file beside the session";
                Text::new(words).with("named", named)
            }
            ReplayFailure::NotSeen { line, text, .. } => {
                Text::new("line {line}: `{text}` is not on the screen").with("line", line).with("text", text)
            }
            ReplayFailure::NoTab(line, name) => {
                let words = "line {line}: the problem has no tab `{name}`";
                Text::new(words).with("line", line).with("name", name)
            }
            ReplayFailure::Ended(line) => {
                Text::new("line {line}: the program has already ended").with("line", line)
            }
        }
    }
}

impl fmt::Display for ReplayFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text().english())
    }
}

impl std::error::Error for ReplayFailure {}

/// Plays a session that stands in a folder. An animation shows the frames that the time of a `wait` has room for.
pub fn play(replay: &Replay, folder: &Path) -> Result<ReplayResult, ReplayFailure> {
    let mut harness = Harness::new(catalogue(), replay.screen, replay.language, replay.look);
    (harness.model.readonly, harness.model.is_replay) = (true, true);
    harness.model.field.clone_from(&replay.field);
    if let Some(named) = &replay.open {
        let (file, analysis) = to_open(named, folder)?;
        harness.begins(file, analysis);
    } else if replay.field.is_some() {
        harness.begins(None, None);
    }
    let mut pictures = Vec::new();
    for (line, act) in &replay.acts {
        if harness.has_quit {
            return Err(ReplayFailure::Ended(*line));
        }
        match act {
            Act::Type(keys) => keys.iter().for_each(|key| harness.happens(Msg::Key(*key))),
            Act::Paste(text) => harness.happens(Msg::Paste(text.clone())),
            Act::Resize(columns, rows) => harness.resizes(*columns, *rows),
            Act::Tab(name) => {
                if !turn(&mut harness, name) {
                    return Err(ReplayFailure::NoTab(*line, name.clone()));
                }
            }
            Act::Wait(time) => pass(&mut harness, *time),
            Act::UntilSolved | Act::Pause => {}
            Act::Caption(text) => {
                harness.model.caption = Some(text.clone()).filter(|text| !text.is_empty());
            }
            Act::Picture(name) => {
                let text = harness.text();
                pictures.push(Picture { name: name.clone(), text, svg: svg::screen(harness.draws()) });
            }
            Act::Expect(text) => {
                let screen = harness.text();
                if !collapsed(&screen).contains(&collapsed(text)) {
                    return Err(ReplayFailure::NotSeen { line: *line, text: text.clone(), screen });
                }
            }
        }
    }
    Ok(ReplayResult { pictures, last: harness.text() })
}

/// File or analysis that a session opens.
pub fn to_open(
    named: &str,
    folder: &Path,
) -> Result<(Option<PathBuf>, Option<&'static Entry>), ReplayFailure> {
    let path = folder.join(named);
    match find(named) {
        Some(entry) => Ok((None, Some(entry))),
        None if path.is_file() => Ok((Some(path), None)),
        None => Err(ReplayFailure::NothingToOpen(named.to_owned())),
    }
}

/// Columns are made of blanks: any number of them is one.
fn collapsed(text: &str) -> String {
    let lines = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "));
    lines.collect::<Vec<_>>().join("\n")
}

/// Types the keys to a pane; says whether it is there.
fn turn(harness: &mut Harness, name: &str) -> bool {
    let most = panes::all().len() + 2;
    for _ in 0..most {
        let Some(key) = key_to_tab(&harness.model, name) else { return true };
        harness.happens(Msg::Key(key));
    }
    false
}

fn pass(harness: &mut Harness, time: Duration) {
    let mut left = time;
    while let Some(tempo) = tempo(&harness.model).filter(|tempo| !tempo.is_zero() && *tempo <= left) {
        left -= tempo;
        harness.happens(Msg::Tick);
    }
}
