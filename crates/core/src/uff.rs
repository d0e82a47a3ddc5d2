//! Universal files: functions of a degree of freedom, dataset 58, in text and in binary (58b).
//!
//! A universal file is made of datasets, each between two lines that hold `-1`; the first line inside is the number
//! of the dataset. Dataset 58 has eleven records of text in columns, then the values. In 58b the values follow as
//! bytes, in the order of the text form, with little or big ends first. The format is that of SDRC, kept by the
//! Structural Dynamics Research Laboratory of the University of Cincinnati.

mod table;
#[cfg(test)]
mod tests;

pub(crate) use table::text_table;
pub use table::{UniversalError, table};

use crate::Text;

/// The most points of a function.
const MOST_POINTS: usize = 1 << 24;

/// A function of a degree of freedom: a frequency response, a time history.
#[derive(Clone, Debug, PartialEq)]
pub struct UffFunction {
    /// The line its dataset begins in, counted from 1; lines end where a line feed stands, in bytes too.
    pub line: usize,
    /// First identification line.
    pub name: String,
    /// The kind of function: 1 time response, 4 frequency response, …
    pub kind: i64,
    /// Node and direction of the response, ±1 … ±3 along and ±4 … ±6 about x, y and z.
    pub response: (i64, i64),
    /// Node and direction of the reference.
    pub reference: (i64, i64),
    /// Quantity of the abscissa.
    pub abscissa: Characteristic,
    /// Quantity of the ordinate, or of its numerator.
    pub ordinate: Characteristic,
    /// Quantity of the denominator of the ordinate.
    pub denominator: Characteristic,
    /// True if the ordinates have an imaginary part.
    pub complex: bool,
    /// Abscissa, real and imaginary part.
    pub points: Vec<[f64; 3]>,
}

/// Quantity of an axis.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Characteristic {
    /// 0 unknown, 8 displacement, 9 excitation force, 11 velocity, 12 acceleration, 13 reaction force, 17 time,
    /// 18 frequency, 19 rpm, …
    pub kind: i64,
    /// The label of its unit; may be empty or `NONE`.
    pub unit: String,
}

/// Skipped part of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Skipped {
    /// The line, counted from 1.
    pub line: usize,
    /// Reason for skipping it.
    pub why: Text,
}

/// Returns true if bytes begin as a universal file: a line that holds `-1`, then the number of a dataset.
pub fn is_universal(bytes: &[u8]) -> bool {
    let mut lines = Lines { bytes, at: 0, number: 0 };
    let mut line = lines.next();
    while line.is_some_and(|line| text(line).trim().is_empty()) {
        line = lines.next();
    }
    line.is_some_and(|line| text(line).trim_start_matches('\u{FEFF}').trim() == "-1")
        && lines.next().is_some_and(|line| dataset(&text(line)).is_some())
}

/// The functions of a universal file, and everything else in it with the reason why it is left out.
pub fn functions(bytes: &[u8]) -> (Vec<UffFunction>, Vec<Skipped>) {
    let (mut found, mut skipped) = (Vec::new(), Vec::new());
    let mut lines = Lines { bytes, at: 0, number: 0 };
    while let Some(line) = lines.next() {
        let opening = text(line);
        if opening.trim().is_empty() {
            continue;
        }
        let begin = lines.number;
        if opening.trim_start_matches('\u{FEFF}').trim() != "-1" {
            skipped.push(Skipped { line: begin, why: Text::new("is between datasets") });
            continue;
        }
        let Some(header) = lines.next().map(text) else {
            skipped.push(Skipped { line: begin, why: Text::new("a dataset begins and the file ends") });
            break;
        };
        let read = match dataset(&header) {
            Some(58) => function(&header, &mut lines, begin),
            Some(number) => Err(Skipped {
                line: begin,
                why: Text::new("dataset {number} is not a function").with("number", number),
            }),
            None => Err(Skipped { line: begin + 1, why: Text::new("not a dataset number") }),
        };
        match read {
            Ok(function) => found.push(function),
            Err(why) => {
                skipped.push(why);
                lines.leave_dataset();
            }
        }
    }
    (found, skipped)
}

/// The lines of a file, its bytes included.
struct Lines<'b> {
    bytes: &'b [u8],
    at: usize,
    /// The number of the last line given.
    number: usize,
}

impl<'b> Lines<'b> {
    fn next(&mut self) -> Option<&'b [u8]> {
        let rest = self.bytes.get(self.at..).filter(|rest| !rest.is_empty())?;
        let end = rest.iter().position(|byte| *byte == b'\n');
        self.at += end.map_or(rest.len(), |end| end + 1);
        self.number += 1;
        let line = &rest[..end.unwrap_or(rest.len())];
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }

    /// The bytes that follow, so many of them.
    fn take(&mut self, count: usize) -> Option<&'b [u8]> {
        let taken = self.bytes.get(self.at..)?.get(..count)?;
        self.at += count;
        self.number += taken.split(|byte| *byte == b'\n').count() - 1;
        Some(taken)
    }

    /// Returns true if the end of the dataset follows after so many bytes: `-1` in its columns, on this line or the
    /// next.
    fn ends_after(&self, count: usize) -> bool {
        let rest = self.bytes.get(self.at..).and_then(|rest| rest.get(count..)).unwrap_or_default();
        let rest = rest.strip_prefix(b"\r").unwrap_or(rest);
        rest.strip_prefix(b"\n").unwrap_or(rest).starts_with(b"    -1")
    }

    /// Goes on behind the line that ends the dataset, or behind the last line.
    fn leave_dataset(&mut self) {
        while let Some(line) = self.next() {
            // Behind bytes the mark may stand at the end of a longer line.
            if line == b"-1" || line.ends_with(b"    -1") || text(line).trim() == "-1" {
                return;
            }
        }
    }
}

fn text(line: &[u8]) -> String {
    String::from_utf8_lossy(line).into_owned()
}

/// The number of a dataset, from its first six columns.
fn dataset(header: &str) -> Option<i64> {
    column(header, 0, 6).trim().parse().ok().filter(|number| *number > 0)
}

/// Columns of a line, counted from 0; empty beyond its end.
fn column(line: &str, from: usize, width: usize) -> String {
    line.chars().skip(from).take(width).collect()
}

fn integer(line: &str, from: usize, width: usize) -> Option<i64> {
    let text = column(line, from, width);
    if text.trim().is_empty() { Some(0) } else { text.trim().parse().ok() }
}

/// A number as Fortran writes it: `1.5E+00`, `1.5D+00`.
fn number(text: &str) -> Option<f64> {
    text.trim().replace(['D', 'd'], "E").parse().ok()
}

fn characteristic(line: &str) -> Characteristic {
    Characteristic {
        kind: integer(line, 0, 10).unwrap_or(0),
        unit: column(line, 47, 21).trim().trim_matches('\0').to_owned(),
    }
}

/// Layout of the values of a dataset.
struct Layout {
    count: usize,
    complex: bool,
    double: bool,
    even: bool,
    start: f64,
    step: f64,
}

/// Reads dataset 58 up to and with its end.
fn function(header: &str, lines: &mut Lines<'_>, begin: usize) -> Result<UffFunction, Skipped> {
    let fail = |line: usize, why: Text| Err(Skipped { line, why });
    let mut records: Vec<String> = Vec::with_capacity(11);
    while records.len() < 11 {
        match lines.next() {
            Some(line) if text(line).trim() != "-1" => records.push(text(line)),
            _ => return fail(begin, Text::new("the function ends before its values")),
        }
    }
    let kind = &records[5];
    let form = &records[6];
    let words: Vec<&str> = form.split_whitespace().collect();
    let whole =
        |at: usize| integer(form, 10 * at, 10).or_else(|| words.get(at).and_then(|word| word.parse().ok()));
    let real = |at: usize| {
        number(&column(form, 30 + 13 * (at - 3), 13)).or_else(|| words.get(at).and_then(|word| number(word)))
    };
    let (Some(ordinates), Some(count), Some(spacing)) = (whole(0), whole(1), whole(2)) else {
        return fail(begin + 8, Text::new("the form of the values cannot be read"));
    };
    let layout = Layout {
        count: usize::try_from(count).unwrap_or(usize::MAX),
        complex: matches!(ordinates, 5 | 6),
        double: matches!(ordinates, 4 | 6),
        even: spacing == 1,
        start: real(3).unwrap_or(0.0),
        step: real(4).unwrap_or(0.0),
    };
    if !matches!(ordinates, 2 | 4 | 5 | 6) {
        let why = Text::new("values of type {found} are not read; types 2, 4, 5 and 6 are");
        return fail(begin + 8, why.with("found", ordinates));
    }
    if layout.count == 0 || layout.count > MOST_POINTS {
        let why = Text::new("{count} points are announced; 1 to {most} are read");
        return fail(begin + 8, why.with("count", count).with("most", MOST_POINTS));
    }
    if layout.even && (layout.step == 0.0 || !layout.step.is_finite()) && layout.count > 1 {
        return fail(begin + 8, Text::new("the abscissas are evenly spaced without a step"));
    }
    let values = if column(header, 6, 1).eq_ignore_ascii_case("b") {
        binary(header, &layout, lines, begin)?
    } else {
        written(&layout, lines, begin)?
    };
    let width = layout.width();
    let point = |(n, values): (usize, &[f64])| {
        let (abscissa, ordinate) = if layout.even {
            (layout.start + n as f64 * layout.step, values)
        } else {
            (values[0], &values[1..])
        };
        [abscissa, ordinate[0], if layout.complex { ordinate[1] } else { 0.0 }]
    };
    let points: Vec<[f64; 3]> = values.chunks_exact(width).enumerate().map(point).collect();
    if let Some(n) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
        return fail(begin, Text::new("point {n} of the function is not finite").with("n", n + 1));
    }
    Ok(UffFunction {
        line: begin,
        name: records[0].trim().to_owned(),
        kind: integer(kind, 0, 5).unwrap_or(0),
        response: (integer(kind, 41, 10).unwrap_or(0), integer(kind, 51, 4).unwrap_or(0)),
        reference: (integer(kind, 66, 10).unwrap_or(0), integer(kind, 76, 4).unwrap_or(0)),
        abscissa: characteristic(&records[7]),
        ordinate: characteristic(&records[8]),
        denominator: characteristic(&records[9]),
        complex: layout.complex,
        points,
    })
}

impl Layout {
    /// Numbers of one point.
    fn width(&self) -> usize {
        usize::from(!self.even) + if self.complex { 2 } else { 1 }
    }

    /// The widths in columns of the numbers of one point.
    fn columns(&self) -> Vec<usize> {
        let ordinate = if self.double { 20 } else { 13 };
        let mut columns = vec![ordinate; self.width()];
        if !self.even {
            // The abscissa is a single one even where the ordinates are double.
            columns[0] = 13;
        }
        columns
    }
}

/// The values as text.
fn written(layout: &Layout, lines: &mut Lines<'_>, begin: usize) -> Result<Vec<f64>, Skipped> {
    let wanted = layout.count * layout.width();
    let columns = layout.columns();
    let mut values = Vec::with_capacity(wanted.min(lines.bytes.len()));
    loop {
        let Some(line) = lines.next().map(text) else {
            return Err(Skipped { line: begin, why: Text::new("the file ends within the function") });
        };
        if line.trim() == "-1" {
            break;
        }
        if line.trim().is_empty() {
            continue;
        }
        // Blanks part numbers, where they do; else the columns of the format.
        let by_blanks: Option<Vec<f64>> = line.split_whitespace().map(number).collect();
        let read = by_blanks.or_else(|| by_columns(&line, &columns, values.len()));
        let Some(read) = read else {
            let wrong = line.split_whitespace().find(|word| number(word).is_none()).unwrap_or(line.trim());
            let why = Text::new("`{cell}` is not a number").with("cell", column(wrong, 0, 20));
            return Err(Skipped { line: lines.number, why });
        };
        values.extend(read);
    }
    if values.len() < wanted {
        let why = Text::new("the function has {have} numbers; its header announces {wanted}");
        return Err(Skipped { line: begin, why: why.with("have", values.len()).with("wanted", wanted) });
    }
    values.truncate(wanted);
    Ok(values)
}

/// Numbers in the columns of the format, of which so many stood in earlier lines.
fn by_columns(line: &str, columns: &[usize], before: usize) -> Option<Vec<f64>> {
    let line = line.trim_end();
    let length = line.chars().count();
    let (mut at, mut numbers) = (0, Vec::new());
    while at < length {
        let width = columns[(before + numbers.len()) % columns.len()];
        numbers.push(number(&column(line, at, width))?);
        at += width;
    }
    Some(numbers)
}

/// The values as bytes.
fn binary(header: &str, layout: &Layout, lines: &mut Lines<'_>, begin: usize) -> Result<Vec<f64>, Skipped> {
    let fail = |why: Text| Err(Skipped { line: begin + 1, why });
    let words: Vec<i64> =
        column(header, 7, 73).split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let (order, format) = (words.first().copied().unwrap_or(1), words.get(1).copied().unwrap_or(2));
    if !matches!(order, 1 | 2) {
        return fail(Text::new("byte order {order} is not read; 1 and 2 are").with("order", order));
    }
    if format != 2 {
        let why =
            Text::new("floating-point format {format} is not read; write the file in format 2, IEEE 754");
        return fail(why.with("format", format));
    }
    let size = if layout.double { 8 } else { 4 };
    let width = layout.width();
    let all = layout.count * width * size;
    // By the letter of the format the abscissa is single where the ordinates are double; most programs write it
    // double. What is there tells which it is.
    let mixed = layout.count * (4 + (width - 1) * size);
    let sizes = if !layout.even && layout.double { vec![all, mixed] } else { vec![all] };
    let announced = words.get(3).copied().and_then(|bytes| usize::try_from(bytes).ok());
    let found = sizes
        .iter()
        .copied()
        .find(|size| lines.ends_after(*size))
        .or_else(|| sizes.iter().copied().find(|size| Some(*size) == announced));
    let Some(length) = found else {
        return fail(Text::new("the function has too few bytes for its points"));
    };
    let Some(bytes) = lines.take(length) else {
        return fail(Text::new("the file ends within the function"));
    };
    let little = order == 1;
    let single = |bytes: &[u8]| {
        let bytes: [u8; 4] = bytes.try_into().unwrap_or_default();
        f64::from(if little { f32::from_le_bytes(bytes) } else { f32::from_be_bytes(bytes) })
    };
    let double = |bytes: &[u8]| {
        let bytes: [u8; 8] = bytes.try_into().unwrap_or_default();
        if little { f64::from_le_bytes(bytes) } else { f64::from_be_bytes(bytes) }
    };
    let values = if length == mixed && length != all {
        bytes
            .chunks_exact(4 + (width - 1) * size)
            .flat_map(|point| {
                std::iter::once(single(&point[..4])).chain(point[4..].chunks_exact(8).map(double))
            })
            .collect()
    } else if layout.double {
        bytes.chunks_exact(8).map(double).collect()
    } else {
        bytes.chunks_exact(4).map(single).collect()
    };
    // The mark of the end follows at once, or on a line of its own.
    while let Some(line) = lines.next() {
        let line = text(line);
        if line.trim() == "-1" {
            return Ok(values);
        }
        if !line.trim().is_empty() {
            break;
        }
    }
    fail(Text::new("end of dataset missing after its bytes"))
}
