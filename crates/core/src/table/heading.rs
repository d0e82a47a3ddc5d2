//! The units that the lines above the rows of a table name.
//!
//! `t [ms]`, `t (ms)`, `t / ms`, `t in ms`, `t_ms`, `time ms`, and a line of units alone. A letter such as `m` or `t`
//! is as often the symbol of a quantity as a unit: outside brackets a unit counts where its dimension is that of the
//! column. A unit that does not is reported, so that no column is read in a unit other than the one that stands above it.

use std::borrow::Cow;

use dalembert_units::{self as units, Unit};

use super::{Separator, measure, own_unit, takes};
use crate::{Field, Text, reading};

/// Units that are words or common subscripts too: `x_min`, `centre of the bar`, the angle psi, `x_cg`, `second mass`.
const ALSO_WORDS: [&str; 49] = [
    "in",
    "min",
    "bar",
    "day",
    "days",
    "turn",
    "turns",
    "cycle",
    "cycles",
    "rev",
    "revs",
    "rot",
    "foot",
    "feet",
    "mil",
    "thou",
    "pol",
    "cal",
    "psi",
    "gs",
    "gn",
    "cg",
    "dm",
    "dg",
    "dN",
    "hN",
    "hm",
    "hs",
    "pm",
    "ps",
    "kp",
    "kt",
    "cv",
    "um",
    "st",
    "cd",
    "volta",
    "voltas",
    "ciclo",
    "ciclos",
    "revolution",
    "revolutions",
    "pound",
    "nós",
    "second",
    "segundo",
    "minute",
    "minuto",
    "dia",
];
/// Words between a quantity and its unit, in English, Portuguese and Spanish.
const IN: [&str; 3] = ["in", "em", "en"];

/// A line above the rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heading<'t> {
    /// Line number, from 1.
    pub(super) line: usize,
    /// Text of the line.
    pub(super) text: &'t str,
    /// True for a comment, of which only units are read.
    pub(super) comment: bool,
}

/// Finds the units of the columns. `rows` is what sets the cells of the rows apart.
pub(super) fn read(
    headings: &[Heading<'_>],
    rows: Separator,
    columns: &'static [Field],
    found: &mut [Option<Unit>],
    faults: &mut Vec<Text>,
) {
    for heading in headings.iter().filter(|heading| !heading.comment) {
        match cells(heading.text, rows, columns.len()) {
            Some(cells) => {
                for ((cell, column), place) in cells.iter().zip(columns).zip(found.iter_mut()) {
                    match (of_cell(cell, column), &place) {
                        (Ok(Some(unit)), Some(known)) if unit.factor != known.factor => {
                            let why = Text::new(
                                "line {line}: the unit of {column} is {known} above and {unit} here",
                            );
                            let why = why.with("line", heading.line).with_text("column", column.label);
                            faults.push(why.with("known", known.pretty()).with("unit", unit.pretty()));
                        }
                        (Ok(Some(unit)), None) => *place = Some(unit),
                        (Ok(_), _) => {}
                        (Err(why), _) => faults.push(why),
                    }
                }
            }
            None => in_brackets_alone(heading.text, columns, found, faults),
        }
    }
    // A comment of words just above the rows is what numpy writes its heading as.
    if let Some(comment) = headings.last().filter(|heading| heading.comment)
        && let Some(cells) = cells(comment.text, rows, columns.len())
        && !cells.iter().any(|cell| cell.starts_with(|c: char| c.is_ascii_digit()))
    {
        let units: Vec<_> = cells.iter().zip(columns).map(|(cell, column)| of_cell(cell, column)).collect();
        if units.iter().all(Result::is_ok) {
            for (unit, place) in units.into_iter().flatten().zip(found) {
                *place = place.take().or(unit);
            }
        }
    }
}

/// Returns true if a line consists of units alone, where columns without one may have a dash or a one.
pub(super) fn is_of_units(cells: &[Cow<'_, str>], columns: &'static [Field]) -> bool {
    let fits = |(cell, column): (&Cow<'_, str>, &Field)| fitting(unbracketed(cell), column).is_some();
    cells.len() == columns.len()
        && cells.iter().zip(columns).all(|both| is_dash(both.0) || fits(both))
        && cells.iter().any(|cell| !is_dash(cell))
}

fn is_dash(cell: &str) -> bool {
    matches!(unbracketed(cell), "" | "-" | "–" | "—" | "1")
}

/// A line that does not part into the columns: its brackets in their order.
fn in_brackets_alone(
    text: &str,
    columns: &'static [Field],
    found: &mut [Option<Unit>],
    faults: &mut Vec<Text>,
) {
    let brackets = bracketed(text);
    for ((text, column), place) in brackets.iter().zip(columns).zip(found) {
        match stated(text, column) {
            Ok(unit) => *place = unit,
            Err(why) => faults.push(why),
        }
    }
    if brackets.is_empty()
        && let Some(word) = words(text).find(is_unit_word)
    {
        let why =
            Text::new("the heading contains {word} but has not one cell per column: write one such as {own}");
        let own: Vec<String> =
            columns.iter().map(|column| format!("[{}]", own_unit(column).ascii())).collect();
        faults.push(why.with("word", word).with("own", own.join("; ")));
    }
}

/// The unit that the heading of a column names.
fn of_cell(cell: &str, column: &'static Field) -> Result<Option<Unit>, Text> {
    if cell.contains('[')
        && let Some(text) = bracketed(cell).pop()
    {
        return stated(text, column);
    }
    if let Some(unit) = fitting(unbracketed(cell), column) {
        return Ok(Some(unit));
    }
    let after_slash = after_slash(cell);
    let after_in = after_in(cell);
    let round = bracketed(cell).pop();
    for text in [after_slash, after_in, round].into_iter().flatten() {
        if let Some(unit) = fitting(text, column) {
            return used(cell, text, unit, column);
        }
    }
    if let Some(text) = round {
        return stated(text, column);
    }
    for text in [after_in, after_slash].into_iter().flatten() {
        if units::unit(text).is_ok() {
            return Err(unfit(text, column));
        }
    }
    let after_underscores = cell.match_indices('_').map(|(at, _)| &cell[at + 1..]);
    let last_word = cell.split_whitespace().next_back();
    for text in after_underscores.chain(last_word) {
        if let Some(unit) = fitting(text, column) {
            return used(cell, text, unit, column);
        }
    }
    match words(cell).find(is_unit_word) {
        Some(word) => Err(unfit(word, column)),
        None => written_otherwise(cell, column),
    }
}

/// The unit, unless another unit stands in the cell beside it.
fn used(cell: &str, text: &str, unit: Unit, column: &'static Field) -> Result<Option<Unit>, Text> {
    let at = text.as_ptr() as usize - cell.as_ptr() as usize;
    let rest = [&cell[..at], &cell[at + text.len()..]];
    match rest.into_iter().flat_map(words).find(is_unit_word) {
        Some(word) => Err(unfit(word, column)),
        None => Ok(Some(unit)),
    }
}

/// A unit in brackets, which can mean nothing else.
fn stated(text: &str, column: &'static Field) -> Result<Option<Unit>, Text> {
    if matches!(text.trim(), "" | "-" | "–" | "—") {
        return Ok(None);
    }
    match units::unit(text) {
        Ok(unit) if takes(column, |dim| unit.dim.agrees(dim)) => Ok(Some(unit)),
        Ok(_) => Err(match (own_unit(column).pretty(), reading::unit_hint(text, own_unit(column).dim)) {
            (_, Some(hint)) => {
                Text::new("the heading gives {unit} for {column}; {hint}").with_text("hint", hint)
            }
            (own, None) if own.is_empty() => {
                Text::new("the heading gives {unit} for {column}, which has no unit")
            }
            (own, None) => {
                Text::new("the heading gives {unit} for {column}; write a unit like {own}").with("own", own)
            }
        }
        .with("unit", text)
        .with_text("column", column.label)),
        Err(err) => Err(reading::text(&err)),
    }
}

fn unfit(word: &str, column: &'static Field) -> Text {
    let why = Text::new(
        "the heading of {column} contains {word}, not recognised as its unit: write the unit in brackets, such as [{own}]",
    );
    let own = match units::meant_unit(word, own_unit(column).dim) {
        Some(units::Hint::Namesake(_, unit)) => unit,
        _ => own_unit(column).ascii(),
    };
    let own = if own.is_empty() { "1".to_owned() } else { own };
    why.with("word", word).with("own", own).with_text("column", column.label)
}

/// `hz` and `MM` are no units, but were meant as one.
fn written_otherwise(cell: &str, column: &'static Field) -> Result<Option<Unit>, Text> {
    let usual = measure(column).map(|measure| measure.units()).unwrap_or_default();
    for word in words(cell).filter(|word| word.len() > 1) {
        let meant = usual.iter().find(|unit| unit.len() > 1 && unit.to_lowercase() == word.to_lowercase());
        if let Some(meant) = meant {
            let why = Text::new("the heading of {column} contains {word}: did you mean [{meant}]?");
            return Err(why.with("word", word).with("meant", meant).with_text("column", column.label));
        }
    }
    Ok(None)
}

/// The unit of a text that has the dimension of the column, angle included: `r` above ratios is no revolution.
fn fitting(text: &str, column: &Field) -> Option<Unit> {
    let text = text.trim();
    if text.is_empty() || text.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    units::unit(text).ok().filter(|unit| takes(column, |dim| dim == unit.dim))
}

/// Text after the first slash outside brackets: `t / ms`, `H / (m/N)`.
fn after_slash(cell: &str) -> Option<&str> {
    let mut depth = 0i32;
    for (at, c) in cell.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            '/' if depth == 0 && !cell[..at].trim().is_empty() => return Some(unbracketed(&cell[at + 1..])),
            _ => {}
        }
    }
    None
}

fn after_in(cell: &str) -> Option<&str> {
    let mut words = cell.split_whitespace().skip(1);
    let word = words.find(|word| IN.contains(word))?;
    let after = word.as_ptr() as usize - cell.as_ptr() as usize + word.len();
    Some(unbracketed(&cell[after..])).filter(|rest| !rest.is_empty())
}

fn unbracketed(text: &str) -> &str {
    let text = text.trim();
    let inside = |open, close| text.strip_prefix(open).and_then(|text| text.strip_suffix(close));
    inside('(', ')')
        .or_else(|| inside('[', ']'))
        .filter(|text| !text.contains(['(', ')']))
        .unwrap_or(text)
        .trim()
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphabetic() || matches!(c, '°' | '%' | '\'')))
        .filter(|word| !word.is_empty())
}

/// Returns true if a word can hardly be anything but a unit.
fn is_unit_word(word: &&str) -> bool {
    word.chars().count() > 1 && !ALSO_WORDS.contains(word) && units::unit(word).is_ok()
}

/// The cells of a heading, where there are as many as columns: set apart as the rows are, or otherwise.
fn cells(line: &str, rows: Separator, columns: usize) -> Option<Vec<Cow<'_, str>>> {
    let ways = [rows, Separator::Semicolon, Separator::Tab, Separator::Comma];
    let same = |cells: &Vec<Cow<'_, str>>| cells.len() == columns;
    ways.into_iter()
        .filter(|way| *way != Separator::Blank)
        .map(|way| way.split(line))
        .find(same)
        .or_else(|| Some(wide(line)).filter(same))
        .or_else(|| Some(Separator::Blank.split(line)).filter(same))
        .or_else(|| Some(joined(line)).filter(same))
}

/// Cells with two blanks or more between them.
fn wide(line: &str) -> Vec<Cow<'_, str>> {
    line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(Cow::from).collect()
}

/// Words with blanks between them, where a slash, a bracket and the word before a unit join: `t / ms x / mm`,
/// `t (ms) x (mm)`, `t in ms x in mm`.
fn joined(line: &str) -> Vec<Cow<'_, str>> {
    let mut cells: Vec<String> = Vec::new();
    let mut open = false;
    for word in line.split_whitespace() {
        let joins = open || word.starts_with(['/', '(', '[']) || IN.contains(&word);
        match cells.last_mut() {
            Some(cell) if joins => {
                cell.push(' ');
                cell.push_str(word);
            }
            _ => cells.push(word.to_owned()),
        }
        let last = cells.last().map_or("", String::as_str);
        let unclosed = |open, close| last.matches(open).count() > last.matches(close).count();
        open = last.ends_with('/') || IN.contains(&word) || unclosed('(', ')') || unclosed('[', ']');
    }
    cells.into_iter().map(Cow::from).collect()
}

/// Texts in square brackets, or in round ones if there are no square ones: `Re (H) [m/(N*s)]` has one unit.
fn bracketed(text: &str) -> Vec<&str> {
    let (open, close) = if text.contains('[') { ('[', ']') } else { ('(', ')') };
    let (mut found, mut depth, mut start) = (Vec::new(), 0usize, 0);
    for (at, c) in text.char_indices() {
        if c == open {
            if depth == 0 {
                start = at + 1;
            }
            depth += 1;
        } else if c == close && depth > 0 {
            depth -= 1;
            if depth == 0 {
                found.push(&text[start..at]);
            }
        }
    }
    found
}
