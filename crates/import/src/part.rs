//! Parts of a file, behind the `#` of its name.

use dalembert_core::Text;

/// Word before a number of lines.
const SKIP: &str = "skip=";

/// A part of a file: `skip=12`, `1,3`, `1,3,skip=12`, `Data!A:C`, the name of a variable or of a function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Part {
    /// Lines at the beginning that are left out.
    pub(crate) skip: usize,
    /// All else.
    pub(crate) choice: String,
}

impl Part {
    /// Reads what stands behind `#`.
    ///
    /// Error: what stands behind `skip=` is not a number of lines.
    pub(crate) fn read(text: &str) -> Result<Self, Text> {
        let mut part = Self::default();
        let mut others = Vec::new();
        for item in text.split(',') {
            match item.trim().strip_prefix(SKIP) {
                Some(lines) => {
                    part.skip = lines.trim().parse().map_err(|_| {
                        Text::new("`skip={lines}` is not a number of lines: write one, as in `#skip=12` or `#1,3,skip=12`")
                            .with("lines", lines)
                    })?;
                }
                None => others.push(item),
            }
        }
        others.join(",").trim().clone_into(&mut part.choice);
        Ok(part)
    }

    /// Numbers from 1 on; none where nothing is chosen.
    ///
    /// Error: what is no such number.
    pub(crate) fn numbers(&self) -> Result<Vec<usize>, Text> {
        self.items().map(number).collect()
    }

    /// Items set apart by commas.
    pub(crate) fn items(&self) -> impl Iterator<Item = &str> {
        self.choice.split(',').map(str::trim).filter(|item| !item.is_empty())
    }

    /// Error: lines are to be skipped in a file without lines.
    pub(crate) fn without_skip(self) -> Result<Self, Text> {
        match self.skip {
            0 => Ok(self),
            _ => Err("`skip=` counts the lines of text and the rows of spreadsheets; this file has none: leave it out"
                .into()),
        }
    }
}

/// A number behind `#`, counted from 1.
pub(crate) fn number(text: &str) -> Result<usize, Text> {
    let number = text.trim().parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| {
        Text::new("`#{part}`: write a number from 1 on, as in `#2` or `#1,3`").with("part", text)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_to_skip_stand_beside_any_choice() {
        for (text, skip, choice) in [
            ("1,3", 0, "1,3"),
            ("skip=12", 12, ""),
            ("1,3, skip=2", 2, "1,3"),
            ("skip=1,Data!A,C", 1, "Data!A,C"),
        ] {
            assert_eq!(Part::read(text), Ok(Part { skip, choice: choice.to_owned() }), "{text}");
        }
        for wrong in ["skip=", "skip=-1", "skip=two"] {
            assert!(Part::read(wrong).is_err(), "{wrong}");
        }
        assert_eq!(Part::read("1, 3,skip=2").and_then(|part| part.numbers()), Ok(vec![1, 3]));
        assert!(Part::read("0").and_then(|part| part.numbers()).is_err());
    }
}
