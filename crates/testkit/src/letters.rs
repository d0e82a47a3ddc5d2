//! Letters of drawings: what the form asks for stands in a figure of the problem.

use std::collections::BTreeMap;

use dalembert_core::{
    Drawing, DrawnShape, Entry, Exhibit, Field, Locale, Number, Record, Shape, Solution, Stop, Value, cases,
    normalised, printer, trace::Op,
};
use dalembert_units::Kind;

/// Kinds of inputs that a figure of the machine shows: lengths, angles, masses, springs, dampers, loads, speeds.
const SHOWN: [Kind; 14] = [
    Kind::Length,
    Kind::Amplitude,
    Kind::Angle,
    Kind::Mass,
    Kind::MomentOfInertia,
    Kind::Unbalance,
    Kind::Stiffness,
    Kind::TorsionalStiffness,
    Kind::Damping,
    Kind::TorsionalDamping,
    Kind::Force,
    Kind::Torque,
    Kind::Velocity,
    Kind::AngularVelocity,
];

/// Symbols of an analysis that no figure shows, and why.
#[derive(Default)]
struct Listed {
    reasons: BTreeMap<String, String>,
}

/// Searches the drawings, animations and scenes of the first case of every analysis for the symbol of each input that is a
/// length, an angle, a mass, a spring, a load, a speed: it stands there as a word of a label. What no figure shows is
/// listed, a line for each reason: `analysis: symbol symbol — reason`. A listed symbol that is labelled is a fault as well,
/// so that the list can only become shorter. Returns the number of labelled symbols and of listed ones.
pub fn every_symbol_of_the_form_stands_in_a_drawing(
    entries: &[&'static Entry],
    listed: &[&str],
) -> (usize, usize) {
    let mut listed = read(listed);
    let (mut faults, mut labelled, mut exempt) = (Vec::new(), 0, 0);
    for entry in entries {
        let Some((record, solution)) = first(entry) else { continue };
        let words = labels(&solution);
        let mut known = listed.remove(entry.about.id).unwrap_or_default();
        let mut missing = Vec::new();
        for (symbol, name) in symbols(&record, &solution) {
            let stands = |word: &str| words.iter().any(|label| names(label, word));
            let is_labelled = stands(&symbol) || name.as_deref().is_some_and(stands);
            match (is_labelled, known.reasons.remove(&symbol)) {
                (true, None) => labelled += 1,
                (false, Some(_)) => exempt += 1,
                (true, Some(_)) => {
                    faults.push(format!("{}: {symbol} is labelled and listed", entry.about.id));
                }
                (false, None) => missing.push(symbol),
            }
        }
        if !missing.is_empty() {
            faults.push(format!("{}: {} — no label", entry.about.id, missing.join(" ")));
        }
        let unknown =
            known.reasons.keys().map(|symbol| format!("{}: {symbol} is listed and no input", entry.about.id));
        faults.extend(unknown);
    }
    faults.extend(listed.keys().map(|id| format!("{id} is listed and no analysis")));
    let count = faults.len();
    assert!(
        faults.is_empty(),
        "{labelled} symbols labelled, {exempt} listed, {count} faults:\n{}",
        faults.join("\n")
    );
    (labelled, exempt)
}

/// The symbols of the list by their analyses.
fn read(texts: &[&str]) -> BTreeMap<String, Listed> {
    let mut all: BTreeMap<String, Listed> = BTreeMap::new();
    for line in texts.iter().flat_map(|text| text.lines()).filter(|line| !line.starts_with("# ")) {
        let (before, reason) = line.split_once(" — ").unwrap_or_else(|| panic!("no reason in `{line}`"));
        let (id, symbols) = before.split_once(": ").unwrap_or_else(|| panic!("no analysis in `{line}`"));
        let of = all.entry(id.to_owned()).or_default();
        for symbol in symbols.split(' ') {
            let twice = of.reasons.insert(symbol.to_owned(), reason.to_owned());
            assert!(twice.is_none() && !reason.is_empty(), "{id}: {symbol} is listed twice");
        }
    }
    all
}

fn first(entry: &'static Entry) -> Option<(Record, Solution)> {
    let record = cases::first(entry)?.record(entry).ok()?;
    let solution = entry.solve(&record, &Stop::new()).ok()?;
    Some((record, solution))
}

/// The symbols of the inputs that a figure shows, as the working writes them: `m₁` of the first row. What is zero has no
/// extent to be labelled. A place that has a name in its row may stand under that name.
fn symbols(record: &Record, solution: &Solution) -> BTreeMap<String, Option<String>> {
    let (mut shown, mut row_names) = (BTreeMap::new(), BTreeMap::new());
    record.leaves(&mut |path, field, value| match value {
        Value::Quantity(_) | Value::Vector(_) if is_shown(field) => {
            shown.insert(path.to_owned(), matches!(value, Value::Vector(_)));
        }
        Value::Text(name) if field.name == "name" => {
            row_names.insert(path.trim_end_matches(".name").to_owned(), name.clone());
        }
        _ => {}
    });
    let given = solution.trace.nodes.iter().filter_map(|node| {
        let Op::Given { symbol, path, .. } = &node.op else { return None };
        let is_place = *shown.get(path).filter(|_| !is_zero(node.number))?;
        let row = path.rsplit_once('.').map(|(row, _)| row).filter(|_| is_place);
        let name = row.and_then(|row| row_names.get(row)).cloned();
        Some((printer::symbol(symbol).replace(' ', ""), name))
    });
    given.filter(|(symbol, _)| !symbol.is_empty()).collect()
}

fn is_zero(number: Number) -> bool {
    match number {
        Number::Scalar(x) => x == 0.0,
        Number::Vector(v) => v == [0.0; 3],
    }
}

/// True for an input that a figure of the machine shows; gravity, frequencies and lengths over which something is computed
/// are none.
fn is_shown(field: &Field) -> bool {
    let mut shape = field.shape;
    while let Shape::Optional(inner) | Shape::Rows { item: inner, .. } = shape {
        shape = *inner();
    }
    let (Shape::Quantity(measure) | Shape::Vector(measure, _)) = shape else { return false };
    field.symbol != "g" && measure.unit != "Hz" && SHOWN.contains(&measure.kind())
}

/// The words of all figures of a solution.
fn labels(solution: &Solution) -> Vec<String> {
    let drawings = solution.exhibits.iter().filter_map(|exhibit: &Exhibit| exhibit.sketch(0));
    let words = |drawing: &Drawing| {
        let texts = drawing.shapes.iter().filter_map(|shape| match shape {
            DrawnShape::Label(_, _, text) => Some(text.render(&Locale::english())),
            _ => None,
        });
        texts.collect::<Vec<_>>()
    };
    drawings.flat_map(|drawing| words(&drawing)).collect()
}

/// True if a label has the symbol as a word: `m₁` in `m₁ r₁` and `m_1 = 2 kg`, not in `m₁₂`.
fn names(label: &str, symbol: &str) -> bool {
    let belongs = |c: char| c.is_alphanumeric() || matches!(c, '_' | '′' | '\u{307}' | '\u{308}' | ',');
    let mut words = label.split(|c| !belongs(c)).map(|word| word.trim_end_matches(','));
    words.any(|word| normalised(word) == normalised(symbol))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_symbol_is_a_whole_word_of_a_label() {
        for label in ["m₁", "m₁ r₁", "2 m₁ = 4 kg", "k(m₁)", "m₁, m₂", "m_1"] {
            assert!(names(label, "m₁"), "{label}");
        }
        for label in ["m₁₂", "m₁,₂", "am₁", "m", "m₁′", "I_m₁"] {
            assert!(!names(label, "m₁"), "{label}");
        }
    }
}
