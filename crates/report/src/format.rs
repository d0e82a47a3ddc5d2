//! A document as the files that hold it.

use std::path::Path;

use dalembert_core::Locale;

use crate::{Document, html, latex, markdown, text, typst};

/// The width of a text in a file.
const COLUMNS: usize = 80;

/// Output format of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DocumentFormat {
    /// Plain text, without figures.
    Text,
    /// Markdown; its figures are files beside it.
    Markdown,
    /// One HTML page.
    Html,
    /// One LaTeX file.
    Latex,
    /// Typst; its figures are files beside it.
    Typst,
}

impl DocumentFormat {
    /// Format by the extension of a file.
    pub fn of(path: &Path) -> Option<Self> {
        Some(match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "txt" => DocumentFormat::Text,
            "md" | "markdown" => DocumentFormat::Markdown,
            "html" | "htm" => DocumentFormat::Html,
            "tex" => DocumentFormat::Latex,
            "typ" => DocumentFormat::Typst,
            _ => return None,
        })
    }

    /// The document; where it links to figures, their files begin with `figures`.
    pub fn write(self, document: &Document, figures: Option<&str>, locale: &Locale) -> String {
        match self {
            DocumentFormat::Text => text(document, COLUMNS),
            DocumentFormat::Markdown => markdown(document, figures),
            DocumentFormat::Html => html(document, locale),
            DocumentFormat::Latex => latex(document),
            DocumentFormat::Typst => typst(document, figures, locale),
        }
    }

    /// The document as files beside one another: the name and the text of each, the document itself first. `None`
    /// where the path has no name.
    pub fn files(self, document: &Document, path: &Path, locale: &Locale) -> Option<Vec<(String, String)>> {
        let name = path.file_name()?.to_string_lossy().into_owned();
        let stem = path.file_stem()?.to_string_lossy().into_owned();
        let mut files = vec![(name, self.write(document, Some(&stem), locale))];
        if matches!(self, DocumentFormat::Markdown | DocumentFormat::Typst) {
            files.extend(document.figures(&stem));
        }
        Some(files)
    }
}
