//! Exercises for a class: variants of a problem with other data, sheets and keys, the grading of answers, and files for
//! learning platforms. Plain functions of plain data.
//!
//! [`Generator`] draws [`Variant`]s of an [`Exercise`] and accepts those that are as sound as the problem itself;
//! [`sheets`] writes them for people, [`moodle`], [`qti`] and [`prairielearn`] for platforms; [`grading`] compares the
//! answers of a class with them.

mod base64;
pub mod causes;
mod decimal;
mod exercise;
mod export;
pub mod grading;
pub mod moodle;
pub mod prairielearn;
pub mod qti;
mod ranges;
mod rewritten;
mod seed;
pub mod sheets;
mod variants;

pub use crate::{
    exercise::Exercise,
    export::{ExportFile, file_label},
    ranges::{Datum, Range, ranges},
    rewritten::rewritten,
    seed::seed_of,
    variants::{CLOSEST, Generator, LARGEST_ELASTICITY, TRIES, Variant},
};

dalembert_core::messages!("../locales/pt-BR.ftl");
