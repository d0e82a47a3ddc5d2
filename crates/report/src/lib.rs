//! A worked solution on paper: text, Markdown, HTML, LaTeX, Typst, JSON and CSV, and its figures as SVG. Plain
//! functions of plain data.
//!
//! What people read goes through a [`Document`]: [`document`] says what stands in it and in which order,
//! [`text`], [`markdown`], [`html`], [`latex`] and [`typst`] how it looks. Another format for people is another function of a [`Document`];
//! one for machines is another function of a [`Worked`], like [`json`] and [`csv`].

mod csv;
mod document;
pub mod figure;
mod html;
mod inputs;
mod json;
mod latex;
mod markdown;
mod math;
mod paper;
mod text;
mod typst;
mod units;
mod worked;
mod wrap;
mod xml;

pub use crate::{
    csv::{csv, csv_tables, plot_csv},
    document::{Block, Document, Line, Table},
    figure::figure,
    html::html,
    inputs::{Input, inputs},
    json::{json, json_text},
    latex::latex,
    markdown::markdown,
    paper::Paper,
    text::text,
    typst::typst,
    units::show_answer_in,
    worked::{Worked, document},
};

dalembert_core::messages!("../locales/pt-BR.ftl");
