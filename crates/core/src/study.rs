//! Questions about a whole range of inputs: studies of any size, by a [plan](StudyPlan); curves of their answers; where
//! an answer takes a wanted value.

mod bands;
mod curves;
mod design;
mod evaluation;
mod notation;
mod plan;
mod statistics;
mod target;
mod words;

pub use self::{
    bands::Bands,
    curves::{Curves, MOST_CURVES},
    design::{Design, USUAL_SAMPLES},
    evaluation::{Evaluation, Row, Rows, Study, answer},
    plan::{
        Amount, Correlation, DataColumn, DistributionKind, Limit, ReadData, Sampling, Spacing, StudyPlan,
        Variation,
    },
    statistics::{
        Accumulator, AnswerLimit, AnswerStatistics, BLOCK, Exceedance, Histogram, PERCENTILES, Summary,
    },
    target::{FoundTarget, find_target},
};
