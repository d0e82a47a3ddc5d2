//! Marks and letters of drawings: what points away from the viewer, letters of several inputs at one feature.

use dalembert_core::{Ink, Point, Sketch, Symbol, Text, printer};

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
fn indexed(letter: &'static str, row: usize) -> String {
    printer::symbol(&Symbol::from(letter).row(row))
}

/// Letters of one row.
pub(crate) fn of_row(of: &[&'static str], row: usize) -> Text {
    Text::verbatim(of.iter().map(|letter| indexed(letter, row)).collect::<Vec<_>>().join(", "))
}
