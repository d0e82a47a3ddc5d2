//! Alternatives: each is reached by a case that holds a number.

use std::collections::{BTreeMap, BTreeSet, btree_map};

use dalembert_core::{
    Entry, Field, Record, Shape, Value, Variant,
    cases::{Case, Seen, Truth},
};
use itertools::Itertools as _;

use crate::{problems::cases_of, some};

/// A one-of by the place of the list of its alternatives, which is a `static` of the enum: so an enum that several
/// analyses share, or that stands at several places of one, is one. What an alternative means is then read by the
/// methods of that enum, whoever asks; one case reaches them for all.
type OneOf = usize;

/// Searches every alternative of every one-of in the cases: each is chosen by one with a number that somebody else
/// found. Returns the number of one-ofs.
pub fn every_alternative_is_reached_by_a_case(entries: &[&'static Entry]) -> usize {
    some(entries);
    let mut known: BTreeMap<OneOf, (String, &'static [Variant])> = BTreeMap::new();
    let mut reached: BTreeSet<(OneOf, usize)> = BTreeSet::new();
    for entry in entries {
        alternatives(entry.fields(), entry.about.id, &mut known);
        for case in cases_of(entry).iter().filter(|case| holds(case)) {
            choices(&case.record(entry).unwrap_or_else(|err| panic!("{}: {err}", case.name)), &mut reached);
        }
    }
    let unreached: Vec<String> = known
        .iter()
        .flat_map(|(place, (path, variants))| {
            (0..variants.len())
                .filter(|at| !reached.contains(&(*place, *at)))
                .map(move |at| format!("{path} = {}", variants[at].name))
        })
        .collect();
    assert!(
        unreached.is_empty(),
        "{} alternatives without a case:\n{}",
        unreached.len(),
        unreached.join("\n")
    );
    known.len()
}

/// True for a case with a number that somebody else found.
fn holds(case: &Case) -> bool {
    let apart = match case.truth {
        Truth::Published => case.seen != Some(Seen::Recalled),
        Truth::ClosedForm | Truth::OtherProgram => true,
        Truth::OwnEarlierValue => false,
    };
    apart && !case.expect.is_empty() && case.refused.is_none()
}

/// The one-ofs below some fields that are not known yet.
fn alternatives(
    fields: &'static [Field],
    path: &str,
    known: &mut BTreeMap<OneOf, (String, &'static [Variant])>,
) {
    for field in fields {
        below(field.shape, &format!("{path} {}", field.name), known);
    }
}

fn below(shape: Shape, path: &str, known: &mut BTreeMap<OneOf, (String, &'static [Variant])>) {
    match shape.present() {
        Shape::OneOf(variants) => {
            let variants = variants();
            if let btree_map::Entry::Vacant(new) = known.entry(place(variants)) {
                new.insert((path.to_owned(), variants));
                for variant in variants {
                    alternatives((variant.fields)(), &format!("{path}.{}", variant.name), known);
                }
            }
        }
        Shape::Group(fields) => alternatives(fields(), path, known),
        Shape::Rows { item, .. } => below(*item(), path, known),
        _ => {}
    }
}

/// The alternatives that a record chooses.
fn choices(record: &Record, reached: &mut BTreeSet<(OneOf, usize)>) {
    for (field, value) in record.fields.iter().zip_eq(&record.values) {
        chosen(field.shape, value, reached);
    }
}

fn chosen(shape: Shape, value: &Value, reached: &mut BTreeSet<(OneOf, usize)>) {
    match (shape.present(), value) {
        (Shape::OneOf(variants), Value::OneOf { variant, fields }) => {
            reached.insert((place(variants()), *variant));
            choices(fields, reached);
        }
        (_, Value::Group(record)) => choices(record, reached),
        (Shape::Rows { item, .. }, Value::Rows(rows)) => {
            for row in rows {
                chosen(*item(), row, reached);
            }
        }
        _ => {}
    }
}

fn place(variants: &'static [Variant]) -> OneOf {
    variants.as_ptr().addr()
}
