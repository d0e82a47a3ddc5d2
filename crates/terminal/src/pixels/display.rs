//! Pictures on the screen: what has to be sent so that those of a frame are seen, and nothing else of any.
//!
//! Sources: Kitty's *Terminal graphics protocol*; iTerm2's *Inline Images Protocol*.

use std::io::{self, Write};

use base64::{Engine, engine::general_purpose::STANDARD};
use ratatui::{
    backend::Backend,
    buffer::{Buffer, Cell},
    layout::{Position, Rect},
    style::Color,
};

use super::{DEGREES, FORGET, Graphics, Ink, Picture, Protocol, Raster, png::png, sixel::sixel};
use crate::glyphs::{index_of, rgb};

/// The number of the first picture at the terminal: others on the same screen are not ours to replace.
const FIRST: usize = 31_700;
/// Pictures lie below text, and the first below the others.
const DEPTH: i32 = -1000;
/// The longest part of a picture that Kitty's protocol takes in one sequence.
const PART: usize = 4096;

/// Pictures that the terminal shows.
pub(crate) struct Display {
    graphics: Graphics,
    /// Pictures that Kitty keeps under their numbers, and where each is seen.
    kept: Vec<(Raster, Option<Rect>)>,
    /// Pictures in place of cells, with the text over them.
    shown: Vec<(Picture, Vec<Cell>)>,
}

impl Display {
    pub(crate) fn new(graphics: Graphics) -> Self {
        Self { graphics, kept: Vec::new(), shown: Vec::new() }
    }

    pub(crate) fn graphics(&self) -> &Graphics {
        &self.graphics
    }

    /// Takes another size of cells.
    pub(crate) fn set_cell(&mut self, cell: (u16, u16)) {
        self.graphics.cell = cell;
    }

    /// True if there is nothing to show, to hide or to keep.
    pub(crate) fn is_idle(&self, pictures: &[Picture]) -> bool {
        pictures.is_empty() && self.shown.is_empty() && self.kept.iter().all(|(_, seen)| seen.is_none())
    }

    /// The screen was lost, and all pictures with it.
    pub(crate) fn forget(&mut self, out: &mut impl Write) -> io::Result<()> {
        self.shown.clear();
        if self.kept.is_empty() {
            return Ok(());
        }
        self.kept.clear();
        out.write_all(FORGET.as_bytes())
    }

    /// Shows the pictures of a frame, whose cells are written already.
    pub(crate) fn show<B: Backend<Error = io::Error>>(
        &mut self,
        pictures: Vec<Picture>,
        frame: &Buffer,
        backend: &mut B,
        out: &mut impl Write,
    ) -> io::Result<()> {
        // Where the cursor stands and what it writes with is the frame's.
        out.write_all(b"\x1b7")?;
        match self.graphics.protocol {
            Protocol::Kitty => self.below(pictures, frame, out)?,
            Protocol::Iterm2 | Protocol::Sixel => self.in_place(pictures, frame, backend, out)?,
        }
        out.write_all(b"\x1b8")
    }

    /// Pictures below the text: each is sent when it changes, and moved or hidden without that.
    fn below(&mut self, pictures: Vec<Picture>, frame: &Buffer, out: &mut impl Write) -> io::Result<()> {
        let count = pictures.len();
        for (n, Picture { area, raster }) in pictures.into_iter().enumerate() {
            let (id, depth) = (FIRST + n, DEPTH + n as i32);
            let place = format!("p=1,C=1,z={depth},c={},r={}", area.width, area.height);
            match self.kept.get(n) {
                Some((same, seen)) if *same == raster => {
                    if *seen != Some(area) {
                        go_to(out, area)?;
                        write!(out, "\x1b_Ga=p,q=2,i={id},{place}\x1b\\")?;
                    }
                }
                _ => {
                    go_to(out, area)?;
                    let ground = self.ground(frame, area);
                    let data = STANDARD.encode(png(&raster, |pixel| self.color(&raster, pixel, ground))?);
                    let mut first = format!("a=T,q=2,f=100,i={id},{place},");
                    let mut parts = data.as_bytes().chunks(PART).peekable();
                    while let Some(part) = parts.next() {
                        write!(out, "\x1b_G{first}m={};", u8::from(parts.peek().is_some()))?;
                        out.write_all(part)?;
                        out.write_all(b"\x1b\\")?;
                        first.clear();
                    }
                }
            }
            let now = (raster, Some(area));
            match self.kept.get_mut(n) {
                Some(kept) => *kept = now,
                None => self.kept.push(now),
            }
        }
        for (n, (_, seen)) in self.kept.iter_mut().enumerate().skip(count) {
            if seen.take().is_some() {
                write!(out, "\x1b_Ga=d,q=2,d=i,i={}\x1b\\", FIRST + n)?;
            }
        }
        Ok(())
    }

    /// Pictures in place of cells: the cells that changed are sent, and the text over them again.
    fn in_place<B: Backend<Error = io::Error>>(
        &mut self,
        pictures: Vec<Picture>,
        frame: &Buffer,
        backend: &mut B,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let now: Vec<(Picture, Vec<Cell>)> = flat(pictures)
            .into_iter()
            .map(|picture| {
                let cells = picture.area.positions().map(|at| frame[at].clone()).collect();
                (picture, cells)
            })
            .collect();
        // Text is written where pictures were.
        for (gone, _) in &self.shown {
            if !now.iter().any(|(picture, _)| picture.area == gone.area) {
                let area = gone.area.intersection(frame.area);
                backend.draw(area.positions().map(|at| (at.x, at.y, &frame[at])))?;
            }
        }
        for (picture, cells) in &now {
            let before = self.shown.iter().find(|(shown, _)| shown.area == picture.area);
            let Some(part) = self.changed(picture, cells, before) else { continue };
            self.send(picture, part, frame, backend, out)?;
            let is_text = |at: &Position| frame[*at].symbol() != " ";
            backend.draw(part.positions().filter(is_text).map(|at| (at.x, at.y, &frame[at])))?;
        }
        self.shown = now;
        Ok(())
    }

    /// The cells of a picture that look otherwise than before.
    fn changed(
        &self,
        picture: &Picture,
        cells: &[Cell],
        before: Option<&(Picture, Vec<Cell>)>,
    ) -> Option<Rect> {
        let area = picture.area;
        let Some((old, old_cells)) = before.filter(|(old, _)| {
            old.raster.size() == picture.raster.size() && old.raster.inks == picture.raster.inks
        }) else {
            return Some(area);
        };
        let (across, down) = (usize::from(self.graphics.cell.0), usize::from(self.graphics.cell.1));
        let columns = usize::from(area.width);
        let mut dirty: Vec<bool> = cells.iter().zip(old_cells).map(|(new, old)| new != old).collect();
        for y in 0..picture.raster.size().1 {
            let (new, old) = (picture.raster.row(y), old.raster.row(y));
            if new == old {
                continue;
            }
            for (column, (new, old)) in new.chunks(across).zip(old.chunks(across)).enumerate() {
                if new != old {
                    dirty[(y / down).min(usize::from(area.height) - 1) * columns + column.min(columns - 1)] =
                        true;
                }
            }
        }
        let changed = area.positions().zip(dirty).filter(|(_, dirty)| *dirty);
        changed.map(|(at, _)| Rect::new(at.x, at.y, 1, 1)).reduce(Rect::union)
    }

    /// Sends some cells of a picture.
    fn send<B: Backend<Error = io::Error>>(
        &self,
        picture: &Picture,
        part: Rect,
        frame: &Buffer,
        backend: &mut B,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let (across, down) = (usize::from(self.graphics.cell.0), usize::from(self.graphics.cell.1));
        let (x, y) = (usize::from(part.x - picture.area.x), usize::from(part.y - picture.area.y));
        let (width, height) = (usize::from(part.width), usize::from(part.height));
        let raster = picture.raster.crop(x * across, y * down, width * across, height * down);
        let ground = self.ground(frame, picture.area);
        // Nothing of what was there before may shine through.
        let opaque = |pixel: u8| {
            let (rgb, alpha) = self.color(&raster, pixel, ground);
            let share = f64::from(alpha) / 255.0;
            let ground = ground.unwrap_or([0; 3]);
            std::array::from_fn(|n| (share * f64::from(rgb[n]) + (1.0 - share) * f64::from(ground[n])) as u8)
        };
        match self.graphics.protocol {
            Protocol::Sixel => {
                // What is not drawn is the ground of these cells, without the picture that was there.
                let blank = |at: Position| Cell::default().set_bg(frame[at].bg).clone();
                let blanks: Vec<(u16, u16, Cell)> =
                    part.positions().map(|at| (at.x, at.y, blank(at))).collect();
                backend.draw(blanks.iter().map(|(x, y, cell)| (*x, *y, cell)))?;
                go_to(out, part)?;
                out.write_all(&sixel(&raster, opaque))
            }
            _ => {
                let image = png(&raster, |pixel| match ground {
                    Some(_) => (opaque(pixel), 255),
                    None => self.color(&raster, pixel, ground),
                })?;
                go_to(out, part)?;
                write!(
                    out,
                    "\x1b]1337;File=inline=1;size={};width={};height={};preserveAspectRatio=0;doNotMoveCursor=1:{}\x07",
                    image.len(),
                    part.width,
                    part.height,
                    STANDARD.encode(&image)
                )
            }
        }
    }

    /// The ground that a picture lies on, where it is known: that of its cells, or the terminal's.
    fn ground(&self, frame: &Buffer, area: Rect) -> Option<[u8; 3]> {
        let cell = frame.cell(area.as_position()).map_or(Color::Reset, |cell| cell.bg);
        self.rgb(cell).or(self.graphics.colors.background)
    }

    /// Colour and opacity of a pixel.
    fn color(&self, raster: &Raster, pixel: u8, ground: Option<[u8; 3]>) -> ([u8; 3], u8) {
        let Some((Ink { color, faint }, degree)) = raster.ink_of(pixel) else {
            return (ground.unwrap_or_default(), 0);
        };
        let text = || {
            self.graphics.colors.foreground.unwrap_or_else(|| {
                let is_light = ground
                    .is_some_and(|ground| ground.iter().map(|part| u32::from(*part)).sum::<u32>() > 384);
                if is_light { [0x20; 3] } else { [0xDD; 3] }
            })
        };
        let alpha = u16::from(degree) * 255 / u16::from(DEGREES) / if faint { 2 } else { 1 };
        (self.rgb(color).unwrap_or_else(text), alpha as u8)
    }

    /// Red, green and blue of a colour; `None` for that of text or of the ground.
    fn rgb(&self, color: Color) -> Option<[u8; 3]> {
        if let Color::Rgb(red, green, blue) = color {
            return Some([red, green, blue]);
        }
        let index = index_of(color)?;
        self.graphics.colors.sixteen.get(usize::from(index)).copied().flatten().or(Some(rgb(index)))
    }
}

/// Moves the cursor to the upper left corner of an area.
fn go_to(out: &mut impl Write, area: Rect) -> io::Result<()> {
    write!(out, "\x1b[{};{}H", area.y + 1, area.x + 1)
}

/// Pictures without any over another.
fn flat(pictures: Vec<Picture>) -> Vec<Picture> {
    let mut flat: Vec<Picture> = Vec::new();
    for picture in pictures {
        match flat.iter_mut().find(|below| below.area.intersection(picture.area) == picture.area) {
            Some(below) => {
                let (width, height) = below.raster.size();
                let across = width / usize::from(below.area.width).max(1);
                let down = height / usize::from(below.area.height).max(1);
                let (x, y) = (picture.area.x - below.area.x, picture.area.y - below.area.y);
                below.raster.lay(&picture.raster, (usize::from(x) * across, usize::from(y) * down));
            }
            None => flat.push(picture),
        }
    }
    flat
}

#[cfg(test)]
mod tests;
