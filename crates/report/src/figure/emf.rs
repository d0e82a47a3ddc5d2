//! Pictures as Windows metafiles (Enhanced Metafile Format, [MS-EMF]): lines, areas and words that Word and LibreOffice
//! draw sharp at any size.
//!
//! Lengths are twentieths of a pixel.

use super::picture::{Anchor, Picture, PictureElement, Tone, WORDS};

/// Units of a pixel.
const SCALE: f64 = 20.0;
/// Hundredths of a millimetre of a pixel, of which there are 96 to the inch.
const FRAME: f64 = 2540.0 / 96.0;
/// Object that a pen, a brush or a font is while it is used.
const OBJECT: u32 = 1;

// Types of records.
const HEADER: u32 = 1;
const POLYLINE: u32 = 4;
const SET_WINDOW_EXTENT: u32 = 9;
const SET_VIEWPORT_EXTENT: u32 = 11;
const END: u32 = 14;
const SET_MAP_MODE: u32 = 17;
const SET_BACKGROUND_MODE: u32 = 18;
const SET_TEXT_ALIGN: u32 = 22;
const SET_TEXT_COLOUR: u32 = 24;
const SELECT_OBJECT: u32 = 37;
const CREATE_PEN: u32 = 38;
const CREATE_BRUSH: u32 = 39;
const DELETE_OBJECT: u32 = 40;
const ELLIPSE: u32 = 42;
const RECTANGLE: u32 = 43;
const CREATE_FONT: u32 = 82;
const WORDS_OUT: u32 = 84;

/// Stock objects: no pen, no brush.
const NO_PEN: u32 = 0x8000_0008;
const NO_BRUSH: u32 = 0x8000_0005;

/// A picture as the bytes of a metafile.
pub(crate) fn emf(picture: &Picture) -> Vec<u8> {
    let mut file = Metafile::default();
    let [width, height] = [picture.width, picture.height].map(|length| length.ceil() as u32);
    let units = |length: u32| length * SCALE as u32;
    // Bounds and sizes are written when the number of records is known.
    file.record(HEADER, &[0; 80]);
    file.words(SET_MAP_MODE, &[8]);
    file.words(SET_WINDOW_EXTENT, &[units(width), units(height)]);
    file.words(SET_VIEWPORT_EXTENT, &[width, height]);
    file.words(SET_BACKGROUND_MODE, &[1]);
    for part in &picture.parts {
        file.part(part);
    }
    file.words(END, &[0, 16, 20]);
    file.finish(width, height)
}

#[derive(Default)]
struct Metafile {
    bytes: Vec<u8>,
    records: u32,
}

impl Metafile {
    fn record(&mut self, kind: u32, content: &[u8]) {
        let length = content.len().next_multiple_of(4);
        self.bytes.extend(kind.to_le_bytes());
        self.bytes.extend((length as u32 + 8).to_le_bytes());
        self.bytes.extend(content);
        self.bytes.resize(self.bytes.len() + length - content.len(), 0);
        self.records += 1;
    }

    fn words(&mut self, kind: u32, words: &[u32]) {
        let content: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        self.record(kind, &content);
    }

    fn numbers(&mut self, kind: u32, numbers: &[i32]) {
        let content: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        self.record(kind, &content);
    }

    /// Draws with an object that exists as long.
    fn with_object(&mut self, other: u32, draw: impl FnOnce(&mut Self)) {
        self.words(SELECT_OBJECT, &[OBJECT]);
        self.words(SELECT_OBJECT, &[other]);
        draw(self);
        // What is selected cannot be deleted.
        self.words(SELECT_OBJECT, &[NO_PEN]);
        self.words(SELECT_OBJECT, &[NO_BRUSH]);
        self.words(DELETE_OBJECT, &[OBJECT]);
    }

    fn part(&mut self, part: &PictureElement) {
        match part {
            PictureElement::Line { points, tone, width, dash } => {
                let colour = colour(*tone, 1.0);
                let width = (width * SCALE).round() as u32;
                // Style, width and an unused number, colour.
                self.words(CREATE_PEN, &[OBJECT, 0, width, 0, colour]);
                self.with_object(NO_BRUSH, |file| {
                    for run in dashed(points, dash.lengths()) {
                        file.polyline(&run);
                    }
                });
            }
            PictureElement::Disc { at, radius, tone } => {
                let from = (at.0 - radius, at.1 - radius);
                self.filled(ELLIPSE, colour(*tone, 1.0), from, (at.0 + radius, at.1 + radius));
            }
            PictureElement::Area { from, to, tone, opacity } => {
                self.filled(RECTANGLE, colour(*tone, *opacity), *from, *to);
            }
            PictureElement::Words { at, anchor, text, tone } => self.set(*at, *anchor, text, *tone),
        }
    }

    fn polyline(&mut self, points: &[(f64, f64)]) {
        let mut numbers = bounds(points).to_vec();
        numbers.push(points.len() as i32);
        numbers.extend(points.iter().flat_map(|(x, y)| [unit(*x), unit(*y)]));
        self.numbers(POLYLINE, &numbers);
    }

    fn filled(&mut self, kind: u32, colour: u32, from: (f64, f64), to: (f64, f64)) {
        self.words(CREATE_BRUSH, &[OBJECT, 0, colour, 0]);
        self.with_object(NO_PEN, |file| file.numbers(kind, &bounds(&[from, to])));
    }

    fn set(&mut self, at: (f64, f64), anchor: Anchor, text: &str, tone: Tone) {
        let letters: Vec<u16> = text.encode_utf16().collect();
        let mut font: Vec<u8> = Vec::new();
        // A negative height is that of the letters; then width, angles and weight.
        for number in [OBJECT as i32, -unit(WORDS), 0, 0, 0, 400] {
            font.extend(number.to_le_bytes());
        }
        // Style, set of characters, precision, pitch.
        font.extend([0, 0, 0, 1, 0, 0, 0, 0]);
        let name: Vec<u8> = "Cambria".encode_utf16().flat_map(u16::to_le_bytes).collect();
        font.extend(&name);
        font.resize(4 + 92 + 228, 0);
        self.record(CREATE_FONT, &font);
        // On the base line.
        let align = match anchor {
            Anchor::Start => 24,
            Anchor::Middle => 24 + 6,
            Anchor::End => 24 + 2,
        };
        self.words(SET_TEXT_ALIGN, &[align]);
        self.words(SET_TEXT_COLOUR, &[colour(tone, 1.0)]);
        self.words(SELECT_OBJECT, &[OBJECT]);
        // Bounds, mode of graphics, scales, place, number of letters, their offset, options, rectangle, offset of widths.
        let mut content: Vec<u8> = Vec::new();
        for number in [0, 0, -1, -1, 1] {
            content.extend(i32::to_le_bytes(number));
        }
        for scale in [1.0_f32, 1.0] {
            content.extend(scale.to_le_bytes());
        }
        for number in [unit(at.0), unit(at.1)] {
            content.extend(number.to_le_bytes());
        }
        let after = 76 + 2 * letters.len().next_multiple_of(2);
        for number in [letters.len() as u32, 76, 0, 0, 0, 0, 0, after as u32] {
            content.extend(number.to_le_bytes());
        }
        content.extend(letters.iter().flat_map(|letter| letter.to_le_bytes()));
        content.resize(after - 8, 0);
        let advance = (0.5 * WORDS * SCALE) as u32;
        content.extend(letters.iter().flat_map(|_| advance.to_le_bytes()));
        self.record(WORDS_OUT, &content);
        self.words(DELETE_OBJECT, &[OBJECT]);
    }

    /// The bytes with their header.
    fn finish(mut self, width: u32, height: u32) -> Vec<u8> {
        let frame = |length: u32| (f64::from(length) * FRAME).round() as u32;
        let size = self.bytes.len() as u32;
        let mut header: Vec<u8> = Vec::new();
        let mut words = |words: &[u32]| header.extend(words.iter().flat_map(|word| word.to_le_bytes()));
        words(&[0, 0, width, height, 0, 0, frame(width), frame(height)]);
        // Signature, version, bytes, records; objects with the one of no number; no description, no palette.
        words(&[0x464D_4520, 0x0001_0000, size, self.records, 2, 0, 0, 0]);
        // A device of 1920 × 1080 pixels, in pixels and in millimetres.
        words(&[1920, 1080, 508, 286]);
        self.bytes[8..8 + header.len()].copy_from_slice(&header);
        self.bytes
    }
}

fn unit(length: f64) -> i32 {
    (length * SCALE).round() as i32
}

fn bounds(points: &[(f64, f64)]) -> [i32; 4] {
    let mut bounds = [i32::MAX, i32::MAX, i32::MIN, i32::MIN];
    for (x, y) in points.iter().map(|(x, y)| (unit(*x), unit(*y))) {
        bounds = [bounds[0].min(x), bounds[1].min(y), bounds[2].max(x), bounds[3].max(y)];
    }
    bounds
}

/// Colour on white paper: blue, green and red from the highest byte.
fn colour(tone: Tone, opacity: f64) -> u32 {
    let ([red, green, blue], opacity) = match (tone.channels(), tone) {
        (Some(channels), _) => (channels, opacity),
        (None, Tone::Faint) => ([0; 3], 0.35 * opacity),
        (None, _) => ([0; 3], opacity),
    };
    let on_white = |channel: u8| (255.0 - opacity * (255.0 - f64::from(channel))).round() as u32;
    on_white(blue) << 16 | on_white(green) << 8 | on_white(red)
}

/// A line of points in dashes of these lengths, dash and gap in turn; without lengths the line as it is.
fn dashed(points: &[(f64, f64)], lengths: &[u32]) -> Vec<Vec<(f64, f64)>> {
    let Some(first) = points.first() else { return Vec::new() };
    if lengths.is_empty() {
        return vec![points.to_vec()];
    }
    let (mut runs, mut run) = (Vec::new(), vec![*first]);
    let (mut at, mut left) = (0, f64::from(lengths[0]));
    for pair in points.windows(2) {
        let [(mut x, mut y), to] = [pair[0], pair[1]];
        loop {
            let rest = (to.0 - x).hypot(to.1 - y);
            if rest <= left {
                left -= rest;
                run.push(to);
                break;
            }
            let share = left / rest;
            (x, y) = (x + share * (to.0 - x), y + share * (to.1 - y));
            run.push((x, y));
            if at % 2 == 0 {
                runs.push(run);
            }
            run = vec![(x, y)];
            at += 1;
            left = f64::from(lengths[at % lengths.len()]);
        }
    }
    if at % 2 == 0 {
        runs.push(run);
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dashed_line_is_drawn_in_dashes() {
        let runs = dashed(&[(0.0, 0.0), (10.0, 0.0)], &[4, 2]);
        assert_eq!(runs, [vec![(0.0, 0.0), (4.0, 0.0)], vec![(6.0, 0.0), (10.0, 0.0)]]);
    }

    #[test]
    fn a_metafile_counts_its_bytes_and_records() {
        let words = PictureElement::Words {
            at: (5.0, 5.0),
            anchor: Anchor::Middle,
            text: "θ₂".to_owned(),
            tone: Tone::Ink,
        };
        let picture = Picture { width: 100.0, height: 50.0, parts: vec![words], ..Picture::default() };
        let bytes = emf(&picture);
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        let (mut at, mut records) = (0, 0);
        while at < bytes.len() {
            at += word(at + 4) as usize;
            records += 1;
        }
        assert_eq!((at, word(48), word(52)), (bytes.len(), bytes.len() as u32, records));
    }
}
