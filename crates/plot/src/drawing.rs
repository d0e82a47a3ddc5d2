//! Sketches of machines, in the cells of a terminal.

use dalembert_core::{Drawing, DrawnShape, Ink, LabelSide, Locale, Point, Text};
use dalembert_report::figure::strokes::{Box2, Stroke, StrokeRole, strokes};
use dalembert_terminal::pixels::Picture;
use ratatui::{buffer::Buffer, layout::Rect, style::Style};
use unicode_width::UnicodeWidthStr;

use crate::{
    look::Appearance,
    plot::{
        Marker,
        dots::{self, Dots, Pen},
        labels::Labels,
    },
    wrap,
};

/// Rows of an area that is higher than any terminal.
const TALL: u16 = 1000;
/// Rows for labels above or below what is drawn.
const LABEL_ROWS: u16 = 1;

/// Places of the words of a drawing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlacedLabel {
    /// Words beside their points: the cells they take, the words, and the cells of the points.
    pub beside: Vec<(Rect, String, (u16, u16))>,
    /// Words without a free place, listed under the drawing where there is room for that.
    pub listed: Vec<String>,
    /// Cells of the heads of arrows, which no words cover.
    pub heads: Vec<(u16, u16)>,
    /// The strokes, where the look has pixels in place of braille.
    pub picture: Option<Picture>,
}

/// Draws a sketch as large as it fits, with equal scales across and up; any size will do. Words that have no free place
/// beside their points give way to a mark there, and are listed below with it.
pub fn render(
    drawing: &Drawing,
    look: &Appearance,
    locale: &Locale,
    area: Rect,
    buffer: &mut Buffer,
) -> PlacedLabel {
    let mut area = area.intersection(buffer.area);
    if area.is_empty() {
        return PlacedLabel::default();
    }
    let locale = locale.ascii(look.ascii);
    if area.height >= 6 {
        let most = wrap::title_rows(area.height);
        for line in wrap::title(&drawing.title.render(&locale), area.width.into(), most, look) {
            buffer.set_string(area.x, area.y, line, look.title());
            area = Rect { y: area.y + 1, height: area.height - 1, ..area };
        }
    }
    let all = strokes(drawing);
    let labels = labels(drawing, &locale);
    let Some(bounds) = bounds(drawing, &all, &labels) else {
        let words = look.shortened(&Text::new("nothing to draw").render(&locale), area.width.into());
        let x = area.x + (area.width - words.width() as u16) / 2;
        buffer.set_string(x, area.y + area.height / 2, words, look.dim());
        return PlacedLabel::default();
    };
    let sketch = Sketch { strokes: &all, labels: &labels, bounds: &bounds, look };
    let mut drawn = sketch.drawn(area);
    if !drawn.listed.is_empty() && area.height >= 6 {
        let rows = list(&drawn.listed, area.width, look).len().min(usize::from(area.height / 4)) as u16;
        drawn = sketch.drawn(Rect { height: area.height - rows, ..area });
        let mut lines = list(&drawn.listed, area.width, look);
        if lines.len() > rows.into() {
            let rest = lines.drain(usize::from(rows) - 1..).collect::<Vec<_>>().join("  ");
            lines.push(look.shortened(&rest, usize::from(area.width).min(rest.width() - 1)));
        }
        for (line, y) in lines.iter().zip(area.bottom() - rows..) {
            buffer.set_string(area.x, y, line, look.dim());
        }
    }
    drawn.dots.draw(buffer);
    drawn.words.draw(buffer);
    if let Some(brush) = drawn.dots.brush() {
        drawn.words.cells().for_each(|cells| brush.clear(cells));
    }
    PlacedLabel {
        picture: drawn.dots.picture(look),
        beside: drawn.words.placed(),
        listed: drawn.listed.into_iter().map(|(_, words)| words).collect(),
        heads: drawn.heads,
    }
}

/// Rows in which a sketch is as large as so many columns let it be.
pub fn rows(drawing: &Drawing, look: &Appearance, locale: &Locale, width: u16) -> u16 {
    let locale = locale.ascii(look.ascii);
    let all = strokes(drawing);
    let labels = labels(drawing, &locale);
    let Some(bounds) = bounds(drawing, &all, &labels) else { return 1 };
    let area = Rect::new(0, 0, width, TALL);
    let marker = look.marker(Marker::Braille);
    let dots = bounds.height() * Fit::of(&bounds, &labels, marker, area).scale.1;
    let sketch = (dots / f64::from(dots::per_cell(marker).1)).ceil() as u16 + LABEL_ROWS;
    let most = wrap::title_rows(u16::MAX);
    let title = wrap::title(&drawing.title.render(&locale), width.into(), most, look);
    wrap::height_with_title(title.len(), sketch)
}

/// The box around everything that is drawn.
fn bounds(drawing: &Drawing, strokes: &[Stroke], labels: &[Label]) -> Option<Box2> {
    let corners =
        strokes.iter().flat_map(|stroke| &stroke.points).chain(labels.iter().map(|label| &label.at));
    Box2::of(corners.copied().chain(extent(drawing)))
}

/// Words and the point that they stand beside.
#[derive(PartialEq)]
struct Label {
    at: Point,
    side: LabelSide,
    text: String,
}

/// Parts of a drawing, and the look they are drawn with.
struct Sketch<'a> {
    strokes: &'a [Stroke],
    labels: &'a [Label],
    bounds: &'a Box2,
    look: &'a Appearance,
}

/// A drawing in the cells of an area.
struct Drawn {
    dots: Dots,
    words: Labels,
    /// Marks and words that have no place beside their points.
    listed: Vec<(String, String)>,
    heads: Vec<(u16, u16)>,
}

impl Sketch<'_> {
    fn drawn(&self, area: Rect) -> Drawn {
        let look = self.look;
        let marker = look.marker(Marker::Braille);
        let mut dots = Dots::new(area, marker);
        let fit = Fit::of(self.bounds, self.labels, marker, area);
        for stroke in self.strokes {
            draw(stroke, &fit, look, &mut dots);
        }
        let mut words = Labels::new(area);
        let heads = self
            .strokes
            .iter()
            .filter(|stroke| stroke.part == StrokeRole::Head)
            .flat_map(|stroke| &stroke.points);
        let mut heads: Vec<(u16, u16)> = heads.map(|at| dots.cell_of(fit.dot(*at))).collect();
        heads.sort_unstable();
        heads.dedup();
        for cell in &heads {
            words.reserve(*cell);
        }
        let mut listed = Vec::new();
        for Label { at, side, text } in self.labels {
            let short = look.shortened(text, area.width.into());
            let cell = dots.cell_of(fit.dot(*at));
            let free = |x, y| dots.is_free(x, y);
            if !words.at_side(&short, look.symbol(), cell, *side, free) {
                let mark = mark(listed.len(), look);
                words.mark(&mark, look.symbol(), cell, free);
                listed.push((mark, text.clone()));
            }
        }
        Drawn { dots, words, listed, heads }
    }
}

/// The sign of words that are listed under a drawing: no number of a mass, no symbol.
fn mark(n: usize, look: &Appearance) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let number = (n + 1).to_string();
    if look.ascii {
        return format!("*{number}");
    }
    number.bytes().map(|digit| RAISED[usize::from(digit - b'0')]).collect()
}

/// Marks and words side by side, in lines.
fn list(listed: &[(String, String)], width: u16, look: &Appearance) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (mark, words) in listed {
        let entry = look.shortened(&format!("{mark} {words}"), width.into());
        match lines.last_mut() {
            Some(line) if line.width() + 2 + entry.width() <= width.into() => *line += &format!("  {entry}"),
            _ => lines.push(entry),
        }
    }
    lines
}

/// The words of a drawing and their points; the same words at the same point once.
fn labels(drawing: &Drawing, locale: &Locale) -> Vec<Label> {
    let label = |shape: &DrawnShape| match shape {
        DrawnShape::Label(at, side, text) if at.0.is_finite() && at.1.is_finite() => {
            Some(Label { at: *at, side: *side, text: text.render(locale) })
        }
        _ => None,
    };
    let mut labels: Vec<Label> = Vec::new();
    for label in drawing.shapes.iter().filter_map(label).filter(|label| !label.text.is_empty()) {
        if !labels.iter().any(|other| other.at == label.at && other.text == label.text) {
            labels.push(label);
        }
    }
    labels
}

/// Corners of what all frames of an animation show.
fn extent(drawing: &Drawing) -> impl Iterator<Item = Point> {
    drawing
        .shapes
        .iter()
        .filter(|shape| matches!(shape, DrawnShape::Extent(..)))
        .flat_map(DrawnShape::corners)
}

fn draw(stroke: &Stroke, fit: &Fit, look: &Appearance, dots: &mut Dots) {
    let style = look.ink(stroke.ink);
    let points: Vec<(f64, f64)> = stroke.points.iter().map(|at| fit.dot(*at)).collect();
    dots.lift();
    if matches!(stroke.part, StrokeRole::Solid | StrokeRole::Disc) {
        dots.hide(&points);
    }
    if look.ascii {
        match (stroke.part, &points[..]) {
            (StrokeRole::Head | StrokeRole::Hatch, _) => return,
            (StrokeRole::Spring, [from, .., to]) => return spring(*from, *to, style, dots),
            (StrokeRole::Ground, [from, to]) => hatch(*from, *to, look, dots),
            (StrokeRole::Round | StrokeRole::Disc, _) if is_small(&points) => {
                let at = middle(&points);
                dots.line(at, at, Pen::solid(style, 'O'));
                return;
            }
            _ => {}
        }
    }
    let points = if stroke.part == StrokeRole::Spring { open_coils(points) } else { points };
    for pair in points.windows(2) {
        let stamp = if matches!(stroke.part, StrokeRole::Round | StrokeRole::Disc) {
            'o'
        } else {
            stamp(pair[0], pair[1])
        };
        dots.line(pair[0], pair[1], Pen::solid(style, stamp));
    }
    if let (StrokeRole::Shaft, [tail, head]) = (stroke.part, &points[..])
        && look.ascii
    {
        dots.line(*head, *head, Pen::solid(style, head_stamp(*tail, *head)));
    }
}

/// The same wave of a spring with fewer coils, where its turns would lie on each other.
fn open_coils(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    // Straight ends and turns in between, one dot apart at least.
    let [from, first, turns @ .., last, to] = &points[..] else { return points };
    let length = (last.0 - first.0).abs().max((last.1 - first.1).abs());
    let fewest = 2;
    let most = ((length / 1.5) as usize).max(fewest);
    if turns.len() <= most {
        return points;
    }
    let half = (0..most).map(|n| {
        let part = (n as f64 + 0.5) / most as f64;
        let middle = (first.0 + (last.0 - first.0) * part, first.1 + (last.1 - first.1) * part);
        // The first two turns say how far a wave leaves its axis, and to which sides.
        let axis = 0.5 / turns.len() as f64 + (n % 2) as f64 / turns.len() as f64;
        let on = (first.0 + (last.0 - first.0) * axis, first.1 + (last.1 - first.1) * axis);
        let turn = turns[n % 2];
        (middle.0 + turn.0 - on.0, middle.1 + turn.1 - on.1)
    });
    [*from, *first].into_iter().chain(half).chain([*last, *to]).collect()
}

/// A zigzag of slashes between two straight ends: where a cell is one dot, a wave is not wide enough to be seen.
fn spring(from: (f64, f64), to: (f64, f64), style: Style, dots: &mut Dots) {
    let (across, down) = (to.0 - from.0, to.1 - from.1);
    let steps = across.abs().max(down.abs()).round().clamp(1.0, 1000.0);
    let straight = stamp(from, to);
    for n in 0..=steps as u32 {
        let share = f64::from(n) / steps;
        let at = (from.0 + across * share, from.1 + down * share);
        let stamp = match ((0.15..=0.85).contains(&share), n % 2) {
            (false, _) => straight,
            (true, 0) => '/',
            (true, _) => '\\',
        };
        dots.line(at, at, Pen::solid(style, stamp));
    }
}

/// A row of slashes one cell from the surface of the ground, at its right-hand side.
fn hatch(from: (f64, f64), to: (f64, f64), look: &Appearance, dots: &mut Dots) {
    let (across, down) = (to.0 - from.0, to.1 - from.1);
    let longer = across.abs().max(down.abs());
    if longer > 0.0 {
        let beside = |at: (f64, f64)| ((at.0).round() - down / longer, (at.1).round() + across / longer);
        dots.line(beside(from), beside(to), Pen::solid(look.ink(Ink::Faint), '/'));
    }
}

/// True for a circle too small for its outline to be seen as one.
fn is_small(points: &[(f64, f64)]) -> bool {
    let size = |of: fn(&(f64, f64)) -> f64| {
        let least = points.iter().map(of).fold(f64::INFINITY, f64::min);
        points.iter().map(of).fold(f64::NEG_INFINITY, f64::max) - least
    };
    size(|at| at.0) < 2.5 && size(|at| at.1) < 1.25
}

fn middle(points: &[(f64, f64)]) -> (f64, f64) {
    let sum = points.iter().fold((0.0, 0.0), |sum, at| (sum.0 + at.0, sum.1 + at.1));
    (sum.0 / points.len().max(1) as f64, sum.1 / points.len().max(1) as f64)
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
    fn of(bounds: &Box2, labels: &[Label], marker: Marker, area: Rect) -> Self {
        let bare = Self::within(bounds, marker, area, (1.0, 1.0));
        let (across, _) = dots::per_cell(marker);
        let most = f64::from(area.width) / 4.0;
        let beyond = |cells: &dyn Fn(f64, f64) -> f64| {
            let over = |label: &Label| {
                let (right, _) = label.side.direction();
                let width = label.text.width() as f64;
                // Words begin or end two cells from their point, or have it in their middle.
                let shift = if right.abs() > 0.1 { 2.0 * right.signum() } else { -width / 2.0 };
                let from = if right < -0.1 { shift - width } else { shift };
                let at = bare.dot(label.at).0 / f64::from(across) + from;
                cells(at, at + width)
            };
            labels.iter().map(over).fold(0.0, f64::max).min(most)
        };
        let left = beyond(&|from, _| -from);
        let right = beyond(&|_, to| to + 1.0 - f64::from(area.width));
        let mut fit = Self::within(bounds, marker, area, (1.0 + left, 1.0 + right));
        // What there is to spare goes to both sides.
        let (width, _) = dots::size(marker, area);
        let end = fit.dot((bounds.right, bounds.top)).0 + right * f64::from(across);
        let start = fit.dot((bounds.left, bounds.top)).0 - left * f64::from(across);
        fit.centre.0 += (f64::from(width) - 1.0 - end - start) / 2.0;
        fit
    }

    /// The largest scale that leaves so many cells free at the left and at the right.
    fn within(bounds: &Box2, marker: Marker, area: Rect, (left, right): (f64, f64)) -> Self {
        let (across, down) = dots::per_cell(marker);
        let (across, down) = (f64::from(across), f64::from(down));
        let (width, height) = dots::size(marker, area);
        let (width, height) = (f64::from(width), f64::from(height));
        let room_across = (width - 1.0 - (left + right) * across).max(1.0);
        let room_down = (height - 1.0 - down.min(height / 4.0)).max(1.0);
        // In widths of a cell to a metre.
        let aspect = dots::aspect(marker);
        let scale = (room_across / across / bounds.width()).min(aspect * room_down / down / bounds.height());
        Self {
            middle: (f64::midpoint(bounds.left, bounds.right), f64::midpoint(bounds.bottom, bounds.top)),
            centre: (f64::midpoint(left * across, width - 1.0 - right * across), (height - 1.0) / 2.0),
            scale: (scale * across, scale * down / aspect),
        }
    }

    fn dot(&self, (x, y): Point) -> (f64, f64) {
        let (across, up) = (x - self.middle.0, y - self.middle.1);
        (self.centre.0 + across * self.scale.0, self.centre.1 - up * self.scale.1)
    }
}

#[cfg(test)]
mod tests;
