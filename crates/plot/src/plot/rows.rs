//! A vertical axis whose labelled ticks stand in the middle of rows of characters.
//!
//! Labels stand in whole rows, curves are drawn with dots, up to four of them to a row. Both tell the same values where
//! every label is a whole number of rows from the next, and the middle of its row is what it says.

use dalembert_core::Scale;
use dalembert_report::figure::ticks::{Span, Ticks};
use dalembert_units::Style;

/// Distance from the middle of its row that a labelled tick may have, in rows: logarithms of 2 and 5 are no whole
/// numbers.
const ASTRAY: f64 = 0.2;

/// An axis over rows of characters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows {
    /// Number of rows.
    pub(super) rows: u16,
    /// Dots down each of them.
    pub(super) dots: u16,
}

impl Rows {
    /// The span, as little wider as it may be, from the middle of its lowest dot to that of its highest, with its
    /// ticks. One that no wider span helps (its ends are the largest numbers there are) stays as it is.
    pub(super) fn with_ticks(self, span: Span, style: Style) -> (Span, Ticks) {
        self.wider(span, style).unwrap_or_else(|| {
            let ticks =
                span.ticks_that_fit(self.most(), style, |ticks| self.are_apart(&self.rows_of(&span, ticks)));
            (span, ticks)
        })
    }

    /// The ticks whose labels all stand in the middle of rows.
    fn in_rows(self, span: &Span, style: Style) -> Ticks {
        let astray = if span.scale == Scale::Log { ASTRAY } else { 1e-3 };
        span.ticks_that_fit(self.most(), style, |ticks| {
            let rows = self.rows_of(span, ticks);
            self.are_apart(&rows) && rows.iter().all(|row| (row - row.round()).abs() <= astray)
        })
    }

    /// The narrowest span round this one that has as many labelled ticks in the middle of rows as there is room for.
    fn wider(self, span: Span, style: Style) -> Option<(Span, Ticks)> {
        if self.rows < 2 {
            return None;
        }
        // Ticks just beyond the ends count too: the wider span may hold them.
        let (from, to) = (coordinate(span.from, span.scale), coordinate(span.to, span.scale));
        let beyond = to / 2.0 - from / 2.0;
        let around = span_of(from - beyond, to + beyond, span)?;
        let mut sets: Vec<Vec<f64>> = (1..=3 * self.most())
            .map(|most| labelled(&around.ticks(most, style)).map(|at| coordinate(at, span.scale)).collect())
            .collect();
        sets.dedup();
        let found = sets.into_iter().flat_map(|at| {
            let extent = at.last().zip(at.first()).map_or(0.0, |(last, first)| last - first);
            let apart = extent / (to - from) * self.all() + 1e-6;
            let together = ((apart / 2.0) as u16..=apart as u16).filter_map(|rows| {
                let per_row = extent / f64::from(rows);
                self.fitted(&span, &at, per_row).filter(|fitted| usize::from(fitted.seen) <= self.most())
            });
            let together: Vec<Fitted> = together.collect();
            let alone =
                at.into_iter().filter(|at| (from..=to).contains(at)).flat_map(|at| self.alone(&span, at));
            together.into_iter().chain(alone).collect::<Vec<Fitted>>()
        });
        let mut found: Vec<Fitted> = found.collect();
        found.sort_by(|a, b| self.cost(a).total_cmp(&self.cost(b)));
        found.into_iter().find_map(|fitted| {
            // No less but for rounding.
            let wider = span_of(fitted.from.min(from), fitted.to.max(to), span)?;
            // Its own numbers of ticks are others: these may be among them, or not.
            let ticks = self.in_rows(&wider, style);
            (labelled(&ticks).count() >= usize::from(fitted.seen)).then_some((wider, ticks))
        })
    }

    /// Span of a row, weighted where labels are few: a label less is worth a quarter of the rows.
    fn cost(self, fitted: &Fitted) -> f64 {
        let wanted = f64::from(self.rows.div_ceil(4)).clamp(2.0, 5.0);
        let missing = (wanted - f64::from(fitted.seen)).max(0.0);
        let alone = if fitted.seen < 2 { 2.0 } else { 1.0 };
        fitted.per_row * (1.0 + missing / 4.0) * alone
    }

    /// One label alone in the middle of a row, for each of the rows.
    fn alone(self, span: &Span, at: f64) -> Vec<Fitted> {
        let (from, to) = (coordinate(span.from, span.scale), coordinate(span.to, span.scale));
        let over = |part: f64, rows: f64| if part > 0.0 { part / rows } else { 0.0 };
        let below = (0..self.rows).map(|row| f64::from(row) + self.margin());
        let per_row = below.map(|below| over(at - from, below).max(over(to - at, self.all() - below)));
        per_row.filter_map(|per_row| self.fitted(span, &[at], per_row)).collect()
    }

    /// The span with so much to a row, if it holds what it must with every one of these ticks in the middle of a row.
    fn fitted(self, span: &Span, ticks: &[f64], per_row: f64) -> Option<Fitted> {
        let (from, to) = (coordinate(span.from, span.scale), coordinate(span.to, span.scale));
        let first = *ticks.first()?;
        let highest = f64::from(self.rows) - 1.0;
        let margin = self.margin();
        // The rows of the ticks over that of the first, which has to be a whole one.
        let over = |at: f64| (at - first) / per_row;
        let least = (-over(from) - margin - 1e-9).ceil();
        let most = (highest - over(to) + margin + 1e-9).floor();
        if !(per_row > 0.0 && per_row.is_finite() && least <= most) {
            return None;
        }
        // What begins at zero has it in the lowest row, what ends at zero in the highest.
        let row = match (span.from == 0.0, span.to == 0.0) {
            (true, _) => least,
            (_, true) => most,
            _ => f64::midpoint(least, most).floor(),
        };
        let rows: Vec<f64> = ticks.iter().map(|at| row + over(*at)).collect();
        let astray = rows.iter().any(|row| (row - row.round()).abs() > ASTRAY);
        let seen = rows.iter().filter(|row| (-0.25..=highest + 0.25).contains(*row)).count() as u16;
        (!astray && self.are_apart(&rows) && seen > 0).then_some(Fitted {
            from: first - (row + margin) * per_row,
            to: first + (highest + margin - row) * per_row,
            per_row,
            seen,
        })
    }

    /// The rows of the labelled ticks, counted up from the middle of the lowest one.
    fn rows_of(self, span: &Span, ticks: &Ticks) -> Vec<f64> {
        labelled(ticks).filter_map(|at| Some(span.place(at)? * self.all() - self.margin())).collect()
    }

    /// From the middle of the lowest dot to that of the highest, in rows.
    fn all(self) -> f64 {
        f64::from(self.rows) - 1.0 + 2.0 * self.margin()
    }

    /// From the middle of the lowest row to the middle of its lowest dot, in rows.
    fn margin(self) -> f64 {
        0.5 - 0.5 / f64::from(self.dots)
    }

    /// The largest number of labels.
    fn most(self) -> usize {
        usize::from(self.rows.div_ceil(3)).clamp(2, 10)
    }

    /// True where labels leave a row between them, if there are rows enough.
    fn are_apart(self, rows: &[f64]) -> bool {
        let least = if self.rows < 3 { 1.0 } else { 2.0 };
        rows.windows(2).all(|pair| pair[1].round() - pair[0].round() >= least)
    }
}

/// A span that holds what it must, in the coordinate of its scale.
struct Fitted {
    from: f64,
    to: f64,
    per_row: f64,
    /// Number of its ticks that are seen.
    seen: u16,
}

fn labelled(ticks: &Ticks) -> impl Iterator<Item = f64> {
    ticks.ticks.iter().filter(|tick| !tick.label.is_empty()).map(|tick| tick.at)
}

/// Coordinate proportional to the distance along the axis.
fn coordinate(value: f64, scale: Scale) -> f64 {
    match scale {
        Scale::Linear => value,
        Scale::Log => value.log10(),
    }
}

/// A span of the same kind between two coordinates; `None` where an end is no number that there is.
fn span_of(from: f64, to: f64, like: Span) -> Option<Span> {
    let scale = like.scale;
    let value = |at: f64| match scale {
        Scale::Linear => at,
        Scale::Log => 10f64.powf(at),
    };
    let span = Span { from: value(from), to: value(to), ..like };
    let least = if scale == Scale::Log { f64::MIN_POSITIVE } else { f64::MIN };
    (span.from >= least && span.to <= f64::MAX && span.from < span.to).then_some(span)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value in the middle of a row, counted up from the lowest, read back from the dots: dot 0 stands at the lower
    /// end of the span, the last one at its upper end.
    fn read_back(rows: Rows, span: Span, row: f64) -> f64 {
        let dots = f64::from(rows.rows) * f64::from(rows.dots);
        let dot = (row + 0.5) * f64::from(rows.dots) - 0.5;
        span.value(dot / (dots - 1.0))
    }

    fn cases() -> impl Iterator<Item = (Rows, Span)> {
        let linear = [
            (0.0, 20.4),
            (-0.3, 10.4),
            (-47.0, 52.0),
            (988.0, 1013.0),
            (-3e-7, -1e-9),
            (1.1, 1.9),
            (0.0, 4.7e9),
        ];
        let log = [(1e-3, 30.0), (0.9, 60.0), (3.1, 4.4), (2e-9, 7e8), (14.0, 90.0), (101.0, 104.0)];
        let spans = linear
            .into_iter()
            .map(|ends| (ends, Scale::Linear))
            .chain(log.into_iter().map(|ends| (ends, Scale::Log)))
            .map(|((from, to), scale)| Span { from, to, scale, degrees: false });
        spans.flat_map(|span| {
            (4..=20)
                .chain([27, 34, 48])
                .flat_map(move |rows| [1, 2, 4].map(|dots| (Rows { rows, dots }, span)))
        })
    }

    #[test]
    fn the_middle_of_a_row_with_a_label_is_what_it_says() {
        for (rows, span) in cases() {
            let (wider, ticks) = rows.with_ticks(span, Style::default());
            let inside = |value: f64| (-1e-9..=1.0 + 1e-9).contains(&wider.place(value).unwrap());
            assert!(inside(span.from) && inside(span.to), "{rows:?} {span:?} {wider:?}");
            let quarter = 0.25 / rows.all();
            let labelled: Vec<f64> = labelled(&ticks).collect();
            assert!(!labelled.is_empty(), "{rows:?} {span:?} {wider:?}");
            for at in labelled {
                let place = wider.place(at).unwrap();
                // The row that holds the dot of the tick.
                let dots = f64::from(rows.rows) * f64::from(rows.dots);
                let row = ((place * (dots - 1.0)).round() / f64::from(rows.dots)).floor();
                let read = wider.place(read_back(rows, wider, row)).unwrap();
                assert!((read - place).abs() <= quarter, "{at}: {rows:?} {span:?} {wider:?}");
            }
        }
    }

    #[test]
    fn equal_steps_are_equal_numbers_of_rows() {
        for (rows, span) in cases().filter(|(_, span)| span.scale == Scale::Linear) {
            let (wider, ticks) = rows.with_ticks(span, Style::default());
            let steps: Vec<f64> =
                rows.rows_of(&wider, &ticks).windows(2).map(|pair| pair[1] - pair[0]).collect();
            for step in &steps {
                assert!((step - steps[0]).abs() < 1e-6, "{rows:?} {span:?}: {steps:?}");
                assert!((step - step.round()).abs() < 1e-6 && *step > 1.5, "{rows:?} {span:?}: {steps:?}");
            }
        }
    }

    #[test]
    fn most_rows_are_used_and_more_than_one_is_labelled() {
        for (rows, span) in cases().filter(|(rows, _)| rows.rows >= 8) {
            let (wider, ticks) = rows.with_ticks(span, Style::default());
            let used = wider.place(span.to).unwrap() - wider.place(span.from).unwrap();
            assert!(used > 0.5, "{used}: {rows:?} {span:?} {wider:?}");
            assert!(labelled(&ticks).count() >= 2, "{rows:?} {span:?} {wider:?}");
        }
    }
}
