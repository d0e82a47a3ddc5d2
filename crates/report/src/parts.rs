//! Parts of a worked solution that a note has.

/// Choice of parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Parts {
    /// Problem, data and drawing: a sheet to be worked on.
    Statement,
    /// Problem, data, drawing, answers, warnings and checks.
    Answers,
    /// Everything.
    #[default]
    Full,
}

impl Parts {
    /// All choices.
    pub const ALL: [Self; 3] = [Self::Statement, Self::Answers, Self::Full];

    /// Name: on the command line, and in the note.
    pub fn name(self) -> &'static str {
        match self {
            Self::Statement => "statement",
            Self::Answers => "answers",
            Self::Full => "full",
        }
    }

    /// The choice of a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|parts| parts.name() == name)
    }
}
