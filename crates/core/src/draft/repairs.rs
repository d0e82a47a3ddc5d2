//! Repairs of a text that cannot be read.

use dalembert_units as units;

use super::{per_cent, read_leaf};
use crate::Shape;

/// Texts to write in place of a wrong one: those that its error offers and that can be read.
pub fn repairs(text: &str, shape: &Shape) -> Vec<String> {
    let error = match shape.present() {
        Shape::Quantity(measure) => {
            let one = measure.meant(text);
            match units::read_quantity(measure.without_letter(text), &one.own_unit(), one.kind()) {
                Ok(quantity) => return per_cent(text, &quantity, shape).map_or_else(Vec::new, Vec::from),
                Err(error) => error,
            }
        }
        Shape::Vector(measure, len) => {
            match units::read_vector(text, &measure.own_unit(), measure.kind(), len) {
                Ok(_) => return Vec::new(),
                Err(error) => error,
            }
        }
        _ => return Vec::new(),
    };
    let around = error.span().and_then(|span| Some((text.get(..span.start)?, text.get(span.end..)?)));
    let can_be_read = |text: &String| read_leaf(text, shape, "").is_ok();
    let repaired = |part: String| {
        // A part of the text in its place, or a text of its own.
        let within = around.map(|(before, after)| format!("{before}{part}{after}")).filter(can_be_read);
        within.or_else(|| Some(part).filter(can_be_read))
    };
    error.repairs().into_iter().filter_map(repaired).collect()
}
