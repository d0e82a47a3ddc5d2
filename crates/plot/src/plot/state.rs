//! Settings of a user on a plot: cursor, marks, the part that is shown, how values are spread.

use dalembert_core::{Plot, Scale};
use dalembert_report::figure::axes::{Axes, PlotWindow, Spread, has_logarithms, has_logarithms_across};

use super::Marker;

/// Settings of a user on a plot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlotState {
    /// Place of the cursor: a value of `x` in SI. One beyond the axis is shown at its end.
    pub cursor: Option<f64>,
    /// Place under the pointer of the mouse, which is read instead.
    pub pointer: Option<f64>,
    /// Marks that curves are drawn with.
    pub marker: Marker,
    /// The part that is shown.
    pub view: PlotWindow,
}

/// The least part of an axis that is worth a look.
const LEAST: f64 = 1e-6;

impl PlotState {
    /// The cursor moved by a share of the axis (0.01 to the right, −0.1 to the left), to a computed point or a
    /// mark, and at least to the next one; what is shown follows it. A plot without a cursor gets one: at its first
    /// mark, else in its middle.
    #[must_use]
    pub fn moved(self, plot: &Plot, share: f64) -> Self {
        let Some(axes) = Axes::seen(plot, None, &self.view) else { return self };
        let stops = axes.stops();
        let seen = |place: &f64| (0.0..=1.0).contains(place);
        let here = self.cursor.and_then(|cursor| axes.x.of(cursor)).map(|place| place.clamp(0.0, 1.0));
        let target = match here {
            Some(place) => place + share,
            None => plot.marks.iter().filter_map(|mark| axes.x.of(mark.at.0)).find(seen).unwrap_or(0.5),
        };
        let beyond = |place: f64| match here {
            Some(here) if share > 0.0 => place > here,
            Some(here) if share < 0.0 => place < here,
            _ => seen(&place),
        };
        let nearest = stops
            .into_iter()
            .filter(|(place, _)| beyond(*place))
            .min_by(|(a, _), (b, _)| (a - target).abs().total_cmp(&(b - target).abs()));
        let Some((place, x)) = nearest else { return self };
        let moved = Self { cursor: Some(x), pointer: None, ..self };
        let by = place.min(0.0) + (place - 1.0).max(0.0);
        if self.view.window.is_some() && by != 0.0 { moved.showing(&axes, by, 1.0 + by) } else { moved }
    }

    /// The cursor at the computed point or mark nearest to a place of the axis, from 0 to 1.
    #[must_use]
    pub fn with_cursor(self, plot: &Plot, place: f64) -> Self {
        Self { cursor: self.nearest(plot, place).or(self.cursor), pointer: None, ..self }
    }

    /// The pointer over a place of the axis, from 0 to 1, or elsewhere.
    #[must_use]
    pub fn with_pointer(self, plot: &Plot, place: Option<f64>) -> Self {
        let inside = place.filter(|place| (0.0..=1.0).contains(place));
        Self { pointer: inside.and_then(|place| self.nearest(plot, place)), ..self }
    }

    /// Place at which the curves are read: under the pointer, else at the cursor.
    pub fn read_at(&self) -> Option<f64> {
        self.pointer.or(self.cursor)
    }

    /// The computed point or mark nearest to a place of the axis.
    fn nearest(&self, plot: &Plot, place: f64) -> Option<f64> {
        let axes = Axes::seen(plot, None, &self.view)?;
        let place = place.clamp(0.0, 1.0);
        let nearest =
            axes.stops().into_iter().min_by(|(a, _), (b, _)| (a - place).abs().total_cmp(&(b - place).abs()));
        nearest.map(|(_, x)| x)
    }

    /// So many times as much of the axis, with what stands at a place of it left there; the cursor stays.
    #[must_use]
    pub fn zoomed_at(self, plot: &Plot, place: f64, factor: f64) -> Self {
        let Some(axes) = Axes::seen(plot, None, &self.view) else { return self };
        let from = place.clamp(0.0, 1.0) * (1.0 - factor);
        self.showing(&axes, from, from + factor)
    }

    /// The same state without a cursor.
    #[must_use]
    pub fn without_cursor(self) -> Self {
        Self { cursor: None, pointer: None, ..self }
    }

    /// The same state with the next kind of marker.
    #[must_use]
    pub fn next_marker(self) -> Self {
        let marker = match self.marker {
            Marker::Braille => Marker::HalfBlock,
            Marker::HalfBlock => Marker::Dot,
            Marker::Dot => Marker::Ascii,
            Marker::Ascii | Marker::Pixels { .. } => Marker::Braille,
        };
        Self { marker, ..self }
    }

    /// So many times as much of the axis, with the cursor where it is on the screen; without one, about the middle.
    #[must_use]
    pub fn zoomed(self, plot: &Plot, factor: f64) -> Self {
        let Some(axes) = Axes::seen(plot, None, &self.view) else { return self };
        let place = self.cursor.and_then(|cursor| axes.x.of(cursor));
        let centre = place.filter(|place| (0.0..=1.0).contains(place)).unwrap_or(0.5);
        let from = centre * (1.0 - factor);
        self.showing(&axes, from, from + factor)
    }

    /// The shown part, moved by a share of it.
    #[must_use]
    pub fn panned(self, plot: &Plot, share: f64) -> Self {
        let Some(axes) = Axes::seen(plot, None, &self.view).filter(|_| self.view.window.is_some()) else {
            return self;
        };
        self.showing(&axes, share, 1.0 + share)
    }

    /// The next way to spread the values that they allow, or why there is none.
    ///
    /// # Errors
    ///
    /// The reason why values can be spread in one way alone.
    pub fn next_spread(self, plot: &Plot) -> Result<Self, &'static str> {
        if !has_logarithms(plot) {
            return Err("negative values have no logarithm: the axis stays linear");
        }
        let spread = match self.view.spread_of(plot) {
            Spread::Linear => Spread::Log,
            Spread::Log => Spread::Decibel,
            Spread::Decibel => Spread::Linear,
        };
        Ok(Self { view: PlotWindow { spread: Some(spread), ..self.view }, ..self })
    }

    /// The horizontal axis linear where it is logarithmic, and the other way round; or why it cannot be.
    ///
    /// # Errors
    ///
    /// The reason why it stays linear.
    pub fn next_spread_across(self, plot: &Plot) -> Result<Self, &'static str> {
        if !has_logarithms_across(plot) {
            return Err("zero and negative values have no logarithm: the axis stays linear");
        }
        let across = match self.view.scale_across(plot) {
            Scale::Linear => Scale::Log,
            Scale::Log => Scale::Linear,
        };
        Ok(Self { view: PlotWindow { across: Some(across), ..self.view }, ..self })
    }

    /// The same with that part of `x`, in SI; with all of it for `None`.
    #[must_use]
    pub fn windowed(self, window: Option<(f64, f64)>) -> Self {
        Self { view: PlotWindow { window, ..self.view }, ..self }
    }

    /// From one place of the axis, as it is shown, to another: no further than the data reach.
    fn showing(self, axes: &Axes<'_>, from: f64, to: f64) -> Self {
        let at = |place: f64| axes.whole.place(axes.x.span.value(place)).unwrap_or(place);
        let (from, to) = (at(from), at(to));
        let width = to - from;
        if width >= 1.0 - 1e-9 {
            return self.windowed(None);
        }
        if width < LEAST {
            return self;
        }
        let from = from.clamp(0.0, 1.0 - width);
        let si = |place: f64| axes.x.si(axes.whole.value(place));
        self.windowed(Some((si(from), si(from + width))))
    }
}
