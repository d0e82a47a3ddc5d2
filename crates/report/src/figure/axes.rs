//! Ranges and scales of the axes of a plot, and conversion between values and positions.

use dalembert_core::{
    Locale, Plot, Scale, Series,
    exhibit::{Band, Level},
};
use dalembert_units::{Style, Unit, unit};
use itertools::Itertools as _;

pub use super::ruler::Ruler;
use super::ticks::Span;

/// Below the largest level, levels are seen over so many decibels.
const DECIBELS: f64 = 80.0;
/// The share of a linear axis at either end of it where a curve may plunge to nothing: of its levels there none is sought.
const PLUNGE: f64 = 0.05;

/// A plot with what its axes cover.
#[derive(Clone, Debug)]
pub struct Axes<'a> {
    /// The plot.
    pub plot: &'a Plot,
    /// One of the same axes, whose curves lie under those of the plot.
    pub pinned: Option<&'a Plot>,
    /// The horizontal axis.
    pub x: Ruler<'a>,
    /// The vertical axis.
    pub y: Ruler<'a>,
    /// Full range of the horizontal axis.
    pub whole: Span,
}

/// Reading of a curve at the cursor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveReading {
    /// The value, in SI.
    pub y: f64,
    /// Error bound of the reading, in the unit of the axis; `None` for a computed point.
    pub error: Option<f64>,
}

/// Visible part of a plot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlotWindow {
    /// The part of `x`, in SI; `None` for all of it.
    pub window: Option<(f64, f64)>,
    /// Vertical scale, `None` for that of the plot.
    pub spread: Option<Spread>,
    /// Horizontal scale, `None` for that of the plot.
    pub across: Option<Scale>,
}

/// Vertical scale of curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// Equal distances for equal differences.
    Linear,
    /// Equal distances for equal ratios.
    Log,
    /// The same, numbered in decibels over one of the unit.
    Decibel,
}

impl PlotWindow {
    /// Vertical scale of a plot: the requested one if the values permit it, else that of the plot.
    pub fn spread_of(&self, plot: &Plot) -> Spread {
        let own = if plot.y.scale == Scale::Log { Spread::Log } else { Spread::Linear };
        self.spread.filter(|_| has_logarithms(plot)).unwrap_or(own)
    }

    /// Horizontal scale of a plot: the requested one if the values permit it, else that of the plot.
    pub fn scale_across(&self, plot: &Plot) -> Scale {
        self.across.filter(|_| has_logarithms_across(plot)).unwrap_or(plot.x.scale)
    }
}

/// Returns true if a logarithmic vertical scale is possible: some values are above zero, and none is below it.
pub fn has_logarithms(plot: &Plot) -> bool {
    let unit = unit(plot.y.unit).unwrap_or(Unit::ONE);
    let curves = plot.series.iter().flat_map(|series| &series.points);
    let all = || curves.clone().chain(plot.marks.iter().map(|mark| &mark.at)).map(|at| unit.value(at.1));
    all().any(|value| value > 0.0) && !all().any(|value| value < 0.0)
}

/// Returns true if a logarithmic horizontal axis is possible: nothing lies below zero, and the positive values are not
/// all equal.
pub fn has_logarithms_across(plot: &Plot) -> bool {
    let unit = unit(plot.x.unit).unwrap_or(Unit::ONE);
    let points = plot.series.iter().flat_map(|series| &series.points);
    let all = || points.clone().map(|at| unit.value(at.0)).filter(|value| value.is_finite());
    let above = || all().filter(|value| *value > 0.0);
    let (least, most) = (above().fold(f64::INFINITY, f64::min), above().fold(0.0, f64::max));
    least < most && !all().any(|value| value < 0.0)
}

impl<'a> Axes<'a> {
    /// `None` where there is nothing to draw.
    pub fn of(plot: &'a Plot) -> Option<Self> {
        Self::seen(plot, None, &PlotWindow::default())
    }

    /// The same for a part of it, with the curves and the marks of a pinned plot in sight.
    pub fn seen(plot: &'a Plot, pinned: Option<&'a Plot>, view: &PlotWindow) -> Option<Self> {
        let (spread, x_scale) = (view.spread_of(plot), view.scale_across(plot));
        let across = Ruler::of_axis(&plot.x, false);
        let up = Ruler::of_axis(&plot.y, spread == Spread::Decibel);
        let scale = if spread == Spread::Log { Scale::Log } else { Scale::Linear };
        // A point counts where both of its values can be shown.
        let shown = |(x, y): (f64, f64)| {
            let (x, y) = (across.value(x), up.value(y));
            let shows =
                |value: f64, scale: Scale| value.is_finite() && (scale == Scale::Linear || value > 0.0);
            (shows(x, x_scale) && shows(y, scale)).then_some((x, y))
        };
        let both = || [Some(plot), pinned].into_iter().flatten();
        let marks: Vec<(f64, f64)> =
            both().flat_map(|plot| &plot.marks).filter_map(|mark| shown(mark.at)).collect();
        let points: Vec<(f64, f64)> =
            plot.series.iter().flat_map(|series| &series.points).copied().filter_map(shown).collect();
        let whole = Span::of(points.iter().chain(&marks).map(|at| at.0), x_scale)?;
        let window = view.window.and_then(|(from, to)| whole.part(across.value(from), across.value(to)));
        let x = window.unwrap_or(whole);
        // The vertical axis fits what is seen: the points inside, and where curves cross the edges.
        let inside = |at: &(f64, f64)| x.from <= at.0 && at.0 <= x.to;
        let all = || both().flat_map(|plot| &plot.series);
        let of = |joined: bool| {
            let series = all().filter(move |series| series.joined == joined);
            series.flat_map(|series| &series.points).copied().filter_map(shown).filter(inside)
        };
        let mut seen: Vec<(f64, f64)> = of(true).collect();
        if window.is_some() {
            for series in all().filter(|series| series.joined) {
                seen.extend(series.points.windows(2).flat_map(|pair| {
                    let ends = shown(pair[0]).zip(shown(pair[1]));
                    let at = move |edge| Some((edge, between(ends?, edge, &x, scale)?));
                    [x.from, x.to].into_iter().filter_map(at)
                }));
            }
        }
        if spread != Spread::Linear {
            let floor = floor(&seen, &x, window.is_none(), spread == Spread::Decibel);
            seen.retain(|at| at.1 >= floor);
        }
        seen.extend(of(false).chain(marks.iter().copied().filter(inside)));
        let data = Span::of(seen.iter().map(|at| at.1), scale)
            .or_else(|| Span::of(points.iter().chain(&marks).map(|at| at.1), scale))?;
        let data = levels(plot, &up, data);
        let data = if spread == Spread::Decibel { data.with_margin() } else { data.with_room() };
        let y = up.clone().over(data).in_best_unit();
        let whole = across.clone().over(whole).in_best_unit();
        // A part is shown in the unit of the whole.
        let convert = |value: f64| whole.value(across.si(value));
        let part = window.map(|part| Span { from: convert(part.from), to: convert(part.to), ..whole.span });
        let x = Ruler { span: part.unwrap_or(whole.span), ..whole.clone() };
        Some(Self { plot, pinned, x, y, whole: whole.span })
    }

    /// True if its circles are to be round.
    pub fn has_equal_scales(&self) -> bool {
        let is_plain = |ruler: &Ruler<'_>| ruler.span.scale == Scale::Linear && ruler.decibels.is_none();
        self.plot.equal && is_plain(&self.x) && is_plain(&self.y)
    }

    /// The vertical axis in an area of that width and height with at least as much to a length as the horizontal one
    /// needs, for equal scales.
    pub fn equal_up(&self, [across, up]: [f64; 2]) -> Span {
        let (x, y) = (&self.x, &self.y);
        wider(y.span, x.unit.factor * (x.span.to - x.span.from) / across * up / y.unit.factor)
    }

    /// The horizontal axis with as much to a length as a vertical one has.
    pub fn equal_across(&self, span: &Span, [across, up]: [f64; 2]) -> Span {
        let (x, y) = (&self.x, &self.y);
        wider(x.span, y.unit.factor * (span.to - span.from) / up * across / x.unit.factor)
    }

    /// Cursor stops: every computed point and every mark, with its position on the axis.
    pub fn stops(&self) -> Vec<(f64, f64)> {
        let curves = self.plot.series.iter().flat_map(|series| &series.points);
        let all = curves.chain(self.plot.marks.iter().map(|mark| &mark.at));
        all.filter(|at| self.y.of(at.1).is_some()).filter_map(|at| Some((self.x.of(at.0)?, at.0))).collect()
    }

    /// A value of `x`, moved to the end of the axis where it lies beyond it.
    pub fn within(&self, x: f64) -> Option<f64> {
        let place = self.x.of(x)?;
        if (0.0..=1.0).contains(&place) {
            return Some(x);
        }
        let end = if place < 0.0 { self.x.span.from } else { self.x.span.to };
        Some(self.x.si(end))
    }

    /// Ends of a band from `from` to `to` (SI, perhaps infinite), as fractions of the horizontal axis in their order;
    /// `None` for a band that is not seen.
    pub fn band(&self, from: f64, to: f64) -> Option<[f64; 2]> {
        let end = |at: f64| match at {
            f64::INFINITY => Some(1.0),
            // An end that a logarithmic axis cannot show lies at or below zero: left of it.
            _ if at == f64::NEG_INFINITY || (!at.is_nan() && self.x.of(at).is_none()) => Some(0.0),
            _ => self.x.of(at),
        };
        let (from, to) = (end(from)?, end(to)?);
        let (from, to) = (from.min(to), from.max(to));
        (to >= 0.0 && from <= 1.0).then(|| [from, to].map(|place| place.clamp(0.0, 1.0)))
    }

    /// The levels that are named: of those of one name the first.
    pub fn named_levels(&self, locale: &Locale) -> impl Iterator<Item = &'a Level> {
        self.plot.levels.iter().unique_by(|level| level.label.render(locale))
    }

    /// The bands that are named, with their ends as fractions of the horizontal axis: of those of one name the first that
    /// is seen.
    pub fn named_bands(&self, locale: &Locale) -> impl Iterator<Item = (&'a Band, [f64; 2])> {
        let seen = self.plot.bands.iter().filter_map(|band| Some((band, self.band(band.from, band.to)?)));
        seen.unique_by(|(band, _)| band.label.render(locale))
    }

    /// Reading of a curve at `x`. Between two computed points a joined curve is read along the line that is drawn, and
    /// no better than the curve bends there: parabolas through a third point on either side tell how much. A mark at
    /// `x` that is no further off is one of the curve, and is read itself, so that no answer is contradicted. Separate
    /// points are read at themselves alone.
    pub fn read(&self, series: &Series, x: f64) -> Option<CurveReading> {
        let place = |at: &(f64, f64)| Some((self.x.of(at.0)?, self.y.of(at.1)?));
        if let Some(at) = series.points.iter().find(|at| at.0 == x && place(at).is_some()) {
            return Some(CurveReading { y: at.1, error: None });
        }
        if !series.joined {
            return None;
        }
        let here = self.x.of(x)?;
        let between = |pair: &[(f64, f64)]| {
            let (from, to) = (place(&pair[0])?, place(&pair[1])?);
            (0.0..=1.0).contains(&((here - from.0) / (to.0 - from.0))).then_some((from, to))
        };
        let (n, (from, to)) =
            series.points.windows(2).enumerate().find_map(|(n, pair)| Some((n, between(pair)?)))?;
        let slope = (to.1 - from.1) / (to.0 - from.0);
        let at = from.1 + slope * (here - from.0);
        // Newton's form: the third point adds its divided difference times both distances to the line.
        let third = [n.checked_sub(1), Some(n + 2)].into_iter().flatten();
        let third = third.filter_map(|n| place(series.points.get(n)?));
        let bend = |third: (f64, f64)| {
            let beyond = (third.1 - from.1) / (third.0 - from.0);
            ((beyond - slope) / (third.0 - to.0) * (here - from.0) * (here - to.0)).abs()
        };
        let bend = third.map(bend).filter(|bend| bend.is_finite()).fold(0.0, f64::max);
        // Twice, since the next term of the series is not known.
        let error = (self.y.span.value(at + 2.0 * bend) - self.y.span.value(at)).abs();
        let y = self.y.si(self.y.span.value(at));
        let off = |mark: &f64| (self.y.value(*mark) - self.y.value(y)).abs();
        let marks = self.plot.marks.iter().filter(|mark| mark.at.0 == x).map(|mark| mark.at.1);
        let mark = marks.min_by(|a, b| off(a).total_cmp(&off(b))).filter(|mark| off(mark) <= error);
        Some(mark.map_or(CurveReading { y, error: Some(error) }, |y| CurveReading { y, error: None }))
    }

    /// `speed = 1500 rpm`, `X = 4.62 mm`, … and the marks at the cursor.
    pub fn readout(&self, cursor: f64, locale: &Locale) -> Vec<String> {
        let Some(x) = self.within(cursor) else { return Vec::new() };
        let label = self.x.axis.label.render(locale);
        let mut parts = vec![format!("{label} = {}", self.x.write(x, locale.style))];
        let mut found = |label: String, CurveReading { y, error }: CurveReading| {
            let sign = match (error.is_none(), locale.style.ascii) {
                (true, _) => "=",
                (false, false) => "≈",
                (false, true) => "~",
            };
            let digits =
                error.map_or(locale.style.digits, |error| digits(self.y.value(y), error, locale.style));
            let value = self.y.write(y, Style { digits, ..locale.style });
            parts.push(match (label.contains('='), error) {
                // `ζ = 0.05` is a name.
                (true, None) => format!("{label}: {value}"),
                (true, Some(_)) => format!("{label}: {sign} {value}"),
                (false, _) => format!("{label} {sign} {value}"),
            });
        };
        let is_here = |at: (f64, f64)| at.0 == x && self.y.of(at.1).is_some();
        for mark in self.plot.marks.iter().filter(|mark| is_here(mark.at) && !mark.label.is_empty()) {
            found(mark.label.render(locale), CurveReading { y: mark.at.1, error: None });
        }
        for series in &self.plot.series {
            if let Some(reading) = self.read(series, x) {
                found(series.label.render(locale), reading);
            }
        }
        parts
    }
}

/// As many digits as an error leaves: the last one is worth more than it.
fn digits(value: f64, error: f64, style: Style) -> u8 {
    let digits = value.abs().log10().floor() - error.log10().floor();
    if digits.is_finite() { digits.clamp(1.0, f64::from(style.digits)) as u8 } else { style.digits }
}

/// The height of the line between two points at an edge that lies between them.
fn between(((x0, y0), (x1, y1)): ((f64, f64), (f64, f64)), edge: f64, x: &Span, scale: Scale) -> Option<f64> {
    let (from, to, here) = (x.place(x0)?, x.place(x1)?, x.place(edge)?);
    let share = (here - from) / (to - from);
    if !(0.0..=1.0).contains(&share) {
        return None;
    }
    Some(match scale {
        Scale::Linear => y0 * (1.0 - share) + y1 * share,
        Scale::Log => (y0.ln() * (1.0 - share) + y1.ln() * share).exp(),
    })
}

/// Lowest value of curves that an axis of ratios has to show: of none where they plunge to nothing at an end of the whole
/// plot, and no level far below the largest.
fn floor(seen: &[(f64, f64)], x: &Span, is_whole: bool, in_decibels: bool) -> f64 {
    let largest = seen.iter().map(|at| at.1).fold(f64::NEG_INFINITY, f64::max);
    let least = if in_decibels { largest - DECIBELS } else { f64::NEG_INFINITY };
    if !is_whole || x.scale == Scale::Log {
        return least;
    }
    let is_inside = |at: f64| x.place(at).is_some_and(|place| (PLUNGE..=1.0 - PLUNGE).contains(&place));
    let inner = seen.iter().filter(|at| is_inside(at.0)).map(|at| at.1).fold(f64::INFINITY, f64::min);
    if inner.is_finite() { inner.max(least) } else { least }
}

/// A span of at least that width about the same middle.
fn wider(span: Span, width: f64) -> Span {
    let (middle, half) = (f64::midpoint(span.from, span.to), width / 2.0);
    let (from, to) = (span.from.min(middle - half), span.to.max(middle + half));
    if from.is_finite() && to.is_finite() { Span { from, to, ..span } } else { span }
}

/// The span with the levels, as long as the data keep a third of it: a limit far away is named at the edge instead.
fn levels(plot: &Plot, ruler: &Ruler<'_>, data: Span) -> Span {
    let mut span = data;
    for level in &plot.levels {
        let Some(wider) = Span::of([span.from, span.to, ruler.value(level.y)], span.scale) else {
            continue;
        };
        let share = |value: f64| wider.place(value).unwrap_or(0.0);
        if share(data.to) - share(data.from) >= 1.0 / 3.0 {
            span = wider;
        }
    }
    span
}

#[cfg(test)]
mod tests {
    use dalembert_core::Axis;

    use super::*;

    fn plot(points: Vec<(f64, f64)>) -> Plot {
        Plot::new("", Axis::linear("f", "Hz"), Axis::linear("X", "mm"), vec![Series::line("X", points)])
    }

    fn in_decibels(plot: &Plot, window: Option<(f64, f64)>) -> Span {
        let view = PlotWindow { window, spread: Some(Spread::Decibel), across: None };
        Axes::seen(plot, None, &view).unwrap().y.span
    }

    /// An unbalance response begins at nothing: its levels are seen from about where the curve leaves the corner.
    #[test]
    fn levels_are_shown_where_the_curve_is() {
        let at = |n: i32| {
            let r = f64::from(n) / 100.0;
            (r, r * r / ((1.0 - r * r).powi(2) + (0.1 * r).powi(2)).sqrt())
        };
        let unbalance = plot((1..=300).map(at).collect());
        let span = in_decibels(&unbalance, None);
        assert!(span.to > 79.0 && span.from > 20.0 && span.from < 50.0, "{span:?}");
        // A part that is zoomed to is seen whole.

        let close = in_decibels(&unbalance, Some((0.01, 0.1)));
        assert!(close.from < -15.0, "{close:?}");
        // An antiresonance is no plunge to nothing.
        let notch = plot((0..=200).map(|n| (f64::from(n), (f64::from(n) - 100.2).abs() / 100.0)).collect());
        assert!(in_decibels(&notch, None).from < 10.0, "{:?}", in_decibels(&notch, None));
        // Nobody reads a level 80 dB below the largest.
        let deep = plot((0..=200).map(|n| (f64::from(n), if n == 100 { 1e-9 } else { 1.0 })).collect());
        let span = in_decibels(&deep, None);
        assert!(span.to - span.from < 90.0, "{span:?}");
        // A mark is an answer, and always seen.
        let marked = plot((1..=300).map(at).collect()).mark("at rest", (0.02, 0.0004));
        assert!(in_decibels(&marked, None).from < -7.9, "{:?}", in_decibels(&marked, None));
    }
}
