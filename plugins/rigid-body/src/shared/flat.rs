//! Marks and letters of drawings: what points away from the viewer, letters of several inputs at one feature.

use dalembert_core::{Ink, Point, Sketch, Text};

/// A vector that points away from the viewer: a circle with a cross.
pub(crate) fn into_page(sketch: &mut Sketch, name: impl Into<Text>, at: Point, radius: f64) {
    let (x, y) = at;
    let d = radius / std::f64::consts::SQRT_2;
    sketch
        .circle(at, radius, Ink::Motion)
        .curve([(x - d, y - d), (x + d, y + d)], Ink::Motion)
        .curve([(x - d, y + d), (x + d, y - d)], Ink::Motion)
        .label(name, at);
}

/// The letters of a body, put after one another; those that are empty are left out.
pub(crate) fn letters(of: &[&str]) -> Text {
    Text::verbatim(of.iter().filter(|one| !one.is_empty()).copied().collect::<Vec<_>>().join(", "))
}

/// A letter with the number of its row, as the working writes it: `m₁`.
pub(crate) fn indexed(letter: &str, row: usize) -> String {
    const DIGITS: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];
    let number = row.to_string();
    letter.chars().chain(number.bytes().map(|digit| DIGITS[usize::from(digit - b'0')])).collect()
}

/// Letters of one row.
pub(crate) fn of_row(of: &[&str], row: usize) -> Text {
    let all: Vec<String> = of.iter().map(|letter| indexed(letter, row)).collect();
    letters(&all.iter().map(String::as_str).collect::<Vec<_>>())
}
