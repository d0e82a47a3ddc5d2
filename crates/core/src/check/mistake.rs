//! Mistakes: what was done in place of what is right, and where.

use super::words;
use crate::{Locale, Solution, Symbol, Text, reevaluate::Edit, trace::Id};

/// A mistake that explains a wrong answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// Place where it was made.
    pub place: Place,
    /// Kind of the mistake.
    pub change: Change,
    /// The term, factor or argument of the step that it is about.
    pub of: Option<Id>,
    /// The other computation of a number of the trace, where it is one.
    pub(super) edit: Option<Edit>,
    /// The number in place of the right one, in SI, where it is one of an input or a step.
    pub(super) taken: Option<f64>,
}

/// Place of a mistake.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// The finished answer.
    Answer,
    /// An input, by its path, and its label.
    Input(String, Text),
    /// A step of the worked solution, by its place, and its symbol.
    Step(usize, Symbol),
    /// The problem as a whole.
    Problem,
}

/// Kind of a mistake.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// It follows from the user's own answers of these names, which are wrong.
    Follows(Vec<String>),
    /// It is the value that a book prints for this problem, and why that is disputed.
    Printed(Text),
    /// A common error that the analysis knows, in words.
    Common(Text),
    /// The value of another answer, by its name.
    OtherAnswer(String),
    /// The value of an intermediate step.
    OtherStep(Symbol),
    /// The value of an input, by its path and label.
    Given(String, Text),
    /// The other sign.
    Sign,
    /// So many times as large; as it is written.
    Times(f64, &'static str),
    /// A shift of the decimal point by so many places.
    PowerOfTen(i8),
    /// The number was taken in another unit than it is in.
    Unit {
        /// The unit it is in.
        is: String,
        /// The unit it was taken in.
        taken: String,
    },
    /// Twice or half of it: diameter and radius, peak and peak to peak.
    Half,
    /// Another acceleration of gravity, in m/s².
    Gravity(f64),
    /// Weight in place of mass, or mass in place of weight.
    Weight,
    /// Left out: zero.
    LeftOut,
    /// A digit copied wrongly: the number as it is written, and as it was read.
    Digit(String, String),
    /// Two digits interchanged: the number as it is written, and as it was read.
    Swapped(String, String),
    /// One more or one less was counted.
    Count,
    /// Measured from the other end of a length, by the label of that.
    OtherEnd(Text),
    /// Interchanged with another input, by its path and label.
    Interchanged(String, Text),
    /// Another option of a choice, by the names that both are read by.
    Alternative(Text, Text),
    /// Square in place of the number.
    Squared,
    /// Square root in place of the number.
    Rooted,
    /// One divided by it.
    Inverted,
    /// An angle from another axis or in the other direction.
    Direction,
    /// The arctangent of a quotient alone: half a turn off.
    Quadrant,
    /// The acute angle whose tangent is the size of a quotient.
    AcuteAngle,
    /// A share measured from the other end: its complement to 1.
    Complement,
    /// The other angle of the same sine or cosine.
    OtherAngle,
    /// The sign of a term of a sum.
    TermSign,
    /// A term of a sum is missing.
    TermLeftOut,
    /// A term of a sum was added twice.
    TermTwice,
    /// A factor of a product is missing.
    FactorLeftOut,
    /// A factor of a product stands twice.
    FactorSquared,
    /// A number of a formula divides in place of multiplying, or the other way round.
    FactorInverted,
    /// Another coefficient in a formula: the right one, and the one that was taken.
    Coefficient(f64, f64),
    /// Components added as numbers in place of the root of the sum of their squares.
    AddedDirectly,
    /// The root of the sum of the squares in place of a sum.
    AddedAsVectors,
    /// The product over the sum in place of the sum: series and parallel connection confused.
    SeriesForParallel,
    /// Another exponent: the right one, and the one that was taken.
    Exponent(i8, i8),
    /// A root was omitted.
    RootLeftOut,
    /// Another function of the angle: the right one, and the one that was taken.
    Trigonometric(&'static str, &'static str),
    /// A number was divided by where it should multiply, or the other way round.
    DividedForMultiplied,
    /// An angle in degrees went into a function that takes radians, or a number in radians was read as degrees.
    Degrees,
    /// Every trigonometric function of a step by a calculator in degrees (true) or in radians, of angles in the other
    /// unit.
    Calculator(bool),
    /// One of several parts of a set, or one of its ends.
    Branch,
    /// Rounded to so many significant digits on the way.
    Rounded(u8),
}

/// Explanation of a wrong answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// The mistakes that give the answer together: one, or two.
    pub mistakes: Vec<Mistake>,
    /// Other mistakes about as common that give the very same number, so that nobody can tell them from the number.
    pub equivalents: Vec<Vec<Mistake>>,
    /// True if chance hardly hits the digits that were given; otherwise it is only possible.
    pub is_named: bool,
}

impl Mistake {
    pub(super) fn new(place: Place, change: Change) -> Self {
        Self { place, change, of: None, edit: None, taken: None }
    }

    pub(super) fn of(self, of: Option<Id>) -> Self {
        Self { of, ..self }
    }

    pub(super) fn by(self, edit: Edit) -> Self {
        Self { edit: Some(edit), ..self }
    }

    pub(super) fn taken(self, si: f64) -> Self {
        Self { taken: Some(si), ..self }
    }

    /// Name of the kind of the mistake in files.
    pub fn operation(&self) -> &'static str {
        match &self.change {
            Change::Follows(_) => "follows",
            Change::Printed(_) => "printed",
            Change::OtherAnswer(_) | Change::OtherStep(_) => "other-answer",
            Change::Given(..) => "given",
            Change::Sign | Change::TermSign => "sign",
            Change::Times(..) | Change::FactorInverted => "factor",
            Change::PowerOfTen(_) => "power-of-ten",
            Change::Unit { .. } => "unit",
            Change::Half => "half",
            Change::Gravity(_) => "gravity",
            Change::Weight => "weight",
            Change::LeftOut | Change::TermLeftOut | Change::FactorLeftOut => "left-out",
            Change::Digit(..) => "digit",
            Change::Swapped(..) => "swapped",
            Change::Count => "count",
            Change::OtherEnd(_) | Change::Complement => "other-end",
            Change::Interchanged(..) => "interchanged",
            Change::Alternative(..) => "alternative",
            Change::Squared | Change::FactorSquared | Change::Exponent(..) => "square",
            Change::Rooted | Change::RootLeftOut => "root",
            Change::Inverted | Change::DividedForMultiplied => "reciprocal",
            Change::Common(_) => "common",
            Change::Coefficient(..)
            | Change::AddedDirectly
            | Change::AddedAsVectors
            | Change::SeriesForParallel => "model",
            Change::Direction | Change::Quadrant | Change::AcuteAngle => "direction",
            Change::TermTwice => "twice",
            Change::Trigonometric(..) => "sine-cosine",
            Change::Degrees | Change::Calculator(_) => "degrees",
            Change::Branch | Change::OtherAngle => "branch",
            Change::Rounded(_) => "rounded",
        }
    }

    /// Description of the mistake, without a number of the right solution.
    pub fn text(&self, solution: &Solution) -> Text {
        words::mistake(self, solution)
    }

    /// Lines of what was computed and of what is right in its place, as in the worked solution: `P₃ = −45 kW`,
    /// `P₃ = −450 kW`; `None` where the description says it all.
    pub fn lines(&self, solution: &Solution, locale: &Locale) -> Option<[String; 2]> {
        words::lines(self, solution, locale)
    }
}

impl Cause {
    pub(super) fn new(mistakes: Vec<Mistake>, is_named: bool) -> Self {
        Self { mistakes, equivalents: Vec::new(), is_named }
    }

    /// Description of the cause, without a number of the right solution.
    pub fn text(&self, solution: &Solution) -> Text {
        let together = |mistakes: &Vec<Mistake>| {
            let all = mistakes.iter().map(|mistake| mistake.text(solution));
            all.reduce(|first, second| {
                Text::new("{first}, and {second}").with_text("first", first).with_text("second", second)
            })
            .unwrap_or_default()
        };
        self.all_mistakes()
            .map(together)
            .reduce(|first, second| {
                Text::new("{first}; or, with the same result, {second}")
                    .with_text("first", first)
                    .with_text("second", second)
            })
            .unwrap_or_default()
    }

    /// The mistakes, then their equivalents.
    pub fn all_mistakes(&self) -> impl Iterator<Item = &Vec<Mistake>> {
        std::iter::once(&self.mistakes).chain(&self.equivalents)
    }
}
