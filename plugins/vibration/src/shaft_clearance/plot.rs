//! The largest amplitude over the range of speeds against the diameter.

use std::ops::Bound::{Excluded, Included, Unbounded};

use dalembert_core::{Axis, Plot, Series};
use dalembert_mechanics::{intervals::IntervalSet, sdof, section, whirl};

use super::{Damping, ShaftClearance};

impl ShaftClearance {
    /// The largest amplitude in the range against the diameter, with the clearance and the permitted bands.
    pub(super) fn amplitude_over_diameter(
        &self,
        speeds: [f64; 2],
        set: &IntervalSet,
        limits: [Option<f64>; 2],
    ) -> Plot {
        let critical = |speed: f64| {
            let stiffness = self.mass * speed.powi(2);
            section::round_diameter(
                stiffness / self.shaft.mounting.stiffness(self.shaft.young, 1.0, self.shaft.length),
            )
        };
        // From well below to well above the diameters whose critical speed lies in the range.
        let first = 0.4 * critical(speeds[0].max(0.02 * speeds[1]));
        let last = 1.6 * critical(speeds[1]);
        let at = |n: u16| {
            let d = first * (last / first).powf(f64::from(n) / 600.0);
            (d, self.worst_amplitude(d, speeds))
        };
        let mut plot = Plot::new(
            "Largest amplitude in the range of speeds against diameter",
            Axis::log("diameter", "mm"),
            Axis::log("amplitude", "mm"),
            vec![Series::line("X", (0..=600).map(at).collect())],
        )
        .level("clearance", self.clearance);
        for (limit, label) in limits.into_iter().zip(["end of the soft branch", "start of the stiff branch"])
        {
            if let Some(d) = limit.filter(|d| d.is_finite()) {
                plot = plot.mark(label, (d, self.clearance));
            }
        }
        for interval in set.intervals() {
            let from = match interval.lower {
                Included(d) | Excluded(d) => d,
                Unbounded => 0.0,
            };
            let to = match interval.upper {
                Included(d) | Excluded(d) => d,
                Unbounded => f64::INFINITY,
            };
            plot = plot.band("permitted", from, to, true);
        }
        plot
    }

    /// Infinite where an undamped rotor meets its critical speed.
    fn worst_amplitude(&self, diameter: f64, speeds: [f64; 2]) -> f64 {
        let k = self.shaft.mounting.stiffness(
            self.shaft.young,
            section::round_second_moment(diameter),
            self.shaft.length,
        );
        let c = match self.damping {
            Damping::Undamped => 0.0,
            Damping::Ratio { ratio } => sdof::damping_from_ratio(ratio, k, self.mass),
            Damping::Coefficient { coefficient } => coefficient,
        };
        whirl::worst_speed(k, self.mass, c, speeds)
            .map_or(f64::NAN, |(speed, _)| sdof::unbalance_amplitude(self.unbalance, k, self.mass, c, speed))
    }
}
