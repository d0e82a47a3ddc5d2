//! Errors of reading a quantity, in words for the user who typed it.

use std::{fmt, ops::Range};

use crate::{Dim, Kind, Unit, UnitMeaning, table};

/// Reason for which a text could not be read. `span` is in bytes of the text typed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReadError {
    /// Nothing was written.
    #[error("a value is needed, for example {example}")]
    Empty {
        /// Valid text to write instead.
        example: String,
    },
    /// More text than a quantity can have.
    #[error("the text is longer than {limit} characters: write a single value")]
    TooLong {
        /// The most characters there may be.
        limit: usize,
    },
    /// A control character, or one that is invisible or turns the direction of the text.
    #[error("the text contains the control or invisible character U+{code:04X}: delete it")]
    Control {
        /// Unicode code point of the character.
        code: u32,
        /// Position in the text.
        span: Range<usize>,
    },
    /// Something else where a number should be.
    #[error("`{text}` is not a number: write digits, for example {example}")]
    NotANumber {
        /// Offending text.
        text: String,
        /// Valid text to write instead.
        example: String,
        /// Position in the text.
        span: Range<usize>,
    },
    /// A number too large or too small to compute with.
    #[error("`{text}` is too {}: write a number between 1e-300 and 1e300", if *.large { "large" } else { "close to zero" })]
    OutOfRange {
        /// Text as typed.
        text: String,
        /// Too large rather than too small.
        large: bool,
        /// Position in the text.
        span: Range<usize>,
    },
    /// Two decimal marks, or marks between thousands.
    #[error("`{text}` has two decimal marks: write `{}` or `{}`", readings[0], readings[1])]
    TwoMarks {
        /// Text as typed.
        text: String,
        /// Two possible readings.
        readings: [String; 2],
        /// Position in the text.
        span: Range<usize>,
    },
    /// A number after a number: thousands set apart by a space, or an operator left out.
    #[error("`{text}` has a gap between digits: write `{}` or `{}`", readings[0], readings[1])]
    Gap {
        /// Text as typed.
        text: String,
        /// Two possible readings.
        readings: [String; 2],
        /// Position in the text.
        span: Range<usize>,
    },
    /// A unit that is not in the table.
    #[error("unknown unit `{symbol}`{}", did_you_mean(nearest))]
    UnknownUnit {
        /// Unit symbol as typed.
        symbol: String,
        /// Symbols it may have been meant as.
        nearest: Vec<&'static str>,
        /// Position in the text.
        span: Range<usize>,
    },
    /// A symbol that stands for several units.
    #[error("`{symbol}` has several meanings: write {}", quoted(meant))]
    SeveralUnits {
        /// Unit symbol as typed.
        symbol: String,
        /// Spellings of the units it may stand for, those of the wanted dimension where there are such.
        meant: Vec<&'static str>,
        /// Position in the text.
        span: Range<usize>,
    },
    /// A text with two readings, such as a product after a division.
    #[error("`{text}` can be read in two ways: write `{}` or `{}`", readings[0], readings[1])]
    Ambiguous {
        /// Text as typed.
        text: String,
        /// Two possible readings.
        readings: [String; 2],
        /// Position in the text.
        span: Range<usize>,
    },
    /// Something that does not belong there.
    #[error("unexpected `{found}`: {expected} expected")]
    Unexpected {
        /// Text found.
        found: String,
        /// Element expected in its place.
        expected: &'static str,
        /// Position in the text.
        span: Range<usize>,
    },
    /// The text ends too early.
    #[error("`{text}` is incomplete: {expected} expected")]
    Unfinished {
        /// Text as typed.
        text: String,
        /// Element that is missing.
        expected: &'static str,
        /// Position of the end of the text.
        span: Range<usize>,
    },
    /// Brackets, roots, powers or signs within one another without end.
    #[error("more than {limit} nested brackets, roots, powers and signs: write a simpler expression")]
    TooDeep {
        /// The deepest there may be.
        limit: usize,
        /// Position in the text.
        span: Range<usize>,
    },
    /// An exponent that is no whole number, or too large.
    #[error(
        "unexpected `{text}` after the unit: an exponent is an integer other than 0 from -{limit} to {limit}"
    )]
    Exponent {
        /// Text as typed.
        text: String,
        /// The largest there may be.
        limit: u8,
        /// Position in the text.
        span: Range<usize>,
    },
    /// A division by zero.
    #[error("`{text}` divides by zero: write another divisor")]
    DivisionByZero {
        /// Text as typed.
        text: String,
        /// Position in the text.
        span: Range<usize>,
    },
    /// A root or a power that is no real number.
    #[error("`{text}` is not a real number: write a root of a positive number")]
    NotReal {
        /// Text as typed.
        text: String,
        /// Position in the text.
        span: Range<usize>,
    },
    /// A root whose unit does not come out even.
    #[error("the square root of {dim} is not a unit: write a root of an even power, such as sqrt(4 m^2)")]
    UnevenRoot {
        /// The dimension under the root.
        dim: Dim,
        /// Position in the text.
        span: Range<usize>,
    },
    /// A sum of different things.
    #[error("{} and {} cannot be added: {}", in_words(*left), in_words(*right), of_one_kind(repairs))]
    Sum {
        /// The dimension of the left side.
        left: Dim,
        /// The dimension of the right side.
        right: Dim,
        /// Sums of one kind that may have been meant, one or two: a unit of mass in place of one of force.
        repairs: Vec<String>,
        /// Position in the text.
        span: Range<usize>,
    },
    /// A level or an amplitude suffix within a larger expression, or without its unit.
    #[error("`{symbol}` must follow {after}: write a single value, for example {example}")]
    Alone {
        /// The unit or suffix.
        symbol: String,
        /// Element that precedes it.
        after: &'static str,
        /// Valid text to write instead.
        example: &'static str,
    },
    /// Another kind of quantity than the one asked for.
    #[error(transparent)]
    WrongKind(Box<WrongKind>),
    /// Too few or too many components.
    #[error("{found} component{} written where {expected} are expected: write them as in `{example}`", if *.found == 1 { " is" } else { "s are" })]
    Components {
        /// Number of components typed.
        found: usize,
        /// Number of components expected.
        expected: &'static str,
        /// Valid text to write instead.
        example: String,
        /// Position in the text.
        span: Range<usize>,
    },
    /// Units with some components and not with others.
    #[error(
        "`{text}` has a unit with some components only: write one unit after the brackets, as in `{example}`"
    )]
    MixedComponents {
        /// Text as typed.
        text: String,
        /// Valid text to write instead.
        example: String,
        /// Position in the text.
        span: Range<usize>,
    },
    /// Not a whole number.
    #[error("`{text}` is not a count: enter an integer, for example 4")]
    NotACount {
        /// Text as typed.
        text: String,
        /// Position in the text.
        span: Range<usize>,
    },
}

/// Another kind of quantity than the one asked for.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "`{text}` is {}; {} expected, e.g. in {}{}",
    found(unit),
    expected(*kind, default),
    example(*kind, default),
    hinted(hint.as_ref())
)]
pub struct WrongKind {
    /// Text as typed.
    pub text: String,
    /// The unit it was written in.
    pub unit: Unit,
    /// The kind that is wanted.
    pub kind: Kind,
    /// The unit of a number written alone.
    pub default: Unit,
    /// Probable intention.
    pub hint: Option<Hint>,
    /// Position in the text.
    pub span: Range<usize>,
}

/// Probable intention behind a unit of the wrong kind. Each shows a text that can be typed.
#[derive(Clone, Debug, PartialEq)]
pub enum Hint {
    /// A mass where a force is wanted: its value in kilograms.
    WeightOf(String),
    /// A force where a mass is wanted: its value in newtons.
    MassOf(String),
    /// A unit of mass, force or acceleration in place of one that shares its name: the unit, and the text with the other.
    Namesake(&'static str, String),
    /// A unit of energy where a torque is wanted: the value in N·m.
    TorqueOf(String),
    /// A peak, peak-to-peak or rms value where no amplitude is asked.
    NoAmplitude,
    /// A percentage where an angle is wanted: it may be a slope.
    Slope,
    /// A mark of minutes or seconds of arc where a length is wanted.
    Feet(String),
    /// The reciprocal has the right dimension.
    Reciprocal(String),
    /// A letter was left out of a unit of the right kind, as in `dg` for `deg`: the number with that unit.
    Meant(String),
}

impl fmt::Display for Hint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Hint::WeightOf(kg) => write!(f, "a weight is mass × g: write `9.81*{kg} N` or `{kg} kgf`"),
            Hint::MassOf(newtons) => write!(f, "a mass is weight / g: write `{newtons}/9.81 kg`"),
            Hint::Namesake("g", text) => {
                write!(f, "g is the gram: write `{text}` for multiples of standard gravity")
            }
            Hint::Namesake("g0", text) => write!(f, "g0 is standard gravity: write `{text}` for grams"),
            Hint::Namesake(unit, text) if is_force(unit) => {
                write!(f, "{unit} is a force: write `{text}`")
            }
            Hint::Namesake(unit, text) => write!(f, "{unit} is a mass: write `{text}`"),
            Hint::TorqueOf(number) => write!(f, "write N·m for a torque: `{number} N*m`"),
            Hint::NoAmplitude => {
                write!(f, "peak, peak-to-peak and rms belong to amplitudes: write the unit alone")
            }
            Hint::Slope => write!(f, "write the angle in rad or deg; that of a 30 % slope is 16.699 deg"),
            Hint::Feet(text) => {
                write!(f, "the marks ' and \" are minutes and seconds of arc: write `{text}`")
            }
            Hint::Reciprocal(text) => {
                write!(f, "write brackets if the divisor is meant to have the unit: `{text}`")
            }
            Hint::Meant(text) => write!(f, "did you mean `{text}`?"),
        }
    }
}

impl Hint {
    /// The texts that it shows.
    fn repairs(&self) -> Vec<String> {
        match self {
            Self::WeightOf(kg) => vec![format!("9.81*{kg} N"), format!("{kg} kgf")],
            Self::MassOf(newtons) => vec![format!("{newtons}/9.81 kg")],
            Self::TorqueOf(number) => vec![format!("{number} N*m")],
            Self::Namesake(_, text) | Self::Feet(text) | Self::Reciprocal(text) | Self::Meant(text) => {
                vec![text.clone()]
            }
            Self::NoAmplitude | Self::Slope => Vec::new(),
        }
    }
}

impl ReadError {
    /// Names the units that an unknown one may have been meant as, those of the wanted dimension first: a search that
    /// only a message needs. Of these, and of the units that a symbol may stand for, up to three stay: those that `fits`
    /// takes in its place, if it takes any.
    pub(super) fn suggesting(mut self, wanted: Dim, fits: impl Fn(&Range<usize>, &str) -> bool) -> Self {
        if let Self::UnknownUnit { symbol, nearest, .. } = &mut self
            && nearest.is_empty()
        {
            *nearest = table::nearest(symbol, wanted);
        }
        if let Self::Sum { repairs, span, .. } = &mut self
            && repairs.iter().any(|sum| fits(span, sum))
        {
            repairs.retain(|sum| fits(span, sum));
        }
        if let Self::SeveralUnits { meant, span, .. } | Self::UnknownUnit { nearest: meant, span, .. } =
            &mut self
        {
            if meant.iter().any(|unit| fits(span, unit)) {
                meant.retain(|unit| fits(span, unit));
            }
            meant.truncate(3);
        }
        self
    }

    /// Texts that the message offers in place of the [`span`](Self::span) at fault, or of the whole.
    pub fn repairs(&self) -> Vec<String> {
        match self {
            Self::TwoMarks { readings, .. }
            | Self::Gap { readings, .. }
            | Self::Ambiguous { readings, .. } => readings.to_vec(),
            Self::UnknownUnit { nearest: units, .. } | Self::SeveralUnits { meant: units, .. } => {
                units.iter().map(|unit| (*unit).to_owned()).collect()
            }
            Self::Sum { repairs, .. } => repairs.clone(),
            Self::WrongKind(wrong) => wrong.hint.as_ref().map_or_else(Vec::new, Hint::repairs),
            _ => Vec::new(),
        }
    }

    /// The bytes of the text typed that are at fault; `None` when it is the whole of it.
    pub fn span(&self) -> Option<Range<usize>> {
        match self {
            Self::Empty { .. } | Self::TooLong { .. } | Self::Alone { .. } => None,
            Self::WrongKind(wrong) => Some(wrong.span.clone()),
            Self::Control { span, .. }
            | Self::NotANumber { span, .. }
            | Self::OutOfRange { span, .. }
            | Self::TwoMarks { span, .. }
            | Self::Gap { span, .. }
            | Self::UnknownUnit { span, .. }
            | Self::SeveralUnits { span, .. }
            | Self::Ambiguous { span, .. }
            | Self::Unexpected { span, .. }
            | Self::Unfinished { span, .. }
            | Self::TooDeep { span, .. }
            | Self::Exponent { span, .. }
            | Self::DivisionByZero { span, .. }
            | Self::NotReal { span, .. }
            | Self::UnevenRoot { span, .. }
            | Self::Sum { span, .. }
            | Self::Components { span, .. }
            | Self::MixedComponents { span, .. }
            | Self::NotACount { span, .. } => Some(span.clone()),
        }
    }
}

fn did_you_mean(nearest: &[&str]) -> String {
    match nearest {
        [] => ": write a unit such as m, kg, s, N, Pa or rpm".into(),
        [one] => format!(": did you mean `{one}`?"),
        [first @ .., last] => {
            let first: Vec<_> = first.iter().map(|symbol| format!("`{symbol}`")).collect();
            format!(": did you mean {} or `{last}`?", first.join(", "))
        }
    }
}

fn of_one_kind(sums: &[String]) -> String {
    match sums {
        [] => "give both the same kind of unit, or write brackets as in `(2 + 3) mm`".into(),
        [one] => format!("did you mean `{one}`?"),
        [first, second, ..] => format!("write `{first}` or `{second}`"),
    }
}

fn quoted(units: &[&str]) -> String {
    units.iter().map(|unit| format!("`{unit}`")).collect::<Vec<_>>().join(", ")
}

/// Returns true if a unit is one of force.
fn is_force(unit: &str) -> bool {
    crate::unit(unit).is_ok_and(|unit| unit.dim == Dim::new(1, 1, -2, 0))
}

fn hinted(hint: Option<&Hint>) -> String {
    hint.map_or_else(String::new, |hint| format!("; {hint}"))
}

fn found(unit: &Unit) -> String {
    match (unit.sense, Kind::of(unit)) {
        (UnitMeaning::Level, _) => "a level".into(),
        (_, Kind::Other) => format!("a quantity in {}", unit.pretty()),
        (_, Kind::Amplitude) => format!("an amplitude in {}", unit.pretty()),
        (_, kind) => kind.name().into(),
    }
}

fn expected(kind: Kind, default: &Unit) -> String {
    match kind {
        Kind::Other => format!("a quantity in {}", default.pretty()),
        Kind::Amplitude => format!("an amplitude in {}", default.pretty()),
        kind => kind.name().into(),
    }
}

fn example(kind: Kind, default: &Unit) -> String {
    match kind.units() {
        [first, ..] if default.text.is_empty() => (*first).to_owned(),
        _ => default.ascii(),
    }
}

/// Description in words of a quantity of this dimension.
fn in_words(dim: Dim) -> String {
    match Kind::of_dim(dim) {
        Kind::Other => format!("a quantity in {dim}"),
        Kind::Ratio => "a number without a unit".into(),
        kind => kind.name().into(),
    }
}
