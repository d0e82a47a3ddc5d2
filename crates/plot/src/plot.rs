//! Curves over an axis, in the cells of a terminal.

pub(crate) mod brush;
pub(crate) mod dots;
mod frame;
pub(crate) mod labels;
mod rows;
mod state;

use dalembert_core::{Locale, Plot, Series, exhibit::Mark};
use dalembert_report::figure::axes::Axes;
use dalembert_terminal::pixels::Picture;
use ratatui::{
    buffer::Buffer,
    layout::Rect,
    style::{Modifier, Style},
};
use unicode_width::UnicodeWidthStr;

use self::{
    brush::Brush,
    dots::{Dots, Pen, over},
    frame::{Frame, Setting},
    labels::Labels,
};
use crate::look::{Appearance, Glyph};

pub use self::state::PlotState;
pub use dalembert_terminal::glyphs::PlotMarker as Marker;

/// Reading of the cursor: `speed = 1500 rpm   X = 4.62 mm`, with `≈` between two computed points, and the marks it
/// stands on. `None` without a cursor.
pub fn readout(plot: &Plot, state: &PlotState, locale: &Locale) -> Option<String> {
    Some(Axes::seen(plot, None, &state.view)?.readout(state.read_at()?, locale).join("   "))
}

/// Draws a plot, over the faint curves and marks of one that is pinned; any size will do. What there is no room for is left out
/// in this order: titles, names of curves and axes, ticks, axes; the curves last. Where the look has pixels in place of
/// braille, the curves are pictures over the cells left blank for them, and the cursor is one of its own.
pub fn render(
    plot: &Plot,
    pinned: Option<&Plot>,
    state: &PlotState,
    look: &Appearance,
    locale: &Locale,
    area: Rect,
    buffer: &mut Buffer,
) -> Vec<Picture> {
    let area = area.intersection(buffer.area);
    if area.is_empty() {
        return Vec::new();
    }
    let locale = locale.ascii(look.ascii);
    let marker = look.marker(state.marker);
    let Some(mut axes) = Axes::seen(plot, pinned, &state.view) else {
        let words = dalembert_core::Text::new("nothing to draw").render(&locale);
        let words = look.shortened(&words, area.width.into());
        let x = area.x + (area.width - words.width() as u16) / 2;
        buffer.set_string(x, area.y + area.height / 2, words, look.dim());
        return Vec::new();
    };
    let frame = Frame::of(&axes, state, Setting { area, marker, look, locale: &locale });
    frame.draw(matches!(marker, Marker::Pixels { .. }), look, buffer);
    let zero = axes.y.passes_zero();
    (axes.x.span, axes.y.span) = (frame.across, frame.up);
    let canvas = Canvas { axes: &axes, area: frame.canvas, marker, look, zero, ticks: &frame.ticks };
    canvas.draw(state, &locale, buffer)
}

/// The part of the axis at a column of the screen, from 0 to 1, and the cells of the whole of it.
pub fn place_at(
    plot: &Plot,
    state: &PlotState,
    look: &Appearance,
    locale: &Locale,
    area: Rect,
    column: u16,
) -> Option<(f64, u16)> {
    let locale = locale.ascii(look.ascii);
    let marker = look.marker(state.marker);
    let axes = Axes::seen(plot, None, &state.view)?;
    let Frame { canvas, across, .. } =
        Frame::of(&axes, state, Setting { area, marker, look, locale: &locale });
    let inside = f64::from(column) + 0.5 - f64::from(canvas.x);
    let place = axes.x.span.place(across.value(inside / f64::from(canvas.width)))?;
    (canvas.width > 0).then_some((place, canvas.width))
}

/// The pen of the curve of that place: a colour of its own, or, where there are no more, signs on it.
pub(crate) fn pen(n: usize, marker: Marker, look: &Appearance) -> Pen {
    let colored = n < look.curves();
    let stamp = match marker {
        Marker::Ascii => point(n, true),
        _ if colored => '•',
        _ => point(n, false),
    };
    let finer = matches!(marker, Marker::Braille | Marker::HalfBlock | Marker::Pixels { .. });
    // Not at the same place on every curve: some begin at one point.
    let mark = (finer && !colored).then(|| (point(n, false), 3 + 5 * (n as u32 % 4)));
    Pen { mark, curve: Some(n), ..Pen::solid(look.series(n), stamp) }
}

/// The pen of the curves of a pinned plot.
pub(crate) fn pinned_pen(look: &Appearance) -> Pen {
    // Without colours gaps alone tell it from the present curve.
    let dash = if look.curves() == 0 { (1, 3) } else { (2, 1) };
    Pen { dash, ..Pen::solid(look.dim(), if look.ascii { '.' } else { '·' }) }
}

/// Sign of a separate point of that curve.
pub(crate) fn point(n: usize, ascii: bool) -> char {
    const UNICODE: [char; 8] = ['•', '◆', '▲', '■', '○', '◇', '△', '□'];
    const ASCII: [char; 8] = ['*', '+', 'x', 'o', '#', '%', '&', '$'];
    if ascii { ASCII[n % ASCII.len()] } else { UNICODE[n % UNICODE.len()] }
}

/// Shade of permitted and of forbidden ranges: no sign of the grid or of a curve.
pub(crate) fn shade(permitted: bool, look: &Appearance) -> (char, Style) {
    let (unicode, ascii, style) =
        if permitted { ('░', '=', look.good()) } else { ('╱', '/', look.error()) };
    (if look.ascii { ascii } else { unicode }, style.remove_modifier(Modifier::BOLD))
}

/// The inside of the axes.
struct Canvas<'a> {
    axes: &'a Axes<'a>,
    area: Rect,
    marker: Marker,
    look: &'a Appearance,
    /// True where zero lies among the values.
    zero: bool,
    /// The labelled ticks, as parts of the axes: across and up.
    ticks: &'a [Vec<f64>; 2],
}

impl Canvas<'_> {
    fn draw(&self, state: &PlotState, locale: &Locale, buffer: &mut Buffer) -> Vec<Picture> {
        if self.area.is_empty() {
            return Vec::new();
        }
        let (plot, look) = (self.axes.plot, self.look);
        let mut labels = Labels::new(self.area);
        if !matches!(self.marker, Marker::Pixels { .. }) {
            self.bands(buffer);
        }
        let mut dots = Dots::new(self.area, self.marker);
        self.levels(&mut dots);
        let faint = pinned_pen(look);
        for series in self.axes.pinned.iter().flat_map(|pinned| &pinned.series) {
            if series.joined {
                self.curve(series, faint, &mut dots);
            } else {
                for at in &series.points {
                    if let Some(dot) = self.dot(&dots, *at) {
                        dots.line(dot, dot, faint);
                    }
                }
            }
        }
        for (n, series) in plot.series.iter().enumerate().filter(|(_, series)| series.joined) {
            self.curve(series, pen(n, self.marker, look), &mut dots);
        }
        dots.draw(buffer);
        for (n, series) in plot.series.iter().enumerate().filter(|(_, series)| !series.joined) {
            for at in &series.points {
                if let Some(cell) = self.cell(&dots, *at) {
                    self.sign((*at, cell), point(n, look.ascii), look.series(n), &mut dots, buffer);
                }
            }
        }
        for mark in self.axes.pinned.iter().flat_map(|pinned| &pinned.marks) {
            let sign = if look.ascii { 'o' } else { '○' };
            if let Some(cell) = self.cell(&dots, mark.at) {
                self.sign((mark.at, cell), sign, faint.style, &mut dots, buffer);
                labels.reserve(cell);
            }
        }
        let cursor = self.cursor(state, &dots, &mut labels, buffer);
        let style = Style::new().add_modifier(Modifier::BOLD);
        let marks = self.marks(&dots);
        for (cell, mark) in &marks {
            self.sign((mark.at, *cell), if look.ascii { '@' } else { '●' }, style, &mut dots, buffer);
            labels.reserve(*cell);
        }
        for (cell, mark) in &marks {
            let words = look.shortened(&mark.label.render(locale), self.area.width.into());
            labels.beside(&words, style, *cell, |x, y| dots.is_free(x, y));
        }
        self.level_labels(&dots, locale, &mut labels);
        self.band_labels(&dots, locale, &mut labels);
        labels.draw(buffer);
        if let Some(brush) = dots.brush() {
            self.ground(brush);
            labels.cells().for_each(|cells| brush.clear(cells));
        }
        dots.picture(look).into_iter().chain(cursor).collect()
    }

    /// The part of the axes at a point, for any finite point the scales can show.
    fn place(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        Some((self.axes.x.of(x)?, self.axes.y.of(y)?))
    }

    /// Draws a sign at a point in pixels, or in the cell that is its own.
    fn sign(
        &self,
        (at, cell): ((f64, f64), (u16, u16)),
        sign: char,
        style: Style,
        dots: &mut Dots,
        buffer: &mut Buffer,
    ) {
        match dots.dot_of(self.place(at)) {
            Some((at, brush)) => brush.sign(at, sign, style.into()),
            None => over(buffer, cell, sign, style),
        }
    }

    /// The dot of a point, for any finite point the scales can show.
    fn dot(&self, dots: &Dots, at: (f64, f64)) -> Option<(f64, f64)> {
        Some(dots.at_place(self.place(at)?))
    }

    /// The cell of a point inside the axes.
    fn cell(&self, dots: &Dots, at: (f64, f64)) -> Option<(u16, u16)> {
        let near = -1e-9..=1.0 + 1e-9;
        let inside = near.contains(&self.axes.x.of(at.0)?) && near.contains(&self.axes.y.of(at.1)?);
        self.dot(dots, at).filter(|_| inside).map(|dot| dots.cell_of(dot))
    }

    /// The marks inside the axes, each in a cell of its own: of several that fall in one, the next stands in the cell
    /// beside it on its side, so that as many are seen as there are.
    fn marks(&self, dots: &Dots) -> Vec<((u16, u16), &Mark)> {
        let mut placed: Vec<((u16, u16), &Mark)> = Vec::new();
        for mark in &self.axes.plot.marks {
            let Some((x, y)) = self.cell(dots, mark.at) else { continue };
            let there = placed.iter().find(|(cell, other)| *cell == (x, y) && other.at != mark.at);
            let (right, left) = ((x.saturating_add(1), y), (x.wrapping_sub(1), y));
            let sides = match there {
                None => [(x, y); 3],
                Some((_, other)) if mark.at.0 < other.at.0 => [left, right, (x, y)],
                Some(_) => [right, left, (x, y)],
            };
            let is_free = |cell: &(u16, u16)| {
                self.area.contains((*cell).into()) && placed.iter().all(|(other, _)| other != cell)
            };
            let cell = sides.into_iter().find(is_free).unwrap_or((x, y));
            placed.push((cell, mark));
        }
        placed
    }

    /// Points of one column of dots are drawn as their first, least, largest and last: no peak is lost, and a
    /// million points cost what they must.
    fn curve(&self, series: &Series, pen: Pen, dots: &mut Dots) {
        struct Column {
            at: f64,
            least: f64,
            largest: f64,
            last: (f64, f64),
        }
        let mut column: Option<Column> = None;
        for point in &series.points {
            let Some(dot) = self.dot(dots, *point) else {
                if let Some(column) = column.take() {
                    dots.line((column.at, column.least), (column.at, column.largest), pen);
                }
                dots.lift();
                continue;
            };
            match &mut column {
                Some(column) if column.at == dot.0.round() => {
                    column.least = column.least.min(dot.1);
                    column.largest = column.largest.max(dot.1);
                    column.last = dot;
                }
                _ => {
                    let from = column.take().map(|column| {
                        if column.least < column.largest {
                            dots.line((column.at, column.least), (column.at, column.largest), pen);
                        }
                        column.last
                    });
                    dots.line(from.unwrap_or(dot), dot, pen);
                    column = Some(Column { at: dot.0.round(), least: dot.1, largest: dot.1, last: dot });
                }
            }
        }
        if let Some(column) = column {
            dots.line((column.at, column.least), (column.at, column.largest), pen);
        }
        dots.lift();
    }

    fn levels(&self, dots: &mut Dots) {
        let mut level = |y: f64, pen: Pen| {
            if let Some(place) = self.axes.y.of(y).filter(|place| (0.0..=1.0).contains(place)) {
                let [left, right] = [0.0, 1.0].map(|across| dots.at_place((across, place)));
                dots.lift();
                dots.line(left, right, pen);
            }
        };
        let stamp = if self.look.ascii { '-' } else { '╌' };
        // In pixels, dashes are as long as in braille.
        let across = match self.marker {
            Marker::Pixels { .. } => 2,
            marker => dots::per_cell(marker).0.into(),
        };
        if self.zero {
            level(0.0, Pen { dash: (1, 2 * across - 1), ..Pen::solid(self.look.dim(), stamp) });
        }
        for limit in &self.axes.plot.levels {
            level(limit.y, Pen { dash: (2 * across, across), ..Pen::solid(self.look.warning(), stamp) });
        }
    }

    /// The name of each level at its right end; at the edge, with an arrow and its value, where it lies beyond.
    fn level_labels(&self, dots: &Dots, locale: &Locale, labels: &mut Labels) {
        for level in self.axes.named_levels(locale) {
            let Some(place) = self.axes.y.of(level.y) else { continue };
            let words = level.label.render(locale);
            let beyond = |glyph| {
                format!("{} {words}: {}", self.look.glyph(glyph), self.axes.y.write(level.y, locale.style))
            };
            let (words, rows): (String, &[i32]) = match place {
                ..0.0 => (beyond(Glyph::Down), &[0, -1, -2]),
                0.0..=1.0 => (words, &[-1, 1, 0]),
                _ => (beyond(Glyph::Up), &[0, 1, 2]),
            };
            let words = self.look.shortened(&words, self.area.width.into());
            let row = i32::from(dots.cell_of(dots.at_place((0.0, place.clamp(0.0, 1.0)))).1);
            let right = i32::from(self.area.right()) - words.width() as i32;
            let left = i32::from(self.area.x);
            let places = rows.iter().flat_map(|up| [right, left].map(|x| (x, row + up)));
            labels.put(&words, self.look.warning(), places, |_| 0, |x, y| dots.is_free(x, y));
        }
    }

    /// The columns of the ends of a band.
    fn columns(&self, ends: [f64; 2]) -> [u16; 2] {
        let last = f64::from(self.area.width) - 1.0;
        ends.map(|place| (place * last).round() as u16)
    }

    /// Forbidden ranges are hatched, permitted ones have a bar at the top and at the bottom.
    fn bands(&self, buffer: &mut Buffer) {
        let look = self.look;
        for band in &self.axes.plot.bands {
            let Some(ends) = self.axes.band(band.from, band.to) else { continue };
            let [first, last] = self.columns(ends);
            let (shade, style) = shade(band.permitted, look);
            let style = style.add_modifier(Modifier::DIM);
            for row in 0..self.area.height {
                for column in first..=last {
                    let drawn = if band.permitted {
                        row == 0 || row + 1 == self.area.height
                    } else {
                        (column + row) % 3 == 0
                    };
                    if drawn {
                        buffer[(self.area.x + column, self.area.y + row)].set_char(shade).set_style(style);
                    }
                }
            }
        }
    }

    /// Ranges and lines of the ticks, under whatever is drawn in pixels already.
    fn ground(&self, brush: &mut Brush) {
        let (width, height) = brush.size();
        for band in &self.axes.plot.bands {
            let Some([from, to]) = self.axes.band(band.from, band.to) else { continue };
            let across = (from * (width - 1.0), to * (width - 1.0) + 1.0);
            let (_, style) = shade(band.permitted, self.look);
            if band.permitted {
                brush.shade(across, (0.0, height), style.into(), |_, _| 0.13);
            } else {
                // Hatched, as in cells.
                let pitch = (width / f64::from(self.area.width)).max(4.0) as usize;
                brush.shade(across, (0.0, height), style.into(), |x, y| {
                    if (x + y) % pitch < pitch.div_ceil(8) { 0.4 } else { 0.07 }
                });
            }
        }
        let faint = self.look.dim();
        for place in &self.ticks[0] {
            let x = (place * (width - 1.0)).round();
            brush.shade((x, x + 1.0), (0.0, height), faint.into(), |_, y| if y % 4 < 2 { 0.5 } else { 0.0 });
        }
        for place in &self.ticks[1] {
            let y = ((1.0 - place) * (height - 1.0)).round();
            brush.shade((0.0, width), (y, y + 1.0), faint.into(), |x, _| if x % 4 < 2 { 0.5 } else { 0.0 });
        }
    }

    /// The name of each band in it.
    fn band_labels(&self, dots: &Dots, locale: &Locale, labels: &mut Labels) {
        for (band, ends) in self.axes.named_bands(locale) {
            let [first, last] = self.columns(ends);
            let style = if band.permitted { self.look.good() } else { self.look.error() };
            let words = self.look.shortened(&band.label.render(locale), self.area.width.into());
            let middle = (i32::from(first) + i32::from(last) + 1 - words.width() as i32) / 2;
            // The name of a narrow band reaches beyond it, but not beyond the axes.
            let most = i32::from(self.area.width) - words.width() as i32;
            let x = i32::from(self.area.x) + middle.clamp(0, most.max(0));
            let rows = (0..4).chain([i32::from(self.area.height) - 1]);
            let places = rows.map(|row| (x, i32::from(self.area.y) + row));
            labels.put(&words, style, places, |_| 0, |x, y| dots.is_free(x, y));
        }
    }

    /// A line down the plot, with a point on every curve it reads; in pixels a picture of its own, so that a cursor that
    /// moves leaves the curves as they are.
    fn cursor(
        &self,
        state: &PlotState,
        dots: &Dots,
        labels: &mut Labels,
        buffer: &mut Buffer,
    ) -> Option<Picture> {
        let cursor = self.axes.within(state.read_at()?)?;
        let place = self.axes.x.of(cursor)?;
        let (x, _) = dots.cell_of(dots.at_place((place, 0.0)));
        let style = Style::new().add_modifier(Modifier::BOLD);
        let strip = Rect { x: x.saturating_sub(1), width: 3, ..self.area }.intersection(self.area);
        let mut strip = match self.marker {
            Marker::Pixels { across, down } => Some((Brush::new(strip, (across, down)), strip)),
            _ => None,
        };
        let in_strip = |(across, down): (f64, f64), strip: Rect| {
            (across - f64::from(strip.x - self.area.x) * f64::from(dots.per_cell().0), down)
        };
        if let Some((brush, strip)) = &mut strip {
            let (at, _) = in_strip(dots.at_place((place, 0.0)), *strip);
            let (_, height) = brush.size();
            brush.shade((at.round(), at.round() + 1.0), (0.0, height), style.into(), |_, _| 1.0);
        } else {
            for y in (self.area.y..self.area.bottom()).filter(|y| dots.is_free(x, *y)) {
                over(buffer, (x, y), if self.look.ascii { '|' } else { '│' }, style);
            }
        }
        for (n, series) in self.axes.plot.series.iter().enumerate() {
            let Some(reading) = self.axes.read(series, cursor) else { continue };
            let at = (cursor, reading.y);
            let (Some(cell), Some(dot)) = (self.cell(dots, at), self.dot(dots, at)) else { continue };
            let style = self.look.series(n).add_modifier(Modifier::BOLD);
            match &mut strip {
                Some((brush, strip)) => brush.sign(in_strip(dot, *strip), point(n, false), style.into()),
                None => over(buffer, cell, if self.look.ascii { 'O' } else { point(n, false) }, style),
            }
            labels.reserve(cell);
        }
        strip.map(|(brush, _)| brush.picture(self.look))
    }
}

#[cfg(test)]
mod tests;
