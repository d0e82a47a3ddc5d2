//! Strokes and signs in pixels.

use dalembert_terminal::pixels::{Ink, Picture, Raster};
use ratatui::layout::Rect;

use crate::look::Appearance;

/// Strokes over the cells of an area, in pixels from its upper left corner.
#[derive(Clone, Debug)]
pub(crate) struct Brush {
    area: Rect,
    /// Pixels across a cell and down a cell.
    cell: (u16, u16),
    raster: Raster,
}

impl Brush {
    /// Nothing yet.
    pub(crate) fn new(area: Rect, cell: (u16, u16)) -> Self {
        let size = |cells: u16, pixels: u16| usize::from(cells) * usize::from(pixels);
        let raster = Raster::new(size(area.width, cell.0), size(area.height, cell.1));
        Self { area, cell, raster }
    }

    /// Pixels across and down.
    pub(crate) fn size(&self) -> (f64, f64) {
        let (width, height) = self.raster.size();
        (width as f64, height as f64)
    }

    /// Half the width of strokes.
    pub(crate) fn radius(&self) -> f64 {
        (f64::from(self.cell.1) / 20.0).max(0.6)
    }

    /// A round spot.
    pub(crate) fn spot(&mut self, at: (f64, f64), radius: f64, ink: Ink) {
        self.fill(at, radius, ink, |across, down| radius - across.hypot(down));
    }

    /// A sign, as large as its character.
    pub(crate) fn sign(&mut self, at: (f64, f64), sign: char, ink: Ink) {
        let radius = (0.24 * f64::from(self.cell.1)).min(0.45 * f64::from(self.cell.0)).max(2.0);
        let half = self.radius();
        let solid = move |across: f64, down: f64| match sign {
            '◆' | '◇' => (1.25 * radius - across.abs() - down.abs()) / std::f64::consts::SQRT_2,
            '■' | '□' => 0.85 * radius - across.abs().max(down.abs()),
            // Through the upper corner with a slope of 2, and above the base.
            '▲' | '△' => (0.9 * (f64::midpoint(radius, down) - across.abs())).min(0.8 * radius - down),
            _ => radius - across.hypot(down),
        };
        let is_hollow = matches!(sign, '◇' | '□' | '△' | '○');
        let hollow = move |across, down| {
            let depth: f64 = solid(across, down);
            depth.min(2.0 * half - depth)
        };
        if is_hollow {
            // The curve that it stands on is hidden inside.
            self.each(at, 1.3 * radius, solid, |raster, (x, y), depth| {
                if depth > half {
                    raster.erase(y, x, x + 1);
                }
            });
            self.fill(at, 1.3 * radius, ink, hollow);
        } else {
            self.fill(at, 1.3 * radius, ink, solid);
        }
    }

    /// Covers every pixel of part of the area to a share, where nothing covers it more.
    pub(crate) fn shade(
        &mut self,
        (from, to): (f64, f64),
        (top, bottom): (f64, f64),
        ink: Ink,
        share: impl Fn(usize, usize) -> f64,
    ) {
        let ink = self.raster.ink(ink);
        let (width, height) = self.raster.size();
        for y in top.max(0.0) as usize..(bottom.max(0.0) as usize).min(height) {
            for x in from.max(0.0) as usize..(to.max(0.0) as usize).min(width) {
                self.raster.cover((x, y), ink, share(x, y));
            }
        }
    }

    /// Erases what lies inside a closed line.
    pub(crate) fn hide(&mut self, corners: &[(f64, f64)]) {
        let height = self.raster.size().1;
        let (least, most) = corners
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), at| (least.min(at.1), most.max(at.1)));
        for y in least.max(0.0) as usize..((most + 1.0).max(0.0) as usize).min(height) {
            let row = y as f64;
            let crossing = |pair: &[(f64, f64)]| {
                let (from, to) = (pair[0], pair[1]);
                ((from.1 > row) != (to.1 > row))
                    .then(|| from.0 + (row - from.1) / (to.1 - from.1) * (to.0 - from.0))
            };
            let mut crossings: Vec<f64> = corners.windows(2).filter_map(crossing).collect();
            crossings.sort_by(f64::total_cmp);
            for pair in crossings.chunks_exact(2) {
                self.raster.erase(y, pair[0].ceil().max(0.0) as usize, pair[1].ceil().max(0.0) as usize);
            }
        }
    }

    /// Erases cells, for words.
    pub(crate) fn clear(&mut self, cells: Rect) {
        let (columns, rows) = self.letters_of(cells.intersection(self.area));
        for y in rows {
            self.raster.erase(y, columns.start, columns.end);
        }
    }

    /// True for a cell without a stroke where letters stand.
    pub(crate) fn is_free(&self, x: u16, y: u16) -> bool {
        let (columns, rows) = self.letters_of(Rect::new(x, y, 1, 1).intersection(self.area));
        self.raster.is_free(rows, columns)
    }

    /// The picture, in the colours of a theme.
    pub(crate) fn picture(mut self, look: &Appearance) -> Picture {
        self.raster.change_inks(|ink| look.stroke(ink));
        Picture { area: self.area, raster: self.raster }
    }

    /// The pixels of cells, without those above and below letters.
    fn letters_of(&self, cells: Rect) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
        let range = |from: u16, cells: u16, origin: u16, pixels: u16| {
            let from = usize::from(from.saturating_sub(origin)) * usize::from(pixels);
            from..from + usize::from(cells) * usize::from(pixels)
        };
        let rows = range(cells.y, cells.height, self.area.y, self.cell.1);
        let margin = usize::from(self.cell.1 / 8);
        let rows = rows.start + margin..rows.end.saturating_sub(margin);
        (range(cells.x, cells.width, self.area.x, self.cell.0), rows)
    }

    /// Covers the pixels round a point by how deep inside a shape they are.
    fn fill(&mut self, at: (f64, f64), radius: f64, ink: Ink, depth: impl Fn(f64, f64) -> f64) {
        let ink = self.raster.ink(ink);
        self.each(at, radius, depth, |raster, at, depth| {
            raster.cover(at, ink, (depth + 0.5).clamp(0.0, 1.0));
        });
    }

    /// Changes the pixels round a point by how deep inside a shape they are.
    fn each(
        &mut self,
        (x, y): (f64, f64),
        radius: f64,
        depth: impl Fn(f64, f64) -> f64,
        mut change: impl FnMut(&mut Raster, (usize, usize), f64),
    ) {
        let range =
            |at: f64| (at - radius - 1.0).ceil().max(0.0) as usize..=(at + radius + 1.0).max(0.0) as usize;
        for row in range(y) {
            for column in range(x) {
                change(&mut self.raster, (column, row), depth(column as f64 - x, row as f64 - y));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hollow_sign_hides_the_curve_inside_and_a_solid_one_covers_it() {
        for (sign, degree) in
            [('○', 0), ('◇', 0), ('□', 0), ('△', 0), ('●', 15), ('◆', 15), ('■', 15), ('▲', 15)]
        {
            let mut brush = Brush::new(Rect::new(0, 0, 4, 2), (10, 20));
            let (curve, own) = (Ink { faint: true, ..Ink::default() }, Ink::default());
            for x in 0..40 {
                brush.spot((f64::from(x), 20.0), brush.radius(), curve);
            }
            brush.sign((20.0, 20.0), sign, own);
            // The middle of a triangle is below its point.
            let inside = brush.raster.pixel((20, 21));
            assert_eq!(inside, (degree > 0).then_some((own, degree)), "{sign}");
            // Beside the sign the curve is as it was.
            assert_eq!(brush.raster.pixel((5, 20)), Some((curve, 15)), "{sign}");
        }
    }
}
