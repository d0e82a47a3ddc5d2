//! Units that the preamble of an instrument names.

use dalembert_core::Text;

/// Words of a line that names units, in English, German, Portuguese, French and Spanish.
const UNIT: [&str; 5] = ["unit", "einheit", "unidade", "unité", "unidad"];
/// Words for a unit that are not its symbol, as oscilloscopes write them.
const SYMBOLS: [(&str, &str); 8] = [
    ("volt", "V"),
    ("volts", "V"),
    ("ampere", "A"),
    ("amps", "A"),
    ("second", "s"),
    ("seconds", "s"),
    ("sec", "s"),
    ("hertz", "Hz"),
];

/// The unit of a column that none is named for: an empty cell would not count as one.
pub(crate) const NONE: &str = "[-]";

/// The units of all columns, as a heading.
#[derive(Debug, PartialEq)]
pub(crate) struct UnitsAbove {
    /// Index of the line that names the last of them.
    pub(crate) line: usize,
    /// `[s]`, `[mm]`, …; [`NONE`] where a column has none.
    pub(crate) units: Vec<String>,
}

/// Returns true if a line names units, by its first cell.
pub(crate) fn is_key(cells: &[String]) -> bool {
    let key = cells.first().map(|key| key.to_lowercase()).unwrap_or_default();
    cells.len() > 1 && UNIT.iter().any(|word| key.contains(word))
}

/// The units that lines of a preamble name, for so many columns: `Vertical Units,V`, `Y_Unit_Label  mm`, `Unit;s;mm`.
///
/// Error: units that cannot be assigned to the columns.
pub(crate) fn of(above: &[Vec<String>], width: usize) -> Result<Option<UnitsAbove>, Text> {
    let mut found: Option<UnitsAbove> = None;
    for (line, cells) in above.iter().enumerate() {
        let Some((key, values)) = cells.split_first().filter(|_| is_key(cells)) else { continue };
        let key = key.to_lowercase();
        let values: Vec<&String> = values
            .iter()
            .filter(|value| value.chars().any(|c| c.is_alphabetic() || "°%µ".contains(c)))
            .collect();
        if values.is_empty() {
            continue;
        }
        let known = found.get_or_insert_with(|| UnitsAbove { line, units: vec![NONE.to_owned(); width] });
        known.line = line;
        let first = |letter: char| key.starts_with(letter) && !key[1..].starts_with(char::is_alphabetic);
        let (is_first, is_other) =
            (key.contains("horizontal") || first('x'), key.contains("vertical") || first('y'));
        let places: Vec<usize> = match (is_first, is_other, values.len()) {
            (true, _, 1) => vec![0],
            (_, true, have) if have == 1 || have + 1 == width => (1..width).collect(),
            (false, false, have) if have == width => (0..width).collect(),
            // The key stands in the first column.
            (false, false, have) if have > 1 && have + 1 == width => (1..width).collect(),
            _ => {
                let why = Text::new(
                    "line {line} names a unit above the heading, but not of which column: write it into the heading, as in `x [mm]`, or leave the lines out, as in `#skip={line}`",
                );
                return Err(why.with("line", line + 1));
            }
        };
        for (n, place) in places.into_iter().enumerate() {
            known.units[place] = bracketed(values.get(n).unwrap_or(&values[0]));
        }
    }
    Ok(found)
}

/// A unit in brackets, by its symbol; without the channel before it, `CH1:mm`.
pub(crate) fn bracketed(unit: &str) -> String {
    let unit = unit.rsplit(':').next().unwrap_or_default().trim().trim_matches(['[', ']', '(', ')']);
    format!("[{}]", symbol(unit).unwrap_or(unit))
}

/// Symbol of a unit that is written as a word.
pub(crate) fn symbol(word: &str) -> Option<&'static str> {
    SYMBOLS.iter().find(|(known, _)| word.eq_ignore_ascii_case(known)).map(|(_, symbol)| *symbol)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_assigned_to_columns_by_their_key() {
        let cells = |text: &str| -> Vec<Vec<String>> {
            text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
        };
        let units =
            |text: &str, width: usize| of(&cells(text), width).map(|found| found.map(|all| all.units));
        for (text, wanted) in [
            ("Horizontal Units,S\nVertical Units,Volts", vec!["[S]", "[V]", "[V]"]),
            ("Vertical Units,mm,N", vec!["[-]", "[mm]", "[N]"]),
            ("Unit,s,mm,N", vec!["[s]", "[mm]", "[N]"]),
            ("Y_Unit_Label,mm,mm", vec!["[-]", "[mm]", "[mm]"]),
            ("Einheit,s,mm", vec!["[-]", "[s]", "[mm]"]),
            ("Vertical Units,CH1:mm", vec!["[-]", "[mm]", "[mm]"]),
        ] {
            let wanted: Vec<String> = wanted.into_iter().map(str::to_owned).collect();
            assert_eq!(units(text, 3), Ok(Some(wanted)), "{text}");
        }
        assert_eq!(units("Model,DS1\nUnits per division,2", 3), Ok(None));
        assert!(units("Unit,mm", 3).is_err());
    }
}
