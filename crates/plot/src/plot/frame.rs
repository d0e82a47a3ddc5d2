//! Surroundings of the curves: titles, legend, axes, ticks, the reading of the cursor.

use dalembert_core::{Locale, Text};
use dalembert_report::figure::{
    axes::Axes,
    ruler::AxisTitle,
    ticks::{Span, Ticks},
};
use dalembert_units::Style as NumberStyle;
use ratatui::{buffer::Buffer, layout::Rect, style::Style};
use unicode_width::UnicodeWidthStr;

use super::{
    Marker, PlotState,
    dots::{Pen, aspect, per_cell},
    pen, pinned_pen, point, rows, shade,
};
use crate::{look::Appearance, wrap};

/// Words and ticks round a canvas, each at its place.
pub(crate) struct Frame {
    /// Area of the curves.
    pub(crate) canvas: Rect,
    /// Span of the vertical axis over the rows of the canvas: no less than the curves need.
    pub(crate) up: Span,
    /// That of the horizontal axis over its columns: with equal scales as much to a length as up.
    pub(crate) across: Span,
    words: Vec<(u16, u16, String, Style)>,
    /// The cells of the axes: a column left of the canvas and a row below it, where there is room.
    lines: Vec<(u16, u16, &'static str)>,
    /// Faint points where ticks of both axes meet.
    grid: Vec<(u16, u16)>,
    /// The labelled ticks, as parts of the axes: across and up.
    pub(crate) ticks: [Vec<f64>; 2],
}

/// Number of rows for each part: none where there is no room.
struct Rows {
    title: u16,
    head: u16,
    legend: u16,
    axis: u16,
    labels: u16,
    foot: u16,
    readout: u16,
}

/// Area, marks, look and language of a plot.
#[derive(Clone, Copy)]
pub(crate) struct Setting<'a> {
    pub(crate) area: Rect,
    pub(crate) marker: Marker,
    pub(crate) look: &'a Appearance,
    pub(crate) locale: &'a Locale,
}

impl Frame {
    pub(crate) fn of(axes: &Axes, state: &PlotState, setting: Setting) -> Self {
        let Setting { area, marker, look, locale } = setting;
        let height = area.height;
        let from = |least: u16| u16::from(height >= least);
        let readout = state.read_at().map_or_else(Vec::new, |cursor| axes.readout(cursor, locale));
        // The name of the axis and the legend share a row if they can. A low plot has no second one for shades: their
        // names stand in them.
        let head = axes.y.title(axes.y.span.ticks(3, locale.style).ten, locale);
        let fits = |legend: &[Sample]| head.whole().width() + 2 + legend_width(legend) <= area.width.into();
        let mut legend = [curves(axes, marker, look, locale), shades(axes, look, locale)].concat();
        if height < 14 && !fits(&legend) {
            legend = curves(axes, marker, look, locale);
        }
        let beside = fits(&legend);
        // A title that is too long goes on in further rows where there is room for them.
        let title = axes.plot.title.render(locale);
        let title = wrap::title(&title, area.width.into(), wrap::title_rows(height), look);
        let most = if height > 15 { 2 } else { 1 };
        let axis_title = |title: &AxisTitle| axis_lines(title, area.width.into(), most, look);
        let foot = axes.x.title(axes.x.span.ticks(3, locale.style).ten, locale);
        let mut rows = Rows {
            title: from(10) * title.len() as u16,
            head: from(6) * axis_title(&head).len() as u16,
            legend: if legend.is_empty() || beside {
                0
            } else {
                legend_rows(&legend, area).min(from(9) * height.div_ceil(if height < 14 { 8 } else { 5 }))
            },
            axis: from(4),
            labels: from(5),
            foot: from(8) * axis_title(&foot).len() as u16,
            readout: 0,
        };
        // All that the cursor reads, as long as the curves keep a third of the rows.
        let others = rows.title + rows.head + rows.legend + rows.axis + rows.labels + rows.foot;
        let spare = height.saturating_sub(others + (height / 3).max(2));
        let readout = flow(&readout, area.width.into(), spare.max(1).into(), look);
        rows.readout = if height >= 3 { readout.len() as u16 } else { 0 };
        let above = rows.title + rows.head + rows.legend;
        let below = rows.axis + rows.labels + rows.foot + rows.readout;
        let inner = Rect { y: area.y + above, height: height.saturating_sub(above + below), ..area };
        let sides = Sides { axes, inner, marker, style: locale.style };
        let Measured { canvas, gutter, up, across, ticks } = sides.measured(rows.axis > 0, rows.head > 0);
        let mut frame = Self {
            canvas,
            up,
            across,
            words: Vec::new(),
            lines: Vec::new(),
            grid: Vec::new(),
            ticks: [Vec::new(), Vec::new()],
        };
        for (line, y) in title.into_iter().zip(area.y..area.y + rows.title) {
            frame.words.push((area.x, y, line, look.title()));
        }
        if rows.head > 0 {
            let y = area.y + rows.title;
            // Where both share a row, that there are curves is seen.
            let shares = if rows.legend == 0 && !legend.is_empty() && !beside { 4 } else { 0 };
            let width = usize::from(area.width).saturating_sub(shares);
            let head = axis_lines(&axes.y.title(ticks.ten, locale), width, rows.head, look);
            let after = area.x + head.last().map_or(0, |line| line.width()) as u16 + 2;
            for (line, y) in head.into_iter().zip(y..) {
                frame.words.push((area.x, y, line, look.dim()));
            }
            let y = y + rows.head - 1;
            match rows.legend {
                0 if beside => frame.legend(&legend, area.right() - legend_width(&legend) as u16, y, setting),
                0 => frame.legend(&legend, after, y, setting),
                most => {
                    let mut rest = &legend[..];
                    for row in 1..=most {
                        let here = if row == most { rest.len() } else { legend_row(rest, area) };
                        frame.legend(&rest[..here], area.x, y + row, setting);
                        rest = &rest[here..];
                    }
                }
            }
        }
        let rows_of_ticks = frame.y_axis(&ticks, gutter, setting);
        if rows.axis > 0 {
            for x in frame.x_axis(axes, gutter, &rows, setting) {
                frame.grid.extend(rows_of_ticks.iter().map(|y| (x, *y)));
            }
        }
        for (n, line) in readout.into_iter().take(rows.readout.into()).enumerate() {
            let y = area.bottom() - rows.readout + n as u16;
            frame.words.push((area.x, y, line, look.answer()));
        }
        frame
    }

    pub(crate) fn draw(&self, is_picture: bool, look: &Appearance, buffer: &mut Buffer) {
        // In pixels they are lines of the picture, at the place of the tick and not in the middle of its cell.
        for at in self.grid.iter().filter(|_| !is_picture) {
            buffer[*at].set_char(if look.ascii { '.' } else { '·' }).set_style(look.dim());
        }
        for (x, y, symbol) in &self.lines {
            let symbol = if is_picture && *symbol == "┬" { "─" } else { symbol };
            buffer[(*x, *y)].set_symbol(symbol).set_style(look.dim());
        }
        for (x, y, words, style) in &self.words {
            buffer.set_string(*x, *y, words, *style);
        }
    }

    /// The rows of its labelled ticks.
    fn y_axis(&mut self, ticks: &Ticks, gutter: u16, setting: Setting) -> Vec<u16> {
        let Setting { marker, look, .. } = setting;
        let mut rows = Vec::new();
        if gutter == 0 {
            return rows;
        }
        let (canvas, x) = (self.canvas, self.canvas.x - 1);
        let (line, minor, major) = if look.ascii { ("|", "|", "+") } else { ("│", "┤", "┤") };
        self.lines.extend((canvas.y..canvas.bottom()).map(|y| (x, y, line)));
        for tick in &ticks.ticks {
            let Some(row) = self.up.place(tick.at).and_then(|place| row(canvas, marker, place)) else {
                continue;
            };
            self.lines.push((x, row, if tick.label.is_empty() { minor } else { major }));
            let start = x.saturating_sub(tick.label.width() as u16);
            self.words.push((start, row, tick.label.clone(), look.dim()));
            if !tick.label.is_empty() {
                rows.push(row);
                self.ticks[1].extend(self.up.place(tick.at));
            }
        }
        rows
    }

    /// The columns of its labelled ticks.
    fn x_axis(&mut self, axes: &Axes, gutter: u16, rows: &Rows, setting: Setting) -> Vec<u16> {
        let Setting { area, marker, look, locale } = setting;
        let canvas = self.canvas;
        let y = canvas.bottom();
        let (corner, line, minor, major) =
            if look.ascii { ("+", "-", "-", "+") } else { ("└", "─", "┴", "┬") };
        if gutter > 0 {
            self.lines.push((canvas.x - 1, y, corner));
        }
        self.lines.extend((canvas.x..canvas.right()).map(|x| (x, y, line)));
        let span = self.across;
        let place = |at: f64| span.place(at).and_then(|place| column(canvas, marker, place));
        // A label stands under its tick, or as near as the edges let it.
        let start = |at: u16, width: u16| {
            let last = area.right().saturating_sub(width).max(area.x);
            at.saturating_sub(width / 2).clamp(area.x, last)
        };
        let fit = |ticks: &Ticks| {
            let mut free = area.x;
            ticks.ticks.iter().filter(|tick| !tick.label.is_empty()).all(|tick| {
                let Some(at) = place(tick.at) else { return false };
                let width = tick.label.width() as u16;
                let (from, to) = (start(at, width), start(at, width) + width);
                let fits = from >= free && to <= area.right() && (from..to).contains(&at);
                free = to + 2;
                fits
            })
        };
        let most = usize::from(canvas.width / 6).clamp(2, 12);
        let ticks = span.ticks_that_fit(most, locale.style, fit);
        for tick in &ticks.ticks {
            let Some(x) = place(tick.at) else { continue };
            self.lines.push((x, y, if tick.label.is_empty() { minor } else { major }));
            if rows.labels > 0 && !tick.label.is_empty() {
                let x = start(x, tick.label.width() as u16);
                self.words.push((x, y + 1, tick.label.clone(), look.dim()));
            }
        }
        let title = axes.x.title(ticks.ten, locale);
        // On the axis itself where there is no row for it.
        let (first, width) = if rows.foot > 0 { (y + 2, area.width) } else { (y, canvas.width) };
        let lines = axis_lines(&title, width.into(), rows.foot.max(1), look);
        for (line, y) in lines.into_iter().zip(first..) {
            self.words.push((area.right() - line.width() as u16, y, line, look.dim()));
        }
        let labelled = ticks.ticks.iter().filter(|tick| !tick.label.is_empty());
        self.ticks[0].extend(labelled.clone().filter_map(|tick| span.place(tick.at)));
        labelled.filter_map(|tick| place(tick.at)).collect()
    }

    /// A row of the legend; where not all have room, it ends in the number of curves that it leaves out.
    fn legend(&mut self, legend: &[Sample], x: u16, y: u16, setting: Setting) {
        if legend.is_empty() {
            return;
        }
        let Setting { area, look, .. } = setting;
        let room = usize::from(area.right().saturating_sub(x));
        let more = |shown: usize| match legend.len() - shown {
            0 => String::new(),
            left => format!("+{left}"),
        };
        let fits = |shown: &usize| {
            let more = more(*shown).width();
            legend_width(&legend[..*shown]) + if more > 0 { more + 2 } else { 0 } <= room
        };
        let whole = (1..=legend.len()).rev().find(fits);
        // One that is too long alone is shortened.
        let first = legend.first().map_or(0, |(sample, ..)| sample.width() + 4 + 2 + more(1).width());
        let shown = whole.unwrap_or(usize::from(first <= room));
        let mut x = x;
        for (sample, name, style) in &legend[..shown] {
            self.words.push((x, y, sample.clone(), *style));
            let left = usize::from(area.right().saturating_sub(x)).saturating_sub(sample.width() + 1);
            let left = if whole.is_some() { left } else { left.saturating_sub(2 + more(1).width()) };
            let name = look.shortened(name, left);
            let next = x + (sample.width() + name.width()) as u16 + 3;
            self.words.push((x + sample.width() as u16 + 1, y, name, Style::new()));
            x = next;
        }
        let more = more(shown);
        if !more.is_empty() {
            self.words.push((
                area.right().saturating_sub(more.width() as u16).max(area.x),
                y,
                more,
                look.dim(),
            ));
        }
    }
}

/// The room of a canvas and what stands left of it.
struct Sides<'a> {
    axes: &'a Axes<'a>,
    inner: Rect,
    marker: Marker,
    style: NumberStyle,
}

/// A canvas with its spans; `gutter` is the width of what stands left of it.
struct Measured {
    canvas: Rect,
    gutter: u16,
    up: Span,
    across: Span,
    ticks: Ticks,
}

impl Sides<'_> {
    /// The canvas in which both axes show what they must. Without a title no power of ten may be left out.
    fn measured(&self, has_axis: bool, has_title: bool) -> Measured {
        let Self { axes, inner, marker, style } = *self;
        let rows = rows::Rows { rows: inner.height, dots: per_cell(marker).1 };
        let is_equal = axes.has_equal_scales() && !inner.is_empty();
        // A narrower canvas than this one needs more of the vertical axis, so that the first width that does is found.
        let mut width = inner.width;
        loop {
            let canvas = Rect { width, ..inner };
            let wanted = if is_equal { axes.equal_up(lengths(canvas, marker)) } else { axes.y.span };
            let (up, ticks) = rows.with_ticks(wanted, style);
            let gutter = ticks.ticks.iter().map(|tick| tick.label.width()).max().unwrap_or(0) as u16 + 1;
            let is_readable = has_axis && (has_title || ticks.ten == 0);
            let gutter = if is_readable && gutter + 8 <= inner.width { gutter } else { 0 };
            let canvas = Rect { x: inner.x + gutter, width: inner.width - gutter, ..inner };
            if !is_equal || canvas.width >= width {
                let across =
                    if is_equal { axes.equal_across(&up, lengths(canvas, marker)) } else { axes.x.span };
                return Measured { canvas, gutter, up, across, ticks };
            }
            width = canvas.width;
        }
    }
}

/// From the first dot of a canvas to the last one, across and down, in widths of a cell; a cell is twice as high.
fn lengths(canvas: Rect, marker: Marker) -> [f64; 2] {
    let per_cell = per_cell(marker);
    let length = |cells: u16, dots: u16| f64::from(cells) - 1.0 / f64::from(dots);
    let [across, down] =
        [length(canvas.width, per_cell.0), aspect(marker) * length(canvas.height, per_cell.1)];
    [across.max(0.5), down.max(0.5)]
}

/// The title of an axis in at most so many lines; of one that is too long the name is shortened, never the unit.
fn axis_lines(title: &AxisTitle, width: usize, most: u16, look: &Appearance) -> Vec<String> {
    let unbroken = AxisTitle { unit: title.unit.replace(' ', "\u{A0}"), ..title.clone() };
    let whole = wrap::words(&unbroken.whole(), width);
    if whole.len() <= most.into() && title.unit.width() <= width {
        return whole;
    }
    let name = look.shortened(&title.name, width.saturating_sub(title.unit.width() + 1));
    vec![look.shortened(&AxisTitle { name, ..title.clone() }.whole(), width)]
}

/// The column of a place on the horizontal axis: that of its dots.
fn column(canvas: Rect, marker: Marker, place: f64) -> Option<u16> {
    cell(canvas.x, canvas.width, per_cell(marker).0, place)
}

/// The row of a place on the vertical axis.
fn row(canvas: Rect, marker: Marker, place: f64) -> Option<u16> {
    cell(canvas.y, canvas.height, per_cell(marker).1, 1.0 - place)
}

fn cell(first: u16, cells: u16, dots: u16, place: f64) -> Option<u16> {
    let dot = (place * (f64::from(cells) * f64::from(dots) - 1.0)).round();
    let inside = cells > 0 && (-1e-6..=1.0 + 1e-6).contains(&place);
    inside.then(|| first + (dot.max(0.0) as u16 / dots).min(cells - 1))
}

/// An entry of a legend: what it explains, the explanation, and the style of the first.
type Sample = (String, String, Style);

fn legend_width(legend: &[Sample]) -> usize {
    let width = legend.iter().map(|(sample, name, _)| sample.width() + name.width() + 3).sum::<usize>();
    width.saturating_sub(2)
}

/// Number of entries that a row holds, one at least.
fn legend_row(legend: &[Sample], area: Rect) -> usize {
    (1..=legend.len()).take_while(|n| legend_width(&legend[..*n]) <= area.width.into()).last().unwrap_or(1)
}

/// In how many rows a legend is whole.
fn legend_rows(legend: &[Sample], area: Rect) -> u16 {
    let (mut rest, mut rows) = (legend, 0);
    while !rest.is_empty() {
        rest = &rest[legend_row(rest, area)..];
        rows += 1;
    }
    rows
}

/// The curves by their names; empty where one curve needs no name.
fn curves(axes: &Axes, marker: Marker, look: &Appearance, locale: &Locale) -> Vec<Sample> {
    let series = &axes.plot.series;
    if series.len() < 2 && axes.pinned.is_none() {
        return Vec::new();
    }
    let pinned = axes.pinned.map(|_| {
        let has_marks = axes.pinned.is_some_and(|pinned| !pinned.marks.is_empty());
        let sample = match (look.ascii, has_marks) {
            (true, _) => ".",
            (false, true) => "┄○",
            (false, false) => "┄┄",
        };
        (sample.into(), Text::new("before").render(locale), pinned_pen(look).style)
    });
    let sample = |n: usize, joined: bool| match (joined, pen(n, marker, look)) {
        (false, _) => point(n, look.ascii).to_string(),
        (true, Pen { mark: Some((mark, _)), .. }) => format!("─{mark}─"),
        (true, Pen { stamp, .. }) if matches!(marker, Marker::Dot | Marker::Ascii) => stamp.to_string(),
        (true, _) => "──".into(),
    };
    series
        .iter()
        .enumerate()
        .map(|(n, series)| (sample(n, series.joined), series.label.render(locale), look.series(n)))
        .chain(pinned)
        .collect()
}

/// Meaning of the shades that there are: bands of one name by that name, others by being permitted or forbidden.
fn shades(axes: &Axes, look: &Appearance, locale: &Locale) -> Vec<Sample> {
    let meaning = |(permitted, words): (bool, &'static str)| {
        let mut names =
            axes.plot.bands.iter().filter(|band| band.permitted == permitted).map(|band| &band.label);
        let first = names.next()?;
        let words = if names.all(|name| name == first) { first.clone() } else { Text::new(words) };
        let (shade, style) = shade(permitted, look);
        Some((shade.to_string(), words.render(locale), style))
    };
    [(true, "permitted"), (false, "forbidden")].into_iter().filter_map(meaning).collect()
}

/// Parts side by side, in no more than `most` lines; the last says with an ellipsis that there are more.
fn flow(parts: &[String], width: usize, most: usize, look: &Appearance) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        let full = lines.len() == most;
        match lines.last_mut() {
            Some(line) if full || line.width() + 3 + part.width() <= width => *line += &format!("   {part}"),
            _ => lines.push(part.clone()),
        }
    }
    lines.iter().map(|line| look.shortened(line, width)).collect()
}
