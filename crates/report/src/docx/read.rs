//! Reads a note for Word again: its problem file, and its lines. Word writes a document its own way when it saves it, so
//! that paragraphs and rows of tables are compared by their letters.

use std::io::{Cursor, Read as _};

use dalembert_core::Text;
use quick_xml::{
    Reader,
    escape::resolve_xml_entity,
    events::{BytesRef, Event},
};
use zip::ZipArchive;

use super::{DOCUMENT, SOURCE_NAMESPACE, body};
use crate::{
    Difference, Document, NoteSource,
    document::Block,
    note::{compared, is_compared},
};

/// The largest part that is read, in bytes.
const LARGEST: u64 = 64 << 20;

/// A note for Word as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DocxNote {
    /// Source of the note: problem file, language, digits.
    pub source: NoteSource,
    lines: Vec<String>,
}

impl DocxNote {
    /// The note in the bytes of a file.
    ///
    /// # Errors
    /// What is no document of Word, and one without a problem file.
    pub fn read(bytes: &[u8]) -> Result<Self, Text> {
        let damaged = || Text::from("the file is no document of Word, or is damaged");
        let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|_| damaged())?;
        let mut part = |name: &str| {
            let mut text = String::new();
            let read = archive.by_name(name).map(|part| part.take(LARGEST).read_to_string(&mut text));
            matches!(read, Ok(Ok(_))).then_some(text)
        };
        let lines = lines(&part(DOCUMENT).ok_or_else(damaged)?).ok_or_else(damaged)?;
        // Word numbers custom parts anew.
        let sources = (1..10).filter_map(|n| part(&format!("customXml/item{n}.xml")));
        let source = sources.into_iter().find(|text| text.contains(SOURCE_NAMESPACE)).unwrap_or_default();
        let source = text_of(&source).ok_or_else(damaged)?;
        Ok(Self { source: NoteSource::of_note(&source)?, lines })
    }
}

/// Compares a note with its document as it is now, as [`crate::differences`] does.
pub fn docx_differences(note: &DocxNote, document: &Document) -> (usize, Vec<Difference>) {
    let blocks: Vec<Block> = document.blocks.iter().filter(|block| is_compared(block)).cloned().collect();
    let now = lines(&body::xml(&Document { title: String::new(), blocks })).unwrap_or_default();
    let now: Vec<&str> = now.iter().map(String::as_str).collect();
    let printed: Vec<&str> = note.lines.iter().map(String::as_str).collect();
    compared(&now, &printed, &|line| line.to_owned())
}

/// Lines of a document: the letters of each paragraph, and of each row of a table; `None` if the XML is damaged.
fn lines(xml: &str) -> Option<Vec<String>> {
    let mut reader = Reader::from_str(xml);
    let (mut lines, mut line) = (Vec::new(), String::new());
    let (mut is_text, mut is_in_row) = (false, false);
    loop {
        match reader.read_event().ok()? {
            Event::Start(element) => match element.name().as_ref() {
                "w:t" | "m:t" => is_text = true,
                "w:tr" => is_in_row = true,
                "w:tc" if !line.is_empty() => line.push(' '),
                _ => {}
            },
            Event::End(element) => {
                match element.name().as_ref() {
                    "w:t" | "m:t" => is_text = false,
                    "w:tr" => is_in_row = false,
                    _ => {}
                }
                let ends = matches!(element.name().as_ref(), "w:p" | "w:tr") && !is_in_row;
                if ends && !line.trim().is_empty() {
                    lines.push(line.trim().to_owned());
                }
                if ends {
                    line.clear();
                }
            }
            Event::Text(text) if is_text => line += &text,
            Event::GeneralRef(name) if is_text => line.push_str(&character(&name)?),
            Event::Eof => return Some(lines),
            _ => {}
        }
    }
}

/// The letters of a part.
fn text_of(xml: &str) -> Option<String> {
    let (mut reader, mut all) = (Reader::from_str(xml), String::new());
    loop {
        match reader.read_event().ok()? {
            Event::Text(text) => all += &text,
            Event::GeneralRef(name) => all.push_str(&character(&name)?),
            Event::Eof => return Some(all),
            _ => {}
        }
    }
}

/// The characters that a reference stands for: `amp`, `#38`.
fn character(reference: &BytesRef<'_>) -> Option<String> {
    match reference.resolve_char_ref().ok()? {
        Some(character) => Some(character.to_string()),
        None => resolve_xml_entity(reference).map(str::to_owned),
    }
}
