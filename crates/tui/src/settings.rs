//! Settings of the user: one TOML file, `dalembert/settings.toml` in the folder of configurations.
//!
//! [`parse`] takes what it can and says of the rest in which line it stands and what to write instead; so a slip in
//! the file never keeps anybody from working. [`default_file`] is a file that says what can be set and sets nothing.

mod write;

use std::{
    ops::Range,
    path::{Path, PathBuf},
    time::Duration,
};

use dalembert_core::{Language, Text, file, nearest};
use dalembert_units::{Decimal, Style};
use etcetera::{BaseStrategy, choose_base_strategy};
use toml_edit::{Document, Item, TableLike};

pub use self::write::default_file;
use crate::{
    files::{self, FileError},
    glyphs::{Capabilities, Glyphs},
    keys::{Key, KeyChange, KeyContext, KeyMap},
    look::Theme,
    panes::places,
    plot::Marker,
};

dalembert_core::messages!("../locales/settings.pt-BR.ftl");

/// Settings of the user; without a file, the defaults.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The language; `None`: that of the environment.
    pub language: Option<Language>,
    /// Colour theme.
    pub theme: Theme,
    /// Nothing outside ASCII, whatever the terminal promises.
    pub ascii: bool,
    /// True to capture mouse events; `None`: unless the session is remote.
    pub mouse: Option<bool>,
    /// True for pictures in pixels where the terminal shows them; `None`: unless the session is remote.
    pub pixels: Option<bool>,
    /// Marker of curves; `None`: the finest that the terminal shows.
    pub marker: Option<Marker>,
    /// The decimal mark; `None`: that of the language.
    pub decimal: Option<Decimal>,
    /// Significant digits of results.
    pub digits: u8,
    /// Playback speed of animations, over their own; at 0 they are paused until a key starts them.
    pub animation_speed: f64,
    /// The command that edits a file; `None`: that of `$VISUAL` or `$EDITOR`.
    pub editor: Option<String>,
    /// Key map.
    pub keys: KeyMap,
}

/// Something in the file that cannot be taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Line number, from 1.
    pub line: usize,
    /// Description of the error and of its repair.
    pub why: Text,
}

impl Fault {
    /// Fault at a byte range of a text.
    pub fn of(text: &str, span: Option<Range<usize>>, why: Text) -> Self {
        Self { line: line_of(text, span), why }
    }

    /// The sentence, with its line.
    pub fn text(&self) -> Text {
        Text::new("line {line}: {why}").with("line", self.line).with_text("why", self.why.clone())
    }

    /// The sentence, with its file as it is shown.
    pub fn text_in(&self, file: impl std::fmt::Display) -> Text {
        Text::new("in {file}, {why}").with("file", file).with_text("why", self.text())
    }
}

/// The settings at the top of the file, in its order.
const KEYS: [&str; 11] = [
    "language",
    "theme",
    "ascii",
    "mouse",
    "pixels",
    "marker",
    "decimal",
    "digits",
    "animation-speed",
    "editor",
    "keys",
];
/// Names of markers.
const MARKERS: [(&str, Marker); 4] = [
    ("braille", Marker::Braille),
    ("half-block", Marker::HalfBlock),
    ("dots", Marker::Dot),
    ("ascii", Marker::Ascii),
];
/// Names of decimal marks.
const DECIMALS: [(&str, Decimal); 2] = [("point", Decimal::Point), ("comma", Decimal::Comma)];
/// The fastest animation.
const FASTEST: f64 = 100.0;

impl Default for Settings {
    fn default() -> Self {
        Self {
            language: None,
            theme: Theme::default(),
            ascii: false,
            mouse: None,
            pixels: None,
            marker: None,
            decimal: None,
            digits: Style::default().digits,
            animation_speed: 1.0,
            editor: None,
            keys: KeyMap::default(),
        }
    }
}

impl Settings {
    /// The time in which a terminal has to answer that it shows pictures in pixels; `None` where it is not asked.
    pub(crate) fn wait_for_pixels(&self, capabilities: &Capabilities, is_remote: bool) -> Option<Duration> {
        let wait = match self.pixels {
            Some(true) => Duration::from_secs(1),
            None if !is_remote => Duration::from_millis(20),
            _ => return None,
        };
        (capabilities.glyphs == Glyphs::Unicode).then_some(wait)
    }
}

/// Path of the file, whether it exists or not; `None` without a home folder.
pub fn path() -> Option<PathBuf> {
    let base = choose_base_strategy().ok()?;
    Some(base.config_dir().join("dalembert").join("settings.toml"))
}

/// Reads the file. Where there is none, or it cannot be read, these are the defaults.
pub fn read(path: &Path) -> (Settings, Vec<Fault>) {
    match files::read(path) {
        Ok(opened) => parse(&opened.text),
        Err(FileError::Missing(_)) => (Settings::default(), Vec::new()),
        Err(error) => (Settings::default(), vec![Fault { line: 1, why: error.text() }]),
    }
}

/// Takes what a file sets, and says what cannot be taken.
pub fn parse(text: &str) -> (Settings, Vec<Fault>) {
    let document = match Document::parse(text) {
        Ok(document) => document,
        Err(error) => {
            let why = Text::new("not valid TOML: {why}").with("why", error.message().replace('\n', "; "));
            return (Settings::default(), vec![Fault { line: line_of(text, error.span()), why }]);
        }
    };
    let mut reader = Reader { text, settings: Settings::default(), faults: Vec::new() };
    let mut changes = Vec::new();
    for (key, item) in document.as_table() {
        match (key, item.as_table_like()) {
            ("keys", Some(table)) => reader.keys(table, None, &mut changes),
            ("keys", None) => {
                let why =
                    Text::new("`keys` is a table: write [keys] and, below it, for example save = \"ctrl-s\"");
                reader.fault(span_in(document.as_table(), key), why);
            }
            _ => {
                if let Err(why) = reader.set(key, item) {
                    reader.fault(span_in(document.as_table(), key), why);
                }
            }
        }
    }
    let (asked, spans): (Vec<KeyChange>, Vec<Option<Range<usize>>>) = changes.into_iter().unzip();
    let (keys, refused) = KeyMap::changed(&places(), &asked);
    reader.settings.keys = keys;
    for (n, why) in refused {
        reader.fault(spans[n].clone(), why);
    }
    reader.faults.sort_by_key(|fault| fault.line);
    (reader.settings, reader.faults)
}

struct Reader<'t> {
    text: &'t str,
    settings: Settings,
    faults: Vec<Fault>,
}

impl Reader<'_> {
    fn fault(&mut self, span: Option<Range<usize>>, why: Text) {
        self.faults.push(Fault { line: line_of(self.text, span), why });
    }

    fn set(&mut self, key: &str, item: &Item) -> Result<(), Text> {
        let settings = &mut self.settings;
        match key {
            "language" => {
                settings.language = Some(one_of(key, item, &Language::ALL.map(|one| (one.tag(), one)))?);
            }
            "theme" => settings.theme = one_of(key, item, &Theme::ALL.map(|theme| (theme.id(), theme)))?,
            "ascii" => settings.ascii = flag(key, item)?,
            "mouse" => settings.mouse = Some(flag(key, item)?),
            "pixels" => settings.pixels = Some(flag(key, item)?),
            "marker" => settings.marker = Some(one_of(key, item, &MARKERS)?),
            "decimal" => settings.decimal = Some(one_of(key, item, &DECIMALS)?),
            "digits" => match item.as_integer().and_then(|digits| u8::try_from(digits).ok()) {
                Some(digits @ 1..=17) => settings.digits = digits,
                _ => return Err(Text::new("`digits` is an integer from 1 to 17")),
            },
            "animation-speed" | "film-speed" => {
                match item.as_float().or_else(|| item.as_integer().map(|whole| whole as f64)) {
                    Some(speed) if (0.0..=FASTEST).contains(&speed) => settings.animation_speed = speed,
                    _ => return Err(Text::new("`animation-speed` is a number from 0 (paused) to 100")),
                }
            }
            "editor" => match item.as_str().map(str::trim) {
                Some(command) if !command.is_empty() => settings.editor = Some(command.to_owned()),
                _ => {
                    return Err(Text::new(
                        "`editor` is a command in quotes, such as \"nano\" or \"code --wait\"",
                    ));
                }
            },
            _ => return Err(unknown("setting", key, &KEYS)),
        }
        Ok(())
    }

    /// The changes of `[keys]`, or of the part of it that belongs to one place.
    fn keys(
        &mut self,
        table: &dyn TableLike,
        place: Option<KeyContext>,
        changes: &mut Vec<(KeyChange, Option<Range<usize>>)>,
    ) {
        for (key, item) in table.iter() {
            let span = span_in(table, key);
            if let (Some(inner), None) = (item.as_table_like(), place) {
                let places = places();
                match places.iter().copied().find(|place| place.id() == key) {
                    Some(place) => self.keys(inner, Some(place), changes),
                    None => {
                        let known: Vec<&str> = places.into_iter().map(KeyContext::id).collect();
                        self.fault(span, unknown("place", key, &known));
                    }
                }
                continue;
            }
            match change(place, key, item) {
                Ok(change) => changes.push((change, span)),
                Err(why) => self.fault(span, why),
            }
        }
    }
}

/// A line of `[keys]`: `save = "ctrl-s"`, `save = ["s", "ctrl-s"]`, `save = []`.
fn change(place: Option<KeyContext>, name: &str, item: &Item) -> Result<KeyChange, Text> {
    let known: Vec<&'static str> =
        places().into_iter().flat_map(KeyContext::bindings).map(|binding| binding.action.id()).collect();
    let Some(action) = known.iter().find(|known| **known == name).copied() else {
        return Err(unknown("action", name, &known));
    };
    let written: Option<Vec<&str>> = match (item.as_str(), item.as_array()) {
        (Some(key), _) => Some(vec![key]),
        (None, Some(array)) => array.iter().map(toml_edit::Value::as_str).collect(),
        (None, None) => None,
    };
    let keys = written.ok_or_else(|| {
        Text::new("`{action}` is a key in quotes, or several: [\"s\", \"ctrl-s\"]").with("action", action)
    })?;
    let keys = keys.into_iter().map(Key::parse).collect::<Result<_, _>>()?;
    Ok(KeyChange { place, action, keys })
}

fn one_of<T: Copy>(key: &str, item: &Item, known: &[(&'static str, T)]) -> Result<T, Text> {
    let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
    let Some(written) = item.as_str() else {
        return Err(Text::new("`{key}` is one of {known}, in quotes")
            .with("key", key)
            .with("known", names.join(", ")));
    };
    let found = known.iter().find(|(name, _)| *name == written).map(|(_, value)| *value);
    found.ok_or_else(|| match nearest(written, names.iter().copied()) {
        Some(near) => Text::new("`{key}` cannot be `{written}`; did you mean `{near}`?")
            .with("key", key)
            .with("written", written)
            .with("near", near),
        None => Text::new("`{key}` cannot be `{written}`; write one of {known}")
            .with("key", key)
            .with("written", written)
            .with("known", names.join(", ")),
    })
}

fn flag(key: &str, item: &Item) -> Result<bool, Text> {
    item.as_bool().ok_or_else(|| Text::new("`{key}` is true or false, without quotes").with("key", key))
}

fn unknown(kind: &'static str, name: &str, known: &[&str]) -> Text {
    let near = nearest(name, known.iter().copied());
    let text = match (kind, near.is_some()) {
        ("setting", true) => Text::new("unknown setting `{name}`; did you mean `{near}`?"),
        ("setting", false) => Text::new("unknown setting `{name}`; `dalembert settings` lists them"),
        ("place", true) => Text::new("unknown table `{name}`; did you mean `{near}`?"),
        ("place", false) => Text::new("unknown table `{name}`; `dalembert settings` lists them"),
        (_, true) => Text::new("unknown command `{name}`; did you mean `{near}`?"),
        (_, false) => Text::new("unknown command `{name}`; `dalembert settings` lists them"),
    };
    let text = text.with("name", name.chars().take(60).collect::<String>());
    match near {
        Some(near) => text.with("near", near),
        None => text,
    }
}

/// Byte range of a key of a table.
fn span_in(table: &dyn TableLike, key: &str) -> Option<Range<usize>> {
    table.key(key).and_then(toml_edit::Key::span)
}

fn line_of(text: &str, span: Option<Range<usize>>) -> usize {
    file::line_of(text, span.map_or(0, |span| span.start))
}

#[cfg(test)]
mod tests;
