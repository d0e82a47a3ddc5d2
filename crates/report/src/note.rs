//! Calculation notes that carry their problem file: as a comment at their end, from which the same note can be written again
//! and compared.

use std::path::Path;

use dalembert_core::{Language, Locale, Text};
use itertools::Itertools as _;
use serde_json::{Value as Json, json};
use similar::{Algorithm, DiffOp, capture_diff_slices};

use crate::{
    DocumentFormat, Parts,
    document::{Block, Document},
};

/// Begin of the comment, before its options.
const BEGIN: &str = "problem file of dalembert ";
/// Last line of the comment.
const END: &str = "end of the problem file";
/// Signs that a comment of HTML cannot hold, and those that stand for them there.
const ESCAPES: [(&str, &str); 2] = [("&", "&amp;"), ("--", "&#45;&#45;")];

/// Problem file of a note, and the options with which the note was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoteSource {
    /// Version of the program.
    pub version: String,
    /// Language.
    pub language: Language,
    /// Number of significant digits.
    pub digits: u8,
    /// True if the note has ASCII alone.
    pub ascii: bool,
    /// Answers whose working alone is printed; empty for all.
    pub answers: Vec<String>,
    /// Parts of the solution that the note has.
    pub parts: Parts,
    /// Text of the problem file.
    pub problem_file: String,
}

/// A line of a note that is not as the program writes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Line of the note, counted from 1, and its text; `None` where a line is missing.
    pub printed: Option<(usize, String)>,
    /// The line as it is now.
    pub computed: String,
}

impl NoteSource {
    /// The source of a note that is written now.
    pub fn new(problem_file: String, answers: &[String], parts: Parts, locale: &Locale) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            language: locale.language,
            digits: locale.style.digits,
            ascii: locale.style.ascii,
            answers: answers.to_vec(),
            parts,
            problem_file,
        }
    }

    /// A note with its source behind it; plain text has no comments and stays as it is.
    pub fn append_to(&self, note: String, format: DocumentFormat) -> String {
        let options = json!({
            "version": self.version,
            "language": self.language.tag(),
            "digits": self.digits,
            "ascii": self.ascii,
            "answers": self.answers,
            "parts": self.parts.name(),
        });
        let begin = format!("{BEGIN}{options}");
        let lines = [begin.as_str()].into_iter().chain(self.problem_file.lines()).chain([END]);
        let with =
            |sign: &str| lines.clone().map(|line| format!("{sign}{line}\n")).collect::<Vec<_>>().concat();
        match format {
            DocumentFormat::Text => note,
            DocumentFormat::Latex => format!("{note}{}", with("% ")),
            DocumentFormat::Typst => format!("{note}\n{}", with("// ")),
            DocumentFormat::Html | DocumentFormat::Markdown => {
                let escaped = ESCAPES.iter().fold(with(""), |text, (from, to)| text.replace(from, to));
                format!("{note}\n<!--\n{escaped}-->\n")
            }
        }
    }

    /// The note as files, as [`DocumentFormat::files`] has them, with its source.
    pub fn files(
        &self,
        format: DocumentFormat,
        document: &Document,
        path: &Path,
        locale: &Locale,
    ) -> Option<Vec<(String, String)>> {
        let mut files = format.files(document, path, locale)?;
        if let Some((_, note)) = files.first_mut() {
            *note = self.append_to(std::mem::take(note), format);
        }
        Some(files)
    }

    /// The source of a note.
    ///
    /// # Errors
    /// A note without one, or with one that was damaged.
    pub fn of_note(note: &str) -> Result<Self, Text> {
        let mut lines = note.lines().skip_while(|line| !line.contains(BEGIN));
        let first = lines
            .next()
            .ok_or("the note holds no problem file; `dalembert solve --output` writes notes that do")?;
        let (sign, _) = first.split_once(BEGIN).unwrap_or_default();
        let bare = |line: &str| {
            let line = line.strip_prefix(sign).or(line.strip_prefix(sign.trim_end())).unwrap_or(line);
            if sign.is_empty() {
                ESCAPES.iter().rev().fold(line.to_owned(), |line, (from, to)| line.replace(to, from))
            } else {
                line.to_owned()
            }
        };
        let damaged = || {
            Text::from(
                "the problem file in the note is damaged: its first or last line is not as it was written",
            )
        };
        let first = bare(first);
        let options =
            first.strip_prefix(BEGIN).and_then(|options| serde_json::from_str::<Json>(options).ok());
        let options = options.ok_or_else(damaged)?;
        let (mut problem_file, mut is_whole) = (String::new(), false);
        for line in lines.map(bare) {
            if line.trim_end() == END {
                is_whole = true;
                break;
            }
            problem_file += &line;
            problem_file.push('\n');
        }
        let text = |key: &str| options[key].as_str().ok_or_else(damaged);
        let answers = options["answers"].as_array().ok_or_else(damaged)?;
        // Older notes have everything.
        let parts = options["parts"].as_str().map_or(Some(Parts::Full), Parts::of_name);
        let digits = options["digits"].as_u64().and_then(|digits| u8::try_from(digits).ok());
        if !is_whole {
            return Err(damaged());
        }
        Ok(Self {
            version: text("version")?.to_owned(),
            language: Language::of_tag(text("language")?).ok_or_else(damaged)?,
            digits: digits.filter(|digits| (1..=17).contains(digits)).ok_or_else(damaged)?,
            ascii: options["ascii"].as_bool().ok_or_else(damaged)?,
            answers: answers.iter().filter_map(Json::as_str).map(str::to_owned).collect(),
            parts: parts.ok_or_else(damaged)?,
            problem_file,
        })
    }
}

/// Compares a note with its document as it is now: every line of data, answers, steps and tables must stand in the note, in
/// their order. Gives the number of those lines, and those that do not. What else stands in the note is not compared:
/// remarks may be added, and figures differ in their last digit from machine to machine.
pub fn differences(
    note: &str,
    document: &Document,
    format: DocumentFormat,
    locale: &Locale,
) -> (usize, Vec<Difference>) {
    let write =
        |blocks: Vec<Block>| format.write(&Document { title: document.title.clone(), blocks }, None, locale);
    let frame = write(Vec::new());
    let now = write(document.blocks.iter().filter(|block| is_compared(block)).cloned().collect());
    let frame: Vec<&str> = frame.lines().collect();
    let now: Vec<&str> = now.lines().filter(|line| !line.is_empty() && !frame.contains(line)).collect();
    let printed: Vec<&str> = note.lines().collect();
    compared(&now, &printed, &|line| words(line, format))
}

/// True of what a note must have as it is computed.
pub(crate) fn is_compared(block: &Block) -> bool {
    matches!(block, Block::TitleBlock(_) | Block::Lines(_) | Block::Step(..) | Block::Table(_))
}

/// Compares the lines of a note with those that it is to have: their number, and those that are not in it.
pub(crate) fn compared(
    now: &[&str],
    printed: &[&str],
    words: &impl Fn(&str) -> String,
) -> (usize, Vec<Difference>) {
    let mut found = Vec::new();
    for operation in capture_diff_slices(Algorithm::Myers, now, printed) {
        let (old, new) = match operation {
            DiffOp::Equal { .. } | DiffOp::Insert { .. } => continue,
            DiffOp::Delete { old_index, old_len, new_index } => {
                (old_index..old_index + old_len, new_index..new_index)
            }
            DiffOp::Replace { old_index, old_len, new_index, new_len } => {
                (old_index..old_index + old_len, new_index..new_index + new_len)
            }
        };
        let mut left: Vec<(usize, String)> = new.map(|at| (at + 1, words(printed[at]))).collect();
        for computed in old.map(|line| words(now[line])) {
            // Of the lines in its place, the one that says most of the same.
            let common = |(_, text): &(usize, String)| {
                text.split_whitespace().filter(|word| computed.split_whitespace().contains(word)).count()
            };
            let place = left.iter().map(common).position_max().filter(|at| common(&left[*at]) > 0);
            found.push(Difference { printed: place.map(|at| left.remove(at)), computed });
        }
    }
    (now.len(), found)
}

/// The words of a line, without the elements of HTML around them.
fn words(line: &str, format: DocumentFormat) -> String {
    if format != DocumentFormat::Html {
        return line.trim().to_owned();
    }
    let parts = line.split('<').map(|part| part.split_once('>').map_or(part, |(_, words)| words));
    let parts = parts.map(str::trim).filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NamedValue;

    const FORMATS: [DocumentFormat; 4] =
        [DocumentFormat::Markdown, DocumentFormat::Html, DocumentFormat::Latex, DocumentFormat::Typst];

    fn document(value: &str) -> Document {
        let line = |label: &str, value: &str| NamedValue {
            label: label.to_owned(),
            value: value.to_owned(),
            ..NamedValue::default()
        };
        let blocks = vec![
            Block::Paragraph("A fan.".to_owned()),
            Block::Lines(vec![line("mass", "40 kg")]),
            Block::Heading("Answers".to_owned()),
            Block::Lines(vec![line("amplitude", value), line("frequency", "106.2 rad/s")]),
        ];
        Document { title: "Fan".to_owned(), blocks }
    }

    #[test]
    fn a_note_gives_its_problem_file_back() {
        let locale = Locale::portuguese();
        let file = "title = \"a <!-- b --> & --- %\"\n\n[inputs]\nmass = \"40 kg\"\n";
        let source = NoteSource::new(file.to_owned(), &["x".to_owned()], Parts::Answers, &locale);
        for format in FORMATS {
            let note = source.append_to(format.write(&document("19 mm"), None, &locale), format);
            assert_eq!(NoteSource::of_note(&note).as_ref(), Ok(&source), "{note}");
            let trimmed: Vec<&str> = note.lines().map(str::trim_end).collect();
            let trimmed = trimmed.join("\r\n");
            assert_eq!(NoteSource::of_note(&trimmed).as_ref(), Ok(&source), "{note}");
            assert!(NoteSource::of_note(&note.replace(END, "")).is_err());
        }
        assert!(NoteSource::of_note("= Fan\n").unwrap_err().english().starts_with("the note holds no"));
    }

    #[test]
    fn a_line_that_was_changed_is_found_and_a_remark_is_none() {
        let locale = Locale::english();
        for format in FORMATS {
            let note = format.write(&document("19.456 mm"), None, &locale);
            let (count, found) = differences(&note, &document("19.456 mm"), format, &locale);
            assert!(count >= 3, "{count} lines of {format:?}");
            assert_eq!(found, [], "{note}");
            let remarked = note.replace("A fan.", "A fan.\n\nChecked by hand.");
            assert_eq!(differences(&remarked, &document("19.456 mm"), format, &locale).1, []);
            let (_, found) =
                differences(&note.replace("456 mm", "465 mm"), &document("19.456 mm"), format, &locale);
            assert_eq!(found.len(), 1, "{found:?}");
            assert!(found[0].computed.contains("456 mm"), "{found:?}");
            assert!(found[0].printed.as_ref().is_some_and(|(_, line)| line.contains("465 mm")), "{found:?}");
        }
    }
}
