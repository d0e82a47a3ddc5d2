//! The tabs beside the form.

/// What is shown of what was found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// Answers, checks and warnings.
    #[default]
    Results,
    /// The worked solution.
    Working,
    /// Plots.
    Plot,
    /// Sketches of the machine.
    Drawing,
    /// Tables.
    Table,
    /// The user's own answers.
    Check,
    /// Which input matters.
    Sensitivity,
    /// Ranges of inputs.
    Study,
    /// Books and published cases.
    Sources,
}

impl Tab {
    /// Every tab, from left to right.
    pub const ALL: [Tab; 9] = [
        Tab::Results,
        Tab::Working,
        Tab::Plot,
        Tab::Drawing,
        Tab::Table,
        Tab::Check,
        Tab::Sensitivity,
        Tab::Study,
        Tab::Sources,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Tab::Results => "Results",
            Tab::Working => "Working",
            Tab::Plot => "Plot",
            Tab::Drawing => "Drawing",
            Tab::Table => "Table",
            Tab::Check => "Check",
            Tab::Sensitivity => "Sensitivity",
            Tab::Study => "Study",
            Tab::Sources => "Sources",
        }
    }

    /// Whether it has cells to type in.
    pub fn has_cells(self) -> bool {
        matches!(self, Tab::Check | Tab::Sensitivity | Tab::Study)
    }

    /// Whether it stands alone in its column on a wide screen.
    pub fn is_alone(self) -> bool {
        matches!(self, Tab::Table | Tab::Sources) || self.has_cells()
    }

    /// Whether it shows a picture: on a wide screen these have a column of their own.
    pub fn is_picture(self) -> bool {
        matches!(self, Tab::Plot | Tab::Drawing)
    }
}
