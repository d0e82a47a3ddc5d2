//! The words of a reading error, so that they can be said in every language.

use dalembert_units::{self as units, Dim, Hint, Kind, ReadError, Unit, UnitMeaning, WrongKind};

use crate::Text;

/// Message of a read error, as a translatable sentence.
pub(crate) fn text(error: &ReadError) -> Text {
    match error {
        ReadError::Empty { example } => {
            Text::new("a value is needed, for example {example}").with_number("example", example)
        }
        ReadError::TooLong { limit } => {
            Text::new("the text is longer than {limit} characters: write a single value").with("limit", limit)
        }
        ReadError::Control { code, .. } => {
            Text::new("the text contains the control or invisible character {code}: delete it")
                .with("code", format!("U+{code:04X}"))
        }
        ReadError::NotANumber { text, example, .. } => {
            Text::new("`{text}` is not a number: write digits, for example {example}")
                .with("text", text)
                .with_number("example", example)
        }
        ReadError::OutOfRange { text, large: true, .. } => {
            Text::new("`{text}` is too large: write a number below 1e300").with("text", text)
        }
        ReadError::OutOfRange { text, large: false, .. } => {
            Text::new("`{text}` is too close to zero: write a number above 1e-300").with("text", text)
        }
        ReadError::TwoMarks { text, readings, .. } => {
            two_readings("`{text}` has two decimal marks: write `{first}` or `{second}`", text, readings)
        }
        ReadError::Gap { text, readings, .. } => {
            two_readings("`{text}` has a gap between digits: write `{first}` or `{second}`", text, readings)
        }
        ReadError::Ambiguous { text, readings, .. } => {
            two_readings("`{text}` can be read in two ways: write `{first}` or `{second}`", text, readings)
        }
        ReadError::UnknownUnit { symbol, nearest, .. } if nearest.is_empty() => {
            Text::new("unknown unit `{symbol}`: write a unit such as m, kg, s, N, Pa or rpm").with("symbol", symbol)
        }
        ReadError::UnknownUnit { symbol, nearest, .. } => Text::new("unknown unit `{symbol}`: did you mean {nearest}?")
            .with("symbol", symbol)
            .with("nearest", nearest.iter().map(|near| format!("`{near}`")).collect::<Vec<_>>().join(", ")),
        ReadError::SeveralUnits { symbol, meant, .. } => Text::new("`{symbol}` has several meanings: write {meant}")
            .with("symbol", symbol)
            .with("meant", meant.iter().map(|unit| format!("`{unit}`")).collect::<Vec<_>>().join(", ")),
        ReadError::Unexpected { found, expected, .. } => {
            Text::new("unexpected `{found}`: {expected} expected")
                .with("found", found)
                .with_text("expected", *expected)
        }
        ReadError::Unfinished { text, expected, .. } => {
            Text::new("`{text}` is incomplete: {expected} expected")
                .with("text", text)
                .with_text("expected", *expected)
        }
        ReadError::TooDeep { limit, .. } => {
            Text::new("more than {limit} nested brackets, roots, powers and signs: write a simpler expression")
                .with("limit", limit)
        }
        ReadError::Exponent { text, limit, .. } => {
            Text::new("unexpected `{text}` after the unit: an exponent is an integer other than 0 from -{limit} to {limit}")
                .with("text", text)
                .with("limit", limit)
        }
        ReadError::DivisionByZero { text, .. } => {
            Text::new("`{text}` divides by zero: write another divisor").with("text", text)
        }
        ReadError::NotReal { text, .. } => {
            Text::new("`{text}` is not a real number: write a root of a positive number").with("text", text)
        }
        ReadError::UnevenRoot { dim, .. } => {
            Text::new("the square root of {dim} is not a unit: write a root of an even power, such as sqrt(4 m^2)")
                .with("dim", dim)
        }
        ReadError::Sum { left, right, repairs, .. } => match &repairs[..] {
            [] => Text::new(
                "{left} and {right} cannot be added: give both the same kind of unit, or write brackets as in `(2 + 3) mm`",
            ),
            [one] => Text::new("{left} and {right} cannot be added: did you mean `{one}`?").with("one", one),
            [first, second, ..] => Text::new("{left} and {right} cannot be added: write `{first}` or `{second}`")
                .with("first", first)
                .with("second", second),
        }
        .with_text("left", of_dim(*left))
        .with_text("right", of_dim(*right)),
        ReadError::Alone { symbol, after, example } => {
            Text::new("`{symbol}` must follow {after}: write a single value, for example {example}")
                .with("symbol", symbol)
                .with_text("after", *after)
                .with_number("example", example)
        }
        ReadError::WrongKind(wrong) => wrong_kind(wrong),
        ReadError::Components { found, expected, example, .. } => {
            Text::new("{found} components are written where {expected} are expected: write them as in `{example}`")
                .with("found", found)
                .with_text("expected", *expected)
                .with_number("example", example)
        }
        ReadError::MixedComponents { text, example, .. } => Text::new(
            "`{text}` has a unit with some components only: write one unit after the brackets, as in `{example}`",
        )
        .with("text", text)
        .with_number("example", example),
        ReadError::NotACount { text, .. } => {
            Text::new("`{text}` is not a count: enter an integer, for example 4").with("text", text)
        }
    }
}

fn two_readings(template: &'static str, text: &str, [first, second]: &[String; 2]) -> Text {
    Text::new(template).with("text", text).with("first", first).with("second", second)
}

fn wrong_kind(wrong: &WrongKind) -> Text {
    let WrongKind { text, unit, kind, default, hint, .. } = wrong;
    let found = match (unit.sense, Kind::of(unit)) {
        (UnitMeaning::Level, _) => Text::new("a level"),
        (_, found) => in_unit(found, unit),
    };
    let example = match kind.units() {
        [first, ..] if default.text.is_empty() => (*first).to_owned(),
        _ => default.ascii(),
    };
    let expects_number = *kind == Kind::Ratio && default.text.is_empty();
    let sentence = match hint {
        None if expects_number => {
            Text::new("`{text}` is {found}; a number without a unit expected, e.g. 0.05")
        }
        None => Text::new("`{text}` is {found}; {expected} expected, e.g. in {example}"),
        Some(hint) => Text::new("`{text}` is {found}; {expected} expected, e.g. in {example}; {hint}")
            .with_text("hint", self::hint(hint)),
    };
    sentence
        .with("text", text)
        .with_text("found", found)
        .with_text("expected", in_unit(*kind, default))
        .with_number("example", example)
}

fn in_unit(kind: Kind, unit: &Unit) -> Text {
    match kind {
        Kind::Other => Text::new("a quantity in {unit}").with("unit", unit.pretty()),
        Kind::Amplitude => Text::new("an amplitude in {unit}").with("unit", unit.pretty()),
        kind => Text::from(kind.name()),
    }
}

/// Refusal of a text that has another dimension than a unit.
pub(crate) fn of_another_dimension(text: &str, found: Dim, expected: &Unit) -> Text {
    Text::new("`{text}` is {found}; {expected} expected, e.g. in {example}")
        .with("text", text)
        .with_text("found", of_dim(found))
        .with_text("expected", of_dim(expected.dim))
        .with("example", expected.ascii())
}

/// A dimension in words.
pub(crate) fn of_dim(dim: Dim) -> Text {
    match Kind::of_dim(dim) {
        Kind::Other => Text::new("a quantity in {unit}").with("unit", dim),
        Kind::Ratio => Text::new("a number without a unit"),
        kind => Text::from(kind.name()),
    }
}

fn hint(hint: &Hint) -> Text {
    match hint {
        Hint::WeightOf(kg) => {
            Text::new("a weight is mass × g: write `9.81*{mass} N` or `{mass} kgf`").with("mass", kg)
        }
        Hint::MassOf(newtons) => {
            Text::new("a mass is weight / g: write `{weight}/9.81 kg`").with("weight", newtons)
        }
        Hint::Namesake("g", text) => {
            Text::new("g is the gram: write `{text}` for multiples of standard gravity").with("text", text)
        }
        Hint::Namesake("g0", text) => {
            Text::new("g0 is standard gravity: write `{text}` for grams").with("text", text)
        }
        Hint::Namesake(unit, text) => {
            let is_force = units::unit(unit).is_ok_and(|unit| Kind::of(&unit) == Kind::Force);
            let sentence = if is_force {
                "{unit} is a force: write `{text}`"
            } else {
                "{unit} is a mass: write `{text}`"
            };
            Text::new(sentence).with("unit", unit).with("text", text)
        }
        Hint::TorqueOf(number) => Text::new("write N·m for a torque: `{number} N*m`").with("number", number),
        Hint::NoAmplitude => {
            Text::new("peak, peak-to-peak and rms belong to amplitudes: write the unit alone")
        }
        Hint::Slope => Text::new("write the angle in rad or deg; that of a 30 % slope is 16.699 deg"),
        Hint::Feet(text) => {
            Text::new("the marks ' and \" are minutes and seconds of arc: write `{text}`").with("text", text)
        }
        Hint::Meant(text) => Text::new("did you mean `{text}`?").with("text", text),
        Hint::Reciprocal(text) => {
            Text::new("write brackets if the divisor is meant to have the unit: `{text}`").with("text", text)
        }
    }
}

/// Correction of a unit that has not the dimension wanted because it has a unit of mass in place of one of force, or the
/// like: "lb is a mass: write `lbf/in`".
pub fn unit_hint(text: &str, dim: Dim) -> Option<Text> {
    units::meant_unit(text, dim).as_ref().map(hint)
}

#[cfg(test)]
mod tests {
    use dalembert_units::{Kind, read_quantity, read_vector, unit};

    /// The translatable sentence says what the error itself says, but for plurals and two refinements.
    #[test]
    fn the_words_are_those_of_the_error() {
        let metre = unit("m").unwrap();
        for typed in [
            "",
            "abc",
            "1,2.3",
            "12 34",
            "3 furlong",
            "3 kg",
            "3 N",
            "1/0",
            "sqrt(-1)",
            "1 m + 1 s",
            "5 lb + 3 lbf",
            "3 J",
            "5 m/",
            "3 ton",
        ] {
            let error = read_quantity(typed, &metre, Kind::Length).unwrap_err();
            assert_eq!(super::text(&error).english(), error.to_string(), "{typed}");
        }
        for (typed, default) in [
            ("0.5 g", "m/s^2"),
            ("0.04 g^2/Hz", "m^2/s^3"),
            ("20 lb/in", "N/m"),
            ("3 lbf", "kg"),
            ("3 g0", "kg"),
        ] {
            let default = unit(default).unwrap();
            let error = read_quantity(typed, &default, Kind::Other).unwrap_err();
            assert_eq!(super::text(&error).english(), error.to_string(), "{typed}");
        }
        let error = read_vector("(1; 2; 3; 4) m", &metre, Kind::Length, 3).unwrap_err();
        assert_eq!(super::text(&error).english(), error.to_string());
    }
}
