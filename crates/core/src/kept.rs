//! Inputs that keep their first value in a field beside them when they are changed alone: a mechanism is drawn with one
//! value of a driver, which fixes how gears mesh and on which side a linkage is assembled, and moved to others.

use crate::{
    Draft, Field, Record, Shape, Value,
    draft::read_leaf,
    path::{Segment, segments},
};

/// Keeps the present value of the input at a path, where a field beside it keeps it and is left out.
pub(crate) fn keep(record: &mut Record, path: &str) {
    if let Ok(segments) = segments(path) {
        keep_at(record, &segments);
    }
}

fn keep_at(record: &mut Record, path: &[Segment]) {
    let Some((Segment::Name(name), rest)) = path.split_first() else { return };
    let Some(at) = record.fields.iter().position(|field| field.name == name) else { return };
    if !rest.is_empty() {
        return keep_within(&mut record.values[at], rest);
    }
    if let Some(kept) = place(record.fields, at)
        && record.values[kept] == Value::Absent
    {
        record.values[kept] = record.values[at].clone();
    }
}

fn keep_within(value: &mut Value, path: &[Segment]) {
    match (value, path) {
        (Value::Group(record), path) => keep_at(record, path),
        // The first segment is the name of the alternative.
        (Value::OneOf { fields, .. }, [_, rest @ ..]) => keep_at(fields, rest),
        (Value::Rows(rows), [Segment::Row(row), rest @ ..]) => {
            if let Some(row) = rows.get_mut(*row) {
                keep_within(row, rest);
            }
        }
        _ => {}
    }
}

/// The place of the field that keeps the first value of the one at `at`.
fn place(fields: &[Field], at: usize) -> Option<usize> {
    let kept_in = fields[at].kept_in?;
    fields.iter().position(|field| field.name == kept_in)
}

impl Draft {
    /// After a change of one input from `before`: keeps its value of then, where a field beside it keeps it and is left
    /// out, and nothing else was changed there. A value that could not be read is none.
    pub fn keep_first(&mut self, before: &Draft, shape: &Shape) {
        match (shape.present(), self, before) {
            (Shape::Group(fields), Draft::Group(now), Draft::Group(before)) => {
                keep_in_group(fields(), now, before);
            }
            (Shape::OneOf(variants), Draft::OneOf(at, now), Draft::OneOf(was, before)) if at == was => {
                if let (Some(variant), Draft::Group(now), Draft::Group(before)) =
                    (variants().get(*at), &mut **now, &**before)
                {
                    keep_in_group((variant.fields)(), now, before);
                }
            }
            (Shape::Rows { item, .. }, Draft::Rows(now), Draft::Rows(before))
                if now.len() == before.len() =>
            {
                for (now, before) in now.iter_mut().zip(before) {
                    now.keep_first(before, item());
                }
            }
            _ => {}
        }
    }
}

fn keep_in_group(fields: &[Field], now: &mut [Draft], before: &[Draft]) {
    let changed: Vec<usize> = (0..now.len().min(before.len())).filter(|&at| now[at] != before[at]).collect();
    if let [at] = changed[..]
        && let Some(kept) = place(fields, at)
    {
        let is_left_out = match &now[kept] {
            Draft::Absent => true,
            Draft::Leaf(text) => text.trim().is_empty(),
            _ => false,
        };
        if let Draft::Leaf(text) = &before[at]
            && is_left_out
            && read_leaf(text, &fields[at].shape, "").is_ok()
        {
            now[kept] = Draft::Leaf(text.clone());
        }
        return;
    }
    for at in changed {
        now[at].keep_first(&before[at], &fields[at].shape);
    }
}
