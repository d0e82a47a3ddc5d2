//! Ranges and ticks of an axis: pure numbers, for a screen or a file.
//!
//! Everything here is in the unit of the axis.

use dalembert_core::Scale;
use dalembert_units::{Style, superscript, write_number};

/// Range of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Lower end.
    pub from: f64,
    /// Upper end, above `from`.
    pub to: f64,
    /// Spacing of values between the ends.
    pub scale: Scale,
    /// True for angles in degrees, whose ticks are parts of a turn.
    pub degrees: bool,
}

/// The ticks of an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ticks {
    /// The power of ten that the labels leave out; it belongs to the unit in the title of the axis.
    pub ten: i32,
    /// The ticks, ascending.
    pub ticks: Vec<Tick>,
}

/// A tick of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Position, as a value.
    pub at: f64,
    /// Label; empty for a minor tick.
    pub label: String,
}

impl Span {
    /// From the least to the largest of `values`. Those that the scale cannot show are passed over; `None` if that
    /// leaves nothing. Values that differ by rounding alone count as one, which gets room on both sides.
    pub fn of(values: impl IntoIterator<Item = f64>, scale: Scale) -> Option<Self> {
        let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.into_iter().filter(|value| shows(*value, scale)) {
            (from, to) = (from.min(value), to.max(value));
        }
        if from > to {
            return None;
        }
        let size = from.abs().max(to.abs());
        if to / 2.0 - from / 2.0 <= 1e-12 * size {
            (from, to) = match scale {
                _ if size == 0.0 => (-1.0, 1.0),
                Scale::Linear => (from - size / 2.0, to + size / 2.0),
                Scale::Log => (from / 10f64.sqrt(), to * 10f64.sqrt()),
            };
        }
        // The outermost numbers there are: no end may be infinite, and a logarithm needs a positive one.
        let least = if scale == Scale::Log { f64::MIN_POSITIVE } else { f64::MIN };
        let (from, to) = (from.max(least), to.min(f64::MAX));
        (from < to).then_some(Self { from, to, scale, degrees: false })
    }

    /// The same span with a twentieth more on both sides. A linear span that begins not far above zero begins at it.
    #[must_use]
    pub fn with_room(self) -> Self {
        let Self { from, to, scale, degrees } = self;
        match scale {
            Scale::Linear => {
                let room = to / 20.0 - from / 20.0;
                let near_zero = |end: f64, other: f64| {
                    end == 0.0 || (end > 0.0) == (other > 0.0) && end.abs() < 0.4 * other.abs()
                };
                Self {
                    from: if from >= 0.0 && near_zero(from, to) { 0.0 } else { (from - room).max(f64::MIN) },
                    to: if to <= 0.0 && near_zero(to, from) { 0.0 } else { (to + room).min(f64::MAX) },
                    scale,
                    degrees,
                }
            }
            Scale::Log => {
                let room = (to.log10() - from.log10()) / 20.0;
                Self {
                    from: (from * 10f64.powf(-room)).max(f64::MIN_POSITIVE),
                    to: (to * 10f64.powf(room)).min(f64::MAX),
                    scale,
                    degrees,
                }
            }
        }
    }

    /// The same span with a twentieth more on both sides, for levels, whose zero is no end.
    #[must_use]
    pub fn with_margin(self) -> Self {
        let room = self.to / 20.0 - self.from / 20.0;
        Self { from: (self.from - room).max(f64::MIN), to: (self.to + room).min(f64::MAX), ..self }
    }

    /// The part of it between two values; `None` where it has none there.
    pub fn part(&self, from: f64, to: f64) -> Option<Self> {
        let (from, to) = (from.max(self.from), to.min(self.to));
        (from < to).then_some(Self { from, to, ..*self })
    }

    /// Position of a value: 0 at the lower end, 1 at the upper; `None` for a value that the scale cannot show.
    pub fn place(&self, value: f64) -> Option<f64> {
        if !shows(value, self.scale) {
            return None;
        }
        Some(match self.scale {
            // Halves, so that no difference of two finite numbers is infinite.
            Scale::Linear => (value / 2.0 - self.from / 2.0) / (self.to / 2.0 - self.from / 2.0),
            Scale::Log => (value.log10() - self.from.log10()) / (self.to.log10() - self.from.log10()),
        })
    }

    /// The value that stands at a place.
    pub fn value(&self, place: f64) -> f64 {
        match self.scale {
            Scale::Linear => self.from * (1.0 - place) + self.to * place,
            Scale::Log => 10f64.powf(self.from.log10() * (1.0 - place) + self.to.log10() * place),
        }
    }

    /// At most `most` labelled ticks at round numbers: 1, 2 or 5 times a power of ten on a linear axis, parts of a turn on
    /// one of degrees, decades on a logarithmic one. A logarithmic axis over less than two decades is labelled at 1, 2, 5,
    /// or as a linear one.
    pub fn ticks(&self, most: usize, style: Style) -> Ticks {
        match self.scale {
            Scale::Linear => self.linear(most, style),
            Scale::Log => self.decades(most, style),
        }
    }

    /// Of all numbers of ticks up to `most`, the densest whose labels `fit`.
    pub fn ticks_that_fit(&self, most: usize, style: Style, fit: impl Fn(&Ticks) -> bool) -> Ticks {
        (1..=most).rev().map(|most| self.ticks(most, style)).find(|ticks| fit(ticks)).unwrap_or_default()
    }

    fn linear(&self, most: usize, style: Style) -> Ticks {
        let Some((mantissa, exponent, first, last)) = self.steps(most) else {
            return Ticks::default();
        };
        let at: Vec<f64> = (first..=last).map(|n| decimal(n * mantissa, exponent)).collect();
        let size = at.iter().fold(0.0f64, |size, at| size.max(at.abs()));
        let top = if size > 0.0 { size.log10().floor() as i32 } else { 0 };
        // Long and short numbers leave out a power of ten, a multiple of three as prefixes are.
        let ten = if (-2..5).contains(&top) { 0 } else { top.div_euclid(3) * 3 };
        // As many digits as tell each tick from the next.
        let digits = u8::try_from((top - exponent + 1).clamp(1, 17)).unwrap_or(17);
        let ticks = (first..=last)
            .zip(at)
            .filter(|(_, at)| at.is_finite())
            .map(|(n, at)| {
                let shown = decimal(n * mantissa, exponent - ten);
                Tick { at, label: write_number(shown, Style { digits, ..style }) }
            })
            .collect();
        Ticks { ten, ticks }
    }

    /// The smallest step `mantissa × 10^exponent` that has at most `most` multiples in the span, and the first and
    /// last of those multiples.
    fn steps(&self, most: usize) -> Option<(i64, i32, i64, i64)> {
        // A step may lie below the smallest normal number for the narrowest spans there are; those have no ticks.
        let width = self.to / 2.0 - self.from / 2.0;
        let least = (2.0 * (width / most.max(1) as f64)).log10().floor();
        if !least.is_finite() {
            return None;
        }
        let fits = |(mantissa, exponent): (i64, i32)| {
            let step = decimal(mantissa, exponent);
            // An end that is a multiple but for rounding counts as one.
            let (first, last) = ((self.from / step - 1e-9).ceil(), (self.to / step + 1e-9).floor());
            let fits = last - first < most as f64 && first.abs().max(last.abs()) < 1e15;
            fits.then_some((mantissa, exponent, first as i64, last as i64))
        };
        if self.degrees && least >= 0.0 {
            return parts_of_a_turn().find_map(fits);
        }
        let sizes = (least as i32 - 1..).flat_map(|exponent| [1, 2, 5].map(|mantissa| (mantissa, exponent)));
        sizes.take(16).find_map(fits)
    }

    fn decades(&self, most: usize, style: Style) -> Ticks {
        let (low, high) = (self.from.log10(), self.to.log10());
        let (first, last) = ((low - 1e-9).ceil() as i32, (high + 1e-9).floor() as i32);
        let decades = usize::try_from(last - first + 1).unwrap_or(0);
        if decades < 2 {
            return self.within_decades(first - 1..=last, most, style);
        }
        let stride = decades.div_ceil(most.max(1)) as i32;
        let plain = first >= -3 && last <= 4;
        let mut ticks = Vec::new();
        for exponent in first - 1..=last {
            let labelled = exponent.rem_euclid(stride) == 0;
            for mantissa in 1..=(if stride == 1 { 9 } else { 1 }) {
                let at = decimal(mantissa, exponent);
                let inside = exponent >= first || mantissa > 1;
                if !inside || !at.is_finite() || at < self.from || at / self.to > 1.0 + 1e-9 {
                    continue;
                }
                let label = match (labelled && mantissa == 1, plain) {
                    (false, _) => String::new(),
                    (true, true) => write_number(at, style),
                    (true, false) => power_of_ten(exponent, style),
                };
                ticks.push(Tick { at, label });
            }
        }
        Ticks { ten: 0, ticks }
    }

    fn within_decades(&self, exponents: std::ops::RangeInclusive<i32>, most: usize, style: Style) -> Ticks {
        let ticks: Vec<Tick> = exponents
            .flat_map(|exponent| [1, 2, 5].map(|mantissa| decimal(mantissa, exponent)))
            .filter(|at| *at / self.from >= 1.0 - 1e-9 && *at / self.to <= 1.0 + 1e-9)
            .map(|at| Tick { at, label: write_number(at, style) })
            .collect();
        if (2..=most).contains(&ticks.len()) { Ticks { ten: 0, ticks } } else { self.linear(most, style) }
    }
}

/// Steps of an axis in degrees, `mantissa × 10^exponent`: from one degree to a turn, then turns.
fn parts_of_a_turn() -> impl Iterator<Item = (i64, i32)> {
    let parts = [(1, 0), (2, 0), (5, 0), (1, 1), (15, 0), (3, 1), (45, 0), (9, 1), (18, 1)];
    let turns = (1..300).flat_map(|exponent| [36, 72, 180].map(|mantissa| (mantissa, exponent)));
    parts.into_iter().chain(turns)
}

/// `10⁻⁶`, or `1e-6` in ASCII; nothing for 10⁰.
pub fn power_of_ten(exponent: i32, style: Style) -> String {
    match (exponent, style.ascii) {
        (_, true) => format!("1e{exponent}"),
        (0, false) => "1".into(),
        (1, false) => "10".into(),
        (_, false) => format!("10{}", superscript(exponent)),
    }
}

fn shows(value: f64, scale: Scale) -> bool {
    value.is_finite() && (scale == Scale::Linear || value > 0.0)
}

/// The number nearest to `mantissa × 10^exponent`: as a user would write it, without rounding of a product.
fn decimal(mantissa: i64, exponent: i32) -> f64 {
    format!("{mantissa}e{exponent}").parse().expect("a number with a power of ten is one")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(from: f64, to: f64, scale: Scale, most: usize) -> Vec<String> {
        let ticks = Span { from, to, scale, degrees: false }.ticks(most, Style::default());
        ticks.ticks.into_iter().map(|tick| tick.label).filter(|label| !label.is_empty()).collect()
    }

    #[test]
    fn a_linear_axis_is_ticked_in_ones_twos_and_fives() {
        assert_eq!(labels(0.0, 10.0, Scale::Linear, 11).join(" "), "0 1 2 3 4 5 6 7 8 9 10");
        assert_eq!(labels(0.0, 10.0, Scale::Linear, 10).join(" "), "0 2 4 6 8 10");
        assert_eq!(labels(0.0, 10.0, Scale::Linear, 5).join(" "), "0 5 10");
        assert_eq!(labels(-0.3, 0.3, Scale::Linear, 7).join(" "), "−0.3 −0.2 −0.1 0 0.1 0.2 0.3");
        assert_eq!(labels(988.0, 1013.0, Scale::Linear, 4).join(" "), "990 1000 1010");
    }

    #[test]
    fn an_axis_of_degrees_is_ticked_in_parts_of_a_turn() {
        let labels = |from, to, most| {
            let ticks = Span { from, to, scale: Scale::Linear, degrees: true }.ticks(most, Style::default());
            ticks.ticks.into_iter().map(|tick| tick.label).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(labels(0.0, 360.0, 8), "0 90 180 270 360");
        assert_eq!(labels(0.0, 360.0, 12), "0 45 90 135 180 225 270 315 360");
        assert_eq!(labels(-189.0, 189.0, 5), "−180 −90 0 90 180");
        assert_eq!(labels(0.0, 94.0, 4), "0 30 60 90");
        assert_eq!(labels(0.0, 94.0, 8), "0 15 30 45 60 75 90");
        assert_eq!(labels(3.0, 11.0, 5), "4 6 8 10");
        assert_eq!(labels(0.0, 720.0, 5), "0 180 360 540 720");
        assert_eq!(labels(0.0, 7300.0, 6), "0 1800 3600 5400 7200");
        assert_eq!(labels(1.1, 1.6, 6), "1.1 1.2 1.3 1.4 1.5 1.6");
    }

    #[test]
    fn ticks_are_the_numbers_their_labels_say() {
        for tick in (Span { from: 0.0, to: 1.0, scale: Scale::Linear, degrees: false })
            .ticks(11, Style::default())
            .ticks
        {
            assert_eq!(tick.at, tick.label.parse::<f64>().unwrap());
        }
    }

    #[test]
    fn long_numbers_share_a_power_of_ten() {
        let ticks =
            Span { from: 0.0, to: 4.1e-6, scale: Scale::Linear, degrees: false }.ticks(5, Style::default());
        assert_eq!(ticks.ten, -6);
        let labels: Vec<_> = ticks.ticks.iter().map(|tick| tick.label.as_str()).collect();
        assert_eq!(labels, ["0", "1", "2", "3", "4"]);
        assert_eq!(ticks.ticks[3].at, 3e-6);
        assert_eq!(
            (Span { from: 0.0, to: 250e3, scale: Scale::Linear, degrees: false })
                .ticks(6, Style::default())
                .ten,
            3
        );
    }

    #[test]
    fn a_narrow_axis_far_from_zero_tells_its_ticks_apart() {
        assert_eq!(labels(1000.0, 1000.002, Scale::Linear, 3).join(" "), "1000 1000.001 1000.002");
    }

    #[test]
    fn a_logarithmic_axis_is_ticked_in_decades() {
        assert_eq!(labels(0.01, 100.0, Scale::Log, 9).join(" "), "0.01 0.1 1 10 100");
        assert_eq!(labels(1e-6, 1e6, Scale::Log, 5).join(" "), "10⁻⁶ 10⁻³ 1 10³ 10⁶");
        assert_eq!(labels(0.9, 60.0, Scale::Log, 9).join(" "), "1 10");
        assert_eq!(labels(1.5, 60.0, Scale::Log, 9).join(" "), "2 5 10 20 50");
        assert_eq!(labels(3.1, 4.4, Scale::Log, 4).join(" "), "3.5 4");
        let minor =
            Span { from: 1.0, to: 100.0, scale: Scale::Log, degrees: false }.ticks(5, Style::default());
        assert_eq!(minor.ticks.len(), 19, "1, 2 … 9, 10, 20 … 90, 100");
    }

    #[test]
    fn a_span_holds_what_can_be_shown_and_nothing_else() {
        let of =
            |values: &[f64], scale| Span::of(values.iter().copied(), scale).map(|span| (span.from, span.to));
        assert_eq!(of(&[3.0, f64::NAN, -1.0, f64::INFINITY], Scale::Linear), Some((-1.0, 3.0)));
        assert_eq!(of(&[3.0, 0.0, -1.0, 12.0], Scale::Log), Some((3.0, 12.0)));
        assert_eq!(of(&[f64::NAN], Scale::Linear), None);
        assert_eq!(of(&[-1.0, 0.0], Scale::Log), None);
        assert_eq!(of(&[4.0], Scale::Linear), Some((2.0, 6.0)));
        assert_eq!(of(&[0.0, 0.0], Scale::Linear), Some((-1.0, 1.0)));
        let (from, to) = of(&[4.0, 4.0 + 1e-15], Scale::Linear).unwrap();
        assert!((from - 2.0).abs() < 1e-9 && (to - 6.0).abs() < 1e-9, "{from} {to}");
    }

    #[test]
    fn room_keeps_zero() {
        let span = |from, to| Span { from, to, scale: Scale::Linear, degrees: false }.with_room();
        assert_eq!(span(0.2, 10.0), Span { from: 0.0, to: 10.49, scale: Scale::Linear, degrees: false });
        assert_eq!(span(-10.0, -1.0).to, 0.0);
        assert!((span(8.0, 10.0).from - 7.9).abs() < 1e-12);
        assert!((span(-1.0, 1.0).to - 1.1).abs() < 1e-12);
    }

    #[test]
    fn places_and_values_are_each_others_inverse() {
        for (from, to, scale) in [
            (-2.0, 8.0, Scale::Linear),
            (-1e308, 1e308, Scale::Linear),
            (1e-300, 1e300, Scale::Log),
            (0.5, 20.0, Scale::Log),
        ] {
            let span = Span { from, to, scale, degrees: false };
            for n in 0..=10 {
                let place = f64::from(n) / 10.0;
                let back = span.place(span.value(place)).unwrap();
                assert!((back - place).abs() < 1e-9, "{span:?} at {place}: {back}");
            }
        }
        assert_eq!(Span { from: 1.0, to: 100.0, scale: Scale::Log, degrees: false }.place(10.0), Some(0.5));
        assert_eq!(Span { from: 1.0, to: 100.0, scale: Scale::Log, degrees: false }.place(0.0), None);
    }

    #[test]
    fn any_span_has_a_bounded_number_of_ticks_inside_it() {
        let ends =
            [-1e308, -1e300, -1.0, -1e-300, 0.0, 5e-324, 1e-300, 1e-12, 1.0, 1.0 + 1e-10, 7e5, 1e300, 1e308];
        for from in ends {
            for to in ends.into_iter().filter(|to| *to > from) {
                for scale in [Scale::Linear, Scale::Log] {
                    let Some(span) = Span::of([from, to], scale) else { continue };
                    for most in [1, 2, 5, 20] {
                        let ticks = span.with_room().ticks(most, Style::default()).ticks;
                        let labelled = ticks.iter().filter(|tick| !tick.label.is_empty()).count();
                        assert!(labelled <= most, "{span:?}: {labelled} of {most}");
                        assert!(ticks.iter().all(|tick| {
                            (-1e-6..=1.0 + 1e-6).contains(&span.with_room().place(tick.at).unwrap())
                        }));
                    }
                }
            }
        }
    }
}
