//! Nodal lines and surfaces of the shapes.

use std::f64::consts::TAU;

use dalembert_core::{Exhibit, Ink, Sketch, Text};
use dalembert_mechanics::vibration::plate::{LevyMode, RoundMode};

use super::{MembraneOutline, PlateAndMembrane, PlateOutline, SurfaceMass, ThinBody};

/// The edge, its larger side one, or a circle of radius one.
#[derive(Clone, Copy)]
pub(super) enum Outline {
    Rectangle(f64, f64),
    Circle,
}

/// A shape with its frequency, rad/s.
pub(super) enum Figure {
    /// Sines in both directions.
    Sines { pattern: [usize; 2], frequency: f64 },
    /// A sine along `a`.
    Levy { mode: LevyMode, frequency: f64 },
    /// In a circle.
    Round { mode: RoundMode, circles: Vec<f64>, frequency: f64 },
}

impl Figure {
    pub(super) fn sines(pattern: [usize; 2], frequency: f64) -> Self {
        Figure::Sines { pattern, frequency }
    }

    pub(super) fn levy(mode: LevyMode, frequency: f64) -> Self {
        Figure::Levy { mode, frequency }
    }

    pub(super) fn round(mode: RoundMode, frequency: f64) -> Self {
        Figure::Round { mode, circles: mode.circles(), frequency }
    }

    pub(super) fn frequency(&self) -> f64 {
        match self {
            Figure::Sines { frequency, .. }
            | Figure::Levy { frequency, .. }
            | Figure::Round { frequency, .. } => *frequency,
        }
    }

    /// Half waves along `a` and number across; nodal diameters and circles.
    pub(super) fn pattern(&self) -> [usize; 2] {
        match self {
            Figure::Sines { pattern, .. } => *pattern,
            Figure::Levy { mode, .. } => [mode.half_waves, mode.place],
            Figure::Round { mode, circles, .. } => [mode.diameters, circles.len()],
        }
    }

    /// Deflection across the width, 0 to 1.
    fn across(&self, eta: f64) -> f64 {
        match self {
            Figure::Sines { pattern, .. } => (pattern[1] as f64 * std::f64::consts::PI * eta).sin(),
            Figure::Levy { mode, .. } => mode.shape.deflection(eta),
            Figure::Round { mode, .. } => mode.deflection(eta),
        }
    }

    /// Interior zeros of the deflection across.
    fn zeros_across(&self) -> Vec<f64> {
        match self {
            Figure::Sines { pattern, .. } => (1..pattern[1]).map(|n| n as f64 / pattern[1] as f64).collect(),
            Figure::Levy { mode, .. } => mode.shape.nodes(),
            Figure::Round { circles, .. } => circles.clone(),
        }
    }
}

/// The nodal lines of the first six shapes.
pub(super) fn nodal_lines(figures: &[Figure], outline: Outline) -> Exhibit {
    let mut sketch = Sketch::new("Nodal lines");
    for (n, figure) in figures.iter().take(6).enumerate() {
        let corner = (2.6 * (n % 3) as f64, -2.9 * (n / 3) as f64);
        let at = |x: f64, y: f64| (corner.0 + x, corner.1 + y);
        let [lengthwise, _] = figure.pattern();
        match outline {
            Outline::Rectangle(a, b) => {
                let (a, b) = (2.0 * a, 2.0 * b);
                sketch.bars([at(0.0, 0.0), at(a, 0.0), at(a, b), at(0.0, b), at(0.0, 0.0)]);
                for line in 1..lengthwise {
                    let x = a * line as f64 / lengthwise as f64;
                    sketch.curve([at(x, 0.0), at(x, b)], Ink::Result);
                }
                for eta in figure.zeros_across() {
                    sketch.curve([at(0.0, b * eta), at(a, b * eta)], Ink::Result);
                }
            }
            Outline::Circle => {
                sketch.circle(at(1.0, 1.0), 1.0, Ink::Body);
                for radius in figure.zeros_across() {
                    sketch.circle(at(1.0, 1.0), radius, Ink::Result);
                }
                for line in 0..lengthwise {
                    // cos nθ = 0.
                    let angle = std::f64::consts::PI * (line as f64 + 0.5) / lengthwise as f64;
                    let (x, y) = (angle.cos(), angle.sin());
                    sketch.curve([at(1.0 - x, 1.0 - y), at(1.0 + x, 1.0 + y)], Ink::Result);
                }
            }
        }
        sketch.caption(Text::new("mode {n}").with("n", n + 1), at(1.0, -0.35));
    }
    Exhibit::Drawing(sketch.finish())
}

/// A shape in motion, seen from the side and above.
pub(super) fn animation(figure: &Figure, outline: Outline) -> Exhibit {
    const FRAMES: u16 = 24;
    let lines = surface(figure, outline);
    let frame = |n: u16| {
        let phase = 0.6 * (TAU * f64::from(n) / f64::from(FRAMES)).cos();
        let seen = |(x, y, w): &(f64, f64, f64)| (x + 0.4 * y, 0.5 * y + phase * w);
        let mut sketch = Sketch::default();
        for line in &lines {
            sketch.curve(line.iter().map(seen).collect::<Vec<_>>(), Ink::Motion);
        }
        sketch
    };
    let [first, second] = figure.pattern();
    let title = Text::new("Mode ({m}, {n}) in motion").with("m", first).with("n", second);
    Exhibit::Animation(Sketch::animation(title, (0..FRAMES).map(frame), 2.0))
}

/// Lines on the surface of a shape: places and deflections.
fn surface(figure: &Figure, outline: Outline) -> Vec<Vec<(f64, f64, f64)>> {
    const LINES: usize = 8;
    const POINTS: usize = 32;
    let part = |n: usize, of: usize| n as f64 / of as f64;
    let [lengthwise, _] = figure.pattern();
    let across: Vec<f64> = (0..=POINTS).map(|n| figure.across(part(n, POINTS))).collect();
    let step = POINTS / LINES;
    match outline {
        Outline::Rectangle(a, b) => {
            let (a, b) = (3.0 * a, 3.0 * b);
            let along = |n: usize| (lengthwise as f64 * std::f64::consts::PI * part(n, POINTS)).sin();
            let point = |i: usize, j: usize| (a * part(i, POINTS), b * part(j, POINTS), along(i) * across[j]);
            let one_way = (0..=LINES).map(|l| (0..=POINTS).map(|i| point(i, l * step)).collect());
            let other_way = (0..=LINES).map(|l| (0..=POINTS).map(|j| point(l * step, j)).collect());
            one_way.chain(other_way).collect()
        }
        Outline::Circle => {
            let point = |radius: usize, turn: f64| {
                let r = 1.6 * part(radius, POINTS);
                (r * turn.cos(), r * turn.sin(), across[radius] * (lengthwise as f64 * turn).cos())
            };
            let around =
                |l: usize| (0..=2 * POINTS).map(|n| point(l * step, TAU * part(n, 2 * POINTS))).collect();
            let spoke = |l: usize| (0..=POINTS).map(|n| point(n, TAU * part(l, 12))).collect();
            (1..=LINES).map(around).chain((0..12).map(spoke)).collect()
        }
    }
}

/// The body from above with its lengths, and the tension or the thickness.
pub(super) fn outline(problem: &PlateAndMembrane) -> Exhibit {
    let mut sketch = Sketch::new("The body from above");
    let rectangle = |sketch: &mut Sketch, length: f64, breadth: f64| {
        let (a, b) = (2.0, (2.0 * breadth / length).clamp(0.4, 4.0));
        sketch.mass("", (-a, -b), (a, b)).dimension("a", (-a, -b), (a, -b), -2.0).dimension(
            "b",
            (a, -b),
            (a, b),
            -2.0,
        );
        (a, b)
    };
    let circle = |sketch: &mut Sketch| {
        sketch.disc("", (0.0, 0.0), 2.0).dimension("R", (0.0, 0.0), (1.732, -1.0), 0.0);
        (2.0, 2.0)
    };
    match &problem.body {
        ThinBody::Membrane { outline, mass, .. } => {
            let (a, b) = match *outline {
                MembraneOutline::Rectangle { length, breadth } => rectangle(&mut sketch, length, breadth),
                MembraneOutline::Circle { .. } => circle(&mut sketch),
            };
            for (x, y, name) in [(a, 0.0, "T"), (-a, 0.0, "T"), (0.0, b, "T"), (0.0, -b, "T")] {
                let out = 0.8;
                sketch.force(
                    name,
                    (x, y),
                    (x + x.signum() * out * f64::from(x != 0.0), y + out * y.signum() * f64::from(y != 0.0)),
                );
            }
            if let SurfaceMass::Density { .. } = mass {
                strip(&mut sketch, a);
            }
        }
        ThinBody::Plate { outline, .. } => {
            let (a, _) = match *outline {
                PlateOutline::Rectangle { length, breadth, .. } => rectangle(&mut sketch, length, breadth),
                PlateOutline::Circle { .. } => circle(&mut sketch),
            };
            strip(&mut sketch, a);
        }
    }
    Exhibit::Drawing(sketch.finish())
}

/// The thickness, on the edge beside the body.
fn strip(sketch: &mut Sketch, half: f64) {
    let left = half + 1.6;
    sketch.mass("", (left, -0.12), (left + 1.6, 0.12)).dimension(
        "h",
        (left + 1.6, -0.12),
        (left + 1.6, 0.12),
        -1.5,
    );
}
