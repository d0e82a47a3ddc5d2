//! Pictures in pixels over cells of a frame, and the terminals that can show them.
//!
//! A [`Raster`] has no colours of its own: a pixel holds the number of an ink and how much of the pixel the ink covers.
//! So it is one byte a pixel, has soft edges on any ground, and is a palette of PNG or Sixel as it is.

mod answers;
#[cfg(feature = "pixels")]
pub(crate) mod display;
#[cfg(feature = "pixels")]
mod png;
#[cfg(feature = "pixels")]
mod sixel;

use ratatui::{
    layout::Rect,
    style::{Color, Modifier, Style},
};

#[cfg(feature = "pixels")]
pub(crate) use self::answers::is_sane;
pub use self::answers::{Answers, QUERY};

/// Deletes every picture on the screen of a terminal that knows Kitty's protocol.
pub(crate) const FORGET: &str = "\x1b_Ga=d,q=2,d=A\x1b\\";

/// Degrees to which an ink covers a pixel, above none.
pub const DEGREES: u8 = 15;
/// Inks of a raster at most: with their degrees they fit in a byte.
const MOST_INKS: usize = 16;

/// Way in which a terminal takes pictures; of several that a terminal knows, the first is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Protocol {
    /// Inline images of iTerm2: pictures in place of cells. WezTerm has Kitty's protocol too, but takes a picture away
    /// where text is written over it.
    Iterm2,
    /// Kitty's graphics protocol: pictures below the text, kept by the terminal.
    Kitty,
    /// Sixel of the DEC terminals: pictures in place of cells.
    Sixel,
}

/// Colour of strokes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ink {
    /// The colour, as that of a cell; `Reset` is the colour of text.
    pub color: Color,
    /// Half as strong, as dim text is.
    pub faint: bool,
}

impl From<Style> for Ink {
    fn from(style: Style) -> Self {
        Self { color: style.fg.unwrap_or(Color::Reset), faint: style.add_modifier.contains(Modifier::DIM) }
    }
}

/// Pixels, row by row.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Raster {
    width: usize,
    height: usize,
    /// Zero for nothing, else one more than `DEGREES * ink + degree - 1`.
    pixels: Vec<u8>,
    inks: Vec<Ink>,
}

impl Raster {
    /// Nothing, in so many pixels across and down.
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![0; width * height], inks: Vec::new() }
    }

    /// Pixels across and down.
    pub fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// The number of an ink; beyond the sixteenth, of the last.
    pub fn ink(&mut self, ink: Ink) -> u8 {
        let at = self.inks.iter().position(|known| *known == ink).unwrap_or_else(|| {
            if self.inks.len() < MOST_INKS {
                self.inks.push(ink);
            }
            self.inks.len() - 1
        });
        at as u8
    }

    /// Covers a pixel with an ink, from 0 to 1, unless another covers it more.
    pub fn cover(&mut self, (x, y): (usize, usize), ink: u8, share: f64) {
        let degree = (share * f64::from(DEGREES)).round().clamp(0.0, f64::from(DEGREES)) as u8;
        if degree == 0 || x >= self.width || y >= self.height {
            return;
        }
        let pixel = &mut self.pixels[y * self.width + x];
        // The degree of what is there is one more than the remainder.
        if *pixel == 0 || (*pixel - 1) % DEGREES < degree {
            *pixel = DEGREES * ink + degree;
        }
    }

    /// The ink of a pixel, and the degree to which it covers it.
    pub fn pixel(&self, (x, y): (usize, usize)) -> Option<(Ink, u8)> {
        self.ink_of(*self.pixels.get(y * self.width + x)?)
    }

    /// Ink of a byte of a row and the degree to which it covers the pixel.
    pub(crate) fn ink_of(&self, pixel: u8) -> Option<(Ink, u8)> {
        let of = pixel.checked_sub(1)?;
        Some((self.inks.get(usize::from(of / DEGREES)).copied().unwrap_or_default(), of % DEGREES + 1))
    }

    /// Erases part of a row.
    pub fn erase(&mut self, y: usize, from: usize, to: usize) {
        let (from, to) = (from.min(self.width), to.min(self.width));
        if y < self.height && from < to {
            self.pixels[y * self.width + from..y * self.width + to].fill(0);
        }
    }

    /// True if nothing covers part of some rows.
    pub fn is_free(&self, rows: std::ops::Range<usize>, columns: std::ops::Range<usize>) -> bool {
        let (from, to) = (columns.start.min(self.width), columns.end.min(self.width));
        rows.take_while(|y| *y < self.height)
            .all(|y| self.pixels[y * self.width + from..y * self.width + to].iter().all(|pixel| *pixel == 0))
    }

    /// Changes every ink.
    pub fn change_inks(&mut self, change: impl Fn(Ink) -> Ink) {
        self.inks.iter_mut().for_each(|ink| *ink = change(*ink));
    }
}

#[cfg(feature = "pixels")]
impl Raster {
    /// The bytes of a row.
    pub(crate) fn row(&self, y: usize) -> &[u8] {
        &self.pixels[y * self.width..(y + 1) * self.width]
    }

    /// A part.
    pub(crate) fn crop(&self, x: usize, y: usize, width: usize, height: usize) -> Self {
        let rows = (y..y + height).flat_map(|y| &self.row(y)[x..x + width]);
        Self { width, height, pixels: rows.copied().collect(), inks: self.inks.clone() }
    }

    /// Lays another one over it.
    pub(crate) fn lay(&mut self, over: &Self, (x, y): (usize, usize)) {
        let numbers: Vec<u8> = over.inks.iter().map(|ink| self.ink(*ink)).collect();
        for row in 0..over.height.min(self.height.saturating_sub(y)) {
            for column in 0..over.width.min(self.width.saturating_sub(x)) {
                let pixel = over.pixels[row * over.width + column];
                if pixel > 0 {
                    let number = numbers[usize::from((pixel - 1) / DEGREES)];
                    self.pixels[(y + row) * self.width + x + column] =
                        DEGREES * number + (pixel - 1) % DEGREES + 1;
                }
            }
        }
    }
}

/// A raster over cells of a frame; later pictures lie over earlier ones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The cells.
    pub area: Rect,
    /// The pixels.
    pub raster: Raster,
}

/// Means of a terminal to show pictures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graphics {
    /// The way in which it takes them.
    pub protocol: Protocol,
    /// Pixels across a cell and down a cell.
    pub cell: (u16, u16),
    /// The colours of the terminal.
    pub colors: TerminalColors,
}

/// The colours of a terminal, as far as it says them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TerminalColors {
    /// Text.
    pub foreground: Option<[u8; 3]>,
    /// Ground.
    pub background: Option<[u8; 3]>,
    /// The sixteen.
    pub sixteen: [Option<[u8; 3]>; 16],
}
