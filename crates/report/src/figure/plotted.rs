//! A plot as a picture.

use dalembert_core::{Locale, Plot, Series, Text, exhibit::clipped};

use super::{
    Seen,
    axes::Axes,
    labels::{Labels, width},
    picture::{Anchor, LineStyle, Picture, PictureElement, Tone, WORDS},
    ticks::{Tick, Ticks},
};

const WIDTH: f64 = 640.0;
/// The height of what is inside the axes.
const INSIDE: f64 = 300.0;
/// Room that the numbers of a vertical axis may take beside equal scales.
const WIDEST: f64 = 90.0;
/// A line of words.
const LINE: f64 = 1.5 * WORDS;

/// Picture of the visible part of a plot with axes, ticks, legend, names and cursor readings; `None` where there is
/// nothing to draw.
pub(super) fn picture(plot: &Plot, seen: &Seen<'_>, locale: &Locale) -> Option<Picture> {
    let mut axes = Axes::seen(plot, seen.pinned, &seen.view)?;
    let longest = |ticks: &Ticks| ticks.ticks.iter().map(|tick| width(&tick.label)).fold(0.0, f64::max);
    let right = WIDTH - 20.0;
    if axes.has_equal_scales() {
        axes.y.span = axes.equal_up([right - WIDEST, INSIDE]);
    }
    let up = axes.y.span.ticks(7, locale.style);
    let left = longest(&up) + 16.0;
    if axes.has_equal_scales() {
        axes.x.span = axes.equal_across(&axes.y.span, [right - left, INSIDE]);
    }
    let across = axes.x.span.ticks_that_fit(10, locale.style, |ticks| {
        let labelled = ticks.ticks.iter().filter(|tick| !tick.label.is_empty()).count();
        (longest(ticks) + 14.0) * labelled as f64 <= right - left
    });
    let legend = Legend::of(&axes, locale, right - 12.0);
    let top = LINE + legend.height + 8.0;
    let area = Area { left, top, right, bottom: top + INSIDE, axes: &axes };
    let mut parts = Vec::new();
    area.bands(&mut parts);
    area.grid(&across.ticks, &up.ticks, &mut parts);
    let mut labels = Labels::new((area.left + 3.0, area.top + 3.0, area.right - 3.0, area.bottom - 3.0));
    area.levels(locale, &mut labels, &mut parts);
    for series in seen.pinned.iter().flat_map(|pinned| &pinned.series) {
        area.curve(Tone::Faint, LineStyle::Short, series, &mut labels, &mut parts);
    }
    for (n, series) in plot.series.iter().enumerate() {
        area.curve(Tone::Curve(n), LineStyle::of_curve(n), series, &mut labels, &mut parts);
    }
    let readout = seen.cursor.map_or_else(Vec::new, |cursor| area.cursor(cursor, locale, &mut parts));
    for mark in seen.pinned.iter().flat_map(|pinned| &pinned.marks) {
        if let Some(at) = area.inside(mark.at) {
            labels.avoid(&[at]);
            parts.push(PictureElement::Disc { at, radius: 4.0, tone: Tone::Faint });
        }
    }
    for mark in &plot.marks {
        if let Some(at) = area.inside(mark.at) {
            labels.avoid(&[at]);
            parts.push(PictureElement::Disc { at, radius: 4.0, tone: Tone::Ink });
        }
    }
    for mark in &plot.marks {
        if let Some(at) = area.inside(mark.at) {
            labels.beside(&mark.label.render(locale), Tone::Ink, at);
        }
    }
    area.band_names(locale, &mut labels);
    parts.append(&mut labels.parts);
    let words = |at, anchor, text| PictureElement::Words { at, anchor, text, tone: Tone::Ink };
    parts.push(words((12.0, LINE - 4.0), Anchor::Start, axes.y.title(up.ten, locale).whole()));
    parts.extend(legend.parts);
    let foot = (f64::midpoint(left, right), area.bottom + 2.0 * LINE);
    parts.push(words(foot, Anchor::Middle, axes.x.title(across.ten, locale).whole()));
    let mut below = area.bottom + 2.0 * LINE;
    for line in readout {
        below += LINE;
        parts.push(words((12.0, below), Anchor::Start, line));
    }
    let height = below + 10.0;
    Some(Picture { title: plot.title.render(locale), width: WIDTH, height, parts, letters: Vec::new() })
}

/// The inside of the axes.
struct Area<'a> {
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
    axes: &'a Axes<'a>,
}

impl Area<'_> {
    fn x(&self, place: f64) -> f64 {
        self.left + place * (self.right - self.left)
    }

    fn y(&self, place: f64) -> f64 {
        self.bottom + place * (self.top - self.bottom)
    }

    /// Position of a point given in SI; `None` for one that the scales cannot show.
    fn place(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        Some((self.x(self.axes.x.of(x)?), self.y(self.axes.y.of(y)?)))
    }

    /// The same, for a point inside the axes.
    fn inside(&self, at: (f64, f64)) -> Option<(f64, f64)> {
        self.place(at).filter(|at| clipped(*at, *at, &self.corners()).is_some())
    }

    /// The corners of the axes, with a little room for rounding.
    fn corners(&self) -> [(f64, f64); 2] {
        [(self.left - 1e-6, self.top - 1e-6), (self.right + 1e-6, self.bottom + 1e-6)]
    }

    /// A line down the plot, with a point on every curve it reads; and what it reads, in lines.
    fn cursor(&self, cursor: f64, locale: &Locale, parts: &mut Vec<PictureElement>) -> Vec<String> {
        let Some(x) = self.axes.within(cursor) else { return Vec::new() };
        if let Some(place) = self.axes.x.of(x) {
            let points = vec![(self.x(place), self.top), (self.x(place), self.bottom)];
            parts.push(PictureElement::Line { points, tone: Tone::Ink, width: 1.0, dash: LineStyle::Solid });
        }
        for (n, series) in self.axes.plot.series.iter().enumerate() {
            let at = self.axes.read(series, x).and_then(|reading| self.inside((x, reading.y)));
            parts.extend(at.map(|at| PictureElement::Disc { at, radius: 3.5, tone: Tone::Curve(n) }));
        }
        let mut lines: Vec<String> = Vec::new();
        for part in self.axes.readout(cursor, locale) {
            match lines.last_mut() {
                Some(line) if width(line) + 30.0 + width(&part) <= self.right => {
                    *line += &format!("   {part}");
                }
                _ => lines.push(part),
            }
        }
        lines
    }

    fn grid(&self, across: &[Tick], up: &[Tick], parts: &mut Vec<PictureElement>) {
        let mut line = |from, to, tone, width| {
            parts.push(PictureElement::Line { points: vec![from, to], tone, width, dash: LineStyle::Solid });
        };
        let mut words = Vec::new();
        for tick in across {
            let Some(x) = self.axes.x.span.place(tick.at).map(|place| self.x(place)) else { continue };
            let named = !tick.label.is_empty();
            line((x, self.top), (x, self.bottom), Tone::Faint, if named { 0.8 } else { 0.3 });
            let at = (x, self.bottom + LINE);
            words.push(PictureElement::Words {
                at,
                anchor: Anchor::Middle,
                text: tick.label.clone(),
                tone: Tone::Ink,
            });
        }
        for tick in up {
            let Some(y) = self.axes.y.span.place(tick.at).map(|place| self.y(place)) else { continue };
            let named = !tick.label.is_empty();
            line((self.left, y), (self.right, y), Tone::Faint, if named { 0.8 } else { 0.3 });
            let at = (self.left - 6.0, y + 0.35 * WORDS);
            words.push(PictureElement::Words {
                at,
                anchor: Anchor::End,
                text: tick.label.clone(),
                tone: Tone::Ink,
            });
        }
        if self.axes.y.passes_zero()
            && let Some(place) = self.axes.y.of(0.0)
        {
            line((self.left, self.y(place)), (self.right, self.y(place)), Tone::Ink, 0.8);
        }
        let (left, top, right, bottom) = (self.left, self.top, self.right, self.bottom);
        for (from, to) in [((left, top), (left, bottom)), ((left, bottom), (right, bottom))] {
            line(from, to, Tone::Ink, 1.2);
        }
        parts.extend(
            words
                .into_iter()
                .filter(|part| !matches!(part, PictureElement::Words { text, .. } if text.is_empty())),
        );
    }

    fn curve(
        &self,
        tone: Tone,
        dash: LineStyle,
        series: &Series,
        labels: &mut Labels,
        parts: &mut Vec<PictureElement>,
    ) {
        if !series.joined {
            for at in series.points.iter().filter_map(|at| self.inside(*at)) {
                labels.avoid(&[at]);
                parts.push(PictureElement::Disc { at, radius: 2.5, tone });
            }
            return;
        }
        // A point that cannot be shown breaks the line.
        for run in series.points.split(|at| self.place(*at).is_none()) {
            let points = thinned(run.iter().filter_map(|at| self.place(*at)));
            for points in pieces(&points, &self.corners()) {
                if points.len() > 1 {
                    labels.avoid(&points);
                    parts.push(PictureElement::Line { points, tone, width: 1.8, dash });
                } else if let [at] = points[..] {
                    parts.push(PictureElement::Disc { at, radius: 1.8, tone });
                }
            }
        }
    }

    /// Lines across, named at their right end; a level beyond the axis is named at its edge, with its value.
    fn levels(&self, locale: &Locale, labels: &mut Labels, parts: &mut Vec<PictureElement>) {
        let inside = |place: &f64| (0.0..=1.0).contains(place);
        for place in self.axes.plot.levels.iter().filter_map(|level| self.axes.y.of(level.y)).filter(inside) {
            let points = vec![(self.left, self.y(place)), (self.right, self.y(place))];
            labels.avoid(&points);
            parts.push(PictureElement::Line { points, tone: Tone::Bad, width: 1.2, dash: LineStyle::Long });
        }
        for level in self.axes.named_levels(locale) {
            let Some(place) = self.axes.y.of(level.y) else { continue };
            let name = level.label.render(locale);
            let y = self.y(place.clamp(0.0, 1.0));
            let name = if inside(&place) {
                name
            } else {
                let arrow = match (place > 1.0, locale.style.ascii) {
                    (_, true) => "",
                    (true, false) => "↑ ",
                    (false, false) => "↓ ",
                };
                format!("{arrow}{name}: {}", self.axes.y.write(level.y, locale.style))
            };
            let (right, above, below) = (self.right - width(&name) - 4.0, y - 5.0, y + WORDS + 1.0);
            let left = self.left + 6.0;
            labels.put(&name, Tone::Bad, &[(right, above), (right, below), (left, above), (left, below)]);
        }
    }

    /// Ends of a band inside the axes.
    fn ends(&self, from: f64, to: f64) -> Option<(f64, f64)> {
        self.axes.band(from, to).map(|ends| ends.map(|place| self.x(place)).into())
    }

    fn bands(&self, parts: &mut Vec<PictureElement>) {
        for band in &self.axes.plot.bands {
            if let Some((from, to)) = self.ends(band.from, band.to) {
                let tone = if band.permitted { Tone::Good } else { Tone::Bad };
                let (from, to) = ((from, self.top), (to, self.bottom));
                parts.push(PictureElement::Area { from, to, tone, opacity: 0.15 });
            }
        }
    }

    /// The name of each band in it.
    fn band_names(&self, locale: &Locale, labels: &mut Labels) {
        for (band, [from, to]) in self.axes.named_bands(locale) {
            let name = band.label.render(locale);
            let x = self.x(f64::midpoint(from, to)) - width(&name) / 2.0;
            let mut places: Vec<(f64, f64)> =
                (1..5).map(|row| (x, self.top + f64::from(row) * LINE)).collect();
            places.push((x, self.bottom - 6.0));
            labels.put(&name, if band.permitted { Tone::Good } else { Tone::Bad }, &places);
        }
    }
}

/// The names of the curves, in rows above the axes.
struct Legend {
    height: f64,
    parts: Vec<PictureElement>,
}

impl Legend {
    fn of(axes: &Axes<'_>, locale: &Locale, right: f64) -> Self {
        const SAMPLE: f64 = 26.0;
        let mut legend = Self { height: 0.0, parts: Vec::new() };
        let mut x = 12.0;
        let curves = axes.plot.series.iter().enumerate();
        let curves = curves.map(|(n, series)| {
            (series.label.render(locale), series.joined, Tone::Curve(n), LineStyle::of_curve(n))
        });
        let before =
            axes.pinned.map(|_| (Text::new("before").render(locale), true, Tone::Faint, LineStyle::Short));
        for (name, joined, tone, dash) in curves.chain(before) {
            if name.is_empty() {
                continue;
            }
            let long = SAMPLE + 6.0 + width(&name) + 16.0;
            if legend.height == 0.0 || x + long > right {
                (x, legend.height) = (12.0, legend.height + LINE);
            }
            let base = LINE + legend.height - 4.0;
            let middle = base - 0.35 * WORDS;
            legend.parts.push(if joined {
                let points = vec![(x, middle), (x + SAMPLE, middle)];
                PictureElement::Line { points, tone, width: 1.8, dash }
            } else {
                PictureElement::Disc { at: (x + SAMPLE / 2.0, middle), radius: 2.5, tone }
            });
            let at = (x + SAMPLE + 6.0, base);
            legend.parts.push(PictureElement::Words {
                at,
                anchor: Anchor::Start,
                text: name,
                tone: Tone::Ink,
            });
            x += long;
        }
        legend
    }
}

/// The pieces of a line between two corners; points that touch no other stay alone.
fn pieces(points: &[(f64, f64)], corners: &[(f64, f64); 2]) -> Vec<Vec<(f64, f64)>> {
    if let [at] = points {
        return clipped(*at, *at, corners).map(|_| vec![vec![*at]]).unwrap_or_default();
    }
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    for pair in points.windows(2) {
        let Some((from, to)) = clipped(pair[0], pair[1], corners) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

/// The points of a curve that can be distinguished: of those within half a pixel across, the first, the least, the
/// largest and the last.
fn thinned(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut out: Vec<(f64, f64)> = Vec::new();
    let mut column: Vec<(f64, f64)> = Vec::new();
    let column_of = |at: (f64, f64)| (2.0 * at.0).round();
    for at in points {
        if column.first().is_some_and(|first| column_of(*first) != column_of(at)) {
            out.extend(outermost(&column));
            column.clear();
        }
        column.push(at);
    }
    out.extend(outermost(&column));
    out
}

fn outermost(column: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if column.len() <= 4 {
        return column.to_vec();
    }
    let by_height = |a: &usize, b: &usize| column[*a].1.total_cmp(&column[*b].1);
    let least = (0..column.len()).min_by(by_height).unwrap_or(0);
    let largest = (0..column.len()).max_by(by_height).unwrap_or(0);
    let mut kept = [0, least, largest, column.len() - 1];
    kept.sort_unstable();
    let mut all: Vec<(f64, f64)> = kept.iter().map(|at| column[*at]).collect();
    all.dedup();
    all
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use dalembert_core::Axis;

    use super::*;

    #[test]
    fn circles_of_equal_scales_are_round_on_paper() {
        let at = |n: u32| TAU * f64::from(n) / 360.0;
        let points = (0..=360).map(|n| (0.1 + 0.003 * at(n).cos(), 0.003 * at(n).sin())).collect();
        let axes = [Axis::linear("x", "mm"), Axis::linear("y", "m")];
        let [x, y] = axes;
        let circle = Plot::new("", x, y, vec![Series::line("circle", points)]);
        let extent = |plot: &Plot| {
            let drawn = picture(plot, &Seen::default(), &Locale::english()).expect("it can be drawn");
            let curve = drawn.parts.iter().find_map(|part| match part {
                PictureElement::Line { points, tone: Tone::Curve(0), .. } if points.len() > 50 => {
                    Some(points.clone())
                }
                _ => None,
            });
            let curve = curve.expect("the curve is a line");
            let size = |part: fn(&(f64, f64)) -> f64| {
                let most = curve.iter().map(part).fold(f64::NEG_INFINITY, f64::max);
                most - curve.iter().map(part).fold(f64::INFINITY, f64::min)
            };
            size(|at| at.0) / size(|at| at.1)
        };
        assert!(extent(&circle) > 1.5, "an ellipse: {}", extent(&circle));
        assert!((extent(&circle.equal()) - 1.0).abs() < 0.01);
    }
}
