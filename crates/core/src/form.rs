//! The inputs of a problem as a form, whatever draws it: lines of a [`Draft`], texts as a user of a language types them, and
//! changes of lists and alternatives.

mod lines;
mod units;

use dalembert_units::Decimal;

pub use self::{
    lines::{BETWEEN, FormLine, Role, lines, push_field, summary},
    units::{in_next_unit, own_unit, with_unit, written_unit},
};
use crate::{Draft, Shape, draft};

/// A text of the draft as it is shown and edited in a language: numbers with its decimal mark. What is no quantity stays
/// as it is.
pub fn in_language(text: &str, shape: &Shape, decimal: Decimal) -> String {
    let is_quantity = matches!(shape.present(), Shape::Quantity(_) | Shape::Vector(..));
    let is_marked = decimal != Decimal::Point && is_quantity && draft::read_leaf(text, shape, "").is_ok();
    if is_marked { decimal.written(text) } else { text.to_owned() }
}

/// A number as a draft has it, of what is typed in a language: with a decimal point. Any other text as it is.
pub fn settled(text: String, shape: &Shape, decimal: Decimal) -> String {
    match shape.present() {
        Shape::Quantity(_) | Shape::Vector(..) => decimal.to_point(&text),
        _ => text,
    }
}

/// The rows of a list, to be changed, and its shape; `None` where the path leads to no list.
pub fn rows_mut<'d>(draft: &'d mut Draft, shape: &Shape, list: &str) -> Option<(&'d mut Vec<Draft>, Shape)> {
    match draft.at_mut(shape, list).ok()? {
        (Draft::Rows(rows), shape) => Some((rows, shape.present())),
        _ => None,
    }
}

/// Puts a row, blank but for first alternatives, into a list: at a place, or at its end. The place; `None` where the list
/// has room for no more.
pub fn insert_row(draft: &mut Draft, shape: &Shape, list: &str, at: Option<usize>) -> Option<usize> {
    let (rows, shape) = rows_mut(draft, shape, list)?;
    let Shape::Rows { item, most, .. } = shape else { return None };
    if rows.len() >= most {
        return None;
    }
    let at = at.map_or(rows.len(), |at| at.min(rows.len()));
    rows.insert(at, Draft::blank(item()).with_first_alternatives(item()));
    Some(at)
}

/// Puts in an optional input that was left out, blank but for first alternatives.
pub fn put_in(draft: &mut Draft, shape: &Shape, path: &str) -> Option<()> {
    let (place, shape) = draft.at_mut(shape, path).ok()?;
    let shape = shape.present();
    *place = Draft::blank(&shape).with_first_alternatives(&shape);
    Some(())
}

/// Names of the rows of a list, which a reference may name; their numbers where they have none.
pub fn names(draft: &Draft, shape: &Shape, list: &str) -> Vec<String> {
    let Ok((Draft::Rows(rows), shape)) = draft.at(shape, list) else { return Vec::new() };
    let Shape::Rows { item, .. } = shape.present() else { return Vec::new() };
    let named = item().fields(None).iter().position(|field| field.name == "name");
    let name = |row: &Draft| match (row, named) {
        (Draft::Group(fields), Some(at)) => match fields.get(at) {
            Some(Draft::Leaf(text)) if !text.trim().is_empty() => Some(text.trim().to_owned()),
            _ => None,
        },
        _ => None,
    };
    rows.iter().enumerate().map(|(n, row)| name(row).unwrap_or_else(|| (n + 1).to_string())).collect()
}

/// An alternative of a one-of, with the texts of that which is left in the fields that both have. `None` where the shape is
/// no one-of, or the alternative is chosen already.
pub fn alternative(shape: &Shape, old: &Draft, to: usize) -> Option<Draft> {
    if !matches!(shape, Shape::OneOf(_)) {
        return None;
    }
    let new = match Draft::alternative(shape, to).with_first_alternatives(shape) {
        Draft::OneOf(_, blank) => *blank,
        _ => return None,
    };
    let fields = match old {
        Draft::OneOf(from, _) if *from == to => return None,
        Draft::OneOf(from, old) => with_common_texts(new, old, shape, *from, to),
        _ => new,
    };
    Some(Draft::OneOf(to, Box::new(fields)))
}

/// The fields of an alternative, with the texts of another in the fields of the same name.
fn with_common_texts(blank: Draft, old: &Draft, shape: &Shape, from: usize, to: usize) -> Draft {
    let (Draft::Group(mut blank), Draft::Group(old)) = (blank, old) else { return Draft::Absent };
    let names = shape.fields(Some(from));
    for (field, place) in shape.fields(Some(to)).iter().zip(&mut blank) {
        let common =
            names.iter().position(|other| other.name == field.name && alike(&other.shape, &field.shape));
        if let Some(old) = common.and_then(|at| old.get(at)) {
            *place = old.clone();
        }
    }
    Draft::Group(blank)
}

/// Returns true if the texts of one shape may stand in the other.
fn alike(a: &Shape, b: &Shape) -> bool {
    match (a, b) {
        (Shape::OneOf(a), Shape::OneOf(b)) => std::ptr::eq(a(), b()),
        (Shape::Group(a), Shape::Group(b)) => std::ptr::eq(a(), b()),
        (Shape::Rows { item: a, .. }, Shape::Rows { item: b, .. })
        | (Shape::Optional(a), Shape::Optional(b)) => alike(a(), b()),
        _ => a.is_leaf() && b.is_leaf(),
    }
}
