//! Inputs: one gravity in a problem, and tables whose units are known.

use std::collections::BTreeSet;

use dalembert_core::{Draft, Entry, Field, Record, Shape, Value, gravity, vary};
use dalembert_units::unit;

use crate::{problems::cases_of, some};

/// Searches the inputs named after gravity: each is the gravity of its problem, with the usual default. Returns their
/// number.
pub fn every_gravity_has_the_same_default(entries: &[&'static Entry]) -> usize {
    some(entries);
    let mut found = 0;
    for entry in entries {
        fields(entry.fields(), entry.about.id, &mut Vec::new(), &mut |path, field| {
            let (Shape::Quantity(measure) | Shape::Vector(measure, _)) = field.shape else { return };
            if !(field.symbol == "g" && measure.unit == "m/s^2" || field.name.contains("gravity")) {
                return;
            }
            assert!(gravity::is_gravity(field), "{path} is no gravity of the problem");
            let default = field.default.unwrap_or_default();
            let known = ["9.81 m/s^2", "(0; -9.81) m/s^2", "(0; 0; -9.81) m/s^2"];
            assert!(known.contains(&default), "{path} is {default}");
            found += 1;
        });
    }
    found
}

/// Leaves out every gravity of every case, and states the first: the problem has one number for all of them. Returns
/// the number of cases with several.
pub fn a_problem_has_one_gravity(entries: &[&'static Entry]) -> usize {
    some(entries);
    let mut several = 0;
    for entry in entries {
        for case in cases_of(entry) {
            // The same problem with every gravity left out, and then with the first of them stated.
            let mut draft = case.draft.clone();
            let shape = entry.shape();
            let paths = |record: &Record| {
                let mut paths = Vec::new();
                record.leaves(&mut |path, field, value| {
                    if gravity::is_gravity(field) && matches!(value, Value::Quantity(_)) {
                        paths.push(path.to_owned());
                    }
                });
                paths
            };
            let Ok(record) = draft.read(&shape) else { continue };
            let paths = paths(&record);
            for path in &paths {
                draft.set(&shape, path, "").expect("a gravity can be left out");
            }
            let values = |draft: &Draft| {
                let mut values = BTreeSet::new();
                draft.read(&shape).expect("a gravity left out has a default").leaves(
                    &mut |_, field, value| {
                        if let (true, Value::Quantity(quantity)) = (gravity::is_gravity(field), value) {
                            values.insert(quantity.si.to_bits());
                        }
                    },
                );
                values.into_iter().map(f64::from_bits).collect::<Vec<_>>()
            };
            let Some(first) = paths.first() else { continue };
            let default = values(&draft);
            let known = |si: &f64| [9.81, 9.81456].iter().any(|known| (si / known - 1.0).abs() < 1e-15);
            assert!(default.len() == 1 && default.iter().all(known), "{}: {default:?}", entry.about.id);
            draft.set(&shape, first, "1.62 m/s^2").expect("a gravity can be stated");
            assert_eq!(values(&draft), [1.62], "{}", entry.about.id);
            // And it is one number to those who vary it.
            let record = draft.read(&shape).expect("it can be read");
            let inputs = vary::inputs(&record);
            assert_eq!(inputs.iter().filter(|input| paths.contains(&input.path)).count(), 1);
            let changed = vary::changed(&record, first, 3.7).expect("gravity can be changed");
            changed.leaves(&mut |path, _, value| {
                if let (true, Value::Quantity(quantity)) = (paths.iter().any(|known| known == path), value) {
                    assert_eq!(quantity.si, 3.7, "{}: {path}", entry.about.id);
                }
            });
            several += usize::from(paths.len() > 1);
        }
    }
    several
}

/// Searches the columns of frequencies: they are in hertz, speeds of shafts in revolutions per minute. Returns their
/// number.
pub fn frequencies_in_tables_are_in_hertz(entries: &[&'static Entry]) -> usize {
    some(entries);
    let speed = unit("Hz").expect("a frequency has a unit").dim;
    let mut found = 0;
    for entry in entries {
        fields(entry.fields(), entry.about.id, &mut Vec::new(), &mut |path, field| {
            let mut shape = field.shape;
            while let Shape::Optional(inner) | Shape::Rows { item: inner, .. } = shape {
                shape = *inner();
            }
            let Shape::Table(columns) = shape else { return };
            for column in columns() {
                let Shape::Quantity(measure) = column.shape else { continue };
                if measure.own_unit().dim != speed {
                    continue;
                }
                // Speeds of shafts are in revolutions.
                let wanted = if column.name == "speed" { "rpm" } else { "Hz" };
                assert_eq!(measure.unit, wanted, "{path}.{}", column.name);
                found += 1;
            }
        });
    }
    found
}

/// Reads the tables of every case: their headings name the units. Returns the number of tables.
pub fn published_tables_name_their_units(entries: &[&'static Entry]) -> usize {
    some(entries);
    let mut tables = 0;
    for entry in entries {
        for case in cases_of(entry) {
            let Ok(record) = case.draft.read(&entry.shape()) else { continue };
            record.leaves(&mut |path, _, value| {
                let Value::Table(table) = value else { return };
                assert!(!table.assumed.contains(&true), "{}, {}: {path}", entry.about.id, case.name);
                tables += 1;
            });
        }
    }
    tables
}

/// Every field, with its path, the columns of tables and the insides of every alternative included. What contains
/// itself is entered once.
fn fields(
    list: &'static [Field],
    above: &str,
    seen: &mut Vec<*const Field>,
    visit: &mut impl FnMut(&str, &'static Field),
) {
    if seen.contains(&list.as_ptr()) {
        return;
    }
    seen.push(list.as_ptr());
    for field in list {
        let path = format!("{above}.{}", field.name);
        visit(&path, field);
        inside(&field.shape, &path, seen, visit);
    }
    seen.pop();
}

fn inside(
    shape: &Shape,
    path: &str,
    seen: &mut Vec<*const Field>,
    visit: &mut impl FnMut(&str, &'static Field),
) {
    match shape {
        Shape::Group(list) | Shape::Table(list) => fields(list(), path, seen, visit),
        Shape::OneOf(variants) => {
            for variant in variants() {
                fields((variant.fields)(), &format!("{path}.{}", variant.name), seen, visit);
            }
        }
        Shape::Rows { item, .. } => inside(item(), path, seen, visit),
        Shape::Optional(inner) => inside(inner(), path, seen, visit),
        _ => {}
    }
}
