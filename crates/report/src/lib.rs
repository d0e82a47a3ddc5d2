//! A worked solution on paper: text, Markdown, HTML, LaTeX, Typst, JSON and CSV, and its figures as SVG. Plain
//! functions of plain data.
//!
//! What people read goes through a [`Document`]: [`document`] says what stands in it and in which order,
//! [`text`], [`markdown`], [`html`], [`latex`] and [`typst`] how it looks. Another format for people is another function of a [`Document`];
//! one for machines is another function of a [`WorkedProblem`], like [`json`] and [`csv`].

mod checked;
mod csv;
mod document;
#[cfg(feature = "word")]
mod docx;
mod errors;
pub mod figure;
mod format;
mod html;
mod inputs;
mod json;
mod latex;
mod markdown;
mod math;
mod note;
mod parts;
mod study;
mod study_figures;
mod tables;
mod text;
mod typst;
mod units;
mod worked;
mod wrap;
mod xml;

#[cfg(feature = "word")]
pub use crate::docx::{DocxNote, docx, docx_differences};
pub use crate::{
    checked::{CheckedAnswer, checked_answers},
    csv::{csv, csv_tables, plot_csv},
    document::{Block, Document, DocumentTable, NamedValue},
    errors::{RequestError, errors_json, named_error, short, typed},
    figure::figure,
    format::DocumentFormat,
    html::{html, html_fragment},
    inputs::{ReportedInput, inputs},
    json::{RESULT_KEYS, RESULTS_FORMAT, RESULTS_SCHEMA, json, json_of, json_text, unknown_formula},
    latex::{latex, latex_formulas},
    markdown::markdown,
    note::{Difference, NoteSource, differences},
    parts::Parts,
    study::{study_document, study_json},
    tables::{file_of, with_file},
    text::text,
    typst::typst,
    units::{show_answer_in, show_answers_in},
    worked::{WorkedProblem, document, document_of, document_without_figures},
};

/// Program and version, at the foot of a page.
const PROGRAM: &str = concat!("dalembert ", env!("CARGO_PKG_VERSION"));

dalembert_core::messages!("../locales/pt-BR.ftl");
