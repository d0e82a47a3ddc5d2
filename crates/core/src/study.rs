//! Questions about a whole range of inputs: studies of any size, by a [plan](StudyPlan); curves of their answers; where
//! an answer takes a wanted value.

mod amounts;
mod bands;
mod curves;
mod design;
mod evaluation;
mod grid;
mod indices;
mod levels;
mod notation;
mod plan;
mod rows;
mod sample;
mod statistics;
mod target;
mod values;
mod words;

pub use self::{
    bands::Bands,
    curves::{Curves, MOST_CURVES},
    design::{Design, USUAL_SAMPLES},
    evaluation::{Evaluation, Study, answer},
    indices::{Estimate, SobolIndex, SobolIndices},
    levels::{LevelMean, Levels},
    plan::{
        Amount, Correlation, DataColumn, DistributionKind, Limit, MappedInputs, ReadData, Sampling, Spacing,
        StudyPlan, Variation,
    },
    rows::{Row, Rows},
    statistics::{Accumulator, AnswerLimit, AnswerStatistics, BLOCK, Exceedance, LEVEL_ROWS, Summary},
    target::{FoundTarget, find_target},
    values::{Histogram, PERCENTILES},
};
