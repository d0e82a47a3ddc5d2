//! The loads over the speed, and the vehicle from behind.

use std::f64::consts::PI;

use dalembert_core::{Axis, Drawing, Ink, Plot, Series, Sketch};

use super::{
    AxleLayout, TurnDirection, WheelInertia, WheelLoads,
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

    /// The vehicle from behind on its road, with the loads of the two sides, and beside it from the left.
    pub(super) fn rear_view(&self, constants: &Constants, wheels: &[Wheel]) -> Drawing {
        let mut sketch = Sketch::new("The vehicle from behind and from the left (R is not to scale)");
        self.seen_from_behind(&mut sketch, constants, wheels);
        self.seen_from_the_left(&mut sketch);
        sketch.finish()
    }

    /// The larger load of a side is drawn as long as the track.
    fn seen_from_behind(&self, sketch: &mut Sketch, constants: &Constants, wheels: &[Wheel]) {
        // Towards the inside the road falls.
        let inside = if self.towards == TurnDirection::Left { -1.0 } else { 1.0 };
        let (sin, cos) = self.bank.sin_cos();
        let at = |across: f64, up: f64| (across * inside * cos + up * sin * inside, up * cos - across * sin);
        let height = (self.centre_height / self.track).clamp(0.45, 1.5);
        let speed = self.speed.unwrap_or(0.0);
        let side = |outer: bool| -> f64 {
            wheels.iter().filter(|wheel| wheel.outer == outer).map(|wheel| constants.load(wheel, speed)).sum()
        };
        let (inner, outer) = (side(false), side(true));
        let scale = 0.7 / inner.abs().max(outer.abs());
        let wheel = 2.0 * (self.wheel_radius / self.track).clamp(0.12, 0.4);
        let rectangle = |x: [f64; 2], y: [f64; 2]| {
            [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])].map(|(x, y)| at(x, y))
        };
        sketch.bars([at(-0.8, 0.0), at(1.2, 0.0)]).link("", at(-0.5, wheel / 2.0), at(0.5, wheel / 2.0));
        for (place, load, name) in [(0.5, inner, "ΣN_i"), (-0.5, outer, "ΣN_o")] {
            sketch.body("", rectangle([place - 0.09, place + 0.09], [0.0, wheel]));
            let length = load * scale;
            if length.is_finite() && length > 0.0 {
                sketch.force("", at(place, -length), at(place, 0.0)).label(name, at(place, -length));
            }
        }
        let mass = if self.transverse_inertia.is_some() { "m, I_t" } else { "m" };
        let (floor, top) = (0.6 * wheel, (1.7 * height).max(1.1 * wheel));
        sketch
            .body("", rectangle([-0.36, 0.36], [floor, top]))
            .label(mass, at(-0.2, 0.7 * top + 0.3 * floor))
            .dimension("w", at(-0.5 * inside, wheel), at(0.5 * inside, wheel), 1.5 + 6.0 * (top - wheel))
            .dimension("h", at(0.36, 0.0), at(0.36, height), -3.5 * inside)
            .dimension("R", at(0.0, height), at(1.2, height), 0.0)
            .axis(at(1.2, 0.0), at(1.2, 1.4 * height))
            .mass_centre("G", at(0.0, height));
        if self.bank > 0.0 {
            let foot = at(1.2, 0.0);
            let away = if inside > 0.0 { PI } else { 0.0 };
            sketch.axis(foot, (foot.0 - inside, foot.1)).angle("β", foot, away, away - inside * self.bank);
        }
    }

    /// The vehicle from its left side, driving to the left.
    fn seen_from_the_left(&self, sketch: &mut Sketch) {
        let wheel = (self.wheel_radius / self.track).clamp(0.12, 0.4);
        let height = (self.centre_height / self.track).clamp(0.45, 1.5);
        let (front, rear, centre) = match self.layout {
            AxleLayout::TwoAxles { wheelbase, behind_front, .. } => {
                let length = (wheelbase / self.track).clamp(0.8, 1.5);
                (0.0, length, length * behind_front / wheelbase)
            }
            AxleLayout::TwoEqualAxles => (0.0, 1.2, 0.6),
            AxleLayout::OneAxle => (0.0, 0.0, 0.0),
        };
        let left = if self.towards == TurnDirection::Left { 1.7 } else { 2.1 };
        let (front, rear, centre) = (left + front, left + rear, left + centre);
        let top = (1.7 * height).max(2.2 * wheel);
        sketch
            .ground((front - 0.5, 0.0), (rear + 0.4, 0.0))
            .mass("", (front - 0.35, 1.2 * wheel), (rear + 0.35, top))
            .mass_centre("G", (centre, height));
        let axles = if front < rear { vec![front, rear] } else { vec![front] };
        for axle in &axles {
            sketch.disc("", (*axle, wheel), wheel);
        }
        let letters = match self.wheels {
            WheelInertia::EachWheel { .. } | WheelInertia::EachPair { .. } => "I_w",
            WheelInertia::EachWheelGyration { .. } | WheelInertia::EachPairGyration { .. } => "m_w, k",
        };
        sketch
            .label(letters, (rear, wheel))
            .vector("r", (front, wheel), (front - 0.7 * wheel, 1.7 * wheel), Ink::Faint)
            .motion("v", (front - 0.35, height), (front - 0.7, height));
        if let AxleLayout::TwoAxles { .. } = self.layout {
            sketch.dimension("L", (front, 0.0), (rear, 0.0), -5.0).dimension(
                "c",
                (front, 0.0),
                (centre, 0.0),
                -2.0,
            );
        }
        if self.engine.is_some() {
            sketch.round("I_e", (f64::midpoint(front, centre), 1.1 * height), 0.12, Ink::Body);
        }
    }
}
