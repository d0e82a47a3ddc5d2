//! Plots and sketches of pendulums as absorbers.

use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_core::{Animation, Axis, Drawing, Ink, Plot, Scale, Series, Sketch};
use dalembert_mechanics::vibration::pendulum_absorber::Pair;

use super::{Pendulum, PendulumCarrier, PendulumMass};
use crate::shared::letters::joined;

/// Points of a curve.
const POINTS: u32 = 400;

/// A rotor with pendulums.
pub(super) struct PendulumRotor {
    pub(super) pair: Pair,
    /// Moment of inertia without the pendulums.
    pub(super) alone: f64,
    pub(super) speed: f64,
    pub(super) tuned: f64,
    pub(super) order: f64,
    pub(super) pivot: f64,
    pub(super) arm: f64,
}

impl PendulumRotor {
    /// Effective inertia of the pendulums against the order.
    pub(super) fn effective(&self) -> Plot {
        let last = 2.0 * self.tuned.max(self.order);
        let carried = self.pair.body - self.alone;
        let limit = 6.0 * carried.abs().max(self.alone);
        let at = |n: u32| {
            let order = last * f64::from(n) / f64::from(POINTS);
            let shift = self.tuned.powi(2) - order.powi(2);
            let effective = carried + self.pair.coupling.powi(2) * order.powi(2) / (self.pair.swing * shift);
            // The curve is cut off beside the tuned order, where it has no bound.
            (order, if effective.abs() < limit { effective } else { f64::INFINITY })
        };
        Plot::new(
            "Effective inertia of the pendulums against the order",
            Axis::linear("order", "1"),
            Axis::linear("effective inertia", "kg*m^2"),
            vec![Series::line("pendulums", (0..=POINTS).map(at).collect()).of("effective_inertia")],
        )
        .level("cancels the rotor inertia", -self.alone)
    }

    /// Natural frequencies and the frequency of the torque against the speed.
    pub(super) fn against_speed(&self) -> Plot {
        let last = 2.0 * self.speed;
        let curve = |which: usize| {
            let at = |n: u32| {
                let speed = last * f64::from(n.max(1)) / 200.0;
                let back = self.pair.back * (speed / self.speed).powi(2);
                (speed, Pair { back, ..self.pair }.frequencies()[which])
            };
            (0..=200).map(at).collect::<Vec<_>>()
        };
        let ray = |order: f64| vec![(0.0, 0.0), (last, order * last)];
        let two = self.pair.held > 0.0;
        let upper = if two { "frequency[2]" } else { "frequency[1]" };
        let mut series = vec![Series::line("upper natural frequency", curve(1)).of(upper)];
        if two {
            series.push(Series::line("lower natural frequency", curve(0)).of("frequency[1]"));
        }
        series.push(Series::line("tuned order", ray(self.tuned)));
        if (self.order / self.tuned - 1.0).abs() > 1e-9 {
            series.push(Series::line("order of the torque", ray(self.order)));
        }
        Plot::new(
            "Natural frequencies against the speed",
            Axis::linear("speed", "rpm"),
            Axis::linear("frequency", "Hz"),
            series,
        )
        .mark("at this speed", (self.speed, self.order * self.speed))
    }

    /// The rotor along its axis with a pendulum, which is drawn long enough to be seen.
    pub(super) fn drawing(&self, problem: &PendulumCarrier) -> Drawing {
        let whole = self.pivot + self.arm;
        let (pivot, arm) = (self.pivot / whole, (self.arm / whole).max(0.3));
        let swing = 0.5_f64;
        let end = (arm * swing.sin(), pivot + arm * swing.cos());
        let mut sketch = Sketch::new("The rotor and its pendulum (r is not to scale)");
        sketch
            .circle((0.0, 0.0), pivot + 0.15, Ink::Body)
            .dimension("R", (0.0, 0.0), (0.0, pivot), 0.0)
            .axis((0.0, pivot), (0.0, pivot + arm))
            .link("r", (0.0, pivot), end)
            .joint("", (0.0, pivot))
            .bearing("", (0.0, 0.0), 0.0)
            .joint("", (0.0, 0.0));
        let PendulumCarrier::Rotor { pendulum, mass, inertia, stiffness, torque, .. } = problem else {
            return sketch.finish();
        };
        let bob = match pendulum {
            Pendulum::Point | Pendulum::Bifilar => "m",
            Pendulum::Body { .. } => "m, κ",
            Pendulum::Roller { .. } => "m, a",
        };
        let angle = match mass {
            PendulumMass::Given { .. } => "φ",
            PendulumMass::Swing { .. } => "φ_a",
        };
        sketch
            .round("", end, 0.1, Ink::Motion)
            .label(bob, end)
            .angle(angle, (0.0, pivot), FRAC_PI_2, FRAC_PI_2 - swing)
            .couple("Ω", (0.0, 0.0), (-0.9, 0.7), Ink::Motion)
            .label(joined(inertia.letters()), (-0.5 * pivot, -0.6 * pivot));
        if torque.is_some() {
            sketch.couple("T cos(n Ω t)", (0.0, 0.0), (3.4, 5.0), Ink::Force);
        }
        if stiffness.is_some() {
            sketch.torsion_spring("k", (0.0, 0.0), 3.0);
        }
        sketch.finish()
    }

    /// The pendulum as it swings on the rotor.
    pub(super) fn animation(&self) -> Animation {
        const FRAMES: u32 = 24;
        let whole = self.pivot + self.arm;
        let (pivot, arm) = ((0.0, self.pivot / whole), (self.arm / whole).max(0.06));
        let frame = |n: u32| {
            let swing = 0.5 * (TAU * f64::from(n) / f64::from(FRAMES)).sin();
            let end = (arm * swing.sin(), pivot.1 + arm * swing.cos());
            let mut sketch = Sketch::default();
            sketch
                .circle((0.0, 0.0), pivot.1 + 0.4 * arm, Ink::Faint)
                .circle((0.0, 0.0), 1.25, Ink::Faint)
                .line("R", (0.0, 0.0), pivot, Ink::Faint)
                .link("r", pivot, end)
                .joint("", (0.0, 0.0))
                .joint("", pivot)
                .round("", end, 0.07, Ink::Motion);
            sketch
        };
        Sketch::animation("The pendulum on the rotor", (0..FRAMES).map(frame), 1.5)
    }
}

/// A mass with a pendulum under it.
pub(super) struct SuspendedPendulum {
    pub(super) pair: Pair,
    pub(super) frequency: f64,
    pub(super) length: f64,
}

impl SuspendedPendulum {
    /// Amplitudes against the frequency, for a unit of the force.
    pub(super) fn response(&self) -> Plot {
        let last = 1.6 * self.pair.frequencies()[1].max(self.frequency);
        let at = |which: usize, scale: f64| {
            let point = |n: u32| {
                let frequency = last * f64::from(n) / f64::from(POINTS);
                (frequency, (self.pair.steady(1.0, frequency)[which] * scale).abs())
            };
            (1..=POINTS).map(point).collect::<Vec<_>>()
        };
        let mut plot = Plot::new(
            "Amplitudes of the mass and of the end of the pendulum per newton of force",
            Axis::linear("frequency", "Hz"),
            Axis::log("amplitude over force", "m/N"),
            vec![
                Series::line("mass", at(0, 1.0)).of("|amplitude|").with("problem.gravity.force", 1.0),
                Series::line("oscillation at the end of the pendulum", at(1, self.length)),
            ],
        );
        plot.y.scale = Scale::Log;
        plot.mark("this force", (self.frequency, self.pair.steady(1.0, self.frequency)[0].abs()))
    }

    /// The mass on its spring with the pendulum.
    pub(super) fn drawing(&self) -> Drawing {
        let bob = (0.5, -1.6);
        Sketch::new("The mass with its pendulum")
            .ground((-2.0, 0.5), (-2.0, -0.5))
            .spring("k", (-2.0, 0.0), (-0.6, 0.0))
            .mass("M", (-0.6, -0.3), (0.6, 0.3))
            .axis((0.0, 0.0), (0.0, -1.7))
            .link("l", (0.0, 0.0), bob)
            .joint("", (0.0, 0.0))
            .round("m", bob, 0.12, Ink::Motion)
            .force("F₀ cos(ω t)", (0.7, 0.0), (1.6, 0.0))
            .angle("φ", (0.0, 0.0), -FRAC_PI_2, 0.3 - FRAC_PI_2)
            .finish()
    }
}
