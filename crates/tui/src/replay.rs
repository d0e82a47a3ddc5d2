//! Sessions that are played again: a text of a few words a line, written by a user or recorded.
//!
//! ```text
//! # Twice the speed.
//! screen 120x36
//! language en
//! look colour
//! open vibration/rotating-unbalance
//! expect 19.456
//! type <end><del>2000 rpm<enter>
//! wait 1500 ms
//! picture twice-the-speed
//! ```
//!
//! | line | what it does |
//! |---|---|
//! | `screen COLUMNSxROWS` | the size of the screen, 80x24 without it |
//! | `language en` or `pt-BR` | the language of the interface |
//! | `look colour`, `plain` or `ascii` | sixteen colours, none, or nothing outside ASCII |
//! | `open ID` or `FILE` | begins on an analysis, or on a problem file beside the session |
//! | `field` or `field FILE` | begins in field mode on that file, or on a blank job, which may have a name |
//! | `type KEYS` | keys, as [`keys_of`] reads them |
//! | `paste "TEXT"` | a text, with `\n`, `\t`, `\"` and `\\` |
//! | `resize COLUMNSxROWS` | the window has another size |
//! | `tab NAME` | the keys are in the pane of that English name: `Drawing` |
//! | `wait MILLISECONDS ms`, `wait solved` | lets time pass; animations move |
//! | `pause` | stops until Space, Enter, → or Page Down |
//! | `caption TEXT` | stands below the screen until the next one; alone it takes it away |
//! | `picture NAME` | the screen is to be kept |
//! | `expect TEXT` | the text stands on the screen, or the session fails |

mod caption;
mod headless;
mod player;
mod recorder;
mod svg;
mod tour;

use std::{fmt, path::PathBuf, time::Duration};

use dalembert_core::{Language, Text};
use ratatui::crossterm::event::{KeyCode, KeyEvent};

pub use headless::{Picture, ReplayFailure, ReplayResult, play, to_open};
pub use tour::tour;

pub(crate) use caption::{above as above_caption, draw as draw_caption};
pub(crate) use player::Player;
pub(crate) use recorder::Recorder;

use crate::{
    glyphs::{Capabilities, Colors, Glyphs, PlotMarker},
    keys::notation::keys_of,
    layout::Focus,
    model::Model,
};

/// A session that can be played.
#[derive(Clone, Debug, PartialEq)]
pub struct Replay {
    /// Columns and rows of the screen.
    pub screen: (u16, u16),
    /// The language of the interface.
    pub language: Language,
    /// Capabilities of the screen.
    pub look: Capabilities,
    /// An analysis or a problem file to begin with.
    pub open: Option<String>,
    /// Field mode to begin with, and the file that a blank job is to be saved in.
    pub field: Option<Option<PathBuf>>,
    /// Actions, each with its line number.
    pub acts: Vec<(usize, Act)>,
}

/// Something that is done in a session.
#[derive(Clone, Debug, PartialEq)]
pub enum Act {
    /// Keys are typed.
    Type(Vec<KeyEvent>),
    /// A text is pasted.
    Paste(String),
    /// The window takes another size.
    Resize(u16, u16),
    /// The keys that lead to the pane of this name are typed, wherever it stands.
    Tab(String),
    /// Time passes.
    Wait(Duration),
    /// Time passes until everything is solved.
    UntilSolved,
    /// The session stands until a key lets it go on.
    Pause,
    /// A line below the screen; an empty one takes it away.
    Caption(Text),
    /// The screen is kept under this name.
    Picture(String),
    /// This stands on the screen.
    Expect(String),
}

/// A line that cannot be read, and what to write instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Unreadable {
    /// The line, from 1.
    pub line: usize,
    /// Description of the error.
    pub why: Text,
}

/// Message for a line with an unknown command.
const UNKNOWN: &str = "unknown command `{word}`: write screen, language, look, open, field, type, paste, resize, tab, wait, pause, caption, picture or expect";

/// The looks, by their names.
const LOOKS: [(&str, Capabilities); 3] = [
    (
        "colour",
        Capabilities { glyphs: Glyphs::Unicode, colors: Colors::Sixteen, marker: PlotMarker::Braille },
    ),
    ("plain", Capabilities { glyphs: Glyphs::Unicode, colors: Colors::None, marker: PlotMarker::Braille }),
    ("ascii", Capabilities { glyphs: Glyphs::Ascii, colors: Colors::None, marker: PlotMarker::Ascii }),
];

impl Unreadable {
    /// The sentence, for a user.
    pub fn text(&self) -> Text {
        Text::new("line {line}: {why}").with("line", self.line).with_text("why", self.why.clone())
    }
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text().english())
    }
}

impl std::error::Error for Unreadable {}

impl Replay {
    /// Reads a session.
    pub fn read(text: &str) -> Result<Self, Unreadable> {
        let mut replay = Self {
            screen: (80, 24),
            language: Language::English,
            look: LOOKS[0].1,
            open: None,
            field: None,
            acts: Vec::new(),
        };
        for (at, line) in text.lines().enumerate() {
            let line = line.trim();
            if !line.is_empty() && !line.starts_with('#') {
                replay.take(at + 1, line).map_err(|why| Unreadable { line: at + 1, why })?;
            }
        }
        Ok(replay)
    }

    fn take(&mut self, at: usize, line: &str) -> Result<(), Text> {
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim_start();
        let quoting = |template: &'static str, word: &str| Text::new(template).with("word", word);
        let act = match word {
            "screen" | "language" | "look" | "open" | "field" if !self.acts.is_empty() => {
                return Err(quoting("`{word}` must come before the first action", word));
            }
            "screen" => {
                self.screen = size(rest)?;
                return Ok(());
            }
            "language" => {
                let unknown = || quoting("`{word}` is not a language: write `en` or `pt-BR`", rest);
                self.language = Language::of_tag(rest).ok_or_else(unknown)?;
                return Ok(());
            }
            "look" => {
                let known = LOOKS.iter().find(|(name, _)| *name == rest);
                let unknown =
                    || quoting("`{word}` is not a display mode: write `colour`, `plain` or `ascii`", rest);
                self.look = known.ok_or_else(unknown)?.1;
                return Ok(());
            }
            "open" if rest.is_empty() => return Err("write the id of an analysis or a file".into()),
            "open" => {
                self.open = Some(rest.to_owned());
                return Ok(());
            }
            "field" => {
                self.field = Some(Some(PathBuf::from(rest)).filter(|_| !rest.is_empty()));
                return Ok(());
            }
            "type" => Act::Type(
                keys_of(rest).map_err(|name| quoting("{word} is not a key; write `<lt>` for `<`", &name))?,
            ),
            "paste" => Act::Paste(unquoted(rest)?),
            "resize" => {
                let (columns, rows) = size(rest)?;
                Act::Resize(columns, rows)
            }
            "tab" => Act::Tab(name(rest)?),
            "wait" if rest == "solved" => Act::UntilSolved,
            "wait" => Act::Wait(milliseconds(rest)?),
            "pause" => Act::Pause,
            "caption" => Act::Caption(Text::verbatim(rest)),
            "picture" => Act::Picture(name(rest)?),
            "expect" if rest.is_empty() => return Err("give the expected text".into()),
            "expect" => Act::Expect(rest.to_owned()),
            _ => return Err(quoting(UNKNOWN, word)),
        };
        self.acts.push((at, act));
        Ok(())
    }
}

fn size(text: &str) -> Result<(u16, u16), Text> {
    let (columns, rows) = text.split_once(['x', '×']).unwrap_or_default();
    match (columns.parse(), rows.parse()) {
        (Ok(columns @ 1..=1000), Ok(rows @ 1..=1000)) => Ok((columns, rows)),
        _ => {
            Err(Text::new("`{text}` is not a size: write columns and rows, as in `120x36`")
                .with("text", text))
        }
    }
}

fn milliseconds(text: &str) -> Result<Duration, Text> {
    let number = text.strip_suffix("ms").unwrap_or(text).trim();
    let wrong = |_| Text::new("`{text}` is not a duration: write `400 ms` or `solved`").with("text", text);
    number.parse().map(Duration::from_millis).map_err(wrong)
}

/// The next key on the way to the pane of a name; `None` where the keys are there, or there is no problem.
fn key_to_tab(model: &Model, name: &str) -> Option<KeyEvent> {
    let bench = model.bench.as_ref()?;
    let code = if bench.shown().name() != name {
        KeyCode::Char(']')
    } else if bench.focus == Focus::Form {
        KeyCode::Tab
    } else {
        return None;
    };
    Some(KeyEvent::from(code))
}

/// The name of a pane or a picture. That of a picture is the name of its file: nothing that could lead elsewhere.
fn name(text: &str) -> Result<String, Text> {
    let fits = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if !text.is_empty() && text.len() <= 64 && text.chars().all(fits) {
        return Ok(text.to_owned());
    }
    Err(Text::new("`{text}` is not a name: use letters, digits, `-` and `_`").with("text", text))
}

/// A text as it is, between quotes.
fn quoted(text: &str) -> String {
    let mut written = String::from('"');
    for character in text.chars() {
        match character {
            '\n' => written += "\\n",
            '\t' => written += "\\t",
            '"' | '\\' => written.extend(['\\', character]),
            _ => written.push(character),
        }
    }
    written + "\""
}

fn unquoted(text: &str) -> Result<String, Text> {
    let inner = text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    let mut characters =
        inner.ok_or_else(|| Text::new("`{text}` is not in quotes").with("text", text))?.chars();
    let mut read = String::new();
    while let Some(character) = characters.next() {
        read.push(match character {
            '\\' => match characters.next() {
                Some('n') => '\n',
                Some('t') => '\t',
                Some(other @ ('"' | '\\')) => other,
                other => {
                    let other = other.map_or(String::new(), String::from);
                    return Err(Text::new("unknown escape `\\{word}`").with("word", other));
                }
            },
            '"' => return Err("write `\\` before a quote within the text".into()),
            _ => character,
        });
    }
    Ok(read)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_session_is_read() {
        let text = "# two lines\nscreen 120×36\n\nlanguage pt-BR\nlook ascii\nopen vibration/rotating-unbalance\n\
                    type <end>1500 rpm<enter>\ntab Drawing\n  wait 400 ms\nwait solved\npaste \"1; 2\\n\\\"3\\\\\"\nresize 80x24\n\
                    picture fan_1\nexpect 4.5535 mm\ncaption The peak.\npause\ncaption\n";
        let replay = Replay::read(text).expect("a session");
        assert_eq!((replay.screen, replay.language), ((120, 36), Language::Portuguese));
        assert_eq!(replay.look.glyphs, Glyphs::Ascii);
        assert_eq!(replay.open.as_deref(), Some("vibration/rotating-unbalance"));
        assert_eq!(
            replay.acts,
            [
                (7, Act::Type(keys_of("<end>1500 rpm<enter>").expect("keys"))),
                (8, Act::Tab("Drawing".to_owned())),
                (9, Act::Wait(Duration::from_millis(400))),
                (10, Act::UntilSolved),
                (11, Act::Paste("1; 2\n\"3\\".to_owned())),
                (12, Act::Resize(80, 24)),
                (13, Act::Picture("fan_1".to_owned())),
                (14, Act::Expect("4.5535 mm".to_owned())),
                (15, Act::Caption(Text::verbatim("The peak."))),
                (16, Act::Pause),
                (17, Act::Caption(Text::verbatim(""))),
            ]
        );
    }

    #[test]
    fn what_cannot_be_read_is_named_with_its_line() {
        for (text, line, words) in [
            ("screen 80", 1, "120x36"),
            ("\nscreen 80x0", 2, "120x36"),
            ("language fr", 1, "pt-BR"),
            ("look dark", 1, "colour"),
            ("open", 1, "analysis"),
            ("type <return>", 1, "<return>"),
            ("paste text", 1, "quotes"),
            ("paste \"\\q\"", 1, "\\q"),
            ("wait long", 1, "400 ms"),
            ("picture ../up", 1, "letters"),
            ("press x", 1, "press"),
            ("type x\nscreen 80x24", 2, "before"),
        ] {
            let error = Replay::read(text).expect_err(text);
            assert_eq!(error.line, line, "{text}");
            assert!(error.to_string().contains(words), "{text}: {error}");
        }
    }

    #[test]
    fn quotes_go_there_and_back() {
        for text in ["", "a\n\tb", "\"\\", "0,5; 1"] {
            assert_eq!(unquoted(&quoted(text)).as_deref(), Ok(text));
        }
    }
}
