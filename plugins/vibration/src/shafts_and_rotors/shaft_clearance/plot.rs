//! The largest amplitude over the range of speeds against what is sought of the shaft.

use dalembert_core::{Axis, Plot, Series};
use dalembert_mechanics::{sdof, whirl};
use dalembert_numerics::intervals::IntervalSet;

use super::{ClearanceDamping, ShaftClearance};
use crate::shared::jeffcott::pairs;

/// The curve of a plot that is still without words.
pub(super) struct Curve {
    points: Vec<(f64, f64)>,
    clearance: f64,
}

impl ShaftClearance {
    /// The largest amplitude in the range of speeds, between two values of the variable whose stiffness is given.
    pub(super) fn amplitude_over(
        &self,
        [first, last]: [f64; 2],
        unbalance: f64,
        speeds: [f64; 2],
        stiffness: impl Fn(f64) -> f64,
    ) -> Curve {
        let at = |n: u16| {
            let x = first * (last / first).powf(f64::from(n) / 480.0);
            (x, self.worst_amplitude(stiffness(x), unbalance, speeds))
        };
        Curve { points: (0..=480).map(at).collect(), clearance: self.clearance }
    }

    /// Infinite where an undamped rotor meets its critical speed.
    fn worst_amplitude(&self, k: f64, unbalance: f64, speeds: [f64; 2]) -> f64 {
        let c = match self.damping {
            ClearanceDamping::Undamped => 0.0,
            ClearanceDamping::Ratio { ratio } => sdof::damping_from_ratio(ratio, k, self.mass),
            ClearanceDamping::Coefficient { coefficient } => coefficient,
        };
        let natural = sdof::natural_frequency(k, self.mass);
        if c == 0.0 && (speeds[0]..=speeds[1]).contains(&natural) {
            return f64::INFINITY;
        }
        whirl::worst_speed(k, self.mass, c, speeds)
            .map_or(f64::NAN, |(speed, _)| sdof::unbalance_amplitude(unbalance, k, self.mass, c, speed))
    }
}

impl Curve {
    /// The plot with the clearance and the permitted bands.
    pub(super) fn permitted(
        self,
        title: &'static str,
        (label, unit): (&'static str, &'static str),
        set: &IntervalSet,
        limits: [Option<f64>; 2],
    ) -> Plot {
        let mut plot = Plot::new(
            title,
            Axis::log(label, unit),
            Axis::log("amplitude", "mm"),
            vec![Series::line("X", self.points).of("worst_amplitude")],
        )
        .level("clearance", self.clearance);
        for (limit, label) in
            limits.into_iter().zip(["end of the supercritical range", "start of the subcritical range"])
        {
            if let Some(x) = limit.filter(|x| x.is_finite()) {
                plot = plot.mark(label, (x, self.clearance));
            }
        }
        for (from, to) in pairs(set) {
            plot = plot.band("permitted", from, to, true);
        }
        plot
    }
}
