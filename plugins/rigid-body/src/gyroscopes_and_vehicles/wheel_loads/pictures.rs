//! The loads over the speed, and the vehicle from behind.

use dalembert_core::{Axis, Drawing, Plot, Series, Sketch};

use super::{
    TurnDirection, WheelLoads,
    wheels::{Constants, Wheel},
};

impl WheelLoads {
    pub(super) fn loads_over_speed(&self, constants: &Constants, wheels: &[Wheel]) -> Plot {
        let first =
            wheels.iter().filter_map(|wheel| constants.lifting_speed(wheel)).fold(f64::INFINITY, f64::min);
        let most = match (first.is_finite(), self.speed) {
            (true, Some(speed)) => (1.1 * first).max(1.1 * speed),
            (true, None) => 1.1 * first,
            (false, Some(speed)) if speed > 0.0 => 2.0 * speed,
            (false, _) => (self.gravity * self.radius).sqrt(),
        };
        let curve = |wheel: &Wheel| {
            let at = |n: u16| {
                let speed = most * f64::from(n) / 100.0;
                (speed, constants.load(wheel, speed))
            };
            Series::line(wheel.label, (0..=100).map(at).collect()).of(wheel.name)
        };
        let mut plot = Plot::new(
            "Wheel loads against speed",
            Axis::linear("speed", "km/h"),
            Axis::linear("wheel load", "N"),
            wheels.iter().map(curve).collect(),
        )
        .over("speed");
        if first.is_finite() {
            plot = plot.mark("a wheel lifts", (first, 0.0));
        }
        if let (Some(speed), Some(wheel)) = (self.speed, wheels.first()) {
            plot = plot.mark("this speed", (speed, constants.load(wheel, speed)));
        }
        plot
    }

    /// The vehicle from behind on its road, with the loads of the two sides, the larger one as long as the track.
    pub(super) fn rear_view(&self, constants: &Constants, wheels: &[Wheel]) -> Drawing {
        // Towards the inside the road falls.
        let inside = if self.towards == TurnDirection::Left { -1.0 } else { 1.0 };
        let (sin, cos) = self.bank.sin_cos();
        let at = |across: f64, up: f64| (across * inside * cos + up * sin * inside, up * cos - across * sin);
        let height = (self.centre_height / self.track).clamp(0.2, 2.0);
        let speed = self.speed.unwrap_or(0.0);
        let side = |outer: bool| -> f64 {
            wheels.iter().filter(|wheel| wheel.outer == outer).map(|wheel| constants.load(wheel, speed)).sum()
        };
        let (inner, outer) = (side(false), side(true));
        let scale = 0.9 / inner.abs().max(outer.abs());
        let wheel = 0.35f64.min(0.8 * height);
        let mut sketch = Sketch::new("The vehicle seen from behind, turning in the direction of the arrow");
        sketch.bars([at(-1.0, 0.0), at(1.0, 0.0)]).link("", at(-0.5, wheel / 2.0), at(0.5, wheel / 2.0));
        for (place, load, name) in [(0.5, inner, "ΣN_i"), (-0.5, outer, "ΣN_o")] {
            sketch.body(
                "",
                [(-0.07, 0.0), (0.07, 0.0), (0.07, wheel), (-0.07, wheel)].map(|(x, y)| at(place + x, y)),
            );
            let length = load * scale;
            if length.is_finite() && length > 0.0 {
                sketch.force("", at(place, -length), at(place, 0.0)).label(name, at(place, -length));
            }
        }
        let top = 1.6 * height;
        sketch
            .body("", [at(-0.5, 0.7 * wheel), at(-0.5, top), at(0.5, top), at(0.5, 0.7 * wheel)])
            .mass_centre("G", at(0.0, height))
            .motion("a", at(0.55, height), at(0.95, height))
            .finish()
    }
}
