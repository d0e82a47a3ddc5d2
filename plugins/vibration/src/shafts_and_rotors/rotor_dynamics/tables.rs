//! Bearings whose coefficients are tables over speed.

use dalembert_core::{Refusal, Text};

use super::{
    RotorDynamics,
    parts::{Bearing, SpeedRow},
};

/// Relative distance outside a table that a speed may have by rounding alone.
const ROUNDING: f64 = 1e-9;

impl RotorDynamics {
    /// Refuses tables that are none, and speeds that a table does not reach: nothing is known of a bearing there.
    pub(super) fn refuse_what_lies_beyond_a_table(&self) -> Result<(), Refusal> {
        for (n, rows) in self.tables() {
            if rows.is_empty() || rows.windows(2).any(|pair| pair[0].speed >= pair[1].speed) {
                return Err(Refusal::because(
                    "the speeds of a bearing table must increase from row to row, and at least one row is required",
                ));
            }
            let Some((from, to)) = ends(rows) else { continue };
            let refuse = |speed: f64, words: &'static str| {
                Err(Refusal::because(
                    Text::new(words)
                        .with_quantity("speed", speed, "rpm")
                        .with("n", n)
                        .with_quantity("from", from, "rpm")
                        .with_quantity("to", to, "rpm"),
                ))
            };
            let (least, most) = (from * (1.0 - ROUNDING), to * (1.0 + ROUNDING));
            if !(least..=most).contains(&self.speed) {
                return refuse(
                    self.speed,
                    "the speed {speed} lies outside the bearing table of support {n}, which goes from {from} to {to}: \
                     write a speed within it, or add rows to the table",
                );
            }
            if self.highest_speed <= from || self.highest_speed > most {
                return refuse(
                    self.highest_speed,
                    "the highest speed of the diagrams, {speed}, lies outside the bearing table of support {n}, which \
                     goes from {from} to {to}: write a speed within it, or add rows to the table",
                );
            }
        }
        Ok(())
    }

    /// Lower end of the diagrams: standstill, or the largest of the first speeds of the tables.
    pub(super) fn lowest_speed(&self) -> f64 {
        self.tables().filter_map(|(_, rows)| ends(rows)).map(|(from, _)| from).fold(0.0, f64::max)
    }

    /// The speeds of all rows.
    pub(super) fn table_speeds(&self) -> impl Iterator<Item = f64> {
        self.tables().flat_map(|(_, rows)| rows).map(|row| row.speed)
    }

    /// The tables with the numbers of their supports.
    fn tables(&self) -> impl Iterator<Item = (usize, &[SpeedRow])> {
        (1..).zip(&self.supports).filter_map(|(n, support)| match &support.bearing {
            Bearing::Table { rows } => Some((n, rows.as_slice())),
            _ => None,
        })
    }
}

/// First and last speed of a table; none of a single row, which holds at every speed.
fn ends(rows: &[SpeedRow]) -> Option<(f64, f64)> {
    match rows {
        [first, .., last] => Some((first.speed, last.speed)),
        _ => None,
    }
}
