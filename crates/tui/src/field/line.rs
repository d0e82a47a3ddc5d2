//! A line of a page.

use dalembert_core::Text;

/// A line of a page.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldLine {
    /// Name.
    pub label: Text,
    /// Meaning, and how it is found; may be empty.
    pub help: Text,
    /// Kind.
    pub kind: LineKind,
    /// True if the job does not go on without it.
    pub required: bool,
}

/// Kind of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum LineKind {
    /// The name of the rotor, which is the title of the problem.
    Title,
    /// One of a few options, by its digit.
    Choice(Choice, Vec<Text>),
    /// An input, with the unit of a number alone.
    Value(String, String),
    /// A size and an angle, typed on one line: a reading, a weight. Their paths, and the unit of the size.
    Pair(String, String, String),
    /// The way on.
    Go(Go),
}

/// Meaning of an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Number of correction planes.
    Planes,
    /// Number of sensors.
    Sensors,
    /// Unit of the readings.
    ReadingUnit,
    /// Unit of the weights.
    WeightUnit,
    /// An alternative of a one-of, by its place there.
    OneOf(&'static str),
}

/// The way on from a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Go {
    /// The next page.
    Next,
    /// The last page.
    End,
    /// The report is written.
    Report,
    /// The job as a problem of the workbench.
    Workbench,
}

/// Units of readings: as they are typed, and as they are shown.
pub(super) const READING_UNITS: [&str; 6] = ["mm/s", "um", "m/s^2", "mil", "in/s", "1"];
/// Units of weights.
pub(super) const WEIGHT_UNITS: [&str; 2] = ["g", "oz"];

impl FieldLine {
    /// True if it is typed in.
    pub fn is_text(&self) -> bool {
        matches!(self.kind, LineKind::Title | LineKind::Value(..) | LineKind::Pair(..))
    }

    /// The same line, which may be left empty.
    #[must_use]
    pub(super) fn optional(self) -> Self {
        Self { required: false, ..self }
    }
}
