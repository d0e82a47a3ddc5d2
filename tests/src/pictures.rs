//! Pictures in pixels that a program has sent to its terminal, decoded.
//!
//! Sources: Kitty's *Terminal graphics protocol*; iTerm2's *Inline Images Protocol*; DEC's *VT330/VT340 Programmer Reference
//! Manual*, volume 2, chapter 14; *Portable Network Graphics (PNG) Specification*, third edition, sections 5 and 11.

use std::{collections::BTreeMap, io::Read};

use base64::{Engine, engine::general_purpose::STANDARD};
use flate2::read::ZlibDecoder;

/// Way in which a picture was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Protocol {
    /// Kitty's.
    Kitty,
    /// Sixel.
    Sixel,
    /// iTerm2's.
    Iterm2,
}

/// A picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SentPicture {
    /// The way in which it was sent.
    pub protocol: Protocol,
    /// Column and row of its upper left cell, from 0.
    pub at: (usize, usize),
    /// Cells across and down, where they are sent with it.
    pub cells: Option<(usize, usize)>,
    /// Pixels across and down.
    pub size: (usize, usize),
    /// Red, green, blue and opacity of each, row by row.
    pub pixels: Vec<[u8; 4]>,
}

impl SentPicture {
    /// The pixel at a column and a row.
    pub fn pixel(&self, (x, y): (usize, usize)) -> [u8; 4] {
        self.pixels[y * self.size.0 + x]
    }
}

/// The commands of Kitty's protocol: control data and payload, its parts joined; questions are left out.
pub fn kitty_commands(raw: &[u8]) -> Vec<(String, String)> {
    let raw = String::from_utf8_lossy(raw);
    let mut commands: Vec<(String, String)> = Vec::new();
    for command in raw.split("\x1b_G").skip(1) {
        let command = command.split("\x1b\\").next().unwrap_or_default();
        let (data, payload) = command.split_once(';').unwrap_or((command, ""));
        match commands.last_mut() {
            Some((_, before)) if data.starts_with("m=") => *before += payload,
            _ => commands.push((data.to_owned(), payload.to_owned())),
        }
    }
    commands.retain(|(data, _)| !data.contains("a=q"));
    commands
}

/// All pictures among the bytes of a program, in their order.
pub fn pictures(raw: &[u8]) -> Vec<SentPicture> {
    let raw = String::from_utf8_lossy(raw);
    let mut found = Vec::new();
    let mut at = (0, 0);
    let mut rest = &*raw;
    while let Some(escape) = rest.find('\x1b') {
        rest = &rest[escape + 1..];
        if let Some(place) = rest.strip_prefix('[').and_then(place) {
            at = place;
        } else if rest.starts_with("_Ga=T") {
            // Its parts follow one another.
            let whole = [b"\x1b", rest.as_bytes()].concat();
            let (data, payload) = kitty_commands(&whole).swap_remove(0);
            let values = values(&data, ',');
            assert_eq!(values["f"], "100", "{data}");
            found.push(png(Protocol::Kitty, at, Some(cells(&values, ["c", "r"])), &payload));
        } else if let Some(image) = rest.strip_prefix("]1337;File=") {
            let (head, data) = image.split_once(':').expect("a picture has data");
            let values = values(head, ';');
            assert_eq!((values["inline"], values["preserveAspectRatio"]), ("1", "0"), "{head}");
            let data = data.split('\x07').next().unwrap_or_default();
            found.push(png(Protocol::Iterm2, at, Some(cells(&values, ["width", "height"])), data));
            assert_eq!(values["size"].parse(), Ok(STANDARD.decode(data).expect("base64").len()));
        } else if rest.starts_with('P')
            && let Some((_, inside)) = rest.split("\x1b\\").next().unwrap_or_default().split_once("q\"")
        {
            found.push(sixel(at, inside));
        }
    }
    found
}

/// The place of a `CUP`, from 0.
fn place(rest: &str) -> Option<(usize, usize)> {
    let (numbers, _) = rest.split_once('H')?;
    let (row, column) = numbers.split_once(';')?;
    Some((column.parse::<usize>().ok()? - 1, row.parse::<usize>().ok()? - 1))
}

fn values(text: &str, between: char) -> BTreeMap<&str, &str> {
    text.split(between).filter_map(|pair| pair.split_once('=')).collect()
}

/// Cells across and down that a picture is given.
fn cells(values: &BTreeMap<&str, &str>, names: [&str; 2]) -> (usize, usize) {
    names.map(|name| values[name].parse().expect("a number")).into()
}

/// A PNG with a palette of colours and opacities.
fn png(protocol: Protocol, at: (usize, usize), cells: Option<(usize, usize)>, data: &str) -> SentPicture {
    let png = STANDARD.decode(data).expect("base64");
    assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().expect("four bytes")) as usize;
    let (size, mut next, mut chunks) = ((number(16), number(20)), 8, BTreeMap::new());
    assert_eq!(&png[24..29], [8, 3, 0, 0, 0], "eight bits of a palette");
    while next < png.len() {
        let data = &png[next + 8..next + 8 + number(next)];
        let mut sum = flate2::Crc::new();
        sum.update(&png[next + 4..next + 8 + data.len()]);
        assert_eq!(sum.sum() as usize, number(next + 8 + data.len()), "the sum of a chunk");
        chunks.insert(&png[next + 4..next + 8], data);
        next += data.len() + 12;
    }
    let mut rows = Vec::new();
    ZlibDecoder::new(chunks[&b"IDAT"[..]]).read_to_end(&mut rows).expect("zlib");
    assert_eq!(rows.len(), size.1 * (size.0 + 1));
    let (colors, opacities) = (chunks[&b"PLTE"[..]], chunks[&b"tRNS"[..]]);
    let color = |n: &u8| {
        let n = usize::from(*n);
        [colors[3 * n], colors[3 * n + 1], colors[3 * n + 2], opacities[n]]
    };
    let row = |row: &[u8]| {
        assert_eq!(row[0], 0, "a row without a filter");
        row[1..].iter().map(color).collect::<Vec<_>>()
    };
    SentPicture { protocol, at, cells, size, pixels: rows.chunks(size.0 + 1).flat_map(row).collect() }
}

/// A Sixel picture, from its raster attributes on; what it leaves as it is has no opacity.
fn sixel(at: (usize, usize), inside: &str) -> SentPicture {
    let mut letters = inside.chars().peekable();
    let numbers = |letters: &mut std::iter::Peekable<std::str::Chars<'_>>| -> Vec<usize> {
        let mut text = String::new();
        while let Some(part) = letters.next_if(|next| next.is_ascii_digit() || *next == ';') {
            text.push(part);
        }
        text.split(';').map(|number| number.parse().expect("a number")).collect()
    };
    let &[1, 1, width, height] = &numbers(&mut letters)[..] else { panic!("raster attributes: {inside}") };
    let mut pixels = vec![[0; 4]; width * height];
    let mut registers: BTreeMap<usize, [u8; 4]> = BTreeMap::new();
    let (mut x, mut top, mut color, mut times) = (0, 0, [0; 4], 1);
    while let Some(letter) = letters.next() {
        match letter {
            '#' => match numbers(&mut letters)[..] {
                [n] => color = registers[&n],
                [n, 2, red, green, blue] => {
                    let part = |share: usize| ((share * 255 + 50) / 100) as u8;
                    registers.insert(n, [part(red), part(green), part(blue), 255]);
                }
                _ => panic!("a colour: {inside}"),
            },
            '!' => times = numbers(&mut letters)[0],
            '$' => x = 0,
            '-' => (x, top) = (0, top + 6),
            '?'..='~' => {
                for _ in 0..std::mem::replace(&mut times, 1) {
                    for bit in (0..6).filter(|bit| (letter as u8 - b'?') >> bit & 1 == 1) {
                        pixels[(top + bit) * width + x] = color;
                    }
                    x += 1;
                }
            }
            _ => panic!("{letter:?} in a picture"),
        }
    }
    SentPicture { protocol: Protocol::Sixel, at, cells: None, size: (width, height), pixels }
}
