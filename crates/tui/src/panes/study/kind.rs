//! Kinds of studies that the pane begins with.

use dalembert_core::Text;

/// Kind of a study: what its plan is made of before a text is typed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Kind {
    /// Curve of an answer over an input.
    #[default]
    Sweep,
    /// Input at which the answer takes a target value.
    Find,
    /// The plan of a file.
    File,
    /// Monte Carlo with normal distributions.
    Normal,
    /// Monte Carlo with uniform distributions.
    Uniform,
}

impl Kind {
    /// Every kind in the order of choice; that of a file is there when there is one.
    pub(super) const ALL: [Kind; 5] = [Kind::Sweep, Kind::Find, Kind::File, Kind::Normal, Kind::Uniform];

    /// Name of the kind.
    pub(super) fn name(self) -> Text {
        match self {
            Kind::Sweep => Text::new("sweep"),
            Kind::Find => Text::new("target value"),
            Kind::File => Text::new("plan of a file"),
            Kind::Normal => Text::new("Monte Carlo, normal"),
            Kind::Uniform => Text::new("Monte Carlo, uniform"),
        }
    }

    /// Plan that the kind begins with.
    pub(super) fn about(self) -> Text {
        match self {
            Kind::Sweep => Text::new("answer as a function of an input"),
            Kind::Find => Text::new("input for a target value of the answer"),
            Kind::File => Text::new("plan of a file"),
            Kind::Normal => Text::new("inputs normal, tolerance = 3 standard deviations"),
            Kind::Uniform => Text::new("inputs uniform within their tolerances"),
        }
    }
}
