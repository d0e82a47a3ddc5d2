//! An axis of a plot: its unit, its range, its title.

use dalembert_core::{Axis, Locale, Scale, Text};
use dalembert_units::{Kind, Style, Unit, best_unit, unit, write_number, write_quantity};

use super::ticks::{Span, power_of_ten};

/// An axis with its unit and what it covers in it.
#[derive(Clone, Debug)]
pub struct Ruler<'a> {
    /// The axis.
    pub axis: &'a Axis,
    /// The unit it is shown in.
    pub unit: Unit,
    /// Decibels of a factor of ten over one of the unit: 20 for amplitudes, 10 for what is a square of one. `None` for
    /// the values themselves.
    pub decibels: Option<f64>,
    /// Range in that unit or in decibels.
    pub span: Span,
}

/// Title of an axis: the quantity, and its unit in brackets, which is never shortened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AxisTitle {
    /// Name of the quantity.
    pub name: String,
    /// `[mm]`, with the power of ten that the ticks leave out; empty for a pure number.
    pub unit: String,
}

impl AxisTitle {
    /// The whole of it: `speed [rpm]`.
    pub fn whole(&self) -> String {
        let between = if self.name.is_empty() || self.unit.is_empty() { "" } else { " " };
        format!("{}{between}{}", self.name, self.unit)
    }
}

impl<'a> Ruler<'a> {
    /// An axis that covers nothing in particular yet.
    pub(super) fn of_axis(axis: &'a Axis, in_decibels: bool) -> Self {
        // A density is a mean square over a bandwidth.
        let factor = if axis.unit.ends_with("/Hz") { 10.0 } else { 20.0 };
        let scale = if in_decibels { Scale::Linear } else { axis.scale };
        Self {
            axis,
            unit: unit(axis.unit).unwrap_or(Unit::ONE),
            decibels: in_decibels.then_some(factor),
            span: Span { from: 0.0, to: 1.0, scale, degrees: false },
        }
    }

    /// The same axis over a range; angles in degrees are ticked as such.
    #[must_use]
    pub(super) fn over(self, span: Span) -> Self {
        let degrees = self.decibels.is_none() && self.unit.ascii() == "deg";
        Self { span: Span { degrees, ..span }, ..self }
    }

    /// The same axis in the unit an engineer writes its largest value in (0.002 m in mm) where its ticks would leave out a
    /// power of ten; as it is where its unit is not SI, or has no such multiple.
    #[must_use]
    pub(super) fn in_best_unit(self) -> Self {
        let largest = self.span.from.abs().max(self.span.to.abs());
        let kind = Kind::of(&self.unit);
        let is_known = kind.units().iter().any(|known| unit(known).is_ok_and(|known| known == self.unit));
        let leaves_out = self.span.ticks(5, Style::default()).ten != 0;
        if self.decibels.is_some() || !leaves_out || !is_known || !self.unit.is_decimal() {
            return self;
        }
        let best = best_unit(self.unit.si(largest), kind);
        let convert = |value: f64| best.value(self.unit.si(value));
        let span = Span { from: convert(self.span.from), to: convert(self.span.to), ..self.span };
        let is_better = span.from < span.to && span.from.is_finite() && span.to.is_finite();
        if is_better { Self { unit: best, span, ..self } } else { self }
    }

    /// Axis value of a value in SI; not finite where it has no level.
    pub fn value(&self, si: f64) -> f64 {
        let value = self.unit.value(si);
        self.decibels.map_or(value, |factor| factor * value.log10())
    }

    /// The value in SI that is shown so.
    pub fn si(&self, value: f64) -> f64 {
        self.unit.si(self.decibels.map_or(value, |factor| 10f64.powf(value / factor)))
    }

    /// Position of a value in SI: 0 at the lower end, 1 at the upper.
    pub fn of(&self, si: f64) -> Option<f64> {
        self.span.place(self.value(si)).filter(|place| place.is_finite())
    }

    /// A value in SI as it is read.
    pub fn write(&self, si: f64, style: Style) -> String {
        match self.decibels {
            None => write_quantity(si, &self.unit, style),
            Some(_) => format!("{} dB", write_number(self.value(si), style)),
        }
    }

    /// Returns true if zero lies inside, away from both ends.
    pub fn passes_zero(&self) -> bool {
        self.span.scale == Scale::Linear && self.span.from < 0.0 && self.span.to > 0.0
    }

    /// The quantity, and its unit with the power of ten that the ticks leave out.
    pub fn title(&self, ten: i32, locale: &Locale) -> AxisTitle {
        let name = self.axis.label.render(locale);
        let unit = self.unit.shown(locale.style.ascii);
        let inside = match (self.decibels.is_some(), unit.is_empty(), ten) {
            (true, true, _) => "dB".to_owned(),
            (true, false, _) => Text::new("dB over 1 {unit}").with("unit", &unit).render(locale),
            (false, _, 0) => unit,
            (false, true, _) => power_of_ten(ten, locale.style),
            (false, false, _) => format!("{} {unit}", power_of_ten(ten, locale.style)),
        };
        let unit = if inside.is_empty() { inside } else { format!("[{inside}]") };
        AxisTitle { name, unit }
    }
}
