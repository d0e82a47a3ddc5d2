//! Axes of the grid of a study: the inputs that take given values.

use super::plan::Spacing;

/// Values that one or several inputs take together.
#[derive(Clone, Debug)]
pub(super) enum GridAxis {
    /// A range of an input.
    Range(InputRange),
    /// Rows of values of inputs, by their places, in the unit of each and in SI.
    Rows { inputs: Vec<usize>, rows: Vec<Vec<[f64; 2]>> },
}

/// Range of an input in its unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct InputRange {
    /// Place of the input.
    pub(super) input: usize,
    /// First value.
    pub(super) from: f64,
    /// Last value.
    pub(super) to: f64,
    /// Number of values.
    pub(super) points: u64,
    /// Spacing of the values.
    pub(super) spacing: Spacing,
}

impl GridAxis {
    pub(super) fn len(&self) -> u64 {
        match self {
            GridAxis::Range(range) => range.points,
            GridAxis::Rows { rows, .. } => rows.len() as u64,
        }
    }
}

impl InputRange {
    /// The value at a place, counted from 0.
    pub(super) fn value(&self, at: u64) -> f64 {
        let Self { from, to, points, spacing, .. } = *self;
        let share = if points > 1 { at as f64 / (points - 1) as f64 } else { 0.0 };
        match spacing {
            _ if at + 1 == points => to,
            Spacing::Linear => from + (to - from) * share,
            Spacing::Log => from * (to / from).powf(share),
        }
    }
}
