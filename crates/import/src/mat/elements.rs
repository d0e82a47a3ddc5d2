//! The elements of a MAT-file: version 5 of the format, as "MAT-File Format" of The MathWorks describes it.
//!
//! A header of 128 bytes, then elements: type and length in 4 bytes each, or in 2 and 2 with up to 4 bytes of data behind
//! them; data are padded to 8 bytes. A variable is an element of type 14, matrix, or one of type 15 that contains it
//! compressed by zlib. A matrix consists of elements: flags with its class, dimensions, name, real and imaginary part, the
//! numbers column after column and each part in the smallest type that holds it. A structure has the length of its field
//! names, the names, and a matrix for each.

use std::io::Read as _;

use dalembert_core::Text;
use flate2::read::ZlibDecoder;

const HEADER: usize = 128;
/// The most bytes of a variable once it is decompressed.
const MOST_BYTES: u64 = 1 << 28;
/// The deepest structure within structures.
const DEEPEST: usize = 8;
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Bit of the flags of complex numbers.
const COMPLEX: u32 = 0x800;

/// A variable, or a field of a structure as `run.t`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Variable {
    pub(super) name: String,
    pub(super) content: Content,
}

/// Content of a variable.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Content {
    /// Real numbers, column after column.
    Numbers { rows: usize, columns: usize, numbers: Vec<f64> },
    /// Something else, by a word for it.
    Other(&'static str),
}

/// Bytes in the order of the file.
#[derive(Clone, Copy)]
struct Bytes<'b> {
    rest: &'b [u8],
    little: bool,
}

/// Type and data of an element.
struct Element<'b> {
    kind: u32,
    data: Bytes<'b>,
}

impl<'b> Bytes<'b> {
    fn take(&mut self, count: usize) -> Option<&'b [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        Some(taken)
    }

    fn word(&mut self) -> Option<u32> {
        let bytes: [u8; 4] = self.take(4)?.try_into().ok()?;
        Some(if self.little { u32::from_le_bytes(bytes) } else { u32::from_be_bytes(bytes) })
    }

    /// The next element; compressed ones are not padded.
    fn element(&mut self) -> Option<Element<'b>> {
        let first = self.word()?;
        let (kind, data) = if first >> 16 == 0 {
            let length = usize::try_from(self.word()?).ok()?;
            let data = self.take(length)?;
            if first != COMPRESSED {
                // The last one may end without its padding.
                let padding = (length.next_multiple_of(8) - length).min(self.rest.len());
                self.take(padding)?;
            }
            (first, data)
        } else {
            let length = usize::try_from(first >> 16).ok().filter(|length| *length <= 4)?;
            (first & 0xFFFF, &self.take(4)?[..length])
        };
        Some(Element { kind, data: Bytes { rest: data, little: self.little } })
    }

    /// The numbers of an element of this type.
    fn numbers(self, kind: u32) -> Option<Vec<f64>> {
        macro_rules! each {
            ($number:ty, $to:expr) => {
                self.rest
                    .chunks_exact(size_of::<$number>())
                    .map(|bytes| {
                        let bytes = bytes.try_into().ok()?;
                        let number = if self.little {
                            <$number>::from_le_bytes(bytes)
                        } else {
                            <$number>::from_be_bytes(bytes)
                        };
                        Some($to(number))
                    })
                    .collect()
            };
        }
        match kind {
            1 => each!(i8, f64::from),
            2 => each!(u8, f64::from),
            3 => each!(i16, f64::from),
            4 => each!(u16, f64::from),
            5 => each!(i32, f64::from),
            6 => each!(u32, f64::from),
            7 => each!(f32, f64::from),
            9 => each!(f64, f64::from),
            12 => each!(i64, |number: i64| number as f64),
            13 => each!(u64, |number: u64| number as f64),
            _ => None,
        }
    }
}

/// The variables of a file, fields of its structures among them.
///
/// Errors: a file that ends within a variable, or is not as the format asks for; a variable that is too large.
pub(super) fn variables(bytes: &[u8]) -> Result<Vec<Variable>, Text> {
    let broken = || Text::from("this MAT-file is damaged or cut off: save it again");
    let mark = bytes.get(HEADER - 2..HEADER).ok_or_else(broken)?;
    let mut file = Bytes { rest: &bytes[HEADER..], little: mark == b"IM" };
    let mut found = Vec::new();
    while !file.rest.is_empty() {
        let element = file.element().ok_or_else(broken)?;
        match element.kind {
            MATRIX => matrix(element.data, None, 0, &mut found).ok_or_else(broken)?,
            COMPRESSED => {
                let mut inflated = Vec::new();
                let mut decoder = ZlibDecoder::new(element.data.rest).take(MOST_BYTES + 1);
                decoder.read_to_end(&mut inflated).map_err(|_| broken())?;
                if inflated.len() as u64 > MOST_BYTES {
                    return Err(Text::new(
                        "a variable of this MAT-file has more than {most} bytes: save a part of it",
                    )
                    .with("most", MOST_BYTES));
                }
                let inner = Bytes { rest: &inflated, little: file.little }.element().ok_or_else(broken)?;
                matrix(inner.data, None, 0, &mut found).ok_or_else(broken)?;
            }
            _ => {}
        }
    }
    Ok(found)
}

/// Adds the variable of a matrix, or the fields of a structure; `None` where the format is another.
fn matrix(
    mut bytes: Bytes<'_>,
    field: Option<String>,
    depth: usize,
    found: &mut Vec<Variable>,
) -> Option<()> {
    if bytes.rest.is_empty() {
        // A field without a value.
        return Some(());
    }
    let flags = bytes.element()?.data.word()?;
    let class = flags & 0xFF;
    let mut sizes = Vec::new();
    // An object has no dimensions.
    if class != 17 {
        let element = bytes.element()?;
        sizes = element.data.numbers(element.kind)?;
    }
    let own = String::from_utf8_lossy(bytes.element()?.data.rest).into_owned();
    let name = field.unwrap_or(own);
    let is_matrix = sizes.len() == 2;
    let content = match class {
        2 if depth < DEEPEST && sizes == [1.0, 1.0] => return structure(bytes, &name, depth, found),
        6..=15 if flags & COMPLEX != 0 => Content::Other("complex"),
        6..=15 if is_matrix => {
            let element = bytes.element()?;
            let numbers = element.data.numbers(element.kind)?;
            let (rows, columns) = (sizes[0] as usize, sizes[1] as usize);
            (rows.checked_mul(columns)? == numbers.len()).then_some(())?;
            Content::Numbers { rows, columns, numbers }
        }
        6..=15 => Content::Other("an array of more than two dimensions"),
        1 => Content::Other("a cell array"),
        2 => Content::Other("an array of structures"),
        4 => Content::Other("a text"),
        5 => Content::Other("sparse"),
        _ => Content::Other("an object"),
    };
    // What a program keeps for itself has no name.
    if !name.is_empty() {
        found.push(Variable { name, content });
    }
    Some(())
}

/// Adds the fields of a structure.
fn structure(mut bytes: Bytes<'_>, name: &str, depth: usize, found: &mut Vec<Variable>) -> Option<()> {
    let length = usize::try_from(bytes.element()?.data.word()?).ok().filter(|length| *length > 0)?;
    let names = bytes.element()?.data.rest;
    for field in names.chunks_exact(length) {
        let field = field.split(|byte| *byte == 0).next().unwrap_or_default();
        let field = format!("{name}.{}", String::from_utf8_lossy(field));
        let element = bytes.element()?;
        (element.kind == MATRIX).then_some(())?;
        matrix(element.data, Some(field), depth + 1, found)?;
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An element in little order, with its padding.
    fn element(kind: u32, data: &[u8]) -> Vec<u8> {
        let length = u32::try_from(data.len()).expect("short");
        let mut bytes = [kind.to_le_bytes(), length.to_le_bytes()].concat();
        bytes.extend(data);
        bytes.resize(bytes.len().next_multiple_of(8), 0);
        bytes
    }

    /// A file with a 3×1 vector `x`, its numbers kept in one byte each.
    fn file() -> Vec<u8> {
        let dimensions: Vec<u8> = [3i32, 1].iter().flat_map(|size| size.to_le_bytes()).collect();
        let flags = [6u32.to_le_bytes(), 0u32.to_le_bytes()].concat();
        let parts = [element(6, &flags), element(5, &dimensions), element(1, b"x"), element(2, &[1, 2, 250])];
        let mut file = vec![b' '; HEADER - 4];
        file.extend([0, 1, b'I', b'M']);
        file.extend(element(MATRIX, &parts.concat()));
        file
    }

    #[test]
    fn numbers_are_kept_in_the_smallest_type() {
        let content = Content::Numbers { rows: 3, columns: 1, numbers: vec![1.0, 2.0, 250.0] };
        assert_eq!(variables(&file()), Ok(vec![Variable { name: "x".to_owned(), content }]));
    }

    #[test]
    fn any_bytes_are_read_without_a_panic() {
        let file = file();
        for cut in 0..file.len() {
            let _ = variables(&file[..cut]);
            let mut changed = file.clone();
            changed[cut] = changed[cut].wrapping_add(97);
            let _ = variables(&changed);
        }
    }
}
