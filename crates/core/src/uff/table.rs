//! The text of a table from a function of a universal file.

use dalembert_units as units;

use super::{Characteristic, Skipped, UffFunction, functions};
use crate::{Field, Shape, Text};

/// The most remarks that are written over a table.
const MOST_REMARKS: usize = 20;

/// Reason for which a universal file gives no table.
#[derive(Clone, Debug, PartialEq)]
pub struct UniversalError(
    /// Description of the error and of its repair.
    pub Text,
);

impl std::fmt::Display for UniversalError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0.english())
    }
}

impl std::error::Error for UniversalError {}

/// The table that columns ask for, from the only function of a universal file that has it, or from the one of that
/// number, counted from 1, or of that name. Over the rows stand remarks: which function it is, what its units were taken
/// for, and what of the file was left out.
///
/// Two columns take abscissa and ordinate, of a complex function its amplitude; three columns take real and
/// imaginary part, or amplitude and phase where the last one is an angle.
///
/// Errors: no function that fits; several that may be meant, with their numbers, names and degrees of freedom.
pub fn table(bytes: &[u8], columns: &'static [Field], which: Option<&str>) -> Result<String, UniversalError> {
    chosen_table(bytes, columns, which).map_err(UniversalError)
}

fn chosen_table(bytes: &[u8], columns: &'static [Field], which: Option<&str>) -> Result<String, Text> {
    let (found, skipped) = functions(bytes);
    if found.is_empty() {
        return Err(match skipped.first() {
            Some(Skipped { line, why }) => {
                Text::new("this universal file has no function that can be read; line {line}: {why}")
                    .with("line", line)
                    .with_text("why", why.clone())
            }
            None => Text::new("this universal file has no function that can be read"),
        });
    }
    let chosen = match which {
        Some(which) => chosen(&found, which)?,
        None => (0..found.len()).collect(),
    };
    let (mut fitting, mut first_fault) = (Vec::new(), None);
    for at in chosen {
        match rows(&found[at], columns) {
            Ok(read) => fitting.push((at, read)),
            Err(why) => first_fault = first_fault.or(Some((found[at].line, why))),
        }
    }
    match (fitting.as_slice(), first_fault) {
        ([(at, (remarks, rows))], _) => Ok(written_table(&found, *at, remarks, &skipped) + rows),
        ([], Some((line, why))) => {
            Err(Text::new("no function of this universal file fits the table; line {line}: {why}")
                .with("line", line)
                .with_text("why", why))
        }
        ([], None) => Err(Text::new("this universal file has no function that can be read")),
        (several, _) => {
            let why = Text::new(
                "{have} functions of this universal file fit the table: choose one by its number, as in `@FILE#{first}`; it has {functions}",
            );
            let places: Vec<usize> = several.iter().map(|(at, _)| *at).collect();
            let why = why.with("have", several.len()).with("first", places[0] + 1);
            Err(why.with("functions", listed(&found, &places)))
        }
    }
}

/// Index of the function of a number, or those of a name.
fn chosen(found: &[UffFunction], which: &str) -> Result<Vec<usize>, Text> {
    let which = which.trim();
    let all: Vec<usize> = (0..found.len()).collect();
    let at = which.parse::<usize>().ok().and_then(|which| which.checked_sub(1));
    if let Some(at) = at.filter(|at| *at < found.len()) {
        return Ok(vec![at]);
    }
    let named: Vec<usize> =
        all.iter().copied().filter(|at| found[*at].name.eq_ignore_ascii_case(which)).collect();
    if !named.is_empty() {
        return Ok(named);
    }
    let why = Text::new("there is no function {which}; this universal file has {have}: {functions}");
    let why = why.with("which", which).with("have", found.len());
    Err(why.with("functions", listed(found, &all)))
}

/// Numbers, names and degrees of freedom of functions: `2 FRF of the beam 5:3/1:-3`.
fn listed(found: &[UffFunction], places: &[usize]) -> String {
    let one = |at: &usize| {
        let function = &found[*at];
        let ((node, direction), (reference, along)) = (function.response, function.reference);
        format!("{} {} {node}:{direction}/{reference}:{along}", at + 1, named(function))
    };
    let mut list: Vec<String> = places.iter().take(MOST_REMARKS).map(one).collect();
    if places.len() > MOST_REMARKS {
        list.push("…".to_owned());
    }
    list.join("; ")
}

fn named(function: &UffFunction) -> &str {
    if function.name.is_empty() { "without a name" } else { &function.name }
}

/// Remarks over the rows of a function.
fn written_table(found: &[UffFunction], at: usize, remarks: &[String], skipped: &[Skipped]) -> String {
    let function = &found[at];
    let mut text = format!(
        "# universal file, function {} of {} (line {}): {}, response {}:{}, reference {}:{}\n",
        at + 1,
        found.len(),
        function.line,
        named(function),
        function.response.0,
        function.response.1,
        function.reference.0,
        function.reference.1,
    );
    for remark in remarks {
        text += &format!("# {remark}\n");
    }
    for Skipped { line, why } in skipped.iter().take(MOST_REMARKS) {
        text += &format!("# left out, line {line}: {}\n", why.english());
    }
    if skipped.len() > MOST_REMARKS {
        text += &format!("# left out: {} more\n", skipped.len() - MOST_REMARKS);
    }
    text
}

/// The table of a universal file that was pasted as text.
pub(crate) fn text_table(text: &str, columns: &'static [Field]) -> Result<String, Text> {
    chosen_table(text.as_bytes(), columns, None)
}

/// Remarks, and the rows under their heading of units.
fn rows(function: &UffFunction, columns: &'static [Field]) -> Result<(Vec<String>, String), Text> {
    let own: Vec<units::Unit> = columns
        .iter()
        .map(|column| match column.shape {
            Shape::Quantity(measure) => measure.own_unit(),
            _ => units::Unit::ONE,
        })
        .collect();
    let mut remarks = Vec::new();
    let polar = own.get(2).is_some_and(|unit| unit.dim == units::Dim::ANGLE);
    match columns.len() {
        2 => {
            if function.complex {
                remarks.push("the ordinates are complex: their amplitudes are given here".to_owned());
            }
        }
        3 if !function.complex => {
            return Err(Text::new(
                "the function is real; the table asks for real and imaginary part, or amplitude and phase",
            ));
        }
        3 => {}
        count => {
            return Err(Text::new("a function fills two or three columns; the table has {count}")
                .with("count", count));
        }
    }
    let abscissa = match (function.abscissa.kind, function.kind) {
        (17, _) | (0 | 1, 1) => "s",
        (19, _) => "rpm",
        _ => "Hz",
    };
    fits(abscissa, &own[0], columns[0].label)?;
    let (ordinate, guessed) = match ordinate(function) {
        Some(found) => found,
        None => (own[1].ascii().clone(), true),
    };
    fits(&ordinate, &own[1], columns[1].label)?;
    if guessed {
        remarks.push(format!("the file does not name its units: {ordinate} is assumed"));
    }
    let angle = if polar { "; [rad]".to_owned() } else { format!("; [{ordinate}]") };
    let heading =
        format!("[{abscissa}]; [{ordinate}]{}", if columns.len() == 3 { angle.as_str() } else { "" });
    let row = |[x, re, im]: &[f64; 3]| {
        let cells = match (columns.len(), polar) {
            (2, _) if function.complex => vec![*x, re.hypot(*im)],
            (2, _) => vec![*x, *re],
            (_, true) => vec![*x, re.hypot(*im), im.atan2(*re)],
            _ => vec![*x, *re, *im],
        };
        cells.into_iter().map(written).collect::<Vec<_>>().join("; ")
    };
    let rows: Vec<String> = std::iter::once(heading).chain(function.points.iter().map(row)).collect();
    Ok((remarks, rows.join("\n")))
}

/// A number that reads back as itself.
fn written(x: f64) -> String {
    if x == 0.0 || (1e-3..1e7).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

fn fits(unit: &str, own: &units::Unit, label: &'static str) -> Result<(), Text> {
    let why = Text::new("the function is in {unit}; the table asks for {column} in a unit like {own}");
    match units::unit(unit) {
        Ok(found) if found.dim.agrees(own.dim) => Ok(()),
        _ => Err(why.with("unit", unit).with_text("column", label).with("own", own.pretty())),
    }
}

/// The unit of the ordinate, and whether part of it is assumed; `None` where the file does not say what it is.
fn ordinate(function: &UffFunction) -> Option<(String, bool)> {
    let (top, top_assumed) = unit_of(&function.ordinate)?;
    let (below, below_assumed) = match function.denominator.kind {
        0 => ("1".to_owned(), false),
        _ => unit_of(&function.denominator)?,
    };
    let assumed = top_assumed || below_assumed;
    if below == "1" {
        return Some((top, assumed));
    }
    let in_brackets = |unit: String| if unit.contains(['/', '*', ' ']) { format!("({unit})") } else { unit };
    Some((format!("{}/{}", in_brackets(top), in_brackets(below)), assumed))
}

/// The unit of an axis: the one it names where that is one of its kind, else that of the SI.
fn unit_of(axis: &Characteristic) -> Option<(String, bool)> {
    let base = match axis.kind {
        2 | 15 => "Pa",
        3 => "1",
        8 => "m",
        9 | 13 => "N",
        11 => "m/s",
        12 => "m/s^2",
        16 => "kg",
        _ => return None,
    };
    // In acceleration, g is that of gravity and not the gram.
    let named = match (axis.kind, axis.unit.as_str()) {
        (12, "g" | "G") => "g0",
        (_, named) => named,
    };
    let of_its_kind = units::unit(named).is_ok_and(|named| {
        units::unit(base).is_ok_and(|base| named.dim.agrees(base.dim)) && named.dim != units::Dim::NONE
    });
    Some(if of_its_kind { (named.to_owned(), false) } else { (base.to_owned(), base != "1") })
}
