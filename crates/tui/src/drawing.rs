//! Sketches of machines, in the cells of a terminal.

mod strokes;

use dalembert_core::{Drawing, DrawnShape, Locale, Point, Text};
use ratatui::{buffer::Buffer, layout::Rect};
use unicode_width::UnicodeWidthStr;

use self::strokes::{Box2, Part, Stroke, strokes};
use crate::{
    look::Look,
    plot::{
        Marker,
        dots::{Dots, Pen},
        labels::Labels,
    },
};

/// Draws a sketch as large as it fits, with equal scales across and up; any size will do.
pub fn render(drawing: &Drawing, look: &Look, locale: &Locale, area: Rect, buffer: &mut Buffer) {
    let mut area = area.intersection(buffer.area);
    if area.is_empty() {
        return;
    }
    let locale = Locale { style: dalembert_units::Style { ascii: look.ascii, ..locale.style }, ..*locale };
    if area.height >= 6 {
        let title = look.shortened(&drawing.title.render(&locale), area.width.into());
        buffer.set_string(area.x, area.y, title, look.title());
        area = Rect { y: area.y + 1, height: area.height - 1, ..area };
    }
    let all = strokes(drawing);
    let labels: Vec<(Point, String)> = labels(drawing, &locale);
    let corners = all.iter().flat_map(|stroke| &stroke.points).chain(labels.iter().map(|(at, _)| at));
    let Some(bounds) = Box2::of(corners.copied()) else {
        let words = look.shortened(&Text::new("nothing to draw").render(&locale), area.width.into());
        let x = area.x + (area.width - words.width() as u16) / 2;
        buffer.set_string(x, area.y + area.height / 2, words, look.dim());
        return;
    };
    let marker = if look.ascii { Marker::Ascii } else { Marker::Braille };
    let mut dots = Dots::new(area, marker);
    let fit = Fit::of(&bounds, &labels, &dots, area);
    for stroke in &all {
        draw(stroke, &fit, look, &mut dots);
    }
    dots.draw(buffer);
    let mut words = Labels::new(area);
    for (at, text) in &labels {
        let text = look.shortened(text, area.width.into());
        words.beside(&text, look.symbol(), dots.cell_of(fit.dot(*at)), |x, y| dots.is_free(x, y));
    }
    words.draw(buffer);
}

fn labels(drawing: &Drawing, locale: &Locale) -> Vec<(Point, String)> {
    let label = |shape: &DrawnShape| match shape {
        DrawnShape::Label(at, text) if at.0.is_finite() && at.1.is_finite() => {
            Some((*at, text.render(locale)))
        }
        _ => None,
    };
    drawing.shapes.iter().filter_map(label).collect()
}

fn draw(stroke: &Stroke, fit: &Fit, look: &Look, dots: &mut Dots) {
    let style = look.ink(stroke.ink);
    let points: Vec<(f64, f64)> = stroke.points.iter().map(|at| fit.dot(*at)).collect();
    dots.lift();
    if stroke.part == Part::Solid {
        dots.hide(&points);
    }
    if look.ascii && stroke.part == Part::Head {
        return;
    }
    for pair in points.windows(2) {
        let stamp = if stroke.part == Part::Round { 'o' } else { stamp(pair[0], pair[1]) };
        dots.line(pair[0], pair[1], Pen::solid(style, stamp));
    }
    if let (Part::Shaft, [tail, head]) = (stroke.part, &points[..])
        && look.ascii
    {
        dots.line(*head, *head, Pen::solid(style, head_stamp(*tail, *head)));
    }
}

/// The character that runs along a line of cells. A cell is twice as high as wide.
fn stamp(from: (f64, f64), to: (f64, f64)) -> char {
    let (across, down) = (to.0 - from.0, to.1 - from.1);
    if across.abs() > 2.5 * down.abs() {
        '-'
    } else if down.abs() > 2.5 * across.abs() {
        '|'
    } else if across * down > 0.0 {
        '\\'
    } else {
        '/'
    }
}

fn head_stamp(from: (f64, f64), to: (f64, f64)) -> char {
    let (across, down) = (to.0 - from.0, to.1 - from.1);
    match (across.abs() > 2.0 * down.abs(), across > 0.0, down > 0.0) {
        (true, true, _) => '>',
        (true, false, _) => '<',
        (false, _, true) => 'v',
        (false, _, false) => '^',
    }
}

/// From the metres of a drawing to dots.
struct Fit {
    middle: Point,
    /// The dot in the middle.
    centre: (f64, f64),
    /// Dots to a metre, across and down.
    scale: (f64, f64),
}

impl Fit {
    /// The largest scale with a cell of margin, and room for the words at the sides.
    fn of(bounds: &Box2, labels: &[(Point, String)], dots: &Dots, area: Rect) -> Self {
        let bare = Self::within(bounds, dots, (1.0, 1.0));
        let (across, _) = dots.per_cell();
        let cells = |at: Point| bare.dot(at).0 / f64::from(across);
        // Words stand right of their point if they can.
        let beyond = labels
            .iter()
            .map(|(at, text)| cells(*at) + 3.0 + text.width() as f64 - f64::from(area.width))
            .fold(0.0, f64::max);
        let most = f64::from(area.width) / 4.0;
        let mut fit = Self::within(bounds, dots, (1.0, 1.0 + beyond.min(most)));
        // What there is to spare goes to both sides.
        let (width, _) = dots.size();
        let right = fit.dot((bounds.right, bounds.top)).0 + beyond.min(most) * f64::from(across);
        let left = fit.dot((bounds.left, bounds.top)).0;
        fit.centre.0 += (f64::from(width) - 1.0 - right - left) / 2.0;
        fit
    }

    /// The largest scale that leaves so many cells free at the left and at the right.
    fn within(bounds: &Box2, dots: &Dots, (left, right): (f64, f64)) -> Self {
        let (across, down) = dots.per_cell();
        let (across, down) = (f64::from(across), f64::from(down));
        let (width, height) = (f64::from(dots.size().0), f64::from(dots.size().1));
        let room_across = (width - 1.0 - (left + right) * across).max(1.0);
        let room_down = (height - 1.0 - down.min(height / 4.0)).max(1.0);
        // In widths of a cell to a metre; a cell is twice as high as wide.
        let scale = (room_across / across / bounds.width()).min(2.0 * room_down / down / bounds.height());
        Self {
            middle: (f64::midpoint(bounds.left, bounds.right), f64::midpoint(bounds.bottom, bounds.top)),
            centre: (f64::midpoint(left * across, width - 1.0 - right * across), (height - 1.0) / 2.0),
            scale: (scale * across, scale * down / 2.0),
        }
    }

    fn dot(&self, (x, y): Point) -> (f64, f64) {
        let (across, up) = (x - self.middle.0, y - self.middle.1);
        (self.centre.0 + across * self.scale.0, self.centre.1 - up * self.scale.1)
    }
}

#[cfg(test)]
mod tests;
