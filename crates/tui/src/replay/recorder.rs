//! Writes down what a user does, as a session that can be played again.

use std::{
    fs::File,
    io::{self, Seek, SeekFrom, Write},
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

/// A session as it is recorded. Every key is in the file at once, so that a window that is closed loses none.
#[derive(Debug)]
pub(crate) struct Recorder {
    file: File,
    /// The end of the file.
    line: Line,
    /// The same before what is open now was opened: a question, the palette.
    before: Line,
    last: Instant,
}

/// The line under way: where it begins in the file, and its keys.
#[derive(Clone, Debug, Default)]
struct Line {
    begin: u64,
    keys: String,
}

impl Recorder {
    /// Begins a new file, whose head ends in the lines that open something; one that is there already is an error.
    pub(crate) fn begin(
        path: &Path,
        (columns, rows): (u16, u16),
        language: Language,
        look: &Appearance,
        first: &[String],
    ) -> io::Result<Self> {
        let mut file = File::create_new(path)?;
        let language = language.tag();
        let look = match (look.ascii, look.colors) {
            (true, _) => "ascii",
            (false, crate::glyphs::Colors::None) => "plain",
            (false, _) => "colour",
        };
        writeln!(file, "screen {columns}x{rows}\nlanguage {language}\nlook {look}")?;
        for line in first {
            writeln!(file, "{line}")?;
        }
        let line = Line { begin: file.stream_position()?, keys: String::new() };
        Ok(Self { file, before: line.clone(), line, last: Instant::now() })
    }

    /// Notes what a user did; anything else that happens follows from it. `in_dialog` is true if a dialog takes the keys.
    pub(crate) fn note(&mut self, msg: &Msg, in_dialog: bool) -> io::Result<()> {
        if !in_dialog && matches!(msg, Msg::Key(_)) {
            self.before = self.line.clone();
        }
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
            self.end_line()?;
        }
        if !line.is_empty() {
            writeln!(self.file, "{line}")?;
            self.end_line()?;
        }
        if let Msg::Key(key) = msg {
            self.line.keys += &written(*key);
            self.write_line()?;
        }
        Ok(())
    }

    /// Takes out how the program was ended: what is played again leaves the keyboard to whoever looks on.
    pub(crate) fn forget_the_end(&mut self) -> io::Result<()> {
        self.line = self.before.clone();
        self.write_line()
    }

    fn end_line(&mut self) -> io::Result<()> {
        self.line = Line { begin: self.file.stream_position()?, keys: String::new() };
        Ok(())
    }

    /// Writes the line under way over what is there of it.
    fn write_line(&mut self) -> io::Result<()> {
        let keys = &self.line.keys;
        // Blanks at the ends of a line are nobody's.
        let inner = keys.trim_matches(' ');
        let before = keys.len() - keys.trim_start_matches(' ').len();
        let after = keys.len() - before - inner.len();
        let space = |count| "<space>".repeat(count);
        self.file.seek(SeekFrom::Start(self.line.begin))?;
        if !keys.is_empty() {
            writeln!(self.file, "type {}{inner}{}", space(before), space(after))?;
        }
        let end = self.file.stream_position()?;
        self.file.set_len(end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::notation::keys_of;

    fn recorded(does: impl FnOnce(&mut Recorder)) -> String {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("lesson.replay");
        let look = Appearance::default();
        let recorder = Recorder::begin(&path, (80, 24), Language::English, &look, &[]);
        // As if the window were closed: nothing is dropped.
        let mut recorder = std::mem::ManuallyDrop::new(recorder.expect("a new file"));
        does(&mut recorder);
        let text = std::fs::read_to_string(&path).expect("it is there");
        text.split_once("look ascii\n").or(text.split_once("look colour\n")).expect("a head").1.to_owned()
    }

    fn types(recorder: &mut Recorder, keys: &str, in_dialog: bool) {
        for key in keys_of(keys).expect("keys") {
            recorder.note(&Msg::Key(key), in_dialog).expect("written");
        }
    }

    #[test]
    fn every_key_is_in_the_file_at_once() {
        let text = recorded(|recorder| types(recorder, "<end><del>1500 rpm<enter><space>", false));
        assert_eq!(text, "type <end><del>1500 rpm<enter><space>\n");
        let text = recorded(|recorder| {
            types(recorder, "5", false);
            types(recorder, "<space>", false);
            types(recorder, "m", false);
        });
        assert_eq!(text, "type 5 m\n", "a blank at the end becomes one within");
        let text = recorded(|recorder| {
            types(recorder, "a", false);
            recorder.note(&Msg::Resize(90, 30), false).expect("written");
            recorder.note(&Msg::Paste("1; 2".to_owned()), false).expect("written");
            types(recorder, "b", false);
        });
        assert_eq!(text, "type a\nresize 90x30\npaste \"1; 2\"\ntype b\n");
    }

    #[test]
    fn the_end_of_the_program_is_not_recorded() {
        let text = recorded(|recorder| {
            types(recorder, "]]q", false);
            types(recorder, "<down><enter>", true);
            recorder.forget_the_end().expect("written");
        });
        assert_eq!(text, "type ]]\n");
        // A question that was answered otherwise stays.
        let text = recorded(|recorder| {
            types(recorder, "q", false);
            types(recorder, "<esc>", true);
            recorder.note(&Msg::Resize(90, 30), false).expect("written");
            types(recorder, "q", false);
            types(recorder, "<enter>", true);
            recorder.forget_the_end().expect("written");
        });
        assert_eq!(text, "type q<esc>\nresize 90x30\n");
    }
}
