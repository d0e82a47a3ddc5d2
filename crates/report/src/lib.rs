//! A worked solution on paper: text, Markdown, JSON and CSV. Plain functions of plain data.
//!
//! What people read goes through a [`Document`]: [`document`] says what stands in it and in which order,
//! [`text`] and [`markdown`] how it looks. Another format for people is another function of a [`Document`];
//! one for machines is another function of a [`Worked`], like [`json`] and [`csv`].

mod ascii;
mod csv;
mod document;
pub mod figure;
mod inputs;
mod json;
mod markdown;
mod text;
mod units;
mod worked;
mod wrap;

pub use crate::{
    ascii::ascii,
    csv::{csv, csv_tables},
    document::{Block, Document, Line, Table},
    inputs::{Input, inputs},
    json::json,
    markdown::markdown,
    text::text,
    units::show_answer_in,
    worked::{Worked, document},
};

dalembert_core::messages!("../locales/pt-BR.ftl");
