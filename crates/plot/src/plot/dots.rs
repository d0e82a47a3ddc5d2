//! Lines made of dots, several to a cell.

use dalembert_core::exhibit::clipped;
use dalembert_terminal::pixels::Picture;
use ratatui::{buffer::Buffer, layout::Rect, style::Style};

use super::{Marker, brush::Brush};
use crate::look::Appearance;

/// Dots over the cells of an area. Coordinates are in dots from the upper left corner.
pub(crate) struct Dots {
    marker: Marker,
    area: Rect,
    cells: Vec<Cell>,
    /// Strokes in pixels, in place of the cells.
    brush: Option<Brush>,
    /// Dots since the pen was set down, for its dashes.
    travelled: u32,
    /// Signs on curves, over their dots.
    marks: Vec<Sign>,
    /// The sign of a stroke that has none yet, at its last dot.
    end: Option<Sign>,
}

/// Steps of a stroke to a pixel: spots half a pixel apart make an even line.
const STEPS: f64 = 2.0;

/// Pen that dots are drawn with.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pen {
    /// Style.
    pub(crate) style: Style,
    /// Sign of a cell where a dot is a whole cell.
    pub(crate) stamp: char,
    /// Dots drawn and dots left out, in turn; nothing is left out of `(1, 0)`.
    pub(crate) dash: (u32, u32),
    /// A sign that stands on the stroke now and then, and after how many dots it comes first; on a short one at its
    /// end.
    pub(crate) mark: Option<(char, u32)>,
    /// The place of its curve. A cell in which several curves have dots looks like the one that has most of them, the
    /// first of equals; what is no curve gives way to any, and to what is drawn later.
    pub(crate) curve: Option<usize>,
}

/// A sign on a curve: its cell, its dot, its character and its style.
type Sign = (usize, (f64, f64), char, Style);

#[derive(Clone, Copy, Default)]
struct Cell {
    mask: u8,
    stamp: char,
    style: Style,
    /// Owner of the cell's style, and its dots.
    owner: (Option<usize>, u8),
    /// Another curve and its dots.
    other: (Option<usize>, u8),
}

impl Cell {
    fn add(&mut self, bit: u8, pen: &Pen) {
        self.mask |= bit;
        if self.owner.0 == pen.curve {
            self.owner.1 |= bit;
        } else if self.owner.0.is_none() || pen.curve.is_none() {
            self.owner = (pen.curve, bit);
        } else {
            if self.other.0 != pen.curve {
                self.other = (pen.curve, 0);
            }
            self.other.1 |= bit;
            if self.other.1.count_ones() <= self.owner.1.count_ones() {
                return;
            }
            std::mem::swap(&mut self.owner, &mut self.other);
        }
        (self.stamp, self.style) = (pen.stamp, pen.style);
    }
}

impl Pen {
    /// A pen without gaps.
    pub(crate) fn solid(style: Style, stamp: char) -> Self {
        Self { style, stamp, dash: (1, 0), mark: None, curve: None }
    }
}

impl Dots {
    /// No dots yet.
    pub(crate) fn new(area: Rect, marker: Marker) -> Self {
        Self {
            marker,
            area,
            cells: vec![Cell::default(); area.area() as usize],
            brush: match marker {
                Marker::Pixels { across, down } => Some(Brush::new(area, (across, down))),
                _ => None,
            },
            travelled: 0,
            marks: Vec::new(),
            end: None,
        }
    }

    /// Dots across a cell and down a cell.
    pub(crate) fn per_cell(&self) -> (u16, u16) {
        per_cell(self.marker)
    }

    /// Dots across the area and down the area.
    pub(crate) fn size(&self) -> (u16, u16) {
        size(self.marker, self.area)
    }

    /// The dot at parts of the area, across and up.
    pub(crate) fn at_place(&self, (across, up): (f64, f64)) -> (f64, f64) {
        let (width, height) = self.size();
        (across * (f64::from(width) - 1.0), (1.0 - up) * (f64::from(height) - 1.0))
    }

    /// The dot at parts of the area, where it is drawn in pixels, and what it is drawn with.
    pub(crate) fn dot_of(&mut self, place: Option<(f64, f64)>) -> Option<((f64, f64), &mut Brush)> {
        let dot = self.at_place(place?);
        Some((dot, self.brush.as_mut()?))
    }

    /// The cell that holds a dot, inside the area.
    pub(crate) fn cell_of(&self, (x, y): (f64, f64)) -> (u16, u16) {
        let (across, down) = self.per_cell();
        let cell =
            |at: f64, per: u16, cells: u16| (at.round().max(0.0) as u16 / per).min(cells.saturating_sub(1));
        (self.area.x + cell(x, across, self.area.width), self.area.y + cell(y, down, self.area.height))
    }

    /// True for a cell of the buffer without a dot.
    pub(crate) fn is_free(&self, x: u16, y: u16) -> bool {
        if let Some(brush) = &self.brush {
            return brush.is_free(x, y);
        }
        self.index(x, y).is_none_or(|at| self.cells[at].mask == 0)
    }

    /// Lifts the pen: the next line begins a dash.
    pub(crate) fn lift(&mut self) {
        self.travelled = 0;
        self.marks.extend(self.end.take());
    }

    /// A straight line, clipped at the edges. Ends that are not finite draw nothing.
    pub(crate) fn line(&mut self, from: (f64, f64), to: (f64, f64), pen: Pen) {
        let (width, height) = self.size();
        if width == 0 || height == 0 {
            return;
        }
        let Some((from, to)) = clip(from, to, (f64::from(width) - 1.0, f64::from(height) - 1.0)) else {
            return;
        };
        let (across, down) = (to.0 - from.0, to.1 - from.1);
        // No step is longer than a dot, so that none is skipped between two that are rounded.
        let finer = if self.brush.is_some() { STEPS } else { 1.0 };
        let steps = (finer * across.abs().max(down.abs())).ceil().max(1.0);
        for n in 0..=steps as u32 {
            let share = f64::from(n) / steps;
            self.dot((from.0 + across * share, from.1 + down * share), pen);
        }
    }

    /// Hides what lies inside a closed line.
    pub(crate) fn hide(&mut self, corners: &[(f64, f64)]) {
        if let Some(brush) = &mut self.brush {
            return brush.hide(corners);
        }
        let (width, height) = self.size();
        let range = |of: fn(&(f64, f64)) -> f64, size: u16| {
            let least = corners.iter().map(of).fold(f64::INFINITY, f64::min);
            let most = corners.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
            least.max(0.0) as u16..((most + 1.0).max(0.0) as u16).min(size)
        };
        for y in range(|at| at.1, height) {
            for x in range(|at| at.0, width) {
                if inside(corners, (f64::from(x), f64::from(y))) {
                    self.erase(x, y);
                }
            }
        }
    }

    /// Strokes in pixels.
    pub(crate) fn brush(&mut self) -> Option<&mut Brush> {
        self.brush.as_mut()
    }

    /// The picture in pixels.
    pub(crate) fn picture(&mut self, look: &Appearance) -> Option<Picture> {
        Some(self.brush.take()?.picture(look))
    }

    /// Draws the cells that hold dots, and the signs of curves; in pixels, the signs alone.
    pub(crate) fn draw(&mut self, buffer: &mut Buffer) {
        if let Some(brush) = &mut self.brush {
            for (_, at, mark, style) in self.marks.drain(..) {
                brush.sign(at, mark, style.into());
            }
            return;
        }
        for (n, cell) in self.cells.iter().enumerate().filter(|(_, cell)| cell.mask != 0) {
            let (x, y) = (n as u16 % self.area.width, n as u16 / self.area.width);
            let shown = match self.marker {
                Marker::Braille => char::from_u32(0x2800 + u32::from(cell.mask)).unwrap_or(' '),
                Marker::HalfBlock => [' ', '▀', '▄', '█'][usize::from(cell.mask & 3)],
                Marker::Dot | Marker::Ascii | Marker::Pixels { .. } => cell.stamp,
            };
            over(buffer, (self.area.x + x, self.area.y + y), shown, cell.style);
        }
        for (n, _, mark, style) in &self.marks {
            let (x, y) = (*n as u16 % self.area.width, *n as u16 / self.area.width);
            over(buffer, (self.area.x + x, self.area.y + y), *mark, *style);
        }
    }

    fn dot(&mut self, dot: (f64, f64), pen: Pen) {
        let (x, y) = dot;
        // Dashes are measured in dots of braille, two of them across a cell.
        let unit = if self.brush.is_some() { STEPS as u32 * u32::from(self.per_cell().0) / 2 } else { 1 };
        let (on, off) = (pen.dash.0 * unit, pen.dash.1 * unit);
        let drawn = self.travelled % (on + off).max(1) < on;
        let travelled = self.travelled;
        self.travelled = travelled.wrapping_add(1);
        let (across, down) = self.per_cell();
        let (x, y) = (x.round().max(0.0) as u16, y.round().max(0.0) as u16);
        let (column, row) = (x / across, y / down);
        let Some(at) = self.index(self.area.x + column, self.area.y + row).filter(|_| drawn) else {
            return;
        };
        match &mut self.brush {
            Some(brush) => brush.spot(dot, brush.radius(), pen.style.into()),
            None => self.cells[at].add(bit(self.marker, x, y), &pen),
        }
        if let Some((mark, first)) = pen.mark {
            let every = if self.brush.is_some() { 24 * unit } else { 4 * u32::from(across + down) };
            let first = first * unit % every;
            if travelled % every == first {
                self.marks.push((at, dot, mark, pen.style));
                self.end = None;
            } else if travelled < first {
                self.end = Some((at, dot, mark, pen.style));
            }
        }
    }

    fn erase(&mut self, x: u16, y: u16) {
        let (across, down) = self.per_cell();
        if let Some(at) = self.index(self.area.x + x / across, self.area.y + y / down) {
            self.cells[at].mask &= !bit(self.marker, x, y);
        }
    }

    fn index(&self, x: u16, y: u16) -> Option<usize> {
        let inside = x >= self.area.x && x < self.area.right() && y >= self.area.y && y < self.area.bottom();
        inside.then(|| {
            usize::from(y - self.area.y) * usize::from(self.area.width) + usize::from(x - self.area.x)
        })
    }
}

/// Draws over whatever a cell holds: nothing of its colours and emphasis stays.
pub(crate) fn over(buffer: &mut Buffer, cell: (u16, u16), sign: char, style: Style) {
    let cell = &mut buffer[cell];
    cell.reset();
    cell.set_char(sign).set_style(style);
}

/// Heights of a cell to its width.
pub(crate) fn aspect(marker: Marker) -> f64 {
    match marker {
        Marker::Pixels { across, down } => f64::from(down) / f64::from(across.max(1)),
        _ => 2.0,
    }
}

/// Dots across an area and down it.
pub(crate) fn size(marker: Marker, area: Rect) -> (u16, u16) {
    let (across, down) = per_cell(marker);
    (area.width.saturating_mul(across), area.height.saturating_mul(down))
}

/// Dots across a cell and down a cell.
pub(crate) fn per_cell(marker: Marker) -> (u16, u16) {
    match marker {
        Marker::Braille => (2, 4),
        Marker::HalfBlock => (1, 2),
        Marker::Dot | Marker::Ascii => (1, 1),
        Marker::Pixels { across, down } => (across, down),
    }
}

/// The bit of a dot in the mask of its cell.
fn bit(marker: Marker, x: u16, y: u16) -> u8 {
    // The dots of a braille cell are numbered 1-2-3, 4-5-6 down its columns, 7 and 8 below them.
    const BRAILLE: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
    match marker {
        Marker::Braille => BRAILLE[usize::from(y % 4)][usize::from(x % 2)],
        Marker::HalfBlock => 1 << (y % 2),
        Marker::Dot | Marker::Ascii | Marker::Pixels { .. } => 1,
    }
}

/// True where a closed line goes round a point: a ray from it crosses the line an odd number of times.
fn inside(corners: &[(f64, f64)], (x, y): (f64, f64)) -> bool {
    let crosses = |from: (f64, f64), to: (f64, f64)| {
        (from.1 > y) != (to.1 > y) && x < from.0 + (y - from.1) / (to.1 - from.1) * (to.0 - from.0)
    };
    corners.windows(2).filter(|pair| crosses(pair[0], pair[1])).count() % 2 == 1
}

/// The part of a line inside `0 ≤ x ≤ width, 0 ≤ y ≤ height`.
fn clip(from: (f64, f64), to: (f64, f64), (width, height): (f64, f64)) -> Option<((f64, f64), (f64, f64))> {
    if ![from.0, from.1, to.0, to.1].into_iter().all(f64::is_finite) {
        return None;
    }
    // A line far longer than any screen is cut to a length whose arithmetic is exact enough.
    let far = |at: f64| at.clamp(-1e9, 1e9);
    let (from, to) = ((far(from.0), far(from.1)), (far(to.0), far(to.1)));
    clipped(from, to, &[(0.0, 0.0), (width, height)])
}

#[cfg(test)]
mod tests {
    use ratatui::style::Color;

    use super::*;

    fn drawn(width: u16, height: u16, marker: Marker, lines: &[[(f64, f64); 2]]) -> Vec<String> {
        let area = Rect::new(0, 0, width, height);
        let mut dots = Dots::new(area, marker);
        for [from, to] in lines {
            dots.line(*from, *to, Pen::solid(Style::new(), '*'));
        }
        let mut buffer = Buffer::empty(area);
        dots.draw(&mut buffer);
        (0..height).map(|y| (0..width).map(|x| buffer[(x, y)].symbol()).collect()).collect()
    }

    #[test]
    fn dots_stand_where_they_are_put() {
        assert_eq!(drawn(2, 1, Marker::Braille, &[[(0.0, 0.0), (3.0, 3.0)]]), ["⠑⢄"]);
        assert_eq!(drawn(1, 2, Marker::HalfBlock, &[[(0.0, 0.0), (0.0, 2.0)]]), ["█", "▀"]);
        assert_eq!(drawn(3, 2, Marker::Ascii, &[[(0.0, 1.0), (2.0, 1.0)]]), ["   ", "***"]);
    }

    #[test]
    fn lines_are_clipped_not_bent() {
        assert_eq!(drawn(3, 3, Marker::Ascii, &[[(-2.0, -2.0), (4.0, 4.0)]]), ["*  ", " * ", "  *"]);
        assert_eq!(drawn(3, 1, Marker::Ascii, &[[(0.0, 5.0), (2.0, 5.0)]]), ["   "]);
        assert_eq!(drawn(3, 1, Marker::Ascii, &[[(-1e300, 0.0), (1e300, 0.0)]]), ["***"]);
    }

    #[test]
    fn lines_have_no_gaps_wherever_between_dots_they_begin() {
        for tenths in 0..40 {
            let end = 10.0 + f64::from(tenths) / 10.0;
            let drawn = drawn(
                16,
                1,
                Marker::Ascii,
                &[
                    [(0.6, 0.0), (1.3 + f64::from(tenths % 7) / 10.0, 0.0)],
                    [(1.3 + f64::from(tenths % 7) / 10.0, 0.0), (end, 0.0)],
                ],
            );
            let last = end.round() as usize;
            assert_eq!(drawn[0].trim(), "*".repeat(last), "to {end}");
        }
    }

    #[test]
    fn what_is_not_finite_is_not_drawn() {
        for end in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(drawn(3, 1, Marker::Ascii, &[[(0.0, 0.0), (end, 0.0)]]), ["   "]);
        }
    }

    #[test]
    fn a_marked_curve_has_its_sign_now_and_then_and_a_short_stroke_at_its_end() {
        let area = Rect::new(0, 0, 20, 1);
        let mut dots = Dots::new(area, Marker::Ascii);
        let pen = Pen { mark: Some(('#', 2)), ..Pen::solid(Style::new(), '-') };
        dots.line((0.0, 0.0), (13.0, 0.0), pen);
        dots.lift();
        dots.line((18.0, 0.0), (19.0, 0.0), pen);
        dots.lift();
        let mut buffer = Buffer::empty(area);
        dots.draw(&mut buffer);
        let shown: String = (0..20).map(|x| buffer[(x, 0)].symbol()).collect();
        assert_eq!(shown, "--#-------#---    -#");
    }

    #[test]
    fn a_cell_of_two_curves_looks_like_the_one_with_more_dots_in_it() {
        let area = Rect::new(0, 0, 1, 2);
        let mut dots = Dots::new(area, Marker::Braille);
        let colors = [Color::Cyan, Color::Yellow];
        let pen = |n: usize| Pen { curve: Some(n), ..Pen::solid(Style::new().fg(colors[n]), '*') };
        // A long stem, and beside it one that reaches half a cell higher than its own.
        dots.line((0.0, 7.0), (0.0, 2.0), pen(0));
        dots.line((1.0, 7.0), (1.0, 0.0), pen(1));
        let mut buffer = Buffer::empty(area);
        dots.draw(&mut buffer);
        assert_eq!([0, 1].map(|y| buffer[(0, y)].fg), [Color::Yellow, Color::Cyan]);
        assert_eq!([0, 1].map(|y| buffer[(0, y)].symbol()), ["⣼", "⣿"]);
    }

    #[test]
    fn dashes_run_on_along_a_curve() {
        let area = Rect::new(0, 0, 9, 1);
        let mut dots = Dots::new(area, Marker::Ascii);
        let pen = Pen { dash: (2, 1), ..Pen::solid(Style::new(), '-') };
        dots.line((0.0, 0.0), (8.0, 0.0), pen);
        let mut buffer = Buffer::empty(area);
        dots.draw(&mut buffer);
        let shown: String = (0..9).map(|x| buffer[(x, 0)].symbol()).collect();
        assert_eq!(shown, "-- -- -- ");
    }
}
