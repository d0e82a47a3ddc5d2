//! Writes down what a user does, as a session that can be played again.

use std::{
    fs::File,
    io::{self, Write},
    path::Path,
    time::{Duration, Instant},
};

use dalembert_core::Language;

use super::quoted;
use crate::{keys::notation::written, look::Appearance, model::Msg};

/// Shorter pauses are those between the keys of one hand.
const PAUSE: Duration = Duration::from_millis(600);
/// A user who went for a coffee need not be waited for.
const LONGEST: Duration = Duration::from_secs(5);

/// A session as it is recorded. What was done is in the file when the next thing is done, or the recorder is dropped.
#[derive(Debug)]
pub(crate) struct Recorder {
    file: File,
    /// The keys of the line under way.
    keys: String,
    last: Instant,
}

impl Recorder {
    /// Begins a new file; one that is there already is an error.
    pub(crate) fn begin(
        path: &Path,
        (columns, rows): (u16, u16),
        language: Language,
        look: &Appearance,
        open: Option<&str>,
    ) -> io::Result<Self> {
        let mut file = File::create_new(path)?;
        let language = match language {
            Language::English => "en",
            Language::Portuguese => "pt-BR",
        };
        let look = match (look.ascii, look.colors) {
            (true, _) => "ascii",
            (false, crate::glyphs::Colors::None) => "plain",
            (false, _) => "colour",
        };
        writeln!(file, "screen {columns}x{rows}\nlanguage {language}\nlook {look}")?;
        if let Some(open) = open {
            writeln!(file, "open {open}")?;
        }
        Ok(Self { file, keys: String::new(), last: Instant::now() })
    }

    /// Notes what a user did; anything else that happens follows from it.
    pub(crate) fn note(&mut self, msg: &Msg) -> io::Result<()> {
        let pause = std::mem::replace(&mut self.last, Instant::now()).elapsed();
        let line = match msg {
            Msg::Key(_) => String::new(),
            Msg::Paste(text) => format!("paste {}", quoted(text)),
            Msg::Resize(columns, rows) => format!("resize {columns}x{rows}"),
            _ => return Ok(()),
        };
        if pause > PAUSE || !line.is_empty() {
            self.end_line()?;
        }
        if pause > PAUSE {
            writeln!(self.file, "wait {} ms", pause.min(LONGEST).as_millis())?;
        }
        if !line.is_empty() {
            writeln!(self.file, "{line}")?;
        }
        if let Msg::Key(key) = msg {
            self.keys += &written(*key);
        }
        Ok(())
    }

    fn end_line(&mut self) -> io::Result<()> {
        let keys = std::mem::take(&mut self.keys);
        if keys.is_empty() {
            return Ok(());
        }
        // Blanks at the ends of a line are nobody's.
        let inner = keys.trim_matches(' ');
        let before = keys.len() - keys.trim_start_matches(' ').len();
        let after = keys.len() - before - inner.len();
        let space = |count| "<space>".repeat(count);
        writeln!(self.file, "type {}{inner}{}", space(before), space(after))
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        // Nobody is left to be reported.
        let _ = self.end_line();
    }
}
