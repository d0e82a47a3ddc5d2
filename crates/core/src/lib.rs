//! Analyses: their inputs, their worked solutions, their published cases, and the registry of all of them.
//!
//! A problem is a struct whose fields are its inputs ([`Inputs`], derived). Its [`Analysis::solve`] is written
//! once over [`Worksheet`]: read with a [`Sheet`] it is the worked solution, read with [`Plain`] the numbers
//! alone. Nothing here reads or writes files.

extern crate self as dalembert_core;

mod analysis;
pub mod ascii;
mod assumed;
pub mod cases;
mod cell;
pub mod check;
pub mod coverage;
mod definitions;
pub mod describe;
pub mod draft;
pub mod exams;
pub mod exercises;
pub mod exhibit;
mod field;
pub mod file;
pub mod form;
mod formula;
pub mod gravity;
pub mod hints;
mod input;
mod intern;
mod kept;
mod kinds;
pub mod linked;
pub mod mutation;
mod names;
mod path;
mod placed;
pub mod printer;
mod reading;
mod record;
mod reevaluate;
pub mod search;
pub mod sensitivity;
mod sheet;
pub mod sketch;
mod solution;
mod source;
mod statement;
pub mod study;
pub mod suggestions;
pub mod table;
pub mod text;
mod tolerances;
pub mod trace;
pub mod uff;
mod unit_system;
mod unknowns;
pub mod vary;
mod working;
pub mod worksheet;

pub use dalembert_derive::Inputs;
#[doc(hidden)]
pub use inventory;
/// Vectors and matrices of analyses, in the version that the numerical kernels take.
pub use nalgebra;

#[doc(hidden)]
pub use crate::input::derive_support;
pub use crate::{
    analysis::{
        About, Analysis, Entry, Evaluate, Refusal, SolveError, Stop, duplicates, find_analysis, registry,
    },
    ascii::ascii,
    definitions::{COMMON_LISTS, Goal, has_unknown, own_fields, split_tolerance, within_problem},
    draft::Draft,
    exams::{catalogue, find},
    exhibit::{
        Animation, Axis, Band, Cell, Column, Deferred, Drawing, DrawnShape, Exhibit, Frames, Ink, LabelSide,
        Level, Mark, Over, Plot, Point, Point3, Scale, Scene, Series, Shape3, TableExhibit, Viewpoint3,
    },
    field::{ChildList, Field, FieldLimit, Fields, Measure, Shape, Variant},
    formula::{normalised, value_of_numbers},
    input::{FieldError, Inputs, Lift, MeasuredQuantity, Reference},
    linked::LinkedProblem,
    path::{is_within, nearest},
    reading::unit_hint,
    record::{NumberTable, Record, Value},
    sheet::{Sheet, Term, VectorTerm},
    sketch::Sketch,
    solution::{
        Answer, AnswerValue, Check, CommonError, Display, Name, ProblemSteps, Sides, Solution, Step,
        problem_heading,
    },
    source::{Cite, Source},
    statement::Statement,
    text::{Arg, Language, Locale, Messages, Text},
    trace::{Number, Symbol, Trace},
    unit_system::{ShownUnits, UnitSetting},
    unknowns::{Candidate, Determined, DeterminedInput, Optimum, ReachedAnswer},
    vary::title_of,
    worksheet::{FieldPath, Plain, Reason, Worksheet},
};

messages!("../locales/pt-BR.ftl");
