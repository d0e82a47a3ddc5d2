//! What the axes of a plot cover, and what stands at a place of them.

use dalembert_core::{Axis, Locale, Plot, Scale, Series};
use dalembert_units::{Style, Unit, unit, write_quantity};

use super::ticks::Span;

/// A plot with what its axes cover.
#[derive(Clone, Debug)]
pub struct Axes<'a> {
    /// The plot.
    pub plot: &'a Plot,
    /// The horizontal axis.
    pub x: Ruler<'a>,
    /// The vertical axis.
    pub y: Ruler<'a>,
}

/// An axis with its unit and what it covers in it.
#[derive(Clone, Debug)]
pub struct Ruler<'a> {
    /// The axis.
    pub axis: &'a Axis,
    /// The unit it is shown in.
    pub unit: Unit,
    /// What it covers, in that unit.
    pub span: Span,
}

impl<'a> Axes<'a> {
    /// `None` where there is nothing to draw.
    pub fn of(plot: &'a Plot) -> Option<Self> {
        // A point counts where both of its values can be shown.
        let (x_unit, y_unit) = (unit_of(&plot.x), unit_of(&plot.y));
        let shown = |(x, y): (f64, f64)| {
            let (x, y) = (x_unit.value(x), y_unit.value(y));
            let shows =
                |value: f64, scale: Scale| value.is_finite() && (scale == Scale::Linear || value > 0.0);
            (shows(x, plot.x.scale) && shows(y, plot.y.scale)).then_some((x, y))
        };
        let curves = plot.series.iter().flat_map(|series| &series.points);
        let points: Vec<(f64, f64)> =
            curves.chain(plot.marks.iter().map(|mark| &mark.at)).copied().filter_map(shown).collect();
        let x = Span::of(points.iter().map(|at| at.0), plot.x.scale)?;
        let data = Span::of(points.iter().map(|at| at.1), plot.y.scale)?;
        let y = levels(plot, &y_unit, data).with_room();
        Some(Self {
            plot,
            x: Ruler { axis: &plot.x, unit: x_unit, span: x },
            y: Ruler { axis: &plot.y, unit: y_unit, span: y },
        })
    }

    /// Where the cursor may stand: every computed point and every mark, with its place on the axis.
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
        Some(self.x.unit.si(end))
    }

    /// What a curve reads at `x`, and whether that is a computed point. Between two of them a joined curve is read
    /// along the line that is drawn; separate points are read at themselves alone.
    pub fn read(&self, series: &Series, x: f64) -> Option<(f64, bool)> {
        let shown = |at: &&(f64, f64)| self.x.of(at.0).is_some() && self.y.of(at.1).is_some();
        if let Some(at) = series.points.iter().filter(shown).find(|at| at.0 == x) {
            return Some((at.1, true));
        }
        if !series.joined {
            return None;
        }
        series.points.windows(2).find_map(|pair| {
            let (from, to, here) = (self.x.of(pair[0].0)?, self.x.of(pair[1].0)?, self.x.of(x)?);
            let (low, high) = (self.y.of(pair[0].1)?, self.y.of(pair[1].1)?);
            let share = (here - from) / (to - from);
            let place = low * (1.0 - share) + high * share;
            (0.0..=1.0).contains(&share).then(|| (self.y.unit.si(self.y.span.value(place)), false))
        })
    }

    /// `speed = 1500 rpm`, `X = 4.62 mm`, … and the marks at the cursor.
    pub fn readout(&self, cursor: f64, locale: &Locale) -> Vec<String> {
        let Some(x) = self.within(cursor) else { return Vec::new() };
        let label = self.x.axis.label.render(locale);
        let mut parts = vec![format!("{label} = {}", self.x.write(x, locale.style))];
        let mut found = |label: String, y: f64, exact: bool| {
            let sign = match (exact, locale.style.ascii) {
                (true, _) => "=",
                (false, false) => "≈",
                (false, true) => "~",
            };
            parts.push(format!("{label} {sign} {}", self.y.write(y, locale.style)));
        };
        for mark in self.plot.marks.iter().filter(|mark| mark.at.0 == x && self.y.of(mark.at.1).is_some()) {
            found(mark.label.render(locale), mark.at.1, true);
        }
        for series in &self.plot.series {
            if let Some((y, exact)) = self.read(series, x) {
                found(series.label.render(locale), y, exact);
            }
        }
        parts
    }
}

impl Ruler<'_> {
    /// Where a value in SI stands: 0 at the lower end, 1 at the upper.
    pub fn of(&self, si: f64) -> Option<f64> {
        self.span.place(self.unit.value(si)).filter(|place| place.is_finite())
    }

    /// A value in SI as it is read.
    pub fn write(&self, si: f64, style: Style) -> String {
        write_quantity(si, &self.unit, style)
    }

    /// Whether zero lies inside, away from both ends.
    pub fn passes_zero(&self) -> bool {
        self.span.scale == Scale::Linear && self.span.from < 0.0 && self.span.to > 0.0
    }

    /// `speed [rpm]`; a power of ten that the ticks leave out stands before the unit.
    pub fn title(&self, ten: i32, locale: &Locale) -> String {
        let label = self.axis.label.render(locale);
        let unit = if locale.style.ascii { self.unit.ascii() } else { self.unit.pretty() };
        let ten = if ten == 0 { String::new() } else { super::ticks::power_of_ten(ten, locale.style) };
        match (ten.is_empty(), unit.is_empty()) {
            (true, true) => label,
            (true, false) => format!("{label} [{unit}]"),
            (false, true) => format!("{label} [{ten}]"),
            (false, false) => format!("{label} [{ten} {unit}]"),
        }
    }
}

fn unit_of(axis: &Axis) -> Unit {
    unit(axis.unit).unwrap_or(Unit::ONE)
}

/// The span with the levels, as long as the data keep a third of it: a limit far away is named at the edge instead.
fn levels(plot: &Plot, unit: &Unit, data: Span) -> Span {
    let mut span = data;
    for level in &plot.levels {
        let Some(wider) = Span::of([span.from, span.to, unit.value(level.y)], span.scale) else { continue };
        let share = |value: f64| wider.place(value).unwrap_or(0.0);
        if share(data.to) - share(data.from) >= 1.0 / 3.0 {
            span = wider;
        }
    }
    span
}
