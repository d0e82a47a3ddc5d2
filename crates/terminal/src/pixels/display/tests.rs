use std::{collections::BTreeMap, io::Read};

use flate2::read::ZlibDecoder;
use ratatui::style::Style;

use super::*;
use crate::{backend::MinimalBackend, pixels::TerminalColors, session::FrameBytes};

const CELL: (u16, u16) = (8, 16);

/// A terminal that shows pictures, and its screen of 40 columns and 12 rows.
struct Shown {
    display: Display,
    bytes: FrameBytes,
    frame: Buffer,
}

impl Shown {
    fn new(protocol: Protocol) -> Self {
        let colors = TerminalColors { background: Some([0; 3]), ..TerminalColors::default() };
        let display = Display::new(Graphics { protocol, cell: CELL, colors });
        Self { display, bytes: FrameBytes::default(), frame: Buffer::empty(Rect::new(0, 0, 40, 12)) }
    }

    /// Bytes that are sent for these pictures.
    fn sent(&mut self, pictures: Vec<Picture>) -> String {
        let mut backend = MinimalBackend::new(self.bytes.clone());
        self.display.show(pictures, &self.frame, &mut backend, &mut self.bytes).unwrap();
        String::from_utf8(std::mem::take(&mut *self.bytes.0.borrow_mut())).unwrap()
    }
}

/// A stroke down a picture, at a pixel of its rows.
fn stroke(area: Rect, at: usize) -> Picture {
    let mut raster = Raster::new(usize::from(area.width * CELL.0), usize::from(area.height * CELL.1));
    let green = raster.ink(Style::new().fg(Color::Rgb(0, 255, 0)).into());
    let height = raster.size().1;
    for y in 0..height {
        raster.cover((at, y), green, 1.0);
        raster.cover((at + 1, y), green, 0.5);
    }
    Picture { area, raster }
}

/// The payload of the pictures that were sent to Kitty.
fn payload(sent: &str) -> Vec<u8> {
    let parts = sent.split("\x1b_G").skip(1).map(|part| part.split("\x1b\\").next().unwrap());
    let data: String = parts.filter_map(|part| part.split_once(';')).map(|(_, data)| data).collect();
    STANDARD.decode(data).unwrap()
}

/// Width, height and pixels of a PNG as we write it, a row at a time.
fn decoded(png: &[u8]) -> (usize, usize, Vec<u8>) {
    assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap()) as usize;
    let (width, height) = (number(16), number(20));
    let (mut at, mut data) = (8, Vec::new());
    while at < png.len() {
        let length = number(at);
        if &png[at + 4..at + 8] == b"IDAT" {
            data.extend_from_slice(&png[at + 8..at + 8 + length]);
        }
        at += length + 12;
    }
    let mut rows = Vec::new();
    ZlibDecoder::new(&data[..]).read_to_end(&mut rows).unwrap();
    let pixels = rows.chunks(width + 1).flat_map(|row| row[1..].to_vec()).collect();
    (width, height, pixels)
}

/// The pixels that a Sixel picture sets, with the number of their colour.
fn of_sixel(sent: &str) -> BTreeMap<(usize, usize), usize> {
    let (_, inside) = sent.split_once("\x1bP").expect("a picture");
    let inside = inside.split("\x1b\\").next().unwrap().split_once('q').unwrap().1;
    let mut pixels = BTreeMap::new();
    let (mut x, mut top, mut color) = (0, 0, 0);
    let mut letters = inside.chars().peekable();
    let mut number = String::new();
    while let Some(letter) = letters.next() {
        match letter {
            '#' | '!' | '"' => {
                number.clear();
                while let Some(part) = letters.next_if(|next| next.is_ascii_digit() || *next == ';') {
                    number.push(part);
                }
                if letter == '#' {
                    color = number.split(';').next().unwrap().parse().unwrap();
                }
                if letter == '!' {
                    let (times, bits) =
                        (number.parse::<usize>().unwrap(), letters.next().unwrap() as u8 - b'?');
                    for _ in 0..times {
                        pixels.extend((0..6).filter(|n| bits >> n & 1 == 1).map(|n| ((x, top + n), color)));
                        x += 1;
                    }
                }
            }
            '$' => x = 0,
            '-' => (x, top) = (0, top + 6),
            letter => {
                let bits = letter as u8 - b'?';
                pixels.extend((0..6).filter(|n| bits >> n & 1 == 1).map(|n| ((x, top + n), color)));
                x += 1;
            }
        }
    }
    pixels
}

#[test]
fn kitty_gets_each_picture_once() {
    let mut shown = Shown::new(Protocol::Kitty);
    let area = Rect::new(3, 2, 10, 5);
    let sent = shown.sent(vec![stroke(area, 20)]);
    assert!(sent.contains("\x1b[3;4H\x1b_Ga=T,") && sent.contains("c=10,r=5"), "{sent:?}");
    let (width, height, pixels) = decoded(&payload(&sent));
    assert_eq!((width, height), (80, 80));
    assert_eq!(pixels, stroke(area, 20).raster.pixels);
    // The same again; elsewhere; gone; back; another.
    assert_eq!(shown.sent(vec![stroke(area, 20)]), "\x1b7\x1b8");
    let moved = Rect { x: 5, ..area };
    assert_eq!(
        shown.sent(vec![stroke(moved, 20)]),
        "\x1b7\x1b[3;6H\x1b_Ga=p,q=2,i=31700,p=1,C=1,z=-1000,c=10,r=5\x1b\\\x1b8"
    );
    assert_eq!(shown.sent(vec![]), "\x1b7\x1b_Ga=d,q=2,d=i,i=31700\x1b\\\x1b8");
    assert!(shown.display.is_idle(&[]));
    assert_eq!(shown.sent(vec![stroke(moved, 20)]).matches("a=p").count(), 1);
    let other = shown.sent(vec![stroke(moved, 21)]);
    assert_eq!(decoded(&payload(&other)).2, stroke(area, 21).raster.pixels);
    // Of a screen that was lost nothing is left.
    shown.display.forget(&mut shown.bytes).unwrap();
    assert!(shown.sent(vec![stroke(moved, 21)]).starts_with("\x1b_Ga=d,q=2,d=A\x1b\\\x1b7"));
}

#[test]
fn a_long_picture_is_sent_in_parts() {
    let mut shown = Shown::new(Protocol::Kitty);
    let area = Rect::new(0, 0, 40, 12);
    let mut picture = stroke(area, 20);
    let ink = picture.raster.ink(Ink::default());
    // A generator of no quality serves (Numerical Recipes, 2nd edition, section 7.1).
    let mut state = 1u32;
    for y in 0..192 {
        for x in 0..320 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            picture.raster.cover((x, y), ink, f64::from(state >> 16) / 65536.0);
        }
    }
    let pixels = picture.raster.pixels.clone();
    let sent = shown.sent(vec![picture]);
    let parts: Vec<&str> = sent.split("\x1b_G").skip(1).collect();
    assert!(parts.len() > 2 && parts.iter().all(|part| part.len() < PART + 100));
    assert_eq!(parts.iter().position(|part| part.contains("m=0;")), Some(parts.len() - 1));
    assert_eq!(decoded(&payload(&sent)).2, pixels);
}

#[test]
fn sixel_gets_the_cells_that_changed_and_the_text_over_them() {
    let mut shown = Shown::new(Protocol::Sixel);
    let area = Rect::new(3, 2, 10, 5);
    shown.frame.set_string(5, 3, "peak", Style::new());
    let sent = shown.sent(vec![stroke(area, 20)]);
    assert!(sent.contains("q\"1;1;80;80#0;2;"), "{sent:?}");
    let set = of_sixel(&sent);
    // A pixel that is half covered has a colour of its own, half as bright.
    let wanted = (0..80).flat_map(|y| [((20, y), 0), ((21, y), 1)]).collect();
    assert_eq!(set, wanted);
    assert!(sent.contains("#0;2;0;100;0") && sent.contains("#1;2;0;53;0"), "{sent:?}");
    assert!(sent.find("\x1b\\").unwrap() < sent.find("peak").unwrap(), "text is over the picture: {sent:?}");
    assert_eq!(shown.sent(vec![stroke(area, 20)]), "\x1b7\x1b8");
    // The stroke goes from the third column of cells to the fifth: three columns are sent.
    let sent = shown.sent(vec![stroke(area, 36)]);
    assert!(sent.contains("q\"1;1;24;80") && sent.contains("\x1b[3;6H"), "{sent:?}");
    assert_eq!(of_sixel(&sent).keys().map(|(x, _)| *x).max(), Some(21));
    // Where a word was there is the picture again.
    shown.frame.set_string(5, 3, "    ", Style::new());
    let sent = shown.sent(vec![stroke(area, 36)]);
    assert!(sent.contains("q\"1;1;32;16") && sent.contains("\x1b[4;6H"), "{sent:?}");
    // Where a picture was there are the cells again.
    let sent = shown.sent(vec![]);
    assert!(!sent.contains("\x1bP"), "{sent:?}");
    assert_eq!(sent.matches(' ').count(), 50);
}

#[test]
fn a_picture_over_another_is_part_of_it_where_cells_hold_pictures() {
    let area = Rect::new(3, 2, 10, 5);
    let cursor = stroke(Rect { x: 6, width: 3, ..area }, 4);
    let set = of_sixel(&Shown::new(Protocol::Sixel).sent(vec![stroke(area, 20), cursor]));
    let columns: std::collections::BTreeSet<usize> = set.keys().map(|(x, _)| *x).collect();
    assert_eq!(columns.into_iter().collect::<Vec<_>>(), [20, 21, 28, 29]);
}

#[test]
fn iterm2_gets_an_image_of_as_many_cells() {
    let area = Rect::new(3, 2, 10, 5);
    let sent = Shown::new(Protocol::Iterm2).sent(vec![stroke(area, 20)]);
    let (head, data) = sent.split_once("\x1b]1337;File=inline=1;").unwrap().1.split_once(':').unwrap();
    assert!(head.contains("width=10;height=5;preserveAspectRatio=0"), "{head}");
    let png = STANDARD.decode(data.split('\x07').next().unwrap()).unwrap();
    assert_eq!(decoded(&png).2, stroke(area, 20).raster.pixels);
}
