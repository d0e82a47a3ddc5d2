//! Paths of fields as text: `supports[2].cantilever.length`. Rows count from 1, as in `m₁`.

use crate::{ChildList, Field, FieldError, Shape, Text, ascii};

/// The most names that an error lists.
const MOST_KNOWN: usize = 40;
/// The most inputs that an error offers for a name.
const MOST_NEAR: usize = 3;
/// The longest name that is compared with others, or repeated in full in an error.
const LONGEST_NAME: usize = 100;

/// A part of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Segment {
    /// A field or an alternative.
    Name(String),
    /// A row, counted from 0.
    Row(usize),
}

/// The parts of a path.
pub(crate) fn segments(path: &str) -> Result<Vec<Segment>, FieldError> {
    let mut parts = Vec::new();
    for piece in path.split('.') {
        let (name, mut rest) = piece.split_at(piece.find('[').unwrap_or(piece.len()));
        if name.is_empty() {
            return Err(FieldError::new(path, "a name is missing; write a path such as masses[1].radius"));
        }
        parts.push(Segment::Name(name.to_owned()));
        while let Some(tail) = rest.strip_prefix('[') {
            let row =
                tail.split_once(']').and_then(|(row, tail)| Some((row.trim().parse::<usize>().ok()?, tail)));
            match row {
                Some((row @ 1.., tail)) => {
                    parts.push(Segment::Row(row - 1));
                    rest = tail;
                }
                _ => {
                    let why = Text::new("`{row}` is not a row; rows count from 1, as in masses[1]")
                        .with("row", rest);
                    return Err(FieldError::new(path, why));
                }
            }
        }
        if !rest.is_empty() {
            return Err(FieldError::new(
                path,
                Text::new("`{rest}` was not expected here").with("rest", rest),
            ));
        }
    }
    Ok(parts)
}

/// The indices of a path within a shape: what [`Inputs::slot`](crate::Inputs::slot) takes.
pub(crate) fn indices(shape: &Shape, path: &str) -> Result<Vec<usize>, FieldError> {
    let mut indices = Vec::new();
    let mut shape = *shape;
    for segment in segments(path)? {
        let (at, inner) = match (shape.present(), &segment) {
            (Shape::Vector(measure, _), Segment::Name(name)) => {
                let at = ["x", "y", "z"].iter().position(|axis| axis == name);
                let at = at.ok_or_else(|| unknown(path, name, ["x", "y", "z"].into_iter()))?;
                (at, Shape::Quantity(measure))
            }
            (shape, segment) => step(&shape, segment, path)?,
        };
        indices.push(at);
        shape = inner;
    }
    Ok(indices)
}

/// Index and shape of the part that a segment of a path leads to. A one-of leads to the group of an alternative.
pub(crate) fn step(shape: &Shape, segment: &Segment, path: &str) -> Result<(usize, Shape), FieldError> {
    match (shape, segment) {
        (Shape::Group(fields), Segment::Name(name)) => {
            let fields = fields();
            let at = fields.iter().position(|field| field.name == name);
            let at = at.ok_or_else(|| unknown_input(path, name, fields))?;
            Ok((at, fields[at].shape))
        }
        (Shape::OneOf(variants), Segment::Name(name)) => {
            let variants = variants();
            let at = variants.iter().position(|variant| variant.name == name);
            let at = at.ok_or_else(|| unknown(path, name, variants.iter().map(|variant| variant.name)))?;
            Ok((at, Shape::Group(variants[at].fields)))
        }
        (Shape::Rows { item, .. }, Segment::Row(row)) => Ok((*row, *item())),
        (Shape::Rows { .. }, Segment::Name(name)) => {
            let row = path.replacen(&format!(".{name}"), &format!("[1].{name}"), 1);
            Err(FieldError::new(path, Text::new("is in a list; name a row, as in {row}").with("row", row)))
        }
        _ => Err(FieldError::new(path, "there is no such input: what it would be part of is one value")),
    }
}

/// The error of a name that is none of `known`, with the nearest one.
pub(crate) fn unknown<'k>(path: &str, name: &str, known: impl Iterator<Item = &'k str>) -> FieldError {
    let known: Vec<&str> = known.collect();
    let shown = shortened(name);
    let why = match nearest(name, known.iter().copied()) {
        Some(near) => {
            Text::new("there is no `{name}`; did you mean `{near}`?").with("name", shown).with("near", near)
        }
        None => {
            let more = if known.len() > MOST_KNOWN { ", …" } else { "" };
            let known = format!("{}{more}", known[..known.len().min(MOST_KNOWN)].join(", "));
            Text::new("there is no `{name}`; write one of {known}").with("name", shown).with("known", known)
        }
    };
    FieldError::new(path, why)
}

/// The error of a name that is no input among `fields`: with the nearest of them, or those of that symbol, or those of that
/// name in a group or an alternative.
pub(crate) fn unknown_input(path: &str, name: &str, fields: &'static [Field]) -> FieldError {
    let names = || fields.iter().map(|field| field.name);
    if nearest(name, names()).is_some() || name.len() > LONGEST_NAME {
        return unknown(path, name, names());
    }
    let mut found = Vec::new();
    meant(name, fields, "", &mut Vec::new(), &mut found);
    found.truncate(MOST_NEAR);
    if found.is_empty() {
        return unknown(path, name, names());
    }
    let why = Text::new("there is no `{name}`; did you mean `{near}`?").with("name", name);
    FieldError::new(path, why.with("near", found.join("`, `")))
}

/// Paths of the inputs that have a name or a symbol, those of the nearest level first in each branch.
fn meant(
    name: &str,
    fields: &'static [Field],
    above: &str,
    seen: &mut Vec<ChildList>,
    found: &mut Vec<String>,
) {
    let plain = |text: &str| ascii(text).replace(['_', ' '], "");
    let is_meant = |field: &&Field| {
        field.name == name || (!field.symbol.is_empty() && plain(field.symbol) == plain(name))
    };
    found.extend(fields.iter().filter(is_meant).map(|field| format!("{above}{}", field.name)));
    for field in fields {
        let (mut shape, mut path) = (field.shape.present(), format!("{above}{}", field.name));
        while let Shape::Rows { item, .. } = shape {
            (shape, path) = (item().present(), format!("{path}[1]"));
        }
        let Some(list) = shape.child_list().filter(|list| !seen.contains(list)) else { continue };
        seen.push(list);
        match shape {
            Shape::Group(fields) => meant(name, fields(), &format!("{path}."), seen, found),
            Shape::OneOf(variants) => {
                for variant in variants() {
                    meant(name, (variant.fields)(), &format!("{path}.{}.", variant.name), seen, found);
                }
            }
            _ => {}
        }
    }
}

/// Returns true if a path is equal to another or within it: `force.x` is within `force`.
pub fn is_within(path: &str, of: &str) -> bool {
    path.strip_prefix(of).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// The known name that `name` was probably meant to be.
pub fn nearest<'k>(name: &str, known: impl Iterator<Item = &'k str>) -> Option<&'k str> {
    // A pasted page is no slip of a name, and comparing it would take minutes.
    if name.len() > LONGEST_NAME {
        return None;
    }
    let name = name.to_lowercase().replace('_', "-");
    known
        .map(|candidate| (distance(&name, &candidate.to_lowercase().replace('_', "-")), candidate))
        .min_by_key(|(distance, _)| *distance)
        .filter(|(distance, candidate)| *distance <= 1 + candidate.chars().count() / 3)
        .map(|(_, candidate)| candidate)
}

/// A name as an error repeats it.
pub(crate) fn shortened(name: &str) -> String {
    match name.char_indices().nth(LONGEST_NAME) {
        Some((end, _)) => format!("{}…", &name[..end]),
        None => name.to_owned(),
    }
}

/// Edits (insert, delete, replace, swap neighbours) from one word to the other.
pub(crate) fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let same = usize::from(a[i - 1] != b[j - 1]);
                let swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
                let swapped = if swap { rows[i - 2][j - 2] + 1 } else { usize::MAX };
                (rows[i - 1][j] + 1).min(rows[i][j - 1] + 1).min(rows[i - 1][j - 1] + same).min(swapped)
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_names_and_rows() {
        let name = |text: &str| Segment::Name(text.into());
        assert_eq!(segments("joints[2].axis").unwrap(), [name("joints"), Segment::Row(1), name("axis")]);
        assert_eq!(segments("a[1][3]").unwrap(), [name("a"), Segment::Row(0), Segment::Row(2)]);
        for wrong in ["", ".x", "a[0]", "a[x]", "a[1", "a[1]b"] {
            assert!(segments(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn the_nearest_name_is_offered() {
        let known = ["rotating-unbalance", "two-plane", "shaft-clearance"];
        assert_eq!(nearest("rotating_unbalence", known.into_iter()), Some("rotating-unbalance"));
        assert_eq!(nearest("2-plane", known.into_iter()), Some("two-plane"));
        assert_eq!(nearest("pendulum", known.into_iter()), None);
    }
}
